//! Plausibility of catalogue files: the built-in series written out as a file raises no finding, each planted fault is found.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use crate::written_product::{Stated, toml, written};
use actuator::Parameters;
use axis::{CatalogueCheck, PLAUSIBILITY_RULES, PlausibilityRuleId, SERIES_KEYS, check_catalogue};
use configurator::Product;
use provenance::Datum;
use quantities::unit::DEGREE_CELSIUS;
use quantities::{Language, Measure};
use questions::embedded_catalogue;
use std::sync::LazyLock;

/// Returns every value of a product of the built-in series that a catalogue file can state, numbers only.
fn whole(product: &Product) -> Vec<Stated> {
    fn quantity<T: Measure + Copy>(key: &'static str, datum: &Datum<T>, unit: &'static str) -> Stated {
        (key, datum.known().map(|known| format!("{:?}", known.value.si())), unit)
    }
    let of = &product.parameters;
    let winding = of.heat.winding_shutdown.known().map(|known| known.value.in_unit(&DEGREE_CELSIUS).to_string());
    let mut stated = written(of);
    stated.extend([
        ("pole_pairs", of.pole_pairs.known().map(|known| known.value.to_string()), ""),
        ("winding_temperature_max", winding, "degC"),
        quantity("speed_max", &of.speed_max, "rad/s"),
        quantity("speed_motor_max", &of.speed_motor_max, "rad/s"),
        quantity("speed_motor_rated", &of.speed_motor_rated, "rad/s"),
        quantity("stall_torque", &of.stall_torque, "N m"),
        quantity("stall_current", &of.stall_current, "A"),
        quantity("current_max", &of.current_max, "A"),
        quantity("current_demagnetisation", &of.current_demagnetisation, "A"),
        quantity("no_load_starting_current", &of.no_load_starting_current, "A"),
        quantity("no_load_current_constant_30", &of.no_load_current_constant_cold, "A s/rad"),
        quantity("no_load_current_constant_80", &of.no_load_current_constant_warm, "A s/rad"),
        quantity("torque_constant_out", &of.torque_constant_out, "N m/A"),
        quantity("torque_constant_motor", &of.torque_constant_motor, "N m/A"),
        quantity("voltage_constant_motor", &of.voltage_constant_motor, "V s/rad"),
        quantity("resistance_ll", &of.resistance_ll, "Ohm"),
        quantity("inductance_ll", &of.inductance_ll, "H"),
        quantity("mass", &of.mass, "kg"),
        quantity("length", &of.length, "m"),
        quantity("hollow_shaft", &of.hollow_shaft, "m"),
        quantity("dc_link_max", &of.dc_link_max, "V"),
        quantity("terminal_voltage_min", &of.terminal_voltage_min, "V"),
        quantity("winding_time_constant", &of.heat.winding_time_constant, "s"),
    ]);
    stated
}

/// A file in memory: rows of products with their keys, units and values.
#[derive(Clone)]
struct Sheet(Vec<(String, Vec<Stated>)>);

impl Sheet {
    /// Returns the built-in series, every product or one of several.
    fn of_series(step: usize) -> Self {
        let products = embedded_catalogue().products(false).iter().step_by(step);
        // A name that is an ordering code belongs to the built-in series.
        Self(products.map(|product| (product.id.to_string().replace("CHA-", "XHA-"), whole(product))).collect())
    }

    fn one(&self, index: usize) -> Self {
        Self(vec![self.0[index].clone()])
    }

    /// Returns the file with one value multiplied; `None` if it is not stated.
    fn planted(&self, index: usize, key: &str, factor: f64) -> Option<Self> {
        let mut planted = self.clone();
        let stated = planted.0[index].1.iter_mut().find(|(name, ..)| *name == key)?;
        stated.1 = Some(format!("{:?}", stated.1.as_ref()?.parse::<f64>().unwrap() * factor));
        Some(planted)
    }

    fn without(mut self, key: &str) -> Self {
        self.0
            .iter_mut()
            .flat_map(|(_, stated)| stated)
            .filter(|(name, ..)| *name == key)
            .for_each(|each| each.1 = None);
        self
    }

    fn csv(&self) -> String {
        let heading =
            |(key, _, unit): &Stated| if unit.is_empty() { (*key).to_owned() } else { format!("{key} [{unit}]") };
        let headings: Vec<String> = self.0[0].1.iter().map(heading).collect();
        let mut text = format!("maker,series,id,{}\n", headings.join(","));
        for (id, stated) in &self.0 {
            let cells: Vec<&str> = stated.iter().map(|(_, value, _)| value.as_deref().unwrap_or_default()).collect();
            text.push_str(&format!("Example,X,{id},{}\n", cells.join(",")));
        }
        text
    }

    fn toml(&self) -> String {
        let head = "[catalogue]\nmaker = \"Example\"\nseries = \"X\"\n".to_owned();
        let one = |(id, stated): &(String, Vec<Stated>)| format!("[[actuator]]\nid = \"{id}\"\n{}", toml(stated));
        head + &self.0.iter().map(one).collect::<String>()
    }

    fn findings(&self) -> Vec<(PlausibilityRuleId, String, Vec<&'static str>)> {
        let of = |finding: axis::PlausibilityFinding| {
            (finding.rule, finding.product, finding.figures.iter().map(|figure| figure.key).collect())
        };
        checked("x.csv", &self.csv()).findings.into_iter().map(of).collect()
    }
}

fn parameters() -> &'static Parameters {
    static PARAMETERS: LazyLock<Parameters> = LazyLock::new(|| embedded_catalogue().own_actuator());
    &PARAMETERS
}

fn checked(name: &str, text: &str) -> CatalogueCheck {
    let found = check_catalogue(name, text.as_bytes(), parameters(), true);
    found.unwrap_or_else(|faults| panic!("{:?}", words::worded(&faults, Language::En)))
}

/// The series of the manual with its corrections, as a file in both formats.
#[test]
fn the_built_in_series_as_a_file_raises_no_finding() {
    let series = Sheet::of_series(1);
    assert_eq!(series.0.len(), 276);
    for (name, text) in [("x.csv", series.csv()), ("x.toml", series.toml())] {
        let check = checked(name, &text);
        assert_eq!(check.names.len(), 276);
        assert_eq!(check.findings, [], "{name}");
        assert_eq!(check.proposals, [], "{name}");
    }
}

/// Plants at every key that a rule reads a factor that leaves the window from every place in it, up and down.
#[test]
fn a_planted_fault_is_found_at_each_key_of_each_rule() {
    let series = Sheet::of_series(11);
    for rule in PLAUSIBILITY_RULES {
        let mut planted = 0;
        for index in 0..series.0.len() {
            // Three products, up and down at each key: every product takes a minute.
            if planted >= 6 * rule.terms.len() {
                break;
            }
            let mut product = series.one(index);
            if let Some(other) = rule.unless {
                product = product.without(other);
            }
            assert_eq!(product.findings(), [], "{:?}", rule.id);
            for (_, key, power) in rule.terms {
                for direction in [1.0, -1.0] {
                    let factor = (1.01 * rule.high / rule.low).powf(direction / power.abs());
                    let Some(file) = product.planted(0, key, factor) else { continue };
                    let stated =
                        |key: &str| product.0[0].1.iter().any(|(name, value, _)| *name == key && value.is_some());
                    let applies = rule.terms.iter().all(|(_, key, _)| stated(key));
                    // A value outside the range of its key, or of its order with another, is a fault already.
                    let Ok(check) = check_catalogue("x.csv", file.csv().as_bytes(), parameters(), false) else {
                        continue;
                    };
                    let found = check.findings.iter().find(|finding| finding.rule == rule.id);
                    assert_eq!(found.is_some(), applies, "{:?} {key} {factor} {}", rule.id, product.0[0].0);
                    let Some(found) = found else { continue };
                    assert!(found.figures.iter().any(|figure| figure.key == *key && figure.line == 2), "{found:?}");
                    assert!(found.ratio.is_some_and(|ratio| !(rule.low..=rule.high).contains(&ratio)), "{found:?}");
                    planted += 1;
                }
            }
        }
        assert!(planted > 0, "{:?}", rule.id);
    }
}

/// A thousandfold and a thousandth of every key that is compared within the series; no other product is named.
#[test]
fn a_value_off_by_three_powers_of_ten_is_found_among_its_neighbours() {
    // An odd step takes products with and without brake.
    let series = Sheet::of_series(3);
    for of in SERIES_KEYS {
        let states =
            |index: &usize| series.0[*index].1.iter().any(|(name, value, _)| *name == of.key && value.is_some());
        let stating: Vec<usize> = (0..series.0.len()).filter(states).collect();
        for (index, factor) in [(stating[stating.len() / 3], 1e3), (stating[stating.len() - 1], 1e-3)] {
            let file = series.planted(index, of.key, factor).unwrap();
            let Ok(check) = check_catalogue("x.csv", file.csv().as_bytes(), parameters(), false) else { continue };
            let products: Vec<&str> = check.findings.iter().map(|finding| finding.product.as_str()).collect();
            assert!(products.iter().all(|product| *product == file.0[index].0), "{} {products:?}", of.key);
            let is_it = |finding: &axis::PlausibilityFinding| {
                finding.rule == PlausibilityRuleId::Neighbours && finding.formula == of.key
            };
            assert!(check.findings.iter().any(is_it), "{} {factor} {:?}", of.key, check.findings);
        }
    }
}

/// The key of a group is the motor; three products with one motor are enough.
#[test]
fn an_inertia_that_is_not_that_of_the_motor_is_found() {
    let series = Sheet::of_series(1);
    let of_motor = |index: usize| {
        let value = |key: &str| series.0[index].1.iter().find(|(name, ..)| *name == key).unwrap().1.clone();
        (value("torque_constant_motor"), value("resistance_ll"), value("dc_link_max"))
    };
    let same: Vec<usize> = (0..series.0.len()).filter(|index| of_motor(*index) == of_motor(0)).take(3).collect();
    let file = Sheet(same.into_iter().map(|index| series.0[index].clone()).collect());
    assert_eq!(file.findings(), []);
    for factor in [10.0, 0.1] {
        let found = file.planted(1, "inertia_out", factor).unwrap().findings();
        assert_eq!(found, [(PlausibilityRuleId::SameMotor, file.0[1].0.clone(), vec!["inertia_out", "ratio"])]);
    }
}

/// Two of four products with one motor are wrong: the ratio is that of two products, which the finding names.
#[test]
fn the_ratio_to_the_same_motor_is_that_of_a_product_of_the_file() {
    let text = "id;ratio;inertia_out [kg cm^2];torque_constant_motor [N m/A];resistance_ll [ohm]\n\
        A;50;900;0.12;2.1\nB;100;36000;0.12;2.1\nC;30;3240;0.12;2.1\nD;80;2304;0.12;2.1\n";
    let check = checked("x.csv", text);
    let found: Vec<(&str, f64)> =
        check.findings.iter().map(|finding| (finding.product.as_str(), finding.ratio.unwrap())).collect();
    assert_eq!(found.iter().map(|(product, _)| *product).collect::<Vec<_>>(), ["B", "C"]);
    // (36000/100²)/(900/50²) = (3240/30²)/(2304/80²) = 10.
    assert!(found.iter().all(|(_, ratio)| (ratio - 10.0).abs() < 1e-9), "{found:?}");
}

#[test]
fn names_that_differ_in_writing_only_are_found() {
    let mut file = Sheet::of_series(90);
    file.0[0].0 = "XD 25-100".to_owned();
    file.0[1].0 = "xd-25_100".to_owned();
    file.0[2].0 = "XD-251-00".to_owned();
    let found = file.findings();
    assert_eq!(found, [(PlausibilityRuleId::SameName, "xd-25_100".to_owned(), vec![])]);
}

/// Units of data sheets that are confused: the proposal is the cell as it was before.
#[test]
fn a_confused_unit_is_proposed_as_it_was() {
    let series = Sheet::of_series(5);
    for (key, wrong, right) in [
        ("inertia_out", "kg cm^2", "kg m^2"),
        ("inertia_out", "g cm^2", "kg m^2"),
        ("stall_torque", "N cm", "N m"),
        ("voltage_constant_motor", "V/1000 1/min", "V s/rad"),
        ("speed_max", "1/min", "rad/s"),
        ("mass", "g", "kg"),
        ("length", "mm", "m"),
        ("inductance_ll", "mH", "H"),
        ("stiffness_1", "N m/arcmin", "N m/rad"),
        ("bearing_dynamic", "kN", "N"),
        ("brake_torque", "N cm", "N m"),
    ] {
        let states = |index: &usize| series.0[*index].1.iter().any(|(name, value, _)| *name == key && value.is_some());
        let stating: Vec<usize> = (0..series.0.len()).filter(states).collect();
        let index = stating[stating.len() / 2];
        let mut file = series.clone();
        let stated = file.0[index].1.iter_mut().find(|(name, ..)| *name == key).unwrap();
        let value = stated.1.clone().unwrap();
        stated.2 = wrong;
        let check = checked("x.toml", &file.toml());
        let found = check.proposals.iter().find(|proposal| proposal.key == key);
        let Some(found) = found else { panic!("{key} {wrong} {:?}", check.findings) };
        assert_eq!(
            (found.old.clone(), found.new.clone()),
            (format!("\"{value} {wrong}\""), format!("\"{value} {right}\""))
        );
        assert_eq!(found.product.as_ref(), Some(&file.0[index].0));
        // The proposed file has no finding.
        let fixed = file.toml().replacen(&found.old, &found.new, 1);
        assert_eq!(checked("x.toml", &fixed).findings, [], "{key} {wrong}");
    }
}

/// A heading with the wrong unit: one proposal for the heading, none for its cells.
#[test]
fn a_heading_with_a_wrong_unit_is_proposed_once() {
    let series = Sheet::of_series(6);
    let wrong = series.csv().replacen("[V s/rad]", "[V/1000 1/min]", 1);
    let check = checked("x.csv", &wrong);
    assert!(check.findings.len() >= series.0.len(), "{:?}", check.findings.len());
    let proposals: Vec<_> =
        check.proposals.iter().filter(|proposal| proposal.key == "voltage_constant_motor").collect();
    let [one] = proposals.as_slice() else { panic!("{proposals:?}") };
    assert_eq!(
        (one.old.as_str(), one.new.as_str()),
        ("voltage_constant_motor [V/1000 1/min]", "voltage_constant_motor [V s/rad]",)
    );
    assert_eq!((one.product.as_ref(), one.line), (None, 1));
}

/// A cell keeps the decimal mark of its table.
#[test]
fn a_proposed_cell_has_the_decimal_mark_of_its_table() {
    let text = "id;ratio;torque_max [N m];mass [kg];length [mm]\nA;50;12,5;2700,5;118,5\n";
    let check = checked("x.csv", text);
    let cells: Vec<(&str, &str)> =
        check.proposals.iter().map(|proposal| (proposal.old.as_str(), proposal.new.as_str())).collect();
    assert!(cells.contains(&("2700,5", "2,7005")), "{cells:?}");
}

/// Faults of the file come first; then nothing is compared.
#[test]
fn a_file_with_faults_is_not_compared() {
    let found = check_catalogue("x.csv", b"id,mass [kg],torque_max\nA,1,2\nA,1,2\n", parameters(), false);
    assert_eq!(found.unwrap_err().len(), 2);
}

/// Both guides list every rule with its ratio and its window.
#[test]
fn the_guide_states_each_rule_with_its_window() {
    for (file, to, mark) in [("guide", "to", "."), ("anleitung", "bis", ",")] {
        let path = format!("{}/../../docs/{file}/own-catalogue.md", env!("CARGO_MANIFEST_DIR"));
        let text = std::fs::read_to_string(path).unwrap();
        for rule in PLAUSIBILITY_RULES {
            let [low, high] = [rule.low, rule.high].map(|value| value.to_string().replace('.', mark));
            let unit = if rule.unit.is_empty() { String::new() } else { format!(" {}", rule.unit) };
            let row = format!("| `{}` | `{}` | {low} {to} {high}{unit} |", rule.id.id(), rule.formula);
            assert!(text.contains(&row), "{file}: {row}");
        }
        for id in PlausibilityRuleId::IDS {
            assert!(text.contains(&format!("`{id}`")), "{file}: {id}");
        }
    }
}
