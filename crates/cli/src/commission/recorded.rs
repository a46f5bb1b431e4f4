//! A recorded commissioning, judged.

use crate::answer::Answer;
use crate::fault::{Source, report};
use crate::table::{Align, Table, paragraph};
use clap::ArgMatches;
use std::path::Path;
use workbench::answers::{Fit, Recorded};
use workbench::text::{capitalised, commission, terms, told, verdict_word};
use workbench::{Commissioning, Language, answer, chapter};

/// `antrieb commission CODE --record FILE`: 0 nothing is off, 1 something is, 2 the record cannot be read.
pub(super) fn record(
    about: &Commissioning,
    path: &Path,
    matches: &ArgMatches,
    as_json: bool,
    language: Language,
) -> Result<Answer, Answer> {
    let source = Source::read(path, matches, as_json, language)?;
    let measured = workbench::measured(&source.text)
        .map_err(|faults| report(&source.name, &source.text, &told(&faults, language), as_json, language))?;
    let judged = workbench::judge(about, &measured);
    let recorded = answer::recorded(about, &judged, language);
    let fits = recorded.verdict == Fit::Fits;
    let answer = if as_json { Answer::record(&recorded) } else { Answer::data(text(&recorded, language)) };
    Ok(answer.fits(fits))
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
    let mut table = Table::new(heads);
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
    out
}
