//! Lists of plain numbers.

use crate::Fault;
use crate::key::Kind;
use crate::read::{FoundValue, Reader};
use std::ops::Range as Span;
use toml::Spanned;
use toml::de::DeValue;

impl Reader<'_> {
    /// Returns the value at a place as a plain number within bounds.
    pub(crate) fn bounded(
        &mut self,
        value: &DeValue<'_>,
        span: Span<usize>,
        path: &str,
        (low, high): (f64, f64),
    ) -> Option<f64> {
        let written = match value {
            DeValue::Integer(_) | DeValue::Float(_) => self.text().get(span.clone()),
            _ => None,
        };
        let number: Option<f64> = written.and_then(|text| text.replace('_', "").parse().ok());
        let number = number.filter(|number| number.is_finite() && (low..=high).contains(number));
        if number.is_none() {
            self.fault(span, Fault::NumberOutOfRange { path: path.to_owned(), low, high }, None);
        }
        number
    }

    /// Returns plain numbers within bounds.
    pub(crate) fn numbers(&mut self, found: &FoundValue<'_, '_>) -> Option<Vec<f64>> {
        let (Kind::Numbers(low, high, most), DeValue::Array(items)) = (found.key.kind, found.value) else {
            return self.wrong_type(found);
        };
        if items.is_empty() || items.len() > most {
            return self.refuse(found.span.clone(), Fault::RatioCount { most });
        }
        let number = |item: &Spanned<DeValue<'_>>| self.bounded(item.get_ref(), item.span(), found.path, (low, high));
        let numbers: Vec<Option<f64>> = items.iter().map(number).collect();
        numbers.into_iter().collect()
    }
}
