//! `[mechanism.conveyor]`: a conveyor or a roller; the equations are those of a [`crate::Linear`] drive.

use crate::drawing::{Drawing, Look};

pub(crate) fn drawing() -> Drawing {
    let mut drawing =
        Drawing::new().along_a_line().strand([60.0, 116.0], [320.0, 116.0], 24.0).face([60.0, 116.0], 22.0);
    for x in [125.0, 190.0, 255.0, 320.0] {
        drawing = drawing.circle(Look::Housing, [x, 116.0], 22.0);
    }
    drawing
        .rect(Look::Body, [96.0, 54.0], [46.0, 38.0])
        .rect(Look::Body, [174.0, 62.0], [40.0, 30.0])
        .rect(Look::Body, [246.0, 48.0], [44.0, 44.0])
        .arrow([150.0, 30.0], [230.0, 30.0])
        .arrow([346.0, 70.0], [296.0, 70.0])
        .line(Look::Thin, [38.0, 116.0], [38.0, 176.0])
        .line(Look::Thin, [82.0, 116.0], [82.0, 176.0])
        .dimension([38.0, 170.0], [82.0, 170.0])
        .ground([100.0, 150.0], 250.0)
        .calls("roller_diameter", "D", [70.0, 170.0], [118.0, 174.0])
        .calls("mass", "m", [120.0, 72.0], [82.0, 40.0])
        .calls("inertia", "J", [198.0, 122.0], [222.0, 172.0])
        .calls("friction_force", "F_R", [230.0, 92.0], [230.0, 64.0])
        .calls("friction_coefficient", "µ", [158.0, 92.0], [158.0, 64.0])
        .calls("process_force", "F", [336.0, 70.0], [358.0, 54.0])
        .calls("inclination", "γ", [344.0, 116.0], [366.0, 96.0])
        .calls("efficiency", "η", [290.0, 140.0], [306.0, 172.0])
        .calls("friction_torque", "T_L", [44.0, 102.0], [20.0, 70.0])
        .calls("viscous_friction", "d", [46.0, 128.0], [16.0, 150.0])
        .calls("external_torque", "T_x", [60.0, 94.0], [60.0, 48.0])
}
