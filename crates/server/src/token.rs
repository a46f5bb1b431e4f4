//! The token that every request needs, since the loopback is open to all users of the machine.
//!
//! A request carries it as a bearer token or in its query, never as a cookie: a browser sends the cookies of a host to
//! all of its ports, and so also to a server of another user.

use hyper::HeaderMap;
use hyper::header::AUTHORIZATION;

/// Name of the token in the query of the printed address.
pub(crate) const IN_QUERY: &str = "token";

/// Random bytes of a token.
const BYTES: usize = 32;

/// A token from the randomness of the system.
#[derive(Clone)]
pub(crate) struct Token {
    text: String,
    /// Hash for a comparison whose duration does not depend on the position of a difference.
    hash: blake3::Hash,
}

impl Token {
    /// Creates a token.
    ///
    /// # Errors
    /// When the system provides no randomness.
    pub(crate) fn new() -> std::io::Result<Self> {
        let mut bytes = [0; BYTES];
        getrandom::fill(&mut bytes).map_err(|error| std::io::Error::other(error.to_string()))?;
        let text: String = bytes.iter().map(|byte| format!("{byte:02x}")).collect();
        let hash = blake3::hash(text.as_bytes());
        Ok(Self { text, hash })
    }

    /// Returns the text of the token in the address.
    pub(crate) fn text(&self) -> &str {
        &self.text
    }

    /// Returns `true` if a text is the token.
    pub(crate) fn is(&self, text: &str) -> bool {
        blake3::hash(text.as_bytes()) == self.hash
    }

    /// Returns `true` if a request has the token as a bearer token.
    pub(crate) fn is_in(&self, headers: &HeaderMap) -> bool {
        let mut texts = headers.get_all(AUTHORIZATION).into_iter().filter_map(|value| value.to_str().ok());
        texts.any(|value| {
            let parts = value.split_once(' ').filter(|(scheme, _)| scheme.eq_ignore_ascii_case("bearer"));
            parts.is_some_and(|(_, value)| self.is(value.trim()))
        })
    }

    /// Returns a query without the token; `None` if it does not contain the token.
    pub(crate) fn taken_from(&self, query: &str) -> Option<String> {
        let is_token = |pair: &&str| {
            let given = pair.strip_prefix(IN_QUERY).and_then(|rest| rest.strip_prefix('='));
            given.is_some_and(|given| self.is(given))
        };
        let rest: Vec<&str> = query.split('&').filter(|pair| !is_token(pair)).collect();
        (rest.len() < query.split('&').count()).then(|| rest.join("&"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use hyper::header::{COOKIE, HeaderValue};

    #[test]
    fn a_token_is_brought_whole_or_not_at_all() {
        let (token, other) = (Token::new().unwrap(), Token::new().unwrap());
        assert!(token.text().len() == 64 && token.text() != other.text());
        let with = |name: hyper::header::HeaderName, value: &str| {
            HeaderMap::from_iter([(name, HeaderValue::from_str(value).unwrap())])
        };
        let text = token.text();
        assert!(token.is_in(&with(AUTHORIZATION, &format!("Bearer {text}"))));
        assert_eq!(token.taken_from(&format!("a=b&token={text}&c=d")).as_deref(), Some("a=b&c=d"));
        assert_eq!(token.taken_from(&format!("token={text}")).as_deref(), Some(""));
        for value in [String::new(), text[1..].to_owned(), format!("{text}0"), other.text().to_owned()] {
            assert!(!token.is_in(&with(AUTHORIZATION, &format!("Bearer {value}"))), "{value}");
            assert_eq!(token.taken_from(&format!("token={value}")), None, "{value}");
        }
        assert!(!token.is_in(&with(AUTHORIZATION, &format!("Basic {text}"))));
        assert_eq!(token.taken_from(&format!("xtoken={text}")), None);
        assert!(!token.is_in(&HeaderMap::new()));
        for name in ["antrieb_token", "antrieb_token_80", "token"] {
            assert!(!token.is_in(&with(COOKIE, &format!("{name}={text}"))), "a cookie goes to every port");
        }
    }
}
