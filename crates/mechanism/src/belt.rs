//! `[mechanism.belt]`: a belt or a rack with a slide; the equations are those of a [`crate::Linear`] drive.

use crate::drawing::{Drawing, Look, Step};

pub(crate) fn drawing() -> Drawing {
    Drawing::new()
        .along_a_line()
        .line(Look::Axis, [40.0, 112.0], [350.0, 112.0])
        .strand([84.0, 112.0], [306.0, 112.0], 32.0)
        .face([84.0, 112.0], 30.0)
        .circle(Look::Housing, [306.0, 112.0], 30.0)
        .circle(Look::Hole, [306.0, 112.0], 7.0)
        .rect(Look::Hole, [180.0, 76.0], [34.0, 10.0])
        .slide([155.0, 40.0])
        .arrow([166.0, 24.0], [228.0, 24.0])
        .arrow([288.0, 58.0], [244.0, 58.0])
        .line(Look::Thin, [54.0, 112.0], [54.0, 178.0])
        .line(Look::Thin, [114.0, 112.0], [114.0, 178.0])
        .dimension([54.0, 172.0], [114.0, 172.0])
        .calls("pulley_diameter", "D", [100.0, 172.0], [146.0, 170.0])
        .calls("mass", "m", [206.0, 50.0], [258.0, 22.0])
        .calls("inertia", "J", [318.0, 124.0], [352.0, 156.0])
        .calls("friction_force", "F_R", [214.0, 82.0], [246.0, 104.0])
        .calls("friction_coefficient", "µ", [182.0, 84.0], [164.0, 108.0])
        .calls("process_force", "F", [282.0, 58.0], [316.0, 46.0])
        .calls("inclination", "γ", [44.0, 112.0], [16.0, 92.0])
        .calls("efficiency", "η", [190.0, 144.0], [210.0, 168.0])
        .calls("counterweight", "m_G", [160.0, 52.0], [124.0, 36.0])
        .calls("friction_torque", "T_L", [66.0, 92.0], [36.0, 56.0])
        .calls("viscous_friction", "d", [60.0, 128.0], [22.0, 150.0])
        .calls("external_torque", "T_x", [84.0, 82.0], [84.0, 40.0])
}

impl Drawing {
    /// A belt about two wheels on one level.
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
