//! A further axis, the views about the actuator, and the tools as a list.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use crate::shell;

use quantities::Language;
use questions::list::new::{template, template_kinds};
use shell::{get, page, post, whole};

/// Returns the text of a project as the page holds it.
fn text_of(html: &str) -> String {
    let inside = html.split("id=\"text\"").nth(1).and_then(|rest| rest.split_once('>')).map(|(_, rest)| rest).unwrap();
    let text = inside.split("</textarea>").next().unwrap().trim_start_matches('\n');
    text.replace("&quot;", "\"").replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&")
}

/// Returns the fields of a form to begin, each with the value that it proposes.
fn proposed(place: &str) -> Vec<(String, String)> {
    let form = page(&get("/begin", &format!("further=&kind={place}&lang=en")));
    whole(&form);
    assert!(form.contains("hx-post=\"/work\""), "{form}");
    let attribute = |tag: &str, name: &str| {
        let rest = tag.split(&format!(" {name}=\"")).nth(1)?;
        Some(rest.split('"').next()?.to_owned())
    };
    let mut fields = Vec::new();
    for tag in form.split('<').filter(|tag| tag.starts_with("input ") || tag.starts_with("select ")) {
        let Some(name) = attribute(tag, "name") else { continue };
        let value = if tag.starts_with("select ") {
            let options = form.split(&format!("name=\"{name}\"")).nth(1).unwrap().split("</select>").next().unwrap();
            let chosen = options.split("<option ").find(|option| option.contains(" selected"));
            let first =
                options.split("<option ").find(|option| !option.contains("value=\"\"") && option.contains("value="));
            chosen.or(first).and_then(|option| attribute(&format!(" {option}"), "value")).unwrap()
        } else {
            attribute(tag, "value")
                .or_else(|| attribute(tag, "placeholder"))
                .unwrap_or_default()
                .replace("example: ", "")
        };
        fields.push((name, value));
    }
    fields
}

/// Every example takes every kind of further axis; both are shown, and all of them together have their powers.
#[test]
fn a_further_axis_is_added_to_any_project() {
    let tiles = page(&get("/axis", "lang=de"));
    whole(&tiles);
    let places: Vec<&str> = tiles.split("id=\"further-").skip(1).filter_map(|rest| rest.split('"').next()).collect();
    assert!(places.len() > 8, "{tiles}");
    let kinds: Vec<&str> = template_kinds().filter(|kind| !matches!(*kind, "recording" | "joint")).collect();
    for turn in 0..kinds.len().max(places.len()) {
        let (kind, place) = (kinds[turn % kinds.len()], places[turn % places.len()]);
        let text = template(kind, "axis.toml", Language::En).unwrap().text;
        let typed = proposed(place);
        let fields = typed.iter().map(|(name, value)| (name.as_str(), value.as_str()));
        let fields: Vec<(&str, &str)> = [("text", text.as_str())].into_iter().chain(fields).collect();
        let html = page(&post("/work", &fields));
        let joined = text_of(&html);
        assert_eq!(joined.matches("[[axis]]").count(), text.matches("[[axis]]").count().max(1) + 1, "{kind}\n{joined}");
        let read = questions::read_all(&joined, &axis::NoFiles);
        assert!(read.is_ok(), "{kind} {place} {typed:?}\n{joined}\n{read:?}");
        let html = page(&post("/work", &[("text", &joined), ("axis", "all")]));
        assert!(html.contains("id=\"power-of-axes\"") && html.contains("<svg"), "{kind}: {html}");
    }
}

/// The views about the actuator request their tools with the code that is shown, and have no field for it.
#[test]
fn the_views_follow_the_actuator() {
    let text = template("arm", "axis.toml", Language::En).unwrap().text;
    for (view, tool) in [
        ("data_sheet", "data"),
        ("wiring", "wiring"),
        ("mounting", "mount"),
        ("commissioning", "commission"),
        ("encoder", "encoder"),
        ("maintenance", "upkeep"),
    ] {
        for code in ["CHA-17A-100-H-M128S-B", "CHA-25A-50-H-C1024"] {
            let html = page(&post("/work", &[("text", &text), ("view", view), ("code", code)]));
            let place =
                html.split(&format!("id=\"view-tool-{tool}\"")).nth(1).unwrap_or_else(|| panic!("{view}: {html}"));
            let asked = place.split('>').next().unwrap();
            assert!(asked.contains(code) && asked.contains("within"), "{asked}");
            for lang in ["en", "de"] {
                let fields = [("tool", tool), ("about", code), ("within", "view"), ("text", &text), ("lang", lang)];
                let form = page(&post("/tools", &fields));
                whole(&form);
                assert!(form.starts_with("<form id=\"tool-view\"") && !form.contains("id=\"about\""), "{form}");
                assert!(form.len() > 800, "{tool}: {form}");
            }
        }
    }
}
