//! What tools hold: an instance with its log. No panic crosses its boundary.

use std::ffi::{CStr, CString, c_char};
use std::panic::{AssertUnwindSafe, catch_unwind};

use crate::held::line;

use super::instance::{Failure, Instance, State, error};

/// What becomes of a call, with the numbers of both standards.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(C)]
pub enum Status {
    Ok = 0,
    Warning = 1,
    Discard = 2,
    Error = 3,
}

impl Status {
    fn category(self) -> &'static CStr {
        match self {
            Self::Ok => c"logAll",
            Self::Warning => c"logStatusWarning",
            Self::Discard => c"logStatusDiscard",
            Self::Error => c"logStatusError",
        }
    }
}

/// Tells the tool: a status, its category, a message.
pub type Logger = Box<dyn Fn(Status, &CStr, &CStr)>;

/// Where messages go.
pub struct Log {
    pub logger: Logger,
    /// Whether what is no error is told, too.
    pub is_on: bool,
}

impl Log {
    pub fn tell(&self, status: Status, message: &str) {
        if self.is_on || status == Status::Error {
            let message = CString::new(message.replace('\0', " ")).unwrap_or_default();
            (self.logger)(status, status.category(), &message);
        }
    }
}

/// An instance with its log.
pub struct Component {
    pub instance: Instance,
    pub log: Log,
}

/// A new component on the heap; null, with a message, where there is none.
pub fn instantiate(log: Log, make: impl FnOnce() -> Result<Instance, String>) -> *mut Component {
    let made = catch_unwind(AssertUnwindSafe(make));
    match made.unwrap_or_else(|_| Err(INTERNAL.to_owned())) {
        Ok(instance) => {
            for warning in instance.warnings() {
                log.tell(Status::Warning, &line(warning));
            }
            Box::into_raw(Box::new(Component { instance, log }))
        }
        Err(message) => {
            log.tell(Status::Error, &message);
            std::ptr::null_mut()
        }
    }
}

const NO_ARRAY: &str = "an array is null or not aligned";

const INTERNAL: &str = "internal error of schlupf";

/// Does something with a component.
///
/// # Safety
/// The component is null or one that was instantiated and is used by nobody else.
pub unsafe fn with(
    component: *mut Component,
    act: impl FnOnce(&mut Component) -> Result<(), Failure>,
) -> Status {
    let Some(component) = (unsafe { component.as_mut() }) else { return Status::Error };
    let done = catch_unwind(AssertUnwindSafe(|| act(component)));
    let (status, message) = match done.unwrap_or_else(|_| error(INTERNAL)) {
        Ok(()) => return Status::Ok,
        Err(Failure::Discard(message)) => (Status::Discard, message),
        Err(Failure::Error(message)) => (Status::Error, message),
    };
    component.log.tell(status, &message);
    status
}

/// Makes a function of the standard of what is done with the component. All of them trust the
/// pointers of the tool, as the standard has it.
macro_rules! functions {
    ($($name:ident($component:pat $(, $argument:ident: $type:ty)*) $body:block)*) => {
        $(#[unsafe(no_mangle)]
        unsafe extern "C" fn $name(component: *mut Component $(, $argument: $type)*) -> Status {
            unsafe { with(component, |$component: &mut Component| $body) }
        })*
    };
}

/// Frees a component.
///
/// # Safety
/// As [`with`]; it is not used afterwards.
pub unsafe fn free(component: *mut Component) {
    if !component.is_null() {
        drop(unsafe { Box::from_raw(component) });
    }
}

/// An array of the caller.
///
/// # Safety
/// It has so many elements, or the pointer is null.
pub unsafe fn array<'a, T>(first: *const T, count: usize) -> Result<&'a [T], Failure> {
    match count {
        0 => Ok(&[]),
        _ if first.is_null() || !first.is_aligned() => error(NO_ARRAY),
        _ => Ok(unsafe { std::slice::from_raw_parts(first, count) }),
    }
}

/// An array of the caller for results.
///
/// # Safety
/// It has so many elements, or the pointer is null.
pub unsafe fn array_mut<'a, T>(first: *mut T, count: usize) -> Result<&'a mut [T], Failure> {
    match count {
        0 => Ok(&mut []),
        _ if first.is_null() || !first.is_aligned() => error(NO_ARRAY),
        _ => Ok(unsafe { std::slice::from_raw_parts_mut(first, count) }),
    }
}

/// Writes a result, unless nobody wants it.
///
/// # Safety
/// The pointer is null or one to a value.
pub unsafe fn put<T>(place: *mut T, value: T) {
    if let Some(place) = unsafe { place.as_mut() } {
        *place = value;
    }
}

/// A text of the caller; empty where it is null.
///
/// # Safety
/// It ends with a zero, or the pointer is null.
pub unsafe fn text<'a>(text: *const c_char) -> std::borrow::Cow<'a, str> {
    if text.is_null() { "".into() } else { unsafe { CStr::from_ptr(text) }.to_string_lossy() }
}

/// Saves the state, in place of another one if there is one.
///
/// # Safety
/// The pointer is null or one to a state that was saved, or to null.
pub unsafe fn save(component: &mut Component, place: *mut *mut State) -> Result<(), Failure> {
    let Some(place) = (unsafe { place.as_mut() }) else { return error("the state is null") };
    let state = component.instance.save();
    match unsafe { place.as_mut() } {
        Some(old) => *old = state,
        None => *place = Box::into_raw(Box::new(state)),
    }
    Ok(())
}

/// A saved state.
///
/// # Safety
/// The pointer is null or one to a state that was saved.
pub unsafe fn saved<'a>(state: *const State) -> Result<&'a State, Failure> {
    unsafe { state.as_ref() }.map_or_else(|| error("the state is null"), Ok)
}

/// Frees a saved state.
///
/// # Safety
/// The pointer is null or one to a state that was saved, or to null.
pub unsafe fn free_state(place: *mut *mut State) {
    if let Some(place) = unsafe { place.as_mut() }
        && !place.is_null()
    {
        drop(unsafe { Box::from_raw(*place) });
        *place = std::ptr::null_mut();
    }
}

/// Puts the bytes of a saved state into an array.
///
/// # Safety
/// As [`saved`] and [`array_mut`].
pub unsafe fn serialize(state: *const State, bytes: *mut u8, size: usize) -> Result<(), Failure> {
    let own = unsafe { saved(state) }?.serialized();
    match unsafe { array_mut(bytes, size) }?.get_mut(..own.len()) {
        Some(place) => place.copy_from_slice(&own),
        None => return error(format!("a state has {} bytes, but there are {size}", own.len())),
    }
    Ok(())
}

/// Makes a state from its bytes.
///
/// # Safety
/// As [`array`]; the place is null or one to a pointer, which is overwritten.
pub unsafe fn deserialize(
    component: &Component,
    (bytes, size): (*const u8, usize),
    place: *mut *mut State,
) -> Result<(), Failure> {
    let Some(place) = (unsafe { place.as_mut() }) else { return error("the state is null") };
    let state = component.instance.deserialized(unsafe { array(bytes, size) }?)?;
    *place = Box::into_raw(Box::new(state));
    Ok(())
}
