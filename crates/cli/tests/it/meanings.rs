//! Words of a call: each has one meaning in all commands, which the answer states; where two are plausible, the refusal has a call
//! for each, and each does what it says.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use crate::refusals::{call, named, recording};
use order_code::Pattern;

/// A folder with two projects and a recording.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (kind, more) in [("disc", "--mass 30kg --diameter 0.6m --time 0.4s"), ("arm", "--length 0.8m")] {
        let made = call(folder.path(), &format!("antrieb new {kind} {more} --out {kind}.toml"));
        assert_eq!(made.code, 0, "{}", made.err);
    }
    std::fs::write(folder.path().join("log.csv"), recording()).unwrap();
    folder
}

const BOTH_TIMES: &str = "motion[1].time 0.4s → 2s; motion[3].time 0.4s → 2s";
const BOTH_WAYS: &str = "motion[1].distance 90 deg → 45deg; motion[3].distance -90 deg → -45deg";
const PAUSES: &str = "motion[2].time 1 s → 1.1 s; motion[4].time 1 s → 1.1 s";

#[test]
fn a_word_for_the_motion_sets_every_move_in_all_commands() {
    let folder = folder();
    for command in
        ["size disc.toml", "check disc.toml", "simulate disc.toml", "compare disc.toml", "size Scheibe --mass 9kg"]
    {
        let is_new = command.contains("Scheibe");
        for (words, part) in [
            ("--time 2s", BOTH_TIMES),
            ("time=2s", BOTH_TIMES),
            ("--set time=2s", BOTH_TIMES),
            ("--zeit 2s", BOTH_TIMES),
            ("--distance 45deg", BOTH_WAYS),
            ("--angle 45deg", BOTH_WAYS),
            ("--set winkel=45deg", BOTH_WAYS),
            ("--cycle 3s", PAUSES),
            ("Taktzeit=3s", PAUSES),
        ] {
            let found = call(folder.path(), &format!("antrieb {command} {words}"));
            let part = if is_new { part.replace("0.4s", "0.8 s").replace("1.1 s", "0.7 s") } else { part.to_owned() };
            assert!(found.code < 2 && found.err.contains(&part), "{command} {words}\n{}", found.err);
        }
    }
    for (words, parts) in [
        (
            "new disc --angle 45deg --time 0.4s --cycle 2s",
            &["distance = \"45deg\"", "distance = \"-45deg\"", "time = \"0.6 s\""][..],
        ),
        ("new belt --velocity 1m/s", &["speed = \"1m/s\""]),
        ("new screw --vertical --mass 30,5kg", &["inclination = \"90deg\"", "mass = \"30.5kg\""]),
        ("sweep disc.toml --time 0.4,2s", &["motion[1].time [s]  motion[3].time [s]"]),
        ("sweep disc.toml --vary motion[1].time=0.3-0.8s --steps 2", &["0.8"]),
        ("sweep arm.toml --payload 2;4kg", &["motion[3].payload [kg]"]),
    ] {
        let found = call(folder.path(), &format!("antrieb {words}"));
        assert!(found.code < 2, "{words}\n{}", found.err);
        for part in parts {
            assert!(found.out.contains(part), "{words}: {part}\n{}", found.out);
        }
    }
    // The moves of a template have one of speed and time.
    let belt = call(folder.path(), "antrieb size belt --velocity 1m/s");
    assert!(belt.code < 2 && belt.err.contains("motion[1].time 2 s → –"), "{}", belt.err);
}

/// Refused words with a part of the message, and what each proposed call does, in its own words.
#[test]
fn a_refusal_has_a_call_for_each_meaning_and_each_does_it() {
    let folder = folder();
    let inertia = "understood as";
    for (written, message, effects) in [
        ("size disc.toml --time 2", "no unit", &["motion[3].time 0.4s → 2 s", "time × 2"][..]),
        ("size disc.toml --zeit 2", "no unit", &["motion[3].time 0.4s → 2 s", "time × 2"]),
        ("check disc.toml time=2", "no unit", &["motion[3].time 0.4s → 2 s", "time × 2"]),
        ("check disc.toml --set time=2", "no unit", &["motion[3].time 0.4s → 2 s", "time × 2"]),
        ("simulate disc.toml --estop --time 2", "no unit", &["motion[3].time 0.4s → 2 s", "time × 2"]),
        ("size disc.toml --distance 45", "no unit", &["motion[3].distance -90 deg → -45 deg"]),
        ("size disc.toml --time 2 --distance 45", "no unit", &["→ -45 deg", "time × 2"]),
        ("size arm.toml --payload 5", "no unit", &["motion[1].payload – → 5 kg"]),
        ("size disc.toml --load 30", "no unit", &["mass 30kg → 30 kg"]),
        ("size disc.toml --cycle 3", "no unit", &["motion[2].time 1 s → 1.1 s"]),
        ("size disc.toml --cycle 0.5s", "the moves alone take 0.8 s", &["motion[3].time 0.4s → 0.2s"]),
        ("size disc.toml --scale load=15%", "increase or a share", &["load × 1.15", "load × 0.15"]),
        ("size disc.toml --load 49%", "increase or a share", &["load × 1.49", "load × 0.49"]),
        ("size disc.toml --scale load=+15", "increase or a share", &["load × 1.15", "load × 15"]),
        ("size disc.toml --scale load=+0.15", "increase or a share", &["load × 1.15", "load × 0.15"]),
        ("size disc.toml --payload 5kg", "no effect", &["mass 30kg → 35kg"]),
        ("sweep disc.toml --payload 0..10kg --time 0.4..1s --steps 2", "no effect", &["understood|columns|1 s"]),
        ("sweep disc.toml --speed 10,20rpm", "replaces", &["motion[1].speed – → 20 rpm"]),
        ("sweep disc.toml --mass 2,5kg", "comma", &["understood|columns|2.5", "understood|columns|2.5"]),
        ("sweep disc.toml --vary motion[9].time=1;2s", "no such entry", &["understood|columns|motion[3]"]),
        ("sweep disc.toml --time 1..2", "no unit", &["understood|columns|1 s"]),
    ] {
        let refused = call(folder.path(), &format!("antrieb {written}"));
        let first = refused.err.lines().next().unwrap_or_default();
        assert!(refused.code == 2 && first.contains(message), "{written}\n{}", refused.err);
        let calls = named(&refused.err);
        assert_eq!(calls.len(), effects.len(), "{written}\n{}", refused.err);
        for (proposed, effect) in calls.iter().zip(effects) {
            let done = call(folder.path(), proposed);
            assert!(done.code < 2, "{written}: {proposed}\n{}", done.err);
            let is_free = effect.contains('|');
            assert!(
                is_free || done.err.contains(effect) || done.err.contains(inertia) && done.out.contains(effect),
                "{proposed}: {effect}\n{}",
                done.err
            );
        }
    }
}

#[test]
fn an_entry_that_a_list_does_not_have_is_refused_everywhere() {
    let folder = folder();
    for command in
        ["size disc.toml", "check disc.toml", "compare disc.toml", "report disc.toml", "new disc", "size drehtisch"]
    {
        for set in [
            "mechanism.turntable.body[2].mass=5kg",
            "mechanism.turntable.body[7].mass=5kg",
            "mechanism.turntable.body[2].mass=quatsch",
            "motion[5].time=1s",
            "motion[9].time=1s",
            "motion[5].hold=brake",
        ] {
            let refused = call(folder.path(), &format!("antrieb {command} --set {set}"));
            assert!(refused.code == 2 && refused.err.contains("no such entry"), "{command} {set}\n{}", refused.err);
        }
    }
    let vary = call(folder.path(), "antrieb sweep disc.toml --vary motion[9].time=1s,2s");
    assert!(vary.code == 2 && vary.err.contains("no such entry"), "{}", vary.err);
}

/// The fault is that of the value: its unit, its thousands, its kind.
#[test]
fn a_faulty_value_is_no_unknown_name() {
    let folder = folder();
    for (written, part) in [
        ("new disc --mass 30Kg", "unknown unit \"Kg\""),
        ("new disc --mass 1.000,5kg", "1.000,5kg"),
        ("new disc --zeit 5kg", "unit of mass"),
        ("size disc.toml --set ambient=50C", "unknown unit \"C\""),
        ("size disc.toml --set ambient=122F", "unknown unit \"F\""),
        ("size disc.toml --set mass=abc", "mechanism.turntable.body[1].mass"),
    ] {
        let refused = call(folder.path(), &format!("antrieb {written}"));
        assert!(refused.code == 2 && refused.err.contains(part), "{written}\n{}", refused.err);
        assert!(
            !refused.err.contains("unknown option") && !refused.err.contains("no key"),
            "{written}\n{}",
            refused.err
        );
    }
    for set in ["'mass=\"35 kg\"'", "mass=“35 kg”", "mass=„35 kg“", "mass=35,0kg"] {
        let words = ["size", "disc.toml", "--set", set.trim_matches('\'')];
        let found = crate::run::run_at(folder.path(), &words);
        assert!(found.code < 2 && found.err.contains("body[1].mass 30kg → 35"), "{set}\n{}", found.err);
    }
}

/// Calls that lack a word: what is assumed is stated.
#[test]
fn a_call_that_lacks_one_word_is_answered_with_what_it_assumes() {
    let folder = folder();
    std::fs::remove_file(folder.path().join("arm.toml")).unwrap();
    const CODE: &str = "CHA-25A-50-H-C1024";
    for (written, part) in [
        (format!("compare {CODE} CHA-32A-50-H-C1024"), "the only one of this folder, disc.toml"),
        ("size".to_owned(), "the only one of this folder, disc.toml"),
        ("size --mass 20kg".to_owned(), "mass 30kg → 20kg"),
        ("data".to_owned(), "best of the ranking"),
        ("commission disc.toml".to_owned(), "--for plain"),
        (format!("commission {CODE} --for s120"), ""),
        (format!("commission {CODE} --for Siemens"), ""),
        ("upkeep CHA-14A-50-E-M128S".to_owned(), "assumed: --delivered 20"),
        ("upkeep CHA-14A-50-E-M128S --delivered 1.3.2026".to_owned(), ""),
        ("upkeep CHA-14A-50-E-M128S --delivered today".to_owned(), ""),
        ("battery CHA-14A-50-E-M128S".to_owned(), "--hours-per-day \"8 h\""),
        ("simulate disc.toml --time 8h".to_owned(), "--days 1 --hours-per-day 8h"),
        ("simulate disc.toml --duration 16h".to_owned(), "--hours-per-day 16h"),
        ("simulate disc.toml --scenario estop".to_owned(), ""),
        (format!("plot {CODE} -o curve.svg"), "antrieb curve"),
        (format!("size disc.toml {CODE}"), "antrieb check disc.toml"),
        ("size disc.toml --best".to_owned(), "--top 1"),
        ("check disc.toml cha-25a-100".to_owned(), "stands for 4 actuators of the ranking"),
        ("check disc.toml CHA-25A-*".to_owned(), "the one with the smallest excess, CHA-25A-50-H-C1024"),
        ("check disc.toml CHA_32A_50".to_owned(), "the best of them"),
        ("size log.csv".to_owned(), "axis.single_move = true"),
        ("inertia flange 200mm 60mm 25mm steel".to_owned(), "tube outer=200mm inner=60mm length=25mm"),
        ("inertia steel disc outer=200mm bore=60mm Dicke=25mm".to_owned(), "outer=200mm inner=60mm length=25mm"),
        ("inertia ring --outer 200mm --innen 60mm --h 25mm 7,85g/cm³".to_owned(), "density=7.85g/cm³"),
        ("pdf disc.toml".to_owned(), ""),
        ("version".to_owned(), ""),
        ("code CHA_25A_1x0_H_M512P".to_owned(), "code list"),
    ] {
        let found = call(folder.path(), &format!("antrieb {written}"));
        assert!(found.code < 2 && found.err.contains(part), "{written}\n{}", found.err);
    }
    let german = call(folder.path(), "antrieb auslegen disc.toml");
    assert!(german.out.contains("geeignet"), "{}", german.out);
    for kind in [
        "ballscrew",
        "rotarytable",
        "zachse",
        "foerderband",
        "kugelgewinde",
        "linear",
        "slide",
        "wheel",
        "schlitten",
        "dial",
        "tilt",
        "rad",
    ] {
        let made = call(folder.path(), &format!("antrieb new {kind}"));
        assert_eq!(made.code, 0, "{kind}\n{}", made.err);
    }
    // In an empty folder nothing is assumed; every refusal of a first call names some that work.
    let empty = tempfile::tempdir().unwrap();
    for written in ["", " code", " list", " show", " info", " catalogue", " code read", " frobnicate"] {
        let refused = call(empty.path(), &format!("antrieb{written}"));
        assert!(refused.code == 2 && !named(&refused.err).is_empty(), "{written}\n{}", refused.err);
    }
}

/// A text with wildcards lists every code whose fields it can be: the mandatory ones in their places, optional ones in their order.
#[test]
fn wildcards_list_every_code_that_they_can_be() {
    let folder = tempfile::tempdir().unwrap();
    let all = call(folder.path(), "antrieb code list").out;
    let codes: Vec<&str> = all.lines().map(|line| line.split('\t').next().unwrap()).collect();
    assert!(codes.len() > 1000);
    let is_like = |word: &str, text: &str| {
        word.len() == text.len() && word.bytes().zip(text.bytes()).all(|(own, sign)| sign == b'?' || own == sign)
    };
    let is_meant = |code: &str, text: &str| {
        let own: Vec<&str> = code.split('-').collect();
        let parts: Vec<&str> = text.split('-').collect();
        let mandatory = parts.len().min(5);
        let mut rest = own.iter().skip(5);
        parts.iter().take(mandatory).zip(&own).all(|(part, own)| is_like(own, part))
            && parts.iter().skip(5).all(|part| rest.any(|own| is_like(own, part)))
    };
    let (mut tried, mut further) = (0, 0);
    for (place, code) in codes.iter().enumerate().step_by(37) {
        let parts: Vec<&str> = code.split('-').collect();
        for cut in 2..=parts.len() {
            // One field with one letter, or all letters, unreadable.
            let worn = (place + cut) % (cut - 1) + 1;
            let whole = (place + cut) % 2 == 0;
            let unread = |word: &str| if whole { "?".repeat(word.len()) } else { format!("?{}", &word[1..]) };
            let part = |(at, word): (usize, &&str)| if at == worn { unread(word) } else { (*word).to_owned() };
            let text = parts.iter().take(cut).enumerate().map(part).collect::<Vec<_>>().join("-");
            let Some(pattern) = Pattern::parse_worn(&text, false) else { panic!("{text}") };
            for code in &codes {
                let is_listed = pattern.matches(&order_code::parse(code).unwrap().code);
                assert_eq!(is_listed, is_meant(code, &text), "{text} {code}");
            }
            tried += 1;
            further += usize::from(worn >= 5);
        }
    }
    assert!(tried > 100 && further > 10, "{tried} {further}");
}

/// A figure that a call states is never lost: not to a second one for the same key, not in a text, not as another number.
#[test]
fn no_stated_figure_is_lost() {
    let folder = folder();
    for (written, part) in [
        ("size disc.toml --mass 80kg --mass 90kg", "given twice"),
        ("check disc.toml --set ambient=20degC --set ambient=30degC", "given twice"),
        ("size disc.toml --load +15% --load +10%", "given twice"),
        ("size disc.toml --lang de --mass 1.000kg", "mehrdeutig"),
        ("size disc.toml --title Table", "--report"),
    ] {
        let refused = call(folder.path(), &format!("antrieb {written}"));
        assert!(refused.code == 2 && refused.err.contains(part), "{written}\n{}", refused.err);
    }
    for written in ["size disc.toml --tilt 30deg", "report disc.toml --friktion 5", "size disc.toml --faster 10%"] {
        let refused = call(folder.path(), &format!("antrieb {written}"));
        let is_field = ["--title", "--revision", "--order", "--author", "--date", "--number", "--customer"];
        let is_lost = is_field.iter().any(|field| refused.err.contains(field));
        assert!(refused.code == 2 && !is_lost, "{written}\n{}", refused.err);
    }
    let scaled = call(folder.path(), "antrieb size disc.toml --load +15%");
    let keys = ["load × 1.15: ", "mechanism.turntable.body[1].mass 30kg → 34.5kg"];
    assert!(keys.iter().all(|key| (scaled.out.clone() + &scaled.err).contains(key)), "{}", scaled.err);
    let pairs = call(folder.path(), "antrieb sweep disc.toml --mass 2,5kg,3,5kg --json");
    assert!(pairs.out.contains("\"2.5\"") && pairs.out.contains("\"3.5\""), "{}", pairs.err);
}
