#![allow(clippy::unwrap_used, reason = "a test fails loudly")]

use super::*;

fn names(folder: &str, ending: &str) -> Vec<String> {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs").join(folder);
    let files = std::fs::read_dir(folder).unwrap().flatten().map(|file| file.file_name().into_string().unwrap());
    let mut found: Vec<String> = files.filter(|name| name.ends_with(ending)).collect();
    found.sort();
    found
}

#[test]
fn every_chapter_and_every_picture_is_there_in_both_languages() {
    for folder in ["theory", "theorie"] {
        assert_eq!(CHAPTERS.map(|(name, _)| name.to_owned()).to_vec(), names(folder, ".md"));
        assert_eq!(PICTURES.map(|(name, _)| name.to_owned()).to_vec(), names(&format!("{folder}/pictures"), ".svg"));
    }
    for path in theory_files() {
        assert_eq!(file(&format!("/{path}")).unwrap().status, 200, "{path}");
    }
    assert_eq!(theory_files().count(), 2 * (CHAPTERS.len() + PICTURES.len()));
    assert_eq!(file("/theory/../gear.html").unwrap().status, 404);
    assert_eq!(file("/theory/de/de/gear.html").unwrap().status, 404);
    assert!(file("/gear.html").is_none());
}

#[test]
fn the_address_of_a_chapter_decides_its_language() {
    for (path, language) in [("/theory/gear.html", Language::En), ("/theory/de/gear.html", Language::De)] {
        assert_eq!(language_of(path), Some(language));
        let page = String::from_utf8(file(path).unwrap().body).unwrap();
        assert!(page.contains(&format!("<html lang=\"{}\"", language.id())), "{path}");
    }
    assert_eq!(language_of("/work"), None);
}

/// Requires that every link within the theory leads to a heading or a picture of the same language.
#[test]
fn links_within_the_theory_lead_somewhere() {
    for language in Language::ALL {
        let shown = |(name, texts): &(&str, Texts)| {
            (name.replace(".md", ".html"), shown(name, text_in(texts, language), language))
        };
        let pages: Vec<(String, String)> = CHAPTERS.iter().map(shown).collect();
        let mut seen = 0;
        for (own, page) in &pages {
            let folder = format!("/{}", words::page::theory_folder(language));
            for address in page.split("src=\"").skip(1).filter_map(|rest| rest.split('"').next()) {
                assert_eq!(file(&format!("{folder}{address}")).unwrap().status, 200, "{own}: {address}");
            }
            for address in page.split("href=\"").skip(1).filter_map(|rest| rest.split('"').next()) {
                let (file, anchor) =
                    address.split_once('#').map_or((address, None), |(file, anchor)| (file, Some(anchor)));
                if file.starts_with("../") || file.starts_with("data:") {
                    continue;
                }
                let file = if file.is_empty() { own } else { file };
                let (_, target) =
                    pages.iter().find(|(name, _)| name == file).unwrap_or_else(|| panic!("{own}: {address}"));
                if let Some(anchor) = anchor {
                    // Umlauts are escaped in an address.
                    let (anchor, _) = form_urlencoded::parse(anchor.as_bytes()).next().unwrap();
                    assert!(target.contains(&format!("id=\"{anchor}\"")), "{own}: {address}");
                    seen += 1;
                }
            }
            let note = [".rs`", "crates/", ".rs<", "In the code"].iter().find(|note| page.contains(**note));
            assert!(note.is_none(), "{own}: a note for developers outside the section In the code: {note:?}");
            assert!(!page.contains(".md\"") && page.contains("<h1 id="), "{own}");
        }
        assert!(seen > 5, "{seen}");
    }
}

/// Section of a chapter: what must agree in both languages.
#[derive(Default, Debug, PartialEq)]
struct Section {
    level: usize,
    /// Formulas that stand alone, in signs that no language changes.
    formulas: Vec<String>,
    /// Digits of each number of each table, in ascending order.
    tables: Vec<Vec<String>>,
    /// Digits of each different number elsewhere in the text, in ascending order; the index of a symbol is none.
    numbers: Vec<String>,
    /// Chapters, headings aside, that links lead to, in ascending order.
    links: Vec<String>,
}

/// Names in formulas that are the same in both languages.
const FUNCTIONS: [&str; 10] = ["sin", "cos", "tan", "cot", "max", "min", "ln", "arg", "sgn", "arcosh"];

/// Returns a line of a formula with decimal points, without its words and the punctuation between them.
fn signs(line: &str) -> String {
    let letters: Vec<char> = line.chars().collect();
    let at = |place: usize| letters.get(place).copied();
    let is_latin = |letter: char| letter.is_ascii_alphabetic() || "äöüÄÖÜß".contains(letter);
    let mut kept = String::new();
    let mut place = 0;
    let mut is_index = false;
    while let Some(letter) = at(place) {
        is_index = letter == '_'
            || (is_index
                && (letter.is_alphanumeric() || (letter == ',' && at(place + 1).is_some_and(char::is_alphanumeric))));
        let run: String = letters[place..].iter().take_while(|letter| is_latin(**letter)).collect();
        let length = run.chars().count();
        if is_index || length == 0 {
            let is_decimal = letter == ','
                && kept.ends_with(|before: char| before.is_ascii_digit())
                && at(place + 1).is_some_and(|next| next.is_ascii_digit());
            let separates = matches!(letter, ',' | ';' | ':' | '.')
                && at(place + 1).is_none_or(|next| next.is_whitespace() || next == ')');
            // A hyphen joins words; the sign of subtraction is another one.
            if !(separates || letter == '-') {
                kept.push(if is_decimal { '.' } else { letter });
            }
            place += 1;
            continue;
        }
        let is_lower = run.chars().skip(1).all(char::is_lowercase);
        let is_article = run == "a"
            && at(place + 1) == Some(' ')
            && at(place + 2).is_some_and(is_latin)
            && at(place + 3).is_some_and(is_latin);
        let is_word = length > 2 && is_lower || length == 2 && run.chars().all(char::is_lowercase) || is_article;
        if !is_word || FUNCTIONS.contains(&&*run) {
            kept.push_str(&run);
        }
        place += length;
    }
    let kept = kept.split_whitespace().collect::<Vec<_>>().join(" ");
    kept.replace("( )", "").replace("()", "").split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Returns the digits of each number, sorted: 1.5 and 1,5 are equal. The index of a symbol is no number.
fn numbers(text: &str) -> Vec<String> {
    let mut found: Vec<String> = Vec::new();
    let letters: Vec<char> = text
        .split_inclusive(|letter: char| letter.is_whitespace())
        .flat_map(|word| {
            let mut is_index = false;
            word.chars().map(move |letter| {
                is_index = letter == '_' || (is_index && letter.is_alphanumeric());
                if is_index { '_' } else { letter }
            })
        })
        .collect();
    let is_digit = |place: usize| letters.get(place).is_some_and(char::is_ascii_digit);
    let mut number = String::new();
    for place in 0..=letters.len() {
        if is_digit(place) {
            number.push(letters[place]);
        } else if !number.is_empty() {
            let is_inside = matches!(letters.get(place), Some('.' | ',')) && is_digit(place + 1);
            if !is_inside {
                found.push(std::mem::take(&mut number));
            }
        }
    }
    found.sort();
    found
}

/// Returns the sections of a chapter that an engineer reads.
fn sections(text: &str, language: Language) -> Vec<Section> {
    let mut found: Vec<Section> = Vec::new();
    let (mut is_formula, mut table, mut prose) = (false, None::<String>, String::new());
    let end = |found: &mut Vec<Section>, prose: &mut String| {
        if let Some(section) = found.last_mut() {
            section.numbers = numbers(prose);
            section.numbers.dedup();
            section.links.sort();
        }
        prose.clear();
    };
    for event in for_engineers(Parser::new_ext(text, Options::ENABLE_TABLES).collect(), language) {
        match event {
            Event::Start(Tag::Heading { level, .. }) => {
                end(&mut found, &mut prose);
                found.push(Section { level: level as usize, ..Section::default() });
            }
            Event::InlineHtml(mark) if &*mark == FORMULA => is_formula = true,
            Event::InlineHtml(mark) if &*mark == FORMULA_END => is_formula = false,
            Event::Text(words) if is_formula => {
                let section = found.last_mut().unwrap();
                section.formulas.extend(words.lines().map(signs).filter(|line| !line.is_empty()));
            }
            Event::Start(Tag::Table(_)) => table = Some(String::new()),
            Event::End(TagEnd::Table) => found.last_mut().unwrap().tables.push(numbers(&table.take().unwrap())),
            Event::Start(Tag::Link { dest_url, .. }) => {
                let file = dest_url.split('#').next().unwrap().to_owned();
                let file = if file.contains('/') { file.replace("/anleitung/", "/guide/") } else { file };
                found.last_mut().unwrap().links.push(file);
            }
            Event::Text(words) | Event::Code(words) => {
                let into = table.as_mut().unwrap_or(&mut prose);
                into.push_str(&words);
            }
            Event::End(TagEnd::TableCell | TagEnd::Paragraph | TagEnd::Item) | Event::SoftBreak => {
                table.as_mut().unwrap_or(&mut prose).push('\n');
            }
            _ => {}
        }
    }
    end(&mut found, &mut prose);
    found
}

/// Requires the same sections, formulas, numbers and links in both languages.
#[test]
fn a_chapter_says_the_same_in_both_languages() {
    let mut differences = Vec::new();
    for (name, [english, german]) in &CHAPTERS {
        let (english, german) = (sections(english, Language::En), sections(german, Language::De));
        if english.len() != german.len() {
            differences.push(format!("{name}: {} sections, in English {}", german.len(), english.len()));
            continue;
        }
        for (place, (theirs, ours)) in english.iter().zip(&german).enumerate() {
            let mut differ = |what: &str, theirs: &[String], ours: &[String]| {
                let (theirs, ours): (Vec<_>, Vec<_>) = (without(theirs, ours), without(ours, theirs));
                if !(theirs.is_empty() && ours.is_empty()) {
                    differences.push(format!(
                        "{name}, section {place}: {what} in English only {theirs:?}, in German only {ours:?}"
                    ));
                }
            };
            differ("formulas", &theirs.formulas, &ours.formulas);
            differ("numbers", &theirs.numbers, &ours.numbers);
            differ("links", &theirs.links, &ours.links);
            for (theirs, ours) in theirs.tables.iter().zip(&ours.tables) {
                differ("numbers of a table", theirs, ours);
            }
            if theirs.level != ours.level || theirs.tables.len() != ours.tables.len() {
                differences.push(format!("{name}, section {place}: level or number of tables"));
            }
        }
    }
    assert!(differences.is_empty(), "{}", differences.join("\n"));
}

/// Returns the entries of the first list that are missing in the second; duplicates count twice.
fn without(first: &[String], second: &[String]) -> Vec<String> {
    let mut rest = second.to_vec();
    let mut found = Vec::new();
    for entry in first {
        match rest.iter().position(|other| other == entry) {
            Some(at) => drop(rest.swap_remove(at)),
            None => found.push(entry.clone()),
        }
    }
    found
}

#[test]
fn a_wrong_number_a_lost_formula_and_a_lost_section_are_seen() {
    let english = "# A\n1.5 m, [x](gear.md#a)\n\n    P = 1.5 R I²   if T > 0\n\n| a |\n|---|\n| 0.25 |\n\n## Cost\n7\n";
    let german = "# B\n1,5 m, [x](gear.md#b)\n\n    P = 1,5 R I²   wenn T > 0\n\n| a |\n|---|\n| 0,25 |\n";
    let of_english = sections(english, Language::En);
    assert_eq!(of_english, sections(german, Language::De));
    for (old, new) in
        [("1,5 m", "1,6 m"), ("1,5 R", "1,6 R"), ("R I²", "I²"), ("0,25", "0,52"), ("gear", "twin"), ("# B", "## B")]
    {
        assert_ne!(of_english, sections(&german.replace(old, new), Language::De), "{old}");
    }
}

#[test]
fn html_in_a_chapter_is_shown_as_it_is_written() {
    let (title, body) =
        set("# A *b* `c`\n\nx <b>y</b> [in](gear.md#a) [out](../x.md) [far](https://e.org)\n", Language::En);
    assert_eq!(title, "A b c");
    assert!(
        body.contains("id=\"a-b-c\"") && body.contains("&lt;b&gt;y") && body.contains("href=\"gear.html#a\""),
        "{body}"
    );
    assert!(!body.contains("x.md") && !body.contains("e.org"), "{body}");
}

#[test]
fn a_key_and_a_check_are_quoted_as_the_page_names_them() {
    let text = "# A\n\nx `rope_mass` `brake_holding` `rod`\n";
    let (_, german) = set(text, Language::De);
    assert!(german.contains("<em>Masse ") && german.contains("<em>Haltemoment der Bremse</em>"), "{german}");
    assert!(german.contains("<code>rod</code>"), "{german}");
    let (_, english) = set(text, Language::En);
    assert!(english.contains("<em>mass ") && english.contains("<em>brake, holding torque</em>"), "{english}");
}
