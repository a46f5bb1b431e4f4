//! Actuators that are not in the catalogue: one of a project, and those of catalogue files.

use crate::about::About;
use crate::choices::BearingDesign;
use crate::curves::CURVE;
use crate::section::section;
use crate::value::{CurveRow, OneOrMany, Rows, Texts};
use quantities::{
    Angle, AngularVelocity, ElectricCurrent, ElectricPotential, ElectricalResistance, Force, Inductance, Length, Mass,
    MomentOfInertia, NoLoadCurrentConstant, ThermodynamicTemperature, TiltingStiffness, Time, Torque, TorqueConstant,
    TorsionalStiffness, VoltageConstant,
};

section! {
    /// An actuator that is not in the catalogue.
    ActuatorSection, ActuatorName of About::Actuator {
        name: String => needed;
        ..values: ActuatorValues;
    }
}

section! {
    /// Data of an actuator, as its data sheet states them.
    ActuatorValues, ActuatorValueName of About::ActuatorValue {
        ratio: f64 => within(1.0, 10_000.0), example("50");
        torque_max: Torque => positive;
        speed_max: AngularVelocity => positive;
        speed_motor_max: AngularVelocity => positive, example("6000 1/min");
        speed_motor_rated: AngularVelocity => positive, example("3500 1/min");
        inertia_out: MomentOfInertia => not_negative;
        stall_torque: Torque => positive;
        stall_current: ElectricCurrent => positive;
        current_max: ElectricCurrent => positive;
        current_demagnetisation: ElectricCurrent => positive;
        no_load_starting_current: ElectricCurrent => not_negative;
        no_load_current_constant_30: NoLoadCurrentConstant => not_negative;
        no_load_current_constant_80: NoLoadCurrentConstant => not_negative;
        torque_constant_out: TorqueConstant => positive;
        torque_constant_motor: TorqueConstant => positive;
        voltage_constant_motor: VoltageConstant => positive;
        resistance_ll: ElectricalResistance => positive;
        winding_temperature_max: ThermodynamicTemperature;
        inductance_ll: Inductance => positive;
        pole_pairs: u32 => whole(1, 100), example("5");
        mass: Mass => positive;
        length: Length => positive, example("120 mm");
        hollow_shaft: Length => not_negative, example("18 mm");
        dc_link_max: ElectricPotential => positive;
        terminal_voltage_min: ElectricPotential => positive;
        gear_torque_rated: Torque => positive;
        gear_torque_mean_max: Torque => positive;
        gear_torque_momentary_max: Torque => positive;
        gear_speed_max: AngularVelocity => positive, example("8500 1/min");
        gear_speed_mean_max: AngularVelocity => positive, example("3500 1/min");
        gear_life_rated: Time => positive, example("7000 h");
        gear_life_speed: AngularVelocity => positive, example("2000 1/min");
        stiffness_1: TorsionalStiffness => positive;
        stiffness_2: TorsionalStiffness => positive;
        stiffness_3: TorsionalStiffness => positive;
        torque_1: Torque => positive;
        torque_2: Torque => positive;
        transmission_accuracy: Angle => not_negative, example("1 arcmin");
        repeatability: Angle => not_negative, example("0.1 arcmin");
        hysteresis_loss: Angle => not_negative, example("1 arcmin");
        lost_motion: Angle => not_negative, example("1 arcmin");
        feedback_resolution: Angle => positive, example("1 arcsec");
        feedback_accuracy: Angle => not_negative, example("20 arcsec");
        bearing_type: BearingDesign;
        bearing_pitch_diameter: Length => positive, example("85 mm");
        bearing_offset: Length => not_negative, example("15 mm");
        bearing_dynamic: Force => positive, example("15 kN");
        bearing_static: Force => positive, example("24 kN");
        tilting_moment_max: Torque => positive;
        static_moment_max: Torque => positive;
        axial_force_max: Force => positive, example("5 kN");
        radial_force_max: Force => positive, example("4 kN");
        tilting_stiffness: TiltingStiffness => positive;
        brake_torque: Torque => positive;
        brake_closing_time: Time => positive, example("40 ms");
        brake_opening_time: Time => positive, example("60 ms");
        winding_time_constant: Time => positive, example("60 s");
        ambient_min: ThermodynamicTemperature;
        ambient_max: ThermodynamicTemperature;
        short_time_curve: Rows<CurveRow> => example(CURVE);
        continuous_curve: Rows<CurveRow> => example(CURVE);
    }
}

section! {
    /// Catalogue files of a project.
    CatalogueSection, CatalogueName of About::Catalogue {
        files: Texts => example("stock.toml");
        cha: bool = true;
    }
}

section! {
    /// A whole catalogue file.
    CatalogueFile, CatalogueFileName of About::CatalogueFile {
        catalogue: CatalogueHead;
        actuator: OneOrMany<ActuatorEntry, ActuatorEntry>;
    }
}

section! {
    /// Statements of a catalogue file that hold for all its products.
    CatalogueHead, CatalogueHeadName of About::CatalogueHead {
        maker: String => example("Example Drives");
        series: String => example("XD");
        source: String => example("catalogue 2026, pages 12 to 15");
        date: String => example("2026-05-01");
    }
}

section! {
    /// An actuator of a catalogue file.
    ActuatorEntry, ActuatorEntryName of About::ActuatorEntry {
        id: String => needed, example("XD-25-100");
        maker: String => example("Example Drives");
        series: String => example("XD");
        source: String => example("data sheet XD-25, revision C");
        price: String => example("1250 EUR");
        lead_time: Time => not_negative, example("56 d");
        ..values: ActuatorValues;
    }
}
