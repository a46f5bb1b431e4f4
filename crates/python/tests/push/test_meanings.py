"""One meaning for a key: as an object, as a file, as a heading; and equal objects answer alike."""

from __future__ import annotations

import datetime
import itertools
import os
import pathlib
import re
import tempfile
import typing
import unittest

import antrieb

CODE = "CHA-17A-100-N-D2048-B"


def axis(mechanism: typing.Any, unit: str = "deg", **more: typing.Any) -> antrieb.Axis:
    """An axis that moves there and back."""
    motion = [antrieb.Move("modified_sine", distance=f"90 {unit}", time="2 s", **more), antrieb.Dwell("1 s"), antrieb.Return(time="2 s")]
    return antrieb.Axis("t", mechanism, motion, supply="560 V", ambient="25 degC")


ARM = axis(antrieb.Arm(mass="6 kg", length="0.5 m", angle="-20 deg"))
SCREW = axis(antrieb.Screw(lead="20 mm", mass="5 kg"), "mm")
LOAD = axis(antrieb.Load(inertia="0.3 kg m^2"))
AXES = {"arm": ARM, "screw": SCREW, "load": LOAD}


def outcome(project: typing.Any, table: dict[str, typing.Any]) -> typing.Any:
    """The answers of a sweep, or the kind of its refusal."""
    try:
        found = antrieb.sweep(project, table, lang="en").to_pydict()
    except antrieb.AntriebError as error:
        return sorted({fault.id or "" for fault in error.faults})
    return found["fit"], found["code"], found["utilisation"], found["error"]


class Meanings(unittest.TestCase):
    """A project as objects, as its file, and loaded again."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_a_key_means_the_same_for_objects_and_files(self) -> None:
        headings = {
            "load.inertia [kg m^2]": [0.3, 0.4],
            "load.mass [kg]": [3.0, 4.0],
            "load.lead [mm]": [10.0, 20.0],
            "load.screw.mass [kg]": [3.0, 4.0],
            "mechanism.mass [kg]": [3.0, 4.0],
            "mechanism.inertia [kg m^2]": [0.3, 0.4],
            "mechanism.lead [mm]": [10.0, 20.0],
            "mechanism.arm.mass [kg]": [3.0, 4.0],
            "mechanism.angle [deg]": [-10.0, 10.0],
            "mass [kg]": [3.0, 4.0],
            "Masse [kg]": [3.0, 4.0],
            "mass_kg": [3.0, 4.0],
            "time_s": [2.5, 3.0],
            "motion.1.time_s": [2.5, 3.0],
            "time [s]": [2.5, 3.0],
            "supply_V": [500.0, 560.0],
            "Supply [V]": [500.0, 560.0],
            "ambient_degC": [25.0, 40.0],
            "payload_kg": [1.0, 2.0],
            "angle [deg]": [45.0, 60.0],
            "winkel_deg": [45.0, 60.0],
            "bearing.radial_force [N]": [10.0, 20.0],
            "stage.ratio": [2.0, 3.0],
        }
        for (name, project), (heading, values) in itertools.product(AXES.items(), headings.items()):
            path = self.folder / f"{name}.toml"
            project.save(path)
            with self.subTest(axis=name, heading=heading):
                found = outcome(project, {heading: values})
                self.assertEqual(found, outcome(path, {heading: values}))
                self.assertEqual(found, outcome(antrieb.load(path), {heading: values}))

    def test_a_load_is_none_of_a_mechanism(self) -> None:
        for change in ({"load.mass": "9 kg"}, {"load.lead": "5 mm"}, {"load.screw.mass": "9 kg"}, {"load": antrieb.Load(inertia="1 kg m^2")}):
            with self.subTest(change), self.assertRaises(antrieb.AntriebError) as caught:
                SCREW.replace(change)
            self.assertIn("mechanism.screw", str(caught.exception))
        with self.assertRaises(antrieb.AntriebError) as caught:
            antrieb.sweep(SCREW, {"load.inertia [kg m^2]": [0.001, 0.01]})
        self.assertEqual({fault.heading for fault in caught.exception.faults}, {"load.inertia [kg m^2]"})
        self.assertEqual(SCREW.replace({"mechanism.mass": "9 kg"}), SCREW.replace({"mechanism.screw.mass": "9 kg"}))
        self.assertEqual(LOAD.replace({"mechanism.inertia": "1 kg m^2"}), LOAD.replace({"load.inertia": "1 kg m^2"}))

    def test_an_angle_of_mechanism_and_moves_is_refused_with_both(self) -> None:
        for table in ({"angle": antrieb.q([-60, 45], "deg")}, {"angle [deg]": [-60.0, 45.0]}, {"Winkel_deg": [-60.0, 45.0]}):
            with self.subTest(table), self.assertRaises(antrieb.AntriebError) as caught:
                antrieb.sweep(ARM, table)
            (fault,) = [fault for fault in caught.exception.faults if fault.heading]
            self.assertIn("mechanism.arm.start_angle [deg]", fault.hint or "")
            self.assertIn("motion[1].distance [deg]", fault.hint or "")
        # Without such a mechanism it is the distance.
        self.assertIsInstance(outcome(LOAD, {"angle [deg]": [45.0, 60.0]}), tuple)

    def test_a_unit_behind_an_underscore_is_read(self) -> None:
        for plain, own in (("time_s", "time [s]"), ("mass_kg", "mass [kg]"), ("supply_V", "requirements.supply [V]"), ("ambient_degC", "requirements.ambient [degC]")):
            with self.subTest(plain):
                values = [450.0, 560.0] if "V" in plain else [2.5, 6.0]
                self.assertEqual(outcome(ARM, {plain: values}), outcome(ARM, {own: values}))
        swept = antrieb.sweep(ARM, {"mass_kg": [1.0, 2.0], "serial_s": [1.0, 2.0], "joint_deg": [1, 2]}).to_pydict()
        self.assertEqual((swept["serial_s"], swept["joint_deg"]), ([1.0, 2.0], [1, 2]))

    def test_equal_axes_answer_alike(self) -> None:
        path = self.folder / "return.toml"
        LOAD.save(path)
        loaded = antrieb.load(path)
        table = {"motion[1].distance [deg]": [30.0, 45.0]}
        # A written way back is a fixed distance.
        self.assertNotEqual(outcome(LOAD, table), outcome(loaded, table))
        self.assertNotEqual(LOAD, loaded)
        self.assertNotEqual(hash(LOAD), hash(loaded))
        self.assertEqual(loaded, antrieb.load(path))
        fixed = antrieb.Axis("t", antrieb.Load(inertia="0.3 kg m^2"), [
            antrieb.Move("modified_sine", distance="90 deg", time="2 s"), antrieb.Dwell("1 s"),
            antrieb.Move("modified_sine", distance="-90 deg", time="2 s"),
        ], supply="560 V", ambient="25 degC")
        self.assertEqual(fixed, loaded)
        self.assertEqual(hash(fixed), hash(loaded))
        self.assertEqual(outcome(fixed, table), outcome(loaded, table))

    def test_a_key_without_a_meaning_is_refused_once(self) -> None:
        for heading, values in {
            "load.inertia [kg m^2]": [0.1, 0.2],
            "motion[1].distance [mm]": [1.0, 2.0],
            "stage.ratio": [2.0, 3.0],
            "bearing.radial_force [N]": [1.0, 2.0],
        }.items():
            path = self.folder / "arm.toml"
            ARM.save(path)
            for project in (ARM, path):
                with self.subTest(heading), self.assertRaises(antrieb.AntriebError) as caught:
                    antrieb.sweep(project, {heading: values})
                self.assertIn(heading, {fault.heading for fault in caught.exception.faults})
        # Values decide about rows, not about keys.
        found = antrieb.sweep(ARM, {"motion[1].time [s]": [-1.0, 2.0]}).to_pydict()
        self.assertEqual([error is None for error in found["error"]], [False, True])

    def test_wrong_values_have_their_own_reason(self) -> None:
        with self.assertRaises(antrieb.AntriebError) as caught:
            antrieb.sweep(ARM, {"motion.1.payload": ["1 kg ± 10 %", "2 kg"]})
        self.assertIn("tolerance", str(caught.exception))
        times = [datetime.timedelta(seconds=2.5), datetime.timedelta(seconds=6)]
        for name in ("time", "dauer"):
            with self.subTest(name):
                self.assertEqual(outcome(ARM, {name: times}), outcome(ARM, {"time [s]": [2.5, 6.0]}))


class Files(unittest.TestCase):
    """Project files and lists of codes."""

    def test_a_file_is_overwritten_only_if_it_is_meant(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "axis.toml")
            written = "# by hand\n" + ARM.to_toml()
            path.write_text(written, encoding="utf-8")
            with self.assertRaises(antrieb.AntriebError) as caught:
                LOAD.save(path)
            self.assertIn("force=True", str(caught.exception))
            self.assertEqual(path.read_text(encoding="utf-8"), written)
            # The file from which it was loaded, with its comments.
            antrieb.load(path).replace({"motion.1.time": "3 s"}).save(path)
            self.assertIn("# by hand", path.read_text(encoding="utf-8"))
            LOAD.save(path, force=True)
            self.assertEqual(path.read_text(encoding="utf-8"), LOAD.to_toml())
            LOAD.save(path)

    def test_an_empty_list_is_no_value(self) -> None:
        calls: list[typing.Callable[[], typing.Any]] = [
            lambda: antrieb.check(ARM, []),
            lambda: antrieb.explain(ARM, []),  # type: ignore[arg-type]
            lambda: antrieb.plot(ARM, "cycle", code=[]),  # type: ignore[arg-type]
            lambda: antrieb.simulate(ARM, []),  # type: ignore[arg-type]
            lambda: antrieb.report(ARM, []),  # type: ignore[arg-type]
            lambda: antrieb.diff(ARM, LOAD, code=[]),  # type: ignore[arg-type]
            lambda: antrieb.sweep(ARM, {"mass_kg": [1.0]}, check=[]),
        ]
        for place, call in enumerate(calls):
            with self.subTest(place), self.assertRaises(antrieb.AntriebError) as caught:
                call()
            self.assertRegex(str(caught.exception), "(code|check): the list is empty")

    def test_a_wrong_project_is_named(self) -> None:
        for call, name in (
            (lambda: antrieb.diff(None, ARM), "old"),  # type: ignore[arg-type]
            (lambda: antrieb.diff(ARM, 3), "new"),  # type: ignore[arg-type]
            (lambda: antrieb.size(None), "text"),  # type: ignore[arg-type]
            (lambda: antrieb.size([ARM, 1]), "text"),  # type: ignore[list-item]
            (lambda: antrieb.sweep([1], {"mass_kg": [1.0]}), "text"),  # type: ignore[list-item]
        ):
            with self.subTest(name), self.assertRaises(TypeError) as caught:
                call()
            self.assertRegex(str(caught.exception), f"^{name}\\b")

    def test_every_refused_value_is_an_error_of_the_package(self) -> None:
        calls: list[typing.Callable[[], typing.Any]] = [
            lambda: antrieb.size(ARM, lang=""),  # type: ignore[arg-type]
            lambda: antrieb.sweep(ARM, []),
            lambda: antrieb.sweep(ARM, {"mass_kg": [1.0], "id": [1, 2]}),
            lambda: antrieb.identify({"time [s]": [0.0, 1.0], "torque [kg]": [0.0, 1.0]}, ARM, CODE),
            lambda: antrieb.identify({"time [s]": [0.0, 1.0], "torque [N m]": [0.0]}, ARM, CODE),
            lambda: antrieb.identify({}, ARM, CODE),
        ]
        for place, call in enumerate(calls):
            with self.subTest(place), self.assertRaises(antrieb.AntriebError):
                call()

    def test_a_day_is_a_day_of_any_library(self) -> None:
        expected = antrieb.upkeep(CODE, delivered="2026-01-05", today="2026-02-01", inspect="200 days")
        days: list[typing.Any] = [datetime.date(2026, 1, 5), datetime.datetime(2026, 1, 5)]
        try:
            import numpy
            import pandas

            days += [numpy.datetime64("2026-01-05"), numpy.datetime64("2026-01-05T00:00:00.000000000"), pandas.Timestamp("2026-01-05")]
        except ImportError:
            pass
        for day in days:
            with self.subTest(repr(day)):
                found = antrieb.upkeep(CODE, delivered=day, today="2026-02-01", inspect=datetime.timedelta(days=200))
                self.assertEqual(found, expected)
        with self.assertRaises(antrieb.AntriebError) as caught:
            antrieb.upkeep(CODE, delivered=datetime.datetime(2026, 1, 5, 12))  # type: ignore[arg-type]
        self.assertRegex(str(caught.exception), "delivered: a day is expected")
        with self.assertRaises(antrieb.AntriebError) as caught:
            antrieb.upkeep(CODE, delivered="2026-01-05", inspect=datetime.timedelta(hours=5))  # type: ignore[arg-type]
        self.assertRegex(str(caught.exception), "inspect: whole days")

    def test_answers_show_tables_of_twenty_lines(self) -> None:
        shown: dict[str, typing.Any] = {
            "bearing": antrieb.bearing(ARM),
            "curve": antrieb.curve(CODE),
            "data": antrieb.data(CODE),
            "errata": antrieb.errata(),
            "units": antrieb.units(),
            "moves": antrieb.moves(ARM),
            "wiring": antrieb.wiring(CODE, length="5 m"),
            "upkeep": antrieb.upkeep(CODE, delivered="2026-01-05"),
            "commission": antrieb.commission(CODE),
        }
        simulated, encoder = antrieb.simulate(ARM, CODE), antrieb.encoder(CODE)
        shown |= {"simulate": simulated, "summary": simulated.summary, "gains": simulated.gains, "signals": encoder.signals}
        for name, record in shown.items():
            with self.subTest(name):
                lines = repr(record).split("\n")
                self.assertLessEqual(len(lines), 20)
                self.assertTrue(any(line.startswith("──") for line in lines), repr(record))
                self.assertIn("<table", record._repr_html_())

    def test_a_rejection_says_where_its_checks_are(self) -> None:
        rejected = next(each for each in antrieb.size(ARM).candidates if type(each).__name__ == "Rejection")
        with self.assertRaises(AttributeError) as caught:
            rejected.checks  # type: ignore[union-attr]  # noqa: B018
        self.assertIn("antrieb.check(project, code)", str(caught.exception))

    def test_answers_name_arguments_and_no_options(self) -> None:
        found = str(antrieb.upkeep(CODE, delivered="2026-01-05").to_dict()) + str(antrieb.check(ARM).to_dict())
        self.assertEqual(re.findall(r"--[a-z]+", found), [])


if __name__ == "__main__":
    os.environ.setdefault("PYTHONHASHSEED", "0")
    unittest.main()
