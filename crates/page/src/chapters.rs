//! Chapters as HTML.

use answers::{Block, Chapter, Grid, Hazard};
use maud::{Markup, PreEscaped, html};
use words::{capitalised, symbol_shown};

/// Returns a symbol with its subscript as HTML.
pub(crate) fn symbol(symbol: &str) -> Markup {
    let shown = symbol_shown(symbol);
    html! { @match shown.split_once('_') {
        Some((head, tail)) => { (head) sub { (tail.replace('_', ",")) } }
        None => { (shown) }
    } }
}

/// Returns a sentence as HTML, its symbols such as `T_max` with their subscripts.
pub(crate) fn with_symbols(text: &str) -> Markup {
    let is_of_a_symbol = |sign: char| sign.is_alphanumeric() || sign == '_';
    html! { @for piece in text.split_inclusive(|sign| !is_of_a_symbol(sign)) {
        @let (word, rest) = piece.split_at(piece.trim_end_matches(|sign| !is_of_a_symbol(sign)).len());
        @if word.contains('_') { i { (symbol(word)) } } @else { (word) }
        (rest)
    } }
}

/// Returns a chapter as HTML.
pub(crate) fn laid_out(chapter: &Chapter) -> Markup {
    html! {
        h3 { (chapter.title) }
        @for block in &chapter.blocks { (block_of(block)) }
    }
}

/// Returns a chapter with each section in a fold, without its title and without the sections of these names.
pub(crate) fn folded(chapter: &Chapter, name: &str, without: &[&str]) -> Markup {
    let is_section = |block: &Block| matches!(block, Block::Section { .. });
    let mut rest = chapter.blocks.as_slice();
    let before = rest.iter().position(is_section).unwrap_or(rest.len());
    let (first, mut sections) = rest.split_at(before);
    let mut parts: Vec<(&str, &[Block])> = Vec::new();
    while let Some((Block::Section { text }, inside)) = sections.split_first() {
        let end = inside.iter().position(is_section).unwrap_or(inside.len());
        (rest, sections) = inside.split_at(end);
        parts.push((text, rest));
    }
    let is_shown = |title: &str| !without.iter().any(|other| capitalised(other) == title);
    html! {
        @for block in first { (block_of(block)) }
        @for (place, (title, blocks)) in parts.iter().enumerate().filter(|(_, (title, _))| is_shown(title)) {
            details.subject id={ (name) "-" (place) } { summary { (title) } @for block in *blocks { (block_of(block)) } }
        }
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
        Block::Picture(picture) => figure.plot { (PreEscaped(&picture.svg)) figcaption { (with_symbols(&picture.caption)) } },
        Block::Tasks { items } => ul.tasks { @for item in items { li {
            (hazard(&item.what))
            @if !item.expected.is_empty() { " " span.expected { (item.expected) } }
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
