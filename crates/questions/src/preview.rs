//! First rows of a recording and the possible roles of its columns, as a basis for selecting them.

use axis::Files;
use recording::{Preview, Role};

/// Number of rows.
const ROWS: usize = 4;

/// Returns the header and the first rows of a recording of a project, as text; `None` if the file cannot be opened or
/// is no text.
#[must_use]
pub fn recording_preview(name: &str, files: &dyn Files) -> Option<Preview> {
    let is_text = !name.to_ascii_lowercase().ends_with(".parquet") && files.grant().reach.admits(name);
    let source = is_text.then(|| files.open(name).ok())??;
    recording::preview_csv(source, ROWS)
}

/// Returns the roles of columns, each by its key and with its valid units.
#[must_use]
pub fn recording_roles() -> [(&'static str, Role, Vec<&'static str>); 4] {
    Role::ALL.map(|role| {
        let name = match role {
            Role::Time => "time",
            Role::Position => "position",
            Role::Speed => "speed",
            Role::Torque => "torque",
        };
        let units = role.dimensions().iter().flat_map(|dimension| dimension.units()).map(|unit| unit.ascii).collect();
        (name, role, units)
    })
}
