//! What is known of a key of the project file: one description from which the reader, its messages, the JSON Schema, the
//! reference page and the form of the page come.

use crate::about::About;
use crate::{Assumption, Expected, Range};
use quantities::Dimension;

/// A column of rows: what it may measure, the usual first.
pub type Column = &'static [Dimension];

/// What may stand behind a key.
#[derive(Clone, Copy, Debug)]
pub enum Kind {
    /// A number with its unit, written as text.
    Quantity(Dimension, Range),
    /// A number with a unit of one of two dimensions: of the rotation, or of the line of a linear mechanism.
    Along(Dimension, Dimension, Range),
    /// A plain number within bounds.
    Number(f64, f64),
    /// A list of plain numbers within bounds, and how many at most.
    Numbers(f64, f64, usize),
    /// A whole number within bounds.
    Integer(i64, i64),
    /// `true` or `false`.
    Bool,
    /// Free text of bounded length.
    Text,
    /// One of these words.
    OneOf(&'static [&'static str]),
    /// A list of these words.
    ListOf(&'static [&'static str]),
    /// Rows of quantities, `[["0 1/min", "32 N m"], …]`.
    Rows(&'static [Column]),
    /// A table.
    Table(&'static [Key]),
    /// A table, or an array of tables with more in them.
    OneOrMany(&'static [Key], &'static [Key]),
    /// Solid bodies, one text each.
    Bodies,
    /// An array of tables, each of one of several kinds.
    Variants(&'static Variants),
}

impl Kind {
    /// What may stand there, for a fault.
    pub(crate) const fn expected(&self) -> Expected {
        match *self {
            Self::Quantity(dimension, _) => Expected::Quantity(dimension),
            Self::Along(turning, line, _) => Expected::Along(turning, line),
            Self::Number(..) => Expected::Number,
            Self::Numbers(..) => Expected::Numbers,
            Self::Integer(..) => Expected::Integer,
            Self::Bool => Expected::Bool,
            Self::Text => Expected::Text,
            Self::OneOf(words) => Expected::OneOf(words),
            Self::ListOf(words) => Expected::ListOf(words),
            Self::Rows(_) => Expected::Rows,
            Self::Table(_) | Self::OneOrMany(..) => Expected::Table,
            Self::Bodies => Expected::Bodies,
            Self::Variants(_) => Expected::Tables,
        }
    }

    /// The keys of a table behind this key, or of an entry of a list of them; empty for a value.
    #[must_use]
    pub const fn keys(&self, entry: bool) -> &'static [Key] {
        match *self {
            Self::Table(keys) => keys,
            Self::OneOrMany(one, many) => {
                if entry {
                    many
                } else {
                    one
                }
            }
            Self::Variants(variants) => variants.keys,
            Self::Quantity(..)
            | Self::Along(..)
            | Self::Number(..)
            | Self::Numbers(..)
            | Self::Integer(..)
            | Self::Bool
            | Self::Text
            | Self::OneOf(_)
            | Self::ListOf(_)
            | Self::Rows(_)
            | Self::Bodies => &[],
        }
    }
}

/// Tables of several kinds that share a description: one key says which kind it is, and so which others belong.
#[derive(Debug)]
pub struct Variants {
    /// The keys of all kinds.
    pub keys: &'static [Key],
    /// The key that names the kind.
    pub by: &'static str,
    /// Name, keys that must be there, keys that may be there besides those of every kind.
    pub kinds: &'static [(&'static str, &'static [&'static str], &'static [&'static str])],
    /// Keys that every kind may have.
    pub shared: &'static [&'static str],
}

/// One key of the project file.
#[derive(Clone, Copy, Debug)]
pub struct Key {
    /// Its name in the file.
    pub name: &'static str,
    /// What may stand behind it.
    pub kind: Kind,
    /// Whether its table must have it.
    pub required: bool,
    /// What it is for.
    pub about: About,
    /// A value that may stand there, as it is written; empty where the kind has one of its own.
    pub(crate) example: &'static str,
    /// What holds where it is not stated, as it is written; `None` where its absence means something else.
    pub default: Option<fn() -> String>,
    /// What is listed as assumed where it is not stated.
    pub note: Option<Assumption>,
    /// Of a segment that takes k times as long and goes m times as far the value is multiplied by k^a m^b: a and b.
    pub(crate) stretches: Option<(i32, i32)>,
}

impl Key {
    pub(crate) const fn new(name: &'static str, kind: Kind, about: About) -> Self {
        Self { name, kind, required: false, about, example: "", default: None, note: None, stretches: None }
    }

    /// Its table must have it.
    pub(crate) const fn needed(self) -> Self {
        Self { required: true, ..self }
    }

    /// More than zero.
    pub(crate) const fn positive(self) -> Self {
        self.in_range(Range::Positive)
    }

    /// Zero or more.
    pub(crate) const fn not_negative(self) -> Self {
        self.in_range(Range::NotNegative)
    }

    const fn in_range(self, range: Range) -> Self {
        let kind = match self.kind {
            Kind::Quantity(dimension, _) => Kind::Quantity(dimension, range),
            Kind::Along(turning, line, _) => Kind::Along(turning, line, range),
            other => other,
        };
        Self { kind, ..self }
    }

    /// A plain number between these bounds, or a list of them.
    pub(crate) const fn within(self, low: f64, high: f64) -> Self {
        let kind = match self.kind {
            Kind::Numbers(_, _, most) => Kind::Numbers(low, high, most),
            _ => Kind::Number(low, high),
        };
        Self { kind, ..self }
    }

    /// At most so many numbers.
    pub(crate) const fn at_most(self, most: usize) -> Self {
        let kind = match self.kind {
            Kind::Numbers(low, high, _) => Kind::Numbers(low, high, most),
            other => other,
        };
        Self { kind, ..self }
    }

    /// A whole number between these bounds.
    pub(crate) const fn whole(self, low: i64, high: i64) -> Self {
        Self { kind: Kind::Integer(low, high), ..self }
    }

    /// A value as it is written, without the quotes of a text.
    pub(crate) const fn example(self, example: &'static str) -> Self {
        Self { example, ..self }
    }

    /// Where it is not stated this holds.
    pub(crate) const fn or(self, default: fn() -> String) -> Self {
        Self { default: Some(default), ..self }
    }

    /// Where it is not stated this is listed as assumed.
    pub(crate) const fn noted(self, note: Assumption) -> Self {
        Self { note: Some(note), ..self }
    }

    /// How the value grows with the time and the way of its segment.
    pub(crate) const fn stretches(self, time: i32, way: i32) -> Self {
        Self { stretches: Some((time, way)), ..self }
    }
}

/// A line that would be valid for a key, `None` for one of no words.
#[must_use]
pub fn example(key: &Key) -> Option<String> {
    let name = key.name;
    let own = |usual: &'static str| if key.example.is_empty() { usual } else { key.example };
    Some(match key.kind {
        Kind::Quantity(dimension, _) | Kind::Along(dimension, ..) => {
            format!("{name} = \"{}\"", own(dimension.example()))
        }
        Kind::Integer(low, _) if key.example.is_empty() => format!("{name} = {low}"),
        Kind::Number(_, high) if key.example.is_empty() => format!("{name} = {high:.1}"),
        Kind::Integer(..) | Kind::Number(..) | Kind::Rows(_) => format!("{name} = {}", key.example),
        Kind::Numbers(..) => format!("{name} = [{}]", own("1.0, 2.5")),
        Kind::Bool => format!("{name} = true"),
        Kind::Text => format!("{name} = \"{}\"", own("…")),
        Kind::OneOf(words) => format!("{name} = \"{}\"", words.first()?),
        Kind::ListOf(words) => format!("{name} = [\"{}\"]", words.first()?),
        Kind::Table(_) | Kind::OneOrMany(..) => format!("[{name}]"),
        Kind::Bodies => format!("{name} = [\"cylinder diameter=300mm length=20mm density=7850kg/m^3\"]"),
        Kind::Variants(_) => format!("[[{name}]]"),
    })
}

/// How many keys these are together.
pub(crate) const fn count(parts: &[&[Key]]) -> usize {
    let (mut total, mut rest) = (0, parts);
    while let [first, others @ ..] = rest {
        total += first.len();
        rest = others;
    }
    total
}

/// These keys, one after the other.
#[allow(clippy::indexing_slicing, reason = "read while compiling: an index out of bounds does not compile")]
pub(crate) const fn concat<const N: usize>(parts: &[&[Key]], filler: Key) -> [Key; N] {
    let mut all = [filler; N];
    let (mut at, mut rest) = (0, parts);
    while let [first, others @ ..] = rest {
        let mut keys = *first;
        while let [key, more @ ..] = keys {
            all[at] = *key;
            at += 1;
            keys = more;
        }
        rest = others;
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::read::Reader;
    use crate::root::{KEYS, Root};
    use crate::{Fault, MEASURED_KEYS, measured};

    /// For every key below a table a text that states its example.
    fn all(keys: &'static [Key], heads: &str, path: &str, found: &mut Vec<String>) {
        for key in keys {
            let path = if path.is_empty() { key.name.to_owned() } else { format!("{path}.{}", key.name) };
            let head = match key.kind {
                Kind::Variants(_) => format!("{heads}[[{path}]]\n"),
                _ => format!("{heads}[{path}]\n"),
            };
            let below = key.kind.keys(false);
            found.push(if below.is_empty() { format!("{heads}{}\n", example(key).unwrap()) } else { head.clone() });
            all(below, &head, &path, found);
        }
    }

    /// What is wrong with the value of a key alone, not with what stands beside it.
    fn is_of_the_value(fault: &Fault) -> bool {
        !matches!(fault, Fault::MissingKey { .. })
    }

    #[test]
    fn every_example_of_the_reference_is_a_value_of_its_key() {
        let mut found = Vec::new();
        all(KEYS, "", "", &mut found);
        assert!(found.len() > 200, "{}", found.len());
        for text in found {
            let mut reader = Reader::new(&text);
            let _: Root = reader.read();
            let faults = reader.into_faults();
            assert!(!faults.iter().any(|fault| is_of_the_value(&fault.fault)), "{text}: {faults:?}");
        }
        let mut found = Vec::new();
        all(MEASURED_KEYS, "", "", &mut found);
        for text in found {
            let faults = measured(&text).err().unwrap_or_default();
            assert!(!faults.iter().any(|fault| is_of_the_value(&fault.fault)), "{text}: {faults:?}");
        }
    }
}
