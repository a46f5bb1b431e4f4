//! The first sheet: what was asked, what came out, and how to read the rest.

use super::sheet::FIRST;
use super::style::{Styles, decimals};
use super::{Front, Paper, SHEET_ROWS_MOST, height, lines};
use crate::error::WriteError;
use crate::table::Table;
use crate::words::{Both, t};
use rust_xlsxwriter::utility::row_col_to_cell;
use rust_xlsxwriter::{ExcelDateTime, Format, Formula, Url, Worksheet};
use workbench::quantities::Measure;
use workbench::quantities::format_number;
use workbench::quantities::unit::NEWTON_METRE;
use workbench::text::{check_title, grade_about, grade_word, standing_text};
use workbench::{Grade, Language};

const GRADES: [Grade; 5] = [Grade::Printed, Grade::Computed, Grade::Published, Grade::Estimated, Grade::Assumed];

/// Widths of the three columns, in characters.
const WIDTHS: [f64; 3] = [30.0, 34.0, 80.0];

/// A sheet that is written from the top down.
struct Page<'s> {
    sheet: Worksheet,
    row: u32,
    styles: &'s Styles,
    language: Language,
}

impl Page<'_> {
    /// Makes the current row as high as its texts need, and goes on to the next.
    fn next(&mut self, texts: [&str; 3]) -> Result<(), WriteError> {
        let most = texts.into_iter().zip(WIDTHS).map(|(text, wide)| lines(text, wide)).max();
        self.sheet.set_row_height(self.row, height(most.unwrap_or(1)))?;
        self.row += 1;
        Ok(())
    }

    fn heading(&mut self, words: Both) -> Result<(), WriteError> {
        self.row += 1;
        for column in 0..3 {
            let text = if column == 0 { t(self.language, words) } else { "" };
            self.sheet.write_string_with_format(self.row, column, text, &self.styles.head)?;
        }
        self.row += 1;
        Ok(())
    }

    fn pair(&mut self, label: Both, value: &str) -> Result<(), WriteError> {
        let format = &self.styles.plain;
        self.sheet.write_string_with_format(self.row, 0, t(self.language, label), &self.styles.label)?;
        self.sheet.write_string_with_format(self.row, 1, value, format)?;
        self.next(["", value, ""])
    }

    /// The date as one, where it is one of the calendar; else as it is written.
    fn date(&mut self, text: &str) -> Result<(), WriteError> {
        let label = ["date", "Datum"];
        let mut parts = text.splitn(3, '-').map(str::parse::<u16>);
        let mut next = || parts.next().and_then(Result::ok);
        let found = next().zip(next()).zip(next()).and_then(|((year, month), day)| {
            ExcelDateTime::from_ymd(year, u8::try_from(month).ok()?, u8::try_from(day).ok()?).ok()
        });
        let Some(date) = found else { return self.pair(label, text) };
        let form = t(self.language, ["yyyy-mm-dd", "dd.mm.yyyy"]);
        self.sheet.write_string_with_format(self.row, 0, t(self.language, label), &self.styles.label)?;
        let format = self.styles.date.clone().set_num_format(form);
        self.sheet.write_datetime_with_format(self.row, 1, &date, &format)?;
        self.next([""; 3])
    }

    /// A formula with its value, a unit and a remark.
    fn formula(&mut self, label: &str, formula: Formula, format: &Format, about: &str) -> Result<(), WriteError> {
        self.sheet.write_string_with_format(self.row, 0, label, &self.styles.label)?;
        self.sheet.write_formula_with_format(self.row, 1, formula, format)?;
        self.sheet.write_string_with_format(self.row, 2, about, &self.styles.plain)?;
        self.next(["", "", about])
    }
}

pub(super) fn sheet(tables: &[Table], front: &Front<'_>, styles: &Styles) -> Result<Worksheet, WriteError> {
    let l = front.language;
    let mut page = Page { sheet: Worksheet::new(), row: 0, styles, language: l };
    page.sheet.set_name(t(l, ["Overview", "Übersicht"]))?;
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
    let sentence = [
        "antrieb is an open engineering workbench for hollow-shaft servo actuators; it is not affiliated with their maker.",
        "antrieb ist ein offenes Auslegungswerkzeug für Hohlwellen-Servoantriebe; es steht in keiner Verbindung zu deren Hersteller.",
    ];
    page.sheet.write_string_with_format(page.row, 0, t(l, sentence), &styles.label)?;
    Paper::A4.set(&mut page.sheet);
    Ok(page.sheet)
}

fn answer(page: &mut Page<'_>, front: &Front<'_>) -> Result<(), WriteError> {
    let l = front.language;
    let chosen = front.chosen;
    page.sheet.write_string_with_format(page.row, 0, t(l, ["verdict", "Urteil"]), &page.styles.label)?;
    let format = match (chosen.fits(), chosen.open_questions()) {
        (false, _) => &page.styles.over,
        (true, 0) => &page.styles.fine,
        (true, _) => &page.styles.text,
    };
    let standing = standing_text(chosen, l);
    page.sheet.write_string_with_format(page.row, 1, &standing, &format.clone().set_bold().set_text_wrap())?;
    page.next(["", &standing, ""])?;
    let label = t(l, ["ordering code", "Bestellbezeichnung"]);
    page.sheet.write_string_with_format(page.row, 0, label, &page.styles.label)?;
    page.sheet.write_string_with_format(page.row, 1, chosen.id.to_string(), &page.styles.strong)?;
    page.row += 1;
    if let Some(check) = chosen.judgement.tightest() {
        let share = format_number(check.utilisation.unwrap_or(0.0) * 100.0, 1, l);
        page.pair(["tightest check", "engster Nachweis"], &format!("{}, {share} %", check_title(check.id, l)))?;
    }
    page.pair(["open questions", "offene Fragen"], &chosen.open_questions().to_string())?;
    for objection in workbench::answer::objections(chosen, l) {
        page.pair(["requirement not met", "Anforderung nicht erfüllt"], &objection)?;
    }
    page.pair(["project file", "Projektdatei"], front.file)?;
    if let Some(revision) = front.revision {
        page.pair(["revision", "Revision"], revision)?;
    }
    if let Some(date) = front.date {
        page.date(date)?;
    }
    page.pair(["antrieb, version", "antrieb, Version"], env!("CARGO_PKG_VERSION"))
}

/// T_rms once more from the course, beside the exact integral.
fn effective_torque(page: &mut Page<'_>, tables: &[Table], front: &Front<'_>) -> Result<(), WriteError> {
    let l = front.language;
    let course = tables.iter().find(|table| table.name == "course" && table.rows.len() <= SHEET_ROWS_MOST);
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
    page.heading(["Rms torque, computed twice", "Effektives Drehmoment, zweimal gerechnet"])?;
    let from = page.row;
    page.formula(
        t(l, ["T_rms from the course", "T_rms aus dem Verlauf"]),
        Formula::new(formula).set_result(found.to_string()),
        &digits,
        t(
            l,
            [
                "formula over the sheet of the course, torque linear between its instants",
                "Formel über das Blatt „Verlauf“, Drehmoment zwischen den Zeitpunkten linear",
            ],
        ),
    )?;
    page.sheet.write_string_with_format(page.row, 0, t(l, ["T_rms exact", "T_rms exakt"]), &page.styles.label)?;
    page.sheet.write_number_with_format(page.row, 1, exact, &digits)?;
    let about = ["exact integral, which the checks use", "exaktes Integral, mit dem geprüft wird"];
    page.sheet.write_string_with_format(page.row, 2, t(l, about), &page.styles.plain)?;
    page.row += 1;
    let (course_cell, exact_cell) = (row_col_to_cell(from, 1), row_col_to_cell(from + 1, 1));
    let difference = if exact == 0.0 { 0.0 } else { found / exact - 1.0 };
    let share = page.styles.number("0.0000%");
    page.formula(
        t(l, ["difference", "Unterschied"]),
        Formula::new(format!("=IF({exact_cell}=0,0,{course_cell}/{exact_cell}-1)")).set_result(difference.to_string()),
        &share,
        t(l, ["what the sampling leaves out", "was die Abtastung weglässt"]),
    )
}

/// What the formula gives, for programs that show a workbook without computing it.
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
    page.heading(["Sheets", "Blätter"])?;
    for table in tables {
        let rows = table.rows.len();
        let count = match l {
            Language::En if rows == 1 => "1 row".to_owned(),
            Language::De if rows == 1 => "1 Zeile".to_owned(),
            Language::En => format!("{rows} rows"),
            Language::De => format!("{rows} Zeilen"),
        };
        if rows <= SHEET_ROWS_MOST {
            let link = Url::new(format!("internal:'{}'!A1", table.title)).set_text(table.title.as_str());
            page.sheet.write_url_with_format(page.row, 0, link, &page.styles.link)?;
            page.sheet.write_string_with_format(page.row, 1, count, &page.styles.plain)?;
        } else {
            let left = match l {
                Language::En => format!("{count}, too many for a sheet: antrieb export --table {}", table.name),
                Language::De => format!("{count}, zu viele für ein Blatt: antrieb export --table {}", table.name),
            };
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
    page.heading(["How to read it", "Wie man es liest"])?;
    let styles = page.styles;
    for (shown, format, words) in [
        ("62.0 %", &styles.fine, ["up to 80 % of a limit, or passed", "bis 80 % einer Grenze, oder erfüllt"]),
        ("● 91.0 %", &styles.near, ["above 80 % of a limit, or advice", "über 80 % einer Grenze, oder Hinweis"]),
        ("▲ 104.0 %", &styles.over, ["above a limit, or failed", "über einer Grenze oder nicht erfüllt"]),
        (
            "–",
            &styles.open,
            [
                "not checked: a datum is missing; it counts as neither passed nor failed",
                "nicht geprüft: eine Angabe fehlt; es zählt weder als erfüllt noch als nicht erfüllt",
            ],
        ),
    ] {
        let shown = if l == Language::De { shown.replace('.', ",") } else { shown.to_owned() };
        page.sheet.write_string_with_format(page.row, 0, shown, format)?;
        page.sheet.write_string_with_format(page.row, 2, t(l, words), &styles.plain)?;
        page.next(["", "", t(l, words)])?;
    }
    for grade in GRADES {
        page.sheet.write_string_with_format(page.row, 0, t(l, ["grade", "Güte"]), &styles.label)?;
        page.sheet.write_string_with_format(page.row, 1, grade_word(grade, l), &styles.plain)?;
        page.sheet.write_string_with_format(page.row, 2, grade_about(grade, l), &styles.plain)?;
        page.next(["", "", grade_about(grade, l)])?;
    }
    Ok(())
}
