//! `wiring`: connectors, pins and cables, and their comparison with a list of pins.

use crate::answer::CommandAnswer;
use crate::call::Call;
use crate::command::typed::typed;
use crate::laid_out::shown;
use crate::plot;
use crate::table::{Align, TextTable};
use answers::WiringCheck;
use quantities::Language;
use questions::chapter;
use questions::list::wiring::Role;
use questions::list::{Inquiry, Unanswered, wiring_check};
use std::fmt::Write as _;
use words::wiring;

/// Servo drive of the example of `commission`.
const DRIVE: &str = "sinamics";

/// `antrieb wiring CODE`
pub(crate) fn wiring(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    let (found, record) = questions::list::wiring::found(inquiry)?;
    if plot::is_asked(call) {
        return draw(&found, call);
    }
    let pins = shown(&chapter::wiring(&record, Vec::new(), language), language);
    let call = typed(["antrieb", "commission", &record.code, "--for", DRIVE]);
    Ok(CommandAnswer::data(format!("{pins}\n{}:\n  {call}\n", wiring::drive_values(language))))
}

fn draw(found: &questions::list::wiring::CodeWiring, call: &Call<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    let wanted = call.text("connector").unwrap_or(Role::Feedback.id());
    let Some(connector) = found.connectors.iter().find(|connector| connector.role.id() == wanted) else {
        let roles: Vec<&str> = found.connectors.iter().map(|connector| connector.role.id()).collect();
        let what = wiring::no_such_connector(&found.code, &roles.join(", "), language);
        return Err(Unanswered::option("connector", (what, None)));
    };
    if connector.pins.is_empty() {
        return Err(Unanswered::message(wiring::no_pins_to_draw(language)));
    }
    plot::destination(call, None)?;
    plot::draw(&figures::mating_face(&found.code, connector, figures::PinTexts::Full, language), call)
}

/// `antrieb wiring CODE --check FILE`
pub(crate) fn check(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    if plot::is_asked(call) {
        return Err(Unanswered::message(wiring::check_or_draw(language)));
    }
    let record = wiring_check::found(inquiry)?;
    let name = inquiry.source()?.name.as_str();
    Ok(CommandAnswer::data(check_text(&record, name, language)).fits(record.agrees))
}

fn check_text(record: &WiringCheck, name: &str, language: Language) -> String {
    let mut out = format!("{}, {name}\n", record.code);
    let counted = if record.agreeing == record.rows {
        wiring::agrees(&record.rows, language)
    } else {
        wiring::differs(&record.agreeing, &record.rows, language)
    };
    let _ = writeln!(out, "{counted}");
    if record.findings.is_empty() {
        return out;
    }
    out.push('\n');
    let mut table = TextTable::new([
        (wiring::line(language), Align::Right),
        (wiring::severity(language), Align::Left),
        (wiring::connector(language), Align::Left),
        (wiring::pin(language), Align::Left),
        (wiring::finding(language), Align::Left),
    ]);
    for finding in &record.findings {
        table.row([
            finding.line.map_or_else(|| "–".into(), |line| line.to_string()),
            wiring::severity_word(*finding.severity, language).to_owned(),
            finding.connector.id().to_owned(),
            finding.pin.clone().unwrap_or_else(|| "–".into()),
            format!("{}; {}", finding.message, finding.action),
        ]);
    }
    out.push_str(&table.render());
    out
}
