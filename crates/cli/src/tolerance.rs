//! The part of `size` and `check` that tells what the tolerances of a project mean.

use crate::table::{Align, Table, paragraph};
use clap::ArgMatches;
use std::fmt::Write as _;
use workbench::quantities::{Unit, format_number, format_significant};
use workbench::text::{check_title, terminal, terms};
use workbench::{ALL_CORNERS_MOST, Assessment, Draw, Language, Place, Project, Ranking, SEED_USUAL, Sampling, Worst};

fn percent(share: f64, language: Language) -> String {
    if share.is_finite() { format_number(share * 100.0, 1, language) } else { "∞".to_owned() }
}

fn shown(si: f64, unit: &Unit, language: Language) -> String {
    format_significant(unit.from_si(si), 5, language)
}

/// A share of samples; it shows 100 % only where every sample passes.
fn share(assessment: &Assessment, language: Language) -> String {
    format_number((assessment.share() * 1e4).floor() / 1e2, 2, language)
}

/// How many samples and which seed are asked for.
pub(crate) fn draw(matches: &ArgMatches) -> Draw {
    Draw {
        samples: matches.get_one::<u32>("samples").and_then(|samples| usize::try_from(*samples).ok()),
        seed: matches.get_one::<u64>("seed").copied().unwrap_or(SEED_USUAL),
    }
}

fn head(sampling: Sampling, language: Language) -> String {
    let Sampling { samples, seed } = sampling;
    terminal::tolerances_head(&samples, &seed, language)
}

fn worst_word(worst: &Worst, language: Language) -> String {
    let verdict = if worst.fits { terms::fits(language) } else { terms::does_not_fit(language) };
    let check = worst
        .check
        .map_or_else(|| terminal::no_axis_possible(language).to_owned(), |check| check_title(check, language));
    let word = format!("{verdict}: {check}");
    if worst.place == Place::Sample {
        return format!("{word} ({})", terminal::inside_the_band(language));
    }
    word
}

/// The quantity that dominates and its share.
fn dominating(project: &Project, assessment: &Assessment, language: Language) -> [String; 2] {
    let found = assessment.influence.first().and_then(|first| Some((first, project.tolerances.get(first.quantity)?)));
    match found {
        Some((first, tolerance)) => [tolerance.path.clone(), percent(first.share, language)],
        None => [terminal::none(language).to_owned(), "–".to_owned()],
    }
}

/// The table behind a ranking; empty without tolerances.
pub(crate) fn table(ranking: &Ranking<'_>, language: Language) -> String {
    let (project, assessed) = (ranking.project, &ranking.assessed);
    let Some((_, first)) = assessed.first() else { return String::new() };
    let mut table = Table::new([
        (terms::ordering_code(language), Align::Left),
        (terms::utilisation_short(language), Align::Right),
        (terminal::worst_percent(language), Align::Right),
        (terminal::at_the_worst_corner(language), Align::Left),
        (terminal::passes_percent(language), Align::Right),
        (terminal::dominated_by(language), Align::Left),
        (terminal::by_percent(language), Align::Right),
    ]);
    for (candidate, assessment) in ranking.assessed() {
        let [by, by_share] = dominating(project, assessment, language);
        table.row([
            candidate.id.to_string(),
            percent(candidate.standing.utilisation, language),
            percent(assessment.worst.utilisation, language),
            worst_word(&assessment.worst, language),
            share(assessment, language),
            by,
            by_share,
        ]);
    }
    format!("{}\n{}\n", head(first.sampling, language), table.render())
}

/// Everything about the tolerances of one actuator.
pub(crate) fn detail(project: &Project, assessment: &Assessment, language: Language) -> String {
    let mut out = String::from("\n");
    let (low, high) = assessment.interval;
    let passes = share(assessment, language);
    let [low, high] = [low, high].map(|share| format_number(share * 100.0, 2, language));
    let found = &assessment.utilisation;
    let [p05, p50, p95, max] = [found.p05, found.p50, found.p95, found.max].map(|share| percent(share, language));
    let worst = percent(assessment.worst.utilisation, language);
    let word = worst_word(&assessment.worst, language);
    let head = head(assessment.sampling, language);
    let _ = writeln!(
        out,
        "{head}
  {}
  {}
  {}",
        terminal::share_passing(&passes, &low, &high, language),
        terminal::quantiles(&p05, &p50, &p95, &max, language),
        terminal::worst_corner(&worst, &word, language),
    );
    if assessment.impossible > 0 {
        let count = assessment.impossible;
        let _ = writeln!(out, "  {}", terminal::impossible_samples(&count, language));
    }
    if project.tolerances.len() > ALL_CORNERS_MOST {
        let corners = terminal::corner_searched(&ALL_CORNERS_MOST, language);
        out.push_str(&paragraph("  ", &corners));
    }
    out.push_str(&quantities(project, assessment, language));
    out
}

fn quantities(project: &Project, assessment: &Assessment, language: Language) -> String {
    let mut table = Table::new([
        (terminal::quantity(language), Align::Left),
        (terminal::from(language), Align::Right),
        (terminal::to(language), Align::Right),
        (terms::unit(language), Align::Left),
        (terminal::worst(language), Align::Right),
        (terminal::influence_percent(language), Align::Right),
    ]);
    // By influence; where nothing depends on any, as in the file.
    let listed: Vec<usize> = assessment.influence.iter().map(|each| each.quantity).collect();
    let order = if listed.is_empty() { (0..project.tolerances.len()).collect() } else { listed };
    for index in order {
        let (Some(each), Some(at)) = (project.tolerances.get(index), assessment.worst.values.get(index)) else {
            continue;
        };
        let share = assessment.influence.iter().find(|found| found.quantity == index).map(|found| found.share);
        table.row([
            each.path.clone(),
            shown(each.at(-1.0), each.unit, language),
            shown(each.at(1.0), each.unit, language),
            each.unit.symbol.to_owned(),
            shown(*at, each.unit, language),
            share.map_or_else(|| "–".into(), |share| percent(share, language)),
        ]);
    }
    table.render()
}
