//! What a project file holds once it passed its description.

use crate::recorded::RecordingRead;
use quantities::{Dimension, Measure};
use std::collections::BTreeMap;
use std::ops::Range as Span;

/// A value that passed its description.
#[derive(Clone, Debug)]
pub(crate) enum Entry {
    /// SI value of a quantity.
    Quantity(f64),
    /// SI value and which dimension it was written in.
    Along(Dimension, f64),
    Number(f64),
    Integer(i64),
    Bool(bool),
    Text(String),
    List(Vec<String>),
    Numbers(Vec<f64>),
    /// Rows of SI values.
    Rows(Vec<Vec<f64>>),
    /// Solid bodies.
    Bodies(Vec<mechanism::Body>),
    /// What stands in a file that was named.
    Recording(RecordingRead),
    Table(Section),
    Tables(Vec<Section>),
}

impl Entry {
    /// Of a value that is no quantity, table or row: its number if it is one.
    pub(crate) const fn plain(&self) -> Option<Option<f64>> {
        match self {
            Self::Number(number) => Some(Some(*number)),
            #[allow(clippy::cast_precision_loss, reason = "bounded by its description")]
            Self::Integer(number) => Some(Some(*number as f64)),
            Self::Bool(_) | Self::Text(_) | Self::List(_) | Self::Numbers(_) => Some(None),
            _ => None,
        }
    }
}

/// A table that passed its description.
#[derive(Clone, Debug, Default)]
pub(crate) struct Section {
    pub(crate) span: Span<usize>,
    /// Its path in the file: `motion[2]`, `axis[1].load`; empty for the root.
    pub(crate) path: String,
    pub(crate) entries: BTreeMap<&'static str, (Entry, Span<usize>)>,
    /// Keys that are there, but whose value was refused.
    pub(crate) refused: Vec<&'static str>,
}

impl Section {
    pub(crate) fn get(&self, name: &str) -> Option<&Entry> {
        self.entries.get(name).map(|(entry, _)| entry)
    }

    /// Whether a key is there, with a valid value or not.
    pub(crate) fn has(&self, name: &str) -> bool {
        self.entries.contains_key(name) || self.refused.contains(&name)
    }

    /// Whether no value was refused.
    pub(crate) const fn is_whole(&self) -> bool {
        self.refused.is_empty()
    }

    pub(crate) fn span_of(&self, name: &str) -> Span<usize> {
        self.entries.get(name).map_or_else(|| self.span.clone(), |(_, span)| span.clone())
    }

    /// Puts another value in the place of one that is there.
    pub(crate) fn replace(&mut self, name: &str, entry: Entry) {
        if let Some((old, _)) = self.entries.get_mut(name) {
            *old = entry;
        }
    }

    /// Takes back a value that turned out to be no good.
    pub(crate) fn refuse(&mut self, name: &'static str) {
        self.entries.remove(name);
        self.refused.push(name);
    }

    pub(crate) fn tables_mut(&mut self, name: &str) -> &mut [Self] {
        match self.entries.get_mut(name) {
            Some((Entry::Tables(sections), _)) => sections,
            _ => &mut [],
        }
    }

    /// One of several axes as if it stood alone: its name and all else at the root.
    pub(crate) fn as_root(&self) -> Self {
        let mut root = self.clone();
        root.entries.insert("axis", (Entry::Table(self.clone()), self.span.clone()));
        root
    }

    pub(crate) fn quantity<Q: Measure>(&self, name: &str) -> Option<Q> {
        match self.get(name) {
            Some(Entry::Quantity(si)) => Some(Q::from_si(*si)),
            _ => None,
        }
    }

    /// The SI value of a quantity.
    pub(crate) fn si(&self, name: &str) -> Option<f64> {
        match self.get(name) {
            Some(Entry::Quantity(si) | Entry::Along(_, si)) => Some(*si),
            _ => None,
        }
    }

    pub(crate) fn along(&self, name: &str) -> Option<(Dimension, f64)> {
        match self.get(name) {
            Some(Entry::Along(dimension, si)) => Some((*dimension, *si)),
            _ => None,
        }
    }

    pub(crate) fn rows(&self, name: &str) -> &[Vec<f64>] {
        match self.get(name) {
            Some(Entry::Rows(rows)) => rows,
            _ => &[],
        }
    }

    pub(crate) fn bodies(&self, name: &str) -> Option<&[mechanism::Body]> {
        match self.get(name) {
            Some(Entry::Bodies(bodies)) => Some(bodies),
            _ => None,
        }
    }

    /// Puts another value, in SI, in the place of a quantity: `load.inertia`, `motion[2].speed`, `points[1][3]` (row and
    /// column), `bodies[1].mass`. `None` where no quantity stands there.
    pub(crate) fn set(&mut self, path: &str, si: f64) -> Option<()> {
        let (head, rest) = path.split_once('.').unwrap_or((path, ""));
        let mut parts = head.split('[').map(|part| part.trim_end_matches(']'));
        let name = parts.next()?;
        let mut index = || parts.next()?.parse::<usize>().ok()?.checked_sub(1);
        match &mut self.entries.get_mut(name)?.0 {
            Entry::Quantity(value) | Entry::Along(_, value) => *value = si,
            Entry::Rows(rows) => *rows.get_mut(index()?)?.get_mut(index()?)? = si,
            Entry::Bodies(bodies) => crate::bodies::set(bodies.get_mut(index()?)?, rest, si)?,
            Entry::Table(section) => section.set(rest, si)?,
            Entry::Tables(sections) => sections.get_mut(index()?)?.set(rest, si)?,
            _ => return None,
        }
        Some(())
    }

    /// The tables within, by name.
    pub(crate) fn subtables(&self) -> impl Iterator<Item = (&'static str, &Self)> {
        self.entries.iter().filter_map(|(name, (entry, _))| match entry {
            Entry::Table(section) => Some((*name, section)),
            _ => None,
        })
    }

    pub(crate) fn text(&self, name: &str) -> Option<&str> {
        match self.get(name) {
            Some(Entry::Text(text)) => Some(text),
            _ => None,
        }
    }

    pub(crate) fn list(&self, name: &str) -> &[String] {
        match self.get(name) {
            Some(Entry::List(list)) => list,
            _ => &[],
        }
    }

    pub(crate) fn numbers(&self, name: &str) -> &[f64] {
        match self.get(name) {
            Some(Entry::Numbers(numbers)) => numbers,
            _ => &[],
        }
    }

    pub(crate) fn number(&self, name: &str) -> Option<f64> {
        match self.get(name) {
            Some(Entry::Number(number)) => Some(*number),
            #[allow(clippy::cast_precision_loss, reason = "bounded by its description")]
            Some(Entry::Integer(number)) => Some(*number as f64),
            _ => None,
        }
    }

    pub(crate) fn bool(&self, name: &str) -> Option<bool> {
        match self.get(name) {
            Some(Entry::Bool(value)) => Some(*value),
            _ => None,
        }
    }

    pub(crate) fn table(&self, name: &str) -> Option<&Self> {
        match self.get(name) {
            Some(Entry::Table(section)) => Some(section),
            _ => None,
        }
    }

    pub(crate) fn tables(&self, name: &str) -> &[Self] {
        match self.get(name) {
            Some(Entry::Tables(sections)) => sections,
            _ => &[],
        }
    }
}
