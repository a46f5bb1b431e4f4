//! Line protocol: each request is a line of text, answered by a line.

use crate::dictionary::{Address, Value};
use crate::drive::{Drive, HALF_MS_S};
use quantities::identified;

/// Length limit of a line including its end \[bytes\].
pub const LINE_MOST: usize = 128;

/// Upper limit of the time step of one line \[ms\].
pub const STEP_MOST_MS: f64 = 10_000.0;

identified! {
    /// Source of time.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
    pub enum Time {
        /// Time follows the clock.
        #[default]
        Real = "real",
        /// The client advances time.
        Stepped = "stepped",
    }
}

impl Time {
    /// Returns the value with an identifier.
    #[must_use]
    pub fn of(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|time| time.id() == id)
    }
}

/// Answer to a line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Answer {
    /// A line of text.
    Line(String),
    /// The client ends the connection.
    Bye,
    /// The command has wrong arguments.
    Wrong,
    /// The line is no command.
    NoCommand,
}

/// Answer to a command with wrong arguments.
pub const WRONG: &str = "error arguments";
/// Answer to a line that is no command.
pub const NO_COMMAND: &str = "error command";

/// Returns the number of steps by which a line advances time before its answer, [`stepped`]; `None` for any other line,
/// which [`answer`] answers at once.
#[must_use]
pub fn steps_of(time: Time, line: &str) -> Option<u64> {
    let words: Vec<&str> = line.split_ascii_whitespace().collect();
    match (words.as_slice(), time) {
        (["step", milliseconds], Time::Stepped) => steps(milliseconds),
        _ => None,
    }
}

/// Returns the answer to a line that advanced time, after its steps.
#[must_use]
pub fn stepped(drive: &Drive<'_>) -> String {
    format!("ok {:.1}", 1e3 * drive.time_s())
}

/// Answers a line, advancing time within the call if the line requests it.
pub fn answer(drive: &mut Drive<'_>, time: Time, line: &str) -> Answer {
    if let Some(steps) = steps_of(time, line) {
        drive.advance(steps);
        return Answer::Line(stepped(drive));
    }
    let words: Vec<&str> = line.split_ascii_whitespace().collect();
    let text = match words.as_slice() {
        ["read", at] => address(at).map(|at| read(drive, at)),
        ["write", at, value] => address(at).zip(number(value)).map(|(at, value)| match drive.write(at, value) {
            Ok(()) => "ok".to_owned(),
            Err(abort) => format!("abort 0x{:08X}", abort.code()),
        }),
        ["step", _] if time == Time::Real => Some("error real_time".to_owned()),
        ["time"] => Some(format!("ok {:.1} {}", 1e3 * drive.time_s(), time.id())),
        ["status"] => Some(status(drive)),
        ["bye"] => return Answer::Bye,
        ["read" | "write" | "step" | "time" | "status" | "bye", ..] => None,
        _ => return Answer::NoCommand,
    };
    text.map_or(Answer::Wrong, Answer::Line)
}

/// Parses `6041` or `6091:1`, hexadecimal.
fn address(written: &str) -> Option<Address> {
    let (index, sub) = written.split_once(':').unwrap_or((written, "0"));
    let index = index.strip_prefix("0x").unwrap_or(index);
    let is_hex = |digits: &str| !digits.is_empty() && digits.bytes().all(|digit| digit.is_ascii_hexdigit());
    if !is_hex(index) || !is_hex(sub) {
        return None;
    }
    Some(Address::new(u16::from_str_radix(index, 16).ok()?, u8::from_str_radix(sub, 16).ok()?))
}

/// Parses `-15`, `15` or `0x0F`.
fn number(written: &str) -> Option<i64> {
    match written.strip_prefix("0x") {
        Some(digits) if digits.bytes().all(|digit| digit.is_ascii_hexdigit()) => i64::from_str_radix(digits, 16).ok(),
        Some(_) => None,
        None => written.parse().ok(),
    }
}

/// Parses milliseconds as whole steps of the drive.
fn steps(written: &str) -> Option<u64> {
    let milliseconds: f64 = written.parse().ok()?;
    let steps = milliseconds / (1e3 * HALF_MS_S);
    if !(milliseconds > 0.0 && milliseconds <= STEP_MOST_MS) || (steps - steps.round()).abs() > 1e-6 {
        return None;
    }
    u64::try_from(crate::scale::bounded(steps, 1, i64::MAX)).ok()
}

fn read(drive: &Drive<'_>, at: Address) -> String {
    match drive.read(at) {
        Ok(Value::Number(number)) => format!("ok {number}"),
        Ok(Value::Text(text)) => format!("ok \"{text}\""),
        Err(abort) => format!("abort 0x{:08X}", abort.code()),
    }
}

fn status(drive: &Drive<'_>) -> String {
    let read = |index: u16| match drive.read(Address::new(index, 0)) {
        Ok(Value::Number(number)) => Some(number),
        Ok(Value::Text(_)) | Err(_) => None,
    };
    let of = |index: u16| read(index).unwrap_or(0);
    let names: [(&str, u16); 9] = [
        ("mode", 0x6061),
        ("demand", 0x6062),
        ("position", 0x6064),
        ("velocity", 0x606C),
        ("following", 0x60F4),
        ("current", 0x6078),
        ("link", 0x6079),
        ("winding", 0x2001),
        ("brake", 0x2003),
    ];
    let mut text = format!(
        "ok time={:.1} state={} statusword=0x{:04X} error=0x{:04X}",
        1e3 * drive.time_s(),
        drive.state().id(),
        of(0x6041),
        of(0x603F)
    );
    // A drive without winding temperature sensor lacks this object.
    for (name, number) in names.iter().filter_map(|(name, index)| Some((name, read(*index)?))) {
        text.push_str(&format!(" {name}={number}"));
    }
    text
}
