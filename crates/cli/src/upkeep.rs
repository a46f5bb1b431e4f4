//! `upkeep`: maintenance of an actuator with its dates.

use crate::answer::{CommandAnswer, written};
use crate::call::Call;
use crate::fault::path_text;
use crate::laid_out::with_file;
use answers::Fit;
use questions::chapter;
use questions::list::{Inquiry, Unanswered};
use words::upkeep;

/// `antrieb upkeep CODE --delivered DATE`
pub(crate) fn upkeep(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    let file = call.path("ical");
    let wrong = file.filter(|file| file.extension().is_none_or(|ending| !ending.eq_ignore_ascii_case("ics")));
    let wrong =
        wrong.map(|file| Unanswered::option("ical", (upkeep::calendar_is_an_ics(&path_text(file), language), None)));
    let found = questions::list::upkeep::found(inquiry);
    let (plan, mut record) = match (found, wrong) {
        (Ok(found), None) => found,
        (Ok(_), Some(wrong)) | (Err(wrong), None) => return Err(wrong),
        (Err(why), Some(wrong)) => return Err(Unanswered::combined(vec![why, wrong])),
    };
    let name = call.label("name")?;
    if let Some(file) = file {
        let bytes = tables::calendar(&plan, &record, name.as_deref(), language);
        call.saver().save(&[(file, bytes.as_bytes())])?;
        record.calendar = Some(path_text(file));
    }
    let text = || with_file(&chapter::upkeep(&record, language), record.calendar.as_deref(), language);
    let data = if call.as_json { written(&record) } else { text() };
    Ok(CommandAnswer::data(data).fits(record.verdict == Fit::Fits))
}
