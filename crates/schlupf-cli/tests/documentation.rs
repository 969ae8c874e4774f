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

/// The last command of every block of commands that a block of output follows.
fn samples(page: &Path) -> Vec<Sample> {
    let text = std::fs::read_to_string(page).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    let starts = (0..lines.len()).filter(|k| lines[*k] == "```sh");
    let samples = starts.filter_map(|start| {
        let (commands, end) = block(&lines, start);
        let follows = lines[end..].iter().position(|line| *line == "```text")?;
        if follows > 6 {
            return None;
        }
        let commands = commands.join("\n").replace("\\\n", " ");
        let command = commands.lines().rfind(|line| line.starts_with("schlupf "))?.to_owned();
        let (output, _) = block(&lines, end + follows);
        Some(Sample { page: page.display().to_string(), command, output })
    });
    samples.collect()
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

/// Whether a line is the same, but for the last digits of its numbers and for what is rounding.
fn is_same(shown: &str, printed: &str) -> bool {
    let is_close = |(shown, printed): (&str, &str)| {
        let numbers = [shown, printed].map(|word| word.trim_end_matches(',').parse::<f64>());
        match numbers {
            [Ok(one), Ok(two)] => (one - two).abs() <= 2e-3 * one.abs() + 1e-5,
            _ => shown == printed,
        }
    };
    let words = |line: &str| line.split_whitespace().count();
    let pairs = shown.split_whitespace().zip(printed.split_whitespace());
    words(shown) == words(printed) && pairs.into_iter().all(is_close)
}

fn check(sample: &Sample) {
    let Sample { page, command, output } = sample;
    let run = Command::new(env!("CARGO_BIN_EXE_schlupf"))
        .args(arguments(command))
        .current_dir(workspace())
        .output()
        .unwrap();
    let printed = String::from_utf8(run.stdout).unwrap() + &String::from_utf8_lossy(&run.stderr);
    let mut rest = printed.lines();
    for line in output.iter().filter(|line| *line != "…") {
        let is_there = rest.any(|printed| is_same(line, printed));
        assert!(is_there, "{page}: {command}\nhas {line:?} below it, but prints\n{printed}");
    }
}

#[test]
fn sample_outputs_are_what_the_command_prints() {
    let docs = std::fs::read_dir(workspace().join("docs")).unwrap();
    let pages = docs.map(|entry| entry.unwrap().path()).chain([workspace().join("README.md")]);
    let pages = pages.filter(|page| page.extension().is_some_and(|ending| ending == "md"));
    let samples: Vec<Sample> = pages.flat_map(|page| samples(&page)).collect();
    assert!(samples.len() >= 4, "{samples:?}");
    samples.iter().for_each(check);
}
