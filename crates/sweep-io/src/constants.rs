//! Values of the project beside the answers: the same in every row.

use arrow_array::{ArrayRef, Float64Array, RecordBatch, StringArray};
use arrow_schema::{DataType, Field, Schema, SchemaRef};
use project::{Counted, Heading, Written, key_at, written};
use std::sync::Arc;

/// Values of a project that no column of its table changes, each a column beside the answers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Constants(Vec<(String, Constant)>);

/// Value in every row.
#[derive(Clone, Debug, PartialEq)]
enum Constant {
    Number(f64),
    Text(String),
}

impl Constants {
    /// Returns the values that a project states for one of its axes, without those of the columns; `prefix` is that of the
    /// paths of the axis. A number has its unit in the heading, as in a table of rows.
    #[must_use]
    pub fn of(text: &str, prefix: &str, columns: &[&str]) -> Self {
        let all = written(text).unwrap_or_default();
        let of_axis = |path: &str| match path.strip_prefix(prefix) {
            Some(own) if !own.starts_with("axis[") => Some(own.to_owned()),
            // What the axes of a file share.
            None if !path.starts_with("axis[") => Some(path.to_owned()),
            _ => None,
        };
        let constant = |each: &Written| {
            let (path, value) = (of_axis(&each.path)?, each.value.as_deref()?);
            let is_due = key_at(&path).is_some() && path.contains('.') && !columns.contains(&path.as_str());
            is_due.then(|| column(path, value))
        };
        Self(all.iter().filter_map(constant).collect())
    }

    fn field((name, constant): &(String, Constant)) -> Arc<Field> {
        let of = match constant {
            Constant::Number(_) => DataType::Float64,
            Constant::Text(_) => DataType::Utf8,
        };
        Arc::new(Field::new(name, of, false))
    }

    /// Returns the columns of answers with the values behind them.
    #[must_use]
    pub fn schema(&self, answers: &SchemaRef) -> SchemaRef {
        if self.0.is_empty() {
            return Arc::clone(answers);
        }
        let own = self.0.iter().map(Self::field);
        Arc::new(Schema::new(answers.fields().iter().cloned().chain(own).collect::<Vec<_>>()))
    }

    /// Returns answers with the values in every row.
    ///
    /// # Errors
    /// A batch that cannot be composed.
    pub fn in_each_row(&self, answers: &RecordBatch) -> Result<RecordBatch, String> {
        let rows = answers.num_rows();
        let own = self.0.iter().map(|(_, constant)| match constant {
            Constant::Number(number) => Arc::new(Float64Array::from(vec![*number; rows])) as ArrayRef,
            Constant::Text(text) => Arc::new(StringArray::from(vec![text.as_str(); rows])),
        });
        let columns = answers.columns().iter().cloned().chain(own).collect();
        RecordBatch::try_new(self.schema(&answers.schema()), columns).map_err(|error| error.to_string())
    }
}

/// Returns the column of a key with its value: a number of the unit in the heading, else the text of the file.
fn column(path: String, value: &str) -> (String, Constant) {
    if let Some((number, unit)) = recording::with_unit(value) {
        let heading = format!("{path} [{unit}]");
        let is_read = Heading::read(&heading, Counted::FromOne, None).is_ok_and(|heading| heading.is_number());
        if let Some(number) = recording::number(number, false).filter(|_| is_read) {
            return (heading, Constant::Number(number));
        }
    }
    let is_number = Heading::read(&path, Counted::FromOne, None).is_ok_and(|heading| heading.is_number());
    match recording::number(value, false).filter(|_| is_number) {
        Some(number) => (path, Constant::Number(number)),
        None => (path, Constant::Text(value.to_owned())),
    }
}
