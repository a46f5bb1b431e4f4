//! What a recorded run says, laid out.

use super::{grid, significant, unit_shown};
use crate::list::identify::Identification;
use answers::{Chapter, Column, Number};
use quantities::Language;
use words::{capitalised, simulation};

/// The estimates beside what project and tables say, and the lines for the project.
#[must_use]
pub fn identification(record: &Identification, language: Language) -> Chapter {
    let mut chapter = Chapter::new(simulation::identified(&record.axis, &record.samples, language));
    let number = |value: Option<Number>, digits| significant(value, digits, language);
    grid(
        &mut chapter,
        &record.estimates,
        &[
            (Column::wide(capitalised(simulation::quantity(language))), &|each| each.title.clone()),
            (Column::numbers(capitalised(words::terms::value(language))), &|each| number(Some(each.value), 4)),
            (Column::numbers(simulation::interval_95(language)), &|each| number(Some(each.half_width), 2)),
            (Column::text(words::terms::unit(language)), &|each| unit_shown(each.unit)),
            (Column::numbers(capitalised(simulation::of_the_project(language))), &|each| number(each.stated, 4)),
        ],
    );
    chapter.points(record.notes.clone());
    chapter.section(capitalised(simulation::lines_for_the_project(language)));
    record.overrides.lines().for_each(|line| chapter.text(line));
    chapter
}
