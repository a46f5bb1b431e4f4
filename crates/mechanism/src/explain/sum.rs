//! Formulas composed of the terms that are stated.

/// Sum of terms in a formula.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sum {
    text: String,
    has_several: bool,
}

impl Sum {
    /// Creates a sum of one term.
    pub(crate) fn of(term: impl AsRef<str>) -> Self {
        Self::default().and(true, term)
    }

    /// Adds a term that is stated.
    pub(crate) fn and(self, is_stated: bool, term: impl AsRef<str>) -> Self {
        if is_stated { self.with(["", " + "], term.as_ref()) } else { self }
    }

    /// Subtracts a term that is stated.
    pub(crate) fn less(self, is_stated: bool, term: impl AsRef<str>) -> Self {
        if is_stated { self.with(["-", " - "], term.as_ref()) } else { self }
    }

    fn with(mut self, [first, next]: [&str; 2], term: &str) -> Self {
        self.has_several = !self.is_empty();
        self.text += if self.is_empty() { first } else { next };
        self.text += term;
        self
    }

    /// Returns `true` if no term is stated.
    pub(crate) fn is_empty(&self) -> bool {
        self.text.is_empty()
    }

    /// Returns the sum as a factor of a product: in parentheses if it has several terms.
    pub(crate) fn factor(self) -> String {
        if self.has_several { format!("({})", self.text) } else { self.text() }
    }

    /// Returns the sum; `0` without terms.
    pub(crate) fn text(self) -> String {
        if self.is_empty() { "0".to_owned() } else { self.text }
    }
}
