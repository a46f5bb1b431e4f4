//! Effect of a stage behind the actuator on angles: torsion and errors at the mechanism.

use crate::axis::Axis;
use crate::comparison::{Asking, project};
use crate::workings;
use actuator::{Contribution, ErrorBudget, ErrorKind};
use derivation::Workings;
use mechanism::{Mechanism, Stage};
use provenance::{Grade, Source, Sourced};
use quantities::unit::{ARCMINUTE, NEWTON_METRE, NEWTON_METRE_PER_RADIAN, ONE};
use quantities::{Angle, Measure, Torque, TorsionalStiffness};
use std::borrow::Cow;

/// Model of the stage.
pub(crate) const MODEL: Source = Source::Model { name: "stage" };

/// Returns a stiffness of the gear with that of the stage in series, at the output of the actuator.
pub(crate) fn in_series<'k>(
    mechanism: &Mechanism,
    gear: &'k Sourced<TorsionalStiffness>,
) -> Cow<'k, Sourced<TorsionalStiffness>> {
    let series = mechanism.in_series(gear.value);
    if series == gear.value {
        return Cow::Borrowed(gear);
    }
    Cow::Owned(Sourced { value: series, source: MODEL, grade: gear.grade.worst(Grade::Computed), errata: gear.errata })
}

/// Records a stiffness of the gear with that of the stage in series under a symbol.
pub(crate) fn explain_series(
    mechanism: &Mechanism,
    symbol: &'static str,
    gear: &Sourced<TorsionalStiffness>,
    work: &mut Workings,
) {
    let series = mechanism.in_series(gear.value);
    match &mechanism.stage {
        Some(stage) if series != gear.value => {
            work.given("K_g", &NEWTON_METRE_PER_RADIAN, gear);
            ratio(stage, work);
            stiffness(stage, work);
            let text = "K_g/(1 + K_g*i_s^2/K_s)";
            work.formula(symbol, &NEWTON_METRE_PER_RADIAN, series.si(), text, &MODEL);
        }
        _ => work.given(symbol, &NEWTON_METRE_PER_RADIAN, gear),
    }
}

/// Returns the torsion of the stage itself, at the mechanism.
///
/// φ_s = i_s T / K_s
///
/// # Symbols
/// i_s ratio, T torque at the output of the actuator \[Nm\], K_s stiffness on the side of the mechanism [Nm/rad]
/// # Source
/// docs/theory/stage.md
/// # Valid
/// losses left out; zero for a stage whose stiffness is not stated
fn own_torsion(stage: &Stage, torque: Torque) -> Angle {
    Angle::from_si(stage.stiffness.map_or(0.0, |stiffness| stage.ratio * torque.si().abs() / stiffness.si()))
}

/// Returns the torsion at the mechanism under a torque: that of the gear through the ratio, plus that of the stage.
/// `phi_L` in the derivation.
pub(crate) fn torsion(stage: &Stage, gear: Angle, torque: Torque, work: &mut Workings) -> Angle {
    let angle = Angle::from_si(gear.si() / stage.ratio) + own_torsion(stage, torque);
    ratio(stage, work);
    if stage.stiffness.is_some() {
        stiffness(stage, work);
        work.formula("phi_L", &ARCMINUTE, angle.si(), "phi/i_s + i_s*T/K_s*10800/pi", &MODEL);
    } else {
        work.formula("phi_L", &ARCMINUTE, angle.si(), "phi/i_s", &MODEL);
    }
    angle
}

fn ratio(stage: &Stage, work: &mut Workings) {
    work.stated("i_s", &ONE, stage.ratio, "stage.ratio");
}

fn stiffness(stage: &Stage, work: &mut Workings) {
    if let Some(stiffness) = stage.stiffness {
        work.stated("K_s", &NEWTON_METRE_PER_RADIAN, stiffness.si(), "stage.stiffness");
    }
}

/// Converts the budget at the output of the actuator to that at the mechanism: its errors through the ratio, without
/// the tilt of the flange, and with backlash and torsion of the stage.
pub(crate) fn behind(stage: &Stage, budget: &mut ErrorBudget, torque: Torque) {
    budget.contributions.retain(|entry| entry.kind != ErrorKind::Tilt);
    budget.missing.retain(|kind| *kind != ErrorKind::Tilt);
    for entry in &mut budget.contributions {
        entry.angle.value = Angle::from_si(entry.angle.value.si() / stage.ratio);
    }
    let own =
        |key: &'static str, value: Angle| Sourced { value, source: project(key), grade: Grade::Published, errata: &[] };
    if let Some(backlash) = stage.backlash {
        let angle = own("stage.backlash", backlash);
        budget.contributions.push(Contribution { kind: ErrorKind::StageBacklash, angle });
    }
    if stage.stiffness.is_some() {
        let angle = own("stage.stiffness", own_torsion(stage, torque));
        budget.contributions.push(Contribution { kind: ErrorKind::StageTorsion, angle });
    }
}

/// Returns the sum of the errors at the output of the actuator, of a budget at the mechanism.
pub(crate) fn before(stage: &Stage, budget: &ErrorBudget) -> Angle {
    let of_stage = |kind: ErrorKind| matches!(kind, ErrorKind::StageBacklash | ErrorKind::StageTorsion);
    let entries = budget.contributions.iter().filter(|entry| !of_stage(entry.kind));
    Angle::from_si(entries.map(|entry| entry.angle.value.si()).sum::<f64>() * stage.ratio)
}

/// Records the derivation of the sum at the mechanism, `phi_sum`, from that at the output of the actuator, `phi_out`;
/// `has_torque`: the largest load torque is recorded as `T`.
pub(crate) fn explain_budget(axis: &Axis, stage: &Stage, (worst, has_torque): (Angle, bool), work: &mut Workings) {
    ratio(stage, work);
    let mut text = "phi_out/i_s";
    if let Some(backlash) = stage.backlash {
        work.stated("phi_b", &ARCMINUTE, backlash.si(), "stage.backlash");
        text = "phi_out/i_s + phi_b";
    }
    if stage.stiffness.is_some() {
        stiffness(stage, work);
        if has_torque {
            work.formula("T_s", &NEWTON_METRE, axis.moments().load_peak.si(), "T", &workings::DEMAND);
        } else {
            workings::peak_load(axis, "T_s", work);
        }
        text = if stage.backlash.is_some() {
            "phi_out/i_s + phi_b + i_s*T_s/K_s*10800/pi"
        } else {
            "phi_out/i_s + i_s*T_s/K_s*10800/pi"
        };
    }
    work.formula("phi_sum", &ARCMINUTE, worst.si(), text, &MODEL);
}

#[cfg(test)]
mod tests {
    use crate::axis::Axis;
    use mechanism::{Extra, Mechanism, MechanismKind, Output, Rotor, RotorKind, Stage, StageKind};
    use motion::{Closing, Given, Law, Motion, SegmentSpec};
    use quantities::unit::DEGREE;
    use quantities::{Angle, Length, Mass, Measure, MomentOfInertia, Time, Torque};

    fn swing(angle_deg: f64, seconds: f64) -> SegmentSpec {
        let given = Given {
            distance: Some(Angle::new_in(angle_deg, &DEGREE)),
            time: Some(Time::from_si(seconds)),
            ..Given::default()
        };
        SegmentSpec::Move(Law::ModifiedSine, given)
    }

    /// Compares mean square of the torque and its cubic mean over the travel, with losses on both sides of a stage,
    /// with sums over many steps of the motion at the mechanism.
    #[test]
    fn a_lossy_stage_agrees_with_many_small_steps() {
        let rotor = Rotor {
            kind: RotorKind::Arm,
            inertia: MomentOfInertia::from_si(0.9),
            mass: Mass::from_si(6.0),
            radius: Length::from_si(0.3),
            payload_radius: Length::from_si(0.0),
            angle: Angle::from_si(0.0),
            tilt: Angle::new_in(90.0, &DEGREE),
        };
        let plain = Mechanism {
            kind: MechanismKind::Rotor(rotor),
            efficiency_driving: 0.95,
            efficiency_driven: 0.9,
            ..Mechanism::direct(MomentOfInertia::from_si(0.0), Torque::from_si(2.0))
        };
        for (ratio, steps) in [(0.4, 100_000), (3.0, 100_000)] {
            let stage = Stage {
                kind: StageKind::Gear,
                ratio,
                efficiency_driving: 0.9,
                efficiency_driven: 0.7,
                inertia_driving: MomentOfInertia::from_si(0.004),
                inertia_driven: MomentOfInertia::from_si(0.05),
                stiffness: None,
                backlash: None,
                pitch_diameter: None,
            };
            let motion = Motion::new(&[swing(140.0, 0.7), swing(-140.0, 0.9)], None, Closing::Position).unwrap();
            let staged = Mechanism { stage: Some(stage), ..plain.clone() };
            let axis = Axis::new(staged, motion.geared(ratio), Vec::new());
            let (mut square, mut cube, mut travelled) = (0.0, 0.0, 0.0);
            for piece in motion.pieces() {
                let dt = piece.duration_s / f64::from(steps);
                for step in 0..steps {
                    let state = piece.at((f64::from(step) + 0.5) * dt);
                    let (w, a) = (state.speed_rad_s, state.acceleration_rad_s2);
                    let output = Output {
                        position_rad: state.position_rad,
                        speed_rad_s: w,
                        acceleration_rad_s2: a,
                        direction: w.signum(),
                    };
                    let handed_on = plain.torque(&output, &Extra::none()) + 0.05 * a;
                    let taken = if handed_on * w > 0.0 { handed_on / 0.9 } else { handed_on * 0.7 };
                    let torque = taken / ratio + 0.004 * a * ratio;
                    square += torque * torque * dt;
                    cube += torque.abs().powi(3) * (w * ratio).abs() * dt;
                    travelled += (w * ratio).abs() * dt;
                }
            }
            let rms = axis.demand(MomentOfInertia::from_si(0.0)).torque_rms.si();
            assert!((rms / (square / 1.6).sqrt() - 1.0).abs() < 1e-7, "{rms}");
            let mean = axis.load_cubic_mean().si();
            assert!((mean / (cube / travelled).cbrt() - 1.0).abs() < 1e-7, "{mean}");
        }
    }
}
