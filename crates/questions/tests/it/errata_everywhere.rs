//! Every number that rests on a cell with an erratum names the erratum: all codes, every question about one.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail")]

use axis::NoFiles;
use catalogue::Cell;
use order_code::OrderCode;
use provenance::Source as Origin;
use quantities::Language;
use questions::Progress;
use questions::list::{Entry, Given, Gives, Inquiry, LIST, Reads, ReferencedText};
use serde_json::Value;
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};

const AXIS: &str = "format = 1\n[load]\ninertia = \"0.05 kg m^2\"\n[[motion]]\nlaw = \"manual\"\nspeed = \"20 1/min\"\n\
    accelerate = \"0.2 s\"\nrun = \"0.5 s\"\nbrake = \"0.2 s\"\npause = \"0.5 s\"\n";

/// Further arguments without which a question is not answered.
const FURTHER: [(&str, &[(&str, &str)]); 4] = [
    ("upkeep", &[("delivered", "2026-03-01")]),
    ("torsion", &[("torque", "5 N m")]),
    ("battery", &[("hours-per-day", "8 h")]),
    ("commission", &[("for", "sinamics")]),
];

fn codes() -> Vec<OrderCode> {
    crate::catalogue_actuators().map(|(code, _)| *code).collect()
}

/// Errata of the cells of a code, by the text that cites the cell.
fn doubts(code: &OrderCode) -> BTreeMap<String, BTreeSet<&'static str>> {
    let ratio = code.ratio.to_string();
    let feedback = code.feedback.as_str();
    let of_encoder =
        |cell: &&'static Cell| cell.feedback == feedback && (cell.place.ratio.is_empty() || cell.place.ratio == ratio);
    let own = catalogue::cells_about(code.size, code.winding, code.feedback, code.ratio);
    let mut found: BTreeMap<String, BTreeSet<&'static str>> = BTreeMap::new();
    for cell in own.into_iter().chain(catalogue::cells().filter(of_encoder)) {
        if !cell.errata.is_empty() {
            let text = words::source_text(&Origin::Cell(&cell.place), Language::En);
            found.entry(text).or_default().extend(cell.errata);
        }
    }
    found
}

fn answered(entry: &Entry, pairs: &[(&str, &str)]) -> Option<Value> {
    let progress = Progress::endless();
    let cow = |text| Cow::Borrowed(text);
    let given =
        Given::of(entry.arguments, pairs.iter().map(|(name, value)| (cow(*name), cow(*value))), Language::En).ok()?;
    let source = || ReferencedText { name: "axis.toml".into(), bytes: Cow::Borrowed(AXIS.as_bytes()), files: &NoFiles };
    let sources = match entry.reads {
        Reads::Nothing => Vec::new(),
        Reads::Project => vec![source()],
        Reads::Pins | Reads::Measured | Reads::TwoProjects => return None,
    };
    let inquiry = Inquiry {
        given,
        sources,
        catalogue: questions::embedded_catalogue(),
        days_since_1970: None,
        progress: &progress,
        refuses_long: false,
        by_axes: false,
        language: Language::En,
    };
    let answer = entry.answer?(&inquiry).ok()?;
    serde_json::from_str(&answer.text).ok()
}

/// Every record with a source: the texts of its sources, its errata, its place in the answer.
fn sourced(value: &Value, place: &str, found: &mut Vec<(Vec<String>, Vec<String>, String)>) {
    match value {
        Value::Object(record) => {
            let text = |key: &str| record.get(key).and_then(Value::as_str).unwrap_or_default().to_owned();
            let sources: Vec<String> = ["source", "value_source", "limit_source"]
                .into_iter()
                .flat_map(|key| text(key).split("; ").map(str::to_owned).collect::<Vec<_>>())
                .filter(|source| !source.is_empty())
                .collect();
            let id = |each: &Value| each.as_str().or_else(|| each.get("id")?.as_str()).unwrap_or_default().to_owned();
            let errata = record.get("errata").and_then(Value::as_array).into_iter().flatten().map(id).collect();
            if !sources.is_empty() {
                found.push((sources, errata, place.to_owned()));
            }
            for (key, inner) in record {
                sourced(inner, &format!("{place}.{key}"), found);
            }
        }
        Value::Array(items) => items.iter().for_each(|item| sourced(item, place, found)),
        _ => {}
    }
}

#[test]
fn what_rests_on_a_doubtful_cell_names_its_erratum() {
    let mut silent: BTreeSet<String> = BTreeSet::new();
    let (mut named, mut seen) = (BTreeSet::new(), BTreeSet::new());
    for (place, code) in codes().into_iter().enumerate() {
        let doubts = doubts(&code);
        let text = code.to_string();
        for entry in LIST.iter().filter(|entry| matches!(entry.gives, Gives::Record(_) | Gives::RecordOr(..))) {
            if !entry.arguments.iter().any(|argument| argument.name == "code") || entry.command == "simulate" {
                continue;
            }
            // Judging takes long: some codes, of every size and winding.
            if entry.reads == Reads::Project && place % 7 != 0 {
                continue;
            }
            let further =
                FURTHER.iter().find(|(command, _)| *command == entry.command).map_or(&[][..], |(_, pairs)| pairs);
            let mut forms = vec![further.to_vec()];
            if entry.command == "commission" {
                forms.push(vec![("for", "cia402")]);
            }
            for mut pairs in forms {
                pairs.push(("code", &text));
                let Some(answer) = answered(entry, &pairs) else { continue };
                seen.insert(entry.command);
                let mut records = Vec::new();
                sourced(&answer, entry.command, &mut records);
                for (sources, errata, place) in records {
                    for (source, ids) in sources.iter().filter_map(|source| Some((source, doubts.get(source)?))) {
                        for id in ids {
                            if errata.iter().any(|each| each == id) {
                                named.insert(*id);
                            } else {
                                silent.insert(format!("{place}: {source} without {id}"));
                            }
                        }
                    }
                }
            }
        }
    }
    assert!(silent.is_empty(), "{} {silent:#?}", silent.len());
    assert!(named.len() > 30 && ["14A-H/N-k_TM", "17A-H/N-k_TM"].iter().all(|id| named.contains(id)), "{named:?}");
    assert!(seen.len() >= 6, "{seen:?}");
}

/// A file for a drive marks the value and states the evidence.
#[test]
fn files_for_a_drive_mark_doubtful_values() {
    use questions::list::commission::commission;
    use questions::list::commission_drive::{eds, sinamics_script};
    let mut marked = 0;
    for code in codes() {
        let about = commission(&code).unwrap();
        let of = |id: &str| about.parameters.iter().find(|each| each.id.id() == id).map(|each| each.errata.clone());
        for (language, evidence) in [(Language::En, "evidence"), (Language::De, "evidence_de")] {
            let (script, sheet) = (sinamics_script(&about, language), eds(&about, language));
            for (number, id) in
                [("p0316", "torque_constant_motor"), ("p0319", "stall_torque_motor"), ("p0318", "stall_current")]
            {
                let line = script.lines().find(|line| line.starts_with(number)).unwrap();
                for erratum in of(id).unwrap() {
                    assert!(line.contains('†') && line.contains(erratum), "{code}: {line}");
                    let text = words::evidence_text(erratum, language);
                    assert!(script.contains(text), "{code} {evidence}: {erratum}");
                    marked += 1;
                }
            }
            for erratum in of("stall_torque_motor").unwrap() {
                let of_object = sheet.split("\n[").find(|section| section.starts_with("6076]")).unwrap();
                assert!(of_object.contains(erratum), "{code}: {of_object}");
            }
            assert!(sheet.lines().all(|line| line.len() <= 255), "{code}");
        }
    }
    assert!(marked > 100, "{marked}");
}
