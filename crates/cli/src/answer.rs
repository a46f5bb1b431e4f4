//! What a command answers: data for stdout, talk for stderr, an exit code.

use std::io::Write;
use std::process::ExitCode;

/// The answer of a command.
#[derive(Debug, Default)]
pub(crate) struct Answer {
    /// For stdout.
    pub(crate) data: String,
    /// For stderr.
    pub(crate) talk: String,
    /// Exit code: 0 fits or answered, 1 does not fit, 2 not answered.
    pub(crate) code: u8,
}

impl Answer {
    pub(crate) fn none() -> Self {
        Self::default()
    }

    pub(crate) fn data(data: String) -> Self {
        Self { data, ..Self::default() }
    }

    /// The question could not be answered.
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
