//! Order of the rows by their times, and the reason for one that is wrong.

use crate::faults::{FileRow, Remedy};
use crate::number::Tick;

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
}

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
                }
            }
        }
        self.before = self.last.map(|(tick, _)| tick);
        self.last = Some((tick, number));
    }

    /// Returns the way to read a file in which time runs backwards.
    pub(crate) fn of_backwards(&self, place: impl Fn(u64) -> FileRow) -> Option<Remedy> {
        let [at, number] = self.turn?;
        Some(match self.back {
            _ if self.forward == 0 => Remedy::Reverse,
            _ if self.is_restart => Remedy::KeepOne { at: place(number) },
            1 if self.is_exchange => Remedy::Exchange { rows: [place(at), place(number)] },
            _ => Remedy::Sort,
        })
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
