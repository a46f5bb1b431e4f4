//! A value with its place and path in the file.

use crate::KeyDefault;
use crate::key::Key;
use crate::read::{FoundValue, Reader, joined};
use crate::value::KeyValue;
use quantities::Measure;
use std::ops::Range as Span;
use std::sync::Arc;

/// Start of a section of the file, and its path: `motion[2]`, `axis[1].load`; empty for the root.
#[derive(Clone, Debug)]
pub struct SectionHead {
    /// Path in the file.
    pub path: Arc<str>,
    /// Place in the file, in bytes.
    pub span: Span<usize>,
    /// The section contains keys that it does not have.
    pub has_strays: bool,
}

impl SectionHead {
    /// Creates the head of a section.
    #[must_use]
    pub fn new(path: &str, span: Span<usize>) -> Self {
        Self { path: path.into(), span, has_strays: false }
    }

    /// Returns the place at which a missing key is reported.
    #[must_use]
    pub fn start(&self) -> Span<usize> {
        self.span.start..self.span.start + usize::from(!self.span.is_empty())
    }
}

/// A field of a section: its value if stated, with path and place.
#[derive(Clone, Debug)]
pub struct Stated<T> {
    /// Path of its section.
    section: Arc<str>,
    key: &'static Key,
    /// Place of its value; that of the section without a valid value.
    span: Span<usize>,
    state: State<T>,
}

#[derive(Clone, Debug)]
enum State<T> {
    Absent,
    /// The key is present, but its value was refused.
    Refused,
    Given(T),
}

impl<T> Stated<T> {
    pub(crate) fn absent(head: &SectionHead, key: &'static Key) -> Self {
        Self { section: Arc::clone(&head.path), key, span: head.span.clone(), state: State::Absent }
    }

    /// Returns the valid value.
    pub const fn get(&self) -> Option<&T> {
        match &self.state {
            State::Given(value) => Some(value),
            State::Absent | State::Refused => None,
        }
    }

    /// Returns the valid value for a change.
    pub const fn get_mut(&mut self) -> Option<&mut T> {
        match &mut self.state {
            State::Given(value) => Some(value),
            State::Absent | State::Refused => None,
        }
    }

    /// States a value at a place.
    pub fn give(&mut self, value: T, span: Span<usize>) {
        (self.state, self.span) = (State::Given(value), span);
    }

    /// Marks the value as refused after a later check.
    pub fn refuse(&mut self) {
        self.state = State::Refused;
    }

    /// Removes a value as if it had never been stated.
    pub fn clear(&mut self) {
        self.state = State::Absent;
    }
}

impl<T: Copy> Stated<T> {
    /// Returns a copy of the valid value.
    pub fn value(&self) -> Option<T> {
        self.get().copied()
    }
}

impl<Q: Measure> Stated<Q> {
    /// Returns the value, or zero if none is stated.
    pub fn or_zero(&self) -> Q {
        self.value().unwrap_or_else(|| Q::from_si(0.0))
    }
}

/// A field without the type of its value.
pub trait StatedField {
    /// Returns the name of its key.
    fn name(&self) -> &'static str;
    /// Returns the assumption that replaces a missing value, if the key has one.
    fn note(&self) -> Option<KeyDefault>;
    /// Returns its path in the file: `motion[2].speed`.
    fn path(&self) -> String;
    /// Returns the place of its value; that of the section without a valid value.
    fn span(&self) -> Span<usize>;
    /// Returns `true` if a valid value is stated.
    fn is_given(&self) -> bool;
    /// Returns `true` if the key is present, with a valid value or not.
    fn is_written(&self) -> bool;
    /// Reads its value.
    fn read(&mut self, found: &FoundValue<'_, '_>, reader: &mut Reader<'_>);
    /// Returns `true` if its value is stated along the line of a mechanism.
    fn is_of_a_line(&self) -> bool;
    /// Returns the value of a quantity in SI.
    fn si(&self) -> Option<f64>;
    /// Marks its value as refused.
    fn refuse_value(&mut self);
    /// States a quantity by its value in SI.
    fn state(&mut self, si: f64, span: Span<usize>);
    /// Replaces the value of a quantity, in SI; `index` and `rest` lead to it within a list. A quantity that is not stated
    /// is stated. `None` if there is no quantity.
    fn set(&mut self, index: &[usize], rest: &str, si: f64) -> Option<()>;
    /// Returns `true` if it is stated, as is the key to which `index` and `rest` lead within it.
    fn states(&self, index: &[usize], rest: &str) -> bool;
}

impl<T: KeyValue> StatedField for Stated<T> {
    fn name(&self) -> &'static str {
        self.key.name
    }

    fn note(&self) -> Option<KeyDefault> {
        self.key.note.filter(|_| !self.is_given())
    }

    fn path(&self) -> String {
        joined(&self.section, self.key.name)
    }

    fn span(&self) -> Span<usize> {
        self.span.clone()
    }

    fn is_given(&self) -> bool {
        self.get().is_some()
    }

    fn is_written(&self) -> bool {
        !matches!(self.state, State::Absent)
    }

    fn read(&mut self, found: &FoundValue<'_, '_>, reader: &mut Reader<'_>) {
        match T::read(found, reader) {
            Some(value) => {
                if let Some(number) = value.noted() {
                    reader.input(found.path, &found.span, number);
                }
                self.give(value, found.span.clone());
            }
            None => self.refuse(),
        }
    }

    fn is_of_a_line(&self) -> bool {
        self.get().is_some_and(T::is_of_a_line)
    }

    fn si(&self) -> Option<f64> {
        self.get()?.as_si()
    }

    fn refuse_value(&mut self) {
        self.refuse();
    }

    fn state(&mut self, si: f64, span: Span<usize>) {
        if let Some(value) = T::of_si(si) {
            self.give(value, span);
        }
    }

    fn set(&mut self, index: &[usize], rest: &str, si: f64) -> Option<()> {
        if let State::Absent = self.state
            && index.is_empty()
            && rest.is_empty()
        {
            self.state = State::Given(T::of_si(si)?);
            return Some(());
        }
        self.get_mut()?.set(index, rest, si)
    }

    fn states(&self, index: &[usize], rest: &str) -> bool {
        self.get().map_or_else(|| self.is_written(), |value| value.states(index, rest))
    }
}
