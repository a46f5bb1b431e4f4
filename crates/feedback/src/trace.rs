//! Digital signals over time, and their file for logic analysers.

use std::fmt::Write;

/// Maximum number of edges of a trace.
pub const EDGES_MOST: usize = 1_000_000;

/// A digital signal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line {
    /// Name of the signal.
    pub name: &'static str,
    /// Level at the start.
    pub level: bool,
}

/// A change of level of one signal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Edge {
    /// Time of the edge \[ns\].
    pub time_ns: u64,
    /// Index of the line.
    pub line: usize,
    /// Level after the edge.
    pub level: bool,
}

/// Error: a trace would exceed [`EDGES_MOST`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TooManyEdges {
    /// Approximate number of edges.
    pub edges: f64,
}

/// Digital signals over time, with their edges.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Trace {
    /// Signals of the trace.
    pub lines: Vec<Line>,
    /// Edges in order of time.
    pub edges: Vec<Edge>,
    /// End of the trace \[ns\].
    pub end_ns: u64,
}

impl Trace {
    /// Adds the lines of another trace over the same time.
    #[must_use]
    pub fn with(mut self, other: Self) -> Self {
        let before = self.lines.len();
        self.lines.extend(other.lines);
        self.edges.extend(other.edges.into_iter().map(|edge| Edge { line: edge.line + before, ..edge }));
        self.edges.sort_by_key(|edge| (edge.time_ns, edge.line));
        self.end_ns = self.end_ns.max(other.end_ns);
        self
    }

    /// Returns the trace as a value change dump in nanoseconds.
    ///
    /// # Source
    /// IEEE 1364-2005, clause 18 (four-state VCD)
    #[must_use]
    pub fn vcd(&self, scope: &str) -> String {
        let mut out = String::with_capacity(300 + self.edges.len() * 12);
        // Names are single words in the file: white space would end them.
        let plain = |text: &str| text.replace(|sign: char| !sign.is_ascii_graphic(), "_");
        let _ = write!(out, "$timescale 1 ns $end\n$scope module {} $end\n", plain(scope));
        for (at, line) in self.lines.iter().enumerate() {
            let _ = writeln!(out, "$var wire 1 {} {} $end", key(at), plain(line.name));
        }
        out.push_str("$upscope $end\n$enddefinitions $end\n#0\n$dumpvars\n");
        for (at, line) in self.lines.iter().enumerate() {
            let _ = writeln!(out, "{}{}", u8::from(line.level), key(at));
        }
        out.push_str("$end\n");
        let mut now = 0;
        for edge in &self.edges {
            if edge.time_ns != now {
                now = edge.time_ns;
                let _ = writeln!(out, "#{now}");
            }
            let _ = writeln!(out, "{}{}", u8::from(edge.level), key(edge.line));
        }
        if self.end_ns > now {
            let _ = writeln!(out, "#{}", self.end_ns);
        }
        out
    }

    /// Returns the level of a line at a time.
    #[must_use]
    pub fn level(&self, line: usize, time_ns: u64) -> Option<bool> {
        let start = self.lines.get(line)?.level;
        let until = self.edges.partition_point(|edge| edge.time_ns <= time_ns);
        let before = self.edges.get(..until)?.iter().rev().find(|edge| edge.line == line);
        Some(before.map_or(start, |edge| edge.level))
    }
}

/// Returns the short name of a line, a printable character.
fn key(line: usize) -> char {
    u8::try_from(line).ok().and_then(|line| b'!'.checked_add(line)).map_or('~', char::from)
}

/// Builder of a clocked serial line: data changes on rising clock edges and is read on falling ones.
pub(crate) struct Clocked {
    trace: Trace,
    now_ns: u64,
    half_ns: u64,
}

/// Lines of a clocked trace.
const CLOCK: usize = 0;
const DATA: usize = 1;

impl Clocked {
    /// Creates both lines, at rest for some time.
    pub(crate) fn at_rest(half_ns: u64, rest_ns: u64, data: bool) -> Self {
        let lines = vec![Line { name: "CLOCK", level: true }, Line { name: "DATA", level: data }];
        Self { trace: Trace { lines, edges: Vec::new(), end_ns: 0 }, now_ns: rest_ns, half_ns }
    }

    fn edge(&mut self, line: usize, level: bool) {
        if self.trace.level(line, u64::MAX) != Some(level) {
            self.trace.edges.push(Edge { time_ns: self.now_ns, line, level });
        }
    }

    /// Adds one clock period, falling edge first, without new data.
    pub(crate) fn idle(&mut self) {
        self.edge(CLOCK, false);
        self.now_ns += self.half_ns;
        self.edge(CLOCK, true);
        self.now_ns += self.half_ns;
    }

    /// Adds one clock period; the bit is valid from the preceding rising edge.
    pub(crate) fn bit(&mut self, bit: bool) {
        // The clock rose half a period ago, when the bit was set.
        self.now_ns -= self.half_ns;
        self.edge(DATA, bit);
        self.now_ns += self.half_ns;
        self.idle();
    }

    /// Sets the data line to a level for some time while the clock rests.
    pub(crate) fn hold(&mut self, level: bool, time_ns: u64) {
        self.now_ns -= self.half_ns;
        self.edge(DATA, level);
        self.now_ns += time_ns.max(self.half_ns);
    }

    /// Returns the trace after some time at rest.
    pub(crate) fn done(mut self, rest_ns: u64, data: bool) -> Trace {
        self.edge(DATA, data);
        self.trace.edges.sort_by_key(|edge| (edge.time_ns, edge.line));
        self.trace.end_ns = self.now_ns + rest_ns;
        self.trace
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_trace_is_written_as_a_dump() {
        let trace = Trace {
            lines: vec![Line { name: "A", level: false }, Line { name: "B", level: true }],
            edges: vec![Edge { time_ns: 5, line: 0, level: true }, Edge { time_ns: 5, line: 1, level: false }],
            end_ns: 9,
        };
        assert_eq!(
            trace.vcd("CHA 1"),
            "$timescale 1 ns $end\n$scope module CHA_1 $end\n$var wire 1 ! A $end\n$var wire 1 \" B $end\n\
             $upscope $end\n$enddefinitions $end\n#0\n$dumpvars\n0!\n1\"\n$end\n#5\n1!\n0\"\n#9\n"
        );
        assert_eq!((trace.level(0, 4), trace.level(0, 5), trace.level(2, 0)), (Some(false), Some(true), None));
    }
}
