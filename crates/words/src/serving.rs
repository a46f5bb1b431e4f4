//! What is said of serving the web workbench.

use crate::texts::texts;

texts! {
    no_folder(path, trouble) =
        "the folder {path} cannot be worked in: {trouble}"
        | "im Ordner {path} lässt sich nicht arbeiten: {trouble}";
    port_taken(port) =
        "port {port} is taken by another program; --port 0 takes a free one"
        | "Port {port} ist von einem anderen Programm belegt; --port 0 nimmt einen freien";
    no_address(address, trouble) =
        "{address} cannot be listened on: {trouble}"
        | "auf {address} lässt sich nicht lauschen: {trouble}";
    no_token(trouble) =
        "the system gives no randomness for a token: {trouble}"
        | "das System gibt keinen Zufall für ein Token her: {trouble}";
    how_to_end = "Ctrl+C ends it" | "Strg+C beendet es";
    reachable(address) =
        "reachable in the network at {address}, without encryption; anyone with the token in the address can read and write the project files of the folder"
        | "im Netz erreichbar unter {address}, unverschlüsselt; wer das Token aus der Adresse kennt, kann die Projektdateien des Ordners lesen und schreiben";
    open_to_the_machine =
        "without a token: every user and program of this machine can read and write the project files of the folder"
        | "ohne Token: jeder Benutzer und jedes Programm dieser Maschine kann die Projektdateien des Ordners lesen und schreiben";
    open_to_the_network(address) =
        "without a token and without encryption at {address}: anyone in the network can read and write the project files of the folder"
        | "ohne Token und unverschlüsselt unter {address}: jeder im Netz kann die Projektdateien des Ordners lesen und schreiben";
    drive_listens(address, protocol) =
        "virtual drive at {address}, protocol {protocol}"
        | "virtueller Regler unter {address}, Protokoll {protocol}";
    drive_is_open =
        "every user and program of this machine can command the virtual drive; it opens no file and no other connection"
        | "jeder Benutzer und jedes Programm dieser Maschine kann den virtuellen Regler steuern; er öffnet keine Datei und keine weitere Verbindung";
    eds_of_the_virtual_drive =
        "virtual drive of antrieb, a simulation"
        | "virtueller Regler von antrieb, eine Simulation";
    no_browser(trouble) = "no browser could be opened: {trouble}" | "es ließ sich kein Browser öffnen: {trouble}";
    no_listening_address(written) =
        "\"{written}\" is no address of this machine to listen on"
        | "„{written}“ ist keine Adresse dieser Maschine zum Lauschen";
    listening_addresses(one, all) =
        "a number such as {one}, or {all} for every address"
        | "eine Nummer wie {one}, oder {all} für jede Adresse";
}
