"""What pictures show as arrays: lines, points and bars with labels and units, for Matplotlib and whatever else draws."""

# Answers have no types here until they are looked at; the classes of one package share what is private.
# pyright: reportUnknownVariableType=false, reportUnknownMemberType=false, reportUnknownArgumentType=false
# pyright: reportPrivateUsage=false

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable, Iterator, Mapping
from typing import Any, Literal

from antrieb._origin import language
from antrieb._record import Record, Rows, Tabular

Kind = Literal["line", "points", "bars"]
"""How the values are drawn: joined, each by itself, or as bars whose names are `x`."""


@dataclasses.dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Line(Record):
    """A line of a picture as two arrays: `ax.plot(*line, label=line.name)`, `ax.set(**line.axes)`, or `line.draw(ax)`."""

    name: str
    """Name for a legend."""
    kind: Kind
    """`line`, `points` or `bars`."""
    x: list[Any]
    """Abscissas; names of bars."""
    y: list[float]
    """Ordinates; NaN where there is none."""
    x_label: str
    """Label of the abscissa with its unit."""
    y_label: str
    """Label of the ordinate with its unit."""
    x_unit: str | None = None
    """Unit of the abscissas; `None` for names."""
    y_unit: str | None = None
    """Unit of the ordinates; `1` for a ratio."""

    def __iter__(self) -> Iterator[list[Any]]:
        return iter((self.x, self.y))

    @property
    def axes(self) -> dict[str, str]:
        """The labels of the axes, as `Axes.set` of Matplotlib takes them."""
        return {"xlabel": self.x_label, "ylabel": self.y_label}

    def draw(self, ax: Any, **style: Any) -> Any:
        """Draw it into axes of Matplotlib, with the labels of the axes; `style` is handed over to `plot` or `barh`."""
        style = {"label": self.name, **style}
        if self.kind == "bars":
            ax.set(xlabel=self.y_label, ylabel=self.x_label)
            return ax.barh(self.x, self.y, **style)
        if self.kind == "points":
            style = {"linestyle": "none", "marker": "o", **style}
        ax.set(**self.axes)
        return ax.plot(self.x, self.y, **style)


@dataclasses.dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Grid(Record):
    """A column of a sweep over two others: `ax.pcolormesh(*grid)`, `ax.contourf(*grid)`, or `grid.draw(ax)`."""

    name: str
    """Name of the column."""
    x: list[Any]
    """Values of the first column."""
    y: list[Any]
    """Values of the second column."""
    z: list[list[Any]]
    """A row for each value of `y`; NaN, for texts `None`, where the sweep has no answer."""
    x_label: str
    """Heading of the first column with its unit."""
    y_label: str
    """Heading of the second column with its unit."""
    z_label: str
    """Heading of the values."""

    def __iter__(self) -> Iterator[list[Any]]:
        return iter((self.x, self.y, self.z))

    @property
    def axes(self) -> dict[str, str]:
        """The labels of the axes, as `Axes.set` of Matplotlib takes them."""
        return {"xlabel": self.x_label, "ylabel": self.y_label}

    def draw(self, ax: Any, **style: Any) -> Any:
        """Draw it into axes of Matplotlib, with the labels of the axes; `style` is handed over to `pcolormesh`."""
        ax.set(**self.axes, title=self.z_label)
        return ax.pcolormesh(self.x, self.y, self.z, **{"shading": "nearest", **style})


def _line(name: str, x: Any, y: Any, x_of: tuple[str, str | None], y_of: tuple[str, str | None], kind: Kind = "line") -> Line:
    labels = [f"{label} [{unit}]" if unit not in (None, "", "1") and unit not in label else label for label, unit in (x_of, y_of)]
    xs: list[Any] = [math.nan if each is None else each for each in x]
    ys: list[float] = [math.nan if each is None else each for each in y]
    return Line(name=name, kind=kind, x=xs, y=ys, x_label=labels[0], y_label=labels[1], x_unit=x_of[1], y_unit=y_of[1])


def of_answer(record: Any) -> Rows[Line]:
    """The arrays of an answer.

    Raises:
        TypeError: No picture shows it.
    """
    kind = type(record).__name__
    if kind == "Curves":
        return Rows(_curves(record))
    if kind == "Curve":
        return Rows(_curve(record, ("n", None), ("T", None)))
    if kind == "Torsion":
        return Rows(_torsion(record, record.torque))
    if isinstance(record, Tabular) and "time" in record.columns.keys():  # type: ignore[attr-defined]
        return Rows(_course(record))
    if kind in ("Judgement", "Ranked", "Assessed"):
        return Rows([_bars(record)])
    raise TypeError(
        f"{kind} is no picture; arrays() is of plot(…), check(…), curve(…), torsion(…), export(…, table='course') and "
        "simulate(…, format='svg')"
    )


def _curves(record: Any) -> list[Line]:
    units = record.units
    return [line for each in record.curves for line in _curve(each, ("n", units.get("n")), ("T", units.get("T")))]


def _curve(record: Any, x_of: tuple[str, str | None], y_of: tuple[str, str | None]) -> list[Line]:
    # Several limits have one title at different voltages.
    name = record.title if record.voltage is None else f"{record.title}, {record.voltage:.4g} V"
    edges = [(name, record.points), (f"{name} (+)", record.upper)]
    return [
        _line(title, [point[0] for point in points], [point[1] for point in points], x_of, y_of) for title, points in edges if points
    ]


def _course(record: Any) -> list[Line]:
    columns: list[Any] = list(record.columns)
    time: Any = next(each for each in columns if each.name == "time")
    return [
        _line(each.name, record["time"], record[each.name], (time.title, time.unit), (each.title, each.unit))
        for each in columns
        if each.name != "time" and any(isinstance(value, float) for value in record[each.name])
    ]


def _bars(record: Any) -> Line:
    from antrieb._shown import _importance, words

    shown: list[Any] = [each for each in sorted(record.checks, key=_importance) if each.utilisation is not None and each.margin]
    word = words(language(record))
    titles, shares = [each.title for each in shown], [100 * each.utilisation for each in shown]
    return _line(record.code or "", titles, shares, (word["check"], None), (word["utilisation"], "%"), "bars")


def _torsion(record: Any, torque: float | None) -> list[Line]:
    """The curve in both directions, to 1.15 times its last corner or the torque, as the picture has it."""
    ends = [0.0, record.T_1, record.T_2, 1.15 * max(abs(torque or 0.0), record.T_2)]
    torques, angles = [0.0], [0.0]
    for place, stiffness in enumerate(record.K):
        torques.append(ends[place + 1])
        angles.append(angles[-1] + (ends[place + 1] - ends[place]) / stiffness)
    scale = 60 * 180 / math.pi
    both = [-each for each in torques[:0:-1]] + torques, [-each * scale for each in angles[:0:-1]] + [each * scale for each in angles]
    x_of, y_of = ("T", record.units.get("T")), ("φ", "arcmin")
    lines = [_line("torsion", *both, x_of, y_of)]
    if torque is not None and record.angle_arcmin is not None:
        lines.append(_line("point", [torque], [record.angle_arcmin], x_of, y_of, "points"))
    return lines


# ---- pictures


class Drawn:
    """The call that a picture comes from."""

    def __init__(self, command: str, text: Any, given: Mapping[str, Any], lang: str, named: Mapping[str, Any]) -> None:
        self.command, self.text, self.given, self.lang, self.named = command, text, given, lang, named

    def asked(self, question: str, **given: Any) -> Any:
        """The answer to a question about the same project."""
        from antrieb import questions

        ask: Any = getattr(questions, question)
        axis = {"axis": self.given["axis"]} if self.given.get("axis") else {}
        return ask(self.text, code=self.given.get("code"), lang=self.lang, **axis, **self.named, **given)

    def svg(self) -> str:
        """The picture drawn anew."""
        from antrieb import questions

        ask: Any = getattr(questions, self.command)
        drawn = ask(self.text, lang=self.lang, **self.named, **{name.replace("-", "_"): value for name, value in self.given.items()})
        return str(drawn.svg)


def of_picture(svg: str, drawn: Drawn | None) -> Rows[Line]:
    """The arrays of a picture.

    Raises:
        TypeError: Its data are in no answer.
        ValueError: The project has changed since it was drawn.
    """
    if drawn is None:
        raise TypeError("the picture was not drawn by plot or simulate; its data are with its maker")
    figure = drawn.given.get("figure") or "simulation"
    make = FIGURES.get(figure)
    if make is None:
        raise TypeError(f"the data of {figure} are no arrays of an answer: {OTHERS[figure]}")
    lines = make(drawn)
    if drawn.svg() != svg:
        raise ValueError("the project has changed since the picture was drawn; draw it again")
    return Rows(lines)


def _only(answer: Any) -> Any:
    return answer.axes[0]


def _plane(drawn: Drawn) -> list[Line]:
    judged = _only(drawn.asked("check"))
    n_of, t_of = ("n", "1/min"), ("T", "Nm")
    if not judged.code:
        raise TypeError(
            "the limits of an actuator of the project's own are no arrays of an answer: antrieb.check(…) has them, "
            "antrieb.export(…, table='course') has the cycle"
        )
    from antrieb import questions

    # The limits are those at the terminals, of which the check of the voltage has what the supply leaves.
    terminal: Any = next((each.limit for each in judged.checks if each.id == "voltage"), None)
    voltage = {} if terminal is None else {"voltage": f"{terminal!r} V"}
    ask: Any = questions.curve
    lines = _curves(ask(judged.code, lang=drawn.lang, **voltage))
    course = drawn.asked("export", table="course")
    lines.append(_line("cycle", course["speed"], course["torque"], n_of, t_of))
    demand = judged.demand
    if demand is not None:
        lines.append(_line("mean", [demand.n_av], [demand.T_rms], n_of, t_of, "points"))
    return lines


def _gear(drawn: Drawn) -> list[Line]:
    from antrieb import questions

    judged = _only(drawn.asked("check"))
    if not judged.code:
        raise TypeError("the torsion of an actuator of the project's own is no array of an answer: its stiffness is stated in the project")
    ask: Any = questions.torsion
    return _torsion(ask(judged.code, lang=drawn.lang, torque="0 N m"), None)


def _course_of(drawn: Drawn) -> list[Line]:
    return _course(drawn.asked("export", table="course"))


def _bars_of(drawn: Drawn) -> list[Line]:
    return [_bars(_only(drawn.asked("check")))]


def _map(drawn: Drawn) -> list[Line]:
    from antrieb._shown import words

    # The map shows every actuator, also those that a table of the best leaves out.
    table = drawn.asked("export", table="candidates", top=65535)
    by = drawn.given.get("by") or "mass"
    of: Any = table.columns[by]
    word = words(drawn.lang)
    kinds: dict[str, tuple[list[float], list[float]]] = {}
    for row in table:
        if row[by] is None or row["margin"] is None:
            continue
        xs, ys = kinds.setdefault(str(row["verdict"]), ([], []))
        xs.append(row[by])
        ys.append(100 * row["margin"])
    x_of, y_of = (of.title, of.unit), (table.columns["margin"].title, "%")
    return [_line(word.get(name, name), xs, ys, x_of, y_of, "points") for name, (xs, ys) in kinds.items()]


def _run(drawn: Drawn) -> list[Line]:
    given = {name.replace("-", "_"): value for name, value in drawn.given.items() if name not in ("figure", "theme", "width", "height", "axis", "code")}
    text: str = drawn.asked("simulate", **{**given, "format": "csv"})
    head, *rows = [line.split(",") for line in text.splitlines()]
    columns = [[float(cell) if cell else math.nan for cell in column] for column in zip(*rows, strict=True)]
    found: list[Line] = []
    for heading, values in zip(head[1:], columns[1:], strict=True):
        name = next((signal for signal in _signals() if heading == signal or heading.startswith(f"{signal}_")), heading)
        unit = UNITS.get(heading[len(name) + 1 :], heading[len(name) + 1 :] or None)
        found.append(_line(name, columns[0], values, ("t", "s"), (name.replace("_", " "), unit)))
    return found


def _signals() -> list[str]:
    """The signals of a run, longer names first."""
    import typing

    from antrieb import answers, questions

    hints = typing.get_type_hints(questions.simulate, {**vars(questions), "answers": answers})["signals"]
    literal = typing.get_args(hints)[0]
    return sorted(typing.get_args(literal), key=len, reverse=True)


UNITS = {"rad": "rad", "rad_s": "rad/s", "rad_s2": "rad/s^2", "nm": "N m", "a": "A", "v": "V", "degc": "degC"}
"""Units by the endings of the headings of a trace."""

FIGURES: dict[str, Callable[[Drawn], list[Line]]] = {
    "torque_speed": _plane,
    "cycle": _course_of,
    "utilisation": _bars_of,
    "candidate_map": _map,
    "simulation": _run,
    "torsion": _gear,
}

OTHERS = {
    "bearing_load": "antrieb.check(…) has the largest loads with their limits, bearing_radial, bearing_axial, bearing_tilting_moment",
    "control_loops": "antrieb.simulate(…).loops has the bandwidths and margins",
}
"""Pictures without arrays, and where their figures are."""
