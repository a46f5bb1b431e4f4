//! Long work: its progress, its end, and the page after a timeout or cancellation.

use crate::call::{Call, Reply, Shell};
use crate::markup::vals;
use maud::{Markup, html};
use quantities::{Language, format_number};
use questions::answer::refusal_text;
use questions::{Progress, Refusal};
use words::{capitalised, page, requests, terminal};

/// Returns the place that shows the progress of a long work, with a button to cancel it.
pub(crate) fn place(language: Language) -> Markup {
    html! {
        div id="busy" hidden {
            output id="busy-text" data-usual=(capitalised(terminal::calculating(language))) { (capitalised(terminal::calculating(language))) }
            " " button type="button" data-cancel="" { (page::cancel(language)) }
        }
    }
}

/// Returns the progress of a work as text.
pub(crate) fn progress(call: &Call<'_>, shell: &dyn Shell) -> Reply {
    let l = call.language();
    let work = call.field("work").unwrap_or_default();
    match shell.progress(&work) {
        None => Reply::text(404, ""),
        Some((done, Some(all))) if done <= all => {
            #[allow(clippy::cast_precision_loss, reason = "at most some millions")]
            let share = format_number(100.0 * done as f64 / all as f64, 0, l);
            Reply::text(200, &capitalised(&terminal::calculating_share(&share, l)))
        }
        Some(_) => Reply::text(200, &capitalised(terminal::calculating(l))),
    }
}

/// Cancels a work.
pub(crate) fn cancelled(call: &Call<'_>, shell: &dyn Shell) -> Reply {
    let work = call.field("work").unwrap_or_default();
    let status = if shell.cancel(&work) { 200 } else { 404 };
    Reply::text(status, "")
}

/// Returns the reason why the last change has no result, and a way to repeat the request if that may help; `before`
/// means that an older result is shown.
pub(crate) fn stopped(
    refusal: &Refusal,
    before: bool,
    again: Option<&str>,
    shell: &dyn Shell,
    progress: &Progress,
    language: Language,
) -> Markup {
    let is_stopped = *refusal == Refusal::Stopped;
    let why = match shell.time_limit().filter(|_| progress.is_late()) {
        _ if !is_stopped => refusal_text(refusal, None, language),
        Some(limit) => requests::not_in_time(&limit.as_secs(), language),
        None => page::was_cancelled(language).to_owned(),
    };
    html! {
        (capitalised(&why)) ". " @if before { (page::result_before(language)) " " }
        @if let Some(path) = again.filter(|_| is_stopped) {
            button.small type="button" id="again" hx-post=(path) hx-vals=(vals(&[])) { (page::compute_again(language)) }
        }
    }
}
