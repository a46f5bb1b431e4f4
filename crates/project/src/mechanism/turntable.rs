//! A turntable or drum of solid bodies.

use super::parts::{Friction, Losses};
use super::MechanismName;
use crate::KeyDefault;
use crate::about::About;
use crate::bodies::BodySection;
use crate::section::section;
use crate::value::{BodyLines, Tables};
use quantities::{Angle, Length};

section! {
    /// Solid bodies that turn with the output.
    Turntable, TurntableName of About::Mechanism, MechanismName::Turntable {
        body: Tables<BodySection>;
        bodies: BodyLines;
        axis_tilt: Angle => noted(KeyDefault::AxisVertical);
        start_angle: Angle;
        payload_distance: Length => not_negative;
        ..friction: Friction;
        ..losses: Losses;
    }
}
