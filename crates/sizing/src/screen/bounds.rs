//! Bounds of the utilisation of each check, from few figures of the axis and of four actuators at a time.

use super::catalogue::{Conditions, Drive, Four, Place, swing};
use crate::axis::Axis;
use crate::check::CheckId;
use crate::supply::Edge;
use quantities::{AngularVelocity, Measure};
use trace::{Extent, Outline};
use wide::f64x4;

/// The checks with bounds, in the order of their places in [`Bounds`].
pub(super) const COVERED: [CheckId; COUNT] = [
    CheckId::PeakTorque,
    CheckId::PeakSpeed,
    CheckId::MeanSpeed,
    CheckId::ContinuousTorque,
    CheckId::PeakCurrent,
    CheckId::Demagnetisation,
    CheckId::Voltage,
    CheckId::GearMeanTorque,
    CheckId::Ambient,
    CheckId::DcLink,
    CheckId::TorqueSpeedTrace,
    CheckId::Thermal,
    CheckId::OverloadI2t,
    CheckId::GearMeanInputSpeed,
    CheckId::ScrewJointLoad,
    CheckId::ScrewJointHousing,
];

const COUNT: usize = 16;

/// The first of them that looks at an actuator which no check of the first stage rejects.
const FIRST_OF_SURVIVORS: usize = 10;

const AMBIENT: u64 = 1 << 8;
const DC_LINK: u64 = 1 << 9;

/// So near a limit a bound decides nothing: far above the rounding of the sums.
pub(super) const ROOM: f64 = 1e-6;

/// The same where a signal is curved: what lies between its nodes is known to such a share.
const ROOM_CURVED: f64 = 1e-3;

/// So near an edge of the range of temperatures the check itself decides \[K\].
const EDGE_K: f64 = 1e-6;

/// One number for four actuators.
pub(super) const fn all(value: f64) -> f64x4 {
    f64x4::new([value; 4])
}

/// Bounds of the signals between some nodes of an axis.
struct Bound {
    extent: Extent,
    /// Largest |α| and |T_L|.
    acceleration: f64,
    load: f64,
}

/// Figures of an axis.
#[derive(Default)]
pub(super) struct Figures {
    outline: Outline,
    bounds: Vec<Bound>,
    room: f64,
    duration: f64,
    duty: f64,
    speed_mean: f64,
    speed_peak: f64,
    load_peak: f64,
    load_mean: f64,
    open_share: f64,
    has_collision: bool,
    ambient: Option<f64>,
    supply: Option<f64>,
    terminal: Option<f64>,
    /// Means of the products of (α, T_L, σ, ω).
    means: [[f64; 4]; 4],
    of_drives: Vec<OfDrive>,
}

impl Figures {
    /// Those of an axis; whether there are any.
    pub(super) fn take(&mut self, axis: &Axis, conditions: &Conditions<'_>) -> bool {
        if !axis.trace.outline(&mut self.outline) {
            return false;
        }
        let moments = axis.moments();
        self.bounds.clear();
        self.bounds.extend(self.outline.extents.iter().map(|extent| Bound {
            extent: *extent,
            acceleration: extent.acceleration_rad_s2.1.max(-extent.acceleration_rad_s2.0),
            load: extent.load_nm.1.max(-extent.load_nm.0),
        }));
        self.outline.nodes.dedup();
        self.room = if self.outline.is_straight { ROOM } else { ROOM_CURVED };
        self.ambient = axis.ambient.map(Measure::si);
        self.duration = moments.duration.si();
        self.duty = moments.duty_factor();
        self.speed_mean = moments.speed_mean().si();
        self.speed_peak = moments.speed_peak.si();
        self.load_peak = moments.load_peak.si();
        self.load_mean = axis.load_cubic_mean().si();
        self.open_share = axis.brake_open_share().si();
        self.has_collision = axis.asked.collision_torque.is_some();
        self.supply = axis.supply.as_ref().map(|supply| supply.at(Edge::High).si());
        self.terminal = conditions.terminal.map(Measure::si);
        self.means = axis.trace.gram().sums().map(|row| row.map(|sum| sum / self.duration));
        let mut of_drives = std::mem::take(&mut self.of_drives);
        of_drives.clear();
        of_drives.extend(
            conditions
                .drives()
                .map(|found| found.map_or(OfDrive::UNKNOWN, |(drive, place)| OfDrive::of(self, drive, place))),
        );
        self.of_drives = of_drives;
        self.duration > 0.0
    }

    fn of_drive(&self, place: usize) -> &OfDrive {
        self.of_drives.get(place).unwrap_or(&OfDrive::UNKNOWN)
    }

    /// Bounds of the largest |J α + T_L|.
    fn torque_peak(&self, inertia: f64x4) -> [f64x4; 2] {
        let (mut low, mut high) = (f64x4::ZERO, f64x4::ZERO);
        for [a, t, ..] in &self.outline.nodes {
            low = low.fast_max((inertia * all(*a) + all(*t)).abs());
        }
        for Bound { extent, .. } in &self.bounds {
            let (least, most) = torques(extent, inertia);
            high = high.fast_max(most).fast_max(-least);
        }
        [low, high]
    }

    /// Mean of (J α + T_L)².
    fn torque_square(&self, inertia: f64x4) -> f64x4 {
        let [[aa, at, ..], [_, tt, ..], ..] = self.means;
        (inertia * (inertia * all(aa) + all(2.0 * at)) + all(tt)).fast_max(f64x4::ZERO)
    }
}

/// All J α + T_L lie between these; J is not negative.
fn torques(extent: &Extent, inertia: f64x4) -> (f64x4, f64x4) {
    let at = |acceleration: f64, load: f64| inertia * all(acceleration) + all(load);
    (at(extent.acceleration_rad_s2.0, extent.load_nm.0), at(extent.acceleration_rad_s2.1, extent.load_nm.1))
}

/// What the actuators of one drivetrain have in common for an axis.
struct OfDrive {
    /// Of the continuous torque and of its upper edge the inverse of both bounds, each of the lower one first.
    continuous: [[f64; 2]; 2],
    /// Inverse of the least torque that is permitted for a short time up to the peak speed.
    short_time: f64,
    /// Largest rise of the winding per mean of copper loss and of friction.
    gains: [f64; 2],
    /// What makes shares of bounds of the rise: of the permitted rise by its lower edge, below and above, and by its upper edge.
    rise: [[f64; 2]; 2],
    /// Largest over mean of the supervision's lag.
    swing: f64,
    /// Supply over what is permitted, where it is above.
    above: f64,
    is_elsewhere: bool,
    /// Checks of the place that decide themselves.
    open: u64,
}

impl OfDrive {
    const UNKNOWN: Self = Self {
        continuous: [[0.0; 2]; 2],
        short_time: 0.0,
        gains: [0.0; 2],
        rise: [[0.0; 2]; 2],
        swing: 0.0,
        above: 0.0,
        is_elsewhere: false,
        open: 0,
    };

    fn of(figures: &Figures, drive: &Drive, place: &Place<'_>) -> Self {
        let short_time = place.short_time.as_ref().map(|short_time| {
            let [still, fastest] = [0.0, figures.speed_peak].map(AngularVelocity::from_si);
            let [least, _] = short_time.least_between(still, fastest);
            1.0 / least.si().min(drive.torque_max)
        });
        let network = drive.heat.network();
        let [quick, slow] = network.time_constants().map(|tau| swing(figures.duration, tau));
        let most = |gain: f64, [least, most]: [f64; 2]| if gain >= 0.0 { gain * most } else { gain * least };
        let sum = |[of_quick, of_slow]: [f64; 2]| most(of_quick, quick) + most(of_slow, slow);
        let gains = network.winding();
        let [_, swing] = swing(figures.duration, drive.heat.winding_time_constant());
        let mut found = Self {
            continuous: drive.continuous.at(figures.speed_mean).map(|bounds| bounds.map(f64::recip)),
            short_time: short_time.unwrap_or(0.0),
            gains: [sum(gains.copper), sum(gains.friction)],
            rise: Self::rise(figures, drive, place),
            swing,
            ..Self::UNKNOWN
        };
        found.place(figures, drive);
        found
    }

    fn rise(figures: &Figures, drive: &Drive, place: &Place<'_>) -> [[f64; 2]; 2] {
        let permitted = drive.heat.winding_limit().si() - place.ambient_k;
        if permitted <= 0.0 {
            return [[0.0, f64::INFINITY]; 2];
        }
        let shares = |[low, high]: [f64; 2], edge: f64| [low / (edge * permitted), high / (edge * permitted)];
        if drive.has_curves {
            let Some(published) = &drive.published else { return [[0.0, f64::INFINITY]; 2] };
            let [least, most] = published.rise_shares(figures.duty);
            return [shares([1.0 / most, 1.0 / least], 1.0); 2];
        }
        let (edge, upper) = drive.heat.band(AngularVelocity::from_si(figures.speed_mean));
        [shares([1.0; 2], edge), shares([1.0; 2], upper)]
    }

    /// Ambient temperature and supply, which neither load nor pace can mend.
    fn place(&mut self, figures: &Figures, drive: &Drive) {
        if let (Some(air), Some((low, high))) = (figures.ambient, drive.ambient_range) {
            // The check itself decides at an edge of the range.
            if air < low - EDGE_K || air > high + EDGE_K {
                self.is_elsewhere = true;
            } else if air < low + EDGE_K || air > high - EDGE_K {
                self.open |= AMBIENT;
            }
        }
        if let (Some(supply), Some(limit)) = (figures.supply, drive.dc_link_max) {
            let share = supply / limit;
            if share > 1.0 + ROOM {
                self.is_elsewhere = true;
                self.above = share;
            } else if share > 1.0 - ROOM {
                self.open |= DC_LINK;
            }
        }
    }
}

/// Bounds of four actuators.
#[derive(Clone, Debug)]
pub(super) struct Bounds {
    room: f64,
    /// Of each: whether it fails for sure, whether where neither load nor pace matter, whether nothing is known.
    fails: [bool; 4],
    is_elsewhere: [bool; 4],
    is_unknown: [bool; 4],
    /// Bit k: whether the check at place k is decided by itself only.
    open: [u64; 4],
    least_first: [f64; 4],
    least: [f64; 4],
    /// Above the utilisation of each check.
    high: [f64x4; COUNT],
}

/// The bounds of one actuator.
#[derive(Clone, Copy, Debug)]
pub(super) struct BoundsOfOne<'b> {
    of: &'b Bounds,
    place: usize,
}

impl BoundsOfOne<'_> {
    fn own<T: Copy>(&self, all: &[T; 4], otherwise: T) -> T {
        all.get(self.place).copied().unwrap_or(otherwise)
    }

    /// Whether nothing is known: then the actuator is judged.
    pub(super) fn is_unknown(&self) -> bool {
        self.own(&self.of.is_unknown, true)
    }

    /// Whether it fails for sure.
    pub(super) fn fails(&self) -> bool {
        self.own(&self.of.fails, false)
    }

    /// Whether it fails where neither load nor pace matter.
    pub(super) fn is_of_another_place(&self) -> bool {
        self.own(&self.of.is_elsewhere, false)
    }

    /// At most its utilisation.
    pub(super) fn least(&self) -> f64 {
        self.own(&self.of.least, 0.0) * (1.0 - self.of.room)
    }

    /// At most the utilisation by the checks of the first stage.
    pub(super) fn least_first(&self) -> f64 {
        self.own(&self.of.least_first, 0.0) * (1.0 - self.of.room)
    }

    /// The checks that its bounds leave open.
    pub(super) fn open(&self) -> Ids {
        Ids(self.own(&self.of.open, u64::MAX))
    }

    /// The checks whose utilisation may be the largest.
    pub(super) fn contenders(&self) -> Ids {
        let least = self.least();
        let may_be = |high: &f64x4| self.own(high.as_array(), f64::INFINITY) * (1.0 + self.of.room) >= least;
        let places = self.of.high.iter().enumerate().filter(|(_, high)| may_be(high));
        Ids(places.fold(0, |all, (place, _)| all | 1 << place) | self.open().0)
    }
}

/// Bounds of four actuators on their way.
struct Found {
    /// Above the first something fails, below the second it does not.
    limits: [f64x4; 2],
    fails: f64x4,
    open: f64x4,
    least: f64x4,
    high: [f64x4; COUNT],
}

impl Found {
    /// A check with bounds of its utilisation, which fails above one.
    #[inline]
    fn take(&mut self, at: usize, [low, high]: [f64x4; 2]) {
        self.take_beside(at, [low, high], [low, high]);
    }

    /// A check with bounds of its utilisation and of its value by the edge above which it fails.
    #[inline]
    fn take_beside(&mut self, at: usize, [low, high]: [f64x4; 2], [sure, most]: [f64x4; 2]) {
        if let Some(known) = self.high.get_mut(at) {
            *known = high;
        }
        self.least = self.least.max(low);
        let [above, below] = self.limits;
        self.fails |= sure.simd_gt(above);
        // Not a number is open too.
        self.open |= !most.simd_lt(below) & all(f64::from_bits(1 << at));
    }

    /// Whether all four fail.
    fn all_fail(&self) -> bool {
        self.fails.all()
    }
}

impl Bounds {
    /// Of one of the four.
    pub(super) const fn of_one(&self, place: usize) -> BoundsOfOne<'_> {
        BoundsOfOne { of: self, place }
    }

    /// Nothing is known.
    pub(super) const UNKNOWN: Self = Self {
        room: ROOM,
        fails: [false; 4],
        is_elsewhere: [false; 4],
        is_unknown: [true; 4],
        open: [u64::MAX; 4],
        least_first: [0.0; 4],
        least: [0.0; 4],
        high: [all(f64::INFINITY); COUNT],
    };

    pub(super) fn of(figures: &Figures, four: &Four) -> Self {
        let of_drives = four.drives.map(|drive| figures.of_drive(drive));
        let is_elsewhere = of_drives.map(|of_drive| of_drive.is_elsewhere);
        let mut found = Found {
            limits: [all(1.0 + figures.room), all(1.0 - figures.room)],
            fails: f64x4::ZERO,
            open: f64x4::from(of_drives.map(|of_drive| f64::from_bits(of_drive.open))),
            least: f64x4::from(of_drives.map(|of_drive| of_drive.above)),
            high: [f64x4::ZERO; COUNT],
        };
        let least_first = found.of_four(figures, four, of_drives);
        let fails = found.fails.to_array().map(|fails| fails.to_bits() != 0);
        let fails = std::array::from_fn(|place| {
            let at = |all: &[bool; 4]| all.get(place).copied().unwrap_or(false);
            (at(&fails) || at(&is_elsewhere)) && !at(&four.is_unknown)
        });
        Self {
            room: figures.room,
            fails,
            is_elsewhere,
            is_unknown: four.is_unknown,
            open: found.open.to_array().map(f64::to_bits),
            least_first: least_first.to_array(),
            least: found.least.to_array(),
            high: found.high,
        }
    }
}

impl Found {
    /// The checks one stage after the other, as long as one of the four may fit; the least of the first stage.
    fn of_four(&mut self, figures: &Figures, four: &Four, of_drives: [&OfDrive; 4]) -> f64x4 {
        let peak = figures.torque_peak(four.inertia);
        let square = figures.torque_square(four.inertia);
        self.speeds(figures, four);
        self.take(0, peak.map(|torque| torque * four.per_torque_max));
        let effective = square.sqrt();
        let edge = |edge: fn(&OfDrive) -> f64| effective * f64x4::from(of_drives.map(edge));
        self.take_beside(
            3,
            [edge(|drive| drive.continuous[0][1]), edge(|drive| drive.continuous[0][0])],
            [edge(|drive| drive.continuous[1][1]), edge(|drive| drive.continuous[1][0])],
        );
        if self.all_fail() {
            return self.least;
        }
        self.currents(figures, four);
        let least_first = self.least;
        if self.all_fail() {
            return least_first;
        }
        self.joints(figures, four);
        let per_short_time = f64x4::from(of_drives.map(|drive| drive.short_time));
        let [_, peak] = peak;
        self.take(FIRST_OF_SURVIVORS, [f64x4::ZERO, peak * per_short_time]);
        self.heat(figures, four, of_drives, square);
        least_first
    }

    fn speeds(&mut self, figures: &Figures, four: &Four) {
        let share = |value: f64, per_limit: f64x4| [all(value) * per_limit; 2];
        self.take(1, share(figures.speed_peak, four.per_speed_max));
        self.take(2, share(figures.speed_mean, four.per_speed_rated));
        self.take(7, share(figures.load_mean, four.per_average_torque_max));
    }

    /// What the gear's input and the screws bear.
    fn joints(&mut self, figures: &Figures, four: &Four) {
        self.take(13, [all(figures.speed_mean) * four.per_input_speed_mean_max; 2]);
        let load = all(figures.load_peak) * four.per_transmissible_load;
        // |T_L| + (J_out/i) |α|
        let mut housing = f64x4::ZERO;
        for Bound { acceleration, load, .. } in &figures.bounds {
            housing = housing.fast_max(four.inertia_in * all(*acceleration) + all(*load));
        }
        let housing = housing * four.per_transmissible_housing;
        let [load_most, housing] =
            [load, housing].map(|most| if figures.has_collision { all(f64::INFINITY) } else { most });
        self.take(14, [load, load_most]);
        self.take(15, [f64x4::ZERO, housing]);
    }

    fn currents(&mut self, figures: &Figures, four: &Four) {
        let (inertia, per_torque) = (four.inertia, four.per_torque);
        let ([cold, cold_k], [warm, warm_k]) = (four.cold, four.warmest);
        let (mut high, mut volts) = (f64x4::ZERO, f64x4::ZERO);
        for Bound { extent, .. } in &figures.bounds {
            let (least, most) = torques(extent, inertia);
            let ((back, forth), (slowest, fastest)) = (extent.direction, extent.speeds_rad_s);
            // Of any friction between both, a sum of parts with the sign of the motion.
            let of = |direction: f64, speed: f64| {
                let of = |counted: f64x4, constant: f64x4| all(direction) * counted + all(speed) * constant;
                (of(cold, cold_k), of(warm, warm_k))
            };
            let (by_cold, by_warm) = of(forth, fastest);
            let upper = most * per_torque + by_cold.fast_max(by_warm);
            let (by_cold, by_warm) = of(back, slowest);
            let lower = least * per_torque + by_cold.fast_min(by_warm);
            let current = upper.fast_max(-lower);
            high = high.fast_max(current);
            if figures.terminal.is_some() {
                volts = volts.fast_max(four.voltage(extent.speed_rad_s, current));
            }
        }
        let (mut low, mut sure) = (f64x4::ZERO, f64x4::ZERO);
        for [a, t, s, w] in &figures.outline.nodes {
            let torque = (inertia * all(*a) + all(*t)) * per_torque;
            let (s, w) = (all(*s), all(w.abs()));
            let most = cold + cold_k * w;
            low = low.fast_max((torque + s * most).abs());
            // Of any friction between both.
            let [least, most] = [warm + warm_k * w, most].map(|friction| s.abs() * friction);
            let braking = (torque * s).simd_lt(f64x4::ZERO);
            let magnitude = torque.abs();
            sure = sure.fast_max(braking.select((magnitude - most).fast_max(f64x4::ZERO), magnitude + least));
        }
        let share = |current: f64x4| current * four.per_current_max;
        // A published curve may permit more than I_max.
        self.take_beside(
            4,
            [share(low) * four.without_curve, share(high)],
            [share(sure) * four.without_curve, share(high)],
        );
        self.take(5, [low, high].map(|current| current * four.per_current_demagnetisation));
        if let Some(terminal) = figures.terminal {
            self.take(6, [f64x4::ZERO, volts * all(1.0 / terminal) * four.has_voltage]);
        }
    }

    fn heat(&mut self, figures: &Figures, four: &Four, of_drives: [&OfDrive; 4], square: f64x4) {
        let [[_, _, a_s, a_w], [_, _, t_s, t_w], [_, _, moving, travelled], [.., w_w]] =
            figures.means.map(|row| row.map(all));
        let per_torque = four.per_torque;
        let of_square = square * per_torque * per_torque;
        let of_direction = (four.inertia * a_s + t_s) * per_torque;
        let of_speed = (four.inertia * a_w + t_w) * per_torque;
        let two = all(2.0);
        // Mean of I²: of I_T + I_s σ + K ω a parabola in I_s and in K, largest at a corner.
        let mean = |counted: f64x4, constant: f64x4| {
            of_square
                + counted * (counted * moving + two * (of_direction + constant * travelled))
                + constant * (constant * w_w + two * of_speed)
        };
        let friction = |starting: f64x4, constant: f64x4| four.friction_v_s * (starting * travelled + constant * w_w);
        let ([warm_starting, warm_counted, warm_k], [cool_starting, cool_counted, cool_k]) =
            (four.warm_air, four.at_ambient);
        let coil = four.coil_w * all(figures.open_share);
        let [r_wh, r_ha] = four.resistances;
        // The losses fall as the housing warms: then two temperatures of which each is that of the losses of the other one
        // hold the settled one between them.
        let rise = |constant: f64x4| {
            let copper = four.copper_ohm * mean(warm_counted, constant).fast_max(f64x4::ZERO);
            r_ha * (copper + friction(warm_starting, constant) + coil)
        };
        let settled = |constant: f64x4| warm_k.fast_max(cool_k * (-four.decay * rise(constant)).exp());
        let slope =
            two * four.copper_ohm * (of_speed + warm_counted * travelled + warm_k * w_w) + four.friction_v_s * w_w;
        let falls = four.is_steady & slope.simd_ge(f64x4::ZERO);
        let [least_k, most_k] = if falls.any() {
            let most = settled(settled(cool_k));
            let least = settled(most);
            [falls.select(least * all(1.0 - SETTLED), warm_k), falls.select(most * all(1.0 + SETTLED), cool_k)]
        } else {
            [warm_k, cool_k]
        };
        let current_high = mean(warm_counted, least_k)
            .fast_max(mean(warm_counted, most_k))
            .fast_max(mean(cool_counted, least_k))
            .fast_max(mean(cool_counted, most_k))
            .fast_max(f64x4::ZERO);
        let vertex = if figures.means[3][3] > 0.0 {
            (-(of_speed + warm_counted * travelled) / w_w).fast_max(least_k).fast_min(most_k)
        } else {
            least_k
        };
        let current_low = four.is_steady.select(mean(warm_counted, vertex).fast_max(f64x4::ZERO), f64x4::ZERO);
        let [copper_low, copper_high] = [current_low, current_high].map(|square| four.copper_ohm * square);
        let [friction_low, friction_high] = [friction(warm_starting, least_k), friction(cool_starting, most_k)];
        let of_drive = |figure: fn(&OfDrive) -> f64| f64x4::from(of_drives.map(figure));
        let [by_copper, by_friction] = [of_drive(|drive| drive.gains[0]), of_drive(|drive| drive.gains[1])];
        let high = copper_high * by_copper + friction_high * by_friction + coil * r_ha;
        let low = copper_low * (r_wh + r_ha) + friction_low * r_ha + coil * r_ha;
        self.take_beside(
            11,
            [low * of_drive(|drive| drive.rise[0][0]), high * of_drive(|drive| drive.rise[0][1])],
            [low * of_drive(|drive| drive.rise[1][0]), high * of_drive(|drive| drive.rise[1][1])],
        );
        let swing = of_drive(|drive| drive.swing);
        self.take(12, [f64x4::ZERO, current_high * four.per_stalled * swing]);
    }
}

/// The friction of the settled cycle is known to this share: the root of its equation is found to 10⁻¹⁰ of the temperature.
const SETTLED: f64 = 1e-7;

/// Some of the covered checks.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ids(u64);

impl Ids {
    pub(super) const fn is_empty(self) -> bool {
        self.0 == 0
    }

    pub(super) fn iter(self) -> impl Iterator<Item = CheckId> {
        COVERED.into_iter().enumerate().filter(move |(place, _)| self.0 >> place & 1 == 1).map(|(_, id)| id)
    }
}
