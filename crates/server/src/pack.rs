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
use std::sync::{LazyLock, Mutex, PoisonError};

/// Smallest number of bytes that is compressed.
const LEAST: usize = 1400;

/// Prefix of the files of the page: cached by the browser and revalidated by their hash.
const ASSETS: &str = "/assets/";

/// Returns a reply to a request for a path with these headers, with its own headers and those of every reply.
pub(crate) fn sent(
    reply: Reply,
    path: &str,
    asked: &HeaderMap,
    always: &[(&'static str, &'static str)],
) -> Response<Full<Bytes>> {
    let is_asset = path.starts_with(ASSETS) && reply.status == 200;
    // What is the same for everyone is packed once: it is requested without the token too.
    let kept = (page::is_open_to_all(path) && reply.status == 200).then(|| blake3::hash(&reply.body));
    let tag = kept.filter(|_| is_asset).map(|hash| format!("\"{}\"", hash.to_hex()));
    let is_known = tag.as_deref().is_some_and(|tag| has(asked, &IF_NONE_MATCH, tag));
    let is_text = reply.media.starts_with("text/") || reply.media.contains("json") || reply.media.contains("svg");
    let is_packable = is_text && !is_known && reply.body.len() >= LEAST && reads_gzip(asked);
    let packed = match kept {
        _ if !is_packable => None,
        Some(hash) => packed_once(hash, &reply.body),
        None => packed(&reply.body).map(Bytes::from),
    };
    let is_packed = packed.is_some();
    let body = if is_known { Bytes::new() } else { packed.unwrap_or_else(|| Bytes::from(reply.body)) };
    let mut response = Response::new(Full::new(body));
    let status = if is_known { 304 } else { reply.status };
    *response.status_mut() = StatusCode::from_u16(status).unwrap_or(StatusCode::INTERNAL_SERVER_ERROR);
    let headers = response.headers_mut();
    headers.insert(CONTENT_TYPE, HeaderValue::from_static(reply.media));
    for (name, value) in always {
        headers.insert(HeaderName::from_static(name), HeaderValue::from_static(value));
    }
    let caching = if is_asset { "private, no-cache" } else { "no-store" };
    headers.insert(CACHE_CONTROL, HeaderValue::from_static(caching));
    if is_text {
        headers.insert(VARY, HeaderValue::from_static("accept-encoding"));
    }
    if is_packed {
        headers.insert(CONTENT_ENCODING, HeaderValue::from_static("gzip"));
    }
    if let Some(tag) = tag.and_then(|tag| HeaderValue::try_from(tag).ok()) {
        headers.insert(ETAG, tag);
    }
    for (name, value) in reply.headers {
        // An invalid header is left out, so that its text cannot end the headers.
        if let (Ok(name), Ok(value)) = (HeaderName::try_from(name), HeaderValue::try_from(value)) {
            headers.insert(name, value);
        }
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

/// Most packed files that are kept: more than are open to all.
const KEPT_MOST: usize = 256;

/// Compresses a file that is the same for everyone, the first time that it is sent.
fn packed_once(hash: blake3::Hash, body: &[u8]) -> Option<Bytes> {
    static KEPT: LazyLock<Mutex<BTreeMap<[u8; 32], Bytes>>> = LazyLock::new(Mutex::default);
    let mut kept = KEPT.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(found) = kept.get(hash.as_bytes()) {
        return Some(found.clone());
    }
    let found = Bytes::from(packed(body)?);
    if kept.len() < KEPT_MOST {
        drop(kept.insert(*hash.as_bytes(), found.clone()));
    }
    Some(found)
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
        let plain = sent(reply(), "/work", &asked(&[]), &[]);
        assert!(plain.headers().get(CONTENT_ENCODING).is_none());
        assert_eq!(body(plain).await, text.as_bytes());
        let refused = sent(reply(), "/work", &asked(&[(ACCEPT_ENCODING, "gzip;q=0, br")]), &[]);
        assert!(refused.headers().get(CONTENT_ENCODING).is_none());
        let short = sent(Reply::text(200, "short"), "/work", &asked(&[(ACCEPT_ENCODING, "gzip")]), &[]);
        assert!(short.headers().get(CONTENT_ENCODING).is_none());
        let packed = sent(reply(), "/work", &asked(&[(ACCEPT_ENCODING, "br, gzip;q=0.8")]), &[]);
        assert_eq!(packed.headers().get(CONTENT_ENCODING).map(HeaderValue::as_bytes), Some(&b"gzip"[..]));
        let bytes = body(packed).await;
        assert!(bytes.len() * 10 < text.len(), "{}", bytes.len());
        let mut read = String::new();
        assert!(GzDecoder::new(bytes.as_slice()).read_to_string(&mut read).is_ok());
        assert_eq!(read, text);
    }

    /// Files that are open to all are packed when they are first sent, and are the same bytes each time.
    #[tokio::test]
    async fn what_is_the_same_for_everyone_is_packed_once() {
        let text = "a rule of the style\n".repeat(1 << 16);
        let asked = asked(&[(ACCEPT_ENCODING, "gzip")]);
        let reply = || sent(Reply::text(200, &text), "/assets/page.css", &asked, &[]);
        let first = body(reply()).await;
        assert_eq!(body(reply()).await, first);
        let hash = blake3::hash(text.as_bytes());
        let [one, other] = [(); 2].map(|()| packed_once(hash, text.as_bytes()).map(|bytes| bytes.as_ptr() as usize));
        assert!(one.is_some() && one == other, "it is kept");
    }

    #[tokio::test]
    async fn a_file_of_the_page_that_the_browser_has_is_not_sent_again() {
        let reply = || Reply::text(200, "body { margin: 0 }");
        let first = sent(reply(), "/assets/page.css", &asked(&[]), &[]);
        let tag = first.headers().get(ETAG).cloned();
        let mut headers = HeaderMap::new();
        headers.extend(tag.map(|tag| (IF_NONE_MATCH, tag)));
        assert!(!headers.is_empty());
        let again = sent(reply(), "/assets/page.css", &headers, &[]);
        assert_eq!(again.status(), 304);
        assert!(body(again).await.is_empty());
        let other = sent(Reply::text(200, "body { margin: 1px }"), "/assets/page.css", &headers, &[]);
        assert_eq!(other.status(), 200);
        // Only files of the page are cached.
        let page = sent(reply(), "/work", &headers, &[]);
        assert_eq!(page.headers().get(CACHE_CONTROL).map(HeaderValue::as_bytes), Some(&b"no-store"[..]));
    }
}
