"""The recipes of the guide that need Dask and Ray."""

from __future__ import annotations

import importlib.util
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "push"))

import test_guides as guides


class Recipes(unittest.TestCase):
    """The scripts of the guides."""

    def test_every_recipe_runs(self) -> None:
        for library in guides.NIGHTLY:
            self.assertTrue(importlib.util.find_spec(library), library)
        for guide in guides.GUIDES:
            with self.subTest(guide=guide.parent.name), tempfile.TemporaryDirectory() as folder:
                guides.run_scripts(guide, folder, guides.LIBRARIES + guides.NIGHTLY)


if __name__ == "__main__":
    unittest.main()
