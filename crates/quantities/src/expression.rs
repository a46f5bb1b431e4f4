//! Interpretation of a text as a product of units, including units unknown to the program; shows which proposals would
//! change a value.

use crate::spelling::Canonical;

/// Powers of length, mass, time, current, temperature and angle.
pub(crate) type Powers = [i8; 6];

/// A meaning of a text: its value in SI, and its dimension.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Meaning {
    pub(crate) factor: f64,
    pub(crate) powers: Powers,
}

impl Meaning {
    const ONE: Self = Self { factor: 1.0, powers: [0; 6] };

    /// Returns the product with a power of another meaning.
    fn times(self, other: Self, power: i8) -> Option<Self> {
        let mut powers = self.powers;
        for (sum, each) in powers.iter_mut().zip(other.powers) {
            *sum = sum.checked_add(each.checked_mul(power)?)?;
        }
        Some(Self { factor: self.factor * other.factor.powi(power.into()), powers })
    }

    /// Returns `true` if both meanings agree within rounding.
    pub(crate) fn is(self, other: Self) -> bool {
        self.powers == other.powers && (self.factor - other.factor).abs() <= 1e-9 * other.factor.abs()
    }
}

/// Name, factor and powers of a unit; the flag permits SI prefixes.
type Symbol = (&'static str, f64, Powers, bool);

const POUND_FORCE: f64 = 0.453_592_37 * 9.806_65;
const TURN: f64 = std::f64::consts::TAU;

/// Units in the notation of publications, more than the program reads.
#[rustfmt::skip]
const SYMBOLS: &[Symbol] = &[
    ("m", 1.0, [1, 0, 0, 0, 0, 0], true),
    ("g", 1e-3, [0, 1, 0, 0, 0, 0], true),
    ("s", 1.0, [0, 0, 1, 0, 0, 0], true),
    ("sec", 1.0, [0, 0, 1, 0, 0, 0], true),
    ("A", 1.0, [0, 0, 0, 1, 0, 0], true),
    ("K", 1.0, [0, 0, 0, 0, 1, 0], true),
    ("rad", 1.0, [0, 0, 0, 0, 0, 1], true),
    ("deg", TURN / 360.0, [0, 0, 0, 0, 0, 1], true),
    // A gon in English, a degree in German.
    ("grad", TURN / 400.0, [0, 0, 0, 0, 0, 1], true),
    ("grad", TURN / 360.0, [0, 0, 0, 0, 0, 1], true),
    ("gon", TURN / 400.0, [0, 0, 0, 0, 0, 1], true),
    ("arcmin", TURN / 21_600.0, [0, 0, 0, 0, 0, 1], false),
    ("arcsec", TURN / 1_296_000.0, [0, 0, 0, 0, 0, 1], true),
    ("rev", TURN, [0, 0, 0, 0, 0, 1], true),
    ("U", TURN, [0, 0, 0, 0, 0, 1], false),
    ("r", TURN, [0, 0, 0, 0, 0, 1], false),
    ("rpm", TURN / 60.0, [0, 0, -1, 0, 0, 1], true),
    ("rps", TURN, [0, 0, -1, 0, 0, 1], true),
    ("min", 60.0, [0, 0, 1, 0, 0, 0], false),
    ("h", 3600.0, [0, 0, 1, 0, 0, 0], false),
    ("d", 86_400.0, [0, 0, 1, 0, 0, 0], false),
    ("a", 31_557_600.0, [0, 0, 1, 0, 0, 0], false),
    ("N", 1.0, [1, 1, -2, 0, 0, 0], true),
    ("J", 1.0, [2, 1, -2, 0, 0, 0], true),
    ("W", 1.0, [2, 1, -3, 0, 0, 0], true),
    ("Pa", 1.0, [-1, 1, -2, 0, 0, 0], true),
    ("bar", 1e5, [-1, 1, -2, 0, 0, 0], true),
    ("psi", POUND_FORCE / (0.0254 * 0.0254), [-1, 1, -2, 0, 0, 0], true),
    ("V", 1.0, [2, 1, -3, -1, 0, 0], true),
    ("ohm", 1.0, [2, 1, -3, -2, 0, 0], true),
    ("Ohm", 1.0, [2, 1, -3, -2, 0, 0], true),
    ("S", 1.0, [-2, -1, 3, 2, 0, 0], true),
    ("H", 1.0, [2, 1, -2, -2, 0, 0], true),
    ("F", 1.0, [-2, -1, 4, 2, 0, 0], true),
    ("T", 1.0, [0, 1, -2, -1, 0, 0], true),
    ("Wb", 1.0, [2, 1, -2, -1, 0, 0], true),
    ("C", 1.0, [0, 0, 1, 1, 0, 0], true),
    ("Hz", 1.0, [0, 0, -1, 0, 0, 0], true),
    ("t", 1e3, [0, 1, 0, 0, 0, 0], true),
    ("l", 1e-3, [3, 0, 0, 0, 0, 0], true),
    ("L", 1e-3, [3, 0, 0, 0, 0, 0], true),
    ("in", 0.0254, [1, 0, 0, 0, 0, 0], true),
    ("mil", 0.0254e-3, [1, 0, 0, 0, 0, 0], false),
    ("ft", 0.3048, [1, 0, 0, 0, 0, 0], true),
    ("yd", 0.9144, [1, 0, 0, 0, 0, 0], false),
    ("lb", 0.453_592_37, [0, 1, 0, 0, 0, 0], true),
    ("lbm", 0.453_592_37, [0, 1, 0, 0, 0, 0], false),
    ("oz", 0.453_592_37 / 16.0, [0, 1, 0, 0, 0, 0], true),
    ("slug", POUND_FORCE / 0.3048, [0, 1, 0, 0, 0, 0], false),
    ("lbf", POUND_FORCE, [1, 1, -2, 0, 0, 0], true),
    ("ozf", POUND_FORCE / 16.0, [1, 1, -2, 0, 0, 0], false),
    ("gf", 9.806_65e-3, [1, 1, -2, 0, 0, 0], true),
    ("p", 9.806_65e-3, [1, 1, -2, 0, 0, 0], true),
    ("dyn", 1e-5, [1, 1, -2, 0, 0, 0], true),
    ("hp", 550.0 * 0.3048 * POUND_FORCE, [2, 1, -3, 0, 0, 0], false),
    ("PS", 75.0 * 9.806_65, [2, 1, -3, 0, 0, 0], false),
];

const PREFIXES: &[(&str, f64)] = &[
    ("E", 1e18),
    ("P", 1e15),
    ("T", 1e12),
    ("G", 1e9),
    ("M", 1e6),
    ("k", 1e3),
    ("K", 1e3),
    ("h", 1e2),
    ("da", 1e1),
    ("d", 1e-1),
    ("c", 1e-2),
    ("m", 1e-3),
    ("u", 1e-6),
    ("n", 1e-9),
    ("p", 1e-12),
    ("f", 1e-15),
];

/// Maximum number of meanings of a text; with more, some would contradict each proposal.
const MEANINGS_MOST: usize = 32;

/// Maximum number of letters in a run; longer runs are no units.
const LETTERS_MOST: usize = 12;

/// Returns the meanings of a text as a product of units, with prefixes and powers; empty if it is no such product.
pub(crate) fn meanings(spelling: &Canonical) -> Vec<Meaning> {
    // Brackets after a slash are divided by as a whole, as is everything after a slash here.
    if spelling.text.is_empty() || spelling.text.matches('/').count() > 1 {
        return Vec::new();
    }
    let mut found = vec![Meaning::ONE];
    let mut place = 0;
    let mut sign = 1_i8;
    let mut has_unit = false;
    while let Some(rest) = spelling.text.get(place..).filter(|rest| !rest.is_empty()) {
        let Some(first) = rest.chars().next() else { break };
        match first {
            '/' => (sign, place) = (-sign, place + 1),
            '(' | ')' => place += 1,
            first if first.is_ascii_digit() => {
                // A number before the units: 1, 10-4, 1000.
                let length = rest.find(|sign: char| !sign.is_ascii_digit()).unwrap_or(rest.len());
                let power = exponent(rest.get(length..).unwrap_or_default()).filter(|(power, _)| *power < 0);
                let Ok(number) = rest.get(..length).unwrap_or_default().parse::<f64>() else { return Vec::new() };
                let (power, taken) = power.unwrap_or((1, 0));
                let factor = number.powi(i32::from(power) * i32::from(sign));
                found.iter_mut().for_each(|meaning| meaning.factor *= factor);
                place += length + taken;
            }
            first if first.is_ascii_alphabetic() => {
                let mut length = rest.find(|sign: char| !sign.is_ascii_alphabetic()).unwrap_or(rest.len());
                if let Some(at) = (1..length).find(|at| spelling.begins(place + at)) {
                    length = at;
                }
                if length > LETTERS_MOST {
                    return Vec::new();
                }
                let (run, behind) = rest.split_at(length);
                let (power, taken) = exponent(behind).unwrap_or((1, 0));
                // A prefix binds more tightly than a product: read with as few units as possible, mm is a length and no
                // area.
                let read = |count| {
                    let mut next = Vec::new();
                    found.iter().for_each(|meaning| products(run, count, *meaning, (sign, power), &mut next));
                    Some(next).filter(|next| !next.is_empty())
                };
                found = (1..=LETTERS_MOST).find_map(read).unwrap_or_default();
                has_unit = true;
                place += length + taken;
            }
            _ => return Vec::new(),
        }
        if found.is_empty() {
            return Vec::new();
        }
    }
    if has_unit { found } else { Vec::new() }
}

/// Returns the exponent at the beginning of a text, with its length.
fn exponent(text: &str) -> Option<(i8, usize)> {
    let digits = text.strip_prefix('-').unwrap_or(text);
    let count = digits.bytes().take_while(u8::is_ascii_digit).count();
    let length = text.len() - digits.len() + count;
    let power = text.get(..length).filter(|_| count > 0)?.parse().ok()?;
    Some((power, length))
}

/// Adds every reading of letters as `count` consecutive units, the last of them with a power.
fn products(run: &str, count: usize, before: Meaning, (sign, power): (i8, i8), found: &mut Vec<Meaning>) {
    if found.len() >= MEANINGS_MOST || run.len() < count {
        return;
    }
    let plain = [("", 1.0)];
    for (prefix, factor) in plain.iter().chain(PREFIXES) {
        let Some(named) = run.strip_prefix(prefix) else { continue };
        for (name, unit, powers, has_prefixes) in SYMBOLS {
            let Some(rest) = named.strip_prefix(name).filter(|_| prefix.is_empty() || *has_prefixes) else { continue };
            let is_last = count == 1;
            if rest.is_empty() != is_last {
                continue;
            }
            let unit = Meaning { factor: factor * unit, powers: *powers };
            let own = if is_last { power.checked_mul(sign) } else { Some(sign) };
            let Some(next) = own.and_then(|own| before.times(unit, own)) else { continue };
            if is_last {
                found.push(next);
            } else {
                products(rest, count - 1, next, (sign, power), found);
            }
        }
    }
}
