"""Answers: shown in a few lines, found by code and id, handed over, explained, copied."""

from __future__ import annotations

import copy
import dataclasses
import pathlib
import pickle
import re
import subprocess
import sys
import tempfile
import typing
import unittest
import xml.etree.ElementTree as ET

import antrieb
from antrieb import _mathml, answers, questions

EXAMPLES = pathlib.Path(__file__).resolve().parents[4] / "examples"
PROJECTS = sorted(EXAMPLES.glob("*.toml"))
CODE = "CHA-25A-50-H-C1024"
PROJECT = EXAMPLES / "indexing-table.toml"


def parts(value: typing.Any) -> typing.Iterator[typing.Any]:
    """A record and every record and list in it."""
    if isinstance(value, antrieb.Record):
        yield value
        for each in dataclasses.fields(value):  # type: ignore[arg-type]
            yield from parts(getattr(value, each.name))
    elif isinstance(value, list):
        if isinstance(value, antrieb.Rows):
            yield value
        for each in value[:3]:
            yield from parts(each)


def every_answer() -> list[typing.Any]:
    """Answers of many questions."""
    code = "CHA-25A-100-H-M512P-B"
    found: list[typing.Any] = [antrieb.size(path, top=3) for path in PROJECTS]
    found += [
        antrieb.check(PROJECT, CODE, lang="de"),
        antrieb.size(PROJECT, lang="de", all=True),
        antrieb.explain(PROJECT, CODE),
        antrieb.compare(PROJECT, [CODE, "CHA-25A-80-H-C1024"]),
        antrieb.simulate(PROJECT, CODE),
        antrieb.data(code),
        antrieb.wiring(code),
        antrieb.encoder(code),
        antrieb.commission(code),
        antrieb.code(code),
        antrieb.errata(),
        antrieb.curve(code, voltage="560 V"),
    ]
    return found


class Shown(unittest.TestCase):
    """Text and HTML."""

    def test_every_answer_and_every_part_of_it_is_shown_in_few_lines(self) -> None:
        for answer in every_answer():
            for part in parts(answer):
                with self.subTest(type(part).__name__):
                    text = repr(part)
                    self.assertLessEqual(len(text.split("\n")), 20, text)
                    self.assertLessEqual(max(map(len, text.split("\n"))), 200, text)
                    html = getattr(part, "_repr_html_", str)()
                    self.assertLess(len(html), 400_000)
                    if html.startswith("<div"):
                        ET.fromstring(html.replace("<br>", "<br/>"))

    def test_the_answer_of_size_says_verdict_and_ranking(self) -> None:
        (sizing,) = antrieb.size(PROJECT).axes
        text = str(sizing)
        self.assertIn(f"{sizing.axis}: {sizing.answer}: fits", text.split("\n")[0])
        for each in sizing.ranking[:5]:
            self.assertIn(str(each.code), text)
        self.assertIn("<svg", sizing._repr_html_())
        self.assertIn("geeignet", str(antrieb.size(PROJECT, lang="de")))

    def test_what_is_missing_is_said_as_by_the_command_line(self) -> None:
        for path in PROJECTS[::3]:
            for lang in ("en", "de"):
                with self.subTest(path.name, lang=lang):
                    called = [sys.executable, "-m", "antrieb", "check", str(path), "--lang", lang]
                    printed = " ".join(subprocess.run(called, capture_output=True, encoding="utf-8", check=False).stdout.split())
                    for answer in antrieb.check(path, lang=typing.cast(antrieb.Lang, lang)).axes:
                        title = str(answer).split("\n")[0].replace("…", "")
                        missing = title.partition("; ")[2]
                        self.assertEqual(bool(missing), bool(answer.open_questions) and answer.verdict != "does_not_fit")
                        self.assertIn(missing, printed)
        several = antrieb.size(EXAMPLES / "two-axes.toml", top=1)
        for answer in several.axes:
            missing = str(answer).split("\n")[0].partition("; ")[2]
            self.assertTrue(missing)
            self.assertIn(missing, str(several))
        text = str(antrieb.check(PROJECT))
        self.assertIn("best of the ranking", text)
        self.assertNotIn("--code", text)
        self.assertNotIn("best of the ranking", str(antrieb.check(PROJECT, CODE)))

    def test_no_assumption_is_none(self) -> None:
        for path in PROJECTS:
            for answer in antrieb.size(path, top=1).axes:
                self.assertNotIn("None", answer._repr_html_())

    def test_a_list_and_a_comparison_are_tables(self) -> None:
        codes = antrieb.code_list()
        self.assertLessEqual(len(repr(codes).split("\n")), 20)
        self.assertEqual(codes[0].code, codes.keys()[0] if isinstance(codes, antrieb.Rows) else "")
        (sizing,) = antrieb.size(PROJECT).axes
        both = [str(sizing.answer), sizing.rejected[0].code]
        (compared,) = antrieb.compare(PROJECT, both).axes
        lines = str(compared).split("\n")
        self.assertLessEqual(len(lines), 20)
        for each in both:
            self.assertTrue(any(line.startswith("check") and each in line for line in lines))
        self.assertIn("<table", compared._repr_html_())

    def test_a_formula_of_every_derivation_is_mathematics(self) -> None:
        whole = 0
        formulas: set[str] = set()

        def walk(node: typing.Any) -> None:
            formulas.add(node.formula or "x")
            for each in node.operands or []:
                walk(each)

        for path in PROJECTS[:8]:
            for axis in antrieb.explain(path, "CHA-32A-50-H-C1024").axes:
                for check in axis.checks:
                    for side in (check.derivation.value, check.derivation.limit):
                        if side is not None:
                            walk(side)
        for formula in formulas:
            found = _mathml.math(formula)
            ET.fromstring(found)
            whole += found.startswith("<math")
        self.assertGreater(whole, 40)

    def test_formulas_bind_as_written(self) -> None:
        for text, expected in (
            ("a/b·c", "<mfrac><mrow><mi>a</mi></mrow><mrow><mi>b</mi></mrow></mfrac><mo>·</mo><mi>c</mi>"),
            ("a·b/c", "<mfrac><mrow><mi>a</mi><mo>·</mo><mi>b</mi></mrow><mrow><mi>c</mi></mrow></mfrac>"),
            ("(a + b)/(c − d)", "<mfrac><mrow><mi>a</mi><mo>+</mo><mi>b</mi></mrow><mrow><mi>c</mi><mo>−</mo><mi>d</mi></mrow></mfrac>"),
            ("I_0²", "<msup><mrow><msub><mi>I</mi><mtext>0</mtext></msub></mrow><mn>2</mn></msup>"),
            ("√(a)", "<msqrt><mrow><mi>a</mi></mrow></msqrt>"),
        ):
            self.assertEqual(_mathml.math(text), f'<math alttext="{text}"><mrow>{expected}</mrow></math>')
        self.assertEqual(_mathml.math("the larger of both"), "<span>the larger of both</span>")


class Found(unittest.TestCase):
    """Indexing and iteration."""

    def test_by_code_and_check(self) -> None:
        (sizing,) = antrieb.size(PROJECT, all=True).axes
        code = sizing.ranking[3].code
        assert code
        self.assertIs(sizing[code], sizing.ranking[3])
        self.assertIs(sizing.ranking[code].checks["thermal"], next(c for c in sizing.ranking[3].checks if c.id == "thermal"))
        self.assertEqual([each.code for each in sizing], [each.code for each in sizing.candidates])
        self.assertEqual(len(sizing.candidates), sizing.judged)
        self.assertIs(sizing.best, sizing.ranking[0])
        self.assertTrue(sizing)
        for wrong in ("CHA-32A-50-H-C102", "thermall"):
            with self.assertRaisesRegex(KeyError, "did you mean|there are"):
                sizing[wrong]
        both = antrieb.size(EXAMPLES / "two-axes.toml")
        assert isinstance(both, answers.AxesOfSizing)
        self.assertIs(both["lift"], both.axes[1])
        judged = antrieb.check(PROJECT, CODE)
        assert isinstance(judged, answers.Judgement)
        self.assertEqual([check.id for check in judged], [check.id for check in judged.checks])
        self.assertEqual(judged["thermal"].id, "thermal")

    def test_every_candidate_has_verdict_and_governing_check(self) -> None:
        (sizing,) = antrieb.size(PROJECT, top=2).axes
        candidates: typing.Any = sizing.candidates
        fitting = [each.code for each in candidates if each.verdict == "fits"]
        self.assertEqual(len(fitting), sizing.fit)
        self.assertEqual(len(candidates), sizing.judged)
        self.assertEqual(fitting[:2], [each.code for each in sizing.ranking if each.verdict == "fits"])
        for each in sizing.rejected:
            rejected: typing.Any = each
            self.assertEqual((rejected.verdict, rejected.tightest), ("does_not_fit", each.check))
            self.assertNotIn("verdict", each.to_dict())
        self.assertNotIn(None, candidates._columns()["verdict"])
        with self.assertRaisesRegex(AttributeError, "verdicts"):
            candidates[-1].verdicts

    def test_the_candidates_are_all_that_were_judged(self) -> None:
        two_axes = EXAMPLES / "two-axes.toml"
        (whole,) = antrieb.size(PROJECT, all=True).axes
        for top in (1, 2, 7, 1000):
            (sizing,) = antrieb.size(PROJECT, top=top).axes
            for found in (sizing, pickle.loads(pickle.dumps(sizing)), copy.deepcopy(sizing)):
                with self.subTest(top=top):
                    self.assertEqual([each.code for each in found.candidates], [each.code for each in whole])
                    self.assertEqual(len(found), len(found.candidates._columns()["code"]))
        both = antrieb.size(two_axes, top=1)
        self.assertEqual([len(axis) for axis in both.axes], [axis.judged for axis in both.axes])
        self.assertIn(whole.best.code, whole)
        self.assertIn(whole.ranking[-1].code, antrieb.size(PROJECT, top=1))
        self.assertNotIn("CHA-32A-50-H-C102", whole)
        apart = dataclasses.replace(antrieb.size(PROJECT, top=1).axes[0])
        with self.assertRaisesRegex(ValueError, "1 of"):
            apart.candidates

    def test_a_code_that_is_not_shown_says_why(self) -> None:
        (sizing,) = antrieb.size(PROJECT, top=2).axes
        (longer,) = antrieb.size(PROJECT, top=30).axes
        for code, words in (
            (longer.ranking[5].code, "only 2 are shown"),
            (longer.ranking[20].code, "top="),
            ("CHA-25", "no entry"),
        ):
            with self.subTest(code), self.assertRaisesRegex(KeyError, words):
                sizing.ranking[str(code)]
        with self.assertRaisesRegex(KeyError, "candidates"):
            sizing.ranking[sizing.rejected[0].code]

    def test_a_name_of_several_entries_is_not_guessed(self) -> None:
        (sizing,) = antrieb.size(PROJECT, top=1).axes
        twice = antrieb.Rows([*sizing.ranking, *sizing.ranking])
        with self.assertRaisesRegex(KeyError, "2 entries"):
            twice[str(sizing.answer)]

    def test_where_nothing_fits_there_is_no_best(self) -> None:
        text = PROJECT.read_text(encoding="utf-8")
        for factor in ("9", "99", "99999"):
            (sizing,) = antrieb.size(text.replace('inertia = "', f'inertia = "{factor}', 1)).axes
            swept = antrieb.sweep(text.replace('inertia = "', f'inertia = "{factor}', 1), {"load.inertia [kg m^2]": [float(factor + "0")]})
            with self.subTest(factor):
                self.assertFalse(sizing.best)
                self.assertEqual((sizing.best.code, sizing.answer, swept["code"][0]), (None, None, None))
                self.assertEqual((sizing.best.verdict, sizing.best.nearest_miss), ("does_not_fit", sizing.nearest_miss))
                self.assertEqual(pickle.loads(pickle.dumps(sizing.best)), sizing.best)
                self.assertIn(str(sizing.nearest_miss or "candidates"), repr(sizing.best))
                self.assertIn("nothing fits", sizing.best._repr_html_())
                if sizing.nearest_miss:
                    self.assertEqual(sizing.best.nearest.code, sizing.nearest_miss)
                    self.assertTrue(sizing.best.checks["peak_torque"].explain())
                else:
                    with self.assertRaises(LookupError):
                        sizing.best.checks


class HandedOver(unittest.TestCase):
    """Dictionaries, copies, derivations."""

    def test_a_dictionary_has_the_fields(self) -> None:
        (sizing,) = antrieb.size(PROJECT, top=2).axes
        found = sizing.to_dict()
        self.assertEqual(found, dataclasses.asdict(sizing))
        self.assertEqual(type(found["ranking"][0]), dict)
        rows = sizing.candidates.to_dicts()
        self.assertEqual(len(rows), len(sizing.candidates))
        columns = sizing.ranking._columns()
        self.assertEqual(columns["code"], [each.code for each in sizing.ranking])
        self.assertEqual(columns["demand.T_rms"], [each.demand.T_rms if each.demand else None for each in sizing.ranking])

    def test_answers_are_pickled_copied_and_equal(self) -> None:
        for answer in every_answer():
            with self.subTest(type(answer).__name__):
                again = pickle.loads(pickle.dumps(answer))
                self.assertEqual(again, answer)
                self.assertIs(type(again), type(answer))
                self.assertEqual(repr(again), repr(answer))
                self.assertEqual(copy.copy(answer), answer)
                self.assertEqual(copy.deepcopy(answer), answer)

    def test_a_check_is_explained_from_anywhere(self) -> None:
        both = antrieb.size(EXAMPLES / "two-axes.toml", lang="de")
        check = both.axes[1].best.checks["peak_torque"]
        found = pickle.loads(pickle.dumps(both)).axes[1].best.checks["peak_torque"].explain()
        self.assertEqual((found.value, found.limit), (check.value, check.limit))
        self.assertIn("gefordert", str(found))
        self.assertGreater(len(str(found).split("\n")), 5)
        self.assertIn("<math", found._repr_html_())
        code = both.axes[1].best.code
        (direct,) = antrieb.explain(EXAMPLES / "two-axes.toml", code, axis="lift", check="peak_torque", lang="de").axes
        self.assertEqual(direct.checks[0], found)

    def test_a_check_of_a_changed_project_is_not_explained(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "axis.toml")
            text = PROJECT.read_text(encoding="utf-8")
            path.write_text(text, encoding="utf-8")
            check = antrieb.check(path, CODE).axes[0].checks["peak_torque"]
            path.write_text(text.replace('inertia = "', 'inertia = "1', 1), encoding="utf-8")
            with self.assertRaisesRegex(ValueError, "has changed"):
                check.explain()
        alone = dataclasses.replace(check)
        with self.assertRaisesRegex(ValueError, "antrieb.explain"):
            alone.explain()


class Import(unittest.TestCase):
    """The first line of a program."""

    def test_the_classes_of_the_answers_are_made_when_they_are_used(self) -> None:
        script = (
            "import sys, antrieb; assert 'antrieb.answers' not in sys.modules; assert antrieb.answers.Sizing; "
            "assert antrieb.Fault; import antrieb.__main__"
        )
        done = subprocess.run([sys.executable, "-c", script], capture_output=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_hints_of_every_function_can_be_read(self) -> None:
        for name in questions.__all__:
            self.assertTrue(typing.get_type_hints(getattr(questions, name)))
        self.assertTrue(re.match(r"\d", antrieb.__version__))


if __name__ == "__main__":
    unittest.main()
