//! A value with the place and the path under which it is stated.

use crate::Assumption;
use crate::key::Key;
use crate::read::{Found, Reader, joined};
use crate::value::Value;
use quantities::Measure;
use std::ops::Range as Span;
use std::sync::Arc;

/// Where a section of the file begins, and its path: `motion[2]`, `axis[1].load`; empty for the root.
#[derive(Clone, Debug)]
pub(crate) struct Head {
    pub(crate) path: Arc<str>,
    pub(crate) span: Span<usize>,
    /// Whether keys stand there that the section does not have.
    pub(crate) has_strays: bool,
}

impl Head {
    pub(crate) fn new(path: &str, span: Span<usize>) -> Self {
        Self { path: path.into(), span, has_strays: false }
    }

    /// The place at which something that is missing is reported.
    pub(crate) fn start(&self) -> Span<usize> {
        self.span.start..self.span.start + usize::from(!self.span.is_empty())
    }
}

/// A field of a section: its value as far as it is stated, with path and place.
#[derive(Clone, Debug)]
pub(crate) struct Stated<T> {
    /// The path of its section.
    section: Arc<str>,
    key: &'static Key,
    /// The place of its value; of the section where no valid one is stated.
    span: Span<usize>,
    state: State<T>,
}

#[derive(Clone, Debug)]
enum State<T> {
    Absent,
    /// It is there, but its value was refused.
    Refused,
    Given(T),
}

impl<T> Stated<T> {
    pub(crate) fn absent(head: &Head, key: &'static Key) -> Self {
        Self { section: Arc::clone(&head.path), key, span: head.span.clone(), state: State::Absent }
    }

    pub(crate) const fn get(&self) -> Option<&T> {
        match &self.state {
            State::Given(value) => Some(value),
            State::Absent | State::Refused => None,
        }
    }

    pub(crate) const fn get_mut(&mut self) -> Option<&mut T> {
        match &mut self.state {
            State::Given(value) => Some(value),
            State::Absent | State::Refused => None,
        }
    }

    /// States a value at a place.
    pub(crate) fn give(&mut self, value: T, span: Span<usize>) {
        (self.state, self.span) = (State::Given(value), span);
    }

    /// Takes a value back that turned out to be no good.
    pub(crate) fn refuse(&mut self) {
        self.state = State::Refused;
    }

    /// Takes a value away as if it had never been stated.
    pub(crate) fn clear(&mut self) {
        self.state = State::Absent;
    }
}

impl<T: Copy> Stated<T> {
    pub(crate) fn value(&self) -> Option<T> {
        self.get().copied()
    }
}

impl<Q: Measure> Stated<Q> {
    pub(crate) fn or_zero(&self) -> Q {
        self.value().unwrap_or_else(|| Q::from_si(0.0))
    }
}

/// A field without the type of its value.
pub(crate) trait Field {
    fn name(&self) -> &'static str;
    /// What is assumed where no valid value is stated, if its key says so.
    fn note(&self) -> Option<Assumption>;
    /// Its path in the file: `motion[2].speed`.
    fn path(&self) -> String;
    fn span(&self) -> Span<usize>;
    /// Whether a valid value is stated.
    fn is_given(&self) -> bool;
    /// Whether it is there, with a valid value or not.
    fn is_written(&self) -> bool;
    fn read(&mut self, found: &Found<'_, '_>, reader: &mut Reader<'_>);
    /// Whether its value is stated along the line of a mechanism.
    fn is_of_a_line(&self) -> bool;
    /// The value of a quantity in SI.
    fn si(&self) -> Option<f64>;
    /// States a quantity by its value in SI.
    fn state(&mut self, si: f64, span: Span<usize>);
    /// Puts another value, in SI, in the place of a quantity; `index` and `rest` lead to it within a list. `None` where no
    /// quantity stands there.
    fn set(&mut self, index: &[usize], rest: &str, si: f64) -> Option<()>;
}

impl<T: Value> Field for Stated<T> {
    fn name(&self) -> &'static str {
        self.key.name
    }

    fn note(&self) -> Option<Assumption> {
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

    fn read(&mut self, found: &Found<'_, '_>, reader: &mut Reader<'_>) {
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

    fn state(&mut self, si: f64, span: Span<usize>) {
        if let Some(value) = T::of_si(si) {
            self.give(value, span);
        }
    }

    fn set(&mut self, index: &[usize], rest: &str, si: f64) -> Option<()> {
        self.get_mut()?.set(index, rest, si)
    }
}
