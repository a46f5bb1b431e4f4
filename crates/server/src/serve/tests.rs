use super::*;
use page::{Call, Reply, Shell};
use questions::Progress;
use std::io::{Read, Write};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::Instant;
use tokio::sync::oneshot;

/// A server that lives as long as its test.
struct Up {
    address: SocketAddr,
    url: String,
    end: Option<oneshot::Sender<()>>,
    thread: Option<std::thread::JoinHandle<()>>,
    _folder: tempfile::TempDir,
}

impl Drop for Up {
    fn drop(&mut self) {
        drop(self.end.take());
        if let Some(thread) = self.thread.take() {
            thread.join().unwrap();
        }
    }
}

fn up(respond: Respond, access: Access, limits: RequestLimits) -> Up {
    listening(respond, None, access, limits)
}

fn listening(respond: Respond, listen: Option<IpAddr>, access: Access, limits: RequestLimits) -> Up {
    let folder = tempfile::tempdir().unwrap();
    let options = Options {
        folder: folder.path().to_owned(),
        listen,
        access,
        port: 0,
        memory: 1 << 20,
        language: Language::default(),
        limits,
        press: None,
    };
    let server = Server::with(options, respond).unwrap();
    let (address, url) = (server.address(), server.url());
    let (end, ended) = oneshot::channel();
    let thread = std::thread::spawn(move || server.run_until(async { drop(ended.await) }).unwrap());
    Up { address, url, end: Some(end), thread: Some(thread), _folder: folder }
}

impl Up {
    fn connect(&self) -> std::net::TcpStream {
        let mut address = self.address;
        if address.ip().is_unspecified() {
            address.set_ip(IpAddr::V4(Ipv4Addr::LOCALHOST));
        }
        let stream = std::net::TcpStream::connect(address).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(20))).unwrap();
        stream
    }

    /// Returns the reply to a request with further headers.
    fn ask(&self, line: &str, headers: &str) -> String {
        let mut stream = self.connect();
        let host = if self.address.ip().is_unspecified() {
            format!("127.0.0.1:{}", self.address.port())
        } else {
            self.address.to_string()
        };
        write!(stream, "{line} HTTP/1.1\r\nhost: {host}\r\nconnection: close\r\n{headers}\r\n").unwrap();
        let mut answer = String::new();
        let _ = stream.read_to_string(&mut answer);
        answer
    }
}

fn short() -> RequestLimits {
    RequestLimits {
        answer_time: Duration::from_millis(300),
        head_time: Duration::from_millis(300),
        body_time: Duration::from_millis(300),
        computed: 1,
        waiting: 1,
        end_time: Duration::from_millis(500),
        ..RequestLimits::default()
    }
}

fn panics(call: &Call<'_>, _: &dyn Shell, _: &Progress) -> Reply {
    assert!(call.path != "/panics", "the secret of the request");
    Reply::text(200, "here")
}

/// Internal errors are not disclosed, and the next request is answered.
#[test]
fn a_fault_inside_is_an_answer_without_detail() {
    let up = up(panics, Access::Anyone, RequestLimits::default());
    let answer = up.ask("GET /panics", "");
    assert!(answer.starts_with("HTTP/1.1 500 "), "{answer}");
    assert!(answer.contains("internal error") && !answer.contains("secret"), "{answer}");
    assert!(up.ask("GET /", "").starts_with("HTTP/1.1 200 "));
}

static STOPPED: AtomicUsize = AtomicUsize::new(0);

/// Works until it is cancelled.
fn endless(call: &Call<'_>, _: &dyn Shell, progress: &Progress) -> Reply {
    while call.path != "/" && !progress.is_over() {
        std::thread::sleep(Duration::from_millis(5));
    }
    if call.path != "/" {
        STOPPED.fetch_add(1, Ordering::SeqCst);
    }
    Reply::text(200, "here")
}

/// One test for both: they count the same work.
#[test]
fn work_that_nobody_waits_for_ends() {
    let waited = |count: usize| {
        let begun = Instant::now();
        while STOPPED.load(Ordering::SeqCst) < count && begun.elapsed() < Duration::from_secs(10) {
            std::thread::sleep(Duration::from_millis(5));
        }
        STOPPED.load(Ordering::SeqCst)
    };
    let up_short = up(endless, Access::Anyone, short());
    let answer = up_short.ask("GET /long", "");
    assert!(answer.starts_with("HTTP/1.1 503 ") && answer.contains("not answered within"), "{answer}");
    assert_eq!(waited(1), 1, "the time is over");
    drop(up_short);
    // The client disconnects long before the time limit.
    let up_long = up(
        endless,
        Access::Anyone,
        RequestLimits { answer_time: Duration::from_secs(60), computed: 1, ..RequestLimits::default() },
    );
    let mut stream = up_long.connect();
    write!(stream, "GET /long HTTP/1.1\r\nhost: 127.0.0.1:{}\r\n\r\n", up_long.address.port()).unwrap();
    std::thread::sleep(Duration::from_millis(200));
    assert_eq!(STOPPED.load(Ordering::SeqCst), 1);
    drop(stream);
    assert_eq!(waited(2), 2, "the client has gone");
    assert!(up_long.ask("GET /", "").starts_with("HTTP/1.1 200 "));
}

static GATE: Mutex<()> = Mutex::new(());
static INSIDE: AtomicUsize = AtomicUsize::new(0);
static MOST_INSIDE: AtomicUsize = AtomicUsize::new(0);

fn slow(_: &Call<'_>, _: &dyn Shell, _: &Progress) -> Reply {
    let now = INSIDE.fetch_add(1, Ordering::SeqCst) + 1;
    MOST_INSIDE.fetch_max(now, Ordering::SeqCst);
    drop(GATE.lock().unwrap_or_else(PoisonError::into_inner));
    INSIDE.fetch_sub(1, Ordering::SeqCst);
    Reply::text(200, "here")
}

#[test]
fn so_many_are_computed_so_many_wait_and_the_rest_is_reported_to_come_again() {
    let limits =
        RequestLimits { computed: 2, waiting: 3, short_time: Duration::from_secs(60), ..RequestLimits::default() };
    let up = up(slow, Access::Anyone, limits);
    let held = GATE.lock().unwrap();
    let answers: Vec<String> = std::thread::scope(|scope| {
        let asked: Vec<_> = (0..12).map(|_| scope.spawn(|| up.ask("GET /", ""))).collect();
        let begun = Instant::now();
        while asked.iter().filter(|one| one.is_finished()).count() < 7 && begun.elapsed() < Duration::from_secs(10) {
            std::thread::sleep(Duration::from_millis(5));
        }
        // Health is answered regardless of the queue.
        drop(held);
        asked.into_iter().map(|one| one.join().unwrap()).collect()
    });
    let busy = answers.iter().filter(|answer| answer.starts_with("HTTP/1.1 503 ") && answer.contains("retry-after: 1"));
    assert_eq!(busy.count(), 7, "{answers:?}");
    assert_eq!(answers.iter().filter(|answer| answer.starts_with("HTTP/1.1 200 ")).count(), 5);
    assert_eq!(MOST_INSIDE.load(Ordering::SeqCst), 2);
}

#[test]
fn slow_heads_and_slow_bodies_are_not_waited_for() {
    let up = up(panics, Access::Anyone, short());
    let mut stream = up.connect();
    write!(stream, "GET / HTTP/1.1\r\nhost: ").unwrap();
    let (begun, mut answer) = (Instant::now(), String::new());
    let _ = stream.read_to_string(&mut answer);
    assert!(begun.elapsed() < Duration::from_secs(5) && !answer.contains("200"), "{answer}");
    let answer = up.ask("POST /", "content-length: 10\r\n");
    assert!(answer.starts_with("HTTP/1.1 408 "), "{answer}");
}

#[test]
fn on_every_address_a_token_is_needed() {
    for listen in ["127.0.0.1", "127.0.0.2", "0.0.0.0"] {
        needs_a_token(listen.parse().unwrap());
    }
}

fn needs_a_token(listen: IpAddr) {
    let up = listening(panics, Some(listen), Access::default(), RequestLimits::default());
    let (_, token) = up.url.split_once("/?token=").unwrap();
    let bearer = format!("authorization: Bearer {token}\r\n");
    for line in ["GET /", "GET /health", "GET /api/v1/size", "POST /work", "GET /?token=0", "POST /?token="] {
        assert!(up.ask(line, "").starts_with("HTTP/1.1 401 "), "{line}");
        assert!(up.ask(line, &bearer).starts_with("HTTP/1.1 200 "), "{line}");
    }
    for line in [format!("GET /?token={token}"), format!("POST /work?a=b&token={token}")] {
        assert!(up.ask(&line, "").starts_with("HTTP/1.1 200 "), "{line}");
    }
    assert!(up.ask("GET /assets/page.css", "").starts_with("HTTP/1.1 200 "), "it is the same for everyone");
    assert!(up.ask("POST /assets/page.css", "").starts_with("HTTP/1.1 401 "));
}

/// Replies with path and query of the call.
fn repeats(call: &Call<'_>, _: &dyn Shell, _: &Progress) -> Reply {
    Reply::text(200, &format!("{} {}", call.path, call.query))
}

/// A browser sends cookies to every port of a host, so to a server of another user: none is set, and none opens anything.
#[test]
fn no_cookie_is_set_and_none_is_taken() {
    let up = up(repeats, Access::default(), RequestLimits::default());
    let (_, token) = up.url.split_once("/?token=").unwrap();
    let page = "accept: text/html,*/*;q=0.8\r\n";
    let bearer = format!("authorization: Bearer {token}\r\n{page}");
    let cookies = ["antrieb_token", &format!("antrieb_token_{}", up.address.port()), "token"]
        .map(|name| format!("cookie: {name}={token}\r\n{page}"));
    let lines = ["GET /", "GET /?open=axis.toml", "POST /work", "GET /api/v1/code/list", "GET /assets/enter.js"];
    let with_token = lines.map(|line| format!("{line}{}token={token}", if line.contains('?') { '&' } else { '?' }));
    for line in lines.iter().copied().chain(with_token.iter().map(String::as_str)) {
        for headers in cookies.iter().chain([&bearer, &page.to_owned()]) {
            let answer = up.ask(line, headers).to_lowercase();
            assert!(!answer.contains("set-cookie") && !answer.contains("location:"), "{line}: {answer}");
            assert!(!answer.contains(token), "{line}: what is answered does not hold the token: {answer}");
            let is_open = headers == &bearer || line.contains("token=") || line.contains("/assets/");
            assert_eq!(!answer.starts_with("http/1.1 401 "), is_open, "{line}: {answer}");
        }
    }
    let shown = up.ask(&format!("GET /?a=b&token={token}&c=d"), page);
    assert!(shown.ends_with("/ a=b&c=d"), "the question does not hold the token: {shown}");
    // A browser that opens a page without it gets the script that sends the kept token, and nothing else.
    let locked = up.ask("GET /", page);
    assert!(locked.contains("text/html") && locked.contains("/assets/enter.js"), "{locked}");
    assert!(!up.ask("GET /", "accept: */*\r\n").contains("text/html"));
}

/// Requests that are turned away, then more idle connections than there are places: the user is answered at once.
#[test]
fn a_stranger_without_the_token_does_not_slow_the_user() {
    let limits = RequestLimits { connections: 64, ..RequestLimits::default() };
    let up = up(repeats, Access::default(), limits);
    let (_, token) = up.url.split_once("/?token=").unwrap();
    let bearer = format!("authorization: Bearer {token}\r\n");
    let mut stream = up.connect();
    let request = format!("GET /health HTTP/1.1\r\nhost: {}\r\n\r\n", up.address);
    let mut piece = vec![0; 1 << 16];
    for _ in 0..40 {
        stream.write_all(request.repeat(50).as_bytes()).unwrap();
        let mut answers: Vec<u8> = Vec::new();
        while answers.windows(12).filter(|part| part == b"HTTP/1.1 401").count() < 50 {
            let read = stream.read(&mut piece).unwrap();
            assert!(read > 0, "closed");
            answers.extend(&piece[..read]);
        }
    }
    let idle: Vec<std::net::TcpStream> = (0..90).map(|_| up.connect()).collect();
    let begun = Instant::now();
    assert!(up.ask("GET /health", &bearer).starts_with("HTTP/1.1 200 "));
    // Well before the idle ones time out by themselves.
    assert!(begun.elapsed() < limits.head_time / 2, "{:?}", begun.elapsed());
    drop(idle);
}

/// Bodies that a stranger sends to the files that are open to all, whole or in part, are not awaited and take no memory from those
/// of the user.
#[test]
fn a_stranger_without_the_token_sends_no_body() {
    let limits = RequestLimits { bodies_bytes: 1 << 20, ..RequestLimits::default() };
    let up = up(repeats, Access::default(), limits);
    let (_, token) = up.url.split_once("/?token=").unwrap();
    let bearer = format!("authorization: Bearer {token}\r\ncontent-length: 1000\r\n\r\n{}", "x".repeat(1000));
    let begun = Instant::now();
    let mut held = Vec::new();
    for (line, how) in ["GET", "HEAD"]
        .iter()
        .flat_map(|line| ["content-length: 1000000", "transfer-encoding: chunked"].map(|how| (line, how)))
    {
        for _ in 0..4 {
            let mut stream = up.connect();
            let head = format!("{line} /assets/enter.js HTTP/1.1\r\nhost: {}\r\n{how}\r\n\r\n", up.address);
            let piece = if how.starts_with("transfer") {
                format!("f4000\r\n{}", "x".repeat(0xf4000))
            } else {
                "x".repeat(999_999)
            };
            // The server may close while the body is sent.
            let _ = stream.write_all(head.as_bytes()).and_then(|()| stream.write_all(piece.as_bytes()));
            let mut answer = [0; 12];
            if stream.read_exact(&mut answer).is_ok() {
                assert_eq!(&answer, b"HTTP/1.1 413", "{line} {how}");
            }
            held.push(stream);
        }
        assert!(up.ask("POST /api/v1/size", &bearer).starts_with("HTTP/1.1 200 "), "{line} {how}");
    }
    assert!(begun.elapsed() < Duration::from_secs(5), "{:?}", begun.elapsed());
    assert!(up.ask("GET /assets/enter.js", "").starts_with("HTTP/1.1 200 "), "without a body it is answered");
}

static MADE: AtomicUsize = AtomicUsize::new(0);

/// Counts how often a file is made.
fn made(_: &Call<'_>, _: &dyn Shell, _: &Progress) -> Reply {
    MADE.fetch_add(1, Ordering::Relaxed);
    Reply::text(200, &"a rule of the style\n".repeat(400))
}

/// A file that is open to all is made when it is first requested, by strangers and users alike; another path is another file.
#[test]
fn an_open_file_is_made_once() {
    let up = up(made, Access::default(), RequestLimits::default());
    for _ in 0..5 {
        for line in ["GET /assets/page.css", "HEAD /assets/page.css", "GET /assets/p%61ge.css"] {
            assert!(up.ask(line, "").starts_with("HTTP/1.1 200 "), "{line}");
        }
    }
    assert_eq!(MADE.load(Ordering::Relaxed), 1);
    assert!(up.ask("GET /theory/gear.html", "").starts_with("HTTP/1.1 200 "));
    assert_eq!(MADE.load(Ordering::Relaxed), 2);
}

static BEGUN: AtomicUsize = AtomicUsize::new(0);
static ENOUGH: AtomicBool = AtomicBool::new(false);

/// A long work ends when it is enough or when it is cancelled.
fn long_or_short(call: &Call<'_>, _: &dyn Shell, progress: &Progress) -> Reply {
    if call.path == "/short" {
        return Reply::text(200, "short");
    }
    BEGUN.fetch_add(1, Ordering::SeqCst);
    while !ENOUGH.load(Ordering::SeqCst) {
        if progress.is_over() {
            return Reply::text(503, "cancelled");
        }
        std::thread::sleep(Duration::from_millis(5));
    }
    Reply::text(200, "long")
}

/// Three long works on a server of one worker: the short ones are answered meanwhile, and in the end each long one has its answer.
#[test]
fn long_works_do_not_keep_a_short_one_waiting() {
    let limits = RequestLimits { computed: 1, short_time: Duration::from_millis(100), ..RequestLimits::default() };
    let up = up(long_or_short, Access::Anyone, limits);
    std::thread::scope(|scope| {
        let long: Vec<_> = (0..3).map(|_| scope.spawn(|| up.ask("GET /long", ""))).collect();
        let begun = Instant::now();
        while BEGUN.load(Ordering::SeqCst) < 3 {
            assert!(begun.elapsed() < Duration::from_secs(10), "each has begun");
            std::thread::sleep(Duration::from_millis(5));
        }
        for _ in 0..3 {
            let begun = Instant::now();
            assert!(up.ask("GET /short", "").ends_with("short"));
            assert!(begun.elapsed() < Duration::from_secs(2), "{:?}", begun.elapsed());
        }
        assert!(long.iter().all(|one| !one.is_finished()));
        ENOUGH.store(true, Ordering::SeqCst);
        for one in long {
            assert!(one.join().unwrap().ends_with("long"));
        }
    });
    assert_eq!(BEGUN.load(Ordering::SeqCst), 5, "two were begun again");
}

static FINISHED: AtomicBool = AtomicBool::new(false);

fn takes_a_while(_: &Call<'_>, _: &dyn Shell, _: &Progress) -> Reply {
    std::thread::sleep(Duration::from_millis(300));
    FINISHED.store(true, Ordering::SeqCst);
    Reply::text(200, "here")
}

#[test]
fn what_has_begun_is_finished_when_the_end_comes() {
    let up = up(takes_a_while, Access::Anyone, RequestLimits::default());
    let mut stream = up.connect();
    write!(stream, "GET / HTTP/1.1\r\nhost: 127.0.0.1:{}\r\n\r\n", up.address.port()).unwrap();
    std::thread::sleep(Duration::from_millis(100));
    drop(up);
    assert!(FINISHED.load(Ordering::SeqCst));
    let mut answer = String::new();
    let _ = stream.read_to_string(&mut answer);
    assert!(answer.starts_with("HTTP/1.1 200 "), "{answer}");
}

/// A work that runs until it is stopped and returns the reason; else the list of known works.
fn named(call: &Call<'_>, shell: &dyn Shell, progress: &Progress) -> Reply {
    let work = call.field("work").unwrap_or_default();
    match call.path {
        page::PROGRESS => Reply::text(if shell.progress(&work).is_some() { 200 } else { 404 }, ""),
        page::CANCEL => Reply::text(if shell.cancel(&work) { 200 } else { 404 }, ""),
        _ => {
            while !progress.is_over() {
                std::thread::sleep(Duration::from_millis(5));
            }
            Reply::text(200, if progress.is_late() { "late" } else { "cancelled" })
        }
    }
}

/// A named work returns its partial state on a timeout; it is cancelled by its name while all workers are busy.
#[test]
fn a_work_with_a_name_is_followed_and_cancelled() {
    let up_short = up(named, Access::Anyone, short());
    let answer = up_short.ask("GET /long", "x-work: a-1\r\n");
    assert!(answer.starts_with("HTTP/1.1 200 ") && answer.ends_with("late"), "{answer}");
    assert!(up_short.ask("GET /long", "x-work: ../a\r\n").starts_with("HTTP/1.1 503 "), "no name of a work");
    drop(up_short);
    let up_long = up(named, Access::Anyone, RequestLimits { computed: 1, waiting: 1, ..RequestLimits::default() });
    assert!(up_long.ask("GET /progress?work=a-1", "").starts_with("HTTP/1.1 404 "));
    std::thread::scope(|scope| {
        let long = scope.spawn(|| up_long.ask("GET /long", "x-work: a-1\r\n"));
        let begun = Instant::now();
        while !up_long.ask("GET /progress?work=a-1", "").starts_with("HTTP/1.1 200 ") {
            assert!(begun.elapsed() < Duration::from_secs(10), "the work has begun");
        }
        assert!(up_long.ask("GET /cancel?work=b", "").starts_with("HTTP/1.1 404 "));
        assert!(up_long.ask("GET /cancel?work=a-1", "").starts_with("HTTP/1.1 200 "));
        let answer = long.join().unwrap();
        assert!(answer.starts_with("HTTP/1.1 200 ") && answer.ends_with("cancelled"), "{answer}");
    });
    assert!(up_long.ask("GET /progress?work=a-1", "").starts_with("HTTP/1.1 404 "), "it has ended");
}
