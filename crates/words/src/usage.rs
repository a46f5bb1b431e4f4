//! Words for invalid calls.

use super::hint_text;
use crate::texts::said;
use project::Hint;
use quantities::Language;

/// Faults of a call.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Usage {
    /// The command does not exist.
    UnknownCommand {
        /// Spelling of the call.
        written: String,
    },
    /// The option does not exist.
    UnknownOption {
        /// Spelling of the call.
        written: String,
    },
    /// The option is one of another command.
    OptionOf {
        /// Spelling of the call.
        written: String,
        /// Command of the call.
        command: String,
        /// Command that has the option.
        other: String,
    },
    /// The project does not exist.
    NoFile {
        /// Spelling of the call.
        written: String,
    },
    /// The command takes no such argument.
    NoSuchArgument {
        /// Spelling of the call.
        written: String,
        /// The command.
        command: String,
    },
    /// A part of a code stands for several actuators where one is expected.
    SeveralCodes {
        /// Spelling of the call.
        written: String,
        /// Number of the actuators.
        count: usize,
    },
    /// A project of several axes stands where one actuator is expected.
    SeveralAxes {
        /// Names of the axes.
        names: String,
    },
    /// The encoder of the actuator has no battery.
    NoBattery {
        /// Ordering code.
        code: String,
    },
    /// The word may be the value of several options.
    SeveralOptions {
        /// Spelling of the call.
        written: String,
        /// The options.
        options: Vec<String>,
    },
    /// A recording stands where a project is expected.
    Recording {
        /// Spelling of the call.
        written: String,
    },
    /// Required arguments are missing.
    Missing {
        /// Names of the arguments in the help.
        names: String,
    },
    /// The value is invalid for the argument.
    BadValue {
        /// Spelling of the call.
        written: String,
        /// Name of the argument in the help.
        name: String,
    },
    /// The option has no value.
    ValueMissing {
        /// Name of the option in the help.
        name: String,
    },
    /// The option is given twice.
    Twice {
        /// Name of the option in the help.
        name: String,
    },
    /// The call has no command.
    NoCommand,
    /// An argument is not valid UTF-8.
    NotUtf8,
    /// A text exceeds the limit of its length.
    TooLong {
        /// Largest number of characters.
        most: usize,
    },
    /// The text is no amount of memory.
    NoMemory {
        /// Spelling of the call.
        written: String,
    },
    /// Any other fault.
    Other,
}

/// Remedies for a fault of a call.
#[derive(Clone, Debug, PartialEq)]
pub enum UsageHint {
    /// A similar word, or all valid words.
    Words(Hint),
    /// Valid range, from and to.
    Range(String, String),
    /// A whole number.
    WholeNumber,
    /// Syntax of an amount of memory.
    Memory,
    /// Calls that work, with the words of the faulty one.
    Calls(Vec<String>),
    /// Reference to the help.
    Help,
}

/// Returns the fault of a call, in one sentence.
#[must_use]
pub fn usage_text(usage: &Usage, language: Language) -> String {
    match usage {
        Usage::UnknownCommand { written } => {
            said!(language => "unknown command \"{written}\"" | "unbekannter Befehl „{written}“")
        }
        Usage::UnknownOption { written } => {
            said!(language => "unknown option \"{written}\"" | "unbekannte Option „{written}“")
        }
        Usage::OptionOf { written, command, other } => said!(language =>
            "\"{written}\" is an option of `{other}`, not of `{command}`"
            | "„{written}“ ist eine Option von `{other}`, nicht von `{command}`"
        ),
        Usage::NoFile { written } => said!(language =>
            "{written}: there is no such file" | "{written}: diese Datei existiert nicht"
        ),
        Usage::NoSuchArgument { written, command } => said!(language =>
            "\"{written}\" is no argument of `{command}`" | "„{written}“ ist kein Argument von `{command}`"
        ),
        Usage::SeveralCodes { written, count } => said!(language =>
            "\"{written}\" stands for {count} actuators, one is expected"
            | "„{written}“ steht für {count} Antriebe, erwartet wird einer"
        ),
        Usage::SeveralAxes { names } => crate::terminal::several_axes(names, language),
        Usage::NoBattery { code } => said!(language =>
            "the encoder of {code} has no battery" | "der Geber von {code} hat keine Batterie"
        ),
        Usage::SeveralOptions { written, options } => {
            let options = options.join(", ");
            said!(language =>
                "\"{written}\" may be the value of several options: {options}"
                | "„{written}“ kann der Wert mehrerer Optionen sein: {options}"
            )
        }
        Usage::Recording { written } => said!(language =>
            "\"{written}\" is a recording or a table; a project that names it is expected"
            | "„{written}“ ist eine Aufzeichnung oder Tabelle; erwartet wird ein Projekt, das sie nennt"
        ),
        Usage::Missing { names } if names.contains(", ") => {
            said!(language => "{names} are missing" | "es fehlen {names}")
        }
        Usage::Missing { names } => said!(language => "{names} is missing" | "es fehlt {names}"),
        Usage::BadValue { written, name } => {
            said!(language => "\"{written}\" is not a valid value for {name}" | "„{written}“ ist kein gültiger Wert für {name}")
        }
        Usage::ValueMissing { name } => {
            said!(language => "{name} requires a value" | "{name} erfordert einen Wert")
        }
        Usage::Twice { name } => said!(language => "{name} is given twice" | "{name} ist doppelt angegeben"),
        Usage::NoCommand => said!(language => "a command is missing" | "es fehlt ein Befehl"),
        Usage::NotUtf8 => said!(language => "an argument is not UTF-8 text" | "ein Argument ist kein UTF-8-Text"),
        Usage::TooLong { most } => said!(language => "longer than {most} characters" | "länger als {most} Zeichen"),
        Usage::NoMemory { written } => {
            said!(language => "\"{written}\" is not an amount of memory" | "„{written}“ ist keine Speichergröße")
        }
        Usage::Other => said!(language => "invalid command line" | "ungültiger Aufruf"),
    }
}

/// Returns the remedy as text.
#[must_use]
pub fn usage_hint(hint: &UsageHint, language: Language) -> String {
    match hint {
        UsageHint::Words(hint) => hint_text(hint, language),
        UsageHint::Range(from, to) => {
            said!(language => "valid range: {from} to {to}" | "gültiger Bereich: {from} bis {to}")
        }
        UsageHint::WholeNumber => said!(language => "a whole number is expected" | "erwartet wird eine ganze Zahl"),
        UsageHint::Memory => {
            said!(language => "1 MiB to 64 GiB, for example \"512 MiB\"" | "1 MiB bis 64 GiB, zum Beispiel \"512 MiB\"")
        }
        UsageHint::Calls(calls) => {
            let calls = calls.join("\n");
            said!(language => "write: {calls}" | "so schreiben: {calls}")
        }
        UsageHint::Help => said!(language => "--help shows the syntax" | "--help zeigt den Aufruf"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_fault_of_a_call_has_its_sentence_in_both_languages() {
        let word = || "--word".to_owned();
        let all = [
            Usage::UnknownCommand { written: word() },
            Usage::UnknownOption { written: word() },
            Usage::NoSuchArgument { written: word(), command: word() },
            Usage::SeveralOptions { written: word(), options: vec![word(), word()] },
            Usage::Recording { written: word() },
            Usage::Missing { names: word() },
            Usage::BadValue { written: word(), name: word() },
            Usage::ValueMissing { name: word() },
            Usage::Twice { name: word() },
            Usage::NoCommand,
            Usage::NotUtf8,
            Usage::TooLong { most: 1 },
            Usage::NoMemory { written: word() },
            Usage::SeveralCodes { written: "CHA-25A".into(), count: 2 },
            Usage::SeveralAxes { names: "lift, swivel".into() },
            Usage::NoBattery { code: "CHA-25A-100-H-C1024".into() },
            Usage::Other,
        ];
        for usage in all {
            let [en, de] = [Language::En, Language::De].map(|language| usage_text(&usage, language));
            assert!(en.len() > 10 && de.len() > 10 && en != de, "{usage:?}");
        }
        let hints = [
            UsageHint::Range(word(), word()),
            UsageHint::WholeNumber,
            UsageHint::Memory,
            UsageHint::Calls(vec![word()]),
            UsageHint::Help,
        ];
        for hint in hints {
            let [en, de] = [Language::En, Language::De].map(|language| usage_hint(&hint, language));
            assert!(en.len() > 10 && de.len() > 10 && en != de, "{hint:?}");
        }
    }
}
