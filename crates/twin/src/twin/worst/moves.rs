//! Moves and standstills of the motion, with the instants at which a rigid body would travel farthest.

use crate::scenario::{Reaction, ScenarioId};
use crate::twin::Twin;
use quantities::identified;

identified! {
    /// Direction of the motion at an event.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum MotionDirection {
        /// The position increases.
        Positive = "positive",
        /// The position decreases.
        Negative = "negative",
        /// The setpoint is at rest.
        Standstill = "standstill",
    }
}

/// Longest time after the event that is examined \[s\].
pub(super) const EXAMINED_S: f64 = 2.0;

/// Stretch of the motion in one direction, or at rest, within one segment.
pub(super) struct Stretch {
    pub(super) direction: MotionDirection,
    pub(super) from_s: f64,
    pub(super) until_s: f64,
    /// Largest values of the properties, with their instants.
    pub(super) properties: [(f64, f64); 4],
}

/// Places of the properties of a stretch.
pub(super) const SPEED: usize = 0;
pub(super) const TRAVEL: usize = 1;
pub(super) const POWER: usize = 2;
pub(super) const BEYOND: usize = 3;

/// Speed below which the setpoint is at rest [rad/s].
pub(super) const AT_REST: f64 = 1e-9;

/// Steps of a stretch in which the instant of the farthest end of travel of a rigid body is searched, and the largest number
/// of stretches for which it is.
const FINE: u32 = 128;
const STRETCHES_FINE: usize = 400;

impl Twin<'_> {
    /// Returns the stretches of the first cycle, with the instants of their largest properties.
    pub(super) fn stretches(&self, ends_rad: Option<[f64; 2]>) -> Vec<Stretch> {
        let mut found: Vec<Stretch> = Vec::new();
        let mut segment = usize::MAX;
        for time in self.course.instants() {
            let point = self.course.at(time);
            let speed = point.state[1];
            let direction = match speed {
                _ if speed.abs() < AT_REST => MotionDirection::Standstill,
                _ if speed > 0.0 => MotionDirection::Positive,
                _ => MotionDirection::Negative,
            };
            let [speed_of, travel, power] = self.properties(time);
            let beyond = ends_rad.map_or(f64::NEG_INFINITY, |ends| self.beyond(time, ends));
            let properties = [speed_of, travel, power, beyond];
            match found.last_mut() {
                Some(last) if last.direction == direction && segment == point.segment => {
                    last.until_s = time;
                    for (known, value) in last.properties.iter_mut().zip(properties) {
                        if value > known.0 {
                            *known = (value, time);
                        }
                    }
                }
                _ => found.push(Stretch {
                    direction,
                    from_s: time,
                    until_s: time,
                    properties: properties.map(|value| (value, time)),
                }),
            }
            segment = point.segment;
        }
        // A move lasts from the standstill before it to that behind it.
        let bounds: Vec<[f64; 2]> = found.iter().map(|each| [each.from_s, each.until_s]).collect();
        for (place, stretch) in found.iter_mut().enumerate() {
            if stretch.direction == MotionDirection::Standstill {
                continue;
            }
            let before = place.checked_sub(1).and_then(|place| bounds.get(place));
            stretch.from_s = before.map_or(stretch.from_s, |[_, until_s]| *until_s);
            stretch.until_s = bounds.get(place + 1).map_or(stretch.until_s, |[from_s, _]| *from_s);
        }
        if let Some(ends_rad) = ends_rad.filter(|_| found.len() <= STRETCHES_FINE) {
            for stretch in found.iter_mut().filter(|stretch| stretch.direction != MotionDirection::Standstill) {
                let long = stretch.until_s - stretch.from_s;
                for place in 1..FINE {
                    let time = stretch.from_s + long * f64::from(place) / f64::from(FINE);
                    let value = self.beyond(time, ends_rad);
                    if let Some(known) = stretch.properties.get_mut(BEYOND).filter(|known| value > known.0) {
                        *known = (value, time);
                    }
                }
            }
        }
        found
    }

    /// Returns the position beyond the end ahead if the rigid body stopped from an instant \[rad\], negative within.
    fn beyond(&self, time: f64, [lower, upper]: [f64; 2]) -> f64 {
        let [position, speed, _] = self.course.at(time).state;
        let [_, travel, _] = self.properties(time);
        if speed < 0.0 { lower - position + travel } else { position + travel - upper }
    }

    /// Returns speed, travel of the rigid body after the event, and power of the motion at an instant; at rest the travel
    /// of the unbraked load.
    fn properties(&self, time: f64) -> [f64; 3] {
        let point = self.course.at(time);
        let [position, speed, acceleration] = point.state;
        let Some(local) = self.load.linearised(point.segment, position, speed, acceleration) else {
            return [speed.abs(), 0.0, 0.0];
        };
        let inertia = self.plant.inertia_kgm2 + local.inertia_kgm2;
        let load_nm = local.torque(position, speed);
        let way = if speed.abs() < AT_REST { -load_nm.signum() } else { speed.signum() };
        let rubbed = self.plant.friction_nm + self.plant.viscous_nms * speed.abs() + local.coulomb_nm;
        let free = (-way * load_nm - rubbed) / inertia;
        let power = speed * (inertia * acceleration + load_nm) + speed.abs() * rubbed;
        let reaction = self.setup.scenario.reaction;
        let is_stop = self.setup.scenario.id == ScenarioId::EmergencyStop;
        let travel = match self.machine.brake {
            _ if is_stop && reaction == Reaction::Ramp && self.limits.ramp_rad_s2 > 0.0 => {
                speed * speed / (2.0 * self.limits.ramp_rad_s2)
            }
            Some(brake) if !(is_stop && reaction == Reaction::Coast) => {
                let [closing, at_closing] = glided(speed.abs(), free, brake.closing_s);
                closing + glided(at_closing, free - brake.torque_nm / inertia, EXAMINED_S)[0]
            }
            _ => glided(speed.abs(), free, EXAMINED_S)[0],
        };
        [speed.abs(), travel, power]
    }
}

/// Returns way and final speed of a body under constant acceleration, until it stops or the time ends.
fn glided(speed: f64, acceleration: f64, time: f64) -> [f64; 2] {
    if speed + acceleration * time <= 0.0 {
        let way = if acceleration < 0.0 { speed * speed / (-2.0 * acceleration) } else { 0.0 };
        [way, 0.0]
    } else {
        [speed * time + 0.5 * acceleration * time * time, speed + acceleration * time]
    }
}
