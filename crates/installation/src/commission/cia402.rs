//! CiA 402 objects that follow from a code, as whole numbers with their rounding error.

use super::counting::counting_fact;
use super::recorded::REVERSED;
use super::{Commissioning, ParameterId, ParameterToSet, clean};
use catalogue::Fact;
use quantities::identified;
use quantities::unit::{MILLIAMPERE, MILLINEWTON_METRE, ONE, REVOLUTION_PER_MINUTE};

identified! {
    /// Data type of CiA 301.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum DataType {
        /// Signed, 8 bit.
        Integer8 = "INTEGER8",
        /// Signed, 16 bit.
        Integer16 = "INTEGER16",
        /// Signed, 32 bit.
        Integer32 = "INTEGER32",
        /// Unsigned, 8 bit.
        Unsigned8 = "UNSIGNED8",
        /// Unsigned, 16 bit.
        Unsigned16 = "UNSIGNED16",
        /// Unsigned, 32 bit.
        Unsigned32 = "UNSIGNED32",
        /// Text without fixed length.
        VisibleString = "VISIBLE_STRING",
    }
}

impl DataType {
    /// Returns the number of the type in CiA 301, as used in an EDS.
    #[must_use]
    pub const fn number(self) -> u16 {
        match self {
            Self::Integer8 => 2,
            Self::Integer16 => 3,
            Self::Integer32 => 4,
            Self::Unsigned8 => 5,
            Self::Unsigned16 => 6,
            Self::Unsigned32 => 7,
            Self::VisibleString => 9,
        }
    }

    /// Returns the size of a number in bytes; zero for a text.
    #[must_use]
    pub const fn bytes(self) -> u8 {
        match self {
            Self::Integer8 | Self::Unsigned8 => 1,
            Self::Integer16 | Self::Unsigned16 => 2,
            Self::Integer32 | Self::Unsigned32 => 4,
            Self::VisibleString => 0,
        }
    }

    /// Returns the smallest and the largest value; zero for a text.
    #[must_use]
    pub const fn range(self) -> [i64; 2] {
        match self {
            Self::Integer8 => [i8::MIN as i64, i8::MAX as i64],
            Self::Integer16 => [i16::MIN as i64, i16::MAX as i64],
            Self::Integer32 => [i32::MIN as i64, i32::MAX as i64],
            Self::Unsigned8 => [0, u8::MAX as i64],
            Self::Unsigned16 => [0, u16::MAX as i64],
            Self::Unsigned32 => [0, u32::MAX as i64],
            Self::VisibleString => [0, 0],
        }
    }
}

/// Meaning of an object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ObjectId {
    /// Max torque, 0x6072.
    MaxTorque,
    /// Max current, 0x6073.
    MaxCurrent,
    /// Motor rated current, 0x6075.
    MotorRatedCurrent,
    /// Motor rated torque, 0x6076.
    MotorRatedTorque,
    /// Polarity, 0x607E.
    Polarity,
    /// Max motor speed, 0x6080.
    MaxMotorSpeed,
    /// Encoder increments, 0x608F sub 1.
    EncoderIncrements,
    /// Motor revolutions of the encoder increments, 0x608F sub 2.
    EncoderRevolutions,
    /// Motor revolutions of the gear ratio, 0x6091 sub 1.
    GearMotorRevolutions,
    /// Shaft revolutions of the gear ratio, 0x6091 sub 2.
    GearShaftRevolutions,
}

identified! {
    /// Rounding of an exact value to a whole number.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Rounding {
        /// Nearest number, for reference values: error at most half a unit.
        Nearest = "nearest",
        /// Downwards, for limits: error less than one unit.
        Down = "down",
    }
}

/// An object with its value.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    /// Meaning of the object.
    pub id: ObjectId,
    /// Index of the object.
    pub index: u16,
    /// Sub-index of the object.
    pub sub: u8,
    /// Data type of the value.
    pub data_type: DataType,
    /// Value to write.
    pub value: u32,
    /// Value before rounding.
    pub exact: f64,
    /// Unit of both values.
    pub unit: &'static str,
    /// Rounding of the value.
    pub rounding: Rounding,
    /// Parameters from which the value follows.
    pub from: Vec<ParameterToSet>,
    /// Facts from which the value follows.
    pub facts: Vec<&'static Fact>,
    /// Document that defines the object, its type and its unit.
    pub document: &'static str,
}

impl Object {
    /// Returns the errata that concern the value, each once.
    #[must_use]
    pub fn errata(&self) -> Vec<&'static str> {
        let mut found = Vec::new();
        for id in self.from.iter().flat_map(|parameter| &parameter.errata) {
            if !found.contains(id) {
                found.push(*id);
            }
        }
        found
    }
}

/// Bits 7 (position) and 6 (velocity) of 0x607E, which multiply the demand value by −1 (synapticon-circulo).
const BOTH_REVERSED: u8 = 0b1100_0000;

/// Per mille of the rated value.
const PER_MILLE: f64 = 1000.0;

/// Returns the objects with known values, by index and sub-index.
///
/// The rated values are the stall values of the motor, I_0 and k_TM I_0: a drive assumes that torque is proportional to
/// current, so that 0x6072 and 0x6073 are both 1000 I_lim/I_0. A value outside the range of its type is omitted.
///
/// The ratio is negative (cha-manual section 11.1), but 0x6091 has no sign: 0x607E sets it, so that positive values
/// turn the flange clockwise as seen from the front. It is included if the manual states the direction of increasing
/// position.
#[must_use]
pub fn objects(commissioning: &Commissioning) -> Vec<Object> {
    use DataType::{Unsigned16, Unsigned32};
    use Rounding::{Down, Nearest};
    let get = |id| commissioning.get(id).cloned();
    let draft = |id, (index, sub), exact, unit, from, document| Object {
        id,
        index,
        sub,
        data_type: Unsigned32,
        value: 0,
        exact,
        unit,
        rounding: Nearest,
        from,
        facts: Vec::new(),
        document,
    };
    let mut drafts: Vec<Object> = Vec::new();
    if let (Some(limit), Some(stall)) = (get(ParameterId::CurrentLimit), get(ParameterId::StallCurrent)) {
        let exact = clean(PER_MILLE * (limit.si / stall.si));
        let share = |id, index, document| Object {
            data_type: Unsigned16,
            rounding: Down,
            ..draft(id, (index, 0), exact, "0.1 %", vec![limit.clone(), stall.clone()], document)
        };
        drafts.push(share(ObjectId::MaxTorque, 0x6072, "beckhoff-ax8xxx"));
        drafts.push(share(ObjectId::MaxCurrent, 0x6073, "festo-cmmp"));
    }
    let mut one = |id, place, parameter: Option<ParameterToSet>, unit: &quantities::Unit, shown, document| {
        if let Some(parameter) = parameter {
            let exact = clean(unit.from_si(parameter.si));
            drafts.push(draft(id, place, exact, shown, vec![parameter], document));
        }
    };
    let stall = get(ParameterId::StallCurrent);
    one(ObjectId::MotorRatedCurrent, (0x6075, 0), stall, &MILLIAMPERE, "mA", "elmo-dsp402");
    let torque = get(ParameterId::StallTorqueMotor);
    one(ObjectId::MotorRatedTorque, (0x6076, 0), torque, &MILLINEWTON_METRE, "mNm", "elmo-dsp402");
    let speed = get(ParameterId::SpeedMotorMax);
    let polarity = counting_fact(&commissioning.code).map(|counting| Object {
        data_type: DataType::Unsigned8,
        facts: catalogue::fact(REVERSED).into_iter().chain([counting]).collect(),
        ..draft(ObjectId::Polarity, (0x607E, 0), f64::from(BOTH_REVERSED), "1", Vec::new(), "synapticon-circulo")
    });
    one(ObjectId::MaxMotorSpeed, (0x6080, 0), speed, &REVOLUTION_PER_MINUTE, "1/min", "infranor-xtrapuls");
    let (increments, ratio) = (get(ParameterId::EncoderIncrements), get(ParameterId::ReductionRatio));
    let document = "beckhoff-ax8xxx";
    one(ObjectId::EncoderIncrements, (0x608F, 1), increments.clone(), &ONE, "inc", document);
    // Per single turn.
    let single = |parameter: Option<ParameterToSet>| parameter.map(|parameter| ParameterToSet { si: 1.0, ..parameter });
    one(ObjectId::EncoderRevolutions, (0x608F, 2), single(increments), &ONE, "rev", document);
    one(ObjectId::GearMotorRevolutions, (0x6091, 1), ratio.clone(), &ONE, "rev", document);
    one(ObjectId::GearShaftRevolutions, (0x6091, 2), single(ratio), &ONE, "rev", document);
    drafts.extend(polarity);
    drafts.sort_by_key(|draft| (draft.index, draft.sub));
    drafts.into_iter().filter_map(whole).collect()
}

fn whole(draft: Object) -> Option<Object> {
    let rounded = match draft.rounding {
        Rounding::Nearest => draft.exact.round(),
        Rounding::Down => draft.exact.floor(),
    };
    let [_, largest] = draft.data_type.range();
    #[allow(clippy::cast_precision_loss, reason = "at most 32 bit")]
    if rounded < 0.0 || rounded > largest as f64 {
        return None;
    }
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "whole and within the type")]
    let value = rounded as u32;
    Some(Object { value, ..draft })
}
