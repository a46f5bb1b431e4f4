//! A recording passed interval by interval, several straight ones at a time: for what no sum of a block or cell holds.

use super::{LANES, Strip};
use crate::{Block, Panel, Place};
use std::ops::Range;

/// Neighbouring intervals of a recording in which all signals are straight lines, run through in one direction.
#[derive(Clone, Copy, Debug)]
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
        // Where the bounds show one direction nothing turns round; what is not straight is passed one by one anyway.
        let turns = self.plain.is_some() && block.extent.direction.0 != block.extent.direction.1;
        let mut from = intervals.start;
        while from < intervals.end {
            let to = if turns { self.one_way(from, intervals.end).max(from + 1) } else { intervals.end };
            let done = self.ramps(from..to, look);
            (done..to).for_each(|index| self.interval(index, &mut |panel| look(Swept::Panel(panel))));
            from = to;
        }
    }

    /// Passes as many intervals of one direction as make whole lanes; the first that is left.
    fn ramps(&self, intervals: Range<usize>, look: &mut impl FnMut(Swept<'_>)) -> usize {
        let Some(plain) = &self.plain else { return intervals.start };
        let recorded = &*self.placed.recorded;
        let (time, speed, torque) = (recorded.time_s(), recorded.speed_rad_s(), recorded.torque_nm());
        let view = &self.view;
        let slow = 1.0 / view.stretch;
        let mut from = intervals.start;
        let direction = speed.get(from).map_or(0.0, |speed| if *speed == 0.0 { 0.0 } else { speed.signum() });
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
}

/// The values of samples from one on, and those of the samples after each of them.
fn ends(values: &[f64], from: usize) -> Option<[[f64; LANES]; 2]> {
    let first = values.get(from..from + LANES)?.try_into().ok()?;
    let next = values.get(from + 1..=from + LANES)?.try_into().ok()?;
    Some([first, next])
}
