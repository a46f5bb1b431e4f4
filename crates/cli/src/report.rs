//! `report`: the results as the PDF that an engineer signs.

use crate::answer::Answer;
use crate::fault::{Source, simple};
use crate::save::save;
use crate::subject::candidate;
use crate::subject::picked;
use clap::ArgMatches;
use figures::{By, Drawing, Figure, Style, Theme};
use report::{Content, Settings};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use workbench::text::standing_text;
use workbench::{Candidate, Language, Project, Sizing, catalogue_fingerprint, json as answers, project_fingerprint};

/// The figures of the report beside the map of the candidates, each with its place there.
const FIGURES: [(&str, Figure); 4] = [
    ("motion", Figure::Cycle),
    ("torque_speed", Figure::TorqueSpeed),
    ("output_bearing", Figure::BearingLoad),
    ("gear", Figure::Torsion),
];

/// `antrieb report PROJECT --out FILE`
pub(crate) fn report(matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    let out = matches.get_one::<PathBuf>("out").cloned().unwrap_or_default();
    write(matches, &out, as_json, language).unwrap_or_else(|answer| answer)
}

/// Writes the report of the axis and the actuator that are asked for.
pub(crate) fn write(matches: &ArgMatches, out: &Path, as_json: bool, language: Language) -> Result<Answer, Answer> {
    if !out.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("pdf")) {
        let what = match language {
            Language::En => format!("a report is a PDF: name a file that ends in .pdf, not {}", out.display()),
            Language::De => {
                format!("ein Bericht ist ein PDF: eine Datei mit der Endung .pdf nennen, nicht {}", out.display())
            }
        };
        return Err(simple(&what, as_json, language));
    }
    let path = matches.get_one::<PathBuf>("project").cloned().unwrap_or_default();
    let source = Source::read(&path, as_json, language)?;
    let projects = picked(source.projects(as_json, language)?, matches, as_json, language)?;
    let [(_, project)] = projects.as_slice() else {
        let names: Vec<&str> = projects.iter().map(|(_, project)| project.name.as_str()).collect();
        let names = names.join(", ");
        let what = match language {
            Language::En => format!("a report is that of one axis; name it with --axis: {names}"),
            Language::De => format!("ein Bericht gilt für eine Achse; sie mit --axis nennen: {names}"),
        };
        return Err(simple(&what, as_json, language));
    };
    let sizing = workbench::size(project);
    let best = || sizing.candidates.first().map(|best| best.id.clone());
    let (candidate, talk) = candidate(project, best, matches, as_json, language)?;
    let content = content(project, &sizing, &candidate, &source.text, language);
    let bytes =
        report::pdf(&content, &settings(matches)).map_err(|fault| simple(&fault.to_string(), as_json, language))?;
    save(&[(out, &bytes)], matches.get_flag("force"))
        .map_err(|fault| simple(&fault.message(language), as_json, language))?;
    let verdict = standing_text(&candidate, language);
    let data = if as_json {
        let value = json!({
            "file": out.display().to_string(),
            "code": candidate.id.to_string(),
            "verdict": answers::verdict(&candidate),
            "bytes": bytes.len(),
        });
        format!("{value:#}\n")
    } else {
        format!("{}: {}: {verdict}; {} kB\n", out.display(), candidate.id, bytes.len() / 1000)
    };
    Ok(Answer { data, talk, code: u8::from(!candidate.fits()) })
}

fn settings(matches: &ArgMatches) -> Settings {
    let text = |name: &str| {
        let given = matches.try_get_one::<String>(name).ok().flatten();
        given.cloned().unwrap_or_default()
    };
    Settings {
        date: Some(text("date")).filter(|date| !date.is_empty()),
        revision: text("revision"),
        project: text("title"),
        number: text("number"),
        author: text("author"),
        company: text("company"),
        pdf_a: matches.try_get_one::<bool>("archive").ok().flatten().copied().unwrap_or(false),
    }
}

/// Results as data and as figures, side by side. A thread that could not finish leaves its part to this one.
fn content(
    project: &Project,
    sizing: &Sizing<'_>,
    candidate: &Candidate<'_>,
    text: &str,
    language: Language,
) -> Content {
    let figures = || drawn_figures(project, sizing, candidate, language);
    std::thread::scope(|scope| {
        let drawn = scope.spawn(|| {
            report::prepare();
            figures()
        });
        let search = || workbench::reserve_of(project, candidate);
        let searched = scope.spawn(search);
        let mut data = data(project, sizing, candidate, text, language);
        let reserve = answers::reserve(&searched.join().unwrap_or_else(|_| search()), candidate);
        if let Some(Value::Object(judged)) = data.get_mut("check") {
            judged.insert("reserve".into(), reserve);
        }
        Content { language, data, figures: drawn.join().unwrap_or_else(|_| figures()) }
    })
}

fn data(project: &Project, sizing: &Sizing<'_>, candidate: &Candidate<'_>, text: &str, language: Language) -> Value {
    let motion = answers::moves(&workbench::moves(project), language);
    let assumptions = answers::assumptions(&project.assumptions, language);
    let mut judged = answers::candidate(candidate, language);
    if let Value::Object(map) = &mut judged {
        map.insert("axis".into(), json!(project.name));
        map.insert("motion".into(), motion.clone());
        map.insert("assumptions".into(), json!(assumptions));
    }
    let mut ranking = answers::sizing(sizing, project, &[], usize::MAX, language);
    if let Value::Object(map) = &mut ranking {
        map.insert("motion".into(), motion);
    }
    let explained = match &candidate.id {
        workbench::CandidateId::Code(code) => workbench::explain(project, code),
        workbench::CandidateId::Own(_) => workbench::explain_own(project),
    };
    let derivations: Vec<Value> = explained
        .iter()
        .flat_map(|explained| &explained.judgement.checks)
        .map(|check| answers::explain(check, language))
        .collect();
    let inputs = report::inputs(text).unwrap_or_default();
    json!({
        "check": judged,
        "sizing": ranking,
        "inputs": inputs,
        "assumptions": assumptions,
        "explain": { "axis": project.name, "code": candidate.id.to_string(), "checks": derivations },
        "hash": { "project": project_fingerprint(text, &project.recordings), "catalogue": catalogue_fingerprint() },
        "screws": answers::screws(candidate, language),
        "bill_of_material": answers::bill_of_material(candidate, language),
    })
}

fn drawn_figures(
    project: &Project,
    sizing: &Sizing<'_>,
    candidate: &Candidate<'_>,
    language: Language,
) -> Vec<report::Figure> {
    let figures = FIGURES.iter().filter_map(|(place, figure)| {
        let drawing = figures::draw(*figure, project, candidate, By::Mass, language).ok()?;
        Some(drawn(place, &drawing, language))
    });
    let map = figures::candidate_map(sizing, By::Mass, Some(&candidate.id), language);
    figures.chain([drawn("alternatives", &map, language)]).collect()
}

fn drawn(place: &str, drawing: &Drawing, language: Language) -> report::Figure {
    let style = Style::new(drawing.size()).theme(Theme::Light).language(language).id(place);
    report::Figure {
        name: place.to_owned(),
        svg: drawing.render(&style).into_svg(),
        caption: drawing.caption.clone(),
        alternative_text: drawing.description.clone(),
    }
}
