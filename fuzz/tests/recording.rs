//! Recordings: whatever stands in the file, no panic; a refusal has a place, what is read can be judged.

use fuzz::{any_edits, any_text, explore, mutate};
use std::cell::Cell;
use std::io::Read;
use workbench::text::told;
use workbench::{Files, Language, answer, explain, size};

const PROJECT: &str = "format = 1\n[load]\ninertia = \"0.5 kg m^2\"\nfriction_torque = \"1 N m\"\n[[motion]]\n\
                       law = \"recorded\"\nfile = \"run.csv\"\nstandstill = \"0.01 1/min\"\n\
                       [axis]\nsingle_move = true\n[requirements]\nsupply = \"560 V\"\n";

const ARM: &str = "format = 1\n[mechanism.arm]\ninertia = \"0.5 kg m^2\"\nmass = \"6 kg\"\ncentre_distance = \"0.3 m\"\n\
                   axis_tilt = \"90 deg\"\nstart_angle = \"20 deg\"\nefficiency = 0.9\n[[motion]]\n\
                   law = \"recorded\"\nfile = \"run.csv\"\nsmoothing = \"0.7 s\"\ngaps = \"allow\"\n\
                   [axis]\nsingle_move = true\n";

const JOINT: &str = "format = 1\n[mechanism.joint]\n[[motion]]\nlaw = \"recorded\"\nfile = \"run.csv\"\n\
                     [axis]\nsingle_move = true\n[requirements]\nbrake = true\n";

const CSV: &str = "time [s],q [deg],n [1/min],M [Nm],note\n0,0,0,1.5,a\n0.1,0.3,1,2.5,b\n0.2,1.2,2,3.5,\n0.3,2.1,1,-1.5,x\n\
                   0.4,2.4,0,-2.5,\n0.5,2.4,0,-2.5,\n0.6,2.1,-1,0,\n0.7,1.5,-1,0,y\n0.8,1.2,0,0,z\n";

const GERMAN: &str = "# Logger\nZeit;Winkel;Moment\nms;deg;Nm\n0;0,0;1,5\n100;0,3;2,5\n200;1,2;3,5\n300;2,1;-1,5\n\
                      400;2,4;-2,5\n500;2,1;0,0\n";

struct Only<'t>(&'t [u8]);

impl Files for Only<'_> {
    fn open(&self, _: &str) -> std::io::Result<Box<dyn Read>> {
        Ok(Box::new(std::io::Cursor::new(self.0.to_vec())))
    }
}

fn hold(project: &str, file: &[u8]) -> bool {
    let read = [Language::En, Language::De].map(|language| match workbench::read_all(project, &Only(file)) {
        Ok(projects) => {
            for project in &projects {
                let sizing = size(project);
                for candidate in sizing.candidates.iter().take(3) {
                    for check in &candidate.judgement.checks {
                        let figures = [check.value.map(|f| f.si), check.limit.map(|f| f.si), check.utilisation];
                        assert!(figures.iter().flatten().all(|figure| !figure.is_nan()), "{check:?}");
                    }
                }
                if let Some(best) = sizing.candidates.first()
                    && let workbench::CandidateId::Code(code) = best.id
                    && let Ok(explained) = explain(project, &code)
                {
                    explained.judgement.checks.iter().for_each(|check| drop(answer::explained(check, language)));
                }
            }
            true
        }
        Err(faults) => {
            let faults = told(&faults, language);
            assert!(!faults.is_empty() && faults.iter().all(|fault| !fault.message.is_empty()));
            false
        }
    });
    let [english, german] = read;
    assert_eq!(english, german, "the languages disagree");
    english
}

#[test]
fn recordings_from_any_text() {
    explore(4, |u| {
        hold(u.choose(&[PROJECT, ARM, JOINT])?, any_text(u, 2000)?.as_bytes());
        Ok(())
    });
}

#[test]
fn recordings_from_any_bytes_in_parquet() {
    let project = PROJECT.replace("run.csv", "run.parquet");
    explore(4, |u| {
        let mut bytes = b"PAR1".to_vec();
        bytes.extend(u.bytes(u.len().min(600))?);
        bytes.extend(b"PAR1");
        hold(&project, &bytes);
        Ok(())
    });
}

#[test]
fn recordings_with_a_few_edits() {
    let read = Cell::new(0);
    explore(1, |u| {
        let project = u.choose(&[PROJECT, ARM, JOINT])?;
        let file = u.choose(&[CSV, GERMAN])?;
        let (project, file) = if u.ratio(1, 4)? {
            (mutate(project, &any_edits(u, 3)?), (*file).to_owned())
        } else {
            ((*project).to_owned(), mutate(file, &any_edits(u, 4)?))
        };
        read.set(read.get() + usize::from(hold(&project, file.as_bytes())));
        Ok(())
    });
    assert!(read.get() > 0, "no case was read: the target tries nothing but refusals");
}

#[test]
fn the_starting_points_are_valid() {
    for (project, file) in [(PROJECT, CSV), (ARM, CSV), (JOINT, CSV), (PROJECT, GERMAN), (JOINT, GERMAN)] {
        assert!(hold(project, file.as_bytes()), "{project}{file}");
    }
}
