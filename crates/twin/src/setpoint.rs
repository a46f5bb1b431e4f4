//! Setpoints from the motion of the project, repeated over the cycles.

use crate::scenario::Part;
use motion::{Hold, Motion, Piece};
use quantities::{Angle, Measure};

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

/// A repeated motion, or a part of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Course<'a> {
    motion: &'a Motion,
    /// Time of the motion at which the run begins, and the duration of the run \[s\].
    part: Part,
    period_s: f64,
    net_rad: f64,
    cycles: f64,
    /// The axis moves at the first instant of a cycle.
    pub(crate) begins_in_motion: bool,
    /// The axis moves through the end of a cycle into the next one without a step of the speed.
    runs_on: bool,
}

/// Largest speed at the beginning of a cycle that counts as rest, relative to its largest speed \[1\]. A choice: recorded
/// speeds scatter.
const RESTS: f64 = 1e-3;

/// Largest difference between the speeds at both ends of a cycle that runs on without a step, relative to the speed at
/// its beginning \[1\]. A choice: recorded speeds scatter.
const RUNS_ON: f64 = 0.02;

impl<'a> Course<'a> {
    pub(crate) fn of(motion: &'a Motion, cycles: u32, part: Option<Part>) -> Self {
        let (period_s, net_rad) = (motion.duration().si(), motion.net().si());
        let cycles = f64::from(cycles.max(1));
        let part = part.unwrap_or(Part { from_s: 0.0, for_s: period_s * cycles });
        let course = Self { motion, part, period_s, net_rad, cycles, begins_in_motion: false, runs_on: false };
        let speed = |time: f64| course.state(time)[1];
        let moves = |speed_at: f64| speed_at != 0.0 && speed_at.abs() > RESTS * speed(course.fastest_s()).abs();
        let [begin, end] = [speed(0.0), speed(period_s)];
        let runs_on = moves(begin) && (end - begin).abs() <= RUNS_ON * begin.abs();
        let course = Self { runs_on, ..course };
        let begins_in_motion = if part.from_s > 0.0 { moves(course.at(0.0).state[1]) } else { moves(begin) };
        Self { begins_in_motion, ..course }
    }

    /// Returns the duration of the run along the motion: all cycles, or the part \[s\].
    pub(crate) const fn duration_s(&self) -> f64 {
        self.part.for_s
    }

    /// Returns the setpoint at a time. Before the first cycle an axis that begins in motion runs up: through the cycle
    /// before, if its end joins, otherwise at constant speed. After the last cycle it runs on if its end joins, otherwise
    /// it is at rest. Before and after a part the motion itself continues.
    pub(crate) fn at(&self, run_s: f64) -> SetPoint {
        let time_s = self.part.from_s + run_s;
        let cycle = (time_s / self.period_s).floor();
        let cycle = if self.runs_on { cycle } else { cycle.clamp(0.0, self.cycles - 1.0) };
        let is_over = !self.runs_on && time_s >= self.period_s * self.cycles;
        let time = (time_s - cycle * self.period_s).clamp(0.0, self.period_s);
        let stretches = self.motion.stretches();
        let segment = stretches.partition_point(|each| each.start.si() <= time).saturating_sub(1);
        let braked = stretches.get(segment).filter(|each| each.hold == Hold::Brake).map(|each| {
            let since = time - each.start.si();
            [since, each.duration.si() - since]
        });
        let [position, speed, acceleration] = self.state(time);
        let state = if !self.runs_on && time_s < 0.0 {
            [position + speed * time_s, speed, 0.0]
        } else {
            [
                position + cycle * self.net_rad,
                if is_over { 0.0 } else { speed },
                if is_over { 0.0 } else { acceleration },
            ]
        };
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

    /// Returns the largest |α| of the motion, whatever its laws and recordings [rad/s²].
    pub(crate) fn steepest_rad_s2(&self) -> f64 {
        let laws = self.motion.pieces().iter().map(Piece::acceleration_peak_rad_s2);
        let recorded = self.motion.recordings().iter().flat_map(|placed| {
            (0..placed.intervals()).filter_map(|index| Some(placed.interval(index)?.acceleration_rad_s2().abs()))
        });
        laws.chain(recorded).fold(0.0, f64::max)
    }

    /// Returns the lowest and the highest position of the motion \[rad\]; `None` if the cycle does not end where it
    /// starts, so that the axis has no ends.
    pub(crate) fn ends_rad(&self) -> Option<[f64; 2]> {
        let laws =
            self.motion.pieces().iter().flat_map(|piece| {
                (0..=8).map(|eighth| piece.at(piece.duration_s * f64::from(eighth) / 8.0).position_rad)
            });
        let recorded = self.motion.recordings().iter().flat_map(|placed| {
            (0..placed.intervals())
                .filter_map(|index| placed.interval(index))
                .flat_map(|interval| [0.0, 1.0].map(|share| interval.at(share).0))
        });
        let mut travelled = 0.0;
        let mut last = None;
        let mut ends = [f64::INFINITY, f64::NEG_INFINITY];
        for position in laws.chain(recorded) {
            travelled += last.replace(position).map_or(0.0, |last: f64| (position - last).abs());
            ends = [ends[0].min(position), ends[1].max(position)];
        }
        let returns = self.motion.ends_where_it_starts(Angle::from_si(travelled), Angle::from_si(ends[1] - ends[0]));
        (ends[1] > ends[0] && returns).then_some(ends)
    }

    /// Returns beginning and duration of the first cycle, or of the part, as times of the motion \[s\].
    fn first_cycle(&self) -> [f64; 2] {
        if self.part.from_s > 0.0 {
            [self.part.from_s, self.part.for_s]
        } else {
            [0.0, self.period_s.min(self.part.for_s)]
        }
    }

    /// Returns the duration of the first cycle, or of the part \[s\].
    pub(crate) fn first_cycle_s(&self) -> f64 {
        self.first_cycle()[1]
    }

    /// Returns the instant of the highest speed in the first cycle, or in the part \[s\].
    pub(crate) fn fastest_s(&self) -> f64 {
        let samples = 2000;
        let [from, long] = self.first_cycle();
        let instants = (0..=samples).map(|k| long * f64::from(k) / f64::from(samples));
        let speed = |time: f64| self.state(from + time)[1].abs();
        instants.fold((0.0, -1.0), |best, time| if speed(time) > best.1 { (time, speed(time)) } else { best }).0
    }

    /// Returns the first instant at rest in the first cycle, or in the part; zero if there is none \[s\].
    pub(crate) fn rest_s(&self) -> f64 {
        self.instants().into_iter().find(|time| self.at(*time).state[1].abs() < 1e-9).unwrap_or(0.0)
    }

    /// Returns the instants of the first cycle, or of the part, at which the motion is examined \[s\]: those of
    /// every segment, of the pieces of its law and of its recording, at most [`INSTANTS_MOST`] of each recording.
    pub(crate) fn instants(&self) -> Vec<f64> {
        let [from, long] = self.first_cycle();
        let mut found = vec![0.0];
        for stretch in self.motion.stretches() {
            let (start, duration) = (stretch.start.si(), stretch.duration.si());
            found.extend([0.0, 0.5, 1.0].map(|share| start + share * duration - from));
        }
        let pieces = self.motion.pieces();
        let each = pieces.len().div_ceil(INSTANTS_MOST / 4).max(1);
        for piece in pieces.iter().step_by(each) {
            found.extend([0.0, 0.25, 0.5, 0.75, 1.0].map(|share| piece.start_s + share * piece.duration_s - from));
        }
        for placed in self.motion.recordings() {
            let each = placed.intervals().div_ceil(INSTANTS_MOST).max(1);
            let starts = (0..placed.intervals()).step_by(each).filter_map(|index| placed.interval(index));
            found.extend(starts.map(|interval| interval.start_s - from));
        }
        found.retain(|time| (0.0..long).contains(time));
        found.sort_by(f64::total_cmp);
        found.dedup();
        found
    }
}

/// Largest number of instants of laws, and of each recording.
const INSTANTS_MOST: usize = 20_000;
