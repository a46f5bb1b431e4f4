//! `[mechanism.belt]`: a belt or a rack with a slide; the equations are those of a [`crate::Linear`] drive.

use crate::drawing::{Drawing, GroupAngles, Look, MechanismValues, Placement, Step};

pub(crate) fn drawing(figures: &MechanismValues) -> Drawing {
    let start = figures.start_rad();
    let radius = figures.length("pulley_diameter").map_or(0.03, |diameter| 0.5 * diameter);
    let (scale, x) = figures.along(radius, 30.0 / radius, [88.0, 218.0], 155.0);
    let wheel = (radius * scale).clamp(13.0, 30.0);
    // The belt and the slide on it adapt to the size of the pulleys.
    let (top, low) = (110.0 - wheel, 114.0 + wheel);
    let turning = |it: Drawing, at: [f64; 2]| it.turns(start, at, -1.0, |it| it.holes(at, 0.66 * wheel, 0.11 * wheel));
    let mut drawing = Drawing::new()
        .along_a_line(figures)
        .line(Look::Axis, [40.0, 112.0], [350.0, 112.0])
        .strand([84.0, 112.0], [306.0, 112.0], wheel + 2.0)
        .face([84.0, 112.0], wheel)
        .circle(Look::Housing, [306.0, 112.0], wheel)
        .circle(Look::Hole, [306.0, 112.0], 0.24 * wheel);
    drawing = turning(drawing, [84.0, 112.0]);
    drawing = turning(drawing, [306.0, 112.0]);
    drawing
        .moves(
            &GroupAngles::even(start),
            [x, 112.0],
            |angle| Placement::shifted([radius * scale * (angle - start), 0.0]),
            |it| {
                it.rect(Look::Hole, [x + 25.0, top - 4.0], [34.0, 10.0])
                    .slide([x, top - 40.0])
                    .arrow([x + 11.0, top - 56.0], [x + 73.0, top - 56.0])
                    .arrow([x + 133.0, top - 22.0], [x + 89.0, top - 22.0])
                    .calls("mass", "m", [x + 51.0, top - 30.0], [x + 103.0, top - 58.0])
                    .calls("friction_force", "F_R", [x + 59.0, top + 2.0], [x + 81.0, top + 24.0])
                    .calls("friction_coefficient", "µ", [x + 27.0, top + 4.0], [x + 9.0, top + 28.0])
                    .calls("process_force", "F", [x + 127.0, top - 22.0], [x + 140.0, top - 40.0])
                    .calls("counterweight", "m_G", [x + 5.0, top - 28.0], [x - 31.0, top - 44.0])
            },
        )
        .line(Look::Thin, [84.0 - wheel, 112.0], [84.0 - wheel, 178.0])
        .line(Look::Thin, [84.0 + wheel, 112.0], [84.0 + wheel, 178.0])
        .dimension([84.0 - wheel, 172.0], [84.0 + wheel, 172.0])
        .calls("pulley_diameter", "D", [84.0 + 0.5 * wheel, 172.0], [146.0, 170.0])
        .calls("inertia", "J", [318.0, 124.0], [352.0, 156.0])
        .calls("inclination", "γ", [44.0, 112.0], [16.0, 92.0])
        .calls("efficiency", "η", [190.0, low], [210.0, low + 24.0])
        .calls("friction_torque", "T_L", [84.0 - 0.6 * wheel, 112.0 - 0.67 * wheel], [36.0, 56.0])
        .calls("viscous_friction", "d", [84.0 - 0.8 * wheel, 112.0 + 0.53 * wheel], [22.0, 150.0])
        .calls("external_torque", "T_x", [84.0, 112.0 - wheel], [66.0, 34.0])
}

impl Drawing {
    /// Adds a belt around two pulleys at the same height.
    pub(crate) fn strand(self, [ax, ay]: [f64; 2], [bx, by]: [f64; 2], radius: f64) -> Self {
        let steps = [
            Step::Move([ax, ay - radius]),
            Step::Line([bx, by - radius]),
            Step::Arc(radius, true, [bx, by + radius]),
            Step::Line([ax, ay + radius]),
            Step::Arc(radius, true, [ax, ay - radius]),
            Step::Close,
        ];
        self.path(Look::Line, steps)
    }
}
