//! Programs in C, C++ and Fortran with the installed library.

use std::path::Path;
use std::process::Command;

use crate::install_c::{install, read};
use crate::step::Step;

const PACKAGE: &str = "crates/schlupf-c";

/// What the part needs, with an argument that shows that it is there; `.ci/run` installs it.
const PROGRAMS: [(&str, &str); 7] = [
    ("gcc", "--version"),
    ("g++", "--version"),
    ("gfortran", "--version"),
    ("cmake", "--version"),
    ("pkg-config", "--version"),
    ("valgrind", "--version"),
    ("nm", "--version"),
];

/// Largest relative difference of the numbers that two programs print.
const DIFFERENCE: f64 = 1e-12;

/// Installs the library, compiles and runs what uses it, compares the numbers, and looks for
/// errors of memory.
pub fn run(workspace: &Path, target: &Path) -> Result<(), String> {
    if !cfg!(target_os = "linux") {
        eprintln!("  skipped: programs in C are compiled and run on Linux only");
        return Ok(());
    }
    PROGRAMS.iter().try_for_each(|(program, argument)| {
        let found = Command::new(program).arg(argument).output();
        found.map(|_| ()).map_err(|error| format!("{program} is needed, but: {error}"))
    })?;
    let target = std::path::absolute(workspace.join(target)).map_err(|error| error.to_string())?;
    let folder = target.join("c");
    let prefix = folder.join("prefix");
    install(workspace, &target, &prefix, "dev")?;
    let build = Build { workspace, folder: &folder, prefix: &prefix };
    build.compare_symbols()?;
    build.programs()?;
    let names = ["brake_c", "brake_cpp", "brake_f", "cmake/brake_c", "cmake/brake_static"];
    let exact = numbers(&build.output(Path::new("cargo"), RUST)?);
    for name in names.into_iter().chain(["cmake/brake_cpp"]) {
        let found = numbers(&build.output(&folder.join(name), "")?);
        if found.len() != exact.len() || found.is_empty() {
            return Err(format!("{name} prints {} numbers, Rust {}", found.len(), exact.len()));
        }
        let mut pairs = found.iter().zip(&exact);
        if let Some((one, other)) =
            pairs.find(|(one, other)| (*one - *other).abs() > DIFFERENCE * other.abs())
        {
            return Err(format!("{name} prints {one:e}, Rust {other:e}"));
        }
    }
    for name in ["brake_c", "brake_f", "module_f", "misuse", "block"] {
        let program = folder.join(name);
        let check = "--quiet --error-exitcode=1 --leak-check=full --errors-for-leak-kinds=definite";
        // Where the block of Simulink has its case; others take no argument.
        let case = folder.join("block.toml");
        let arguments = format!("{check} {} {}", program.display(), case.display());
        Step::new("valgrind".into(), &arguments).run(workspace)?;
    }
    Ok(())
}

/// The example in Rust.
const RUST: &str = "run --quiet --package schlupf-c --example brake";

/// Where programs are built, with what.
struct Build<'a> {
    workspace: &'a Path,
    folder: &'a Path,
    prefix: &'a Path,
}

impl Build<'_> {
    /// Compiles the examples and the tests, with pkg-config and with CMake.
    fn programs(&self) -> Result<(), String> {
        let (folder, prefix) = (self.folder.display(), self.prefix.display());
        let flags = self.output(Path::new("pkg-config"), "--cflags --libs schlupf")?;
        let flags = format!("{} -Wl,-rpath,{prefix}/lib", flags.trim());
        let strict = "-O2 -Wall -Wextra -Werror -pedantic";
        let module = format!("{prefix}/share/schlupf/schlupf.f90 -J{folder}");
        let compile = |compiler: &str, arguments: String| {
            Step::new(compiler.into(), &format!("{strict} {arguments} {flags}")).run(self.workspace)
        };
        let [examples, tests] = ["examples", "tests"].map(|part| format!("{PACKAGE}/{part}"));
        compile("gcc", format!("-std=c99 {examples}/brake.c -o {folder}/brake_c"))?;
        compile("g++", format!("-std=c++11 {examples}/brake.cpp -o {folder}/brake_cpp"))?;
        for program in ["examples/brake", "tests/module"] {
            let source = format!("{PACKAGE}/{program}.f90");
            let program = program.rsplit('/').next().unwrap_or(program);
            let output = format!("{folder}/{program}_f");
            compile("gfortran", format!("-g -std=f2008 {module} {source} -o {output}"))?;
        }
        compile("gcc", format!("-std=c99 -pthread {tests}/misuse.c -o {folder}/misuse"))?;
        let block = format!("{examples}/schlupf_block.c -I{tests}/simulink");
        let engine = format!("-DMATLAB_MEX_FILE {tests}/simulink/engine.c -o {folder}/block");
        compile("gcc", format!("-std=c99 {block} {engine}"))?;
        let steps = [
            format!("-S {examples} -B {folder}/cmake -DCMAKE_PREFIX_PATH={prefix}"),
            format!("--build {folder}/cmake"),
        ];
        let cmake = |arguments| Step::new("cmake".into(), arguments).run(self.workspace);
        steps.iter().try_for_each(|arguments| cmake(arguments))
    }

    /// Compares the functions of the shared library with the list.
    fn compare_symbols(&self) -> Result<(), String> {
        let library = self.prefix.join("lib/libschlupf.so");
        let arguments =
            format!("--dynamic --defined-only --format=just-symbols {}", library.display());
        let found = self.output(Path::new("nm"), &arguments)?;
        let list = self.workspace.join(PACKAGE).join("symbols.txt");
        let mut found: Vec<&str> = found.lines().collect();
        found.sort_unstable();
        if read(&list)?.lines().eq(found.iter().copied()) {
            return Ok(());
        }
        Err(format!(
            "the library exports other functions than {}:\n{}",
            list.display(),
            found.join("\n")
        ))
    }

    /// What a program prints.
    fn output(&self, program: &Path, arguments: &str) -> Result<String, String> {
        eprintln!("  > {} {arguments}", program.display());
        let mut command = Command::new(program);
        command.args(arguments.split_whitespace()).current_dir(self.workspace);
        command.env("PKG_CONFIG_PATH", self.prefix.join("lib/pkgconfig"));
        let output = command.output().map_err(|error| format!("{}: {error}", program.display()))?;
        if !output.status.success() {
            let text = String::from_utf8_lossy(&output.stderr).into_owned();
            return Err(format!("{}: {}\n{text}", program.display(), output.status));
        }
        Ok(String::from_utf8_lossy(&output.stdout).into_owned())
    }
}

fn numbers(text: &str) -> Vec<f64> {
    text.split_whitespace().filter_map(|word| word.parse().ok()).collect()
}
