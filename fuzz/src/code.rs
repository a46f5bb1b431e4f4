//! Ordering codes: a code is never read as another one, and every fault has its place and its text.

use crate::text::{any_edits, mutate, one_in, rest, tells};
use arbitrary::{Result, Unstructured};
use order_code::{Field, OrderCode, Pattern, parse};
use quantities::Language;
use questions::list::code_complete::completion;
use questions::list::code_list::{list_codes, read_pattern};
use questions::list::code_parse::explain_code;
use questions::{CodeRefusal, answer, read_code};
use std::sync::LazyLock;

static CODES: LazyLock<Vec<OrderCode>> =
    LazyLock::new(|| list_codes(None).into_iter().map(|(code, _)| *code).collect());

/// Tests a valid code with edits, or any text.
pub fn run(data: &[u8]) {
    let text = shown(data);
    hold(&text);
    // The nearest codes and the completions of a partial code are searched among all codes: each takes as long as ten
    // other cases or more, and the languages differ in their texts only.
    let language = if one_in(2, &text) { Language::De } else { Language::En };
    if one_in(15, &text) {
        hold_read(&text, language);
    } else if one_in(13, &text) {
        hold_partial(&text, language);
    }
}

/// Returns the text of a case.
pub fn shown(data: &[u8]) -> String {
    text(&mut Unstructured::new(data)).unwrap_or_default()
}

fn text(u: &mut Unstructured<'_>) -> Result<String> {
    if u.ratio(1, 4)? {
        return Ok(rest(u));
    }
    let code = u.choose(&CODES)?.to_string();
    let edits = if u.ratio(1, 8)? { Vec::new() } else { any_edits(u, 4)? };
    Ok(mutate(&code, &edits))
}

fn bare(text: &str) -> String {
    text.chars().filter(|c| c.is_alphanumeric()).collect::<String>().to_ascii_uppercase()
}

fn hold(text: &str) {
    match parse(text) {
        Ok(parsed) => {
            let printed = parsed.code.to_string();
            assert_eq!(bare(text), bare(&printed), "{text:?}");
            let again = parse(&printed);
            assert!(again.is_ok_and(|again| again.code == parsed.code && again.is_canonical()), "{text:?}");
        }
        Err(faults) => assert!(faults.iter().all(|fault| text.get(fault.span()).is_some()), "{text:?}"),
    }
}

fn hold_read(text: &str, language: Language) {
    match read_code(text, language) {
        Ok(reading) => {
            let _ = answer::code_reading(&reading, language);
            let explained = explain_code(&reading.parsed.code, language);
            assert_eq!(explained.len(), Field::ALL.len());
            explained.iter().for_each(|(_, _, meaning)| tells(meaning));
        }
        Err(refusal) => refused(text, &refusal, language),
    }
}

fn hold_partial(text: &str, language: Language) {
    if let Err(faults) = Pattern::parse(text) {
        assert!(faults.iter().all(|fault| text.get(fault.span()).is_some()), "{text:?}");
    }
    match read_pattern(text, language) {
        Ok(pattern) => partial(&pattern, language),
        Err(refusal) => refused(text, &refusal, language),
    }
}

fn refused(text: &str, refusal: &CodeRefusal, language: Language) {
    assert!(!refusal.faults.is_empty(), "{text:?}");
    for fault in &refusal.faults {
        assert!(text.get(fault.span.clone()).is_some(), "{text:?}: {fault:?}");
        tells(&fault.message);
        fault.hint.iter().for_each(|hint| tells(hint));
    }
    for (code, _) in &refusal.nearest {
        assert!(read_code(&code.to_string(), language).is_ok(), "{text:?}: {code} is proposed and cannot be had");
    }
    let _ = answer::code_faults(text, refusal, language);
}

/// Checks that every completion of a partial code leads to a code.
fn partial(pattern: &Pattern, language: Language) {
    let codes = list_codes(Some(pattern));
    assert!(!codes.is_empty(), "{pattern:?}");
    assert!(codes.iter().all(|(code, _)| pattern.matches(code)), "{pattern:?}");
    let fields = completion(pattern, language);
    assert!(fields.iter().all(|(_, name, choices)| !name.is_empty() && !choices.is_empty()), "{pattern:?}");
}
