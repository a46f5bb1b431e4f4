//! `commission`: what a drive is told about the motor of a code, check-lists, and the judgement of what was measured.

mod recorded;

use crate::answer::{Answer, written};
use crate::code::{parse_for_use, read_argument};
use crate::fault::{path_text, quantity, simple};
use crate::laid_out;
use crate::report::checklist;
use crate::save::{Unwritten, save};
use crate::subject::refuse;
use clap::ArgMatches;
use std::path::{Path, PathBuf};
use workbench::answers::{Block, CommissionAnswer, CommissionWritten, Commissioning};
use workbench::quantities::ThermodynamicTemperature;
use workbench::text::{commission, describe_uncovered};
use workbench::{DriveForm, Language, Refusal, answer, chapter, uncovered, usual_ambient};

/// `antrieb commission CODE`
pub(crate) fn commission(matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    answered(matches, as_json, language).unwrap_or_else(|answer| answer)
}

fn answered(matches: &ArgMatches, as_json: bool, language: Language) -> Result<Answer, Answer> {
    let (reading, talk) = parse_for_use(&read_argument(matches), as_json, language)?;
    let about =
        workbench::commission(&reading.parsed.code).ok_or_else(|| refuse(&Refusal::NoData, as_json, language))?;
    let path = |name: &str| matches.get_one::<PathBuf>(name);
    if let Some(record) = path("record") {
        if ["for", "out", "checklist", "blank"].iter().any(|name| matches.contains_id(name)) {
            return Err(simple(commission::record_alone(language), as_json, language));
        }
        let answer = recorded::record(&about, record, matches, as_json, language)?;
        return Ok(Answer { talk: format!("{talk}{}", answer.talk), ..answer });
    }
    let ambient: Option<ThermodynamicTemperature> = quantity(matches, "ambient", as_json, language)?;
    let ambient = ambient.unwrap_or_else(usual_ambient);
    let form = matches.get_one::<String>("for").and_then(|form| DriveForm::of_id(form));
    let sheet = |form| answer::commissioning(&about, form, ambient, language);
    let mut files: Vec<(PathBuf, Vec<u8>)> = Vec::new();
    if let Some(blank) = path("blank") {
        let name = blank.file_name().map_or_else(String::new, |name| path_text(Path::new(name)));
        files.push((blank.clone(), workbench::blank_record(&about, &name, language).into_bytes()));
    }
    if let Some(file) = path("checklist") {
        files.push((file.clone(), lists_as_pdf(file, &sheet(DriveForm::Plain), as_json, language)?));
    }
    if let (Some(out), Some(form)) = (path("out"), form) {
        let text = match form {
            DriveForm::Sinamics => workbench::sinamics_script(&about, language),
            DriveForm::Cia402 => workbench::eds(&about, language),
            DriveForm::Plain => written(&sheet(form)),
        };
        files.push((out.clone(), text.into_bytes()));
    }
    if !files.is_empty() {
        return write(&files, &about.code.to_string(), matches, as_json, language)
            .map(|answer| Answer { talk, ..answer });
    }
    let form = form.unwrap_or(DriveForm::Plain);
    let answer = match (as_json, form) {
        (true, DriveForm::Cia402) => {
            Answer::record(&CommissionAnswer::Objects(answer::drive_objects(&about, language)))
        }
        (true, _) => Answer::record(&CommissionAnswer::Sheet(Box::new(sheet(form)))),
        (false, _) => {
            let objects = if form == DriveForm::Cia402 { answer::drive_objects(&about, language) } else { Vec::new() };
            let mut chapter = chapter::commission(&sheet(form), &objects, language);
            let uncovered =
                uncovered(&about.code).into_iter().map(|what| describe_uncovered(what, language).to_owned());
            for text in uncovered.collect::<Vec<_>>().into_iter().rev() {
                chapter.blocks.insert(0, Block::Text { text });
            }
            Answer::data(laid_out::shown(&chapter, language))
        }
    };
    Ok(Answer { talk, ..answer })
}

/// Writes the files that were asked for, all or none.
fn write(
    files: &[(PathBuf, Vec<u8>)],
    code: &str,
    matches: &ArgMatches,
    as_json: bool,
    language: Language,
) -> Result<Answer, Answer> {
    let to_write: Vec<(&Path, &[u8])> = files.iter().map(|(path, bytes)| (path.as_path(), bytes.as_slice())).collect();
    save(&to_write, &[], matches.get_flag("force")).map_err(|fault| fault.answer(as_json, language))?;
    let told: Vec<CommissionWritten> = files
        .iter()
        .map(|(path, bytes)| CommissionWritten { file: path_text(path), code: code.to_owned(), bytes: bytes.len() })
        .collect();
    if as_json {
        return Ok(Answer::record(&told));
    }
    Ok(Answer::data(told.iter().map(|each| format!("{}: {}\n", each.file, each.code)).collect()))
}

fn lists_as_pdf(file: &Path, sheet: &Commissioning, as_json: bool, language: Language) -> Result<Vec<u8>, Answer> {
    if file.as_os_str() == "-" {
        return Err(Unwritten::to_stdout(file).answer(as_json, language));
    }
    if !file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("pdf")) {
        return Err(simple(&commission::checklist_is_a_pdf(&path_text(file), language), as_json, language));
    }
    checklist(sheet, as_json, language)
}
