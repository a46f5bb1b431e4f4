//! Signals of the shaft behind a stage.

use super::{EXCITING, loads, moves, none, recorded, said};
use mechanism::{Mechanism, Stage, StageKind};
use quantities::{Measure, MomentOfInertia};
use twin::{Column, Misread, Observed};

/// Behind a stage the position, or a speed, is that of another shaft: it is named so, and no column that is right.
#[test]
fn signals_behind_a_stage_are_named() {
    let [wheel, ..] = loads();
    let motion = moves(&EXCITING);
    for ratio in [0.4, 3.0, 7.5] {
        let stage = Stage {
            kind: StageKind::Belt,
            ratio,
            efficiency_driving: 1.0,
            efficiency_driven: 1.0,
            inertia_driving: MomentOfInertia::from_si(0.0),
            inertia_driven: MomentOfInertia::from_si(0.0),
            stiffness: None,
            backlash: None,
            pitch_diameter: None,
        };
        let mechanism = Mechanism { stage: Some(stage), ..wheel.clone() };
        let run = recorded(&mechanism, &motion, &none(), 2);
        let named = |change: &dyn Fn(&mut Observed)| {
            let mut run = run.clone();
            change(&mut run);
            let found = said(&run, &mechanism, &motion, &none()).doubts;
            found.iter().map(|doubt| (doubt.column, doubt.misread)).collect::<Vec<_>>()
        };
        let divided = |column: &mut Vec<f64>| column.iter_mut().for_each(|value| *value /= ratio);
        assert_eq!(named(&|_| {}), [], "{ratio}");
        let of_both = named(&|run| {
            divided(&mut run.position_rad);
            run.speed_rad_s.as_mut().into_iter().for_each(divided);
        });
        assert_eq!(of_both, [(Column::Position, Misread::BehindStage)], "{ratio}");
        let of_speed = named(&|run| run.speed_rad_s.as_mut().into_iter().for_each(divided));
        assert_eq!(of_speed, [(Column::Speed, Misread::BehindStage)], "{ratio}");
    }
}
