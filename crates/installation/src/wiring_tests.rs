use super::*;
use configurator::all;
use quantities::unit::{METRE, MILLIAMPERE, SQUARE_MILLIMETRE, VOLT};
use quantities::{Area, Length, Measure};

fn code(text: &str) -> OrderCode {
    order_code::parse(text).unwrap().code
}

fn of(text: &str) -> CodeWiring {
    wiring(&code(text)).unwrap()
}

fn signals(connector: &Connector) -> Vec<(&str, &str)> {
    connector.pins.iter().map(|pin| (pin.name.as_str(), pin.printed())).collect()
}

fn compared(code: &str, list: &str) -> PinComparison {
    compare(&of(code), &read_pin_list(list).unwrap())
}

fn found(code: &str, list: &str) -> Vec<(Option<usize>, &'static str, Severity)> {
    compared(code, list).findings.iter().map(|each| (each.line, each.difference.id(), each.severity())).collect()
}

/// Returns the list of a connector as stated in the manual.
fn printed_list(wiring: &CodeWiring) -> String {
    let mut list = String::from("connector,pin,signal\n");
    for connector in &wiring.connectors {
        for pin in &connector.pins {
            list.push_str(&format!("{},{},{}\n", connector.role.id(), pin.name, pin.printed()));
        }
    }
    list
}

#[test]
fn every_code_has_its_wiring_or_is_on_request() {
    assert_eq!(all().len(), 1254);
    for (code, availability) in all() {
        let wiring = wiring(code).unwrap_or_else(|| panic!("{code}: no wiring"));
        let roles: Vec<Role> = wiring.connectors.iter().map(|connector| connector.role).collect();
        let ec = code.option_1.is_some();
        assert_eq!(roles, if ec { Role::ALL.to_vec() } else { vec![Role::Motor, Role::Feedback] }, "{code}");
        for connector in &wiring.connectors {
            let missing = connector.pins.is_empty();
            // Resolvers on 20A to 58A are missing in table 65.3 of the motor connector.
            assert_eq!(
                missing,
                connector.role == Role::Motor && wiring.absences.iter().any(|a| a.what == Absent::MotorPins)
            );
            assert!(!missing || !availability.is_available(), "{code}: {:?}", connector.role);
            assert!(missing || connector.pins.len() == usize::from(connector.poles), "{code}: {:?}", connector.role);
            assert!(connector.mating.is_some(), "{code}: {:?}", connector.role);
        }
    }
}

#[test]
fn no_pin_stands_twice_and_every_signal_is_understood() {
    for (code, _) in all() {
        for connector in wiring(code).unwrap().connectors {
            let mut names: Vec<&str> = connector.pins.iter().map(|pin| pin.name.as_str()).collect();
            names.sort_unstable();
            names.dedup();
            assert_eq!(names.len(), connector.pins.len(), "{code}");
            let mut carried: Vec<&str> = Vec::new();
            for pin in &connector.pins {
                let nothing = pin.signal.is_none() || pin.printed() == "-";
                assert_eq!(pin.carries.is_none(), nothing, "{code} pin {}: `{}`", pin.name, pin.printed());
                if !nothing {
                    carried.push(pin.printed());
                }
            }
            carried.sort_unstable();
            let all = carried.len();
            carried.dedup();
            // Both ends of the thermistor chain have the same name.
            let twice = usize::from(connector.role == Role::Motor && carried.contains(&"Temp PTC"));
            assert_eq!(carried.len() + twice, all, "{code}");
            for pin in &connector.pins {
                if let Some(signal) = pin.carries.filter(|signal| signal.polarity.is_some()) {
                    let ends =
                        connector.pins.iter().filter(|other| other.carries.is_some_and(|o| o.is_other_end_of(signal)));
                    assert_eq!(ends.count(), 1, "{code} pin {}: a pair has two ends", pin.name);
                }
            }
        }
    }
}

#[test]
fn every_cable_fits_a_connector_of_its_code() {
    for (code, _) in all() {
        let wiring = wiring(code).unwrap();
        for cable in &wiring.cables {
            let role = match cable.role {
                CableRole::Motor => Role::Motor,
                CableRole::Feedback | CableRole::Set => Role::Feedback,
                CableRole::OutputEncoder => Role::OutputEncoder,
            };
            let connector = wiring.connector(role).unwrap_or_else(|| panic!("{code}: {cable:?} fits nothing"));
            let section = |table: &str| catalogue::table(table).unwrap().section;
            assert_eq!(section(cable.number.place.table), section(connector.table.id), "{code}: {cable:?}");
        }
        let power = wiring.cables.iter().filter(|cable| cable.role == CableRole::Motor).count();
        assert_eq!(power, usize::from(code.winding.as_str() == "H"), "{code}: one power cable, with or without brake");
    }
}

#[test]
fn what_is_absent_names_a_table() {
    for (code, _) in all() {
        for absence in wiring(code).unwrap().absences {
            assert!(catalogue::table(absence.table).is_some(), "{code}: {absence:?}");
        }
    }
}

// Typed by hand from cha-manual tables 63.3, 63.6, 66.3 and 68.4.
#[test]
fn the_pin_outs_are_those_of_the_print() {
    let wiring = of("CHA-25A-100-H-M512P-B-EC");
    let motor = wiring.connector(Role::Motor).unwrap();
    assert_eq!(signals(motor), [("1", "U"), ("2", "V"), ("3", "PE"), ("4", "BR+"), ("5", "BR-"), ("6", "W")]);
    assert_eq!(motor.mating.unwrap().corrected, "301193");
    assert_eq!(motor.ambiguous.len(), 1);
    assert_eq!((motor.ambiguous[0].colour.corrected, motor.ambiguous[0].pins.join(" ")), ("weiß", "4 6".to_owned()));
    let feedback = wiring.connector(Role::Feedback).unwrap();
    assert_eq!(feedback.pin("7").unwrap().joined.as_deref(), Some("15"));
    assert_eq!(feedback.pin("10").unwrap().printed(), "Up");
    assert_eq!(feedback.pin("17").unwrap().printed(), "Inner Schirm");
    let output = wiring.connector(Role::OutputEncoder).unwrap();
    assert_eq!(output.pin("7").unwrap().printed(), "Up");
    assert_eq!(output.pin("10").unwrap().printed(), "GND");
    assert_eq!(output.mating.unwrap().corrected, feedback.mating.unwrap().corrected);
    let small = of("CHA-14A-50-N-RES");
    let pins = signals(small.connector(Role::Motor).unwrap());
    let expected =
        [("1", "U"), ("2", "Temp PTC"), ("3", "BR+"), ("4", "BR-"), ("5", "Temp PTC"), ("6", "W"), ("7", "V")];
    assert_eq!((&pins[..7], pins[7]), (expected.as_slice(), ("PE", "PE")));
}

#[test]
fn the_printed_list_of_every_code_agrees_with_itself() {
    for (code, _) in all().iter().filter(|(code, _)| code.ratio.value() == 50) {
        let wiring = wiring(code).unwrap();
        let comparison = compare(&wiring, &read_pin_list(&printed_list(&wiring)).unwrap());
        let graver: Vec<_> = comparison.findings.iter().filter(|f| f.severity() != Severity::Advice).collect();
        assert!(comparison.agrees() && graver.is_empty(), "{code}: {graver:?}");
    }
}

#[test]
fn any_two_pins_exchanged_are_found() {
    for text in ["CHA-25A-100-H-M512P-B-EC", "CHA-14A-50-N-D2048-B", "CHA-17A-80-E-M128S", "CHA-14A-50-H-RES-B"] {
        let wiring = of(text);
        for connector in &wiring.connectors {
            let pins: Vec<&Pin> = connector.pins.iter().filter(|pin| pin.carries.is_some()).collect();
            for (index, one) in pins.iter().enumerate() {
                for other in pins.iter().skip(index + 1).filter(|other| other.printed() != one.printed()) {
                    let mut list = String::from("connector;pin;signal\n");
                    for pin in &connector.pins {
                        let signal = match pin.name.as_str() {
                            name if name == one.name => other.printed(),
                            name if name == other.name => one.printed(),
                            _ => pin.printed(),
                        };
                        list.push_str(&format!("{};{};{signal}\n", connector.role.id(), pin.name));
                    }
                    let comparison = compare(&wiring, &read_pin_list(&list).unwrap());
                    let found: Vec<_> = comparison.findings.iter().filter(|f| f.line.is_some()).collect();
                    assert_eq!(found.len(), 1, "{text}: {} and {}: {found:?}", one.name, other.name);
                    assert!(["swapped", "polarity_reversed"].contains(&found[0].difference.id()));
                }
            }
        }
    }
}

#[test]
fn swaps_polarity_and_what_is_missing_are_reported_apart() {
    let motor = "connector,pin,signal\nmotor,1,U\nmotor,2,V\nmotor,3,PE\nmotor,4,Brake-\nmotor,5,Bremse +\nmotor,6,W\n";
    let found_motor = found("CHA-25A-100-H-M512P-B", motor);
    assert_eq!(found_motor[0], (Some(5), "polarity_reversed", Severity::Danger));
    assert_eq!(found_motor[1..], [(None, "connector_not_listed", Severity::Advice)]);
    let phases = motor.replace("1,U", "1,v").replace("2,V", "2,u").replace("Brake-", "br+").replace("Bremse +", "BR -");
    assert_eq!(found("CHA-25A-100-H-M512P-B", &phases)[0], (Some(2), "swapped", Severity::Danger));
    let without = motor.replace("motor,3,PE\n", "").replace("Brake-", "BR+").replace("Bremse +", "BR-");
    assert!(found("CHA-25A-100-H-M512P-B", &without).contains(&(None, "protective_earth_missing", Severity::Danger)));
    let kty = "Stecker;Stift;Signal\nGeber;8;KTY-\nGeber;9;Temp+ KTY\n";
    let found_kty = found("CHA-25A-100-H-M512P", kty);
    assert_eq!(found_kty[0], (Some(2), "polarity_reversed", Severity::Fault));
    assert!(found_kty.contains(&(None, "shield_missing", Severity::Fault)));
}

#[test]
fn the_other_encoders_pin_out_is_recognised() {
    let wiring = of("CHA-25A-100-H-M512P-EC");
    let mut list = String::from("connector,pin,signal\n");
    for pin in &wiring.connector(Role::Feedback).unwrap().pins {
        list.push_str(&format!("EC,{},{}\n", pin.name, pin.printed()));
    }
    let comparison = compare(&wiring, &read_pin_list(&list).unwrap());
    assert_eq!(comparison.findings[0].difference, PinDifference::OtherEncoder { of: Role::Feedback });
    assert_eq!(comparison.findings[0].severity(), Severity::Danger);
    assert!(!comparison.agrees());
}

#[test]
fn pins_signals_colours_and_shields_that_are_not_so_are_found() {
    let list = "# by hand\nconnector,pin,signal,colour,shield\n\nmotor,1,U,RD,yes\nmotor,1,V,black,\nmotor,9,W,,\n\
                motor,3,GNYE,,\nmotor,6,W,green,no\nmotor,2,DATA+,,\nmotor,4,BRR+,,\n";
    let found = found("CHA-25A-100-H-M512P-B", list);
    let has = |line, id| assert!(found.iter().any(|(at, each, _)| *at == Some(line) && *each == id), "{id}: {found:?}");
    has(5, "pin_twice");
    has(6, "no_such_pin");
    has(7, "unknown_signal");
    has(8, "colour");
    has(8, "unshielded");
    has(9, "foreign_signal");
    has(10, "unknown_signal");
    assert!(!found.iter().any(|(at, ..)| *at == Some(4)), "red by its letters and U: {found:?}");
    let nearest = compared("CHA-25A-100-H-M512P-B", list).findings;
    let nearest = nearest.iter().find(|each| each.line == Some(10)).unwrap();
    assert_eq!(nearest.difference, PinDifference::UnknownSignal { written: "BRR+".into(), nearest: Some("BR+") });
    let open = self::found("CHA-14A-50-E-RES", "connector,pin,signal\nfeedback,3,SIN+\nfeedback,7,-\nfeedback,4,xyz\n");
    assert_eq!(open[0], (Some(2), "wrong_pin", Severity::Fault));
    assert_eq!(open[1], (Some(3), "left_open", Severity::Fault));
    assert_eq!(open[2], (Some(4), "not_connected", Severity::Fault));
    let none = self::found("CHA-25A-100-H-M512P", "connector,pin,signal\nEC,1,A+\n");
    assert_eq!(none[0].1, "no_such_connector");
}

#[test]
fn a_list_that_cannot_be_read_tells_all_its_faults() {
    let ids = |text: &str| read_pin_list(text).unwrap_err().iter().map(ListFault::id).collect::<Vec<_>>();
    assert_eq!(ids(""), ["pin_list_empty"]);
    assert_eq!(ids("connector,pin,signal\n"), ["pin_list_empty"]);
    assert_eq!(
        ids("plug,pin,colour,pin,what\n"),
        ["pin_list_column_twice", "pin_list_column_unknown", "pin_list_column_missing"]
    );
    let text = "connector,pin,signal,shield\nmoter,1,U,\nmotor,,V,perhaps\nmotor,3\n";
    let faults = read_pin_list(text).unwrap_err();
    assert_eq!(
        faults.iter().map(ListFault::id).collect::<Vec<_>>(),
        ["pin_list_connector_unknown", "pin_list_cell_empty", "pin_list_shield_unclear", "pin_list_ragged"]
    );
    assert_eq!(&text[faults[0].span()], "moter");
    assert_eq!(&text[faults[2].span()], "perhaps");
    assert_eq!(&text[faults[3].span()], "motor,3");
}

// 2 * 0.017241 * 15 * 0.6 / 0.75 = 0.41378 V; at 70 °C times 1 + 0.00393 * 50 = 1.1965, 0.49509 V.
#[test]
fn the_loss_of_the_brake_is_that_of_both_wires() {
    let (length, section) = (Length::new_in(15.0, &METRE), Area::new_in(0.75, &SQUARE_MILLIMETRE));
    let drops = voltage_drops(&code("CHA-20A-100-H-C1024-B"), length, Some(section));
    let brake = drops.iter().find(|drop| drop.circuit == Circuit::Brake).unwrap();
    let [cold, warm] = brake.loss.unwrap();
    assert!((cold.in_unit(&VOLT) - 0.413_784).abs() < 1e-6 && (warm.in_unit(&VOLT) - 0.495_093).abs() < 1e-6);
    assert_eq!(brake.verdict, DropVerdict::Pass);
    // 24 V ± 10 % leaves 2.4 V: A = 2 * 0.017241 * 1.1965 * 15 * 0.6 / 2.4 = 0.15472 mm².
    assert!((brake.cross_section_min.unwrap().in_unit(&SQUARE_MILLIMETRE) - 0.154_716).abs() < 1e-6);
    let thin = voltage_drops(&code("CHA-20A-100-H-C1024-B"), length, Some(Area::new_in(0.15, &SQUARE_MILLIMETRE)));
    assert_eq!(thin[0].verdict, DropVerdict::Fail);
}

#[test]
fn a_supply_without_tolerance_or_nominal_value_is_not_judged() {
    let (length, section) = (Length::new_in(10.0, &METRE), Some(Area::new_in(0.25, &SQUARE_MILLIMETRE)));
    let verdict = |text: &str| voltage_drops(&code(text), length, section)[0].verdict;
    assert_eq!(verdict("CHA-14A-50-N-RES"), DropVerdict::NoTolerance);
    assert_eq!(verdict("CHA-25A-100-H-M512P"), DropVerdict::NoNominal);
    let ssi = &voltage_drops(&code("CHA-14A-50-H-M128S"), length, section)[0];
    // 0.1 W at 5 V.
    assert!((ssi.current.value.in_unit(&MILLIAMPERE) - 20.0).abs() < 1e-9);
    assert_eq!(verdict("CHA-14A-50-E-RES-B"), DropVerdict::NoOpeningCurrent, "table 15.2 has a dash for I_OBr");
    let open = voltage_drops(&code("CHA-14A-50-N-D2048"), length, None);
    assert_eq!(open[0].verdict, DropVerdict::NoCrossSection);
    assert!(open[0].loss.is_none() && open[0].cross_section_min.is_some());
}

#[test]
fn every_circuit_of_every_code_has_its_loss() {
    for (code, _) in all() {
        let expected = 1 + usize::from(code.brake == Brake::With) + usize::from(code.option_1.is_some());
        let found = voltage_drops(code, Length::new_in(10.0, &METRE), None).len();
        // Codes on request have no drive in the catalogue and therefore no brake current.
        let data = catalogue::drive(code.size, code.winding, code.feedback).is_some();
        assert_eq!(found, expected - usize::from(!data && code.brake == Brake::With), "{code}");
    }
}
