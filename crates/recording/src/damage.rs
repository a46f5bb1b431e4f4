//! Reasons why a Parquet file cannot be read.

use thiserror::Error;

/// Reason why a Parquet file cannot be read.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum Damage {
    /// The magic bytes of the format are missing.
    #[error("it is none")]
    NoParquet,
    /// The file is encrypted.
    #[error("it is encrypted")]
    Encrypted,
    /// The pages lie in another file.
    #[error("its pages lie in another file")]
    Elsewhere,
    /// The footer is damaged.
    #[error("its footer is damaged")]
    Footer,
    /// A page is damaged.
    #[error("a page is damaged")]
    Page,
    /// A page does not unpack to its stated size.
    #[error("a page does not unpack to the size that it says")]
    Packed,
    /// The columns of a row group differ in length.
    #[error("the columns of a row group differ in length")]
    Lengths,
    /// A compression that is not supported.
    #[error("compression {name} is not read")]
    Compression {
        /// Name, or number if unknown.
        name: String,
    },
    /// An encoding of numbers that is not supported.
    #[error("encoding {name} of numbers is not read")]
    Encoding {
        /// Name, or number if unknown.
        name: String,
    },
    /// The values cannot be decoded.
    #[error("the values of a page: {text}")]
    Values {
        /// Message of the library.
        text: String,
    },
}
