//! What keeps a table from being written.

use quantities::Language;
use words::terminal;

/// What keeps a table from being written: a limit of the format, never a value.
#[derive(Debug, thiserror::Error)]
pub enum WriteError {
    /// The workbook does not take it.
    #[error(transparent)]
    Workbook {
        /// What it says.
        #[from]
        source: rust_xlsxwriter::XlsxError,
    },
    /// The Parquet file does not take it.
    #[error(transparent)]
    Parquet {
        /// What it says.
        #[from]
        source: ::parquet::errors::ParquetError,
    },
}

impl WriteError {
    /// The trouble in a sentence.
    #[must_use]
    pub fn message(&self, language: Language) -> String {
        match self {
            Self::Workbook { source } => terminal::workbook_not_written(source, language),
            Self::Parquet { source } => terminal::parquet_not_written(source, language),
        }
    }
}
