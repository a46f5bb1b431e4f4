//! Characteristic values of an axis for the bounds, and of each drivetrain for it.

use super::bounds::ROOM;
use super::catalogue::{Conditions, Drive, Place, swing};
use crate::axis::Axis;
use crate::supply::Edge;
use quantities::{AngularVelocity, Measure};
use trace::{Extent, Outline};
use wide::f64x4;

/// Bits of the checks that depend neither on load nor on pace.
const AMBIENT: u64 = 1 << 8;
const DC_LINK: u64 = 1 << 9;

/// Distance from a limit within which a bound decides nothing if a signal is curved, whose values between nodes are
/// known to this share.
const ROOM_CURVED: f64 = 1e-3;

/// Distance from an edge of the temperature range within which the check itself decides \[K\].
const EDGE_K: f64 = 1e-6;

/// Returns one number for four actuators.
pub(super) const fn all(value: f64) -> f64x4 {
    f64x4::new([value; 4])
}

/// Bounds of the signals between some nodes of an axis.
pub(super) struct Bound {
    pub(super) extent: Extent,
    /// Largest |α| and |T_L|.
    pub(super) acceleration: f64,
    pub(super) load: f64,
}

/// Characteristic values of an axis.
#[derive(Default)]
pub(super) struct Figures {
    pub(super) outline: Outline,
    pub(super) bounds: Vec<Bound>,
    pub(super) room: f64,
    pub(super) duration: f64,
    pub(super) duty: f64,
    pub(super) speed_mean: f64,
    pub(super) speed_peak: f64,
    pub(super) load_peak: f64,
    pub(super) load_mean: f64,
    pub(super) open_share: f64,
    pub(super) has_collision: bool,
    pub(super) ambient: Option<f64>,
    pub(super) supply: Option<f64>,
    pub(super) terminal: Option<f64>,
    /// Means of the products of (α, T_L, σ, ω).
    pub(super) means: [[f64; 4]; 4],
    pub(super) of_drives: Vec<OfDrive>,
}

impl Figures {
    /// Computes the values of an axis; returns `true` if it has them.
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

    pub(super) fn of_drive(&self, place: usize) -> &OfDrive {
        self.of_drives.get(place).unwrap_or(&OfDrive::UNKNOWN)
    }

    /// Returns a lower bound of the largest |J α + T_L|.
    pub(super) fn torque_peak_low(&self, inertia: f64x4) -> f64x4 {
        let of = |low: f64x4, [a, t, ..]: &[f64; 4]| low.fast_max((inertia * all(*a) + all(*t)).abs());
        self.outline.nodes.iter().fold(f64x4::ZERO, of)
    }

    /// Returns an upper bound of the largest |J α + T_L|.
    pub(super) fn torque_peak_high(&self, inertia: f64x4) -> f64x4 {
        let of = |high: f64x4, Bound { extent, .. }: &Bound| {
            let (least, most) = torques(extent, inertia);
            high.fast_max(most).fast_max(-least)
        };
        self.bounds.iter().fold(f64x4::ZERO, of)
    }

    /// Returns the mean of (J α + T_L)².
    pub(super) fn torque_square(&self, inertia: f64x4) -> f64x4 {
        let [[aa, at, ..], [_, tt, ..], ..] = self.means;
        (inertia * (inertia * all(aa) + all(2.0 * at)) + all(tt)).fast_max(f64x4::ZERO)
    }
}

/// Returns bounds of J α + T_L; J is not negative.
pub(super) fn torques(extent: &Extent, inertia: f64x4) -> (f64x4, f64x4) {
    let at = |acceleration: f64, load: f64| inertia * all(acceleration) + all(load);
    (at(extent.acceleration_rad_s2.0, extent.load_nm.0), at(extent.acceleration_rad_s2.1, extent.load_nm.1))
}

/// Values that the actuators of one drivetrain share for an axis.
pub(super) struct OfDrive {
    /// Inverses of both bounds of the continuous torque and of its upper edge, that of the lower bound first.
    pub(super) continuous: [[f64; 2]; 2],
    /// Inverse of the least permissible short-time torque up to the peak speed.
    pub(super) short_time: f64,
    /// Largest rise of the winding per mean of copper loss and of friction.
    pub(super) gains: [f64; 2],
    /// Factors that convert bounds of the rise to shares of the permissible rise: by its lower edge, below and above,
    /// and by its upper edge.
    pub(super) rise: [[f64; 2]; 2],
    /// Maximum over mean of the supervision's lag.
    pub(super) swing: f64,
    /// Supply voltage over the permissible one, if it is above.
    pub(super) above: f64,
    pub(super) is_elsewhere: bool,
    /// Bits of the ambient checks that are decided only by the check itself.
    pub(super) open: u64,
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

    /// Evaluates ambient temperature and supply, which depend neither on load nor on pace.
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
