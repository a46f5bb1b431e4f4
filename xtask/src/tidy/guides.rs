//! Rule: the English and the German guide agree page by page in commands, blocks, headings, pictures and figures.

use std::path::Path;

use super::Violation;
use super::tree::Tree;
use crate::markdown::{Code, MarkdownText, Section};

const ENGLISH: &str = "docs/guide";
const GERMAN: &str = "docs/anleitung";
/// Additional argument of a command in the German guide.
const IN_GERMAN: &str = " --lang de";

pub(super) fn rule(root: &Path) -> Vec<Violation> {
    let tree = Tree::read(root);
    let pages =
        |folder: &str| -> Vec<String> { tree.under(folder, ".md").map(|page| page.replacen(folder, "", 1)).collect() };
    let (english, german) = (pages(ENGLISH), pages(GERMAN));
    let mut findings = Vec::new();
    let mut alone = |page: &String, here: &str, there: &str| {
        let message = format!("`{here}{page}` has no twin `{there}{page}`");
        findings.push(Violation { path: format!("{here}{page}"), line: 1, rule: "guides", message });
    };
    english.iter().filter(|page| !german.contains(page)).for_each(|page| alone(page, ENGLISH, GERMAN));
    german.iter().filter(|page| !english.contains(page)).for_each(|page| alone(page, GERMAN, ENGLISH));
    for page in english.iter().filter(|page| german.contains(page)) {
        let read = |folder: &str| MarkdownText::read(&tree.text(&format!("{folder}{page}")).unwrap_or_default());
        let path = format!("{GERMAN}{page}");
        let tell = |(line, message)| Violation { path: path.clone(), line, rule: "guides", message };
        findings.extend(differences(&read(ENGLISH), &read(GERMAN)).into_iter().map(tell));
    }
    findings
}

/// Returns the differences of a German page from the English one, with their lines.
fn differences(english: &MarkdownText, german: &MarkdownText) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    let infos = |page: &MarkdownText| page.code.iter().map(|code| code.info.clone()).collect::<Vec<_>>();
    let levels = |page: &MarkdownText| page.sections.iter().map(|section| section.level).collect::<Vec<_>>();
    let pictures = |page: &MarkdownText| page.links.iter().filter(|link| link.is_picture).count();
    if infos(english) != infos(german) {
        found.push((1, format!("blocks of code {:?}, in English {:?}", infos(german), infos(english))));
    } else {
        for (ours, theirs) in english.code.iter().zip(&german.code) {
            if shown(ours) != shown(theirs) {
                let message = format!("shows {:?}, in English {:?}", shown(theirs), shown(ours));
                found.push((theirs.line, message));
            }
        }
    }
    if levels(english) != levels(german) {
        found.push((1, format!("headings of the levels {:?}, in English {:?}", levels(german), levels(english))));
    } else {
        for (ours, theirs) in english.sections.iter().zip(&german.sections) {
            let (ours, figures) = (figures(ours), figures(theirs));
            let missing = without(&ours, &figures);
            let added = without(&figures, &ours);
            if !missing.is_empty() || !added.is_empty() {
                let message = format!("figures of this section: {missing:?} in English only, {added:?} in German only");
                found.push((theirs.line, message));
            }
        }
    }
    if pictures(english) != pictures(german) {
        found.push((1, format!("{} pictures, in English {}", pictures(german), pictures(english))));
    }
    found
}

/// Returns the parts of a code block that must agree: the commands of a console block, the lines of a file without
/// comments.
fn shown(code: &Code) -> Vec<String> {
    let line = |line: &str| match code.info.as_str() {
        "console" => line.strip_prefix("$ ").map(|command| command.replace(IN_GERMAN, "")),
        "toml" => Some(line.split('#').next().unwrap_or_default().trim_end().to_owned()),
        _ => None,
    };
    code.text.lines().filter_map(line).collect()
}

/// Returns the numbers in a section, sorted, without decimal sign: 41.47 and 41,47 are equal.
fn figures(section: &Section) -> Vec<String> {
    let prose = section.prose.iter().map(|(_, text)| text.as_str());
    let mut found = Vec::new();
    for text in prose.chain(section.spans.iter().map(String::as_str)) {
        let mut figure = String::new();
        let mut signs = text.chars().peekable();
        while let Some(sign) = signs.next() {
            let within = matches!(sign, '.' | ',') && !figure.is_empty();
            if sign.is_ascii_digit() {
                figure.push(sign);
            } else if !(figure.is_empty() || within && signs.peek().is_some_and(char::is_ascii_digit)) {
                found.push(std::mem::take(&mut figure));
            }
        }
        if !figure.is_empty() {
            found.push(figure);
        }
    }
    found.sort();
    found
}

/// Returns the entries of the first list that are missing in the second; duplicates count twice.
fn without(first: &[String], second: &[String]) -> Vec<String> {
    let mut rest = second.to_vec();
    let mut found = Vec::new();
    for figure in first {
        match rest.iter().position(|other| other == figure) {
            Some(at) => drop(rest.swap_remove(at)),
            None => found.push(figure.clone()),
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tidy::scratch::Scratch;

    const PAGE: &str = "# Ask\n41.47 of 71 Nm, `\"1.3 kg m^2\"`\n\n```console\n$ antrieb size a.toml\nfits\n```\n";

    fn findings_of(german: &str) -> Vec<String> {
        let scratch = Scratch::new(&[("docs/guide/a.md", PAGE), ("docs/anleitung/a.md", german)]);
        rule(scratch.root()).into_iter().map(|finding| finding.message).collect()
    }

    #[test]
    fn a_page_and_its_twin_say_the_same() {
        let twin = "# Fragen\n71 Nm, davon 41,47, `\"1.3 kg m^2\"`\n\n```console\n$ antrieb size a.toml --lang de\ngeeignet\n```\n";
        assert_eq!(findings_of(twin), Vec::<String>::new());
    }

    #[test]
    fn a_wrong_figure_a_wrong_command_and_a_lost_block_are_reported() {
        let twin = |figure: &str, command: &str| {
            format!("# Fragen\n{figure} von 71 Nm, `\"1.3 kg m^2\"`\n\n```console\n$ {command}\nja\n```\n")
        };
        assert!(findings_of(&twin("41,74", "antrieb size a.toml --lang de"))[0].contains("4174"));
        assert!(findings_of(&twin("41,47", "antrieb check a.toml --lang de"))[0].contains("check"));
        assert!(findings_of("# Fragen\n41,47 von 71 Nm, `\"1.3 kg m^2\"`\n")[0].contains("blocks of code []"));
        assert!(findings_of("41,47\n")[1].contains("levels"));
    }

    #[test]
    fn a_page_without_its_twin_is_reported() {
        let scratch = Scratch::new(&[("docs/guide/a.md", PAGE), ("docs/anleitung/b.md", PAGE)]);
        let found: Vec<String> = rule(scratch.root()).into_iter().map(|finding| finding.path).collect();
        assert_eq!(found, ["docs/guide/a.md", "docs/anleitung/b.md"]);
    }
}
