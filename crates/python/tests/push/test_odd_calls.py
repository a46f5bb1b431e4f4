"""Odd calls: wrong types, units, words, shapes and empty values. Each ends in an exception that names the argument and says what
to write; none hangs, none is misread."""

from __future__ import annotations

import importlib
import importlib.util
import inspect
import pathlib
import re
import sys
import time
import typing
import unittest

import antrieb
from antrieb import questions

EXAMPLES = pathlib.Path(__file__).resolve().parents[4] / "examples"
PROJECT = (EXAMPLES / "indexing-table.toml").read_text(encoding="utf-8")
CODE = "CHA-25A-50-H-C1024"
INERTIA = "load.inertia [kg m^2]"

GIVEN: dict[str, typing.Any] = {
    "text": PROJECT,
    "old": PROJECT,
    "new": PROJECT,
    "code": CODE,
    "figure": "cycle",
    "table": "checks",
    "kind": "arm",
    "delivered": "2026-03-01",
    "voltage": "560 V",
    "hours_per_day": "8 h",
    "length": "5 m",
    "for_": "cia402",
    "trace": "run.csv",
    "body": "disc diameter=200mm length=20mm density=7850kg/m^3",
}
"""A value of each argument that a function needs."""

TYPES: list[typing.Any] = [object(), 1.5, b"x", {"a": 1}, ["x", 3.5], [None], float("nan"), 1j, print, {1}, bytearray(b"1"), "a\ud800"]
"""Values of a type that no argument has."""

if importlib.util.find_spec("numpy"):
    # As a whole number it would be five.
    TYPES.append(importlib.import_module("numpy").datetime64(5, "ns"))

WORDS = ["", "5 bananas", "nonsense"]

FREE = ("title", "number", "revision", "author", "company", "customer", "order", "key", "change", "pattern", "about", "axis")
"""Arguments that take any text, or name an entry of the user."""


def calls() -> typing.Iterator[tuple[str, str, typing.Any, dict[str, typing.Any]]]:
    """Each argument of each question with values that it cannot have."""
    for name in sorted(set(questions.__all__) & set(questions._EXAMPLES)):
        parameters = inspect.signature(getattr(questions, name)).parameters
        needed = {key: GIVEN[key] for key, each in parameters.items() if each.default is each.empty}
        if "code" in parameters:
            needed["code"] = [CODE, "CHA-25A-80-H-C1024"] if name == "compare" else CODE
        if name == "wiring":
            needed["length"] = GIVEN["length"]
        for key in parameters:
            if key in ("text", "old", "new", "file", "folder"):
                continue
            for value in TYPES:
                if key == "hours_per_day" and isinstance(value, float) and value == 1.5:
                    continue
                yield name, key, value, needed
            for value in WORDS:
                if value and (key in FREE or key in ("trace", "memory", "deadline")):
                    continue
                if not value and key == "code":
                    continue
                yield name, key, value, needed


def questions_with_several() -> set[str]:
    """The arguments that may have several values, by the types of the functions."""
    found: set[str] = {"check"}
    for name in questions.__all__:
        parameters = inspect.signature(getattr(questions, name)).parameters if callable(getattr(questions, name)) else {}
        found |= {key for key, each in parameters.items() if key not in ("text", "old", "new") and "Sequence" in str(each.annotation)}
    return found


class OddCalls(unittest.TestCase):
    """The list walked."""

    def test_every_wrong_value_is_refused_by_the_name_of_its_argument(self) -> None:
        count = 0
        for name, key, value, needed in calls():
            count += 1
            with self.subTest(f"{name}({key}={value!r:.30})"):
                begin = time.monotonic()
                with self.assertRaises((TypeError, ValueError)) as caught:
                    getattr(antrieb, name)(**{**needed, key: value})
                self.assertLess(time.monotonic() - begin, 30.0)
                message = str(caught.exception)
                self.assertIn(key, message)
                self.assertNotRegex(re.sub(r"`[^`]*`", "", message), r"--[a-z]")
        self.assertGreater(count, 200)

    def test_texts_that_are_no_projects_are_refused(self) -> None:
        wrong: list[typing.Any] = [None, 1, 1.5, b"x", object(), ["x"], {"a": 1}, "", "\n", "nowhere.toml", "= 3", PROJECT[:200] + '"']
        for value in wrong:
            for function in (antrieb.size, antrieb.check, antrieb.report, lambda text: antrieb.sweep(text, {INERTIA: [1.0]})):
                with self.subTest(f"{value!r:.30}"), self.assertRaises((TypeError, ValueError)):
                    function(value)

    def test_tables_that_are_none_are_refused(self) -> None:
        wrong: list[typing.Any] = [
            None,
            "tasks.csv",
            b"x",
            3,
            [],
            {},
            [1.0],
            [[1.0]],
            [{}],
            object(),
            {INERTIA: 1.0},
            {INERTIA: None},
            {INERTIA: [[1.0], [2.0]]},
            {INERTIA: [1.0, "two"]},
            {INERTIA: [True]},
            {INERTIA: [object()]},
            {INERTIA: [1.0], "motion[1].time [s]": [1.0, 2.0]},
            {INERTIA: [1.0, None]},
            {INERTIA: [float("nan")]},
            {INERTIA: ["1.5 m"]},
            {INERTIA: ["heavy"]},
            {"load.inertia": [1.0]},
            {"load.inertia [m]": [1.0]},
            {"load.inertja [kg m^2]": [1.0]},
            {"inertia": [1.0], INERTIA: [1.0]},
            {"motion[0].time [s]": [1.0]},
            {"motion[9].time [s]": [1.0]},
            {"motion[1].law": ["sine"]},
            {"code": ["CHA-25A-55-H-C1024"]},
            {"code": [1]},
            {"id": [1]},
            {INERTIA: [1.0], "row": [1]},
            {1: [1.0]},
            {INERTIA: {"a": 1}},
        ]
        for table in wrong:
            with self.subTest(f"{table!r:.50}"):
                with self.assertRaises((TypeError, ValueError)) as caught:
                    found = antrieb.sweep(PROJECT, table)
                    self.assertEqual(len(found), 1)
                self.assertRegex(str(caught.exception), "table|inertia|motion|code|id|row|key")

    def test_keys_of_answers_are_refused_with_what_they_may_be(self) -> None:
        found = antrieb.size(PROJECT)
        swept = antrieb.sweep(PROJECT, {INERTIA: [1.0, 2.0]})
        for holder in (found, found.candidates, found.best.checks, swept):
            for key in (1.5, None, [], {}, object(), b"x", (0, 1)):
                with self.subTest(f"{type(holder).__name__}[{key!r:.20}]"), self.assertRaisesRegex(TypeError, "by its number"):
                    holder[typing.cast(typing.Any, key)]

    def test_an_argument_of_one_value_takes_no_container(self) -> None:
        several = questions_with_several()
        count = 0
        for name in sorted(set(questions.__all__) & set(questions._EXAMPLES)):
            parameters = inspect.signature(getattr(questions, name)).parameters
            needed = {key: GIVEN[key] for key, each in parameters.items() if each.default is each.empty}
            for key in set(parameters) - several - {"text", "old", "new", "file", "folder", "lang", "deadline", "memory", "trace"}:
                for value in ([], ["a"], ("a",), {"a": 1}):
                    count += 1
                    with self.subTest(f"{name}({key}={value!r})"), self.assertRaisesRegex((TypeError, ValueError), key):
                        getattr(antrieb, name)(**{**needed, key: value})
        self.assertGreater(count, 200)

    def test_a_container_of_one_is_no_number(self) -> None:
        polars = importlib.import_module("polars")
        for value in ([1.5], (1.5,), polars.Series([1.5]), polars.DataFrame({"a": [1.5]})):
            with self.subTest(type(value).__name__), self.assertRaisesRegex(TypeError, "load_factor"):
                antrieb.Bearing(load_factor=value)

    def test_parts_of_axes_from_arrays_are_refused_by_their_names(self) -> None:
        numpy = importlib.import_module("numpy")
        time = [0.0, 0.5, 1.0, 1.5]
        position = [0.0, 0.5, 1.0, 0.0]
        for value in (0, "", {}, set(), "arm", numpy.zeros(2), antrieb.Move, object()):
            with self.subTest(f"mechanism={value!r:.20}"), self.assertRaisesRegex(TypeError, "mechanism"):
                antrieb.axes_from_arrays(time, position, torque=position, mechanism=typing.cast(typing.Any, value))
        with self.assertRaisesRegex(TypeError, "time"):
            antrieb.axes_from_arrays({"a": 1}, position, torque=position)
        with self.assertRaisesRegex(TypeError, "position_unit"):
            antrieb.axes_from_arrays(time, antrieb.q(numpy.zeros((4, 2)), "deg"))
        sweep = antrieb.Sweep(PROJECT, {INERTIA: [1.0]})
        for first in ("1", 1.5, None, -1, [1], 1 << 70):
            with self.subTest(f"first_row={first!r}"), self.assertRaisesRegex((TypeError, ValueError), "first_row"):
                sweep.batch({INERTIA: [1.0]}, typing.cast(typing.Any, first))

    def test_options_of_a_sweep_are_refused_by_their_names(self) -> None:
        wrong: dict[str, list[typing.Any]] = {
            "lang": ["fr", "", 1],
            "axis": ["nowhere", 3.5],
            "check": ["termal", 3.5, ["thermal", 1.5]],
            "front": ["yes", 1, None],
            "inputs": ["yes", 1, None],
            "deadline": [60, "soon", "60"],
            "memory": [1, "1", "much"],
            "progress": ["yes", 1],
        }
        for key, values in wrong.items():
            for value in values:
                with self.subTest(f"{key}={value!r}"), self.assertRaisesRegex((TypeError, ValueError), key):
                    antrieb.sweep(PROJECT, {INERTIA: [1.0]}, **{key: value})


def table() -> None:
    """Print each call with its answer, a line of Markdown for each: `python test_odd_calls.py --table`."""
    print("| call | answer |\n|---|---|")
    for name, key, value, needed in calls():
        try:
            getattr(antrieb, name)(**{**needed, key: value})
            said = "no exception"
        except (TypeError, ValueError) as error:
            said = f"{type(error).__name__}: {error}"
        line = " ".join(said.split()).replace("|", "\\|")
        print(f"| `{name}({key}={value!r:.30})` | {line:.200} |")


if __name__ == "__main__":
    if "--table" in sys.argv:
        table()
    else:
        unittest.main()
