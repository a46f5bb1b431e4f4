//! The tools next to the project: each answers in both languages, its faults are shown at its fields, a link restores
//! it.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use crate::shell;

use shell::{get, page, post, whole};

const TOOLS: [&str; 14] = [
    "code",
    "data",
    "curve",
    "torsion",
    "bearing",
    "inertia",
    "battery",
    "wiring",
    "mount",
    "commission",
    "record",
    "upkeep",
    "errata",
    "glossary",
];

/// Returns a tool with typed values.
fn tool(name: &str, about: &str, fields: &[(&str, &str)]) -> String {
    let mut all = vec![("tool", name), ("asked", name), ("about", about)];
    all.extend(fields);
    let html = page(&post("/tools", &all));
    whole(&html);
    html
}

/// Returns the row of a field.
fn row<'h>(html: &'h str, field: &str) -> &'h str {
    let row = html.split(&format!("id=\"t-{field}\"")).nth(1).unwrap_or_else(|| panic!("no field {field}: {html}"));
    &row[..row.find("<label").unwrap_or(row.len())]
}

#[test]
fn tools_answer_for_a_whole_code_a_part_of_one_and_none() {
    for name in TOOLS {
        for about in ["CHA-25A-100-H-M512P-B", "CHA-25A", "CHA-25A-100-H-X9", ""] {
            for lang in ["en", "de"] {
                let html = page(&post("/tools", &[("tool", name), ("about", about), ("lang", lang)]));
                whole(&html);
                assert!(html.contains("aria-pressed=\"true\" hx-post=\"/tools\""), "{name} {about}");
                assert!(html.len() > 3000 && !html.contains("NaN"), "{name} {about}: {html}");
            }
        }
    }
}

#[test]
fn a_calculator_answers_with_number_source_grade_and_picture() {
    let code = "CHA-20A-100-H-C1024";
    let torsion = tool("torsion", code, &[("t_torque", "60 N m")]);
    assert!(torsion.contains("under 60.00 Nm, stiffness region 3") && torsion.contains("<svg"), "{torsion}");
    assert!(torsion.contains("Hysteresis loss: at most 1.00 arcmin (manufacturer data, table 54.1"), "{torsion}");
    let back = tool("torsion", code, &[("t_torque", ""), ("t_angle", "1 arcmin")]);
    assert!(back.contains("1.00 arcmin"), "{back}");
    let curve = tool("curve", code, &[("t_voltage", "220 V")]);
    assert!(
        curve.contains("<svg") && curve.contains("published, CHA Engineering Data p. 39") && curve.contains("220 V"),
        "{curve}"
    );
    let battery = tool("battery", "", &[("t_hours-per-day", "10"), ("t_storage", "1 a")]);
    assert!(battery.contains("Encoder battery:") && battery.contains("at the latest"), "{battery}");
    let inertia =
        tool("inertia", "", &[("t_body", "point mass=2kg distance=500mm\npoint mass=2kg distance=500mm angle=180deg")]);
    assert!(inertia.contains("J = 1.000 kgm², m = 4.000 kg"), "{inertia}");
    let loads = [
        ("t_bearing.radial_force", "1200 N"),
        ("t_bearing.radial_distance", "80 mm"),
        ("t_motion[1].speed", "10 1/min"),
    ];
    let bearing = tool("bearing", "CHA-25A-100-H-C1024", &loads);
    assert!(bearing.contains("id=\"size-25A\" open") && bearing.contains("manufacturer data, table 55.1"), "{bearing}");
    let mount = tool("mount", code, &[("t_bore", "K7")]);
    assert!(mount.contains("K7"));
}

#[test]
fn a_fault_stands_at_its_field_and_the_last_answer_is_marked_as_old() {
    let code = "CHA-20A-100-H-C1024";
    let good = tool("torsion", code, &[("t_torque", "60 N m")]);
    let good = good.split("name=\"t_good\" value=\"").nth(1).unwrap().split('"').next().unwrap().replace("&amp;", "&");
    let html = tool("torsion", code, &[("t_torque", "60"), ("t_good", &good)]);
    assert!(row(&html, "torque").contains("the unit is missing") && html.contains("aria-invalid=\"true\""), "{html}");
    assert!(html.contains("class=\"old\"") && html.contains("under 60.00 Nm"), "{html}");
    let html = tool("inertia", "", &[("t_body", "disc diameter=1m length=2mm mass=1kg\nbox")]);
    let second = html.split("id=\"body-1\"").nth(1).unwrap().split("</fieldset>").next().unwrap();
    assert!(second.contains("class=\"fault\""), "{html}");
    let html = tool("bearing", "", &[("t_bearing.radial_force", "1200 kg")]);
    assert!(row(&html, "bearing.radial_force").contains("class=\"fault\""), "{html}");
    let html = tool("mount", code, &[("t_bore", "K99")]);
    assert!(row(&html, "bore").contains("class=\"fault\""), "{html}");
    // An empty field is no fault before the first entry.
    let fresh = page(&post("/tools", &[("tool", "upkeep"), ("about", code)]));
    assert!(!fresh.contains("class=\"fault\""), "{fresh}");
    assert!(row(&tool("upkeep", code, &[]), "delivered").contains("class=\"fault\""));
}

#[test]
fn a_link_opens_a_tool_as_it_was() {
    let html = tool("torsion", "CHA-20A-100-H-C1024", &[("t_angle", "2 arcmin"), ("t_torque", "")]);
    let link =
        html.split("id=\"tool-link\" href=\"/?").nth(1).unwrap().split('"').next().unwrap().replace("&amp;", "&");
    let opened = page(&get("/", &link));
    whole(&opened);
    let answer =
        |html: &str| html.split("id=\"tool-answer\"").nth(1).unwrap().split("</svg>").next().unwrap().to_owned();
    assert_eq!(answer(&opened), answer(&html));
}

#[test]
fn upkeep_has_its_dates_and_its_calendar() {
    let html = tool("upkeep", "CHA-17A-100-H-M128S", &[("t_delivered", "2026-03-01"), ("t_storage", "6 months")]);
    assert!(
        html.contains("2026-09-01") && html.contains("/api/v1/upkeep/calendar?code=CHA-17A-100-H-M128S&amp;"),
        "{html}"
    );
    let calendar = get("/api/v1/upkeep/calendar", "code=CHA-17A-100-H-M128S&delivered=2026-03-01&today=2026-04-01");
    assert_eq!((calendar.status, calendar.media), (200, "text/calendar; charset=utf-8"));
    assert!(calendar.body.starts_with(b"BEGIN:VCALENDAR"));
}

#[test]
fn what_a_drive_is_told_comes_as_its_files() {
    let code = "code=CHA-25A-100-H-M512P-B";
    for (path, more, begin) in [
        ("commission/drive", "&for=sinamics", "; "),
        ("commission/drive", "&for=cia402", "; "),
        ("commission/blank", "", "# "),
    ] {
        let reply = get(&format!("/api/v1/{path}"), &format!("{code}{more}"));
        assert!(reply.status == 200 && reply.body.starts_with(begin.as_bytes()), "{path}{more}");
        assert!(reply.headers.iter().any(|(name, value)| *name == "content-disposition" && value.contains("CHA-25A")));
    }
    assert_eq!(get("/api/v1/commission/drive", code).status, 422, "no drive is named");
    assert_eq!(
        get("/api/v1/commission/checklist", code).status,
        422,
        "nothing here writes a PDF, and the answer says so"
    );
}

/// Values are typed in and judged; the file is the one of the command line.
#[test]
fn measured_values_are_judged_as_they_are_typed() {
    let code = "CHA-25A-100-H-M512P-B";
    let blank = tool("record", code, &[]);
    assert!(blank.contains("0 out of tolerance, 15 not checked") && blank.contains("3.33 to 4.07"), "{blank}");
    let text = "# mine\nformat = 1\n";
    let typed = |more: &[(&str, &str)]| {
        let mut fields = vec![("t_text", text), ("t_was", text)];
        fields.extend(more);
        tool("record", code, &fields)
    };
    let html = typed(&[("t_winding.temperature", "22 degC"), ("t_winding.resistance_ll", "9 ohm")]);
    assert!(
        html.contains(
            "# mine\nformat = 1\n\n[winding]\ntemperature = &quot;22 degC&quot;\nresistance_ll = &quot;9 ohm&quot;"
        ),
        "{html}"
    );
    assert!(html.contains("1 out of tolerance") && html.contains("class=\"fail\""), "{html}");
    let html = typed(&[("t_winding.temperature", "22 degC"), ("t_winding.resistance_ll", "9")]);
    assert!(
        row(&html, "winding.resistance_ll").contains("the unit is missing") && html.contains("class=\"old\""),
        "{html}"
    );
    let html = typed(&[("t_do", "add no_load[1]")]);
    assert!(html.contains("id=\"t-no_load[1].current\"") && html.contains("[[no_load]]"), "{html}");
    // Entries in the text itself precede those of the fields.
    let fields = [("t_text", "format = 1\n[emf]\n"), ("t_was", text), ("t_winding.temperature", "22 degC")];
    let html = tool("record", code, &fields);
    assert!(!html.contains("22 degC") && row(&html, "emf.voltage_ll").contains("class=\"fault\""), "{html}");
    // Brake values are requested if there is a brake.
    assert!(!tool("record", "CHA-25A-100-H-M512P", &[]).contains("id=\"t-brake.voltage\""));
}

#[test]
fn a_data_sheet_marks_notes_and_errata() {
    let html = tool("data", "CHA-25A-100-H-M512P-B", &[("lang", "de")]);
    assert!(html.contains("href=\"#erratum-") && html.contains("id=\"erratum-") && html.contains("[1] "), "{html}");
    for id in html.split("href=\"#erratum-").skip(1).map(|rest| rest.split('"').next().unwrap()) {
        assert!(html.contains(&format!("id=\"erratum-{id}\"")), "{id} is marked and not explained");
    }
}

/// Bodies of any shape, entered row by row, have the moment of inertia of their text, are drawn, and fill the field that
/// the tool was opened from.
#[test]
fn bodies_entered_row_by_row_fill_the_field() {
    type Shape = (&'static str, &'static [(&'static str, &'static str)], &'static str);
    let shapes: [Shape; 7] = [
        ("disc", &[("diameter", "200"), ("length", "20 mm")], "disc diameter=200mm length=20mm"),
        ("tube", &[("outer", "80"), ("inner", "60"), ("length", "50")], "tube outer=80mm inner=60mm length=50mm"),
        ("box", &[("a", "50"), ("b", "4 cm"), ("height", "30")], "box a=50mm b=4cm height=30mm"),
        ("cone", &[("diameter", "90"), ("height", "30")], "cone diameter=90mm height=30mm"),
        ("sphere", &[("diameter", "90")], "sphere diameter=90mm"),
        (
            "cylinder",
            &[("diameter", "40"), ("length", "90"), ("axis", "perpendicular")],
            "cylinder diameter=40mm length=90mm axis=perpendicular",
        ),
        ("rod", &[("length", "300")], "rod length=300mm"),
    ];
    for (index, (shape, sizes, text)) in shapes.iter().enumerate() {
        let (other, other_sizes, other_text) = &shapes[(index + 3) % shapes.len()];
        let massive = |text: &str| format!("{text} mass=2kg distance=120mm count=3");
        let light = |text: &str| format!("{text} mass=0.5kg");
        let wanted = axis::inertia(&format!("{}\n{}", massive(text), light(other_text))).unwrap();
        let mut fields: Vec<(String, String)> = vec![
            ("t_rows".to_owned(), "true".to_owned()),
            ("into".to_owned(), "load.inertia".to_owned()),
            ("t_shape-0".to_owned(), (*shape).to_owned()),
            ("t_shape-1".to_owned(), (*other).to_owned()),
        ];
        let mut add = |key: &str, row: usize, value: &str| fields.push((format!("t_{key}-{row}"), value.to_owned()));
        for (key, value) in *sizes {
            add(key, 0, value);
        }
        for (key, value) in *other_sizes {
            add(key, 1, value);
        }
        for (key, row, value) in [("mass", 0, "2"), ("distance", 0, "120"), ("count", 0, "3"), ("mass", 1, "500 g")] {
            add(key, row, value);
        }
        let borrowed: Vec<(&str, &str)> = fields.iter().map(|(key, value)| (key.as_str(), value.as_str())).collect();
        let html = tool("inertia", "", &borrowed);
        assert!(html.contains("id=\"bodies-drawing\"") && !html.contains("class=\"fault\""), "{html}");
        assert_eq!(html.matches("<fieldset class=\"body\"").count(), 3, "two bodies and the choice of a further one");
        let value = html.split("value load.inertia=").nth(1).unwrap().split("&quot;").next().unwrap();
        let number: f64 = value.split(' ').next().unwrap().parse().unwrap();
        let inertia = quantities::Measure::si(wanted.total.inertia);
        assert!((number / inertia - 1.0).abs() < 1e-5, "{shape} {other}: {value}, {inertia}");
    }
    // The density of a material is that of its standard; a row without a shape is none.
    let steel = tool(
        "inertia",
        "",
        &[
            ("t_rows", "true"),
            ("t_shape-0", "disc"),
            ("t_diameter-0", "200"),
            ("t_length-0", "20"),
            ("t_material-0", "steel"),
            ("t_shape-1", ""),
        ],
    );
    let wanted = axis::inertia("disc diameter=200mm length=20mm density=7850kg/m^3").unwrap();
    let shown =
        quantities::format_significant(quantities::Measure::si(wanted.total.inertia), 4, quantities::Language::En);
    assert!(steel.contains(&format!("J = {shown} kgm²")), "{steel}");
    assert!(!steel.contains("fill-inertia"), "no field was named");
}

/// A tool begins with the values of the axis in work, or with empty fields: never with a result of figures that were not
/// typed.
#[test]
fn a_tool_begins_from_the_axis_in_work() {
    let fresh = |name: &str, text: &str| {
        page(&post("/tools", &[("tool", name), ("about", "CHA-25A-100-H-C1024"), ("text", text), ("axis", "0")]))
    };
    let held = |html: &str, field: &str| {
        let tag = html.split(&format!("id=\"t-{field}\"")).nth(1).unwrap().split('>').next().unwrap().to_owned();
        tag.split(" value=\"").nth(1).unwrap().split('"').next().unwrap().to_owned()
    };
    let plain = "format = 1\n[load]\ninertia = \"1 kg m^2\"\n";
    for text in ["", plain] {
        for (name, fields) in [
            ("torsion", &["torque", "angle"][..]),
            ("bearing", &["bearing.radial_force", "bearing.axial_force", "motion[1].speed"]),
            ("battery", &["hours-per-day"]),
        ] {
            let html = fresh(name, text);
            for field in fields {
                assert_eq!(held(&html, field), "", "{name} {field}");
            }
            let answer = html.split("id=\"tool-answer\"").nth(1).unwrap().split_once('>').unwrap().1;
            // No answer, but what it needs.
            let answer = answer.split_once("</p>").map_or(answer, |(needs, rest)| {
                if needs.starts_with("<p class=\"small\">Needed for an answer: ") { rest } else { answer }
            });
            assert!(answer.starts_with("</div>"), "{name}: {answer}");
            assert!(!html.contains("class=\"fault\""), "{name}: {html}");
        }
        let bodies = fresh("inertia", text);
        assert!(!bodies.contains("id=\"body-1\"") && !bodies.contains("J = "), "{bodies}");
    }
    for (prefix, table) in [("", ""), ("axis.", "[[axis]]\nname = \"a\"\n")] {
        let text = format!(
            "format = 1\n{table}[{prefix}bearing]\nradial_force = \"321 N\"\nradial_distance = \"45 mm\"\n\
            [[{prefix}mechanism.turntable.body]]\nshape = \"disc\"\ndiameter = \"400 mm\"\nlength = \"20 mm\"\nmass = \"8 kg\"\n\
            [[{prefix}mechanism.turntable.body]]\nshape = \"point\"\nmass = \"2 kg\"\ndistance = \"150 mm\"\n"
        );
        let bearing = fresh("bearing", &text);
        assert_eq!(held(&bearing, "bearing.radial_force"), "321 N");
        assert_eq!(held(&bearing, "bearing.radial_distance"), "45 mm");
        let bodies = fresh("inertia", &text);
        let wanted = axis::inertia("disc diameter=400mm length=20mm mass=8kg\npoint mass=2kg distance=150mm").unwrap();
        let inertia = quantities::Measure::si(wanted.total.inertia);
        let shown = quantities::format_significant(inertia, 4, quantities::Language::En);
        assert!(bodies.contains(&format!("J = {shown} kgm²")), "{bodies}");
    }
}

/// The twist of an axis is that under its own peak torque; without an axis an example of a torque stands in its place.
#[test]
fn torsion_takes_the_peak_torque_of_the_axis() {
    let code = "CHA-20A-100-H-C1024";
    let text = "format = 1\n[load]\ninertia = \"0.9 kg m^2\"\n[[motion]]\nlaw = \"polynomial_5\"\ndistance = \"60 deg\"\ntime = \"0.8 s\"\n\
        [[motion]]\nlaw = \"polynomial_5\"\ndistance = \"-60 deg\"\ntime = \"0.8 s\"\n";
    let work = page(&post("/work", &[("text", text), ("code", code)]));
    let sums = work.split("class=\"sums\"").nth(1).unwrap();
    let peak = sums.split("<sub>peak</sub>").nth(1).unwrap().split("Nm").next().unwrap();
    let peak = peak.rsplit('>').next().unwrap().trim().to_owned();
    let html = page(&post("/tools", &[("tool", "torsion"), ("about", code), ("text", text)]));
    let field = html.split("id=\"t-torque\"").nth(1).unwrap().split('>').next().unwrap();
    assert!(!peak.is_empty() && field.contains(&format!("value=\"{peak}")), "{peak}: {field}");
    let alone = page(&post("/tools", &[("tool", "torsion"), ("about", code)]));
    assert!(!alone.split("id=\"t-torque\"").nth(1).unwrap().split('>').next().unwrap().contains(&peak));
}
