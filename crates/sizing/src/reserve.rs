//! Permissible changes of an axis until an actuator just fits: load, payload, cycle time, ambient temperature.

mod ambient;

use crate::axis::Axis;
use crate::brake_times::carried;
use crate::check::{Check, CheckId, Fit, Verdict};
use crate::judge::{Judgement, Proviso, Scope, judge};
use crate::observer::{StepObserver, Unobserved, finished};
use actuator::{HeatModel, Parameters};
use ambient::ambient_region;
use numeric::border;
use quantities::unit::{DEGREE_CELSIUS, ONE, SECOND};
use quantities::{Mass, Measure, ThermodynamicTemperature, Time, Unit};
use std::cell::RefCell;

/// Permissible change of one quantity, rounded to its displayed digits: with this value no check fails.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reach<T> {
    /// Value.
    pub value: T,
    /// Verdict of the checks with it: that an actuator fits, or that it fits if an estimate holds.
    pub fit: Fit,
    /// Conditions of this verdict.
    pub proviso: Proviso,
}

/// Largest change of each quantity, with all others unchanged, for which no check of an actuator fails.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reserve {
    /// Factor on all inertias and masses of the load, payloads included; friction and process forces are unchanged.
    pub load_factor: Option<Reach<f64>>,
    /// Factor on the payloads of the segments alone, if there are any.
    pub payload_factor: Option<Reach<f64>>,
    /// Shortest cycle time: the whole motion, dwells included, run faster or slower.
    pub cycle_time: Option<Reach<Time>>,
    /// Lowest ambient temperature of those about the present one, or of the nearest ones at which the actuator fits.
    pub ambient_least: Option<Reach<ThermodynamicTemperature>>,
    /// Highest ambient temperature of the same.
    pub ambient: Option<Reach<ThermodynamicTemperature>>,
    /// Changes that were not searched because of their cost.
    pub unsought: Option<Unsought>,
}

impl Reserve {
    /// Returns the reserve without the changes of load, payload and cycle time.
    #[must_use]
    pub const fn without_changes(&self) -> Self {
        Self { load_factor: None, payload_factor: None, cycle_time: None, ..*self }
    }
}

/// Changes of the load, and possibly of the pace, that were not searched: each step would compute the load of a long
/// recording again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unsought {
    /// The cycle time was not searched; load and payloads never were.
    pub pace: bool,
    /// Work of each step in samples of a recording, above the limit without a deadline.
    pub samples: usize,
}

/// Largest number of samples whose load the steps of the search compute again without a deadline: some twenty steps,
/// forty with payloads, at 1.5 µs for a sample of noise under losses.
pub const SAMPLES_ANEW: usize = 50_000;

/// Work of an instant of a motion law, or of the loads on the flange, in samples whose load is computed again.
const AN_INSTANT: f64 = 0.25;

/// Range of the factors.
const FACTOR_MOST: f64 = 1e3;

/// Steps of the search: a tenth up to a factor of two, then larger ones, since only the order of magnitude is useful
/// there. A gap narrower than a step between two fitting regions may be missed.
const STEPS: [(f64, f64); 3] = [(2.0, 1.1), (10.0, 1.25), (f64::INFINITY, 1.6)];

/// Distance of the two sides of the border as a share of a step: some 10⁻⁴ of the value, about the last displayed digit.
const NARROW: f64 = 1.0 / (1_u64 << 12) as f64;

/// Digits of a displayed value.
const DIGITS: i32 = 4;

/// Smallest displayed step of a temperature \[K\].
const TEMPERATURE_DIGIT: f64 = 0.01;

/// Number of steps of the last digit from a border in which the displayed value is searched: one unless the fitting
/// region is narrower than the digit.
const TRIALS: u32 = 3;

/// Ambient temperature of an actuator without a heat model \[K\].
const AMBIENT_USUAL: f64 = 313.15;

/// Searches the reserves of an actuator for an axis, with the checks that judge it.
///
/// Cost: a judgement for each step of the walk and some four more for each of the quantities where their excess is smooth, at
/// most twenty, with the motion prepared anew for each.
#[must_use]
pub fn reserve(axis: &Axis, actuator: &Parameters) -> Reserve {
    finished(reserve_watched(axis, actuator, usize::MAX, &Unobserved))
}

/// Searches the reserves with cancellation; changes for which each step computes the load of more than `most` samples
/// again are not searched.
///
/// # Errors
/// The reason of a cancellation.
pub fn reserve_watched<W: StepObserver>(
    axis: &Axis,
    actuator: &Parameters,
    most: usize,
    watch: &W,
) -> Result<Reserve, W::Stop> {
    let judged = |axis: &Axis| -> Result<Judgement, W::Stop> {
        watch.step()?;
        Ok(judge(axis, actuator, Scope::Deciding))
    };
    let duration = axis.moments().duration.si();
    let load = Search::of(&ONE, true, |factor: f64| judged(&axis.with_load(factor, factor)));
    let payload = Search::of(&ONE, true, |factor: f64| judged(&axis.with_load(1.0, factor)));
    let pace = Search::of(&SECOND, false, |cycle: f64| judged(&axis.with_time(cycle / duration)));
    // Temperatures that are not stated are assumed to be the highest permissible one.
    let reference = || HeatModel::of(actuator).ok().map(|heat| heat.ambient_reference());
    let present_k = axis.ambient.or_else(reference).map_or(AMBIENT_USUAL, Measure::si);
    let ambient = || -> Result<[Option<Reach<_>>; 2], W::Stop> {
        // A long axis is copied once.
        let warmer = RefCell::new(axis.clone());
        let at = |kelvin: f64| {
            let mut warmer = warmer.borrow_mut();
            warmer.ambient = Some(ThermodynamicTemperature::from_si(kelvin));
            judged(&warmer)
        };
        let upper = Search { least_digit: TEMPERATURE_DIGIT, ..Search::of(&DEGREE_CELSIUS, true, &at) };
        let lower = Search {
            worse_above: false,
            ..Search { least_digit: TEMPERATURE_DIGIT, ..Search::of(&DEGREE_CELSIUS, true, &at) }
        };
        let [least, most] =
            ambient_region(present_k, NARROW, |kelvin| Ok(excess(&upper.judged(kelvin)?)))?.unwrap_or_default();
        let kelvin = ThermodynamicTemperature::from_si;
        let ends = [
            least.map_or(Ok(None), |border| lower.shown(border, kelvin))?,
            most.map_or(Ok(None), |border| upper.shown(border, kelvin))?,
        ];
        Ok(ends)
    };
    let carries = axis.extras.iter().any(|extra| extra.mass.si() > 0.0 || extra.inertia.si() > 0.0);
    if matches!(axis.mechanism.kind, mechanism::MechanismKind::Joint(_)) {
        // Recorded torques do not apply to another load or another pace.
        let [ambient_least, ambient] = ambient()?;
        return Ok(Reserve { ambient_least, ambient, ..Reserve::default() });
    }
    let now = judge(axis, actuator, Scope::Deciding);
    let fails = |of: fn(CheckId) -> bool| now.checks.iter().any(|check| check.verdict == Verdict::Fail && of(check.id));
    if fails(CheckId::is_of_the_place) {
        // A failed check that depends on neither load nor pace cannot pass by changing them.
        let [ambient_least, ambient] = ambient()?;
        return Ok(Reserve { ambient_least, ambient, ..Reserve::default() });
    }
    let here = excess(&now);
    let [other_load, other_pace] = axis.found_anew();
    let seeks = [other_load <= most, other_pace <= most];
    // A speed that is too high is so under any load and at any temperature.
    let too_fast = fails(CheckId::is_of_the_pace);
    let of_loads = || match seeks {
        [true, _] if !too_fast => Ok((load.factor(here)?, if carries { payload.factor(here)? } else { None })),
        _ => Ok((None, None)),
    };
    let of_the_pace = || {
        // A faster cycle is a smaller factor on the time.
        let faster = largest(here, |factor| Ok(excess(&pace.judged(duration / factor)?)))?;
        faster.map_or(Ok(None), |(good, bad)| pace.shown((duration / good, duration / bad), Time::from_si))
    };
    let cycle_time = || if seeks[1] { of_the_pace() } else { Ok(None) };
    let of_others = || Ok((cycle_time()?, if too_fast { [None; 2] } else { ambient()? }));
    // If a change of the pace is too expensive, so is one of the load.
    let unsought = (!seeks[0] && (!too_fast || !seeks[1])).then_some(Unsought { pace: !seeks[1], samples: other_load });
    let (loads, others): (Result<_, W::Stop>, Result<_, W::Stop>) = if axis.is_short() {
        // Starting a thread would take as long as the work.
        (of_loads(), of_others())
    } else {
        std::thread::scope(|scope| {
            let others = std::thread::Builder::new().spawn_scoped(scope, of_others).ok();
            let loads = of_loads();
            // If no thread is available, as in a browser, or it could not finish, its part is done here.
            (loads, others.and_then(|others| others.join().ok()).unwrap_or_else(of_others))
        })
    };
    let ((load_factor, payload_factor), (cycle_time, [ambient_least, ambient])) = (loads?, others?);
    Ok(Reserve { load_factor, payload_factor, cycle_time, ambient_least, ambient, unsought })
}

/// Judgements of an actuator under changes of one quantity.
struct Search<F> {
    /// Display unit of the quantity.
    unit: &'static Unit,
    /// Larger values are beyond the border; otherwise smaller ones.
    worse_above: bool,
    /// Smallest step of the displayed value in its unit; zero if it has [`DIGITS`] however small it is.
    least_digit: f64,
    at: F,
}

impl<F> Search<F> {
    const fn of(unit: &'static Unit, worse_above: bool, at: F) -> Self {
        Self { unit, worse_above, least_digit: 0.0, at }
    }
}

impl<S, F: Fn(f64) -> Result<Judgement, S>> Search<F> {
    /// Returns the judgement with a value in SI.
    fn judged(&self, si: f64) -> Result<Judgement, S> {
        (self.at)(si)
    }

    /// Returns the largest factor for which no check fails.
    fn factor(&self, here: f64) -> Result<Option<Reach<f64>>, S> {
        let border = largest(here, |factor| Ok(excess(&self.judged(factor)?)))?;
        border.map_or(Ok(None), |border| self.shown(border, |factor| factor))
    }

    /// Returns the last value of the displayed digits before the border for which no check fails, judged as it is displayed;
    /// the next one, where it is not beyond the `bad` side, has been judged not to fit.
    fn shown<T>(&self, border: (f64, f64), of: impl Fn(f64) -> T) -> Result<Option<Reach<T>>, S> {
        let fits = |si: f64| {
            let judgement = self.judged(si)?;
            let (fit, proviso) = (judgement.fit(), judgement.proviso());
            Ok(fit.fits().then(|| Reach { value: of(si), fit, proviso }))
        };
        let shown = displayed(border, (self.unit, self.worse_above, self.least_digit), fits)?;
        Ok(shown.map(|(_, reach)| reach))
    }
}

/// Returns the last value of the displayed digits before a border for which `fits` has a result, and this result; of
/// `(unit, worse_above, least_digit)` see [`Search`].
fn displayed<T, S>(
    (good, bad): (f64, f64),
    (unit, worse_above, least_digit): (&Unit, bool, f64),
    mut fits: impl FnMut(f64) -> Result<Option<T>, S>,
) -> Result<Option<(f64, T)>, S> {
    let (good, bad) = (unit.from_si(good), unit.from_si(bad));
    let exponent = if good == 0.0 { 0.0 } else { good.abs().log10().floor() };
    let digit = 10_f64.powf(exponent - f64::from(DIGITS - 1)).max(least_digit);
    // Towards the good side.
    let inward = if worse_above { -1.0 } else { 1.0 };
    let (mut steps, last) = if worse_above {
        ((bad / digit).ceil() - 1.0, (good / digit).floor())
    } else {
        ((bad / digit).floor() + 1.0, (good / digit).ceil())
    };
    let last = last + inward * f64::from(TRIALS);
    while (last - steps) * inward > 0.0 {
        // A division by a whole number of digits: 1.341, not 1.3410000000000002.
        let si = unit.to_si(if digit < 1.0 { steps / (1.0 / digit).round() } else { steps * digit });
        if let Some(found) = fits(si)? {
            return Ok(Some((si, found)));
        }
        steps += inward;
    }
    Ok(None)
}

/// Quantity of an axis that is changed with all others unchanged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AxisChange {
    /// Factor on all inertias and masses of the load, payloads included.
    Load,
    /// Factor on the payloads of the segments alone.
    Payload,
    /// Duration of the cycle: the whole motion, dwells included, runs slower.
    CycleTime,
}

/// Number of halvings of a step of the search: the last displayed digit.
const HALVINGS: u32 = 12;

/// Searches the smallest reduction of the load, or the shortest longer cycle, for which `fits` has a result, where it has
/// none for the axis as it is. Returns the factor, or the duration in SI, rounded to its displayed digits and judged with
/// them; `None` if no change up to a factor of a thousand suffices, if the quantity has no effect, or if each step would
/// compute the load of more than `most` samples again.
///
/// A gap narrower than a step of the search, a tenth up to a factor of two, may be missed.
///
/// # Errors
/// The reason of a cancellation, from `fits`.
pub fn nearest_change<T, S>(
    axis: &Axis,
    change: AxisChange,
    most: usize,
    mut fits: impl FnMut(Axis) -> Result<Option<T>, S>,
) -> Result<Option<(f64, T)>, S> {
    let [other_load, other_pace] = axis.found_anew();
    let carries = axis.extras.iter().any(|extra| extra.mass.si() > 0.0 || extra.inertia.si() > 0.0);
    let (work, has_effect) = match change {
        AxisChange::Load => (other_load, true),
        AxisChange::Payload => (other_load, carries),
        AxisChange::CycleTime => (other_pace, true),
    };
    // Recorded torques do not apply to another load or another pace.
    if !has_effect || work > most || matches!(axis.mechanism.kind, mechanism::MechanismKind::Joint(_)) {
        return Ok(None);
    }
    let duration = axis.moments().duration.si();
    let (unit, worse_above) = if change == AxisChange::CycleTime { (&SECOND, false) } else { (&ONE, true) };
    let value = |factor: f64| if change == AxisChange::CycleTime { duration / factor } else { factor };
    let mut at = |si: f64| {
        fits(match change {
            AxisChange::Load => axis.with_load(si, si),
            AxisChange::Payload => axis.with_load(1.0, si),
            AxisChange::CycleTime => axis.with_time(si / duration),
        })
    };
    // If the load is not the reason, none of its factors is sought.
    if change != AxisChange::CycleTime && at(value(1.0 / FACTOR_MOST))?.is_none() {
        return Ok(None);
    }
    let mut factor = 1.0;
    while factor > 1.0 / FACTOR_MOST {
        let farther = factor / step(1.0 / factor);
        if at(value(farther))?.is_some() {
            let (mut good, mut bad) = (farther, factor);
            for _ in 0..HALVINGS {
                let middle = f64::midpoint(good, bad);
                if at(value(middle))?.is_some() { good = middle } else { bad = middle }
            }
            return displayed((value(good), value(bad)), (unit, worse_above, 0.0), at);
        }
        factor = farther;
    }
    Ok(None)
}

/// Returns the distance of an actuator from failing: above zero a check fails.
///
/// The largest share of the edges above which checks fail, minus one, as far as it agrees with the verdict. If a limit
/// of zero is exceeded among others, the distance of the others is used.
fn excess(judgement: &Judgement) -> f64 {
    let most = |of: fn(&Check) -> bool| {
        let shares = judgement.checks.iter().filter(|check| of(check)).filter_map(|check| check.share_of_failure());
        shares.reduce(f64::max).map(|share| share - 1.0)
    };
    if judgement.fits() {
        return most(|check| check.id.has_margin()).unwrap_or(-1.0).min(0.0);
    }
    most(|check| check.verdict == Verdict::Fail).map_or(f64::INFINITY, |excess| excess.max(f64::EPSILON))
}

/// Returns both sides of the largest factor beyond which the actuator does not fit, searched upwards from a fitting one or
/// downwards from one that does not fit; `None` if no factor nearby fits, or all of them do. `now` is the excess at a factor of
/// one.
fn largest<S>(now: f64, excess: impl Fn(f64) -> Result<f64, S>) -> Result<Option<(f64, f64)>, S> {
    let (mut factor, mut here) = (1.0, now);
    if here <= 0.0 {
        loop {
            let farther = factor * step(factor);
            let next = excess(farther)?;
            if next > 0.0 {
                return border(excess, (factor, here), (farther, next), NARROW).map(Some);
            }
            (factor, here) = (farther, next);
            if factor > FACTOR_MOST {
                return Ok(None);
            }
        }
    }
    while factor > 1.0 / FACTOR_MOST {
        let farther = factor / step(1.0 / factor);
        let next = excess(farther)?;
        if next <= 0.0 {
            return border(excess, (farther, next), (factor, here), NARROW).map(Some);
        }
        (factor, here) = (farther, next);
    }
    Ok(None)
}

/// Returns the step of the search at a factor of one or more.
fn step(factor: f64) -> f64 {
    STEPS.iter().find(|(until, _)| factor < *until).map_or(1.1, |(_, step)| *step)
}

impl Axis {
    /// Returns the work of a step with another load, and of one with another pace, in samples whose load is computed
    /// again: those of the recordings, the instants of the motion laws, and the instants at which the loads on the
    /// flange follow from the mechanism.
    fn found_anew(&self) -> [usize; 2] {
        let [recorded, _] = self.trace.samples();
        let kept = self.trace.instants().saturating_sub(recorded);
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a count; what is out of range is clamped"
        )]
        let instants = ((kept as f64 + self.flange_instants().iter().sum::<f64>()) * AN_INSTANT) as usize;
        self.trace.found_anew().map(|samples| samples + instants)
    }

    /// Returns the axis with other masses and inertias: a factor on those of the load and one on the payloads.
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
        self.changed(self.mechanism.with_masses(load), self.motion.clone(), extras)
    }

    /// Returns the axis with its motion run in another time.
    fn with_time(&self, factor: f64) -> Self {
        self.changed(self.mechanism.clone(), self.motion.stretched(factor), self.extras.clone())
    }

    /// Returns the axis with another mechanism, motion or additional loads, and unchanged requirements.
    pub(crate) fn changed(
        &self,
        mechanism: mechanism::Mechanism,
        motion: motion::Motion,
        extras: Vec<mechanism::Extra>,
    ) -> Self {
        let trace = self.trace.changed(&mechanism, &motion, &extras, &carried(&motion, self.brake_times.as_ref()));
        let prepared = Self::with_trace(mechanism, motion, extras, trace);
        Self {
            ambient: self.ambient,
            bearing: self.bearing.clone(),
            supply: self.supply,
            asked: self.asked.clone(),
            brake_times: self.brake_times,
            ..prepared
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use actuator::Drivetrain;
    use mechanism::Mechanism;
    use motion::{Closing, ManualMove, Motion, SegmentSpec};
    use provenance::{Datum, Grade, Source, Sourced};
    use quantities::{Angle, AngularVelocity, MomentOfInertia, Torque};

    fn known<T>(value: T) -> Datum<T> {
        let source = Source::Project { key: "test".into() };
        Datum::Known(Sourced { value, source, grade: Grade::Printed, errata: &[] })
    }

    const fn reach<T>(value: T) -> Option<Reach<T>> {
        Some(Reach { value, fit: Fit::Fits, proviso: Proviso { estimate: false, rating: false } })
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

    /// Returns an actuator limited by T_max = 105 Nm only: (J_L + 0.5)·40 + 5 = 105 Nm at J_L = 2.0 kgm².
    fn actuator() -> Parameters {
        Parameters {
            inertia_out: known(MomentOfInertia::from_si(0.5)),
            ..Drivetrain { torque_max: known(Torque::from_si(105.0)), ..Drivetrain::unknown() }.into()
        }
    }

    #[test]
    fn the_border_by_hand_from_both_sides() {
        for (inertia, shown) in [(1.01, 1.980), (1.9, 1.052), (2.003, 0.9985), (8.3, 0.2409)] {
            let found = reserve(&axis(inertia), &actuator());
            assert_eq!(found.load_factor, reach(shown), "{inertia}: {found:?}");
            assert_eq!(found.payload_factor, None, "there is no payload");
        }
        // (1.0 + 0.5)·40/f² + 5 = 105: the time may shrink to √0.6 of 1.3 s.
        let found = reserve(&axis(1.0), &actuator());
        assert_eq!(found.cycle_time, reach(Time::from_si((1.3 * 0.6_f64.sqrt() * 1e3).ceil() / 1e3)), "{found:?}");
    }

    #[test]
    fn at_the_border_the_actuator_fits_and_beyond_it_does_not() {
        let axis = axis(1.3);
        let factor = reserve(&axis, &actuator()).load_factor.unwrap().value;
        let fits = |factor: f64| judge(&axis.with_load(factor, factor), &actuator(), Scope::All).fits();
        assert!(fits(factor) && !fits(factor + 0.001));
    }

    /// Returns nine seconds of swinging, with too many samples for their nodes to be stored.
    fn recorded(with_torque: bool) -> Motion {
        let time_s: Vec<f64> = (0..9_001).map(|k| 1e-3 * f64::from(k)).collect();
        let speed: Vec<f64> = (0..9_001).map(|k| (f64::from(k) * std::f64::consts::PI / 1_000.0).sin()).collect();
        let torque: Vec<f64> = time_s.iter().map(|t| t.cos()).collect();
        let samples = motion::Samples {
            time_s: time_s.into(),
            speed_rad_s: Some(speed.into()),
            torque_nm: with_torque.then(|| torque.into()),
            position_rad: None,
        };
        let recorded = motion::Recorded::new(samples, motion::Treatment::default()).unwrap();
        Motion::new(&[SegmentSpec::Recorded(recorded.into())], Some(Angle::from_si(0.0)), Closing::SingleMove).unwrap()
    }

    /// Returns an arm with the weight of 2 kg at 0.2 m.
    fn arm(efficiency: f64) -> Mechanism {
        let rotor = mechanism::Rotor {
            kind: mechanism::RotorKind::Arm,
            mass: Mass::from_si(2.0),
            radius: quantities::Length::from_si(0.2),
            tilt: Angle::from_si(std::f64::consts::FRAC_PI_2),
            ..mechanism::Rotor::balanced(MomentOfInertia::from_si(0.5))
        };
        let direct = Mechanism::direct(MomentOfInertia::from_si(0.5), Torque::from_si(1.0));
        Mechanism {
            kind: mechanism::MechanismKind::Rotor(rotor),
            efficiency_driving: efficiency,
            efficiency_driven: efficiency,
            ..direct
        }
    }

    #[test]
    fn what_costs_too_much_is_not_sought_and_said() {
        let found = |mechanism: &Mechanism, with_torque: bool, most: usize| {
            let axis = Axis::new(mechanism.clone(), recorded(with_torque), Vec::new());
            finished(reserve_watched(&axis, &actuator(), most, &Unobserved))
        };
        // Views of one survey cover every load and every pace.
        let all = found(&arm(1.0), false, 0);
        assert!(all.load_factor.is_some() && all.cycle_time.is_some() && all.unsought.is_none(), "{all:?}");
        // The recorded torque is unchanged by another weight.
        let some = found(&arm(1.0), true, 9_000);
        assert!(some.load_factor.is_none() && some.cycle_time.is_some(), "{some:?}");
        assert_eq!(some.unsought, Some(Unsought { pace: false, samples: 9_001 }));
        // Losses change sides at other instants.
        let none = found(&arm(0.9), false, 9_000);
        assert!(none.load_factor.is_none() && none.cycle_time.is_none(), "{none:?}");
        assert_eq!(none.unsought, Some(Unsought { pace: true, samples: 9_001 }));
        assert_eq!(none.ambient, all.ambient);
    }

    /// With losses close to zero the search that computes each load again agrees with the search by views.
    #[test]
    fn views_and_surveys_of_an_arm_have_the_same_reserves() {
        let reserves = |mechanism: &Mechanism| {
            let axis = Axis::new(mechanism.clone(), recorded(true), Vec::new());
            reserve(&axis, &actuator())
        };
        let (by_views, anew) = (reserves(&arm(1.0)), reserves(&arm(1.0 - 1e-12)));
        assert_eq!(by_views, anew);
    }

    /// The speed is too high: the trace fails too, whose limit is zero there.
    #[test]
    fn what_is_too_fast_is_mended_by_another_pace_alone() {
        let slow = |most: f64| Parameters {
            inertia_out: known(MomentOfInertia::from_si(0.5)),
            ..Drivetrain {
                torque_max: known(Torque::from_si(105.0)),
                speed_max: known(AngularVelocity::from_si(most)),
                ..Drivetrain::unknown()
            }
            .into()
        };
        let found = reserve(&axis(1.0), &slow(3.9));
        assert_eq!((found.load_factor, found.ambient), (None, None), "{found:?}");
        assert_eq!(found.cycle_time, reach(Time::from_si(1.334)), "1.3 s · 4.0/3.9 = 1.3333 s: {found:?}");
        // The highest permissible speed limits the pace.
        let found = reserve(&axis(1.0), &slow(4.1));
        assert_eq!(found.cycle_time, reach(Time::from_si(1.269)), "1.3 s · 4.0/4.1 = 1.2683 s: {found:?}");
    }

    #[test]
    fn where_nothing_helps_nothing_is_promised() {
        let mut weak = actuator();
        weak.torque_max = known(Torque::from_si(4.0));
        let found = reserve(&axis(1.0), &weak);
        assert_eq!((found.load_factor, found.cycle_time), (None, None), "friction alone is too much");
    }
}
