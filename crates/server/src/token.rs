//! The token that every request needs: the loopback is open to all users of the machine.

use hyper::HeaderMap;
use hyper::header::{AUTHORIZATION, COOKIE};

/// What the name of the cookie begins with; the port follows, since a browser sends cookies to all ports of a host.
const NAME: &str = "antrieb_token";
/// Its name in the address that is printed.
pub(crate) const IN_QUERY: &str = "token";

/// Bytes of chance in a token.
const BYTES: usize = 32;

/// A token, made by the system's randomness.
#[derive(Clone)]
pub(crate) struct Token {
    text: String,
    /// The name of its cookie.
    name: String,
    /// Two hashes are compared in a time that does not tell where they differ.
    hash: blake3::Hash,
}

impl Token {
    /// A new one, for the server of a port.
    ///
    /// # Errors
    /// Where the system has no randomness to give.
    pub(crate) fn new(port: u16) -> std::io::Result<Self> {
        let mut bytes = [0; BYTES];
        getrandom::fill(&mut bytes).map_err(|error| std::io::Error::other(error.to_string()))?;
        let text: String = bytes.iter().map(|byte| format!("{byte:02x}")).collect();
        let hash = blake3::hash(text.as_bytes());
        Ok(Self { text, name: format!("{NAME}_{port}"), hash })
    }

    /// As it stands in the address.
    pub(crate) fn text(&self) -> &str {
        &self.text
    }

    /// Whether a text is the token.
    pub(crate) fn is(&self, text: &str) -> bool {
        blake3::hash(text.as_bytes()) == self.hash
    }

    /// Whether a request has it, as a cookie or as a bearer token.
    pub(crate) fn is_in(&self, headers: &HeaderMap) -> bool {
        let texts = |name| headers.get_all(name).into_iter().filter_map(|value| value.to_str().ok());
        let cookies = texts(COOKIE).flat_map(|value| value.split(';'));
        let mut cookies = cookies.filter_map(|pair| pair.trim().strip_prefix(self.name.as_str())?.strip_prefix('='));
        cookies.any(|value| self.is(value))
            || texts(AUTHORIZATION).any(|value| {
                let parts = value.split_once(' ').filter(|(scheme, _)| scheme.eq_ignore_ascii_case("bearer"));
                parts.is_some_and(|(_, value)| self.is(value.trim()))
            })
    }

    /// The header that gives it to a browser: for this server alone, out of reach of scripts, and with no request that begins
    /// on another site.
    pub(crate) fn cookie(&self) -> String {
        format!("{}={}; Path=/; HttpOnly; SameSite=Strict", self.name, self.text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use hyper::header::HeaderValue;

    #[test]
    fn a_token_is_brought_whole_or_not_at_all() {
        let (token, other) = (Token::new(80).unwrap(), Token::new(80).unwrap());
        let name = token.name.as_str();
        assert!(token.text().len() == 64 && token.text() != other.text());
        let with = |name: hyper::header::HeaderName, value: &str| {
            HeaderMap::from_iter([(name, HeaderValue::from_str(value).unwrap())])
        };
        let text = token.text();
        assert!(token.is_in(&with(COOKIE, &format!("a=b; {name}={text}; c=d"))));
        assert!(token.is_in(&with(AUTHORIZATION, &format!("Bearer {text}"))));
        for value in [String::new(), text[1..].to_owned(), format!("{text}0"), other.text().to_owned()] {
            assert!(!token.is_in(&with(COOKIE, &format!("{name}={value}"))), "{value}");
            assert!(!token.is_in(&with(AUTHORIZATION, &format!("Bearer {value}"))), "{value}");
        }
        assert!(!token.is_in(&with(COOKIE, &format!("x{name}={text}"))));
        assert!(!token.is_in(&with(AUTHORIZATION, &format!("Basic {text}"))));
        assert!(!token.is_in(&with(COOKIE, &format!("{NAME}_81={text}"))), "a server on another port");
        assert!(!token.is_in(&HeaderMap::new()));
    }
}
