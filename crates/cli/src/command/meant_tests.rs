use super::*;
use crate::command::example::filled;
use crate::command::{build, examples};
use ::words::{Usage, usage_hint, usage_text};
use clap::error::ErrorKind;

/// Words of every kind that a call may contain.
const WORDS: [&str; 26] = [
    "CHA-25A-50-H-C1024",
    "30deg",
    "-30deg",
    "1.5 s",
    "2h",
    "60Nm",
    "100mm",
    "0.5 mm^2",
    "220 V",
    "20 degC",
    "0.2kgm^2",
    "3000rpm",
    "2026-03-01",
    "7",
    "8080",
    "de",
    "axis.pdf",
    "axis.svg",
    "axis.csv",
    "axis.toml",
    "load=1.15",
    "mass=3kg",
    "512 MiB",
    "K7",
    "emergency_stop",
    "nonsense",
];

fn words(call: &str) -> Vec<OsString> {
    let mut words = Vec::new();
    for (place, part) in call.split('"').enumerate() {
        if place % 2 == 1 {
            words.push(part.into());
        } else {
            words.extend(part.split_whitespace().map(OsString::from));
        }
    }
    words
}

/// Returns the calls that a refusal names.
fn named(usage: &(Usage, Option<UsageHint>)) -> Vec<String> {
    match &usage.1 {
        Some(UsageHint::Calls(calls)) => calls.clone(),
        _ => Vec::new(),
    }
}

fn is_read(call: &str, whole: &Command) -> bool {
    let understood = understood(words(call), whole, Language::En);
    understood.stray.is_none() && whole.clone().try_get_matches_from(&understood.arguments).is_ok()
}

/// A further word of a call is taken, or the refusal names calls that work, with the word where an option takes it.
#[test]
fn a_further_word_is_taken_or_its_refusal_names_calls_that_work() {
    let whole = build(Language::En);
    let (mut taken, mut refused) = (0, 0);
    for (_, example) in examples() {
        let arguments = words(&example);
        let Some(called) = Called::of(&arguments, &whole, Language::En) else { continue };
        if called.entry.is_none() || example.contains("&&") {
            continue;
        }
        for word in WORDS {
            let mut call = arguments.clone();
            call.insert(arguments.len(), word.into());
            let Understood { arguments: meant, stray } = understood(call, &whole, Language::En);
            let Some(stray) = stray else {
                let read = whole.clone().try_get_matches_from(&meant);
                let is_refused = match read.as_ref().err().map(clap::Error::kind) {
                    Some(ErrorKind::MissingRequiredArgument) => {
                        filled(&meant, &called).is_some_and(|call| is_read(&call, &whole))
                    }
                    kind => kind == Some(ErrorKind::ArgumentConflict),
                };
                assert!(read.is_ok() || is_refused, "{example} {word}: {meant:?} {read:?}");
                taken += 1;
                continue;
            };
            refused += 1;
            let calls = named(&stray.fault(&called, &meant));
            assert!(!calls.is_empty(), "{example} {word}");
            for named in &calls {
                assert!(is_read(named, &whole), "{example} {word}: {named}");
                assert!(
                    stray.options.is_empty() || stray.options.iter().any(|(_, value)| named.contains(value.as_str())),
                    "{named}"
                );
            }
        }
    }
    assert!(taken > 100 && refused > 100, "{taken} {refused}");
}

/// A call that lacks something is answered by one that works and begins with the words of the call.
#[test]
fn what_a_call_lacks_is_filled_in_behind_its_own_words() {
    let whole = build(Language::En);
    let mut lacking = 0;
    for (_, example) in examples() {
        let arguments = words(&example);
        let Some(called) = Called::of(&arguments, &whole, Language::En)
            .filter(|called| called.entry.is_some() && !example.contains("&&"))
        else {
            continue;
        };
        for count in called.begin..arguments.len() {
            let begun = &arguments[..count];
            let read = whole.clone().try_get_matches_from(begun);
            if read.err().map(|error| error.kind()) != Some(ErrorKind::MissingRequiredArgument) {
                continue;
            }
            lacking += 1;
            let found = filled(begun, &called).unwrap_or_else(|| panic!("{begun:?}"));
            assert!(is_read(&found, &whole), "{found}");
            let own = super::super::typed::typed(begun.iter().filter_map(|word| word.to_str()));
            assert!(found.starts_with(&own), "{found} {own}");
        }
    }
    assert!(lacking > 15, "{lacking}");
    let call = |text: &str| {
        let arguments = words(text);
        Called::of(&arguments, &whole, Language::En).and_then(|called| filled(&arguments, &called))
    };
    for (written, meant) in [
        ("antrieb torsion CHA-25A-100-H-M512P", "antrieb torsion CHA-25A-100-H-M512P --torque \"60 N m\""),
        ("antrieb sweep press.toml --table t.csv", "antrieb sweep press.toml --table t.csv --out best.parquet"),
        ("antrieb torsion --torque 20Nm", "antrieb torsion CHA-20A-100-H-C1024 --torque 20Nm"),
    ] {
        assert_eq!(call(written).as_deref(), Some(meant), "{written}");
    }
}

#[test]
fn words_without_an_option_are_taken_by_their_form() {
    let whole = build(Language::En);
    let meant = |call: &str| {
        let found = understood(words(call), &whole, Language::En);
        (found.stray.is_none())
            .then(|| found.arguments.iter().filter_map(|word| word.to_str()).collect::<Vec<_>>().join(" "))
    };
    for (written, expected) in [
        ("antrieb battery 10 h", Some("antrieb battery --hours-per-day 10 h")),
        ("antrieb battery 10", Some("antrieb battery --hours-per-day 10")),
        ("antrieb torsion 60Nm CHA-20A-100-H-C1024", Some("antrieb torsion --torque 60Nm CHA-20A-100-H-C1024")),
        ("antrieb torsion CHA-20A-100-H-C1024 60 N m", Some("antrieb torsion CHA-20A-100-H-C1024 --torque 60 N m")),
        ("antrieb encoder CHA-25A-100-H-M512P 30deg", Some("antrieb encoder CHA-25A-100-H-M512P --angle 30deg")),
        (
            "antrieb encoder CHA-25A-100-H-M512P angle -30deg",
            Some("antrieb encoder CHA-25A-100-H-M512P --angle -30deg"),
        ),
        ("antrieb encoder CHA-25A 100 H M512P 3000rpm", Some("antrieb encoder CHA-25A 100 H M512P --speed 3000rpm")),
        ("antrieb encoder CHA-25A-100-H-M512P angle=3deg", Some("antrieb encoder CHA-25A-100-H-M512P --angle 3deg")),
        ("antrieb new rotary table x.toml", Some("antrieb new rotary table --out x.toml")),
        ("antrieb new recording no-such.csv", None),
        (
            "antrieb report a.toml report.pdf 2026-03-01 full",
            Some("antrieb report a.toml --out report.pdf --date 2026-03-01 --full"),
        ),
        (
            "antrieb upkeep CHA-14A-50-E-M128S 2026-03-01",
            Some("antrieb upkeep CHA-14A-50-E-M128S --delivered 2026-03-01"),
        ),
        ("antrieb size a.toml top 3 de", Some("antrieb size a.toml --top 3 --lang de")),
        ("antrieb size a.toml load=1.2 mass=3kg", Some("antrieb size a.toml --scale load=1.2 --set mass=3kg")),
        ("antrieb identify a.toml run.csv", Some("antrieb identify run.csv a.toml")),
        ("antrieb serve 8080", Some("antrieb serve --port 8080")),
        ("antrieb size a.toml 5", None),
        ("antrieb size a.toml --tpo 5", Some("antrieb size a.toml --tpo 5")),
        ("antrieb glossary output bearing", Some("antrieb glossary output bearing")),
    ] {
        assert_eq!(meant(written).as_deref(), expected, "{written}");
    }
}

#[test]
fn a_refusal_is_said_in_both_languages() {
    let whole = build(Language::En);
    for (call, parts) in [
        ("antrieb battery CHA-25A-50-H-C1024", ["antrieb code parse CHA-25A-50-H-C1024", "antrieb code list"]),
        ("antrieb explain a.toml termal", ["termal", "antrieb explain a.toml --check thermal"]),
        ("antrieb check a.toml --code X CHA-25A-50-H-C1024", ["--code", "antrieb check a.toml --code X"]),
    ] {
        let Understood { arguments, stray } = understood(words(call), &whole, Language::En);
        let called = Called::of(&arguments, &whole, Language::En).unwrap();
        let (usage, hint) = stray.unwrap().fault(&called, &arguments);
        let [en, de] = Language::ALL
            .map(|language| usage_text(&usage, language) + "\n" + &usage_hint(hint.as_ref().unwrap(), language));
        assert!(en != de, "{en}");
        for part in parts {
            assert!([&en, &de].iter().all(|text| text.contains(part)), "{part}\n{en}\n{de}");
        }
    }
}
