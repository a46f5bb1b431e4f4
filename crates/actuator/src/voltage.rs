//! Terminal voltage of the motor in the dq frame of the rotor.

use crate::copper::copper_resistance;
use crate::parameters::Drivetrain;
use derivation::Workings;
use provenance::{Grade, Missing, Source};
use quantities::unit::{
    AMPERE, DEGREE_CELSIUS, HENRY, OHM, RADIAN_PER_SECOND, VOLT, VOLT_PER_THOUSAND_REVOLUTIONS, VOLT_SECOND_PER_RADIAN,
};
use quantities::{AngularVelocity, ElectricCurrent, ElectricPotential, Measure, ThermodynamicTemperature};

/// Electrical constants of a motor per phase of the star.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotorVoltage {
    /// i: reduction ratio \[1\].
    ratio: f64,
    /// p: number of pole pairs.
    pole_pairs: f64,
    /// R = R_LL/2 at the temperature of the winding \[Ω\]
    resistance_ohm: f64,
    /// L = L_LL/2 \[H\]
    inductance_h: f64,
    /// ψ: flux linkage, peak value of one phase \[Vs\]
    flux_vs: f64,
    /// Worst grade of the inputs.
    pub grade: Grade,
}

impl MotorVoltage {
    /// Creates the constants of an actuator's motor with the winding at the shutdown temperature, where the resistance
    /// is largest.
    ///
    /// # Errors
    /// [`Missing`] with the first unknown datum.
    pub fn of(actuator: &Drivetrain) -> Result<Self, Missing> {
        let hot = actuator.heat.winding_shutdown.require("T_KTY")?;
        let motor = Self::with_winding(actuator, hot.value)?;
        Ok(Self { grade: motor.grade.worst(hot.grade), ..motor })
    }

    /// Creates the constants of an actuator's motor with the winding at a temperature.
    ///
    /// ψ = k_EM √(2/3) / p, with k_EM the rms voltage line to line per mechanical angular velocity
    ///
    /// # Errors
    /// [`Missing`] with the first unknown datum.
    pub fn with_winding(actuator: &Drivetrain, winding: ThermodynamicTemperature) -> Result<Self, Missing> {
        let ratio = actuator.ratio.require("i")?;
        let pole_pairs = actuator.pole_pairs.require("p")?;
        let resistance = actuator.resistance_ll.require("R_LL")?;
        let inductance = actuator.inductance_ll.require("L_LL")?;
        let constant = actuator.voltage_constant_motor.require("k_EM")?;
        let resistance_ll = copper_resistance(resistance.value, winding);
        Ok(Self {
            ratio: ratio.value,
            pole_pairs: pole_pairs.value,
            resistance_ohm: resistance_ll.si() / 2.0,
            inductance_h: inductance.value.si() / 2.0,
            flux_vs: constant.value.si() * (2.0_f64 / 3.0).sqrt() / pole_pairs.value,
            grade: [pole_pairs.grade, resistance.grade, inductance.grade, constant.grade]
                .into_iter()
                .fold(Grade::Computed, Grade::worst),
        })
    }

    /// Returns u_d and u_q \[V\], peak values of one phase, with i_d = 0.
    ///
    /// u_d = −ω_e L i_q, u_q = R i_q + ω_e ψ, ω_e = p i ω_out, i_q = √2 I
    #[inline]
    fn components(&self, speed_out: AngularVelocity, current: ElectricCurrent) -> (f64, f64) {
        let omega_e = self.pole_pairs * self.ratio * speed_out.si();
        let i_q = std::f64::consts::SQRT_2 * current.si();
        (-omega_e * self.inductance_h * i_q, self.resistance_ohm * i_q + omega_e * self.flux_vs)
    }

    /// Returns the terminal voltage, fundamental, line to line, rms.
    ///
    /// U = √(3/2) √(u_d² + u_q²)
    ///
    /// # Symbols
    /// I motor current, rms, signed like the torque; ω_out output speed, signed
    /// # Source
    /// docs/theory/voltage.md; model of the synchronous machine with surface magnets
    /// # Valid
    /// sinusoidal quantities, no saturation, i_d = 0
    #[must_use]
    pub fn at(&self, speed_out: AngularVelocity, current: ElectricCurrent) -> ElectricPotential {
        let (u_d, u_q) = self.components(speed_out, current);
        ElectricPotential::from_si((1.5 * (u_d * u_d + u_q * u_q)).sqrt())
    }

    /// Returns p i, R \[Ω\], L \[H\] and ψ \[Vs\] per phase of the star.
    #[must_use]
    pub const fn constants(&self) -> [f64; 4] {
        [self.pole_pairs * self.ratio, self.resistance_ohm, self.inductance_h, self.flux_vs]
    }

    /// Records the derivation of [`MotorVoltage::at`]; the caller has recorded the speed `n` and the current `I`, the
    /// result is `U_LL`.
    pub fn explain(
        &self,
        actuator: &Drivetrain,
        speed_out: AngularVelocity,
        current: ElectricCurrent,
        work: &mut Workings,
    ) {
        if !work.is_on() {
            return;
        }
        let source = Source::Model { name: "voltage" };
        work.known_number("i", &actuator.ratio);
        work.known_number("p", &actuator.pole_pairs);
        work.known("R_LL", &OHM, &actuator.resistance_ll);
        work.known("L_LL", &HENRY, &actuator.inductance_ll);
        work.known("k_EM", &VOLT_PER_THOUSAND_REVOLUTIONS, &actuator.voltage_constant_motor);
        let omega_e = self.pole_pairs * self.ratio * speed_out.si();
        let i_q = std::f64::consts::SQRT_2 * current.si();
        let (u_d, u_q) = self.components(speed_out, current);
        work.known("theta_max", &DEGREE_CELSIUS, &actuator.heat.winding_shutdown);
        work.formula("R", &OHM, self.resistance_ohm, "R_LL*(1 + 3.93e-3*(theta_max - 20))/2", &source);
        work.formula("L", &HENRY, self.inductance_h, "L_LL/2", &source);
        work.formula("psi", &VOLT_SECOND_PER_RADIAN, self.flux_vs, "k_EM*sqrt(2/3)/(p*2*pi*1000/60)", &source);
        work.formula("omega_e", &RADIAN_PER_SECOND, omega_e, "p*i*n*2*pi/60", &source);
        work.formula("i_q", &AMPERE, i_q, "sqrt(2)*I", &source);
        work.formula("u_d", &VOLT, u_d, "-omega_e*L*i_q", &source);
        work.formula("u_q", &VOLT, u_q, "R*i_q + omega_e*psi", &source);
        work.formula("U_LL", &VOLT, self.at(speed_out, current).si(), "sqrt(3/2)*sqrt(u_d^2 + u_q^2)", &source);
    }

    /// Returns the largest driving current at a speed and a terminal voltage; `None` if the voltage does not reach the
    /// back-EMF with i_d = 0.
    ///
    /// (ω_e² L² + R²) i_q² + 2 R ω_e ψ i_q + ω_e² ψ² − ⅔ U² = 0, I = i_q/√2
    ///
    /// # Symbols
    /// see [`MotorVoltage::at`]; U terminal voltage, fundamental, line to line, rms \[V\]
    /// # Source
    /// docs/theory/short-time-torque.md
    /// # Valid
    /// see [`MotorVoltage::at`]; field weakening (i_d < 0) would permit more
    #[must_use]
    pub fn current_max(&self, speed_out: AngularVelocity, voltage: ElectricPotential) -> Option<ElectricCurrent> {
        let omega_e = self.pole_pairs * self.ratio * speed_out.si().abs();
        let (reactance, resistance) = (omega_e * self.inductance_h, self.resistance_ohm);
        let square = reactance * reactance + resistance * resistance;
        let emf = omega_e * self.flux_vs;
        let rest = emf * emf - voltage.si().powi(2) / 1.5;
        let root = (resistance * emf).powi(2) - square * rest;
        (rest <= 0.0).then(|| {
            // The product of the roots is rest/square: this form avoids cancellation.
            let i_q = -rest / (resistance * emf + root.max(0.0).sqrt());
            ElectricCurrent::from_si(i_q / std::f64::consts::SQRT_2)
        })
    }

    /// Returns an upper bound of the terminal voltage over a ramp on which speed and current change linearly; if both
    /// increase or both are constant, it is the voltage at the end with the larger values.
    ///
    /// U² is a polynomial of the fourth degree there, bounded by the largest of its coefficients in the Bernstein
    /// basis: u_d has (d_0, d_1, d_2) with d_1 = −ω_e L i_q from crosswise ends, u_q has (q_0, q_1).
    ///
    /// # Source
    /// docs/theory/voltage.md
    #[must_use]
    pub fn bound_on_line(&self, ends: [(AngularVelocity, ElectricCurrent); 2]) -> ElectricPotential {
        let [(n0, i0), (n1, i1)] = ends;
        let ((d0, q0), (d2, q1)) = (self.components(n0, i0), self.components(n1, i1));
        let d1 = 0.5 * (self.components(n0, i1).0 + self.components(n1, i0).0);
        let square = [
            d0 * d0 + q0 * q0,
            d0 * d1 + 0.5 * q0 * (q0 + q1),
            (d0 * d2 + 2.0 * d1 * d1) / 3.0 + (q0 * q0 + 4.0 * q0 * q1 + q1 * q1) / 6.0,
            d1 * d2 + 0.5 * q1 * (q0 + q1),
            d2 * d2 + q1 * q1,
        ];
        ElectricPotential::from_si((1.5 * square.into_iter().fold(0.0, f64::max)).sqrt())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Parameters;
    use provenance::{CellRef, Datum, Source, Sourced};
    use quantities::unit::{MILLIHENRY, OHM, REVOLUTION_PER_MINUTE, VOLT_PER_THOUSAND_REVOLUTIONS};
    use quantities::{ElectricalResistance, Inductance, VoltageConstant};

    fn known<T>(value: T) -> Datum<T> {
        const CELL: CellRef = CellRef::of_the_manual("26.1", "x", "");
        Datum::Known(Sourced { value, source: Source::Cell(&CELL), grade: Grade::Printed, errata: &[] })
    }

    /// Returns the motor of CHA-20A (table 26.1) at i = 50.
    fn motor(resistance: f64, inductance: f64) -> MotorVoltage {
        MotorVoltage::of(&Parameters::from(Drivetrain {
            ratio: known(50.0),
            pole_pairs: known(5.0),
            resistance_ll: known(ElectricalResistance::new_in(resistance, &OHM)),
            inductance_ll: known(Inductance::new_in(inductance, &MILLIHENRY)),
            voltage_constant_motor: known(VoltageConstant::new_in(23.0, &VOLT_PER_THOUSAND_REVOLUTIONS)),
            heat: crate::Heat {
                winding_shutdown: known(ThermodynamicTemperature::from_si(363.15)),
                ..crate::Heat::default()
            },
            ..Drivetrain::unknown()
        }))
        .unwrap()
    }

    fn rpm(n: f64) -> AngularVelocity {
        AngularVelocity::new_in(n, &REVOLUTION_PER_MINUTE)
    }

    /// Without current the terminals have the back-EMF only: k_EM · 6000 = 138 V at 120 1/min with i = 50.
    #[test]
    fn without_current_the_back_emf_is_left() {
        let volts = motor(5.9, 8.0).at(rpm(120.0), ElectricCurrent::from_si(0.0)).si();
        assert!((volts - 138.0).abs() < 1e-9, "{volts}");
    }

    /// At standstill only the hot resistance has an effect: √3 · R/2 · I = √3/2 · 5.9 · 1.2751 · 2 A.
    #[test]
    fn at_standstill_the_resistance_is_left() {
        let volts = motor(5.9, 8.0).at(rpm(0.0), ElectricCurrent::from_si(2.0)).si();
        assert!((volts - 3.0_f64.sqrt() / 2.0 * 5.9 * (1.0 + 3.93e-3 * 70.0) * 2.0).abs() < 1e-9, "{volts}");
    }

    #[test]
    fn braking_needs_less_voltage_than_driving() {
        let motor = motor(5.9, 8.0);
        let current = ElectricCurrent::from_si(3.0);
        assert!(motor.at(rpm(100.0), -current).si() < motor.at(rpm(100.0), current).si());
        assert!((motor.at(rpm(-100.0), -current).si() - motor.at(rpm(100.0), current).si()).abs() < 1e-12);
    }

    #[test]
    fn the_largest_voltage_bounds_every_point_of_the_ramp() {
        let motor = motor(5.9, 60.0);
        for (n0, i0, n1, i1) in
            [(0.0, 4.0, 120.0, 4.2), (120.0, -1.0, 0.0, -4.0), (0.0, 5.0, 120.0, -1.0), (50.0, 2.0, 50.0, 2.0)]
        {
            let (a, b) = ((rpm(n0), ElectricCurrent::from_si(i0)), (rpm(n1), ElectricCurrent::from_si(i1)));
            let bound = motor.bound_on_line([a, b]).si();
            for step in 0..=100 {
                let s = f64::from(step) / 100.0;
                let here = motor.at(rpm(n0 + s * (n1 - n0)), ElectricCurrent::from_si(i0 + s * (i1 - i0))).si();
                assert!(here <= bound + 1e-9, "{n0} {i0} {n1} {i1} {s}: {here} > {bound}");
            }
        }
    }

    #[test]
    fn the_largest_current_needs_exactly_the_voltage() {
        let motor = motor(5.9, 8.0);
        for n in [0.0, 30.0, 100.0, 120.0] {
            let current = motor.current_max(rpm(n), ElectricPotential::from_si(220.0)).unwrap();
            assert!((motor.at(rpm(n), current).si() - 220.0).abs() < 1e-9, "{n}");
        }
        // 120 1/min cause a back-EMF of 138 V.
        assert!(motor.current_max(rpm(120.0), ElectricPotential::from_si(137.9)).is_none());
        let nothing = motor.current_max(rpm(120.0), ElectricPotential::from_si(138.000_000_1)).unwrap();
        assert!(nothing.si() < 1e-6);
    }
}
