//! The functions of FMI 2.0.3.

#![allow(non_snake_case, reason = "names of the standard")]

use std::ffi::{CStr, CString, c_char, c_int, c_void};
use std::path::PathBuf;
use std::ptr;

use super::component::{
    Component, Log, Logger, Status, array, array_mut, deserialize, free, free_state, instantiate,
    put, save, saved, serialize, text, with,
};
use super::instance::{Failure, Instance, State, Use, error};

type Callback =
    unsafe extern "C" fn(*mut c_void, *const c_char, Status, *const c_char, *const c_char, ...);

/// What the tool offers; its memory is not used.
#[repr(C)]
struct Callbacks {
    logger: Option<Callback>,
    allocate_memory: *const c_void,
    free_memory: *const c_void,
    step_finished: *const c_void,
    environment: *mut c_void,
}

#[repr(C)]
struct EventInfo {
    new_discrete_states_needed: c_int,
    terminate_simulation: c_int,
    nominals_changed: c_int,
    states_changed: c_int,
    next_event_time_defined: c_int,
    next_event_time: f64,
}

#[unsafe(no_mangle)]
extern "C" fn fmi2GetTypesPlatform() -> *const c_char {
    c"default".as_ptr()
}

#[unsafe(no_mangle)]
extern "C" fn fmi2GetVersion() -> *const c_char {
    c"2.0".as_ptr()
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi2Instantiate(
    name: *const c_char,
    purpose: c_int,
    token: *const c_char,
    resources: *const c_char,
    callbacks: *const Callbacks,
    _visible: c_int,
    is_logging: c_int,
) -> *mut Component {
    let (name, token, resources) = unsafe { (text(name), text(token), text(resources)) };
    let logger = unsafe { logger(&name, callbacks) };
    instantiate(Log { logger, is_on: is_logging != 0 }, || {
        let purpose = if purpose == 0 { Use::ModelExchange } else { Use::CoSimulation };
        Instance::new(purpose, &path(&resources)?, &token)
    })
}

/// Tells the tool, whose function takes a format of `printf`.
unsafe fn logger(name: &str, callbacks: *const Callbacks) -> Logger {
    let name = CString::new(name).unwrap_or_default();
    let callbacks = unsafe { callbacks.as_ref() };
    let Some((callback, environment)) = callbacks.and_then(|of| Some((of.logger?, of.environment)))
    else {
        return Box::new(|_, _, _| {});
    };
    Box::new(move |status, category: &CStr, message: &CStr| {
        let format = CString::new(message.to_string_lossy().replace('%', "%%")).unwrap_or_default();
        unsafe {
            callback(environment, name.as_ptr(), status, category.as_ptr(), format.as_ptr());
        }
    })
}

/// The path that a URI of the scheme `file` names.
fn path(uri: &str) -> Result<PathBuf, String> {
    let refused = || format!("the resources must be at a URI file:///…, but are at {uri:?}");
    let rest = uri.strip_prefix("file:").ok_or_else(refused)?;
    // Without an authority, or with that of this machine.
    let rest =
        rest.strip_prefix("//").map_or(rest, |rest| rest.strip_prefix("localhost").unwrap_or(rest));
    let mut bytes = Vec::new();
    let mut left = rest.as_bytes();
    while let [first, behind @ ..] = left {
        let code = behind.get(..2).and_then(|code| std::str::from_utf8(code).ok());
        let code = code.and_then(|code| u8::from_str_radix(code, 16).ok());
        let code = code.filter(|_| *first == b'%');
        bytes.push(code.unwrap_or(*first));
        left = if code.is_some() { &behind[2..] } else { behind };
    }
    let text = String::from_utf8(bytes).map_err(|_| refused())?;
    // Before the letter of a drive.
    let path = text.strip_prefix('/').filter(|rest| rest.as_bytes().get(1) == Some(&b':'));
    Ok(PathBuf::from(path.unwrap_or(&text)))
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi2FreeInstance(component: *mut Component) {
    unsafe { free(component) };
}

functions! {
    fmi2SetDebugLogging(
        component, is_on: c_int, _count: usize, _categories: *const *const c_char
    ) {
        component.log.is_on = is_on != 0;
        Ok(())
    }

    fmi2SetupExperiment(
        component, _has_tolerance: c_int, _tolerance: f64, start: f64, _has_stop: c_int, _stop: f64
    ) {
        component.instance.set_time(start)
    }

    fmi2EnterInitializationMode(_) {
        Ok(())
    }

    fmi2ExitInitializationMode(component) {
        component.instance.finish_initialization();
        Ok(())
    }

    fmi2Terminate(_) {
        Ok(())
    }

    fmi2Reset(component) {
        component.instance.reset();
        Ok(())
    }

    fmi2GetReal(component, references: *const u32, count: usize, values: *mut f64) {
        let (references, values) = (array(references, count)?, array_mut(values, count)?);
        component.instance.get(references, values)
    }

    fmi2SetReal(component, references: *const u32, count: usize, values: *const f64) {
        let (references, values) = (array(references, count)?, array(values, count)?);
        component.instance.set(references, values)
    }

    fmi2GetInteger(_, _references: *const u32, count: usize, _values: *mut c_int) {
        no_others(count)
    }

    fmi2SetInteger(_, _references: *const u32, count: usize, _values: *const c_int) {
        no_others(count)
    }

    fmi2GetBoolean(_, _references: *const u32, count: usize, _values: *mut c_int) {
        no_others(count)
    }

    fmi2SetBoolean(_, _references: *const u32, count: usize, _values: *const c_int) {
        no_others(count)
    }

    fmi2GetString(_, _references: *const u32, count: usize, _values: *mut *const c_char) {
        no_others(count)
    }

    fmi2SetString(_, _references: *const u32, count: usize, _values: *const *const c_char) {
        no_others(count)
    }

    fmi2GetFMUstate(component, place: *mut *mut State) {
        save(component, place)
    }

    fmi2SetFMUstate(component, state: *const State) {
        component.instance.restore(saved(state)?)
    }

    fmi2FreeFMUstate(_, place: *mut *mut State) {
        free_state(place);
        Ok(())
    }

    fmi2SerializedFMUstateSize(_, state: *const State, size: *mut usize) {
        put(size, saved(state)?.serialized().len());
        Ok(())
    }

    fmi2SerializeFMUstate(_, state: *const State, bytes: *mut u8, size: usize) {
        serialize(state, bytes, size)
    }

    fmi2DeSerializeFMUstate(component, bytes: *const u8, size: usize, place: *mut *mut State) {
        deserialize(component, (bytes, size), place)
    }

    fmi2GetDirectionalDerivative(
        component,
        unknowns: *const u32, unknown_count: usize,
        knowns: *const u32, known_count: usize,
        seed: *const f64,
        sensitivity: *mut f64
    ) {
        let between = [array(unknowns, unknown_count)?, array(knowns, known_count)?];
        let seed = array(seed, known_count)?;
        let sensitivity = array_mut(sensitivity, unknown_count)?;
        component.instance.differentiate(between, seed, (sensitivity, false))
    }

    fmi2EnterEventMode(_) {
        Ok(())
    }

    fmi2NewDiscreteStates(_, info: *mut EventInfo) {
        let nothing = EventInfo {
            new_discrete_states_needed: 0,
            terminate_simulation: 0,
            nominals_changed: 0,
            states_changed: 0,
            next_event_time_defined: 0,
            next_event_time: 0.0,
        };
        put(info, nothing);
        Ok(())
    }

    fmi2EnterContinuousTimeMode(_) {
        Ok(())
    }

    fmi2CompletedIntegratorStep(
        _, _is_final: c_int, enter_event_mode: *mut c_int, terminate: *mut c_int
    ) {
        put(enter_event_mode, 0);
        put(terminate, 0);
        Ok(())
    }

    fmi2SetTime(component, time: f64) {
        component.instance.set_time(time)
    }

    fmi2SetContinuousStates(component, states: *const f64, count: usize) {
        component.instance.set_states(array(states, count)?)
    }

    fmi2GetDerivatives(component, rates: *mut f64, count: usize) {
        component.instance.rates(array_mut(rates, count)?)
    }

    fmi2GetEventIndicators(_, _indicators: *mut f64, count: usize) {
        if count == 0 { Ok(()) } else { error("there are no event indicators") }
    }

    fmi2GetContinuousStates(component, states: *mut f64, count: usize) {
        component.instance.get_states(array_mut(states, count)?)
    }

    fmi2GetNominalsOfContinuousStates(component, nominals: *mut f64, count: usize) {
        component.instance.nominals(array_mut(nominals, count)?)
    }

    fmi2SetRealInputDerivatives(
        _, _references: *const u32, _count: usize, _orders: *const c_int, _values: *const f64
    ) {
        error("inputs are constant in a step")
    }

    fmi2GetRealOutputDerivatives(
        _, _references: *const u32, _count: usize, _orders: *const c_int, _values: *mut f64
    ) {
        error("outputs have no derivatives by time")
    }

    fmi2DoStep(component, time: f64, duration: f64, _is_final: c_int) {
        component.instance.step(time, duration)
    }

    fmi2CancelStep(_) {
        error("no step is pending")
    }

    fmi2GetStatus(_, _kind: c_int, _value: *mut Status) {
        never_pending()
    }

    fmi2GetRealStatus(component, kind: c_int, value: *mut f64) {
        // fmi2LastSuccessfulTime.
        if kind != 2 {
            return never_pending();
        }
        put(value, component.instance.time());
        Ok(())
    }

    fmi2GetIntegerStatus(_, _kind: c_int, _value: *mut c_int) {
        never_pending()
    }

    fmi2GetBooleanStatus(_, kind: c_int, value: *mut c_int) {
        // fmi2Terminated.
        if kind != 3 {
            return never_pending();
        }
        put(value, 0);
        Ok(())
    }

    fmi2GetStringStatus(_, _kind: c_int, value: *mut *const c_char) {
        put(value, ptr::null());
        never_pending()
    }
}

fn no_others(count: usize) -> Result<(), Failure> {
    if count == 0 { Ok(()) } else { error("all variables are of type Real") }
}

fn never_pending() -> Result<(), Failure> {
    Err(Failure::Discard("steps end before they return".to_owned()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn resources_are_at_the_path_of_a_uri() {
        let found = |uri| path(uri).unwrap().to_str().unwrap().to_owned();
        assert_eq!(found("file:///tmp/a%20b/%C3%A9/resources"), "/tmp/a b/é/resources");
        assert_eq!(found("file:/tmp/100%/x%2"), "/tmp/100%/x%2");
        assert_eq!(found("file://localhost/tmp"), "/tmp");
        assert_eq!(found("file:///C:/tmp"), "C:/tmp");
        assert!(path("http://x/y").is_err() && path("").is_err());
    }
}
