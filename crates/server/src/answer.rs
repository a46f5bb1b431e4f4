//! From a request to its answer: let in, read, computed beside the others, sent back.

use crate::body::{Bodies, Held, NoBody, read};
use crate::folder::Workplace;
use crate::gate::{Barred, admit, preferred};
use crate::limits::Limits;
use crate::pack::sent;
use crate::serve::IdleSlot;
use crate::token::{IN_QUERY, Token};
use bytes::Bytes;
use http_body_util::Full;
use hyper::body::Incoming;
use hyper::header::CONTENT_TYPE;
use hyper::http::request::Parts;
use hyper::{Method, Request, Response};
use page::{Call, Reply, Shell};
use percent_encoding::percent_decode_str;
use quantities::Language;
use questions::Patience;
use std::net::SocketAddr;
use std::pin::pin;
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::Semaphore;
use words::requests;

/// What answers a call.
pub(crate) type Respond = fn(&Call<'_>, &dyn Shell, &Patience) -> Reply;

/// What all connections share.
pub(crate) struct Desk {
    pub(crate) address: SocketAddr,
    pub(crate) token: Option<Token>,
    pub(crate) language: Language,
    pub(crate) limits: Limits,
    pub(crate) respond: Respond,
    workplace: Arc<Workplace>,
    bodies: Bodies,
    /// Answers that may be computed at the same time.
    turns: Arc<Semaphore>,
    /// Questions that may wait for that.
    places: Arc<Semaphore>,
}

/// Headers of every response: no external resources, no framing, no caching, no access for other sites.
const HEADERS: [(&str, &str); 7] = [
    (
        "content-security-policy",
        "default-src 'self'; img-src 'self' data:; style-src 'self'; script-src 'self'; frame-ancestors 'none'; \
         base-uri 'none'; form-action 'self'",
    ),
    ("x-content-type-options", "nosniff"),
    ("x-frame-options", "DENY"),
    ("referrer-policy", "same-origin"),
    ("cross-origin-opener-policy", "same-origin"),
    ("cross-origin-resource-policy", "same-origin"),
    ("permissions-policy", "camera=(), geolocation=(), microphone=()"),
];

/// What is answered at once, however many questions wait: that the server is up, how far a work is, that it ends.
const AT_ONCE: [&str; 3] = ["/health", page::PROGRESS, page::CANCEL];

/// The header with the name of a page's work, by which its progress is requested and it is cancelled.
const WORK: &str = "x-work";

/// So long a page may still take, when the time is over, to say what is there.
const LAST_WORDS: Duration = Duration::from_secs(2);

/// Cancels the work on a timeout or when the client has disconnected.
struct Waits {
    patience: Arc<Patience>,
    named: Option<String>,
    workplace: Arc<Workplace>,
}

impl Drop for Waits {
    fn drop(&mut self) {
        self.patience.cancel();
        if let Some(name) = &self.named {
            self.workplace.ended(name);
        }
    }
}

/// A request whose head and body are here.
struct Question {
    parts: Parts,
    path: String,
    body: Held,
    language: Language,
}

impl Desk {
    pub(crate) fn new(
        address: SocketAddr,
        token: Option<Token>,
        language: Language,
        limits: Limits,
        workplace: Workplace,
        respond: Respond,
    ) -> Self {
        Self {
            address,
            token,
            language,
            respond,
            workplace: Arc::new(workplace),
            bodies: Bodies::default(),
            turns: Arc::new(Semaphore::new(limits.computed.max(1))),
            places: Arc::new(Semaphore::new(limits.waiting)),
            limits,
        }
    }

    /// Answers a request, whatever it is.
    pub(crate) async fn answer(&self, request: Request<Incoming>, place: &IdleSlot) -> Response<Full<Bytes>> {
        let (parts, body) = request.into_parts();
        let (asked, headers) = (parts.uri.path().to_owned(), parts.headers.clone());
        let reply = match self.let_in(&parts) {
            Err(reply) => reply,
            Ok((path, language)) => {
                let most = if path == page::RECORDING { self.limits.recording_bytes } else { self.limits.body_bytes };
                match read(body, most, &self.bodies, &self.limits).await {
                    Ok(body) => {
                        place.busy();
                        self.respond(Question { parts, path, body, language }).await
                    }
                    Err(why) => self.no_body(why, most, language),
                }
            }
        };
        sent(reply, &asked, &headers, &HEADERS)
    }

    /// The path and the language of a request that may ask.
    fn let_in(&self, parts: &Parts) -> Result<(String, Language), Reply> {
        let path = percent_decode_str(parts.uri.path()).decode_utf8_lossy().into_owned();
        // For scripts the same call gives the same bytes, whatever the language of the machine.
        let preferred = if path.starts_with("/api/") { None } else { preferred(&parts.headers) };
        let language = preferred.unwrap_or(self.language);
        let barred = |status, what: &str| Err(page::misdirected(status, what, None));
        match admit(parts, self.address) {
            Err(Barred::Host) => return barred(421, &requests::foreign_host(&self.address, language)),
            Err(Barred::Site) => return barred(403, requests::foreign_site(language)),
            Ok(()) => {}
        }
        if let Some(token) = &self.token {
            if let Some(reply) = introduced(parts, token) {
                return Err(reply);
            }
            if !token.is_in(&parts.headers) {
                let reply = page::misdirected(401, requests::token_missing(language), None);
                return Err(reply.with("www-authenticate", "Bearer"));
            }
        }
        match parts.method {
            Method::GET | Method::HEAD | Method::POST => Ok((path, language)),
            _ => {
                let valid = page::methods(&path);
                let valid = if valid.is_empty() { &[page::Method::Get, page::Method::Post][..] } else { &valid };
                Err(page::wrong_method(&path, parts.method.as_str(), valid, language))
            }
        }
    }

    fn no_body(&self, why: NoBody, most: usize, language: Language) -> Reply {
        let Limits { body_time, .. } = self.limits;
        let (status, message) = match why {
            NoBody::TooLarge => (413, requests::body_larger_than(&most, language)),
            NoBody::TooSlow => (408, requests::body_too_slow(&body_time.as_secs(), language)),
            NoBody::NoRoom => (503, requests::busy(language).to_owned()),
            NoBody::Broken => (400, requests::body_broken(language).to_owned()),
        };
        // What may still come of it is not read.
        page::misdirected(status, &message, None).with("connection", "close")
    }

    /// Computes the answer on a thread of its own when its turn has come, and gives up when its time is over.
    async fn respond(&self, question: Question) -> Reply {
        let language = question.language;
        let (respond, workplace) = (self.respond, Arc::clone(&self.workplace));
        let patience = Arc::new(Patience::limited());
        if AT_ONCE.contains(&question.path.as_str()) {
            return question.put(respond, &workplace, &patience);
        }
        let name = question.parts.headers.get(WORK).and_then(|name| name.to_str().ok());
        let named = name.filter(|name| workplace.begun(name, &patience)).map(str::to_owned);
        let says_what_is_there = named.is_some();
        let _waits = Waits { patience: Arc::clone(&patience), named, workplace: Arc::clone(&workplace) };
        let Ok(place) = self.places.try_acquire() else { return busy(language) };
        let ends = Arc::clone(&patience);
        let work = async {
            let turn = Arc::clone(&self.turns).acquire_owned().await;
            drop(place);
            let work = move || {
                // The worker stays busy until the computation ends, even if the client has disconnected.
                let _turn = turn;
                if patience.is_over() && !says_what_is_there {
                    return busy(language);
                }
                question.put(respond, &workplace, &patience)
            };
            tokio::task::spawn_blocking(work).await
        };
        let mut work = pin!(work);
        let mut found = tokio::time::timeout(self.limits.answer_time, work.as_mut()).await;
        if found.is_err() && says_what_is_there {
            ends.expire();
            found = tokio::time::timeout(LAST_WORDS, work).await;
        }
        match found {
            Ok(Ok(reply)) => reply,
            Ok(Err(_)) => page::misdirected(500, requests::failed_inside(language), None),
            Err(_) => {
                let most = self.limits.answer_time.as_secs();
                page::misdirected(503, &requests::not_in_time(&most, language), None)
            }
        }
    }
}

impl Question {
    /// Puts the question.
    fn put(&self, respond: Respond, shell: &Workplace, patience: &Patience) -> Reply {
        let call = Call {
            method: if self.parts.method == Method::POST { page::Method::Post } else { page::Method::Get },
            path: &self.path,
            query: self.parts.uri.query().unwrap_or_default(),
            media: self.parts.headers.get(CONTENT_TYPE).and_then(|value| value.to_str().ok()),
            body: self.body.bytes(),
            language: self.language,
        };
        respond(&call, shell, patience)
    }
}

/// Too many wait already.
fn busy(language: Language) -> Reply {
    page::misdirected(503, requests::busy(language), None).with("retry-after", "1")
}

/// Who opens the address with the token gets it as a cookie and the address without it.
fn introduced(parts: &Parts, token: &Token) -> Option<Reply> {
    let query = parts.uri.query()?;
    let is_token = |pair: &&str| {
        let given = pair.strip_prefix(IN_QUERY).and_then(|rest| rest.strip_prefix('='));
        given.is_some_and(|given| token.is(given))
    };
    if parts.method != Method::GET || !query.split('&').any(|pair| is_token(&pair)) {
        return None;
    }
    let rest: Vec<&str> = query.split('&').filter(|pair| !is_token(pair)).collect();
    // One slash at the beginning: two would name another host.
    let path = format!("/{}", parts.uri.path().trim_start_matches('/'));
    let place = if rest.is_empty() { path } else { format!("{path}?{}", rest.join("&")) };
    Some(Reply::text(303, "").with("location", place).with("set-cookie", token.cookie()))
}
