//! The digital twin as a question.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::indexing_slicing, clippy::panic, reason = "a test may fail")]

use crate::simulated;

use quantities::Language;
use questions::list::{Given, Unanswered, simulate};
use simulated::simulated;
use std::borrow::Cow;

const TABLE: &str = include_str!("../../../../examples/indexing-table.toml");

fn message(why: &Unanswered) -> String {
    why.faults(None, Language::En).errors.iter().map(|fault| fault.message.clone()).collect::<Vec<_>>().join("; ")
}

const CODE: (&str, &str) = ("code", "CHA-25A-100-H-C1024");

/// The record has what its contract says, and sizing and twin agree on temperature and torque within a few per cent.
#[test]
fn a_cycle_is_summed_up_and_compared_with_the_sizing() {
    let (record, _) = simulated(TABLE, &[CODE]).unwrap();
    for part in ["summary", "events", "comparison", "verdicts", "loops", "gains", "parameters"] {
        assert!(!record[part].is_null(), "{part}: {record}");
    }
    let rows = record["comparison"].as_array().unwrap();
    let row = |id: &str| rows.iter().find(|row| row["id"] == id).unwrap();
    let thermal = row("thermal");
    let (sizing, twin) = (thermal["sizing"].as_f64().unwrap(), thermal["twin"].as_f64().unwrap());
    assert!((sizing - twin).abs() < 1.5, "{thermal}");
    assert!(rows.iter().all(|row| !row["why"].as_str().unwrap().is_empty()));
    let balance = record["summary"]["unaccounted"]["value"].as_f64().unwrap();
    assert!(balance.abs() < 1e-7, "{balance}");
    assert_eq!(record["cycles"], 1);
    let assumed = record["parameters"].as_array().unwrap().iter().filter(|each| each["grade"] == "assumed").count();
    assert!(assumed > 10, "{assumed}");
}

/// `[twin]` states scenario and measured values; what the call says comes first.
#[test]
fn the_project_states_scenario_gains_and_measured_values() {
    let text = format!(
        "{TABLE}\n[twin]\nscenario = \"emergency_stop\"\nat = \"0.15 s\"\nposition_gain = \"12 1/s\"\n[twin.measured]\nresistance_ll = \"2.5 ohm\"\n"
    );
    let (record, _) = simulated(&text, &[CODE]).unwrap();
    assert_eq!((&record["scenario"], &record["at"]), (&"emergency_stop".into(), &0.15.into()));
    assert_eq!(record["gains"]["position_gain"]["value"], 12.0);
    assert_eq!(record["gains_by_rule"], false);
    let resistance =
        record["parameters"].as_array().unwrap().iter().find(|each| each["key"] == "resistance_ll").unwrap().clone();
    assert_eq!((resistance["value"].as_f64(), resistance["grade"].as_str()), (Some(2.5), Some("published")));
    assert!(record["comparison"].as_array().unwrap().is_empty());
    let (other, _) = simulated(&text, &[CODE, ("scenario", "cycle")]).unwrap();
    assert_eq!(other["scenario"], "cycle");
}

/// A run that is impossible is refused with its reason.
#[test]
fn what_cannot_run_is_refused_with_its_reason() {
    let refused = |text: &str, pairs: &[(&str, &str)]| message(&simulated(text, pairs).unwrap_err());
    assert!(refused(TABLE, &[CODE, ("scenario", "brake_stuck")]).contains("brake"));
    assert!(refused(TABLE, &[CODE, ("scenario", "emergency_stop"), ("at", "9 s")]).contains("1.3"));
    assert!(refused(TABLE, &[CODE, ("cycles", "100000")]).contains("steps"));
    let unstable = format!("{TABLE}\n[twin]\ncurrent_gain = \"900 V/A\"\n");
    assert!(refused(&unstable, &[CODE]).contains("is unstable"));
    let joint = include_str!("../../../../examples/robot-joint.toml");
    assert!(!refused(joint, &[CODE]).is_empty());
    let wrong = format!("{TABLE}\n[twin]\nscenario = \"emergency\"\n");
    assert!(refused(&wrong, &[CODE]).contains("emergency"));
}

/// A refusal names the value of the file that causes it with its line; a value of the call has no line.
#[test]
fn a_refusal_stands_at_the_value_that_causes_it() {
    let place = |lines: &str, pairs: &[(&str, &str)]| {
        let text = format!("{TABLE}\n[twin]\n{lines}\n");
        let refused = simulated(&text, &[&[CODE], pairs].concat()).unwrap_err();
        let Unanswered::Text { faults, text, .. } = refused else { return None };
        let [fault] = faults.as_slice() else { panic!("{faults:?}") };
        assert_eq!(text.lines().nth(fault.line - 1).map(str::len), text[..fault.span.end].lines().last().map(str::len));
        Some((fault.id, text[fault.span.clone()].to_owned()))
    };
    let at = |id, written: &str| Some((id, written.to_owned()));
    for (lines, id, written) in [
        ("scenario = \"emergency_stop\"\nat = \"9 s\"", "scenario_after_the_end", "\"9 s\""),
        ("scenario = \"collision\"\nat = \"1 s\"", "scenario_at_rest", "\"1 s\""),
        ("scenario = \"brake_stuck\"", "scenario_without_brake", "\"brake_stuck\""),
        ("scenario = \"battery_loss\"", "scenario_without_battery", "\"battery_loss\""),
        ("scenario = \"encoder_failure\"\nfailure = \"error_bit\"", "failure_of_another_encoder", "\"error_bit\""),
        ("current_gain = \"900 V/A\"", "gain_unstable", "\"900 V/A\""),
        ("[twin.measured]\nchopper_off = 1.9", "wrong_order", "1.9"),
        ("[twin.measured]\nchopper_on = 1.01", "wrong_order", "1.01"),
        ("[twin.measured]\ngear_torque_1 = \"5000 N m\"", "wrong_order", "\"5000 N m\""),
        ("[twin.measured]\ngear_torque_2 = \"0.1 N m\"", "wrong_order", "\"0.1 N m\""),
    ] {
        assert_eq!(place(lines, &[]), at(id, written), "{lines}");
    }
    assert_eq!(place("cycles = 2", &[("scenario", "brake_stuck")]), None);
    let late = "scenario = \"emergency_stop\"\nat = \"0.1 s\"";
    assert_eq!(place(late, &[("at", "9 s")]), None);
}

/// Ten days of two shifts: temperatures of the settled cycle, energies in proportion; what does not fit is refused.
#[test]
fn days_of_operation_are_summed_up() {
    let of = |pairs: &[(&str, &str)]| simulated(TABLE, &[&[CODE], pairs].concat());
    let (record, _) = of(&[("days", "10"), ("hours-per-day", "16")]).unwrap();
    let figure = |id: &str| record["averaged"][id]["value"].as_f64().unwrap_or_else(|| panic!("{id}: {record}"));
    assert_eq!((figure("days"), figure("starts")), (10.0, 10.0));
    assert!((figure("operation") - 160.0).abs() < 1e-9);
    assert!((figure("cycles") * record["time"].as_f64().unwrap() / 3600.0 - 160.0).abs() < 1e-6);
    let warm = record["start"][0].as_f64().unwrap();
    assert!((figure("winding_peak") - warm).abs() < 0.5, "{} {warm}", figure("winding_peak"));
    assert!(figure("winding_swing") > 1.0 && figure("energy_supply") > figure("energy_copper"));
    let (always, _) = of(&[("days", "10")]).unwrap();
    let share = record["averaged"]["energy_supply"]["value"].as_f64().unwrap()
        / always["averaged"]["energy_supply"]["value"].as_f64().unwrap();
    assert!((share - 16.0 / 24.0).abs() < 0.02, "{share}");
    assert!(simulated(TABLE, &[CODE]).unwrap().0["averaged"].is_null());
    let refused = |pairs: &[(&str, &str)]| message(&of(pairs).unwrap_err());
    assert!(refused(&[("days", "10"), ("hours-per-day", "25")]).contains("24"));
    assert!(refused(&[("hours-per-day", "8")]).contains("--days"));
    assert!(refused(&[("days", "10"), ("scenario", "emergency_stop")]).contains("cycle"));
}

/// An actuator of the project whose winding is not stated cannot be simulated, and the answer names what is missing.
#[test]
fn a_missing_parameter_is_named() {
    let own = "\n[actuator]\nname = \"own\"\nratio = 100\ntorque_max = \"60 N m\"\n";
    let text = TABLE.to_owned() + own;
    let why = message(&simulated(&text, &[]).unwrap_err());
    assert!(why.contains("p is not known"), "{why}");
}

/// A failed encoder: what the drive notices and when, in figures and in words; what cannot be is refused.
#[test]
fn an_encoder_that_fails_is_answered_with_what_is_noticed() {
    let failure = |code: &str, more: &[(&str, &str)]| {
        let (code, scenario) = (("code", code), ("scenario", "encoder_failure"));
        simulated(TABLE, &[&[code, scenario], more].concat()).map(|(record, _)| record)
    };
    let record = failure("CHA-25A-100-H-M512P", &[("failure", "check")]).unwrap();
    let found = &record["encoder_failure"];
    assert_eq!((&found["failure"], &found["finding"]), (&"check".into(), &"check".into()), "{found}");
    let after = found["after"].as_f64().unwrap();
    assert!((0.05..0.7).contains(&after), "{found}");
    assert!(found["title"].as_str().unwrap().contains(" ms"), "{found}");
    assert!(record["events"].as_array().unwrap().iter().any(|event| event["event"] == "no_position"));
    assert!(simulated(TABLE, &[CODE]).unwrap().0["encoder_failure"].is_null());
    let stated = format!("{TABLE}\n[twin]\nscenario = \"encoder_failure\"\nfailure = \"amplitude\"\n");
    assert_eq!(simulated(&stated, &[CODE]).unwrap().0["encoder_failure"]["failure"], "amplitude");
    let refused = |found: Result<serde_json::Value, Unanswered>| message(&found.unwrap_err());
    assert!(refused(failure("CHA-25A-100-H-C1024", &[("failure", "check")])).contains("track, amplitude, cable"));
    let other = simulated(TABLE, &[CODE, ("failure", "track")]).map(|(record, _)| record);
    assert!(refused(other).contains("encoder_failure"));
    let lost = simulated(TABLE, &[("code", "CHA-17A-100-H-M128S"), ("scenario", "battery_loss")]).unwrap().0;
    assert_eq!(lost["encoder_failure"]["failure"], "battery");
    assert!(
        lost["encoder_failure"]["finding"].is_null() && lost["encoder_failure"]["error"].as_f64().unwrap() < -7000.0
    );
}

/// Every wrong option of a run at once.
#[test]
fn wrong_options_are_reported_together() {
    let wrong =
        [CODE, ("scenario", "collision"), ("every", "20 us"), ("at", "-1 s"), ("days", "3"), ("failure", "track")];
    let faults = simulated(TABLE, &wrong).unwrap_err().faults(None, Language::En).errors;
    let options: Vec<_> = faults.iter().filter_map(|fault| fault.option.as_deref()).collect();
    assert_eq!(options, ["every", "at", "days", "failure"], "{faults:?}");
    assert!(faults[0].message.contains("62.5"), "{faults:?}");
}

/// Signals are named with commas or one by one; every wrong name is refused at once, with the one that was probably meant.
#[test]
fn signals_are_named_and_wrong_names_are_refused_together() {
    let read = |pairs: &[(&'static str, &'static str)]| {
        let pairs = pairs.iter().map(|(name, value)| (Cow::Borrowed(*name), Cow::Borrowed(*value)));
        let given = Given::of(simulate::Args::ARGUMENTS, pairs, Language::En)?;
        simulate::Args::read(&given).map(|args| args.signals.iter().map(|signal| signal.id).collect::<Vec<_>>())
    };
    assert_eq!(read(&[]).unwrap(), Vec::<&str>::new());
    assert_eq!(read(&[("signals", "current_q, speed,current_q")]).unwrap(), ["current_q", "speed"]);
    assert_eq!(read(&[("signals", "torque"), ("signals", "link")]).unwrap(), ["torque", "link"]);
    let faults =
        read(&[("signals", "curent_q,speed,spede"), ("signals", "")]).unwrap_err().faults(None, Language::En).errors;
    assert_eq!(faults.len(), 3, "{faults:?}");
    assert!(faults[0].hint.as_deref().unwrap().contains("current_q"), "{faults:?}");
    assert!(faults[1].hint.as_deref().unwrap().contains("speed"), "{faults:?}");
    assert!(faults[2].hint.as_deref().unwrap().contains("winding"), "all names: {faults:?}");
}

/// The first and the last day of operation are listed hour by hour: warming in operation, cooling at rest, the largest
/// temperatures those of the figures.
#[test]
fn days_of_operation_are_listed_by_the_hour() {
    let (record, _) = simulated(TABLE, &[CODE, ("days", "3"), ("hours-per-day", "8h")]).unwrap();
    let days = record["days"].as_array().unwrap();
    assert_eq!(days.iter().map(|day| day["day"].as_u64().unwrap()).collect::<Vec<_>>(), [1, 3]);
    for day in days {
        let hours = day["hours"].as_array().unwrap();
        assert_eq!(hours.len(), 25);
        let of = |name: &str| hours.iter().map(|hour| hour[name].as_f64().unwrap()).collect::<Vec<_>>();
        let (winding, peak, housing) = (of("winding"), of("winding_peak"), of("housing"));
        assert!(winding.iter().zip(&peak).all(|(mean, peak)| peak >= mean), "{day}");
        assert!(housing[1] > housing[0] + 0.5 && housing[8] >= housing[7] && housing[9] < housing[8], "{day}");
        let highest = record["averaged"]["housing_peak"]["value"].as_f64().unwrap();
        assert!((housing[8] - highest).abs() < 0.5, "{day} {highest}");
    }
    let (single, _) = simulated(TABLE, &[CODE, ("days", "1")]).unwrap();
    assert_eq!(single["days"].as_array().unwrap().len(), 1);
    let (none, _) = simulated(TABLE, &[CODE]).unwrap();
    assert_eq!(none["days"].as_array().unwrap().len(), 0);
}
