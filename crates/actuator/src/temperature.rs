//! Temperatures of winding and housing: two nodes in a chain to the ambient air, linear, at constant resistance.

use crate::motor::{WINDING_TEMPERATURE_CONTINUOUS, WINDING_TIME_CONSTANT, copper_resistance};
use crate::overload::periodic_lag;
use crate::parameters::Parameters;
use derivation::Workings;
use provenance::{Grade, Missing, Source};
use quantities::unit::{AMPERE, OHM, WATT};
use quantities::{ElectricCurrent, ElectricalResistance, Measure, Power, ThermodynamicTemperature, Time};

/// τ_h: time constant of the housing in seconds, 40 min; estimated from the printed time of cooling down, up to 140 min.
pub const HOUSING_TIME_CONSTANT: f64 = 2400.0;

/// Band of the time constant of the housing in seconds, 35 min to 45 min.
pub const HOUSING_TIME_CONSTANT_BAND: (f64, f64) = (2100.0, 2700.0);

/// R_wh/(R_wh + R_ha): share of the thermal resistance that lies between winding and housing; estimated from published
/// robot joints of the same build, which show 0.088 to 0.097.
pub const WINDING_RESISTANCE_SHARE: f64 = 0.1;

/// Rise of the winding at standstill with I_0: from the reference ambient 40 °C to the warning threshold 80 °C, in kelvin.
const RISE_AT_STALL: f64 = 40.0;

/// Temperatures of the two nodes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Temperatures {
    /// Winding.
    pub winding: ThermodynamicTemperature,
    /// Housing.
    pub housing: ThermodynamicTemperature,
}

/// The largest temperatures of a cycle that repeats for ever.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CycleTemperatures {
    /// Largest temperature of the winding.
    pub winding_max: ThermodynamicTemperature,
    /// Moment of the cycle at which the winding is hottest.
    pub at: Time,
    /// Largest temperature of the housing.
    pub housing: ThermodynamicTemperature,
}

/// The thermal model of one actuator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Thermal {
    /// Thermal resistances winding-housing and housing-ambient \[K/W\].
    resistance_k_per_w: [f64; 2],
    /// Time constants of the two modes \[s\], the quick one first.
    tau_s: [f64; 2],
    /// Share of each mode in the rise of the winding \[K/W\].
    gain_winding: [f64; 2],
    /// Share of each mode in the rise of the housing \[K/W\].
    gain_housing: [f64; 2],
}

impl Thermal {
    /// Where the model is told.
    pub const SOURCE: Source = Source::Model { name: "thermal" };
    /// How far its answers can be trusted.
    pub const GRADE: Grade = Grade::Estimated;

    /// The thermal model of an actuator.
    ///
    /// R_wh + R_ha = 40 K / P_0, P_0 = 1.5 R I_0², R_wh = 0.1 (R_wh + R_ha), C_w = τ_w/R_wh, C_h = τ_h/R_ha
    ///
    /// # Symbols  R = R_LL at 80 °C \[Ω\], I_0 largest stall current of the motor over the ratios \[A\],
    ///   R_wh, R_ha thermal resistances \[K/W\], C_w, C_h heat capacities \[J/K\], τ_w = 60 s, τ_h = 2400 s
    /// # Source   docs/theory/thermal.md
    /// # Valid    on the plate of table 13.3; the rise of 40 K at I_0 is an assumption
    /// # Errors
    /// [`Missing`] with the first datum that is not known.
    pub fn of(actuator: &Parameters) -> Result<Self, Missing> {
        let current = match actuator.stall_current_motor.known() {
            Some(motor) => motor,
            None => actuator.stall_current.require("I_0")?,
        };
        let resistance = actuator.resistance_ll.require("R_LL")?;
        let loss_w = copper_loss(resistance.value, current.value).si();
        let total = RISE_AT_STALL / loss_w;
        let winding = WINDING_RESISTANCE_SHARE * total;
        Ok(Self::with([winding, total - winding], [WINDING_TIME_CONSTANT, HOUSING_TIME_CONSTANT]))
    }

    /// The modes of a chain with these resistances and the time constants τ_w = R_wh C_w, τ_h = R_ha C_h.
    fn with([r_wh, r_ha]: [f64; 2], [tau_w, tau_h]: [f64; 2]) -> Self {
        let (c_w, c_h) = (tau_w / r_wh, tau_h / r_ha);
        // w' = P/C_w − a (w − h), h' = c (w − h) − d h
        let (a, c, d) = (1.0 / tau_w, 1.0 / (r_wh * c_h), 1.0 / tau_h);
        let half = (a + c + d) / 2.0;
        let quick = -half - (half * half - a * d).sqrt();
        // The product of the two is a d; the quotient keeps the digits of the slow one.
        let slow = a * d / quick;
        let residue_w = |own: f64, other: f64| (own + c + d) / (c_w * (own - other));
        let residue_h = |own: f64, other: f64| c / (c_w * (own - other));
        let tau_s = [-1.0 / quick, -1.0 / slow];
        let [tau_quick, tau_slow] = tau_s;
        Self {
            resistance_k_per_w: [r_wh, r_ha],
            tau_s,
            gain_winding: [residue_w(quick, slow) * tau_quick, residue_w(slow, quick) * tau_slow],
            gain_housing: [residue_h(quick, slow) * tau_quick, residue_h(slow, quick) * tau_slow],
        }
    }

    /// The workings of [`Thermal::of`]: `P_0`, the loss that warms the winding by 40 K.
    pub fn explain(&self, actuator: &Parameters, work: &mut Workings) {
        let current = actuator.stall_current_motor.known().or_else(|| actuator.stall_current.known());
        let (Some(current), Some(resistance), true) = (current, actuator.resistance_ll.known(), work.is_on()) else {
            return;
        };
        work.given("I_0", &AMPERE, current);
        work.given("R_LL", &OHM, resistance);
        let hot = copper_loss(resistance.value, ElectricCurrent::from_si(1.0)).si() / 1.5;
        work.formula("R_hot", &OHM, hot, "R_LL*(1 + 3.93e-3*(80 - 20))", &Self::SOURCE);
        let loss = RISE_AT_STALL / self.resistance_k_per_w.iter().sum::<f64>();
        work.formula("P_0", &WATT, loss, "1.5*R_hot*I_0^2", &Self::SOURCE);
    }

    /// Temperatures under a loss that lasts for ever.
    ///
    /// ϑ_w = ϑ_a + P (R_wh + R_ha), ϑ_h = ϑ_a + P R_ha
    ///
    /// # Source   docs/theory/thermal.md
    #[must_use]
    pub fn steady(&self, loss_mean: Power, ambient: ThermodynamicTemperature) -> Temperatures {
        let [r_wh, r_ha] = self.resistance_k_per_w;
        Temperatures {
            winding: ThermodynamicTemperature::from_si(ambient.si() + loss_mean.si() * (r_wh + r_ha)),
            housing: ThermodynamicTemperature::from_si(ambient.si() + loss_mean.si() * r_ha),
        }
    }

    /// Time from cold (ambient temperature) until the winding reaches a threshold under a constant loss;
    /// `None` if it never does.
    ///
    /// ϑ_w(t) = ϑ_a + P Σ G_k (1 − e^(−t/τ_k)), rising; the root by bisection
    ///
    /// # Source   docs/theory/thermal.md
    #[must_use]
    pub fn warm_up_time(
        &self,
        loss_mean: Power,
        ambient: ThermodynamicTemperature,
        threshold: ThermodynamicTemperature,
    ) -> Option<Time> {
        let wanted = threshold.si() - ambient.si();
        if wanted <= 0.0 {
            return Some(Time::from_si(0.0));
        }
        let [g_quick, g_slow] = self.gain_winding;
        let [tau_quick, tau_slow] = self.tau_s;
        let loss = loss_mean.si();
        // Written with what is left to the steady state, whose difference keeps its digits near the end.
        let left_at_end = loss * (g_quick + g_slow) - wanted;
        if left_at_end.is_nan() || left_at_end <= 0.0 {
            return None;
        }
        let left = |t: f64| loss * (g_quick * (-t / tau_quick).exp() + g_slow * (-t / tau_slow).exp());
        let mut high = tau_slow;
        while left(high) > left_at_end {
            high *= 2.0;
            if high > 1e6 * tau_slow {
                return None;
            }
        }
        let mut low = 0.0;
        for _ in 0..200 {
            let middle = f64::midpoint(low, high);
            if left(middle) > left_at_end { low = middle } else { high = middle }
        }
        Some(Time::from_si(high))
    }

    /// Largest temperatures of a cycle of constant losses that repeats for ever.
    ///
    /// Each mode is a first-order lag; its steady periodic state is a closed form, and inside a piece the sum of the two
    /// A e^(−t/τ_1) + B e^(−t/τ_2) has at most one extreme, at t = ln(−A τ_2/(B τ_1)) / (1/τ_1 − 1/τ_2).
    ///
    /// # Symbols  pieces: duration \[s\] and loss \[W\], constant on each piece
    /// # Source   docs/theory/thermal.md
    /// # Valid    durations ≥ 0; an empty cycle stays at ambient temperature
    #[must_use]
    pub fn cycle(&self, pieces: &[(Time, Power)], ambient: ThermodynamicTemperature) -> CycleTemperatures {
        let plain: Vec<(f64, f64)> =
            pieces.iter().map(|(duration, loss)| (duration.si(), loss.si())).filter(|(s, _)| *s > 0.0).collect();
        let modes = self.tau_s.map(|tau| periodic_lag(&plain, tau));
        let (winding, at_s) = self.peak(&plain, &modes, self.gain_winding);
        let (housing, _) = self.peak(&plain, &modes, self.gain_housing);
        CycleTemperatures {
            winding_max: ThermodynamicTemperature::from_si(ambient.si() + winding),
            at: Time::from_si(at_s),
            housing: ThermodynamicTemperature::from_si(ambient.si() + housing),
        }
    }

    /// Temperatures at the start of every piece of a cycle that repeats for ever; as [`Thermal::cycle`].
    #[must_use]
    pub fn course(&self, pieces: &[(Time, Power)], ambient: ThermodynamicTemperature) -> Vec<Temperatures> {
        let plain: Vec<(f64, f64)> = pieces.iter().map(|(duration, loss)| (duration.si(), loss.si())).collect();
        let [quick, slow] = self.tau_s.map(|tau| periodic_lag(&plain, tau));
        let rise = |[q, s]: [f64; 2], quick: f64, slow: f64| {
            ThermodynamicTemperature::from_si(ambient.si() + q * quick + s * slow)
        };
        let starts = quick.into_iter().zip(slow);
        starts
            .map(|(quick, slow)| Temperatures {
                winding: rise(self.gain_winding, quick, slow),
                housing: rise(self.gain_housing, quick, slow),
            })
            .collect()
    }

    /// Largest rise \[K\] of a node with these gains and its moment \[s\].
    fn peak(&self, pieces: &[(f64, f64)], modes: &[Vec<f64>; 2], gains: [f64; 2]) -> (f64, f64) {
        let ([quick, slow], [g_quick, g_slow], [tau_quick, tau_slow]) = (modes, gains, self.tau_s);
        let (mut peak, mut at_s, mut clock_s) = (0.0_f64, 0.0, 0.0);
        for ((&(duration_s, loss), y_quick), y_slow) in pieces.iter().zip(quick).zip(slow) {
            let (a, b) = (g_quick * (y_quick - loss), g_slow * (y_slow - loss));
            let end = loss * (g_quick + g_slow);
            let rise = |t: f64| end + a * (-t / tau_quick).exp() + b * (-t / tau_slow).exp();
            // a/τ_q e^(−t/τ_q) + b/τ_s e^(−t/τ_s) = 0
            let ratio = -(a * tau_slow) / (b * tau_quick);
            let inside = if ratio > 0.0 { ratio.ln() / (1.0 / tau_quick - 1.0 / tau_slow) } else { f64::NAN };
            let mut see = |t: f64, rise: f64| {
                if rise > peak {
                    (peak, at_s) = (rise, clock_s + t);
                }
            };
            see(0.0, end + a + b);
            if (0.0..=duration_s).contains(&inside) {
                see(inside, rise(inside));
            }
            see(duration_s, rise(duration_s));
            clock_s += duration_s;
        }
        (peak, at_s)
    }
}

/// Copper loss of a star winding at 80 °C: the loss that the thermal model is made for.
///
/// P = 1.5 R_LL I²
///
/// # Symbols  R_LL line to line at 80 °C \[Ω\], computed here from the value at 20 °C; I current, rms \[A\]
/// # Source   docs/theory/continuous-torque.md
/// # Valid    constant hot resistance: the safe side as long as the winding is cooler
#[must_use]
pub fn copper_loss(resistance_ll_20: ElectricalResistance, current: ElectricCurrent) -> Power {
    let hot = copper_resistance(resistance_ll_20, ThermodynamicTemperature::from_si(WINDING_TEMPERATURE_CONTINUOUS));
    Power::from_si(1.5 * hot.si() * current.si().powi(2))
}

#[cfg(test)]
#[path = "temperature_tests.rs"]
mod tests;
