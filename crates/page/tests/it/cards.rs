//! The cards of a project that no actuator of the catalogue fits: each change of the cycle or the load has a button, and
//! with it the axis is judged as the card says.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test fails loudly")]

use crate::shell;

use page::{Call, Method, respond};
use quantities::Language;
use questions::Progress;
use shell::{Alone, form, page, post};

const LOAD: &str = "format = 1\n[load]\ninertia = \"200 kg m^2\"\n";

/// Returns a to-and-fro motion with a payload, of a number of strokes.
fn strokes(count: usize) -> String {
    let one = |way: &str| {
        format!(
            "[[motion]]\nlaw = \"polynomial_5\"\ndistance = \"{way}60 deg\"\ntime = \"0.8 s\"\npayload_inertia = \"30 kg m^2\"\n"
        )
    };
    format!("{LOAD}{}", format!("{}{}", one(""), one("-")).repeat(count))
}

/// A card: its title, the actuator, and the fields of its button.
type Card = (String, String, Option<Vec<(String, String)>>);

/// Returns each card.
fn cards(text: &str) -> Vec<Card> {
    let html = page(&post("/would-fit", &[("text", text)]));
    let cut = |html: &str, from: &str, to: &str| Some(html.split_once(from)?.1.split_once(to)?.0.to_owned());
    let card = |html: &str| {
        let fields = cut(html, "hx-vals=\"", "\"").map(|json| {
            let json: std::collections::BTreeMap<String, String> =
                serde_json::from_str(&json.replace("&quot;", "\"")).unwrap();
            json.into_iter().collect()
        });
        (cut(html, "<h4>", "</h4>").unwrap(), cut(html, "class=\"code\">", "<").unwrap(), fields)
    };
    html.split("<article").skip(1).map(card).collect()
}

#[test]
fn every_card_of_cycle_and_load_has_a_button_that_leads_to_its_verdict() {
    // Of a long cycle the changes are sought for the nearest actuators of some sizes and ratios.
    for (count, titles) in [(1, ["Longer cycle", "Smaller load"]), (130, ["Longer cycle", "Smaller load"])] {
        let text = strokes(count);
        let found = cards(&text);
        for title in &titles {
            let (_, code, fields) =
                found.iter().find(|(of, ..)| of == title).unwrap_or_else(|| panic!("{title} of {count}: {found:?}"));
            let fields = fields.as_ref().unwrap_or_else(|| panic!("{title} of {count} without a button"));
            let mut sent: Vec<(&str, &str)> =
                fields.iter().map(|(name, value)| (name.as_str(), value.as_str())).collect();
            sent.push(("text", &text));
            let html = page(&post("/work", &sent));
            let standing = html.split("id=\"standing\"").nth(1).unwrap().split("</p>").next().unwrap();
            assert!(standing.contains(code.as_str()), "{title} of {count}: {code}, {standing}");
        }
    }
}

/// Returns the cards of a project with the progress of their work.
fn watched(text: &str, more: &[(&str, &str)], progress: &Progress) -> String {
    let mut fields = vec![("text", text)];
    fields.extend(more);
    let body = form(&fields);
    let media = Some("application/x-www-form-urlencoded");
    let call = Call {
        method: Method::Post,
        path: "/would-fit",
        query: "",
        media,
        body: body.as_bytes(),
        language: Language::En,
    };
    page(&respond(&call, &Alone, progress))
}

/// Cost of the cards in judgements of an actuator.
#[test]
fn the_cards_take_some_ten_thousand_judgements_at_most() {
    /// Rankings of the catalogue, each of 276 actuators, in which most are ruled out by bounds.
    const MOST: usize = 40_000;
    for count in [1, 3, 130] {
        let progress = Progress::endless();
        let _ = watched(&strokes(count), &[], &progress);
        let (done, _) = progress.progress();
        assert!((1..MOST).contains(&done), "{done} judgements for {count} strokes");
    }
}
