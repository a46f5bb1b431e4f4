//! The browser of the machine and the program that drives it.

use crate::tab::Tab;
use fantoccini::ClientBuilder;
use fantoccini::wd::Capabilities;
use hyper_util::client::legacy::connect::HttpConnector;
use serde_json::json;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::rc::Rc;
use tokio::runtime::Runtime;

/// Options of a test browser: headless, for a small machine, without network requests of its own.
const ARGUMENTS: [&str; 11] = [
    "--headless=new",
    "--window-size=1440,987",
    "--no-sandbox",
    "--disable-dev-shm-usage",
    "--disable-gpu",
    "--disable-quic",
    "--disable-sync",
    "--disable-background-networking",
    "--disable-component-update",
    "--no-first-run",
    "--no-default-browser-check",
];

/// The driver, which runs as long as this is held.
pub(crate) struct Driver {
    process: Child,
    address: String,
    runtime: Rc<Runtime>,
}

impl Driver {
    /// Starts it.
    pub(crate) fn start(program: &Path) -> Result<Self, String> {
        let mut command = Command::new(program);
        command.arg("--port=0").stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::null());
        let mut process = command.spawn().map_err(|error| format!("{}: {error}", program.display()))?;
        let output = process.stdout.take().ok_or("no output of the driver")?;
        let mut lines = BufReader::new(output).lines().map_while(Result::ok);
        let port_in = |line: String| line.split_once("started successfully on port ").map(|(_, rest)| rest.to_owned());
        let port: String = lines
            .find_map(port_in)
            .map(|rest| rest.chars().take_while(char::is_ascii_digit).collect())
            .ok_or("the driver names no port")?;
        // What it says further is of no interest, but must have somewhere to go.
        drop(std::thread::spawn(move || lines.for_each(drop)));
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build();
        let runtime = Rc::new(runtime.map_err(|error| error.to_string())?);
        Ok(Self { process, address: format!("http://127.0.0.1:{port}"), runtime })
    }

    /// A browser with nothing kept of earlier ones; what it downloads comes into `folder`.
    pub(crate) fn browser(&self, chromium: &Path, folder: &Path) -> Result<Tab, String> {
        let options = json!({
            "binary": chromium,
            "args": ARGUMENTS,
            "prefs": {
                "download.default_directory": folder,
                "download.prompt_for_download": false,
                "intl.accept_languages": "en",
            },
        });
        let mut wanted = Capabilities::new();
        let _ = wanted.insert("goog:chromeOptions".to_owned(), options);
        let _ = wanted.insert("goog:loggingPrefs".to_owned(), json!({ "browser": "ALL" }));
        let mut builder = ClientBuilder::new(HttpConnector::new());
        let client = self.runtime.block_on(builder.capabilities(wanted).connect(&self.address));
        Tab::new(client.map_err(|error| error.to_string())?, Rc::clone(&self.runtime))
    }
}

impl Drop for Driver {
    fn drop(&mut self) {
        // It ends its browsers with itself.
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}
