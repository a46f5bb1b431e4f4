//! The two ways of serving the page, each at an address of this machine.

use std::fs;
use std::io::{BufRead, BufReader, Write};
use std::net::{TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// The page as it is served.
pub(crate) enum Shell {
    /// Served by `antrieb serve`, with a folder on disk.
    Server { process: Child, address: String, token: String, folder: tempfile::TempDir },
    /// Served as a static folder, by a host of plain files.
    Site { address: String, folder: PathBuf, is_up: Arc<AtomicBool> },
}

/// Path of the folder, which is not at the top level of its host.
const BELOW: &str = "/somewhere/antrieb/";

impl Shell {
    /// Starts the program in a temporary folder.
    pub(crate) fn server(program: &Path) -> Result<Self, String> {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let mut command = Command::new(program);
        command.arg("serve").arg(folder.path()).args(["--port", "0", "--lang", "en"]);
        command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::null());
        let mut process = command.spawn().map_err(|error| format!("{}: {error}", program.display()))?;
        let mut line = String::new();
        let output = process.stdout.take().ok_or("no output of the program")?;
        BufReader::new(output).read_line(&mut line).map_err(|error| error.to_string())?;
        let (address, token) = line.trim().split_once("?token=").ok_or("no token in the address")?;
        Ok(Self::Server { process, address: address.to_owned(), token: token.to_owned(), folder })
    }

    /// Serves a static folder.
    pub(crate) fn site(folder: &Path) -> Result<Self, String> {
        let listener = TcpListener::bind("127.0.0.1:0").map_err(|error| error.to_string())?;
        let port = listener.local_addr().map_err(|error| error.to_string())?.port();
        let is_up = Arc::new(AtomicBool::new(true));
        let (root, up) = (folder.to_owned(), Arc::clone(&is_up));
        drop(std::thread::spawn(move || {
            for stream in listener.incoming().flatten().take_while(|_| up.load(Ordering::Relaxed)) {
                let root = root.clone();
                // A client that disconnects early is not an error of the host.
                drop(std::thread::spawn(move || drop(sent(&stream, &root))));
            }
        }));
        Ok(Self::Site { address: format!("http://127.0.0.1:{port}{BELOW}"), folder: folder.to_owned(), is_up })
    }

    pub(crate) fn name(&self) -> &'static str {
        match self {
            Self::Server { .. } => "server",
            Self::Site { .. } => "site",
        }
    }

    /// Returns the address of the page with a query.
    pub(crate) fn at(&self, query: &str) -> String {
        match self {
            // Each browser begins without the token.
            Self::Server { address, token, .. } => format!("{address}?token={token}&{query}"),
            Self::Site { address, .. } => format!("{address}?{query}"),
        }
    }

    /// Returns the folder on disk, if there is one.
    pub(crate) fn folder(&self) -> Option<PathBuf> {
        match self {
            Self::Server { folder, .. } => Some(folder.path().to_owned()),
            Self::Site { .. } => None,
        }
    }
}

impl Drop for Shell {
    fn drop(&mut self) {
        match self {
            Self::Server { process, .. } => {
                let _ = process.kill();
                let _ = process.wait();
            }
            Self::Site { is_up, .. } => is_up.store(false, Ordering::Relaxed),
        }
    }
}

/// Answers one request for a file.
fn sent(mut stream: &TcpStream, root: &Path) -> std::io::Result<()> {
    let mut head = BufReader::new(stream);
    let mut line = String::new();
    head.read_line(&mut line)?;
    loop {
        let mut header = String::new();
        if head.read_line(&mut header)? < 3 {
            break;
        }
    }
    let path = line.split(' ').nth(1).and_then(|path| path.split('?').next()).unwrap_or_default();
    let name = match path.strip_prefix(BELOW) {
        Some("") => "index.html",
        Some(name) if !name.contains("..") => name,
        _ => "none",
    };
    let media = match name.rsplit_once('.').map(|(_, ending)| ending) {
        Some("html") => "text/html",
        Some("js") => "text/javascript",
        Some("css") => "text/css",
        Some("wasm") => "application/wasm",
        _ => "text/plain",
    };
    let (status, body) = match fs::read(root.join(name)) {
        Ok(body) => ("200 OK", body),
        Err(_) => ("404 Not Found", Vec::new()),
    };
    let head = format!(
        "HTTP/1.1 {status}\r\ncontent-type: {media}\r\ncontent-length: {}\r\nconnection: close\r\n\r\n",
        body.len()
    );
    stream.write_all(head.as_bytes())?;
    stream.write_all(&body)
}
