//! The resulting motion as text, and its setpoints as a table.

use crate::answer::{CommandAnswer, written};
use crate::call::Call;
use crate::command::typed::typed;
use crate::fault::path_text;
use crate::reserve::assumptions_of_motion;
use crate::table::{Align, TextTable, labelled};
use axis::SegmentLoadKey;
use quantities::unit::SECOND;
use quantities::{Language, Measure, Time, format_significant};
use questions::list::{Cost, Inquiry, Unanswered, moves};
use questions::texts::recording_text;
use questions::{Moves, answer};
use tables::Format;
use words::{law_text, segment_load, terminal, terms, unpadded};

/// Number of segments shown; --json has all of them.
const SEGMENTS_MOST: usize = 12;

/// `antrieb moves PROJECT [--every TIME [--out FILE]]`
pub(crate) fn moves(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    let args = moves::Args::read(&inquiry.given)?;
    let file = call.path("out");
    let ending = || Unanswered::option("out", (terminal::ending_of_setpoints(language).to_owned(), None));
    let is_table = |format: &Format| matches!(format, Format::Csv | Format::Parquet);
    let format = file.map(|file| Format::of(file).filter(is_table).ok_or_else(ending)).transpose()?;
    let saver = call.saver();
    if let Some(file) = file {
        saver.ready(&[file])?;
    }
    let (_, project) = inquiry.axis(args.axis.as_deref(), Cost::Other)?;
    let found = questions::moves(&project);
    let Some(setpoints) = args.setpoints(&project, inquiry)? else {
        let named = call.path("project").map(path_text).filter(|name| name != "-");
        let setpoints = named.map(|name| {
            let of_axis = args.axis.iter().flat_map(|axis| ["--axis", axis.as_str()]);
            let head = ["antrieb", "moves", name.as_str()].into_iter();
            let call = typed(head.chain(of_axis).chain(["--every", "2ms", "--out", "setpoints.csv"]));
            format!("\n{}\n", terminal::setpoints_call(&call, language))
        });
        let assumed = assumptions_of_motion(&project, language);
        return Ok(CommandAnswer::data(text(&found, language) + &assumed + &setpoints.unwrap_or_default()));
    };
    let table = tables::setpoints(&setpoints, language);
    let ms = |time: Time| unpadded(time.si() * 1e3, 6, language);
    let rest = setpoints.rest.map(|rest| {
        let cycle = unpadded(project.axis.motion.duration().si(), 6, language);
        format!("{}\n", terminal::setpoints_rest(&cycle, &ms(setpoints.every), &ms(rest), language))
    });
    let talk = assumptions_of_motion(&project, language) + &rest.unwrap_or_default();
    let (Some(file), Some(format)) = (file, format) else {
        return Ok(CommandAnswer { talk, ..CommandAnswer::data(tables::csv(&table)) });
    };
    let bytes = match format {
        Format::Parquet => tables::parquet(&table).map_err(|error| Unanswered::message(error.message(language)))?,
        Format::Csv | Format::Json | Format::Workbook => tables::csv(&table).into_bytes(),
    };
    saver.save(&[(file, &bytes)])?;
    let data = if call.as_json {
        let record = answer::setpoints(&setpoints, Some(path_text(file)));
        written(&answer::motion_of(&project, Some(record), language))
    } else {
        let rows = setpoints.rows.len();
        format!("{}\n", terminal::setpoints_written(&path_text(file), &rows, &ms(setpoints.every), language))
    };
    Ok(CommandAnswer { talk, ..CommandAnswer::data(data) })
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
