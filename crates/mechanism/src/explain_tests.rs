//! Derivations of every mechanism with every combination of stated terms: each formula gives its value, and the last one the
//! torque or the load that it derives.

use super::*;
use crate::{
    ArmBody, ArmShape, Contact, FlangeLoadKind, FourBar, Friction, Joint, Linear, LinearKind, Mounting, Rotor,
    RotorKind, ScissorLift, SliderCrank, StageKind, Table, TablePoint, Winder, Winding, reeving_efficiency,
};
use derivation::{How, Step, evaluate};
use numeric::Random;
use quantities::unit::DEGREE;
use quantities::{Angle, Force, Length, Mass, MassDensity, MomentOfInertia, ViscousFriction};
use std::collections::BTreeSet;

/// Random values, each of which may be left out.
struct Draws(Random);

impl Draws {
    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.0.uniform()
    }

    fn is_stated(&mut self) -> bool {
        self.0.uniform() < 0.5
    }

    /// Returns a value that is stated in half of the cases, else another.
    fn or(&mut self, (low, high): (f64, f64), otherwise: f64) -> f64 {
        let value = self.within(low, high);
        if self.is_stated() { value } else { otherwise }
    }

    fn one_of<T: Copy>(&mut self, all: &[T]) -> T {
        let place = all.iter().enumerate().skip(1).fold(0, |kept, (place, _)| {
            let count = f64::from(u32::try_from(place).unwrap()) + 1.0;
            if self.0.uniform() * count < 1.0 { place } else { kept }
        });
        all[place]
    }
}

fn degrees(angle: f64) -> Angle {
    Angle::new_in(angle, &DEGREE)
}

fn kinds(draws: &mut Draws) -> Vec<MechanismKind> {
    let inertia = MomentOfInertia::from_si(draws.within(0.1, 2.0));
    let mass = Mass::from_si(draws.within(2.0, 30.0));
    let metres = |draws: &mut Draws, low, high| Length::from_si(draws.within(low, high));
    let rotor = |draws: &mut Draws, kind| Rotor {
        kind,
        inertia,
        mass: Mass::from_si(if kind == RotorKind::Load { 0.0 } else { mass.si() }),
        radius: Length::from_si(if kind == RotorKind::Load { 0.0 } else { draws.within(0.05, 0.4) }),
        payload_radius: Length::from_si(if kind == RotorKind::Load { 0.0 } else { draws.or((0.1, 0.5), 0.0) }),
        angle: degrees(if kind == RotorKind::Turntable { draws.or((-180.0, 180.0), 0.0) } else { 0.0 }),
        tilt: degrees(if kind == RotorKind::Load {
            0.0
        } else {
            let drawn = draws.within(5.0, 175.0);
            draws.one_of(&[0.0, 90.0, drawn])
        }),
    };
    let linear = |draws: &mut Draws, kind| {
        MechanismKind::Linear(Linear {
            kind,
            travel_m_per_rad: draws.within(0.002, 0.1),
            inertia,
            mass,
            counterweight: Mass::from_si(draws.or((1.0, 20.0), 0.0)),
            inclination: degrees(draws.or((-90.0, 90.0), 0.0)),
            friction_force: Force::from_si(draws.or((1.0, 50.0), 0.0)),
            friction_coefficient: draws.or((0.01, 0.2), 0.0),
        })
    };
    let falls = draws.one_of(&[1, 2, 3, 4, 5]);
    let rope = draws.or((0.5, 12.0), 0.0);
    let periodic = draws.is_stated();
    let points = (0..=12).map(|k| {
        let angle = 30.0 * f64::from(k);
        TablePoint {
            position: degrees(if periodic { angle } else { angle + 5.0 }),
            inertia: MomentOfInertia::from_si(1.0 + 0.3 * angle.to_radians().cos() + 1e-16),
            torque: Torque::from_si(if k == 12 && periodic { 0.0 } else { 4.0 * (2.0 * angle.to_radians()).sin() }),
        }
    });
    let mut points: Vec<TablePoint> = points.collect();
    if periodic {
        points[12] = TablePoint { position: points[12].position, ..points[0] };
    }
    vec![
        MechanismKind::Rotor(rotor(draws, RotorKind::Load)),
        MechanismKind::Rotor(rotor(draws, RotorKind::Arm)),
        MechanismKind::Rotor(rotor(draws, RotorKind::Turntable)),
        MechanismKind::Rotor({
            let shape = draws.one_of(&ArmShape::ALL);
            let width = Length::from_si(if shape == ArmShape::Bar { 0.08 } else { 0.0 });
            let body = ArmBody { shape, length: metres(draws, 0.2, 1.5), width };
            let (inertia, radius) = shape.spread(mass, body.length, width);
            Rotor { inertia, radius, ..rotor(draws, RotorKind::Shaped(body)) }
        }),
        linear(draws, LinearKind::Screw),
        linear(draws, LinearKind::Belt),
        linear(draws, LinearKind::Conveyor),
        MechanismKind::SliderCrank(SliderCrank {
            crank: metres(draws, 0.03, 0.08),
            rod: metres(draws, 0.09, 0.3),
            inertia,
            mass,
            inclination: degrees(draws.or((-90.0, 90.0), 0.0)),
            angle: degrees(draws.or((-180.0, 180.0), 0.0)),
        }),
        MechanismKind::Table(Table::new(points).unwrap()),
        MechanismKind::Joint(Joint { inertia: Some(inertia), holding_torque: Some(Torque::from_si(30.0)) }),
        MechanismKind::Hoist(Hoist {
            drum_diameter: metres(draws, 0.1, 0.4),
            falls,
            inertia,
            mass,
            counterweight: Mass::from_si(draws.or((1.0, 40.0), 0.0)),
            rope_mass: Mass::from_si(rope),
            hanging: Length::from_si(if rope > 0.0 { 30.0 } else { 0.0 }),
            reeving: reeving_efficiency(falls, draws.one_of(&[1.0, 0.98, 0.9])),
        }),
        MechanismKind::Winder(Winder {
            winding: draws.one_of(&[Winding::Up, Winding::Off]),
            core_diameter: Length::from_si(0.08),
            full_diameter: Length::from_si(0.4),
            start_diameter: metres(draws, 0.1, 0.38),
            thickness: metres(draws, 0.0003, 0.003),
            width: Length::from_si(0.3),
            density: MassDensity::from_si(900.0),
            tension: Force::from_si(draws.within(-20.0, 200.0)),
            inertia,
        }),
        MechanismKind::ScissorLift(ScissorLift {
            stages: draws.one_of(&[1, 2, 3]),
            arm_length: metres(draws, 0.6, 1.2),
            lead: metres(draws, 0.005, 0.04),
            angle: degrees(draws.within(10.0, 40.0)),
            mass,
            arm_mass: Mass::from_si(draws.or((1.0, 10.0), 0.0)),
            inertia,
        }),
        MechanismKind::FourBar(FourBar {
            ground: metres(draws, 0.35, 0.45),
            crank: Length::from_si(0.1),
            coupler: metres(draws, 0.32, 0.38),
            rocker: Length::from_si(0.25),
            is_crossed: draws.is_stated(),
            inertia,
            coupler_mass: mass,
            coupler_centre: metres(draws, 0.0, 0.3),
            coupler_inertia: MomentOfInertia::from_si(0.02),
            rocker_mass: Mass::from_si(draws.or((1.0, 8.0), 0.0)),
            rocker_centre: Length::from_si(0.15),
            rocker_inertia: MomentOfInertia::from_si(0.25),
            rocker_torque: Torque::from_si(draws.or((-9.0, 9.0), 0.0)),
            inclination: degrees(draws.or((-90.0, 90.0), 0.0)),
            tilt: degrees(draws.or((-170.0, 170.0), 0.0)),
        }),
    ]
}

fn mechanism(kind: MechanismKind, draws: &mut Draws) -> Mechanism {
    let stage = Stage {
        kind: draws.one_of(&[StageKind::Belt, StageKind::Gear, StageKind::Coupling]),
        ratio: draws.one_of(&[0.5, 1.0, 2.5]),
        efficiency_driving: draws.one_of(&[1.0, 0.94]),
        efficiency_driven: draws.one_of(&[1.0, 0.9]),
        inertia_driving: MomentOfInertia::from_si(draws.or((0.001, 0.1), 0.0)),
        inertia_driven: MomentOfInertia::from_si(draws.or((0.001, 0.1), 0.0)),
        stiffness: None,
        backlash: None,
        pitch_diameter: Some(Length::from_si(draws.within(0.05, 0.2))),
    };
    Mechanism {
        kind,
        friction: Friction {
            coulomb: Torque::from_si(draws.or((0.1, 5.0), 0.0)),
            viscous: ViscousFriction::from_si(draws.or((0.01, 1.0), 0.0)),
            external: Torque::from_si(draws.or((-5.0, 5.0), 0.0)),
        },
        efficiency_driving: draws.one_of(&[1.0, 0.9]),
        efficiency_driven: draws.one_of(&[1.0, 0.8]),
        stage: draws.is_stated().then_some(stage),
    }
}

fn state(mechanism: &Mechanism, draws: &mut Draws) -> At {
    let direction = draws.one_of(&[-1.0, 0.0, 1.0]);
    let output = Output {
        position_rad: draws.within(-4.0, 9.0),
        speed_rad_s: direction * draws.within(0.1, 8.0),
        acceleration_rad_s2: draws.or((-60.0, 60.0), 0.0),
        direction,
    };
    let extra = Extra {
        mass: Mass::from_si(draws.or((0.5, 9.0), 0.0)),
        inertia: MomentOfInertia::from_si(draws.or((0.01, 0.5), 0.0)),
        force: Force::from_si(draws.or((-90.0, 90.0), 0.0)),
        torque: Torque::from_si(draws.or((-9.0, 9.0), 0.0)),
    };
    // Only a rotor with a lever, a line or a lift carries a mass.
    let carries = match &mechanism.kind {
        MechanismKind::Rotor(rotor) => rotor.kind != RotorKind::Load,
        MechanismKind::Linear(_)
        | MechanismKind::SliderCrank(_)
        | MechanismKind::Hoist(_)
        | MechanismKind::ScissorLift(_) => true,
        _ => false,
    };
    let mass = if carries { extra.mass } else { Mass::from_si(0.0) };
    let recorded_nm = draws.or((-30.0, 30.0), 0.0);
    At { time_s: 0.25, output, extra: Extra { mass, ..extra }, recorded_nm, segment: 1 }
}

fn mounting(draws: &mut Draws) -> Mounting {
    let metres = |draws: &mut Draws| Some(Length::from_si(draws.within(-0.05, 0.1)));
    let contact = [
        None,
        Some(Contact::Belt { tension: Force::from_si(250.0) }),
        Some(Contact::Mesh { pressure_angle: degrees(20.0), helix_angle: degrees(draws.or((-20.0, 20.0), 0.0)) }),
    ];
    Mounting {
        overhang: metres(draws),
        payload_overhang: metres(draws),
        share: draws.one_of(&[None, Some(0.7), Some(0.0)]),
        contact: draws.one_of(&contact),
        wheel_mass: draws.one_of(&[None, Some(Mass::from_si(1.5))]),
        axis_tilt: Some(degrees(draws.within(0.0, 180.0))),
    }
}

/// Checks the steps of a derivation whose last formula is recorded under a symbol: each formula gives the value beside it, the
/// last one that expected, every step leads to it, and no step is described by a sentence alone, except the state of the motion.
fn check(steps: &[Step], expected: f64, scale: f64, place: &dyn Fn() -> String) {
    let close = |value: f64, other: f64| (value - other).abs() <= 1e-9 * (1e-3 * scale + other.abs());
    let mut used = vec![false; steps.len()];
    if let Some(last) = used.last_mut() {
        *last = true;
    }
    for (index, step) in steps.iter().enumerate().rev() {
        assert!(used[index], "{}: {} leads nowhere\n{steps:#?}", place(), step.symbol);
        step.operands().iter().for_each(|operand| used[*operand] = true);
        match &step.how {
            How::Formula { text, .. } => {
                let found = evaluate(steps, index).unwrap();
                let is_close = found.as_ref().is_ok_and(|found| close(step.value(), *found));
                assert!(is_close, "{}: {} = {text} gives {found:?}, not {}", place(), step.symbol, step.value());
            }
            How::Found { what, .. } => assert!(
                what.formula().is_some()
                    || matches!(
                        what,
                        Finding::AccelerationAt
                            | Finding::SpeedAt
                            | Finding::AngularVelocityAt
                            | Finding::DirectionAt
                            | Finding::PositionAt
                            | Finding::RecordedTorqueAt
                            | Finding::PositionOfLargestHolding
                            | Finding::PositionOfLargestInertia
                    ),
                "{}: {} is found by {what:?}",
                place(),
                step.symbol
            ),
            How::Given => {}
        }
    }
    let found = steps.last().map_or(0.0, |step| step.si);
    assert!(close(found, expected), "{}: {found}, not {expected}", place());
}

/// Returns every mechanism with random terms, with a state of its output.
fn drawn(seed: u64, rounds: usize) -> Vec<(Mechanism, At)> {
    let mut draws = Draws(Random::new(seed));
    let mut all = Vec::new();
    for _ in 0..rounds {
        for kind in kinds(&mut draws) {
            let mechanism = mechanism(kind, &mut draws);
            let at = state(&mechanism, &mut draws);
            all.push((mechanism, at));
        }
    }
    all
}

fn torque_steps(mechanism: &Mechanism, at: &At) -> Vec<Step> {
    let mut work = Workings::on();
    if mechanism.explains_by_acceleration() {
        let alpha = at.output.acceleration_rad_s2;
        work.figure("alpha", &RADIAN_PER_SECOND_SQUARED, alpha, &MODEL, Grade::Computed);
    }
    mechanism.explain_torque(at, mechanism.torque_at(at), &mut work);
    work.into_steps()
}

#[test]
fn the_law_of_every_mechanism_gives_its_torque_with_every_combination_of_terms() {
    for (mechanism, at) in drawn(7, 150) {
        let torque = mechanism.torque_at(&at);
        check(&torque_steps(&mechanism, &at), torque, 1.0, &|| format!("{mechanism:?} {at:?}"));
    }
}

#[test]
fn the_law_of_every_mechanism_gives_its_loads_on_the_flange() {
    let mut draws = Draws(Random::new(11));
    let offset =
        provenance::Sourced { value: Length::from_si(0.018), source: MODEL, grade: Grade::Printed, errata: &[] };
    let mut found = BTreeSet::new();
    for (mechanism, at) in drawn(13, 150) {
        let mounting = mounting(&mut draws);
        let forces = mechanism.flange_forces(&at.output, &at.extra, at.recorded_nm, &mounting);
        for (kind, value) in [
            (FlangeLoadKind::Radial, forces.radial()),
            (FlangeLoadKind::Axial, forces.axial()),
            (FlangeLoadKind::Moment, forces.moment(offset.value)),
        ] {
            let mut work = Workings::on();
            let text = mechanism.explain_flange(kind, &at, (&mounting, Some(&offset)), &mut work);
            assert!(text != "0" || value == 0.0, "{kind:?} {mechanism:?} {at:?}: {value}");
            work.formula("F_m", &NEWTON, value, text, &MODEL);
            if value != 0.0 {
                found.insert((mechanism.id(), kind as u8, mechanism.stage.is_some()));
            }
            // A rotor whose weight acts across the axis only has no axial force.
            check(&work.into_steps(), value, 1.0, &|| format!("{kind:?} {mechanism:?} {at:?} {mounting:?}"));
        }
    }
    assert!(found.len() > 60, "{}", found.len());
}

#[test]
fn the_law_of_every_mechanism_gives_its_inertia_and_what_holds_it_at_rest() {
    for (mechanism, at) in drawn(17, 100) {
        let (extra, position) = (at.extra, at.output.position_rad);
        let place = || format!("{mechanism:?} {at:?}");
        let mut work = Workings::on();
        mechanism.explain_holding(position, (at.segment, &extra), &mut work);
        let holding = mechanism.holding_torque(position, &extra).si().abs();
        check(&work.into_steps(), holding, 1.0, &place);
        let mut work = Workings::on();
        let what = Finding::PositionOfLargestInertia;
        mechanism.explain_inertia("J_L", (position, what), (at.segment, &extra), &mut work);
        check(&work.into_steps(), mechanism.inertia(position, &extra).si(), 1.0, &place);
    }
}
