//! Placeholders for the values of arguments.

use crate::texts::texts;

texts! {
    address = "ADDRESS" | "ADRESSE";
    angle = "ANGLE" | "WINKEL";
    area = "AREA" | "QUERSCHNITT";
    bits = "BITS";
    connector = "CONNECTOR" | "STECKER";
    body = "BODY" | "KÖRPER";
    bore = "BORE" | "BOHRUNG";
    check = "CHECK" | "NACHWEIS";
    code = "CODE";
    command = "COMMAND" | "BEFEHL";
    date = "DATE" | "DATUM";
    drive = "DRIVE" | "SERVOREGLER";
    key_values = "KEY=VALUES" | "SCHLÜSSEL=WERTE";
    key_value = "KEY=VALUE" | "SCHLÜSSEL=WERT";
    what_factor = "WHAT=FACTOR" | "WAS=FAKTOR";
    figure = "FIGURE" | "BILD";
    file = "FILE" | "DATEI";
    folder = "FOLDER" | "ORDNER";
    format = "FORMAT";
    hours = "HOURS" | "STUNDEN";
    interval = "INTERVAL" | "INTERVALL";
    kind = "KIND" | "ART";
    lang = "LANG" | "SPRACHE";
    length = "LENGTH" | "LÄNGE";
    name = "NAME";
    names = "NAME,…";
    new = "NEW" | "NEU";
    old = "OLD" | "ALT";
    pattern = "PATTERN" | "MUSTER";
    project = "PROJECT" | "PROJEKT";
    quantity = "QUANTITY" | "MESSGRÖSSE";
    set = "SET" | "BEFEHLSSATZ";
    size = "SIZE" | "GRÖSSE";
    speed = "SPEED" | "DREHZAHL";
    temperature = "TEMPERATURE" | "TEMPERATUR";
    term = "TERM" | "BEGRIFF";
    text = "TEXT";
    change = "REVISION; DATE; AUTHOR; TEXT" | "REVISION; DATUM; NAME; TEXT";
    theme = "THEME" | "FARBEN";
    time = "TIME" | "ZEIT";
    torque = "TORQUE" | "MOMENT";
    voltage = "VOLTAGE" | "SPANNUNG";
    what = "WHAT" | "WAS";
    code_table_or_id = "CODE | TABLE | ID";
    n = "N";
    shell = "shell" | "SHELL";
}
