//! Keys and faults of a text, found by their paths: a file may have as many as it has bytes, and a form searches for
//! each of its fields.

use project::Written;
use std::ops::Deref;
use words::Worded;

/// An item with a place in the file.
pub(crate) trait Placed {
    /// Returns the path, if the item has one.
    fn path(&self) -> Option<&str>;
}

impl Placed for Written {
    fn path(&self) -> Option<&str> {
        Some(&self.path)
    }
}

impl Placed for (Option<String>, Worded) {
    fn path(&self) -> Option<&str> {
        self.0.as_deref()
    }
}

/// Items in the order of their file, with an index of their paths.
pub(crate) struct ByPath<T> {
    items: Vec<T>,
    /// Places of those with a path, by path; equal paths in their order.
    sorted: Vec<usize>,
}

impl<T: Placed> From<Vec<T>> for ByPath<T> {
    fn from(items: Vec<T>) -> Self {
        let path = |place: &usize| items.get(*place).and_then(Placed::path);
        let mut sorted: Vec<usize> = (0..items.len()).filter(|place| path(place).is_some()).collect();
        sorted.sort_by(|a, b| path(a).cmp(&path(b)));
        Self { items, sorted }
    }
}

impl<T> Deref for ByPath<T> {
    type Target = [T];

    fn deref(&self) -> &[T] {
        &self.items
    }
}

impl<T: Placed> ByPath<T> {
    /// Returns the items whose path begins with a text, by path.
    fn beginning<'s, 't>(&'s self, text: &'t str) -> impl Iterator<Item = &'s T> + use<'s, 't, T> {
        let path = |place: &usize| self.items.get(*place).and_then(Placed::path).unwrap_or_default();
        let first = self.sorted.partition_point(|place| path(place) < text);
        let items = self.sorted.iter().skip(first).filter_map(|place| self.items.get(*place));
        items.take_while(move |item| item.path().is_some_and(|path| path.starts_with(text)))
    }

    /// Returns the items at a path, in the order of the file.
    pub(crate) fn at<'s>(&'s self, path: &str) -> impl Iterator<Item = &'s T> {
        self.beginning(path).take_while(move |item| item.path() == Some(path))
    }

    /// Returns the items at a path and those in the list of this path, in the order of the paths.
    pub(crate) fn at_or_listed<'s>(&'s self, path: &str) -> impl Iterator<Item = &'s T> {
        self.at(path).chain(self.listed(path))
    }

    /// Returns the items in the list of a path, in the order of the paths.
    pub(crate) fn listed<'s>(&'s self, path: &str) -> impl Iterator<Item = &'s T> {
        self.beginning(&format!("{path}[")).collect::<Vec<_>>().into_iter()
    }

    /// Returns `true` if there is an item at a path or below it.
    pub(crate) fn is_there(&self, path: &str) -> bool {
        let is_any = |text: &str| self.beginning(text).next().is_some();
        self.at(path).next().is_some() || is_any(&format!("{path}.")) || is_any(&format!("{path}["))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "format = 1\nload.inertia = \"1 kg m^2\"\n[[motion]]\nlaw = \"dwell\"\n[[motion]]\ntime = \"1 s\"\n\
        [stage]\nratio = [2, 3]\n[stage-like]\n";

    /// Returns the index and the items for comparison by scanning.
    fn keys() -> (ByPath<Written>, Vec<Written>) {
        let keys = || (1..=12).map(|n| project::written(&TEXT.replace("stage-like", &format!("motion{n}"))).unwrap());
        let all: Vec<Written> = keys().flatten().collect();
        (ByPath::from(all.clone()), all)
    }

    #[test]
    fn an_item_is_found_as_by_scanning_all() {
        let (index, all) = keys();
        let below = |path: &str, known: &str, signs: &[char]| {
            known.strip_prefix(path).is_some_and(|rest| rest.is_empty() || rest.starts_with(signs))
        };
        let mut paths: Vec<String> = all.iter().map(|key| key.path.clone()).collect();
        paths.extend(
            ["", "m", "motion", "motion[", "motion[1", "motion[11]", "load", "lo", "stage.", "z"].map(String::from),
        );
        for path in &paths {
            let at: Vec<&Written> = index.at(path).collect();
            assert_eq!(at, all.iter().filter(|key| key.path == *path).collect::<Vec<_>>(), "{path}");
            assert_eq!(index.is_there(path), all.iter().any(|key| below(path, &key.path, &['.', '['])), "{path}");
            let listed = all.iter().filter(|key| below(path, &key.path, &['['])).count();
            assert_eq!(index.at_or_listed(path).count(), listed, "{path}");
        }
        assert_eq!(index.len(), all.len());
    }
}
