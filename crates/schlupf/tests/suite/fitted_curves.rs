//! Curves of a fitted model between the data.

use approx::assert_relative_eq;
use schlupf::analysis::creep_curve::Abscissa;
use schlupf::analysis::identification::{
    Component, Condition, CreepForceModel, DataPoint, ForceRatio, Parameter, sample_curves,
};
use schlupf::bodies::Kinematics;
use schlupf::solution::Work;
use schlupf::{Error, Watch, unwatched};

/// A force along the creepage that saturates, the sooner the faster; it counts its solutions.
struct Saturating {
    solved: usize,
}

fn force(motion: &Kinematics) -> [f64; 2] {
    let total = motion.creepage_x.hypot(motion.creepage_y);
    let over_creepage = 0.3 * (4.0 * motion.speed * total).tanh() / total.max(1e-12);
    [over_creepage * motion.creepage_x, over_creepage * motion.creepage_y]
}

impl CreepForceModel for Saturating {
    fn parameters(&self) -> &[Parameter] {
        &[]
    }

    fn start(&self) -> Vec<f64> {
        Vec::new()
    }

    fn set(&mut self, _values: &[f64]) -> Result<(), Error> {
        Ok(())
    }

    fn force_ratio(
        &mut self,
        condition: &Condition,
        _watch: Watch,
    ) -> Result<Option<ForceRatio>, Error> {
        self.solved += 1;
        let value = force(&condition.kinematics);
        Ok(Some(ForceRatio { value, by_parameter: Vec::new() }))
    }

    fn work(&self) -> Work {
        Work::default()
    }
}

const TOTALS: [f64; 4] = [-0.004, 0.002, 0.01, 0.05];

/// Both components of forces under creepages in one direction, written with five decimal places.
fn in_one_direction(speeds: &[f64]) -> Vec<DataPoint> {
    let digits = |creepage: f64| (1e5 * creepage).round() / 1e5;
    let mut data = Vec::new();
    for speed in speeds {
        for total in TOTALS {
            let [creepage_x, creepage_y] = [0.8 * total, 0.601 * total].map(digits);
            let kinematics =
                Kinematics { creepage_x, creepage_y, ..Kinematics::free_rolling(*speed) };
            let condition = Condition { kinematics, load: None };
            for component in [Component::Longitudinal, Component::Lateral] {
                let force_ratio = force(&kinematics)[component.index()];
                data.push(DataPoint {
                    condition,
                    component,
                    force_ratio,
                    standard_deviation: None,
                });
            }
        }
    }
    data
}

/// ξ and η in one direction are one curve over the total creepage for each component and speed,
/// though each point has an η of its own.
#[test]
fn creepages_in_one_direction_are_a_curve_over_the_total_one() {
    let mut data = in_one_direction(&[10.0, 30.0]);
    let mut model = Saturating { solved: 0 };
    let curves = sample_curves(&mut model, &data, 5, &unwatched).unwrap();
    let Abscissa::Total { direction } = curves.abscissa else { panic!("{:?}", curves.abscissa) };
    assert_relative_eq!(direction, 0.601_f64.atan2(0.8), epsilon = 1e-3);
    assert_eq!(curves.series.len(), 4);
    for series in &curves.series {
        assert_eq!(series.members.len(), TOTALS.len());
        for point in series.members.iter().map(|k| &data[*k]) {
            let place = curves.place(point);
            let there = series.curve.iter().find(|there| there.creepage == place).unwrap();
            // The digits turn the direction by up to 3 mrad.
            assert_relative_eq!(there.force_ratio.unwrap(), point.force_ratio, epsilon = 1e-3);
        }
    }
    // Five points and the four of the data, of which the first and the last are the ends of the
    // five.
    let each: Vec<usize> = curves.series.iter().map(|series| series.curve.len()).collect();
    assert_eq!(each, [7; 4]);
    assert_eq!(model.solved, each.iter().sum::<usize>());
    // One point off the line is enough for it to be none.
    data[0].condition.kinematics.creepage_y = 0.01;
    assert_eq!(
        sample_curves(&mut model, &data, 0, &unwatched).unwrap().abscissa,
        Abscissa::CreepageX
    );
}

/// Twelve conditions have curves, whether one component was measured or both; thirteen have none.
#[test]
fn too_many_conditions_have_no_curves() {
    let speeds: Vec<f64> = (1..=13).map(f64::from).collect();
    let mut model = Saturating { solved: 0 };
    let twelve =
        sample_curves(&mut model, &in_one_direction(&speeds[..12]), 5, &unwatched).unwrap();
    assert_eq!(twelve.series.len(), 24);
    assert!(twelve.series.iter().all(|series| !series.curve.is_empty()));
    let before = model.solved;
    let thirteen = sample_curves(&mut model, &in_one_direction(&speeds), 5, &unwatched).unwrap();
    assert!(thirteen.series.iter().all(|series| series.curve.is_empty()));
    assert_eq!(model.solved, before);
}
