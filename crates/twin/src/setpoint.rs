//! Setpoints from the motion of the project, repeated over the cycles.

use motion::{Hold, Motion};
use quantities::Measure;

/// Setpoint of the axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SetPoint {
    /// Position q \[rad\], speed ω [rad/s], acceleration α [rad/s²].
    pub(crate) state: [f64; 3],
    /// Segment of the motion.
    pub(crate) segment: usize,
    /// Times since the beginning and until the end of a segment held by the brake \[s\]; `None` for other segments.
    pub(crate) braked: Option<[f64; 2]>,
}

/// A repeated motion.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Course<'a> {
    motion: &'a Motion,
    period_s: f64,
    net_rad: f64,
    cycles: f64,
}

impl<'a> Course<'a> {
    pub(crate) fn of(motion: &'a Motion, cycles: u32) -> Self {
        Self { motion, period_s: motion.duration().si(), net_rad: motion.net().si(), cycles: f64::from(cycles.max(1)) }
    }

    /// Returns the duration of all cycles \[s\].
    pub(crate) fn duration_s(&self) -> f64 {
        self.period_s * self.cycles
    }

    /// Returns the setpoint at a time; after the last cycle the axis is at rest.
    pub(crate) fn at(&self, time_s: f64) -> SetPoint {
        let cycle = (time_s / self.period_s).floor().clamp(0.0, self.cycles - 1.0);
        let is_over = time_s >= self.duration_s();
        let time = (time_s - cycle * self.period_s).clamp(0.0, self.period_s);
        let stretches = self.motion.stretches();
        let segment = stretches.partition_point(|each| each.start.si() <= time).saturating_sub(1);
        let braked = stretches.get(segment).filter(|each| each.hold == Hold::Brake).map(|each| {
            let since = time - each.start.si();
            [since, each.duration.si() - since]
        });
        let [position, speed, acceleration] = self.state(time);
        let state = [
            position + cycle * self.net_rad,
            if is_over { 0.0 } else { speed },
            if is_over { 0.0 } else { acceleration },
        ];
        SetPoint { state, segment, braked }
    }

    fn state(&self, time: f64) -> [f64; 3] {
        let recordings = self.motion.recordings();
        let place = recordings.partition_point(|each| each.start_s <= time).saturating_sub(1);
        if let Some(placed) = recordings.get(place)
            && (placed.start_s..=placed.start_s + placed.duration_s()).contains(&time)
        {
            let own = (time - placed.start_s) / placed.stretch;
            let index = placed.recorded.time_s().partition_point(|t| *t <= own).saturating_sub(1);
            let index = index.min(placed.intervals().saturating_sub(1));
            if let Some(interval) = placed.interval(index) {
                let u = (time - interval.start_s) / interval.duration_s;
                let (position, speed, _) = interval.at(u.clamp(0.0, 1.0));
                return [position, speed, interval.acceleration_rad_s2()];
            }
        }
        let pieces = self.motion.pieces();
        let place = pieces.partition_point(|piece| piece.start_s <= time).saturating_sub(1);
        pieces.get(place).map_or([0.0; 3], |piece| {
            let state = piece.at((time - piece.start_s).clamp(0.0, piece.duration_s));
            [state.position_rad, state.speed_rad_s, state.acceleration_rad_s2]
        })
    }

    /// Returns the instant of the highest speed in the first cycle \[s\].
    pub(crate) fn fastest_s(&self) -> f64 {
        let samples = 2000;
        let instants = (0..=samples).map(|k| self.period_s * f64::from(k) / f64::from(samples));
        let speed = |time: f64| self.state(time)[1].abs();
        instants.fold((0.0, -1.0), |best, time| if speed(time) > best.1 { (time, speed(time)) } else { best }).0
    }
}
