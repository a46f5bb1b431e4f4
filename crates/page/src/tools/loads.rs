//! The output bearing under typed loads: a small project, judged like any other.

use super::field::{MARK, ToolField, Trouble, at_their_fields};
use super::scene::{GOOD, Scene, fields_of};
use crate::checks::{check_heads, verdict_class};
use crate::placed::placed;
use axis::AxisProject;
use maud::{Markup, html};
use project::{Edit, edit, key_at, written};
use quantities::Language;
use questions::list::bearing::{bearing_checks, bearing_of_each_size};
use questions::texts::{by_importance, compared_texts, margin_text, percent, unit_text, verdict_text};
use questions::{Candidate, Part, Unread, Verdict, read_all_watched, read_code};
use words::{about_text, capitalised, grade_word, page, short_label, source_text, terminal, terms, title_of_check};

/// Keys of the form. They begin with the values of the axis in work, if it states them.
const KEYS: [&str; 8] = [
    "bearing.radial_force",
    "bearing.radial_distance",
    "bearing.axial_force",
    "bearing.axial_distance",
    SPEED,
    "bearing.load_factor",
    "bearing.operating_condition",
    "requirements.bearing_life_min",
];

/// Constant speed of the output.
const SPEED: &str = "motion[1].speed";

/// Rest of the project: an output that turns at constant speed. Its inertia has no effect on the bearing.
const AROUND: &str = "format = 1\n[axis]\nsingle_move = true\n[load]\ninertia = \"1 kg m^2\"\n[[motion]]\nlaw = \"constant\"\ntime = \"1 s\"\n";

pub(super) fn shown(scene: &Scene<'_>) -> Markup {
    let l = scene.language;
    let mut fields: Vec<ToolField> = KEYS.iter().filter_map(|path| field(path, scene)).collect();
    let text = fields
        .iter()
        .fold(AROUND.to_owned(), |text, field| edit(&text, &field.name, Edit::Value(&field.value)).unwrap_or(text));
    let read = |text: &str| read_all_watched(text, scene.shell.files(), scene.shell.catalogue(), scene.progress);
    let (projects, troubles) = match read(&text) {
        Ok(projects) => (projects, Vec::new()),
        Err(Unread::Faults(found)) => {
            let faults = placed(&found, (&text, &written(&text).unwrap_or_default()), key_at, l);
            let trouble = |(field, fault): (Option<String>, words::Worded)| Trouble {
                field,
                message: fault.message,
                hint: fault.hint,
            };
            let mut troubles: Vec<Trouble> = faults.into_iter().map(trouble).collect();
            if fields.iter().any(|field| field.name == SPEED && field.value.trim().is_empty()) {
                // Without a speed the motion as a whole is faulty.
                troubles.retain(|each| each.field.as_ref().is_some_and(|at| KEYS.contains(&at.as_str())));
                let message = page::speed_of_output_missing(l).to_owned();
                troubles.push(Trouble { field: Some(SPEED.to_owned()), message, hint: None });
            }
            (Vec::new(), troubles)
        }
        Err(Unread::Refused(_)) => (Vec::new(), Vec::new()),
    };
    let loose = at_their_fields(&mut fields, troubles, scene.is_filled);
    let is_old = projects.is_empty();
    let good = if is_old { scene.typed(GOOD).unwrap_or_default() } else { text };
    let projects = if is_old && !good.is_empty() { read(&good).unwrap_or_default() } else { projects };
    let state: Vec<(&str, &str)> = fields.iter().map(|field| (field.name.as_str(), field.value.as_str())).collect();
    html! {
        input type="hidden" name={ (MARK) (GOOD) } value=(good);
        (fields_of(&fields, l))
        @for trouble in &loose { (trouble.shown(l)) }
        div id="tool-answer" aria-live="polite" class=[is_old.then_some("old")] {
            @if let Some(project) = projects.first() {
                @if is_old { p.advice { (page::answer_is_old(l)) } }
                (answer(project, scene))
            }
        }
        (scene.link(&state))
    }
}

fn field(path: &str, scene: &Scene<'_>) -> Option<ToolField> {
    let l = scene.language;
    let key = key_at(path)?;
    let mut field = ToolField::of_key(path, &capitalised(&short_label(about_text(key.about, l))), key, l);
    let of_axis = || if path == SPEED { None } else { scene.of_axis(path) };
    field.value = scene.typed(path).or_else(of_axis).unwrap_or_default();
    Some(field)
}

fn answer(project: &AxisProject, scene: &Scene<'_>) -> Markup {
    let l = scene.language;
    // A cancelled answer is not shown.
    let Ok(sizes) = bearing_of_each_size(project, scene.progress) else { return html! {} };
    let about = read_code(&scene.about, l).ok().map(|reading| reading.parsed.code.into());
    let about = about.and_then(|id| scene.shell.catalogue().product(&id));
    let is_about = |one: &Candidate<'_>| {
        about.is_some_and(|about| (&about.series, &about.frame_size) == (&one.product.series, &one.product.frame_size))
    };
    if sizes.iter().all(|candidate| bearing_checks(candidate).next().is_none()) {
        return html! { p.unchecked { (terms::no_flange_loads(l)) } };
    }
    html! { @for candidate in &sizes { (of_size(candidate, is_about(candidate), l)) } }
}

fn of_size(candidate: &Candidate<'_>, is_open: bool, language: Language) -> Markup {
    let (l, size) = (language, candidate.product.size_name());
    // The first in the order of every answer: failed, then inside the band of an estimate.
    let worst = by_importance(&candidate.judgement.checks)
        .into_iter()
        .filter(|check| check.id.part() == Part::OutputBearing)
        .find(|check| check.verdict == Verdict::Fail || check.is_inside_band());
    let open = bearing_checks(candidate).filter(|check| check.is_open()).count();
    let heads = check_heads(l).into_iter().chain([terms::source(l)]);
    html! {
        details id={ "size-" (size) } open[is_open] {
            summary {
                (capitalised(terminal::size(l))) " " (size) ": "
                @match worst {
                    Some(check) => span class={ (if check.verdict == Verdict::Fail { "fail" } else { "advice" }) } {
                        (if check.verdict == Verdict::Fail { terms::does_not_fit(l) } else { terminal::if_the_estimate_holds(l) }) ", "
                        (title_of_check(check, l)) @if check.utilisation.is_some() { " " (percent(check.utilisation, l)) " %" }
                    },
                    None => span.pass { (terms::fits(l)) },
                }
                @if open > 0 { ", " span.unchecked { (terms::not_checked(l)) ": " (open) } }
            }
            div.wide tabindex="0" { table.checks {
                thead { tr { @for head in heads { th scope="col" { (crate::tip::of_word(head, l)) } } } }
                tbody { @for check in bearing_checks(candidate) { tr class=(verdict_class(check.verdict)) {
                    th scope="row" { (capitalised(&title_of_check(check, l))) }
                    td { span.verdict { (verdict_text(check, l)) } }
                    @for figure in compared_texts(check, l) { td.number { (figure) } }
                    td { (unit_text(check.value, l)) } td.number { (margin_text(check, l)) }
                    td.small {
                        @if let (Some(source), Some(grade)) = (&check.limit_source, check.grade) { (grade_word(grade, l)) ", " (source_text(source, l)) }
                        @if let Some(missing) = check.missing { (page::to_be_checked_state(l)) " " (words::check_missing(missing, l)) }
                    }
                } } }
            } }
        }
    }
}
