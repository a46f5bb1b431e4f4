//! Words of the keys of the project file.

use project::About;
use quantities::Language;

/// What a key of the project file is for.
#[must_use]
#[rustfmt::skip] // one line per key and language
pub const fn about_text(about: About, language: Language) -> &'static str {
    let (en, de) = match about {
        About::Measured(key) => return super::measured_key_text(key, language),
        About::Format => ("version of the file format, 1", "Version des Dateiformats, 1"),
        About::Axis => (
            "the axis; or [[axis]], several axes with load, motion and all else inside",
            "die Achse; oder [[axis]], mehrere Achsen mit Last, Bewegung und allem anderen darin",
        ),
        About::Load => (
            "what is moved, referred to the output; or [mechanism.…]",
            "was bewegt wird, auf den Abtrieb bezogen; oder [mechanism.…]",
        ),
        About::Mechanism => (
            "what lies between output and load; one of its tables",
            "was zwischen Abtrieb und Last liegt; eine seiner Tabellen",
        ),
        About::Stage => (
            "belt, gear or coupling between actuator and mechanism",
            "Riemen, Getriebestufe oder Kupplung zwischen Antrieb und Mechanismus",
        ),
        About::Motion => ("the moves of one cycle, in order", "die Bewegungen eines Zyklus, der Reihe nach"),
        About::Bearing => ("loads on the output flange", "Lasten am Abtriebsflansch"),
        About::Requirements => ("what the actuator must have", "was der Antrieb haben muss"),
        About::Actuator => ("an actuator that the catalogue lacks", "ein Antrieb, der nicht im Katalog steht"),
        About::Curve => (
            "measured or digitised curves of the torque-speed plane; they win over the catalogue's",
            "gemessene oder digitalisierte Kennlinien; sie gehen denen des Katalogs vor",
        ),
        About::CurveKind => ("what the curve limits", "was die Kennlinie begrenzt"),
        About::CurveCode => (
            "codes it holds for; * stands for any field: CHA-25A-100-*",
            "Codes, für die sie gilt; * steht für jedes Feld: CHA-25A-100-*",
        ),
        About::CurvePoints => (
            "corner points from standstill, speed and torque at the output",
            "Eckpunkte ab Stillstand, Drehzahl und Drehmoment am Abtrieb",
        ),
        About::CurveSource => ("where the curve is from", "woher die Kennlinie ist"),
        About::AxisName => ("name of the axis", "Name der Achse"),
        About::AxisSingleMove => (
            "true: the motion is one move and need not come back",
            "true: die Bewegung ist einmalig und muss nicht zurückkehren",
        ),
        About::LoadInertia => (
            "J_L, moment of inertia of the load at the output",
            "J_L, Massenträgheitsmoment der Last am Abtrieb",
        ),
        About::FrictionTorque => (
            "T_L, friction torque at the output; opposes every motion; zero where no friction is stated, listed as assumed",
            "T_L, Reibmoment am Abtrieb; wirkt jeder Bewegung entgegen; null, wo keine Reibung angegeben ist, als angenommen genannt",
        ),
        About::ViscousFriction => (
            "friction at the output in proportion to the speed",
            "drehzahlproportionale Reibung am Abtrieb",
        ),
        About::ExternalTorque => (
            "constant torque at the output against the positive direction; does not reverse",
            "konstantes Moment am Abtrieb gegen die positive Richtung; kehrt nicht um",
        ),
        About::Efficiency => (
            "efficiency while the actuator drives the load; 1 without it, listed as assumed",
            "Wirkungsgrad, wenn der Antrieb die Last treibt; ohne Angabe 1, als angenommen genannt",
        ),
        About::EfficiencyBack => (
            "efficiency while the load drives the actuator; 1 without it, listed as assumed where efficiency is stated",
            "Wirkungsgrad, wenn die Last den Antrieb treibt; ohne Angabe 1, als angenommen genannt, wo efficiency angegeben ist",
        ),
        About::Mass => ("moved mass", "bewegte Masse"),
        About::TurningInertia => (
            "moment of inertia of what turns with the output",
            "Massenträgheitsmoment dessen, was sich mit dem Abtrieb dreht",
        ),
        About::Inclination => (
            "positive direction above the horizontal; 90 deg is upwards; horizontal without it",
            "positive Richtung über der Waagerechten; 90 deg ist aufwärts; ohne Angabe waagerecht",
        ),
        About::Counterweight => ("counterweight that moves with the slide", "mitbewegtes Gegengewicht"),
        About::FrictionForce => ("friction force of seals and guides", "Reibkraft von Dichtungen und Führungen"),
        About::FrictionCoefficient => ("friction coefficient of the guide", "Reibzahl der Führung"),
        About::ProcessForce => (
            "process force along the line, against the positive direction; does not reverse",
            "Prozesskraft längs der Führung, gegen die positive Richtung; kehrt nicht um",
        ),
        About::StartAngle => ("position in which the motion begins", "Stellung, in der die Bewegung beginnt"),
        About::MechanismTurntable => ("turntable or drum of solid bodies", "Drehtisch oder Trommel aus Vollkörpern"),
        About::MechanismArm => ("unbalanced arm", "unausgewuchteter Arm"),
        About::MechanismScrew => ("screw with slide", "Gewindetrieb mit Schlitten"),
        About::MechanismBelt => ("belt, or rack and pinion, with slide", "Zahnriemen oder Zahnstange mit Schlitten"),
        About::MechanismConveyor => (
            "conveyor or roller that runs endlessly",
            "endlos laufendes Förderband oder Walze",
        ),
        About::MechanismSliderCrank => ("crank, rod and slider", "Schubkurbel"),
        About::MechanismJoint => (
            "joint of a robot, its torque recorded with the motion",
            "Robotergelenk, dessen Moment mit der Bewegung aufgezeichnet ist",
        ),
        About::MechanismTable => (
            "inertia and torque over the position",
            "Massenträgheitsmoment und Moment über der Stellung",
        ),
        About::StageKind => ("what the stage is", "Art der Stufe"),
        About::StageRatio => (
            "i_s, turns of the actuator's output per turn of the mechanism; a coupling has 1 without it",
            "i_s, Umdrehungen des Antriebs je Umdrehung des Mechanismus; eine Kupplung hat ohne Angabe 1",
        ),
        About::StageRatios => (
            "several ratios, of which the best is found",
            "mehrere Übersetzungen, aus denen die beste gesucht wird",
        ),
        About::StageEfficiency => ("efficiency while the actuator drives; 1 without it, listed as assumed", "Wirkungsgrad, wenn der Antrieb treibt; ohne Angabe 1, als angenommen genannt"),
        About::StageEfficiencyBack => (
            "efficiency while the mechanism drives; 1 without it, listed as assumed where efficiency is stated",
            "Wirkungsgrad, wenn der Mechanismus treibt; ohne Angabe 1, als angenommen genannt, wo efficiency angegeben ist",
        ),
        About::StageInertiaDriving => (
            "J_1, moment of inertia of what turns with the actuator",
            "J_1, Massenträgheitsmoment dessen, was sich mit dem Antrieb dreht",
        ),
        About::StageInertiaDriven => (
            "J_2, moment of inertia of what turns with the mechanism",
            "J_2, Massenträgheitsmoment dessen, was sich mit dem Mechanismus dreht",
        ),
        About::StageStiffness => (
            "K_s, torsional stiffness of the stage on the side of the mechanism; rigid without it, listed as assumed",
            "K_s, Torsionssteifigkeit der Stufe auf der Seite des Mechanismus; ohne Angabe starr, als angenommen genannt",
        ),
        About::StageBacklash => ("backlash on the side of the mechanism; none without it, listed as assumed", "Spiel auf der Seite des Mechanismus; ohne Angabe keines, als angenommen genannt"),
        About::StagePitchDiameter => (
            "pitch diameter of pulley or wheel on the actuator",
            "Wirkdurchmesser von Scheibe oder Rad am Antrieb",
        ),
        About::BodyShape => ("shape of the body", "Form des Körpers"),
        About::BodyDiameter => (
            "diameter of cylinder, disc, cone (at its base) or sphere",
            "Durchmesser von Zylinder, Scheibe, Kegel (unten) oder Kugel",
        ),
        About::BodyLength => ("length along the body's own axis", "Länge in Richtung der eigenen Achse"),
        About::BodyOuter => ("outer diameter of a tube", "Außendurchmesser eines Rohrs"),
        About::BodyInner => ("inner diameter of a tube", "Innendurchmesser eines Rohrs"),
        About::BodyA => (
            "first side of a box, across the axis of rotation",
            "erste Seite eines Quaders, quer zur Drehachse",
        ),
        About::BodyB => (
            "second side of a box, across the axis of rotation",
            "zweite Seite eines Quaders, quer zur Drehachse",
        ),
        About::BodyHeight => (
            "height of box or cone along the axis of rotation",
            "Höhe von Quader oder Kegel in Richtung der Drehachse",
        ),
        About::BodyAxis => (
            "how cylinder, disc or tube lies to the axis of rotation; parallel without it",
            "wie Zylinder, Scheibe oder Rohr zur Drehachse liegt; ohne Angabe parallel",
        ),
        About::BodyMass => ("mass of one piece; or density", "Masse eines Stücks; oder density"),
        About::BodyDensity => ("density; or mass", "Dichte; oder mass"),
        About::BodyDistance => (
            "distance of the centre of mass from the axis of rotation; zero without it",
            "Abstand des Schwerpunkts von der Drehachse; ohne Angabe null",
        ),
        About::BodyAngle => (
            "direction of the centre of mass in the plane of rotation; zero without it",
            "Richtung des Schwerpunkts in der Drehebene; ohne Angabe null",
        ),
        About::BodyCount => (
            "equal pieces, evenly spaced on the circle; one without it",
            "gleiche Stücke, gleichmäßig auf dem Kreis; ohne Angabe eines",
        ),
        About::TurntableBody => (
            "its solid bodies, each a table; or bodies",
            "seine Vollkörper, je eine Tabelle; oder bodies",
        ),
        About::TurntableBodies => (
            "the same, each in one line as for antrieb inertia",
            "dasselbe, je Körper eine Zeile wie bei antrieb inertia",
        ),
        About::TurntableAxisTilt => (
            "tilt of the rotation axis from the vertical; vertical without it",
            "Neigung der Drehachse gegen die Senkrechte; ohne Angabe senkrecht",
        ),
        About::TurntableStartAngle => (
            "position in which the motion begins; zero without it",
            "Stellung, in der die Bewegung beginnt; ohne Angabe null",
        ),
        About::TurntablePayloadDistance => (
            "distance of the payload of a segment from the axis",
            "Abstand der Nutzlast eines Abschnitts von der Drehachse",
        ),
        About::ArmInertia => (
            "moment of inertia of the arm about the axis, without payload",
            "Massenträgheitsmoment des Arms um die Drehachse, ohne Nutzlast",
        ),
        About::ArmMass => ("mass of the arm", "Masse des Arms"),
        About::ArmCentreDistance => (
            "distance of its centre of mass from the axis",
            "Abstand seines Schwerpunkts von der Drehachse",
        ),
        About::ArmAxisTilt => (
            "tilt of the rotation axis from the vertical; 90 deg for a horizontal axis",
            "Neigung der Drehachse gegen die Senkrechte; 90 deg bei waagerechter Achse",
        ),
        About::ScrewLead => ("travel per revolution", "Steigung, Weg je Umdrehung"),
        About::BeltPulleyDiameter => (
            "pitch diameter of the driving pulley or pinion",
            "Wirkdurchmesser der Antriebsscheibe oder des Ritzels",
        ),
        About::ConveyorRollerDiameter => ("diameter of the driving roller", "Durchmesser der Antriebswalze"),
        About::SliderCrankCrank => ("crank radius", "Kurbelradius"),
        About::SliderCrankRod => ("rod length, longer than the crank", "Pleuellänge, größer als der Kurbelradius"),
        About::TablePoints => (
            "position, moment of inertia, holding torque; straight between the points",
            "Stellung, Massenträgheitsmoment, Haltemoment; gerade zwischen den Punkten",
        ),
        About::JointInertia => (
            "largest moment of inertia that the joint feels, for the ratio of inertias, the natural frequency and the brake; it is in the recorded torque already",
            "größtes Massenträgheitsmoment am Gelenk, für Trägheitsverhältnis, Eigenfrequenz und Bremse; im aufgezeichneten Moment steckt es schon",
        ),
        About::JointHoldingTorque => (
            "largest torque that holds the arm at rest, for the brake",
            "größtes Moment, das den Arm im Stillstand hält, für die Bremse",
        ),
        About::ColumnsTime => ("name of the column of time", "Name der Zeitspalte"),
        About::ColumnsPosition => (
            "name of the column of position; none: there is none",
            "Name der Lagespalte; none: es gibt keine",
        ),
        About::ColumnsSpeed => (
            "name of the column of speed; none: there is none",
            "Name der Drehzahl- oder Geschwindigkeitsspalte; none: es gibt keine",
        ),
        About::ColumnsTorque => (
            "name of the column of torque or force; none: there is none",
            "Name der Momenten- oder Kraftspalte; none: es gibt keine",
        ),
        About::UnitsTime => (
            "unit of time, if the file does not say it",
            "Einheit der Zeit, wenn die Datei sie nicht nennt",
        ),
        About::UnitsPosition => (
            "unit of position, if the file does not say it",
            "Einheit der Lage, wenn die Datei sie nicht nennt",
        ),
        About::UnitsSpeed => (
            "unit of speed, if the file does not say it",
            "Einheit der Drehzahl, wenn die Datei sie nicht nennt",
        ),
        About::UnitsTorque => (
            "unit of torque or force, if the file does not say it",
            "Einheit des Moments oder der Kraft, wenn die Datei sie nicht nennt",
        ),
        About::MotionLaw => ("law of the motion", "Bewegungsgesetz"),
        About::MotionSpeed => (
            "largest speed, at the output or along the line; negative for the way back",
            "größte Drehzahl am Abtrieb oder Geschwindigkeit längs der Führung; negativ für den Rückweg",
        ),
        About::MotionAccelerate => (
            "t_1, time of acceleration from rest",
            "t_1, Beschleunigungszeit aus dem Stillstand",
        ),
        About::MotionRun => ("t_2, time at constant speed", "t_2, Zeit mit konstanter Drehzahl"),
        About::MotionBrake => ("t_3, time of braking to rest", "t_3, Bremszeit bis zum Stillstand"),
        About::MotionPause => ("t_p, rest after the move", "t_p, Stillstand nach der Bewegung"),
        About::MotionDistance => ("travel, negative backwards", "Weg, rückwärts negativ"),
        About::MotionTime => ("duration of the segment", "Dauer des Abschnitts"),
        About::MotionAcceleration => (
            "largest acceleration and deceleration",
            "größte Beschleunigung und Verzögerung",
        ),
        About::MotionJerk => ("largest jerk", "größter Ruck"),
        About::MotionEndSpeed => (
            "speed at the end of the segment; rest without it",
            "Geschwindigkeit am Ende des Abschnitts; ohne Angabe Stillstand",
        ),
        About::MotionHold => (
            "what holds the load at rest; the motor without it, listed as assumed",
            "was die Last im Stillstand hält; ohne Angabe der Motor, als angenommen genannt",
        ),
        About::MotionFile => (
            "CSV or Parquet file with the recording, beside the project file",
            "CSV- oder Parquet-Datei mit der Aufzeichnung, neben der Projektdatei",
        ),
        About::MotionColumns => (
            "names of its columns, where they are not the usual ones",
            "Namen ihrer Spalten, wo es nicht die üblichen sind",
        ),
        About::MotionUnits => (
            "units of its columns, where the file does not say them",
            "Einheiten ihrer Spalten, wo die Datei sie nicht nennt",
        ),
        About::MotionFrom => (
            "samples before are left out, in the time of the file",
            "frühere Abtastwerte entfallen, in der Zeit der Datei",
        ),
        About::MotionTo => (
            "samples after are left out, in the time of the file",
            "spätere Abtastwerte entfallen, in der Zeit der Datei",
        ),
        About::MotionSmoothing => (
            "width of the window of a moving parabola; nothing is smoothed without it",
            "Fensterbreite einer gleitenden Parabel; ohne Angabe wird nichts geglättet",
        ),
        About::MotionStandstill => (
            "speeds below this count as standstill",
            "kleinere Drehzahlen gelten als Stillstand",
        ),
        About::MotionGaps => (
            "allow: long gaps between samples are meant",
            "allow: lange Lücken zwischen Abtastwerten sind gewollt",
        ),
        About::MotionPayload => ("mass carried in this segment", "in diesem Abschnitt mitgeführte Masse"),
        About::MotionPayloadInertia => (
            "moment of inertia at the output carried in this segment",
            "in diesem Abschnitt mitgeführtes Massenträgheitsmoment am Abtrieb",
        ),
        About::MotionProcessForce => (
            "process force along the line in this segment, against the positive direction",
            "Prozesskraft längs der Führung in diesem Abschnitt, gegen die positive Richtung",
        ),
        About::MotionProcessTorque => (
            "process torque at the output in this segment, against the positive direction",
            "Prozessmoment am Abtrieb in diesem Abschnitt, gegen die positive Richtung",
        ),
        About::MotionBearing => (
            "loads on the output flange in this segment, instead of [bearing]",
            "Lasten am Abtriebsflansch in diesem Abschnitt, anstelle von [bearing]",
        ),
        About::RadialForce => ("F_r, radial force on the flange", "F_r, Radialkraft am Flansch"),
        About::RadialDistance => (
            "L_r, distance of the radial force from the flange face",
            "L_r, Abstand der Radialkraft von der Flanschfläche",
        ),
        About::AxialForce => ("F_a, axial force on the flange", "F_a, Axialkraft am Flansch"),
        About::AxialDistance => (
            "L_a, distance of the axial force from the axis",
            "L_a, Abstand der Axialkraft von der Drehachse",
        ),
        About::BearingLoadFactor => ("f_w, load factor of table 74.2; the life of the output bearing is not checked without it", "f_w, Betriebsfaktor nach Tabelle 74.2; ohne Angabe wird die Lebensdauer des Abtriebslagers nicht geprüft"),
        About::BearingOperatingCondition => (
            "operating condition of table 76.3; the static safety is shown and not judged without it",
            "Betriebsbedingung nach Tabelle 76.3; ohne Angabe wird die statische Sicherheit gezeigt und nicht beurteilt",
        ),
        About::BearingMechanism => (
            "loads that follow from the mechanism: they add to the stated ones, are replaced by those of a segment, or do not count; they do not count without it",
            "Lasten, die aus dem Mechanismus folgen: sie kommen zu den angegebenen hinzu, werden von denen eines Abschnitts ersetzt oder zählen nicht; ohne Angabe zählen sie nicht",
        ),
        About::BearingOverhang => (
            "L, distance of the centre of mass, or of the middle of pulley, pinion or crank pin, from the flange face",
            "L, Abstand des Schwerpunkts oder der Mitte von Scheibe, Ritzel oder Kurbelzapfen von der Flanschfläche",
        ),
        About::BearingPayloadOverhang => (
            "distance of the payload of a segment from the flange face",
            "Abstand der Nutzlast eines Abschnitts von der Flanschfläche",
        ),
        About::BearingFlangeShare => (
            "share of the mechanism's forces that reaches the flange; other bearings carry the rest; needed for a screw, elsewhere 1 without it, listed as assumed",
            "Anteil der Kräfte des Mechanismus, der den Flansch erreicht; den Rest tragen andere Lager; beim Gewindetrieb nötig, sonst ohne Angabe 1, als angenommen genannt",
        ),
        About::BearingBeltTension => (
            "F_v, tension of each span of the belt at rest",
            "F_v, Trumkraft des Riemens im Stillstand, je Trum",
        ),
        About::BearingPressureAngle => (
            "pressure angle of pinion and rack in the normal section",
            "Eingriffswinkel von Ritzel und Zahnstange im Normalschnitt",
        ),
        About::BearingHelixAngle => (
            "helix angle of the teeth; spur teeth without it, listed as assumed",
            "Schrägungswinkel der Verzahnung; ohne Angabe Geradverzahnung, als angenommen genannt",
        ),
        About::BearingWheelMass => (
            "mass of pulley, pinion or crank on the flange; weightless without it, listed as assumed",
            "Masse von Scheibe, Ritzel oder Kurbel am Flansch; ohne Angabe gewichtslos, als angenommen genannt",
        ),
        About::BearingAxisTilt => (
            "tilt of the rotation axis from the vertical, for the weight of the wheel",
            "Neigung der Drehachse gegen die Senkrechte, für das Gewicht des Rads",
        ),
        About::RequirementsFeedback => ("permitted motor feedback systems; any without it", "zulässige Motorfeedbacksysteme; ohne Angabe jedes"),
        About::RequirementsBrake => (
            "with (true) or without (false) holding brake; either without it",
            "mit (true) oder ohne (false) Haltebremse; ohne Angabe beides",
        ),
        About::RequirementsHollowShaftMin => ("smallest bore of the hollow shaft", "kleinster Hohlwellendurchmesser"),
        About::RequirementsLengthMax => ("largest length of the actuator", "größte Länge des Antriebs"),
        About::RequirementsMassMax => ("largest mass of the actuator", "größte Masse des Antriebs"),
        About::RequirementsSupply => ("DC link voltage", "Zwischenkreisspannung"),
        About::RequirementsModulationReserve => (
            "share of U_DC/√2 that the drive can give as fundamental; 0.9 without it, listed as assumed",
            "Anteil von U_DC/√2, den der Regler als Grundwelle stellen kann; ohne Angabe 0,9, als angenommen genannt",
        ),
        About::RequirementsAmbient => ("ambient temperature in operation", "Umgebungstemperatur im Betrieb"),
        About::RequirementsBearingLifeMin => (
            "life required of the output bearing",
            "geforderte Lebensdauer des Abtriebslagers",
        ),
        About::RequirementsGearLifeMin => (
            "life required of the wave-generator bearing",
            "geforderte Lebensdauer des Wave-Generator-Lagers",
        ),
        About::RequirementsTorsionMax => (
            "torsion of the gear permitted under the largest torque",
            "zulässiger Torsionswinkel des Getriebes unter dem größten Drehmoment",
        ),
        About::RequirementsNaturalFrequencyMin => (
            "least first natural frequency with blocked motor",
            "kleinste erste Eigenfrequenz bei blockiertem Motor",
        ),
        About::RequirementsTiltAngleMax => (
            "tilt of the flange permitted under the tilting moment",
            "zulässiger Kippwinkel des Flansches unter dem Kippmoment",
        ),
        About::RequirementsAngleErrorMax => (
            "sum of all angular errors permitted at the output",
            "zulässige Summe aller Winkelfehler am Abtrieb",
        ),
        About::RequirementsLeverArm => (
            "distance from the axis at which the error is looked at",
            "Abstand von der Drehachse, in dem der Fehler betrachtet wird",
        ),
        About::RequirementsDeviationMax => (
            "deviation permitted at the lever arm",
            "zulässige Abweichung am Hebelarm",
        ),
        About::RequirementsResolutionMax => (
            "largest step of the position at the output",
            "größter Schritt der Lage am Abtrieb",
        ),
        About::RequirementsAbsolute => (
            "whether the position must be absolute over the whole travel",
            "ob die Lage über den ganzen Weg absolut sein muss",
        ),
        About::RequirementsStopAngleMax => (
            "angle permitted for a stop by the brake alone",
            "zulässiger Winkel eines Halts allein durch die Bremse",
        ),
        About::RequirementsEmergencyStops => (
            "number of stops by the brake alone",
            "Zahl der Nothalte allein durch die Bremse",
        ),
        About::RequirementsHoldingSafety => (
            "factor by which the brake must hold more than the load asks; 1 without it",
            "Faktor, um den die Bremse mehr halten muss, als die Last verlangt; ohne Angabe 1",
        ),
        About::RequirementsServiceLife => (
            "operating time over the life of the axis, for the number of brakings",
            "Betriebszeit über die Lebensdauer der Achse, für die Zahl der Bremsungen",
        ),
        About::RequirementsRegenerationPowerMax => (
            "mean power that supply or brake resistor take back",
            "mittlere Leistung, die Netz oder Bremswiderstand aufnehmen",
        ),
        About::RequirementsOperationPerDay => (
            "operation per day, for the battery of M128S",
            "Betrieb je Tag, für die Batterie von M128S",
        ),
        About::RequirementsStorage => (
            "storage before operation, for the battery of M128S; none without it",
            "Lagerung vor dem Betrieb, für die Batterie von M128S; ohne Angabe keine",
        ),
        About::RequirementsBatteryLifeMin => ("life required of the battery", "geforderte Lebensdauer der Batterie"),
        About::RequirementsCollisionTorque => (
            "largest torque of a collision at the output",
            "größtes Moment einer Kollision am Abtrieb",
        ),
        About::RequirementsCollisionTime => ("duration of a collision", "Dauer einer Kollision"),
        About::RequirementsCollisions => (
            "number of collisions over the life of the axis",
            "Zahl der Kollisionen über die Lebensdauer der Achse",
        ),
        About::RequirementsPositionLoop => (
            "encoder that closes the position loop; output needs option EC; the motor feedback without it",
            "Geber, über den der Lageregler schließt; output braucht Option EC; ohne Angabe das Motorfeedback",
        ),
        About::RequirementsDcLinkRise => (
            "rise of the DC link voltage for which a capacitor bank is sized",
            "Anstieg der Zwischenkreisspannung, für den eine Kondensatorbatterie bemessen wird",
        ),
        About::RequirementsSpecialApplication => (
            "field of application that needs the maker's approval (section 2.4)",
            "Anwendungsbereich, der die Freigabe des Herstellers braucht (Abschnitt 2.4)",
        ),
        About::RequirementsOption1 => ("sensor option", "Option 1 (Sensor)"),
        About::RequirementsOption2 => ("cable and connector option", "Option 2 (Kabel/Stecker)"),
        About::ActuatorName => ("name of the actuator", "Name des Antriebs"),
        About::ActuatorRatio => ("i, reduction ratio", "i, Untersetzung"),
        About::ActuatorTorqueMax => ("T_max", "T_max"),
        About::ActuatorSpeedMax => ("n_max at the output", "n_max am Abtrieb"),
        About::ActuatorSpeedMotorMax => ("largest motor speed", "maximale Motordrehzahl"),
        About::ActuatorSpeedMotorRated => ("n_N, rated motor speed", "n_N, Motor-Bemessungsdrehzahl"),
        About::ActuatorInertiaOut => (
            "J_out, own moment of inertia at the output",
            "J_out, eigenes Massenträgheitsmoment am Abtrieb",
        ),
        About::ActuatorStallTorque => ("T_0", "T_0"),
        About::ActuatorStallCurrent => ("I_0", "I_0"),
        About::ActuatorCurrentMax => ("I_max", "I_max"),
        About::ActuatorCurrentDemagnetisation => ("I_E", "I_E"),
        About::ActuatorNoLoadStartingCurrent => ("I_NLS", "I_NLS"),
        About::ActuatorNoLoadCurrentConstant30 => (
            "K_INL at 30 °C, per output speed",
            "K_INL bei 30 °C, je Abtriebsdrehzahl",
        ),
        About::ActuatorNoLoadCurrentConstant80 => (
            "K_INL at 80 °C, per output speed",
            "K_INL bei 80 °C, je Abtriebsdrehzahl",
        ),
        About::ActuatorTorqueConstantOut => ("k_Tout", "k_Tout"),
        About::ActuatorTorqueConstantMotor => ("k_TM", "k_TM"),
        About::ActuatorVoltageConstantMotor => ("k_EM, line to line, rms", "k_EM, Leiter-Leiter, effektiv"),
        About::ActuatorResistanceLl => ("R_LL at 20 °C", "R_LL bei 20 °C"),
        About::ActuatorWindingTemperatureMax => (
            "largest temperature of the winding, at which the voltage is checked; 90 °C is assumed without it",
            "größte Temperatur der Wicklung, bei der die Spannung geprüft wird; ohne Angabe werden 90 °C angenommen",
        ),
        About::ActuatorInductanceLl => ("L_LL", "L_LL"),
        About::ActuatorPolePairs => ("p", "p"),
        About::ActuatorMass => ("m", "m"),
        About::ActuatorLength => ("L", "L"),
        About::ActuatorHollowShaft => ("d_H", "d_H"),
        About::ActuatorDcLinkMax => ("U_DCmax", "U_DCmax"),
        About::ActuatorTerminalVoltageMin => (
            "U_M from which the performance holds",
            "U_M, ab der die Leistungsdaten gelten",
        ),
        About::ActuatorShortTimeCurve => (
            "short-time curve by its corner points, from standstill",
            "Kurzzeitkennlinie durch ihre Eckpunkte, ab Stillstand",
        ),
        About::ActuatorContinuousCurve => (
            "continuous-duty curve by its corner points, from standstill",
            "Dauerbetriebskennlinie durch ihre Eckpunkte, ab Stillstand",
        ),
    };
    match language {
        Language::En => en,
        Language::De => de,
    }
}
