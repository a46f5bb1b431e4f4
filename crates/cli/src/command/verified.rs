//! Proposed calls that can be answered: each is read as if it were typed, without its answer.

use super::example::split;
use super::meant::Called;
use super::parsed::{Misread, ParsedCall};
use super::{remedy, usage};
use crate::ask;
use quantities::Language;
use questions::list::Unanswered;
use std::ffi::OsString;
use words::{UsageHint, usage_hint};

/// Number of refusals that are followed from a proposal to one that works.
const FOLLOWED_MOST: usize = 2;

/// Largest number of calls that stand in place of one that does not work.
const INSTEAD_MOST: usize = 4;

/// Returns the proposed calls that can be answered; in place of one that cannot, those that its own refusal proposes. A call about a
/// file that one before it writes stays as it is.
pub(crate) fn verified(calls: Vec<String>) -> Vec<String> {
    let mut written: Vec<String> = Vec::new();
    let mut found: Vec<String> = Vec::new();
    for call in calls {
        let words = split(&call);
        let reads_written = words.iter().any(|word| written.contains(word));
        let out = words.iter().skip_while(|word| !["--out", "-o"].contains(&word.as_str())).nth(1);
        written.extend(out.cloned());
        let own = if reads_written { vec![call] } else { answerable(&call, FOLLOWED_MOST) };
        found.extend(own.into_iter().filter(|call| !found.contains(call)).collect::<Vec<_>>());
    }
    found
}

/// Returns a hint with the calls of it that can be answered; `None` without any.
pub(crate) fn verified_hint(hint: UsageHint) -> Option<UsageHint> {
    match hint {
        UsageHint::Calls(calls) => {
            let calls = verified(calls);
            (!calls.is_empty()).then_some(UsageHint::Calls(calls))
        }
        other => Some(other),
    }
}

/// Returns a call that can be answered, else the calls that its refusal proposes, followed `most` times.
fn answerable(call: &str, most: usize) -> Vec<String> {
    let words: Vec<OsString> = split(call).into_iter().map(OsString::from).collect();
    let ParsedCall { arguments, command, language, matches, .. } = ParsedCall::of(words);
    let proposed = match matches {
        Err(Misread::Library(error)) if !error.use_stderr() => return vec![call.to_owned()],
        Err(Misread::Library(error)) => usage::hints(&error, (&command, &arguments), language),
        Err(Misread::Stray(stray)) => Called::of(&arguments, &command, language)
            .and_then(|called| stray.fault(&called, &arguments).1)
            .into_iter()
            .collect(),
        Ok(matches) => match ask::read(&matches, language) {
            Ok(()) => return vec![call.to_owned()],
            Err(why) => {
                let why = remedy::with_whole_calls(why, &arguments, language, &|calls| calls);
                let calls = calls_of(&why, language);
                vec![UsageHint::Calls([calls, remedy::calls(&why, &arguments, &command, language)].concat())]
            }
        },
    };
    if most == 0 {
        return Vec::new();
    }
    let calls =
        proposed.into_iter().flat_map(|hint| if let UsageHint::Calls(calls) = hint { calls } else { Vec::new() });
    let others = calls.filter(|other| other != call);
    others.flat_map(|other| answerable(&other, most - 1)).take(INSTEAD_MOST).collect()
}

/// Returns the whole calls that the hints of faults name.
fn calls_of(why: &Unanswered, language: Language) -> Vec<String> {
    match why {
        Unanswered::Option { fault: (_, Some(hint)), .. } | Unanswered::Message((_, Some(hint))) => {
            let begin = usage_hint(&UsageHint::Calls(vec![String::new()]), language);
            let program = format!("{} ", super::NAME);
            let lines = hint.strip_prefix(&begin).into_iter().flat_map(str::lines).map(str::trim);
            lines.filter(|line| line.starts_with(&program)).map(str::to_owned).collect()
        }
        Unanswered::Together(all) => all.iter().flat_map(|one| calls_of(one, language)).collect(),
        _ => Vec::new(),
    }
}
