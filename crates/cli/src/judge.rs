//! `size` and `check`: the axis judged with the catalogue, and with one actuator.

use crate::answer::CommandAnswer;
use crate::call::Call;
use crate::command::typed::typed;
use crate::reserve::{assumptions_about, assumptions_text, reserve_text};
use crate::table::{Align, TextTable, labelled, paragraph, width};
use crate::waiting::progress;
use crate::{moves, report, tolerance};
use anstyle::{AnsiColor, Style};
use axis::Assumption;
use quantities::unit::{KILOGRAM, NEWTON_METRE, REVOLUTION_PER_MINUTE};
use quantities::{Language, Measure, format_number, seen};
use questions::list::check::Verification;
use questions::list::size::Ranking;
use questions::list::{Inquiry, Unanswered, check, size};
use questions::texts::{
    by_importance, compared_texts, counts_text, demand_figures, fitting_text, instant_text, law_text, margin_text,
    mend_text, objection_text, percent, provisos, reach_text, reason, rejections, reserve_condition, shown,
    standing_text, unit_text, verdict_of, verdict_text,
};
use questions::{Candidate, Check, Demand, Objection, Reserve, Sizing, Verdict};
use std::cell::RefCell;
use std::collections::BTreeSet;
use std::fmt::Write as _;
use words::{
    ERRATUM_MARK, check_missing, erratum_line, grade_word, marked, note_text, ranking_rule, ratios_text, source_text,
    terminal, terms, title_of_check, verdict_word,
};

fn paint(text: &str, verdict: Verdict) -> String {
    let colour = match verdict {
        Verdict::Pass => AnsiColor::Green,
        Verdict::Fail => AnsiColor::Red,
        Verdict::Advice => AnsiColor::Yellow,
        Verdict::NotChecked => AnsiColor::Magenta,
    };
    let style = Style::new().fg_color(Some(colour.into())).bold();
    format!("{style}{text}{style:#}")
}

/// `antrieb size PROJECT`
pub(crate) fn size(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    // First the file: if the report cannot be written, no partial answer is shown.
    let talk = match call.path("report") {
        Some(out) => report::write(call, inquiry, out, false)?.data,
        None => String::new(),
    };
    if call.as_json {
        return Ok(CommandAnswer { talk, ..call.record(inquiry)? });
    }
    let args = size::Args::read(&inquiry.given)?;
    let axes = args.axes(inquiry)?;
    if inquiry.sources.len() > 1 {
        return Ok(CommandAnswer { talk, ..side_by_side(inquiry, &args, language)? });
    }
    let best: RefCell<Option<Best>> = RefCell::new(None);
    let found = inquiry.each(&axes, |project| {
        let found = args.ranking(project, progress())?;
        best.replace(found.sizing.answer().map(|answer| Best {
            code: answer.id.to_string(),
            is_ordered: answer.id.order_code().is_some(),
            check: answer.governing().map(|check| check.id.id()),
            has_open_law: project.assumptions.contains(&Assumption::LawOpen),
        }));
        let reserve = |candidate| questions::list::check::reserve_within(project, candidate, progress());
        // The changes with which the actuator with the smallest excess would fit; the long list does not show them.
        let nearest = found.sizing.nearest_miss().filter(|_| !args.all);
        let reserves = Reserves {
            answer: found.sizing.answer().map(reserve).transpose()?,
            nearest: nearest.map(reserve).transpose()?,
        };
        Ok((sizing_text(&found, &reserves, args.all, language), found.sizing.fits()))
    })?;
    // The further calls are those of the project as its file and the catalogue of the program have it.
    let is_plain = axes.len() == 1 && call.changes.is_empty() && !args.all && call.names_no_catalogue();
    let next = best.into_inner().filter(|_| is_plain).and_then(|best| next_calls(&best, inquiry, args.axis.as_deref()));
    let next = next.map(|calls| format!("\n{}:\n  {}\n", terminal::next_calls(language), calls.join("\n  ")));
    Ok(CommandAnswer { talk, next: next.unwrap_or_default(), ..CommandAnswer::of_axes(found) })
}

/// Reserves that a ranking states.
struct Reserves {
    /// Reserve of the answer.
    answer: Option<Reserve>,
    /// The changes with which the actuator with the smallest excess would fit.
    nearest: Option<Reserve>,
}

/// The answer of a ranking, for the calls that go on from it.
struct Best {
    code: String,
    /// It has an ordering code.
    is_ordered: bool,
    /// Identifier of its governing check.
    check: Option<&'static str>,
    has_open_law: bool,
}

/// Returns the calls that go on from a ranking: the derivation of the governing check, the settings of the drive,
/// the report, and the laws of motion if none is decided; `None` if the project is no file.
fn next_calls(best: &Best, inquiry: &Inquiry<'_>, axis: Option<&str>) -> Option<Vec<String>> {
    let [source] = inquiry.sources.as_slice() else { return None };
    let project = Some(&*source.name).filter(|name| name.ends_with(".toml") && !name.starts_with('('))?;
    let axis: Vec<&str> = axis.into_iter().flat_map(|axis| ["--axis", axis]).collect();
    let of = |words: &[&str]| typed([&["antrieb"][..], words, &axis].concat());
    let mut calls: Vec<String> = best.check.iter().map(|check| of(&["explain", project, "--check", check])).collect();
    if best.has_open_law {
        calls.push(of(&["sweep", project, "--vary", "law=polynomial_5,modified_sine,trapezoid,triangle"]));
    }
    if best.is_ordered {
        calls.push(typed(["antrieb", "commission", &best.code, "--for", "sinamics"]));
    }
    calls.push(of(&["report", project, "--out", "report.pdf"]));
    Some(calls)
}

/// Returns the best actuators of several projects, a row for each axis.
fn side_by_side(inquiry: &Inquiry<'_>, args: &size::Args, language: Language) -> Result<CommandAnswer, Unanswered> {
    let mut table = TextTable::new([
        (terms::file(language), Align::Left),
        (terms::axis(language), Align::Left),
        (terms::ordering_code(language), Align::Left),
        (terms::utilisation_short(language), Align::Right),
        (terms::tightest_check(language), Align::Left),
        ("T_rms Nm", Align::Right),
        ("T_peak Nm", Align::Right),
        ("n_peak min⁻¹", Align::Right),
        ("m kg", Align::Right),
    ]);
    let mut all_fit = true;
    for source in &inquiry.sources {
        let axes = inquiry.axes_of(source, args.axis.as_deref())?;
        let rows = inquiry.each(&axes, |project| {
            let found = args.ranking(project, progress())?;
            let Some(named) = found.sizing.named() else { return Ok((Vec::new(), false)) };
            let demand = |of: fn(&Demand) -> f64, unit: &'static quantities::Unit| {
                named.judgement.demand.map(|demand| shown(of(&demand), unit, language)).unwrap_or_default()
            };
            let mass = named.parameters.mass.known();
            let fits = found.sizing.answer().is_some();
            let verdict = paint(verdict_of(named, language), named.marked_as());
            let row = vec![
                file_name(&source.name).to_owned(),
                project.name.clone(),
                format!("{} {verdict}", named.id),
                percent(named.utilisation(), language),
                named.governing().map(|check| title_of_check(check, language)).unwrap_or_default(),
                demand(|demand| demand.torque_rms.si(), &NEWTON_METRE),
                demand(|demand| demand.torque_peak.si(), &NEWTON_METRE),
                demand(|demand| demand.speed_peak.si(), &REVOLUTION_PER_MINUTE),
                mass.map(|mass| format_number(KILOGRAM.from_si(mass.value.si()), 1, language)).unwrap_or_default(),
            ];
            Ok((row, fits))
        })?;
        for (row, fits) in rows {
            all_fit &= fits;
            if let Ok(row) = <[String; 9]>::try_from(row) {
                table.row(row);
            }
        }
    }
    Ok(CommandAnswer::data(table.render()).fits(all_fit))
}

/// Returns the last part of a path, with the changes of the call behind it.
pub(crate) fn file_name(name: &str) -> &str {
    let path = name.split_once(" (").map_or(name, |(path, _)| path);
    name.get(path.rfind(['/', '\\']).map_or(0, |at| at + 1)..).unwrap_or(name)
}

fn sizing_text(found: &Ranking<'_>, reserves: &Reserves, all: bool, language: Language) -> String {
    let Ranking { project, sizing, top, .. } = found;
    let top = *top;
    let mut out = String::new();
    let evaluated = sizing.ranked().count();
    let name = if sizing.name.is_empty() { terms::axis(language) } else { sizing.name };
    let _ = match sizing.answer() {
        Some(best) => {
            writeln!(out, "{name}: {}: {}", best.id, paint(&standing_text(best, language), best.marked_as()))
        }
        None => writeln!(out, "{name}: {}", paint(terminal::no_actuator_fits(language), Verdict::Fail)),
    };
    let _ = writeln!(out, "{}", fitting_text(sizing, language));
    if let (Some(best), Some(reserve)) = (sizing.answer(), &reserves.answer) {
        out.push_str(&reserve_text(reserve, best, "", language));
    }
    if let Some(reached) = found.reached.as_ref().filter(|reached| !reached.is_empty()) {
        let all: Vec<String> = reached.iter().map(|reach| reach_text(reach, language)).collect();
        out.push_str(&labelled(terminal::smallest_change(language), &all.join("; ")));
        let nearest = reserves.nearest.as_ref().zip(sizing.nearest_miss());
        let condition = nearest.and_then(|(reserve, near)| reserve_condition(reserve, near, language));
        if let Some(condition) = condition {
            out.push_str(&labelled(terms::not_checked(language), &condition));
        }
    }
    if let Some(law) = &found.proposals.law {
        out.push_str(&labelled(terminal::would_fit_with_another_law(language), &law_text(law, language)));
    }
    if !found.proposals.gearings.is_empty() {
        let all: Vec<String> = found.proposals.gearings.iter().map(|mend| mend_text(mend, language)).collect();
        out.push_str(&labelled(terminal::would_fit_with_other_gearing(language), &all.join("; ")));
    }
    out.push('\n');
    if !project.ratios.is_empty() {
        let head = terminal::ratio_of_the_stage(language);
        out.push_str(&labelled(head, &ratios_text(&project.ratios, language)));
        out.push('\n');
    }
    out.push_str(&moves::text(&questions::moves(project), language));
    out.push('\n');
    if let Some(best) = sizing.answer() {
        out.push_str(&demand_text(best, language));
        out.push('\n');
    }
    if evaluated > 0 {
        out.push_str(&ranking_table(sizing, top, language).render());
        out.push_str(&paragraph("", &ranking_rule(sizing.by_mass, language)));
        let shown = sizing.ranked().take(top);
        let masses = shown.filter_map(|(_, candidate)| candidate.parameters.mass.known());
        let errata: BTreeSet<&str> = masses.flat_map(|mass| mass.errata).copied().collect();
        for id in errata {
            out.push_str(&paragraph(&format!("{ERRATUM_MARK} "), &erratum_line(id, language)));
        }
        if evaluated > top {
            let line = terminal::more_fit(&(evaluated - top), language);
            let _ = writeln!(out, "{line}");
        }
        out.push('\n');
    }
    out.push_str(&not_evaluated_text(sizing, top, language));
    out.push_str(&tolerance::table(found, language));
    if let Some(best) = sizing.answer() {
        let open: Vec<String> = best
            .not_checked()
            .map(|check| format!("{} ({})", title_of_check(check, language), missing(check, language)))
            .collect();
        let noted = remarks(best, "  ", language);
        if !open.is_empty() || !noted.is_empty() {
            let _ = writeln!(out, "{}:", terminal::remarks_on(&best.id, language));
        }
        if !open.is_empty() {
            let head = format!("  {}", verdict_word(Verdict::NotChecked, language));
            out.push_str(&labelled(&head, &open.join("; ")));
        }
        out.push_str(&noted);
    }
    // Changes with which any actuator fits stand above: those of the nearest one alone are larger.
    let of_nearest = reserves.nearest.map(|reserve| match &found.reached {
        Some(_) => reserve.without_changes(),
        None => reserve,
    });
    out.push_str(&rejected_text(sizing, of_nearest.as_ref(), all, language));
    if let Some(own) = &sizing.own {
        let _ = writeln!(out, "\n{}:", terminal::own_actuator_of_the_project(language));
        out.push_str(&candidate_text(own, language));
    }
    out.push_str(&assumptions_text(sizing.assumptions, language));
    out
}

/// Returns an actuator with its maker, if several makers compete.
fn product_text(candidate: &Candidate<'_>) -> String {
    match candidate.product.manufacturer.as_ref().filter(|_| candidate.is_among_makers) {
        Some(maker) => format!("{} ({})", candidate.id, seen(maker)),
        None => candidate.id.to_string(),
    }
}

/// Returns the actuators without a check that can reject them, as many as the ranking shows; empty if there are none.
fn not_evaluated_text(sizing: &Sizing<'_>, top: usize, language: Language) -> String {
    let open: Vec<String> = sizing.fitting().iter().filter(|each| each.is_not_evaluated()).map(product_text).collect();
    if open.is_empty() {
        return String::new();
    }
    let left = (open.len() > top).then(|| terminal::and_more(&(open.len() - top), language));
    let listed: Vec<String> = open.into_iter().take(top).chain(left).collect();
    labelled(terminal::not_evaluated_listed(language), &listed.join(", ")) + "\n"
}

fn ranking_table(sizing: &Sizing<'_>, top: usize, language: Language) -> TextTable {
    let product = if sizing.by_mass { terms::product(language) } else { terms::ordering_code(language) };
    let mut table = TextTable::new([
        ("#", Align::Right),
        (product, Align::Left),
        (terms::utilisation_short(language), Align::Right),
        (terms::tightest_check(language), Align::Left),
        ("T_rms Nm", Align::Right),
        ("m kg", Align::Right),
        (terms::remark(language), Align::Left),
    ]);
    for (rank, candidate) in sizing.ranked().take(top) {
        let judgement = &candidate.judgement;
        let mass = candidate.parameters.mass.known();
        let inside = provisos(candidate, |check| title_of_check(check, language));
        let named = [
            (terms::fits_if_estimate(language), inside.estimates),
            (terms::fits_unless_rating(language), inside.ratings),
        ];
        let mut remarks: Vec<String> = named
            .into_iter()
            .filter(|(_, checks)| !checks.is_empty())
            .map(|(verdict, checks)| format!("{verdict}: {checks}"))
            .collect();
        let advised = by_importance(&judgement.checks)
            .into_iter()
            .filter(|check| check.verdict == Verdict::Advice && !check.is_inside_band())
            .map(|check| format!("{}: {}", verdict_text(check, language), title_of_check(check, language)));
        remarks.extend(advised);
        if !candidate.on_request.is_empty() {
            remarks.push(terms::on_request(language).to_owned());
        }
        table.row([
            rank.to_string(),
            product_text(candidate),
            percent(candidate.utilisation(), language),
            candidate.governing().map(|check| title_of_check(check, language)).unwrap_or_default(),
            judgement.demand.map(|d| shown(d.torque_rms.si(), &NEWTON_METRE, language)).unwrap_or_default(),
            mass.map(|m| marked(format_number(KILOGRAM.from_si(m.value.si()), 1, language), m.errata))
                .unwrap_or_default(),
            remarks.join(", "),
        ]);
    }
    table
}

fn rejected_text(sizing: &Sizing<'_>, of_nearest: Option<&Reserve>, all: bool, language: Language) -> String {
    let rejected = sizing.rejected();
    if rejected.is_empty() {
        return String::new();
    }
    let mut out = String::new();
    if all {
        let code = terms::rejected(language);
        let why = terms::reason(language);
        let mut table = TextTable::new([(code, Align::Left), (why, Align::Left)]);
        for candidate in rejected {
            table.row([candidate.id.to_string(), reason(candidate, language)]);
        }
        out.push_str(&table.render());
        return out;
    }
    let reasons = rejections(sizing, language);
    let parts: Vec<String> =
        reasons.iter().map(|reason| format!("{}: {}", reason.title, reason.candidates.len())).collect();
    let head = terminal::rejected_count(&rejected.len(), language);
    let tail = terminal::all_shows_each(language);
    out.push_str(&labelled(&head, &format!("{} ({tail})", parts.join(", "))));
    let by_all = questions::texts::failed_by_all(sizing, language);
    if sizing.fitting().is_empty() && !by_all.is_empty() {
        out.push_str(&labelled(terminal::failed_by_all(language), &by_all.join(", ")));
    }
    let noted = |head: &str, candidate: &Candidate<'_>| {
        labelled(head, &format!("{}, {}", candidate.id, reason(candidate, language)))
    };
    let nearest = sizing.nearest_miss();
    if let Some(nearest) = nearest {
        out.push_str(&noted(terminal::nearest_miss(language), nearest));
    }
    // The necessary changes: for the actuator with the smallest excess, or for one that only limits of the project
    // exclude.
    let by_limits = rejected.iter().find(|candidate| questions::limits_needed(candidate).is_some());
    if let Some(limited) = by_limits.filter(|limited| nearest.is_none_or(|nearest| nearest.id != limited.id)) {
        let head = terminal::kept_out_by_limits(language);
        out.push_str(&noted(head, limited));
        out.push_str(&reserve_text(&Reserve::default(), limited, "  ", language));
    }
    if let (Some(near), Some(reserve)) = (nearest, of_nearest) {
        out.push_str(&reserve_text(reserve, near, "  ", language));
    }
    out
}

fn missing(check: &Check, language: Language) -> String {
    check.missing.map(|symbol| check_missing(symbol, language)).unwrap_or_default()
}

/// Returns the demand in one line, in several on a narrow terminal.
fn demand_line(name: &str, demand: &Demand, language: Language) -> String {
    // A symbol stays on the line of its value.
    let part = |(symbol, value, unit)| format!("{symbol} {value} {unit}").replace(' ', "\u{a0}");
    paragraph(&format!("  {name:<10} "), &demand_figures(demand, language).map(part).join(" · "))
}

/// Returns the demand in both modes; the exact integral is shown if it differs.
fn demand_text(candidate: &Candidate<'_>, language: Language) -> String {
    let mut out = String::new();
    if candidate.judgement.demand.is_none() {
        return out;
    }
    let name = terminal::demand_on(&candidate.id, language);
    let _ = writeln!(out, "{name}");
    if let Some(manual) = candidate.judgement.by_the_manual() {
        for (index, each) in manual.moves.iter().enumerate().take(5) {
            let which = if manual.moves.len() > 1 {
                format!("{}: ", terminal::move_number(&(index + 1), language))
            } else {
                String::new()
            };
            let _ = writeln!(
                out,
                "  {which}T_1 {} · T_2 {} · T_3 {} Nm",
                shown(each.accelerate.si(), &NEWTON_METRE, language),
                shown(each.run.si(), &NEWTON_METRE, language),
                shown(each.brake.si(), &NEWTON_METRE, language),
            );
        }
        let name = terms::manual(language);
        out.push_str(&demand_line(name, &manual.demand, language));
    }
    if let Some(demand) = &candidate.judgement.demand {
        let name = terms::integral(language);
        out.push_str(&demand_line(name, demand, language));
    }
    out
}

/// Returns the remarks on the checks, each line indented.
fn remarks(candidate: &Candidate<'_>, indent: &str, language: Language) -> String {
    let mut out = String::new();
    let mut seen: Vec<String> = Vec::new();
    for check in by_importance(&candidate.judgement.checks) {
        // The erratum of a limit that is far away is in --json; here it would obscure the rest.
        let far = check.verdict == Verdict::Pass && check.utilisation.is_some_and(|share| share < 0.5);
        for note in check.notes.iter() {
            if far && note.is_erratum() {
                continue;
            }
            let text = note_text(note, language);
            if !seen.contains(&text) {
                out.push_str(&paragraph(&format!("{indent}{}: ", title_of_check(check, language)), &text));
                seen.push(text);
            }
        }
    }
    out
}

/// Returns every check of one actuator.
fn candidate_text(candidate: &Candidate<'_>, language: Language) -> String {
    let mut out = String::new();
    let colour = candidate.marked_as();
    let standing = standing_text(candidate, language);
    let long = candidate.id.to_string().chars().count() + standing.chars().count() + 2 > width();
    let between = if long { "\n  " } else { " " };
    let _ = writeln!(out, "{}:{between}{}", candidate.id, paint(&standing, colour));
    for objection in &candidate.objections {
        let head = match objection {
            Objection::Unmet(unmet) if unmet.is_open() => terminal::requirement_not_checked(language),
            _ => terms::requirement_not_met(language),
        };
        out.push_str(&labelled(head, &objection_text(candidate, objection, language)));
    }
    for open in &candidate.open_requirements {
        out.push_str(&labelled(terminal::requirement_not_checked(language), &words::unmet_text(open, language)));
    }
    out.push_str(&labelled(terminal::checks(language), &counts_text(candidate, language)));
    let keys: Vec<&str> = candidate.keys_to_state().into_iter().map(|(key, _)| key).collect();
    if !keys.is_empty() {
        out.push_str(&labelled(terminal::to_state(language), &keys.join(", ")));
    }
    if !candidate.on_request.is_empty() {
        let _ = writeln!(out, "{}", terms::on_request_only(language));
    }
    out.push_str(&demand_text(candidate, language));
    out.push('\n');
    let mut table = TextTable::new([
        (terms::check(language), Align::Left),
        (terms::verdict(language), Align::Left),
        (terms::value(language), Align::Right),
        (terms::limit(language), Align::Right),
        (terms::unit(language), Align::Left),
        (terms::utilisation_short(language), Align::Right),
        (terminal::at_s(language), Align::Right),
        (terminal::grade_and_source(language), Align::Left),
    ]);
    for check in by_importance(&candidate.judgement.checks) {
        let source = match (&check.limit_source, check.grade) {
            (Some(source), Some(grade)) => {
                format!("{}, {}", grade_word(grade, language), source_text(source, language))
            }
            _ => missing(check, language),
        };
        let [value, limit] = compared_texts(check, language);
        table.row([
            title_of_check(check, language),
            verdict_text(check, language),
            value,
            limit,
            unit_text(check.value, language).to_owned(),
            margin_text(check, language),
            check.at.map_or_else(|| "–".into(), |at| instant_text(at, language)),
            source,
        ]);
    }
    out.push_str(&table.render());
    out.push_str(&remarks(candidate, "", language));
    out
}

/// `antrieb check PROJECT --code CODE`
pub(crate) fn check(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    let args = check::Args::read(&inquiry.given)?;
    let axes = args.axes(inquiry)?;
    let found = inquiry.each(&axes, |project| {
        let found = args.verification(project, progress())?;
        Ok((verification_text(&found, language), found.candidate.fits()))
    })?;
    Ok(CommandAnswer::of_axes(found))
}

fn verification_text(found: &Verification<'_>, language: Language) -> String {
    let (project, candidate) = (found.project, &found.candidate);
    let reserve = reserve_text(&found.reserve, candidate, "", language);
    let assumed = assumptions_about(project, candidate, language);
    let one_line = format!("{} · {}: {}", project.name, candidate.id, standing_text(candidate, language));
    let head = match (project.name.is_empty(), one_line.chars().count() > width()) {
        (true, _) => String::new(),
        (false, true) => paragraph("", &project.name),
        (false, false) => format!("{} · ", project.name),
    };
    let tolerances = found.assessment.as_ref();
    let tolerances = tolerances.map(|found| tolerance::detail(project, found, language)).unwrap_or_default();
    let moves = moves::text(&questions::moves(project), language);
    format!("{head}{}{reserve}{moves}{tolerances}{assumed}", candidate_text(candidate, language))
}
