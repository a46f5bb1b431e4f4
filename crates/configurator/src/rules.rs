//! Rules of the ordering tables: availability of ordering codes.

use crate::matrix::matrix;
use catalogue::MarkEntry;
use order_code::{Brake, Feedback, Field, Option1, Option2, OrderCode, Series};

/// Availability of an ordering code.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Availability {
    /// Fields available on request only; empty if the code is available.
    pub on_request: Vec<Field>,
}

impl Availability {
    /// Returns `true` if all fields of the code are available without request.
    #[must_use]
    pub fn is_available(&self) -> bool {
        self.on_request.is_empty()
    }
}

/// A rule of the ordering tables that a code breaks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BrokenRule {
    /// Field whose word breaks the rule.
    pub field: Field,
    /// Kind of rule.
    pub rule: Rule,
    /// Table that states the rule.
    pub table: &'static str,
}

/// Kind of rule of the ordering tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// The matrix has a dash for this word at this size.
    NotForSize,
    /// The ordering tables do not list this winding with this feedback.
    PairNotListed,
    /// The matrix lists this winding, but no ordering table does.
    NotInOrderingTables,
    /// At this size the word is available with this feedback only.
    OnlyWith {
        /// Feedback required.
        feedback: Feedback,
        /// Mark of the footnote stating that the actuator becomes longer; empty if it does not.
        longer: &'static str,
    },
}

/// Returns the availability of a code.
///
/// # Errors
/// Returns the rules that the code breaks.
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

/// Returns the fields on request and all rules that a code breaks, possibly several of one field.
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

/// A property of a code that the tables of the manual do not cover.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Uncovered {
    /// An option makes the actuator longer; the manual does not state by how much.
    LongerWith {
        /// Option that adds the length.
        option: Option2,
        /// Table of the matrix.
        table: &'static str,
        /// Mark of the footnote that states it.
        footnote: &'static str,
    },
    /// A special design; the tables apply to the standard version.
    SpecialDesign(Series),
    /// An encoder at the output; the tables do not state which values it and its inner hollow shaft change.
    OutputEncoder(Option1),
}

impl Uncovered {
    /// Returns the symbols of the data stated for the standard version only that differ, or may differ, for this code.
    #[must_use]
    pub const fn not_printed(self) -> &'static [&'static str] {
        match self {
            Self::LongerWith { .. } => &["L", "L_brake"],
            Self::SpecialDesign(_) => &["L", "L_brake", "m", "m_brake"],
            Self::OutputEncoder(_) => &[],
        }
    }

    /// Returns the symbols of the data to which a remark on this property belongs.
    #[must_use]
    pub const fn concerns(self) -> &'static [&'static str] {
        match self {
            Self::OutputEncoder(_) => &["L", "L_brake", "m", "m_brake", "d_H"],
            Self::LongerWith { .. } | Self::SpecialDesign(_) => self.not_printed(),
        }
    }
}

/// Returns the properties of a code that the tables of the manual do not cover.
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
