//! Calls Tamaas (Frérot et al. 2020, J. Open Source Softw. 5, 2121) where a Python has it.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use schlupf::surface::HeightMap;

/// Says that a test must not be skipped.
pub const REQUIRED: &str = "SCHLUPF_REQUIRE_TAMAAS";

/// What Tamaas finds for one mean pressure.
pub struct TamaasSolution {
    /// Over the contact modulus.
    pub pressure: Vec<f64>,
    /// In s, without start of Python.
    pub time: f64,
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/tamaas")
}

/// A Python that has Tamaas: that of `.ci/run`, or the first one on the path.
pub fn python() -> Option<PathBuf> {
    let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../target/tamaas/bin/python");
    let has_tamaas = |python: &PathBuf| {
        let output = Command::new(python).args(["-c", "import tamaas"]).output();
        output.is_ok_and(|output| output.status.success())
    };
    let found = [own, PathBuf::from("python3")].into_iter().find(has_tamaas);
    assert!(
        found.is_some() || env::var_os(REQUIRED).is_none(),
        "{REQUIRED} is set, but no Python has Tamaas: see .ci/run"
    );
    found
}

/// Solves periodic contact of a square surface with a plane. Mean pressures over the contact
/// modulus.
pub fn solve(
    python: &Path,
    surface: &HeightMap,
    tolerance: f64,
    pressures: &[f64],
) -> Vec<TamaasSolution> {
    let lattice = surface.lattice();
    assert_eq!(lattice.columns, lattice.rows);
    let name = format!("schlupf-tamaas-{}-{}", std::process::id(), lattice.columns);
    let file = |end: &str| env::temp_dir().join(format!("{name}-{end}"));
    let (heights, results) = (file("heights"), file("pressures"));
    let bytes = |height: &f64| (height / lattice.length_x()).to_le_bytes();
    fs::write(&heights, surface.heights().iter().flat_map(bytes).collect::<Vec<u8>>()).unwrap();
    let output = Command::new(python)
        .arg(folder().join("solve.py"))
        .args([lattice.columns.to_string(), tolerance.to_string()])
        .args([&heights, &results])
        .args(pressures.iter().map(ToString::to_string))
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let numbers = fs::read(&results).unwrap();
    let numbers: Vec<f64> =
        numbers.as_chunks().0.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect();
    for path in [heights, results] {
        fs::remove_file(path).unwrap();
    }
    let text = String::from_utf8(output.stdout).unwrap();
    let times = text.lines().filter_map(|line| line.split(' ').next()?.parse().ok());
    let solutions: Vec<TamaasSolution> = times
        .zip(numbers.chunks_exact(lattice.len()))
        .map(|(time, pressure)| TamaasSolution { pressure: pressure.to_vec(), time })
        .collect();
    assert_eq!(solutions.len(), pressures.len(), "{text}");
    solutions
}
