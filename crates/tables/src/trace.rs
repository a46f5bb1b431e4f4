//! Course of a simulation as a table.

use crate::csv::csv;
use crate::rows::Rows;
use crate::subject::column;
use crate::table::{ColumnContent, Table};
use quantities::Language;
use quantities::unit::{DEGREE_CELSIUS, HOUR};
use questions::{PeriodCourse, SIGNALS, Signal, TIME, TwinSample};
use words::{capitalised, simulation, terms};

/// Returns the course of a simulation: the time, then these signals; every signal if none is named.
#[must_use]
pub fn trace(samples: &[TwinSample], signals: &[&Signal], language: Language) -> Table {
    let all: Vec<&Signal> = SIGNALS.iter().collect();
    let named = if signals.is_empty() { all.as_slice() } else { signals };
    let shown: Vec<&Signal> = std::iter::once(&TIME).chain(named.iter().copied()).collect();
    // The name already contains the unit.
    let heading = |each: &&Signal| column(each.column, each.title, ColumnContent::Number, None, each.about, language);
    let values = samples.iter().flat_map(|sample| shown.iter().map(|each| each.unit.from_si((each.of)(sample))));
    Table {
        name: "trace",
        title: capitalised(simulation::trace(language)),
        about: simulation::trace_about(language).to_owned(),
        columns: shown.iter().map(heading).collect(),
        rows: Rows::numbered(shown.len(), values),
        derived: Vec::new(),
    }
}

/// Returns the temperatures over days of operation, one row per minute.
#[must_use]
pub fn days(courses: &[PeriodCourse], language: Language) -> Table {
    // The names already contain the unit.
    let of = |name, title, kind, about| column(name, title, kind, None, about, language);
    let columns = vec![
        of("day", simulation::day_number, ColumnContent::Count, simulation::day_number_about),
        of("time_h", terms::time, ColumnContent::Number, simulation::hour_about),
        of("winding_degc", terms::winding, ColumnContent::Number, simulation::winding_mean_about),
        of("winding_peak_degc", simulation::winding_highest, ColumnContent::Number, simulation::winding_highest_about),
        of("housing_degc", terms::housing, ColumnContent::Number, simulation::housing_about),
    ];
    let values = courses.iter().flat_map(|course| {
        course.points.iter().flat_map(|point| {
            let [winding, peak, housing] =
                [point.winding_k, point.winding_peak_k, point.housing_k].map(|kelvin| DEGREE_CELSIUS.from_si(kelvin));
            [f64::from(course.number), HOUR.from_si(point.time_s), winding, peak, housing]
        })
    });
    Table {
        name: "days",
        title: capitalised(simulation::days_table(language)),
        about: simulation::days_table_about(language).to_owned(),
        rows: Rows::numbered(columns.len(), values),
        columns,
        derived: Vec::new(),
    }
}

/// Number of rows of a piece of [`trace_csv`].
const PIECE: usize = 4096;

/// Writes the course of a run as CSV, piece by piece: its whole text takes more memory than the run.
///
/// # Errors
/// Error of the receiver of the pieces.
pub fn trace_csv<E>(
    samples: &[TwinSample],
    signals: &[&Signal],
    language: Language,
    mut take: impl FnMut(&str) -> Result<(), E>,
) -> Result<(), E> {
    for (place, piece) in samples.chunks(PIECE).enumerate() {
        let text = csv(&trace(piece, signals, language));
        // Only the first piece has the heading.
        let rows = if place == 0 { text.as_str() } else { text.split_once("\r\n").map_or("", |(_, rows)| rows) };
        take(rows)?;
    }
    Ok(())
}
