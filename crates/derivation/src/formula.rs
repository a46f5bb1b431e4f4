//! Formulas in the notation of a derivation: `T_L + 2*pi/60*(J_out + J_L)*n_2/t_1`.

use std::fmt;

/// Maximum nesting of parentheses.
const DEPTH_MAX: usize = 32;

/// A formula of numbers, symbols, `+ - * / ^`, parentheses, `pi` and the functions `sqrt abs min max exp ln sin cos tan
/// arccos arctan2`, with `int(x)` for ∫ x dt over the cycle and `sum(x)` for Σ x over the segments, which have no value of their own.
#[derive(Clone, Debug, PartialEq)]
pub enum Formula {
    /// A number, as written.
    Number(f64),
    /// A symbol.
    Symbol(String),
    /// A sign before a term.
    Minus(Box<Formula>),
    /// `+`, `-`, `*`, `/` or `^` between two terms.
    Binary(char, Box<Formula>, Box<Formula>),
    /// A function with its arguments.
    Function(String, Vec<Formula>),
}

/// Reason why a formula has no value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FormulaFault {
    /// The text cannot be parsed.
    Syntax {
        /// Byte at which the parser stopped.
        at: usize,
    },
    /// A symbol has no value.
    Unknown {
        /// The symbol.
        symbol: String,
    },
    /// A function does not exist, or not with this number of arguments.
    Function {
        /// Name of the function.
        name: String,
    },
}

impl fmt::Display for FormulaFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Syntax { at } => write!(f, "the formula does not read at byte {at}"),
            Self::Unknown { symbol } => write!(f, "no figure for `{symbol}`"),
            Self::Function { name } => write!(f, "no function `{name}` of these terms"),
        }
    }
}

impl std::error::Error for FormulaFault {}

/// Returns the names in a text in their order, without functions and `pi`.
pub(crate) fn symbols(text: &str) -> Vec<&str> {
    let is_name = |c: char| c.is_alphanumeric() || c == '_' || c == ',' || c == '\'';
    text.split(|c| !is_name(c))
        .map(|name| name.trim_matches([',', '\'']))
        .filter(|name| name.starts_with(char::is_alphabetic) && *name != "pi" && !FUNCTIONS.contains(name))
        .collect()
}

const FUNCTIONS: [&str; 13] =
    ["sqrt", "abs", "min", "max", "exp", "ln", "sin", "cos", "tan", "arccos", "arctan2", "int", "sum"];

impl Formula {
    /// Parses a formula.
    ///
    /// # Errors
    /// [`FormulaFault::Syntax`] if the text cannot be parsed.
    pub fn parse(text: &str) -> Result<Self, FormulaFault> {
        let mut reader = Reader { text, at: 0, depth: 0 };
        let formula = reader.sum()?;
        reader.space();
        if reader.at == text.len() { Ok(formula) } else { Err(reader.fault()) }
    }

    /// Evaluates the formula for given values of its symbols.
    ///
    /// # Errors
    /// [`FormulaFault`] if a symbol or a function is unknown.
    pub fn value(&self, figure: &dyn Fn(&str) -> Option<f64>) -> Result<f64, FormulaFault> {
        Ok(match self {
            Self::Number(number) => *number,
            Self::Symbol(name) if name == "pi" => std::f64::consts::PI,
            Self::Symbol(name) => figure(name).ok_or_else(|| FormulaFault::Unknown { symbol: name.clone() })?,
            Self::Minus(term) => -term.value(figure)?,
            Self::Binary(operator, a, b) => {
                let (a, b) = (a.value(figure)?, b.value(figure)?);
                match operator {
                    '+' => a + b,
                    '-' => a - b,
                    '*' => a * b,
                    '/' => a / b,
                    _ => a.powf(b),
                }
            }
            Self::Function(name, terms) => {
                let values = terms.iter().map(|term| term.value(figure)).collect::<Result<Vec<f64>, _>>()?;
                match (name.as_str(), values.as_slice()) {
                    ("sqrt", [x]) => x.sqrt(),
                    ("abs", [x]) => x.abs(),
                    ("exp", [x]) => x.exp(),
                    ("ln", [x]) => x.ln(),
                    ("sin", [x]) => x.sin(),
                    ("cos", [x]) => x.cos(),
                    ("tan", [x]) => x.tan(),
                    ("arccos", [x]) => x.clamp(-1.0, 1.0).acos(),
                    ("arctan2", [y, x]) => y.atan2(*x),
                    ("min", [first, rest @ ..]) => rest.iter().fold(*first, |a, b| a.min(*b)),
                    ("max", [first, rest @ ..]) => rest.iter().fold(*first, |a, b| a.max(*b)),
                    _ => return Err(FormulaFault::Function { name: name.clone() }),
                }
            }
        })
    }

    /// Formats the formula for display, with symbols and numbers formatted by the callers.
    #[must_use]
    pub fn shown(&self, symbol: &dyn Fn(&str) -> String, number: &dyn Fn(f64) -> String) -> String {
        self.write(0, symbol, number)
    }

    /// Returns the binding strength: sum 1, product 2, power 3, everything else 4. A term within another one of greater
    /// strength is enclosed in parentheses.
    #[must_use]
    pub const fn binding(&self) -> u8 {
        match self {
            Self::Binary('+' | '-', ..) => 1,
            Self::Binary('*' | '/', ..) => 2,
            Self::Minus(_) => 2,
            Self::Binary(..) => 3,
            _ => 4,
        }
    }

    /// Returns `true` for an integral or a sum.
    fn is_aggregate(&self) -> bool {
        matches!(self, Self::Function(name, _) if name == "int" || name == "sum")
    }

    fn write(&self, outer: u8, symbol: &dyn Fn(&str) -> String, number: &dyn Fn(f64) -> String) -> String {
        let own = self.binding();
        let inner = |term: &Self, least: u8| term.write(least, symbol, number);
        let text = match self {
            Self::Number(value) => number(*value),
            Self::Symbol(name) if name == "pi" => "π".to_owned(),
            Self::Symbol(name) => symbol(name),
            Self::Minus(term) => format!("−{}", inner(term, 3)),
            Self::Binary('+', a, b) => format!("{} + {}", inner(a, 1), inner(b, 1)),
            Self::Binary('-', a, b) => format!("{} − {}", inner(a, 1), inner(b, 2)),
            Self::Binary('*', a, b) => format!("{} · {}", inner(a, 2), inner(b, 2)),
            Self::Binary('/', a, b) => {
                let (above, below) = (inner(a, 2), whole(inner(b, 3), b));
                // The stroke is set apart from the dt of an integral.
                let stroke = if a.is_aggregate() || b.is_aggregate() { " / " } else { "/" };
                format!("{above}{stroke}{below}")
            }
            Self::Binary(_, a, b) => {
                let base = whole(inner(a, 4), a);
                match b.as_ref() {
                    Self::Number(power) if *power == 2.0 => format!("{base}²"),
                    Self::Number(power) if *power == 3.0 => format!("{base}³"),
                    power => format!("{base}^{}", inner(power, 4)),
                }
            }
            Self::Function(name, terms) => {
                let terms: Vec<String> = terms.iter().map(|term| inner(term, 0)).collect();
                match (name.as_str(), terms.as_slice()) {
                    ("sqrt", [term]) => return format!("√({term})"),
                    ("abs", [term]) => return format!("|{}|", bare(term)),
                    ("int", [term]) => return format!("∫{term} dt"),
                    ("sum", [term]) => return format!("Σ {term}"),
                    (name, [term]) => return format!("{name}({})", bare(term)),
                    (name, terms) => return format!("{name}({})", terms.join("; ")),
                }
            }
        };
        if own < outer { format!("({text})") } else { text }
    }
}

/// Encloses a value with its unit in parentheses if it replaces a symbol.
fn whole(text: String, term: &Formula) -> String {
    let apart = matches!(term, Formula::Symbol(_)) && text.contains(' ') && !text.starts_with('(');
    if apart { format!("({text})") } else { text }
}

/// Removes the parentheses around a single negative value.
fn bare(text: &str) -> &str {
    let inner = text.strip_prefix('(').and_then(|text| text.strip_suffix(')'));
    inner.filter(|inner| !inner.contains(['(', ')'])).unwrap_or(text)
}

struct Reader<'t> {
    text: &'t str,
    at: usize,
    depth: usize,
}

impl Reader<'_> {
    const fn fault(&self) -> FormulaFault {
        FormulaFault::Syntax { at: self.at }
    }

    fn rest(&self) -> &str {
        self.text.get(self.at..).unwrap_or_default()
    }

    fn space(&mut self) {
        self.at += self.rest().len() - self.rest().trim_start().len();
    }

    fn take(&mut self, wanted: &[char]) -> Option<char> {
        self.space();
        let next = self.rest().chars().next().filter(|c| wanted.contains(c))?;
        self.at += next.len_utf8();
        Some(next)
    }

    fn sum(&mut self) -> Result<Formula, FormulaFault> {
        self.depth += 1;
        if self.depth > DEPTH_MAX {
            return Err(self.fault());
        }
        let mut left = self.product()?;
        while let Some(operator) = self.take(&['+', '-']) {
            left = Formula::Binary(operator, Box::new(left), Box::new(self.product()?));
        }
        self.depth -= 1;
        Ok(left)
    }

    fn product(&mut self) -> Result<Formula, FormulaFault> {
        let mut left = self.signed()?;
        while let Some(operator) = self.take(&['*', '/']) {
            left = Formula::Binary(operator, Box::new(left), Box::new(self.signed()?));
        }
        Ok(left)
    }

    fn signed(&mut self) -> Result<Formula, FormulaFault> {
        if self.take(&['-']).is_some() {
            return Ok(Formula::Minus(Box::new(self.power()?)));
        }
        self.power()
    }

    fn power(&mut self) -> Result<Formula, FormulaFault> {
        let base = self.term()?;
        if self.take(&['^']).is_none() {
            return Ok(base);
        }
        let power = if self.take(&['-']).is_some() { Formula::Minus(Box::new(self.term()?)) } else { self.term()? };
        Ok(Formula::Binary('^', Box::new(base), Box::new(power)))
    }

    fn term(&mut self) -> Result<Formula, FormulaFault> {
        if self.take(&['(']).is_some() {
            let inner = self.sum()?;
            return if self.take(&[')']).is_some() { Ok(inner) } else { Err(self.fault()) };
        }
        self.space();
        let rest = self.rest();
        let first = rest.chars().next().ok_or_else(|| self.fault())?;
        if first.is_ascii_digit() {
            let end = number_end(rest);
            let number = rest.get(..end).and_then(|text| text.parse().ok()).ok_or_else(|| self.fault())?;
            self.at += end;
            return Ok(Formula::Number(number));
        }
        if !first.is_alphabetic() {
            return Err(self.fault());
        }
        let end = rest.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(rest.len());
        let name = rest.get(..end).unwrap_or_default().to_owned();
        self.at += end;
        if self.take(&['(']).is_none() {
            return Ok(Formula::Symbol(name));
        }
        let mut terms = vec![self.sum()?];
        while self.take(&[',', ';']).is_some() {
            terms.push(self.sum()?);
        }
        if self.take(&[')']).is_some() { Ok(Formula::Function(name, terms)) } else { Err(self.fault()) }
    }
}

/// Returns the length of the number at the start of a text: digits, a point, an exponent with its sign.
fn number_end(text: &str) -> usize {
    let mut end = 0;
    let mut last = ' ';
    for c in text.chars() {
        let sign = matches!(c, '+' | '-') && last == 'e';
        if !(c.is_ascii_digit() || c == '.' || c == 'e' || sign) {
            break;
        }
        last = c;
        end += c.len_utf8();
    }
    end
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(text: &str) -> f64 {
        let figure = |name: &str| match name {
            "a" => Some(2.0),
            "k_Tout" => Some(5.0),
            _ => None,
        };
        Formula::parse(text).unwrap().value(&figure).unwrap()
    }

    #[test]
    fn values_by_hand() {
        for (text, expected) in [
            ("1 + 2*3", 7.0),
            ("(1 + 2)*3", 9.0),
            ("10/4/5", 0.5),
            ("10 - 4 - 5", 1.0),
            ("-a^2", -4.0),
            ("2^-1", 0.5),
            ("sqrt(a*8) + abs(-3)", 7.0),
            ("min(a, k_Tout, 3)/max(1; 4)", 0.5),
            ("exp(ln(a))*1.5e-3", 0.003),
            ("2*pi/pi", 2.0),
            ("k_Tout*(a - 1)", 5.0),
            ("4*arctan2(1, 1) + 3*arccos(0.5) + arctan2(0, -1)", 3.0 * std::f64::consts::PI),
            ("tan(arctan2(a, k_Tout))", 0.4),
        ] {
            assert!((value(text) - expected).abs() < 1e-12, "{text}: {}", value(text));
        }
    }

    #[test]
    fn what_does_not_read_is_reported() {
        for text in ["", "1 +", "(1", "a b", "1..2", "f()", "+", "a^", "√2"] {
            assert!(matches!(Formula::parse(text), Err(FormulaFault::Syntax { .. })), "{text}");
        }
        assert!(Formula::parse(&"(".repeat(10_000)).is_err());
        let unknown = Formula::parse("foo(1)").unwrap().value(&|_| None);
        assert_eq!(unknown, Err(FormulaFault::Function { name: "foo".to_owned() }));
    }

    #[test]
    fn shown_it_reads_as_it_is_meant() {
        let shown = |text: &str| {
            Formula::parse(text).unwrap().shown(&|name| name.replace('_', ""), &|number| number.to_string())
        };
        for (text, expected) in [
            ("T_L + 2*pi/60*(J_out + J_L)*n_2/t_1", "TL + 2 · π/60 · (Jout + JL) · n2/t1"),
            ("sqrt(a^2 + b^2)", "√(a² + b²)"),
            ("a/(b*c)", "a/(b · c)"),
            ("a - (b - c)", "a − (b − c)"),
            ("-(a + b)", "−(a + b)"),
            ("abs(a)^2", "|a|²"),
            ("(a + b)^2", "(a + b)²"),
            ("2^-a", "2^(−a)"),
            ("(int(abs(T)^3*abs(n))/int(abs(n)))^(1/3)", "(∫|T|³ · |n| dt / ∫|n| dt)^(1/3)"),
            ("sqrt(int(I^2)/t_0)", "√(∫I² dt / t0)"),
            ("sum(t_k)", "Σ tk"),
        ] {
            assert_eq!(shown(text), expected);
        }
    }

    #[test]
    fn figures_with_units_are_held_together() {
        let figure = |name: &str| match name {
            "a" => "(−3 Nm)".to_owned(),
            "b" => "4 Nm/A".to_owned(),
            _ => "7".to_owned(),
        };
        let shown = |text: &str| Formula::parse(text).unwrap().shown(&figure, &|number| number.to_string());
        for (text, expected) in [
            ("a/b", "(−3 Nm)/(4 Nm/A)"),
            ("b^2 + c^2", "(4 Nm/A)² + 7²"),
            ("abs(a)", "|−3 Nm|"),
            ("cos(a)", "cos(−3 Nm)"),
            ("max(a, b)", "max((−3 Nm); 4 Nm/A)"),
            ("abs(a - b)", "|(−3 Nm) − 4 Nm/A|"),
            ("b/c", "4 Nm/A/7"),
        ] {
            assert_eq!(shown(text), expected);
        }
    }

    #[test]
    fn the_symbols_of_a_text() {
        assert_eq!(symbols("T_L + 2*pi/60*(J_out)"), ["T_L", "J_out"]);
        assert_eq!(symbols("max(abs(T(t)), T_L) over the cycle"), ["T", "t", "T_L", "over", "the", "cycle"]);
    }
}
