//! Notations of the times of a column.

use crate::clock::Clock;
use crate::columns::Heading;

/// Notation of the times.
#[derive(Default)]
pub(crate) enum TimeForm {
    #[default]
    Number,
    Clock(Clock),
    /// Millionths of a day.
    MillionthsOfDay,
    /// Hundreds of nanoseconds.
    HundredsOfNanoseconds,
    /// Whole seconds; nanoseconds stand in the first column after the values.
    Seconds,
}

/// Returns the form of a column of time that counts no usual unit: that of WinCC, millionths of a day since 1899-12-30 despite its
/// name, beside the clock time; `Time [FILETIME]`, hundreds of nanoseconds since 1601, as Windows counts.
pub(crate) fn form_of_integers(heading: &Heading, headings: &[Heading]) -> Option<TimeForm> {
    let is = |heading: &Heading, name: &str| heading.written.eq_ignore_ascii_case(name);
    let has_unit = |unit: &str| heading.named.unit.as_ref().is_some_and(|stated| stated.eq_ignore_ascii_case(unit));
    if is(heading, "Time_ms") && headings.iter().any(|other| is(other, "TimeString")) {
        return Some(TimeForm::MillionthsOfDay);
    }
    has_unit("FILETIME").then_some(TimeForm::HundredsOfNanoseconds)
}
