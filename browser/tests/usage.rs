//! The program without its arguments. Cargo builds a program together with the tests of its package only if such a test
//! exists, and the step `browser` starts the program built with the tests.

use std::process::Command;

#[test]
fn without_arguments_the_usage_is_reported_with_exit_code_2() {
    let output = Command::new(env!("CARGO_BIN_EXE_browser")).output();
    assert!(output.is_ok_and(|output| {
        output.status.code() == Some(2) && String::from_utf8_lossy(&output.stderr).starts_with("usage: browser PROGRAM")
    }));
}
