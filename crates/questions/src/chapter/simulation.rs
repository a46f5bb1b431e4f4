//! A run of the digital twin as a chapter.

use super::parts::{grid, significant, unit_shown};
use answers::{Chapter, Column, DayOfOperation, Figures, Grade, ModelParameter, Number, Simulation};
use quantities::Language;
use words::{capitalised, grade_word, simulation, verdict_word};

/// Returns the run: figures, verdicts, events, agreement with the sizing, loops, assumptions.
#[must_use]
pub fn simulation(record: &Simulation, language: Language) -> Chapter {
    let number = |value: Option<Number>| significant(value, 4, language);
    let mut chapter = Chapter::new(simulation::title(&record.code, &record.axis, language));
    let [winding, housing] = record.start.map(|start| number(Some(start)));
    let start = if record.start == [record.ambient; 2] {
        simulation::cold(&number(Some(record.ambient)), language)
    } else {
        simulation::warm(&winding, &housing, language)
    };
    let (time, step) = (number(Some(record.time)), number(Some(record.step)));
    let title = capitalised(&record.title);
    chapter.text(simulation::course(&title, &time, &start, &record.steps, &step, language));
    if let Some(instant) = &record.instant {
        chapter.text(instant.title.clone());
    }
    let section = |chapter: &mut Chapter, title: &str| chapter.section(capitalised(title));

    let quantity = capitalised(simulation::quantity(language));
    let value = capitalised(words::terms::value(language));
    let unit = capitalised(words::terms::unit(language));

    section(&mut chapter, simulation::verdicts(language));
    grid(
        &mut chapter,
        &record.verdicts,
        &[
            (Column::wide(&quantity), &|each| each.title.clone()),
            (Column::numbers(&value), &|each| number(each.value)),
            (Column::numbers(capitalised(simulation::limit(language))), &|each| number(each.limit)),
            (Column::text(&unit), &|each| unit_shown(each.unit, language)),
            (Column::text(capitalised(words::terms::verdict(language))), &|each| verdict_word(*each.verdict, language)),
        ],
    );

    section(&mut chapter, simulation::summary(language));
    let figures = |chapter: &mut Chapter, figures: &Figures| {
        grid(
            chapter,
            figures.0.iter().filter(|figure| figure.value.is_some()),
            &[
                (Column::wide(&quantity), &|figure| figure.title.clone()),
                (Column::numbers(&value), &|figure| number(figure.value)),
                (Column::text(&unit), &|figure| unit_shown(figure.unit, language)),
            ],
        );
    };
    figures(&mut chapter, &record.summary);

    if let Some(averaged) = &record.averaged {
        section(&mut chapter, simulation::averaged(language));
        figures(&mut chapter, averaged);
        chapter.text(simulation::averaged_about(language));
        days(&mut chapter, &record.days, language);
    }
    section(&mut chapter, simulation::events(language));
    if record.events.is_empty() {
        chapter.text(simulation::no_events(language));
    }
    grid(
        &mut chapter,
        record.events.iter().take(EVENTS_MOST),
        &[
            (Column::numbers(capitalised(simulation::time_s(language))), &|event| number(Some(event.time))),
            (Column::wide(capitalised(simulation::event(language))), &|event| event.title.clone()),
        ],
    );
    if let Some(failure) = &record.encoder_failure {
        chapter.text(failure.title.clone());
    }
    if !record.comparison.is_empty() {
        section(&mut chapter, simulation::agreement(language));
        grid(
            &mut chapter,
            &record.comparison,
            &[
                (Column::text(&quantity), &|row| row.title.clone()),
                (Column::numbers(capitalised(simulation::sizing_said(language))), &|row| number(Some(row.sizing))),
                (Column::numbers(capitalised(simulation::twin_shows(language))), &|row| number(Some(row.twin))),
                (Column::text(&unit), &|row| unit_shown(row.unit, language)),
                (Column::wide(capitalised(simulation::why(language))), &|row| {
                    reason([row.sizing, row.twin].map(|value| number(Some(value))), &row.why)
                }),
            ],
        );
    }
    section(&mut chapter, simulation::loops(language));
    grid(
        &mut chapter,
        &record.loops,
        &[
            (Column::text(capitalised(simulation::loop_head(language))), &|each| each.title.clone()),
            (Column::numbers(capitalised(simulation::crossover(language))), &|each| number(each.crossover)),
            (Column::numbers(capitalised(simulation::phase_margin(language))), &|each| number(each.phase_margin)),
            (Column::numbers(capitalised(simulation::gain_margin(language))), &|each| number(each.gain_margin)),
            (Column::numbers(capitalised(simulation::bandwidth(language))), &|each| number(each.bandwidth)),
            (Column::text(capitalised(simulation::stability(language))), &|each| {
                let stable = if each.stable { simulation::stable } else { simulation::unstable };
                stable(language).to_owned()
            }),
        ],
    );

    section(&mut chapter, simulation::gains(language));
    figures(&mut chapter, &record.gains);

    section(&mut chapter, simulation::assumed(language));
    let of_the_model =
        |each: &&ModelParameter| each.grade.is_some_and(|grade| matches!(*grade, Grade::Assumed | Grade::Published));
    grid(
        &mut chapter,
        record.parameters.iter().filter(of_the_model),
        &[
            (Column::wide(capitalised(simulation::parameter(language))), &|each| {
                format!("{} (twin.measured.{})", each.title, each.key)
            }),
            (Column::numbers(&value), &|each| number(each.value)),
            (Column::text(&unit), &|each| unit_shown(each.unit, language)),
            (Column::wide(capitalised(simulation::source_head(language))), &|each| {
                let grade = each.grade.map_or("", |grade| grade_word(*grade, language));
                format!("{grade}, {}", each.source.as_deref().unwrap_or_default())
            }),
        ],
    );
    chapter.points(record.notes.clone());
    chapter
}

/// Adds the temperatures over the first and the last day, hour by hour.
fn days(chapter: &mut Chapter, days: &[DayOfOperation], language: Language) {
    let number = |value: Number| significant(Some(value), 4, language);
    for day in days {
        chapter.section(capitalised(&simulation::day_course(&day.day, language)));
        grid(
            chapter,
            &day.hours,
            &[
                (Column::numbers(capitalised(simulation::hour_h(language))), &|hour| hour.hour.to_string()),
                (Column::numbers(capitalised(simulation::winding_mean(language))), &|hour| number(hour.winding)),
                (Column::numbers(capitalised(simulation::winding_in_the_hour(language))), &|hour| {
                    number(hour.winding_peak)
                }),
                (Column::numbers(capitalised(simulation::housing_then(language))), &|hour| number(hour.housing)),
            ],
        );
    }
    if !days.is_empty() {
        chapter.text(simulation::day_course_about(language));
    }
}

/// Largest number of events shown; the record has them all.
const EVENTS_MOST: usize = 40;

/// Returns the reason of a difference between two values as they are shown; none if they do not differ.
fn reason([sizing, twin]: [String; 2], why: &str) -> String {
    if sizing == twin { String::new() } else { why.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_values_need_no_reason() {
        let shown = |value: f64| significant(Some(Number(value)), 4, Language::En);
        assert_eq!(reason([shown(70.381), shown(70.379)], "overshoot"), "");
        assert_eq!(reason([shown(70.38), shown(70.64)], "overshoot"), "overshoot");
    }
}
