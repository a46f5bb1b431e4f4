//! Assembly of a recording from consecutive samples.

use crate::GAP_FACTOR;
use crate::collected::FaultCollector;
use crate::columns::check_course;
use crate::faults::{Fault, FileRow, Remedy, Stamp, excerpt};
use crate::lacking::Lacking;
use crate::layout::{Layout, Role};
use crate::limits::{MAGNITUDE_MAX, SAMPLES_MAX, SAMPLES_MIN, STEP_MIN_S};
use crate::memory::Memory;
use crate::modulo::{first_jump, undecided_step, unwrap_revolutions};
use crate::number::{Bad, Tick, short};
use crate::order::Order;
use crate::series::{Along, ColumnRead, RecordedCourse, Recording, Series};
use quantities::{Angle, Measure, Time, Unit};
use std::cmp::Ordering;
use std::f64::consts::TAU;
use std::sync::Arc;

/// Rounding error of a difference of time stamps, relative to the largest stamp.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

/// Share by which an interval may exceed the longest permitted one.
const GAP_ROUNDING: f64 = 1e-9;

/// Treatment of a sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SampleUse {
    /// The sample is kept; its values follow.
    Kept,
    /// It lies outside the window, or its time is faulty.
    Dropped,
    /// No further sample can be kept.
    Full,
}

/// Values kept of one column.
struct Channel {
    role: Role,
    unit: &'static Unit,
    values: Vec<f64>,
}

/// Collector of samples in the order of the file.
pub(crate) struct Gather<'m> {
    /// Memory of all recordings of a project, and the number of samples for which it is reserved.
    memory: &'m mut Memory,
    room: usize,
    columns: Vec<ColumnRead>,
    unit: &'static Unit,
    from_si: f64,
    to_si: f64,
    allow_gaps: bool,
    even_stamps: bool,
    order: Order,
    rows: bool,
    first: Option<Tick>,
    last: Option<(Tick, u64)>,
    first_kept: Option<Tick>,
    time_s: Vec<f64>,
    channels: Vec<Channel>,
    /// Points at which sample index and place in the file stop advancing together: index and place.
    places: Vec<(usize, u64)>,
    before: u64,
    after: u64,
    /// No faulty time was found.
    sound: bool,
    /// Kept samples that lack a value, in runs from an index up to another one.
    lacking: Lacking,
}

/// Relative deviation of times in faults, which are shown with fifteen digits.
const SHOWN: f64 = 1e-14;

/// Checks the window of the layout.
pub(crate) fn check_window(layout: &Layout, faults: &mut FaultCollector) {
    if let (Some(from), Some(to)) = (layout.from, layout.to)
        && from.si().partial_cmp(&to.si()) != Some(Ordering::Less)
    {
        faults.push(Fault::WindowReversed { from, to });
    }
}

impl<'m> Gather<'m> {
    /// Creates the collector for columns with known units; `rows` states if places are rows instead of lines.
    pub(crate) fn new(
        columns: Vec<ColumnRead>,
        layout: &Layout,
        rows: bool,
        memory: &'m mut Memory,
        faults: &mut FaultCollector,
    ) -> Option<Self> {
        check_course(&columns, faults);
        let unit = columns.iter().find(|column| column.role == Role::Time)?.unit;
        let channels = columns
            .iter()
            .filter(|column| column.role != Role::Time)
            .map(|column| Channel { role: column.role, unit: column.unit, values: Vec::new() })
            .collect();
        // A bound and a time written alike may differ in the last digits after conversion to SI.
        let slack = |bound: f64| 4.0 * f64::EPSILON * bound.abs();
        Some(Self {
            memory,
            room: 0,
            columns,
            unit,
            from_si: layout.from.map_or(f64::NEG_INFINITY, |from| from.si() - slack(from.si())),
            to_si: layout.to.map_or(f64::INFINITY, |to| to.si() + slack(to.si())),
            allow_gaps: layout.allow_gaps,
            even_stamps: layout.even_stamps,
            order: Order::default(),
            rows,
            first: None,
            last: None,
            first_kept: None,
            time_s: Vec::new(),
            channels,
            places: Vec::new(),
            before: 0,
            after: 0,
            sound: true,
            lacking: Lacking::default(),
        })
    }

    /// Adds a value that the sample kept last lacks, by the index of its channel.
    pub(crate) fn lacks(&mut self, channel: usize) {
        self.lacking.note(self.time_s.len().saturating_sub(1), channel);
    }

    /// Returns the columns that lack values, each with the way to read the recording nevertheless; `is_end` states that all samples
    /// were read.
    pub(crate) fn remedies(&self, is_end: bool) -> Vec<(String, Remedy)> {
        let first = self.first_kept.map_or(0.0, Tick::value);
        let stamp = |index: usize| {
            let since = self.unit.from_si(self.time_s.get(index).copied().unwrap_or(0.0));
            Stamp { value: short(first + since), unit: self.unit }
        };
        let roles: Vec<Role> = self.channels.iter().map(|channel| channel.role).collect();
        let remedies = self.lacking.remedies(&roles, is_end.then_some(self.time_s.len()), stamp);
        let name = |channel: usize| {
            let role = roles.get(channel)?;
            self.columns.iter().find(|column| column.role == *role).map(|column| excerpt(&column.name))
        };
        remedies.into_iter().filter_map(|(channel, remedy)| Some((name(channel)?, remedy))).collect()
    }

    /// Adds the reasons for a wrong order of the rows to the faults.
    pub(crate) fn advise_order(&self, faults: &mut FaultCollector) {
        faults.advise_order(self.order.of_backwards(self.unit, |number| self.place(number)), self.order.of_same());
    }

    /// Returns `true` if so many lines that are no rows may be a footer: some few below many rows.
    pub(crate) fn may_end_in(&self, lines: u64) -> bool {
        const LINES: u64 = 8;
        const ROWS_PER_LINE: u64 = 20;
        let rows = self.before + self.after + self.time_s.len() as u64;
        lines <= LINES.max(rows / ROWS_PER_LINE)
    }

    /// Returns the time of the last row that has one.
    pub(crate) fn last_time(&self) -> Option<Stamp> {
        self.last.map(|(tick, _)| Stamp { value: short(tick.value()), unit: self.unit })
    }

    /// Returns `true` if a row reached the end of the window: what follows is no part of the recording.
    pub(crate) fn is_over(&self) -> bool {
        // The end may be stated as shown in a fault.
        let slack = SHOWN * self.to_si.abs();
        self.to_si.is_finite() && self.last.is_some_and(|(tick, _)| self.unit.to_si(tick.value()) >= self.to_si - slack)
    }

    /// Returns `true` if no sample was kept yet.
    pub(crate) const fn is_empty(&self) -> bool {
        self.time_s.is_empty()
    }

    /// Returns `true` if only a part of the samples is requested.
    pub(crate) fn has_window(&self) -> bool {
        self.from_si.is_finite() || self.to_si.is_finite()
    }

    /// Returns an error if the caller cancelled.
    pub(crate) fn go_on(&self) -> Result<(), Fault> {
        self.memory.go_on()
    }

    /// Returns the remaining memory.
    pub(crate) fn memory(&self) -> Memory {
        self.memory.clone()
    }

    /// Returns the number of bytes of a number of samples.
    fn bytes_of(&self, samples: usize) -> u64 {
        (samples as u64).saturating_mul(8 * (1 + self.channels.len() as u64))
    }

    /// Reserves room for a further sample; doubles the room as long as memory is left.
    fn make_room(&mut self) -> Result<(), Fault> {
        if self.time_s.len() < self.room {
            return Ok(());
        }
        // Initial number of samples.
        const FIRST: usize = 4096;
        let room = (2 * self.time_s.len()).clamp(FIRST, SAMPLES_MAX);
        // Old and new arrays exist together while the samples are copied.
        self.memory.take(self.bytes_of(room))?;
        let more = room - self.time_s.len();
        self.time_s.reserve_exact(more);
        self.channels.iter_mut().for_each(|channel| channel.values.reserve_exact(more));
        self.memory.give_back(self.bytes_of(self.room));
        self.room = room;
        Ok(())
    }

    pub(crate) const fn place(&self, number: u64) -> FileRow {
        if self.rows { FileRow::Row(number) } else { FileRow::Line(number) }
    }

    const fn stamp(&self, tick: Tick) -> Stamp {
        Stamp { value: tick.value(), unit: self.unit }
    }

    /// Starts a sample: checks its time against the one before. If the sample is kept, a value for every channel must
    /// follow.
    pub(crate) fn sample(&mut self, number: u64, tick: Tick, faults: &mut FaultCollector) -> SampleUse {
        self.first.get_or_insert(tick);
        self.order.note(number, tick);
        let before = self.last.replace((tick, number));
        if let Some((last, at)) = before
            && !(self.even_stamps && tick.since(last) == 0.0)
        {
            let step = tick.since(last);
            if step <= 0.0 {
                return self.out_of_order(number, tick, (last, at), step == 0.0, faults);
            }
            let step = self.unit.to_si(step);
            if step < STEP_MIN_S {
                self.sound = false;
                faults.push(Fault::TooClose { at: self.place(number), length: Time::from_si(step) });
                return SampleUse::Dropped;
            }
        }
        let si = self.unit.to_si(tick.value());
        if si.is_nan() || si.abs() > MAGNITUDE_MAX {
            return self.out_of_range(number, tick, faults);
        }
        if si < self.from_si {
            self.before += 1;
            return SampleUse::Dropped;
        }
        if si > self.to_si {
            self.after += 1;
            return SampleUse::Dropped;
        }
        if self.time_s.len() >= SAMPLES_MAX {
            faults.push(Fault::too_many_samples());
            return SampleUse::Full;
        }
        if let Err(fault) = self.make_room() {
            faults.push(fault);
            return SampleUse::Full;
        }
        let first = *self.first_kept.get_or_insert(tick);
        let time = self.unit.to_si(tick.since(first));
        // Relative to a very distant first time, two different times may become equal.
        if let (Some(last), Some(before)) = (self.time_s.last(), before)
            && (time < *last || time == *last && !self.even_stamps)
            && self.sound
        {
            return self.out_of_order(number, tick, before, true, faults);
        }
        let index = self.time_s.len();
        let expected = self.places.last().map(|(start, place)| place + (index - start) as u64);
        if expected != Some(number) {
            self.places.push((index, number));
        }
        self.time_s.push(time);
        SampleUse::Kept
    }

    fn out_of_order(
        &mut self,
        number: u64,
        tick: Tick,
        (last, at): (Tick, u64),
        same: bool,
        faults: &mut FaultCollector,
    ) -> SampleUse {
        self.sound = false;
        let (at, first) = (self.place(number), self.place(at));
        faults.push(if same {
            Fault::SameTime { at, first, time: self.stamp(tick) }
        } else {
            Fault::Backwards { at, time: self.stamp(tick), before: self.stamp(last) }
        });
        SampleUse::Dropped
    }

    /// Reports a time that is out of range.
    fn out_of_range(&mut self, number: u64, tick: Tick, faults: &mut FaultCollector) -> SampleUse {
        self.sound = false;
        let time = self.columns.iter().find(|column| column.role == Role::Time);
        let column = time.map_or_else(String::new, |column| excerpt(&column.name));
        faults.push(Fault::ValueImplausible { at: self.place(number), column, text: format!("{:e}", tick.value()) });
        SampleUse::Dropped
    }

    /// Records that a time could not be read, so that the intervals around it are not checked.
    pub(crate) const fn time_failed(&mut self) {
        self.sound = false;
    }

    /// Adds the value of a channel, by its index in the order of the columns without time.
    pub(crate) fn value(&mut self, channel: usize, value: f64) -> Result<(), Bad> {
        let Some(channel) = self.channels.get_mut(channel) else { return Ok(()) };
        let si = channel.unit.to_si(value);
        channel.values.push(si);
        match si.abs() {
            size if size <= MAGNITUDE_MAX => Ok(()),
            size if size.is_finite() || value.is_finite() => Err(Bad::Implausible),
            _ => Err(Bad::NotFinite),
        }
    }

    /// Builds the recording after the last sample.
    pub(crate) fn finish(mut self, faults: &mut FaultCollector) -> Option<Recording> {
        if self.sound && self.time_s.len() < SAMPLES_MIN && faults.none() {
            faults.push(Fault::TooFewSamples {
                found: self.time_s.len(),
                least: SAMPLES_MIN,
                outside: self.before + self.after,
                span: self.first.zip(self.last).map(|(first, (last, _))| [self.stamp(first), self.stamp(last)]),
            });
        }
        if self.sound && !self.allow_gaps {
            self.check_gaps(faults);
        }
        if self.sound {
            self.check_steps(faults);
        }
        let revolutions_removed = if self.sound { self.unwrap_turns() } else { 0 };
        if self.sound {
            self.check_turns(faults);
        }
        if self.sound && faults.none() {
            self.check_jumps(faults);
        }
        if !faults.none() {
            return None;
        }
        let kept = self.bytes_of(self.time_s.len());
        let first_time = Time::from_si(self.unit.to_si(self.first_kept?.value()));
        let mut series = |role: Role| {
            let channel = self.channels.iter_mut().find(|channel| channel.role == role)?;
            let mut values = std::mem::take(&mut channel.values);
            values.shrink_to_fit();
            Some(Series { along: Along::of(channel.unit), values: Arc::new(values) })
        };
        let course = RecordedCourse { position: series(Role::Position), speed: series(Role::Speed) };
        let torque = series(Role::Torque);
        self.memory.give_back(self.bytes_of(self.room).saturating_sub(kept));
        self.room = 0;
        let mut time_s = std::mem::take(&mut self.time_s);
        time_s.shrink_to_fit();
        Some(Recording {
            time_s: Arc::new(time_s),
            first_time,
            course,
            torque,
            columns: std::mem::take(&mut self.columns),
            encoding: None,
            unused: Vec::new(),
            comments: 0,
            revolutions_removed,
            left_out_before: self.before,
            left_out_after: self.after,
        })
    }

    fn check_gaps(&self, faults: &mut FaultCollector) {
        let steps = || self.time_s.iter().zip(self.time_s.iter().skip(1)).map(|(before, after)| after - before);
        let (least, most) =
            steps().fold((f64::INFINITY, 0.0_f64), |(least, most), step| (least.min(step), most.max(step)));
        // The median is at least as long as the shortest interval.
        if most <= GAP_FACTOR * least {
            return;
        }
        let mut sorted: Vec<f64> = steps().collect();
        let middle = sorted.len() / 2;
        if middle >= sorted.len() {
            return;
        }
        let (_, median, _) = sorted.select_nth_unstable_by(middle, f64::total_cmp);
        // Of rounded time stamps most may be equal.
        let mean = steps().sum::<f64>() / (self.time_s.len() - 1).max(1) as f64;
        let median = if self.even_stamps { median.max(mean) } else { *median };
        // The difference of two rounded stamps is inexact by units of their last place.
        let largest = self.time_s.iter().fold(0.0_f64, |largest, time| largest.max(time.abs()));
        // Equal stamps are rounded, to the smallest step between others.
        let has_equal = self.even_stamps && steps().any(|step| step == 0.0);
        let rounded = if has_equal { steps().filter(|step| *step > 0.0).fold(f64::INFINITY, f64::min) } else { 0.0 };
        let rounded = if rounded.is_finite() { rounded } else { 0.0 };
        let most = GAP_FACTOR * median * (1.0 + GAP_ROUNDING) + rounded + ROUNDING * largest;
        for (index, step) in (1..).zip(steps()) {
            if step > most {
                let at = self.place(self.number_of(index));
                faults.push(Fault::Gap { at, length: Time::from_si(step), median: Time::from_si(median) });
            }
        }
    }

    /// Removes the jumps of a full turn from the positions of a modulo axis and returns their number.
    fn unwrap_turns(&mut self) -> usize {
        let position = self.channels.iter_mut().find(|channel| channel.role == Role::Position);
        let turning = position.filter(|channel| Along::of(channel.unit) == Along::Turning);
        turning.map_or(0, |channel| unwrap_revolutions(&mut channel.values))
    }

    /// Reports steps of about half a revolution in positions that may be those of a modulo axis. A column of speed decides: if it does not
    /// fit the positions, the recording is refused for that.
    fn check_steps(&self, faults: &mut FaultCollector) {
        let of = |role: Role| self.channels.iter().find(|channel| channel.role == role);
        let turning = of(Role::Position).filter(|channel| Along::of(channel.unit) == Along::Turning);
        let Some(position) = turning.filter(|_| of(Role::Speed).is_none()) else { return };
        let Some((index, step, count)) = undecided_step(&position.values) else { return };
        let time = self.first_kept.map_or(0.0, Tick::value)
            + self.unit.from_si(self.time_s.get(index).copied().unwrap_or(0.0));
        let time = Stamp { value: short(time), unit: self.unit };
        faults.push(Fault::StepUndecided {
            at: self.place(self.number_of(index)),
            time,
            step: Angle::from_si(step),
            count,
        });
    }

    /// Reports jumps of a position against the motion: a modulo axis whose jumps were not removed.
    fn check_jumps(&self, faults: &mut FaultCollector) {
        let of = |role: Role| self.channels.iter().find(|channel| channel.role == role);
        let Some(position) = of(Role::Position) else { return };
        let Some((index, size, count)) = first_jump(&position.values) else { return };
        let named = self.columns.iter().find(|column| column.role == Role::Position);
        let column = named.map_or_else(String::new, |column| excerpt(&column.name));
        let (at, along) = (self.place(self.number_of(index)), Along::of(position.unit));
        faults.push(Fault::PositionJumps { at, column, size, along, has_speed: of(Role::Speed).is_some(), count });
    }

    /// Reports a position that begins anew after a full turn, as that of an axis that counts from 0° to 360°: a jump of a turn, but for
    /// a step as between its neighbours.
    fn check_turns(&self, faults: &mut FaultCollector) {
        const STEP_MOST: f64 = TAU / 12.0;
        let of = |role: Role| self.channels.iter().find(|channel| channel.role == role);
        let Some(position) = of(Role::Position).filter(|channel| Along::of(channel.unit) == Along::Turning) else {
            return;
        };
        for (index, values) in position.values.windows(4).enumerate() {
            let [first, before, after, last] = values else { continue };
            let jump = after - before;
            let step = (before - first).abs().max((last - after).abs());
            let beside = (jump.abs() - TAU).abs();
            if step < STEP_MOST && beside <= 2.0 * step + 1e-3 * TAU {
                let at = self.place(self.number_of(index + 2));
                faults.push(Fault::TurnBegun { at, jump: Angle::from_si(jump), has_speed: of(Role::Speed).is_some() });
            }
        }
    }

    /// Returns the line or row of a kept sample.
    fn number_of(&self, index: usize) -> u64 {
        let run = self.places.partition_point(|(start, _)| *start <= index);
        let (start, number) = run.checked_sub(1).and_then(|run| self.places.get(run)).copied().unwrap_or((0, 0));
        number + (index - start) as u64
    }
}

impl Drop for Gather<'_> {
    /// Returns the reserved memory if no recording was built.
    fn drop(&mut self) {
        self.memory.give_back(self.bytes_of(self.room));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::series::KnownBy;
    use quantities::unit::SECOND;

    #[test]
    fn no_more_samples_are_kept_than_the_bound() {
        let time = ColumnRead { role: Role::Time, name: String::from("t"), unit: &SECOND, known_by: KnownBy::Header };
        let mut faults = FaultCollector::default();
        let mut memory = Memory::default();
        let mut gather = Gather::new(vec![time], &Layout::default(), false, &mut memory, &mut faults).unwrap();
        gather.time_s = vec![-1.0; SAMPLES_MAX - 1];
        assert_eq!(gather.sample(2, Tick::of_float(1.0), &mut faults), SampleUse::Kept);
        assert_eq!(gather.sample(3, Tick::of_float(2.0), &mut faults), SampleUse::Full);
        assert_eq!(faults.outcome(Some(())), Err(vec![Fault::TooManySamples { most: SAMPLES_MAX }]));
    }
}
