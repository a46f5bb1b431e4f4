//! Every fault of a project file is shown on the page: in the list with a link to its field, and at the field; a fault without a
//! field leads to its line in the text.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use crate::shell;

use questions::read_all;
use shell::{InMemory, page, whole};
use std::collections::BTreeSet;

/// Place at which a fault is shown.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum At {
    /// Field, named by its path.
    Field(&'static str),
    /// Table or list of this path.
    Table(&'static str),
    /// Line in the text.
    Text,
}
use At::{Field, Table, Text};

const HEAD: &str = "format = 1\n";
const LOAD: &str = "[load]\ninertia = \"1.3 kg m^2\"\n";
const MOVE: &str = "[[motion]]\nlaw = \"manual\"\nspeed = \"40 1/min\"\naccelerate = \"0.1 s\"\nrun = \"0.1 s\"\n\
    brake = \"0.1 s\"\npause = \"1 s\"\n";

/// A dwell, which every load accepts.
const REST: &str = "[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n";

/// Returns a project of a load and a motion.
fn with(load: &str, motion: &str) -> String {
    format!("{HEAD}{load}{motion}")
}

/// Returns a valid project with more text behind it.
fn more(rest: &str) -> String {
    format!("{HEAD}{LOAD}{MOVE}{rest}")
}

/// Returns a project with this inertia.
fn inertia(value: &str) -> String {
    with(&format!("[load]\ninertia = {value}\n"), MOVE)
}

/// Returns a project with these segments.
fn segments(segments: &[&str]) -> String {
    let all: Vec<String> = segments.iter().map(|each| format!("[[motion]]\n{each}\n")).collect();
    with(LOAD, &all.concat())
}

/// Returns a turntable with these bodies.
fn bodies(text: &str) -> String {
    with(&format!("[mechanism.turntable]\nbodies = [\"{text}\"]\n"), MOVE)
}

/// Returns a scissor lift whose first segment is a move of ten seconds.
fn lift(keys: &str) -> String {
    let lift = "[axis]\nsingle_move = true\n[mechanism.scissor_lift]\narm_length = \"700 mm\"\nlead = \"10 mm\"\narm_angle = \"20 deg\"\nmass = \"60 kg\"\n";
    with(lift, &format!("[[motion]]\nlaw = \"trapezoid\"\ntime = \"10 s\"\n{keys}\n"))
}

/// Returns a winder with a motion.
fn web(motion: &str) -> String {
    let winder = "[axis]\nsingle_move = true\n[mechanism.winder]\ncore_diameter = \"90 mm\"\nfull_diameter = \"330 mm\"\nthickness = \"2 mm\"\nwidth = \"400 mm\"\ndensity = \"900 kg/m^3\"\ntension = \"80 N\"\n";
    with(winder, motion)
}

/// A cam table up to its points.
const CAM: &str = "law = \"points\"\nspline = \"cubic\"\nends = \"rest\"\npoints = ";

/// Returns a motion from the recording in the folder.
fn recorded(more: &str) -> String {
    segments(&[&format!("law = \"recorded\"\nfile = \"run.csv\"\n{more}")])
}

#[rustfmt::skip] // one line per fault
pub(crate) fn cases() -> Vec<(&'static str, String, At)> {
    let pattern = |code: &str| {
        format!("[[curve]]\nkind = \"continuous\"\ncode = \"{code}\"\nsource = \"own\"\npoints = [[\"0 1/min\", \"10 N m\"], [\"9 1/min\", \"5 N m\"]]\n")
    };
    let bend = "[[curve]]\nkind = \"continuous\"\ncode = \"CHA-25A-50-*\"\nsource = \"own\"\npoints = ";
    vec![
        ("syntax", "format = = 1".to_owned(), Text),
        ("invisible_character", inertia("\"1.3 kg m^2\"").replace("inertia", "\u{200b}inertia"), Text),
        ("missing_key", with("[load]\n", MOVE), Field("load.inertia")),
        ("missing_key", with(LOAD, ""), Table("motion")),
        ("unknown_key", more("[requirements]\nsuply = \"560 V\"\n"), Table("requirements")),
        ("unknown_key", more("[loads]\n"), Text),
        ("key_of_another_kind", segments(&["law = \"dwell\"\ntime = \"1 s\"\nspeed = \"1 1/min\""]), Field("motion[1].speed")),
        ("missing_key", segments(&["law = \"dwell\""]), Field("motion[1].time")),
        ("cycle_and_time", segments(&["law = \"dwell\"\ntime = \"1 s\"\ncycle = \"2 s\""]), Field("motion[1].cycle")),
        ("cycle_filled_twice", segments(&["law = \"dwell\"\ncycle = \"2 s\"", "law = \"dwell\"\ncycle = \"2 s\""]), Field("motion[2].cycle")),
        ("outside_the_axes", format!("{HEAD}{LOAD}[[axis]]\nname = \"a\"\n[axis.load]\ninertia = \"1 kg m^2\"\n[[axis.motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n"), Text),
        ("axis_named_twice", HEAD.to_owned() + &"[[axis]]\nname = \"a\"\n[axis.load]\ninertia = \"1 kg m^2\"\n[[axis.motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n".repeat(2), Text),
        ("bare_number", inertia("1.3"), Field("load.inertia")),
        ("quantity_empty", inertia("\"\""), Field("load.inertia")),
        ("number_missing", inertia("\"kg m^2\""), Field("load.inertia")),
        ("number_unreadable", inertia("\"1.3.4 kg m^2\""), Field("load.inertia")),
        ("decimal_comma", inertia("\"1,3 kg m^2\""), Field("load.inertia")),
        ("not_finite", inertia("\"1e999 kg m^2\""), Field("load.inertia")),
        ("unit_missing", inertia("\"1.3\""), Field("load.inertia")),
        ("unit_of_flywheel_effect", inertia("\"5.2 kgf m^2\""), Field("load.inertia")),
        ("unit_unknown", inertia("\"1.3 kgm3\""), Field("load.inertia")),
        ("unit_of_another_quantity", inertia("\"1.3 N m\""), Field("load.inertia")),
        ("tolerance_missing", inertia("\"1.3 kg m^2 ±\""), Field("load.inertia")),
        ("tolerance_negative", inertia("\"1.3 kg m^2 ± -5 %\""), Field("load.inertia")),
        ("tolerance_of_offset_scale", more("[requirements]\nambient = \"20 degC ± 5 %\"\n"), Field("requirements.ambient")),
        ("ratio_too_small", recorded("recorded_ratio = { position = 0.0 }"), Field("motion[1].recorded_ratio.position")),
        ("number_out_of_range", more("[bearing]\nload_factor = 9.0\n"), Field("bearing.load_factor")),
        ("quantity_out_of_range", inertia("\"-1 kg m^2\""), Field("load.inertia")),
        ("below_absolute_zero", more("[requirements]\nambient = \"-300 degC\"\n"), Field("requirements.ambient")),
        ("implausible", inertia("\"1e30 kg m^2\""), Field("load.inertia")),
        ("text_too_long", more(&format!("[axis]\nname = \"{}\"\n", "x".repeat(5000))), Field("axis.name")),
        ("control_character", more("[axis]\nname = \"a\\u0007b\"\n"), Field("axis.name")),
        ("wrong_type", inertia("true"), Field("load.inertia")),
        ("wrong_type", with("load = 5\n", MOVE), Table("mechanism")),
        ("not_a_choice", segments(&["law = \"sprint\"\ntime = \"1 s\""]), Field("motion[1].law")),
        ("not_a_choice", more("[requirements]\nfeedback = [\"X\"]\n"), Field("requirements.feedback")),
        ("empty_list", more("[requirements]\nfeedback = []\n"), Field("requirements.feedback")),
        ("no_price", more("[requirements]\nprice_max = \"1.500 EUR\"\n"), Field("requirements.price_max")),
        ("unknown_maker", more("[requirements]\nmakers = [\"Nobody\"]\n"), Field("requirements.makers")),
        ("not_a_row", more(&format!("{bend}[[\"0 1/min\"]]\n")), Field("curve[1].points")),
        ("ratio_count", more("[stage]\nkind = \"belt\"\nratios = []\n"), Field("stage.ratios")),
        ("ratio_and_ratios", more("[stage]\nkind = \"belt\"\nratio = 2.0\nratios = [2.0, 3.0]\n"), Field("stage.ratios")),
        ("no_ratio_in_a_coupling", more("[stage]\nkind = \"coupling\"\nratio = 2.0\n"), Field("stage.ratio")),
        ("tolerance_end", inertia("\"1.3 kg m^2 ± 200 %\""), Field("load.inertia")),
        ("code_unknown_token", more(&pattern("XYZ")), Field("curve[1].code")),
        ("no_such_code", more(&pattern("CHA-14A-160-*")), Field("curve[1].code")),
        ("curve_too_few_points", more(&format!("{bend}[[\"0 1/min\", \"10 N m\"]]\n")), Field("curve[1].points")),
        ("curve_not_from_standstill", more(&format!("{bend}[[\"5 1/min\", \"10 N m\"], [\"9 1/min\", \"5 N m\"]]\n")), Field("curve[1].points")),
        ("curve_speeds_not_ascending", more(&format!("{bend}[[\"0 1/min\", \"10 N m\"], [\"9 1/min\", \"5 N m\"], [\"8 1/min\", \"5 N m\"]]\n")), Field("curve[1].points")),
        ("no_mechanism", with("", MOVE), Table("mechanism")),
        ("too_many_mechanisms", with("[mechanism.belt]\npulley_diameter = \"1 m\"\nmass = \"1 kg\"\n[mechanism.screw]\nlead = \"1 mm\"\nmass = \"1 kg\"\n", MOVE), Table("mechanism")),
        ("rod_too_short", with("[mechanism.slider_crank]\ncrank = \"60 mm\"\nrod = \"50 mm\"\nmass = \"1 kg\"\n", MOVE), Field("mechanism.slider_crank.rod")),
        ("full_below_core", with("[mechanism.winder]\nwinding = \"up\"\ncore_diameter = \"90 mm\"\nfull_diameter = \"80 mm\"\nstart_diameter = \"90 mm\"\nthickness = \"1 mm\"\nwidth = \"1 m\"\ndensity = \"900 kg/m^3\"\ntension = \"9 N\"\n", REST), Field("mechanism.winder.full_diameter")),
        ("no_flange_loads", more("[bearing]\nmechanism = \"add\"\n"), Field("bearing.mechanism")),
        ("motion_without_duration", segments(&["law = \"dwell\"\ntime = \"0 s\""]), Table("motion")),
        ("move_not_determined", segments(&["law = \"trapezoid\"\ndistance = \"90 deg\""]), Table("motion")),
        ("still_moving", segments(&["law = \"constant\"\nspeed = \"5 1/min\"\ntime = \"1 s\"", "law = \"dwell\"\ntime = \"1 s\""]), Table("motion")),
        ("no_time_to_change_speed", segments(&["law = \"manual\"\nspeed = \"5 1/min\"\naccelerate = \"0 s\"\nrun = \"1 s\"\nbrake = \"1 s\"\npause = \"1 s\""]), Table("motion")),
        ("move_speed_too_low", segments(&["law = \"trapezoid\"\ndistance = \"90 deg\"\nspeed = \"1 1/min\"\ntime = \"0.1 s\""]), Table("motion")),
        ("points_too_few", segments(&[&format!("{CAM}[]")]), Field("motion[1].points")),
        ("points_not_increasing", segments(&[&format!("{CAM}[[\"0 s\", \"0 deg\"], [\"0 s\", \"1 deg\"]]")]), Field("motion[1].points")),
        ("supply_and_mains", with(LOAD, &format!("{MOVE}[requirements]\nsupply = \"560 V\"\nmains = \"400 V\"\n")), Field("requirements.mains")),
        ("wrong_order", with(LOAD, &format!("{MOVE}[requirements]\nhumidity_min = 0.6\nhumidity_max = 0.5\n")), Field("requirements.humidity_min")),
        ("wrong_order", with(LOAD, &format!("{MOVE}[drive]\ncurrent_continuous = \"6 A\"\ncurrent_peak = \"3 A\"\n")), Field("drive.current_continuous")),
        ("only_beside", with(LOAD, &format!("{MOVE}[requirements]\ndeviation_max = \"0.2 mm\"\n")), Field("requirements.deviation_max")),
        ("unlike_first_point", segments(&[&format!("{CAM}[[\"0 s\", \"0 deg\"], [\"9 deg\", \"1 deg\"]]")]), Field("motion[1].points")),
        ("master_of_times", segments(&[&format!("master_speed = \"9 1/min\"\n{CAM}[[\"0 s\", \"0 deg\"], [\"1 s\", \"1 deg\"]]")]), Field("motion[1].master_speed")),
        ("points_speed_jumps", segments(&["law = \"dwell\"\ntime = \"1 s\"", "law = \"points\"\nspline = \"cubic\"\nends = \"natural\"\npoints = [[\"0 s\", \"0 deg\"], [\"1 s\", \"1 deg\"]]"]), Field("motion[2].points")),
        ("without_effect", more("[bearing]\noverhang = \"5 mm\"\n"), Field("bearing.overhang")),
        ("belt_or_teeth", with("[mechanism.belt]\npulley_diameter = \"0.1 m\"\nmass = \"1 kg\"\n", &format!("{}[bearing]\nmechanism = \"add\"\nbelt_tension = \"5 N\"\npressure_angle = \"20 deg\"\n", REST)), Field("bearing.pressure_angle")),
        ("body_axis", bodies("disc diameter=1m length=1mm mass=1kg axis=up"), Field("mechanism.turntable.bodies")),
        ("body_distance_out_of_range", bodies("point mass=1kg distance=-1m"), Field("mechanism.turntable.bodies")),
        ("body_density_out_of_range", bodies("sphere diameter=1m density=0kg/m^3"), Field("mechanism.turntable.bodies")),
        ("code_repeated", more(&pattern("CHA-CHA-25A")), Field("curve[1].code")),
        ("code_empty_part", more(&pattern("CHA--25A")), Field("curve[1].code")),
        ("code_out_of_order", more(&pattern("CHA-50-25A")), Field("curve[1].code")),
        ("curve_torque_out_of_range", more(&format!("{bend}[[\"0 1/min\", \"-10 N m\"], [\"9 1/min\", \"5 N m\"]]\n")), Field("curve[1].points")),
        ("file_out_of_reach", segments(&["law = \"recorded\"\nfile = \"../x.csv\""]), Field("motion[1].file")),
        ("no_line", segments(&["law = \"trapezoid\"\ndistance = \"90 mm\"\ntime = \"1 s\""]), Field("motion[1].distance")),
        ("stroke_beyond", lift("distance = \"900 mm\""), Field("motion[1].distance")),
        ("stroke_from_unknown", lift("speed = \"20 1/min\"\n[[motion]]\nlaw = \"trapezoid\"\ndistance = \"9 mm\"\ntime = \"1 s\""), Field("motion[2].distance")),
        ("key_of_another_kind", with("[mechanism.arm]\nshape = \"rod\"\nlength = \"1 m\"\nmass = \"1 kg\"\ninertia = \"1 kg m^2\"\n", REST), Field("mechanism.arm.inertia")),
        ("key_of_another_kind", with("[mechanism.arm]\nshape = \"taper\"\nlength = \"1 m\"\nwidth = \"9 cm\"\nmass = \"1 kg\"\n", REST), Field("mechanism.arm.width")),
        ("no_web", segments(&["law = \"web\"\nspeed = \"20 m/min\""]), Field("motion[1].law")),
        ("web_not_alone", web("[[motion]]\nlaw = \"web\"\nspeed = \"20 m/min\"\n[[motion]]\nlaw = \"constant\"\nspeed = \"1 1/min\"\ntime = \"1 s\"\n"), Field("motion[2].law")),
        ("web_speed", web("[[motion]]\nlaw = \"web\"\nspeed = \"20 1/min\"\n"), Field("motion[1].speed")),
        ("web_too_short", web("[[motion]]\nlaw = \"web\"\nspeed = \"900 m/min\"\n"), Field("motion[1].speed")),
        ("no_column_with_ratio", segments(&["law = \"recorded\"\nfile = \"motor.csv\"\nrecorded_ratio = { speed = 80, torque = 80 }"]), Field("motion[1].recorded_ratio.torque")),
        ("recorded_at_the_motor", segments(&["law = \"recorded\"\nfile = \"motor.csv\""]), Field("motion[1].file")),
        ("unknown_unit", recorded("[motion.units]\nposition = \"furlong\""), Field("motion[1].units.position")),
        ("time_stamps_uneven", segments(&["law = \"recorded\"\nfile = \"uneven.csv\"\ntime_stamps = \"even\""]), Field("motion[1].time_stamps")),
        ("file_unreadable", segments(&["law = \"recorded\"\nfile = \"none.csv\""]), Field("motion[1].file")),
        ("recording_time_missing", recorded(""), Field("motion[1].file")),
        ("body_missing", bodies(""), Field("mechanism.turntable.bodies")),
        ("shape_missing", bodies("mass=1kg"), Field("mechanism.turntable.bodies")),
        ("no_shape", bodies("blob mass=1kg"), Field("mechanism.turntable.bodies")),
        ("no_key", bodies("disc wide"), Field("mechanism.turntable.bodies")),
        ("key_of_another_shape", bodies("disc diameter=1m length=1mm mass=1kg inner=2mm"), Field("mechanism.turntable.bodies")),
        ("given_twice", bodies("disc diameter=1m diameter=2m length=1mm mass=1kg"), Field("mechanism.turntable.bodies")),
        ("count", bodies("disc diameter=1m length=1mm mass=1kg count=x"), Field("mechanism.turntable.bodies")),
        ("body_without_mass", bodies("disc diameter=1m length=1mm"), Field("mechanism.turntable.bodies")),
        ("body_mass_and_density", bodies("disc diameter=1m length=1mm mass=1kg density=1kg/m^3"), Field("mechanism.turntable.bodies")),
        ("body_dimension_out_of_range", bodies("disc diameter=0m length=1mm mass=1kg"), Field("mechanism.turntable.bodies")),
        ("body_dimension_missing", bodies("disc diameter=1m density=7850kg/m^3"), Field("mechanism.turntable.bodies")),
        ("body_inner_not_below_outer", bodies("tube outer=10mm inner=20mm length=1mm mass=1kg"), Field("mechanism.turntable.bodies")),
        ("body_without_volume", bodies("point density=1kg/m^3"), Field("mechanism.turntable.bodies")),
        ("body_mass_out_of_range", bodies("point mass=0kg"), Field("mechanism.turntable.bodies")),
        ("body_no_piece", bodies("point mass=1kg count=0"), Field("mechanism.turntable.bodies")),
    ]
}

/// Returns a recording of a swing whose rows are first 1 ms, then 3 ms apart.
fn uneven() -> Vec<u8> {
    let mut text = "t [s],q [deg]\n".to_owned();
    let mut time = 0.0;
    for k in 0..400 {
        let position = 30.0 * (1.0 - (time * std::f64::consts::TAU / 0.8_f64).cos());
        text.push_str(&format!("{time:.4},{position:.6}\n"));
        time += if k < 200 { 1e-3 } else { 3e-3 };
    }
    text.into_bytes()
}

fn element(path: &str) -> String {
    let sign = |sign: char| if sign.is_ascii_alphanumeric() || sign == '_' { sign } else { '-' };
    format!("f-{}", path.chars().map(sign).collect::<String>())
}

/// Returns the text of HTML for readers; quotations of the file stand between grave accents in a message, and a key is shown by its
/// label, which names the key.
fn plain(html: &str) -> String {
    let mut text = String::new();
    for (place, part) in html.split("<em data-key=\"").enumerate() {
        match part.split_once("</em>").filter(|_| place > 0) {
            Some((label, rest)) => {
                text.push_str(&format!("`{}`{rest}", label.split_once('"').map_or("", |(key, _)| key)));
            }
            None => text.push_str(part),
        }
    }
    text.replace("<code>", "`")
        .replace("</code>", "`")
        .replace("&lt;", "<")
        .replace("&gt;", ">")
        .replace("&quot;", "\"")
        .replace("&amp;", "&")
}

/// Returns the longest part of a message without a line or a table of the file, which the page says in its own words.
fn without_lines(message: &str) -> String {
    if ![" = ", "[[", " [", "`["].iter().any(|sign| message.contains(sign)) {
        return message.to_owned();
    }
    let parts: Vec<&str> = message.split(['=', '[', ']', '{', '}', '"']).collect();
    let longest = parts.iter().max_by_key(|part| part.len()).copied().unwrap_or_default().trim();
    // The words next to the cut belong to the line.
    let words: Vec<&str> = longest.split(' ').collect();
    words.get(1..words.len() - 1).unwrap_or_default().join(" ")
}

#[test]
fn every_fault_has_its_place_in_the_page() {
    let folder = InMemory::default();
    let _ = folder.0.borrow_mut().insert("run.csv".to_owned(), b"q [deg]\n0\n1\n".to_vec());
    let motor = b"t [s],q [deg],r0061[0]: Speed actual value [1/min]\n0,0,0\n1,1,40\n2,2,0\n";
    let _ = folder.0.borrow_mut().insert("motor.csv".to_owned(), motor.to_vec());
    let _ = folder.0.borrow_mut().insert("uneven.csv".to_owned(), uneven());
    let good = more("");
    let mut wrong = Vec::new();
    for (id, text, at) in cases() {
        let found = read_all(&text, &folder).err().unwrap_or_default();
        let Some(fault) = found.iter().find(|fault| fault.fault.id() == id) else {
            wrong.push(format!("{id}: has {:?}", found.iter().map(|fault| fault.fault.id()).collect::<Vec<_>>()));
            continue;
        };
        // The page names the choice in place of the tables of the file.
        let message = match id {
            "no_mechanism" => words::incoming::load_missing(quantities::Language::En).to_owned(),
            _ => words::fault_text(&fault.fault, quantities::Language::En),
        };
        let message = without_lines(&message);
        let html = page(&folder.post("/work", &[("text", &text), ("good", &good)]));
        whole(&html);
        let list = html.split("id=\"faults\"").nth(1).unwrap().split("id=\"stopped\"").next().unwrap();
        let line = list.split("<li>").find(|line| plain(line).contains(&message)).unwrap_or_default();
        let leads = |to: &str| line.contains(&format!("href=\"#{to}\""));
        let stands = |after: &str, until: &str| {
            let part = html.split(after).nth(1).unwrap_or_default();
            plain(&part[..part.find(until).unwrap_or(part.len())]).contains(&message)
        };
        let is_shown = match at {
            Field(path) => {
                let id = element(path);
                leads(&id) && stands(&format!("id=\"{id}-x\""), "</div>")
            }
            Table(path) => {
                let id = element(path);
                let id = if path == "mechanism" { path.to_owned() } else { id };
                line.contains(&format!("href=\"#{id}")) && plain(&html).matches(&*message).count() >= 2
            }
            Text => line.contains("href=\"#text\"") && line.contains(&format!("data-line=\"{}\"", fault.line)),
        };
        if !is_shown {
            wrong.push(format!("{id} at {at:?}: {line}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// A fault in the load, in the motion or in the requirements leaves the other faults of the file in the list, but for those that
/// only a whole load has: the end of its cycle and its loads on the flange.
#[test]
fn no_fault_hides_another() {
    let folder = InMemory::default();
    let _ = folder.0.borrow_mut().insert("run.csv".to_owned(), b"q [deg]\n0\n1\n".to_vec());
    let motor = b"t [s],q [deg],r0061[0]: Speed actual value [1/min]\n0,0,0\n1,1,40\n2,2,0\n";
    let _ = folder.0.borrow_mut().insert("motor.csv".to_owned(), motor.to_vec());
    let _ = folder.0.borrow_mut().insert("uneven.csv".to_owned(), uneven());
    let of_a_whole_load = ["no_flange_loads", "without_effect"];
    let ids = |text: &str| -> Vec<String> {
        let found = read_all(text, &folder).err().unwrap_or_default();
        found.iter().map(|fault| fault.fault.id().to_owned()).collect()
    };
    let mut wrong = Vec::new();
    let mut tried = 0;
    for (id, text, _) in cases().into_iter().filter(|(id, ..)| *id != "syntax") {
        let in_the_load = text.replace("inertia = \"1.3 kg m^2\"\n", "inertia = \"1.3 kg\"\n");
        let in_the_motion = format!("{text}[[motion]]\nlaw = \"manual\"\nspeed = \"5 1/min\"\n");
        let in_the_requirements = match text.contains("[requirements]\n") {
            true => text.replace("[requirements]\n", "[requirements]\naltitude_derating = 0.9\n"),
            false => format!("{text}[requirements]\naltitude_derating = 0.9\n"),
        };
        let more: [(&str, &str, &str); 3] = [
            ("unit_of_another_quantity", &in_the_load, "load"),
            ("missing_key", &in_the_motion, "motion"),
            ("only_beside", &in_the_requirements, "requirements"),
        ];
        // A recording that cannot be read, before and behind the segments of the case, itself with a second fault.
        let recordings = [
            ("file_unreadable", "file = \"missing.csv\"\nsmoothing = \"20 N m\""),
            (
                "recording_column_unknown",
                "file = \"motor.csv\"\ncolumns = { position = \"x\" }\nstandstill = \"20 N m\"",
            ),
            ("recording_window_reversed", "file = \"motor.csv\"\nfrom = \"2 s\"\nto = \"1 s\"\npayload = \"20 N m\""),
            ("file_unreadable", "file = \"missing.csv\"\n[motion.units]\nposition = \"20 N m\""),
        ];
        let recordings = recordings.map(|(other, keys)| (other, format!("[[motion]]\nlaw = \"recorded\"\n{keys}\n")));
        let around = recordings.iter().flat_map(|(other, segment)| {
            let before = text.replacen("[[motion]]\n", &format!("{segment}[[motion]]\n"), 1);
            let behind = if before == text { text.clone() } else { format!("{text}{segment}") };
            [(*other, before, "motion"), (*other, behind, "motion")]
        });
        let around: Vec<(&str, String, &str)> = around.collect();
        let more = more.into_iter().chain(around.iter().map(|(other, text, part)| (*other, text.as_str(), *part)));
        for (other, with_both, part) in more {
            let second =
                if with_both.contains("position = \"20 N m\"") { "unknown_unit" } else { "unit_of_another_quantity" };
            let is_recorded = with_both.contains("\"20 N m\"");
            // A table outside the axes holds no values of an axis; the duration is one of all segments.
            let of_the_whole = match part {
                "load" => of_a_whole_load.contains(&id),
                "motion" => id == "motion_without_duration",
                _ => id == "outside_the_axes" || id == "axis_named_twice",
            };
            if with_both == text || of_the_whole {
                continue;
            }
            tried += 1;
            let found = ids(with_both);
            let both = |each: &str| found.iter().filter(|id| *id == each).count();
            let expected = |each: &str| {
                [id, other].iter().filter(|known| **known == each).count() + usize::from(is_recorded && each == second)
            };
            let is_kept =
                [id, other, if is_recorded { second } else { other }].iter().all(|each| both(each) >= expected(each));
            if !is_kept {
                wrong.push(format!("{id} and {other} in the {part}: {found:?}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{} of {tried}\n{}", wrong.len(), wrong.join("\n"));
    assert!(tried > 800, "{tried}");
}

#[test]
fn the_faults_of_another_axis_lead_there() {
    let axis = |name: &str, inertia: &str| {
        format!(
            "[[axis]]\nname = \"{name}\"\n[axis.load]\ninertia = {inertia}\n[[axis.motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n"
        )
    };
    let good = format!("{HEAD}{}{}", axis("a", "\"1 kg m^2\""), axis("b", "\"1 kg m^2\""));
    let text = format!("{HEAD}{}{}", axis("a", "\"1 kg m^2\""), axis("b", "\"1\""));
    let folder = InMemory::default();
    let html = page(&folder.post("/work", &[("text", &text), ("good", &good)]));
    let list = html.split("id=\"faults\"").nth(1).unwrap().split("id=\"stopped\"").next().unwrap();
    assert!(plain(list).contains("{\"axis\":\"1\",\"code\":\"\"}"), "{list}");
    let there = page(&folder.post("/work", &[("text", &text), ("good", &good), ("axis", "1")]));
    assert!(there.contains("id=\"f-axis-2--load-inertia-x\""), "{there}");
}

/// The cases name every kind of fault, those apart that stand where another of their kind does, by the same lines of the reader.
#[test]
fn no_kind_of_fault_is_forgotten() {
    let source = concat!(
        include_str!("../../../project/src/fault.rs"),
        include_str!("../../../project/src/ids.rs"),
        include_str!("../../../axis/src/fault.rs"),
        include_str!("../../../axis/src/ids.rs")
    );
    let all: BTreeSet<&str> = source
        .lines()
        .filter_map(|line| line.split("=> \"").nth(1)?.split('"').next())
        .filter(|id| id.bytes().all(|byte| byte == b'_' || byte.is_ascii_lowercase()))
        .collect();
    assert!(all.len() > 100, "{all:?}");
    let tried: BTreeSet<&str> = cases().iter().map(|(id, ..)| *id).collect();
    // At the file of its segment.
    let of_file = |id: &str| id.starts_with("recording_") || id.starts_with("samples_") || id.starts_with("smoothing_");
    let left: Vec<&str> =
        all.difference(&tried).copied().filter(|id| !of_file(id) && !ELSEWHERE.contains(id)).collect();
    assert!(left.is_empty(), "{left:?}");
    let none: Vec<&str> = ELSEWHERE.iter().copied().filter(|id| !all.contains(id) || tried.contains(id)).collect();
    assert!(none.is_empty(), "{none:?}");
}

/// Faults that stand where another stands that is tried, by the same lines of the reader, or that only other questions have.
#[rustfmt::skip] // one line per place
const ELSEWHERE: [&str; 43] = [
    // At the segment or its file.
    "end_speed_above_limit", "move_acceleration_too_low", "move_out_of_range", "move_speed_too_high", "rest_to_rest_only",
    "speed_not_closed", "position_not_closed", "motion_empty", "beyond_range", "position_and_speed_contradict", "joint_without_torque",
    "too_many_instants", "cycle_too_short",
    // At the bodies.
    "bodies_twice", "body_angle_not_finite", "body_beyond_numbers",
    // At the pattern of codes.
    "code_ambiguous", "code_missing", "code_empty", "code_too_long",
    // At the points of a table.
    "table_negative_inertia", "table_positions_not_ascending", "table_too_few_points",
    // At the key of the loads on the flange.
    "replaces_everything", "tooth_angle", "flange_loads_undecided",
    // At a quantity with a tolerance, or in the text.
    "impossible_within_tolerance", "no_tolerance", "too_many_tolerances", "too_many_entries", "more_faults", "reading_stopped", "file_too_large",
    // At the points of a cam table; a number that is not finite is refused where it is read.
    "points_not_finite", "points_uneven",
    // At the names of catalogue files.
    "catalogue_without_products", "nothing_offered", "product_named_as_code", "product_named_twice", "product_of_two_files",
    // Faults that no project file on the page can have.
    "battery_operation_out_of_range", "battery_storage_out_of_range", "one_axis_only",
];
