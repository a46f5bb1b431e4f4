//! Lists whose length depends on the project: a report prints the beginning and the end of a long one.

use serde::Serialize;

/// Number of entries printed at the beginning and at the end of a long list.
const LISTED: [usize; 2] = [150, 50];

/// A list, or the beginning and the end of a long one.
#[derive(Serialize)]
pub(super) struct Ends<T> {
    pub(super) rows: Vec<T>,
    /// Number of entries left out between beginning and end.
    left_out: usize,
}

impl<T> Default for Ends<T> {
    fn default() -> Self {
        Self { rows: Vec::new(), left_out: 0 }
    }
}

impl<T> Ends<T> {
    /// Creates the printed part of a list; the entry `kept` is printed at any position.
    pub(super) fn of(list: impl ExactSizeIterator<Item = T>, kept: Option<usize>) -> Self {
        let count = list.len();
        let is_listed = |place: &usize| is_listed(*place, count) || kept == Some(*place);
        let rows: Vec<T> = list.enumerate().filter(|(place, _)| is_listed(place)).map(|(_, row)| row).collect();
        Self { left_out: count - rows.len(), rows }
    }
}

/// Returns `true` if the entry at `place` of a list of `count` entries is printed.
pub(super) const fn is_listed(place: usize, count: usize) -> bool {
    let [first, last] = LISTED;
    count <= first + last || place < first || place + last >= count
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_list_has_its_ends_and_what_is_kept() {
        for count in [0, 1, 199, 200] {
            let whole = Ends::of(0..count, None);
            assert_eq!((whole.rows.len(), whole.left_out), (count, 0));
        }
        let long = Ends::of(0..8000, None);
        assert_eq!((long.rows.len(), long.left_out), (200, 7800));
        assert_eq!((long.rows[149], long.rows[150], long.rows[199]), (149, 7950, 7999));
        let kept = Ends::of(0..8000, Some(4000));
        assert_eq!((kept.rows[150], kept.left_out), (4000, 7799));
        assert_eq!(Ends::of(0..8000, Some(3)).left_out, 7800);
    }
}
