//! What the examples in other languages print: a wheel brakes for ten seconds.

use schlupf::Quantity;
use schlupf::element::Signal;
use schlupf_case::{CaseFile, Folder, Overrides};

const CASE: &str = "kinematics.speed = \"20 m/s\"\nsolver.method = \"polach\"\n\
                    friction = { model = \"constant\", coefficient = 0.4 }";

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let [radius, inertia, mass, torque, step] = [0.46, 70.0, 8000.0, 4000.0, 1e-3];
    let assignments = &["normal.load=80 kN".to_owned()];
    let set = Overrides { option: "override", assignments };
    let file = CaseFile::from_str(CASE, "the case", Folder::new(""), set)?;
    let mut wheel = file.pose(&schlupf::unwatched)?.element()?;
    let place = |all: &[Signal], wanted| all.iter().position(|signal| *signal == wanted);
    let (Some(v), Some(omega), Some(force)) = (
        place(wheel.inputs(), Quantity::VelocityX),
        place(wheel.inputs(), Quantity::AngularVelocity),
        place(wheel.outputs(), Quantity::ForceX),
    ) else {
        return Err("an input or output is missing".into());
    };
    let mut inputs = wheel.start();
    let mut states = vec![0.0; wheel.states().len()];
    let mut found = wheel.evaluation();
    for k in 0..=10_000 {
        wheel.evaluate(&inputs, &states, &mut found);
        let (fx, by_omega) = (found.outputs[force], found.derivative(force, omega));
        if k % 2000 == 0 {
            println!("{:.16e} {:.16e} {fx:.16e}", inputs[v], inputs[omega]);
        }
        inputs[v] += step * fx / mass;
        inputs[omega] += step * (-radius * fx - torque) / (inertia + step * radius * by_omega);
        wheel.advance(&inputs, &mut states, step);
    }
    Ok(())
}
