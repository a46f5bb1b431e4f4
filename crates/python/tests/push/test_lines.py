"""Pictures as arrays, and answers as rows of data frames."""

from __future__ import annotations

import importlib.util
import math
import os
import pathlib
import pickle
import tempfile
import typing
import unittest

import antrieb
from antrieb import answers, questions
from antrieb.examples import ARM

EXAMPLES = pathlib.Path(__file__).resolve().parents[4] / "examples"
PROJECT = EXAMPLES / "indexing-table.toml"
SEVERAL = EXAMPLES / "two-axes.toml"
CODE = "CHA-25A-50-H-C1024"
ENCODED = "CHA-25A-100-H-M512P-B"
FIGURES: tuple[typing.Any, ...] = ("torque_speed", "cycle", "utilisation", "torsion", "candidate_map")


class Grids(unittest.TestCase):
    """A sweep over two quantities as arrays."""

    TIMES, LOADS = (0.8, 1.0, 1.2), (0.5, 2.0)

    def swept(self) -> antrieb.Table:
        """Every time with every payload."""
        columns = {"motion.1.time": antrieb.q(self.TIMES, "s"), "motion.1.payload": antrieb.q(self.LOADS, "kg")}
        return antrieb.sweep(ARM, columns, grid=True)

    def test_the_values_of_a_grid_stand_by_both_columns(self) -> None:
        table = self.swept()
        grid = table.arrays()
        x, y, z = grid
        self.assertEqual((tuple(x), tuple(y)), (self.TIMES, self.LOADS))
        self.assertEqual(grid.axes, {"xlabel": "motion[1].time [s]", "ylabel": "motion[1].payload [kg]"})
        for row in table:
            place = y.index(row["motion[1].payload [kg]"]), x.index(row["motion[1].time [s]"])
            self.assertEqual(z[place[0]][place[1]], row["utilisation"])
        turned = table.arrays("code", x="motion[1].payload [kg]")
        self.assertEqual([*zip(*turned.z, strict=True)], [tuple(row) for row in table.arrays("code").z])
        if importlib.util.find_spec("pandas"):
            self.assertEqual(len(grid.to_pandas()), len(table))
        self.assertEqual(pickle.loads(pickle.dumps(grid)), grid)

    def test_what_is_no_grid_is_refused_with_its_columns(self) -> None:
        table = self.swept()
        self.assertRaisesRegex(KeyError, "utilization.*utilisation", table.arrays, "utilization")
        with self.assertRaisesRegex(TypeError, "grid=True or inputs=True"):
            antrieb.sweep(ARM, {"motion.1.time": antrieb.q(self.TIMES, "s")}).arrays()
        twice = antrieb.sweep(ARM, {"motion[1].time [s]": [1.0, 1.0, 1.1], "motion[1].payload [kg]": [1.0, 1.0, 2.0]}, inputs=True)
        self.assertRaisesRegex(TypeError, "several rows", twice.arrays)

    @unittest.skipUnless(importlib.util.find_spec("pandas"), "without pandas")
    def test_the_points_of_lines_are_rows(self) -> None:
        lines = antrieb.curve(CODE).arrays()
        frame = lines.to_pandas()
        self.assertEqual(len(frame), sum(len(line.x) for line in lines))
        self.assertEqual([*frame.columns[-2:]], ["x", "y"])
        first = frame[frame["name"] == lines[0].name]
        self.assertEqual([*first["y"]], lines[0].y)


class Pictures(unittest.TestCase):
    """Arrays with labels and units."""

    def test_every_figure_has_arrays_or_says_where_its_figures_are(self) -> None:
        figures = typing.get_args(typing.get_type_hints(questions.plot, {**vars(questions), "answers": answers})["figure"])
        for figure in figures:
            picture = antrieb.plot(PROJECT, figure, CODE)
            with self.subTest(figure=figure):
                if figure not in FIGURES:
                    self.assertRaisesRegex(TypeError, r"antrieb\.check", picture.arrays)
                    continue
                lines = picture.arrays()
                self.assertTrue(lines)
                for line in lines:
                    self.assertEqual(len(line.x), len(line.y))
                    self.assertTrue(line.x and line.name and line.x_label and line.y_label)
                    x, y = line
                    self.assertIs(x, line.x)
                    self.assertIs(y, line.y)
                    self.assertTrue(all(isinstance(each, float) for each in line.y))
                    self.assertEqual(set(line.axes), {"xlabel", "ylabel"})
                self.assertEqual(pickle.loads(pickle.dumps(picture)).arrays(), lines)

    def test_the_values_are_those_of_the_answers(self) -> None:
        (judged,) = antrieb.check(PROJECT, CODE).axes
        lines = antrieb.plot(PROJECT, "torque_speed", CODE).arrays()
        cycle = lines["cycle"]
        self.assertEqual(max(map(abs, cycle.y)), judged.checks["peak_torque"].value)
        self.assertEqual(max(map(abs, cycle.x)), judged.checks["peak_speed"].value)
        self.assertEqual((cycle.x_label, cycle.y_label), ("n [1/min]", "T [Nm]"))
        # The limits are those at the terminals, not those at the voltage of the link.
        terminal = judged.checks["voltage"].limit
        limits = antrieb.curve(CODE, voltage=f"{terminal!r} V").arrays()
        self.assertEqual(lines[: len(limits)], limits)
        self.assertEqual(max(y for line in limits for y in line.y), judged.checks["peak_torque"].limit)
        bars = antrieb.plot(PROJECT, "utilisation", CODE).arrays()[0]
        self.assertEqual((bars.kind, bars.y_unit, len(bars.x)), ("bars", "%", len(set(bars.x))))
        self.assertEqual(bars.y[bars.x.index("peak torque")], 100 * (judged.checks["peak_torque"].utilisation or 0.0))
        points = antrieb.plot(PROJECT, "candidate_map", CODE).arrays()
        self.assertEqual(sum(len(line.x) for line in points), antrieb.size(PROJECT).axes[0].judged)

    def test_the_torsion_curve_goes_through_every_answer(self) -> None:
        for torque in (3.0, 14.0, 30.0, 48.0, 60.0, -60.0):
            found = antrieb.torsion(CODE, torque=f"{torque} N m")
            curve, point = found.arrays()
            self.assertEqual([*point], [[torque], [found.angle_arcmin]])
            place = next(at for at in range(1, len(curve.x)) if curve.x[at] >= torque)
            (x0, x1), (y0, y1) = curve.x[place - 1 : place + 1], curve.y[place - 1 : place + 1]
            self.assertAlmostEqual(y0 + (torque - x0) / (x1 - x0) * (y1 - y0), point.y[0], places=8)

    def test_a_run_has_its_signals(self) -> None:
        text = antrieb.simulate(PROJECT, CODE, format="csv", every="5 ms")
        picture: typing.Any = antrieb.simulate(PROJECT, CODE, format="svg", every="5 ms")
        rows = [line.split(",") for line in typing.cast(str, text).splitlines()]
        lines = picture.arrays()
        self.assertEqual(len(lines), len(rows[0]) - 1)
        for place, line in enumerate(lines, 1):
            self.assertEqual(line.x, [float(row[0]) for row in rows[1:]])
            self.assertEqual(line.y, [float(row[place]) for row in rows[1:]])
        units = {line.name: line.y_unit for line in lines}
        self.assertEqual((units["torque"], units["speed"], units["winding"]), ("N m", "rad/s", "degC"))

    def test_a_picture_of_a_changed_project_has_none(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "axis.toml")
            text = PROJECT.read_text(encoding="utf-8")
            path.write_text(text, encoding="utf-8")
            picture = antrieb.plot(path, "cycle", CODE)
            path.write_text(text.replace("40 1/min", "30 1/min"), encoding="utf-8")
            self.assertRaisesRegex(ValueError, "changed", picture.arrays)

    def test_answers_without_a_picture_are_refused(self) -> None:
        self.assertRaisesRegex(TypeError, "curve", antrieb.units().arrays)
        # Its limits are not left out in silence.
        self.assertRaisesRegex(TypeError, "project's own", antrieb.plot(EXAMPLES / "manual-example.toml", "torque_speed").arrays)
        self.assertRaisesRegex(TypeError, "maker", antrieb.Picture("<svg/>").arrays)

    def test_a_missing_value_is_not_a_number(self) -> None:
        from antrieb import _lines

        line = _lines._line("a", [0.0, None], [None, 1.0], ("t", "s"), ("T", "Nm"))
        self.assertTrue(math.isnan(line.x[1]) and math.isnan(line.y[0]))

    @unittest.skipUnless(importlib.util.find_spec("matplotlib"), "Matplotlib is not installed")
    def test_matplotlib_draws_them(self) -> None:
        os.environ.setdefault("MPLBACKEND", "Agg")
        plt: typing.Any = importlib.import_module("matplotlib.pyplot")
        for figure in FIGURES:
            _, ax = plt.subplots()
            lines = antrieb.plot(PROJECT, figure, CODE).arrays()
            for line in lines:
                line.draw(ax)
            self.assertEqual(len(ax.get_legend_handles_labels()[1]), len(lines))
            self.assertTrue(ax.get_xlabel() and ax.get_ylabel())
            plt.close()


class Frames(unittest.TestCase):
    """Answers as rows."""

    def asked(self) -> list[tuple[typing.Any, int]]:
        """Answers with entries, and how many rows they have."""
        units, wiring, sheet = antrieb.units(), antrieb.wiring(ENCODED), antrieb.data(ENCODED)
        compared = antrieb.compare(PROJECT, [CODE, "CHA-25A-80-H-C1024"]).axes[0]
        several = antrieb.check(SEVERAL)
        curves = antrieb.curve(CODE)
        table = antrieb.export(PROJECT, CODE, table="course")
        found: list[tuple[typing.Any, int]] = [
            (units, sum(len(each.units) for each in units)),
            (wiring, sum(len(each.pins) for each in wiring)),
            (sheet, sum(max(len(each.values), 1) for each in sheet)),
            (compared, sum(answer is not None for row in compared.checks for answer in row.answers)),
            (several, sum(len(each.checks) for each in several.axes)),
            (curves, sum(len(each.points) + len(each.upper or []) for each in curves)),
            (table, len(table.rows)),
        ]
        own = [
            antrieb.diff(PROJECT, PROJECT, CODE), antrieb.moves(PROJECT), antrieb.size(PROJECT, top=3), antrieb.simulate(PROJECT, CODE),
            antrieb.commission(CODE), antrieb.code(CODE), antrieb.glossary(), antrieb.errata(), antrieb.licences(),
        ]  # fmt: skip
        for each in own:
            entries: typing.Any = each
            found.append((each, len(list(entries))))
        return found

    def test_every_list_is_a_data_frame(self) -> None:
        for answer, rows in self.asked():
            with self.subTest(type(answer).__name__):
                self.assertGreater(rows, 0)
                self.assertEqual(len(answer.to_pandas()), rows)
                self.assertEqual(answer.to_polars().height, rows)
                self.assertEqual(len(answer.to_dicts()), len(list(answer)))
                self.assertIsInstance(answer.to_dict(), dict)

    def test_what_entries_hold_is_in_the_frame(self) -> None:
        frame = antrieb.units().to_pandas()
        self.assertEqual(set(frame[frame["quantity"] == "torque"]["units.unit"]) >= {"N m"}, True)
        pins = antrieb.wiring(ENCODED)
        self.assertEqual(pins.to_polars()["role"].to_list(), [each.role for each in pins for _ in each.pins])
        self.assertEqual(antrieb.check(SEVERAL).to_polars()["axis"].unique(maintain_order=True).to_list(), ["swivel", "lift"])
        both = antrieb.compare(PROJECT, [CODE, "CHA-25A-80-H-C1024"]).to_polars()
        self.assertEqual(both["code"].to_list()[:2], [CODE, "CHA-25A-80-H-C1024"])

    def test_a_table_is_read_by_rows_and_by_columns(self) -> None:
        table = antrieb.export(PROJECT, CODE, table="course")
        self.assertEqual(list(table), table.rows)
        self.assertEqual(table[0], table.rows[0])
        self.assertEqual(table["torque"], [row["torque"] for row in table.rows])
        self.assertRaisesRegex(KeyError, "did you mean 'torque'", table.__getitem__, "torqe")

    def test_several_lists_are_not_guessed(self) -> None:
        self.assertRaisesRegex(TypeError, r"\.pilots\.to_pandas\(\)", antrieb.mount(CODE).to_pandas)
        picked: typing.Any = antrieb.size(PROJECT).axes[0].motion.units
        self.assertIsInstance(picked, dict)


class Refused(unittest.TestCase):
    """What would be ignored is refused."""

    def test_samples_without_tolerances(self) -> None:
        for given in ({"samples": 100}, {"seed": 3}):
            name = next(iter(given))
            with self.subTest(name):
                self.assertRaisesRegex(antrieb.AntriebError, f"{name}: the project has no tolerances", lambda: antrieb.size(PROJECT, **given))
                self.assertRaisesRegex(antrieb.AntriebError, f"{name}: .* ±", lambda: antrieb.check(SEVERAL, **given))
        self.assertTrue(antrieb.size(EXAMPLES / "tolerances.toml", top=1, samples=50).axes[0].ranking[0].tolerance)

    def test_the_name_of_a_path(self) -> None:
        self.assertRaisesRegex(TypeError, "^file is", lambda: antrieb.size(PROJECT, file="other.toml"))
        text = PROJECT.read_text(encoding="utf-8").replace("40 1/min", "40 parsec")
        self.assertRaisesRegex(antrieb.AntriebError, "^other.toml:", lambda: antrieb.size(text, file="other.toml"))

    def test_columns_of_different_lengths(self) -> None:
        self.assertRaisesRegex(
            ValueError, "'a' has 2, 'b' has 1", lambda: antrieb.Table.from_pydict({"a": [1, 2], "b": [1], "c": [3, 4]})
        )

    def test_a_project_of_arrays_says_what_it_holds(self) -> None:
        robot = antrieb.axes_from_arrays([0.0, 0.1, 0.2], [[0.0], [0.1], [0.0]], torque=[[1.0], [1.0], [1.0]], names=["a"], supply="560 V")
        for each in (robot, robot["a"]):
            text = repr(each)
            self.assertTrue(text.endswith("# with recordings that are in no file: a-1.csv; save writes them"), text)
            self.assertEqual(text.count("#"), 1)
            eval(text, vars(antrieb).copy())


if __name__ == "__main__":
    unittest.main()
