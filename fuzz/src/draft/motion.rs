//! Motion of a generated project: moves that close the cycle, suited to the load.

use super::load::{LoadKind, forces};
use super::page::{
    ACCELERATION, ANGLE, INERTIA, JERK, LENGTH, MASS, Page, SPEED, TIME, TORQUE, UnitSpellings, WAY_ACCELERATION,
    WAY_JERK, WAY_SPEED,
};
use arbitrary::Result;

/// Distance in rad or m, with the units in which it and its rates are written.
struct Way {
    /// Units of a distance, and the number of them per rad or m.
    distance: (UnitSpellings, f64),
    speed: (UnitSpellings, f64),
    acceleration: UnitSpellings,
    jerk: UnitSpellings,
    most: f64,
}

const TURN: Way = Way {
    distance: (ANGLE, 57.295_779_513_082_32),
    speed: (SPEED, 9.549_296_585_513_72),
    acceleration: ACCELERATION,
    jerk: JERK,
    most: 2.5,
};

const LINE: Way =
    Way { distance: (LENGTH, 1e3), speed: (WAY_SPEED, 1.0), acceleration: WAY_ACCELERATION, jerk: WAY_JERK, most: 0.8 };

const LAWS: [&str; 10] = [
    "trapezoid",
    "triangle",
    "jerk",
    "polynomial_5",
    "modified_sine",
    "modified_trapezoid",
    "simple_sine",
    "inclined_sine",
    "parabola",
    "open",
];

pub(super) fn motions(page: &mut Page<'_, '_>, load: LoadKind, single: bool) -> Result<()> {
    let way = if matches!(load, LoadKind::Line | LoadKind::Belt) { LINE } else { TURN };
    let endless = matches!(load, LoadKind::Free | LoadKind::Belt);
    match page.u.int_in_range(0..=7)? {
        0 | 1 if load == LoadKind::Winder => web(page),
        0 if endless => constant(page, &way),
        1 => manual(page, &way, load, single),
        2 => through(page, &way, endless || single),
        _ => moves(page, &way, endless || single),
    }
}

/// Writes a run of the web of a winder, and a rest.
fn web(page: &mut Page<'_, '_>) -> Result<()> {
    page.row("motion");
    page.word("law", "web");
    page.key("speed", 1.0, 600.0, &[("m/min", 1.0), ("m/s", 1.0 / 60.0)])?;
    page.may("accelerate", 0.1, 30.0, TIME)?;
    page.may("brake", 0.1, 30.0, TIME)?;
    if page.often()? { dwell(page) } else { Ok(()) }
}

/// Writes moves with rests between them; back and forth for a bound load.
fn moves(page: &mut Page<'_, '_>, way: &Way, one_way: bool) -> Result<()> {
    for _ in 0..page.u.int_in_range(1..=2)? {
        let distance = page.between(way.most * 0.02, way.most)?;
        let written = page.literal(distance * way.distance.1, way.distance.0)?;
        one(page, way, &written, distance)?;
        if !one_way || page.u.ratio(1, 3)? {
            one(page, way, &format!("-{written}"), distance)?;
        }
    }
    Ok(())
}

/// Writes one move, given by its defining values, and a rest after it.
fn one(page: &mut Page<'_, '_>, way: &Way, written: &str, distance: f64) -> Result<()> {
    let law = *page.u.choose(&LAWS)?;
    page.row("motion");
    page.word("law", law);
    page.word("distance", written);
    let time = page.between(0.08, 3.0)?;
    // For a trapezoid with equal thirds; approximate for the other laws.
    let speed = distance / time * page.between(1.4, 1.9)?;
    let acceleration = distance / (time * time) * page.between(4.5, 9.0)?;
    match (law, page.u.int_in_range(0..=3)?) {
        ("jerk", _) => {
            page.exactly("speed", speed * way.speed.1, way.speed.0)?;
            page.exactly("acceleration", acceleration, way.acceleration)?;
            page.exactly("jerk", acceleration / time * 20.0, way.jerk)?;
        }
        ("trapezoid", 0) => {
            page.exactly("time", time, TIME)?;
            page.exactly("speed", speed * way.speed.1, way.speed.0)?;
        }
        ("trapezoid", 1) => {
            page.exactly("time", time, TIME)?;
            page.exactly("acceleration", acceleration, way.acceleration)?;
        }
        ("trapezoid", _) => {
            page.exactly("speed", speed * way.speed.1, way.speed.0)?;
            page.exactly("acceleration", acceleration, way.acceleration)?;
        }
        (_, 0) => page.exactly("speed", speed * way.speed.1, way.speed.0)?,
        (_, 1) => page.exactly("acceleration", acceleration, way.acceleration)?,
        _ => page.exactly("time", time, TIME)?,
    }
    carried(page)?;
    if page.often()? { dwell(page) } else { Ok(()) }
}

fn dwell(page: &mut Page<'_, '_>) -> Result<()> {
    page.row("motion");
    page.word("law", "dwell");
    // A cycle that the other segments leave room for.
    if !page.text.contains("\ncycle = ") && page.seldom()? {
        page.key("cycle", 2_000.0, 9_000.0, TIME)?;
    } else {
        page.key("time", 0.05, 20.0, TIME)?;
    }
    page.may_word("hold", &["motor", "brake", "free"])
}

fn constant(page: &mut Page<'_, '_>, way: &Way) -> Result<()> {
    page.row("motion");
    page.word("law", "constant");
    let speed = page.between(0.02, 4.0)?;
    page.exactly("speed", speed * way.speed.1, way.speed.0)?;
    page.key("time", 0.1, 30.0, TIME)?;
    carried(page)
}

/// Writes an acceleration to a speed, a run at it and a deceleration as three segments; then the same way back.
fn through(page: &mut Page<'_, '_>, way: &Way, one_way: bool) -> Result<()> {
    let (reach, time) = (page.between(way.most * 0.1, way.most)?, page.between(0.1, 1.0)?);
    let law = *page.u.choose(&["polynomial_5", "trapezoid"])?;
    let speed = page.literal(reach / time * way.speed.1, way.speed.0)?;
    let ramp = page.literal(0.5 * reach * way.distance.1, way.distance.0)?;
    let (time, second) = (page.literal(time, TIME)?, page.literal(time, TIME)?);
    let acceleration = page.literal(reach / (time_of(&time) * time_of(&time)) * 1.2, way.acceleration)?;
    for sign in ["", "-"].into_iter().take(if one_way { 1 } else { 2 }) {
        for end in [Some(&speed), None] {
            page.row("motion");
            page.word("law", law);
            page.word("distance", &format!("{sign}{ramp}"));
            if law == "trapezoid" {
                page.word("acceleration", &acceleration)
            } else {
                page.word("time", &time)
            }
            if let Some(end) = end {
                page.word("end_speed", &format!("{sign}{end}"));
                page.row("motion");
                page.word("law", "constant");
                page.word("speed", &format!("{sign}{end}"));
                page.word("time", &second);
            }
        }
    }
    dwell(page)
}

/// Returns the seconds of a time as written.
fn time_of(text: &str) -> f64 {
    let (number, unit) = text.split_once(' ').unwrap_or((text, "s"));
    let seconds: f64 = number.parse().unwrap_or(1.0);
    if unit == "ms" { seconds * 1e-3 } else { seconds }
}

/// Writes the manual's cycle; back and forth for a bound load.
fn manual(page: &mut Page<'_, '_>, way: &Way, load: LoadKind, single: bool) -> Result<()> {
    let speed = page.between(0.1, 4.0)? * if load == LoadKind::Line { 0.1 } else { 1.0 };
    let speed = page.literal(speed * way.speed.1, way.speed.0)?;
    let mut times = Vec::new();
    for key in ["accelerate", "run", "brake"] {
        let time = page.between(0.02, 0.4)?;
        times.push((key, page.literal(time, TIME)?));
    }
    let back = matches!(load, LoadKind::Line | LoadKind::Bound | LoadKind::Winder);
    for sign in ["", "-"].into_iter().take(if back && !single { 2 } else { 1 }) {
        page.row("motion");
        page.word("law", "manual");
        page.word("speed", &format!("{sign}{speed}"));
        times.iter().for_each(|(key, time)| page.word(key, time));
        page.key("pause", 0.02, 5.0, TIME)?;
        carried(page)?;
    }
    Ok(())
}

/// Writes a payload of a segment, and its own loads at the flange.
fn carried(page: &mut Page<'_, '_>) -> Result<()> {
    if page.u.ratio(1, 8)? {
        page.key("payload_inertia", 1e-3, 2.0, INERTIA)?;
    }
    // A payload needs a position: along a line, or at a distance from the axis.
    if ["payload_distance", "screw", "mechanism.belt", "conveyor", "hoist", "scissor_lift"]
        .iter()
        .any(|word| page.text.contains(word))
        && page.u.ratio(1, 8)?
    {
        page.key("payload", 0.05, 8.0, MASS)?;
    }
    if page.u.ratio(1, 10)? {
        page.key("process_torque", -20.0, 20.0, TORQUE)?;
    }
    if page.u.ratio(1, 12)? {
        page.table("motion.bearing");
        forces(page)?;
    }
    Ok(())
}
