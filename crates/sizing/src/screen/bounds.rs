//! Bounds of the utilisation of each check, from few characteristic values of the axis and of four actuators at a time.

use super::catalogue::Four;
use super::figures::{Bound, Figures, OfDrive, all, torques};
use super::losses::{Means, decay_above, decay_below};
use crate::check::CheckId;
use wide::f64x4;

/// Checks with bounds, in the order of their bits in [`Bounds`].
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

/// Distance from a limit within which a bound decides nothing: far above the rounding of the sums.
pub(super) const ROOM: f64 = 1e-6;

/// Bounds of four actuators. The lower ones cost as much as the upper ones and are computed only if they matter.
#[derive(Clone, Debug)]
pub(super) struct Bounds {
    /// Limits of the bounds: above the first a check fails, below the second it does not.
    limits: [f64x4; 2],
    room: f64,
    is_elsewhere: [bool; 4],
    is_unknown: [bool; 4],
    has_low: bool,
    /// Mask of the actuators that certainly fail.
    fails: f64x4,
    /// Bit k: the check at place k is decided only by the check itself.
    open: f64x4,
    /// Bit k: the check at place k may exceed its limit, at least within the band of an estimate.
    near: f64x4,
    /// Lower bound of the utilisation of certainly failing checks.
    least_failing: f64x4,
    least: f64x4,
    /// Upper bound of the utilisation of each check.
    high: [f64x4; COUNT],
    /// Mean of (J α + T_L)².
    square: f64x4,
    /// Bounds of K in the settled cycle.
    constant: [f64x4; 2],
}

/// Bounds of one actuator.
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

    /// Returns `true` if no bounds are known: then the actuator is judged.
    pub(super) fn is_unknown(&self) -> bool {
        self.is(&self.of.is_unknown)
    }

    /// Returns `true` if it certainly fails.
    pub(super) fn fails(&self) -> bool {
        !self.is_unknown() && (self.is(&self.of.is_elsewhere) || self.own(&self.of.fails).to_bits() != 0)
    }

    /// Returns `true` if it fails by a check that depends neither on load nor on pace.
    pub(super) fn is_of_another_place(&self) -> bool {
        !self.is_unknown() && self.is(&self.of.is_elsewhere)
    }

    /// Returns a lower bound of its utilisation.
    pub(super) fn least(&self) -> f64 {
        self.own(&self.of.least) * (1.0 - self.of.room)
    }

    /// Returns a lower bound of the utilisation of its governing check if it fails.
    pub(super) fn least_failing(&self) -> f64 {
        self.own(&self.of.least_failing) * (1.0 - self.of.room)
    }

    /// Returns `true` if a limit is certainly exceeded, at least within the band of an estimate.
    pub(super) fn is_beyond_a_limit(&self) -> bool {
        self.of.has_low && self.least() > 1.0 + ROOM
    }

    /// Returns the checks that may exceed their limit, at least within the band of an estimate; including undecided
    /// ones.
    pub(super) fn exceeding(&self) -> Ids {
        Ids(self.own(&self.of.near).to_bits() | self.open().0)
    }

    /// Returns the checks that its bounds do not decide.
    pub(super) fn open(&self) -> Ids {
        Ids(self.own(&self.of.open).to_bits())
    }

    /// Returns the checks whose utilisation may be the largest.
    pub(super) fn contenders(&self) -> Ids {
        let least = self.least();
        let may_be = |high: &f64x4| self.own(high) * (1.0 + self.of.room) >= least;
        let places = self.of.high.iter().enumerate().filter(|(_, high)| may_be(high));
        Ids(places.fold(0, |all, (place, _)| all | 1 << place) | self.open().0)
    }
}

impl Bounds {
    /// Returns the bounds of one of the four.
    pub(super) const fn of_one(&self, place: usize) -> BoundsOfOne<'_> {
        BoundsOfOne { of: self, place }
    }

    /// Bounds without information.
    pub(super) const UNKNOWN: Self = Self {
        limits: [f64x4::ONE; 2],
        room: ROOM,
        is_elsewhere: [false; 4],
        is_unknown: [true; 4],
        has_low: true,
        fails: f64x4::ZERO,
        open: all(f64::from_bits((1 << COUNT) - 1)),
        near: all(f64::from_bits((1 << COUNT) - 1)),
        least_failing: f64x4::ZERO,
        least: f64x4::ZERO,
        high: [all(f64::INFINITY); COUNT],
        square: f64x4::ZERO,
        constant: [f64x4::ZERO; 2],
    };

    /// Updates the upper bounds and, if they leave checks undecided, the lower bounds.
    pub(super) fn update(&mut self, figures: &Figures, four: &Four) {
        let of_drives = four.drives.map(|drive| figures.of_drive(drive));
        let above = f64x4::from(of_drives.map(|of_drive| of_drive.above));
        self.limits = [all(1.0 + figures.room), all(1.0 - figures.room)];
        self.room = figures.room;
        self.is_elsewhere = of_drives.map(|of_drive| of_drive.is_elsewhere);
        self.is_unknown = four.is_unknown;
        self.has_low = false;
        self.fails = f64x4::ZERO;
        self.open = f64x4::from(of_drives.map(|of_drive| f64::from_bits(of_drive.open)));
        self.near = f64x4::ZERO;
        self.least = above;
        self.least_failing = above;
        self.high = [f64x4::ZERO; COUNT];
        self.square = figures.torque_square(four.inertia);
        self.look_above(figures, four, of_drives);
        if (self.open | self.near).to_array().iter().any(|open| open.to_bits() != 0) {
            self.look_below(figures, four);
        }
    }

    /// Records an upper bound of the utilisation of a check.
    #[inline]
    fn below(&mut self, at: usize, high: f64x4) {
        self.below_beside(at, high, high);
    }

    /// Records an upper bound of the utilisation of a check, and one of its value relative to the edge above which it
    /// fails.
    #[inline]
    fn below_beside(&mut self, at: usize, high: f64x4, most: f64x4) {
        if let Some(known) = self.high.get_mut(at) {
            *known = high;
        }
        let [_, below] = self.limits;
        // NaN leaves the check undecided.
        let bit = all(f64::from_bits(1 << at));
        self.open |= !most.simd_lt(below) & bit;
        self.near |= !high.simd_lt(below) & bit;
    }

    /// Records a lower bound of the utilisation of a check.
    #[inline]
    fn above(&mut self, low: f64x4) {
        self.above_beside(low, low);
    }

    /// Records a lower bound of the utilisation of a check, and one of its value relative to the edge above which it
    /// fails.
    #[inline]
    fn above_beside(&mut self, low: f64x4, sure: f64x4) {
        let [above, _] = self.limits;
        let fails = sure.simd_gt(above);
        self.least = self.least.max(low);
        self.least_failing = self.least_failing.max(low & fails);
        self.fails |= fails;
    }

    /// Records the known utilisation of a check.
    fn known(&mut self, at: usize, share: f64x4) {
        self.known_beside(at, [share; 2]);
    }

    /// A check whose utilisation is known, and its value over the limit beyond which it fails: zero where it only advises.
    fn known_beside(&mut self, at: usize, [share, fails]: [f64x4; 2]) {
        self.below_beside(at, share, fails);
        self.above_beside(share, fails);
    }

    fn look_above(&mut self, figures: &Figures, four: &Four, of_drives: [&OfDrive; 4]) {
        self.known(1, all(figures.speed_peak) * four.per_speed_max);
        self.known(2, all(figures.speed_mean) * four.per_speed_rated);
        self.known_beside(7, four.per_average_torque_max.map(|per| all(figures.load_mean) * per));
        self.known_beside(13, four.per_input_speed_mean_max.map(|per| all(figures.speed_mean) * per));
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

    /// Computes the lower bounds of the utilisations, unless they are known.
    pub(super) fn look_below(&mut self, figures: &Figures, four: &Four) {
        if self.has_low {
            return;
        }
        self.has_low = true;
        let of_drives = four.drives.map(|drive| figures.of_drive(drive));
        let of_drive = |figure: fn(&OfDrive) -> f64| f64x4::from(of_drives.map(figure));
        self.above(figures.torque_peak_low(four.inertia) * four.per_torque_max);
        let effective = self.square.sqrt();
        let [share, sure] = [of_drive(|drive| drive.continuous[0][1]), of_drive(|drive| drive.continuous[1][1])];
        self.above_beside(effective * share, effective * sure);
        self.currents_below(figures, four);
        let rise = self.rise_below(figures, four);
        let [share, sure] = [of_drive(|drive| drive.rise[0][0]), of_drive(|drive| drive.rise[1][0])];
        self.above_beside(rise * share, rise * sure);
    }

    /// Bounds the utilisation of the screws.
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
            // For any friction between both, a sum of parts with the sign of the motion.
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
            // For any friction between both.
            let [least, most] = [warm + warm_k * w, most].map(|friction| s.abs() * friction);
            let braking = (torque * s).simd_lt(f64x4::ZERO);
            let magnitude = torque.abs();
            sure = sure.fast_max(braking.select((magnitude - most).fast_max(f64x4::ZERO), magnitude + least));
        }
        // A published curve may permit more than I_max, but not more than I_E.
        let per_limit = four.per_current_max * four.without_curve;
        self.above_beside(low * per_limit, sure * per_limit);
        self.above(low * four.per_current_demagnetisation);
    }

    fn heat_above(&mut self, figures: &Figures, four: &Four, of_drives: [&OfDrive; 4]) {
        let means = Means::of(figures, four, self.square);
        let ([warm_starting, warm, warm_k], [cool_starting, cool, cool_k]) = (four.warm_air, four.at_ambient);
        let coil = four.coil_w * all(figures.open_share);
        let [_, r_ha] = four.resistances;
        // The losses fall as the housing warms: two temperatures, each resulting from the losses at the other, then
        // enclose the settled one.
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

    /// Returns a lower bound of the largest rise of the winding: its mean \[K\].
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

/// Relative accuracy of the friction of the settled cycle: the root of its equation is found to 10⁻¹⁰ of the
/// temperature.
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
