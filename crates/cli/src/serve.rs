//! `serve`: the web workbench.

use crate::answer::CommandAnswer;
use crate::fault::memory;
use clap::ArgMatches;
use quantities::Language;
use questions::list::Unanswered;
use server::{Access, Options, RequestLimits, Server};
use std::io::Write;
use std::net::IpAddr;
use std::path::PathBuf;
use words::{file_trouble, serving};

/// Default port: always the same, so that bookmarks stay valid.
const USUAL_PORT: u16 = 8377;

/// Examples of an address to listen on: one of a network, and all.
pub(crate) const EXAMPLES: [&str; 2] = ["192.168.1.5", "0.0.0.0"];

/// `antrieb serve [DIR]`
pub(crate) fn serve(matches: &ArgMatches, language: Language) -> Result<CommandAnswer, Unanswered> {
    let server = bound(matches, language)?;
    let url = server.url();
    let mut out = anstream::stdout();
    if let Err(error) = writeln!(out, "{url}").and_then(|()| out.flush()) {
        return Err(Unanswered::message(file_trouble(&error, language)));
    }
    let mut talk = anstream::stderr();
    let warning = match (server.is_reachable_from_elsewhere(), server.access()) {
        (false, Access::WithToken) => None,
        (true, Access::WithToken) => Some(serving::reachable(&server.address(), language)),
        (false, Access::Anyone) => Some(serving::open_to_the_machine(language).to_owned()),
        (true, Access::Anyone) => Some(serving::open_to_the_network(&server.address(), language)),
    };
    if let Some(warning) = warning {
        let _ = writeln!(talk, "{warning}");
    }
    if matches.get_flag("open")
        && let Err(error) = opener::open_browser(&url)
    {
        let _ = writeln!(talk, "{}", serving::no_browser(&error, language));
    }
    let _ = writeln!(talk, "{}", serving::how_to_end(language));
    server.run().map_err(|fault| Unanswered::message(fault.message(language)))?;
    Ok(CommandAnswer::none())
}

/// Returns a listening server: on the requested port, else on the default one or, if that is taken, on a free one.
fn bound(matches: &ArgMatches, language: Language) -> Result<Server, Unanswered> {
    let port = matches.get_one::<u16>("port").copied();
    let options = Options {
        folder: matches.get_one::<PathBuf>("folder").cloned().unwrap_or_else(|| PathBuf::from(".")),
        listen: listen(matches, language)?,
        access: if matches.get_flag("no-token") { Access::Anyone } else { Access::WithToken },
        port: port.unwrap_or(USUAL_PORT),
        memory: memory::allowed(matches, language)?,
        language,
        limits: RequestLimits::default(),
        press: crate::report::PRESS,
    };
    let first = Server::bind(options.clone());
    let bound = match (first, port) {
        (Err(server::Unserved::Address(..)), None) => Server::bind(Options { port: 0, ..options }),
        (first, _) => first,
    };
    bound.map_err(|fault| Unanswered::message(fault.message(language)))
}

fn listen(matches: &ArgMatches, language: Language) -> Result<Option<IpAddr>, Unanswered> {
    let Some(written) = matches.get_one::<String>("listen") else { return Ok(None) };
    written.parse().map(Some).map_err(|_| {
        let [one, all] = EXAMPLES;
        let hint = serving::listening_addresses(&one, &all, language);
        Unanswered::option("listen", (serving::no_listening_address(written, language), Some(hint)))
    })
}
