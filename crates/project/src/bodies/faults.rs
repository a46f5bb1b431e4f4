//! Faults of a body as written.

use super::{BODY_SHAPES, BodyShape, BodyTolerance, Keyed, Line};
use crate::choices::Orientation;
use crate::value::WordChoice;
use crate::{Diagnostic, Fault, Hint};
use quantities::{Dimension, HalfWidth};
use std::ops::Range;

/// Faults beyond this number are counted, not listed.
const FAULTS_MOST: usize = 50;

/// Longest excerpt of the text in a message, in characters.
const EXCERPT_MOST: usize = 60;

/// Faults of a text.
pub(super) struct Faults<'t> {
    text: &'t str,
    found: Vec<Diagnostic>,
    more: usize,
    /// Tolerances of the bodies; `None` if they are not allowed.
    pub(super) tolerances: Option<Vec<BodyTolerance>>,
    /// Index of the line being read, from zero, and its offset.
    line: (usize, usize),
}

impl<'t> Faults<'t> {
    pub(super) const fn new(text: &'t str) -> Self {
        Self { text, found: Vec::new(), more: 0, tolerances: None, line: (0, 0) }
    }

    pub(super) fn with_tolerances(text: &'t str) -> Self {
        Self { tolerances: Some(Vec::new()), ..Self::new(text) }
    }

    /// Sets the line that is read next.
    pub(super) const fn begin(&mut self, index: usize, start: usize) {
        self.line = (index, start);
    }

    /// Returns the faults in the order of the text, and the number of further ones.
    pub(super) fn take(mut self) -> (Vec<Diagnostic>, usize) {
        self.found.sort_by_key(|fault| (fault.span.start, fault.span.end));
        (self.found, self.more)
    }

    fn fault(&mut self, span: Range<usize>, fault: Fault, hint: Option<Hint>) {
        if self.found.len() >= FAULTS_MOST {
            self.more += 1;
            return;
        }
        self.found.push(Diagnostic::at(self.text, span, fault, hint));
    }

    /// Returns "did you mean …", or the whole list if no name is near.
    fn nearest(&self, written: &str, valid: &[&str]) -> Option<Hint> {
        if self.found.len() >= FAULTS_MOST {
            return None;
        }
        Some(match nearest_of(written, valid) {
            Some(name) => Hint::DidYouMean(name.to_owned()),
            None => Hint::valid(valid),
        })
    }

    /// Returns the shape of a line.
    pub(super) fn shape(&mut self, line: &Line<'_>) -> Option<&'static BodyShape> {
        let found = BODY_SHAPES.iter().find(|shape| shape.name == line.shape.to_lowercase());
        if found.is_some() {
            return found;
        }
        let names: Vec<&str> = BODY_SHAPES.iter().map(|shape| shape.name).collect();
        if line.shape.is_empty() {
            let (fault, hint) = if line.pairs.is_empty() {
                (Fault::BodyMissing, example("cylinder diameter=200mm length=20mm density=7850kg/m^3"))
            } else {
                (Fault::ShapeMissing, Hint::valid(&names))
            };
            self.fault(line.shape_span.clone(), fault, Some(hint));
            return None;
        }
        let hint = self.nearest(line.shape, &names);
        self.fault(line.shape_span.clone(), Fault::NoShape { written: excerpt(line.shape) }, hint);
        None
    }

    /// Reports text that does not belong to a key.
    pub(super) fn stray(&mut self, (text, span): &(&str, Range<usize>)) {
        self.fault(span.clone(), Fault::NoKey { written: excerpt(text) }, Some(example("diameter=200mm")));
    }

    /// Reports a key that the shape does not have; returns the one that was probably meant.
    pub(super) fn unknown_key<'n>(
        &mut self,
        pair: &Keyed<'_>,
        shape: Option<&BodyShape>,
        valid: &[&'n str],
    ) -> Option<&'n str> {
        let key = excerpt(pair.key);
        if self.found.len() >= FAULTS_MOST {
            self.more += 1;
            return None;
        }
        let hint = self.nearest(pair.key, valid);
        let span = if pair.key.is_empty() { pair.value_span.clone() } else { pair.key_span.clone() };
        let fault = match shape {
            Some(shape) => Fault::KeyOfAnotherShape { key, shape: shape.name },
            None => Fault::UnknownKey { path: key },
        };
        self.fault(span, fault, hint);
        nearest_of(pair.key, valid)
    }

    pub(super) fn twice(&mut self, pair: &Keyed<'_>) {
        self.fault(pair.key_span.clone(), Fault::Twice { key: pair.key.to_owned() }, None);
    }

    pub(super) fn missing(&mut self, line: &Line<'_>, key: &str) {
        let fault = Fault::MissingKey { path: key.to_owned(), list: false };
        self.fault(line.shape_span.clone(), fault, Some(example(&format!("{key}=50mm"))));
    }

    /// Returns a quantity in SI.
    pub(super) fn quantity(&mut self, pair: &Keyed<'_>, key: &'static str, dimension: Dimension) -> Option<f64> {
        let read = match self.tolerances {
            Some(_) => quantities::parse_toleranced(dimension, pair.value),
            None => quantities::parse(dimension, pair.value).map(|reading| (reading, None)),
        };
        let error = match read {
            Ok((reading, half)) => {
                if let (Some(tolerances), Some(half)) = (&mut self.tolerances, half) {
                    let (line, start) = self.line;
                    let from = pair.value_span.start.saturating_sub(start);
                    let span = from + half.span.start..from + half.span.end;
                    tolerances.push((line, key, reading, HalfWidth { span, ..half }));
                }
                return Some(reading.si);
            }
            Err(error) => error,
        };
        // A tolerance, where none may be, is a fault of its own.
        let all = quantities::quantity_faults(dimension, pair.value);
        let all = if all.first() == Some(&error) { all } else { vec![error] };
        for error in all {
            let span = if pair.value.is_empty() {
                pair.value_span.clone()
            } else {
                let inner = error.span();
                pair.value_span.start + inner.start..pair.value_span.start + inner.end
            };
            self.fault(span, Fault::Quantity { path: pair.key.to_owned(), error, also: Vec::new() }, None);
        }
        None
    }

    /// Returns a number of pieces; the mechanics check for zero.
    pub(super) fn count(&mut self, pair: &Keyed<'_>) -> Option<u32> {
        let plain = pair.value.bytes().all(|byte| byte.is_ascii_digit());
        let found = pair.value.parse().ok().filter(|_| plain);
        if found.is_none() {
            let fault = Fault::Count { written: excerpt(pair.value) };
            self.fault(pair.value_span.clone(), fault, Some(example("count=4")));
        }
        found
    }

    /// Returns the orientation of a cylinder.
    pub(super) fn axis(&mut self, pair: &Keyed<'_>) -> Option<Orientation> {
        let found = Orientation::of_word(pair.value);
        if found.is_none() {
            let hint = self.nearest(pair.value, Orientation::WORDS);
            self.fault(pair.value_span.clone(), Fault::BodyAxis { written: excerpt(pair.value) }, hint);
        }
        found
    }
}

/// Returns the name that was probably meant.
fn nearest_of<'n>(written: &str, valid: &[&'n str]) -> Option<&'n str> {
    let written = excerpt(written).to_lowercase();
    let akin = valid.iter().copied().find(|name| written.len() >= 3 && name.starts_with(written.as_str()));
    let near = || {
        valid
            .iter()
            .map(|name| (strsim::damerau_levenshtein(&written, name), *name))
            .min()
            .filter(|(distance, name)| distance * 2 <= name.len())
            .map(|(_, name)| name)
    };
    akin.or_else(near)
}

fn excerpt(text: &str) -> String {
    text.chars().filter(|c| !c.is_control()).take(EXCERPT_MOST).collect()
}

fn example(line: &str) -> Hint {
    Hint::Example(line.to_owned())
}
