//! Parser of a user's pin list in CSV.

use super::Role;
use super::signal::plain;
use std::collections::BTreeMap;
use std::ops::Range;

/// Length limit of a list \[bytes\].
pub const LISTED_BYTES_MAX: usize = 1 << 20;

/// Largest number of faults reported per list.
const FAULTS_MAX: usize = 50;

/// A user's list of pins.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PinList {
    /// Pins in the order of the file.
    pub pins: Vec<ListedPin>,
}

/// A row of the list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ListedPin {
    /// Line of the file, from 1.
    pub line: usize,
    /// Role of the connector.
    pub role: Role,
    /// Text of the pin.
    pub pin: String,
    /// Text of the signal.
    pub signal: String,
    /// Text of the colour; `None` if the list lacks the column or the cell is empty.
    pub colour: Option<String>,
    /// Shielding of the wire, if the list states it.
    pub shield: Option<bool>,
}

/// A column of the list.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum PinColumn {
    /// Connector of the row.
    Connector,
    /// Pin of the connector.
    Pin,
    /// Signal on the pin.
    Signal,
    /// Colour of the wire.
    Colour,
    /// Shielding of the wire.
    Shield,
}

impl PinColumn {
    /// The columns, mandatory ones first.
    pub const ALL: &'static [Self] = &[Self::Connector, Self::Pin, Self::Signal, Self::Colour, Self::Shield];

    /// Returns the accepted headings in plain spelling; the first one is the English heading of the documentation.
    #[must_use]
    pub const fn heads(self) -> &'static [&'static str] {
        match self {
            Self::Connector => &["CONNECTOR", "STECKER", "STECKVERBINDER", "ROLE", "PLUG"],
            Self::Pin => &["PIN", "STIFT", "STECKERSTIFT", "KONTAKT", "CONTACT", "PINNO"],
            Self::Signal => &["SIGNAL", "MOTORPHASE", "FUNCTION", "FUNKTION"],
            Self::Colour => &["COLOUR", "COLOR", "FARBE", "ADERFARBE", "WIRECOLOUR"],
            Self::Shield => &["SHIELD", "SCHIRM", "SHIELDED", "GESCHIRMT"],
        }
    }

    const fn is_needed(self) -> bool {
        matches!(self, Self::Connector | Self::Pin | Self::Signal)
    }
}

/// Fault of a list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ListFault {
    /// The list has only white space and comments.
    Empty,
    /// A mandatory column is missing.
    ColumnMissing {
        /// Missing column.
        column: PinColumn,
        /// Headings found.
        found: Vec<String>,
    },
    /// Two headings name the same column.
    ColumnTwice {
        /// Repeated column.
        column: PinColumn,
        /// Bytes of the second heading.
        span: Range<usize>,
    },
    /// A heading names no column.
    ColumnUnknown {
        /// Text of the heading.
        head: String,
        /// Bytes of the heading.
        span: Range<usize>,
    },
    /// A row differs from the header in its number of cells.
    Ragged {
        /// Bytes of the row.
        span: Range<usize>,
        /// Number of cells of the row.
        found: usize,
        /// Number of cells of the header.
        expected: usize,
    },
    /// A mandatory cell is empty.
    CellEmpty {
        /// Column of the cell.
        column: PinColumn,
        /// Bytes of the row.
        span: Range<usize>,
    },
    /// No actuator has the connector.
    ConnectorUnknown {
        /// Text of the connector.
        written: String,
        /// Bytes of the cell.
        span: Range<usize>,
    },
    /// The shielding is neither stated nor denied.
    ShieldUnclear {
        /// Text of the cell.
        written: String,
        /// Bytes of the cell.
        span: Range<usize>,
    },
    /// The list has a header but no row.
    NoRows,
    /// Further faults are not reported.
    More,
}

impl ListFault {
    /// Returns the identifier used in data exchange.
    #[must_use]
    pub const fn id(&self) -> &'static str {
        match self {
            Self::Empty | Self::NoRows => "pin_list_empty",
            Self::ColumnMissing { .. } => "pin_list_column_missing",
            Self::ColumnTwice { .. } => "pin_list_column_twice",
            Self::ColumnUnknown { .. } => "pin_list_column_unknown",
            Self::Ragged { .. } => "pin_list_ragged",
            Self::CellEmpty { .. } => "pin_list_cell_empty",
            Self::ConnectorUnknown { .. } => "pin_list_connector_unknown",
            Self::ShieldUnclear { .. } => "pin_list_shield_unclear",
            Self::More => "pin_list_more",
        }
    }

    /// Returns the byte range of the fault; the beginning of the text for a fault of the whole list.
    #[must_use]
    pub fn span(&self) -> Range<usize> {
        match self {
            Self::Empty | Self::NoRows | Self::ColumnMissing { .. } | Self::More => 0..0,
            Self::ColumnTwice { span, .. }
            | Self::ColumnUnknown { span, .. }
            | Self::Ragged { span, .. }
            | Self::CellEmpty { span, .. }
            | Self::ConnectorUnknown { span, .. }
            | Self::ShieldUnclear { span, .. } => span.clone(),
        }
    }
}

/// Returns the delimiter of the cells: `;`, else a tab, else `,`, from the first line that is not empty or a comment.
fn delimiter(text: &str) -> u8 {
    let says = |line: &&str| !line.trim().is_empty() && !line.trim_start().starts_with('#');
    let header = text.lines().find(says).unwrap_or_default();
    [b';', b'\t'].into_iter().find(|sign| header.as_bytes().contains(sign)).unwrap_or(b',')
}

/// Returns the role of a connector from a common name in plain spelling.
pub(super) fn role_of(text: &str) -> Option<Role> {
    match plain(text).replace('-', "").as_str() {
        "MOTOR" | "MOTORCONNECTOR" | "MOTORSTECKER" | "POWER" | "LEISTUNG" | "LEISTUNGSSTECKER" => Some(Role::Motor),
        "FEEDBACK" | "ENCODER" | "MOTORFEEDBACK" | "GEBER" | "MOTORGEBER" | "ENCODERSTECKER" | "GEBERSTECKER" => {
            Some(Role::Feedback)
        }
        "OUTPUTENCODER" | "EC" | "OPTIONEC" | "ABTRIEBSGEBER" | "GEBERAMABTRIEB" => Some(Role::OutputEncoder),
        _ => None,
    }
}

fn shield_of(text: &str) -> Option<bool> {
    match plain(text).as_str() {
        "YES" | "Y" | "JA" | "J" | "X" | "1" | "TRUE" | "SHIELDED" | "GESCHIRMT" => Some(true),
        "NO" | "N" | "NEIN" | "0" | "FALSE" | "-" | "UNSHIELDED" | "UNGESCHIRMT" => Some(false),
        _ => None,
    }
}

/// Parses a list of pins. The header names the columns in English or German; lines that begin with `#` are comments.
///
/// # Errors
/// Returns the faults of the list.
pub fn read_pin_list(text: &str) -> Result<PinList, Vec<ListFault>> {
    let mut reader = csv::ReaderBuilder::new()
        .delimiter(delimiter(text))
        .has_headers(false)
        .flexible(true)
        .trim(csv::Trim::All)
        .comment(Some(b'#'))
        .from_reader(text.as_bytes());
    let mut faults = Vec::new();
    let mut header: Option<Header> = None;
    let mut pins = Vec::new();
    let mut record = csv::StringRecord::new();
    // Reading cannot fail: the text is UTF-8 and the number of cells is flexible.
    while reader.read_record(&mut record).unwrap_or(false) {
        if record.iter().all(str::is_empty) {
            continue;
        }
        let row = Row::new(text, &record);
        match &header {
            None => header = Some(Header::read(&row, &mut faults)),
            Some(header) => pins.extend(listed(&row, header, &mut faults)),
        }
        if faults.len() > FAULTS_MAX {
            faults.truncate(FAULTS_MAX);
            faults.push(ListFault::More);
            return Err(faults);
        }
    }
    match header {
        None => faults.push(ListFault::Empty),
        Some(_) if pins.is_empty() && faults.is_empty() => faults.push(ListFault::NoRows),
        Some(_) => {}
    }
    if faults.is_empty() { Ok(PinList { pins }) } else { Err(faults) }
}

/// A record with the byte ranges of its cells.
struct Row {
    cells: Vec<(String, Range<usize>)>,
    span: Range<usize>,
    line: usize,
}

impl Row {
    fn new(text: &str, record: &csv::StringRecord) -> Self {
        let begin = record.position().map_or(0, |at| usize::try_from(at.byte()).unwrap_or(usize::MAX)).min(text.len());
        // The position of a record begins after the end of the previous one: comments and empty lines may be in
        // between.
        let mut start = begin;
        for line in text.get(begin..).unwrap_or_default().split_inclusive('\n') {
            if !line.trim().is_empty() && !line.trim_start().starts_with('#') {
                break;
            }
            start += line.len();
        }
        let rest = text.get(start..).unwrap_or_default();
        let end = start + rest.find(['\n', '\r']).unwrap_or(rest.len());
        let mut cells = Vec::new();
        let mut at = start;
        for cell in record {
            let found = text.get(at..end).and_then(|rest| rest.find(cell)).filter(|_| !cell.is_empty());
            let span = found.map_or(at..at, |offset| at + offset..at + offset + cell.len());
            at = span.end;
            cells.push((cell.to_owned(), span));
        }
        let line = text.get(..start).unwrap_or_default().matches('\n').count() + 1;
        Self { cells, span: start..end, line }
    }
}

/// Index of each column.
struct Header {
    places: BTreeMap<PinColumn, usize>,
    width: usize,
}

impl Header {
    fn read(row: &Row, faults: &mut Vec<ListFault>) -> Self {
        let mut places = BTreeMap::new();
        for (index, (head, span)) in row.cells.iter().enumerate() {
            match PinColumn::ALL.iter().copied().find(|column| column.heads().contains(&plain(head).as_str())) {
                Some(column) if places.contains_key(&column) => {
                    faults.push(ListFault::ColumnTwice { column, span: span.clone() });
                }
                Some(column) => drop(places.insert(column, index)),
                None => faults.push(ListFault::ColumnUnknown { head: head.clone(), span: span.clone() }),
            }
        }
        let heads = || row.cells.iter().map(|(head, _)| head.clone()).collect();
        let missing =
            PinColumn::ALL.iter().copied().filter(|column| column.is_needed() && !places.contains_key(column));
        faults.extend(missing.map(|column| ListFault::ColumnMissing { column, found: heads() }));
        Self { places, width: row.cells.len() }
    }

    fn cell<'r>(&self, row: &'r Row, column: PinColumn) -> Option<&'r (String, Range<usize>)> {
        row.cells.get(*self.places.get(&column)?)
    }
}

fn listed(row: &Row, header: &Header, faults: &mut Vec<ListFault>) -> Option<ListedPin> {
    if row.cells.len() != header.width {
        let (found, expected) = (row.cells.len(), header.width);
        faults.push(ListFault::Ragged { span: row.span.clone(), found, expected });
        return None;
    }
    let before = faults.len();
    for column in [PinColumn::Connector, PinColumn::Pin] {
        if header.cell(row, column).is_some_and(|(text, _)| text.is_empty()) {
            faults.push(ListFault::CellEmpty { column, span: row.span.clone() });
        }
    }
    let role = header.cell(row, PinColumn::Connector).filter(|(text, _)| !text.is_empty()).and_then(|(text, span)| {
        let role = role_of(text);
        if role.is_none() {
            faults.push(ListFault::ConnectorUnknown { written: text.clone(), span: span.clone() });
        }
        role
    });
    let shield = header.cell(row, PinColumn::Shield).filter(|(text, _)| !text.is_empty()).and_then(|(text, span)| {
        let shield = shield_of(text);
        if shield.is_none() {
            faults.push(ListFault::ShieldUnclear { written: text.clone(), span: span.clone() });
        }
        shield
    });
    if faults.len() > before {
        return None;
    }
    let text = |column| header.cell(row, column).map(|(text, _)| text.clone());
    Some(ListedPin {
        line: row.line,
        role: role?,
        pin: text(PinColumn::Pin)?,
        signal: text(PinColumn::Signal)?,
        colour: text(PinColumn::Colour).filter(|colour| !colour.is_empty()),
        shield,
    })
}
