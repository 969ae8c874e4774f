//! What a caller points to; all that is not safe is here.

#![allow(unsafe_code, reason = "numbers and texts of a caller are behind pointers")]

use std::ffi::{CStr, c_char};
use std::ptr;
use std::slice;

use crate::trouble::Trouble;

/// Numbers that a caller gives.
#[derive(Debug, Clone, Copy)]
pub struct Given {
    pub name: &'static str,
    pub numbers: *const f64,
    pub count: usize,
}

impl Given {
    /// So many numbers.
    ///
    /// # Safety
    /// Behind a pointer that is neither null nor unaligned are `count` numbers, which nobody
    /// changes while the slice is used.
    pub unsafe fn slice<'a>(self, wanted: Option<usize>) -> Result<&'a [f64], Trouble> {
        let Self { name, numbers, count } = self;
        match checked(name, numbers, count, wanted)? {
            0 => Ok(&[]),
            // SAFETY: the caller says so; `checked` has seen the pointer.
            _ => Ok(unsafe { slice::from_raw_parts(numbers, count) }),
        }
    }
}

/// Room for numbers that a caller wants.
#[derive(Debug, Clone, Copy)]
pub struct Wanted {
    pub name: &'static str,
    pub numbers: *mut f64,
    pub count: usize,
}

impl Wanted {
    /// Fails unless there is room for so many numbers, or none at all: then they are not wanted.
    pub fn check(self, wanted: Option<usize>) -> Result<(), Trouble> {
        let Self { name, numbers, count } = self;
        let wanted = if count == 0 { Some(0) } else { wanted };
        checked(name, numbers.cast_const(), count, wanted).map(|_| ())
    }

    /// The same numbers, to be changed in place.
    ///
    /// # Safety
    /// Behind a pointer that is neither null nor unaligned are `count` numbers, which nobody
    /// else uses as long as the slice.
    pub unsafe fn slice<'a>(self, wanted: usize) -> Result<&'a mut [f64], Trouble> {
        let Self { name, numbers, count } = self;
        match checked(name, numbers.cast_const(), count, Some(wanted))? {
            0 => Ok(&mut []),
            // SAFETY: the caller says so; `checked` has seen the pointer.
            _ => Ok(unsafe { slice::from_raw_parts_mut(numbers, count) }),
        }
    }

    /// Writes the numbers of a row, if they are wanted.
    ///
    /// # Safety
    /// [`Self::check`] has passed for all rows, and there is room for `count` numbers.
    pub unsafe fn write(self, row: usize, numbers: &[f64]) {
        let start = row * numbers.len();
        if start + numbers.len() <= self.count {
            // SAFETY: within the room of the caller, which is none of the library's own numbers.
            unsafe {
                ptr::copy_nonoverlapping(numbers.as_ptr(), self.numbers.add(start), numbers.len());
            }
        }
    }
}

/// The count, if it is what it should be and the pointer is one.
fn checked(
    array: &'static str,
    numbers: *const f64,
    given: usize,
    wanted: Option<usize>,
) -> Result<usize, Trouble> {
    let wanted = wanted.unwrap_or(usize::MAX);
    if given != wanted || given > isize::MAX as usize / size_of::<f64>() {
        return Err(Trouble::Size { array, given, wanted });
    }
    if given > 0 && (numbers.is_null() || !numbers.is_aligned()) {
        return Err(Trouble::Pointer { name: array });
    }
    Ok(given)
}

/// A text that ends with a null byte.
///
/// # Safety
/// A pointer that is not null points to one, which nobody changes while it is used.
pub unsafe fn text<'a>(name: &'static str, pointer: *const c_char) -> Result<&'a str, Trouble> {
    if pointer.is_null() {
        return Err(Trouble::Pointer { name });
    }
    // SAFETY: the caller says so.
    let text = unsafe { CStr::from_ptr(pointer) };
    text.to_str().map_err(|_| Trouble::Text { name })
}

/// Texts that end with a null byte.
///
/// # Safety
/// A pointer that is not null points to `count` texts, which nobody changes while they are read.
pub unsafe fn texts(
    name: &'static str,
    pointers: *const *const c_char,
    count: usize,
) -> Result<Vec<String>, Trouble> {
    if count > 0 && (pointers.is_null() || !pointers.is_aligned()) {
        return Err(Trouble::Pointer { name });
    }
    // SAFETY: the caller says so, for the array and for each text.
    let one = |k| unsafe { text(name, *pointers.add(k)) }.map(str::to_owned);
    (0..count).map(one).collect()
}

/// Writes a value to its place.
///
/// # Safety
/// A pointer that is neither null nor unaligned points to room for one.
pub unsafe fn put<T>(name: &'static str, place: *mut T, value: T) -> Result<(), Trouble> {
    if place.is_null() || !place.is_aligned() {
        return Err(Trouble::Pointer { name });
    }
    // SAFETY: the caller says so.
    unsafe { place.write(value) };
    Ok(())
}

/// Copies as much of a text as there is room for, with a null byte at its end.
///
/// # Safety
/// A pointer that is not null points to room for `size` bytes.
pub unsafe fn put_text(text: &str, place: *mut c_char, size: usize) {
    let Some(most) = size.checked_sub(1).filter(|_| !place.is_null()) else { return };
    let count = (0..=most.min(text.len())).rev().find(|end| text.is_char_boundary(*end));
    let count = count.unwrap_or(0);
    // SAFETY: `count` bytes and a null byte are no more than `size`.
    unsafe {
        ptr::copy_nonoverlapping(text.as_ptr().cast(), place, count);
        place.add(count).write(0);
    }
}
