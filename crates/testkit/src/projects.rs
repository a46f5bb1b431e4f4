//! Generated project files: every mechanism with random values, alone and behind a stage, and motions within the limits
//! of its geometry.

use numeric::Random;

/// A mechanism as sections of a project file.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// Key of the mechanism; `load` for a load at the output.
    pub key: &'static str,
    /// `[mechanism.…]` or `[load]`, and `[stage]`.
    pub sections: String,
    /// Keys of `[bearing]` from which its loads on the flange follow; `None` if it describes none.
    pub bearing: Option<String>,
    /// Permitted angle from position zero, forwards \[deg\].
    pub stroke_deg: f64,
}

/// Names of laws of motion that move by a distance within a time.
pub const LAWS: [&str; 5] = ["trapezoid", "polynomial_5", "modified_sine", "triangle", "simple_sine"];

/// Random numbers for a project.
#[derive(Clone, Debug)]
pub struct Draws(Random);

impl Draws {
    /// Creates the numbers that follow from a seed.
    #[must_use]
    pub const fn new(seed: u64) -> Self {
        Self(Random::new(seed))
    }

    /// Returns a number between two.
    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.0.uniform()
    }

    /// Returns one of several values.
    ///
    /// # Panics
    /// If there is none.
    #[allow(clippy::indexing_slicing, reason = "a draw from nothing must fail the test")]
    pub fn one_of<T: Clone>(&mut self, all: &[T]) -> T {
        let place = (0..all.len()).rev().find(|place| self.0.uniform() * (index(*place) + 1.0) < 1.0).unwrap_or(0);
        all[place].clone()
    }
}

fn index(place: usize) -> f64 {
    f64::from(u32::try_from(place).unwrap_or(u32::MAX))
}

/// Returns every mechanism, alone and behind a belt and a pair of gear wheels.
#[must_use]
pub fn mechanisms(draws: &mut Draws) -> Vec<Drawn> {
    let alone = alone(draws);
    let mut all = alone.clone();
    for drawn in alone {
        all.push(behind_a_stage(drawn, draws));
    }
    all
}

fn behind_a_stage(drawn: Drawn, draws: &mut Draws) -> Drawn {
    let ratio = draws.one_of(&[0.5, 1.5, 2.5]);
    let efficiency = draws.one_of(&["", "efficiency = 0.94\n"]);
    let diameter = draws.within(60.0, 160.0);
    let overhang = draws.within(15.0, 60.0);
    let (kind, contact) = draws.one_of(&[
        ("belt", "belt_tension = \"250 N\"\n"),
        ("gear", "pressure_angle = \"20 deg\"\nhelix_angle = \"12 deg\"\n"),
    ]);
    let stage = format!(
        "[stage]\nkind = \"{kind}\"\nratio = {ratio}\ninertia_driven = \"0.002 kg m^2\"\npitch_diameter = \"{diameter} mm\"\n{efficiency}"
    );
    Drawn {
        sections: format!("{}{stage}", drawn.sections),
        bearing: Some(format!("mechanism = \"add\"\noverhang = \"{overhang} mm\"\n{contact}")),
        ..drawn
    }
}

fn alone(draws: &mut Draws) -> Vec<Drawn> {
    let efficiency = draws.one_of(&["", "efficiency = 0.9\n"]);
    let overhang = draws.within(-40.0, 90.0);
    let at = |more: &str| Some(format!("mechanism = \"add\"\noverhang = \"{overhang} mm\"\n{more}"));
    let (mass, tilt, start) = (draws.within(2.0, 30.0), draws.within(5.0, 175.0), draws.within(-180.0, 180.0));
    let (far, inertia) = (draws.within(50.0, 400.0), draws.within(0.05, 2.0));
    let drawn = |key, sections: String, bearing| Drawn { key, sections, bearing, stroke_deg: 3000.0 };
    let bounded = |drawn: Drawn, stroke_deg: f64| Drawn { stroke_deg, ..drawn };
    let (lead, diameter) = (draws.within(5.0, 40.0), draws.within(40.0, 200.0));
    let slope = draws.within(-90.0, 90.0);
    let (crank, rod) = (draws.within(30.0, 80.0), draws.within(82.0, 300.0));
    let (ground, coupler) = (draws.within(350.0, 450.0), draws.within(320.0, 380.0));
    let (thickness, core, tension) = (draws.within(0.3, 3.0), draws.within(60.0, 120.0), draws.within(20.0, 200.0));
    let full = core + draws.within(100.0, 300.0);
    let (arm_angle, arm_length) = (draws.within(8.0, 40.0), draws.within(500.0, 1200.0));
    let falls = draws.one_of(&[1.0, 2.0, 3.0, 4.0]);
    let rope = draws.within(0.5, 12.0);
    // Up to four fifths of the way from the start to upright.
    let lift = 0.8 * arm_length * arm_angle.to_radians().cos() / lead * 360.0;
    let roll = 0.95 * (full - core) / (2.0 * thickness) * 360.0;
    let hoist = 0.9 * 3000.0 / (std::f64::consts::PI * diameter / falls) * 360.0;
    let points = (0..=12).map(|k| {
        let angle = 30.0 * f64::from(k);
        let (j, t) = (1.0 + 0.3 * angle.to_radians().cos(), 4.0 * (2.0 * angle.to_radians()).sin());
        format!("[\"{angle} deg\", \"{j:.6} kg m^2\", \"{t:.6} N m\"]")
    });
    let points = points.collect::<Vec<_>>().join(", ");
    vec![
        drawn("load", format!("[load]\ninertia = \"{inertia} kg m^2\"\nfriction_torque = \"1 N m\"\n"), None),
        drawn(
            "arm",
            format!(
                "[mechanism.arm]\ninertia = \"{inertia} kg m^2\"\nmass = \"{mass} kg\"\ncentre_distance = \"{far} mm\"\n\
                 axis_tilt = \"{tilt} deg\"\nstart_angle = \"{start} deg\"\n{efficiency}"
            ),
            at(""),
        ),
        drawn(
            "turntable",
            format!(
                "[mechanism.turntable]\naxis_tilt = \"{tilt} deg\"\n\
                 bodies = [\"disc mass={mass}kg diameter={far}mm length=20mm\"]\n"
            ),
            at(""),
        ),
        drawn(
            "slider_crank",
            format!(
                "[mechanism.slider_crank]\ncrank = \"{crank} mm\"\nrod = \"{rod} mm\"\nmass = \"{mass} kg\"\n\
                 inclination = \"{slope} deg\"\nstart_angle = \"{start} deg\"\n{efficiency}"
            ),
            at(""),
        ),
        drawn(
            "four_bar",
            format!(
                "[mechanism.four_bar]\nground = \"{ground} mm\"\ncrank = \"100 mm\"\ncoupler = \"{coupler} mm\"\nrocker = \"250 mm\"\n\
                 coupler_mass = \"{mass} kg\"\ncoupler_centre = \"160 mm\"\ncoupler_inertia = \"0.02 kg m^2\"\nrocker_mass = \"4 kg\"\n\
                 rocker_centre = \"150 mm\"\nrocker_inertia = \"0.25 kg m^2\"\naxis_tilt = \"{tilt} deg\"\nstart_angle = \"{start} deg\"\n{efficiency}"
            ),
            at(""),
        ),
        drawn("table", format!("[mechanism.table]\npoints = [{points}]\nstart_angle = \"10 deg\"\n{efficiency}"), None),
        drawn(
            "conveyor",
            format!(
                "[mechanism.conveyor]\nroller_diameter = \"{diameter} mm\"\nmass = \"{mass} kg\"\ninclination = \"{slope} deg\"\n{efficiency}"
            ),
            at("belt_tension = \"300 N\"\n"),
        ),
        bounded(
            drawn(
                "belt",
                format!(
                    "[mechanism.belt]\npulley_diameter = \"{diameter} mm\"\nmass = \"{mass} kg\"\ninclination = \"{slope} deg\"\n{efficiency}"
                ),
                at("belt_tension = \"300 N\"\n"),
            ),
            3000.0,
        ),
        bounded(
            drawn(
                "screw",
                format!(
                    "[mechanism.screw]\nlead = \"{lead} mm\"\nmass = \"{mass} kg\"\ninclination = \"{slope} deg\"\n{efficiency}"
                ),
                Some("mechanism = \"add\"\nflange_share = 0.7\n".to_owned()),
            ),
            9000.0,
        ),
        bounded(
            drawn(
                "hoist",
                format!(
                    "[mechanism.hoist]\ndrum_diameter = \"{diameter} mm\"\nfalls = {falls}\nmass = \"{mass} kg\"\ninertia = \"0.01 kg m^2\"\n\
                     rope_mass = \"{rope} kg\"\nhanging = \"3 m\"\nsheave_efficiency = 0.98\n{efficiency}"
                ),
                at(""),
            ),
            hoist,
        ),
        bounded(
            drawn(
                "winder",
                format!(
                    "[mechanism.winder]\nwinding = \"up\"\ncore_diameter = \"{core} mm\"\nfull_diameter = \"{full} mm\"\n\
                     start_diameter = \"{core} mm\"\nthickness = \"{thickness} mm\"\nwidth = \"300 mm\"\ndensity = \"900 kg/m^3\"\n\
                     tension = \"{tension} N\"\ninertia = \"0.02 kg m^2\"\n{efficiency}"
                ),
                at(""),
            ),
            roll,
        ),
        bounded(
            drawn(
                "scissor_lift",
                format!(
                    "[mechanism.scissor_lift]\nstages = 2\narm_length = \"{arm_length} mm\"\nlead = \"{lead} mm\"\n\
                     arm_angle = \"{arm_angle} deg\"\nmass = \"{mass} kg\"\narm_mass = \"10 kg\"\ninertia = \"0.0004 kg m^2\"\n{efficiency}"
                ),
                Some("mechanism = \"add\"\nflange_share = 0.6\n".to_owned()),
            ),
            lift,
        ),
    ]
}

impl Drawn {
    /// Returns a project file with the mechanism, a motion, further keys of `[bearing]`, and `[requirements]`.
    #[must_use]
    pub fn project(&self, motion: &str, bearing: &str, requirements: &str) -> String {
        let loads = self.bearing.as_deref().unwrap_or_default();
        format!(
            "format = 1\n[axis]\nsingle_move = true\n{}{motion}[bearing]\n{loads}{bearing}[requirements]\n{requirements}",
            self.sections
        )
    }
}

/// Returns one move with a law by a distance within a time.
#[must_use]
pub fn moved(law: &str, distance_deg: f64, time_s: f64) -> String {
    format!("[[motion]]\nlaw = \"{law}\"\ndistance = \"{distance_deg} deg\"\ntime = \"{time_s} s\"\n")
}
