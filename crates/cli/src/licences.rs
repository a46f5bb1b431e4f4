//! `licences`: whose work the program is, and under which terms.

use crate::answer::Answer;
use workbench::answers::{LicenceText, Licences};

/// The files of the repository that go with the program; whoever has the program alone has them as well.
const TEXTS: [(&str, &str); 3] = [
    ("LICENSE", include_str!("../../../LICENSE")),
    ("THIRD-PARTY.md", include_str!("../../../THIRD-PARTY.md")),
    ("third-party/two-face.md", include_str!("../../../third-party/two-face.md")),
];

/// `antrieb licences`
pub(crate) fn licences(as_json: bool) -> Answer {
    if as_json {
        let texts = TEXTS.map(|(name, text)| LicenceText { name: name.to_owned(), text: text.to_owned() });
        return Answer::record(&Licences { texts: texts.into() });
    }
    Answer::data(TEXTS.map(|(_, text)| text.trim_end().to_owned() + "\n").join("\n"))
}
