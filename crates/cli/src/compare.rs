//! `compare`: comparison of several actuators.

use crate::answer::CommandAnswer;
use crate::call::Call;
use crate::reserve::assumptions_text;
use crate::table::{Align, TextTable, paragraph};
use axis::AxisProject;
use order_code::OrderCode;
use quantities::{Language, format_significant};
use questions::list::compare::{Comparison, DatumRow, errata_of};
use questions::list::{Inquiry, Unanswered, compare};
use questions::texts::{ValuesInRow, governing_text, margin_text, standing_text, verdict_of};
use questions::{Candidate, Check, Verdict, answer};
use std::fmt::Write as _;
use words::{
    ERRATUM_MARK, check_title, erratum_line, figure_term, marked, symbol_shown, terminal, terms, verdict_word,
    without_limit,
};

/// Number of actuators in one table; further ones follow in the next.
const BESIDE: usize = 3;

/// `antrieb compare PROJECT --code A --code B`
pub(crate) fn compare(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    let (args, axes) = compare::read(inquiry)?;
    let found = inquiry.each(&axes, |project| {
        let found = args.comparison(project, inquiry)?;
        Ok((text(&found, project, language), found.candidates.iter().any(Candidate::fits)))
    })?;
    Ok(CommandAnswer::of_axes(found))
}

fn text(found: &Comparison<'_>, project: &AxisProject, language: Language) -> String {
    let mut out = String::new();
    if !project.name.is_empty() {
        let _ = writeln!(out, "{}", project.name);
    }
    for (index, candidate) in found.candidates.iter().enumerate() {
        let tightest = match governing_text(candidate, language) {
            none if none.is_empty() => none,
            some => format!(", {some}"),
        };
        // That nothing fails says little about an actuator with few data.
        let verdict = match candidate.product.is_described() {
            true => standing_text(candidate, language),
            false => verdict_of(candidate, language).to_owned(),
        };
        let first = if found.better == Some(index) {
            format!("; {}", terminal::first_in_the_ranking(language))
        } else {
            String::new()
        };
        let _ = writeln!(out, "{}  {}: {verdict}{tightest}{first}", letter(index), candidate.id);
        for objection in answer::objections(candidate, language) {
            out.push_str(&paragraph("   ", &objection));
        }
    }
    let all: Vec<usize> = (0..found.candidates.len()).collect();
    for part in all.chunks(BESIDE) {
        out.push('\n');
        out.push_str(&checks(found, part, language));
    }
    let pass = verdict_word(Verdict::Pass, language);
    let fail = verdict_word(Verdict::Fail, language);
    let advice = verdict_word(Verdict::Advice, language);
    let open = verdict_word(Verdict::NotChecked, language);
    let shown = without_limit(language);
    let room = terminal::lowest_utilisation(language);
    let _ = writeln!(out, "✓ {pass} · ✗ {fail} · ! {advice} · ? {open} · ○ {shown} · * {room}\n");
    out.push_str(&figures(found, language));
    out.push_str(&assumptions_text(&project.assumptions, language));
    out
}

fn letter(index: usize) -> char {
    ('A'..='E').nth(index).unwrap_or('?')
}

fn sign(check: &Check) -> char {
    match check.verdict {
        Verdict::Pass => '✓',
        Verdict::Fail => '✗',
        Verdict::Advice => '!',
        Verdict::NotChecked if check.is_without_limit() => '○',
        Verdict::NotChecked => '?',
    }
}

fn checks(found: &Comparison<'_>, part: &[usize], language: Language) -> String {
    let mut heads =
        vec![(terms::check(language).to_owned(), Align::Left), (terms::unit(language).to_owned(), Align::Left)];
    for index in part {
        let letter = letter(*index);
        heads.push((format!("{letter} {}", terms::value(language)), Align::Right));
        heads.push((format!("{letter} {}  ", terms::utilisation_short(language)), Align::Right));
    }
    let mut table = TextTable::new(heads);
    for row in &found.checks {
        let values = ValuesInRow::of(row.checks.iter().map(Option::as_ref));
        let mut cells = vec![check_title(row.id, language), values.unit(language).to_owned()];
        for index in part {
            match row.checks.get(*index).and_then(Option::as_ref) {
                Some(check) => {
                    let margin = margin_text(check, language);
                    // A check without a utilisation is none with the lowest.
                    let better = if row.better == Some(*index) && margin != "–" { '*' } else { ' ' };
                    cells.push(values.value(check, language));
                    cells.push(format!("{better}{margin} {}", sign(check)));
                }
                None => cells.extend(["–".to_owned(), "–  ".to_owned()]),
            }
        }
        table.row(cells);
    }
    table.render()
}

fn figures(found: &Comparison<'_>, language: Language) -> String {
    table_of(found.candidates.len(), found.demand.iter().chain(&found.data), language)
        + &errata_lines(&found.data, language)
}

/// Returns the data of several actuators side by side, as `data CODE --beside CODE` shows them.
pub(crate) fn data_text(codes: &[OrderCode], data: &[DatumRow], language: Language) -> String {
    let line = |(index, code): (usize, &OrderCode)| format!("{}  {code}\n", letter(index));
    let codes_of: String = codes.iter().enumerate().map(line).collect();
    format!("{codes_of}\n{}{}", table_of(codes.len(), data.iter(), language), errata_lines(data, language))
}

fn table_of<'r>(count: usize, rows: impl Iterator<Item = &'r DatumRow>, language: Language) -> String {
    let mut heads =
        vec![(terminal::figure(language).to_owned(), Align::Left), (terms::unit(language).to_owned(), Align::Left)];
    heads.extend((0..count).map(|index| (letter(index).to_string(), Align::Right)));
    let mut table = TextTable::new(heads);
    for row in rows {
        let mut cells = names(row, language).to_vec();
        let marked = |(place, value): (usize, &Option<f64>)| marked(shown(*value, language), row.errata_of(place));
        cells.extend(row.values.iter().enumerate().map(marked));
        table.row(cells);
    }
    table.render()
}

/// Returns the errata of some data, a paragraph for each.
fn errata_lines(data: &[DatumRow], language: Language) -> String {
    let line = |id| paragraph(&format!("{ERRATUM_MARK} "), &erratum_line(id, language));
    errata_of(data).into_iter().map(line).collect()
}

/// Returns symbol with name, and unit.
pub(crate) fn names(row: &DatumRow, language: Language) -> [String; 2] {
    let name = format!("{} {}", symbol_shown(row.symbol), figure_term(row.symbol, language));
    [name, if row.unit.symbol == "1" { "–".to_owned() } else { row.unit.symbol_in(language).to_owned() }]
}

pub(crate) fn shown(value: Option<f64>, language: Language) -> String {
    value.map_or_else(|| "–".to_owned(), |value| format_significant(value, 4, language))
}
