//! `inertia BODY…`.

use crate::answer::CommandAnswer;
use crate::call::Call;
use crate::table::{Align, TextTable};
use axis::InertiaAnswer;
use quantities::unit::{DEGREE, MILLIMETRE, NEWTON_METRE};
use quantities::{Language, Measure, format_significant};
use questions::list::{Inquiry, Unanswered, inertia};
use words::{shape_title, terminal, terms};

/// `antrieb inertia "disc diameter=200mm length=20mm density=7850kg/m^3" …`
pub(crate) fn inertia(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    Ok(CommandAnswer::data(shown(&inertia::found(inquiry)?, language)))
}

fn shown(answer: &InertiaAnswer, language: Language) -> String {
    let number = |value: f64| format_significant(value, 4, language);
    let mut table = TextTable::new([
        ("#", Align::Right),
        (terms::body(language), Align::Left),
        ("z", Align::Right),
        ("m [kg]", Align::Right),
        ("r [mm]", Align::Right),
        ("φ [°]", Align::Right),
        ("J_own [kgm²]", Align::Right),
        ("m r² [kgm²]", Align::Right),
        ("J [kgm²]", Align::Right),
    ]);
    for (index, each) in answer.bodies.iter().enumerate() {
        table.row([
            (index + 1).to_string(),
            shape_title(each.shape, language).to_owned(),
            each.body.count.to_string(),
            number(each.parts.mass.si()),
            number(each.body.distance.in_unit(&MILLIMETRE)),
            number(each.body.angle.in_unit(&DEGREE)),
            number(each.parts.own.si()),
            number(each.parts.steiner.si()),
            number(each.parts.total.si()),
        ]);
    }
    let total = &answer.total;
    let (inertia, mass) = (number(total.inertia.si()), number(total.mass.si()));
    let (radius, angle) =
        (number(total.centre_radius.in_unit(&MILLIMETRE)), number(total.centre_angle.in_unit(&DEGREE)));
    let gravity = number(total.gravity_torque_max().in_unit(&NEWTON_METRE));
    let balanced = total.centre_radius.si() <= 0.0;
    let centre = if balanced {
        terminal::centre_on_the_axis(language).to_owned()
    } else {
        terminal::centre_of_mass(&radius, &angle, &gravity, language)
    };
    let meaning = terminal::inertia_explained(language);
    format!("{}\n{meaning}\nJ = {inertia} kgm², m = {mass} kg\n{centre}\n", table.render())
}
