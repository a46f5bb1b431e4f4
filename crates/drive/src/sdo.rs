//! SDO server: expedited transfer of numbers, segmented transfer of texts.

use crate::abort::Abort;
use crate::dictionary::{Address, Value, parts};
use crate::drive::Drive;
use installation::commission::cia402::DataType;

/// SDO server with the text that is being read in segments.
#[derive(Clone, Debug, Default)]
pub(crate) struct Server {
    upload: Option<Upload>,
}

#[derive(Clone, Debug)]
struct Upload {
    at: Address,
    rest: Vec<u8>,
    toggle: u8,
}

/// Data bytes of a segment.
const SEGMENT: usize = 7;

impl Server {
    /// Returns the answer to a request; `None` to an abort.
    ///
    /// # Source
    /// cia-301 section 7.2.4
    pub(crate) fn answer(&mut self, request: [u8; 8], drive: &mut Drive<'_>) -> Option<[u8; 8]> {
        let [head, low, high, sub, data @ ..] = request;
        let at = Address::new(u16::from_le_bytes([low, high]), sub);
        let found = match head >> 5 {
            1 => download(head, at, data, drive),
            2 => self.begin_upload(at, drive),
            3 => self.go_on(head),
            4 => {
                self.upload = None;
                return None;
            }
            _ => Err((at, Abort::Specifier)),
        };
        Some(found.unwrap_or_else(|(at, abort)| {
            self.upload = None;
            let [low, high] = at.index.to_le_bytes();
            let [a, b, c, d] = abort.code().to_le_bytes();
            [0x80, low, high, at.sub, a, b, c, d]
        }))
    }

    fn begin_upload(&mut self, at: Address, drive: &Drive<'_>) -> Result<[u8; 8], (Address, Abort)> {
        let refused = |abort| (at, abort);
        let bytes = match drive.read(at).map_err(refused)? {
            Value::Text(text) => text.into_bytes(),
            Value::Number(number) => {
                let entry = drive.dictionary.entry(at).map_err(refused)?;
                parts::bytes(entry.data_type, number)
            }
        };
        let [low, high] = at.index.to_le_bytes();
        let size = u8::try_from(bytes.len()).unwrap_or(u8::MAX);
        if let Some(unused) = 4_u8.checked_sub(size).filter(|_| size > 0) {
            let mut four = [0; 4];
            for (place, byte) in four.iter_mut().zip(&bytes) {
                *place = *byte;
            }
            let [a, b, c, d] = four;
            return Ok([0x43 | unused << 2, low, high, at.sub, a, b, c, d]);
        }
        self.upload = Some(Upload { at, rest: bytes, toggle: 0 });
        Ok([0x41, low, high, at.sub, size, 0, 0, 0])
    }

    fn go_on(&mut self, head: u8) -> Result<[u8; 8], (Address, Abort)> {
        let Some(upload) = &mut self.upload else { return Err((Address::new(0, 0), Abort::Specifier)) };
        if head & 0x10 != upload.toggle {
            return Err((upload.at, Abort::Toggle));
        }
        let behind = upload.rest.split_off(upload.rest.len().min(SEGMENT));
        let segment = std::mem::replace(&mut upload.rest, behind);
        let unused = u8::try_from(SEGMENT - segment.len()).unwrap_or(0);
        let is_last = upload.rest.is_empty();
        let mut answer = [0; 8];
        let head = upload.toggle | unused << 1 | u8::from(is_last);
        for (place, byte) in answer.iter_mut().zip(std::iter::once(&head).chain(&segment)) {
            *place = *byte;
        }
        upload.toggle ^= 0x10;
        if is_last {
            self.upload = None;
        }
        Ok(answer)
    }
}

/// Writes an object of at most four bytes.
fn download(head: u8, at: Address, data: [u8; 4], drive: &mut Drive<'_>) -> Result<[u8; 8], (Address, Abort)> {
    let refused = |abort| (at, abort);
    let entry = drive.dictionary.entry(at).map_err(refused)?;
    let data_type = entry.data_type;
    if data_type == DataType::VisibleString {
        return Err(refused(Abort::ReadOnly));
    }
    let (is_expedited, says_size) = (head & 2 != 0, head & 1 != 0);
    if !is_expedited {
        // No writable object needs segments.
        return Err(refused(if says_size && u32::from_le_bytes(data) > 4 { Abort::TooLong } else { Abort::Specifier }));
    }
    let size = if says_size { 4 - (head >> 2 & 3) } else { data_type.bytes() };
    let bytes = data.get(..usize::from(size)).unwrap_or(&data);
    let value = parts::number(data_type, bytes).map_err(refused)?;
    drive.write(at, value).map_err(refused)?;
    let [low, high] = at.index.to_le_bytes();
    Ok([0x60, low, high, at.sub, 0, 0, 0, 0])
}
