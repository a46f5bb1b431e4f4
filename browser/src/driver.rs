//! The browser and its WebDriver.

use crate::make::Make;
use crate::tab::Tab;
use fantoccini::ClientBuilder;
use fantoccini::wd::Capabilities;
use hyper_util::client::legacy::connect::HttpConnector;
use serde_json::{Value, json};
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

/// A running driver, terminated on drop.
pub(crate) struct Driver {
    pub(crate) make: Make,
    process: Child,
    address: String,
    runtime: Rc<Runtime>,
}

impl Driver {
    /// Starts the driver.
    pub(crate) fn start(program: &Path) -> Result<Self, String> {
        let mut command = Command::new(program);
        command.arg("--port=0").stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::null());
        let mut process = command.spawn().map_err(|error| format!("{}: {error}", program.display()))?;
        let output = process.stdout.take().ok_or("no output of the driver")?;
        let mut lines = BufReader::new(output).lines().map_while(Result::ok);
        let make = Make::of(program);
        let port_in = |line: String| line.split_once(make.before_the_port()).map(|(_, rest)| rest.to_owned());
        let port: String = lines
            .find_map(port_in)
            .map(|rest| rest.chars().take_while(char::is_ascii_digit).collect())
            .ok_or("the driver names no port")?;
        // Further output is not needed, but the pipe must be emptied.
        drop(std::thread::spawn(move || lines.for_each(drop)));
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build();
        let runtime = Rc::new(runtime.map_err(|error| error.to_string())?);
        Ok(Self { make, process, address: format!("http://127.0.0.1:{port}"), runtime })
    }

    /// Starts a browser with an empty profile that downloads to `folder`.
    pub(crate) fn browser(&self, program: &Path, folder: &Path) -> Result<Tab, String> {
        let mut wanted = Capabilities::new();
        let _ = match self.make {
            Make::Chromium => {
                let _ = wanted.insert("goog:loggingPrefs".to_owned(), json!({ "browser": "ALL" }));
                wanted.insert("goog:chromeOptions".to_owned(), chromium(program, folder))
            }
            Make::Firefox => wanted.insert("moz:firefoxOptions".to_owned(), firefox(program, folder)),
        };
        let mut builder = ClientBuilder::new(HttpConnector::new());
        let client = self.runtime.block_on(builder.capabilities(wanted).connect(&self.address));
        Tab::new(client.map_err(|error| error.to_string())?, Rc::clone(&self.runtime), self.make)
    }
}

fn chromium(program: &Path, folder: &Path) -> Value {
    json!({
        "binary": program,
        "args": ARGUMENTS,
        "prefs": {
            "download.default_directory": folder,
            "download.prompt_for_download": false,
            "intl.accept_languages": "en",
        },
    })
}

fn firefox(program: &Path, folder: &Path) -> Value {
    json!({
        "binary": program,
        "args": ["-headless", "--width=1440", "--height=987"],
        "prefs": {
            "browser.download.folderList": 2,
            "browser.download.dir": folder,
            "browser.download.always_ask_before_handling_new_types": false,
            "pdfjs.disabled": true,
            "browser.helperApps.neverAsk.saveToDisk": SAVED,
            "intl.accept_languages": "en",
            // A page with unsaved work is left without a dialog: a browser that shows one does not end.
            "dom.disable_beforeunload": true,
            // A window in the background receives focus events too.
            "focusmanager.testmode": true,
            // Permits clipboard access without a dialog, as after a click of the user.
            "dom.events.testing.asyncClipboard": true,
        },
    })
}

/// Media types that Firefox saves without a dialog.
const SAVED: &str = "application/pdf,application/octet-stream,text/csv,text/plain,application/toml,image/svg+xml,\
    application/vnd.openxmlformats-officedocument.spreadsheetml.sheet";

impl Drop for Driver {
    fn drop(&mut self) {
        // The driver terminates its browsers when it ends.
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}
