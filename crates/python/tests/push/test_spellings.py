"""Values, units and containers in every spelling that files have, and faults that name arguments."""

from __future__ import annotations

import csv
import io
import itertools
import typing
import unittest
import warnings

import duckdb
import numpy as np
import pandas as pd
import pint
import polars as pl
import pyarrow as pa

import antrieb

AXIS = antrieb.Axis(
    "tilt",
    antrieb.Arm(mass="6 kg", length="0.5 m", angle="-20 deg"),
    [antrieb.Move("modified_sine", distance="90 deg", time="0.8 s"), antrieb.Dwell("1 s"), antrieb.Return(time="0.6 s")],
    supply="560 V",
)
CODE = "CHA-17A-100-N-D2048-B"
ROLES = ("time_s", "position_rad", "motor_speed_rad_s", "torque_nm", "current_q_a")


class Runs(unittest.TestCase):
    """`identify` takes what `sweep` takes, in units of every spelling."""

    text: str
    run_of: dict[str, list[float]]
    known: typing.Any

    @classmethod
    def setUpClass(cls) -> None:
        cls.text = str(antrieb.simulate(AXIS, CODE, format="csv"))
        head, *rows = csv.reader(io.StringIO(cls.text))
        cls.run_of = {name: [float(row[head.index(name)]) for row in rows] for name in ROLES}
        cls.known = cls.values(cls.run_of)

    @classmethod
    def values(cls, trace: typing.Any) -> typing.Any:
        """What the run shows."""
        return antrieb.identify(trace, AXIS, CODE).to_dict()

    def test_units_of_every_spelling(self) -> None:
        plain = {name.partition("_")[0] if name != "motor_speed_rad_s" else "motor_speed": values for name, values in self.run_of.items()}
        plain["current_q"] = plain.pop("current")
        for unit in ("N m", "Nm", "N*m", "m*N", "N·m", "N.m"):
            table = {**plain, f"torque [{unit}]": plain["torque"]}
            del table["torque"]
            headings = {"time": "time [s]", "position": "position [rad]", "motor_speed": "motor_speed [rad/s]", "current_q": "current_q [A]"}
            named = {headings.get(name, name): values for name, values in table.items()}
            with self.subTest(unit):
                self.assertEqual(self.values(named), self.known)
        registry = pint.UnitRegistry()
        of_pint = {"time": "s", "position": "rad", "motor_speed": "rad/s", "torque": "N*m", "current_q": "A"}
        self.assertEqual(self.values({name: registry.Quantity(np.array(plain[name]), unit) for name, unit in of_pint.items()}), self.known)

    def test_every_container(self) -> None:
        frame = pl.DataFrame(self.run_of)
        own = self.values(self.text)
        for name, trace in {
            "polars": frame,
            "lazy": frame.lazy(),
            "arrow": pa.table(self.run_of),
            "duckdb": duckdb.sql("select * from frame"),
            "numpy": {key: np.array(values) for key, values in self.run_of.items()},
        }.items():
            with self.subTest(name):
                self.assertEqual(self.values(trace), self.known)
        content = self.text.encode()
        for kind in (bytes, bytearray, memoryview, io.BytesIO):
            with self.subTest(kind.__name__):
                self.assertEqual(self.values(kind(content)), own)
        self.assertEqual(self.values(io.StringIO(self.text)), own)

    def test_a_text_in_a_column_has_its_row(self) -> None:
        wrong: typing.Any = dict(self.run_of)
        wrong["torque_nm"] = ["x", *map(str, self.run_of["torque_nm"][1:])]
        with self.assertRaises(antrieb.AntriebError) as caught:
            self.values(wrong)
        self.assertRegex(str(caught.exception), "^trace: column 'torque_nm', row 0: a number is expected")


class Spellings(unittest.TestCase):
    """Quantities and numbers of other libraries."""

    def test_every_format_of_pint(self) -> None:
        registry = pint.UnitRegistry()
        quantities: list[tuple[float, str, str]] = [
            (1.25, "kg*m^2", "kg m^2"), (1.5e-7, "kg*m^2", "kg m^2"), (-90.0, "deg", "deg"), (90.0, "mm", "mm"), (40.0, "rpm", "1/min"),
            (12.0, "degC", "degC"), (3.0, "N*m", "N m"), (3.0, "rad/s**2", "rad/s^2"), (0.25, "m/s", "m/s"), (560.0, "V", "V"),
        ]
        makes: dict[str, typing.Callable[[str], typing.Any]] = {
            "kg m^2": lambda text: antrieb.Load(inertia=text),
            "deg": lambda text: antrieb.Move("triangle", distance=text, time="1 s"),
            "mm": lambda text: antrieb.Move("triangle", distance=text, time="1 s"),
            "1/min": lambda text: antrieb.Move("trapezoid", distance="90 deg", speed=text),
            "m/s": lambda text: antrieb.Move("trapezoid", distance="90 mm", speed=text),
            "rad/s^2": lambda text: antrieb.Move("trapezoid", distance="90 deg", acceleration=text),
            "N m": lambda text: antrieb.Load(inertia="1 kg m^2", friction_torque=text),
            "degC": lambda text: AXIS.replace(ambient=text),
            "V": lambda text: AXIS.replace(supply=text),
        }
        formats = ["".join(parts) for parts in itertools.product(("", ".2e", ".3g"), ("", "P", "~P", "H", "~H", "L", "~L", "Lx", "~Lx", "C", "~C", "D", "~D"))]
        for (number, unit, own), spec in itertools.product(quantities, formats):
            written = format(registry.Quantity(number, unit), spec)
            with self.subTest(written):
                made = makes[own](written)
                field = {"kg m^2": "inertia", "deg": "distance", "mm": "distance", "1/min": "speed", "m/s": "speed", "rad/s^2": "acceleration",
                         "N m": "friction_torque", "degC": "ambient", "V": "supply"}[own]
                text = getattr(made, field)
                self.assertEqual(float(text.split(" ")[0]), number)

    def test_long_doubles_are_numbers(self) -> None:
        values = np.array([4.0, 5.0], dtype=np.longdouble)
        plain = antrieb.sweep(AXIS, {"mass [kg]": [4.0, 5.0], "id": [4.0, 5.0]}).to_pydict()
        self.assertEqual(antrieb.sweep(AXIS, {"mass [kg]": values, "id": values}).to_pydict(), plain)
        self.assertEqual(antrieb.sweep(AXIS, {"mass [kg]": list(values), "id": [4.0, 5.0]}).to_pydict(), plain)
        with self.assertRaises(TypeError):
            antrieb.sweep(AXIS, {"mass [kg]": values.astype(np.clongdouble)})

    def test_a_column_is_in_its_table(self) -> None:
        table = antrieb.sweep(AXIS, {"mass [kg]": [4.0, 5.0]})
        self.assertIn("code", table)
        self.assertNotIn("nothing", table)
        self.assertNotIn(1, table)
        with self.assertRaises(TypeError):
            table[True]

    def test_a_wrong_code_of_a_column_has_near_ones(self) -> None:
        with self.assertRaises(antrieb.AntriebError) as caught:
            antrieb.sweep(AXIS, {"mass [kg]": [1.0], "code": ["CHA-17A-100-N-D2048-X"]})
        self.assertIn(CODE, [each.code for each in caught.exception.nearest])


class Faults(unittest.TestCase):
    """Messages name arguments and stay short."""

    def test_long_arguments_are_not_repeated_whole(self) -> None:
        long = "C" * 100_000
        calls: list[typing.Callable[[], typing.Any]] = [
            lambda: antrieb.size(AXIS, axis=long),
            lambda: antrieb.check(AXIS, long),
            lambda: antrieb.sweep(AXIS, {f"{long} [kg]": [1.0]}),
            lambda: antrieb.Arm(mass=long, length="1 m"),
            lambda: antrieb.Arm(mass="1 kg", length="1 m", shape=long),  # type: ignore[arg-type]
            lambda: antrieb.Arm(mass="1 kg", length="1 m", efficiency=long),  # type: ignore[arg-type]
            lambda: antrieb.size(long + "\n"),
        ]
        for place, call in enumerate(calls):
            with self.subTest(place), self.assertRaises((antrieb.AntriebError, TypeError)) as caught:
                call()
            self.assertLess(len(str(caught.exception)), 5_000)

    def test_arrays_are_named_as_arguments(self) -> None:
        t = np.linspace(0, 2, 201)
        q, torque = (1 - np.cos(np.pi * t)) / 2, 12 * np.cos(np.pi * t)
        make: typing.Any = antrieb.axes_from_arrays
        for call, names in (
            (lambda: make(t, q, torque=torque, time_unit="5 lux"), "^time_unit"),
            (lambda: make(t, q, torque=torque, position_unit="kg m"), "^position_unit"),
            (lambda: make(t, speed=q, torque=torque, speed_unit="N m"), "^speed_unit"),
            (lambda: antrieb.size(make(t, q, speed=1000 * np.sin(t), torque=torque)), "speed=None"),
            (lambda: antrieb.size(make(t, t, torque=torque)), "single_move=True"),
            (lambda: antrieb.size(make(t, q, torque=torque * 1e20)), "row 0: "),
        ):
            with self.subTest(names), self.assertRaises(antrieb.AntriebError) as caught:
                call()
            message = str(caught.exception)
            self.assertRegex(message, names)
            self.assertNotRegex(message, r'\.csv|line \d|"none"|units = \{|\[axis\]|recorded_ratio')
        for unit in ("N*m", "m N", "N·m"):
            self.assertEqual(len(make(t, q, torque=torque, torque_unit=unit)), 1)

    def test_odd_arguments_are_named(self) -> None:
        for call, message in (
            (lambda: antrieb.check(AXIS, [CODE, CODE]), "^code: one ordering code"),
            (lambda: antrieb.sweep(AXIS, {"a\0": [1.0], "mass [kg]": [1.0]}), "^table: the heading"),
            (lambda: antrieb.load("a\0b"), "^path: "),
            (lambda: antrieb.q("a", "kg"), "^value: "),
            (lambda: antrieb.Arm(mass="6 kg", length="1 m", efficiency="90 %"), "write efficiency=0.9$"),  # type: ignore[arg-type]
            (lambda: antrieb.report(AXIS, title=True), "^title is a text"),  # type: ignore[arg-type]
            (lambda: antrieb.upkeep_ical(CODE, delivered="2026-01-01", name=5), "^name is a text"),  # type: ignore[arg-type]
            (lambda: antrieb.sweep(AXIS, {"mass [kg]": [1.0]}, inputs=pl.DataFrame({"a": [1]})), "^inputs is True or False, not DataFrame$"),  # type: ignore[arg-type]
            (lambda: antrieb.axes_from_arrays([0, 1, 2], [0, 1, 0], torque=[0, 1, 0], names=pint.Quantity(3, "m")), "^names is a list"),  # type: ignore[arg-type]
        ):
            with self.subTest(message), self.assertRaises((antrieb.AntriebError, TypeError)) as caught:
                call()
            self.assertRegex(str(caught.exception), message)

    def test_headings_of_arrays_state_their_units(self) -> None:
        t = np.linspace(0, 2, 201)
        q, torque = 30 * (1 - np.cos(np.pi * t)), 12 * np.cos(np.pi * t)
        make: typing.Any = antrieb.axes_from_arrays
        plain = antrieb.size(make(t, np.radians(q), torque=torque, names=["J1"])).axes[0]
        for time, position, load in (
            (t, pd.DataFrame({"J1 [deg]": q}), torque),
            (t, {"J1 (deg)": q}, {"J1 [N m]": torque}),
            (t, pl.DataFrame({"J1 [deg]": q}), torque),
            (pd.Series(t * 1e3, name="t [ms]"), pd.Series(q, name="q [deg]"), pd.Series(torque * 1e3, name="M [mN m]")),
            (t, np.array(np.radians(q), dtype=[("J1 [rad]", "f8")]), torque),
        ):
            found = antrieb.size(make(time, position, torque=load, names=["J1"])).axes[0]
            self.assertEqual((found.answer, found.fitting), (plain.answer, plain.fitting))
        for call, message in (
            (lambda: make(t, pd.DataFrame({"J1 [deg]": q}), torque=torque, position_unit="rad"), "^position has the unit deg in its headings"),
            (lambda: make(t, pd.DataFrame({"a [deg]": q, "b": q}), torque=np.c_[torque, torque]), "^position: its columns are not all in one unit"),
            (lambda: make(t, pd.DataFrame({"a [grd]": q}), torque=torque), "^position: the unit of the column 'a .grd.' is not known"),
        ):
            with self.subTest(message), self.assertRaises((antrieb.AntriebError, TypeError)) as caught:
                call()
            self.assertRegex(str(caught.exception), message)
        self.assertEqual(len(make(t, pd.DataFrame({"J[1]": np.radians(q), "J (left)": q}), torque=np.c_[torque, torque])), 2)

    def test_tables_are_no_numbers(self) -> None:
        for table in (pd.DataFrame([[7], [8]]), pl.DataFrame({"a": [7]}), pa.table({"a": [7]}), {1: 2}):
            with self.subTest(type(table)), self.assertRaisesRegex(TypeError, "^value"):
                antrieb.q(table, "kg")

    def test_a_rate_per_minute_of_pint_has_an_angle(self) -> None:
        units = pint.UnitRegistry()
        for value in (units.Quantity(20, "1/min"), units.Quantity(10, "m/min") / units.Quantity(0.5, "m")):
            with self.subTest(value), self.assertRaisesRegex(antrieb.AntriebError, "has no angle"):
                antrieb.Move("jerk", distance="90 deg", speed=value, acceleration="10 rad/s^2", jerk="100 rad/s^3")
        with self.assertRaisesRegex(antrieb.AntriebError, "has no angle"):
            antrieb.Load(inertia="1 kg m^2", viscous_friction=units.Quantity(1, "N*m*min"))
        with self.assertRaisesRegex(antrieb.AntriebError, "has no angle"):
            antrieb.sweep(AXIS, {"motion.1.speed": units.Quantity([20.0, 30.0], "1/min")})
        antrieb.Load(inertia="1 kg m^2", viscous_friction=units.Quantity(1, "N*m*s"))
        antrieb.Screw(mass="5 kg", lead="10 mm", friction_force=units.Quantity(1, "N"))

    def test_columns_under_other_names_are_told(self) -> None:
        frame = pd.DataFrame({"motion.1.payload [kg]": [1.0, 2.0]}, index=pd.to_timedelta([1, 2], unit="s")).rename_axis("time")
        with self.assertWarnsRegex(UserWarning, r'"time \[s\]", state: motion\[1\].time'):
            antrieb.sweep(AXIS, frame)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            antrieb.sweep(AXIS, {"motion.1.payload [kg]": [1.0, 2.0], "id": [1, 2]})

    def test_what_has_no_name_is_told_the_names_that_fit(self) -> None:
        for call, message in (
            (lambda: antrieb.torsion(CODE, "1 N m"), "write it as in torque=…, angle=…$"),  # type: ignore[call-arg]
            (lambda: antrieb.Arm("1 kg"), "write it as in mass=…$"),  # type: ignore[arg-type]
            (lambda: antrieb.Move("jerk", "1 deg"), "write it as in distance=…$"),  # type: ignore[misc]
        ):
            with self.subTest(message), self.assertRaisesRegex(TypeError, message):
                call()

    def test_rows_of_a_run_are_those_of_its_arrays(self) -> None:
        t = np.linspace(0, 5, 5001)
        run = {"time [s]": t[::-1], "position [rad]": np.sin(t), "motor_speed [rad/s]": np.cos(t), "torque [N m]": np.cos(t), "current_q [A]": np.cos(t)}
        with self.assertRaisesRegex(antrieb.AntriebError, "^trace: row 1: the time"):
            antrieb.identify(run, AXIS, CODE)

    def test_a_text_of_numpy_is_a_text(self) -> None:
        self.assertEqual(antrieb.check(AXIS, np.str_(CODE)).code, CODE)
        self.assertEqual(len(antrieb.explain(AXIS, np.str_(CODE), check=typing.cast("typing.Any", np.str_("thermal"))).checks), 1)


if __name__ == "__main__":
    unittest.main()
