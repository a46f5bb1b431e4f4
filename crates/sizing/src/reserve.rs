//! How far an axis may be changed until an actuator just fits: load, payload, cycle time, ambient temperature.

use crate::axis::Axis;
use crate::checks::{Depth, judge};
use actuator::Parameters;
use quantities::{Mass, Measure, ThermodynamicTemperature, Time};

/// The largest change of one quantity, all others as they are, with which an actuator fits.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reserve {
    /// Factor on all inertias and masses of the load, payloads included; friction and process forces stay.
    pub load_factor: Option<f64>,
    /// Factor on the payloads of the segments alone, if there are any.
    pub payload_factor: Option<f64>,
    /// Shortest cycle: the whole motion, pauses too, run through faster or slower.
    pub cycle_time: Option<Time>,
    /// Highest ambient temperature.
    pub ambient: Option<ThermodynamicTemperature>,
}

/// Factors looked at: beyond, nobody asks.
const FACTOR_MOST: f64 = 1e3;

/// The search walks in steps of a tenth, so a gap narrower than that between two regions that fit may be passed over.
const STEP: f64 = 1.1;

/// Halvings of the last step: 30 leave 10⁻¹⁰ of it.
const HALVINGS: usize = 30;

/// Ambient temperatures looked at, −20 °C to 80 °C, in kelvin.
const AMBIENT_RANGE: (f64, f64) = (253.15, 353.15);

/// Step of the search, in kelvin.
const AMBIENT_STEP: f64 = 5.0;

/// Searches the reserves of an actuator for an axis, each on the same checks that judge it.
///
/// Cost: some sixty judgements for each of the quantities, with the motion prepared anew.
#[must_use]
pub fn reserve(axis: &Axis, actuator: &Parameters) -> Reserve {
    let fits = |changed: &Axis| judge(changed, actuator, Depth::Margins).fits();
    let load = |factor: f64| fits(&axis.with_load(factor, factor));
    let payload = |factor: f64| fits(&axis.with_load(1.0, factor));
    // A faster cycle is a smaller factor on the time.
    let faster = |factor: f64| fits(&axis.with_time(1.0 / factor));
    let carries = axis.extras.iter().any(|extra| extra.mass.si() > 0.0 || extra.inertia.si() > 0.0);
    if matches!(axis.mechanism.kind, mechanism::Kind::Joint(_)) {
        // Recorded torques say nothing about another load or another pace.
        return Reserve { ambient: highest_ambient(axis, &fits), ..Reserve::default() };
    }
    Reserve {
        load_factor: largest(load),
        payload_factor: carries.then(|| largest(payload)).flatten(),
        cycle_time: largest(faster).map(|factor| Time::from_si(axis.moments().duration.si() / factor)),
        ambient: highest_ambient(axis, &fits),
    }
}

/// The largest factor from which nothing fits any more, walking up from what fits or down from what does not;
/// `None` if nothing near fits, or everything does.
fn largest(fits: impl Fn(f64) -> bool) -> Option<f64> {
    let mut factor = 1.0;
    if fits(factor) {
        while fits(factor * STEP) {
            factor *= STEP;
            if factor > FACTOR_MOST {
                return None;
            }
        }
        return Some(bisect(fits, factor, factor * STEP));
    }
    while factor > 1.0 / FACTOR_MOST {
        if fits(factor / STEP) {
            return Some(bisect(fits, factor / STEP, factor));
        }
        factor /= STEP;
    }
    None
}

/// The border between what fits at `good` and what does not at `bad`, on the side that fits.
fn bisect(fits: impl Fn(f64) -> bool, mut good: f64, mut bad: f64) -> f64 {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (good + bad);
        if fits(middle) {
            good = middle;
        } else {
            bad = middle;
        }
    }
    good
}

fn highest_ambient(axis: &Axis, fits: &impl Fn(&Axis) -> bool) -> Option<ThermodynamicTemperature> {
    let at = |kelvin: f64| fits(&Axis { ambient: Some(ThermodynamicTemperature::from_si(kelvin)), ..axis.clone() });
    let (low, high) = AMBIENT_RANGE;
    // From above: the highest region that fits.
    let mut kelvin = high;
    while kelvin >= low {
        if at(kelvin) {
            return Some(ThermodynamicTemperature::from_si(bisect(at, kelvin, kelvin + AMBIENT_STEP)));
        }
        kelvin -= AMBIENT_STEP;
    }
    None
}

impl Axis {
    /// The same axis with other masses and inertias: a factor on those of the load and one on the payloads.
    fn with_load(&self, load: f64, payload: f64) -> Self {
        let extras = self
            .extras
            .iter()
            .map(|extra| mechanism::Extra {
                mass: Mass::from_si(extra.mass.si() * payload),
                inertia: quantities::MomentOfInertia::from_si(extra.inertia.si() * payload),
                ..*extra
            })
            .collect();
        self.changed(Self::new(self.mechanism.with_masses(load), self.motion.clone(), extras))
    }

    /// The same axis with its motion run through in another time.
    fn with_time(&self, factor: f64) -> Self {
        self.changed(Self::new(self.mechanism.clone(), self.motion.stretched(factor), self.extras.clone()))
    }

    /// What is asked stays.
    fn changed(&self, prepared: Self) -> Self {
        Self {
            ambient: self.ambient,
            bearing: self.bearing.clone(),
            supply: self.supply,
            asked: self.asked.clone(),
            ..prepared
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mechanism::Mechanism;
    use motion::{Closing, ManualMove, Motion, SegmentSpec};
    use provenance::{Datum, Grade, Source, Sourced};
    use quantities::{Angle, AngularVelocity, MomentOfInertia, Torque};

    fn known<T>(value: T) -> Datum<T> {
        let source = Source::Project { key: "test".into() };
        Datum::Known(Sourced { value, source, grade: Grade::Printed, errata: &[] })
    }

    fn axis(inertia: f64) -> Axis {
        let s = Time::from_si;
        let only = SegmentSpec::Manual(ManualMove {
            speed: AngularVelocity::from_si(4.0),
            accelerate: s(0.1),
            run: s(0.1),
            brake: s(0.1),
            pause: s(1.0),
        });
        let motion = Motion::new(&[only], Some(Angle::from_si(0.0)), Closing::Speed).unwrap();
        Axis::new(Mechanism::direct(MomentOfInertia::from_si(inertia), Torque::from_si(5.0)), motion, Vec::new())
    }

    /// Only T_max = 105 Nm limits: (J_L + 0.5)·40 + 5 = 105 Nm at J_L = 2.0 kgm².
    fn actuator() -> Parameters {
        Parameters {
            torque_max: known(Torque::from_si(105.0)),
            inertia_out: known(MomentOfInertia::from_si(0.5)),
            ..Parameters::unknown()
        }
    }

    #[test]
    fn the_border_by_hand_from_both_sides() {
        for inertia in [1.0, 1.999, 2.001, 8.0] {
            let found = reserve(&axis(inertia), &actuator());
            assert!((found.load_factor.unwrap() * inertia - 2.0).abs() < 1e-9, "{inertia}: {found:?}");
            assert_eq!(found.payload_factor, None, "there is no payload");
        }
        // (1.0 + 0.5)·40/f² + 5 = 105: the time may shrink to √0.6 of 1.3 s.
        let found = reserve(&axis(1.0), &actuator());
        assert!((found.cycle_time.unwrap().si() - 1.3 * 0.6_f64.sqrt()).abs() < 1e-9, "{found:?}");
    }

    #[test]
    fn at_the_border_the_actuator_fits_and_beyond_it_does_not() {
        let axis = axis(1.3);
        let factor = reserve(&axis, &actuator()).load_factor.unwrap();
        let fits = |factor: f64| judge(&axis.with_load(factor, factor), &actuator(), Depth::Full).fits();
        assert!(fits(factor) && !fits(factor * (1.0 + 1e-9)));
    }

    #[test]
    fn where_nothing_helps_nothing_is_promised() {
        let weak = Parameters { torque_max: known(Torque::from_si(4.0)), ..actuator() };
        let found = reserve(&axis(1.0), &weak);
        assert_eq!((found.load_factor, found.cycle_time), (None, None), "friction alone is too much");
    }
}
