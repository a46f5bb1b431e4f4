//! Ordering codes: whatever the text, no panic, and never another code than the one written.

use fuzz::{any_edits, any_text, explore, mutate};
use order_code::{Pattern, parse};
use workbench::{Language, read_code};

fn bare(text: &str) -> String {
    text.chars().filter(|c| c.is_alphanumeric()).collect::<String>().to_ascii_uppercase()
}

fn hold(text: &str) {
    match parse(text) {
        Ok(parsed) => assert_eq!(bare(text), bare(&parsed.code.to_string()), "{text:?}"),
        Err(faults) => assert!(faults.iter().all(|fault| text.get(fault.span()).is_some()), "{text:?}"),
    }
    if let Err(faults) = Pattern::parse(text) {
        assert!(faults.iter().all(|fault| text.get(fault.span()).is_some()), "{text:?}");
    }
    for language in [Language::En, Language::De] {
        if let Err(refusal) = read_code(text, language) {
            let faults = refusal.faults;
            assert!(!faults.is_empty());
            assert!(faults.iter().all(|fault| text.get(fault.span.clone()).is_some() && !fault.message.is_empty()));
        }
    }
}

#[test]
fn codes_from_any_text() {
    explore(2, |u| {
        hold(&any_text(u, 80)?);
        Ok(())
    });
}

#[test]
fn codes_with_a_few_edits() {
    let codes: Vec<String> = workbench::list_codes(None).into_iter().map(|(code, _)| code.to_string()).collect();
    explore(2, |u| {
        let code = u.choose(&codes)?;
        hold(&mutate(code, &any_edits(u, 4)?));
        Ok(())
    });
}

#[test]
fn inputs_that_once_were_hard() {
    for text in include_str!("../corpus/codes.txt").lines() {
        hold(text);
    }
}
