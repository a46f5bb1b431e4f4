//! A check by its title: where it is stated with its numbers.

use super::folder::projects_in;
use super::typed::typed;
use crate::table::paragraph;
use quantities::Language;
use std::path::Path;
use words::terminal;

/// Returns the sentence on a check and the call that states it with its numbers, for a project of the folder.
pub(crate) fn what_a_check_is((title, id, meaning): (&str, &str, &str), language: Language) -> String {
    let own = projects_in(Path::new(""));
    let project = own.first().and_then(|path| path.to_str()).unwrap_or("axis.toml");
    let call = typed(["antrieb", "explain", project, "--check", id]);
    format!("{}  {call}\n", paragraph("", &terminal::help_on_check(&title, &id, &meaning, language)))
}
