//! Maintenance as a record.

use crate::answer::{battery, cited_erratum, facts};
use answers::{Fit, Id, Planned};
use installation::calendar::Interval;
use installation::upkeep::Upkeep;
use quantities::Language;
use words::upkeep::{date_text, plan_note, rule_text, task_title};
use words::{fact_source, fact_text, source_text};

/// Erratum of the chapter on which the plan is based.
const GENERIC_TEXT: &str = "text-9.8-generic";

/// Returns the maintenance plan of an actuator.
#[must_use]
pub fn upkeep(upkeep: &Upkeep, language: Language) -> answers::Upkeep {
    answers::Upkeep {
        code: upkeep.code.to_string(),
        verdict: Fit::of(upkeep.storage_permitted),
        delivered: date_text(upkeep.delivered),
        in_service: date_text(upkeep.in_service),
        today: upkeep.today.map(date_text),
        plan: upkeep.plan.iter().map(|line| planned(line, language)).collect(),
        battery: upkeep.battery.known().map(|life| battery(&life.value)),
        notes: upkeep.notes.iter().map(|note| plan_note(*note, language).to_owned()).collect(),
        storage: facts(&upkeep.storage, language),
        service: facts(&upkeep.service, language),
        shutdown: facts(&upkeep.shutdown, language),
        disposal: facts(&upkeep.disposal, language),
        errata: vec![cited_erratum(GENERIC_TEXT, language)],
        calendar: None,
    }
}

fn planned(line: &installation::upkeep::Planned, language: Language) -> Planned {
    let model = line.model.as_ref().map(|source| source_text(source, language));
    Planned {
        task: Id(line.task),
        title: task_title(line.task, language),
        rule: Id(line.rule),
        rule_text: rule_text(line.rule, line.interval, language),
        interval: line.interval.map(|interval| match interval {
            Interval::Months(months) => format!("P{months}M"),
            Interval::Days(days) => format!("P{days}D"),
        }),
        first: date_text(line.first),
        next: date_text(line.next),
        passed: line.passed,
        fact: line.fact.id,
        text: fact_text(line.fact, language),
        source: model.unwrap_or_else(|| fact_source(line.fact, language)),
        grade: line.grade.map(Id),
    }
}
