//! Passes over a recording several straight intervals at a time, for signals that no sum of a block or cell covers.

use super::loads::{Piece, direction};
use super::{LANES, Strip, parts};
use crate::{Block, BlockPanels, Panel};
use mechanism::Plain;
use motion::Interval;
use std::ops::Range;

/// Largest deviation of a load from the straight line between its ends, as a share of the largest load of its block, up
/// to which it is replaced by a straight line with the same mean. Its integral over an interval, alone and multiplied
/// by the speed, stays exact; its square, and the place of a change of sign, change by this share.
const STRAIGHT: f64 = 1e-6;

/// Neighbouring intervals of a recording, or parts of them, in which all signals are straight lines, with one
/// direction. An empty lane has the duration zero and zeros throughout.
#[derive(Clone, Copy, Debug, Default)]
pub struct Ramps {
    /// Durations \[s\].
    pub duration_s: [f64; LANES],
    /// α \[rad/s²\]
    pub acceleration_rad_s2: [f64; LANES],
    /// ω at the start and the end of each \[rad/s\].
    pub speed_rad_s: [[f64; LANES]; 2],
    /// T_L at the start and the end of each \[Nm\].
    pub load_nm: [[f64; LANES]; 2],
    /// σ, common to all lanes.
    pub direction: f64,
}

/// Part of a block, as visited by a sweep.
#[derive(Clone, Copy, Debug)]
pub enum Swept<'p> {
    /// Consecutive straight intervals.
    Ramps(&'p [Ramps]),
    /// One panel with any signals.
    Panel(Panel<'p>),
}

impl Strip {
    /// Visits the intervals of a block in chronological order, as [`Strip::panels`] does.
    pub fn sweep(&self, block: &Block, look: &mut impl FnMut(Swept<'_>)) {
        let BlockPanels::Recorded { intervals, .. } = &block.place else { return };
        let mut gathered = Gathered::of(intervals.len());
        match self.straight() {
            Some(plain) => self.straight_intervals(plain, block, intervals.clone(), &mut gathered),
            None => self.pieces(block, intervals.clone(), &mut gathered, look),
        }
        gathered.pass(look);
    }

    /// Returns the direction of the motion at a sample.
    fn direction(&self, sample: usize) -> f64 {
        let speed = self.placed.recorded.speed_rad_s().get(sample);
        speed.map_or(0.0, |speed| if *speed == 0.0 { 0.0 } else { speed.signum() })
    }

    /// Gathers intervals under a load that makes each of them straight.
    fn straight_intervals(&self, plain: &Plain, block: &Block, intervals: Range<usize>, gathered: &mut Gathered) {
        // No interval reverses if the bounds show one direction.
        let turns = block.extent.direction.0 != block.extent.direction.1;
        let mut from = intervals.start;
        while from < intervals.end {
            let to = if turns { self.one_way(from, intervals.end).max(from + 1) } else { intervals.end };
            // A block that starts from rest takes its direction from the bounds.
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

    /// Gathers intervals of one direction as long as they fill whole lanes, and returns the index of the first
    /// remaining one.
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

    /// Returns the motion of [`LANES`] neighbouring intervals, without their load.
    #[inline]
    fn lanes(&self, from: usize, direction: f64) -> Option<Ramps> {
        let recorded = &*self.placed.recorded;
        let ([t0, t1], [w0, w1]) = (ends(recorded.time_s(), from)?, ends(recorded.speed_rad_s(), from)?);
        // A load that is not plain is surveyed as placed.
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

    /// Returns [`LANES`] neighbouring intervals with one direction, each with one nearly straight piece.
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

    /// Gathers intervals whose load depends on the position or has losses: pieces with known, nearly straight loads in
    /// lanes; the others are visited one by one.
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
                        // A straight line with the same mean: Simpson's rule adds ⅔ of the bend to the chord.
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

/// Straight intervals gathered for one visit.
struct Gathered {
    ramps: Vec<Ramps>,
    /// Single intervals in the first lanes, waiting for further ones.
    single: Ramps,
    count: usize,
}

impl Gathered {
    fn of(intervals: usize) -> Self {
        // Single intervals may leave lanes empty where the direction changes.
        Self { ramps: Vec::with_capacity(intervals / LANES + LANES), single: Ramps::default(), count: 0 }
    }

    /// Adds neighbouring intervals that fill all lanes.
    #[inline]
    fn push(&mut self, ramps: &Ramps) {
        self.close();
        self.ramps.push(*ramps);
    }

    /// Adds a part of an interval with its load at both ends.
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

    /// Closes the lanes of single intervals; unused lanes have the duration zero.
    #[inline]
    fn close(&mut self) {
        if self.count > 0 {
            self.ramps.push(self.single);
            (self.single, self.count) = (Ramps::default(), 0);
        }
    }

    /// Visits the gathered intervals and clears them.
    fn pass(&mut self, look: &mut impl FnMut(Swept<'_>)) {
        self.close();
        if !self.ramps.is_empty() {
            look(Swept::Ramps(&self.ramps));
            self.ramps.clear();
        }
    }
}

/// Returns the values of [`LANES`] samples, and of the samples after each of them.
fn ends(values: &[f64], from: usize) -> Option<[[f64; LANES]; 2]> {
    let first = values.get(from..from + LANES)?.try_into().ok()?;
    let next = values.get(from + 1..=from + LANES)?.try_into().ok()?;
    Some([first, next])
}
