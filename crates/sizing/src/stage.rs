//! What a stage behind the actuator does to angles: torsion and errors at the mechanism.

use actuator::{Contribution, ErrorBudget, ErrorKind};
use derivation::Workings;
use mechanism::Stage;
use provenance::{Grade, Source, Sourced};
use quantities::unit::{ARCMINUTE, NEWTON_METRE, NEWTON_METRE_PER_RADIAN, ONE};
use quantities::{Angle, Measure, Torque};

/// The model of the stage.
pub(crate) const MODEL: Source = Source::Model { name: "stage" };

/// Torsion of the stage itself, at the mechanism.
///
/// φ_s = n T / K_s
///
/// # Symbols  n ratio, T torque at the output of the actuator \[Nm\], K_s stiffness on the side of the mechanism [Nm/rad]
/// # Source   docs/theory/stage.md
/// # Valid    losses left out; zero for a stage whose stiffness is not stated
fn own_torsion(stage: &Stage, torque: Torque) -> Angle {
    Angle::from_si(stage.stiffness.map_or(0.0, |stiffness| stage.ratio * torque.si().abs() / stiffness.si()))
}

/// Torsion at the mechanism under a torque: that of the gear seen through the ratio, and that of the stage. `phi_L` in the
/// workings.
pub(crate) fn torsion(stage: &Stage, gear: Angle, torque: Torque, work: &mut Workings) -> Angle {
    let angle = Angle::from_si(gear.si() / stage.ratio) + own_torsion(stage, torque);
    ratio(stage, work);
    if stage.stiffness.is_some() {
        stiffness(stage, work);
        work.formula("phi_L", &ARCMINUTE, angle.si(), "phi/n + n*T/K_s*10800/pi", &MODEL);
    } else {
        work.formula("phi_L", &ARCMINUTE, angle.si(), "phi/n", &MODEL);
    }
    angle
}

fn ratio(stage: &Stage, work: &mut Workings) {
    work.figure("n", &ONE, stage.ratio, &Source::Project { key: "stage.ratio".into() }, Grade::Printed);
}

fn stiffness(stage: &Stage, work: &mut Workings) {
    if let Some(stiffness) = stage.stiffness {
        let key = Source::Project { key: "stage.stiffness".into() };
        work.figure("K_s", &NEWTON_METRE_PER_RADIAN, stiffness.si(), &key, Grade::Printed);
    }
}

/// The budget at the output of the actuator becomes that at the mechanism: its errors through the ratio, without the tilt
/// of the flange, and backlash and torsion of the stage.
pub(crate) fn behind(stage: &Stage, budget: &mut ErrorBudget, torque: Torque) {
    budget.contributions.retain(|entry| entry.kind != ErrorKind::Tilt);
    budget.missing.retain(|kind| *kind != ErrorKind::Tilt);
    for entry in &mut budget.contributions {
        entry.angle.value = Angle::from_si(entry.angle.value.si() / stage.ratio);
    }
    let own = |key: &'static str, value: Angle| Sourced {
        value,
        source: Source::Project { key: key.into() },
        grade: Grade::Published,
        errata: &[],
    };
    if let Some(backlash) = stage.backlash {
        let angle = own("stage.backlash", backlash);
        budget.contributions.push(Contribution { kind: ErrorKind::StageBacklash, angle });
    }
    if stage.stiffness.is_some() {
        let angle = own("stage.stiffness", own_torsion(stage, torque));
        budget.contributions.push(Contribution { kind: ErrorKind::StageTorsion, angle });
    }
}

/// The sum of the errors at the output of the actuator, of a budget at the mechanism.
pub(crate) fn before(stage: &Stage, budget: &ErrorBudget) -> Angle {
    let of_stage = |kind: ErrorKind| matches!(kind, ErrorKind::StageBacklash | ErrorKind::StageTorsion);
    let entries = budget.contributions.iter().filter(|entry| !of_stage(entry.kind));
    Angle::from_si(entries.map(|entry| entry.angle.value.si()).sum::<f64>() * stage.ratio)
}

/// The workings of the sum at the mechanism, `phi_sum`, from that at the output of the actuator, `phi_out`.
pub(crate) fn explain_budget(stage: &Stage, (worst, torque): (Angle, Torque), work: &mut Workings) {
    ratio(stage, work);
    let mut text = "phi_out/n";
    if let Some(backlash) = stage.backlash {
        let key = Source::Project { key: "stage.backlash".into() };
        work.figure("phi_b", &ARCMINUTE, backlash.si(), &key, Grade::Printed);
        text = "phi_out/n + phi_b";
    }
    if stage.stiffness.is_some() {
        stiffness(stage, work);
        let found = "max |T_L| over the cycle";
        work.found("T_s", &NEWTON_METRE, torque.si(), found, &crate::workings::DEMAND, Grade::Computed);
        text = if stage.backlash.is_some() {
            "phi_out/n + phi_b + n*T_s/K_s*10800/pi"
        } else {
            "phi_out/n + n*T_s/K_s*10800/pi"
        };
    }
    work.formula("phi_sum", &ARCMINUTE, worst.si(), text, &MODEL);
}
