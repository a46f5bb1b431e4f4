//! `export`: the results as a workbook, or one table in a file.

use crate::answer::{Answer, written};
use crate::code::parse_for_use;
use crate::fault::{Source, path_text, simple, text_option};
use crate::save::{ready, save};
use crate::subject::{in_reach, picked, refuse};
use crate::waiting::patience;
use clap::ArgMatches;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use tables::{Format, Front, NAMES, SHEET_ROWS_MOST, Subject, Table};
use workbench::answers::{ExportWritten, TableWritten};
use workbench::text::{hint_text, standing_text, terminal};
use workbench::{Candidate, Hint, Language, Project, Question, Sizing, answer};

/// What is asked for, before anything is computed.
struct Wish<'m> {
    /// The file; `None` for standard output.
    file: Option<&'m Path>,
    format: Format,
    /// One table; `None` for the whole workbook.
    table: Option<&'static str>,
    force: bool,
}

/// `antrieb export PROJECT (--out FILE | --table NAME)`
pub(crate) fn export(matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    answer(matches, as_json, language).unwrap_or_else(|fault| fault)
}

fn answer(matches: &ArgMatches, as_json: bool, language: Language) -> Result<Answer, Answer> {
    let wish = wish(matches, as_json, language)?;
    let option = |matches, name| text_option(matches, name, as_json, language);
    let path = matches.get_one::<PathBuf>("project").cloned().unwrap_or_default();
    let source = Source::read(&path, matches, as_json, language)?;
    let (revision, date) = (option(matches, "revision")?, option(matches, "date")?);
    let projects = source.projects(as_json, language)?;
    let inputs = source.inputs(&projects);
    if let Some(file) = wish.file {
        ready(&[file], &inputs, wish.force).map_err(|fault| fault.answer(as_json, language))?;
    }
    let mut axes = picked(projects, matches, as_json, language)?;
    if axes.len() > 1 {
        let names: Vec<&str> = axes.iter().map(|(_, project)| project.name.as_str()).collect();
        let names = names.join(", ");
        let what = terminal::export_is_of_one_axis(&names, language);
        return Err(simple(&what, as_json, language));
    }
    let Some((axis, project)) = axes.pop() else { return Ok(Answer::none()) };
    in_reach(Question::Other, [&project], as_json, language)?;
    let memory = source.memory();
    wish.format.within(&project, wish.table, memory).map_err(|refusal| refuse(&refusal, as_json, language))?;
    let top = usize::from(matches.get_one::<u16>("top").copied().unwrap_or(20));
    let sizing = workbench::sized(&project, top, patience()).map_err(|refusal| refuse(&refusal, as_json, language))?;
    let (chosen, talk) = chosen(matches, &project, &sizing, as_json, language)?;
    let subject =
        Subject { text: &source.text, axis, project: &project, sizing: &sizing, chosen: &chosen, top, language };
    let tables: Vec<Table> = match wish.table {
        Some(name) => subject.table(name, wish.format).into_iter().collect(),
        None => subject.tables(),
    };
    let file = path.file_name().map_or_else(|| source.name.clone(), |name| path_text(Path::new(name)));
    let front = Front {
        file: &file,
        revision: revision.as_deref(),
        date: date.as_deref(),
        project: &project,
        chosen: &chosen,
        language,
    };
    let bytes = bytes(&wish, &tables, &front).map_err(|error| simple(&error.message(language), as_json, language))?;
    let code = u8::from(!chosen.fits());
    let Some(file) = wish.file else {
        return Ok(Answer { data: String::from_utf8_lossy(&bytes).into_owned(), talk, code, ..Answer::none() });
    };
    save(&[(file, &bytes)], &inputs, wish.force).map_err(|fault| fault.answer(as_json, language))?;
    let (there, left_out): (Vec<&Table>, Vec<&Table>) = tables.iter().partition(|table| wish.format.holds(table));
    let data = if as_json {
        told_json(file, (&there, &left_out), &chosen)
    } else {
        told(file, (&there, &left_out), &chosen, language)
    };
    Ok(Answer { data, talk, code, ..Answer::none() })
}

fn wish<'m>(matches: &'m ArgMatches, as_json: bool, language: Language) -> Result<Wish<'m>, Answer> {
    let fault = |what: &str| simple(what, as_json, language);
    let names = NAMES.join(", ");
    let table = match matches.get_one::<String>("table") {
        None => None,
        Some(written) => Some(*NAMES.iter().find(|name| *name == written).ok_or_else(|| {
            let near = NAMES.iter().min_by_key(|name| strsim::damerau_levenshtein(name, written)).unwrap_or(&NAMES[0]);
            let close = strsim::damerau_levenshtein(near, written) * 2 <= near.len();
            let hint = if close {
                hint_text(&Hint::DidYouMean((*near).to_owned()), language)
            } else {
                hint_text(&Hint::ValidAre(NAMES.map(str::to_owned).to_vec()), language)
            };
            fault(&terminal::no_such_table(&written, &hint, language))
        })?),
    };
    let file = matches.get_one::<PathBuf>("out").map(PathBuf::as_path).filter(|path| path.as_os_str() != "-");
    let ending = file.map(|file| file.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase()));
    let format = match ending.as_ref().map(Option::as_deref) {
        None if as_json => Format::Json,
        None => Format::Csv,
        Some(ending) => {
            let known = ending.and_then(Format::of_ending);
            known.ok_or_else(|| fault(terminal::ending_says_the_format(language)))?
        }
    };
    if table.is_none() && format != Format::Workbook {
        return Err(fault(&terminal::name_one_table(&names, language)));
    }
    Ok(Wish { file, format, table, force: matches.get_flag("force") })
}

/// The code asked for, else the project's own actuator, else the best of the catalogue, be it the nearest miss.
fn chosen<'p>(
    matches: &ArgMatches,
    project: &'p Project,
    sizing: &Sizing<'p>,
    as_json: bool,
    language: Language,
) -> Result<(Candidate<'p>, String), Answer> {
    let asked = match matches.get_one::<String>("code") {
        Some(text) => Some(parse_for_use(text, as_json, language)?),
        None => None,
    };
    let (code, talk) = asked.map(|(reading, note)| (reading.parsed.code, note)).unzip();
    workbench::candidate_of_tables(project, code.as_ref(), sizing)
        .map(|candidate| (candidate, talk.unwrap_or_default()))
        .map_err(|refusal| refuse(&refusal, as_json, language))
}

fn bytes(wish: &Wish<'_>, tables: &[Table], front: &Front<'_>) -> Result<Vec<u8>, tables::WriteError> {
    let one = tables.first();
    Ok(match (wish.format, one) {
        (Format::Workbook, _) => tables::xlsx(tables, front)?,
        (Format::Csv, Some(table)) => tables::csv(table).into_bytes(),
        (Format::Json, Some(table)) => written(&tables::record(table)).into_bytes(),
        (Format::Parquet, Some(table)) => tables::parquet(table)?,
        (_, None) => Vec::new(),
    })
}

/// The tables in a file, and those that are too long for it.
type Told<'t> = (&'t [&'t Table], &'t [&'t Table]);

fn told(file: &Path, (there, left_out): Told<'_>, chosen: &Candidate<'_>, language: Language) -> String {
    let verdict = standing_text(chosen, language);
    let listed = |tables: &[&Table]| {
        let each = tables.iter().map(|table| format!("{} {}", table.name, table.rows.len()));
        each.collect::<Vec<_>>().join(", ")
    };
    let rows = terminal::rows(language);
    let mut told = format!("{}: {}: {verdict}; {rows}: {}", path_text(file), chosen.id, listed(there));
    if !left_out.is_empty() {
        let _ = write!(told, "; {}: {}", terminal::on_no_sheet(&SHEET_ROWS_MOST, language), listed(left_out));
    }
    told.push('\n');
    told
}

fn told_json(file: &Path, (there, left_out): Told<'_>, chosen: &Candidate<'_>) -> String {
    let listed = |tables: &[&Table]| {
        let each = tables.iter().map(|table| TableWritten { name: table.name.to_owned(), rows: table.rows.len() });
        each.collect()
    };
    written(&ExportWritten {
        file: path_text(file),
        code: chosen.id.to_string(),
        verdict: answer::fit(chosen),
        tables: listed(there),
        left_out: listed(left_out),
    })
}
