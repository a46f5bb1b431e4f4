//! How an actuator is mounted.

use super::{NOTHING, hazards, plain, significant, unit_shown};
use answers::{Chapter, Column, Joint, JointCase, Mount, MountValue, Number, Pilot, TableCell};
use provenance::Grade;
use quantities::{Language, format_number};
use words::{capitalised, grade_word, mounting, step_title, terminal, terms, verdict_word};

/// The mounting of a code.
#[must_use]
pub fn mount(record: &Mount, language: Language) -> Chapter {
    let mut chapter = Chapter::new(mounting::title(&record.code, language));
    chapter.section(capitalised(mounting::fits_head(language)));
    fits(&mut chapter, &record.pilots, language);
    chapter.section(capitalised(mounting::dimensions_head(language)));
    values(&mut chapter, record.tolerances.iter().chain(&record.dimensions), language);
    match record.lifting_gear {
        Some(true) => chapter.text(mounting::lifting_gear_needed(language)),
        Some(false) => {}
        None => chapter.text(mounting::lifting_gear_not_known(language)),
    }
    for joint in &record.joints {
        joined(&mut chapter, joint, language);
    }
    chapter.section(capitalised(terms::remarks(language)));
    let erratum = |erratum: &answers::CitedErratum| format!("{}: {}", erratum.id, erratum.evidence);
    chapter.points(record.notes.iter().cloned().chain(record.errata.iter().map(erratum)).collect());
    for facts in record.facts.chunk_by(|one, other| one.step == other.step) {
        let step = facts.first().and_then(|fact| fact.step);
        let title = step.map_or_else(|| mounting::always(language), |step| step_title(*step, language));
        chapter.section(format!("{}: {title}", capitalised(mounting::demands_head(language))));
        chapter.hazards(hazards(facts, language));
    }
    chapter
}

/// A figure of a fit in µm: whole, or with a half.
fn micrometres(value: Number, signed: bool, language: Language) -> String {
    let value = value.0;
    let digits = usize::from((value - value.round()).abs() > 0.01);
    let text = format_number(value, digits, language);
    if signed && value > 0.0 { format!("+{text}") } else { text }
}

fn fits(chapter: &mut Chapter, pilots: &[Pilot], language: Language) {
    let signed = |value: Number| micrometres(value, true, language);
    let unsigned = |value: Number| micrometres(value, false, language);
    let row = |pilot: &Pilot| {
        vec![
            pilot.title.clone(),
            format!("{} {}", plain(Some(pilot.nominal), language), pilot.zone),
            format!("{} / {}", signed(pilot.upper), signed(pilot.lower)),
            pilot.bore.map_or_else(|| mounting::own_deviations(language).to_owned(), str::to_owned),
            format!("{} / {}", signed(pilot.bore_upper), signed(pilot.bore_lower)),
            format!("{} … {}", unsigned(pilot.clearance_min), unsigned(pilot.clearance_max)),
            unsigned(pilot.off_centre_max),
            format!("{} ({})", pilot.fit_text, grade_word(*pilot.grade, language)),
        ]
    };
    let columns = vec![
        Column::text(""),
        Column::text(mounting::pilot(language)),
        Column::text(mounting::deviation_pilot(language)),
        Column::text(mounting::bore(language)),
        Column::text(mounting::deviation_bore(language)),
        Column::text(mounting::clearance_um(language)),
        Column::numbers(mounting::off_centre_um(language)),
        Column::wide(mounting::fit_head(language)),
    ];
    chapter.grid(columns, pilots.iter().map(row).collect());
}

fn values<'v>(chapter: &mut Chapter, values: impl Iterator<Item = &'v MountValue>, language: Language) {
    let row = |each: &MountValue| {
        let shown = match &each.value {
            TableCell::Number(number) => plain(Some(*number), language),
            TableCell::Text(text) => text.clone(),
            _ => mounting::not_printed(language).to_owned(),
        };
        let source = each.source.clone().unwrap_or_else(|| NOTHING.to_owned());
        vec![each.symbol.to_owned(), shown, unit_shown(each.unit), each.name.clone(), source]
    };
    let columns = vec![
        Column::text(terminal::symbol(language)),
        Column::text(terms::value(language)),
        Column::text(terms::unit(language)),
        Column::wide(terminal::name(language)),
        Column::wide(terms::source(language)),
    ];
    chapter.grid(columns, values.map(row).collect());
}

fn joined(chapter: &mut Chapter, joint: &Joint, language: Language) {
    let exact = |value: Option<Number>| plain(value, language);
    let printed = |text: &Option<String>| text.clone().unwrap_or_else(|| NOTHING.to_owned());
    chapter.section(capitalised(&mounting::joint_head(&joint.title, language)));
    let screws = mounting::joint_screws(
        &exact(joint.count),
        &printed(&joint.size),
        &printed(&joint.class),
        &exact(joint.bolt_circle),
        &exact(joint.tightening_torque),
        &exact(joint.transmissible_torque),
        &exact(joint.friction),
        language,
    );
    let source = joint.source.as_ref().map(|source| format!("; {source}")).unwrap_or_default();
    chapter.text(format!("{screws}{source}"));
    let force = joint.clamp_force.map(|force| Number(force.0 / 1000.0));
    let estimated = grade_word(Grade::Estimated, language);
    chapter.text(mounting::joint_clamp(&significant(force, 3, language), &estimated, language));
    let columns = vec![
        Column::text(mounting::load_head(language)),
        Column::numbers(mounting::torque_nm(language)),
        Column::numbers(terms::utilisation_short(language)),
        Column::text(terms::verdict(language)),
        Column::numbers(mounting::tilting_nm(language)),
        Column::numbers(mounting::relieved_percent(language)),
        Column::numbers(mounting::with_moment_percent(language)),
        Column::wide(terms::source(language)),
    ];
    chapter.grid(columns, joint.cases.iter().map(|case| case_row(case, language)).collect());
}

fn case_row(case: &JointCase, language: Language) -> Vec<String> {
    let percent = |value: Option<Number>| significant(value.map(|value| Number(value.0 * 100.0)), 3, language);
    let opens = case.relieved.is_some() && case.utilisation_together.is_none();
    let of_moment_alone = case.torque.is_none() && case.missing.is_none();
    let together = if of_moment_alone && !opens {
        NOTHING.to_owned()
    } else if opens {
        mounting::joint_opens(language).to_owned()
    } else {
        percent(case.utilisation_together)
    };
    // A case without a torque is judged by the moment alone.
    let verdict = if of_moment_alone { case.verdict_together } else { case.verdict };
    let grade = case.grade.map(|grade| grade_word(*grade, language).to_owned());
    let parts = [grade, case.torque_source.clone(), case.moment_source.clone(), case.missing.clone()];
    vec![
        case.title.clone(),
        significant(case.torque, 4, language),
        percent(case.utilisation),
        verdict_word(*verdict, language),
        significant(case.moment, 4, language),
        percent(case.relieved),
        together,
        parts.into_iter().flatten().collect::<Vec<_>>().join("; "),
    ]
}
