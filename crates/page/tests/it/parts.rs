//! Parts that a browser shows are not sent again: with them put back in their places, the page equals the one sent as a
//! whole.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use crate::shell;

use page::Reply;
use quantities::Language;
use questions::list::new::{example, template_kinds};
use shell::{page, post};

/// Returns the parts of a page: identifier, digest, text.
fn parts(page: &str) -> Vec<(&str, &str, &str)> {
    let one = |(place, _): (usize, &str)| {
        let begin = page[..place].rfind('<').unwrap();
        let tag: &str = page[begin + 1..].split(' ').next().unwrap();
        let digest = page[place..].split('"').nth(1).unwrap();
        let id = page[place..].split("id=\"").nth(1).unwrap().split('"').next().unwrap();
        (id, digest, element(&page[begin..], tag))
    };
    page.match_indices(" data-part=\"").map(one).collect()
}

/// Returns the first element of a text with its content.
fn element<'p>(text: &'p str, tag: &str) -> &'p str {
    let (open, close) = (format!("<{tag}"), format!("</{tag}>"));
    let mut deep = 0;
    let mut at = 0;
    loop {
        let next_close = at + text[at..].find(&close).unwrap();
        match text[at..next_close].find(&open) {
            Some(found) => {
                deep += 1;
                at += found + open.len();
            }
            None => {
                deep -= 1;
                at = next_close + close.len();
                if deep == 0 {
                    return &text[..at];
                }
            }
        }
    }
}

fn work(text: &str, kept: &str, change: (&str, &str)) -> Reply {
    post("/work", &[("text", text), ("good", text), ("path", change.0), ("value", change.1), ("parts", kept)])
}

/// Returns an answer with the parts that a browser shows inserted, as the browser does.
fn whole_again(sent: &str, shown: &str) -> (String, usize) {
    let mut out = sent.to_owned();
    let mut named = 0;
    for (id, _, text) in parts(shown) {
        let tag: &str = text[1..].split(' ').next().unwrap();
        let name = format!("<{tag} id=\"{id}\" data-same></{tag}>");
        named += sent.matches(&name).count();
        out = out.replace(&name, text);
    }
    (out, named)
}

#[test]
fn put_back_in_its_place_what_is_left_out_gives_the_whole_page() {
    let changes = [
        ("requirements.ambient", "31 degC"),
        ("motion[1].time", "0.93 s"),
        ("requirements.supply", "no voltage"),
        ("bearing.overhang", "80 mm"),
    ];
    for kind in template_kinds() {
        let Some(found) = example(kind, "axis", Language::En).filter(|found| found.recording.is_none()) else {
            continue;
        };
        let shown = page(&work(&found.text, "", ("", "")));
        let kept: Vec<String> = parts(&shown).iter().map(|(id, digest, _)| format!("{id}={digest}")).collect();
        assert!(kept.len() > 10, "{kind}: {kept:?}");
        for change in changes {
            let whole = page(&work(&found.text, "", change));
            let sent = page(&work(&found.text, &kept.join(" "), change));
            let (again, named) = whole_again(&sent, &shown);
            assert_eq!(again, whole, "{kind}, {change:?}");
            assert!(named > 3 && !again.contains("data-same"), "{kind}, {change:?}: {named}");
            assert!(sent.len() < whole.len(), "{kind}");
        }
    }
}

/// The promise for the turntable: what a key in a field of its load or its motion moves.
#[test]
fn a_key_in_the_turntable_moves_at_most_sixty_kilobytes() {
    let text = example("turntable", "axis", Language::En).unwrap().text;
    let shown = page(&work(&text, "", ("", "")));
    let kept: Vec<String> = parts(&shown).iter().map(|(id, digest, _)| format!("{id}={digest}")).collect();
    for change in [
        ("mechanism.turntable.body[1].diameter", "610 mm"),
        ("requirements.ambient", "31 degC"),
        ("motion[1].time", "0.93 s"),
    ] {
        let sent = page(&work(&text, &kept.join(" "), change));
        assert!(sent.len() <= 60 * 1024, "{change:?}: {}", sent.len());
    }
}
