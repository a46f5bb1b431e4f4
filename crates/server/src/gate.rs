//! Access of requests: the addressed host, the sending site, the preferred language.

use hyper::header::{ACCEPT_LANGUAGE, HOST, ORIGIN};
use hyper::http::request::Parts;
use hyper::{HeaderMap, Method};
use quantities::Language;
use std::net::{IpAddr, SocketAddr};

/// Reason why a request is rejected.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Barred {
    /// The request is addressed to another host.
    Host,
    /// The request comes from another site.
    Site,
}

/// Admits a request that is addressed to this server and comes from its own pages.
pub(crate) fn admit(parts: &Parts, address: SocketAddr) -> Result<(), Barred> {
    let headers = &parts.headers;
    let hosts: Vec<&[u8]> = headers.get_all(HOST).into_iter().map(|value| value.as_bytes()).collect();
    let [host] = hosts.as_slice() else { return Err(Barred::Host) };
    let is_ours = |text: &str| is_host(text, address);
    if !std::str::from_utf8(host).is_ok_and(is_ours) {
        return Err(Barred::Host);
    }
    // The request line may name the host too.
    if parts.uri.authority().is_some_and(|authority| !is_ours(authority.as_str())) {
        return Err(Barred::Host);
    }
    if is_from_elsewhere(&parts.method, headers, address) { Err(Barred::Site) } else { Ok(()) }
}

/// Returns `true` if a text is a host of this server: its own address or a name of the loopback, with its port. Other
/// names are rejected, independent of their resolution.
fn is_host(text: &str, address: SocketAddr) -> bool {
    let (name, port) = match text.rsplit_once(':') {
        // In an address without a port, the colons stand within brackets.
        Some((name, port)) if !port.ends_with(']') => (name, port.parse::<u16>().ok()),
        _ => (text, Some(80)),
    };
    if port != Some(address.port()) {
        return false;
    }
    if name.eq_ignore_ascii_case("localhost") {
        return address.ip().is_loopback() || address.ip().is_unspecified();
    }
    let plain = name.strip_prefix('[').and_then(|name| name.strip_suffix(']')).unwrap_or(name);
    let Ok(named) = plain.parse::<IpAddr>() else { return false };
    if address.ip().is_unspecified() {
        // Listening on all addresses: a numeric address is accepted, because it cannot come from a forged name.
        return true;
    }
    named == address.ip() || (named.is_loopback() && address.ip().is_loopback())
}

/// Returns `true` if the headers of a browser show that another site has sent the request. A request that changes
/// something must come from this server; one that only reads may come from a link on any site.
fn is_from_elsewhere(method: &Method, headers: &HeaderMap, address: SocketAddr) -> bool {
    let text = |name: &str| headers.get(name).map(|value| value.to_str().unwrap_or("?"));
    let changes = !matches!(*method, Method::GET | Method::HEAD);
    let site = text("sec-fetch-site");
    let foreign = site.is_some_and(|site| !matches!(site, "same-origin" | "none"));
    let by_link = text("sec-fetch-mode") == Some("navigate");
    if foreign && (changes || !by_link) {
        return true;
    }
    let origins: Vec<&[u8]> = headers.get_all(ORIGIN).into_iter().map(|value| value.as_bytes()).collect();
    let ours = |origin: &&[u8]| {
        let text = std::str::from_utf8(origin).unwrap_or_default();
        text.strip_prefix("http://").is_some_and(|host| is_host(host, address))
    };
    changes && !origins.iter().all(ours)
}

/// Returns the supported language that a browser prefers.
pub(crate) fn preferred(headers: &HeaderMap) -> Option<Language> {
    let accepted = headers.get(ACCEPT_LANGUAGE)?.to_str().ok()?;
    let mut best: Option<(f32, Language)> = None;
    for range in accepted.split(',') {
        let (tag, quality) = match range.split_once(';') {
            Some((tag, more)) => {
                let quality = more.trim().strip_prefix("q=").and_then(|quality| quality.trim().parse().ok());
                (tag, quality.unwrap_or(0.0))
            }
            None => (range, 1.0),
        };
        let primary = tag.trim().split('-').next().unwrap_or_default();
        if let Some(language) = Language::of_id(primary)
            && quality > 0.0
            && best.is_none_or(|(most, _)| quality > most)
        {
            best = Some((quality, language));
        }
    }
    best.map(|(_, language)| language)
}

#[cfg(test)]
mod tests {
    use super::*;
    use hyper::Request;

    const HERE: &str = "127.0.0.1:8080";

    fn asked(method: &str, uri: &str, headers: &[(&str, &str)]) -> Result<(), Barred> {
        at(HERE, method, uri, headers)
    }

    fn at(address: &str, method: &str, uri: &str, headers: &[(&str, &str)]) -> Result<(), Barred> {
        let mut request = Request::builder().method(method).uri(uri);
        for (name, value) in headers {
            request = request.header(*name, *value);
        }
        admit(&request.body(()).unwrap().into_parts().0, address.parse().unwrap())
    }

    #[test]
    fn only_its_own_names_are_answered() {
        for host in [HERE, "localhost:8080", "LOCALHOST:8080", "[::1]:8080", "127.0.0.2:8080"] {
            assert_eq!(asked("GET", "/", &[("host", host)]), Ok(()), "{host}");
        }
        let foreign = [
            "",
            "127.0.0.1",
            "localhost",
            "127.0.0.1:80",
            "127.0.0.1:8081",
            "evil.example:8080",
            "localhost.evil.example:8080",
            "10.0.0.1:8080",
            "[::1]",
            "[::1:8080",
            "127.0.0.1:8080:8080",
            "user@127.0.0.1:8080",
            "0x7f.1:8080",
            ":8080",
            "127.0.0.1:8080, evil.example",
        ];
        for host in foreign {
            assert_eq!(asked("GET", "/", &[("host", host)]), Err(Barred::Host), "{host}");
        }
        assert_eq!(asked("GET", "/", &[]), Err(Barred::Host));
        assert_eq!(asked("GET", "/", &[("host", HERE), ("host", HERE)]), Err(Barred::Host));
        assert_eq!(asked("GET", "http://evil.example/", &[("host", HERE)]), Err(Barred::Host));
        assert_eq!(asked("GET", "http://127.0.0.1:8080/", &[("host", HERE)]), Ok(()));
        assert_eq!(at("127.0.0.1:80", "GET", "/", &[("host", "localhost")]), Ok(()));
        assert_eq!(at("192.168.1.5:8080", "GET", "/", &[("host", "192.168.1.5:8080")]), Ok(()));
        assert_eq!(at("192.168.1.5:8080", "GET", "/", &[("host", "localhost:8080")]), Err(Barred::Host));
        assert_eq!(at("0.0.0.0:8080", "GET", "/", &[("host", "192.168.1.5:8080")]), Ok(()));
        assert_eq!(at("0.0.0.0:8080", "GET", "/", &[("host", "evil.example:8080")]), Err(Barred::Host));
    }

    #[test]
    fn what_another_site_sends_is_not_taken() {
        let with = |method: &str, name: &str, value: &str| asked(method, "/", &[("host", HERE), (name, value)]);
        for origin in ["http://127.0.0.1:8080", "http://localhost:8080", "http://[::1]:8080"] {
            assert_eq!(with("POST", "origin", origin), Ok(()), "{origin}");
        }
        for origin in
            ["null", "", "http://evil.example", "https://127.0.0.1:8080", "http://127.0.0.1:8081", "http://127.0.0.1"]
        {
            assert_eq!(with("POST", "origin", origin), Err(Barred::Site), "{origin}");
            assert_eq!(with("GET", "origin", origin), Ok(()), "{origin}");
        }
        assert_eq!(with("POST", "sec-fetch-site", "cross-site"), Err(Barred::Site));
        assert_eq!(with("POST", "sec-fetch-site", "same-site"), Err(Barred::Site));
        assert_eq!(with("POST", "sec-fetch-site", "same-origin"), Ok(()));
        assert_eq!(with("GET", "sec-fetch-site", "cross-site"), Err(Barred::Site));
        let link = [("host", HERE), ("sec-fetch-site", "cross-site"), ("sec-fetch-mode", "navigate")];
        assert_eq!(asked("GET", "/", &link), Ok(()));
        assert_eq!(asked("POST", "/", &link), Err(Barred::Site));
        // A script or a program sends no such header.
        assert_eq!(asked("POST", "/", &[("host", HERE)]), Ok(()));
    }

    #[test]
    fn the_language_is_the_one_that_is_liked_best() {
        let of = |value: &str| {
            preferred(&HeaderMap::from_iter([(ACCEPT_LANGUAGE, value.parse().unwrap())])).map(Language::id)
        };
        assert_eq!(of("de-DE,de;q=0.9,en;q=0.8"), Some("de"));
        assert_eq!(of("fr, en;q=0.3, de;q=0.5"), Some("de"));
        assert_eq!(of("en-GB, de"), Some("en"));
        assert_eq!(of("fr, de;q=0"), None);
        assert_eq!(of("*"), None);
    }
}
