//! `licences`: whose work the program is, and under which terms.

use crate::answer::Answer;

/// `antrieb licences`
pub(crate) fn licences(as_json: bool) -> Answer {
    let found = workbench::licences();
    if as_json {
        return Answer::record(&found);
    }
    let texts: Vec<String> = found.texts.iter().map(|each| each.text.trim_end().to_owned() + "\n").collect();
    Answer::data(texts.join("\n"))
}
