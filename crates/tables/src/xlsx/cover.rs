//! The first sheet: the task, the result, and an explanation of the other sheets.

use super::paper::{Paper, height, lines};
use super::sheet::FIRST;
use super::style::{Styles, decimals};
use crate::error::WriteError;
use crate::format;
use crate::table::Table;
use answers::Identified;
use axis::AxisProject;
use chrono::NaiveDate;
use provenance::Grade;
use quantities::unit::NEWTON_METRE;
use quantities::{Language, Measure};
use questions::texts::{governing_text, standing_text};
use questions::{Candidate, Verdict};
use rust_xlsxwriter::utility::row_col_to_cell;
use rust_xlsxwriter::{ExcelDateTime, Format, Formula, Url, Worksheet};
use words::{Word, capitalised, grade_about, grade_word, tables, terms};

/// Content of the first sheet in addition to the tables.
#[derive(Clone, Copy, Debug)]
pub struct Front<'a> {
    /// Name of the project file.
    pub file: &'a str,
    /// Revision of the project, if stated.
    pub revision: Option<&'a str>,
    /// Date, if stated; the clock is not used.
    pub date: Option<NaiveDate>,
    /// Axis.
    pub project: &'a AxisProject,
    /// Actuator of the tables.
    pub chosen: &'a Candidate<'a>,
    /// Language of the words.
    pub language: Language,
}

/// Widths of the three columns in characters.
const WIDTHS: [f64; 3] = [30.0, 34.0, 80.0];

/// A sheet written from the top down.
struct Page<'s> {
    sheet: Worksheet,
    row: u32,
    styles: &'s Styles,
    language: Language,
}

impl Page<'_> {
    /// Fits the height of the current row to its texts, and advances to the next.
    fn next(&mut self, texts: [&str; 3]) -> Result<(), WriteError> {
        let most = texts.into_iter().zip(WIDTHS).map(|(text, wide)| lines(text, wide)).max();
        self.sheet.set_row_height(self.row, height(most.unwrap_or(1)))?;
        self.row += 1;
        Ok(())
    }

    fn heading(&mut self, words: Word) -> Result<(), WriteError> {
        self.row += 1;
        for column in 0..3 {
            let text = if column == 0 { capitalised(words(self.language)) } else { String::new() };
            self.sheet.write_string_with_format(self.row, column, text, &self.styles.head)?;
        }
        self.row += 1;
        Ok(())
    }

    fn pair(&mut self, label: Word, value: &str) -> Result<(), WriteError> {
        self.sheet.write_string_with_format(self.row, 0, label(self.language), &self.styles.label)?;
        self.sheet.write_string_with_format(self.row, 1, value, &self.styles.plain)?;
        self.next(["", value, ""])
    }

    fn date(&mut self, date: NaiveDate) -> Result<(), WriteError> {
        let form = tables::date_format(self.language);
        self.sheet.write_string_with_format(self.row, 0, terms::date(self.language), &self.styles.label)?;
        let format = self.styles.date.clone().set_num_format(form);
        let date = ExcelDateTime::parse_from_str(&date.to_string())?;
        self.sheet.write_datetime_with_format(self.row, 1, &date, &format)?;
        self.next([""; 3])
    }

    /// Writes a formula with its value, a unit and a remark.
    fn formula(&mut self, label: &str, formula: Formula, format: &Format, about: &str) -> Result<(), WriteError> {
        self.sheet.write_string_with_format(self.row, 0, label, &self.styles.label)?;
        self.sheet.write_formula_with_format(self.row, 1, formula, format)?;
        self.sheet.write_string_with_format(self.row, 2, about, &self.styles.plain)?;
        self.next(["", "", about])
    }
}

pub(super) fn sheet(
    tables: &[Table],
    front: &Front<'_>,
    title: &str,
    styles: &Styles,
) -> Result<Worksheet, WriteError> {
    let l = front.language;
    let mut page = Page { sheet: Worksheet::new(), row: 0, styles, language: l };
    page.sheet.set_name(title)?;
    for (column, width) in (0_u16..).zip(WIDTHS) {
        page.sheet.set_column_width(column, width)?;
    }
    let name = if front.project.name.is_empty() { front.file } else { &front.project.name };
    page.sheet.write_string_with_format(0, 0, name, &styles.title)?;
    page.sheet.set_row_height(0, 30)?;
    page.row = 1;
    answer(&mut page, front)?;
    effective_torque(&mut page, tables, front)?;
    contents(&mut page, tables)?;
    legend(&mut page)?;
    page.row += 1;
    page.sheet.write_string_with_format(page.row, 0, tables::about_antrieb(l), &styles.label)?;
    Paper::A4.set(&mut page.sheet);
    Ok(page.sheet)
}

fn answer(page: &mut Page<'_>, front: &Front<'_>) -> Result<(), WriteError> {
    let l = front.language;
    let chosen = front.chosen;
    page.sheet.write_string_with_format(page.row, 0, terms::verdict(l), &page.styles.label)?;
    let format = match chosen.marked_as() {
        Verdict::Fail => &page.styles.over,
        Verdict::Advice => &page.styles.near,
        Verdict::Pass => &page.styles.fine,
        Verdict::NotChecked => &page.styles.text,
    };
    let standing = standing_text(chosen, l);
    page.sheet.write_string_with_format(page.row, 1, &standing, &format.clone().set_bold().set_text_wrap())?;
    page.next(["", &standing, ""])?;
    page.sheet.write_string_with_format(page.row, 0, terms::ordering_code(l), &page.styles.label)?;
    page.sheet.write_string_with_format(page.row, 1, chosen.id.to_string(), &page.styles.strong)?;
    page.row += 1;
    if chosen.governing().is_some() {
        page.pair(terms::tightest_check, &governing_text(chosen, l))?;
    }
    page.pair(tables::open_questions, &chosen.open_questions().to_string())?;
    for objection in questions::answer::objections(chosen, l) {
        page.pair(terms::requirement_not_met, &objection)?;
    }
    page.pair(tables::project_file, front.file)?;
    if let Some(revision) = front.revision {
        page.pair(terms::revision, revision)?;
    }
    if let Some(date) = front.date {
        page.date(date)?;
    }
    page.pair(tables::antrieb_version, env!("CARGO_PKG_VERSION"))
}

/// Writes T_rms computed from the course, next to the exact integral.
fn effective_torque(page: &mut Page<'_>, tables: &[Table], front: &Front<'_>) -> Result<(), WriteError> {
    let l = front.language;
    let course = tables.iter().find(|table| table.name == "course" && format::Format::Workbook.holds(table));
    let (Some(course), Some(demand)) = (course, front.chosen.judgement.demand.as_ref()) else { return Ok(()) };
    let (Some(time), Some(torque)) = (course.column("time"), course.column("torque")) else { return Ok(()) };
    let (Ok(time_at), Ok(torque_at)) = (u16::try_from(time), u16::try_from(torque)) else { return Ok(()) };
    let last = FIRST + u32::try_from(course.rows.len()).unwrap_or(0) - 1;
    let Some(found) = trapezoid_rms(course, time, torque) else { return Ok(()) };
    let range = |column: u16, from: u32, to: u32| {
        format!("'{}'!{}:{}", course.title, row_col_to_cell(from, column), row_col_to_cell(to, column))
    };
    let (t_0, t_1) = (range(time_at, FIRST, last - 1), range(time_at, FIRST + 1, last));
    let (a, b) = (range(torque_at, FIRST, last - 1), range(torque_at, FIRST + 1, last));
    let all = range(time_at, FIRST, last);
    let formula = format!("=SQRT(SUMPRODUCT(({t_1}-{t_0})*({a}^2+{a}*{b}+{b}^2)/3)/(MAX({all})-MIN({all})))");
    let exact = NEWTON_METRE.from_si(demand.torque_rms.si());
    let digits = page.styles.number(&format!("{}\" Nm\"", decimals(exact, 5)));
    page.heading(tables::rms_torque_computed_twice)?;
    let from = page.row;
    page.formula(
        tables::t_rms_from_the_course(l),
        Formula::new(formula).set_result(found.to_string()),
        &digits,
        tables::t_rms_from_the_course_about(l),
    )?;
    page.sheet.write_string_with_format(page.row, 0, tables::t_rms_exact(l), &page.styles.label)?;
    page.sheet.write_number_with_format(page.row, 1, exact, &digits)?;
    page.sheet.write_string_with_format(page.row, 2, tables::t_rms_exact_about(l), &page.styles.plain)?;
    page.row += 1;
    let (course_cell, exact_cell) = (row_col_to_cell(from, 1), row_col_to_cell(from + 1, 1));
    let difference = if exact == 0.0 { 0.0 } else { found / exact - 1.0 };
    let share = page.styles.number("0.0000%");
    page.formula(
        tables::difference(l),
        Formula::new(format!("=IF({exact_cell}=0,0,{course_cell}/{exact_cell}-1)")).set_result(difference.to_string()),
        &share,
        tables::difference_about(l),
    )
}

/// Returns the value of the formula, for programs that show a workbook without computing it.
fn trapezoid_rms(course: &Table, time: usize, torque: usize) -> Option<f64> {
    let samples: Vec<(f64, f64)> =
        course.numbers(time).zip(course.numbers(torque)).map(|(t, m)| Some((t?, m?))).collect::<Option<_>>()?;
    let (first, last) = (samples.first()?.0, samples.last()?.0);
    let pairs = samples.iter().zip(samples.iter().skip(1));
    let square: f64 = pairs.map(|((t, a), (next, b))| (next - t) * (a * a + a * b + b * b) / 3.0).sum();
    let found = (square / (last - first)).sqrt();
    found.is_finite().then_some(found)
}

fn contents(page: &mut Page<'_>, tables: &[Table]) -> Result<(), WriteError> {
    let l = page.language;
    page.heading(tables::sheets)?;
    for table in tables {
        let rows = table.rows.len();
        let count = tables::rows(rows, l);
        if format::Format::Workbook.holds(table) {
            let link = Url::new(format!("internal:'{}'!A1", table.title)).set_text(table.title.as_str());
            page.sheet.write_url_with_format(page.row, 0, link, &page.styles.link)?;
            page.sheet.write_string_with_format(page.row, 1, count, &page.styles.plain)?;
        } else {
            let left = tables::too_many_rows(&count, &table.name, l);
            page.sheet.write_string_with_format(page.row, 0, table.title.as_str(), &page.styles.label)?;
            page.sheet.write_string_with_format(page.row, 1, left, &page.styles.plain)?;
        }
        page.sheet.write_string_with_format(page.row, 2, table.about.as_str(), &page.styles.plain)?;
        page.next(["", "", &table.about])?;
    }
    Ok(())
}

fn legend(page: &mut Page<'_>) -> Result<(), WriteError> {
    let l = page.language;
    page.heading(tables::how_to_read_it)?;
    let styles = page.styles;
    let marks: [(&str, &Format, Word); 4] = [
        ("62.0 %", &styles.fine, tables::legend_fine),
        ("● 91.0 %", &styles.near, tables::legend_near),
        ("▲ 104.0 %", &styles.over, tables::legend_over),
        ("–", &styles.open, tables::legend_open),
    ];
    for (shown, format, words) in marks {
        let shown = shown.replace('.', l.decimal_mark().encode_utf8(&mut [0; 4]));
        page.sheet.write_string_with_format(page.row, 0, shown, format)?;
        page.sheet.write_string_with_format(page.row, 2, words(l), &styles.plain)?;
        page.next(["", "", words(l)])?;
    }
    for &grade in <Grade as Identified>::ALL {
        page.sheet.write_string_with_format(page.row, 0, terms::grade(l), &styles.label)?;
        page.sheet.write_string_with_format(page.row, 1, grade_word(grade, l), &styles.plain)?;
        page.sheet.write_string_with_format(page.row, 2, grade_about(grade, l), &styles.plain)?;
        page.next(["", "", grade_about(grade, l)])?;
    }
    Ok(())
}
