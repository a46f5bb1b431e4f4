//! Letters and words of a report as its readers see them.

use quantities::Language;
use report::{Content, Settings};
use testkit::readers::{english, identifiers, text_of};

/// Smallest letter \[pt\].
const LEAST: f64 = 7.0;

/// Asserts that letters of text and diagrams can be read, that no internal identifier stands in them and, in German, no English.
pub fn is_readable(name: &str, content: &Content, settings: &Settings) {
    let warnings = report::warnings(content, settings).unwrap();
    assert!(warnings.is_empty(), "{name}: {warnings:?}");
    let letters = report::letters(content, settings).unwrap();
    are_readable(name, content, &letters);
}

/// Asserts the same of the letters of a report.
pub fn are_readable(name: &str, content: &Content, letters: &[report::Letter]) {
    let language = content.language;
    let of_a_diagram = |text: &str| text.contains("fill=");
    assert!(letters.len() > 500 && letters.iter().any(|letter| of_a_diagram(&letter.text)), "{name}");
    let mut faults = Vec::new();
    for letter in letters {
        if letter.size_pt < LEAST - 0.01 {
            faults.push(format!("page {}: {:.2} pt: {}", letter.page, letter.size_pt, letter.text));
        }
    }
    if language == Language::De {
        // Of a diagram the parts of its source are no text.
        let is_text = |text: &str| !text.contains(['<', '>', '=']);
        let quoted = letters.iter().filter(|letter| letter.text.contains('"') && is_text(&letter.text));
        faults.extend(quoted.map(|letter| format!("page {}: {}", letter.page, letter.text)));
    }
    let text = letters.iter().map(|letter| letter.text.as_str()).filter(|text| !of_a_diagram(text));
    let mut texts = vec![text.collect::<Vec<_>>().join(" ")];
    for figure in content.axes.iter().flat_map(|axis| &axis.figures) {
        texts.push(text_of(figure.svgs.first().map_or("", String::as_str)));
    }
    for text in &texts {
        faults.extend(identifiers(text));
        // What a user types is of no use on paper.
        faults.extend(text.match_indices(" (--").map(|(at, _)| text[at..].chars().take(30).collect::<String>()));
        if language == Language::De {
            // A document keeps its title, which a line may break; the words of titles are left out.
            let documents = content.axes.iter().flat_map(|axis| &axis.dossier.documents);
            let titles: String = documents.map(|found| format!(" {} ", found.title)).collect();
            let of_a_title = |found: &String| found.split_once(':').is_some_and(|(word, _)| titles.contains(word));
            // What the user wrote stays as written: names of axes and of columns.
            let recordings = content.axes.iter().flat_map(|axis| &axis.dossier.judgement.motion.segments);
            let columns = recordings.filter_map(|segment| segment.recording.as_ref()).flat_map(|each| &each.columns);
            let columns = columns.map(|column| column.name.as_str());
            let names = content.axes.iter().map(|axis| axis.dossier.judgement.axis.as_str()).chain(columns);
            // A name may go on in the next line.
            let joined = text.split_whitespace().collect::<Vec<_>>().join(" ");
            let own = names.filter(|name| !name.is_empty()).fold(joined, |text, name| text.replace(name, ""));
            faults.extend(english(&own).into_iter().filter(|found| !of_a_title(found)));
        }
    }
    faults.sort();
    faults.dedup();
    assert!(faults.is_empty(), "{name}: {} faults\n{}", faults.len(), faults.join("\n"));
}
