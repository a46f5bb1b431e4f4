//! Words for files of another format that were given as a recording.

use crate::texts::said;
use quantities::Language;
use recording::Foreign;

/// Returns the format with its article, and the conversion of its content to a recording.
pub(super) fn foreign(format: Foreign, language: Language) -> (String, String) {
    let (what, remedy) = match format {
        Foreign::Zip => (
            said!(language => "an Excel workbook or another zip archive" | "eine Excel-Mappe oder ein anderes Zip-Archiv"),
            said!(language =>
                "save the sheet of a workbook as CSV; unpack an archive, or pack its CSV with gzip or Zstandard"
                | "das Blatt einer Mappe als CSV speichern; ein Archiv entpacken oder seine CSV-Datei mit gzip oder Zstandard packen"
            ),
        ),
        Foreign::Xls => (
            said!(language => "an old Excel workbook (.xls)" | "eine alte Excel-Mappe (.xls)"),
            said!(language => "save the sheet as CSV" | "das Blatt als CSV speichern"),
        ),
        Foreign::Mat => (
            said!(language => "a MAT file of MATLAB" | "eine MAT-Datei von MATLAB"),
            said!(language =>
                "in MATLAB: writetable(table(t, q, VariableNames=[\"t [s]\", \"q [rad]\"]), \"run.csv\")"
                | "in MATLAB: writetable(table(t, q, VariableNames=[\"t [s]\", \"q [rad]\"]), \"run.csv\")"
            ),
        ),
        Foreign::Hdf5 => (
            said!(language => "HDF5, as MATLAB 7.3 writes it too" | "HDF5, wie es auch MATLAB 7.3 schreibt"),
            said!(language => "export the columns as CSV or Parquet" | "die Spalten als CSV oder Parquet ausgeben"),
        ),
        Foreign::Tdms => (
            said!(language => "a TDMS file of LabVIEW" | "eine TDMS-Datei von LabVIEW"),
            said!(language => "export the channels as CSV" | "die Kanäle als CSV ausgeben"),
        ),
        Foreign::Mdf => (
            said!(language => "an MDF file of a measuring system" | "eine MDF-Datei einer Messdatenerfassung"),
            said!(language => "export the channels as CSV on one time base" | "die Kanäle mit gemeinsamer Zeitbasis als CSV ausgeben"),
        ),
        Foreign::Arrow => (
            said!(language => "an Arrow or Feather file" | "eine Arrow- oder Feather-Datei"),
            said!(language => "save the table as Parquet" | "die Tabelle als Parquet speichern"),
        ),
        Foreign::Bag => (
            said!(language => "a bag of ROS" | "eine Bag-Datei von ROS"),
            said!(language => "export the topic as CSV" | "das Topic als CSV ausgeben"),
        ),
        Foreign::Sqlite => (
            said!(language => "an SQLite database, as bags of ROS 2 are" | "eine SQLite-Datenbank, wie auch Bag-Dateien von ROS 2"),
            said!(language => "export the columns as CSV" | "die Spalten als CSV ausgeben"),
        ),
        Foreign::Pdf => (
            said!(language => "a PDF" | "ein PDF"),
            said!(language => "a table of numbers is required" | "erforderlich ist eine Tabelle aus Zahlen"),
        ),
        Foreign::Packed => (
            said!(language => "packed with bzip2, xz or 7-Zip" | "mit bzip2, xz oder 7-Zip gepackt"),
            said!(language => "unpack it, or pack it with gzip or Zstandard" | "entpacken oder mit gzip oder Zstandard packen"),
        ),
        Foreign::Npy => (
            said!(language => "an array of NumPy (.npy)" | "ein Feld von NumPy (.npy)"),
            said!(language =>
                "in Python: np.savetxt(\"run.csv\", a, delimiter=\",\", header=\"t [s],q [deg]\")"
                | "in Python: np.savetxt(\"run.csv\", a, delimiter=\",\", header=\"t [s],q [deg]\")"
            ),
        ),
        Foreign::Json => (
            said!(language => "JSON" | "JSON"),
            said!(language => "export the columns as CSV or Parquet" | "die Spalten als CSV oder Parquet ausgeben"),
        ),
        Foreign::Markup => (
            said!(language => "XML or HTML, regardless of its name" | "XML oder HTML, unabhängig vom Dateinamen"),
            said!(language => "export the table as CSV" | "die Tabelle als CSV ausgeben"),
        ),
        Foreign::Orc => (
            said!(language => "an ORC file" | "eine ORC-Datei"),
            said!(language => "save the table as Parquet" | "die Tabelle als Parquet speichern"),
        ),
        Foreign::Avro => (
            said!(language => "an Avro file" | "eine Avro-Datei"),
            said!(language => "save the table as Parquet" | "die Tabelle als Parquet speichern"),
        ),
        Foreign::Utf32 => (
            said!(language => "text in UTF-32" | "Text in UTF-32"),
            said!(language => "save it as UTF-8" | "als UTF-8 speichern"),
        ),
    };
    (what, remedy)
}
