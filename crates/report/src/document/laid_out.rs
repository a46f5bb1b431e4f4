//! Chapters of the answers in the form of the template: units tied to their numbers, pictures as names of files.

use super::shown::tied;
use answers::{Block, Chapter, Column, Grid, Hazard, Task};
use serde::Serialize;
use words::capitalised;

#[derive(Serialize)]
pub(super) struct LaidOut {
    title: String,
    blocks: Vec<Placed>,
}

#[derive(Serialize)]
#[serde(untagged)]
enum Placed {
    Block(Block),
    Picture {
        kind: &'static str,
        file: String,
        /// `true` if the picture takes the width of the text; otherwise it takes that of a column, so that its letters
        /// keep their size.
        is_wide: bool,
        caption: String,
        alternative: String,
    },
}

/// Width of a picture beside another one \[mm\].
const COLUMN_MM: f64 = 81.0;

/// Returns the width that a picture states \[mm\].
fn width_mm(svg: &str) -> Option<f64> {
    svg.split_once("width=\"")?.1.split_once("mm\"")?.0.parse().ok()
}

/// Returns the name by which the template finds a picture of the chapters of an axis.
pub(crate) fn picture_file(axis: usize, index: usize) -> String {
    format!("chapter-{axis}-{index}.svg")
}

/// Iterates over the pictures of chapters, in the order of their names.
#[cfg(feature = "pdf")]
pub(crate) fn pictures(chapters: &[Chapter]) -> impl Iterator<Item = &answers::Picture> {
    chapters.iter().flat_map(|chapter| &chapter.blocks).filter_map(|block| match block {
        Block::Picture(picture) => Some(picture),
        _ => None,
    })
}

/// Returns the chapters of an axis in the form of the template.
pub(super) fn laid_out(axis: usize, chapters: &[Chapter]) -> Vec<LaidOut> {
    let mut index = 0;
    let mut placed = |block: &Block| match block {
        Block::Picture(picture) => {
            let file = picture_file(axis, index);
            index += 1;
            Placed::Picture {
                kind: "picture",
                file,
                is_wide: width_mm(&picture.svg).is_some_and(|width| width > COLUMN_MM),
                caption: tied(&picture.caption),
                alternative: picture.alternative_text.clone(),
            }
        }
        other => Placed::Block(capitalised_block(other)),
    };
    let one = |chapter: &Chapter| LaidOut {
        title: chapter.title.clone(),
        blocks: chapter.blocks.iter().map(&mut placed).collect(),
    };
    chapters.iter().map(one).collect()
}

fn capitalised_block(block: &Block) -> Block {
    let all = |items: &[String]| items.iter().map(|item| tied(item)).collect();
    let hazard = |item: &Hazard| Hazard { text: tied(&item.text), ..item.clone() };
    match block {
        Block::Section { text } => Block::Section { text: tied(text) },
        Block::Text { text } => Block::Text { text: tied(&capitalised(text)) },
        Block::Points { items } => Block::Points { items: all(items) },
        Block::Steps { items } => Block::Steps { items: all(items) },
        Block::Grid(grid) => {
            // A heading begins with a capital, as everywhere in the report.
            let column = |column: &Column| Column { head: capitalised(&column.head), ..column.clone() };
            Block::Grid(Grid {
                columns: grid.columns.iter().map(column).collect(),
                rows: grid.rows.iter().map(|row| all(row)).collect(),
            })
        }
        Block::Hazards { items } => Block::Hazards { items: items.iter().map(hazard).collect() },
        Block::Tasks { items } => {
            let task = |item: &Task| Task { what: hazard(&item.what), expected: tied(&item.expected), ..item.clone() };
            Block::Tasks { items: items.iter().map(task).collect() }
        }
        Block::Picture(picture) => Block::Picture(picture.clone()),
    }
}
