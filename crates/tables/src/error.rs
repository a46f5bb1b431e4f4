//! What keeps a table from being written.

/// What keeps a table from being written: a limit of the format, never a value.
#[derive(Debug, thiserror::Error)]
pub enum WriteError {
    /// The workbook does not take it.
    #[error("the workbook cannot be written: {source}")]
    Workbook {
        /// What it says.
        #[from]
        source: rust_xlsxwriter::XlsxError,
    },
    /// The Parquet file does not take it.
    #[error("the Parquet file cannot be written: {source}")]
    Parquet {
        /// What it says.
        #[from]
        source: ::parquet::errors::ParquetError,
    },
}
