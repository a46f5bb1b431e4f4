//! Reading bodies: values, and every fault with its place.

use axis::{InertiaAnswer, inertia};
use project::BODY_SHAPES;
use quantities::{Language, Measure};
use words::worded;

fn close(value: f64, expected: f64) -> bool {
    (value - expected).abs() <= 1e-9 * expected.abs()
}

fn answer(text: &str) -> InertiaAnswer {
    inertia(text).unwrap()
}

/// Place and message of each fault.
fn faults(text: &str) -> Vec<(String, String)> {
    let found = worded(&inertia(text).unwrap_err(), Language::En);
    found.into_iter().map(|fault| (text.get(fault.span).unwrap_or("?").to_owned(), fault.message)).collect()
}

fn underlined(text: &str) -> Vec<String> {
    faults(text).into_iter().map(|(place, _)| place).collect()
}

#[test]
fn every_shape_is_read_in_any_spacing() {
    for (text, inertia) in [
        ("cylinder diameter=100mm length=300mm mass=2kg", 2.5e-3),
        ("  Disc   diameter = 10 cm   length= 300 mm mass =2 kg ", 2.5e-3),
        ("cylinder diameter=100mm length=300mm axis=perpendicular mass=2kg", 0.016_25),
        ("tube outer=100mm inner=80mm length=300mm mass=2kg", 4.1e-3),
        ("tube outer=100mm inner=80mm length=300mm mass=2kg axis=perpendicular", 0.017_05),
        ("box a=300mm b=400mm height=7mm mass=2kg", 0.25 / 6.0),
        ("cone diameter=200mm height=90mm mass=2kg", 6e-3),
        ("sphere diameter=200mm mass=2kg", 8e-3),
        ("rod length=600mm mass=2kg", 0.06),
        ("point mass=500 g distance=0.2 m angle=90deg", 0.02),
    ] {
        assert!(close(answer(text).total.inertia.si(), inertia), "{text}");
    }
}

#[test]
fn several_bodies_add_up() {
    let found = answer(
        "cylinder diameter=200mm length=20mm density=7850kg/m^3\nbox a=50mm b=50mm height=30mm mass=0.6kg distance=80mm count=4",
    );
    assert_eq!(found.bodies.len(), 2);
    assert!(close(found.total.mass.si(), std::f64::consts::PI * 0.01 * 0.02 * 7850.0 + 2.4));
    assert!(close(found.total.inertia.si(), std::f64::consts::PI * 0.01 * 0.02 * 7850.0 * 0.005 + 0.016_36));
}

#[test]
fn every_shape_has_a_reader_for_each_of_its_keys() {
    for shape in &BODY_SHAPES {
        let dimensions: Vec<String> =
            shape.dimensions.iter().enumerate().map(|(at, key)| format!("{key}={}mm", 90 - at)).collect();
        let body = format!("{} {}", shape.name, dimensions.join(" "));
        let of_mass = answer(&format!("{body} mass=1kg")).total;
        assert!(of_mass.mass.si() > 0.0);
        // The inertia about the own axis does not depend on the extent along it.
        let Some(extent) = shape.extent else { continue };
        assert_eq!(answer(&format!("{body} {extent}=50mm mass=1kg")).total, of_mass, "{body}");
        let places = |text: &str| faults(text).into_iter().map(|(place, _)| place).collect::<Vec<_>>();
        assert_eq!(places(&format!("{body} density=1kg/dm^3")), [shape.name], "{body}");
        assert!(answer(&format!("{body} {extent}=50mm density=1kg/dm^3")).total.mass.si() > 0.0);
        if shape.may_lie {
            assert_eq!(places(&format!("{body} mass=1kg axis=perpendicular")), [shape.name], "{body}");
            assert!(inertia(&format!("{body} mass=1kg axis=perpendicular {extent}=50mm")).is_ok());
        }
    }
}

#[test]
fn all_faults_at_once_each_at_its_place() {
    let text = "cylinder diameter=200 length=20s densty=7850kg/m^3\ntub outer=50mm\ntube outer=50mm inner=60mm length=0mm mass=1kg density=1kg/dm^3 count=0";
    assert_eq!(
        faults(text).into_iter().map(|(place, _)| place).collect::<Vec<_>>(),
        ["200", "s", "densty", "tub", "60mm", "0mm", "1kg/dm^3", "0"]
    );
    let found = worded(&inertia(text).unwrap_err(), Language::De);
    let lines: Vec<usize> = found.iter().map(|fault| fault.line).collect();
    assert_eq!(lines, [1, 1, 1, 2, 3, 3, 3, 3]);
    assert!(found.iter().any(|fault| fault.hint.as_deref() == Some("gemeint ist vielleicht `density`")));
    assert!(found.iter().any(|fault| fault.hint.as_deref() == Some("gemeint ist vielleicht `tube`")));
}

#[test]
fn what_is_missing_is_reported_at_the_shape() {
    assert_eq!(
        faults("box mass=1kg"),
        [("box".to_owned(), "`a` is missing".to_owned()), ("box".to_owned(), "`b` is missing".to_owned())]
    );
    assert_eq!(
        faults("sphere diameter=5mm"),
        [("sphere".to_owned(), "neither `mass` nor `density` is given".to_owned())]
    );
    assert_eq!(underlined("sphere diameter=5mm mass=kg"), ["kg"], "the mass is there, but no number");
    assert_eq!(underlined("point density=1kg/l"), ["1kg/l"]);
}

#[test]
fn strange_lines_are_refused_without_panic() {
    for text in [
        "",
        " ",
        "\n",
        "=",
        "==",
        "a=",
        "=5mm",
        "sphere",
        "sphere =",
        "sphere diameter==5mm mass=1kg",
        "5mm",
        "diameter=5mm",
        "sphere 5mm mass=1kg diameter=5mm",
        "sphere diameter=5mm mass=1kg mass=1kg",
        "sphere diameter=5mm mass=1kg count=1.5",
        "sphere diameter=5mm mass=1kg count=+1",
        "sphere diameter=5mm mass=1kg count=4294967296",
        "sphere diameter=-5mm mass=1kg",
        "sphere diameter=5mm mass=1kg distance=-1mm",
        "sphere diameter=1e200m mass=1e300kg",
        "cylinder diameter=5mm length=5mm mass=1kg axis=flat",
        "sphere\u{a0}diameter=5mm",
        "ä=ö ü=ß",
        "sphère ø=1mm",
        "point mass=1kg\n",
        "sphere diameter=5mm inner=1mm mass=1kg",
        "sphere\u{2003}=\u{2003}5mm",
    ] {
        for language in [Language::En, Language::De] {
            let found = worded(&inertia(text).unwrap_err(), language);
            assert!(!found.is_empty(), "{text:?}");
            for fault in found {
                assert!(text.get(fault.span.clone()).is_some(), "{text:?}: {fault:?}");
            }
        }
    }
}

#[test]
fn no_more_than_fifty_faults_are_reported() {
    let text = vec!["ball"; 80].join("\n");
    let found = worded(&inertia(&text).unwrap_err(), Language::En);
    assert_eq!(found.len(), 51);
    assert!(found.last().unwrap().message.contains("30 more"));
}

const TAIL: &str =
    "[[motion]]\nlaw = \"modified_sine\"\ndistance = \"60 deg\"\ntime = \"0.5 s\"\n[axis]\nsingle_move = true\n";

fn turntable(bodies: &str) -> String {
    format!("format = 1\n[mechanism.turntable]\naxis_tilt = \"90 deg\"\n{bodies}\n{TAIL}")
}

/// Place and message of each fault of a turntable.
fn refused(bodies: &str) -> Vec<(String, String)> {
    let text = turntable(bodies);
    let found = worded(&crate::read(&text).map(|_| ()).unwrap_err(), Language::En);
    found.into_iter().map(|fault| (text.get(fault.span).unwrap_or("?").to_owned(), fault.message)).collect()
}

const TABLES: &str = "[[mechanism.turntable.body]]\nshape = \"disc\"\ndiameter = \"420 mm\"\nlength = \"12 mm\"\n\
    density = \"2700 kg/m^3\"\n[[mechanism.turntable.body]]\nshape = \"box\"\na = \"60 mm\"\nb = \"40 mm\"\n\
    height = \"50 mm\"\nmass = \"0.9 kg\"\ndistance = \"160 mm\"\nangle = \"30 deg\"\ncount = 1\n\
    [[mechanism.turntable.body]]\nshape = \"tube\"\nouter = \"90 mm\"\ninner = \"60 mm\"\nlength = \"40 mm\"\n\
    density = \"7850 kg/m^3\"\naxis = \"perpendicular\"\n";

#[test]
fn bodies_as_tables_are_the_bodies_of_the_lines() {
    let lines = "bodies = [\"disc diameter=420mm length=12mm density=2700kg/m^3\", \
                 \"box a=60mm b=40mm height=50mm mass=0.9kg distance=160mm angle=30deg\", \
                 \"tube outer=90mm inner=60mm length=40mm density=7850kg/m^3 axis=perpendicular\"]";
    let [tables, lines] = [TABLES, lines].map(|bodies| crate::read(&turntable(bodies)).unwrap());
    assert_eq!(format!("{:?}", tables.axis.mechanism), format!("{:?}", lines.axis.mechanism));
    let inline = "body = [{ shape = \"sphere\", diameter = \"0.1 m\", mass = \"2 kg\", distance = \"0.3 m\" }]";
    assert!(crate::read(&turntable(inline)).is_ok());
}

#[test]
fn every_fault_of_a_table_has_its_place() {
    let found = refused(
        &TABLES
            .replace("\"420 mm\"", "\"0 mm\"")
            .replace("b = \"40 mm\"\n", "")
            .replace("\"60 mm\"\nlength = \"40 mm\"", "\"95 mm\"\nlength = \"40 mm\"\nheight = \"1 mm\""),
    );
    let places: Vec<&str> = found.iter().map(|(place, _)| place.as_str()).collect();
    assert_eq!(places, ["\"0 mm\"", "[", "height"], "{found:?}");
    assert!(found[1].1.contains("`mechanism.turntable.body[2].b` is missing"), "{found:?}");
    assert!(found[2].1.contains("has no meaning with shape = \"tube\""), "{found:?}");
    // What only the whole body shows.
    let found = refused(&TABLES.replace("\"60 mm\"\nlength", "\"95 mm\"\nlength").replace("mass = \"0.9 kg\"\n", ""));
    assert_eq!(found.len(), 2, "{found:?}");
    assert_eq!((found[0].0.as_str(), found[1].0.as_str()), ("\"box\"", "\"95 mm\""));
    let both = format!("bodies = [\"point mass=1kg\"]\n{TABLES}");
    assert!(refused(&both)[0].1.contains("not both"), "{:?}", refused(&both));
    assert!(refused("")[0].1.contains("`[[mechanism.turntable.body]]` is missing"), "{:?}", refused(""));
    assert_eq!(refused("body = []").len(), 1, "{:?}", refused("body = []"));
}

#[test]
fn a_table_of_a_body_may_carry_a_tolerance() {
    let text = turntable(&TABLES.replace("0.9 kg", "0.9 kg ± 10 %"));
    let project = crate::read(&text).unwrap();
    let paths: Vec<&str> = project.tolerances.iter().map(|each| each.path.as_str()).collect();
    assert_eq!(paths, ["mechanism.turntable.body[2].mass"]);
    let heavier = axis::Varied::new(&project).unwrap().at(&[0.99]).unwrap();
    let inertia = |axis: &sizing::Axis| axis.moments().inertia_max.si();
    // 10 % of m r² and of the box's own m (a² + b²) / 12.
    let more = 0.09 * (0.16 * 0.16 + (0.06 * 0.06 + 0.04 * 0.04) / 12.0);
    assert!(close(inertia(&heavier.axis) - inertia(&project.axis), more));
}
