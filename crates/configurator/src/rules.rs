//! Whether an ordering code can be ordered.

use crate::matrix::matrix;
use catalogue::MarkEntry;
use order_code::{Brake, Feedback, Field, Option1, Option2, OrderCode, Series};

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
    /// At this size the word exists with this feedback only.
    OnlyWith {
        /// The feedback.
        feedback: Feedback,
        /// Mark of the footnote that says that the actuator becomes longer; empty: it does not.
        longer: &'static str,
    },
}

/// Whether a code can be ordered, and which of its fields only on request.
///
/// # Errors
/// Every rule that the code breaks.
pub fn availability(code: &OrderCode) -> Result<Availability, Vec<BrokenRule>> {
    let (on_request, broken) = looked_up(code);
    // One rule per field; for an invalid winding or feedback the pair is not checked.
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
    let mut broken = Vec::new();
    let mut on_request = Vec::new();
    let Some(m) = matrix(code.series()) else { return (on_request, broken) };
    let words = [
        (Field::Ratio, Some(code.ratio.place())),
        (Field::Winding, Some(code.winding.place())),
        (Field::Feedback, Some(code.feedback.place())),
        (Field::Brake, (code.brake == Brake::With).then_some(0)),
        (Field::Option1, code.option_1.map(Option1::place)),
        (Field::Option2, code.option_2.map(Option2::place)),
    ];
    for (field, word) in words {
        let Some(word) = word else { continue };
        let mark = m.entry(code.size, field, word);
        let rule = match (mark.entry, mark.feedback) {
            (_, Some(feedback)) if feedback != code.feedback => Rule::OnlyWith { feedback, longer: mark.longer },
            (MarkEntry::Available, _) => continue,
            (MarkEntry::OnRequest, _) => {
                on_request.push(field);
                continue;
            }
            (MarkEntry::NotAvailable, _) => Rule::NotForSize,
        };
        broken.push(BrokenRule { field, rule, table: m.data.matrix });
    }
    if !m.ordered(code.winding) {
        broken.push(BrokenRule { field: Field::Winding, rule: Rule::NotInOrderingTables, table: m.data.pairs });
    } else if !m.pair(code.winding, code.feedback) {
        broken.push(BrokenRule { field: Field::Feedback, rule: Rule::PairNotListed, table: m.data.pairs });
    }
    if code.special {
        on_request.push(Field::Special);
    }
    (on_request, broken)
}

/// Something of a code that the printed tables do not cover.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Uncovered {
    /// An option makes the actuator longer; by how much is not printed.
    LongerWith {
        /// The option.
        option: Option2,
        /// Table of the matrix.
        table: &'static str,
        /// Mark of its footnote that says so.
        footnote: &'static str,
    },
    /// A special design: the tables hold for the standard.
    SpecialDesign(Series),
    /// An encoder at the output: the tables do not say what it and its inner hollow shaft change.
    OutputEncoder(Option1),
}

impl Uncovered {
    /// The data that are printed for the standard only and known to differ, or that may.
    #[must_use]
    pub const fn not_printed(self) -> &'static [&'static str] {
        match self {
            Self::LongerWith { .. } => &["L", "L_brake"],
            Self::SpecialDesign(_) => &["L", "L_brake", "m", "m_brake"],
            Self::OutputEncoder(_) => &[],
        }
    }

    /// The data that a remark on it belongs to.
    #[must_use]
    pub const fn concerns(self) -> &'static [&'static str] {
        match self {
            Self::OutputEncoder(_) => &["L", "L_brake", "m", "m_brake", "d_H"],
            Self::LongerWith { .. } | Self::SpecialDesign(_) => self.not_printed(),
        }
    }
}

/// What the printed tables do not cover of a code.
///
/// # Source
/// The marks of the matrix; cha-manual table 11.1 (special design), section 6.25.1 (option EC)
#[must_use]
pub fn uncovered(code: &OrderCode) -> Vec<Uncovered> {
    let longer = matrix(code.series()).zip(code.option_2).and_then(|(m, option)| {
        let footnote = m.entry(code.size, Field::Option2, option.place()).longer;
        (!footnote.is_empty()).then_some(Uncovered::LongerWith { option, table: m.data.matrix, footnote })
    });
    let special = code.special.then_some(Uncovered::SpecialDesign(code.series()));
    [longer, special, code.option_1.map(Uncovered::OutputEncoder)].into_iter().flatten().collect()
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
        let only_with = |word, longer| {
            let feedback = Feedback::of(Series::default(), word).unwrap();
            Rule::OnlyWith { feedback, longer }
        };
        assert_eq!(rule("CHA-14A-120-E-RES"), vec![(Field::Ratio, Rule::NotForSize, "12.1")]);
        assert_eq!(rule("CHA-20A-100-N-C1024"), vec![(Field::Winding, Rule::NotForSize, "12.1")]);
        assert_eq!(rule("CHA-14A-100-H-D2048"), vec![(Field::Feedback, Rule::PairNotListed, "11.3")]);
        assert_eq!(rule("CHA-20A-100-L-C1024"), vec![(Field::Winding, Rule::NotInOrderingTables, "11.3")]);
        assert_eq!(rule("CHA-20A-100-H-C1024-R"), vec![(Field::Option2, only_with("M512P", ""), "12.1")]);
        assert_eq!(rule("CHA-14A-100-H-M128S-K"), vec![(Field::Option2, only_with("RES", "1"), "12.1")]);
        assert_eq!(rule("CHA-14A-120-H-C1024").len(), 2, "all broken rules at once");
    }

    #[test]
    fn the_resolver_of_the_large_sizes_is_on_request() {
        assert_eq!(ask("CHA-58A-50-H-RES").unwrap().on_request, vec![Field::Feedback]);
    }
}
