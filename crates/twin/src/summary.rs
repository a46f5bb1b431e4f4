//! Results of a run as figures.

use crate::link::Link;
use crate::plant::Energies;

/// Results of a run, in SI; currents rms of a phase.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Summary {
    /// Simulated time \[s\].
    pub time_s: f64,
    /// Largest following error of the load, setpoint minus position \[rad\].
    pub following_peak_rad: f64,
    /// Root mean square of the following error \[rad\].
    pub following_rms_rad: f64,
    /// Longest time from the end of a move until the load stays near its final position \[s\]; `None` if no move ends.
    pub settling_s: Option<f64>,
    /// Largest deviation of the load at rest from the setpoint \[rad\]: torsion and errors of the gear.
    pub standing_rad: Option<f64>,
    /// Largest motor current \[A\].
    pub current_peak_a: f64,
    /// Root mean square of the motor current \[A\].
    pub current_rms_a: f64,
    /// Largest torque through the gear \[Nm\].
    pub torque_peak_nm: f64,
    /// Root mean square of the torque through the gear \[Nm\].
    pub torque_rms_nm: f64,
    /// Largest motor speed over i [rad/s].
    pub speed_peak_rad_s: f64,
    /// Final temperature of the winding \[K\]; zero without a heat model, as for the following two.
    pub winding_end_k: f64,
    /// Final temperature of the housing \[K\].
    pub housing_end_k: f64,
    /// Largest temperature of the winding \[K\].
    pub winding_peak_k: f64,
    /// Largest state of the overload supervision \[1\].
    pub overload_peak: f64,
    /// Lowest DC link voltage at the lowest supply, and highest at the highest supply \[V\].
    pub link_v: [f64; 2],
    /// Energy balance of the run.
    pub energies: Energies,
    /// Error of the energy balance \[J\].
    pub unaccounted_j: f64,
    /// Energy through the motor, in both directions \[J\].
    pub throughput_j: f64,
    /// Energy from the supply at its lowest voltage \[J\].
    pub supplied_j: f64,
    /// Heat in the braking resistor at the highest voltage of the supply \[J\].
    pub resistor_j: f64,
    /// Number of closings of the brake at rest and on a moving axis.
    pub brake_closings: [u32; 2],
    /// Time from the event of the scenario until the axis is at rest \[s\]; `None` if it does not stop.
    pub stop_s: Option<f64>,
    /// Largest distance from the place of the event until the axis is at rest \[rad\].
    pub stop_rad: Option<f64>,
    /// Farthest ways below the lowest and above the highest position of the motion until the axis is at rest after the event
    /// \[rad\]; `None` without a stop, within the range, or if the cycle does not end where it starts.
    pub beyond_rad: [Option<f64>; 2],
}

/// Results accumulated during a run.
#[derive(Clone, Debug)]
pub(crate) struct Gathered {
    settled_rad: f64,
    following: [f64; 2],
    looks: f64,
    settling: Option<f64>,
    standing: Option<f64>,
    /// Start of the present rest of the setpoint \[s\], and the errors since then \[rad\].
    rest: Option<(f64, Vec<f64>)>,
    current: [f64; 2],
    periods: f64,
    torque: [f64; 2],
    speed: f64,
    temperatures: [f64; 3],
    overload: f64,
    link: [f64; 2],
    stop_from: Option<(f64, f64)>,
    stop: Option<(f64, f64)>,
    stop_way: f64,
    /// Lowest and highest position after the event, until the axis is at rest \[rad\].
    reached: [f64; 2],
}

/// Largest number of errors stored for one rest: a hundred seconds.
const REST_MOST: usize = 200_000;

/// Time between two evaluations of the position \[s\].
const LOOK_S: f64 = 8.0 * crate::twin::PERIOD_S;

impl Gathered {
    pub(crate) const fn new(settled_rad: f64) -> Self {
        Self {
            settled_rad,
            following: [0.0; 2],
            looks: 0.0,
            settling: None,
            standing: None,
            rest: None,
            current: [0.0; 2],
            periods: 0.0,
            torque: [0.0; 2],
            speed: 0.0,
            temperatures: [0.0; 3],
            overload: 0.0,
            link: [f64::INFINITY, 0.0],
            stop_from: None,
            stop: None,
            stop_way: 0.0,
            reached: [f64::INFINITY, f64::NEG_INFINITY],
        }
    }

    /// Returns the largest torque so far \[Nm\].
    pub(crate) const fn torque_nm(&self) -> f64 {
        self.torque[0]
    }

    /// Returns `true` if the axis has come to rest after the event.
    pub(crate) const fn is_stopped(&self) -> bool {
        self.stop.is_some()
    }

    /// Returns the largest distance from the place of the event so far \[rad\].
    pub(crate) fn travel_rad(&self) -> f64 {
        self.stop.map_or(self.stop_way, |(_, way)| way)
    }

    /// Returns the lowest and the highest position after the event so far \[rad\].
    pub(crate) const fn reached_rad(&self) -> [f64; 2] {
        self.reached
    }

    /// Returns the lowest DC link voltage so far \[V\].
    pub(crate) const fn link_low_v(&self) -> f64 {
        self.link[0]
    }

    /// Evaluates the position, at the rate of the position loop.
    pub(crate) fn update(&mut self, time: f64, wanted: &[f64; 3], position: f64) {
        let [place, speed, acceleration] = *wanted;
        let error = place - position;
        self.following[0] = self.following[0].max(error.abs());
        self.following[1] += error * error;
        self.looks += 1.0;
        let stands = speed == 0.0 && acceleration == 0.0;
        match (&mut self.rest, stands) {
            (Some((_, errors)), true) if errors.len() < REST_MOST => errors.push(error),
            (None, true) => self.rest = Some((time, vec![error])),
            (Some(_), true) | (None, false) => {}
            (Some(_), false) => {
                if let Some(rest) = self.rest.take() {
                    self.rested(&rest.1, rest.0 > 0.0);
                }
            }
        }
    }

    /// Evaluates a rest that has ended; after a move its settling time counts.
    fn rested(&mut self, errors: &[f64], after_move: bool) {
        let Some(last) = errors.last() else { return };
        self.standing = Some(self.standing.unwrap_or(0.0).max(last.abs()));
        if after_move {
            let outside = errors.iter().rposition(|error| (error - last).abs() > self.settled_rad);
            #[allow(clippy::cast_precision_loss, reason = "at most 200 000")]
            let settling = outside.map_or(0.0, |place| (place + 1) as f64 * LOOK_S);
            self.settling = Some(self.settling.unwrap_or(0.0).max(settling));
        }
    }

    /// Evaluates one period of the current loop.
    #[inline]
    pub(crate) fn each(&mut self, square_a2: f64, torque: f64, speed: f64, [low_v, high_v]: [f64; 2]) {
        self.current[0] = self.current[0].max(square_a2);
        self.current[1] += square_a2;
        self.periods += 1.0;
        self.torque[0] = self.torque[0].max(torque.abs());
        self.torque[1] += torque * torque;
        self.speed = self.speed.max(speed.abs());
        self.link = [self.link[0].min(low_v), self.link[1].max(high_v)];
    }

    /// Evaluates temperatures and overload, once a millisecond.
    pub(crate) fn warm(&mut self, winding: f64, housing: f64, overload: f64) {
        self.temperatures = [winding, housing, self.temperatures[2].max(winding)];
        self.overload = self.overload.max(overload);
    }

    /// Evaluates the stop after the event of a scenario; returns `true` if the axis is at rest so far. An axis under
    /// gravity is at rest for a moment before it sags.
    pub(crate) fn stop(&mut self, time: f64, happened: bool, rests: bool, position: f64) -> bool {
        if !happened {
            return false;
        }
        let (since, place) = *self.stop_from.get_or_insert((time, position));
        if self.stop.is_none() {
            self.stop_way = self.stop_way.max((position - place).abs());
            self.reached = [self.reached[0].min(position), self.reached[1].max(position)];
        }
        // The first instant of rest counts, unless the axis moves again.
        if rests && self.stop.is_none() && time > since + 0.01 {
            self.stop = Some((time - since, self.stop_way));
        } else if !rests && self.stop.is_some() {
            self.stop = None;
        }
        self.stop.is_some()
    }

    pub(crate) fn summary(
        &self,
        energies: &Energies,
        unaccounted_j: f64,
        [link, link_high]: [&Link; 2],
        time_s: f64,
        brake_closings: [u32; 2],
        happens: Option<f64>,
    ) -> Summary {
        let mut last = self.clone();
        if let Some((since, errors)) = last.rest.take() {
            last.rested(&errors, since > 0.0);
        }
        let mean = |sum: f64, count: f64| if count > 0.0 { (sum / count).sqrt() } else { 0.0 };
        Summary {
            time_s,
            following_peak_rad: last.following[0],
            following_rms_rad: mean(last.following[1], last.looks),
            settling_s: last.settling,
            standing_rad: last.standing,
            current_peak_a: last.current[0].sqrt(),
            current_rms_a: mean(last.current[1], last.periods),
            torque_peak_nm: last.torque[0],
            torque_rms_nm: mean(last.torque[1], last.periods),
            speed_peak_rad_s: last.speed,
            winding_end_k: last.temperatures[0],
            housing_end_k: last.temperatures[1],
            winding_peak_k: last.temperatures[2],
            overload_peak: last.overload,
            link_v: last.link,
            energies: *energies,
            unaccounted_j,
            throughput_j: energies.throughput(),
            supplied_j: link.supplied_j,
            resistor_j: link_high.brake_j,
            brake_closings,
            stop_s: happens.and(last.stop).map(|(time, _)| time),
            stop_rad: happens.and(last.stop).map(|(_, way)| way),
            beyond_rad: [None; 2],
        }
    }
}
