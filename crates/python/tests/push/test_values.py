"""Values of other libraries as they come: times with their unit, tables with their headings and labels, lists of scalars."""

from __future__ import annotations

import datetime
import decimal
import enum
import importlib.util
import inspect
import itertools
import json
import math
import os
import pathlib
import pickle
import random
import subprocess
import sys
import tempfile
import typing
import unittest
import uuid

import antrieb as an
from antrieb import _section, questions, sections

HAS_LIBRARIES = all(importlib.util.find_spec(name) for name in ("numpy", "pandas", "polars", "pyarrow", "pint"))
CODE = "CHA-25A-50-H-C1024"
MASS = "mechanism.arm.mass [kg]"
ROWS = 41


def axis() -> an.Axis:
    """An arm that swings up, is held, and comes back."""
    motion = [an.Move("modified_sine", distance="90 deg", time="0.8 s", payload="2 kg"), an.Dwell("1 s"), an.Return(time="0.6 s")]
    return an.Axis("tilt", an.Arm(mass="6 kg", length="0.5 m", angle="-20 deg"), motion, supply="560 V")


def arrays() -> tuple[list[float], list[list[float]], list[list[float]]]:
    """Instants of whole milliseconds, positions and torques of two joints."""
    time = [0.025 * row for row in range(ROWS)]
    position = [[reach * (1 - math.cos(2 * math.pi * each)) for reach in (0.3, 0.2)] for each in time]
    torque = [[5 + each, 3 - each] for each in time]
    return time, position, torque


def contents(project: an.Project) -> dict[str, bytes]:
    """The recordings of each joint, by its name."""
    return {str(each.name): next(iter(each._recordings.values())) for each in project.axes}


TYPED = '''
import antrieb as an
from typing import assert_type

axis = an.Axis("a", an.Arm(mass="6 kg", length="0.5 m"), [an.Move("modified_sine", distance="90 deg", time="0.8 s"), an.Return(time="0.6 s")])
robot = an.axes_from_arrays([0.0, 1.0, 2.0], [0.0, 1.0, 0.0], torque=[1.0, 2.0, 1.0])
for each in an.size(robot):
    assert_type(each, an.answers.Sizing)
    assert_type(each.best.code, str | None)
assert_type(an.size([axis, axis]), an.answers.AxesOfSizing)
assert_type(an.size(robot, axis="J1"), an.answers.Sizing)
assert_type(an.size(axis), an.answers.Sizing)
assert_type(an.simulate(axis, "C", format="svg"), an.Picture)
assert_type(an.simulate(axis, "C", format="csv"), str)
assert_type(an.simulate(axis, "C", format="parquet"), bytes)
assert_type(an.simulate(axis, "C"), an.answers.Simulation)
assert_type(an.size(an.load("x.toml")), an.answers.Sizing | an.answers.AxesOfSizing)
print(an.size(axis).best.checks["thermal"].explain(), len(an.size(axis)), "C" in an.size(axis))
best = an.size(axis).best
if best:
    print(best.code)
'''


@unittest.skipUnless(importlib.util.find_spec("mypy"), "needs mypy")
class Types(unittest.TestCase):
    """The types of answers as type checkers read them."""

    def test_the_type_of_an_answer_is_that_of_its_project(self) -> None:
        checkers = [[sys.executable, "-m", "mypy", "--strict"], [sys.executable, "-m", "basedpyright", "--pythonpath", sys.executable]]
        for checker in checkers:
            with self.subTest(checker[2]), tempfile.TemporaryDirectory() as folder:
                pathlib.Path(folder, "typed.py").write_text(TYPED, encoding="utf-8")
                pathlib.Path(folder, "pyrightconfig.json").write_text('{"typeCheckingMode": "strict"}', encoding="utf-8")
                done = subprocess.run([*checker, "typed.py"], cwd=folder, capture_output=True, check=False, text=True)
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


@unittest.skipUnless(HAS_LIBRARIES, "needs the libraries of tables")
class Times(unittest.TestCase):
    """Times of every library and unit: read with their unit where a time is meant, refused elsewhere."""

    def times(self, milliseconds: list[int], instants: bool) -> typing.Iterator[tuple[str, typing.Any]]:
        """The same times in every container and unit."""
        import numpy as np
        import pandas as pd
        import polars as pl
        import pyarrow as pa

        whole = np.array(milliseconds, "int64")
        kind = "M8" if instants else "m8"
        for unit, ticks in (("ms", 1), ("us", 1000), ("ns", 1_000_000)):
            array = (whole * ticks).view(f"{kind}[{unit}]")
            yield f"numpy {unit}", array
            yield f"column {unit}", array.reshape(-1, 1)
            yield f"scalars {unit}", list(array)
            yield f"index {unit}", pd.Index(array)
            yield f"series {unit}", pd.Series(array)
            yield f"objects of pandas {unit}", list(pd.Series(array))
            yield f"objects in a series {unit}", pd.Series(list(pd.Series(array)), dtype=object)
            yield f"polars {unit}", pl.Series(array)
            yield f"pyarrow {unit}", pa.array(array)
            yield f"chunks {unit}", pa.chunked_array([pa.array(array[:7]), pa.array(array[7:])])
            arrow = pa.timestamp(unit) if instants else pa.duration(unit)
            yield f"arrow of pandas {unit}", pd.Series(array, dtype=pd.ArrowDtype(arrow))
            if instants:
                yield f"zone {unit}", pd.Series(array).dt.tz_localize("UTC").dt.tz_convert("Europe/Berlin")
                yield f"index of a zone {unit}", pd.DatetimeIndex(array).tz_localize("UTC")
                yield f"zone of polars {unit}", pl.Series(array).dt.replace_time_zone("UTC")
                yield f"zone of arrow {unit}", pa.array(array).cast(pa.timestamp(unit, "UTC"))
        begin = datetime.datetime(1970, 1, 1)
        deltas = [datetime.timedelta(milliseconds=each) for each in milliseconds]
        yield "standard library", [begin + each for each in deltas] if instants else deltas
        if instants:
            yield "aware", [begin.replace(tzinfo=datetime.UTC) + each for each in deltas]
        for unit in ("s", "m", "h", "D"):
            yield f"numpy {unit}", np.array([0, 1, 3], f"{kind}[{unit}]")

    def test_instants_of_every_kind_are_those_in_seconds(self) -> None:
        time, position, torque = arrays()
        expected = contents(an.axes_from_arrays([round(1000 * each) for each in time], position, torque=torque, time_unit="ms"))
        count = 0
        for instants in (False, True):
            for name, given in self.times([round(1000 * each) for each in time], instants):
                if len(given) != ROWS:
                    continue
                with self.subTest(name, instants=instants):
                    found = contents(an.axes_from_arrays(given, position, torque=torque))
                    for own, others in zip(expected["J1"].split()[5:], found["J1"].split()[5:], strict=True):
                        mine, other = own.decode().split(","), others.decode().split(",")
                        self.assertAlmostEqual(float(mine[0]) / 1000, float(other[0]), delta=1e-12)
                        self.assertEqual(mine[1:], other[1:])
                    with self.assertRaisesRegex(TypeError, "time_unit"):
                        an.axes_from_arrays(given, position, torque=torque, time_unit="s")
                    count += 1
        self.assertGreater(count, 60)

    def test_intervals_become_quantities_of_time_and_of_nothing_else(self) -> None:
        seconds = {"s": 1.0, "m": 60.0, "h": 3600.0, "D": 86400.0}
        for name, given in self.times([0, 20, 1500], False):
            own = [0.0, 1.0, 3.0] if name[-2:] in (" s", " m", " h", " D") else [0.0, 0.02, 1.5]
            factor = seconds[name[-1]] if len(own) == 3 and own[1] == 1.0 else 1.0
            with self.subTest(name):
                for unit, per_second in (("s", 1.0), ("ms", 1000.0), ("min", 1 / 60)):
                    for mine, other in zip([each * factor * per_second for each in own], an.q(given, unit).values, strict=True):
                        self.assertAlmostEqual(mine, other, delta=1e-9 * abs(mine))
                for unit in ("kg", "deg", "", "degC"):
                    with self.assertRaisesRegex(TypeError, "value: times"):
                        an.q(given, unit)
        for name, given in self.times([0, 20, 1500], True):
            with self.subTest(name), self.assertRaisesRegex(TypeError, "instants"):
                an.q(given, "s")

    def test_no_number_is_a_time(self) -> None:
        import numpy as np
        import pandas as pd
        import pint

        wrong: list[typing.Any] = [
            np.timedelta64(5, "ns"), np.timedelta64(5, "ms"), np.datetime64(5, "ns"), np.array(5, "m8[ns]"), pd.Timedelta(5), pd.Timestamp(5),
            datetime.timedelta(seconds=5), datetime.datetime(2020, 1, 1), datetime.date(2020, 1, 1),
            pint.Quantity(np.array(5, "m8[ns]"), "kg"),
        ]
        count = 0
        for of in vars(sections).values():
            if not (isinstance(of, type) and issubclass(of, an.Section)):
                continue
            for name, kind in of._KEYS.items():
                name = kind.of_key or name
                if kind.of not in ("quantity", "number", "integer", "numbers", "rows"):
                    continue
                is_time = kind.of == "quantity" and kind.example.split(" ", 1)[-1] in ("s", "ms", "us", "ns", "min", "h", "d", "a")
                for value in wrong:
                    if is_time and not hasattr(value, "magnitude") and "date" not in type(value).__name__ and not isinstance(value, pd.Timestamp):
                        continue
                    with self.subTest(of=of.__name__, key=name, value=repr(value)), self.assertRaises((TypeError, ValueError)) as caught:
                        _section._stored(kind, [value, value] if kind.of in ("numbers", "rows") else value, f"{of.__name__}.{name}")
                    self.assertIn(name, str(caught.exception), (of, kind, value))
                    count += 1
        self.assertGreater(count, 1000)
        self.assertEqual(an.Dwell(datetime.timedelta(milliseconds=700)), an.Dwell("0.7 s"))
        self.assertEqual(an.Dwell(np.timedelta64(700_000_000, "ns")), an.Dwell(pd.Timedelta("700ms")))
        for value in wrong[1:]:
            for call in (lambda value=value: an.size(axis(), top=value), lambda value=value: an.torsion(CODE, value)):
                with self.subTest(repr(value)), self.assertRaises((TypeError, ValueError)):
                    call()
        self.assertEqual(an.size(axis(), deadline=datetime.timedelta(minutes=1)), an.size(axis(), deadline="60 s"))

    def test_arrays_of_other_quantities_are_no_times(self) -> None:
        time, position, torque = arrays()
        milliseconds = [round(1000 * each) for each in time]
        for instants in (False, True):
            for name, given in self.times(milliseconds, instants):
                if len(given) != ROWS:
                    continue
                with self.subTest(name, instants=instants):
                    one = [row[:1] for row in position]
                    for role in ("position", "speed", "torque"):
                        wrong = {"position": one, "torque": [row[:1] for row in torque], role: given}
                        with self.assertRaisesRegex(TypeError, f"{role}.*times"):
                            an.axes_from_arrays(time, **wrong)
                    if getattr(given, "ndim", 1) == 1:
                        with self.assertRaisesRegex((TypeError, ValueError), "mass"):
                            an.sweep(axis(), {MASS: given})
                    with self.assertRaisesRegex((TypeError, ValueError), "position"):
                        an.identify({"time [s]": time, "position [deg]": given, "motor_speed [1/min]": time, "torque [N m]": time, "current_q [A]": time}, axis(), CODE)

    def test_columns_of_a_sweep_that_are_times(self) -> None:
        expected = an.sweep(axis(), {"motion.1.time [s]": [0.8, 0.9, 1.2]})
        for name, given in self.times([800, 900, 1200], False):
            if getattr(given, "ndim", 1) > 1 or name[-2:] in (" s", " m", " h", " D"):
                continue
            for heading in ("motion.1.time", "motion[1].time", "motion.1.time [ms]", "motion.1.time [s]"):
                with self.subTest(name, heading=heading):
                    self.assertEqual(an.sweep(axis(), {heading: given}), expected)
            with self.subTest(name), self.assertRaisesRegex((TypeError, ValueError), "payload"):
                an.sweep(axis(), {"motion.1.payload": given})
        for name, given in self.times([800, 900, 1200], True):
            if getattr(given, "ndim", 1) == 1:
                with self.subTest(name), self.assertRaisesRegex((TypeError, ValueError), "time"):
                    an.sweep(axis(), {"motion.1.time": given})


@unittest.skipUnless(HAS_LIBRARIES, "needs the libraries of tables")
class Labels(unittest.TestCase):
    """Headings and labels of rows decide, never the place."""

    def test_joints_are_matched_by_their_headings(self) -> None:
        import numpy as np
        import pandas as pd
        import polars as pl
        import pyarrow as pa

        chance = random.Random(1)
        time, position, torque = arrays()
        joints = ["x", "y", "z", "tool 4"]
        every = {role: {name: [value * (at + 1) for value, *_ in rows] for at, name in enumerate(joints)} for role, rows in (("p", position), ("t", torque))}
        expected = contents(an.axes_from_arrays(time, every["p"], torque=every["t"]))
        self.assertEqual(list(expected), joints)
        made: list[typing.Any] = [dict, pd.DataFrame, pl.DataFrame, pa.table]
        made.append(lambda columns: np.array(list(zip(*columns.values(), strict=True)), [(name, "f8") for name in columns]))
        for first, second in itertools.product(made, made):
            for _ in range(3):
                order = chance.sample(joints, len(joints))
                turned = {name: every["t"][name] for name in order}
                with self.subTest(first=first, second=second, order=order):
                    found = contents(an.axes_from_arrays(time, first(every["p"]), torque=second(turned)))
                    self.assertEqual(found, expected)
                    named = contents(an.axes_from_arrays(time, first(every["p"]), torque=second(turned), names=order))
                    self.assertEqual(list(named), order)
                    self.assertEqual({name: named[name] for name in joints}, expected)
        with self.assertRaisesRegex(an.AntriebError, "columns"):
            an.axes_from_arrays(time, every["p"], torque={**{name: every["t"][name] for name in joints[1:]}, "w": every["t"]["x"]})
        plain = pd.DataFrame(every["t"]).to_numpy()
        self.assertEqual(contents(an.axes_from_arrays(time, every["p"], torque=plain)), expected)
        self.assertEqual(list(contents(an.axes_from_arrays(time, every["p"], torque=plain, names=["a", "b", "c", "d"]))), ["a", "b", "c", "d"])

    def test_rows_are_matched_by_their_labels(self) -> None:
        import pandas as pd

        chance = random.Random(2)
        time, position, torque = arrays()
        expected = an.axes_from_arrays(time, position, torque=torque)
        frames = [pd.DataFrame(position), pd.DataFrame(torque)]
        for _ in range(5):
            order = chance.sample(range(ROWS), ROWS)
            found = an.axes_from_arrays(pd.Series(time), frames[0].iloc[order], torque=frames[1].iloc[chance.sample(range(ROWS), ROWS)])
            self.assertEqual(contents(found), contents(expected))
        with self.assertRaisesRegex(an.AntriebError, "labels"):
            an.axes_from_arrays(time, frames[0], torque=frames[1].set_index(frames[1].index + 1))
        masses, names = [1.0, 2.0, 3.0], ["a", "b", "c"]
        for labels in ([5, 6, 7], ["u", "v", "w"], [2, 0, 1]):
            whole = pd.DataFrame({MASS: masses, "id": names}, index=labels)
            for order in itertools.permutations(range(3)):
                found = an.sweep(axis(), {MASS: whole[MASS], "id": whole["id"].iloc[list(order)]})
                self.assertEqual((found["id"], found["utilisation"]), (names, an.sweep(axis(), {MASS: masses})["utilisation"]))
            with self.assertRaisesRegex(an.AntriebError, "id.*labels"):
                an.sweep(axis(), {MASS: whole[MASS], "id": pd.Series(names)} if labels != [2, 0, 1] else {MASS: whole[MASS], "id": pd.Series(names, index=[0, 1, 9])})


@unittest.skipUnless(HAS_LIBRARIES, "needs the libraries of tables")
class Rows(unittest.TestCase):
    """Rows and columns of every form."""

    def test_lists_of_scalars_rows_and_tuples_are_arrays(self) -> None:
        import numpy as np

        time, position, torque = arrays()
        one, moment = [row[0] for row in position], [row[0] for row in torque]
        expected = contents(an.axes_from_arrays(time, one, torque=moment))
        scalars: list[typing.Any] = [float, np.float64, decimal.Decimal, lambda value: np.array(value)]
        for of in scalars:
            forms: list[typing.Any] = [
                [of(value) for value in one], tuple(of(value) for value in one), [[of(value)] for value in one], [(of(value),) for value in one],
                (of(value) for value in one), np.array([[value] for value in one]), [np.array([value]) for value in one],
            ]
            for place, form in enumerate(forms):
                with self.subTest(of=of, place=place):
                    self.assertEqual(contents(an.axes_from_arrays([of(value) for value in time], form, torque=[of(value) for value in moment])), expected)
        for wrong in (True, "1", None, 1j, [1.0, 2.0], float("inf"), 10**400, np.bool_(True), b"1"):
            with self.subTest(wrong=wrong), self.assertRaisesRegex((TypeError, ValueError), r"position\[2\]|position: its rows"):
                an.axes_from_arrays(time, [*one[:2], wrong, *one[3:]], torque=moment)

    def test_faults_of_arrays_are_found_at_the_call(self) -> None:
        time, position, torque = arrays()
        cases: list[tuple[dict[str, typing.Any], str]] = [
            ({"time": time[::-1]}, r"time.*time\[1\].*\[::-1\]"),
            ({"time": [0.0] * ROWS}, r"time.*time\[1\]"),
            ({"time": [*time[:9], time[8], *time[10:]]}, r"time\[9\]"),
            ({"time": time[:2], "position": position[:2], "torque": torque[:2]}, "time has 2"),
            ({"time_unit": "m"}, "time_unit.*length"),
            ({"time_unit": 5}, "time_unit"),
            ({"position_unit": "grad"}, "position_unit.*rad"),
            ({"position_unit": "m"}, "position_unit.*Screw"),
            ({"torque_unit": "kg"}, "torque_unit.*mass"),
            ({"torque_unit": "N"}, "torque_unit.*force"),
            ({"speed": position, "speed_unit": "m/s"}, "speed_unit"),
            ({"torquex": torque}, "did you mean 'torque'"),
            ({"supplyx": "560 V"}, "did you mean 'supply'"),
            ({"names": {"a", "b"}}, "names"),
        ]
        for wrong, words in cases:
            with self.subTest(words), self.assertRaisesRegex((TypeError, ValueError), words):
                an.axes_from_arrays(**{"time": time, "position": position, "torque": torque, **wrong})
        screw = an.Screw(lead="20 mm", mass="25 kg")
        self.assertEqual(len(an.axes_from_arrays(time, position, position_unit="mm", mechanism=screw)), 2)

    def test_what_is_only_carried_comes_back_as_it_is(self) -> None:
        import numpy as np
        import pandas as pd
        import polars as pl
        import pyarrow as pa

        values: list[list[typing.Any]] = [
            [b"\xff\x00", b"a"], [b"", b"\x00"], [[1], [2, 3]], [{"a": 1, "b": "x"}, {"a": 2, "b": None}], ["ä", ""], [1, None], [True, False],
            [datetime.date(2020, 1, 1), datetime.date(1, 1, 1)], [datetime.time(1, 2, 3), None], [datetime.timedelta(days=1), datetime.timedelta(microseconds=1)],
            [decimal.Decimal("1.10"), decimal.Decimal("22.20")], [datetime.datetime(2020, 1, 1, 1), datetime.datetime(1960, 1, 1)],
            [datetime.datetime(2020, 1, 1, tzinfo=datetime.UTC)] * 2, [None, None],
        ]
        for own in values:
            for made in (list, pa.array, lambda each: pa.chunked_array([pa.array(each[:1], pa.array(each).type), pa.array(each[1:], pa.array(each).type)])):
                with self.subTest(own=own, made=made):
                    found = an.sweep(axis(), {MASS: [1.0, 2.0], "id": made(own)})
                    self.assertEqual(found["id"], own)
                    self.assertEqual(found.to_dicts()[1]["id"], own[1])
                    self.assertTrue(repr(found) and found._repr_html_())
                    self.assertEqual(found.to_polars().height, 2)
                    self.assertEqual(len(found.to_pandas()), 2)
                    self.assertEqual(pickle.loads(pickle.dumps(found)), found)
            with self.subTest(own=own, made="frames"):
                self.assertEqual(an.sweep(axis(), pl.DataFrame({MASS: [1.0, 2.0], "id": own}).to_dict())["id"], own)
                self.assertEqual(an.sweep(axis(), pl.DataFrame({MASS: [1.0, 2.0], "id": own}))["id"], own)
                self.assertEqual(an.sweep(axis(), pa.table({MASS: [1.0, 2.0], "id": own}))["id"], own)
        fixed = pa.array([b"ab", b"cd"], pa.binary(2))
        self.assertEqual(an.sweep(axis(), {MASS: [1.0, 2.0], "id": fixed})["id"], [b"ab", b"cd"])
        for zone in ("UTC", "Europe/Berlin", "+05:30"):
            stamps = pa.array([0, 1_600_000_000_000_000], pa.timestamp("us", zone))
            self.assertEqual([each.timestamp() for each in an.sweep(axis(), {MASS: [1.0, 2.0], "id": stamps})["id"]], [0.0, 1.6e9])
        texts: list[typing.Any] = [uuid.UUID(int=1), pathlib.Path("a", "b")]
        for text in texts:
            self.assertEqual(an.sweep(axis(), {MASS: [1.0], "id": [text]})["id"], [str(text)])
        for own in ([datetime.timedelta(seconds=1)], ["3 kg"], [decimal.Decimal("1.10")]):
            self.assertEqual(an.sweep(axis(), {MASS: [1.0], "label": own})["label"], own)
        for masses in ([decimal.Decimal("1.5"), decimal.Decimal(2)], [decimal.Decimal("1.5"), 2], [decimal.Decimal("1.5"), 2.0], [1.5, decimal.Decimal(2)]):
            self.assertEqual(an.sweep(axis(), {MASS: masses}), an.sweep(axis(), {MASS: [1.5, 2.0]}))
        listed = an.sweep(axis(), {MASS: [1.0, 2.0], "motion.1.payload": ["1 kg", "2 kg"], "id": [[1], [2]]}, inputs=True)
        self.assertTrue(listed.arrays(x=MASS, y="motion[1].payload [kg]").z)
        with self.assertRaisesRegex(TypeError, "id.*lists"):
            listed.arrays(x=MASS, y="id")
        grid = an.sweep(axis(), {MASS: pd.Series([1.0, 2.0]), "id": pa.array([datetime.date(2020, 1, 1), datetime.date(2021, 1, 1)])}, grid=True)
        self.assertEqual(grid["id"], [datetime.date(2020, 1, 1), datetime.date(2021, 1, 1)] * 2)
        expected = an.sweep(axis(), {MASS: [1.0, 2.0]})
        keys: list[typing.Any] = [np.array([1.0, 2.0]), pl.Series("m", [1.0, 2.0]), pa.array([1.0, 2.0]), pa.chunked_array([[1.0], [2.0]]), pd.Series([1.0, 2.0]), (each for each in (1.0, 2.0)), [1, 2.0]]
        for values_of_key in keys:
            self.assertEqual(an.sweep(axis(), {MASS: values_of_key}), expected)

    def test_a_table_of_times_is_never_one_of_numbers(self) -> None:
        import numpy as np

        for kind in ("m8[ns]", "M8[ns]", "m8[ms]"):
            with self.assertRaisesRegex(TypeError, "times"):
                an.Table.from_pydict({"x": np.array([1, 2], kind)})


class E(str, enum.Enum):
    """Words and codes as members."""

    LAW = "modified_sine"
    CODE = CODE
    MASS = "6 kg"


class Whole(enum.IntEnum):
    """A number as a member."""

    TWO = 2


class Refused(unittest.TestCase):
    """Values without an order, half characters, numbers beyond every limit, calls of another form."""

    def test_collections_without_an_order_are_refused(self) -> None:
        wrong: list[typing.Any] = [{1: 2, 3: 4}, {1, 2}, frozenset({1}), b"12", bytearray(b"12"), memoryview(b"12"), {"a": 1}.keys()]
        for value in wrong:
            with self.subTest(repr(value)):
                with self.assertRaisesRegex(TypeError, "value"):
                    an.q(value, "kg")
                with self.assertRaisesRegex((TypeError, ValueError), "mass"):
                    an.sweep(axis(), {MASS: value})
        for endless in (itertools.count(), itertools.repeat(1.0)):
            with self.assertRaisesRegex(an.AntriebError, "mass.*1000000"):
                an.sweep(axis(), {MASS: endless})
            with self.assertRaisesRegex(an.AntriebError, "value.*1000000"):
                an.q(endless, "kg")
        for single in ("12", " 1e3 ", 3, 3.0, None, True):
            with self.subTest(single), self.assertRaisesRegex(TypeError, "one value"):
                an.sweep(axis(), {MASS: single})

    def test_numbers_beyond_every_limit_are_refused_by_name(self) -> None:
        for value in (10**400, -(10**400), decimal.Decimal("1e400")):
            with self.subTest(value), self.assertRaisesRegex(an.AntriebError, "ratio"):
                an.Stage(kind="belt", ratio=value)
            with self.subTest(value), self.assertRaisesRegex(an.AntriebError, "q|mass"):
                an.Arm(mass=an.q(value, "kg"))

    def test_half_characters_are_refused_by_name(self) -> None:
        half = "a\ud800"
        cases: list[tuple[typing.Any, str]] = [
            (lambda: an.Axis(half, an.Arm(mass="1 kg"), []), "Axis.name"),
            (lambda: an.Arm(mass=half), "Arm.mass"),
            (lambda: an.q(1, half), "unit"),
            (lambda: an.Move(half, distance="1 deg", time="1 s"), "Move.law"),
            (lambda: an.check(axis(), half), "code"),
            (lambda: an.size(axis(), axis=half), "axis"),
            (lambda: an.size(axis(), file=half), "file"),
            (lambda: an.size(axis(), deadline=half), "deadline"),
            (lambda: an.loads(half), "text"),
            (lambda: an.loads("format = 1", name=half), "name"),
            (lambda: an.sweep(axis(), {half: [1], MASS: [1.0]}), "heading"),
            (lambda: an.sweep(axis(), {"id": [half], MASS: [1.0]}), "id"),
            (lambda: an.sweep(axis(), [{half: 1}]), "heading"),
            (lambda: axis().replace({half: "1 kg"}), "key"),
        ]
        for call, name in cases:
            with self.subTest(name), self.assertRaisesRegex(an.AntriebError, f"{name}.*half of a character"):
                call()

    def test_members_of_enumerations_are_their_values(self) -> None:
        self.assertEqual(an.Move(E.LAW, distance="90 deg", time="1 s"), an.Move("modified_sine", distance="90 deg", time="1 s"))
        self.assertEqual(repr(an.Arm(mass=E.MASS)), repr(an.Arm(mass="6 kg")))
        self.assertEqual(an.check(axis(), E.CODE), an.check(axis(), CODE))
        self.assertEqual(an.sweep(axis(), {"code": [E.CODE]}), an.sweep(axis(), {"code": [CODE]}))
        self.assertEqual(an.size(axis(), top=Whole.TWO), an.size(axis(), top=2))
        self.assertIn("ratio = 2\n", axis().replace(stage=an.Stage(kind="belt", ratio=Whole.TWO)).to_toml())

    def test_paths_of_keys_have_one_form(self) -> None:
        wrong = ("motion[1.time", "motion.01.time", "motion.\u0661.time", "motion]1[.time", "motion[1]].time", "motion[[1]].time", "motion..time", "motion.1.", "motion[-1].time", "motion[ 1].time", "motion[1]time")
        for path in wrong:
            with self.subTest(path):
                with self.assertRaisesRegex(an.AntriebError, "motion"):
                    axis().replace({path: "1 s"})
                with self.assertRaisesRegex((TypeError, ValueError), "motion"):
                    an.sweep(axis(), {f"{path} [s]": [1.0]})
        with self.assertRaisesRegex(an.AntriebError, 'Axis has no key "supplyx".*supply'):
            axis().replace(supplyx="1 V")
        self.assertEqual(an.sweep(axis(), {"mechanism.arm.angle": ["3 deg"]}), an.sweep(axis(), {"mechanism.arm.start_angle": ["3 deg"]}))

    def test_numbers_without_a_unit_are_answered_with_each_unit(self) -> None:
        with self.assertRaises(TypeError) as caught:
            an.Move("modified_sine", distance=math.pi / 2, time="1 s")
        self.assertTrue('"1.5707963267948966 deg"' in str(caught.exception) and '"1.5707963267948966 rad"' in str(caught.exception))
        with self.assertRaisesRegex(TypeError, 'mass="3.0 kg"'):
            an.Arm(mass=3.0)

    def test_calls_of_another_form_say_what_to_write(self) -> None:
        cases: list[tuple[typing.Any, str]] = [
            (lambda: an.size(axis(), "de"), "size.*lang="),
            (lambda: an.size(axis(), tops=3), "size.*did you mean 'top'"),
            (lambda: an.size(), "size.*text"),
            (lambda: an.plot(axis()), "figure.*torque_speed"),
            (lambda: an.size(axis(), text=axis()), "size.*twice"),
            (lambda: an.size(axis(), file=5), "file"),
            (lambda: an.loads("format = 1", name=5), "name"),
            (lambda: an.q(1), "q.*unit"),
            (lambda: an.q(1, "kg", 2), "q.*2"),
            (lambda: an.sweep(axis(), {}, grids=True), "sweep.*grid"),
            (lambda: an.Sweep(axis()), "Sweep.*schema"),
            (lambda: an.load("a.toml", "b"), "load.*'b'"),
            (lambda: an.axes_from_arrays([0.0]), "position"),
            (lambda: an.Recorded(time=[0.0], position=[1.0]), "axes_from_arrays"),
            (lambda: an.simulate(axis(), CODE).arrays(), "simulate.*svg"),
            (lambda: an.sweep(axis(), {MASS: [1.0]}, progress=int), "progress.*int"),
        ]
        for call, words in cases:
            with self.subTest(words), self.assertRaisesRegex((TypeError, ValueError), words):
                call()
        for name in questions.__all__:
            with self.subTest(name), self.assertRaisesRegex(TypeError, f"{getattr(questions, name).__name__} has no argument 'nonsense'"):
                getattr(an, name)(nonsense=1)
            self.assertIs(pickle.loads(pickle.dumps(getattr(an, name))), getattr(an, name))
            self.assertIn("lang", inspect.signature(getattr(an, name)).parameters)

    def test_hours_and_limits_are_within_their_range(self) -> None:
        for hours in (3, 5.5, "3", "5.5", "5.5 h", 24):
            self.assertTrue(an.battery(hours))
        self.assertEqual(an.battery(5.5), an.battery("5.5 h"))
        for hours in (-1, "-1", "nan", 25, "1000", "25 h", float("nan"), True):
            for call in (lambda hours=hours: an.battery(hours), lambda hours=hours: an.upkeep(CODE, "2020-01-01", hours_per_day=hours)):
                with self.subTest(hours), self.assertRaisesRegex((TypeError, ValueError), "hours_per_day"):
                    call()
        for limit in ("-1 s", "-1 h", datetime.timedelta(seconds=-1)):
            with self.subTest(limit), self.assertRaisesRegex(an.AntriebError, "deadline.*negative"):
                an.size(axis(), deadline=limit)

    def test_a_wrong_code_is_named_in_both_languages(self) -> None:
        for lang in ("en", "de"):
            with self.assertRaisesRegex(an.AntriebError, "^code: `55`"):
                an.check(axis(), "CHA-25A-55-H-C1024", lang=lang)

    def test_a_file_in_another_encoding_is_named(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "a.toml")
            file.write_bytes(("# ä\n" + axis().to_toml()).encode("latin-1"))
            with self.assertRaisesRegex(an.AntriebError, "a.toml:1:3.*UTF-8"):
                an.load(file)


class Kept(unittest.TestCase):
    """What stays true in another folder, another process and another protocol."""

    def test_recordings_are_found_from_another_folder(self) -> None:
        time, position, torque = arrays()
        robot = an.axes_from_arrays(time, position, torque=torque)
        before = os.getcwd()
        with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryDirectory() as other:
            pathlib.Path(folder, "sub").mkdir()
            robot.save(pathlib.Path(folder, "sub", "r.toml"))
            code = "import os, pickle, sys; import antrieb; project, sizing = pickle.load(sys.stdin.buffer); print(antrieb.size(project) == sizing)"
            try:
                os.chdir(folder)
                text = pathlib.Path("sub/r.toml").read_text(encoding="utf-8")
                projects = [an.load("sub/r.toml"), an.load(pathlib.Path("sub", "r.toml")), an.loads(text, folder="sub")]
                expected = [an.size(each) for each in projects]
                by_text = an.size(text, folder="sub")
                os.chdir(other)
                for project, sizing in zip(projects, expected, strict=True):
                    self.assertEqual(an.size(project), sizing)
                    self.assertEqual(an.size(project.replace({"axis.1.supply": "48 V"})).verdict, an.size(robot.replace({"axis.1.supply": "48 V"})).verdict)
                    done = subprocess.run([sys.executable, "-c", code], input=pickle.dumps((project, sizing)), capture_output=True, check=False, cwd=other)
                    self.assertEqual(done.stdout.strip(), b"True", done.stderr)
                self.assertEqual(len(by_text.axes[0].candidates), by_text.axes[0].judged)
            finally:
                os.chdir(before)

    def test_everything_is_pickled_in_every_protocol(self) -> None:
        import copy

        one = axis()
        made: list[typing.Any] = [
            one, an.Project([one]), an.q([1, 2], "kg"), an.size(one, top=2), an.size(one, top=2).best, an.plot(one, "cycle"), an.plot(one, "cycle", CODE),
            an.plot(one, "cycle", CODE).arrays(), an.sweep(one, {MASS: [1.0, 2.0]}), an.check(one, CODE).checks,
            an.sweep(one, {MASS: [1.0, 2.0], "motion.1.payload": ["1 kg", "2 kg"]}, grid=True).arrays(), an.explain(one, CODE, check="thermal"),
        ]
        for each in made:
            for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
                with self.subTest(type(each).__name__, protocol=protocol):
                    self.assertEqual(pickle.loads(pickle.dumps(each, protocol)), each)
            self.assertEqual(copy.copy(each), each)
            self.assertEqual(copy.deepcopy(each), each)
        picture = an.plot(one, "cycle")
        self.assertEqual((picture, hash(picture)), (an.plot(one, "cycle"), hash(an.plot(one, "cycle"))))
        self.assertNotEqual(picture, an.plot(one, "cycle", lang="de"))
        self.assertTrue(pickle.loads(pickle.dumps(picture)).arrays())

    def test_a_project_is_answered_by_its_axes(self) -> None:
        one, two = axis(), an.Axis("other", axis().mechanism, list(axis().motion), supply="560 V")
        calls: dict[str, tuple[typing.Any, ...]] = {"size": (), "check": (CODE,), "explain": (CODE,), "simulate": (CODE,), "compare": ([CODE, "CHA-25A-80-H-C1024"],), "bearing": ()}
        for command, given in calls.items():
            ask = getattr(an, command)
            held = {"bearing": an.Bearing(overhang="60 mm")} if command == "bearing" else {}
            one, two = one.replace(**held), two.replace(**held)
            single, several = ask(one, *given), ask(an.Project([one, two]), *given)
            for project in (an.Project([one]), [one]):
                with self.subTest(command, project=type(project).__name__):
                    found = ask(project, *given)
                    self.assertIs(type(found), type(several))
                    self.assertEqual([type(each) for each in found.axes], [type(single)])
                    self.assertEqual([getattr(each, "axis", "tilt") for each in found], ["tilt"])
                    self.assertEqual(found.verdict, several.verdict)
                    self.assertIs(type(ask(project, *given, axis="tilt")), type(single))
        found = an.diff(an.Project([one]), an.Project([one]))
        self.assertEqual([each.axis for each in found.axes], ["tilt"])
        self.assertIsInstance(found, an.answers.AxesOfDifference)

    def test_an_axis_that_none_fits_is_read_like_others(self) -> None:
        motion = [an.Move("modified_sine", distance="90 deg", time="0.8 s", payload="5 kg"), an.Dwell("1 s", hold="brake"), an.Return(time="0.6 s")]
        heavy = an.Axis("tilt", an.Arm(mass="30 kg", length="1.2 m", angle="-20 deg"), motion, brake=True, supply="560 V")
        best = an.size(heavy)
        self.assertEqual((best.fit, best.best.code), (0, None))
        self.assertEqual(len(best.candidates.to_dicts()), best.judged)
        self.assertIn("thermal", str(best.best.checks["thermal"].explain().id))
        self.assertEqual([each.best.code for each in an.size([heavy])], [None])

    def test_notebooks_show_projects_and_quantities(self) -> None:
        for each in (axis(), an.Project([axis()]), axis().mechanism, an.q(3, "kg"), an.q(range(100), "kg")):
            with self.subTest(type(each).__name__):
                self.assertLess(len(each._repr_html_()), 20_000)
        self.assertIn("mechanism.arm.mass", axis()._repr_html_())
        explained = an.explain(axis(), CODE, check="thermal")
        self.assertIn("<math", explained._repr_html_())
        self.assertEqual(str(explained).split("\n")[1:], str(explained.checks["thermal"]).split("\n"))
        self.assertLessEqual(len(repr(an.explain(axis(), CODE)).split("\n")), 20)

    def test_the_class_of_a_bar_shows_the_progress(self) -> None:
        seen: list[tuple[str, int]] = []

        class Bar:
            def __init__(self, total: int) -> None:
                seen.append(("total", total))

            def update(self, done: int) -> None:
                seen.append(("done", done))

            def close(self) -> None:
                seen.append(("closed", 0))

        an.sweep(axis(), {MASS: [1.0, 2.0, 3.0]}, progress=Bar)
        self.assertEqual((seen[0], seen[-1]), (("total", 3), ("closed", 0)))
        self.assertEqual(sum(done for word, done in seen if word == "done"), 3)

    def test_a_body_is_that_of_the_command_line(self) -> None:
        body = an.Body("disc", diameter="200 mm", length="20 mm", density="7850 kg/m^3", distance="50 mm", count=2)
        text = "disc diameter=200mm length=20mm density=7850kg/m^3 distance=50mm count=2"
        self.assertEqual(json.dumps(an.inertia(body).to_dict()), json.dumps(an.inertia(text).to_dict()))
        self.assertEqual(an.inertia([body, body]), an.inertia([text, text]))


if __name__ == "__main__":
    unittest.main()
