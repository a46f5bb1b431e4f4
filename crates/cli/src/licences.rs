//! `licences`: whose work the program is, and under which terms.

use crate::answer::Answer;
use crate::call::Call;
use questions::list::{Asked, Unanswered};

/// `antrieb licences`
pub(crate) fn licences(_: &Call<'_>, _: &Asked<'_>) -> Result<Answer, Unanswered> {
    let found = questions::list::licences::licences();
    let texts: Vec<String> = found.texts.iter().map(|each| each.text.trim_end().to_owned() + "\n").collect();
    Ok(Answer::data(texts.join("\n")))
}
