//! Results of a recorded run as a chapter.

use super::parts::{grid, significant, unit_shown};
use crate::list::identify::{Identification, LeftOpen};
use answers::{Chapter, Column, Number};
use quantities::Language;
use words::{capitalised, identification, simulation};

/// Returns the estimates beside the values of project and tables, and the lines for the project.
#[must_use]
pub fn identification(record: &Identification, language: Language) -> Chapter {
    let mut chapter = Chapter::new(simulation::identified(&record.axis, &record.samples, language));
    if !record.doubts.is_empty() {
        chapter.section(capitalised(identification::doubts(language)));
        chapter.points(record.doubts.iter().map(|doubt| doubt.text.clone()).collect());
    }
    let number = |value: Option<Number>, digits| significant(value, digits, language);
    if !record.estimates.is_empty() {
        grid(
            &mut chapter,
            &record.estimates,
            &[
                (Column::wide(capitalised(simulation::quantity(language))), &|each| each.title.clone()),
                (Column::numbers(capitalised(words::terms::value(language))), &|each| number(Some(each.value), 4)),
                (Column::numbers(simulation::interval_95(language)), &|each| number(Some(each.half_width), 2)),
                (Column::text(words::terms::unit(language)), &|each| unit_shown(each.unit, language)),
                (Column::numbers(capitalised(simulation::of_the_project(language))), &|each| number(each.stated, 4)),
            ],
        );
    }
    if !record.signals.is_empty() {
        chapter.section(capitalised(identification::signals(language)));
        grid(
            &mut chapter,
            &record.signals,
            &[
                (Column::wide(capitalised(simulation::quantity(language))), &|each| each.title.clone()),
                (Column::numbers(capitalised(words::terms::value(language))), &|each| number(Some(each.value), 3)),
                (Column::numbers(simulation::interval_95(language)), &|each| number(Some(each.half_width), 2)),
                (Column::text(words::terms::unit(language)), &|each| unit_shown(each.unit, language)),
            ],
        );
    }
    if !record.open.is_empty() {
        chapter.section(capitalised(identification::open(language)));
        let point = |open: &LeftOpen| format!("{}: {}", open.title, open.reason);
        chapter.points(record.open.iter().map(point).collect());
    }
    chapter.points(record.notes.clone());
    if !record.overrides.is_empty() {
        chapter.section(capitalised(simulation::lines_for_the_project(language)));
        record.overrides.lines().for_each(|line| chapter.text(line));
    }
    chapter
}
