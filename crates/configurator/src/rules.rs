//! Whether an ordering code can be ordered.

use crate::matrix::{Entry, matrix};
use order_code::{Feedback, Field, Option1, Option2, OrderCode, Size};

/// How an ordering code can be had.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Availability {
    /// The fields that are on request only; empty: the code is available.
    pub on_request: Vec<Field>,
}

impl Availability {
    /// Whether everything of the code is available without asking.
    #[must_use]
    pub fn is_available(&self) -> bool {
        self.on_request.is_empty()
    }
}

/// A rule of the ordering tables that a code breaks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BrokenRule {
    /// The field that breaks it.
    pub field: Field,
    /// The rule.
    pub rule: Rule,
    /// The table that states it.
    pub table: &'static str,
}

/// What an ordering table demands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// The matrix has a dash for this field at this size.
    NotForSize,
    /// The ordering tables do not list this winding with this feedback.
    PairNotListed,
    /// The matrix lists this winding, but no ordering table does.
    NotInOrderingTables,
    /// The option exists with feedback M512P only.
    OnlyWithM512P,
    /// At this size the option exists with the resolver only.
    OnlyWithResolver,
}

/// Whether a code can be ordered, and which of its fields only on request.
///
/// # Source   cha-manual tables 11.3 (winding and feedback) and 12.1 (matrix, footnote 1)
/// # Errors
/// Every rule that the code breaks.
pub fn availability(code: &OrderCode) -> Result<Availability, Vec<BrokenRule>> {
    let (on_request, broken) = looked_up(code);
    // One rule per field, and of a winding or feedback that cannot be, nobody asks for the pair.
    let mut first: Vec<BrokenRule> = Vec::new();
    for rule in broken {
        let of_pair = |field| rule.rule == Rule::PairNotListed && field == Field::Winding;
        if !first.iter().any(|known| known.field == rule.field || of_pair(known.field)) {
            first.push(rule);
        }
    }
    if first.is_empty() { Ok(Availability { on_request }) } else { Err(first) }
}

/// The fields on request, and every rule that a code breaks, several of one field too.
pub(crate) fn looked_up(code: &OrderCode) -> (Vec<Field>, Vec<BrokenRule>) {
    let m = matrix();
    let mut broken = Vec::new();
    let mut on_request = Vec::new();
    let mut look = |field: Field, entry: Entry| match entry {
        Entry::Available => {}
        Entry::OnRequest => on_request.push(field),
        Entry::OnRequestForResolver if code.feedback == Feedback::RES => on_request.push(field),
        Entry::OnRequestForResolver => broken.push(BrokenRule { field, rule: Rule::OnlyWithResolver, table: "12.1" }),
        Entry::OnlyWithM512P if code.feedback == Feedback::M512P => {}
        Entry::OnlyWithM512P => broken.push(BrokenRule { field, rule: Rule::OnlyWithM512P, table: "12.1" }),
        Entry::NotAvailable => broken.push(BrokenRule { field, rule: Rule::NotForSize, table: "12.1" }),
    };
    look(Field::Ratio, m.ratio(code.size, code.ratio));
    look(Field::Winding, m.winding(code.size, code.winding));
    look(Field::Feedback, m.feedback(code.size, code.feedback));
    look(Field::Brake, m.brake(code.size, code.brake));
    look(Field::Option1, m.option_1(code.size, code.option_1));
    look(Field::Option2, m.option_2(code.size, code.option_2));
    if !m.ordered(code.winding) {
        broken.push(BrokenRule { field: Field::Winding, rule: Rule::NotInOrderingTables, table: "11.3" });
    } else if !m.pair(code.winding, code.feedback) {
        broken.push(BrokenRule { field: Field::Feedback, rule: Rule::PairNotListed, table: "11.3" });
    }
    if code.special {
        on_request.push(Field::Special);
    }
    (on_request, broken)
}

/// Something of a code that the printed tables do not cover.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Uncovered {
    /// Option K makes 14A and 17A longer; by how much is not printed.
    LongerWithK,
    /// A special design: the tables hold for the standard.
    SpecialDesign,
    /// Option EC: the tables tell nothing of what its encoder and inner hollow shaft change.
    OutputEncoder,
}

impl Uncovered {
    /// The data that are printed for the standard only and known to differ, or that may.
    #[must_use]
    pub const fn not_printed(self) -> &'static [&'static str] {
        match self {
            Self::LongerWithK => &["L", "L_brake"],
            Self::SpecialDesign => &["L", "L_brake", "m", "m_brake"],
            Self::OutputEncoder => &[],
        }
    }

    /// The data that a remark on it belongs to.
    #[must_use]
    pub const fn concerns(self) -> &'static [&'static str] {
        match self {
            Self::OutputEncoder => &["L", "L_brake", "m", "m_brake", "d_H"],
            Self::LongerWithK | Self::SpecialDesign => self.not_printed(),
        }
    }
}

/// What the printed tables do not cover of a code.
///
/// # Source   cha-manual tables 11.1 (special design) and 12.1 (footnote 1), section 6.25.1 (option EC)
#[must_use]
pub fn uncovered(code: &OrderCode) -> Vec<Uncovered> {
    let longer = matches!(code.option_2, Some(Option2::K)) && matches!(code.size, Size::S14A | Size::S17A);
    [
        (longer, Uncovered::LongerWithK),
        (code.special, Uncovered::SpecialDesign),
        (code.option_1 == Some(Option1::EC), Uncovered::OutputEncoder),
    ]
    .into_iter()
    .filter_map(|(is, what)| is.then_some(what))
    .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ask(text: &str) -> Result<Availability, Vec<BrokenRule>> {
        availability(&order_code::parse(text).unwrap().code)
    }

    #[test]
    fn the_example_of_the_manual_is_available_apart_from_k_and_sp() {
        let found = ask("CHA-20A-100-H-C1024-B-EC-K-SP").unwrap();
        assert_eq!(found.on_request, vec![Field::Option2, Field::Special]);
        assert!(ask("CHA-20A-100-H-C1024-B-EC").unwrap().is_available());
    }

    #[test]
    fn each_rule_is_named_with_its_table() {
        let rule = |text| ask(text).unwrap_err().iter().map(|b| (b.field, b.rule, b.table)).collect::<Vec<_>>();
        assert_eq!(rule("CHA-14A-120-E-RES"), vec![(Field::Ratio, Rule::NotForSize, "12.1")]);
        assert_eq!(rule("CHA-20A-100-N-C1024"), vec![(Field::Winding, Rule::NotForSize, "12.1")]);
        assert_eq!(rule("CHA-14A-100-H-D2048"), vec![(Field::Feedback, Rule::PairNotListed, "11.3")]);
        assert_eq!(rule("CHA-20A-100-L-C1024"), vec![(Field::Winding, Rule::NotInOrderingTables, "11.3")]);
        assert_eq!(rule("CHA-20A-100-H-C1024-R"), vec![(Field::Option2, Rule::OnlyWithM512P, "12.1")]);
        assert_eq!(rule("CHA-14A-100-H-M128S-K"), vec![(Field::Option2, Rule::OnlyWithResolver, "12.1")]);
        assert_eq!(rule("CHA-14A-120-H-C1024").len(), 2, "all broken rules at once");
    }

    #[test]
    fn the_resolver_of_the_large_sizes_is_on_request() {
        assert_eq!(ask("CHA-58A-50-H-RES").unwrap().on_request, vec![Field::Feedback]);
    }
}
