//! `report`: the results as the PDF that an engineer signs.

use crate::answer::{Answer, written};
use crate::fault::{Source, option_fault, path_text, simple, text_option};
use crate::save::{Unwritten, ready, save};
use crate::subject::candidate;
use crate::subject::{in_reach, picked, refuse};
use crate::waiting::patience;
use clap::ArgMatches;
use figures::{By, Drawing, Figure, Style, Theme};
use page::{Press, ReportAsked};
use report::{AxisContent, Content, Place, Settings};
use std::path::{Path, PathBuf};
use workbench::answers::{AxisWritten, Chapter, Commissioning, Fit, Picture, ReportWritten};
use workbench::text::{standing_text, terminal};
use workbench::{
    Candidate, CandidateId, Draw, DriveForm, Language, MountAsked, OrderCode, Patience, Project, Question, Refusal,
    Sizing, UpkeepAsked, answer, chapter, usual_ambient,
};

/// The figures of the report beside the map of the candidates, each with its place there.
const FIGURES: [(Place, &str, Figure); 4] = [
    (Place::Motion, "motion", Figure::Cycle),
    (Place::TorqueSpeed, "torque_speed", Figure::TorqueSpeed),
    (Place::OutputBearing, "output_bearing", Figure::BearingLoad),
    (Place::Gear, "gear", Figure::Torsion),
];

/// `antrieb report PROJECT --out FILE`
pub(crate) fn report(matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    let out = matches.get_one::<PathBuf>("out").cloned().unwrap_or_default();
    write(matches, &out, as_json, language).unwrap_or_else(|answer| answer)
}

/// Writes the report of the axes and the actuator that are asked for.
pub(crate) fn write(matches: &ArgMatches, out: &Path, as_json: bool, language: Language) -> Result<Answer, Answer> {
    if out.as_os_str() == "-" {
        return Err(Unwritten::to_stdout(out).answer(as_json, language));
    }
    if !out.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("pdf")) {
        let what = terminal::report_is_a_pdf(&path_text(out), language);
        return Err(simple(&what, as_json, language));
    }
    let settings = settings(matches, as_json, language)?;
    let path = matches.get_one::<PathBuf>("project").cloned().unwrap_or_default();
    let source = Source::read(&path, matches, as_json, language)?;
    let projects = source.projects(as_json, language)?;
    let inputs = source.inputs(&projects);
    let force = matches.get_flag("force");
    ready(&[out], &inputs, force).map_err(|fault| fault.answer(as_json, language))?;
    let projects = picked(projects, matches, as_json, language)?;
    in_reach(Question::Report, projects.iter().map(|(_, project)| project), as_json, language)?;
    if projects.len() > 1 && matches!(matches.try_get_one::<String>("code"), Ok(Some(_))) {
        let names: Vec<&str> = projects.iter().map(|(_, project)| project.name.as_str()).collect();
        let names = names.join(", ");
        let what = terminal::code_is_for_one_axis(&names, language);
        return Err(simple(&what, as_json, language));
    }
    let flag = |name: &str| matches.try_get_one::<bool>(name).ok().flatten().copied().unwrap_or(false);
    let with_installation = flag("installation");
    let delivered = matches.try_get_one::<String>("delivered").ok().flatten();
    let delivered = delivered
        .map(|text| workbench::read_date(text, language))
        .transpose()
        .map_err(|fault| option_fault("delivered", fault, as_json, language))?;
    let (mut axes, mut told, mut talk, mut standings) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    for (place, project) in &projects {
        let sizing =
            workbench::sized(project, usize::MAX, patience()).map_err(|refusal| refuse(&refusal, as_json, language))?;
        let best = || sizing.candidates.first().map(|best| best.id.clone());
        let (candidate, said) = candidate(project, best, matches, as_json, language)?;
        let mut content = content((*place, project), &sizing, &candidate, &source.text, patience(), language)
            .map_err(|refusal| refuse(&refusal, as_json, language))?;
        if let (true, CandidateId::Code(code)) = (with_installation, &candidate.id) {
            content.chapters = installation(code, project, delivered, language)
                .map_err(|(what, hint)| option_fault("delivered", (what, hint), as_json, language))?;
            let cited = chapter::documents(&content.chapters, language);
            content.dossier.documents.extend(cited);
        }
        axes.push(content);
        told.push(AxisWritten {
            axis: project.name.clone(),
            code: candidate.id.to_string(),
            verdict: answer::fit(&candidate),
        });
        standings.push(standing_text(&candidate, language));
        talk.push(said);
    }
    let content = Content { language, axes };
    let bytes =
        report::pdf(&content, &settings).map_err(|fault| simple(&fault.message(language), as_json, language))?;
    save(&[(out, &bytes)], &inputs, force).map_err(|fault| fault.answer(as_json, language))?;
    let file = path_text(out);
    let fits = told.iter().all(|each| each.verdict == Fit::Fits);
    let data = match (as_json, told.as_slice()) {
        (false, [one]) => format!(
            "{file}: {}: {}; {} kB\n",
            one.code,
            standings.first().map_or("", String::as_str),
            bytes.len() / 1000
        ),
        (false, several) => {
            let lines = several.iter().zip(&standings);
            let lines: String = lines.map(|(each, text)| format!("  {}: {}: {text}\n", each.axis, each.code)).collect();
            format!("{file}: {} kB\n{lines}", bytes.len() / 1000)
        }
        (true, _) => {
            let code = if let [one] = told.as_slice() { Some(one.code.clone()) } else { None };
            written(&ReportWritten {
                file,
                axes: if code.is_some() { Vec::new() } else { told },
                code,
                verdict: Fit::of(fits),
                bytes: bytes.len(),
            })
        }
    };
    Ok(Answer { talk: talk.concat(), ..Answer::data(data) }.fits(fits))
}

/// Reports and forms over HTTP.
pub(crate) const PRESS: Option<Press> = Some(Press {
    report: served,
    checklist: |sheet, language| report::checklist_pdf(sheet, language).map_err(|fault| fault.message(language)),
});

fn served(asked: &ReportAsked<'_>) -> Result<Vec<u8>, String> {
    let l = asked.language;
    let said = |refusal: Refusal| answer::refusal_text(&refusal, None, l);
    let mut axes = Vec::new();
    for (place, project) in asked.axes {
        let sizing = workbench::sized(project, usize::MAX, asked.patience).map_err(said)?;
        let best = || sizing.candidates.first().map(|best| best.id.clone());
        let candidate = workbench::candidate_for(project, asked.code.as_ref(), best).map_err(said)?;
        let mut content =
            content((*place, project), &sizing, &candidate, asked.text, asked.patience, l).map_err(said)?;
        if let (true, CandidateId::Code(code)) = (asked.installation, &candidate.id) {
            content.chapters = installation(code, project, None, l).map_err(|(what, _)| what)?;
        }
        axes.push(content);
    }
    let settings = Settings { date: asked.date.map(str::to_owned), full: asked.full, ..Settings::default() };
    report::pdf(&Content { language: l, axes }, &settings).map_err(|fault| fault.message(l))
}

/// The check-lists of a commissioning as PDF.
pub(crate) fn checklist(sheet: &Commissioning, as_json: bool, language: Language) -> Result<Vec<u8>, Answer> {
    report::checklist_pdf(sheet, language).map_err(|fault| simple(&fault.message(language), as_json, language))
}

fn settings(matches: &ArgMatches, as_json: bool, language: Language) -> Result<Settings, Answer> {
    let text = |name: &str| text_option(matches, name, as_json, language).map(Option::unwrap_or_default);
    let flag = |name: &str| matches.try_get_one::<bool>(name).ok().flatten().copied().unwrap_or(false);
    Ok(Settings {
        date: Some(text("date")?).filter(|date| !date.is_empty()),
        revision: text("revision")?,
        project: text("title")?,
        number: text("number")?,
        author: text("author")?,
        company: text("company")?,
        pdf_a: flag("archive"),
        full: flag("full"),
    })
}

/// Results as a record and as figures, side by side. A thread that could not finish leaves its part to this one.
fn content(
    (place, project): (usize, &Project),
    sizing: &Sizing<'_>,
    candidate: &Candidate<'_>,
    text: &str,
    patience: &Patience,
    language: Language,
) -> Result<AxisContent, Refusal> {
    let figures = || drawn_figures(project, sizing, candidate, language);
    std::thread::scope(|scope| {
        let drawn = scope.spawn(|| {
            report::prepare();
            figures()
        });
        let (reserve, assessment) = workbench::margins(project, candidate, Draw::default(), patience)?;
        let dossier = answer::dossier(
            project,
            sizing,
            candidate,
            (&reserve, assessment.as_ref()),
            (text, place, concat!("antrieb ", env!("CARGO_PKG_VERSION"))),
            language,
        );
        Ok(AxisContent { dossier, figures: drawn.join().unwrap_or_else(|_| figures()), chapters: Vec::new() })
    })
}

/// What follows from the code for those who build and run the machine, the joints under the loads of the project.
fn installation(
    code: &OrderCode,
    project: &Project,
    delivered: Option<workbench::Date>,
    language: Language,
) -> Result<Vec<Chapter>, (String, Option<String>)> {
    let mut chapters = Vec::new();
    if let Some(found) = workbench::wiring(code) {
        let faces = found.connectors.iter().filter(|connector| !connector.pins.is_empty());
        let drawings = faces.map(|connector| {
            let drawing = figures::mating_face_beside_pins(code, connector, language);
            let (svg, alternative_text) = as_svg(connector.role.id(), &drawing, language);
            Picture { svg, caption: drawing.title.clone(), alternative_text }
        });
        chapters.push(chapter::wiring(&answer::wiring(&found, None, language), drawings.collect(), language));
    }
    let asked = MountAsked { axis: workbench::joint_loads(project, code).unwrap_or_default(), ..MountAsked::default() };
    if let Some(found) = workbench::mount(code, &asked) {
        chapters.push(chapter::mount(&answer::mount(&found, &asked, Some(&project.name), language), language));
    }
    if let Some(about) = workbench::commission(code) {
        let sheet = answer::commissioning(&about, DriveForm::Plain, usual_ambient(), language);
        chapters.push(chapter::commission(&sheet, &[], language));
    }
    if let Some(delivered) = delivered {
        let asked = UpkeepAsked { delivered, storage: None, hours_per_day: None, inspect: None, today: None };
        let plan = workbench::upkeep(code, &asked, language).map_err(|(_, what, hint)| (what, hint))?;
        chapters.push(chapter::upkeep(&answer::upkeep(&plan, language), language));
    }
    Ok(chapters)
}

fn drawn_figures(
    project: &Project,
    sizing: &Sizing<'_>,
    candidate: &Candidate<'_>,
    language: Language,
) -> Vec<report::Figure> {
    let figures = FIGURES.iter().filter_map(|(place, id, figure)| {
        let drawing = figures::draw(*figure, project, candidate, By::Mass, patience(), language).ok()?;
        Some(drawn((*place, id), &drawing, language))
    });
    let map = figures::candidate_map(sizing, By::Mass, Some(&candidate.id), language);
    figures.chain([drawn((Place::Alternatives, "alternatives"), &map, language)]).collect()
}

fn drawn((place, id): (Place, &str), drawing: &Drawing, language: Language) -> report::Figure {
    let (svg, alternative_text) = as_svg(id, drawing, language);
    report::Figure { place, svg, caption: drawing.caption.clone(), alternative_text }
}

/// A drawing on paper, and what it shows.
fn as_svg(id: &str, drawing: &Drawing, language: Language) -> (String, String) {
    let style = Style::new(drawing.size()).theme(Theme::Light).language(language).id(id);
    (drawing.render(&style).into_svg(), drawing.description.clone())
}
