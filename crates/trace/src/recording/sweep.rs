//! A recording passed several straight intervals at a time: for what no sum of a block or cell holds.

use super::loads::{Piece, direction};
use super::{LANES, Strip, parts};
use crate::{Block, BlockPanels, Panel};
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
#[derive(Clone, Copy, Debug)]
pub enum Swept<'p> {
    /// Straight intervals, one after the other.
    Ramps(&'p [Ramps]),
    /// One panel, whatever its signals are.
    Panel(Panel<'p>),
}

impl Strip {
    /// Passes the intervals of a block in the order of time, as [`Strip::panels`] does.
    pub fn sweep(&self, block: &Block, look: &mut impl FnMut(Swept<'_>)) {
        let BlockPanels::Recorded { intervals, .. } = &block.place else { return };
        let mut gathered = Gathered::of(intervals.len());
        match self.straight() {
            Some(plain) => self.straight_intervals(plain, block, intervals.clone(), &mut gathered),
            None => self.pieces(block, intervals.clone(), &mut gathered, look),
        }
        gathered.pass(look);
    }

    /// The direction in which a sample is passed.
    fn direction(&self, sample: usize) -> f64 {
        let speed = self.placed.recorded.speed_rad_s().get(sample);
        speed.map_or(0.0, |speed| if *speed == 0.0 { 0.0 } else { speed.signum() })
    }

    /// Gathers intervals under a load that makes each a straight one.
    fn straight_intervals(&self, plain: &Plain, block: &Block, intervals: Range<usize>, gathered: &mut Gathered) {
        // Where the bounds show one direction nothing turns round.
        let turns = block.extent.direction.0 != block.extent.direction.1;
        let mut from = intervals.start;
        while from < intervals.end {
            let to = if turns { self.one_way(from, intervals.end).max(from + 1) } else { intervals.end };
            // A block that starts from rest has its direction all the same.
            let direction = if turns { self.direction(from) } else { block.extent.direction.0 };
            let done = self.ramps(plain, from..to, direction, gathered);
            for interval in (done..to).filter_map(|index| self.placed.interval(index)) {
                let acceleration = interval.acceleration_rad_s2();
                for (from, to, direction) in parts(&interval) {
                    let unchanging =
                        plain.constant_nm + self.view.coulomb * direction + self.view.inertia * acceleration;
                    let load = |u: f64| {
                        let (_, speed, torque) = interval.at(u);
                        torque + unchanging + self.view.viscous * speed
                    };
                    gathered.add((from, to), [load(from), load(to)], &interval, direction);
                }
            }
            from = to;
        }
    }

    /// Gathers as many intervals of one direction as make whole lanes; the first that is left.
    fn ramps(&self, plain: &Plain, intervals: Range<usize>, direction: f64, gathered: &mut Gathered) -> usize {
        let torque = self.placed.recorded.torque_nm();
        let mut from = intervals.start;
        let constant = plain.constant_nm + self.view.coulomb * direction;
        while from + LANES <= intervals.end {
            let torque = torque.map_or(Some([[0.0; LANES]; 2]), |torque| ends(torque, from));
            let (Some(mut ramps), Some(torque)) = (self.lanes(from, direction), torque) else { break };
            for ((load, torque), speed) in ramps.load_nm.iter_mut().zip(&torque).zip(&ramps.speed_rad_s) {
                for (((load, torque), speed), acceleration) in
                    load.iter_mut().zip(torque).zip(speed).zip(&ramps.acceleration_rad_s2)
                {
                    *load = torque + constant + self.view.inertia * acceleration + self.view.viscous * speed;
                }
            }
            gathered.push(&ramps);
            from += LANES;
        }
        from
    }

    /// The course of neighbouring intervals from one on, without their load.
    #[inline]
    fn lanes(&self, from: usize, direction: f64) -> Option<Ramps> {
        let recorded = &*self.placed.recorded;
        let ([t0, t1], [w0, w1]) = (ends(recorded.time_s(), from)?, ends(recorded.speed_rad_s(), from)?);
        // What is not plain is surveyed as it is placed.
        let stretch = self.placed.stretch;
        let slow = 1.0 / stretch;
        let mut ramps =
            Ramps { speed_rad_s: [w0, w1].map(|speed| speed.map(|speed| speed * slow)), direction, ..Ramps::default() };
        let lanes = ramps.duration_s.iter_mut().zip(&mut ramps.acceleration_rad_s2);
        for ((((h, a), (t0, t1)), w0), w1) in lanes.zip(t0.iter().zip(&t1)).zip(&w0).zip(&w1) {
            let raw = t1 - t0;
            *h = raw * stretch;
            *a = (w1 - w0) / raw * slow * slow;
        }
        Some(ramps)
    }

    /// Neighbouring intervals from one on that are run through in one direction, each with one piece that is nearly straight.
    #[inline]
    fn leaning(&self, from: usize, bent_at_most: f64) -> Option<Ramps> {
        let loads = self.loads.whole(from)?;
        let speeds = self.placed.recorded.speed_rad_s().get(from..=from + LANES)?;
        let direction = if speeds.iter().all(|speed| *speed > 0.0) {
            1.0
        } else if speeds.iter().all(|speed| *speed < 0.0) {
            -1.0
        } else {
            return None;
        };
        let (view, mut ramps) = (&self.view, self.lanes(from, direction)?);
        let [load_0, load_1] = &mut ramps.load_nm;
        let [speed_0, speed_1] = &ramps.speed_rad_s;
        let mut bent = 0.0_f64;
        let lanes = load_0.iter_mut().zip(load_1).zip(speed_0.iter().zip(speed_1)).zip(&ramps.acceleration_rad_s2);
        for ((((load_0, load_1), (speed_0, speed_1)), acceleration), [first, middle, last]) in lanes.zip(loads) {
            let bend = view.weight * (middle - 0.5 * (first + last));
            let unchanging = view.inertia * acceleration + view.coulomb * direction + 2.0 / 3.0 * bend;
            bent = bent.max(bend.abs());
            *load_0 = view.weight * first + view.viscous * speed_0 + unchanging;
            *load_1 = view.weight * last + view.viscous * speed_1 + unchanging;
        }
        (bent <= bent_at_most).then_some(ramps)
    }

    /// Gathers intervals whose load hangs on the position or has losses: the pieces whose loads are known and nearly straight
    /// side by side; whatever else there is, is passed one by one.
    fn pieces(
        &self,
        block: &Block,
        intervals: Range<usize>,
        gathered: &mut Gathered,
        look: &mut impl FnMut(Swept<'_>),
    ) {
        let bent_at_most = STRAIGHT * f64::max(block.extent.load_nm.1, -block.extent.load_nm.0);
        let mut next = intervals.start;
        while next < intervals.end {
            if next + LANES <= intervals.end
                && let Some(ramps) = self.leaning(next, bent_at_most)
            {
                gathered.push(&ramps);
                next += LANES;
                continue;
            }
            let index = next;
            next += 1;
            let Some(interval) = self.placed.interval(index) else { continue };
            let seen = |piece: Piece| match direction(&interval) {
                Some(direction) => self.view.piece(&piece, &interval, direction),
                None => piece,
            };
            let pieces = self.loads.pieces(index).map(|piece| piece.map(seen));
            let is_straight = |piece: &Piece| piece.bend().abs() <= bent_at_most;
            match direction(&interval) {
                Some(direction) if pieces[0].is_some() && pieces.iter().flatten().all(is_straight) => {
                    for piece in pieces.iter().flatten() {
                        // A straight line of the same mean: Simpson's is ⅔ of the bend above the line between the ends.
                        let raised = 2.0 / 3.0 * piece.bend();
                        let [first, _, last] = piece.loads;
                        gathered.add((piece.from, piece.to), [first + raised, last + raised], &interval, direction);
                    }
                }
                _ => {
                    gathered.pass(look);
                    self.interval(index, &mut |panel| look(Swept::Panel(panel)));
                }
            }
        }
    }
}

/// Straight intervals on their way to be passed together.
struct Gathered {
    ramps: Vec<Ramps>,
    /// Single ones that wait for others, in the first lanes.
    single: Ramps,
    count: usize,
}

impl Gathered {
    fn of(intervals: usize) -> Self {
        // Single ones may leave lanes empty where the direction changes.
        Self { ramps: Vec::with_capacity(intervals / LANES + LANES), single: Ramps::default(), count: 0 }
    }

    /// Neighbouring intervals, as many as there are lanes.
    #[inline]
    fn push(&mut self, ramps: &Ramps) {
        self.close();
        self.ramps.push(*ramps);
    }

    /// A part of an interval, with its load at both ends.
    fn add(&mut self, (from, to): (f64, f64), loads: [f64; 2], interval: &Interval, direction: f64) {
        if self.single.direction != direction {
            self.close();
        }
        self.single.direction = direction;
        let [begin, end] = interval.speed_rad_s;
        let speed = |u: f64| if u == 1.0 { end } else { begin + u * (end - begin) };
        let Ramps {
            duration_s, acceleration_rad_s2, speed_rad_s: [speed_0, speed_1], load_nm: [load_0, load_1], ..
        } = &mut self.single;
        for (values, value) in [
            (duration_s, (to - from) * interval.duration_s),
            (acceleration_rad_s2, interval.acceleration_rad_s2()),
            (speed_0, speed(from)),
            (speed_1, speed(to)),
            (load_0, loads[0]),
            (load_1, loads[1]),
        ] {
            values.iter_mut().skip(self.count).take(1).for_each(|place| *place = value);
        }
        self.count += 1;
        if self.count == LANES {
            self.close();
        }
    }

    /// No further single one joins those that wait; the lanes that are left have no duration, and nothing in them.
    #[inline]
    fn close(&mut self) {
        if self.count > 0 {
            self.ramps.push(self.single);
            (self.single, self.count) = (Ramps::default(), 0);
        }
    }

    /// Passes what is there.
    fn pass(&mut self, look: &mut impl FnMut(Swept<'_>)) {
        self.close();
        if !self.ramps.is_empty() {
            look(Swept::Ramps(&self.ramps));
            self.ramps.clear();
        }
    }
}

/// The values of samples from one on, and those of the samples after each of them.
fn ends(values: &[f64], from: usize) -> Option<[[f64; LANES]; 2]> {
    let first = values.get(from..from + LANES)?.try_into().ok()?;
    let next = values.get(from + 1..=from + LANES)?.try_into().ok()?;
    Some([first, next])
}
