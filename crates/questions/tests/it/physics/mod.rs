//! Physics held over generated projects of every mechanism and over hand-made cases: what must not depend on law, window, order,
//! unit or language does not, and every limit is kept or broken independent of rounding.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing, reason = "a test may fail")]

mod at_rest;
mod invariance;
mod least_peak;
mod life;
mod limits;
mod requirements_apart;
mod rope;

use axis::AxisProject;
use questions::{CheckId, check};
use sizing::{Check, Checks};

fn read(text: &str) -> AxisProject {
    questions::read(text).unwrap_or_else(|faults| panic!("{faults:?}\n{text}"))
}

fn checks(project: &AxisProject, code: &str) -> Checks {
    let code = order_code::parse(code).unwrap().code;
    check(project, &code).unwrap().judgement.checks
}

fn of(project: &AxisProject, code: &str, id: CheckId) -> Check {
    checks(project, code).iter().find(|check| check.id == id).cloned().unwrap_or_else(|| panic!("{id:?} is not made"))
}
