//! The interface as a program calls it.

#![allow(unsafe_code, reason = "functions for C")]
#![allow(dead_code, reason = "each test file uses its part of it")]

use std::ffi::{CStr, CString, c_char};
use std::ptr;

use schlupf_c::Status;
use schlupf_c::interface::{
    Code, Element, SCHLUPF_INPUTS, SCHLUPF_OUTPUTS, SCHLUPF_STATES, schlupf_element_advance,
    schlupf_element_count, schlupf_element_destroy, schlupf_element_evaluate,
    schlupf_element_evaluate_rows, schlupf_element_from_text, schlupf_element_message,
    schlupf_element_start, schlupf_element_warnings,
};

pub const METHODS: [&str; 4] = ["kalker-linear", "shen-hedrick-elkins", "polach", "table"];

/// A case whose friction a fast method takes, with creepage and spin.
pub const CASE: &str = "[kinematics]\nspeed = \"20 m/s\"\ncreepage_x = 0.002\ncreepage_y = 0.001\n\
                        spin = \"0.2 1/m\"\n[friction]\nmodel = \"constant\"\ncoefficient = 0.4\n";

/// An element, destroyed with this.
pub struct Handle(pub Element);

/// What an evaluation gives.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    pub status: Code,
    pub outputs: Vec<f64>,
    pub rates: Vec<f64>,
    pub derivatives: Vec<f64>,
}

impl Found {
    pub fn bits(&self) -> Vec<u64> {
        let all = self.outputs.iter().chain(&self.rates).chain(&self.derivatives);
        all.map(|number| number.to_bits()).collect()
    }
}

impl Handle {
    pub fn new(text: &str, overrides: &[&str]) -> (Self, Code) {
        let text = CString::new(text).unwrap();
        let overrides: Vec<_> = overrides.iter().map(|set| CString::new(*set).unwrap()).collect();
        let pointers: Vec<*const c_char> = overrides.iter().map(|set| set.as_ptr()).collect();
        let mut element = 0;
        let (set, count) = (pointers.as_ptr(), pointers.len());
        let code = unsafe {
            schlupf_element_from_text(text.as_ptr(), ptr::null(), set, count, &raw mut element)
        };
        (Self(element), code)
    }

    pub fn of_method(method: &str) -> Self {
        let (element, code) = Self::new(CASE, &[&format!("solver.method={method}")]);
        assert_eq!(code, Status::Found as Code, "{}", element.message());
        element
    }

    pub fn counts(&self) -> [usize; 3] {
        [SCHLUPF_INPUTS, SCHLUPF_OUTPUTS, SCHLUPF_STATES]
            .map(|kind| schlupf_element_count(self.0, kind))
    }

    pub fn message(&self) -> String {
        self.text(schlupf_element_message)
    }

    pub fn warnings(&self) -> String {
        self.text(schlupf_element_warnings)
    }

    fn text(&self, of: unsafe extern "C" fn(Element, *mut c_char, usize) -> usize) -> String {
        let mut text = [1; 1000];
        let size = unsafe { of(self.0, text.as_mut_ptr(), text.len()) };
        assert_eq!(text[size.min(text.len() - 1)], 0);
        unsafe { CStr::from_ptr(text.as_ptr()) }.to_str().unwrap().to_owned()
    }

    pub fn start(&self) -> Vec<f64> {
        let mut inputs = vec![0.0; self.counts()[0]];
        let code = unsafe { schlupf_element_start(self.0, inputs.as_mut_ptr(), inputs.len()) };
        assert_eq!(code, Status::Found as Code);
        inputs
    }

    pub fn room(&self, rows: usize) -> Found {
        let [inputs, outputs, states] = self.counts().map(|count| rows * count);
        let derivatives = (outputs + states) * (inputs + states) / rows.max(1);
        let [outputs, rates, derivatives] = [outputs, states, derivatives].map(|n| vec![0.0; n]);
        Found { status: -1, outputs, rates, derivatives }
    }

    pub fn evaluate(&self, inputs: &[f64], states: &[f64], found: &mut Found) {
        let Found { outputs, rates, derivatives, .. } = found;
        found.status = unsafe {
            schlupf_element_evaluate(
                self.0,
                inputs.as_ptr(),
                inputs.len(),
                states.as_ptr(),
                states.len(),
                outputs.as_mut_ptr(),
                outputs.len(),
                rates.as_mut_ptr(),
                rates.len(),
                derivatives.as_mut_ptr(),
                derivatives.len(),
            )
        };
    }

    pub fn rows(&self, inputs: &[f64], states: &[f64], codes: &mut [Code]) -> Found {
        let mut found = self.room(codes.len());
        let Found { outputs, rates, derivatives, .. } = &mut found;
        found.status = unsafe {
            schlupf_element_evaluate_rows(
                self.0,
                codes.len(),
                inputs.as_ptr(),
                inputs.len(),
                states.as_ptr(),
                states.len(),
                outputs.as_mut_ptr(),
                outputs.len(),
                rates.as_mut_ptr(),
                rates.len(),
                derivatives.as_mut_ptr(),
                derivatives.len(),
                codes.as_mut_ptr(),
            )
        };
        found
    }

    pub fn advance(&self, inputs: &[f64], states: &mut [f64], duration: f64) -> Code {
        let (place, count) = (states.as_mut_ptr(), states.len());
        unsafe {
            schlupf_element_advance(self.0, inputs.as_ptr(), inputs.len(), place, count, duration)
        }
    }
}

impl Drop for Handle {
    fn drop(&mut self) {
        schlupf_element_destroy(self.0);
    }
}
