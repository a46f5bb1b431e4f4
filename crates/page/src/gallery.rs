//! The gallery: links to the states of the page, and every component of it, so that the effect of a style change is visible.

use crate::call::Call;
use crate::form::AT_ONCE;
use crate::{checks, value};
use figures::Theme;
use maud::{DOCTYPE, Markup, html};
use project::{Kind, key_at};
use quantities::Language;
use questions::Verdict;
use words::{capitalised, page, terms, verdict_count, verdict_word};

/// A state of the page that stands for its kind; the browser tests compare its picture and look for faults of accessibility.
#[derive(Clone, Copy, Debug)]
pub struct GalleryState {
    /// Name of its picture.
    pub name: &'static str,
    /// Query of its address, without the language.
    pub query: &'static str,
    /// Element that is there when the state is complete.
    pub there: &'static str,
    /// Shown as on a phone.
    pub is_narrow: bool,
    title: fn(Language) -> &'static str,
}

const fn state(
    name: &'static str,
    query: &'static str,
    there: &'static str,
    title: fn(Language) -> &'static str,
) -> GalleryState {
    GalleryState { name, query, there, is_narrow: false, title }
}

/// States of the page, in the order of a visit.
pub const STATES: [GalleryState; 16] = [
    state("start", "", "#start-title", page::what_do_you_move),
    state("begin", "kind=3", "#begin form", page::first_answer),
    state("cycle", "new=screw", "#plot-cycle", page::view_cycle),
    state("checks", "new=belt&unfolded=true", "#checks", terms::checks),
    state("derivation", "new=belt&check=continuous_torque", "#detail .formula", page::how_it_came_about),
    state("torque-speed", "new=turntable&view=torque_speed", "#plot-torque-speed", page::view_torque_speed),
    state("heat-dark", "new=arm&view=heat&theme=dark", "#plot-heat", page::view_heat),
    state("bearing", "new=arm&view=bearing", "#plot-bearing-load", page::view_bearing),
    state("simulation", "new=arm&view=simulation", "#view figure.plot", page::view_simulation),
    state("why-not", "new=belt&list=rejected", "table.rejected", page::why_not),
    state("map", "new=belt&list=map", "#plot-map", page::map),
    state(
        "compare",
        "new=belt&mark=CHA-14A-50-N-D2048&mark=CHA-14A-50-H-RES",
        "#detail table.compare",
        page::side_by_side,
    ),
    state(
        "nothing-fits",
        "new=arm&do=value+mechanism.arm.mass%3D300+kg&do=value+mechanism.arm.centre_distance%3D800+mm",
        ".remedies h3",
        page::what_would_fit,
    ),
    state("fault", "new=belt&do=value+mechanism.belt.mass%3D60", "#faults li", page::fault_in_the_file),
    state("data-sheet", "new=arm&tool=data&about=CHA-20A-50-H-C1024", "#detail table", page::tool_data),
    GalleryState { is_narrow: true, ..state("phone", "new=arm", "#standing", page::on_a_phone) },
];

const VERDICTS: [Verdict; 4] = [Verdict::Pass, Verdict::Fail, Verdict::Advice, Verdict::NotChecked];

/// Returns the components in a language and a theme.
pub(crate) fn shown(call: &Call<'_>) -> Markup {
    let l = call.language();
    html! {
        (DOCTYPE)
        html lang=(l.id()) data-theme=[(call.theme() == Theme::Dark).then_some("dark")] {
            (crate::frame::head(&html! {}, page::title(l), "/assets/page.css", &html! {}))
            body.gallery {
                main.start {
                    h1 { (page::components(l)) }
                    (section("states", page::states(l), &states(l)))
                    (section("type", page::components_type(l), &type_scale(l)))
                    (section("verdicts", terms::verdict(l), &verdicts(l)))
                    (section("buttons", page::components_buttons(l), &buttons(l)))
                    (section("fields", page::components_fields(l), &fields(l)))
                    (section("tables", terms::checks(l), &table(l)))
                }
            }
        }
    }
}

fn states(language: Language) -> Markup {
    let l = language.id();
    html! { ol { @for state in STATES { li {
        a href={ "/?lang=" (l) @if !state.query.is_empty() { "&" (state.query) } } { (capitalised((state.title)(language))) }
    } } } }
}

fn section(id: &str, title: &str, inside: &Markup) -> Markup {
    html! { section aria-labelledby={ "g-" (id) } { h2 id={ "g-" (id) } { (capitalised(title)) } (inside) } }
}

fn type_scale(language: Language) -> Markup {
    let text = page::start_about(language);
    html! { h2 { (text) } h3 { (text) } h4 { (text) } p { (text) } p.small { (text) } p.formula { "T = J α" } }
}

fn verdicts(language: Language) -> Markup {
    html! {
        p { @for verdict in VERDICTS {
            span class={ "count " (checks::verdict_class(verdict)) } { (verdict_count(verdict, 3, language)) } " "
        } }
        p { @for verdict in VERDICTS { strong class=(checks::verdict_class(verdict)) { (verdict_word(verdict, language)) } " " } }
        p { @for (place, verdict) in VERDICTS.into_iter().enumerate() {
            span class={ "mark-number " (checks::verdict_class(verdict)) } { (place + 1) } " "
        } }
    }
}

fn buttons(language: Language) -> Markup {
    let l = language;
    html! {
        p.bar {
            button type="button" { (page::save(l)) }
            button type="button" aria-pressed="true" { (page::dark(l)) }
            button type="button" disabled { (page::undo(l)) }
            button.small type="button" { (page::copy_svg(l)) }
            button.plain type="button" { "CHA-25A-50-H-C1024" }
            button.icon type="button" aria-label=(page::find(l)) { "⌕" }
        }
        div.views role="group" {
            button type="button" aria-selected="true" role="tab" { (page::view_cycle(l)) }
            button type="button" aria-selected="false" role="tab" { (page::view_heat(l)) }
        }
    }
}

/// Returns a field with a value, empty, faulty, and with a tolerance.
fn fields(language: Language) -> Markup {
    let l = language;
    let path = "load.inertia";
    let Some(key) = key_at(path).filter(|key| matches!(key.kind, Kind::Quantity(..))) else { return html! {} };
    let label = capitalised(terms::mass(l));
    html! {
        div.rows id="moves" {
            @for (place, (text, follows, wrong)) in [("1.3 kg m^2", None, false), ("", None, false), ("", Some("0.25 kg m^2"), false), ("1.3 kg", None, true)].into_iter().enumerate() {
                @let id = format!("g-field-{place}");
                div.row {
                    label for=(id) { (label) }
                    (value::field(key, (&id, path, &label), text, follows, (wrong, "g-fault"), AT_ONCE, l))
                }
            }
            p.fault id="g-fault" { (page::faults(1, l)) }
            label { input type="checkbox" checked; " " (page::with_brake(l)) }
        }
    }
}

fn table(language: Language) -> Markup {
    html! {
        table.checks {
            tbody { @for verdict in VERDICTS {
                tr class=(checks::verdict_class(verdict)) {
                    th scope="row" { span.verdict {} (verdict_word(verdict, language)) }
                    td.number { "12" } td.number { "18" } td { "Nm" }
                    td.number { "66" (checks::bar(0.66, None)) }
                }
            } }
        }
    }
}
