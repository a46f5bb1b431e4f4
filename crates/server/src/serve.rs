//! The server itself: a place to listen, connections, and an end in good order.

use crate::answer::{Desk, Respond};
use crate::folder::Workplace;
use crate::lanes::Lanes;
use crate::limits::Limits;
use crate::token::{IN_QUERY, Token};
use hyper::server::conn::http1;
use hyper::service::service_fn;
use hyper_util::rt::{TokioIo, TokioTimer};
use quantities::Language;
use std::collections::BTreeMap;
use std::convert::Infallible;
use std::future::Future;
use std::io;
use std::net::{IpAddr, Ipv4Addr, SocketAddr, TcpListener};
use std::path::PathBuf;
use std::pin::pin;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;
use tokio::net::TcpStream;
use tokio::sync::{Notify, OwnedSemaphorePermit, Semaphore, watch};
use words::{file_trouble, serving};

/// Longest duration of a connection, so that slow clients do not keep a slot.
const CONNECTION_TIME: Duration = Duration::from_secs(600);

/// After a connection could not be taken, such as for want of handles: long enough for another to end.
const PAUSE: Duration = Duration::from_millis(50);

/// Who is answered.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Access {
    /// A client that sends the token, which is new at each start.
    #[default]
    WithToken,
    /// Every client that reaches the address: on the loopback all users and programs of the machine.
    Anyone,
}

/// Where and for whom is served.
#[derive(Clone, Debug)]
pub struct Options {
    /// The folder that is worked in.
    pub folder: PathBuf,
    /// The address to listen on; none for the loopback.
    pub listen: Option<IpAddr>,
    /// Who is answered.
    pub access: Access,
    /// The port; 0 takes a free one.
    pub port: u16,
    /// Bytes of memory for the recordings of one project.
    pub memory: u64,
    /// The default language.
    pub language: Language,
    /// What requests are held to.
    pub limits: Limits,
    /// What writes reports and forms; none without a typesetting engine.
    pub press: Option<page::Press>,
}

/// Why nothing is served.
#[derive(Debug)]
pub enum Unserved {
    /// The folder cannot be worked in.
    Folder(PathBuf, io::Error),
    /// The address cannot be listened on.
    Address(SocketAddr, io::Error),
    /// The system gives no randomness for a token.
    Token(io::Error),
    /// The system gives no means to wait for connections.
    System(io::Error),
}

impl Unserved {
    /// Why, in one sentence.
    #[must_use]
    pub fn message(&self, language: Language) -> String {
        match self {
            Self::Folder(path, error) => {
                serving::no_folder(&disk::path_text(path), &file_trouble(error, language), language)
            }
            Self::Address(address, error) if error.kind() == io::ErrorKind::AddrInUse => {
                serving::port_taken(&address.port(), language)
            }
            Self::Address(address, error) => serving::no_address(address, &file_trouble(error, language), language),
            Self::Token(error) => serving::no_token(&file_trouble(error, language), language),
            Self::System(error) => file_trouble(error, language),
        }
    }
}

/// A place to listen, and its address.
pub(crate) fn listening(asked: SocketAddr) -> Result<(TcpListener, SocketAddr), Unserved> {
    let bound = || {
        let listener = TcpListener::bind(asked)?;
        listener.set_nonblocking(true)?;
        let address = listener.local_addr()?;
        Ok((listener, address))
    };
    bound().map_err(|error| Unserved::Address(asked, error))
}

/// A server that listens already, so that its address is known before it serves.
pub struct Server {
    listener: TcpListener,
    desk: Desk,
}

impl Server {
    /// Listens.
    ///
    /// # Errors
    /// [`Unserved`].
    pub fn bind(options: Options) -> Result<Self, Unserved> {
        Self::with(options, page::respond)
    }

    fn with(options: Options, respond: Respond) -> Result<Self, Unserved> {
        let folder = std::fs::canonicalize(&options.folder)
            .and_then(|folder| std::fs::read_dir(&folder).map(|_| folder))
            .map_err(|error| Unserved::Folder(options.folder.clone(), error))?;
        let ip = options.listen.unwrap_or(IpAddr::V4(Ipv4Addr::LOCALHOST));
        let (listener, address) = listening(SocketAddr::new(ip, options.port))?;
        // The loopback is no exception: every user of the machine reaches it.
        let token = match options.access {
            Access::WithToken => Some(Token::new().map_err(Unserved::Token)?),
            Access::Anyone => None,
        };
        let workplace = Workplace::new(folder, options.memory, options.limits.answer_time, options.press);
        Ok(Self { listener, desk: Desk::new(address, token, options.language, options.limits, workplace, respond) })
    }

    /// Where it listens.
    #[must_use]
    pub const fn address(&self) -> SocketAddr {
        self.desk.address
    }

    /// The address for a browser, with the token where one is needed.
    #[must_use]
    pub fn url(&self) -> String {
        let mut address = self.desk.address;
        if address.ip().is_unspecified() {
            // Of all addresses of the machine the one that it has for itself.
            address.set_ip(IpAddr::V4(Ipv4Addr::LOCALHOST));
        }
        match &self.desk.token {
            Some(token) => format!("http://{address}/?{IN_QUERY}={}", token.text()),
            None => format!("http://{address}/"),
        }
    }

    /// Whether other machines reach it.
    #[must_use]
    pub const fn is_reachable_from_elsewhere(&self) -> bool {
        !self.desk.address.ip().is_loopback()
    }

    /// Who is answered.
    #[must_use]
    pub const fn access(&self) -> Access {
        if self.desk.token.is_some() { Access::WithToken } else { Access::Anyone }
    }

    /// Serves until the program is terminated.
    ///
    /// # Errors
    /// Where the system gives no means to wait for connections.
    pub fn run(self) -> Result<(), Unserved> {
        self.run_until(end_requested())
    }

    /// Serves until `end` comes; what has begun is finished within its time.
    ///
    /// # Errors
    /// Where the system gives no means to wait for connections.
    pub fn run_until(self, end: impl Future<Output = ()>) -> Result<(), Unserved> {
        let Self { listener, desk } = self;
        let runtime = tokio::runtime::Builder::new_current_thread()
            .enable_io()
            .enable_time()
            .max_blocking_threads(Lanes::threads(&desk.limits))
            .build()
            .map_err(Unserved::System)?;
        let end_time = desk.limits.end_time;
        let served = runtime.block_on(async {
            let listener = tokio::net::TcpListener::from_std(listener).map_err(Unserved::System)?;
            serve(listener, Arc::new(desk), end).await;
            Ok(())
        });
        // A save in progress is completed; a cancelled computation ends at its next step.
        runtime.shutdown_timeout(end_time);
        served
    }
}

/// The connections on which no request is being answered: idle ones, and those whose request is not complete. When every place
/// is taken a new connection takes the place of the one that has waited longest, so that half-sent requests do not hold others. Those
/// that never brought the token go first.
#[derive(Debug, Default)]
pub(crate) struct Idle(Mutex<Waiting>);

/// Idle connections by [`IdleKey`]: at most one entry for each connection.
#[derive(Debug, Default)]
struct Waiting {
    last: u64,
    all: BTreeMap<IdleKey, Arc<Notify>>,
}

/// Whether a connection has brought the token, and its number since it is idle.
type IdleKey = (bool, u64);

impl Idle {
    fn closes_longest(&self) {
        let idle = &mut *self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, close)) = idle.all.pop_first() {
            close.notify_one();
        }
    }
}

/// A connection in the list of idle ones.
#[derive(Debug)]
pub(crate) struct IdleSlot {
    all: Arc<Idle>,
    close: Arc<Notify>,
    /// Its place while it is idle, and whether it has brought the token.
    state: Mutex<(Option<IdleKey>, bool)>,
}

impl IdleSlot {
    fn new(all: &Arc<Idle>) -> Self {
        let place = Self { all: Arc::clone(all), close: Arc::default(), state: Mutex::default() };
        place.idle();
        place
    }

    /// No request is being answered any more. A request that was turned away never was busy: the connection keeps its place among those
    /// that wait, so that a client that only asks is not younger than one that is silent.
    fn idle(&self) {
        let (place, is_known) = &mut *self.state.lock().unwrap_or_else(PoisonError::into_inner);
        if place.is_some() {
            return;
        }
        let idle = &mut *self.all.0.lock().unwrap_or_else(PoisonError::into_inner);
        idle.last += 1;
        let key = (*is_known, idle.last);
        let _ = idle.all.insert(key, Arc::clone(&self.close));
        *place = Some(key);
    }

    /// A request with the token is complete: its answer is not interrupted.
    pub(crate) fn busy(&self) {
        let (place, is_known) = &mut *self.state.lock().unwrap_or_else(PoisonError::into_inner);
        *is_known = true;
        if let Some(key) = place.take() {
            let _ = self.all.0.lock().unwrap_or_else(PoisonError::into_inner).all.remove(&key);
        }
    }

    /// Completes when a new connection takes the place of this one.
    async fn closed(&self) {
        loop {
            self.close.notified().await;
            // A request may have become complete meanwhile.
            if self.state.lock().unwrap_or_else(PoisonError::into_inner).0.is_some() {
                return;
            }
        }
    }
}

impl Drop for IdleSlot {
    fn drop(&mut self) {
        self.busy();
    }
}

/// Takes connections until the end comes.
async fn serve(listener: tokio::net::TcpListener, desk: Arc<Desk>, end: impl Future<Output = ()>) {
    let (tell, ended) = watch::channel(());
    let most = desk.limits.connections.max(1);
    let connections = Arc::new(Semaphore::new(most));
    let idle = Arc::<Idle>::default();
    let mut end = pin!(end);
    loop {
        let next = async {
            let taken = listener.accept().await;
            loop {
                if connections.available_permits() == 0 {
                    idle.closes_longest();
                }
                // What was to be closed may have become busy: then another one is.
                let place = Arc::clone(&connections).acquire_owned();
                if let Ok(place) = tokio::time::timeout(PAUSE, place).await {
                    break (place, taken);
                }
            }
        };
        tokio::select! {
            () = &mut end => break,
            (place, taken) = next => match (place, taken) {
                (Ok(place), Ok((stream, _))) => {
                    let place = (place, IdleSlot::new(&idle));
                    drop(tokio::spawn(connection(stream, Arc::clone(&desk), ended.clone(), place)));
                }
                _ => tokio::time::sleep(PAUSE).await,
            },
        }
    }
    drop((listener, tell));
    let all = u32::try_from(most).unwrap_or(u32::MAX);
    let _ = tokio::time::timeout(desk.limits.end_time, connections.acquire_many(all)).await;
    desk.lanes.cancel_all();
}

/// Serves one connection: request by request until it ends, or the server does.
async fn connection(
    stream: TcpStream,
    desk: Arc<Desk>,
    mut ended: watch::Receiver<()>,
    (_permit, place): (OwnedSemaphorePermit, IdleSlot),
) {
    // Responses are small and latency matters; without this option it is slower.
    let _ = stream.set_nodelay(true);
    let limits = desk.limits;
    let place = Arc::new(place);
    let own = Arc::clone(&place);
    let service = service_fn(move |request| {
        let (desk, place) = (Arc::clone(&desk), Arc::clone(&own));
        async move {
            let answer = desk.answer(request, &place).await;
            place.idle();
            Ok::<_, Infallible>(answer)
        }
    });
    let connection = http1::Builder::new()
        .timer(TokioTimer::new())
        .header_read_timeout(limits.head_time)
        .max_buf_size(limits.head_bytes)
        .max_headers(limits.headers)
        .serve_connection(TokioIo::new(stream), service);
    let mut connection = pin!(connection);
    tokio::select! {
        // Errors of a connection are not reported: the client has disconnected.
        _ = &mut connection => return,
        _ = ended.changed() => {}
        () = place.closed() => return,
        () = tokio::time::sleep(CONNECTION_TIME) => {}
    }
    connection.as_mut().graceful_shutdown();
    let _ = tokio::time::timeout(limits.body_time + limits.answer_time, connection).await;
}

/// Completes when the program is terminated: by the keyboard, by closing its terminal, or by a signal.
#[cfg(unix)]
pub(crate) async fn end_requested() {
    use tokio::signal::unix::{SignalKind, signal};
    let ended = |kind| async move {
        match signal(kind) {
            Ok(mut signals) => drop(signals.recv().await),
            // Without a watch the signal ends the program as ever.
            Err(_) => std::future::pending().await,
        }
    };
    tokio::select! {
        () = ended(SignalKind::interrupt()) => {}
        () = ended(SignalKind::terminate()) => {}
        () = ended(SignalKind::hangup()) => {}
    }
}

/// Completes when the program is terminated by the keyboard.
#[cfg(not(unix))]
pub(crate) async fn end_requested() {
    let _ = tokio::signal::ctrl_c().await;
}

#[cfg(test)]
mod tests;
