//! Mounting of an actuator as a chapter.

use super::parts::{NOTHING, grid, hazards, plain, significant, unit_shown};
use answers::{Chapter, CitedErratum, Column, Joint, JointCase, Mount, MountValue, Number, Pilot, TableCell};
use provenance::Grade;
use quantities::{Language, format_number};
use sizing::Verdict;
use words::{
    ERRATUM_MARK, capitalised, erratum_line, grade_word, marked, mounting, row_sign, step_title, terminal, terms,
    typeset, verdict_word,
};

/// Returns the mounting of a code.
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
    let erratum = |erratum: &CitedErratum| {
        let mark = if marks(record).any(|id| *id == erratum.id) { format!("{ERRATUM_MARK} ") } else { String::new() };
        format!("{mark}{}", erratum_line(&erratum.id, language))
    };
    chapter.points(record.notes.iter().cloned().chain(record.errata.iter().map(erratum)).collect());
    for facts in record.facts.chunk_by(|one, other| one.step == other.step) {
        let step = facts.first().and_then(|fact| fact.step);
        let title = step.map_or_else(|| mounting::always(language), |step| step_title(*step, language));
        chapter.section(format!("{}: {title}", capitalised(mounting::demands_head(language))));
        chapter.hazards(hazards(facts, language));
    }
    chapter
}

/// Returns the errata of the values that are shown.
fn marks(record: &Mount) -> impl Iterator<Item = &&'static str> {
    let values = record.tolerances.iter().chain(&record.dimensions).flat_map(|value| &value.errata);
    let joints = record.joints.iter().flat_map(|joint| {
        let of_cases = joint.cases.iter().flat_map(|case| case.torque_errata.iter().chain(&case.moment_errata));
        joint.tightening_errata.iter().chain(&joint.transmissible_errata).chain(of_cases)
    });
    values.chain(joints)
}

/// Formats a figure of a fit in µm: whole, or with a half.
fn micrometres(value: Number, signed: bool, language: Language) -> String {
    let value = value.0;
    let digits = usize::from((value - value.round()).abs() > 0.01);
    let text = format_number(value, digits, language);
    if signed && value > 0.0 { format!("+{text}") } else { text }
}

fn fits(chapter: &mut Chapter, pilots: &[Pilot], language: Language) {
    let signed = |value: Number| micrometres(value, true, language);
    let unsigned = |value: Number| micrometres(value, false, language);
    grid(
        chapter,
        pilots,
        &[
            (Column::text(""), &|pilot| pilot.title.clone()),
            (Column::text(mounting::pilot(language)), &|pilot| {
                format!("{} {}", plain(Some(pilot.nominal), language), pilot.zone)
            }),
            (Column::text(mounting::deviation_pilot(language)), &|pilot| {
                format!("{} / {}", signed(pilot.upper), signed(pilot.lower))
            }),
            (Column::text(mounting::bore(language)), &|pilot| {
                pilot.bore.map_or_else(|| mounting::own_deviations(language).to_owned(), str::to_owned)
            }),
            (Column::text(mounting::deviation_bore(language)), &|pilot| {
                format!("{} / {}", signed(pilot.bore_upper), signed(pilot.bore_lower))
            }),
            (Column::text(mounting::clearance_um(language)), &|pilot| {
                format!("{} … {}", unsigned(pilot.clearance_min), unsigned(pilot.clearance_max))
            }),
            (Column::numbers(mounting::off_centre_um(language)), &|pilot| unsigned(pilot.off_centre_max)),
            (Column::wide(mounting::fit_head(language)), &|pilot| {
                format!("{} ({})", pilot.fit_text, grade_word(*pilot.grade, language))
            }),
        ],
    );
}

fn values<'v>(chapter: &mut Chapter, values: impl Iterator<Item = &'v MountValue>, language: Language) {
    let shown = |each: &MountValue| match &each.value {
        TableCell::Number(number) => marked(plain(Some(*number), language), &each.errata),
        TableCell::Text(text) => marked(typeset(text).into_owned(), &each.errata),
        _ => mounting::not_printed(language).to_owned(),
    };
    grid(
        chapter,
        values,
        &[
            (Column::text(terminal::symbol(language)), &|each| {
                row_sign(each.symbol).unwrap_or_else(|| NOTHING.to_owned())
            }),
            (Column::text(terms::value(language)), &shown),
            (Column::text(terms::unit(language)), &|each| unit_shown(each.unit, language)),
            (Column::wide(terminal::name(language)), &|each| each.name.clone()),
            (Column::wide(terms::source(language)), &|each| each.source.clone().unwrap_or_else(|| NOTHING.to_owned())),
        ],
    );
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
        &marked(exact(joint.tightening_torque), &joint.tightening_errata),
        &marked(exact(joint.transmissible_torque), &joint.transmissible_errata),
        &exact(joint.friction),
        language,
    );
    let source = joint.source.as_ref().map(|source| format!("; {source}")).unwrap_or_default();
    chapter.text(format!("{screws}{source}"));
    let force = joint.clamp_force.map(|force| Number(force.0 / 1000.0));
    let estimated = grade_word(Grade::Estimated, language);
    chapter.text(mounting::joint_clamp(&significant(force, 3, language), &estimated, language));
    let percent = |value: Option<Number>| significant(value.map(|value| Number(value.0 * 100.0)), 3, language);
    let of_moment_alone = |case: &JointCase| case.torque.is_none() && case.missing.is_none();
    let together = |case: &JointCase| {
        if case.relieved.is_some() && case.utilisation_together.is_none() {
            mounting::joint_opens(language).to_owned()
        } else if of_moment_alone(case) {
            NOTHING.to_owned()
        } else {
            percent(case.utilisation_together)
        }
    };
    // A case without a torque is judged by the moment alone, and one whose torque alone holds by both together.
    let verdict = |case: &JointCase| match (*case.verdict, *case.verdict_together) {
        (Verdict::Pass, Verdict::Advice | Verdict::Fail) => case.verdict_together,
        _ if of_moment_alone(case) => case.verdict_together,
        _ => case.verdict,
    };
    let source = |case: &JointCase| {
        let grade = case.grade.map(|grade| grade_word(*grade, language).to_owned());
        let parts = [grade, case.torque_source.clone(), case.moment_source.clone(), case.missing.clone()];
        parts.into_iter().flatten().collect::<Vec<_>>().join("; ")
    };
    grid(
        chapter,
        &joint.cases,
        &[
            (Column::text(mounting::load_head(language)), &|case| case.title.clone()),
            (Column::numbers(mounting::torque_nm(language)), &|case| {
                marked(significant(case.torque, 4, language), &case.torque_errata)
            }),
            (Column::numbers(terms::utilisation_short(language)), &|case| percent(case.utilisation)),
            (Column::text(terms::verdict(language)), &|case| verdict_word(*verdict(case), language)),
            (Column::numbers(mounting::tilting_nm(language)), &|case| {
                marked(significant(case.moment, 4, language), &case.moment_errata)
            }),
            (Column::numbers(mounting::relieved_percent(language)), &|case| percent(case.relieved)),
            (Column::numbers(mounting::with_moment_percent(language)), &together),
            (Column::wide(terms::source(language)), &source),
        ],
    );
}
