//! Holding brake: sag while it closes, and the stop of an axis without drive torque.
//!
//! The built-in brake is a holding brake and no safety function: an axis under gravity needs an additional one
//! (cha-manual section 2).

use provenance::Datum;
use quantities::{
    Angle, AngularVelocity, ElectricCurrent, ElectricPotential, Energy, Measure, MomentOfInertia, Power, Ratio, Time,
    Torque,
};

/// Data of the brake; every datum is [`Datum::NotApplicable`] without a brake.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Brake {
    /// T_Br: holding torque at the output.
    pub holding_torque: Datum<Torque>,
    /// U_Br: nominal DC voltage.
    pub voltage: Datum<ElectricPotential>,
    /// I_OBr: opening current.
    pub opening_current: Datum<ElectricCurrent>,
    /// I_HBr: holding current, which keeps the brake open.
    pub holding_current: Datum<ElectricCurrent>,
    /// t_o: opening time.
    pub opening_time: Datum<Time>,
    /// t_c: closing time.
    pub closing_time: Datum<Time>,
    /// N_brakings: permitted number of applications at standstill.
    pub brakings_max: Datum<f64>,
    /// N_emergency: permitted number of stops from motion.
    pub emergency_max: Datum<f64>,
}

impl Brake {
    /// Returns the data of an actuator without brake.
    #[must_use]
    pub const fn absent() -> Self {
        Self {
            holding_torque: Datum::NotApplicable,
            voltage: Datum::NotApplicable,
            opening_current: Datum::NotApplicable,
            holding_current: Datum::NotApplicable,
            opening_time: Datum::NotApplicable,
            closing_time: Datum::NotApplicable,
            brakings_max: Datum::NotApplicable,
            emergency_max: Datum::NotApplicable,
        }
    }
}

/// Returns an upper bound of the mean heat of the coil over a cycle.
///
/// P = U_Br I_HBr s
///
/// # Symbols
/// U_Br nominal voltage \[V\], I_HBr holding current \[A\], s share of the cycle in which the brake is open
/// # Source
/// docs/theory/brake.md
/// # Valid
/// power of the supply at full voltage; a drive that lowers the voltage for holding leaves less in the coil
#[must_use]
pub fn coil_power(voltage: ElectricPotential, holding_current: ElectricCurrent, share_open: Ratio) -> Power {
    Power::from_si(voltage.si() * holding_current.si().abs() * share_open.si())
}

/// Returns the angle by which an axis at rest sags while its brake closes and nothing else holds it.
///
/// φ = ½ (T / J) t_c²
///
/// # Symbols
/// T unbalanced torque at the output \[Nm\], J load and actuator at the output \[kgm²\], t_c closing time \[s\]
/// # Source
/// docs/theory/brake.md, uniform acceleration from rest
/// # Valid
/// J > 0; no friction, brake without effect before t_c: an upper bound
#[must_use]
pub fn sag_angle(inertia_total: MomentOfInertia, torque_unbalanced: Torque, closing_time: Time) -> Angle {
    Angle::from_si(0.5 * torque_unbalanced.si() / inertia_total.si() * closing_time.si().powi(2))
}

/// Outcome of a stop by the brake alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StopOutcome {
    /// The axis comes to rest and is held.
    Stops(EmergencyStop),
    /// The driving torque is not below the holding torque: the brake cannot stop or hold the axis.
    DoesNotStop,
}

/// A stop by the brake alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EmergencyStop {
    /// Energy dissipated in the brake.
    pub energy: Energy,
    /// Path from the failure to rest, both directions added.
    pub angle: Angle,
    /// Time from the failure to rest.
    pub time: Time,
    /// Speed when the brake engages, positive in the direction of the initial speed.
    pub speed_at_engagement: AngularVelocity,
}

/// Computes the stop of an axis without drive torque by the holding brake.
///
/// ω_1 = ω_0 + (T_d/J) t_c, then |α| = (T_Br − T_d sgn ω_1)/J:
/// t = t_c + |ω_1|/|α|, φ = φ(t_c) + ω_1²/(2 |α|), W = T_Br ω_1²/(2 |α|)
///
/// # Symbols
/// ω_0 speed at the failure [rad/s], T_d torque of the load \[Nm\], positive if it drives the motion, J load and
/// actuator at the output \[kgm²\], T_Br holding torque at the output \[Nm\], t_c closing time \[s\]
/// # Source
/// docs/theory/brake.md, uniform acceleration in two parts
/// # Valid
/// J > 0; full torque from t_c on and none before, sliding torque equal to the holding torque, no friction
#[must_use]
pub fn emergency_stop(
    inertia_total: MomentOfInertia,
    speed: AngularVelocity,
    holding_torque: Torque,
    torque_driving: Torque,
    closing_time: Time,
) -> StopOutcome {
    let (brake, t_c, inertia) = (holding_torque.si(), closing_time.si(), inertia_total.si());
    // Sign convention: the initial speed is positive.
    let (omega_0, driving) = (speed.si().abs(), torque_driving.si());
    if brake <= driving.abs() {
        return StopOutcome::DoesNotStop;
    }
    let alpha = driving / inertia;
    let omega_1 = omega_0 + alpha * t_c;
    let falling = if omega_1 >= 0.0 {
        omega_0 * t_c + 0.5 * alpha * t_c * t_c
    } else {
        // The load reverses the axis before the brake is closed.
        let reversal = -omega_0 / alpha;
        0.5 * omega_0 * reversal + 0.5 * alpha.abs() * (t_c - reversal).powi(2)
    };
    let net = if omega_1 >= 0.0 { brake - driving } else { brake + driving };
    let braking = 0.5 * inertia * omega_1 * omega_1 / net;
    StopOutcome::Stops(EmergencyStop {
        energy: Energy::from_si(brake * braking),
        angle: Angle::from_si(falling + braking),
        time: Time::from_si(t_c + omega_1.abs() * inertia / net),
        speed_at_engagement: AngularVelocity::from_si(omega_1),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stop(j: f64, w: f64, brake: f64, driving: f64, t_c: f64) -> StopOutcome {
        emergency_stop(
            MomentOfInertia::from_si(j),
            AngularVelocity::from_si(w),
            Torque::from_si(brake),
            Torque::from_si(driving),
            Time::from_si(t_c),
        )
    }

    fn stops(j: f64, w: f64, brake: f64, driving: f64, t_c: f64) -> EmergencyStop {
        match stop(j, w, brake, driving, t_c) {
            StopOutcome::Stops(found) => found,
            StopOutcome::DoesNotStop => panic!("does not stop"),
        }
    }

    /// 20 Nm on 2 kgm² for 0.07 s: α = 10 rad/s², φ = 0.0245 rad.
    #[test]
    fn a_hanging_axis_sags_by_half_a_t_squared() {
        let (j, t, t_c) = (MomentOfInertia::from_si(2.0), Torque::from_si(20.0), Time::from_si(0.07));
        assert!((sag_angle(j, t, t_c).si() - 0.0245).abs() < 1e-15);
        assert!((sag_angle(j, -t, t_c).si() + 0.0245).abs() < 1e-15);
    }

    /// J = 2, ω = 5, T_Br = 45, T_d = 0, t_c = 0.07: coasts 0.35 rad, then 25/45 rad in 10/45 s; heat = ½ J ω² = 25 J.
    #[test]
    fn without_a_load_torque_the_heat_is_the_kinetic_energy() {
        let found = stops(2.0, 5.0, 45.0, 0.0, 0.07);
        assert!((found.energy.si() - 25.0).abs() < 1e-12);
        assert!((found.angle.si() - (0.35 + 25.0 / 45.0)).abs() < 1e-12);
        assert!((found.time.si() - (0.07 + 10.0 / 45.0)).abs() < 1e-12);
    }

    /// The heat is the kinetic energy at the failure plus the work of the load over the whole path.
    #[test]
    fn energy_balance_with_a_driving_and_a_helping_load() {
        for driving in [-30.0, -10.0, 0.0, 10.0, 30.0, 44.0] {
            let found = stops(2.0, 5.0, 45.0, driving, 0.07);
            assert!(found.speed_at_engagement.si() > 0.0);
            let put_in = 0.5 * 2.0 * 25.0 + driving * found.angle.si();
            assert!((found.energy.si() - put_in).abs() < 1e-9, "{driving}");
        }
    }

    /// ω = 0.1 rad/s against α = −10 rad/s²: reversal at 0.01 s after 0.0005 rad, then 0.06 s backwards, 0.018 rad,
    /// 0.6 rad/s; then 25 Nm net on 2 kgm²: 0.0144 rad in 0.048 s.
    #[test]
    fn a_load_may_reverse_the_axis_before_the_brake_closes() {
        let found = stops(2.0, 0.1, 45.0, -20.0, 0.07);
        assert!((found.speed_at_engagement.si() + 0.6).abs() < 1e-12);
        assert!((found.angle.si() - (0.0005 + 0.018 + 0.0144)).abs() < 1e-12);
        assert!((found.time.si() - 0.118).abs() < 1e-12);
    }

    #[test]
    fn at_rest_the_stop_begins_with_the_sag() {
        let found = stops(2.0, 0.0, 45.0, 20.0, 0.07);
        let sag = sag_angle(MomentOfInertia::from_si(2.0), Torque::from_si(20.0), Time::from_si(0.07)).si();
        // 0.7 rad/s against 25 Nm net: 0.49 / 25 rad more.
        assert!((found.angle.si() - sag - 0.49 / 25.0).abs() < 1e-12);
        assert_eq!(stops(2.0, 0.0, 45.0, 0.0, 0.07).energy.si(), 0.0);
    }

    /// 24 V and 0.3 A: 7.2 W while it is open.
    #[test]
    fn the_coil_heats_while_the_brake_is_open() {
        let power = |share| {
            let (voltage, current) = (ElectricPotential::from_si(24.0), ElectricCurrent::from_si(0.3));
            coil_power(voltage, current, Ratio::from_si(share)).si()
        };
        assert!((power(1.0) - 7.2).abs() < 1e-12 && (power(0.25) - 1.8).abs() < 1e-12 && power(0.0) == 0.0);
    }

    #[test]
    fn a_brake_weaker_than_the_load_does_not_stop() {
        assert_eq!(stop(2.0, 5.0, 45.0, 45.0, 0.07), StopOutcome::DoesNotStop);
        assert_eq!(stop(2.0, 5.0, 45.0, -50.0, 0.07), StopOutcome::DoesNotStop);
    }
}
