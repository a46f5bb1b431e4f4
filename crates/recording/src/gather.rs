//! Samples one after another become a recording.

use crate::columns::check_course;
use crate::faults::{Fault, Faults, Place, Stamp, excerpt};
use crate::layout::{Layout, Role};
use crate::number::Tick;
use crate::series::{Along, ColumnRead, Course, Effort, Recording, Series};
use crate::{GAP_FACTOR, SAMPLES_MAX, SAMPLES_MIN};
use quantities::{Measure, Time, Unit};
use std::cmp::Ordering;

/// What is to be done with a sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sample {
    /// Its values are wanted.
    Kept,
    /// It lies outside the window, or its time is faulty.
    Dropped,
    /// No further sample can be kept.
    Full,
}

/// Values of one column that are kept.
struct Channel {
    role: Role,
    unit: &'static Unit,
    values: Vec<f64>,
}

/// Takes samples in the order of the file.
pub(crate) struct Gather {
    columns: Vec<ColumnRead>,
    unit: &'static Unit,
    from_si: f64,
    to_si: f64,
    allow_gaps: bool,
    rows: bool,
    first: Option<Tick>,
    last: Option<(Tick, u64)>,
    first_kept: Option<Tick>,
    time_s: Vec<f64>,
    channels: Vec<Channel>,
    /// Where the numbers of samples and places part: index of the sample and its place.
    places: Vec<(usize, u64)>,
    before: u64,
    after: u64,
    /// Whether no time was faulty.
    sound: bool,
}

/// Checks the window before anything is read.
pub(crate) fn check_window(layout: &Layout, faults: &mut Faults) {
    if let (Some(from), Some(to)) = (layout.from, layout.to)
        && from.si().partial_cmp(&to.si()) != Some(Ordering::Less)
    {
        faults.push(Fault::WindowReversed { from, to });
    }
}

impl Gather {
    /// Columns that have all their units; `rows` says whether places are rows or lines.
    pub(crate) fn new(columns: Vec<ColumnRead>, layout: &Layout, rows: bool, faults: &mut Faults) -> Option<Self> {
        check_course(&columns, faults);
        let unit = columns.iter().find(|column| column.role == Role::Time)?.unit;
        let channels = columns
            .iter()
            .filter(|column| column.role != Role::Time)
            .map(|column| Channel { role: column.role, unit: column.unit, values: Vec::new() })
            .collect();
        // A bound and a time that are written alike may differ in the last digits once they are in SI.
        let slack = |bound: f64| 4.0 * f64::EPSILON * bound.abs();
        Some(Self {
            columns,
            unit,
            from_si: layout.from.map_or(f64::NEG_INFINITY, |from| from.si() - slack(from.si())),
            to_si: layout.to.map_or(f64::INFINITY, |to| to.si() + slack(to.si())),
            allow_gaps: layout.allow_gaps,
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
        })
    }

    /// Whether only a part of the samples is wanted.
    pub(crate) fn has_window(&self) -> bool {
        self.from_si.is_finite() || self.to_si.is_finite()
    }

    pub(crate) const fn place(&self, number: u64) -> Place {
        if self.rows { Place::Row(number) } else { Place::Line(number) }
    }

    const fn stamp(&self, tick: Tick) -> Stamp {
        Stamp { value: tick.value(), unit: self.unit }
    }

    /// A sample begins: its time is checked against the one before. If it is kept, a value for every channel follows.
    pub(crate) fn sample(&mut self, number: u64, tick: Tick, faults: &mut Faults) -> Sample {
        self.first.get_or_insert(tick);
        let before = self.last.replace((tick, number));
        if let Some((last, at)) = before {
            let step = tick.since(last);
            if step <= 0.0 {
                return self.out_of_order(number, tick, (last, at), step == 0.0, faults);
            }
        }
        let si = self.unit.to_si(tick.value());
        if !si.is_finite() {
            return self.out_of_range(number, tick, faults);
        }
        if si < self.from_si {
            self.before += 1;
            return Sample::Dropped;
        }
        if si > self.to_si {
            self.after += 1;
            return Sample::Dropped;
        }
        if self.time_s.len() >= SAMPLES_MAX {
            faults.push(Fault::too_many_samples());
            return Sample::Full;
        }
        let first = *self.first_kept.get_or_insert(tick);
        let time = self.unit.to_si(tick.since(first));
        if !time.is_finite() {
            return self.out_of_range(number, tick, faults);
        }
        // Beside a very distant first time two times may become one.
        if let (Some(last), Some(before)) = (self.time_s.last(), before)
            && time <= *last
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
        Sample::Kept
    }

    fn out_of_order(
        &mut self,
        number: u64,
        tick: Tick,
        (last, at): (Tick, u64),
        same: bool,
        faults: &mut Faults,
    ) -> Sample {
        self.sound = false;
        let (at, first) = (self.place(number), self.place(at));
        faults.push(if same {
            Fault::SameTime { at, first, time: self.stamp(tick) }
        } else {
            Fault::Backwards { at, time: self.stamp(tick), before: self.stamp(last) }
        });
        Sample::Dropped
    }

    /// SI cannot hold the time, or not its distance from the first.
    fn out_of_range(&mut self, number: u64, tick: Tick, faults: &mut Faults) -> Sample {
        self.sound = false;
        let time = self.columns.iter().find(|column| column.role == Role::Time);
        let column = time.map_or_else(String::new, |column| excerpt(&column.name));
        faults.push(Fault::ValueNotFinite { at: self.place(number), column, text: format!("{:e}", tick.value()) });
        Sample::Dropped
    }

    /// A time could not be read: the intervals around it say nothing.
    pub(crate) const fn time_failed(&mut self) {
        self.sound = false;
    }

    /// The value of a channel, by its number in the order of the columns without time; false if SI cannot hold it.
    pub(crate) fn value(&mut self, channel: usize, value: f64) -> bool {
        let Some(channel) = self.channels.get_mut(channel) else { return true };
        let si = channel.unit.to_si(value);
        channel.values.push(si);
        si.is_finite()
    }

    /// The recording, after the last sample.
    pub(crate) fn finish(mut self, faults: &mut Faults) -> Option<Recording> {
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
        let first_time = Time::from_si(self.unit.to_si(self.first_kept?.value()));
        let mut series = |role: Role| {
            let channel = self.channels.iter_mut().find(|channel| channel.role == role)?;
            Some((Along::of(channel.unit), std::mem::take(&mut channel.values)))
        };
        let course = Course {
            position: series(Role::Position).map(|(along, values)| Series { along, values }),
            speed: series(Role::Speed).map(|(along, values)| Series { along, values }),
        };
        let torque = series(Role::Torque).map(|(along, values)| Effort { along, values });
        Some(Recording {
            time_s: self.time_s,
            first_time,
            course,
            torque,
            columns: self.columns,
            left_out_before: self.before,
            left_out_after: self.after,
        })
    }

    fn check_gaps(&self, faults: &mut Faults) {
        let steps = || self.time_s.iter().zip(self.time_s.iter().skip(1)).map(|(before, after)| after - before);
        let mut sorted: Vec<f64> = steps().collect();
        let middle = sorted.len() / 2;
        if middle >= sorted.len() {
            return;
        }
        let (_, median, _) = sorted.select_nth_unstable_by(middle, f64::total_cmp);
        let median = *median;
        for (index, step) in (1..).zip(steps()) {
            if step > GAP_FACTOR * median {
                let at = self.place(self.number_of(index));
                faults.push(Fault::Gap { at, length: Time::from_si(step), median: Time::from_si(median) });
            }
        }
    }

    /// Line or row of a kept sample.
    fn number_of(&self, index: usize) -> u64 {
        let run = self.places.partition_point(|(start, _)| *start <= index);
        let (start, number) = run.checked_sub(1).and_then(|run| self.places.get(run)).copied().unwrap_or((0, 0));
        number + (index - start) as u64
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
        let mut faults = Faults::default();
        let mut gather = Gather::new(vec![time], &Layout::default(), false, &mut faults).unwrap();
        gather.time_s = vec![-1.0; SAMPLES_MAX - 1];
        assert_eq!(gather.sample(2, Tick::of_float(1.0), &mut faults), Sample::Kept);
        assert_eq!(gather.sample(3, Tick::of_float(2.0), &mut faults), Sample::Full);
        assert_eq!(faults.outcome(Some(())), Err(vec![Fault::TooManySamples { most: SAMPLES_MAX }]));
    }
}
