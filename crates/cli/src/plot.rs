//! `plot`, and `curve` with a file: pictures.

use crate::answer::CommandAnswer;
use crate::call::Call;
use crate::fault::path_text;
use crate::waiting::{progress, waited_s};
use answers::{Number, PlotWritten, Units};
use figures::{By, Drawing, Figure, Picture, Size, Style, Theme};
use quantities::format_number;
use quantities::unit::MILLIMETRE;
use questions::list::{Inquiry, Unanswered, plot};
use std::path::Path;
use words::terminal;

/// Pixels of a PNG to the CSS pixel: 192 dpi.
const PNG_SCALE: f64 = 2.0;

/// Millimetres to the CSS pixel, 96 to the inch.
const MM_PER_PX: f64 = 25.4 / 96.0;

/// `antrieb plot PROJECT --figure FIGURE`
pub(crate) fn plot(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    destination(call, None)?;
    let args = plot::Args::read(&inquiry.given)?;
    let project = args.drawn(inquiry)?;
    let figure = args.figure.as_deref().and_then(Figure::of_id).unwrap_or(Figure::TorqueSpeed);
    let by = if args.by == Some(true) { By::Length } else { By::Mass };
    let candidate = args.candidate(&project, inquiry)?;
    let drawing = figures::draw(figure, &project, &candidate, by, progress(), language)
        .map_err(|fault| Unanswered::message(fault.message(waited_s(), language)))?;
    Ok(draw(&drawing, call)?.fits(candidate.fits()))
}

/// Returns `true` if a picture is requested.
pub(crate) fn is_asked(call: &Call<'_>) -> bool {
    call.path("svg").is_some() || call.path("png").is_some()
}

/// Checks that the picture can be written to its files before it is computed, and that none of them is `other`, a
/// further file that the call writes.
pub(crate) fn destination(call: &Call<'_>, other: Option<&Path>) -> Result<(), Unanswered> {
    if call.path("png").is_some_and(|path| path.as_os_str() == "-") {
        return Err(Unanswered::message(terminal::png_needs_a_file(call.language)));
    }
    let files: Vec<&Path> = other.into_iter().chain(call.file("svg")).chain(call.path("png")).collect();
    call.saver().ready(&files)
}

/// Draws the picture and writes it to the files that [`destination`] has checked, or to standard output.
pub(crate) fn draw(drawing: &Drawing, call: &Call<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    let picture = drawing.render(&style(drawing, call)?);
    let png = call.path("png");
    let mut pixels = Vec::new();
    if png.is_some() {
        let too_large =
            || Unanswered::message(terminal::picture_too_large(&(Picture::PIXELS_MAX / 1_000_000), language));
        pixels = picture.png(PNG_SCALE).ok_or_else(too_large)?;
    }
    let svg = call.file("svg").map(|path| (path, picture.svg().as_bytes()));
    let files: Vec<(&Path, &[u8])> = svg.into_iter().chain(png.map(|path| (path, pixels.as_slice()))).collect();
    call.saver().save(&files)?;
    let paths: Vec<String> = files.iter().map(|(path, _)| path_text(path)).collect();
    if call.as_json {
        return Ok(CommandAnswer::record(&described(drawing, &picture, &paths)));
    }
    let to_stdout = call.path("svg").is_some_and(|path| path.as_os_str() == "-") || paths.is_empty();
    if to_stdout {
        return Ok(CommandAnswer::data(picture.into_svg()));
    }
    let (width, height) = millimetres(&picture);
    let mm = |value: f64| format_number(value, 0, language);
    let head = format!("{} ({} × {} mm)", paths.join(", "), mm(width), mm(height));
    Ok(CommandAnswer::data(format!("{head}\n{}\n{}\n", drawing.title, drawing.description)))
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

fn style(drawing: &Drawing, call: &Call<'_>) -> Result<Style, Unanswered> {
    let language = call.language;
    let side = |name: &'static str, usual: f64| {
        let Some(text) = call.text(name) else { return Ok(usual) };
        let length = questions::read_quantity(text, language).map_err(|fault| Unanswered::option(name, fault))?;
        figures::side_mm(length, language).map_err(|what| Unanswered::option(name, (what, None)))
    };
    let (width, height) = drawing.size_mm;
    let size = Size::millimetres(side("width", width)?, side("height", height)?);
    let theme = if call.text("theme") == Some("dark") { Theme::Dark } else { Theme::Light };
    Ok(drawing.style(size, theme, language))
}
