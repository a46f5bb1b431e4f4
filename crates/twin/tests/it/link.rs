//! The DC link between the edges of its supply and the largest voltage of the actuator.

use super::{NOTHING, load, one_move, parameters};
use quantities::{ElectricPotential, Measure};
use twin::{EventKind, Parameters, Setup, Supply, Twin};

/// Brakes a heavy load from speed, so that energy is regenerated.
fn braked(code: &str, supply: Supply, inertia: f64, rpm: f64) -> (Parameters, twin::Summary, Vec<EventKind>) {
    let actuator = parameters(code).actuator;
    let parameters = Parameters::on_supply(&actuator, &supply);
    let (mechanism, motion, extras) = (load(inertia, 0.0), one_move(rpm, 0.15, 0.1, 0.1), NOTHING());
    let mut twin = Twin::new(&Setup { supply, ..Setup::of(&parameters, &mechanism, &motion, &extras) }).unwrap();
    twin.advance(u64::MAX);
    let (events, summary) = (twin.events().iter().map(|event| event.kind).collect(), twin.summary());
    drop(twin);
    (parameters, summary, events)
}

/// 230 V, 400 V and 48 V windings from far below U_DCmax up to it: where a threshold of the resistor exists, the link stays below
/// U_DCmax and nothing trips; where none does, it passes U_DCmax and the drive of the twin goes on.
#[test]
fn braking_keeps_the_link_below_its_largest_voltage_wherever_a_resistor_can() {
    for (code, inertia, rpm, supplies) in [
        ("CHA-25A-50-H-C1024", 4.0, 60.0, [320.0, 486.0, 560.0, 591.0, 622.0, 650.0, 659.0, 660.0, 670.0, 680.0]),
        ("CHA-14A-50-E-RES", 0.5, 30.0, [20.0, 24.0, 30.0, 36.0, 40.0, 44.0, 46.0, 46.56, 47.0, 48.0]),
    ] {
        for most_v in supplies {
            for share in [1.0, 0.8] {
                let supply = Supply { least_v: share * most_v, nominal_v: 0.9 * most_v, most_v };
                let (parameters, summary, events) = braked(code, supply, inertia, rpm);
                let limit = parameters.actuator.dc_link_max.known().unwrap().value;
                let has_room = most_v < 0.97 * limit.si();
                let thresholds = actuator::chopper_thresholds(ElectricPotential::from_si(most_v), Some(limit));
                assert_eq!(thresholds.is_some(), has_room, "{most_v}");
                let [_, highest] = summary.link_v;
                assert!(
                    summary.energies.regenerated_j > 0.0 && highest >= most_v - 1e-9,
                    "{code} {most_v} {summary:?}"
                );
                assert!(
                    !events.contains(&EventKind::LinkHigh) && !events.contains(&EventKind::LinkLow),
                    "{code} {most_v}"
                );
                assert!(!has_room || highest <= limit.si(), "{code} {most_v}: {highest}");
                // The supply alone never feeds the resistor.
                let threshold = parameters.model.chopper_on.value * most_v;
                assert!(threshold > most_v && parameters.model.chopper_off.value > 1.0, "{code} {most_v}");
                assert!(summary.resistor_j == 0.0 || highest > threshold, "{code} {most_v}");
            }
        }
    }
}

/// Assumed parts of the drive: 470 µF, 1 Ω and 82 Ω at 560 V; the same current at 48 V has 5.5 mF, 86 mΩ and 7.0 Ω.
#[test]
fn the_assumed_parts_of_the_drive_scale_with_its_voltage() {
    for (code, volt, [capacity, supply, resistor]) in [
        ("CHA-25A-50-H-C1024", 560.0, [470e-6, 1.0, 82.0]),
        ("CHA-14A-50-E-RES", 48.0, [470e-6 * 560.0 / 48.0, 48.0 / 560.0, 82.0 * 48.0 / 560.0]),
    ] {
        let model = Parameters::on_supply(&parameters(code).actuator, &Supply::of(volt)).model;
        let farad = 2.0 * model.link_energy.value / (volt * volt);
        assert!((farad / capacity - 1.0).abs() < 1e-3, "{volt}: {farad}");
        assert!((model.supply_resistance.value / supply - 1.0).abs() < 1e-12);
        assert!((model.brake_resistor.value / resistor - 1.0).abs() < 1e-12);
    }
}

/// With mains ± 10 % currents are those of the low edge, the largest voltage that of the high one; both edges give the same where
/// they are one.
#[test]
fn the_mains_are_taken_at_both_edges() {
    let edges = Supply { least_v: 486.0, nominal_v: 566.0, most_v: 622.0 };
    let (_, both, _) = braked("CHA-25A-50-H-C1024", edges, 4.0, 60.0);
    let (_, low, _) = braked("CHA-25A-50-H-C1024", Supply::of(486.0), 4.0, 60.0);
    let (_, high, _) = braked("CHA-25A-50-H-C1024", Supply::of(622.0), 4.0, 60.0);
    assert!((both.link_v[0] / low.link_v[0] - 1.0).abs() < 0.01, "{both:?} {low:?}");
    assert_eq!(both.current_peak_a, low.current_peak_a);
    assert!((both.link_v[1] / high.link_v[1] - 1.0).abs() < 0.01 && both.link_v[1] > 622.0, "{both:?} {high:?}");
}
