//! `report` in a program that was built without the typesetting engine: it says so, and how to get it.

use crate::answer::Answer;
use crate::fault::simple;
use clap::ArgMatches;
use std::path::Path;
use workbench::Language;
use workbench::answers::Commissioning;
use workbench::text::terminal;

/// Reports and forms over HTTP.
pub(crate) const PRESS: Option<page::Press> = None;

/// `antrieb report PROJECT --out FILE`
pub(crate) fn report(_: &ArgMatches, as_json: bool, language: Language) -> Answer {
    refusal(as_json, language)
}

/// `antrieb size PROJECT --report FILE`
pub(crate) fn write(_: &ArgMatches, _: &Path, as_json: bool, language: Language) -> Result<Answer, Answer> {
    Err(refusal(as_json, language))
}

/// `antrieb commission CODE --checklist FILE`
pub(crate) fn checklist(_: &Commissioning, as_json: bool, language: Language) -> Result<Vec<u8>, Answer> {
    Err(refusal(as_json, language))
}

fn refusal(as_json: bool, language: Language) -> Answer {
    let what = terminal::built_without_report(language);
    simple(what, as_json, language)
}
