//! How far two texts are apart.
//!
//! Written here because a wrong code is compared with every valid one and must be answered within milliseconds: the
//! library's function keeps a hash table per pair. The tests compare the two.

/// The distances of many texts from one: how many letters to insert, delete, change or swap; case does not count.
///
/// Damerau-Levenshtein distance over characters, where swapped letters may have been edited between (so that it keeps
/// the triangle inequality). Cost: the product of both lengths in time and memory, less the common
/// beginning with the previous text: texts in alphabetical order are fast.
///
/// # Source
/// R. Lowrance, R. A. Wagner, "An extension of the string-to-string correction problem", J. ACM 22 (1975) 177-183
#[derive(Clone, Debug)]
pub struct Distances {
    from: Vec<char>,
    /// The letters of the text compared last: one row of the table each.
    letters: Vec<char>,
    /// The table, a row of `from.len() + 1` steps for each letter behind the row of the empty text.
    steps: Vec<usize>,
    /// For each row and each letter of `from`: the last row whose letter is the same, from 1 on; 0 for none.
    same_rows: Vec<usize>,
    /// For each row the least that the distance of a text can be which begins with its letters.
    least: Vec<usize>,
}

impl Distances {
    /// Prepares for comparing texts with one.
    #[must_use]
    pub fn from(text: &str) -> Self {
        let from: Vec<char> = capitals(text).collect();
        let steps = (0..=from.len()).collect();
        let same_rows = vec![0; from.len()];
        Self { from, letters: Vec::new(), steps, same_rows, least: vec![0] }
    }

    /// How far a text is away.
    #[must_use]
    pub fn to(&mut self, text: &str) -> usize {
        self.within(text, usize::MAX).unwrap_or(usize::MAX)
    }

    /// How far a text is away; `None` if further than `most`. A text that begins too far away is not read to its end.
    #[must_use]
    pub fn within(&mut self, text: &str, most: usize) -> Option<usize> {
        let common = capitals(text).zip(&self.letters).take_while(|(new, old)| new == *old).count();
        self.go_on(capitals(text), common, most)
    }

    /// How far a text is away of which the first `common` letters are those compared last.
    fn go_on(&mut self, text: impl Iterator<Item = char>, common: usize, most: usize) -> Option<usize> {
        self.letters.truncate(common);
        self.steps.truncate((common + 1) * (self.from.len() + 1));
        self.same_rows.truncate((common + 1) * self.from.len());
        self.least.truncate(common + 1);
        let mut rest = text.skip(common);
        while !self.is_beyond(most) {
            let Some(letter) = rest.next() else { return self.steps.last().copied().filter(|found| *found <= most) };
            self.add(letter);
        }
        None
    }

    /// Whether every text that begins with the letters compared last is further away than `most`.
    fn is_beyond(&self, most: usize) -> bool {
        self.least.last().is_none_or(|least| *least > most)
    }

    /// Works out the row of one more letter.
    fn add(&mut self, letter: char) {
        let width = self.from.len();
        self.letters.push(letter);
        let row = self.letters.len();
        let (begin, before) = (self.steps.len(), self.same_rows.len() - width);
        self.steps.resize(begin + width + 1, row);
        let (done, new) = self.steps.split_at_mut(begin);
        let above = done.get(begin - (width + 1)..).unwrap_or_default();
        let same_rows = self.same_rows.get(before..).unwrap_or_default();
        // A way through the table goes through this row, or leaps over it as letters are swapped: that costs a step at least.
        let mut row_least = self.least.last().map_or(row, |least| row.min(least + 1));
        let (mut left, mut same_column) = (row, 0);
        let columns = self.from.iter().zip(same_rows).zip(above.iter().zip(above.iter().skip(1)));
        for (column, (((from, same), (diagonal, up)), step)) in columns.zip(new.iter_mut().skip(1)).enumerate() {
            let is_same = *from == letter;
            let mut least = (diagonal + usize::from(!is_same)).min(up + 1).min(left + 1);
            // The last column in this row whose letters are the same, from 1 on; 0 for none.
            if *same > 0 && same_column > 0 {
                let swapped = done.get((same - 1) * (width + 1) + same_column - 1);
                let between = (row - same) + (column - same_column);
                least = swapped.map_or(least, |swapped| least.min(swapped + between));
            }
            if is_same {
                same_column = column + 1;
            }
            *step = least;
            left = least;
            row_least = row_least.min(least);
        }
        self.least.push(row_least);
        self.same_rows.extend_from_within(before..);
        let now = self.same_rows.get_mut(before + width..).unwrap_or_default();
        for (same, _) in now.iter_mut().zip(&self.from).filter(|(_, from)| **from == letter) {
            *same = row;
        }
    }
}

/// Texts in which those near another one are sought: neighbours that begin alike are compared, or given up, at once.
#[derive(Clone, Debug)]
pub struct Texts {
    texts: Vec<Letters>,
}

#[derive(Clone, Debug)]
struct Letters {
    capitals: Vec<char>,
    /// How many of them the text before begins with too.
    shared: usize,
}

impl Texts {
    /// Prepares texts for the search; quickest in alphabetical order.
    #[must_use]
    pub fn new<'t>(texts: impl IntoIterator<Item = &'t str>) -> Self {
        let mut found: Vec<Letters> = Vec::new();
        for text in texts {
            let capitals: Vec<char> = capitals(text).collect();
            let before = found.last().map(|letters| letters.capitals.as_slice()).unwrap_or_default();
            let shared = capitals.iter().zip(before).take_while(|(new, old)| new == old).count();
            found.push(Letters { capitals, shared });
        }
        Self { texts: found }
    }

    /// The texts not further away than `most`, of those that `asked` wants by their place: place and distance.
    ///
    /// Cost: a row of the table for each beginning that may lead to such a text.
    pub fn within(
        &self,
        distances: &mut Distances,
        most: usize,
        asked: impl Fn(usize) -> bool,
        mut found: impl FnMut(usize, usize),
    ) {
        // What the text at hand has in common with the one that was compared last.
        let mut shared = 0;
        for (place, text) in self.texts.iter().enumerate() {
            shared = shared.min(text.shared);
            if (shared >= distances.letters.len() && distances.is_beyond(most)) || !asked(place) {
                continue;
            }
            let common = shared.min(distances.letters.len());
            if let Some(distance) = distances.go_on(text.capitals.iter().copied(), common, most) {
                found(place, distance);
            }
            shared = usize::MAX;
        }
    }
}

fn capitals(text: &str) -> impl Iterator<Item = char> {
    text.chars().flat_map(char::to_uppercase)
}

#[cfg(test)]
mod tests {
    use super::{Distances, Texts};

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
            assert_eq!(Distances::from(a).to(b), distance, "{a} {b}");
            assert_eq!(Distances::from(b).to(a), distance, "{b} {a}");
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
        // The order of the texts lets each begin with another part of the one before.
        for a in texts.iter().filter(|a| a.len() < 5) {
            let mut distances = Distances::from(a);
            for b in &texts {
                let distance = strsim::damerau_levenshtein(a, b);
                assert_eq!(distances.to(b), distance, "{a} {b}");
                for most in 0..=5 {
                    assert_eq!(distances.within(b, most), (distance <= most).then_some(distance), "{a} {b} {most}");
                }
            }
        }
        let alphabetical = Texts::new(texts.iter().map(String::as_str));
        for a in texts.iter().step_by(7) {
            for most in [0, 2, 4] {
                for asked in [1, 3] {
                    let mut found = Vec::new();
                    let mut distances = Distances::from(a);
                    // A search before leaves nothing that a later one takes for its own.
                    let _ = distances.to("CAB");
                    alphabetical.within(
                        &mut distances,
                        most,
                        |place| place % asked == 0,
                        |place, far| {
                            found.push((place, far));
                        },
                    );
                    let each = texts.iter().map(|b| strsim::damerau_levenshtein(a, b)).enumerate().step_by(asked);
                    assert_eq!(found, each.filter(|(_, distance)| *distance <= most).collect::<Vec<_>>(), "{a} {most}");
                }
            }
        }
        let (a, b) = ("CHA-20A-100-H-C1024-B-EC", "CAH-25A-10-HM-C1042-EC-B");
        assert_eq!(Distances::from(a).to(b), strsim::damerau_levenshtein(a, b));
    }
}
