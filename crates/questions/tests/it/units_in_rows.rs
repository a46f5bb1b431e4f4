//! Values of several actuators or revisions that stand in one row have one unit, or each its own.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test fails loudly")]

use quantities::Language;
use questions::list::compare::compare;
use questions::texts::{ValuesInRow, checked_text, unit_text};

/// A hoist whose counterweight decides whether an emergency stop has an angle (the brake stops the load) or a torque (it does not).
fn project(counterweight: u32) -> axis::AxisProject {
    let text = format!(
        "format = 1\n[mechanism.hoist]\ndrum_diameter = \"150 mm\"\nfalls = 1\nmass = \"40 kg\"\n\
         counterweight = \"{counterweight} kg\"\ninertia = \"0.02 kg m^2\"\n\
         [[motion]]\nlaw = \"trapezoid\"\ndistance = \"900 mm\"\nspeed = \"0.25 m/s\"\nacceleration = \"0.8 m/s^2\"\n\
         [[motion]]\nlaw = \"trapezoid\"\ndistance = \"-900 mm\"\nspeed = \"0.3 m/s\"\nacceleration = \"1 m/s^2\"\n\
         [[motion]]\nlaw = \"dwell\"\ntime = \"1.5 s\"\nhold = \"brake\"\n\
         [requirements]\nsupply = \"560 V\"\nbrake = true\n"
    );
    questions::read(&text).unwrap()
}

#[test]
fn a_value_stands_under_its_own_unit() {
    let codes = ["CHA-20A-100-H-C1024-B", "CHA-32A-80-H-M512P-B", "CHA-40A-80-H-C1024-B", "CHA-17A-80-N-D2048-B"];
    let codes: Vec<_> = codes.iter().map(|code| order_code::parse(code).unwrap().code.into()).collect();
    let mut with_own = 0;
    for counterweight in [0, 40, 90, 150, 200, 300] {
        let project = project(counterweight);
        let found = compare(&project, &codes, &questions::Progress::endless()).unwrap();
        for row in &found.checks {
            let values = ValuesInRow::of(row.checks.iter().map(Option::as_ref));
            for language in [Language::En, Language::De] {
                for check in row.checks.iter().flatten() {
                    let own = unit_text(check.value, language);
                    let plain = checked_text(check.id, check.value, language);
                    let shown = values.value(check, language);
                    let is_under_its_unit = shown == plain && (check.value.is_none() || values.unit(language) == own);
                    let with_unit = if own == "°" { format!("{plain}°") } else { format!("{plain} {own}") };
                    let has_its_own = shown == with_unit && values.unit(language).is_empty();
                    assert!(is_under_its_unit || has_its_own, "{:?}: {shown} under {}", row.id, values.unit(language));
                    with_own += u32::from(has_its_own && !own.is_empty() && shown != plain);
                }
            }
        }
    }
    assert!(with_own > 4, "{with_own} values with a unit of their own");
}
