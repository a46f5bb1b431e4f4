//! Units of other papers against the figures of other hands: technical-metric and inch-pound torque constants, stiffnesses,
//! frictions, and single units of mass, length, power and energy.
//!
//! The figures are those that GNU Units 2.22 (`definitions.units` 3.15, September 2022) prints for one of the unit with
//! `units -t -o %.16g`, such as `units -t -o %.16g 'kgf m/arcmin' 'N m/radian'`. pint 0.25.3 (`default_en.txt`) differs from each
//! of them by less than 4·10⁻¹⁶ of the value. Neither shares a line with this crate or with `uom`.
#![allow(clippy::excessive_precision, reason = "figures as the other program printed them")]
#![allow(clippy::panic, reason = "a test may fail")]
#![allow(clippy::approx_constant, reason = "figures as another program prints them")]

use quantities::{Dimension, parse};

/// Dimension, spelling of project files, and one of the unit in SI.
const FIGURES: &[(Dimension, &str, f64)] = &[
    (Dimension::TorqueConstant, "mN m/A", 0.001),
    (Dimension::TorqueConstant, "N cm/A", 0.01),
    (Dimension::TorqueConstant, "lbf in/A", 0.112_984_829_027_616_7),
    (Dimension::TorqueConstant, "lbf ft/A", 1.355_817_948_331_401),
    (Dimension::TorqueConstant, "ozf in/A", 0.007_061_551_814_226_043),
    (Dimension::TorqueConstant, "kgf m/A", 9.806_649_999_999_999),
    (Dimension::TorqueConstant, "kgf cm/A", 0.098_066_5),
    (Dimension::VoltageConstant, "V/(1/min)", 9.549_296_585_513_721),
    (Dimension::VoltageConstant, "mV s/rad", 0.001),
    (Dimension::TorsionalStiffness, "N m/deg", 57.295_779_513_082_32),
    (Dimension::TorsionalStiffness, "N m/arcmin", 3_437.746_770_784_94),
    (Dimension::TorsionalStiffness, "lbf in/rad", 0.112_984_829_027_616_7),
    (Dimension::TorsionalStiffness, "lbf in/deg", 6.473_553_852_289_631),
    (Dimension::TorsionalStiffness, "lbf in/arcmin", 388.413_231_137_377_9),
    (Dimension::TorsionalStiffness, "lbf ft/rad", 1.355_817_948_331_401),
    (Dimension::TorsionalStiffness, "lbf ft/deg", 77.682_646_227_475_56),
    (Dimension::TorsionalStiffness, "lbf ft/arcmin", 4_660.958_773_648_535),
    (Dimension::TorsionalStiffness, "kgf m/rad", 9.806_649_999_999_999),
    (Dimension::TorsionalStiffness, "kgf m/deg", 561.879_656_161_968_7),
    (Dimension::TorsionalStiffness, "kgf m/arcmin", 33_712.779_369_718_13),
    (Dimension::TorsionalStiffness, "10^4 N m/rad", 10_000.0),
    (Dimension::TorsionalStiffness, "10^6 N m/rad", 1_000_000.0),
    (Dimension::TiltingStiffness, "N m/deg", 57.295_779_513_082_32),
    (Dimension::TiltingStiffness, "N m/arcmin", 3_437.746_770_784_94),
    (Dimension::TiltingStiffness, "lbf in/rad", 0.112_984_829_027_616_7),
    (Dimension::TiltingStiffness, "lbf in/deg", 6.473_553_852_289_631),
    (Dimension::TiltingStiffness, "lbf in/arcmin", 388.413_231_137_377_9),
    (Dimension::TiltingStiffness, "lbf ft/rad", 1.355_817_948_331_401),
    (Dimension::TiltingStiffness, "lbf ft/deg", 77.682_646_227_475_56),
    (Dimension::TiltingStiffness, "lbf ft/arcmin", 4_660.958_773_648_535),
    (Dimension::TiltingStiffness, "kgf m/rad", 9.806_649_999_999_999),
    (Dimension::TiltingStiffness, "kgf m/deg", 561.879_656_161_968_7),
    (Dimension::TiltingStiffness, "kgf m/arcmin", 33_712.779_369_718_13),
    (Dimension::TiltingStiffness, "10^4 N m/rad", 10_000.0),
    (Dimension::TiltingStiffness, "10^6 N m/rad", 1_000_000.0),
    (Dimension::ViscousFriction, "N m/krpm", 0.009_549_296_585_513_721),
    (Dimension::ViscousFriction, "mN m s/rad", 0.001),
    (Dimension::ViscousFriction, "mN m/krpm", 9.549_296_585_513_72e-6),
    (Dimension::ViscousFriction, "lbf in s/rad", 0.112_984_829_027_616_7),
    (Dimension::ViscousFriction, "lbf in/krpm", 0.001_078_925_642_048_272),
    (Dimension::ViscousFriction, "lbf ft s/rad", 1.355_817_948_331_401),
    (Dimension::ViscousFriction, "lbf ft/krpm", 0.012_947_107_704_579_26),
    (Dimension::ViscousFriction, "ozf in s/rad", 0.007_061_551_814_226_043),
    (Dimension::ViscousFriction, "ozf in/krpm", 6.743_285_262_801_699e-5),
    (Dimension::ViscousFriction, "kgf m s/rad", 9.806_649_999_999_999),
    (Dimension::ViscousFriction, "kgf m/krpm", 0.093_646_609_360_328_13),
    (Dimension::ViscousFriction, "kgf cm s/rad", 0.098_066_5),
    (Dimension::ViscousFriction, "kgf cm/krpm", 0.000_936_466_093_603_281_2),
    (Dimension::ViscousFriction, "N m s/deg", 57.295_779_513_082_32),
    (Dimension::ViscousFriction, "N m/(1/min)", 9.549_296_585_513_721),
    (Dimension::Mass, "slug", 14.593_902_937_206_37),
    (Dimension::Mass, "mg", 1.0e-6),
    (Dimension::Length, "mil", 2.54e-5),
    (Dimension::Power, "hp", 745.699_871_582_270_2),
    (Dimension::Power, "PS", 735.498_75),
    (Dimension::Energy, "kW h", 3_600_000.0),
    (Dimension::Energy, "mJ", 0.001),
    (Dimension::Velocity, "km/h", 0.277_777_777_777_777_8),
    (Dimension::Velocity, "cm/s", 0.01),
    (Dimension::Force, "daN", 10.0),
    (Dimension::Force, "gf", 0.009_806_65),
    (Dimension::Torque, "daN m", 10.0),
    (Dimension::Torque, "cN m", 0.01),
    (Dimension::Angle, "mdeg", 1.745_329_251_994_33e-5),
    (Dimension::Angle, "gon", 0.015_707_963_267_948_97),
    (Dimension::AngularVelocity, "mdeg/s", 1.745_329_251_994_33e-5),
    (Dimension::AngularVelocity, "arcmin/s", 2.908_882_086_657_216e-4),
    (Dimension::AngularVelocity, "arcsec/s", 4.848_136_811_095_36e-6),
    (Dimension::AngularVelocity, "krpm", 104.719_755_119_659_8),
    (Dimension::AngularAcceleration, "rpm/s", 0.104_719_755_119_659_8),
    (Dimension::AngularAcceleration, "krpm/s", 104.719_755_119_659_8),
    (Dimension::AngularAcceleration, "rev/s^2", 6.283_185_307_179_586),
    (Dimension::MomentOfInertia, "t m^2", 1_000.0),
    (Dimension::MomentOfInertia, "gf cm s^2", 9.806_65e-5),
    (Dimension::Acceleration, "cm/s^2", 0.01),
];

/// Further spellings of motor and gear sheets, each with the spelling of project files.
const OF_SHEETS: &[(Dimension, &str, &str)] = &[
    (Dimension::TorqueConstant, "oz-in/A", "ozf in/A"),
    (Dimension::TorqueConstant, "lb-in/A", "lbf in/A"),
    (Dimension::TorqueConstant, "lb-ft/A", "lbf ft/A"),
    (Dimension::TorqueConstant, "mNm/A", "mN m/A"),
    (Dimension::TorqueConstant, "Ncm/A", "N cm/A"),
    (Dimension::TorqueConstant, "kgf-cm/A", "kgf cm/A"),
    (Dimension::TorsionalStiffness, "Nm/deg", "N m/deg"),
    (Dimension::TorsionalStiffness, "Nm/arcmin", "N m/arcmin"),
    (Dimension::TorsionalStiffness, "lb-in/rad", "lbf in/rad"),
    (Dimension::TiltingStiffness, "kgf-m/arcmin", "kgf m/arcmin"),
    (Dimension::ViscousFriction, "Nm/krpm", "N m/krpm"),
    (Dimension::ViscousFriction, "oz-in/krpm", "ozf in/krpm"),
];

/// Largest relative deviation: the last printed digits of sixteen.
const PRINTED: f64 = 1e-15;

fn si(dimension: Dimension, spelling: &str) -> f64 {
    parse(dimension, &format!("1 {spelling}")).unwrap_or_else(|fault| panic!("{spelling}: {fault}")).si
}

#[test]
fn units_have_the_figures_of_gnu_units() {
    for (dimension, spelling, figure) in FIGURES {
        let found = si(*dimension, spelling);
        assert!((found / figure - 1.0).abs() <= PRINTED, "{spelling}: {found} is not {figure}");
    }
}

#[test]
fn spellings_of_sheets_are_these_units() {
    for (dimension, of_sheet, spelling) in OF_SHEETS {
        assert!(FIGURES.iter().any(|(other, text, _)| (other, text) == (dimension, spelling)), "{spelling}");
        assert_eq!(si(*dimension, of_sheet).to_bits(), si(*dimension, spelling).to_bits(), "{of_sheet}");
    }
}
