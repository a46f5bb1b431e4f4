//! Maintenance of an actuator: tasks and dates.

use super::parts::{grid, hazards, remarks, significant};
use answers::{Chapter, Column, Fact, Upkeep};
use quantities::Language;
use words::{capitalised, grade_word, signal_word, terminal, upkeep};

/// Returns the maintenance of a code.
#[must_use]
pub fn upkeep(record: &Upkeep, language: Language) -> Chapter {
    let mut chapter = Chapter::new(upkeep::title(&record.code, language));
    let shown = |day: &str| upkeep::date_shown(day, language);
    let mut head = upkeep::delivered_and_service(&shown(&record.delivered), &shown(&record.in_service), language);
    if let Some(today) = &record.today {
        head = format!("{head}; {}", upkeep::seen_from(&shown(today), language));
    }
    chapter.text(head);
    chapter.section(capitalised(upkeep::plan_head(language)));
    grid(
        &mut chapter,
        &record.plan,
        &[
            (Column::text(upkeep::date_head(language)), &|line| shown(&line.next)),
            (Column::text(upkeep::task_head(language)), &|line| line.title.clone()),
            (Column::wide(upkeep::rule_head(language)), &|line| {
                let passed = if line.passed { format!(", {}", upkeep::passed(language)) } else { String::new() };
                format!("{}{passed}", line.rule_text)
            }),
            (Column::wide(upkeep::rests_on(language)), &|line| {
                let stated = || upkeep::as_stated(language);
                format!("{}, {}", line.grade.map_or_else(stated, |grade| grade_word(*grade, language)), line.source)
            }),
        ],
    );
    if let Some(battery) = &record.battery {
        let years = |value| significant(Some(value), 3, language);
        chapter.text(terminal::battery(&years(battery.life), &grade_word(*battery.grade, language), language));
        chapter.text(terminal::battery_exchange(
            &years(battery.exchange_recommended),
            &years(battery.exchange_latest),
            language,
        ));
    }
    chapter.points(remarks(&record.notes, &record.errata, language));
    chapter.section(capitalised(upkeep::storage_head(language)));
    chapter.hazards(hazards(&record.storage, language));
    chapter.section(capitalised(upkeep::service_head(language)));
    chapter.hazards(hazards(&record.service, language));
    chapter.section(capitalised(upkeep::shutdown_head(language)));
    let step = |fact: &Fact| {
        let word = fact.signal.map(|signal| format!("{}: ", signal_word(*signal, language)));
        format!("{}{} ({})", word.unwrap_or_default(), fact.text, fact.source)
    };
    chapter.steps(record.shutdown.iter().map(step).collect());
    chapter.section(capitalised(upkeep::disposal_head(language)));
    chapter.hazards(hazards(&record.disposal, language));
    chapter
}
