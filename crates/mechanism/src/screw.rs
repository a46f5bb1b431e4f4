//! `[mechanism.screw]`: a screw with its slide; the equations are those of a [`crate::Linear`] drive.

use crate::drawing::{Drawing, GroupAngles, Look, MechanismValues, Placement, Step};
use std::f64::consts::TAU;

/// Scale at which a lead of 10 mm is drawn if the motion fits [sheet/m].
const SCALE: f64 = 1600.0;

pub(crate) fn drawing(figures: &MechanismValues) -> Drawing {
    let start = figures.start_rad();
    let lead = figures.length("lead").unwrap_or(0.01);
    let (scale, x) = figures.along(lead / TAU, SCALE, [136.0, 262.0], 184.0);
    Drawing::new()
        .along_a_line(figures)
        .line(Look::Axis, [8.0, 102.0], [372.0, 102.0])
        .actuator([20.0, 102.0])
        .spindle([112.0, 102.0], 238.0, lead * scale, start)
        .rect(Look::Housing, [98.0, 92.0], [14.0, 20.0])
        .rect(Look::Housing, [350.0, 88.0], [12.0, 28.0])
        .ground([112.0, 140.0], 250.0)
        .moves(
            &GroupAngles::even(start),
            [x, 102.0],
            |angle| Placement::shifted([lead / TAU * scale * (angle - start), 0.0]),
            |it| {
                it.rect(Look::Hole, [x + 22.0, 86.0], [40.0, 32.0])
                    .slide([x, 46.0])
                    .line(Look::Line, [x + 12.0, 118.0], [x + 12.0, 140.0])
                    .line(Look::Line, [x + 72.0, 118.0], [x + 72.0, 140.0])
                    .arrow([x + 12.0, 32.0], [x + 74.0, 32.0])
                    .arrow([x + 138.0, 64.0], [x + 90.0, 64.0])
                    .calls("mass", "m", [x + 50.0, 58.0], [x + 100.0, 24.0])
                    .calls("friction_force", "F_R", [x + 72.0, 138.0], [x + 98.0, 162.0])
                    .calls("friction_coefficient", "µ", [x + 12.0, 138.0], [x - 2.0, 164.0])
                    .calls("process_force", "F", [x + 128.0, 64.0], [x + 130.0, 48.0])
                    .calls("efficiency", "η", [x + 28.0, 112.0], [x + 46.0, 164.0])
                    .calls("counterweight", "m_G", [x + 6.0, 56.0], [x - 28.0, 38.0])
            },
        )
        .calls("inertia", "J", [340.0, 102.0], [336.0, 158.0])
        .calls("inclination", "γ", [358.0, 140.0], [374.0, 160.0])
        .calls("friction_torque", "T_L", [104.0, 92.0], [106.0, 62.0])
        .calls("viscous_friction", "d", [106.0, 112.0], [100.0, 164.0])
        .calls("external_torque", "T_x", [93.0, 78.0], [76.0, 34.0])
}

impl Drawing {
    /// Adds a spindle from its left end along its axis, with its lead; the thread moves to the right as it turns.
    pub(crate) fn spindle(self, [x, y]: [f64; 2], length: f64, pitch: f64, start_rad: f64) -> Self {
        let pitch = pitch.clamp(16.0, 32.0);
        let mut thread = Vec::new();
        let mut at = x - pitch + 4.0;
        while at + 6.0 < x + length {
            thread.extend([Step::Move([at, y - 6.0]), Step::Line([at + 4.0, y + 6.0])]);
            at += pitch;
        }
        // Hides the thread in front of the left end, which enters with the next turn.
        let hidden = [Step::Move([x, y - 6.0]), Step::Line([x, y + 6.0])];
        self.rect(Look::Hole, [x, y - 6.0], [length, 12.0])
            .moves(
                &GroupAngles::anew(start_rad, TAU),
                [x, y],
                |angle| Placement::shifted([pitch * (angle - start_rad) / TAU, 0.0]),
                |it| it.path(Look::Thin, thread).calls("lead", "P", [x + 32.0, y + 14.0], [x + 32.0, y + 60.0]),
            )
            .path(Look::Line, hidden)
            .dimension([x + 18.0, y + 18.0], [x + 18.0 + pitch, y + 18.0])
    }
}
