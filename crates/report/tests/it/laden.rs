//! Axes with payload, loads on the flange, conditions of the place of installation and every requirement: nine pages at most in
//! both languages, and no text over another, with the chapter on mounting too.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test that cannot panic cannot fail")]

use crate::samples;

use quantities::Language;
use questions::list::mount::MountInputs;
use report::{Content, Settings};

/// Pages of one axis at most, without appendices.
const MOST: usize = 9;

/// Mechanisms with their motion.
const AXES: [(&str, &str); 4] = [
    (
        "arm",
        "[mechanism.arm]\nshape = \"taper\"\nlength = \"720 mm\"\nmass = \"7.4 kg\"\npayload_distance = \"690 mm\"\n\
         start_angle = \"-35 deg\"\nfriction_torque = \"2.2 N m\"\n\
         [[motion]]\nlaw = \"modified_sine\"\ndistance = \"110 deg\"\ntime = \"1.6 s\"\npayload = \"3.2 kg\"\n\
         [[motion]]\nlaw = \"dwell\"\ntime = \"1.2 s\"\nhold = \"brake\"\n\
         [[motion]]\nlaw = \"trapezoid\"\ndistance = \"-110 deg\"\ntime = \"1.4 s\"\nacceleration = \"6 rad/s^2\"\n\
         [[motion]]\nlaw = \"dwell\"\ntime = \"0.8 s\"\nhold = \"motor\"\n",
    ),
    (
        "hoist",
        "[mechanism.hoist]\ndrum_diameter = \"140 mm\"\nfalls = 2\nmass = \"55 kg\"\ninertia = \"0.014 kg m^2\"\n\
         rope_mass = \"0.9 kg\"\nhanging = \"2.4 m\"\nsheave_efficiency = 0.97\nefficiency = 0.95\n\
         [[motion]]\nlaw = \"simple_sine\"\ndistance = \"650 mm\"\ntime = \"4.2 s\"\npayload = \"35 kg\"\n\
         [[motion]]\nlaw = \"dwell\"\ntime = \"3 s\"\nhold = \"brake\"\n\
         [[motion]]\nlaw = \"jerk\"\ndistance = \"-650 mm\"\nspeed = \"220 mm/s\"\nacceleration = \"0.5 m/s^2\"\n\
         jerk = \"4 m/s^3\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"5 s\"\nhold = \"brake\"\n",
    ),
    (
        "turntable",
        "[mechanism.turntable]\nfriction_torque = \"3.5 N m\"\n\
         [[mechanism.turntable.body]]\nshape = \"disc\"\ndiameter = \"620 mm\"\nlength = \"28 mm\"\nmass = \"41 kg\"\n\
         [[mechanism.turntable.body]]\nshape = \"disc\"\ndiameter = \"90 mm\"\nlength = \"120 mm\"\nmass = \"5 kg\"\n\
         distance = \"240 mm\"\n\
         [[motion]]\nlaw = \"modified_sine\"\ndistance = \"60 deg\"\ntime = \"0.9 s\"\npayload_inertia = \"0.35 kg m^2\"\n\
         [[motion]]\nlaw = \"dwell\"\ntime = \"1.8 s\"\n",
    ),
    WINDER,
];

/// A winder that states no direction and no start: they are assumed.
const WINDER: (&str, &str) = (
    "winder",
    "single_move = true\n[mechanism.winder]\ntension = \"80 N\"\nwidth = \"400 mm\"\nthickness = \"0.2 mm\"\n\
     density = \"900 kg/m^3\"\ncore_diameter = \"90 mm\"\nfull_diameter = \"330 mm\"\n\
     [[motion]]\nlaw = \"web\"\nspeed = \"60 m/min\"\n",
);

/// Loads on the flange, conditions of the place and requirements.
const DEMANDS: [&str; 3] = [
    "[bearing]\noverhang = \"85 mm\"\npayload_overhang = \"120 mm\"\nload_factor = 1.3\noperating_condition = \"shock\"\n\
     [requirements]\nbrake = true\nfeedback = [\"M512P\", \"M128S\"]\nmains = \"400 V\"\nambient = \"38 degC\"\n\
     altitude = \"1400 m\"\nprotection = \"IP65\"\nhumidity_max = 0.75\nvibration = \"2 g\"\nmounting = \"horizontal\"\n\
     bearing_life_min = \"30000 h\"\ngear_life_min = \"20000 h\"\nangle_error_max = \"3 arcmin\"\nabsolute = true\n\
     emergency_stops = 120\nholding_safety = 1.5\n",
    "[bearing]\naxial_force = \"480 N\"\naxial_distance = \"0 mm\"\nradial_force = \"150 N\"\nradial_distance = \"70 mm\"\n\
     load_factor = 1.2\noperating_condition = \"high_accuracy\"\nmechanism = \"ignore\"\n\
     [requirements]\nsupply = \"560 V\"\nambient = \"25 degC\"\nhollow_shaft_min = \"20 mm\"\nangle_error_max = \"3 arcmin\"\n\
     resolution_max = \"5 arcsec\"\n",
    "[requirements]\nbrake = true\nsupply = \"560 V\"\nambient = \"8 degC\"\nholding_safety = 2\n\
     regeneration_power_max = \"150 W\"\nservice_life = \"20000 h\"\n",
];

fn with_mounting(mut content: Content) -> Content {
    let language = content.language;
    for axis in &mut content.axes {
        let Some(code) = &axis.dossier.judgement.candidate.code else { continue };
        let code = questions::read_code(code, Language::En).unwrap().parsed.code;
        let inputs = MountInputs::default();
        let found = questions::list::mount::mount(&code, &inputs).unwrap();
        let record = questions::answer::mount(&found, &inputs, None, language);
        axis.chapters.push(questions::chapter::mount(&record, language));
    }
    content
}

#[test]
fn an_axis_with_every_requirement_takes_nine_pages_and_no_text_stands_on_another() {
    let mut faults = Vec::new();
    for (name, axis) in AXES {
        for (number, demands) in DEMANDS.iter().enumerate() {
            // Only an arm carries its payload at a distance of its own.
            let demands = if name == "arm" {
                (*demands).to_owned()
            } else {
                demands.replace("payload_overhang = \"120 mm\"\n", "")
            };
            let text =
                format!("format = 1\n[axis]\nname = \"Axis of a plant with a long name – {name}\"\n{axis}{demands}");
            for content in samples::made_in(&text, None, &Language::ALL, true) {
                let what = format!("{name}, demands {number}, {:?}", content.language);
                let settings = Settings { pdf_a: false, ..Settings::default() };
                let pages = report::page_fills(&content, &settings).unwrap().len();
                if pages > MOST {
                    faults.push(format!("{what}: {pages} pages"));
                }
                // What a user types is of no use on paper, nor is the name of a row of our data.
                samples::read::are_readable(&what, &content, &report::letters(&content, &settings).unwrap());
                let content = with_mounting(content);
                faults.extend(
                    report::overlaps(&content, &settings).unwrap().into_iter().map(|each| format!("{what}: {each:?}")),
                );
            }
        }
    }
    assert!(faults.is_empty(), "{faults:#?}");
}
