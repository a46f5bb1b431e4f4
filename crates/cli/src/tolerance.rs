//! The part of `size` and `check` that tells what the tolerances of a project mean.

use crate::say::t;
use crate::table::{Align, Table, paragraph};
use clap::ArgMatches;
use std::fmt::Write as _;
use workbench::quantities::{Unit, format_number, format_significant};
use workbench::text::check_title;
use workbench::{
    ALL_CORNERS_MOST, Assessment, Candidate, Language, Place, Project, SAMPLES_USUAL, SEED_USUAL, Sampling, Worst,
};

/// Of so many candidates at most the tolerances are judged.
const CANDIDATES_MOST: usize = 10;

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
pub(crate) fn sampling(matches: &ArgMatches) -> Sampling {
    let samples = matches.get_one::<u32>("samples").and_then(|samples| usize::try_from(*samples).ok());
    Sampling {
        samples: samples.unwrap_or(SAMPLES_USUAL),
        seed: matches.get_one::<u64>("seed").copied().unwrap_or(SEED_USUAL),
    }
}

/// The tolerances judged for the best candidates of a ranking and the project's own actuator; nothing without
/// tolerances.
pub(crate) fn assess<'c>(
    project: &Project,
    ranking: impl Iterator<Item = &'c Candidate<'c>>,
    own: Option<&'c Candidate<'c>>,
    sampling: Sampling,
) -> Vec<(&'c Candidate<'c>, Assessment)> {
    if project.tolerances.is_empty() {
        return Vec::new();
    }
    let chosen: Vec<&Candidate<'_>> = ranking.take(CANDIDATES_MOST).chain(own).collect();
    let answers = workbench::assess(project, &chosen, sampling);
    chosen.into_iter().zip(answers).collect()
}

fn head(sampling: Sampling, language: Language) -> String {
    let Sampling { samples, seed } = sampling;
    match language {
        Language::En => format!("tolerances: {samples} samples, seed {seed}"),
        Language::De => format!("Toleranzen: {samples} Stichproben, Startwert {seed}"),
    }
}

fn worst_word(worst: &Worst, language: Language) -> String {
    let verdict =
        if worst.fits { t(language, "fits", "geeignet") } else { t(language, "does not fit", "nicht geeignet") };
    let check = worst
        .check
        .map_or_else(|| t(language, "no axis possible", "keine Achse möglich"), |check| check_title(check, language));
    let word = format!("{verdict}: {check}");
    if worst.place == Place::Sample {
        return format!("{word} {}", t(language, "(inside the band)", "(im Innern des Bands)"));
    }
    word
}

/// The quantity that dominates and its share.
fn dominating(project: &Project, assessment: &Assessment, language: Language) -> [String; 2] {
    let found = assessment.influence.first().and_then(|first| Some((first, project.tolerances.get(first.quantity)?)));
    match found {
        Some((first, tolerance)) => [tolerance.path.clone(), percent(first.share, language)],
        None => [t(language, "none", "keine"), "–".to_owned()],
    }
}

/// The table behind a ranking; empty without tolerances.
pub(crate) fn table(project: &Project, assessed: &[(&Candidate<'_>, Assessment)], language: Language) -> String {
    let Some((_, first)) = assessed.first() else { return String::new() };
    let heads: [&str; 7] = match language {
        Language::En => {
            ["ordering code", "util. %", "worst %", "at the worst corner", "passes %", "dominated by", "by %"]
        }
        Language::De => [
            "Bestellbezeichnung",
            "Ausl. %",
            "Ecke %",
            "in der schlimmsten Ecke",
            "geeignet %",
            "bestimmt durch",
            "zu %",
        ],
    };
    let [code, nominal, worst, word, passes, by, by_share] = heads;
    let mut table = Table::new([
        (code, Align::Left),
        (nominal, Align::Right),
        (worst, Align::Right),
        (word, Align::Left),
        (passes, Align::Right),
        (by, Align::Left),
        (by_share, Align::Right),
    ]);
    for (candidate, assessment) in assessed {
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
    let _ = match language {
        Language::En => writeln!(
            out,
            "{head}\n  passes {passes} % of the samples, 95 % interval {low} % to {high} %\n  \
             utilisation {p05} %, {p50} %, {p95} % at 5, 50, 95 % of the samples, largest {max} %\n  \
             worst corner {worst} %, {word}"
        ),
        Language::De => writeln!(
            out,
            "{head}\n  geeignet bei {passes} % der Stichproben, 95-%-Intervall {low} % bis {high} %\n  \
             Auslastung {p05} %, {p50} %, {p95} % bei 5, 50, 95 % der Stichproben, größte {max} %\n  \
             schlimmste Ecke {worst} %, {word}"
        ),
    };
    if assessment.impossible > 0 {
        let count = assessment.impossible;
        let _ = match language {
            Language::En => writeln!(out, "  with {count} samples no axis is possible; none of them passes"),
            Language::De => {
                writeln!(out, "  bei {count} Stichproben ist keine Achse möglich; bei keiner ist er geeignet")
            }
        };
    }
    if project.tolerances.len() > ALL_CORNERS_MOST {
        let corners = match language {
            Language::En => format!(
                "more than {ALL_CORNERS_MOST} quantities: the corner was searched by one quantity at a time, not every corner was looked at"
            ),
            Language::De => format!(
                "mehr als {ALL_CORNERS_MOST} Größen: die Ecke wurde Größe um Größe gesucht, nicht jede Ecke angesehen"
            ),
        };
        out.push_str(&paragraph("  ", &corners));
    }
    out.push_str(&quantities(project, assessment, language));
    out
}

fn quantities(project: &Project, assessment: &Assessment, language: Language) -> String {
    let heads: [&str; 6] = match language {
        Language::En => ["quantity", "from", "to", "unit", "worst", "influence %"],
        Language::De => ["Größe", "von", "bis", "Einheit", "schlimmst", "Einfluss %"],
    };
    let [quantity, from, to, unit, worst, influence] = heads;
    let mut table = Table::new([
        (quantity, Align::Left),
        (from, Align::Right),
        (to, Align::Right),
        (unit, Align::Left),
        (worst, Align::Right),
        (influence, Align::Right),
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
