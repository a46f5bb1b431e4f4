//! What a recorded run says, laid out.

use super::{significant, unit_shown};
use crate::list::identify::Identification;
use answers::{Chapter, Column};
use quantities::Language;
use words::{capitalised, simulation};

/// The estimates beside what project and tables say, and the lines for the project.
#[must_use]
pub fn identification(record: &Identification, language: Language) -> Chapter {
    let mut chapter = Chapter::new(simulation::identified(&record.axis, &record.samples, language));
    let columns = vec![
        Column::wide(capitalised(simulation::quantity(language))),
        Column::numbers(capitalised(words::terms::value(language))),
        Column::numbers(simulation::interval_95(language)),
        Column::text(words::terms::unit(language)),
        Column::numbers(capitalised(simulation::of_the_project(language))),
    ];
    let rows = record.estimates.iter().map(|each| {
        vec![
            each.title.clone(),
            significant(Some(each.value), 4, language),
            significant(Some(each.half_width), 2, language),
            unit_shown(each.unit),
            significant(each.stated, 4, language),
        ]
    });
    chapter.grid(columns, rows.collect());
    chapter.points(record.notes.clone());
    chapter.section(capitalised(simulation::lines_for_the_project(language)));
    record.overrides.lines().for_each(|line| chapter.text(line.to_owned()));
    chapter
}
