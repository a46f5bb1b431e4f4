//! Charts of the tables: the course of the cycle and the utilisation of the checks.

use super::paper::Paper;
use super::sheet::FIRST;
use crate::cell::Cell;
use crate::error::WriteError;
use crate::table::Table;
use quantities::Language;
use rust_xlsxwriter::{Chart, ChartLine, ChartType, Worksheet};
use words::tables;

/// Largest number of drawn rows of a course; a choice of this crate that keeps a workbook quick to open.
const DRAWN_MOST: usize = 20_000;

const BLUE: &str = "1F4E9C";
const RED: &str = "A2222B";

/// Writes a sheet with the charts; `None` if there is nothing to draw.
pub(super) fn sheet(
    tables: &[Table],
    chosen: &str,
    title: &str,
    language: Language,
) -> Result<Option<Worksheet>, WriteError> {
    let table = |name: &str| tables.iter().find(|table| table.name == name);
    let charts = [
        table("course").and_then(|table| course(table, language)),
        table("checks").and_then(|table| utilisations(table, chosen, language)),
    ];
    if charts.iter().all(Option::is_none) {
        return Ok(None);
    }
    let mut sheet = Worksheet::new();
    sheet.set_name(title)?;
    let mut row = 0;
    for mut chart in charts.into_iter().flatten() {
        chart.set_width(960).set_height(430);
        sheet.insert_chart(row, 0, &chart)?;
        row += 23;
    }
    Paper::A4.set(&mut sheet);
    sheet.set_print_fit_to_pages(1, 1);
    Ok(Some(sheet))
}

/// Rows of a column as a range for a chart.
type Range<'t> = (&'t str, u32, u16, u32, u16);

fn range(table: &Table, column: usize, (first, last): (u32, u32)) -> Option<Range<'_>> {
    let column = u16::try_from(column).ok()?;
    Some((table.title.as_str(), first, column, last, column))
}

/// Draws torque and speed over time.
fn course(table: &Table, language: Language) -> Option<Chart> {
    if table.rows.is_empty() || table.rows.len() > DRAWN_MOST {
        return None;
    }
    let rows = (FIRST, FIRST + u32::try_from(table.rows.len()).ok()? - 1);
    let time = table.column("time")?;
    let mut chart = Chart::new(ChartType::ScatterStraight);
    chart.title().set_name(tables::course_chart(language));
    chart.x_axis().set_name(tables::time_in_s(language));
    chart.y_axis().set_name(tables::torque_in_nm(language));
    chart.y2_axis().set_name(tables::speed_per_minute(language));
    for (name, colour, second) in [("torque", RED, false), ("speed", BLUE, true)] {
        let column = table.column(name)?;
        let series = chart.add_series();
        series
            .set_categories(range(table, time, rows)?)
            .set_values(range(table, column, rows)?)
            .set_name(table.columns.get(column)?.title.as_str())
            .set_secondary_axis(second)
            .set_format(ChartLine::new().set_color(colour).set_width(1.5));
    }
    chart.legend().set_position(rust_xlsxwriter::ChartLegendPosition::Bottom);
    Some(chart)
}

/// Draws the utilisation of every check of the chosen actuator.
fn utilisations(table: &Table, chosen: &str, language: Language) -> Option<Chart> {
    let (code, title, share) = (table.column("code")?, table.column("title")?, table.column("utilisation")?);
    // The chosen actuator comes first.
    let own = table.rows.iter().take_while(|row| row.get(code).and_then(Cell::as_text) == Some(chosen)).count();
    let any = table.numbers(share).take(own).any(|number| number.is_some());
    if !any {
        return None;
    }
    let rows = (FIRST, FIRST + u32::try_from(own).ok()? - 1);
    let mut chart = Chart::new(ChartType::Column);
    chart.title().set_name(tables::checks_chart(language));
    chart
        .add_series()
        .set_categories(range(table, title, rows)?)
        .set_values(range(table, share, rows)?)
        .set_name(chosen)
        .set_format(rust_xlsxwriter::ChartSolidFill::new().set_color(BLUE));
    chart.y_axis().set_num_format("0%").set_min(0.0);
    chart.legend().set_hidden();
    Some(chart)
}
