//! Project files: what is read, what is refused, and with which words.

use crate::reading::schema;
use axis::Assumption;
use axis::{AxisProject, NoFiles, Varied};
use project::PROJECT_MAX_BYTES;
use quantities::{Language, Measure};
use sizing::CheckId;
use words::Worded;

const GOOD: &str = r#"
format = 1
[axis]
name = "axis"
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
"#;

fn faults(text: &str) -> Vec<Worded> {
    words::worded(&crate::read(text).expect_err("must be refused"), Language::En)
}

fn one(text: &str) -> Worded {
    let mut found = faults(text);
    assert_eq!(found.len(), 1, "{found:#?}");
    found.remove(0)
}

#[test]
fn a_good_project_is_read() {
    let project = crate::read(GOOD).unwrap();
    assert_eq!(project.name, "axis");
    assert!((project.axis.motion.duration().si() - 1.3).abs() < 1e-12);
    assert_eq!(
        project.assumptions,
        [
            Assumption::Default(project::KeyDefault::AmbientWithinRange),
            Assumption::ConditionsWithinRange,
            Assumption::CoolingPlate,
            Assumption::Default(project::KeyDefault::NoSupply),
            Assumption::NoFlangeLoads,
            Assumption::Default(project::KeyDefault::OrdinaryApplication),
        ]
    );
}

#[test]
fn the_full_project_of_the_documentation_is_read() {
    let text = format!(
        "{GOOD}{}",
        r#"
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
brake = true
supply = "560 V"
ambient = "40 degC"
[actuator]
name = "CanisDrive-25A-50"
"#
    );
    let project = crate::read(&text).unwrap();
    assert!(project.assumptions.contains(&Assumption::FlangeLoadsConstant));
    let sizing = crate::size(&project);
    let answer = sizing.answer().unwrap();
    assert!(answer.id.to_string().ends_with("-H-M512P-B"), "{}", answer.id);
    let verdict = |id| answer.judgement.checks.iter().find(|check| check.id == id).map(|check| check.verdict);
    assert_eq!(verdict(CheckId::Ambient), Some(sizing::Verdict::Pass));
    assert_eq!(verdict(CheckId::BearingTiltingMoment), Some(sizing::Verdict::Pass));
    assert_eq!(verdict(CheckId::BearingStatic), Some(sizing::Verdict::Pass));
    assert_eq!(verdict(CheckId::BearingLife), Some(sizing::Verdict::NotChecked), "no life is required");
}

#[test]
fn all_faults_are_reported_at_once_in_the_order_of_the_file() {
    let text = GOOD
        .replace("1.3 kg m^2", "-1.3 kg m^2")
        .replace("5 N m", "5 kg")
        .replace("speed =", "sped =")
        .replace("\"1 s\"", "1");
    let found = faults(&text);
    let lines: Vec<usize> = found.iter().map(|fault| fault.line).collect();
    assert_eq!(found.len(), 5, "{found:#?}");
    assert!(lines.is_sorted());
    let all: String = found.iter().map(|fault| format!("{} {:?}\n", fault.message, fault.hint)).collect();
    assert!(all.contains("must not be negative"), "{all}");
    assert!(all.contains("unit of mass"), "{all}");
    assert!(all.contains("did you mean `speed`?"), "{all}");
    assert!(all.contains("number without a unit"), "{all}");
    assert!(all.contains("`motion[1].speed` is missing"), "{all}");
}

#[test]
fn the_place_of_a_fault_is_the_offending_text() {
    let text = GOOD.replace("40 1/min", "40 rpn");
    let fault = one(&text);
    assert_eq!(&text[fault.span.clone()], "rpn");
    assert_eq!((fault.line, fault.column), (10, 13));
}

#[test]
fn numbers_that_are_none_are_refused() {
    for wrong in ["NaN s", "inf s", "-inf s", "1e999 s", "0,1 s", "s", "", "0.1", "0.1 1/min", "1 000 s"] {
        let fault = one(&GOOD.replace("accelerate = \"0.1 s\"", &format!("accelerate = \"{wrong}\"")));
        assert_eq!(fault.line, 11, "{wrong}: {fault:?}");
    }
    for wrong in ["nan", "inf", "0.1", "5", "true", "[]", "{}", "1979-05-27"] {
        let fault = one(&GOOD.replace("accelerate = \"0.1 s\"", &format!("accelerate = {wrong}")));
        assert_eq!(fault.line, 11, "{wrong}: {fault:?}");
    }
}

#[test]
fn magnitudes_that_no_machine_has_are_refused() {
    for wrong in ["1e13 s", "1e-13 s", "1e-320 s"] {
        let fault = one(&GOOD.replace("pause = \"1 s\"", &format!("pause = \"{wrong}\"")));
        assert!(fault.message.contains("implausible"), "{fault:?}");
    }
}

#[test]
fn a_cycle_without_time_is_refused() {
    let still = GOOD.replace("40 1/min", "0 1/min").replace("0.1 s", "0 s").replace("\"1 s\"", "\"0 s\"");
    assert!(one(&still).message.contains("no duration"));
    let jump = GOOD.replace("accelerate = \"0.1 s\"", "accelerate = \"0 s\"");
    let fault = one(&jump);
    assert!(fault.message.contains("greater than zero"), "{fault:?}");
    assert_eq!(fault.line, 11);
}

#[test]
fn what_is_missing_is_named_with_an_example() {
    let fault = one(&GOOD.replace("inertia = \"1.3 kg m^2\"\n", ""));
    assert!(fault.message.contains("`load.inertia` is missing"));
    assert!(fault.hint.unwrap().contains("1.3 kg m^2"));
    assert!(faults("").iter().any(|fault| fault.message.contains("`format` is missing")));
    assert!(one("format = 1\n[load]\ninertia = \"1 kg m^2\"\n").message.contains("[[motion]]"));
}

#[test]
fn a_misspelt_mechanism_is_one_fault() {
    let text = GOOD.replace("[load]", "[mechanism.skrew]");
    let fault = one(&text);
    assert!(fault.message.contains("`mechanism.skrew`"), "{fault:?}");
    assert!(fault.hint.as_deref().unwrap().contains("screw"), "{fault:?}");
}

#[test]
fn broken_toml_is_no_panic_and_hides_no_other_fault_as_missing() {
    let found = faults(&GOOD.replace("[load]", "[load"));
    assert!(found.iter().any(|fault| fault.message.contains("TOML")), "{found:?}");
    for text in ["\u{0}\u{1}\u{2}", "= = =", "[[[[[[", "a = \"\u{7f}", "format = 1\nformat = 1", &"[".repeat(5000)] {
        assert!(!faults(text).is_empty());
    }
}

/// The cost of a refusal grows with the file, not with its square: 1 MiB full of faults is answered at once.
#[test]
fn a_file_full_of_faults_is_answered_at_once() {
    for piece in ["=\n", "a=0\n", "feedback=[\"x\"]\n", "[[motion]]\nlaw=1\n"] {
        let most = if piece.starts_with("[[") { 9_000 } else { usize::MAX };
        let text = piece.repeat(((PROJECT_MAX_BYTES - 1) / piece.len()).min(most));
        let found = faults(&text);
        assert!(found.len() <= 52, "{piece:?}: {}", found.len());
        assert!(found.iter().any(|fault| fault.message.contains("more faults")), "{piece:?}: {:?}", found.last());
    }
}

#[test]
fn a_large_file_is_refused_before_it_is_read() {
    let text = "#".repeat(PROJECT_MAX_BYTES + 1);
    assert!(one(&text).message.contains("bytes"));
}

#[test]
fn unknown_words_get_the_nearest_one() {
    let text = format!("{GOOD}[requirements]\nfeedback = [\"M512\"]\nbrake = \"yes\"\n");
    let found = faults(&text);
    assert_eq!(found.len(), 2, "{found:?}");
    assert!(found[0].hint.as_deref().unwrap().contains("M512P"));
    assert!(found[1].message.contains("true or false"));
    let german = words::worded(&crate::read(&text).unwrap_err(), Language::De);
    assert!(german[0].hint.as_deref().unwrap().contains("gemeint ist vielleicht"));
}

#[test]
fn an_own_actuator_may_be_known_in_part_or_by_a_curve() {
    let text = format!(
        "{GOOD}[actuator]\nname = \"own\"\ninertia_out = \"1 kg m^2\"\nspeed_motor_rated = \"3500 1/min\"\nratio = 50\n\
         continuous_curve = [[\"0 1/min\", \"50 N m\"], [\"70 1/min\", \"30 N m\"]]\n"
    );
    let project = crate::read(&text).unwrap();
    let own = crate::check_own(&project).unwrap();
    let check = own.judgement.checks.iter().find(|check| check.id == CheckId::ContinuousTorque).unwrap();
    assert_eq!(check.verdict, sizing::Verdict::Pass);
    let torque = own.judgement.checks.iter().find(|check| check.id == CheckId::PeakTorque).unwrap();
    assert_eq!((torque.verdict, torque.missing), (sizing::Verdict::NotChecked, Some("T_max")));
    let bad = text.replace("[\"70 1/min\", \"30 N m\"]", "[\"0 1/min\", \"30 N m\"]");
    assert!(one(&bad).message.contains("must increase"));
}

#[test]
fn the_schema_knows_every_key_and_refuses_others() {
    let schema = schema(Language::En);
    let root = schema["properties"].as_object().unwrap();
    assert!(root.contains_key("load") && root.contains_key("motion") && root.contains_key("requirements"));
    assert_eq!(schema["additionalProperties"], false);
    assert_eq!(schema["required"], serde_json::json!(["format"]));
    let laws = root["motion"]["items"]["properties"]["law"]["enum"].as_array().unwrap();
    let conditions = root["motion"]["items"]["allOf"].as_array().unwrap();
    assert_eq!(laws.len(), conditions.len(), "every law says which keys it needs");
    assert_eq!(schema["oneOf"].as_array().unwrap().len(), 2, "one axis or several");
    assert_eq!(schema["oneOf"][0]["oneOf"].as_array().unwrap().len(), 2, "load or mechanism");
}

/// The ambient conditions of the CHA tables must not be cited for an actuator of another maker.
#[test]
fn the_tables_of_the_catalogue_do_not_speak_for_an_own_actuator() {
    let text =
        format!("{GOOD}[requirements]\nambient = \"60 degC\"\n[actuator]\nname = \"own\"\nstall_current = \"2 A\"\n");
    let project = crate::read(&text).unwrap();
    assert!(project.assumptions.contains(&Assumption::OwnStallCurrentIncludesFriction));
    let ambient = |candidate: &crate::Candidate<'_>| {
        candidate.judgement.checks.iter().find(|check| check.id == CheckId::Ambient).map(|check| check.verdict)
    };
    assert_eq!(ambient(&crate::check_own(&project).unwrap()), Some(sizing::Verdict::NotChecked));
    let sizing = crate::size(&project);
    assert!(sizing.candidates.iter().all(|candidate| ambient(candidate) == Some(sizing::Verdict::Fail)));
}

const HEAD: &str = "format = 1\n";

fn messages(text: &str) -> Vec<String> {
    words::worded(&crate::read(text).unwrap_err(), Language::En).into_iter().map(|fault| fault.message).collect()
}

#[test]
fn a_screw_axis_may_be_written_along_its_line() {
    let text = |distance: &str, speed: &str| {
        format!(
            "{HEAD}[mechanism.screw]\nlead = \"20 mm\"\nmass = \"80 kg\"\ninclination = \"90 deg\"\nefficiency = 0.9\n\
             [[motion]]\nlaw = \"jerk\"\ndistance = \"{distance}\"\nspeed = \"{speed}\"\n\
             acceleration = \"2 m/s^2\"\njerk = \"50 m/s^3\"\npayload = \"20 kg\"\n\
             [[motion]]\nlaw = \"dwell\"\ntime = \"0.4 s\"\nhold = \"brake\"\n\
             [[motion]]\nlaw = \"jerk\"\ndistance = \"-300 mm\"\nspeed = \"0.2 m/s\"\n\
             acceleration = \"2 m/s^2\"\njerk = \"50 m/s^3\"\n"
        )
    };
    let line = crate::read(&text("300 mm", "0.2 m/s")).unwrap();
    // 300 mm at 20 mm a revolution are 15 revolutions; 0.2 m/s are 10 revolutions a second.
    let turning = crate::read(&text("15 rev", "10 rev/s")).unwrap();
    let solved = |project: &AxisProject| project.axis.motion.stretches()[0].solved.unwrap();
    assert!((solved(&line).time.si() - solved(&turning).time.si()).abs() < 1e-12);
    // T = d/v + v/a + a/j by hand: 1.5 + 0.1 + 0.04.
    assert!((solved(&line).time.si() - 1.64).abs() < 1e-12);
    assert!(line.assumptions.contains(&Assumption::Default(project::KeyDefault::LossesDoNotHelp)));
    let one_way = text("300 mm", "0.2 m/s").replace("-300 mm", "-200 mm");
    assert!(messages(&one_way)[0].contains("does not close"), "{:?}", messages(&one_way));
    assert!(crate::read(&format!("{one_way}[axis]\nsingle_move = true\n")).is_ok());
}

#[test]
fn a_turntable_of_bodies_is_the_load_they_sum_to() {
    let text = |load: &str| format!("{HEAD}{load}\n{}", &GOOD[GOOD.find("[[motion]]").unwrap()..]);
    let bodies = "[mechanism.turntable]\nbodies = [\"point mass=2kg distance=500mm\", \"point mass=1kg distance=1m\"]";
    let turntable = crate::read(&text(bodies)).unwrap();
    let direct = crate::read(&text("[load]\ninertia = \"1.5 kg m^2\"")).unwrap();
    let own = quantities::MomentOfInertia::from_si(0.3);
    let rms = |project: &AxisProject| project.axis.demand(own).torque_rms.si();
    assert!((rms(&turntable) / rms(&direct) - 1.0).abs() < 1e-12);
    let bad = text("[mechanism.turntable]\nbodies = [\"point mass=2kg distance=500mm\", \"cylindr mass=1kg\"]");
    let fault = crate::read(&bad).unwrap_err().remove(0);
    assert_eq!(&bad[fault.span.clone()], "cylindr");
}

#[test]
fn what_does_not_belong_together_is_refused() {
    let tail = "[[motion]]\nlaw = \"triangle\"\ndistance = \"90 deg\"\ntime = \"1 s\"\n";
    let both = format!(
        "{HEAD}[load]\ninertia = \"1 kg m^2\"\n[mechanism.belt]\npulley_diameter = \"80 mm\"\nmass = \"5 kg\"\n{tail}"
    );
    assert!(messages(&both)[0].contains("one load"));
    assert!(messages(&format!("{HEAD}{tail}"))[0].contains("`[load]` or a table"));
    let load = "[load]\ninertia = \"1 kg m^2\"\n";
    let of = |motion: &str| messages(&format!("{HEAD}{load}[[motion]]\n{motion}\n")).remove(0);
    assert!(
        of("law = \"triangle\"\ndistance = \"90 deg\"").contains("do not determine this move (quantities stated: 1")
    );
    assert!(of("law = \"triangle\"\ndistance = \"90 mm\"\ntime = \"1 s\"").contains("no fixed travel"));
    assert!(
        of("law = \"triangle\"\ndistance = \"90 deg\"\ntime = \"1 s\"\nrun = \"1 s\"").contains("no meaning with law")
    );
    assert!(of("law = \"jerk\"\ndistance = \"90 deg\"").contains("`motion[1].speed` is missing"));
    assert!(of("law = \"trapezoid\"\ndistance = \"1 rad\"\ntime = \"1 s\"\nspeed = \"0.5 rad/s\"").contains("too low"));
    assert!(of("law = \"triangle\"\ndistance = \"0 deg\"\ntime = \"1 s\"").contains("must not be zero"));
    let crank =
        "[mechanism.slider_crank]\ncrank = \"100 mm\"\nrod = \"90 mm\"\nmass = \"1 kg\"\nstart_angle = \"0 deg\"\n";
    assert!(messages(&format!("{HEAD}{crank}{tail}"))[0].contains("longer than the crank"));
}

/// The text of a fault's place.
fn place_of(text: &str) -> (String, Worded) {
    let fault = one(text);
    (text.get(fault.span.clone()).unwrap().to_owned(), fault)
}

#[test]
fn a_tolerance_is_read_wherever_a_quantity_stands() {
    let text = r#"
format = 1
[mechanism.turntable]
bodies = ["cylinder diameter=300mm±1mm length=20mm density=7850kg/m^3 ± 2 %", "point mass=2kg+-0.1kg distance=100mm"]
[[motion]]
law = "trapezoid"
distance = "90 deg"
time = "0.5 s +/- 10 ms"
[[motion]]
law = "trapezoid"
distance = "90 deg ± 1 arcmin"
time = "0.5 s"
[motion.bearing]
radial_force = "500 N ± 50 N"
radial_distance = "50 mm"
[bearing]
mechanism = "add"
[requirements]
ambient = "30 degC ± 5 K"
[actuator]
name = "own"
mass = "5 kg ± 1 %"
continuous_curve = [["0 1/min", "50 N m ± 5 %"], ["70 1/min ± 1 1/min", "30 N m"]]
"#;
    let project = crate::read(text).unwrap_or_else(|faults| panic!("{faults:#?}"));
    let mut found: Vec<(&str, &str)> =
        project.tolerances.iter().map(|each| (each.path.as_str(), text.get(each.span.clone()).unwrap())).collect();
    found.sort_unstable();
    assert_eq!(
        found,
        [
            ("actuator.continuous_curve[1][2]", "5 %"),
            ("actuator.continuous_curve[2][1]", "1 1/min"),
            ("actuator.mass", "1 %"),
            ("mechanism.turntable.bodies[1].density", "2 %"),
            ("mechanism.turntable.bodies[1].diameter", "1mm"),
            ("mechanism.turntable.bodies[2].mass", "0.1kg"),
            ("motion[1].time", "10 ms"),
            ("motion[2].bearing.radial_force", "50 N"),
            ("motion[2].distance", "1 arcmin"),
            ("requirements.ambient", "5 K"),
        ]
    );
    // Each of them can be set, and what is built from it differs.
    let mut varied = Varied::new(&project).unwrap();
    let nominal: Vec<f64> = project.tolerances.iter().map(|each| each.nominal).collect();
    let said = |varied: &mut Varied<'_>, values: &[f64]| format!("{:?}", varied.at(values).unwrap());
    let before = said(&mut varied, &nominal);
    for (index, tolerance) in project.tolerances.iter().enumerate() {
        let mut values = nominal.clone();
        values[index] = tolerance.at(0.5);
        assert_ne!(said(&mut varied, &values), before, "{}", tolerance.path);
    }
    assert_eq!(said(&mut varied, &nominal), before);
    assert!(before.contains(&format!("{:?}", project.axis)), "the nominal values give the nominal axis");
}

#[test]
fn each_axis_of_several_has_its_own_tolerances() {
    let one = |name: &str, half: &str| {
        format!(
            "[[axis]]\nname = \"{name}\"\n[axis.load]\ninertia = \"1 kg m^2{half}\"\n[[axis.motion]]\nlaw = \"constant\"\n\
             speed = \"10 1/min\"\ntime = \"1 s ± 1 %\"\n"
        )
    };
    let text = format!("format = 1\n{}{}", one("a", ""), one("b", " ± 10 %"));
    let axes = crate::read_all(&text, &NoFiles).unwrap();
    let paths = |index: usize| axes[index].tolerances.iter().map(|each| each.path.as_str()).collect::<Vec<_>>();
    assert_eq!((paths(0), paths(1)), (vec!["motion[1].time"], vec!["load.inertia", "motion[1].time"]));
    assert!(Varied::new(&axes[1]).unwrap().at(&[1.05, 1.0]).is_ok());
}

#[test]
fn a_fault_of_a_tolerance_is_reported_at_its_half_width() {
    for (written, place, message) in [
        ("1.3 kg m^2 ± 120 %", "120 %", "with this tolerance the value reaches −0.26000 kgm²; it must not be negative"),
        ("1.3 kg m^2 ± 2 kg m^2", "2 kg m^2", "with this tolerance the value reaches −0.70000 kgm²"),
        ("1.3 kg m^2 ± -1 %", "-1 %", "must not be negative"),
        ("1.3 kg m^2 ± NaN %", "NaN", "not a finite number"),
        ("1.3 kg m^2 ± 1 kg", "kg", "is a unit of mass"),
        ("1.3 kg m^2 ±", "±", "half-width of the tolerance is missing"),
        ("1.3 kg m^2 ± 0.1", "0.1", "the unit is missing"),
        ("1.3 kg ± 1 %", "kg", "is a unit of mass"),
    ] {
        let (found, fault) = place_of(&GOOD.replace("1.3 kg m^2", written));
        assert_eq!(found, place, "{written}: {fault:?}");
        assert!(fault.message.contains(message), "{written}: {}", fault.message);
    }
    let (found, fault) = place_of(&format!("{GOOD}[requirements]\nambient = \"40 degC ± 10 %\"\n"));
    assert_eq!(found, "10 %");
    assert!(fault.hint.unwrap().contains("kelvin"));
    let (found, fault) = place_of(&format!("{GOOD}[requirements]\nambient = \"40 degC ± 400 K\"\n"));
    assert_eq!(found, "400 K");
    assert!(fault.message.contains("below absolute zero"), "{}", fault.message);
    assert!(crate::read(&GOOD.replace("1.3 kg m^2", "1.3 kg m^2 ± 100 %")).is_ok());
}

#[test]
fn a_motion_that_a_tolerance_makes_impossible_is_reported_at_it() {
    let shuttle = |half: &str, single: bool| {
        format!(
            "format = 1\n[axis]\nsingle_move = {single}\n[mechanism.screw]\nlead = \"10 mm\"\nmass = \"5 kg\"\n[[motion]]\n\
             law = \"trapezoid\"\ndistance = \"90 mm{half}\"\ntime = \"1 s\"\nspeed = \"100 mm/s\"\n[[motion]]\n\
             law = \"trapezoid\"\ndistance = \"-90 mm\"\ntime = \"1 s\"\n"
        )
    };
    let (place, fault) = place_of(&shuttle(" ± 1 mm", false));
    assert_eq!(place, "1 mm");
    assert!(fault.message.contains("motion[1].distance = 89.000 mm: the cycle does not close"), "{}", fault.message);
    assert!(fault.hint.unwrap().contains("`axis.single_move`"));
    assert!(crate::read(&shuttle(" ± 1 mm", true)).is_ok());
    // At 100 mm in 1 s a speed of 100 mm/s leaves no time to accelerate.
    let (place, fault) = place_of(&shuttle(" ± 12 mm", true));
    assert_eq!(place, "12 mm");
    assert!(fault.message.contains("102.00 mm: the speed is too low"), "{}", fault.message);

    // Each end alone is possible, both together are not.
    let both = shuttle(" ± 8 mm", true).replace("\"100 mm/s\"", "\"100 mm/s ± 5 %\"");
    let (place, fault) = place_of(&both);
    assert_eq!(place, "8 mm");
    assert!(fault.message.contains("combined"), "{}", fault.message);

    let tube = "format = 1\n[mechanism.turntable]\nbodies = [\"tube outer=80mm inner=70mm±12mm length=1m mass=1kg\"]\n\
                [[motion]]\nlaw = \"constant\"\nspeed = \"10 1/min\"\ntime = \"1 s\"\n";
    let (place, fault) = place_of(tube);
    assert_eq!(place, "12mm");
    assert!(fault.message.contains("bodies[1].inner = 82.000 mm: `inner` must be smaller"), "{}", fault.message);
}

#[test]
fn more_tolerances_than_can_be_judged_are_refused() {
    let row = |index: usize| format!("[\"{index} deg\", \"1 kg m^2 ± 1 %\", \"0 N m\"]");
    let rows: Vec<String> = (0..65).map(row).collect();
    let text = format!(
        "format = 1\n[mechanism.table]\npoints = [{}]\nstart_angle = \"0 deg\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n",
        rows.join(", ")
    );
    assert!(one(&text).message.contains("more than 64 quantities with a tolerance"));
}

const CURVE: &str = "[[curve]]\nkind = \"continuous\"\ncode = \"CHA-32A-50\"\nsource = \"bench 3\"\n\
                     points = [[\"0 1/min\", \"60 N m\"], [\"40 1/min\", \"50 N m\"]]\n";

#[test]
fn a_curve_of_the_user_wins_over_the_catalogue() {
    let text = include_str!("../../../../examples/indexing-table.toml");
    let project = crate::read(&format!("{text}\n{CURVE}")).unwrap();
    let code = order_code::parse("CHA-32A-50-H-C1024").unwrap().code;
    let limit = |project: &AxisProject, code: &order_code::OrderCode| {
        let candidate = crate::check(project, code).unwrap();
        let checks = &candidate.judgement.checks;
        let found = checks.iter().find(|check| check.id == sizing::CheckId::ContinuousTorque).unwrap();
        (found.limit.unwrap().si, found.grade.unwrap())
    };
    // n_av = 6.1538 1/min: 60 − 10 · 6.1538/40 Nm
    let (torque, grade) = limit(&project, &code);
    assert!((torque - (60.0 - 10.0 * 6.153_846_153_8 / 40.0)).abs() < 1e-6, "{torque}");
    assert_eq!(grade, provenance::Grade::Published);
    let plain = crate::read(text).unwrap();
    assert_ne!(limit(&plain, &code).0, torque);
    let other = order_code::parse("CHA-40A-50-H-C1024").unwrap().code;
    assert_eq!(limit(&plain, &other), limit(&project, &other), "other codes keep theirs");
    for (from, to) in [
        ("CHA-32A-50", "CHA-33A-50"),
        ("CHA-32A-50", "CHA-14A-160-H"),
        ("\"0 1/min\"", "\"1 1/min\""),
        ("source = \"bench 3\"\n", ""),
        ("continuous", "contineous"),
    ] {
        let text = format!("{text}\n{}", CURVE.replace(from, to));
        assert_eq!(crate::read(&text).unwrap_err().len(), 1, "{from} {to}");
    }
}

#[test]
fn a_decimal_comma_before_one_per_minute_is_reported_as_one() {
    let text = GOOD.replace("40 1/min", "40,5 1/min");
    let fault = one(&text);
    assert_eq!((&text[fault.span.clone()], fault.id), ("40,5", "decimal_comma"));
    assert!(fault.hint.unwrap().contains("40.5"));
}

#[test]
fn what_is_stated_along_a_line_is_reported_along_it() {
    let text = |motion: &str| {
        format!(
            "format = 1\n[mechanism.screw]\nlead = \"20 mm\"\nmass = \"10 kg\"\n[[motion]]\nlaw = \"trapezoid\"\n{motion}\n"
        )
    };
    // 100 mm in 1 s take more than 0.1 m/s.
    let slow = one(&text("distance = \"100 mm\"\ntime = \"1 s\"\nspeed = \"0.05 m/s\""));
    assert_eq!(slow.hint.as_deref(), Some("it must be above 0.10000 m/s"));
    let turning = one(&text("distance = \"5 rev\"\ntime = \"1 s\"\nspeed = \"100 1/min\""));
    assert_eq!(turning.hint.as_deref(), Some("it must be above 300.00 min⁻¹"));
    let open = one(&text("distance = \"100 mm\"\ntime = \"1 s\""));
    assert_eq!(open.message, "the cycle does not close: it ends 100.00 mm from where it begins");
    let open = one(&text("distance = \"5 rev\"\ntime = \"1 s\""));
    assert_eq!(open.message, "the cycle does not close: it ends 1800.0° (at the output) from where it begins");
    let weak = one(&text("distance = \"100 mm\"\ntime = \"1 s\"\nacceleration = \"0.1 m/s^2\""));
    assert_eq!(weak.hint.as_deref(), Some("at least 0.40000 m/s²"));
}

/// A dwell that fills the cycle is one with the time that is left, at any place and in any unit.
#[test]
fn a_dwell_fills_the_cycle_that_it_states() {
    let moves = |dwell: &str| {
        format!(
            "{HEAD}[load]\ninertia = \"1.3 kg m^2\"\n[[motion]]\nlaw = \"polynomial_5\"\ndistance = \"90 deg\"\ntime = \"0.6 s\"\n\
            [[motion]]\nlaw = \"dwell\"\n{dwell}\nhold = \"brake\"\n[[motion]]\nlaw = \"modified_sine\"\ndistance = \"-90 deg\"\n\
            time = \"0.55 s\"\n"
        )
    };
    let read = |dwell: &str| crate::read(&moves(dwell)).unwrap().axis;
    for cycle in ["2 s", "2000 ms"] {
        let filled = read(&format!("cycle = \"{cycle}\""));
        assert!((filled.motion.duration().si() - 2.0).abs() < 1e-12);
        let code = order_code::parse("CHA-25A-50-H-C1024-B").unwrap().code;
        let checked = |dwell: &str| {
            let project = crate::read(&moves(dwell)).unwrap();
            let checks = crate::check(&project, &code).unwrap().judgement.checks;
            checks.iter().map(|check| (check.id, check.value.map(|value| value.si))).collect::<Vec<_>>()
        };
        for ((id, filled), (_, stated)) in
            checked(&format!("cycle = \"{cycle}\"")).into_iter().zip(checked("time = \"0.85 s\""))
        {
            let (Some(filled), Some(stated)) = (filled, stated) else { continue };
            assert!((filled - stated).abs() <= 1e-9 * stated.abs(), "{id:?}");
        }
    }
    let short = one(&moves("cycle = \"1 s\""));
    assert!(short.message.contains("1.150 s") && short.message.contains("1.000 s"), "{}", short.message);
}
