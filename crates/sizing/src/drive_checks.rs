//! Checks of the motor current against the ratings of the drive of the machine.
//!
//! All currents are rms values of a phase, as in the manual.

use crate::axis::Axis;
use crate::check::{Check, CheckId};
use crate::comparison::{Asking, Comparison, Edges, project};
use crate::currents::Currents;
use crate::list::{Case, Outcome};
use crate::workings;
use derivation::{Finding, Workings};
use numeric::{AT_THE_LIMIT, at_most};
use provenance::{Grade, Missing, Source};
use quantities::unit::{AMPERE, SECOND};
use quantities::{ElectricCurrent, Measure, Time, Unit};
use trace::Panel;

const MODEL: Source = Source::Model { name: "current" };

/// Checks the effective current of the settled cycle ≤ the continuous current of the drive.
///
/// √(∫I² dt / t_0) ≤ I_D
///
/// # Symbols
/// I motor current in the settled cycle \[A\], I_D continuous current of the drive \[A\], t_0 cycle time \[s\]
/// # Source
/// docs/theory/current.md
pub(crate) fn continuous(case: &Case<'_>, work: &mut Workings) -> Outcome {
    let (axis, key) = (case.axis, "drive.current_continuous");
    let limit = axis.asked.drive_current_continuous.ok_or(Missing { symbol: key })?;
    let currents = case.currents.map_err(|missing| *missing)?;
    let duration = axis.moments.duration.si();
    let value = (axis.trace.gram().square(currents.settled_weights()) / duration).sqrt();
    work.figure("t_0", &SECOND, duration, &workings::DEMAND, Grade::Computed);
    work.found("I_rms", &AMPERE, value, Finding::EffectiveCurrent, &MODEL, currents.grade);
    work.value("I_rms");
    work.asked_by("I_D", &AMPERE, limit.si(), key);
    Ok(against(CheckId::DriveCurrent, currents, (&AMPERE, value), (limit.si(), key), None))
}

/// Checks the largest current of the cycle, with the gear at the ambient temperature or settled, ≤ the peak current of the
/// drive.
///
/// max |I| ≤ I_D,max
///
/// # Symbols
/// I motor current \[A\], I_D,max peak current of the drive \[A\]
/// # Source
/// docs/theory/current.md
pub(crate) fn peak(case: &Case<'_>, work: &mut Workings) -> Outcome {
    let (axis, key) = (case.axis, "drive.current_peak");
    let limit = axis.asked.drive_current_peak.ok_or(Missing { symbol: key })?;
    let currents = case.currents.map_err(|missing| *missing)?;
    let node = currents.peak(axis);
    currents.explain_peak(&node, None, (axis, case.actuator), work);
    work.value("I_peak");
    work.asked_by("I_D_max", &AMPERE, limit.si(), key);
    let (value, at) = (currents.extreme(&node).abs(), Some(Time::from_si(node.time_s)));
    Ok(against(CheckId::DriveCurrentPeak, currents, (&AMPERE, value), (limit.si(), key), at))
}

/// Checks the longest time with a current above the continuous one ≤ the time for which the drive gives its peak current.
///
/// |I| > I_D for no longer than t_D at a stretch
///
/// # Symbols
/// I motor current in the settled cycle, which repeats \[A\], I_D continuous current of the drive \[A\], t_D time of its peak
/// current \[s\]
/// # Source
/// docs/theory/current.md
/// # Valid
/// Within its continuous effective value the drive is assumed to recover between two overloads: its own overload integral is
/// not modelled. An overload that begins and ends between two adjacent nodes of a curved panel is not counted.
pub(crate) fn peak_time(case: &Case<'_>, work: &mut Workings) -> Outcome {
    let (axis, key, of_level) = (case.axis, "drive.peak_time", "drive.current_continuous");
    let limit = axis.asked.drive_peak_time.ok_or(Missing { symbol: key })?;
    let level: ElectricCurrent = axis.asked.drive_current_continuous.ok_or(Missing { symbol: of_level })?;
    let currents = case.currents.map_err(|missing| *missing)?;
    let value = longest_above(axis, currents, level.si());
    work.stated("I_D", &AMPERE, level.si(), of_level);
    work.found("t_over", &SECOND, value, Finding::TimeAboveContinuous, &MODEL, currents.grade);
    work.value("t_over");
    work.asked_by("t_D", &SECOND, limit.si(), key);
    Ok(against(CheckId::DrivePeakTime, currents, (&SECOND, value), (limit.si(), key), None))
}

/// Compares a quantity of the current with a rating of the drive.
fn against(
    id: CheckId,
    currents: &Currents<'_>,
    (unit, value): (&'static Unit, f64),
    (limit, key): (f64, &'static str),
    at: Option<Time>,
) -> Check {
    Comparison {
        id,
        unit,
        value,
        value_source: MODEL,
        at,
        limit,
        limit_source: &project(key),
        grade: currents.grade,
        errata: &[],
        notes: currents.notes.clone(),
    }
    .between(Edges { limit, upper: limit, unit })
}

/// Consecutive parts of a cycle, and the times in them with a current above a level \[s\].
#[derive(Clone, Copy, Debug, PartialEq)]
struct Above {
    duration: f64,
    /// Time from the beginning.
    first: f64,
    /// Time to the end.
    last: f64,
    most: f64,
}

impl Above {
    const fn part(duration: f64, is_above: bool) -> Self {
        let above = if is_above { duration } else { 0.0 };
        Self { duration, first: above, last: above, most: above }
    }

    /// Returns `true` if the current is above the level all the time.
    fn all(&self) -> bool {
        self.first >= self.duration
    }

    fn then(self, next: Self) -> Self {
        Self {
            duration: self.duration + next.duration,
            first: if self.all() { self.duration + next.first } else { self.first },
            last: if next.all() { self.last + next.duration } else { next.last },
            most: self.most.max(next.most).max(self.last + next.first),
        }
    }

    /// Repeats the parts `times` times.
    fn repeated(self, times: f64) -> Self {
        let duration = times * self.duration;
        if self.all() {
            Self::part(duration, true)
        } else if times > 1.0 {
            Self { duration, most: self.most.max(self.last + self.first), ..self }
        } else {
            self
        }
    }
}

/// Returns the longest time for which the current of the settled cycle is above a level \[s\]; the cycle repeats.
fn longest_above(axis: &Axis, currents: &Currents<'_>, level: f64) -> f64 {
    let mut cycle = Above::part(0.0, false);
    for block in axis.trace.blocks() {
        let (low, high) = block.extent.range(currents.settled_weights());
        let mut once = Above::part(block.duration_s / block.times, false);
        if !at_most(high.max(-low), level) {
            once = Above::part(0.0, false);
            axis.trace.panels(block, &mut |panel| once = once.then(above_within(&panel, currents, level)));
        }
        cycle = cycle.then(once.repeated(block.times));
    }
    if cycle.all() { cycle.duration } else { cycle.most.max(cycle.last + cycle.first) }
}

/// Returns the times above the level in a panel: between adjacent nodes, and where the current passes zero or the
/// level.
fn above_within(panel: &Panel<'_>, currents: &Currents<'_>, level: f64) -> Above {
    let [start, ..] = panel.nodes else { return Above::part(0.0, false) };
    let current = |share: f64| currents.at(&panel.at(share));
    // A current that equals the level up to rounding is not above it, as in every comparison with a limit.
    let over = |current: f64| {
        let over = current.abs() - level;
        if over.abs() <= AT_THE_LIMIT * level { 0.0 } else { over }
    };
    let mut found = Above::part(0.0, false);
    let mut piece = |(from, a): (f64, f64), (to, b): (f64, f64)| {
        let (over_a, over_b) = (over(a), over(b));
        let mut add = |from: f64, to: f64, is_above| {
            found = found.then(Above::part((to - from) * panel.duration_s, is_above));
        };
        if over_a * over_b < 0.0 {
            let at = numeric::root(|share| current(share).abs() - level, (from, over_a), (to, over_b), CLOSE);
            add(from, at, over_a > 0.0);
            add(at, to, over_b > 0.0);
        } else {
            add(from, to, over_a > 0.0 || over_b > 0.0);
        }
    };
    for (a, b) in panel.nodes.iter().zip(panel.nodes.iter().skip(1)) {
        let [from, to] = [a, b].map(|node| (node.time_s - start.time_s) / panel.duration_s);
        let [first, last] = [a, b].map(|node| currents.at(node));
        if first * last < 0.0 {
            let zero = numeric::root(current, (from, first), (to, last), CLOSE);
            piece((from, first), (zero, 0.0));
            piece((zero, 0.0), (to, last));
        } else {
            piece((from, first), (to, last));
        }
    }
    found
}

/// Tolerance of the search for a zero, as a share of a panel.
const CLOSE: f64 = 1e-12;

#[cfg(test)]
#[path = "drive_tests.rs"]
mod tests;
