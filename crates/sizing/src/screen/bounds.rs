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

/// The places of the checks that neither load nor pace can mend.
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

    /// Below the largest |J α + T_L|.
    fn torque_peak_low(&self, inertia: f64x4) -> f64x4 {
        let of = |low: f64x4, [a, t, ..]: &[f64; 4]| low.fast_max((inertia * all(*a) + all(*t)).abs());
        self.outline.nodes.iter().fold(f64x4::ZERO, of)
    }

    /// Above it.
    fn torque_peak_high(&self, inertia: f64x4) -> f64x4 {
        let of = |high: f64x4, Bound { extent, .. }: &Bound| {
            let (least, most) = torques(extent, inertia);
            high.fast_max(most).fast_max(-least)
        };
        self.bounds.iter().fold(f64x4::ZERO, of)
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

/// Bounds of four actuators. Those below cost as much as those above and are found only where they count.
#[derive(Clone, Debug)]
pub(super) struct Bounds {
    /// Above the first something fails, below the second it does not.
    limits: [f64x4; 2],
    room: f64,
    is_elsewhere: [bool; 4],
    is_unknown: [bool; 4],
    has_low: bool,
    /// Whether it fails for sure.
    fails: f64x4,
    /// Bit k: whether the check at place k is decided by itself only.
    open: f64x4,
    least_first: f64x4,
    least: f64x4,
    /// Above the utilisation of each check.
    high: [f64x4; COUNT],
    /// Mean of (J α + T_L)².
    square: f64x4,
    /// Bounds of K in the settled cycle.
    constant: [f64x4; 2],
}

/// The bounds of one actuator.
#[derive(Clone, Copy, Debug)]
pub(super) struct BoundsOfOne<'b> {
    of: &'b Bounds,
    place: usize,
}

impl BoundsOfOne<'_> {
    fn own(&self, all: &f64x4) -> f64 {
        all.as_array().get(self.place).copied().unwrap_or(f64::NAN)
    }

    fn is(&self, all: &[bool; 4]) -> bool {
        all.get(self.place).copied().unwrap_or(true)
    }

    /// Whether nothing is known: then the actuator is judged.
    pub(super) fn is_unknown(&self) -> bool {
        self.is(&self.of.is_unknown)
    }

    /// Whether it fails for sure.
    pub(super) fn fails(&self) -> bool {
        !self.is_unknown() && (self.is(&self.of.is_elsewhere) || self.own(&self.of.fails).to_bits() != 0)
    }

    /// Whether it fails where neither load nor pace matter.
    pub(super) fn is_of_another_place(&self) -> bool {
        !self.is_unknown() && self.is(&self.of.is_elsewhere)
    }

    /// At most its utilisation.
    pub(super) fn least(&self) -> f64 {
        self.own(&self.of.least) * (1.0 - self.of.room)
    }

    /// At most the utilisation by the checks of the first stage.
    pub(super) fn least_first(&self) -> f64 {
        self.own(&self.of.least_first) * (1.0 - self.of.room)
    }

    /// The checks that its bounds leave open.
    pub(super) fn open(&self) -> Ids {
        Ids(self.own(&self.of.open).to_bits())
    }

    /// The checks whose utilisation may be the largest.
    pub(super) fn contenders(&self) -> Ids {
        let least = self.least();
        let may_be = |high: &f64x4| self.own(high) * (1.0 + self.of.room) >= least;
        let places = self.of.high.iter().enumerate().filter(|(_, high)| may_be(high));
        Ids(places.fold(0, |all, (place, _)| all | 1 << place) | self.open().0)
    }
}

impl Bounds {
    /// Of one of the four.
    pub(super) const fn of_one(&self, place: usize) -> BoundsOfOne<'_> {
        BoundsOfOne { of: self, place }
    }

    /// Nothing is known.
    pub(super) const UNKNOWN: Self = Self {
        limits: [f64x4::ONE; 2],
        room: ROOM,
        is_elsewhere: [false; 4],
        is_unknown: [true; 4],
        has_low: true,
        fails: f64x4::ZERO,
        open: all(f64::from_bits((1 << COUNT) - 1)),
        least_first: f64x4::ZERO,
        least: f64x4::ZERO,
        high: [all(f64::INFINITY); COUNT],
        square: f64x4::ZERO,
        constant: [f64x4::ZERO; 2],
    };

    /// Takes those above, and where these leave something open those below.
    pub(super) fn look(&mut self, figures: &Figures, four: &Four) {
        let of_drives = four.drives.map(|drive| figures.of_drive(drive));
        let above = f64x4::from(of_drives.map(|of_drive| of_drive.above));
        self.limits = [all(1.0 + figures.room), all(1.0 - figures.room)];
        self.room = figures.room;
        self.is_elsewhere = of_drives.map(|of_drive| of_drive.is_elsewhere);
        self.is_unknown = four.is_unknown;
        self.has_low = false;
        self.fails = f64x4::ZERO;
        self.open = f64x4::from(of_drives.map(|of_drive| f64::from_bits(of_drive.open)));
        self.least = above;
        self.high = [f64x4::ZERO; COUNT];
        self.square = figures.torque_square(four.inertia);
        self.look_above(figures, four, of_drives);
        if self.open.to_array().iter().any(|open| open.to_bits() != 0) {
            self.look_below(figures, four);
        }
    }

    /// A check whose utilisation is below this.
    #[inline]
    fn below(&mut self, at: usize, high: f64x4) {
        self.below_beside(at, high, high);
    }

    /// A check whose utilisation is below the first, and its value by the edge above which it fails below the second.
    #[inline]
    fn below_beside(&mut self, at: usize, high: f64x4, most: f64x4) {
        if let Some(known) = self.high.get_mut(at) {
            *known = high;
        }
        let [_, below] = self.limits;
        // Not a number is open too.
        self.open |= !most.simd_lt(below) & all(f64::from_bits(1 << at));
    }

    /// A check whose utilisation is above this.
    #[inline]
    fn above(&mut self, low: f64x4) {
        self.above_beside(low, low);
    }

    /// The same, and its value by the edge above which it fails above the second.
    #[inline]
    fn above_beside(&mut self, low: f64x4, sure: f64x4) {
        let [above, _] = self.limits;
        self.least = self.least.max(low);
        self.fails |= sure.simd_gt(above);
    }

    /// A check whose utilisation is known.
    fn known(&mut self, at: usize, share: f64x4) {
        self.below(at, share);
        self.above(share);
    }

    fn look_above(&mut self, figures: &Figures, four: &Four, of_drives: [&OfDrive; 4]) {
        self.known(1, all(figures.speed_peak) * four.per_speed_max);
        self.known(2, all(figures.speed_mean) * four.per_speed_rated);
        self.known(7, all(figures.load_mean) * four.per_average_torque_max);
        self.least_first = self.least;
        self.known(13, all(figures.speed_mean) * four.per_input_speed_mean_max);
        let of_drive = |figure: fn(&OfDrive) -> f64| f64x4::from(of_drives.map(figure));
        let peak = figures.torque_peak_high(four.inertia);
        self.below(0, peak * four.per_torque_max);
        self.below(10, peak * of_drive(|drive| drive.short_time));
        let effective = self.square.sqrt();
        let [share, most] = [of_drive(|drive| drive.continuous[0][0]), of_drive(|drive| drive.continuous[1][0])];
        self.below_beside(3, effective * share, effective * most);
        self.joints(figures, four);
        self.currents_above(figures, four);
        self.heat_above(figures, four, of_drives);
    }

    /// What is below the utilisations, unless it is known already.
    pub(super) fn look_below(&mut self, figures: &Figures, four: &Four) {
        if self.has_low {
            return;
        }
        self.has_low = true;
        let of_drives = four.drives.map(|drive| figures.of_drive(drive));
        let of_drive = |figure: fn(&OfDrive) -> f64| f64x4::from(of_drives.map(figure));
        let beyond_first = self.least;
        self.least = self.least_first;
        self.above(figures.torque_peak_low(four.inertia) * four.per_torque_max);
        let effective = self.square.sqrt();
        let [share, sure] = [of_drive(|drive| drive.continuous[0][1]), of_drive(|drive| drive.continuous[1][1])];
        self.above_beside(effective * share, effective * sure);
        self.currents_below(figures, four);
        self.least_first = self.least;
        self.least = self.least.max(beyond_first);
        let rise = self.rise_below(figures, four);
        let [share, sure] = [of_drive(|drive| drive.rise[0][0]), of_drive(|drive| drive.rise[1][0])];
        self.above_beside(rise * share, rise * sure);
    }

    /// What the screws bear.
    fn joints(&mut self, figures: &Figures, four: &Four) {
        let load = all(figures.load_peak) * four.per_transmissible_load;
        self.above(load);
        // |T_L| + (J_out/i) |α|
        let most = |most: f64x4, Bound { acceleration, load, .. }: &Bound| {
            most.fast_max(four.inertia_in * all(*acceleration) + all(*load))
        };
        let housing = figures.bounds.iter().fold(f64x4::ZERO, most) * four.per_transmissible_housing;
        let [load, housing] = [load, housing].map(|most| if figures.has_collision { all(f64::INFINITY) } else { most });
        self.below(14, load);
        self.below(15, housing);
    }

    fn currents_above(&mut self, figures: &Figures, four: &Four) {
        let ([cold, cold_k], [warm, warm_k]) = (four.cold, four.warmest);
        let (mut high, mut volts) = (f64x4::ZERO, f64x4::ZERO);
        for Bound { extent, .. } in &figures.bounds {
            let (least, most) = torques(extent, four.inertia);
            let ((back, forth), (slowest, fastest)) = (extent.direction, extent.speeds_rad_s);
            // Of any friction between both, a sum of parts with the sign of the motion.
            let of = |direction: f64, speed: f64| {
                let of = |counted: f64x4, constant: f64x4| all(direction) * counted + all(speed) * constant;
                (of(cold, cold_k), of(warm, warm_k))
            };
            let (by_cold, by_warm) = of(forth, fastest);
            let upper = most * four.per_torque + by_cold.fast_max(by_warm);
            let (by_cold, by_warm) = of(back, slowest);
            let lower = least * four.per_torque + by_cold.fast_min(by_warm);
            let current = upper.fast_max(-lower);
            high = high.fast_max(current);
            if figures.terminal.is_some() {
                volts = volts.fast_max(four.voltage(extent.speed_rad_s, current));
            }
        }
        self.below(4, high * four.per_current_max);
        self.below(5, high * four.per_current_demagnetisation);
        if let Some(terminal) = figures.terminal {
            self.below(6, volts * all(1.0 / terminal) * four.has_voltage);
        }
    }

    fn currents_below(&mut self, figures: &Figures, four: &Four) {
        let ([cold, cold_k], [warm, warm_k]) = (four.cold, four.warmest);
        let (mut low, mut sure) = (f64x4::ZERO, f64x4::ZERO);
        for [a, t, s, w] in &figures.outline.nodes {
            let torque = (four.inertia * all(*a) + all(*t)) * four.per_torque;
            let (s, w) = (all(*s), all(w.abs()));
            let most = cold + cold_k * w;
            low = low.fast_max((torque + s * most).abs());
            // Of any friction between both.
            let [least, most] = [warm + warm_k * w, most].map(|friction| s.abs() * friction);
            let braking = (torque * s).simd_lt(f64x4::ZERO);
            let magnitude = torque.abs();
            sure = sure.fast_max(braking.select((magnitude - most).fast_max(f64x4::ZERO), magnitude + least));
        }
        // A published curve may permit more than I_max.
        let per_limit = four.per_current_max * four.without_curve;
        self.above_beside(low * per_limit, sure * per_limit);
        self.above(low * four.per_current_demagnetisation);
    }

    fn heat_above(&mut self, figures: &Figures, four: &Four, of_drives: [&OfDrive; 4]) {
        let means = Means::of(figures, four, self.square);
        let ([warm_starting, warm, warm_k], [cool_starting, cool, cool_k]) = (four.warm_air, four.at_ambient);
        let coil = four.coil_w * all(figures.open_share);
        let [_, r_ha] = four.resistances;
        // The losses fall as the housing warms: then two temperatures of which each is that of the losses of the other one
        // hold the settled one between them.
        let falls = four.is_steady & means.by_constant(four, warm, warm_k).simd_ge(f64x4::ZERO);
        let [least_k, most_k] = if falls.any() {
            let exponent = |constant: f64x4| {
                let copper = four.copper_ohm * means.square(warm, constant).fast_max(f64x4::ZERO);
                four.decay * r_ha * (copper + means.friction(four, warm_starting, constant) + coil)
            };
            let least = warm_k.fast_max(cool_k * decay_below(exponent(cool_k)));
            let most = warm_k.fast_max(cool_k * decay_above(exponent(least)));
            let least = warm_k.fast_max(cool_k * decay_below(exponent(most)));
            [falls.select(least * all(1.0 - SETTLED), warm_k), falls.select(most * all(1.0 + SETTLED), cool_k)]
        } else {
            [warm_k, cool_k]
        };
        self.constant = [least_k, most_k];
        // A parabola in I_s and in K is largest at a corner.
        let corners = |counted: f64x4| means.square(counted, least_k).fast_max(means.square(counted, most_k));
        let mut square = corners(cool).fast_max(f64x4::ZERO);
        if !four.is_steady.all() {
            square = square.fast_max(corners(warm));
        }
        let of_drive = |figure: fn(&OfDrive) -> f64| f64x4::from(of_drives.map(figure));
        let [by_copper, by_friction] = [of_drive(|drive| drive.gains[0]), of_drive(|drive| drive.gains[1])];
        let friction = means.friction(four, cool_starting, most_k);
        let rise = four.copper_ohm * square * by_copper + friction * by_friction + coil * r_ha;
        let [share, most] = [of_drive(|drive| drive.rise[0][1]), of_drive(|drive| drive.rise[1][1])];
        self.below_beside(11, rise * share, rise * most);
        self.below(12, square * four.per_stalled * of_drive(|drive| drive.swing));
    }

    /// Below the largest rise of the winding: its mean \[K\].
    fn rise_below(&self, figures: &Figures, four: &Four) -> f64x4 {
        let means = Means::of(figures, four, self.square);
        let ([starting, counted, _], [least_k, most_k]) = (four.warm_air, self.constant);
        let square = means.square(counted, means.vertex(counted).fast_max(least_k).fast_min(most_k));
        let square = four.is_steady.select(square.fast_max(f64x4::ZERO), f64x4::ZERO);
        let [r_wh, r_ha] = four.resistances;
        let housing = means.friction(four, starting, least_k) + four.coil_w * all(figures.open_share);
        four.copper_ohm * square * (r_wh + r_ha) + housing * r_ha
    }
}

/// Means over the cycle from which the losses follow for any friction.
struct Means {
    /// Of I_T², I_T σ and I_T ω.
    square: f64x4,
    direction: f64x4,
    speed: f64x4,
    /// Of σ², |ω| and ω².
    moving: f64x4,
    travelled: f64x4,
    speed_square: f64x4,
}

impl Means {
    fn of(figures: &Figures, four: &Four, square: f64x4) -> Self {
        let [[_, _, a_s, a_w], [_, _, t_s, t_w], [_, _, moving, travelled], [.., w_w]] =
            figures.means.map(|row| row.map(all));
        Self {
            square: square * four.per_torque * four.per_torque,
            direction: (four.inertia * a_s + t_s) * four.per_torque,
            speed: (four.inertia * a_w + t_w) * four.per_torque,
            moving,
            travelled,
            speed_square: w_w,
        }
    }

    /// Mean of I² = (I_T + I_s σ + K ω)², a convex parabola in I_s and in K.
    fn square(&self, counted: f64x4, constant: f64x4) -> f64x4 {
        let two = all(2.0);
        self.square
            + counted * (counted * self.moving + two * (self.direction + constant * self.travelled))
            + constant * (constant * self.speed_square + two * self.speed)
    }

    /// The K at which it is least.
    fn vertex(&self, counted: f64x4) -> f64x4 {
        let at_rest = self.speed_square.simd_eq(f64x4::ZERO);
        at_rest.select(f64x4::ZERO, -(self.speed + counted * self.travelled) / self.speed_square)
    }

    /// Friction loss \[W\].
    fn friction(&self, four: &Four, starting: f64x4, constant: f64x4) -> f64x4 {
        four.friction_v_s * (starting * self.travelled + constant * self.speed_square)
    }

    /// Growth of both losses with K; it rises with K.
    fn by_constant(&self, four: &Four, counted: f64x4, constant: f64x4) -> f64x4 {
        let of_square = self.speed + counted * self.travelled + constant * self.speed_square;
        all(2.0) * four.copper_ohm * of_square + four.friction_v_s * self.speed_square
    }
}

/// The friction of the settled cycle is known to this share: the root of its equation is found to 10⁻¹⁰ of the temperature.
const SETTLED: f64 = 1e-7;

/// Below e^(−x): the eighth power of 1 − y + y²/2 − y³/6, y = x/8.
fn decay_below(x: f64x4) -> f64x4 {
    let y = x * all(0.125);
    let root = f64x4::ONE - y * (f64x4::ONE - y * (all(0.5) - y * all(1.0 / 6.0)));
    eighth_power(root.fast_max(f64x4::ZERO))
}

/// Above it: the same with y⁴/24.
fn decay_above(x: f64x4) -> f64x4 {
    let y = x * all(0.125);
    let root = f64x4::ONE - y * (f64x4::ONE - y * (all(0.5) - y * (all(1.0 / 6.0) - y * all(1.0 / 24.0))));
    eighth_power(root.fast_min(f64x4::ONE))
}

fn eighth_power(root: f64x4) -> f64x4 {
    let square = root * root;
    let fourth = square * square;
    fourth * fourth
}

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
