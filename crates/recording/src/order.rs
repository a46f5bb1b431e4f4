//! Order of the rows by their times, and the reason for one that is wrong.

use crate::faults::{FileRow, Remedy, Stamp};
use crate::number::{Tick, short};
use quantities::Unit;

/// Smallest share of rows with the time of the row before that are those of rounded time stamps.
const ROUNDED: f64 = 0.05;

/// Smallest number of such rows.
const ROUNDED_LEAST: u64 = 3;

/// Smallest number of steps forward of a time that does not stand still.
const FORWARD_LEAST: u64 = 2;

/// Counts of the steps between the rows of a file.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Order {
    first: Option<Tick>,
    /// Time of the row before, and of the one before that.
    last: Option<(Tick, u64)>,
    before: Option<Tick>,
    forward: u64,
    same: u64,
    back: u64,
    /// Numbers of the row at which time first runs backwards, and of the row before it.
    turn: Option<[u64; 2]>,
    /// The first backward step returns to the first time.
    is_restart: bool,
    /// The first backward step ends behind the row before both.
    is_exchange: bool,
    /// Time, in the unit of the column, after which the rows behind the first backward step would follow those before it evenly.
    back_by: f64,
}

/// Seconds of an hour, by which a clock is set back at the end of summer time.
const HOUR_S: f64 = 3600.0;

impl Order {
    /// Adds a row with its number.
    pub(crate) fn note(&mut self, number: u64, tick: Tick) {
        let first = *self.first.get_or_insert(tick);
        if let Some((last, at)) = self.last {
            let step = tick.since(last);
            if step > 0.0 {
                self.forward += 1;
            } else if step == 0.0 {
                self.same += 1;
            } else {
                self.back += 1;
                if self.turn.is_none() {
                    self.turn = Some([at, number]);
                    self.is_restart = tick.since(first) == 0.0;
                    self.is_exchange = self.before.is_none_or(|before| tick.since(before) > 0.0);
                    self.back_by = self.before.map_or(0.0, |before| last.since(before)) - step;
                }
            }
        }
        self.before = self.last.map(|(tick, _)| tick);
        self.last = Some((tick, number));
    }

    /// Returns the way to read a file in which time runs backwards; `unit` is that of the column of time.
    pub(crate) fn of_backwards(&self, unit: &'static Unit, place: impl Fn(u64) -> FileRow) -> Option<Remedy> {
        let [at, number] = self.turn?;
        Some(match self.back {
            _ if self.forward == 0 => Remedy::Reverse,
            _ if self.is_restart => Remedy::KeepOne { at: place(number) },
            1 if self.is_exchange => Remedy::Exchange { rows: [place(at), place(number)] },
            1 if !self.is_ring() => Remedy::SetBack { at: place(number), by: self.set_back_by(unit) },
            _ => Remedy::Sort,
        })
    }

    /// Returns `true` if the rows behind a backward step end where the first row begins: a buffer that overwrites its oldest rows
    /// was written from its beginning.
    fn is_ring(&self) -> bool {
        /// Largest gap between the end of the second part and the beginning of the first, in steps.
        const STEPS: f64 = 10.0;
        let (Some(first), Some((last, _)), Some(before)) = (self.first, self.last, self.before) else { return false };
        let gap = first.since(last);
        gap > 0.0 && gap <= STEPS * last.since(before).abs()
    }

    /// Returns the time by which the clock was set back: whole hours, if the step is one of hours within a second.
    fn set_back_by(&self, unit: &'static Unit) -> Stamp {
        let seconds = unit.to_si(self.back_by);
        let hours = (seconds / HOUR_S).round();
        let is_hours = hours >= 1.0 && (seconds - hours * HOUR_S).abs() <= 1.0;
        Stamp { value: if is_hours { unit.from_si(hours * HOUR_S) } else { short(self.back_by) }, unit }
    }

    /// Returns the way to read a file in which rows have the same time; none if time stands still.
    pub(crate) fn of_same(&self) -> Option<Remedy> {
        if self.forward < FORWARD_LEAST {
            return None;
        }
        let rows = self.forward + self.same + self.back;
        let is_rounded = self.same >= ROUNDED_LEAST && self.same as f64 >= ROUNDED * rows as f64;
        Some(if self.back == 0 && is_rounded { Remedy::EvenStamps } else { Remedy::DeleteRepeated })
    }
}
