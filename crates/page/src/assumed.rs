//! The strip of assumptions at the top of the left pane: each with its value, and the ways to state it.

use crate::markup::{id, label_of, vals};
use crate::parts::part;
use crate::value::said;
use axis::{AssumedKeys, AxisProject};
use maud::{Markup, html};
use project::{Kind, Written, key_at};
use quantities::Language;
use words::{assumption_text, capitalised, key_word, page, without_keys};

/// Returns the strip; empty without assumptions. `prefix`: `axis[2].` in a file with several axes.
pub(crate) fn assumptions(project: &AxisProject, written: &[Written], prefix: &str, language: Language) -> Markup {
    let l = language;
    let found = project.assumed();
    // What a key decides comes first; the conditions of the manufacturer follow.
    let (open, others): (Vec<&AssumedKeys>, Vec<&AssumedKeys>) = found.iter().partition(|each| !each.keys.is_empty());
    if found.is_empty() {
        return html! {};
    }
    part(html! {
            details.assumed id="assumptions" open {
                summary { (page::assumed_title(l)) " (" (found.len()) ")" }
                ul {
                    @for each in open.into_iter().chain(others) { li id=[each.keys.first().map(|key| format!("assumed-{}", id(key)))] { (entry(each, written, prefix, l)) } }
                }
            }
    })
}

/// Returns one assumption.
fn entry(each: &AssumedKeys, written: &[Written], prefix: &str, language: Language) -> Markup {
    let l = language;
    let why = capitalised(&without_keys(&assumption_text(each.assumption, l), l));
    let Some(key) = each.keys.first() else { return html! { span.why { (why) } } };
    let label = label_of(key, l).unwrap_or_default();
    let value = each.value.as_deref().map(|value| shown(key, value, l));
    let states =
        |value: &str| each.keys.iter().map(|key| format!("value {key}={value}")).collect::<Vec<_>>().join("\n");
    let usual = each.usual.as_deref().map(|value| (value, shown(key, value, l)));
    let about = |what: &str| format!("{what}: {label}");
    html! {
        details.what {
            summary { (crate::markup::label(&label)) ": " b { @match &value { Some(value) => (value), None => (page::assumed_not_checked(l)) } } }
            p.why { (why) }
        }
        span.ways {
            @if let Some(value) = each.value.as_ref().filter(|_| each.is_alone) {
                button.small type="button" aria-label=(about(page::assumed_take(l))) hx-post="/work" hx-vals=(vals(&[("do", &states(value))])) { (page::assumed_take(l)) }
            }
            @if let Some((value, text)) = &usual {
                button.small type="button" aria-label=(about(&format!("{} {text}", page::assumed_take(l)))) hx-post="/work" hx-vals=(vals(&[("do", &states(value))])) { (text) }
            }
            @match each.value.as_ref().filter(|_| each.is_alone) {
                Some(value) => button.small type="button" data-change=(id(key)) aria-label=(about(page::assumed_change(l))) hx-post="/work" hx-vals=(vals(&[("do", &states(value))])) { (page::assumed_change(l)) },
                None => a.small href={ "#" (id(key)) } aria-label=(about(page::assumed_change(l))) { (page::assumed_change(l)) },
            }
            @if let Some(word) = each.assumption.left_out() {
                @let list = left_out(written, prefix, word.id());
                button.small type="button" aria-label=(about(page::assumed_leave_out(l))) hx-post="/work" hx-vals=(vals(&[("do", &format!("value {prefix}requirements.leave_out={list}"))])) { (page::assumed_leave_out(l)) }
            }
        }
    }
}

/// Returns the list of what is left out, with one word more.
fn left_out(written: &[Written], prefix: &str, word: &str) -> String {
    let path = format!("{prefix}requirements.leave_out");
    let stated = written.iter().find(|key| key.path == path).and_then(|key| key.value.as_deref()).unwrap_or_default();
    let kept = stated.split(',').map(str::trim).filter(|each| !each.is_empty() && *each != word);
    kept.chain([word]).collect::<Vec<_>>().join(", ")
}

/// Returns a value of a key in words of the page: its word, or its number with the symbol of the unit.
fn shown(path: &str, value: &str, language: Language) -> String {
    let key = key_at(path);
    if let Some(key) = key.filter(|key| matches!(key.kind, Kind::OneOf(_))) {
        let word = key_word(key.name, value, language);
        return word.map_or_else(|| value.to_owned(), |word| word.into_owned());
    }
    said(value, language)
}
