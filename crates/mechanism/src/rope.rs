//! Ropes that hold a load; they can pull but not push.

use crate::flange::Mounting;
use crate::{Extra, Mechanism, Output};

/// A rope, belt or chain that can only pull.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rope {
    /// Rope of the load.
    Load,
    /// Rope of the counterweight.
    Counterweight,
}

impl Rope {
    /// The rope of the load, then that of the counterweight.
    pub const ALL: [Self; 2] = [Self::Load, Self::Counterweight];
}

impl Mechanism {
    /// Returns the tension of a taut rope \[N\], negative where it would have to push; `None` if the mechanism has no
    /// such rope.
    ///
    /// # Symbols
    /// `recorded_nm` recorded torque \[Nm\], without a stage a force along the line
    /// # Source
    /// docs/theory/mechanisms.md#slack-rope
    /// # Valid
    /// stiff rope, taut until this instant
    #[must_use]
    pub fn rope_tension(&self, rope: Rope, output: &Output, extra: &Extra, recorded_nm: f64) -> Option<f64> {
        let (behind, mounting) =
            (self.stage.as_ref().map_or(*output, |stage| stage.behind(output)), Mounting::default());
        // With a stage, a recorded torque is that of the actuator and no force along the line.
        let recorded_nm = if self.stage.is_some() { 0.0 } else { recorded_nm };
        self.kind.equations().rope_tension(rope, &self.instant(&behind, extra, recorded_nm, &mounting))
    }

    /// Returns `true` if a rope holds the load or a counterweight.
    #[must_use]
    pub fn has_rope(&self) -> bool {
        let still = Output { position_rad: 0.0, speed_rad_s: 0.0, acceleration_rad_s2: 0.0, direction: 0.0 };
        Rope::ALL.iter().any(|rope| self.rope_tension(*rope, &still, &Extra::none(), 0.0).is_some())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Hoist, Linear, LinearKind, MechanismKind, gravity_m_s2};
    use quantities::unit::DEGREE;
    use quantities::{Angle, Force, Length, Mass, Measure, MomentOfInertia, Torque};

    fn with(kind: MechanismKind) -> Mechanism {
        Mechanism { kind, ..Mechanism::direct(MomentOfInertia::from_si(0.0), Torque::from_si(0.0)) }
    }

    fn out(acceleration: f64) -> Output {
        Output { position_rad: 0.0, speed_rad_s: 0.0, acceleration_rad_s2: acceleration, direction: 1.0 }
    }

    /// One fall on a drum of 300 mm: k = 0.15 m; S = m (g + a) + F_p, S_c = m_c (g − a).
    #[test]
    fn a_hoist_by_hand() {
        let hoist = with(MechanismKind::Hoist(Hoist {
            drum_diameter: Length::from_si(0.3),
            falls: 1,
            inertia: MomentOfInertia::from_si(0.05),
            mass: Mass::from_si(5.0),
            counterweight: Mass::from_si(2.0),
            rope_mass: Mass::from_si(0.0),
            hanging: Length::from_si(0.0),
            reeving: 1.0,
        }));
        let g = gravity_m_s2();
        for a in [-20.0, -9.0, 0.0, 9.0, 20.0] {
            let lifted = Extra { force: Force::from_si(-10.0), ..Extra::none() };
            let tension = |rope, extra: &Extra| hoist.rope_tension(rope, &out(a / 0.15), extra, 0.0).unwrap();
            assert!((tension(Rope::Load, &Extra::none()) - 5.0 * (g + a)).abs() < 1e-9);
            assert!((tension(Rope::Load, &lifted) - (5.0 * (g + a) - 10.0)).abs() < 1e-9);
            assert!((tension(Rope::Counterweight, &Extra::none()) - 2.0 * (g - a)).abs() < 1e-9);
        }
    }

    /// A counterweight is on the side to which the slide would fall: S = m_c (g |sin γ| − a sgn γ).
    #[test]
    fn a_counterweight_by_hand() {
        let slide = |inclination: f64, counterweight: f64| {
            with(MechanismKind::Linear(Linear {
                kind: LinearKind::Screw,
                travel_m_per_rad: 0.01,
                inertia: MomentOfInertia::from_si(0.0),
                mass: Mass::from_si(8.0),
                counterweight: Mass::from_si(counterweight),
                inclination: Angle::new_in(inclination, &DEGREE),
                friction_force: Force::from_si(0.0),
                friction_coefficient: 0.0,
            }))
        };
        let tension = |inclination: f64, a: f64| {
            slide(inclination, 3.0).rope_tension(Rope::Counterweight, &out(a / 0.01), &Extra::none(), 0.0)
        };
        let g = gravity_m_s2();
        assert!((tension(90.0, 12.0).unwrap() - 3.0 * (g - 12.0)).abs() < 1e-9);
        assert!((tension(-90.0, 12.0).unwrap() - 3.0 * (g + 12.0)).abs() < 1e-9);
        assert!((tension(30.0, 2.0).unwrap() - 3.0 * (0.5 * g - 2.0)).abs() < 1e-9);
        assert_eq!(tension(0.0, 12.0), None, "what lies level does not hang");
        assert!(!slide(90.0, 0.0).has_rope() && slide(90.0, 1.0).has_rope());
    }
}
