//! Ropes cannot push: the times of slack of a hoist and of a counterweight.

use crate::physics::{checks, of, read};
use quantities::Language;
use questions::{CheckId, Verdict};

const CODE: &str = "CHA-25A-100-H-C1024";

fn hoist(more: &str, motion: &str) -> String {
    format!(
        "format = 1\n[axis]\nsingle_move = true\n[mechanism.hoist]\ndrum_diameter = \"300 mm\"\nmass = \"5 kg\"\ninertia = \"0.05 kg m^2\"\n{more}{motion}"
    )
}

fn trapezoid(distance: &str, speed: &str, acceleration: &str, more: &str) -> String {
    format!(
        "[[motion]]\nlaw = \"trapezoid\"\ndistance = \"{distance}\"\nspeed = \"{speed}\"\nacceleration = \"{acceleration}\"\n{more}"
    )
}

/// Lowered with 20 m/s² up to 3 m/s: the motion takes 5 kg · 20 m/s² off the rope, which bears 5 kg · g, for 0.15 s. Braking pulls.
#[test]
fn lowering_faster_than_a_free_fall_leaves_the_rope_slack() {
    let project = read(&hoist("", &trapezoid("-1 m", "3 m/s", "20 m/s^2", "")));
    let check = of(&project, CODE, CheckId::RopeTension);
    assert_eq!(check.verdict, Verdict::Fail);
    assert!((check.value.unwrap().si - 100.0).abs() < 1e-9, "{check:?}");
    assert!((check.limit.unwrap().si - 5.0 * 9.806_65).abs() < 1e-9 && check.relation() == Some(">"), "{check:?}");
    assert!((check.utilisation.unwrap() - 20.0 / 9.806_65).abs() < 1e-9);
    let note = words::note_text(&check.notes[0], Language::En);
    assert!(note.starts_with("the rope of the load would be slack from 0.000 s to 0.150 s:"), "{note}");
    assert!(words::note_text(&check.notes[0], Language::De).contains("von 0,000 s bis 0,150 s"));
}

/// Lifted with 12 m/s² the rope of a counterweight would push, and braked so that of the load; at 9 m/s² nothing is slack.
#[test]
fn a_counterweight_falls_no_faster_than_free() {
    let with = |acceleration: &str| {
        let project = read(&hoist("counterweight = \"3 kg\"\n", &trapezoid("1 m", "2 m/s", acceleration, "")));
        of(&project, CODE, CheckId::RopeTension)
    };
    let slack = with("12 m/s^2");
    assert_eq!(slack.verdict, Verdict::Fail);
    // 12 m/s² up to 2 m/s takes a sixth of a second, as does braking at the end of 2/3 s.
    let note = words::note_text(&slack.notes[0], Language::En);
    let expected = "the rope of the load would be slack from 0.500 s to 0.667 s; \
                    the rope of the counterweight would be slack from 0.000 s to 0.167 s:";
    assert!(note.starts_with(expected), "{note}");
    assert_eq!(with("9 m/s^2").verdict, Verdict::Pass);
    assert!(with("9 m/s^2").notes.is_empty());
}

/// A process force upwards that is larger than the weight: slack all the time, at rest too.
#[test]
fn an_upward_process_force_slackens_the_rope() {
    let dwell = "[[motion]]\nlaw = \"dwell\"\ntime = \"2 s\"\nprocess_force = \"-60 N\"\n";
    let project = read(&hoist("", &format!("{}{dwell}", trapezoid("1 m", "0.5 m/s", "1 m/s^2", ""))));
    let check = of(&project, CODE, CheckId::RopeTension);
    assert_eq!(check.verdict, Verdict::Fail);
    // 1 m with 1 m/s² up to 0.5 m/s takes 2.5 s.
    let note = words::note_text(&check.notes[0], Language::En);
    assert!(note.starts_with("the rope of the load would be slack from 2.500 s to 4.500 s:"), "{note}");
}

#[test]
fn what_has_no_rope_has_no_such_check() {
    let text = "format = 1\n[load]\ninertia = \"1 kg m^2\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n";
    assert!(checks(&read(text), CODE).iter().all(|check| check.id != CheckId::RopeTension));
    let slide = |counterweight: &str| {
        let text = format!(
            "format = 1\n[mechanism.screw]\nlead = \"20 mm\"\nmass = \"8 kg\"\ninclination = \"90 deg\"\n{counterweight}{}{}",
            trapezoid("0.2 m", "0.5 m/s", "5 m/s^2", ""),
            trapezoid("-0.2 m", "0.5 m/s", "5 m/s^2", "")
        );
        checks(&read(&text), CODE).iter().any(|check| check.id == CheckId::RopeTension)
    };
    assert!(slide("counterweight = \"4 kg\"\n") && !slide(""));
}

/// The hoist of the examples keeps its rope taut.
#[test]
fn the_example_is_taut() {
    let project = read(include_str!("../../../../../examples/hoist.toml"));
    assert_eq!(of(&project, CODE, CheckId::RopeTension).verdict, Verdict::Pass);
}
