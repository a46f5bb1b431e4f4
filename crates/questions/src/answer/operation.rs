//! The cycle on the chosen actuator and the data of that actuator in the manual, as records.

use crate::sheet::{SheetRow, sheet, sheet_value_text};
use answers::{DataLine, Duty, MotorSide, Number, Operation, SegmentLoad};
use order_code::OrderCode;
use quantities::unit::REVOLUTION_PER_MINUTE;
use quantities::{Language, Unit};
use sizing::{Check, CheckId, Checks, Note};
use words::operation::{duty_id, duty_name, duty_reason};
use words::{condition_text, symbol_term};

/// The cycle on an actuator whose checks are these, with the errata of k_TM: energies of the cycle and the largest power are theirs.
pub(super) fn operation(
    found: &sizing::Operation,
    (checks, errata): (&Checks, &'static [&'static str]),
    language: Language,
) -> Operation {
    let energies = checks.iter().find(|check| check.id == CheckId::Regeneration).and_then(energies);
    let found = energies.map_or_else(|| found.clone(), |energies| found.clone().with_energies(energies));
    Operation {
        segments: found.segments.iter().map(load).collect(),
        cycle: load(&found.cycle),
        motor: found.motor.map(|motor| MotorSide {
            ratio: Number(motor.ratio),
            speed_peak: speed(motor.speed_peak_rad_s),
            speed_mean: speed(motor.speed_mean_rad_s),
            torque_peak_cold: motor.torque_peak_cold_nm.map(Number),
            torque_peak: motor.torque_peak_nm.map(Number),
            torque_rms: motor.torque_rms_nm.map(Number),
            torque_errata: errata,
        }),
        inertia_load: Number(found.inertia_load),
        inertia_own: Number(found.inertia_own),
        duty: Duty {
            id: duty_id(found.duty),
            name: duty_name(found.duty, language),
            reason: duty_reason(found.duty, language),
        },
    }
}

fn energies(check: &Check) -> Option<[f64; 2]> {
    check.notes.iter().find_map(|note| match note {
        Note::EnergyPerCycle { motoring, regenerated, .. } => {
            use quantities::Measure;
            Some([motoring.si(), regenerated.si()])
        }
        _ => None,
    })
}

fn speed(rad_s: f64) -> Number {
    Number(REVOLUTION_PER_MINUTE.from_si(rad_s))
}

fn load(of: &sizing::SegmentLoad) -> SegmentLoad {
    SegmentLoad {
        duration: Number(of.duration_s),
        torque_peak: Number(of.torque_peak_nm),
        torque_rms: Number(of.torque_rms_nm),
        speed_peak: speed(of.speed_peak_rad_s),
        current_peak_cold: of.current_peak_cold_a.map(Number),
        current_peak: of.current_peak_a.map(Number),
        current_rms: of.current_rms_a.map(Number),
        power_peak: of.power_peak_w.map(Number),
        energy_taken: of.energy_taken_j.map(Number),
        energy_returned: of.energy_returned_j.map(Number),
    }
}

/// Symbols of the data sheet, in their order, each with its letters in the manual; empty if the manual has none.
const SHEET: [(&str, &str); 61] = [
    ("T_max", "T_max"),
    ("T_0", "T_0"),
    ("n_max", "n_max"),
    ("I_max", "I_max"),
    ("I_0", "I_0"),
    ("U_DCmax", "U_DCmax"),
    ("n_mot_max", "n_mot_max"),
    ("n_N", "n_N"),
    ("k_Tout", "k_Tout"),
    ("k_TM", "k_TM"),
    ("k_EM", "k_EM"),
    ("R_LL", "R_LL"),
    ("L_LL", "L_LL"),
    ("p", "p"),
    ("tau_e", "τ_e"),
    ("tau_m", "τ_m"),
    ("I_E", "I_E"),
    ("I_NLS", "I_NLS"),
    ("J_out", "J_out"),
    ("J_out_brake", "J_out"),
    ("U_Br", "U_Br"),
    ("T_Br", "T_Br"),
    ("I_OBr", "I_OBr"),
    ("I_HBr", "I_HBr"),
    ("t_o", "t_o"),
    ("t_c", "t_c"),
    ("transmission_accuracy", ""),
    ("repeatability", ""),
    ("hysteresis_loss", ""),
    ("lost_motion", ""),
    ("K_1", "K_1"),
    ("K_2", "K_2"),
    ("K_3", "K_3"),
    ("T_1", "T_1"),
    ("T_2", "T_2"),
    ("C", "C"),
    ("C_0", "C_0"),
    ("d_p", "d_p"),
    ("R", "R"),
    ("M_dyn_max", "M_dyn_max"),
    ("M_0_max", "M_0_max"),
    ("F_A_dyn_max", "F_A_dyn_max"),
    ("F_R_dyn_max", "F_R_dyn_max"),
    ("K_B", "K_B"),
    ("resolution_out", ""),
    ("accuracy", ""),
    ("T_NAT", "T_NAT"),
    ("T_KTY", "T_KTY"),
    ("L", "L"),
    ("L_brake", "L_1"),
    ("d_H", "d_H"),
    ("m", "m"),
    ("m_brake", "m"),
    ("protection_class", ""),
    ("ambient_temperature_operation", ""),
    ("altitude", ""),
    ("relative_humidity", ""),
    ("vibration_resistance", ""),
    ("shock_resistance", ""),
    ("insulation_class", ""),
    ("temperature_sensors", ""),
];

/// Returns the data of an actuator of the catalogue: drive, brake, gear, output bearing, encoder, dimensions,
/// environment.
///
/// A threshold of the KTY is left out if `without_kty`: no connector leads it out.
pub(super) fn data_sheet(code: &OrderCode, without_kty: bool, language: Language) -> Vec<DataLine> {
    let Some(sheet) = sheet(code) else { return Vec::new() };
    let rows: Vec<&SheetRow> = sheet.sections.iter().flat_map(|section| &section.rows).collect();
    let of = |(symbol, printed): &(&'static str, &'static str)| {
        let applies = *symbol != "T_KTY" || !without_kty;
        let found = rows.iter().filter(move |row| applies && row.cell.place.symbol == *symbol);
        let printed = *printed;
        found.map(move |row| line(row, printed, language)).collect::<Vec<_>>()
    };
    SHEET.iter().flat_map(of).chain([mounting_position(language)]).collect()
}

/// The mounting position, which no table of the manual states.
fn mounting_position(language: Language) -> DataLine {
    DataLine {
        symbol: "",
        name: words::operation::mounting_position(language).to_owned(),
        value: words::operation::not_stated(language).to_owned(),
        unit: String::new(),
        table: "",
        errata: &[],
    }
}

fn line(row: &SheetRow, symbol: &'static str, language: Language) -> DataLine {
    let cell = row.cell;
    let mut name = symbol_term(cell.place.symbol, language);
    if !cell.place.condition.is_empty() {
        name = format!("{name} ({})", condition_text(cell.place.condition, language));
    }
    let value = sheet_value_text(row, language);
    let is_none = matches!(value.as_str(), "" | "-");
    DataLine {
        symbol,
        name,
        unit: if is_none {
            String::new()
        } else {
            Unit::of(cell.unit).map_or(cell.unit, |unit| unit.symbol_in(language)).to_owned()
        },
        value: if is_none { "–".to_owned() } else { value },
        table: cell.place.table,
        errata: cell.errata,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A check that counts a datum of the gear, such as the sum of angle errors, can be followed in the report.
    #[test]
    fn the_data_sheet_has_every_datum_of_the_accuracy_and_stiffness_of_the_gear() {
        let mut seen = 0;
        for (code, _) in configurator::all().iter().step_by(41) {
            let Some(sheet) = sheet(code) else { continue };
            let of_the_gear = |section: &&crate::sheet::SheetSection| section.table.id.starts_with("54.");
            let rows = sheet.sections.iter().filter(of_the_gear).flat_map(|section| &section.rows);
            let lines = data_sheet(code, true, Language::En);
            for row in rows {
                let name = symbol_term(row.cell.place.symbol, Language::En);
                assert!(lines.iter().any(|line| line.name.starts_with(&name)), "{code} {name}");
                seen += 1;
            }
        }
        assert!(seen > 200, "{seen}");
    }
}
