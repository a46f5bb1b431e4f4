//! How far two texts are apart.
//!
//! Written here because a wrong code is compared with every valid one and must be answered within milliseconds: the
//! library's function keeps a hash table per pair. The tests compare the two.

/// Number of letters to insert, delete, change or swap to turn one text into the other; case does not count.
///
/// Damerau-Levenshtein distance over characters, where swapped letters may have been edited between (so that it keeps
/// the triangle inequality). Cost: the product of both lengths in time and memory, about a microsecond for two codes.
///
/// # Source
/// R. Lowrance, R. A. Wagner, "An extension of the string-to-string correction problem", J. ACM 22 (1975) 177-183
#[must_use]
pub fn edit_distance(a: &str, b: &str) -> usize {
    let (a, b) = (capitals(a), capitals(b));
    let mut rows: Vec<Vec<usize>> = Vec::with_capacity(a.len() + 1);
    rows.push((0..=b.len()).collect());
    // For each letter of b: the last row whose letter of a is the same, from 1 on; 0 for none.
    let mut same_row = vec![0; b.len()];
    for (i, from) in a.iter().enumerate() {
        let above = rows.last().map(Vec::as_slice).unwrap_or_default();
        let mut row = Vec::with_capacity(b.len() + 1);
        let mut left = i + 1;
        row.push(left);
        // The last column in this row whose letters are the same, from 1 on; 0 for none.
        let mut same_column = 0;
        for (j, ((to, steps), same)) in b.iter().zip(above.windows(2)).zip(&same_row).enumerate() {
            let &[diagonal, up] = steps else { continue };
            let mut least = (diagonal + usize::from(from != to)).min(up + 1).min(left + 1);
            if *same > 0 && same_column > 0 {
                let before = rows.get(same - 1).and_then(|row| row.get(same_column - 1));
                let between = (i - same) + 1 + (j - same_column);
                least = before.map_or(least, |before| least.min(before + between));
            }
            if from == to {
                same_column = j + 1;
            }
            row.push(least);
            left = least;
        }
        for (same, to) in same_row.iter_mut().zip(&b) {
            if from == to {
                *same = i + 1;
            }
        }
        rows.push(row);
    }
    rows.last().and_then(|row| row.last()).copied().unwrap_or(0)
}

fn capitals(text: &str) -> Vec<char> {
    text.chars().flat_map(char::to_uppercase).collect()
}

#[cfg(test)]
mod tests {
    use super::edit_distance;

    #[test]
    fn the_distance_counts_single_edits_whatever_the_case() {
        for (a, b, distance) in [
            ("", "", 0),
            ("", "CHA", 3),
            ("cha-20a", "CHA-20A", 0),
            ("CHA-20A", "CAH-20A", 1),
            ("C1024", "C1042", 1),
            ("20A", "25A", 1),
            ("100", "10", 1),
            ("CA", "ABC", 2),
            ("é", "e", 1),
        ] {
            assert_eq!(edit_distance(a, b), distance, "{a} {b}");
            assert_eq!(edit_distance(b, a), distance, "{b} {a}");
        }
    }

    /// Cross-check with strsim 0.11: every pair of texts of up to five letters out of three, the first with fewer.
    #[test]
    fn the_distance_agrees_with_another_implementation() {
        let mut texts = vec![String::new()];
        let mut from = 0;
        for _ in 0..5 {
            let longer: Vec<String> = texts
                .iter()
                .skip(from)
                .flat_map(|text| ["A", "B", "C"].map(|letter| format!("{text}{letter}")))
                .collect();
            from = texts.len();
            texts.extend(longer);
        }
        assert_eq!(texts.len(), 364);
        for a in texts.iter().filter(|a| a.len() < 5) {
            for b in &texts {
                assert_eq!(edit_distance(a, b), strsim::damerau_levenshtein(a, b), "{a} {b}");
            }
        }
        let (a, b) = ("CHA-20A-100-H-C1024-B-EC", "CAH-25A-10-HM-C1042-EC-B");
        assert_eq!(edit_distance(a, b), strsim::damerau_levenshtein(a, b));
    }
}
