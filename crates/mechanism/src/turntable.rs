//! `[mechanism.turntable]`: bodies on a turning plate; the equations are those of a [`crate::Rotor`].

use crate::drawing::{Drawing, GroupAngles, Look, MechanismValues, Placement, Step};

pub(crate) fn drawing(figures: &MechanismValues) -> Drawing {
    let start = figures.start_rad();
    // Seen from the side, a body on the plate moves to and fro with the cosine of the angle.
    let body = |it: Drawing, [x, y]: [f64; 2], [w, h]: [f64; 2]| {
        let radius = x + 0.5 * w - 190.0;
        it.moves(
            &GroupAngles::round(start),
            [190.0, 96.0],
            |angle| Placement::shifted([radius * ((angle - start).cos() - 1.0), 0.0]),
            |it| {
                let it = it.rect(Look::Body, [x, y], [w, h]);
                if radius < 0.0 {
                    it.calls("bodies", "J", [113.0, 66.0], [62.0, 40.0])
                } else {
                    it.calls("start_angle", "φ_0", [284.0, 62.0], [334.0, 54.0])
                }
            },
        )
    };
    let mut drawing = Drawing::new()
        .leaning(-figures.of("axis_tilt").unwrap_or(0.0))
        .line(Look::Axis, [190.0, 10.0], [190.0, 178.0])
        .rect(Look::Housing, [160.0, 104.0], [60.0, 56.0])
        .rect(Look::Housing, [150.0, 96.0], [80.0, 9.0])
        .rect(Look::Body, [84.0, 80.0], [212.0, 16.0]);
    drawing = body(drawing, [96.0, 52.0], [34.0, 28.0]);
    drawing = body(drawing, [254.0, 44.0], [30.0, 36.0]);
    drawing
        .rect(Look::Body, [172.0, 64.0], [36.0, 16.0])
        .path(Look::Arrow, [Step::Move([160.0, 30.0]), Step::Curve([166.0, 42.0], [214.0, 42.0], [222.0, 29.0])])
        .ground([120.0, 160.0], 140.0)
        .line(Look::Thin, [269.0, 98.0], [269.0, 182.0])
        .dimension([190.0, 176.0], [269.0, 176.0])
        .calls("payload_distance", "r_p", [250.0, 176.0], [312.0, 168.0])
        .calls("friction_torque", "T_L", [155.0, 100.0], [92.0, 128.0])
        .calls("viscous_friction", "d", [160.0, 130.0], [92.0, 156.0])
        .calls("external_torque", "T_x", [221.0, 32.0], [264.0, 18.0])
        .calls("axis_tilt", "β", [190.0, 14.0], [146.0, 14.0])
}
