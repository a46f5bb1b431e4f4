//! One table on a sheet.

use super::paper::{Paper, height, lines};
use super::style::{MARGIN, NEAR, RATIO, SHARE, Styles, decimals, single};
use crate::cell::Cell;
use crate::error::WriteError;
use crate::table::{Column, ColumnContent, Derived, Table};
use quantities::Language;
use questions::{Direction, Verdict};
use rust_xlsxwriter::utility::{column_number_to_name, row_col_to_cell};
use rust_xlsxwriter::{ConditionalFormatFormula, Format, FormatAlign, Formula, Url, Worksheet};
use std::collections::BTreeMap;
use words::{terms, verdict_word, without_limit};

/// Row of the first record, below heading and unit.
pub(super) const FIRST: u32 = 2;

/// Smallest and largest width of a column in characters; a longer text takes more lines, so that a page in landscape
/// stays legible.
const WIDTHS: (usize, usize) = (9, 34);

/// Number of rows that decide the width of a column.
const LOOK: usize = 2000;

/// Digits of a column, and of a single number among numbers of other units.
const DIGITS: (i32, i32) = (5, 4);

/// Links between the sheets of candidates and checks, which have the code in the first column.
#[derive(Debug, Default)]
pub(super) struct Links {
    /// Name and rows by code of the linked sheet, by the name of a table.
    to: BTreeMap<&'static str, (String, BTreeMap<String, u32>)>,
}

impl Links {
    pub(super) fn of(tables: &[Table]) -> Self {
        let mut links = Self::default();
        for (from, to) in [("candidates", "checks"), ("checks", "candidates")] {
            let Some(target) = tables.iter().find(|table| table.name == to) else { continue };
            let Some(code) = target.column("code") else { continue };
            let mut rows = BTreeMap::new();
            for (row, cells) in (FIRST..).zip(target.rows.iter()) {
                if let Some(text) = cells.get(code).and_then(Cell::as_text) {
                    rows.entry(text.to_owned()).or_insert(row);
                }
            }
            links.to.insert(from, (target.title.clone(), rows));
        }
        links
    }

    fn get(&self, table: &str, code: &str) -> Option<String> {
        let (title, rows) = self.to.get(table)?;
        rows.get(code).map(|row| format!("internal:'{title}'!{}", row_col_to_cell(*row, 0)))
    }
}

pub(super) fn sheet(
    table: &Table,
    links: &Links,
    styles: &Styles,
    language: Language,
) -> Result<Worksheet, WriteError> {
    let mut sheet = Worksheet::new();
    sheet.set_name(table.title.as_str())?;
    let mut widths: Vec<f64> = Vec::new();
    let ratio = styles.number(RATIO);
    let last = FIRST + u32::try_from(table.rows.len()).unwrap_or(u32::MAX - FIRST).max(1) - 1;
    for (at, column) in (0_u16..).zip(&table.columns) {
        let index = usize::from(at);
        // A heading stands over its values: those of numbers at the right.
        let over = |format: &Format| match column.kind {
            ColumnContent::Number | ColumnContent::Count | ColumnContent::Share | ColumnContent::Ratio => {
                format.clone().set_align(FormatAlign::Right)
            }
            ColumnContent::Text | ColumnContent::Id | ColumnContent::Verdict => format.clone(),
        };
        sheet.write_string_with_format(0, at, column.title.as_str(), &over(&styles.head))?;
        sheet.write_string_with_format(1, at, unit(column, language), &over(&styles.unit))?;
        let wide = width(table, index, column);
        sheet.set_column_width(at, wide)?;
        if column.kind == ColumnContent::Id {
            sheet.set_column_hidden(at)?;
        } else {
            widths.push(wide);
        }
        let derived = table.derived.iter().find(|derived| derived.column() == index);
        let format = column_format(table, index, column, derived, styles);
        let margin = table.derived.iter().find_map(|derived| match *derived {
            Derived::Margin { column, utilisation } if utilisation == index => Some(column),
            _ => None,
        });
        for (row, cells) in (FIRST..).zip(table.rows.iter()) {
            let Some(cell) = cells.get(index) else { continue };
            let place = RowCells { row, at, cells: &cells };
            // A utilisation without a margin beside it is one of a recommendation or a class.
            let plain = margin.is_some_and(|at| cells.get(at).is_some_and(|margin| margin.as_number().is_none()));
            let format = if plain { Some(&ratio) } else { format.as_ref() };
            write(&mut sheet, &place, cell, (column, derived), format, (table.name, links), styles)?;
        }
        let beside =
            Beside { margin, verdict: table.columns.iter().position(|each| each.kind == ColumnContent::Verdict) };
        colour(&mut sheet, (column, derived), beside, (at, last), styles, language)?;
    }
    let title = table.columns.iter().zip(&widths).map(|(column, wide)| lines(&column.title, *wide)).max();
    sheet.set_row_height(0, height(title.unwrap_or(1)))?;
    for (row, cells) in (FIRST..).zip(table.rows.iter()) {
        let most = cells.iter().zip(&widths).map(|(cell, wide)| cell.as_text().map_or(1, |text| lines(text, *wide)));
        // A row of one line keeps the default height of the program.
        if let Some(most) = most.max().filter(|most| *most > 1) {
            sheet.set_row_height(row, height(most))?;
        }
    }
    let right = u16::try_from(table.columns.len()).unwrap_or(1).max(1) - 1;
    sheet.autofilter(1, 0, last, right)?;
    let held = table.column("code").map_or(1, |code| u16::try_from(code).unwrap_or(0) + 1);
    sheet.set_freeze_panes(FIRST, held)?;
    sheet.set_repeat_rows(0, 1)?;
    // The pages beside the first one name their rows too.
    sheet.set_repeat_columns(0, held.saturating_sub(1))?;
    Paper::for_width(widths.iter().sum()).set(&mut sheet);
    Ok(sheet)
}

impl Derived {
    const fn column(self) -> usize {
        match self {
            Self::Utilisation { column, .. } | Self::Margin { column, .. } => column,
        }
    }
}

/// Returns the unit below the heading.
fn unit(column: &Column, language: Language) -> &'static str {
    match (column.kind, column.unit) {
        (ColumnContent::Share | ColumnContent::Ratio, _) => "%",
        (_, Some(unit)) if unit.symbol != "1" => unit.symbol_in(language),
        _ => "",
    }
}

fn width(table: &Table, index: usize, column: &Column) -> f64 {
    let longest = table
        .rows
        .iter()
        .take(LOOK)
        .filter_map(|row| match row.get(index)? {
            Cell::Text(text) | Cell::Word(_, text) | Cell::Ids(_, text) => Some(text.chars().count()),
            _ => None,
        })
        .max()
        .unwrap_or(0);
    // A heading may break at its spaces, a value should not.
    let word = column.title.split([' ', '-']).map(|word| word.chars().count()).max().unwrap_or(0);
    #[allow(clippy::cast_precision_loss, reason = "at most WIDTHS.1")]
    let width = longest.max(word).clamp(WIDTHS.0, WIDTHS.1) as f64;
    width * 1.1 + 2.0
}

/// Returns the format of the numbers of a column; `None` if each has its own.
fn column_format(
    table: &Table,
    index: usize,
    column: &Column,
    derived: Option<&Derived>,
    styles: &Styles,
) -> Option<Format> {
    match (column.kind, derived) {
        (ColumnContent::Share, Some(Derived::Margin { .. })) => Some(styles.number(MARGIN)),
        (ColumnContent::Share, _) => Some(styles.number(SHARE)),
        (ColumnContent::Ratio, _) => Some(styles.number(RATIO)),
        (ColumnContent::Count, _) => Some(styles.number("0")),
        (ColumnContent::Number, _) if column.unit.is_some() => {
            let largest = table.numbers(index).flatten().fold(0.0, |most: f64, number| most.max(number.abs()));
            Some(styles.number(&decimals(largest, DIGITS.0)))
        }
        _ => None,
    }
}

/// A cell with the row it belongs to.
struct RowCells<'t> {
    row: u32,
    at: u16,
    cells: &'t [Cell],
}

fn write(
    sheet: &mut Worksheet,
    place: &RowCells<'_>,
    cell: &Cell,
    (column, derived): (&Column, Option<&Derived>),
    format: Option<&Format>,
    (table, links): (&str, &Links),
    styles: &Styles,
) -> Result<(), WriteError> {
    let (row, at) = (place.row, place.at);
    match cell {
        Cell::Empty => {}
        Cell::Text(text) => {
            let link = (column.name == "code").then(|| links.get(table, text)).flatten();
            match link {
                Some(link) => sheet.write_url_with_format(row, at, Url::new(link).set_text(text), &styles.link)?,
                None => sheet.write_string_with_format(row, at, text, &styles.text)?,
            };
        }
        Cell::Word(_, text) | Cell::Ids(_, text) => {
            sheet.write_string_with_format(row, at, text, &styles.text)?;
        }
        Cell::Number(number) => {
            let own;
            let format = match format {
                Some(format) => format,
                None => {
                    own = styles.number(&single(*number, DIGITS.1));
                    &own
                }
            };
            match derived.and_then(|derived| formula(place, *number, *derived)) {
                Some(formula) => {
                    let formula = Formula::new(formula).set_result(number.to_string());
                    sheet.write_formula_with_format(row, at, formula, format)?
                }
                None => sheet.write_number_with_format(row, at, *number, format)?,
            };
        }
    }
    Ok(())
}

/// Returns the formula of a derived number, if it has one.
fn formula(place: &RowCells<'_>, number: f64, derived: Derived) -> Option<String> {
    let cell = |index: usize| Some(row_col_to_cell(place.row, u16::try_from(index).ok()?));
    let figure = |index: usize| place.cells.get(index).and_then(Cell::as_number);
    let gives = |found: f64| (found - number).abs() <= 1e-9 * number.abs().max(1e-3);
    match derived {
        Derived::Margin { utilisation, .. } => {
            gives(1.0 - figure(utilisation)?).then_some(format!("=1-{}", cell(utilisation)?))
        }
        Derived::Utilisation { value, limit, direction, .. } => {
            let at_least = place.cells.get(direction).and_then(Cell::as_text) == Some(Direction::AtLeast.id());
            let (upper, lower) = if at_least { (limit, value) } else { (value, limit) };
            let ratio = (figure(upper)? / figure(lower)?).abs();
            // The utilisation of a temperature is the share of its rise above the ambient temperature.
            gives(ratio).then_some(format!("=ABS({}/{})", cell(upper)?, cell(lower)?))
        }
    }
}

/// Columns on which the colour of a share depends.
#[derive(Clone, Copy)]
struct Beside {
    /// Column of the margin of this utilisation.
    margin: Option<usize>,
    /// Column of the verdicts.
    verdict: Option<usize>,
}

/// Adds colours by rule, which follow a changed value.
fn colour(
    sheet: &mut Worksheet,
    kind: (&Column, Option<&Derived>),
    beside: Beside,
    (at, last): (u16, u32),
    styles: &Styles,
    language: Language,
) -> Result<(), WriteError> {
    for (rule, format) in rules(kind, beside, at, styles, language) {
        // The first rule that holds decides alone; the bold of another would remain.
        let rule = ConditionalFormatFormula::new().set_rule(rule.as_str()).set_format(format).set_stop_if_true(true);
        sheet.add_conditional_format(FIRST, at, last, at, &rule)?;
    }
    Ok(())
}

/// Returns the rules of the colours of a column, the first one decides. A share above 1 that does not reject has the
/// colour of an advice; a utilisation without a margin beside it has none.
fn rules<'s>(
    (column, derived): (&Column, Option<&Derived>),
    beside: Beside,
    at: u16,
    styles: &'s Styles,
    language: Language,
) -> Vec<(String, &'s Format)> {
    let first = |at: u16| format!("${}{}", column_number_to_name(at), FIRST + 1);
    let of = |index: usize| u16::try_from(index).ok().map(first);
    let cell = first(at);
    let advised = [
        verdict_word(Verdict::Advice, language),
        terms::fits_if_estimate(language).to_owned(),
        terms::fits_unless_rating(language).to_owned(),
    ];
    let is_advised = beside.verdict.and_then(of).map(|verdict| {
        let words = advised.each_ref().map(|word| format!("{verdict}=\"{word}\"")).join(",");
        format!("OR({words})")
    });
    let mut rules: Vec<(String, &Format)> = Vec::new();
    match (column.kind, derived) {
        (ColumnContent::Share, Some(Derived::Margin { .. })) => {
            if let Some(is_advised) = is_advised {
                rules.push((format!("=AND(ISNUMBER({cell}),{cell}<0,{is_advised})"), &styles.near));
            }
            rules.push((format!("=AND(ISNUMBER({cell}),{cell}<0)"), &styles.over));
        }
        (ColumnContent::Share, _) => {
            let margin = beside.margin.and_then(of).unwrap_or_else(|| cell.clone());
            let number = format!("ISNUMBER({cell}),ISNUMBER({margin})");
            if let Some(is_advised) = is_advised {
                rules.push((format!("=AND({number},{cell}>1,{is_advised})"), &styles.near));
            }
            rules.push((format!("=AND({number},{cell}>1)"), &styles.over));
            rules.push((format!("=AND({number},{cell}>{NEAR},{cell}<=1)"), &styles.near));
            rules.push((format!("=AND({number},{cell}<={NEAR})"), &styles.fine));
        }
        (ColumnContent::Verdict, _) => {
            let word = |verdict| verdict_word(verdict, language);
            let [advice, if_estimate, unless_rating] = advised;
            for (text, format) in [
                (word(Verdict::Pass), &styles.fine),
                (word(Verdict::Fail), &styles.over),
                (advice, &styles.near),
                (word(Verdict::NotChecked), &styles.open),
                (without_limit(language), &styles.open),
                (terms::not_required(language).to_owned(), &styles.open),
                (terms::fits(language).to_owned(), &styles.fine),
                (if_estimate, &styles.near),
                (unless_rating, &styles.near),
                (terms::does_not_fit(language).to_owned(), &styles.over),
            ] {
                rules.push((format!("={cell}=\"{text}\""), format));
            }
        }
        _ => {}
    }
    rules
}

#[cfg(test)]
mod tests {
    use super::*;

    fn column(kind: ColumnContent) -> Column {
        Column { name: String::new(), title: String::new(), unit: None, about: String::new(), kind }
    }

    #[test]
    fn a_share_that_is_no_margin_has_no_colour_and_an_advice_has_its_own() {
        let styles = Styles::new();
        let beside = Beside { margin: Some(9), verdict: Some(3) };
        for language in [Language::En, Language::De] {
            let of = |kind, derived| rules((&column(kind), derived), beside, 8, &styles, language);
            assert!(of(ColumnContent::Ratio, None).is_empty());
            let utilisation = Derived::Utilisation { column: 8, value: 4, limit: 5, direction: 7 };
            let found = of(ColumnContent::Share, Some(&utilisation));
            assert_eq!(found.len(), 4);
            assert!(found.iter().all(|(rule, _)| rule.contains("ISNUMBER($J3)")), "{found:?}");
            let advice = verdict_word(Verdict::Advice, language);
            let (first, format) = &found[0];
            assert!(first.contains("$I3>1") && first.contains(&format!("$D3=\"{advice}\"")), "{first}");
            assert_eq!(**format, styles.near);
            let margin = Derived::Margin { column: 9, utilisation: 8 };
            let found = rules((&column(ColumnContent::Share), Some(&margin)), beside, 9, &styles, language);
            assert!(found[0].0.contains("$J3<0") && *found[0].1 == styles.near, "{found:?}");
        }
    }
}
