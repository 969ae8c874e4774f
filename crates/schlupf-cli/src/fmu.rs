//! `schlupf fmu`.

use std::env::consts::{DLL_PREFIX, DLL_SUFFIX};
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

use clap::builder::PossibleValuesParser;
use clap::{Args, ValueHint};
use schlupf_case::fmu::{Binary, Fmu as Unit, Role, Version};

use crate::arguments::CaseArguments;
use crate::failure::{Failure, SUCCESS};
use crate::outputs::{self, Input, Output};
use crate::progress::Progress;
use crate::read_case::read_case;
use crate::{report, stdout};

/// Which case, and what goes into the archive.
#[derive(Debug, Args)]
pub struct Fmu {
    #[command(flatten)]
    pub case: CaseArguments,
    /// Where to write the FMU
    #[arg(short, long, value_name = "FILE", default_value = "contact.fmu",
        value_hint = ValueHint::FilePath)]
    pub output: PathBuf,
    /// Version of FMI
    #[arg(long, value_name = "VERSION", default_value = "2",
        value_parser = PossibleValuesParser::new(["2", "3"]))]
    pub fmi: String,
    /// The library for this platform [default: the one beside the command]
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub library: Option<PathBuf>,
    /// The library for another platform, such as win64 (FMI 2) or x86_64-windows (FMI 3)
    #[arg(long, value_name = "PLATFORM=FILE", value_parser = platform_and_file)]
    pub add_binary: Vec<(String, PathBuf)>,
    /// Print no summary
    #[arg(short, long)]
    pub quiet: bool,
}

fn platform_and_file(text: &str) -> Result<(String, PathBuf), String> {
    let is_name = |platform: &str| {
        let is_of_name = |c: char| c.is_ascii_alphanumeric() || "-_".contains(c);
        !platform.is_empty() && platform.chars().all(is_of_name)
    };
    match text.split_once('=') {
        Some((platform, file)) if is_name(platform) && !file.is_empty() => {
            Ok((platform.to_owned(), file.into()))
        }
        _ => Err("must be PLATFORM=FILE, such as win64=schlupf_c.dll".to_owned()),
    }
}

/// Writes the force element of a case as an FMU.
pub fn fmu(arguments: &Fmu) -> Result<u8, Failure> {
    let output = Output { option: "--output".to_owned(), path: arguments.output.clone() };
    let file = read_case(&arguments.case)?;
    let outputs = [output];
    outputs::check(&outputs, None)?;
    let version = if arguments.fmi == "2" { Version::Two } else { Version::Three };
    let libraries = libraries(arguments, version)?;
    let inputs = libraries.iter().map(|(_, path)| Input {
        what: "a library".to_owned(),
        path: path.clone(),
        except: None,
    });
    let inputs: Vec<Input> =
        Input::of_case(&arguments.case, &file).into_iter().chain(inputs).collect();
    outputs::refuse_inputs(&outputs, None, &inputs)?;
    let binaries = libraries.iter().map(|(platform, path)| read(platform, path));
    let binaries = binaries.collect::<Result<Vec<_>, _>>()?;
    let progress = Progress::start();
    let unit = Unit::of(&file, &progress.watch())?;
    drop(progress);
    let notices = file.notices();
    notices.iter().chain(unit.warnings()).for_each(report::warn);
    let bytes = unit.to_bytes(version, &binaries);
    let bytes = bytes.map_err(|error| Failure::file(&arguments.output, io::Error::other(error)))?;
    let size = bytes.len();
    outputs::write(&[(arguments.output.clone(), bytes)], None)?;
    if !arguments.quiet {
        stdout::write(&summary(arguments, &unit, &binaries, size))?;
    }
    Ok(SUCCESS)
}

/// Platforms with their libraries, each once.
fn libraries(arguments: &Fmu, version: Version) -> Result<Vec<(String, PathBuf)>, Failure> {
    let own = Binary::platform(version);
    let library = match &arguments.library {
        Some(library) => library.clone(),
        None => beside_command()?,
    };
    let mut all = vec![(own, library)];
    for (platform, path) in &arguments.add_binary {
        if all.iter().any(|(other, _)| other == platform) {
            let message = format!(
                "--add-binary: {platform} has a library already (--library names that of this \
                 platform)"
            );
            return Err(Failure::Arguments(message));
        }
        all.push((platform.clone(), path.clone()));
    }
    Ok(all)
}

/// The library as cargo makes it, in the folder of the program that runs.
fn beside_command() -> Result<PathBuf, Failure> {
    let name = format!("{DLL_PREFIX}schlupf_c{DLL_SUFFIX}");
    let program =
        std::env::current_exe().map_err(|cause| Failure::file(Path::new(&name), cause))?;
    let path = program.with_file_name(name);
    if path.is_file() {
        return Ok(path);
    }
    let message = "the library that an FMU needs is not there: `cargo build --release --package \
                   schlupf-c` makes it, and --library names one elsewhere";
    Err(Failure::file(&path, io::Error::new(ErrorKind::NotFound, message)))
}

/// A function that every library of an FMU has.
const FUNCTION: &[u8] = b"fmi3GetVersion";

fn read(platform: &str, path: &Path) -> Result<Binary, Failure> {
    let bytes = fs::read(path).map_err(|cause| Failure::file(path, cause))?;
    if !bytes.windows(FUNCTION.len()).any(|part| part == FUNCTION) {
        let message = "must be a library of the crate schlupf-c, but has no functions of FMI";
        return Err(Failure::file(path, io::Error::new(ErrorKind::InvalidData, message)));
    }
    Ok(Binary { platform: platform.to_owned(), bytes })
}

fn summary(arguments: &Fmu, unit: &Unit, binaries: &[Binary], size: usize) -> String {
    let names = |is_one: fn(Role) -> bool| -> String {
        let all = unit.variables().iter().filter(|variable| is_one(variable.role));
        let names: Vec<&str> = all.map(|variable| variable.name.as_str()).collect();
        if names.is_empty() { "none".to_owned() } else { names.join(", ") }
    };
    let platforms: Vec<&str> = binaries.iter().map(|binary| binary.platform.as_str()).collect();
    format!(
        "{}\n\nFMI        {}.0: model exchange and co-simulation\ninputs     {}\noutputs    {}\n\
         states     {}\nplatforms  {}\nsize       {:.1} MB\n",
        arguments.output.display(),
        arguments.fmi,
        names(|role| matches!(role, Role::Input(_))),
        names(|role| matches!(role, Role::Output(_))),
        names(|role| matches!(role, Role::State(_))),
        platforms.join(", "),
        size as f64 / 1e6,
    )
}
