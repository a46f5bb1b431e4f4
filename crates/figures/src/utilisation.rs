//! Bars of the utilisation of every check.

use crate::drawing::{Chart, Drawing, Figure};
use crate::labels::{amount, listed, percent, with_symbols};
use plot::{Bar, BarChart, PlaneAxis};
use quantities::{Language, grouped, with_symbol};
use questions::texts::{by_importance, compared_texts, counts_text, margin_share, verdict_text};
use questions::{Candidate, Check, CheckId, Direction, Objection, Verdict};
use words::{
    advice_word, capitalised, check_missing, pictures, row_name, terms, title_of_check, unmet_text, verdict_word,
    without_keys, without_limit,
};

/// Draws every check of a candidate, in the order of all answers.
#[must_use]
pub fn utilisation(candidate: &Candidate<'_>, language: Language) -> Drawing {
    let checks = by_importance(&candidate.judgement.checks);
    let mut chart = BarChart::new(PlaneAxis::new("", "%").name(pictures::utilisation_of_the_limit(language)));
    for objection in &candidate.objections {
        chart = chart.bar(objection_bar(candidate, objection, language));
    }
    for open in &candidate.open_requirements {
        chart = chart.bar(requirement_bar(plot::Verdict::NotChecked, &unmet_text(open, language), language));
    }
    for check in &checks {
        chart = chart.bar(bar(check, language));
    }
    let proviso = candidate.judgement.proviso();
    for verdict in VERDICTS {
        if checks.iter().any(|check| check.verdict == verdict && !check.is_without_limit()) {
            let word = match verdict {
                Verdict::Advice => advice_word(proviso.estimate, proviso.rating, language),
                verdict => verdict_word(verdict, language),
            };
            chart = chart.explain(sign(verdict), word);
        }
    }
    if checks.iter().any(|check| check.is_without_limit()) {
        chart = chart.explain(plot::Verdict::NoLimit, without_limit(language));
    }
    let rows = checks.len() + candidate.objections.len() + candidate.open_requirements.len();
    #[expect(clippy::cast_precision_loss, reason = "a count of rows")]
    let height = 6.0f64.mul_add(rows as f64, 30.0);
    let mut caption = pictures::utilisation_caption(language).to_owned();
    if checks.iter().any(|check| margin_share(check).is_some() && check.utilisation_band().is_some()) {
        caption = format!("{caption} {}", pictures::estimated_band(language));
    }
    let texts = (caption, description(candidate, &checks, language));
    let of = candidate.id.to_string();
    Drawing::new(Figure::Utilisation, &of, (165.0, height), texts, Chart::Bars(chart), language)
}

/// Verdicts in the order of their explanation and count.
const VERDICTS: [Verdict; 4] = [Verdict::Pass, Verdict::Advice, Verdict::Fail, Verdict::NotChecked];

pub(crate) const fn sign(verdict: Verdict) -> plot::Verdict {
    match verdict {
        Verdict::Pass => plot::Verdict::Pass,
        Verdict::Fail => plot::Verdict::Fail,
        Verdict::Advice => plot::Verdict::Advice,
        Verdict::NotChecked => plot::Verdict::NotChecked,
    }
}

fn bar(check: &Check, language: Language) -> Bar {
    let sign = if check.is_without_limit() { plot::Verdict::NoLimit } else { sign(check.verdict) };
    let mut bar = Bar::new(capitalised(&title_of_check(check, language)), sign).data("check", check.id.id());
    let numbers = match (check.value, check.limit) {
        (Some(_), Some(limit)) => {
            let [shown, bound] = compared_texts(check, language);
            let sign = if check.direction() == Direction::AtLeast { "≥ " } else { "" };
            let limit = match check.id {
                CheckId::Protection => bound,
                _ => with_symbol(&grouped(&bound), limit.unit.symbol_in(language)),
            };
            format!("{shown} / {sign}{limit}")
        }
        (Some(value), None) => amount(value.si, value.unit, language),
        _ => String::new(),
    };
    if check.is_without_limit() {
        return bar.text(numbers).tooltip(&verdict_text(check, language));
    }
    if check.verdict == Verdict::NotChecked {
        let missing = check.missing.unwrap_or_default();
        // The datum in a few words; the tooltip says more.
        let named = row_name(missing, language);
        let short = without_keys(&named, language);
        let reason = check_missing(missing, language);
        let reason = without_keys(&reason, language);
        let text = with_symbols(&format!("{}: {short}", terms::missing(language)));
        return bar.text(text).tooltip(&format!("{reason} {numbers}"));
    }
    // A recommendation or a class that is met has no utilisation to compare with others.
    let Some(share) = margin_share(check) else { return bar.text(numbers) };
    bar = bar.percent(share * 100.0).data("utilisation", &format!("{share}"));
    if let Some([low, _]) = check.utilisation_band() {
        bar = bar.uncertain_from(low * 100.0);
    }
    bar.text(if numbers.is_empty() {
        percent(share, language)
    } else {
        format!("{} · {numbers}", percent(share, language))
    })
}

fn objection_bar(candidate: &Candidate<'_>, objection: &Objection, language: Language) -> Bar {
    let (sign, text) = match objection {
        Objection::Unmet(unmet) if unmet.is_open() => (plot::Verdict::NotChecked, unmet_text(unmet, language)),
        Objection::Unmet(unmet) => (plot::Verdict::Fail, unmet_text(unmet, language)),
        Objection::Rule(rule) => (plot::Verdict::Fail, questions::texts::rule_text(&candidate.id, rule, language)),
    };
    requirement_bar(sign, &text, language)
}

fn requirement_bar(sign: plot::Verdict, text: &str, language: Language) -> Bar {
    Bar::new(capitalised(text), sign).text(terms::requirement(language)).tooltip(text)
}

fn description(candidate: &Candidate<'_>, checks: &[&Check], language: Language) -> String {
    let counts = counts_text(candidate, language);
    let head = pictures::checks_counted(&checks.len(), &candidate.id, &counts, language);
    let named =
        |check: &&Check| Some(format!("{} {}", title_of_check(check, language), percent(check.utilisation?, language)));
    let counts = |check: &&&Check| check.id.has_margin() || check.verdict == Verdict::Fail;
    let worst: Vec<String> = checks.iter().filter(counts).filter_map(named).take(3).collect();
    if worst.is_empty() {
        return head;
    }
    pictures::tightest_named(&head, &listed(&worst, language), language)
}
