//! CSV reader for recordings.

use crate::ahead::{Ahead, is_spaced_row};
use crate::cells::{CellSplitter, ends_empty};
use crate::clock::{Clock, is_clock, is_clock_of_unknown_form};
use crate::collected::FaultCollector;
use crate::columns::{Heading, Pick, Said, decide, pick, units_alone, unused};
use crate::csv_faults::{cell_fault, ragged, time_fault};
use crate::csv_units::{holds_number, is_row_of_values, unbracketed, unit_row};
use crate::encoding;
use crate::faults::{Fault, excerpt};
use crate::gather::{Gather, SampleUse, check_window};
use crate::layout::{Layout, Role};
use crate::limits::{COLUMNS_MAX, FILE_BYTES_MAX, Limit};
use crate::lines::Lines;
use crate::memory::Memory;
use crate::number::{Bad, Decimals, Tick, finite, plain, with_unit};
use crate::plain::{PlainRows, Written, plain_time};
use crate::series::{Encoding, KnownBy, Recording};
use crate::thousands::{Commas, RowKind, Thousands};
use crate::time_form::{TimeForm, form_of_integers};
use memchr::memchr;
use quantities::Unit;
use quantities::unit::SECOND;
use std::io::Read;

/// Reads a recording from CSV with the default memory limit.
///
/// # Errors
/// All faults of the file.
pub fn read_csv(source: impl Read, layout: &Layout) -> Result<Recording, Vec<Fault>> {
    read_csv_within(source, layout, &mut Memory::default())
}

/// Reads a recording from CSV.
///
/// The header is the line above the first rows of numbers; a row of units may stand in between. Comments (`#`), empty
/// lines, lines about the file and `sep=;` before it are skipped. The header determines the delimiter: `;`, else a tab,
/// else `,`, else `|`. With `;`, a tab, `|` or quotes the numbers may have decimal commas, either all or none. A unit stands in the
/// header (`q [deg]`), in a row of units below it, or in the layout; clock times need none and are counted from the
/// first. Columns without a role may hold any text. Only the time is read of samples outside the window. A quoted cell
/// must end in its line.
///
/// The text is UTF-8, UTF-16 or Windows-1252; [`Recording::encoding`] states which, and if it was guessed. Lines end
/// with a line feed, with or without a carriage return before it, or with a carriage return alone. The memory of the
/// recording is taken from `memory`.
///
/// # Errors
/// All faults of the file.
pub fn read_csv_within(source: impl Read, layout: &Layout, memory: &mut Memory) -> Result<Recording, Vec<Fault>> {
    let mut faults = FaultCollector::default();
    // Reading one byte beyond the limit shows that the file is larger.
    let mut source = source.take(FILE_BYTES_MAX + 1);
    let recording = read(&mut source, layout, memory, &mut faults);
    if source.limit() == 0 {
        faults = FaultCollector::default();
        faults.push(Fault::Beyond { limit: Limit::FileBytes, found: FILE_BYTES_MAX + 1, most: FILE_BYTES_MAX });
    }
    faults.outcome(recording)
}

fn read(source: impl Read, layout: &Layout, memory: &mut Memory, faults: &mut FaultCollector) -> Option<Recording> {
    check_window(layout, faults);
    let mut lines = Ahead::new(source);
    let Some(found) = lines.heading(&layout.numbered()).map_err(|fault| faults.push(fault)).ok()? else {
        faults.push(Fault::NoHeader);
        return None;
    };
    let mut more = advance(&mut lines, faults)?;
    let mut cells = CellSplitter::new(found.delimiter);
    let mut header = cells.all(lines.line(), lines.number(), faults)?;
    if found.is_missing {
        // Without names, columns are identified by their numbers only.
        if layout.time.name.as_deref().is_none_or(|name| !name.starts_with('#')) {
            faults.push(Fault::HeadingMissing { columns: header.len() });
            return None;
        }
        header.iter_mut().for_each(Vec::clear);
    }
    if let Err(fault) = Limit::Columns.hold(header.len() as u64, COLUMNS_MAX as u64) {
        faults.push(fault);
        return None;
    }
    let mut is_utf8 = std::str::from_utf8(lines.line()).is_ok();
    let mut headings: Vec<Heading> = header.iter().map(|cell| Heading::new(&encoding::text(cell))).collect();
    if !found.is_missing {
        more = advance(&mut lines, faults)?;
    }
    let second = if more { cells.all(lines.line(), lines.number(), faults) } else { None };
    // A row of values is none of units, though one of its cells may be: `Value;Unit` over `0.5;deg`.
    for (heading, cell) in headings.iter_mut().zip(second.iter().filter(|row| !is_row_of_values(row)).flatten()) {
        heading.below = Some(unbracketed(&encoding::text(cell)));
    }
    for (heading, cell) in headings.iter_mut().zip(second.iter().flatten()) {
        heading.is_clock = is_clock(&encoding::text(cell));
    }
    if second.as_deref().is_some_and(is_row_of_values)
        && let Some(columns) = units_alone(&headings, layout)
    {
        faults.push(Fault::HeadingOfUnits { columns });
        return None;
    }
    let (picks, more_time) = pick(&headings, layout, faults);

    let mut units = None;
    let mut is_table = false;
    if more {
        is_table = second.as_deref().is_some_and(holds_number);
        units = second.and_then(|row| unit_row(&row, &picks));
        if let Some(row) = &units {
            is_utf8 &= std::str::from_utf8(lines.line()).is_ok();
            if row.len() != headings.len() {
                let (line, found, expected) = (lines.number(), row.len(), headings.len());
                faults.push(Fault::Ragged { line, found, expected });
            }
        }
        // A row without numbers may be the units of columns that were not found.
        if units.is_some() || !is_table && !faults.none() {
            more = advance(&mut lines, faults)?;
        }
        if !is_table {
            is_table = more && cells.all(lines.line(), lines.number(), faults).as_deref().is_some_and(holds_number);
        }
    }
    // Text of a file that is no table is not quoted in faults: it may be a note or a key.
    if !is_table && !faults.none() {
        *faults = FaultCollector::default();
        let is_spaced = is_spaced_row(lines.line()) || lines.is_spaced();
        faults.push(if is_spaced { Fault::SpacesOnly } else { Fault::NoTable });
        return None;
    }
    if units.is_none() {
        headings.iter_mut().for_each(|heading| heading.below = None);
    }
    let first_row = if more { cells.try_all(lines.line()).unwrap_or_default() } else { Vec::new() };
    let mut columns = Vec::new();
    let mut wanted = Wanted { fields: headings.len(), named: headings.len(), ..Wanted::default() };
    if !found.is_missing {
        let blank = headings.iter().rev().take_while(|heading| heading.written.trim().is_empty());
        wanted.named -= blank.count();
    }
    for (role, picked) in Role::ALL.into_iter().zip(picks) {
        let Some(Pick { index, unit, .. }) = picked else { continue };
        let Some(heading) = headings.get(index) else { continue };
        // A column without a heading is named by its number, as a layout names it.
        let numbered = Heading { written: format!("#{}", index + 1), ..heading.clone() };
        let heading = if heading.written.is_empty() { &numbered } else { heading };
        let in_row = units.as_ref().and_then(|row| row.get(index)).filter(|text| !text.is_empty());
        let cell = first_row.get(index).map(|cell| encoding::text(cell)).unwrap_or_default();
        if role == Role::Time && is_clock(&cell) {
            wanted.form = TimeForm::Clock(Clock::default());
            let said = [(KnownBy::Values, Said::Unit(&SECOND))];
            wanted.assign(index, heading);
            columns.extend(decide(role, heading, said, faults));
            continue;
        }
        if role == Role::Time && is_clock_of_unknown_form(&cell) {
            faults.push(Fault::ClockUnknown { column: excerpt(&heading.written), text: excerpt(cell.trim()) });
            continue;
        }
        if role == Role::Time
            && let Some(form) = form_of_integers(heading, &headings)
        {
            wanted.form = form;
            wanted.assign(index, heading);
            columns.extend(decide(role, heading, [(KnownBy::Values, Said::Unit(&SECOND))], faults));
            continue;
        }
        let nanoseconds = more_time.nanoseconds.and_then(|index| Some((index, headings.get(index)?)));
        if role == Role::Time
            && let Some((other, more)) = nanoseconds
        {
            wanted.form = TimeForm::Seconds;
            let written = format!("{} + {}", heading.written, more.written);
            let both = Heading { written, ..heading.clone() };
            wanted.assign(index, heading);
            wanted.beside.push((other, excerpt(&more.written)));
            columns.extend(decide(role, &both, [(KnownBy::Header, Said::Unit(&SECOND))], faults));
            continue;
        }
        let in_cell = with_unit(&cell).map(|(_, unit)| unit);
        let said = [
            unit.map(|text| (KnownBy::Header, Said::Text(text))),
            in_row.map(|text| (KnownBy::UnitRow, Said::Text(text.clone()))),
            in_cell.map(|text| (KnownBy::Values, Said::Text(text.to_owned()))),
            layout.column(role).unit.map(|unit| (KnownBy::Layout, Said::Unit(unit))),
        ];
        let column = decide(role, heading, said.into_iter().flatten(), faults);
        wanted.assign(index, heading);
        if let Some(place) = wanted.of_cells.last_mut()
            && let Some(spelling) = in_cell
        {
            *place = column.as_ref().map(|column| (column.unit, spelling.to_owned()));
        }
        columns.extend(column);
    }
    let twins = more_time.twins.iter().filter_map(|index| Some((*index, excerpt(&headings.get(*index)?.written))));
    wanted.beside.extend(twins);
    wanted.channels = columns.len().saturating_sub(1);
    let used: Vec<usize> =
        wanted.indices.iter().copied().chain(wanted.beside.iter().map(|(index, _)| *index)).collect();
    wanted.is_open =
        found.delimiter == b',' && wanted.named < wanted.fields && used.iter().all(|index| *index < wanted.named);
    let mut unused = unused(&headings, layout, &used);
    // The index of a data frame has no heading.
    let has_value = |index: usize| first_row.get(index).is_some_and(|cell| !cell.trim_ascii().is_empty());
    if !found.is_missing
        && headings.first().is_some_and(|first| first.written.trim().is_empty())
        && has_value(0)
        && !used.contains(&0)
    {
        unused.insert(0, "#1".to_owned());
    }
    for (index, name) in std::mem::take(&mut wanted.beside) {
        wanted.indices.push(index);
        wanted.names.push(name);
    }
    // Samples have no meaning without a column or a unit.
    if !faults.none() {
        return None;
    }
    let mut gather = Gather::new(columns, layout, false, memory, faults)?;
    if !more {
        return gather.finish(faults);
    }
    // In a comma-separated file a decimal comma must be quoted.
    let commas = Commas::of(cells.delimiter, memchr(b'"', lines.line()).is_some());
    wanted.thousands = Thousands::of(commas);
    let mut decimals = if commas.may_be_decimal() { Decimals::Undecided } else { Decimals::PointAlways };
    let is_read = read_rows(&mut lines, &mut wanted, &mut cells, &mut decimals, &mut gather, faults);
    if decimals != Decimals::PointAlways
        && let Some(found) = wanted.thousands.possible(RowKind::Samples).next()
    {
        // Numbers that may be a thousand times larger make every other fault of a cell doubtful.
        *faults = FaultCollector::default();
        let column = wanted.names.get(found.column).cloned().unwrap_or_default();
        faults.push(Fault::ThousandsPossible { line: found.place, column, text: found.text.clone() });
        return None;
    }
    faults.advise(gather.remedies(is_read.is_some()));
    gather.advise_order(faults);
    wanted.end(&gather, faults);
    is_read?;
    let encoding = Some(if is_utf8 { lines.encoding() } else { Encoding::Windows1252Guessed });
    gather.finish(faults).map(|recording| Recording { encoding, unused, comments: lines.comments(), ..recording })
}

/// Reads all rows, of which the first is the current line; returns `None` after a fault that ends the reading.
fn read_rows(
    lines: &mut Ahead<impl Read>,
    wanted: &mut Wanted,
    cells: &mut CellSplitter,
    decimals: &mut Decimals,
    gather: &mut Gather<'_>,
    faults: &mut FaultCollector,
) -> Option<()> {
    let mut rows = <[PlainRows; 2]>::default();
    let mut more = true;
    while more {
        if let Err(fault) = gather.go_on() {
            *faults = FaultCollector::default();
            faults.push(fault);
            wanted.thousands = Thousands::default();
            return None;
        }
        let going_on = row(lines.line(), lines.number(), wanted, cells, decimals, gather, faults);
        if !going_on || faults.enough() {
            return None;
        }
        if let Some(sign) = decimals.sign()
            && wanted.is_certain(*decimals)
            && wanted.is_plain()
            && wanted.no_rows.is_empty()
            && wanted.blank.is_none()
            && let Some(lines) = lines.unread()
        {
            plain_rows(lines, sign, wanted, cells, &mut rows, gather, faults)?;
        }
        more = advance(lines, faults)?;
    }
    Some(())
}

/// Advances to the next line; reports a read error.
pub(crate) fn advance(lines: &mut Ahead<impl Read>, faults: &mut FaultCollector) -> Option<bool> {
    lines.advance().map_err(|fault| faults.push(fault)).ok()
}

/// The columns in use, time first.
#[derive(Default)]
struct Wanted {
    fields: usize,
    /// Number of columns without the nameless ones at the end.
    named: usize,
    /// Commas separate the cells, and the last columns have neither a name nor a role.
    is_open: bool,
    /// Rows differ from the heading in empty cells at their end, which the reader of plain rows does not allow.
    is_padded: bool,
    indices: Vec<usize>,
    names: Vec<String>,
    /// Units that every cell of a column states, as written in the first; shorter than the columns if the last ones state
    /// none.
    of_cells: Vec<Option<(&'static Unit, String)>>,
    form: TimeForm,
    /// Number of value columns, which follow the time.
    channels: usize,
    /// Additional columns of time, which come last.
    beside: Vec<(usize, String)>,
    /// Notation of the numbers read so far.
    thousands: Thousands,
    /// Faults of the lines since the last row that are no rows, and the number of these lines.
    no_rows: Vec<Fault>,
    no_rows_since: u64,
    /// Fault of the first of the rows without content before the current line.
    blank: Option<Fault>,
    /// Times have separators of thousands.
    has_grouped_times: bool,
}

impl Wanted {
    /// Adds the fault of a line that is no row; lines behind the end of the window do not matter.
    fn no_row(&mut self, fault: Fault, gather: &mut Gather<'_>, faults: &mut FaultCollector) {
        const LINES_MOST: usize = 100;
        if gather.is_over() {
            return;
        }
        gather.time_failed();
        self.no_rows_since += 1;
        self.no_rows.push(fault);
        if self.no_rows.len() > LINES_MOST {
            self.follow(faults);
        }
    }

    /// Reports the lines that are no rows, as further rows follow.
    fn follow(&mut self, faults: &mut FaultCollector) {
        self.no_rows.drain(..).for_each(|fault| faults.push(fault));
    }

    /// Reports the lines that are no rows at the end of the file: some few below many rows are a footer.
    fn end(&mut self, gather: &Gather<'_>, faults: &mut FaultCollector) {
        // The last row that could be read is not the last one of the file.
        if self.has_grouped_times {
            self.no_rows.clear();
        }
        let count = self.no_rows.len() as u64;
        if let Some(last) = gather.last_time().filter(|_| gather.may_end_in(self.no_rows_since))
            && let Some(first) = self.no_rows.first_mut()
        {
            *first = Fault::BelowRows { first: Box::new(first.clone()), count, last };
        }
        self.follow(faults);
    }

    fn assign(&mut self, index: usize, heading: &Heading) {
        self.names.push(excerpt(&heading.written));
        self.indices.push(index);
        self.of_cells.push(None);
    }

    /// Returns the number of a cell, without the unit that every cell of its column states.
    fn number<'c>(&self, place: usize, cell: &'c [u8]) -> Result<&'c [u8], Bad> {
        let Some(Some((unit, spelling))) = self.of_cells.get(place) else { return Ok(cell) };
        let cell = cell.trim_ascii();
        if cell.is_empty() {
            return Ok(cell);
        }
        let text = encoding::text(cell);
        let same = |other: &str| Unit::of_dimension(unit.dimension, other) == Some(*unit);
        // What follows the number is usually written alike in all cells.
        if let Some(number) = text.strip_suffix(spelling.as_str()).map(str::trim_ascii_end)
            && (plain(number.as_bytes(), b'.').is_some() || plain(number.as_bytes(), b',').is_some())
        {
            return Ok(cell.get(..number.len()).unwrap_or_default());
        }
        let (number, _) = with_unit(&text).filter(|(_, other)| same(other)).ok_or(Bad::OtherUnit(unit))?;
        // The characters of a number are those of its bytes.
        Ok(cell.get(..number.len()).unwrap_or_default())
    }

    /// Returns `true` if the decimal sign is beyond doubt.
    const fn is_certain(&self, decimals: Decimals) -> bool {
        decimals.is_point_for(self.thousands.commas()) || self.thousands.is_decimal()
    }

    /// Returns `true` if a row has a number without a sign below the empty end of a heading: the comma before it may stand in a number.
    fn has_more(&self, line: &[u8], cells: &mut CellSplitter) -> bool {
        let is_rest = |cell: &Vec<u8>| {
            let text = encoding::text(cell.trim_ascii());
            text.starts_with(|sign: char| sign.is_ascii_digit()) && Decimals::is_number(&text)
        };
        self.is_open && cells.try_all(line).is_some_and(|all| all.iter().skip(self.named).any(is_rest))
    }

    /// Returns `true` if a row consists of the time and the values, all plain numbers.
    fn is_plain(&self) -> bool {
        !self.is_padded
            && !self.is_open
            && self.of_cells.iter().all(Option::is_none)
            && matches!(self.form, TimeForm::Number)
            && self.indices.len() == self.channels + 1
    }
}

/// Number of bytes tried first for rows of plain numbers; twice as many after each success. Few rows are then read in vain
/// where other rows stand among them.
const BYTES_FIRST: usize = 1 << 12;

/// Reads the following rows of plain numbers; returns `None` if no further row can be kept.
fn plain_rows(
    lines: &mut Lines<impl Read>,
    sign: u8,
    wanted: &Wanted,
    cells: &mut CellSplitter,
    rows: &mut [PlainRows; 2],
    gather: &mut Gather<'_>,
    faults: &mut FaultCollector,
) -> Option<()> {
    let mut most = BYTES_FIRST;
    loop {
        let (before, end) = (lines.number(), lines.ending());
        let written = Written { delimiter: cells.delimiter, sign, end, fields: wanted.fields, wanted: &wanted.indices };
        let text = written.first(lines.whole(), most);
        written.read(text, rows);
        let numbers = rows.iter().flat_map(|rows| rows.numbers.chunks_exact(wanted.indices.len().max(1)));
        // Lines are needed only for faults and are visited once each.
        let (mut texts, mut looked_at) = (text.split(|byte| *byte == end), 0);
        let mut count = 0;
        for (number, row) in (before + 1..).zip(numbers) {
            let [time, values @ ..] = row else { continue };
            count += 1;
            let mut line = None;
            match gather.sample(number, Tick::of_float(*time), faults) {
                SampleUse::Kept => {}
                SampleUse::Dropped if faults.enough() => return None,
                SampleUse::Dropped => continue,
                SampleUse::Full => return None,
            }
            for (channel, value) in values.iter().enumerate() {
                if let Err(bad) = gather.value(channel, *value) {
                    let line = *line.get_or_insert_with(|| {
                        let ahead = count - std::mem::replace(&mut looked_at, count);
                        texts.nth(ahead - 1).unwrap_or_default()
                    });
                    cells.split(line, &wanted.indices);
                    let found = wanted.names.iter().zip(cells.found(line)).nth(channel + 1);
                    if let Some((name, cell)) = found {
                        faults.push(cell_fault(bad, number, name, cell));
                    }
                }
            }
            if faults.enough() {
                return None;
            }
        }
        let (bytes, all) = (rows.iter().map(|rows| rows.bytes).sum(), text.len());
        lines.pass(bytes, count as u64);
        if bytes < all || bytes == 0 || gather.go_on().is_err() {
            return Some(());
        }
        most = most.saturating_mul(2);
    }
}

/// Reads one row; returns `false` if no further row can be kept.
fn row(
    line: &[u8],
    number: u64,
    wanted: &mut Wanted,
    cells: &mut CellSplitter,
    decimals: &mut Decimals,
    gather: &mut Gather<'_>,
    faults: &mut FaultCollector,
) -> bool {
    let Some(count) = cells.split(line, &wanted.indices) else {
        wanted.no_row(Fault::QuoteOpen { line: number }, gather, faults);
        return true;
    };
    // Rows without content end the export of a range of a spreadsheet; among others the values are missing.
    if line.iter().all(|byte| *byte == cells.delimiter || byte.is_ascii_whitespace()) {
        let column = wanted.names.first().cloned().unwrap_or_default();
        let _ = wanted.blank.get_or_insert(Fault::ValueMissing { at: crate::FileRow::Line(number), column });
        return true;
    }
    if let Some(fault) = wanted.blank.take() {
        wanted.no_row(fault, gather, faults);
    }
    // The last line of a scope.
    if count == 1 && wanted.fields > 1 && line.trim_ascii() == b"EOF" {
        return true;
    }
    if count != wanted.fields && is_padded(line, count, wanted, cells.delimiter) {
        wanted.is_padded = true;
    } else if count != wanted.fields {
        let (found, expected) = (count, wanted.fields);
        let may_be_twice = *decimals == Decimals::PointAlways && (found == 2 * expected || gather.is_empty());
        wanted.no_row(ragged(line, (number, found, expected), may_be_twice), gather, faults);
        return true;
    }
    if wanted.is_open {
        if wanted.has_more(line, cells) {
            let (found, expected) = (count, wanted.named);
            wanted.no_row(Fault::CommasTwice { line: number, found, expected }, gather, faults);
            return true;
        }
        let _ = cells.split(line, &wanted.indices);
    }
    if !wanted.is_certain(*decimals) {
        for (column, cell) in cells.found(line).enumerate() {
            let bare = wanted.number(column, cell).unwrap_or(cell);
            let text = encoding::text(bare);
            wanted.thousands.note(column, &text, number);
        }
    }
    let mut read = wanted.names.iter().zip(cells.found(line));
    let Some((name, cell)) = read.next() else { return false };
    let behind = 1 + wanted.channels;
    let bare = wanted.number(0, cell);
    let tick = match &mut wanted.form {
        TimeForm::Number => bare.and_then(|bare| {
            let quick = decimals.sign().and_then(|sign| plain_time(bare, sign)).map(Tick::of_float);
            quick.map_or_else(|| decimals.plain(bare, number).and_then(|text| Tick::read(&text)), Ok)
        }),
        TimeForm::Clock(clock) => clock.tick(&encoding::text(cell)).ok_or(Bad::Unreadable),
        TimeForm::MillionthsOfDay => {
            let tick = decimals.plain(cell, number).and_then(|text| Tick::read(&text));
            tick.map(Tick::of_millionths_of_day)
        }
        TimeForm::HundredsOfNanoseconds => {
            let tick = decimals.plain(cell, number).and_then(|text| Tick::read(&text));
            tick.map(Tick::of_hundreds_of_nanoseconds)
        }
        TimeForm::Seconds => {
            let more = cells.found(line).nth(behind).unwrap_or_default();
            let whole = decimals.plain(cell, number).and_then(|text| Tick::read(&text));
            let more = decimals.plain(more, number).and_then(|text| finite(&text));
            let more = more.and_then(|more| if (0.0..1e9).contains(&more) { Ok(more) } else { Err(Bad::Unreadable) });
            whole.and_then(|whole| more.map(|more| whole.later(1e-9 * more)))
        }
    };
    let first = behind + usize::from(matches!(wanted.form, TimeForm::Seconds));
    for (place, other) in cells.found(line).enumerate().skip(first) {
        if other.trim_ascii() != cell.trim_ascii() {
            let at = crate::FileRow::Line(number);
            let numbers = [0, place].map(|place| wanted.indices.get(place).map_or(0, |index| index + 1));
            faults.push(Fault::TimesDiffer { at, column: name.clone(), numbers });
            gather.time_failed();
            return true;
        }
    }
    if tick.is_ok() {
        wanted.no_rows.drain(..).for_each(|fault| faults.push(fault));
        wanted.no_rows_since = 0;
    }
    match tick {
        Err(bad) => {
            let fault = time_fault(bad, number, name, cell);
            // A number with separators of thousands belongs to a row, however many of them end the file.
            if matches!(fault, Fault::ThousandsGrouped { .. }) {
                if !gather.is_over() {
                    gather.time_failed();
                    wanted.has_grouped_times = true;
                    faults.push(fault);
                }
            } else {
                wanted.no_row(fault, gather, faults);
            }
            return true;
        }
        Ok(tick) => match gather.sample(number, tick, faults) {
            SampleUse::Kept => {}
            SampleUse::Dropped => return true,
            SampleUse::Full => return false,
        },
    }
    for (channel, (name, cell)) in read.take(wanted.channels).enumerate() {
        let value = wanted.number(channel + 1, cell).and_then(|bare| {
            let quick = decimals.sign().and_then(|sign| plain(bare, sign));
            quick.map_or_else(|| decimals.plain(bare, number).and_then(|text| finite(&text)), Ok)
        });
        match value {
            Ok(value) => {
                if let Err(bad) = gather.value(channel, value) {
                    faults.push(cell_fault(bad, number, name, cell));
                }
            }
            Err(bad) => {
                gather.lacks(channel);
                faults.push(cell_fault(bad, number, name, cell));
            }
        }
    }
    true
}

/// Returns `true` if a row differs from the heading in empty cells at its end only.
fn is_padded(line: &[u8], count: usize, wanted: &Wanted, delimiter: u8) -> bool {
    let Some(more) = count.checked_sub(wanted.fields) else { return count >= wanted.named };
    ends_empty(line, more, delimiter)
}
