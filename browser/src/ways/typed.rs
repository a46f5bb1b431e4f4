//! Scenarios from a tile to an answer whose every figure was typed or is shown as assumed.

use crate::stage::OpenPage;
use crate::tab::{Worded, expect};
use serde_json::json;

/// A machine of a user: its tile, and path, entry and value of each figure; a path repeats the figure of another one.
struct Machine {
    tile: usize,
    figures: &'static [(&'static str, &'static str, &'static str)],
    repeated: &'static [(&'static str, &'static str)],
}

const SCREW: Machine = Machine {
    tile: 4,
    figures: &[
        ("mechanism.screw.lead", "40", "40 mm"),
        ("mechanism.screw.mass", "60+17", "77 kg"),
        ("mechanism.screw.inclination", "90", "90 deg"),
        ("motion[1].distance", "2*130", "260 mm"),
        ("motion[1].time", "7", "7 s"),
        ("motion[2].time", "1/2", "0.5 s"),
    ],
    repeated: &[("motion[3].distance", "-260 mm"), ("motion[3].time", "7 s"), ("motion[4].time", "0.5 s")],
};

const ARM: Machine = Machine {
    tile: 3,
    figures: &[
        ("mechanism.arm.length", "430", "430 mm"),
        ("mechanism.arm.shape", "rod", "rod"),
        ("mechanism.arm.mass", "3,7", "3.7 kg"),
        ("motion[1].distance", "75", "75 deg"),
        ("motion[1].time", "1,6", "1.6 s"),
        ("motion[2].time", "0,9", "0.9 s"),
    ],
    repeated: &[("motion[3].distance", "-75 deg"), ("motion[3].time", "1.6 s"), ("motion[4].time", "0.9 s")],
};

const HOIST: Machine = Machine {
    tile: 8,
    figures: &[
        ("mechanism.hoist.mass", "43", "43 kg"),
        ("mechanism.hoist.drum_diameter", "110", "110 mm"),
        ("mechanism.hoist.falls", "2", "2"),
        ("motion[1].distance", "450", "450 mm"),
        ("motion[1].time", "5,5", "5.5 s"),
        ("motion[2].time", "3", "3 s"),
    ],
    repeated: &[("motion[3].distance", "-450 mm"), ("motion[3].time", "5.5 s"), ("motion[4].time", "3 s")],
};

const WINDER: Machine = Machine {
    tile: 9,
    figures: &[
        ("mechanism.winder.tension", "70", "70 N"),
        ("mechanism.winder.width", "350", "350 mm"),
        ("mechanism.winder.thickness", "0,15", "0.15 mm"),
        ("mechanism.winder.density", "920", "920 kg/m^3"),
        ("motion[1].speed", "45", "45 m/min"),
        ("mechanism.winder.core_diameter", "96", "96 mm"),
        ("mechanism.winder.full_diameter", "310", "310 mm"),
    ],
    repeated: &[],
};

const LOAD: Machine = Machine {
    tile: 1,
    figures: &[
        ("load.inertia", "2", "2 kg m^2"),
        ("motion[1].distance", "90", "90 deg"),
        ("motion[1].time", "2", "2 s"),
        ("motion[2].time", "1", "1 s"),
    ],
    repeated: &[],
};

/// Begins with a screw.
pub(super) fn screw(stage: &OpenPage<'_>) -> Worded {
    begin(stage, &SCREW, "en").map(|_| ())
}

/// Begins with a load at the output; returns the number of actions.
pub(super) fn load(stage: &OpenPage<'_>) -> Worded<usize> {
    begin(stage, &LOAD, "en")
}

/// Largest number of clicks, entries and choices to an answer.
const ACTIONS_MOST: usize = 20;

/// Screw lift, arm, hoist and winder, on a desk and on a phone.
pub(crate) fn typed_and_judged(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    for (width, height) in [(1440, 900), (375, 812)] {
        tab.sized(width, height, 1.0)?;
        for (name, machine) in [("screw", &SCREW), ("arm", &ARM), ("hoist", &HOIST), ("winder", &WINDER)] {
            let what = format!("{name} at {width}");
            let actions = begin(stage, machine, "de").map_err(|error| format!("{what}: {error}"))?;
            println!("       {}: {what}: {actions} actions to an answer", stage.shell.name());
            expect(actions <= ACTIONS_MOST, || format!("{what}: {actions} actions"))?;
            let text = tab.value("#text")?;
            for (path, value) in keys_of(&text) {
                let typed = machine.figures.iter().any(|(of, _, stated)| *of == path && *stated == value);
                let repeated = machine.repeated.iter().any(|(of, stated)| *of == path && *stated == value);
                // The motion of the template is plain; a law that is not decided is listed as assumed.
                let plain = path == "format" || path == "axis.single_move" || path.ends_with(".law");
                expect(typed || repeated || plain, || format!("{what}: {path} = {value} was not typed\n{text}"))?;
            }
            for (path, _, value) in machine.figures {
                let is_stated = keys_of(&text).iter().any(|(of, stated)| of == path && stated == value);
                expect(is_stated, || format!("{what}: {path} = {value} is not in the project\n{text}"))?;
            }
            let assumed = questions::read(&text).map_err(|faults| format!("{what}: {faults:?}"))?.assumed();
            let shown = tab.eval("document.querySelectorAll('#assumptions li').length")?;
            expect(shown == json!(assumed.len()), || format!("{what}: {shown} of {} assumed", assumed.len()))?;
            // It has an answer: actuators that fit, in the list.
            expect(tab.eval("document.querySelectorAll('.ranking tbody').length")? != json!(0), || what.clone())?;
        }
    }
    tab.sized(1440, 900, 1.0)
}

/// Types the figures of a machine and returns the number of actions to its answer.
fn begin(stage: &OpenPage<'_>, machine: &Machine, language: &str) -> Worded<usize> {
    let tab = &stage.tab;
    stage.start(language)?;
    tab.click(&format!(".tiles li:nth-child({}) .tile", machine.tile))?;
    tab.until("document.activeElement.matches('#begin input')")?;
    let mut actions = 1;
    for (place, (path, entry, _)) in machine.figures.iter().enumerate() {
        let field = format!("#begin [name=\"{path}\"]");
        let is_choice = tab.eval(&format!("document.querySelector({})?.tagName === 'SELECT'", json!(field)))?;
        if is_choice == json!(true) {
            tab.run(
                "const field = document.querySelector(arguments_[0]); field.value = arguments_[1]; \
                 field.dispatchEvent(new Event('change', { bubbles: true }));",
                vec![json!(field), json!(entry)],
            )?;
            // Opened, and chosen from.
            actions += 2;
            continue;
        }
        // The first field has the focus.
        if place > 0 {
            tab.click(&field)?;
            actions += 1;
        }
        tab.keys(entry)?;
        tab.until(&format!("document.querySelector({})?.value === {}", json!(field), json!(entry)))?;
        actions += 1;
    }
    tab.click("#begin form button[type=submit]")?;
    stage.ready()?;
    Ok(actions + 1)
}

/// Returns path and value of every key of a plain project file.
fn keys_of(text: &str) -> Vec<(String, String)> {
    let (mut table, mut segments, mut found) = (String::new(), 0, Vec::new());
    for line in text.lines() {
        if line == "[[motion]]" {
            segments += 1;
            table = format!("motion[{segments}].");
        } else if let Some(name) = line.strip_prefix('[').and_then(|line| line.strip_suffix(']')) {
            table = format!("{name}.");
        } else if let Some((key, value)) = line.split_once(" = ") {
            found.push((format!("{table}{key}"), value.trim_matches('"').to_owned()));
        }
    }
    found
}

/// An assumption is taken, changed and left out; each is undone.
pub(crate) fn assumptions(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    begin(stage, &ARM, "de")?;
    stage.accessible("assumptions")?;
    let before = tab.value("#text")?;
    let count = tab.eval("document.querySelectorAll('#assumptions li').length")?;
    let item = |key: &str| format!("#assumptions button[hx-vals*=\"{key}\"]");
    let undone = || {
        tab.click("#undo")?;
        tab.until(&format!("document.querySelector('#text').value === {}", json!(before)))?;
        // The strip follows with the answer.
        tab.until(&format!("document.querySelectorAll('#assumptions li').length === {count}"))
    };
    tab.click(&item("friction_torque"))?;
    tab.until("document.querySelector('#text').value.includes('friction_torque = \"0 N m\"')")?;
    tab.until("!document.querySelector('#assumptions button[hx-vals*=\"friction_torque\"]')")?;
    undone()?;
    tab.click("#assumptions [data-change$=\"axis_tilt\"]")?;
    tab.until("document.activeElement.id === 'f-mechanism-arm-axis_tilt' && document.activeElement.value === '90'")?;
    undone()?;
    tab.click(&item("leave_out=supply"))?;
    tab.until("document.querySelector('#text').value.includes('leave_out = [\"supply\"]')")?;
    undone()
}
