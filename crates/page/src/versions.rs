//! Versions of a session: the changes from one to the next, in the words of the form.

use crate::call::Call;
use maud::{Markup, html};
use project::{input_changes, key_at, written};
use quantities::Language;
use words::{about_text, capitalised, page, short_label};

/// Returns the versions of the call, the latest first, each with its changes.
pub(crate) fn listed(call: &Call<'_>) -> Markup {
    let l = call.language();
    let texts: Vec<String> = call.all("version").map(|text| text.replace("\r\n", "\n")).collect();
    let pairs = texts.iter().zip(texts.iter().skip(1));
    let count = texts.len();
    let inside = html! {
        @if count < 2 { p { (page::no_versions(l)) } }
        ol.entries reversed { @for (place, (before, after)) in pairs.enumerate().collect::<Vec<_>>().into_iter().rev() {
            li.entry {
                ul.plain { @for change in changes(before, after, l) { li { (change) } } }
                @if place + 2 < count { (back(after, l)) } @else { span.small { (page::this_version(l)) } }
            }
        } }
        @if let Some(first) = texts.first().filter(|_| count > 1) { div.entry { (page::first_version(l)) " " (back(first, l)) } }
    };
    crate::markup::drawer(page::versions(l), &inside, l)
}

fn back(text: &str, language: Language) -> Markup {
    html! { div { textarea hidden readonly { (crate::markup::kept(text)) } button.small type="button" data-version="" { (page::back_to_version(language)) } } }
}

/// Returns the changes of a version in all axes, a line each.
fn changes(before: &str, after: &str, language: Language) -> Vec<String> {
    let axes = |text: &str| {
        let keys = written(text).unwrap_or_default();
        (1..).take_while(|place| keys.iter().any(|key| key.path.starts_with(&format!("axis[{place}]")))).count().max(1)
    };
    let mut lines = Vec::new();
    for axis in 0..axes(before).max(axes(after)) {
        for change in input_changes((before, axis), (after, axis)) {
            let name = key_at(&change.path).map(|key| capitalised(&short_label(about_text(key.about, language))));
            let shown = |value: &Option<String>| value.clone().unwrap_or_else(|| String::from("–"));
            let line = format!(
                "{}: {} → {}",
                name.unwrap_or_else(|| change.path.clone()),
                shown(&change.old),
                shown(&change.new)
            );
            if !lines.contains(&line) {
                lines.push(line);
            }
        }
    }
    if lines.is_empty() {
        lines.push(page::only_layout(language).to_owned());
    }
    lines
}
