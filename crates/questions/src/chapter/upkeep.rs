//! What is to be done with an actuator, and by when.

use super::{hazards, significant};
use answers::{Chapter, Column, Fact, Planned, Upkeep};
use quantities::Language;
use words::{capitalised, grade_word, signal_word, terminal, upkeep};

/// The upkeep of a code.
#[must_use]
pub fn upkeep(record: &Upkeep, language: Language) -> Chapter {
    let mut chapter = Chapter::new(upkeep::title(&record.code, language));
    let mut head = upkeep::delivered_and_service(&record.delivered, &record.in_service, language);
    if let Some(today) = &record.today {
        head = format!("{head}; {}", upkeep::seen_from(today, language));
    }
    chapter.text(head);
    chapter.section(capitalised(upkeep::plan_head(language)));
    let heads = [upkeep::date_head, upkeep::task_head];
    let mut columns: Vec<Column> = heads.map(|head| Column::text(head(language))).into();
    columns.extend([upkeep::rule_head, upkeep::rests_on].map(|head| Column::wide(head(language))));
    chapter.grid(columns, record.plan.iter().map(|line| planned(line, language)).collect());
    if let Some(battery) = &record.battery {
        let years = |value| significant(Some(value), 3, language);
        chapter.text(terminal::battery(&years(battery.life), &grade_word(*battery.grade, language), language));
        chapter.text(terminal::battery_exchange(
            &years(battery.exchange_recommended),
            &years(battery.exchange_latest),
            language,
        ));
    }
    let erratum = |erratum: &answers::CitedErratum| format!("{}: {}", erratum.id, erratum.evidence);
    chapter.points(record.notes.iter().cloned().chain(record.errata.iter().map(erratum)).collect());
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

fn planned(line: &Planned, language: Language) -> Vec<String> {
    let passed = if line.passed { format!(", {}", upkeep::passed(language)) } else { String::new() };
    let grade = line.grade.map_or_else(|| upkeep::as_stated(language), |grade| grade_word(*grade, language));
    vec![
        line.next.clone(),
        line.title.clone(),
        format!("{}{passed}", line.rule_text),
        format!("{grade}, {}", line.source),
    ]
}
