//! Brakes that state times of their own: T_rms, heat and verdict by these times, in every answer.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use crate::catalogue_files::Memory;
use crate::written_product::{toml, written};
use quantities::Measure;
use questions::sweep::{Cells, Judged, Options, Sweep};
use questions::{Progress, check_own, embedded_catalogue, size};

/// A hoist whose load the brake holds in two rests of 3 s: T_h = m g r, without friction.
const HOIST: &str = "format = 1\n[mechanism.hoist]\ndrum_diameter = \"150 mm\"\nfalls = 1\nmass = \"40 kg\"\n\
    [[motion]]\nlaw = \"polynomial_5\"\ndistance = \"300 mm\"\ntime = \"1 s\"\n\
    [[motion]]\nlaw = \"dwell\"\ntime = \"3 s\"\nhold = \"brake\"\n\
    [[motion]]\nlaw = \"polynomial_5\"\ndistance = \"-300 mm\"\ntime = \"1 s\"\n\
    [[motion]]\nlaw = \"dwell\"\ntime = \"3 s\"\nhold = \"brake\"\n";

/// Closing and opening times \[s\]: those of the manual, faster ones, slower ones, and such that the rests are too short.
const TIMES: [[f64; 2]; 6] = [[0.07, 0.11], [0.01, 0.02], [0.2, 0.3], [1.4, 1.4], [0.0704, 0.11], [2.0, 2.5]];

/// Returns the data of an actuator with a brake, with times of its own.
fn braked(index: usize, [closing, opening]: [f64; 2]) -> String {
    let products = embedded_catalogue().products(false);
    let with_brake = products.iter().filter(|product| product.parameters.brake.holding_torque.known().is_some());
    let product = with_brake.clone().nth(index % with_brake.count()).unwrap();
    let stated = written(&product.parameters)
        .into_iter()
        .filter(|(key, ..)| !key.starts_with("brake_") || !key.ends_with("_time"));
    let mut stated: Vec<_> = stated.collect();
    stated.push(("mass", product.parameters.mass.known().map(|mass| format!("{:?}", mass.value.si())), "kg"));
    stated.push(("brake_closing_time", Some(format!("{closing:?}")), "s"));
    stated.push(("brake_opening_time", Some(format!("{opening:?}")), "s"));
    toml(&stated)
}

/// T_rms² t_0 grows by T_h² for each second in which the motor holds the load: until the brake has closed, while it opens, and the
/// whole rest if it is too short for both.
#[test]
fn the_motor_holds_while_the_brake_of_the_actuator_closes_and_opens() {
    let squares = |times: [f64; 2]| {
        let text = format!("{HOIST}[actuator]\nname = \"x\"\n{}", braked(7, times));
        let project = questions::read(&text).unwrap();
        let demand = check_own(&project).unwrap().judgement.demand.unwrap();
        demand.torque_rms.si().powi(2) * 8.0
    };
    let held = |[closing, opening]: [f64; 2]| if closing + opening >= 3.0 { 6.0 } else { 2.0 * (closing + opening) };
    let holding = 40.0 * 9.806_65 * 0.075;
    let first = squares(TIMES[0]);
    for times in TIMES {
        let expected = first + holding * holding * (held(times) - held(TIMES[0]));
        assert!((squares(times) / expected - 1.0).abs() < 1e-9, "{times:?}: {} for {expected}", squares(times));
    }
}

/// Actuators of a file with brakes of their own: each is judged as alone in its project, whatever stands beside it, and the row of a
/// sweep has the answer of `size`.
#[test]
fn each_brake_has_its_times_beside_others() {
    let head = "[catalogue]\nmaker = \"Example\"\nseries = \"B\"\nsource = \"invented\"\n".to_owned();
    let products: Vec<String> = (0..24).map(|index| braked(index * 5, TIMES[index % TIMES.len()])).collect();
    let one = |(index, data): (usize, &String)| format!("[[actuator]]\nid = \"P{index}\"\n{data}");
    let file = head + &products.iter().enumerate().map(one).collect::<String>();
    let files = || Memory([("b.toml", file.clone())].into());
    for own in ["cha = false\n", ""] {
        let text = format!("{HOIST}[catalogue]\nfiles = [\"b.toml\"]\n{own}");
        let project = questions::read_all(&text, &files()).unwrap().remove(0);
        let sizing = size(&project);
        let mut seen = 0;
        for candidate in &sizing.candidates {
            let id = candidate.id.to_string();
            let Some(index) = id.strip_prefix("P").and_then(|rest| rest.parse::<usize>().ok()) else { continue };
            let alone = format!("{HOIST}[actuator]\nname = \"x\"\n{}", products[index]);
            let alone = questions::read(&alone).unwrap();
            let alone = check_own(&alone).unwrap();
            let of = |judgement: &sizing::Judgement| {
                let demand = judgement.demand.map(|demand| demand.torque_rms.si().to_bits());
                (demand, judgement.fit(), judgement.governing().map(|check| (check.id, check.utilisation)))
            };
            assert_eq!(of(&candidate.judgement), of(&alone.judgement), "{id}");
            seen += 1;
        }
        assert_eq!(
            seen,
            products.len(),
            "{:?}",
            sizing.candidates.iter().map(|each| each.id.to_string()).collect::<Vec<_>>()
        );
        let sweep =
            Sweep::new(("axis.toml", &text), Box::new(files()), &["mechanism.hoist.mass [kg]"], Options::default());
        let masses = [5.0, 20.0, 40.0, 60.0, 90.0];
        let rows = sweep.unwrap().judge(&[Cells::Numbers(masses.map(Some).to_vec())], &Progress::endless()).unwrap();
        for (row, mass) in rows.iter().zip(masses) {
            let Ok(Judged::Best(best)) = row else { panic!("{row:?}") };
            let text = text.replace("40 kg", &format!("{mass} kg"));
            let project = questions::read_all(&text, &files()).unwrap().remove(0);
            let sizing = size(&project);
            let answer = sizing.answer();
            assert_eq!(best.code.as_ref().map(ToString::to_string), answer.map(|each| each.id.to_string()), "{mass}");
            assert_eq!([best.fit, best.fit_if_estimate].map(|count| count as usize), sizing.counts(), "{mass}");
        }
    }
}

/// No brake of the series states times other than those of the catalogue, for which the demand is computed once.
#[test]
fn the_brakes_of_the_series_share_their_times() {
    let (closing, opening) = embedded_catalogue().brake_times().map(|times| (times.closing, times.opening)).unwrap();
    for product in embedded_catalogue().products(false) {
        let brake = &product.parameters.brake;
        let same =
            |stated: Option<quantities::Time>, of_all: quantities::Time| stated.is_none_or(|stated| stated == of_all);
        assert!(same(brake.closing_time.known().map(|known| known.value), closing), "{:?}", product.parameters.brake);
        assert!(same(brake.opening_time.known().map(|known| known.value), opening), "{:?}", product.parameters.brake);
    }
}
