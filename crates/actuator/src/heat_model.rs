//! Heat model: permitted continuous losses, temperatures and currents.
//!
//! One model serves the continuous curve, intermittent duty, the temperature of a cycle and the overload supervision.

use crate::friction::{FrictionAt, NoLoadFriction};
use crate::instant::LossLaw;
use crate::parameters::Drivetrain;
use crate::temperature::{Losses, Network};
use provenance::Missing;
use quantities::{AngularVelocity, ElectricCurrent, Measure, Power, ThermodynamicTemperature, Time, Torque};

/// Means over a cycle from which the losses follow for any friction.
///
/// With I = I_T + I_s σ + K ω the copper loss needs the six means of the products of I_T, σ and ω.
///
/// # Symbols
/// I_T = T/k_Tout current of the torque \[A\], σ direction, ω output speed [rad/s]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LossMeans {
    /// Mean of I_T² \[A²\].
    pub torque_current_square: f64,
    /// Mean of I_T σ \[A\].
    pub torque_current_direction: f64,
    /// Mean of I_T ω [A rad/s].
    pub torque_current_speed: f64,
    /// Mean of σ²: share of time in motion.
    pub moving: f64,
    /// Mean of σ ω = |ω| [rad/s].
    pub speed_magnitude: f64,
    /// Mean of ω² [rad²/s²].
    pub speed_square: f64,
}

impl LossMeans {
    /// Returns the means of a constant torque at a constant speed for a share of the time, with rest without torque for
    /// the remainder.
    fn intermittent(torque_current: f64, speed: f64, duty: f64) -> Self {
        let turning = if speed > 0.0 { duty } else { 0.0 };
        Self {
            torque_current_square: duty * torque_current * torque_current,
            torque_current_direction: turning * torque_current,
            torque_current_speed: duty * torque_current * speed,
            moving: turning,
            speed_magnitude: duty * speed,
            speed_square: duty * speed * speed,
        }
    }
}

/// Steady state of a repeated cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settled {
    /// Mean temperature of the housing, assumed for the friction too.
    pub housing: ThermodynamicTemperature,
    /// Friction at this temperature.
    pub friction: FrictionAt,
    /// Mean losses over the cycle.
    pub losses: Losses,
}

/// Heat model of an actuator.
///
/// P_cu = 1.5 R I², P_f = (I_NLS + K(ϑ_h)|n|) k_TM ω_mot; R_wh + R_ha = Δϑ/P_0, P_0 = F · 1.5 R I_0², R_ha = w (R_wh + R_ha)
///
/// # Symbols
/// R = R_LL at the temperature of continuous duty \[Ω\] (1.5 R_LL I² is the copper loss of a star winding), Δϑ
/// difference from the reference ambient temperature to that temperature \[K\], I_0 largest stall current of the drive
/// over its ratios \[A\], F and w see [`Heat`](crate::Heat), ϑ_h temperature of the housing
/// # Source
/// docs/theory/thermal.md
/// # Valid
/// mounted on the plate of table 13.3; resistance of continuous duty, which is on the safe side for a cooler winding
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeatModel {
    friction: NoLoadFriction,
    torque_constant: f64,
    losses: LossLaw,
    stall_loss_w: f64,
    network: Network,
    band: (f64, f64),
    /// n_N/i [rad/s]
    rated: f64,
    /// Reference ambient temperature \[K\].
    ambient_k: f64,
    /// Winding temperature of continuous duty \[K\].
    limit_k: f64,
    winding_time_constant: Time,
}

impl HeatModel {
    /// Creates the model of an actuator.
    ///
    /// # Errors
    /// [`Missing`] with the first unknown datum.
    pub fn of(actuator: &Drivetrain) -> Result<Self, Missing> {
        let heat = &actuator.heat;
        let current = match actuator.stall_current_motor.known() {
            Some(motor) => motor,
            None => actuator.stall_current.require("I_0")?,
        };
        actuator.resistance_ll.require("R_LL")?;
        let factor = heat.stall_loss_factor.require("stall_loss_factor")?.value;
        let share = heat.housing_share.require("housing_share")?.value;
        let winding_time_constant = heat.winding_time_constant.require("tau_w")?.value;
        let tau = [winding_time_constant, heat.housing_time_constant.require("tau_h")?.value];
        let ratio = actuator.ratio.require("i")?.value;
        let friction = NoLoadFriction::of(actuator)?;
        let torque_constant = actuator.torque_constant_out.require("k_Tout")?.value.si();
        let limit = heat.winding_warning.require("T_KTY")?.value;
        let ambient_k = heat.ambient_reference.require("ambient_temperature_operation")?.value.si();
        let losses = LossLaw::of(actuator, limit)?;
        let stall_loss_w = factor * losses.copper_ohm() * current.value.si() * current.value.si();
        let total = (limit.si() - ambient_k) / stall_loss_w;
        Ok(Self {
            friction,
            torque_constant,
            losses,
            stall_loss_w,
            network: Network::new([(1.0 - share) * total, share * total], tau),
            band: heat.loss_band.require("loss_band")?.value,
            rated: actuator.speed_motor_rated.require("n_N")?.value.si() / ratio,
            ambient_k,
            limit_k: limit.si(),
            winding_time_constant,
        })
    }

    /// Returns `true` if the permitted continuous torque provably decreases with the speed for every edge of the band.
    ///
    /// δ (1 − w) b Δϑ < 1
    ///
    /// # Symbols
    /// δ decay of K per kelvin \[1/K\], w = R_ha/(R_wh + R_ha), b upper edge of the band, Δϑ permitted rise \[K\]
    /// # Source
    /// docs/theory/sweep.md
    /// # Valid
    /// speeds up to n_N/i
    #[must_use]
    pub fn falls_with_the_speed(&self) -> bool {
        let [r_wh, r_ha] = self.network.resistances_k_per_w();
        let (low, high) = self.band;
        let across = r_wh / (r_wh + r_ha);
        low <= 1.0 && self.friction.decay_per_k() * across * high.max(1.0) * self.rise_permitted() < 1.0
    }

    /// Returns P_0, the loss of the winding at standstill that heats it by the permitted rise.
    #[must_use]
    pub fn stall_loss(&self) -> Power {
        Power::from_si(self.stall_loss_w)
    }

    /// Returns the ambient temperature assumed if none is stated: the highest to which the data of the actuator apply.
    #[must_use]
    pub fn ambient_reference(&self) -> ThermodynamicTemperature {
        ThermodynamicTemperature::from_si(self.ambient_k)
    }

    /// Returns the winding temperature of continuous duty.
    #[must_use]
    pub fn winding_limit(&self) -> ThermodynamicTemperature {
        ThermodynamicTemperature::from_si(self.limit_k)
    }

    /// Returns the rise from the reference ambient temperature to the temperature of continuous duty \[K\]. The
    /// manufacturer states the same rise, 40 K, as a guide for mountings other than the plate (cha-manual section 6.1).
    fn rise_permitted(&self) -> f64 {
        self.limit_k - self.ambient_k
    }

    /// Returns the law of the friction.
    #[must_use]
    pub const fn friction(&self) -> &NoLoadFriction {
        &self.friction
    }

    /// Returns the thermal network.
    #[must_use]
    pub const fn network(&self) -> &Network {
        &self.network
    }

    /// Returns τ_w, the time constant of the winding.
    #[must_use]
    pub const fn winding_time_constant(&self) -> Time {
        self.winding_time_constant
    }

    /// Returns the law of the instantaneous losses, with the winding at the temperature of continuous duty.
    #[must_use]
    pub const fn losses(&self) -> &LossLaw {
        &self.losses
    }

    /// Returns the edges of the band of the permitted loss at a mean speed, as multiples of it \[1\].
    ///
    /// At standstill T_0 is known from the tables, so that the lower edge has no distance there and reaches its full
    /// distance linearly at n_N/i.
    #[must_use]
    pub fn band(&self, speed_mean: AngularVelocity) -> (f64, f64) {
        let (low, high) = self.band;
        let share = (speed_mean.si().abs() / self.rated).min(1.0);
        (1.0 - (1.0 - low) * share, high)
    }

    /// Returns both losses for a friction, as means over a cycle.
    fn mean_losses(&self, means: &LossMeans, starting: f64, constant: f64) -> Losses {
        let counted = self.friction.counted(starting);
        let square = means.torque_current_square
            + counted * counted * means.moving
            + constant * constant * means.speed_square
            + 2.0 * counted * means.torque_current_direction
            + 2.0 * constant * means.torque_current_speed
            + 2.0 * counted * constant * means.speed_magnitude;
        let friction = starting * means.speed_magnitude + constant * means.speed_square;
        let law = &self.losses;
        Losses { copper_w: law.copper_ohm() * square.max(0.0), friction_w: law.friction_v_s_per_rad() * friction }
    }

    /// Returns the steady state of a repeated cycle: temperature of the housing, friction and losses.
    ///
    /// ϑ_h = ϑ_a + R_ha (P_cu(K) + P_f(K) + P_x) with K = K(ϑ_h): one equation for ϑ_h, whose right-hand side decreases
    /// with ϑ_h
    ///
    /// # Symbols
    /// P_x additional loss in the housing, such as that of the coil of an open brake
    /// # Source
    /// docs/theory/thermal.md
    /// # Valid
    /// cycles short compared with τ_h; for longer ones the result is the mean
    #[must_use]
    pub fn settle(&self, means: &LossMeans, further: Power, ambient: ThermodynamicTemperature) -> Settled {
        let [_, r_ha] = self.network.resistances_k_per_w();
        let housing = self.balance(ambient.si(), |starting, constant, slope| {
            let losses = self.mean_losses(means, starting, constant);
            let counted = self.friction.counted(starting);
            let by_constant = 2.0
                * self.losses.copper_ohm()
                * (means.torque_current_speed + counted * means.speed_magnitude + constant * means.speed_square)
                + self.losses.friction_v_s_per_rad() * means.speed_square;
            let rise = r_ha * (losses.copper_w + losses.friction_w + further.si());
            (rise, -slope * by_constant * r_ha)
        });
        let (starting, constant, _) = self.friction.state(housing);
        let losses = self.mean_losses(means, starting, constant);
        let housing = ThermodynamicTemperature::from_si(housing);
        Settled {
            housing,
            friction: self.friction.with(housing, starting, constant),
            losses: Losses { friction_w: losses.friction_w + further.si(), ..losses },
        }
    }

    /// Returns the root of ϑ = ϑ_a + rise(ϑ); `rise` returns the rise and its slope for I_NLS, K and −dK/dϑ at ϑ.
    fn balance(&self, ambient_k: f64, rise: impl Fn(f64, f64, f64) -> (f64, f64)) -> f64 {
        let at = |temperature_k: f64| {
            let (starting, constant, slope) = self.friction.state(temperature_k);
            let (rise, rise_slope) = rise(starting, constant, slope);
            (temperature_k - ambient_k - rise, 1.0 - rise_slope)
        };
        // Friction is largest at ambient temperature: the rise there is above the root, and its tangent below.
        let (excess, slope) = at(ambient_k);
        let (low, high) = (ambient_k, ambient_k - excess.min(0.0));
        numeric::root_by_slope(at, (ambient_k - excess / slope).clamp(low, high), (low, high), 1e-10)
    }

    /// Returns the torque at a constant speed at which the winding reaches a multiple of its permitted rise, at the
    /// reference ambient temperature, with operation for a share of each cycle and rest without loss for the remainder;
    /// never negative.
    ///
    /// A P_cu + B P_f = b Δϑ with A, B of [`Network::intermittent`]; T = k_Tout (√(P_cu/1.5R) − I_s − K n)
    ///
    /// # Symbols
    /// b edge of the band; friction at the mean temperature of the housing ϑ_a + R_ha ED (P_cu + P_f)
    /// # Source
    /// docs/theory/continuous-torque.md, docs/theory/short-time-torque.md
    #[must_use]
    pub fn torque(&self, speed: AngularVelocity, duty: f64, cycle: Time, edge: f64) -> (Torque, Settled) {
        let n = speed.si().abs();
        let [_, r_ha] = self.network.resistances_k_per_w();
        let (a, b) = self.network.intermittent(duty, cycle);
        let permitted = edge * self.rise_permitted();
        let friction_loss =
            |starting: f64, constant: f64| self.losses.friction_v_s_per_rad() * (starting + constant * n) * n;
        let copper = |friction: f64| ((permitted - b * friction) / a).max(0.0);
        let housing = self.balance(self.ambient_k, |starting, constant, slope| {
            let friction = friction_loss(starting, constant);
            let copper_w = copper(friction);
            let by_friction = if copper_w > 0.0 { 1.0 - b / a } else { 1.0 };
            let rise = r_ha * duty * (copper_w + friction);
            (rise, -slope * self.losses.friction_v_s_per_rad() * n * n * by_friction * r_ha * duty)
        });
        let (starting, constant, _) = self.friction.state(housing);
        let friction_w = friction_loss(starting, constant);
        let copper_w = copper(friction_w);
        let counted = self.friction.counted(starting);
        let current = (copper_w / self.losses.copper_ohm()).sqrt() - counted - constant * n;
        let housing = ThermodynamicTemperature::from_si(housing);
        let settled = Settled { housing, friction: self.friction.at(housing), losses: Losses { copper_w, friction_w } };
        (Torque::from_si((self.torque_constant * current).max(0.0)), settled)
    }

    /// Returns the rise of the winding at the end of each operation of an intermittent duty at a constant torque and
    /// speed, at the reference ambient temperature, relative to the permitted one \[1\], and the steady state of the
    /// duty; a duty of one is continuous duty.
    ///
    /// # Source
    /// docs/theory/thermal.md
    #[must_use]
    pub fn rise_share(&self, torque: Torque, speed: AngularVelocity, duty: f64, cycle: Time) -> (f64, Settled) {
        let (a, b) = self.network.intermittent(duty, cycle);
        let means = LossMeans::intermittent(torque.si() / self.torque_constant, speed.si().abs(), duty);
        let settled = self.settle(&means, Power::from_si(0.0), self.ambient_reference());
        let rise = (a * settled.losses.copper_w + b * settled.losses.friction_w) / duty;
        (rise / self.rise_permitted(), settled)
    }

    /// Returns the current of a driving torque at a speed in steady state, with a known friction.
    #[must_use]
    pub fn current(&self, torque: Torque, speed: AngularVelocity, friction: &FrictionAt) -> ElectricCurrent {
        ElectricCurrent::from_si(torque.si() / self.torque_constant + friction.current(speed).si())
    }
}

#[cfg(test)]
#[path = "heat_model_tests.rs"]
mod tests;
