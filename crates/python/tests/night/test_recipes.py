"""The recipes of the guide that need Dask, Ray and Matplotlib, the pictures that Matplotlib draws, and the notebook in its kernel."""

from __future__ import annotations

import importlib.util
import pathlib
import sys
import tempfile
import unittest
from typing import Any

import nbclient
import nbformat

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "push"))

import test_guides as guides


class Recipes(unittest.TestCase):
    """The scripts of the guides."""

    def test_every_recipe_runs(self) -> None:
        for library in (*guides.NIGHTLY, "matplotlib"):
            self.assertTrue(importlib.util.find_spec(library), library)
        for guide in guides.GUIDES:
            with self.subTest(guide=guide.parent.name), tempfile.TemporaryDirectory() as folder:
                guides.run_scripts(guide, folder, guides.LIBRARIES + guides.NIGHTLY)

    def test_matplotlib_draws_every_figure(self) -> None:
        result = unittest.TestResult()
        unittest.defaultTestLoader.loadTestsFromName("test_lines.Pictures.test_matplotlib_draws_them").run(result)
        self.assertEqual((result.testsRun, result.skipped, result.failures, result.errors), (1, [], [], []))

    def test_the_notebook_shows_tables_pictures_and_formulas(self) -> None:
        notebook: Any = nbformat.read(guides.NOTEBOOK, as_version=4)
        with tempfile.TemporaryDirectory() as folder:
            nbclient.NotebookClient(notebook, timeout=300, resources={"metadata": {"path": folder}}).execute()
        shown = [output.data for cell in notebook.cells for output in cell.get("outputs", []) if output.output_type == "execute_result"]
        html = [data.get("text/html", "") for data in shown]
        for part in ("<table", "<svg", "<math"):
            with self.subTest(part):
                self.assertTrue(any(part in text for text in html) or any(part in data.get("image/svg+xml", "") for data in shown))


if __name__ == "__main__":
    unittest.main()
