//! `commission CODE --blank FILE`: an empty record of measured values.

use super::given::{arguments, code};
use super::{Answer, CODE, Entry, Gives, OutputFile, Reads, commission, media};
pub use crate::commission::blank_record;
use order_code::OrderCode;
use words::help;

arguments! {
    /// Arguments of `commission --blank`: the actuator.
    pub struct Args {
        /// Ordering code of the actuator.
        code: OrderCode = CODE => code,
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "commission --blank",
    path: "commission/blank",
    about: help::commission_blank,
    reads: Reads::Nothing,
    arguments: Args::ARGUMENTS,
    gives: Gives::Media(&[media::TOML]),
    writes: &[OutputFile::of("blank", &[media::TOML], help::commission_blank)],
    example: "",
    answer: Some(|asked| {
        let code = Args::read(&asked.given)?.code;
        let file = format!("{code}-measured.toml");
        let text = blank_record(&commission::about(&code)?, &file, asked.language);
        Ok(Answer::text(media::TOML, text).saved_as(file))
    }),
};
