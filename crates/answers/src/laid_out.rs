//! An answer laid out: what a terminal, a page or a sheet of paper shows of it, in its order, in one language.
//!
//! The records stay the answer; this is one way to read them aloud, made once for all who show them.

use serde::Serialize;

/// A part of a document with a heading.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Chapter {
    /// Its heading.
    pub title: String,
    /// What stands in it.
    pub blocks: Vec<Block>,
}

/// What stands in a chapter.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Block {
    /// A heading within the chapter.
    Section {
        /// Its text.
        text: String,
    },
    /// A paragraph.
    Text {
        /// Its text.
        text: String,
    },
    /// Sentences that stand side by side.
    Points {
        /// One each.
        items: Vec<String>,
    },
    /// Steps in their order, numbered from 1.
    Steps {
        /// One each.
        items: Vec<String>,
    },
    /// A table.
    Grid(Grid),
    /// Hazards and rules, gravest first.
    Hazards {
        /// One each.
        items: Vec<Hazard>,
    },
    /// A picture.
    Picture(Picture),
    /// What is to be done and ticked off.
    Tasks {
        /// One each.
        items: Vec<Task>,
    },
}

/// A table of texts.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Grid {
    /// Its columns.
    pub columns: Vec<Column>,
    /// Its rows, a cell for each column.
    pub rows: Vec<Vec<String>>,
}

/// The head of a column.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Column {
    /// What stands above it.
    pub head: String,
    /// Whether its cells are numbers and stand on the right.
    pub numbers: bool,
    /// Whether its cells may be sentences and take the room that is left.
    pub wide: bool,
}

/// A hazard or a rule.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Hazard {
    /// `danger`, `warning`, `caution`, `notice`, `info`; empty for a plain statement.
    pub level: &'static str,
    /// The signal word in the language; empty for a plain statement.
    pub word: &'static str,
    /// What it says.
    pub text: String,
    /// Where it stands.
    pub source: String,
}

/// A picture.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Picture {
    /// It, as SVG.
    pub svg: String,
    /// The line below it.
    pub caption: String,
    /// Description of the picture, for screen readers.
    pub alternative_text: String,
}

/// An entry of a check-list.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Task {
    /// What is to be done; a hazard has its signal word.
    pub what: Hazard,
    /// What is expected, with unit; empty where there is nothing to measure.
    pub expected: String,
    /// Unit of what is written down; none: nothing is.
    pub unit: Option<String>,
}

impl Column {
    /// A column of short texts.
    #[must_use]
    pub fn text(head: impl Into<String>) -> Self {
        Self { head: head.into(), numbers: false, wide: false }
    }

    /// A column of numbers.
    #[must_use]
    pub fn numbers(head: impl Into<String>) -> Self {
        Self { head: head.into(), numbers: true, wide: false }
    }

    /// A column of sentences.
    #[must_use]
    pub fn wide(head: impl Into<String>) -> Self {
        Self { head: head.into(), numbers: false, wide: true }
    }
}

impl Block {
    fn texts(&self) -> Vec<&str> {
        match self {
            Self::Section { text } | Self::Text { text } => vec![text],
            Self::Points { items } | Self::Steps { items } => items.iter().map(String::as_str).collect(),
            Self::Grid(grid) => {
                let heads = grid.columns.iter().map(|column| column.head.as_str());
                heads.chain(grid.rows.iter().flatten().map(String::as_str)).collect()
            }
            Self::Hazards { items } => items.iter().flat_map(|item| [item.text.as_str(), &item.source]).collect(),
            Self::Picture(picture) => vec![&picture.caption],
            Self::Tasks { items } => {
                items.iter().flat_map(|task| [task.what.text.as_str(), &task.what.source]).collect()
            }
        }
    }
}

impl Chapter {
    /// A chapter without anything in it.
    #[must_use]
    pub fn new(title: impl Into<String>) -> Self {
        Self { title: title.into(), blocks: Vec::new() }
    }

    /// Adds a heading.
    pub fn section(&mut self, text: impl Into<String>) {
        self.blocks.push(Block::Section { text: text.into() });
    }

    /// Every text of the chapter, in its order.
    pub fn texts(&self) -> impl Iterator<Item = &str> {
        self.blocks.iter().flat_map(Block::texts)
    }

    /// Adds a paragraph; an empty one is left out.
    pub fn text(&mut self, text: impl Into<String>) {
        let text = text.into();
        self.add(text.is_empty(), Block::Text { text });
    }

    /// Adds what is not empty.
    fn add(&mut self, is_empty: bool, block: Block) {
        if !is_empty {
            self.blocks.push(block);
        }
    }

    /// Adds sentences side by side, if there are any.
    pub fn points(&mut self, items: Vec<String>) {
        self.add(items.is_empty(), Block::Points { items });
    }

    /// Adds numbered steps, if there are any.
    pub fn steps(&mut self, items: Vec<String>) {
        self.add(items.is_empty(), Block::Steps { items });
    }

    /// Adds a table, if it has rows.
    pub fn grid(&mut self, columns: Vec<Column>, rows: Vec<Vec<String>>) {
        self.add(rows.is_empty(), Block::Grid(Grid { columns, rows }));
    }

    /// Adds hazards and rules, if there are any.
    pub fn hazards(&mut self, items: Vec<Hazard>) {
        self.add(items.is_empty(), Block::Hazards { items });
    }

    /// Adds entries of a check-list, if there are any.
    pub fn tasks(&mut self, items: Vec<Task>) {
        self.add(items.is_empty(), Block::Tasks { items });
    }
}
