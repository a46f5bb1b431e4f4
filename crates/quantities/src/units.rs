//! A unit: how it is written, how it converts, and how a spelling finds it.

use crate::dimension::Dimension;
use crate::proposal;
use crate::spelling::{Canonical, abbreviated};
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
        with_spelling(spelling, |_| true)
    }

    /// The unit of a dimension with this spelling.
    ///
    /// Case matters (`mN` is no `MN`), and so does the sign of a product: `m N` is a torque, `mN` a force. Which sign it is does not
    /// (space, `·`, `*`, `×`, or `-` and `.` between letters), nor does `^`; `²`, `⁻¹`, `µ`, `Ω`, `°` may stand for `2`, `-1`, `u`,
    /// `ohm`, `deg`, words for their abbreviations (`degrees/sec`), and a negative power for a stroke (`rad s^-1`). Factors may stand
    /// in any order.
    #[must_use]
    pub fn of_dimension(dimension: Dimension, spelling: &str) -> Option<&'static Self> {
        with_spelling(spelling, |unit| unit.dimension == dimension)
    }

    /// Every spelling, the one of project files first.
    pub fn spellings(&self) -> impl Iterator<Item = &'static str> {
        [self.ascii, self.symbol, self.json].into_iter().chain(self.others.iter().copied())
    }

    /// The unit of a dimension that was probably meant by a text that is none of it; `None` where another one could be meant.
    ///
    /// A proposal keeps what the text means: where it reads as a product of units, with prefixes and powers, the proposed unit has
    /// the same value. Otherwise the letters differ from those of one unit only in case, or by one letter that is no prefix.
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

/// Longer texts are no unit; the longest spelling has less than half of it.
const SPELLING_LENGTH_MAX: usize = 64;

/// A unit by one of its spellings.
struct Known {
    unit: &'static Unit,
    /// Places at which the sign of a product may stand.
    products: u64,
}

/// Units by their canonical text, and by their factors in a fixed order, in the order of [`Dimension::ALL`].
struct Index {
    texts: BTreeMap<String, Vec<Known>>,
    factors: BTreeMap<String, Vec<&'static Unit>>,
}

static INDEX: LazyLock<Index> = LazyLock::new(|| {
    let mut index = Index { texts: BTreeMap::new(), factors: BTreeMap::new() };
    for unit in Dimension::ALL.iter().flat_map(|dimension| dimension.units()) {
        for spelling in unit.spellings() {
            let mut put = |spelling: &str| {
                let canonical = Canonical::of(spelling);
                if let Some(factors) = canonical.factors() {
                    let units = index.factors.entry(factors).or_default();
                    if !units.contains(&unit) {
                        units.push(unit);
                    }
                }
                let units = index.texts.entry(canonical.text).or_default();
                match units.iter_mut().find(|known| known.unit == unit) {
                    Some(known) => known.products |= canonical.products,
                    None => units.push(Known { unit, products: canonical.products }),
                }
            };
            put(spelling);
            if let Some(spelling) = with_negative_power(spelling) {
                put(&spelling);
            }
        }
    }
    index
});

/// The spelling with a negative power in the place of its stroke: `rad s^-1` for `rad/s`.
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

/// The first unit with a spelling that is one of those looked for.
fn with_spelling(spelling: &str, is_wanted: impl Fn(&Unit) -> bool) -> Option<&'static Unit> {
    if spelling.len() > SPELLING_LENGTH_MAX {
        return None;
    }
    // `None` where nothing is written so, of whatever dimension.
    let found = |text: &str, products: u64| {
        let known = INDEX.texts.get(text)?.iter().filter(|known| products & !known.products == 0);
        let mut known = known.map(|known| known.unit);
        let first = known.next()?;
        Some(std::iter::once(first).chain(known).find(|unit| is_wanted(unit)))
    };
    let of = |spelling: &str| {
        let canonical = Canonical::of(spelling);
        let in_order = found(&canonical.text, canonical.products);
        in_order
            .or_else(|| Some(INDEX.factors.get(&canonical.factors()?)?.iter().copied().find(|unit| is_wanted(unit))))
    };
    // Most are written as the index has them.
    found(spelling, 0).or_else(|| of(spelling)).or_else(|| of(&abbreviated(spelling)?)).flatten()
}
