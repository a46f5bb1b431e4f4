//! The report of an actuator of an invented series, typeset. A program of its own: what is added to the catalogue is added for
//! all tests of a program.
#![allow(clippy::unwrap_used, reason = "a test that cannot panic cannot fail")]

use crate::samples;

use quantities::Language;
use samples::{made, settings};

const PROJECT: &str = "format = 1\n[axis]\nname = \"invented axis\"\n[load]\ninertia = \"0.4 kg m^2\"\nfriction_torque = \"3 N m\"\n\
    [[motion]]\nlaw = \"manual\"\nspeed = \"40 1/min\"\naccelerate = \"0.2 s\"\nrun = \"0.3 s\"\nbrake = \"0.2 s\"\n\
    pause = \"1 s\"\n";

#[test]
fn an_invented_series_is_typeset_in_both_languages() {
    testkit::series::add(&testkit::series::invented());
    for (language, meaning) in [(Language::En, "invented encoder"), (Language::De, "erfundener Geber")] {
        let content = made(PROJECT, Some("INV-V-09C-42-X-QE"), language, true);
        assert!(report::pdf(&content, &settings()).unwrap().starts_with(b"%PDF-"));
        // Line breaks are a matter of setting.
        let text: String = report::page_texts(&content, &settings()).unwrap().concat().split_whitespace().collect();
        for printed in ["INV-V-09C-42-X-QE", meaning] {
            let printed: String = printed.split_whitespace().collect();
            assert!(text.contains(&printed), "{printed}: {text}");
        }
        let upright = report::overlaps(&content, &settings()).unwrap();
        assert!(upright.is_empty(), "{upright:?}");
    }
}
