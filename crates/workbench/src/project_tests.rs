use super::*;
use sizing::CheckId;

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

fn faults(text: &str) -> Vec<Diagnostic> {
    Project::read(text, Language::En).expect_err("must be refused")
}

fn one(text: &str) -> Diagnostic {
    let mut found = faults(text);
    assert_eq!(found.len(), 1, "{found:#?}");
    found.remove(0)
}

#[test]
fn a_good_project_is_read() {
    let project = Project::read(GOOD, Language::En).unwrap();
    assert_eq!(project.name, "axis");
    assert!((project.axis.cycle.duration().si() - 1.3).abs() < 1e-12);
    assert_eq!(
        project.assumptions,
        [Assumption::AmbientWithinRange, Assumption::CoolingPlate, Assumption::NoSupply, Assumption::NoFlangeLoads]
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
    let project = Project::read(&text, Language::En).unwrap();
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
        assert!(fault.message.contains("no machine"), "{fault:?}");
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
        assert!(found.last().unwrap().message.contains("more faults"), "{piece:?}: {:?}", found.last());
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
    let german = Project::read(&text, Language::De).unwrap_err();
    assert!(german[0].hint.as_deref().unwrap().contains("gemeint ist vielleicht"));
}

#[test]
fn an_own_actuator_may_be_known_in_part_or_by_a_curve() {
    let text = format!(
        "{GOOD}[actuator]\nname = \"own\"\ninertia_out = \"1 kg m^2\"\nspeed_motor_rated = \"3500 1/min\"\nratio = 50\n\
         continuous_curve = [[\"0 1/min\", \"50 N m\"], [\"70 1/min\", \"30 N m\"]]\n"
    );
    let project = Project::read(&text, Language::En).unwrap();
    let own = crate::check_own(&project).unwrap();
    let check = own.judgement.checks.iter().find(|check| check.id == CheckId::ContinuousTorque).unwrap();
    assert_eq!(check.verdict, sizing::Verdict::Pass);
    let torque = own.judgement.checks.iter().find(|check| check.id == CheckId::PeakTorque).unwrap();
    assert_eq!((torque.verdict, torque.missing), (sizing::Verdict::NotChecked, Some("T_max")));
    let bad = text.replace("[\"70 1/min\", \"30 N m\"]", "[\"0 1/min\", \"30 N m\"]");
    assert!(one(&bad).message.contains("must grow"));
}

#[test]
fn the_schema_knows_every_key_and_refuses_others() {
    let schema = schema(Language::En);
    let root = schema["properties"].as_object().unwrap();
    assert!(root.contains_key("load") && root.contains_key("motion") && root.contains_key("requirements"));
    assert_eq!(schema["additionalProperties"], false);
    assert_eq!(schema["required"], serde_json::json!(["format", "load", "motion"]));
    assert_eq!(root["motion"]["items"]["properties"]["law"]["enum"], serde_json::json!(["manual"]));
}

/// What the CHA tables say of the ambient must not be cited for an actuator of another maker.
#[test]
fn the_tables_of_the_catalogue_do_not_speak_for_an_own_actuator() {
    let text =
        format!("{GOOD}[requirements]\nambient = \"60 degC\"\n[actuator]\nname = \"own\"\nstall_current = \"2 A\"\n");
    let project = Project::read(&text, Language::En).unwrap();
    assert!(project.assumptions.contains(&Assumption::OwnStallCurrentIncludesFriction));
    let ambient = |candidate: &crate::Candidate<'_>| {
        candidate.judgement.checks.iter().find(|check| check.id == CheckId::Ambient).map(|check| check.verdict)
    };
    assert_eq!(ambient(&crate::check_own(&project).unwrap()), Some(sizing::Verdict::NotChecked));
    let sizing = crate::size(&project);
    assert!(sizing.candidates.iter().all(|candidate| ambient(candidate) == Some(sizing::Verdict::Fail)));
}
