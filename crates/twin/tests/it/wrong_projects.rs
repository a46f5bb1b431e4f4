//! Right runs with wrong projects: values of the project that are off by up to 40 % are no wrong scale of a signal.

use super::identify::{CODE, EXCITING, loads, measured, moves, recorded_by};
use super::parameters;
use mechanism::{Extra, Mechanism};
use numeric::Random;
use provenance::Datum;
use quantities::{Measure, MomentOfInertia, Torque, TorqueConstant, ViscousFriction};
use std::sync::Arc;
use twin::{Misread, Parameters, Stated, identify};

/// Projects per run whose values are each off on their own; as many have all values off alike.
const PROJECTS: u64 = 12;

/// Returns the parameters of a motor with other torque constants than those of the tables.
fn motor(factor: f64) -> Parameters {
    let mut all = parameters(CODE);
    let drivetrain = Arc::make_mut(&mut all.actuator.drivetrain);
    for constant in [&mut drivetrain.torque_constant_out, &mut drivetrain.torque_constant_motor] {
        if let Datum::Known(known) = constant {
            known.value = TorqueConstant::from_si(known.value.si() * factor);
        }
    }
    all
}

/// Returns a load whose masses, payloads, friction and constant torque are the true ones times a factor each.
fn stated(mechanism: &Mechanism, extras: &[Extra], factors: [f64; 4]) -> (Mechanism, Vec<Extra>) {
    let [mass, payload, friction, constant] = factors;
    let mut all = mechanism.with_masses(mass);
    all.friction.coulomb *= friction;
    all.friction.viscous = ViscousFriction::from_si(all.friction.viscous.si() * friction);
    all.friction.external *= constant;
    let extra = |extra: &Extra| Extra { torque: extra.torque * payload, inertia: extra.inertia * payload, ..*extra };
    (all, extras.iter().map(extra).collect())
}

/// With torque constants within a tenth of the tables, payloads that differ from move to move, and a project that is off by up to
/// 40 % in each value or in all of them alike, nothing but the payloads is doubted.
#[test]
fn a_wrong_project_is_no_wrong_scale() {
    let motion = moves(&EXCITING);
    let extras: Vec<Extra> = (0..EXCITING.len())
        .map(|place| match place % 3 {
            0 => Extra { torque: Torque::from_si(2.0), ..Extra::none() },
            1 => Extra { inertia: MomentOfInertia::from_si(0.3), ..Extra::none() },
            _ => Extra::none(),
        })
        .collect();
    let parameters = parameters(CODE);
    let mut random = Random::new(77_000);
    let mut wrong = Vec::new();
    for (place, mechanism) in loads().iter().enumerate() {
        for (seed, constant) in [(71, 0.905), (72, 1.0), (73, 1.095)] {
            let run = measured(&recorded_by(&motor(constant), 16, mechanism, &motion, &extras, seed), seed);
            for project in 0..2 * PROJECTS {
                let mut off = || 0.6 + 0.8 * random.uniform();
                let factors = if project < PROJECTS { [off(), off(), off(), off()] } else { [off(); 4] };
                let (load, added) = stated(mechanism, &extras, factors);
                let project = Stated { parameters: &parameters, mechanism: &load, motion: &motion, extras: &added };
                let doubts = identify(&run, &project).unwrap().doubts;
                if doubts.iter().any(|doubt| doubt.misread != Misread::PayloadMissing) {
                    wrong.push(format!("load {place}, k_T {constant}, {factors:?}: {doubts:?}"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
