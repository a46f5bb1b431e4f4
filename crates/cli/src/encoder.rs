//! `encoder`: signals and words of the encoders of a code.

use crate::answer::{CommandAnswer, written};
use crate::call::Call;
use crate::fault::path_text;
use crate::laid_out::with_file;
use questions::chapter;
use questions::list::{Inquiry, Unanswered, encoder, encoder_trace};

/// `antrieb encoder CODE`
pub(crate) fn encoder(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    let file = call.path("vcd");
    let trace = || call.inquiry(&encoder_trace::ENTRY).and_then(|inquiry| encoder_trace::found(&inquiry));
    let (mut record, trace) = match (encoder::found(inquiry), file.map(|_| trace()).transpose()) {
        (Ok(record), Ok(trace)) => (record, trace),
        // A fault of a shared argument occurs in both calls and is reported once.
        (Err(why), _) | (_, Err(why)) => return Err(why),
    };
    if let (Some(file), Some((code, trace))) = (file, trace) {
        let text = trace.vcd(&code.to_string());
        call.saver().save(&[(file, text.as_bytes())])?;
        record.trace = Some(path_text(file));
    }
    let text = || with_file(&chapter::encoder(&record, language), record.trace.as_deref(), language);
    let data = if call.as_json { written(&record) } else { text() };
    Ok(CommandAnswer::data(data).fits(encoder::is_right(&record)))
}
