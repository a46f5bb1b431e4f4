//! Reports on products of catalogue files: their own limits are theirs, and those without data stand in a list of their own.

use crate::samples;

use quantities::Language;
use samples::{made_in, settings};

const WINDER: &str = r#"
format = 1
[axis]
name = "Wickler Folie"
single_move = true
[mechanism.winder]
winding = "up"
core_diameter = "90 mm"
full_diameter = "330 mm"
start_diameter = "90 mm"
thickness = "2 mm"
width = "400 mm"
density = "900 kg/m^3"
tension = "110 N"
inertia = "0.02 kg m^2"
friction_torque = "1 N m"
[[motion]]
law = "trapezoid"
distance = "21600 deg"
speed = "60 1/min"
acceleration = "2 rad/s^2"
[[motion]]
law = "dwell"
time = "20 s"
[bearing]
overhang = "60 mm"
load_factor = 1.2
operating_condition = "normal"
[drive]
current_continuous = "3 A"
current_peak = "6 A"
peak_time = "2 s"
[requirements]
supply = "560 V"
[catalogue]
files = ["catalogue/stock.csv", "catalogue/fha-c.toml"]
cha = false
"#;

/// XD-25-100 states its mean input speed itself and fails at it. Of 16 products 12 have no data for any check.
#[test]
fn a_product_is_rejected_by_its_own_limit_and_listed_by_what_is_known() {
    let texts = [
        (Language::En, "gear rating of another manufacturer", "Not evaluated (data missing)"),
        (Language::De, "Getriebegrenze eines anderen Herstellers", "Nicht bewertet (Angaben fehlen)"),
    ];
    let contents = made_in(WINDER, Some("XD-25-100"), &[Language::En, Language::De], false);
    for ((language, of_another, not_evaluated), content) in texts.into_iter().zip(&contents) {
        let text: String = report::page_texts(content, &settings()).unwrap_or_default().concat();
        let text: String = text.split_whitespace().collect();
        let dense = |text: &str| text.split_whitespace().collect::<String>();
        assert!(text.contains("XD-25-100"), "{text}");
        assert!(!text.contains(&dense(of_another)), "{language:?}: {text}");
        assert!(text.contains(&dense(not_evaluated)) && text.contains("FHA-17C-50"), "{language:?}: {text}");
        assert!(!text.contains('∞'), "{language:?}: {text}");
    }
}
