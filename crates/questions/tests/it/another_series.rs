//! A series of invented figures, a folder of data and nothing else, through the ordering code, the data sheet, the sizing and
//! the report. A program of its own: what is added to the catalogue is added for all tests of a program.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test that cannot panic cannot fail")]

use order_code::Field;
use quantities::Language;
use questions::{Verdict, answer};

const PROJECT: &str = "format = 1\n[axis]\nname = \"invented axis\"\n[load]\ninertia = \"0.4 kg m^2\"\nfriction_torque = \"3 N m\"\n\
    [[motion]]\nlaw = \"manual\"\nspeed = \"40 1/min\"\naccelerate = \"0.2 s\"\nrun = \"0.3 s\"\nbrake = \"0.2 s\"\n\
    pause = \"1 s\"\n";

#[test]
fn an_invented_series_goes_through_code_data_size_and_report() {
    testkit::series::add(&testkit::series::invented());
    codes();
    data();
    sizes();
    reports();
    the_first_series_is_what_it_was();
}

fn codes() {
    // Another order of the fields, an optional one amid them, small letters and no hyphens.
    let reading = questions::read_code("inv v07c 42xqe", Language::En).unwrap_or_else(|_| unreachable!());
    let code = reading.parsed.code;
    assert_eq!(code.to_string(), "INV-V-07C-42-X-QE");
    assert_eq!((code.size.number(), code.ratio.value()), (7, 42));
    let explained = questions::list::code_parse::explain_code(&code, Language::De);
    let meaning = |field| explained.iter().find(|(known, ..)| *known == field).map(|(_, _, text)| text.clone());
    assert_eq!(meaning(Field::Size).as_deref(), Some("erfundene Baugröße 07C"));
    assert_eq!(meaning(Field::Brake).as_deref(), Some("mit Bremse"));
    // 64 does not exist at the smaller size, the resolver only on request.
    let refused = |text: &str| match questions::read_code(text, Language::En) {
        Ok(_) => Vec::new(),
        Err(refusal) => {
            let nearest = refusal.nearest.iter().map(|(code, _)| code.to_string()).collect();
            [refusal.faults.into_iter().map(|fault| fault.message).collect::<Vec<_>>(), nearest].concat()
        }
    };
    let faults = refused("INV-V-07C-64-QE");
    assert_eq!(faults[0], "reduction ratio 64 does not exist for size 07C (table inv-1)");
    assert!(faults[1..].iter().all(|near| near.starts_with("INV-V-")) && faults.len() > 1, "{faults:?}");
    assert_eq!(refused("INV-V-08C-42-QE").len().min(2), 2, "a fault and a proposal");
    let resolver = questions::read_code("INV-V-07C-42-RS", Language::En).unwrap_or_else(|_| unreachable!());
    assert_eq!(resolver.availability.on_request, [Field::Feedback]);
    // QE and RS, with and without brake: three pairs of size and ratio.
    let all = questions::list::code_list::list_codes(Some(&order_code::Pattern::parse("INV").unwrap()));
    assert_eq!(all.len(), 3 * 4);
}

fn data() {
    let code = order_code::parse("INV-V-09C-64-QE").unwrap().code;
    let sheet = answer::sheet(&questions::list::data::sheet(&code).unwrap(), Language::En);
    let text = serde_json::to_string(&sheet).unwrap();
    for printed in ["inv-09c", "inv-6", "inv-5", "inv-4", "Technical data 09C"] {
        assert!(text.contains(printed), "{printed}");
    }
    assert!(!text.contains("CHA") && !text.contains("inv-07c"), "{text}");
}

fn sizes() {
    let project = &questions::read_all(PROJECT, &axis::NoFiles).unwrap()[0];
    let ranked = questions::size(project);
    let of_inv = ranked.candidates.iter().filter(|candidate| candidate.id.to_string().starts_with("INV-"));
    // Those available without asking: 07C with QE, 09C with both, each with and without brake.
    assert_eq!(of_inv.clone().count(), 2 + 2 * 4);
    assert!(ranked.candidates.len() > 200, "the first series is judged too");
    let code = order_code::parse("INV-V-09C-42-X-QE").unwrap().code;
    let chosen = questions::check(project, &code).unwrap_or_else(|_| unreachable!());
    let judged = |id: &str| {
        let check = chosen.judgement.checks.iter().find(|check| check.id.id() == id).unwrap();
        (check.verdict, check.limit.as_ref().map(|limit| limit.si))
    };
    assert_eq!(judged("peak_torque"), (Verdict::Pass, Some(210.0)));
    assert_eq!(judged("inertia_ratio").1, Some(5.0 * 0.75));
}

/// The record that the report is typeset from, in both languages.
fn reports() {
    let project = &questions::read_all(PROJECT, &axis::NoFiles).unwrap()[0];
    let ranked = questions::size(project);
    let code = order_code::parse("INV-V-09C-42-X-QE").unwrap().code;
    let chosen = questions::check(project, &code).unwrap_or_else(|_| unreachable!());
    let reserve = questions::reserve_of(project, &chosen);
    for language in Language::ALL {
        let text = (PROJECT, 0, "antrieb of the tests");
        let dossier = answer::dossier(
            project,
            &ranked,
            &chosen,
            (&reserve, None, &questions::Proposals::default()),
            text,
            language,
        );
        assert!(dossier.documents.iter().any(|document| document.id == "inv-manual"));
        let text = serde_json::to_string(&dossier).unwrap();
        let meaning = if language == Language::De { "erfundener Geber" } else { "invented encoder" };
        assert!(text.contains("INV-V-09C-42-X-QE") && text.contains(meaning), "{text}");
    }
}

fn the_first_series_is_what_it_was() {
    let code = order_code::parse("CHA-20A-100-H-C1024-B").unwrap().code;
    assert_eq!(code.series(), order_code::Series::default());
    let sheet =
        serde_json::to_string(&answer::sheet(&questions::list::data::sheet(&code).unwrap(), Language::En)).unwrap();
    assert!(!sheet.contains("inv-"), "{sheet}");
}
