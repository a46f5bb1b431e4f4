//! The virtual drive of a code: its axis, and its electronic data sheet.

use crate::eds::{self, MANDATORY, Variable};
use crate::list::Unanswered;
use crate::reading::{Unread, read_with};
use crate::simulate::Ready;
use crate::sizing_use::{Refusal, check};
use axis::{AxisProject, Catalogue};
use drive::{Drive, Entry, Given, Value};
use installation::commission::{cia402, commission};
use order_code::OrderCode;
use quantities::{Language, Measure, MomentOfInertia};
use std::fmt::Write as _;
use std::sync::Arc;
use twin::Setup;
use words::simulation;

pub use drive::can::{CanNode, Frame};
pub use drive::line::{self, Time};
pub use drive::{self as room, HALF_MS_S, socketcand};

/// Largest node number of CANopen.
pub const NODE_MOST: u8 = 127;

/// Returns an axis without a project: a load with a moment of inertia, by default that of the actuator itself, without
/// any other torque.
///
/// # Errors
/// The manual states no data for the code.
pub fn bare_axis(
    code: &OrderCode,
    inertia: Option<MomentOfInertia>,
    catalogue: &Arc<dyn Catalogue>,
    language: Language,
) -> Result<AxisProject, Unanswered> {
    let about = commission(code).ok_or(Refusal::NoData)?;
    let own = about.actuator.inertia_out.known().map(|known| known.value);
    let inertia = inertia.or(own).ok_or(Refusal::NoData)?;
    let text = format!(
        "format = 1\n[load]\ninertia = \"{} kg m^2\"\n[[motion]]\nlaw = \"manual\"\nspeed = \"1 1/min\"\n\
        accelerate = \"0.1 s\"\nrun = \"0.1 s\"\nbrake = \"0.1 s\"\npause = \"1 s\"\n",
        inertia.si()
    );
    let faults = |found| Unanswered::unread(Unread::Faults(found), "load", &text, language);
    read_with(&text, catalogue).map_err(faults)
}

/// Passes a drive with the axis of a project to a function.
///
/// # Errors
/// The manual states no data for the code, the project is not judged, or the twin cannot run.
pub fn with_drive<T>(
    project: &AxisProject,
    code: &OrderCode,
    (node, seed): (u8, u32),
    language: Language,
    run: impl FnOnce(Drive<'_>) -> T,
) -> Result<T, Unanswered> {
    let about = commission(code).ok_or(Refusal::NoData)?;
    let candidate = check(project, code)?;
    let ready = Ready::of(project, &candidate);
    let given = Given {
        node,
        name: format!("antrieb {code}"),
        seed,
        objects: cia402::objects(&about),
        has_battery: about.actuator.feedback.buffered_by_battery,
        has_kty: about.has_kty(),
    };
    let encoder = crate::simulate::encoder_of(code);
    let failure = project.twin.scenario.failure;
    let scenario = twin::Scenario { failure, ..twin::Scenario::default() };
    let mut setup = Setup { seed: u64::from(seed), scenario, encoder: encoder.as_ref(), ..ready.setup() };
    let made = ready.controlled(&mut setup).and_then(|_| Drive::new(&setup, &given));
    let drive = made.map_err(|fault| Unanswered::message(simulation::simulation_fault(&fault, language)))?;
    Ok(run(drive))
}

/// Communication objects whose value depends on the node number.
const OF_NODE: [(u16, u8); 9] = [
    (0x1014, 0),
    (0x1400, 1),
    (0x1401, 1),
    (0x1402, 1),
    (0x1403, 1),
    (0x1800, 1),
    (0x1801, 1),
    (0x1802, 1),
    (0x1803, 1),
];

/// Returns the electronic data sheet of the virtual drive, for any node number; without a date, so that the same call
/// gives the same bytes.
///
/// # Source
/// cia-306
#[must_use]
pub fn eds(drive: &Drive<'_>, code: &OrderCode, node: u8, language: Language) -> String {
    let entries: Vec<&Entry> = drive.entries().collect();
    let about = words::serving::eds_of_the_virtual_drive(language);
    let mut out = format!("; {code}: {about}\n");
    eds::file_info(&mut out, &format!("{code}-virtual"), about);
    let _ = write!(
        out,
        "[DeviceInfo]\nVendorName=antrieb\nVendorNumber=0x0\nProductName=antrieb {code}\nProductNumber=0x402\n\
        RevisionNumber=0x1\nOrderCode={code}\n"
    );
    for rate in [10, 20, 50, 125, 250, 500, 800, 1000] {
        let _ = writeln!(out, "BaudRate_{rate}=1");
    }
    out.push_str(
        "SimpleBootUpMaster=0\nSimpleBootUpSlave=1\nGranularity=8\nDynamicChannelsSupported=0\nGroupMessaging=0\n\
        NrOfRXPDO=4\nNrOfTXPDO=4\nLSS_Supported=0\n",
    );
    let mut indices: Vec<u16> = entries.iter().map(|entry| entry.at.index).collect();
    indices.dedup();
    let of =
        |keeps: &dyn Fn(u16) -> bool| -> Vec<u16> { indices.iter().copied().filter(|index| keeps(*index)).collect() };
    let is_own = |index: u16| (0x2000..0x6000).contains(&index);
    eds::list(&mut out, "MandatoryObjects", &of(&|index| MANDATORY.contains(&index)));
    eds::list(&mut out, "OptionalObjects", &of(&|index| !MANDATORY.contains(&index) && !is_own(index)));
    eds::list(&mut out, "ManufacturerObjects", &of(&is_own));
    for index in &indices {
        let of_index: Vec<&&Entry> = entries.iter().filter(|entry| entry.at.index == *index).collect();
        if let Some(name) = of_index.first().and_then(|entry| entry.group) {
            eds::group(&mut out, *index, name, 9, of_index.len());
        }
        for entry in of_index {
            let head = match entry.group {
                Some(_) => format!("{index:04X}sub{:X}", entry.at.sub),
                None => format!("{index:04X}"),
            };
            eds::variable(&mut out, &head, &variable(entry, node));
        }
    }
    out
}

fn variable(entry: &Entry, node: u8) -> Variable<'_> {
    let usual = match &entry.usual {
        Value::Text(text) => text.clone(),
        Value::Number(number) if OF_NODE.contains(&(entry.at.index, entry.at.sub)) => {
            format!("$NODEID+0x{:X}", number - i64::from(node))
        }
        Value::Number(number) => number.to_string(),
    };
    let is_number = matches!(entry.usual, Value::Number(_));
    Variable {
        name: entry.name,
        data_type: entry.data_type.number(),
        access: entry.access.id(),
        usual: Some(usual),
        range: (is_number && entry.range != entry.data_type.range()).then_some(entry.range),
        mappable: entry.mappable,
    }
}
