//! `units`: valid units, with every spelling and their value in SI.

use super::argument::nearest_words;
use super::given::{Hinted, arguments, some};
use super::{Answer, Argument, ArgumentForm, Entry, Gives, Inquiry, Reads, Record, Unanswered};
use answers::Number;
use quantities::{Dimension, Language, Unit};
use schemars::JsonSchema;
use serde::Serialize;
use words::help::values;
use words::{help, hint_text, terminal};

arguments! {
    /// Arguments of `units`: a selection.
    pub struct Args {
        /// A quantity or a spelling of a unit; all of them without it.
        quantity: Option<Vec<Dimension>> =
            Argument::option("quantity", values::quantity, help::units_quantity).form(ArgumentForm::Words) => some(dimensions),
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "units",
    path: "units",
    about: help::units,
    reads: Reads::Nothing,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<Units>("units")),
    writes: &[],
    example: "torque",
    answer: Some(|inquiry| Ok(Answer::record(&found(inquiry)?))),
};

/// Units by the quantity that they measure.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Units {
    /// The quantities.
    pub quantities: Vec<Measured>,
}

/// A quantity with its units.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Measured {
    /// Name in the language of the call.
    pub quantity: String,
    /// The unit in which `si` and `zero` are stated, in the spelling of project files.
    pub si_unit: String,
    /// Units, the usual one first.
    pub units: Vec<UnitRead>,
}

/// A unit and how it is read.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct UnitRead {
    /// Spelling in project files.
    pub unit: String,
    /// Symbol in reports and on the terminal.
    pub symbol: String,
    /// Spelling in JSON and tables.
    pub json: String,
    /// Further spellings that are read.
    pub also: Vec<String>,
    /// One of it, as a difference, in SI.
    pub si: Number,
    /// Zero of it in SI: nonzero for degrees Celsius alone.
    pub zero: Number,
}

/// Returns the units of a quantity, of every quantity that is measured in a unit, or all of them.
///
/// # Errors
/// If the text is neither a quantity nor a unit.
pub fn found(inquiry: &Inquiry<'_>) -> Result<Units, Unanswered> {
    let dimensions = Args::read(&inquiry.given)?.quantity.unwrap_or_else(|| Dimension::ALL.to_vec());
    Ok(of(&dimensions, inquiry.language))
}

/// Returns the quantities with a name in either language, or with a spelling of a unit.
fn dimensions(written: &str, language: Language) -> Result<Vec<Dimension>, Hinted> {
    let names = |dimension: &Dimension| Language::ALL.map(|language| dimension.name(language));
    let all = |keeps: &dyn Fn(&Dimension) -> bool| -> Vec<Dimension> {
        Dimension::ALL.iter().filter(|dimension| keeps(dimension)).copied().collect()
    };
    let wanted = written.to_lowercase();
    let named = all(&|dimension| names(dimension).iter().any(|name| name.to_lowercase() == wanted));
    let found = if named.is_empty() { all(&|one| Unit::of_dimension(*one, written).is_some()) } else { named };
    if found.is_empty() {
        let known: Vec<&str> = Dimension::ALL.iter().map(|dimension| dimension.name(language)).collect();
        return Err((
            terminal::no_such_unit(&written, language),
            Some(hint_text(&nearest_words(written, &known), language)),
        ));
    }
    Ok(found)
}

fn of(dimensions: &[Dimension], language: Language) -> Units {
    let measured = |dimension: &Dimension| {
        let units = dimension.units();
        let si = units.iter().find(|unit| is_si(unit));
        Measured {
            quantity: dimension.name(language).to_owned(),
            si_unit: si.map_or_else(String::new, |unit| unit.ascii.to_owned()),
            units: units.iter().map(|unit| read(unit, si.unwrap_or(unit))).collect(),
        }
    };
    Units { quantities: dimensions.iter().map(measured).collect() }
}

/// Returns `true` if values in the unit are values in SI.
fn is_si(unit: &Unit) -> bool {
    [0.0, 1.0].iter().all(|value| (unit.to_si(*value) - value).abs() < f64::EPSILON)
}

fn read(unit: &Unit, si: &Unit) -> UnitRead {
    let own = [unit.ascii, unit.symbol, unit.json];
    let also = unit.spellings().filter(|spelling| !own.contains(spelling)).map(str::to_owned).collect();
    let zero = unit.to_si(0.0);
    UnitRead {
        unit: unit.ascii.to_owned(),
        symbol: unit.symbol.to_owned(),
        json: unit.json.to_owned(),
        also,
        si: Number::in_unit(unit.to_si(1.0) - zero, si),
        zero: Number::in_unit(zero, si),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 1 °C is 274.15 K as a temperature and 1 K as a difference; every quantity has its SI unit.
    #[test]
    fn every_unit_has_its_value_in_si() {
        let all = of(Dimension::ALL, Language::En);
        assert!(all.quantities.iter().all(|each| !each.si_unit.is_empty()), "{all:?}");
        let temperature = of(&[Dimension::Temperature], Language::De).quantities.remove(0);
        let celsius = &temperature.units[0];
        assert_eq!((celsius.si.written(), celsius.zero.written()), (Some(1.0), Some(273.15)));
        let times = of(&[Dimension::Time], Language::En).quantities.remove(0);
        let hour = times.units.iter().find(|unit| unit.unit == "h").unwrap();
        assert_eq!((hour.si.written(), times.si_unit.as_str()), (Some(3600.0), "s"));
    }

    /// A quantity is found by its name in either language and by a unit; another text is refused with the nearest name.
    #[test]
    fn a_quantity_is_found_by_name_and_by_unit() {
        let of = |written| dimensions(written, Language::En).unwrap();
        assert_eq!(of("Drehmoment"), [Dimension::Torque]);
        assert_eq!(of("rpm"), [Dimension::AngularVelocity]);
        assert_eq!(of("g"), [Dimension::Mass, Dimension::Acceleration]);
        let (message, hint) = dimensions("torqe", Language::En).unwrap_err();
        assert!(message.contains("torqe") && hint.unwrap().contains("torque"));
    }
}
