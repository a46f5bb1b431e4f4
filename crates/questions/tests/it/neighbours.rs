//! Results found once for actuators that share a drivetrain or an output bearing equal those of each alone.
#![allow(clippy::unwrap_used, reason = "a test may fail")]

use crate::catalogue_actuators;
use axis::Files;
use questions::{Candidate, Progress, Rejected, Verdict};
use sizing::{Check, Depth, Judge, Scope};

struct Examples;

impl Files for Examples {
    fn open(&self, name: &str) -> std::io::Result<Box<dyn std::io::Read>> {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/");
        Ok(Box::new(std::fs::File::open(format!("{folder}{name}"))?))
    }
}

/// Stands for the keys of a project: a name for the governing move, so that one given twice or for another move shows.
fn named(check: &mut Check, governing: usize) {
    let name = |key: &str| provenance::Source::Project { key: format!("{key} of move {governing}").into() };
    for source in [&mut check.value_source, &mut check.limit_source].into_iter().flatten() {
        if let provenance::Source::Project { key } = source {
            *source = name(&key.to_string());
        }
    }
}

/// A light move and a heavy one, of which each governs for some own inertia: (J + 0.2)·10 + 0 and (J + 0.2)·9 + friction.
const TURNING: &str = r#"
format = 1
[axis]
name = "two moves"
[load]
inertia = "1 kg m^2"
friction_torque = "5 N m"
[[motion]]
law = "manual"
speed = "20 1/min"
accelerate = "0.1 s"
run = "0.3 s"
brake = "0.1 s"
pause = "0.5 s"
[[motion]]
law = "manual"
speed = "-30 1/min"
accelerate = "0.2 s"
run = "0.1 s"
brake = "0.1 s"
pause = "0.2 s"
[bearing]
axial_force = "2000 N"
radial_force = "900 N"
radial_distance = "30 mm"
axial_distance = "80 mm"
load_factor = 1.0
operating_condition = "normal"
[requirements]
supply = "560 V"
ambient = "30 degC"
"#;

/// An arm that swings so often that its cycle is no short one, each time by another angle, with a limit for what comes back.
fn swinging() -> String {
    let head = "format = 1\n[axis]\nname = \"swings\"\n[mechanism.arm]\naxis_tilt = \"90 deg\"\nmass = \"4 kg\"\n\
        centre_distance = \"200 mm\"\nstart_angle = \"-60 deg\"\nfriction_torque = \"0.5 N m\"\ninertia = \"0.3 kg m^2\"\n\
        [requirements]\nregeneration_power_max = \"0.5 W\"\n";
    let swing = |angle: u32| {
        [1.0, -1.0].map(|sign| {
            let distance = sign * f64::from(angle);
            format!("[[motion]]\nlaw = \"modified_sine\"\ndistance = \"{distance} deg\"\ntime = \"0.4 s\"\n")
        })
    };
    head.to_owned() + &(20..60).flat_map(swing).collect::<String>()
}

/// The axes of all examples.
fn examples() -> Vec<axis::AxisProject> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples");
    let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let texts = files.filter(|path| path.extension().is_some_and(|end| end == "toml"));
    texts
        .flat_map(|path| questions::read_all(&std::fs::read_to_string(path).unwrap(), &Examples).unwrap_or_default())
        .collect()
}

#[test]
fn what_neighbours_share_each_has_alone() {
    let mut projects = examples();
    projects.extend(questions::read_all(TURNING, &Examples).unwrap());
    assert!(projects.len() > 5);
    for project in &projects {
        for (scope, depth) in
            [(Scope::All, Depth::Complete), (Scope::Ranking, Depth::UntilRejected), (Scope::Deciding, Depth::Complete)]
        {
            let mut all = Judge::new(&project.axis, scope, depth);
            // Of a long cycle some neighbours show it as well as all of them.
            let most = if project.axis.is_short() { usize::MAX } else { 12 };
            for (code, parameters) in catalogue_actuators().take(most) {
                let together = all.next(parameters, &mut named);
                let alone = Judge::new(&project.axis, scope, depth).next(parameters, &mut named);
                assert_eq!(format!("{together:?}"), format!("{alone:?}"), "{}, {code}", project.name);
                assert_eq!(together.utilisation(), alone.utilisation());
            }
        }
    }
}

/// Checks in the order of the output, shared or not.
#[test]
fn the_order_of_the_checks_is_the_same_for_every_actuator() {
    let project = questions::read(TURNING).unwrap();
    let mut judge = Judge::new(&project.axis, Scope::All, Depth::Complete);
    let order = |judge: &mut Judge<'_>, parameters| -> Vec<_> {
        judge.next(parameters, &mut |_, _| {}).checks.iter().map(|check| check.id).take(20).collect()
    };
    let mut orders = catalogue_actuators().map(|(_, parameters)| order(&mut judge, parameters));
    let first = orders.next().unwrap();
    assert_eq!(first.len(), 20);
    assert!(orders.all(|other| other == first));
}

/// The energy that comes back is found for many in one pass over a long cycle: it is what each of them has alone.
#[test]
fn what_a_cycle_gives_back_is_found_for_many_as_for_one() {
    let mut projects = examples();
    projects.extend(questions::read_all(&swinging(), &Examples).unwrap());
    let (mut seen, mut failed) = (0, 0);
    for project in projects.iter().filter(|project| !project.axis.is_short()) {
        let all = questions::size(project).candidates;
        let mut judge = Judge::new(&project.axis, Scope::All, Depth::Complete);
        for candidate in all.iter().filter(|candidate| candidate.fits()).take(20) {
            let energy = |checks: &sizing::Checks| {
                let energy = checks.iter().find(|check| check.id == sizing::CheckId::Regeneration).unwrap();
                (energy.value, energy.verdict, energy.notes.clone())
            };
            let alone = judge.next(candidate.parameters, &mut |_, _| {});
            let ids = |checks: &sizing::Checks| checks.iter().map(|check| check.id).collect::<Vec<_>>();
            assert_eq!(ids(&candidate.judgement.checks), ids(&alone.checks), "{}, {}", project.name, candidate.id);
            let (together, alone) = (energy(&candidate.judgement.checks), energy(&alone.checks));
            assert_eq!(format!("{together:?}"), format!("{alone:?}"), "{}, {}", project.name, candidate.id);
            seen += 1;
        }
        let by_energy =
            |each: &&Candidate<'_>| each.governing().map(|check| check.id) == Some(sizing::CheckId::Regeneration);
        failed += all.iter().filter(by_energy).count();
        assert!(all.is_sorted_by(|a, b| sizing::rank(&a.standing, &b.standing).is_le()), "{}", project.name);
    }
    assert!(seen > 40 && failed > 10, "{seen} seen, {failed} failed by it");
}

/// The best three are the same whether three or all are reported in full, and so are all others, except for regenerated
/// energy without a limit.
#[test]
fn a_ranking_is_the_same_however_many_are_reported_in_full() {
    let limited = format!("{TURNING}regeneration_power_max = \"1 W\"\n");
    let mut projects = examples();
    let seen = [TURNING, &limited, &swinging()].map(|text| questions::read(text).unwrap());
    projects.extend(seen);
    let (mut left_out, mut decided) = (0, 0);
    for project in &projects {
        let all = questions::size(project).candidates;
        let some = questions::list::size::sized(project, 3, Rejected::All, &Progress::endless()).unwrap().candidates;
        assert_eq!(all.len(), some.len());
        for (place, (full, short)) in all.iter().zip(&some).enumerate() {
            let energy = |each: &Candidate<'_>| {
                each.judgement.checks.iter().find(|check| check.id == sizing::CheckId::Regeneration).cloned()
            };
            let advice = |each: &Candidate<'_>| {
                each.judgement.checks.iter().filter(|check| check.verdict == Verdict::Advice).count()
            };
            let said = |each: &Candidate<'_>| {
                let id = |check: Option<&Check>| check.map(|check| check.id);
                (each.id.to_string(), each.standing, each.open_questions(), advice(each), id(each.governing()))
            };
            assert_eq!(said(full), said(short), "{}", project.name);
            if place < 3 && full.fits() {
                assert_eq!(format!("{:?}", full.judgement), format!("{:?}", short.judgement), "{}", project.name);
            }
            left_out += u32::from(energy(full).is_some() && energy(short).is_none());
            decided += u32::from(energy(short).is_some_and(|check| check.verdict == Verdict::Fail));
        }
    }
    assert!(left_out > 100 && decided > 10, "{left_out} left out, {decided} decided by it");
}
