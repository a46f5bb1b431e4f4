//! Time stamps that scatter and values held over rows, examined as those of a recording of a cycle, and taken out of a run.

use super::windows::Grain;
use super::{Column, HeldColumn, Observed, Scatter};
use motion::{HeldSignal, Stamps};

/// A run without scatter of the stamps and without held values.
pub(super) struct Examined {
    pub(super) run: Observed,
    /// Noise of its signals.
    pub(super) grain: Grain,
    /// Scatter of the stamps, which even instants replace.
    pub(super) scatter: Option<Scatter>,
    /// Scatter of stamps that remain, because no signal shows which instants it follows.
    pub(super) undecided: Option<Scatter>,
    /// Columns with one value for each update.
    pub(super) held: Vec<HeldColumn>,
}

/// Examines stamps first, then the values of each column.
pub(super) fn examined(mut run: Observed) -> Examined {
    let (mut scatter, mut undecided) = (None, None);
    match Stamps::of(&run.time_s, &[&run.position_rad, &run.motor_rad_s]) {
        Stamps::Kept => {}
        Stamps::Scattered(even) => {
            scatter = Some(Scatter { scatter_s: even.scatter_s, interval_s: even.interval_s });
            run.time_s = even.time_s;
        }
        Stamps::Undecided { scatter_s, interval_s } => undecided = Some(Scatter { scatter_s, interval_s }),
    }
    let Observed { time_s, position_rad, speed_rad_s, motor_rad_s, torque_nm, current_q_a } = &mut run;
    let mut held = Vec::new();
    let mut taken = |column, values: &mut Vec<f64>| {
        let found = HeldSignal::of(time_s, values)?;
        held.push(HeldColumn { column, period_s: found.period_s });
        *values = found.values;
        Some((found.updated, found.period_s))
    };
    let position = taken(Column::Position, position_rad);
    let _ = speed_rad_s.as_mut().and_then(|speed| taken(Column::Speed, speed));
    let motor = taken(Column::MotorSpeed, motor_rad_s);
    let torque = taken(Column::Torque, torque_nm);
    let current = taken(Column::Current, current_q_a);
    let period = |found: &Option<(Vec<f64>, f64)>| found.as_ref().map_or(0.0, |(_, period)| *period);
    let updates_s = [period(&position), period(&torque), period(&current), period(&motor)];
    let values = |found: Option<(Vec<f64>, f64)>| found.map(|(updated, _)| updated);
    let [of_position, of_torque, of_motor] = [values(position), values(torque), values(motor)];
    let grain = Grain::of(
        of_position.as_deref().unwrap_or(&run.position_rad),
        of_torque.as_deref().unwrap_or(&run.torque_nm),
        of_motor.as_deref().unwrap_or(&run.motor_rad_s),
        updates_s,
    );
    Examined { run, grain, scatter, undecided, held }
}
