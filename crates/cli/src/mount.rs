//! `mount`: how an actuator is mounted.

use crate::answer::{Answer, written};
use crate::code::{parse_for_use, read_argument};
use crate::facts::facts_text;
use crate::fault::{option_fault, simple};
use crate::subject::{axes_of, refuse, refused_together};
use crate::table::{Align, Table, labelled, paragraph};
use clap::ArgMatches;
use std::fmt::Write as _;
use workbench::answers::{Fit, Joint, Mount, MountValue, Number, Pilot, TableCell};
use workbench::quantities::{Unit, format_number, format_significant};
use workbench::text::{grade_word, mounting, step_title, terminal, terms, verdict_word};
use workbench::{Language, MountAsked, OrderCode};

/// `antrieb mount CODE`
pub(crate) fn mount(matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    let mut faults: Vec<Answer> = Vec::new();
    let code = parse_for_use(&read_argument(matches), as_json, language).map_err(|fault| faults.push(fault));
    let mut bore = |option: &str| {
        let text = matches.get_one::<String>(option)?;
        workbench::read_bore(text, language)
            .map_err(|fault| faults.push(option_fault(option, fault, as_json, language)))
            .ok()
    };
    let (both, load, housing) = (bore("bore"), bore("bore-load"), bore("bore-housing"));
    let asked = MountAsked { bore_load: load.or(both), bore_housing: housing.or(both), ..MountAsked::default() };
    let Ok((reading, talk)) = code else { return refused_together(faults, as_json) };
    if !faults.is_empty() {
        return refused_together(faults, as_json);
    }
    let code = reading.parsed.code;
    let found = match loaded(matches, &code, asked, as_json, language) {
        Ok(found) => found,
        Err(fault) => return fault,
    };
    let (asked, axis) = found;
    let Some(found) = workbench::mount(&code, &asked) else {
        return refuse(&workbench::Refusal::NoData, as_json, language);
    };
    let record = workbench::answer::mount(&found, &asked, axis.as_deref(), language);
    let data = if as_json { written(&record) } else { text(&record, language) };
    Answer { talk, ..Answer::data(data) }.fits(record.verdict == Fit::Fits)
}

/// The question with the loads of a project, where one is named, and the name of its axis.
fn loaded(
    matches: &ArgMatches,
    code: &OrderCode,
    asked: MountAsked,
    as_json: bool,
    language: Language,
) -> Result<(MountAsked, Option<String>), Answer> {
    if !matches.contains_id("project") {
        return Ok((asked, None));
    }
    let projects = axes_of(matches, as_json, language)?;
    let [project] = projects.as_slice() else {
        let names: Vec<&str> = projects.iter().map(|project| project.name.as_str()).collect();
        return Err(simple(&terminal::several_axes(&names.join(", "), language), as_json, language));
    };
    let axis = workbench::joint_loads(project, code).map_err(|refusal| refuse(&refusal, as_json, language))?;
    Ok((MountAsked { axis, ..asked }, Some(project.name.clone())))
}

fn text(mount: &Mount, language: Language) -> String {
    let mut out = format!("{}\n\n{}\n", mount.code, mounting::fits_head(language));
    out.push_str(&fits(&mount.pilots, language));
    let _ = writeln!(out, "\n{}", mounting::dimensions_head(language));
    out.push_str(&values(mount.tolerances.iter().chain(&mount.dimensions), language));
    match mount.lifting_gear {
        Some(true) => out.push_str(&paragraph("", mounting::lifting_gear_needed(language))),
        Some(false) => {}
        None => out.push_str(&paragraph("", mounting::lifting_gear_not_known(language))),
    }
    for joint in &mount.joints {
        joint_text(&mut out, joint, language);
    }
    out.push('\n');
    for note in &mount.notes {
        out.push_str(&labelled(terminal::note(language), note));
    }
    let _ = writeln!(out, "\n{}", mounting::demands_head(language));
    let same = |one: &workbench::answers::Fact, other: &workbench::answers::Fact| one.step == other.step;
    for facts in mount.facts.chunk_by(same) {
        let step = facts.first().and_then(|fact| fact.step);
        let _ =
            writeln!(out, "{}", step.map_or_else(|| mounting::always(language), |step| step_title(*step, language)));
        out.push_str(&facts_text(facts, language));
    }
    let _ = writeln!(out, "\n{}", mounting::errata_head(language));
    for erratum in &mount.errata {
        out.push_str(&paragraph(&format!("* {}: ", erratum.id), &erratum.evidence));
    }
    out
}

/// A number as the print has it: no more digits than it needs.
fn plain(value: Number, language: Language) -> String {
    let text = value.written().map_or_else(|| "–".to_owned(), |value| value.to_string());
    text.replace('.', &language.decimal_mark().to_string())
}

/// A figure of a fit in µm: whole, or with a half.
fn micrometres(value: Number, signed: bool, language: Language) -> String {
    let value = value.0;
    let digits = usize::from((value - value.round()).abs() > 0.01);
    let text = format_number(value, digits, language);
    if signed && value > 0.0 { format!("+{text}") } else { text }
}

fn fits(pilots: &[Pilot], language: Language) -> String {
    let left = |head: &'static str| (head, Align::Left);
    let mut table = Table::new([
        left(""),
        left(mounting::pilot(language)),
        left(mounting::deviation_pilot(language)),
        left(mounting::bore(language)),
        left(mounting::deviation_bore(language)),
        left(mounting::clearance_um(language)),
        (mounting::off_centre_um(language), Align::Right),
        left(mounting::fit_head(language)),
    ]);
    let signed = |value: Number| micrometres(value, true, language);
    let unsigned = |value: Number| micrometres(value, false, language);
    for pilot in pilots {
        table.row([
            pilot.title.clone(),
            format!("{} {}", plain(pilot.nominal, language), pilot.zone),
            format!("{} / {}", signed(pilot.upper), signed(pilot.lower)),
            pilot.bore.map_or_else(|| mounting::own_deviations(language).to_owned(), str::to_owned),
            format!("{} / {}", signed(pilot.bore_upper), signed(pilot.bore_lower)),
            format!("{} … {}", unsigned(pilot.clearance_min), unsigned(pilot.clearance_max)),
            unsigned(pilot.off_centre_max),
            format!("{} ({})", pilot.fit_text, grade_word(*pilot.grade, language)),
        ]);
    }
    table.render()
}

fn values<'v>(values: impl Iterator<Item = &'v MountValue>, language: Language) -> String {
    let heads = [terminal::symbol(language), terms::value(language), terms::unit(language), terminal::name(language)];
    let [symbol, value, unit, name] = heads.map(|head| (head, Align::Left));
    let mut table = Table::new([symbol, value, unit, name, (terms::source(language), Align::Left)]);
    for each in values {
        let shown = match &each.value {
            TableCell::Number(number) => plain(*number, language),
            TableCell::Text(text) => text.clone(),
            _ => mounting::not_printed(language).to_owned(),
        };
        let unit = Unit::of(each.unit).map_or(each.unit, |unit| unit.symbol);
        let source = each.source.clone().unwrap_or_else(|| "–".to_owned());
        table.row([each.symbol.to_owned(), shown, unit.to_owned(), each.name.clone(), source]);
    }
    table.render()
}

fn joint_text(out: &mut String, joint: &Joint, language: Language) {
    let number = |value: Option<Number>, digits: usize| {
        value.map_or_else(|| "–".to_owned(), |value| format_significant(value.0, digits, language))
    };
    let percent = |value: Option<Number>| number(value.map(|value| Number(value.0 * 100.0)), 3);
    let exact = |value: Option<Number>| value.map_or_else(|| "–".to_owned(), |value| plain(value, language));
    let printed = |text: &Option<String>| text.clone().unwrap_or_else(|| "–".to_owned());
    let _ = writeln!(out, "\n{}", mounting::joint_head(&joint.title, language));
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
    out.push_str(&paragraph("", &format!("{screws}{source}")));
    let force = joint.clamp_force.map(|force| Number(force.0 / 1000.0));
    let estimated = grade_word(workbench::Grade::Estimated, language);
    out.push_str(&paragraph("", &mounting::joint_clamp(&number(force, 3), &estimated, language)));
    let right = |head: &'static str| (head, Align::Right);
    let mut table = Table::new([
        (mounting::load_head(language), Align::Left),
        right(mounting::torque_nm(language)),
        right(terms::utilisation_short(language)),
        (terms::verdict(language), Align::Left),
        right(mounting::tilting_nm(language)),
        right(mounting::relieved_percent(language)),
        right(mounting::with_moment_percent(language)),
        (terms::source(language), Align::Left),
    ]);
    for case in &joint.cases {
        let opens = case.relieved.is_some() && case.utilisation_together.is_none();
        let of_moment_alone = case.torque.is_none() && case.missing.is_none();
        let together = if of_moment_alone && !opens {
            "–".to_owned()
        } else if opens {
            mounting::joint_opens(language).to_owned()
        } else {
            percent(case.utilisation_together)
        };
        // A case without a torque is judged by the moment alone.
        let verdict = if of_moment_alone { case.verdict_together } else { case.verdict };
        let grade = case.grade.map(|grade| grade_word(*grade, language).to_owned());
        let parts = [grade, case.torque_source.clone(), case.moment_source.clone(), case.missing.clone()];
        table.row([
            case.title.clone(),
            number(case.torque, 4),
            percent(case.utilisation),
            verdict_word(*verdict, language),
            number(case.moment, 4),
            percent(case.relieved),
            together,
            parts.into_iter().flatten().collect::<Vec<_>>().join("; "),
        ]);
    }
    out.push_str(&table.render());
}
