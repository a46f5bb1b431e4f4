"""A heat map as SVG, in the style of the other pictures: a cell for each pair of values, lines where its name changes."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence
from html import escape

from antrieb._call import Picture

_WIDTH, _HEIGHT = 623.62, 434.65  # 165 × 115 mm
_LEFT, _RIGHT, _TOP, _BOTTOM = 52.0, 520.0, 40.0, 380.0
_INK, _GREY = "#1d2127", "#d5d9de"
# From few to many: light to dark, so that it can be read without colours.
_COLOURS = ((237, 244, 251), (158, 199, 233), (66, 133, 193), (8, 61, 119))


@dataclasses.dataclass(frozen=True, kw_only=True)
class Axis:
    """The values along an axis, in equal steps, and what they are."""

    label: str
    values: Sequence[float]

    def edges(self) -> tuple[float, float]:
        """From where to where its cells reach."""
        half = (self.values[-1] - self.values[0]) / (len(self.values) - 1) / 2
        return self.values[0] - half, self.values[-1] + half


def drawn(
    title: str,
    x: Axis,
    y: Axis,
    counts: Sequence[Sequence[int]],
    names: Sequence[Sequence[str]],
    *,
    legend: str,
    none: str,
    comma: bool = False,
) -> Picture:
    """The picture of `counts` over the values of two axes, a row for each value of `y`; cells of one name are outlined together."""
    most = max(1, *(max(row) for row in counts))
    wide, high = (_RIGHT - _LEFT) / len(x.values), (_BOTTOM - _TOP) / len(y.values)
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="165mm" height="115mm" viewBox="0 0 {_WIDTH} {_HEIGHT}" '
        f"font-family=\"Inter, 'Helvetica Neue', Arial, sans-serif\" font-size=\"10.8\" fill=\"{_INK}\" role=\"img\">",
        f"<title>{escape(title)}</title>",
        f'<rect width="{_WIDTH}" height="{_HEIGHT}" fill="#ffffff"/>',
        f'<text x="8" y="20.75" font-size="15" font-weight="600">{escape(title)}</text>',
        '<g shape-rendering="crispEdges">',
    ]
    for index, row in enumerate(counts):
        top, begin = _BOTTOM - high * (index + 1), 0
        for place in range(1, len(row) + 1):
            # Cells of one colour are one rectangle.
            if place < len(row) and row[place] == row[begin]:
                continue
            parts.append(_cell(_LEFT + wide * begin, top, wide * (place - begin), high, _colour(row[begin], most)))
            begin = place
    parts.append("</g>")
    parts.append(f'<path d="{_outlines(names, wide, high)}" fill="none" stroke="{_INK}" stroke-width="1.1"/>')
    parts.extend(_labels(names, wide, high, none))
    parts.extend(_axes(x, y, comma))
    parts.extend(_legend(most, legend, none))
    return Picture("\n".join([*parts, "</svg>\n"]))


def _cell(left: float, top: float, wide: float, high: float, fill: str) -> str:
    return f'<rect x="{left:.2f}" y="{top:.2f}" width="{wide:.2f}" height="{high:.2f}" fill="{fill}"/>'


def _colour(count: float, most: int) -> str:
    if count == 0:
        return _GREY
    # By its root: between one and ten there is more to see than between a hundred and a hundred and ten.
    at = math.sqrt(count / most) * (len(_COLOURS) - 1)
    index = min(int(at), len(_COLOURS) - 2)
    pairs = zip(_COLOURS[index], _COLOURS[index + 1], strict=True)
    return "#" + "".join(f"{round(low + (high - low) * (at - index)):02x}" for low, high in pairs)


def _outlines(names: Sequence[Sequence[str]], wide: float, high: float) -> str:
    """Lines between cells of different names."""
    lines: list[str] = []
    for index, row in enumerate(names):
        bottom = _BOTTOM - high * index
        for place, name in enumerate(row):
            left = _LEFT + wide * place
            if place and row[place - 1] != name:
                lines.append(f"M{left:.2f} {bottom:.2f}v{-high:.2f}")
            if index and names[index - 1][place] != name:
                lines.append(f"M{left:.2f} {bottom:.2f}h{wide:.2f}")
    return "".join(lines)


def _labels(names: Sequence[Sequence[str]], wide: float, high: float, none: str) -> list[str]:
    """Each name once, where the cells around it have the same name the farthest."""
    best: dict[str, tuple[float, int, int]] = {}
    for index, row in enumerate(names):
        for place, name in enumerate(row):
            column = [each[place] for each in names]
            along = min(_same(row, place, 1), _same(row, place, -1)) * wide
            across = min(_same(column, index, 1), _same(column, index, -1)) * high
            # A text is broader than it is high.
            best[name] = max(best.get(name, (0.0, 0, 0)), (min(along, 4 * across), index, place))
    found: list[str] = []
    for name, (room, index, place) in best.items():
        text = name or none
        if room < 2.6 * len(text):
            continue
        x, y = _LEFT + wide * (place + 0.5), _BOTTOM - high * (index + 0.5) + 4
        found.append(
            f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="middle" font-weight="600" stroke="#ffffff" stroke-width="3" '
            f'stroke-linejoin="round" paint-order="stroke">{escape(text)}</text>'
        )
    return found


def _same(names: Sequence[str], place: int, step: int) -> float:
    """How many cells of the same name there are in a direction, half of its own included."""
    count = 0.5
    while 0 <= place + step < len(names) and names[place + step] == names[place]:
        count, place = count + 1, place + step
    return count


def _number(value: float, step: float, comma: bool) -> str:
    text = f"{value:.{max(0, -math.floor(math.log10(step) + 1e-9))}f}"
    return text.replace(".", ",") if comma else text


def _ticks(low: float, high: float) -> tuple[list[float], float]:
    """Round values between two, some six of them, and their step."""
    rough = (high - low) / 6
    power = 10.0 ** math.floor(math.log10(rough))
    step = next(step * power for step in (1, 2, 5, 10) if step * power >= rough)
    return [step * number for number in range(math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9) + 1)], step


def _axes(x: Axis, y: Axis, comma: bool) -> list[str]:
    parts = [f'<path d="M{_LEFT} {_TOP}V{_BOTTOM}H{_RIGHT}" fill="none" stroke="{_INK}"/>']
    low, high = x.edges()
    values, step = _ticks(low, high)
    for value in values:
        at = _LEFT + (_RIGHT - _LEFT) * (value - low) / (high - low)
        parts.append(f'<path d="M{at:.2f} {_BOTTOM}v4" stroke="{_INK}"/>')
        parts.append(f'<text x="{at:.2f}" y="{_BOTTOM + 17}" text-anchor="middle">{_number(value, step, comma)}</text>')
    low, high = y.edges()
    values, step = _ticks(low, high)
    for value in values:
        at = _BOTTOM - (_BOTTOM - _TOP) * (value - low) / (high - low)
        parts.append(f'<path d="M{_LEFT} {at:.2f}h-4" stroke="{_INK}"/>')
        parts.append(f'<text x="{_LEFT - 8}" y="{at + 4:.2f}" text-anchor="end">{_number(value, step, comma)}</text>')
    middle = (_TOP + _BOTTOM) / 2
    parts.append(f'<text x="{(_LEFT + _RIGHT) / 2}" y="{_BOTTOM + 38}" text-anchor="middle">{escape(x.label)}</text>')
    parts.append(f'<text transform="translate(16 {middle}) rotate(-90)" text-anchor="middle">{escape(y.label)}</text>')
    return parts


def _legend(most: int, legend: str, none: str) -> list[str]:
    left, top, bottom, steps = _RIGHT + 26, _TOP + 32, _BOTTOM - 40, 60
    high = (bottom - top) / steps
    parts = ['<g shape-rendering="crispEdges">']
    for step in range(steps):
        parts.append(_cell(left, bottom - high * (step + 1), 16, high + 0.3, _colour(most * ((step + 0.5) / steps) ** 2, most)))
    parts.append(_cell(left, bottom + 14, 16, 16, _GREY))
    parts.append("</g>")
    # Even in the root, as the colours are.
    for count in [*(count for count in (1, 10, 50, 100, 150, 200, 250) if count < 0.9 * most), most]:
        at = bottom - (bottom - top) * math.sqrt(count / most)
        parts.append(f'<text x="{left + 22}" y="{at + 4:.2f}">{count}</text>')
    parts.append(f'<text x="{left + 22}" y="{bottom + 26}">0</text>')
    for line, text in enumerate(legend.split("\n")):
        parts.append(f'<text x="{left}" y="{_TOP + 4 + 13 * line}">{escape(text)}</text>')
    return parts
