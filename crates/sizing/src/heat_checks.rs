//! Checks of heat: continuous torque, temperature of the winding, overload supervision.

use crate::axis::Axis;
use crate::check::{Check, CheckId, Verdict};
use crate::comparison::{Comparison, Edges, cite, project};
use crate::currents::{Currents, coil_loss};
use crate::environment_checks;
use crate::list::{Case, Outcome};
use crate::notes::{Note, Notes};
use crate::workings;
use actuator::{ContinuousLimit, Gains, Parameters, PublishedDuty};
use derivation::{Finding, Workings};
use provenance::{Grade, Missing, Source};
use quantities::Measure;
use quantities::unit::{
    AMPERE, DEGREE_CELSIUS, KELVIN_DIFFERENCE, NEWTON_METRE, NEWTON_METRE_PER_AMPERE, ONE, SECOND, WATT,
};
use trace::{Form, Lag};

/// Ratio of cycle to the winding's time constant above which a cycle is no longer short: the winding's temperature
/// swings by more than a tenth of its rise, so that the effective value alone is not sufficient.
const SHORT_CYCLE_SHARE: f64 = 0.2;

/// Model of temperatures.
const THERMAL: Source = Source::Model { name: "thermal" };

/// Checks T_rms ≤ continuous torque at n_av (cha-manual 7.1: the point (n_av, T_rms) inside the continuous zone).
pub(crate) fn continuous_torque(case: &Case<'_>, work: &mut Workings) -> Outcome {
    let (compared, edges) = continuous_torques(case, work)?;
    work.limit("T_cont");
    work.value("T_rms");
    let mut notes = compared.notes;
    if notes.is_empty() {
        notes = case.electrics.estimated.clone();
    }
    notes.extend(environment_checks::not_derated(case.axis, case.actuator));
    Ok(Comparison { notes, ..compared }.between(edges))
}

/// Effective torque and continuous torque with its band, before they are compared.
pub(crate) fn continuous_torques<'c>(case: &Case<'c>, work: &mut Workings) -> Result<(Comparison<'c>, Edges), Missing> {
    let Case { axis, actuator, electrics, demand, manual, .. } = *case;
    let id = CheckId::ContinuousTorque;
    let demand = demand.ok_or(Missing { symbol: "J_out" })?;
    workings::mean_speed(axis, work);
    if work.is_on() {
        // Computed again for its derivation.
        let _ = actuator::continuous_torque_with(actuator, electrics.heat.as_ref().ok(), demand.speed_mean, work);
    }
    let limit = electrics.continuous.as_ref().map_err(|missing| *missing)?;
    workings::effective_torque(axis, actuator, demand, manual, work);
    let mut notes = crate::checks::braking_note(manual);
    cite(&mut notes, crate::checks::inertia_errata(actuator));
    if limit.limit.grade == Grade::Estimated {
        for datum in [&actuator.stall_current, &actuator.stall_current_motor] {
            cite(&mut notes, datum.known().map_or(&[], |known| known.errata));
        }
        cite(&mut notes, actuator.torque_constant_out.known().map_or(&[], |known| known.errata));
    }
    if let Some(tau) = actuator.heat.winding_time_constant.known()
        && axis.moments.duration.si() > SHORT_CYCLE_SHARE * tau.value.si()
    {
        notes.push(Note::CycleNotShort { cycle: axis.moments.duration, time_constant: tau.value });
    }
    let edges = crate::electrics::edges(limit);
    let source = crate::checks::demand_source(manual, "69.2");
    let compared = Comparison::with(id, &NEWTON_METRE, demand.torque_rms.si(), source, &limit.limit);
    Ok((Comparison { notes, ..compared }, edges))
}

/// Returns the permissible values of the published curves at the duty of the cycle.
fn published(axis: &Axis, actuator: &Parameters, currents: &Currents<'_>) -> Option<PublishedDuty> {
    let (model, _) = currents.heat().ok()?;
    actuator::published_duty(actuator, model, axis.moments.duty_factor(), axis.moments.speed_mean())
}

/// Returns the factor that scales the modelled temperature rise of the winding to published curves; 1 without curves.
pub(crate) fn rise_scale(axis: &Axis, actuator: &Parameters, currents: &Currents<'_>) -> f64 {
    published(axis, actuator, currents).as_ref().map_or(1.0, PublishedDuty::rise_scale)
}

/// Returns the two lags whose sum is the temperature rise above the ambient: each mode has its share of both losses.
fn temperature_lags(currents: &Currents<'_>, gains: Gains) -> Result<[Lag; 2], Missing> {
    let (model, _) = currents.heat()?;
    let copper = Form::square(currents.settled_weights()).scale(model.losses().copper_ohm());
    let friction = currents.friction_form(model.losses().friction_v_s_per_rad());
    let [quick, slow] = model.network().time_constants();
    let ([cu_quick, cu_slow], [f_quick, f_slow]) = (gains.copper, gains.friction);
    let form = |of_copper: f64, of_friction: f64| copper.scale(of_copper).plus(&friction.scale(of_friction));
    Ok([
        Lag { tau_s: quick.si(), form: form(cu_quick, f_quick) },
        Lag { tau_s: slow.si(), form: form(cu_slow, f_slow) },
    ])
}

/// Checks that the winding stays below its warning threshold of 80 °C in the steady cycle, within the accuracy of the
/// model.
///
/// ϑ_w − ϑ_a ≤ b (80 °C − ϑ_a) with b the lower edge of the band: pass; above the upper edge: fail; between them
/// advice. With published curves the model is scaled to agree with them, and has no band.
pub(crate) fn thermal(case: &Case<'_>, work: &mut Workings) -> Option<Outcome> {
    temperature(case, work).transpose()
}

fn temperature(case: &Case<'_>, work: &mut Workings) -> Result<Option<Check>, Missing> {
    let Case { axis, actuator, currents, .. } = *case;
    let id = CheckId::Thermal;
    let currents = currents.map_err(|missing| *missing)?;
    let (model, settled) = currents.heat()?;
    let lags = temperature_lags(currents, model.network().winding())?;
    let ambient = axis.ambient.unwrap_or_else(|| model.ambient_reference());
    // The coil of an open brake heats the housing, on average.
    let coil = coil_loss(axis, actuator).si();
    let [_, r_ha] = model.network().resistances_k_per_w();
    let published = published(axis, actuator, currents);
    let scale = published.as_ref().map_or(1.0, PublishedDuty::rise_scale);
    let (low, high) = if published.is_some() { (1.0, 1.0) } else { model.band(axis.moments.speed_mean()) };
    let threshold = model.winding_limit();
    let room = threshold.si() - ambient.si();
    let least = case.least(low * room / scale - coil * r_ha);
    let Some(peak) = axis.trace.peak_of_lags_above(&lags, least) else { return Ok(None) };
    let rise = (peak.value + coil * r_ha) * scale;
    if work.is_on() {
        let grade = if axis.ambient.is_some() { Grade::Printed } else { Grade::Assumed };
        work.figure("theta_a", &DEGREE_CELSIUS, ambient.si(), &project("requirements.ambient"), grade);
        actuator::explain_stall_loss(actuator, work);
        work.known_number("w", &actuator.heat.housing_share);
        work.known("k_TM", &NEWTON_METRE_PER_AMPERE, &actuator.torque_constant_motor);
        actuator::explain_friction(actuator, settled, work);
        let what = Finding::CopperLoss;
        work.found("P_cu", &WATT, settled.losses.copper_w, what, &THERMAL, Grade::Estimated);
        let what = Finding::FrictionLoss;
        work.found("P_f", &WATT, settled.losses.friction_w, what, &THERMAL, Grade::Estimated);
        let steady = model.network().steady(settled.losses, ambient).winding.si();
        work.estimate("theta_m", &DEGREE_CELSIUS, steady, "theta_a + 40*(P_cu + w*P_f)/P_0", &THERMAL);
        let what = Finding::WindingRise;
        let swing = peak.value + coil * r_ha - (steady - ambient.si());
        work.found("dtheta", &KELVIN_DIFFERENCE, swing, what, &THERMAL, Grade::Estimated);
        let what = Finding::CurvesOverModel;
        work.found("c", &ONE, scale, what, &THERMAL, Grade::Estimated);
        let text = "theta_a + c*(theta_m + dtheta - theta_a)";
        work.estimate("theta_w", &DEGREE_CELSIUS, ambient.si() + rise, text, &THERMAL);
        work.value("theta_w");
        work.known("theta_warn", &DEGREE_CELSIUS, &actuator.heat.winding_warning);
        work.found("b", &ONE, low, Finding::LowerEdgeOfBand, &THERMAL, Grade::Estimated);
        let text = "theta_a + b*(theta_warn - theta_a)";
        work.estimate("theta_perm", &DEGREE_CELSIUS, ambient.si() + low * room, text, &THERMAL);
        work.limit("theta_perm");
    }
    let at = |share: f64| ambient.si() + share * room;
    let warm_up = model.network().warm_up_time(settled.losses, ambient, threshold);
    let mut notes = Notes::from([Note::RiseAbove(ambient), Note::Housing(settled.housing)]);
    notes.extend(warm_up.map(Note::WarmUp));
    notes.extend(environment_checks::not_derated(axis, actuator));
    let mut check = Comparison {
        id,
        unit: &DEGREE_CELSIUS,
        value: ambient.si() + rise,
        value_source: THERMAL,
        at: Some(quantities::Time::from_si(peak.at_s)),
        limit: at(low),
        limit_source: &THERMAL,
        grade: Grade::Estimated,
        errata: &[],
        notes,
    }
    .between(Edges { limit: at(low), upper: at(high), unit: &DEGREE_CELSIUS });
    // A temperature has no share of a limit; its rise above the ambient has.
    check.utilisation = (room > 0.0).then(|| {
        let share = rise / (low * room);
        if check.verdict == Verdict::Pass { share.min(1.0) } else { share }
    });
    Ok(Some(check))
}

/// Checks that the first-order mean of (I/I_0)² with τ_w stays below one, as a drive's I²t supervision does.
///
/// A duty that the continuous curve permits at the mean speed passes, with the friction of the cycle; above the
/// permissible heat of the winding it fails, between the two it is advice.
pub(crate) fn overload(case: &Case<'_>, work: &mut Workings) -> Option<Outcome> {
    supervised(case, work).transpose()
}

fn supervised(case: &Case<'_>, work: &mut Workings) -> Result<Option<Check>, Missing> {
    let Case { axis, actuator, electrics, currents, .. } = *case;
    let id = CheckId::OverloadI2t;
    let currents = currents.map_err(|missing| *missing)?;
    let stall = actuator.stall_current.require("I_0")?;
    let (model, _) = currents.heat()?;
    let continuous = electrics.continuous.as_ref().map_err(|missing| *missing)?;
    let stalled = stall.value.si() * stall.value.si();
    let tau = model.winding_time_constant();
    let form = Form::square(currents.settled_weights()).scale(1.0 / stalled);
    let lags = [Lag { tau_s: tau.si(), form }];
    // The limit is one or more.
    let Some(peak) = axis.trace.peak_of_lags_above(&lags, case.least(1.0)) else { return Ok(None) };
    let permitted = published(axis, actuator, currents);
    let ContinuousLimit { limit, upper } = continuous;
    let filtered = |torque: quantities::Torque| {
        let current = model.current(torque, axis.moments.speed_mean(), &currents.warm).si();
        current * current / stalled
    };
    let by_torque = filtered(limit.value).max(1.0);
    let low = by_torque.max(permitted.map_or(1.0, |published| published.overload));
    let (_, band) = model.band(axis.moments.speed_mean());
    let by_heat = band * model.stall_loss().si() / (model.losses().copper_ohm() * stalled);
    let high = if limit.grade == Grade::Estimated { low.max(filtered(*upper)).max(by_heat) } else { low };
    let source = Source::Model { name: "overload" };
    work.given("I_0", &AMPERE, stall);
    work.known("tau_w", &SECOND, &actuator.heat.winding_time_constant);
    let what = Finding::OverloadLag;
    work.found("y", &ONE, peak.value, what, &source, Grade::Estimated);
    work.value("y");
    if low > by_torque {
        work.found("y_perm", &ONE, low, Finding::OverloadPermitted, &source, Grade::Estimated);
    } else {
        if work.is_on() {
            workings::mean_speed(axis, work);
            // Computed again for its derivation.
            let speed = axis.moments.speed_mean();
            let _ = actuator::continuous_torque_with(actuator, electrics.heat.as_ref().ok(), speed, work);
            currents.explain_permitted((limit.value, speed), (model, actuator), work);
            // The derivation of the continuous torque may have that of another ratio.
            work.given("I_0", &AMPERE, stall);
        }
        work.estimate("y_perm", &ONE, low, "max((I_perm/I_0)^2, 1)", &source);
    }
    work.limit("y_perm");
    let mut check = Comparison {
        id,
        unit: &ONE,
        value: peak.value,
        value_source: Source::Model { name: "overload" },
        at: Some(quantities::Time::from_si(peak.at_s)),
        limit: low,
        limit_source: &stall.source,
        grade: Grade::Estimated,
        errata: stall.errata,
        notes: Notes::NONE,
    }
    .between(Edges { limit: low, upper: high, unit: &ONE });
    if check.verdict != Verdict::Fail && peak.value > 1.0 {
        check.notes.push(Note::TripsAtStallCurrent(stall.value));
    }
    check.notes.extend(environment_checks::not_derated(axis, actuator));
    Ok(Some(check))
}
