//! The server: its address, connections, and an orderly shutdown.

use crate::answer::{Respond, Responder};
use crate::folder::Workplace;
use crate::idle::{Idle, IdleSlot};
use crate::lanes::Lanes;
use crate::limits::RequestLimits;
use crate::token::{IN_QUERY, Token};
use hyper::server::conn::http1;
use hyper::service::service_fn;
use hyper_util::rt::{TokioIo, TokioTimer};
use quantities::Language;
use std::convert::Infallible;
use std::future::Future;
use std::io;
use std::net::{IpAddr, Ipv4Addr, SocketAddr, TcpListener};
use std::path::PathBuf;
use std::pin::pin;
use std::sync::Arc;
use std::time::Duration;
use tokio::net::TcpStream;
use tokio::sync::{OwnedSemaphorePermit, Semaphore, watch};
use words::{file_trouble, serving};

/// Longest duration of a connection, so that slow clients do not keep a slot.
const CONNECTION_TIME: Duration = Duration::from_secs(600);

/// Pause after a connection could not be accepted, e.g. for lack of file handles; in it another one may end.
const PAUSE: Duration = Duration::from_millis(50);

/// Clients that are served.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Access {
    /// Clients that send the token, which is new at each start.
    #[default]
    WithToken,
    /// Every client that reaches the address: on the loopback all users and programs of the machine.
    Anyone,
}

/// Options of the server.
#[derive(Clone, Debug)]
pub struct Options {
    /// Working folder.
    pub folder: PathBuf,
    /// Address to listen on; `None` for the loopback.
    pub listen: Option<IpAddr>,
    /// Clients that are served.
    pub access: Access,
    /// Port; 0 selects a free one.
    pub port: u16,
    /// Bytes of memory for the recordings of one project.
    pub memory: u64,
    /// Default language.
    pub language: Language,
    /// Limits of requests.
    pub limits: RequestLimits,
    /// Writers of reports and forms; `None` without a typesetting engine.
    pub press: Option<page::Press>,
}

/// Reason why the server cannot run.
#[derive(Debug)]
pub enum Unserved {
    /// The working folder is not accessible.
    Folder(PathBuf, io::Error),
    /// The address cannot be used for listening.
    Address(SocketAddr, io::Error),
    /// The system provides no randomness for a token.
    Token(io::Error),
    /// The system provides no means to wait for connections.
    System(io::Error),
}

impl Unserved {
    /// Returns the reason in one sentence.
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

/// Number of connections that wait for their acceptance.
#[cfg(unix)]
const BACKLOG: i32 = 4096;

/// Opens a listener and returns it with its address.
pub(crate) fn listening(asked: SocketAddr) -> Result<(TcpListener, SocketAddr), Unserved> {
    let bound = || {
        let listener = TcpListener::bind(asked)?;
        // Many connections at once overflow the queue of the standard library, and their senders wait for a second. The
        // system reduces the number to its own limit.
        #[cfg(unix)]
        rustix::net::listen(&listener, BACKLOG)?;
        listener.set_nonblocking(true)?;
        let address = listener.local_addr()?;
        Ok((listener, address))
    };
    bound().map_err(|error| Unserved::Address(asked, error))
}

/// A server that already listens, so that its address is known before it serves.
pub struct Server {
    listener: TcpListener,
    responder: Responder,
}

impl Server {
    /// Opens the listener.
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
        Ok(Self {
            listener,
            responder: Responder::new(address, token, options.language, options.limits, workplace, respond),
        })
    }

    /// Returns the address that it listens on.
    #[must_use]
    pub const fn address(&self) -> SocketAddr {
        self.responder.address
    }

    /// Returns the address for a browser, with the token if one is required.
    #[must_use]
    pub fn url(&self) -> String {
        let mut address = self.responder.address;
        if address.ip().is_unspecified() {
            // For all addresses of the machine: the loopback.
            address.set_ip(IpAddr::V4(Ipv4Addr::LOCALHOST));
        }
        match &self.responder.token {
            Some(token) => format!("http://{address}/?{IN_QUERY}={}", token.text()),
            None => format!("http://{address}/"),
        }
    }

    /// Returns `true` if other machines reach it.
    #[must_use]
    pub const fn is_reachable_from_elsewhere(&self) -> bool {
        !self.responder.address.ip().is_loopback()
    }

    /// Returns the clients that are served.
    #[must_use]
    pub const fn access(&self) -> Access {
        if self.responder.token.is_some() { Access::WithToken } else { Access::Anyone }
    }

    /// Serves until the program is terminated.
    ///
    /// # Errors
    /// When the system provides no means to wait for connections.
    pub fn run(self) -> Result<(), Unserved> {
        self.run_until(end_requested())
    }

    /// Serves until `end` completes; running requests are finished within their time limit.
    ///
    /// # Errors
    /// When the system provides no means to wait for connections.
    pub fn run_until(self, end: impl Future<Output = ()>) -> Result<(), Unserved> {
        let Self { listener, responder } = self;
        let runtime = tokio::runtime::Builder::new_current_thread()
            .enable_io()
            .enable_time()
            .max_blocking_threads(Lanes::threads(&responder.limits))
            .build()
            .map_err(Unserved::System)?;
        let end_time = responder.limits.end_time;
        let served = runtime.block_on(async {
            let listener = tokio::net::TcpListener::from_std(listener).map_err(Unserved::System)?;
            serve(listener, Arc::new(responder), end).await;
            Ok(())
        });
        // A save in progress is completed; a cancelled computation ends at its next step.
        runtime.shutdown_timeout(end_time);
        served
    }
}

/// Accepts connections until the end is requested.
async fn serve(listener: tokio::net::TcpListener, responder: Arc<Responder>, end: impl Future<Output = ()>) {
    let (tell, ended) = watch::channel(());
    let most = responder.limits.connections.max(1);
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
                // The connection to be closed may have become busy: then another one is closed.
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
                    drop(tokio::spawn(connection(stream, Arc::clone(&responder), ended.clone(), place)));
                }
                _ => tokio::time::sleep(PAUSE).await,
            },
        }
    }
    drop((listener, tell));
    let all = u32::try_from(most).unwrap_or(u32::MAX);
    let _ = tokio::time::timeout(responder.limits.end_time, connections.acquire_many(all)).await;
    responder.lanes.cancel_all();
}

/// Serves one connection: request by request until it or the server ends.
async fn connection(
    stream: TcpStream,
    responder: Arc<Responder>,
    mut ended: watch::Receiver<()>,
    (_permit, place): (OwnedSemaphorePermit, IdleSlot),
) {
    // Responses are small and latency matters; Nagle's algorithm would delay them.
    let _ = stream.set_nodelay(true);
    let limits = responder.limits;
    let place = Arc::new(place);
    let own = Arc::clone(&place);
    let service = service_fn(move |request| {
        let (responder, place) = (Arc::clone(&responder), Arc::clone(&own));
        async move {
            let answer = responder.answer(request, &place).await;
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
            // Without a handler the signal ends the program as usual.
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
