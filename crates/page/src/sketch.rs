//! Own drawings of the mechanisms; the signs in them lead to the rows of the form, and the rows to them.

use crate::form::id;
use maud::{Markup, PreEscaped, html};
use workbench::Language;
use workbench::text::page;

/// A sign in a drawing: the key that it stands for, how it is written, where.
type Sign = (&'static str, &'static str, u16, u16);

struct Sketch {
    /// Lines and bodies, as SVG.
    lines: &'static str,
    signs: &'static [Sign],
}

/// The actuator as every drawing has it: a hollow cylinder with its output at the left.
const ACTUATOR: &str = "<rect class='actuator' x='20' y='62' width='44' height='46' rx='3'/>\
    <path class='axis' d='M10 85H74'/>";

const LOAD: Sketch = Sketch {
    lines: "<path class='shaft' d='M64 85H112'/><circle class='body' cx='160' cy='85' r='46'/>\
        <circle class='thin' cx='160' cy='85' r='6'/><path class='arrow' d='M160 30a55 55 0 0 1 52 38' marker-end='url(#tip)'/>",
    signs: &[
        ("inertia", "J", 160, 118),
        ("friction_torque", "T_R", 92, 76),
        ("viscous_friction", "d", 92, 106),
        ("external_torque", "T_x", 224, 60),
    ],
};

const TURNTABLE: Sketch = Sketch {
    lines: "<path class='shaft' d='M64 85H112'/><rect class='body' x='112' y='30' width='18' height='110' rx='2'/>\
        <rect class='body' x='130' y='42' width='34' height='26'/><rect class='body' x='130' y='104' width='34' height='22'/>\
        <path class='dim' d='M176 55V85' /><path class='axis' d='M112 85H200'/><path class='arrow' d='M121 18a14 40 0 0 1 10 6' marker-end='url(#tip)'/>",
    signs: &[
        ("bodies", "J", 147, 60),
        ("payload_distance", "r", 190, 74),
        ("axis_tilt", "β", 214, 90),
        ("start_angle", "φ_0", 150, 20),
        ("friction_torque", "T_R", 92, 76),
    ],
};

const ARM: Sketch = Sketch {
    lines: "<circle class='actuator' cx='60' cy='100' r='24'/><circle class='thin' cx='60' cy='100' r='6'/>\
        <path class='body' d='M52 92L220 34l10 18L66 110z'/><circle class='mark' cx='150' cy='67' r='5'/>\
        <path class='dim' d='M60 130L158 96'/><path class='arrow' d='M150 67V128' marker-end='url(#tip)'/><path class='axis' d='M60 100H230'/>\
        <path class='thin' d='M120 100a60 60 0 0 0 -4 -20'/>",
    signs: &[
        ("inertia", "J", 206, 30),
        ("mass", "m", 164, 126),
        ("centre_distance", "s", 106, 128),
        ("payload_distance", "r_p", 240, 50),
        ("start_angle", "φ_0", 136, 94),
        ("axis_tilt", "β", 40, 66),
        ("friction_torque", "T_R", 24, 136),
    ],
};

const SCREW: Sketch = Sketch {
    lines: "<path class='shaft' d='M64 85H290'/><path class='thread' d='M90 79l6 12M102 79l6 12M114 79l6 12M126 79l6 12M210 79l6 12M222 79l6 12M234 79l6 12M246 79l6 12M258 79l6 12'/>\
        <rect class='body' x='146' y='52' width='54' height='58' rx='2'/><path class='ground' d='M84 118H290'/>\
        <path class='arrow' d='M200 66H236' marker-end='url(#tip)'/><path class='dim' d='M90 100H102'/>",
    signs: &[
        ("lead", "P", 96, 114),
        ("mass", "m", 173, 86),
        ("inertia", "J", 74, 74),
        ("process_force", "F", 246, 70),
        ("friction_force", "F_R", 146, 134),
        ("friction_coefficient", "µ", 190, 134),
        ("inclination", "β", 276, 134),
        ("counterweight", "m_G", 173, 40),
    ],
};

const BELT: Sketch = Sketch {
    lines: "<circle class='actuator' cx='60' cy='92' r='30'/><circle class='thin' cx='260' cy='92' r='30'/>\
        <path class='belt' d='M60 62H260M60 122H260'/><rect class='body' x='130' y='34' width='62' height='28' rx='2'/>\
        <path class='ground' d='M100 62H226'/><path class='arrow' d='M192 46H232' marker-end='url(#tip)'/><path class='dim' d='M60 62V122'/>",
    signs: &[
        ("pulley_diameter", "D", 74, 96),
        ("mass", "m", 160, 53),
        ("inertia", "J", 40, 52),
        ("process_force", "F", 244, 50),
        ("friction_force", "F_R", 110, 78),
        ("friction_coefficient", "µ", 206, 78),
        ("inclination", "β", 292, 134),
        ("counterweight", "m_G", 160, 140),
    ],
};

const CONVEYOR: Sketch = Sketch {
    lines: "<circle class='actuator' cx='50' cy='96' r='24'/><circle class='thin' cx='270' cy='96' r='24'/>\
        <path class='belt' d='M50 72H270M50 120H270'/><rect class='body' x='96' y='44' width='34' height='28'/>\
        <rect class='body' x='156' y='44' width='34' height='28'/><path class='arrow' d='M200 58H236' marker-end='url(#tip)'/><path class='dim' d='M50 72V120'/>",
    signs: &[
        ("roller_diameter", "D", 64, 100),
        ("mass", "m", 143, 38),
        ("inertia", "J", 24, 68),
        ("process_force", "F", 248, 62),
        ("friction_force", "F_R", 120, 90),
        ("friction_coefficient", "µ", 190, 90),
        ("inclination", "β", 296, 134),
    ],
};

const SLIDER_CRANK: Sketch = Sketch {
    lines: "<circle class='actuator' cx='70' cy='92' r='34'/><path class='body' d='M66 88L92 62l8 8L76 96z'/>\
        <path class='shaft' d='M96 66L214 92'/><rect class='body' x='206' y='74' width='56' height='36' rx='2'/>\
        <path class='ground' d='M180 112H296'/><path class='arrow' d='M262 92H292' marker-end='url(#tip)'/><path class='axis' d='M30 92H206'/>",
    signs: &[
        ("crank", "r", 70, 70),
        ("rod", "l", 158, 68),
        ("mass", "m", 234, 96),
        ("inertia", "J", 50, 118),
        ("process_force", "F", 286, 82),
        ("start_angle", "φ_0", 118, 106),
        ("inclination", "β", 296, 132),
    ],
};

const JOINT: Sketch = Sketch {
    lines: "<circle class='actuator' cx='70' cy='104' r='26'/><path class='body' d='M60 90L150 36l10 16L80 118z'/>\
        <circle class='thin' cx='152' cy='44' r='16'/><path class='body' d='M160 36L262 60l-4 18L156 56z'/>\
        <path class='arrow' d='M104 104a36 36 0 0 0 -8 -22' marker-end='url(#tip)'/>",
    signs: &[("inertia", "J", 210, 48), ("holding_torque", "T_H", 124, 116)],
};

const TABLE: Sketch = Sketch {
    lines: "<path class='thin' d='M40 20V136H300'/><path class='shaft' d='M40 96C90 40 120 40 160 84S240 130 296 60' fill='none'/>\
        <path class='dash' d='M40 60C100 110 160 110 200 70S270 40 296 96' fill='none'/>",
    signs: &[("points", "J(φ), T(φ)", 210, 32), ("start_angle", "φ_0", 62, 152), ("friction_torque", "T_R", 270, 152)],
};

fn sketch_of(mechanism: Option<&str>) -> Sketch {
    match mechanism {
        None => LOAD,
        Some("turntable") => TURNTABLE,
        Some("arm") => ARM,
        Some("screw") => SCREW,
        Some("belt") => BELT,
        Some("conveyor") => CONVEYOR,
        Some("slider_crank") => SLIDER_CRANK,
        Some("joint") => JOINT,
        _ => TABLE,
    }
}

/// The head of an arrow, once for all drawings of the page.
pub(crate) fn tip() -> Markup {
    html! { svg.hidden width="0" height="0" aria-hidden="true" { defs { marker id="tip" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" markerHeight="7" orient="auto" { path d="M0 0L8 4L0 8z" {} } } } }
}

/// Whether a drawing shows its actuator itself.
fn has_actuator(sketch: &Sketch, mechanism: Option<&str>) -> bool {
    sketch.lines.contains("'actuator'") || mechanism == Some("table")
}

/// The drawing alone, for a picture of a choice.
pub(crate) fn still(mechanism: Option<&str>) -> Markup {
    let sketch = sketch_of(mechanism);
    html! {
        svg viewBox="0 0 320 160" {
            @if !has_actuator(&sketch, mechanism) { (PreEscaped(ACTUATOR)) }
            (PreEscaped(sketch.lines))
        }
    }
}

/// The drawing of a mechanism, of the load at the output without one; `of` is the path of its table.
pub(crate) fn of(mechanism: Option<&str>, of: &str, title: &str, language: Language) -> Markup {
    let sketch = sketch_of(mechanism);
    html! {
        svg viewBox="0 0 320 160" role="group" aria-label=(page::drawing_of(&title, language)) {
            @if !has_actuator(&sketch, mechanism) { (PreEscaped(ACTUATOR)) }
            (PreEscaped(sketch.lines))
            @for (key, sign, x, y) in sketch.signs {
                @let path = format!("{of}.{key}");
                a href={ "#" (id(&path)) } data-for=(id(&path)) {
                    text x=(x) y=(y) text-anchor="middle" {
                        @match sign.split_once('_') {
                            Some((head, tail)) => { (head) tspan dy="4" font-size="70%" { (tail) } }
                            None => { (sign) }
                        }
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use workbench::{KEYS, Key, Kind};

    fn keys_of(name: &str) -> &'static [Key] {
        match KEYS.iter().find(|key| key.name == name).map(|key| key.kind) {
            Some(Kind::Table(keys)) => keys,
            _ => &[],
        }
    }

    #[test]
    fn every_mechanism_has_a_drawing_and_every_sign_a_key() {
        let mut seen = Vec::new();
        for kind in keys_of("mechanism") {
            let Kind::Table(rows) = kind.kind else { panic!("{}", kind.name) };
            let drawn = of(Some(kind.name), "m", "t", Language::En).into_string();
            assert!(!seen.contains(&drawn), "{}", kind.name);
            for part in drawn.split("href=\"#f-m-").skip(1) {
                let key = part.split('"').next().unwrap_or_default();
                assert!(rows.iter().any(|row| row.name == key), "{}: {key}", kind.name);
            }
            seen.push(drawn);
        }
        let load = of(None, "load", "t", Language::De).into_string();
        for part in load.split("href=\"#f-load-").skip(1) {
            let key = part.split('"').next().unwrap_or_default();
            assert!(keys_of("load").iter().any(|row| row.name == key), "{key}");
        }
    }
}
