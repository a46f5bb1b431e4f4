//! Functions called by the browser. It writes a message to the buffer that it requested, calls for the answer, and
//! reads it at the returned address.
//!
//! No address is dereferenced here. Only the fixed names are unsafe: two functions with one name in a program would be
//! confused with each other.
#![allow(unsafe_code, reason = "the names of three functions: docs/decisions/0017-engine-in-the-browser.md")]

use crate::PageEngine;
use std::cell::RefCell;

/// Message being written, and answer being read.
#[derive(Default)]
struct Counter {
    engine: PageEngine,
    message: Vec<u8>,
    answer: Vec<u8>,
}

thread_local! {
    static COUNTER: RefCell<Counter> = RefCell::default();
}

/// Returns a buffer for a message of `bytes` bytes.
#[unsafe(no_mangle)]
extern "C" fn antrieb_room(bytes: usize) -> *mut u8 {
    COUNTER.with_borrow_mut(|counter| {
        counter.message = vec![0; bytes];
        counter.message.as_mut_ptr()
    })
}

/// Answers the message and returns the length of the answer in bytes.
#[unsafe(no_mangle)]
extern "C" fn antrieb_answer() -> usize {
    COUNTER.with_borrow_mut(|counter| {
        let message = std::mem::take(&mut counter.message);
        counter.answer = counter.engine.answer(&message);
        counter.answer.len()
    })
}

/// Returns the address of the answer, valid until the next message.
#[unsafe(no_mangle)]
extern "C" fn antrieb_answered() -> *const u8 {
    COUNTER.with_borrow(|counter| counter.answer.as_ptr())
}
