//! `[mechanism.conveyor]`: a conveyor or a roller; the equations are those of a [`crate::Linear`] drive.

use crate::drawing::{Drawing, GroupAngles, Look, MechanismValues, Placement};

pub(crate) fn drawing(figures: &MechanismValues) -> Drawing {
    let (start, roller, apart) = (figures.start_rad(), 22.0, 75.0);
    let rollers = [60.0, 125.0, 190.0, 255.0, 320.0];
    let mut drawing =
        Drawing::new().along_a_line(figures).strand([60.0, 116.0], [320.0, 116.0], 24.0).face([60.0, 116.0], roller);
    for x in rollers.into_iter().skip(1) {
        drawing = drawing.circle(Look::Housing, [x, 116.0], roller);
    }
    for x in rollers {
        drawing = drawing.turns(start, [x, 116.0], -1.0, |it| it.holes([x, 116.0], 0.66 * roller, 2.4));
    }
    drawing
        .moves(
            &GroupAngles::anew(start, apart / roller),
            [60.0, 92.0],
            |angle| Placement::shifted([roller * (angle - start), 0.0]),
            |it| {
                [64.0, 64.0 + apart, 64.0 + 2.0 * apart]
                    .into_iter()
                    .fold(it, |it, x| it.rect(Look::Body, [x, 56.0], [42.0, 36.0]))
                    .calls("mass", "m", [92.0, 72.0], [70.0, 36.0])
            },
        )
        .arrow([150.0, 30.0], [230.0, 30.0])
        .arrow([362.0, 70.0], [320.0, 70.0])
        .line(Look::Thin, [38.0, 116.0], [38.0, 176.0])
        .line(Look::Thin, [82.0, 116.0], [82.0, 176.0])
        .dimension([38.0, 170.0], [82.0, 170.0])
        .ground([100.0, 150.0], 250.0)
        .calls("roller_diameter", "D", [70.0, 170.0], [118.0, 174.0])
        .calls("inertia", "J", [198.0, 122.0], [222.0, 172.0])
        .calls("friction_force", "F_R", [270.0, 92.0], [282.0, 42.0])
        .calls("friction_coefficient", "µ", [122.0, 92.0], [122.0, 44.0])
        .calls("process_force", "F", [350.0, 70.0], [358.0, 52.0])
        .calls("inclination", "γ", [344.0, 116.0], [366.0, 96.0])
        .calls("efficiency", "η", [290.0, 140.0], [306.0, 172.0])
        .calls("friction_torque", "T_L", [44.0, 102.0], [20.0, 70.0])
        .calls("viscous_friction", "d", [46.0, 128.0], [16.0, 150.0])
        .calls("external_torque", "T_x", [50.0, 96.0], [36.0, 46.0])
}
