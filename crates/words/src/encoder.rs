//! Words about signals and words of encoders.

use crate::pick;
use crate::texts::texts;
use installation::encoder::Assumed;
use provenance::Grade;
use quantities::Language;

texts! {
    title(code) = "Encoder signals of {code}" | "Gebersignale von {code}";
    motor_feedback = "motor feedback" | "Motorfeedback";
    output_encoder = "encoder at the output (option EC)" | "Geber am Abtrieb (Option EC)";
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
    angle_from_the_shaft = "angle from where the shaft stands" | "Winkel ab Stellung der Welle";
    tracks_caption(range) =
        "{range}° of the shaft. The dashed line is where it stands; to its right is what follows clockwise."
        | "{range}° der Welle. Die gestrichelte Linie ist ihre Stellung; rechts davon folgt der Rechtslauf.";
    tracks_described(angle, range) =
        "Tracks over {range}° around the shaft angle of {angle}°."
        | "Spuren über {range}° um den Wellenwinkel {angle}°.";
    excitation = "excitation" | "Erregung";
    sine_winding = "sine winding" | "Sinuswicklung";
    cosine_winding = "cosine winding" | "Kosinuswicklung";
    carrier_caption =
        "Two periods of the excitation while the shaft turns at its speed."
        | "Zwei Perioden der Erregung bei der Drehzahl der Welle.";
    carrier_described(frequency) =
        "Voltages of the resolver at an excitation of {frequency} kHz."
        | "Spannungen des Resolvers bei einer Erregung von {frequency} kHz.";
    turn_the_shaft = "turn the shaft" | "Welle drehen";
    periods = "periods per turn" | "Perioden je Umdrehung";
    assumptions = "what the manual leaves open" | "was die Anleitung offen lässt";
    notes = "about the position" | "zur Position";
    no_words = "no serial interface: nothing is sent as a word" | "keine serielle Schnittstelle: kein Datenwort";
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
    field_crc = "check (CRC)" | "Prüfsumme (CRC)";
    decoded(bits) = "word read: {bits}" | "gelesenes Wort: {bits}";
    decoded_position(turns, angle) = "position: turn {turns}, {angle}°" | "Position: Umdrehung {turns}, {angle}°";
    word_is_right = "nothing is wrong with the word" | "das Wort ist fehlerfrei";
    ssi_has_no_check =
        "SSI sends no check: a wrong bit inside the word cannot be found"
        | "SSI überträgt keine Prüfsumme: ein falsches Bit im Wort ist nicht erkennbar";
    fault_length(found, expected) =
        "the word has {found} bits; this encoder sends {expected}"
        | "das Wort hat {found} Bit; dieser Geber sendet {expected}";
    fault_start = "the start bit is low" | "das Startbit ist low";
    fault_start_hint =
        "the word begins with the start bit; check the number of clock periods before it and the delay on the cable"
        | "das Wort beginnt mit dem Startbit; Anzahl der Taktperioden davor und Laufzeit der Leitung prüfen";
    fault_alike = "error bits F1 and F2 are alike" | "die Fehlerbits F1 und F2 sind gleich";
    fault_alike_hint =
        "F1 and F2 are inverse to each other: a bit is wrong, or the word is one of command set 2.1 with one error bit"
        | "F1 und F2 sind zueinander invers: ein Bit ist falsch, oder das Wort gehört zum Befehlssatz 2.1 mit einem Fehlerbit";
    fault_crc(found, expected) =
        "the check is {found}; that of the bits is {expected}"
        | "die Prüfsumme ist {found}; die der Bits ist {expected}";
    fault_crc_hint =
        "a bit is wrong: check screen, termination and clock frequency, and that data is read on the falling edge of the clock"
        | "ein Bit ist falsch: Schirm, Abschlusswiderstand und Taktfrequenz prüfen, und ob mit der fallenden Taktflanke gelesen wird";
    fault_command = "no mode command has these six bits" | "kein Modebefehl hat diese sechs Bit";
    fault_reported = "the encoder reports an error" | "der Geber meldet einen Fehler";
    fault_reported_hint =
        "read the error source in the operating status and reset it; the position may be wrong"
        | "Fehlerursache im Betriebszustand lesen und zurücksetzen; die Position kann falsch sein";
    no_word_to_decode = "this encoder sends no word" | "dieser Geber sendet kein Datenwort";
    no_error_to_report = "no encoder of this code reports errors in its word" | "kein Geber dieser Bestellbezeichnung meldet Fehler in seinem Wort";
    no_battery_to_lose = "no encoder of this code has a battery" | "kein Geber dieser Bestellbezeichnung hat eine Batterie";
    bits_are_0_and_1(sign, place) =
        "`{sign}` at place {place} is no bit: a word is written with 0 and 1"
        | "`{sign}` an Stelle {place} ist kein Bit: ein Wort wird mit 0 und 1 geschrieben";
    word_is_empty = "the word has no bits" | "das Wort hat keine Bits";
    word_is_too_long(most) = "a word has at most {most} bits" | "ein Wort hat höchstens {most} Bit";
    turn_is_whole(most) =
        "a turn is a whole number from -{most} to {most}"
        | "eine Umdrehung ist eine ganze Zahl von -{most} bis {most}";
    angle_is_bounded(most) =
        "an angle lies between -{most} and {most} turns"
        | "ein Winkel liegt zwischen -{most} und {most} Umdrehungen";
    speed_is_bounded(most) =
        "a speed lies between −{most} and {most} min⁻¹"
        | "eine Drehzahl liegt zwischen −{most} und {most} min⁻¹";
    window_is_bounded = "a window is larger than zero and at most 360 deg" | "ein Fenster ist größer als null und höchstens 360 deg";
    time_is_bounded(most) =
        "a trace is longer than zero and at most {most} s long"
        | "eine Aufzeichnung ist länger als null und höchstens {most} s lang";
    too_many_edges(edges, most) =
        "the trace would have about {edges} edges and may have {most}"
        | "die Aufzeichnung hätte etwa {edges} Flanken und darf {most} haben";
    too_many_edges_hint = "a shorter --time or a lower --speed" | "kürzere Angabe --time oder kleinere --speed";
    nothing_digital = "a resolver has no digital signal to write" | "ein Resolver hat kein digitales Signal zum Schreiben";
    no_output_encoder = "this code has no encoder at the output" | "diese Bestellbezeichnung hat keinen Geber am Abtrieb";
    overflow(turns, sent) =
        "turn {turns} lies outside of 0 to {sent}: the position has begun again, and the controller must count the overflows"
        | "Umdrehung {turns} liegt außerhalb von 0 bis {sent}: die Position hat neu begonnen, die Steuerung muss die Überläufe zählen";
    battery_lost =
        "battery and supply failed together: the position sent is wrong, and nothing in the word shows it; reference the axis before it moves"
        | "Batterie und Versorgung sind zugleich ausgefallen: die gemeldete Position ist falsch, und im Wort zeigt es nichts; die Achse vor jeder Bewegung neu referenzieren";
    incremental_only =
        "the position is lost with the supply: after switching on the axis is referenced"
        | "die Position geht mit der Versorgung verloren: nach dem Einschalten wird die Achse referenziert";
}

/// What is assumed, and what it rests on.
#[must_use]
pub const fn assumed(what: Assumed, language: Language) -> &'static str {
    let (en, de) = match what {
        Assumed::OrderOfTracks => (
            "track A leads B while the angle rises, as on M128S, whose pins name A cosine and B sine; the manual prints no order in the text that is kept",
            "Spur A eilt B bei steigendem Winkel voraus wie beim M128S, dessen Stifte A Kosinus und B Sinus nennen; die Reihenfolge steht nicht im erhaltenen Text der Anleitung",
        ),
        Assumed::ZeroOfTracks => (
            "the zero lies at the peak of A, and the mark where A and B are high, in the first period: 180° wide for R (the figure allows ±90°), 90° for Z",
            "der Nullpunkt liegt im Scheitel von A, die Marke dort, wo A und B high sind, in der ersten Periode: R 180° breit (die Abbildung lässt ±90° zu), Z 90°",
        ),
        Assumed::ZeroOfCommutation => (
            "the commutation signals begin at the zero of the encoder; their place against the rotor is adjusted by the maker and not printed",
            "die Kommutierungssignale beginnen im Nullpunkt des Gebers; ihre Lage zum Rotor stellt der Hersteller ein, sie ist nicht abgedruckt",
        ),
        Assumed::ZeroOfPosition => (
            "the position zero is the stated angle zero; where it lies against rotor and flange is found by commissioning",
            "die Position null ist der angegebene Winkel null; ihre Lage zu Rotor und Flansch ergibt die Inbetriebnahme",
        ),
        Assumed::ZeroOfOutput => (
            "motor and output encoder are zero together; the flange turns against the motor shaft (tables 58.1 and 68.1), so the output position falls while that of the motor rises",
            "Motor- und Abtriebsgeber sind gemeinsam null; der Flansch dreht gegen die Motorwelle (Tabellen 58.1 und 68.1), die Position am Abtrieb fällt also, während die des Motors steigt",
        ),
        Assumed::TimesOfEndat => (
            "calculation within 5 µs, recovery 1.25 to 3.75 µs (2.2) or 10 to 30 µs (2.1), published for the interface in general; 1 MHz is taken for the clock",
            "Rechenzeit höchstens 5 µs, Totzeit 1,25 bis 3,75 µs (2.2) oder 10 bis 30 µs (2.1), veröffentlicht für die Schnittstelle allgemein; als Takt sind 1 MHz angesetzt",
        ),
        Assumed::TimesOfSsi => (
            "clock 500 kHz and a monoflop time of 20 µs, as masters of other makers wait; the manual prints neither",
            "Takt 500 kHz und Monoflopzeit 20 µs, wie Master anderer Hersteller warten; die Anleitung nennt beides nicht",
        ),
        Assumed::Carrier => (
            "excitation at the lower end of its range, and windings without phase shift; the transformation ratio may be 10 % off",
            "Erregung am unteren Ende ihres Bereichs, Wicklungen ohne Phasenverschiebung; das Übersetzungsverhältnis kann um 10 % abweichen",
        ),
        Assumed::Deviation => (
            "the deviation is a seeded sum of harmonics within the printed accuracy; the course of a real encoder is another",
            "die Abweichung ist eine Summe von Oberwellen aus einem Startwert innerhalb der abgedruckten Genauigkeit; ein wirklicher Geber hat einen anderen Verlauf",
        ),
        Assumed::BatteryLost => (
            "after the loss the turns count from zero; the manual says only that the position is wrong",
            "nach dem Ausfall zählen die Umdrehungen von null an; die Anleitung sagt nur, dass die Position fehlerhaft ist",
        ),
    };
    pick(language, en, de)
}

/// How far an assumption can be trusted.
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
