#[path = "../tests/common.rs"]
mod common;
fn main() {
    let mut r = common::RECIPE;
    let args: Vec<String> = std::env::args().collect();
    let dir = &args[1];
    if let Some(d) = args.get(2) { r.direction = d.parse().unwrap(); }
    if let Some(d) = args.get(3) { r.cells = d.parse().unwrap(); }
    if let Some(d) = args.get(4) { r.semi_axes[1] = r.semi_axes[0] / d.parse::<f64>().unwrap(); }
    let s = common::solution(r);
    let t = std::time::Instant::now();
    let f = schlupf_output::figures::all("steel wheel, 80 kN, braking", &s).unwrap();
    eprintln!("{:?}", t.elapsed());
    std::fs::create_dir_all(dir).unwrap();
    for f in f {
        eprintln!("{} {} {}", f.name, f.svg.len(), f.png.len());
        std::fs::write(format!("{dir}/{}.svg", f.name), f.svg).unwrap();
        std::fs::write(format!("{dir}/{}.png", f.name), f.png).unwrap();
    }
}
