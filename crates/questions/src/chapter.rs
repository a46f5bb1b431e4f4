//! Answers as chapters, for terminal, page and report.

mod commission;
mod encoder;
mod identification;
mod mount;
mod parts;
mod recorded;
mod simulation;
mod upkeep;
mod wiring;

pub use commission::commission;
pub use encoder::encoder;
pub use identification::identification;
pub use mount::mount;
pub use parts::marked_errata;
pub use recorded::{RecordedLine, recorded};
pub use simulation::simulation;
pub use upkeep::upkeep;
pub use wiring::wiring;

use crate::answer::document;
use answers::{Block, Chapter, Document, Hazard};
use quantities::Language;

/// Removes from each chapter the hazards and rules of earlier ones, so that a report states each of them once; empty
/// sections are removed too.
pub fn state_each_once(chapters: &mut [Chapter]) {
    let mut stated: Vec<Hazard> = Vec::new();
    for chapter in chapters {
        for block in &mut chapter.blocks {
            let Block::Hazards { items } = block else { continue };
            items.retain(|hazard| !stated.contains(hazard));
            stated.extend(items.iter().cloned());
        }
        chapter.blocks.retain(|block| !matches!(block, Block::Hazards { items } if items.is_empty()));
        let is_head: Vec<bool> = chapter.blocks.iter().map(|block| matches!(block, Block::Section { .. })).collect();
        let mut next = is_head.iter().skip(1).copied().chain([true]);
        let mut heads = is_head.iter().copied();
        chapter.blocks.retain(|_| {
            let (is_head, before_head) = (heads.next().unwrap_or(false), next.next().unwrap_or(false));
            !(is_head && before_head)
        });
    }
}

/// Returns the documents that chapters cite by name, in the order of the catalogue; a report lists each of its
/// documents once.
#[must_use]
pub fn documents(chapters: &[Chapter], language: Language) -> Vec<Document> {
    let texts: Vec<&str> = chapters.iter().flat_map(Chapter::texts).collect();
    let cited =
        |found: &&catalogue::SourceDocument| texts.iter().any(|text| names(text, words::short(found, language)));
    catalogue::documents().iter().filter(cited).map(|found| document(found, language)).collect()
}

/// Returns `true` if a text contains a short name as a separate word: `DIN 4408` is not in `DIN 44081`.
fn names(text: &str, short: &str) -> bool {
    let part = |sign: Option<char>| sign.is_some_and(|sign| sign.is_ascii_alphanumeric() || sign == '-');
    text.match_indices(short).any(|(at, _)| {
        let (before, after) = (text.get(..at).unwrap_or_default(), text.get(at + short.len()..).unwrap_or_default());
        !part(before.chars().next_back()) && !part(after.chars().next())
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::answer;
    use crate::codes::list_codes;
    use crate::commission::{DriveForm, usual_ambient};
    use crate::upkeep::read_date;
    use catalogue::Topic;
    use installation::mount::{MountInputs, mount as mounting};
    use installation::upkeep::UpkeepInputs;
    use order_code::OrderCode;

    #[test]
    fn a_document_is_cited_by_its_whole_name_only() {
        assert!(names("see CHA manual section 9.3", "CHA manual") && names("(NXP KTY84)", "NXP KTY84"));
        assert!(!names("DIN 44081 and more", "DIN 4408") && !names("SINAMICS S120-x", "SINAMICS S120"));
    }

    /// Otherwise a document would be listed for another one that a text cites.
    #[test]
    fn no_short_name_of_a_document_is_within_another_one() {
        for language in Language::ALL {
            for found in catalogue::documents() {
                let short = words::short(found, language);
                let within = |other: &&catalogue::SourceDocument| names(words::short(other, language), short);
                let ids: Vec<&str> = catalogue::documents().iter().filter(within).map(|other| other.id).collect();
                assert_eq!(ids, [found.id], "{short}");
            }
        }
    }

    #[test]
    fn every_document_that_the_chapters_of_a_code_cite_is_listed() {
        let code = order_code::parse("CHA-25A-100-H-M512P-B").unwrap().code;
        let mounted = {
            let asked = MountInputs::default();
            mount(&answer::mount(&mounting(&code, &asked).unwrap(), &asked, None, Language::En), Language::En)
        };
        let about = crate::commission::commission(&code).unwrap();
        let sheet = answer::commissioning(&about, DriveForm::Plain, usual_ambient(), Language::En);
        let chapters = [mounted, commission(&sheet, &[], Language::En)];
        let listed: Vec<String> = documents(&chapters, Language::En).into_iter().map(|found| found.id).collect();
        for wanted in ["cha-manual", "cha-manual-en-v03", "zd-shf-2uh", "nxp-kty84"] {
            assert!(listed.iter().any(|id| id == wanted), "{wanted}: {listed:?}");
        }
        assert!(!listed.iter().any(|id| id == "csd-2a-engineering-data"), "{listed:?}");
    }

    /// Wiring, mounting and commissioning of a code contain the same safety facts; a report states them once.
    #[test]
    fn a_report_states_each_hazard_once() {
        let code = order_code::parse("CHA-25A-100-H-M512P-B").unwrap().code;
        for language in Language::ALL {
            let asked = MountInputs::default();
            let wired = installation::wiring::wiring(&code).unwrap();
            let about = crate::commission::commission(&code).unwrap();
            let sheet = answer::commissioning(&about, DriveForm::Plain, usual_ambient(), language);
            let mut chapters = [
                wiring(&answer::wiring(&wired, None, language), Vec::new(), language),
                mount(&answer::mount(&mounting(&code, &asked).unwrap(), &asked, None, language), language),
                commission(&sheet, &[], language),
            ];
            let hazards = |chapters: &[Chapter]| -> Vec<String> {
                let blocks = chapters.iter().flat_map(|chapter| &chapter.blocks);
                let items = blocks.flat_map(|block| match block {
                    Block::Hazards { items } => items.clone(),
                    _ => Vec::new(),
                });
                items.map(|hazard| hazard.text).collect()
            };
            let before = hazards(&chapters);
            state_each_once(&mut chapters);
            let after = hazards(&chapters);
            let distinct: std::collections::BTreeSet<&String> = before.iter().collect();
            assert!(before.len() > after.len() && after.len() == distinct.len(), "{} {}", before.len(), after.len());
            for chapter in &chapters {
                let heads = |at: usize| matches!(chapter.blocks.get(at), Some(Block::Section { .. }) | None);
                assert!((0..chapter.blocks.len()).all(|at| !(heads(at) && heads(at + 1))), "{}", chapter.title);
            }
        }
    }

    /// Returns the whole text of a chapter.
    fn said(topic: Topic, code: &OrderCode, language: Language) -> Option<String> {
        let chapter = match topic {
            Topic::Wiring => {
                wiring(&answer::wiring(&installation::wiring::wiring(code)?, None, language), Vec::new(), language)
            }
            Topic::Mount => {
                let asked = MountInputs::default();
                mount(&answer::mount(&mounting(code, &asked)?, &asked, None, language), language)
            }
            Topic::Commission => {
                let about = crate::commission::commission(code)?;
                let sheet = answer::commissioning(&about, DriveForm::Plain, usual_ambient(), language);
                commission(&sheet, &[], language)
            }
            Topic::Upkeep => {
                let delivered = read_date("2026-03-01", language).ok()?;
                let asked = UpkeepInputs { delivered, storage: None, hours_per_day: None, inspect: None, today: None };
                upkeep(&answer::upkeep(&crate::upkeep::upkeep(code, &asked, language).ok()?, language), language)
            }
            Topic::Safety => return None,
        };
        serde_json::to_string(&chapter).ok()
    }

    #[test]
    fn every_fact_is_said_in_a_chapter_on_each_of_its_topics_in_both_languages() {
        let codes = list_codes(None);
        for fact in catalogue::facts() {
            let topics = Topic::ALL.iter().filter(|topic| **topic != Topic::Safety);
            for topic in topics.filter(|topic| fact.topics.contains(topic)) {
                for (language, text) in [(Language::En, fact.en), (Language::De, fact.de)] {
                    let text = serde_json::to_string(text).unwrap();
                    let holds = codes.iter().filter(|(code, _)| fact.is_shown(*topic, code));
                    let named = |code: &OrderCode| {
                        said(*topic, code, language).is_some_and(|said| said.contains(text.trim_matches('"')))
                    };
                    assert!(holds.map(|(code, _)| code).any(named), "{}: not said on {topic:?}, {language:?}", fact.id);
                }
            }
        }
    }
}
