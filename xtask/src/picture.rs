//! The picture at the head of the README: an answer, a figure and a page of the report, as the program gives them.
//!
//! The lines are those of the first answer in the README, which the step `readme` compares with the program; the figure is drawn anew; the
//! page of the report is the picture of the guide.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use base64::Engine as _;

use crate::markdown::Document;
use crate::{Error, samples};

const FILE: &str = "docs/pictures/overview.svg";
const README: &str = "README.md";
const PAGE: &str = "docs/guide/pictures/indexing-table-report.png";
const FIGURE: [&str; 6] = ["plot", "examples/indexing-table.toml", "--figure", "torque_speed", "--lang", "en"];
const DESCRIPTION: &str = "antrieb size: the ranking of the catalogue for an indexing table in the terminal; beside it the torque-speed plane of the best actuator and the first page of its report.";

/// Sizes in points of the picture.
const WIDTH: usize = 1240;
const EDGE: usize = 16;
const TERMINAL: usize = 780;
const LINE: usize = 16;
/// Of a letter of 12 points.
const LETTER: f64 = 7.2;
/// Width and height of the figure, and of a page.
const PLANE: (usize, usize) = (412, 312);
const SHEET: (usize, usize) = (236, 334);

/// Composes the picture and writes it.
///
/// # Errors
/// When the program cannot be built or draws nothing, or a file cannot be read or written.
pub fn run(root: &Path) -> Result<(), Error> {
    let path = root.join(FILE);
    let text = composed(root)?;
    let file = |source| Error::File { path: path.clone(), source };
    fs::create_dir_all(path.parent().unwrap_or(root)).map_err(file)?;
    fs::write(&path, text).map_err(file)
}

/// The picture is that of the program as it is.
pub(crate) fn check(root: &Path) -> Result<(), Error> {
    let (stored, now) = (read(root, FILE)?, composed(root)?);
    if stored == now {
        return Ok(());
    }
    let same = stored.lines().zip(now.lines()).take_while(|(stored, now)| stored == now).count();
    Err(Error::Stale { file: FILE, line: same + 1, command: "cargo xtask picture" })
}

fn composed(root: &Path) -> Result<String, Error> {
    let program = samples::built(root)?;
    let mut command = Command::new(program);
    command.args(FIGURE).current_dir(root).env_remove("ANTRIEB_LANG").stdin(Stdio::null()).stderr(Stdio::null());
    let output = command.output().map_err(|source| Error::NotStarted { command: FIGURE.join(" "), source })?;
    let figure = String::from_utf8_lossy(&output.stdout).into_owned();
    if !output.status.success() || !figure.starts_with("<svg ") {
        return Err(Error::Failed { command: FIGURE.join(" "), status: output.status.to_string() });
    }
    let page = root.join(PAGE);
    let page = fs::read(&page).map_err(|source| Error::File { path: page, source })?;
    let readme = Document::read(&read(root, README)?);
    let answer = readme.code.into_iter().find(|code| code.info == "console").ok_or(Error::NoReadmeCommand)?;
    Ok(picture(&answer.text, &figure, &base64::engine::general_purpose::STANDARD.encode(page)))
}

fn picture(answer: &str, figure: &str, page: &str) -> String {
    let lines: Vec<&str> = answer.lines().collect();
    let height = (lines.len() * LINE + 4 * EDGE).max(PLANE.1 + SHEET.1 + 3 * EDGE);
    let mut picture = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{height}\" viewBox=\"0 0 {WIDTH} {height}\" role=\"img\" aria-labelledby=\"overview\">\n\
         <desc id=\"overview\">{DESCRIPTION}</desc>\n\
         <rect width=\"{WIDTH}\" height=\"{height}\" rx=\"12\" fill=\"#e8ebef\"/>\n\
         <rect x=\"{EDGE}\" y=\"{EDGE}\" width=\"{TERMINAL}\" height=\"{}\" rx=\"8\" fill=\"#16202b\"/>\n\
         <g font-family=\"ui-monospace, 'DejaVu Sans Mono', Menlo, Consolas, monospace\" font-size=\"12\" fill=\"#d7dee6\">\n",
        height - 2 * EDGE,
    );
    for (number, line) in (0..).zip(&lines).filter(|(_, line)| !line.trim().is_empty()) {
        let text = line.trim_start();
        let before = line.chars().count() - text.chars().count();
        let (x, y) = (2 * EDGE, 2 * EDGE + 12 + number * LINE);
        let at = LETTER * letters(before);
        // Another font is set as wide, so that the columns stand.
        let width = LETTER * letters(text.chars().count());
        let colour = if number == 0 { " fill=\"#8fd19e\"" } else { "" };
        picture.push_str(&format!(
            "<text x=\"{:.1}\" y=\"{y}\" textLength=\"{width:.1}\" lengthAdjust=\"spacingAndGlyphs\" xml:space=\"preserve\"{colour}>{}</text>\n",
            at + letters(x),
            escaped(text),
        ));
    }
    picture.push_str("</g>\n");
    let left = TERMINAL + 2 * EDGE;
    let top = EDGE + PLANE.1 + EDGE;
    picture.push_str(&format!(
        "<rect x=\"{left}\" y=\"{EDGE}\" width=\"{}\" height=\"{}\" rx=\"8\" fill=\"#ffffff\"/>\n{}\n",
        WIDTH - left - EDGE,
        PLANE.1,
        placed(figure, left, EDGE),
    ));
    let middle = left + (WIDTH - left - EDGE - SHEET.0) / 2;
    picture.push_str(&format!(
        "<rect x=\"{middle}\" y=\"{top}\" width=\"{}\" height=\"{}\" fill=\"#ffffff\"/>\n\
         <image x=\"{middle}\" y=\"{top}\" width=\"{}\" height=\"{}\" href=\"data:image/png;base64,{page}\"/>\n</svg>\n",
        SHEET.0, SHEET.1, SHEET.0, SHEET.1,
    ));
    picture
}

/// The figure with its place and size instead of its own size.
fn placed(figure: &str, x: usize, y: usize) -> String {
    let (head, rest) = figure.split_once('>').unwrap_or((figure, ""));
    let own = |word: &&str| !word.starts_with("width=") && !word.starts_with("height=");
    let head: Vec<&str> = head.split(' ').filter(own).collect();
    format!("{} x=\"{x}\" y=\"{y}\" width=\"{}\" height=\"{}\">{}", head.join(" "), PLANE.0, PLANE.1, rest.trim_end())
}

fn letters(count: usize) -> f64 {
    u32::try_from(count).map_or(0.0, f64::from)
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

fn read(root: &Path, file: &str) -> Result<String, Error> {
    let path = root.join(file);
    fs::read_to_string(&path).map_err(|source| Error::File { path, source })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_picture_holds_the_answer_the_figure_and_the_page() {
        let figure = "<svg xmlns=\"x\" width=\"165mm\" height=\"125mm\" viewBox=\"0 0 6 4\"><path/></svg>\n";
        let picture = picture("$ antrieb size a.toml\n\n  a > b\n", figure, "c2hlZXQ=");
        assert!(picture.contains(">$ antrieb size a.toml</text>") && picture.contains(">a &gt; b</text>"), "{picture}");
        assert!(picture.contains("viewBox=\"0 0 6 4\" x=\"812\"") && !picture.contains("165mm"), "{picture}");
        assert!(picture.contains("base64,c2hlZXQ=\"") && picture.ends_with("</svg>\n"));
    }
}
