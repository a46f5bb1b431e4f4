//! Setpoints at the cycle of a controller, of every law of motion and of every example.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test fails loudly")]

use axis::{AxisProject, Files};
use project::SegmentLaw;
use quantities::{Language, Measure, Time};
use questions::list::new::{template, template_kinds};
use questions::{NoSetpoints, moves, setpoints};
use std::collections::BTreeSet;
use std::io::Read;
use std::path::PathBuf;

struct Folder(PathBuf);

impl Files for Folder {
    fn open(&self, name: &str) -> std::io::Result<Box<dyn Read>> {
        Ok(Box::new(std::fs::File::open(self.0.join(name))?))
    }
}

/// Returns the axes of the examples and of the new projects, and one for each law that a distance and a time determine, turning and along a line.
fn projects() -> Vec<(String, AxisProject)> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let files = std::fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path());
    let files = files.filter(|path| path.extension().is_some_and(|ending| ending == "toml"));
    let mut all = Vec::new();
    for path in files {
        let text = std::fs::read_to_string(&path).unwrap();
        let read = questions::read_all(&text, &Folder(folder.clone())).unwrap();
        all.extend(read.into_iter().map(|project| (path.display().to_string(), project)));
    }
    for kind in template_kinds() {
        let Some(made) = template(kind, "axis", Language::En) else { continue };
        if let Ok(project) = questions::read(&made.text) {
            all.push((format!("new {kind}"), project));
        }
    }
    let belt = "mechanism.belt]\npulley_diameter = \"128 mm\"\nmass = \"4 kg\"";
    let arm = "mechanism.arm]\nlength = \"300 mm\"\nmass = \"3 kg\"";
    for law in SegmentLaw::all().filter(|law| law.of_a_move().is_some()) {
        for (mechanism, distance) in [(belt, "317 mm"), (arm, "77 deg")] {
            let moved = |sign: &str| {
                format!("[[motion]]\nlaw = \"{}\"\ndistance = \"{sign}{distance}\"\ntime = \"0.731 s\"\n", law.id())
            };
            let text = format!(
                "format = 1\n[{mechanism}\n{}[[motion]]\nlaw = \"dwell\"\ntime = \"0.2 s\"\n{}",
                moved(""),
                moved("-")
            );
            if let Ok(project) = questions::read(&text) {
                all.push((format!("{} {distance}", law.id()), project));
            }
        }
    }
    all
}

#[test]
fn positions_and_speeds_agree_and_the_ends_are_exact() {
    let mut laws = BTreeSet::new();
    for (name, project) in projects() {
        let (found, motion) = (moves(&project), &project.axis.motion);
        laws.extend(found.moves.iter().map(|each| each.law.id()));
        let is_recorded = found.moves.iter().any(|each| each.recording.is_some());
        let most =
            |of: usize| found.moves.iter().filter_map(|each| each.course).map(|c| c[of].abs()).fold(0.0, f64::max);
        let (speed, acceleration) = (most(1), most(2));
        let end = motion.duration().si();
        for step in [end, end / 7.0, end / 100.0, 0.002_f64.max(end / 50_000.0), 0.013_f64.max(end / 20_000.0)] {
            let points = setpoints(&project, &found, Time::from_si(step)).unwrap();
            let rows = &points.rows;
            let (first, last) = (rows[0], rows[rows.len() - 1]);
            assert!(first[0] == 0.0 && (last[0] - end).abs() <= 1e-12 * end, "{name}: {last:?}");
            let net = motion.net().si() * found.per_output;
            let range = rows.iter().fold(most(0), |most, row| most.max(row[1].abs())).max(net.abs());
            assert!(
                (last[1] - first[1] - net).abs() <= 1e-9 * range.max(speed * end),
                "{name}: {net} {first:?} {last:?}"
            );
            for pair in rows.windows(2) {
                let [[t0, q0, v0, a0], [t1, q1, v1, _]] = [pair[0], pair[1]];
                let h = t1 - t0;
                assert!(h > 0.0 && h <= step * (1.0 + 1e-9), "{name}: {t0} {t1}");
                // The trapezoid of the speeds misses the position by the acceleration over a step at most; the positions of a
                // recording are those of its samples, whose speeds are smoothed.
                let of_samples = if is_recorded { 0.1 * speed * h + 1e-3 * range } else { 0.0 };
                let most = acceleration * h * h / 2.0 + 1e-9 * range + of_samples;
                assert!((q1 - q0 - h * (v0 + v1) / 2.0).abs() <= most, "{name}: {t0}: {q0} {q1} {v0} {v1}");
                assert!((v1 - v0).abs() <= acceleration * h * (1.0 + 1e-6) + 1e-9 * speed, "{name}: {t0}: {v0} {v1}");
                assert!(v0.abs() <= speed * (1.0 + 1e-9) && a0.abs() <= acceleration * (1.0 + 1e-9), "{name}: {t0}");
            }
        }
        // Every move ends where its distance says, whatever the step.
        for (stretch, each) in motion.stretches().iter().zip(&found.moves) {
            let [from, to] = [stretch.start.si(), stretch.start.si() + stretch.duration.si()].map(Time::from_si);
            let way = (motion.at(to).position_rad - motion.at(from).position_rad) * found.per_output;
            let distance = each.course.map_or(0.0, |[distance, ..]| distance);
            let scale = each.course.map_or(1.0, |[distance, speed, _]| distance.abs().max(speed * each.duration.si()));
            assert!((way - distance).abs() <= 1e-9 * scale.max(1e-6), "{name}: {way} {distance}");
        }
    }
    let all: BTreeSet<&str> = SegmentLaw::all().map(SegmentLaw::id).collect();
    let missing: Vec<&&str> = all.difference(&laws).collect();
    assert!(missing.is_empty(), "{missing:?}");
}

#[test]
fn a_step_that_gives_no_table_is_refused() {
    let (_, project) = projects().pop().unwrap();
    let found = moves(&project);
    let of = |step: f64| setpoints(&project, &found, Time::from_si(step)).map(|points| points.rows.len());
    assert_eq!([of(0.0), of(-1.0), of(f64::NAN)], [Err(NoSetpoints::NoStep); 3]);
    assert_eq!(of(1e-9), Err(NoSetpoints::TooMany));
    let end = project.axis.motion.duration().si();
    assert_eq!(of(2.0 * end), Ok(2), "both ends");
    assert_eq!(of(end / 4.0), Ok(5));
    assert_eq!(of(end / 4.5), Ok(6), "the rest of a step");
}
