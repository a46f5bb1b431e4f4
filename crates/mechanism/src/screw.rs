//! `[mechanism.screw]`: a screw with its slide; the equations are those of a [`crate::Linear`] drive.

use crate::drawing::{Drawing, Look, Step};

pub(crate) fn drawing() -> Drawing {
    Drawing::new()
        .along_a_line()
        .line(Look::Axis, [8.0, 102.0], [372.0, 102.0])
        .actuator([20.0, 102.0])
        .rect(Look::Housing, [98.0, 92.0], [14.0, 20.0])
        .spindle([112.0, 102.0], 238.0)
        .rect(Look::Housing, [350.0, 88.0], [12.0, 28.0])
        .rect(Look::Hole, [206.0, 86.0], [40.0, 32.0])
        .slide([184.0, 46.0])
        .ground([112.0, 140.0], 250.0)
        .line(Look::Line, [196.0, 118.0], [196.0, 140.0])
        .line(Look::Line, [256.0, 118.0], [256.0, 140.0])
        .arrow([196.0, 32.0], [258.0, 32.0])
        .arrow([322.0, 64.0], [274.0, 64.0])
        .dimension([130.0, 124.0], [158.0, 124.0])
        .calls("lead", "P", [144.0, 124.0], [144.0, 158.0])
        .calls("mass", "m", [234.0, 58.0], [284.0, 24.0])
        .calls("inertia", "J", [316.0, 102.0], [336.0, 130.0])
        .calls("friction_force", "F_R", [256.0, 138.0], [282.0, 162.0])
        .calls("friction_coefficient", "µ", [196.0, 138.0], [182.0, 164.0])
        .calls("process_force", "F", [312.0, 64.0], [344.0, 50.0])
        .calls("inclination", "γ", [12.0, 102.0], [14.0, 158.0])
        .calls("efficiency", "η", [212.0, 112.0], [230.0, 164.0])
        .calls("counterweight", "m_G", [190.0, 56.0], [156.0, 38.0])
        .calls("friction_torque", "T_L", [104.0, 92.0], [120.0, 62.0])
        .calls("viscous_friction", "d", [106.0, 112.0], [100.0, 160.0])
        .calls("external_torque", "T_x", [93.0, 78.0], [94.0, 34.0])
}

impl Drawing {
    /// A spindle from its left end along its axis.
    pub(crate) fn spindle(self, [x, y]: [f64; 2], length: f64) -> Self {
        let mut thread = Vec::new();
        let mut at = x + 4.0;
        while at + 6.0 < x + length {
            thread.extend([Step::Move([at, y - 6.0]), Step::Line([at + 4.0, y + 6.0])]);
            at += 7.0;
        }
        self.rect(Look::Hole, [x, y - 6.0], [length, 12.0]).path(Look::Thin, thread)
    }
}
