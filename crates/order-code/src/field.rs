//! The fields of a code and their tokens.

use std::fmt;

macro_rules! tokens {
    ($(#[$doc:meta])* $name:ident { $($(#[$vdoc:meta])* $variant:ident => $token:literal),* $(,)? }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum $name { $($(#[$vdoc])* $variant),* }

        impl $name {
            /// Every value, in the order of the ordering tables.
            pub const ALL: &'static [Self] = &[$(Self::$variant),*];
            pub(crate) const TOKENS: &'static [&'static str] = &[$($token),*];

            /// The token in the code.
            #[must_use]
            pub const fn as_str(self) -> &'static str {
                match self { $(Self::$variant => $token),* }
            }

            pub(crate) fn of(token: &str) -> Option<Self> {
                Self::ALL.iter().copied().find(|value| value.as_str() == token)
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(self.as_str())
            }
        }
    };
}

tokens! {
    /// Frame size with version letter.
    ///
    /// # Source
    /// cha-manual table 11.1
    Size {
        /// Size 14.
        S14A => "14A",
        /// Size 17.
        S17A => "17A",
        /// Size 20.
        S20A => "20A",
        /// Size 25.
        S25A => "25A",
        /// Size 32.
        S32A => "32A",
        /// Size 40.
        S40A => "40A",
        /// Size 50.
        S50A => "50A",
        /// Size 58.
        S58A => "58A",
    }
}

impl Size {
    /// The frame size as a number: 20 for 20A.
    #[must_use]
    pub const fn number(self) -> u16 {
        match self {
            Self::S14A => 14,
            Self::S17A => 17,
            Self::S20A => 20,
            Self::S25A => 25,
            Self::S32A => 32,
            Self::S40A => 40,
            Self::S50A => 50,
            Self::S58A => 58,
        }
    }
}

tokens! {
    /// Reduction ratio.
    ///
    /// # Source
    /// cha-manual table 11.1
    Ratio {
        /// 30 : 1
        R30 => "30",
        /// 50 : 1
        R50 => "50",
        /// 80 : 1
        R80 => "80",
        /// 100 : 1
        R100 => "100",
        /// 120 : 1
        R120 => "120",
        /// 160 : 1
        R160 => "160",
    }
}

impl Ratio {
    /// The ratio as a number.
    #[must_use]
    pub const fn value(self) -> u16 {
        match self {
            Self::R30 => 30,
            Self::R50 => 50,
            Self::R80 => 80,
            Self::R100 => 100,
            Self::R120 => 120,
            Self::R160 => 160,
        }
    }
}

tokens! {
    /// Motor winding and connector configuration.
    ///
    /// # Source
    /// cha-manual tables 11.2 and 11.3; L stands in table 12.1 only, without a meaning
    Winding {
        /// 48 V DC link, connectors on the housing.
        E => "E",
        /// 680 V DC link, M23 connectors.
        H => "H",
        /// Named in table 12.1 only.
        L => "L",
        /// 680 V DC link, M17 connectors.
        N => "N",
    }
}

tokens! {
    /// Motor feedback system.
    ///
    /// # Source
    /// cha-manual table 11.4
    Feedback {
        /// Incremental encoder.
        C1024 => "C1024",
        /// Multiturn absolute encoder, EnDat.
        M512P => "M512P",
        /// Resolver.
        RES => "RES",
        /// Incremental encoder.
        D2048 => "D2048",
        /// Multiturn absolute encoder, SSI.
        M128S => "M128S",
    }
}

tokens! {
    /// Option 1, sensor.
    ///
    /// # Source
    /// cha-manual table 11.5
    Option1 {
        /// Single-turn absolute EnDat encoder at the output.
        EC => "EC",
    }
}

tokens! {
    /// Option 2, cable and connector exit; without it the cable leaves radially.
    ///
    /// # Source
    /// cha-manual table 11.6
    Option2 {
        /// Axial cable exit.
        K => "K",
        /// Axial connector exit.
        R => "R",
        /// Radial connector exit.
        S => "S",
    }
}

/// Holding brake.
///
/// # Source
/// cha-manual table 11.1
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Brake {
    /// No brake, nothing in the code.
    Without,
    /// `B` in the code.
    With,
}

impl Brake {
    /// Both values.
    pub const ALL: &'static [Self] = &[Self::Without, Self::With];
}

/// The fields of a code, in their order.
///
/// # Source
/// cha-manual table 11.1
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Field {
    /// `CHA`
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
    /// Every field, in order.
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

    /// The tokens that may stand at this field.
    #[must_use]
    pub const fn tokens(self) -> &'static [&'static str] {
        match self {
            Self::Series => &["CHA"],
            Self::Size => Size::TOKENS,
            Self::Ratio => Ratio::TOKENS,
            Self::Winding => Winding::TOKENS,
            Self::Feedback => Feedback::TOKENS,
            Self::Brake => &["B"],
            Self::Option1 => Option1::TOKENS,
            Self::Option2 => Option2::TOKENS,
            Self::Special => &["SP"],
        }
    }

    /// Whether the field may be left out.
    #[must_use]
    pub const fn is_optional(self) -> bool {
        matches!(self, Self::Brake | Self::Option1 | Self::Option2 | Self::Special)
    }

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
/// Displayed in the canonical spelling, `CHA-20A-100-H-C1024-B-EC-K-SP`; an absent field leaves nothing. Sorted by the
/// fields in their order, each as in the ordering tables.
///
/// # Source
/// cha-manual table 11.1
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
    /// Special design to the customer's wish, `SP`.
    pub special: bool,
}

impl OrderCode {
    /// The token at a field; `None` where the field is left out.
    #[must_use]
    pub fn token(&self, field: Field) -> Option<&'static str> {
        match field {
            Field::Series => Some("CHA"),
            Field::Size => Some(self.size.as_str()),
            Field::Ratio => Some(self.ratio.as_str()),
            Field::Winding => Some(self.winding.as_str()),
            Field::Feedback => Some(self.feedback.as_str()),
            Field::Brake => (self.brake == Brake::With).then_some("B"),
            Field::Option1 => self.option_1.map(Option1::as_str),
            Field::Option2 => self.option_2.map(Option2::as_str),
            Field::Special => self.special.then_some("SP"),
        }
    }
}

impl fmt::Display for OrderCode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let tokens: Vec<&str> = Field::ALL.iter().filter_map(|field| self.token(*field)).collect();
        f.pad(&tokens.join("-"))
    }
}
