//! A run of the digital twin as a record.

use super::check::assumptions_about;
use crate::simulate::{COMPARED, Shown, Simulated};
use answers::{
    Compared, ControlLoop, DayOfOperation, EncoderFailure, EndOverrun, Figure, Figures, HourOfOperation, Id,
    ModelParameter, Number, SimulatedEvent, SimulatedVerdict, Simulation, WorstInstant, WorstOfDirection,
};
use feedback::Failure;
use quantities::unit::{
    AMPERE, ARCMINUTE, DEGREE, DEGREE_CELSIUS, HERTZ, HOUR, JOULE, KELVIN_DIFFERENCE, MILLIMETRE, NEWTON_METRE, ONE,
    REVOLUTION_PER_MINUTE, SECOND, VOLT, WATT_HOUR,
};
use quantities::{Language, Measure, Unit, format_significant};
use sizing::{CheckId, RunCheck};
use twin::{
    Averaged, EventEffect, EventKind, Failed, Gains, LoopResponse, MotionDirection, Operation, POINTS_OF_A_PERIOD,
    Parameter, PeriodCourse, ScenarioId, WorstOf,
};
use words::{Word, check_title, schema_text, short_label, simulation, source_text};

/// Returns a run.
#[must_use]
pub fn simulation(run: &Simulated<'_>, language: Language) -> Simulation {
    let celsius = |kelvin: f64| Number::in_unit(kelvin, &DEGREE_CELSIUS);
    Simulation {
        axis: run.project.name.clone(),
        code: run.candidate.id.to_string(),
        scenario: Id(run.scenario.id),
        title: simulation::scenario_title(run.scenario.id, language),
        at: run.events.iter().find(|event| event.kind == EventKind::Scenario).map(|event| Number(event.time_s)),
        instant: run.worst.as_ref().map(|worst| worst_instant(worst, run, language)),
        reaction: Id(run.scenario.reaction),
        cycles: run.scenario.cycles.max(1),
        seed: run.seed,
        time: Number(run.summary.time_s),
        steps: run.steps,
        step: Number(run.step_s * 1e6),
        ambient: celsius(run.ambient_k),
        start: run.start_k.map(celsius),
        summary: Figures(figures(run, language)),
        averaged: run.averaged.as_ref().map(|(operation, found)| Figures(averaged(operation, found, language))),
        days: run.averaged.iter().flat_map(|(_, found)| &found.courses).map(day).collect(),
        verdicts: run.checks().into_iter().map(|check| verdict(check, language)).collect(),
        events: run.events.iter().map(|event| happened(event, language)).collect(),
        encoder_failure: run.failed.as_ref().map(|failed| encoder_failure(failed, language)),
        comparison: comparison(run, language),
        loops: run.loops.iter().map(|each| control_loop(each, language)).collect(),
        gains: Figures(gains(&run.gains)),
        gains_by_rule: !run.gains_stated,
        parameters: run.parameters.list().into_iter().map(|each| parameter(each, language)).collect(),
        notes: notes(run, language),
        assumptions: assumptions_about(run.project, &run.candidate, language),
        trace: None,
    }
}

fn worst_instant(worst: &twin::WorstInstant, run: &Simulated<'_>, language: Language) -> WorstInstant {
    // Along a linear axis ways are lengths.
    let travel = run.project.axis.mechanism.travel_m_per_rad().map(f64::abs);
    let (way_unit, per_rad) = travel.map_or((&DEGREE, 1.0), |travel| (&MILLIMETRE, travel));
    let (unit, effect) = match worst.effect {
        EventEffect::Travel => (way_unit, simulation::effect_travel(language)),
        EventEffect::Torque => (&NEWTON_METRE, simulation::effect_torque(language)),
        EventEffect::Link => (&VOLT, simulation::effect_link(language)),
        EventEffect::Speed => (&REVOLUTION_PER_MINUTE, simulation::effect_speed(language)),
    };
    let direction = |each: &WorstOf| match each.direction {
        MotionDirection::Positive => simulation::direction_positive(language),
        MotionDirection::Negative => simulation::direction_negative(language),
        MotionDirection::Standstill => simulation::direction_standstill(language),
    };
    let factor = if worst.effect == EventEffect::Travel { per_rad } else { 1.0 };
    let shown = |si: f64, unit: &'static Unit, rests: bool| {
        let gap = if unit.symbol_in(language) == "°" { "" } else { "\u{a0}" };
        let number = format_significant(unit.from_si(si), 4, language);
        let value = format!("{number}{gap}{}", unit.symbol_in(language));
        if rests { value } else { simulation::no_rest(&value, language) }
    };
    let value = |each: &WorstOf| shown(factor * each.value, unit, each.rests);
    let seconds = |time: f64| format_significant(time, 4, language);
    let mut parts: Vec<String> = Vec::new();
    for (place, each) in worst.directions.iter().enumerate() {
        parts.push(if place == 0 {
            simulation::worst_instant(
                &worst.examined,
                &seconds(each.at_s),
                &direction(each),
                &effect,
                &value(each),
                language,
            )
        } else {
            simulation::worst_elsewhere(&direction(each), &value(each), &seconds(each.at_s), language)
        });
    }
    for each in &worst.overruns {
        let value = shown(per_rad * each.beyond_rad, way_unit, each.rests);
        parts.push(match each.end {
            MotionDirection::Negative => simulation::overrun_below(&value, &seconds(each.at_s), language),
            _ => simulation::overrun_above(&value, &seconds(each.at_s), language),
        });
    }
    if worst.is_cut {
        parts.push(simulation::search_limited(language).to_owned());
    }
    let directions = worst.directions.iter().map(|each| WorstOfDirection {
        direction: Id(each.direction),
        at: Number(each.at_s),
        value: Number::in_unit(factor * each.value, unit),
        unit: unit.json,
        rests: each.rests,
    });
    let overruns = worst.overruns.iter().map(|each| EndOverrun {
        end: Id(each.end),
        at: Number(each.at_s),
        value: Number::in_unit(per_rad * each.beyond_rad, way_unit),
        unit: way_unit.json,
        rests: each.rests,
    });
    WorstInstant {
        effect: Id(worst.effect),
        examined: worst.examined,
        limited: worst.is_cut,
        directions: directions.collect(),
        overruns: overruns.collect(),
        title: parts.join("; "),
    }
}

fn encoder_failure(failed: &Failed, language: Language) -> EncoderFailure {
    let error = Number::in_unit(failed.error_rad, &DEGREE);
    let shown = |value: f64| format_significant(value, 3, language);
    let failure = simulation::failure_title(failed.failure, language);
    let angle = shown(DEGREE.from_si(failed.error_rad));
    EncoderFailure {
        failure: failed.failure.map_or("battery", Failure::id),
        finding: failed.noticed.map(|(finding, _)| finding.id()),
        after: failed.noticed.map(|(_, after_s)| Number(after_s * 1e3)),
        error,
        title: match failed.noticed {
            Some((finding, after_s)) => simulation::noticed(
                &failure,
                &shown(after_s * 1e3),
                &simulation::finding_title(finding, language),
                &angle,
                language,
            ),
            None => simulation::not_noticed(&failure, &angle, language),
        },
    }
}

fn happened(event: &twin::Event, language: Language) -> SimulatedEvent {
    SimulatedEvent {
        time: Number(event.time_s),
        event: Id(event.kind),
        title: simulation::event_title(event.kind, language),
    }
}

/// Returns the figures of a run, in their order.
fn figures(run: &Simulated<'_>, language: Language) -> Vec<Figure> {
    let (s, e) = (&run.summary, &run.summary.energies);
    let with_heat = s.winding_peak_k > 0.0;
    let warm = |si: f64| with_heat.then_some(si);
    let [blocked, free] = run.resonance.map_or([None; 2], |both| both.map(|frequency| Some(frequency.si())));
    let travel = run.project.axis.mechanism.travel_m_per_rad();
    let along = |angle: f64| travel.map(|travel| angle * travel.abs());
    let [at_rest, in_motion] = s.brake_closings.map(|count| Some(f64::from(count)));
    let way_unit = if travel.is_some() { &MILLIMETRE } else { &DEGREE };
    let way = |angle: Option<f64>| if travel.is_some() { angle.and_then(along) } else { angle };
    let all: [(&'static str, Word, Option<f64>, &'static Unit); 36] = [
        ("following_peak", simulation::following_peak, Some(s.following_peak_rad), &ARCMINUTE),
        ("following_rms", simulation::following_rms, Some(s.following_rms_rad), &ARCMINUTE),
        ("settling", simulation::settling, s.settling_s, &SECOND),
        ("standing", simulation::standing, s.standing_rad, &ARCMINUTE),
        ("current_peak", simulation::current_peak, Some(s.current_peak_a), &AMPERE),
        ("current_rms", simulation::current_rms, Some(s.current_rms_a), &AMPERE),
        ("torque_peak", simulation::torque_peak, Some(s.torque_peak_nm), &NEWTON_METRE),
        ("torque_rms", simulation::torque_rms, Some(s.torque_rms_nm), &NEWTON_METRE),
        ("speed_peak", simulation::speed_peak, Some(s.speed_peak_rad_s), &REVOLUTION_PER_MINUTE),
        ("winding_end", simulation::winding_end, warm(s.winding_end_k), &DEGREE_CELSIUS),
        ("housing_end", simulation::housing_end, warm(s.housing_end_k), &DEGREE_CELSIUS),
        ("winding_peak", simulation::winding_peak, warm(s.winding_peak_k), &DEGREE_CELSIUS),
        ("overload", simulation::overload, warm(s.overload_peak), &ONE),
        ("link_low", simulation::link_low, Some(s.link_v[0]), &VOLT),
        ("link_high", simulation::link_high, Some(s.link_v[1]), &VOLT),
        ("energy_motor", simulation::energy_motor, Some(e.terminal_j + e.regenerated_j), &JOULE),
        ("energy_regenerated", simulation::energy_regenerated, Some(e.regenerated_j), &JOULE),
        ("energy_copper", simulation::energy_copper, Some(e.copper_j), &JOULE),
        ("energy_friction", simulation::energy_friction, Some(e.friction_j), &JOULE),
        ("energy_mesh", simulation::energy_mesh, Some(e.mesh_j), &JOULE),
        ("energy_hysteresis", simulation::energy_hysteresis, Some(e.hysteresis_j + e.damping_j), &JOULE),
        ("energy_brake", simulation::energy_brake, Some(e.brake_j), &JOULE),
        ("energy_load", simulation::energy_load, Some(e.flange_j), &JOULE),
        ("energy_constants", simulation::energy_constants, Some(e.constants_j), &JOULE),
        ("energy_resistor", simulation::energy_resistor, Some(s.resistor_j), &JOULE),
        ("energy_supply", simulation::energy_supply, Some(s.supplied_j), &JOULE),
        ("unaccounted", simulation::unaccounted, Some(s.unaccounted_j), &JOULE),
        ("resonance_blocked", simulation::resonance_blocked, blocked, &HERTZ),
        ("resonance_free", simulation::resonance_free, free, &HERTZ),
        ("stop_time", simulation::stop_time, s.stop_s, &SECOND),
        ("stop_angle", simulation::stop_angle, s.stop_rad, &DEGREE),
        ("stop_travel", simulation::stop_travel, s.stop_rad.and_then(along), &MILLIMETRE),
        ("overrun_below", simulation::beyond_lowest, way(s.beyond_rad[0]), way_unit),
        ("overrun_above", simulation::beyond_highest, way(s.beyond_rad[1]), way_unit),
        ("brake_rest", simulation::brake_rest, at_rest, &ONE),
        ("brake_moving", simulation::brake_moving, in_motion, &ONE),
    ];
    laid(&all, language)
}

/// Returns the figures of operation over days.
fn averaged(operation: &Operation, found: &Averaged, language: Language) -> Vec<Figure> {
    let ([winding, housing], [winding_swing, housing_swing]) = (found.peak_k, found.swing_k);
    let [copper, heat] = found.lost_j;
    let runs = found.running_s > 0.0;
    let all: [(&'static str, Word, Option<f64>, &'static Unit); 12] = [
        ("days", simulation::days, Some(f64::from(operation.periods)), &ONE),
        ("operation", simulation::operation, Some(found.running_s), &HOUR),
        ("cycles", simulation::cycles, Some(found.cycles), &ONE),
        ("starts", simulation::starts, Some(f64::from(found.starts)), &ONE),
        ("winding_peak", simulation::winding_peak, Some(winding), &DEGREE_CELSIUS),
        ("housing_peak", simulation::housing_peak, Some(housing), &DEGREE_CELSIUS),
        ("housing_mean", simulation::housing_mean, runs.then_some(found.running_housing_k), &DEGREE_CELSIUS),
        ("winding_swing", simulation::winding_swing, Some(winding_swing), &KELVIN_DIFFERENCE),
        ("housing_swing", simulation::housing_swing, Some(housing_swing), &KELVIN_DIFFERENCE),
        ("energy_copper", simulation::energy_copper, Some(copper), &WATT_HOUR),
        ("energy_housing", simulation::energy_housing, Some(heat), &WATT_HOUR),
        ("energy_supply", simulation::energy_supply, Some(found.supplied_j), &WATT_HOUR),
    ];
    laid(&all, language)
}

/// Returns a day by its hours.
fn day(course: &PeriodCourse) -> DayOfOperation {
    let celsius = |kelvin: f64| Number::in_unit(kelvin, &DEGREE_CELSIUS);
    let each = (POINTS_OF_A_PERIOD / HOURS) as usize;
    let hour = |hour: u32| {
        let end = hour as usize * each;
        let point = course.points.get(end)?;
        let since = if hour == 0 { 0 } else { end - each + 1 };
        let peak = course.points.get(since..=end)?.iter().map(|point| point.winding_peak_k).fold(0.0, f64::max);
        Some(HourOfOperation {
            hour,
            winding: celsius(point.winding_k),
            winding_peak: celsius(peak),
            housing: celsius(point.housing_k),
        })
    };
    DayOfOperation { day: course.number, hours: (0..=HOURS).filter_map(hour).collect() }
}

/// Hours of a day.
const HOURS: u32 = 24;

fn laid(all: &[(&'static str, Word, Option<f64>, &'static Unit)], language: Language) -> Vec<Figure> {
    let figure = |(id, title, si, unit): &(&'static str, Word, Option<f64>, &'static Unit)| Figure {
        id,
        title: title(language).to_owned(),
        value: si.map(|si| Number::in_unit(si, unit)),
        unit: unit.json,
    };
    all.iter().map(figure).collect()
}

fn verdict(check: RunCheck, language: Language) -> SimulatedVerdict {
    let unit = check.id.unit();
    let limit = check.limit.as_ref();
    SimulatedVerdict {
        id: Id(check.id),
        title: simulation::run_check_against(&check, language),
        verdict: Id(check.verdict),
        value: Some(Number::in_unit(check.value, unit)),
        limit: limit.map(|limit| Number::in_unit(limit.value, unit)),
        unit: unit.json,
        grade: limit.map(|limit| Id(limit.grade)),
        source: limit.map(|limit| source_text(&limit.source, language)),
    }
}

/// Returns the figures of the cycle by the sizing beside those of the twin.
fn comparison(run: &Simulated<'_>, language: Language) -> Vec<Compared> {
    if run.scenario.id != ScenarioId::Cycle {
        return Vec::new();
    }
    let checks = &run.candidate.judgement.checks;
    let row = |(id, shown, why): &(CheckId, Shown, Word)| {
        let said = checks.iter().find(|check| check.id == *id)?.value?;
        Some(Compared {
            id: Id(*id),
            title: check_title(*id, language),
            sizing: Number(said.value()),
            twin: Number::in_unit(shown(&run.summary), said.unit),
            unit: said.unit.json,
            why: why(language).to_owned(),
        })
    };
    COMPARED.iter().filter_map(row).collect()
}

fn control_loop(each: &LoopResponse, language: Language) -> ControlLoop {
    let margins = &each.margins;
    ControlLoop {
        id: Id(each.of),
        title: simulation::loop_title(each.of, language),
        crossover: margins.crossover_hz.map(Number),
        phase_margin: margins.phase_rad.map(|phase| Number::in_unit(phase, &DEGREE)),
        gain_margin: margins.gain.map(|gain| Number(20.0 * gain.log10())),
        bandwidth: margins.bandwidth_hz.map(Number),
        stable: margins.stable,
    }
}

fn gains(gains: &Gains) -> Vec<Figure> {
    let all = [
        ("current_gain", "K_p,I", gains.current_p, "V/A"),
        ("current_time", "T_n,I", gains.current_time_s, "s"),
        ("speed_gain", "K_p,n", gains.speed_p, "N m s/rad"),
        ("speed_time", "T_n,n", gains.speed_time_s, "s"),
        ("speed_filter", "T_f", gains.speed_filter_s, "s"),
        ("position_gain", "K_v", gains.position_p, "1/s"),
        ("feed_forward_speed", "v_ff", gains.feed_speed, "1"),
        ("feed_forward_inertia", "J_ff", gains.feed_inertia, "kg m^2"),
    ];
    all.map(|(id, title, value, unit)| Figure { id, title: title.to_owned(), value: Some(Number(value)), unit }).into()
}

fn parameter(each: Parameter, language: Language) -> ModelParameter {
    let unit =
        each.dimension.units().iter().find(|unit| (unit.to_si(1.0) - 1.0).abs() < 1e-12 && unit.to_si(0.0) == 0.0);
    let unit = unit.or(each.dimension.units().first()).unwrap_or(&ONE);
    ModelParameter {
        key: each.key,
        title: parameter_title(each.key, language),
        value: each.value.as_ref().map(|value| Number::in_unit(value.value, unit)),
        unit: unit.json,
        grade: each.value.as_ref().map(|value| Id(value.grade)),
        source: each.value.as_ref().map(|value| source_text(&value.source, language)),
    }
}

fn parameter_title(key: &str, language: Language) -> String {
    let data: Option<Word> = match key {
        "ratio" => Some(simulation::data_ratio),
        "pole_pairs" => Some(simulation::data_pole_pairs),
        "torque_max" => Some(simulation::data_torque_max),
        "current_max" => Some(simulation::data_current_max),
        "current_demagnetisation" => Some(simulation::data_current_demagnetisation),
        "stall_torque" => Some(simulation::data_stall_torque),
        "stall_current" => Some(simulation::data_stall_current),
        "dc_link_max" => Some(simulation::data_dc_link_max),
        "collision_torque_max" => Some(simulation::data_collision_torque_max),
        "feedback_resolution" => Some(simulation::data_feedback_resolution),
        "housing_share" => Some(simulation::data_housing_share),
        "winding_warning" => Some(simulation::data_winding_warning),
        "winding_shutdown" => Some(simulation::data_winding_shutdown),
        "brake_opening_usual" => Some(simulation::data_brake_opening),
        "brake_closing_usual" => Some(simulation::data_brake_closing),
        _ => None,
    };
    if let Some(data) = data {
        return data(language).to_owned();
    }
    let label = project::input_label(&format!("twin.measured.{key}")).map(|label| schema_text(label, language));
    label.map_or_else(|| key.to_owned(), |label| short_label(&label))
}

fn notes(run: &Simulated<'_>, language: Language) -> Vec<String> {
    let mut notes = vec![simulation::band(language).to_owned()];
    if let Some(volt) = run.supply_assumed_v {
        notes.push(simulation::supply_assumed(&format_significant(volt, 3, language), language));
    }
    let is_stop =
        matches!(run.scenario.id, ScenarioId::PowerFailure | ScenarioId::EmergencyStop | ScenarioId::HangingLoad);
    if is_stop && run.summary.stop_s.is_none() {
        notes.push(simulation::stop_missing(language).to_owned());
    }
    let volt = |volt: f64| format_significant(volt, 3, language);
    if run.supply.most_v > run.supply.least_v {
        notes.push(simulation::supply_edges(&volt(run.supply.least_v), &volt(run.supply.most_v), language));
    }
    if run.supply_within() == Some(false) {
        notes.push(simulation::no_chopper_threshold(&volt(run.supply.most_v), language));
    }
    let actuator = &run.parameters.actuator;
    let both = actuator.current_max.known().zip(actuator.current_demagnetisation.known());
    if let Some((most, _)) = both.filter(|_| run.project.twin.switches.limits) {
        let most = format_significant(AMPERE.from_si(most.value.si()), 4, language);
        notes.push(simulation::setpoint_limit(&most, language));
    }
    if !run.left_out.is_empty() {
        notes.push(simulation::left_out(&run.left_out.join(", "), language));
    }
    let rule = if run.gains_stated { simulation::gains_stated } else { simulation::gains_rule };
    notes.push(rule(language).to_owned());
    notes
}

#[cfg(test)]
mod tests {
    use super::parameter_title;
    use quantities::Language;

    #[test]
    fn no_parameter_is_titled_by_its_key() {
        for (key, _) in twin::Parameters::keys() {
            for language in Language::ALL {
                let title = parameter_title(key, language);
                assert!(!title.contains('_') && title != key, "{key}: {title}");
            }
        }
    }
}
