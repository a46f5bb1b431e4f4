//! The combination matrix (table 12.1) and the pairs of winding and feedback (table 11.3), read from the cells.

use catalogue::Cell;
use order_code::{Brake, Feedback, Option1, Option2, Ratio, Size, Winding};
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
    /// For each size in turn, one for each of [`CONDITIONS`].
    entries: Vec<Entry>,
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

/// The conditions of table 12.1, each field's in the order of its values: whoever asks counts on it.
const CONDITIONS: [&str; 20] = [
    "ratio=30",
    "ratio=50",
    "ratio=80",
    "ratio=100",
    "ratio=120",
    "ratio=160",
    "winding=E",
    "winding=H",
    "winding=L",
    "winding=N",
    "feedback=C1024",
    "feedback=M512P",
    "feedback=RES",
    "feedback=D2048",
    "feedback=M128S",
    "brake=B",
    "option_1=EC",
    "option_2=K",
    "option_2=R",
    "option_2=S",
];
const RATIOS: usize = 0;
const WINDINGS: usize = 6;
const FEEDBACKS: usize = 10;
const BRAKE: usize = 15;
const OPTION_1: usize = 16;
const OPTIONS_2: usize = 17;

fn table(id: &str) -> &'static [Cell] {
    catalogue::table(id).map(catalogue::Table::cells).unwrap_or_default()
}

static MATRIX: LazyLock<Matrix> = LazyLock::new(|| {
    let mut entries = Vec::new();
    for &size in Size::ALL {
        let head = format!("CHA-{size}");
        for condition in CONDITIONS {
            // A cell merged over several sizes names all of them.
            let covers = |cell: &&Cell| {
                cell.place.condition == condition && cell.place.drive.split(" / ").any(|each| each == head)
            };
            entries.push(table("12.1").iter().find(covers).and_then(entry_of).unwrap_or(Entry::NotAvailable));
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
    fn entry(&self, size: Size, condition: usize) -> Entry {
        self.entries.get(size as usize * CONDITIONS.len() + condition).copied().unwrap_or(Entry::NotAvailable)
    }

    pub(crate) fn ratio(&self, size: Size, ratio: Ratio) -> Entry {
        self.entry(size, RATIOS + ratio as usize)
    }

    pub(crate) fn winding(&self, size: Size, winding: Winding) -> Entry {
        self.entry(size, WINDINGS + winding as usize)
    }

    pub(crate) fn feedback(&self, size: Size, feedback: Feedback) -> Entry {
        self.entry(size, FEEDBACKS + feedback as usize)
    }

    pub(crate) fn brake(&self, size: Size, brake: Brake) -> Entry {
        match brake {
            Brake::Without => Entry::Available,
            Brake::With => self.entry(size, BRAKE),
        }
    }

    pub(crate) fn option_1(&self, size: Size, option: Option<Option1>) -> Entry {
        option.map_or(Entry::Available, |option| self.entry(size, OPTION_1 + option as usize))
    }

    pub(crate) fn option_2(&self, size: Size, option: Option<Option2>) -> Entry {
        option.map_or(Entry::Available, |option| self.entry(size, OPTIONS_2 + option as usize))
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
            assert!(CONDITIONS.contains(&cell.place.condition), "{cell:?}");
        }
        for (size, condition) in Size::ALL.iter().flat_map(|size| CONDITIONS.map(|condition| (size, condition))) {
            let head = format!("CHA-{size}");
            let stands = |cell: &Cell| cell.place.condition == condition && cell.place.drive.contains(&head);
            assert!(table("12.1").iter().any(stands), "{size} {condition}");
        }
    }

    #[test]
    fn each_value_has_its_condition() {
        let holds = |first: usize, place: usize, text: String| assert_eq!(CONDITIONS[first + place], text);
        Ratio::ALL.iter().for_each(|each| holds(RATIOS, *each as usize, format!("ratio={each}")));
        Winding::ALL.iter().for_each(|each| holds(WINDINGS, *each as usize, format!("winding={each}")));
        Feedback::ALL.iter().for_each(|each| holds(FEEDBACKS, *each as usize, format!("feedback={each}")));
        Option1::ALL.iter().for_each(|each| holds(OPTION_1, *each as usize, format!("option_1={each}")));
        Option2::ALL.iter().for_each(|each| holds(OPTIONS_2, *each as usize, format!("option_2={each}")));
        assert_eq!((CONDITIONS[BRAKE], CONDITIONS.len()), ("brake=B", OPTIONS_2 + Option2::ALL.len()));
        let places = Size::ALL.iter().map(|size| *size as usize);
        assert!(places.eq(0..Size::ALL.len()), "the sizes are declared in their order");
    }
}
