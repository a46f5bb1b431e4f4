//! Lists of plain numbers.

use crate::Fault;
use crate::read::Reader;
use crate::section::Entry;
use std::ops::Range as Span;
use toml::de::{DeArray, DeValue};

impl Reader<'_> {
    /// Plain numbers within bounds.
    pub(crate) fn numbers(
        &mut self,
        items: &DeArray<'_>,
        (low, high, most): (f64, f64, usize),
        span: Span<usize>,
        path: &str,
    ) -> Option<Entry> {
        if items.is_empty() || items.len() > most {
            return self.refuse(span, Fault::RatioCount { most });
        }
        let mut found = Vec::with_capacity(items.len());
        for item in items {
            let written = match item.get_ref() {
                DeValue::Integer(_) | DeValue::Float(_) => self.text.get(item.span()),
                _ => None,
            };
            let number: Option<f64> = written.and_then(|text| text.replace('_', "").parse().ok());
            match number.filter(|number| number.is_finite() && (low..=high).contains(number)) {
                Some(number) => found.push(number),
                None => self.fault(item.span(), Fault::NumberOutOfRange { path: path.to_owned(), low, high }, None),
            }
        }
        (found.len() == items.len()).then_some(Entry::Numbers(found))
    }
}
