//! Lists of plain numbers.

use crate::Fault;
use crate::key::Kind;
use crate::read::{Found, Reader};
use toml::de::DeValue;

impl Reader<'_> {
    /// Plain numbers within bounds.
    pub(crate) fn numbers(&mut self, found: &Found<'_, '_>) -> Option<Vec<f64>> {
        let (Kind::Numbers(low, high, most), DeValue::Array(items)) = (found.key.kind, found.value) else {
            return self.wrong_type(found);
        };
        if items.is_empty() || items.len() > most {
            return self.refuse(found.span.clone(), Fault::RatioCount { most });
        }
        let mut numbers = Vec::with_capacity(items.len());
        for item in items {
            let written = match item.get_ref() {
                DeValue::Integer(_) | DeValue::Float(_) => self.text.get(item.span()),
                _ => None,
            };
            let number: Option<f64> = written.and_then(|text| text.replace('_', "").parse().ok());
            match number.filter(|number| number.is_finite() && (low..=high).contains(number)) {
                Some(number) => numbers.push(number),
                None => {
                    let fault = Fault::NumberOutOfRange { path: found.path.to_owned(), low, high };
                    self.fault(item.span(), fault, None);
                }
            }
        }
        (numbers.len() == items.len()).then_some(numbers)
    }
}
