#[path = "../tests/common/mod.rs"]
mod common;
use common::{cells, layer, problem, rolling};
use schlupf::heat::Heat;
use schlupf::heat::duhamel::Duhamel;
use schlupf::heat::partition::Partition;
use schlupf::interface::contact_law::*;
use schlupf::interface::friction::temperature_linear::TemperatureLinear;
use schlupf::*;
use std::sync::Arc;
fn main() {
    let _ = layer();
    let mut f = problem(rolling(0.3, 0.0, 0.0));
    f.elasticity = Arc::new(schlupf::elasticity::rigid::Rigid);
    f.contact_law = Incremental::new(1e6).unwrap().into();
    f.friction.law = Arc::new(TemperatureLinear::new(0.4, 700.0, 0.0).unwrap());
    f.heat = Heat { model: Some(Arc::new(Duhamel)), partition: Partition::Velocity };
    let s = rolling::steady::solve(&f, &cells(12), &unwatched).unwrap();
    println!("{:?} {:?}", s.work, s.normalised);
}
