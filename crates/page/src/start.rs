//! Where one begins: a mechanism, at most six figures, a first answer.

use crate::call::{Call, Shell};
use crate::sketch;
use maud::{Markup, html};
use project::{Edit, KEYS, Kind, edit, key_at};
use quantities::{Language, Measure, format_significant};
use questions::list::new::template;
use questions::list::size::sized;
use questions::{Patience, read_all_watched};
use words::{about_text, capitalised, page, short_label, terminal};

/// A way to begin: the mechanism, and the keys to fill in with typical values; those after
/// the sixth are set without a field.
pub(crate) struct Begin {
    pub(crate) mechanism: Option<&'static str>,
    pub(crate) asked: &'static [(&'static str, &'static str)],
    pub(crate) set: &'static [(&'static str, &'static str)],
}

/// The moves of each: there and back, with a rest after both.
const FORTH_AND_BACK: &[(&str, &str)] = &[("motion[1].law", "polynomial_5"), ("motion[2].law", "dwell")];

pub(crate) const BEGINS: [Begin; 11] = [
    Begin {
        mechanism: None,
        asked: &[
            ("load.inertia", "1.3 kg m^2"),
            ("load.friction_torque", "5 N m"),
            ("motion[1].distance", "90 deg"),
            ("motion[1].time", "0.6 s"),
            ("motion[2].time", "1 s"),
            ("requirements.supply", "560 V"),
        ],
        set: FORTH_AND_BACK,
    },
    Begin {
        mechanism: Some("turntable"),
        asked: &[
            ("mechanism.turntable.bodies", "disc diameter=600mm length=20mm density=7850kg/m^3"),
            ("mechanism.turntable.friction_torque", "3 N m"),
            ("motion[1].distance", "90 deg"),
            ("motion[1].time", "0.8 s"),
            ("motion[2].time", "1 s"),
            ("requirements.supply", "560 V"),
        ],
        set: FORTH_AND_BACK,
    },
    Begin {
        mechanism: Some("arm"),
        asked: &[
            ("mechanism.arm.mass", "8 kg"),
            ("mechanism.arm.centre_distance", "250 mm"),
            ("mechanism.arm.inertia", "0.7 kg m^2"),
            ("motion[1].distance", "90 deg"),
            ("motion[1].time", "0.9 s"),
            ("motion[2].time", "1 s"),
        ],
        set: &[
            ("mechanism.arm.axis_tilt", "90 deg"),
            ("mechanism.arm.start_angle", "0 deg"),
            ("motion[1].law", "polynomial_5"),
            ("motion[2].law", "dwell"),
            ("requirements.supply", "560 V"),
        ],
    },
    Begin {
        mechanism: Some("screw"),
        asked: &[
            ("mechanism.screw.lead", "20 mm"),
            ("mechanism.screw.mass", "60 kg"),
            ("mechanism.screw.inclination", "0 deg"),
            ("motion[1].distance", "100 mm"),
            ("motion[1].time", "8 s"),
            ("motion[2].time", "1 s"),
        ],
        set: &[("motion[1].law", "polynomial_5"), ("motion[2].law", "dwell"), ("requirements.supply", "560 V")],
    },
    Begin {
        mechanism: Some("belt"),
        asked: &[
            ("mechanism.belt.pulley_diameter", "120 mm"),
            ("mechanism.belt.mass", "18 kg"),
            ("mechanism.belt.friction_force", "35 N"),
            ("motion[1].distance", "800 mm"),
            ("motion[1].time", "2.8 s"),
            ("motion[2].time", "0.6 s"),
        ],
        set: &[("motion[1].law", "polynomial_5"), ("motion[2].law", "dwell"), ("requirements.supply", "560 V")],
    },
    Begin {
        mechanism: Some("conveyor"),
        asked: &[
            ("mechanism.conveyor.roller_diameter", "100 mm"),
            ("mechanism.conveyor.mass", "80 kg"),
            ("mechanism.conveyor.friction_force", "60 N"),
            ("motion[1].distance", "500 mm"),
            ("motion[1].time", "2 s"),
            ("motion[2].time", "1 s"),
        ],
        set: &[("motion[1].law", "polynomial_5"), ("motion[2].law", "dwell"), ("requirements.supply", "560 V")],
    },
    Begin {
        mechanism: Some("slider_crank"),
        asked: &[
            ("mechanism.slider_crank.crank", "60 mm"),
            ("mechanism.slider_crank.rod", "240 mm"),
            ("mechanism.slider_crank.mass", "12 kg"),
            ("motion[1].speed", "30 1/min"),
            ("motion[1].time", "2 s"),
            ("requirements.supply", "560 V"),
        ],
        set: &[("mechanism.slider_crank.start_angle", "0 deg"), ("motion[1].law", "constant")],
    },
    Begin {
        mechanism: Some("hoist"),
        asked: &[
            ("mechanism.hoist.drum_diameter", "120 mm"),
            ("mechanism.hoist.falls", "2"),
            ("mechanism.hoist.mass", "45 kg"),
            ("motion[1].distance", "600 mm"),
            ("motion[1].time", "6 s"),
            ("motion[2].time", "2 s"),
        ],
        set: &[("motion[1].law", "polynomial_5"), ("motion[2].law", "dwell"), ("requirements.supply", "560 V")],
    },
    Begin {
        mechanism: Some("winder"),
        asked: &[
            ("mechanism.winder.core_diameter", "90 mm"),
            ("mechanism.winder.full_diameter", "330 mm"),
            ("mechanism.winder.thickness", "2 mm"),
            ("mechanism.winder.width", "400 mm"),
            ("mechanism.winder.tension", "80 N"),
            ("motion[1].speed", "40 1/min"),
        ],
        set: &[
            ("mechanism.winder.winding", "up"),
            ("mechanism.winder.start_diameter", "90 mm"),
            ("mechanism.winder.density", "900 kg/m^3"),
            ("motion[1].law", "trapezoid"),
            ("motion[1].distance", "21600 deg"),
            ("motion[1].acceleration", "2 rad/s^2"),
            ("motion[2].law", "dwell"),
            ("motion[2].time", "20 s"),
            ("requirements.supply", "560 V"),
        ],
    },
    Begin {
        mechanism: Some("scissor_lift"),
        asked: &[
            ("mechanism.scissor_lift.arm_length", "700 mm"),
            ("mechanism.scissor_lift.lead", "10 mm"),
            ("mechanism.scissor_lift.mass", "60 kg"),
            ("motion[1].distance", "5760 deg"),
            ("motion[1].time", "20 s"),
            ("motion[2].time", "5 s"),
        ],
        set: &[
            ("mechanism.scissor_lift.stages", "2"),
            ("mechanism.scissor_lift.arm_angle", "20 deg"),
            ("motion[1].law", "polynomial_5"),
            ("motion[2].law", "dwell"),
            ("requirements.supply", "560 V"),
        ],
    },
    Begin {
        mechanism: Some("four_bar"),
        asked: &[
            ("mechanism.four_bar.ground", "400 mm"),
            ("mechanism.four_bar.crank", "100 mm"),
            ("mechanism.four_bar.coupler", "350 mm"),
            ("mechanism.four_bar.rocker", "250 mm"),
            ("mechanism.four_bar.rocker_inertia", "0.25 kg m^2"),
            ("motion[1].speed", "25 1/min"),
        ],
        set: &[
            ("mechanism.four_bar.axis_tilt", "90 deg"),
            ("mechanism.four_bar.start_angle", "0 deg"),
            ("motion[1].law", "constant"),
            ("motion[1].time", "2.4 s"),
            ("requirements.supply", "560 V"),
        ],
    },
];

impl Begin {
    /// The project file that begins so.
    pub(crate) fn text(&self, told: impl Fn(&str) -> Option<String>) -> String {
        let mut text = String::from("format = 1\n");
        // The kind of a segment stands before what it takes.
        let mut all: Vec<(&str, String)> = Vec::new();
        for (path, value) in self.asked.iter().chain(self.set) {
            let value = told(path).unwrap_or_else(|| (*value).to_owned());
            all.push((path, value));
        }
        // A cycle that comes back: the same way with the other sign.
        let turns_on =
            matches!(self.mechanism, Some("conveyor" | "turntable" | "slider_crank" | "winder" | "four_bar"));
        all.sort_by_key(|(path, _)| {
            (
                !path.starts_with("mechanism") && !path.starts_with("load"),
                path.starts_with("requirements"),
                (*path).split('.').next().map(str::to_owned),
                !path.ends_with(".law"),
            )
        });
        for (path, value) in &all {
            if let Some(entry) = path.split('.').next().filter(|entry| entry.ends_with(']'))
                && let Ok(made) = with_entry(&text, entry)
            {
                text = made;
            }
            text = edit(&text, path, Edit::Value(value)).unwrap_or(text);
        }
        let of = |path: &str| all.iter().find(|(known, _)| *known == path).map(|(_, value)| value.clone());
        if turns_on {
            if let Ok(single) = edit(&text, "axis.single_move", Edit::Value("true")) {
                text = single;
            }
        } else if let (Some(distance), Some(time), Some(rest)) =
            (of("motion[1].distance"), of("motion[1].time"), of("motion[2].time"))
        {
            let back = distance.strip_prefix('-').map_or_else(|| format!("-{distance}"), str::to_owned);
            let more = [
                ("motion[3].law", "polynomial_5".to_owned()),
                ("motion[3].distance", back),
                ("motion[3].time", time),
                ("motion[4].law", "dwell".to_owned()),
                ("motion[4].time", rest),
            ];
            for (path, value) in more {
                if let Some(entry) = path.split('.').next()
                    && let Ok(made) = with_entry(&text, entry)
                {
                    text = made;
                }
                text = edit(&text, path, Edit::Value(&value)).unwrap_or(text);
            }
        }
        text
    }
}

/// The text with an entry of a list, where it has none yet.
fn with_entry(text: &str, entry: &str) -> Result<String, project::EditFault> {
    let there = project::written(text).is_some_and(|all| all.iter().any(|key| key.path == entry));
    if there { Ok(text.to_owned()) } else { edit(text, entry, Edit::Table) }
}

/// What a mechanism is called.
fn title(mechanism: Option<&str>, language: Language) -> String {
    let Some(name) = mechanism else { return page::load_at_the_output(language).to_owned() };
    let key = KEYS.iter().find(|key| key.name == "mechanism").and_then(|key| match key.kind {
        Kind::Table(keys) => keys.iter().find(|key| key.name == name),
        _ => None,
    });
    key.map(|key| capitalised(about_text(key.about, language))).unwrap_or_default()
}

/// The ways to begin, as drawings.
pub(crate) fn tiles(language: Language) -> Markup {
    html! {
        ul.tiles { @for (place, begin) in BEGINS.iter().enumerate() {
            @let title = title(begin.mechanism, language);
            li { button.tile type="button" hx-get={ "/begin?kind=" (place) "&lang=" (language.id()) } hx-target="#begin" hx-swap="innerHTML" hx-include="unset" {
                span.sketch aria-hidden="true" { (sketch::still(begin.mechanism)) }
                span { (title) }
            } }
        } }
    }
}

/// The few figures of a way to begin.
pub(crate) fn asked(place: usize, language: Language) -> Markup {
    let Some(begin) = BEGINS.get(place) else { return html! {} };
    html! {
        form.begin-form.rows method="get" action="/" aria-labelledby="begin-title" {
            h3 id="begin-title" tabindex="-1" { (title(begin.mechanism, language)) }
            span.sketch { (sketch::of(begin.mechanism, None, "b", &title(begin.mechanism, language), language)) }
            p.small { (page::usual_values(language)) }
            @for (path, value) in begin.asked {
                div.row {
                    label for={ "b-" (crate::form::id(path)) } { (key_at(path).map(|key| capitalised(&short_label(about_text(key.about, language)))).unwrap_or_default()) @if path.starts_with("motion[2]") { " (" (words::law_text(project::SegmentLaw::Dwell, language)) ")" } }
                    input id={ "b-" (crate::form::id(path)) } name=(path) type="text" value=(value) autocomplete="off" spellcheck="false";
                }
            }
            input type="hidden" name="begin" value=(place);
            input type="hidden" name="lang" value=(language.id());
            button.primary type="submit" { (page::first_answer(language)) }
        }
    }
}

/// What comes out of an example, for its card.
pub(crate) fn example_verdict(call: &Call<'_>, shell: &dyn Shell, patience: &Patience) -> Markup {
    let l = call.language();
    let kind = call.field("kind").unwrap_or_default();
    let Some(found) = template(&kind, crate::head::USUAL_NAME, l).filter(|found| found.recording.is_none()) else {
        return html! {};
    };
    let Ok(projects) = read_all_watched(&found.text, shell.files(), patience) else { return html! {} };
    let Some((project, sizing)) =
        projects.first().and_then(|project| Some((project, sized(project, 0, patience).ok()?)))
    else {
        return html! {};
    };
    let cycle = format_significant(project.axis.motion.duration().si(), 3, l);
    html! {
        @match sizing.answer() {
            Some(best) => span class=(crate::verdict::class(best)) { (best.id) },
            None => span.fail { (capitalised(terminal::no_actuator_fits(l))) },
        }
        " " span.small { (page::cycle_of(&cycle, l)) }
    }
}

/// The mechanism of a project's text.
pub(crate) fn mechanism_of(text: &str) -> Option<String> {
    project::written(text)?
        .iter()
        .find_map(|key| key.path.strip_prefix("mechanism.")?.split('.').next().map(str::to_owned))
}

/// The first line of an example: what it is.
pub(crate) fn about<'t>(text: &'t str, kind: &'t str) -> &'t str {
    text.lines().find_map(|line| line.strip_prefix("# ")).unwrap_or(kind)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_way_to_begin_asks_for_at_most_six_figures_and_has_an_answer() {
        for begin in &BEGINS {
            assert!(begin.asked.len() <= 6, "{:?}", begin.mechanism);
            let text = begin.text(|_| None);
            let project = questions::read(&text);
            assert!(project.is_ok(), "{text}\n{project:?}");
            let fits = project.is_ok_and(|project| questions::size(&project).fits());
            assert!(fits, "{text}");
        }
    }

    #[test]
    fn what_is_typed_takes_the_place_of_what_is_proposed() {
        let text = BEGINS[4].text(|path| (path == "motion[1].distance").then(|| "-250 mm".to_owned()));
        assert!(text.contains("distance = \"-250 mm\"") && text.contains("distance = \"250 mm\""), "{text}");
    }
}
