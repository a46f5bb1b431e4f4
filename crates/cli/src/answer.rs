//! What a command answers: data for stdout, talk for stderr, an exit code.

use serde::Serialize;
use std::io::Write;
use std::process::ExitCode;
use workbench::answers::{Fault, Faults};

/// The answer of a command.
#[derive(Debug, Default)]
pub(crate) struct Answer {
    /// For stdout.
    pub(crate) data: String,
    /// For stderr.
    pub(crate) talk: String,
    /// Exit code: 0 fits or answered, 1 does not fit, 2 not answered.
    pub(crate) code: u8,
    /// What kept the question from being answered.
    pub(crate) faults: Vec<Fault>,
}

/// A record as a file or standard output has it: JSON, indented, with a line feed at its end.
pub(crate) fn written(record: &impl Serialize) -> String {
    // A record has string keys and finite numbers only: nothing in it can fail.
    let mut text = serde_json::to_string_pretty(record).unwrap_or_default();
    text.push('\n');
    text
}

impl Answer {
    pub(crate) fn none() -> Self {
        Self::default()
    }

    pub(crate) fn data(data: String) -> Self {
        Self { data, ..Self::default() }
    }

    /// A record for stdout.
    pub(crate) fn record(record: &impl Serialize) -> Self {
        Self::data(written(record))
    }

    /// The question could not be answered; whoever asked for JSON gets the faults as a record.
    pub(crate) fn refused(talk: String, faults: Faults, as_json: bool) -> Self {
        let data = if as_json { written(&faults) } else { String::new() };
        Self { data, talk, code: 2, faults: faults.errors }
    }

    /// The arguments could not be read.
    pub(crate) fn fault(talk: String) -> Self {
        Self { talk, code: 2, ..Self::default() }
    }

    /// The same answer with a verdict.
    pub(crate) fn fits(self, fits: bool) -> Self {
        Self { code: u8::from(!fits), ..self }
    }

    /// Writes data and talk; colours are dropped where the stream is no terminal. A pipe that the reader closed is
    /// no fault; anything else that stdout refuses is.
    pub(crate) fn write(self) -> ExitCode {
        let _ = anstream::stderr().write_all(self.talk.as_bytes());
        let mut out = anstream::stdout();
        let written = out.write_all(self.data.as_bytes()).and_then(|()| out.flush());
        match written {
            Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
                let _ = writeln!(anstream::stderr(), "antrieb: stdout: {error}");
                ExitCode::from(2)
            }
            _ => ExitCode::from(self.code),
        }
    }
}
