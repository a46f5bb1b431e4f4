//! `encoder`: what the encoders of a code send, and words read back.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use quantities::Language;
use questions::Progress;
use questions::list::{Entry, Given, Inquiry, Unanswered, encoder, encoder_trace};
use serde_json::Value;
use std::borrow::Cow;

const M512P: (&str, &str) = ("code", "CHA-25A-100-H-M512P");
const M128S: (&str, &str) = ("code", "CHA-17A-100-H-M128S");

fn text(entry: &Entry, pairs: &[(&str, &str)]) -> Result<(String, bool), Unanswered> {
    let progress = Progress::endless();
    let pairs = pairs.iter().map(|(name, value)| (Cow::Borrowed(*name), Cow::Borrowed(*value)));
    let given = Given::of(entry.arguments, pairs, Language::En)?;
    let inquiry = Inquiry {
        given,
        sources: Vec::new(),
        catalogue: questions::embedded_catalogue(),
        days_since_1970: None,
        progress: &progress,
        refuses_long: true,
        by_axes: false,
        language: Language::En,
    };
    let answer = entry.answer.unwrap()(&inquiry)?;
    Ok((answer.text, answer.fits))
}

fn answered(pairs: &[(&str, &str)]) -> (Value, bool) {
    let (text, fits) = text(&encoder::ENTRY, pairs).unwrap();
    (serde_json::from_str(&text).unwrap(), fits)
}

/// The vectors of docs/theory/feedback.md through the whole program: position 0 and 1 of 25 bits, both command sets.
#[test]
fn the_words_of_endat_are_the_published_vectors() {
    // Position 1 is the middle of the first of 8192 steps.
    for (angle, check_2_2, check_2_1) in [("0 deg", "01101", "00011"), ("0.06 deg", "11000", "10110")] {
        let (record, _) = answered(&[M512P, ("angle", angle)]);
        let words = record["words"].as_array().unwrap();
        assert_eq!((&words[0]["crc"], &words[1]["crc"]), (&check_2_2.into(), &check_2_1.into()), "{angle}");
        assert_eq!(words.iter().map(|word| word["bits"].as_str().unwrap().len()).collect::<Vec<_>>(), [33, 32]);
    }
    let last = answered(&[M512P, ("turn", "-1"), ("angle", "359.99 deg")]).0;
    assert_eq!((&last["words"][0]["crc"], &last["words"][1]["crc"]), (&"10010".into(), &"11100".into()));
    let failed = answered(&[M512P, ("error", "true")]).0;
    assert_eq!(failed["words"][1]["crc"], "00010");
    let output = answered(&[("code", "CHA-25A-100-H-M512P-EC"), ("error", "true")]).0;
    assert_eq!(output["output_encoder"]["words"][1]["crc"], "01101");
}

#[test]
fn every_word_is_read_back_and_every_wrong_bit_of_endat_is_found() {
    for (turn, angle) in [("0", "0 deg"), ("3", "12.5 deg"), ("4095", "359.99 deg"), ("2048", "180 deg")] {
        for code in [M512P, M128S] {
            let (record, _) = answered(&[code, ("turn", turn), ("angle", angle)]);
            for word in record["words"].as_array().unwrap() {
                let bits = word["bits"].as_str().unwrap();
                let (read, fits) = answered(&[code, ("decode", bits)]);
                assert!(fits && read["decoded"]["valid"] == true, "{bits}");
                assert_eq!(read["decoded"]["turns"].to_string(), turn);
                let stated: f64 = angle.strip_suffix(" deg").unwrap().parse().unwrap();
                assert!((read["decoded"]["angle_deg"].as_f64().unwrap() - stated).abs() < 0.05);
                for bit in 0..if code == M512P { bits.len() } else { 0 } {
                    let mut wrong = bits.to_owned();
                    wrong.replace_range(bit..=bit, if &bits[bit..=bit] == "0" { "1" } else { "0" });
                    let (read, fits) = answered(&[code, ("decode", &wrong)]);
                    assert!(!fits && !read["decoded"]["faults"].as_array().unwrap().is_empty(), "{wrong}");
                }
            }
        }
    }
}

#[test]
fn a_fault_is_named() {
    let fault = |code, word: &str| {
        let (read, fits) = answered(&[code, ("decode", word)]);
        let id = read["decoded"]["faults"][0]["id"].as_str().map(str::to_owned);
        (id, read["decoded"]["name"].as_str().map(str::to_owned), fits)
    };
    let some = |text: &str| Some(text.to_owned());
    assert_eq!(fault(M128S, "101"), (some("length"), None, false));
    assert_eq!(fault(M512P, "010000000000000000000000000011010"), (some("start"), some("endat_2_2_position"), false));
    assert_eq!(
        fault(M512P, "11000000000000000000000000000010"),
        (some("encoder_error"), some("endat_2_1_position"), false)
    );
    assert_eq!(fault(M512P, "100001101000000000001100100101"), (None, some("endat_parameter"), true));
    assert_eq!(fault(M512P, "000001101000000000001100100101"), (None, some("endat_additional_information"), true));
    assert_eq!(fault(M512P, "000111"), (None, some("endat_mode_command"), true));
    assert_eq!(fault(M512P, "000110"), (some("command"), some("endat_mode_command"), false));
    let refused = text(&encoder::ENTRY, &[("code", "CHA-14A-100-N-RES"), ("decode", "1")]).unwrap_err();
    assert_eq!(refused.faults(None, Language::En).errors[0].option.as_deref(), Some("decode"));
}

#[test]
fn overflow_and_a_lost_battery_are_reported() {
    let (record, _) = answered(&[M128S, ("turn", "4096"), ("angle", "90 deg")]);
    assert_eq!(record["words"][0]["fields"][0]["value"], 0);
    assert!(record["notes"][0].as_str().unwrap().contains("4096"));
    let (lost, _) = answered(&[M128S, ("turn", "7"), ("angle", "90 deg"), ("battery-lost", "true")]);
    assert_eq!((&lost["shaft"]["turns_valid"], &lost["words"][0]["fields"][0]["value"]), (&false.into(), &0.into()));
    assert_eq!(lost["words"][0]["fields"][1]["value"], 32_768, "the angle within the turn stays");
    let (kept, _) = answered(&[M512P, ("turn", "7")]);
    assert_eq!((&kept["shaft"]["turns_valid"], kept["notes"].as_array().unwrap().len()), (&true.into(), 0));
    let refused = text(&encoder::ENTRY, &[("code", "CHA-14A-100-N-RES"), ("battery-lost", "true"), ("error", "true")]);
    assert_eq!(refused.unwrap_err().faults(None, Language::En).errors.len(), 2);
}

/// Motor clockwise, flange counter-clockwise: the position of the motor rises, that of the output falls.
#[test]
fn motor_and_output_turn_against_each_other() {
    let code = ("code", "CHA-25A-100-H-M512P-EC");
    let angle = |turn| {
        let (record, _) = answered(&[code, ("turn", turn)]);
        let of = |state: &Value| state["shaft"]["angle_deg"].as_f64().unwrap();
        (record["shaft"]["turns"].as_i64().unwrap(), of(&record["output_encoder"]))
    };
    assert_eq!((angle("25"), angle("-25")), ((25, 270.0), (-25, 90.0)));
}

#[test]
fn curves_pass_through_the_value_and_faults_come_together() {
    for code in ["CHA-20A-100-H-C1024", "CHA-14A-100-N-D2048", "CHA-14A-100-N-RES", "CHA-25A-100-H-M512P-EC"] {
        let (record, _) = answered(&[("code", code), ("angle", "12.345 deg"), ("seed", "4")]);
        let states = [&record, &record["output_encoder"]];
        for (name, signal) in states.into_iter().filter_map(|state| state["signals"].as_object()).flatten() {
            assert_eq!(signal["pins"].as_array().unwrap().len(), 2, "{name}");
            if let Some(values) = signal["curve"]["value"].as_array() {
                assert_eq!((values.len(), &values[64]), (129, &signal["value"]), "{code} {name}");
            } else {
                assert_eq!(signal["form"], "other", "{code} {name}");
            }
        }
    }
    let refused =
        text(&encoder::ENTRY, &[M512P, ("angle", "5"), ("turn", "1.5"), ("window", "2 rev"), ("decode", "2")]);
    assert_eq!(refused.unwrap_err().faults(None, Language::En).errors.len(), 4);
}

#[test]
fn a_trace_is_bounded_and_needs_digital_signals() {
    let trace = |pairs: &[(&str, &str)]| text(&encoder_trace::ENTRY, pairs);
    let (vcd, _) = trace(&[M512P, ("speed", "3000 1/min")]).unwrap();
    assert!(vcd.starts_with("$timescale 1 ns $end\n") && vcd.contains("$var wire 1 # CLOCK $end"));
    let option = |pairs: &[(&str, &str)]| trace(pairs).unwrap_err().faults(None, Language::En).errors[0].option.clone();
    assert_eq!(option(&[M512P, ("speed", "6000 1/min"), ("time", "3000 s")]).as_deref(), Some("time"));
    assert_eq!(option(&[("code", "CHA-14A-100-N-RES")]).as_deref(), Some("vcd"));
    assert_eq!(option(&[M512P, ("connector", "output_encoder")]).as_deref(), Some("connector"));
    assert_eq!(option(&[M512P, ("time", "0 s")]).as_deref(), Some("time"));
}
