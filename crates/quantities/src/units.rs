//! A unit with its spellings and its conversion, and the search for a unit by a spelling.

use crate::dimension::Dimension;
use crate::proposal;
use crate::spelling::{Canonical, abbreviated};
use std::collections::BTreeMap;
use std::fmt;
use std::hash::{Hash, Hasher};
use std::sync::LazyLock;

/// One unit with its spellings and its conversion (SI value = value × factor + offset).
///
/// Two units are equal if they measure the same quantity and have the same spelling; compare with `==`, not by address.
#[derive(Clone, Copy)]
pub struct Unit {
    /// Quantity measured by the unit.
    pub dimension: Dimension,
    /// Spelling of project files: `N m`, `1/min`, `kg m^2`.
    pub ascii: &'static str,
    /// Spelling for display: `Nm`, `min⁻¹`, `kgm²`, `Ω`, `°C`.
    pub symbol: &'static str,
    /// Spelling in data exchange: `Nm`, `1/min`, `kgm^2`, `degC`.
    pub json: &'static str,
    /// Further spellings that are accepted.
    pub(crate) others: &'static [&'static str],
    pub(crate) forth: fn(f64) -> f64,
    pub(crate) back: fn(f64) -> f64,
}

impl Unit {
    /// Converts a value in this unit to SI.
    #[must_use]
    pub fn to_si(&self, value: f64) -> f64 {
        (self.forth)(value)
    }

    /// Converts an SI value to this unit.
    #[must_use]
    pub fn from_si(&self, si: f64) -> f64 {
        (self.back)(si)
    }

    /// Returns the unit with this spelling, of any dimension. If several dimensions share the spelling, it belongs to
    /// the first of [`Dimension::ALL`]: `g` is a gram, `K` a temperature. Units of gains are found by their dimension
    /// only: `1/s` alone is rad/s to some and revolutions per second to others.
    #[must_use]
    pub fn of(spelling: &str) -> Option<&'static Self> {
        use Dimension::{CurrentGain, PositionGain, SpeedGain};
        with_spelling(spelling, |unit| !matches!(unit.dimension, CurrentGain | PositionGain | SpeedGain))
    }

    /// Returns the unit of a dimension with this spelling.
    ///
    /// Case is significant (`mN` is not `MN`), and so is the sign of a product: `m N` is a torque, `mN` a force. Not
    /// significant is the choice of the sign (space, `·`, `*`, `×`, or `-` and `.` between letters), and `^`; `²`,
    /// `⁻¹`, `µ`, `Ω`, `°` may replace `2`, `-1`, `u`, `ohm`, `deg`, words their abbreviations (`degrees/sec`), and a
    /// negative power a slash (`rad s^-1`). Factors may have any order.
    #[must_use]
    pub fn of_dimension(dimension: Dimension, spelling: &str) -> Option<&'static Self> {
        with_spelling(spelling, |unit| unit.dimension == dimension)
    }

    /// Iterates over the spellings, the one of project files first.
    pub fn spellings(&self) -> impl Iterator<Item = &'static str> {
        [self.ascii, self.symbol, self.json].into_iter().chain(self.others.iter().copied())
    }

    /// Returns the unit of a dimension that was probably meant by a text that is none; `None` if another one is
    /// possible.
    ///
    /// A proposal keeps the meaning of the text: if it reads as a product of units, with prefixes and powers, the
    /// proposed unit has the same value. Otherwise the letters differ from those of one unit only in case, or by one
    /// letter that is no prefix.
    #[must_use]
    pub fn nearest(dimension: Dimension, spelling: &str) -> Option<&'static Self> {
        if spelling.len() > SPELLING_LENGTH_MAX { None } else { proposal::of(dimension, spelling) }
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

/// Maximum length of a spelling; the longest one has less than half of it.
const SPELLING_LENGTH_MAX: usize = 64;

/// A unit with the canonical form of one of its spellings.
struct Known {
    unit: &'static Unit,
    /// Places at which the sign of a product may stand.
    products: u64,
}

/// Units by the canonical text of their spellings, in the order of [`Dimension::ALL`].
static TEXTS: LazyLock<BTreeMap<String, Vec<Known>>> = LazyLock::new(|| {
    let mut texts: BTreeMap<String, Vec<Known>> = BTreeMap::new();
    for_each_spelling(|unit, canonical| {
        let units = texts.entry(canonical.text).or_default();
        match units.iter_mut().find(|known| known.unit == unit) {
            Some(known) => known.products |= canonical.products,
            None => units.push(Known { unit, products: canonical.products }),
        }
    });
    texts
});

/// Units by their factors in a fixed order, for the few spellings in another order than those of [`TEXTS`].
static FACTORS: LazyLock<BTreeMap<String, Vec<&'static Unit>>> = LazyLock::new(|| {
    let mut by_factors: BTreeMap<String, Vec<&'static Unit>> = BTreeMap::new();
    for_each_spelling(|unit, canonical| {
        if let Some(factors) = canonical.factors() {
            let units = by_factors.entry(factors).or_default();
            if !units.contains(&unit) {
                units.push(unit);
            }
        }
    });
    by_factors
});

/// Visits the spellings of every unit, with a slash also those with a negative power.
fn for_each_spelling(mut visit: impl FnMut(&'static Unit, Canonical)) {
    for unit in Dimension::ALL.iter().flat_map(|dimension| dimension.units()) {
        for spelling in unit.spellings() {
            visit(unit, Canonical::of(spelling));
            if let Some(spelling) = with_negative_power(spelling) {
                visit(unit, Canonical::of(&spelling));
            }
        }
    }
}

/// Returns the spelling with a negative power instead of the slash: `rad s^-1` for `rad/s`.
fn with_negative_power(spelling: &str) -> Option<String> {
    let (over, under) = spelling.split_once('/')?;
    let name = under.trim_end_matches(|sign: char| !sign.is_ascii_alphabetic());
    let is_name = !name.is_empty() && name.bytes().all(|byte| byte.is_ascii_alphabetic());
    let power = match under.get(name.len()..)? {
        "" => "1",
        "^2" | "²" => "2",
        "^3" | "³" => "3",
        _ => return None,
    };
    let has_unit = over.chars().any(char::is_alphabetic) || over.contains(['°', 'Ω']);
    (is_name && has_unit).then(|| format!("{over} {name}-{power}"))
}

/// Returns the first unit with a spelling that satisfies a predicate.
fn with_spelling(spelling: &str, is_wanted: impl Fn(&Unit) -> bool) -> Option<&'static Unit> {
    if spelling.len() > SPELLING_LENGTH_MAX {
        return None;
    }
    // `None` if no unit of any dimension has this spelling.
    let found = |text: &str, products: u64| {
        let known = TEXTS.get(text)?.iter().filter(|known| products & !known.products == 0);
        let mut known = known.map(|known| known.unit);
        let first = known.next()?;
        Some(std::iter::once(first).chain(known).find(|unit| is_wanted(unit)))
    };
    let of = |spelling: &str| {
        let canonical = Canonical::of(spelling);
        found(&canonical.text, canonical.products).or_else(|| {
            // First the factors: a text of one factor, as that of a cell without a unit, needs no index of them.
            let factors = canonical.factors()?;
            Some(FACTORS.get(&factors)?.iter().copied().find(|unit| is_wanted(unit)))
        })
    };
    // Most spellings are in the index as written.
    found(spelling, 0).or_else(|| of(spelling)).or_else(|| of(&abbreviated(spelling)?)).flatten()
}
