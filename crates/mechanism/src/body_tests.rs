//! Solid bodies compared with values by hand, limits, additivity and scaling.

use super::*;
use quantities::unit::{CENTIMETRE, DEGREE, MILLIMETRE};

fn mm(value: f64) -> Length {
    Length::new_in(value, &MILLIMETRE)
}

fn kg(value: f64) -> Option<Mass> {
    Some(Mass::from_si(value))
}

const STEEL: f64 = 7850.0;

fn density(value: f64) -> Option<MassDensity> {
    Some(MassDensity::from_si(value))
}

fn cylinder(diameter: f64, length: f64) -> SolidShape {
    SolidShape::Cylinder { diameter: mm(diameter), length: Some(mm(length)), orientation: Orientation::Parallel }
}

fn tube(outer: f64, inner: f64, length: f64, orientation: Orientation) -> SolidShape {
    SolidShape::Tube { outer: mm(outer), inner: mm(inner), length: Some(mm(length)), orientation }
}

fn close(value: f64, expected: f64) -> bool {
    (value - expected).abs() <= 1e-12 * expected.abs()
}

fn on_axis(shape: SolidShape, mass: Option<Mass>, density: Option<MassDensity>) -> Body {
    Body { shape, mass, density, distance: mm(0.0), angle: Angle::from_si(0.0), count: 1 }
}

/// Returns m and J about its own axis of a body on the axis of rotation.
fn own(shape: SolidShape, mass: Option<Mass>, density: Option<MassDensity>) -> (f64, f64) {
    let found = inertia(&[on_axis(shape, mass, density)]).unwrap();
    (found.mass.si(), found.inertia.si())
}

/// A steel disc of 200 mm and 20 mm: V = π/4 · 0.04 · 0.02 = 6.283185e-4 m³, m = 4.932300 kg, J = m · 0.01/2.
#[test]
fn a_steel_disc_by_hand() {
    let (mass, inertia) = own(cylinder(200.0, 20.0), None, density(STEEL));
    assert!((mass - 4.932_300_5).abs() < 5e-7, "{mass}");
    assert!((inertia - 0.024_661_502).abs() < 5e-9, "{inertia}");
}

/// Shapes of 2 kg each, with values typed from textbook formulas.
#[test]
fn every_shape_by_hand() {
    let two = |shape| own(shape, kg(2.0), None).1;
    let across = |shape: SolidShape| match shape {
        SolidShape::Cylinder { diameter, length, .. } => {
            SolidShape::Cylinder { diameter, length, orientation: Orientation::Perpendicular }
        }
        other => other,
    };
    // ½ m r² = ½ · 2 · 0.05²
    assert!(close(two(cylinder(100.0, 300.0)), 2.5e-3));
    // m (3 r² + L²)/12 = 2 · (0.0075 + 0.09)/12
    assert!(close(two(across(cylinder(100.0, 300.0))), 0.016_25));
    // ½ m (r_o² + r_i²) = 0.0025 + 0.0016
    assert!(close(two(tube(100.0, 80.0, 300.0, Orientation::Parallel)), 4.1e-3));
    // m (3 (r_o² + r_i²) + L²)/12 = 2 · (0.0123 + 0.09)/12
    assert!(close(two(tube(100.0, 80.0, 300.0, Orientation::Perpendicular)), 0.017_05));
    // m (a² + b²)/12 = 2 · (0.09 + 0.16)/12; independent of the height
    assert!(close(two(SolidShape::Box { a: mm(300.0), b: mm(400.0), height: Some(mm(7.0)) }), 0.25 / 6.0));
    // 3/10 m r² = 0.6 · 0.01
    assert!(close(two(SolidShape::Cone { diameter: mm(200.0), height: Some(mm(90.0)) }), 6e-3));
    // 2/5 m r² = 0.8 · 0.01
    assert!(close(two(SolidShape::Sphere { diameter: mm(200.0) }), 8e-3));
    // m L²/12 = 2 · 0.36/12
    assert!(close(two(SolidShape::Rod { length: mm(600.0) }), 0.06));
    assert!(two(SolidShape::PointMass).abs() < 1e-300);
}

/// With water, 1000 kg/m³, the mass in kg is the volume in litres.
#[test]
fn volumes_are_exact() {
    let litres = |shape| own(shape, None, density(1000.0)).0;
    assert!(close(litres(cylinder(200.0, 100.0)), PI));
    assert!(close(litres(tube(200.0, 100.0, 100.0, Orientation::Perpendicular)), 0.75 * PI));
    assert!(close(litres(SolidShape::Box { a: mm(100.0), b: mm(200.0), height: Some(mm(300.0)) }), 6.0));
    assert!(close(litres(SolidShape::Cone { diameter: mm(200.0), height: Some(mm(300.0)) }), PI));
    assert!(close(litres(SolidShape::Sphere { diameter: mm(200.0) }), 4.0 / 3.0 * PI));
}

#[test]
fn a_tube_without_bore_is_a_cylinder() {
    for orientation in [Orientation::Parallel, Orientation::Perpendicular] {
        let solid = SolidShape::Cylinder { diameter: mm(80.0), length: Some(mm(50.0)), orientation };
        let (mass, inertia) = own(solid, None, density(STEEL));
        for bore in [0.0, 1e-7] {
            let found = own(tube(80.0, bore, 50.0, orientation), None, density(STEEL));
            assert!(close(found.0, mass) && close(found.1, inertia), "{bore} {orientation:?}");
        }
    }
}

#[test]
fn a_thin_ring_has_m_r_squared() {
    let (_, inertia) = own(tube(200.0, 199.999_999, 10.0, Orientation::Parallel), kg(3.0), None);
    assert!((inertia - 3.0 * 0.01).abs() < 1e-9);
}

#[test]
fn a_thin_lying_cylinder_is_a_rod_and_a_narrow_box_too() {
    let rod = own(SolidShape::Rod { length: mm(500.0) }, kg(1.0), None).1;
    let thin =
        SolidShape::Cylinder { diameter: mm(1e-4), length: Some(mm(500.0)), orientation: Orientation::Perpendicular };
    assert!(close(own(thin, kg(1.0), None).1, rod));
    assert!(close(own(SolidShape::Box { a: mm(500.0), b: mm(1e-4), height: Some(mm(9.0)) }, kg(1.0), None).1, rod));
}

#[test]
fn a_bore_is_a_cylinder_taken_away() {
    let full = own(cylinder(100.0, 40.0), None, density(STEEL));
    let core = own(cylinder(60.0, 40.0), None, density(STEEL));
    let found = own(tube(100.0, 60.0, 40.0, Orientation::Parallel), None, density(STEEL));
    assert!(close(found.0, full.0 - core.0) && close(found.1, full.1 - core.1));
}

/// Two halves of a box, each off the axis by a quarter of its side, are equivalent to the whole box.
#[test]
fn steiner_adds_the_halves_of_a_box_to_the_whole() {
    let whole = own(SolidShape::Box { a: mm(400.0), b: mm(100.0), height: Some(mm(30.0)) }, None, density(STEEL));
    let half = Body {
        distance: mm(100.0),
        count: 2,
        ..on_axis(SolidShape::Box { a: mm(200.0), b: mm(100.0), height: Some(mm(30.0)) }, None, density(STEEL))
    };
    let found = inertia(&[half]).unwrap();
    assert!(close(found.mass.si(), whole.0) && close(found.inertia.si(), whole.1));
    assert!(found.centre_radius.si().abs() < 1e-300);
    let one = Body { count: 1, ..half };
    let apart = inertia(&[one, Body { angle: Angle::new_in(180.0, &DEGREE), ..one }]).unwrap();
    assert!(close(apart.inertia.si(), whole.1));
    assert_eq!((apart.centre_radius.si(), apart.centre_angle.si()), (0.0, 0.0), "balanced");
}

#[test]
fn the_parts_of_one_body_add_up() {
    let body = Body {
        distance: mm(80.0),
        count: 4,
        ..on_axis(SolidShape::Box { a: mm(50.0), b: mm(50.0), height: Some(mm(30.0)) }, kg(0.6), None)
    };
    let parts = body.inertia().unwrap();
    // 0.6 · 0.005/12 = 2.5e-4; 0.6 · 0.0064 = 3.84e-3; 4 · 4.09e-3.
    assert!(close(parts.own.si(), 2.5e-4) && close(parts.steiner.si(), 3.84e-3) && close(parts.total.si(), 0.016_36));
    assert!(close(inertia(&[body]).unwrap().inertia.si(), 0.016_36));
}

#[test]
fn the_centre_of_mass_and_its_gravity() {
    let at = |mass, distance, degrees| Body {
        distance: mm(distance),
        angle: Angle::new_in(degrees, &DEGREE),
        ..on_axis(SolidShape::PointMass, kg(mass), None)
    };
    // 3 kg at 400 mm along x and 4 kg at 300 mm along y: 1.2 kgm in each direction, for 7 kg.
    let found = inertia(&[at(3.0, 400.0, 0.0), at(4.0, 300.0, 90.0)]).unwrap();
    assert!(close(found.centre_radius.si(), 1.2 * 2.0_f64.sqrt() / 7.0));
    assert!(close(found.centre_angle.si(), PI / 4.0));
    assert!(close(found.gravity_torque_max().si(), 1.2 * 2.0_f64.sqrt() * 9.806_65));
    assert!(close(found.inertia.si(), 3.0 * 0.16 + 4.0 * 0.09));
}

/// At constant density the mass scales with s³ and J with s⁵ in the lengths; at constant mass J scales with s².
#[test]
fn scaling_laws() {
    let shapes: [fn(f64) -> SolidShape; 6] = [
        |s| cylinder(80.0 * s, 30.0 * s),
        |s| tube(80.0 * s, 50.0 * s, 30.0 * s, Orientation::Perpendicular),
        |s| SolidShape::Box { a: mm(20.0 * s), b: mm(70.0 * s), height: Some(mm(30.0 * s)) },
        |s| SolidShape::Cone { diameter: mm(80.0 * s), height: Some(mm(30.0 * s)) },
        |s| SolidShape::Sphere { diameter: mm(80.0 * s) },
        |s| SolidShape::Rod { length: mm(80.0 * s) },
    ];
    for shape in shapes {
        for s in [0.01, 3.0, 1000.0] {
            let off = |mass, density, s: f64| {
                let body = Body { distance: mm(120.0 * s), ..on_axis(shape(s), mass, density) };
                inertia(&[body]).unwrap()
            };
            assert!(close(off(kg(2.0), None, s).inertia.si(), s * s * off(kg(2.0), None, 1.0).inertia.si()));
            if !matches!(shape(1.0), SolidShape::Rod { .. }) {
                let (big, small) = (off(None, density(STEEL), s), off(None, density(STEEL), 1.0));
                assert!(close(big.mass.si(), s.powi(3) * small.mass.si()));
                assert!(close(big.inertia.si(), s.powi(5) * small.inertia.si()));
            }
        }
    }
}

#[test]
fn no_body_has_no_inertia() {
    let none = inertia(&[]).unwrap();
    assert_eq!((none.inertia.si(), none.mass.si(), none.centre_radius.si()), (0.0, 0.0, 0.0));
}

#[test]
fn every_fault_of_every_body_is_reported() {
    let broken = Body {
        distance: mm(-1.0),
        angle: Angle::from_si(f64::NAN),
        count: 0,
        ..on_axis(tube(50.0, 60.0, 0.0, Orientation::Parallel), kg(1.0), density(STEEL))
    };
    let good = on_axis(SolidShape::PointMass, kg(1.0), None);
    let faults = inertia(&[good, broken]).unwrap_err();
    assert!(faults.iter().all(|fault| fault.body == 1));
    let errors: Vec<BodyError> = faults.into_iter().map(|fault| fault.error).collect();
    assert_eq!(
        errors,
        [
            BodyError::DimensionOutOfRange { field: "length", value: mm(0.0) },
            BodyError::InnerNotBelowOuter { inner: mm(60.0), outer: mm(50.0) },
            BodyError::MassAndDensity { mass: Mass::from_si(1.0), density: MassDensity::from_si(STEEL) },
            BodyError::DistanceOutOfRange { distance: mm(-1.0) },
            BodyError::AngleNotFinite,
            BodyError::NoPiece,
        ]
    );
}

#[test]
fn a_mass_is_needed_and_must_be_one() {
    let faults = |shape, mass, density| on_axis(shape, mass, density).faults();
    let ball = SolidShape::Sphere { diameter: Length::new_in(5.0, &CENTIMETRE) };
    assert_eq!(faults(ball, None, None), [BodyError::NoMass]);
    assert_eq!(faults(ball, kg(0.0), None), [BodyError::MassOutOfRange { mass: Mass::from_si(0.0) }]);
    let negative = MassDensity::from_si(-1.0);
    assert_eq!(faults(ball, None, Some(negative)), [BodyError::DensityOutOfRange { density: negative }]);
    for shape in [SolidShape::PointMass, SolidShape::Rod { length: mm(10.0) }] {
        assert_eq!(faults(shape, None, density(1.0)), [BodyError::NoVolume]);
    }
    let equal = tube(50.0, 50.0, 10.0, Orientation::Parallel);
    assert_eq!(faults(equal, kg(1.0), None), [BodyError::InnerNotBelowOuter { inner: mm(50.0), outer: mm(50.0) }]);
}

#[test]
fn what_overflows_is_refused() {
    let far = |mass| Body { distance: Length::from_si(1e150), ..on_axis(SolidShape::PointMass, kg(mass), None) };
    assert_eq!(far(1e10).inertia().unwrap_err(), [BodyError::BeyondNumbers]);
    let faults = inertia(&[far(1e8), far(1e8)]).unwrap_err();
    assert_eq!(faults, [BodyFault { body: 1, error: BodyError::BeyondNumbers }]);
}
