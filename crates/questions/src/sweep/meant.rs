//! Headings of a table with the keys that they stand for.

/// Heading of a column of keys.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MeantHeading {
    /// Heading in the table.
    pub written: String,
    /// Heading with the path of the key; the written one if it is no word for a key.
    pub meant: String,
    /// `true` if the key has the values of the cells with the opposite sign.
    pub is_opposite: bool,
}

impl MeantHeading {
    /// Returns `true` if a word stands for the key.
    pub(super) fn is_by_word(&self) -> bool {
        self.written != self.meant
    }
}

impl From<&str> for MeantHeading {
    fn from(heading: &str) -> Self {
        Self { written: heading.to_owned(), meant: heading.to_owned(), is_opposite: false }
    }
}
