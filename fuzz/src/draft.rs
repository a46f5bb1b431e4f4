//! Generation of projects from bytes: every mechanism, law, stage, load and requirement, mostly with realistic sizes.

mod asked;
mod load;
mod motion;
mod page;
mod twin;

use arbitrary::{Result, Unstructured};
use load::{LoadKind, forces};
use page::{ANGLE, FORCE, INERTIA, LENGTH, MASS, Page, TORQUE};

/// Generates a project file with one axis or several, without recordings. With `ratios`, some files have several ratios
/// of their stage, for each of which the whole catalogue is sized while the file is read.
///
/// # Errors
/// The case has too few bytes.
pub fn project(u: &mut Unstructured<'_>, ratios: bool) -> Result<String> {
    let tolerances = if u.ratio(1, 8)? { 4 } else { 0 };
    let edges = u.ratio(1, 6)?;
    let several = u.ratio(1, 10)?;
    let prefix = if several { "axis." } else { "" };
    let mut page = Page { u, text: String::from("format = 1\n"), prefix, tolerances, edges, effective: &[], ratios };
    if several {
        for name in ["swivel", "lift", "wrist"].iter().take(page.u.int_in_range(2..=3)?) {
            page.text.push_str("[[axis]]\n");
            page.word("name", name);
            axis(&mut page)?;
        }
    } else {
        page.text.push_str("[axis]\n");
        page.word("name", "axis of a case");
        axis(&mut page)?;
    }
    Ok(page.text)
}

/// Writes the tables of an axis after its name, the keys of `[axis]` first.
fn axis(page: &mut Page<'_, '_>) -> Result<()> {
    let single = page.seldom()?;
    if single {
        page.plain("single_move", true);
    }
    let load = load(page)?;
    if page.u.ratio(1, 8)? {
        stage(page)?;
    }
    motion::motions(page, load, single)?;
    if page.u.ratio(1, 2)? || (has_own_loads(page) && page.text.contains("motion.bearing]")) {
        bearing(page)?;
    }
    if page.often()? {
        asked::requirements(page)?;
    }
    if page.u.ratio(1, 8)? {
        asked::actuator(page)?;
    }
    if page.prefix.is_empty() && page.u.ratio(1, 12)? {
        asked::curve(page)?;
    }
    if page.u.ratio(1, 4)? {
        twin::twin(page)?;
    }
    Ok(())
}

/// Keys of `[bearing]` for a load that rotates with the flange, a screw or crank, a belt or rack, a conveyor.
const TURNING: &[&str] = &["overhang", "payload_overhang", "flange_share"];
const COUPLED: &[&str] = &["overhang", "flange_share", "wheel_mass"];
const PULLED: &[&str] = &["overhang", "flange_share", "wheel_mass", "belt_tension"];
const MESHED: &[&str] = &["overhang", "flange_share", "wheel_mass", "pressure_angle"];

fn load(page: &mut Page<'_, '_>) -> Result<LoadKind> {
    let kind = page.u.int_in_range(0..=11)?;
    page.effective = match kind {
        1 | 2 => TURNING,
        3 | 6 | 8..=11 => COUPLED,
        4 => *page.u.choose(&[PULLED, MESHED])?,
        5 => PULLED,
        _ => &[],
    };
    let found = match kind {
        0 => {
            page.table("load");
            page.key("inertia", 1e-3, 20.0, INERTIA)?;
            LoadKind::Free
        }
        1 => turntable(page)?,
        2 => {
            page.table("mechanism.arm");
            page.key("mass", 0.2, 30.0, MASS)?;
            if page.u.ratio(1, 2)? {
                page.key("inertia", 0.01, 8.0, INERTIA)?;
                page.key("centre_distance", 10.0, 600.0, LENGTH)?;
            } else {
                let shape = *page.u.choose(&["rod", "bar", "taper", "point"])?;
                page.word("shape", shape);
                page.key("length", 50.0, 1500.0, LENGTH)?;
                if shape == "bar" {
                    page.key("width", 10.0, 200.0, LENGTH)?;
                }
            }
            page.may("payload_distance", 50.0, 900.0, LENGTH)?;
            page.may("axis_tilt", 0.0, 90.0, ANGLE)?;
            page.may("start_angle", -90.0, 90.0, ANGLE)?;
            LoadKind::Bound
        }
        3 | 4 => {
            let belt = kind == 4;
            page.table(if belt { "mechanism.belt" } else { "mechanism.screw" });
            if belt {
                page.key("pulley_diameter", 20.0, 200.0, LENGTH)?
            } else {
                page.key("lead", 2.0, 60.0, LENGTH)?
            }
            page.key("mass", 0.5, 60.0, MASS)?;
            line(page)?;
            page.may("counterweight", 0.1, 20.0, MASS)?;
            LoadKind::Line
        }
        5 => {
            page.table("mechanism.conveyor");
            page.key("roller_diameter", 40.0, 300.0, LENGTH)?;
            page.key("mass", 0.5, 80.0, MASS)?;
            line(page)?;
            LoadKind::Belt
        }
        6 => {
            page.table("mechanism.slider_crank");
            let crank = page.between(10.0, 150.0)?;
            page.exactly("crank", crank, LENGTH)?;
            let rod = crank * page.between(1.5, 6.0)?;
            page.exactly("rod", rod, LENGTH)?;
            page.key("mass", 0.2, 20.0, MASS)?;
            page.key("start_angle", 0.0, 180.0, ANGLE)?;
            page.may("inclination", -90.0, 90.0, ANGLE)?;
            page.may("process_force", -200.0, 200.0, FORCE)?;
            page.may("inertia", 1e-3, 1.0, INERTIA)?;
            LoadKind::Free
        }
        7 => table(page)?,
        8 => hoist(page)?,
        9 => winder(page)?,
        10 => scissor_lift(page)?,
        _ => four_bar(page)?,
    };
    // The bodies of a turntable are tables of their own, after the keys common to all.
    if kind != 1 {
        shared(page, kind != 0)?;
    }
    Ok(found)
}

/// Writes keys permitted for every mechanism.
fn shared(page: &mut Page<'_, '_>, efficiencies: bool) -> Result<()> {
    page.may("friction_torque", 0.1, 15.0, TORQUE)?;
    page.may("viscous_friction", 0.01, 3.0, &[("N m s/rad", 1.0)])?;
    page.may("external_torque", -10.0, 10.0, TORQUE)?;
    if efficiencies {
        page.may_number("efficiency", 0.6, 1.0)?;
        page.may_number("efficiency_back", 0.3, 1.0)?;
    }
    Ok(())
}

/// Writes keys permitted for every linear mechanism.
fn line(page: &mut Page<'_, '_>) -> Result<()> {
    page.may("inclination", -90.0, 90.0, ANGLE)?;
    page.may("friction_force", 1.0, 80.0, FORCE)?;
    page.may_number("friction_coefficient", 0.0, 0.3)?;
    page.may("process_force", -300.0, 300.0, FORCE)?;
    page.may("inertia", 1e-4, 0.5, INERTIA)
}

fn hoist(page: &mut Page<'_, '_>) -> Result<LoadKind> {
    page.table("mechanism.hoist");
    page.key("drum_diameter", 60.0, 400.0, LENGTH)?;
    if page.often()? {
        let falls = page.u.int_in_range(1..=8)?;
        page.plain("falls", falls);
    }
    page.key("mass", 5.0, 200.0, MASS)?;
    page.may("counterweight", 1.0, 100.0, MASS)?;
    page.may("inertia", 1e-3, 1.0, INERTIA)?;
    if page.u.ratio(1, 2)? {
        page.key("rope_mass", 0.1, 10.0, MASS)?;
        page.key("hanging", 1e3, 1e4, LENGTH)?;
    }
    page.may_number("sheave_efficiency", 0.9, 1.0)?;
    page.may("friction_force", 1.0, 80.0, FORCE)?;
    page.may("process_force", -300.0, 300.0, FORCE)?;
    Ok(LoadKind::Line)
}

fn winder(page: &mut Page<'_, '_>) -> Result<LoadKind> {
    page.table("mechanism.winder");
    if page.often()? {
        let winding = *page.u.choose(&["up", "off"])?;
        page.word("winding", winding);
    }
    let core = page.between(40.0, 200.0)?;
    let full = core * page.between(1.5, 6.0)?;
    let start = page.between(core, full)?;
    for (key, diameter) in [("core_diameter", core), ("full_diameter", full)] {
        page.exactly(key, diameter, LENGTH)?;
    }
    if page.u.ratio(1, 2)? {
        page.exactly("start_diameter", start, LENGTH)?;
    }
    page.key("thickness", 0.02, 10.0, LENGTH)?;
    page.key("width", 50.0, 1000.0, LENGTH)?;
    page.key("density", 500.0, 2700.0, &[("kg/m^3", 1.0)])?;
    page.key("tension", 5.0, 400.0, FORCE)?;
    page.may("inertia", 1e-3, 1.0, INERTIA)?;
    Ok(LoadKind::Winder)
}

fn scissor_lift(page: &mut Page<'_, '_>) -> Result<LoadKind> {
    page.table("mechanism.scissor_lift");
    if page.often()? {
        let stages = page.u.int_in_range(1..=5)?;
        page.plain("stages", stages);
    }
    page.key("arm_length", 200.0, 2000.0, LENGTH)?;
    page.key("lead", 2.0, 40.0, LENGTH)?;
    page.key("arm_angle", 5.0, 80.0, ANGLE)?;
    page.key("mass", 5.0, 200.0, MASS)?;
    page.may("arm_mass", 1.0, 80.0, MASS)?;
    page.may("inertia", 1e-4, 0.1, INERTIA)?;
    page.may("process_force", -300.0, 300.0, FORCE)?;
    Ok(LoadKind::Bound)
}

fn four_bar(page: &mut Page<'_, '_>) -> Result<LoadKind> {
    page.table("mechanism.four_bar");
    let crank = page.between(20.0, 150.0)?;
    // The crank is the shortest link; together with the ground it stays shorter than coupler and rocker.
    let [ground, coupler, rocker] = [(3.0, 5.0), (3.0, 4.0), (2.5, 3.5)];
    page.exactly("crank", crank, LENGTH)?;
    for (key, (low, high)) in [("ground", ground), ("coupler", coupler), ("rocker", rocker)] {
        let length = crank * page.between(low, high)?;
        page.exactly(key, length, LENGTH)?;
    }
    if page.u.ratio(1, 4)? {
        page.plain("crossed", true);
    }
    page.may("inertia", 1e-3, 1.0, INERTIA)?;
    for part in ["coupler", "rocker"] {
        page.may(&format!("{part}_mass"), 0.2, 10.0, MASS)?;
        page.may(&format!("{part}_centre"), 10.0, 300.0, LENGTH)?;
        page.may(&format!("{part}_inertia"), 1e-3, 1.0, INERTIA)?;
    }
    page.may("rocker_torque", -20.0, 20.0, TORQUE)?;
    page.key("axis_tilt", 0.0, 90.0, ANGLE)?;
    page.may("inclination", -90.0, 90.0, ANGLE)?;
    page.may("start_angle", -180.0, 180.0, ANGLE)?;
    Ok(LoadKind::Free)
}

fn turntable(page: &mut Page<'_, '_>) -> Result<LoadKind> {
    let in_lines = page.u.ratio(1, 3)?;
    page.table("mechanism.turntable");
    let tilted = page.u.ratio(1, 3)?;
    if tilted {
        page.key("axis_tilt", 0.0, 90.0, ANGLE)?;
        page.may("start_angle", -180.0, 180.0, ANGLE)?;
        page.may("payload_distance", 50.0, 900.0, LENGTH)?;
    }
    shared(page, true)?;
    if in_lines {
        let bodies = ["disc diameter=300mm length=10mm mass=5kg", "point mass=1kg distance=200mm angle=30deg"];
        let more = ["tube outer=90mm inner=60mm length=40mm density=7850kg/m^3", "sphere diameter=80mm mass=2kg"];
        let chosen = format!("[\"{}\", \"{}\"]", page.u.choose(&bodies)?, page.u.choose(&more)?);
        page.plain("bodies", chosen);
    } else {
        for _ in 0..page.u.int_in_range(1..=3)? {
            page.row("mechanism.turntable.body");
            body(page)?;
        }
    }
    Ok(if tilted { LoadKind::Bound } else { LoadKind::Free })
}

fn body(page: &mut Page<'_, '_>) -> Result<()> {
    let shapes: [(&str, &[&str]); 8] = [
        ("cylinder", &["diameter", "length"]),
        ("disc", &["diameter", "length"]),
        ("tube", &["outer", "inner", "length"]),
        ("box", &["a", "b", "height"]),
        ("cone", &["diameter", "height"]),
        ("sphere", &["diameter"]),
        ("point", &[]),
        ("rod", &["length"]),
    ];
    let (shape, sizes) = *page.u.choose(&shapes)?;
    page.word("shape", shape);
    for size in sizes {
        let (low, high) = if *size == "inner" { (5.0, 40.0) } else { (41.0, 500.0) };
        page.key(size, low, high, LENGTH)?;
    }
    if shape == "point" || shape == "rod" || page.u.ratio(1, 2)? {
        page.key("mass", 0.1, 12.0, MASS)?;
    } else {
        page.key("density", 1000.0, 7850.0, &[("kg/m^3", 1.0)])?;
    }
    page.may("distance", 10.0, 400.0, LENGTH)?;
    page.may("angle", -180.0, 180.0, ANGLE)?;
    if page.seldom()? {
        let count = page.u.int_in_range(1..=12)?;
        page.plain("count", count);
    }
    Ok(())
}

fn table(page: &mut Page<'_, '_>) -> Result<LoadKind> {
    page.table("mechanism.table");
    let mut rows = Vec::new();
    let count = page.u.int_in_range(2..=6)?;
    for index in 0..count {
        let angle = -360.0 + 720.0 * f64::from(index) / f64::from(count - 1);
        let inertia = page.between(0.05, 4.0)?;
        let torque = page.between(-20.0, 20.0)?;
        rows.push(format!("[\"{angle:.0} deg\", \"{inertia:.3} kg m^2\", \"{torque:.2} N m\"]"));
    }
    let rows = rows.join(", ");
    page.plain("points", format!("[{rows}]"));
    page.key("start_angle", -45.0, 45.0, ANGLE)?;
    Ok(LoadKind::Bound)
}

fn stage(page: &mut Page<'_, '_>) -> Result<()> {
    page.table("stage");
    let kind = *page.u.choose(&["belt", "gear", "coupling"])?;
    page.word("kind", kind);
    if kind != "coupling" && page.ratios && page.seldom()? {
        page.plain("ratios", "[0.5, 1.5, 2, 4]");
    } else if kind != "coupling" {
        page.number("ratio", 0.3, 8.0)?;
    }
    page.effective = match kind {
        "belt" => PULLED,
        "gear" => MESHED,
        _ => COUPLED,
    };
    page.may_number("efficiency", 0.8, 1.0)?;
    page.may_number("efficiency_back", 0.7, 1.0)?;
    page.may("inertia_driving", 1e-5, 0.05, INERTIA)?;
    page.may("inertia_driven", 1e-4, 0.5, INERTIA)?;
    page.may("stiffness", 1e3, 1e6, &[("N m/rad", 1.0)])?;
    page.may("backlash", 0.01, 0.2, ANGLE)?;
    if kind != "coupling" { page.may("pitch_diameter", 30.0, 300.0, LENGTH) } else { Ok(()) }
}

/// Returns `true` if the mechanism or its stage loads the flange; next to stated loads the file must then describe its
/// own.
fn has_own_loads(page: &Page<'_, '_>) -> bool {
    !page.effective.is_empty()
}

fn bearing(page: &mut Page<'_, '_>) -> Result<()> {
    page.table("bearing");
    let keys = page.effective;
    let states = page.text.contains("motion.bearing]");
    let word = match keys.is_empty() {
        true => "",
        false if !states && page.u.ratio(1, 2)? => "",
        false => *page.u.choose(&["add", "replace", "ignore"])?,
    };
    if word == "add" || word == "replace" {
        let has = |key: &str| keys.contains(&key);
        page.word("mechanism", word);
        page.key("overhang", 5.0, 150.0, LENGTH)?;
        page.may_number("flange_share", 0.0, 1.0)?;
        if has("payload_overhang") {
            page.may("payload_overhang", 5.0, 150.0, LENGTH)?;
        }
        if has("wheel_mass") && page.u.ratio(1, 2)? {
            page.key("wheel_mass", 0.1, 5.0, MASS)?;
            page.key("axis_tilt", 0.0, 90.0, ANGLE)?;
        }
        if has("belt_tension") {
            page.may("belt_tension", 10.0, 600.0, FORCE)?;
        }
        if has("pressure_angle") {
            page.key("pressure_angle", 14.5, 25.0, ANGLE)?;
            page.may("helix_angle", 0.0, 30.0, ANGLE)?;
        }
    } else if word == "ignore" {
        page.word("mechanism", word);
    }
    let may_state = word != "replace" && (keys.is_empty() || !word.is_empty());
    if may_state && (keys.is_empty() || page.u.ratio(1, 2)?) {
        forces(page)?;
    }
    page.may_number("load_factor", 1.0, 2.0)?;
    page.may_word("operating_condition", &["normal", "shock", "high_accuracy"])
}
