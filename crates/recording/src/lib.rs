//! Recorded or planned motion, read from CSV and Parquet into plain SI arrays.
//!
//! [`read_csv`] and [`read_parquet`] find the columns of time, position, speed and torque by their names or by a
//! [`Layout`], require a unit for each, and check every sample. A [`Recording`] is ready for computation: times rise
//! strictly, all values are finite and in SI. A refused file returns all its faults at once, each with its line or row.
//! Nothing is smoothed, filled in or sorted.
//!
//! ```
//! use recording::{Along, Layout, read_csv};
//!
//! let text = "t [ms];Winkel [deg];M\n;;Nm\n100;0,0;1,5\n101;0,9;1,6\n102;1,8;1,7\n";
//! let recording = read_csv(text.as_bytes(), &Layout::default()).unwrap();
//! assert_eq!(*recording.time_s, [0.0, 0.001, 0.002]);
//! let position = recording.course.position.unwrap();
//! assert_eq!((position.along, position.values.len()), (Along::Turning, 3));
//! assert_eq!(*recording.torque.unwrap().values, [1.5, 1.6, 1.7]);
//! ```

mod ahead;
mod cells;
mod clock;
mod collected;
mod columns;
mod counted;
mod csv;
mod csv_faults;
mod csv_units;
mod damage;
mod encoding;
mod factor;
mod faults;
mod gather;
mod lacking;
mod layout;
mod limits;
mod lines;
mod memory;
mod modulo;
mod names;
mod number;
mod order;
mod packed;
mod parquet;
mod places;
mod plain;
mod preview;
mod records;
mod series;
mod side;
mod thousands;
mod time_form;
mod tools;

pub use counted::refuse_long;
pub use csv::{read_csv, read_csv_within};
pub use encoding::read_text;
pub use faults::{Damage, Fault, FileRow, NearColumn, Remedy, Stamp};
pub use layout::{ColumnSpec, Layout, Role};
pub use limits::{
    BLANK_BYTES_MAX, DELTA_BLOCK_MAX, FILE_BYTES_MAX, LINE_BYTES_MAX, Limit, MAGNITUDE_MAX, MEMORY_USUAL, NESTING_MAX,
    SAMPLES_MAX, STEP_MIN_S, TABLE_COLUMNS_MAX,
};
pub use memory::Memory;
pub use names::{is_share, name_and_unit, unit_after_underscore};
pub use number::{is_grouped, number, with_unit};
pub use packed::{Content, Foreign, Packing, Sniffed, opened};
pub use parquet::{
    Ranges, Table, TableColumn, TableValues, ValueKind, column_names, read_columns, read_parquet, read_parquet_within,
    row_count,
};
pub use preview::{PREVIEW_COLUMNS_MAX, Preview, PreviewColumn, preview_csv, preview_parquet};
pub use records::Records;
pub use series::{Along, ColumnRead, Encoding, KnownBy, RecordedCourse, Recording, Series};
pub use side::is_of_motor;
pub use thousands::{Commas, Possible, RowKind, Thousands, may_be_grouped};

pub use ::bytes::Bytes;

/// Maximum number of faults reported; the last entry then states the number of the others.
pub const FAULTS_MAX: usize = 50;

/// Number of median intervals above which an interval is a gap. A choice of this crate: a logger that skips a few
/// samples passes, a recording that was paused does not.
pub const GAP_FACTOR: f64 = 10.0;
