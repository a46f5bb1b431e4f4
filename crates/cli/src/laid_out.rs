//! Layout of a chapter on the terminal.

use crate::table::{Align, TextTable, paragraph};
use answers::{Block, Chapter, Grid, Hazard, Task};
use quantities::Language;
use words::commission;

/// Returns the chapter as text, no line wider than the terminal; pictures are written only on request.
pub(crate) fn shown(chapter: &Chapter, language: Language) -> String {
    let mut out = paragraph("", &chapter.title);
    let mut before = None;
    for block in &chapter.blocks {
        if matches!(block, Block::Section { .. }) || needs_room(before, block) {
            out.push('\n');
        }
        out.push_str(&block_text(block, language));
        before = Some(block);
    }
    out
}

/// Returns the chapter as text, with the name of the file written for it.
pub(crate) fn with_file(chapter: &Chapter, file: Option<&str>, language: Language) -> String {
    let text = shown(chapter, language);
    file.map_or_else(|| text.clone(), |file| format!("{text}\n{file}\n"))
}

/// Returns `true` if an empty line separates two blocks: below a table, which has no visible end.
const fn needs_room(before: Option<&Block>, block: &Block) -> bool {
    matches!((before, block), (Some(Block::Grid(_)), Block::Text { .. } | Block::Grid(_)))
}

fn block_text(block: &Block, language: Language) -> String {
    match block {
        Block::Section { text } | Block::Text { text } => paragraph("", text),
        Block::Points { items } => items.iter().map(|item| paragraph("- ", item)).collect(),
        Block::Steps { items } => {
            (1..).zip(items).map(|(number, item)| paragraph(&format!("{number:>2}. "), item)).collect()
        }
        Block::Grid(grid) => grid_text(grid),
        Block::Hazards { items } => hazards(items),
        Block::Picture(_) => String::new(),
        Block::Tasks { items } => items.iter().map(|item| task(item, language)).collect(),
    }
}

fn grid_text(grid: &Grid) -> String {
    let align = |numbers| if numbers { Align::Right } else { Align::Left };
    let mut table = TextTable::new(grid.columns.iter().map(|column| (&column.head, align(column.numbers))));
    for row in &grid.rows {
        table.row(row.as_slice());
    }
    table.render()
}

/// Returns hazards and rules one below the other, with their texts next to their signal words.
fn hazards(items: &[Hazard]) -> String {
    let widest = items.iter().map(|item| item.word.chars().count()).max().unwrap_or(0);
    let line =
        |item: &Hazard| paragraph(&format!("{:<widest$}  ", item.word), &format!("{} ({})", item.text, item.source));
    items.iter().map(line).collect()
}

fn task(item: &Task, language: Language) -> String {
    let word = if item.what.word.is_empty() { String::new() } else { format!("{}: ", item.what.word) };
    let expected = match (item.expected.is_empty(), item.unit.is_some()) {
        (true, _) => String::new(),
        (false, true) => format!(": {} {}", commission::expected(language), item.expected),
        (false, false) => format!(": {}", item.expected),
    };
    let field =
        if item.unit.is_some() { format!("  {} ________", commission::measured(language)) } else { String::new() };
    paragraph("[ ] ", &format!("{word}{}{expected} ({}){field}", item.what.text, item.what.source))
}
