//! A recording from outside: shown before it is used, written as chosen, and refused with a sentence.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use crate::shell;

use project::written;
use shell::{InMemory, page, whole};
use std::collections::BTreeMap;

const PREVIEW: &str = "/recording/preview";
const LOAD: &str = "format = 1\n[axis]\nsingle_move = true\n[load]\ninertia = \"0.9 kg m^2\"\nfriction_torque = \"2 N m\"\n[[motion]]\nlaw = \"trapezoid\"\ndistance = \"90 deg\"\ntime = \"1 s\"\n[requirements]\nsupply = \"560 V\"\n";
const TWO: &str = "format = 1\n[[axis]]\nname = \"a\"\n[axis.load]\ninertia = \"1 kg m^2\"\n[[axis.motion]]\nlaw = \"trapezoid\"\ndistance = \"90 deg\"\ntime = \"1 s\"\n[[axis]]\nname = \"b\"\n[axis.load]\ninertia = \"2 kg m^2\"\n[[axis.motion]]\nlaw = \"trapezoid\"\ndistance = \"30 deg\"\ntime = \"1 s\"\n";

/// Returns a swing to and fro with rows every `step_ms`, its columns with these headings; positions are rounded to `grid`.
fn swing(rows: u32, step_ms: f64, headings: &str, grid: f64) -> String {
    let period = f64::from(rows - 1) * step_ms;
    let row = |index: u32| {
        let t = f64::from(index) * step_ms;
        let phase = std::f64::consts::TAU * t / period;
        let position = 40.0 * (1.0 - phase.cos());
        format!("{t},{:.7},{:.5}\n", grid * (position / grid).round(), 3.0 * phase.sin())
    };
    std::iter::once(format!("{headings}\n")).chain((0..rows).map(row)).collect()
}

fn keys(text: &str) -> BTreeMap<String, String> {
    written(text).unwrap().into_iter().filter_map(|key| Some((key.path, key.value?))).collect()
}

fn preview(folder: &InMemory, fields: &[(&str, &str)], file: &[u8]) -> String {
    let reply = folder.post_file(PREVIEW, fields, file);
    let html = page(&reply);
    whole(&html);
    // The picture is long, and no part of what is asserted.
    let pieces = html.split("<svg").map(|piece| piece.split_once("</svg>").map_or(piece, |(_, behind)| behind));
    pieces.collect()
}

fn is_usable(html: &str) -> bool {
    let button = html.split("id=\"incoming-use\"").nth(1).unwrap_or_else(|| panic!("{html}"));
    !button.split('>').next().unwrap().contains("disabled")
}

/// The project holds what it held, and of the recording only what was chosen; nothing is kept before it is used.
#[test]
fn the_project_contains_only_what_was_chosen() {
    let file = swing(400, 2.0, "t [ms],q [deg],M [N m]", 0.01);
    let bases = [("", "0", ""), (LOAD, "0", ""), (TWO, "1", "axis[2].")];
    for (base, axis, prefix) in bases {
        for torque in ["whole", "process", "unused"] {
            for place in ["replaced", "added"] {
                for (smoothing, once) in [("", ""), ("20 ms", "true")] {
                    let folder = InMemory::default();
                    let fields = [
                        ("text", base),
                        ("axis", axis),
                        ("name", "run.csv"),
                        ("torque", torque),
                        ("place", place),
                        ("smoothing", smoothing),
                        ("once", once),
                    ];
                    let html = preview(&folder, &fields, file.as_bytes());
                    assert!(is_usable(&html) && folder.0.borrow().is_empty(), "{html}");
                    let reply = folder.post_file("/recording", &fields, file.as_bytes());
                    let text = page(&reply);
                    assert_eq!(folder.0.borrow()["run.csv"], file.as_bytes());
                    let count = u32::from(!base.is_empty() && place == "added");
                    let segment = format!("{prefix}motion[{}]", count + 1);
                    let mut expected = if base.is_empty() {
                        BTreeMap::from([("format".to_owned(), "1".to_owned())])
                    } else {
                        keys(base)
                    };
                    let of = |path: &str, inside: &str| path.starts_with(&format!("{prefix}{inside}"));
                    if place == "replaced" {
                        expected.retain(|path, _| !of(path, "motion["));
                    }
                    let inertia = expected.get(&format!("{prefix}load.inertia")).cloned();
                    if torque == "whole" {
                        expected.retain(|path, _| !of(path, "load."));
                    }
                    let mut add = |path: String, value: &str| {
                        let _ = expected.insert(path, value.to_owned());
                    };
                    // The recorded torque contains that of the inertia, which decides about the drive all the same.
                    if let Some(inertia) = inertia.filter(|_| torque == "whole") {
                        add(format!("{prefix}mechanism.joint.inertia"), &inertia);
                    }
                    add(format!("{segment}.law"), "recorded");
                    add(format!("{segment}.file"), "run.csv");
                    if torque == "unused" {
                        add(format!("{segment}.columns.torque"), "none");
                    }
                    if !smoothing.is_empty() {
                        add(format!("{segment}.smoothing"), smoothing);
                        add(format!("{prefix}{}single_move", if prefix.is_empty() { "axis." } else { "" }), "true");
                    }
                    assert_eq!(keys(&text), expected, "{torque} {place} {smoothing} {base}\n{text}");
                    assert_eq!(text.contains("mechanism.joint]"), torque == "whole", "{text}");
                    assert!(!text.contains("mechanism]"), "{text}");
                }
            }
        }
    }
}

/// Without an answer about the torque nothing can be used, and no peak torque is stated.
#[test]
fn a_recorded_torque_is_asked_about() {
    let folder = InMemory::default();
    let file = swing(400, 2.0, "t [ms],q [deg],M [N m]", 0.01);
    let fields = [("text", LOAD), ("name", "run.csv")];
    let html = preview(&folder, &fields, file.as_bytes());
    assert!(!is_usable(&html) && html.contains("What is the recorded torque or force?"), "{html}");
    assert!(!html.contains("checked required"), "no answer is chosen beforehand");
    assert_eq!(folder.post_file("/recording", &fields, file.as_bytes()).status, 422);
    assert!(folder.0.borrow().is_empty());
    let added = preview(&folder, &[("text", LOAD), ("name", "run.csv"), ("torque", "process")], file.as_bytes());
    assert!(added.contains("is added to") && added.contains("0.9 kgm²") && added.contains("2 Nm"), "{added}");
    let whole = preview(&folder, &[("text", LOAD), ("name", "run.csv"), ("torque", "whole")], file.as_bytes());
    assert!(whole.contains("Removed") && whole.contains("0.9 kgm²"), "{whole}");
    // The largest recorded torque is the peak of the whole load.
    assert!(whole.contains("= 3.000 Nm"), "{whole}");
    let none = preview(
        &folder,
        &[("text", LOAD), ("name", "run.csv")],
        swing(400, 2.0, "t [ms],q [deg],mode", 0.01).as_bytes(),
    );
    assert!(is_usable(&none) && !none.contains("incoming-torque"), "{none}");
}

/// Steps of a coarse encoder raise the peak torque; the proposed window takes that away.
#[test]
fn the_effect_of_smoothing_on_the_peak_torque_is_shown() {
    let folder = InMemory::default();
    let peaks = |grid: f64| {
        let file = swing(2000, 1.0, "t [ms],q [deg],mode", grid);
        let html = preview(&folder, &[("text", LOAD), ("name", "run.csv")], file.as_bytes());
        let numbers = html.split("</sub> = ").skip(1);
        let peaks: Vec<f64> = numbers.map(|rest| rest.split(' ').next().unwrap().parse().unwrap()).collect();
        (html, peaks)
    };
    let (_, smooth) = peaks(1e-7);
    for grid in [0.001, 0.003] {
        let (html, found) = peaks(grid);
        assert!(html.contains("The steps of the file alone") && html.contains("proposed"), "{html}");
        assert!(found[0] > 2.0 * smooth[0], "{grid}: {found:?} {smooth:?}");
        let of_proposed = html.split("proposed:").next().unwrap().rsplit("</sub> = ").next().unwrap();
        let peak: f64 = of_proposed.split(' ').next().unwrap().parse().unwrap();
        assert!((peak / smooth[0] - 1.0).abs() < 0.15, "{grid}: {peak} {smooth:?}");
        assert!(html.contains("Step, position"), "{html}");
    }
}

/// Column, unit and ratio are written where they differ from what the file says by itself.
#[test]
fn another_use_of_the_columns_is_written() {
    let folder = InMemory::default();
    let file = swing(400, 2.0, "clock,angle_a,m", 0.01);
    let html = preview(&folder, &[("text", LOAD), ("name", "run.csv")], file.as_bytes());
    assert!(!is_usable(&html) && html.contains("cannot be used like this"), "{html}");
    let fields = [
        ("text", LOAD),
        ("name", "run.csv"),
        ("role_0", "time"),
        ("unit_0", "ms"),
        ("role_1", "position"),
        ("unit_1", "deg"),
        ("ratio_1", "-80"),
        ("role_2", "none"),
    ];
    let html = preview(&folder, &fields, file.as_bytes());
    assert!(is_usable(&html), "{html}");
    let text = page(&folder.post_file("/recording", &fields, file.as_bytes()));
    let found = keys(&text);
    let of = |key: &str| found.get(&format!("motion[1].{key}")).map(String::as_str);
    let expected = [
        ("columns.time", Some("clock")),
        ("columns.position", Some("angle_a")),
        ("columns.torque", Some("none")),
        ("units.time", Some("ms")),
        ("units.position", Some("deg")),
        ("recorded_ratio.position", Some("-80")),
        ("columns.speed", None),
        ("units.torque", None),
    ];
    for (key, value) in expected {
        assert_eq!(of(key), value, "{key} {text}");
    }
    // A role that a second column receives leaves the first one.
    let fields = [("text", LOAD), ("name", "run.csv"), ("role_0", "time"), ("role_1", "time"), ("changed", "role_1")];
    let html = preview(&folder, &fields, file.as_bytes());
    assert_eq!(html.matches("data-chosen=\"time\"").count(), 1, "{html}");
}

/// A file that is no recording has a sentence, changes nothing and cannot be used; none ends in a crash.
#[test]
fn hostile_files_have_a_sentence_and_change_nothing() {
    let nan = format!("t [s],q [deg]\n{}", "0,NaN\n".repeat(5));
    let backwards = "t [s],q [deg]\n2,0\n1,1\n0,2\n";
    let binary: Vec<u8> = (0..4000_u32).map(|index| (index.wrapping_mul(2_654_435_761) >> 13) as u8).collect();
    let files: [(&str, &[u8]); 10] = [
        ("binary.csv", &binary),
        ("empty.csv", b""),
        ("one-row.csv", b"t [s],q [deg]\n0,1\n"),
        ("nan.csv", nan.as_bytes()),
        ("units-alone.csv", b"t,q\ns,deg\n"),
        ("wrong-order.csv", backwards.as_bytes()),
        ("text.csv", b"Dear colleague,\nplease find the drive attached.\n"),
        ("broken.parquet", b"PAR1\x00\x01\x02"),
        ("book.xlsx", b"PK\x03\x04 a workbook"),
        ("../../etc/x", b"a b c\n1 2 3\n"),
    ];
    for (name, file) in files {
        for text in ["", LOAD, TWO, "this is no = = TOML\n"] {
            for lang in ["en", "de"] {
                let folder = InMemory::default();
                let fields = [("text", text), ("name", name), ("lang", lang)];
                let html = preview(&folder, &fields, file);
                assert!(!is_usable(&html), "{name}: {html}");
                assert!(html.contains("role=\"alert\""), "{name}: {html}");
                assert!(folder.0.borrow().is_empty());
            }
        }
    }
    // Rows of units are read, and so is a project that is not yet whole.
    let folder = InMemory::default();
    let file = swing(40, 10.0, "t,q,mode\nms,deg,", 0.01);
    let html = preview(&folder, &[("text", ""), ("name", "run.csv")], file.as_bytes());
    assert!(is_usable(&html) && html.contains("Still open in the project afterwards"), "{html}");
    assert!(html.contains("The load is missing") && !html.contains("[load]"), "{html}");
}

/// A file of any name is kept under one that a project may state.
#[test]
fn a_file_of_any_name_is_kept_as_a_recording() {
    let file = swing(40, 10.0, "t [ms],q [deg],mode", 0.01);
    for (name, kept) in [
        ("trace", "trace.csv"),
        ("a.b.dat", "a.b.dat.csv"),
        ("Messung 1.CSV", "Messung 1.CSV"),
        ("C:\\logs\\x.csv", "x.csv"),
        ("../../y.txt", "y.txt"),
        (".hidden", "hidden.csv"),
        ("", "recording.csv"),
    ] {
        let folder = InMemory::default();
        let reply = folder.post_file("/recording", &[("name", name)], file.as_bytes());
        let text = page(&reply);
        assert!(text.contains(&format!("file = \"{kept}\"")), "{name}: {text}");
        assert!(folder.0.borrow().contains_key(kept), "{name}");
    }
}

/// Returns each window of smoothing with its peak, as the preview lists them.
fn windows(html: &str) -> Vec<(String, String)> {
    let list = html.split("id=\"incoming-smoothing\"").nth(1).unwrap().split("</fieldset>").next().unwrap();
    let entries = list.split("<li>").skip(1).filter(|entry| !entry.contains("incoming-window-other"));
    let of = |entry: &str| {
        let window = entry.split("value=\"").nth(1).unwrap().split('"').next().unwrap();
        let peak = entry.split("</sub> = ").nth(1).map_or("none", |rest| rest.split('<').next().unwrap());
        (window.to_owned(), peak.to_owned())
    };
    entries.map(of).collect()
}

/// The peak torque of each window of a noisy cycle is the same whichever of them is selected, and none lacks it.
#[test]
fn the_list_of_windows_does_not_depend_on_the_selected_one() {
    let cycle = LOAD.replace("single_move = true\n", "name = \"a\"\n");
    for grid in [1e-7, 0.003, 0.01] {
        let file = swing(600, 2.0, "t [ms],q [deg],mode", grid);
        for base in [LOAD, &cycle] {
            let folder = InMemory::default();
            let of = |window: &str| {
                let fields = [("text", base), ("name", "run.csv"), ("smoothing", window)];
                windows(&preview(&folder, &fields, file.as_bytes()))
            };
            let plain = of("");
            assert!(plain.len() > 2 && plain.iter().all(|(_, peak)| peak.ends_with("Nm")), "{grid}: {plain:?}");
            for (window, _) in &plain {
                assert_eq!(of(window), plain, "{grid}, {window} selected");
            }
        }
    }
}

/// Without a load the list states the acceleration: at the output, or along the line.
#[test]
fn without_a_load_the_windows_have_their_acceleration() {
    let folder = InMemory::default();
    for (headings, unit) in [("t [ms],q [deg],mode", "rad/s²"), ("t [ms],position [mm],mode", "m/s²")] {
        let file = swing(600, 2.0, headings, 1e-7);
        let html = preview(&folder, &[("text", ""), ("name", "run.csv")], file.as_bytes());
        let found = windows(&html);
        assert!(found.len() > 2 && found.iter().all(|(_, peak)| peak.ends_with(unit)), "{headings}: {found:?}");
        // 40 (1 − cos ωt) with one turn in 1.198 s: by hand 40 ω².
        let rate = std::f64::consts::TAU / 1.198;
        let expected = 40.0 * rate * rate * if unit == "m/s²" { 1e-3 } else { 1_f64.to_radians() };
        let peak: f64 = found[0].1.split(' ').next().unwrap().parse().unwrap();
        assert!((peak / expected - 1.0).abs() < 0.02, "{headings}: {peak} {expected}");
        assert!(!html.contains("id=\"incoming-inertia\"") || unit == "rad/s²", "{html}");
    }
}

/// A recording along a line requires a mechanism where the axis has none with a constant travel; the project that results
/// has it in place of the load, with what was typed, and no fault.
#[test]
fn a_recording_along_a_line_asks_for_its_mechanism() {
    let file = swing(400, 2.0, "t [ms],position [mm],force [N]", 1e-7);
    let screw = "format = 1\n[mechanism.screw]\nlead = \"20 mm\"\nmass = \"12 kg\"\n[[motion]]\nlaw = \"trapezoid\"\ndistance = \"90 mm\"\ntime = \"1 s\"\n";
    for (base, torque) in
        [("", "process"), ("", "whole"), ("", "unused"), (LOAD, "process"), (LOAD, "whole"), (screw, "whole")]
    {
        let folder = InMemory::default();
        let mut fields = vec![("text", base), ("name", "run.csv"), ("torque", torque)];
        let html = preview(&folder, &fields, file.as_bytes());
        assert!(html.contains("incoming-mechanism-kind") && !html.contains("incoming-inertia"), "{html}");
        // A screw of the project is proposed with its lead.
        assert_eq!(is_usable(&html), base == screw, "{html}");
        if base != screw {
            assert!(html.contains("State the mechanism first."), "{html}");
            assert_eq!(folder.post_file("/recording", &fields, file.as_bytes()).status, 422);
            fields.push(("mechanism", "screw"));
            let html = preview(&folder, &fields, file.as_bytes());
            assert!(!is_usable(&html) && html.contains("mechanism.screw.lead"), "{html}");
            assert_eq!(html.contains("name=\"mechanism.screw.mass\""), torque != "whole", "{html}");
            fields.extend([
                ("mechanism.screw.lead", "20"),
                ("unit.mechanism.screw.lead", "mm"),
                ("mechanism.screw.mass", "8"),
                ("unit.mechanism.screw.mass", "kg"),
                ("mechanism.screw.inclination", "0"),
                ("unit.mechanism.screw.inclination", "deg"),
                ("once", "true"),
            ]);
        }
        let html = preview(&folder, &fields, file.as_bytes());
        assert!(is_usable(&html) && !html.contains("incoming-open"), "{html}");
        let text = page(&folder.post_file("/recording", &fields, file.as_bytes()));
        let found = keys(&text);
        let of = |key: &str| found.get(&format!("mechanism.screw.{key}")).map(String::as_str);
        assert_eq!(of("lead"), Some("20 mm"), "{text}");
        assert_eq!(of("mass"), Some(if torque == "whole" { "0 kg" } else { "8 kg" }), "{text}");
        assert!(!found.keys().any(|key| key.starts_with("load.")), "{text}");
    }
    // A mechanism whose travel is constant stays; a rotation needs none.
    let folder = InMemory::default();
    let fields = [("text", screw), ("name", "run.csv"), ("torque", "process")];
    let html = preview(&folder, &fields, file.as_bytes());
    assert!(is_usable(&html) && !html.contains("incoming-mechanism"), "{html}");
    let turning = swing(400, 2.0, "t [ms],q [deg],M [N m]", 0.01);
    let html = preview(&folder, &[("text", ""), ("name", "run.csv"), ("torque", "whole")], turning.as_bytes());
    assert!(is_usable(&html) && !html.contains("incoming-mechanism"), "{html}");
}

/// Single wild values, a position that was set anew and the ends of the recording are said before it is used.
#[test]
fn what_is_odd_about_a_recording_is_said() {
    let plain = swing(400, 2.0, "t [s],q [deg],M [N m]", 0.01);
    let with = |row: usize, change: &dyn Fn(f64, f64) -> (f64, f64)| {
        let lines = plain.lines().enumerate().map(|(place, line)| {
            let mut cells = line.split(',');
            match (place, cells.next(), cells.next(), cells.next()) {
                (place, Some(t), Some(q), Some(m)) if place > 0 => {
                    let (q, m) = (q.parse().unwrap(), m.parse().unwrap());
                    let (q, m) = if place >= row { change(q, m) } else { (q, m) };
                    format!("{t},{q},{m}\n")
                }
                _ => format!("{line}\n"),
            }
        });
        lines.collect::<String>()
    };
    let shown =
        |file: &str| preview(&InMemory::default(), &[("name", "run.csv"), ("torque", "whole")], file.as_bytes());
    let said = ["far from those", "jumps by", "Beginning and end, position"];
    let found = |html: &str| said.map(|text| html.contains(text));
    assert_eq!(found(&shown(&plain)), [false, false, true]);
    let spiked: String = plain
        .lines()
        .enumerate()
        .map(
            |(place, line)| {
                if place == 150 { format!("{},99\n", line.rsplit_once(',').unwrap().0) } else { format!("{line}\n") }
            },
        )
        .collect();
    let html = shown(&spiked);
    assert_eq!(found(&html), [true, false, true]);
    assert!(html.contains("99.00 Nm at 298.000 s"), "{html}");
    let set = shown(&with(200, &|q, m| (q + 720.0, m)));
    assert_eq!(found(&set), [false, true, true]);
    assert!(set.contains("720"), "{set}");
}
