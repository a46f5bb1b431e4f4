//! Properties over every valid ordering code.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "a test fails loudly"
)]

use configurator::{all, availability, choices, complete, nearest, parameters};
use order_code::{Brake, Feedback, Field, OrderCode, Pattern, Series, Size, Winding, parse};

#[test]
fn the_count_of_valid_codes_follows_from_the_tables_by_hand() {
    // 14A: E with RES D2048 M128S, H with RES M128S, N with RES M128S D2048 (11.3) on 4 ratios, with and without brake,
    // plus option K for the three resolver pairs (12.1, footnote 1). 17A the same on 5 ratios.
    let small = |ratios: usize| ratios * 2 * (8 + 3);
    // 20A to 58A, winding H: C1024, M512P, RES; with and without brake and EC; standard exit or K; R and S with M512P.
    let large = |ratios: usize| ratios * 2 * 2 * (3 * 2 + 2);
    let expected = small(4) + small(5) + 3 * large(6) + 3 * large(5);
    assert_eq!(all().len(), expected);
    let available = all().iter().filter(|(_, found)| found.is_available()).count();
    // Available: no RES from 20A up, no K anywhere; C1024 standard, M512P standard, R, S.
    assert_eq!(available, 4 * 2 * 8 + 5 * 2 * 8 + 3 * (6 * 2 * 2 * 4) + 3 * (5 * 2 * 2 * 4));
}

#[test]
fn codes_are_unique_and_read_back() {
    let mut texts: Vec<String> = all().iter().map(|(code, _)| code.to_string()).collect();
    for (code, found) in all() {
        assert_eq!(parse(&code.to_string()).unwrap().code, *code);
        assert_eq!(availability(code).as_ref(), Ok(found));
    }
    texts.sort();
    texts.dedup();
    assert_eq!(texts.len(), all().len());
}

#[test]
fn every_available_code_has_data_and_every_value_that_the_checks_need() {
    for (code, found) in all() {
        let parameters = parameters(code);
        let printed = code.feedback.as_str() != "RES" || code.size.number() <= 17;
        assert_eq!(parameters.is_some(), printed, "{code}");
        let Some(p) = parameters else {
            assert!(!found.is_available());
            continue;
        };
        for (name, known) in [
            ("T_max", p.torque_max.known().is_some()),
            ("n_mot_max", p.speed_motor_max.known().is_some()),
            ("n_N", p.speed_motor_rated.known().is_some()),
            ("I_max", p.current_max.known().is_some()),
            ("T_0", p.stall_torque.known().is_some()),
            ("I_0", p.stall_current.known().is_some()),
            ("I_NLS", p.no_load_starting_current.known().is_some()),
            ("K_INL 30", p.no_load_current_constant_cold.known().is_some()),
            ("K_INL 80", p.no_load_current_constant_warm.known().is_some()),
            ("k_Tout", p.torque_constant_out.known().is_some()),
            ("k_TM", p.torque_constant_motor.known().is_some()),
            ("k_EM", p.voltage_constant_motor.known().is_some()),
            ("R_LL", p.resistance_ll.known().is_some()),
            ("L_LL", p.inductance_ll.known().is_some()),
            ("p", p.pole_pairs.known().is_some()),
            ("J_out", p.inertia_out.known().is_some()),
            ("m", p.mass.known().is_some()),
            ("L", p.length.known().is_some()),
            ("d_H", p.hollow_shaft.known().is_some()),
            ("U_DCmax", p.dc_link_max.known().is_some()),
            ("U_M", p.terminal_voltage_min.known().is_some()),
        ] {
            assert!(known, "{code}: {name}");
        }
        // The manual prints a dash for the demagnetisation current of 14A and 17A.
        assert_eq!(p.current_demagnetisation.known().is_some(), code.size.number() >= 20, "{code}");
    }
}

#[test]
fn a_brake_adds_inertia_mass_and_length() {
    use quantities::Measure;
    for (code, _) in all().iter().filter(|(code, _)| code.brake == Brake::With) {
        let Some(with) = parameters(code) else { continue };
        let mut bare = *code;
        bare.brake = Brake::Without;
        let without = parameters(&bare).unwrap();
        let si = |datum: &provenance::Datum<_>| {
            datum.known().map(|known: &provenance::Sourced<quantities::Mass>| known.value.si())
        };
        assert!(si(&with.mass) > si(&without.mass), "{code}");
        let inertia = |p: &actuator::Parameters| p.inertia_out.known().unwrap().value.si();
        assert!(inertia(&with) > inertia(&without), "{code}");
        let length = |p: &actuator::Parameters| p.length.known().unwrap().value.si();
        assert!(length(&with) > length(&without), "{code}");
    }
}

#[test]
fn safe_sides_of_contradictions_reach_the_parameters() {
    use quantities::Measure;
    let of = |text: &str| parameters(&parse(text).unwrap().code).unwrap();
    let inertia = of("CHA-25A-50-H-M512P").inertia_out.known().unwrap().clone();
    assert!((inertia.value.si() - 1.10).abs() < 1e-12, "corrected: J i² = 1,10, printed 0,97");
    assert_eq!(inertia.errata, ["25A-M512P-J_out-50"]);
    let mass = of("CHA-25A-50-H-M512P").mass.known().unwrap().clone();
    assert!((mass.value.si() - 5.9).abs() < 1e-12, "the heavier of the doubtful masses");
    assert!((of("CHA-25A-50-H-C1024").mass.known().unwrap().value.si() - 4.9).abs() < 1e-12);
}

#[test]
fn patterns_complete_to_valid_codes_only() {
    let pattern = Pattern::parse("CHA-20A-100-H-*").unwrap();
    let codes: Vec<_> = complete(&pattern).collect();
    assert_eq!(codes.len(), 32);
    let choices = choices(&pattern);
    let of = |field: Field| choices.iter().find(|(known, _)| *known == field).map(|(_, c)| c.clone()).unwrap();
    let feedback: Vec<(&str, bool)> = of(Field::Feedback).iter().map(|c| (c.token, c.available)).collect();
    assert_eq!(feedback, [("C1024", true), ("M512P", true), ("RES", false)]);
    assert_eq!(complete(&Pattern::parse("CHA-14A-120").unwrap()).count(), 0);
    let special: Vec<_> = complete(&Pattern::parse("CHA-20A-100-H-C1024-B-EC-K-SP").unwrap()).collect();
    assert_eq!(special.len(), 1);
    assert!(special[0].0.special && special[0].1.on_request.contains(&Field::Special));
}

/// A partial code without a code has a reason, one with codes has none, and a reason is a rule that its codes break.
#[test]
fn what_no_code_can_have_is_reported_with_its_rule() {
    use configurator::{Rule, broken_by_all};
    let stated = |text: &str| {
        let broken = broken_by_all(&Pattern::parse(text).unwrap());
        broken.iter().map(|(_, rule)| (rule.field, rule.rule)).collect::<Vec<_>>()
    };
    assert_eq!(stated("CHA-40A-30"), [(Field::Ratio, Rule::NotForSize)]);
    assert_eq!(stated("CHA-14A-120"), [(Field::Ratio, Rule::NotForSize)]);
    assert_eq!(stated("CHA-20A-100-L"), [(Field::Winding, Rule::NotInOrderingTables)]);
    assert_eq!(stated("CHA-*-*-E-C1024"), [(Field::Feedback, Rule::PairNotListed)]);
    assert_eq!(
        stated("CHA-20A-*-H-C1024-R"),
        [(Field::Option2, Rule::OnlyWith { feedback: Feedback::of(Series::default(), "M512P").unwrap(), longer: "" })]
    );
    assert!(stated("CHA-20A-100").is_empty());
    let sizes = stated("CHA-*-160-E").len();
    assert!(sizes >= Size::all(Series::default()).len(), "no single rule forbids it: one for each size, {sizes}");
    for text in ["CHA", "CHA-14A-*-*-M128S-B", "CHA-*-*-L-RES", "CHA-17A-*-*-*-EC", "CHA-58A-160-H-RES-S"] {
        let pattern = Pattern::parse(text).unwrap();
        assert_eq!(broken_by_all(&pattern).is_empty(), complete(&pattern).next().is_some(), "{text}");
    }
}

/// Every code with one wrong letter finds its way home, unless another valid code is as near.
#[test]
fn one_wrong_letter_finds_its_code_among_the_nearest() {
    let with_data = |code: &OrderCode| catalogue::drive(code.size, code.winding, code.feedback).is_some();
    for (code, _) in all().iter().filter(|(code, _)| with_data(code)).step_by(151) {
        let text = code.to_string();
        for index in 4..text.len() {
            if !text.as_bytes()[index].is_ascii_alphanumeric() {
                continue;
            }
            let mut wrong = text.clone();
            wrong.replace_range(index..=index, "X");
            let found = nearest(&wrong, usize::MAX);
            assert!(found.iter().any(|(near, _)| near == code), "{wrong} -> {found:?}");
        }
    }
    let swapped: Vec<String> = nearest("CHA-20A-100-C1024-H", 1).iter().map(|(code, _)| code.to_string()).collect();
    assert_eq!(swapped, ["CHA-20A-100-H-C1024"]);
    assert!(nearest("completely different", 3).is_empty());
    assert!(nearest("", 3).is_empty());
}

#[test]
fn the_tables_and_the_grammar_know_the_same_words() {
    for winding in Winding::all(Series::default()) {
        let listed =
            catalogue::table("12.1").unwrap().cells().iter().any(|c| c.place.condition == format!("winding={winding}"));
        assert!(listed, "{winding}");
    }
    for feedback in Feedback::all(Series::default()) {
        let named = catalogue::table("11.4").unwrap().cells().iter().any(|cell| cell.feedback == feedback.as_str());
        assert!(named, "{feedback}");
    }
}
