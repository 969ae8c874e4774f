//! A fast force through the C interface allocates nothing.

#![allow(unsafe_code, reason = "the interface of allocators is unsafe")]

mod common;

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

use common::{Handle, METHODS};

/// The system's allocator, counting what each thread asks of it: that of the harness goes on beside
/// the test.
struct Counting;

thread_local! {
    static COUNT: Cell<usize> = const { Cell::new(0) };
}

fn asked() -> usize {
    COUNT.with(Cell::get)
}

// SAFETY: whatever is asked for goes to the system's allocator unchanged. The counter has neither
// an initialiser nor a destructor that could allocate.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        COUNT.with(|count| count.set(count.get() + 1));
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Loads that vary, no contact, and numbers that are not finite; with states that advance.
#[test]
fn fast_forces_allocate_nothing() {
    for method in METHODS {
        let element = Handle::of_method(method);
        let (mut inputs, mut states) = (element.start(), [0.0; 3]);
        let mut found = element.room(1);
        let load = inputs[4];
        let before = asked();
        for k in 0..100 {
            inputs[4] = load * (f64::from(k) / 10.0).cos();
            element.evaluate(&inputs, &states, &mut found);
            element.advance(&inputs, &mut states, 1e-3);
        }
        inputs[4] = f64::NAN;
        element.evaluate(&inputs, &states, &mut found);
        assert_eq!(asked(), before, "{method}");
    }
}
