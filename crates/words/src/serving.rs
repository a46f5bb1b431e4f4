//! Texts about serving the web workbench.

use crate::texts::texts;

texts! {
    no_folder(path, trouble) =
        "the folder {path} cannot be used: {trouble}"
        | "der Ordner {path} kann nicht verwendet werden: {trouble}";
    port_taken(port) =
        "port {port} is in use by another program; --port 0 selects a free port"
        | "Port {port} ist von einem anderen Programm belegt; --port 0 wählt einen freien Port";
    no_address(address, trouble) =
        "cannot listen on {address}: {trouble}"
        | "unter {address} können keine Verbindungen angenommen werden: {trouble}";
    no_token(trouble) =
        "the operating system provides no random numbers for a token: {trouble}"
        | "das Betriebssystem liefert keine Zufallszahlen für ein Token: {trouble}";
    how_to_end = "press Ctrl+C to stop" | "Beenden mit Strg+C";
    reachable(address) =
        "accessible on the network at {address}, unencrypted; anyone with the token in the address can read and write the project files of the folder"
        | "im Netz erreichbar unter {address}, unverschlüsselt; wer das Token aus der Adresse kennt, kann die Projektdateien des Ordners lesen und schreiben";
    open_to_the_machine =
        "without a token: every user and program on this computer can read and write the project files of the folder"
        | "ohne Token: jeder Benutzer und jedes Programm auf diesem Rechner kann die Projektdateien des Ordners lesen und schreiben";
    open_to_the_network(address) =
        "without a token and unencrypted at {address}: anyone on the network can read and write the project files of the folder"
        | "ohne Token und unverschlüsselt unter {address}: jeder im Netz kann die Projektdateien des Ordners lesen und schreiben";
    drive_listens(address, protocol) =
        "virtual drive at {address}, protocol {protocol}"
        | "virtueller Servoregler unter {address}, Protokoll {protocol}";
    drive_is_open =
        "every user and program on this computer can control the virtual drive; it opens no files and no other connections"
        | "jeder Benutzer und jedes Programm auf diesem Rechner kann den virtuellen Servoregler steuern; er öffnet keine Dateien und keine weiteren Verbindungen";
    eds_of_the_virtual_drive =
        "virtual drive of antrieb, a simulation"
        | "virtueller Servoregler von antrieb, eine Simulation";
    no_browser(trouble) = "cannot open a browser: {trouble}" | "der Browser lässt sich nicht öffnen: {trouble}";
    no_listening_address(written) =
        "\"{written}\" is not a network address of this computer"
        | "„{written}“ ist keine Netzwerkadresse dieses Rechners";
    listening_addresses(one, all) =
        "a number such as {one}, or {all} for all addresses"
        | "eine Nummer wie {one} oder {all} für alle Adressen";
}
