//! `code parse|list|complete`.

use crate::answer::CommandAnswer;
use crate::call::Call;
use crate::table::{Align, TextTable, paragraph};
use order_code::OrderCode;
use quantities::Language;
use questions::list::code_list::Availability;
use questions::list::code_parse::uncovered;
use questions::list::{Inquiry, Unanswered, code_complete, code_list, code_parse};
use std::fmt::Write as _;
use words::{describe_field, describe_uncovered, terminal, terms};

/// `antrieb code parse CODE`
pub(crate) fn parse(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    let reading = code_parse::reading(inquiry)?;
    let mut data = format!("{}\n", reading.parsed.code);
    let state = if reading.availability.is_available() {
        terminal::available(language).to_owned()
    } else {
        let fields: Vec<&str> =
            reading.availability.on_request.iter().map(|field| describe_field(*field, language)).collect();
        format!("{}: {}", terms::on_request(language), fields.join(", "))
    };
    let _ = writeln!(data, "{state}\n");
    let (field, token, meaning) = (terminal::field(language), terminal::token(language), terminal::meaning(language));
    let mut table = TextTable::new([(field, Align::Left), (token, Align::Left), (meaning, Align::Left)]);
    for (each, token, meaning) in questions::list::code_parse::explain_code(&reading.parsed.code, language) {
        let token = if token.is_empty() { "–".to_owned() } else { token };
        table.row([describe_field(each, language).to_owned(), token, meaning]);
    }
    data.push_str(&table.render());
    for (index, what) in uncovered(&reading.parsed.code).into_iter().enumerate() {
        if index == 0 {
            data.push('\n');
        }
        data.push_str(&paragraph("", &describe_uncovered(what, language)));
    }
    Ok(CommandAnswer::data(data))
}

/// `antrieb code list [PATTERN]`
pub(crate) fn list(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    let codes = code_list::Args::read(&inquiry.given)?.codes();
    let available = codes.iter().filter(|(_, found)| found.is_available()).count();
    let talk = terminal::codes_counted(&codes.len(), &available, &(codes.len() - available), language) + "\n";
    Ok(CommandAnswer { talk, ..CommandAnswer::data(listed(&codes, language)) }.fits(!codes.is_empty()))
}

/// Lists codes, a line each; those available on request only are marked.
fn listed(codes: &[&(OrderCode, Availability)], language: Language) -> String {
    let line = |(code, found): &&(OrderCode, Availability)| {
        if found.is_available() { format!("{code}\n") } else { format!("{code}\t{}\n", terms::on_request(language)) }
    };
    codes.iter().map(line).collect()
}

/// `antrieb code complete CODE`
pub(crate) fn complete(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    let pattern = code_complete::pattern_of(&inquiry.given)?;
    let codes = questions::list::code_list::list_codes(Some(&pattern));
    let choices = questions::list::code_complete::completion(&pattern, language);
    let (field, may) = (terminal::field(language), terminal::may_be(language));
    let none = terminal::nothing(language);
    let mut table = TextTable::new([(field, Align::Left), (may, Align::Left)]);
    for (_, name, found) in &choices {
        let tokens: Vec<String> = found
            .iter()
            .map(|choice| {
                let token = if choice.token.is_empty() { none } else { choice.token };
                if choice.available { token.to_owned() } else { format!("{token} ○") }
            })
            .collect();
        table.row([(*name).to_owned(), tokens.join(", ")]);
    }
    let data = format!("{}\n{}", table.render(), listed(&codes, language));
    let talk = terminal::codes(codes.len(), language) + "\n";
    Ok(CommandAnswer { talk, ..CommandAnswer::data(data) }.fits(!codes.is_empty()))
}
