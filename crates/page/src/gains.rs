//! Gains of the simulated control above the pictures of their effect: value in use, slider, default.

use crate::chapters::symbol;
use crate::markup::{id, vals};
use crate::state::PageState;
use answers::Figure;
use maud::{Markup, html};
use project::{key_at, written};
use quantities::{Language, Unit, format_significant};
use words::{about_text, capitalised, short_label, simulation, views};

/// Span of a slider on both sides of the value in use, in powers of ten.
const DECADES: f64 = 1.0;

/// Longest time constant of the slider of a time that is zero \[ms\].
const TIME_MOST: f64 = 5.0;

/// Returns the gains in use; another one starts a new run, and the instant stays.
pub(crate) fn gains(state: &PageState, record: &answers::Simulation) -> Markup {
    let l = state.language;
    let stated = written(&state.good).unwrap_or_default();
    let of = |gain: &Figure| {
        let path = format!("{}twin.{}", state.prefix, gain.id);
        let is_stated = stated.iter().any(|key| key.path == path && key.value.is_some());
        Some(field(gain, &path, gain.value?.0, is_stated, l))
    };
    html! {
        details id="gains" open {
            summary { (capitalised(simulation::gains(l))) }
            div.gains { @for gain in record.gains.0.iter().filter_map(of) { (gain) } }
        }
    }
}

fn field(gain: &Figure, path: &str, value: f64, is_stated: bool, language: Language) -> Markup {
    let l = language;
    let Some(key) = key_at(path) else { return html! {} };
    let about = capitalised(&short_label(about_text(key.about, l)));
    let id = format!("gain-{}", id(path));
    // Times of a controller are milliseconds or less.
    let (value, unit) = match gain.unit {
        "1" => (value, ""),
        "s" => (1e3 * value, "ms"),
        other => (value, other),
    };
    // A share may be nought; the others go by powers of ten.
    let is_linear = value <= 0.0 || unit.is_empty();
    let (low, high, at) = if is_linear {
        let least = if unit.is_empty() { 1.0 } else { TIME_MOST };
        (0.0, (2.0 * value).max(least), value)
    } else {
        (value.log10() - DECADES, value.log10() + DECADES, value.log10())
    };
    let shown = format_significant(value, 4, l);
    html! {
        div.gain {
            label for=(id) title=(about) { i { (symbol(&gain.title)) } }
            input id={ (id) "-r" } type="range" min=(low) max=(high) step=((high - low) / 200.0) value=(at) data-gain=(id) data-linear=[is_linear.then_some("")] hx-morph-skip="" aria-label={ (about) ", " (views::slider(l)) };
            input id=(id) type="text" name="value" value=(shown) size="7" autocomplete="off" spellcheck="false" inputmode="decimal" title=(about) data-gain-field=""
                hx-post="/work" hx-trigger="input changed delay:60ms, change" hx-vals=(vals(&[("path", path), ("unit", unit)]));
            span.unit { (Unit::of(unit).map_or(unit, |unit| unit.symbol_in(l))) }
            @if is_stated {
                button.small type="button" id={ (id) "-d" } hx-post="/work" hx-vals=(vals(&[("path", path), ("value", "")])) title=(views::default_gain(l)) aria-label={ (about) ", " (views::default_gain(l)) } { "↺" }
            }
        }
    }
}
