//! Control of the drive: position, speed and current loop at their rates, and their default gains.

use crate::plant::Plant;

/// Periods of the current loop per period of the speed loop.
pub(crate) const SPEED_EVERY: u64 = 4;

/// Periods of the current loop per period of the position loop.
pub const POSITION_EVERY: u64 = 8;

/// Period of the position loop \[s\].
#[allow(clippy::cast_precision_loss, reason = "eight")]
pub(crate) const POSITION_PERIOD_S: f64 = POSITION_EVERY as f64 / CURRENT_RATE_HZ;
/// Rate of the current loop \[Hz\]; speed and position loop run at 4 kHz and 2 kHz.
pub const CURRENT_RATE_HZ: f64 = 16_000.0;

/// Gains of the loops, referred to the output.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gains {
    /// K_p of the current loop for phase quantities \[V/A\].
    pub current_p: f64,
    /// T_n of the current loop \[s\].
    pub current_time_s: f64,
    /// K_p of the speed loop [Nm s/rad].
    pub speed_p: f64,
    /// T_n of the speed loop \[s\].
    pub speed_time_s: f64,
    /// Time constant of the filter of the measured speed \[s\].
    pub speed_filter_s: f64,
    /// K_v of the position loop [1/s].
    pub position_p: f64,
    /// Share of the setpoint speed used as feedforward \[1\].
    pub feed_speed: f64,
    /// Inertia of the torque feedforward \[kgm²\].
    pub feed_inertia: f64,
}

impl Gains {
    /// Returns the default gains.
    ///
    /// Current: K_p = L/(2 T_σ), T_n = L/R (magnitude optimum, T_σ = 1.5 T_c); speed: K_p = J_M/(2 T_Σ), T_n = 4 T_Σ
    /// (J_M + J_L)/J_M (symmetrical optimum of the rotor above the resonance, of rotor and load below it, T_Σ = 2 T_σ +
    /// T_s + T_f); position: K_v = min(1/(2 T_n), ω_a/5); for a loop closed at the output also at most ζ_a ω_a = D/(2
    /// J_L), half of the limit given by the resonance
    ///
    /// # Symbols
    /// T_c, T_s periods of the current and speed loop, T_f filter of the speed, J_M inertia of the rotor, J_L inertia
    /// of the load at the output, ω_a = √(K_2/J_L) frequency of the load on the blocked rotor, D damping of the gear
    /// # Source
    /// Kessler, Das symmetrische Optimum, Regelungstechnik 6 (1958); Schröder, Elektrische Antriebe, Regelung von
    /// Antriebssystemen; the factor of the load and the bound by ω_a are chosen by antrieb
    /// # Valid
    /// measured speed of the motor, position of the motor or at the output
    #[must_use]
    pub(crate) fn standard(plant: &Plant, load_kgm2: f64, stiffness_nm: f64, delay: bool, at_output: bool) -> Self {
        let period = 1.0 / CURRENT_RATE_HZ;
        let current_sum = period * if delay { 1.5 } else { 0.5 };
        let speed_period = 4.0 * period;
        let speed_filter_s = 0.0;
        let speed_sum = 2.0 * current_sum + speed_period + speed_filter_s;
        let (rotor, total) = (plant.inertia_kgm2, plant.inertia_kgm2 + load_kgm2);
        let speed_time_s = 4.0 * speed_sum * total / rotor;
        let blocked = (stiffness_nm / load_kgm2).sqrt();
        let damped = if at_output { 0.5 * plant.damping_nms / load_kgm2 } else { f64::INFINITY };
        Self {
            current_p: plant.inductance_h / (2.0 * current_sum),
            current_time_s: plant.inductance_h / plant.resistance_ohm,
            speed_p: rotor / (2.0 * speed_sum),
            speed_time_s,
            speed_filter_s,
            position_p: (0.5 / speed_time_s).min(blocked / 5.0).min(damped),
            feed_speed: 1.0,
            feed_inertia: total,
        }
    }
}

/// Setpoint of the drive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Demand {
    /// Position \[rad\] with its speed [rad/s] and acceleration [rad/s²].
    Position([f64; 3]),
    /// Speed [rad/s].
    Speed(f64),
}

/// Limits within the control.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounds {
    /// Largest i_q, peak of a phase \[A\].
    pub(crate) current_a: f64,
    /// Largest voltage of a phase, peak \[V\].
    pub(crate) voltage_v: f64,
    /// Largest speed [rad/s].
    pub(crate) speed: f64,
}

/// Measured values of one period.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Measured {
    pub(crate) current: [f64; 2],
    /// Angle of the motor over i \[rad\].
    pub(crate) angle_rad: f64,
    /// Position measured for the position loop \[rad\].
    pub(crate) position_rad: f64,
}

/// Steady state of an axis in motion, in which a control begins.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Steady {
    /// Measured angle of the motor over i \[rad\].
    pub(crate) angle_rad: f64,
    /// Speed of the motor over i [rad/s].
    pub(crate) speed: f64,
    /// Torque of the motor at the output, and its part from the feedforward \[Nm\].
    pub(crate) torque_nm: f64,
    pub(crate) feed_nm: f64,
}

/// State of the control.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Control {
    pub(crate) gains: Gains,
    /// Constants of the decoupling.
    resistance_l: [f64; 2],
    flux_vs: f64,
    electrical: f64,
    torque_constant: f64,
    delay: bool,
    /// Integrals of the current loop \[V\] and of the speed loop \[Nm\].
    integral_v: [f64; 2],
    pub(crate) integral_nm: f64,
    last_angle: f64,
    /// Filtered measured speed [rad/s].
    pub(crate) speed: f64,
    pub(crate) speed_wanted: f64,
    feed_nm: f64,
    pub(crate) current_wanted: f64,
    /// Voltage computed in the last period \[V\], applied one period later.
    pending: [f64; 2],
    pub(crate) following_rad: f64,
    pub(crate) limited: bool,
}

impl Control {
    /// Creates the control at rest with a holding torque \[Nm\].
    pub(crate) fn at_rest(gains: Gains, plant: &Plant, delay: bool, angle_rad: f64, holding_nm: f64) -> Self {
        let still = Steady { angle_rad, speed: 0.0, torque_nm: holding_nm, feed_nm: 0.0 };
        Self::steady(gains, plant, delay, &still)
    }

    /// Creates the control in a steady state: no error of speed and current, the integrals hold what the feedforward
    /// leaves.
    pub(crate) fn steady(gains: Gains, plant: &Plant, delay: bool, at: &Steady) -> Self {
        let &Steady { angle_rad, speed, torque_nm, feed_nm } = at;
        let current = torque_nm / plant.torque_constant;
        let voltage = [0.0, plant.resistance_ohm * current];
        let electric = plant.electrical * speed;
        #[allow(clippy::cast_precision_loss, reason = "four")]
        let speed_period = SPEED_EVERY as f64 / CURRENT_RATE_HZ;
        Self {
            gains,
            resistance_l: [plant.resistance_ohm, plant.inductance_h],
            flux_vs: plant.flux_vs,
            electrical: plant.electrical,
            torque_constant: plant.torque_constant,
            delay,
            integral_v: voltage,
            integral_nm: torque_nm - feed_nm,
            last_angle: angle_rad - speed * speed_period,
            speed,
            speed_wanted: speed,
            feed_nm,
            current_wanted: current,
            pending: [0.0 - electric * plant.inductance_h * current, voltage[1] + electric * plant.flux_vs],
            following_rad: 0.0,
            limited: false,
        }
    }

    /// Computes the voltage of this period.
    #[inline]
    pub(crate) fn period(
        &mut self,
        tick: u64,
        measured: &Measured,
        demand: impl FnOnce() -> Demand,
        bounds: &Bounds,
    ) -> [f64; 2] {
        let period = 1.0 / CURRENT_RATE_HZ;
        if tick.is_multiple_of(SPEED_EVERY) {
            #[allow(clippy::cast_precision_loss, reason = "four")]
            let speed_period = SPEED_EVERY as f64 * period;
            let raw = (measured.angle_rad - self.last_angle) / speed_period;
            self.last_angle = measured.angle_rad;
            self.speed += (raw - self.speed) * speed_period / (speed_period + self.gains.speed_filter_s);
            if tick.is_multiple_of(POSITION_EVERY) {
                match demand() {
                    Demand::Position([position, speed, acceleration]) => {
                        self.following_rad = position - measured.position_rad;
                        let wanted = self.gains.position_p * self.following_rad + self.gains.feed_speed * speed;
                        self.speed_wanted = wanted.clamp(-bounds.speed, bounds.speed);
                        self.feed_nm = self.gains.feed_inertia * acceleration;
                    }
                    Demand::Speed(speed) => {
                        self.speed_wanted = speed.clamp(-bounds.speed, bounds.speed);
                        (self.feed_nm, self.following_rad) = (0.0, 0.0);
                    }
                }
            }
            let error = self.speed_wanted - self.speed;
            let grown = self.integral_nm + self.gains.speed_p * error * speed_period / self.gains.speed_time_s;
            let wanted = (self.gains.speed_p * error + grown + self.feed_nm) / self.torque_constant;
            self.current_wanted = wanted.clamp(-bounds.current_a, bounds.current_a);
            self.limited = self.current_wanted != wanted;
            // Anti-windup: the integral is frozen while the current is limited, unless the error reduces it.
            if !self.limited || error * wanted < 0.0 {
                self.integral_nm = grown;
            }
        }
        let [i_d, i_q] = measured.current;
        let electric = self.electrical * self.speed;
        let l = self.resistance_l[1];
        let decoupling = [-electric * l * i_q, electric * (l * i_d + self.flux_vs)];
        let errors = [-i_d, self.current_wanted - i_q];
        let share = period / self.gains.current_time_s;
        let mut voltage = [0.0; 2];
        for (((u, integral), error), free) in voltage.iter_mut().zip(&mut self.integral_v).zip(errors).zip(decoupling) {
            *integral += self.gains.current_p * share * error;
            *u = self.gains.current_p * error + *integral + free;
        }
        let size = (voltage[0] * voltage[0] + voltage[1] * voltage[1]).sqrt();
        if size > bounds.voltage_v {
            let scale = bounds.voltage_v / size;
            for (u, integral) in voltage.iter_mut().zip(&mut self.integral_v) {
                let cut = *u * scale;
                // Back-calculation: the integral is reduced by the voltage that the inverter cannot provide.
                *integral += share.min(1.0) * (cut - *u);
                *u = cut;
            }
            self.limited = true;
        }
        if self.delay { std::mem::replace(&mut self.pending, voltage) } else { voltage }
    }
}
