//! Derivation of a number: input values, formulas, results.
//!
//! A computation with [`Workings`] records each value where it uses it. Switched off they cost a branch; switched on
//! they hold the derivation of exactly the numbers computed. A [`Formula`] is written once: it is displayed, displayed
//! with the values inserted, and can be evaluated to verify its result.

mod finding;
mod formula;

pub use finding::Finding;
pub use formula::{Formula, FormulaFault};

use provenance::{Datum, Grade, Source, Sourced};
use quantities::{Measure, Unit};
use std::borrow::Cow;

/// Origin of a value within the derivation.
#[derive(Clone, Debug, PartialEq)]
pub enum How {
    /// An input value.
    Given,
    /// Result of a formula whose symbols are those of earlier steps, in their units.
    Formula {
        /// Text of the formula, see [`Formula`].
        text: Cow<'static, str>,
        /// Indices of the steps of its symbols, without duplicates, in the order of the text.
        operands: Vec<usize>,
    },
    /// Result of a search or an integral over the cycle, a table or a curve.
    Found {
        /// Kind of search, integral, table or curve.
        what: Finding,
        /// Indices of the steps of its symbols.
        operands: Vec<usize>,
    },
}

impl How {
    fn operands(&self) -> &[usize] {
        match self {
            Self::Given => &[],
            Self::Formula { operands, .. } | Self::Found { operands, .. } => operands,
        }
    }
}

/// Role of a value in its check.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Part {
    /// An intermediate value.
    #[default]
    Step,
    /// The value demanded by the axis.
    Value,
    /// The limit of the actuator.
    Limit,
}

/// One value of a derivation.
#[derive(Clone, Debug)]
pub struct Step {
    /// Symbol in ASCII, as in the source: `T_max`, `n_2`.
    pub symbol: &'static str,
    /// Value in SI.
    pub si: f64,
    /// Unit in which it is displayed and inserted into formulas.
    pub unit: &'static Unit,
    /// Origin within the derivation.
    pub how: How,
    /// Role in the check.
    pub part: Part,
    /// Source of the value or of its formula.
    pub source: Source,
    /// Grade; for a formula the worst grade of its inputs.
    pub grade: Grade,
    /// Errata that concern the value.
    pub errata: &'static [&'static str],
}

impl Step {
    /// Returns the value in its unit.
    #[must_use]
    pub fn value(&self) -> f64 {
        self.unit.from_si(self.si)
    }

    /// Returns the indices of the steps that the value is computed from.
    #[must_use]
    pub fn operands(&self) -> &[usize] {
        self.how.operands()
    }
}

/// The steps of a computation; empty if switched off.
#[derive(Clone, Debug, Default)]
pub struct Workings {
    steps: Option<Vec<Step>>,
}

impl Workings {
    /// Creates workings that record nothing.
    #[must_use]
    pub const fn off() -> Self {
        Self { steps: None }
    }

    /// Creates workings that record every step.
    #[must_use]
    pub const fn on() -> Self {
        Self { steps: Some(Vec::new()) }
    }

    /// Returns `true` if steps are recorded, for computations needed by the derivation only.
    #[must_use]
    pub const fn is_on(&self) -> bool {
        self.steps.is_some()
    }

    /// Returns the steps in the order in which they were recorded.
    #[must_use]
    pub fn into_steps(self) -> Vec<Step> {
        self.steps.unwrap_or_default()
    }

    /// Records an input quantity.
    #[inline]
    pub fn given<Q: Measure>(&mut self, symbol: &'static str, unit: &'static Unit, datum: &Sourced<Q>) {
        if self.is_on() {
            self.record(symbol, unit, datum.value.si(), &datum.source, datum.grade, datum.errata);
        }
    }

    /// Records an input number without a unit, such as a ratio; its unit is that of a ratio.
    #[inline]
    pub fn given_number(&mut self, symbol: &'static str, datum: &Sourced<f64>) {
        if self.is_on() {
            self.record(symbol, &quantities::unit::ONE, datum.value, &datum.source, datum.grade, datum.errata);
        }
    }

    /// Records an input quantity if it is known.
    #[inline]
    pub fn known<Q: Measure>(&mut self, symbol: &'static str, unit: &'static Unit, datum: &Datum<Q>) {
        if let Some(known) = datum.known() {
            self.given(symbol, unit, known);
        }
    }

    /// Records an input number if it is known.
    #[inline]
    pub fn known_number(&mut self, symbol: &'static str, datum: &Datum<f64>) {
        if let Some(known) = datum.known() {
            self.given_number(symbol, known);
        }
    }

    /// Records an input value in SI.
    #[inline]
    pub fn figure(&mut self, symbol: &'static str, unit: &'static Unit, si: f64, source: &Source, grade: Grade) {
        if self.is_on() {
            self.record(symbol, unit, si, source, grade, &[]);
        }
    }

    fn record(
        &mut self,
        symbol: &'static str,
        unit: &'static Unit,
        si: f64,
        source: &Source,
        grade: Grade,
        errata: &'static [&'static str],
    ) {
        let Some(steps) = &mut self.steps else { return };
        // The same input value is recorded once, unless another value of its symbol followed: formulas take the latest.
        let is_same = |step: &&Step| step.si == si && step.unit.json == unit.json && step.how == How::Given;
        if steps.iter().rev().find(|step| step.symbol == symbol).is_some_and(|step| is_same(&step)) {
            return;
        }
        let (source, part) = (source.clone(), Part::Step);
        steps.push(Step { symbol, si, unit, how: How::Given, part, source, grade, errata });
    }

    /// Records the result of a formula, in SI. Its symbols are those of earlier steps, the latest of each name; grade
    /// and errata are those of its inputs.
    #[inline]
    pub fn formula(
        &mut self,
        symbol: &'static str,
        unit: &'static Unit,
        si: f64,
        text: impl Into<Cow<'static, str>>,
        source: &Source,
    ) {
        if self.is_on() {
            self.calculation(symbol, unit, si, (text.into(), Grade::Computed), source);
        }
    }

    /// Records the result of a formula like [`Self::formula`], for a model whose result is an estimate even with exact
    /// inputs.
    #[inline]
    pub fn estimate(
        &mut self,
        symbol: &'static str,
        unit: &'static Unit,
        si: f64,
        text: &'static str,
        source: &Source,
    ) {
        if self.is_on() {
            self.calculation(symbol, unit, si, (text.into(), Grade::Estimated), source);
        }
    }

    fn calculation(
        &mut self,
        symbol: &'static str,
        unit: &'static Unit,
        si: f64,
        (text, grade): (Cow<'static, str>, Grade),
        source: &Source,
    ) {
        let operands = self.operands(&formula::symbols(&text));
        self.push(symbol, unit, si, How::Formula { text, operands }, source, grade);
    }

    /// Records the result of a search, an integral or a curve, in SI. Earlier steps with its symbols are its operands;
    /// the grade is the worst of theirs and of `grade`.
    #[inline]
    pub fn found(
        &mut self,
        symbol: &'static str,
        unit: &'static Unit,
        si: f64,
        what: Finding,
        source: &Source,
        grade: Grade,
    ) {
        if self.is_on() {
            let how = How::Found { what, operands: self.operands(what.symbols()) };
            self.push(symbol, unit, si, how, source, grade);
        }
    }

    /// Marks the latest value of a symbol as the value demanded by the axis.
    #[inline]
    pub fn value(&mut self, symbol: &'static str) {
        if self.is_on() {
            self.mark(symbol, Part::Value);
        }
    }

    /// Marks the latest value of a symbol as the limit of the actuator.
    #[inline]
    pub fn limit(&mut self, symbol: &'static str) {
        if self.is_on() {
            self.mark(symbol, Part::Limit);
        }
    }

    fn mark(&mut self, symbol: &str, part: Part) {
        let steps = self.steps.iter_mut().flatten();
        if let Some(step) = steps.rev().find(|step| step.symbol == symbol) {
            step.part = part;
        }
    }

    fn operands(&self, symbols: &[&str]) -> Vec<usize> {
        let steps = self.steps.as_deref().unwrap_or_default();
        let mut operands = Vec::new();
        for name in symbols {
            if let Some(index) = steps.iter().rposition(|step| step.symbol == *name)
                && !operands.contains(&index)
            {
                operands.push(index);
            }
        }
        operands
    }

    fn push(&mut self, symbol: &'static str, unit: &'static Unit, si: f64, how: How, source: &Source, grade: Grade) {
        let Some(steps) = &mut self.steps else { return };
        let used = how.operands().iter().filter_map(|index| steps.get(*index));
        let grade = used.fold(grade, |grade, step| grade.worst(step.grade));
        let source = source.clone();
        steps.push(Step { symbol, si, unit, how, part: Part::Step, source, grade, errata: &[] });
    }
}

/// Evaluates the formula of a step with the values of its operands, in the unit of the step; `None` if the step is not
/// a formula.
///
/// # Errors
/// [`FormulaFault`] if the formula cannot be parsed or a symbol has no step.
pub fn evaluate(steps: &[Step], index: usize) -> Option<Result<f64, FormulaFault>> {
    let How::Formula { text, operands } = &steps.get(index)?.how else { return None };
    let value = |name: &str| {
        operands.iter().filter_map(|index| steps.get(*index)).find(|step| step.symbol == name).map(Step::value)
    };
    Some(Formula::parse(text).and_then(|formula| formula.value(&value)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use quantities::Torque;
    use quantities::unit::{KILOGRAM_SQUARE_METRE, NEWTON_METRE, REVOLUTION_PER_MINUTE, SECOND};

    const EQUATION: Source = Source::Equation { number: "69.1" };

    /// The manual's example: 5 + 2π/60 · 2.363 · 40/0.1 = 103.98 Nm.
    fn worked() -> Workings {
        let project = Source::Project { key: "load.inertia".into() };
        let mut work = Workings::on();
        let given = |si, grade| Sourced { value: Torque::from_si(si), source: project.clone(), grade, errata: &[] };
        work.given("T_L", &NEWTON_METRE, &given(5.0, Grade::Printed));
        work.figure("J_out", &KILOGRAM_SQUARE_METRE, 1.063, &project, Grade::Printed);
        work.figure("J_L", &KILOGRAM_SQUARE_METRE, 1.3, &project, Grade::Estimated);
        work.figure("n_2", &REVOLUTION_PER_MINUTE, 40.0 * std::f64::consts::TAU / 60.0, &project, Grade::Printed);
        work.figure("t_1", &SECOND, 0.1, &project, Grade::Printed);
        let torque = 5.0 + 2.363 * 40.0 * std::f64::consts::TAU / 60.0 / 0.1;
        work.formula("T_1", &NEWTON_METRE, torque, "T_L + 2*pi/60*(J_out + J_L)*n_2/t_1", &EQUATION);
        work.value("T_1");
        work
    }

    #[test]
    fn a_formula_gives_the_number_beside_it_and_the_worst_grade() {
        let steps = worked().into_steps();
        assert_eq!(steps.len(), 6);
        let last = &steps[5];
        assert_eq!((last.part, last.grade, last.operands()), (Part::Value, Grade::Estimated, &[0, 1, 2, 3, 4][..]));
        let value = evaluate(&steps, 5).unwrap().unwrap();
        assert!((value - last.value()).abs() < 1e-12 && (value - 103.98).abs() < 0.005, "{value}");
        assert!(evaluate(&steps, 0).is_none());
    }

    #[test]
    fn switched_off_nothing_is_noted() {
        let mut work = Workings::off();
        work.figure("T_L", &NEWTON_METRE, 5.0, &EQUATION, Grade::Printed);
        work.formula("T_1", &NEWTON_METRE, 5.0, "T_L", &EQUATION);
        assert!(!work.is_on() && work.into_steps().is_empty());
    }

    #[test]
    fn the_same_figure_is_noted_once_and_a_symbol_without_a_step_is_reported() {
        let mut work = Workings::on();
        work.figure("T_L", &NEWTON_METRE, 5.0, &EQUATION, Grade::Printed);
        work.figure("T_L", &NEWTON_METRE, 5.0, &EQUATION, Grade::Printed);
        work.formula("T_1", &NEWTON_METRE, 5.0, "T_L + T_x", &EQUATION);
        let steps = work.into_steps();
        assert_eq!(steps.len(), 2);
        assert_eq!(evaluate(&steps, 1), Some(Err(FormulaFault::Unknown { symbol: "T_x".to_owned() })));
    }

    #[test]
    fn a_figure_noted_again_behind_another_of_its_symbol_is_the_one_in_use() {
        let mut work = Workings::on();
        for torque in [5.0, 6.0, 5.0] {
            work.figure("T_L", &NEWTON_METRE, torque, &EQUATION, Grade::Printed);
        }
        work.formula("T_1", &NEWTON_METRE, 10.0, "2*T_L", &EQUATION);
        let steps = work.into_steps();
        assert_eq!(evaluate(&steps, 3), Some(Ok(10.0)));
    }
}
