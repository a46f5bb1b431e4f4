//! Resolver windings, and the loop that tracks the resolver angle.

use quantities::{Angle, AngularVelocity, EffectiveVoltage, ElectricPotential, Frequency, Measure, Time};
use std::f64::consts::{SQRT_2, TAU};

/// A resolver with its excitation.
///
/// u_e = √2 U sin(2πft),  u_s = k u_e sin(pφ),  u_c = k u_e cos(pφ)
///
/// # Symbols
/// U excitation (rms) \[V\], f frequency of the excitation \[Hz\], t time \[s\], k transformation ratio, p pole pairs,
/// φ measured angle \[rad\]
/// # Source
/// Levels, frequency, ratio and pole pairs: cha-manual table 58.2
/// # Valid
/// Without phase shift of the windings and without the rotational voltage: at 5000 1/min the latter is 1.7 % of the
/// carrier voltage at 5 kHz
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Resolver {
    /// Number of pole pairs.
    pub pole_pairs: u32,
    /// Excitation voltage, rms.
    pub excitation: EffectiveVoltage,
    /// Excitation frequency.
    pub frequency: Frequency,
    /// Transformation ratio: voltage of a winding over the excitation \[1\].
    pub ratio: f64,
}

/// Voltages of the resolver at an instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Windings {
    /// Voltage of the excitation.
    pub excitation: ElectricPotential,
    /// Sine winding.
    pub sine: ElectricPotential,
    /// Cosine winding.
    pub cosine: ElectricPotential,
}

impl Resolver {
    /// Returns the voltages at an angle and a time.
    #[must_use]
    pub fn at(&self, seen: Angle, time: Time) -> Windings {
        let carrier = self.peak() * (TAU * self.frequency.si() * time.si()).sin();
        let [sine, cosine] = self.envelope(seen);
        let volts = ElectricPotential::from_si;
        Windings { excitation: volts(carrier), sine: volts(carrier * sine), cosine: volts(carrier * cosine) }
    }

    /// Returns the voltages of sine and cosine winding at the peak of the excitation, relative to the excitation \[1\].
    #[must_use]
    pub fn envelope(&self, seen: Angle) -> [f64; 2] {
        let (sine, cosine) = (f64::from(self.pole_pairs) * seen.si()).sin_cos();
        [self.ratio * sine, self.ratio * cosine]
    }

    /// Returns the peak of the excitation \[V\].
    fn peak(&self) -> f64 {
        self.excitation.si() * SQRT_2
    }
}

/// A type II tracking loop with the constants of the AD2S1205.
///
/// G(z) = k_1 k_2 I(z)² C(z),  I(z) = c/(1 − z⁻¹),  C(z) = (1 − a z⁻¹)/(1 − b z⁻¹),  error sin(θ − φ)
///
/// # Symbols
/// θ angle of the resolver, φ angle of the loop, k_1 = 1.8/2.5, k_2 = 2π·18·10⁶, a = 4095/4096, b = 4085/4096, c = 1/4.096 MHz
/// # Source
/// Analog Devices, AD2S1205 data sheet rev. A, "Circuit Dynamics"
/// # Valid
/// Demodulated signals of nominal level. A reference converter; the converter of a drive depends on its manufacturer
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrackingLoop {
    integral: f64,
    compensated: f64,
    angle_rad: f64,
}

/// Output of the loop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tracked {
    /// Tracked angle.
    pub angle: Angle,
    /// Tracked speed.
    pub speed: AngularVelocity,
    /// Sine of the tracking error.
    pub error: f64,
}

impl TrackingLoop {
    /// Steps per second \[Hz\].
    pub const RATE_HZ: f64 = 4.096e6;
    const GAIN: f64 = 1.8 / 2.5 * 18e6 * TAU;
    const A: f64 = 4095.0 / 4096.0;
    const B: f64 = 4085.0 / 4096.0;

    /// Creates a loop at rest at an angle.
    #[must_use]
    pub fn at_rest(angle: Angle) -> Self {
        Self { integral: 0.0, compensated: 0.0, angle_rad: angle.si() }
    }

    /// Creates a loop that follows a constant speed without error: both integrators hold their steady-state values.
    #[must_use]
    pub fn turning(angle: Angle, speed: AngularVelocity) -> Self {
        let integral = speed.si() * (1.0 - Self::B) / (1.0 - Self::A);
        Self { integral, compensated: speed.si(), angle_rad: angle.si() }
    }

    /// Returns the acceleration that causes an error of one radian: k_1 k_2 (1 − a)/(1 − b) \[1/s²\].
    #[must_use]
    pub const fn acceleration_constant() -> f64 {
        Self::GAIN * (1.0 - Self::A) / (1.0 - Self::B)
    }

    /// Returns the time constants (1 + a)/(2c⁻¹(1 − a)) and (1 + b)/(2c⁻¹(1 − b)).
    #[must_use]
    pub fn time_constants() -> [Time; 2] {
        [Self::A, Self::B].map(|x| Time::from_si((1.0 + x) / (2.0 * Self::RATE_HZ * (1.0 - x))))
    }

    /// Advances one step with the demodulated windings, relative to their nominal peak.
    pub fn step(&mut self, [sine, cosine]: [f64; 2]) -> Tracked {
        const C: f64 = 1.0 / TrackingLoop::RATE_HZ;
        let ahead = Self::B * self.compensated + (1.0 - Self::A) * self.integral;
        let foreseen = self.angle_rad + C * ahead;
        let (own_sine, own_cosine) = foreseen.sin_cos();
        // The error is that of the angle after the step, which changes with the step by c² k times the error.
        let error = (sine * own_cosine - cosine * own_sine) / (1.0 + C * C * Self::GAIN);
        self.compensated = ahead + C * Self::GAIN * error;
        self.integral += C * Self::GAIN * error;
        self.angle_rad += C * self.compensated;
        Tracked { angle: Angle::from_si(self.angle_rad), speed: AngularVelocity::from_si(self.compensated), error }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use quantities::unit::{EFFECTIVE_VOLT, KILOHERTZ};

    const fn turn(share: f64) -> f64 {
        TAU * share
    }

    #[test]
    fn the_angle_comes_back_from_samples_of_a_carrier() {
        let resolver = Resolver {
            pole_pairs: 1,
            excitation: EffectiveVoltage::new_in(7.0, &EFFECTIVE_VOLT),
            frequency: Frequency::new_in(5.0, &KILOHERTZ),
            ratio: 0.5,
        };
        for at in 0..360 {
            let angle = Angle::from_si(turn(f64::from(at) / 360.0));
            let samples = (0..16).map(|each| resolver.at(angle, Time::from_si(f64::from(each) / 16.0 / 5000.0)));
            // Each winding is multiplied by the excitation and summed, followed by the arctangent.
            let (sine, cosine) = samples.fold((0.0, 0.0), |(sine, cosine), found| {
                let carrier = found.excitation.si();
                (sine + found.sine.si() * carrier, cosine + found.cosine.si() * carrier)
            });
            let found = sine.atan2(cosine);
            assert!((found - angle.si()).sin().abs() < 1e-12, "{at}: {found}");
        }
        let peak = resolver.at(Angle::from_si(turn(0.25)), Time::from_si(1.0 / 20_000.0));
        assert!((peak.excitation.si() - 7.0 * SQRT_2).abs() < 1e-12 && (peak.sine.si() - 3.5 * SQRT_2).abs() < 1e-12);
    }

    /// Values computed in the data sheet: K_a 7.403·10⁶ 1/s², t_1 1.000 ms, t_2 90.8 µs.
    #[test]
    fn the_constants_are_those_of_the_data_sheet() {
        assert!((TrackingLoop::acceleration_constant() - 7.403e6).abs() < 0.5e3);
        let [first, second] = TrackingLoop::time_constants();
        assert!((first.si() - 1e-3).abs() < 0.5e-6 && (second.si() - 90.8e-6).abs() < 0.05e-6);
    }

    /// 10 000 1/min per second are 1047 rad/s²; the lag is 0.49′, as computed in the data sheet.
    #[test]
    fn acceleration_leaves_the_lag_of_the_data_sheet() {
        let acceleration = 10_000.0 * TAU / 60.0;
        let mut tracking = TrackingLoop::at_rest(Angle::from_si(0.0));
        let mut lag = 0.0;
        for at in 1..=200_000 {
            let time = f64::from(at) / TrackingLoop::RATE_HZ;
            let angle = acceleration * time * time / 2.0;
            let found = tracking.step([angle.sin(), angle.cos()]);
            lag = angle - found.angle.si();
        }
        assert!((lag.to_degrees() * 60.0 - 0.49).abs() < 0.005, "{lag}");
        assert!((lag - acceleration / TrackingLoop::acceleration_constant()).abs() < 1e-8);
    }
}
