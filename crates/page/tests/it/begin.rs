//! Faults of a beginning, at the fields that they belong to.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use crate::shell;

use shell::{form, get, page};

/// Returns the fault that the answer to a typed value shows at each field, by the identifier of the field.
fn faults(kind: &str, path: &str, typed: &str, unit: &str, lang: &str) -> Vec<(String, String)> {
    let fields = [("kind", kind), ("lang", lang), (path, typed), (&format!("unit.{path}"), unit)];
    let html = page(&get("/begin/drawing", &form(&fields)));
    let plain = |html: &str| html.split('<').map(|part| part.rsplit('>').next().unwrap()).collect::<String>();
    let places = html.split("hx-target=\"#").skip(1);
    let of = |part: &str| {
        let (field, rest) = part.split_once("-x\"").unwrap();
        let inside = rest.split_once('>').unwrap().1.split("</template>").next().unwrap();
        (field.to_owned(), plain(inside))
    };
    places.map(of).collect()
}

/// A wrong value has its fault at its own field, every other field has none, and the field refers to it.
#[test]
fn a_fault_of_a_beginning_is_at_its_field() {
    for (kind, path, unit) in [
        ("0", "load.inertia", "kg m^2"),
        ("0", "motion[1].time", "s"),
        ("3", "mechanism.screw.lead", "mm"),
        ("3", "motion[1].distance", "mm"),
        ("9", "mechanism.scissor_lift.mass", "kg"),
    ] {
        let id = format!("f-{}", path.replace(['[', ']', '.'], "-"));
        let form = page(&get("/begin", &format!("kind={kind}")));
        assert!(
            form.contains(&format!("aria-describedby=\"{id}-x\"")) && form.contains(&format!("id=\"{id}-x\"")),
            "{form}"
        );
        for (typed, is_wrong) in [("fast", true), ("2", false), ("2*", true), ("", false)] {
            let found = faults(kind, path, typed, unit, "en");
            assert!(found.len() >= 4, "{found:?}");
            for (field, fault) in found {
                assert_eq!(!fault.is_empty(), is_wrong && field == id, "{path} = {typed}: {field} {fault}");
            }
        }
    }
}

/// A fault of a number says what to write, in the language of the page.
#[test]
fn a_fault_of_a_number_says_what_to_write() {
    for (typed, lang, words) in [
        ("2*0,3", "en", "decimal point"),
        ("1,000.5", "en", "without separators"),
        ("1.000", "de", "Dezimalkomma"),
        ("1.000,5", "de", "Dezimalkomma"),
        ("1,000.5", "de", "Dezimalkomma"),
        ("5kg*2", "en", "write the unit once, after the whole expression: 2*5 kg"),
        ("5kg*2", "de", "die Einheit einmal"),
        ("1e-400", "en", "too small"),
        ("1e-400", "de", "zu klein"),
        ("2*1e-400", "de", "zu klein"),
        ("1/0", "en", "division by zero"),
        ("1/0", "de", "Division durch null"),
    ] {
        let found = faults("3", "mechanism.screw.mass", typed, "kg", lang);
        let at = found.iter().find(|(field, _)| field == "f-mechanism-screw-mass").unwrap();
        assert!(at.1.contains(words), "{typed} {lang}: {at:?}");
    }
}

/// A fault of a number stands in the line of a segment too, with the unit of its field; a distance that is most likely a slip is remarked.
#[test]
fn a_cell_of_a_segment_says_what_to_write() {
    let of = |law: &str| {
        let text = format!("format = 1\n[load]\ninertia = \"1 kg m^2\"\n[[motion]]\nlaw = \"trapezoid\"\n{law}\n");
        crate::shell::page(&crate::shell::post("/work", &[("text", &text)]))
    };
    let html = of("distance = \"90 deg\"\ntime = \"5kg*2\"");
    let fault = html.split("id=\"f-motion-1--time-x\"").nth(1).unwrap().split("</div>").next().unwrap();
    assert!(fault.contains("after the whole expression: 2*5 s"), "{fault}");
    let list = html.split("id=\"faults\"").nth(1).unwrap().split("id=\"stopped\"").next().unwrap();
    assert!(list.contains("after the whole expression: 2*5 s"), "{list}");
    assert!(of("distance = \"1e9 deg\"\ntime = \"5 s\"").contains("2.78·10⁶ turns"));
    assert!(!of("distance = \"3600 deg\"\ntime = \"5 s\"").contains("long-way"));
}

/// Without a load the right pane leads to what is to be stated.
#[test]
fn next_steps_stand_where_the_actuators_will() {
    let html = crate::shell::page(&crate::shell::post(
        "/work",
        &[("text", "format = 1\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n")],
    ));
    let pane = html.split("id=\"fits\"").nth(1).unwrap();
    assert!(pane.contains("href=\"#mechanism\"") && pane.contains("still open"), "{pane}");
    assert!(pane.contains("href=\"#f-motion-t\"") && pane.contains("Motion: stated"), "{pane}");
}
