//! `curve`, `bearing`, `battery`, `new`: commands whose answer is one chapter.

use crate::answer::CommandAnswer;
use crate::call::{Call, named_file};
use crate::command::typed::typed;
use crate::fault::path_text;
use crate::plot;
use crate::preview::previewed;
use crate::reserve::assumptions_text;
use crate::source::SourceFile;
use crate::source::begun::as_single_move;
use crate::table::{Align, TextTable, labelled};
use crate::waiting::progress;
use answers::FilesWritten;
use axis::{Grant, Reach};
use disk::{Links, ProjectFiles};
use project::written;
use quantities::unit::{NEWTON_METRE, REVOLUTION_PER_MINUTE, VOLT};
use quantities::{Language, Measure, Torque, format_significant};
use questions::Candidate;
use questions::list::bearing::bearing_checks;
use questions::list::new::Template;
use questions::list::{Cost, Inquiry, Unanswered, battery, bearing, curve, new};
use questions::texts::{battery_lines, compared_texts, margin_text, unit_text, verdict_of, verdict_text};
use std::path::Path;
use words::{curve_title, grade_word, source_text, terminal, terms, title_of_check};

/// `antrieb curve CODE`
pub(crate) fn curve(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    if plot::is_asked(call) {
        plot::destination(call, None)?;
    }
    let (code, plane) = curve::found(inquiry)?;
    if plot::is_asked(call) {
        return plot::draw(&figures::curves(&code, &plane, language), call);
    }
    let mut out = format!("{code}\n");
    for curve in &plane.curves {
        let volts = curve.voltage.map_or_else(String::new, |voltage| {
            format!(", {} {}", format_significant(voltage.in_unit(&VOLT), 3, language), VOLT.symbol)
        });
        out.push_str(&format!(
            "\n{}{volts}: {}, {}\n",
            curve_title(&curve.kind, language),
            grade_word(curve.grade, language),
            source_text(&curve.source, language)
        ));
        let (speed, torque, upper) = ("n min⁻¹", "T Nm", terminal::up_to_nm(language));
        let mut table = TextTable::new([(speed, Align::Right), (torque, Align::Right), (upper, Align::Right)]);
        let shown = |value: f64| format_significant(value, 4, language);
        let newton_metres =
            |torque: Option<Torque>| torque.map_or_else(|| "–".into(), |torque| shown(torque.in_unit(&NEWTON_METRE)));
        for (speed, torque, upper) in questions::curve_rows(curve) {
            table.row([shown(speed.in_unit(&REVOLUTION_PER_MINUTE)), newton_metres(torque), newton_metres(upper)]);
        }
        out.push_str(&table.render());
    }
    Ok(CommandAnswer::data(out))
}

/// `antrieb bearing PROJECT`
pub(crate) fn bearing(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    let args = bearing::Args::read(&inquiry.given)?;
    let axes = inquiry.axes(args.axis.as_deref(), Cost::Other)?;
    let found = inquiry.each(&axes, |project| {
        let sizes = bearing::sizes(project, inquiry.progress, language)?;
        let assumed = assumptions_text(&project.assumptions, language);
        Ok((bearing_text(&sizes, language) + &assumed, bearing::fits(&sizes)))
    })?;
    Ok(CommandAnswer::of_axes(found))
}

fn bearing_text(sizes: &[Candidate<'_>], language: Language) -> String {
    let mut table = TextTable::new([
        (terminal::size(language), Align::Left),
        (terms::check(language), Align::Left),
        (terms::verdict(language), Align::Left),
        (terms::value(language), Align::Right),
        (terms::limit(language), Align::Right),
        (terms::unit(language), Align::Left),
        (terms::utilisation_short(language), Align::Right),
    ]);
    let checks =
        || sizes.iter().flat_map(|size| bearing_checks(size).map(move |check| (size.product.size_name(), check)));
    for (size, check) in checks() {
        let [value, limit] = compared_texts(check, language);
        table.row([
            size.to_owned(),
            title_of_check(check, language),
            verdict_text(check, language),
            value,
            limit,
            unit_text(check.value, language).to_owned(),
            margin_text(check, language),
        ]);
    }
    let mut keys: Vec<&str> = Vec::new();
    for (_, check) in checks() {
        keys.extend(check.missing.filter(|key| key.contains('.') && !keys.contains(key)));
    }
    let open = if keys.is_empty() { String::new() } else { labelled(terminal::to_state(language), &keys.join(", ")) };
    table.render() + &open
}

/// `antrieb battery`
pub(crate) fn battery(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    Ok(CommandAnswer::lines(&battery_lines(&battery::found(inquiry)?, call.language)))
}

/// Returns `true` if there is something at a path other than the recording of a template, in any language.
fn is_of_the_user(path: &Path, kind: &str) -> bool {
    let Ok(about) = std::fs::symlink_metadata(path) else { return false };
    let written = |language| new::template(kind, new::USUAL_NAME, language)?.recording.map(|(_, text)| text);
    let is_as_long = |text: &String| about.is_file() && about.len() == text.len() as u64;
    let mut alike = Language::ALL.into_iter().filter_map(written).filter(is_as_long);
    !alike.any(|text| disk::read_file(path, text.len()).is_ok_and(|found| found == text.as_bytes()))
}

/// Returns the project that begins with a recording.
fn recorded(call: &Call<'_>, (from, out): (&Path, Option<&Path>), file: &str) -> Result<Template, Unanswered> {
    let language = call.language;
    let kind = call.given(new::Args::ARGUMENTS)?.all("kind").next().unwrap_or_default().to_owned();
    let not_of_kind = || Unanswered::option("from", (words::recorded_template::not_of_kind(&kind, language), None));
    if !new::begins_with_motion(&kind) {
        return Err(not_of_kind());
    }
    let name = path_text(from);
    let preview = previewed(from, language)?;
    // The project names the recording relative to its own folder.
    let folder = out.and_then(Path::parent).unwrap_or(Path::new(""));
    let inside = from.strip_prefix(folder).ok().map(path_text);
    let named = inside.unwrap_or_else(|| named_file(&name));
    new::recorded(&kind, &preview, (&named, file), language).ok_or_else(not_of_kind)
}

/// Reads a new project as the other commands do, and states what it lacks: a recorded motion that does not return becomes a single
/// move; returns a remark on each.
///
/// # Errors
/// Every fault that another command would report, except the missing data of a recorded machine.
fn finished(call: &Call<'_>, template: &mut Template, out: Option<&Path>) -> Result<String, Unanswered> {
    let language = call.language;
    let is_project = written(&template.text).is_some_and(|keys| keys.iter().any(|key| key.path.starts_with("motion")));
    if !is_project {
        return Ok(String::new());
    }
    let folder = out.and_then(Path::parent).unwrap_or(Path::new("")).to_owned();
    let files =
        ProjectFiles { folder, links: Links::Followed, grant: Grant { reach: Reach::Anywhere, ..Grant::default() } };
    let is_recorded = call.path("from").is_some();
    let checked = |template: &Template| new::checked(template, is_recorded, &files, progress(), language);
    let mut talk = String::new();
    let mut readiness = checked(template)?;
    if readiness.is_open
        && let Some(text) = as_single_move(&template.text)
    {
        template.text = text;
        talk += &format!("{}\n", terminal::option_assumed(&format!("{} = true", new::SINGLE_MOVE), language));
        readiness = checked(template)?;
    }
    if !readiness.missing.is_empty() {
        talk += &format!("{}\n", terminal::still_missing(&readiness.missing.join("; "), language));
    }
    for fault in &readiness.recording {
        talk += &format!("{}\n", terminal::recording_to_mend(fault, language));
    }
    Ok(talk)
}

/// Returns the new project of a call with its values, and remarks.
///
/// # Errors
/// Faults of the call and of the values.
pub(crate) fn made(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<(Template, String), Unanswered> {
    let language = call.language;
    let out = call.file("out");
    let name = out.and_then(Path::file_name);
    let name = name.map_or_else(|| new::USUAL_NAME.to_owned(), |name| path_text(Path::new(name)));
    let mut template = match call.path("from") {
        Some(from) => recorded(call, (from, out), &name)?,
        None => new::found(inquiry, &name)?,
    };
    let mut talk = String::new();
    if let Some((text, made)) = call.changed(&template.text)? {
        template.text = text;
        // A statement that changes several keys says which.
        let several = made.iter().filter(|made| made.contains("; "));
        talk = several.map(|made| format!("{}\n", terminal::values_set(made, language))).collect();
    }
    talk += &finished(call, &mut template, out)?;
    Ok((template, talk))
}

/// Returns the result of a new project whose call states values; `None` without one.
fn first_result(call: &Call<'_>, text: &str, out: &Path) -> Option<String> {
    let language = call.language;
    if call.texts("set").is_empty() {
        return None;
    }
    let folder = out.parent().unwrap_or(Path::new(""));
    let file = SourceFile::of_text(path_text(out), text.as_bytes().to_vec(), folder, call.memory());
    let projects = file.source().projects(questions::embedded_catalogue(), progress(), language).ok()?;
    let [project] = &projects[..] else { return None };
    // A long recording is written at once; its sizing takes a call of its own.
    Cost::Other.is_quick([project]).ok()?;
    let sizing = questions::size(project);
    let call = typed(["antrieb", "size", &path_text(out)]);
    Some(match sizing.answer() {
        Some(best) => format!("{}: {} ({call})", best.id, verdict_of(best, language)),
        None => terminal::no_result_of_new(&call, language),
    })
}

/// `antrieb new KIND`
pub(crate) fn template(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    let (template, mut talk) = made(call, inquiry)?;
    let Some(out) = call.file("out") else {
        let mut answer = CommandAnswer::data(template.text);
        if let Some((recording, _)) = template.recording {
            let kind = call.text("kind").unwrap_or_default();
            talk += &format!("{}\n", terminal::recording_not_written(&recording, &kind, language));
        }
        answer.talk = talk;
        return Ok(answer);
    };
    let beside = template.recording.map(|(name, text)| (out.with_file_name(name), text));
    // `--force` is about the file that is named: a recording of the user with the name of the example's is not replaced.
    let kind = call.text("kind").unwrap_or_default();
    if let Some((path, _)) = beside.as_ref().filter(|(path, _)| is_of_the_user(path, kind)) {
        let message = words::file_trouble(&std::io::ErrorKind::AlreadyExists.into(), language);
        return Err(Unanswered::File { name: path_text(path), message, is_too_large: false });
    }
    let mut files: Vec<(&Path, &[u8])> = vec![(out, template.text.as_bytes())];
    files.extend(beside.iter().map(|(path, text)| (path.as_path(), text.as_bytes())));
    call.saver().save(&files)?;
    let paths: Vec<String> = files.iter().map(|(path, _)| path_text(path)).collect();
    if let Some(result) = first_result(call, &template.text, out) {
        talk += &format!("{result}\n");
    }
    if call.as_json {
        return Ok(CommandAnswer { talk, ..CommandAnswer::record(&FilesWritten { files: paths }) });
    }
    Ok(CommandAnswer { talk, ..CommandAnswer::lines(&paths) })
}
