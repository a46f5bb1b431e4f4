//! Builds the book: the documents of `docs/` and those they link, with mdBook into `target/book`; checks its links.
//!
//! The documents link each other and the files of the repository in place, so that they can be read on a code forge
//! too. A book of `docs/` alone would break half of these links, so the pages of the summary and the files they link
//! are copied to `target/xtask/book` in the layout of the repository, and mdBook builds from there.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use crate::Error;
use crate::cargo::{Workspace, must_succeed};
use crate::markdown::{Link, MarkdownText, leads_to};
use crate::tidy::tree::Tree;
use crate::tools::{LYCHEE, MDBOOK};

/// Order of the pages.
pub(crate) const SUMMARY: &str = "docs/SUMMARY.md";
/// The settings of mdBook, and the width of a page.
const SETTINGS: [&str; 2] = ["docs/book.toml", "docs/book.css"];

/// Builds the book and checks every link in it.
///
/// # Errors
/// When a tool is missing, a page cannot be copied, mdBook does not build or a link leads nowhere.
pub fn run(root: &Path) -> Result<(), Error> {
    let tree = Tree::read(root);
    let target = Workspace::ask(root)?.target;
    let (laid_out, book) = (target.join("xtask").join("book"), target.join("book"));
    lay_out(root, &tree, &laid_out)?;
    must_succeed(MDBOOK.command(root)?.arg("build").arg(&laid_out).arg("--dest-dir").arg(&book))?;
    for page in chapters(&tree).into_iter().filter(|page| is_german(page)) {
        name_language(&book.join(page).with_extension("html"))?;
    }
    must_succeed(LYCHEE.command(root)?.arg(&book))?;
    eprintln!("book: {}", book.join("index.html").display());
    Ok(())
}

/// Returns `true` for a document written in German.
pub(crate) fn is_german(document: &str) -> bool {
    document.starts_with("docs/anleitung/")
        || document.starts_with("docs/theorie/")
        || ["docs/reference/befehle.md", "docs/reference/projektdatei.md"].contains(&document)
}

/// Returns the pages named in the summary, in its order.
pub(crate) fn chapters(tree: &Tree) -> Vec<String> {
    let summary = MarkdownText::read(&tree.text(SUMMARY).unwrap_or_default());
    summary.links.iter().filter_map(|link| leads_to(SUMMARY, &link.target)).collect()
}

/// Copies settings, summary, pages and the files linked by the pages.
fn lay_out(root: &Path, tree: &Tree, folder: &Path) -> Result<(), Error> {
    if folder.exists() {
        fs::remove_dir_all(folder).map_err(|source| Error::File { path: folder.to_path_buf(), source })?;
    }
    let chapters = chapters(tree);
    let mut files: BTreeSet<String> = chapters.iter().cloned().collect();
    for page in &chapters {
        let document = MarkdownText::read(&tree.text(page).unwrap_or_default());
        let led_to = document.links.iter().filter_map(|Link { target, .. }| leads_to(page, target));
        // A page missing from the summary would be copied as text: its link is left to fail.
        files.extend(led_to.filter(|file| !file.ends_with(".md") && root.join(file).is_file()));
    }
    for file in &files {
        let to = folder.join("src").join(as_index(file));
        create(to.parent().unwrap_or(folder))?;
        if let Some(text) = tree.text(file).filter(|_| file.ends_with(".md")) {
            write(&to, &with_indices(&text))?;
        } else {
            fs::copy(root.join(file), &to).map_err(|source| Error::File { path: root.join(file), source })?;
        }
    }
    for file in SETTINGS {
        write(&folder.join(file.trim_start_matches("docs/")), &tree.text(file).unwrap_or_default())?;
    }
    write(&folder.join("src").join("SUMMARY.md"), &from_the_root(&tree.text(SUMMARY).unwrap_or_default()))
}

/// Returns the summary with links relative to the root of the repository.
fn from_the_root(summary: &str) -> String {
    let line = |line: &str| {
        let (head, rest) = line.split_once("](")?;
        let (target, tail) = rest.split_once(')')?;
        Some(format!("{head}]({}){tail}", as_index(&leads_to(SUMMARY, target)?)))
    };
    summary.lines().map(|text| line(text).unwrap_or_else(|| text.to_owned()) + "\n").collect()
}

/// Replaces README.md by index.md: mdBook renders a README as `index.html` but leaves the links to it unchanged.
fn as_index(path: &str) -> String {
    path.replace("README.md", "index.md")
}

/// Returns a page with its links to a README changed to links to an index.
fn with_indices(page: &str) -> String {
    let links = MarkdownText::read(page).links.into_iter().map(|link| link.target);
    links
        .filter(|target| leads_to("", target).is_some_and(|file| file.ends_with("README.md")))
        .fold(page.to_owned(), |text, target| {
            text.replace(&format!("]({target})"), &format!("]({})", as_index(&target)))
        })
}

/// Sets the language of a page to German: mdBook supports one language per book, and screen readers need that of the
/// page.
fn name_language(page: &Path) -> Result<(), Error> {
    let file = |source| Error::File { path: page.to_path_buf(), source };
    let text = fs::read_to_string(page).map_err(file)?;
    write(page, &text.replacen("<html lang=\"en\"", "<html lang=\"de\"", 1))
}

fn create(folder: &Path) -> Result<(), Error> {
    fs::create_dir_all(folder).map_err(|source| Error::File { path: folder.to_path_buf(), source })
}

fn write(path: &Path, text: &str) -> Result<(), Error> {
    fs::write(path, text).map_err(|source| Error::File { path: path.to_path_buf(), source })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_summary_is_reported_from_the_root() {
        let summary = "# Summary\n\n[antrieb](../README.md)\n\n- [Axis](guide/first-axis.md)\n";
        assert_eq!(from_the_root(summary), "# Summary\n\n[antrieb](index.md)\n\n- [Axis](docs/guide/first-axis.md)\n");
    }

    #[test]
    fn a_link_to_a_readme_leads_to_the_index_of_its_folder() {
        let page = "README.md [data](../../data/README.md#form) [a](https://example.org/README.md)\n";
        assert_eq!(
            with_indices(page),
            "README.md [data](../../data/index.md#form) [a](https://example.org/README.md)\n"
        );
    }

    #[test]
    fn the_book_has_pages_in_both_languages() {
        let chapters = chapters(&Tree::read(&crate::root()));
        assert!(chapters.iter().any(|page| is_german(page)) && chapters.iter().any(|page| !is_german(page)));
    }
}
