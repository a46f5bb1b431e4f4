//! Other fitting actuators, those with the smallest excess, and the reasons for rejecting the rest.

use super::checks::Titles;
use super::shown::{Formatter, tied};
use answers::{CheckId, Dossier, Fit, Ranked, Rejection};
use serde::Serialize;
use words::terminal::{and_more, speed_beyond_the_curve, without_any_check};
use words::{capitalised, erratum_place_of, marked};

/// Number of fitting actuators, and of those with the smallest excess, in the short form.
const FEW: usize = 5;
/// Number of each in the full form.
const MANY: usize = 12;

#[derive(Serialize)]
pub(super) struct Alternatives {
    judged: usize,
    fit: usize,
    /// Sentence on the actuators without a single check, which are neither evaluated nor fitting; empty without any.
    not_evaluated: String,
    /// Codes of these actuators, as many as fitting ones are listed.
    without_check: Vec<String>,
    fit_if_estimate: usize,
    rejected: usize,
    rule: String,
    ranking: Vec<Fitting>,
    /// Errata of the masses of the ranking.
    mass_errata: Vec<String>,
    nearest: Vec<Miss>,
    reasons: Vec<Reason>,
}

#[derive(Serialize)]
struct Fitting {
    rank: usize,
    code: String,
    utilisation: f64,
    /// `pass`, or `advice` within the band of an estimate.
    verdict: &'static str,
    /// `true` if the limit of the governing check is a rating of another manufacturer's gear.
    is_of_another_gear: bool,
    percent: String,
    tightest: String,
    mass: String,
    open: usize,
    on_request: Vec<String>,
    chosen: bool,
}

#[derive(Serialize)]
struct Miss {
    code: String,
    check: String,
    value: String,
    relation: &'static str,
    limit: String,
    percent: String,
    further: Vec<String>,
}

/// One reason and every code that it excludes.
#[derive(Serialize)]
struct Reason {
    is_check: bool,
    text: String,
    count: usize,
    /// Rejected codes; empty in the short form.
    codes: Vec<String>,
}

impl Alternatives {
    pub(super) fn build(dossier: &Dossier, titles: &Titles, full: bool, shown: &Formatter) -> Self {
        let sizing = &dossier.sizing;
        let chosen = dossier.judgement.candidate.code.as_deref();
        let most = if full { MANY } else { FEW };
        let (open, evaluated): (Vec<&Ranked>, Vec<&Ranked>) =
            sizing.ranking.iter().partition(|each| each.of.candidate.is_not_evaluated());
        let best = evaluated.iter().take(most);
        let own = evaluated.iter().skip(most).filter(|each| each.of.candidate.code.as_deref() == chosen);
        let ranking = best.chain(own).map(|each| {
            let candidate = &each.of.candidate;
            let governing = candidate.checks.iter().find(|check| candidate.tightest == Some(check.id));
            Fitting {
                is_of_another_gear: governing.is_some_and(|check| check.is_of_another_gear),
                rank: each.rank,
                code: candidate.called().to_owned(),
                utilisation: candidate.utilisation.written().unwrap_or_default(),
                verdict: if candidate.verdict == Fit::FitsIfEstimate { "advice" } else { "pass" },
                percent: shown.share(candidate.utilisation),
                tightest: candidate.tightest.map(|id| capitalised(&titles.of(*id))).unwrap_or_default(),
                mass: candidate
                    .mass_kg
                    .map(|mass| marked(shown.mass(mass), &candidate.mass_errata))
                    .unwrap_or_default(),
                open: candidate.open_questions,
                on_request: candidate.on_request.clone(),
                chosen: candidate.code.as_deref() == chosen,
            }
        });
        let ranking: Vec<Fitting> = ranking.collect();
        let shown_codes = |code: &str| ranking.iter().any(|row| row.code == code);
        let listed = sizing.ranking.iter().map(|each| &each.of.candidate).filter(|each| shown_codes(each.called()));
        let mut mass_errata: Vec<String> = Vec::new();
        for id in listed.flat_map(|candidate| &candidate.mass_errata) {
            let place = erratum_place_of(id, shown.0);
            if !mass_errata.contains(&place) {
                mass_errata.push(place);
            }
        }
        let reasons = dossier.rejections.iter().map(|group| Reason {
            is_check: group.is_check,
            text: tied(&capitalised(&group.reason)),
            count: group.codes.len(),
            codes: if full { group.codes.clone() } else { Vec::new() },
        });
        // An excess is defined only for actuators rejected solely by a limit; a limit of zero has no utilisation.
        let is_near = |each: &&Rejection| {
            let of_the_place = each.failing.iter().any(|id| id.is_of_the_place());
            each.objections.is_empty() && each.utilisation.is_some() && !of_the_place
        };
        let near = sizing.rejected.iter().filter(is_near);
        let without_check = open.iter().take(most).map(|each| each.of.candidate.called().to_owned());
        let left = (open.len() > most).then(|| and_more(&(open.len() - most), shown.0));
        let count = sizing.not_evaluated;
        Self {
            judged: sizing.judged - count,
            fit: sizing.fit - count,
            not_evaluated: if count == 0 { String::new() } else { without_any_check(count, shown.0) },
            without_check: without_check.chain(left).collect(),
            fit_if_estimate: sizing.fit_if_estimate,
            rejected: sizing.rejected.len(),
            rule: capitalised(&sizing.rule),
            ranking,
            mass_errata,
            nearest: near.take(most).filter_map(|each| miss(each, titles, shown)).collect(),
            reasons: reasons.collect(),
        }
    }
}

fn miss(rejection: &Rejection, titles: &Titles, shown: &Formatter) -> Option<Miss> {
    let check = *rejection.check?;
    let (value, limit) = (rejection.value?, rejection.limit?);
    let unit = rejection.unit.unwrap_or("1");
    let title = capitalised(&titles.of(check));
    // Beyond the end of the curve no torque is permitted: the utilisation is that of the speed.
    let is_beyond = check == CheckId::TorqueSpeedTrace && limit.0 == 0.0;
    let [shown_value, shown_limit] =
        if is_beyond { [String::new(), String::new()] } else { shown.figures_apart([value, limit], unit) };
    Some(Miss {
        code: rejection.code.clone(),
        check: if is_beyond { format!("{title}: {}", speed_beyond_the_curve(shown.0)) } else { title },
        value: shown_value,
        relation: if is_beyond { "" } else { check.direction().relation(false, value.0, limit.0) },
        limit: shown_limit,
        percent: rejection.utilisation.map(|share| shown.share(share)).unwrap_or_default(),
        further: rejection.failing.iter().filter(|id| ***id != check).map(|id| titles.of(**id)).collect(),
    })
}
