"""Projects as typed objects: every key of the declaration as a keyword and back, texts and objects alike, arrays, sweeps."""

from __future__ import annotations

import copy
import json
import math
import pathlib
import pickle
import random
import tempfile
import tomllib
import typing
import unittest

import antrieb as an
from antrieb import sections

EXAMPLES = pathlib.Path(__file__).resolve().parents[4] / "examples"
PROJECTS = sorted(EXAMPLES.glob("*.toml"))
CLASSES = [of for of in vars(sections).values() if isinstance(of, type) and issubclass(of, an.Section) and of.__module__ == sections.__name__]


def axis(**fields: typing.Any) -> an.Axis:
    """An arm that swings up, is held, and comes back."""
    motion = [
        an.Move("modified_sine", distance="90 deg", time="0.8 s", payload="2 kg"),
        an.Dwell("1 s", hold="brake"),
        an.Return(time="0.6 s"),
    ]
    return an.Axis("tilt", an.Arm(mass="6 kg", length="0.5 m", angle="-20 deg"), motion, **{"brake": True, "supply": "560 V", **fields})


def sample(kind: typing.Any, chance: random.Random) -> typing.Any:
    """A value that a keyword can have."""
    match kind.of:
        case "quantity":
            number, unit = kind.example.split(" ", 1)
            return f"{round(float(number) * chance.uniform(0.5, 2), 3)} {unit}"
        case "number" | "integer":
            return json.loads(kind.example)
        case "numbers":
            return tuple(json.loads(kind.example))
        case "bool":
            return chance.random() < 0.5
        case "text":
            return chance.choice(["plain", 'with "quotes"', "back\\slash", "äöü — ±", "# no comment", "a = [b]"])
        case "word":
            return chance.choice(kind.words)
        case "words":
            return tuple(chance.sample(kind.words, min(2, len(kind.words))))
        case "rows":
            return tuple(tuple(row) for row in json.loads(kind.example))
        case "texts":
            return ("disc diameter=300mm length=20mm mass=5kg", "point mass=3kg distance=550mm")
        case "table":
            return made(getattr(sections, kind.table), chance)
        case "tables" if kind.table == "Segment":
            of = [each for each in CLASSES if issubclass(each, sections.Segment) and each is not an.Return]
            return tuple(made(chance.choice(of), chance) for _ in range(chance.randint(1, 4)))
        case "tables":
            return tuple(made(getattr(sections, kind.table), chance) for _ in range(2))
        case "mechanism":
            return made(chance.choice([each for each in CLASSES if issubclass(each, sections.LoadOrMechanism)]), chance)
    raise AssertionError(kind)


def made(of: typing.Any, chance: random.Random, share: float = 0.6) -> typing.Any:
    """An object of a class with some of its keywords."""
    must = {"law", "name", "mechanism", "motion", "axis", "time", "kind", "shape"}
    kinds = {name: kind for name, kind in of._KEYS.items() if kind.of != "alias"}
    hints = typing.get_type_hints(of.__init__)
    given = {}
    for name, kind in kinds.items():
        is_open = type(None) in typing.get_args(hints[name])
        if not is_open or name in must or chance.random() < share:
            given[name] = sample(kind, chance)
    return of(**given)


def answered(project: typing.Any) -> typing.Any:
    """The answer about a project, or what is missing in it."""
    try:
        return an.size(project, top=2)
    except an.AntriebError as error:
        return [fault.message for fault in error.faults]


class Faults(unittest.TestCase):
    """Faults of whole projects, and texts from other systems."""

    def test_a_fault_of_a_project_of_objects_names_the_argument(self) -> None:
        move, back = an.Move("modified_sine", distance="90 deg", time="0.8 s"), an.Return(time="0.6 s")
        arm = an.Arm(mass="6 kg", length="0.5 m")
        for wrong, named in (
            (an.Axis("a", arm, []), "motion"),
            (an.Axis("a", arm, [move]), "motion[1]"),
            (an.Axis("a", arm, [move, back], mains="400 V", supply="560 V"), "mains"),
        ):
            for ask in (an.size, lambda axis: an.sweep(axis, {"code": ["CHA-25A-50-H-C1024"]})):
                with self.subTest(named), self.assertRaises(an.AntriebError) as caught:
                    ask(wrong)
                fault = caught.exception.faults[0]
                self.assertTrue(isinstance(fault, an.answers.Fault) and fault.option and fault.option.startswith(named), str(caught.exception))
                self.assertIsNone(fault.line)
                self.assertIn(named, str(caught.exception))

    def test_a_fault_of_a_text_has_its_line_and_the_word_that_is_meant(self) -> None:
        with self.assertRaises(an.AntriebError) as caught:
            an.size(axis().to_toml().replace("[mechanism", "[mechanisms", 1))
        self.assertIn("mechanism", caught.exception.meant)
        self.assertTrue(all(isinstance(each, an.answers.Fault) and each.line for each in caught.exception.faults))

    def test_ends_of_lines_stay_as_they_are(self) -> None:
        text = ("# head\n" + axis().to_toml()).replace("\n", "\r\n")
        read = an.loads(text)
        self.assertEqual(read.to_toml(), text)
        changed = read.replace(supply="48 V").to_toml()
        self.assertEqual(changed, text.replace("560 V", "48 V"))
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "a.toml")
            file.write_bytes(text.encode())
            an.load(file).save(file)
            self.assertEqual(file.read_bytes(), text.encode())


class Projects(unittest.TestCase):
    """Objects and their files."""

    def test_every_key_is_a_keyword_and_comes_back(self) -> None:
        known: dict[tuple[str, str], typing.Any] = {}
        for of in CLASSES:
            for name, kind in of._KEYS.items():
                if kind.of == "alias" or of in (an.Axis, an.Project, an.Return):
                    continue
                with self.subTest(of=of.__name__, key=name):
                    value = sample(kind, random.Random(name))
                    rest = {key: sample(each, random.Random(key)) for key, each in of._KEYS.items() if each.of != "alias"}
                    one = of(**{**rest, name: value})
                    self.assertEqual(getattr(one, name), value)
                    document = one._document()
                    self.assertIn(name.rstrip("_"), document)
                    self.assertEqual(of._read(document, ""), one)
                    known[of._TABLE, name.rstrip("_")] = kind
        for name in an.Axis._REQUIREMENTS:
            value = sample(an.Axis._KEYS[name], random.Random(name))
            one = axis(**{name: value})
            self.assertEqual(getattr(one, name), value)
            self.assertEqual(getattr(an.loads(one.to_toml()), name), value)

    def test_generated_projects_come_back_from_their_text(self) -> None:
        for seed in range(120):
            chance = random.Random(seed)
            one = made(an.Axis, chance, chance.choice([0.1, 0.5, 0.9]))
            with self.subTest(seed=seed):
                document = tomllib.loads(one.to_toml())
                again = an.Axis._of_document({**{k: v for k, v in document.items() if k not in ("format", "axis")}, **document["axis"]}, "")
                self.assertEqual(again, one)
                self.assertEqual(eval(repr(one), vars(an)), one)
                self.assertEqual(pickle.loads(pickle.dumps(one)), one)
                self.assertEqual(hash(again), hash(one))

    def test_examples_are_the_same_as_objects(self) -> None:
        self.assertGreater(len(PROJECTS), 15)
        for file in PROJECTS:
            with self.subTest(file.name):
                text = file.read_text(encoding="utf-8")
                of_file = an.load(file)
                self.assertEqual(of_file.to_toml(), text)
                fresh: typing.Any = eval(repr(of_file), vars(an))
                self.assertEqual(fresh, of_file)
                self.assertEqual(tomllib.loads(fresh.to_toml()), tomllib.loads(text))
                self.assertEqual(an.size(fresh, top=1, folder=EXAMPLES), an.size(file, top=1))
                self.assertEqual(an.size(of_file, top=1), an.size(file, top=1))
                self.assertEqual(copy.deepcopy(of_file), of_file)

    def test_templates_are_the_same_as_objects(self) -> None:
        kinds = typing.get_args(typing.get_type_hints(an.new)["kind"])
        self.assertGreater(len(kinds), 12)
        for kind in kinds:
            for example in (False, True):
                with self.subTest(kind=kind, example=example):
                    try:
                        text = an.new(kind, lang="de", example=example)
                    except an.AntriebError:
                        # A kind without a rich example, or one that needs a key.
                        continue
                    try:
                        of_text: typing.Any = an.loads(text)
                    except an.AntriebError:
                        # A table of a sweep, and a catalogue file.
                        self.assertIn(kind, ("sweep", "catalogue"))
                        continue
                    self.assertEqual(of_text.to_toml(), text)
                    fresh = eval(repr(of_text), vars(an))
                    self.assertEqual(fresh, of_text)
                    # The figures of a template count as assumed as long as its first line stands; those of objects are stated.
                    own = text.split("\n", 1)[1]
                    self.assertEqual(answered(fresh), answered(own))
                    changed = of_text.replace(supply="48 V").to_toml()
                    self.assertEqual(an.loads(changed).axes[0].supply, "48 V")
                    self.assertEqual(changed.splitlines()[0], text.splitlines()[0])

    def test_a_change_keeps_the_comments(self) -> None:
        chance = random.Random(3)
        for file in PROJECTS:
            before = an.load(file)
            if not isinstance(before, an.Axis):
                continue
            places = len(before.motion)
            changes: list[dict[str, typing.Any]] = [
                {"supply": "48 V"},
                {"brake": None, "ambient": "31 degC"},
                {"feedback": ["RES"]},
                {"motion": (*before.motion, an.Dwell("1.5 s", hold="motor"))},
                {"motion": before.motion[: max(1, places - 1)]},
                {"mechanism": an.Load(inertia="1 kg m^2")},
                {"stage": an.Stage(kind="belt", ratio=2.0)},
                {"twin": an.Twin(scenario="cycle", measured=an.Measured(brake_torque="3 N m"))},
                {"bearing": None},
                {f"motion.{chance.randint(1, places)}.payload": "1.25 kg"},
            ]
            for change in changes:
                with self.subTest(file=file.name, change=list(change)):
                    try:
                        after = before.replace(change)
                    except an.AntriebError:
                        # A segment without such a keyword.
                        continue
                    text = after.to_toml()
                    self.assertEqual(tomllib.loads(text), after._document())
                    first = before.to_toml().splitlines()[0]
                    if first.startswith("#"):
                        self.assertEqual(text.splitlines()[0], first)

    def test_a_return_ends_where_the_motion_began(self) -> None:
        self.assertIn('distance = "-90 deg"', axis().to_toml())
        moves = [an.Move("trapezoid", distance="0.1 rev", time="1 s"), an.Move("jerk", distance="0.25 rev", speed="1 rev/s", acceleration="9 rad/s^2", jerk="99 rad/s^3")]
        one = an.Axis("a", an.Load(inertia="1 kg m^2"), [*moves, an.Return(time="1 s"), moves[0], an.Return(time="2 s", law="triangle")])
        back = [segment for segment in an.loads(one.to_toml()).axes[0].motion]
        self.assertEqual([segment._document()["distance"] for segment in back], ["0.1 rev", "0.25 rev", "-0.35 rev", "0.1 rev", "-0.1 rev"])
        self.assertEqual([segment._document()["law"] for segment in back][2:], ["jerk", "trapezoid", "triangle"])
        for motion in ([an.Return(time="1 s")], [moves[0], an.Move("triangle", distance="5 deg", time="1 s"), an.Return(time="1 s")],
                       [an.Move("constant", speed="5 1/min", time="1 s"), an.Return(time="1 s")], [an.Recorded("a.csv"), an.Return(time="1 s")],
                       [an.Move("triangle", distance="5 deg ± 1 %", time="1 s"), an.Return(time="1 s")]):
            with self.assertRaisesRegex(an.AntriebError, "Return"):
                an.Axis("a", an.Load(inertia="1 kg m^2"), motion).to_toml()

    def test_a_faulty_text_is_refused_with_its_places(self) -> None:
        text = (EXAMPLES / "turntable.toml").read_text(encoding="utf-8")
        for wrong in ("[requirements", text.replace("[requirements]", "[requirement]"), text.replace('time = "', 'times = "', 1),
                      text.replace("format = 1", "format = 2"), text.replace('"', "", 2), text + "\n[load]\ninertia = \"1 kg m^2\"\n"):
            with self.assertRaises(an.AntriebError) as found:
                an.loads(wrong)
            self.assertTrue(all(fault.line for fault in found.exception.faults if isinstance(fault, an.answers.Fault)))

    def test_arms_need_no_shape(self) -> None:
        judged = an.size(axis(), top=1)
        assumed = {each.key: each.value for each in judged.axes[0].assumptions}
        self.assertEqual(assumed["mechanism.arm.shape"], "rod")
        self.assertEqual(assumed["mechanism.arm.payload_distance"], "500 mm")
        stated = axis().replace({"mechanism.shape": "rod", "mechanism.payload_distance": "500 mm"})
        same = an.size(stated, top=1).axes[0]
        self.assertEqual(same.ranking, judged.axes[0].ranking)
        self.assertFalse({"mechanism.arm.shape", "mechanism.arm.payload_distance"} & {each.key for each in same.assumptions})


class Sweeps(unittest.TestCase):
    """Sweeps by the keys of an axis."""

    def test_a_grid_is_every_combination(self) -> None:
        loads, times = an.q([0.5, 1, 2], "kg"), ["0.6 s", "0.8 s"]
        table = an.sweep(axis(), {"motion.1.payload": loads, "motion.1.time": times}, grid=True).to_pydict()
        self.assertEqual(len(table["row"]), 6)
        for row, (load, time) in enumerate((load, time) for load in loads for time in times):
            one = an.size(axis().replace({"motion.1.payload": load, "motion.1.time": time}), top=1).axes[0]
            self.assertEqual(table["code"][row], one.answer)
            # The record has twelve digits.
            self.assertAlmostEqual(table["utilisation"][row], one.ranking[0].utilisation or 0, places=11)

    def test_a_way_back_follows_its_distance(self) -> None:
        table = an.sweep(axis(), {"motion.1.distance": an.q([60, 90, 120], "deg")}).to_pydict()
        for row, distance in enumerate(("60 deg", "90 deg", "120 deg")):
            one = an.size(axis().replace({"motion.1.distance": distance}), top=1).axes[0]
            self.assertEqual((table["code"][row], table["error"][row]), (one.answer, None))

    def test_keys_of_an_axis_are_those_of_its_file(self) -> None:
        short = an.sweep(axis(), {"supply": an.q([48, 560], "V"), "mechanism.mass": ["3 kg", "4 kg"]})
        long = an.sweep(axis().to_toml(), {"requirements.supply [V]": [48, 560], "mechanism.arm.mass [kg]": [3.0, 4.0]})
        self.assertEqual(short.to_pydict(), long.to_pydict())

    def test_a_wrong_column_is_refused(self) -> None:
        for table, words in (
            ({"motion.0.payload": an.q([1], "kg")}, "motion.1.payload"),
            ({"motion[0].payload": an.q([1], "kg")}, "motion.1.payload"),
            ({"motion.1.payload": ["1 kg", "200 g"]}, "g and kg"),
            ({"motion.1.payload": an.q([1, 2], "kg"), "motion.1.time": ["1 s"]}, "grid=True"),
            ({"motion.1.payload": [1, 2]}, "unit"),
            ({"motion.1.payloads": an.q([1], "kg")}, "payload"),
            ({"motion.1.payload [kg]": an.q([1], "kg")}, "unit already"),
        ):
            with self.subTest(table=table), self.assertRaisesRegex(an.AntriebError, words):
                an.sweep(axis(), table)
        for value in (3, True, None, {"a": 1}):
            with self.assertRaisesRegex(TypeError, r"motion\.1\.payload"):
                an.sweep(axis(), {"motion.1.payload": value})


class Arrays(unittest.TestCase):
    """Axes out of arrays."""

    def test_the_axes_are_those_of_files(self) -> None:
        time = [0.01 * step for step in range(201)]
        position = [[reach * (1 - math.cos(math.pi * step)) for reach in (0.3, 0.2)] for step in time]
        torque = [[5 + step, 3 - step] for step in time]
        robot = an.axes_from_arrays(time, position, torque=torque, names=["lift", "turn"], supply="560 V")
        found = an.size(robot, top=1)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "robot.toml"
            robot.save(file)
            # The recordings of a saved project are named after it.
            self.assertEqual(str(an.size(file, top=1).to_dict()).replace("robot-", ""), str(found.to_dict()))
            self.assertEqual(an.size(an.load(file), top=1), an.size(file, top=1))
            self.assertEqual(an.size(an.load(file)["turn"], top=1).answer, found.axes[1].answer)
        self.assertEqual([each.axis for each in found.axes], ["lift", "turn"])
        self.assertEqual(an.size(list(pickle.loads(pickle.dumps(robot))), top=1), found)
        self.assertEqual(an.size(robot["turn"], top=1).axes[0].answer, found.axes[1].answer)
        degrees = [[value * 57.29577951308232 for value in row] for row in position]
        same = an.axes_from_arrays(time, degrees, torque=torque, names=["lift", "turn"], position_unit="deg", supply="560 V")
        self.assertEqual([each.answer for each in an.size(same).axes], [each.answer for each in found.axes])

    def test_arrays_that_do_not_belong_together_are_refused(self) -> None:
        time, one = [0.0, 0.1, 0.2], [[0.0, 0.0], [0.1, 0.1], [0.0, 0.0]]
        cases: list[tuple[dict[str, typing.Any], str]] = [
            ({"position": [[0.0, 0.1, 0.0], [0.0, 0.1, 0.0]], "torque": one}, r"position\.T"),
            ({"position": one}, "torque"),
            ({"position": one, "torque": [1.0, 1.0, 1.0]}, "torque has 1"),
            ({"position": one, "torque": one, "names": ["a"]}, "names"),
            ({"position": one, "torque": one, "names": "ab"}, "names"),
            ({"position": one, "torque": one, "names": ["a", "a"]}, "names"),
            ({"position": [[0.0, float("nan")]] * 3, "torque": one}, r"position\[0\]\[1\]"),
            ({"position": "q", "torque": one}, "position"),
            ({"position": one, "torque": one, "torque_unit": 3}, "unit"),
            ({"torque": one}, "position or speed"),
            ({"position": [[0.0], [0.1, 0.2], [0.0]], "torque": one}, "lengths"),
            ({"position": one, "torque": one, "supplies": "560 V"}, "supplies"),
            ({"position": one, "torque": one, "mechanism": an.Arm(mass="1 kg", length="1 m")}, "second time"),
            ({"position": one, "torque": one, "mechanism": [an.Joint(), an.Load(inertia="1 kg m^2")]}, "second time"),
            ({"position": one, "torque": one, "names": [1, 2]}, r"names\[0\]"),
            ({"position": one, "torque": one, "names": 2}, "names"),
            ({"position": one, "torque": one, "speed_unit": "1/min"}, "speed_unit"),
            ({"position": one, "torque": one, "time": an.q(time, "s"), "time_unit": "ms"}, "time_unit"),
        ]
        for given, words in cases:
            with self.subTest(words=words), self.assertRaisesRegex((TypeError, an.AntriebError), words):
                an.axes_from_arrays(given.pop("time", time), **given)
        for role, values in (("position", one), ("speed", one), ("torque", one)):
            column = an.q([row[0] for row in values], "N m" if role == "torque" else "deg" if role == "position" else "deg/s")
            others = {"position": [0.0, 0.1, 0.0], "torque": [1.0, 1.0, 1.0]}
            with self.subTest(role=role), self.assertRaisesRegex(TypeError, f"{role}_unit"):
                an.axes_from_arrays(time, **{**others, role: column, f"{role}_unit": "rad"})


class Saved(unittest.TestCase):
    """Projects and their recordings in files."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def robot(self, share: float) -> an.Project:
        time = [0.01 * step for step in range(201)]
        position = [[0.3 * (1 - math.cos(math.pi * step)), 0.2 * (1 - math.cos(math.pi * step))] for step in time]
        return an.axes_from_arrays(time, position, torque=[[share * (5 + step), share * (3 - step)] for step in time], supply="560 V")

    def contents(self) -> dict[str, bytes]:
        return {str(file.relative_to(self.folder)): file.read_bytes() for file in self.folder.rglob("*") if file.is_file()}

    def test_projects_of_one_folder_keep_their_recordings(self) -> None:
        light, heavy = self.robot(1.0), self.robot(8.0)
        light.save(self.folder / "light.toml")
        before = an.size(self.folder / "light.toml", top=1)
        heavy.save(self.folder / "heavy.toml")
        self.assertEqual(an.size(self.folder / "light.toml", top=1), before)
        self.assertEqual(an.size(self.folder / "heavy.toml", top=1)["J1"].answer, an.size(heavy, top=1)["J1"].answer)
        light.save(self.folder / "light.toml")
        (self.folder / "own-J2-2.csv").write_text("not ours", encoding="utf-8")
        whole = self.contents()
        for name in ("light.toml", "own.toml"):
            with self.subTest(name), self.assertRaisesRegex(an.AntriebError, name.replace(".toml", "-J")):
                heavy.save(self.folder / name)
            self.assertEqual(self.contents(), whole)
        one = heavy["J2"]
        one.save(self.folder / "one.toml")
        self.assertEqual(an.size(self.folder / "one.toml", top=1).axes[0].answer, an.size(one, top=1).axes[0].answer)

    def test_a_project_that_is_saved_elsewhere_takes_its_recordings_along(self) -> None:
        here, there = self.folder / "here", self.folder / "there"
        here.mkdir()
        there.mkdir()
        self.robot(1.0).save(here / "robot.toml")
        loaded = an.load(here / "robot.toml")
        found = an.size(loaded, top=1)
        loaded.save(here / "again.toml")
        loaded.save(there / "robot.toml")
        loaded["J1"].save(there / "one.toml")
        self.assertEqual(an.size(there / "robot.toml", top=1), found)
        self.assertEqual(an.size(here / "again.toml", top=1), found)
        self.assertEqual(an.size(there / "one.toml", top=1).axes[0].answer, found["J1"].answer)
        (there / "robot-J1-1.csv").write_text("other", encoding="utf-8")
        whole = self.contents()
        with self.assertRaisesRegex(an.AntriebError, "robot-J1-1.csv"):
            loaded.save(there / "robot.toml")
        (here / "robot-J1-1.csv").unlink()
        whole.pop(str(pathlib.Path("here", "robot-J1-1.csv")))
        with self.assertRaisesRegex(an.AntriebError, "missing"):
            loaded.save(there / "robot.toml")
        self.assertEqual(self.contents(), whole)
        example = an.load(EXAMPLES / "robot-joint.toml")
        example.save(self.folder / "joint.toml")
        self.assertEqual(an.size(self.folder / "joint.toml", top=1), an.size(example, top=1))

    def test_other_endings_and_folders_are_refused(self) -> None:
        made_by: typing.Any = an
        for name in ("axis.json", "axis", "axis.yaml"):
            with self.assertRaisesRegex(an.AntriebError, r"\.toml"):
                axis().save(self.folder / name)
        for name in ("a.png", "b.jpg", "c.pdf", "d"):
            with self.assertRaisesRegex(ValueError, "SVG"):
                an.Picture("<svg/>").save(self.folder / name)
        an.Picture("<svg/>").save(self.folder / "e.SVG")
        with self.assertRaises(TypeError):
            made_by.Axis.save(axis(), 3)
        with self.assertRaises(FileNotFoundError):
            axis().save(self.folder / "nowhere" / "axis.toml")
        self.assertEqual(list(self.contents()), ["e.SVG"])
        for ask in (lambda: an.size(axis(), folder="nowhere"), lambda: an.loads(axis().to_toml(), folder="nowhere")):
            with self.assertRaisesRegex(NotADirectoryError, "nowhere"):
                ask()
        with self.assertRaisesRegex(TypeError, "folder"):
            an.size(PROJECTS[0], folder=EXAMPLES)


class Quantities(unittest.TestCase):
    """Texts, numbers with units, and what is refused."""

    def test_a_bare_number_is_never_guessed(self) -> None:
        for of in CLASSES:
            for name, kind in of._KEYS.items():
                if kind.of == "quantity":
                    with self.subTest(of=of.__name__, key=name), self.assertRaisesRegex(TypeError, name):
                        an.Section._begin(of.__new__(of), **{name: 3})
        with self.assertRaisesRegex(TypeError, 'write mass="30 kg"'):
            an.Arm(mass=30)  # type: ignore[arg-type]

    def test_a_fault_of_a_value_names_its_argument(self) -> None:
        for make, words in (
            (lambda: an.Arm(mass="30", length="1 m"), r"Arm\.mass: the unit is missing"),
            (lambda: an.Arm(mass="30 kg", length="1 kg"), r"Arm\.length: .*mass"),
            (lambda: an.Arm(mass="-3 kg", length="1 m"), r"Arm\.mass"),
            (lambda: an.Move("trapezoid", distance="10 N"), r"Move\.distance"),
            (lambda: an.Bearing(radial_force="85 m*N"), r"Bearing\.radial_force: .*torque"),
            (lambda: an.Stage(kind="belt", efficiency=1.5), r"Stage\.efficiency"),
            (lambda: an.Hoist(drum_diameter="300 mm", mass="1 kg", falls=0), r"Hoist\.falls"),
            (lambda: axis(ambient="30 K", supply="5"), r"Axis\.supply"),
            (lambda: axis(humidity_max=float("nan")), r"Axis\.humidity_max"),
            (lambda: an.Points([("0 s", "0 deg"), ("1 s", "3 kg"), ("2 s", "0 deg")], spline="cubic", ends="rest"), r"Points\.points"),
            (lambda: an.Turntable(bodies=["disc diameter=3"]), r"Turntable"),
            (lambda: an.Dwell("1 s", hold="brakes"), r'Dwell\.hold: "brakes".*brake'),
        ):
            with self.subTest(words=words), self.assertRaisesRegex(an.AntriebError, words):
                make()

    def test_odd_arguments_are_refused_by_their_names(self) -> None:
        load, rest = an.Load(inertia="1 kg m^2"), an.Dwell("1 s")
        made_by: typing.Any = an
        for make, words in (
            (lambda: made_by.Arm(mass=None), "Arm.mass is required"),
            (lambda: made_by.Arm("30 kg"), "30 kg"),
            (lambda: made_by.Arm(mass="30 kg", long="1 m"), "has no keyword 'long'"),
            (lambda: made_by.Arm(mass=["30 kg"]), "Arm.mass"),
            (lambda: made_by.Arm(mass=b"30 kg"), "Arm.mass"),
            (lambda: made_by.Arm(mass=an.q([1, 2], "kg")), "Arm.mass is one quantity"),
            (lambda: made_by.Move(3), "Move.law"),
            (lambda: made_by.Move("triangle", "90 deg"), "90 deg"),
            (lambda: made_by.Dwell("1 s", hold=True), "Dwell.hold"),
            (lambda: made_by.Axis("a", rest, load), "Axis.mechanism"),
            (lambda: made_by.Axis(load, rest, []), "name comes first"),
            (lambda: made_by.Axis("a", load, None), "Axis.motion is required"),
            (lambda: made_by.Axis("a", load, [load]), r"Axis.motion\[1\]"),
            (lambda: made_by.Axis("a", load, rest, supply=560), 'supply="560 V"'),
            (lambda: made_by.Axis("a", load, rest, brake="yes"), "Axis.brake"),
            (lambda: made_by.Axis("a", load, rest, bearing={"overhang": "1 mm"}), "Axis.bearing"),
            (lambda: made_by.Axis("a", load, rest, feedback=[3]), "Axis.feedback"),
            (lambda: made_by.Project([]), "Project"),
            (lambda: made_by.Project([load]), r"Project.axis\[1\]"),
            (lambda: made_by.Points([[1, 2]], spline="cubic", ends="rest"), r"points\[1\]\[1\]"),
            (lambda: made_by.Points([["0 s"]], spline="cubic", ends="rest"), "row 1, has 1 cells"),
            (lambda: made_by.Turntable(body=[{"shape": "disc"}]), r"Turntable.body\[1\]"),
            (lambda: made_by.Stage(kind="gear", ratio="2"), "Stage.ratio"),
            (lambda: made_by.Twin(cycles=True), "Twin.cycles"),
            (lambda: made_by.size([]), "empty list"),
            (lambda: made_by.size([axis(), "x"]), "entry 2"),
            (lambda: made_by.size(None), "NoneType"),
            (lambda: made_by.loads(3), "loads"),
            (lambda: setattr(axis(), "supply", "48 V"), "replace"),
            (lambda: made_by.sweep(axis(), an.Table.from_pydict({"a": [1.0]}), grid=True), "grid"),
        ):
            with self.subTest(words=words), self.assertRaisesRegex((TypeError, AttributeError), words):
                make()

    def test_texts_of_pint_are_read(self) -> None:
        for text, plain in (
            ("60 meter * newton", "60 m * N"),
            ("60 meter\u00b7newton", "60 m\u00b7N"),
            ("1.5 kilonewton * meter", "1.5 kN * m"),
            (r"60\ \mathrm{m} \cdot \mathrm{N}", "60 m * N"),
        ):
            self.assertEqual(an.size(axis(collision_torque=text), top=1), an.size(axis(collision_torque=plain), top=1))
        self.assertEqual(an.Arm(mass="30 kilogram", length="1 m").mass, "30 kg")
        self.assertEqual(an.Load(inertia=r"1.3\ \mathrm{kilogram} \cdot \mathrm{meter}^{2}").inertia, "1.3 kg * m^2")
        self.assertEqual(an.Load(inertia="1.3 kg m<sup>2</sup>").inertia, "1.3 kg m^2")
        self.assertEqual(an.Move("trapezoid", speed="40.0 / minute").speed, "40.0 1/min")
        self.assertEqual(an.Stage(kind="belt", stiffness=r"5\ \frac{\mathrm{m} \cdot \mathrm{N}}{\mathrm{rad}}").stiffness, "5 m * N/rad")

    def test_numbers_are_written_as_they_are(self) -> None:
        self.assertEqual(an.Arm(mass=an.q(30, "kg")).mass, "30 kg")
        self.assertEqual(an.Arm(mass=an.q(0.1 + 0.2, "kg")).mass, "0.30000000000000004 kg")
        self.assertEqual(eval(repr(an.q([1, 2.5], "kg")), vars(an)), an.q((1, 2.5), "kg"))
        for value in ("3", None, True, [1, None], [[1, 2], [3, 4]], 1j, b"3"):
            with self.assertRaises(TypeError):
                an.q(value, "kg")


if __name__ == "__main__":
    unittest.main()
