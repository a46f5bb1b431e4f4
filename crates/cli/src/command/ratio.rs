//! Reduction ratios of the catalogue in a call: the actuators with this field of their codes.

use super::best::{ProjectOfCall, best_of_pattern};
use super::meant::Called;
use super::own::VARY;
use super::replaced;
use order_code::{Ratio, Series};
use quantities::Language;
use std::ffi::OsString;
use words::spoken;

/// A statement of ratios: its words in the call, and the ratios in their order.
struct Stated {
    place: usize,
    count: usize,
    ratios: Vec<u16>,
}

/// Returns a call that states ratios of the catalogue with the actuators that have them, and `true` if there was such a statement:
/// `check a.toml --ratio 50` is about the best with this ratio, `sweep a.toml --ratio 50,100` has a row for the best with each.
pub(super) fn with_codes(mut arguments: Vec<OsString>, language: Language) -> (Vec<OsString>, bool) {
    let names_ratio = |word: &OsString| word.to_str().is_some_and(|word| key_of(word).is_some());
    if super::json_of(&arguments) || !arguments.iter().skip(2).any(names_ratio) {
        return (arguments, false);
    }
    let whole = super::build_for(&arguments, language);
    let found = Called::of(&arguments, &whole, language).and_then(|called| changes(&called, &arguments));
    let Some((Stated { place, count, .. }, words, command)) = found else { return (arguments, false) };
    arguments.splice(place..place + count, words.into_iter().map(OsString::from));
    if let Some((place, name)) = command
        && let Some(word) = arguments.get_mut(place)
    {
        *word = name.into();
    }
    (arguments, true)
}

/// Words in place of a statement, and another command at its place.
type Changes = (Stated, Vec<String>, Option<(usize, &'static str)>);

fn changes(called: &Called<'_>, arguments: &[OsString]) -> Option<Changes> {
    let texts: Vec<&str> = arguments.iter().map(|word| word.to_str()).collect::<Option<_>>()?;
    let project = called.projects.first()?.to_str()?;
    called.command.get_positionals().find(|position| position.get_id() == "project")?;
    let stated = stated(called, &texts)?;
    let is_given = |name: &str| texts.iter().any(|word| word.split('=').next() == Some(name));
    // The project as the other words of the call change it.
    let changed = || {
        let Stated { place, count, .. } = stated;
        let others = arguments.iter().enumerate().filter(|(at, _)| !(place..place + count).contains(at));
        let others: Vec<OsString> = others.map(|(_, word)| word.clone()).collect();
        let (found, _) = replaced::understood(others, false, called.whole(), called.language());
        ProjectOfCall::of_call(project, &found.arguments, called)
    };
    let all = || {
        let changed = changed()?;
        let best = |ratio: &u16| {
            let pattern = questions::list::code_list::read_pattern(&pattern(*ratio), called.language()).ok()?;
            Some(best_of_pattern(&changed, &pattern)?.code)
        };
        stated.ratios.iter().map(best).collect::<Option<Vec<String>>>()
    };
    let rows = || Some(vec![format!("--{VARY}"), format!("code={}", all()?.join(","))]);
    let command = |name| Some((called.begin.checked_sub(1)?, name));
    let of_one = || match &stated.ratios[..] {
        [ratio] if !is_given("--code") => Some(vec!["--code".to_owned(), pattern(*ratio)]),
        _ => None,
    };
    match called.entry?.command {
        "sweep" => Some((rows()?, None)),
        // A ranking has every ratio.
        "size" => match of_one() {
            Some(words) => Some((words, command("check"))),
            None => Some((rows()?, command("sweep"))),
        },
        "compare" => Some((all()?.into_iter().flat_map(|code| ["--code".to_owned(), code]).collect(), None)),
        _ if called.has("code") => Some((of_one()?, None)),
        _ => None,
    }
    .map(|(words, command)| (stated, words, command))
}

/// Returns the word for the ratio that an option, or a statement with its values, begins with.
fn key_of(word: &str) -> Option<&str> {
    let word = word.strip_prefix(&format!("--{VARY}=")).unwrap_or(word);
    let key = word.split('=').next().unwrap_or_default().trim_start_matches('-');
    spoken::is_ratio(key).then_some(key)
}

/// Returns the first statement of a call.
fn stated<'t>(called: &Called<'_>, texts: &[&'t str]) -> Option<Stated> {
    let name = |word: &str| key_of(word).is_some_and(|key| !called.has(key));
    let of = |(place, word): (usize, &&'t str)| -> Option<(usize, usize, &'t str, &'t str)> {
        let next = texts.get(place + 1).copied().unwrap_or_default();
        // `--vary ratio=50,100`
        if *word == format!("--{VARY}") {
            let (key, values) = next.split_once('=').filter(|(key, _)| name(key))?;
            return Some((place, 2, key, values));
        }
        let word = word.strip_prefix(&format!("--{VARY}=")).unwrap_or(word);
        match word.split_once('=') {
            Some((key, values)) => Some((place, 1, key, values)),
            None => Some((place, 2, word, next)),
        }
    };
    let all = texts.iter().enumerate().skip(called.begin).take_while(|(_, word)| **word != "--");
    all.filter_map(of)
        .filter(|(_, _, key, _)| name(key))
        .find_map(|(place, count, _, values)| Some(Stated { place, count, ratios: ratios(values)? }))
}

/// Reads a list or a range of ratios that the catalogue has: `50`, `50,100`, `30..100`.
fn ratios(text: &str) -> Option<Vec<u16>> {
    let mut all: Vec<u16> = Series::all().flat_map(Ratio::all).map(Ratio::value).collect();
    all.sort_unstable();
    all.dedup();
    let number = |text: &str| {
        let text = text.trim();
        let text = text.strip_prefix("i=").or_else(|| text.strip_prefix("1:")).unwrap_or(text);
        let number: u16 = text.strip_suffix(":1").unwrap_or(text).parse().ok()?;
        all.contains(&number).then_some(number)
    };
    match text.split_once("..") {
        Some((low, high)) => {
            let (low, high) = (number(low)?, number(high)?);
            Some(all.iter().copied().filter(|ratio| (low..=high).contains(ratio)).collect())
        }
        None => text.split([',', ';']).map(number).collect(),
    }
}

/// Returns the pattern of the codes with a ratio.
fn pattern(ratio: u16) -> String {
    format!("CHA-*-{ratio}-*")
}
