//! Layout of an answer for terminal, page or paper: its parts in order, in one language.
//!
//! The records stay the answer; the layout is one presentation of them, made once for all faces.

use serde::Serialize;

/// A part of a document with a heading.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Chapter {
    /// Heading.
    pub title: String,
    /// Content in order.
    pub blocks: Vec<Block>,
}

/// Part of a chapter.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Block {
    /// A heading within the chapter.
    Section {
        /// Text of the heading.
        text: String,
    },
    /// A paragraph.
    Text {
        /// Text of the paragraph.
        text: String,
    },
    /// Independent sentences.
    Points {
        /// One sentence per entry.
        items: Vec<String>,
    },
    /// Steps in order, numbered from 1.
    Steps {
        /// One step per entry.
        items: Vec<String>,
    },
    /// A table.
    Grid(Grid),
    /// Hazards and rules, the gravest first.
    Hazards {
        /// One hazard or rule per entry.
        items: Vec<Hazard>,
    },
    /// A picture.
    Picture(Picture),
    /// Tasks to be ticked off.
    Tasks {
        /// One task per entry.
        items: Vec<Task>,
    },
}

/// A table of texts.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Grid {
    /// Columns of the table.
    pub columns: Vec<Column>,
    /// Rows with a cell for each column.
    pub rows: Vec<Vec<String>>,
}

/// The head of a column.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Column {
    /// Heading of the column.
    pub head: String,
    /// `true` if the cells are numbers, aligned right.
    pub numbers: bool,
    /// `true` if the cells may be sentences and take the remaining width.
    pub wide: bool,
}

/// A hazard or a rule.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Hazard {
    /// `danger`, `warning`, `caution`, `notice`, `info`; empty for a plain statement.
    pub level: &'static str,
    /// Signal word in the language; empty for a plain statement.
    pub word: &'static str,
    /// Text of the hazard or rule.
    pub text: String,
    /// Source.
    pub source: String,
}

/// A picture.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Picture {
    /// Picture as SVG.
    pub svg: String,
    /// Caption below the picture.
    pub caption: String,
    /// Description of the picture, for screen readers.
    pub alternative_text: String,
}

/// An entry of a checklist.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Task {
    /// Task; a hazard has its signal word.
    pub what: Hazard,
    /// Expected value with unit; empty if nothing is measured.
    pub expected: String,
    /// Unit of the value to record; `null` if none is recorded.
    pub unit: Option<String>,
}

impl Column {
    /// Creates a column of short texts.
    #[must_use]
    pub fn text(head: impl Into<String>) -> Self {
        Self { head: head.into(), numbers: false, wide: false }
    }

    /// Creates a column of numbers.
    #[must_use]
    pub fn numbers(head: impl Into<String>) -> Self {
        Self { head: head.into(), numbers: true, wide: false }
    }

    /// Creates a column of sentences.
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
    /// Creates an empty chapter.
    #[must_use]
    pub fn new(title: impl Into<String>) -> Self {
        Self { title: title.into(), blocks: Vec::new() }
    }

    /// Adds a heading.
    pub fn section(&mut self, text: impl Into<String>) {
        self.blocks.push(Block::Section { text: text.into() });
    }

    /// Iterates over the texts of the chapter, in order.
    pub fn texts(&self) -> impl Iterator<Item = &str> {
        self.blocks.iter().flat_map(Block::texts)
    }

    /// Adds a paragraph; an empty one is left out.
    pub fn text(&mut self, text: impl Into<String>) {
        let text = text.into();
        self.add(text.is_empty(), Block::Text { text });
    }

    /// Adds a block unless it is empty.
    fn add(&mut self, is_empty: bool, block: Block) {
        if !is_empty {
            self.blocks.push(block);
        }
    }

    /// Adds independent sentences, if there are any.
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

    /// Adds entries of a checklist, if there are any.
    pub fn tasks(&mut self, items: Vec<Task>) {
        self.add(items.is_empty(), Block::Tasks { items });
    }
}
