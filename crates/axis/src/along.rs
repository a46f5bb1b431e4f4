//! Quantities along the line of a mechanism.

use crate::fault::AxisReport;
use project::Fault;
use project::sections::{Along, Stated, StatedField, Turning};

/// Converts a quantity to the output.
pub(crate) fn turned<Q: Turning>(
    stated: &Stated<Along<Q>>,
    travel: Option<f64>,
    report: &mut AxisReport<'_>,
) -> Option<Q> {
    let along = stated.value()?;
    match (along.is_of_a_line, travel) {
        (false, _) => Some(Q::from_si(along.si)),
        (true, Some(travel)) => Some(Q::from_si(along.si / travel)),
        (true, None) => {
            report.fault(stated.span(), Fault::NoLine { path: stated.name().to_owned() }, None);
            None
        }
    }
}
