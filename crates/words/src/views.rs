//! Words for the views of the middle pane: cursor, editor of the motion, simulation.

use crate::texts::texts;

texts! {
    place_on_the_axis = "Place on the horizontal axis" | "Stelle auf der waagerechten Achse";
    across_about =
        "Moves a line through the plane; the row shows the value of each curve there. The pointer over the plane does the same."
        | "Bewegt eine Linie durch die Ebene; die Zeile zeigt den Wert jeder Kurve an dieser Stelle. Der Zeiger über der Ebene bewirkt dasselbe.";
    candidate_by_mass = "Candidate, by ascending mass" | "Kandidat nach steigender Masse";
    zoom_about =
        "Also by dragging over a diagram, by the wheel with Ctrl, and by double click for the whole cycle"
        | "Auch durch Ziehen über ein Diagramm, mit Strg und Mausrad; Doppelklick zeigt den ganzen Zyklus";
    margin = "margin" | "Reserve";
}
