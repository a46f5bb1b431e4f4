//! Errors in writing a table.

use quantities::Language;
use words::terminal;

/// Error in writing a table: a limit of the format, never a value.
#[derive(Debug, thiserror::Error)]
pub enum WriteError {
    /// The workbook library refuses the table.
    #[error(transparent)]
    Workbook {
        /// Error of the library.
        #[from]
        source: rust_xlsxwriter::XlsxError,
    },
    /// The Parquet library refuses the table.
    #[error(transparent)]
    Parquet {
        /// Error of the library.
        #[from]
        source: ::parquet::errors::ParquetError,
    },
}

impl WriteError {
    /// Returns the error in a sentence.
    #[must_use]
    pub fn message(&self, language: Language) -> String {
        match self {
            Self::Workbook { source } => terminal::workbook_not_written(source, language),
            Self::Parquet { source } => terminal::parquet_not_written(source, language),
        }
    }
}
