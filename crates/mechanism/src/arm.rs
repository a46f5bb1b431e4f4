//! `[mechanism.arm]`: an unbalanced arm; the equations are those of a [`crate::Rotor`].

use crate::drawing::{Drawing, Look};

pub(crate) fn drawing() -> Drawing {
    Drawing::new()
        .line(Look::Axis, [60.0, 112.0], [340.0, 112.0])
        .face([92.0, 112.0], 38.0)
        .outline(Look::Body, &[[86.0, 94.0], [300.0, 44.0], [305.0, 61.0], [98.0, 130.0]])
        .centre([206.0, 82.0])
        .rect(Look::Body, [294.0, 38.0], [26.0, 28.0])
        .arrow([206.0, 96.0], [206.0, 130.0])
        .turning([156.0, 112.0], 64.0, false, [153.6, 94.0])
        .line(Look::Thin, [92.0, 112.0], [92.0, 184.0])
        .line(Look::Thin, [206.0, 134.0], [206.0, 164.0])
        .line(Look::Thin, [307.0, 66.0], [307.0, 184.0])
        .dimension([92.0, 160.0], [206.0, 160.0])
        .dimension([92.0, 180.0], [307.0, 180.0])
        .calls("inertia", "J", [156.0, 88.0], [146.0, 48.0])
        .calls("mass", "m", [206.0, 76.0], [206.0, 34.0])
        .calls("centre_distance", "s", [132.0, 160.0], [132.0, 146.0])
        .calls("payload_distance", "r_p", [262.0, 180.0], [262.0, 162.0])
        .calls("start_angle", "φ_0", [156.0, 104.0], [182.0, 128.0])
        .calls("friction_torque", "T_L", [66.0, 86.0], [34.0, 52.0])
        .calls("viscous_friction", "d", [62.0, 134.0], [26.0, 152.0])
        .calls("external_torque", "T_x", [100.0, 76.0], [92.0, 40.0])
        .calls("axis_tilt", "β", [64.0, 112.0], [24.0, 100.0])
}
