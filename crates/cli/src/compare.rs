//! `compare`: several actuators side by side.

use crate::answer::Answer;
use crate::code::parse_for_use;
use crate::fault::simple;
use crate::subject::{Part, axes_of, refuse, together};
use crate::table::{Align, Table, paragraph};
use crate::waiting::patience;
use clap::ArgMatches;
use std::fmt::Write as _;
use workbench::quantities::format_significant;
use workbench::text::{check_title, figure_term, symbol_shown, terminal, terms, verdict_word};
use workbench::{
    Candidate, Check, Comparison, DatumRow, Language, OrderCode, Project, Question, Refusal, Verdict, answer, answers,
};
use workbench::{figure_text, percent};

/// How many are compared.
const COUNT: std::ops::RangeInclusive<usize> = 2..=5;

/// So many stand in one table; further ones in the next.
const BESIDE: usize = 3;

const LETTERS: [char; 5] = ['A', 'B', 'C', 'D', 'E'];

/// `antrieb compare PROJECT --code A --code B`
pub(crate) fn compare(matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    answer(matches, as_json, language).unwrap_or_else(|fault| fault)
}

fn answer(matches: &ArgMatches, as_json: bool, language: Language) -> Result<Answer, Answer> {
    let written: Vec<&String> = matches.get_many::<String>("code").into_iter().flatten().collect();
    if !COUNT.contains(&written.len()) {
        let count = written.len();
        let what = terminal::two_to_five_codes(&count, language);
        return Err(simple(&what, as_json, language));
    }
    let mut talk = String::new();
    let mut codes: Vec<OrderCode> = Vec::new();
    for text in written {
        let (reading, note) = parse_for_use(text, as_json, language)?;
        talk.push_str(&note);
        codes.push(reading.parsed.code);
    }
    let projects = axes_of(Question::Other, matches, as_json, language)?;
    let parts = projects.iter().map(|project| axis(project, &codes, as_json, language));
    let mut answer = together(parts.collect(), as_json);
    answer.talk = talk + &answer.talk;
    Ok(answer)
}

fn axis(
    project: &Project,
    codes: &[OrderCode],
    as_json: bool,
    language: Language,
) -> Result<Part<answers::Comparison>, Answer> {
    let found = workbench::compare(project, codes, patience()).map_err(|(index, refusal)| {
        let mut fault = refuse(&refusal, as_json, language);
        if let Some(code) = codes.get(index).filter(|_| refusal != Refusal::Stopped) {
            let _ = writeln!(fault.talk, "{code}");
        }
        fault
    })?;
    let fits = found.candidates.iter().any(Candidate::fits);
    let record = || answer::comparison(&found, &project.name, language);
    Ok(Part::of(as_json, fits, record, || text(&found, project, language)))
}

fn text(found: &Comparison<'_>, project: &Project, language: Language) -> String {
    let mut out = String::new();
    if !project.name.is_empty() {
        let _ = writeln!(out, "{}", project.name);
    }
    for (index, candidate) in found.candidates.iter().enumerate() {
        let tightest = candidate.judgement.tightest().map_or_else(String::new, |check| {
            format!(", {} {} %", check_title(check.id, language), percent(check.utilisation, language))
        });
        let verdict = verdict(candidate, language);
        let first = if found.better == Some(index) {
            format!("; {}", terminal::first_in_the_ranking(language))
        } else {
            String::new()
        };
        let _ = writeln!(out, "{}  {}: {verdict}{tightest}{first}", letter(index), candidate.id);
        for objection in answer::objections(candidate, language) {
            out.push_str(&paragraph("   ", &objection));
        }
    }
    let all: Vec<usize> = (0..found.candidates.len()).collect();
    for part in all.chunks(BESIDE) {
        out.push('\n');
        out.push_str(&checks(found, part, language));
    }
    let pass = verdict_word(Verdict::Pass, language);
    let fail = verdict_word(Verdict::Fail, language);
    let advice = verdict_word(Verdict::Advice, language);
    let open = verdict_word(Verdict::NotChecked, language);
    let room = terminal::lowest_utilisation(language);
    let _ = writeln!(out, "✓ {pass} · ✗ {fail} · ! {advice} · ? {open} · * {room}\n");
    out.push_str(&figures(found, language));
    out
}

pub(crate) fn verdict(candidate: &Candidate<'_>, language: Language) -> &'static str {
    if candidate.fits() { terms::fits(language) } else { terms::does_not_fit(language) }
}

fn letter(index: usize) -> char {
    LETTERS.get(index).copied().unwrap_or('?')
}

const fn sign(verdict: Verdict) -> char {
    match verdict {
        Verdict::Pass => '✓',
        Verdict::Fail => '✗',
        Verdict::Advice => '!',
        Verdict::NotChecked => '?',
    }
}

fn checks(found: &Comparison<'_>, part: &[usize], language: Language) -> String {
    let mut heads =
        vec![(terms::check(language).to_owned(), Align::Left), (terms::unit(language).to_owned(), Align::Left)];
    for index in part {
        let letter = letter(*index);
        heads.push((format!("{letter} {}", terms::value(language)), Align::Right));
        heads.push((format!("{letter} {}  ", terms::utilisation_short(language)), Align::Right));
    }
    let mut table = Table::of(heads);
    for row in &found.checks {
        let unit = row.checks.iter().flatten().find_map(|check: &Check| check.value.or(check.limit));
        let unit = unit.map_or("", |figure| figure.unit.symbol);
        let mut cells = vec![check_title(row.id, language), if unit == "1" { "–".to_owned() } else { unit.to_owned() }];
        for index in part {
            match row.checks.get(*index).and_then(Option::as_ref) {
                Some(check) => {
                    let better = if row.better == Some(*index) { '*' } else { ' ' };
                    cells.push(figure_text(check.value, language));
                    cells.push(format!("{better}{} {}", percent(check.utilisation, language), sign(check.verdict)));
                }
                None => cells.extend(["–".to_owned(), "–  ".to_owned()]),
            }
        }
        table.push(cells);
    }
    table.render()
}

fn figures(found: &Comparison<'_>, language: Language) -> String {
    let mut heads =
        vec![(terminal::figure(language).to_owned(), Align::Left), (terms::unit(language).to_owned(), Align::Left)];
    heads.extend((0..found.candidates.len()).map(|index| (letter(index).to_string(), Align::Right)));
    let mut table = Table::of(heads);
    for row in found.demand.iter().chain(&found.data) {
        let mut cells = names(row, language).to_vec();
        cells.extend(row.values.iter().map(|value| shown(*value, language)));
        table.push(cells);
    }
    table.render()
}

/// Symbol with its word, and unit.
pub(crate) fn names(row: &DatumRow, language: Language) -> [String; 2] {
    let name = format!("{} {}", symbol_shown(row.symbol), figure_term(row.symbol, language));
    [name, if row.unit.symbol == "1" { "–".to_owned() } else { row.unit.symbol.to_owned() }]
}

pub(crate) fn shown(value: Option<f64>, language: Language) -> String {
    value.map_or_else(|| "–".to_owned(), |value| format_significant(value, 4, language))
}
