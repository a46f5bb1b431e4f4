//! Tables of a series, and the words of its code.

use order_code::{Feedback, OrderCode, Series, Size, Winding};
use std::sync::LazyLock;

/// Tables of a series by their purpose, the marks of its matrix, and the data of its windings and feedback systems.
#[derive(Clone, Copy, Debug, Default)]
pub struct SeriesData {
    /// Identifier of its manual.
    pub manual: &'static str,
    /// Table with the calibrations of the models.
    pub family: &'static str,
    /// Table of the words that exist at each size.
    pub matrix: &'static str,
    /// Table of the pairs of winding and feedback.
    pub pairs: &'static str,
    /// Table with the thresholds of the winding temperature; empty: none.
    pub thresholds: &'static str,
    /// Table with the conditions of the preselection; empty: none.
    pub preselection: &'static str,
    /// Table of the encoder at the output; empty: none.
    pub output_encoder: &'static str,
    /// Connector and pins of the encoder at the output; empty: none.
    pub output_wiring: &'static [&'static str],
    /// Tables of cables.
    pub cables: &'static [&'static str],
    /// Prefixes of the sections whose tables are headed by the size.
    pub by_size: &'static [&'static str],
    /// Prefixes of the sections whose tables are about a feedback.
    pub feedback: &'static [&'static str],
    /// Sections of ordering and wiring.
    pub ordering: &'static [&'static str],
    /// Prefixes of the sections whose cells hold for every actuator.
    pub of_all: &'static [&'static str],
    /// Tables of published curves.
    pub curves: &'static [&'static str],
    /// Table with the life of the gear; empty: none.
    pub gear_life: &'static str,
    /// Series of gears whose rows of that table apply.
    pub gear_series: &'static str,
    /// Marks in the cells of the matrix.
    pub marks: &'static [Mark],
    /// Tables of each winding, in the order of its words.
    pub windings: &'static [WindingData],
    /// Table of each feedback, in the order of its words; empty: none.
    pub feedback_tables: &'static [&'static str],
    /// Headings of the drives.
    pub drives: &'static [DriveHead],
    /// Tables of connectors.
    pub wirings: &'static [WiringTables],
}

/// Meaning of a cell of the matrix: the first mark that it begins with applies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mark {
    /// Beginning of the text.
    pub begins: &'static str,
    /// Meaning.
    pub entry: MarkEntry,
    /// Feedback with which alone the mark applies.
    pub feedback: Option<Feedback>,
    /// Mark of the footnote that makes the actuator longer; empty: none.
    pub longer: &'static str,
}

/// Availability of a word at a size.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MarkEntry {
    /// Available.
    Available,
    /// Available on request.
    OnRequest,
    /// Not available.
    NotAvailable,
}

/// Tables of a winding.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WindingData {
    /// Table of general data.
    pub general: &'static str,
    /// Heading of its columns.
    pub general_head: &'static str,
    /// Condition of the row of I_NLS that holds within the range of operating temperatures.
    pub starting_current: &'static str,
    /// `true`: I_0 = T_0/k_Tout + I_NLS; `false`: I_0 = T_0/k_Tout.
    pub stall_current_includes_friction: bool,
    /// A PTC is led out of the winding.
    pub ptc: bool,
    /// Words of the feedback systems whose connector does not carry the KTY.
    pub without_kty: &'static [&'static str],
}

/// A drive that heads tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DriveHead {
    /// Heading.
    pub name: &'static str,
    /// Frame size.
    pub size: Size,
    /// Windings for which its tables hold.
    pub windings: &'static [Winding],
    /// Feedback systems for which its tables hold.
    pub feedbacks: &'static [Feedback],
}

/// Tables of connectors by winding and feedback.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WiringTables {
    /// Windings.
    pub windings: &'static [Winding],
    /// Feedback systems.
    pub feedbacks: &'static [Feedback],
    /// Connector and pins of the motor, then of the feedback.
    pub tables: [&'static str; 4],
}

impl SeriesData {
    /// Returns the data of a series.
    #[must_use]
    pub fn of(series: Series) -> &'static Self {
        static NONE: LazyLock<SeriesData> = LazyLock::new(SeriesData::default);
        crate::series().get(series.place()).unwrap_or_else(|| &NONE)
    }

    /// Returns every table of pins, without repetition.
    #[must_use]
    pub fn pin_tables(&self) -> Vec<&'static str> {
        let wired = self.wirings.iter().flat_map(|each| [each.tables[1], each.tables[3]]);
        let mut found: Vec<&'static str> = Vec::new();
        for table in wired.chain(self.output_wiring.get(1).copied()) {
            if !found.contains(&table) {
                found.push(table);
            }
        }
        found
    }

    /// Returns `true` if a section begins with one of the prefixes.
    #[must_use]
    pub fn begins(sections: &[&str], section: &str) -> bool {
        sections.iter().any(|begin| section.starts_with(begin))
    }
}

/// Returns `true` if the connector of the feedback leads out the KTY of the winding.
///
/// # Source
/// data/cha/code.toml, from the pins of section 6.24 with their errata
#[must_use]
pub fn leads_out_kty(code: &OrderCode) -> bool {
    !winding_data(code.winding).is_some_and(|data| data.without_kty.contains(&code.feedback.as_str()))
}

/// Returns `true` if the connector of the motor leads out the PTC of the winding.
///
/// # Source
/// data/cha/code.toml, from the pins of section 6.24 with their errata
#[must_use]
pub fn leads_out_ptc(code: &OrderCode) -> bool {
    winding_data(code.winding).is_some_and(|data| data.ptc)
}

/// Returns the tables of a winding.
#[must_use]
pub fn winding_data(winding: Winding) -> Option<&'static WindingData> {
    SeriesData::of(winding.series()).windings.get(winding.place())
}
