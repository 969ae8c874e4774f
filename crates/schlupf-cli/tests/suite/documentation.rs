//! Sample outputs in README and docs are what the command prints.

use std::path::{Path, PathBuf};
use std::process::Command;

fn workspace() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// A command with the output that a page shows below it.
#[derive(Debug)]
struct Sample {
    page: String,
    command: String,
    output: Vec<String>,
}

/// The text of the fenced block that begins on a line, and the line after it.
fn block(lines: &[&str], start: usize) -> (Vec<String>, usize) {
    let length = lines[start + 1..].iter().position(|line| line.starts_with("```")).unwrap();
    let text = lines[start + 1..start + 1 + length].iter().map(|line| (*line).to_owned());
    (text.collect(), start + length + 2)
}

/// Every block of output with the last command above it.
fn samples(page: &Path) -> Vec<Sample> {
    let page_name = page.display().to_string();
    let text = std::fs::read_to_string(page).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    let mut samples = Vec::new();
    let mut command = None;
    // Whether a command is right above.
    let mut is_below = false;
    let mut line = 0;
    while line < lines.len() {
        let Some(language) = lines[line].strip_prefix("```") else {
            is_below &= lines[line].is_empty();
            line += 1;
            continue;
        };
        let (text, end) = block(&lines, line);
        match language {
            "sh" => command = last_command(&text),
            "text" => samples.push(Sample {
                page: page_name.clone(),
                command: command.take().unwrap_or_else(|| {
                    panic!("{page_name}:{}: output without a command of its own", line + 1)
                }),
                output: text,
            }),
            // Formulas have no language; below a command it would be output that is not checked.
            "" => assert!(!is_below, "{page_name}:{}: output is ```text", line + 1),
            _ => {}
        }
        is_below = language == "sh" && command.is_some();
        line = end;
    }
    samples
}

/// The last command `schlupf` of a block.
fn last_command(block: &[String]) -> Option<String> {
    let commands = block.join("\n").replace("\\\n", " ");
    commands.lines().rfind(|line| line.starts_with("schlupf ")).map(str::to_owned)
}

/// The words of a command as a shell splits them, without what writes files.
fn arguments(command: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut quote = None;
    for c in command.chars() {
        match (quote, c) {
            (None, '"' | '\'') => quote = Some(c),
            (Some(open), c) if c == open => quote = None,
            (None, ' ') => words.push(String::new()),
            _ => words.last_mut().unwrap().push(c),
        }
    }
    words.retain(|word| !word.is_empty());
    while let Some(k) = words.iter().position(|word| word == "--figures" || word == "--write-case")
    {
        words.drain(k..k + 2);
    }
    words.split_off(1)
}

/// Line that stands for any number of omitted ones.
const OMITTED: &str = "…";

/// Whether the output is what is printed, line by line and digit by digit, but for what is omitted.
fn is_same(output: &[String], printed: &[&str]) -> bool {
    match output.split_first() {
        None => printed.is_empty(),
        Some((line, rest)) if line == OMITTED => {
            (0..=printed.len()).any(|omitted| is_same(rest, &printed[omitted..]))
        }
        Some((line, rest)) => printed
            .split_first()
            .is_some_and(|(first, others)| line == first && is_same(rest, others)),
    }
}

fn check(sample: &Sample) {
    let Sample { page, command, output } = sample;
    let run = Command::new(env!("CARGO_BIN_EXE_schlupf"))
        .args(arguments(command))
        .current_dir(workspace())
        .output()
        .unwrap();
    let printed = String::from_utf8(run.stdout).unwrap() + &String::from_utf8_lossy(&run.stderr);
    let lines: Vec<&str> = printed.lines().collect();
    let shown = output.join("\n");
    assert!(is_same(output, &lines), "{page}: {command}\nshows\n{shown}\nbut prints\n{printed}");
}

#[test]
fn sample_outputs_are_what_the_command_prints() {
    let docs = std::fs::read_dir(workspace().join("docs")).unwrap();
    let pages = docs.map(|entry| entry.unwrap().path()).chain([workspace().join("README.md")]);
    let pages = pages.filter(|page| page.extension().is_some_and(|ending| ending == "md"));
    let samples: Vec<Sample> = pages.flat_map(|page| samples(&page)).collect();
    for page in ["command.md", "identification.md"] {
        assert!(samples.iter().any(|sample| sample.page.ends_with(page)), "{page} has no sample");
    }
    samples.iter().for_each(check);
}

#[test]
fn outputs_are_compared_digit_by_digit() {
    let is_same = |shown: &str, printed: &str| {
        let shown: Vec<String> = shown.lines().map(str::to_owned).collect();
        is_same(&shown, &printed.lines().collect::<Vec<_>>())
    };
    let printed = "load  80 kN\nforce  30.26 kN\n\nleft over 1.319e-6 kW";
    assert!(is_same(printed, printed));
    assert!(is_same("load  80 kN\n…\nleft over 1.319e-6 kW", printed));
    assert!(is_same("…\nforce  30.26 kN\n…", printed));
    for wrong in [
        "load  80 kN\n…\nleft over 1.466e-6 kW",
        "load  80 kN\nforce  30.26 kN",
        "force  30.26 kN\n…",
        "load  80 kN\n\nleft over 1.319e-6 kW",
        "",
    ] {
        assert!(!is_same(wrong, printed), "{wrong}");
    }
}
