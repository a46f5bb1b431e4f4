//! The fields of a code and their words.

use crate::grammar::Series;
use std::fmt;

macro_rules! words {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        ///
        /// A place among the words of its series.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub struct $name {
            series: Series,
            place: u8,
        }

        impl $name {
            /// The word at a place; the data hold it to those that exist.
            #[must_use]
            pub const fn at(series: Series, place: u8) -> Self {
                Self { series, place }
            }

            /// Every value of a series, in the order of the ordering tables.
            pub fn all(series: Series) -> impl DoubleEndedIterator<Item = Self> + ExactSizeIterator + Clone {
                // A field has at most 64 words, which the build holds.
                let places = 0..u8::try_from(series.words(Field::$name).len()).unwrap_or(u8::MAX);
                (places.start..places.end).map(move |place| Self { series, place })
            }

            /// The value of this word in a series.
            #[must_use]
            pub fn of(series: Series, word: &str) -> Option<Self> {
                Self::all(series).find(|value| value.as_str() == word)
            }

            /// The word in the code.
            #[must_use]
            pub fn as_str(self) -> &'static str {
                self.series.words(Field::$name).get(self.place()).copied().unwrap_or_default()
            }

            /// Its series.
            #[must_use]
            pub const fn series(self) -> Series {
                self.series
            }

            /// Its place among the words.
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
    /// The frame size as a number: 20 for 20A.
    #[must_use]
    pub fn number(self) -> u16 {
        leading_number(self.as_str())
    }
}

impl Ratio {
    /// The ratio as a number.
    #[must_use]
    pub fn value(self) -> u16 {
        leading_number(self.as_str())
    }
}

fn leading_number(word: &str) -> u16 {
    let digits = word.bytes().take_while(u8::is_ascii_digit);
    digits.fold(0, |number: u16, digit| number.saturating_mul(10).saturating_add(u16::from(digit - b'0')))
}

/// Holding brake.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Brake {
    /// No brake, nothing in the code.
    Without,
    /// Its word in the code.
    With,
}

impl Brake {
    /// Both values.
    pub const ALL: &'static [Self] = &[Self::Without, Self::With];
}

/// The fields that a code may have; each series has its own order of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Field {
    /// Series.
    Series,
    /// Frame size and version.
    Size,
    /// Reduction ratio.
    Ratio,
    /// Motor winding and connectors.
    Winding,
    /// Motor feedback.
    Feedback,
    /// Brake.
    Brake,
    /// Sensor option.
    Option1,
    /// Cable and connector option.
    Option2,
    /// Special design.
    Special,
}

impl Field {
    /// Every field.
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

    /// The identifier used in data exchange.
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

/// An ordering code that keeps the grammar; whether it can be ordered is another question.
///
/// Displayed in the canonical spelling, `CHA-20A-100-H-C1024-B-EC-K-SP`; an absent field leaves nothing. Sorted by series
/// and by the fields in their order, each as in the ordering tables. Its values are of one series.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct OrderCode {
    /// Frame size and version.
    pub size: Size,
    /// Reduction ratio.
    pub ratio: Ratio,
    /// Motor winding and connectors.
    pub winding: Winding,
    /// Motor feedback.
    pub feedback: Feedback,
    /// Brake.
    pub brake: Brake,
    /// Sensor option.
    pub option_1: Option<Option1>,
    /// Cable and connector option.
    pub option_2: Option<Option2>,
    /// Special design to the customer's wish.
    pub special: bool,
}

impl OrderCode {
    /// Its series.
    #[must_use]
    pub const fn series(&self) -> Series {
        self.size.series()
    }

    /// Whether it has the encoder at the output.
    #[must_use]
    pub const fn has_output_encoder(&self) -> bool {
        self.option_1.is_some()
    }

    /// The word at a field; `None` where the field is left out.
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
