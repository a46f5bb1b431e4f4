//! `sweep`: a table of axes, judged part by part. Finished parts are kept next to the output until that is complete, so
//! that an interrupted call continues.

mod factors;
mod parts;
mod run;
mod shown;
mod table;
mod vary;

use crate::answer::{CommandAnswer, written};
use crate::call::Call;
use crate::changed::prefix;
use crate::command::own::VARY;
use crate::fault::path_text;
use crate::source::SourceFile;
use crate::table::labelled;
use parts::{PART, SweepParts};
use quantities::{Language, format_number};
use questions::list::{Cost, Inquiry, Unanswered, sweep};
use questions::sweep::{SweepSummary, Tally};
use run::SweepRun;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use sweep_io::{BatchHead, Constants, Format, Repeats};
use table::{Table, TableRows};
use words::sweeps;

/// Columns of the answers besides those of the question (`--inputs`).
#[derive(Clone, Copy, PartialEq, Eq)]
enum Inputs {
    /// Columns of the table.
    Table,
    /// Columns of the table, and the values that the project states.
    All,
}

/// Steps of a range without `--steps`.
pub(crate) const STEPS: u64 = 11;

/// `antrieb sweep PROJECT --table FILE --out FILE`, `antrieb sweep PROJECT --vary KEY=VALUES`
pub(crate) fn sweep(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    let args = sweep::Args::read(&inquiry.given)?;
    let text = inquiry.source()?.text(language)?;
    let stated = call.texts(VARY);
    let steps = call.count("steps").unwrap_or(STEPS);
    let steps = usize::try_from(steps).unwrap_or(usize::MAX);
    let path = PathBuf::from(args.table.clone().unwrap_or_default());
    let rows = match &stated[..] {
        [] => TableRows::File(&path),
        _ => {
            let rows = vary::rows(text, args.axis.as_ref(), &stated, steps, language)?;
            refuse_changed_twice(call, &rows)?;
            refuse_faulty_keys(call, inquiry, (text, &rows), args.axis.as_ref())?;
            TableRows::Stated(rows)
        }
    };
    match (&rows, call.path("out")) {
        (TableRows::Stated(rows), None) => shown::sweep(call, inquiry, rows),
        (_, Some(out)) => into_file(call, inquiry, (&args, out), Table { rows, language }),
        (TableRows::File(_), None) => Ok(CommandAnswer::none()),
    }
}

/// Reads the rows that a call states, or checks that there is a table.
///
/// # Errors
/// Faults of the values, or a missing table.
pub(crate) fn readable(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<(), Unanswered> {
    let language = call.language;
    let args = sweep::Args::read(&inquiry.given)?;
    let text = inquiry.source()?.text(language)?;
    let stated = call.texts(VARY);
    if stated.is_empty() {
        let table = PathBuf::from(args.table.unwrap_or_default());
        let missing = || words::file_trouble(&std::io::ErrorKind::NotFound.into(), language);
        return if table.is_file() {
            Ok(())
        } else {
            Err(Unanswered::File { name: path_text(&table), message: missing(), is_too_large: false })
        };
    }
    let steps = usize::try_from(call.count("steps").unwrap_or(STEPS)).unwrap_or(usize::MAX);
    let rows = vary::rows(text, args.axis.as_ref(), &stated, steps, language)?;
    refuse_changed_twice(call, &rows)?;
    refuse_faulty_keys(call, inquiry, (text, &rows), args.axis.as_ref())
}

/// Refuses keys that the call multiplies for all rows and states in each row: the value of the row would replace the product.
/// A value that is set for all rows is one that the rows replace.
fn refuse_changed_twice(call: &Call<'_>, rows: &str) -> Result<(), Unanswered> {
    let headings = rows.lines().next().unwrap_or_default().split(',');
    let paths: Vec<&str> = headings.filter_map(|heading| heading.split(" [").next()).collect();
    // A line for each change, those of `--set` first, with each key as a word before its value: `mechanism.arm.mass 6 kg → 6.9 kg`.
    let scaled = call.changes.lines().skip(call.texts("set").len()).take(call.texts("scale").len());
    let mut changed = scaled.flat_map(str::split_whitespace);
    match changed.find(|word| paths.iter().any(|path| word.ends_with(path))) {
        Some(path) => {
            let usage = words::Usage::Twice { name: path.to_owned() };
            Err(Unanswered::option(VARY, (words::usage_text(&usage, call.language), None)))
        }
        None => Ok(()),
    }
}

/// Refuses values of keys of which no row can be evaluated, though the project alone can: the first and the last row are read.
fn refuse_faulty_keys(
    call: &Call<'_>,
    inquiry: &Inquiry<'_>,
    (text, rows): (&str, &str),
    axis: Option<&String>,
) -> Result<(), Unanswered> {
    let Some(files) = call.project_files() else { return Ok(()) };
    let prefix = prefix(text, axis).unwrap_or_default();
    let mut lines = rows.lines();
    let headings: Vec<&str> = lines.next().unwrap_or_default().split(',').collect();
    let values = |line: &str| -> Vec<(String, String)> {
        let value = |(heading, cell): (&&str, &str)| match heading.split_once(" [") {
            Some((path, unit)) => (format!("{prefix}{path}"), format!("{cell} {}", unit.trim_end_matches(']'))),
            None => (format!("{prefix}{heading}"), cell.to_owned()),
        };
        headings.iter().zip(line.split(',')).map(value).filter(|(path, _)| project::key_at(path).is_some()).collect()
    };
    let read = |text: &str, name: String| {
        let file = SourceFile::of_text(name, text.as_bytes().to_vec(), &files.folder, call.memory());
        file.source().projects(inquiry.catalogue, inquiry.progress, call.language).map(|_| ())
    };
    let name = inquiry.source()?.name.clone();
    let fault_of = |line: &str| {
        let values = values(line);
        let changed = project::edit_values(text, &values).ok()?;
        let stated: Vec<String> = values.iter().map(|(path, value)| format!("{path} → {value}")).collect();
        read(&changed, format!("{name} ({})", stated.join("; "))).err()
    };
    let (Some(first), Some(last)) = (lines.next(), lines.next_back()) else { return Ok(()) };
    match (fault_of(first), fault_of(last)) {
        (Some(_), Some(fault)) if read(text, name.clone()).is_ok() => Err(fault),
        _ => Ok(()),
    }
}

/// Writes the answers of a table to a file.
fn into_file(
    call: &Call<'_>,
    inquiry: &Inquiry<'_>,
    (args, out): (&sweep::Args, &Path),
    table: Table<'_>,
) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    let Some(project_files) = call.project_files() else { return Ok(CommandAnswer::none()) };
    let wanted = match call.text("inputs") {
        Some("all") => Some(Inputs::All),
        Some(_) => Some(Inputs::Table),
        // Values that no file holds are repeated in the answer.
        None => matches!(table.rows, TableRows::Stated(_)).then_some(Inputs::Table),
    };
    let source = inquiry.source()?;
    let text = source.text(language)?;
    let projects = source.projects(inquiry.catalogue, inquiry.progress, language);
    let products = run::products(&**inquiry.catalogue, projects.as_deref().unwrap_or_default());
    let costs = projects.iter().flatten().map(Cost::seconds_of_row);
    // From the project alone, so that the parts of a continued run are the same.
    let rows_in_time = rows_within(SECONDS_OF_PART, costs.fold(0.0, f64::max));
    let mut saver = call.saver();
    let place = format_of(call, out).and_then(|answers| saver.ready(&[out]).map(|()| answers));
    let opened = table.open(0, PART).map(|batches| (table, batches));
    let ready = match opened {
        Ok((table, batches)) => {
            let options = args.options(inquiry.catalogue, batches.commas(), language)?;
            let repeats = if wanted.is_some() { Repeats::Values } else { Repeats::Labels };
            let mut head = BatchHead::read(text, projects, &batches.schema(), repeats, options);
            head.refuse_unwritable(&batches.schema(), language);
            table.checked(batches, head, project_files.clone()).map(|(sweep, rows)| (table, sweep, rows))
        }
        Err(unread) => Err(Unanswered::combined(projects.err().into_iter().chain([unread]).collect())),
    };
    let (table, sweep, [rows, comments], answers) = match (ready, place) {
        (Ok((table, sweep, rows)), Ok(answers)) => (table, sweep, rows, answers),
        (ready, place) => return Err(Unanswered::combined(ready.err().into_iter().chain(place.err()).collect())),
    };
    let options = vec![
        ("--axis", format!("{:?}", args.axis)),
        ("--check", format!("{:?}", args.check)),
        ("--front", args.front.to_string()),
        ("--inputs", wanted.is_some().to_string()),
        ("--lang", language.id().to_owned()),
        ("--memory", call.memory().to_string()),
    ];
    let recordings = sweep.recordings();
    let run = SweepRun { table: &table, project: text, products, recordings, files: &project_files, options };
    // Files that the table names are protected too.
    saver.inputs.extend(run.recordings.iter().map(|name| project_files.folder.join(name)));
    saver.ready(&[out])?;
    let lines = sweep.rows_within(call.memory(), rows_in_time);
    let parts = SweepParts::of(&run, out, run.mark()?, lines, call.flag("force"))?;
    let mut talk = format!("{}\n", sweeps::keys(&sweep.keys().collect::<Vec<_>>().join(", "), language));
    let carried = sweep.carried().collect::<Vec<_>>().join(", ");
    if !carried.is_empty() {
        talk += &format!("{}\n", sweeps::carried(&carried, language));
    }
    if comments > 0 {
        talk += &format!("{}\n", words::terminal::comments_passed_over(&comments, language));
    }
    talk += &parts.remark(rows);
    if let Err(why) = parts.judged(&table, &sweep, rows, inquiry) {
        return Err(parts.ended(why));
    }
    let parts = parts.verified(&run)?;
    let constants = if wanted == Some(Inputs::All) {
        let keys: Vec<&str> = sweep.keys().collect();
        Constants::of(text, &prefix(text, args.axis.as_ref()).unwrap_or_default(), &keys)
    } else {
        Constants::default()
    };
    let mut tally = Tally::default();
    if let Err(why) = saver.save_by(out, |file| parts.join((answers, &constants), &sweep, rows, file, &mut tally)) {
        return Err(parts.ended(why));
    }
    parts.remove();
    let summary = tally.summary(sweep.sweep(), Some(path_text(out)));
    let data = if call.as_json { written(&summary) } else { shown(&summary, language) };
    Ok(CommandAnswer { talk, ..CommandAnswer::data(data) }.fits(summary.fitting > 0))
}

/// Time after which a part should be finished on one core \[s\]: what an interruption or a time limit loses at most.
const SECONDS_OF_PART: f64 = 30.0;

/// Returns the number of rows of a part that is finished within a time, from one to [`PART`].
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from one to the largest part")]
fn rows_within(seconds: f64, of_row: f64) -> usize {
    (seconds / of_row).clamp(1.0, PART as f64) as usize
}

/// Returns the format of the answers: that of the ending of their file, with the decimal sign of the call.
fn format_of(call: &Call<'_>, out: &Path) -> Result<Format, Unanswered> {
    let language = call.language;
    let ending = || Unanswered::option("out", (sweeps::ending_of_a_table(language).to_owned(), None));
    let format = Format::of(out).ok_or_else(ending)?;
    if !call.flag("decimal-comma") {
        return Ok(format);
    }
    let none = || Unanswered::option("decimal-comma", (sweeps::decimal_comma_of_csv(language).to_owned(), None));
    format.with_decimal_commas().ok_or_else(none)
}

/// Returns the summary for the terminal.
fn shown(summary: &SweepSummary, language: Language) -> String {
    #[allow(clippy::cast_precision_loss, reason = "counts of rows")]
    let share = |rows: u64| format_number(100.0 * rows as f64 / summary.rows.max(1) as f64, 1, language);
    let counted = |rows: u64| usize::try_from(rows).unwrap_or(usize::MAX);
    let mut text = String::new();
    if let Some(file) = &summary.file {
        let _ = writeln!(text, "{}", sweeps::written(counted(summary.rows), file, language));
    }
    let _ = writeln!(text, "{}", sweeps::fitting(counted(summary.fitting), &share(summary.fitting), language));
    if summary.fit_if_estimate > 0 {
        let rows = summary.fit_if_estimate;
        let _ = writeln!(text, "  {}", sweeps::fitting_if_estimate(&rows, &share(rows), language));
    }
    let missed: u64 = summary.none_fits.iter().map(|each| each.rows).sum();
    if missed > 0 {
        let _ = writeln!(
            text,
            "{}; {}:",
            sweeps::none_fits(counted(missed), &share(missed), language),
            sweeps::tightest(language)
        );
        for each in &summary.none_fits {
            let _ = writeln!(text, "  {:>10}  {}", each.rows, each.title);
        }
    }
    let refused: u64 = summary.not_judged.iter().map(|each| each.rows).sum::<u64>() + summary.further;
    if refused > 0 {
        let _ = writeln!(
            text,
            "{}; {}:",
            sweeps::not_judged(counted(refused), &share(refused), language),
            sweeps::reason(language)
        );
        for each in &summary.not_judged {
            let _ = writeln!(text, "  {:>10}  {}", each.rows, each.message);
        }
        if summary.further > 0 {
            let _ = writeln!(text, "  {:>10}  {}", summary.further, sweeps::further(language));
        }
    }
    for each in &summary.assumptions {
        text.push_str(&labelled(words::terms::assumed(language), &each.why));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A part takes half a minute at most by the estimate, whatever a row costs, and never more rows than the largest part.
    #[test]
    fn a_part_has_as_many_rows_as_its_time_permits() {
        for exponent in -8..8_i32 {
            let of_row = 3.0 * 10.0_f64.powi(exponent);
            let rows = rows_within(SECONDS_OF_PART, of_row);
            assert!((1..=PART).contains(&rows), "{of_row}");
            assert!(rows == 1 || rows as f64 * of_row <= SECONDS_OF_PART, "{of_row}: {rows}");
            assert!(rows == PART || (rows + 1) as f64 * of_row > SECONDS_OF_PART, "{of_row}: {rows}");
        }
    }

    /// A row costs more with the samples of a recording and with the ratios among which it chooses.
    #[test]
    fn a_long_recording_and_several_ratios_make_a_row_dear() {
        let axis = "format = 1\n[load]\ninertia = \"1 kg m^2\"\n[[motion]]\nlaw = \"trapezoid\"\ndistance = \"90 deg\"\n\
             time = \"0.5 s\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n";
        let cost = |text: &str| Cost::seconds_of_row(&questions::read(text).unwrap());
        let plain = cost(axis);
        assert_eq!(rows_within(SECONDS_OF_PART, plain), PART, "{plain}");
        let chosen = cost(&axis.replace(
            "[[motion]]\nlaw = \"trap",
            "[stage]\nkind = \"belt\"\nratios = [2, 3]\n[[motion]]\nlaw = \"trap",
        ));
        assert!(chosen > 20.0 * plain, "{chosen} {plain}");
    }
}
