//! Every instant of a cycle against a short-time curve that rises again: what it asks at a speed between two instants counts.
#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test may fail")]

use sizing::{CheckId, Verdict};

/// 2 N m are permitted at 15 min⁻¹, at least 80 N m at the speeds where a move begins and ends.
fn project(law: &str) -> String {
    format!(
        "format = 1\n[load]\ninertia = \"1.0 kg m^2\"\n[[motion]]\nlaw = \"{law}\"\ndistance = \"360 deg\"\ntime = \"2 s\"\n\
         [requirements]\nsupply = \"560 V\"\nambient = \"30 degC\"\n[[curve]]\ncode = \"CHA-32A-100-H\"\nkind = \"short_time\"\n\
         source = \"a data sheet\"\npoints = [[\"0 1/min\", \"100 N m\"], [\"15 1/min\", \"2 N m\"], \
         [\"30 1/min\", \"100 N m\"], [\"60 1/min\", \"80 N m\"]]\n"
    )
}

/// Value and limit \[Nm\], utilisation, and the instant \[s\].
fn asked(law: &str) -> (Verdict, [f64; 4]) {
    let project = questions::read(&project(law)).expect("a valid project");
    let code = questions::read_code("CHA-32A-100-H-C1024", quantities::Language::En).expect("a code").parsed.code;
    let candidate = questions::check(&project, &code).expect("it is in the catalogue");
    let check = candidate.judgement.checks.iter().find(|check| check.id == CheckId::TorqueSpeedTrace).unwrap();
    let number = |figure: Option<sizing::Amount>| figure.unwrap().si;
    let at = quantities::Measure::si(check.at.unwrap());
    (check.verdict, [number(check.value), number(check.limit), check.utilisation.unwrap(), at])
}

/// Three equal thirds up to 45 min⁻¹: α = 4.5π/2 rad/s² all the way, and 15 min⁻¹ after two ninths of a second.
#[test]
fn a_straight_ramp_meets_the_valley_at_its_speed() {
    let (verdict, [torque, limit, share, at]) = asked("trapezoid");
    assert_eq!(verdict, Verdict::Fail);
    assert!((limit - 2.0).abs() < 1e-9 && (at - 2.0 / 9.0).abs() < 1e-9, "{limit} {at}");
    assert!((share / (torque / 2.0) - 1.0).abs() < 1e-9, "{share}");
}

/// Smooth laws pass that speed between the instants that are kept; the torque there hangs on the law.
#[test]
fn a_smooth_ramp_meets_the_valley_between_its_instants() {
    for law in ["polynomial_5", "modified_sine", "modified_trapezoid", "simple_sine", "inclined_sine"] {
        let (verdict, [torque, limit, share, at]) = asked(law);
        assert_eq!(verdict, Verdict::Fail, "{law}");
        assert!((limit - 2.0).abs() < 1e-6 && at > 0.1 && at < 0.5, "{law}: {limit} {at}");
        assert!(torque > 20.0 && share > 10.0, "{law}: {torque} {share}");
    }
}

/// A cycle whose acceleration is `rise` and whose deceleration is `fall` seconds long, with an inertia \[kgm²\].
fn cycle(inertia: f64, speed: f64, rise: f64, fall: f64, curve: &str) -> axis::AxisProject {
    let text = format!(
        "format = 1\n[load]\ninertia = \"{inertia} kg m^2\"\nfriction_torque = \"5 N m\"\n[[motion]]\nlaw = \"manual\"\n\
         speed = \"{speed} 1/min\"\naccelerate = \"{rise} s\"\nrun = \"0.1 s\"\nbrake = \"{fall} s\"\npause = \"5 s\"\n\
         [requirements]\nsupply = \"560 V\"\nambient = \"30 degC\"\n{curve}"
    );
    questions::read(&text).expect("a valid project")
}

fn peak_current(project: &axis::AxisProject, code: &str) -> sizing::Check {
    let code = questions::read_code(code, quantities::Language::En).expect("a code").parsed.code;
    let candidate = questions::check(project, &code).expect("it is in the catalogue");
    candidate.judgement.checks.iter().find(|check| check.id == CheckId::PeakCurrent).unwrap().clone()
}

/// The torque of a drawn curve, of any height, does not raise the permitted current above I_max; that both contradict is a
/// remark.
#[test]
fn a_curve_of_the_project_permits_no_more_than_the_stated_current() {
    let code = "CHA-25A-100-H-C1024";
    let plain = peak_current(&cycle(1.3, 40.0, 0.1, 0.1, ""), code);
    for height in [20, 100, 300, 1000, 10_000] {
        let curve = format!(
            "[[curve]]\nkind = \"short_time\"\ncode = \"CHA-25A-100-*\"\nsource = \"drawn\"\n\
             points = [[\"0 1/min\", \"{height} N m\"], [\"60 1/min\", \"{} N m\"]]\n",
            0.9 * f64::from(height)
        );
        let check = peak_current(&cycle(1.3, 40.0, 0.1, 0.1, &curve), code);
        assert_eq!((check.limit, check.verdict), (plain.limit, plain.verdict), "{height}");
        let contradicts = check.notes.iter().any(|note| matches!(note, sizing::Note::CurveAboveLargestCurrent { .. }));
        assert_eq!(contradicts, height >= 300, "{height}: {:?}", check.notes);
    }
}

/// With a published curve the current of the check is the largest one of the cycle, or the remark states the largest one: that
/// of the actuator without the curve. The permitted current stays below I_E.
#[test]
fn the_largest_current_is_stated_where_another_instant_governs() {
    let (mut elsewhere, mut seen) = (0, 0);
    for ratio in [30, 50, 80, 100, 120] {
        let code = order_code::parse(&format!("CHA-20A-{ratio}-H-C1024")).unwrap().code;
        let actuator = configurator::parameters(&code).unwrap();
        let mut without = actuator.clone();
        std::sync::Arc::make_mut(&mut without.drivetrain).short_time_curve = provenance::Datum::NotPrinted;
        for speed in [10.0, 25.0, 40.0] {
            for (rise, fall) in [(0.1, 0.1), (0.1, 0.09), (0.2, 0.1), (0.5, 0.2)] {
                let project = cycle(1.3, speed, rise, fall, "");
                let [with, largest] = [&actuator, &without].map(|actuator| {
                    let found = sizing::judge(&project.axis, actuator, sizing::Scope::All);
                    found.checks.iter().find(|check| check.id == CheckId::PeakCurrent).unwrap().clone()
                });
                let [value, largest] = [&with, &largest].map(|check| check.value.unwrap().si);
                let stated = with.notes.iter().find_map(|note| match note {
                    sizing::Note::LargestCurrentElsewhere { current, .. } => Some(quantities::Measure::si(*current)),
                    _ => None,
                });
                elsewhere += usize::from(stated.is_some());
                seen += 1;
                let found = stated.unwrap_or(value);
                assert!((found / largest - 1.0).abs() < 1e-9, "{ratio} {speed} {rise} {fall}: {found} {largest}");
                let most = actuator.current_demagnetisation.known().unwrap().value;
                assert!(with.limit.unwrap().si <= quantities::Measure::si(most) * (1.0 + 1e-12));
            }
        }
    }
    assert!(elsewhere > 0 && elsewhere < seen, "{elsewhere} of {seen}");
}
