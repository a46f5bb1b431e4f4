//! Cost of the page: proportional to the length of the project.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test fails loudly")]

use crate::shell;

use shell::{page, post, whole};
use testkit::cost::processor_time;

/// Returns the keys of a segment, by its index.
type Segment<'s> = &'s dyn Fn(usize) -> String;

/// Returns a project with segments of one kind.
fn project(segment: Segment<'_>, count: usize) -> String {
    let segments: String = (0..count).map(|place| format!("[[motion]]\n{}\n", segment(place))).collect();
    format!("format = 1\n[load]\ninertia = \"0.3 kg m^2\"\n{segments}")
}

fn to_and_fro(place: usize) -> String {
    let sign = if place.is_multiple_of(2) { "" } else { "-" };
    format!("law = \"polynomial_5\"\ndistance = \"{sign}30 deg\"\ntime = \"0.3 s\"")
}

/// Twice as many segments cost at most somewhat more than twice as much: shown, with a fault in each, and with keys that
/// do not belong to them.
#[test]
fn twice_the_segments_cost_twice_the_time() {
    let kinds: [(&str, usize, Segment<'_>); 4] = [
        ("moves", 200, &to_and_fro),
        ("dwells", 800, &|_| String::from("law = \"dwell\"\ntime = \"0.1 s\"")),
        ("faults", 400, &|_| String::from("law = \"dwell\"\ntime = \"0.1\"")),
        ("unknown keys", 400, &|_| String::from("law = \"dwell\"\ntime = \"0.1 s\"\ntme = 1")),
    ];
    for (name, count, segment) in kinds {
        let [once, twice] = [count, 2 * count].map(|count| {
            let text = project(segment, count);
            processor_time(1, || drop(page(&post("/work", &[("text", &text)]))))
        });
        assert!(twice <= 2.5 * once + 0.03, "{name}: {once} s for {count}, {twice} s for twice as many");
    }
}

/// The first and the last group of many segments are shown, and that with the fault or with the focus; the others are sent
/// when they are opened.
#[test]
fn many_segments_are_folded_in_groups() {
    let text = project(&to_and_fro, 420);
    let shows = |html: &str, number: usize| html.contains(&format!("id=\"f-motion-{number}--time\""));
    let html = page(&post("/work", &[("text", &text)]));
    whole(&html);
    assert_eq!(
        [1, 100, 101, 300, 301, 400, 401, 420].map(|n| shows(&html, n)),
        [true, true, false, false, false, false, true, true]
    );
    assert!(html.contains("Segments 101 to 200") && html.contains("Segments 301 to 400"));
    let opened = page(&post("/work", &[("text", &text), ("fold", "f-motion-g201")]));
    assert_eq!([101, 201, 300, 301].map(|n| shows(&opened, n)), [false, true, true, false]);
    let typed = page(&post("/work", &[("text", &text), ("path", "motion[150].time"), ("value", "0.4 s")]));
    assert_eq!([101, 200, 201].map(|n| shows(&typed, n)), [true, true, false]);
    let wrong = text.replacen("0.3 s", "0.3", 350).replacen("\"0.3\"", "\"0.3 s\"", 230);
    let wrong = page(&post("/work", &[("text", &wrong), ("good", &text)]));
    assert_eq!([101, 231, 301].map(|n| shows(&wrong, n)), [false, true, false]);
    // A hundred segments are shown as before.
    let few = page(&post("/work", &[("text", &project(&to_and_fro, 100))]));
    assert!(shows(&few, 50) && !few.contains("Segments 1 to"));
}
