//! Remedies of faults.

use quantities::Dimension;

/// Hint that adds to the fault.
#[derive(Clone, Debug, PartialEq)]
pub enum Hint {
    /// A valid line.
    Example(String),
    /// The name that was probably meant.
    DidYouMean(String),
    /// List of the valid names.
    ValidAre(Vec<String>),
    /// A bare number with a unit behind it.
    WithUnit {
        /// The number as written.
        written: String,
        /// Dimension of the key.
        dimension: Dimension,
    },
    /// The mechanisms from which loads on the flange follow.
    MechanismsWithLoads,
    /// Times of a clock in a recording count from its first row.
    TimeOfClock,
    /// Ways to make a recorded cycle close.
    CloseTheRecording,
    /// A key of another table.
    KeyOfTable {
        /// Key.
        key: &'static str,
        /// Heading of the table, with the line of the only kind that has the key: `[[motion]]`, `[[motion]] law = "dwell"`.
        table: String,
    },
    /// The keys of the same section for a quantity of this kind, none of which has the written name.
    KeysOfQuantity {
        /// Kind of the value.
        dimension: Dimension,
        /// Keys.
        keys: Vec<&'static str>,
    },
    /// The turns of a winder for a length or speed of its web.
    WebOfWinder {
        /// Speed of the web \[m/s\], if the value is one.
        web_m_s: Option<f64>,
        /// Diameter at the start \[m\].
        start_m: f64,
        /// Diameter of the core \[m\].
        core_m: f64,
    },
}

impl Hint {
    /// Creates a proposal of one name, or of several.
    #[must_use]
    pub fn instead(names: &[&str]) -> Self {
        match names {
            [only] => Self::DidYouMean((*only).to_owned()),
            several => Self::valid(several),
        }
    }

    /// Returns `true` if it names a key of the segments.
    pub(crate) fn is_of_a_segment(&self) -> bool {
        matches!(self, Self::KeyOfTable { table, .. } if table.starts_with("[[motion]]"))
    }

    /// Creates the list of the valid names.
    #[must_use]
    pub fn valid(names: &[&str]) -> Self {
        Self::ValidAre(names.iter().map(|name| (*name).to_owned()).collect())
    }
}
