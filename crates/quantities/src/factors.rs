//! Definitions from which the factors of the units follow.

use uom::si::{angle, angular_velocity, time};

/// One pound, 0.45359237 kg exactly (international yard and pound agreement of 1959).
pub(crate) const POUND_KG: f64 = 0.453_592_37;
/// One inch, 25.4 mm exactly (the same).
pub(crate) const INCH_M: f64 = 0.0254;
/// One foot, twelve inches.
pub(crate) const FOOT_M: f64 = 12.0 * INCH_M;
/// Ounces per pound.
pub(crate) const OUNCES: f64 = 16.0;
/// One pound-force, a pound under standard gravity, 9.80665 m/s² (CGPM 1901). `uom` rounds it to seven digits.
pub(crate) const POUND_FORCE_N: f64 = POUND_KG * STANDARD_GRAVITY_M_S2;
/// Standard gravity, 9.80665 m/s² exactly (CGPM 1901): one kilogram-force in newtons.
pub(crate) const STANDARD_GRAVITY_M_S2: f64 = 9.806_65;

/// Inertia per GD²: GD² has the diameter of gyration, J its radius; a weight in kgf has as many kg.
pub(crate) const FLYWHEEL_EFFECT: f64 = 0.25;
/// One mechanical horsepower, 550 ft lbf/s.
pub(crate) const HORSEPOWER_W: f64 = 550.0 * FOOT_M * POUND_FORCE_N;
/// One metric horsepower, 75 kgf m/s (Pferdestärke, DIN 66036).
pub(crate) const PFERDESTAERKE_W: f64 = 75.0 * STANDARD_GRAVITY_M_S2;

/// One revolution per minute, 2π/60 rad/s, as in `uom`.
pub(crate) fn per_minute() -> f64 {
    uom::si::f64::AngularVelocity::new::<angular_velocity::revolution_per_minute>(1.0).value
}

/// One minute of arc, π/10800 rad, as in `uom`.
pub(crate) fn arcminute() -> f64 {
    uom::si::f64::Angle::new::<angle::minute>(1.0).value
}

/// One degree, π/180 rad, as in `uom`.
pub(crate) fn degree() -> f64 {
    uom::si::f64::Angle::new::<angle::degree>(1.0).value
}

/// One day, as in `uom`.
pub(crate) fn day() -> f64 {
    uom::si::f64::Time::new::<time::day>(1.0).value
}
