//! Formulas in the notation of the derivations, parsed and written as MathML.
//!
//! `T_rms` has a subscript, `²` and `^` are powers, `√(…)` is a root and `|…|` an absolute value. `a/b` and `a / b` are
//! fractions: without spaces, of the two adjacent factors; with spaces, of the whole products on both sides. Words stay
//! words. A text that is no formula is shown as text.

use maud::{Markup, PreEscaped, html};
use quantities::Unit;

/// Returns a formula as MathML, with its plain text for screen readers.
pub(crate) fn math(text: &str) -> Markup {
    let inside = read(text).unwrap_or_else(|| tag("mtext", text));
    html! { math displaystyle="true" alttext=(text) { mrow { (PreEscaped(inside)) } } }
}

/// Returns a symbol as MathML; the part behind its `_` is the subscript.
pub(crate) fn symbol(text: &str) -> Markup {
    let inside = read(text).unwrap_or_else(|| tag("mtext", text));
    html! { math alttext=(text) { mrow { (PreEscaped(inside)) } } }
}

/// Parses a formula to MathML; `None` if it is no formula.
fn read(text: &str) -> Option<String> {
    let mut reader = Reader { rest: text, depth: 0, in_amount: false };
    let found = reader.sequence()?;
    reader.rest.is_empty().then_some(found)
}

/// Deepest nesting of a formula.
const DEPTH_MAX: usize = 32;

/// Names of functions, set upright.
const FUNCTIONS: [&str; 7] = ["min", "max", "exp", "ln", "sin", "cos", "sqrt"];

/// Escapes a text as the content of an element.
pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

fn tag(name: &str, text: &str) -> String {
    format!("<{name}>{}</{name}>", escaped(text))
}

fn operator(text: &str) -> String {
    tag("mo", text)
}

/// A parsed factor, and its content without the enclosing parentheses.
struct Factor {
    shown: String,
    bare: Option<String>,
}

impl Factor {
    const fn plain(shown: String) -> Self {
        Self { shown, bare: None }
    }

    /// Returns the factor as a side of a fraction or below a root, where parentheses are superfluous.
    fn held(self) -> String {
        let inside = self.bare.unwrap_or(self.shown);
        format!("<mrow>{inside}</mrow>")
    }
}

struct Reader<'t> {
    rest: &'t str,
    depth: usize,
    /// Inside `|…|`: the next `|` ends it.
    in_amount: bool,
}

/// Returns the character that a superscript character stands for.
fn superscript(sign: char) -> Option<char> {
    let place = "⁻⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|raised| raised == sign)?;
    "−0123456789".chars().nth(place)
}

impl<'t> Reader<'t> {
    fn next(&self) -> Option<char> {
        self.rest.chars().next()
    }

    fn skip(&mut self, bytes: usize) -> &'t str {
        let (taken, rest) = self.rest.split_at_checked(bytes).unwrap_or((self.rest, ""));
        self.rest = rest;
        taken
    }

    fn take(&mut self, wanted: &str) -> bool {
        let found = self.rest.strip_prefix(wanted);
        self.rest = found.unwrap_or(self.rest);
        found.is_some()
    }

    /// Returns the length in bytes of the leading characters of a class.
    fn length(&self, is_of: impl Fn(char) -> bool) -> usize {
        self.rest.find(|sign| !is_of(sign)).unwrap_or(self.rest.len())
    }

    /// Parses sums, relations, words and their separators, up to an end.
    fn sequence(&mut self) -> Option<String> {
        self.depth += 1;
        if self.depth > DEPTH_MAX {
            return None;
        }
        let mut found = String::new();
        loop {
            let spaces = self.length(|sign| sign == ' ');
            self.skip(spaces);
            let Some(next) = self.next() else { break };
            if next == ')' || (next == '|' && self.in_amount) {
                break;
            }
            if let Some(word) = self.word() {
                let mut words = String::from(word);
                loop {
                    let before = self.rest;
                    let next = if self.take(" ") { self.word() } else { None };
                    let Some(next) = next else {
                        self.rest = before;
                        break;
                    };
                    words.push('\u{a0}');
                    words.push_str(next);
                }
                let separated = if found.is_empty() { "" } else { "\u{a0}" };
                let goes_on = !self.rest.is_empty() && !self.rest.starts_with([',', ':', ')', '|']);
                let after = if goes_on { "\u{a0}" } else { "" };
                found.push_str(&format!("<mtext class=\"words\">{separated}{}{after}</mtext>", escaped(&words)));
                continue;
            }
            match next {
                '+' | '−' | '-' | '=' | '<' | '>' | '≤' | '≥' if self.rest.chars().nth(1) == Some(' ') => {
                    self.skip(next.len_utf8());
                    found.push_str(&operator(&next.to_string()));
                }
                ',' | ';' | ':' | '.' => {
                    self.skip(1);
                    found.push_str("<mo separator=\"true\">");
                    found.push(next);
                    found.push_str("</mo>");
                }
                _ => found.push_str(&self.product()?),
            }
        }
        self.depth -= 1;
        Some(found)
    }

    /// Parses a word of a sentence: letters only, and neither a symbol nor a function.
    fn word(&mut self) -> Option<&'t str> {
        let length = self.length(|sign| sign.is_alphabetic() || sign == '-' || sign == '’');
        let (word, after) = self.rest.split_at_checked(length)?;
        let is_greek = |sign: char| matches!(sign, 'α'..='ω' | 'Α'..='Ω' | 'ϑ' | 'µ');
        let is_symbol = word.chars().any(is_greek)
            || word.chars().any(|sign| superscript(sign).is_some())
            || after.starts_with(['_', '(', '^', '\''])
            || after.starts_with(|sign: char| sign.is_ascii_digit() || superscript(sign).is_some())
            || FUNCTIONS.contains(&word)
            || matches!(word, "dt");
        let letters = word.chars().filter(|sign| sign.is_alphabetic()).count();
        // The English article is followed by another word.
        let is_article = word == "a"
            && after
                .strip_prefix(' ')
                .is_some_and(|rest| rest.find(|sign: char| !sign.is_alphabetic()).unwrap_or(rest.len()) > 1);
        (is_article || (letters > 1 && !word.starts_with('-') && !is_symbol)).then(|| self.skip(length))
    }

    /// Parses factors with a multiplication sign between them.
    fn product(&mut self) -> Option<String> {
        let mut found = self.fraction()?.shown;
        while self.take(" · ") {
            found.push_str(&operator("·"));
            found.push_str(&self.fraction()?.shown);
        }
        Some(found)
    }

    /// Parses adjacent factors, and a fraction with spaces around its stroke.
    fn fraction(&mut self) -> Option<Factor> {
        let mut found = self.side_by_side()?;
        while self.take(" / ") {
            let below = self.side_by_side()?;
            found = Factor::plain(format!("<mfrac>{}{}</mfrac>", found.held(), below.held()));
        }
        Some(found)
    }

    fn side_by_side(&mut self) -> Option<Factor> {
        let mut found = self.tight()?;
        loop {
            let before = self.rest;
            let spaces = self.length(|sign| sign == ' ');
            let next = self.rest.get(spaces..).and_then(|rest| rest.chars().next());
            let goes_on = next.is_some_and(|sign| {
                sign.is_alphanumeric()
                    || matches!(sign, '(' | '√' | '∫' | 'Σ' | '∑')
                    || (sign == '|' && !self.in_amount)
            });
            // Factors may follow without a space only after an operator, as in ∫α.
            if !goes_on || (spaces == 0 && !found.shown.ends_with("</mo>")) {
                return Some(found);
            }
            self.skip(spaces);
            let mut ahead = Reader { rest: self.rest, depth: 0, in_amount: self.in_amount };
            if ahead.word().is_some() {
                self.rest = before;
                return Some(found);
            }
            let further = self.tight()?;
            let between = if found.shown.ends_with("</mo>") { "" } else { "<mspace width=\"0.17em\"/>" };
            found = Factor::plain(format!("{}{between}{}", found.shown, further.shown));
        }
    }

    /// Parses a power, divided without spaces.
    fn tight(&mut self) -> Option<Factor> {
        let mut found = self.power()?;
        while self.rest.starts_with('/') {
            self.skip(1);
            let below = self.power()?;
            found = Factor::plain(format!("<mfrac>{}{}</mfrac>", found.held(), below.held()));
        }
        Some(found)
    }

    fn power(&mut self) -> Option<Factor> {
        let base = self.atom()?;
        let length = self.length(|sign| superscript(sign).is_some());
        let raised = if length > 0 {
            let digits: String = self.skip(length).chars().filter_map(superscript).collect();
            digits.strip_prefix('−').map_or_else(
                || tag("mn", &digits),
                |digits| format!("<mrow>{}{}</mrow>", operator("−"), tag("mn", digits)),
            )
        } else if self.take("^") {
            self.atom()?.held()
        } else {
            return Some(base);
        };
        Some(Factor::plain(format!("<msup><mrow>{}</mrow>{raised}</msup>", base.shown)))
    }

    fn atom(&mut self) -> Option<Factor> {
        let next = self.next()?;
        let plain = |text: String| Some(Factor::plain(text));
        match next {
            '0'..='9' => plain(self.number()),
            '(' => {
                self.skip(1);
                let inside = self.enclosed(')')?;
                let shown = format!("<mrow><mo>(</mo>{inside}<mo>)</mo></mrow>");
                Some(Factor { shown, bare: Some(inside) })
            }
            '|' => {
                self.skip(1);
                let outer = std::mem::replace(&mut self.in_amount, true);
                let inside = self.enclosed('|');
                self.in_amount = outer;
                plain(format!("<mrow><mo>|</mo>{}<mo>|</mo></mrow>", inside?))
            }
            '√' => {
                self.skip(next.len_utf8());
                let below = self.atom()?.held();
                plain(format!("<msqrt>{below}</msqrt>"))
            }
            '∫' | 'Σ' | '∑' => {
                self.skip(next.len_utf8());
                plain(operator(if next == '∫' { "∫" } else { "∑" }))
            }
            '−' | '-' => {
                self.skip(next.len_utf8());
                let of = self.power()?;
                plain(format!("<mrow><mo form=\"prefix\">−</mo>{}</mrow>", of.shown))
            }
            '°' | '%' => {
                self.skip(next.len_utf8());
                plain(tag("mi", &next.to_string()))
            }
            sign if sign.is_alphabetic() => self.name(),
            _ => None,
        }
    }

    /// Parses the content up to a closing character, and consumes it.
    fn enclosed(&mut self, end: char) -> Option<String> {
        let outer = self.in_amount;
        self.in_amount = end == '|';
        let inside = self.sequence()?;
        self.in_amount = outer;
        (self.next() == Some(end)).then(|| self.skip(1))?;
        Some(inside)
    }

    /// Parses a number with its power of ten and its unit.
    fn number(&mut self) -> String {
        let mut length = 0;
        let mut signs = self.rest.char_indices().peekable();
        while let Some((at, sign)) = signs.next() {
            let is_point = matches!(sign, '.' | ',') && signs.peek().is_some_and(|(_, next)| next.is_ascii_digit());
            if !sign.is_ascii_digit() && !is_point {
                break;
            }
            length = at + sign.len_utf8();
        }
        let mut found = tag("mn", self.skip(length));
        if self.rest.starts_with("·10") || self.rest.starts_with(" · 10⁻") || self.rest.starts_with(" · 10⁺") {
            let point = if self.rest.starts_with(' ') { " · " } else { "·" };
            self.skip(point.len());
            let ten = self.skip(2);
            let raised = self.length(|sign| superscript(sign).is_some());
            let digits: String = self.skip(raised).chars().filter_map(superscript).collect();
            found.push_str(&operator("·"));
            found.push_str(&format!("<msup>{}{}</msup>", tag("mn", ten), tag("mn", &digits)));
        }
        if let Some(unit) = self.unit() {
            let space = if unit == "°" { "" } else { "<mspace width=\"0.17em\"/>" };
            found.push_str(&format!("{space}<mtext class=\"unit\">{}</mtext>", escaped(unit)));
        }
        format!("<mrow>{found}</mrow>")
    }

    /// Parses the unit after a number: the longest known one.
    fn unit(&mut self) -> Option<&'t str> {
        let spaces = self.length(|sign| sign == ' ');
        if spaces > 1 {
            return None;
        }
        let rest = self.rest.get(spaces..)?;
        let is_of_unit = |sign: char| !matches!(sign, ' ' | '+' | '−' | ';' | ',' | '|' | '=');
        let most = rest.find(|sign| !is_of_unit(sign)).unwrap_or(rest.len());
        let ends = rest.char_indices().map(|(at, sign)| at + sign.len_utf8()).take_while(|end| *end <= most);
        let is_whole = |end: usize| {
            let after = rest.get(end..).and_then(|rest| rest.chars().next());
            after.is_none_or(|sign| !sign.is_alphanumeric() && sign != '_' && superscript(sign).is_none())
        };
        let known = |end: &usize| rest.get(..*end).is_some_and(|unit| Unit::of(unit).is_some()) && is_whole(*end);
        // A space is required before all units but the degree; a stroke followed by a number is a fraction.
        let end = ends.filter(known).max()?;
        let unit = rest.get(..end)?;
        if (spaces == 0) != (unit == "°") {
            return None;
        }
        self.skip(spaces + end);
        Some(unit)
    }

    /// Parses a symbol with its subscript, or a function with its arguments.
    fn name(&mut self) -> Option<Factor> {
        let head =
            self.skip(self.length(|sign| (sign.is_alphanumeric() && superscript(sign).is_none()) || sign == '\''));
        if FUNCTIONS.contains(&head) {
            let name = tag("mi", head);
            if !self.rest.starts_with('(') {
                let space = if self.take(" ") { "<mspace width=\"0.17em\"/>" } else { "" };
                return Some(Factor::plain(format!("{name}{space}")));
            }
            self.skip(1);
            let inside = self.enclosed(')')?;
            return Some(Factor::plain(format!("<mrow>{name}<mo>(</mo>{inside}<mo>)</mo></mrow>")));
        }
        if head == "dt" {
            return Some(Factor::plain("<mrow><mi mathvariant=\"normal\">d</mi><mi>t</mi></mrow>".into()));
        }
        if !self.rest.starts_with('_') {
            return Some(Factor::plain(tag("mi", head)));
        }
        self.skip(1);
        let mut length = 0;
        let mut signs = self.rest.char_indices().peekable();
        while let Some((at, sign)) = signs.next() {
            let is_between = matches!(sign, ',' | '_') && signs.peek().is_some_and(|(_, next)| next.is_alphanumeric());
            if !is_between && (!sign.is_alphanumeric() || superscript(sign).is_some()) {
                break;
            }
            length = at + sign.len_utf8();
        }
        if length == 0 {
            return None;
        }
        let index = self.skip(length).replace('_', ",");
        Some(Factor::plain(format!("<msub>{}<mtext>{}</mtext></msub>", tag("mi", head), escaped(&index))))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use answers::Node;
    use quantities::Language;
    use questions::list::explain::derivation;
    use questions::list::new::{template, template_kinds};
    use questions::list::size::sized;
    use questions::{CandidateId, MechanismId, Patience, Rejected, explain, read_all};

    fn shown(text: &str) -> String {
        read(text).unwrap_or_else(|| panic!("{text}"))
    }

    #[test]
    fn a_formula_reads_as_mathematics() {
        assert_eq!(shown("T_rms"), "<msub><mi>T</mi><mtext>rms</mtext></msub>");
        assert_eq!(shown("φ_acc,out"), "<msub><mi>φ</mi><mtext>acc,out</mtext></msub>");
        assert_eq!(shown("a/b"), "<mfrac><mrow><mi>a</mi></mrow><mrow><mi>b</mi></mrow></mfrac>");
        assert_eq!(shown("√(x)"), "<msqrt><mrow><mi>x</mi></mrow></msqrt>");
        assert_eq!(shown("x²"), "<msup><mrow><mi>x</mi></mrow><mn>2</mn></msup>");
        assert_eq!(
            shown("2,5 Nm"),
            "<mrow><mn>2,5</mn><mspace width=\"0.17em\"/><mtext class=\"unit\">Nm</mtext></mrow>"
        );
        assert!(shown("|n| + 1").contains("<mo>|</mo><mi>n</mi><mo>|</mo>"));
        assert!(shown("min(a; b)").contains("<mi>min</mi><mo>(</mo><mi>a</mi>"));
    }

    #[test]
    fn a_stroke_with_spaces_divides_all_beside_it() {
        let found = shown("(Σ |n_k| t_k / Σ t_k)^(1/B) over the segments");
        assert!(found.starts_with("<msup><mrow><mrow><mo>(</mo><mfrac><mrow><mo>∑</mo><mrow><mo>|</mo>"), "{found}");
        assert!(found.ends_with("<mtext class=\"words\">\u{a0}over\u{a0}the\u{a0}segments</mtext>"), "{found}");
        let tight = shown("x · a/b");
        assert!(tight.starts_with("<mi>x</mi><mo>·</mo><mfrac>"), "{tight}");
    }

    #[test]
    fn a_unit_ends_where_a_division_begins() {
        let found = shown("12 Nm/(3 1/min)");
        assert!(found.starts_with("<mfrac><mrow><mrow><mn>12</mn>") && found.contains(">1/min</mtext>"), "{found}");
        assert!(shown("12 Nm/3").contains(">Nm</mtext></mrow></mrow><mrow><mrow><mn>3</mn>"));
        assert!(!shown("1.5 R_hot I²").contains("unit"));
    }

    #[test]
    fn what_does_not_read_stands_there_as_text() {
        for text in ["(a", "a)", "T_", "{x}", "", &"(".repeat(100)] {
            let found = math(text).into_string();
            assert!(found.contains("<mtext>") || text.is_empty(), "{text}: {found}");
            assert!(found.contains("alttext"), "{text}");
        }
        assert!(math("<script>").into_string().contains("&lt;script&gt;"));
    }

    fn walk(node: &Node, look: &mut impl FnMut(&str)) {
        look(&node.symbol);
        for text in [&node.formula, &node.figures].into_iter().flatten() {
            look(text);
        }
        for operand in &node.operands {
            walk(operand, look);
        }
    }

    /// Parses every formula of every check of every example, and every text of a finding, in both languages.
    #[test]
    fn every_formula_of_the_program_reads() {
        let mut count = 0;
        let mut seen = std::collections::BTreeSet::new();
        let mut look = |text: &str| {
            count += 1;
            if !text.is_empty() && seen.insert(text.to_owned()) && read(text).is_none() {
                panic!("does not read: {text}");
            }
        };
        for language in Language::ALL {
            for what in sizing::derivation::Finding::ALL {
                look(&words::found_text(*what, language));
            }
        }
        let texts = MechanismId::ALL.iter().map(|id| id.example().to_owned());
        let templates = template_kinds().filter_map(|kind| Some(template(kind, "axis.toml", Language::En)?.text));
        for text in texts.chain(templates) {
            let Ok(projects) = read_all(&text, &project::NoFiles) else { continue };
            for project in &projects {
                let Ok(found) = sized(project, 0, Rejected::Nearest, &Patience::endless()) else { continue };
                for candidate in found.candidates.iter().take(2) {
                    let CandidateId::Code(code) = &candidate.id else { continue };
                    let Ok(explained) = explain(project, code) else { continue };
                    for check in &explained.judgement.checks {
                        for language in Language::ALL {
                            let found = derivation(check, language);
                            for root in [found.value, found.limit].iter().flatten() {
                                walk(root, &mut look);
                            }
                        }
                    }
                }
            }
        }
        assert!(count > 5000, "{count}");
    }
}
