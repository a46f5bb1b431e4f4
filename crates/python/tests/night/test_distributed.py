"""Sweeps on a cluster of two nodes, of which a worker, then a node is lost in mid-run."""

from __future__ import annotations

import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time
import typing
import unittest

import pyarrow as pa
import pyarrow.dataset as ds
import pyarrow.parquet as pq
import ray
import yaml
from ray import cloudpickle
from ray.cluster_utils import Cluster

import antrieb
from antrieb import distributed
from antrieb import examples

ARM = examples.ARM.to_toml()

CLUSTER = pathlib.Path(__file__).resolve().parents[4] / "examples" / "cluster"
ROWS = 1_500
PART_ROWS = 50

# The workers do not know this file.
cloudpickle.register_pickle_by_value(__import__(__name__, fromlist=["*"]))


def made(first: int, count: int) -> pa.Table:
    """Tasks from their ids alone."""
    ids = range(first, first + count)
    return pa.table(
        {
            "motion[1].payload [kg]": [(each * 7919 % 1000) / 80 for each in ids],
            "motion[1].time [s]": [0.5 + (each * 104729 % 997) / 997 for each in ids],
        }
    )


def seen(folder: str) -> typing.Callable[[int, int], pa.Table]:
    """The same, and each worker leaves its number in a folder."""

    def tasks(first: int, count: int) -> pa.Table:
        pathlib.Path(folder, str(os.getpid())).touch()
        return made(first, count)

    return tasks


def whole(out: str) -> pa.Table:
    """The answers of all parts in the order of their rows."""
    return ds.dataset(out, format="parquet").to_table().sort_by("row").combine_chunks()


class OnACluster(unittest.TestCase):
    """Two nodes on this machine."""

    expected: pa.Table

    @classmethod
    def setUpClass(cls) -> None:
        os.environ["RAY_AUTH_MODE"] = "disabled"
        cls.expected = pa.table(antrieb.sweep(ARM, made(0, ROWS))).replace_schema_metadata(None).combine_chunks()

    def setUp(self) -> None:
        self.cluster = Cluster(initialize_head=True, head_node_args={"num_cpus": 1})
        self.node = self.cluster.add_node(num_cpus=1)
        ray.init(address=self.cluster.address, log_to_driver=False)
        self.addCleanup(self.cluster.shutdown)
        self.addCleanup(ray.shutdown)
        self.folder = tempfile.mkdtemp()
        self.out = os.path.join(self.folder, "out")
        self.begin = time.monotonic()

    def log(self, what: str) -> None:
        """A line of the run."""
        print(f"{time.monotonic() - self.begin:7.1f} s  {what}", flush=True)

    def finished(self) -> list[str]:
        """The parts that are finished."""
        return sorted(path.name for path in pathlib.Path(self.out).glob("part-*.parquet"))

    def bytes_of_parts(self) -> dict[str, bytes]:
        """The parts, byte for byte."""
        return {name: pathlib.Path(self.out, name).read_bytes() for name in self.finished()}

    def after(self, parts: int, then: typing.Callable[[], None]) -> threading.Thread:
        """Does something when so many parts are finished."""

        def wait() -> None:
            while len(self.finished()) < parts:
                time.sleep(0.02)
            then()

        thread = threading.Thread(target=wait)
        thread.start()
        return thread

    def test_every_row_comes_once_though_a_worker_and_a_node_are_lost(self) -> None:
        workers = tempfile.mkdtemp()
        lost: list[str] = []

        def kill_a_worker() -> None:
            # The process of the test reads the project too.
            number = max(int(name) for name in os.listdir(workers) if int(name) != os.getpid())
            os.kill(number, signal.SIGKILL)
            lost.append(f"worker {number}")
            self.log(f"worker {number} killed with {len(self.finished())} parts finished")

        def remove_a_node() -> None:
            self.cluster.remove_node(self.node, allow_graceful=False)
            lost.append("node")
            self.log(f"node removed with {len(self.finished())} parts finished")

        threads = [self.after(5, kill_a_worker), self.after(14, remove_a_node)]
        found = distributed.sweep(ARM, seen(workers), self.out, rows=ROWS, part_rows=PART_ROWS)
        for thread in threads:
            thread.join()
        self.log(f"{found}")
        self.assertEqual(len(lost), 2)
        # What a worker had finished before it was lost is found, not judged again.
        self.assertEqual((found.rows, found.parts), (ROWS, ROWS // PART_ROWS))
        answers = whole(self.out)
        self.assertEqual(answers.column("row").to_pylist(), list(range(ROWS)))
        self.assertTrue(answers.replace_schema_metadata(None).equals(self.expected))
        self.assertEqual(found.fitting, ROWS - answers.column("code").null_count)

        # Finished parts are kept, those that are gone come back byte for byte.
        before = self.bytes_of_parts()
        for name in (self.finished()[3], self.finished()[-1]):
            os.remove(os.path.join(self.out, name))
        again = distributed.sweep(ARM, seen(workers), self.out, rows=ROWS, part_rows=PART_ROWS)
        self.log(f"two parts removed: {again}")
        self.assertEqual((again.rows, again.found), (ROWS, ROWS - 2 * PART_ROWS))
        self.assertEqual(self.bytes_of_parts(), before)

    def test_tasks_of_files_and_their_faults(self) -> None:
        files = []
        for number in range(3):
            files.append(os.path.join(self.folder, f"tasks-{number}.parquet"))
            pq.write_table(made(number * 200, 200), files[-1], row_group_size=60)
        found = distributed.sweep(ARM, files, self.out, part_rows=120, window=2)
        self.assertEqual(found.rows, 600)
        self.assertTrue(whole(self.out).replace_schema_metadata(None).equals(self.expected.slice(0, 600)))
        with self.assertRaises(ValueError):
            distributed.sweep(ARM.replace("6 kg", "7 kg"), files, self.out, part_rows=120)
        with self.assertRaises(antrieb.AntriebError):
            distributed.sweep(ARM.replace("6 kg", "6"), files, os.path.join(self.folder, "none"))

    def test_a_row_that_cannot_be_judged_is_counted_with_its_reason(self) -> None:
        def tasks(first: int, count: int) -> pa.Table:
            return pa.table({"motion[1].time [s]": [None if each % 5 == 0 else 1.0 for each in range(first, first + count)]})

        found = distributed.sweep(ARM, tasks, self.out, rows=50, part_rows=20)
        self.assertEqual((found.rows, found.failed), (50, 10))
        self.assertEqual(sum(found.reasons.values()), 10)

    def test_the_job_of_the_examples_runs_on_the_cluster(self) -> None:
        words = ["--address", self.cluster.address, "--rows", "600", "--part-rows", "200", "--out", self.out]
        done = subprocess.run(
            [sys.executable, str(CLUSTER / "sweep.py"), *words], capture_output=True, text=True, check=False
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("600 rows in ", done.stdout)
        self.assertEqual(len(self.finished()), 3)


class Files(unittest.TestCase):
    """What is handed to clusters."""

    def test_the_manifests_name_what_is_there(self) -> None:
        job = yaml.safe_load((CLUSTER / "rayjob.yaml").read_text(encoding="utf-8"))
        self.assertEqual((job["apiVersion"], job["kind"]), ("ray.io/v1", "RayJob"))
        self.assertIn("sweep.py", job["spec"]["entrypoint"])
        cluster = job["spec"]["rayClusterSpec"]
        self.assertEqual(cluster["rayVersion"], ray.__version__)
        for group in [cluster["headGroupSpec"], *cluster["workerGroupSpecs"]]:
            pod = group["template"]["spec"]
            mounted = {each["name"] for container in pod["containers"] for each in container["volumeMounts"]}
            self.assertEqual(mounted, {each["name"] for each in pod["volumes"]})
        brought = yaml.safe_load((CLUSTER / "runtime-env.yaml").read_text(encoding="utf-8"))
        self.assertTrue(any(f"antrieb-{antrieb.__version__}-" in each for each in brought["pip"]))


if __name__ == "__main__":
    unittest.main()
