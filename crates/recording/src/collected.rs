//! Faults of a file as they are found.

use crate::FAULTS_MAX;
use crate::faults::{Fault, FaultKind, Remedy};

/// Number of faults after which reading stops, because the rest of the file gives no new information.
const COUNTED_MAX: u64 = 10_000;

/// Number of equal faults reported individually; of more than that, only the first is kept.
const EQUAL_MAX: u64 = 3;

/// Faults of a file, in the order found.
#[derive(Debug, Default)]
pub(crate) struct FaultCollector {
    listed: Vec<Fault>,
    /// Kinds of repeatable faults, with the number of occurrences.
    kinds: Vec<(FaultKind, u64)>,
    /// Number of faults found but not kept.
    more: u64,
    /// Number of these whose kind is represented by its first fault.
    repeated: u64,
    /// Ways to read the recording without faults in these columns.
    remedies: Vec<(String, Remedy)>,
    /// Ways to read the recording where time runs backwards, and where rows have the same time.
    order: [Option<Remedy>; 2],
}

impl FaultCollector {
    pub(crate) fn push(&mut self, fault: Fault) {
        if let Some(kind) = fault.kind() {
            match self.kinds.iter_mut().find(|(known, _)| *known == kind) {
                Some((_, count)) => {
                    *count = count.saturating_add(1);
                    if *count > EQUAL_MAX {
                        self.more = self.more.saturating_add(1);
                        self.repeated = self.repeated.saturating_add(1);
                        return;
                    }
                }
                None if self.listed.len() < FAULTS_MAX => self.kinds.push((kind, 1)),
                None => {}
            }
        }
        if self.listed.len() < FAULTS_MAX {
            self.listed.push(fault);
        } else {
            self.more = self.more.saturating_add(1);
        }
    }

    /// Returns the faults kept, with many equal ones combined into one.
    fn grouped(&mut self) -> Vec<Fault> {
        let mut grouped: Vec<Fault> = Vec::new();
        let mut begun: Vec<FaultKind> = Vec::new();
        for fault in std::mem::take(&mut self.listed) {
            let kind = fault.kind();
            let count = kind.as_ref().and_then(|kind| self.kinds.iter().find(|(known, _)| known == kind));
            match (kind.clone(), count) {
                (Some(kind), Some((_, count))) if *count > EQUAL_MAX => {
                    if !begun.contains(&kind) {
                        begun.push(kind);
                        grouped.push(Fault::Repeated { first: Box::new(fault), more: count - 1 });
                    }
                }
                _ => grouped.push(fault),
            }
        }
        grouped
    }

    /// Adds ways to read the recording despite faults in columns.
    pub(crate) fn advise(&mut self, remedies: Vec<(String, Remedy)>) {
        self.remedies = remedies;
    }

    /// Adds ways to read the recording where time runs backwards, and where rows have the same time.
    pub(crate) const fn advise_order(&mut self, backwards: Option<Remedy>, same: Option<Remedy>) {
        self.order = [backwards, same];
    }

    /// Adds the remedy to a fault of a column or of the order of the rows.
    fn advised(&self, fault: Fault) -> Fault {
        let of_order = match &fault {
            Fault::Repeated { first, .. } => self.of_order(first),
            fault => self.of_order(fault),
        };
        if let Some(remedy) = of_order {
            return Fault::Advised { fault: Box::new(fault), remedy };
        }
        let found = match &fault {
            Fault::Repeated { first, .. } => first.column_of_value(),
            fault => fault.column_of_value(),
        };
        let remedy = found.and_then(|name| self.remedies.iter().find(|(column, _)| column == name));
        match remedy {
            Some((_, remedy)) => Fault::Advised { fault: Box::new(fault), remedy: *remedy },
            None => fault,
        }
    }

    const fn of_order(&self, fault: &Fault) -> Option<Remedy> {
        let [backwards, same] = self.order;
        match fault {
            Fault::Backwards { .. } => backwards,
            Fault::SameTime { .. } => same,
            _ => None,
        }
    }

    pub(crate) const fn none(&self) -> bool {
        self.listed.is_empty()
    }

    /// Returns `true` if further reading is pointless.
    pub(crate) const fn enough(&self) -> bool {
        self.more >= COUNTED_MAX
    }

    /// Returns the answer if there is no fault, else the faults.
    pub(crate) fn outcome<T>(mut self, answer: Option<T>) -> Result<T, Vec<Fault>> {
        match answer {
            Some(answer) if self.listed.is_empty() => Ok(answer),
            _ => {
                let stopped = self.enough();
                let grouped = self.grouped();
                let mut listed: Vec<Fault> = grouped.into_iter().map(|fault| self.advised(fault)).collect();
                let count = self.more - self.repeated;
                if count > 0 || stopped {
                    listed.push(Fault::More { count, stopped });
                }
                Err(listed)
            }
        }
    }
}
