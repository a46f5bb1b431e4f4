//! A unit: how it is written, how it converts, and how a spelling finds it.

use crate::dimension::Dimension;
use std::collections::BTreeMap;
use std::fmt;
use std::hash::{Hash, Hasher};
use std::sync::LazyLock;

/// One unit: how it is written and how it converts (SI value = value × factor + offset).
///
/// Two units are equal if they measure the same quantity and are written alike; compare with `==`, not by address.
#[derive(Clone, Copy)]
pub struct Unit {
    /// The quantity it measures.
    pub dimension: Dimension,
    /// Spelling of project files: `N m`, `1/min`, `kg m^2`.
    pub ascii: &'static str,
    /// Spelling for people: `Nm`, `min⁻¹`, `kgm²`, `Ω`, `°C`.
    pub symbol: &'static str,
    /// Spelling in data exchange: `Nm`, `1/min`, `kgm^2`, `degC`.
    pub json: &'static str,
    /// Further spellings that are understood.
    pub(crate) others: &'static [&'static str],
    pub(crate) forth: fn(f64) -> f64,
    pub(crate) back: fn(f64) -> f64,
}

impl Unit {
    /// A value in this unit, in SI.
    #[must_use]
    pub fn to_si(&self, value: f64) -> f64 {
        (self.forth)(value)
    }

    /// An SI value in this unit.
    #[must_use]
    pub fn from_si(&self, si: f64) -> f64 {
        (self.back)(si)
    }

    /// The unit with this spelling, of whatever dimension. Where several dimensions share the spelling, the first of
    /// [`Dimension::ALL`] has it: `g` is a gram, `K` a temperature.
    #[must_use]
    pub fn of(spelling: &str) -> Option<&'static Self> {
        with_spelling(spelling).first().copied()
    }

    /// The unit of a dimension with this spelling.
    ///
    /// Case matters (`mN` is no `MN`); spaces, `·`, `*` and `^` do not, and `²`, `⁻¹`, `µ`, `Ω`, `°` may stand for
    /// `2`, `-1`, `u`, `ohm`, `deg`.
    #[must_use]
    pub fn of_dimension(dimension: Dimension, spelling: &str) -> Option<&'static Self> {
        with_spelling(spelling).iter().copied().find(|unit| unit.dimension == dimension)
    }

    /// Every spelling, the one of project files first.
    pub fn spellings(&self) -> impl Iterator<Item = &'static str> {
        [self.ascii, self.symbol, self.json].into_iter().chain(self.others.iter().copied())
    }

    /// The unit of a dimension whose spelling is nearest to a misspelt one; `None` if nothing is near.
    #[must_use]
    pub fn nearest(dimension: Dimension, spelling: &str) -> Option<&'static Self> {
        if spelling.len() > SPELLING_LENGTH_MAX {
            return None;
        }
        let wanted = canonical(spelling);
        let length = wanted.chars().count();
        let mut best: Option<((usize, usize), &Self)> = None;
        for unit in dimension.units() {
            for known in unit.spellings().map(canonical) {
                // Case counts, but less than a wrong letter.
                let letters = strsim::damerau_levenshtein(&wanted.to_lowercase(), &known.to_lowercase());
                let distance = (letters, strsim::damerau_levenshtein(&wanted, &known));
                let near = letters <= 1 + length / 3 && letters < length.max(known.chars().count());
                if near && best.is_none_or(|(least, _)| distance < least) {
                    best = Some((distance, unit));
                }
            }
        }
        best.map(|(_, unit)| unit)
    }
}

impl PartialEq for Unit {
    fn eq(&self, other: &Self) -> bool {
        (self.dimension, self.ascii) == (other.dimension, other.ascii)
    }
}

impl Eq for Unit {}

impl Hash for Unit {
    fn hash<H: Hasher>(&self, state: &mut H) {
        (self.dimension, self.ascii).hash(state);
    }
}

impl fmt::Debug for Unit {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "Unit({:?}, {:?})", self.dimension, self.ascii)
    }
}

/// Longer texts are no unit; the longest spelling has less than half of it.
const SPELLING_LENGTH_MAX: usize = 64;

/// Canonical spelling to the units that have it, in the order of [`Dimension::ALL`].
static INDEX: LazyLock<BTreeMap<String, Vec<&'static Unit>>> = LazyLock::new(|| {
    let mut index: BTreeMap<String, Vec<&'static Unit>> = BTreeMap::new();
    for unit in Dimension::ALL.iter().flat_map(|dimension| dimension.units()) {
        for spelling in unit.spellings() {
            let units = index.entry(canonical(spelling)).or_default();
            if !units.contains(&unit) {
                units.push(unit);
            }
        }
    }
    index
});

fn with_spelling(spelling: &str) -> &'static [&'static Unit] {
    if spelling.len() > SPELLING_LENGTH_MAX {
        return &[];
    }
    // Most are written as the index has them.
    INDEX.get(spelling).or_else(|| INDEX.get(&canonical(spelling))).map_or(&[], Vec::as_slice)
}

/// A spelling without what does not matter: spaces and signs of a product or power, raised digits, Greek letters.
pub(crate) fn canonical(spelling: &str) -> String {
    let mut out = String::with_capacity(spelling.len());
    for c in spelling.chars() {
        match c {
            '·' | '⋅' | '∙' | '*' | '^' => {}
            c if c.is_whitespace() => {}
            '⁻' | '−' => out.push('-'),
            '⁰' => out.push('0'),
            '¹' => out.push('1'),
            '²' => out.push('2'),
            '³' => out.push('3'),
            '⁴' => out.push('4'),
            '⁵' => out.push('5'),
            '⁶' => out.push('6'),
            '⁷' => out.push('7'),
            '⁸' => out.push('8'),
            '⁹' => out.push('9'),
            // The micro sign and the Greek mu; the ohm sign and the Greek omega.
            '\u{b5}' | '\u{3bc}' => out.push('u'),
            '\u{2126}' | '\u{3a9}' => out.push_str("ohm"),
            '°' => out.push_str("deg"),
            c => out.push(c),
        }
    }
    out
}
