//! Requirements on the actuator.

use crate::KeyDefault;
use crate::about::About;
use crate::choices::{LeftOut, MainsPhases, MountingPosition, ProtectionDegree, SpecialApplication};
use crate::section::section;
use crate::value::{Choices, Texts, WordChoice, choice, choices};
use order_code::{Feedback, Option1, Option2, Series};
use quantities::{
    Acceleration, Angle, EffectiveVoltage, ElectricCurrent, ElectricPotential, Frequency, Length, Mass, Power,
    ThermodynamicTemperature, Time, Torque,
};

/// Default deviation of the mains voltage as a share of the nominal one (IEC 60038: ± 10 %).
const MAINS_DEVIATION: f64 = 0.1;

/// Default share of U_DC/√2 that a drive can use, with room for dead times and current control.
const MODULATION_RESERVE: f64 = 0.9;

section! {
    /// Requirements on the actuator.
    RequirementsSection, RequirementsName of About::Requirements {
        feedback: Choices<Feedback>;
        brake: bool;
        hollow_shaft_min: Length => not_negative, example("18 mm");
        length_max: Length => positive, example("200 mm");
        mass_max: Mass => positive, example("10 kg");
        makers: Texts => example("Example Drives");
        price_max: String => example("1500 EUR");
        lead_time_max: Time => positive, example("60 d");
        supply: ElectricPotential => positive, noted(KeyDefault::NoSupply);
        mains: EffectiveVoltage => positive;
        mains_phases: MainsPhases;
        mains_deviation: f64 = MAINS_DEVIATION => within(0.0, 0.5), example("0.1");
        modulation_reserve: f64 = MODULATION_RESERVE => within(0.5, 1.0), example("0.9"), noted(KeyDefault::ModulationReserve);
        ambient: ThermodynamicTemperature => noted(KeyDefault::AmbientWithinRange);
        altitude: Length => example("800 m");
        altitude_derating: f64 => within(0.1, 1.0), example("0.9");
        protection: ProtectionDegree;
        humidity_min: f64 => within(0.0, 1.0), example("0.3");
        humidity_max: f64 => within(0.0, 1.0), example("0.75");
        vibration: Acceleration => not_negative, example("2 g");
        shock: Acceleration => not_negative, example("15 g");
        mounting: MountingPosition;
        bearing_life_min: Time => positive, example("20000 h");
        gear_life_min: Time => positive, example("20000 h");
        torsion_max: Angle => positive, example("2 arcmin");
        natural_frequency_min: Frequency => positive, example("25 Hz");
        tilt_angle_max: Angle => positive, example("2 arcmin");
        angle_error_max: Angle => positive, example("2 arcmin");
        lever_arm: Length => positive, example("500 mm");
        deviation_max: Length => positive, example("0.2 mm");
        resolution_max: Angle => positive, example("5 arcsec");
        absolute: bool;
        stop_angle_max: Angle => positive;
        emergency_stops: u32 => whole(0, 1_000_000), example("200");
        holding_safety: f64 => within(1.0, 100.0), example("1.5");
        service_life: Time => positive, example("20000 h");
        regeneration_power_max: Power => positive;
        operation_per_day: Time => not_negative, example("10 h");
        storage: Time => not_negative, example("720 h");
        battery_life_min: Time => positive, example("20000 h");
        collision_torque: Torque => positive;
        collision_time: Time => positive;
        collisions: u32 => whole(0, 1_000_000), example("10");
        position_loop: PositionLoop;
        dc_link_rise: ElectricPotential => positive, example("40 V");
        special_application: SpecialApplication => noted(KeyDefault::OrdinaryApplication);
        leave_out: Choices<LeftOut>;
        option_1: Option1;
        option_2: Option2;
    }
}

section! {
    /// The drive that supplies the motor.
    DriveSection, DriveName of About::Drive {
        current_continuous: ElectricCurrent => positive, example("5 A");
        current_peak: ElectricCurrent => positive, example("10 A");
        peak_time: Time => positive, example("2 s");
    }
}
/// Words of a field of the ordering code, each of the first series that has it.
macro_rules! words_of_the_code {
    ($($Choice:ident of $WORDS:ident),+) => {$(
        impl WordChoice for $Choice {
            const WORDS: &'static [&'static str] = order_code::$WORDS;

            fn of_word(word: &str) -> Option<Self> {
                Series::all().find_map(|series| Self::of(series, word))
            }
        }
    )+};
}

words_of_the_code!(Feedback of FEEDBACKS, Option1 of OPTIONS_1, Option2 of OPTIONS_2);

choice!(Option1);
choice!(Option2);

/// The encoder that closes the position loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PositionLoop {
    /// Encoder of the motor.
    Motor,
    /// Encoder at the output.
    Output,
}

choices! {
    PositionLoop { Motor = "motor", Output = "output" }
}
