//! Encoding of a reply: compressed if the client accepts it; an entity tag for files that the browser caches.

use bytes::Bytes;
use flate2::Compression;
use flate2::write::GzEncoder;
use http_body_util::Full;
use hyper::header::{
    ACCEPT_ENCODING, CACHE_CONTROL, CONTENT_ENCODING, CONTENT_TYPE, ETAG, HeaderMap, HeaderName, HeaderValue,
    IF_NONE_MATCH, VARY,
};
use hyper::{Response, StatusCode};
use page::Reply;
use std::collections::BTreeMap;
use std::io::Write;
use std::sync::{Arc, Mutex, PoisonError};

/// Smallest number of bytes that is compressed.
const LEAST: usize = 1400;

/// Prefix of the files of the page: cached by the browser and revalidated by their hash.
const ASSETS: &str = "/assets/";

/// Files that are the same for all clients, by their paths: made, hashed and packed when they are first requested, because a client
/// without the token may request them at any rate.
#[derive(Default)]
pub(crate) struct OpenFiles(Mutex<BTreeMap<String, Arc<OpenFile>>>);

/// A file that is the same for all clients, as it is sent.
pub(crate) struct OpenFile {
    media: &'static str,
    body: Bytes,
    packed: Option<Bytes>,
    /// Entity tag of a file that the browser caches.
    tag: Option<String>,
}

/// Largest number of files that are kept: more than are open to all.
const KEPT_MOST: usize = 256;

impl OpenFiles {
    /// Returns the file with a path, if it was requested before.
    pub(crate) fn get(&self, path: &str) -> Option<Arc<OpenFile>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).get(path).cloned()
    }

    /// Keeps the reply to a path as a file; a reply that is none, such as one to an unknown name, is returned.
    pub(crate) fn kept(&self, path: &str, reply: Reply) -> Result<Arc<OpenFile>, Reply> {
        let mut all = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if reply.status != 200 || !reply.headers.is_empty() || all.len() >= KEPT_MOST {
            return Err(reply);
        }
        let is_packable = is_compressible(reply.media) && reply.body.len() >= LEAST;
        let file = Arc::new(OpenFile {
            media: reply.media,
            packed: is_packable.then(|| packed(&reply.body)).flatten().map(Bytes::from),
            tag: path.starts_with(ASSETS).then(|| format!("\"{}\"", blake3::hash(&reply.body).to_hex())),
            body: Bytes::from(reply.body),
        });
        drop(all.insert(path.to_owned(), Arc::clone(&file)));
        Ok(file)
    }
}

/// Headers of every response.
type Always = [(&'static str, &'static str)];

/// Returns a reply to a request with these headers, with its own headers and those of every reply.
pub(crate) fn sent(reply: Reply, asked: &HeaderMap, always: &Always) -> Response<Full<Bytes>> {
    let is_packable = is_compressible(reply.media) && reply.body.len() >= LEAST && reads_gzip(asked);
    let packed = is_packable.then(|| packed(&reply.body)).flatten();
    let is_packed = packed.is_some();
    let body = Bytes::from(packed.unwrap_or(reply.body));
    let mut response = begun((reply.status, reply.media), (body, is_packed), None, always);
    for (name, value) in reply.headers {
        // An invalid header is left out, so that its text cannot end the headers.
        if let (Ok(name), Ok(value)) = (HeaderName::try_from(name), HeaderValue::try_from(value)) {
            response.headers_mut().insert(name, value);
        }
    }
    response
}

/// Returns a file that is the same for all clients; without its bytes if the client has them.
pub(crate) fn sent_open(file: &OpenFile, asked: &HeaderMap, always: &Always) -> Response<Full<Bytes>> {
    let tag = file.tag.as_deref();
    if tag.is_some_and(|tag| has(asked, &IF_NONE_MATCH, tag)) {
        return begun((304, file.media), (Bytes::new(), false), tag, always);
    }
    let packed = file.packed.as_ref().filter(|_| reads_gzip(asked));
    let body = packed.unwrap_or(&file.body).clone();
    begun((200, file.media), (body, packed.is_some()), tag, always)
}

fn is_compressible(media: &str) -> bool {
    media.starts_with("text/") || media.starts_with("font/") || media.contains("json") || media.contains("svg")
}

fn begun(
    (status, media): (u16, &'static str),
    (body, is_packed): (Bytes, bool),
    tag: Option<&str>,
    always: &Always,
) -> Response<Full<Bytes>> {
    let mut response = Response::new(Full::new(body));
    *response.status_mut() = StatusCode::from_u16(status).unwrap_or(StatusCode::INTERNAL_SERVER_ERROR);
    let headers = response.headers_mut();
    headers.insert(CONTENT_TYPE, HeaderValue::from_static(media));
    for (name, value) in always {
        headers.insert(HeaderName::from_static(name), HeaderValue::from_static(value));
    }
    let caching = if tag.is_some() { "private, no-cache" } else { "no-store" };
    headers.insert(CACHE_CONTROL, HeaderValue::from_static(caching));
    if is_compressible(media) {
        headers.insert(VARY, HeaderValue::from_static("accept-encoding"));
    }
    if is_packed {
        headers.insert(CONTENT_ENCODING, HeaderValue::from_static("gzip"));
    }
    if let Some(tag) = tag.and_then(|tag| HeaderValue::try_from(tag).ok()) {
        headers.insert(ETAG, tag);
    }
    response
}

/// Returns `true` if a header lists a value.
fn has(headers: &HeaderMap, name: &HeaderName, wanted: &str) -> bool {
    let values = headers.get_all(name).iter().filter_map(|value| value.to_str().ok());
    values.flat_map(|value| value.split(',')).any(|value| value.trim().trim_start_matches("W/") == wanted)
}

/// Returns `true` if the client accepts gzip: listed, with a weight other than zero.
fn reads_gzip(headers: &HeaderMap) -> bool {
    let values = headers.get_all(ACCEPT_ENCODING).iter().filter_map(|value| value.to_str().ok());
    values.flat_map(|value| value.split(',')).any(|value| {
        let mut parts = value.split(';').map(str::trim);
        let is_gzip = parts.next().is_some_and(|name| name.eq_ignore_ascii_case("gzip"));
        let is_refused =
            parts.any(|part| part.strip_prefix("q=").is_some_and(|weight| weight.trim().parse() == Ok(0.0_f64)));
        is_gzip && !is_refused
    })
}

/// Compresses a body, quickly rather than strongly: the distance is short.
fn packed(body: &[u8]) -> Option<Vec<u8>> {
    let mut packer = GzEncoder::new(Vec::with_capacity(body.len() / 3), Compression::fast());
    packer.write_all(body).ok()?;
    packer.finish().ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use flate2::read::GzDecoder;
    use http_body_util::BodyExt;
    use std::io::Read;

    fn asked(pairs: &[(HeaderName, &'static str)]) -> HeaderMap {
        pairs.iter().map(|(name, value)| (name.clone(), HeaderValue::from_static(value))).collect()
    }

    async fn body(response: Response<Full<Bytes>>) -> Vec<u8> {
        response.into_body().collect().await.map(|body| body.to_bytes().to_vec()).unwrap_or_default()
    }

    #[tokio::test]
    async fn what_a_client_reads_packed_is_the_same_bytes() {
        let text = "a line of the page\n".repeat(400);
        let reply = || Reply::text(200, &text);
        let plain = sent(reply(), &asked(&[]), &[]);
        assert!(plain.headers().get(CONTENT_ENCODING).is_none());
        assert_eq!(body(plain).await, text.as_bytes());
        let refused = sent(reply(), &asked(&[(ACCEPT_ENCODING, "gzip;q=0, br")]), &[]);
        assert!(refused.headers().get(CONTENT_ENCODING).is_none());
        let short = sent(Reply::text(200, "short"), &asked(&[(ACCEPT_ENCODING, "gzip")]), &[]);
        assert!(short.headers().get(CONTENT_ENCODING).is_none());
        let packed = sent(reply(), &asked(&[(ACCEPT_ENCODING, "br, gzip;q=0.8")]), &[]);
        assert_eq!(packed.headers().get(CONTENT_ENCODING).map(HeaderValue::as_bytes), Some(&b"gzip"[..]));
        let bytes = body(packed).await;
        assert!(bytes.len() * 10 < text.len(), "{}", bytes.len());
        let mut read = String::new();
        assert!(GzDecoder::new(bytes.as_slice()).read_to_string(&mut read).is_ok());
        assert_eq!(read, text);
    }

    /// A file that is open to all is made, hashed and packed once: later requests get the same memory.
    #[tokio::test]
    async fn what_is_the_same_for_everyone_is_made_once() {
        let text = "a rule of the style\n".repeat(1 << 16);
        let files = OpenFiles::default();
        assert!(files.get("/assets/page.css").is_none());
        assert!(files.kept("/assets/page.css", Reply::text(200, &text)).is_ok());
        assert!(
            files.kept("/assets/none.css", Reply::text(404, "")).is_err() && files.get("/assets/none.css").is_none()
        );
        let place = |packs: bool| {
            let asked = if packs { asked(&[(ACCEPT_ENCODING, "gzip")]) } else { asked(&[]) };
            let file = files.get("/assets/page.css").unwrap();
            async move {
                let bytes = sent_open(&file, &asked, &[]).into_body().collect().await.unwrap().to_bytes();
                (bytes.as_ptr() as usize, bytes.len())
            }
        };
        assert_eq!((place(true).await, place(false).await), (place(true).await, place(false).await));
        assert!(place(false).await.1 == text.len() && place(true).await.1 * 10 < text.len());
    }

    #[tokio::test]
    async fn a_file_of_the_page_that_the_browser_has_is_not_sent_again() {
        let open = |path: &str, text: &str| OpenFiles::default().kept(path, Reply::text(200, text)).ok().unwrap();
        let file = open("/assets/page.css", "body { margin: 0 }");
        let first = sent_open(&file, &asked(&[]), &[]);
        let tag = first.headers().get(ETAG).cloned();
        let mut headers = HeaderMap::new();
        headers.extend(tag.map(|tag| (IF_NONE_MATCH, tag)));
        assert!(!headers.is_empty());
        let again = sent_open(&file, &headers, &[]);
        assert_eq!(again.status(), 304);
        assert!(body(again).await.is_empty());
        let other = open("/assets/page.css", "body { margin: 1px }");
        assert_eq!(sent_open(&other, &headers, &[]).status(), 200);
        // Only files of the page are cached.
        let page = sent(Reply::text(200, "body { margin: 0 }"), &headers, &[]);
        assert_eq!(page.headers().get(CACHE_CONTROL).map(HeaderValue::as_bytes), Some(&b"no-store"[..]));
        let theory = sent_open(&open("/theory/gear.html", "body { margin: 0 }"), &headers, &[]);
        assert_eq!(theory.headers().get(CACHE_CONTROL).map(HeaderValue::as_bytes), Some(&b"no-store"[..]));
    }
}
