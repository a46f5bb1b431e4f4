//! Answers of the rows that a call states, on the terminal.

use crate::answer::{CommandAnswer, written};
use crate::call::Call;
use crate::command::own::VARY;
use crate::table::{Align, TextTable};
use quantities::{Language, format_significant};
use questions::CheckId;
use questions::list::{Inquiry, Unanswered, sweep};
use questions::sweep::{SweepCheck, SweepRow, SweepSummary};
use questions::texts::percent;
use words::{check_title, sweeps, terminal, terms, verdict_word};

/// Largest number of rows that are shown; --json and a file have all of them.
const ROWS_MOST: usize = 200;

/// Evaluates the rows of a table in CSV and shows their answers.
pub(super) fn sweep(call: &Call<'_>, inquiry: &Inquiry<'_>, rows: &str) -> Result<CommandAnswer, Unanswered> {
    let Some(files) = call.project_files() else { return Ok(CommandAnswer::none()) };
    let language = call.language;
    let name = format!("--{}", VARY);
    let summary = sweep::of_rows(inquiry, (&name, rows), Box::new(files))?;
    let fits = summary.fitting > 0;
    if call.as_json {
        return Ok(CommandAnswer::data(written(&summary)).fits(fits));
    }
    let headings: Vec<&str> = rows.lines().next().unwrap_or_default().split(',').collect();
    let text = format!("{}\n{}", table(&summary, &headings, language), super::shown(&summary, language));
    Ok(CommandAnswer::data(text).fits(fits))
}

/// Returns a table of the answers: the values of each row, its actuator, and the check that governs it.
fn table(summary: &SweepSummary, headings: &[&str], language: Language) -> String {
    let own = headings.iter().map(|heading| ((*heading).to_owned(), Align::Right));
    let of_answer = [
        (terms::fits(language).to_owned(), Align::Right),
        (terms::ordering_code(language).to_owned(), Align::Left),
        (terms::utilisation_short(language).to_owned(), Align::Right),
        (terms::tightest_check(language).to_owned(), Align::Left),
    ];
    let has_ratio = summary.answers.iter().any(|row| row.stage_ratio.is_some());
    let ratio = has_ratio.then(|| (terminal::ratio_of_the_stage(language).to_owned(), Align::Right));
    let checks: &[SweepCheck] =
        summary.answers.iter().map(|row| row.checks.as_slice()).find(|all| !all.is_empty()).unwrap_or_default();
    let of_checks = checks.iter().map(|check| (check_title(check.id.0, language), Align::Left));
    let mut table = TextTable::new(own.chain(of_answer).chain(ratio).chain(of_checks));
    for row in summary.answers.iter().take(ROWS_MOST) {
        let own = headings.iter().map(|heading| {
            let text = row.labels.get(*heading).map(String::as_str).unwrap_or_default();
            in_own_marks(text, language)
        });
        let ratio = row.stage_ratio.as_ref().map(|ratio| format_significant(ratio.0, 4, language));
        let ratio = has_ratio.then(|| ratio.unwrap_or_default());
        let checks = row.checks.iter().map(|check| checked(check, language));
        table.row(own.chain(answer(row, language)).chain(ratio).chain(checks).collect::<Vec<_>>());
    }
    let mut text = table.render();
    if summary.answers.len() > ROWS_MOST {
        text.push_str(&format!("{}\n", sweeps::shown_rows(&ROWS_MOST, &summary.answers.len(), language)));
    }
    text
}

/// Returns a value of a row, a number with the decimal mark of the language.
fn in_own_marks(text: &str, language: Language) -> String {
    match text.parse::<f64>() {
        Ok(_) => text.replace('.', language.decimal_mark().encode_utf8(&mut [0; 4])),
        Err(_) => text.to_owned(),
    }
}

/// Returns the verdict of a check with its utilisation; empty if there is none.
fn checked(check: &SweepCheck, language: Language) -> String {
    let verdict = check.verdict.as_ref().map(|verdict| verdict_word(verdict.0, language));
    let share = check.utilisation.as_ref().map(|share| format!("{} %", percent(Some(share.0), language)));
    verdict.into_iter().chain(share).collect::<Vec<_>>().join(" ")
}

/// Returns the cells of an answer: number of fitting codes, the best one, and its governing check or the reason.
fn answer(row: &SweepRow, language: Language) -> [String; 4] {
    let count = [row.fit, row.fit_if_estimate].into_iter().flatten().sum::<u32>();
    // The utilisation of an actuator that fits exceeds one only within the band of an estimate or beyond a foreign rating.
    let is_conditional = count > 0 && row.utilisation.as_ref().is_some_and(|share| share.0 > 1.0);
    let title = row.tightest.as_ref().map(|check: &answers::Id<CheckId>| {
        let title = check_title(check.0, language);
        if is_conditional { sweeps::on_a_condition(&title, language) } else { title }
    });
    let fits = if row.fit.is_some() { count.to_string() } else { String::new() };
    let none = || if count == 0 && row.error.is_none() { "–".to_owned() } else { String::new() };
    [
        fits,
        row.code.clone().unwrap_or_else(none),
        row.utilisation.as_ref().map(|share| percent(Some(share.0), language)).unwrap_or_default(),
        row.error.clone().or(title).unwrap_or_default(),
    ]
}
