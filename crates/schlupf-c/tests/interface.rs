//! Elements through the C interface are those of Rust, whatever a program does with them.

#![allow(unsafe_code, reason = "functions for C")]

mod common;

use std::ffi::CStr;
use std::ptr;
use std::thread;

use common::{CASE, Found, Handle, METHODS};
use schlupf_c::Status;
use schlupf_c::interface::*;
use schlupf_case::{CaseFile, Folder, Overrides};

fn code(status: Status) -> Code {
    status as Code
}

/// Motions, loads and states of a wheel that lifts off in between.
fn conditions(start: &[f64]) -> Vec<(Vec<f64>, Vec<f64>)> {
    let at = |k: u32| {
        let part = f64::from(k) / 100.0;
        let mut inputs = start.to_vec();
        inputs[0] *= 1.0 - part;
        inputs[3] *= 1.0 - part * part;
        inputs[4] *= (7.0 * part).cos();
        (inputs, vec![2e-3 * part, -1e-3 * part, 0.1 * part])
    };
    (0..=100).map(at).collect()
}

/// Numbers, names and units are those of the element in Rust, bit for bit: 1e-12 and better.
#[test]
fn an_element_is_that_of_rust() {
    for method in METHODS {
        let handle = Handle::of_method(method);
        let assignments = &[format!("solver.method={method}")];
        let set = Overrides { option: "override", assignments };
        let file = CaseFile::from_str(CASE, "", Folder::new(""), set).unwrap();
        let mut element = file.pose(&schlupf::unwatched).unwrap().element().unwrap();
        assert_eq!(handle.start(), element.start());
        let kinds = [element.inputs(), element.outputs(), element.states()];
        for (kind, quantities) in (0..).zip(kinds) {
            assert_eq!(schlupf_element_count(handle.0, kind), quantities.len());
            for (k, quantity) in quantities.iter().enumerate() {
                let texts = [schlupf_element_name, schlupf_element_unit];
                let texts = texts.map(|text| unsafe { CStr::from_ptr(text(handle.0, kind, k)) });
                let found = unsafe { schlupf_element_find(handle.0, kind, texts[0].as_ptr()) };
                assert_eq!(usize::try_from(found), Ok(k));
                let texts = texts.map(|text| text.to_str().unwrap());
                assert_eq!(texts, [quantity.name(), quantity.quantity.unit()]);
            }
            assert!(schlupf_element_description(handle.0, kind, quantities.len()).is_null());
        }
        let (mut found, mut expected) = (handle.room(1), element.evaluation());
        for (inputs, mut states) in conditions(&element.start()) {
            handle.evaluate(&inputs, &states, &mut found);
            let status = Status::from(element.evaluate(&inputs, &states, &mut expected));
            assert_eq!(found.status, code(status));
            assert_eq!(found.outputs, expected.outputs);
            assert_eq!(found.rates, expected.rates);
            assert_eq!(found.derivatives, expected.derivatives);
            let mut after = states.clone();
            element.advance(&inputs, &mut after, 0.01);
            assert_eq!(handle.advance(&inputs, &mut states, 0.01), code(status));
            assert_eq!(states, after);
        }
    }
}

/// Rows are evaluations one by one, each with its code.
#[test]
fn rows_are_evaluations() {
    let handle = Handle::of_method("polach");
    let mut rows = conditions(&handle.start());
    rows[3].0[0] = f64::NAN;
    let (inputs, states): (Vec<_>, Vec<_>) = rows.iter().cloned().unzip();
    let mut codes = vec![-1; rows.len()];
    let all = handle.rows(&inputs.concat(), &states.concat(), &mut codes);
    assert_eq!(all.status, code(Status::NotFinite));
    assert_eq!(handle.message(), "velocity_x must be finite, but is NaN");
    let (mut found, mut bits) = (handle.room(1), Vec::new());
    for (row, (inputs, states)) in rows.iter().enumerate() {
        handle.evaluate(inputs, states, &mut found);
        assert_eq!(codes[row], found.status);
        bits.push(found.outputs.iter().map(|x| x.to_bits()).collect::<Vec<_>>());
    }
    assert!(codes.contains(&code(Status::Found)) && codes.contains(&code(Status::NoContact)));
    let outputs: Vec<u64> = all.outputs.iter().map(|x| x.to_bits()).collect();
    assert_eq!(outputs, bits.concat());
    assert_eq!(handle.rows(&[], &[], &mut []).status, code(Status::Found));
}

/// Eight threads with an element each give what one gives, bit for bit, also with a solver.
#[test]
fn threads_give_what_one_gives() {
    let run = |method: &str| {
        let (element, code) = Handle::new(
            CASE,
            &[&format!("solver.method={method}"), "grid.cells_x=8", "grid.cells_y=8"],
        );
        assert_eq!(code, 0, "{}", element.message());
        let mut found = element.room(1);
        let evaluate = |(inputs, states): (Vec<f64>, Vec<f64>)| {
            element.evaluate(&inputs, &states, &mut found);
            found.bits()
        };
        let count = if method == "fastsim" { 5 } else { 100 };
        conditions(&element.start()).into_iter().take(count).map(evaluate).collect::<Vec<_>>()
    };
    for method in ["table", "polach", "fastsim"] {
        let one = run(method);
        let results: Vec<_> = thread::scope(|scope| {
            let threads: Vec<_> = (0..8).map(|_| scope.spawn(|| run(method))).collect();
            threads.into_iter().map(|thread| thread.join().unwrap()).collect()
        });
        assert!(results.iter().all(|result| *result == one), "{method}");
    }
}

/// What a method neglects, with its code; nothing of a wrong case.
#[test]
fn warnings_are_lines() {
    assert_eq!(Handle::of_method("polach").warnings(), "");
    let layer = "layer.yield_stress=100 MPa";
    let layer = ["layer.thickness=10 um", "layer.shear_modulus=8 GPa", layer];
    let (element, status) = Handle::new(CASE, &[&layer[..], &["solver.method=polach"]].concat());
    assert_eq!(status, 0, "{}", element.message());
    let warnings = element.warnings();
    let codes: Vec<_> = warnings.lines().map(|line| line.split(':').next().unwrap()).collect();
    assert_eq!(codes, ["no-yield"], "{warnings}");
    assert_eq!(Handle::new("nonsense", &[]).0.warnings(), "");
}

/// A wrong case is a code and a message, and so is a file that is not there.
#[test]
fn wrong_cases_have_a_message() {
    let (element, found) = Handle::new("[normal]\nlod = \"1 kN\"", &[]);
    assert_eq!(found, code(Status::InvalidCase));
    assert!(element.message().contains("normal.lod"), "{}", element.message());
    assert_eq!(element.counts(), [0; 3]);
    assert_eq!(schlupf_element_forget(element.0), code(Status::InvalidCase));
    let (element, found) = Handle::new(CASE, &["normal.load"]);
    assert_eq!(found, code(Status::InvalidCase));
    assert!(element.message().contains("section.field=value"));
    let mut element = Handle(0);
    let path = c"no such file.toml".as_ptr();
    let found = unsafe { schlupf_element_from_file(path, ptr::null(), 0, &raw mut element.0) };
    assert_eq!(found, code(Status::Unreadable));
    assert!(element.message().contains("no such file.toml"));
}

/// Clones do not share what happens to one of them, and outlive it.
#[test]
fn clones_are_independent() {
    let one = Handle::of_method("polach");
    let mut other = Handle(0);
    assert_eq!(unsafe { schlupf_element_clone(one.0, &raw mut other.0) }, 0);
    let (inputs, mut found) = (other.start(), other.room(1));
    assert_eq!(schlupf_element_destroy(one.0), 0);
    assert_eq!(schlupf_element_destroy(one.0), code(Status::InvalidElement));
    assert_eq!(one.message(), "there is no such element; nothing was done");
    other.evaluate(&inputs, &[0.0; 3], &mut found);
    assert_eq!(found.status, code(Status::Found));
}

/// What is no number, no array of the right size, or no pointer is a code.
#[test]
fn wrong_arguments_are_codes() {
    let element = Handle::of_method("polach");
    let (start, states) = (element.start(), [0.0; 3]);
    let mut found = element.room(1);
    let evaluate = |inputs: &[f64], states: &[f64], found: &mut Found| {
        element.evaluate(inputs, states, found);
        (found.status, element.message())
    };
    let wrong = code(Status::WrongSize);
    let (status, message) = evaluate(&start[1..], &states, &mut found);
    assert_eq!((status, message.as_str()), (wrong, "inputs must have 8 numbers, but have 7"));
    assert_eq!(evaluate(&start, &[], &mut found).0, wrong);
    let mut small = found.clone();
    small.derivatives.pop();
    assert_eq!(evaluate(&start, &states, &mut small).0, wrong);
    // What is not wanted has the size 0.
    small.derivatives.clear();
    small.rates.clear();
    assert_eq!(evaluate(&start, &states, &mut small), (0, String::new()));
    let (status, message) = evaluate(&start, &[0.0, f64::INFINITY, 0.0], &mut found);
    assert_eq!(status, code(Status::NotFinite));
    assert_eq!(message, "elastic_shift_y must be finite, but is inf");
    assert!(found.outputs.iter().all(|output| output.is_nan()));
    assert_eq!(element.advance(&start, &mut [0.0; 3], f64::NAN), code(Status::NotFinite));
    assert_eq!(element.message(), "the duration must be finite and not negative, but is NaN");
    assert_eq!(element.advance(&start, &mut [0.0; 3], -1.0), code(Status::NotFinite));
    let pointer = code(Status::InvalidPointer);
    let unaligned = start.as_ptr().wrapping_byte_add(1);
    for place in [ptr::null(), unaligned] {
        let mut states = states;
        let states = states.as_mut_ptr();
        let found = unsafe { schlupf_element_advance(element.0, place, 8, states, 3, 1.0) };
        assert_eq!(found, pointer);
        assert_eq!(element.message(), "inputs must not be null or unaligned");
    }
    unsafe {
        let (none, place) = (ptr::null(), ptr::null_mut());
        assert_eq!(schlupf_element_from_text(none, none, ptr::null(), 0, place), pointer);
        assert_eq!(schlupf_element_from_text(c"".as_ptr(), none, ptr::null(), 1, place), pointer);
        assert_eq!(schlupf_element_clone(element.0, place), pointer);
        assert_eq!(schlupf_element_start(element.0, ptr::null_mut(), 8), pointer);
        assert_eq!(schlupf_element_find(element.0, SCHLUPF_INPUTS, none), -1);
        assert_eq!(schlupf_element_message(0, ptr::null_mut(), 0), 42);
        let mut text = [1; 4];
        assert_eq!(schlupf_element_message(0, text.as_mut_ptr(), 4), 42);
        assert_eq!(CStr::from_ptr(text.as_ptr()), c"the");
    }
    let mut other = Handle(0);
    let text = c"\xff".as_ptr();
    let (none, place) = (ptr::null(), &raw mut other.0);
    assert_eq!(unsafe { schlupf_element_from_text(text, none, ptr::null(), 0, place) }, 8);
    assert_eq!(other.message(), "text must be text in UTF-8");
    assert_eq!(schlupf_element_count(element.0, 3), 0);
}

/// Every code has a text, and no other.
#[test]
fn codes_have_texts() {
    let text = |code| unsafe { CStr::from_ptr(schlupf_status_text(code)) };
    for (code, status) in (0..).zip(Status::ALL) {
        assert_eq!((*status as Code, text(code)), (code, status.text()));
    }
    assert_eq!(text(-1), c"unknown code");
    assert_eq!(schlupf_abi_version(), SCHLUPF_ABI_VERSION);
}
