//! Refused calls: each names calls that work, in the folder in which it was made.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, reason = "a test fails loudly")]

use crate::run::{Run, run_at};
use std::path::Path;

/// A recording of a turn by 90° in 1 s, with the headings of a logger.
pub(crate) fn recording() -> String {
    let row = |step: u32| {
        let angle = 45.0 * (1.0 - (std::f64::consts::PI * f64::from(step) / 100.0).cos());
        format!("{};{angle:.6};{:.3}\r\n", step * 10, 3.0 + f64::from(step) / 100.0).replace('.', ",")
    };
    let rows: String = (0..=100).map(row).collect();
    format!("Time [ms];ActPos [deg];ActTorque [Nm]\r\n{rows}")
}

const TWO_AXES: &str = r#"format = 1
[[axis]]
name = "tilt"
[axis.mechanism.arm]
mass = "5 kg"
length = "400 mm"
[[axis.motion]]
law = "open"
distance = "90 deg"
time = "1 s"
[[axis.motion]]
law = "open"
distance = "-90 deg"
time = "1 s"
[[axis]]
name = "turn"
[axis.load]
inertia = "1 kg m^2"
[[axis.motion]]
law = "open"
distance = "90 deg"
time = "1 s"
[[axis.motion]]
law = "open"
distance = "-90 deg"
time = "1 s"
"#;

/// Splits a call into its words as a shell does.
fn words(call: &str) -> Vec<String> {
    let mut words = Vec::new();
    for (place, part) in call.split('"').enumerate() {
        if place % 2 == 1 {
            words.push(part.to_owned());
        } else {
            words.extend(part.split_whitespace().map(str::to_owned));
        }
    }
    words
}

pub(crate) fn call(folder: &Path, call: &str) -> Run {
    let words = words(call);
    let words: Vec<&str> = words.iter().skip(1).map(String::as_str).collect();
    run_at(folder, &words)
}

/// Returns the calls that a refusal names.
pub(crate) fn named(refusal: &str) -> Vec<String> {
    let lines = refusal
        .lines()
        .map(|line| line.trim_start().trim_start_matches("write: ").trim_start_matches("so schreiben: "));
    lines.filter(|line| line.starts_with("antrieb ")).map(str::to_owned).collect()
}

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for kind in ["disc", "lift"] {
        let made = call(folder.path(), &format!("antrieb new {kind} --out {kind}.toml"));
        assert_eq!(made.code, 0, "{}", made.err);
    }
    std::fs::write(folder.path().join("machine.toml"), TWO_AXES).unwrap();
    std::fs::write(folder.path().join("log.csv"), recording()).unwrap();
    let made = call(folder.path(), "antrieb new log.csv --out once.toml");
    assert_eq!(made.code, 0, "{}", made.err);
    folder
}

#[test]
fn a_refused_call_names_calls_that_work() {
    for written in [
        "antrieb size disc.toml brake=true 40degC",
        "antrieb size lift.toml +15%",
        "antrieb wiring CHA-25A-50-H-C1024 --for SINAMICS",
        "antrieb sweep disc.toml --ratio 1,2,3",
        "antrieb size disc.toml --mass 10..20kg",
        "antrieb size disc.toml CHA-25A-100-H-?",
        "antrieb drive --eds",
        "antrieb size lift.toml --verbose",
        "antrieb size lift.toml -v",
        "antrieb check lift.toml CHA-25A-50-H-C1024 -v",
        "antrieb battery CHA-25A-100-H-C1024",
        "antrieb data CHA-25A",
        "antrieb wiring CHA-25A-1?0-H-C1024",
        "antrieb upkeep \"CHA-25A-100-H-M*\" --delivered 2026-03-01 --today 2026-04-01",
        "antrieb moves lift.toml --ambient +10degC",
        "antrieb moves lift.toml --ambient +10K",
        "antrieb moves lift.toml --set motion.time=2s",
        "antrieb size machine.toml time=1.5s",
        "antrieb sweep lift.toml mass=10,5kg",
        "antrieb code CHA-25A-100-H-?",
        "antrieb code CHA-25A-1?0-H-M",
        "antrieb code CHA-25A-1?0-H-M?????",
        "antrieb wiring CHA-25A-50-H-C1024 --drive sinamics",
        "antrieb wiring CHA-25A-50-H-C1024 --umrichter=sinamics",
        "antrieb sinamics CHA-25A-50-H-C1024",
        "antrieb machine disc.toml lift.toml",
        "antrieb \"steel disc 12 kg 500 mm diameter\"",
        "antrieb size lift.toml 60kg",
        "antrieb size lift.toml --mass 60",
        "antrieb size lift.toml --mass=60 --top 2",
        "antrieb check lift.toml disc.toml",
        "antrieb check lift.toml lift.toml",
        "antrieb new lift --mass 80 --out new.toml",
        "antrieb new lift --set mass=80",
        "antrieb sweep lift.toml",
        "antrieb sweep lift.toml --mass 40,60",
        "antrieb DE sweep lift.toml --vary mass=40,5kg",
        "antrieb data CHA-25A-50-H-C1024 --pdf",
        "antrieb curve CHA-25A-50-H-C1024 -o curve.pdf",
        "antrieb inertia cylinder steel d=100 l=50",
        "antrieb report lift.toml --out -",
        "antrieb compare lift.toml --code CHA-25A-50-H-C1024",
        "antrieb size lift.toml --tpo 3",
        "antrieb size tilt",
        "antrieb check lfit.toml",
        "antrieb size",
        "antrieb torsion CHA-14A-50-E-D2048",
        "antrieb new sweep disc.toml",
        "antrieb new sweep --from log.csv",
        "antrieb new manual --from log.csv",
        "antrieb check disc.toml thermal",
        "antrieb size disc.toml torque_speed",
    ] {
        let folder = folder();
        let refused = call(folder.path(), written);
        assert_eq!((refused.code, refused.out.as_str()), (2, ""), "{written}\n{}", refused.err);
        let calls = named(&refused.err);
        assert!(!calls.is_empty(), "{written}\n{}", refused.err);
        for meant in calls {
            let answered = call(folder.path(), &meant);
            assert!(answered.code < 2, "{written}: {meant}\n{}", answered.err);
        }
    }
}

/// Words that people append to a call about a project, with a slip, without a unit, or of another command.
const ODD: [&str; 44] = [
    "--cycle 2,3s",
    "--cycle 2,3",
    "--cycle 0.1s",
    "--cycle 3",
    "--payload 5",
    "--payload 0,5,10kg",
    "--payload 5kg",
    "--speed 10",
    "--speed 10,20rpm",
    "--speed 0.1m/s",
    "--time 2",
    "--time 1..2",
    "--time 2,3s",
    "time=",
    "time=2",
    "--pause 1",
    "--pause 1,2s",
    "--distance 45",
    "--distance 10mm",
    "--acceleration 3",
    "--mass 10",
    "--mass 10,20",
    "--mass 10..20kg",
    "--hold",
    "--load 15%",
    "--load 1.15",
    "--load 30",
    "--scale load=49%",
    "--scale time",
    "+15%",
    "--for SINAMICS",
    "--verbose",
    "--quick-stop",
    "--reaction Rampe",
    "--hours 8",
    "--days",
    "--svg p.svg",
    "--pdf",
    "--code CHA-25A-?",
    "CHA-25A-100-H-?",
    "thermal",
    "torque_speed",
    "--vary time=1",
    "--supply 48",
];

/// Every call that a refusal proposes is answered, in the order in which they are proposed.
fn proposals_of(base: &str, folder: &Path) -> Vec<String> {
    let mut failed = Vec::new();
    for odd in ODD {
        let written = format!("antrieb {base} {odd}");
        let refused = call(folder, &written);
        if refused.code < 2 {
            continue;
        }
        for meant in named(&refused.err) {
            // A file that an earlier proposal wrote is no fault of this one.
            let forced = if meant.contains(" --out ") { format!("{meant} --force") } else { meant.clone() };
            let answered = call(folder, &forced);
            if answered.code > 1 {
                failed.push(format!("{written}\n  {meant}\n  {}", answered.err.lines().next().unwrap_or_default()));
            }
        }
    }
    failed
}

macro_rules! proposals_work {
    ($($name:ident $base:literal;)*) => {
        $(#[test]
        fn $name() {
            let failed = proposals_of($base, folder().path());
            assert!(failed.is_empty(), "{}", failed.join("\n"));
        })*
    };
}

proposals_work! {
    what_a_refused_sweep_proposes_works "sweep disc.toml";
    what_a_refused_sizing_proposes_works "size lift.toml";
    what_a_refused_check_proposes_works "check disc.toml";
    what_a_refused_simulation_proposes_works "simulate disc.toml";
    what_a_refused_new_project_proposes_works "new disc";
}

/// Calls of which the first creates what the others need.
#[test]
fn a_call_that_needs_several_steps_names_all_of_them() {
    let (written, folder) = ("antrieb new sweep lift.toml", folder());
    let refused = call(folder.path(), written);
    let calls = named(&refused.err);
    assert_eq!((refused.code, calls.len()), (2, 2), "{}", refused.err);
    let made = call(folder.path(), &calls[0]);
    assert_eq!(made.code, 0, "{}\n{}", calls[0], made.err);
    let empty = tempfile::tempdir().unwrap();
    // A recorded run is simulated first, unless the folder has one.
    for written in ["antrieb identify", "antrieb identify lift.toml"] {
        for has_recording in [true, false] {
            let folder = self::folder();
            if !has_recording {
                std::fs::remove_file(folder.path().join("log.csv")).unwrap();
            }
            let calls = named(&call(folder.path(), written).err);
            assert_eq!(calls.len(), if has_recording { 1 } else { 2 }, "{written}: {calls:?}");
            for meant in calls.iter().filter(|_| !has_recording) {
                let done = call(folder.path(), meant);
                assert!(done.code < 2, "{meant}\n{}", done.err);
            }
        }
    }
    for written in ["antrieb size", "antrieb size lift.toml", "antrieb report", "antrieb size --mass 60kg"] {
        let calls = named(&call(empty.path(), written).err);
        assert!(calls[0].starts_with("antrieb new "), "{calls:?}");
        assert_eq!(call(empty.path(), &format!("{} --force", calls[0])).code, 0, "{calls:?}");
        std::fs::read_dir(empty.path()).unwrap().for_each(|file| std::fs::remove_file(file.unwrap().path()).unwrap());
    }
}

#[test]
fn calls_as_people_write_them_are_answered() {
    let folder = folder();
    for (written, part) in [
        ("antrieb DE size disc.toml", "geeignet"),
        ("antrieb simulate disc.toml --hours 8", "--days 1"),
        ("antrieb heat disc.toml 8h", "--days 1 --hours-per-day 8h"),
        ("antrieb cable CHA-25A-100-H-M512P", "Wiring of"),
        ("antrieb commission CHA-25A-100-H-M512P --regler sinamics", "Commissioning of"),
        (
            "antrieb commission disc.toml CHA-25A-100-H-M512P --for sinamics",
            "understood as: antrieb commission CHA-25A",
        ),
        ("antrieb wiring CHA-25A-100-H-M512P disc.toml", "Wiring of"),
        ("antrieb check disc.toml CHA-25A-100-H-M512P --help", "Usage"),
        ("antrieb battery CHA-14A-30-H-M128S -h", "Usage"),
        ("antrieb size nothing.toml --nothing 3 --help --lang de", "Aufruf"),
        ("antrieb glossary peak speed", "--check peak_speed"),
        ("antrieb glossary Torsionswinkel", "--check torsion"),
        ("antrieb code list brake", "CHA-14A-30-N-D2048-B"),
        ("antrieb code \"CHA-25A-*-B\"", "CHA-25A-100-H-C1024-B"),
        ("antrieb encoder CHA-25A-100-H-M512P 30deg", "M512P"),
        ("antrieb help torsion", "Usage"),
        ("antrieb size lift", "understood as: antrieb size lift.toml"),
        ("antrieb check disc.toml CHA-25A-50-H-C1024 CHA-32A-50-H-C1024", "understood as: antrieb compare disc.toml"),
        ("antrieb check disc.toml --code CHA-25A-50-H-C1024 --code CHA-32A-50-H-C1024", "antrieb compare disc.toml"),
        ("antrieb size -v", "antrieb 0."),
        ("antrieb simulate disc.toml --quick-stop --reaction Rampe", "emergency_stop"),
        ("antrieb simulate disc.toml --scenario Netzausfall", ""),
        ("antrieb plot disc.toml --figure Auslastung --theme dunkel", "<svg"),
        ("antrieb export disc.toml --table Nachweise", "continuous_torque"),
        ("antrieb wiring CHA-25A-50-H-C1024 --svg - --connector Geber", "<svg"),
        ("antrieb sweep disc.toml --cycle 3s,4s", "motion[4].time [s]"),
        ("antrieb drive disc.toml --eds", "[DeviceInfo]"),
        ("antrieb size disc.toml DE", "geeignet"),
        ("antrieb AUSLEGEN disc.toml --Sprache Deutsch --TOP 2", "geeignet"),
        ("antrieb size disc.toml brake=true", "requirements.brake"),
        ("antrieb size machine.toml tilt", "tilt"),
        ("antrieb check lift.toml \"motion.1.time=4 s\"", "motion[1].time"),
        ("antrieb moves lift.toml --set \"Motion[1].TIME=4 s\"", "motion[1].time"),
        ("antrieb moves machine.toml --axis TILT mass=4kg", "axis[1].mechanism.arm.mass 5 kg → 4kg"),
        ("antrieb moves machine.toml --axis 1 mass=4kg", "axis[1].mechanism.arm.mass 5 kg → 4kg"),
        ("antrieb size machine.toml tilt.mass=4kg", "axis[1].mechanism.arm.mass 5 kg → 4kg"),
        ("antrieb size machine.toml mass=4kg", "axis[1].mechanism.arm.mass 5 kg → 4kg"),
        ("antrieb size machine.toml --scale load=1.5", "axis[2].load.inertia 1 kg m^2 → 1.5 kg m^2"),
        ("antrieb wiring lift.toml --set mass=60kg", "mass=60kg"),
        ("antrieb lift.toml CHA-25A-50-H-C1024", "understood as: antrieb check lift.toml --code"),
        ("antrieb size lift.toml --no-brake", "requirements.brake – → false"),
        ("antrieb moves lift.toml --with-brake", "requirements.brake – → true"),
        ("antrieb size lift.toml --format json", "\"ranking\""),
        (
            "antrieb inertia disc diameter=300 mm length=20mm mass=5kg tube outer=60mm inner=52mm length=1m mass=2kg",
            "7.000 kg",
        ),
        ("antrieb new log.csv", "recorded"),
        ("antrieb new lift mass=200kg supply=48V", "mass = \"200kg\""),
        ("antrieb simulate disc.toml Emergency stop at 0.4s", "0.4"),
        ("antrieb plot disc.toml torque speed", "<svg"),
        ("antrieb wiring lift.toml", "Wiring of CHA-"),
        ("antrieb mount lift.toml", "Mounting of CHA-"),
        ("antrieb data disc.toml", "the best of the ranking, CHA-"),
        ("antrieb torsion lift.toml 5Nm", "5.000 Nm"),
        ("antrieb commission disc.toml sinamics", "Commissioning of CHA-"),
        ("antrieb lift --mass 80kg", "mass = \"80kg\""),
        ("antrieb lift --mass 80 kg", "mass = \"80 kg\""),
        ("antrieb neu Spindel masse=12,5kg", "mass = \"12.5kg\""),
        ("antrieb lift.toml", "understood as: antrieb size lift.toml"),
        ("antrieb CHA-20A-100-H-C1024", "understood as: antrieb data CHA-20A-100-H-C1024"),
        ("antrieb size lift.toml --mass 60kg", "understood as: antrieb size lift.toml --set mechanism.hoist.mass=60kg"),
        ("antrieb size lift.toml --load +15%", "--scale load=1.15"),
        ("antrieb size lift.toml --load 1.15", "load × 1.15"),
        ("antrieb size lift.toml load=+15%", "load × 1.15"),
        ("antrieb size lift.toml --scale load=+15%", "load × 1.15"),
        ("antrieb new disc stations=8", "distance = \"45 deg\""),
        ("antrieb new disc --stations 8", "distance = \"45 deg\""),
        ("antrieb size disc.toml stations=6", "motion[3].distance -90 deg → 60 deg"),
        ("antrieb size lift.toml --brake", "requirements.brake – → true"),
        ("antrieb size lift.toml --set bremse=ja", "requirements.brake – → true"),
        ("antrieb size lift.toml --scale Last=1.1", "load × 1.1"),
        ("antrieb check machine.toml --axis tilt --mass 4kg", "axis[1].mechanism.arm.mass 5 kg → 4kg"),
        ("antrieb sweep lift.toml --mass 20,40kg", "CHA-"),
        ("antrieb sweep lift.toml mass=20..40kg motion.1.time=4s,6s", "CHA-"),
        ("antrieb sweep lift.toml --mass 20,40kg --json", "\"mechanism.hoist.mass [kg]\": \"40\""),
        ("antrieb code CHA-20A-100", "code complete CHA-20A-100"),
        ("antrieb code CHA-20A-100-H-C1024", "code parse CHA-20A-100-H-C1024"),
        ("antrieb code \"CHA-25A-1?0-H-M*\"", "CHA-25A-120-H-M512P"),
        ("antrieb simulate disc.toml --estop", "--scenario emergency_stop"),
        ("antrieb compare lift.toml CHA-25A-50-H-C1024", "compared with the best of the ranking: CHA-"),
        ("antrieb inertia cylinder steel d=100mm l=50mm", "density=7850kg/m^3"),
        ("antrieb inertia cylinder 100mm x 50mm steel", "3.083 kg"),
        ("antrieb inertia \"box 50mm 40mm 20mm 2kg\"", "a=50mm b=40mm height=20mm mass=2kg"),
        ("antrieb new lift --mass 80kg --stroke 1m --time 2s", "motion[3].distance -500 mm → -1m"),
        ("antrieb new lift mass=80kg hub=1m pause=3s", "motion[4].time 2 s → 3s"),
        ("antrieb new belt --mass 20kg --speed 2m/s --distance 1m", "motion[3].time 2 s → –"),
        ("antrieb new lift 80kg", "mass = \"80kg\""),
        ("antrieb why lift.toml thermal", "winding temperature"),
        ("antrieb curve CHA-25A-50-H-C1024 --png", "--png CHA-25A-50-H-C1024.png"),
        ("antrieb inertia Zylinder Stahl d=100mm l=50mm", "3.083 kg"),
    ] {
        let found = call(folder.path(), written);
        assert!(
            found.code < 2 && (found.out + &found.err).contains(part),
            "{written}\n{}",
            call(folder.path(), written).err
        );
    }
    for (written, file) in [
        ("antrieb report lift.toml", "lift.pdf"),
        ("antrieb export lift.toml --xlsx", "lift.xlsx"),
        ("antrieb export lift.toml --csv --table demand", "lift.csv"),
        ("antrieb curve CHA-25A-50-H-C1024 -o curve.png", "curve.png"),
        ("antrieb report lift.toml mass=45kg", "lift_mass=45kg.pdf"),
        ("antrieb report lift.toml --scale load=1.1 --set \"ambient=35 degC\"", "lift_ambient=35degC_load=1.1.pdf"),
    ] {
        let report = call(folder.path(), written);
        assert!(report.code < 2 && folder.path().join(file).is_file(), "{written}\n{}", report.err);
    }
    for (written, part) in [
        ("antrieb new lift --set nonsense=5", "valid here: axis.name, mechanism.hoist"),
        ("antrieb new lift --set mas=5kg", "did you mean `mechanism.hoist.mass`?"),
        ("antrieb new lift --set mass=abc", "mechanism.hoist.mass"),
        ("antrieb new lift --set mass=1,200kg", "mechanism.hoist.mass"),
        ("antrieb new lift --set mass=5m", "mechanism.hoist.mass"),
        ("antrieb new lift --set motion[1].law=foo", "motion[1].law"),
        ("antrieb plot disc.toml temperature", "torque_speed"),
        ("antrieb new sweep --key \"motion[1].time [s] = 1..3\" mass=3kg", "--key"),
    ] {
        let refused = call(folder.path(), written);
        assert!(refused.code == 2 && refused.err.contains(part), "{written}\n{}", refused.err);
    }
    let both = call(folder.path(), "antrieb size lift.toml time=3s");
    assert!(both.err.contains("motion[1].time 5 s → 3s; motion[3].time 5 s → 3s"), "{}", both.err);
}

/// A number that is typed stays the number of the proposed call; an unknown option is what is wrong, not the code before it.
#[test]
fn a_refusal_keeps_what_is_typed_and_names_what_is_wrong() {
    let folder = folder();
    for (typed, message, proposed) in [
        ("torsion CHA-20A-100-H-C1024 75,5Nm", "75,5Nm", &["--torque 75.5Nm"][..]),
        ("torsion CHA-20A-100-H-C1024 75", "75", &["--torque \"75 N m\"", "--angle \"75 deg\""]),
        ("torsion CHA-20A-100-H-C1024 60kg", "60kg", &[]),
        ("battery CHA-20A-100-H-M512P --duration 16", "unknown option \"--duration\"", &["--hours-per-day"]),
        ("simulate disc.toml CHA-20A-100-H-C1024 --frob", "unknown option \"--frob\"", &[]),
        (
            "size disc.toml --set ambient=45",
            "ambient",
            &["antrieb size disc.toml --set \"requirements.ambient=45 degC\""],
        ),
    ] {
        let run = call(folder.path(), &format!("antrieb {typed}"));
        assert_eq!(run.code, 2, "{typed}: {}", run.err);
        let first = run.err.lines().next().unwrap();
        assert!(first.contains(message), "{typed}: {}", run.err);
        for each in proposed {
            assert!(run.err.contains(each), "{typed}: {}", run.err);
        }
        assert!(!run.err.contains("60 N m"), "{typed}: {}", run.err);
    }
}

/// A recording says nothing about the mass of the machine: no figure of a template stands in its project.
#[test]
fn a_project_of_a_recording_has_no_figures_of_a_template() {
    let folder = folder();
    std::fs::write(folder.path().join("turn.csv"), "t [s];q [deg]\n0;0\n0,1;5\n0,2;0\n").unwrap();
    std::fs::write(folder.path().join("line.csv"), "t [s];x [mm];F [N]\n0;0;1\n0,1;5;2\n0,2;0;1\n").unwrap();
    for (file, missing) in [("turn.csv", &["load.inertia"][..]), ("line.csv", &["pulley_diameter"])] {
        let made = call(folder.path(), &format!("antrieb new recording --from {file} --out {file}.toml"));
        assert_eq!(made.code, 0, "{}", made.err);
        let run = call(folder.path(), &format!("antrieb size {file}.toml"));
        assert_eq!(run.code, 2, "{file}: {}", run.out);
        for key in missing {
            assert!(run.err.contains(key), "{file}: {}", run.err);
        }
    }
}

/// The datum that a product of a catalogue file lacks is named; it has neither an ordering code nor a manual.
#[test]
fn a_product_of_a_file_names_the_datum_that_it_lacks() {
    for (question, more, german) in [("curve", &[][..], "n_N"), ("torsion", &["--torque", "10 N m"], "K_1")] {
        let file = ["--catalogue", "examples/catalogue/stock.csv"];
        let run = crate::run::run(&[&[question, "XD-20-80"], more, &file, &["--lang", "de"]].concat());
        assert_eq!(run.code, 2, "{}", run.out);
        assert!(run.err.contains("XD-20-80: nicht bekannt") && run.err.contains(german), "{}", run.err);
        assert!(!run.err.contains("Bestell"), "{}", run.err);
    }
}
