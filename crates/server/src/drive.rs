//! The virtual drive over TCP: connections on the loopback to one drive, and its clock.

mod places;

use crate::owner::Owners;
use crate::serve::{Unserved, end_requested, listening};
pub use places::CLIENTS_MOST;
use places::{Client, SILENT_MOST, leaving, silent_leaving};
use questions::drive::line::{self, Answer, LINE_MOST};
use questions::drive::room::Drive;
use questions::drive::{CanNode, Frame, HALF_MS_S, Time, socketcand};
use std::collections::{BTreeMap, VecDeque};
use std::future::Future;
use std::io::ErrorKind;
use std::net::{Ipv4Addr, SocketAddr, TcpListener};
use std::pin::pin;
use std::time::{Duration, Instant};
use tokio::net::TcpStream;
use tokio::sync::{mpsc, oneshot};

/// Protocol between a client and the drive.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DriveProtocol {
    /// Lines of text.
    #[default]
    Line,
    /// CAN frames in the protocol of socketcand.
    SocketCand,
}

impl DriveProtocol {
    /// Both protocols.
    pub const ALL: [Self; 2] = [Self::Line, Self::SocketCand];

    /// Returns the identifier.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Line => "line",
            Self::SocketCand => "socketcand",
        }
    }

    /// Returns the protocol of an identifier.
    #[must_use]
    pub fn of(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|protocol| protocol.id() == id)
    }

    /// Returns the largest number of bytes of a request.
    const fn request_most(self) -> usize {
        match self {
            Self::Line => LINE_MOST,
            Self::SocketCand => socketcand::MESSAGE_MOST,
        }
    }
}

/// Time limit of the first request of a client.
const FIRST_TIME: Duration = Duration::from_secs(60);

/// Time limit for sending an answer.
const WRITE_TIME: Duration = Duration::from_secs(10);

/// Largest number of answers and frames that wait for a client; a slower client is disconnected.
const WAITING_MOST: usize = 2048;

/// Capacity of the queue from the connections to the drive.
const REPORTS_MOST: usize = 64;

/// Steps of the drive between two polls of the signals and the clients: 25 ms of the axis.
const SLICE: u64 = 50;

/// Polling interval of the clock.
const TICK: Duration = Duration::from_millis(1);

/// Largest number of steps at once: a simulation slower than the clock skips time.
const CATCH_UP_MOST: u64 = 40;

/// A drive that accepts connections.
pub struct DriveServer {
    listener: TcpListener,
    address: SocketAddr,
    protocol: DriveProtocol,
    time: Time,
}

/// Report of a connection.
enum Event {
    Opened(u64, mpsc::Sender<Vec<u8>>, SocketAddr),
    /// A request, and the sender that is dropped with its answer; the client sends its next request after that.
    Request(u64, Vec<u8>, oneshot::Sender<()>),
    Closed(u64),
}

/// A request that waits for its turn or is being answered.
struct Job {
    client: u64,
    request: Vec<u8>,
    /// Steps of the drive until the answer; `None` before the request is begun.
    left: Option<u64>,
    /// Dropped with the request.
    _answered: oneshot::Sender<()>,
}

impl DriveServer {
    /// Listens on the loopback only.
    ///
    /// # Errors
    /// [`Unserved`].
    pub fn bind(port: u16, protocol: DriveProtocol, time: Time) -> Result<Self, Unserved> {
        let (listener, address) = listening(SocketAddr::from((Ipv4Addr::LOCALHOST, port)))?;
        Ok(Self { listener, address, protocol, time })
    }

    /// Returns the address that it listens on.
    #[must_use]
    pub const fn address(&self) -> SocketAddr {
        self.address
    }

    /// Serves a drive until the program is terminated.
    ///
    /// # Errors
    /// When the system provides no means to wait for connections.
    pub fn run(self, drive: Drive<'_>, node: u8) -> Result<(), Unserved> {
        let runtime = tokio::runtime::Builder::new_current_thread()
            .enable_io()
            .enable_time()
            .build()
            .map_err(Unserved::System)?;
        let served = runtime.block_on(async {
            let listener = tokio::net::TcpListener::from_std(self.listener).map_err(Unserved::System)?;
            let bench = Bench::new(drive, node, self.protocol, self.time);
            serve(listener, bench, end_requested()).await;
            Ok(())
        });
        runtime.shutdown_background();
        served
    }
}

/// The drive behind its protocol.
enum Device<'a> {
    Line(Box<Drive<'a>>),
    Node(Box<CanNode<'a>>),
}

/// Disconnection of a client, by itself or by the drive.
struct Leaves;

/// The drive with its clients and its clock.
struct Bench<'a> {
    device: Device<'a>,
    time: Time,
    clients: BTreeMap<u64, Client>,
    /// Requests in the order of their arrival, at most one of each client.
    jobs: VecDeque<Job>,
    begun: Instant,
    steps: u64,
}

impl<'a> Bench<'a> {
    fn new(mut drive: Drive<'a>, node: u8, protocol: DriveProtocol, time: Time) -> Self {
        // The state machine has started before the first client connects.
        drive.advance(2);
        let device = match protocol {
            DriveProtocol::Line => Device::Line(Box::new(drive)),
            DriveProtocol::SocketCand => Device::Node(Box::new(CanNode::new(drive, node, time == Time::Stepped))),
        };
        Self { device, time, clients: BTreeMap::new(), jobs: VecDeque::new(), begun: Instant::now(), steps: 0 }
    }

    const fn protocol(&self) -> DriveProtocol {
        match self.device {
            Device::Line(_) => DriveProtocol::Line,
            Device::Node(_) => DriveProtocol::SocketCand,
        }
    }

    /// Advances the drive to the time of the clock.
    fn follow_clock(&mut self) {
        if self.time == Time::Stepped {
            return;
        }
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a time that has passed")]
        let due = (self.begun.elapsed().as_secs_f64() / HALF_MS_S) as u64;
        let steps = due.saturating_sub(self.steps).min(CATCH_UP_MOST);
        // Steps beyond the limit are skipped.
        self.steps = due;
        match &mut self.device {
            Device::Line(drive) => drive.advance(steps),
            Device::Node(node) => node.advance(steps),
        }
        self.send_frames();
    }

    fn handle(&mut self, event: Event) {
        match event {
            Event::Opened(id, out, peer) => {
                if self.protocol() == DriveProtocol::SocketCand {
                    let _ = out.try_send(socketcand::HI.into());
                }
                self.clients.insert(id, Client { out, is_known: false, heard: Instant::now(), peer });
            }
            Event::Closed(id) => {
                self.clients.remove(&id);
                self.jobs.retain(|job| job.client != id);
            }
            Event::Request(client, request, answered) => {
                self.jobs.push_back(Job { client, request, left: None, _answered: answered });
            }
        }
    }

    /// Returns `true` if there is a place for a new connection; disconnects the oldest silent one if necessary.
    fn has_place(&mut self, peer: SocketAddr) -> bool {
        if self.clients.len() - self.known() >= SILENT_MOST
            && let Some(id) = silent_leaving(&self.clients)
        {
            self.handle(Event::Closed(id));
        }
        self.known() < CLIENTS_MOST || self.leaving(&Owners::read(), peer).is_some()
    }

    /// Returns the number of clients that have made a request.
    fn known(&self) -> usize {
        self.clients.values().filter(|client| client.is_known).count()
    }

    /// Returns the client that leaves for a new one.
    fn leaving(&self, owners: &Owners, peer: SocketAddr) -> Option<u64> {
        leaving(&self.clients, |peer| owners.user_of(peer), owners.user_of(peer), owners.own())
    }

    /// Begins a request. The first one of a connection makes it a client, which may replace another; without a place it is
    /// not begun.
    fn begin_first(&mut self, id: u64, request: &[u8]) -> Result<u64, Leaves> {
        let Some(client) = self.clients.get(&id) else { return Err(Leaves) };
        let peer = client.peer;
        let leaving = if client.is_known || self.known() < CLIENTS_MOST {
            None
        } else {
            Some(self.leaving(&Owners::read(), peer).ok_or(Leaves)?)
        };
        let steps = self.begin(id, request)?;
        let is_client = self.clients.get(&id).is_some_and(|client| client.is_known);
        if let Some(other) = leaving.filter(|_| is_client) {
            self.handle(Event::Closed(other));
        }
        Ok(steps)
    }

    /// Works for one slice on the request at the head of the queue. A request that needs further steps is queued again
    /// behind those of the other clients: on a bus, all of them share the time.
    fn work(&mut self) {
        let Some(mut job) = self.jobs.pop_front() else { return };
        self.follow_clock();
        let left = match job.left {
            Some(left) => {
                let steps = left.min(SLICE);
                self.advance(steps);
                left - steps
            }
            None => match self.begin_first(job.client, &job.request) {
                Ok(steps) => steps,
                Err(Leaves) => {
                    self.clients.remove(&job.client);
                    return;
                }
            },
        };
        if left == 0 {
            if job.left.is_some() && !self.finish(job.client) {
                self.clients.remove(&job.client);
            }
            return;
        }
        job.left = Some(left);
        match self.device {
            Device::Line(_) => self.jobs.push_back(job),
            Device::Node(_) => self.jobs.push_front(job),
        }
    }

    fn advance(&mut self, steps: u64) {
        match &mut self.device {
            Device::Line(drive) => drive.advance(steps),
            Device::Node(node) => node.advance(steps),
        }
        self.send_frames();
    }

    /// Begins a request: answers it, or returns the number of steps before its answer.
    fn begin(&mut self, id: u64, request: &[u8]) -> Result<u64, Leaves> {
        let client = self.clients.get_mut(&id).ok_or(Leaves)?;
        let sent = |client: &Client, text: Vec<u8>| client.out.try_send(text).map_err(|_| Leaves);
        match &mut self.device {
            Device::Line(drive) => {
                let text = std::str::from_utf8(request).map_err(|_| Leaves)?;
                if let Some(steps) = line::steps_of(self.time, text) {
                    client.is_known = true;
                    client.heard = Instant::now();
                    return Ok(steps);
                }
                let answer = match line::answer(drive, self.time, text) {
                    Answer::Line(answer) => {
                        client.heard = Instant::now();
                        answer
                    }
                    Answer::Bye => return Err(Leaves),
                    // A browser sends something else first.
                    Answer::NoCommand | Answer::Wrong if !client.is_known => return Err(Leaves),
                    Answer::NoCommand => line::NO_COMMAND.to_owned(),
                    Answer::Wrong => line::WRONG.to_owned(),
                };
                client.is_known = true;
                sent(client, format!("{answer}\n").into_bytes())?;
            }
            Device::Node(node) => {
                let Ok(Some((message, _))) = socketcand::read(request) else { return Err(Leaves) };
                if message != socketcand::Message::Other {
                    client.heard = Instant::now();
                }
                match message {
                    socketcand::Message::Open => sent(client, socketcand::OK.into())?,
                    socketcand::Message::RawMode => {
                        client.is_known = true;
                        sent(client, socketcand::OK.into())?;
                    }
                    socketcand::Message::Echo => sent(client, b"< echo >".to_vec())?,
                    socketcand::Message::Other => {}
                    socketcand::Message::Send(_) if !client.is_known => return Err(Leaves),
                    socketcand::Message::Send(frame) => {
                        let time_s = node.drive().time_s();
                        let steps = node.accept(&frame);
                        // The other nodes on the bus receive the frame too.
                        self.broadcast(&[frame], time_s, Some(id));
                        self.send_frames();
                        return Ok(steps);
                    }
                }
            }
        }
        Ok(0)
    }

    /// Answers a request after its steps; returns `true` if the client stays connected.
    fn finish(&mut self, id: u64) -> bool {
        let Some(client) = self.clients.get_mut(&id) else { return true };
        client.heard = Instant::now();
        match &self.device {
            Device::Line(drive) => client.out.try_send(format!("{}\n", line::stepped(drive)).into_bytes()).is_ok(),
            // A frame has no answer.
            Device::Node(_) => true,
        }
    }

    fn send_frames(&mut self) {
        let Device::Node(node) = &mut self.device else { return };
        let (frames, time_s) = (node.take(), node.drive().time_s());
        self.broadcast(&frames, time_s, None);
    }

    fn broadcast(&mut self, frames: &[Frame], time_s: f64, except: Option<u64>) {
        if frames.is_empty() {
            return;
        }
        let texts: Vec<Vec<u8>> = frames.iter().map(|frame| socketcand::written(frame, time_s).into_bytes()).collect();
        self.clients.retain(|id, client| {
            !client.is_known
                || Some(*id) == except
                || texts.iter().all(|text| client.out.try_send(text.clone()).is_ok())
        });
    }
}

async fn serve(listener: tokio::net::TcpListener, mut bench: Bench<'_>, end: impl Future<Output = ()>) {
    let protocol = bench.protocol();
    let (report, mut events) = mpsc::channel::<Event>(REPORTS_MOST);
    let mut clock = tokio::time::interval(TICK);
    clock.set_missed_tick_behavior(tokio::time::MissedTickBehavior::Delay);
    let mut end = pin!(end);
    let mut next = 0_u64;
    loop {
        tokio::select! {
            biased;
            () = &mut end => break,
            // Signals and sockets are polled between two slices of work.
            () = tokio::task::yield_now() => {}
        }
        bench.work();
        tokio::select! {
            () = &mut end => break,
            Some(event) = events.recv() => bench.handle(event),
            accepted = listener.accept() => match accepted {
                Ok((stream, peer)) if bench.has_place(peer) => {
                    next += 1;
                    let (out, answers) = mpsc::channel(WAITING_MOST);
                    bench.handle(Event::Opened(next, out, peer));
                    drop(tokio::spawn(connection(stream, next, protocol, report.clone(), answers)));
                }
                Ok(_) => {}
                Err(_) => tokio::time::sleep(TICK).await,
            },
            _ = clock.tick(), if bench.time == Time::Real => bench.follow_clock(),
            () = std::future::ready(()), if !bench.jobs.is_empty() => {}
        }
    }
}

/// Serves one connection: passes its requests to the drive one by one, and the answers back.
async fn connection(
    stream: TcpStream,
    id: u64,
    protocol: DriveProtocol,
    report: mpsc::Sender<Event>,
    mut answers: mpsc::Receiver<Vec<u8>>,
) {
    let _ = stream.set_nodelay(true);
    let mut received = Vec::new();
    let mut is_first = true;
    let mut first_time = pin!(tokio::time::sleep(FIRST_TIME));
    let mut pending: Option<oneshot::Receiver<()>> = None;
    loop {
        if pending.is_none() {
            match first_request(protocol, &received) {
                Some(Ok(end)) => {
                    let request: Vec<u8> = received.drain(..end).collect();
                    let (answered, waits) = oneshot::channel();
                    is_first = false;
                    if report.send(Event::Request(id, request, answered)).await.is_err() {
                        break;
                    }
                    pending = Some(waits);
                }
                Some(Err(())) => break,
                None => {}
            }
        }
        tokio::select! {
            // The drive has disconnected the client; the last answer is still written.
            answer = answers.recv() => match answer {
                Some(answer) => match tokio::time::timeout(WRITE_TIME, written(&stream, &answer)).await {
                    Ok(true) => {}
                    Ok(false) | Err(_) => break,
                },
                None => break,
            },
            () = &mut first_time, if is_first => break,
            () = is_answered(&mut pending), if pending.is_some() => pending = None,
            ready = stream.readable(), if pending.is_none() => {
                if ready.is_err() || !taken(&stream, &mut received) {
                    break;
                }
            }
        }
    }
    let _ = report.send(Event::Closed(id)).await;
}

/// Waits until the drive has answered a request.
async fn is_answered(pending: &mut Option<oneshot::Receiver<()>>) {
    if let Some(waits) = pending {
        let _ = waits.await;
    }
}

/// Returns the length of the first request in the received bytes; `None` if it is incomplete, an error if it is
/// invalid.
fn first_request(protocol: DriveProtocol, received: &[u8]) -> Option<Result<usize, ()>> {
    match protocol {
        DriveProtocol::Line => match received.iter().position(|byte| *byte == b'\n') {
            Some(end) if end < protocol.request_most() => Some(Ok(end + 1)),
            None if received.len() < protocol.request_most() => None,
            Some(_) | None => Some(Err(())),
        },
        DriveProtocol::SocketCand => match socketcand::read(received) {
            Ok(Some((_, end))) => Some(Ok(end)),
            Ok(None) => None,
            Err(socketcand::NoMessage) => Some(Err(())),
        },
    }
}

/// Reads the received bytes; returns `true` while the connection is open.
fn taken(stream: &TcpStream, received: &mut Vec<u8>) -> bool {
    let mut some = [0; 1024];
    match stream.try_read(&mut some) {
        Ok(0) => false,
        Ok(count) => {
            received.extend(some.iter().take(count));
            true
        }
        Err(error) => error.kind() == ErrorKind::WouldBlock,
    }
}

/// Writes the whole text; returns `true` while the connection is open.
async fn written(stream: &TcpStream, mut text: &[u8]) -> bool {
    while !text.is_empty() {
        if stream.writable().await.is_err() {
            return false;
        }
        match stream.try_write(text) {
            Ok(count) => text = text.get(count..).unwrap_or_default(),
            Err(error) if error.kind() == ErrorKind::WouldBlock => {}
            Err(_) => return false,
        }
    }
    true
}
