//! The fields of a code and their words.

use crate::grammar::Series;
use std::fmt;

macro_rules! words {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        ///
        /// Stored as the index of its word within the series.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub struct $name {
            series: Series,
            place: u8,
        }

        impl $name {
            /// Creates the value from the index of its word, which the data guarantee to exist.
            #[must_use]
            pub const fn at(series: Series, place: u8) -> Self {
                Self { series, place }
            }

            /// Iterates over the values of a series, in the order of the ordering tables.
            pub fn all(series: Series) -> impl DoubleEndedIterator<Item = Self> + ExactSizeIterator + Clone {
                // The build script limits a field to 64 words.
                let places = 0..u8::try_from(series.words(Field::$name).len()).unwrap_or(u8::MAX);
                (places.start..places.end).map(move |place| Self { series, place })
            }

            /// Returns the value of a word in a series, if the series has it.
            #[must_use]
            pub fn of(series: Series, word: &str) -> Option<Self> {
                Self::all(series).find(|value| value.as_str() == word)
            }

            /// Returns the word used in the code.
            #[must_use]
            pub fn as_str(self) -> &'static str {
                self.series.words(Field::$name).get(self.place()).copied().unwrap_or_default()
            }

            /// Returns the series that the value belongs to.
            #[must_use]
            pub const fn series(self) -> Series {
                self.series
            }

            /// Returns the index of the word among the words of the field.
            #[must_use]
            pub fn place(self) -> usize {
                usize::from(self.place)
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(self.as_str())
            }
        }

        impl fmt::Debug for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(self.as_str())
            }
        }
    };
}

words! {
    /// Frame size with version letter.
    Size
}

words! {
    /// Reduction ratio.
    Ratio
}

words! {
    /// Motor winding and connector configuration.
    Winding
}

words! {
    /// Motor feedback system.
    Feedback
}

words! {
    /// Option 1, sensor: an encoder at the output.
    Option1
}

words! {
    /// Option 2, cable and connector exit.
    Option2
}

impl Size {
    /// Returns the frame size as a number: 20 for `20A`.
    #[must_use]
    pub fn number(self) -> u16 {
        leading_number(self.as_str())
    }
}

impl Ratio {
    /// Returns the reduction ratio as a number \[1\].
    #[must_use]
    pub fn value(self) -> u16 {
        leading_number(self.as_str())
    }
}

fn leading_number(word: &str) -> u16 {
    let digits = word.bytes().take_while(u8::is_ascii_digit);
    digits.fold(0, |number: u16, digit| number.saturating_mul(10).saturating_add(u16::from(digit - b'0')))
}

/// Holding brake of a code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Brake {
    /// No brake; the code has no word for it.
    Without,
    /// Brake fitted; the code contains the word of the series.
    With,
}

impl Brake {
    /// The two values, without brake first.
    pub const ALL: &'static [Self] = &[Self::Without, Self::With];
}

/// A field of a code; each series has its own order of fields.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Field {
    /// Word of the series at the beginning of the code.
    Series,
    /// Frame size and version letter.
    Size,
    /// Reduction ratio.
    Ratio,
    /// Motor winding and connector configuration.
    Winding,
    /// Motor feedback.
    Feedback,
    /// Holding brake.
    Brake,
    /// Option 1, sensor at the output.
    Option1,
    /// Option 2, cable and connector exit.
    Option2,
    /// Special design.
    Special,
}

impl Field {
    /// Fields of the codes of every series.
    pub const ALL: &'static [Self] = &[
        Self::Series,
        Self::Size,
        Self::Ratio,
        Self::Winding,
        Self::Feedback,
        Self::Brake,
        Self::Option1,
        Self::Option2,
        Self::Special,
    ];

    /// Returns the identifier used in data exchange.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Series => "series",
            Self::Size => "size",
            Self::Ratio => "ratio",
            Self::Winding => "winding",
            Self::Feedback => "feedback",
            Self::Brake => "brake",
            Self::Option1 => "option_1",
            Self::Option2 => "option_2",
            Self::Special => "special",
        }
    }
}

impl fmt::Display for Field {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Option1 => "option 1",
            Self::Option2 => "option 2",
            Self::Special => "special design",
            other => other.id(),
        })
    }
}

/// An ordering code that follows the grammar of its series, not necessarily one that can be ordered.
///
/// Displayed in the canonical spelling, `CHA-20A-100-H-C1024-B-EC-K-SP`; an absent field leaves no gap. Sorted by
/// series, then by the fields in their order, each as in the ordering tables. All values belong to one series.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct OrderCode {
    /// Frame size and version letter.
    pub size: Size,
    /// Reduction ratio.
    pub ratio: Ratio,
    /// Motor winding and connector configuration.
    pub winding: Winding,
    /// Motor feedback.
    pub feedback: Feedback,
    /// Holding brake.
    pub brake: Brake,
    /// Option 1, sensor at the output.
    pub option_1: Option<Option1>,
    /// Option 2, cable and connector exit.
    pub option_2: Option<Option2>,
    /// Special design to customer specification.
    pub special: bool,
}

impl OrderCode {
    /// Returns the series of the code.
    #[must_use]
    pub const fn series(&self) -> Series {
        self.size.series()
    }

    /// Returns `true` if the actuator has an encoder at the output.
    #[must_use]
    pub const fn has_output_encoder(&self) -> bool {
        self.option_1.is_some()
    }

    /// Returns the word of a field, or `None` if the code omits it.
    #[must_use]
    pub fn token(&self, field: Field) -> Option<&'static str> {
        let only = |stands: bool| self.series().words(field).first().copied().filter(|_| stands);
        match field {
            Field::Series => only(true),
            Field::Size => Some(self.size.as_str()),
            Field::Ratio => Some(self.ratio.as_str()),
            Field::Winding => Some(self.winding.as_str()),
            Field::Feedback => Some(self.feedback.as_str()),
            Field::Brake => only(self.brake == Brake::With),
            Field::Option1 => self.option_1.map(Option1::as_str),
            Field::Option2 => self.option_2.map(Option2::as_str),
            Field::Special => only(self.special),
        }
    }
}

impl fmt::Display for OrderCode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let tokens: Vec<&str> = self.series().fields().filter_map(|field| self.token(field)).collect();
        f.pad(&tokens.join("-"))
    }
}
