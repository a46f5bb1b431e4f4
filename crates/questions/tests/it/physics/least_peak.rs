//! An actuator without a stated J_out: what no J_out permits is rejected, what some permits is not checked.

use crate::physics::read;
use questions::{CheckId, Verdict, check_own};
use sizing::Check;

/// Returns the check of the peak torque of an own actuator.
fn peak(axis: &str, torque_max: f64, inertia_out: Option<f64>) -> Check {
    let inertia = inertia_out.map_or_else(String::new, |inertia| format!("inertia_out = \"{inertia} kg m^2\"\n"));
    let text = format!("{axis}\n[actuator]\nname = \"X\"\nratio = 100\ntorque_max = \"{torque_max} N m\"\n{inertia}");
    let project = read(&text);
    let judged = check_own(&project).unwrap().judgement.checks;
    judged.of(CheckId::PeakTorque).cloned().unwrap()
}

/// Axes of every kind of load; in the last the torque falls first with J_out: the heavy side is braked downwards.
#[test]
fn a_torque_that_every_j_out_needs_rejects_an_actuator_without_it() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples");
    let mut axes: Vec<String> = ["tilting-arm", "hoist", "four-bar", "screw-axis", "turntable", "winder"]
        .iter()
        .map(|name| std::fs::read_to_string(format!("{folder}/{name}.toml")).unwrap())
        .collect();
    axes.push(
        "format = 1\n[axis]\nsingle_move = true\n[mechanism.arm]\ninertia = \"1 kg m^2\"\nmass = \"8 kg\"\ncentre_distance = \"0.5 m\"\n\
         start_angle = \"0 deg\"\n[[motion]]\nlaw = \"trapezoid\"\ndistance = \"-20 deg\"\ntime = \"0.4 s\"\n"
            .to_owned(),
    );
    for axis in &axes {
        let value = |inertia: f64| peak(axis, 1.0, Some(inertia)).value.unwrap().si;
        let least = (-40..30).map(|k| value(10.0_f64.powf(f64::from(k) / 10.0))).fold(value(1e-9), f64::min);
        // The least of the grid lies above the least of all by its spacing.
        let too_weak = peak(axis, 0.9 * least, None);
        assert_eq!(too_weak.verdict, Verdict::Fail, "{axis}");
        let bound = too_weak.value.unwrap().si;
        assert!(bound <= least && bound > 0.93 * least, "{bound} {least}: {axis}");
        let perhaps = peak(axis, 1.01 * least, None);
        assert_eq!((perhaps.verdict, perhaps.missing), (Verdict::NotChecked, Some("J_out")), "{axis}");
    }
}
