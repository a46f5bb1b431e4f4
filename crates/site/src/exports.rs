//! Functions called by the browser. It writes a message to the buffer that it requested, calls for the answer, and reads it
//! at the returned address.
//!
//! Nothing here reads through an address; only the names must be kept as they stand, and that alone is what the language
//! counts as unsafe: two functions of one name in a program would be mistaken for each other.
#![allow(unsafe_code, reason = "the names of three functions: docs/decisions/0017-engine-in-the-browser.md")]

use crate::Desk;
use std::cell::RefCell;

/// The message that is being written, and the answer that is being read.
#[derive(Default)]
struct Counter {
    desk: Desk,
    message: Vec<u8>,
    answer: Vec<u8>,
}

thread_local! {
    static COUNTER: RefCell<Counter> = RefCell::default();
}

/// Room for a message of so many bytes.
#[unsafe(no_mangle)]
extern "C" fn antrieb_room(bytes: usize) -> *mut u8 {
    COUNTER.with_borrow_mut(|counter| {
        counter.message = vec![0; bytes];
        counter.message.as_mut_ptr()
    })
}

/// Answers the message; gives the length of the answer in bytes.
#[unsafe(no_mangle)]
extern "C" fn antrieb_answer() -> usize {
    COUNTER.with_borrow_mut(|counter| {
        let message = std::mem::take(&mut counter.message);
        counter.answer = counter.desk.answer(&message);
        counter.answer.len()
    })
}

/// Where the answer stands, until the next message comes.
#[unsafe(no_mangle)]
extern "C" fn antrieb_answered() -> *const u8 {
    COUNTER.with_borrow(|counter| counter.answer.as_ptr())
}
