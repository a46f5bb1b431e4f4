//! `drive`: the virtual drive of a code.

use crate::answer::CommandAnswer;
use crate::fault::memory;
use crate::source::SourceFile;
use crate::waiting::progress;
use axis::AxisProject;
use clap::ArgMatches;
use order_code::OrderCode;
use quantities::{Language, MomentOfInertia};
use questions::drive::{Time, bare_axis, eds, with_drive};
use questions::list::{AXIS, Cost, Given, Inquiry, Reads, Unanswered};
use questions::{embedded_catalogue, read_code, read_quantity};
use server::{DriveProtocol, DriveServer, Unserved};
use std::io::Write;
use std::path::PathBuf;
use words::{file_trouble, serving};

/// Returns the default port of a protocol: that of socketcand, and the one below it.
const fn usual_port(protocol: DriveProtocol) -> u16 {
    match protocol {
        DriveProtocol::Line => 29_535,
        DriveProtocol::SocketCand => 29_536,
    }
}

/// `antrieb drive CODE`
pub(crate) fn drive(matches: &ArgMatches, language: Language) -> Result<CommandAnswer, Unanswered> {
    let word = |name: &str| matches.get_one::<String>(name).map(String::as_str);
    let written: Vec<&str> = matches.get_many::<String>("code").into_iter().flatten().map(String::as_str).collect();
    let text = written.join(" ");
    let reading = read_code(&text, language);
    let code = reading.map_err(|refusal| Unanswered::Code { text, refusal, among: false })?.parsed.code;
    let inertia = word("inertia").map(|text| read_quantity::<MomentOfInertia>(text, language)).transpose();
    let inertia = inertia.map_err(|fault| Unanswered::option("inertia", fault))?;
    let project = match matches.get_one::<PathBuf>("project-file") {
        Some(path) => {
            let memory = memory::allowed(matches, language)?;
            of_file(&SourceFile::read(path, Reads::Project, memory, language)?, word("axis"), language)?
        }
        None => bare_axis(&code, inertia, embedded_catalogue(), language)?,
    };
    let node = matches.get_one::<u8>("node").copied().unwrap_or(1);
    let seed = matches.get_one::<u32>("seed").copied().unwrap_or(0);
    if matches.get_flag("eds") {
        let sheet = with_drive(&project, &code, (node, seed), language, |drive| eds(&drive, &code, node, language))?;
        return Ok(CommandAnswer::data(sheet));
    }
    let protocol = word("protocol").and_then(DriveProtocol::of).unwrap_or_default();
    let time = word("time").and_then(Time::of).unwrap_or_default();
    let server = bound(matches.get_one::<u16>("port").copied(), protocol, time)
        .map_err(|fault| Unanswered::message(fault.message(language)))?;
    serve(&project, &code, (node, seed), (server, protocol), language)
}

fn serve(
    project: &AxisProject,
    code: &OrderCode,
    (node, seed): (u8, u32),
    (server, protocol): (DriveServer, DriveProtocol),
    language: Language,
) -> Result<CommandAnswer, Unanswered> {
    let served = with_drive(project, code, (node, seed), language, |drive| {
        let address = server.address();
        let mut out = anstream::stdout();
        if let Err(error) = writeln!(out, "{address}").and_then(|()| out.flush()) {
            return Err(file_trouble(&error, language));
        }
        let mut talk = anstream::stderr();
        let _ = writeln!(talk, "{}", serving::drive_listens(&address, &protocol.id(), language));
        let _ = writeln!(talk, "{}", serving::drive_is_open(language));
        let _ = writeln!(talk, "{}", serving::how_to_end(language));
        server.run(drive, node).map_err(|fault| fault.message(language))
    })?;
    served.map(|()| CommandAnswer::none()).map_err(Unanswered::message)
}

/// Listens on the requested port, else on the default one or, if that is taken, on a free one.
fn bound(port: Option<u16>, protocol: DriveProtocol, time: Time) -> Result<DriveServer, Unserved> {
    let first = DriveServer::bind(port.unwrap_or(usual_port(protocol)), protocol, time);
    match (first, port) {
        (Err(Unserved::Address(..)), None) => DriveServer::bind(0, protocol, time),
        (first, _) => first,
    }
}

/// Returns the axis of a project.
fn of_file(file: &SourceFile, axis: Option<&str>, language: Language) -> Result<AxisProject, Unanswered> {
    let inquiry = Inquiry {
        given: Given::of(&[AXIS], [], language)?,
        sources: vec![file.source()],
        catalogue: embedded_catalogue(),
        days_since_1970: None,
        progress: progress(),
        refuses_long: true,
        by_axes: false,
        language,
    };
    inquiry.axis(axis, Cost::Other).map(|(_, project)| project)
}
