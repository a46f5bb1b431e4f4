//! The table of a sweep as a file.

use crate::fault::path_text;
use quantities::Language;
use questions::list::Unanswered;
use std::fs::File;
use std::path::Path;
use sweep_io::{BatchHead, BatchSweep, Batches, NoBatch};
use words::{file_trouble, sweeps};

/// A table in a file.
pub(super) struct Table<'c> {
    pub(super) path: &'c Path,
    pub(super) language: Language,
}

impl Table<'_> {
    /// Returns a message about the table.
    pub(super) fn refused(&self, why: &str) -> Unanswered {
        Unanswered::message(sweeps::unreadable(&path_text(self.path), &why, self.language))
    }

    /// Opens the file.
    pub(super) fn file(&self) -> Result<File, Unanswered> {
        File::open(self.path).map_err(|error| self.refused(&file_trouble(&error, self.language)))
    }

    /// Opens the table at a row, so many at a time.
    pub(super) fn open(&self, skipped: u64, rows: usize) -> Result<Batches, Unanswered> {
        let opened = Batches::open(self.file()?, skipped, rows, self.language);
        opened.map_err(|why| self.refused(&why.text(self.language)))
    }

    /// Returns the sweep over the table and the number of its rows, after all cells have been read without faults.
    pub(super) fn checked(
        &self,
        mut batches: Batches,
        mut head: BatchHead,
        project_files: disk::ProjectFiles,
    ) -> Result<(BatchSweep, u64), Unanswered> {
        let mut rows = 0;
        let unread = loop {
            if head.is_enough() {
                break None;
            }
            match batches.next(self.language) {
                Ok(Some(batch)) => {
                    head.check(&batch, rows);
                    rows += batch.num_rows() as u64;
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
        match (head.ready(&path_text(self.path), Box::new(project_files)), unread) {
            (Ok(sweep), None) => Ok((sweep, rows)),
            (ready, unread) => Err(Unanswered::combined(ready.err().into_iter().chain(unread).collect())),
        }
    }
}
