//! Every example takes nine pages for one axis at most, in both languages.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test that cannot panic cannot fail")]

mod samples;

use quantities::Language;
use report::Settings;

/// Pages of one axis at most, without appendices.
const MOST: usize = 9;

macro_rules! examples {
    ($($test:ident: $file:literal;)*) => {
        const NAMES: &[&str] = &[$($file),*];

        $(
            #[test]
            fn $test() {
                let text = include_str!(concat!("../../../examples/", $file, ".toml"));
                for content in samples::made_in(text, None, &Language::ALL, true) {
                    let language = content.language;
                    let axes = content.axes.len();
                    let most = if axes == 1 { MOST } else { 1 + MOST * axes };
                    let settings = Settings { full: false, pdf_a: false, ..samples::settings() };
                    let pages = report::page_fills(&content, &settings).unwrap().len();
                    assert!(pages <= most, "{}, {language:?}: {pages} pages", $file);
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
