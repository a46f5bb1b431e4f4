//! Properties that hold for every ordering code.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use catalogue::Topic;
use installation::calendar::{Interval, read_date};
use installation::fit::{Bore, FitKind, Side, read_bore};
use installation::joint::LoadCase;
use installation::mount::{MountInputs, mount};
use installation::upkeep::{Storage, Task, UpkeepInputs, upkeep};
use installation::wiring::{Absent, wiring};
use order_code::{Brake, OrderCode};
use quantities::unit::HOUR;
use quantities::{Measure, Time};

fn codes() -> impl Iterator<Item = &'static OrderCode> {
    configurator::all().iter().map(|(code, _)| code)
}

#[test]
fn every_code_with_data_can_be_mounted_and_no_other() {
    let mut with_data = 0;
    for code in codes() {
        let found = mount(code, &MountInputs::default());
        assert_eq!(found.is_some(), configurator::parameters(code).is_some(), "{code}");
        let Some(found) = found else { continue };
        with_data += 1;
        assert_eq!((found.fits.len(), found.joints.len()), (2, 2), "{code}");
        assert!(found.runouts.iter().all(|(_, value)| value.known().is_some()), "{code}");
        assert!(found.plate.is_some() && found.protection.is_some() && found.hollow_shaft.known().is_some(), "{code}");
        let differs = !configurator::uncovered(code).is_empty();
        assert!(differs || (found.length.known().is_some() && found.mass.known().is_some()), "{code}");
        // No mass printed, no word on lifting gear.
        assert_eq!(found.hoist.is_some(), found.mass.known().is_some(), "{code}");
        let stated = found.facts.iter().any(|fact| fact.id == "hoist_above_20_kg");
        assert_eq!(stated, found.hoist != Some(false), "{code}");
    }
    assert!(with_data > 900, "{with_data}");
}

/// The winding sensors in the parameters of an actuator are those with contacts at its connectors.
#[test]
fn the_sensors_of_the_winding_are_those_that_the_connectors_lead_out() {
    let mut found = std::collections::BTreeSet::new();
    for code in codes() {
        let (Some(wiring), Some(actuator)) = (wiring(code), configurator::parameters(code)) else { continue };
        // Where no pins of the motor are printed, nothing is said of the PTC.
        let is_absent = |what| wiring.absences.iter().any(|absence| absence.what == what);
        if is_absent(Absent::MotorPins) {
            continue;
        }
        let has_ptc = actuator.ptc_response.known().is_some();
        assert_eq!(actuator.without_kty, is_absent(Absent::Kty), "{code}");
        assert_eq!(has_ptc, !is_absent(Absent::Ptc), "{code}");
        found.insert((actuator.without_kty, has_ptc));
    }
    assert_eq!(found.into_iter().collect::<Vec<_>>(), [(false, false), (false, true), (true, true)]);
}

/// The clearances span both tolerances for any bore, and determine the kind of fit.
#[test]
fn clearances_span_both_tolerances() {
    let bores = ["H7", "K7", "N7", "+0.012/-0.003 mm"].map(|text| read_bore(text).unwrap());
    for code in codes().filter(|code| configurator::parameters(code).is_some()) {
        for bore in [None, Some(bores[0]), Some(bores[1]), Some(bores[2]), Some(bores[3])] {
            let asked = MountInputs { bore_load: bore, bore_housing: bore, ..MountInputs::default() };
            for fit in mount(code, &asked).unwrap().fits {
                let (pilot, bore_limits) = (fit.pilot.value, fit.bore_deviations);
                let width = (pilot.upper - pilot.lower + bore_limits.upper - bore_limits.lower).si();
                assert!(((fit.clearance_max - fit.clearance_min).si() - width).abs() < 1e-12, "{code}");
                let kind = match bore {
                    None | Some(Bore::Zone("H7")) => FitKind::Clearance,
                    _ => FitKind::Transition,
                };
                assert_eq!(fit.kind, kind, "{code} {bore:?}");
                assert_eq!(fit.pilot_zone, "h7", "{code}");
            }
        }
    }
}

/// Domain notes of table 79.1: the transmissible torques exceed T_max everywhere. The estimate never helps the joint.
#[test]
fn every_joint_carries_the_peak_torque() {
    for code in codes() {
        let Some(found) = mount(code, &MountInputs::default()) else { continue };
        for joint in &found.joints {
            assert!(joint.clamp_force.known().unwrap().value.si() > 1000.0, "{code}");
            let cases: Vec<LoadCase> = joint.cases.iter().map(|case| case.case).collect();
            assert_eq!(cases.contains(&LoadCase::Brake), code.brake == Brake::With, "{code}");
            for case in &joint.cases {
                let together = &case.together;
                if case.case == LoadCase::StaticMoment {
                    // By hand 2 µ M_0/T_trans = 0.3 · 603/177 = 1.02 at the housing of 20A, less than one everywhere else.
                    let opens = together.known().unwrap().value.relieved.si() >= 1.0;
                    assert_eq!(opens, code.size.as_str() == "20A" && joint.side == Side::Housing, "{code}");
                    assert!(case.alone.known().is_none(), "{code}");
                    continue;
                }
                let Some(alone) = case.alone.known() else {
                    assert!(case.case == LoadCase::Collision && together.known().is_none(), "{code} {:?}", case.case);
                    continue;
                };
                assert!(alone.value.si() > 0.0 && alone.value.si() < 1.0, "{code} {:?}: {:?}", case.case, alone.value);
                let slip = together.known().unwrap().value.slip.unwrap();
                assert!(slip.si() > alone.value.si(), "{code} {:?}", case.case);
            }
        }
        let sides: Vec<Side> = found.joints.iter().map(|joint| joint.side).collect();
        assert_eq!(sides, [Side::Load, Side::Housing]);
    }
}

fn asked() -> UpkeepInputs {
    UpkeepInputs {
        delivered: read_date("2026-03-01").unwrap(),
        storage: Some(Storage::For(Interval::Months(6))),
        hours_per_day: Some(Time::new_in(10.0, &HOUR)),
        inspect: Some(Interval::Months(6)),
        today: None,
    }
}

#[test]
fn every_code_has_a_plan_by_date_and_encoders_with_a_battery_their_exchange() {
    for code in codes() {
        let found = upkeep(code, &asked()).unwrap();
        assert!(found.plan.windows(2).all(|pair| pair[0].next <= pair[1].next), "{code}");
        assert!(found.storage_permitted && found.in_service == read_date("2026-09-01").unwrap(), "{code}");
        let date = |task: Task| found.plan.iter().find(|line| line.task == task).map(|line| line.next.to_string());
        assert_eq!(date(Task::StorageEnd), None, "{code}: in service");
        for task in [Task::Cleaning, Task::Cables, Task::ProtectiveEarth, Task::Screws, Task::Seals] {
            assert_eq!(date(task).as_deref(), Some("2027-03-01"), "{code} {task:?}");
        }
        let battery = code.feedback.as_str() == "M128S";
        assert_eq!(date(Task::EncoderRecommended).as_deref(), battery.then_some("2032-03-01"), "{code}");
        assert_eq!(date(Task::EncoderLatest).as_deref(), battery.then_some("2036-03-01"), "{code}");
        assert_eq!(found.battery.known().is_some(), battery, "{code}");
        let lithium = [&found.storage, &found.service, &found.disposal];
        for facts in lithium {
            assert_eq!(facts.iter().any(|fact| fact.en.contains("battery")), battery, "{code}");
        }
    }
}

/// Before the connections are parted stand the five safety rules; the drive is off before the main switch.
#[test]
fn shutting_down_has_its_order() {
    let code = order_code::parse("CHA-25A-100-H-M512P-B").unwrap().code;
    let found = upkeep(&code, &asked()).unwrap();
    let ids: Vec<&str> = found.shutdown.iter().map(|fact| fact.id).collect();
    let place = |id: &str| ids.iter().position(|known| *known == id).unwrap_or_else(|| panic!("{id}: {ids:?}"));
    let order = [
        "shutdown_stop_under_control",
        "shutdown_drive_off",
        "shutdown_main_switch",
        "shutdown_secure",
        "isolate_before_work",
        "shutdown_discharge",
        "shutdown_cool_down",
        "shutdown_secure_the_actuator",
    ];
    assert!(order.windows(2).all(|pair| place(pair[0]) < place(pair[1])), "{ids:?}");
    assert!(!ids.iter().any(|id| id.contains("fan")));
}

#[test]
fn a_storage_longer_than_two_years_is_reported() {
    let code = order_code::parse("CHA-14A-50-E-M128S").unwrap().code;
    let stored = |storage| upkeep(&code, &UpkeepInputs { storage: Some(storage), ..asked() });
    assert!(stored(Storage::For(Interval::Months(24))).unwrap().storage_permitted);
    assert!(!stored(Storage::Until(read_date("2028-03-02").unwrap())).unwrap().storage_permitted);
    assert!(stored(Storage::Until(read_date("2026-02-28").unwrap())).is_err());
    // The model of the battery ends at three years of storage.
    assert!(stored(Storage::For(Interval::Months(48))).is_err());
}

/// The figures of the plan are those of the facts: six and ten years from the delivery, whatever the storage.
#[test]
fn today_moves_the_series_and_marks_what_has_passed() {
    let code = order_code::parse("CHA-14A-50-E-M128S").unwrap().code;
    let today = read_date("2033-01-15").unwrap();
    let found = upkeep(&code, &UpkeepInputs { today: Some(today), ..asked() }).unwrap();
    for line in &found.plan {
        assert_eq!(line.passed, line.next < today, "{:?}", line.task);
        let is_series = line.interval.is_some();
        assert!(!is_series || (line.next >= today && line.first < today), "{:?}", line.task);
    }
    let passed: Vec<Task> = found.plan.iter().filter(|line| line.passed).map(|line| line.task).collect();
    assert_eq!(passed, [Task::EncoderRecommended]);
}

/// The end of the storage is a date while the actuator is stored, or if the plan exceeds it: none in service, nor where service
/// begins on delivery.
#[test]
fn the_storage_ends_for_what_is_stored_alone() {
    let code = order_code::parse("CHA-25A-100-H-M512P").unwrap().code;
    let has = |storage: Option<Storage>, today: Option<&str>| {
        let today = today.map(|text| read_date(text).unwrap());
        let found = upkeep(&code, &UpkeepInputs { storage, today, ..asked() }).unwrap();
        found.plan.iter().any(|line| line.task == Task::StorageEnd)
    };
    // Delivered on 2026-03-01, in service from 2026-09-01 on.
    let stored = asked().storage;
    assert!(has(stored, Some("2026-08-31")) && !has(stored, None));
    let too_long = Some(Storage::Until(read_date("2028-03-02").unwrap()));
    assert!(has(too_long, None) && has(too_long, Some("2028-03-01")) && !has(too_long, Some("2028-03-02")));
    assert!(!has(stored, Some("2026-09-01")) && !has(None, None) && !has(None, Some("2026-03-01")));
}

/// The connectors of a code have pins for the KTY, PTC, brake or output encoder named by a list, a record, an object or
/// a fact, and each signal of the pins is named by one of these.
#[test]
fn the_commissioning_speaks_of_what_the_wiring_has() {
    use installation::commission::expected::Measurand;
    use installation::commission::recorded::{MeasuredValues, Unjudged, judge};
    use installation::commission::sinamics::{self, ParameterChoice, Setting};
    use installation::commission::{ParameterId, checklist, commission};
    use installation::facts::{Order, facts_about};
    use installation::wiring::{Role, SignalGroup};
    use quantities::ThermodynamicTemperature;
    use quantities::unit::DEGREE_CELSIUS;

    let ambient = ThermodynamicTemperature::new_in(20.0, &DEGREE_CELSIUS);
    let (mut with_kty, mut without_kty) = (0, 0);
    for code in codes() {
        let (Some(wiring), Some(about)) = (wiring(code), commission(code)) else { continue };
        let is_absent = |what| wiring.absences.iter().any(|absence| absence.what == what);
        if is_absent(Absent::MotorPins) {
            continue;
        }
        let pins = wiring.connectors.iter().flat_map(|connector| &connector.pins);
        let groups: Vec<SignalGroup> = pins.filter_map(|pin| Some(pin.carries?.group())).collect();
        let is_wired = |group| groups.contains(&group);
        let items: Vec<checklist::ChecklistItem> =
            checklist::lists(&about, ambient).into_iter().flat_map(|list| list.items).collect();
        let is_measured = |what| {
            items
                .iter()
                .any(|item| matches!(item, checklist::ChecklistItem::Measure { expected, .. } if expected.what == what))
        };
        let facts = facts_about(Topic::Commission, code, Order::Data);
        let speaks = |word: &str| facts.iter().any(|fact| fact.en.contains(word));
        let is_set = |choice| sinamics::lines(&about).iter().any(|line| line.entry.setting == Setting::Choice(choice));
        let is_judged = |what| {
            let judged = judge(&about, &MeasuredValues::default());
            judged.iter().any(|each| each.what == what && each.unjudged != Some(Unjudged::NotThere))
        };

        let kty = is_wired(SignalGroup::Kty);
        *(if kty { &mut with_kty } else { &mut without_kty }) += 1;
        assert_eq!(about.has_kty(), kty, "{code}");
        assert_eq!(is_measured(Measurand::Kty), kty, "{code}");
        assert_eq!(is_judged(Measurand::Kty), kty, "{code}");
        assert_eq!(speaks("KTY"), kty, "{code}");
        assert_eq!(
            (is_set(ParameterChoice::SensorAtEncoder), is_set(ParameterChoice::SensorKty)),
            (kty, kty),
            "{code}"
        );
        for threshold in [ParameterId::WindingWarning, ParameterId::WindingShutdown] {
            assert_eq!(about.get(threshold).is_some(), kty, "{code}");
        }
        let ptc = is_wired(SignalGroup::Ptc);
        assert_eq!(
            (about.has_ptc(), is_measured(Measurand::Ptc), is_judged(Measurand::Ptc)),
            (ptc, ptc, ptc),
            "{code}"
        );
        assert_eq!(speaks("PTC"), ptc, "{code}");
        // Pins of the brake are there for every motor connector; what is connected the code says.
        let brake = code.brake == Brake::With;
        assert_eq!(is_absent(Absent::Brake), !brake, "{code}");
        assert!(!brake || is_wired(SignalGroup::Brake), "{code}");
        assert_eq!(
            (is_measured(Measurand::BrakeVoltage), is_judged(Measurand::BrakeVoltage)),
            (brake, brake),
            "{code}"
        );
        assert_eq!(about.get(ParameterId::BrakeVoltage).is_some(), brake, "{code}");
        let output = wiring.connector(Role::OutputEncoder).is_some();
        assert_eq!(facts.iter().any(|fact| fact.id == "position_out_rises_clockwise"), output, "{code}");
        let side = installation::commission::encoder::EncoderSide::Output;
        assert_eq!(about.encoder.iter().any(|row| row.side == side), output, "{code}");
        // The absolute feedbacks have their word, and no other has.
        let absolute = wiring.connector(Role::Feedback).is_some_and(|connector| {
            connector.pins.iter().any(|pin| pin.carries.is_some_and(|signal| signal.group() == SignalGroup::Serial))
        });
        assert_eq!(about.get(ParameterId::EncoderTurns).is_some(), absolute, "{code}");
        assert!(about.get(ParameterId::EncoderLines).is_some(), "{code}");
    }
    assert!(with_kty > 900 && without_kty > 0, "{with_kty} {without_kty}");
}

#[test]
fn every_fact_on_mounting_and_upkeep_is_shown_for_some_code() {
    let with_data: Vec<&OrderCode> = codes().filter(|code| configurator::parameters(code).is_some()).collect();
    let mut shown: Vec<&str> = Vec::new();
    for code in with_data {
        let plan = upkeep(code, &asked()).unwrap();
        let of_plan = [plan.storage, plan.service, plan.shutdown, plan.disposal].concat();
        for fact in mount(code, &MountInputs::default()).unwrap().facts.iter().chain(&of_plan) {
            if !shown.contains(&fact.id) {
                shown.push(fact.id);
            }
        }
    }
    for fact in catalogue::facts() {
        let ours = [Topic::Mount, Topic::Upkeep].iter().any(|topic| fact.topics.contains(topic));
        assert!(!ours || shown.contains(&fact.id), "{}", fact.id);
    }
}

/// The built-in brake is never called safe.
#[test]
fn no_fact_calls_the_brake_safe() {
    for fact in catalogue::facts().iter().filter(|fact| fact.en.contains("brake") && fact.en.contains("safe")) {
        assert!(fact.en.contains("not functionally safe"), "{}: {}", fact.id, fact.en);
        assert!(fact.de.contains("nicht funktional sicher"), "{}: {}", fact.id, fact.de);
    }
}
