//! The list of questions: every entry is whole, and answers.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, reason = "a test fails loudly")]

use axis::NoFiles;
use quantities::Language;
use questions::list::{
    ArgumentForm, ArgumentKind, Entry, Given, Gives, Inquiry, LIST, Reads, ReferencedText, Unanswered, size,
};
use questions::{Progress, Refusal};
use std::borrow::Cow;

const PROJECT: &str = "format = 1\n[load]\ninertia = \"1.3 kg m^2 ± 5 %\"\n[[motion]]\nlaw = \"manual\"\n\
    speed = \"40 1/min\"\naccelerate = \"0.1 s\"\nrun = \"0.1 s\"\nbrake = \"0.1 s\"\npause = \"1 s\"\n";

fn inquiry<'a>(entry: &Entry, pairs: &[(&'a str, &'a str)], progress: &'a Progress) -> Result<Inquiry<'a>, Unanswered> {
    let pairs = pairs.iter().map(|(name, value)| (Cow::Borrowed(*name), Cow::Borrowed(*value)));
    let given = Given::of(entry.arguments, pairs, Language::En)?;
    let source =
        || ReferencedText { name: "axis.toml".into(), bytes: Cow::Borrowed(PROJECT.as_bytes()), files: &NoFiles };
    let sources = match entry.reads {
        Reads::Nothing | Reads::Pins | Reads::Measured => Vec::new(),
        Reads::Project => vec![source()],
        Reads::TwoProjects => vec![source(), source()],
    };
    let catalogue = questions::embedded_catalogue();
    Ok(Inquiry {
        given,
        sources,
        catalogue,
        days_since_1970: None,
        progress,
        refuses_long: true,
        by_axes: false,
        language: Language::En,
    })
}

fn answered(command: &str, pairs: &[(&str, &str)]) -> Result<serde_json::Value, Unanswered> {
    let entry = LIST.iter().find(|entry| entry.command == command).unwrap();
    let progress = Progress::endless();
    let answer = entry.answer.unwrap()(&inquiry(entry, pairs, &progress)?)?;
    Ok(serde_json::from_str(&answer.text).unwrap())
}

/// Names are unique, words are there in both languages, what stands for another argument exists.
#[test]
fn every_entry_is_whole() {
    let schema = answers::schema(&questions::list::records());
    for (place, entry) in LIST.iter().enumerate() {
        let others = LIST.iter().skip(place + 1);
        assert!(others.clone().all(|other| other.command != entry.command), "{}", entry.command);
        let routes = others.filter(|other| other.path == entry.path);
        assert!(routes.clone().all(|other| (other.reads == Reads::Nothing) != (entry.reads == Reads::Nothing)));
        assert!((entry.about)(Language::En) != (entry.about)(Language::De), "{}", entry.command);
        for (place, argument) in entry.arguments.iter().enumerate() {
            let (name, command) = (argument.name, entry.command);
            assert!(entry.arguments.iter().skip(place + 1).all(|other| other.name != name), "{command} {name}");
            assert!((argument.about)(Language::En) != (argument.about)(Language::De), "{command} {name}");
            let is_argument = |other: &str| entry.arguments.iter().any(|argument| argument.name == other);
            assert!(argument.instead_of.is_none_or(is_argument), "{command} {name}");
            let is_option = |other: &str| entry.option() == Some(other);
            assert!(argument.needs.is_none_or(|other| is_argument(other) || is_option(other)), "{command} {name}");
            assert!(
                !matches!(argument.kind, ArgumentKind::Word(_)) || !argument.words().is_empty(),
                "{command} {name}"
            );
            assert!(argument.form != ArgumentForm::Each || argument.repeated, "{command} {name}");
        }
        match entry.gives {
            Gives::Record(record) | Gives::RecordOr(record, _) => {
                assert!(schema["properties"][record.command].is_object(), "{}", record.command);
            }
            Gives::Json | Gives::Media(_) => {}
        }
    }
}

#[test]
fn a_question_about_an_axis_has_its_record() {
    let sizing = answered("size", &[("top", "3"), ("samples", "50")]).unwrap();
    assert_eq!((sizing["judged"].as_u64(), sizing["ranking"].as_array().unwrap().len()), (Some(276), 3));
    assert!(sizing["ranking"][0]["tolerance"].is_object());
    let code = ("code", "CHA-32A-50-H-C1024");
    let judged = answered("check", &[code, ("samples", "50"), ("seed", "1")]).unwrap();
    assert!(judged["tolerance"].is_object() && judged["code"] == code.1, "{judged}");
    let explained = answered("explain", &[code, ("check", "thermal")]).unwrap();
    assert_eq!(explained["checks"].as_array().unwrap().len(), 1);
    let compared = answered("compare", &[code, ("code", "CHA-40A-50-H-C1024")]).unwrap();
    assert_eq!(compared["candidates"].as_array().unwrap().len(), 2);
    assert!(answered("diff", &[code]).unwrap()["inputs"].as_array().unwrap().is_empty());
}

#[test]
fn what_cannot_be_answered_is_refused() {
    let refusal = |command, pairs: &[(&str, &str)]| match answered(command, pairs).unwrap_err() {
        Unanswered::Refused(refusal, _) => refusal,
        other => panic!("{other:?}"),
    };
    assert_eq!(refusal("check", &[("code", "CHA-58A-50-H-RES")]), Refusal::NoData);
    let brake = [("code", "CHA-32A-50-H-C1024"), ("check", "brake_holding")];
    assert!(matches!(refusal("explain", &brake), Refusal::NotAsked(_)));
    assert!(matches!(refusal("size", &[("samples", "1000000")]), Refusal::TooManySamples { .. }));
}

/// Every fault of the arguments at once.
#[test]
fn every_fault_of_the_arguments_is_reported_at_once() {
    let why = answered("wiring", &[("code", "CHA-99"), ("length", "5 kg"), ("cross-section", "1 mm")]).unwrap_err();
    let options: Vec<_> = why.faults(None, Language::En).errors.into_iter().map(|fault| fault.option).collect();
    assert!(options.len() >= 3 && options.contains(&Some("length".into())), "{options:?}");
    let needs = answered("wiring", &[("code", "CHA-25A-100-H-M512P-B"), ("cross-section", "1 mm^2")]).unwrap_err();
    assert!(matches!(needs, Unanswered::Usage(errors) if errors[0].option.as_deref() == Some("length")));
    let progress = Progress::endless();
    let args = size::Args::read(&inquiry(&size::ENTRY, &[], &progress).unwrap().given).unwrap();
    assert_eq!((args.top, args.all, args.samples, args.axis), (10, false, None, None));
}
