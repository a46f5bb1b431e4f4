//! Symbols of derivations, and what was searched or integrated.

use crate::{pick, unpadded};
use quantities::Language;
use sizing::derivation::{Finding, Formula};

/// Greek letters by the names that symbols write.
const GREEK: [(&str, &str); 14] = [
    ("alpha", "α"),
    ("beta", "β"),
    ("dtheta", "Δϑ"),
    ("eta", "η"),
    ("gamma", "γ"),
    ("kappa", "κ"),
    ("mu", "µ"),
    ("omega", "ω"),
    ("phi", "φ"),
    ("psi", "ψ"),
    ("rho", "ρ"),
    ("sigma", "σ"),
    ("tau", "τ"),
    ("theta", "ϑ"),
];

/// Figures that the tables name in words, by the symbol that stands for them in a formula.
const LONG: [(&str, &str); 12] = [
    ("accuracy", "φ_acc"),
    ("accuracy_out", "φ_acc,out"),
    ("approvals", "N_appr"),
    ("approvals_needed", "N_appr,req"),
    ("dU", "ΔU"),
    ("hysteresis_loss", "φ_hys"),
    ("lost_motion", "φ_lm"),
    ("repeatability", "φ_rep"),
    ("resolution", "φ_res"),
    ("resolution_out", "φ_res,out"),
    ("transmission_accuracy", "φ_tr"),
    ("transformation_ratio", "k_res"),
];

/// A symbol as people write it: `omega_1` is ω_1.
#[must_use]
pub fn symbol_shown(symbol: &str) -> String {
    if let Some((_, shown)) = LONG.iter().find(|(name, _)| *name == symbol) {
        return (*shown).to_owned();
    }
    let (head, tail) = symbol.split_once('_').map_or((symbol, None), |(head, tail)| (head, Some(tail)));
    let head = GREEK.iter().find(|(name, _)| *name == head).map_or(head, |(_, letter)| letter);
    tail.map_or_else(|| head.to_owned(), |tail| format!("{head}_{tail}"))
}

/// Returns what was searched or integrated as text: the formula, if it has one, and the condition.
#[must_use]
pub fn found_text(what: Finding, language: Language) -> String {
    let condition = found_condition(what, language);
    match what.formula().and_then(|text| Formula::parse(text).ok()) {
        Some(formula) => {
            format!("{} {condition}", formula.shown(&symbol_shown, &|number| unpadded(number, 6, language)))
        }
        None => condition,
    }
}

/// Returns where or under which condition the formula of a search or an integral holds, or its whole text if it has no
/// formula.
#[must_use]
pub fn found_condition(what: Finding, language: Language) -> String {
    let (en, de) = match what {
        Finding::AccelerationAt => ("acceleration at t", "Beschleunigung bei t"),
        Finding::PeakSpeed
        | Finding::PeakLoad
        | Finding::AngleTravelled
        | Finding::AccelerationRms
        | Finding::LoadRms
        | Finding::Correlation
        | Finding::EffectiveCurrent
        | Finding::CubicMeanTorque
        | Finding::RadialMeanOverCycle
        | Finding::AxialMeanOverCycle
        | Finding::MomentMeanOverCycle => ("over the cycle", "im Zyklus"),
        Finding::RadialMean | Finding::AxialMean | Finding::RadialMomentMean | Finding::AxialMomentMean => {
            ("over the segments", "über die Abschnitte")
        }
        Finding::FrictionOfColdGear => ("(gear at ambient temperature)", "(Getriebe auf Umgebungstemperatur)"),
        Finding::LeastTension => (
            "of what the rope bears, at the instant nearest to slack",
            "der Last am Seil zum Zeitpunkt, der dem Schlaffwerden am nächsten ist",
        ),
        Finding::TorqueOfLoadAt => ("load torque at t", "Lastmoment bei t"),
        Finding::PositionAt => ("position at t", "Position bei t"),
        Finding::AngleOfMassAt => (
            "angle of the centre of mass above the horizontal at t",
            "Winkel des Schwerpunkts über der Waagerechten bei t",
        ),
        Finding::FlangeForcesAt => (
            "by the law of the mechanism for its forces on the flange at t",
            "nach dem Kraftgesetz der Mechanik am Flansch bei t",
        ),
        Finding::RecordedTorqueAt => ("recorded torque at t", "aufgezeichnetes Drehmoment bei t"),
        Finding::SumOfBodies => {
            ("sum of the bodies, by Steiner's theorem", "Summe der Körper nach dem Satz von Steiner")
        }
        Finding::TableAt => (
            "from the table at q, straight between its points",
            "aus der Tabelle bei q, zwischen den Punkten geradlinig",
        ),
        Finding::SpeedsOfFalls => (
            "sum of the squared speeds of the z_f falls relative to the load: z_f, z_f − 2, z_f − 2, z_f − 4, …",
            "Summe der Geschwindigkeitsquadrate der z_f Seilstränge bezogen auf die Last: z_f, z_f − 2, z_f − 2, z_f − 4, …",
        ),
        Finding::LinkageInertia => (
            "from the closed loop of the linkage at q and its derivatives",
            "aus dem Schleifenschluss des Koppelgetriebes bei q und seinen Ableitungen",
        ),
        Finding::LinkageTorque => (
            "weights of coupler and rocker and torque on the rocker, times their rates over q",
            "Gewichtskräfte von Koppel und Schwinge und Moment an der Schwinge, mal ihren Ableitungen nach q",
        ),
        Finding::RopesThroughSheaves => (
            "torque of the ropes with the losses of the sheaves less that without them",
            "Moment der Seile mit Rollenverlusten abzüglich des Moments ohne Verluste",
        ),
        Finding::SpeedAt => ("speed at t", "Drehzahl bei t"),
        Finding::DirectionAt => ("direction at t", "Richtung bei t"),
        Finding::PeakHoldingTorque => (
            "max |holding torque of the load without friction| over the cycle",
            "max |Haltemoment der Last ohne Reibung| im Zyklus",
        ),
        Finding::DrivingTorque => ("largest driving torque of the load", "größtes treibendes Moment der Last"),
        Finding::Travel => {
            ("largest minus smallest position over the cycle", "größte minus kleinste Position im Zyklus")
        }
        Finding::LargestInertia => ("largest along the path", "größtes längs des Wegs"),
        Finding::LeastInertia => ("smallest along the path", "kleinstes längs des Wegs"),
        Finding::LargestInertiaHeld => {
            ("largest during the constant speed from t on", "größtes bei konstanter Drehzahl ab t")
        }
        Finding::LeastInertiaHeld => {
            ("smallest during the constant speed from t on", "kleinstes bei konstanter Drehzahl ab t")
        }
        Finding::SpeedNearResonance => (
            "constant speed from t on that is nearest to a resonance",
            "konstante Drehzahl ab t, die einer Resonanz am nächsten liegt",
        ),
        Finding::ContinuousCurve => ("continuous curve at n_av", "Dauerkennlinie bei n_av"),
        Finding::ShortTimeCurve => ("short-time curve at n, at most T_max", "Kurzzeitkennlinie bei n, höchstens T_max"),
        Finding::SpeedBeyondCurve => ("n is above n_end", "n liegt über n_end"),
        Finding::EdgeOfBand => ("edge of the band at n", "Rand des Bandes bei n"),
        Finding::LowerEdgeOfBand => ("lower edge of the band at n_av", "unterer Rand des Bandes bei n_av"),
        Finding::MeanSpeedUpToRated => ("n_av, at most n_N_out", "n_av, höchstens n_N_out"),
        Finding::GearAsHousing => {
            ("gear temperature, equal to the housing temperature", "Getriebetemperatur gleich Gehäusetemperatur")
        }
        Finding::CurrentWithinVoltage => ("largest current at n within U_M", "größter Strom bei n innerhalb U_M"),
        Finding::GearCold => (
            "gear at ambient temperature: the less favourable of both states",
            "Getriebe auf Umgebungstemperatur: der ungünstigere der beiden Zustände",
        ),
        Finding::GearSettled => (
            "gear in thermal steady state: the less favourable of both states",
            "Getriebe im thermischen Beharrungszustand: der ungünstigere der beiden Zustände",
        ),
        Finding::StateCold => ("gear at ambient temperature", "Getriebe auf Umgebungstemperatur"),
        Finding::StateSettled => ("gear in thermal steady state", "Getriebe im thermischen Beharrungszustand"),
        Finding::StateWarmest => (
            "highest temperature of the table, without a heat model",
            "höchste Temperatur der Tabelle, ohne Erwärmungsmodell",
        ),
        Finding::LawOfFriction => ("friction law at theta_g", "Reibungsgesetz bei theta_g"),
        Finding::TimeAboveContinuous => {
            ("longest time over the cycle with |I| above I_D", "längste Zeit im Zyklus mit |I| über I_D")
        }
        Finding::CurrentOfCurve => (
            "current of the published short-time curve at n, at least I_max",
            "Strom der veröffentlichten Kurzzeitkennlinie bei n, mindestens I_max",
        ),
        Finding::CopperLoss => {
            ("mean of 1.5 R_hot I² over the cycle, I with K", "Mittelwert von 1,5 R_hot I² im Zyklus, I mit K")
        }
        Finding::FrictionLoss => (
            "mean of (I_NLS + K |n|) k_TM ω_mot over the cycle, plus the coil of an open brake",
            "Mittelwert von (I_NLS + K |n|) k_TM ω_mot im Zyklus, zuzüglich Spule einer geöffneten Bremse",
        ),
        Finding::WindingRise => (
            "largest temperature rise of the winding above its mean in the steady-state cycle",
            "größte Erwärmung der Wicklung über ihren Mittelwert im eingeschwungenen Zyklus",
        ),
        Finding::CurvesOverModel => (
            "ratio of published curves to the model at this duty; 1 where none is published",
            "veröffentlichte Kennlinien bezogen auf das Modell bei dieser Betriebsart; 1, wo keine veröffentlicht ist",
        ),
        Finding::OverloadLag => (
            "maximum of (I/I_0)² filtered by a first-order lag with τ_w in the steady-state cycle",
            "Maximum von (I/I_0)² nach Verzögerungsglied erster Ordnung mit τ_w im eingeschwungenen Zyklus",
        ),
        Finding::OverloadPermitted => (
            "(I/I_0)² permitted by the continuous curve at n_av, at least 1",
            "(I/I_0)² nach der Dauerkennlinie bei n_av, mindestens 1",
        ),
        Finding::EnergyReturned => (
            "−∫ P dt for P = 1.5 R_LL I² + k_TM I ω_mot < 0, over the cycle",
            "−∫ P dt für P = 1,5 R_LL I² + k_TM I ω_mot < 0, im Zyklus",
        ),
        Finding::AxialForceMax => ("max F_a over the segments in motion", "max F_a über die Abschnitte mit Bewegung"),
        Finding::RadialForceMax => ("max F_r over the segments in motion", "max F_r über die Abschnitte mit Bewegung"),
        Finding::LargestOverSegments => ("largest over the segments", "größte über die Abschnitte"),
        Finding::LargestOfMechanism => (
            "largest over the cycle, from mechanism and stated loads",
            "größte im Zyklus, aus Mechanik und angegebenen Lasten",
        ),
        Finding::LargestInMotion => (
            "largest while the gear turns, stated loads included",
            "größter Wert bei drehendem Getriebe, einschließlich angegebener Lasten",
        ),
        Finding::LargestAtRest => (
            "largest while the gear rests, stated loads included",
            "größter Wert bei stehendem Getriebe, einschließlich angegebener Lasten",
        ),
        Finding::TensionOfWeight => ("weight on the rope at that instant", "Gewicht am Seil zu diesem Zeitpunkt"),
        Finding::SegmentOfLargestMoment => ("in the segment of the largest M", "im Abschnitt mit dem größten M"),
        Finding::EverySegmentInMotion => ("in every segment in motion", "in jedem Abschnitt mit Bewegung"),
        Finding::TiltBehindStage => (
            "tilting of the flange does not rotate the parts behind the stage",
            "ein Kippen des Flansches verdreht die Teile hinter der Stufe nicht",
        ),
        Finding::NotKnown => ("not known: set to 0", "nicht bekannt: mit 0 angesetzt"),
        Finding::Brakings => ("dwells per cycle held by the brake", "Stillstände je Zyklus, bei denen die Bremse hält"),
        Finding::BatteryLife => ("life at t_op per day after t_store", "Lebensdauer bei t_op je Tag nach t_store"),
    };
    with_shown_symbols(pick(language, en, de))
}

/// The symbols among the words of a text as people write them: `theta_g` is ϑ_g.
fn with_shown_symbols(text: &str) -> String {
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let mut shown = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(from) = rest.find(is_part) {
        let (before, tail) = rest.split_at(from);
        let (word, after) = tail.split_at(tail.find(|c| !is_part(c)).unwrap_or(tail.len()));
        shown.push_str(before);
        if word.contains('_') {
            shown.push_str(&symbol_shown(word))
        } else {
            shown.push_str(word)
        }
        rest = after;
    }
    shown.push_str(rest);
    shown
}

/// Symbols that mean something else in another unit: symbol, unit, English, German. They go before those below.
const BY_UNIT: &[(&str, &str, &str, &str)] = &[
    ("P_0", "W", "permissible loss at standstill", "im Stillstand zulässige Verlustleistung"),
    ("P_0", "N", "static equivalent load", "statische Äquivalentlast"),
    ("S", "N", "tension of the rope", "Seilkraft"),
    ("phi", "arcmin", "torsion angle of the gear", "Torsionswinkel des Getriebes"),
    ("phi", "rad", "angle travelled over the cycle", "im Zyklus zurückgelegter Winkel"),
    ("phi", "rev", "travel from the smallest to the largest position", "Weg von der kleinsten zur größten Position"),
    ("b", "Nms/rad", "viscous friction", "geschwindigkeitsproportionale Reibung"),
    ("gamma", "rad", "inclination", "Neigung"),
    ("L_f", "m", "length of each fall at position zero", "Länge jedes Seilstrangs in Position null"),
    ("m", "kg", "mass", "Masse"),
    ("phi_0", "rad", "angle of the centre of mass at position zero", "Winkel des Schwerpunkts in Position null"),
    ("rho", "kg/m^3", "density of the wound material", "Dichte des Wickelguts"),
    ("tau", "Nm", "recorded torque", "aufgezeichnetes Drehmoment"),
    ("theta_0", "rad", "arm angle at position zero", "Winkel der Scherenarme in Position null"),
    ("resolution", "arcsec", "resolution of the encoder at the motor", "Auflösung des Gebers am Motor"),
    ("R", "ohm", "resistance of a phase, hot", "Strangwiderstand, warm"),
];

/// Symbols of derivations that are no printed cell: English, German.
const TERMS: &[(&str, &str, &str)] = &[
    ("F_as", "stated axial force", "angegebene Axialkraft"),
    ("F_l", "force along the line", "Kraft in Verfahrrichtung"),
    ("F_n", "radial forces without a stated direction", "Radialkräfte ohne angegebene Richtung"),
    ("F_rs", "stated radial force", "angegebene Radialkraft"),
    ("F_v", "radial force with direction", "Radialkraft mit Richtung"),
    ("F_x", "horizontal force in the plane of the flange", "waagerechte Kraft in der Flanschebene"),
    (
        "F_y",
        "force in the plane of the flange, steepest upwards",
        "Kraft in der Flanschebene, steilste Richtung aufwärts",
    ),
    ("F_y1", "force F_y of the mechanism", "Kraft F_y der Mechanik"),
    ("F_y2", "force F_y of the payload", "Kraft F_y der Nutzlast"),
    ("F_x1", "force F_x of the mechanism", "Kraft F_x der Mechanik"),
    ("F_x2", "force F_x of the payload", "Kraft F_x der Nutzlast"),
    ("F_z", "force along the axis", "Kraft in Achsrichtung"),
    ("F_zn", "axial forces without a stated direction", "Axialkräfte ohne angegebene Richtung"),
    ("L_0", "distance of the centre of mass from the flange", "Abstand des Schwerpunkts vom Flansch"),
    ("L_p", "distance of the payload from the flange", "Abstand der Nutzlast vom Flansch"),
    ("M_n", "moments without a stated direction", "Momente ohne angegebene Richtung"),
    ("M_s", "moment of the stated forces", "Moment der angegebenen Kräfte"),
    ("F_m", "force of the mechanism", "Kraft der Mechanik"),
    ("M_m", "tilting moment of the mechanism", "Kippmoment der Mechanik"),
    ("M_v", "tilting moment of the forces with direction", "Kippmoment der Kräfte mit Richtung"),
    ("M_x", "tilting moment about the horizontal direction", "Kippmoment um die waagerechte Richtung"),
    ("M_y", "tilting moment about the steepest direction", "Kippmoment um die steilste Richtung"),
    ("q_m", "angle of the centre of mass", "Winkel des Schwerpunkts"),
    ("w_F", "share of the forces borne by the flange", "Kraftanteil des Flanschs"),
    ("alpha_2", "angular acceleration of the mechanism", "Winkelbeschleunigung der Mechanik"),
    ("b_s", "distance of the lower pins", "Abstand der unteren Bolzen"),
    ("b_w", "width of the web", "Breite der Bahn"),
    ("beta", "tilt of the axis from the vertical", "Neigung der Achse gegen die Senkrechte"),
    ("D", "diameter", "Durchmesser"),
    ("D_0", "diameter of the roll at position zero", "Wickeldurchmesser in Position null"),
    ("D_f", "diameter of the full roll", "Durchmesser des vollen Wickels"),
    ("D_k", "diameter of the core", "Durchmesser des Wickelkerns"),
    ("eta_1", "efficiency while driving", "Wirkungsgrad beim Antreiben"),
    ("eta_2", "efficiency while driven", "Wirkungsgrad bei treibender Last"),
    ("eta_F", "efficiency of the reeving", "Wirkungsgrad der Seileinscherung"),
    ("eta_s1", "efficiency of the stage while driving", "Wirkungsgrad der Stufe beim Antreiben"),
    ("eta_s2", "efficiency of the stage while driven", "Wirkungsgrad der Stufe bei treibender Last"),
    ("F_f", "friction force of guide and seals", "Reibkraft von Führung und Dichtungen"),
    ("F_p", "process force", "Prozesskraft"),
    ("F_w", "tension of the web", "Bahnzug"),
    ("h_1", "rise of the platform per angle", "Hub der Plattform je Winkel"),
    ("h_2", "change of h_1 with the position", "Änderung von h_1 mit der Position"),
    ("J_0", "moment of inertia of the rotating parts", "Massenträgheitsmoment der drehenden Teile"),
    (
        "J_1",
        "moment of inertia of the stage on the side of the actuator",
        "Massenträgheitsmoment der Stufe antriebsseitig",
    ),
    (
        "J_2",
        "moment of inertia of the stage on the side of the mechanism",
        "Massenträgheitsmoment der Stufe lastseitig",
    ),
    (
        "J_c2",
        "moment of inertia of the coupler about its centre",
        "Massenträgheitsmoment der Koppel um ihren Schwerpunkt",
    ),
    ("J_c3", "moment of inertia of the rocker about its pivot", "Massenträgheitsmoment der Schwinge um ihr Lager"),
    ("J_M", "moment of inertia of the mechanism", "Massenträgheitsmoment der Mechanik"),
    ("J_p", "moment of inertia of the payload", "Massenträgheitsmoment der Nutzlast"),
    ("J_q", "change of the moment of inertia per angle", "Änderung des Massenträgheitsmoments je Winkel"),
    ("k", "travel per angle", "Verfahrweg je Winkel"),
    ("l", "length of the rod", "Pleuellänge"),
    ("l_1", "length of the crank", "Länge der Kurbel"),
    ("l_2", "length of the coupler", "Länge der Koppel"),
    ("l_3", "length of the rocker", "Länge der Schwinge"),
    ("l_g", "length of the fixed link", "Länge des Gestells"),
    ("L_s", "length of an arm", "Länge eines Scherenarms"),
    ("m_2", "mass of the coupler", "Masse der Koppel"),
    ("m_3", "mass of the rocker", "Masse der Schwinge"),
    ("m_a", "mass of all arms", "Masse aller Scherenarme"),
    ("m_c", "mass of the counterweight", "Masse des Gegengewichts"),
    ("m_p", "mass of the payload", "Masse der Nutzlast"),
    ("m_r", "mass of all falls of the rope", "Masse aller Seilstränge"),
    ("mu", "friction coefficient of the guide", "Reibungszahl der Führung"),
    ("omega", "angular speed", "Winkelgeschwindigkeit"),
    ("omega_2", "angular speed of the mechanism", "Winkelgeschwindigkeit der Mechanik"),
    ("P_h", "lead", "Spindelsteigung"),
    ("q", "position of the mechanism", "Position der Mechanik"),
    ("r_0", "distance of the centre of mass from the axis", "Abstand des Schwerpunkts von der Achse"),
    ("r_c", "crank radius", "Kurbelradius"),
    ("r_p", "distance of the payload from the axis", "Abstand der Nutzlast von der Achse"),
    ("r_w", "radius of the roll", "Wickelradius"),
    ("s_2", "distance of the coupler's centre from the crank pin", "Abstand des Koppelschwerpunkts vom Kurbelzapfen"),
    ("s_3", "distance of the rocker's centre from its pivot", "Abstand des Schwingenschwerpunkts von ihrem Lager"),
    ("S_u", "squared speeds of the falls", "Geschwindigkeitsquadrate der Seilstränge"),
    ("s_w", "thickness of the web", "Dicke der Bahn"),
    ("T_e", "external torque", "äußeres Moment"),
    ("T_g", "friction of the guide at the output", "Reibung der Führung am Abtrieb"),
    ("T_h", "torque of gravity and forces", "Moment aus Schwerkraft und Kräften"),
    ("T_M", "torque required by the mechanism", "von der Mechanik gefordertes Moment"),
    ("T_p", "process torque", "Prozessmoment"),
    ("T_r", "losses of the sheaves", "Verluste der Seilrollen"),
    ("T_r3", "torque on the rocker", "Moment an der Schwinge"),
    ("T_u", "torque before losses and friction", "Moment ohne Verluste und Reibung"),
    ("T_w", "torque without the losses of the sheaves", "Moment ohne Verluste der Seilrollen"),
    ("T_x", "torques that do not depend on the motion", "von der Bewegung unabhängige Momente"),
    ("w_s", "height of a stage", "Höhe einer Stufe"),
    ("x_1", "travel of the slider per angle", "Verfahrweg des Schiebers je Winkel"),
    ("x_2", "change of x_1 with the position", "Änderung von x_1 mit der Position"),
    ("z_f", "number of falls", "Anzahl der Seilstränge"),
    ("z_s", "number of stages", "Anzahl der Stufen"),
    ("accuracy_out", "accuracy of the encoder at the output", "Genauigkeit des Gebers am Abtrieb"),
    ("a_shock", "shock", "Schock"),
    ("a_shock_max", "shock resistance", "Schockfestigkeit"),
    ("a_vib", "vibration", "Vibration"),
    ("a_vib_max", "vibration resistance", "Vibrationsbeständigkeit"),
    ("approvals", "existing approvals", "vorliegende Freigaben"),
    ("approvals_needed", "approvals required", "erforderliche Freigaben"),
    ("d", "distance from the nearest resonance speed", "Abstand zur nächsten Resonanzdrehzahl"),
    ("d_min", "recommended distance", "empfohlener Abstand"),
    ("f", "first natural frequency", "erste Eigenfrequenz"),
    ("F_aav", "mean axial force", "mittlere Axialkraft"),
    ("f_min", "required natural frequency", "geforderte Eigenfrequenz"),
    ("F_rav", "mean radial force", "mittlere Radialkraft"),
    ("f_high", "natural frequency at the smallest inertia", "Eigenfrequenz beim kleinsten Massenträgheitsmoment"),
    ("f_s", "static safety", "statische Sicherheit"),
    ("f_s_min", "required static safety", "geforderte statische Sicherheit"),
    ("gamma", "tilt of the flange", "Kippwinkel des Flansches"),
    ("gamma_max", "permissible tilt", "zulässiger Kippwinkel"),
    ("i_s", "ratio of the stage", "Übersetzung der Stufe"),
    ("I_D", "continuous current of the drive", "Dauerstrom des Servoreglers"),
    ("I_D_max", "peak current of the drive", "Spitzenstrom des Servoreglers"),
    ("I_rms", "rms motor current", "effektiver Motorstrom"),
    ("K_1", "torsional stiffness below T_1", "Torsionssteifigkeit unter T_1"),
    ("K_2", "torsional stiffness between T_1 and T_2", "Torsionssteifigkeit zwischen T_1 und T_2"),
    ("K_3", "torsional stiffness above T_2", "Torsionssteifigkeit über T_2"),
    ("K_s", "torsional stiffness of the stage", "Torsionssteifigkeit der Stufe"),
    ("L_10", "L10 life", "L10-Lebensdauer"),
    ("L_10_min", "required life", "geforderte Lebensdauer"),
    ("L_50", "L50 life (median)", "L50-Lebensdauer (Median)"),
    ("M", "tilting moment", "Kippmoment"),
    ("M_a", "moment of the axial force", "Moment der Axialkraft"),
    ("M_eq", "static equivalent tilting moment", "statisch äquivalentes Kippmoment"),
    ("M_L", "mean tilting moment of the mechanism", "mittleres Kippmoment der Mechanik"),
    ("M_r", "moment of the radial force", "Moment der Radialkraft"),
    ("n_end", "largest output speed", "größte Abtriebsdrehzahl"),
    ("n_in", "mean input speed", "mittlere Eingangsdrehzahl"),
    ("N_k", "permissible number of collisions", "zulässige Anzahl der Kollisionen"),
    ("n_r", "resonance speed", "Resonanzdrehzahl"),
    ("n_r_high", "resonance speed at the smallest inertia", "Resonanzdrehzahl beim kleinsten Massenträgheitsmoment"),
    ("P_c", "dynamic equivalent load", "dynamische Äquivalentlast"),
    ("phi_max", "permissible torsion angle", "zulässiger Torsionswinkel"),
    ("phi_perm", "permissible angle", "zulässiger Winkel"),
    ("phi_b", "backlash of the stage", "Spiel der Stufe"),
    ("phi_L", "torsion angle at the mechanism", "Torsionswinkel an der Mechanik"),
    (
        "phi_out",
        "sum of the angular errors at the output of the actuator",
        "Summe der Winkelfehler am Abtrieb des Antriebs",
    ),
    ("phi_sum", "sum of the angular errors", "Summe der Winkelfehler"),
    ("phi_sum_max", "permissible sum of the errors", "zulässige Summe der Fehler"),
    ("r", "lever arm", "Hebelarm"),
    ("resolution_out", "resolution at the output", "Auflösung am Abtrieb"),
    ("s", "deviation at the lever arm", "Abweichung am Hebelarm"),
    ("S_off", "unloading of the rope", "Entlastung des Seils"),
    ("S_w", "weight on the rope", "Gewichtskraft am Seil"),
    ("H", "installation altitude", "Aufstellhöhe"),
    ("H_max", "permissible installation altitude", "zulässige Aufstellhöhe"),
    ("IP", "required degree of protection", "geforderte Schutzart"),
    ("IP_max", "degree of protection", "Schutzart"),
    ("k_H", "derating at the altitude", "Minderung durch die Aufstellhöhe"),
    ("rH", "relative humidity", "relative Luftfeuchte"),
    ("rH_limit", "nearest limit of the permissible range", "nächste Grenze des zulässigen Bereichs"),
    ("T_der", "derated continuous torque", "gemindertes Dauerdrehmoment"),
    ("s_max", "permissible deviation", "zulässige Abweichung"),
    ("s_perm", "permissible step", "zulässiger Schritt"),
    ("T_av", "cubic mean torque", "kubisch gemitteltes Moment"),
    ("T_Br", "holding torque of the brake", "Haltemoment der Bremse"),
    ("T_c", "friction torque", "Reibmoment"),
    ("T_k", "collision torque", "Kollisionsmoment"),
    ("t_k", "duration of a collision", "Dauer einer Kollision"),
    ("t_op", "operation per day", "Betrieb je Tag"),
    ("t_store", "storage", "Lagerung"),
    ("theta_limit", "nearest limit of the permissible range", "nächste Grenze des zulässigen Bereichs"),
    ("alpha", "angular acceleration", "Winkelbeschleunigung"),
    ("alpha_rms", "rms acceleration", "effektive Beschleunigung"),
    ("dtheta", "temperature swing of the winding", "Temperaturschwankung der Wicklung"),
    ("dU", "rise of the DC link voltage", "Anstieg der Zwischenkreisspannung"),
    ("b", "edge of the estimation band", "Rand des Schätzbands"),
    ("c", "factor between model and published curves", "Faktor zwischen Modell und veröffentlichten Kennlinien"),
    ("I_p", "no-load starting current of the table", "lastfreier Anlaufstrom nach Tabelle"),
    ("I_perm", "permissible current", "zulässiger Strom"),
    ("I_s", "starting current used", "angesetzter Anlaufstrom"),
    ("K", "no-load current constant at this point", "Leerlaufstromkonstante in diesem Betriebspunkt"),
    (
        "K_cold",
        "no-load current constant of the cold gear (table)",
        "Leerlaufstromkonstante des kalten Getriebes (Tabelle)",
    ),
    (
        "K_warm",
        "no-load current constant of the warm gear (table)",
        "Leerlaufstromkonstante des warmen Getriebes (Tabelle)",
    ),
    ("theta_cold", "lower temperature of the table", "niedrigere Temperatur der Tabelle"),
    ("theta_warm", "higher temperature of the table", "höhere Temperatur der Tabelle"),
    ("theta_p", "lowest temperature with stated friction", "niedrigste Temperatur mit Reibungsangabe"),
    ("P_cu", "copper loss", "Kupferverluste"),
    ("theta_g", "temperature of the gear", "Temperatur des Getriebes"),
    ("theta_h", "temperature of the housing", "Temperatur des Gehäuses"),
    ("theta_max", "highest winding temperature", "höchste Wicklungstemperatur"),
    ("theta_perm", "temperature permissible in any case", "sicher zulässige Temperatur"),
    ("y_perm", "permissible value of (I/I_0)², filtered with τ_w", "zulässiger Wert von (I/I_0)², gefiltert mit τ_w"),
    ("E_reg", "regenerated energy per cycle", "Rückspeiseenergie je Zyklus"),
    ("F", "permissible loss relative to the loss at I_0", "zulässige Verlustleistung bezogen auf die bei I_0"),
    ("F_a", "axial force", "Axialkraft"),
    ("F_r", "radial force", "Radialkraft"),
    ("f_w", "load factor", "Betriebsfaktor"),
    ("I", "motor current", "Motorstrom"),
    ("I_f", "friction current", "Reibungsstrom"),
    ("I_cold", "current with a cold gear", "Strom bei kaltem Getriebe"),
    ("I_warm", "current with a warm gear", "Strom bei betriebswarmem Getriebe"),
    ("I_peak", "peak current", "Spitzenstrom"),
    ("I_th", "current at the permissible loss", "Strom bei zulässiger Verlustleistung"),
    ("I_U", "current at the voltage limit", "Strom an der Spannungsgrenze"),
    ("i_q", "torque-producing current, peak of a phase", "drehmomentbildender Strom, Scheitelwert eines Strangs"),
    ("J", "moment of inertia of load and actuator", "Massenträgheitsmoment von Last und Antrieb"),
    ("J_out", "moment of inertia of the actuator at the output", "Massenträgheitsmoment des Antriebs am Abtrieb"),
    ("J_L", "moment of inertia of the load", "Massenträgheitsmoment der Last"),
    ("J_L_min", "smallest moment of inertia of the load", "kleinstes Massenträgheitsmoment der Last"),
    ("J_L_rec", "recommended for high dynamics", "empfohlen für hohe Dynamik"),
    ("k_J", "recommended inertia ratio", "empfohlenes Trägheitsverhältnis"),
    ("L", "inductance of a phase", "Stranginduktivität"),
    ("L_a", "distance of the axial force from the axis", "Abstand der Axialkraft von der Drehachse"),
    ("L_asked", "required life", "geforderte Lebensdauer"),
    ("L_bat", "life of the battery", "Lebensdauer der Batterie"),
    ("L_r", "distance of the radial force from the flange", "Abstand der Radialkraft vom Flansch"),
    ("m", "modulation reserve", "Modulationsreserve"),
    ("n", "output speed", "Abtriebsdrehzahl"),
    ("n_2", "running speed", "Drehzahl der Konstantfahrt"),
    ("n_av", "mean output speed", "mittlere Abtriebsdrehzahl"),
    ("n_max", "largest output speed", "größte Abtriebsdrehzahl"),
    ("n_N_out", "rated motor speed at the output", "Bemessungsdrehzahl am Abtrieb"),
    ("n_peak", "peak output speed", "Spitzendrehzahl am Abtrieb"),
    ("N", "absolute turns of the encoder", "absolute Umdrehungen des Gebers"),
    ("N_life", "brake applications over the service life", "Bremsungen über die Betriebszeit"),
    ("N_out", "absolute range at the output", "absoluter Bereich am Abtrieb"),
    ("N_stops", "emergency stops required", "geforderte Not-Halte"),
    ("omega_1", "speed at which the brake engages", "Drehzahl beim Einfallen der Bremse"),
    ("omega_e", "electrical angular frequency", "elektrische Kreisfrequenz"),
    ("P_f", "friction loss", "Reibungsverluste"),
    ("P_perm", "permissible regenerative power", "zulässige Rückspeiseleistung"),
    ("P_reg", "mean regenerative power", "mittlere Rückspeiseleistung"),
    ("phi_stop", "stopping angle with the brake alone", "Anhalteweg mit der Bremse allein"),
    ("psi", "flux linkage, peak of a phase", "Flussverkettung, Scheitelwert eines Strangs"),
    ("R_hot", "resistance at the warning threshold", "Widerstand an der Warnschwelle"),
    ("rho", "correlation of acceleration and load torque", "Korrelation von Beschleunigung und Lastmoment"),
    ("S", "holding safety", "Haltesicherheit"),
    ("s_mot", "step at the motor", "Schritt am Motor"),
    ("s_out", "step at the output", "Schritt am Abtrieb"),
    ("sigma", "direction of motion", "Bewegungsrichtung"),
    ("t", "instant", "Zeitpunkt"),
    ("T", "torque at the output", "Drehmoment am Abtrieb"),
    ("t_0", "cycle time", "Zykluszeit"),
    ("t_1", "acceleration time", "Beschleunigungszeit"),
    ("t_2", "time at constant speed", "Konstantfahrzeit"),
    ("t_3", "braking time", "Bremszeit"),
    ("t_p", "pause", "Pausenzeit"),
    ("T_1", "torque while accelerating", "Drehmoment beim Beschleunigen"),
    ("T_2", "torque at constant speed", "Drehmoment bei konstanter Drehzahl"),
    ("T_3", "torque while braking", "Drehmoment beim Bremsen"),
    ("T_at", "torque at this point", "Drehmoment in diesem Betriebspunkt"),
    ("T_cont", "continuous torque", "Dauerdrehmoment"),
    ("T_curve", "torque of the curve", "Drehmoment der Kennlinie"),
    ("T_d", "driving torque of the load", "treibendes Lastmoment"),
    ("T_hold", "holding torque required", "gefordertes Haltemoment"),
    ("T_j", "torque through the joint", "Moment durch die Schraubenverbindung"),
    ("t_D", "permissible duration of the drive's peak current", "zulässige Dauer des Spitzenstroms des Servoreglers"),
    ("t_life", "service life", "Betriebszeit"),
    (
        "t_over",
        "longest time above the drive's continuous current",
        "längste Zeit über dem Dauerstrom des Servoreglers",
    ),
    ("T_L", "load torque", "Lastmoment"),
    ("T_L_rms", "rms load torque", "effektives Lastmoment"),
    ("T_need", "holding torque required, with safety", "gefordertes Haltemoment mit Sicherheit"),
    ("T_peak", "peak torque", "Spitzenmoment"),
    ("T_s", "largest load torque at the output of the actuator", "größtes Lastmoment am Abtrieb des Antriebs"),
    ("T_rms", "rms torque", "effektives Drehmoment"),
    ("T_short", "short-time torque", "Kurzzeitdrehmoment"),
    ("T_th", "torque at the permissible loss", "Drehmoment bei zulässiger Verlustleistung"),
    ("T_trans", "transmissible torque of the bolted joint", "übertragbares Drehmoment der Schraubenverbindung"),
    ("tau_w", "time constant of the winding", "Zeitkonstante der Wicklung"),
    ("theta_a", "ambient temperature", "Umgebungstemperatur"),
    ("theta_m", "mean temperature of the winding", "mittlere Wicklungstemperatur"),
    ("theta_w", "temperature of the winding", "Wicklungstemperatur"),
    ("theta_warn", "warning threshold", "Warnschwelle"),
    ("U", "terminal voltage", "Klemmenspannung"),
    ("u_d", "d-axis voltage", "Spannung in d-Richtung"),
    ("U_DC", "DC link voltage", "Zwischenkreisspannung"),
    ("d_U", "deviation of the mains", "Abweichung der Netzspannung"),
    ("U_mains", "mains voltage, line to line, rms", "Netzspannung Leiter-Leiter, effektiv"),
    ("U_LL", "terminal voltage, fundamental, rms", "Klemmenspannung, Grundwelle, effektiv"),
    ("U_M", "available terminal voltage", "verfügbare Klemmenspannung"),
    ("U_top", "DC link voltage with its rise", "Zwischenkreisspannung mit Anstieg"),
    ("u_q", "q-axis voltage", "Spannung in q-Richtung"),
    ("w", "share of the housing in the thermal resistance", "Anteil des Gehäuses am Wärmewiderstand"),
    ("z", "brake applications per cycle", "Bremsungen je Zyklus"),
    ("y", "overload integral", "Überlastintegral"),
];

/// Returns the meaning of a symbol of a derivation in its unit; an empty text where the glossary defines it.
#[must_use]
pub fn step_term(symbol: &str, unit: &str, language: Language) -> &'static str {
    let of_unit = BY_UNIT.iter().find(|(name, of, ..)| *name == symbol && *of == unit).map(|(.., en, de)| (en, de));
    let found = of_unit.or_else(|| TERMS.iter().find(|(name, ..)| *name == symbol).map(|(_, en, de)| (en, de)));
    found.map_or("", |(en, de)| pick(language, en, de))
}

/// Every symbol of the derivations with its meaning, English and German; one symbol may have several.
pub fn step_terms() -> impl Iterator<Item = (&'static str, &'static str, &'static str)> {
    BY_UNIT.iter().map(|(symbol, _, en, de)| (*symbol, *en, *de)).chain(TERMS.iter().copied())
}
