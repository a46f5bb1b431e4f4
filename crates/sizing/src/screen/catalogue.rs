//! Data of the actuators that are equal for every axis, and for axes with equal ambient temperature and supply.

use super::figures::all;
use crate::axis::Axis;
use crate::brake_times::BrakeTimes;
use crate::check::{CheckId, Verdict};
use crate::electrics::{CurrentLaw, Electrics};
use actuator::{Drivetrain, FrictionAt, HeatModel, MotorVoltage, NoLoadFriction, OutputBearing, Parameters, ShortTime};
use derivation::Workings;
use provenance::{Datum, Missing};
use quantities::{AngularVelocity, ElectricPotential, Measure, ThermodynamicTemperature, Time};
use std::sync::Arc;
use wide::f64x4;

/// An actuator to be ranked.
#[derive(Clone, Copy, Debug)]
pub struct Entrant<'p> {
    /// Parameters.
    pub parameters: &'p Parameters,
    /// Frame size, or the mass \[g\] where products without frame sizes compete; the smaller is preferred.
    pub size: u32,
    /// Mass \[kg\]; infinite if unknown.
    pub mass_kg: f64,
}

/// Actuators that are ranked for many axes.
pub struct Screen {
    drives: Vec<Option<Drive>>,
    /// Number of different output bearings.
    pub(super) bearings: usize,
    /// Groups of actuators that differ in their feedback alone.
    groups: Vec<Group>,
    /// Groups of one actuator each, for axes that limit the feedback.
    singles: Vec<Group>,
}

/// A member of a group.
#[derive(Clone, Copy, Debug)]
pub(super) struct Member {
    pub(super) entrant: usize,
    pub(super) mass_kg: f64,
}

/// Actuators with equal answers to every check.
pub(super) struct Group {
    pub(super) representative: Parameters,
    pub(super) members: Vec<Member>,
    pub(super) size: u32,
    /// Index of its drivetrain; then that of its output bearing.
    pub(super) drive: usize,
    pub(super) bearing: usize,
    /// J_out \[kgm²\]
    pub(super) inertia: f64,
    /// Heat of the coil of an open brake \[W\].
    pub(super) coil_w: f64,
}

/// Data of a drivetrain that are equal for every axis.
pub(super) struct Drive {
    pub(super) drivetrain: Arc<Drivetrain>,
    pub(super) heat: HeatModel,
    friction: NoLoadFriction,
    pub(super) voltage: Option<MotorVoltage>,
    /// T_max \[Nm\]
    pub(super) torque_max: f64,
    /// n_mot,max/i and n_N/i [rad/s]
    pub(super) speed_max: f64,
    pub(super) speed_rated: f64,
    /// k_Tout \[Nm/A\]
    pub(super) torque_constant: f64,
    pub(super) ratio: f64,
    /// I_max, I_E \[A\]
    pub(super) current_max: Option<f64>,
    pub(super) current_demagnetisation: Option<f64>,
    /// A published short-time curve may permit more than I_max.
    pub(super) has_short_time_curve: bool,
    /// Published curves scale the model of heat.
    pub(super) has_curves: bool,
    /// Result of the model on the published curves, if all of them are published.
    pub(super) published: Option<Published>,
    /// I_0 \[A\]
    pub(super) stall_current: f64,
    /// T_A \[Nm\]
    pub(super) average_torque_max: Option<Rating>,
    /// n_in,av [rad/s]
    pub(super) input_speed_mean_max: Option<Rating>,
    /// Torque that the screws transmit \[Nm\].
    pub(super) transmissible_load: Option<f64>,
    pub(super) transmissible_housing: Option<f64>,
    /// Permissible ambient temperature in operation \[K\], U_DCmax \[V\]
    pub(super) ambient_range: Option<(f64, f64)>,
    pub(super) dc_link_max: Option<f64>,
    pub(super) continuous: Continuous,
}

/// A rating of the gear.
#[derive(Clone, Copy)]
pub(super) struct Rating {
    pub(super) si: f64,
    /// Beyond it the actuator is rejected, not only advised against.
    pub(super) rejects: bool,
}

impl Rating {
    fn of<Q: Measure>(datum: &Datum<Q>) -> Option<Self> {
        let known = datum.known()?;
        Some(Self { si: known.value.si(), rejects: crate::gear_checks::beyond(&known.source) == Verdict::Fail })
    }
}

/// Least and largest rise of the winding that the model gives on published curves, as shares of the permissible rise.
pub(super) struct Published {
    /// Range on the continuous curve; then those on the curves of half and of a quarter duty.
    continuous: [f64; 2],
    half: [f64; 2],
    quarter: [f64; 2],
}

/// Number of speed steps at which the model is compared with published curves.
const PUBLISHED_STEPS: u32 = 256;

impl Published {
    /// Computes the ranges. For speeds between two steps there is no proof: the range is widened by the largest change
    /// of a step, an assumption, since curves and model are smooth between corners.
    fn of(drivetrain: &Drivetrain, heat: &HeatModel) -> Option<Self> {
        let [half, quarter] = &drivetrain.s3_curves;
        let curves = [drivetrain.continuous_curve.known()?, half.known()?, quarter.known()?];
        let end = curves.iter().filter_map(|curve| curve.value.points().last()).map(|end| end.speed.si());
        let step = end.fold(0.0, f64::max) / f64::from(PUBLISHED_STEPS);
        let range = |duty: f64| {
            // Beyond its end a curve has the value of its end.
            let at = |place: u32| {
                let speed = AngularVelocity::from_si(step * f64::from(place) * duty);
                Some(actuator::published_duty(drivetrain, heat, duty, speed)?.rise_share)
            };
            let shares: Vec<f64> = (0..=PUBLISHED_STEPS).map(at).collect::<Option<_>>()?;
            let (low, high) =
                shares.iter().fold((f64::INFINITY, 0.0_f64), |(low, high), x| (low.min(*x), high.max(*x)));
            let change = shares.iter().zip(shares.iter().skip(1)).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            (low > 2.0 * change).then_some([low - change, high + change])
        };
        Some(Self { continuous: range(1.0)?, half: range(0.5)?, quarter: range(0.25)? })
    }

    /// Returns bounds of the rise at a duty factor: between the curves next to it.
    pub(super) fn rise_shares(&self, duty: f64) -> [f64; 2] {
        let ([a, b], [c, d]) = if duty > 0.5 { (self.continuous, self.half) } else { (self.half, self.quarter) };
        [a.min(c), b.max(d)]
    }
}

/// Continuous torque over the mean speed: lower edge and upper edge at equal steps of the speed up to n_N/i, both
/// falling.
pub(super) struct Continuous {
    step: f64,
    edges: Vec<[f64; 2]>,
    /// Share by which a value between two steps may lie outside of them: zero if the fall is proven.
    beside: f64,
}

/// Steps of the speed.
const STEPS: u32 = 512;

/// Share by which a value may lie outside of two steps between which the fall is not proven; assumed, since the curve
/// is smooth.
const BESIDE: f64 = 1e-3;

impl Continuous {
    /// Returns `None` if the edges do not fall.
    fn of(drivetrain: &Drivetrain, heat: &HeatModel, rated: f64) -> Option<Self> {
        let (end, is_proven) = match drivetrain.continuous_curve.known() {
            Some(curve) => {
                let points = curve.value.points();
                let falls = points.iter().zip(points.iter().skip(1)).all(|(a, b)| b.torque.si() <= a.torque.si());
                (points.last().map_or(rated, |end| end.speed.si()), falls)
            }
            None => (rated, heat.falls_with_the_speed()),
        };
        let step = end / f64::from(STEPS);
        let at = |place: u32| {
            let speed = AngularVelocity::from_si(step * f64::from(place));
            let found = actuator::continuous_torque_with(drivetrain, Some(heat), speed, &mut Workings::off()).ok()?;
            Some([found.limit.value.si(), found.upper.si()])
        };
        let edges: Vec<[f64; 2]> = (0..=STEPS).map(at).collect::<Option<_>>()?;
        let falls = |[low, high]: &[f64; 2], [next_low, next_high]: &[f64; 2]| next_low <= low && next_high <= high;
        let falls = edges.iter().zip(edges.iter().skip(1)).all(|(one, next)| falls(one, next));
        falls.then_some(Self { step, edges, beside: if is_proven { 0.0 } else { BESIDE } })
    }

    /// Returns bounds of the lower edge and of the upper edge at a speed, the lower bound of each first.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a place of the table")]
    pub(super) fn at(&self, speed: f64) -> [[f64; 2]; 2] {
        let last = self.edges.len().saturating_sub(1);
        let place = ((speed / self.step).max(0.0) as usize).min(last);
        let edges = |place: usize| self.edges.get(place.min(last)).copied().unwrap_or([0.0; 2]);
        // One step further on both sides: the quotient is rounded.
        let ([above, upper_above], [below, upper_below]) = (edges(place.saturating_sub(1)), edges(place + 2));
        let wider = |[low, high]: [f64; 2]| [low * (1.0 - self.beside), high * (1.0 + self.beside)];
        [wider([below, above]), wider([upper_below, upper_above])]
    }
}

impl Screen {
    /// Creates the screen of the actuators in the order of the catalogue.
    #[must_use]
    pub fn of(entrants: &[Entrant<'_>]) -> Self {
        let mut drives: Vec<(&Arc<Drivetrain>, Option<Drive>)> = Vec::new();
        let mut groups: Vec<Group> = Vec::new();
        let mut singles = Vec::with_capacity(entrants.len());
        let mut bearings: Vec<&OutputBearing> = Vec::new();
        for (place, entrant) in entrants.iter().enumerate() {
            let parameters = entrant.parameters;
            let known = drives.iter().position(|(known, _)| Arc::ptr_eq(known, &parameters.drivetrain));
            let drive = known.unwrap_or_else(|| {
                drives.push((&parameters.drivetrain, Drive::of(&parameters.drivetrain)));
                drives.len() - 1
            });
            let own = &parameters.output_bearing;
            let bearing = bearings.iter().position(|known| *known == own).unwrap_or_else(|| {
                bearings.push(own);
                bearings.len() - 1
            });
            let group = || Group::of(entrant, place, (drive, bearing));
            singles.push(group());
            let equal = groups.iter_mut().rev().find(|known| known.drive == drive && known.is_like(parameters));
            match equal {
                Some(known) => known.members.push(Member { entrant: place, mass_kg: entrant.mass_kg }),
                None => groups.push(group()),
            }
        }
        let bearings = bearings.len();
        Self { drives: drives.into_iter().map(|(_, drive)| drive).collect(), bearings, groups, singles }
    }

    /// Returns the groups of actuators with equal answers for an axis.
    pub(super) fn groups(&self, axis: &Axis) -> &[Group] {
        let limits = |id: &CheckId| id.is_of_the_feedback() && id.is_made(axis) && id.can_fail(axis);
        if CheckId::ALL.iter().any(limits) { &self.singles } else { &self.groups }
    }
}

impl Group {
    fn of(entrant: &Entrant<'_>, place: usize, (drive, bearing): (usize, usize)) -> Self {
        let parameters = entrant.parameters;
        let coil = match (parameters.brake.voltage.known(), parameters.brake.holding_current.known()) {
            (Some(voltage), Some(current)) => voltage.value.si() * current.value.si().abs(),
            _ => 0.0,
        };
        Self {
            representative: parameters.clone(),
            members: vec![Member { entrant: place, mass_kg: entrant.mass_kg }],
            size: entrant.size,
            drive,
            bearing,
            // Without it the drive is unknown to bounds, see `Screen::of`.
            inertia: parameters.inertia_out.known().map_or(f64::NAN, |inertia| inertia.value.si()),
            coil_w: coil,
        }
    }

    /// Returns `true` if an actuator with the same drivetrain differs in its feedback alone.
    fn is_like(&self, other: &Parameters) -> bool {
        let own = &self.representative;
        own.inertia_out == other.inertia_out && own.brake == other.brake
    }
}

fn si<Q: Measure>(datum: &Datum<Q>) -> Option<f64> {
    datum.known().map(|known| known.value.si())
}

impl Drive {
    /// Returns `None` if a datum that most checks need is unknown.
    fn of(drivetrain: &Arc<Drivetrain>) -> Option<Self> {
        let heat = HeatModel::of(drivetrain).ok()?;
        let speed_rated = actuator::speed_rated_out(drivetrain).ok()?.value.si();
        let [half, quarter] = &drivetrain.s3_curves;
        let (half, quarter) = (half.known().is_some(), quarter.known().is_some());
        let continuous_curve = drivetrain.continuous_curve.known().is_some();
        Some(Self {
            friction: NoLoadFriction::of(drivetrain).ok()?,
            voltage: MotorVoltage::of(drivetrain).ok(),
            torque_max: si(&drivetrain.torque_max)?,
            speed_max: actuator::speed_max(drivetrain).ok()?.value.si(),
            speed_rated,
            torque_constant: si(&drivetrain.torque_constant_out)?,
            ratio: drivetrain.ratio.known()?.value,
            current_max: si(&drivetrain.current_max),
            current_demagnetisation: si(&drivetrain.current_demagnetisation),
            has_short_time_curve: drivetrain.curve_above_current_max(None).is_some(),
            has_curves: half || quarter || continuous_curve,
            published: Published::of(drivetrain, &heat),
            stall_current: si(&drivetrain.stall_current)?,
            average_torque_max: Rating::of(&drivetrain.gear.average_torque_max),
            input_speed_mean_max: Rating::of(&drivetrain.gear.input_speed_mean_max),
            transmissible_load: si(&drivetrain.screw_joint_load.transmissible_torque),
            transmissible_housing: si(&drivetrain.screw_joint_housing.transmissible_torque),
            ambient_range: drivetrain.ambient_range.known().map(|range| (range.value.0.si(), range.value.1.si())),
            dc_link_max: si(&drivetrain.dc_link_max),
            continuous: Continuous::of(drivetrain, &heat, speed_rated)?,
            heat,
            drivetrain: Arc::clone(drivetrain),
        })
    }
}

/// Friction as current: static part and growth with the speed \[A\], [A/(rad/s)], and the starting current \[A\].
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Friction {
    pub(super) counted: f64,
    pub(super) starting: f64,
    pub(super) constant: f64,
}

impl Friction {
    fn of(friction: &FrictionAt) -> Self {
        Self { counted: friction.counted.si(), starting: friction.starting.si(), constant: friction.constant.si() }
    }
}

/// Data of a drivetrain at one ambient temperature and supply.
pub(super) struct Place<'p> {
    law: CurrentLaw,
    /// Friction of a gear at the ambient temperature of a cold start, of one at that of the cycle, and of the warmest.
    pub(super) cold: Friction,
    pub(super) at_ambient: Friction,
    pub(super) warmest: Friction,
    /// Ambient temperature \[K\].
    pub(super) ambient_k: f64,
    pub(super) short_time: Option<ShortTime<'p>>,
}

/// Data of the actuators for axes with equal ambient temperature and supply.
pub(super) struct Conditions<'p> {
    ambient: Option<ThermodynamicTemperature>,
    pub(super) terminal: Option<ElectricPotential>,
    drives: &'p [Option<Drive>],
    places: Vec<Option<Place<'p>>>,
    pub(super) groups: &'p [Group],
    pub(super) fours: Vec<Four>,
}

impl Place<'_> {
    /// Returns the laws of a drivetrain for an axis, as [`Electrics::of`] does; `is_limited`: with the continuous
    /// torque, which only some checks use.
    pub(super) fn electrics(&self, axis: &Axis, drive: &Drive, is_limited: bool) -> Electrics {
        let missing = Missing { symbol: "U_M" };
        let laws = (Ok(self.law.clone()), Ok(drive.heat), drive.voltage.ok_or(missing));
        if is_limited {
            return Electrics::with(axis, &drive.drivetrain, laws);
        }
        let (current, heat, voltage) = laws;
        Electrics { current, heat, voltage, ..Electrics::UNKNOWN }
    }
}

impl<'p> Conditions<'p> {
    pub(super) fn of(screen: &'p Screen, axis: &Axis) -> Self {
        let (ambient, terminal) = (axis.ambient, axis.terminal_voltage());
        let place = |drive: &'p Drive| {
            let law = CurrentLaw::of(axis, &drive.drivetrain).ok()?;
            let air = ambient.unwrap_or_else(|| drive.heat.ambient_reference());
            Some(Place {
                cold: Friction::of(&law.cold),
                at_ambient: Friction::of(&drive.friction.at(air)),
                warmest: Friction::of(&law.warmest),
                ambient_k: air.si(),
                short_time: ShortTime::of(&drive.drivetrain, terminal, &law.cold).ok(),
                law,
            })
        };
        let drives = screen.drives.as_slice();
        let places: Vec<_> = drives.iter().map(|drive| drive.as_ref().and_then(place)).collect();
        let groups = screen.groups(axis);
        let known = |group: &Group| {
            // Bounds hold for the demand with the brakes of the catalogue.
            if BrakeTimes::are_others(&group.representative.brake, axis.brake_times) {
                return None;
            }
            let drive = drives.get(group.drive)?.as_ref()?;
            Some((drive, places.get(group.drive)?.as_ref()?))
        };
        let fours = groups.chunks(4).map(|four| Four::of(four, known)).collect();
        Self { ambient, terminal, drives, groups, fours, places }
    }

    /// Returns `true` if they apply to an axis.
    pub(super) fn are_of(&self, screen: &Screen, axis: &Axis) -> bool {
        let bits = |value: Option<f64>| value.map(f64::to_bits);
        bits(self.ambient.map(Measure::si)) == bits(axis.ambient.map(Measure::si))
            && bits(self.terminal.map(Measure::si)) == bits(axis.terminal_voltage().map(Measure::si))
            && std::ptr::eq(self.groups, screen.groups(axis))
    }

    /// Iterates over the drivetrains, with `None` for those with insufficient data.
    pub(super) fn drives(&self) -> impl Iterator<Item = Option<(&'p Drive, &Place<'p>)>> {
        self.drives.iter().zip(&self.places).map(|(drive, place)| drive.as_ref().zip(place.as_ref()))
    }

    /// Returns one drivetrain.
    pub(super) fn drive(&self, place: usize) -> Option<(&'p Drive, &Place<'p>)> {
        self.drives.get(place)?.as_ref().zip(self.places.get(place)?.as_ref())
    }
}

/// Four groups under equal conditions, each number in the lane of its group; the inverse of an unknown limit is zero.
pub(super) struct Four {
    /// Indices of the drivetrains.
    pub(super) drives: [usize; 4],
    pub(super) is_unknown: [bool; 4],
    /// J_out and J_out/i \[kgm²\]
    pub(super) inertia: f64x4,
    pub(super) inertia_in: f64x4,
    /// 1/k_Tout
    pub(super) per_torque: f64x4,
    pub(super) per_torque_max: f64x4,
    pub(super) per_speed_max: f64x4,
    pub(super) per_speed_rated: f64x4,
    /// Inverse of the limit, and of the limit if it rejects.
    pub(super) per_average_torque_max: [f64x4; 2],
    /// i over the limit, and over the limit if it rejects.
    pub(super) per_input_speed_mean_max: [f64x4; 2],
    pub(super) per_transmissible_load: f64x4,
    pub(super) per_transmissible_housing: f64x4,
    pub(super) per_current_max: f64x4,
    pub(super) per_current_demagnetisation: f64x4,
    /// One, or zero if a published short-time curve may permit more than I_max.
    pub(super) without_curve: f64x4,
    /// 1/I_0²
    pub(super) per_stalled: f64x4,
    /// I_s and K of a gear at the ambient temperature of a cold start, and of the warmest.
    pub(super) cold: [f64x4; 2],
    pub(super) warmest: [f64x4; 2],
    /// I_NLS, I_s and K of a gear at the ambient temperature of the cycle, and of the warmest.
    pub(super) at_ambient: [f64x4; 3],
    pub(super) warm_air: [f64x4; 3],
    /// I_NLS is equal in both, and K falls from one to the other.
    pub(super) is_steady: f64x4,
    /// Decay of K \[1/K\]
    pub(super) decay: f64x4,
    pub(super) copper_ohm: f64x4,
    pub(super) friction_v_s: f64x4,
    /// R_wh, R_ha \[K/W\]
    pub(super) resistances: [f64x4; 2],
    pub(super) coil_w: f64x4,
    /// One if the voltage is known, and p i, R, L and ψ.
    pub(super) has_voltage: f64x4,
    motor: [f64x4; 4],
}

impl Four {
    fn of<'k>(groups: &'k [Group], known: impl Fn(&'k Group) -> Option<(&'k Drive, &'k Place<'k>)>) -> Self {
        let found: [Option<(&Group, &Drive, &Place<'_>)>; 4] = std::array::from_fn(|place| {
            let group = groups.get(place).filter(|group| group.inertia >= 0.0)?;
            known(group).map(|(drive, place)| (group, drive, place))
        });
        let lanes = |of: &dyn Fn(&Group, &Drive, &Place<'_>) -> f64| {
            f64x4::from(found.map(|found| found.map_or(0.0, |(group, drive, place)| of(group, drive, place))))
        };
        let per = |limit: fn(&Drive) -> Option<f64>| lanes(&|_, drive, _| limit(drive).map_or(0.0, f64::recip));
        let friction = |of: fn(&Place<'_>, &Drive) -> Friction| {
            let part = |part: fn(&Friction) -> f64| lanes(&|_, drive, place| part(&of(place, drive)));
            [part(|friction| friction.starting), part(|friction| friction.counted), part(|friction| friction.constant)]
        };
        let ([_, cold, cold_k], at_ambient) = (friction(|place, _| place.cold), friction(|place, _| place.at_ambient));
        let warm_air @ [_, warm, warm_k] = friction(|place, _| place.warmest);
        let decay = lanes(&|_, drive, _| drive.friction.decay_per_k());
        let motor = |place: usize| {
            lanes(&|_, drive, _| drive.voltage.and_then(|motor| motor.constants().get(place).copied()).unwrap_or(0.0))
        };
        Self {
            drives: std::array::from_fn(|place| groups.get(place).map_or(usize::MAX, |group| group.drive)),
            is_unknown: found.map(|found| found.is_none()),
            inertia: lanes(&|group, _, _| group.inertia),
            inertia_in: lanes(&|group, drive, _| group.inertia / drive.ratio),
            per_torque: lanes(&|_, drive, _| 1.0 / drive.torque_constant),
            per_torque_max: per(|drive| Some(drive.torque_max)),
            per_speed_max: per(|drive| Some(drive.speed_max)),
            per_speed_rated: per(|drive| Some(drive.speed_rated)),
            per_average_torque_max: [
                per(|drive| drive.average_torque_max.map(|limit| limit.si)),
                per(|drive| drive.average_torque_max.filter(|limit| limit.rejects).map(|limit| limit.si)),
            ],
            per_input_speed_mean_max: [
                per(|drive| drive.input_speed_mean_max.map(|limit| limit.si / drive.ratio)),
                per(|drive| {
                    drive.input_speed_mean_max.filter(|limit| limit.rejects).map(|limit| limit.si / drive.ratio)
                }),
            ],
            per_transmissible_load: per(|drive| drive.transmissible_load),
            per_transmissible_housing: per(|drive| drive.transmissible_housing),
            per_current_max: per(|drive| drive.current_max),
            per_current_demagnetisation: per(|drive| drive.current_demagnetisation),
            without_curve: lanes(&|_, drive, _| if drive.has_short_time_curve { 0.0 } else { 1.0 }),
            per_stalled: per(|drive| Some(drive.stall_current * drive.stall_current)),
            cold: [cold, cold_k],
            warmest: [warm, warm_k],
            at_ambient,
            warm_air,
            is_steady: at_ambient[0].simd_eq(warm_air[0])
                & at_ambient[1].simd_eq(warm_air[1])
                & decay.simd_ge(f64x4::ZERO),
            decay,
            copper_ohm: lanes(&|_, drive, _| drive.heat.losses().copper_ohm()),
            friction_v_s: lanes(&|_, drive, _| drive.heat.losses().friction_v_s_per_rad()),
            resistances: [0, 1].map(|place| {
                lanes(&|_, drive, _| drive.heat.network().resistances_k_per_w().get(place).copied().unwrap_or(0.0))
            }),
            coil_w: lanes(&|group, _, _| group.coil_w),
            has_voltage: lanes(&|_, drive, _| if drive.voltage.is_some() { 1.0 } else { 0.0 }),
            motor: std::array::from_fn(motor),
        }
    }

    /// Returns an upper bound of the terminal voltage at a speed and a current of at most these magnitudes \[V\], see
    /// [`MotorVoltage::most`].
    pub(super) fn voltage(&self, speed_rad_s: f64, current: f64x4) -> f64x4 {
        let [turns, resistance, inductance, flux] = self.motor;
        let (omega, i_q) = (turns * all(speed_rad_s), current * all(std::f64::consts::SQRT_2));
        let (u_d, u_q) = (omega * inductance * i_q, resistance * i_q + omega * flux);
        (all(1.5) * (u_d * u_d + u_q * u_q)).sqrt()
    }
}

/// Returns bounds of maximum over mean, and of minimum over mean, of the lag of a nonnegative quantity in the steady
/// cycle.
///
/// λ/(1 − e^(−λ)) ≤ 1 + λ/2 + λ²/12, and λ less
///
/// # Symbols
/// λ = t_0/τ
/// # Source
/// docs/theory/sweep.md
pub(super) fn swing(cycle_s: f64, tau: Time) -> [f64; 2] {
    let share = cycle_s / tau.si();
    [(1.0 - share / 2.0).max(0.0), 1.0 + share / 2.0 + share * share / 12.0]
}
