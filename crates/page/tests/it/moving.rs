//! Dynamic parts of the page from outside: work that ends early, dragged ends, time windows, recordings.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use axis::{Catalogue, Files};
use page::{Call, Method, Reply, Shell, respond};
use quantities::Language;
use questions::Progress;
use questions::list::new::example;
use std::io::{Cursor, Error, ErrorKind, Read, Result};
use std::sync::Arc;
use std::time::Duration;

/// A shell with one recording.
struct OneRecording(&'static str);

impl Files for OneRecording {
    fn open(&self, name: &str) -> Result<Box<dyn Read>> {
        if name == "log.csv" { Ok(Box::new(Cursor::new(self.0))) } else { Err(Error::from(ErrorKind::NotFound)) }
    }
}

impl Shell for OneRecording {
    fn files(&self) -> &dyn Files {
        self
    }

    fn catalogue(&self) -> &Arc<dyn Catalogue> {
        questions::embedded_catalogue()
    }

    fn time_limit(&self) -> Option<Duration> {
        Some(Duration::from_secs(7))
    }

    fn progress(&self, work: &str) -> Option<(usize, Option<usize>)> {
        (work == "mine").then_some((40, Some(160)))
    }

    fn cancel(&self, work: &str) -> bool {
        work == "mine"
    }

    fn version(&self, bytes: &[u8]) -> String {
        bytes.iter().fold(7_u64, |sum, byte| sum.wrapping_mul(31).wrapping_add(u64::from(*byte))).to_string()
    }
}

const LOG: &str = "zeit [s];gemessen;drehmoment [Nm];M [Nm]\n0,0;0;1;2\n0,1;5;1;2\n0,2;10;1;2\n0,3;5;1;2\n0,4;0;1;2\n";

fn ask(path: &str, fields: &[(&str, &str)], progress: &Progress) -> Reply {
    let one = |(key, value): &(&str, &str)| {
        let code = |text: &str| text.bytes().map(|byte| format!("%{byte:02x}")).collect::<String>();
        format!("{}={}", code(key), code(value))
    };
    let body = fields.iter().map(one).collect::<Vec<_>>().join("&");
    let media = Some("application/x-www-form-urlencoded");
    let call = Call { method: Method::Post, path, query: "", media, body: body.as_bytes(), language: Language::En };
    respond(&call, &OneRecording(LOG), progress)
}

fn page(path: &str, fields: &[(&str, &str)]) -> String {
    let reply = ask(path, fields, &Progress::endless());
    assert_eq!(reply.status, 200);
    String::from_utf8(reply.body).unwrap()
}

fn belt() -> String {
    example("belt", "axis.toml", Language::En).unwrap().text
}

/// Returns the text of the project within the page.
fn text_in(html: &str) -> String {
    let field = html.split("id=\"text\"").nth(1).unwrap();
    let inside = field.split_once('>').unwrap().1.split_once("</textarea>").unwrap().0;
    inside.replace("&quot;", "\"").replace("&amp;", "&")
}

/// Returns a number of an attribute of the first plane of the cycle.
fn of_plane(html: &str, attribute: &str) -> f64 {
    let plane = html.split("id=\"plot-cycle\"").nth(1).unwrap().split("class=\"plane").nth(1).unwrap();
    let value = plane.split(&format!("{attribute}=\"")).nth(1).unwrap().split('"').next().unwrap();
    value.parse().unwrap()
}

#[test]
fn work_that_ends_early_takes_the_change_and_leaves_the_result_in_its_place() {
    let text = belt();
    let fields = [("text", text.as_str()), ("path", "mechanism.belt.mass"), ("value", "21 kg")];
    for (is_late, words) in [(true, "answered within 7 s"), (false, "Cancelled")] {
        let progress = Progress::limited();
        if is_late {
            progress.expire()
        } else {
            progress.cancel()
        };
        let reply = ask("/work", &fields, &progress);
        assert!(reply.headers.contains(&("hx-reswap", String::from("none"))), "{:?}", reply.headers);
        let html = String::from_utf8(reply.body).unwrap();
        assert!(html.contains(words) && html.contains("the one before the change") && html.contains("id=\"again\""));
        assert!(text_in(&html).contains("mass = \"21 kg\""), "the change is kept");
        assert!(
            !html.contains("id=\"plot-cycle\"") && !html.contains("id=\"demands\""),
            "nothing is put in place of the result"
        );
        for target in ["#state", "#moves", "#stopped"] {
            assert!(html.contains(&format!("hx-target=\"{target}\"")), "{target}");
        }
    }
    let over = Progress::limited();
    over.cancel();
    let first = String::from_utf8(ask("/", &[("text", &text)], &over).body).unwrap();
    assert!(
        first.contains("Cancelled")
            && first.contains("No result until")
            && first.contains("id=\"f-mechanism-belt-mass\"")
    );
}

#[test]
fn progress_is_told_in_words_and_a_work_is_cancelled_by_its_name() {
    let get = |query: &str| {
        let call =
            Call { method: Method::Get, path: page::PROGRESS, query, media: None, body: &[], language: Language::De };
        let reply = respond(&call, &OneRecording(LOG), &Progress::endless());
        (reply.status, String::from_utf8(reply.body).unwrap())
    };
    assert_eq!(get("work=mine"), (200, String::from("Rechnet 25 %")));
    assert_eq!(get("work=other").0, 404);
    let cancel = |work| ask(page::CANCEL, &[("work", work)], &Progress::endless()).status;
    assert_eq!((cancel("mine"), cancel("other")), (200, 404));
}

#[test]
fn tolerances_are_offered_and_judged() {
    let plain = belt();
    assert!(!page("/work", &[("text", &plain)]).contains("id=\"tolerances\""));
    let text = plain.replace("mass = \"18 kg\"", "mass = \"18 kg ± 10 %\"");
    let html = page("/work", &[("text", &text), ("view", "error_budget")]);
    assert!(html.contains("id=\"tolerances\"") && html.contains("data-at-once"), "few samples are judged at once");
    let found = page("/tolerances", &[("text", &text), ("samples", "40")]);
    assert!(found.contains("40 samples"), "{found}");
    assert!(found.contains("<td>Moved mass</td>") && found.contains("16.2") && found.contains("19.8"), "{found}");
    assert!(found.contains("% of the samples"), "{found}");
}

#[test]
fn a_tolerance_is_written_beside_its_value_and_taken_away() {
    let text = belt();
    let put = |text: &str, nominal: &str, band: &str| {
        let fields = [("text", text), ("path", "mechanism.belt.mass"), ("nominal", nominal), ("band", band)];
        text_in(&page("/work", &fields))
    };
    let with = put(&text, "18 kg", "5 %");
    assert!(with.contains("mass = \"18 kg ± 5 %\""), "{with}");
    let other = put(&with, "18 kg ± 5 %", "± 1 kg");
    assert!(other.contains("mass = \"18 kg ± 1 kg\""), "{other}");
    assert_eq!(put(&other, "18 kg ± 1 kg", " "), text);
}

#[test]
fn the_end_of_a_segment_is_pulled_and_its_text_follows() {
    let text = belt();
    let html = page("/work", &[("text", &text)]);
    // The law with limited jerk ends after 1.8625 s at 800 mm.
    assert!(
        html.contains("id=\"grip-0\"") && html.contains("data-goes=\"true\"") && html.contains("800.0\u{a0}mm"),
        "{html}"
    );
    let pulled = page("/work", &[("text", &text), ("path", "motion[3]"), ("pulled", "1.4 -400 2.8 -800")]);
    let changed = text_in(&pulled);
    assert!(changed.contains("distance = \"-400 mm\"\ntime = \"1.4 s\""), "{changed}");
    // The way back follows in the same change, so that the cycle stays closed.
    assert!(changed.contains("distance = \"400 mm\"") && !changed.contains("800 mm"), "{changed}");
    assert!(pulled.contains("id=\"grip-0\"") && !pulled.contains("id=\"way-back\""));
    for hostile in ["", "1", "a b c d", "0 1 1 1", "1 1 0 0", "inf 1 1 1", "1 1 1 1 1 1"] {
        let same = page("/work", &[("text", &text), ("path", "motion[3]"), ("pulled", hostile)]);
        assert_eq!(text_in(&same), text, "{hostile}");
    }
}

/// Types another distance into a cycle of the second of two axes.
#[test]
fn a_typed_distance_takes_the_way_back_of_its_own_axis_along() {
    let axis = |name: &str| {
        format!(
            "[[axis]]\nname = \"{name}\"\n[axis.mechanism.screw]\nlead = \"10 mm\"\nmass = \"20 kg\"\n[[axis.motion]]\nlaw = \"trapezoid\"\n\
             distance = \"300 mm\"\ntime = \"1 s\"\n[[axis.motion]]\nlaw = \"trapezoid\"\ndistance = \"-300 mm\"\ntime = \"2 s\"\n"
        )
    };
    let text = format!("format = 1\n{}{}", axis("x"), axis("y"));
    let html = page(
        "/work",
        &[("text", &text), ("good", &text), ("axis", "1"), ("path", "axis[2].motion[1].distance"), ("value", "410 mm")],
    );
    let changed = text_in(&html);
    let (first, second) = changed.split_once("name = \"y\"").unwrap();
    assert!(first.contains("\"300 mm\"") && first.contains("\"-300 mm\""), "{changed}");
    assert!(second.contains("\"410 mm\"") && second.contains("\"-410 mm\""), "{changed}");
    // A change elsewhere closes nothing; the buttons do.
    let open = text.replacen("\"300 mm\"", "\"290 mm\"", 1);
    let html = page("/work", &[("text", &open), ("good", &text), ("axis", "0")]);
    assert_eq!(text_in(&html), open);
    assert!(html.contains("close axis[1].") && html.contains("value axis[1].single_move=true"), "{html}");
    let shut = text_in(&page("/work", &[("text", &open), ("good", &text), ("axis", "0"), ("do", "close axis[1].")]));
    // The shorter way follows the longer one.
    assert_eq!(shut, text);
}

#[test]
fn segments_are_doubled_and_moved_up() {
    let text = belt();
    let doubled = text_in(&page("/work", &[("text", &text), ("do", "twice motion[1]")]));
    assert_eq!(doubled.matches("law = \"jerk\"").count(), 2);
    let html = page("/work", &[("text", &text)]);
    assert!(html.contains("down motion[1]") && html.contains("Move Segment 2 up"));
    assert!(!html.contains("Move Segment 1 up"));
}

#[test]
fn a_window_of_time_is_drawn_anew_in_detail() {
    let text = belt();
    let whole = page("/work", &[("text", &text)]);
    assert_eq!(of_plane(&whole, "data-x-min"), 0.0);
    let html = page("/work", &[("text", &text), ("from", "0.01"), ("until", "0.03")]);
    assert_eq!((of_plane(&html, "data-x-min"), of_plane(&html, "data-x-max")), (0.01, 0.03));
    assert!(html.contains("name=\"from\" value=\"0.01\""), "the window is a part of the state");
    // While the jerk is constant the speed is curved: more than the ends of a straight line are drawn.
    let speed = html.split("data-symbol=\"v\"").nth(1).unwrap().split("class=\"line\"").nth(1).unwrap();
    let path = speed.split(" d=\"").nth(1).unwrap().split('"').next().unwrap();
    assert!(path.matches(' ').count() > 8, "{path}");
    for (from, until) in [("2", "1"), ("x", "1"), ("-1", "1"), ("99", "100"), ("inf", "inf")] {
        let html = page("/work", &[("text", &text), ("from", from), ("until", until)]);
        assert_eq!(of_plane(&html, "data-x-max"), of_plane(&whole, "data-x-max"), "{from} {until}");
    }
}

#[test]
fn worst_instants_are_marked_and_numbered_as_in_the_table() {
    let html = page("/work", &[("text", &belt()), ("unfolded", "true")]);
    assert!(html.contains("id=\"mark-0\"") && html.contains("data-row=\"check-"));
    let marks = html.matches(" id=\"mark-").count();
    assert!(marks >= 3, "{marks}");
    assert!(
        html.split("<table class=\"checks\"").nth(1).is_some_and(|table| table.contains(&format!(">{marks}</button>"))),
        "{marks}"
    );
}

#[test]
fn laws_are_chosen_by_their_pictures() {
    let html = page("/", &[("text", &belt()), ("fold", "f-motion-1--law-laws")]);
    for law in ["trapezoid", "jerk", "polynomial_5", "dwell", "recorded", "manual"] {
        assert!(html.contains(&format!("<symbol id=\"law-{law}\"")), "{law}");
        assert!(html.contains(&format!("href=\"#law-{law}\"")), "{law}");
    }
    let chosen = html.split("id=\"f-motion-1--law-jerk\"").nth(1).unwrap();
    assert!(chosen.split('>').next().unwrap().contains("data-checked=\"true\""), "{}", &chosen[..200]);
}

#[test]
fn columns_of_a_recording_are_shown_and_said_otherwise() {
    let text = "format = 1\n[axis]\nsingle_move = true\n[load]\ninertia = \"0.1 kg m^2\"\n[[motion]]\nlaw = \"recorded\"\nfile = \"log.csv\"\n";
    let html = page("/work", &[("text", text)]);
    assert!(html.contains("aria-invalid") || html.contains("class=\"fault\""), "two columns of torque, no position");
    assert!(
        html.contains("<option value=\"gemessen\">gemessen</option>") && html.contains(">drehmoment [Nm]</th>"),
        "{html}"
    );
    let changes = [
        "value motion[1].columns.position=gemessen",
        "value motion[1].units.position=deg",
        "value motion[1].columns.torque=none",
    ];
    let html = page("/work", &[("text", text), ("do", &changes.join("\n"))]);
    assert!(!html.contains("class=\"fault\""), "{}", &html[html.find("class=\"fault\"").unwrap_or(0)..][..500]);
    assert!(html.contains("zeit [s] (recognised)") && html.contains("id=\"plot-cycle\""));
}

#[test]
fn all_axes_stand_together() {
    let text = example("two-axes", "axis.toml", Language::En).map(|found| found.text);
    let text = text.unwrap_or_else(|| include_str!("../../../../examples/two-axes.toml").to_owned());
    let html = page("/work", &[("text", &text), ("axis", "all")]);
    assert!(
        html.contains("id=\"together\"") && html.contains("name=\"axis\" value=\"all\"") && html.contains("<tfoot>")
    );
    assert!(!html.contains("id=\"plot-cycle\""));
    let one = page("/work", &[("text", &text), ("axis", "1")]);
    assert!(one.contains("id=\"plot-cycle\"") && one.contains("axis[2].motion[1]"), "paths of the second axis");
}

#[test]
fn a_point_of_the_map_is_looked_at() {
    let text = belt();
    let html = page("/work", &[("text", &text), ("list", "map")]);
    let map = html.split("id=\"plot-map\"").nth(1).unwrap();
    let of = |part: &str, name: &str| -> f64 {
        part.split(&format!("{name}=\"")).nth(1).unwrap().split('"').next().unwrap().parse().unwrap()
    };
    let reach = |low: &str, high: &str| of(map, high) - of(map, low);
    let marker = map.split("class=\"marker\"").nth(3).unwrap();
    let near = format!(
        "{} {} {} {}",
        of(marker, "data-x"),
        of(marker, "data-y"),
        reach("data-x-min", "data-x-max"),
        reach("data-y-min", "data-y-max")
    );
    let code = |html: &str| html.split("name=\"code\" value=\"").nth(1).unwrap().split('"').next().unwrap().to_owned();
    let looked_at = page("/work", &[("text", &text), ("near", &near)]);
    assert!(code(&looked_at).starts_with("CHA-"), "{near}");
    for nowhere in ["1e9 1e9 1 1", "", "1 2", "a b c d", "1 1 0 0"] {
        assert_eq!(code(&page("/work", &[("text", &text), ("near", nowhere)])), "", "{nowhere}");
    }
}
