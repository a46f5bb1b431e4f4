//! `report`: the results as the PDF that an engineer signs.

use crate::answer::{Answer, written};
use crate::fault::{Source, simple};
use crate::save::save;
use crate::subject::candidate;
use crate::subject::picked;
use clap::ArgMatches;
use figures::{By, Drawing, Figure, Style, Theme};
use report::{Content, Settings};
use std::path::{Path, PathBuf};
use workbench::answers::ReportWritten;
use workbench::text::standing_text;
use workbench::{Candidate, Language, Project, Sampling, Sizing, answer};

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
    let [axis @ (_, project)] = projects.as_slice() else {
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
    let content = content((axis.0, project), &sizing, &candidate, &source.text, language);
    let bytes =
        report::pdf(&content, &settings(matches)).map_err(|fault| simple(&fault.to_string(), as_json, language))?;
    save(&[(out, &bytes)], matches.get_flag("force"))
        .map_err(|fault| simple(&fault.message(language), as_json, language))?;
    let verdict = standing_text(&candidate, language);
    let data = if as_json {
        written(&ReportWritten {
            file: out.display().to_string(),
            code: candidate.id.to_string(),
            verdict: answer::fit(&candidate),
            bytes: bytes.len(),
        })
    } else {
        format!("{}: {}: {verdict}; {} kB\n", out.display(), candidate.id, bytes.len() / 1000)
    };
    Ok(Answer { talk, ..Answer::data(data) }.fits(candidate.fits()))
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

/// Results as a record and as figures, side by side. A thread that could not finish leaves its part to this one.
fn content(
    (place, project): (usize, &Project),
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
        let reserve = workbench::reserve_of(project, candidate);
        let assessed = workbench::assess(project, &[candidate], Sampling::default());
        let dossier = answer::dossier(
            project,
            sizing,
            candidate,
            (&reserve, assessed.first()),
            (text, place, concat!("antrieb ", env!("CARGO_PKG_VERSION"))),
            language,
        );
        Content { language, dossier, figures: drawn.join().unwrap_or_else(|_| figures()) }
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
