//! Requirements on the actuator.

use crate::Catalogue;
use crate::about::About;
use crate::key::example;
use crate::read::Reader;
use crate::section::{Section, section};
use crate::stated::StatedField;
use crate::value::{Choices, WordChoice, choice, choices};
use crate::{Assumption, Fault, Hint};
use actuator::{BatteryFault, Protection};
use configurator::Requirements;
use order_code::{Feedback, Option1, Option2, Series};
use quantities::{
    Acceleration, Angle, EffectiveVoltage, ElectricCurrent, ElectricPotential, Frequency, Length, Mass, Power,
    ThermodynamicTemperature, Time, Torque,
};
use sizing::{Axis, AxisRequirements, MainsPhases, MountingPosition, SpecialApplication, Supply, SupplyFrom};

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
        supply: ElectricPotential => positive, noted(Assumption::NoSupply);
        mains: EffectiveVoltage => positive;
        mains_phases: MainsPhases;
        mains_deviation: f64 = MAINS_DEVIATION => within(0.0, 0.5), example("0.1");
        modulation_reserve: f64 = MODULATION_RESERVE => within(0.5, 1.0), example("0.9"), noted(Assumption::ModulationReserve);
        ambient: ThermodynamicTemperature => noted(Assumption::AmbientWithinRange);
        altitude: Length => example("800 m");
        altitude_derating: f64 => within(0.1, 1.0), example("0.9");
        protection: Protection;
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
        special_application: SpecialApplication => noted(Assumption::OrdinaryApplication);
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

impl DriveSection {
    /// Sets the data of the drive for its check.
    pub(crate) fn apply(&self, axis: &mut Axis) {
        axis.asked.drive_current_continuous = self.current_continuous.value();
        axis.asked.drive_current_peak = self.current_peak.value();
        axis.asked.drive_peak_time = self.peak_time.value();
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
/// Degrees of protection of rotating machines by EN 60034-5, and those of immersion and of jets at high pressure by EN 60529.
impl WordChoice for Protection {
    const WORDS: &'static [&'static str] = &[
        "IP00", "IP10", "IP12", "IP13", "IP20", "IP21", "IP22", "IP23", "IP43", "IP44", "IP54", "IP55", "IP56", "IP64",
        "IP65", "IP66", "IP67", "IP68", "IP69",
    ];

    fn of_word(word: &str) -> Option<Self> {
        Self::WORDS.contains(&word).then(|| Self::read(word)).flatten()
    }
}

choice!(Protection);
choice!(Option1);
choice!(Option2);

/// The encoder that closes the position loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PositionLoop {
    Motor,
    Output,
}

choices! {
    MainsPhases { Single = "single", Three = "three" }
    PositionLoop { Motor = "motor", Output = "output" }
    MountingPosition {
        Horizontal = "horizontal",
        FlangeUp = "flange_up",
        FlangeDown = "flange_down",
        Changing = "changing",
    }
    SpecialApplication {
        Aerospace = "aerospace",
        ExplosiveAtmosphere = "explosive_atmosphere",
        Nuclear = "nuclear",
        Vacuum = "vacuum",
        Household = "household",
        Medical = "medical",
        HumanContact = "human_contact",
        LiftingOfPersons = "lifting_of_persons",
        Amusement = "amusement",
    }
}

impl RequirementsSection {
    /// Returns the requirements on the choice of an actuator.
    pub(crate) fn build(&self) -> Requirements {
        Requirements {
            feedback: self.feedback.get().map(|all| all.0.clone()).unwrap_or_default(),
            brake: self.brake.value(),
            hollow_shaft_min: self.hollow_shaft_min.value(),
            length_max: self.length_max.value(),
            mass_max: self.mass_max.value(),
            supply: self.link().map(|supply| supply.least()),
        }
    }

    /// Returns the DC link.
    fn link(&self) -> Option<Supply> {
        let (phases, deviation) = (self.phases(), self.mains_deviation());
        let of_mains = |nominal| SupplyFrom::Mains { phases, nominal, deviation };
        let from = self.supply.value().map(SupplyFrom::DcLink).or_else(|| self.mains.value().map(of_mains))?;
        Some(Supply { reserve: self.modulation_reserve(), from })
    }

    fn phases(&self) -> MainsPhases {
        self.mains_phases.value().unwrap_or(MainsPhases::Three)
    }

    /// Returns the assumption about conditions of use that are not stated.
    pub(crate) fn conditions_note(&self) -> Option<Assumption> {
        let has_humidity = self.humidity_min.is_given() || self.humidity_max.is_given();
        let accelerations = self.vibration.is_given() && self.shock.is_given();
        let is_complete = self.altitude.is_given()
            && self.protection.is_given()
            && has_humidity
            && accelerations
            && self.mounting.is_given();
        (!is_complete).then_some(Assumption::ConditionsWithinRange)
    }

    /// Returns the assumptions about the DC link.
    pub(crate) fn link_notes(&self) -> Vec<Assumption> {
        if !self.mains.is_given() {
            return self.supply.note().or_else(|| self.modulation_reserve.note()).into_iter().collect();
        }
        let rectifier = match (self.phases(), self.mains_deviation.is_given()) {
            (MainsPhases::Three, true) => Assumption::Rectifier,
            (MainsPhases::Three, false) => Assumption::RectifierAndDeviation,
            (MainsPhases::Single, true) => Assumption::SinglePhaseRectifier,
            (MainsPhases::Single, false) => Assumption::SinglePhaseRectifierAndDeviation,
        };
        std::iter::once(rectifier).chain(self.modulation_reserve.note()).collect()
    }

    /// Reports contradictions, and keys without effect; `has_line`: the mechanism moves along a line in proportion to its
    /// angle.
    pub(crate) fn check(&self, has_line: bool, reader: &mut Reader<'_>) {
        if self.supply.is_given() && self.mains.is_given() {
            reader.fault(self.mains.span(), Fault::SupplyAndMains, None);
        }
        let pairs: [(&dyn StatedField, &dyn StatedField); 6] = [
            (&self.deviation_max, &self.lever_arm),
            (&self.altitude_derating, &self.altitude),
            (&self.collision_time, &self.collision_torque),
            (&self.collisions, &self.collision_torque),
            (&self.mains_phases, &self.mains),
            (&self.mains_deviation, &self.mains),
        ];
        for (field, needs) in pairs {
            // Along a line the travel per angle takes the place of the lever arm.
            let is_known = has_line && needs.name() == self.lever_arm.name();
            if field.is_given() && !needs.is_written() && !is_known {
                let key = Self::KEYS.iter().find(|key| key.name == needs.name());
                let fault = Fault::OnlyBeside { key: field.name(), needs: needs.name() };
                reader.fault(field.span(), fault, key.and_then(example).map(Hint::Example));
            }
        }
    }

    /// Sets the limits of the checks.
    pub(crate) fn apply(&self, axis: &mut Axis) {
        axis.ambient = self.ambient.value();
        axis.supply = self.link();
        axis.asked = AxisRequirements {
            gear_life_min: self.gear_life_min.value(),
            torsion_max: self.torsion_max.value(),
            natural_frequency_min: self.natural_frequency_min.value(),
            angle_error_max: self.angle_error_max.value(),
            lever_arm: self.lever_arm.value(),
            deviation_max: self.deviation_max.value(),
            stop_angle_max: self.stop_angle_max.value(),
            emergency_stops: self.emergency_stops.value().map(f64::from),
            holding_safety: self.holding_safety.value(),
            service_life: self.service_life.value(),
            regeneration_power_max: self.regeneration_power_max.value(),
            absolute: self.absolute.value(),
            resolution_max: self.resolution_max.value(),
            operation_per_day: self.operation_per_day.value(),
            storage: self.storage.value(),
            battery_life_min: self.battery_life_min.value(),
            collision_torque: self.collision_torque.value(),
            collision_time: self.collision_time.value(),
            collisions: self.collisions.value().map(f64::from),
            loop_at_output: self.position_loop.value() == Some(PositionLoop::Output),
            dc_link_rise: self.dc_link_rise.value(),
            altitude: self.altitude.value(),
            altitude_derating: self.altitude_derating.value(),
            protection: self.protection.value(),
            humidity_min: self.humidity_min.value(),
            humidity_max: self.humidity_max.value(),
            vibration: self.vibration.value(),
            shock: self.shock.value(),
            mounting: self.mounting.value(),
            special_application: self.special_application.value(),
            ..AxisRequirements::default()
        };
    }

    /// Reports an operation for which the life of the battery is unknown.
    pub(crate) fn battery(&self, catalogue: &dyn Catalogue, reader: &mut Reader<'_>) {
        let Some(operation) = self.operation_per_day.value() else { return };
        let battery = catalogue.battery();
        let Some(model) = battery.known() else { return };
        if let Err(fault) = model.value.life(operation, self.storage.or_zero()) {
            let operation = matches!(fault, BatteryFault::OperationOutOfRange { .. });
            let span = if operation { self.operation_per_day.span() } else { self.storage.span() };
            reader.fault(span, Fault::Battery(fault), None);
        }
    }
}
