//! The way of a request: admitted, read, computed concurrently with others, answered.

use crate::body::{Bodies, CountedBody, NoBody, read};
use crate::folder::Workplace;
use crate::gate::{Barred, admit, preferred};
use crate::idle::IdleSlot;
use crate::lanes::Lanes;
use crate::limits::RequestLimits;
use crate::pack::{OpenFiles, sent, sent_open};
use crate::token::Token;
use bytes::Bytes;
use http_body_util::Full;
use hyper::body::Incoming;
use hyper::header::{ACCEPT, CONTENT_TYPE};
use hyper::http::request::Parts;
use hyper::{Method, Request, Response};
use page::{Call, Reply, Shell};
use percent_encoding::percent_decode_str;
use quantities::Language;
use questions::Progress;
use std::net::SocketAddr;
use std::pin::pin;
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::{Semaphore, SemaphorePermit};
use words::requests;

/// Answers a call.
pub(crate) type Respond = fn(&Call<'_>, &dyn Shell, &Progress) -> Reply;

/// State shared by all connections.
pub(crate) struct Responder {
    pub(crate) address: SocketAddr,
    pub(crate) token: Option<Token>,
    pub(crate) language: Language,
    pub(crate) limits: RequestLimits,
    pub(crate) respond: Respond,
    workplace: Arc<Workplace>,
    bodies: Bodies,
    /// Turns of short and of long answers.
    pub(crate) lanes: Lanes,
    /// Places of questions that wait for a turn.
    places: Arc<Semaphore>,
    strangers: Strangers,
    open: OpenFiles,
}

/// Requests without the token: one of them is answered at a time, after every request with the token that is ready.
struct Strangers(Semaphore);

impl Default for Strangers {
    fn default() -> Self {
        Self(Semaphore::new(1))
    }
}

impl Strangers {
    /// Waits for the turn of a request.
    async fn turn(&self) -> Option<SemaphorePermit<'_>> {
        let turn = self.0.acquire().await.ok();
        tokio::task::yield_now().await;
        turn
    }
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

/// Paths that are answered at once, independent of the number of waiting questions: the state of the server, progress
/// and cancellation of a work.
const AT_ONCE: [&str; 3] = ["/health", page::PROGRESS, page::CANCEL];

/// Header with the name of a page's work; progress and cancellation refer to it.
const WORK: &str = "x-work";

/// Time that a page has after the time limit to return its partial result.
const LAST_WORDS: Duration = Duration::from_secs(2);

/// Cancels the work on a timeout or when the client has disconnected.
struct Waits {
    progress: Arc<Progress>,
    named: Option<String>,
    workplace: Arc<Workplace>,
}

impl Drop for Waits {
    fn drop(&mut self) {
        self.progress.cancel();
        if let Some(name) = &self.named {
            self.workplace.ended(name);
        }
    }
}

/// An admitted request without its credentials.
struct Admitted {
    path: String,
    query: String,
    language: Language,
    /// The request has the token, or none is needed.
    has_token: bool,
}

/// A request with its complete head and body.
struct Question {
    parts: Parts,
    path: String,
    /// Query without the token.
    query: String,
    body: CountedBody,
    language: Language,
}

impl Responder {
    pub(crate) fn new(
        address: SocketAddr,
        token: Option<Token>,
        language: Language,
        limits: RequestLimits,
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
            lanes: Lanes::new(&limits),
            places: Arc::new(Semaphore::new(limits.waiting)),
            strangers: Strangers::default(),
            open: OpenFiles::default(),
            limits,
        }
    }

    /// Answers a request of any kind.
    pub(crate) async fn answer(&self, request: Request<Incoming>, place: &IdleSlot) -> Response<Full<Bytes>> {
        let (parts, body) = request.into_parts();
        let headers = parts.headers.clone();
        let mut turn = None;
        let reply = match self.let_in(&parts) {
            Err(reply) => {
                turn = self.strangers.turn().await;
                reply
            }
            Ok(Admitted { path, query, language, has_token }) => {
                let most = match &*path {
                    // A stranger takes none of the memory for bodies, nor of the time to send one.
                    _ if !has_token => 0,
                    page::RECORDING | page::PREVIEW => self.limits.recording_bytes,
                    _ => self.limits.body_bytes,
                };
                match read(body, most, &self.bodies, &self.limits).await {
                    Ok(body) => {
                        if !has_token {
                            turn = self.strangers.turn().await;
                        }
                        place.busy(has_token);
                        if is_open_to_all(&parts) {
                            let file = self.open.get(&path).map_or_else(
                                || {
                                    let question = Question { parts, path: path.clone(), query, body, language };
                                    let progress = Progress::limited();
                                    self.open.kept(&path, question.forward(self.respond, &self.workplace, &progress))
                                },
                                Ok,
                            );
                            return match file {
                                Ok(file) => sent_open(&file, &headers, &HEADERS),
                                Err(reply) => sent(reply, &headers, &HEADERS),
                            };
                        }
                        self.respond(Question { parts, path, query, body, language }).await
                    }
                    Err(why) => self.no_body(why, most, language),
                }
            }
        };
        let response = sent(reply, &headers, &HEADERS);
        drop(turn);
        response
    }

    /// Admits a request, or returns the reply that rejects it.
    fn let_in(&self, parts: &Parts) -> Result<Admitted, Reply> {
        let path = percent_decode_str(parts.uri.path()).decode_utf8_lossy().into_owned();
        // For scripts the same call gives the same bytes, independent of the language of the machine.
        let preferred = if path.starts_with("/api/") { None } else { preferred(&parts.headers) };
        let language = preferred.unwrap_or(self.language);
        let barred = |status, what: &str| Err(page::misdirected(status, what, None));
        match admit(parts, self.address) {
            Err(Barred::Host) => return barred(421, &requests::foreign_host(&self.address, language)),
            Err(Barred::Site) => return barred(403, requests::foreign_site(language)),
            Ok(()) => {}
        }
        let mut query = parts.uri.query().unwrap_or_default().to_owned();
        let mut has_token = true;
        if let Some(token) = &self.token {
            let without = token.taken_from(&query);
            // Files that are the same for all clients need no token: the page loads them before it has one, and links
            // to them have none.
            has_token = without.is_some() || token.is_in(&parts.headers);
            if !has_token && !is_open_to_all(parts) {
                return Err(locked(parts, language));
            }
            query = without.unwrap_or(query);
        }
        match parts.method {
            Method::GET | Method::HEAD | Method::POST => Ok(Admitted { path, query, language, has_token }),
            _ => {
                let valid = page::methods(&path);
                let valid = if valid.is_empty() { &[page::Method::Get, page::Method::Post][..] } else { &valid };
                Err(page::wrong_method(&path, parts.method.as_str(), valid, language))
            }
        }
    }

    fn no_body(&self, why: NoBody, most: usize, language: Language) -> Reply {
        let RequestLimits { body_time, .. } = self.limits;
        let (status, message) = match why {
            NoBody::TooLarge => (413, requests::body_larger_than(&most, language)),
            NoBody::TooSlow => (408, requests::body_too_slow(&body_time.as_secs(), language)),
            NoBody::NoRoom => (503, requests::busy(language).to_owned()),
            NoBody::Broken => (400, requests::body_broken(language).to_owned()),
        };
        // The rest of the body is not read.
        page::misdirected(status, &message, None).with("connection", "close")
    }

    /// Computes the answer on a thread of its own when its turn has come, and gives up at the time limit.
    async fn respond(&self, question: Question) -> Reply {
        let language = question.language;
        let (respond, workplace) = (self.respond, Arc::clone(&self.workplace));
        let progress = Arc::new(Progress::limited());
        if AT_ONCE.contains(&question.path.as_str()) {
            return question.forward(respond, &workplace, &progress);
        }
        let name = question.parts.headers.get(WORK).and_then(|name| name.to_str().ok());
        let named = name.filter(|name| workplace.begun(name, &progress)).map(str::to_owned);
        let says_what_is_there = named.is_some();
        let _waits = Waits { progress: Arc::clone(&progress), named, workplace: Arc::clone(&workplace) };
        let Ok(place) = self.places.try_acquire() else { return busy(language) };
        let ends = Arc::clone(&progress);
        let put = move |progress: &Progress| {
            if progress.is_over() && !says_what_is_there {
                return busy(language);
            }
            question.forward(respond, &workplace, progress)
        };
        let mut work = pin!(self.lanes.computed(Arc::new(put), progress, || drop(place)));
        let mut found = tokio::time::timeout(self.limits.answer_time, work.as_mut()).await;
        if found.is_err() && says_what_is_there {
            ends.expire();
            found = tokio::time::timeout(LAST_WORDS, work).await;
        }
        match found {
            Ok(Some(reply)) => reply,
            Ok(None) => page::misdirected(500, requests::failed_inside(language), None),
            Err(_) => {
                let most = self.limits.answer_time.as_secs();
                page::misdirected(503, &requests::not_in_time(&most, language), None)
            }
        }
    }
}

impl Question {
    /// Passes the question on as a call.
    fn forward(&self, respond: Respond, shell: &Workplace, progress: &Progress) -> Reply {
        let call = Call {
            method: if self.parts.method == Method::POST { page::Method::Post } else { page::Method::Get },
            path: &self.path,
            query: &self.query,
            media: self.parts.headers.get(CONTENT_TYPE).and_then(|value| value.to_str().ok()),
            body: self.body.bytes(),
            language: self.language,
        };
        respond(&call, shell, progress)
    }
}

/// Returns the reply when too many questions wait.
fn busy(language: Language) -> Reply {
    page::misdirected(503, requests::busy(language), None).with("retry-after", "1")
}

/// Returns the reply to a request without the token; for a browser that opens a page, the page that sends the stored
/// token.
fn locked(parts: &Parts, language: Language) -> Reply {
    let accepts = parts.headers.get(ACCEPT).and_then(|value| value.to_str().ok()).unwrap_or_default();
    let is_page = !parts.uri.path().starts_with("/api/") && accepts.contains("text/html");
    let message = requests::token_missing(language);
    let reply = if is_page { page::locked(message, language) } else { page::misdirected(401, message, None) };
    reply.with("www-authenticate", "Bearer")
}

/// Returns `true` if a request only reads a file that is the same for all clients.
fn is_open_to_all(parts: &Parts) -> bool {
    matches!(parts.method, Method::GET | Method::HEAD) && page::is_open_to_all(parts.uri.path())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Mutex;

    /// A hundred strangers are ready before the user; of them one at most is answered between two steps of the user.
    #[tokio::test]
    async fn requests_with_the_token_go_before_those_without() {
        const STEPS: usize = 10;
        let (strangers, order) = (Arc::new(Strangers::default()), Arc::new(Mutex::new(Vec::new())));
        let mut all = Vec::new();
        for _ in 0..100 {
            let (strangers, order) = (Arc::clone(&strangers), Arc::clone(&order));
            all.push(tokio::spawn(async move {
                let _turn = strangers.turn().await;
                order.lock().unwrap().push("stranger");
            }));
        }
        let of_user = Arc::clone(&order);
        all.push(tokio::spawn(async move {
            for _ in 0..STEPS {
                of_user.lock().unwrap().push("user");
                tokio::task::yield_now().await;
            }
        }));
        for each in all {
            each.await.unwrap();
        }
        let order = order.lock().unwrap();
        let last = order.iter().rposition(|who| *who == "user").unwrap();
        assert!(order.len() == 100 + STEPS && last < 2 * STEPS + 2, "{last}: {order:?}");
    }
}
