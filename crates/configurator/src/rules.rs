//! Whether an ordering code can be ordered.

use crate::matrix::{Entry, matrix};
use order_code::{Feedback, Field, OrderCode};

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
    let already = |broken: &[BrokenRule], field| broken.iter().any(|rule| rule.field == field);
    if !m.ordered(code.winding) {
        if !already(&broken, Field::Winding) {
            broken.push(BrokenRule { field: Field::Winding, rule: Rule::NotInOrderingTables, table: "11.3" });
        }
    } else if !m.pair(code.winding, code.feedback)
        && !already(&broken, Field::Feedback)
        && !already(&broken, Field::Winding)
    {
        broken.push(BrokenRule { field: Field::Feedback, rule: Rule::PairNotListed, table: "11.3" });
    }
    if code.special {
        on_request.push(Field::Special);
    }
    if broken.is_empty() { Ok(Availability { on_request }) } else { Err(broken) }
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
