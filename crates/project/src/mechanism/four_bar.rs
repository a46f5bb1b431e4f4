//! Crank, coupler and rocker.

use super::parts::{Friction, Losses, StartAngle};
use super::MechanismName;
use crate::KeyDefault;
use crate::about::About;
use crate::section::section;
use quantities::{Angle, Length, Mass, MomentOfInertia, Torque};

section! {
    /// A four-bar linkage with a rotating crank.
    FourBar, FourBarName of About::Mechanism, MechanismName::FourBar {
        ground: Length => positive, needed, example("400 mm");
        crank: Length => positive, needed, example("100 mm");
        coupler: Length => positive, needed, example("350 mm");
        rocker: Length => positive, needed, example("250 mm");
        crossed: bool;
        inertia: MomentOfInertia => not_negative, noted(KeyDefault::PartsWithoutInertia);
        coupler_mass: Mass => not_negative, noted(KeyDefault::CouplerWeightless);
        coupler_centre: Length => not_negative, example("175 mm");
        coupler_inertia: MomentOfInertia => not_negative;
        rocker_mass: Mass => not_negative, noted(KeyDefault::RockerWeightless);
        rocker_centre: Length => not_negative, example("125 mm");
        rocker_inertia: MomentOfInertia => not_negative;
        rocker_torque: Torque;
        axis_tilt: Angle => noted(KeyDefault::AxisLevel);
        inclination: Angle => noted(KeyDefault::GroundHorizontal);
        ..start: StartAngle;
        ..friction: Friction;
        ..losses: Losses;
    }
}
