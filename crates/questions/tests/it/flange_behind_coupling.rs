//! Stated loads on the flange next to a stage: a coupling adds none, and no statement of their use is required.

/// A flywheel behind a stage, with a stated radial force.
fn faults(mechanism: &str, stage: &str, bearing: &str) -> Vec<String> {
    let text = format!(
        "format = 1\n{mechanism}[stage]\n{stage}[[motion]]\nlaw = \"polynomial_5\"\ndistance = \"90 deg\"\ntime = \"1 s\"\n\
         [[motion]]\nlaw = \"polynomial_5\"\ndistance = \"-90 deg\"\ntime = \"1 s\"\n\
         [bearing]\nradial_force = \"110 N\"\nradial_distance = \"60 mm\"\n{bearing}"
    );
    questions::read(&text).err().unwrap_or_default().iter().map(|found| found.fault.id().to_owned()).collect()
}

const MECHANISMS: [&str; 2] = [
    "[load]\ninertia = \"1.4 kg m^2\"\n",
    "[load]\ninertia = \"0.2 kg m^2\"\nfriction_torque = \"3 N m\"\nexternal_torque = \"5 N m\"\n",
];

#[test]
fn a_coupling_without_mass_needs_no_use_of_stated_loads() {
    for mechanism in MECHANISMS {
        let coupling = "kind = \"coupling\"\ninertia_driving = \"0.01 kg m^2\"\n";
        assert!(faults(mechanism, coupling, "").is_empty(), "{mechanism}: {:?}", faults(mechanism, coupling, ""));
        for used in ["add", "ignore"] {
            let stated = format!("mechanism = \"{used}\"\n");
            assert!(faults(mechanism, coupling, &stated).is_empty(), "{mechanism}: {used}");
        }
        let half = "wheel_mass = \"2 kg\"\noverhang = \"30 mm\"\naxis_tilt = \"90 deg\"\n";
        assert_eq!(faults(mechanism, coupling, half), ["flange_loads_undecided"], "{mechanism}");
        let belt = "kind = \"belt\"\nratio = 2\npitch_diameter = \"80 mm\"\n";
        assert_eq!(faults(mechanism, belt, ""), ["flange_loads_undecided"], "{mechanism}");
    }
}
