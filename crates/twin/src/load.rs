//! The load at the output: the mechanism of the project, linearised about a state.

use crate::identify::Losses;
use crate::parameters::MeasuredLoad;
use mechanism::{Extra, Loading, Mechanism, Output, Plain};
use provenance::Sourced;

/// Load linearised about a state: T = J α + T_m + k (q − q_0) + c (q − q_0)² + b (ω − ω_0) + T_c σ.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Local {
    pub(crate) position_rad: f64,
    pub(crate) speed_rad_s: f64,
    /// J including the flange \[kgm²\].
    pub(crate) inertia_kgm2: f64,
    /// T_m: torque without direction-dependent friction \[Nm\].
    pub(crate) middle_nm: f64,
    /// k and c: dependence on the position [Nm/rad], [Nm/rad²].
    pub(crate) slope_nm: f64,
    pub(crate) bend_nm: f64,
    /// b: dependence on the speed [Nm s/rad].
    pub(crate) viscous_nms: f64,
    /// T_c: half the difference between both directions \[Nm\].
    pub(crate) coulomb_nm: f64,
}

impl Local {
    /// Returns the torque of the load without acceleration and direction-dependent friction \[Nm\].
    #[inline]
    pub(crate) fn torque(&self, position_rad: f64, speed_rad_s: f64) -> f64 {
        let way = position_rad - self.position_rad;
        self.middle_nm
            + way * (self.slope_nm + way * self.bend_nm)
            + self.viscous_nms * (speed_rad_s - self.speed_rad_s)
    }
}

/// The mechanism of an axis with the additions of its segments.
#[derive(Clone, Debug)]
pub(crate) struct LoadModel<'a> {
    parts: Vec<Part<'a>>,
    flange_kgm2: f64,
    measured: Measured,
    /// The mechanism without losses, if it has any and values are measured: they replace its own before the losses.
    without: Option<(Mechanism, &'a [Extra])>,
}

/// Measured values as plain numbers; those that depend on the position apply only to a load with constant coefficients.
#[derive(Clone, Copy, Debug, Default)]
struct Measured {
    inertia_kgm2: Option<f64>,
    coulomb_nm: Option<f64>,
    viscous_nms: Option<f64>,
}

#[derive(Clone, Debug)]
struct Part<'a> {
    plain: Option<Plain>,
    loading: Loading<'a>,
}

impl<'a> LoadModel<'a> {
    /// Creates the load with measured values instead of the mechanism's own; `Err` with the key of a value that the
    /// mechanism does not have.
    pub(crate) fn of(
        mechanism: &'a Mechanism,
        extras: &'a [Extra],
        flange_kgm2: f64,
        measured: &MeasuredLoad,
    ) -> Result<Self, &'static str> {
        let value = |of: &Option<Sourced<f64>>| of.as_ref().map(|sourced| sourced.value);
        let (inertia, external) = (value(&measured.inertia), value(&measured.external));
        let (weight, angle) = (value(&measured.gravity), value(&measured.gravity_angle));
        let is_plain = extras.first().is_some_and(|extra| mechanism.plain(extra).is_some());
        let is_even = is_plain || mechanism.travel_m_per_rad().is_some();
        let refused = [
            ("load_inertia", inertia.is_some() && !is_even),
            ("load_gravity", weight.is_some() && !is_plain),
            ("load_gravity_angle", angle.is_some() && !is_plain),
            ("load_external", external.is_some() && !is_plain),
        ];
        if let Some((key, _)) = refused.into_iter().find(|(_, refused)| *refused) {
            return Err(key);
        }
        // Another payload adds to the values measured with the first.
        let first = extras.first().and_then(|extra| mechanism.plain(extra));
        let replaced = |own: Plain| {
            let added = |of: fn(&Plain) -> f64| first.as_ref().map_or(0.0, |first| of(&own) - of(first));
            let (weight_nm, angle_rad) = match &first {
                Some(first) if weight.is_some() || angle.is_some() => laden(&own, first, weight, angle),
                _ => (own.weight_nm, own.angle_rad),
            };
            Plain {
                inertia_kgm2: inertia
                    .map_or(own.inertia_kgm2, |measured| measured - flange_kgm2 + added(|plain| plain.inertia_kgm2)),
                constant_nm: external.map_or(own.constant_nm, |measured| measured + added(|plain| plain.constant_nm)),
                weight_nm,
                angle_rad,
                coulomb_nm: value(&measured.coulomb)
                    .map_or(own.coulomb_nm, |measured| measured + added(|plain| plain.coulomb_nm)),
                viscous_nms: value(&measured.viscous).unwrap_or(own.viscous_nms),
            }
        };
        let part =
            |extra: &'a Extra| Part { plain: mechanism.plain(extra).map(replaced), loading: mechanism.loading(extra) };
        Ok(Self {
            parts: extras.iter().map(part).collect(),
            flange_kgm2,
            measured: Measured {
                inertia_kgm2: inertia,
                coulomb_nm: value(&measured.coulomb),
                viscous_nms: value(&measured.viscous),
            },
            without: (inertia.is_some() || measured.coulomb.is_some() || measured.viscous.is_some())
                .then(|| Losses::of(mechanism).map(|losses| (losses.without, extras)))
                .flatten(),
        })
    }

    /// Returns the load linearised about a state in a segment of the motion.
    pub(crate) fn linearised(&self, segment: usize, position: f64, speed: f64, acceleration: f64) -> Option<Local> {
        let part = self.parts.get(segment).or(self.parts.last())?;
        let local = Local {
            position_rad: position,
            speed_rad_s: speed,
            inertia_kgm2: self.flange_kgm2,
            middle_nm: 0.0,
            slope_nm: 0.0,
            bend_nm: 0.0,
            viscous_nms: 0.0,
            coulomb_nm: 0.0,
        };
        if let Some(plain) = &part.plain {
            let (sin, cos) = if plain.weight_nm == 0.0 { (0.0, 0.0) } else { (position + plain.angle_rad).sin_cos() };
            return Some(Local {
                inertia_kgm2: plain.inertia_kgm2 + self.flange_kgm2,
                middle_nm: plain.constant_nm + plain.weight_nm * cos + plain.viscous_nms * speed,
                slope_nm: -plain.weight_nm * sin,
                bend_nm: -0.5 * plain.weight_nm * cos,
                viscous_nms: plain.viscous_nms,
                coulomb_nm: plain.coulomb_nm,
                ..local
            });
        }
        let torque = |position_rad: f64, speed_rad_s: f64, acceleration_rad_s2: f64, direction: f64| {
            part.loading.at(&Output { position_rad, speed_rad_s, acceleration_rad_s2, direction }).torque_nm
        };
        let sign = if speed == 0.0 { 0.0 } else { speed.signum() };
        // Torque is piecewise linear in the acceleration: the slope is taken at the last one.
        let own = torque(position, speed, acceleration, sign);
        let inertia = torque(position, speed, acceleration + 1.0, sign) - own;
        let still = own - inertia * acceleration;
        let viscous =
            torque(position, speed + 0.5, acceleration, sign) - torque(position, speed - 0.5, acceleration, sign);
        let way = 1e-5;
        let slope = (torque(position + way, speed, acceleration, sign)
            - torque(position - way, speed, acceleration, sign))
            / (2.0 * way);
        let [ahead, back] = [1.0, -1.0].map(|direction| torque(position, speed, acceleration, direction));
        let coulomb = 0.5 * (ahead - back);
        let Measured { inertia_kgm2, coulomb_nm, viscous_nms } = self.measured;
        if let Some((mechanism, extras)) = &self.without
            && let Some(extra) = extras.get(segment).or(extras.last())
        {
            let own = mechanism.loading(extra);
            let at = |speed_rad_s: f64, acceleration_rad_s2: f64, direction: f64| {
                own.at(&Output { position_rad: position, speed_rad_s, acceleration_rad_s2, direction }).torque_nm
            };
            // Values before the losses: an inertia counts with them, friction beside the stated one at the output.
            let stated = at(speed, 1.0, 0.0) - at(speed, 0.0, 0.0);
            let factor = inertia / stated;
            let rubs = viscous_nms.map_or(viscous, |measured| {
                viscous + measured - (at(speed + 0.5, 0.0, sign) - at(speed - 0.5, 0.0, sign))
            });
            let stated_coulomb = 0.5 * (at(speed, 0.0, 1.0) - at(speed, 0.0, -1.0));
            return Some(Local {
                inertia_kgm2: inertia_kgm2.map_or(inertia, |measured| (measured - self.flange_kgm2) * factor)
                    + self.flange_kgm2,
                middle_nm: still - coulomb * sign + (rubs - viscous) * speed,
                slope_nm: slope,
                viscous_nms: rubs,
                coulomb_nm: coulomb_nm.map_or(coulomb, |measured| coulomb + measured - stated_coulomb),
                ..local
            });
        }
        let rubs = viscous_nms.unwrap_or(viscous);
        Some(Local {
            inertia_kgm2: inertia_kgm2.unwrap_or(inertia + self.flange_kgm2),
            middle_nm: still - coulomb * sign + (rubs - viscous) * speed,
            slope_nm: slope,
            viscous_nms: rubs,
            coulomb_nm: coulomb_nm.unwrap_or(coulomb),
            ..local
        })
    }
}

/// Returns weight and angle of a segment: the measured vector of the first segment plus the addition of another
/// payload.
fn laden(own: &Plain, first: &Plain, weight: Option<f64>, angle: Option<f64>) -> (f64, f64) {
    let vector = |weight: f64, angle: f64| {
        let (sine, cosine) = angle.sin_cos();
        [weight * cosine, weight * sine]
    };
    let [x, y] = vector(weight.unwrap_or(first.weight_nm), angle.unwrap_or(first.angle_rad));
    let [[first_x, first_y], [own_x, own_y]] = [first, own].map(|plain| vector(plain.weight_nm, plain.angle_rad));
    let (x, y) = (x + own_x - first_x, y + own_y - first_y);
    (x.hypot(y), y.atan2(x))
}
