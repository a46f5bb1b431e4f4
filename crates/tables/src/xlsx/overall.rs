//! The first sheet of a workbook of several axes: a row for each, and the names of their sheets.

use super::cover::Front;
use super::paper::{Paper, height, lines};
use super::style::{SHARE, Styles, decimals};
use crate::error::WriteError;
use crate::table::Table;
use quantities::unit::{KILOGRAM, NEWTON_METRE, REVOLUTION_PER_MINUTE};
use quantities::{Language, Measure, Unit};
use questions::texts::{governing_text, verdict_of};
use questions::{Demand, Verdict};
use rust_xlsxwriter::{Format, FormatAlign, Url, Worksheet};
use std::collections::BTreeSet;
use words::{figure_term, tables, terms};

/// Largest number of characters of the name of a sheet.
const NAME_MOST: usize = 31;

/// Characters that the name of a sheet cannot have; an apostrophe encloses it in formulas.
const BARRED: [char; 8] = ['[', ']', ':', '*', '?', '/', '\\', '\''];

/// Digits of a torque, a speed and a mass.
const DIGITS: i32 = 4;

/// Row of the headings.
const HEAD: u32 = 2;

/// Widths of the columns in characters.
const WIDTHS: [f64; 11] = [22.0, 24.0, 28.0, 30.0, 34.0, 12.0, 12.0, 12.0, 12.0, 10.0, 12.0];

/// Tables of one axis of several, with what its first sheet contains beside them.
#[derive(Clone, Debug)]
pub struct AxisSheets<'a> {
    /// Tables.
    pub tables: Vec<Table>,
    /// First sheet.
    pub front: Front<'a>,
}

/// Returns the names by which the sheets of each axis begin: permitted ones that differ without regard to case, short enough for
/// the longest title behind them.
pub(super) fn labels<'n>(names: impl Iterator<Item = &'n str>, longest_title: usize) -> Vec<String> {
    let most = NAME_MOST.saturating_sub(longest_title + 1);
    let mut taken = BTreeSet::new();
    names
        .map(|name| {
            let plain: String = name.chars().map(|sign| if is_barred(sign) { '-' } else { sign }).collect();
            let plain = plain.trim();
            let cut = |most: usize| plain.chars().take(most).collect::<String>().trim_end().to_owned();
            let numbered = (2..).map(|number: usize| {
                let number = number.to_string();
                format!(
                    "{}{}{number}",
                    cut(most.saturating_sub(number.len() + 1)),
                    if plain.is_empty() { "" } else { "-" }
                )
            });
            let first = Some(cut(most)).filter(|label| !label.is_empty());
            let mut possible = first.into_iter().chain(numbered);
            let label = possible.find(|label| !taken.contains(&label.to_lowercase())).unwrap_or_default();
            taken.insert(label.to_lowercase());
            label
        })
        .collect()
}

fn is_barred(sign: char) -> bool {
    BARRED.contains(&sign) || sign.is_control()
}

/// Returns the name of a sheet of an axis.
pub(super) fn named(label: &str, title: &str) -> String {
    format!("{label} {title}").chars().take(NAME_MOST).collect()
}

/// Writes the sheet with a row for each axis, whose name leads to its own first sheet.
pub(super) fn sheet(
    axes: &[AxisSheets<'_>],
    labels: &[String],
    styles: &Styles,
    language: Language,
) -> Result<Worksheet, WriteError> {
    let l = language;
    let mut sheet = Worksheet::new();
    sheet.set_name(tables::overview(l))?;
    sheet.write_string_with_format(0, 0, words::report::axes(l), &styles.title)?;
    sheet.set_row_height(0, 30)?;
    let right = |format: &Format| format.clone().set_align(FormatAlign::Right);
    let heads: [(String, &str); 11] = [
        (terms::axis(l).to_owned(), ""),
        (tables::project_file(l).to_owned(), ""),
        (terms::ordering_code(l).to_owned(), ""),
        (terms::verdict(l).to_owned(), ""),
        (terms::tightest_check(l).to_owned(), ""),
        (terms::utilisation(l).to_owned(), "%"),
        (figure_term("T_rms", l), NEWTON_METRE.symbol_in(l)),
        (figure_term("T_peak", l), NEWTON_METRE.symbol_in(l)),
        (figure_term("n_peak", l), REVOLUTION_PER_MINUTE.symbol_in(l)),
        (figure_term("m", l), KILOGRAM.symbol_in(l)),
        (tables::open_questions(l).to_owned(), ""),
    ];
    for ((column, (head, unit)), width) in (0_u16..).zip(&heads).zip(WIDTHS) {
        let over = |format: &Format| if column < FIRST_NUMBER { format.clone() } else { right(format) };
        sheet.write_string_with_format(HEAD, column, head, &over(&styles.head))?;
        sheet.write_string_with_format(HEAD + 1, column, *unit, &over(&styles.unit))?;
        sheet.set_column_width(column, width)?;
    }
    let most = heads.iter().zip(WIDTHS).map(|((head, _), wide)| lines(head, wide)).max();
    sheet.set_row_height(HEAD, height(most.unwrap_or(1)))?;
    let mut row = HEAD + 2;
    for (axis, label) in axes.iter().zip(labels) {
        one(&mut sheet, row, (axis, label), styles, l)?;
        row += 1;
    }
    sheet.set_freeze_panes(HEAD + 2, 1)?;
    row += 1;
    sheet.write_string_with_format(row, 0, tables::antrieb_version(l), &styles.label)?;
    sheet.write_string_with_format(row, 1, env!("CARGO_PKG_VERSION"), &styles.plain)?;
    sheet.write_string_with_format(row + 1, 0, tables::about_antrieb(l), &styles.label)?;
    Paper::for_width(WIDTHS.iter().sum()).set(&mut sheet);
    Ok(sheet)
}

/// First column of numbers.
const FIRST_NUMBER: u16 = 5;

/// Writes the row of an axis.
fn one(
    sheet: &mut Worksheet,
    row: u32,
    (axis, label): (&AxisSheets<'_>, &str),
    styles: &Styles,
    l: Language,
) -> Result<(), WriteError> {
    let chosen = axis.front.chosen;
    let target = format!("internal:'{}'!A1", named(label, tables::overview(l)));
    let name = if axis.front.project.name.is_empty() { label } else { &axis.front.project.name };
    sheet.write_url_with_format(row, 0, Url::new(target).set_text(name), &styles.link)?;
    sheet.write_string_with_format(row, 1, axis.front.file, &styles.text)?;
    sheet.write_string_with_format(row, 2, chosen.id.to_string(), &styles.strong)?;
    let format = match chosen.marked_as() {
        Verdict::Fail => &styles.over,
        Verdict::Advice => &styles.near,
        Verdict::Pass => &styles.fine,
        Verdict::NotChecked => &styles.text,
    };
    let verdict = verdict_of(chosen, l);
    sheet.write_string_with_format(row, 3, verdict, &format.clone().set_text_wrap().set_align(FormatAlign::Top))?;
    let governing = governing_text(chosen, l);
    sheet.write_string_with_format(row, 4, &governing, &styles.text)?;
    let most =
        [verdict, &governing, axis.front.file, name].into_iter().zip([WIDTHS[3], WIDTHS[4], WIDTHS[1], WIDTHS[0]]);
    let most = most.map(|(text, wide)| lines(text, wide)).max();
    sheet.set_row_height(row, height(most.unwrap_or(1)))?;
    if let Some(share) = chosen.utilisation().filter(|share| share.is_finite()) {
        sheet.write_number_with_format(row, FIRST_NUMBER, share, &styles.number(SHARE))?;
    }
    let demand = |of: fn(&Demand) -> f64| chosen.judgement.demand.as_ref().map(of);
    let figures: [(Option<f64>, &Unit); 4] = [
        (demand(|demand| demand.torque_rms.si()), &NEWTON_METRE),
        (demand(|demand| demand.torque_peak.si()), &NEWTON_METRE),
        (demand(|demand| demand.speed_peak.si()), &REVOLUTION_PER_MINUTE),
        (chosen.parameters.mass.known().map(|mass| mass.value.si()), &KILOGRAM),
    ];
    for (column, (si, unit)) in (FIRST_NUMBER + 1..).zip(figures) {
        if let Some(value) = si.map(|si| unit.from_si(si)) {
            sheet.write_number_with_format(row, column, value, &styles.number(&decimals(value, DIGITS)))?;
        }
    }
    #[allow(clippy::cast_precision_loss, reason = "at most the number of checks")]
    let open = chosen.open_questions() as f64;
    sheet.write_number_with_format(row, FIRST_NUMBER + 5, open, &styles.number("0"))?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_sheets_are_permitted_and_differ() {
        let long = "a very long name of an axis that no sheet could have";
        let names = [
            "arm",
            "Arm",
            "ARM",
            "",
            "",
            "x/y:z",
            "it's",
            long,
            &format!("{long} 2"),
            &format!("{long} 3"),
            "é",
            "'",
            "-",
        ];
        let labels = labels(names.into_iter(), 14);
        let sheets: Vec<String> = labels.iter().map(|label| named(label, "Berechnungen22")).collect();
        for sheet in &sheets {
            assert!(sheet.chars().count() <= NAME_MOST && sheet.ends_with("Berechnungen22"), "{sheet}");
            assert!(!sheet.chars().any(is_barred) && !sheet.starts_with(' '), "{sheet}");
        }
        let distinct: BTreeSet<String> = sheets.iter().map(|sheet| sheet.to_lowercase()).collect();
        assert_eq!(distinct.len(), names.len(), "{sheets:?}");
        assert_eq!(labels[..3], ["arm", "Arm-2", "ARM-3"]);
    }

    #[test]
    fn the_widths_have_a_heading_each() {
        assert_eq!(WIDTHS.len(), usize::from(FIRST_NUMBER) + 6);
    }
}
