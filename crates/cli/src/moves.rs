//! The resulting motion as text.

use crate::answer::CommandAnswer;
use crate::call::Call;
use crate::table::{Align, TextTable, labelled};
use axis::SegmentLoadKey;
use quantities::unit::SECOND;
use quantities::{Language, Measure, format_significant};
use questions::Moves;
use questions::list::{Cost, Inquiry, Unanswered, moves};
use questions::texts::recording_text;
use words::{law_text, segment_load, terminal, terms};

/// Number of segments shown; --json has all of them.
const SEGMENTS_MOST: usize = 12;

/// `antrieb moves PROJECT`
pub(crate) fn moves(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    let args = moves::Args::read(&inquiry.given)?;
    let (_, project) = inquiry.axis(args.axis.as_deref(), Cost::Other)?;
    Ok(CommandAnswer::data(text(&questions::moves(&project), language)))
}

/// Returns every segment with its stated and its computed values.
pub(crate) fn text(moves: &Moves<'_>, language: Language) -> String {
    let [distance, speed, acceleration] = moves.units.map(|unit| unit.symbol_in(language));
    let speed_word = if moves.turns { terms::rotary_speed(language) } else { terms::linear_speed(language) };
    let mut table = TextTable::new([
        (terminal::segment_of_motion(language).to_owned(), Align::Right),
        (terms::law(language).to_owned(), Align::Left),
        (terminal::from_s(language).to_owned(), Align::Right),
        (terminal::time_s(language).to_owned(), Align::Right),
        (format!("{} {distance}", terms::distance(language)), Align::Right),
        (format!("{speed_word} {speed}"), Align::Right),
        (format!("{} {acceleration}", terms::acceleration(language)), Align::Right),
    ]);
    for (index, each) in moves.moves.iter().enumerate().take(SEGMENTS_MOST) {
        let cells = match each.course {
            Some([s, v, a]) => {
                let [distance, speed, acceleration] = moves.units;
                [(distance, s), (speed, v), (acceleration, a)].map(|(unit, si)| unit.figure(si, 4, language))
            }
            None => ["–", "–", "–"].map(str::to_owned),
        };
        let [distance, speed, acceleration] = cells;
        let time = |si: f64| SECOND.figure(si, 4, language);
        let (start, duration) = (time(each.start.si()), time(each.duration.si()));
        let law = law_text(each.law, language).to_owned();
        table.row([(index + 1).to_string(), law, start, duration, distance, speed, acceleration]);
    }
    let mut out = table.render();
    let more = moves.moves.len().saturating_sub(SEGMENTS_MOST);
    if more > 0 {
        out.push_str(&format!("{}\n", terminal::more_segments(&more, language)));
    }
    out.push_str(&loads(moves, language));
    for read in moves.moves.iter().filter_map(|each| each.recording) {
        let what = recording_text(read, language);
        out.push_str(&labelled(terms::recording(language), &what));
    }
    out
}

/// Returns the loads of every segment as they act, if a segment states one.
fn loads(moves: &Moves<'_>, language: Language) -> String {
    if moves.loads.is_empty() {
        return String::new();
    }
    let title = |load: &SegmentLoadKey| {
        (format!("{} {}", segment_load(*load, language), load.unit().symbol_in(language)), Align::Right)
    };
    let segment = (terminal::segment_of_motion(language).to_owned(), Align::Right);
    let mut table = TextTable::new(std::iter::once(segment).chain(moves.loads.iter().map(title)));
    for (number, each) in (1_usize..).zip(&moves.moves).take(SEGMENTS_MOST) {
        let value = |(load, si): (&SegmentLoadKey, &f64)| format_significant(load.unit().from_si(*si), 4, language);
        let values = moves.loads.iter().zip(&each.loads).map(value);
        table.row(std::iter::once(number.to_string()).chain(values).collect::<Vec<String>>());
    }
    format!("\n{}", table.render())
}
