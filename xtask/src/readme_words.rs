//! Words of a command as the README prints it.

#[derive(Debug, PartialEq)]
pub(crate) enum ReadmeWord {
    Text(String),
    Into,
}

impl ReadmeWord {
    pub(crate) fn text(self) -> Option<String> {
        match self {
            Self::Text(text) => Some(text),
            Self::Into => None,
        }
    }
}

/// Splits a line into words like a shell, with quotes, `>` and a comment only, so that the README's commands have the
/// same meaning in every shell.
pub(crate) fn split(line: &str) -> Result<Vec<ReadmeWord>, &'static str> {
    let mut words = Vec::new();
    let mut word: Option<String> = None;
    let mut quote: Option<char> = None;
    for letter in line.chars() {
        match (quote, letter) {
            (Some(mark), _) if letter == mark => quote = None,
            (Some(_), _) => word.get_or_insert_default().push(letter),
            (None, '"' | '\'') => {
                quote = Some(letter);
                word.get_or_insert_default();
            }
            (None, '#') if word.is_none() => break,
            (None, '>') => {
                words.extend(word.take().map(ReadmeWord::Text));
                words.push(ReadmeWord::Into);
            }
            (None, '|' | '&' | ';' | '<' | '$' | '`' | '\\' | '*') => {
                return Err("a README command stands alone: no pipe, variable, pattern or second command");
            }
            (None, _) if letter.is_whitespace() => words.extend(word.take().map(ReadmeWord::Text)),
            (None, _) => word.get_or_insert_default().push(letter),
        }
    }
    if quote.is_some() {
        return Err("a quote is not closed");
    }
    words.extend(word.map(ReadmeWord::Text));
    Ok(words)
}
