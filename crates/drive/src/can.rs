//! The drive as a CANopen node: receives and sends frames.

use crate::dictionary::{Value, parts};
use crate::drive::{Drive, HALF_MS_S};
use crate::pdo::{CYCLIC_MOST, Pdo};
use crate::sdo::Server;
use crate::trouble::Trouble;
use std::collections::VecDeque;

/// A data frame with an 11-bit identifier.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Frame {
    id: u16,
    length: u8,
    bytes: [u8; 8],
}

impl Frame {
    /// Creates a frame of at most eight bytes; further bytes are cut off.
    #[must_use]
    pub fn new(id: u16, data: &[u8]) -> Self {
        let mut bytes = [0; 8];
        for (place, byte) in bytes.iter_mut().zip(data) {
            *place = *byte;
        }
        Self { id: id & 0x7FF, length: u8::try_from(data.len().min(8)).unwrap_or(8), bytes }
    }

    /// Returns the identifier.
    #[must_use]
    pub const fn id(&self) -> u16 {
        self.id
    }

    /// Returns the data bytes.
    #[must_use]
    pub fn data(&self) -> &[u8] {
        self.bytes.get(..usize::from(self.length)).unwrap_or(&self.bytes)
    }
}

/// State of the network management.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Nmt {
    /// SDO only, no PDO.
    PreOperational = 127,
    /// SDO and PDO.
    Operational = 5,
    /// Neither SDO nor PDO.
    Stopped = 4,
}

impl Nmt {
    /// Returns the state number transferred in the heartbeat.
    ///
    /// # Source
    /// cia-301
    #[must_use]
    pub const fn number(self) -> u8 {
        self as u8
    }
}

const SYNC: u16 = 0x80;
const EMERGENCY: u16 = 0x80;
const SDO_ANSWER: u16 = 0x580;
const SDO_REQUEST: u16 = 0x600;
const HEARTBEAT: u16 = 0x700;

/// Communication parameters of the received and the sent PDOs.
const RECEIVED: [u16; 4] = [0x1400, 0x1401, 0x1402, 0x1403];
const SENT: [u16; 4] = [0x1800, 0x1801, 0x1802, 0x1803];

/// Limit of the output queue \[frames\]; the oldest frames are lost beyond it, as on a bus.
const WAITING_MOST: usize = 1024;

/// Emergency of a PDO shorter than its mapping: error code and error register.
const TOO_SHORT: (u16, u8) = (0x8210, 1 << 4 | 1);

/// State of a sent PDO.
#[derive(Clone, Debug, Default)]
struct Sent {
    last: Option<Vec<u8>>,
    at_tick: u64,
    syncs: i64,
}

/// A drive on a CAN bus.
#[derive(Clone, Debug)]
pub struct CanNode<'a> {
    drive: Drive<'a>,
    id: u8,
    nmt: Nmt,
    server: Server,
    sent: [Sent; 4],
    /// Received PDOs that wait for the SYNC message.
    pending: [Option<Frame>; 4],
    out: VecDeque<Frame>,
    heartbeat_tick: u64,
    /// Tick of the controller's last heartbeat.
    heard_tick: Option<u64>,
    steps_with_sync: bool,
}

impl<'a> CanNode<'a> {
    /// Creates a node that sends its boot-up message. With `steps_with_sync` each SYNC message advances time by the
    /// period of 60C2h.
    #[must_use]
    pub fn new(drive: Drive<'a>, id: u8, steps_with_sync: bool) -> Self {
        let mut node = Self {
            drive,
            id: id.clamp(1, 127),
            nmt: Nmt::PreOperational,
            server: Server::default(),
            sent: Default::default(),
            pending: [None; 4],
            out: VecDeque::new(),
            heartbeat_tick: 0,
            heard_tick: None,
            steps_with_sync,
        };
        node.boot();
        node
    }

    /// Returns the drive.
    #[must_use]
    pub const fn drive(&self) -> &Drive<'a> {
        &self.drive
    }

    /// Returns the state of the network management.
    #[must_use]
    pub const fn nmt(&self) -> Nmt {
        self.nmt
    }

    /// Removes and returns the frames to be sent.
    pub fn take(&mut self) -> Vec<Frame> {
        self.out.drain(..).collect()
    }

    fn send(&mut self, id: u16, data: &[u8]) {
        if self.out.len() >= WAITING_MOST {
            self.out.pop_front();
        }
        self.out.push_back(Frame::new(id, data));
    }

    fn boot(&mut self) {
        self.nmt = Nmt::PreOperational;
        self.server = Server::default();
        (self.sent, self.pending, self.heard_tick) = (Default::default(), [None; 4], None);
        self.send(HEARTBEAT + u16::from(self.id), &[0]);
    }

    /// Advances time by steps of half a millisecond.
    pub fn advance(&mut self, steps: u64) {
        for _ in 0..steps {
            self.drive.advance(1);
            self.report();
            // All timers count in milliseconds.
            if self.drive.ticks().is_multiple_of(2) {
                self.heartbeat();
                self.listen();
                if self.nmt == Nmt::Operational {
                    self.send_events();
                }
            }
        }
    }

    /// Sends the faults that occurred since the last step.
    fn report(&mut self) {
        for (code, register) in self.drive.take_emergencies() {
            self.emergency(code, register);
        }
    }

    fn emergency(&mut self, code: u16, register: u8) {
        if self.nmt != Nmt::Stopped {
            let [low, high] = code.to_le_bytes();
            self.send(EMERGENCY + u16::from(self.id), &[low, high, register, 0, 0, 0, 0, 0]);
        }
    }

    fn number(&self, index: u16, sub: u8) -> u64 {
        u64::try_from(self.drive.dictionary.number(index, sub)).unwrap_or(0)
    }

    fn heartbeat(&mut self) {
        let every = 2 * self.number(0x1017, 0);
        if every > 0 && self.drive.ticks() >= self.heartbeat_tick + every {
            self.heartbeat_tick = self.drive.ticks();
            self.send(HEARTBEAT + u16::from(self.id), &[self.nmt.number()]);
        }
    }

    /// Raises a fault when the controller's heartbeat is overdue; supervised from its first heartbeat on.
    fn listen(&mut self) {
        let longest = 2 * (self.number(0x1016, 1) & 0xFFFF);
        if longest > 0 && self.heard_tick.is_some_and(|heard| self.drive.ticks() > heard + longest) {
            self.heard_tick = None;
            self.drive.raise(Trouble::Guarding);
            self.report();
        }
    }

    /// Receives a frame and advances time by the steps that it triggers.
    pub fn receive(&mut self, frame: &Frame) {
        let steps = self.accept(frame);
        self.advance(steps);
    }

    /// Receives a frame and returns the number of steps it triggers: those of a SYNC message, by which the caller
    /// advances time before the next frame.
    #[must_use]
    pub fn accept(&mut self, frame: &Frame) -> u64 {
        let own = u16::from(self.id);
        let consumed = u16::try_from(self.number(0x1016, 1) >> 16 & 0x7F).unwrap_or(0);
        match frame.id {
            0 => self.manage(frame),
            SYNC => return self.synchronise(),
            id if id == SDO_REQUEST + own => {
                // A request always has eight bytes.
                if self.nmt != Nmt::Stopped && frame.length == 8 {
                    if let Some(answer) = self.server.answer(frame.bytes, &mut self.drive) {
                        self.send(SDO_ANSWER + own, &answer);
                    }
                    self.report();
                }
            }
            id if consumed != 0 && id == HEARTBEAT + consumed => self.heard_tick = Some(self.drive.ticks()),
            _ => self.take_process_data(frame),
        }
        0
    }

    /// Executes a command of the network management.
    fn manage(&mut self, frame: &Frame) {
        let [command, node, ..] = frame.bytes;
        if frame.length != 2 || (node != 0 && node != self.id) {
            return;
        }
        match command {
            1 if self.nmt != Nmt::Operational => {
                self.nmt = Nmt::Operational;
                self.sent = Default::default();
                self.send_events();
            }
            2 => self.nmt = Nmt::Stopped,
            128 => self.nmt = Nmt::PreOperational,
            129 | 130 => {
                self.drive.restart(command == 129);
                self.boot();
            }
            _ => {}
        }
    }

    fn take_process_data(&mut self, frame: &Frame) {
        if self.nmt != Nmt::Operational {
            return;
        }
        for (place, parameter) in RECEIVED.into_iter().enumerate() {
            let pdo = Pdo::of(&self.drive.dictionary, parameter);
            if pdo.id != Some(frame.id) {
                continue;
            }
            if pdo.kind <= CYCLIC_MOST {
                if let Some(pending) = self.pending.get_mut(place) {
                    *pending = Some(*frame);
                }
            } else {
                self.write(&pdo, frame);
            }
        }
    }

    /// Writes the values of a frame; a value that its object rejects is skipped.
    fn write(&mut self, pdo: &Pdo, frame: &Frame) {
        let mut rest = frame.data();
        let mut found = Vec::new();
        for at in &pdo.objects {
            let Ok(entry) = self.drive.dictionary.entry(*at) else { continue };
            let Some((bytes, behind)) = rest.split_at_checked(usize::from(entry.data_type.bytes())) else {
                let (code, register) = TOO_SHORT;
                return self.emergency(code, register);
            };
            rest = behind;
            if let Ok(value) = parts::number(entry.data_type, bytes) {
                found.push((*at, value));
            }
        }
        for (at, value) in found {
            let _ = self.drive.write(at, value);
        }
        self.report();
    }

    /// Applies the PDOs that waited for the SYNC message and sends those due after it; returns the number of steps it
    /// triggers.
    fn synchronise(&mut self) -> u64 {
        if self.nmt == Nmt::Operational {
            for (place, parameter) in RECEIVED.into_iter().enumerate() {
                if let Some(frame) = self.pending.get_mut(place).and_then(Option::take) {
                    let pdo = Pdo::of(&self.drive.dictionary, parameter);
                    self.write(&pdo, &frame);
                }
            }
            for (place, parameter) in SENT.into_iter().enumerate() {
                let pdo = Pdo::of(&self.drive.dictionary, parameter);
                let (Some(id), Some(sent)) = (pdo.id, self.sent.get_mut(place)) else { continue };
                if pdo.kind > CYCLIC_MOST {
                    continue;
                }
                sent.syncs += 1;
                let is_due = sent.syncs >= pdo.kind;
                let data = data(&self.drive, &pdo);
                // Type 0: sent at the SYNC message after a change.
                if is_due && (pdo.kind != 0 || sent.last.as_ref() != Some(&data)) {
                    (sent.syncs, sent.last) = (0, Some(data.clone()));
                    self.send(id, &data);
                }
            }
        }
        if !self.steps_with_sync {
            return 0;
        }
        let period = crate::scale::bounded(self.drive.period_s() / HALF_MS_S, 1, SYNC_MOST);
        u64::try_from(period).unwrap_or(1)
    }

    /// Sends the PDOs triggered by a change or by their timer.
    fn send_events(&mut self) {
        let now = self.drive.ticks();
        for (place, parameter) in SENT.into_iter().enumerate() {
            let pdo = Pdo::of(&self.drive.dictionary, parameter);
            // Both in ticks of half a millisecond: 0.1 ms rounded up, and milliseconds.
            let inhibit = self.number(parameter, 3).div_ceil(5);
            let timer = 2 * self.number(parameter, 5);
            let (Some(id), Some(sent)) = (pdo.id, self.sent.get_mut(place)) else { continue };
            if pdo.kind <= CYCLIC_MOST || (sent.last.is_some() && now < sent.at_tick + inhibit) {
                continue;
            }
            let data = data(&self.drive, &pdo);
            let has_changed = sent.last.as_ref() != Some(&data);
            if has_changed || (timer > 0 && now >= sent.at_tick + timer) {
                (sent.at_tick, sent.last) = (now, Some(data.clone()));
                self.send(id, &data);
            }
        }
    }
}

/// Upper limit of the steps triggered by one SYNC message: ten seconds.
const SYNC_MOST: i64 = 20_000;

/// Returns the present data of a PDO.
fn data(drive: &Drive<'_>, pdo: &Pdo) -> Vec<u8> {
    let bytes = |at: &crate::Address| match (drive.read(*at), drive.dictionary.entry(*at)) {
        (Ok(Value::Number(number)), Ok(entry)) => parts::bytes(entry.data_type, number),
        _ => Vec::new(),
    };
    pdo.objects.iter().flat_map(bytes).collect()
}
