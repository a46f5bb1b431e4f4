//! The program that `cargo run` builds.

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(antrieb_quick::run(std::env::args_os().collect()))
}
