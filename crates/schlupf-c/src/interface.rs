//! The functions of the C interface.
//!
//! Texts are UTF-8 and end with a null byte. Numbers are in SI units, temperatures in degC. Arrays
//! have their size beside them, and a wrong one is refused.

#![allow(unsafe_code, reason = "functions that C calls, with pointers")]
#![allow(clippy::too_many_arguments, reason = "each array has its size beside it")]

use std::ffi::{CStr, c_char};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::ptr;

use schlupf::element::Signal;

use crate::held::{Contact, Held, Origin};
use crate::pointers::{self, Given, Wanted};
use crate::texts::Texts;
use crate::trouble::Trouble;
use crate::{Status, table};

/// Version of the binary interface: grows when a program must be compiled anew.
pub const SCHLUPF_ABI_VERSION: u32 = 1;

/// The inputs of an element.
pub const SCHLUPF_INPUTS: i32 = 0;
/// The outputs of an element.
pub const SCHLUPF_OUTPUTS: i32 = 1;
/// The states of an element.
pub const SCHLUPF_STATES: i32 = 2;

/// A force element: a number that no other element of the process has; 0 is none.
///
/// Threads may use different elements at the same time. An element that was destroyed is refused
/// (`SCHLUPF_INVALID_ELEMENT`), one that another thread is using too (`SCHLUPF_BUSY`).
pub type Element = u64;

/// What became of a call: `SCHLUPF_FOUND` or another code.
pub type Code = i32;

/// Version of the binary interface that the library has: to be `SCHLUPF_ABI_VERSION`.
#[unsafe(no_mangle)]
pub extern "C" fn schlupf_abi_version() -> u32 {
    SCHLUPF_ABI_VERSION
}

/// Version of the library, as text.
#[unsafe(no_mangle)]
pub extern "C" fn schlupf_version() -> *const c_char {
    Texts::version().as_ptr()
}

/// What a code means.
#[unsafe(no_mangle)]
pub extern "C" fn schlupf_status_text(status: Code) -> *const c_char {
    let known = Status::ALL.iter().find(|known| **known as Code == status);
    known.map_or(c"unknown code", |known| known.text()).as_ptr()
}

/// Makes an element of the text of a case.
///
/// `folder` is where relative paths of files in the case start; null for the working directory.
/// `overrides` are texts `section.field=value` in place of what the case says, `--set` of the
/// command.
///
/// What is wrong with the case is the message of the element, which is made, and to be destroyed,
/// in any case but that of `SCHLUPF_INVALID_POINTER`.
///
/// # Safety
/// Pointers are null or point to what the parameters say.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn schlupf_element_from_text(
    text: *const c_char,
    folder: *const c_char,
    overrides: *const *const c_char,
    override_count: usize,
    element: *mut Element,
) -> Code {
    guarded(|| {
        // SAFETY: that of this function.
        unsafe {
            let set = pointers::texts("overrides", overrides, override_count);
            let text = pointers::text("text", text);
            let folder = if folder.is_null() { Ok("") } else { pointers::text("folder", folder) };
            create(element, || Ok(Held::new(&Origin::Text(text?, folder?), &set?)))
        }
    })
}

/// Makes an element of a case file; relative paths in it start in its folder. Otherwise like
/// `schlupf_element_from_text`.
///
/// # Safety
/// Pointers are null or point to what the parameters say.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn schlupf_element_from_file(
    path: *const c_char,
    overrides: *const *const c_char,
    override_count: usize,
    element: *mut Element,
) -> Code {
    guarded(|| {
        // SAFETY: that of this function.
        unsafe {
            let set = pointers::texts("overrides", overrides, override_count);
            let path = pointers::text("path", path);
            create(element, || Ok(Held::new(&Origin::File(path?), &set?)))
        }
    })
}

/// Makes an independent copy of an element; a solver begins anew.
///
/// # Safety
/// `copy` is null or points to an element.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn schlupf_element_clone(element: Element, copy: *mut Element) -> Code {
    guarded(|| {
        // SAFETY: that of this function.
        unsafe { pointers::put("element", copy, 0)? };
        let held = table::with(element, |held| held.clone()).map_err(Trouble::Status)?;
        // SAFETY: that of this function.
        unsafe { create(copy, || Ok(held)) }
    })
}

/// Destroys an element.
#[unsafe(no_mangle)]
pub extern "C" fn schlupf_element_destroy(element: Element) -> Code {
    guarded(|| match table::remove(element) {
        Ok(()) => Ok(Status::Found),
        Err(status) => Err(Trouble::Status(status)),
    })
}

/// Number of its inputs, outputs or states (`SCHLUPF_INPUTS`, …); 0 where there is no such element.
#[unsafe(no_mangle)]
pub extern "C" fn schlupf_element_count(element: Element, kind: i32) -> usize {
    signals(element, kind, <[Signal]>::len).unwrap_or(0)
}

/// Name of an input, output or state; null where there is none. The pointer stays valid, also
/// after the element was destroyed.
#[unsafe(no_mangle)]
pub extern "C" fn schlupf_element_name(element: Element, kind: i32, index: usize) -> *const c_char {
    text_of(element, kind, index, |texts| &texts.name)
}

/// Its unit; empty where it is dimensionless. Otherwise like `schlupf_element_name`.
#[unsafe(no_mangle)]
pub extern "C" fn schlupf_element_unit(element: Element, kind: i32, index: usize) -> *const c_char {
    text_of(element, kind, index, |texts| &texts.unit)
}

/// What it is. Otherwise like `schlupf_element_name`.
#[unsafe(no_mangle)]
pub extern "C" fn schlupf_element_description(
    element: Element,
    kind: i32,
    index: usize,
) -> *const c_char {
    text_of(element, kind, index, |texts| &texts.description)
}

/// Index of the input, output or state of a name; −1 where there is none.
///
/// # Safety
/// `name` is null or a text.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn schlupf_element_find(
    element: Element,
    kind: i32,
    name: *const c_char,
) -> isize {
    // SAFETY: that of this function.
    let Ok(name) = (unsafe { pointers::text("name", name) }) else { return -1 };
    let place = |all: &[Signal]| all.iter().position(|signal| signal.name() == name);
    signals(element, kind, place).flatten().map_or(-1, |index| index as isize)
}

/// The inputs that the case describes. States start at zero, which is a contact without tractions.
///
/// # Safety
/// `inputs` is null or has room for so many numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn schlupf_element_start(
    element: Element,
    inputs: *mut f64,
    input_count: usize,
) -> Code {
    on(element, |contact| {
        let start = contact.element.start();
        let inputs = Wanted { name: "inputs", numbers: inputs, count: input_count };
        // SAFETY: that of this function.
        unsafe { inputs.slice(start.len()) }?.copy_from_slice(&start);
        Ok(Status::Found)
    })
}

/// Finds outputs, rates of the states (in their unit over s) and derivatives.
///
/// Derivatives are those of the outputs and, after them, of the rates, a row each, with respect to
/// the inputs and, after them, the states: (outputs + states) × (inputs + states) numbers, row by
/// row. Outputs, rates and derivatives that are not wanted have the size 0. Fast methods without
/// fields allocate no memory.
///
/// # Safety
/// Arrays are null or have so many numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn schlupf_element_evaluate(
    element: Element,
    inputs: *const f64,
    input_count: usize,
    states: *const f64,
    state_count: usize,
    outputs: *mut f64,
    output_count: usize,
    rates: *mut f64,
    rate_count: usize,
    derivatives: *mut f64,
    derivative_count: usize,
) -> Code {
    // SAFETY: that of this function.
    unsafe {
        schlupf_element_evaluate_rows(
            element,
            1,
            inputs,
            input_count,
            states,
            state_count,
            outputs,
            output_count,
            rates,
            rate_count,
            derivatives,
            derivative_count,
            ptr::null_mut(),
        )
    }
}

/// The same for many wheels or instants, a row of each array for each, on the thread of the caller.
/// Sizes are those of whole arrays. `statuses` gets the code of each row, or is null. Returns the
/// largest of them.
///
/// # Safety
/// Arrays are null or have so many numbers, `statuses` is null or has room for `row_count` codes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn schlupf_element_evaluate_rows(
    element: Element,
    row_count: usize,
    inputs: *const f64,
    input_count: usize,
    states: *const f64,
    state_count: usize,
    outputs: *mut f64,
    output_count: usize,
    rates: *mut f64,
    rate_count: usize,
    derivatives: *mut f64,
    derivative_count: usize,
    statuses: *mut Code,
) -> Code {
    let given = [
        Given { name: "inputs", numbers: inputs, count: input_count },
        Given { name: "states", numbers: states, count: state_count },
    ];
    let wanted = [
        Wanted { name: "outputs", numbers: outputs, count: output_count },
        Wanted { name: "rates", numbers: rates, count: rate_count },
        Wanted { name: "derivatives", numbers: derivatives, count: derivative_count },
    ];
    // SAFETY: that of this function.
    on(element, |contact| unsafe { evaluate(contact, row_count, given, wanted, statuses) })
}

/// Lets time pass (in s) with constant inputs: `states` become those afterwards. What is not
/// finite, or a negative duration, is `SCHLUPF_NOT_FINITE`, and they stay as they are.
///
/// # Safety
/// Arrays are null or have so many numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn schlupf_element_advance(
    element: Element,
    inputs: *const f64,
    input_count: usize,
    states: *mut f64,
    state_count: usize,
    duration: f64,
) -> Code {
    on(element, |contact| {
        let [input_count_wanted, _, state_count_wanted] = contact.counts();
        let inputs = Given { name: "inputs", numbers: inputs, count: input_count };
        let states = Wanted { name: "states", numbers: states, count: state_count };
        // SAFETY: that of this function.
        let (inputs, states) =
            unsafe { (inputs.slice(Some(input_count_wanted))?, states.slice(state_count_wanted)?) };
        contact.advance(inputs, states, duration)
    })
}

/// Forgets what a solver found last, from which it would start: for results that do not depend on
/// what was evaluated before, not even within the tolerance.
#[unsafe(no_mangle)]
pub extern "C" fn schlupf_element_forget(element: Element) -> Code {
    on(element, |contact| {
        contact.element.forget();
        Ok(Status::Found)
    })
}

/// Copies the message of an element: what is wrong with its case or kept the last call on it from
/// its work, empty where nothing did. Returns the bytes of the whole message, without the null byte
/// at its end; as many as fit into `size` are copied, with a null byte.
///
/// # Safety
/// `message` is null or has room for `size` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn schlupf_element_message(
    element: Element,
    message: *mut c_char,
    size: usize,
) -> usize {
    // SAFETY: that of this function.
    unsafe { put_text_of(element, Held::message, Trouble::to_string, (message, size)) }
}

/// Copies what the method of an element neglects at the load of its case: a line for each warning,
/// which begins with its code; empty where there is none, or no element. Otherwise like
/// `schlupf_element_message`.
///
/// # Safety
/// `warnings` is null or has room for `size` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn schlupf_element_warnings(
    element: Element,
    warnings: *mut c_char,
    size: usize,
) -> usize {
    // SAFETY: that of this function.
    unsafe { put_text_of(element, Held::warnings, |_| String::new(), (warnings, size)) }
}

/// Copies a text of an element, or one of what is wrong with that; returns the bytes of the whole
/// text.
///
/// # Safety
/// `place` is null or has room for `size` bytes.
unsafe fn put_text_of(
    element: Element,
    text: fn(&Held) -> String,
    otherwise: fn(&Trouble) -> String,
    (place, size): (*mut c_char, usize),
) -> usize {
    let work = || {
        let text = table::with(element, |held| text(held));
        text.unwrap_or_else(|status| otherwise(&Trouble::Status(status)))
    };
    let text = catch_unwind(work).unwrap_or_default();
    // SAFETY: that of this function.
    unsafe { pointers::put_text(&text, place, size) };
    text.len()
}

/// Does something with the contact of an element, and keeps what went wrong for its message.
fn on(element: Element, work: impl FnOnce(&mut Contact) -> Result<Status, Trouble>) -> Code {
    guarded(|| {
        let done = table::with(element, |held| {
            let work = AssertUnwindSafe(|| held.contact().and_then(work));
            let panicked = Trouble::Status(Status::Panicked);
            let outcome = catch_unwind(work).unwrap_or(Err(panicked));
            let status = status_of(&outcome);
            held.trouble = outcome.err();
            status
        });
        done.map_err(Trouble::Status)
    })
}

/// The code of some work, also where it panics.
fn guarded(work: impl FnOnce() -> Result<Status, Trouble>) -> Code {
    let outcome = catch_unwind(AssertUnwindSafe(work));
    let outcome = outcome.unwrap_or(Err(Trouble::Status(Status::Panicked)));
    status_of(&outcome) as Code
}

/// Puts an element into its place.
///
/// # Safety
/// The place is null or that of an element.
unsafe fn create(
    place: *mut Element,
    make: impl FnOnce() -> Result<Held, Trouble>,
) -> Result<Status, Trouble> {
    // SAFETY: that of this function.
    unsafe { pointers::put("element", place, 0)? };
    let held = make().unwrap_or_else(Held::failed);
    let status = held.status();
    let handle = table::insert(held).ok_or(Trouble::Status(Status::TooMany))?;
    // SAFETY: that of this function.
    unsafe { pointers::put("element", place, handle)? };
    Ok(status)
}

/// Evaluates rows.
///
/// # Safety
/// Arrays are null or have so many numbers, `statuses` is null or has room for so many codes.
unsafe fn evaluate(
    contact: &mut Contact,
    rows: usize,
    [inputs, states]: [Given; 2],
    wanted: [Wanted; 3],
    statuses: *mut Code,
) -> Result<Status, Trouble> {
    let [input_count, output_count, state_count] = contact.counts();
    let derivative_count = contact.derivatives();
    for (wanted, count) in wanted.iter().zip([output_count, state_count, derivative_count]) {
        wanted.check(rows.checked_mul(count))?;
    }
    // SAFETY: that of this function.
    let (inputs, states) = unsafe {
        (inputs.slice(rows.checked_mul(input_count))?, states.slice(rows.checked_mul(state_count))?)
    };
    let (mut worst, mut trouble) = (Status::Found, None);
    for row in 0..rows {
        let given = (&inputs[row * input_count..], &states[row * state_count..]);
        let given = (&given.0[..input_count], &given.1[..state_count]);
        let (outcome, found) = contact.evaluate(given, wanted[2].count > 0);
        let numbers = [&found.outputs, &found.rates, &found.derivatives];
        for (place, numbers) in wanted.iter().zip(numbers) {
            // SAFETY: `check` has passed.
            unsafe { place.write(row, numbers) };
        }
        let status = status_of(&outcome);
        if !statuses.is_null() {
            // SAFETY: that of this function.
            unsafe { pointers::put("statuses", statuses.add(row), status as Code)? };
        }
        if status.severity() > worst.severity() {
            (worst, trouble) = (status, outcome.err());
        }
    }
    trouble.map_or(Ok(worst), Err)
}

fn status_of(outcome: &Result<Status, Trouble>) -> Status {
    outcome.as_ref().map_or_else(Trouble::status, |status| *status)
}

/// Something of the inputs, outputs or states of an element.
fn signals<T>(element: Element, kind: i32, find: impl FnOnce(&[Signal]) -> T) -> Option<T> {
    let work = AssertUnwindSafe(|| {
        table::with(element, |held| {
            let contact = held.contact().ok()?;
            let element = &contact.element;
            match kind {
                SCHLUPF_INPUTS => Some(find(element.inputs())),
                SCHLUPF_OUTPUTS => Some(find(element.outputs())),
                SCHLUPF_STATES => Some(find(element.states())),
                _ => None,
            }
        })
    });
    catch_unwind(work).ok()?.ok()?
}

fn text_of(
    element: Element,
    kind: i32,
    index: usize,
    text: fn(&'static Texts) -> &'static CStr,
) -> *const c_char {
    let texts = signals(element, kind, |all| all.get(index).map(Texts::of)).flatten();
    texts.map_or(ptr::null(), |texts| text(texts).as_ptr())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A panic is a code, and the element is there afterwards.
    #[test]
    fn panics_are_codes() {
        let case = "solver.method = \"polach\"\nfriction.model = \"constant\"";
        let element = table::insert(Held::new(&Origin::Text(case, ""), &[])).unwrap();
        let panicked = Status::Panicked as Code;
        assert_eq!(guarded(|| panic!("for this test")), panicked);
        assert_eq!(on(element, |_| panic!("for this test")), panicked);
        let mut message = [0; 100];
        let size = unsafe { schlupf_element_message(element, message.as_mut_ptr(), message.len()) };
        assert_eq!(size, Status::Panicked.text().count_bytes());
        assert_eq!(schlupf_element_forget(element), Status::Found as Code);
        assert_eq!(schlupf_element_destroy(element), Status::Found as Code);
    }
}
