//! Theory behind the models: the chapters of `docs/theory`, to which the derivation of a number leads.
//!
//! Chapters exist in both languages, each at an address of its own: `/theory/gear.html` in English, `/theory/de/gear.html` in German. The
//! server sends them, and the writer of the static folder writes them as files; the engine in the browser does not contain them.
//! Sections for developers are in the books of the repository alone; keys of the project file and checks appear with the names that the
//! page gives them.

use crate::call::Reply;
use crate::find::walk;
use crate::markup::label_within;
use maud::{DOCTYPE, Markup, PreEscaped, html};
use project::KEYS;
use pulldown_cmark::{CodeBlockKind, CowStr, Event, LinkType, Options, Parser, Tag, TagEnd};
use quantities::Language;
use questions::CheckId;
use words::{capitalised, chapter_name, check_title, page};

/// Files of the theory with their texts, in the order of [`Language::ALL`].
macro_rules! files {
    ($folder:literal: $($name:literal)*) => { [$(($name, [
        include_str!(concat!("../../../docs/theory/", $folder, $name)),
        include_str!(concat!("../../../docs/theorie/", $folder, $name)),
    ])),*] };
}

/// Texts of a file, in the order of [`Language::ALL`].
type Texts = [&'static str; 2];

const CHAPTERS: [(&str, Texts); 24] = files![
    "": "battery.md" "brake.md" "continuous-torque.md" "current.md" "demand.md" "energy.md" "error-budget.md" "feedback.md"
    "flange-loads.md" "gear.md" "mechanisms.md" "moments.md" "motion-laws.md" "output-bearing.md" "overload.md"
    "recorded-motion.md" "screw-joint.md" "short-time-torque.md" "stage.md" "sweep.md" "thermal.md" "tolerances.md" "twin.md" "voltage.md"
];
const PICTURES: [(&str, Texts); 2] = files!["pictures/": "continuous-20A.svg" "heat-shares.svg"];

/// Returns the text in a language.
fn text_in(texts: &Texts, language: Language) -> &'static str {
    Language::ALL.iter().zip(texts).find(|(each, _)| **each == language).map_or("", |(_, text)| text)
}

/// Returns the paths of all files of the theory, in both languages.
pub fn theory_files() -> impl Iterator<Item = String> {
    Language::ALL.into_iter().flat_map(|language| {
        let folder = page::theory_folder(language);
        let chapters = CHAPTERS.iter().map(move |(name, _)| format!("{folder}{}", name.replace(".md", ".html")));
        chapters.chain(PICTURES.iter().map(move |(name, _)| format!("{folder}pictures/{name}")))
    })
}

/// Returns language and name of a file of the theory by its path; the folders of the languages lie within that of the first one.
fn named(path: &str) -> Option<(Language, &str)> {
    let path = path.strip_prefix('/')?;
    Language::ALL
        .into_iter()
        .rev()
        .find_map(|language| Some((language, path.strip_prefix(page::theory_folder(language))?)))
}

/// Returns the language of a file of the theory by its path; `None` for any other path.
pub(crate) fn language_of(path: &str) -> Option<Language> {
    named(path).map(|(language, _)| language)
}

/// Returns a file of the theory by its path; `None` for a path outside the theory.
pub(crate) fn file(path: &str) -> Option<Reply> {
    let (language, name) = named(path)?;
    if let Some((_, texts)) =
        name.strip_prefix("pictures/").and_then(|name| PICTURES.iter().find(|(of, _)| *of == name))
    {
        return Some(Reply::of(200, "image/svg+xml", text_in(texts, language)));
    }
    let chapter = name
        .strip_suffix(".html")
        .and_then(|name| CHAPTERS.iter().find(|(of, _)| of.strip_suffix(".md") == Some(name)));
    Some(match chapter {
        Some((name, texts)) => Reply::of(200, crate::HTML, shown(name, text_in(texts, language), language)),
        None => Reply::text(404, page::no_such_page(language)),
    })
}

/// Headings of the sections that describe the program to its developers.
const FOR_DEVELOPERS: [&str; 4] = ["In the code", "Cost", "Speed", "Four at a time"];

/// Returns a chapter as a page; the drawer of the workbench shows its article.
fn shown(name: &str, text: &str, language: Language) -> String {
    let l = language;
    let (title, body) = set(text, l);
    let none = html! {};
    // The way up from the folder of the language.
    let up = "../".repeat(page::theory_folder(l).matches('/').count());
    let head = crate::frame::head(&none, &format!("{title} – antrieb"), &format!("{up}assets/page.css"), &none);
    html! {
        (DOCTYPE)
        html lang=(l.id()) {
            (head)
            body.theory {
                header id="head" { h1 { a.brand href=(up) { (crate::markup::logo()) "antrieb" } } }
                main {
                    p.small { (page::about_the_theory(l)) }
                    (chapters(name, l))
                    article id="theory" { (PreEscaped(body)) }
                }
            }
        }
    }
    .into_string()
}

/// Returns the list of all chapters.
fn chapters(own: &str, language: Language) -> Markup {
    let id = |name: &'static str| name.strip_suffix(".md").unwrap_or(name);
    html! {
        details.chapters {
            summary { (page::chapters_of_the_theory(language)) }
            ul { @for (name, _) in CHAPTERS { li {
                a href={ (id(name)) ".html" } aria-current=[(name == own).then_some("page")] { (capitalised(chapter_name(id(name), language))) }
            } } }
        }
    }
}

/// Returns the words for program text of a chapter: the label of a key, the title of a check; `None` for a quotation.
fn in_words(code: &str, language: Language) -> Option<String> {
    let l = language;
    let last = |path: &str| path.rsplit('.').next() == Some(code);
    let of_check = || CheckId::ALL.iter().find(|id| id.id() == code).map(|id| check_title(*id, l));
    let of_key = || {
        let mut found = None;
        let is_name = code.bytes().all(|byte| byte == b'_' || byte.is_ascii_lowercase()) && code.contains('_');
        walk(KEYS, "", &mut |path, _| {
            if found.is_none() && is_name && last(path) {
                found = label_within(path, l);
            }
        });
        found
    };
    of_check().or_else(|| label_within(code, l)).or_else(of_key)
}

/// Returns title and text of a chapter as HTML: headings have anchors, links within the theory lead to its pages, other
/// links become plain words, and HTML in the text is shown literally.
fn set(text: &str, language: Language) -> (String, String) {
    let mut events = for_engineers(Parser::new_ext(text, Options::ENABLE_TABLES).collect(), language);
    let mut title = String::new();
    let mut heading: Option<(usize, String)> = None;
    let mut anchors = Vec::new();
    let mut is_out = false;
    for (place, event) in events.iter_mut().enumerate() {
        match event {
            Event::Start(Tag::Heading { .. }) => heading = Some((place, String::new())),
            Event::End(TagEnd::Heading(_)) => {
                if let Some((begin, words)) = heading.take() {
                    anchors.push((begin, anchor(&words)));
                    if title.is_empty() {
                        title = words;
                    }
                }
            }
            Event::Text(words) | Event::Code(words) => {
                if let Some((_, so_far)) = &mut heading {
                    so_far.push_str(words);
                }
            }
            // The marks of a formula alone are HTML.
            Event::InlineHtml(written) if [FORMULA, FORMULA_END].contains(&&**written) => {}
            Event::Html(written) | Event::InlineHtml(written) => {
                *event = Event::Text(std::mem::replace(written, CowStr::Borrowed("")))
            }
            Event::Start(Tag::Link { link_type: LinkType::Inline, dest_url, .. }) => match within(dest_url) {
                Some(address) => *dest_url = address.into(),
                None => {
                    is_out = true;
                    *event = Event::Text(CowStr::Borrowed(""));
                }
            },
            Event::End(TagEnd::Link) if is_out => {
                is_out = false;
                *event = Event::Text(CowStr::Borrowed(""));
            }
            _ => {}
        }
    }
    for (place, anchor) in anchors {
        if let Some(Event::Start(Tag::Heading { id, .. })) = events.get_mut(place) {
            *id = Some(anchor.into());
        }
    }
    let mut out = String::with_capacity(2 * text.len());
    pulldown_cmark::html::push_html(&mut out, events.into_iter());
    (title, out)
}

/// Returns a chapter without the sections for developers; formulas, which stand indented, as text, so that their symbols are set.
fn for_engineers(events: Vec<Event<'_>>, language: Language) -> Vec<Event<'_>> {
    let mut kept: Vec<Event<'_>> = Vec::with_capacity(events.len());
    let mut is_left_out = false;
    let mut is_formula = false;
    for (place, event) in events.iter().enumerate() {
        if let Event::Start(Tag::Heading { level, .. }) = event
            && *level as usize <= 2
        {
            let title = events.get(place + 1);
            is_left_out = matches!(title, Some(Event::Text(title)) if FOR_DEVELOPERS.contains(&&**title));
        }
        if is_left_out {
            continue;
        }
        match event {
            Event::Start(Tag::CodeBlock(CodeBlockKind::Indented)) => {
                is_formula = true;
                kept.push(Event::InlineHtml(CowStr::Borrowed(FORMULA)));
            }
            Event::End(TagEnd::CodeBlock) if is_formula => {
                is_formula = false;
                kept.push(Event::InlineHtml(CowStr::Borrowed(FORMULA_END)));
            }
            // A label is quoted: a sentence does not inflect it.
            Event::Code(code) => match in_words(code, language) {
                Some(words) => {
                    kept.extend([Event::Start(Tag::Emphasis), Event::Text(words.into()), Event::End(TagEnd::Emphasis)])
                }
                None => kept.push(event.clone()),
            },
            event => kept.push(event.clone()),
        }
    }
    kept
}

/// Beginning and end of a formula.
const FORMULA: &str = "<pre class=\"formula\" tabindex=\"0\">";
const FORMULA_END: &str = "</pre>\n";

/// Returns the address of a link within the theory, in terms of its pages; `None` for a link that leads out of it.
fn within(address: &str) -> Option<String> {
    let (file, anchor) = address.split_once('#').map_or((address, None), |(file, anchor)| (file, Some(anchor)));
    if !file.is_empty() && !CHAPTERS.iter().any(|(name, _)| *name == file) {
        return None;
    }
    let file = file.replace(".md", ".html");
    Some(anchor.map_or_else(|| file.clone(), |anchor| format!("{file}#{anchor}")))
}

/// Returns the identifier of a heading, as the links of the documents write it.
fn anchor(words: &str) -> String {
    let kept = words.chars().filter(|sign| sign.is_alphanumeric() || matches!(sign, ' ' | '-' | '_'));
    kept.flat_map(char::to_lowercase).map(|sign| if sign == ' ' { '-' } else { sign }).collect()
}

#[cfg(test)]
mod tests;
