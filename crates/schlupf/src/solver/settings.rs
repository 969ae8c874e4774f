//! The numbers that steer the numerics of rolling contact: what each one is, and why it has its
//! value. None is part of a model: those of discretisation change results by what is said there, on
//! 20 cells; all others change the work, and which of several states is found, and apart from that
//! results by about the tolerance. Factors of a formula stand with the formula, and limits of
//! input with its checks.
//!
//! In brackets: products with the compliance at half and at twice the value, over those at the
//! value itself, for the reference problems of the test `half_and_twice`, if they change by more
//! than 2 %, and the largest change of a force, if it is more than 10⁻³ of the load.

/// Defines settings as functions of their names. In unit tests one of them can be scaled.
macro_rules! settings {
    ($($(#[$doc:meta])* $name:ident: $number:ty = $value:expr;)*) => {
        $(
            $(#[$doc])*
            #[inline]
            pub(crate) fn $name() -> $number {
                #[cfg(test)]
                return tests::scaled(stringify!($name), $value);
                #[cfg(not(test))]
                $value
            }
        )*

        #[cfg(test)]
        const NAMES: &[&str] = &[$(stringify!($name)),*];
    };
}

settings! {
    // Unlike bodies.

    /// Pressures after which the search for that of unlike bodies is given up: each reduces the
    /// error by about the product of K and the coefficient of friction.
    most_pressures: usize = 30;

    // Layers between the surfaces that flow.

    /// Limits of elasticity after which the search for that at the end of a shift is given up. Each
    /// reduces the error by about the damped product of hardening and compliance.
    most_flows: usize = 100;

    // Newton's method, the Krylov method and the measure of residuals.

    /// Largest forcing term: linear residual that the Krylov method may leave, relative to that of
    /// the Newton step (Eisenstat and Walker 1996). [1.05, 0.96]
    largest_forcing: f64 = 0.3;

    /// Part of the tolerance that the linear residual of the last step may use up. [1.03, 0.99]
    part_of_tolerance: f64 = 0.8;

    /// Decrease of the residual norm required of a step of length λ, relative to λ (Armijo 1966).
    sufficient_decrease: f64 = 1e-4;

    /// Residual over its scale above which an initial guess is compared with the sliding of rigid
    /// bodies.
    poor_guess: f64 = 0.8;

    /// Newton steps among whose residual norms the largest is to be reduced (Grippo, Lampariello
    /// and Lucidi 1986).
    residuals_remembered: usize = 5;

    /// Halvings of a Newton step before it is given up; after a third of them the norm need only
    /// fall below the largest remembered. [0.93, 1.08]
    most_halvings: usize = 10;

    /// Newton steps without a residual less than nine tenths of the least one, after which Newton's
    /// method is given up.
    patience: usize = 40;

    /// Directions of earlier linear systems that a system starts with: their responses are known,
    /// but each costs two passes over all unknowns. [1.12, 0.86]
    directions_kept: usize = 48;

    /// New directions of one linear system.
    most_directions: usize = 120;

    /// Part of a response that must be orthogonal to all before for the direction to count. Where
    /// it is taken from the Gram matrix, which has half as many digits, its root.
    least_new_part: f64 = 1e-6;

    /// The same part below which the recycled space stagnates.
    stagnating_part: f64 = 0.1;

    /// The same part below which a response is made orthogonal once more because of cancellation
    /// (Daniel et al. 1976).
    cancelled_part: f64 = 0.5;

    /// ‖p‖/‖μ pₙ‖ below which residuals are measured by less than ‖μ pₙ‖, as said of
    /// [`crate::Options::tolerance`].
    small_traction: f64 = 0.01;

    // Nested grids, branches and derivatives of steady states.

    /// Largest residual of a coarse grid from which a finer one starts, and of a motion along a
    /// branch from which the next one starts: with 10⁻⁴ no more states are found, nor are fewer
    /// branches lost, for half as much work again; where there are many states, others of them are.
    /// If the residual of its own guess is less than 1.5 times this, a coarse solution is not
    /// prolonged to the finer grid: it would change little more than what it leaves undone.
    coarse_tolerance: f64 = 1e-2;

    /// Fewest cells across the patch of a grid that is coarsened further. On five cells the long
    /// waves of a half-space are so wrong that they spoil the preconditioner. [1.05, 0.99]
    fewest_cells_coarsened: usize = 16;

    /// Extrapolation of two earlier solutions at most, over their distance.
    farthest_extrapolation: f64 = 2.5;

    /// Slip that follows elastically from a fall of friction, over the slip that caused the fall,
    /// above which there may be several states. Of random contacts whose friction falls at once or
    /// with memory 378 between 1 and 2 were followed from low and from high slip, and none had
    /// two states; the least with two had 4.8.
    /// [1.00, 0.77]
    several_states: f64 = 2.0;

    /// Largest slip speed at which the fall of friction is sampled, over the largest of the state.
    fastest_sample: f64 = 10.0;

    /// Speeds at which it is sampled in a cell; neighbouring cells complement each other.
    samples_of_cell: usize = 4;

    /// Steps of the motion along a branch. With fewer, more branches are lost. [0.92, 1.08]
    steps_of_branch: usize = 16;

    /// Multiple of the motion from which a branch of high slip starts.
    highest_slip: f64 = 6.0;

    /// Difference of forces over μ0 N above which two states are distinct, in tolerances.
    distinct_states: f64 = 30.0;

    /// Largest creepage that is tried, of a wheel that locks.
    locking: f64 = 0.95;

    /// Largest creepage that is tried, of a wheel that spins: the cost of conduction under a body
    /// grows with the root of its speed.
    spinning: f64 = 1e3;

    /// Least part of the initial creep stiffness that the preconditioner of prescribed forces
    /// ascribes to a contact that slides.
    least_creep_stiffness: f64 = 1e-3;

    /// Residual of the linear systems of derivatives, over the tolerance of the solution.
    accuracy_of_derivatives: f64 = 0.1;

    /// The same residual at most, whatever the tolerance; that of the slopes of a search.
    least_accurate_derivatives: f64 = 1e-5;

    /// Multiple of that residual above which a derivative counts as not found.
    inaccurate_derivatives: f64 = 100.0;

    // The path of forces that grow to the prescribed ones, in dimensionless creepages. Half and
    // twice of all but the cells change neither work nor forces of the reference problems: they
    // bound the work where the path is hard to follow, or there is no such force.

    /// Force over μ0 N up to which Kalker's theory with a saturation gives the first guess.
    largest_guess: f64 = 0.97;

    /// Step of central differences where a method has no derivatives.
    difference: f64 = 1e-5;

    /// Difference of two motions above which they are distinct, over their size.
    distinct_motions: f64 = 1e-3;

    /// Cells across the patch of the grid on which the path is followed first. [0.94, 1.33]
    cells_of_coarse_search: usize = 10;

    /// Tolerance of the solutions on that grid.
    tolerance_of_coarse_search: f64 = 1e-4;

    /// Force at rest over that prescribed below which there is none.
    no_force: f64 = 1e-9;

    /// Length of the first step. The step is halved where it fails, and doubled after few
    /// corrections.
    first_step: f64 = 0.3;

    /// Length of the least step.
    least_step: f64 = 1e-4;

    /// Steps of the path.
    steps_of_path: usize = 60;

    /// Corrections of a point by Newton's method.
    most_corrections: usize = 8;

    /// Corrections of a point up to which the next step is twice as long.
    few_corrections: usize = 3;

    /// Distance of a point from the path, over the change of the forces along it.
    off_path: f64 = 1e-3;

    /// Distance from the creepages of a locked wheel at which the path ends, over them.
    next_to_locked: f64 = 0.1;

    /// Growth of the forces below which the contact slides, over that of the creepages.
    stagnant_force: f64 = 1e-7;

    /// Successive steps with less growth after which the path ends.
    stagnant_steps: usize = 3;

    /// Share of the way to the prescribed forces over the largest one reached below which the
    /// latter is the peak.
    fallen_force: f64 = 0.5;

    /// Error of prescribed forces, over the tolerance of the solution.
    accuracy_of_forces: f64 = 3.0;

    // Discretisation.

    /// Pressure relative to that of the neighbour towards the middle of the strip below which an
    /// edge cell is slaved to it. The pressure that displaces a cell as much as bristles deflect is
    /// added to both. [1.02, 0.90; forces 3·10⁻³ of the load]
    least_edge_pressure: f64 = 0.35;

    /// Displacement that is missing under p = pₙ, over that of a partly covered cell under its own
    /// traction and of its bristles, beyond which it is slaved, too: its equation would be far too
    /// stiff.
    most_missing: f64 = 0.12;

    /// Sliding of the first cell since entry under its own traction, over its displacement, below
    /// which it is slaved, too: its neighbours would determine its traction. Under an elliptic
    /// pressure it is hardly ever less than a third. [forces 10⁻³ and 4·10⁻³ of the
    /// load]
    least_sliding: f64 = 0.25;

    /// A node of a stencil nearer to the one before than this part of the path into the cell is
    /// left out: its weight would be large. [forces 3·10⁻² and 2·10⁻³ of the load: of a patch with
    /// kinks; with large weights there is a wrong state]
    nearest_node: f64 = 0.4;

    /// Refinement of the grid that stands for the exact displacement: what is missing of the
    /// displacement is found to 8 %, with 2 to 18 % and with 4 to 4 %. On more than 58 000 cells
    /// it is 2, on more than 131 000 it is 1.
    refinement: usize = 3;

    /// Part of a cell's own compliance by which a calibration reduces it in the preconditioner.
    /// [0.99, 1.05]
    most_reduced: f64 = 0.3;

    /// Ratio of the trial traction of a cell of rigid bodies to its bound, and of their stiffness
    /// to that of the bristles: the traction moves nothing.
    rigidity: f64 = 1e10;

    /// Ratio of width to length of a cell times that of the numbers of cells of the contact along
    /// and across rolling, up to which a grid is accepted. Beyond it the edge runs through so many
    /// cells of a strip that products grow, and from twice as much on there are wrong solutions.
    widest_cells: f64 = 50.0;

    /// Longest path into a cell, over its length: anything longer is noise of edges that move with
    /// the material.
    longest_path: f64 = 2.0;

    // Marching.

    /// Successive time steps without an equilibrium after which a march to a steady state ends.
    steps_lost: usize = 10;
}

#[cfg(test)]
mod tests {
    use std::sync::{Arc, PoisonError, RwLock};

    use super::NAMES;
    use crate::bodies::{Kinematics, Material};
    use crate::elasticity::{CalibratedLayer, HalfSpace};
    use crate::interface::friction::{Friction, Polach, TemperatureLinear};
    use crate::interface::{ContactLaw, Incremental};
    use crate::normal::{PressureSource, PressureTable, Tabulated};
    use crate::problem::{History, PrescribedForces, Transient};
    use crate::solution::Solution;
    use crate::solver::rolling::marching::march;
    use crate::{Method, Options, Problem, Status, unwatched};

    /// The setting that is scaled, and the factor. Seen by all tests of this process: the test that
    /// scales is ignored, and the only ignored one of the library.
    static CHANGED: RwLock<Option<(&str, f64)>> = RwLock::new(None);

    pub(super) trait Number: Copy {
        fn times(self, factor: f64) -> Self;
    }

    impl Number for f64 {
        fn times(self, factor: f64) -> Self {
            self * factor
        }
    }

    impl Number for usize {
        fn times(self, factor: f64) -> Self {
            (self as f64 * factor).round() as Self
        }
    }

    /// Computes with a scaled setting; it is what it was afterwards, also after a panic.
    fn with<R>(name: &'static str, factor: f64, compute: impl FnOnce() -> R) -> R {
        struct Reset;
        impl Drop for Reset {
            fn drop(&mut self) {
                *CHANGED.write().unwrap_or_else(PoisonError::into_inner) = None;
            }
        }
        let _reset = Reset;
        *CHANGED.write().unwrap() = Some((name, factor));
        compute()
    }

    pub(super) fn scaled<T: Number>(name: &str, value: T) -> T {
        let changed = *CHANGED.read().unwrap();
        changed.filter(|(of, _)| *of == name).map_or(value, |(_, factor)| value.times(factor))
    }

    /// Creepages and spin from stick to slip, of a patch of some millimetres; spin in 1/m.
    const MOTIONS: [[f64; 3]; 8] = [
        [1e-6, 0.0, 0.0],
        [3e-4, 0.0, 0.0],
        [6e-4, 0.0, 0.0],
        [1e-3, 5e-4, 0.0],
        [0.0, 1e-3, 0.3],
        [5e-4, -1e-3, 0.5],
        [4e-3, 0.0, 0.1],
        [2e-2, 1e-2, 0.0],
    ];

    /// The same contacts in all motions, one contact after the other; at last some whose friction
    /// falls so steeply that there may be several states, and some with a prescribed force, which
    /// is followed along its path where friction falls.
    fn problems() -> Vec<Problem> {
        let steel = Material::STEEL;
        let half_space = HalfSpace::new(&steel, &steel).unwrap();
        let layer = CalibratedLayer::new(&steel, &steel, None).unwrap();
        let bristles = |stiffness| ContactLaw::from(Incremental::new(stiffness).unwrap());
        let falling =
            |limit, decay| Friction::new(Arc::new(Polach::new(0.4, limit, decay).unwrap()), 20.0);
        let hot = Friction::new(Arc::new(TemperatureLinear::new(0.4, 900.0, 0.1).unwrap()), 20.0);
        let on_half_space =
            |law| Problem::builder().elasticity(half_space).contact_law(law).build().unwrap();
        let on_layer = |law| Problem::builder().elasticity(layer).contact_law(law).build().unwrap();
        let coulomb = on_half_space(ContactLaw::Coulomb);
        let lateral = |force| PrescribedForces { y: Some(force), ..PrescribedForces::default() };
        let contacts = [
            coulomb.clone(),
            coulomb.clone().with_interface(|interface| interface.friction = falling(0.5, 1.0)),
            on_half_space(bristles(3e7)),
            on_layer(bristles(5e6)),
            on_layer(ContactLaw::Coulomb).with_interface(|interface| interface.friction = hot),
            coulomb.clone().with_interface(|interface| interface.friction = falling(0.3, 30.0)),
            Problem { prescribed: lateral(2e4), ..coulomb.clone() },
            Problem { prescribed: lateral(1e4), ..coulomb }
                .with_interface(|interface| interface.friction = falling(0.5, 1.0)),
        ];
        let moving = |contact: &Problem| {
            let contact = contact.clone();
            MOTIONS.map(|[creepage_x, creepage_y, spin]| {
                let kinematics = Kinematics { creepage_x, creepage_y, spin, ..contact.kinematics };
                Problem { kinematics, ..contact.clone() }
            })
        };
        contacts.iter().flat_map(moving).collect()
    }

    /// Two circles under 1 GPa from a coarse table, on cells that are wider than long, with
    /// Coulomb's law: kinks from cell to cell.
    fn angular() -> Vec<Problem> {
        let axis = |farthest: i32| (-farthest..=farthest).map(|k| 2.5e-4 * f64::from(k));
        let (x, y): (Vec<f64>, Vec<f64>) = (axis(5).collect(), axis(20).collect());
        let under = |x: f64, y: f64| (1.0 - (x * x + y * y) * 1e6).max(0.0).sqrt();
        let both = |x: f64, y: f64| 1e9 * (under(x, y - 3e-3) + under(x, y + 3e-3));
        let pressure = y.iter().flat_map(|y| x.iter().map(move |x| both(*x, *y))).collect();
        let table = PressureTable::new(&x, &y, pressure).unwrap();
        let normal: Arc<dyn PressureSource> = Arc::new(Tabulated::new(table, Some(4e3)).unwrap());
        let problems = &problems()[..MOTIONS.len()];
        problems.iter().map(|of| Problem { normal: Arc::clone(&normal), ..of.clone() }).collect()
    }

    /// A load that falls by half and rises again, while a lateral force and the spin are given.
    fn transient(problem: &Problem) -> Transient {
        let prescribed = PrescribedForces { y: Some(1e4), ..PrescribedForces::default() };
        let load = problem.normal.normal_contact(None).unwrap().summary.load;
        let history = History {
            time: vec![0.0, 3e-4, 6e-4],
            load: Some(vec![load, 0.5 * load, load]),
            ..History::default()
        };
        let problem = Problem { prescribed, ..problem.clone() };
        Transient { history, ..Transient::to_steady_state(&problem) }
    }

    /// Steady states, each from the one before, with derivatives and forces extrapolated; and
    /// marches on fewer cells.
    fn solutions() -> Vec<Solution> {
        let on = |cells| Options { cells_x: cells, cells_y: cells, ..Options::default() };
        let options = Options { sensitivity: true, extrapolate: true, ..on(20) };
        let mut solver = Method::Full.solver(&options);
        let steady = |problem: &Problem| solver.solve(problem, &unwatched).unwrap();
        let mut found: Vec<Solution> = problems().iter().chain(&angular()).map(steady).collect();
        let problems = problems();
        let marches = problems[10..14].iter().map(Transient::to_steady_state);
        for transient in marches.chain([10, 26].map(|k| transient(&problems[k]))) {
            let options = Options { tolerance: 1e-5, ..on(10) };
            found.push(march(&transient, &options, &unwatched).unwrap());
        }
        found
    }

    fn products(solutions: &[Solution]) -> f64 {
        let of = |found: &Solution| {
            found.work.operator_products + found.work.sensitivity_products as f64
        };
        solutions.iter().map(of).sum()
    }

    /// What misses the limits: stencils with large weights lead to a wrong state of a patch with
    /// kinks, and without the first cells that slide by up to half of what displaces them a hot
    /// layer under Coulomb's law changes by four parts in a thousand of the load.
    const EXCEPTIONS: [(&str, f64); 2] = [("nearest_node", 0.5), ("least_sliding", 2.0)];

    /// The settings that change the discretisation, and with it forces.
    const OF_DISCRETISATION: [&str; 6] = [
        "least_edge_pressure",
        "most_missing",
        "least_sliding",
        "nearest_node",
        "refinement",
        "longest_path",
    ];

    /// Prints how work and forces change at half and at twice each setting. All problems are
    /// solved; work changes by less than a half, and forces by less than what 20 cells are off by,
    /// or by some tolerances.
    #[test]
    #[ignore = "long: cargo xtask long"]
    fn half_and_twice() {
        let reference = solutions();
        let whole = products(&reference);
        println!("{whole:.0} products");
        let mut missed = Vec::new();
        for name in NAMES {
            for factor in [0.5, 2.0] {
                let found = with(name, factor, solutions);
                let apart = found.iter().zip(&reference).map(|(one, other)| {
                    let [x, y] = [one.force.x - other.force.x, one.force.y - other.force.y];
                    x.hypot(y) / one.normal.load
                });
                let apart = apart.fold(0.0, f64::max);
                let work = products(&found) / whole;
                println!("{name} × {factor}: products × {work:.2}, forces {apart:.0e} of the load");
                let is_solved = found.iter().all(|one| one.status == Status::Converged);
                let is_exception = EXCEPTIONS.contains(&(*name, factor));
                let most = if OF_DISCRETISATION.contains(name) { 3e-3 } else { 1e-5 };
                if !is_exception && (!is_solved || apart > most || work > 1.5) {
                    missed.push((name, factor, apart, work));
                }
            }
        }
        assert!(missed.is_empty(), "{missed:?}");
    }
}
