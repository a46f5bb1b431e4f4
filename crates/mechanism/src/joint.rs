//! A joint whose torque is recorded together with its motion.

use crate::drawing::{Drawing, Look, MechanismValues, Step};
use crate::equations::{Equations, Reduced};
use crate::flange::OnFlange;
use crate::{Endless, Extra, MechanismId};
use quantities::{Measure, MomentOfInertia, Torque};

/// A robot joint whose torque is known at every instant from inverse dynamics or measurement, including inertia,
/// gravity and friction of the arm.
///
/// # Valid
/// inertia and holding torque are used only by checks other than the recorded torque: inertia ratio, natural frequency
/// and brake
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint {
    /// Largest inertia at the joint.
    pub inertia: Option<MomentOfInertia>,
    /// Largest torque that holds the arm at rest.
    pub holding_torque: Option<Torque>,
}

impl Equations for Joint {
    fn id(&self) -> MechanismId {
        MechanismId::Joint
    }

    fn reduced(&self, _position_rad: f64, extra: &Extra) -> Reduced {
        Reduced { inertia: 0.0, slope: 0.0, holding: extra.torque.si(), coulomb: 0.0 }
    }

    fn known_inertia(&self, _reduced: &Reduced) -> Option<f64> {
        self.inertia.map(Measure::si)
    }

    fn holding(&self, _reduced: &Reduced, _external_nm: f64) -> f64 {
        self.holding_torque.map_or(0.0, Measure::si)
    }

    /// The recorded torque does not scale with the masses.
    fn with_masses(&self, _factor: f64) -> Self {
        *self
    }

    fn smooth_over(&self, _from_rad: f64, _to_rad: f64) -> Option<f64> {
        None
    }

    fn endless(&self) -> Endless {
        Endless::Never
    }

    /// The recorded torque includes all inertia.
    fn on_flange(&self) -> Option<OnFlange> {
        None
    }
}

pub(crate) fn drawing(figures: &MechanismValues) -> Drawing {
    let (start, axis) = (figures.start_rad(), [106.0, 110.0]);
    let gripper = [
        Step::Move([320.0, 95.0]),
        Step::Line([330.0, 99.0]),
        Step::Line([342.0, 90.0]),
        Step::Move([330.0, 99.0]),
        Step::Line([332.0, 114.0]),
    ];
    Drawing::new()
        .ground([50.0, 170.0], 110.0)
        .outline(Look::Housing, &[[82.0, 170.0], [90.0, 126.0], [122.0, 126.0], [130.0, 170.0]])
        .turns(start, axis, 1.0, |it| {
            it.bar(axis, [229.0, 56.0], 15.0)
                .bar([229.0, 56.0], [314.0, 92.0], 9.0)
                .face([229.0, 56.0], 16.0)
                .path(Look::Line, gripper)
                .calls("inertia", "J", [176.0, 78.0], [172.0, 30.0])
        })
        .face(axis, 34.0)
        .turning([112.0, 66.0], 44.0, false, [66.0, 92.0])
        .calls("holding_torque", "T_H", [74.0, 80.0], [40.0, 50.0])
}
