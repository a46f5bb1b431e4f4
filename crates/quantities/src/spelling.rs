//! Spellings of units in canonical form, without insignificant differences.

/// A spelling in canonical form: without spaces and signs of a product or a power, superscript digits as plain ones,
/// Greek letters as `u`, `ohm`, `deg`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Canonical {
    pub(crate) text: String,
    /// Places of the text, as bits by byte, at which a sign or a space of a product precedes a letter: `m N` is a
    /// product, `mN` a millinewton.
    pub(crate) products: u64,
}

impl Canonical {
    pub(crate) fn of(spelling: &str) -> Self {
        let mut found = Self::default();
        let mut is_parted = false;
        let mut signs = spelling.chars().peekable();
        let mut before = ' ';
        while let Some(sign) = signs.next() {
            match sign {
                '^' => continue,
                '·' | '⋅' | '∙' | '•' | '×' | '*' => is_parted = true,
                sign if sign.is_whitespace() => is_parted = true,
                // `in-lb`, `kg.m2`, `in.-lb`; before a digit it is an exponent or a fraction.
                '-' | '.' | '\u{2010}' | '\u{2011}'
                    if is_of_unit(before) && !signs.peek().is_some_and(char::is_ascii_digit) =>
                {
                    is_parted = true;
                    continue;
                }
                '⁻' | '−' => found.sign('-', &mut is_parted),
                '⁰' => found.sign('0', &mut is_parted),
                '¹' => found.sign('1', &mut is_parted),
                '²' => found.sign('2', &mut is_parted),
                '³' => found.sign('3', &mut is_parted),
                '⁴' => found.sign('4', &mut is_parted),
                '⁵' => found.sign('5', &mut is_parted),
                '⁶' => found.sign('6', &mut is_parted),
                '⁷' => found.sign('7', &mut is_parted),
                '⁸' => found.sign('8', &mut is_parted),
                '⁹' => found.sign('9', &mut is_parted),
                // The micro sign and the Greek mu; the ohm sign and the Greek omega.
                '\u{b5}' | '\u{3bc}' => found.word("u", &mut is_parted),
                '\u{2126}' | '\u{3a9}' => found.word("ohm", &mut is_parted),
                '°' => found.word("deg", &mut is_parted),
                sign if sign.is_alphabetic() => found.word(sign.encode_utf8(&mut [0; 4]), &mut is_parted),
                sign => found.sign(sign, &mut is_parted),
            }
            if !is_parted {
                before = sign;
            }
        }
        found
    }

    /// Adds a character that is no letter: a space before it is no sign of a product.
    fn sign(&mut self, sign: char, is_parted: &mut bool) {
        *is_parted = false;
        self.text.push(sign);
    }

    /// Adds letters; a sign of a product counts after a letter or a power.
    fn word(&mut self, letters: &str, is_parted: &mut bool) {
        if std::mem::take(is_parted) && self.text.chars().next_back().is_some_and(char::is_alphanumeric) {
            self.products |= bit(self.text.len());
        }
        self.text.push_str(letters);
    }

    /// Returns the factors above the slash in a fixed order, and the text below it; `None` if there is one factor only,
    /// or if the place of a factor may be significant.
    pub(crate) fn factors(&self) -> Option<String> {
        let (above, below) = self.text.split_at(self.text.find('/').unwrap_or(self.text.len()));
        let is_plain = below.matches('/').count() < 2 && !self.text.contains(['(', ')']);
        let is_above = self.products != 0 && self.products < bit(above.len().max(1));
        if !is_plain || !is_above {
            return None;
        }
        let places = (1..above.len()).filter(|place| self.products & bit(*place) != 0);
        let (mut factors, mut begin) = (Vec::new(), 0);
        for end in places.chain([above.len()]) {
            factors.push(above.get(begin..end)?);
            begin = end;
        }
        factors.sort_unstable();
        Some(factors.join("·") + below)
    }

    /// Returns `true` if the name of a unit begins at a place: after a character that is no letter, or after the sign
    /// of a product.
    pub(crate) fn begins(&self, place: usize) -> bool {
        let before = self.text.get(..place).and_then(|text| text.chars().next_back());
        !before.is_some_and(char::is_alphabetic) || self.products & bit(place) != 0
    }
}

/// Returns `true` for characters that may precede the sign of a product.
fn is_of_unit(sign: char) -> bool {
    sign.is_alphabetic() || ['.', '°', '²', '³'].contains(&sign)
}

/// Returns the bit of a place; places after the last one share it.
pub(crate) const fn bit(place: usize) -> u64 {
    1 << if place < 63 { place } else { 63 }
}

/// Abbreviations of units with the words that they replace.
const WORDS: &[(&str, &[&str])] = &[
    ("deg", &["degree", "degrees", "Deg", "DEG", "Grad", "Grd"]),
    ("rev", &["turn", "turns", "revolution", "revolutions", "Umdrehung", "Umdrehungen", "Umdr"]),
    ("rad", &["radian", "radians"]),
    ("s", &["sec", "secs", "second", "seconds", "Sek", "Sekunde", "Sekunden"]),
    ("ms", &["msec", "msecs", "millisecond", "milliseconds", "Millisekunde", "Millisekunden"]),
    ("us", &["usec", "usecs", "\u{b5}sec", "\u{3bc}sec", "microsecond", "microseconds", "Mikrosekunden"]),
    ("ns", &["nsec", "nsecs", "nanosec", "nanosecond", "nanoseconds", "Nanosekunden"]),
    ("min", &["minute", "minutes", "Minute", "Minuten"]),
    ("h", &["hr", "hrs", "hour", "hours", "Stunde", "Stunden"]),
    ("rpm", &["RPM", "Rpm"]),
    ("krpm", &["kRPM", "KRPM"]),
    ("slug", &["slugs"]),
    ("m", &["metre", "metres", "meter", "meters", "Meter"]),
    ("mm", &["millimetre", "millimetres", "millimeter", "millimeters", "Millimeter"]),
    ("in", &["inch", "inches", "Zoll"]),
    ("ft", &["foot", "feet"]),
    ("lb", &["lbs"]),
    ("N", &["newton", "newtons", "Newton"]),
];

/// Replaces words by the abbreviations with the same meaning: `degrees/sec` becomes `deg/s`. Returns `None` if there is
/// none.
pub(crate) fn abbreviated(spelling: &str) -> Option<String> {
    let mut out = String::with_capacity(spelling.len());
    let mut rest = spelling;
    let mut is_changed = false;
    while let Some(first) = rest.chars().next() {
        let is_word = first.is_alphabetic();
        let length = rest.find(|sign: char| sign.is_alphabetic() != is_word).unwrap_or(rest.len());
        let (run, behind) = rest.split_at(length);
        let short = WORDS.iter().find(|(_, words)| is_word && words.contains(&run)).map(|(short, _)| *short);
        is_changed |= short.is_some();
        out.push_str(short.unwrap_or(run));
        rest = behind;
    }
    is_changed.then_some(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn canonical(spelling: &str) -> (String, Vec<usize>) {
        let found = Canonical::of(spelling);
        let places = (0..64).filter(|place| found.products & bit(*place) != 0).collect();
        (found.text, places)
    }

    #[test]
    fn signs_of_products_are_kept_as_places() {
        for (written, text, products) in [
            ("Nm", "Nm", vec![]),
            ("N m", "Nm", vec![1]),
            ("m·N", "mN", vec![1]),
            ("in.-lb.", "inlb", vec![2]),
            ("kgf\u{b7}cm\u{b7}s²", "kgfcms2", vec![3, 5]),
            ("m ** 2 * kg", "m2kg", vec![2]),
            ("kg.m2", "kgm2", vec![2]),
            ("10^-4 kg m^2", "10-4kgm2", vec![4, 6]),
            ("min⁻¹", "min-1", vec![]),
            ("deg·s^-1", "degs-1", vec![3]),
            ("lb-in²", "lbin2", vec![2]),
            ("° C", "degC", vec![3]),
            ("m^2 s", "m2s", vec![2]),
            (" ", "", vec![]),
        ] {
            assert_eq!(canonical(written), (text.to_owned(), products), "{written}");
        }
    }

    #[test]
    fn words_are_abbreviated_as_a_whole() {
        assert_eq!(abbreviated("degrees/sec").as_deref(), Some("deg/s"));
        assert_eq!(abbreviated("newton meter").as_deref(), Some("N m"));
        assert_eq!(abbreviated("arcsec"), None);
        assert_eq!(abbreviated("Grads"), None);
    }
}
