//! The values for a drive are those of the printed motor, for every code; wrong measurements are found.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, reason = "a test fails loudly")]

use catalogue::{LifeStep, Topic};
use installation::commission::checklist::{self, ChecklistItem};
use installation::commission::cia402::{self, Rounding};
use installation::commission::expected::Measurand;
use installation::commission::recorded::{
    Cause, Counting, Judged, MeasuredValues, MeasurementVerdict, NoLoad, Turn, Unjudged, judge,
};
use installation::commission::{Commissioning, Gap, ParameterId, commission, sinamics};
use installation::facts::{Order, facts_about};
use order_code::OrderCode;
use quantities::unit::{DEGREE_CELSIUS, REVOLUTION_PER_MINUTE};
use quantities::{
    AngularVelocity, ElectricCurrent, ElectricPotential, ElectricalResistance, Frequency, Inductance, Measure,
    ThermodynamicTemperature, Time,
};

/// Returns every code that can exist and for which the manual prints data.
fn all() -> Vec<Commissioning> {
    configurator::all().iter().filter_map(|(code, _)| commission(code)).collect()
}

fn code(text: &str) -> OrderCode {
    order_code::parse(text).unwrap().code
}

fn of(text: &str) -> Commissioning {
    commission(&code(text)).unwrap()
}

fn si(about: &Commissioning, id: ParameterId) -> f64 {
    about.get(id).unwrap_or_else(|| panic!("{}: {id:?}", about.code)).si
}

/// Returns the numbers of the list as a drive would get them, printed and read again.
fn read_back(about: &Commissioning, number: u16) -> f64 {
    let lines = sinamics::lines(about);
    let line =
        lines.iter().find(|line| line.entry.number == number).unwrap_or_else(|| panic!("{} p{number}", about.code));
    line.value.to_string().parse().unwrap()
}

fn same(one: f64, other: f64) -> bool {
    (one / other - 1.0).abs() < 1e-12
}

#[test]
fn every_code_with_data_has_a_list_that_reads_back_as_the_same_motor() {
    let all = all();
    assert!(all.len() > 900, "{}", all.len());
    let turn = std::f64::consts::TAU;
    for about in &all {
        let back = |number| read_back(about, number);
        let actuator = &about.actuator;
        let printed = |found: Option<f64>| found.unwrap_or_else(|| panic!("{}", about.code));
        let r_ll = printed(actuator.resistance_ll.known().map(|known| known.value.si()));
        let l_ll = printed(actuator.inductance_ll.known().map(|known| known.value.si()));
        let k = printed(actuator.torque_constant_motor.known().map(|known| known.value.si()));
        let p = printed(actuator.pole_pairs.known().map(|known| known.value));
        let n = printed(actuator.speed_motor_rated.known().map(|known| known.value.si()));
        let n_max = printed(actuator.speed_motor_max.known().map(|known| known.value.si()));
        let i_max = printed(actuator.current_max.known().map(|known| known.value.si()));
        assert!(same(2.0 * back(350), r_ll), "{}", about.code);
        assert!(same(2.0 * back(356) * 1e-3, l_ll) && same(back(357), back(356)), "{}", about.code);
        assert!(same(back(316), k) && same(back(314), p), "{}", about.code);
        assert!(same(back(311) * turn / 60.0, n) && same(back(322) * turn / 60.0, n_max), "{}", about.code);
        assert!(same(back(310) * 60.0 / back(314), back(311)), "{}", about.code);
        assert!(back(323) <= i_max * (1.0 + 1e-12) && same(back(323), back(640)), "{}", about.code);
        let i_e = actuator.current_demagnetisation.known().map(|known| known.value.si());
        assert!(i_e.is_none_or(|i_e| back(323) <= i_e * (1.0 + 1e-12)), "{}", about.code);
        let thresholds = [600, 601, 604, 605].map(|number| {
            sinamics::lines(about).iter().find(|line| line.entry.number == number).map(|line| line.value)
        });
        let set = if about.has_kty() { [1.0, 2.0, 80.0, 90.0].map(Some) } else { [None; 4] };
        assert_eq!(thresholds, set, "{}", about.code);
        // p0300 synchronous, k_EM, I_0, k_TM I_0; the counts of the encoder as tables 57.1 to 61.1 print them.
        let (k_em, i_0) = (actuator.voltage_constant_motor.known().unwrap(), actuator.stall_current.known().unwrap());
        assert!(same(back(300), 2.0) && same(back(317), k_em.value.si() * 1000.0 * turn / 60.0), "{}", about.code);
        assert!(same(back(318), i_0.value.si()) && same(back(319), back(316) * back(318)), "{}", about.code);
        let (kind, lines, absolute) = match about.code.feedback.as_str() {
            "C1024" => (9999.0, 1024.0, None),
            "M512P" => (10_100.0, 512.0, Some((4096.0, 8192.0))),
            "M128S" => (9999.0, 128.0, Some((4096.0, 131_072.0))),
            "D2048" => (9999.0, 2048.0, None),
            _ => (9999.0, 1.0, None),
        };
        assert!(same(back(400), kind) && same(back(408), lines), "{}", about.code);
        let line =
            |number| sinamics::lines(about).iter().find(|line| line.entry.number == number).map(|line| line.value);
        assert_eq!(line(421).zip(line(423)), absolute, "{}", about.code);
    }
}

/// The inertia of the motor, against the other one at the output: J_out = J i², both printed with two to three digits.
#[test]
fn the_inertia_is_that_of_the_ordered_variant() {
    let with = read_back(&of("CHA-20A-100-H-M512P-B"), 341);
    let without = read_back(&of("CHA-20A-100-H-M512P"), 341);
    // Table 38.2: 2,60 and 2,32 in 1e-4 kgm².
    assert!((with - 2.60e-4).abs() < 1e-16 && (without - 2.32e-4).abs() < 1e-16, "{with} {without}");
    for about in &all() {
        let out = about.actuator.inertia_out.known().unwrap().value.si();
        let reduced = out / si(about, ParameterId::ReductionRatio).powi(2);
        let share = read_back(about, 341) / reduced;
        assert!((0.9..1.1).contains(&share), "{}: {share}", about.code);
    }
}

#[test]
fn objects_are_whole_numbers_off_by_no_more_than_their_rounding() {
    for about in &all() {
        let objects = cia402::objects(about);
        // The polarity where the manual says which way the position rises: not for the resolver.
        let resolver = about.code.feedback.as_str() == "RES";
        assert_eq!(objects.len(), if resolver { 9 } else { 10 }, "{}", about.code);
        assert_eq!(about.gaps.contains(&Gap::Counting), resolver, "{}", about.code);
        let polarity = objects.iter().find(|object| object.index == 0x607E);
        assert_eq!(polarity.map(|object| (object.value, object.facts.len())), (!resolver).then_some((0xC0, 2)));
        assert!(objects.is_sorted_by_key(|object| (object.index, object.sub)), "{}", about.code);
        for object in &objects {
            let error = object.exact - f64::from(object.value);
            let fine = match object.rounding {
                Rounding::Nearest => error.abs() <= 0.5,
                Rounding::Down => (0.0..1.0).contains(&error),
            };
            assert!(fine && object.value > 0, "{}: {object:?}", about.code);
        }
        let value = |index| f64::from(objects.iter().find(|object| object.index == index).unwrap().value);
        // Read back: printed currents have a tenth of an ampere, so a milliampere loses nothing.
        assert!(same(value(0x6075) / 1000.0, si(about, ParameterId::StallCurrent)), "{}", about.code);
        let torque = si(about, ParameterId::TorqueConstantMotor) * si(about, ParameterId::StallCurrent);
        assert!((value(0x6076) / 1000.0 - torque).abs() <= 0.5e-3, "{}", about.code);
        let limit = value(0x6073) / 1000.0 * value(0x6075) / 1000.0;
        let exact = si(about, ParameterId::CurrentLimit);
        assert!(limit <= exact * (1.0 + 1e-12) && exact - limit < 1e-3 * si(about, ParameterId::StallCurrent) * 1.001);
        assert!(same(value(0x6080) * std::f64::consts::TAU / 60.0, si(about, ParameterId::SpeedMotorMax)));
    }
}

#[test]
fn documents_of_the_forms_are_known() {
    let objects = cia402::objects(&of("CHA-20A-100-H-M512P-B"));
    let documents =
        sinamics::ENTRIES.iter().map(|entry| entry.document).chain(objects.iter().map(|each| each.document));
    for document in documents {
        assert!(catalogue::document(document).is_some(), "{document}");
    }
}

#[test]
fn what_is_not_printed_is_a_gap_and_nothing_is_both() {
    for about in &all() {
        let gaps = &about.gaps;
        for &id in ParameterId::ALL {
            let known = about.get(id).is_some();
            let open = gaps.contains(&Gap::NotPrinted(id));
            assert!(!(known && open), "{}: {id:?}", about.code);
            let brake = id.id().starts_with("brake_");
            let absent = match id {
                ParameterId::WindingWarning | ParameterId::WindingShutdown => !about.has_kty(),
                ParameterId::EncoderPositions | ParameterId::EncoderTurns => {
                    !matches!(about.code.feedback.as_str(), "M512P" | "M128S")
                }
                _ => brake && !about.has_brake(),
            };
            assert!(known || open || absent, "{}: {id:?} is stated nowhere", about.code);
        }
        assert!(gaps.contains(&Gap::RatedPoint));
    }
    // Table 14.1 has a dash for I_E, table 15.2 for the current that opens.
    let small = of("CHA-14A-50-E-M128S-B");
    assert!(small.gaps.contains(&Gap::NotPrinted(ParameterId::CurrentDemagnetisation)));
    assert!(small.gaps.contains(&Gap::NotPrinted(ParameterId::BrakeOpeningCurrent)));
}

#[test]
fn every_list_of_every_code_has_prose_and_figures() {
    let ambient = celsius(20.0);
    for about in &all() {
        let lists = checklist::lists(about, ambient);
        assert_eq!(lists.iter().map(|list| list.step).collect::<Vec<_>>(), checklist::STEPS);
        for list in &lists {
            let facts = list.items.iter().filter(|item| matches!(item, ChecklistItem::Fact(_))).count();
            assert!(facts > 1 && list.items.len() > facts, "{} {:?}", about.code, list.step);
        }
        let brake = |list: &checklist::CheckList| {
            list.items
                .iter()
                .any(|item| matches!(item, ChecklistItem::Measure { expected, .. } if expected.what == Measurand::BrakeVoltage))
        };
        assert_eq!(lists.first().is_some_and(brake), about.has_brake(), "{}", about.code);
    }
    let (speed, time) = checklist::test_run().unwrap();
    assert!((speed.in_unit(&REVOLUTION_PER_MINUTE) - 1000.0).abs() < 1e-9 && (time.si() - 300.0).abs() < 1e-9);
}

/// A fact of the commissioning is shown for some code, at a step with a list or among the rest.
#[test]
fn every_fact_of_the_commissioning_holds_for_some_code() {
    let all = all();
    let mut count = 0;
    for fact in catalogue::facts().iter().filter(|fact| fact.topics.contains(&Topic::Commission)) {
        count += 1;
        let shown = |about: &Commissioning| {
            facts_about(Topic::Commission, &about.code, Order::Data).iter().any(|f| f.id == fact.id)
        };
        assert!(all.iter().any(shown), "{}", fact.id);
    }
    assert!(count >= 30, "{count}");
    let at = |step| catalogue::facts().iter().filter(|fact| fact.step == Some(step)).count();
    assert!(at(LifeStep::BeforePower) > 8 && at(LifeStep::FirstMotion) > 6 && at(LifeStep::AfterADay) >= 2);
}

#[test]
fn no_fact_calls_the_built_in_brake_safe() {
    for fact in catalogue::facts().iter().filter(|fact| fact.en.contains("brake")) {
        let says = |text: &str, word: &str, not: &[&str]| {
            text.to_lowercase().contains(word) && !not.iter().any(|not| text.to_lowercase().contains(not))
        };
        assert!(!says(fact.en, " safe", &["not functionally safe", "no safety function"]), "{}", fact.en);
        assert!(
            !says(fact.de, "sicher", &["nicht funktional sicher", "keine sicherheitsfunktion", "sichern"]),
            "{}",
            fact.de
        );
    }
}

fn celsius(value: f64) -> ThermodynamicTemperature {
    ThermodynamicTemperature::new_in(value, &DEGREE_CELSIUS)
}

fn rpm(value: f64) -> AngularVelocity {
    AngularVelocity::new_in(value, &REVOLUTION_PER_MINUTE)
}

fn q<Q: Measure>(si: f64) -> Q {
    Q::from_si(si)
}

/// Returns a record in which everything is as it should be, computed here from the printed values.
fn healthy(about: &Commissioning) -> MeasuredValues {
    let (warm, i) = (31.0, si(about, ParameterId::ReductionRatio));
    let speed_out = 1000.0 / i;
    let constant = si(about, ParameterId::NoLoadCurrentConstant30) * std::f64::consts::TAU / 60.0;
    let brake = |id| about.get(id).map(|parameter| parameter.si);
    MeasuredValues {
        winding_temperature: Some(celsius(warm)),
        resistance_ll: Some(q(si(about, ParameterId::ResistanceLl) * (1.0 + 3.93e-3 * (warm - 20.0)))),
        inductance_ll: Some(q(si(about, ParameterId::InductanceLl) * 1.1)),
        emf: Some((q(si(about, ParameterId::VoltageConstant) * rpm(1000.0).si()), rpm(-1000.0))),
        sensor_temperature: Some(celsius(25.0)),
        kty: about.has_kty().then(|| q(603.0)),
        ptc: about.has_ptc().then(|| q(90.0)),
        brake_voltage: brake(ParameterId::BrakeVoltage).map(|volt| q(volt * 1.05)),
        brake_opening_current: brake(ParameterId::BrakeOpeningCurrent).map(|ampere| q(ampere * 0.9)),
        brake_holding_current: brake(ParameterId::BrakeHoldingCurrent).map(q),
        brake_opening_time: brake(ParameterId::BrakeOpeningTime).map(q),
        brake_closing_time: brake(ParameterId::BrakeClosingTime).map(q),
        direction_motor: Some(Turn::Clockwise),
        direction_flange: Some(Turn::CounterClockwise),
        position: Some(Counting::Rising),
        speed_motor: Some(rpm(1000.0)),
        speed_flange: Some(rpm(-speed_out)),
        electrical_frequency: Some(q(si(about, ParameterId::PolePairs) * 1000.0 / 60.0)),
        no_load: vec![NoLoad {
            speed_out: rpm(speed_out),
            current: q(si(about, ParameterId::NoLoadStartingCurrent) + constant * speed_out),
            temperature: celsius(30.0),
        }],
    }
}

#[test]
fn a_healthy_actuator_passes_whatever_its_code() {
    for about in &all() {
        for judged in judge(about, &healthy(about)) {
            let open = match judged.unjudged {
                Some(Unjudged::NotThere) => {
                    matches!(judged.what, Measurand::Ptc | Measurand::Kty) || !about.has_brake()
                }
                Some(Unjudged::NotStated) => judged.what == Measurand::DirectionPosition,
                Some(Unjudged::NotMeasured) => judged.what.id().starts_with("brake_"),
                None => false,
            };
            let fine = judged.verdict == MeasurementVerdict::Pass
                || (judged.verdict == MeasurementVerdict::NotChecked && open);
            assert!(fine && judged.cause.is_none(), "{}: {judged:?}", about.code);
        }
    }
}

#[test]
fn what_is_not_in_the_record_is_not_checked() {
    let about = of("CHA-25A-100-H-M512P-B");
    let judged = judge(&about, &MeasuredValues::default());
    assert_eq!(judged.len(), Measurand::ALL.len());
    assert!(judged.iter().all(|each| each.verdict == MeasurementVerdict::NotChecked && each.unjudged.is_some()));
}

/// Judges a record with one fault planted and gives back the entry of the measurand.
fn planted(about: &Commissioning, what: Measurand, plant: impl Fn(&mut MeasuredValues)) -> Judged {
    let mut measured = healthy(about);
    plant(&mut measured);
    let judged = judge(about, &measured);
    judged.into_iter().find(|judged| judged.what == what).unwrap()
}

fn found(
    about: &Commissioning,
    what: Measurand,
    plant: impl Fn(&mut MeasuredValues),
) -> (MeasurementVerdict, Option<&'static str>) {
    let judged = planted(about, what, plant);
    (judged.verdict, judged.cause.map(|cause| cause.id()))
}

fn fails(cause: &'static str) -> (MeasurementVerdict, Option<&'static str>) {
    (MeasurementVerdict::Fail, Some(cause))
}

#[test]
fn a_resistance_that_is_off_has_its_cause() {
    let about = of("CHA-20A-100-H-M512P-B");
    let times = |factor: f64| {
        found(&about, Measurand::ResistanceLl, move |measured| {
            measured.resistance_ll = measured.resistance_ll.map(|ohm: ElectricalResistance| q(ohm.si() * factor));
        })
    };
    assert_eq!(times(0.5), fails("one_phase"));
    assert_eq!(times(2.0), fails("doubled"));
    assert_eq!(times(0.75), fails("terminals_joined"));
    assert_eq!(times(0.01), fails("short"));
    assert_eq!(times(1e4), fails("open"));
    // Measured hot, at 100 °C, and recorded as 31 °C: R is 26 % too large. 5.9 Ω, so no lead explains it.
    let hot = planted(&about, Measurand::ResistanceLl, |measured| {
        measured.resistance_ll = Some(q(5.9 * (1.0 + 3.93e-3 * 80.0)));
    });
    match (hot.verdict, hot.cause) {
        (MeasurementVerdict::Fail, Some(Cause::WindingTemperature(celsius))) => {
            assert!((celsius - 100.0).abs() < 1e-6, "{celsius}")
        }
        other => panic!("{other:?}"),
    }
    // 0.42 Ω of a 48 V winding: the leads count.
    let small = of("CHA-14A-50-E-M128S");
    let leads = found(&small, Measurand::ResistanceLl, |measured| {
        measured.resistance_ll = measured.resistance_ll.map(|ohm| q(ohm.si() + 0.1));
    });
    assert_eq!(leads, fails("leads"));
}

#[test]
fn an_inductance_or_a_voltage_that_is_off_has_its_cause() {
    let about = of("CHA-20A-100-H-M512P-B");
    let inductance = |factor: f64| {
        found(&about, Measurand::InductanceLl, move |measured| {
            measured.inductance_ll = Some(q::<Inductance>(8.0e-3 * factor));
        })
    };
    assert_eq!(inductance(0.5), fails("one_phase"));
    assert_eq!(inductance(2.0), fails("doubled"));
    assert_eq!(inductance(1.4), (MeasurementVerdict::Advice, None));
    let emf = |factor: f64| {
        found(&about, Measurand::Emf, move |measured| {
            measured.emf = measured.emf.map(|(volt, speed): (ElectricPotential, _)| (q(volt.si() * factor), speed));
        })
    };
    let root_three = 3.0_f64.sqrt();
    let root_two = std::f64::consts::SQRT_2;
    assert_eq!(emf(1.0 / root_three), fails("phase_voltage"));
    assert_eq!(emf(root_three), fails("root_three"));
    assert_eq!(emf(root_two), fails("amplitude"));
    assert_eq!(emf(root_two / root_three), fails("phase_amplitude"));
    assert_eq!(emf(2.0 * root_two), fails("peak_to_peak"));
    assert_eq!(emf(2.0), fails("speed_factor"));
    assert_eq!(emf(0.5), fails("speed_factor"));
    assert_eq!(emf(100.0), fails("speed_of_flange"));
    assert_eq!(emf(0.9), fails("magnets"));
    assert_eq!(emf(0.0), fails("open"));
    assert_eq!(emf(1.2), (MeasurementVerdict::Fail, None));
}

#[test]
fn a_temperature_sensor_that_is_off_has_its_cause() {
    let (about, small) = (of("CHA-20A-100-H-M512P-B"), of("CHA-14A-50-E-M128S"));
    let kty = |about: &Commissioning, ohm: f64| {
        found(about, Measurand::Kty, move |measured| measured.kty = Some(q::<ElectricalResistance>(ohm)))
    };
    assert_eq!(kty(&about, 5000.0), fails("open"));
    assert_eq!(kty(&about, 3.0), fails("short"));
    assert_eq!(kty(&about, 560.0), fails("kty_poles_or_temperature"));
    assert_eq!(kty(&small, 90.0), fails("other_sensor"));
    let ptc =
        |ohm: f64| found(&small, Measurand::Ptc, move |measured| measured.ptc = Some(q::<ElectricalResistance>(ohm)));
    assert_eq!(ptc(5.0), fails("short"));
    assert_eq!(ptc(603.0), fails("other_sensor"));
    assert_eq!(ptc(4000.0), fails("ptc_responded"));
    assert_eq!(ptc(20e6), fails("open"));
    // Between the cold bound and the response the standard says nothing.
    let near = planted(&small, Measurand::Ptc, |measured| measured.sensor_temperature = Some(celsius(110.0)));
    assert_eq!((near.verdict, near.unjudged), (MeasurementVerdict::NotChecked, Some(Unjudged::NotStated)));
    // An open or shorted sensor is one there too, and beyond the temperatures of the data sheet.
    let broken = |what: Measurand, celsius_at: f64, ohm: f64| {
        found(&small, what, move |measured| {
            measured.sensor_temperature = Some(celsius(celsius_at));
            (measured.kty, measured.ptc) = (Some(q(ohm)), Some(q(ohm)));
        })
    };
    for (what, celsius_at) in
        [(Measurand::Ptc, 110.0), (Measurand::Ptc, 20.0), (Measurand::Kty, 20.0), (Measurand::Kty, 300.0)]
    {
        assert_eq!(broken(what, celsius_at, 0.0), fails("short"), "{what:?} {celsius_at}");
        assert_eq!(broken(what, celsius_at, 1e9), fails("open"), "{what:?} {celsius_at}");
    }
}

/// Data sheet NXP KTY84 rev. 06, table of the KTY84/130: what it permits passes, one ohm beyond fails.
#[test]
fn the_kty_may_be_off_as_its_data_sheet_permits() {
    let about = of("CHA-25A-100-H-M512P-B");
    let verdict = |celsius_at: f64, ohm: f64| {
        found(&about, Measurand::Kty, move |measured| {
            (measured.sensor_temperature, measured.kty) = (Some(celsius(celsius_at)), Some(q(ohm)));
        })
        .0
    };
    for (celsius_at, least, largest) in [
        (-40.0, 340.0, 379.0),
        (0.0, 474.0, 522.0),
        (20.0, 555.0, 607.0),
        (25.0, 577.0, 629.0),
        (50.0, 694.0, 750.0),
        (80.0, 852.0, 912.0),
        (90.0, 910.0, 970.0),
        (100.0, 970.0, 1030.0),
        (150.0, 1282.0, 1385.0),
        (200.0, 1641.0, 1803.0),
        (250.0, 2046.0, 2286.0),
    ] {
        for (ohm, expected) in [
            (least + 1e-9, MeasurementVerdict::Pass),
            (least - 1.0, MeasurementVerdict::Fail),
            (largest - 1e-9, MeasurementVerdict::Pass),
            (largest + 1.0, MeasurementVerdict::Fail),
        ] {
            assert_eq!(verdict(celsius_at, ohm), expected, "{celsius_at} degC, {ohm} ohm");
        }
    }
    // Between two temperatures the bounds lie between theirs; 580 ohm at 25 degC is within them.
    assert_eq!(verdict(25.0, 580.0), MeasurementVerdict::Pass);
    assert_eq!((verdict(27.5, 588.5), verdict(27.5, 586.0)), (MeasurementVerdict::Pass, MeasurementVerdict::Fail));
}

#[test]
fn a_brake_that_is_off_has_its_cause() {
    // Table 38.3: 24 V, 0.6 A opens, 0.3 A holds, 110 and 70 ms.
    let about = of("CHA-20A-100-H-M512P-B");
    let current = |ampere: f64| {
        found(&about, Measurand::BrakeOpeningCurrent, move |measured| {
            measured.brake_opening_current = Some(q::<ElectricCurrent>(ampere));
        })
    };
    assert_eq!(current(0.0), fails("brake_not_connected"));
    assert_eq!(current(0.3), fails("holding_current"));
    let holding = |ampere: f64| {
        found(&about, Measurand::BrakeHoldingCurrent, move |measured| {
            measured.brake_holding_current = Some(q::<ElectricCurrent>(ampere));
        })
    };
    assert_eq!(holding(0.6), fails("opening_current"));
    assert_eq!(holding(0.15), fails("half_voltage"));
    assert_eq!(holding(0.4), (MeasurementVerdict::Advice, None));
    let voltage = |volt: f64| {
        found(&about, Measurand::BrakeVoltage, move |measured| {
            measured.brake_voltage = Some(q::<ElectricPotential>(volt))
        })
    };
    assert_eq!(voltage(12.0), fails("half_voltage"));
    assert_eq!(voltage(0.0), fails("brake_not_connected"));
    assert_eq!(voltage(20.0), (MeasurementVerdict::Fail, None));
    let slow =
        found(&about, Measurand::BrakeClosingTime, |measured| measured.brake_closing_time = Some(q::<Time>(0.2)));
    assert_eq!(slow, (MeasurementVerdict::Advice, Some("slow_brake")));
}

#[test]
fn a_motion_that_is_off_has_its_cause() {
    let about = of("CHA-20A-100-H-M512P-B");
    let flange =
        found(&about, Measurand::DirectionFlange, |measured| measured.direction_flange = Some(Turn::Clockwise));
    assert_eq!(flange, fails("same_direction"));
    let position = found(&about, Measurand::DirectionPosition, |measured| measured.position = Some(Counting::Falling));
    assert_eq!(position, fails("counting_reversed"));
    let ratio = found(&about, Measurand::Ratio, |measured| measured.speed_flange = Some(rpm(1000.0 / 80.0)));
    assert_eq!(ratio, fails("other_ratio"));
    let pairs =
        planted(&about, Measurand::PolePairs, |measured| measured.electrical_frequency = Some(q::<Frequency>(50.0)));
    assert!(matches!(pairs.cause, Some(Cause::PolePairs(pairs)) if (pairs - 3.0).abs() < 1e-9), "{pairs:?}");
    let current = |factor: f64| {
        found(&about, Measurand::NoLoadCurrent, move |measured| {
            for point in &mut measured.no_load {
                point.current = q(point.current.si() * factor);
            }
        })
    };
    assert_eq!(current(3.0), fails("dragging"));
    assert_eq!(current(std::f64::consts::SQRT_2), (MeasurementVerdict::Advice, Some("amplitude")));
    assert_eq!(current(0.3), (MeasurementVerdict::Advice, None));
    let speed = found(&about, Measurand::NoLoadCurrent, |measured| {
        for point in &mut measured.no_load {
            point.speed_out = rpm(1000.0);
        }
    });
    assert_eq!(speed, fails("speed_of_motor"));
}
