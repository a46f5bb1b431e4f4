//! The drawing of a mechanism: its symbols lead to the rows of the form, and the rows to them.

use crate::form::id;
use maud::{Markup, PreEscaped, html};
use quantities::{Angle, Language, Measure, parse_as};
use questions::{Drawing, MechanismId};
use words::page;

/// The drawing of a mechanism by its key, of the load at the output without one, turned by the inclination as it is stated.
fn drawing(mechanism: Option<&str>, inclination: Option<&str>) -> Drawing {
    let angle = inclination.and_then(|text| parse_as::<Angle>(text).ok());
    let id = mechanism.and_then(MechanismId::of).unwrap_or(MechanismId::Load);
    id.drawing().inclined(angle.map_or(0.0, Measure::si))
}

/// The drawing alone, for a picture of a choice.
pub(crate) fn still(mechanism: Option<&str>) -> Markup {
    let drawing = drawing(mechanism, None);
    html! { svg viewBox=(drawing.view_box()) { (PreEscaped(drawing.svg())) } }
}

/// The drawing of a mechanism with its symbols; `of` is the path of its table.
pub(crate) fn of(
    mechanism: Option<&str>,
    inclination: Option<&str>,
    of: &str,
    title: &str,
    language: Language,
) -> Markup {
    let drawing = drawing(mechanism, inclination);
    html! {
        svg viewBox=(drawing.view_box()) role="group" aria-label=(page::drawing_of(&title, language)) {
            (PreEscaped(drawing.svg()))
            @for call_out in &drawing.call_outs {
                @let path = format!("{of}.{}", call_out.key);
                @let [x, y] = call_out.foot();
                a href={ "#" (id(&path)) } data-for=(id(&path)) {
                    (PreEscaped(call_out.leader()))
                    text x=(x) y=(y) text-anchor="middle" {
                        @match call_out.symbol.split_once('_') {
                            Some((head, tail)) => { (head) tspan dy="4" font-size="70%" { (tail) } }
                            None => { (call_out.symbol) }
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
    use project::{KEYS, Key, Kind};

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
            let drawn = of(Some(kind.name), None, "m", "t", Language::En).into_string();
            assert!(!seen.contains(&drawn), "{}", kind.name);
            for part in drawn.split("href=\"#f-m-").skip(1) {
                let key = part.split('"').next().unwrap_or_default();
                assert!(rows.iter().any(|row| row.name == key), "{}: {key}", kind.name);
            }
            seen.push(drawn);
        }
        let load = of(None, None, "load", "t", Language::De).into_string();
        for part in load.split("href=\"#f-load-").skip(1) {
            let key = part.split('"').next().unwrap_or_default();
            assert!(keys_of("load").iter().any(|row| row.name == key), "{key}");
        }
    }
}
