//! Types of the values of keys.

use crate::Range;
use crate::bodies::BodySection;
use crate::key::{ColumnDimensions, Kind};
use crate::read::{FoundValue, Reader};
use crate::section::{Fields, OfKinds, Section, set, states};
use quantities::unit::ONE;
use quantities::{
    Acceleration, Angle, AngularAcceleration, AngularJerk, AngularVelocity, CurrentGain, Dimension, EffectiveVoltage,
    ElectricCurrent, ElectricPotential, ElectricalResistance, Energy, Force, Frequency, Inductance, Jerk, Lead, Length,
    Mass, MassDensity, Measure, MomentOfInertia, NoLoadCurrentConstant, PositionGain, Power, SpeedGain,
    ThermodynamicTemperature, TiltingStiffness, Time, Torque, TorqueConstant, TorsionalStiffness, Unit, Velocity,
    ViscousFriction, VoltageConstant,
};
use std::marker::PhantomData;
use std::ops::Range as Span;
use toml::de::DeValue;

/// A number in its unit.
type Amount = Option<(f64, &'static Unit)>;

/// Value of a key.
pub trait KeyValue: Sized {
    /// Kind of the value, unless its key is more specific.
    const KIND: Kind;

    /// Reads the value; faults are reported to the reader.
    fn read(found: &FoundValue<'_, '_>, reader: &mut Reader<'_>) -> Option<Self>;

    /// Returns the quantity with this value in SI; `None` for other types.
    fn of_si(_si: f64) -> Option<Self> {
        None
    }

    /// Returns the value of a quantity in SI; `None` for other types.
    fn as_si(&self) -> Option<f64> {
        None
    }

    /// Replaces the value like [`StatedField::set`](crate::stated::StatedField::set).
    fn set(&mut self, _index: &[usize], _rest: &str, si: f64) -> Option<()> {
        *self = Self::of_si(si)?;
        Some(())
    }

    /// Returns `true` if the key to which `index` and `rest` lead within it is stated.
    fn states(&self, _index: &[usize], _rest: &str) -> bool {
        true
    }

    /// Returns `true` if it is stated along the line of a mechanism.
    fn is_of_a_line(&self) -> bool {
        false
    }

    /// Returns the number that is recorded with the text of an input, if it is one. `None` if the value records itself,
    /// or its parts.
    fn noted(&self) -> Option<Amount> {
        None
    }
}

/// A default of a key as written in a file.
pub trait Written {
    /// Returns it as written in a file.
    fn written(&self) -> String;
}

impl Written for f64 {
    fn written(&self) -> String {
        self.to_string()
    }
}

impl Written for u32 {
    fn written(&self) -> String {
        self.to_string()
    }
}

impl Written for bool {
    fn written(&self) -> String {
        self.to_string()
    }
}

macro_rules! quantities {
    ($($Quantity:ty)*) => {$(
        impl KeyValue for $Quantity {
            const KIND: Kind = Kind::Quantity(<Self as Measure>::DIMENSION, Range::Any);

            fn read(found: &FoundValue<'_, '_>, reader: &mut Reader<'_>) -> Option<Self> {
                reader.quantity_of(found).map(|(_, si)| Self::from_si(si))
            }

            fn of_si(si: f64) -> Option<Self> {
                Some(Self::from_si(si))
            }

            fn as_si(&self) -> Option<f64> {
                Some(self.si())
            }
        }
    )*};
}

quantities! {
    Acceleration Angle AngularVelocity CurrentGain EffectiveVoltage ElectricCurrent ElectricPotential ElectricalResistance Energy Force Frequency Inductance Lead Length Mass
    MassDensity MomentOfInertia NoLoadCurrentConstant PositionGain Power SpeedGain ThermodynamicTemperature Time Torque TorqueConstant
    TiltingStiffness TorsionalStiffness ViscousFriction VoltageConstant
}

/// A rotational quantity that may be stated along the line of a mechanism.
pub trait Turning: Measure {
    /// Linear quantity.
    type Line: Measure;
}

impl Turning for Angle {
    type Line = Length;
}

impl Turning for AngularVelocity {
    type Line = Velocity;
}

impl Turning for AngularAcceleration {
    type Line = Acceleration;
}

impl Turning for AngularJerk {
    type Line = Jerk;
}

/// A rotational quantity, or a linear one of a linear mechanism.
#[derive(Clone, Copy, Debug)]
pub struct Along<Q> {
    /// The value is linear.
    pub is_of_a_line: bool,
    /// Value in SI.
    pub si: f64,
    turning: PhantomData<Q>,
}

impl<Q: Turning> KeyValue for Along<Q> {
    const KIND: Kind = Kind::Along(Q::DIMENSION, <Q::Line as Measure>::DIMENSION, Range::Any);

    fn read(found: &FoundValue<'_, '_>, reader: &mut Reader<'_>) -> Option<Self> {
        let (dimension, si) = reader.quantity_of(found)?;
        Some(Self { is_of_a_line: dimension == <Q::Line as Measure>::DIMENSION, si, turning: PhantomData })
    }

    fn set(&mut self, _: &[usize], _: &str, si: f64) -> Option<()> {
        self.si = si;
        Some(())
    }

    fn is_of_a_line(&self) -> bool {
        self.is_of_a_line
    }
}

impl KeyValue for f64 {
    const KIND: Kind = Kind::Number(Self::MIN, Self::MAX);

    fn read(found: &FoundValue<'_, '_>, reader: &mut Reader<'_>) -> Option<Self> {
        reader.number(found)
    }

    fn of_si(si: f64) -> Option<Self> {
        Some(si)
    }

    fn as_si(&self) -> Option<f64> {
        Some(*self)
    }

    fn noted(&self) -> Option<Amount> {
        Some(Some((*self, &ONE)))
    }
}

impl KeyValue for u32 {
    const KIND: Kind = Kind::Integer(0, Self::MAX as i64);

    fn read(found: &FoundValue<'_, '_>, reader: &mut Reader<'_>) -> Option<Self> {
        reader.integer(found)
    }

    fn noted(&self) -> Option<Amount> {
        Some(Some((f64::from(*self), &ONE)))
    }
}

impl KeyValue for bool {
    const KIND: Kind = Kind::Bool;

    fn read(found: &FoundValue<'_, '_>, reader: &mut Reader<'_>) -> Option<Self> {
        match found.value {
            DeValue::Boolean(value) => Some(*value),
            _ => reader.wrong_type(found),
        }
    }

    fn noted(&self) -> Option<Amount> {
        Some(None)
    }
}

impl KeyValue for String {
    const KIND: Kind = Kind::Text;

    fn read(found: &FoundValue<'_, '_>, reader: &mut Reader<'_>) -> Option<Self> {
        reader.free_text(found)
    }

    fn noted(&self) -> Option<Amount> {
        Some(None)
    }
}

/// Plain numbers.
#[derive(Clone, Debug)]
pub struct Numbers(pub Vec<f64>);

impl KeyValue for Numbers {
    const KIND: Kind = Kind::Numbers(f64::MIN, f64::MAX, usize::MAX);

    fn read(found: &FoundValue<'_, '_>, reader: &mut Reader<'_>) -> Option<Self> {
        reader.numbers(found).map(Self)
    }

    fn noted(&self) -> Option<Amount> {
        Some(None)
    }
}

/// Free texts, each with its place.
#[derive(Clone, Debug)]
pub struct Texts(pub Vec<(String, Span<usize>)>);

impl KeyValue for Texts {
    const KIND: Kind = Kind::Texts;

    fn read(found: &FoundValue<'_, '_>, reader: &mut Reader<'_>) -> Option<Self> {
        reader.texts(found).map(Self)
    }

    fn noted(&self) -> Option<Amount> {
        Some(None)
    }
}

/// One of a fixed set of words.
pub trait WordChoice: Sized {
    /// Words of a file.
    const WORDS: &'static [&'static str];

    /// Returns the meaning of a word.
    fn of_word(word: &str) -> Option<Self>;
}

/// Maps the words of a choice to their values. A missing variant is a compile error.
macro_rules! choices {
    ($($Choice:ty { $($Variant:ident = $word:literal),+ $(,)? })+) => {$(
        impl $crate::value::WordChoice for $Choice {
            const WORDS: &'static [&'static str] = &[$($word),+];

            fn of_word(word: &str) -> Option<Self> {
                match word {
                    $($word => Some(Self::$Variant),)+
                    _ => None,
                }
            }
        }

        impl $crate::value::Written for $Choice {
            fn written(&self) -> String {
                match self { $(Self::$Variant => $word.to_owned(),)+ }
            }
        }

        $crate::value::choice! { $Choice }
    )+};
}

/// Implements choices whose words are the identifiers of their values.
macro_rules! choices_by_id {
    ($($Choice:ty),+) => {$(
        impl $crate::value::WordChoice for $Choice {
            const WORDS: &'static [&'static str] = Self::IDS;

            fn of_word(word: &str) -> Option<Self> {
                Self::ALL.into_iter().find(|choice| choice.id() == word)
            }
        }

        impl $crate::value::Written for $Choice {
            fn written(&self) -> String {
                self.id().to_owned()
            }
        }

        $crate::value::choice! { $Choice }
    )+};
}

/// Implements [`Value`] for a [`Choice`].
macro_rules! choice {
    ($Choice:ty) => {
        impl $crate::value::KeyValue for $Choice {
            const KIND: $crate::key::Kind = $crate::key::Kind::OneOf(<Self as $crate::value::WordChoice>::WORDS);

            fn read(found: &$crate::read::FoundValue<'_, '_>, reader: &mut $crate::read::Reader<'_>) -> Option<Self> {
                reader.choice(found)
            }

            fn noted(&self) -> Option<Option<(f64, &'static quantities::Unit)>> {
                Some(None)
            }
        }
    };
}

pub(crate) use {choice, choices, choices_by_id};

/// Several words of a choice.
#[derive(Clone, Debug)]
pub struct Choices<W>(pub Vec<W>);

impl<W: WordChoice> KeyValue for Choices<W> {
    const KIND: Kind = Kind::ListOf(W::WORDS);

    fn read(found: &FoundValue<'_, '_>, reader: &mut Reader<'_>) -> Option<Self> {
        reader.choices(found).map(Self)
    }

    fn noted(&self) -> Option<Amount> {
        Some(None)
    }
}

/// A row of quantities.
pub trait QuantityRow: Copy {
    /// Permissible dimensions of its columns.
    const COLUMNS: &'static [ColumnDimensions];

    /// Creates the row from the cells of its columns.
    fn of(cells: &[ValueCell]) -> Option<Self>;

    /// Returns the cells of its columns.
    fn cells(&self) -> Vec<ValueCell>;

    /// Returns `true` if it states a linear quantity.
    fn is_of_a_line(&self) -> bool {
        false
    }
}

/// Dimension of a cell of a row, and its value in SI.
pub(crate) type ValueCell = (Dimension, f64);

/// Declares rows of quantities: the number of their columns, and the dimensions of each.
macro_rules! rows {
    ($($(#[$doc:meta])* $Row:ident of $count:literal: $columns:expr;)+) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub struct $Row([$crate::value::ValueCell; $count]);

        impl $Row {
            /// Returns the values of its columns in SI.
            #[must_use]
            pub fn si(&self) -> [f64; $count] {
                self.0.map(|(_, si)| si)
            }
        }

        impl $crate::value::QuantityRow for $Row {
            const COLUMNS: &'static [$crate::key::ColumnDimensions] = $columns;

            fn of(cells: &[$crate::value::ValueCell]) -> Option<Self> {
                cells.try_into().ok().map(Self)
            }

            fn cells(&self) -> Vec<$crate::value::ValueCell> {
                self.0.to_vec()
            }
        }
    )+};
}

rows! {
    /// A point of a table over the position: position, inertia and torque.
    TableRow of 3: &[&[Dimension::Angle], &[Dimension::MomentOfInertia], &[Dimension::Torque]];
    /// A corner point of a limit curve: speed and torque.
    CurveRow of 2: &[&[Dimension::AngularVelocity], &[Dimension::Torque]];
}

/// Rows of quantities, each with its place.
#[derive(Clone, Debug)]
pub struct Rows<P> {
    /// Rows without a fault.
    pub rows: Vec<(P, Span<usize>)>,
    /// No row is faulty; otherwise number and ends of the rows are not those of the file.
    pub is_whole: bool,
}

impl<P: Copy> Rows<P> {
    /// Returns the rows without their places.
    #[must_use]
    pub fn values(&self) -> Vec<P> {
        self.rows.iter().map(|(row, _)| *row).collect()
    }
}

impl<P: QuantityRow> KeyValue for Rows<P> {
    const KIND: Kind = Kind::Rows(P::COLUMNS);

    fn read(found: &FoundValue<'_, '_>, reader: &mut Reader<'_>) -> Option<Self> {
        reader.rows(found)
    }

    fn set(&mut self, index: &[usize], _: &str, si: f64) -> Option<()> {
        let [row, column] = *<&[usize; 2]>::try_from(index).ok()?;
        let (row, _) = self.rows.get_mut(row)?;
        let mut cells = row.cells();
        cells.get_mut(column)?.1 = si;
        *row = P::of(&cells)?;
        Some(())
    }

    fn is_of_a_line(&self) -> bool {
        self.rows.iter().any(|(row, _)| row.is_of_a_line())
    }
}

/// Solid bodies, one text each.
#[derive(Clone, Debug)]
pub struct BodyLines {
    /// Bodies of the texts that state a shape.
    pub bodies: Vec<BodySection>,
    /// No text has a fault; otherwise a body may lack a value.
    pub is_whole: bool,
}

impl KeyValue for BodyLines {
    const KIND: Kind = Kind::Bodies;

    fn read(found: &FoundValue<'_, '_>, reader: &mut Reader<'_>) -> Option<Self> {
        reader.bodies(found)
    }

    fn set(&mut self, index: &[usize], rest: &str, si: f64) -> Option<()> {
        set_in(&mut self.bodies, index, rest, si)
    }

    fn states(&self, index: &[usize], rest: &str) -> bool {
        states_in(&self.bodies, index, rest)
    }
}

/// An array of tables, each of one of several kinds.
#[derive(Clone, Debug)]
pub struct Tables<S>(pub Vec<S>);

impl<S: OfKinds> KeyValue for Tables<S> {
    const KIND: Kind = Kind::Variants(S::VARIANTS);

    fn read(found: &FoundValue<'_, '_>, reader: &mut Reader<'_>) -> Option<Self> {
        reader.tables(found, Some(S::VARIANTS)).map(Self)
    }

    fn set(&mut self, index: &[usize], rest: &str, si: f64) -> Option<()> {
        set_in(&mut self.0, index, rest, si)
    }

    fn states(&self, index: &[usize], rest: &str) -> bool {
        states_in(&self.0, index, rest)
    }
}

/// A table, or an array of tables with additional keys.
#[derive(Clone, Debug)]
pub enum OneOrMany<A, B> {
    /// A table.
    One(A),
    /// An array of tables.
    Many(Vec<B>),
}

impl<A: Section, B: Section> KeyValue for OneOrMany<A, B> {
    const KIND: Kind = Kind::OneOrMany(A::KEYS, B::KEYS);

    fn read(found: &FoundValue<'_, '_>, reader: &mut Reader<'_>) -> Option<Self> {
        match found.value {
            DeValue::Array(_) => reader.tables(found, None).map(Self::Many),
            _ => reader.table(found).map(Self::One),
        }
    }

    fn set(&mut self, index: &[usize], rest: &str, si: f64) -> Option<()> {
        match self {
            Self::One(section) => set(section, rest, si),
            Self::Many(sections) => set_in(sections, index, rest, si),
        }
    }

    fn states(&self, index: &[usize], rest: &str) -> bool {
        match self {
            Self::One(section) => states(section, rest),
            Self::Many(sections) => states_in(sections, index, rest),
        }
    }
}

fn states_in<S: Fields>(sections: &[S], index: &[usize], rest: &str) -> bool {
    let section = index.first().and_then(|place| sections.get(*place));
    section.is_none_or(|section| states(section, rest))
}

fn set_in<S: Fields>(sections: &mut [S], index: &[usize], rest: &str, si: f64) -> Option<()> {
    let [place] = *<&[usize; 1]>::try_from(index).ok()?;
    set(sections.get_mut(place)?, rest, si)
}
