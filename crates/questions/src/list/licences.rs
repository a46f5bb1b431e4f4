//! `licences`: licences of the program and of the third-party work in it.

use super::given::arguments;
use super::{Answer, Entry, Gives, Reads, Record};
use answers::{LicenceText, Licences};
use words::help;

arguments! {
    /// Arguments of `licences`, which has none.
    pub struct Args {
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "licences",
    path: "licences",
    about: help::licences,
    reads: Reads::Nothing,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<answers::Licences>("licences")),
    writes: &[],
    example: "",
    answer: Some(|_| Ok(Answer::record(&licences()))),
};

/// Files of the repository that are shipped with the program; they are part of the binary.
const TEXTS: [(&str, &str); 3] = [
    ("LICENSE", include_str!("../../../../LICENSE")),
    ("THIRD-PARTY.md", include_str!("../../../../THIRD-PARTY.md")),
    ("third-party/two-face.md", include_str!("../../../../third-party/two-face.md")),
];

/// Returns the licence of the program and those of third-party work in it.
#[must_use]
pub fn licences() -> Licences {
    let text = |(name, text): (&str, &str)| LicenceText { name: name.to_owned(), text: text.to_owned() };
    Licences { texts: TEXTS.map(text).into() }
}
