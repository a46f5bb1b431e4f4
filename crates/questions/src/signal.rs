//! Signals of a run of the twin: names, columns and descriptions.

use quantities::Unit;
use quantities::unit::{
    AMPERE, DEGREE_CELSIUS, NEWTON_METRE, ONE, RADIAN, RADIAN_PER_SECOND, RADIAN_PER_SECOND_SQUARED, SECOND, VOLT,
};
use twin::Sample;
use words::{Word, simulation, tables, terms};

/// A signal over time.
#[derive(Clone, Copy, Debug)]
pub struct Signal {
    /// Name of the signal.
    pub id: &'static str,
    /// Heading of the column: the name with the unit.
    pub column: &'static str,
    /// Name in words.
    pub title: Word,
    /// Part of the drive to which the signal belongs, or its meaning.
    pub about: Word,
    /// Unit of the column.
    pub unit: &'static Unit,
    /// Function that returns the value in SI; NaN, an empty cell, if the actuator has no such signal.
    pub of: fn(&Sample) -> f64,
}

impl Signal {
    const fn new(
        names: (&'static str, &'static str),
        title: Word,
        about: Word,
        unit: &'static Unit,
        of: fn(&Sample) -> f64,
    ) -> Self {
        let (id, column) = names;
        Self { id, column, title, about, unit, of }
    }

    /// Returns the signal with a name.
    #[must_use]
    pub fn of_id(id: &str) -> Option<&'static Self> {
        SIGNALS.iter().find(|signal| signal.id == id)
    }

    /// Returns the names of all signals.
    #[must_use]
    pub fn ids() -> Vec<&'static str> {
        SIGNALS.iter().map(|signal| signal.id).collect()
    }
}

/// The time, first column of every course.
pub const TIME: Signal =
    Signal::new(("time", "time_s"), terms::time, tables::time_of_course_about, &SECOND, |s| s.time_s);

/// Signals in the order of the columns. Names and headings are the contract with scripts and with `identify`.
pub const SIGNALS: &[Signal] = &[
    Signal::new(("wanted_position", "wanted_position_rad"), tables::angle, simulation::wanted, &RADIAN, |s| {
        s.wanted_rad
    }),
    Signal::new(
        ("wanted_speed", "wanted_speed_rad_s"),
        terms::rotary_speed,
        simulation::wanted,
        &RADIAN_PER_SECOND,
        |s| s.wanted_rad_s,
    ),
    Signal::new(("position", "position_rad"), tables::angle, simulation::of_the_load, &RADIAN, |s| s.position_rad),
    Signal::new(("speed", "speed_rad_s"), terms::rotary_speed, simulation::of_the_load, &RADIAN_PER_SECOND, |s| {
        s.speed_rad_s
    }),
    Signal::new(
        ("acceleration", "acceleration_rad_s2"),
        terms::acceleration,
        simulation::of_the_load,
        &RADIAN_PER_SECOND_SQUARED,
        |s| s.acceleration_rad_s2,
    ),
    Signal::new(("measured_position", "measured_position_rad"), tables::angle, simulation::measured, &RADIAN, |s| {
        s.measured_rad
    }),
    Signal::new(("motor_position", "motor_position_rad"), tables::angle, simulation::of_the_motor, &RADIAN, |s| {
        s.motor_rad
    }),
    Signal::new(
        ("motor_speed", "motor_speed_rad_s"),
        terms::rotary_speed,
        simulation::of_the_motor,
        &RADIAN_PER_SECOND,
        |s| s.motor_rad_s,
    ),
    Signal::new(("torque", "torque_nm"), tables::torque, simulation::torque_peak, &NEWTON_METRE, |s| s.torque_nm),
    Signal::new(("current_q", "current_q_a"), tables::motor_current, simulation::peak_of_a_phase, &AMPERE, |s| {
        s.current_q_a
    }),
    Signal::new(("current_d", "current_d_a"), tables::motor_current, simulation::peak_of_a_phase, &AMPERE, |s| {
        s.current_d_a
    }),
    Signal::new(("voltage_q", "voltage_q_v"), simulation::voltage, simulation::peak_of_a_phase, &VOLT, |s| {
        s.voltage_q_v
    }),
    Signal::new(("voltage_d", "voltage_d_v"), simulation::voltage, simulation::peak_of_a_phase, &VOLT, |s| {
        s.voltage_d_v
    }),
    Signal::new(("link", "link_v"), simulation::voltage, simulation::dc_link, &VOLT, |s| s.link_v),
    Signal::new(("winding", "winding_degc"), terms::winding, tables::temperature_about, &DEGREE_CELSIUS, |s| {
        s.winding_k
    }),
    Signal::new(("housing", "housing_degc"), terms::housing, tables::temperature_about, &DEGREE_CELSIUS, |s| {
        s.housing_k
    }),
    Signal::new(("sensor", "sensor_degc"), simulation::sensor, simulation::sensor, &DEGREE_CELSIUS, |s| {
        s.sensor_k.unwrap_or(f64::NAN)
    }),
    Signal::new(("overload", "overload"), tables::overload, tables::overload_about, &ONE, |s| s.overload),
    Signal::new(
        ("following_error", "following_error_rad"),
        simulation::following_peak,
        simulation::of_the_load,
        &RADIAN,
        |s| s.following_rad,
    ),
    Signal::new(("brake", "brake"), simulation::braked, simulation::braked, &ONE, |s| f64::from(u8::from(s.braked))),
    Signal::new(("link_high", "link_high_v"), simulation::voltage, simulation::dc_link_high, &VOLT, |s| s.link_high_v),
];

#[cfg(test)]
mod tests {
    use super::*;

    /// A heading is the name with the unit in its spelling of identifiers.
    #[test]
    fn a_heading_is_the_name_with_its_unit() {
        for Signal { id, column, unit, .. } in std::iter::once(&TIME).chain(SIGNALS) {
            let spelled: String = unit.ascii.to_lowercase().replace(['/', ' '], "_").replace('^', "");
            let expected =
                if **unit == ONE { (*id).to_owned() } else { format!("{id}_{}", spelled.replace("n_m", "nm")) };
            assert_eq!(*column, expected);
        }
        assert!(Signal::of_id("time").is_none() && Signal::of_id("speed").is_some());
    }
}
