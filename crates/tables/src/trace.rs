//! The course of a simulation as a table.

use crate::define::column;
use crate::rows::Rows;
use crate::table::{Column, ColumnContent, Table};
use quantities::unit::{
    AMPERE, DEGREE_CELSIUS, NEWTON_METRE, ONE, RADIAN, RADIAN_PER_SECOND, RADIAN_PER_SECOND_SQUARED, SECOND, VOLT,
};
use quantities::{Language, Unit};
use questions::TwinSample;
use words::{Word, capitalised, simulation, tables, terms};

/// The course of a simulation: names and units are the contract with scripts and with `identify`.
#[must_use]
pub fn trace(samples: &[TwinSample], language: Language) -> Table {
    type Of = fn(&TwinSample) -> f64;
    let series: [(&str, Word, &'static Unit, Word, Of); 20] = [
        ("time_s", terms::time, &SECOND, tables::time_of_course_about, |s| s.time_s),
        ("wanted_position_rad", tables::angle, &RADIAN, simulation::wanted, |s| s.wanted_rad),
        ("wanted_speed_rad_s", terms::rotary_speed, &RADIAN_PER_SECOND, simulation::wanted, |s| s.wanted_rad_s),
        ("position_rad", tables::angle, &RADIAN, simulation::of_the_load, |s| s.position_rad),
        ("speed_rad_s", terms::rotary_speed, &RADIAN_PER_SECOND, simulation::of_the_load, |s| s.speed_rad_s),
        ("acceleration_rad_s2", terms::acceleration, &RADIAN_PER_SECOND_SQUARED, simulation::of_the_load, |s| {
            s.acceleration_rad_s2
        }),
        ("motor_position_rad", tables::angle, &RADIAN, simulation::of_the_motor, |s| s.motor_rad),
        ("motor_speed_rad_s", terms::rotary_speed, &RADIAN_PER_SECOND, simulation::of_the_motor, |s| s.motor_rad_s),
        ("torque_nm", tables::torque, &NEWTON_METRE, simulation::torque_peak, |s| s.torque_nm),
        ("current_q_a", tables::motor_current, &AMPERE, simulation::peak_of_a_phase, |s| s.current_q_a),
        ("current_d_a", tables::motor_current, &AMPERE, simulation::peak_of_a_phase, |s| s.current_d_a),
        ("voltage_q_v", simulation::voltage, &VOLT, simulation::peak_of_a_phase, |s| s.voltage_q_v),
        ("voltage_d_v", simulation::voltage, &VOLT, simulation::peak_of_a_phase, |s| s.voltage_d_v),
        ("link_v", simulation::voltage, &VOLT, simulation::dc_link, |s| s.link_v),
        ("winding_degc", terms::winding, &DEGREE_CELSIUS, tables::temperature_about, |s| s.winding_k),
        ("housing_degc", terms::housing, &DEGREE_CELSIUS, tables::temperature_about, |s| s.housing_k),
        ("sensor_degc", simulation::sensor, &DEGREE_CELSIUS, simulation::sensor, |s| s.sensor_k),
        ("overload", tables::overload, &ONE, tables::overload_about, |s| s.overload),
        ("following_error_rad", simulation::following_peak, &RADIAN, simulation::of_the_load, |s| s.following_rad),
        ("brake", simulation::braked, &ONE, simulation::braked, |s| if s.braked { 1.0 } else { 0.0 }),
    ];
    let columns: Vec<Column> = series
        .iter()
        // The name has the unit already.
        .map(|(name, title, _, about, _)| column(name, *title, ColumnContent::Number, None, *about, language))
        .collect();
    let row = |sample: &TwinSample| series.map(|(.., unit, _, of)| Some(unit.from_si(of(sample))));
    Table {
        name: "trace",
        title: capitalised(simulation::trace(language)),
        about: simulation::trace_about(language).to_owned(),
        columns,
        rows: Rows::series(samples.iter().map(row)),
        derived: Vec::new(),
    }
}
