//! The load at the output: the project's mechanism, near one state a linear one.

use mechanism::{Extra, Loading, Mechanism, Output, Plain};

/// The load about one state: T = J α + T_m + k (q − q_0) + c (q − q_0)² + b (ω − ω_0) + T_c σ.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Local {
    pub(crate) position_rad: f64,
    pub(crate) speed_rad_s: f64,
    /// J with the flange \[kgm²\].
    pub(crate) inertia_kgm2: f64,
    /// Torque without friction of the direction \[Nm\].
    pub(crate) middle_nm: f64,
    /// [Nm/rad], [Nm/rad²]
    pub(crate) slope_nm: f64,
    pub(crate) bend_nm: f64,
    /// [Nm s/rad]
    pub(crate) viscous_nms: f64,
    /// Half the width between both directions \[Nm\].
    pub(crate) coulomb_nm: f64,
}

impl Local {
    /// Torque that the load takes without acceleration and friction of the direction \[Nm\].
    #[inline]
    pub(crate) fn torque(&self, position_rad: f64, speed_rad_s: f64) -> f64 {
        let way = position_rad - self.position_rad;
        self.middle_nm
            + way * (self.slope_nm + way * self.bend_nm)
            + self.viscous_nms * (speed_rad_s - self.speed_rad_s)
    }
}

/// The mechanism of an axis with what its segments add.
#[derive(Clone, Debug)]
pub(crate) struct LoadModel<'a> {
    parts: Vec<Part<'a>>,
    flange_kgm2: f64,
}

#[derive(Clone, Debug)]
struct Part<'a> {
    plain: Option<Plain>,
    loading: Loading<'a>,
}

impl<'a> LoadModel<'a> {
    pub(crate) fn of(mechanism: &'a Mechanism, extras: &'a [Extra], flange_kgm2: f64) -> Self {
        let part = |extra: &'a Extra| Part { plain: mechanism.plain(extra), loading: mechanism.loading(extra) };
        Self { parts: extras.iter().map(part).collect(), flange_kgm2 }
    }

    /// The load about a state in a segment of the motion; `before` is the load of the step before.
    pub(crate) fn near(&self, segment: usize, position: f64, speed: f64, acceleration: f64) -> Option<Local> {
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
        // Torque is piecewise linear in the acceleration: the slope is that about the last one.
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
        Some(Local {
            inertia_kgm2: inertia + self.flange_kgm2,
            middle_nm: still - coulomb * sign,
            slope_nm: slope,
            viscous_nms: viscous,
            coulomb_nm: coulomb,
            ..local
        })
    }
}
