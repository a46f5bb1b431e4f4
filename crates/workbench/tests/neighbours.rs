//! What is found once for actuators that share a drivetrain or an output bearing is what each of them has alone.
#![allow(clippy::unwrap_used, reason = "a test may fail")]

use configurator::catalogue_actuators;
use sizing::{Check, Depth, Judge};
use workbench::Files;

struct Examples;

impl Files for Examples {
    fn open(&self, name: &str) -> std::io::Result<Box<dyn std::io::Read>> {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/");
        Ok(Box::new(std::fs::File::open(format!("{folder}{name}"))?))
    }
}

/// Stands for the keys of a project: a name that tells which move governs, so that one given twice or for another move shows.
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

#[test]
fn what_neighbours_share_each_has_alone() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples");
    let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let texts = files.filter(|path| path.extension().is_some_and(|end| end == "toml"));
    let mut projects: Vec<_> = texts
        .flat_map(|path| workbench::read_all(&std::fs::read_to_string(path).unwrap(), &Examples).unwrap_or_default())
        .collect();
    projects.extend(workbench::read_all(TURNING, &Examples).unwrap());
    assert!(projects.len() > 5);
    for project in &projects {
        for depth in [Depth::Survivors, Depth::Margins] {
            let mut all = Judge::of(&project.axis, depth);
            // Of a long cycle some neighbours show it as well as all of them.
            let most = if project.axis.is_short() { usize::MAX } else { 12 };
            for (code, parameters) in catalogue_actuators().iter().take(most) {
                let together = all.next(parameters, &mut named);
                let alone = Judge::of(&project.axis, depth).next(parameters, &mut named);
                assert_eq!(format!("{together:?}"), format!("{alone:?}"), "{}, {code}", project.name);
                assert_eq!(together.utilisation(), alone.utilisation());
                assert_eq!(together.checks.len(), together.checks.iter().count());
            }
        }
    }
}

/// Checks in the order in which they are told, whoever else has them.
#[test]
fn the_order_of_the_checks_is_the_same_for_every_actuator() {
    let project = workbench::read(TURNING).unwrap();
    let mut judge = Judge::of(&project.axis, Depth::Full);
    let order = |judge: &mut Judge<'_>, parameters| -> Vec<_> {
        judge.next(parameters, &mut |_, _| {}).checks.iter().map(|check| check.id).take(20).collect()
    };
    let mut orders = catalogue_actuators().iter().map(|(_, parameters)| order(&mut judge, parameters));
    let first = orders.next().unwrap();
    assert_eq!(first.len(), 20);
    assert!(orders.all(|other| other == first));
}
