//! `plot`, and `curve` with a file: pictures.

use crate::answer::Answer;
use crate::fault::{path_text, quantity, simple};
use crate::save::{ready, save};
use crate::subject::{axes_with_inputs, candidate, refuse};
use crate::waiting::{patience, waited_s};
use clap::ArgMatches;
use figures::{By, Drawing, Figure, Picture, Size, Style, Theme};
use std::path::{Path, PathBuf};
use workbench::answers::{Number, PlotWritten, Units};
use workbench::quantities::unit::MILLIMETRE;
use workbench::quantities::{Length, format_number};
use workbench::text::terminal;
use workbench::{Language, Question};

/// Pixels of a PNG to the CSS pixel: 192 dpi.
const PNG_SCALE: f64 = 2.0;

/// Millimetres to the CSS pixel, 96 to the inch.
const MM_PER_PX: f64 = 25.4 / 96.0;

/// `antrieb plot PROJECT --figure FIGURE`
pub(crate) fn plot(matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    let (projects, inputs) = match axes_with_inputs(Question::Other, matches, as_json, language) {
        Ok(found) => found,
        Err(answer) => return answer,
    };
    if let Err(answer) = destination(matches, &inputs, as_json, language) {
        return answer;
    }
    let [project] = projects.as_slice() else {
        let names: Vec<&str> = projects.iter().map(|project| project.name.as_str()).collect();
        let names = names.join(", ");
        return refused(&terminal::several_axes(&names, language), as_json, language);
    };
    let figure = matches.get_one::<String>("figure").and_then(|id| Figure::of_id(id)).unwrap_or(Figure::TorqueSpeed);
    let by = if matches.get_one::<String>("by").is_some_and(|by| by == "length") { By::Length } else { By::Mass };
    // Sought only where neither a code nor an actuator of the project's own is drawn.
    let is_sought = !matches.contains_id("code") && project.actuator.is_none();
    let sizing = match is_sought.then(|| workbench::sized(project, 0, patience())).transpose() {
        Ok(found) => found,
        Err(refusal) => return refuse(&refusal, as_json, language),
    };
    let best = || sizing.as_ref()?.candidates.first().map(|best| best.id.clone());
    let (candidate, talk) = match candidate(project, best, matches, as_json, language) {
        Ok(found) => found,
        Err(answer) => return answer,
    };
    let drawing = match figures::draw(figure, project, &candidate, by, patience(), language) {
        Ok(drawing) => drawing,
        Err(fault) => return refused(&fault.message(waited_s(), language), as_json, language),
    };
    let answer = put(&drawing, matches, &inputs, as_json, language);
    let code = if answer.code == 0 { u8::from(!candidate.fits()) } else { answer.code };
    Answer { talk: talk + &answer.talk, code, ..answer }
}

/// Whether a picture is asked for.
pub(crate) fn is_asked(matches: &ArgMatches) -> bool {
    matches.contains_id("svg") || matches.contains_id("png")
}

/// Whether the picture could be written where it is asked to, before the work for it begins; a fault is the finished
/// answer.
pub(crate) fn destination(
    matches: &ArgMatches,
    inputs: &[PathBuf],
    as_json: bool,
    language: Language,
) -> Result<(), Answer> {
    let asked = |name: &str| matches.get_one::<PathBuf>(name);
    if asked("png").is_some_and(|path| path.as_os_str() == "-") {
        return Err(refused(terminal::png_needs_a_file(language), as_json, language));
    }
    let svg = asked("svg").filter(|path| path.as_os_str() != "-");
    let files: Vec<&Path> = svg.into_iter().chain(asked("png")).map(PathBuf::as_path).collect();
    ready(&files, inputs, matches.get_flag("force")).map_err(|fault| fault.answer(as_json, language))
}

/// Draws and writes where [`destination`] has found room: to files, or to standard output.
pub(crate) fn put(
    drawing: &Drawing,
    matches: &ArgMatches,
    inputs: &[PathBuf],
    as_json: bool,
    language: Language,
) -> Answer {
    let style = match style(drawing, matches, as_json, language) {
        Ok(style) => style,
        Err(answer) => return answer,
    };
    let is_file = |path: &&PathBuf| path.as_os_str() != "-";
    let asked = |name: &str| matches.get_one::<PathBuf>(name);
    let picture = drawing.render(&style);
    let (svg, png) = (asked("svg").filter(is_file), asked("png"));
    let mut pixels = Vec::new();
    if png.is_some() {
        match picture.png(PNG_SCALE) {
            Some(found) => pixels = found,
            None => {
                let what = terminal::picture_too_large(language);
                return refused(what, as_json, language);
            }
        }
    }
    let files: Vec<(&Path, &[u8])> = svg
        .map(|path| (path.as_path(), picture.svg().as_bytes()))
        .into_iter()
        .chain(png.map(|path| (path.as_path(), pixels.as_slice())))
        .collect();
    if let Err(fault) = save(&files, inputs, matches.get_flag("force")) {
        return fault.answer(as_json, language);
    }
    let paths: Vec<String> = files.iter().map(|(path, _)| path_text(path)).collect();
    if as_json {
        return Answer::record(&described(drawing, &picture, &paths));
    }
    let to_stdout = asked("svg").is_some_and(|path| path.as_os_str() == "-") || paths.is_empty();
    if to_stdout {
        return Answer::data(picture.into_svg());
    }
    let (width, height) = millimetres(&picture);
    let mm = |value: f64| format_number(value, 0, language);
    let head = format!("{} ({} × {} mm)", paths.join(", "), mm(width), mm(height));
    Answer::data(format!("{head}\n{}\n{}\n", drawing.title, drawing.description))
}

fn millimetres(picture: &Picture) -> (f64, f64) {
    let (width, height) = picture.pixels();
    let round = |px: f64| (px * MM_PER_PX * 10.0).round() / 10.0;
    (round(width), round(height))
}

fn described(drawing: &Drawing, picture: &Picture, paths: &[String]) -> PlotWritten {
    let (width, height) = millimetres(picture);
    PlotWritten {
        figure: drawing.figure.id(),
        file: paths.first().cloned(),
        files: paths.to_vec(),
        width: Number(width),
        height: Number(height),
        units: Units::of(&[("width", &MILLIMETRE), ("height", &MILLIMETRE)]),
        title: drawing.title.clone(),
        caption: drawing.caption.clone(),
        description: drawing.description.clone(),
    }
}

fn style(drawing: &Drawing, matches: &ArgMatches, as_json: bool, language: Language) -> Result<Style, Answer> {
    let side = |name: &str, usual: f64| {
        let Some(asked) = quantity::<Length>(matches, name, as_json, language)? else { return Ok(usual) };
        figures::side_mm(asked, language)
            .map_err(|what| crate::fault::option_fault(name, (what, None), as_json, language))
    };
    let (width, height) = drawing.size_mm;
    let size = Size::millimetres(side("width", width)?, side("height", height)?);
    let theme = if matches.get_one::<String>("theme").is_some_and(|theme| theme == "dark") {
        Theme::Dark
    } else {
        Theme::Light
    };
    Ok(drawing.style(size, theme, language))
}

fn refused(what: &str, as_json: bool, language: Language) -> Answer {
    simple(what, as_json, language)
}
