//! Words about mounting: fits, bores, screw joints.

use super::{quantity_fault, quantity_hint};
use crate::pick;
use crate::texts::texts;
use installation::fit::{BoreFault, FitKind, Side};
use installation::joint::LoadCase;
use quantities::unit::MILLIMETRE;
use quantities::{Language, Length, Measure, format_number};

/// The side of the actuator.
#[must_use]
pub fn side_title(side: Side, language: Language) -> String {
    let (en, de) = match side {
        Side::Load => ("load", "Last"),
        Side::Housing => ("housing", "Gehäuse"),
    };
    pick(language, en, de).to_owned()
}

/// What a fit is by ISO 286-1.
#[must_use]
pub fn fit_word(kind: FitKind, language: Language) -> String {
    let (en, de) = match kind {
        FitKind::Clearance => ("clearance fit", "Spielpassung"),
        FitKind::Transition => ("transition fit", "Übergangspassung"),
        FitKind::Interference => ("interference fit", "Übermaßpassung"),
    };
    pick(language, en, de).to_owned()
}

/// What loads a joint.
#[must_use]
pub fn load_case_title(case: LoadCase, language: Language) -> String {
    let (en, de) = match case {
        LoadCase::Peak => ("peak torque", "Spitzendrehmoment"),
        LoadCase::Collision => ("collision", "Kollision"),
        LoadCase::Brake => ("brake holds or stops", "Bremse hält oder stoppt"),
        LoadCase::StaticMoment => ("tilting at rest", "Kippen im Stillstand"),
    };
    pick(language, en, de).to_owned()
}

/// What is wrong with a bore, and what would be right.
#[must_use]
pub fn bore_fault(fault: &BoreFault, language: Language) -> (String, Option<String>) {
    // As it was written: rounded only by what the conversion of units has added.
    let millimetres = |length: &Length| {
        let text = format_number(length.in_unit(&MILLIMETRE), 6, language);
        text.trim_end_matches('0').trim_end_matches(['.', ',']).to_owned()
    };
    match fault {
        BoreFault::UnknownZone { written, known } => {
            let message = crate::mounting::no_tolerance_zone(written, language);
            (message, Some(crate::mounting::tolerance_zones(&known.join(", "), language)))
        }
        BoreFault::NoLength(error) => (quantity_fault(error, language), quantity_hint(error, language)),
        BoreFault::UpsideDown { upper, lower } => {
            (crate::mounting::deviations_upside_down(&millimetres(upper), &millimetres(lower), language), None)
        }
        BoreFault::TooLarge { deviation, most } => {
            (crate::mounting::deviation_too_large(&millimetres(deviation), &millimetres(most), language), None)
        }
    }
}

texts! {
    title(code) = "Mounting of {code}" | "Montage von {code}";
    no_tolerance_zone(written) =
        "`{written}` is neither a tolerance zone of a bore nor limit deviations"
        | "„{written}“ ist weder das Toleranzfeld einer Bohrung noch ein Paar Grenzabmaße";
    tolerance_zones(known) =
        "zones: {known}; or limit deviations such as `+12/-3 um`"
        | "Toleranzfelder: {known}; oder Grenzabmaße wie `+12/-3 um`";
    deviations_upside_down(upper, lower) =
        "the upper limit deviation of {upper} mm is below the lower one of {lower} mm"
        | "das obere Grenzabmaß von {upper} mm liegt unter dem unteren von {lower} mm";
    deviation_too_large(deviation, most) =
        "a limit deviation of {deviation} mm makes no fit; at most {most} mm are taken"
        | "ein Grenzabmaß von {deviation} mm ergibt keine Passung; höchstens {most} mm werden angenommen";
    fit_is_named_otherwise(zone, pilot, fit, id) =
        "{zone} over {pilot} is a {fit}, though the manual calls it a transition fit (erratum {id})"
        | "{zone} auf {pilot} ist eine {fit}, obwohl die Anleitung sie Übergangspassung nennt (Druckfehler {id})";
    tolerances_are_drawn(figure) =
        "what the tolerances a to d measure is drawn in figure {figure}, which is not at hand; outer contour, length and engagement of the screws are drawn only, too, and not stated here"
        | "was die Toleranzen a bis d messen, zeigt Abbildung {figure}, die nicht vorliegt; auch Außenkontur, Länge und Einschraubtiefe der Schrauben sind nur gezeichnet und hier nicht angegeben";
    joint_loads_are_limits =
        "loads without a project: T_max, the collision torque T_M of an interchangeable gear, the holding torque of the brake, and the tilting moments that the output bearing permits; --project takes those of a project"
        | "Lasten ohne Projekt: T_max, das Kollisionsmoment T_M eines austauschbaren Getriebes, das Haltemoment der Bremse und die Kippmomente, die das Abtriebslager zulässt; --project nimmt die eines Projekts";
    joint_loads_of(axis) =
        "loads of the project: {axis}; tilting moment about the centre of the output bearing, each load at its largest of the cycle"
        | "Lasten des Projekts: {axis}; Kippmoment um die Mitte des Abtriebslagers, jede Last mit ihrem größten Wert im Zyklus";
    no_flange_loads_known =
        "the project has no known loads on the flange: the tilting moment is the one that the output bearing permits"
        | "das Projekt nennt keine vollständigen Lasten am Flansch: das Kippmoment ist das zulässige des Abtriebslagers";
    joint_model =
        "with moment: estimated, model screw-joint: rigid flange, moment shared linearly, every screw counted like the one relieved most, clamp force from the printed torque; the torque alone decides, the estimate advises"
        | "mit Moment: geschätzt, Modell Schraubverbindung: starrer Flansch, Moment linear verteilt, jede Schraube gerechnet wie die am stärksten entlastete, Klemmkraft aus dem abgedruckten Drehmoment; es entscheidet das Drehmoment allein, die Schätzung ist ein Hinweis";
    nothing_known_of(what) =
        "{what}: nothing is printed or published"
        | "{what}: dazu ist nichts abgedruckt oder veröffentlicht";
    fits_head = "fits" | "Passungen";
    pilot = "pilot" | "Zentrierung";
    bore = "bore" | "Bohrung";
    deviation_pilot = "pilot µm" | "Zentrierung µm";
    deviation_bore = "bore µm" | "Bohrung µm";
    clearance_um = "clearance µm" | "Spiel µm";
    off_centre_um = "off centre µm" | "außermittig µm";
    fit_head = "fit" | "Passung";
    own_deviations = "own" | "eigene";
    dimensions_head = "tolerances, dimensions, mass" | "Toleranzen, Maße, Masse";
    not_printed = "not printed" | "nicht abgedruckt";
    lifting_gear_needed =
        "more than 20 kg: lift with lifting gear only"
        | "mehr als 20 kg: nur mit Hebezeug heben";
    lifting_gear_not_known =
        "no mass is printed for this design: weigh it before it is lifted by hand"
        | "für diese Ausführung ist keine Masse abgedruckt: vor dem Heben von Hand wiegen";
    joint_head(side) = "screw joint of the {side}" | "Schraubverbindung: {side}";
    joint_screws(count, size, class, circle, tightening, transmissible, friction) =
        "{count} × {size}, class {class}, bolt circle {circle} mm, tightened with {tightening} Nm; transmits {transmissible} Nm with degreased faces (µ = {friction})"
        | "{count} × {size}, Festigkeitsklasse {class}, Teilkreis {circle} mm, Anzugsdrehmoment {tightening} Nm; überträgt {transmissible} Nm bei entfetteten Flächen (µ = {friction})";
    joint_clamp(force, grade) = "{force} kN of clamp force per screw, {grade}" | "Klemmkraft {force} kN je Schraube, {grade}";
    load_head = "load" | "Belastung";
    torque_nm = "torque Nm" | "Moment Nm";
    tilting_nm = "tilting Nm" | "Kippen Nm";
    relieved_percent = "relieved %" | "entlastet %";
    with_moment_percent = "with moment %" | "mit Moment %";
    joint_opens = "opens" | "öffnet";
    demands_head = "to be kept" | "Einzuhalten";
    always = "always" | "immer";
}
