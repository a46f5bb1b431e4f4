//! The template, embedded in the program.

/// Name and text of every source file.
pub(crate) const FILES: &[(&str, &str)] = &[
    ("main.typ", include_str!("../template/main.typ")),
    ("line-breaks.typ", LINE_BREAKS),
    ("symbols.typ", SYMBOLS),
    ("style.typ", include_str!("../template/style.typ")),
    ("cover.typ", include_str!("../template/cover.typ")),
    ("inputs.typ", include_str!("../template/inputs.typ")),
    ("mechanism.typ", include_str!("../template/mechanism.typ")),
    ("motion.typ", include_str!("../template/motion.typ")),
    ("data-sheet.typ", include_str!("../template/data-sheet.typ")),
    ("checks.typ", include_str!("../template/checks.typ")),
    ("tolerances.typ", include_str!("../template/tolerances.typ")),
    ("alternatives.typ", include_str!("../template/alternatives.typ")),
    ("build.typ", include_str!("../template/build.typ")),
    ("laid-out.typ", include_str!("../template/laid-out.typ")),
    ("sources.typ", include_str!("../template/sources.typ")),
];

/// Name and text of every source file of the checklists, which are a separate document.
pub(crate) const CHECKLIST: &[(&str, &str)] = &[
    ("line-breaks.typ", LINE_BREAKS),
    ("symbols.typ", SYMBOLS),
    ("checklist.typ", include_str!("../template/checklist.typ")),
];

const LINE_BREAKS: &str = include_str!("../template/line-breaks.typ");
const SYMBOLS: &str = include_str!("../template/symbols.typ");

#[cfg(test)]
mod tests {
    use super::*;
    use quantities::Language;
    use std::collections::BTreeSet;

    /// Returns the keys of the words in a template, which uses them only as `t("key")` with a literal key.
    fn asked(text: &str) -> BTreeSet<&str> {
        let code =
            text.lines().map(|line| line.split(" // ").next().unwrap_or(line)).filter(|line| !line.starts_with("//"));
        let mut keys = BTreeSet::new();
        for line in code.filter(|line| !line.starts_with("#let t(key)")) {
            for (at, _) in line.match_indices("t(") {
                let before = line.get(..at).unwrap_or_default();
                if before.ends_with(|sign: char| sign.is_alphanumeric() || matches!(sign, '-' | '_' | '.')) {
                    continue;
                }
                let key =
                    line.get(at + 2..).and_then(|rest| rest.strip_prefix('"')).and_then(|rest| rest.split_once("\")"));
                let key = key
                    .map(|(key, _)| key)
                    .filter(|key| key.bytes().all(|byte| byte == b'_' || byte.is_ascii_alphanumeric()));
                assert!(key.is_some(), "asked for without a plain key: {line}");
                keys.extend(key);
            }
        }
        keys
    }

    #[test]
    fn the_template_asks_for_every_word_that_there_is_and_for_no_other() {
        let asked: BTreeSet<&str> = FILES.iter().flat_map(|(_, text)| asked(text)).collect();
        for language in Language::ALL {
            let words = words::report::words(language);
            let given: BTreeSet<&str> = words.keys().copied().collect();
            assert_eq!(given.difference(&asked).collect::<Vec<_>>(), Vec::<&&str>::new(), "given and never used");
            assert_eq!(asked.difference(&given).collect::<Vec<_>>(), Vec::<&&str>::new(), "asked for and not given");
        }
        assert!(asked.len() > 150, "{}", asked.len());
    }

    #[test]
    fn a_key_is_found_wherever_it_is_asked_for() {
        assert_eq!(asked("#t(\"a\") and (t(\"b_2\"), insert(c), note(t(\"d\"))"), BTreeSet::from(["a", "b_2", "d"]));
    }

    #[test]
    #[should_panic(expected = "without a plain key")]
    fn a_key_that_is_made_up_is_refused() {
        let _ = asked("#t(\"v_\" + verdict)");
    }
}
