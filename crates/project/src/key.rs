//! Description of a key of the project file, used by the reader, its messages, the JSON Schema, the reference page and
//! the form of the page.

use crate::about::About;
use crate::recovery::{KeyName, TableKind};
use crate::{Expected, KeyDefault, Range};
use quantities::Dimension;

/// Permissible dimensions of a column of rows, the default first.
pub type ColumnDimensions = &'static [Dimension];

/// Permissible values of a key.
#[derive(Clone, Copy, Debug)]
pub enum Kind {
    /// A number with its unit, written as text.
    Quantity(Dimension, Range),
    /// A number with a unit of one of two dimensions: rotational, or linear for a linear mechanism.
    Along(Dimension, Dimension, Range),
    /// A plain number within bounds.
    Number(f64, f64),
    /// A list of plain numbers within bounds, and the largest number of them.
    Numbers(f64, f64, usize),
    /// A whole number within bounds.
    Integer(i64, i64),
    /// `true` or `false`.
    Bool,
    /// Free text of bounded length.
    Text,
    /// A list of free texts.
    Texts,
    /// One of these words.
    OneOf(&'static [&'static str]),
    /// A list of these words.
    ListOf(&'static [&'static str]),
    /// Rows of quantities, `[["0 1/min", "32 N m"], …]`.
    Rows(&'static [ColumnDimensions]),
    /// A table.
    Table(&'static [Key]),
    /// A table, or an array of tables with additional keys.
    OneOrMany(&'static [Key], &'static [Key]),
    /// Solid bodies, one text each.
    Bodies,
    /// An array of tables, each of one of several kinds.
    Variants(&'static Variants),
}

impl Kind {
    /// Returns the permissible values for a fault.
    pub(crate) const fn expected(&self) -> Expected {
        match *self {
            Self::Quantity(dimension, _) => Expected::Quantity(dimension),
            Self::Along(turning, line, _) => Expected::Along(turning, line),
            Self::Number(..) => Expected::Number,
            Self::Numbers(..) => Expected::Numbers,
            Self::Integer(..) => Expected::Integer,
            Self::Bool => Expected::Bool,
            Self::Text => Expected::Text,
            Self::Texts => Expected::Texts,
            Self::OneOf(words) => Expected::OneOf(words),
            Self::ListOf(words) => Expected::ListOf(words),
            Self::Rows(_) => Expected::Rows,
            Self::Table(_) | Self::OneOrMany(..) => Expected::Table,
            Self::Bodies => Expected::Bodies,
            Self::Variants(_) => Expected::Tables,
        }
    }

    /// Returns `true` if the values are a ratio of two equal quantities near one, as efficiencies, shares and humidity, which the trade
    /// writes in percent too. Gear ratios, factors and coefficients of friction go beyond.
    #[must_use]
    pub const fn is_ratio(&self) -> bool {
        /// Largest value of such a ratio.
        const MOST: f64 = 2.0;
        matches!(*self, Self::Number(low, high) if low >= 0.0 && high <= MOST)
    }

    /// Returns the dimensions that the value of a key may have; empty if it is no quantity.
    #[must_use]
    pub fn dimensions(self) -> Vec<Dimension> {
        match self {
            Self::Quantity(dimension, _) => vec![dimension],
            Self::Along(turning, line, _) => vec![turning, line],
            _ => Vec::new(),
        }
    }

    /// Returns the keys of a table behind this key, or of an entry of a list of them; empty for a value.
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
            | Self::Texts
            | Self::OneOf(_)
            | Self::ListOf(_)
            | Self::Rows(_)
            | Self::Bodies => &[],
        }
    }
}

/// Tables of several kinds with one description: one key names the kind, which decides the other keys.
#[derive(Debug)]
pub struct Variants {
    /// The keys of all kinds.
    pub keys: &'static [Key],
    /// Key that names the kind.
    pub by: &'static str,
    /// Name, required keys, optional keys in addition to those of every kind.
    pub kinds: &'static [(&'static str, &'static [&'static str], &'static [&'static str])],
    /// Keys that every kind may have.
    pub shared: &'static [&'static str],
}

impl Variants {
    /// Returns the keys that a kind may have: its own and those of every kind; `None` for an unknown kind.
    pub(crate) fn keys_of(&self, kind: &str) -> Option<Vec<&'static str>> {
        let (_, needed, optional) = self.kinds.iter().find(|(name, ..)| *name == kind)?;
        let own = needed.iter().chain(*optional).chain(self.shared);
        Some(std::iter::once(self.by).chain(own.copied()).collect())
    }

    /// Returns the line of the only kind that may have a key: `law = "dwell"`; `None` for a key of several kinds.
    pub(crate) fn only_kind_with(&self, key: &str) -> Option<String> {
        let has = |(_, needed, optional): &&(&str, &[&str], &[&str])| needed.contains(&key) || optional.contains(&key);
        let mut kinds = self.kinds.iter().filter(has);
        let (kind, ..) = kinds.next().filter(|_| !self.shared.contains(&key))?;
        kinds.next().is_none().then(|| format!("{} = \"{kind}\"", self.by))
    }
}

/// One key of the project file.
#[derive(Clone, Copy, Debug)]
pub struct Key {
    /// Name in the file.
    pub name: &'static str,
    /// Permissible values.
    pub kind: Kind,
    /// Required in its table.
    pub required: bool,
    /// Purpose.
    pub about: About,
    /// Example of a value as written; empty if the kind has one of its own.
    pub(crate) example: &'static str,
    /// Default as written; `None` if the absence of the key has a meaning of its own.
    pub default: Option<fn() -> String>,
    /// Assumption that is listed if the key is not stated.
    pub note: Option<KeyDefault>,
    /// Exponents a and b by which the value of a segment with time factor k and distance factor m is scaled: k^a m^b.
    pub(crate) stretches: Option<(i32, i32)>,
}

impl Key {
    pub(crate) const fn new(name: &'static str, kind: Kind, about: About) -> Self {
        Self { name, kind, required: false, about, example: "", default: None, note: None, stretches: None }
    }

    /// Makes the key required in its table.
    pub(crate) const fn needed(self) -> Self {
        Self { required: true, ..self }
    }

    /// Requires values greater than zero.
    pub(crate) const fn positive(self) -> Self {
        self.in_range(Range::Positive)
    }

    /// Requires values of zero or more.
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

    /// Requires plain numbers between these bounds.
    pub(crate) const fn within(self, low: f64, high: f64) -> Self {
        let kind = match self.kind {
            Kind::Numbers(_, _, most) => Kind::Numbers(low, high, most),
            _ => Kind::Number(low, high),
        };
        Self { kind, ..self }
    }

    /// Limits the number of entries.
    pub(crate) const fn at_most(self, most: usize) -> Self {
        let kind = match self.kind {
            Kind::Numbers(low, high, _) => Kind::Numbers(low, high, most),
            other => other,
        };
        Self { kind, ..self }
    }

    /// Requires whole numbers between these bounds.
    pub(crate) const fn whole(self, low: i64, high: i64) -> Self {
        Self { kind: Kind::Integer(low, high), ..self }
    }

    /// Sets an example as written, without the quotes of a text.
    pub(crate) const fn example(self, example: &'static str) -> Self {
        Self { example, ..self }
    }

    /// Sets the default.
    pub(crate) const fn or(self, default: fn() -> String) -> Self {
        Self { default: Some(default), ..self }
    }

    /// Sets the assumption that is listed if the key is not stated.
    pub(crate) const fn noted(self, note: KeyDefault) -> Self {
        Self { note: Some(note), ..self }
    }

    /// Sets the exponents by which the value scales with time and distance of its segment.
    pub(crate) const fn stretches(self, time: i32, way: i32) -> Self {
        Self { stretches: Some((time, way)), ..self }
    }
}

/// Returns the keys of the table at a path for the recovery from faults of the syntax; none if there is no such table.
pub(crate) fn keys_at(keys: &'static [Key], path: &[String]) -> Vec<KeyName> {
    let mut found = vec![keys];
    for name in path {
        let inner = found.iter().flat_map(|keys| keys.iter()).filter(|key| key.name == name);
        let tables = inner.flat_map(|key| [key.kind.keys(false), key.kind.keys(true)]);
        found = tables.filter(|keys| !keys.is_empty()).collect();
    }
    let table = |kind: &Kind| match kind {
        Kind::Table(_) => Some(TableKind::One),
        Kind::OneOrMany(..) => Some(TableKind::OneOrMany),
        Kind::Variants(_) => Some(TableKind::Many),
        _ => None,
    };
    let keys = found.into_iter().flat_map(|keys| keys.iter());
    keys.map(|key| KeyName { name: key.name, table: table(&key.kind) }).collect()
}

/// Returns a valid line for a key; `None` for an empty set of words.
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
        Kind::Texts => format!("{name} = [\"{}\"]", own("…")),
        Kind::OneOf(words) => format!("{name} = \"{}\"", words.first()?),
        Kind::ListOf(words) => format!("{name} = [\"{}\"]", words.first()?),
        Kind::Table(_) | Kind::OneOrMany(..) => format!("[{name}]"),
        Kind::Bodies => format!("{name} = [\"cylinder diameter=300mm length=20mm density=7850kg/m^3\"]"),
        Kind::Variants(_) => format!("[[{name}]]"),
    })
}

/// Returns the number of these keys.
pub(crate) const fn count(parts: &[&[Key]]) -> usize {
    let (mut total, mut rest) = (0, parts);
    while let [first, others @ ..] = rest {
        total += first.len();
        rest = others;
    }
    total
}

/// Concatenates these keys.
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
    use crate::{Fault, MEASURED_KEYS, read_measured};

    /// Collects, for every key below a table, a text that states its example.
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

    /// Returns `true` if a fault concerns the value of a key alone, not its neighbours.
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
            let faults = reader.report.into_faults();
            assert!(!faults.iter().any(|fault| is_of_the_value(&fault.fault)), "{text}: {faults:?}");
        }
        let mut found = Vec::new();
        all(MEASURED_KEYS, "", "", &mut found);
        for text in found {
            let faults = read_measured(&text).err().unwrap_or_default();
            assert!(!faults.iter().any(|fault| is_of_the_value(&fault.fault)), "{text}: {faults:?}");
        }
    }

    /// Every ratio near one may be written in percent, with the bounds of its number; no other number may, as a gear ratio.
    #[test]
    fn every_ratio_takes_percent() {
        fn numbers(keys: &'static [Key], heads: &str, path: &str, found: &mut Vec<(String, &'static Key)>) {
            for key in keys {
                let path = if path.is_empty() { key.name.to_owned() } else { format!("{path}.{}", key.name) };
                let head = match key.kind {
                    Kind::Variants(_) => format!("{heads}[[{path}]]\n"),
                    _ => format!("{heads}[{path}]\n"),
                };
                if matches!(key.kind, Kind::Number(..) | Kind::Integer(..)) {
                    found.push((heads.to_owned(), key));
                }
                numbers(key.kind.keys(false), &head, &path, found);
            }
        }
        let faults = |text: &str| {
            let mut reader = Reader::new(text);
            let _: Root = reader.read();
            let mut faults: Vec<Fault> = reader.report.into_faults().into_iter().map(|found| found.fault).collect();
            faults.retain(is_of_the_value);
            faults
        };
        let mut found = Vec::new();
        numbers(KEYS, "", "", &mut found);
        let (mut ratios, mut others) = (Vec::new(), Vec::new());
        for (heads, key) in found {
            let text = |value: &str| format!("{heads}{} = \"{value}\"\n", key.name);
            if let Kind::Number(low, high) = key.kind
                && key.kind.is_ratio()
            {
                for share in [low, f64::midpoint(low, high), high] {
                    let written = text(&format!("{} %", 100.0 * share));
                    assert!(faults(&written).is_empty(), "{written}: {:?}", faults(&written));
                }
                let beyond = text(&format!("{} %", 100.0 * high + 1.0));
                assert!(matches!(faults(&beyond)[..], [Fault::NumberOutOfRange { .. }]), "{beyond}");
                assert!(matches!(faults(&text("0.8"))[..], [Fault::WrongType { .. }]), "{heads}{}", key.name);
                ratios.push(key.name);
            } else {
                assert!(matches!(faults(&text("80 %"))[..], [Fault::WrongType { .. }]), "{heads}{}", key.name);
                others.push(key.name);
            }
        }
        for name in ["efficiency", "efficiency_back", "humidity_min", "humidity_max", "flange_share", "mains_deviation"]
        {
            assert!(ratios.contains(&name), "{name}");
        }
        for name in ["ratio", "friction_coefficient", "load_factor", "pole_pairs"] {
            assert!(others.contains(&name), "{name}");
        }
    }

    /// The commands protect the files that a project names: each key whose example is a file is one of theirs.
    #[test]
    fn every_key_that_names_a_file_is_known_to_name_one() {
        let mut found = Vec::new();
        all(KEYS, "", "", &mut found);
        let is_file = |text: &str| [".csv\"", ".toml\"", ".parquet\""].iter().any(|ending| text.contains(ending));
        let texts: Vec<&String> = found.iter().filter(|text| is_file(text)).collect();
        assert!(texts.len() >= 2, "{texts:?}");
        for text in texts {
            assert_eq!(crate::files_named(text).len(), 1, "{text}");
        }
        let several = "motion = [{ law = \"recorded\", file = \"a.csv\" }]\naxis = [{ motion = [{ file = 1 }] }]\n\
            [catalogue]\nfiles = [\"b.csv\", \"c.toml\"]\n";
        assert_eq!(crate::files_named(several), ["a.csv", "b.csv", "c.toml"]);
        assert!(crate::files_named("a =").is_empty());
    }

    /// Optional keys of mechanisms whose absence is no default that a user should see: their assumption belongs to another
    /// key, their part does not exist unless it is stated, or it is required where it has an effect.
    const NOT_LISTED: [&str; 27] = [
        "viscous_friction",
        "external_torque",
        "friction_force",
        "friction_coefficient",
        "counterweight",
        "process_force",
        "hanging",
        "crossed",
        "coupler_centre",
        "coupler_inertia",
        "rocker_centre",
        "rocker_inertia",
        "rocker_torque",
        "payload_distance",
        "turntable.start_angle",
        // Of an arm, described by its shape or by its inertia.
        "shape",
        "length",
        "width",
        "arm.inertia",
        "centre_distance",
        "falls",
        "body",
        "bodies",
        "mass",
        "torque",
        // Of a joint, whose torque is recorded: a check names what it lacks.
        "joint.inertia",
        "joint.holding_torque",
    ];

    /// Requires that an optional key of a mechanism lists its default: an assumption is shown.
    #[test]
    fn every_default_of_a_mechanism_is_listed() {
        let mechanisms = KEYS.iter().find(|key| key.name == "mechanism").unwrap().kind.keys(false);
        assert!(mechanisms.len() > 10, "{}", mechanisms.len());
        for table in mechanisms {
            for key in table.kind.keys(false).iter().filter(|key| !key.required) {
                let path = format!("{}.{}", table.name, key.name);
                let is_exempt = NOT_LISTED.iter().any(|exempt| *exempt == key.name || *exempt == path);
                assert!(key.note.is_some() != is_exempt, "mechanism.{path}");
            }
        }
    }
}
