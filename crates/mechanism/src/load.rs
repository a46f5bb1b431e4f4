//! `[load]`: a load at the output, given by its inertia; the equations are those of a [`crate::Rotor`].

use crate::drawing::{Drawing, Look, MechanismValues};

pub(crate) fn drawing(figures: &MechanismValues) -> Drawing {
    let (start, middle) = (figures.start_rad(), [269.0, 95.0]);
    Drawing::new()
        .line(Look::Axis, [10.0, 95.0], [150.0, 95.0])
        .actuator([28.0, 95.0])
        .rect(Look::Body, [106.0, 30.0], [20.0, 130.0])
        .turns(start, middle, 1.0, |it| {
            it.circle(Look::Body, middle, 62.0).circle(Look::Hole, middle, 14.0).holes(middle, 46.0, 5.0).calls(
                "inertia",
                "J_L",
                [312.0, 118.0],
                [352.0, 150.0],
            )
        })
        .line(Look::Axis, [186.0, 95.0], [352.0, 95.0])
        .line(Look::Axis, [269.0, 14.0], [269.0, 176.0])
        .turning([300.0, 48.0], 56.5, false, [223.0, 62.0])
        .calls("friction_torque", "T_L", [101.0, 118.0], [156.0, 152.0])
        .calls("viscous_friction", "d", [101.0, 72.0], [150.0, 40.0])
        .calls("external_torque", "T_x", [262.0, 38.8], [214.0, 20.0])
}
