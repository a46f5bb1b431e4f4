//! Meaning of each check: the value and the limit that it compares, in a sentence.

use crate::pick;
use quantities::Language;
use sizing::CheckId;

/// Returns what a check compares with its limit, and why.
#[must_use]
pub fn check_meaning(id: CheckId, language: Language) -> &'static str {
    let (en, de) = match id {
        CheckId::PeakTorque => (
            "The largest torque that the motion requires at the output, against the maximum torque of the actuator.",
            "Das größte Drehmoment, das die Bewegung am Abtrieb erfordert, gegen das maximale Drehmoment des Antriebs.",
        ),
        CheckId::PeakSpeed => (
            "The highest output speed of the cycle, against the maximum speed of the motor divided by the ratio.",
            "Die höchste Abtriebsdrehzahl des Zyklus gegen die maximale Motordrehzahl, geteilt durch die Übersetzung.",
        ),
        CheckId::MeanSpeed => (
            "The mean output speed of the cycle, against the rated speed of the motor divided by the ratio.",
            "Die mittlere Abtriebsdrehzahl des Zyklus gegen die Nenndrehzahl des Motors, geteilt durch die Übersetzung.",
        ),
        CheckId::ContinuousTorque => (
            "The effective (rms) torque of the cycle, against the torque that the actuator delivers without time limit at the mean speed: what the winding heats up with on average.",
            "Das effektive Drehmoment des Zyklus gegen das Drehmoment, das der Antrieb bei der mittleren Drehzahl unbegrenzt abgibt: was die Wicklung im Mittel erwärmt.",
        ),
        CheckId::PeakCurrent => (
            "The largest motor current of the cycle, against the maximum current of the actuator.",
            "Der größte Motorstrom des Zyklus gegen den maximalen Strom des Antriebs.",
        ),
        CheckId::Demagnetisation => (
            "The largest motor current, against the current at which the magnets lose part of their magnetisation.",
            "Der größte Motorstrom gegen den Strom, bei dem die Magnete einen Teil ihrer Magnetisierung verlieren.",
        ),
        CheckId::DriveCurrent => (
            "The effective motor current, against the continuous current of the servo drive of the machine.",
            "Der effektive Motorstrom gegen den Dauerstrom des Servoreglers der Maschine.",
        ),
        CheckId::DriveCurrentPeak => (
            "The largest motor current, against the peak current of the servo drive of the machine.",
            "Der größte Motorstrom gegen den Spitzenstrom des Servoreglers der Maschine.",
        ),
        CheckId::DrivePeakTime => (
            "The longest time during which the current exceeds the continuous current of the servo drive, against the time for which it delivers its peak current.",
            "Die längste Dauer, in der der Strom den Dauerstrom des Servoreglers überschreitet, gegen die Dauer, für die er seinen Spitzenstrom abgibt.",
        ),
        CheckId::Voltage => (
            "The largest voltage that the motor needs at its terminals, against the voltage that the drive makes from the DC link.",
            "Die größte Spannung, die der Motor an den Klemmen braucht, gegen die Spannung, die der Servoregler aus dem Zwischenkreis bildet.",
        ),
        CheckId::InertiaRatio => (
            "The moment of inertia of the load, against three times that of the actuator at its output: a recommendation for stiff control.",
            "Das Massenträgheitsmoment der Last gegen das Dreifache des auf den Abtrieb bezogenen Eigenträgheitsmoments: eine Empfehlung für steife Regelung.",
        ),
        CheckId::RopeTension => (
            "The force that the acceleration takes off the ropes, against the weight on them: a rope cannot push.",
            "Die Kraft, um die die Beschleunigung die Seile entlastet, gegen das Gewicht an ihnen: Ein Seil kann nicht drücken.",
        ),
        CheckId::GearMeanTorque => (
            "The cubic mean of the torque, weighted with the speed, against the average torque of the gear.",
            "Das mit der Drehzahl gewichtete kubische Mittel des Drehmoments gegen das mittlere Drehmoment des Getriebes.",
        ),
        CheckId::GearLife => (
            "The nominal life of the wave-generator bearing under the cycle, against the required life.",
            "Die nominelle Lebensdauer des Wellengeneratorlagers in diesem Zyklus gegen die geforderte.",
        ),
        CheckId::Torsion => (
            "The torsion of the gear under the largest torque, against the permissible angle of the project.",
            "Der Torsionswinkel des Getriebes unter dem größten Drehmoment gegen den zulässigen Winkel des Projekts.",
        ),
        CheckId::NaturalFrequency => (
            "The lowest natural frequency of the load on the stiffness of the gear, against the required minimum.",
            "Die niedrigste Eigenfrequenz der Last auf der Steifigkeit des Getriebes gegen den geforderten Mindestwert.",
        ),
        CheckId::BearingAxial => (
            "The axial force on the output flange, against the permissible one of the output bearing.",
            "Die Axialkraft am Abtriebsflansch gegen die zulässige des Abtriebslagers.",
        ),
        CheckId::BearingRadial => (
            "The radial force on the output flange, against the permissible one of the output bearing.",
            "Die Radialkraft am Abtriebsflansch gegen die zulässige des Abtriebslagers.",
        ),
        CheckId::BearingTiltingMoment => (
            "The dynamic tilting moment on the output flange, against the permissible one of the output bearing.",
            "Das dynamische Kippmoment am Abtriebsflansch gegen das zulässige des Abtriebslagers.",
        ),
        CheckId::BearingStaticMoment => (
            "The static equivalent tilting moment of the resting gear, against the permissible static tilting moment.",
            "Das statisch äquivalente Kippmoment des stehenden Getriebes gegen das zulässige statische Kippmoment.",
        ),
        CheckId::BearingLife => (
            "The nominal life of the output bearing under the loads of the cycle, against the required life.",
            "Die nominelle Lebensdauer des Abtriebslagers unter den Lasten des Zyklus gegen die geforderte.",
        ),
        CheckId::BearingStatic => (
            "The static safety of the output bearing, against that for the operating condition.",
            "Die statische Sicherheit des Abtriebslagers gegen die für die Betriebsbedingung geforderte.",
        ),
        CheckId::TiltAngle => (
            "The tilt of the output flange under the tilting moment, against the permissible angle of the project.",
            "Der Kippwinkel des Abtriebsflanschs unter dem Kippmoment gegen den zulässigen Winkel des Projekts.",
        ),
        CheckId::Ambient => (
            "The ambient temperatures of the place, against the operating range of the actuator.",
            "Die Umgebungstemperaturen am Aufstellort gegen den Einsatzbereich des Antriebs.",
        ),
        CheckId::Altitude => (
            "The altitude of the place, against the one up to which the data hold; above it, the effective torque against the reduced continuous torque.",
            "Die Aufstellhöhe gegen die Höhe, bis zu der die Daten gelten; darüber das effektive gegen das verminderte Dauerdrehmoment.",
        ),
        CheckId::Protection => (
            "The required degree of protection, against that of the actuator.",
            "Die geforderte Schutzart gegen die des Antriebs.",
        ),
        CheckId::Humidity => (
            "The highest relative humidity of the place, against the upper limit of the actuator.",
            "Die höchste relative Luftfeuchte am Aufstellort gegen die obere Grenze des Antriebs.",
        ),
        CheckId::HumidityMin => (
            "The lowest relative humidity of the place, against the lower limit of the actuator.",
            "Die niedrigste relative Luftfeuchte am Aufstellort gegen die untere Grenze des Antriebs.",
        ),
        CheckId::Vibration => (
            "The vibration at the place, against the resistance of the actuator to vibration.",
            "Die Vibration am Aufstellort gegen die Vibrationsfestigkeit des Antriebs.",
        ),
        CheckId::Shock => (
            "The shocks at the place, against the resistance of the actuator to shock.",
            "Die Stöße am Aufstellort gegen die Schockfestigkeit des Antriebs.",
        ),
        CheckId::Mounting => (
            "The mounting position of the machine, against the positions that the manufacturer permits.",
            "Die Einbaulage in der Maschine gegen die vom Hersteller zugelassenen Lagen.",
        ),
        CheckId::TorqueSpeedTrace => (
            "The torque at every instant of the cycle, against the torque that the actuator delivers for a short time at the speed of that instant.",
            "Das Drehmoment in jedem Zeitpunkt des Zyklus gegen das Drehmoment, das der Antrieb bei der jeweiligen Drehzahl kurzzeitig abgibt.",
        ),
        CheckId::Thermal => (
            "The highest temperature of the winding in the repeated cycle, against the warning threshold of its sensor.",
            "Die höchste Wicklungstemperatur im wiederholten Zyklus gegen die Warnschwelle ihres Fühlers.",
        ),
        CheckId::OverloadI2t => (
            "The square of the current, averaged over the time constant of the overload protection, against that of the continuous stall current: whether the drive would report an overload.",
            "Das mit der Zeitkonstante des Überlastschutzes gemittelte Stromquadrat gegen das des Stillstands-Dauerstroms: ob der Servoregler Überlast meldet.",
        ),
        CheckId::GearMeanInputSpeed => (
            "The mean speed at the input of the gear, against the limit of its lubrication.",
            "Die mittlere Drehzahl am Getriebeeingang gegen die Grenze seiner Schmierung.",
        ),
        CheckId::CollisionTorque => (
            "The torque of a collision that the project states, against the momentary peak torque of the gear.",
            "Das im Projekt angegebene Drehmoment einer Kollision gegen das Kollisionsdrehmoment des Getriebes.",
        ),
        CheckId::CollisionNumber => (
            "The number of collisions that the project states, against the number that the flexspline bears at their torque and speed.",
            "Die im Projekt angegebene Anzahl der Kollisionen gegen die Anzahl, die der Flexspline bei ihrem Drehmoment und ihrer Drehzahl erträgt.",
        ),
        CheckId::ResonanceSpeed => (
            "The speeds at which the axis turns for longer, against those at which the gear excites the natural frequency of the load.",
            "Die Drehzahlen, mit denen die Achse länger fährt, gegen die, bei denen das Getriebe die Eigenfrequenz der Last anregt.",
        ),
        CheckId::ErrorBudget => (
            "The sum of all angular errors at the output, against the permissible error of the project.",
            "Die Summe aller Winkelfehler am Abtrieb gegen den zulässigen Fehler des Projekts.",
        ),
        CheckId::Deviation => (
            "The deviation that all errors cause at the load, against the permissible deviation of the project.",
            "Die Abweichung, die alle Fehler an der Last verursachen, gegen die zulässige des Projekts.",
        ),
        CheckId::BrakeHolding => (
            "The largest torque of the load while the brake holds it, against the holding torque of the brake.",
            "Das größte Lastmoment, während die Bremse hält, gegen das Haltemoment der Bremse.",
        ),
        CheckId::BrakeApplications => (
            "The closings of the brake at standstill over the service life, against their permissible number.",
            "Die Bremsungen im Stillstand über die Einsatzdauer gegen ihre zulässige Anzahl.",
        ),
        CheckId::BrakeEmergency => (
            "The angle that the axis travels until the brake alone has stopped it from the worst instant, against the limit of the project.",
            "Der Winkel, bis die Bremse allein die Achse aus dem ungünstigsten Zeitpunkt angehalten hat, gegen die Grenze des Projekts.",
        ),
        CheckId::BrakeStops => (
            "The number of emergency stops by the brake alone, against the permissible one.",
            "Die Anzahl der Not-Halte allein durch die Bremse gegen die zulässige.",
        ),
        CheckId::DcLink => (
            "The highest voltage of the DC link, against the permissible one of the motor.",
            "Die höchste Zwischenkreisspannung gegen die zulässige des Motors.",
        ),
        CheckId::Regeneration => (
            "The mean power that the axis feeds back while braking, against what supply or braking resistor can take.",
            "Die mittlere Leistung, die die Achse beim Bremsen zurückspeist, gegen die von Einspeisung oder Bremswiderstand aufnehmbare.",
        ),
        CheckId::FeedbackRange => (
            "The range of positions of the motion, against the range in which the encoder is absolute.",
            "Der Positionsbereich der Bewegung gegen den Bereich, in dem der Geber absolut misst.",
        ),
        CheckId::FeedbackResolution => (
            "The smallest step of the measured position at the output, against the largest permissible step of the project.",
            "Der kleinste Schritt der gemessenen Position am Abtrieb gegen den größten zulässigen des Projekts.",
        ),
        CheckId::Battery => (
            "The life of the battery that keeps the turns of the encoder, against the required life.",
            "Die Lebensdauer der Batterie, die die Umdrehungen des Gebers speichert, gegen die geforderte.",
        ),
        CheckId::ScrewJointLoad => (
            "The peak torque, against the torque that the screws between flange and load transmit by friction.",
            "Das Spitzendrehmoment gegen das Drehmoment, das die Schrauben zwischen Flansch und Last durch Reibung übertragen.",
        ),
        CheckId::ScrewJointHousing => (
            "The peak torque, against the torque that the screws of the housing transmit by friction.",
            "Das Spitzendrehmoment gegen das Drehmoment, das die Schrauben des Gehäuses durch Reibung übertragen.",
        ),
        CheckId::Application => (
            "The field of application of the machine, against those that need the approval of the manufacturer.",
            "Der Anwendungsbereich der Maschine gegen die Bereiche, die der Hersteller freigeben muss.",
        ),
    };
    pick(language, en, de)
}
