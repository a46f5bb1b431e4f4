//! `serve`: the web workbench.

use crate::answer::Answer;
use crate::fault::{memory, option_fault, simple};
use clap::ArgMatches;
use server::{Limits, Options, Server};
use std::io::Write;
use std::net::IpAddr;
use std::path::PathBuf;
use workbench::Language;
use workbench::text::{file_trouble, serving};

/// The port unless another is asked for: the same one each time, so that a bookmark holds.
const USUAL_PORT: u16 = 8377;

/// What an address to listen on looks like: one of a network, and all.
pub(crate) const EXAMPLES: [&str; 2] = ["192.168.1.5", "0.0.0.0"];

/// `antrieb serve [DIR]`
pub(crate) fn serve(matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    answer(matches, as_json, language).unwrap_or_else(|fault| fault)
}

fn answer(matches: &ArgMatches, as_json: bool, language: Language) -> Result<Answer, Answer> {
    let server = bound(matches, as_json, language)?;
    let url = server.url();
    let mut out = anstream::stdout();
    if let Err(error) = writeln!(out, "{url}").and_then(|()| out.flush()) {
        return Err(simple(&file_trouble(&error, language), as_json, language));
    }
    let mut talk = anstream::stderr();
    if server.asks_for_a_token() {
        let _ = writeln!(talk, "{}", serving::reachable(&server.address(), language));
    }
    if matches.get_flag("open")
        && let Err(error) = opener::open_browser(&url)
    {
        let _ = writeln!(talk, "{}", serving::no_browser(&error, language));
    }
    let _ = writeln!(talk, "{}", serving::how_to_end(language));
    server.run().map_err(|fault| simple(&fault.message(language), as_json, language))?;
    Ok(Answer::none())
}

/// A server that listens: on the port that is asked for, else on the usual one or, where that is taken, on a free one.
fn bound(matches: &ArgMatches, as_json: bool, language: Language) -> Result<Server, Answer> {
    let port = matches.get_one::<u16>("port").copied();
    let options = Options {
        folder: matches.get_one::<PathBuf>("folder").cloned().unwrap_or_else(|| PathBuf::from(".")),
        listen: listen(matches, as_json, language)?,
        port: port.unwrap_or(USUAL_PORT),
        memory: memory::allowed(matches, as_json, language)?,
        language,
        limits: Limits::default(),
        press: crate::report::PRESS,
    };
    let first = Server::bind(options.clone());
    let bound = match (first, port) {
        (Err(server::Unserved::Address(..)), None) => Server::bind(Options { port: 0, ..options }),
        (first, _) => first,
    };
    bound.map_err(|fault| simple(&fault.message(language), as_json, language))
}

fn listen(matches: &ArgMatches, as_json: bool, language: Language) -> Result<Option<IpAddr>, Answer> {
    let Some(written) = matches.get_one::<String>("listen") else { return Ok(None) };
    written.parse().map(Some).map_err(|_| {
        let [one, all] = EXAMPLES;
        let hint = serving::listening_addresses(&one, &all, language);
        option_fault("listen", (serving::no_listening_address(written, language), Some(hint)), as_json, language)
    })
}
