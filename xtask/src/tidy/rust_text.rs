//! Rust source with everything blanked out that is no code: comments, literals and, on demand, test code.
//! Lines keep their numbers.

/// The code of a file: comments and the insides of string and character literals become spaces.
pub(super) fn code(source: &str) -> String {
    let mut scan = Scan { chars: source.chars().collect(), at: 0, out: String::new() };
    while let Some(letter) = scan.peek(0) {
        match (letter, scan.peek(1)) {
            ('/', Some('/')) => scan.blank_while(|scan| scan.peek(0).is_some_and(|c| c != '\n')),
            ('/', Some('*')) => scan.block_comment(),
            ('"', _) => scan.string(),
            ('\'', _) => scan.character_or_lifetime(),
            ('r', Some('"' | '#')) if !scan.in_word() => scan.raw_string(),
            _ => scan.keep(),
        }
    }
    scan.out
}

/// Code without its test items, and the names of the modules that are test code as a whole (`#[cfg(test)] mod name;`).
pub(super) fn without_tests(code: &str) -> (String, Vec<String>) {
    const MARKS: [&str; 2] = ["#[cfg(test)]", "#[cfg(all(test,"];
    let blanked = |text: &str| text.chars().map(|c| if c == '\n' { c } else { ' ' }).collect::<String>();
    if code.contains("#![cfg(test)]") {
        return (blanked(code), Vec::new());
    }
    let (mut out, mut modules, mut rest) = (String::new(), Vec::new(), code);
    while let Some(at) = MARKS.iter().filter_map(|mark| rest.find(mark)).min() {
        let (before, from) = rest.split_at(at);
        let (item, after) = from.split_at(item_end(from));
        modules.extend(module_name(item));
        out.push_str(before);
        out.push_str(&blanked(item));
        rest = after;
    }
    out.push_str(rest);
    (out, modules)
}

/// Lines (from 1) on which `word` stands as a word of its own. The word may be a path such as `std::fs`.
pub(super) fn lines_with(code: &str, word: &str) -> Vec<usize> {
    let name = |c: char| c.is_alphanumeric() || c == '_';
    let alone = |line: &str| {
        line.match_indices(word).any(|(at, _)| {
            let before = line.get(..at).unwrap_or_default();
            let after = line.get(at + word.len()..).unwrap_or_default();
            !before.ends_with(name) && !after.starts_with(name)
        })
    };
    (1..).zip(code.lines()).filter(|(_, line)| alone(line)).map(|(number, _)| number).collect()
}

/// The first names inside `std::{…}` groups with their lines: `use std::{env, fs::File}` gives `env` and `fs`.
pub(super) fn std_group_names(code: &str) -> Vec<(usize, String)> {
    const OPEN: &str = "std::{";
    let mut found = Vec::new();
    for (at, _) in code.match_indices(OPEN) {
        let start = at + OPEN.len();
        let mut line = 1 + code.get(..start).unwrap_or_default().matches('\n').count();
        let (mut depth, mut name, mut in_first_name) = (0_u32, String::new(), true);
        for letter in code.get(start..).unwrap_or_default().chars() {
            let of_name = letter.is_alphanumeric() || letter == '_';
            if !of_name && !name.is_empty() {
                found.push((line, std::mem::take(&mut name)));
                in_first_name = false;
            }
            match letter {
                '{' => depth += 1,
                '}' if depth == 0 => break,
                '}' => depth -= 1,
                ',' if depth == 0 => in_first_name = true,
                '\n' => line += 1,
                _ if of_name && in_first_name && depth == 0 => name.push(letter),
                _ => {}
            }
        }
    }
    found
}

/// Length in bytes of the item that starts with an attribute: up to its closing brace or semicolon.
fn item_end(item: &str) -> usize {
    let (mut braces, mut others) = (0_u32, 0_u32);
    for (at, letter) in item.char_indices() {
        match letter {
            '(' | '[' => others += 1,
            ')' | ']' => others = others.saturating_sub(1),
            '{' => braces += 1,
            '}' => {
                braces = braces.saturating_sub(1);
                if braces == 0 {
                    return at + 1;
                }
            }
            ';' if braces == 0 && others == 0 => return at + 1,
            _ => {}
        }
    }
    item.len()
}

fn module_name(item: &str) -> Option<String> {
    let item = item.strip_suffix(';')?;
    let mut words = item.split_whitespace().rev();
    let name = words.next()?;
    (words.next()? == "mod").then(|| name.to_owned())
}

struct Scan {
    chars: Vec<char>,
    at: usize,
    out: String,
}

impl Scan {
    fn peek(&self, ahead: usize) -> Option<char> {
        self.chars.get(self.at + ahead).copied()
    }

    fn keep(&mut self) {
        self.out.extend(self.peek(0));
        self.at += 1;
    }

    fn blank(&mut self) {
        self.out.extend(self.peek(0).map(|c| if c == '\n' { c } else { ' ' }));
        self.at += 1;
    }

    fn blank_while(&mut self, more: impl Fn(&Self) -> bool) {
        while self.peek(0).is_some() && more(self) {
            self.blank();
        }
    }

    /// Whether the letter before belongs to a name; `b` and `c` alone are prefixes of a literal.
    fn in_word(&self) -> bool {
        let name = |c: char| c.is_alphanumeric() || c == '_';
        let before = |back: usize| self.at.checked_sub(back).and_then(|at| self.chars.get(at)).copied();
        match before(1) {
            Some('b' | 'c') => before(2).is_some_and(name),
            Some(letter) => name(letter),
            None => false,
        }
    }

    fn block_comment(&mut self) {
        let mut depth = 0_u32;
        while self.peek(0).is_some() {
            match (self.peek(0), self.peek(1)) {
                (Some('/'), Some('*')) => {
                    depth += 1;
                    self.blank();
                }
                (Some('*'), Some('/')) => {
                    depth -= 1;
                    self.blank();
                }
                _ => {}
            }
            self.blank();
            if depth == 0 {
                return;
            }
        }
    }

    fn string(&mut self) {
        self.keep();
        while let Some(letter) = self.peek(0) {
            match letter {
                '"' => return self.keep(),
                '\\' => {
                    self.blank();
                    self.blank();
                }
                _ => self.blank(),
            }
        }
    }

    fn raw_string(&mut self) {
        let hashes = self.chars.iter().skip(self.at + 1).take_while(|c| **c == '#').count();
        if self.peek(1 + hashes) != Some('"') {
            return self.keep();
        }
        (0..hashes + 2).for_each(|_| self.blank());
        let closed = |scan: &Self| scan.peek(0) == Some('"') && (1..=hashes).all(|ahead| scan.peek(ahead) == Some('#'));
        self.blank_while(|scan| !closed(scan));
        (0..=hashes).for_each(|_| self.blank());
    }

    fn character_or_lifetime(&mut self) {
        let escaped = self.peek(1) == Some('\\');
        if !escaped && self.peek(2) != Some('\'') {
            return self.keep();
        }
        (0..if escaped { 3 } else { 2 }).for_each(|_| self.blank());
        self.blank_while(|scan| scan.peek(0) != Some('\''));
        self.blank();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_and_literals_are_no_code() {
        let source = "a // gone\n/* gone /* gone */ gone */ b \"gone \\\" gone\" c 'g' '\\'' '\\u{67}' &'d e\n\
                      r#\"gone \"gone\"# f br\"gone\" bar r#type g\n";
        let code = code(source);
        assert!(!code.contains("gone") && !code.contains("u{67}"), "{code}");
        let words: Vec<&str> = code.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty()).collect();
        assert_eq!(words, ["a", "b", "c", "d", "e", "f", "b", "bar", "r", "type", "g"]);
        assert_eq!(code.lines().count(), source.lines().count());
    }

    #[test]
    fn test_items_go_and_the_rest_stays() {
        let source = "use a;\n#[cfg(test)]\nuse gone;\nfn b() {}\n#[cfg(test)]\nmod tests {\n fn gone() { x[0]; }\n}\n\
                      #[cfg(test)]\nmod scratch;\nfn c() {}\n";
        let (code, modules) = without_tests(source);
        assert!(!code.contains("gone"), "{code}");
        assert!(code.contains("use a") && code.contains("fn b") && code.contains("fn c"), "{code}");
        assert_eq!(modules, ["scratch"]);
        assert_eq!(code.lines().count(), source.lines().count());
    }

    #[test]
    fn words_stand_alone() {
        assert_eq!(lines_with("Instantly\nx::Instant::now()\nan_Instant", "Instant"), [2]);
    }

    #[test]
    fn grouped_imports_are_seen() {
        let code = "use std::{\n    collections::{BTreeMap, fs},\n    env,\n    fs::File,\n};\n";
        let names = std_group_names(code);
        assert_eq!(names, [(2, "collections".into()), (3, "env".into()), (4, "fs".into())]);
    }
}
