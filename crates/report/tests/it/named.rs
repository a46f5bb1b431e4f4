//! Reports of products with a name: few data, another manufacturer.
#![allow(clippy::unwrap_used, reason = "a test that cannot panic cannot fail")]

use crate::samples;

use quantities::Language;
use report::{Content, Settings};
use samples::made_in;

const PROJECT: &str = "format = 1\n[axis]\nname = \"named axis\"\n[load]\ninertia = \"0.4 kg m^2\"\n\
    friction_torque = \"3 N m\"\n[[motion]]\nlaw = \"polynomial_5\"\ndistance = \"90 deg\"\ntime = \"1 s\"\n\
    [[motion]]\nlaw = \"polynomial_5\"\ndistance = \"-90 deg\"\ntime = \"1 s\"\n\
    [requirements]\nhumidity_max = \"75 %\"\n\
    [actuator]\nname = \"NR 14/100\"\nratio = 100\ntorque_max = \"82 N m\"\nspeed_max = \"60 1/min\"\nmass = \"1.1 kg\"\n";

fn contents() -> Vec<Content> {
    made_in(PROJECT, Some("NR 14/100"), &Language::ALL, true)
}

/// Returns a text without spaces, which are a matter of setting.
fn dense(text: &str) -> String {
    text.split_whitespace().collect()
}

/// The caption says that the inertia of the actuator is not part of the torque, where it is not known.
#[test]
fn without_the_inertia_of_the_actuator_the_caption_says_so() {
    for content in contents() {
        let pages = dense(&report::page_texts(&content, &Settings::default()).unwrap().concat());
        let [own, whole] = [words::pictures::cycle_caption_of_the_load, words::pictures::cycle_caption]
            .map(|caption| dense(caption(content.language)));
        assert!(pages.contains(&own) && !pages.contains(&whole), "{:?}: {pages}", content.language);
    }
}

/// The head is that of the actuator that is judged.
#[test]
fn an_actuator_without_a_hollow_shaft_is_not_called_one() {
    for content in contents() {
        let pages = report::page_texts(&content, &Settings::default()).unwrap();
        let cover = dense(pages.first().unwrap());
        let (kind, other) = match content.language {
            Language::En => ("servoactuator", "hollow"),
            Language::De => ("Servoantrieb", "Hohlwelle"),
        };
        // The requirement on the hollow shaft is not stated, so that no other line names one.
        assert!(cover.contains(kind) && !cover.contains(other), "{cover}");
    }
}

/// No chapter is empty: behind every heading there is more than the next one.
#[test]
fn a_product_with_few_data_leaves_no_chapter_empty() {
    for content in contents() {
        let pages = report::page_texts(&content, &Settings::default()).unwrap();
        let last = words::report::words(content.language);
        let demand = last.get("c_demand").unwrap();
        let text = dense(&pages.get(1..).unwrap().concat());
        assert!(!text.contains(&format!("4{}5", dense(demand))), "{text}");
    }
}

/// Letters can be read, no identifier stands in the words.
#[test]
fn a_report_on_a_product_with_a_name_can_be_read() {
    for content in contents() {
        samples::read::is_readable("named", &content, &Settings::default());
        let crowded = report::overlaps(&content, &Settings::default()).unwrap();
        assert!(crowded.is_empty(), "{crowded:?}");
    }
}

/// A ratio keeps the form in which the project writes it.
#[test]
fn a_humidity_in_percent_is_printed_in_percent() {
    for content in contents() {
        let pages = dense(&report::page_texts(&content, &Settings::default()).unwrap().concat());
        assert!(pages.contains("75%") && !pages.contains("0,75") && !pages.contains("0.75"), "{pages}");
    }
}
