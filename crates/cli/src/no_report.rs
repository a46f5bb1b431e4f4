//! `report` in a program that was built without the typesetting engine: it says so, and how to get it.

use crate::answer::Answer;
use crate::fault::simple;
use clap::ArgMatches;
use std::path::Path;
use workbench::Language;

/// `antrieb report PROJECT --out FILE`
pub(crate) fn report(_: &ArgMatches, as_json: bool, language: Language) -> Answer {
    refusal(as_json, language)
}

/// `antrieb size PROJECT --report FILE`
pub(crate) fn write(_: &ArgMatches, _: &Path, as_json: bool, language: Language) -> Result<Answer, Answer> {
    Err(refusal(as_json, language))
}

fn refusal(as_json: bool, language: Language) -> Answer {
    let what = match language {
        Language::En => {
            "this antrieb was built without the typesetting engine and writes no report; \
             `cargo install --path crates/cli` builds it with the report"
        }
        Language::De => {
            "dieses antrieb ist ohne Satzsystem gebaut und schreibt keinen Bericht; \
             `cargo install --path crates/cli` baut es mit Bericht"
        }
    };
    simple(what, as_json, language)
}
