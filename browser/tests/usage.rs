//! The program without its arguments. Cargo builds a program with the tests of its package only where there is such a test,
//! and the step `browser` starts the one that the tests have built.

use std::process::Command;

#[test]
fn without_arguments_the_usage_is_reported_with_exit_code_2() {
    let output = Command::new(env!("CARGO_BIN_EXE_browser")).output();
    assert!(output.is_ok_and(|output| {
        output.status.code() == Some(2) && String::from_utf8_lossy(&output.stderr).starts_with("usage: browser PROGRAM")
    }));
}
