//! Angular errors of the selected actuator as a table with their sum and its limit.

use crate::checks::bar;
use maud::{Markup, html};
use quantities::unit::ARCMINUTE;
use quantities::{Angle, Language, Measure, format_significant};
use questions::{Candidate, angular_errors};
use words::{capitalised, page, terms};

/// Returns the table; empty if the check of the error budget could not be made.
pub(crate) fn table(candidate: &Candidate<'_>, language: Language) -> Markup {
    let l = language;
    let Some(found) = angular_errors(candidate, l) else { return html! {} };
    let shown = |angle: Angle| format_significant(ARCMINUTE.from_si(angle.si()), 3, l);
    html! {
        table.errors {
            caption.unseen { (page::angular_errors(l)) }
            thead { tr {
                th scope="col" { (page::angular_error(l)) }
                th.number scope="col" { "φ " span.unit { (ARCMINUTE.symbol_in(l)) } }
                th scope="col" { (page::share_of_the_sum(l)) }
                th scope="col" { (capitalised(terms::source(l))) }
            } }
            tbody {
                @for error in &found.errors { tr class=[error.known.is_none().then_some("unchecked")] {
                    th scope="row" { (capitalised(&error.name)) }
                    @match &error.known {
                        Some((angle, source)) => { td.number { (shown(*angle)) } td { (bar(error.share, None)) } td.small { (source) } },
                        None => td colspan="3" { (page::error_not_known(l)) },
                    }
                } }
            }
            tfoot {
                tr { th scope="row" { (page::sum_of_errors(l)) } td.number { strong { (shown(found.sum)) } } td colspan="2" {} }
                tr { th scope="row" { (page::root_of_errors(l)) } td.number { (shown(found.root_sum_square)) } td colspan="2" {} }
            }
        }
    }
}
