//! Words about signals and words of encoders.

use crate::pick;
use crate::texts::texts;
use installation::encoder::Assumed;
use provenance::Grade;
use quantities::Language;

texts! {
    title(code) = "Encoder signals of {code}" | "Gebersignale von {code}";
    motor_feedback = "motor encoder" | "Motorgeber";
    output_encoder = "output encoder (option EC)" | "Abtriebsgeber (Option EC)";
    shaft(turns, angle, speed) =
        "shaft: turn {turns}, {angle}°, {speed} min⁻¹, clockwise positive"
        | "Welle: Umdrehung {turns}, {angle}°, {speed} min⁻¹; Rechtslauf zählt aufwärts";
    seen(angle, accuracy) =
        "the encoder sees {angle}° (accuracy ±{accuracy}″)"
        | "der Geber sieht {angle}° (Genauigkeit ±{accuracy}″)";
    bits = "bits as sent" | "Bits in Senderichtung";
    field = "field" | "Feld";
    value = "value" | "Wert";
    signal = "signal" | "Signal";
    pins = "pins" | "Stifte";
    meaning = "meaning" | "Bedeutung";
    tracks = "encoder tracks" | "Geberspuren";
    angle_from_the_shaft = "angle from the shaft position" | "Winkel ab Wellenposition";
    tracks_caption(range) =
        "{range}° of the shaft. The dashed line marks the shaft position; clockwise rotation continues to the right."
        | "{range}° der Welle. Die gestrichelte Linie ist die Wellenposition; Rechtslauf setzt sich nach rechts fort.";
    tracks_described(angle, range) =
        "Tracks over {range}° around the shaft angle of {angle}°."
        | "Spuren über {range}° um den Wellenwinkel {angle}°.";
    excitation = "excitation" | "Erregung";
    sine_winding = "sine winding" | "Sinuswicklung";
    cosine_winding = "cosine winding" | "Kosinuswicklung";
    carrier_caption =
        "Two periods of the excitation at the stated shaft speed."
        | "Zwei Perioden der Erregung bei der angegebenen Wellendrehzahl.";
    carrier_described(frequency) =
        "Resolver voltages at an excitation of {frequency} kHz."
        | "Spannungen des Resolvers bei einer Erregung von {frequency} kHz.";
    turn_the_shaft = "turn the shaft" | "Welle drehen";
    periods = "periods per turn" | "Perioden je Umdrehung";
    assumptions = "not stated in the manual" | "in der Anleitung nicht angegeben";
    notes = "notes on the position" | "Hinweise zur Position";
    no_words = "no serial interface: no data word is sent" | "keine serielle Schnittstelle: kein Datenwort";
    high = "high";
    low = "low";
    at_peak = "at the peak of the excitation" | "im Scheitel der Erregung";
    of_amplitude = "of the amplitude" | "der Amplitude";
    endat_2_2 = "EnDat 2.2 position (mode command 111000)" | "EnDat-2.2-Position (Modebefehl 111000)";
    endat_2_1 = "EnDat 2.1 position (mode command 000111)" | "EnDat-2.1-Position (Modebefehl 000111)";
    ssi = "SSI position, binary" | "SSI-Position, binär";
    endat_parameter = "EnDat parameter" | "EnDat-Parameter";
    endat_information = "EnDat additional information" | "EnDat-Zusatzinformation";
    endat_command = "EnDat mode command" | "EnDat-Modebefehl";
    field_start = "start bit" | "Startbit";
    field_error_1 = "error 1, high in case of an error" | "Fehler 1, high bei Fehler";
    field_error_2 = "error 2, low in case of an error" | "Fehler 2, low bei Fehler";
    field_position = "position, lowest bit first" | "Position, niedrigstes Bit zuerst";
    field_turns = "turns, highest bit first" | "Umdrehungen, höchstes Bit zuerst";
    field_step = "step of the turn, highest bit first" | "Schritt der Umdrehung, höchstes Bit zuerst";
    field_head = "address or status" | "Adresse oder Status";
    field_value = "value" | "Wert";
    field_command = "command" | "Befehl";
    field_crc = "checksum (CRC)" | "Prüfsumme (CRC)";
    decoded(bits) = "word read: {bits}" | "gelesenes Wort: {bits}";
    decoded_position(turns, angle) = "position: turn {turns}, {angle}°" | "Position: Umdrehung {turns}, {angle}°";
    word_is_right = "the word contains no errors" | "das Wort ist fehlerfrei";
    ssi_has_no_check =
        "SSI transmits no checksum: a wrong bit inside the word cannot be detected"
        | "SSI überträgt keine Prüfsumme: ein falsches Bit im Wort ist nicht erkennbar";
    fault_length(found, expected) =
        "the word has {found} bits; this encoder sends {expected}"
        | "das Wort hat {found} Bit; dieser Geber sendet {expected}";
    fault_start = "the start bit is low" | "das Startbit ist low";
    fault_start_hint =
        "the word begins with the start bit; check the number of clock periods before it and the propagation delay of the cable"
        | "das Wort beginnt mit dem Startbit; Anzahl der Taktperioden davor und Laufzeit der Leitung prüfen";
    fault_alike = "error bits F1 and F2 are equal" | "die Fehlerbits F1 und F2 sind gleich";
    fault_alike_hint =
        "F1 and F2 are inverse to each other: a bit is wrong, or the word is one of command set 2.1 with one error bit"
        | "F1 und F2 sind zueinander invers: ein Bit ist falsch, oder das Wort gehört zum Befehlssatz 2.1 mit einem Fehlerbit";
    fault_crc(found, expected) =
        "the checksum is {found}; the bits require {expected}"
        | "die Prüfsumme ist {found}; aus den Bits folgt {expected}";
    fault_crc_hint =
        "a bit is wrong: check shielding, termination and clock frequency, and that data are read on the falling clock edge"
        | "ein Bit ist falsch: Schirm, Abschlusswiderstand und Taktfrequenz prüfen, und ob mit der fallenden Taktflanke gelesen wird";
    fault_command = "these six bits are not a valid mode command" | "diese sechs Bit sind kein gültiger Modebefehl";
    fault_reported = "the encoder reports an error" | "der Geber meldet einen Fehler";
    fault_reported_hint =
        "read the error source in the operating status and reset the error; the position may be wrong"
        | "Fehlerursache im Betriebsstatus auslesen und Fehler zurücksetzen; die Position kann falsch sein";
    no_word_to_decode = "this encoder sends no data word" | "dieser Geber sendet kein Datenwort";
    no_error_to_report = "no encoder of this ordering code reports errors in its data word" | "kein Geber dieser Bestellbezeichnung meldet Fehler im Datenwort";
    no_battery_to_lose = "no encoder of this ordering code has a battery" | "kein Geber dieser Bestellbezeichnung hat eine Batterie";
    bits_are_0_and_1(sign, place) =
        "`{sign}` at position {place} is not a bit: a word consists of 0 and 1"
        | "`{sign}` an Stelle {place} ist kein Bit: ein Wort besteht aus 0 und 1";
    word_is_empty = "the word has no bits" | "das Wort hat keine Bits";
    word_is_too_long(most) = "a word has at most {most} bits" | "ein Wort hat höchstens {most} Bit";
    turn_is_whole(most) =
        "the number of turns must be a whole number from -{most} to {most}"
        | "die Umdrehungszahl muss eine ganze Zahl von -{most} bis {most} sein";
    angle_is_bounded(most) =
        "the angle must be between -{most} and {most} turns"
        | "der Winkel muss zwischen -{most} und {most} Umdrehungen liegen";
    speed_is_bounded(most) =
        "the speed must be between −{most} and {most} min⁻¹"
        | "die Drehzahl muss zwischen −{most} und {most} min⁻¹ liegen";
    window_is_bounded = "the window must be greater than zero and at most 360°" | "das Fenster muss größer als null und höchstens 360° sein";
    time_is_bounded(most) =
        "the length of the trace must be greater than zero and at most {most} s"
        | "die Aufzeichnungsdauer muss größer als null und höchstens {most} s sein";
    too_many_edges(edges, most) =
        "the trace would contain about {edges} edges; {most} are permitted"
        | "die Aufzeichnung enthielte etwa {edges} Flanken; zulässig sind {most}";
    too_many_edges_hint = "use a shorter --time or a lower --speed" | "--time oder --speed kleiner wählen";
    nothing_digital = "a resolver has no digital signals that could be written" | "ein Resolver hat keine digitalen Signale, die geschrieben werden könnten";
    no_output_encoder = "this ordering code has no output encoder" | "diese Bestellbezeichnung hat keinen Abtriebsgeber";
    overflow(turns, sent) =
        "turn {turns} is outside 0 to {sent}: the position has overflowed; the controller must count the overflows"
        | "Umdrehung {turns} liegt außerhalb von 0 bis {sent}: die Position ist übergelaufen; die Steuerung muss die Überläufe zählen";
    battery_lost =
        "battery and supply failed at the same time: the transmitted position is wrong without any indication in the word; home the axis before any motion"
        | "Batterie und Versorgung sind gleichzeitig ausgefallen: die gemeldete Position ist falsch, ohne dass das Wort es anzeigt; Achse vor jeder Bewegung neu referenzieren";
    incremental_only =
        "the position is lost when the supply fails: home the axis after switch-on"
        | "die Position geht beim Ausfall der Versorgung verloren: Achse nach dem Einschalten referenzieren";
}

/// Returns an assumption and its basis.
#[must_use]
pub const fn assumed(what: Assumed, language: Language) -> &'static str {
    let (en, de) = match what {
        Assumed::OrderOfTracks => (
            "track A leads B as the angle increases, as with M128S, whose pins designate A as cosine and B as sine; the available text of the manual does not state the order",
            "Spur A eilt B bei steigendem Winkel voraus wie beim M128S, bei dem A als Kosinus und B als Sinus bezeichnet ist; im vorliegenden Text der Anleitung ist die Reihenfolge nicht angegeben",
        ),
        Assumed::ZeroOfTracks => (
            "the zero is at the peak of A, the reference mark where A and B are high in the first period: 180° wide for R (the figure permits ±90°), 90° for Z",
            "der Nullpunkt liegt im Scheitel von A, die Referenzmarke in der ersten Periode dort, wo A und B high sind: R 180° breit (die Abbildung lässt ±90° zu), Z 90°",
        ),
        Assumed::ZeroOfCommutation => (
            "the commutation signals begin at the zero of the encoder; their offset to the rotor is adjusted by the manufacturer and not stated",
            "die Kommutierungssignale beginnen im Nullpunkt des Gebers; ihr Versatz zum Rotor wird vom Hersteller eingestellt und ist nicht angegeben",
        ),
        Assumed::ZeroOfPosition => (
            "position zero is the stated angle zero; its offset to rotor and flange is determined during commissioning",
            "Position null entspricht dem angegebenen Winkel null; der Versatz zu Rotor und Flansch wird bei der Inbetriebnahme bestimmt",
        ),
        Assumed::ZeroOfOutput => (
            "motor and output encoder have the same zero; the flange turns opposite to the motor shaft (tables 58.1 and 68.1), so the output position decreases while the motor position increases",
            "Motor- und Abtriebsgeber haben denselben Nullpunkt; der Flansch dreht entgegengesetzt zur Motorwelle (Tabellen 58.1 und 68.1), die Abtriebsposition fällt also bei steigender Motorposition",
        ),
        Assumed::TimesOfEndat => (
            "calculation within 5 µs, recovery 1.25 to 3.75 µs (2.2) or 10 to 30 µs (2.1), published for the interface in general; clock assumed as 1 MHz",
            "Rechenzeit höchstens 5 µs, Totzeit 1,25 bis 3,75 µs (2.2) oder 10 bis 30 µs (2.1), veröffentlicht für die Schnittstelle allgemein; als Takt sind 1 MHz angesetzt",
        ),
        Assumed::TimesOfSsi => (
            "clock 500 kHz and monoflop time 20 µs, typical of masters of other manufacturers; the manual states neither",
            "Takt 500 kHz und Monoflopzeit 20 µs wie bei Mastern anderer Hersteller; die Anleitung nennt beides nicht",
        ),
        Assumed::Carrier => (
            "excitation at the lower end of its range, windings without phase shift; the transformation ratio may deviate by 10 %",
            "Erregung am unteren Ende ihres Bereichs, Wicklungen ohne Phasenverschiebung; das Übersetzungsverhältnis kann um 10 % abweichen",
        ),
        Assumed::Deviation => (
            "the deviation is a sum of harmonics generated from the seed within the stated accuracy; a real encoder has a different error curve",
            "die Abweichung ist eine aus dem Startwert erzeugte Summe von Oberwellen innerhalb der angegebenen Genauigkeit; ein realer Geber hat einen anderen Fehlerverlauf",
        ),
        Assumed::BatteryLost => (
            "after the failure the turns are counted from zero; the manual states only that the position is wrong",
            "nach dem Ausfall werden die Umdrehungen von null an gezählt; die Anleitung gibt nur an, dass die Position fehlerhaft ist",
        ),
    };
    pick(language, en, de)
}

/// Returns the grade of an assumption.
#[must_use]
pub const fn assumed_grade(what: Assumed) -> Grade {
    match what {
        Assumed::TimesOfEndat => Grade::Published,
        Assumed::Deviation => Grade::Estimated,
        Assumed::OrderOfTracks
        | Assumed::ZeroOfTracks
        | Assumed::ZeroOfCommutation
        | Assumed::ZeroOfPosition
        | Assumed::ZeroOfOutput
        | Assumed::TimesOfSsi
        | Assumed::Carrier
        | Assumed::BatteryLost => Grade::Assumed,
    }
}
