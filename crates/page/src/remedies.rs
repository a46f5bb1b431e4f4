//! Changes with which an actuator fits where none does, as cards that apply them.

use crate::call::{Call, Shell};
use crate::markup::{label_of, vals};
use crate::shown::looked_at_alone;
use crate::state::{PageState, ReadProject};
use crate::text_change::TextChange;
use axis::AxisProject;
use maud::{Markup, html};
use project::{SegmentLaw, Written, edit_values, paced, written};
use quantities::unit::SECOND;
use quantities::{Language, Measure, Unit, format_significant};
use questions::list::check::{reserve_unasked, reserve_within};
use questions::list::size::{
    AxisChange, CatalogueReach, GearingProposal, LawProposal, Proposals, Reach, SharedLoad, catalogue_reserve,
    shared_load, sized,
};
use questions::texts::{reason, standing_text};
use questions::{Progress, Rejected, read_all_watched};
use words::{capitalised, law_text, page, proviso_text, terminal, terms, unpadded, views};

/// Number of cards above the fold.
const FIRST: usize = 3;

/// Largest factor on a value of the machine that is proposed above the fold; a fortieth of the load is another machine.
const FACTOR_MOST: f64 = 4.0;

/// Number of actuators whose changes are searched in a long cycle.
const NEAREST: usize = 6;

/// Parts of an ordering code that decide about speed and torque: series, size and ratio.
const KIND_PARTS: usize = 3;

/// Field of a request that searches a load however long its cycle is.
const THOROUGH: &str = "thorough";

/// Key of the name of an axis.
const NAME: &str = "axis.name";

/// A change with which an actuator fits.
struct Remedy {
    title: String,
    before: String,
    after: String,
    /// Actuator that would fit.
    code: String,
    /// Condition of the verdict.
    proviso: Option<&'static str>,
    /// Extent of the change, where its title does not say it.
    extent: Option<String>,
    /// Factor on a value of the machine, or its reciprocal: at least 1.
    factor: f64,
    /// Verdict of the axis after the change; `None` if it was not judged.
    verdict: Option<String>,
    /// The change of the project; `None` if it is up to the user how.
    change: Option<TextChange>,
}

/// Returns the place of the cards in the right pane; they are requested after the page is shown, because they need
/// several judgements of the catalogue. `version` identifies the text that they belong to.
pub(crate) fn place(version: &str, language: Language) -> Markup {
    html! {
        section.remedies id={ "remedies-" (version) } aria-label=(page::what_would_fit(language)) aria-live="polite" hx-morph-skip=""
            hx-post="/would-fit" hx-trigger="load" hx-target="this" hx-swap="innerHTML" {
            p.small { (page::searching_remedies(language)) }
        }
    }
}

/// Returns the cards; without one, what was searched and how far the nearest actuator is from fitting.
pub(crate) fn cards(call: &Call<'_>, shell: &dyn Shell, progress: &Progress) -> Markup {
    let mut state = PageState::of(call);
    let l = state.language;
    let held = state.hold(shell, progress);
    let Some(project) = held.projects.get(state.axis) else { return html! {} };
    let Some(nearest) = looked_at_alone(&state, project, progress) else { return html! {} };
    let ((reached, unsought), is_whole) = match catalogue_reserve(project, progress) {
        Ok(Some(reached)) => ((reached, None), true),
        // A cycle too long for a search in the whole catalogue: the actuators with the smallest excess.
        Ok(None) => (of_nearest(project, call.field(THOROUGH).is_some(), progress), false),
        Err(_) => ((Vec::new(), None), false),
    };
    let Proposals { gearings, law } = Proposals::of(project, progress).unwrap_or_default();
    let reads = |text: &str| {
        let axes = read_all_watched(text, shell.files(), shell.catalogue(), progress).ok()?;
        axes.into_iter().nth(state.axis)
    };
    // Actuator and verdict of the axis after a change, as the page shows them then.
    let verdict = |text: &str| {
        let changed = reads(text)?;
        let sizing = sized(&changed, 1, Rejected::Nearest, progress).ok()?;
        let best = sizing.named().filter(|best| best.fits())?;
        Some((best.id.to_string(), standing_text(best, l)))
    };
    let mut found = by_reserve(project, &reached, (&state.text, &state.prefix), &reads, l);
    found.extend(law.map(|proposal| by_law(proposal, l)));
    found.extend(gearings.iter().map(|proposal| by_gearing(proposal, &held, &state.prefix, l)));
    found.extend(
        shared_load(project, progress).ok().flatten().map(|shared| by_sharing(&shared, &held, &state.prefix, l)),
    );
    // A change that the file does not take, or after which it is judged otherwise, is left to the user.
    for remedy in &mut found {
        let Some(change) = &remedy.change else { continue };
        match change.applied(&state.text, &state.prefix).and_then(|text| verdict(&text)) {
            Some((code, standing)) => (remedy.code, remedy.verdict) = (code, Some(standing)),
            None => remedy.change = None,
        }
    }
    // What a button applies comes before what it does not, and the smaller change first.
    found.sort_by(|a, b| {
        let order = |remedy: &Remedy| (remedy.factor > FACTOR_MOST, remedy.change.is_none());
        order(a).cmp(&order(b)).then(a.factor.total_cmp(&b.factor))
    });
    // The first change that a button applies is the main action of the page, unless it makes another machine of it.
    let main = found.iter().position(|remedy| remedy.change.is_some() && remedy.factor <= FACTOR_MOST);
    let usual = found.iter().filter(|remedy| remedy.factor <= FACTOR_MOST).count();
    let (first, rest) = found.split_at(if usual == 0 { found.len().min(1) } else { usual.min(FIRST) });
    html! {
        @if first.is_empty() {
            h3 { (capitalised(terminal::no_actuator_fits(l))) }
            p { @if is_whole { (page::no_remedy_found(l)) } @else { (page::no_remedy_yet(&NEAREST, l)) } }
            p { (capitalised(terminal::nearest_miss(l))) ": " strong.code { (nearest.id) } ", " (reason(&nearest, l)) }
        } @else {
            h3 { (page::what_would_fit(l)) }
            div.remedy-cards { @for (place, remedy) in first.iter().enumerate() { (card(remedy, &state.prefix, main == Some(place), l)) } }
            @if !rest.is_empty() {
                details id="more-remedies" { summary { (page::more_remedies(&rest.len(), l)) } div.remedy-cards { @for remedy in rest { (card(remedy, &state.prefix, false, l)) } } }
            }
            p.small { (page::remedies_about(l)) }
        }
        @if let Some(samples) = unsought {
            p.small id="not-sought" { (views::load_not_sought(&samples, l))
                // Without a time limit a search of any length would not end.
                @if progress.is_limited() { " " button.small type="button" hx-post="/would-fit" hx-vals=(vals(&[(THOROUGH, "true")])) hx-target="closest .remedies" hx-swap="innerHTML" { (views::seek_load(l)) } }
            }
        }
    }
}

fn card(remedy: &Remedy, prefix: &str, is_main: bool, language: Language) -> Markup {
    let l = language;
    html! {
        article.remedy {
            h4 { (remedy.title) }
            p { @if !remedy.before.is_empty() { s { (remedy.before) } " → " } strong { (remedy.after) } }
            @if let Some(extent) = &remedy.extent { p.small { (extent) } }
            p.small { span.code { (remedy.code) } ": " @match (&remedy.verdict, remedy.proviso) { (Some(verdict), _) => { (verdict) }, (None, Some(proviso)) => { (page::fits_with_proviso(&proviso, l)) }, (None, None) => { (terms::fits(l)) } } }
            @match &remedy.change {
                Some(change) => button class=[is_main.then_some("primary")] type="button" hx-post="/work" hx-vals=(change.fields(prefix)) { (page::apply(l)) },
                None => p.small { (page::by_your_own_change(l)) },
            }
        }
    }
}

/// Returns the smallest changes of cycle time and load with which one of the nearest actuators fits, and the number of instants
/// of each trial if the load was not searched because of them.
///
/// The nearest one alone is not enough: where its ratio makes it too slow, no load helps, and that of another one does.
fn of_nearest(project: &AxisProject, is_thorough: bool, progress: &Progress) -> (Vec<CatalogueReach>, Option<usize>) {
    let reserve = if is_thorough { reserve_within } else { reserve_unasked };
    let mut found: Vec<CatalogueReach> = Vec::new();
    let mut unsought = None;
    let Ok(sizing) = sized(project, 0, Rejected::All, progress) else { return (found, unsought) };
    let mut tried: Vec<String> = Vec::new();
    for candidate in &sizing.candidates {
        let code = candidate.id.to_string();
        let kind = code.splitn(KIND_PARTS + 1, '-').take(KIND_PARTS).collect::<Vec<_>>().join("-");
        // Where a requirement is not met, no change of load or motion makes the actuator fit.
        if !candidate.objections.is_empty() || tried.contains(&kind) {
            continue;
        }
        if tried.len() >= NEAREST {
            break;
        }
        tried.push(kind);
        let reserve = reserve(project, candidate, progress).unwrap_or_default();
        unsought = unsought.or(reserve.unsought.map(|unsought| unsought.samples));
        let cycle_time =
            reserve.cycle_time.map(|reach| Reach { value: reach.value.si(), fit: reach.fit, proviso: reach.proviso });
        for (change, reach) in [
            (AxisChange::CycleTime, cycle_time),
            (AxisChange::Payload, reserve.payload_factor),
            (AxisChange::Load, reserve.load_factor),
        ] {
            let Some(Reach { value, fit, proviso }) = reach else { continue };
            let made = CatalogueReach { change, value, code: code.clone(), fit, proviso };
            let is_smaller = |known: &CatalogueReach| {
                if change == AxisChange::CycleTime { value < known.value } else { value > known.value }
            };
            match found.iter_mut().find(|known| known.change == change) {
                Some(known) if is_smaller(known) => *known = made,
                Some(_) => {}
                None => found.push(made),
            }
        }
    }
    let has_load = found.iter().any(|reach| reach.change == AxisChange::Load);
    (found, unsought.filter(|_| !has_load))
}

/// Returns changes of cycle time and load as cards.
fn by_reserve(
    project: &AxisProject,
    reached: &[CatalogueReach],
    (text, prefix): (&str, &str),
    reads: &dyn Fn(&str) -> Option<AxisProject>,
    language: Language,
) -> Vec<Remedy> {
    let l = language;
    let number = |value: f64| format_significant(value, 4, l);
    let card = |reach: &CatalogueReach| {
        let proviso = proviso_text(reach.proviso.estimate, reach.proviso.rating, l);
        let plain = Remedy {
            title: String::new(),
            before: String::new(),
            after: String::new(),
            code: reach.code.clone(),
            proviso,
            extent: None,
            factor: folded(reach.value),
            verdict: None,
            change: None,
        };
        match reach.change {
            AxisChange::Payload => Remedy {
                title: page::smaller_payload(l).to_owned(),
                after: terminal::payload_factor(&number(reach.value), l),
                change: Some(TextChange::Load([1.0, reach.value])),
                ..plain
            },
            AxisChange::Load => Remedy {
                title: page::smaller_load(l).to_owned(),
                after: terminal::load_factor(&number(reach.value), l),
                change: Some(TextChange::Load([reach.value; 2])),
                ..plain
            },
            AxisChange::CycleTime => {
                let duration = project.axis.motion.duration();
                let seconds = |si: f64| format!("{} {}", number(si), SECOND.symbol_in(l));
                // The times of the file keep few digits, and the card says what they give.
                let factor = rounded_up(reach.value / duration.si());
                let reached = duration.si() * factor;
                let is_reached =
                    |project: &AxisProject| (project.axis.motion.duration().si() / reached - 1.0).abs() < 1e-6;
                let change = slower(project, (text, prefix), factor).filter(|change| {
                    let changed = change.applied(text, prefix).and_then(|text| reads(&text));
                    changed.is_some_and(|project| is_reached(&project))
                });
                Remedy {
                    title: page::longer_cycle(l).to_owned(),
                    before: seconds(duration.si()),
                    after: seconds(reached),
                    extent: Some(page::every_time_longer(&number(factor), l)),
                    factor: folded(factor),
                    change,
                    ..plain
                }
            }
        }
    };
    reached.iter().map(card).collect()
}

/// Returns a factor or its reciprocal, whichever is larger.
fn folded(factor: f64) -> f64 {
    factor.max(1.0 / factor)
}

/// Returns a factor with four significant digits that is not smaller.
fn rounded_up(factor: f64) -> f64 {
    let place = 10_f64.powf(3.0 - factor.log10().floor());
    // A factor of four digits stays in spite of its rounding error.
    (factor * place - 1e-6).ceil() / place
}

/// Returns the change with which the whole motion is slower by a factor. Where times of it are assumed, as the ramps of a
/// web, the change states them.
fn slower(project: &AxisProject, (text, prefix): (&str, &str), factor: f64) -> Option<TextChange> {
    if paced(text, prefix, factor).is_some() {
        return Some(TextChange::Pace(factor));
    }
    let motion = format!("{prefix}motion[");
    let assumed = project.assumed().into_iter().filter(|each| each.is_alone);
    let of_motion = assumed.flat_map(|each| {
        let value = each.value;
        each.keys.into_iter().filter_map(move |key| Some((key, value.clone()?)))
    });
    let taken: Vec<(String, String)> = of_motion.filter(|(key, _)| key.starts_with(&motion)).collect();
    let with_taken = edit_values(text, &taken).ok()?;
    let changed = written(&paced(&with_taken, prefix, factor)?)?;
    let before = written(text)?;
    let is_new = |key: &Written| !before.iter().any(|old| old.path == key.path && old.value == key.value);
    let values = changed.into_iter().filter(is_new).filter_map(|key| Some((key.path, key.value?)));
    Some(TextChange::Values(values.collect()))
}

/// Returns a number as a project file states it, without the noise of its conversion: a proposal has five digits at most.
fn rounded(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}

/// Returns the division of the load among several actuators as a card. It states the share of one actuator, and says so in
/// the name of the axis.
fn by_sharing(shared: &SharedLoad, held: &ReadProject, prefix: &str, language: Language) -> Remedy {
    let l = language;
    let named = held.written.iter().find(|key| key.path == format!("{prefix}{NAME}")).and_then(|key| key.value.clone());
    let name = page::one_of_several(&named.unwrap_or_default(), &shared.actuators, l);
    let shares = shared.shares.iter().map(|share| {
        let value = format!("{} {}", rounded(share.unit.from_si(share.si)), share.unit.ascii);
        (format!("{prefix}{}", share.path), value)
    });
    let values = shares.chain([(format!("{prefix}{NAME}"), name.trim().to_owned())]).collect();
    Remedy {
        title: page::several_actuators(&shared.actuators, l),
        before: String::new(),
        after: page::each_with_its_share(&shared.actuators, l),
        code: shared.code.clone(),
        proviso: proviso_text(shared.proviso.estimate, shared.proviso.rating, l),
        extent: None,
        factor: f64::from(shared.actuators),
        verdict: None,
        change: Some(TextChange::Values(values)),
    }
}

/// Returns the law in place of the open ones as a card.
fn by_law(proposal: LawProposal, language: Language) -> Remedy {
    let law = SegmentLaw::Law(proposal.law);
    Remedy {
        title: page::another_law(language).to_owned(),
        before: law_text(SegmentLaw::Open, language).to_owned(),
        after: law_text(law, language).to_owned(),
        code: proposal.code,
        proviso: proviso_text(proposal.proviso.estimate, proposal.proviso.rating, language),
        extent: None,
        // The machine remains the same: the smallest of all changes.
        factor: 1.0,
        verdict: None,
        change: Some(TextChange::Values(proposal.paths.into_iter().map(|path| (path, law.id().to_owned())).collect())),
    }
}

/// Returns the change of a gearing as a card.
fn by_gearing(proposal: &GearingProposal, held: &ReadProject, prefix: &str, language: Language) -> Remedy {
    let l = language;
    let unit = |unit: &'static Unit| if unit.symbol == "1" { "" } else { unit.symbol_in(l) };
    let shown =
        |si: f64| format!("{} {}", unpadded(proposal.unit.from_si(si), 5, l), unit(proposal.unit)).trim().to_owned();
    let path = format!("{prefix}{}", proposal.path);
    let stated = held.written.iter().find(|key| key.path == path).and_then(|key| key.value.clone());
    let value = format!(
        "{} {}",
        rounded(proposal.unit.from_si(proposal.si)),
        if proposal.unit.symbol == "1" { "" } else { proposal.unit.ascii }
    );
    let value = value.trim();
    let stage = proposal.adds_stage();
    // Values in one unit; a counterweight that is added has none before it.
    let number = |text: &str| text.split(' ').next().and_then(|number| number.parse::<f64>().ok());
    let unit_of = |text: &str| text.split_once(' ').map(|(_, unit)| unit.trim().to_owned());
    let factor = match stated.as_deref().filter(|stated| unit_of(stated) == unit_of(value)) {
        Some(stated) => number(stated).zip(number(value)).map(|(before, after)| after / before),
        None => stage.then_some(proposal.si),
    };
    let kind = stage.then(|| (format!("{prefix}stage.kind"), "gear".to_owned()));
    let values = kind.into_iter().chain([(path, value.to_owned())]).collect();
    Remedy {
        title: if stage {
            page::an_intermediate_stage(l).to_owned()
        } else {
            label_of(&proposal.path, l).unwrap_or_default()
        },
        before: stated.map(|stated| crate::value::said(&stated, l)).unwrap_or_default(),
        after: if stage { terminal::a_stage(&shown(proposal.si), l) } else { shown(proposal.si) },
        code: proposal.code.clone(),
        proviso: proviso_text(proposal.proviso.estimate, proposal.proviso.rating, l),
        extent: None,
        factor: factor.map_or(1.0, folded),
        verdict: None,
        change: Some(TextChange::Values(values)),
    }
}
