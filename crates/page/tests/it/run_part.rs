//! Part of a long cycle in the simulation.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use crate::shell;

use shell::{page, post, whole};

/// A cycle of more than half an hour, too long to be simulated as a whole.
const LONG: &str = "format = 1\n[load]\ninertia = \"0.9 kg m^2\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"2000 s\"\n\
    [[motion]]\nlaw = \"polynomial_5\"\ndistance = \"60 deg\"\ntime = \"0.8 s\"\n\
    [[motion]]\nlaw = \"polynomial_5\"\ndistance = \"-60 deg\"\ntime = \"0.8 s\"\n\
    [requirements]\nsupply = \"560 V\"\n";

fn simulated(more: &[(&str, &str)]) -> String {
    let mut fields = vec![("text", LONG), ("view", "simulation")];
    fields.extend(more);
    let html = page(&post("/work", &fields));
    whole(&html);
    html
}

#[test]
fn a_part_of_a_long_cycle_is_simulated() {
    for lang in ["en", "de"] {
        let html = simulated(&[("lang", lang)]);
        assert!(!html.contains("id=\"plot-simulation\"") && html.contains("id=\"run-part\""), "{html}");
        // The worst instant of the cycle is proposed.
        let from = if lang == "en" { "1991.6" } else { "1991,6" };
        assert!(html.contains(&format!("&quot;run_from&quot;:&quot;{from}")), "{html}");
        let html = simulated(&[("lang", lang), ("run_part", "true"), ("run_from", "2000.4"), ("run_for", "1.2")]);
        assert!(html.contains("id=\"plot-simulation\"") && html.contains("id=\"run-whole\""), "{html}");
        let said = html.split("id=\"part-shown\">").nth(1).unwrap().split("</p>").next().unwrap();
        let words = if lang == "en" {
            "2000.40 s to 2001.60 s of the cycle of 2001.60 s"
        } else {
            "2000,40 s bis 2001,60 s des Zyklus von 2001,60 s"
        };
        assert!(said.contains(words), "{said}");
    }
}

#[test]
fn a_part_outside_of_the_cycle_is_refused_with_its_limits() {
    for (from, long) in [("2001", "5"), ("-1", "5"), ("x", "5"), ("3", ""), ("0", "0")] {
        let html = simulated(&[("run_part", "true"), ("run_from", from), ("run_for", long)]);
        assert!(html.contains("The part must lie within the cycle, 0 to 2001.60 s"), "{from} {long}: {html}");
        assert!(!html.contains("id=\"plot-simulation\"") && html.contains("id=\"run-part\""), "{from} {long}");
    }
}
