//! `licences`: authors and terms of the works in the program.

use crate::answer::CommandAnswer;
use crate::call::Call;
use questions::list::{Inquiry, Unanswered};

/// `antrieb licences`
pub(crate) fn licences(_: &Call<'_>, _: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let found = questions::list::licences::licences();
    let texts: Vec<String> = found.texts.iter().map(|each| each.text.trim_end().to_owned() + "\n").collect();
    Ok(CommandAnswer::data(texts.join("\n")))
}
