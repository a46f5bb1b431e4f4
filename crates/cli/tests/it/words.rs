//! Texts for users, word by word. Rewritten by `cargo xtask snapshots`, reviewed by eye.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, reason = "a test fails loudly")]

use crate::run;

use run::{run_with, shown};

macro_rules! shows {
    ($($name:ident: $arguments:expr;)*) => {$(
        #[test]
        fn $name() {
            let arguments: &[&str] = &$arguments;
            insta::assert_snapshot!(shown(arguments));
        }
    )*};
}

shows! {
    size_in_english: ["size", "examples/indexing-table.toml"];
    size_in_german: ["size", "examples/indexing-table.toml", "--lang", "de", "--top", "3"];
    size_with_every_reason: ["size", "examples/two-way-shuttle.toml", "--all"];
    check_of_the_worked_example: ["check", "examples/manual-example.toml"];
    check_that_fails_in_german: ["check", "examples/indexing-table.toml", "--code", "CHA-25A-50-H-M512P", "--lang", "de"];
    check_as_json: ["check", "examples/manual-example.toml", "--json"];
    code_explained: ["code", "parse", "CHA-20A-100-H-C1024-B-EC-K-SP"];
    code_understood_loosely: ["code", "parse", "cha", "20a", "100", "h", "c1024", "b", "--lang", "de"];
    code_with_three_faults: ["code", "parse", "CHA-21A-101-H-C1025"];
    code_that_breaks_rules: ["code", "parse", "CHA-14A-120-H-D2048-R", "--lang", "de"];
    code_as_json: ["code", "parse", "CHA-14A-100-N-D2048", "--json"];
    code_faults_as_json: ["code", "parse", "CHA-20A-100-L-C1024", "--json"];
    code_completed: ["code", "complete", "CHA-14A-100-N-*"];
    codes_listed: ["code", "list", "CHA-58A-160-H-M512P-B"];
    data_sheet: ["data", "CHA-25A-50-H-M512P-B"];
    data_sheet_in_german: ["data", "CHA-17A-80-E-D2048", "--lang", "de"];
    data_sheet_of_a_special_design_with_battery: ["data", "CHA-17A-50-E-M128S-SP"];
    data_sheet_with_an_encoder_at_the_output: ["data", "CHA-58A-100-H-C1024-B-EC", "--lang", "de"];
    no_data: ["data", "CHA-58A-50-H-RES"];
    code_with_a_longer_housing: ["code", "parse", "CHA-14A-50-E-RES-K", "--lang", "de"];
    code_with_connectors_at_the_housing: ["code", "parse", "CHA-17A-120-E-D2048-B"];
    code_without_completion: ["code", "complete", "CHA-20A-100-L"];
    code_without_completion_as_json: ["code", "complete", "CHA-*-160-E", "--json", "--lang", "de"];
    code_with_a_wrong_winding: ["code", "parse", "CHA-20A-100-X-C1024"];
    wiring: ["wiring", "CHA-25A-100-H-M512P-B"];
    wiring_in_german: ["wiring", "CHA-25A-100-H-M512P-B", "--lang", "de"];
    wiring_without_colours: ["wiring", "CHA-14A-50-E-M128S"];
    wiring_without_colours_in_german: ["wiring", "CHA-14A-50-E-M128S", "--lang", "de"];
    wiring_on_a_long_cable: ["wiring", "CHA-20A-80-H-C1024-B-EC", "--length", "40 m", "--cross-section", "0.5 mm^2", "--lang", "de"];
    wiring_checked: ["wiring", "CHA-25A-100-H-M512P-B", "--check", "examples/pins.csv"];
    wiring_checked_in_german: ["wiring", "CHA-25A-100-H-M512P-B", "--check", "examples/pins.csv", "--lang", "de"];
    wiring_as_picture: ["wiring", "CHA-14A-50-N-RES-B", "--connector", "motor", "--svg", "-"];
    wiring_of_no_such_connector: ["wiring", "CHA-25A-100-H-M512P-B", "--connector", "output_encoder", "--svg", "-"];
    wiring_help: ["wiring", "--help"];
    wiring_help_in_german: ["wiring", "--help", "--lang", "de"];
    commissioning_for_a_sinamics_drive: ["commission", "CHA-25A-100-H-M512P-B", "--for", "sinamics"];
    commissioning_for_a_sinamics_drive_in_german: ["commission", "CHA-25A-100-H-M512P-B", "--for", "sinamics", "--lang", "de"];
    commissioning_in_objects: ["commission", "CHA-14A-50-E-M128S", "--for", "cia402"];
    commissioning_in_objects_in_german: ["commission", "CHA-14A-50-E-M128S", "--for", "cia402", "--lang", "de"];
    commissioning_objects_as_json: ["commission", "CHA-25A-100-H-M512P-B", "--for", "cia402", "--json"];
    commissioning_recorded: ["commission", "CHA-25A-100-H-M512P-B", "--record", "examples/commissioning/three-faults.toml"];
    commissioning_recorded_in_german: ["commission", "CHA-25A-100-H-M512P-B", "--record", "examples/commissioning/three-faults.toml", "--lang", "de"];
    commissioning_help: ["commission", "--help"];
    errata_of_a_table: ["errata", "40.1"];
    errata_of_a_text_in_german: ["errata", "text-ch3-torque-range", "--lang", "de"];
    errata_as_json: ["errata", "T59.1-buffer-current", "--json"];
    errata_of_what_is_not_known: ["errata", "77.2"];
    mounting: ["mount", "CHA-25A-100-H-M512P-B"];
    mounting_in_german: ["mount", "CHA-25A-100-H-M512P-B", "--lang", "de", "--bore", "K7"];
    mounting_of_a_small_one: ["mount", "CHA-14A-50-E-M128S", "--bore-housing", "+0.012/-0.003 mm"];
    mounting_of_a_small_one_in_german: ["mount", "CHA-14A-50-E-M128S", "--lang", "de"];
    mounting_of_a_special_design: ["mount", "CHA-20A-50-H-C1024-SP"];
    mounting_under_the_loads_of_a_project: ["mount", "CHA-32A-50-H-C1024", "--project", "examples/indexing-table.toml"];
    mounting_as_json: ["mount", "CHA-14A-50-E-M128S", "--json"];
    mounting_with_every_fault: ["mount", "CHA-99-50-E", "--bore", "H9", "--bore-load", "+12/-3 mm", "--bore-housing", "-0.01/+0.01 mm"];
    mounting_with_faults_in_german: ["mount", "CHA-14A-50-E-M128S", "--lang", "de", "--bore", "5 N", "--bore-load", "0.01/0.02", "--bore-housing", "0,01/0 mm"];
    mounting_without_data: ["mount", "CHA-58A-50-H-RES"];
    mount_help: ["mount", "--help"];
    upkeep_of_an_encoder_with_battery: ["upkeep", "CHA-14A-50-E-M128S", "--delivered", "2026-03-01", "--storage", "6 months", "--hours-per-day", "10"];
    upkeep_in_german: ["upkeep", "CHA-14A-50-E-M128S", "--delivered", "2026-03-01", "--today", "2033-01-15", "--inspect", "26 weeks", "--lang", "de"];
    upkeep_with_a_brake: ["upkeep", "CHA-25A-100-H-M512P-B", "--delivered", "2026-03-01", "--storage", "2028-06-01", "--inspect", "2 a", "--hours-per-day", "8"];
    upkeep_with_a_brake_in_german: ["upkeep", "CHA-25A-100-H-M512P-B", "--delivered", "2024-02-29", "--lang", "de"];
    upkeep_as_json: ["upkeep", "CHA-14A-50-E-M128S", "--delivered", "2026-03-01", "--hours-per-day", "24", "--json"];
    upkeep_with_every_fault: ["upkeep", "CHA-99", "--delivered", "2026-13-01", "--inspect", "6 mm", "--storage", "3", "--hours-per-day", "5 kg", "--today", "1/3/2026", "--ical", "plan.txt"];
    upkeep_with_faults_in_german: ["upkeep", "CHA-14A-50-E-M128S", "--delivered", "0202-03-01", "--inspect", "0 Monate", "--storage", "99 a", "--lang", "de"];
    upkeep_of_what_is_not_delivered: ["upkeep", "CHA-14A-50-E-M128S", "--delivered", "2030-01-01", "--today", "2026-03-01"];
    upkeep_stored_before_delivery: ["upkeep", "CHA-14A-50-E-M128S", "--delivered", "2025-01-01", "--storage", "2024-01-01", "--lang", "de"];
    upkeep_stored_beyond_the_model: ["upkeep", "CHA-14A-50-E-M128S", "--delivered", "2025-01-01", "--storage", "4 a", "--hours-per-day", "8"];
    upkeep_help_in_german: ["upkeep", "--help", "--lang", "de"];
    help_in_english: ["--help"];
    help_in_german: ["size", "--help", "--lang", "de"];
    unknown_command: ["siz", "x"];
    missing_file: ["size", "examples/none.toml"];
    schema: ["schema"];
    tolerances: ["check", "examples/tolerances.toml", "--code", "CHA-14A-80-H-RES-B"];
    tolerances_in_german: ["size", "examples/tolerances.toml", "--lang", "de", "--top", "3", "--samples", "500", "--seed", "7"];
    inertia_of_a_table: ["inertia", "disc diameter=200mm length=20mm density=7850kg/m^3", "box a=50mm b=50mm height=30mm mass=0.6kg distance=80mm count=4"];
    inertia_of_an_arm_in_german: ["inertia", "--lang", "de", "tube outer=60mm inner=52mm length=400mm density=2.7g/cm^3 axis=perpendicular distance=250mm angle=90deg", "point mass=3kg distance=450mm angle=90deg"];
    inertia_as_json: ["inertia", "--json", "disc diameter=200mm length=20mm density=7850kg/m^3", "point mass=0.5kg distance=80mm angle=45deg"];
    inertia_with_every_fault: ["inertia", "cylinder diameter=200 length=20s densty=7850kg/m^3", "tub outer=50mm", "tube outer=50mm inner=60mm length=0mm mass=1kg density=1kg/dm^3 count=0"];
    inertia_with_faults_in_german: ["inertia", "--lang", "de", "box a=50mm b=-5mm mass=0,6kg", "point distance=80mm count=2.5", "rod length=80mm axis=parallel density=1kg/l"];
    inertia_faults_as_json: ["inertia", "--json", "point mass=1kg", "sphere diametre=50mm mass=1kg"];
    compared: ["compare", "examples/indexing-table.toml", "--code", "CHA-32A-50-H-C1024", "--code", "CHA-25A-50-H-C1024", "--code", "CHA-32A-80-H-C1024-B"];
    compared_in_german: ["compare", "examples/belt-axis.toml", "--code", "CHA-14A-50-N-D2048", "--code", "CHA-17A-50-H-M128S-B", "--lang", "de"];
    compare_help: ["compare", "--help"];
    diff_help_in_german: ["diff", "--help", "--lang", "de"];
    export_help: ["export", "--help"];
    export_help_in_german: ["export", "--help", "--lang", "de"];
    inertia_help: ["inertia", "--help"];
    plot_help: ["plot", "--help"];
    plot_help_in_german: ["plot", "--help", "--lang", "de"];
    curve_help: ["curve", "--help"];
    torsion_as_picture: ["plot", "examples/indexing-table.toml", "--code", "CHA-32A-50-H-C1024", "--figure", "torsion", "--width", "90 mm", "--height", "60 mm"];
    unknown_figure: ["plot", "examples/indexing-table.toml", "--figure", "torque_sped"];
    unknown_figure_in_german: ["plot", "examples/indexing-table.toml", "--figure", "torque_sped", "--lang", "de"];
    picture_of_one_axis_of_two: ["plot", "examples/two-axes.toml", "--figure", "cycle"];
    picture_too_small: ["plot", "examples/indexing-table.toml", "--figure", "cycle", "--width", "3 mm", "--lang", "de"];
    inertia_help_in_german: ["inertia", "--help", "--lang", "de"];
}

#[test]
fn every_fault_of_a_project() {
    let text = "format = 1\n[load]\ninertia = \"1,3 kg m^2\"\nfriction = \"5 N m\"\n[[motion]]\nlaw = \"manuel\"\n\
                speed = 40\naccelerate = \"0.1 m\"\nrun = \"-0.1 s\"\nbrake = \"0.1\"\n[requirements]\nfeedback = [\"M512\"]\n";
    for language in ["en", "de"] {
        let run = run_with(&["size", "-", "--lang", language], text.as_bytes());
        assert_eq!(run.code, 2);
        assert_eq!(run.out, "");
        insta::assert_snapshot!(format!("every_fault_of_a_project_{language}"), run.err);
    }
}

#[test]
fn every_fault_of_a_list_of_pins() {
    let text = "connector;pin;signal;shield;wire\nmoter;1;U;yes;a\nmotor;;V;perhaps;b\nmotor;3\n";
    for language in ["en", "de"] {
        let run = run_with(&["wiring", "CHA-25A-100-H-M512P-B", "--check", "-", "--lang", language], text.as_bytes());
        assert_eq!((run.code, run.out.as_str()), (2, ""));
        insta::assert_snapshot!(format!("every_fault_of_a_list_of_pins_{language}"), run.err);
    }
}

#[test]
fn every_difference_of_a_list_of_pins() {
    let text = "connector\tpin\tsignal\tcolour\tshield\nmotor\t1\tV\tred\tyes\nmotor\t2\tU\tgreen\tno\nmotor\t4\tBRR+\t\t\n\
                motor\t4\tBR+\t\t\nmotor\t9\tPE\t\t\nmotor\t5\tDATA+\t\t\nfeedback\t4\tA+\t\t\nfeedback\t6\txyz\t\t\nEC\t7\tGND\t\t\n\
                EC\t10\tUp\t\t\nfeedback\t8\tKTY-\t\t\nfeedback\t9\tKTY+\t\t\n";
    for language in ["en", "de"] {
        let run =
            run_with(&["wiring", "CHA-25A-100-H-M512P-B-EC", "--check", "-", "--lang", language], text.as_bytes());
        assert_eq!((run.code, run.err.as_str()), (1, ""));
        insta::assert_snapshot!(format!("every_difference_of_a_list_of_pins_{language}"), run.out);
    }
}

#[test]
fn another_revision() {
    let old = std::fs::read_to_string(run::root().join("examples/tilting-arm.toml")).unwrap();
    let new =
        old.replace("[requirements]", "[requirements]\nmass_max = \"2.5 kg\"").replace("\"30 degC\"", "\"38 degC\"");
    let new = new.replacen("payload = \"2.5 kg\"", "payload = \"4 kg\"", 1);
    assert_ne!(old, new);
    for language in ["en", "de"] {
        let run = run_with(&["diff", "examples/tilting-arm.toml", "-", "--lang", language], new.as_bytes());
        insta::assert_snapshot!(format!("another_revision_{language}"), format!("{}--- exit {}\n", run.out, run.code));
    }
}
