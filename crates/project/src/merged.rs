//! Two changed versions of a project file as one.

use crate::edit::{Edit, edit, written};
use std::collections::{BTreeMap, BTreeSet};

/// A key that two versions of a file changed to different values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Clash {
    /// Path of the key, or of the list whose entries changed.
    pub path: String,
    /// Value of one version as typed into a field; `None` if it does not state the key.
    pub ours: Option<String>,
    /// Value of the other version.
    pub theirs: Option<String>,
}

/// Reason why two versions of a file are not merged.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unmerged {
    /// Keys that both changed.
    Clashes(Vec<Clash>),
    /// A version is no TOML, or differs in comments or in the order of a list in a way that would be lost.
    Text,
}

/// Version whose value is kept for keys that both changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Prefer {
    /// Value of the first version.
    Ours,
    /// Value of the second version.
    Theirs,
}

/// Values by path, and the paths of tables and entries of lists.
struct Keys {
    values: BTreeMap<String, String>,
    entries: BTreeSet<String>,
}

/// Changed values by path; `None` for a removed key.
type Changes = BTreeMap<String, Option<String>>;

impl Keys {
    fn of(text: &str) -> Option<Self> {
        let (mut values, mut entries) = (BTreeMap::new(), BTreeSet::new());
        for key in written(text)? {
            match key.value {
                Some(value) => drop(values.insert(key.path, value)),
                None if key.path.ends_with(']') => drop(entries.insert(key.path)),
                None => {}
            }
        }
        Some(Self { values, entries })
    }

    fn since(&self, base: &Self) -> Changes {
        let new = self.values.iter().filter(|(path, value)| base.values.get(*path) != Some(value));
        let gone = base.values.keys().filter(|path| !self.values.contains_key(*path));
        new.map(|(path, value)| (path.clone(), Some(value.clone())))
            .chain(gone.map(|path| (path.clone(), None)))
            .collect()
    }

    /// Returns the lists whose number of entries differs.
    fn changed_lists(&self, base: &Self) -> BTreeSet<String> {
        let list = |entry: &String| entry.rsplit_once('[').map(|(list, _)| list.to_owned());
        self.entries.symmetric_difference(&base.entries).filter_map(list).collect()
    }
}

/// Merges two versions of a file that were made from the same one: the changes of both keys by key, with order, comments
/// and spelling of one of them. `prefer` decides for keys that both changed; without it they are reported.
///
/// # Errors
/// [`Unmerged`].
pub fn merged(base: &str, ours: &str, theirs: &str, prefer: Option<Prefer>) -> Result<String, Unmerged> {
    if ours == theirs || base == ours {
        return Ok(theirs.to_owned());
    }
    if base == theirs {
        return Ok(ours.to_owned());
    }
    let read = |text| Keys::of(text).ok_or(Unmerged::Text);
    let (old, own, other) = (read(base)?, read(ours)?, read(theirs)?);
    let (mine, its) = (own.since(&old), other.since(&old));
    let lists = [own.changed_lists(&old), other.changed_lists(&old)];
    let [in_ours, in_theirs] = &lists;
    // The entries of a changed list have other numbers.
    let of_list = |path: &str, lists: &BTreeSet<String>| {
        lists.iter().any(|list| path.strip_prefix(list.as_str()).is_some_and(|rest| rest.starts_with('[')))
    };
    let touches = |changes: &Changes, lists: &BTreeSet<String>| changes.keys().any(|path| of_list(path, lists));
    let crossed: BTreeSet<&String> = in_ours
        .iter()
        .filter(|list| in_theirs.contains(*list) || touches(&its, &BTreeSet::from([(*list).clone()])))
        .chain(in_theirs.iter().filter(|list| touches(&mine, &BTreeSet::from([(*list).clone()]))))
        .collect();
    let differ = |path: &&String| {
        its.get(*path).is_some_and(|theirs| mine.get(*path) != Some(theirs))
            && !crossed.iter().any(|list| path.starts_with(list.as_str()))
    };
    let mut clashes: Vec<Clash> = mine
        .keys()
        .filter(differ)
        .map(|path| Clash {
            path: path.clone(),
            ours: own.values.get(path).cloned(),
            theirs: other.values.get(path).cloned(),
        })
        .collect();
    clashes.extend(crossed.iter().map(|list| Clash { path: (*list).clone(), ours: None, theirs: None }));
    if !clashes.is_empty() && (prefer.is_none() || !crossed.is_empty()) {
        return Err(Unmerged::Clashes(clashes));
    }
    let without = |changes: &Changes| {
        let kept = changes.iter().filter(|(path, _)| !clashes.iter().any(|clash| clash.path == **path));
        kept.map(|(path, value)| (path.clone(), value.clone())).collect::<Changes>()
    };
    // What is preferred is not replaced, or is put in the place of the other.
    let (replayed_mine, replayed_its) = match prefer {
        Some(Prefer::Theirs) => (without(&mine), its.clone()),
        _ => (mine.clone(), without(&its)),
    };
    let expected = |onto: &Keys, changes: &Changes| {
        let mut values = onto.values.clone();
        for (path, value) in changes {
            match value {
                Some(value) => drop(values.insert(path.clone(), value.clone())),
                None => drop(values.remove(path)),
            }
        }
        values
    };
    let by =
        |(onto, keys): (&str, &Keys), changes: &Changes, (text, lists, all): (&str, &BTreeSet<String>, &Changes)| {
            // Only what consists of changed values can be put onto another text without a loss.
            if !lists.is_empty() || lines(&replay(base, all)?) != lines(text) {
                return None;
            }
            let result = replay(onto, changes)?;
            (Keys::of(&result)?.values == expected(keys, changes)).then_some(result)
        };
    by((theirs, &other), &replayed_mine, (ours, in_ours, &mine))
        .or_else(|| by((ours, &own), &replayed_its, (theirs, in_theirs, &its)))
        .ok_or(Unmerged::Text)
}

/// Returns a text with changed values.
fn replay(text: &str, changes: &Changes) -> Option<String> {
    changes.iter().try_fold(text.to_owned(), |text, (path, value)| match value {
        Some(value) => edit(&text, path, Edit::Value(value)).ok(),
        None => edit(&text, path, Edit::Gone).ok(),
    })
}

/// Returns the lines of a text, sorted, without the layout around them.
fn lines(text: &str) -> Vec<&str> {
    let mut lines: Vec<&str> = text.lines().map(str::trim).filter(|line| !line.is_empty()).collect();
    lines.sort_unstable();
    lines
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails loudly")]

    use super::*;

    const BASE: &str = "format = 1\n\n[axis]\nname = \"lift\"                # the first one\n\n[mechanism.screw]\nlead = \"10 mm\"\n\
        mass = \"60 kg\"\n\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n\n[[motion]]\nlaw = \"polynomial_5\"\n\
        distance = \"300 mm\"\ntime = \"2 s\"\n";

    fn with(text: &str, path: &str, change: Edit<'_>) -> String {
        edit(text, path, change).unwrap()
    }

    #[test]
    fn changes_of_different_keys_are_joined_with_order_and_comments() {
        let ours =
            with(&with(BASE, "mechanism.screw.mass", Edit::Value("77 kg")), "requirements.brake", Edit::Value("true"));
        let theirs = with(&with(BASE, "motion[2].time", Edit::Value("3 s")), "mechanism.screw.lead", Edit::Gone);
        let joined = merged(BASE, &ours, &theirs, None).unwrap();
        for (text, is_there) in
            [("77 kg", true), ("3 s", true), ("brake = true", true), ("lead", false), ("# the first one", true)]
        {
            assert_eq!(joined.contains(text), is_there, "{text}\n{joined}");
        }
        assert_eq!(lines(&merged(BASE, &theirs, &ours, None).unwrap()), lines(&joined));
    }

    #[test]
    fn a_key_that_both_changed_is_asked_for_and_the_others_are_joined() {
        let ours = with(&with(BASE, "mechanism.screw.mass", Edit::Value("77 kg")), "axis.name", Edit::Value("z"));
        let theirs =
            with(&with(BASE, "mechanism.screw.mass", Edit::Value("88 kg")), "motion[1].time", Edit::Value("5 s"));
        let clash =
            Clash { path: "mechanism.screw.mass".into(), ours: Some("77 kg".into()), theirs: Some("88 kg".into()) };
        assert_eq!(merged(BASE, &ours, &theirs, None), Err(Unmerged::Clashes(vec![clash])));
        for (prefer, mass) in [(Prefer::Ours, "77 kg"), (Prefer::Theirs, "88 kg")] {
            let joined = merged(BASE, &ours, &theirs, Some(prefer)).unwrap();
            assert!([mass, "name = \"z\"", "5 s"].iter().all(|text| joined.contains(text)), "{joined}");
        }
    }

    #[test]
    fn a_longer_list_is_joined_with_other_keys_and_clashes_with_changes_of_its_entries() {
        let longer = with(BASE, "motion[1]", Edit::Twice);
        let heavier = with(BASE, "mechanism.screw.mass", Edit::Value("77 kg"));
        for (ours, theirs) in [(&longer, &heavier), (&heavier, &longer)] {
            let joined = merged(BASE, ours, theirs, None).unwrap();
            assert!(joined.contains("77 kg") && joined.matches("[[motion]]").count() == 3, "{joined}");
        }
        let slower = with(BASE, "motion[2].time", Edit::Value("3 s"));
        for (ours, theirs) in [(&longer, &slower), (&slower, &longer), (&longer, &with(BASE, "motion[2]", Edit::Gone))]
        {
            let found = merged(BASE, ours, theirs, None);
            let of_the_list =
                matches!(&found, Err(Unmerged::Clashes(all)) if all.len() == 1 && all[0].path == "motion");
            assert!(of_the_list, "{found:?}");
        }
    }

    #[test]
    fn a_comment_is_not_lost() {
        let ours = BASE.replace("# the first one", "# the second one");
        let theirs = with(BASE, "mechanism.screw.mass", Edit::Value("77 kg"));
        let joined = merged(BASE, &ours, &theirs, None).unwrap();
        assert!(joined.contains("# the second one") && joined.contains("77 kg"), "{joined}");
        let theirs = theirs.replace("format = 1", "format = 1 # theirs");
        assert_eq!(merged(BASE, &ours, &theirs, None), Err(Unmerged::Text));
        assert_eq!(merged(BASE, "[load", &theirs, None), Err(Unmerged::Text));
    }

    /// Random values of random keys in two versions: every change of both is in the result, or reported.
    #[test]
    fn no_change_is_lost() {
        let mut random = numeric::Random::new(11);
        let values = Keys::of(BASE).unwrap().values;
        let paths: Vec<&String> = values.keys().filter(|path| *path != "format").collect();
        let mut joined_count = 0;
        for _ in 0..400 {
            let mut version = || {
                let mut text = BASE.to_owned();
                for _ in 0..3 {
                    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "an index")]
                    let path = paths[((random.uniform() * paths.len() as f64) as usize).min(paths.len() - 1)];
                    let value = format!("{} s", (random.uniform() * 3.0).floor());
                    let change = if random.uniform() < 0.2 { Edit::Gone } else { Edit::Value(&value) };
                    text = with(&text, path, change);
                }
                text
            };
            let (ours, theirs) = (version(), version());
            let all = [&ours, &theirs].map(|text| Keys::of(text).unwrap());
            let old = Keys::of(BASE).unwrap();
            let changes = all.each_ref().map(|keys| keys.since(&old));
            match merged(BASE, &ours, &theirs, None) {
                Ok(joined) => {
                    joined_count += 1;
                    let values = Keys::of(&joined).unwrap().values;
                    for (path, value) in changes.iter().flatten() {
                        assert_eq!(values.get(path), value.as_ref(), "{path}\n{ours}\n{theirs}\n{joined}");
                    }
                    assert!(
                        values.iter().all(|(path, value)| all.iter().any(|keys| keys.values.get(path) == Some(value))),
                        "{joined}"
                    );
                }
                Err(Unmerged::Clashes(clashes)) => {
                    for clash in clashes {
                        assert!(changes[0].get(&clash.path) != changes[1].get(&clash.path), "{clash:?}");
                        assert!(changes.iter().all(|changes| changes.contains_key(&clash.path)), "{clash:?}");
                    }
                }
                Err(Unmerged::Text) => panic!("{ours}\n{theirs}"),
            }
        }
        assert!(joined_count > 50, "{joined_count}");
    }
}
