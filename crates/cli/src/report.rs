//! `report`: the results as PDF for the signature of an engineer.

use crate::answer::{CommandAnswer, written};
use crate::call::Call;
use crate::fault::path_text;
use crate::waiting::progress;
use answers::{AxisWritten, Block, Chapter, Commissioning, Fit, Picture, ReportWritten};
use axis::AxisProject;
use figures::{By, Drawing, Figure, Style, Theme};
use order_code::OrderCode;
use page::{Press, ReportInputs};
use quantities::Language;
use questions::list::commission::{DriveForm, usual_ambient};
use questions::list::mount::MountInputs;
use questions::list::{Inquiry, Unanswered, report as args};
use questions::texts::standing_text;
use questions::{Candidate, Draw, ProductId, Progress, Proposals, Refusal, Rejected, Sizing, answer, chapter};
use report::{AxisContent, Change, Content, DiagramPlace, Settings};
use std::borrow::Cow;
use std::path::Path;
use words::{terminal, without_keys};

/// Figures of the report in addition to the map of candidates, each with its place.
const FIGURES: [(DiagramPlace, &str, Figure); 4] = [
    (DiagramPlace::Motion, "motion", Figure::Cycle),
    (DiagramPlace::TorqueSpeed, "torque_speed", Figure::TorqueSpeed),
    (DiagramPlace::OutputBearing, "output_bearing", Figure::BearingLoad),
    (DiagramPlace::Gear, "gear", Figure::Torsion),
];

/// `antrieb report PROJECT [--out FILE]`
pub(crate) fn report(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let beside = || call.file_beside("pdf").ok_or_else(|| call.missing("--out"));
    let out = call.path("out").map_or_else(beside, |out| Ok(out.to_owned()))?;
    write(call, inquiry, &out, call.as_json)
}

/// Writes the report of the requested axes and actuator.
pub(crate) fn write(
    call: &Call<'_>,
    inquiry: &Inquiry<'_>,
    out: &Path,
    as_json: bool,
) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    if !out.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("pdf")) {
        return Err(Unanswered::message(terminal::report_is_a_pdf(&path_text(out), language)));
    }
    let args = args::Args::read(&call.given(args::Args::ARGUMENTS)?)?;
    // Without the words that the terminal has before each change.
    let made = |line: &'_ str| line.split_once(": ").map_or(line, |(_, made)| made).to_owned();
    let altered = call.changes().map(|line| without_keys(&made(line), language).into_owned()).collect();
    let settings = Settings { altered, ..settings(&args) };
    let source = inquiry.source()?;
    let saver = call.saver();
    saver.ready(&[out])?;
    let projects = args.axes(inquiry)?;
    let with_installation = args.installation;
    let delivered = call.text("delivered").map(|text| questions::list::upkeep::read_date(text, language)).transpose();
    let delivered = delivered.map_err(|fault| Unanswered::option("delivered", fault))?;
    let text = source.text(language)?;
    let (mut axes, mut of_axes, mut standings) = (Vec::new(), Vec::new(), Vec::new());
    for (place, project) in &projects {
        let (mut content, candidate) = content((*place, project), args.code.as_ref(), text, progress(), language)?;
        if with_installation {
            install(&mut content, (project, &candidate), delivered, language)
                .map_err(|fault| Unanswered::option("delivered", fault))?;
        }
        content.chapters.extend(simulated(project, &candidate, progress(), language));
        axes.push(content);
        of_axes.push(AxisWritten {
            axis: project.name.clone(),
            code: candidate.id.to_string(),
            verdict: answer::fit(&candidate),
        });
        standings.push(standing_text(&candidate, language));
    }
    let content = Content { language, axes };
    let bytes = report::pdf(&content, &settings).map_err(|fault| Unanswered::message(fault.message(language)))?;
    saver.save(&[(out, &bytes)])?;
    let file = path_text(out);
    let verdict = Fit::of_all(of_axes.iter().map(|each| each.verdict));
    let data = match (as_json, of_axes.as_slice()) {
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
            let code = if let [one] = of_axes.as_slice() { Some(one.code.clone()) } else { None };
            written(&ReportWritten {
                file,
                axes: if code.is_some() { Vec::new() } else { of_axes },
                code,
                verdict,
                bytes: bytes.len(),
            })
        }
    };
    Ok(CommandAnswer::data(data).fits(verdict.fits()))
}

/// Writers of reports and forms over HTTP.
pub const PRESS: Option<Press> = Some(Press {
    report: served,
    checklist: |sheet, language| report::checklist_pdf(sheet, language).map_err(|fault| fault.message(language)),
});

fn served(inquiry: &ReportInputs<'_>) -> Result<Vec<u8>, String> {
    let l = inquiry.language;
    let said = |refusal: Refusal| answer::refusal_text(&refusal, None, l);
    let mut axes = Vec::new();
    for (place, project) in inquiry.axes {
        let judged = content((*place, project), inquiry.args.code.as_ref(), inquiry.text, inquiry.progress, l);
        let (mut content, candidate) = judged.map_err(said)?;
        if inquiry.args.installation {
            install(&mut content, (project, &candidate), None, l).map_err(|(what, _)| what)?;
        }
        content.chapters.extend(simulated(project, &candidate, inquiry.progress, l));
        axes.push(content);
    }
    report::pdf(&Content { language: l, axes }, &settings(inquiry.args)).map_err(|fault| fault.message(l))
}

/// Returns the checklists of a commissioning as PDF.
pub(crate) fn checklist(sheet: &Commissioning, language: Language) -> Result<Vec<u8>, Unanswered> {
    report::checklist_pdf(sheet, language).map_err(|fault| Unanswered::message(fault.message(language)))
}

/// Returns the title page and the extent of a report.
fn settings(args: &args::Args) -> Settings {
    let text = |value: &Option<String>| value.clone().unwrap_or_default();
    let change = |change: &args::Change| Change {
        revision: change.revision.clone(),
        date: change.date.clone(),
        author: change.author.clone(),
        text: change.text.clone(),
    };
    Settings {
        date: args.date,
        revision: text(&args.revision),
        project: text(&args.title),
        number: text(&args.number),
        author: text(&args.author),
        company: text(&args.company),
        customer: text(&args.customer),
        order: text(&args.order),
        changes: args.changes.iter().map(change).collect(),
        pdf_a: args.archive,
        full: args.full,
        altered: Vec::new(),
    }
}

/// Returns the actuator of an axis, with its results as a record and as figures, computed in parallel. A thread that
/// could not finish leaves its part to this one.
fn content<'p>(
    (place, project): (usize, &'p AxisProject),
    id: Option<&ProductId>,
    text: &str,
    progress: &Progress,
    language: Language,
) -> Result<(AxisContent, Candidate<'p>), Refusal> {
    let sizing = questions::list::size::sized(project, usize::MAX, Rejected::All, progress)?;
    let candidate = questions::candidate_for(project, id, || Ok(Cow::Borrowed(&sizing)))?;
    let figures = || drawn_figures(project, &sizing, &candidate, language);
    let content = std::thread::scope(|scope| {
        let drawn = scope.spawn(|| {
            report::prepare();
            figures()
        });
        let (reserve, assessment) = questions::list::check::margins(project, &candidate, Draw::default(), progress)?;
        let proposals = if sizing.fits() { Proposals::default() } else { Proposals::of(project, progress)? };
        let dossier = answer::dossier(
            project,
            &sizing,
            &candidate,
            (&reserve, assessment.as_ref(), &proposals),
            (text, place, concat!("antrieb ", env!("CARGO_PKG_VERSION"))),
            language,
        );
        let figures = drawn.join().unwrap_or_else(|_| figures());
        let actuator_kind = answer::actuator_kind(&candidate, language).to_owned();
        Ok::<_, Refusal>(AxisContent { dossier, actuator_kind, figures, chapters: Vec::new() })
    })?;
    Ok((content, candidate))
}

/// Adds the chapters of the installation, and the documents that they cite, to the report of an actuator of the
/// catalogue; for another one a chapter that says that they are not known.
fn install(
    content: &mut AxisContent,
    (project, candidate): (&AxisProject, &Candidate<'_>),
    delivered: Option<questions::list::upkeep::Date>,
    language: Language,
) -> Result<(), (String, Option<String>)> {
    let Some(code) = candidate.id.order_code() else {
        let mut chapter = Chapter::new(words::terminal::installation(language).to_owned());
        chapter.text(words::terminal::installation_not_known(&candidate.id.to_string(), language));
        content.chapters = vec![chapter];
        return Ok(());
    };
    content.chapters = installation(code, project, delivered, language)?;
    content.dossier.documents.extend(chapter::documents(&content.chapters, language));
    Ok(())
}

/// Returns the chapters on mounting, wiring and commissioning of the code, with the joints under the loads of the
/// project.
fn installation(
    code: &OrderCode,
    project: &AxisProject,
    delivered: Option<questions::list::upkeep::Date>,
    language: Language,
) -> Result<Vec<Chapter>, (String, Option<String>)> {
    let mut chapters = Vec::new();
    if let Some(found) = questions::list::wiring::wiring(code) {
        let faces = found.connectors.iter().filter(|connector| !connector.pins.is_empty());
        let drawings = faces.map(|connector| {
            let drawing = figures::mating_face(code, connector, figures::PinTexts::Signals, language);
            let (svg, alternative_text) = as_svg(connector.role.id(), &drawing, language);
            Picture { svg, caption: drawing.title.clone(), alternative_text }
        });
        chapters.push(chapter::wiring(&answer::wiring(&found, None, language), drawings.collect(), language));
    }
    let inquiry = MountInputs {
        axis: questions::list::mount::joint_loads(project, code).unwrap_or_default(),
        ..MountInputs::default()
    };
    if let Some(found) = questions::list::mount::mount(code, &inquiry) {
        chapters.push(chapter::mount(&answer::mount(&found, &inquiry, Some(&project.name), language), language));
    }
    if let Some(about) = questions::list::commission::commission(code) {
        let sheet = answer::commissioning(&about, DriveForm::Plain, usual_ambient(), language);
        chapters.push(chapter::commission(&sheet, &[], language));
    }
    if let Some(delivered) = delivered {
        let inquiry = questions::list::upkeep::of_the_project(project, code, delivered);
        let plan = questions::list::upkeep::upkeep(code, &inquiry, language).map_err(|(_, what, hint)| (what, hint))?;
        chapters.push(chapter::upkeep(&answer::upkeep(&plan, language), language));
    }
    chapter::state_each_once(&mut chapters);
    Ok(chapters)
}

/// Returns the simulation that a project states, with its pictures; the reason if it is not run.
fn simulated(
    project: &AxisProject,
    candidate: &Candidate<'_>,
    progress: &Progress,
    language: Language,
) -> Option<Chapter> {
    let run = questions::list::simulate::of_the_project(project, Some(&candidate.id), progress, language)?;
    let run = match run {
        Ok(run) => run,
        Err(why) => {
            let mut chapter = Chapter::new(words::capitalised(words::simulation::simulation(language)));
            chapter.text(why);
            return Some(chapter);
        }
    };
    let mut chapter = chapter::simulation(&answer::simulation(&run, language), language);
    let pictures = [
        ("simulation", figures::simulation(&run, None, &[], language)),
        ("control-loops", figures::control_loops(&run, language)),
    ];
    for (id, drawing) in pictures {
        let (svg, alternative_text) = as_svg(id, &drawing, language);
        chapter.blocks.push(Block::Picture(Picture { svg, caption: drawing.caption.clone(), alternative_text }));
    }
    Some(chapter)
}

fn drawn_figures(
    project: &AxisProject,
    sizing: &Sizing<'_>,
    candidate: &Candidate<'_>,
    language: Language,
) -> Vec<report::Diagram> {
    let figures = FIGURES.iter().filter_map(|(place, id, figure)| {
        let drawing = figures::draw(*figure, project, candidate, By::Mass, progress(), language).ok()?;
        Some(drawn((*place, id), &drawing, language))
    });
    // A map without a point would be a sentence in a frame.
    let map = figures::has_points(sizing, By::Mass)
        .then(|| figures::candidate_map(sizing, By::Mass, Some(&candidate.id), language));
    figures.chain(map.map(|map| drawn((DiagramPlace::Alternatives, "alternatives"), &map, language))).collect()
}

fn drawn((place, id): (DiagramPlace, &str), drawing: &Drawing, language: Language) -> report::Diagram {
    let svgs = place.sizes_mm(drawing.size_mm.1).into_iter().map(|(width, height)| {
        let style = Style::new(figures::Size::millimetres(width, height));
        drawing.render(&style.theme(Theme::Light).language(language).id(id)).into_svg()
    });
    report::Diagram {
        place,
        svgs: svgs.collect(),
        caption: drawing.caption.clone(),
        alternative_text: drawing.description.clone(),
    }
}

/// Returns a drawing on paper, and its description.
fn as_svg(id: &str, drawing: &Drawing, language: Language) -> (String, String) {
    let style = Style::new(drawing.size()).theme(Theme::Light).language(language).id(id);
    (drawing.render(&style).into_svg(), drawing.description.clone())
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test fails loudly")]
mod tests {
    use super::*;

    /// Applies to the command line and to HTTP.
    #[test]
    fn a_report_with_the_installation_lists_the_documents_of_its_chapters() {
        let text = include_str!("../../../examples/turntable.toml");
        let project = questions::read(text).unwrap();
        let (mut whole, candidate) =
            content((0, &project), None, text, &Progress::endless(), Language::default()).unwrap();
        let before = whole.dossier.documents.len();
        install(&mut whole, (&project, &candidate), None, Language::default()).unwrap();
        let cited = chapter::documents(&whole.chapters, Language::default());
        assert!(!whole.chapters.is_empty() && !cited.is_empty());
        assert_eq!(whole.dossier.documents.len(), before + cited.len());
    }
}
