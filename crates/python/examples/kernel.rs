//! Judges the rows of `benches/baseline/sweep_python.py` without Python: the reference for the cost of the way through
//! Python and Arrow.
//!
//! `RAYON_NUM_THREADS=1 cargo run --release -p python --no-default-features --example kernel -- PROJECT ROWS` prints
//! the seconds of one pass on one core. The project has a load and a move with a stated time.
#![allow(clippy::print_stdout, reason = "it prints what it measures")]

use _antrieb::{SourceText, SweepCall};
use arrow_array::{ArrayRef, Float64Array, RecordBatch};
use quantities::Language;
use questions::Progress;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Instant;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [project, rows] = &words[..] else { return Err("PROJECT ROWS".into()) };
    let rows: u32 = rows.parse()?;
    let of = |make: fn(u32) -> f64| -> ArrayRef { Arc::new(Float64Array::from_iter_values((0..rows).map(make))) };
    let inertia = of(|row| 0.05 + f64::from(row % 1000) / 200.0);
    let time = of(|row| 0.5 + f64::from((row / 1000) % 1000) / 666.0);
    let table = RecordBatch::try_from_iter([("load.inertia [kg m^2]", inertia), ("motion[1].time [s]", time)])?;
    let call = SweepCall {
        text: SourceText::At(PathBuf::from(project)),
        pairs: vec![],
        memory: None,
        repeats: sweep_io::Repeats::Labels,
        language: Language::En,
    };
    let begin = Instant::now();
    let why = |why: questions::list::Unanswered| why.record(None, Language::En);
    let sweep = call.prepared(&table.schema(), std::slice::from_ref(&table)).map_err(why)?;
    let memory = call.memory_allowed().map_err(why)?;
    let answers = sweep.whole(&[table], 0, memory, &Progress::endless()).map_err(why)?;
    println!("{:.4} {}", begin.elapsed().as_secs_f64(), answers.iter().map(RecordBatch::num_rows).sum::<usize>());
    Ok(())
}
