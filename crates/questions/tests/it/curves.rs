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
