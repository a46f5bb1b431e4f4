//! Every example in both languages: nine pages for one axis at most, letters that can be read, no identifier and no English in a
//! German report.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test that cannot panic cannot fail")]

use crate::samples;

use quantities::Language;
use report::{Content, Settings};
use samples::read::are_readable;

/// Pages of one axis at most, without appendices.
const MOST: usize = 9;

fn is_in_order(name: &str, content: &Content) {
    let language = content.language;
    let settings = Settings { pdf_a: false, ..samples::full() };
    let letters = report::letters(content, &settings).unwrap();
    are_readable(name, content, &letters);
    let warnings = report::warnings(content, &settings).unwrap();
    assert!(warnings.is_empty(), "{name}, {language:?}: {warnings:?}");
    let axes = content.axes.len();
    let most = if axes == 1 { MOST } else { 1 + MOST * axes };
    // The last sentence before the appendices.
    let last = match language {
        Language::En => "Identical program",
        Language::De => "Gleiches Programm",
    };
    let with_appendices = letters.iter().rfind(|letter| letter.text.contains(last)).unwrap().page;
    // The full form has notes on its documents, which take a few lines more, and with several axes appendices between them.
    let pages = if with_appendices <= most {
        with_appendices
    } else {
        report::page_fills(content, &Settings { full: false, ..settings }).unwrap().len()
    };
    assert!(pages <= most, "{name}, {language:?}: {pages} pages");
}

macro_rules! examples {
    ($($test:ident: $file:literal;)*) => {
        const NAMES: &[&str] = &[$($file),*];

        $(
            #[test]
            fn $test() {
                let text = include_str!(concat!("../../../../examples/", $file, ".toml"));
                for content in samples::made_in(text, None, &Language::ALL, true) {
                    is_in_order($file, &content);
                }
            }
        )*
    };
}

examples! {
    belt_axis: "belt-axis";
    cam_motion: "cam-motion";
    cam_table: "cam-table";
    conveyor: "conveyor";
    four_bar: "four-bar";
    hoist: "hoist";
    indexing_table: "indexing-table";
    manual_example: "manual-example";
    robot_joint: "robot-joint";
    scissor_lift: "scissor-lift";
    screw_axis: "screw-axis";
    slewing_arm: "slewing-arm";
    slider_crank: "slider-crank";
    stage_axis: "stage-axis";
    tilting_arm: "tilting-arm";
    tolerances: "tolerances";
    turntable: "turntable";
    two_axes: "two-axes";
    two_way_shuttle: "two-way-shuttle";
    winder: "winder";
}

#[test]
fn every_example_has_its_test() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples");
    let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let projects = entries.filter(|path| path.extension().is_some_and(|ending| ending == "toml"));
    let mut found: Vec<String> =
        projects.map(|path| path.file_stem().unwrap().to_string_lossy().into_owned()).collect();
    found.sort();
    assert_eq!(found, NAMES);
}
