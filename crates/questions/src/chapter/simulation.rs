//! A run of the digital twin, laid out.

use super::{significant, unit_shown};
use answers::{Chapter, Column, Figure, Grade, Number, Simulation};
use quantities::Language;
use words::{capitalised, grade_word, simulation, verdict_word};

/// The run: figures, verdicts, events, agreement with the sizing, loops, what is assumed.
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
    let section = |chapter: &mut Chapter, title: &str| chapter.section(capitalised(title));

    section(&mut chapter, simulation::verdicts(language));
    let heads = vec![
        Column::wide(capitalised(simulation::quantity(language))),
        Column::numbers(capitalised(words::terms::value(language))),
        Column::numbers(capitalised(simulation::limit(language))),
        Column::text(words::terms::unit(language)),
        Column::text(""),
    ];
    let rows = record.verdicts.iter().map(|each| {
        vec![
            each.title.clone(),
            number(each.value),
            number(each.limit),
            unit_shown(each.unit),
            verdict_word(*each.verdict, language).to_owned(),
        ]
    });
    chapter.grid(heads, rows.collect());

    section(&mut chapter, simulation::summary(language));
    let heads = vec![
        Column::wide(capitalised(simulation::quantity(language))),
        Column::numbers(capitalised(words::terms::value(language))),
        Column::text(words::terms::unit(language)),
    ];
    let figures = |figures: &[Figure]| -> Vec<Vec<String>> {
        let known = figures.iter().filter(|figure| figure.value.is_some());
        known.map(|figure| vec![figure.title.clone(), number(figure.value), unit_shown(figure.unit)]).collect()
    };
    chapter.grid(heads.clone(), figures(&record.summary.0));

    if let Some(averaged) = &record.averaged {
        section(&mut chapter, simulation::averaged(language));
        chapter.grid(heads.clone(), figures(&averaged.0));
        chapter.text(simulation::averaged_about(language).to_owned());
    }
    section(&mut chapter, simulation::events(language));
    if record.events.is_empty() {
        chapter.text(simulation::no_events(language).to_owned());
    } else {
        let heads = vec![
            Column::numbers(capitalised(simulation::time_s(language))),
            Column::wide(capitalised(simulation::event(language))),
        ];
        let shown = record.events.iter().take(EVENTS_MOST);
        chapter.grid(heads, shown.map(|event| vec![number(Some(event.time)), event.title.clone()]).collect());
    }
    if let Some(failure) = &record.encoder_failure {
        chapter.text(failure.title.clone());
    }
    if !record.comparison.is_empty() {
        section(&mut chapter, simulation::agreement(language));
        let heads = vec![
            Column::text(capitalised(simulation::quantity(language))),
            Column::numbers(capitalised(simulation::sizing_said(language))),
            Column::numbers(capitalised(simulation::twin_shows(language))),
            Column::text(words::terms::unit(language)),
            Column::wide(capitalised(simulation::why(language))),
        ];
        let rows = record.comparison.iter().map(|row| {
            vec![
                row.title.clone(),
                number(Some(row.sizing)),
                number(Some(row.twin)),
                unit_shown(row.unit),
                row.why.clone(),
            ]
        });
        chapter.grid(heads, rows.collect());
    }
    section(&mut chapter, simulation::loops(language));
    let words: [fn(Language) -> &'static str; 4] =
        [simulation::crossover, simulation::phase_margin, simulation::gain_margin, simulation::bandwidth];
    let mut columns = vec![Column::text(capitalised(simulation::loop_head(language)))];
    columns.extend(words.map(|word| Column::numbers(capitalised(word(language)))));
    columns.push(Column::text(""));
    let rows = record.loops.iter().map(|each| {
        let stable = if each.stable { simulation::stable } else { simulation::unstable };
        vec![
            each.title.clone(),
            number(each.crossover),
            number(each.phase_margin),
            number(each.gain_margin),
            number(each.bandwidth),
            stable(language).to_owned(),
        ]
    });
    chapter.grid(columns, rows.collect());

    section(&mut chapter, simulation::gains(language));
    chapter.grid(heads, figures(&record.gains.0));

    section(&mut chapter, simulation::assumed(language));
    let heads = vec![
        Column::text(capitalised(simulation::parameter(language))),
        Column::numbers(capitalised(words::terms::value(language))),
        Column::text(words::terms::unit(language)),
        Column::wide(capitalised(simulation::source_head(language))),
    ];
    let of_the_model = record
        .parameters
        .iter()
        .filter(|each| each.grade.is_some_and(|grade| matches!(*grade, Grade::Assumed | Grade::Published)));
    let rows = of_the_model.map(|each| {
        let grade = each.grade.map_or_else(String::new, |grade| grade_word(*grade, language).to_string());
        let source = each.source.clone().unwrap_or_default();
        vec![each.key.to_owned(), number(each.value), unit_shown(each.unit), format!("{grade}, {source}")]
    });
    chapter.grid(heads, rows.collect());
    chapter.points(record.notes.clone());
    chapter
}

/// So many events are shown; the record has them all.
const EVENTS_MOST: usize = 40;
