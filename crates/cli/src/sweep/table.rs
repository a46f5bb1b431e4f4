//! The table of a sweep: a file, or values that the call states.

use crate::command::own::VARY;
use crate::fault::path_text;
use quantities::Language;
use questions::list::Unanswered;
use std::fs::File;
use std::io::Read;
use std::path::Path;
use sweep_io::{BatchHead, BatchSweep, Batches, NoBatch};
use words::{file_trouble, sweeps};

/// TableRows of a table.
pub(super) enum TableRows<'c> {
    /// File.
    File(&'c Path),
    /// Text in CSV, made of the values that the call states.
    Stated(String),
}

/// A table.
pub(super) struct Table<'c> {
    pub(super) rows: TableRows<'c>,
    pub(super) language: Language,
}

impl Table<'_> {
    /// Returns the name of the table for messages.
    fn name(&self) -> String {
        match &self.rows {
            TableRows::File(path) => path_text(path),
            TableRows::Stated(_) => format!("--{VARY}"),
        }
    }

    /// Returns a message about the table.
    pub(super) fn refused(&self, why: &str) -> Unanswered {
        Unanswered::message(sweeps::unreadable(&self.name(), &why, self.language))
    }

    fn file(&self, path: &Path) -> Result<File, Unanswered> {
        disk::open_regular(path).map_err(|error| self.refused(&file_trouble(&error, self.language)))
    }

    /// Opens the bytes of the table.
    pub(super) fn source(&self) -> Result<Box<dyn Read + '_>, Unanswered> {
        Ok(match &self.rows {
            TableRows::File(path) => Box::new(self.file(path)?),
            TableRows::Stated(text) => Box::new(text.as_bytes()),
        })
    }

    /// Opens the table at a row, so many at a time.
    pub(super) fn open(&self, skipped: u64, rows: usize) -> Result<Batches, Unanswered> {
        let opened = match &self.rows {
            TableRows::File(path) => Batches::open(self.file(path)?, skipped, rows, self.language),
            TableRows::Stated(text) => Batches::of_text(text.clone(), skipped, rows, self.language),
        };
        opened.map_err(|why| self.refused(&why.text(self.language)))
    }

    /// Returns the sweep over the table and the number of its rows, after all cells have been read without faults.
    pub(super) fn checked(
        &self,
        mut batches: Batches,
        mut head: BatchHead,
        project_files: disk::ProjectFiles,
    ) -> Result<(BatchSweep, [u64; 2]), Unanswered> {
        let mut rows = 0;
        let unread = loop {
            if head.is_enough() {
                break None;
            }
            match batches.next(self.language) {
                Ok(Some(batch)) => {
                    head.check(&batch, rows);
                    rows += batch.num_rows() as u64;
                    crate::waiting::count_read(rows);
                }
                Ok(None) => {
                    head.refuse_empty(rows);
                    break None;
                }
                Err(NoBatch::Line(fault)) => {
                    head.refuse_line(fault, rows);
                    rows += 1;
                }
                Err(NoBatch::Table(why)) => break Some(self.refused(&why)),
            }
        };
        match (head.ready(&self.name(), Box::new(project_files)), unread) {
            (Ok(sweep), None) => Ok((sweep, [rows, batches.comments()])),
            (ready, unread) => Err(Unanswered::combined(ready.err().into_iter().chain(unread).collect())),
        }
    }
}
