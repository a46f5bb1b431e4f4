//! Lengths and speeds of the web of a winder, whose diameter changes with every turn.

use crate::fault::AxisReport;
use mechanism::MechanismKind;
use project::sections::{Fields, Segment, StatedField};
use project::{Fault, Hint};
use quantities::Measure;

/// Reports values along the web, with the turns of the roll that they are; returns `true` if there are some.
pub(crate) fn is_along_a_web(segments: &[Segment], kind: &MechanismKind, report: &mut AxisReport<'_>) -> bool {
    let MechanismKind::Winder(winder) = kind else { return false };
    let mut found = false;
    for segment in segments {
        for field in segment.fields().into_iter().filter(|field| field.is_of_a_line()) {
            let speed = segment.speed.value().filter(|_| field.name() == segment.speed.name());
            let hint = Hint::WebOfWinder {
                web_m_s: speed.map(|speed| speed.si),
                start_m: winder.start_diameter.si(),
                core_m: winder.core_diameter.si(),
            };
            report.fault(field.span(), Fault::NoLine { path: field.name().to_owned() }, Some(hint));
            found = true;
        }
    }
    found
}
