//! Loads on the output flange: stated ones, and those that follow from the mechanism.

use crate::KeyDefault;
use crate::about::About;
use crate::choices::OperatingCondition;
use crate::section::section;
use crate::value::choices;
use quantities::{Angle, Force, Length, Mass};

section! {
    /// Loads on the output flange.
    FlangeLoads, FlangeLoadsName of About::FlangeLoads {
        radial_force: Force => not_negative;
        radial_distance: Length => not_negative;
        axial_force: Force => not_negative;
        axial_distance: Length => not_negative;
    }
}

section! {
    /// Loads on the output flange, and the way in which the mechanism loads it.
    Bearing, BearingName of About::Bearing {
        ..loads: FlangeLoads;
        load_factor: f64 => within(1.0, 3.0), example("1.2");
        operating_condition: OperatingCondition;
        mechanism: Derived;
        overhang: Length;
        payload_overhang: Length;
        flange_share: f64 => within(0.0, 1.0), example("0.5"), noted(KeyDefault::FlangeBearsAll);
        belt_tension: Force => not_negative;
        pressure_angle: Angle => positive, example("20 deg");
        helix_angle: Angle => not_negative, example("15 deg"), noted(KeyDefault::SpurTeeth);
        wheel_mass: Mass => not_negative, example("1.2 kg"), noted(KeyDefault::WheelWeightless);
        axis_tilt: Angle => noted(KeyDefault::AxisLevel);
    }
}

/// Use of the loads of the mechanism in addition to the stated ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Derived {
    /// They are added.
    Add,
    /// The loads of a segment replace them there.
    Replace,
    /// They are ignored.
    Ignore,
}

choices! {
    Derived { Add = "add", Replace = "replace", Ignore = "ignore" }
}
