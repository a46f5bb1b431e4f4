"""Every question of the list as a function: the answer of its command, as typed objects; faults with their places."""

from __future__ import annotations

import contextlib
import copy
import dataclasses
import inspect
import json
import math
import multiprocessing
import os
import pathlib
import pickle
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import typing
import unittest
import unittest.mock

import antrieb
from antrieb import _antrieb, _call, answers, questions

EXAMPLES = pathlib.Path(__file__).resolve().parents[4] / "examples"
PROJECT = (EXAMPLES / "indexing-table.toml").read_text(encoding="utf-8")
CODE = "CHA-25A-50-H-C1024"


def command(*words: str, folder: str = ".") -> subprocess.CompletedProcess[bytes]:
    """A call of the command line of the same package."""
    return subprocess.run([sys.executable, "-m", "antrieb", *words], capture_output=True, cwd=folder, check=False)


def call_of(function: typing.Any, example: str) -> tuple[dict[str, typing.Any], bool]:
    """The example of a command as the arguments of its function, and whether all of it: files that only the command reads or
    writes are left out."""
    parameters = inspect.signature(function).parameters
    hints = typing.get_type_hints(function)
    words = shlex.split(example)
    while words and words[0].isalpha() and not words[0].isupper() and function.__name__.split("_")[0] == words[0]:
        del words[: function.__name__.count("_") + 1]
    sources = [name for name in parameters if name in ("text", "old", "new")]
    places = [
        name
        for name, each in parameters.items()
        if each.kind is each.POSITIONAL_OR_KEYWORD and name not in ("text", "old", "new", "lang")
    ]
    whole = True
    named: dict[str, typing.Any] = {}
    while words:
        word = words.pop(0)
        if word.startswith("--"):
            name = word[2:].replace("-", "_")
            name = name + "_" if name + "_" in parameters else name
            value: typing.Any = True if hints.get(name) is bool else words.pop(0)
            if hints.get(name) is int or hints.get(name) == int | None:
                value = int(value)
            # The format of a catalogue file is chosen for `new catalogue` alone.
            if name == "out" and "format" in parameters and function is not questions.new:
                name, value = "format", pathlib.Path(value).suffix[1:]
            whole = whole and name in parameters and name != "format"
            if name in parameters:
                several = name in named and not isinstance(named[name], list)
                named[name] = [named[name], value] if several else value
        elif (word.endswith(".toml") or word.startswith("examples/")) and sources:
            named[sources.pop(0)] = pathlib.Path(word)
        else:
            named[places.pop(0)] = word
    return named, whole


def numbers(value: typing.Any) -> list[float]:
    """The numbers of an answer, one after the other."""
    if isinstance(value, dict):
        return [each for part in value.values() for each in numbers(part)]
    if isinstance(value, list):
        return [each for part in value for each in numbers(part)]
    return [value] if isinstance(value, float) else []


class Questions(unittest.TestCase):
    """The list walked."""

    folder: tempfile.TemporaryDirectory[str]

    @classmethod
    def setUpClass(cls) -> None:
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.addClassCleanup(os.chdir, os.getcwd())
        os.chdir(cls.folder.name)
        for name in ("axis.toml", "before.toml"):
            pathlib.Path(name).write_text(PROJECT, encoding="utf-8")
        pathlib.Path("after.toml").write_text(PROJECT.replace("inertia = \"", "inertia = \"1", 1), encoding="utf-8")
        shutil.copytree(EXAMPLES / "catalogue", "examples/catalogue")
        # The name is that of the example; over a question a table is read as CSV.
        pathlib.Path("tasks.parquet").write_text("load.inertia [kg m^2]\n1.0\n1.3\n", encoding="utf-8")
        run = command("simulate", "axis.toml", "--code", CODE, "--out", "run.csv")
        assert run.returncode in (0, 1), run.stderr

    def test_the_course_of_a_run_is_a_table(self) -> None:
        text = antrieb.simulate(PROJECT, CODE, signals=["speed", "torque"], every="10 ms", format="csv")
        self.assertEqual(text.splitlines()[0], "time_s,speed_rad_s,torque_nm")
        with self.assertRaises(antrieb.AntriebError):
            antrieb.simulate(PROJECT, CODE, signals="speed")

    def test_every_question_answers_as_its_command(self) -> None:
        for name, example in questions._EXAMPLES.items():
            with self.subTest(name):
                function = getattr(questions, name)
                named, whole = call_of(function, example)
                seen: list[tuple[str, bytes]] = []

                def ask(*arguments: typing.Any, native: typing.Any = _antrieb.ask) -> tuple[str, bytes]:
                    seen.append(native(*arguments))
                    return seen[-1]

                with unittest.mock.patch.object(_antrieb, "ask", ask):
                    answer = function(**named)
                media, body = seen[0]
                self.assertIsNotNone(answer)
                if media == "application/json" and whole:
                    done = command(*shlex.split(example), "--json")
                    self.assertEqual(done.stdout, body, done.stderr)
                elif media == "application/pdf":
                    self.assertTrue(answer.startswith(b"%PDF-"))
                elif media.startswith("image/svg"):
                    self.assertTrue(answer._repr_svg_().startswith("<svg"))

    def test_a_recorded_run_is_a_path_its_content_or_a_table(self) -> None:
        expected = antrieb.identify("run.csv", PROJECT, CODE)
        text = pathlib.Path("run.csv").read_text(encoding="utf-8")
        head, *lines = text.strip().split("\n")
        cells = [line.split(",") for line in lines]
        columns = {name: [float(row[at]) if row[at] else None for row in cells] for at, name in enumerate(head.split(","))}
        for run in (pathlib.Path("run.csv"), text, text.encode(), columns):
            with self.subTest(type(run).__name__):
                self.assertEqual(antrieb.identify(run, PROJECT, CODE), expected)
        of = antrieb.q
        degrees: typing.Any = {
            "time": of([1000 * value for value in columns["time_s"]], "ms"),
            "position [deg]": [math.degrees(value) for value in columns["position_rad"]],
            "motor_speed [1/min]": [value * 30 / math.pi for value in columns["motor_speed_rad_s"]],
            "torque_nm": of(columns["torque_nm"], "N m"),
            "current_q [A]": columns["current_q_a"],
        }
        rows = [dict(zip(columns, row, strict=True)) for row in zip(*columns.values(), strict=True)]
        self.assertEqual(antrieb.identify(typing.cast(typing.Any, rows), PROJECT, CODE), expected)
        found = antrieb.identify(degrees, PROJECT, CODE)
        for one, other in zip(numbers(found.to_dict()), numbers(expected.to_dict()), strict=True):
            self.assertAlmostEqual(one, other, delta=1e-5 * max(abs(other), 1e-3))
        cases: typing.Any = (
            ({**columns, "time [s]": columns["time_s"]}, "two columns"),
            ({"time [kg]": [1.0]}, "unit of time"),
            ({"time [s]": of([1.0], "s")}, "unit already"),
            ({"mass": of([1.0], "kg")}, "no column of a trace"),
            ({"position [deg]": ["a"]}, "row 0"),
            ({"time_s": [1.0]}, "^trace: the trace lacks"),
        )
        for run, words in cases:
            with self.subTest(words), self.assertRaisesRegex((TypeError, ValueError), words):
                antrieb.identify(run, PROJECT, CODE)
        with self.assertRaisesRegex(antrieb.AntriebError, "^trace: "):
            antrieb.identify(typing.cast(typing.Any, {"a": [1.0]}), PROJECT, CODE, lang="de")
        for wrong in ("a,b\n1,2\n", {"time [s]": []}, {"nonsense": [1.0]}, 3.5, None, [1.0]):
            with self.subTest(f"{wrong!r}"), self.assertRaisesRegex((TypeError, ValueError), "trace"):
                antrieb.identify(typing.cast(typing.Any, wrong), PROJECT, CODE)
        with self.assertRaises(antrieb.AntriebError):
            antrieb.identify(b"\x00\x01", PROJECT, CODE)

    def test_arguments_of_numbers_and_quantities(self) -> None:
        whole: set[str] = set()
        for name in questions.__all__:
            hints = typing.get_type_hints(getattr(questions, name))
            whole.update(each for each, of in hints.items() if of is int or of == int | None)
            self.assertFalse(float in hints.values(), name)
        self.assertEqual(_call.WHOLE, whole)
        ask: typing.Any = antrieb
        for value in ("3", 3.0, True, [3]):
            with self.subTest(value=value), self.assertRaisesRegex(TypeError, "top is a whole number"):
                ask.size(PROJECT, top=value)
        self.assertEqual(str(ask.curve(CODE, voltage=antrieb.q(560, "V"))), str(antrieb.curve(CODE, voltage="560 V")))
        self.assertEqual(ask.size(PROJECT, top=1, deadline=antrieb.q(60, "s")), antrieb.size(PROJECT, top=1))
        with self.assertRaisesRegex(TypeError, "project stands first"):
            ask.check(CODE, antrieb.loads(PROJECT))
        for value in (3.5, antrieb.q([1, 2], "V")):
            with self.assertRaisesRegex(TypeError, "voltage"):
                ask.curve(CODE, voltage=value)
        self.assertNotIn("Path", antrieb.__all__)

    def test_every_function_is_of_the_package(self) -> None:
        for name in questions.__all__:
            self.assertTrue(inspect.getdoc(getattr(antrieb, name)), name)
        self.assertIs(antrieb.code, antrieb.code_parse)
        self.assertIs(antrieb.catalogue, antrieb.catalogue_export)

    def test_questions_of_an_option(self) -> None:
        code = "CHA-25A-100-H-M512P-B"
        self.assertTrue(antrieb.wiring_check(EXAMPLES / "pins.csv", code).findings)
        self.assertIn("BEGIN:VCALENDAR", antrieb.upkeep_ical(code, "2026-03-01"))
        self.assertIn("$enddefinitions", antrieb.encoder_vcd(code))
        self.assertTrue(antrieb.commission_checklist(code).startswith(b"%PDF-"))
        self.assertIn("[", antrieb.commission_blank(code))
        self.assertIsInstance(antrieb.mount_project(PROJECT, code), answers.Mount)
        self.assertIsInstance(antrieb.export(PROJECT, table="checks"), answers.Table)
        self.assertTrue(antrieb.export(PROJECT, format="xlsx").startswith(b"PK"))
        self.assertTrue(antrieb.export(PROJECT, table="checks", format="csv").startswith("code,"))
        objects = antrieb.commission(code, for_="cia402")
        self.assertIsInstance(objects, list)

    def test_texts_and_paths_are_the_same(self) -> None:
        of_text = antrieb.size(PROJECT, top=1)
        self.assertEqual(of_text, antrieb.size("axis.toml", top=1))
        self.assertEqual(of_text, antrieb.size(pathlib.Path("axis.toml"), top=1))
        self.assertEqual(antrieb.size(PROJECT, lang="de", top=1).verdict, of_text.verdict)

    def test_answers_are_typed(self) -> None:
        (sizing,) = antrieb.size(PROJECT, top=2).axes
        self.assertIsInstance(sizing, answers.Sizing)
        self.assertIsInstance(sizing.ranking[0].checks[0], answers.Check)
        self.assertEqual(sizing.ranking[0].checks[0].direction, "at_most")
        self.assertTrue(dataclasses.asdict(sizing))
        both = antrieb.size(EXAMPLES / "two-axes.toml", top=1)
        self.assertIsInstance(both, answers.AxesOfSizing)
        self.assertEqual(len(both.axes), 2)
        one = antrieb.size(EXAMPLES / "two-axes.toml", axis=both.axes[0].axis, top=1)
        self.assertIsInstance(one, answers.Sizing)

    def test_recordings_are_opened_beside_the_file(self) -> None:
        path = EXAMPLES / "robot-joint.toml"
        at_its_place = antrieb.size(path, top=1)
        self.assertEqual(antrieb.size(path.read_text(encoding="utf-8"), folder=EXAMPLES, top=1), at_its_place)
        with self.assertRaises(antrieb.AntriebError) as caught:
            antrieb.size(path.read_text(encoding="utf-8"))
        self.assertIn("robot-joint.csv", str(caught.exception))


class Faults(unittest.TestCase):
    """What cannot be answered."""

    def test_every_fault_comes_with_place_and_hint(self) -> None:
        wrong = 'format = 1\n[load]\ninertja = "1 kg m^2"\n[[motion]]\nlaw = "manual"\nspeed = "40"\n'
        with self.assertRaises(antrieb.AntriebError) as caught:
            antrieb.size(wrong, file="wrong.toml")
        faults = caught.exception.faults
        self.assertGreater(len(faults), 2)
        by_id = {fault.id: fault for fault in faults}
        unknown = by_id["unknown_key"]
        assert isinstance(unknown, answers.Fault)
        self.assertEqual((unknown.file, unknown.line, unknown.column), ("wrong.toml", 3, 1))
        self.assertEqual(unknown.hint, "did you mean `inertia`?")
        self.assertIn("wrong.toml:3:1: ", str(caught.exception))
        again = pickle.loads(pickle.dumps(caught.exception))
        self.assertEqual(again.faults, faults)

    def test_a_wrong_code_has_the_nearest_ones(self) -> None:
        with self.assertRaises(antrieb.AntriebError) as caught:
            antrieb.data("CHA-20B-100-H-C1024")
        self.assertIn("CHA-20A-100-H-C1024", [each.code for each in caught.exception.nearest])

    def test_faults_of_arguments_are_reported_together(self) -> None:
        with self.assertRaises(antrieb.AntriebError) as caught:
            antrieb.size(PROJECT, top=0, samples=0)
        self.assertEqual([fault.option for fault in caught.exception.faults], ["top", "samples"])
        with self.assertRaises(antrieb.AntriebError):
            antrieb.size("nowhere.toml")
        with self.assertRaises(antrieb.AntriebError) as caught:
            antrieb.size(PROJECT, deadline="soon")
        self.assertIn("deadline", str(caught.exception))
        with self.assertRaises(TypeError):
            antrieb.curve(CODE, voltage=220.0)

    def test_the_language_is_that_of_the_call(self) -> None:
        with self.assertRaises(antrieb.AntriebError) as caught:
            antrieb.size("nowhere.toml", lang="de")
        self.assertIn("existiert nicht", str(caught.exception))


class Arguments(unittest.TestCase):
    """No value is taken for another argument."""

    def test_what_could_be_taken_for_another_argument_is_given_by_its_name(self) -> None:
        for name in questions._EXAMPLES:
            parameters = inspect.signature(getattr(questions, name)).parameters
            self.assertIs(parameters["lang"].kind, inspect.Parameter.KEYWORD_ONLY, name)
        wrong: typing.Any = antrieb.size
        with self.assertRaises(TypeError):
            wrong(PROJECT, CODE)

    def test_a_language_that_there_is_not_is_refused(self) -> None:
        wrong: typing.Any = "fr"
        table = antrieb.Table.from_pydict({"load.inertia [kg m^2]": [1.0]})
        for call in (
            lambda: antrieb.size(PROJECT, lang=wrong),
            lambda: antrieb.units(lang=wrong),
            lambda: antrieb.sweep(PROJECT, table, lang=wrong),
            lambda: antrieb.Sweep(PROJECT, table, lang=wrong),
        ):
            with self.assertRaises(antrieb.AntriebError) as caught:
                call()
            self.assertEqual([getattr(fault, "option", None) for fault in caught.exception.faults], ["lang"])

    def test_one_word_is_one_value(self) -> None:
        table = antrieb.Table.from_pydict({"load.inertia [kg m^2]": [1.0]})
        found = antrieb.sweep(PROJECT, table, check="thermal")
        self.assertIn("thermal.verdict", found.column_names)
        self.assertEqual(found.to_pydict(), antrieb.sweep(PROJECT, table, check=("thermal",)).to_pydict())
        with self.assertRaises(antrieb.AntriebError) as caught:
            antrieb.sweep(PROJECT, table, check="thermal", front=True)
        self.assertEqual([getattr(fault, "option", None) for fault in caught.exception.faults], ["front"])

    def test_numbers_of_other_libraries_are_numbers(self) -> None:
        class Number:
            def __index__(self) -> int:
                return 2

        number: typing.Any = Number()
        self.assertEqual(len(antrieb.size(EXAMPLES / "two-axes.toml", axis="lift", top=number).ranking), 2)
        codes: typing.Any = iter([CODE, "CHA-25A-80-H-C1024"])
        self.assertEqual(antrieb.compare(PROJECT, codes), antrieb.compare(PROJECT, [CODE, "CHA-25A-80-H-C1024"]))
        seconds: typing.Any = 60
        with self.assertRaisesRegex(TypeError, "deadline is a text with its unit"):
            antrieb.size(PROJECT, deadline=seconds)
        octets: typing.Any = b"format = 1"
        with self.assertRaisesRegex(TypeError, "not bytes"):
            antrieb.size(octets)

    def test_a_text_of_one_line_is_a_text(self) -> None:
        with self.assertRaises(antrieb.AntriebError) as caught:
            antrieb.size('load.inertja = "1 kg m^2"')
        self.assertIn("unknown_key", [fault.id for fault in caught.exception.faults])
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "a=b.toml")
            path.write_text(PROJECT, encoding="utf-8")
            self.assertEqual(antrieb.size(str(path), top=1), antrieb.size(PROJECT, top=1))

    def test_a_wrong_code_of_a_project_has_the_nearest_ones(self) -> None:
        with self.assertRaises(antrieb.AntriebError) as caught:
            antrieb.check(PROJECT, "CHA-20B-100-H-C1024")
        self.assertIn("CHA-20A-100-H-C1024", [each.code for each in caught.exception.nearest])
        again = pickle.loads(pickle.dumps(caught.exception))
        self.assertEqual(again.nearest, caught.exception.nearest)


def answer_of(call: typing.Any) -> typing.Any:
    """What another process answers."""
    command, given = call
    if command == "sweep":
        return given.table(antrieb.Table.from_pydict({"load.inertia [kg m^2]": [1.0, 2.0]})).to_pydict()
    if command == "table":
        return given.to_pydict()
    return getattr(antrieb, command)(PROJECT, **given).svg if command == "plot" else antrieb.size(PROJECT, **given)


class Processes(unittest.TestCase):
    """Forks and what travels between processes."""

    @unittest.skipUnless(hasattr(os, "fork"), "there is no fork")
    def test_a_forked_process_answers(self) -> None:
        table = antrieb.Table.from_pydict({"load.inertia [kg m^2]": [1.0, 2.0]})
        sweep = antrieb.Sweep(PROJECT, table)
        calls: list[typing.Any] = [
            ("size", {"top": 1}), ("plot", {"figure": "cycle"}), ("sweep", sweep), ("table", table)
        ]
        # Everything is used in the parent, threads and tables that are made on first use too.
        expected = [answer_of(call) for call in calls]
        with multiprocessing.get_context("fork").Pool(2) as pool:
            self.assertEqual(pool.map_async(answer_of, calls * 2).get(timeout=120), expected * 2)
        # Of a fork in a fork too.
        child = os.fork()
        if child == 0:
            grandchild = os.fork()
            same = answer_of(calls[2]) == expected[2]
            if grandchild == 0:
                os._exit(0 if same else 1)
            os._exit(0 if same and os.waitpid(grandchild, 0)[1] == 0 else 1)
        self.assertEqual(os.waitpid(child, 0)[1], 0)
        self.assertEqual(answer_of(calls[0]), expected[0])

    @unittest.skipUnless(hasattr(os, "fork"), "there is no fork")
    def test_a_fork_in_the_middle_of_a_call_is_refused_at_once(self) -> None:
        def work() -> None:
            with contextlib.suppress(antrieb.AntriebError):
                antrieb.size(Work.TOLERANT, all=True, samples=1_000_000, deadline="5 s")

        busy = threading.Thread(target=work)
        busy.start()
        time.sleep(0.3)
        child = os.fork()
        if child == 0:
            try:
                antrieb.size(PROJECT)
            except RuntimeError as error:
                os._exit(0 if "forked" in str(error) else 1)
            os._exit(2)
        begin = time.monotonic()
        self.assertEqual(os.waitpid(child, 0)[1], 0)
        self.assertLess(time.monotonic() - begin, 10.0)
        busy.join()

    def test_tables_and_sweeps_are_pickled_and_copied(self) -> None:
        table = antrieb.Table.from_pydict({"load.inertia [kg m^2]": [1.0, None], "code": [CODE, None], "x": [True, False]})
        answers_of_it = antrieb.sweep(PROJECT, antrieb.Table.from_pydict({"load.inertia [kg m^2]": [1.0, -1.0]}))
        for each in (table, answers_of_it, antrieb.Table.from_pydict({})):
            again = pickle.loads(pickle.dumps(each))
            self.assertEqual((again.column_names, again.to_pydict()), (each.column_names, each.to_pydict()))
            self.assertIs(copy.copy(each), each)
            self.assertIs(copy.deepcopy(each), each)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "axis.toml")
            path.write_text(PROJECT, encoding="utf-8")
            sweep = antrieb.Sweep(path, antrieb.Table.from_pydict({"load.inertia [kg m^2]": [1.0]}), check="thermal")
            path.write_text(PROJECT.replace("1.3 kg", "130 kg"), encoding="utf-8")
            again = pickle.loads(pickle.dumps(sweep))
        rows = antrieb.Table.from_pydict({"load.inertia [kg m^2]": [1.0, 2.0]})
        self.assertEqual(again.table(rows).to_pydict(), sweep.table(rows).to_pydict())


class Work(unittest.TestCase):
    """Threads, interrupts, deadlines."""

    TOLERANT = EXAMPLES / "tolerances.toml"

    def test_other_threads_go_on(self) -> None:
        ticks: list[float] = []
        done = threading.Event()

        def tick() -> None:
            while not done.is_set():
                ticks.append(time.monotonic())
                time.sleep(0.002)

        thread = threading.Thread(target=tick)
        thread.start()
        antrieb.report(PROJECT)
        done.set()
        thread.join()
        halted = max((after - before for before, after in zip(ticks, ticks[1:], strict=False)), default=0.0)
        self.assertGreater(len(ticks), 20)
        self.assertLess(halted, 0.5)

    def test_a_deadline_ends_the_work(self) -> None:
        begin = time.monotonic()
        with self.assertRaisesRegex(antrieb.AntriebError, "^(?!top)"):
            antrieb.size(self.TOLERANT, all=True, samples=1_000_000, deadline="0.3 s")
        self.assertLess(time.monotonic() - begin, 20.0)

    @unittest.skipIf(os.name == "nt", "signals of another kind")
    def test_an_interrupt_ends_the_work(self) -> None:
        # A shell starts what runs in the background with interrupts ignored.
        signal.signal(signal.SIGINT, signal.default_int_handler)
        threading.Timer(0.3, signal.raise_signal, [signal.SIGINT]).start()
        begin = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            antrieb.size(self.TOLERANT, all=True, samples=1_000_000, deadline="600 s")
        self.assertLess(time.monotonic() - begin, 20.0)


class CommandLine(unittest.TestCase):
    """The command of the wheel."""

    def test_the_exit_code_is_that_of_the_answer(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "axis.toml").write_text(PROJECT, encoding="utf-8")
            fits = command("size", "axis.toml", "--json", folder=folder)
            self.assertEqual(fits.returncode, 0, fits.stderr)
            self.assertEqual(json.loads(fits.stdout)["verdict"], "fits")
            refused = command("size", "nowhere.toml", folder=folder)
            self.assertEqual((refused.returncode, refused.stdout), (2, b""))
            report = command("report", "axis.toml", "--out", "axis.pdf", folder=folder)
            self.assertEqual(report.returncode, 0, report.stderr)
            self.assertTrue(pathlib.Path(folder, "axis.pdf").read_bytes().startswith(b"%PDF-"))
        version = command("--version")
        self.assertEqual(version.stdout.decode().strip(), f"antrieb {antrieb.__version__}")


if __name__ == "__main__":
    unittest.main()
