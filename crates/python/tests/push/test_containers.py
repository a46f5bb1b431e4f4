"""A column means the same in every container of a table: it is answered alike, or refused with its heading."""

from __future__ import annotations

import datetime
import decimal
import importlib
import importlib.util
import re
import typing
import unittest

import antrieb
from antrieb.examples import ARM

PROJECT = ARM.to_toml()
CODE = "CHA-25A-50-H-C1024"


def containers() -> dict[str, typing.Callable[[str, list[typing.Any]], typing.Any]]:
    """One column in every container of a table that is installed, by the name of the container."""
    found: dict[str, typing.Callable[[str, list[typing.Any]], typing.Any]] = {
        "dict": lambda heading, values: {heading: values},
        "rows": lambda heading, values: [{heading: value} for value in values],
    }
    if importlib.util.find_spec("numpy"):
        numpy = importlib.import_module("numpy")

        def masked(heading: str, values: list[typing.Any]) -> typing.Any:
            known = next(value for value in values if value is not None)
            plain = [known if value is None else value for value in values]
            return {heading: numpy.ma.masked_array(plain, mask=[value is None for value in values])}

        found["masked"] = masked
        found["object array"] = lambda heading, values: {heading: numpy.array(values, dtype=object)}
        found["array"] = lambda heading, values: {heading: numpy.array(values)}
        found["records"] = lambda heading, values: numpy.array([(value,) for value in values], dtype=[(heading, object)])
    if importlib.util.find_spec("pandas"):
        pandas = importlib.import_module("pandas")
        found["pandas"] = lambda heading, values: pandas.DataFrame({heading: values})
        found["series"] = lambda heading, values: {heading: pandas.Series(values)}
        found["categorical"] = lambda heading, values: pandas.DataFrame({heading: pandas.Categorical(values)})
    if importlib.util.find_spec("polars"):
        polars = importlib.import_module("polars")
        found["polars"] = lambda heading, values: polars.DataFrame({heading: values})
        found["polars lazy"] = lambda heading, values: polars.LazyFrame({heading: values})
        found["polars categorical"] = lambda heading, values: polars.DataFrame({heading: polars.Series(values, dtype=polars.Categorical)})
        found["polars enum"] = lambda heading, values: polars.DataFrame(
            {heading: polars.Series(values, dtype=polars.Enum(sorted({value for value in values if value is not None})))}
        )
        found["polars series"] = lambda heading, values: {heading: polars.Series(values)}
    if importlib.util.find_spec("pyarrow"):
        pyarrow = importlib.import_module("pyarrow")
        found["pyarrow"] = lambda heading, values: pyarrow.table({heading: pyarrow.array(values)})
        found["pyarrow dictionary"] = lambda heading, values: pyarrow.table({heading: pyarrow.array(values).dictionary_encode()})
        found["pyarrow array"] = lambda heading, values: {heading: pyarrow.array(values)}
    return found


def outcome(table: typing.Any) -> typing.Any:
    """Utilisations of the rows of a sweep, or `None` with the message of its refusal."""
    try:
        found = antrieb.sweep(PROJECT, table).to_pydict()
    except (TypeError, ValueError) as error:
        return None, str(error)
    # A row that cannot be judged is refused in its place.
    if any(found["error"]):
        return None, str(next(filter(None, found["error"])))
    return list(zip(found["code"], found["utilisation"], strict=True)), ""


TIME = "motion[1].time"


class Containers(unittest.TestCase):
    """A column means the same in every container: it is answered alike, or refused with its heading."""

    def test_a_column_is_answered_or_refused_alike_in_every_container(self) -> None:
        count = 0
        columns: list[tuple[str, list[typing.Any], bool]] = [
            (f"{TIME} [s]", [0.8, 1.0], True),
            (TIME, ["0.8 s", "1 s"], True),
            (f"{TIME} [s]", ["0.8", "1"], True),
            # An empty cell refuses the table, with its heading and its row.
            (TIME, ["0.8 s", None], False),
            (TIME, [None, "0.8 s"], False),
            (f"{TIME} [s]", [0.8, None], False),
            (f"{TIME} [s]", [0.8, float("nan")], False),
            (TIME, ["0.8 s", ""], False),
            (TIME, ["0.8 s", "soon"], False),
            (TIME, ["0.8", "1"], False),
            (TIME, [0.8, 1.0], False),
            (f"{TIME} [s]", ["0.8 s", "1 s"], True),
            # A table without rows has an answer without rows.
            (f"{TIME} [s]", [], True),
            ("code", [CODE, None], False),
        ]
        for heading, values, is_answered in columns:
            expected, _ = outcome({heading: values})
            self.assertEqual(expected is not None, is_answered, (heading, values, outcome({heading: values})))
            for name, of in containers().items():
                # A list without rows has no headings.
                if name in ("rows", "masked") and not values:
                    continue
                with self.subTest(f"{name}: {heading} {values}"):
                    try:
                        table = of(heading, values)
                    except (TypeError, ValueError, ArithmeticError):
                        continue
                    count += 1
                    found, message = outcome(table)
                    self.assertEqual(found, expected, message)
                    if found is None:
                        self.assertIn(heading.split(" ")[0], message)
        self.assertGreater(count, 40)

    def test_columns_of_other_types_are_refused_by_their_headings_or_right(self) -> None:
        seconds = [datetime.timedelta(seconds=0.8), datetime.timedelta(seconds=1)]
        expected, _ = outcome({f"{TIME} [s]": [0.8, 1.0]})
        right: list[tuple[str, list[typing.Any]]] = [
            (f"{TIME} [s]", [decimal.Decimal("0.8"), decimal.Decimal("1")]),
            (f"{TIME} [s]", [decimal.Decimal("0.8"), 1]),
        ]
        wrong: list[tuple[str, list[typing.Any]]] = [
            (f"{TIME} [s]", [0.8, b"1"]),
            (f"{TIME} [s]", [0.8, datetime.timedelta(seconds=1)]),
            (f"{TIME} [s]", [datetime.date(2026, 1, 1), None]),
            (f"{TIME} [s]", [decimal.Decimal("0.8"), "1"]),
            (f"{TIME} [s]", [[0.8], [1.0]]),
            (f"{TIME} [s]", [{"a": 1}, {"a": 2}]),
            (f"{TIME} [s]", [None, None]),
            (TIME, [None]),
            (f"{TIME} [s]", [10**30, 1]),
            (f"{TIME} [s]", [float("inf"), 1.0]),
        ]
        for heading, values in right:
            for name, of in containers().items():
                with self.subTest(f"{name}: {values}"):
                    try:
                        table = of(heading, values)
                    except Exception:  # the library has no such column
                        continue
                    found, message = outcome(table)
                    self.assertTrue(found == expected or (found is None and TIME in message), message)
        for heading, values in wrong:
            for name, of in containers().items():
                with self.subTest(f"{name}: {heading} {values}"):
                    try:
                        table = of(heading, values)
                    except Exception:  # the library has no such column
                        continue
                    found, message = outcome(table)
                    self.assertIsNone(found, f"{name} {values}: {found}")
                    self.assertRegex(message, "motion|table|row")
        # An interval is a time: it is read as one, or refused by its heading.
        for name, of in containers().items():
            for heading in (TIME, f"{TIME} [s]"):
                with self.subTest(f"{name}: {heading} {seconds}"):
                    try:
                        table = of(heading, seconds)
                    except Exception:  # the library has no such column
                        continue
                    found, message = outcome(table)
                    self.assertTrue(found == expected or (found is None and TIME in message), f"{found} {message}")

    def test_text_in_a_notebook_is_escaped(self) -> None:
        name = "<script>alert(1)</script>&"
        text = re.sub(r'name = ".*"', f'name = "{name}"', PROJECT, count=1)
        for shown in (
            antrieb.size(text),
            antrieb.check(text, CODE),
            antrieb.sweep(PROJECT, {f"{TIME} [s]": [0.8], "<b>id</b>": [name]}),
        ):
            html = shown._repr_html_()
            self.assertNotIn("<script>", html)
            self.assertNotIn("<b>id", html)


if __name__ == "__main__":
    unittest.main()
