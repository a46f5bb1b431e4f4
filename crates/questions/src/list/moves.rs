//! `moves PROJECT`: the motion of an axis, with the solved values of every segment, and its setpoints.

use super::given::{arguments, some, text};
use super::{AXIS, Answer, Argument, Cost, Entry, Gives, Inquiry, OutputFile, Reads, Record, Unanswered, media};
use crate::answer;
use crate::chapters::read_quantity;
use crate::moves::moves;
use crate::setpoints::{NoSetpoints, SETPOINTS_MOST, Setpoints, setpoints};
use axis::AxisProject;
use quantities::{Measure, Time};
use words::{help, help::values, requests};

arguments! {
    /// Arguments of `moves`: the axis, the step of the setpoints.
    pub struct Args {
        /// The axis of a project with several.
        axis: Option<String> = AXIS => text,
        /// The step of the setpoints; without it there are none.
        every: Option<Time> = Argument::option("every", values::time, help::moves_every).signed() => some(read_quantity),
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "moves",
    path: "moves",
    about: requests::moves,
    reads: Reads::Project,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<answers::Motion>("moves")),
    writes: &[OutputFile::of("out", &[media::CSV, media::PARQUET], help::moves_out).with("every")],
    example: "axis.toml --every 2ms --out setpoints.csv",
    answer: Some(|asked| {
        let args = Args::read(&asked.given)?;
        let (_, project) = asked.axis(args.axis.as_deref(), Cost::Other)?;
        let found = args.setpoints(&project, asked)?.map(|found| answer::setpoints(&found, None));
        Ok(Answer::record(&answer::motion_of(&project, found, asked.language)))
    }),
};

impl Args {
    /// Returns the setpoints at the stated step; `None` without one.
    ///
    /// # Errors
    /// A step that is not positive or too small.
    pub fn setpoints(&self, project: &AxisProject, inquiry: &Inquiry<'_>) -> Result<Option<Setpoints>, Unanswered> {
        let Some(every) = self.every else { return Ok(None) };
        let found = setpoints(project, &moves(project), every);
        found.map(Some).map_err(|why| {
            let message = match why {
                NoSetpoints::NoStep => requests::no_step_of_setpoints(inquiry.language).to_owned(),
                NoSetpoints::TooMany => {
                    let least = project.axis.motion.duration().si() / LEAST;
                    let least = words::unpadded(least * 1e3, 3, inquiry.language);
                    requests::too_many_setpoints(&SETPOINTS_MOST, &least, inquiry.language)
                }
            };
            Unanswered::option("every", (message, None))
        })
    }
}

/// Number of steps that is proposed in place of too many: below the limit whatever the rounding.
const LEAST: f64 = 990_000.0;
