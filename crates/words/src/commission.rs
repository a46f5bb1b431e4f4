//! Words of the commissioning: headings, names of objects and files, and the phrases around figures.

use crate::texts::texts;

texts! {
    title(code) = "commissioning of {code}" | "Inbetriebnahme von {code}";
    hazards = "hazards and conditions" | "Gefahren und Bedingungen";
    parameters = "motor and gear" | "Motor und Getriebe";
    parameter = "parameter" | "Parameter";
    conversion = "conversion" | "Umrechnung";
    gaps = "not stated, and what to do" | "nicht angegeben, und was zu tun ist";
    encoder = "encoder settings" | "Gebereinstellungen";
    side_motor = "motor" | "Motor";
    side_output = "output" | "Abtrieb";
    commutation = "commutation offset" | "Kommutierungswinkel";
    thresholds = "temperature sensors" | "Temperatursensoren";
    threshold = "threshold" | "Schwelle";
    temperature = "temperature" | "Temperatur";
    resistance = "resistance" | "Widerstand";
    overload = "overload supervision I²t" | "Überlastüberwachung I²t";
    objects = "objects of CiA 402" | "Objekte nach CiA 402";
    object = "object" | "Objekt";
    type_of_data = "type" | "Typ";
    rounding = "before rounding" | "vor dem Runden";
    expected = "expected" | "erwartet";
    measured = "measured" | "gemessen";
    likely_cause(cause) = "likely cause: {cause}" | "wahrscheinliche Ursache: {cause}";
    between(low, high) = "{low} to {high}" | "{low} bis {high}";
    at_most_value(value) = "at most {value}" | "höchstens {value}";
    script_purpose(code) =
        "motor data of {code} for a SINAMICS drive, made by antrieb"
        | "Motordaten von {code} für einen SINAMICS-Umrichter, erzeugt von antrieb";
    script_use =
        "one parameter a line, data set 0: compare number, unit and value with the drive's list manual while entering them"
        | "ein Parameter je Zeile, Datensatz 0: beim Eintragen Nummer, Einheit und Wert mit dem Listenhandbuch des Umrichters vergleichen";
    script_identify =
        "the drive's own motor identification and the determination of the commutation offset come after these values"
        | "die Motoridentifikation des Umrichters und die Bestimmung des Kommutierungswinkels folgen nach diesen Werten";
    script_missing = "not written here:" | "hier nicht geschrieben:";
    look_up(symbol, value, unit) =
        "{symbol} = {value} {unit}: number of the parameter in the drive's list manual"
        | "{symbol} = {value} {unit}: Nummer des Parameters im Listenhandbuch des Umrichters";
    eds_description = "Motor data of an actuator, to be merged into the configuration of the drive";
    eds_not_the_drive =
        "no EDS of a drive: only the objects of the profile that follow from the motor"
        | "keine EDS eines Antriebsreglers: nur die Objekte des Profils, die aus dem Motor folgen";
    blank_purpose(code) =
        "measured values of {code}: take the # away from what was measured, write the value with its unit"
        | "gemessene Werte von {code}: bei allem Gemessenen das # entfernen und den Wert mit Einheit eintragen";
    blank_use(code, file) =
        "antrieb commission {code} --record {file}"
        | "antrieb commission {code} --record {file} --lang de";
    needed = "needed if this table is there" | "nötig, wenn diese Tabelle vorkommt";
    object_max_torque = "Max torque";
    object_max_current = "Max current";
    object_rated_current = "Motor rated current";
    object_rated_torque = "Motor rated torque";
    object_polarity = "Polarity: positive is flange clockwise, seen from the front; 0 is counter-clockwise" | "Polarity: positiv heißt Flansch rechts, von vorne gesehen; 0 heißt links";
    object_max_motor_speed = "Max motor speed";
    object_encoder_increments = "Position encoder resolution: encoder increments";
    object_encoder_revolutions = "Position encoder resolution: motor revolutions";
    object_gear_motor = "Gear ratio: motor revolutions";
    object_gear_shaft = "Gear ratio: shaft revolutions";
    object_encoder = "Position encoder resolution";
    object_gear = "Gear ratio";
    object_device_type = "Device type";
    object_error_register = "Error register";
    object_identity = "Identity";
    object_vendor = "Vendor-ID";
    highest_sub_index = "Highest sub-index supported";
    limit_run(speed_motor, speed_out, time) =
        "test run outside the final place: about {speed_motor} min⁻¹ at the motor, {speed_out} min⁻¹ at the flange, {time} min at the longest"
        | "Probelauf außerhalb des Einbauorts: etwa {speed_motor} min⁻¹ am Motor, {speed_out} min⁻¹ am Flansch, höchstens {time} min";
    set_value(name) = "set in the drive: {name}" | "im Regler gesetzt: {name}";
    hottest = "largest temperature of the winding that day, below the warning" | "höchste Wicklungstemperatur des Tages, unter der Warnung";
    at_temperature(name, celsius) = "{name} at {celsius} °C" | "{name} bei {celsius} °C";
    at_motor_speed(name, speed) = "{name} at {speed} min⁻¹ of the motor" | "{name} bei {speed} min⁻¹ am Motor";
    at_output_speed(name, speed, celsius) =
        "{name} at {speed} min⁻¹ of the flange, housing at {celsius} °C"
        | "{name} bei {speed} min⁻¹ am Flansch, Gehäuse {celsius} °C";
    warning_threshold = "warning" | "Warnung";
    shutdown_threshold = "shutdown" | "Abschaltung";
    ptc_cold = "cold, up to 20 K below response" | "kalt, bis 20 K unter Ansprechtemperatur";
    ptc_below = "5 K below response" | "5 K unter Ansprechtemperatur";
    ptc_above = "5 K above response" | "5 K über Ansprechtemperatur";
    ptc_far_above = "15 K above response" | "15 K über Ansprechtemperatur";
    no_ptc =
        "no PTC: the 6-pin motor connector has no contact for it; the KTY comes in with the encoder"
        | "kein PTC: der 6-polige Motorstecker hat dafür keinen Kontakt; der KTY kommt mit dem Geber";
    overload_text =
        "factor is rms current over I_0; the manual prints no time constant, this one is of the thermal model; t = τ ln(k²/(k² − 1)) from the cold"
        | "Faktor ist Effektivstrom durch I_0; die Anleitung druckt keine Zeitkonstante, diese ist aus dem Erwärmungsmodell; t = τ ln(k²/(k² − 1)) aus kaltem Zustand";
    overload_not_known =
        "no time constant is known for this winding"
        | "für diese Wicklung ist keine Zeitkonstante bekannt";
    overload_line(current, time_constant) =
        "I_0 = {current} A rms; τ = {time_constant} s"
        | "I_0 = {current} A effektiv; τ = {time_constant} s";
    overload_trip(factor, time) =
        "{factor} times I_0: responds after {time} s"
        | "{factor}-facher I_0: spricht nach {time} s an";
    commute_uncoupled =
        "nothing on the flange, the axis free to turn, the emergency stop within reach"
        | "nichts am Flansch, Achse frei drehbar, Not-Halt in Reichweite";
    commute_limits =
        "current limit at I_0 and speed limit low until the offset is confirmed"
        | "Stromgrenze auf I_0 und Drehzahlgrenze niedrig, bis der Winkel bestätigt ist";
    commute_brake =
        "open the brake for the measurement: the rotor must be able to turn; hold a load otherwise"
        | "Bremse für die Messung öffnen: der Läufer muss drehen können; eine Last anders halten";
    commute_c1024 =
        "C1024: the tracks C/D give the rotor angle roughly at switching on, the reference signal makes it exact; the offset belongs to both"
        | "C1024: die Spuren C/D geben beim Einschalten den Läuferwinkel grob an, das Referenzsignal macht ihn genau; der Winkel gehört zu beiden";
    commute_absolute =
        "absolute encoder: determine the offset once and store it; again after the encoder was exchanged"
        | "Absolutwertgeber: den Winkel einmal bestimmen und speichern; nach einem Gebertausch erneut";
    commute_resolver =
        "resolver with one pole pair: its angle is absolute within a turn, so the offset is determined once"
        | "einpolpaariger Resolver: sein Winkel ist innerhalb einer Umdrehung absolut, der Winkel wird einmal bestimmt";
    commute_d2048 =
        "D2048: U/V/W give six states of 60° electrical at switching on, the pulse Z makes the angle exact after one turn"
        | "D2048: U/V/W geben beim Einschalten sechs Zustände zu 60° elektrisch, der Impuls Z macht den Winkel nach einer Umdrehung genau";
    commute_sinamics =
        "SINAMICS: p1990 = 1 determines the offset and writes it into p0431 (list manual); without brake the motor moves meanwhile"
        | "SINAMICS: p1990 = 1 bestimmt den Winkel und schreibt ihn in p0431 (Listenhandbuch); ohne Bremse bewegt sich der Motor dabei";
    commute_confirm =
        "confirm it: same current for the same speed in both directions, no run-away at a small torque command in either"
        | "bestätigen: gleicher Strom bei gleicher Drehzahl in beiden Richtungen, bei kleinem Momentsollwert kein Durchgehen";
    commute_value =
        "the manual prints no offset: write down the one that was found, with the serial number"
        | "die Anleitung druckt keinen Winkel: den gefundenen mit der Seriennummer notieren";
    record_summary(off, not_checked) =
        "{off} off, {not_checked} not checked"
        | "{off} auffällig, {not_checked} nicht geprüft";
    right = "as it should be" | "richtig";
    reversed = "reversed" | "umgekehrt";
    not_measured = "not measured" | "nicht gemessen";
    not_stated =
        "nothing to compare with: the manual states no value for this code or condition"
        | "kein Vergleichswert: die Anleitung nennt für diesen Code oder Zustand keinen";
    not_there = "this code does not have it" | "hat dieser Code nicht";
    checklist_is_a_pdf(file) =
        "{file}: the check-lists are a PDF, name a file that ends in .pdf"
        | "{file}: die Prüflisten sind ein PDF, eine Datei mit der Endung .pdf nennen";
    record_alone =
        "--record judges measured values and goes with none of --for, --out, --checklist, --blank"
        | "--record beurteilt Gemessenes und steht nicht neben --for, --out, --checklist, --blank";
    field_done(text) = "done: {text}" | "erledigt: {text}";
    field_measured(text) = "measured: {text}" | "gemessen: {text}";
    field_measured_in(text, unit) = "measured in {unit}: {text}" | "gemessen in {unit}: {text}";
    signature = "date, name, signature" | "Datum, Name, Unterschrift";
    serial_number = "serial number" | "Seriennummer";
    page = "page" | "Seite";
    not_affiliated =
        "antrieb is not affiliated with the maker of the actuators; the maker's documents are what counts"
        | "antrieb steht in keiner Verbindung zum Hersteller der Antriebe; maßgebend sind dessen Unterlagen";
}
