//! Curves of the torque-speed plane: continuous duty, intermittent duty S3, short time.

use crate::curve::{Curve, CurvePoint};
use crate::friction::{FrictionAt, NoLoadFriction};
use crate::heat_model::HeatModel;
use crate::motor::{ContinuousLimit, continuous_torque_with, speed_max, speed_rated_out};
use crate::parameters::Drivetrain;
use crate::voltage::MotorVoltage;
use derivation::{Finding, Workings};
use numeric::AT_THE_LIMIT;
use provenance::{Datum, Grade, Missing, Source, Sourced};
use quantities::unit::{AMPERE, NEWTON_METRE, NEWTON_METRE_PER_AMPERE, REVOLUTION_PER_MINUTE, VOLT};
use quantities::{AngularVelocity, ElectricCurrent, ElectricPotential, Measure, Ratio, Time, Torque, TorqueConstant};

/// Number of parts of an estimated curve.
const PARTS: u32 = 32;

/// Kind of duty that a curve limits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CurveKind {
    /// Continuous duty.
    Continuous,
    /// Intermittent duty.
    S3 {
        /// Duty factor.
        duty: Ratio,
        /// Duration of one cycle.
        cycle: Time,
    },
    /// Acceleration and braking.
    ShortTime,
}

/// A curve of the torque-speed plane, from standstill to its end, where it drops vertically to zero.
#[derive(Clone, Debug, PartialEq)]
pub struct PerformanceCurve {
    /// Kind of duty limited.
    pub kind: CurveKind,
    /// Terminal voltage of the curve; `None` if the voltage does not limit it.
    pub voltage: Option<ElectricPotential>,
    /// Limit: published, or the lower edge of the estimate's band. The last two points have the same speed.
    pub points: Vec<CurvePoint>,
    /// Upper edge of the band; `None` if the curve is published.
    pub upper: Option<Vec<CurvePoint>>,
    /// Grade of trust in the curve.
    pub grade: Grade,
    /// Source of the curve.
    pub source: Source,
}

/// Returns the curves available for an actuator: continuous, S3 50 %, S3 25 %, short time, in this order.
///
/// Published curves take precedence and are limited by T_0 or T_max; others are estimated, with their band.
///
/// # Source
/// docs/theory/continuous-torque.md, docs/theory/short-time-torque.md
/// # Valid
/// on the plate of the manual at the highest permitted ambient temperature; S3 for the cycle of the published curves
/// # Errors
/// [`Missing`] with the first unknown datum of the first curve, if no curve is available.
pub fn performance_curves(
    actuator: &Drivetrain,
    terminal_voltage: Option<ElectricPotential>,
) -> Result<Vec<PerformanceCurve>, Missing> {
    let [half, quarter] = &actuator.s3_curves;
    let mut first_missing = None;
    let mut curves = Vec::new();
    for curve in [
        continuous_curve(actuator),
        s3_curve(actuator, half, 0.5, terminal_voltage),
        s3_curve(actuator, quarter, 0.25, terminal_voltage),
        short_time_curve(actuator, terminal_voltage),
    ] {
        match curve {
            Ok(curve) => curves.push(curve),
            Err(missing) => first_missing = first_missing.or(Some(missing)),
        }
    }
    match first_missing {
        Some(missing) if curves.is_empty() => Err(missing),
        _ => Ok(curves),
    }
}

/// Largest short-time torque of an actuator, driving, at a terminal voltage if one is given.
///
/// T = min(T_max, k_Tout (min(I_max, I_U) − I_f)) for |n| ≤ n_mot,max/i, never negative; zero beyond. The upper edge
/// omits I_max, which has a check of its own, and the speed-dependent friction.
///
/// # Symbols
/// I_U largest current of the voltage limit \[A\], see [`MotorVoltage::current_max`], I_f friction current \[A\]
/// # Source
/// docs/theory/short-time-torque.md; the short-time curve instead, if one is published and the voltage is not below the
/// U_M of the tables
/// # Valid
/// driving, i_d = 0; more is permitted in braking
#[derive(Clone, Debug)]
pub struct ShortTime<'a>(Law<'a>);

#[derive(Clone, Debug)]
enum Law<'a> {
    Published { curve: &'a Sourced<Curve>, torque_max: &'a Datum<Torque> },
    Model(Model<'a>),
}

#[derive(Clone, Debug)]
struct Model<'a> {
    torque_max: &'a Sourced<Torque>,
    /// End of the curve.
    end: Sourced<AngularVelocity>,
    current_max: &'a Sourced<ElectricCurrent>,
    torque_constant: &'a Sourced<TorqueConstant>,
    friction: FrictionAt,
    /// Voltage limit, if a voltage is given.
    motor: Option<(MotorVoltage, ElectricPotential)>,
}

impl<'a> ShortTime<'a> {
    /// Creates the limit of an actuator with its friction.
    ///
    /// # Errors
    /// [`Missing`] with the first unknown datum.
    pub fn of(
        actuator: &'a Drivetrain,
        terminal_voltage: Option<ElectricPotential>,
        friction: &FrictionAt,
    ) -> Result<Self, Missing> {
        if let Some(curve) = actuator.at_voltage(&actuator.short_time_curve, terminal_voltage) {
            return Ok(Self(Law::Published { curve, torque_max: &actuator.torque_max }));
        }
        Ok(Self(Law::Model(Model {
            torque_max: actuator.torque_max.require("T_max")?,
            end: speed_max(actuator)?,
            current_max: actuator.current_max.require("I_max")?,
            torque_constant: actuator.torque_constant_out.require("k_Tout")?,
            friction: *friction,
            motor: match terminal_voltage {
                Some(voltage) => Some((MotorVoltage::of(actuator)?, voltage)),
                None => None,
            },
        })))
    }

    /// Returns the speeds [rad/s] at which the limit may have a downward corner or drop, in ascending order.
    #[must_use]
    pub fn corners(&self) -> Vec<f64> {
        match &self.0 {
            Law::Published { curve, .. } => {
                let points = curve.value.points();
                let drop = points.last().map(|end| (end.speed.si() * (1.0 + AT_THE_LIMIT)).next_up());
                points.iter().map(|point| point.speed.si()).chain(drop).collect()
            }
            // The minimum of several laws has upward corners only.
            Law::Model(_) => Vec::new(),
        }
    }

    /// Returns the smallest limit between two speeds, the slower first, and the smallest upper edge.
    #[must_use]
    pub fn least_between(&self, slower: AngularVelocity, faster: AngularVelocity) -> [Torque; 2] {
        match &self.0 {
            Law::Published { curve, torque_max } => {
                let [slower, faster] = [slower, faster].map(|speed| within(&curve.value, speed));
                [at_most(curve.value.least_between(slower, faster), torque_max); 2]
            }
            // The limit decreases with the speed.
            Law::Model(model) => model.at(faster),
        }
    }

    /// Returns the speed above which no torque is permitted.
    #[must_use]
    pub fn end(&self) -> AngularVelocity {
        match &self.0 {
            Law::Published { curve, .. } => {
                AngularVelocity::from_si(curve.value.points().last().map_or(0.0, |point| point.speed.si()))
            }
            Law::Model(model) => model.end.value,
        }
    }

    /// Returns the limit at a speed, and the upper edge of its band.
    #[must_use]
    pub fn at(&self, speed: AngularVelocity) -> [Torque; 2] {
        match &self.0 {
            Law::Published { curve, torque_max } => {
                [at_most(curve.value.at(within(&curve.value, speed)), torque_max); 2]
            }
            Law::Model(model) => model.at(speed),
        }
    }

    /// Returns the limit at a speed with its source and the upper edge of its band.
    #[must_use]
    pub fn limit(&self, speed: AngularVelocity) -> ContinuousLimit {
        let [value, upper] = self.at(speed);
        let (source, grade, errata) = match &self.0 {
            Law::Published { curve, .. } => (curve.source.clone(), curve.grade, curve.errata),
            Law::Model(model) => (SHORT_TIME, model.grade(), model.torque_max.errata),
        };
        ContinuousLimit { limit: Sourced { value, source, grade, errata }, upper }
    }

    /// Records the derivation of the limit at a speed; the caller has recorded the speed `n`, the result is `T_short`.
    pub fn explain(&self, speed: AngularVelocity, work: &mut Workings) {
        let [limit, _] = self.at(speed);
        match &self.0 {
            Law::Published { curve, torque_max } => {
                work.known("T_max", &NEWTON_METRE, torque_max);
                let what = Finding::ShortTimeCurve;
                work.found("T_short", &NEWTON_METRE, limit.si(), what, &curve.source, curve.grade);
            }
            Law::Model(model) if work.is_on() => model.explain(speed, limit, work),
            Law::Model(_) => {}
        }
    }
}

const SHORT_TIME: Source = Source::Model { name: "short-time-torque" };

impl Model<'_> {
    fn is_inside(&self, speed: AngularVelocity) -> bool {
        speed.si().abs() <= self.end.value.si() * (1.0 + AT_THE_LIMIT)
    }

    /// Returns I_U, the largest current of the voltage limit \[A\].
    fn current_of_voltage(&self, speed: AngularVelocity) -> f64 {
        let of = |(motor, voltage): &(MotorVoltage, _)| motor.current_max(speed, *voltage).map_or(0.0, Measure::si);
        self.motor.as_ref().map_or(f64::INFINITY, of)
    }

    fn at(&self, speed: AngularVelocity) -> [Torque; 2] {
        if !self.is_inside(speed) {
            return [Torque::from_si(0.0); 2];
        }
        let voltage = self.current_of_voltage(speed);
        let lower = voltage.min(self.current_max.value.si()) - self.friction.current(speed).si();
        [lower, voltage - self.friction.counted.si()].map(|current| {
            let torque = self.torque_constant.value.si() * current;
            Torque::from_si(torque.clamp(0.0, self.torque_max.value.si()))
        })
    }

    fn grade(&self) -> Grade {
        let of_the_motor = self.motor.as_ref().map_or(Grade::Estimated, |(motor, _)| motor.grade);
        [self.torque_max.grade, self.current_max.grade, self.torque_constant.grade, of_the_motor]
            .into_iter()
            .fold(Grade::Estimated, Grade::worst)
    }

    fn explain(&self, speed: AngularVelocity, limit: Torque, work: &mut Workings) {
        if !self.is_inside(speed) {
            work.given("n_end", &REVOLUTION_PER_MINUTE, &self.end);
            work.found("T_short", &NEWTON_METRE, limit.si(), Finding::SpeedBeyondCurve, &SHORT_TIME, self.grade());
            return;
        }
        work.given("I_max", &AMPERE, self.current_max);
        work.given("k_Tout", &NEWTON_METRE_PER_AMPERE, self.torque_constant);
        work.given("T_max", &NEWTON_METRE, self.torque_max);
        let what = Finding::FrictionOfColdGear;
        let running = self.friction.current(speed).si();
        work.found("I_f", &AMPERE, running, what, &Source::Model { name: "current" }, Grade::Estimated);
        let text = if let Some((_, voltage)) = &self.motor {
            let supply = Source::Model { name: "voltage" };
            work.figure("U_M", &VOLT, voltage.si(), &supply, Grade::Computed);
            let what = Finding::CurrentWithinVoltage;
            work.found("I_U", &AMPERE, self.current_of_voltage(speed), what, &SHORT_TIME, Grade::Estimated);
            "min(max(k_Tout*(min(I_max, I_U) - I_f), 0), T_max)"
        } else {
            "min(max(k_Tout*(I_max - I_f), 0), T_max)"
        };
        work.estimate("T_short", &NEWTON_METRE, limit.si(), text, &SHORT_TIME);
    }
}

impl Drivetrain {
    /// Returns a published curve, if it applies at this voltage: from the U_M of the tables on.
    pub fn at_voltage<'a>(
        &self,
        curve: &'a Datum<Curve>,
        terminal_voltage: Option<ElectricPotential>,
    ) -> Option<&'a Sourced<Curve>> {
        let curve = curve.known()?;
        let enough = match (terminal_voltage, self.terminal_voltage_min.known()) {
            (Some(voltage), Some(least)) => voltage.si() >= least.value.si(),
            _ => true,
        };
        enough.then_some(curve)
    }

    /// Returns the short-time curve whose torque is permitted although its current exceeds I_max: that of the manufacturer, with
    /// the manufacturer's I_max. Of a curve or an I_max of the project the lower limit governs.
    pub fn curve_above_current_max(&self, terminal_voltage: Option<ElectricPotential>) -> Option<&Sourced<Curve>> {
        let is_own = Source::is_of_the_user;
        let curve = self.at_voltage(&self.short_time_curve, terminal_voltage)?;
        let has_own_limit = self.current_max.known().is_some_and(|limit| is_own(&limit.source));
        (!is_own(&curve.source) && !has_own_limit).then_some(curve)
    }
}

/// Returns a speed, reduced to the end of a curve if it exceeds it by rounding only.
fn within(curve: &Curve, speed: AngularVelocity) -> AngularVelocity {
    let end = curve.points().last().map_or(0.0, |point| point.speed.si());
    let speed = speed.si().abs();
    AngularVelocity::from_si(if speed <= end * (1.0 + AT_THE_LIMIT) { speed.min(end) } else { speed })
}

fn at_most(torque: Torque, limit: &Datum<Torque>) -> Torque {
    Torque::from_si(limit.known().map_or(torque.si(), |limit| torque.si().min(limit.value.si())))
}

/// Limits corner points to a torque, with a new corner where a line crosses it.
fn cut(points: &[CurvePoint], limit: &Datum<Torque>) -> Vec<CurvePoint> {
    let mut found: Vec<CurvePoint> = Vec::new();
    let mut last: Option<CurvePoint> = None;
    for &point in points {
        if let (Some(before), Some(limit)) = (last, limit.known()) {
            let (a, b, level) = (before.torque.si(), point.torque.si(), limit.value.si());
            if (a - level) * (b - level) < 0.0 {
                let share = (level - a) / (b - a);
                let speed = before.speed.si() + share * (point.speed.si() - before.speed.si());
                found.push(CurvePoint { speed: AngularVelocity::from_si(speed), torque: limit.value });
            }
        }
        found.push(CurvePoint { speed: point.speed, torque: at_most(point.torque, limit) });
        last = Some(point);
    }
    found
}

/// Adds the vertical drop at the end.
fn dropped(mut points: Vec<CurvePoint>) -> Vec<CurvePoint> {
    if let Some(end) = points.last().copied()
        && end.torque.si() > 0.0
    {
        points.push(CurvePoint { speed: end.speed, torque: Torque::from_si(0.0) });
    }
    points
}

fn published(curve: &Sourced<Curve>, limit: &Datum<Torque>, kind: CurveKind) -> PerformanceCurve {
    PerformanceCurve {
        kind,
        voltage: None,
        points: dropped(cut(curve.value.points(), limit)),
        upper: None,
        grade: curve.grade,
        source: curve.source.clone(),
    }
}

/// Iterates over the speeds at which an estimated curve is computed.
fn speeds(end: AngularVelocity) -> impl Iterator<Item = AngularVelocity> {
    (0..=PARTS).map(move |part| AngularVelocity::from_si(end.si() * (f64::from(part) / f64::from(PARTS))))
}

fn estimated(
    kind: CurveKind,
    voltage: Option<ElectricPotential>,
    end: AngularVelocity,
    at: impl Fn(AngularVelocity) -> Result<ContinuousLimit, Missing>,
) -> Result<PerformanceCurve, Missing> {
    let (mut points, mut upper) = (Vec::new(), Vec::new());
    let (mut grade, mut source) = (Grade::Estimated, None);
    for speed in speeds(end) {
        let limit = at(speed)?;
        points.push(CurvePoint { speed, torque: limit.limit.value });
        upper.push(CurvePoint { speed, torque: limit.upper });
        grade = grade.worst(limit.limit.grade);
        source = source.or(Some(limit.limit.source));
    }
    Ok(PerformanceCurve {
        kind,
        voltage,
        points: dropped(points),
        upper: Some(dropped(upper)),
        grade,
        source: source.unwrap_or(Source::Model { name: "continuous-torque" }),
    })
}

fn continuous_curve(actuator: &Drivetrain) -> Result<PerformanceCurve, Missing> {
    if let Some(curve) = actuator.continuous_curve.known() {
        return Ok(published(curve, &actuator.stall_torque, CurveKind::Continuous));
    }
    let end = speed_rated_out(actuator)?.value;
    let model = HeatModel::of(actuator)?;
    let at = |speed| continuous_torque_with(actuator, Some(&model), speed, &mut Workings::off());
    estimated(CurveKind::Continuous, None, end, at)
}

/// Returns the friction of a cold gear.
fn cold_friction(actuator: &Drivetrain) -> Result<FrictionAt, Missing> {
    let law = NoLoadFriction::of(actuator)?;
    Ok(law.at(law.cold_start()))
}

fn s3_curve(
    actuator: &Drivetrain,
    datum: &Datum<Curve>,
    duty: f64,
    voltage: Option<ElectricPotential>,
) -> Result<PerformanceCurve, Missing> {
    let cycle = actuator.heat.intermittent_cycle.require("s3_cycle")?.value;
    let kind = CurveKind::S3 { duty: Ratio::from_si(duty), cycle };
    if let Some(curve) = actuator.at_voltage(datum, voltage) {
        return Ok(PerformanceCurve { voltage, ..published(curve, &actuator.torque_max, kind) });
    }
    // With half of the time at rest, the mean speed is half of that in motion, and only the mean is limited by n_N/i.
    let end = speed_max(actuator)?.value.si().min(speed_rated_out(actuator)?.value.si() / duty);
    estimated(kind, voltage, AngularVelocity::from_si(end), |speed| {
        intermittent_torque(actuator, speed, Ratio::from_si(duty), voltage)
    })
}

/// Returns the torque of intermittent duty S3 at a speed, with its band, for the cycle of the published curves.
///
/// T of [`HeatModel::torque`] with the duty factor; T ≤ T_A ED^(−1/3) (T_0 instead of an unknown T_A), T ≤ the
/// short-time torque
///
/// # Symbols
/// ED duty factor, T_A average torque of the gear \[Nm\]
/// # Source
/// docs/theory/short-time-torque.md; estimate, compared with curves-20A
/// # Valid
/// |n| ≤ n_mot,max/i and ED |n| ≤ n_N/i, 0 < ED ≤ 1; rest without loss
/// # Errors
/// [`Missing`] with the first unknown datum.
pub fn intermittent_torque(
    actuator: &Drivetrain,
    speed: AngularVelocity,
    duty: Ratio,
    terminal_voltage: Option<ElectricPotential>,
) -> Result<ContinuousLimit, Missing> {
    let model = HeatModel::of(actuator)?;
    let (low, high) = model.band(AngularVelocity::from_si(duty.si() * speed.si()));
    let high = actuator.heat.intermittent_band_high.known().map_or(high, |edge| edge.value.max(high));
    let gear_band = actuator.heat.gear_band.require("s3_gear_band")?.value;
    let cycle = actuator.heat.intermittent_cycle.require("s3_cycle")?.value;
    let thermal = |edge: f64| model.torque(speed, duty.si(), cycle, edge).0.si();
    let short_time = ShortTime::of(actuator, terminal_voltage, &cold_friction(actuator)?)?.limit(speed);
    let stall = actuator.stall_torque.require("T_0")?;
    let rated = speed_rated_out(actuator)?.value.si();
    let inside = numeric::at_most(duty.si() * speed.si().abs(), rated);
    let average = actuator.gear.average_torque_max.known().map(|known| known.value.si());
    // T_0 never exceeds T_A and is a lower bound of an unknown T_A, which the upper edge must not use.
    let gear = duty.si().powf(-1.0 / 3.0) * average.map_or(stall.value.si(), |average| average.max(stall.value.si()));
    let gear_upper = if average.is_some() { gear * (1.0 + gear_band) } else { f64::INFINITY };
    let bounded = |torque: f64, gear: f64, short_time: Torque| {
        Torque::from_si(if inside { torque.min(gear).min(short_time.si()) } else { 0.0 })
    };
    Ok(ContinuousLimit {
        limit: Sourced {
            value: bounded(thermal(low), gear * (1.0 - gear_band), short_time.limit.value),
            source: Source::Model { name: "short-time-torque" },
            grade: short_time.limit.grade.worst(Grade::Estimated),
            errata: stall.errata,
        },
        upper: bounded(thermal(high), gear_upper, short_time.upper),
    })
}

fn short_time_curve(actuator: &Drivetrain, voltage: Option<ElectricPotential>) -> Result<PerformanceCurve, Missing> {
    if let Some(curve) = actuator.at_voltage(&actuator.short_time_curve, voltage) {
        return Ok(PerformanceCurve { voltage, ..published(curve, &actuator.torque_max, CurveKind::ShortTime) });
    }
    let end = speed_max(actuator)?.value;
    let kind = CurveKind::ShortTime;
    let short_time = ShortTime::of(actuator, voltage, &cold_friction(actuator)?)?;
    let mut curve = estimated(kind, voltage, end, |speed| Ok(short_time.limit(speed)))?;
    let points = &mut curve.points;
    // The corner at the onset of another limit, between the last point of equal torque and the next one.
    let corner = points.iter().zip(points.iter().skip(1)).position(|(a, b)| b.torque.si() < a.torque.si());
    if let Some(index) = corner
        && let (Some(flat), Some(fallen)) = (points.get(index).copied(), points.get(index + 1).copied())
    {
        let falls = |speed: f64| {
            let [torque, _] = short_time.at(AngularVelocity::from_si(speed));
            if torque.si() < flat.torque.si() { 1.0 } else { -1.0 }
        };
        let corner = numeric::root(falls, (flat.speed.si(), -1.0), (fallen.speed.si(), 1.0), 0.0);
        if corner > flat.speed.si() {
            points.insert(index + 1, CurvePoint { speed: AngularVelocity::from_si(corner), torque: flat.torque });
        }
    }
    Ok(curve)
}

#[cfg(test)]
#[path = "plane_tests.rs"]
mod tests;
