"""Answers as text of at most 20 lines, and as HTML for a notebook."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from html import escape
from typing import Any, cast

from antrieb import _antrieb, _mathml
from antrieb._origin import language
from antrieb._record import INSIDE, Record, Rows, _columns, _flat, _names, _names_of, _rows  # pyright: ignore[reportPrivateUsage]

LINES = 20
"""Lines of a text."""

WIDTH = 100
"""Characters of a line."""

ROWS_OF_HTML = 40

Cells = list[list[str]]


@functools.cache
def words(lang: str) -> dict[str, str]:
    """The words of a language by their names."""
    return dict(_antrieb.labels(lang))


def number(value: Any, lang: str, digits: int = 4) -> str:
    """A number with so many digits, in German with a comma."""
    if not isinstance(value, (int, float)) or isinstance(value, bool):
        return "" if value is None else str(value)
    if isinstance(value, int) or not math.isfinite(value):
        return str(value)
    size = abs(value)
    text = f"{value:.{digits}g}" if size == 0 or 1e-4 <= size < 10**digits else f"{value:.0f}" if 1 <= size < 1e15 else f"{value:.{digits}g}"
    return text.replace(".", ",") if lang == "de" else text


def percent(value: Any, lang: str) -> str:
    """A utilisation in percent."""
    return "" if value is None else (f"{100 * value:.1f}".replace(".", ",") if lang == "de" else f"{100 * value:.1f}")


def cut(text: str, width: int = WIDTH) -> str:
    """A text of one line, shortened."""
    text = " ".join(text.split())
    return text if len(text) <= width else text[: width - 1] + "…"


def table(head: Sequence[str], rows: Cells, right: Sequence[bool]) -> list[str]:
    """The lines of a table."""
    whole = [list(head), *rows]
    wide = [max(len(row[at]) for row in whole) for at in range(len(head))]
    lines: list[str] = []
    for row in whole:
        cells = [cell.rjust(width) if is_right else cell.ljust(width) for cell, width, is_right in zip(row, wide, right, strict=True)]
        lines.append(cut_end("  ".join(cells)))
    lines.insert(1, cut_end("  ".join("─" * width for width in wide)))
    return lines


def cut_end(line: str) -> str:
    """A line without blanks at its end, shortened."""
    line = line.rstrip()
    return line if len(line) <= WIDTH else line[: WIDTH - 1] + "…"


# ---- what is shown of a record


class View:
    """Title, verdict and table of a record."""

    __slots__ = ("bars", "head", "lines", "more", "right", "rows", "title", "verdict")

    def __init__(
        self, title: str, verdict: str, lines: list[str], head: list[str], rows: Cells, right: list[bool], more: int, bars: list[tuple[str, float, str]]
    ) -> None:
        self.title, self.verdict, self.lines = title, verdict, lines
        self.head, self.rows, self.right, self.more, self.bars = head, rows, right, more, bars

    def text(self) -> str:
        """The text of the terminal."""
        lines = [cut(self.title), *(cut(line) for line in self.lines)]
        if self.rows:
            room = LINES - len(lines) - 4
            left = max(0, len(self.rows) - room)
            lines += ["", *table(self.head, self.rows[:room], self.right)]
            if left + self.more:
                lines.append(f"… {left + self.more}")
        return "\n".join(lines)

    def html(self) -> str:
        """The same for a notebook, with bars of the utilisation."""
        colour = {"fits": "#1a7f37", "pass": "#1a7f37", "does_not_fit": "#b42318", "fail": "#b42318"}.get(self.verdict, "#8a5a00")
        parts = [f'<div class="antrieb"><p><strong style="color:{colour}">{escape(self.title)}</strong>']
        parts.extend(f"<br>{escape(line)}" for line in self.lines if line)
        parts.append("</p>")
        if self.bars:
            parts.append(_bars(self.bars[:12]))
        if self.rows:
            parts.append(_html_table(self.head, self.rows[:ROWS_OF_HTML], self.right))
            left = max(0, len(self.rows) - ROWS_OF_HTML) + self.more
            if left:
                parts.append(f"<p>… {left}</p>")
        parts.append("</div>")
        return "".join(parts)


def is_open(check: Any) -> bool:
    """Returns true for a check without a value because a datum is missing; one without a limit of the project is none."""
    return check.verdict == "not_checked" and check.value is None and not _antrieb.is_limit(check.missing or "")


def standing(record: Any, lang: str, checks: Sequence[Any] | None = None) -> str:
    """The verdict on an actuator, and what is missing for its checks."""
    text = words(lang)[record.verdict]
    checks = getattr(record, "checks", None) if checks is None else checks
    if checks is None or record.verdict == "does_not_fit":
        return text
    missing = sum(map(is_open, checks))
    return text + _antrieb.missing_data(missing, len(checks), max(0, record.open_questions - missing), lang)


def _judged_best(record: Any) -> Any:
    """The actuator that the verdict of a sizing is about; other records are about themselves."""
    for each in (*getattr(record, "ranking", [])[:1], getattr(record, "own", None)):
        if each is not None and each.verdict == record.verdict and record.answer in (each.code, each.name):
            return each
    return record


def _sizing(record: Any, lang: str) -> View:
    word = words(lang)
    best = record.answer
    title = f"{record.axis}: {best}: {standing(_judged_best(record), lang)}" if best else f"{record.axis}: {word['none_fits']}"
    not_evaluated = getattr(record, "not_evaluated", None) or 0
    counts = f"{word['fits']}: {record.fit - not_evaluated} · {word['fits_if_estimate']}: {record.fit_if_estimate} · {word['candidates']}: {record.judged}"
    if not_evaluated:
        counts += f" · {word['not_evaluated']}: {not_evaluated}"
    lines = [counts]
    if not best and record.nearest_miss:
        lines.append(f"{word['nearest_miss']}: {record.nearest_miss}")
    if record.assumptions:
        lines.append(f"{word['assumptions']}: " + "; ".join(map(_assumption, record.assumptions)))
    rows: Cells = []
    bars: list[tuple[str, float, str]] = []
    shown: list[Any] = [*record.ranking] or [*record.rejected]
    for each in shown:
        tightest = getattr(each, "tightest", None) or getattr(each, "check", None) or ""
        titles = {check.id: check.title for check in getattr(each, "checks", [])}
        name = each.code or getattr(each, "name", None) or ""
        demand = getattr(each, "demand", None)
        rows.append([
            name,
            percent(each.utilisation, lang),
            titles.get(tightest, tightest),
            number(getattr(demand, "T_rms", None), lang),
            number(getattr(each, "mass_kg", None), lang, 3),
        ])
        if each.utilisation is not None:
            bars.append((name, each.utilisation, "fits" if record.ranking else "does_not_fit"))
    head = [word["code"], word["utilisation"], word["tightest"], "T_rms Nm", "m kg"]
    right = [False, True, False, True, True]
    if not record.ranking:
        # Of those that do not fit neither demand nor mass is listed.
        head, rows, right = head[:3], [row[:3] for row in rows], right[:3]
    of = record.fit + record.fit_if_estimate if record.ranking else record.judged
    return View(title, record.verdict, lines, head, rows, right, max(0, of - len(shown)), bars)


def _assumption(each: Any) -> str:
    """An assumption as key and value; one without a value with its reason."""
    return f"{each.key} = {each.value}" if each.key and each.value is not None else str(each.why)


def _importance(check: Any) -> tuple[bool, bool, bool, float]:
    """The place of a check: failing ones first, then those without a datum, as in the command line."""
    return check.verdict != "fail", not is_open(check), not check.margin, -(check.utilisation or 0.0)


def _judged(record: Any, lang: str) -> View:
    axis = getattr(record, "axis", None)
    name = record.code or record.name or ""
    title = ": ".join(part for part in (axis, name, standing(record, lang)) if part)
    order = sorted(record.checks, key=_importance)
    rows = [_check_row(check, lang) for check in order]
    bars = [(check.title, check.utilisation, check.verdict) for check in order if check.margin and check.utilisation is not None]
    # The actuator of a call without a code is an assumption.
    chosen = [each for each in getattr(record, "assumptions", []) if record.code and each.value == record.code]
    lines = [each.why for each in chosen]
    lines += record.objections
    return View(title, record.verdict, lines, _check_head(lang), rows, [False, False, True, True, False, True], 0, bars)


def _check_head(lang: str) -> list[str]:
    word = words(lang)
    return [word["check"], word["verdict"], word["value"], word["limit"], word["unit"], word["utilisation"]]


SIGNS = {"1": "", "degC": "°C", "ohm": "Ω", "1/min": "min⁻¹", "deg": "°"}
"""Units of records that have a sign of their own."""

POWERS = (("^-1", "⁻¹"), ("^-2", "⁻²"), ("^2", "²"), ("^3", "³"), ("^4", "⁴"))


def unit_sign(unit: str | None) -> str:
    """Returns a unit of a record as it is read: `kgm^2` as kgm², `1/min` as min⁻¹."""
    if unit is None:
        return ""
    found = SIGNS.get(unit, unit)
    for written, sign in POWERS:
        found = found.replace(written, sign)
    return found


def _check_row(check: Any, lang: str) -> list[str]:
    unit = unit_sign(check.unit)
    verdict = words(lang)[check.verdict] + (f": {check.missing}" if check.verdict == "not_checked" and check.missing else "")
    return [check.title, verdict, number(check.value, lang), number(check.limit, lang), unit, percent(check.utilisation, lang)]


def _check(record: Any, lang: str) -> View:
    row = _check_row(record, lang)
    title = f"{record.title}: {row[1]}" + (f", {row[5]} %" if row[5] else "")
    lines = [f"{row[2]} {row[4]} ({words(lang)['limit']} {row[3]} {row[4]})" if row[2] else "", record.source or "", *record.notes]
    return View(title, record.verdict, [line for line in lines if line.strip()], [], [], [], 0, [])


def _axes(record: Any, lang: str) -> View:
    word = words(lang)
    rows: Cells = []
    for each in record.axes:
        of = getattr(each, "answer", None) or getattr(each, "code", None) or ""
        shown = standing(_judged_best(each), lang) if getattr(each, "verdict", None) else ""
        best = each.ranking[0] if getattr(each, "ranking", None) else each
        share = getattr(best, "utilisation", None)
        rows.append([each.axis, of, shown, percent(share, lang)])
    verdicts = {getattr(each, "verdict", None) for each in record.axes}
    verdict = "does_not_fit" if "does_not_fit" in verdicts else next(iter(verdicts)) if len(verdicts) == 1 else "fits_if_estimate"
    head = [word["axis"], word["code"], word["verdict"], word["utilisation"]]
    return View(f"{len(rows)} × {word['axis']}", str(verdict), [], head, rows, [False, False, False, True], 0, [])


def _comparison(record: Any, lang: str) -> View:
    """Actuators side by side, a column for each."""
    word = words(lang)
    heads = list(record.candidates)
    names = [each.code for each in heads]
    lines = [
        f"{name}: {standing(each, lang, [row.answers[at] for row in record.checks if row.answers[at]])}"
        for at, (name, each) in enumerate(zip(names, heads, strict=True))
    ]
    rows: Cells = [[word["utilisation"], *(percent(each.utilisation, lang) for each in heads)]]
    order = sorted(record.checks, key=_importance_of_row)
    rows += [[row.title, *(_result(each, lang) for each in row.answers)] for row in order]
    rows += [[f"{row.symbol} {unit_sign(row.unit)}", *(number(value, lang) for value in row.values)] for row in [*record.demand, *record.data]]
    return View(record.axis, "", lines, [word["check"], *names], rows, [False] + [True] * len(names), 0, [])


def _importance_of_row(row: Any) -> tuple[bool, bool, float]:
    """The place of a check of several actuators: failing ones first, then the highest utilisation."""
    known = [each for each in row.answers if each is not None]
    shares = [each.utilisation for each in known if each.utilisation is not None]
    return all(each.verdict != "fail" for each in known), not any(each.margin for each in known), -max(shares, default=0.0)


def _result(check: Any, lang: str) -> str:
    """A check of a comparison: its utilisation, or its verdict."""
    if check is None:
        return "–"
    share, verdict = percent(check.utilisation, lang), words(lang)[check.verdict]
    return verdict if not share else share if check.verdict == "pass" else f"{verdict} {share}"


LINES_ABOVE = 7
"""Lines of fields above a table."""


def _any(record: Any, lang: str) -> View:
    listed = _listed(record)
    lines: list[str] = []
    for name in _names(type(record)):
        value = getattr(record, name)
        if value is None or value == [] or name == listed:
            continue
        lines.append(cut(f"  {name}: {_brief(value, lang)}"))
    most = LINES_ABOVE if listed else LINES - 2
    shown, left = lines[:most], len(lines) - most
    if left > 0:
        shown.append(f"  … {left}")
    entries: list[Any] = list(getattr(record, listed)) if listed else []
    head, rows, right = _table_of(entries, lang) if entries else ([], [], [])
    return View(type(record).__name__, str(getattr(record, "verdict", None) or ""), ["  " + line.strip() for line in shown], head, rows, right, 0, [])


def _table_of(entries: list[Any], lang: str) -> tuple[list[str], Cells, list[bool]]:
    """The table of a list: a row for each entry, or for each of what the entries hold, behind the name of the entry."""
    if type(entries[0]).__name__ == "Curve":
        peaks = [{**_flat(each), "points": len(each.points), "T": max((point[1] for point in each.points), default=None)} for each in entries]
        return _columns_view(_columns(peaks), lang)
    columns = _columns(_rows(entries))
    inside = INSIDE.get(type(entries[0]).__name__, "") + "."
    names = [name for name in columns if name.startswith(inside)]
    if not names:
        return _columns_view(columns, lang)
    if f"{inside}title" in names:
        names = [name for name in names if name != f"{inside}id"]
    first = next(name for name in columns if not name.startswith(inside))
    order = {name: place for place, name in enumerate(FIRST)}
    names.sort(key=lambda name: order.get(name.removeprefix(inside), len(FIRST)))
    return _columns_view({first: columns[first], **{name.removeprefix(inside): columns[name] for name in names}}, lang, False)


FIRST = ("title", "symbol", "name", "pin", "signal", "verdict", "value", "unit", "limit")
"""Columns of what the entries of a list hold that are shown first."""


TABLES = {"Wiring": "connectors", "Upkeep": "plan"}
"""Lists that a table shows although another list is longer."""


def _listed(record: Any) -> str:
    """The list of a record that its table shows: the longest one of records; empty without one."""
    if getattr(record, TABLES.get(type(record).__name__, ""), None):
        return TABLES[type(record).__name__]
    fields: dict[str, Any] = {name: getattr(record, name) for name in _names(type(record))}
    lists: dict[str, list[Any]] = {name: value for name, value in fields.items() if isinstance(value, list)}
    lengths = {name: len(value) for name, value in lists.items() if value and all(isinstance(each, Record) for each in value)}
    return max(lengths, key=lambda name: lengths[name]) if lengths else ""


def _brief(value: Any, lang: str) -> str:
    values: Any = value
    if isinstance(value, Record):
        names = _names_of(value)
        figures = [f"{name} {number(each, lang)}" for name, each in _flat(value).items() if isinstance(each, (float, bool, int))]
        return " · ".join([*names[:1], *figures[:4]]) or type(value).__name__
    if isinstance(value, list):
        if values and isinstance(values[0], Record):
            return f"{len(values)} × {type(values[0]).__name__}: " + ", ".join((_names_of(each) or ["…"])[0] for each in values[:6])
        return ", ".join(_brief(each, lang) for each in values[:12]) + (f", … {len(values) - 12}" if len(values) > 12 else "")
    if isinstance(value, dict):
        pairs = list(cast("dict[str, Any]", value).items())[:8]
        return ", ".join(f"{key} {_brief(each, lang)}" for key, each in pairs)
    return number(value, lang) if isinstance(value, float) else str(value)


VIEWS: dict[str, Callable[[Any, str], View]] = {
    "Sizing": _sizing,
    "Judgement": _judged,
    "Ranked": _judged,
    "Assessed": _judged,
    "Check": _check,
    "Comparison": _comparison,
}


def _view(record: Any) -> View:
    lang, name = language(record), type(record).__name__
    if name.startswith("AxesOf"):
        return _axes(record, lang)
    return VIEWS.get(name, _any)(record, lang)


def text(record: Any) -> str:
    """A record in at most 20 lines."""
    if type(record).__name__ == "Explanations" and len(record.checks) > 1:
        return "\n".join([f"{record.axis}: {record.code}", *text_of_rows(record.checks).split("\n")[: LINES - 1]])
    if (whole := _trees(record)) is not None:
        lines = whole.split("\n")
        left = len(lines) - LINES + 1
        return "\n".join(lines if left <= 1 else [*lines[: LINES - 1], f"… {left}: print(…)"])
    return _view(record).text()


def full(record: Any) -> str:
    """A record as `print` shows it: of a derivation the whole tree."""
    whole = _trees(record)
    return text(record) if whole is None else whole


def html(record: Any) -> str:
    """A record in a notebook."""
    shown = _explained(record)
    if shown is None:
        return _view(record).html()
    title, checks = shown
    return (f"<p>{escape(title)}</p>" if title else "") + "".join(map(_html_tree, checks))


def _explained(record: Any) -> tuple[str, list[Any]] | None:
    """The derivations that a record is made of, and its title; `None` for other records, and for those of several axes."""
    if type(record).__name__ == "Explained":
        return "", [record]
    if type(record).__name__ == "Explanations":
        return f"{record.axis}: {record.code}", list(record.checks)
    return None


def _trees(record: Any) -> str | None:
    """The derivations of a record as trees; `None` for other records."""
    shown = _explained(record)
    if shown is None:
        return None
    title, checks = shown
    return "\n".join([*([title] if title else []), *map(tree, checks)])


def html_of_section(name: str, document: Mapping[str, Any]) -> str:
    """A project or a part of it in a notebook: a row for each key."""
    rows = [[path, str(value)] for path, value in _keys(document, "")]
    left = len(rows) - LINES
    shown = rows if left <= 0 else [*rows[:LINES], ["…", str(left)]]
    return f'<div class="antrieb"><p><strong>{escape(name)}</strong></p>{_html_table(["", ""], shown, [False, False])}</div>'


def _keys(document: Any, path: str) -> Iterator[tuple[str, Any]]:
    """The keys of a project with their values."""
    for key, value in document.items():
        own = f"{path}.{key}" if path else key
        entries: list[Any] = [*value] if isinstance(value, list) else []
        if isinstance(value, Mapping):
            yield from _keys(value, own)
        elif entries and all(isinstance(each, Mapping) for each in entries):
            for place, each in enumerate(entries, 1):
                yield from _keys(each, f"{own}[{place}]")
        elif own != "format":
            yield own, value


# ---- lists of records

COLUMNS = 6


def _rows_view(rows: Any) -> tuple[list[str], Cells, list[bool]]:
    lang = next((language(each) for each in rows), "en")
    if rows and all(type(each).__name__ in ("Check", "Explained") for each in rows):
        return _check_head(lang), [_check_row(each, lang) for each in rows], [False, False, True, True, False, True]
    return _columns_view(rows._columns(), lang)


def _columns_view(columns: Mapping[str, list[Any]], lang: str, is_sorted: bool = True) -> tuple[list[str], Cells, list[bool]]:
    """Heads, cells and alignment of the first columns that have values."""
    names = [name for name, values in columns.items() if any(value is not None for value in values)]
    # The first column names the row.
    if is_sorted:
        names.sort(key=lambda name: (name not in ("id", "code", "name", "axis", "key", "symbol"),))
    names = names[:COLUMNS]
    is_number = [all(value is None or isinstance(value, (int, float)) for value in columns[name]) for name in names]
    count = max((len(values) for values in columns.values()), default=0)
    cells = [[cut(number(columns[name][at], lang), 32) for name in names] for at in range(count)]
    return names, cells, is_number


def text_of_rows(rows: Any) -> str:
    """A list of records in at most 20 lines."""
    if not rows:
        return "[]"
    if not all(isinstance(each, Record) for each in rows):
        return cut(str([*rows]), 2 * WIDTH)
    head, cells, right = _rows_view(rows)
    room = LINES - 3
    lines = table(head, cells[:room], right)
    if len(cells) > room:
        lines.append(f"… {len(cells) - room}")
    return "\n".join(lines)


def _fields_view(fields: Mapping[str, Any]) -> tuple[list[str], Cells, list[bool]]:
    lang = next((language(each) for each in fields.values()), "en")
    return _columns_view(_columns([{"id": name, **_flat(each)} for name, each in fields.items()]), lang)


def text_of_fields(fields: Mapping[str, Any]) -> str:
    """Records by their names in at most 20 lines."""
    head, cells, right = _fields_view(fields)
    room = LINES - 3
    return "\n".join([*table(head, cells[:room], right), *([f"… {len(cells) - room}"] if len(cells) > room else [])])


def html_of_fields(fields: Mapping[str, Any]) -> str:
    """Records by their names in a notebook."""
    head, cells, right = _fields_view(fields)
    more = f"<p>… {len(cells) - ROWS_OF_HTML}</p>" if len(cells) > ROWS_OF_HTML else ""
    return _html_table(head, cells[:ROWS_OF_HTML], right) + more


def html_of_rows(rows: Any) -> str:
    """A list of records in a notebook."""
    if not rows or not all(isinstance(each, Record) for each in rows):
        return escape(text_of_rows(rows))
    head, cells, right = _rows_view(rows)
    more = f"<p>… {len(cells) - ROWS_OF_HTML}</p>" if len(cells) > ROWS_OF_HTML else ""
    return _html_table(head, cells[:ROWS_OF_HTML], right) + more


def _html_table(head: Sequence[str], rows: Cells, right: Sequence[bool]) -> str:
    align = ["right" if each else "left" for each in right]

    def of(tag: str, row: Sequence[str]) -> str:
        cells = zip(row, align, strict=True)
        return "".join(f'<{tag} style="text-align:{side}">{escape(cell)}</{tag}>' for cell, side in cells)

    body = "".join(f"<tr>{of('td', row)}</tr>" for row in rows)
    return f"<table><thead><tr>{of('th', head)}</tr></thead><tbody>{body}</tbody></table>"


def _bars(bars: Sequence[tuple[str, float, str]]) -> str:
    """Bars of utilisations with the limit as a line."""
    colours = {"fits": "#2f7d4f", "pass": "#2f7d4f", "fail": "#b42318", "does_not_fit": "#b42318"}
    left, wide, high = 210, 300, 18
    most = max(1.25, min(2.0, max(share for _, share, _ in bars)))
    at = left + wide / most
    height = high * len(bars) + 8
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{left + wide + 60}" height="{height}" font-family="sans-serif" font-size="12" role="img">'
    ]
    for place, (name, share, verdict) in enumerate(bars):
        y = high * place + 4
        width = wide * min(max(share, 0.0), most) / most
        parts.append(f'<text x="{left - 8}" y="{y + 12}" text-anchor="end" fill="currentColor">{escape(cut(name, 30))}</text>')
        parts.append(f'<rect x="{left}" y="{y + 2}" width="{width:.1f}" height="{high - 5}" fill="{colours.get(verdict, "#b8860b")}"/>')
        parts.append(f'<text x="{left + width + 5:.1f}" y="{y + 12}" fill="currentColor">{100 * share:.1f} %</text>')
    parts.append(f'<path d="M{at:.1f} 0V{height}" stroke="currentColor" stroke-dasharray="3 3"/></svg>')
    return "".join(parts)


# ---- derivations


def _amount(node: Any, lang: str) -> str:
    sign = unit_sign(node.unit)
    unit = f" {sign}" if sign else ""
    return number(node.value, lang, 6) + unit


def _trust(node: Any, lang: str) -> str:
    word = words(lang)
    if node.repeated:
        return word["see_above"]
    return ", ".join(part for part in (word.get(node.grade or "", node.grade or ""), node.source) if part)


def tree(record: Any) -> str:
    """The derivation of a check as a tree."""
    lang = language(record)
    lines = _check(record, lang).text().split("\n")[:1]
    for word, root in (("required", record.derivation.value), ("permitted", record.derivation.limit)):
        if root is not None:
            lines.append(f"  {words(lang)[word]}")
            _branch(root, "    ", lines, lang)
    lines.extend(f"  {note}" for note in record.notes)
    return "\n".join(lines)


def _branch(node: Any, indent: str, lines: list[str], lang: str) -> None:
    term = f"  {node.term}" if node.term else ""
    lines.append(f"{indent}{_antrieb.symbol(node.symbol)} = {_amount(node, lang)}{term}  [{_trust(node, lang)}]")
    if not node.repeated:
        lines.extend(f"{indent}  = {each}" for each in (node.formula, node.figures) if each)
    operands: list[Any] = node.operands or []
    for each in operands:
        _branch(each, indent + "    ", lines, lang)


def _html_tree(record: Any) -> str:
    lang = language(record)
    parts = [f'<div class="antrieb"><p><strong>{escape(_check(record, lang).title)}</strong></p>']
    for word, root in (("required", record.derivation.value), ("permitted", record.derivation.limit)):
        if root is not None:
            parts.append(f"<p>{escape(words(lang)[word])}</p>")
            _html_branch(root, parts, lang, True)
    parts.extend(f"<p>{escape(note)}</p>" for note in record.notes)
    return "".join(parts) + "</div>"


def _html_branch(node: Any, parts: list[str], lang: str, is_open: bool) -> None:
    symbol = _mathml.math(_antrieb.symbol(node.symbol))
    head = f"{symbol} = {escape(_amount(node, lang))} {escape(node.term or '')} <small>[{escape(_trust(node, lang))}]</small>"
    formula = "" if node.repeated or not node.formula else f"<div>= {_mathml.math(node.formula)}</div>"
    figures = "" if node.repeated or not node.figures else f"<div>= {escape(node.figures)}</div>"
    if not (formula or figures or node.operands):
        parts.append(f'<div style="margin-left:1.5em">{head}</div>')
        return
    opened = ' open=""' if is_open else ""
    parts.append(f'<details style="margin-left:1em"{opened}><summary>{head}</summary>{formula}{figures}')
    operands: list[Any] = node.operands or []
    for each in operands:
        _html_branch(each, parts, lang, False)
    parts.append("</details>")


__all__ = ["Rows", "full", "html", "html_of_rows", "text", "text_of_rows", "tree"]
