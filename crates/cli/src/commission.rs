//! `commission`: motor data of a code for the drive, checklists, and the judgement of measured values.

mod recorded;

use crate::answer::{CommandAnswer, written};
use crate::call::Call;
use crate::fault::path_text;
use crate::laid_out;
use crate::report::checklist;
use answers::{Block, CommissionWritten, Commissioning};
use order_code::OrderCode;
use quantities::Language;
use questions::list::code_parse::uncovered;
use questions::list::commission::{DriveForm, usual_ambient};
use questions::list::{Inquiry, Unanswered, commission};
use questions::{answer, chapter};
use std::path::Path;
use words::describe_uncovered;

pub(crate) use recorded::recorded;

/// `antrieb commission CODE`
pub(crate) fn commission(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    let args = commission::Args::read(&inquiry.given)?;
    let about = commission::about(&args.code)?;
    let ambient = args.ambient.unwrap_or_else(usual_ambient);
    let form = args.form;
    let sheet = |form| answer::commissioning(&about, form, ambient, language);
    let mut files: Vec<(&Path, Vec<u8>)> = Vec::new();
    if let Some(blank) = call.path("blank") {
        let name = blank.file_name().map_or_else(String::new, |name| path_text(Path::new(name)));
        files.push((blank, questions::list::commission_blank::blank_record(&about, &name, language).into_bytes()));
    }
    if let Some(file) = call.path("checklist") {
        files.push((file, lists_as_pdf(file, &sheet(DriveForm::Plain), language)?));
    }
    if let (Some(out), Some(form)) = (call.path("out"), form) {
        let text = match form {
            DriveForm::Sinamics => questions::list::commission_drive::sinamics_script(&about, language),
            DriveForm::Cia402 => questions::list::commission_drive::eds(&about, language),
            DriveForm::Plain => written(&sheet(form)),
        };
        files.push((out, text.into_bytes()));
    }
    if !files.is_empty() {
        return write(&files, &about.code, call);
    }
    if call.as_json {
        return call.record(inquiry);
    }
    let (sheet, objects) = commission::found(inquiry)?;
    let mut chapter = chapter::commission(&sheet, &objects, language);
    let uncovered = uncovered(&about.code).into_iter().map(|what| describe_uncovered(what, language));
    for text in uncovered.collect::<Vec<_>>().into_iter().rev() {
        chapter.blocks.insert(0, Block::Text { text });
    }
    Ok(CommandAnswer::data(laid_out::shown(&chapter, language)))
}

/// Writes the requested files, all or none.
fn write(files: &[(&Path, Vec<u8>)], code: &OrderCode, call: &Call<'_>) -> Result<CommandAnswer, Unanswered> {
    let to_write: Vec<(&Path, &[u8])> = files.iter().map(|(path, bytes)| (*path, bytes.as_slice())).collect();
    call.saver().save(&to_write)?;
    let code = code.to_string();
    let records: Vec<CommissionWritten> = files
        .iter()
        .map(|(path, bytes)| CommissionWritten { file: path_text(path), code: code.clone(), bytes: bytes.len() })
        .collect();
    if call.as_json {
        return Ok(CommandAnswer::record(&records));
    }
    Ok(CommandAnswer::data(records.iter().map(|each| format!("{}: {}\n", each.file, each.code)).collect()))
}

fn lists_as_pdf(file: &Path, sheet: &Commissioning, language: Language) -> Result<Vec<u8>, Unanswered> {
    if !file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("pdf")) {
        return Err(Unanswered::message(words::commission::checklist_is_a_pdf(&path_text(file), language)));
    }
    checklist(sheet, language)
}
