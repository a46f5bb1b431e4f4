//! `commission --record`: judgement of a recorded commissioning.

use crate::answer::CommandAnswer;
use crate::call::Call;
use crate::table::{Align, TextTable, paragraph};
use answers::{Fit, Recorded};
use quantities::Language;
use questions::chapter;
use questions::list::{Inquiry, Unanswered, commission_record};
use words::{capitalised, commission, terms, verdict_word};

/// `antrieb commission CODE --record FILE`: 0 nothing is off, 1 something is, 2 the record cannot be read.
pub(crate) fn recorded(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let has_file = |name: &&str| call.path(name).is_some();
    if call.text("for").is_some() || ["out", "checklist", "blank"].iter().any(has_file) {
        return Err(Unanswered::message(commission::record_alone(call.language)));
    }
    let found = commission_record::found(inquiry)?;
    Ok(CommandAnswer::data(text(&found, call.language)).fits(found.verdict == Fit::Fits))
}

fn text(recorded: &Recorded, language: Language) -> String {
    let summary = commission::record_summary(&recorded.off, &recorded.not_checked, language);
    let mut out = format!("{}: {summary}\n\n", capitalised(&commission::title(&recorded.code, language)));
    let heads = [
        (commission::measured(language), Align::Left),
        (terms::verdict(language), Align::Left),
        (terms::value(language), Align::Right),
        (commission::expected(language), Align::Right),
        (terms::unit(language), Align::Left),
        (terms::remark(language), Align::Left),
    ];
    let lines = chapter::recorded(recorded, language);
    let mut table = TextTable::new(heads);
    for line in &lines {
        table.row([
            line.name.clone(),
            verdict_word(line.verdict, language),
            line.value.clone(),
            line.expected.clone(),
            line.unit.clone(),
            line.remark.clone(),
        ]);
    }
    out.push_str(&table.render());
    for (line, cause) in lines.iter().filter_map(|line| Some((line, line.cause.as_ref()?))) {
        out.push_str(&paragraph(&format!("{}: ", line.name), cause));
    }
    for erratum in chapter::marked_errata(&recorded.errata, language) {
        out.push_str(&paragraph("", &erratum));
    }
    out
}
