//! The page as its readers see it: no internal identifier and, in German, no English, but for keys to type and what stands in code.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails loudly")]

use crate::shell;

use page::{Call, Method, respond};
use quantities::Language;
use questions::Progress;
use questions::list::new::{example, template_kinds};
use shell::{Alone, form, get, page};
use testkit::readers::{english, identifiers, text_of};

fn worked(path: &str, fields: &[(&str, &str)], language: Language) -> String {
    let body = form(fields);
    let media = Some("application/x-www-form-urlencoded");
    let call = Call { method: Method::Post, path, query: "", media, body: body.as_bytes(), language };
    page(&respond(&call, &Alone, &Progress::endless()))
}

fn faults(place: &str, html: &str, language: Language) -> Vec<String> {
    let text = text_of(html);
    // Keys of the project file are what the reader types.
    let text = words::without_keys(&text, language);
    let mut found: Vec<String> = identifiers(&text).into_iter().collect();
    if language == Language::De {
        let names = catalogue::documents().iter().flat_map(|found| [found.title, found.short]);
        let own = names.fold(text.into_owned(), |text, name| text.replace(name, ""));
        found.extend(english(&own));
    }
    found.into_iter().map(|found| format!("{place} {}: {found}", language.id())).collect()
}

#[test]
fn no_page_shows_an_identifier_or_the_other_language() {
    let mut found = Vec::new();
    for language in Language::ALL {
        let lang = language.id();
        for kind in template_kinds().filter(|kind| !matches!(*kind, "recording" | "joint")) {
            let text = example(kind, "axis.toml", language).unwrap().text;
            let html = worked("/work", &[("text", &text), ("lang", lang)], language);
            assert!(html.contains("id=\"plot-cycle\""), "{kind}");
            found.extend(faults(kind, &html, language));
        }
        let text = example("arm", "axis.toml", language).unwrap().text;
        let rejected = worked("/work", &[("text", &text), ("list", "rejected"), ("lang", lang)], language);
        found.extend(faults("rejected", &rejected, language));
        for path in ["/", "/gallery", "/keys"] {
            found.extend(faults(path, &page(&get(path, &format!("lang={lang}"))), language));
        }
    }
    found.sort();
    found.dedup();
    assert!(found.is_empty(), "{} faults\n{}", found.len(), found.join("\n"));
}
