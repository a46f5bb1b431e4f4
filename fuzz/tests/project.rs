//! Project files: whatever the text, no panic; a refusal has a place, an answer has no NaN.

use fuzz::{any_edits, any_text, explore, mutate};
use workbench::answers::{self, Number};
use workbench::quantities::Measure;
use workbench::text::told;
use workbench::{
    Assessment, Candidate, CandidateId, Language, Project, Sampling, Verdict, answer, assess, place, size,
};

/// Enough samples to go through everything.
const FEW: Sampling = Sampling { samples: 5, seed: 1 };

const FULL: &str = r#"
format = 1
[axis]
name = "full"
[load]
inertia = "1.3 kg m^2"
friction_torque = "5 N m"
[[motion]]
law = "manual"
speed = "40 1/min"
accelerate = "0.1 s"
run = "0.1 s"
brake = "0.1 s"
pause = "1 s"
[bearing]
radial_force = "500 N"
radial_distance = "50 mm"
axial_force = "200 N"
axial_distance = "30 mm"
load_factor = 1.2
operating_condition = "normal"
[requirements]
feedback = ["M512P"]
hollow_shaft_min = "18 mm"
length_max = "300 mm"
mass_max = "20 kg"
brake = true
supply = "560 V"
ambient = "40 degC"
bearing_life_min = "20000 h"
tilt_angle_max = "1 arcmin"
gear_life_min = "20000 h"
torsion_max = "2 arcmin"
natural_frequency_min = "10 Hz"
option_1 = "EC"
[actuator]
name = "own"
ratio = 50
torque_max = "127 N m"
speed_max = "112 1/min"
speed_motor_rated = "3500 1/min"
inertia_out = "1.063 kg m^2"
stall_torque = "49 N m"
stall_current = "1.9 A"
current_max = "4.9 A"
current_demagnetisation = "20 A"
no_load_starting_current = "0.2 A"
no_load_current_constant_30 = "1e-3 A/(1/min)"
torque_constant_out = "30 N m/A"
torque_constant_motor = "0.6 N m/A"
resistance_ll = "5 ohm"
mass = "5 kg"
continuous_curve = [["0 1/min", "50 N m"], ["70 1/min", "30 N m"]]
"#;

const STARTS: [&str; 9] = [
    include_str!("../../examples/indexing-table.toml"),
    include_str!("../../examples/manual-example.toml"),
    include_str!("../../examples/two-way-shuttle.toml"),
    include_str!("../../examples/tilting-arm.toml"),
    include_str!("../../examples/screw-axis.toml"),
    include_str!("../../examples/belt-axis.toml"),
    include_str!("../../examples/turntable.toml"),
    include_str!("../../examples/tolerances.toml"),
    FULL,
];

/// What a check compares is finite, before JSON could turn a NaN into null.
fn checks_are_finite(candidate: &Candidate<'_>) {
    for check in &candidate.judgement.checks {
        let judged = check.verdict != Verdict::NotChecked;
        for figure in [check.value, check.limit] {
            assert!(!judged || figure.is_some(), "{check:?}");
            assert!(figure.is_none_or(|figure| figure.si.is_finite() && figure.value().is_finite()), "{check:?}");
        }
        assert!(check.utilisation.is_none_or(|share| share.is_finite() && share >= 0.0), "{check:?}");
        assert!(check.at.is_none_or(|at| at.si().is_finite()), "{check:?}");
        assert!(judged || check.missing.is_some(), "{check:?}");
    }
    // Infinite where a limit of zero is exceeded: that candidate cannot fit.
    let share = candidate.standing.utilisation;
    assert!(share.is_finite() || (share == f64::INFINITY && !candidate.fits()), "{:?}", candidate.standing);
    let failing = candidate.judgement.checks.iter().any(|check| check.verdict == Verdict::Fail);
    assert!(!(candidate.fits() && failing), "{:?}", candidate.id);
    // Of a user's own actuator a requirement may stay open without breaking it.
    let of_the_catalogue = matches!(candidate.id, CandidateId::Code(_));
    assert!(candidate.fits() || failing || !candidate.objections.is_empty(), "{:?}", candidate.id);
    assert!(!of_the_catalogue || !candidate.fits() || candidate.objections.is_empty(), "{:?}", candidate.id);
}

/// Every verdict that compares numbers has both of them; JSON would turn a NaN or an infinity into null.
fn checks_are_whole(candidate: &answers::Candidate) {
    let written = |number: Option<Number>| number.and_then(Number::written);
    for check in &candidate.checks {
        let judged = *check.verdict != Verdict::NotChecked;
        assert!(!judged || (written(check.value).is_some() && written(check.limit).is_some()), "{check:?}");
        assert!(judged || check.missing.is_some(), "{check:?}");
    }
    if let Some(demand) = &candidate.demand {
        let it = &demand.figures;
        for number in [it.torque_rms, it.torque_peak, it.speed_mean, it.speed_peak, it.duty_factor] {
            assert!(number.written().is_some(), "{demand:?}");
        }
    }
}

/// Counts that add up, values within their bands, quantiles in order.
fn assessment_is_sound(project: &Project, found: &Assessment) {
    assert!(found.passes + found.impossible <= found.sampling.samples, "{found:?}");
    assert!((0.0..=1.0).contains(&found.interval.0) && (0.0..=1.0).contains(&found.interval.1), "{found:?}");
    let quantiles = [0.0, found.utilisation.p05, found.utilisation.p50, found.utilisation.p95, found.utilisation.max];
    assert!(quantiles.windows(2).all(|pair| pair[0] <= pair[1]), "{found:?}");
    assert_eq!(found.worst.values.len(), project.tolerances.len());
    for (tolerance, value) in project.tolerances.iter().zip(&found.worst.values) {
        let rounding = 1e-12 * (tolerance.nominal.abs() + tolerance.half_width);
        assert!((value - tolerance.nominal).abs() <= tolerance.half_width + rounding, "{tolerance:?} {value}");
    }
    let total: f64 = found.influence.iter().map(|each| each.share).sum();
    assert!(found.influence.is_empty() || (total - 1.0).abs() < 1e-9, "{found:?}");
}

/// Holds a project to its promises in both languages; says whether it was read.
fn hold(text: &str) -> bool {
    let refused = [Language::En, Language::De].map(|language| match workbench::read(text) {
        Ok(project) => {
            let sizing = size(&project);
            sizing.candidates.iter().chain(&sizing.own).for_each(checks_are_finite);
            let best: Vec<&Candidate<'_>> = sizing.candidates.iter().take(2).chain(&sizing.own).collect();
            let assessed: Vec<_> = assess(&project, &best, FEW).into_iter().zip(best).map(|(a, b)| (b, a)).collect();
            assert_eq!(assessed.is_empty(), project.tolerances.is_empty());
            for (_, found) in &assessed {
                assessment_is_sound(&project, found);
            }
            let record = answer::sizing(&sizing, &project, &assessed, 1, language);
            record.ranking.iter().for_each(|each| checks_are_whole(&each.of.candidate));
            record.own.iter().for_each(|own| checks_are_whole(&own.candidate));
            if let Some(first) = sizing.candidates.first() {
                checks_are_whole(&answer::candidate(first, language));
            }
            None
        }
        Err(faults) => {
            let faults = told(&faults, language);
            assert!(!faults.is_empty());
            for fault in &faults {
                assert!(fault.line >= 1 && fault.column >= 1 && !fault.message.is_empty(), "{fault:?}");
                assert!(text.get(fault.span.clone()).is_some(), "{text:?}: {fault:?}");
                assert_eq!((fault.line, fault.column), place(text, fault.span.start), "{fault:?}");
            }
            Some(faults.into_iter().map(|fault| fault.span).collect::<Vec<_>>())
        }
    });
    let [english, german] = &refused;
    assert_eq!(english, german, "{text:?}: the languages disagree about the faults");
    english.is_none()
}

#[test]
fn projects_from_any_text() {
    explore(4, |u| {
        hold(&any_text(u, 3000)?);
        Ok(())
    });
}

#[test]
fn projects_with_a_few_edits() {
    let mut read = 0;
    explore(1, |u| {
        let start = u.choose(&STARTS)?;
        read += usize::from(hold(&mutate(start, &any_edits(u, 6)?)));
        Ok(())
    });
    assert!(read > 0, "no case was read: the target tries nothing but refusals");
}

/// Valid files with extreme numbers: the arithmetic must stay finite or be refused.
#[test]
fn projects_with_extreme_numbers() {
    let numbers = ["0", "1e-300", "1e-12", "1e-9", "1e-3", "1", "-1", "1e3", "1e9", "1e12", "1e300", "1.7e308"];
    let mut read = 0;
    explore(2, |u| {
        // Every second part stands between quotes; of a quantity it is the number and the rest is the unit.
        let mut parts: Vec<String> = FULL.split('"').map(str::to_owned).collect();
        for part in parts.iter_mut().skip(1).step_by(2).filter(|part| part.starts_with(|c: char| c.is_ascii_digit())) {
            if u.ratio(1, 6)? {
                let unit = part.split_once(' ').map_or("", |(_, unit)| unit);
                *part = format!("{} {unit}", u.choose(&numbers)?);
            }
        }
        read += usize::from(hold(&parts.join("\"")));
        Ok(())
    });
    assert!(read > 0, "no case was read: the target tries nothing but refusals");
}

/// Tolerances of any width behind the quantities of valid files: what is read can be judged.
#[test]
fn projects_with_tolerances() {
    let halves =
        ["0 %", "1 %", "10 %", "99.9 %", "100 %", "200 %", "-1 %", "1e9 %", "1e-9 %", "1 K", "1 mm", "NaN %", ""];
    let signs = ["±", "+-", " +/- ", " ± "];
    let mut read = 0;
    explore(1, |u| {
        let mut parts: Vec<String> = (*u.choose(&STARTS)?).split('"').map(str::to_owned).collect();
        for part in parts.iter_mut().skip(1).step_by(2).filter(|part| part.starts_with(|c: char| c.is_ascii_digit())) {
            if u.ratio(1, 8)? {
                *part = format!("{part}{}{}", u.choose(&signs)?, u.choose(&halves)?);
            }
        }
        read += usize::from(hold(&parts.join("\"")));
        Ok(())
    });
    assert!(read > 0, "no case was read: the target tries nothing but refusals");
}

#[test]
fn the_starting_points_are_valid() {
    for start in STARTS {
        assert!(workbench::read(start).is_ok());
        hold(start);
    }
}

#[test]
fn inputs_that_once_were_hard() {
    // One project per paragraph that begins with a line of `---`.
    let corpus = include_str!("../corpus/projects.txt");
    let texts: Vec<&str> = corpus.split("---\n").skip(1).collect();
    assert!(texts.len() > 10);
    for text in texts {
        hold(text);
    }
}
