//! A recording passed interval by interval, several straight ones at a time: for what no sum of a block or cell holds.

use super::loads::{Piece, direction};
use super::{LANES, Strip};
use crate::{Block, Panel, Place};
use mechanism::Plain;
use motion::Interval;
use std::ops::Range;

/// A load that bends away from the straight line between its ends by at most this share of the largest of its block is taken
/// as straight, at the same mean. Its integral over an interval, alone and times the speed, stays what it is; its square, and
/// where a sign changes within the interval, feel this share.
const STRAIGHT: f64 = 1e-6;

/// Neighbouring intervals of a recording, or parts of them, in which all signals are straight lines, run through in one
/// direction. A lane may be empty: its duration is zero then, and all else in it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Ramps {
    /// Durations \[s\].
    pub duration_s: [f64; LANES],
    /// α \[rad/s²\]
    pub acceleration_rad_s2: [f64; LANES],
    /// ω at the beginning and the end of each \[rad/s\].
    pub speed_rad_s: [[f64; LANES]; 2],
    /// T_L at the beginning and the end of each \[Nm\].
    pub load_nm: [[f64; LANES]; 2],
    /// σ of all of them.
    pub direction: f64,
}

/// What a sweep passes.
#[derive(Debug)]
pub enum Swept<'p> {
    /// Straight intervals.
    Ramps(&'p Ramps),
    /// One panel, whatever its signals are.
    Panel(Panel<'p>),
}

impl Strip {
    /// Passes the intervals of a block in the order of time, as [`Strip::panels`] does.
    pub fn sweep(&self, block: &Block, look: &mut impl FnMut(Swept<'_>)) {
        let Place::Recorded { intervals, .. } = &block.place else { return };
        let Some(plain) = self.straight() else {
            return self.pieces(block, intervals.clone(), look);
        };
        // Where the bounds show one direction nothing turns round.
        let turns = block.extent.direction.0 != block.extent.direction.1;
        let mut from = intervals.start;
        while from < intervals.end {
            let to = if turns { self.one_way(from, intervals.end).max(from + 1) } else { intervals.end };
            // A block that starts from rest has its direction all the same.
            let direction = if turns { self.direction(from) } else { block.extent.direction.0 };
            let done = self.ramps(plain, from..to, direction, look);
            (done..to).for_each(|index| self.interval(index, &mut |panel| look(Swept::Panel(panel))));
            from = to;
        }
    }

    /// The direction in which a sample is passed.
    fn direction(&self, sample: usize) -> f64 {
        let speed = self.placed.recorded.speed_rad_s().get(sample);
        speed.map_or(0.0, |speed| if *speed == 0.0 { 0.0 } else { speed.signum() })
    }

    /// Passes as many intervals of one direction as make whole lanes; the first that is left.
    fn ramps(&self, plain: &Plain, intervals: Range<usize>, direction: f64, look: &mut impl FnMut(Swept<'_>)) -> usize {
        let recorded = &*self.placed.recorded;
        let (time, speed, torque) = (recorded.time_s(), recorded.speed_rad_s(), recorded.torque_nm());
        let view = &self.view;
        let slow = 1.0 / view.stretch;
        let mut from = intervals.start;
        let constant = plain.constant_nm + view.coulomb * direction;
        while from + LANES <= intervals.end {
            let (Some(time), Some(speed)) = (ends(time, from), ends(speed, from)) else { break };
            let torque = torque.map_or(Some([[0.0; LANES]; 2]), |torque| ends(torque, from));
            let Some(torque) = torque else { break };
            let [duration, acceleration] = {
                let ([t0, t1], [w0, w1]) = (time, speed);
                let mut both = [[0.0; LANES]; 2];
                let [duration, acceleration] = &mut both;
                for (lane, (h, a)) in duration.iter_mut().zip(acceleration.iter_mut()).enumerate() {
                    let of = |values: &[f64; LANES]| values.get(lane).copied().unwrap_or(0.0);
                    let raw = of(&t1) - of(&t0);
                    *h = raw * view.stretch;
                    *a = (of(&w1) - of(&w0)) / raw * slow * slow;
                }
                both
            };
            let speed = speed.map(|speed| speed.map(|speed| speed * slow));
            let mut load = torque;
            for (load, speed) in load.iter_mut().zip(&speed) {
                for ((load, speed), acceleration) in load.iter_mut().zip(speed).zip(&acceleration) {
                    *load += constant + view.inertia * acceleration + view.viscous * speed;
                }
            }
            look(Swept::Ramps(&Ramps {
                duration_s: duration,
                acceleration_rad_s2: acceleration,
                speed_rad_s: speed,
                load_nm: load,
                direction,
            }));
            from += LANES;
        }
        from
    }

    /// Passes intervals whose load hangs on the position or has losses: the pieces whose loads are known and nearly straight
    /// side by side, whatever else there is one by one.
    fn pieces(&self, block: &Block, intervals: Range<usize>, look: &mut impl FnMut(Swept<'_>)) {
        let bent_at_most = STRAIGHT * f64::max(block.extent.load_nm.1, -block.extent.load_nm.0);
        let mut gathered = Gathered::default();
        for index in intervals {
            let Some(interval) = self.placed.interval(index) else { continue };
            let seen = |piece: Piece| match direction(&interval) {
                Some(direction) => self.view.piece(&piece, &interval, direction),
                None => piece,
            };
            let pieces = self.loads.pieces(index).map(|piece| piece.map(seen));
            let is_straight = |piece: &Piece| piece.bend().abs() <= bent_at_most;
            match direction(&interval) {
                Some(direction) if pieces[0].is_some() && pieces.iter().flatten().all(is_straight) => {
                    pieces.iter().flatten().for_each(|piece| gathered.add(piece, &interval, direction, look));
                }
                _ => {
                    gathered.pass(look);
                    self.interval(index, &mut |panel| look(Swept::Panel(panel)));
                }
            }
        }
        gathered.pass(look);
    }
}

/// Pieces on their way to be passed together.
#[derive(Default)]
struct Gathered {
    ramps: Ramps,
    count: usize,
}

impl Gathered {
    /// Adds a piece as a straight line of the same mean: Simpson's is ⅔ of the bend above the line between the ends.
    fn add(&mut self, piece: &Piece, interval: &Interval, direction: f64, look: &mut impl FnMut(Swept<'_>)) {
        if self.count > 0 && self.ramps.direction != direction {
            self.pass(look);
        }
        self.ramps.direction = direction;
        let raised = 2.0 / 3.0 * piece.bend();
        let [first, _, last] = piece.loads;
        let [begin, end] = interval.speed_rad_s;
        let speed = |u: f64| if u == 1.0 { end } else { begin + u * (end - begin) };
        let Ramps {
            duration_s, acceleration_rad_s2, speed_rad_s: [speed_0, speed_1], load_nm: [load_0, load_1], ..
        } = &mut self.ramps;
        for (values, value) in [
            (duration_s, (piece.to - piece.from) * interval.duration_s),
            (acceleration_rad_s2, interval.acceleration_rad_s2()),
            (speed_0, speed(piece.from)),
            (speed_1, speed(piece.to)),
            (load_0, first + raised),
            (load_1, last + raised),
        ] {
            values.iter_mut().skip(self.count).take(1).for_each(|place| *place = value);
        }
        self.count += 1;
        if self.count == LANES {
            self.pass(look);
        }
    }

    /// Passes what is there; the lanes that are left have no duration, and nothing in them.
    fn pass(&mut self, look: &mut impl FnMut(Swept<'_>)) {
        if self.count > 0 {
            look(Swept::Ramps(&self.ramps));
            *self = Self::default();
        }
    }
}

/// The values of samples from one on, and those of the samples after each of them.
fn ends(values: &[f64], from: usize) -> Option<[[f64; LANES]; 2]> {
    let first = values.get(from..from + LANES)?.try_into().ok()?;
    let next = values.get(from + 1..=from + LANES)?.try_into().ok()?;
    Some([first, next])
}
