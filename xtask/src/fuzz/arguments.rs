//! Arguments of `cargo xtask fuzz`.

use std::path::PathBuf;

use crate::Error;

/// Task of the command.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Work {
    /// Searches new cases, for a total time or until each target has its number of cases.
    Campaign { minutes: Option<u32> },
    /// Reports the coverage of the corpora.
    Coverage,
    /// Runs one case again.
    Case(PathBuf),
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Arguments {
    pub(super) work: Work,
    /// Name of the only target to run, if given.
    pub(super) target: Option<String>,
    /// Number of parallel processes.
    pub(super) jobs: u32,
}

impl Arguments {
    /// Parses the arguments; `targets` are the names of the existing targets.
    pub(super) fn read(words: &[String], targets: &[&str]) -> Result<Self, Error> {
        let mut found = Self { work: Work::Campaign { minutes: None }, target: None, jobs: 1 };
        let mut words = words.iter();
        while let Some(word) = words.next() {
            let mut value =
                |what: &str| words.next().ok_or_else(|| wrong(word, format!("{what} is missing behind it")));
            match word.as_str() {
                "--coverage" => found.work = Work::Coverage,
                "--minutes" => {
                    found.work = Work::Campaign { minutes: Some(count(word, value("a number of minutes")?)?) }
                }
                "--jobs" => found.jobs = count(word, value("a number of processes")?)?,
                "--case" => found.work = Work::Case(PathBuf::from(value("a file")?)),
                "--target" => {
                    let name = value("the name of a target")?;
                    if !targets.contains(&name.as_str()) {
                        return Err(wrong(name, format!("there is no such target; there are: {}", targets.join(" "))));
                    }
                    found.target = Some(name.clone());
                }
                _ => {
                    let known = "--minutes N, --target T, --jobs J, --case FILE, --coverage";
                    return Err(wrong(word, format!("not understood; there are: {known}")));
                }
            }
        }
        if matches!(found.work, Work::Case(_)) && found.target.is_none() {
            return Err(wrong("--case", String::from("a case belongs to a target: give --target too")));
        }
        Ok(found)
    }
}

fn count(word: &str, text: &str) -> Result<u32, Error> {
    let number = text.parse().ok().filter(|number| *number > 0);
    number.ok_or_else(|| wrong(word, format!("`{text}` is no whole number above zero")))
}

fn wrong(word: &str, why: String) -> Error {
    Error::Word { word: word.to_owned(), why }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(words: &str) -> Result<Arguments, String> {
        let words: Vec<String> = words.split_whitespace().map(str::to_owned).collect();
        Arguments::read(&words, &["code", "axis"]).map_err(|error| error.to_string())
    }

    #[test]
    fn the_words_are_read_in_any_order() {
        let campaign = Work::Campaign { minutes: Some(5) };
        let expected = Arguments { work: campaign, target: Some("axis".into()), jobs: 2 };
        assert_eq!(read("--jobs 2 --minutes 5 --target axis").unwrap(), expected);
        assert_eq!(read("").unwrap().work, Work::Campaign { minutes: None });
        assert_eq!(read("--case x --target code").unwrap().work, Work::Case("x".into()));
    }

    #[test]
    fn a_word_that_is_wrong_is_named() {
        for (words, part) in [
            ("--minutes", "`--minutes`: a number of minutes is missing"),
            ("--minutes 0", "`0` is no whole number"),
            ("--target size", "there are: code axis"),
            ("--case x", "give --target too"),
            ("--forever", "`--forever`: not understood"),
        ] {
            let error = read(words).unwrap_err();
            assert!(error.contains(part), "{words}: {error}");
        }
    }
}
