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
    /// Case matters (`mN` is no `MN`); spaces and `^` do not, and `²`, `⁻¹`, `µ`, `Ω`, `°` may stand for `2`, `-1`, `u`, `ohm`,
    /// `deg`. A sign of a product (`·`, `*`, `×`) parts factors, as a space between two units does: `m·N` is a newton metre and
    /// no millinewton. Factors may stand in any order.
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
                // What is alike but for its factors, `m·s` and `ms`, is another unit.
                let is_near = letters <= 1 + length / 3 && letters < length.max(known.chars().count());
                let near = is_near && known != wanted;
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
    if let Some(units) = INDEX.get(spelling) {
        return units;
    }
    let written = Factors::of(spelling);
    match INDEX.get(&written.text) {
        Some(units) if units.iter().all(|unit| written.are_of(unit)) => units,
        _ => written.sorted().and_then(|product| PRODUCTS.get(&product)).map_or(&[], Vec::as_slice),
    }
}

/// Units by the factors above and below their fraction stroke, each sorted: `m·N` is a newton metre.
static PRODUCTS: LazyLock<BTreeMap<String, Vec<&'static Unit>>> = LazyLock::new(|| {
    let mut products: BTreeMap<String, Vec<&'static Unit>> = BTreeMap::new();
    for unit in Dimension::ALL.iter().flat_map(|dimension| dimension.units()) {
        for spelling in unit.spellings() {
            let Some(product) = Factors::of(spelling).sorted() else { continue };
            let units = products.entry(product).or_default();
            if !units.contains(&unit) {
                units.push(unit);
            }
        }
    }
    products
});

/// A spelling with the places at which factors part.
struct Factors {
    /// The canonical spelling.
    text: String,
    /// Bytes before which a sign of a product or a space stands between two letters, and whether it is a sign.
    parted: Vec<(usize, bool)>,
}

impl Factors {
    fn of(spelling: &str) -> Self {
        let mut found = Self { text: String::with_capacity(spelling.len()), parted: Vec::new() };
        let mut between = None;
        for part in spelling.split_inclusive(|c: char| is_product(c) || c.is_whitespace()) {
            let letters = part.trim_end_matches(|c: char| is_product(c) || c.is_whitespace());
            let behind = canonical(letters);
            // A power, a stroke and a number join what stands beside them.
            if let Some(is_sign) = between
                && behind.starts_with(char::is_alphabetic)
                && found.text.ends_with(char::is_alphanumeric)
            {
                found.parted.push((found.text.len(), is_sign));
            }
            let is_sign = part.chars().next_back().filter(|_| letters.len() < part.len()).map(is_product);
            between = if letters.is_empty() { between.max(is_sign) } else { is_sign };
            found.text.push_str(&behind);
        }
        found
    }

    /// The factors between the places.
    fn each(&self) -> impl Iterator<Item = &str> {
        let ends = self.parted.iter().map(|(at, _)| *at).chain([self.text.len()]);
        let begins = [0].into_iter().chain(self.parted.iter().map(|(at, _)| *at));
        begins.zip(ends).map(|(begin, end)| self.text.get(begin..end).unwrap_or_default())
    }

    /// Whether a unit has its factors parted at these places, in the spelling that is alike but for them. A prefix is no factor:
    /// behind a sign of a product `m` is a metre, and a space between two units parts them too.
    fn are_of(&self, unit: &Unit) -> bool {
        let own = || unit.spellings().map(Self::of).filter(|own| own.text == self.text);
        let is_own = |at: usize| own().any(|own| own.parted.iter().any(|(place, _)| *place == at));
        let mut factors = self.each();
        let mut before = factors.next().unwrap_or_default();
        self.parted.iter().zip(factors).all(|((at, is_sign), behind)| {
            let both = [std::mem::replace(&mut before, behind), behind];
            is_own(*at) || !is_sign && !both.iter().all(|factor| INDEX.contains_key(*factor))
        })
    }

    /// The factors above the fraction stroke in a fixed order, and what stands below it; `None` where there is one factor only, or
    /// where its place may say something.
    fn sorted(&self) -> Option<String> {
        let (above, below) = self.text.split_at(self.text.find('/').unwrap_or(self.text.len()));
        let is_plain = below.matches('/').count() < 2 && !self.text.contains(['(', ')']);
        if self.parted.is_empty() || !is_plain || self.parted.iter().any(|(at, _)| *at > above.len()) {
            return None;
        }
        let mut factors: Vec<&str> = self.each().map(|factor| factor.strip_suffix(below).unwrap_or(factor)).collect();
        factors.sort_unstable();
        Some(factors.join("·") + below)
    }
}

/// A sign of a product.
const fn is_product(c: char) -> bool {
    matches!(c, '·' | '⋅' | '∙' | '*' | '×')
}

/// A spelling without what does not matter: spaces and signs of a product or power, raised digits, Greek letters.
pub(crate) fn canonical(spelling: &str) -> String {
    let mut out = String::with_capacity(spelling.len());
    for c in spelling.chars() {
        match c {
            '·' | '⋅' | '∙' | '*' | '×' | '^' => {}
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
