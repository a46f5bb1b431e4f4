//! Words of the catalogue file to fill in.

use crate::texts::texts;

texts! {
    how_to_check(file) =
        "Catalogue file; every line but the name is optional. Check: antrieb catalogue check {file}"
        | "Katalogdatei; außer dem Namen ist jede Zeile freigestellt. Prüfen: antrieb catalogue check {file}";
    rms =
        "Currents are rms per phase, torque constants per ampere rms. From peak values: current divided by √2, constant times √2."
        | "Ströme sind Effektivwerte je Phase, Drehmomentkonstanten gelten je Ampere effektiv. Aus Scheitelwerten: Strom durch √2, Konstante mal √2.";
    line_to_line =
        "Resistance, inductance and voltage constant are line to line. From phase values of a star winding: R and L times 2, k_E times √3."
        | "Widerstand, Induktivität und Spannungskonstante gelten Leiter-Leiter. Aus Strangwerten einer Sternschaltung: R und L mal 2, k_E mal √3.";
    voltage_constant =
        "The voltage constant is rms, per 1000 min⁻¹ of the motor or in V s/rad; in SI it is k_TM/√3."
        | "Die Spannungskonstante gilt effektiv, je 1000 min⁻¹ des Motors oder in V s/rad; in SI ist sie k_TM/√3.";
    cold =
        "The resistance is that at 20 °C, not that of the hot winding."
        | "Der Widerstand gilt bei 20 °C, nicht bei warmer Wicklung.";
    side =
        "Torques, speed_max, torque_constant_out and inertia_out hold at the output; keys with motor and gear_speed at the motor shaft."
        | "Drehmomente, speed_max, torque_constant_out und inertia_out gelten am Abtrieb; Schlüssel mit motor und gear_speed an der Motorwelle.";
    not_stated =
        "Leave out what the data sheet does not state: a zero is a value, a missing line is not checked."
        | "Was das Datenblatt nicht angibt, bleibt weg: eine Null ist ein Wert, eine fehlende Zeile wird nicht geprüft.";
    offer = "Offer" | "Angebot";
    offer_place =
        "Ordering code, title and revision of the data sheet, price list"
        | "Bestellbezeichnung, Titel und Ausgabe des Datenblatts, Preisliste";
    ratings = "Ratings" | "Leistungsdaten";
    ratings_place =
        "Table of ratings and torque-speed diagram; torque_max is the repeated peak torque, stall_torque the continuous one at the temperature rise and on the plate of the data sheet"
        | "Tabelle der Leistungsdaten und Drehmoment-Drehzahl-Diagramm; torque_max ist das wiederholte Spitzendrehmoment, stall_torque das Dauerdrehmoment bei der Erwärmung und auf der Platte des Datenblatts";
    motor = "Motor";
    motor_place =
        "Motor data or winding data; beware of peak values, phase values and the warm winding"
        | "Motordaten oder Wicklungsdaten; Vorsicht bei Scheitelwerten, Strangwerten und warmer Wicklung";
    gear = "Gear" | "Getriebe";
    gear_place =
        "Gear data of the actuator, else the rating table of the gear series; stiffness in three regions, accuracies at the output"
        | "Getriebedaten des Antriebs, sonst die Leistungstabelle der Getriebebaureihe; Steifigkeit in drei Bereichen, Genauigkeiten am Abtrieb";
    bearing = "Output bearing" | "Abtriebslager";
    bearing_place =
        "Table of the output bearing: load ratings, pitch diameter, permissible loads; the offset is measured from the flange"
        | "Tabelle des Abtriebslagers: Tragzahlen, Teilkreisdurchmesser, zulässige Lasten; der Abstand gilt vom Flansch";
    brake = "Holding brake" | "Haltebremse";
    brake_place =
        "Brake data; the torque at the motor shaft times the ratio is that at the output"
        | "Bremsdaten; das Drehmoment an der Motorwelle mal Untersetzung ist das am Abtrieb";
    encoder = "Encoder" | "Geber";
    encoder_place =
        "Encoder data, at the output: the values of a motor encoder divided by the ratio"
        | "Geberdaten, am Abtrieb: Werte eines Motorgebers durch die Untersetzung";
    ambient = "Ambient temperature" | "Umgebungstemperatur";
    ambient_place = "Operating conditions" | "Betriebsbedingungen";
    format =
        "Format of a catalogue file: toml (default) or csv; by the ending of the file that is written"
        | "Format einer Katalogdatei: toml (Vorgabe) oder csv; nach der Endung der geschriebenen Datei";
    format_of_catalogue_only =
        "a format is chosen for a catalogue file only" | "ein Format wird nur für eine Katalogdatei gewählt";
    other_ending(ending) =
        "the file ends with .{ending}" | "die Datei endet mit .{ending}";
    kind = "stock list or data sheets of any manufacturer, to be evaluated together with the built-in series"
        | "Lagerliste oder Datenblätter beliebiger Hersteller, zusammen mit der mitgelieferten Baureihe bewertet";
}
