//! Text protocol of socketcand in raw mode: frames in angle brackets.

use crate::can::Frame;

/// A message of a client.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Message {
    /// `< open NAME >`
    Open,
    /// `< rawmode >`
    RawMode,
    /// `< echo >`
    Echo,
    /// `< send ID LENGTH BYTES >`
    Send(Frame),
    /// A frame with a 29-bit identifier, or another command: valid on a bus but unused by this node.
    Other,
}

/// Length limit of a message \[bytes\]: `< send` with eight bytes has 40 characters, the name of a bus 16.
pub const MESSAGE_MOST: usize = 128;

/// Greeting of the server.
pub const HI: &str = "< hi >";

/// Acknowledgement of a command.
pub const OK: &str = "< ok >";

/// Error of a stream whose beginning is no message.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoMessage;

/// Parses the first message of the received bytes and returns it with its length in bytes; `None` if it is incomplete.
///
/// # Errors
/// [`NoMessage`] if the bytes begin with something else, exceed the length of a message, or are not readable.
pub fn read(received: &[u8]) -> Result<Option<(Message, usize)>, NoMessage> {
    let before = received.iter().take_while(|byte| byte.is_ascii_whitespace()).count();
    let rest = received.get(before..).unwrap_or_default();
    match rest.first() {
        None => return if before > MESSAGE_MOST { Err(NoMessage) } else { Ok(None) },
        Some(b'<') => {}
        Some(_) => return Err(NoMessage),
    }
    let Some(end) = rest.iter().take(MESSAGE_MOST).position(|byte| *byte == b'>') else {
        return if rest.len() >= MESSAGE_MOST { Err(NoMessage) } else { Ok(None) };
    };
    let inner = rest.get(1..end).and_then(|inner| std::str::from_utf8(inner).ok()).ok_or(NoMessage)?;
    Ok(Some((message(inner)?, before + end + 1)))
}

fn message(inner: &str) -> Result<Message, NoMessage> {
    let mut words = inner.split_ascii_whitespace();
    Ok(match words.next() {
        Some("open") => Message::Open,
        Some("rawmode") => Message::RawMode,
        Some("echo") => Message::Echo,
        Some("send") => {
            let id = words.next().ok_or(NoMessage)?;
            let number = |word: &str| u32::from_str_radix(word, 16).map_err(|_| NoMessage);
            let length = number(words.next().ok_or(NoMessage)?)?;
            let bytes: Vec<u8> =
                words.map(|word| u8::from_str_radix(word, 16).map_err(|_| NoMessage)).collect::<Result<_, _>>()?;
            if length > 8 || u32::try_from(bytes.len()) != Ok(length) {
                return Err(NoMessage);
            }
            let value = number(id)?;
            match u16::try_from(value) {
                // An identifier of three digits has 11 bit, one of eight digits 29 bit.
                Ok(value) if id.len() <= 3 && value <= 0x7FF => Message::Send(Frame::new(value, &bytes)),
                _ => Message::Other,
            }
        }
        Some(_) => Message::Other,
        None => return Err(NoMessage),
    })
}

/// Returns a frame as sent to a client, with the time of transmission \[s\].
#[must_use]
pub fn written(frame: &Frame, time_s: f64) -> String {
    use std::fmt::Write as _;
    let mut text = format!("< frame {:03X} {time_s:.6} ", frame.id());
    for byte in frame.data() {
        let _ = write!(text, "{byte:02X}");
    }
    text.push_str(" >");
    text
}

/// Returns a frame as sent by a client.
#[must_use]
pub fn sent(frame: &Frame) -> String {
    use std::fmt::Write as _;
    let mut text = format!("< send {:03X} {:X}", frame.id(), frame.data().len());
    for byte in frame.data() {
        let _ = write!(text, " {byte:X}");
    }
    text.push_str(" >");
    text
}
