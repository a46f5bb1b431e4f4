//! `licences`: whose work the program is, and under which terms.

use super::given::arguments;
use super::{Answer, Entry, Gives, Reads, Record};
use answers::{LicenceText, Licences};
use words::help;

arguments! {
    /// Nothing.
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

/// The files of the repository that go with the program; they are part of the binary.
const TEXTS: [(&str, &str); 3] = [
    ("LICENSE", include_str!("../../../../LICENSE")),
    ("THIRD-PARTY.md", include_str!("../../../../THIRD-PARTY.md")),
    ("third-party/two-face.md", include_str!("../../../../third-party/two-face.md")),
];

/// The licence of the program and those of the work of others in it.
#[must_use]
pub fn licences() -> Licences {
    let text = |(name, text): (&str, &str)| LicenceText { name: name.to_owned(), text: text.to_owned() };
    Licences { texts: TEXTS.map(text).into() }
}
