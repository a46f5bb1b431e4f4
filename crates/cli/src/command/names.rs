//! Names of products that a call may state in place of an ordering code.

use super::folder::axes_of;
use super::meant::Called;
use super::readings::readings;
use crate::call::catalogue_of;
use crate::source::SourceFile;
use clap::Arg;
use project::{Hint, nearest_name};
use questions::embedded_catalogue;
use questions::list::{ArgumentKind, Reads};
use std::path::Path;

/// Largest number of words of which a name without quotes may consist.
const WORDS_MOST: usize = 4;

impl Called<'_> {
    /// Returns the names of the products in the catalogue files and the projects of the call; a file with faults has none.
    fn product_names(&self) -> &[String] {
        self.names.get_or_init(|| {
            let own = catalogue_of(&self.catalogues, self.language()).unwrap_or_else(|_| embedded_catalogue().clone());
            let mut found = own.names();
            for path in &self.projects {
                if let Ok(file) = SourceFile::read(path, Reads::Project, questions::MEMORY_USUAL, self.language()) {
                    found.extend(file.source().product_names(embedded_catalogue()));
                }
            }
            found
        })
    }

    /// Returns the option of an ordering code that the call may state.
    pub(super) fn code_option(&self, given: &[&str]) -> Option<String> {
        let is_code = |option: &&Arg| {
            let argument = option.get_long().and_then(|name| self.argument(name));
            argument.is_some_and(|argument| matches!(argument.kind, ArgumentKind::Code))
        };
        let code = self.options().find(is_code).and_then(Arg::get_long);
        let is_free = |name: &&str| !given.contains(name) || self.argument(name).is_some_and(|code| code.repeated);
        code.filter(is_free).map(|name| format!("--{name}"))
    }

    /// Returns `true` if the first of some words is a part of a code for several actuators, and begins no code of several words.
    pub(super) fn is_of_several_codes(&self, rest: &[(usize, &str)]) -> bool {
        /// Largest number of fields of a code.
        const FIELDS_MOST: usize = 8;
        let language = self.language();
        let is_about_codes = self.entry.is_none_or(|entry| entry.command().starts_with("code"));
        let Some((_, word)) = rest.first().filter(|_| !is_about_codes && self.projects.is_empty()) else {
            return false;
        };
        let begins_a_code = || {
            (2..=rest.len().min(FIELDS_MOST)).any(|count| {
                let words: Vec<&str> = rest.iter().take(count).map(|(_, word)| *word).collect();
                questions::read_code(&words.join(" "), language).is_ok()
            })
        };
        readings(word, language).len() > 1 && !begins_a_code()
    }

    /// Returns `true` if a word is a project of several axes, of which the call selects none.
    pub(super) fn is_of_several_axes(&self, word: &str) -> bool {
        let is_project = self.projects.iter().any(|path| path == Path::new(word));
        is_project && axes_of(Path::new(word)).len() > 1
    }

    /// Returns `true` if a word is the name of a product.
    pub(super) fn is_product(&self, word: &str) -> bool {
        self.product_names().iter().any(|name| name == word)
    }

    /// Returns the name of a product near a word.
    pub(super) fn near_product(&self, word: &str) -> Option<String> {
        let names: Vec<&str> = self.product_names().iter().map(String::as_str).collect();
        match nearest_name(word, &names) {
            Hint::DidYouMean(name) => Some(name),
            _ => None,
        }
    }

    /// Returns the name of a product that a word and the following ones form, and their number.
    pub(super) fn product_of_words(&self, word: &str, behind: &[(usize, &str)]) -> Option<(String, usize)> {
        (1..=behind.len().min(WORDS_MOST - 1)).rev().find_map(|count| {
            let more = behind.iter().take(count);
            let name = more.fold(word.to_owned(), |name, (_, more)| format!("{name} {more}"));
            self.is_product(&name).then_some((name, count))
        })
    }
}
