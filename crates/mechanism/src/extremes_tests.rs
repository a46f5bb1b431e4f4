//! Extremes compared with a dense scan of the positions, over drawn mechanisms of every kind that depends on the position.

use super::*;
use crate::{FourBar, Hoist, Rotor, RotorKind, ScissorLift, SliderCrank, Stage, StageKind, Table, TablePoint};
use crate::{Winder, Winding};
use numeric::Random;
use quantities::{Angle, Force, Length, Mass, MassDensity};

/// Positions of the scan: beside a maximum of the drawn loads the nearest of them is low by less than 2·10⁻⁷.
const SCANNED: u32 = 60_000;

const KINDS: usize = 7;

/// Number of the table among the kinds.
const TABLE: usize = 5;

struct Drawn(Random);

impl Drawn {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.0.uniform()
    }

    fn length(&mut self, low: f64, high: f64) -> Length {
        Length::from_si(self.between(low, high))
    }

    fn mass(&mut self, high: f64) -> Mass {
        Mass::from_si(self.between(0.1, high))
    }

    fn inertia(&mut self) -> MomentOfInertia {
        MomentOfInertia::from_si(self.between(0.001, 0.05))
    }

    fn angle(&mut self) -> Angle {
        Angle::from_si(self.between(-PI, PI))
    }

    /// Returns a four-bar linkage whose crank rotates fully.
    fn four_bar(&mut self) -> MechanismKind {
        loop {
            let it = FourBar {
                ground: self.length(0.2, 0.5),
                crank: self.length(0.05, 0.2),
                coupler: self.length(0.1, 0.5),
                rocker: self.length(0.1, 0.5),
                is_crossed: self.0.uniform() < 0.5,
                inertia: self.inertia(),
                coupler_mass: self.mass(5.0),
                coupler_centre: self.length(0.0, 0.2),
                coupler_inertia: self.inertia(),
                rocker_mass: self.mass(5.0),
                rocker_centre: self.length(0.0, 0.2),
                rocker_inertia: self.inertia(),
                rocker_torque: Torque::from_si(self.between(-9.0, 9.0)),
                inclination: self.angle(),
                tilt: self.angle(),
            };
            // The scan cannot follow a linkage that is almost straight once a revolution.
            let [g, r] = [it.ground.si(), it.crank.si()];
            let far = it.coupler.si() + it.rocker.si() > 1.05 * (g + r);
            let near = (it.coupler.si() - it.rocker.si()).abs() < 0.95 * (g - r).abs();
            if it.faults().is_empty() && far && near {
                return MechanismKind::FourBar(it);
            }
        }
    }

    fn kind(&mut self, which: usize) -> MechanismKind {
        match which {
            0 => self.four_bar(),
            1 => {
                let crank = self.length(0.05, 0.2);
                MechanismKind::SliderCrank(SliderCrank {
                    crank,
                    rod: crank * self.between(1.1, 6.0),
                    inertia: self.inertia(),
                    mass: self.mass(9.0),
                    inclination: self.angle(),
                    angle: self.angle(),
                })
            }
            2 => MechanismKind::ScissorLift(ScissorLift {
                stages: 2,
                arm_length: Length::from_si(1.2),
                lead: self.length(0.1, 0.9),
                angle: Angle::from_si(self.between(0.2, 0.4)),
                mass: self.mass(40.0),
                arm_mass: self.mass(20.0),
                inertia: self.inertia(),
            }),
            3 => MechanismKind::Winder(Winder {
                winding: if self.0.uniform() < 0.5 { Winding::Up } else { Winding::Off },
                core_diameter: Length::from_si(0.1),
                full_diameter: Length::from_si(0.6),
                start_diameter: self.length(0.2, 0.4),
                thickness: Length::from_si(1e-3),
                width: self.length(0.1, 1.0),
                density: MassDensity::from_si(900.0),
                tension: Force::from_si(self.between(-50.0, 50.0)),
                inertia: self.inertia(),
            }),
            4 => MechanismKind::Hoist(Hoist {
                drum_diameter: self.length(0.1, 0.3),
                falls: 2,
                inertia: self.inertia(),
                mass: self.mass(90.0),
                counterweight: self.mass(90.0),
                rope_mass: self.mass(20.0),
                hanging: Length::from_si(20.0),
                reeving: 0.93,
            }),
            5 => {
                let points = (0..7).map(|k| TablePoint {
                    position: Angle::from_si(f64::from(k) * TAU / 6.0),
                    inertia: MomentOfInertia::from_si(if k % 6 == 0 { 0.4 } else { self.between(0.1, 0.9) }),
                    torque: Torque::from_si(if k % 6 == 0 { 3.0 } else { self.between(-9.0, 9.0) }),
                });
                MechanismKind::Table(Table::new(points.collect()).unwrap())
            }
            _ => MechanismKind::Rotor(Rotor {
                kind: RotorKind::Arm,
                inertia: self.inertia(),
                mass: self.mass(9.0),
                radius: self.length(0.1, 0.5),
                payload_radius: self.length(0.1, 0.5),
                angle: self.angle(),
                tilt: self.angle(),
            }),
        }
    }

    fn mechanism(&mut self, which: usize) -> Mechanism {
        let stage = Stage {
            kind: StageKind::Belt,
            ratio: self.between(0.5, 4.0) * if self.0.uniform() < 0.5 { -1.0 } else { 1.0 },
            efficiency_driving: 1.0,
            efficiency_driven: 1.0,
            inertia_driving: self.inertia(),
            inertia_driven: self.inertia(),
            stiffness: None,
            backlash: None,
            pitch_diameter: None,
        };
        let mut all = Mechanism::direct(MomentOfInertia::from_si(0.0), Torque::from_si(1.0));
        all.kind = self.kind(which);
        all.friction.external = Torque::from_si(self.between(-2.0, 2.0));
        all.stage = (self.0.uniform() < 0.5).then_some(stage);
        all
    }
}

/// Returns the largest of the four values over a scan.
fn scanned(mechanism: &Mechanism, (from, to): (f64, f64), extra: &Extra) -> Values {
    let mut most = [(f64::NEG_INFINITY, from); 4];
    for k in 0..=SCANNED {
        let q = from + (to - from) * f64::from(k) / f64::from(SCANNED);
        let (inertia, holding) = (mechanism.inertia(q, extra).si(), mechanism.holding_torque(q, extra).si());
        see(&mut most, q, [inertia, -inertia, holding, -holding]);
    }
    most.map(|(value, _)| value)
}

#[test]
fn extremes_are_those_of_a_dense_scan() {
    for case in 0..140_u64 {
        let mut drawn = Drawn(Random::new(7_100 + case));
        let which = usize::try_from(case).unwrap() % KINDS;
        let mechanism = drawn.mechanism(which);
        let extra = Extra {
            mass: drawn.mass(5.0),
            inertia: drawn.inertia(),
            force: Force::from_si(drawn.between(-40.0, 40.0)),
            torque: Torque::from_si(drawn.between(-2.0, 2.0)),
        };
        let ratio = mechanism.stage_ratio();
        // A lift stays between its smallest angle and upright, a winder within its roll.
        let span = match which {
            2 => (-0.2, 1.0),
            _ => (drawn.between(-4.0, 4.0), drawn.between(-9.0, 9.0)),
        };
        let span = (span.0 * ratio, span.1 * ratio);
        let found = mechanism.extremes(span.0, span.1, &extra);
        let [inertia, least, up, down] = scanned(&mechanism, span, &extra);
        let name = format!("case {case}: {:?}", mechanism.id());
        // Never less than a value that occurs, and no more than the scan may miss: at the points of a table values fall
        // straight to both sides.
        let missed = if which == TABLE { 1e-3 } else { 2e-7 };
        let check = |found: f64, scanned: f64, what: &str| {
            let scale = scanned.abs().max(1e-3);
            let (under, over) = ((scanned - found) / scale, (found - scanned) / scale);
            assert!(under <= 1e-9 && over <= missed, "{name}, {what}: {found} beside {scanned}, {under:e}");
        };
        check(found.inertia_largest.si(), inertia, "J_max");
        check(-found.inertia_least.si(), least, "-J_min");
        check(found.holding.si(), up.max(down), "T_h");
        // Each extreme is the value at its position.
        let at = |q: f64| (mechanism.inertia(q, &extra).si(), mechanism.holding_torque(q, &extra).si().abs());
        let close = |one: f64, other: f64| (one - other).abs() <= 1e-9 * (1e-6 + other.abs());
        let [least_at, largest_at] = found.inertia_at_rad;
        assert!(close(at(least_at).0, found.inertia_least.si()), "{name}");
        assert!(close(at(largest_at).0, found.inertia_largest.si()), "{name}");
        assert!(close(at(found.holding_at_rad).1, found.holding.si()), "{name}");
    }
}

/// A slider crank with an endless rod has x' = −r sin q: J = J_c + m r² sin² q, largest at 90°, least at 0°.
#[test]
fn extremes_of_a_crank_with_a_long_rod_by_hand() {
    let kind = MechanismKind::SliderCrank(SliderCrank {
        crank: Length::from_si(0.1),
        rod: Length::from_si(1e6),
        inertia: MomentOfInertia::from_si(0.02),
        mass: Mass::from_si(3.0),
        inclination: Angle::from_si(PI / 6.0),
        angle: Angle::from_si(0.0),
    });
    let crank = Mechanism { kind, ..Mechanism::direct(MomentOfInertia::from_si(0.0), Torque::from_si(0.0)) };
    let of = |from: f64, to: f64| {
        let found = crank.extremes(from, to, &Extra::none());
        [found.inertia_least.si(), found.inertia_largest.si(), found.holding.si()]
    };
    let near = |found: [f64; 3], by_hand: [f64; 3]| {
        for (found, by_hand) in found.into_iter().zip(by_hand) {
            assert!((found / by_hand - 1.0).abs() < 1e-6, "{found} {by_hand}");
        }
    };
    // 0.02 + 3·0.01 = 0.05 kgm² and 0.1·3·9.80665·sin 30° = 1.4709975 Nm at 90°.
    near(of(-1.0, 2.9), [0.02, 0.05, 1.470_997_5]);
    near(
        of(0.3, 0.9),
        [0.02 + 0.03 * 0.3_f64.sin().powi(2), 0.02 + 0.03 * 0.9_f64.sin().powi(2), 1.470_997_5 * 0.9_f64.sin()],
    );
    // The range may be given from above.
    near(of(2.9, -1.0), [0.02, 0.05, 1.470_997_5]);
}

#[test]
fn a_load_at_one_position_has_no_range() {
    let mut drawn = Drawn(Random::new(1));
    for which in 0..KINDS {
        let mechanism = drawn.mechanism(which);
        let found = mechanism.extremes(0.1, 0.1, &Extra::none());
        let inertia = mechanism.inertia(0.1, &Extra::none());
        assert_eq!((found.inertia_least, found.inertia_largest), (inertia, inertia));
        assert_eq!(found.holding.si(), mechanism.holding_torque(0.1, &Extra::none()).si().abs());
    }
}
