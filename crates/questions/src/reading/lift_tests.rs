//! Strokes of a scissor lift out of project files.

use quantities::Measure;

/// A stroke up and the same stroke down, in one segment or in two: the platform stands where it began, and the turns
/// are those of the geometry.
#[test]
fn a_scissor_lift_moves_by_the_stroke_of_its_platform() {
    let turns = |segments: &[&str], stages: u32| -> Vec<f64> {
        let motion: String = segments
            .iter()
            .map(|stroke| format!("[[motion]]\nlaw = \"polynomial_5\"\ndistance = \"{stroke}\"\ntime = \"9 s\"\n"))
            .collect();
        let text = format!(
            "format = 1\n[mechanism.scissor_lift]\narm_length = \"700 mm\"\nlead = \"10 mm\"\narm_angle = \"20 deg\"\n\
            mass = \"60 kg\"\nstages = {stages}\n{motion}"
        );
        let project = crate::read(&text).unwrap_or_else(|faults| panic!("{faults:?}"));
        let stretches = project.axis.motion.stretches();
        stretches.iter().map(|each| each.solved.unwrap().distance.si() / std::f64::consts::TAU).collect()
    };
    for stages in [1, 2, 3] {
        // By hand: w = L sin θ, b = √(L² − w²), turns = (b_0 − b)/lead.
        let (l, low): (f64, f64) = (0.7, 0.7 * 20_f64.to_radians().sin());
        let base = |stroke: f64| (l * l - (low + stroke / f64::from(stages)).powi(2)).sqrt();
        for stroke in [0.03, 0.1, 0.2, 0.4] {
            let expected = (base(0.0) - base(stroke)) / 0.01;
            let [up, down] = ["", "-"].map(|sign| format!("{sign}{} mm", 1e3 * stroke));
            let found = turns(&[&up, &down], stages);
            assert!((found[0] - expected).abs() < 1e-9 && (found[0] + found[1]).abs() < 1e-9, "{found:?}, {expected}");
            let half = format!("{} mm", 0.5e3 * stroke);
            let halves = turns(&[&half, &half, &down], stages);
            assert!((halves[0] + halves[1] - expected).abs() < 1e-9, "{halves:?}");
            // After revolutions, the stroke begins at their height.
            let back = turns(&[&format!("{} rev", found[0]), &down], stages);
            assert!((back[1] - found[1]).abs() < 1e-9, "{back:?}");
        }
    }
}
