//! `mount`: mounting of an actuator.

use crate::answer::CommandAnswer;
use crate::call::Call;
use crate::laid_out::shown;
use crate::table::labelled;
use answers::{Fit, Mount};
use questions::chapter;
use questions::list::{Inquiry, Unanswered, mount, mount_project};
use words::terms;

/// `antrieb mount CODE`
pub(crate) fn alone(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    mount::found(inquiry).map(|found| text(&found, call))
}

/// `antrieb mount CODE --project FILE`
pub(crate) fn under_project(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    mount_project::found(inquiry).map(|found| text(&found, call))
}

fn text(found: &Mount, call: &Call<'_>) -> CommandAnswer {
    let chapter = chapter::mount(found, call.language);
    let assumed: String =
        found.assumptions.iter().map(|each| labelled(terms::assumed(call.language), &each.why)).collect();
    CommandAnswer::data(shown(&chapter, call.language) + &assumed).fits(found.verdict == Fit::Fits)
}
