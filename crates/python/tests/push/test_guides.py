"""The guides as they are read: each block runs in an empty folder, in order; the types of their code hold."""

from __future__ import annotations

import ast
import contextlib
import importlib.util
import io
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import typing
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[4]
GUIDES = [ROOT / "docs" / "guide" / "python.md", ROOT / "docs" / "anleitung" / "python.md"]
NOTEBOOK = ROOT / "examples" / "three-tasks.ipynb"

LIBRARIES = ("", "joblib", *(["matplotlib"] if importlib.util.find_spec("matplotlib") else []))
NIGHTLY = ("dask", "ray")
"""What the recipes need; the second only the tests of a night install."""


SHOWN = {"text/html": "_repr_html_", "image/svg+xml": "_repr_svg_"}
"""Kinds of outputs of a notebook, each with the method of a value that gives it."""


def answered(code: str, count: int, names: dict[str, typing.Any]) -> list[dict[str, typing.Any]]:
    """Runs a cell of a notebook, and returns its outputs in the form of the file."""
    tree = ast.parse(code)
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(compile(tree, "cell", "exec"), names)
        value = None if last is None else eval(compile(ast.Expression(last.value), "cell", "eval"), names)
    outputs: list[dict[str, typing.Any]] = []
    if printed.getvalue():
        outputs.append({"name": "stdout", "output_type": "stream", "text": printed.getvalue().splitlines(keepends=True)})
    if value is not None:
        data = {"text/plain": repr(value).splitlines(keepends=True)}
        for kind, method in SHOWN.items():
            if hasattr(value, method):
                data[kind] = getattr(value, method)().splitlines(keepends=True)
        outputs.append({"data": data, "execution_count": count, "metadata": {}, "output_type": "execute_result"})
    return outputs


class Block(typing.NamedTuple):
    """A block of code, with the mark in the line above it."""

    mark: str
    code: str


def blocks(guide: pathlib.Path) -> list[Block]:
    """The blocks of Python of a guide."""
    found = re.findall(r"(?:<!-- (\w+(?:: \w+)?) -->\n)?```python\n(.*?)^```$", guide.read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE)
    return [Block(mark, code) for mark, code in found]


def lines(code: str) -> int:
    """How many lines of a block are code."""
    return sum(bool(line.strip()) and not line.lstrip().startswith("#") for line in code.splitlines())


def run(parts: list[str], folder: str) -> str:
    """Runs parts of one program in a folder; what it prints."""
    names: dict[str, typing.Any] = {"__name__": "guide"}
    printed = io.StringIO()
    with contextlib.chdir(folder), contextlib.redirect_stdout(printed):
        for part in parts:
            exec(compile(part, "<guide>", "exec"), names)
    return printed.getvalue()


def run_scripts(guide: pathlib.Path, folder: str, libraries: tuple[str, ...]) -> None:
    """Runs the scripts of a guide that need one of these libraries, or none."""
    scripts = [block for block in blocks(guide) if block.mark.startswith("script")]
    assert [block.mark for block in scripts] == ["script: matplotlib", "script", "script: joblib", "script: dask", "script: ray"]
    if not (pathlib.Path(folder) / "axis.toml").exists():
        run([block.code for block in blocks(guide) if not block.mark.startswith("script")][:4], folder)
    for block in scripts:
        if block.mark.removeprefix("script").removeprefix(": ") not in libraries:
            continue
        file = pathlib.Path(folder) / "script.py"
        file.write_text(block.code, encoding="utf-8")
        done = subprocess.run([sys.executable, str(file)], cwd=folder, capture_output=True, check=False, timeout=300)
        assert done.returncode == 0, done.stderr.decode()
        if block.mark == "script: matplotlib":
            assert (pathlib.Path(folder) / "plane.png").stat().st_size > 1000
            continue
        assert done.stdout.count(b"'CHA-") == 3, done.stdout


class Guides(unittest.TestCase):
    """The guides in both languages."""

    def test_every_block_runs_from_an_empty_folder(self) -> None:
        for guide in GUIDES:
            with self.subTest(guide=guide.parent.name), tempfile.TemporaryDirectory() as folder:
                parts = blocks(guide)
                self.assertGreater(len(parts), 8)
                printed = run([block.code for block in parts if not block.mark.startswith("script")], folder)
                self.assertIn("CHA-", printed)
                self.assertTrue({"axis.toml", "axis.pdf", "cycle.svg"} <= set(os.listdir(folder)))
                run_scripts(guide, folder, LIBRARIES)

    def test_both_languages_have_the_same_code(self) -> None:
        bare = [[re.sub(r" *#.*|lang=\"de\", |, lang=\"de\"", "", block.code) for block in blocks(guide)] for guide in GUIDES]
        self.assertEqual(bare[0], bare[1])

    def test_each_task_takes_ten_lines_at_most(self) -> None:
        for guide in GUIDES:
            tasks = [block.code for block in blocks(guide) if block.mark == "task"]
            self.assertEqual(len(tasks), 3)
            for task in tasks:
                self.assertLessEqual(lines(task), 10, task)

    def test_the_types_of_the_code_hold(self) -> None:
        checkers = [[sys.executable, "-m", "mypy", "--strict"], [sys.executable, "-m", "basedpyright", "--pythonpath", sys.executable]]
        for guide in GUIDES:
            parts = [block for block in blocks(guide) if block.mark in ("", "task", "script")]
            with tempfile.TemporaryDirectory() as folder:
                own = [block.code for block in parts if block.mark != "script"]
                (pathlib.Path(folder) / "guide.py").write_text("\n".join(own), encoding="utf-8")
                for number, block in enumerate(block for block in parts if block.mark == "script"):
                    (pathlib.Path(folder) / f"script{number}.py").write_text(block.code, encoding="utf-8")
                # The types of pint itself are partially unknown.
                settings = {"typeCheckingMode": "strict", "reportUnknownMemberType": False, "reportUnknownArgumentType": False}
                (pathlib.Path(folder) / "pyrightconfig.json").write_text(json.dumps(settings), encoding="utf-8")
                for checker in checkers:
                    with self.subTest(guide=guide.parent.name, checker=checker[2]):
                        done = subprocess.run([*checker, "."], cwd=folder, capture_output=True, check=False, text=True)
                        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_the_notebook_runs_from_an_empty_folder(self) -> None:
        notebook = json.loads(NOTEBOOK.read_text(encoding="utf-8"))
        code = ["".join(cell["source"]) for cell in notebook["cells"] if cell["cell_type"] == "code"]
        tasks = [part for part in code if lines(part) > 2]
        self.assertEqual([lines(part) <= 10 for part in tasks], [True] * len(tasks))
        with tempfile.TemporaryDirectory() as folder:
            self.assertIn("CHA-", run(code, folder))

    def test_the_notebook_shows_what_its_cells_answer(self) -> None:
        notebook = json.loads(NOTEBOOK.read_text(encoding="utf-8"))
        cells = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
        names: dict[str, typing.Any] = {}
        with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):
            found = [answered("".join(cell["source"]), count, names) for count, cell in enumerate(cells, 1)]
        if os.environ.get("ANTRIEB_RENEW_NOTEBOOK"):
            for count, (cell, outputs) in enumerate(zip(cells, found, strict=True), 1):
                cell["outputs"], cell["execution_count"] = outputs, count
            NOTEBOOK.write_text(json.dumps(notebook, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
        self.assertEqual([cell["outputs"] for cell in cells], found)
        kinds = {kind for outputs in found for output in outputs for kind in output.get("data", {})}
        self.assertLessEqual({"text/plain", "text/html", "image/svg+xml"}, kinds)


if __name__ == "__main__":
    unittest.main()
