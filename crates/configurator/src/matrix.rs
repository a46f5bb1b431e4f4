//! The combination matrix (table 12.1) and the pairs of winding and feedback (table 11.3), read from the cells.

use catalogue::Cell;
use order_code::{Brake, Feedback, Option1, Option2, Ratio, Size, Winding};
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// One entry of table 12.1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Entry {
    /// `●`
    Available,
    /// `○`
    OnRequest,
    /// `○` with footnote 1: resolver only, with a longer housing.
    OnRequestForResolver,
    /// Only together with M512P.
    OnlyWithM512P,
    /// `-`
    NotAvailable,
}

/// Table 12.1 and 11.3 in a form that answers at once.
pub(crate) struct Matrix {
    entries: BTreeMap<(Size, &'static str), Entry>,
    pairs: Vec<(Winding, Feedback)>,
    windings_ordered: Vec<Winding>,
}

fn entry_of(cell: &Cell) -> Option<Entry> {
    let text = cell.corrected;
    if text.starts_with('●') {
        Some(Entry::Available)
    } else if text.starts_with('○') && text.contains('1') {
        Some(Entry::OnRequestForResolver)
    } else if text.starts_with('○') {
        Some(Entry::OnRequest)
    } else if text.contains("M512P") {
        Some(Entry::OnlyWithM512P)
    } else if text == "-" {
        Some(Entry::NotAvailable)
    } else {
        None
    }
}

/// Every condition of table 12.1 that an ordering code can ask about.
fn conditions() -> Vec<&'static str> {
    let mut found: Vec<&'static str> = Vec::new();
    for cell in table("12.1") {
        if !found.contains(&cell.place.condition) {
            found.push(cell.place.condition);
        }
    }
    found
}

fn table(id: &str) -> &'static [Cell] {
    catalogue::table(id).map(catalogue::Table::cells).unwrap_or_default()
}

static MATRIX: LazyLock<Matrix> = LazyLock::new(|| {
    let mut entries = BTreeMap::new();
    let conditions = conditions();
    for &size in Size::ALL {
        let head = format!("CHA-{size}");
        for &condition in &conditions {
            // A cell merged over several sizes names all of them.
            let covers = |cell: &&Cell| {
                cell.place.condition == condition && cell.place.drive.split(" / ").any(|each| each == head)
            };
            if let Some(entry) = table("12.1").iter().find(covers).and_then(entry_of) {
                entries.insert((size, condition), entry);
            }
        }
    }
    let mut pairs = Vec::new();
    for &winding in Winding::ALL {
        for &feedback in Feedback::ALL {
            let named = |cell: &&Cell| {
                cell.place.condition == format!("winding={winding}") && cell.feedback == feedback.as_str()
            };
            if table("11.3").iter().any(|cell| named(&cell)) {
                pairs.push((winding, feedback));
            }
        }
    }
    let windings_ordered =
        Winding::ALL.iter().copied().filter(|w| pairs.iter().any(|(winding, _)| winding == w)).collect();
    Matrix { entries, pairs, windings_ordered }
});

/// The matrix, read once.
pub(crate) fn matrix() -> &'static Matrix {
    &MATRIX
}

impl Matrix {
    fn entry(&self, size: Size, condition: &'static str) -> Entry {
        self.entries.get(&(size, condition)).copied().unwrap_or(Entry::NotAvailable)
    }

    pub(crate) fn ratio(&self, size: Size, ratio: Ratio) -> Entry {
        let condition = match ratio {
            Ratio::R30 => "ratio=30",
            Ratio::R50 => "ratio=50",
            Ratio::R80 => "ratio=80",
            Ratio::R100 => "ratio=100",
            Ratio::R120 => "ratio=120",
            Ratio::R160 => "ratio=160",
        };
        self.entry(size, condition)
    }

    pub(crate) fn winding(&self, size: Size, winding: Winding) -> Entry {
        let condition = match winding {
            Winding::E => "winding=E",
            Winding::H => "winding=H",
            Winding::L => "winding=L",
            Winding::N => "winding=N",
        };
        self.entry(size, condition)
    }

    pub(crate) fn feedback(&self, size: Size, feedback: Feedback) -> Entry {
        let condition = match feedback {
            Feedback::C1024 => "feedback=C1024",
            Feedback::M512P => "feedback=M512P",
            Feedback::RES => "feedback=RES",
            Feedback::D2048 => "feedback=D2048",
            Feedback::M128S => "feedback=M128S",
        };
        self.entry(size, condition)
    }

    pub(crate) fn brake(&self, size: Size, brake: Brake) -> Entry {
        match brake {
            Brake::Without => Entry::Available,
            Brake::With => self.entry(size, "brake=B"),
        }
    }

    pub(crate) fn option_1(&self, size: Size, option: Option<Option1>) -> Entry {
        match option {
            None => Entry::Available,
            Some(Option1::EC) => self.entry(size, "option_1=EC"),
        }
    }

    pub(crate) fn option_2(&self, size: Size, option: Option<Option2>) -> Entry {
        match option {
            None => Entry::Available,
            Some(Option2::K) => self.entry(size, "option_2=K"),
            Some(Option2::R) => self.entry(size, "option_2=R"),
            Some(Option2::S) => self.entry(size, "option_2=S"),
        }
    }

    /// Whether table 11.3 lists this pair of winding and feedback.
    pub(crate) fn pair(&self, winding: Winding, feedback: Feedback) -> bool {
        self.pairs.contains(&(winding, feedback))
    }

    /// Whether the ordering tables know this winding at all (L stands in table 12.1 only).
    pub(crate) fn ordered(&self, winding: Winding) -> bool {
        self.windings_ordered.contains(&winding)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_matrix_is_read_from_the_tables() {
        let m = matrix();
        assert_eq!(m.ratio(Size::S14A, Ratio::R120), Entry::NotAvailable);
        assert_eq!(m.ratio(Size::S17A, Ratio::R120), Entry::Available);
        assert_eq!(m.ratio(Size::S40A, Ratio::R30), Entry::NotAvailable);
        assert_eq!(m.feedback(Size::S32A, Feedback::RES), Entry::OnRequest);
        assert_eq!(m.option_2(Size::S14A, Some(Option2::K)), Entry::OnRequestForResolver);
        assert_eq!(m.option_2(Size::S14A, Some(Option2::R)), Entry::NotAvailable);
        assert_eq!(m.option_2(Size::S58A, Some(Option2::S)), Entry::OnlyWithM512P);
        assert_eq!(m.winding(Size::S20A, Winding::N), Entry::NotAvailable);
        assert_eq!(m.pairs.len(), 10, "table 11.3 has ten rows");
        assert!(!m.ordered(Winding::L));
    }

    #[test]
    fn every_entry_of_the_matrix_is_understood() {
        for cell in table("12.1") {
            assert!(entry_of(cell).is_some(), "{cell:?}");
        }
        assert_eq!(matrix().entries.len(), Size::ALL.len() * conditions().len());
    }
}
