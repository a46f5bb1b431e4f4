//! Power over the cells of a recording, as a whole if torque and power keep their sign in them.

use super::{Balance, CyclePower, Passed};
use crate::currents::SPEED;
use trace::{Cell, Inside, Strip};

/// Divisor of the number of intervals: cells are used if they leave at most this part to be evaluated one by one.
const WORTHWHILE: usize = 16;

/// Power of the cells of a recording: if torque and power keep their sign in a cell, its sums are used.
pub(super) struct CellPower<'a> {
    power: &'a CyclePower<'a>,
    strip: &'a Strip,
    /// Weights of torque, current in motor operation, current with a driving load and speed, in the signals of the
    /// cells.
    torque: [f64; 4],
    driving: [f64; 4],
    driven: [f64; 4],
    speed: [f64; 4],
}

impl<'a> CellPower<'a> {
    pub(super) fn of(strip: &'a Strip, power: &'a CyclePower<'a>) -> Self {
        Self {
            power,
            strip,
            torque: strip.weights([power.currents.inertia, 1.0, 0.0, 0.0]),
            driving: strip.weights(power.weights(false)),
            driven: strip.weights(power.weights(true)),
            speed: strip.weights(SPEED),
        }
    }

    /// Returns ∫P dt over a cell in which torque and power keep their sign \[J\].
    fn of_one_sign(&self, cell: &Cell) -> Option<f64> {
        let (low, high) = cell.extent.range(self.torque);
        let (back, forth) = cell.extent.direction;
        let driving = (low >= 0.0 && back >= 0.0) || (high <= 0.0 && forth <= 0.0) || (back == 0.0 && forth == 0.0);
        if driving {
            return Some(self.energy(cell, self.driving));
        }
        let driven = (low >= 0.0 && forth <= 0.0) || (high <= 0.0 && back >= 0.0);
        if !driven {
            return None;
        }
        let current = cell.extent.range(self.driven);
        let (r, k) = self.power.constants();
        let volt =
            std::array::from_fn(|n| r * self.driven.get(n).unwrap_or(&0.0) + k * self.speed.get(n).unwrap_or(&0.0));
        let volt = cell.extent.range(volt);
        let (plus, minus) = (|range: (f64, f64)| range.0 >= 0.0, |range: (f64, f64)| range.1 <= 0.0);
        let one_sign = (plus(current) || minus(current)) && (plus(volt) || minus(volt));
        one_sign.then(|| self.energy(cell, self.driven))
    }

    /// Returns `true` if the cells leave few intervals to be evaluated one by one; otherwise evaluating all of them in
    /// the order of time, as they are stored, is faster.
    pub(super) fn serve(&self) -> bool {
        let mut left = self.strip.intervals() / WORTHWHILE;
        self.strip.root().is_some_and(|root| self.leaves_at_most(root, &mut left))
    }

    fn leaves_at_most(&self, cell: &Cell, left: &mut usize) -> bool {
        if self.of_one_sign(cell).is_some() {
            return true;
        }
        match cell.inside {
            Inside::Intervals(from, to) => {
                let within = (to - from) as usize;
                let enough = within <= *left;
                *left = left.saturating_sub(within);
                enough
            }
            Inside::Halves(halves) => {
                self.strip.children(halves).into_iter().flatten().all(|half| self.leaves_at_most(half, left))
            }
        }
    }

    pub(super) fn add(&self, cell: &Cell, balance: &mut Balance, passed: &mut Passed) {
        if let Some(taken) = self.of_one_sign(cell) {
            return balance.part(taken);
        }
        match cell.inside {
            Inside::Intervals(from, to) => {
                self.strip.panels_within((from, to), &mut |panel| balance.panel(&panel, self.power, passed));
            }
            Inside::Halves(halves) => {
                self.strip.children(halves).into_iter().flatten().for_each(|half| self.add(half, balance, passed));
            }
        }
    }

    /// Returns ∫P dt with one sign of the torque \[J\].
    fn energy(&self, cell: &Cell, current: [f64; 4]) -> f64 {
        let (r, k) = self.power.constants();
        self.strip.stretch() * (r * cell.gram.square(current) + k * cell.gram.product(current, self.speed))
    }
}
