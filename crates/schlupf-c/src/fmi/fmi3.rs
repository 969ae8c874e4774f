//! The functions of FMI 3.0.

#![allow(non_snake_case, reason = "names of the standard")]

use std::ffi::{CStr, c_char, c_int, c_void};
use std::path::Path;
use std::ptr;

use super::component::{
    Component, Log, Logger, Status, array, array_mut, deserialize, free, free_state, instantiate,
    put, save, saved, serialize, text, with,
};
use super::instance::{Failure, Instance, State, Use, error};

type Callback = unsafe extern "C" fn(*mut c_void, Status, *const c_char, *const c_char);

/// Makes functions that get or set variables of a type that there are none of.
macro_rules! others {
    ($($get:ident $set:ident $type:ty)*) => {
        functions! {
            $($get(_, _references: *const u32, count: usize, _values: *mut $type, _number: usize) {
                no_others(count)
            }
            $set(_, _references: *const u32, count: usize, _values: *const $type, _number: usize) {
                no_others(count)
            })*
        }
    };
}

#[unsafe(no_mangle)]
extern "C" fn fmi3GetVersion() -> *const c_char {
    c"3.0".as_ptr()
}

/// Tells the tool.
fn logger(callback: Option<Callback>, environment: *mut c_void) -> Logger {
    let Some(callback) = callback else { return Box::new(|_, _, _| {}) };
    Box::new(move |status, category: &CStr, message: &CStr| unsafe {
        callback(environment, status, category.as_ptr(), message.as_ptr());
    })
}

unsafe fn instance(
    purpose: Use,
    [token, resources]: [*const c_char; 2],
    log: Log,
) -> *mut Component {
    let (token, resources) = unsafe { (text(token), text(resources)) };
    instantiate(log, || Instance::new(purpose, Path::new(&*resources), &token))
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi3InstantiateModelExchange(
    _name: *const c_char,
    token: *const c_char,
    resources: *const c_char,
    _visible: bool,
    is_logging: bool,
    environment: *mut c_void,
    callback: Option<Callback>,
) -> *mut Component {
    let log = Log { logger: logger(callback, environment), is_on: is_logging };
    unsafe { instance(Use::ModelExchange, [token, resources], log) }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi3InstantiateCoSimulation(
    _name: *const c_char,
    token: *const c_char,
    resources: *const c_char,
    _visible: bool,
    is_logging: bool,
    _event_mode_used: bool,
    _early_return_allowed: bool,
    _intermediate_variables: *const u32,
    _intermediate_count: usize,
    environment: *mut c_void,
    callback: Option<Callback>,
    _intermediate_update: *const c_void,
) -> *mut Component {
    let log = Log { logger: logger(callback, environment), is_on: is_logging };
    unsafe { instance(Use::CoSimulation, [token, resources], log) }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi3InstantiateScheduledExecution(
    _name: *const c_char,
    _token: *const c_char,
    _resources: *const c_char,
    _visible: bool,
    is_logging: bool,
    environment: *mut c_void,
    callback: Option<Callback>,
    _clock_update: *const c_void,
    _lock: *const c_void,
    _unlock: *const c_void,
) -> *mut Component {
    let log = Log { logger: logger(callback, environment), is_on: is_logging };
    log.tell(Status::Error, "there is no scheduled execution");
    ptr::null_mut()
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi3FreeInstance(component: *mut Component) {
    unsafe { free(component) };
}

functions! {
    fmi3SetDebugLogging(
        component, is_on: bool, _count: usize, _categories: *const *const c_char
    ) {
        component.log.is_on = is_on;
        Ok(())
    }

    fmi3EnterInitializationMode(
        component, _has_tolerance: bool, _tolerance: f64, start: f64, _has_stop: bool, _stop: f64
    ) {
        component.instance.set_time(start)
    }

    fmi3ExitInitializationMode(component) {
        component.instance.finish_initialization();
        Ok(())
    }

    fmi3EnterEventMode(_) {
        Ok(())
    }

    fmi3Terminate(_) {
        Ok(())
    }

    fmi3Reset(component) {
        component.instance.reset();
        Ok(())
    }

    fmi3GetFloat64(
        component, references: *const u32, count: usize, values: *mut f64, number: usize
    ) {
        same(count, number)?;
        let (references, values) = (array(references, count)?, array_mut(values, number)?);
        component.instance.get(references, values)
    }

    fmi3SetFloat64(
        component, references: *const u32, count: usize, values: *const f64, number: usize
    ) {
        same(count, number)?;
        let (references, values) = (array(references, count)?, array(values, number)?);
        component.instance.set(references, values)
    }

    fmi3GetBinary(
        _, _references: *const u32, count: usize, _sizes: *mut usize, _values: *mut *const u8,
        _number: usize
    ) {
        no_others(count)
    }

    fmi3SetBinary(
        _, _references: *const u32, count: usize, _sizes: *const usize, _values: *const *const u8,
        _number: usize
    ) {
        no_others(count)
    }

    fmi3GetClock(_, _references: *const u32, count: usize, _values: *mut bool) {
        no_others(count)
    }

    fmi3SetClock(_, _references: *const u32, count: usize, _values: *const bool) {
        no_others(count)
    }

    fmi3GetNumberOfVariableDependencies(_, _of: u32, _number: *mut usize) {
        no_arrays()
    }

    fmi3GetVariableDependencies(
        _, _of: u32, _elements: *mut usize, _independents: *mut u32, _their: *mut usize,
        _kinds: *mut c_int, _number: usize
    ) {
        no_arrays()
    }

    fmi3GetFMUState(component, place: *mut *mut State) {
        save(component, place)
    }

    fmi3SetFMUState(component, state: *const State) {
        component.instance.restore(saved(state)?)
    }

    fmi3FreeFMUState(_, place: *mut *mut State) {
        free_state(place);
        Ok(())
    }

    fmi3SerializedFMUStateSize(_, state: *const State, size: *mut usize) {
        put(size, saved(state)?.serialized().len());
        Ok(())
    }

    fmi3SerializeFMUState(_, state: *const State, bytes: *mut u8, size: usize) {
        serialize(state, bytes, size)
    }

    fmi3DeserializeFMUState(component, bytes: *const u8, size: usize, place: *mut *mut State) {
        deserialize(component, (bytes, size), place)
    }

    fmi3GetDirectionalDerivative(
        component,
        unknowns: *const u32, unknown_count: usize,
        knowns: *const u32, known_count: usize,
        seed: *const f64, seeds: usize,
        sensitivity: *mut f64, sensitivities: usize
    ) {
        same(known_count, seeds)?;
        same(unknown_count, sensitivities)?;
        let between = [array(unknowns, unknown_count)?, array(knowns, known_count)?];
        let (seed, found) = (array(seed, seeds)?, array_mut(sensitivity, sensitivities)?);
        component.instance.differentiate(between, seed, (found, false))
    }

    fmi3GetAdjointDerivative(
        component,
        unknowns: *const u32, unknown_count: usize,
        knowns: *const u32, known_count: usize,
        seed: *const f64, seeds: usize,
        sensitivity: *mut f64, sensitivities: usize
    ) {
        same(unknown_count, seeds)?;
        same(known_count, sensitivities)?;
        let between = [array(unknowns, unknown_count)?, array(knowns, known_count)?];
        let (seed, found) = (array(seed, seeds)?, array_mut(sensitivity, sensitivities)?);
        component.instance.differentiate(between, seed, (found, true))
    }

    fmi3EnterConfigurationMode(_) {
        error("there are no structural parameters")
    }

    fmi3ExitConfigurationMode(_) {
        error("there are no structural parameters")
    }

    fmi3GetIntervalDecimal(
        _, _clocks: *const u32, count: usize, _intervals: *mut f64, _qualifiers: *mut c_int
    ) {
        no_others(count)
    }

    fmi3GetIntervalFraction(
        _, _clocks: *const u32, count: usize, _counters: *mut u64, _resolutions: *mut u64,
        _qualifiers: *mut c_int
    ) {
        no_others(count)
    }

    fmi3GetShiftDecimal(_, _clocks: *const u32, count: usize, _shifts: *mut f64) {
        no_others(count)
    }

    fmi3GetShiftFraction(
        _, _clocks: *const u32, count: usize, _counters: *mut u64, _resolutions: *mut u64
    ) {
        no_others(count)
    }

    fmi3SetIntervalDecimal(_, _clocks: *const u32, count: usize, _intervals: *const f64) {
        no_others(count)
    }

    fmi3SetIntervalFraction(
        _, _clocks: *const u32, count: usize, _counters: *const u64, _resolutions: *const u64
    ) {
        no_others(count)
    }

    fmi3SetShiftDecimal(_, _clocks: *const u32, count: usize, _shifts: *const f64) {
        no_others(count)
    }

    fmi3SetShiftFraction(
        _, _clocks: *const u32, count: usize, _counters: *const u64, _resolutions: *const u64
    ) {
        no_others(count)
    }

    fmi3EvaluateDiscreteStates(_) {
        Ok(())
    }

    fmi3UpdateDiscreteStates(
        _, needs_update: *mut bool, terminate: *mut bool, nominals_changed: *mut bool,
        states_changed: *mut bool, has_next_event: *mut bool, next_event: *mut f64
    ) {
        for flag in [needs_update, terminate, nominals_changed, states_changed, has_next_event] {
            put(flag, false);
        }
        put(next_event, 0.0);
        Ok(())
    }

    fmi3EnterContinuousTimeMode(_) {
        Ok(())
    }

    fmi3CompletedIntegratorStep(
        _, _is_final: bool, enter_event_mode: *mut bool, terminate: *mut bool
    ) {
        put(enter_event_mode, false);
        put(terminate, false);
        Ok(())
    }

    fmi3SetTime(component, time: f64) {
        component.instance.set_time(time)
    }

    fmi3SetContinuousStates(component, states: *const f64, count: usize) {
        component.instance.set_states(array(states, count)?)
    }

    fmi3GetContinuousStateDerivatives(component, rates: *mut f64, count: usize) {
        component.instance.rates(array_mut(rates, count)?)
    }

    fmi3GetEventIndicators(_, _indicators: *mut f64, count: usize) {
        if count == 0 { Ok(()) } else { error("there are no event indicators") }
    }

    fmi3GetContinuousStates(component, states: *mut f64, count: usize) {
        component.instance.get_states(array_mut(states, count)?)
    }

    fmi3GetNominalsOfContinuousStates(component, nominals: *mut f64, count: usize) {
        component.instance.nominals(array_mut(nominals, count)?)
    }

    fmi3GetNumberOfEventIndicators(_, number: *mut usize) {
        put(number, 0);
        Ok(())
    }

    fmi3GetNumberOfContinuousStates(component, number: *mut usize) {
        put(number, component.instance.number_of_states());
        Ok(())
    }

    fmi3EnterStepMode(_) {
        error("there is no event mode in co-simulation")
    }

    fmi3GetOutputDerivatives(
        _, _references: *const u32, _count: usize, _orders: *const i32, _values: *mut f64,
        _number: usize
    ) {
        error("outputs have no derivatives by time")
    }

    fmi3DoStep(
        component, time: f64, duration: f64, _is_final: bool, needs_event: *mut bool,
        terminate: *mut bool, is_early: *mut bool, last_time: *mut f64
    ) {
        let done = component.instance.step(time, duration);
        for flag in [needs_event, terminate, is_early] {
            put(flag, false);
        }
        put(last_time, component.instance.time());
        done
    }

    fmi3ActivateModelPartition(_, _clock: u32, _time: f64) {
        error("there is no scheduled execution")
    }
}

others! {
    fmi3GetFloat32 fmi3SetFloat32 f32
    fmi3GetInt8 fmi3SetInt8 i8
    fmi3GetUInt8 fmi3SetUInt8 u8
    fmi3GetInt16 fmi3SetInt16 i16
    fmi3GetUInt16 fmi3SetUInt16 u16
    fmi3GetInt32 fmi3SetInt32 i32
    fmi3GetUInt32 fmi3SetUInt32 u32
    fmi3GetInt64 fmi3SetInt64 i64
    fmi3GetUInt64 fmi3SetUInt64 u64
    fmi3GetBoolean fmi3SetBoolean bool
    fmi3GetString fmi3SetString *const c_char
}

fn same(count: usize, number: usize) -> Result<(), Failure> {
    if count == number {
        return Ok(());
    }
    error(format!("there must be a value for each variable, but there are {number} for {count}"))
}

fn no_others(count: usize) -> Result<(), Failure> {
    if count == 0 { Ok(()) } else { error("all variables are of type Float64") }
}

fn no_arrays() -> Result<(), Failure> {
    error("dependencies are those of the description")
}

#[cfg(test)]
mod tests;
