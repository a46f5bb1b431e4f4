//! The program `antrieb`.

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(antrieb::run(std::env::args_os().collect()))
}
