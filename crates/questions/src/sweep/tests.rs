use super::*;
use project::NoFiles;
use std::fmt::Write as _;

pub(super) const MOVE: &str = "format = 1\n[load]\ninertia = \"1 kg m^2\"\nfriction_torque = \"5 N m\"\n[[motion]]\n\
    law = \"trapezoid\"\ndistance = \"90 deg\"\ntime = \"0.5 s\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n";

fn sweep(text: &str, headings: &[&str]) -> Result<Sweep, TableFaults> {
    Sweep::new(("axis.toml", text), Box::new(NoFiles), headings, Options::default()).map_err(|why| match why {
        Unanswered::Table { faults, .. } => faults,
        other => panic!("{other:?}"),
    })
}

fn numbers(cells: &[f64]) -> Cells<'static> {
    Cells::Numbers(cells.iter().copied().map(Some).collect())
}

fn texts<'c>(cells: &[&'c str]) -> Cells<'c> {
    Cells::Texts(cells.iter().map(|cell| Some(Cow::Borrowed(*cell))).collect())
}

fn best(answer: &Answer) -> Best {
    match answer {
        Ok(Judged::Best(best)) => *best,
        other => panic!("{other:?}"),
    }
}

/// What `size` answers of a project.
fn sized(text: &str) -> Result<Best, String> {
    let project = crate::read(text).map_err(|faults| {
        let each = words::worded(&faults, Language::default()).into_iter().map(|fault| fault.message);
        each.collect::<Vec<_>>().join("; ")
    })?;
    let sizing = crate::size(&project);
    let fit = sizing.candidates.iter().filter(|candidate| candidate.fits()).count();
    let finite = |utilisation: f64| utilisation.is_finite().then_some(utilisation);
    let fit = u32::try_from(fit).unwrap();
    let found = match (sizing.answer(), sizing.nearest_miss()) {
        (Some(answer), _) => Best {
            fit,
            code: match answer.id {
                crate::CandidateId::Code(code) => Some(code),
                crate::CandidateId::Own(_) => None,
            },
            utilisation: finite(answer.standing.utilisation),
            tightest: answer.judgement.tightest().map(|check| check.id),
        },
        (None, Some(miss)) => Best {
            fit,
            code: None,
            utilisation: finite(miss.standing.utilisation),
            tightest: miss.worst_failure().map(|check| check.id),
        },
        (None, None) => Best { fit, code: None, utilisation: None, tightest: None },
    };
    Ok(found)
}

#[test]
fn a_row_is_answered_as_the_project_with_its_values() {
    let sweep = sweep(MOVE, &["load.inertia [kg m^2]", "motion[0].time [ms]"]).unwrap();
    let found = sweep
        .judge(&[numbers(&[1.0, 0.1, 400.0, -1.0]), numbers(&[500.0, 200.0, 100.0, 100.0])], &Patience::endless())
        .unwrap();
    for (answer, (inertia, time)) in found.iter().zip([("1", "500"), ("0.1", "200"), ("400", "100")]) {
        let text = MOVE.replace("1 kg m^2", &format!("{inertia} kg m^2")).replace("0.5 s", &format!("{time} ms"));
        assert_eq!(best(answer), sized(&text).unwrap());
    }
    assert_eq!(found[3], Err("`load.inertia` must not be negative, not \"-1 kg m^2\"".to_owned()));
    assert!(best(&found[0]).fit > 50 && best(&found[2]).code.is_none());
}
