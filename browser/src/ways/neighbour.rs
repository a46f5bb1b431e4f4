//! A server of another user on the same machine: at the same address, at another port.

use crate::shell::Shell;
use crate::stage::OpenPage;
use crate::tab::{Worded, expect};
use std::io::{BufRead, BufReader, Write};
use std::net::TcpListener;
use std::sync::{Arc, Mutex, PoisonError};

/// A link and a redirect lead the browser to the other server; neither the request nor the page has the token.
pub(crate) fn a_server_at_another_port_gets_no_token(stage: &OpenPage<'_>) -> Worded {
    let Shell::Server { address, token, .. } = stage.shell else { return Ok(()) };
    let tab = &stage.tab;
    stage.start("en")?;
    tab.until("!location.href.includes('token')")?;
    let (port, heads) = neighbour().map_err(|error| error.to_string())?;
    tab.run(&format!("location.href = 'http://127.0.0.1:{port}/go'; return null;"), Vec::new())?;
    tab.until("document.title === 'neighbour'")?;
    tab.until("document.cookie === '' && localStorage.length === 0")?;
    let seen = heads.lock().unwrap_or_else(PoisonError::into_inner).concat();
    expect(seen.contains("GET /here") && !seen.contains(token.as_str()), || seen.clone())?;
    // The browser has kept the token for the page, and the address does not show it.
    tab.open(&format!("{address}?lang=en"))?;
    tab.there("#start-title")?;
    tab.until("!location.href.includes('token')")
}

/// Headers of the requests that a server receives.
type Heads = Arc<Mutex<Vec<String>>>;

/// Starts a server that redirects once to itself, and returns its port.
fn neighbour() -> std::io::Result<(u16, Heads)> {
    let listener = TcpListener::bind("127.0.0.1:0")?;
    let port = listener.local_addr()?.port();
    let heads = Heads::default();
    let seen = Arc::clone(&heads);
    drop(std::thread::spawn(move || {
        for mut stream in listener.incoming().flatten() {
            let mut head = String::new();
            let mut lines = BufReader::new(&stream);
            while lines.read_line(&mut head).is_ok_and(|read| read > 2) {}
            let answer = if head.starts_with("GET /go") {
                "HTTP/1.1 302 Found\r\nlocation: /here\r\nconnection: close\r\ncontent-length: 0\r\n\r\n"
            } else {
                "HTTP/1.1 200 OK\r\ncontent-type: text/html\r\nconnection: close\r\n\r\n<title>neighbour</title>"
            };
            seen.lock().unwrap_or_else(PoisonError::into_inner).push(head);
            let _ = stream.write_all(answer.as_bytes());
        }
    }));
    Ok((port, heads))
}
