//! Bounds of the utilisation of each check, from few figures of the axis and of the actuator.

use super::catalogue::{Drive, Friction, Group, Place, swing};
use crate::axis::Axis;
use crate::check::CheckId;
use crate::supply::Edge;
use actuator::MotorVoltage;
use quantities::{AngularVelocity, Measure};
use trace::Outline;

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

/// So near a limit a bound decides nothing: far above the rounding of the sums.
pub(super) const ROOM: f64 = 1e-6;

/// The same where a signal is curved: what lies between its nodes is known to such a share.
const ROOM_CURVED: f64 = 1e-3;

/// So near an edge of the range of temperatures the check itself decides \[K\].
const EDGE_K: f64 = 1e-6;

/// Figures of an axis.
#[derive(Default)]
pub(super) struct Figures {
    outline: Outline,
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
    /// Means of the products of (α, T_L, σ, ω).
    means: [[f64; 4]; 4],
}

impl Figures {
    /// Those of an axis; whether there are any.
    pub(super) fn take(&mut self, axis: &Axis) -> bool {
        if !axis.trace.outline(&mut self.outline) {
            return false;
        }
        let moments = axis.moments();
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
        self.means = axis.trace.gram().sums().map(|row| row.map(|sum| sum / self.duration));
        self.duration > 0.0
    }

    /// Bounds of the largest |J α + T_L|.
    fn torque_peak(&self, inertia: f64) -> [f64; 2] {
        let low = self.outline.nodes.iter().fold(0.0_f64, |most, [a, t, ..]| most.max((inertia * a + t).abs()));
        let high = self.outline.extents.iter().fold(0.0_f64, |most, extent| most.max(extent.torque(inertia)));
        [low, high]
    }

    /// Mean of (J α + T_L)².
    fn torque_square(&self, inertia: f64) -> f64 {
        let [[aa, at, ..], [_, tt, ..], ..] = &self.means;
        (inertia * inertia * aa + 2.0 * inertia * at + tt).max(0.0)
    }
}

/// Bounds of one actuator.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    is_unknown: bool,
    fails: bool,
    is_elsewhere: bool,
    room: f64,
    /// Bit k: whether the check at place k is decided by itself only.
    open: u32,
    least_first: f64,
    least: f64,
    /// Above the utilisation of each.
    high: [f64; COUNT],
}

impl Bounds {
    /// Nothing is known: the actuator is judged.
    pub(super) const UNKNOWN: Self = Self {
        is_unknown: true,
        fails: false,
        is_elsewhere: false,
        room: ROOM,
        open: u32::MAX,
        least_first: 0.0,
        least: 0.0,
        high: [f64::INFINITY; COUNT],
    };

    const NONE: Self = Self { is_unknown: false, open: 0, high: [0.0; COUNT], ..Self::UNKNOWN };

    pub(super) const fn is_unknown(&self) -> bool {
        self.is_unknown
    }

    /// Whether it fails for sure.
    pub(super) const fn fails(&self) -> bool {
        self.fails
    }

    /// Whether it fails where neither load nor pace matter.
    pub(super) const fn is_of_another_place(&self) -> bool {
        self.is_elsewhere
    }

    /// At most its utilisation.
    pub(super) fn least(&self) -> f64 {
        self.least * (1.0 - self.room)
    }

    /// At most the utilisation by the checks of the first stage.
    pub(super) fn least_first(&self) -> f64 {
        self.least_first * (1.0 - self.room)
    }

    /// The checks that its bounds leave open.
    pub(super) fn open(&self) -> Ids {
        Ids(self.open)
    }

    /// The checks whose utilisation may be the largest.
    pub(super) fn contenders(&self) -> Ids {
        let least = self.least();
        let may_be = self.high.iter().enumerate().filter(|(_, high)| **high * (1.0 + self.room) >= least);
        Ids(may_be.fold(0, |all, (place, _)| all | 1 << place) | self.open)
    }

    pub(super) fn of(figures: &Figures, group: &Group, shared: &Shared<'_>) -> Self {
        if group.inertia.is_nan() {
            return Self::UNKNOWN;
        }
        let mut found = shared.bounds;
        if found.fails {
            return found;
        }
        let torques = figures.torque_peak(group.inertia);
        let square = figures.torque_square(group.inertia);
        found.torques(figures, group, shared, (torques, square));
        if found.fails {
            return found;
        }
        found.currents(figures, group, shared);
        if found.fails {
            return found;
        }
        found.heat(figures, group, shared, square);
        let [_, peak] = torques;
        if let Some(least) = shared.short_time {
            found.take(10, [0.0, peak / least]);
        }
        found
    }

    /// A check with bounds of its utilisation, which fails above one.
    fn take(&mut self, at: usize, [low, high]: [f64; 2]) {
        self.take_beside(at, [low, high], [low, high]);
    }

    /// A check with bounds of its utilisation and of its value by the edge above which it fails.
    fn take_beside(&mut self, at: usize, [low, high]: [f64; 2], [sure, most]: [f64; 2]) {
        if let Some(known) = self.high.get_mut(at) {
            *known = high;
        }
        self.least = self.least.max(low);
        if at < FIRST_OF_SURVIVORS {
            self.least_first = self.least_first.max(low);
        }
        if sure > 1.0 + self.room {
            self.fails = true;
        }
        // Not a number is open too.
        let is_sure = most < 1.0 - self.room;
        if !is_sure {
            self.open |= 1 << at;
        }
    }

    fn speeds(&mut self, figures: &Figures, drive: &Drive) {
        let share = |value: f64, limit: f64| [value / limit; 2];
        self.take(1, share(figures.speed_peak, drive.speed_max));
        self.take(2, share(figures.speed_mean, drive.speed_rated));
        if let Some(limit) = drive.average_torque_max {
            self.take(7, share(figures.load_mean, limit));
        }
        if let Some(limit) = drive.input_speed_mean_max {
            self.take(13, share(figures.speed_mean * drive.ratio, limit));
        }
        let load = if figures.has_collision { f64::INFINITY } else { figures.load_peak };
        if let Some(limit) = drive.transmissible_load {
            self.take(14, [figures.load_peak / limit, load / limit]);
        }
    }

    fn torques(&mut self, figures: &Figures, group: &Group, shared: &Shared<'_>, (peak, square): ([f64; 2], f64)) {
        let drive = shared.drive;
        self.take(0, peak.map(|torque| torque / drive.torque_max));
        let effective = square.sqrt();
        let [[low, high], [upper_low, upper_high]] = shared.continuous;
        self.take_beside(3, [effective / high, effective / low], [effective / upper_high, effective / upper_low]);
        if let Some(limit) = drive.transmissible_housing {
            // |T_L| + (J_out/i) |α|
            let inertia = group.inertia / drive.ratio;
            let of = |most: f64, extent: &trace::Extent| most.max(extent.torque(inertia)).max(extent.torque(-inertia));
            let housing = figures.outline.extents.iter().fold(0.0, of);
            let housing = if figures.has_collision { f64::INFINITY } else { housing };
            self.take(15, [0.0, housing / limit]);
        }
    }

    /// Ambient temperature and supply, which neither load nor pace can mend.
    fn place(&mut self, figures: &Figures, drive: &Drive) {
        if let (Some(air), Some(range)) = (figures.ambient, drive.drivetrain.ambient_range.known()) {
            let (low, high) = (range.value.0.si(), range.value.1.si());
            // The check itself decides at an edge of the range.
            if air < low - EDGE_K || air > high + EDGE_K {
                self.fails = true;
                self.is_elsewhere = true;
            } else if air < low + EDGE_K || air > high - EDGE_K {
                self.open |= 1 << 8;
            }
        }
        if let (Some(supply), Some(limit)) = (figures.supply, drive.drivetrain.dc_link_max.known()) {
            let share = supply / limit.value.si();
            if share > 1.0 + ROOM {
                self.fails = true;
                self.is_elsewhere = true;
                self.least = self.least.max(share);
                self.least_first = self.least_first.max(share);
            } else if share > 1.0 - ROOM {
                self.open |= 1 << 9;
            }
        }
    }

    fn currents(&mut self, figures: &Figures, group: &Group, shared: &Shared<'_>) {
        let (drive, cold, warmest) = (shared.drive, &shared.place.cold, &shared.place.warmest);
        let (inertia, per_torque) = (group.inertia, shared.per_torque);
        let mut high = 0.0_f64;
        let mut volts = 0.0_f64;
        for extent in &figures.outline.extents {
            let (least, most) = extent.torques(inertia);
            let ((back, forth), (slowest, fastest)) = (extent.direction, extent.speeds_rad_s);
            // Of any friction between both, a sum of parts with the sign of the motion.
            let of = |friction: &Friction, direction: f64, speed: f64| {
                direction * friction.counted + speed * friction.constant
            };
            let upper = most * per_torque + of(cold, forth, fastest).max(of(warmest, forth, fastest));
            let lower = least * per_torque + of(cold, back, slowest).min(of(warmest, back, slowest));
            let current = upper.max(-lower);
            high = high.max(current);
            if let Some(motor) = &shared.motor {
                volts = volts.max(motor.most(AngularVelocity::from_si(extent.speed_rad_s), current));
            }
        }
        let (mut low, mut sure) = (0.0_f64, 0.0_f64);
        for [a, t, s, w] in &figures.outline.nodes {
            let torque = (inertia * a + t) * per_torque;
            low = low.max((torque + s * cold.at(w.abs())).abs());
            // Of any friction between both.
            let [least, most] = [warmest, cold].map(|friction| s.abs() * friction.at(w.abs()));
            let braking = torque * s < 0.0;
            sure = sure.max(if braking { (torque.abs() - most).max(0.0) } else { torque.abs() + least });
        }
        if let Some(limit) = drive.current_max {
            let [low, sure] = if drive.has_short_time_curve { [0.0; 2] } else { [low, sure] };
            self.take_beside(4, [low / limit, high / limit], [sure / limit, high / limit]);
        }
        if let Some(limit) = drive.current_demagnetisation {
            self.take(5, [low / limit, high / limit]);
        }
        if let (Some(terminal), Some(_)) = (shared.terminal, &shared.motor) {
            self.take(6, [0.0, volts / terminal]);
        }
    }

    fn heat(&mut self, figures: &Figures, group: &Group, shared: &Shared<'_>, square: f64) {
        let (drive, place, per_torque) = (shared.drive, shared.place, shared.per_torque);
        let [[_, _, a_s, a_w], [_, _, t_s, t_w], [_, _, moving, travelled], [.., w_w]] = &figures.means;
        let of_square = square * per_torque * per_torque;
        let of_direction = (group.inertia * a_s + t_s) * per_torque;
        let of_speed = (group.inertia * a_w + t_w) * per_torque;
        // Mean of I²: of I_T + I_s σ + K ω a parabola in I_s and in K, largest at a corner.
        let mean = |counted: f64, constant: f64| {
            of_square
                + counted * (counted * moving + 2.0 * of_direction + 2.0 * constant * travelled)
                + constant * (constant * w_w + 2.0 * of_speed)
        };
        let (warm, cool) = (&place.warmest, &place.at_ambient);
        let corners = [
            mean(warm.counted, warm.constant),
            mean(warm.counted, cool.constant),
            mean(cool.counted, warm.constant),
            mean(cool.counted, cool.constant),
        ];
        let current_high = corners.into_iter().fold(0.0, f64::max);
        #[allow(clippy::float_cmp, reason = "the same number, or another one")]
        let current_low = if warm.counted == cool.counted {
            let vertex = -(of_speed + warm.counted * travelled) / w_w;
            let constant = if vertex.is_nan() { warm.constant } else { vertex.max(warm.constant).min(cool.constant) };
            mean(warm.counted, constant).max(0.0)
        } else {
            0.0
        };
        let law = drive.heat.losses();
        let friction = |friction: &Friction| {
            law.friction_v_s_per_rad() * (friction.starting * travelled + friction.constant * w_w)
        };
        let copper = [current_low, current_high].map(|square| law.copper_ohm() * square);
        let friction = [friction(warm), friction(cool)];
        let coil = group.coil_w * figures.open_share;
        let [r_wh, r_ha] = shared.resistances;
        let [by_copper, by_friction] = shared.gains;
        let [copper_low, copper_high] = copper;
        let [friction_low, friction_high] = friction;
        let high = copper_high * by_copper + friction_high * by_friction + coil * r_ha;
        let low = copper_low * (r_wh + r_ha) + friction_low * r_ha + coil * r_ha;
        let permitted = drive.heat.winding_limit().si() - place.ambient_k;
        // What the published curves permit of intermittent duty the model permits at least, see `PublishedDuty`.
        let scales_down = figures.duty <= 0.5 && drive.has_intermittent_curves;
        let (edge, upper) =
            if drive.has_curves { (1.0, 1.0) } else { drive.heat.band(AngularVelocity::from_si(figures.speed_mean)) };
        if permitted > 0.0 && (!drive.has_curves || scales_down) {
            let low = if drive.has_curves { 0.0 } else { low };
            self.take_beside(
                11,
                [low / (edge * permitted), high / (edge * permitted)],
                [0.0, high / (upper * permitted)],
            );
        } else {
            self.take(11, [0.0, f64::INFINITY]);
        }
        let stalled = drive.stall_current * drive.stall_current;
        self.take(12, [0.0, current_high / stalled * shared.swing]);
    }
}

/// What the actuators of one drivetrain have in common for an axis.
pub(super) struct Shared<'c> {
    drive: &'c Drive,
    place: &'c Place<'c>,
    bounds: Bounds,
    per_torque: f64,
    /// Bounds of the continuous torque and of its upper edge.
    continuous: [[f64; 2]; 2],
    /// The least torque that is permitted for a short time up to the peak speed.
    short_time: Option<f64>,
    terminal: Option<f64>,
    motor: Option<MotorVoltage>,
    /// R_wh, R_ha
    resistances: [f64; 2],
    /// Largest rise of the winding per mean of copper loss and of friction.
    gains: [f64; 2],
    /// Largest over mean of the supervision's lag.
    swing: f64,
}

impl<'c> Shared<'c> {
    /// `None` where nothing is known of a drivetrain.
    pub(super) fn of(figures: &Figures, drive: &'c Drive, place: &'c Place<'c>, terminal: Option<f64>) -> Self {
        let mut bounds = Bounds { room: figures.room, ..Bounds::NONE };
        bounds.speeds(figures, drive);
        bounds.place(figures, drive);
        let short_time = place.short_time.as_ref().map(|short_time| {
            let [still, fastest] = [0.0, figures.speed_peak].map(AngularVelocity::from_si);
            let [least, _] = short_time.least_between(still, fastest);
            least.si().min(drive.torque_max)
        });
        let network = drive.heat.network();
        let [quick, slow] = network.time_constants().map(|tau| swing(figures.duration, tau));
        let most = |gain: f64, [least, most]: [f64; 2]| if gain >= 0.0 { gain * most } else { gain * least };
        let sum = |[of_quick, of_slow]: [f64; 2]| most(of_quick, quick) + most(of_slow, slow);
        let gains = network.winding();
        let [_, swing] = swing(figures.duration, drive.heat.winding_time_constant());
        Self {
            drive,
            place,
            bounds,
            per_torque: 1.0 / drive.torque_constant,
            continuous: drive.continuous.at(figures.speed_mean),
            short_time,
            terminal,
            motor: drive.voltage.filter(|_| terminal.is_some()),
            resistances: network.resistances_k_per_w(),
            gains: [sum(gains.copper), sum(gains.friction)],
            swing,
        }
    }
}

/// Some of the covered checks.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ids(u32);

impl Ids {
    pub(super) const fn is_empty(self) -> bool {
        self.0 == 0
    }

    pub(super) fn iter(self) -> impl Iterator<Item = CheckId> {
        COVERED.into_iter().enumerate().filter(move |(place, _)| self.0 >> place & 1 == 1).map(|(_, id)| id)
    }
}
