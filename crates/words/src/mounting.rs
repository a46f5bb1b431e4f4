//! Words for mounting: fits, bores, bolted joints.

use super::{quantity_fault, quantity_hint};
use crate::pick;
use crate::texts::texts;
use installation::fit::{BoreFault, FitKind, Side};
use installation::joint::LoadCase;
use quantities::unit::MILLIMETRE;
use quantities::{Language, Length, Measure, format_number};

/// Returns the name of a side of the actuator.
#[must_use]
pub fn side_title(side: Side, language: Language) -> String {
    let (en, de) = match side {
        Side::Load => ("load", "Last"),
        Side::Housing => ("housing", "Gehäuse"),
    };
    pick(language, en, de).to_owned()
}

/// Returns the kind of a fit according to ISO 286-1.
#[must_use]
pub fn fit_word(kind: FitKind, language: Language) -> String {
    let (en, de) = match kind {
        FitKind::Clearance => ("clearance fit", "Spielpassung"),
        FitKind::Transition => ("transition fit", "Übergangspassung"),
        FitKind::Interference => ("interference fit", "Übermaßpassung"),
    };
    pick(language, en, de).to_owned()
}

/// Returns the name of a load case of a joint; `is_of_a_limit`: its moment is not a load of the axis but what the bearing permits.
#[must_use]
pub fn load_case_title(case: LoadCase, is_of_a_limit: bool, language: Language) -> String {
    let (en, de) = match case {
        LoadCase::StaticMoment if is_of_a_limit => {
            ("permissible static tilting moment of the bearing", "zulässiges statisches Kippmoment des Lagers")
        }
        LoadCase::Peak => ("peak torque in the joint", "Spitzendrehmoment in der Verbindung"),
        LoadCase::Collision => ("collision", "Kollision"),
        LoadCase::Brake => ("holding or emergency stop by the brake", "Halten oder Not-Halt durch die Bremse"),
        LoadCase::StaticMoment => ("tilting moment at standstill", "Kippmoment im Stillstand"),
    };
    pick(language, en, de).to_owned()
}

/// Returns the fault of a bore and the remedy.
#[must_use]
pub fn bore_fault(fault: &BoreFault, language: Language) -> (String, Option<String>) {
    // The spelling of the user, apart from the rounding of the unit conversion.
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
        "`{written}` is neither a tolerance zone of a bore nor a pair of limit deviations"
        | "„{written}“ ist weder das Toleranzfeld einer Bohrung noch ein Paar Grenzabmaße";
    tolerance_zones(known) =
        "zones: {known}; or limit deviations such as `+12/-3 um`"
        | "Toleranzfelder: {known}; oder Grenzabmaße wie `+12/-3 um`";
    deviations_upside_down(upper, lower) =
        "the upper limit deviation of {upper} mm is below the lower one of {lower} mm"
        | "das obere Grenzabmaß von {upper} mm liegt unter dem unteren von {lower} mm";
    deviation_too_large(deviation, most) =
        "a limit deviation of {deviation} mm is not a fit; at most {most} mm are accepted"
        | "ein Grenzabmaß von {deviation} mm ergibt keine Passung; zulässig sind höchstens {most} mm";
    fit_is_named_otherwise(zone, pilot, fit, place) =
        "{zone} on {pilot} is a {fit}, although the manual calls it a transition fit (erratum, {place})"
        | "{zone} auf {pilot} ist eine {fit}, obwohl die Anleitung sie Übergangspassung nennt (Druckfehler, {place})";
    tolerances_are_drawn(figure) =
        "tolerances a to d are defined in figure {figure}, which is not available; outer contour, screw length and thread engagement are also given in drawings only and not stated here"
        | "die Toleranzen a bis d sind in Abbildung {figure} festgelegt, die nicht vorliegt; auch Außenkontur, Schraubenlänge und Einschraubtiefe sind nur gezeichnet und hier nicht angegeben";
    joint_loads_are_limits =
        "loads without a project: T_max, the collision torque T_M of an interchangeable gear, the holding torque of the brake, and the permissible tilting moments of the output bearing; with a project, its loads are used"
        | "Lasten ohne Projekt: T_max, das Kollisionsdrehmoment T_M eines baugleich einsetzbaren Getriebes, das Haltemoment der Bremse und die zulässigen Kippmomente des Abtriebslagers; mit einem Projekt gelten dessen Lasten";
    joint_loads_of(axis) =
        "loads of the project: {axis}; tilting moment about the centre of the output bearing, each load at its maximum over the cycle"
        | "Lasten des Projekts: {axis}; Kippmoment um die Mitte des Abtriebslagers, jede Last mit ihrem größten Wert im Zyklus";
    no_flange_loads_known =
        "the project does not state complete flange loads: the permissible tilting moment of the output bearing is used"
        | "das Projekt nennt keine vollständigen Flanschlasten: angesetzt ist das zulässige Kippmoment des Abtriebslagers";
    joint_model =
        "with tilting moment: estimated, model of the bolted joint: rigid flange, linear distribution of the moment, all screws treated as the most relieved one, clamp force from the stated tightening torque; the torque alone governs, the estimate is for information"
        | "mit Kippmoment: geschätzt, Modell der Schraubenverbindung: starrer Flansch, lineare Verteilung des Moments, alle Schrauben wie die am stärksten entlastete gerechnet, Klemmkraft aus dem angegebenen Anzugsdrehmoment; maßgebend ist das Drehmoment allein, die Schätzung ist ein Hinweis";
    nothing_known_of(what) =
        "{what}: not stated and not published"
        | "{what}: weder angegeben noch veröffentlicht";
    fits_head = "fits" | "Passungen";
    pilot = "pilot" | "Zentrierung";
    bore = "bore" | "Bohrung";
    deviation_pilot = "pilot µm" | "Zentrierung µm";
    deviation_bore = "bore µm" | "Bohrung µm";
    clearance_um = "clearance µm" | "Spiel µm";
    off_centre_um = "eccentricity µm" | "Außermittigkeit µm";
    fit_head = "fit" | "Passung";
    own_deviations = "own" | "eigene";
    dimensions_head = "tolerances, dimensions, mass" | "Toleranzen, Maße, Masse";
    not_printed = "not stated" | "nicht angegeben";
    lifting_gear_needed =
        "more than 20 kg: use lifting gear"
        | "mehr als 20 kg: nur mit Hebezeug heben";
    lifting_gear_not_known =
        "the mass of this design is not stated: weigh it before lifting it by hand"
        | "die Masse dieser Ausführung ist nicht angegeben: vor dem Heben von Hand wiegen";
    joint_head(side) = "bolted joint: {side}" | "Schraubenverbindung: {side}";
    joint_screws(count, size, class, circle, tightening, transmissible, friction) =
        "{count} × {size}, property class {class}, bolt circle {circle} mm, tightening torque {tightening} Nm; transmits {transmissible} Nm at µ = {friction}"
        | "{count} × {size}, Festigkeitsklasse {class}, Lochkreis {circle} mm, Anzugsdrehmoment {tightening} Nm; überträgt {transmissible} Nm bei µ = {friction}";
    joint_clamp(force, grade) = "clamp force {force} kN per screw, {grade}" | "Klemmkraft {force} kN je Schraube, {grade}";
    load_head = "load" | "Belastung";
    torque_nm = "torque Nm" | "Moment Nm";
    tilting_nm = "tilting moment Nm" | "Kippmoment Nm";
    relieved_percent = "relief %" | "Entlastung %";
    with_moment_percent = "with tilting moment %" | "mit Kippmoment %";
    joint_opens = "opens" | "öffnet";
    demands_head = "instructions" | "Hinweise";
    always = "general" | "allgemein";
}
