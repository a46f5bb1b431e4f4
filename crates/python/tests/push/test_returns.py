"""Ways back follow what stands before them, and values of two kinds are no column."""

from __future__ import annotations

import datetime
import itertools
import typing
import unittest

import antrieb as an
import numpy as np

STROKE = an.Axis("x", an.Load(inertia="0.3 kg m^2"), [an.Move("triangle", distance="90 deg", time="1 s"), an.Return(time="1 s")])
ARM = an.Axis(
    "tilt",
    an.Arm(mass="6 kg", length="0.5 m", angle="-20 deg"),
    [an.Move("modified_sine", distance="90 deg", time="0.8 s"), an.Dwell("1 s", hold="brake"), an.Return(time="0.6 s")],
    brake=True,
    supply="560 V",
)
LAWS = ("trapezoid", "polynomial_5", "parabola", "simple_sine", "modified_sine")


class WaysBack(unittest.TestCase):
    """The sweep of a move before a `Return` is the sizing of the axis with that move."""

    def test_a_distance_in_every_spelling_of_its_heading(self) -> None:
        for axis, heading in itertools.product(
            (STROKE, ARM),
            ("motion[1].distance [deg]", "motion.1.distance [deg]", "motion[1].distance_deg", "motion[1].distance (deg)", "motion[1].distance / deg", "distance_deg"),
        ):
            with self.subTest(axis=axis.name, heading=heading):
                swept = an.sweep(axis, {heading: [30.0, 45.0]}).to_pydict()["fit"]
                sized = [an.size(axis.replace({"motion.1.distance": f"{distance} deg"})).fit for distance in (30, 45)]
                self.assertEqual(swept, sized)

    def test_a_law_is_that_of_the_way_back_too(self) -> None:
        for axis in (STROKE, ARM):
            swept = an.sweep(axis, {"motion.1.law": list(LAWS)}).to_pydict()["fit"]
            self.assertEqual(swept, [an.size(axis.replace({"motion.1.law": law})).fit for law in LAWS])

    def test_a_law_of_its_own_stays(self) -> None:
        own = ARM.replace(motion=[ARM.motion[0], ARM.motion[1], an.Return(time="0.6 s", law="parabola")])
        swept = an.sweep(own, {"motion.1.law": list(LAWS)}).to_pydict()["fit"]
        self.assertEqual(swept, [an.size(own.replace({"motion.1.law": law})).fit for law in LAWS])

    def test_a_whole_project_refuses_what_its_ways_back_would_have_to_follow(self) -> None:
        both = an.Project([STROKE, STROKE.replace(name="y")])
        of_project: list[tuple[typing.Any, dict[str, str]]] = [(both, {"axis": "y"}), (an.Project([STROKE]), {}), (list(both), {"axis": "x"})]
        for project, more in of_project:
            for heading in ("motion[1].distance [deg]", "motion[1].distance_deg", "motion[1].law"):
                with self.assertRaisesRegex(an.AntriebError, "Return"):
                    an.sweep(project, {heading: [45.0] if "distance" in heading else ["parabola"]}, axis=more.get("axis"))
            self.assertEqual(an.sweep(project, {"motion[1].time [s]": [1.0]}, axis=more.get("axis")).to_pydict()["fit"], [an.size(STROKE).fit])
        self.assertEqual(
            an.sweep(both["x"], {"motion[1].distance [deg]": [45.0]}).to_pydict()["fit"],
            [an.size(STROKE.replace({"motion.1.distance": "45 deg"})).fit],
        )


class Kinds(unittest.TestCase):
    """Of values of two kinds a library would make one."""

    def test_times_of_two_kinds_are_refused(self) -> None:
        of_kind: dict[str, typing.Any] = {
            "interval": datetime.timedelta(seconds=1),
            "day": datetime.date(2026, 1, 1),
            "instant": datetime.datetime(2026, 1, 1, 15, 30),
            "aware": datetime.datetime(2026, 1, 1, tzinfo=datetime.UTC),
            "time": datetime.time(5),
            "bytes": b"x",
            "text": "y",
            "number": 1,
            "dictionary": {"a": 1},
            "other": {"b": 2},
        }
        for one, other in itertools.permutations(of_kind, 2):
            with self.subTest(one=one, other=other), self.assertRaises((TypeError, an.AntriebError)):
                an.sweep(ARM, {"motion[1].payload [kg]": [1.0, 2.0], "id": [of_kind[one], of_kind[other]]})
        for value in of_kind.values():
            kept = an.sweep(ARM, {"motion[1].payload [kg]": [1.0, 2.0], "id": [value, value]}).to_pydict()["id"]
            self.assertEqual(kept, [value, value])

    def test_intervals_keep_their_length_in_every_mixture_of_units(self) -> None:
        lengths: list[typing.Any] = [np.timedelta64(2, "s"), np.timedelta64(1500, "ms"), np.timedelta64(1_250_000, "us"), datetime.timedelta(milliseconds=900), np.timedelta64(1, "s")]
        seconds = [2.0, 1.5, 1.25, 0.9, 1.0]
        for order in itertools.permutations(range(len(lengths)), 2):
            swept = an.sweep(ARM, {"motion.1.time": [lengths[place] for place in order]}, inputs=True).to_pydict()
            self.assertEqual(swept["motion[1].time [s]"], [seconds[place] for place in order])
            labels = an.sweep(ARM, {"motion[1].payload [kg]": [1.0, 2.0], "id": [lengths[place] for place in order]}).to_pydict()["id"]
            self.assertEqual([each.total_seconds() for each in labels], [seconds[place] for place in order])
        with self.assertRaises(TypeError):
            an.sweep(ARM, {"motion.1.time": [datetime.timedelta(seconds=1), 1]})

    def test_an_array_without_a_dimension_is_one_value(self) -> None:
        code = "CHA-20A-80-H-C1024-B"
        self.assertEqual(an.check(ARM, np.array(code)), an.check(ARM, code))
        self.assertEqual(an.size(ARM, top=np.array(5)), an.size(ARM, top=5))

    def test_a_field_is_changed_once(self) -> None:
        for changes, fields in (
            ({"supply": "48 V", "requirements.supply": "100 V"}, {}),
            ({"motion.1.time": "2 s", "motion[1].time": "3 s"}, {}),
            ({"supply": "48 V"}, {"supply": "100 V"}),
        ):
            with self.assertRaisesRegex(an.AntriebError, "twice"):
                ARM.replace(changes, **fields)

    def test_a_unit_in_every_spelling_for_objects_as_for_files(self) -> None:
        for heading in ("ambient [degC]", "ambient (degC)", "ambient / degC", "ambient_degC"):
            self.assertEqual(an.sweep(ARM, {heading: [21.0]}).to_pydict()["fit"], [an.size(ARM.replace(ambient="21 degC")).fit])


if __name__ == "__main__":
    unittest.main()
