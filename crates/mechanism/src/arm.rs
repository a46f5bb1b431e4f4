//! `[mechanism.arm]`: an unbalanced arm; the equations are those of a [`crate::Rotor`].

use crate::drawing::{Drawing, GroupAngles, Look, MechanismValues, Placement, polar};
use std::f64::consts::FRAC_PI_2;

/// The longer of both distances on the sheet.
const REACH: f64 = 215.0;

/// Angle of the drawn arm if no angle is stated \[rad\].
const NEUTRAL_RAD: f64 = 0.27;

pub(crate) fn drawing(figures: &MechanismValues) -> Drawing {
    let axis = [92.0, 112.0];
    let start = figures.start_rad();
    let lean = figures.of("start_angle").unwrap_or(NEUTRAL_RAD);
    let [centre, payload] = distances(figures);
    let along = |distance: f64, aside: f64| polar(polar(axis, distance, lean), aside, lean + FRAC_PI_2);
    let end = centre.max(payload) + 8.0;
    let half = |distance: f64| 18.0 - 9.0 * distance / end;
    let weight = along(centre, 0.0);
    // The weight has no effect about a vertical axis.
    let share = figures.of("axis_tilt").map_or(1.0, |tilt| tilt.sin().abs());
    let mut drawing =
        Drawing::new().line(Look::Axis, [40.0, 112.0], [230.0, 112.0]).face(axis, 38.0).turns(start, axis, 1.0, |it| {
            it.outline(
                Look::Body,
                &[along(-6.0, 18.0), along(end, half(end)), along(end, -half(end)), along(-6.0, -18.0)],
            )
            .leaning_rect(Look::Body, along(payload, 0.0), [26.0, 28.0], lean)
            .circle(Look::Hole, axis, 8.0)
            .centre(weight)
            .line(Look::Thin, along(0.0, 0.0), along(0.0, -72.0))
            .line(Look::Thin, along(centre, -10.0), along(centre, -52.0))
            .line(Look::Thin, along(payload, -16.0), along(payload, -72.0))
            .dimension(along(0.0, -48.0), along(centre, -48.0))
            .dimension(along(0.0, -68.0), along(payload, -68.0))
            .calls("inertia", "J", along(64.0, 10.0), along(64.0, 46.0))
            .calls("mass", "m", along(centre, 4.0), along(centre, 46.0))
            .calls("centre_distance", "s", along(0.4 * centre, -48.0), along(0.4 * centre, -36.0))
            .calls("payload_distance", "r_p", along(0.8 * payload, -68.0), along(0.8 * payload, -52.0))
        });
    if share > 0.05 {
        // The weight moves with the centre of mass and always points downwards.
        drawing = drawing.moves(
            &GroupAngles::round(start),
            weight,
            |angle| {
                let [x, y] = polar(axis, centre, lean + angle - start);
                Placement::shifted([x - weight[0], y - weight[1]])
            },
            |it| it.arrow([weight[0], weight[1] + 10.0], [weight[0], weight[1] + 12.0 + 30.0 * share]),
        );
    }
    if lean.abs() > 0.05 {
        drawing = drawing.sweep(Look::Arrow, axis, 56.0, [0.0, lean]);
    }
    drawing
        .calls("start_angle", "φ_0", polar(axis, 56.0, 0.5 * lean), polar(axis, 82.0, 0.5 * lean - 0.24))
        .calls("friction_torque", "T_L", [66.0, 86.0], [34.0, 52.0])
        .calls("viscous_friction", "d", [62.0, 134.0], [26.0, 152.0])
        .calls("external_torque", "T_x", [86.0, 75.0], [64.0, 30.0])
        .calls("axis_tilt", "β", [64.0, 112.0], [24.0, 100.0])
}

/// Returns the distances of centre of mass and payload on the sheet, to scale.
fn distances(figures: &MechanismValues) -> [f64; 2] {
    let (centre, payload) = (figures.of("centre_distance"), figures.length("payload_distance"));
    let longest = centre.unwrap_or(0.0).max(payload.unwrap_or(0.0));
    let on_sheet = |metres: f64| (REACH * metres / longest).max(0.0);
    match (centre, payload) {
        (Some(centre), Some(payload)) if longest > 0.0 => [on_sheet(centre), on_sheet(payload).max(52.0)],
        _ => [0.53 * REACH, REACH],
    }
}
