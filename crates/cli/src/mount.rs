//! `mount`: mounting of an actuator.

use crate::answer::Answer;
use crate::call::Call;
use crate::laid_out::shown;
use answers::{Fit, Mount};
use questions::chapter;
use questions::list::{Asked, Unanswered, mount, mount_project};

/// `antrieb mount CODE`
pub(crate) fn alone(call: &Call<'_>, asked: &Asked<'_>) -> Result<Answer, Unanswered> {
    mount::found(asked).map(|found| text(&found, call))
}

/// `antrieb mount CODE --project FILE`
pub(crate) fn under_project(call: &Call<'_>, asked: &Asked<'_>) -> Result<Answer, Unanswered> {
    mount_project::found(asked).map(|found| text(&found, call))
}

fn text(found: &Mount, call: &Call<'_>) -> Answer {
    let chapter = chapter::mount(found, call.language);
    Answer::data(shown(&chapter, call.language)).fits(found.verdict == Fit::Fits)
}
