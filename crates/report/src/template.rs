//! The template, as part of the program.

/// Name and text of every source file.
pub(crate) const FILES: &[(&str, &str)] = &[
    ("main.typ", include_str!("../template/main.typ")),
    ("style.typ", include_str!("../template/style.typ")),
    ("words.typ", include_str!("../template/words.typ")),
    ("cover.typ", include_str!("../template/cover.typ")),
    ("inputs.typ", include_str!("../template/inputs.typ")),
    ("mechanism.typ", include_str!("../template/mechanism.typ")),
    ("sketches.typ", include_str!("../template/sketches.typ")),
    ("motion.typ", include_str!("../template/motion.typ")),
    ("checks.typ", include_str!("../template/checks.typ")),
    ("tolerances.typ", include_str!("../template/tolerances.typ")),
    ("alternatives.typ", include_str!("../template/alternatives.typ")),
    ("build.typ", include_str!("../template/build.typ")),
    ("sources.typ", include_str!("../template/sources.typ")),
];
