//! `commission CODE --for FORM --out FILE`: the values in the form of a drive.

use super::given::{arguments, by_id, code, word};
use super::{Answer, ArgumentKind, CODE, Entry, Gives, OutputFile, Reads, commission, media};
use crate::commission::DriveForm;
pub use crate::commission::{eds, sinamics_script};
use order_code::OrderCode;
use words::{help, requests};

arguments! {
    /// Arguments of `commission --out`: actuator and drive.
    pub struct Args {
        /// Ordering code of the actuator.
        code: OrderCode = CODE => code,
        /// The form of the values.
        form: Option<DriveForm> = commission::FORM
            .of(ArgumentKind::Word(|| [DriveForm::Sinamics, DriveForm::Cia402].map(DriveForm::id).to_vec())).required()
            => word(by_id(&DriveForm::ALL, DriveForm::id)),
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "commission --out",
    path: "commission/drive",
    about: requests::commission_drive,
    reads: Reads::Nothing,
    arguments: Args::ARGUMENTS,
    gives: Gives::Media(&[media::PLAIN]),
    writes: &[OutputFile::of("out", &[media::PLAIN, media::JSON], help::commission_out).with("for")],
    example: "",
    answer: Some(|asked| {
        let Args { code, form } = Args::read(&asked.given)?;
        let about = commission::about(&code)?;
        let (text, ending) = match form {
            Some(DriveForm::Cia402) => (eds(&about, asked.language), "eds"),
            Some(DriveForm::Sinamics | DriveForm::Plain) | None => (sinamics_script(&about, asked.language), "txt"),
        };
        Ok(Answer::text(media::PLAIN, text).saved_as(format!("{code}.{ending}")))
    }),
};
