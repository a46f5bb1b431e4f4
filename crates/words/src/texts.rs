//! The notation of a text: a name with its English and its German, side by side.

/// A text without arguments, before its language is known.
pub type Word = fn(crate::Language) -> &'static str;

/// A text with its two languages as written in the source, for tests of all texts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Text {
    /// Name of the text and of the function that returns it.
    pub name: &'static str,
    /// English and German with arguments as `{name}`; separate pairs for singular and plural, and a single form if both
    /// languages have the same text.
    pub forms: &'static [&'static str],
}

impl Text {
    /// Returns the text in a language, with arguments still as `{name}`.
    #[must_use]
    pub fn plain(&self, language: crate::Language) -> &'static str {
        let [en, de] = match self.forms {
            [same] => [*same, *same],
            [en, de, ..] => [*en, *de],
            [] => ["", ""],
        };
        match language {
            crate::Language::En => en,
            crate::Language::De => de,
        }
    }
}

/// Defines texts, each as a function with this name whose last argument is the language, and the list of them all,
/// `TEXTS`.
///
/// ```text
/// name = "English" | "German";
/// same = "a word that both languages have";
/// with(value, unit) = "{value} {unit} is too much" | "{value} {unit} ist zu viel";
/// rows(count) = "1 row" | "1 Zeile", "{count} rows" | "{count} Zeilen";
/// ```
///
/// Arguments are inserted unchanged, so numbers must have the decimal mark of the language. With separate texts for
/// singular and plural, the first argument is the number.
macro_rules! texts {
    ($($name:ident $(($($arg:ident),+))? = $($form:literal)|+ $(, $($many:literal)|+)? ;)+) => {
        $( $crate::texts::texts!(@one $name $(($($arg),+))? = $($form)|+ $(, $($many)|+)?); )+

        /// Every text of this module.
        pub const TEXTS: &[$crate::texts::Text] = &[
            $( $crate::texts::Text { name: stringify!($name), forms: &[$($form,)+ $($($many,)+)?] }, )+
        ];
    };
    (@one $name:ident = $same:literal) => {
        #[doc = concat!("`` ", $same, " ``")]
        #[must_use]
        pub const fn $name(_: $crate::Language) -> &'static str {
            $same
        }
    };
    (@one $name:ident = $en:literal | $de:literal) => {
        #[doc = concat!("`` ", $en, " ``")]
        #[must_use]
        pub const fn $name(language: $crate::Language) -> &'static str {
            match language {
                $crate::Language::En => $en,
                $crate::Language::De => $de,
            }
        }
    };
    (@one $name:ident ($($arg:ident),+) = $en:literal | $de:literal) => {
        #[doc = concat!("`` ", $en, " ``")]
        #[must_use]
        #[allow(clippy::too_many_arguments, reason = "as many as the text has values")]
        pub fn $name($($arg: &dyn ::std::fmt::Display,)+ language: $crate::Language) -> String {
            match language {
                $crate::Language::En => format!($en),
                $crate::Language::De => format!($de),
            }
        }
    };
    (@one $name:ident ($count:ident $(, $arg:ident)*) = $en:literal | $de:literal, $en_many:literal | $de_many:literal) => {
        #[doc = concat!("`` ", $en_many, " ``")]
        #[must_use]
        pub fn $name($count: usize, $($arg: &dyn ::std::fmt::Display,)* language: $crate::Language) -> String {
            match ($count, language) {
                (1, $crate::Language::En) => format!($en),
                (1, $crate::Language::De) => format!($de),
                (_, $crate::Language::En) => format!($en_many),
                (_, $crate::Language::De) => format!($de_many),
            }
        }
    };
}

pub(crate) use texts;

/// Formats a text in a language, written as in [`texts`]: its English and its German, then the arguments of both
/// besides the names in scope.
///
/// ```text
/// said!(language => "axis \"{name}\"" | "Achse „{name}“")
/// said!(language => "no column is named {}" | "keine Spalte heißt {}", quoted(name, language))
/// ```
macro_rules! said {
    ($language:expr => $en:literal | $de:literal $(, $arg:expr)*) => {
        match $language {
            ::quantities::Language::En => format!($en $(, $arg)*),
            ::quantities::Language::De => format!($de $(, $arg)*),
        }
    };
}

pub(crate) use said;
