//! Answers that are laid out already, and the tools around an ordering code.

use crate::call::Call;
use crate::form::vals;
use maud::{Markup, PreEscaped, html};
use workbench::answers::{Block, Chapter, Grid, Hazard};
use workbench::text::{Word, capitalised, describe_field, describe_uncovered, page, symbol_shown, terminal, terms};
use workbench::{
    CodeRefusal, DriveForm, Language, MountAsked, OrderCode, UpkeepAsked, answer, chapter, commission, completion,
    errata_about, explain_code, glossary, list_codes, mount, read_code, read_date, read_pattern, sheet, uncovered,
    upkeep, usual_ambient, wiring,
};

/// A symbol with its index below the line.
pub(crate) fn symbol(symbol: &str) -> Markup {
    let shown = symbol_shown(symbol);
    html! { @match shown.split_once('_') {
        Some((head, tail)) => { (head) sub { (tail) } }
        None => { (shown) }
    } }
}

/// A chapter as HTML.
pub(crate) fn laid_out(chapter: &Chapter) -> Markup {
    html! {
        h3 { (chapter.title) }
        @for block in &chapter.blocks { (block_of(block)) }
    }
}

fn block_of(block: &Block) -> Markup {
    html! { @match block {
        Block::Section { text } => h4 { (text) },
        Block::Text { text } => p { (text) },
        Block::Points { items } => ul { @for item in items { li { (item) } } },
        Block::Steps { items } => ol { @for item in items { li { (item) } } },
        Block::Grid(grid) => (table(grid)),
        Block::Hazards { items } => div.hazards { @for item in items { (hazard(item)) } },
        Block::Picture(picture) => figure.plot { (PreEscaped(&picture.svg)) figcaption { (picture.caption) } },
        Block::Tasks { items } => ul.tasks { @for item in items { li {
            label { input type="checkbox"; " " (hazard(&item.what)) }
            @if !item.expected.is_empty() { " " span.expected { (item.expected) } }
            @if let Some(unit) = &item.unit { " " input.measured type="text" size="8" aria-label=(item.what.text); " " (unit) }
        } } },
    } }
}

fn hazard(item: &Hazard) -> Markup {
    html! { span class={ "hazard " (item.level) } {
        @if !item.word.is_empty() { strong { (item.word) } " " }
        (item.text) @if !item.source.is_empty() { " " span.source { "[" (item.source) "]" } }
    } }
}

fn table(grid: &Grid) -> Markup {
    let number = |place: usize| grid.columns.get(place).is_some_and(|column| column.numbers);
    html! { div.wide tabindex="0" {
        table {
            thead { tr { @for column in &grid.columns { th scope="col" { (column.head) } } } }
            tbody { @for row in &grid.rows { tr { @for (place, cell) in row.iter().enumerate() { td class=[number(place).then_some("number")] { (cell) } } } } }
        }
    } }
}

/// So many codes are proposed for a beginning of one.
const PROPOSED: usize = 12;

/// The tools, in the order of their use.
const TOOLS: [(&str, Word); 8] = [
    ("code", page::tool_code),
    ("data", page::tool_data),
    ("wiring", page::tool_wiring),
    ("mount", page::tool_mount),
    ("commission", page::tool_commission),
    ("upkeep", page::tool_upkeep),
    ("errata", page::tool_errata),
    ("glossary", page::tool_glossary),
];

/// The tools around a code: which of them is asked for, about what.
pub(crate) fn tools(call: &Call<'_>) -> Markup {
    let l = call.language();
    let field = |name: &str| call.field(name).map(std::borrow::Cow::into_owned).unwrap_or_default();
    let (tool, typed) = (field("tool"), field("about"));
    let (tool, typed) =
        (if tool.is_empty() { "code" } else { &tool }, if typed.is_empty() { field("code") } else { typed });
    let code = read_code(&typed, l);
    let inside = html! {
        nav.kinds aria-label=(page::tools(l)) {
            @for (id, title) in TOOLS {
                button type="button" aria-pressed=(id == tool) hx-post="/tools" hx-target="#detail" hx-swap="innerHTML"
                    hx-include="#state, [form=state], #about" hx-vals=(vals(&[("tool", id)])) { (title(l)) }
            }
        }
        p {
            label for="about" { @if tool == "glossary" { (page::tool_glossary(l)) } @else { (page::tool_code(l)) } " " }
            input id="about" name="about" type="text" size="36" value=(typed) autocomplete="off" spellcheck="false"
                hx-post="/tools" hx-target="#tool" hx-select="#tool" hx-swap="outerMorph" hx-include="#state, [form=state], #tool-fields"
                hx-trigger="input changed delay:80ms, change" hx-vals=(vals(&[("tool", tool)]));
        }
        div id="tool" {
            @match (tool, &code) {
                ("glossary", _) => (words(&typed, l)),
                ("code", Ok(reading)) => (code_explained(&reading.parsed.code, l)),
                ("code", Err(fault)) => (incomplete(&typed, fault, l)),
                (_, Err(fault)) => (incomplete(&typed, fault, l)),
                (_, Ok(reading)) => (about(tool, &reading.parsed.code, call, l)),
            }
        }
    };
    crate::detail::frame(page::tools(l), &inside, l)
}

fn about(tool: &str, code: &OrderCode, call: &Call<'_>, language: Language) -> Markup {
    let l = language;
    let none = || html! { p.unchecked { (terminal::no_data(l)) } };
    match tool {
        "data" => data(code, l),
        "errata" => errata(code, l),
        "wiring" => {
            let Some(found) = wiring(code) else { return none() };
            let drawn = found.connectors.iter().filter(|connector| !connector.pins.is_empty());
            let drawings: Vec<Markup> = drawn
                .map(|connector| {
                    let drawing = figures::mating_face(code, connector, l);
                    let style = figures::Style::new(drawing.size()).language(l).id(connector.role.id());
                    html! { figure.plot.small { (PreEscaped(drawing.render(&style).into_svg())) figcaption { (drawing.caption) } } }
                })
                .collect();
            html! { div.faces { @for each in &drawings { (each) } } (laid_out(&chapter::wiring(&answer::wiring(&found, None, l), Vec::new(), l))) }
        }
        "mount" => {
            let asked = MountAsked::default();
            let Some(found) = mount(code, &asked) else { return none() };
            laid_out(&chapter::mount(&answer::mount(&found, &asked, None, l), l))
        }
        "commission" => {
            let Some(found) = commission(code) else { return none() };
            let form = call.field("for").and_then(|form| DriveForm::of_id(&form)).unwrap_or(DriveForm::Plain);
            let objects = if form == DriveForm::Cia402 { answer::drive_objects(&found, l) } else { Vec::new() };
            laid_out(&chapter::commission(&answer::commissioning(&found, form, usual_ambient(), l), &objects, l))
        }
        _ => plan(code, call, l),
    }
}

fn plan(code: &OrderCode, call: &Call<'_>, language: Language) -> Markup {
    let l = language;
    let typed = call.field("delivered").map(std::borrow::Cow::into_owned).unwrap_or_default();
    let asked = read_date(&typed, l).map(|delivered| UpkeepAsked {
        delivered,
        storage: None,
        hours_per_day: None,
        inspect: None,
        today: None,
    });
    html! {
        p id="tool-fields" {
            label for="delivered" { (page::delivered_on(l)) " " }
            input id="delivered" name="delivered" type="date" value=(typed) hx-post="/tools" hx-target="#tool" hx-select="#tool"
                hx-swap="outerMorph" hx-include="#state, [form=state], #about" hx-trigger="change" hx-vals=(vals(&[("tool", "upkeep")]));
        }
        @match asked {
            Ok(asked) => { @match upkeep(code, &asked, l) {
                Ok(found) => (laid_out(&chapter::upkeep(&answer::upkeep(&found, l), l))),
                Err((_, message, hint)) => p.fault { (message) @if let Some(hint) = hint { " – " (hint) } },
            } }
            Err((message, _)) => { @if !typed.is_empty() { p.fault { (message) } } }
        }
    }
}

fn code_explained(code: &OrderCode, language: Language) -> Markup {
    let l = language;
    html! {
        p { strong { (code) } }
        table {
            thead { tr { @for head in [terminal::field(l), terminal::token(l), terminal::meaning(l)] { th scope="col" { (capitalised(head)) } } } }
            tbody { @for (field, token, meaning) in explain_code(code, l) { tr { th scope="row" { (describe_field(field, l)) } td { (token) } td { (meaning) } } } }
        }
        @for what in uncovered(code) { p.unchecked { (describe_uncovered(what, l)) } }
    }
}

/// Why a text is no code, what it could become, and the nearest that are.
fn incomplete(typed: &str, fault: &CodeRefusal, language: Language) -> Markup {
    let l = language;
    let pattern = read_pattern(typed, l).ok();
    html! {
        @if let Some(pattern) = &pattern {
            @for (_, name, choices) in completion(pattern, l) {
                p { (capitalised(name)) ": " @for choice in &choices { span.token { (choice.token) @if !choice.available { " (" (terms::on_request(l)) ")" } } " " } }
            }
            ul.rejected { @for (code, found) in list_codes(Some(pattern)).iter().take(PROPOSED) { li {
                button.plain type="button" data-into="about" value=(code) { (code) } @if !found.is_available() { " " (terms::on_request(l)) }
            } } }
        } @else {
            @for each in &fault.faults { p.fault { (each.message) @if let Some(hint) = &each.hint { " – " (hint) } } }
        }
        @if !fault.nearest.is_empty() {
            p { (capitalised(terminal::nearest_valid_codes(l))) ": " }
            ul.rejected { @for (code, found) in &fault.nearest { li {
                button.plain type="button" data-into="about" value=(code) { (code) } @if !found.is_available() { " " (terms::on_request(l)) }
            } } }
        }
    }
}

fn data(code: &OrderCode, language: Language) -> Markup {
    let l = language;
    let Some(found) = sheet(code) else { return html! { p.unchecked { (terminal::no_data(l)) } } };
    let record = answer::sheet(&found, l);
    html! {
        @for note in &record.notes { p { (note) } }
        @for section in &record.sections {
            h4 { (section.title) }
            div.wide tabindex="0" { table {
                thead { tr { @for head in [terms::value(l), terms::unit(l), terms::grade(l), terms::source(l)] { th scope="col" { (capitalised(head)) } } } }
                tbody { @for value in &section.values { tr {
                    th scope="row" title=(value.name) { (symbol(value.symbol)) " " span.small { (value.name) " " (value.condition) } }
                    td.number { (value.printed) @for id in value.errata { " " span.advice { "[" (id) "]" } } }
                    td { (value.unit) }
                    td { (workbench::text::grade_word(*value.grade, l)) " · " (value.table) }
                } } }
            } }
        }
    }
}

fn errata(code: &OrderCode, language: Language) -> Markup {
    let Ok(found) = errata_about(Some(&code.to_string()), language) else { return html! { p { "–" } } };
    let record = answer::errata(&found, language);
    html! { dl { @for each in &record.errata {
        dt { (each.id) ": " (each.place) }
        dd { (each.printed) " → " (each.corrected) " " (each.unit) br; span.small { (each.evidence) } }
    } } }
}

fn words(typed: &str, language: Language) -> Markup {
    let wanted = (!typed.starts_with("CHA")).then_some(typed);
    match glossary(wanted, language) {
        Ok(found) => html! { dl {
            @for word in &found.words { dt { (word.en) " · " (word.de) } dd { (word.meaning) } }
            @for term in &found.terms { dt { (symbol(&term.symbol)) } dd { (term.en) " · " (term.de) @if !term.unit.is_empty() { " [" (term.unit) "]" } } }
            @for sign in &found.symbols { dt { (symbol(&sign.symbol)) } dd { (sign.en) " · " (sign.de) } }
        } },
        Err(nearest) => html! { p { (nearest.join(", ")) } },
    }
}
