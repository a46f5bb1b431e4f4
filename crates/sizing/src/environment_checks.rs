//! Checks of the place of installation: altitude, degree of protection, humidity, vibration, shock, mounting position.

use crate::axis::Axis;
use crate::check::{Amount, Check, CheckId, Verdict};
use crate::comparison::{Asking, Comparison, project, unjudged};
use crate::heat_checks;
use crate::list::{Case, Outcome};
use crate::notes::Note;
use actuator::Drivetrain;
use derivation::Workings;
use numeric::{at_least, at_most};
use provenance::{Datum, Missing};
use quantities::unit::{METRE, NEWTON_METRE, ONE, PERCENT, STANDARD_GRAVITY};
use quantities::{Acceleration, Measure};

/// Checks the altitude. Below the stated limit of the manual the data hold. Above it, and if the manual states none, the
/// derating that the project states decides: the effective torque against the derated continuous torque.
///
/// H < H_max, or T_rms ≤ k_H T_cont
///
/// # Symbols
/// H altitude \[m\], H_max altitude limit of the manual \[m\], T_rms effective torque \[Nm\], T_cont continuous torque
/// \[Nm\], k_H stated derating
/// # Source
/// cha-manual table 13.2 for the windings H and N; table 13.1 states none for E. The manual states no derating.
/// # Errors
/// When no derating is stated above H_max, or without H_max.
pub(crate) fn altitude(case: &Case<'_>, work: &mut Workings) -> Outcome {
    let Case { axis, actuator, .. } = *case;
    let (id, key, derating) = (CheckId::Altitude, "requirements.altitude", "requirements.altitude_derating");
    let stated = axis.asked.altitude.ok_or(Missing { symbol: key })?;
    let printed = actuator.environment.altitude_max.known();
    if let Some(limit) = printed.filter(|limit| !at_least(stated.si(), limit.value.si())) {
        work.stated("H", &METRE, stated.si(), key);
        work.value("H");
        work.given("H_max", &METRE, limit);
        work.limit("H_max");
        let check = Comparison::with(id, &METRE, stated.si(), project(key), limit).answer(Verdict::Fail);
        // Below the limit the data hold as stated: the share of the altitude is no margin.
        return Ok(Check { utilisation: None, ..check });
    }
    let symbol = if printed.is_some() { derating } else { "altitude" };
    let factor = axis.asked.altitude_derating.ok_or(Missing { symbol })?;
    let (compared, edges) = heat_checks::continuous_torques(case, work)?;
    work.stated("k_H", &ONE, factor, derating);
    work.formula("T_der", &NEWTON_METRE, factor * edges.limit, "k_H*T_cont", &project(derating));
    work.value("T_rms");
    work.limit("T_der");
    let source = project(derating);
    let edges = edges.scaled(factor);
    let mut notes = compared.notes;
    notes.push(Note::DeratesThisCheckOnly);
    Ok(Comparison { id, limit_source: &source, notes, ..compared }.between(edges))
}

/// Returns the remark that a limit by heat is not derated, if the manual states no data for the stated altitude: the
/// derating is judged by [`altitude`] alone.
pub(crate) fn not_derated(axis: &Axis, actuator: &Drivetrain) -> Option<Note> {
    let stated = axis.asked.altitude?.si();
    let printed = actuator.environment.altitude_max.known();
    printed.is_none_or(|limit| at_least(stated, limit.value.si())).then_some(Note::NotDeratedForAltitude)
}

/// Compares the required degree of protection with that of the manual, numeral by numeral.
pub(crate) fn protection(axis: &Axis, actuator: &Drivetrain, work: &mut Workings) -> Outcome {
    let (id, key) = (CheckId::Protection, "requirements.protection");
    let required = axis.asked.protection.ok_or(Missing { symbol: key })?;
    let printed = actuator.environment.protection.require("protection_class")?;
    let meets = printed.value.meets_solids(required) && printed.value.meets_water(required);
    let both = |of: actuator::Protection| f64::from(10 * of.solids + of.water);
    // A larger second numeral does not make up for the first: then the numeral that is not met is compared.
    let (value, limit) = if meets || both(required) > both(printed.value) {
        (both(required), both(printed.value))
    } else {
        (f64::from(required.water), f64::from(printed.value.water))
    };
    work.stated("IP", &ONE, value, key);
    work.value("IP");
    work.figure("IP_max", &ONE, limit, &printed.source, printed.grade);
    work.limit("IP_max");
    Ok(Check {
        verdict: if meets { Verdict::Pass } else { Verdict::Fail },
        value: Some(Amount { si: value, unit: &ONE }),
        limit: Some(Amount { si: limit, unit: &ONE }),
        grade: Some(printed.grade),
        value_source: Some(project(key)),
        limit_source: Some(printed.source.clone()),
        notes: Note::Protection { required, printed: printed.value }.into(),
        ..unjudged(id)
    })
}

/// Compares the highest relative humidity of the place with the range for which the actuator's data hold.
pub(crate) fn humidity(axis: &Axis, actuator: &Drivetrain, work: &mut Workings) -> Outcome {
    humidity_in_range(CheckId::Humidity, (axis.asked.humidity_max, "requirements.humidity_max"), actuator, work)
}

/// Compares the lowest relative humidity of the place with the range for which the actuator's data hold.
pub(crate) fn humidity_min(axis: &Axis, actuator: &Drivetrain, work: &mut Workings) -> Outcome {
    humidity_in_range(CheckId::HumidityMin, (axis.asked.humidity_min, "requirements.humidity_min"), actuator, work)
}

/// Compares a relative humidity with the nearer end of the permissible range.
fn humidity_in_range(
    id: CheckId,
    (stated, key): (Option<f64>, &'static str),
    actuator: &Drivetrain,
    work: &mut Workings,
) -> Outcome {
    let stated = stated.ok_or(Missing { symbol: key })?;
    let range = actuator.environment.humidity.require("relative_humidity")?;
    let (low, high) = (range.value.0.si(), range.value.1.si());
    let is_inside = at_least(stated, low) && at_most(stated, high);
    let is_of_the_low_end = if is_inside { id == CheckId::HumidityMin } else { stated < low };
    let nearest = if is_of_the_low_end { low } else { high };
    work.stated("rH", &PERCENT, stated, key);
    work.value("rH");
    work.figure("rH_limit", &PERCENT, nearest, &range.source, range.grade);
    work.limit("rH_limit");
    Ok(Check {
        verdict: if is_inside { Verdict::Pass } else { Verdict::Fail },
        value: Some(Amount { si: stated, unit: &PERCENT }),
        limit: Some(Amount { si: nearest, unit: &PERCENT }),
        grade: Some(range.grade),
        value_source: Some(project(key)),
        limit_source: Some(range.source.clone()),
        ..unjudged(id)
    })
}

/// Compares the stated vibration with the resistance of the actuator.
pub(crate) fn vibration(axis: &Axis, actuator: &Drivetrain, work: &mut Workings) -> Outcome {
    let stated = (axis.asked.vibration, "requirements.vibration");
    let limit = (&actuator.environment.vibration_max, "vibration_resistance");
    resisted(CheckId::Vibration, stated, limit, ["a_vib", "a_vib_max"], work)
}

/// Compares the stated shock with the resistance of the actuator.
pub(crate) fn shock(axis: &Axis, actuator: &Drivetrain, work: &mut Workings) -> Outcome {
    let stated = (axis.asked.shock, "requirements.shock");
    let limit = (&actuator.environment.shock_max, "shock_resistance");
    resisted(CheckId::Shock, stated, limit, ["a_shock", "a_shock_max"], work)
}

fn resisted(
    id: CheckId,
    (stated, key): (Option<Acceleration>, &'static str),
    (limit, symbol): (&Datum<Acceleration>, &'static str),
    [value_symbol, limit_symbol]: [&'static str; 2],
    work: &mut Workings,
) -> Outcome {
    let stated = stated.ok_or(Missing { symbol: key })?;
    let limit = limit.require(symbol)?;
    work.stated(value_symbol, &STANDARD_GRAVITY, stated.si(), key);
    work.value(value_symbol);
    work.given(limit_symbol, &STANDARD_GRAVITY, limit);
    work.limit(limit_symbol);
    Ok(Comparison::with(id, &STANDARD_GRAVITY, stated.si(), project(key), limit).answer(Verdict::Fail))
}

/// Returns the check of the mounting position, which is not checked: the manual neither restricts the position nor states
/// that any is permitted.
pub(crate) const fn mounting(_: &Axis, _: &Drivetrain, _: &mut Workings) -> Outcome {
    Err(Missing { symbol: "mounting_position" })
}

#[cfg(test)]
#[path = "environment_tests.rs"]
mod tests;
