use super::lag_tests::under;
use super::tests::{arm, direct, jerk, law, lossless, motion};
use super::*;
use motion::Law;

const LAWS: [Law; 5] =
    [Law::ModifiedSine, Law::InclinedSine, Law::Polynomial5, Law::ModifiedTrapezoid, Law::SimpleSine];

/// Returns smooth moves back and forth under several loads.
fn traces() -> Vec<(String, Trace)> {
    let mut traces = Vec::new();
    for (name, load) in [("direct", direct()), ("arm", arm()), ("without losses", lossless())] {
        for each in LAWS {
            let moves = [law(each, 1.3, 0.6), law(each, -0.4, 0.3), law(each, -0.9, 0.55)];
            traces.push((format!("{each:?} {name}"), under(&load, &motion(&moves))));
        }
        traces.push((format!("jerk {name}"), under(&load, &motion(&[jerk(1.0), jerk(-1.0)]))));
    }
    traces
}

/// Returns the largest value at many instants of the polynomials through the nodes, from the signals at the nodes.
fn dense(trace: &Trace, value: impl Fn(&Node) -> f64) -> f64 {
    let mut most = f64::NEG_INFINITY;
    for block in trace.blocks() {
        trace.panels(block, &mut |panel| {
            for step in 0..=4000 {
                most = most.max(value(&rule::between(panel.nodes, f64::from(step) / 4000.0)));
            }
        });
    }
    most
}

fn finds(what: &str, trace: &Trace, sought: &impl Sought) {
    let (found, node) = trace.largest(sought);
    let plain = dense(trace, |node| sought.value(node));
    assert!(found >= plain * (1.0 - 1e-11), "{what}: {found} below {plain}");
    // Between two of those instants the value rises by no more than this.
    assert!(found <= plain * (1.0 + 1e-5), "{what}: {found} above {plain}");
    assert_eq!(sought.value(&node), found, "{what}");
}

#[test]
fn the_largest_value_of_smooth_moves_is_what_a_dense_look_finds() {
    for (name, trace) in traces() {
        for inertia in [0.0, 0.02, 0.3, 2.0, 40.0] {
            finds(&format!("torque, {inertia}, {name}"), &trace, &TorqueWith { inertia_kgm2: inertia });
            let torque = |node: &Node| inertia * node.acceleration_rad_s2 + node.load_nm;
            let power = Any(
                |extent: &Extent| extent.torque(inertia) * extent.speed_rad_s,
                |node: &Node| (torque(node) * node.speed_rad_s).abs(),
            );
            finds(&format!("power, {inertia}, {name}"), &trace, &power);
        }
    }
}

/// The torque over a limit that falls to a corner and rises again: the quotient has a ridge there.
struct OverValley {
    inertia: f64,
    corners: [f64; 1],
}

impl Sought for OverValley {
    fn bound(&self, extent: &Extent) -> f64 {
        extent.torque(self.inertia)
    }

    fn value(&self, node: &Node) -> f64 {
        let torque = (self.inertia * node.acceleration_rad_s2 + node.load_nm).abs();
        torque / (1.0 + 3.0 * (node.speed_rad_s.abs() - self.corners[0]).abs())
    }

    fn corners(&self) -> &[f64] {
        &self.corners
    }
}

#[test]
fn a_ridge_between_the_nodes_is_found() {
    for (name, trace) in traces() {
        for corner in [0.31, 0.77, 1.234, 1.9, 2.5] {
            let sought = OverValley { inertia: 0.3, corners: [corner] };
            let (found, _) = trace.largest(&sought);
            let plain = dense(&trace, |node| sought.value(node));
            assert!(found >= plain * (1.0 - 1e-5), "{name}, {corner}: {found} below {plain}");
        }
    }
}

#[test]
fn the_series_of_a_panel_are_the_polynomials_through_its_nodes() {
    for (name, trace) in traces() {
        for kept in trace.panels.iter().filter(|kept| kept.nodes.len() > 3) {
            let panel = trace.panel(kept);
            let largest =
                |signal: fn(&Node) -> f64| panel.nodes.iter().fold(1e-300, |most, node| signal(node).abs().max(most));
            for step in 0..=64 {
                let s = f64::from(step) / 64.0;
                let (series, plain) = (panel.at(s), rule::between(panel.nodes, s));
                assert_eq!((series.time_s, series.direction), (plain.time_s, plain.direction));
                let signals: [fn(&Node) -> f64; 3] =
                    [|node| node.acceleration_rad_s2, |node| node.load_nm, |node| node.speed_rad_s];
                for signal in signals {
                    let off = (signal(&series) - signal(&plain)).abs() / largest(signal);
                    assert!(off < 1e-13, "{name}, {s}: {off}");
                }
            }
        }
    }
}

/// The instant of the largest speed is that at which the acceleration vanishes, not one beside it at which the speed is equal
/// up to rounding: the torque there is that of the load alone.
#[test]
fn the_torque_at_the_largest_speed_is_that_of_the_load() {
    for each in LAWS {
        for time in [0.35, 0.6, 1.7] {
            let moves = [law(each, 1.4, time), law(each, -1.4, 1.1 * time)];
            let trace = Trace::of(&direct(), &motion(&moves), &[], &[]);
            let speed = Any(|extent: &Extent| extent.speed_rad_s, |node: &Node| node.speed_rad_s.abs());
            let (_, node) = trace.largest(&speed);
            let most = trace
                .largest(&Any(
                    |extent: &Extent| extent.acceleration_rad_s2.0.abs().max(extent.acceleration_rad_s2.1.abs()),
                    |node: &Node| node.acceleration_rad_s2.abs(),
                ))
                .0;
            // A ramp ends with its acceleration at the largest speed.
            let is_ramp = (node.acceleration_rad_s2.abs() - most).abs() <= 1e-9 * most;
            assert!(
                is_ramp || node.acceleration_rad_s2.abs() <= 1e-9 * most,
                "{each:?} in {time} s: {} of {most} rad/s²",
                node.acceleration_rad_s2
            );
        }
    }
}
