//! The tools next to the project: data of a code, calculators, commissioning, glossary. Each is a question of the list
//! with the question's arguments as fields; faults are shown at the fields.

mod calculators;
mod code;
mod field;
mod inertia;
mod loads;
mod record;
mod scene;

use crate::api::inquiry::read_inquiry;
use crate::api::method;
use crate::call::{Call, Shell, query};
use crate::markup::vals;
use field::{MARK, ToolField, Trouble};
use maud::{Markup, html};
use quantities::Language;
use questions::list::{Entry, Inquiry, Unanswered};
use questions::{Progress, list, read_code};
use scene::{GOOD, IN_VIEW, Scene, fields_of};
use words::{Word, page};

/// A tool: its name in requests, its title, and its answer.
struct Tool {
    id: &'static str,
    title: Word,
    ask: Ask,
}

/// Kind of answer of a tool.
enum Ask {
    /// Data of a code.
    Code(fn(&str, Language) -> Markup),
    /// Explanation of a text.
    About(fn(&str, Language) -> Markup),
    /// A question of the list: the examples of its fields in grey, and the layout of its answer.
    Of(&'static Entry, &'static [(&'static str, &'static str)], Show),
    /// Mounting, under the limits of the manual or under the loads of the open project.
    Mount,
    /// Moment of inertia of bodies.
    Bodies,
    /// Loads on the output bearing.
    Loads,
    /// Judgement of measured values.
    Record,
}

/// Layout of an answer.
type Show = fn(&Inquiry<'_>, &Scene<'_>) -> Result<Markup, Unanswered>;

/// Tools in the order of their use.
const TOOLS: [Tool; 15] = [
    Tool { id: "code", title: page::tool_code, ask: Ask::Code(code::explained) },
    Tool { id: "data", title: page::tool_data, ask: Ask::Code(code::data) },
    Tool { id: "curve", title: page::tool_curve, ask: Ask::Of(&list::curve::ENTRY, &[], calculators::curve) },
    Tool {
        id: "torsion",
        title: page::tool_torsion,
        ask: Ask::Of(&list::torsion::ENTRY, &[("torque", "60 N m")], calculators::torsion),
    },
    Tool { id: "bearing", title: page::tool_bearing, ask: Ask::Loads },
    Tool { id: "inertia", title: page::tool_inertia, ask: Ask::Bodies },
    Tool {
        id: "battery",
        title: page::tool_battery,
        ask: Ask::Of(&list::battery::ENTRY, &[("hours-per-day", "10")], calculators::battery),
    },
    Tool {
        id: "encoder",
        title: page::tool_encoder,
        ask: Ask::Of(&list::encoder::ENTRY, &[("angle", "30 deg")], calculators::encoder),
    },
    Tool { id: "wiring", title: page::tool_wiring, ask: Ask::Of(&list::wiring::ENTRY, &[], calculators::wiring) },
    Tool { id: "mount", title: page::tool_mount, ask: Ask::Mount },
    Tool {
        id: "commission",
        title: page::tool_commission,
        ask: Ask::Of(&list::commission::ENTRY, &[], calculators::commission),
    },
    Tool { id: "record", title: page::tool_record, ask: Ask::Record },
    Tool { id: "upkeep", title: page::tool_upkeep, ask: Ask::Of(&list::upkeep::ENTRY, &[], calculators::upkeep) },
    Tool { id: "errata", title: page::tool_errata, ask: Ask::About(code::errata) },
    Tool { id: "glossary", title: page::tool_glossary, ask: Ask::About(code::words) },
];

/// Returns the pane of the tools: the requested tool and its subject.
pub(crate) fn pane(call: &Call<'_>, shell: &dyn Shell, progress: &Progress) -> Markup {
    let l = call.language();
    let inquiry = call.field("tool").unwrap_or_default();
    let Some(tool) = TOOLS.iter().find(|tool| tool.id == inquiry).or(TOOLS.first()) else { return html! {} };
    let scene = Scene::of(call, tool.id, shell, progress);
    let needs_code = tool.needs_code();
    let about = if needs_code { page::tool_code(l) } else { (tool.title)(l) };
    let shown = match &tool.ask {
        // Only what the checks need is known of it.
        _ if needs_code && scene.is_about_a_product_of_a_file() => {
            html! { p.unchecked id="tool-answer" { (page::tool_of_codes_only(&scene.about, l)) } }
        }
        Ask::Code(say) | Ask::About(say) => html! { (say(&scene.about, l)) (scene.link(&[])) },
        Ask::Record => record::shown(&scene),
        Ask::Loads => loads::shown(&scene),
        Ask::Bodies => inertia::shown(&scene),
        Ask::Mount => mounted(&scene),
        Ask::Of(entry, examples, show) => {
            // The twist of the axis is that under its peak torque.
            let peak = if tool.id == "torsion" { scene.torque_peak() } else { None };
            let first: Vec<(&str, &str)> = peak.iter().map(|peak| ("torque", peak.as_str())).collect();
            of(&scene, &Question { entry, first: &first, examples, show: *show, own: None, body: &[] })
        }
    };
    if scene.is_in_view {
        let follows = matches!(tool.ask, Ask::Mount).then_some("");
        return html! {
            form id="tool-view" data-follows=[follows] method="get" action="/" hx-post="/tools" hx-target="#tool-view" hx-select="#tool-view" hx-swap="outerMorph"
                hx-sync="this:replace" hx-include="#state, [form=state]" hx-trigger="input delay:80ms, change, submit, antrieb:again" {
                @for (name, value) in [("tool", tool.id), ("asked", tool.id), ("within", IN_VIEW), ("about", &scene.about)] { input type="hidden" name=(name) value=(value); }
                (shown)
            }
        };
    }
    let of_actuator = |tool: &&Tool| tool.needs_code() || tool.id == "errata";
    let groups = [(page::tools_of_actuator(l), true), (page::tools_in_general(l), false)];
    let inside = html! {
        div.toolbox {
        nav.kinds aria-label=(page::tools(l)) {
            @for (title, is_of_actuator) in groups {
                h3 { (title) }
                ul.plain { @for other in TOOLS.iter().filter(|tool| of_actuator(tool) == is_of_actuator) {
                    li { button.plain type="button" aria-pressed=(other.id == tool.id) hx-post="/tools" hx-target="#detail" hx-swap="innerHTML"
                        hx-include="#state, [form=state], #about" hx-vals=(vals(&[("tool", other.id)])) { ((other.title)(l)) } }
                } }
            }
        }
        form id="tool" method="get" action="/" hx-post="/tools" hx-target="#tool" hx-select="#tool" hx-swap="outerMorph" hx-sync="this:replace"
            hx-include="#state, [form=state]" hx-trigger="input delay:80ms, change, submit" {
            input type="hidden" name="tool" value=(tool.id);
            input type="hidden" name="asked" value=(tool.id);
            @if needs_code || matches!(tool.ask, Ask::About(_)) {
                div.row {
                    label for="about" { (about) }
                    input id="about" name="about" type="text" value=(scene.about) autocomplete="off" spellcheck="false";
                }
            } @else {
                input id="about" name="about" type="hidden" value=(scene.about);
            }
            (shown)
        }
        }
    };
    crate::markup::drawer(page::tools(l), &inside, l)
}

impl Tool {
    /// Returns `true` if the tool is about a code.
    fn needs_code(&self) -> bool {
        match &self.ask {
            Ask::Of(entry, ..) => takes_a_code(entry),
            Ask::Code(_) | Ask::Record | Ask::Mount => true,
            Ask::About(_) | Ask::Loads | Ask::Bodies => false,
        }
    }
}

/// Returns `true` if a question is about an ordering code.
fn takes_a_code(entry: &Entry) -> bool {
    entry.arguments.iter().any(|argument| argument.name == "code")
}

/// A question of the list.
struct Question<'q> {
    entry: &'static Entry,
    /// Initial values.
    first: &'q [(&'q str, &'q str)],
    /// Examples of values, shown in grey.
    examples: &'q [(&'q str, &'q str)],
    show: Show,
    /// Field of the page that the interface does not have.
    own: Option<ToolField>,
    body: &'q [u8],
}

/// Field that selects the loads of the project.
const UNDER_PROJECT: &str = "project";

/// Returns the mounting; without a project, or without its loads, under the limits of the manual.
fn mounted(scene: &Scene<'_>) -> Markup {
    let text = scene.call.field("text").unwrap_or_default();
    let own = || ToolField::new(UNDER_PROJECT, page::under_project(scene.language), field::FieldEntry::Mark);
    // In the work frame the loads are those of the axis, until the field says otherwise.
    let is_under = scene.typed(UNDER_PROJECT).map_or(scene.is_in_view, |value| value == "true") && !text.is_empty();
    let (entry, show): (&Entry, Show) = if is_under {
        (&list::mount_project::ENTRY, calculators::mount_in_project)
    } else {
        (&list::mount::ENTRY, calculators::mount)
    };
    let own = (!text.is_empty()).then(own);
    let body = if is_under { text.as_bytes() } else { &[] };
    let first: &[(&str, &str)] = if scene.is_in_view { &[(UNDER_PROJECT, "true")] } else { &[] };
    of(scene, &Question { entry, first, examples: &[], show, own, body })
}

/// Returns a question as fields, with its answer below them.
fn of(scene: &Scene<'_>, question: &Question<'_>) -> Markup {
    let l = scene.language;
    let Question { entry, first, examples, show, own, body } = question;
    let mut fields: Vec<ToolField> =
        entry.arguments.iter().filter_map(|each| ToolField::of_argument(each, l)).collect();
    fields.extend(own.clone());
    for field in &mut fields {
        let usual = || first.iter().find(|(name, _)| *name == field.name).map(|(_, value)| (*value).to_owned());
        field.value = scene.typed(&field.name).unwrap_or_else(|| usual().unwrap_or_default());
        let example = examples.iter().find(|(name, _)| *name == field.name);
        field.ghost = example.map(|(_, value)| page::for_example(&crate::value::said(value, l), l));
    }
    let needs_code = takes_a_code(entry);
    if needs_code && let Err(fault) = read_code(&scene.about, l) {
        return html! { (fields_of(&fields, l)) div id="tool-answer" { (code::incomplete(&scene.about, &fault, l)) } };
    }
    let axis = scene.axis().filter(|_| !body.is_empty());
    let said = [("code", Some(scene.about.as_str()).filter(|_| needs_code)), ("axis", axis.as_deref())];
    let query = query_of(&said, &fields, l);
    let answer_to = |query: &str| {
        let call = Call { method: method(entry), path: entry.path, query, media: None, body, ..*scene.call };
        read_inquiry(entry, &call, scene.shell, scene.progress).and_then(|inquiry| show(&inquiry, scene))
    };
    let answer = answer_to(&query);
    let good = match &answer {
        Ok(_) => query,
        Err(_) => scene.typed(GOOD).unwrap_or_default(),
    };
    let troubles: Vec<Trouble> = match &answer {
        Err(unanswered) => field::with_arithmetic(&fields, field::troubles(unanswered, l), l),
        Ok(_) => Vec::new(),
    };
    let awaited = field::awaited(&fields, &troubles, scene.is_filled);
    let loose = field::at_their_fields(&mut fields, troubles, scene.is_filled);
    let old = if answer.is_err() && !good.is_empty() { answer_to(&good).ok() } else { None };
    let state: Vec<(&str, &str)> = fields.iter().map(|field| (field.name.as_str(), field.value.as_str())).collect();
    html! {
        input type="hidden" name={ (MARK) (GOOD) } value=(good);
        (fields_of(&fields, l))
        @for trouble in &loose { (trouble.shown(l)) }
        div id="tool-answer" aria-live="polite" class=[old.is_some().then_some("old")] {
            @match (&answer, &old) {
                (Ok(answer), _) => (answer),
                (_, Some(old)) => { p.advice { (page::answer_is_old(l)) } (old) },
                _ if !awaited.is_empty() => p.small { (page::tool_awaits(l)) " " (awaited.join(", ")) },
                _ => {},
            }
        }
        (scene.link(&state))
    }
}

/// Returns the question as the query that a client of the interface sends.
fn query_of(said: &[(&str, Option<&str>)], fields: &[ToolField], language: Language) -> String {
    let said = said.iter().filter_map(|(name, value)| Some((*name, (*value)?)));
    let inquiry = fields.iter().filter(|field| field.name != UNDER_PROJECT);
    let typed: Vec<(&str, String)> = inquiry
        .flat_map(|field| field.values().map(|value| (field.name.as_str(), field.computed(value, language))))
        .collect();
    let typed = typed.iter().map(|(name, value)| (*name, value.as_str()));
    query(said.chain(typed).chain([("lang", language.id())]))
}
