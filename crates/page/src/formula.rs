//! Formulas of derivations as MathML, from their syntax tree.

use answers::{Formula, Node};
use maud::{Markup, html};
use quantities::Language;
use questions::texts::{number_and_unit, number_text};
use words::symbol_shown;

/// Returns the formula of a figure in symbols, with its plain text for screen readers.
pub(crate) fn symbols(node: &Node, language: Language) -> Option<Markup> {
    let text = node.formula.as_deref()?;
    let Some(tree) = &node.tree else { return Some(html! { span.words { (text) } }) };
    let inside = Notation { symbol: &|name| Inserted::plain(symbol(name)), language }.within(tree, Binding::NONE);
    let condition = node.condition.as_deref().map(|condition| html! { mtext.words { "\u{a0}" (condition) } });
    Some(
        html! { math displaystyle="true" alttext=(text) { mrow { (inside) @if let Some(condition) = condition { (condition) } } } },
    )
}

/// Returns the formula of a figure with the values inserted.
pub(crate) fn values(node: &Node, language: Language) -> Option<Markup> {
    let (text, tree) = (node.figures.as_deref()?, node.tree.as_ref()?);
    let inserted = |name: &str| {
        let operand = node.operands.iter().find(|operand| operand.symbol == name);
        operand.map_or_else(|| Inserted::plain(symbol(name)), |operand| amount(operand, language))
    };
    let inside = Notation { symbol: &inserted, language }.within(tree, Binding::NONE);
    Some(html! { math displaystyle="true" alttext=(text) { mrow { (inside) } } })
}

/// Returns a symbol with its index as subscript.
pub(crate) fn symbol_alone(name: &str) -> Markup {
    html! { math alttext=(symbol_shown(name)) { mrow { (symbol(name)) } } }
}

fn symbol(name: &str) -> Markup {
    let shown = symbol_shown(name);
    html! {
        @match shown.split_once('_') {
            Some((head, index)) => msub { mi { (head) } mtext { (index.replace('_', ",")) } },
            None => mi { (shown) },
        }
    }
}

/// Returns the value of a figure with its unit; enclosed in parentheses if negative.
fn amount(operand: &Node, language: Language) -> Inserted {
    let (number, unit) = number_and_unit(operand, language);
    let space = (unit != "°").then(|| html! { mspace width="0.17em" {} });
    let inside = html! { mn { (number) } @if let Some(unit) = (unit != "1").then_some(unit) { @if let Some(space) = space { (space) } mtext.unit { (unit) } } };
    if operand.value.0 < 0.0 {
        return Inserted::plain(fenced("(", &inside, ")"));
    }
    Inserted { markup: html! { mrow { (inside) } }, is_compound: unit != "1" }
}

/// The written form of a symbol in a formula.
struct Inserted {
    markup: Markup,
    /// Consists of several parts, which a power encloses in parentheses.
    is_compound: bool,
}

impl Inserted {
    const fn plain(markup: Markup) -> Self {
        Self { markup, is_compound: false }
    }
}

/// Binding strengths of [`Formula::binding`] that the surroundings of a term require.
struct Binding;

impl Binding {
    /// Below a root or in a fraction, which separate their terms by themselves.
    const NONE: u8 = 0;
    const SUBTRAHEND: u8 = 2;
    const FACTOR: u8 = 2;
    const NEGATED: u8 = 3;
    const BASE: u8 = 4;
}

fn fenced(open: &str, inside: &Markup, close: &str) -> Markup {
    html! { mrow { mo { (open) } (inside) mo { (close) } } }
}

/// Writes formulas as MathML.
struct Notation<'n> {
    /// Form of a symbol.
    symbol: &'n dyn Fn(&str) -> Inserted,
    language: Language,
}

impl Notation<'_> {
    /// Returns a term, in parentheses if its surroundings bind more strongly.
    fn within(&self, formula: &Formula, outer: u8) -> Markup {
        let is_fraction = matches!(formula, Formula::Binary('/', ..));
        let needs_fence = formula.binding() < outer && !(is_fraction && outer < Binding::BASE);
        let term = self.term(formula);
        if needs_fence { fenced("(", &term, ")") } else { term }
    }

    fn term(&self, formula: &Formula) -> Markup {
        let side = |term: &Formula, outer: u8| self.within(term, outer);
        match formula {
            Formula::Number(value) => html! { mn { (number_text(*value, self.language)) } },
            Formula::Symbol(name) if name == "pi" => html! { mi { "π" } },
            Formula::Symbol(name) => (self.symbol)(name).markup,
            Formula::Minus(term) => html! { mrow { mo form="prefix" { "−" } (side(term, Binding::NEGATED)) } },
            Formula::Binary('+', a, b) => html! { (side(a, Binding::NONE)) mo { "+" } (side(b, Binding::NONE)) },
            Formula::Binary('-', a, b) => html! { (side(a, Binding::NONE)) mo { "−" } (side(b, Binding::SUBTRAHEND)) },
            Formula::Binary('*', a, b) => html! { (side(a, Binding::FACTOR)) mo { "·" } (side(b, Binding::FACTOR)) },
            Formula::Binary('/', a, b) => {
                html! { mfrac { mrow { (side(a, Binding::NONE)) } mrow { (side(b, Binding::NONE)) } } }
            }
            Formula::Binary(_, base, exponent) => {
                html! { msup { mrow { (self.base(base)) } mrow { (side(exponent, Binding::NONE)) } } }
            }
            Formula::Function(name, terms) => self.function(name, terms),
        }
    }

    /// Returns the base of a power.
    fn base(&self, base: &Formula) -> Markup {
        match base {
            Formula::Symbol(name) if name != "pi" => {
                let Inserted { markup, is_compound } = (self.symbol)(name);
                if is_compound { fenced("(", &markup, ")") } else { markup }
            }
            base => self.within(base, Binding::BASE),
        }
    }

    fn function(&self, name: &str, terms: &[Formula]) -> Markup {
        let inside = |term: &Formula| self.within(term, Binding::NONE);
        match (name, terms) {
            ("sqrt", [term]) => html! { msqrt { mrow { (inside(term)) } } },
            ("abs", [term]) => fenced("|", &inside(term), "|"),
            ("int", [term]) => html! {
                mrow { mo { "∫" } (self.within(term, Binding::FACTOR)) mspace width="0.17em" {} mi mathvariant="normal" { "d" } mi { "t" } }
            },
            ("sum", [term]) => html! { mrow { mo { "∑" } (self.within(term, Binding::FACTOR)) } },
            (name, terms) => {
                let list = html! { @for (place, term) in terms.iter().enumerate() { @if place > 0 { mo separator="true" { ";" } } (inside(term)) } };
                html! { mrow { mi { (name) } (fenced("(", &list, ")")) } }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(text: &str) -> String {
        let notation = Notation { symbol: &|name| Inserted::plain(symbol(name)), language: Language::En };
        notation.within(&Formula::parse(text).unwrap(), Binding::NONE).into_string()
    }

    #[test]
    fn a_formula_reads_as_mathematics() {
        for (text, expected) in [
            ("T_rms", "<msub><mi>T</mi><mtext>rms</mtext></msub>"),
            ("accuracy_out", "<msub><mi>φ</mi><mtext>acc,out</mtext></msub>"),
            ("a/b", "<mfrac><mrow><mi>a</mi></mrow><mrow><mi>b</mi></mrow></mfrac>"),
            ("a/b*c", "<mfrac><mrow><mi>a</mi></mrow><mrow><mi>b</mi></mrow></mfrac><mo>·</mo><mi>c</mi>"),
            ("a/(b + c)", "<mfrac><mrow><mi>a</mi></mrow><mrow><mi>b</mi><mo>+</mo><mi>c</mi></mrow></mfrac>"),
            ("sqrt(x)", "<msqrt><mrow><mi>x</mi></mrow></msqrt>"),
            ("x^2", "<msup><mrow><mi>x</mi></mrow><mrow><mn>2</mn></mrow></msup>"),
            (
                "(a/b)^2",
                "<msup><mrow><mrow><mo>(</mo><mfrac><mrow><mi>a</mi></mrow><mrow><mi>b</mi></mrow></mfrac><mo>)</mo></mrow></mrow><mrow><mn>2</mn></mrow></msup>",
            ),
            ("a - (b - c)", "<mi>a</mi><mo>−</mo><mrow><mo>(</mo><mi>b</mi><mo>−</mo><mi>c</mi><mo>)</mo></mrow>"),
            ("abs(n)", "<mrow><mo>|</mo><mi>n</mi><mo>|</mo></mrow>"),
            (
                "min(a; b)",
                "<mrow><mi>min</mi><mrow><mo>(</mo><mi>a</mi><mo separator=\"true\">;</mo><mi>b</mi><mo>)</mo></mrow></mrow>",
            ),
            (
                "int(P)",
                "<mrow><mo>∫</mo><mi>P</mi><mspace width=\"0.17em\"></mspace><mi mathvariant=\"normal\">d</mi><mi>t</mi></mrow>",
            ),
        ] {
            assert_eq!(shown(text), expected, "{text}");
        }
    }

    fn figure(symbol: &str, value: f64, unit: &'static str) -> Node {
        Node {
            symbol: symbol.into(),
            term: String::new(),
            formula: None,
            figures: None,
            tree: None,
            condition: None,
            value: answers::Number(value),
            unit,
            grade: None,
            source: String::new(),
            page: None,
            model: None,
            errata: Vec::new(),
            repeated: false,
            operands: Vec::new(),
        }
    }

    #[test]
    fn inserted_values_keep_their_unit_and_sign_together() {
        let node = Node {
            figures: Some("plain".into()),
            tree: Some(Formula::parse("a^2 + b*c").unwrap()),
            operands: vec![figure("a", 2.5, "Nm"), figure("b", -3.0, "A"), figure("c", 7.0, "1")],
            ..figure("x", 0.0, "1")
        };
        let found = values(&node, Language::De).unwrap().into_string();
        let unit = |unit: &str| format!("<mspace width=\"0.17em\"></mspace><mtext class=\"unit\">{unit}</mtext>");
        assert!(found.contains(&format!("<mo>(</mo><mrow><mn>2,5</mn>{}</mrow><mo>)</mo>", unit("Nm"))), "{found}");
        assert!(found.contains(&format!("<mrow><mo>(</mo><mn>−3</mn>{}<mo>)</mo></mrow>", unit("A"))), "{found}");
        assert!(found.contains("<mo>·</mo><mrow><mn>7</mn></mrow>") && found.contains("alttext=\"plain\""), "{found}");
    }
}
