//! Conditions that every HTML page must satisfy.

use std::collections::BTreeMap;

/// Elements without an end tag.
const VOID: [&str; 6] = ["input", "meta", "link", "br", "hr", "img"];

/// Checks that the tags of a page are closed in order, identifiers are unique, and attributes are quoted.
///
/// # Panics
/// With the place of the first violation.
#[allow(clippy::panic, reason = "a test that uses it must fail")]
pub fn whole(html: &str) {
    let mut open: Vec<&str> = Vec::new();
    let mut ids: BTreeMap<&str, usize> = BTreeMap::new();
    let mut rest = html;
    let start = |text: &str| text.chars().take(120).collect::<String>();
    while let Some((_, tag)) = rest.split_once('<') {
        let Some((inside, behind)) = tag.split_once('>') else { panic!("no end: {}", start(tag)) };
        rest = behind;
        if inside.starts_with('!') {
            continue;
        }
        if let Some(name) = inside.strip_prefix('/') {
            assert_eq!(open.pop(), Some(name), "{}", start(rest));
            continue;
        }
        let name = inside.split([' ', '/', '\n']).next().unwrap_or_default();
        if let Some(id) = inside.split(" id=\"").nth(1).and_then(|id| id.split('"').next()) {
            *ids.entry(id).or_default() += 1;
        }
        assert_eq!(inside.matches('"').count() % 2, 0, "{inside}");
        if !VOID.contains(&name) && !inside.ends_with('/') {
            open.push(name);
        }
    }
    assert!(open.is_empty(), "{open:?}");
    let twice: Vec<_> = ids.iter().filter(|(_, count)| **count > 1).collect();
    assert!(twice.is_empty(), "{twice:?}");
}

#[cfg(test)]
mod tests {
    use super::whole;

    #[test]
    fn what_is_not_whole_is_found() {
        whole("<!DOCTYPE html><p id=\"a\">b<br><svg><path d=\"M0\"/></svg></p>");
        for broken in ["<p", "<p>", "<p></div>", "<p id=\"a></p>", "<p id=\"a\"></p><p id=\"a\"></p>"] {
            assert!(std::panic::catch_unwind(|| whole(broken)).is_err(), "{broken}");
        }
    }
}
