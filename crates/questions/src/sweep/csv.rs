//! Lines of a table in CSV: commas, cells in quotation marks where they hold a comma.

use std::borrow::Cow;

/// The cells of a line without its end; `None` where a quoted cell does not end.
#[must_use]
pub fn cells(line: &str) -> Option<Vec<Cow<'_, str>>> {
    let mut cells = Vec::new();
    let mut rest = line;
    loop {
        let (cell, behind) = match rest.strip_prefix('"') {
            None => {
                let (cell, behind) = rest.split_once(',').map_or((rest, None), |(cell, behind)| (cell, Some(behind)));
                (Cow::Borrowed(cell), behind)
            }
            Some(quoted) => {
                let end = end_of_quoted(quoted)?;
                let cell = quoted.get(..end)?.replace("\"\"", "\"");
                let behind = quoted.get(end + 1..)?;
                // What stands between the quotation mark and the comma belongs to no cell.
                (Cow::Owned(cell), behind.split_once(',').map(|(_, behind)| behind))
            }
        };
        cells.push(cell);
        match behind {
            Some(behind) => rest = behind,
            None => return Some(cells),
        }
    }
}

/// Where a quoted cell ends: at a quotation mark that is not doubled.
fn end_of_quoted(quoted: &str) -> Option<usize> {
    let mut from = 0;
    loop {
        let at = from + quoted.get(from..)?.find('"')?;
        if quoted.get(at + 1..)?.starts_with('"') {
            from = at + 2;
        } else {
            return Some(at);
        }
    }
}

/// A cell as it is written in a line.
#[must_use]
pub fn written(cell: &str) -> Cow<'_, str> {
    if cell.contains([',', '"', '\n', '\r']) {
        Cow::Owned(format!("\"{}\"", cell.replace('"', "\"\"").replace(['\n', '\r'], " ")))
    } else {
        Cow::Borrowed(cell)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_are_read_as_they_are_written() {
        for row in [vec!["a", "", "b c"], vec!["1,5", "say \"so\"", ""], vec![""], vec!["\"", ",", "x"]] {
            let line: Vec<_> = row.iter().map(|cell| written(cell)).collect();
            assert_eq!(cells(&line.join(",")).unwrap(), row);
        }
        assert_eq!(cells("a,\"open"), None);
        assert_eq!(cells("\"a\" ,b").unwrap(), ["a", "b"]);
    }
}
