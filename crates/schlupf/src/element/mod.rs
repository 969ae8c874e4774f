//! The force element: a contact inside a simulation.
//!
//! An [`Element`] is a function of its inputs and states, as a simulator holds it. It takes the
//! motion of the wheel over the rail, the load or the approach, a factor of friction and the bulk
//! temperatures; it gives forces and what belongs to them, the rates of its states, and all
//! derivatives. Nothing in the loop is an error: a wheel that lifts off has no forces, and numbers
//! that are not finite end in a [`Status`].
//!
//! # Through standstill
//!
//! Creepages are slip over rolling speed, which says nothing at standstill. The element takes the
//! rigid slip w (velocities and a spin rate) and the rolling speed V instead.
//!
//! *Without memory* it puts √(V² + v_s²) in the place of the speed; below the standstill speed
//! v_s the forces are those of a damper, and a wheel on a gradient creeps.
//!
//! *With memory* the states are the elastic shift u of the wheel over the rail, and q = u/σ are
//! creepages that relax over the lengths σ:
//!
//! du/dt = w − r q,  r = V' + α (√(V'² + n(w)²/3) − V'),  F = F_steady(q/√(1 − n(q)²/3)),
//!
//! where V' = V²/√(V² + v_s²) and n = G ab √((C11 ξ)² + (C22 η)² + (C23 √(ab) φ)²)/(μN), which is 3
//! where all of the patch slides (Vermeulen and Johnson 1964). In steady rolling α = 1 and the
//! forces are exactly those of the method. At standstill the wheel sticks with the tangential
//! stiffness of the patch (Mindlin 1949), of which σ is Kalker's creep coefficient, nearly along
//! the curve of Cattaneo (1938). α vanishes well below sliding and while the shift decreases, so
//! that vibration at rest moves nothing for good (Dupont, Hayward, Armstrong and Altpeter 2002),
//! as it would with the law of Dahl (1968). What friction cannot bear any more, or a shift without
//! a load, vanishes within some milliseconds. Relaxation lengths are those of tyres (Pacejka 2012,
//! §7).
//!
//! Rolling backwards is rolling forwards in the frame turned by π; between ∓v_s the forces pass
//! from one to the other.
//!
//! Limits: one lag for each creepage stands for the transient of the whole patch, and that of spin
//! is the lateral one's; friction of the methods without fields is that of one slip speed and of
//! the temperature at which the material enters; below a thousandth of the problem's load the
//! relaxation is that of this load.

mod settings;
mod patch;
mod rolling;
mod acting;
mod flash;
mod similar;
mod solved;
mod law;
mod memory;
mod signals;
mod evaluation;
mod contact;
mod any_ellipse;
mod wheel_motion;
mod wheel;
mod held;
mod rows;

pub use evaluation::{Evaluation, Status};
pub use held::Element;
pub use rows::{Given, Rows};
pub use settings::{Motion, Normal, Settings};
pub use signals::Signal;
pub use wheel::{CONTACTS, WheelParts};
