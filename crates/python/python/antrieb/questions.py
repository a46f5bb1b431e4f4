"""The questions of antrieb as functions: each answers as the command of its name does.

This file is written from the list of questions by `cargo xtask snapshots`; do not edit it. A quantity is a text with its unit,
`"40 1/min"`. A question about a project takes its text, or the path of its file; a text of one line is a path. Recordings that
it names are opened beside the file, those of a text in `folder`. `file` names a text in faults. A call that would take long is
refused at once unless `deadline` states how long it may take (`"60 s"`); recordings take `memory` at most (`"1 GiB"`). Every
fault of a call is in one `AntriebError`.
"""

from __future__ import annotations

from collections.abc import Sequence
from datetime import date as Day
from typing import TYPE_CHECKING, Literal, overload

from antrieb._axis import BaseAxis, BaseProject
from antrieb._call import Lang, Path, Picture, Text, TimeLimit, ask, flag
from antrieb._called import called
from antrieb._lazy import lazy
from antrieb._trace import Trace, held

if TYPE_CHECKING:
    from antrieb import answers
else:
    answers = lazy("antrieb.answers")



@overload
def size(
    text: BaseAxis,
    *,
    lang: Lang = "en",
    axis: str | None = None,
    top: int = 10,
    all: bool = False,
    samples: int | None = None,
    seed: int | None = None,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Sizing: ...


@overload
def size(
    text: BaseProject | Sequence[BaseAxis],
    *,
    lang: Lang = "en",
    axis: None = None,
    top: int = 10,
    all: bool = False,
    samples: int | None = None,
    seed: int | None = None,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.AxesOfSizing: ...


@overload
def size(
    text: Text,
    *,
    lang: Lang = "en",
    axis: str,
    top: int = 10,
    all: bool = False,
    samples: int | None = None,
    seed: int | None = None,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Sizing: ...


@overload
def size(
    text: Text,
    *,
    lang: Lang = "en",
    axis: None = None,
    top: int = 10,
    all: bool = False,
    samples: int | None = None,
    seed: int | None = None,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Sizing | answers.AxesOfSizing: ...


@called
def size(
    text: Text,
    *,
    lang: Lang = "en",
    axis: str | None = None,
    top: int = 10,
    all: bool = False,
    samples: int | None = None,
    seed: int | None = None,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Sizing | answers.AxesOfSizing:
    """Rank the whole catalogue for an axis.

    Args:
        text: The project as text, or the path of its file.
        lang: Language of the texts: `en` or `de`.
        axis: Only this axis of a project with several.
        top: Number of fitting actuators shown (10). 1 to 65535.
        all: Show all actuators, rejected ones with the reason.
        samples: Samples within the tolerances of the project (10000, fewer for projects that are expensive to compute). 1 to 1000000.
        seed: Seed of the samples; same seed, same samples (1).
        file: What a text is called in faults.
        folder: Where the recordings that a text names lie; without it the current folder.
        deadline: How long the answer may take, such as `60 s`; without it what would take long is refused.
        memory: How much memory the recordings may take, such as `1 GiB`.

    Returns:
        The record, as `--json` has it, as typed objects; units as `antrieb.answers` states.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: answers.Sizing | answers.AxesOfSizing = ask(
        lambda: answers.Sizing | answers.AxesOfSizing,
        "size",
        (text,),
        [("axis", axis), ("top", top), ("all", flag("all", all)), ("samples", samples), ("seed", seed)],
        lang,
        file=file,
        folder=folder,
        deadline=deadline,
        memory=memory,
    )
    return answer


@overload
def check(
    text: BaseAxis,
    code: str | None = None,
    *,
    lang: Lang = "en",
    axis: str | None = None,
    samples: int | None = None,
    seed: int | None = None,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Judgement: ...


@overload
def check(
    text: BaseProject | Sequence[BaseAxis],
    code: str | None = None,
    *,
    lang: Lang = "en",
    axis: None = None,
    samples: int | None = None,
    seed: int | None = None,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.AxesOfJudgement: ...


@overload
def check(
    text: Text,
    code: str | None = None,
    *,
    lang: Lang = "en",
    axis: str,
    samples: int | None = None,
    seed: int | None = None,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Judgement: ...


@overload
def check(
    text: Text,
    code: str | None = None,
    *,
    lang: Lang = "en",
    axis: None = None,
    samples: int | None = None,
    seed: int | None = None,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Judgement | answers.AxesOfJudgement: ...


@called
def check(
    text: Text,
    code: str | None = None,
    *,
    lang: Lang = "en",
    axis: str | None = None,
    samples: int | None = None,
    seed: int | None = None,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Judgement | answers.AxesOfJudgement:
    """Evaluate one actuator, every check with its margin.

    Args:
        text: The project as text, or the path of its file.
        code: Ordering code; default: the project's own [actuator].
        lang: Language of the texts: `en` or `de`.
        axis: Only this axis of a project with several.
        samples: Samples within the tolerances of the project (10000, fewer for projects that are expensive to compute). 1 to 1000000.
        seed: Seed of the samples; same seed, same samples (1).
        file: What a text is called in faults.
        folder: Where the recordings that a text names lie; without it the current folder.
        deadline: How long the answer may take, such as `60 s`; without it what would take long is refused.
        memory: How much memory the recordings may take, such as `1 GiB`.

    Returns:
        The record, as `--json` has it, as typed objects; units as `antrieb.answers` states.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: answers.Judgement | answers.AxesOfJudgement = ask(
        lambda: answers.Judgement | answers.AxesOfJudgement,
        "check",
        (text,),
        [("axis", axis), ("code", code), ("samples", samples), ("seed", seed)],
        lang,
        file=file,
        folder=folder,
        deadline=deadline,
        memory=memory,
    )
    return answer


@called
def sweep(
    text: Text,
    table: Path,
    *,
    lang: Lang = "en",
    axis: str | None = None,
    check: Literal["peak_torque", "peak_speed", "mean_speed", "continuous_torque", "peak_current", "demagnetisation", "voltage", "inertia_ratio", "rope_tension", "gear_mean_torque", "gear_life", "torsion", "natural_frequency", "bearing_axial", "bearing_radial", "bearing_tilting_moment", "bearing_static_moment", "bearing_life", "bearing_static", "tilt_angle", "ambient", "altitude", "protection", "humidity", "humidity_min", "vibration", "shock", "mounting", "dc_link", "drive_current", "drive_current_peak", "drive_peak_time", "torque_speed_trace", "thermal", "overload_i2t", "regeneration", "gear_mean_input_speed", "collision_torque", "collision_number", "resonance_speed", "error_budget", "deviation", "brake_holding", "brake_applications", "brake_emergency", "brake_stops", "feedback_range", "feedback_resolution", "battery", "screw_joint_load", "screw_joint_housing", "application"] | Sequence[Literal["peak_torque", "peak_speed", "mean_speed", "continuous_torque", "peak_current", "demagnetisation", "voltage", "inertia_ratio", "rope_tension", "gear_mean_torque", "gear_life", "torsion", "natural_frequency", "bearing_axial", "bearing_radial", "bearing_tilting_moment", "bearing_static_moment", "bearing_life", "bearing_static", "tilt_angle", "ambient", "altitude", "protection", "humidity", "humidity_min", "vibration", "shock", "mounting", "dc_link", "drive_current", "drive_current_peak", "drive_peak_time", "torque_speed_trace", "thermal", "overload_i2t", "regeneration", "gear_mean_input_speed", "collision_torque", "collision_number", "resonance_speed", "error_budget", "deviation", "brake_holding", "brake_applications", "brake_emergency", "brake_stops", "feedback_range", "feedback_resolution", "battery", "screw_joint_load", "screw_joint_housing", "application"]] | None = None,
    front: bool = False,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.SweepSummary:
    """Evaluate many axes: a table whose columns are keys of the project.

    Args:
        text: The project as text, or the path of its file.
        table: Table of the rows, CSV or Parquet; headings such as "motion[1].time [s]", "requirements.ambient [°C]", "code".
        lang: Language of the texts: `en` or `de`.
        axis: Only this axis of a project with several.
        check: All ordering codes of every row with verdict and utilisation of this check; may be repeated.
        front: For each row the ordering codes that are Pareto-optimal in mass, length and margin.
        file: What a text is called in faults.
        folder: Where the recordings that a text names lie; without it the current folder.
        deadline: How long the answer may take, such as `60 s`; without it what would take long is refused.
        memory: How much memory the recordings may take, such as `1 GiB`.

    Returns:
        The record, as `--json` has it, as typed objects; units as `antrieb.answers` states.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: answers.SweepSummary = ask(
        lambda: answers.SweepSummary,
        "sweep",
        (text,),
        [("axis", axis), ("table", table), ("check", check), ("front", flag("front", front))],
        lang,
        file=file,
        folder=folder,
        deadline=deadline,
        memory=memory,
    )
    return answer


@overload
def explain(
    text: BaseAxis,
    code: str | None = None,
    *,
    lang: Lang = "en",
    axis: str | None = None,
    check: Literal["peak_torque", "peak_speed", "mean_speed", "continuous_torque", "peak_current", "demagnetisation", "voltage", "inertia_ratio", "rope_tension", "gear_mean_torque", "gear_life", "torsion", "natural_frequency", "bearing_axial", "bearing_radial", "bearing_tilting_moment", "bearing_static_moment", "bearing_life", "bearing_static", "tilt_angle", "ambient", "altitude", "protection", "humidity", "humidity_min", "vibration", "shock", "mounting", "dc_link", "drive_current", "drive_current_peak", "drive_peak_time", "torque_speed_trace", "thermal", "overload_i2t", "regeneration", "gear_mean_input_speed", "collision_torque", "collision_number", "resonance_speed", "error_budget", "deviation", "brake_holding", "brake_applications", "brake_emergency", "brake_stops", "feedback_range", "feedback_resolution", "battery", "screw_joint_load", "screw_joint_housing", "application"] | None = None,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Explanations: ...


@overload
def explain(
    text: BaseProject | Sequence[BaseAxis],
    code: str | None = None,
    *,
    lang: Lang = "en",
    axis: None = None,
    check: Literal["peak_torque", "peak_speed", "mean_speed", "continuous_torque", "peak_current", "demagnetisation", "voltage", "inertia_ratio", "rope_tension", "gear_mean_torque", "gear_life", "torsion", "natural_frequency", "bearing_axial", "bearing_radial", "bearing_tilting_moment", "bearing_static_moment", "bearing_life", "bearing_static", "tilt_angle", "ambient", "altitude", "protection", "humidity", "humidity_min", "vibration", "shock", "mounting", "dc_link", "drive_current", "drive_current_peak", "drive_peak_time", "torque_speed_trace", "thermal", "overload_i2t", "regeneration", "gear_mean_input_speed", "collision_torque", "collision_number", "resonance_speed", "error_budget", "deviation", "brake_holding", "brake_applications", "brake_emergency", "brake_stops", "feedback_range", "feedback_resolution", "battery", "screw_joint_load", "screw_joint_housing", "application"] | None = None,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.AxesOfExplanations: ...


@overload
def explain(
    text: Text,
    code: str | None = None,
    *,
    lang: Lang = "en",
    axis: str,
    check: Literal["peak_torque", "peak_speed", "mean_speed", "continuous_torque", "peak_current", "demagnetisation", "voltage", "inertia_ratio", "rope_tension", "gear_mean_torque", "gear_life", "torsion", "natural_frequency", "bearing_axial", "bearing_radial", "bearing_tilting_moment", "bearing_static_moment", "bearing_life", "bearing_static", "tilt_angle", "ambient", "altitude", "protection", "humidity", "humidity_min", "vibration", "shock", "mounting", "dc_link", "drive_current", "drive_current_peak", "drive_peak_time", "torque_speed_trace", "thermal", "overload_i2t", "regeneration", "gear_mean_input_speed", "collision_torque", "collision_number", "resonance_speed", "error_budget", "deviation", "brake_holding", "brake_applications", "brake_emergency", "brake_stops", "feedback_range", "feedback_resolution", "battery", "screw_joint_load", "screw_joint_housing", "application"] | None = None,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Explanations: ...


@overload
def explain(
    text: Text,
    code: str | None = None,
    *,
    lang: Lang = "en",
    axis: None = None,
    check: Literal["peak_torque", "peak_speed", "mean_speed", "continuous_torque", "peak_current", "demagnetisation", "voltage", "inertia_ratio", "rope_tension", "gear_mean_torque", "gear_life", "torsion", "natural_frequency", "bearing_axial", "bearing_radial", "bearing_tilting_moment", "bearing_static_moment", "bearing_life", "bearing_static", "tilt_angle", "ambient", "altitude", "protection", "humidity", "humidity_min", "vibration", "shock", "mounting", "dc_link", "drive_current", "drive_current_peak", "drive_peak_time", "torque_speed_trace", "thermal", "overload_i2t", "regeneration", "gear_mean_input_speed", "collision_torque", "collision_number", "resonance_speed", "error_budget", "deviation", "brake_holding", "brake_applications", "brake_emergency", "brake_stops", "feedback_range", "feedback_resolution", "battery", "screw_joint_load", "screw_joint_housing", "application"] | None = None,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Explanations | answers.AxesOfExplanations: ...


@called
def explain(
    text: Text,
    code: str | None = None,
    *,
    lang: Lang = "en",
    axis: str | None = None,
    check: Literal["peak_torque", "peak_speed", "mean_speed", "continuous_torque", "peak_current", "demagnetisation", "voltage", "inertia_ratio", "rope_tension", "gear_mean_torque", "gear_life", "torsion", "natural_frequency", "bearing_axial", "bearing_radial", "bearing_tilting_moment", "bearing_static_moment", "bearing_life", "bearing_static", "tilt_angle", "ambient", "altitude", "protection", "humidity", "humidity_min", "vibration", "shock", "mounting", "dc_link", "drive_current", "drive_current_peak", "drive_peak_time", "torque_speed_trace", "thermal", "overload_i2t", "regeneration", "gear_mean_input_speed", "collision_torque", "collision_number", "resonance_speed", "error_budget", "deviation", "brake_holding", "brake_applications", "brake_emergency", "brake_stops", "feedback_range", "feedback_resolution", "battery", "screw_joint_load", "screw_joint_housing", "application"] | None = None,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Explanations | answers.AxesOfExplanations:
    """Show the derivation of the checks of one actuator with numbers substituted.

    Args:
        text: The project as text, or the path of its file.
        code: Ordering code; default: the project's own [actuator].
        lang: Language of the texts: `en` or `de`.
        axis: Only this axis of a project with several.
        check: One check, for example continuous_torque; default: all.
        file: What a text is called in faults.
        folder: Where the recordings that a text names lie; without it the current folder.
        deadline: How long the answer may take, such as `60 s`; without it what would take long is refused.
        memory: How much memory the recordings may take, such as `1 GiB`.

    Returns:
        The record, as `--json` has it, as typed objects; units as `antrieb.answers` states.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: answers.Explanations | answers.AxesOfExplanations = ask(
        lambda: answers.Explanations | answers.AxesOfExplanations,
        "explain",
        (text,),
        [("axis", axis), ("code", code), ("check", check)],
        lang,
        file=file,
        folder=folder,
        deadline=deadline,
        memory=memory,
    )
    return answer


@overload
def simulate(
    text: BaseAxis,
    code: str | None = None,
    *,
    lang: Lang = "en",
    axis: str | None = None,
    scenario: Literal["cycle", "emergency_stop", "power_failure", "brake_stuck", "hanging_load", "blocked_load", "encoder_failure", "battery_loss", "link_sag", "hot_ambient", "cold_grease", "collision"] | None = None,
    at: str | None = None,
    reaction: Literal["ramp", "brake", "coast"] | None = None,
    failure: Literal["track", "amplitude", "cable", "check", "error_bit", "data_line"] | None = None,
    cycles: int | None = None,
    cold: bool = False,
    days: int | None = None,
    hours_per_day: str | float | None = None,
    every: str | None = None,
    signals: Literal["wanted_position", "wanted_speed", "position", "speed", "acceleration", "measured_position", "motor_position", "motor_speed", "torque", "current_q", "current_d", "voltage_q", "voltage_d", "link", "winding", "housing", "sensor", "overload", "following_error", "brake", "link_high"] | Sequence[Literal["wanted_position", "wanted_speed", "position", "speed", "acceleration", "measured_position", "motor_position", "motor_speed", "torque", "current_q", "current_d", "voltage_q", "voltage_d", "link", "winding", "housing", "sensor", "overload", "following_error", "brake", "link_high"]] | None = None,
    format: Literal["json"] = "json",
    figure: Literal["simulation", "control_loops"] | None = None,
    theme: Literal["light", "dark"] = "light",
    width: str | None = None,
    height: str | None = None,
    seed: int = 0,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Simulation: ...


@overload
def simulate(
    text: BaseProject | Sequence[BaseAxis],
    code: str | None = None,
    *,
    lang: Lang = "en",
    axis: None = None,
    scenario: Literal["cycle", "emergency_stop", "power_failure", "brake_stuck", "hanging_load", "blocked_load", "encoder_failure", "battery_loss", "link_sag", "hot_ambient", "cold_grease", "collision"] | None = None,
    at: str | None = None,
    reaction: Literal["ramp", "brake", "coast"] | None = None,
    failure: Literal["track", "amplitude", "cable", "check", "error_bit", "data_line"] | None = None,
    cycles: int | None = None,
    cold: bool = False,
    days: int | None = None,
    hours_per_day: str | float | None = None,
    every: str | None = None,
    signals: Literal["wanted_position", "wanted_speed", "position", "speed", "acceleration", "measured_position", "motor_position", "motor_speed", "torque", "current_q", "current_d", "voltage_q", "voltage_d", "link", "winding", "housing", "sensor", "overload", "following_error", "brake", "link_high"] | Sequence[Literal["wanted_position", "wanted_speed", "position", "speed", "acceleration", "measured_position", "motor_position", "motor_speed", "torque", "current_q", "current_d", "voltage_q", "voltage_d", "link", "winding", "housing", "sensor", "overload", "following_error", "brake", "link_high"]] | None = None,
    format: Literal["json"] = "json",
    figure: Literal["simulation", "control_loops"] | None = None,
    theme: Literal["light", "dark"] = "light",
    width: str | None = None,
    height: str | None = None,
    seed: int = 0,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.AxesOfSimulation: ...


@overload
def simulate(
    text: Text,
    code: str | None = None,
    *,
    lang: Lang = "en",
    axis: str,
    scenario: Literal["cycle", "emergency_stop", "power_failure", "brake_stuck", "hanging_load", "blocked_load", "encoder_failure", "battery_loss", "link_sag", "hot_ambient", "cold_grease", "collision"] | None = None,
    at: str | None = None,
    reaction: Literal["ramp", "brake", "coast"] | None = None,
    failure: Literal["track", "amplitude", "cable", "check", "error_bit", "data_line"] | None = None,
    cycles: int | None = None,
    cold: bool = False,
    days: int | None = None,
    hours_per_day: str | float | None = None,
    every: str | None = None,
    signals: Literal["wanted_position", "wanted_speed", "position", "speed", "acceleration", "measured_position", "motor_position", "motor_speed", "torque", "current_q", "current_d", "voltage_q", "voltage_d", "link", "winding", "housing", "sensor", "overload", "following_error", "brake", "link_high"] | Sequence[Literal["wanted_position", "wanted_speed", "position", "speed", "acceleration", "measured_position", "motor_position", "motor_speed", "torque", "current_q", "current_d", "voltage_q", "voltage_d", "link", "winding", "housing", "sensor", "overload", "following_error", "brake", "link_high"]] | None = None,
    format: Literal["json"] = "json",
    figure: Literal["simulation", "control_loops"] | None = None,
    theme: Literal["light", "dark"] = "light",
    width: str | None = None,
    height: str | None = None,
    seed: int = 0,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Simulation: ...


@overload
def simulate(
    text: Text,
    code: str | None = None,
    *,
    lang: Lang = "en",
    axis: None = None,
    scenario: Literal["cycle", "emergency_stop", "power_failure", "brake_stuck", "hanging_load", "blocked_load", "encoder_failure", "battery_loss", "link_sag", "hot_ambient", "cold_grease", "collision"] | None = None,
    at: str | None = None,
    reaction: Literal["ramp", "brake", "coast"] | None = None,
    failure: Literal["track", "amplitude", "cable", "check", "error_bit", "data_line"] | None = None,
    cycles: int | None = None,
    cold: bool = False,
    days: int | None = None,
    hours_per_day: str | float | None = None,
    every: str | None = None,
    signals: Literal["wanted_position", "wanted_speed", "position", "speed", "acceleration", "measured_position", "motor_position", "motor_speed", "torque", "current_q", "current_d", "voltage_q", "voltage_d", "link", "winding", "housing", "sensor", "overload", "following_error", "brake", "link_high"] | Sequence[Literal["wanted_position", "wanted_speed", "position", "speed", "acceleration", "measured_position", "motor_position", "motor_speed", "torque", "current_q", "current_d", "voltage_q", "voltage_d", "link", "winding", "housing", "sensor", "overload", "following_error", "brake", "link_high"]] | None = None,
    format: Literal["json"] = "json",
    figure: Literal["simulation", "control_loops"] | None = None,
    theme: Literal["light", "dark"] = "light",
    width: str | None = None,
    height: str | None = None,
    seed: int = 0,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Simulation | answers.AxesOfSimulation: ...


@overload
def simulate(
    text: Text,
    code: str | None = None,
    *,
    lang: Lang = "en",
    axis: str | None = None,
    scenario: Literal["cycle", "emergency_stop", "power_failure", "brake_stuck", "hanging_load", "blocked_load", "encoder_failure", "battery_loss", "link_sag", "hot_ambient", "cold_grease", "collision"] | None = None,
    at: str | None = None,
    reaction: Literal["ramp", "brake", "coast"] | None = None,
    failure: Literal["track", "amplitude", "cable", "check", "error_bit", "data_line"] | None = None,
    cycles: int | None = None,
    cold: bool = False,
    days: int | None = None,
    hours_per_day: str | float | None = None,
    every: str | None = None,
    signals: Literal["wanted_position", "wanted_speed", "position", "speed", "acceleration", "measured_position", "motor_position", "motor_speed", "torque", "current_q", "current_d", "voltage_q", "voltage_d", "link", "winding", "housing", "sensor", "overload", "following_error", "brake", "link_high"] | Sequence[Literal["wanted_position", "wanted_speed", "position", "speed", "acceleration", "measured_position", "motor_position", "motor_speed", "torque", "current_q", "current_d", "voltage_q", "voltage_d", "link", "winding", "housing", "sensor", "overload", "following_error", "brake", "link_high"]] | None = None,
    format: Literal["csv"],
    figure: Literal["simulation", "control_loops"] | None = None,
    theme: Literal["light", "dark"] = "light",
    width: str | None = None,
    height: str | None = None,
    seed: int = 0,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> str: ...


@overload
def simulate(
    text: Text,
    code: str | None = None,
    *,
    lang: Lang = "en",
    axis: str | None = None,
    scenario: Literal["cycle", "emergency_stop", "power_failure", "brake_stuck", "hanging_load", "blocked_load", "encoder_failure", "battery_loss", "link_sag", "hot_ambient", "cold_grease", "collision"] | None = None,
    at: str | None = None,
    reaction: Literal["ramp", "brake", "coast"] | None = None,
    failure: Literal["track", "amplitude", "cable", "check", "error_bit", "data_line"] | None = None,
    cycles: int | None = None,
    cold: bool = False,
    days: int | None = None,
    hours_per_day: str | float | None = None,
    every: str | None = None,
    signals: Literal["wanted_position", "wanted_speed", "position", "speed", "acceleration", "measured_position", "motor_position", "motor_speed", "torque", "current_q", "current_d", "voltage_q", "voltage_d", "link", "winding", "housing", "sensor", "overload", "following_error", "brake", "link_high"] | Sequence[Literal["wanted_position", "wanted_speed", "position", "speed", "acceleration", "measured_position", "motor_position", "motor_speed", "torque", "current_q", "current_d", "voltage_q", "voltage_d", "link", "winding", "housing", "sensor", "overload", "following_error", "brake", "link_high"]] | None = None,
    format: Literal["svg"],
    figure: Literal["simulation", "control_loops"] | None = None,
    theme: Literal["light", "dark"] = "light",
    width: str | None = None,
    height: str | None = None,
    seed: int = 0,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> Picture: ...


@overload
def simulate(
    text: Text,
    code: str | None = None,
    *,
    lang: Lang = "en",
    axis: str | None = None,
    scenario: Literal["cycle", "emergency_stop", "power_failure", "brake_stuck", "hanging_load", "blocked_load", "encoder_failure", "battery_loss", "link_sag", "hot_ambient", "cold_grease", "collision"] | None = None,
    at: str | None = None,
    reaction: Literal["ramp", "brake", "coast"] | None = None,
    failure: Literal["track", "amplitude", "cable", "check", "error_bit", "data_line"] | None = None,
    cycles: int | None = None,
    cold: bool = False,
    days: int | None = None,
    hours_per_day: str | float | None = None,
    every: str | None = None,
    signals: Literal["wanted_position", "wanted_speed", "position", "speed", "acceleration", "measured_position", "motor_position", "motor_speed", "torque", "current_q", "current_d", "voltage_q", "voltage_d", "link", "winding", "housing", "sensor", "overload", "following_error", "brake", "link_high"] | Sequence[Literal["wanted_position", "wanted_speed", "position", "speed", "acceleration", "measured_position", "motor_position", "motor_speed", "torque", "current_q", "current_d", "voltage_q", "voltage_d", "link", "winding", "housing", "sensor", "overload", "following_error", "brake", "link_high"]] | None = None,
    format: Literal["parquet"],
    figure: Literal["simulation", "control_loops"] | None = None,
    theme: Literal["light", "dark"] = "light",
    width: str | None = None,
    height: str | None = None,
    seed: int = 0,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> bytes: ...


@called
def simulate(
    text: Text,
    code: str | None = None,
    *,
    lang: Lang = "en",
    axis: str | None = None,
    scenario: Literal["cycle", "emergency_stop", "power_failure", "brake_stuck", "hanging_load", "blocked_load", "encoder_failure", "battery_loss", "link_sag", "hot_ambient", "cold_grease", "collision"] | None = None,
    at: str | None = None,
    reaction: Literal["ramp", "brake", "coast"] | None = None,
    failure: Literal["track", "amplitude", "cable", "check", "error_bit", "data_line"] | None = None,
    cycles: int | None = None,
    cold: bool = False,
    days: int | None = None,
    hours_per_day: str | float | None = None,
    every: str | None = None,
    signals: Literal["wanted_position", "wanted_speed", "position", "speed", "acceleration", "measured_position", "motor_position", "motor_speed", "torque", "current_q", "current_d", "voltage_q", "voltage_d", "link", "winding", "housing", "sensor", "overload", "following_error", "brake", "link_high"] | Sequence[Literal["wanted_position", "wanted_speed", "position", "speed", "acceleration", "measured_position", "motor_position", "motor_speed", "torque", "current_q", "current_d", "voltage_q", "voltage_d", "link", "winding", "housing", "sensor", "overload", "following_error", "brake", "link_high"]] | None = None,
    format: Literal["json", "csv", "parquet", "svg"] = "json",
    figure: Literal["simulation", "control_loops"] | None = None,
    theme: Literal["light", "dark"] = "light",
    width: str | None = None,
    height: str | None = None,
    seed: int = 0,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Simulation | answers.AxesOfSimulation | str | Picture | bytes:
    """Simulate an axis with one actuator: motor, gear, load, control, scenario.

    Args:
        text: The project as text, or the path of its file.
        code: Ordering code; default: the project's own [actuator].
        lang: Language of the texts: `en` or `de`.
        axis: Only this axis of a project with several.
        scenario: Scenario; default: that of the project, otherwise the cycle.
        at: Time of the event, such as "300 ms"; default: the worst instant of the cycle, which the answer states.
        reaction: Stop reaction of the drive; default: ramp.
        failure: Type of encoder failure in the encoder scenario; default: signal loss.
        cycles: Number of cycles simulated (1). 1 to 100000.
        cold: Start at ambient temperature instead of in thermal steady state.
        days: Additionally simulate this number of days with the mean losses of the cycle: temperatures over the day, energy. 1 to 3660.
        hours_per_day: Operation per day in hours (24).
        every: Sampling interval of the trace ("1 ms").
        signals: Signals of the trace, separated by commas; default: all.
        format: Json for the summary (default), csv or parquet for the trace or the days, svg for a picture.
        figure: Picture: the trace, or the frequency responses of the control loops (simulation).
        theme: Colours of the picture.
        width: Width of the picture, for example "160 mm"; default: by its content.
        height: Height of the picture, for example "100 mm"; increased if the content requires it.
        seed: Seed of the gear and encoder errors (0).
        file: What a text is called in faults.
        folder: Where the recordings that a text names lie; without it the current folder.
        deadline: How long the answer may take, such as `60 s`; without it what would take long is refused.
        memory: How much memory the recordings may take, such as `1 GiB`.

    Returns:
        The record as typed objects with `format="json"`, else the file.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: answers.Simulation | answers.AxesOfSimulation | str | Picture | bytes = ask(
        lambda: answers.Simulation | answers.AxesOfSimulation,
        "simulate",
        (text,),
        [("axis", axis), ("code", code), ("scenario", scenario), ("at", at), ("reaction", reaction), ("failure", failure), ("cycles", cycles), ("cold", flag("cold", cold)), ("days", days), ("hours-per-day", hours_per_day), ("every", every), ("signals", signals), ("format", format), ("figure", figure), ("theme", theme), ("width", width), ("height", height), ("seed", seed)],
        lang,
        file=file,
        folder=folder,
        deadline=deadline,
        memory=memory,
    )
    return answer


@called
def identify(
    trace: Trace,
    text: Text,
    code: str | None = None,
    *,
    lang: Lang = "en",
    axis: str | None = None,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Identification:
    """Estimate load, friction and torque constant from a recorded run.

    Args:
        trace: Recorded run (.csv or .parquet) with the columns of a trace file; its position is the angle of the mechanism, times the ratio of a stage, from the same zero.
        text: The project as text, or the path of its file.
        code: Ordering code; default: the project's own [actuator].
        lang: Language of the texts: `en` or `de`.
        axis: Only this axis of a project with several.
        file: What a text is called in faults.
        folder: Where the recordings that a text names lie; without it the current folder.
        deadline: How long the answer may take, such as `60 s`; without it what would take long is refused.
        memory: How much memory the recordings may take, such as `1 GiB`.

    Returns:
        The record, as `--json` has it, as typed objects; units as `antrieb.answers` states.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: answers.Identification = ask(
        lambda: answers.Identification,
        "identify",
        (text,),
        [("axis", axis), ("code", code), ("trace", held("trace", trace))],
        lang,
        file=file,
        folder=folder,
        deadline=deadline,
        memory=memory,
    )
    return answer


@called
def report(
    text: Text,
    code: str | None = None,
    *,
    lang: Lang = "en",
    axis: str | None = None,
    full: bool = False,
    installation: bool = False,
    date: str | Day | None = None,
    revision: str | None = None,
    title: str | None = None,
    number: str | None = None,
    author: str | None = None,
    company: str | None = None,
    customer: str | None = None,
    order: str | None = None,
    change: str | Sequence[str] | None = None,
    archive: bool = False,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> bytes:
    """The results as a PDF to sign.

    Args:
        text: The project as text, or the path of its file.
        code: Ordering code; default: the project's own [actuator], otherwise the best of the catalogue.
        lang: Language of the texts: `en` or `de`.
        axis: Only this axis of a project with several.
        full: Include the derivation of every check, all sources and all ordering codes as appendices.
        installation: Include wiring, mounting and commissioning of the ordering code, and maintenance if --delivered is given.
        date: Date of the document, for example 2026-11-21; default: none, so that the same call gives the same bytes.
        revision: Revision of the document.
        title: Project, plant or order.
        number: Document number.
        author: Author.
        company: Company or office.
        customer: Customer.
        order: Number of the order.
        change: Line of the list of changes, for example "B; 2026-11-21; E. Example; longer stroke"; may be repeated.
        archive: As PDF/A for archiving; requires --date.
        file: What a text is called in faults.
        folder: Where the recordings that a text names lie; without it the current folder.
        deadline: How long the answer may take, such as `60 s`; without it what would take long is refused.
        memory: How much memory the recordings may take, such as `1 GiB`.

    Returns:
        The bytes of the file.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: bytes = ask(
        lambda: object,
        "report",
        (text,),
        [("axis", axis), ("code", code), ("full", flag("full", full)), ("installation", flag("installation", installation)), ("date", date), ("revision", revision), ("title", title), ("number", number), ("author", author), ("company", company), ("customer", customer), ("order", order), ("change", change), ("archive", flag("archive", archive))],
        lang,
        file=file,
        folder=folder,
        deadline=deadline,
        memory=memory,
    )
    return answer


@overload
def compare(
    text: BaseAxis,
    code: str | Sequence[str],
    *,
    lang: Lang = "en",
    axis: str | None = None,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Comparison: ...


@overload
def compare(
    text: BaseProject | Sequence[BaseAxis],
    code: str | Sequence[str],
    *,
    lang: Lang = "en",
    axis: None = None,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.AxesOfComparison: ...


@overload
def compare(
    text: Text,
    code: str | Sequence[str],
    *,
    lang: Lang = "en",
    axis: str,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Comparison: ...


@overload
def compare(
    text: Text,
    code: str | Sequence[str],
    *,
    lang: Lang = "en",
    axis: None = None,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Comparison | answers.AxesOfComparison: ...


@called
def compare(
    text: Text,
    code: str | Sequence[str],
    *,
    lang: Lang = "en",
    axis: str | None = None,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Comparison | answers.AxesOfComparison:
    """Two to five actuators side by side, check by check.

    Args:
        text: The project as text, or the path of its file.
        code: Ordering code; repeat for each actuator.
        lang: Language of the texts: `en` or `de`.
        axis: Only this axis of a project with several.
        file: What a text is called in faults.
        folder: Where the recordings that a text names lie; without it the current folder.
        deadline: How long the answer may take, such as `60 s`; without it what would take long is refused.
        memory: How much memory the recordings may take, such as `1 GiB`.

    Returns:
        The record, as `--json` has it, as typed objects; units as `antrieb.answers` states.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: answers.Comparison | answers.AxesOfComparison = ask(
        lambda: answers.Comparison | answers.AxesOfComparison,
        "compare",
        (text,),
        [("axis", axis), ("code", code)],
        lang,
        file=file,
        folder=folder,
        deadline=deadline,
        memory=memory,
    )
    return answer


@overload
def diff(
    old: Text,
    new: Text,
    code: str | None = None,
    *,
    lang: Lang = "en",
    axis: str,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Difference: ...


@overload
def diff(
    old: Text,
    new: Text,
    code: str | None = None,
    *,
    lang: Lang = "en",
    axis: None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Difference | answers.AxesOfDifference: ...


@called
def diff(
    old: Text,
    new: Text,
    code: str | None = None,
    *,
    lang: Lang = "en",
    axis: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Difference | answers.AxesOfDifference:
    """Changes in each check between two revisions of a project.

    Args:
        old: The project before as text, or the path of its file.
        new: The project after as text, or the path of its file.
        code: Ordering code; default: the project's own [actuator], otherwise the best one before.
        lang: Language of the texts: `en` or `de`.
        axis: Only this axis of a project with several.
        folder: Where the recordings that a text names lie; without it the current folder.
        deadline: How long the answer may take, such as `60 s`; without it what would take long is refused.
        memory: How much memory the recordings may take, such as `1 GiB`.

    Returns:
        The record, as `--json` has it, as typed objects; units as `antrieb.answers` states.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: answers.Difference | answers.AxesOfDifference = ask(
        lambda: answers.Difference | answers.AxesOfDifference,
        "diff",
        (old, new,),
        [("axis", axis), ("code", code)],
        lang,
        folder=folder,
        deadline=deadline,
        memory=memory,
    )
    return answer


@overload
def export(
    text: Text,
    code: str | None = None,
    *,
    lang: Lang = "en",
    axis: str | None = None,
    table: Literal["inputs", "assumptions", "demand", "motion", "candidates", "checks", "course"] | None = None,
    format: Literal["json"] = "json",
    top: int = 20,
    revision: str | None = None,
    date: str | Day | None = None,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Table: ...


@overload
def export(
    text: Text,
    code: str | None = None,
    *,
    lang: Lang = "en",
    axis: str | None = None,
    table: Literal["inputs", "assumptions", "demand", "motion", "candidates", "checks", "course"] | None = None,
    format: Literal["csv"],
    top: int = 20,
    revision: str | None = None,
    date: str | Day | None = None,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> str: ...


@overload
def export(
    text: Text,
    code: str | None = None,
    *,
    lang: Lang = "en",
    axis: str | None = None,
    table: Literal["inputs", "assumptions", "demand", "motion", "candidates", "checks", "course"] | None = None,
    format: Literal["parquet", "xlsx"],
    top: int = 20,
    revision: str | None = None,
    date: str | Day | None = None,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> bytes: ...


@called
def export(
    text: Text,
    code: str | None = None,
    *,
    lang: Lang = "en",
    axis: str | None = None,
    table: Literal["inputs", "assumptions", "demand", "motion", "candidates", "checks", "course"] | None = None,
    format: Literal["json", "csv", "parquet", "xlsx"] = "json",
    top: int = 20,
    revision: str | None = None,
    date: str | Day | None = None,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Table | str | bytes:
    """The results as a workbook, or one table as CSV, JSON or Parquet.

    Args:
        text: The project as text, or the path of its file.
        code: Ordering code; default: the project's own [actuator], otherwise the best one.
        lang: Language of the texts: `en` or `de`.
        axis: Only this axis of a project with several.
        table: One table: inputs, assumptions, demand, motion, candidates, checks, course.
        format: Json, csv or parquet for one table, xlsx for the workbook; default: json if a table is named, otherwise xlsx.
        top: Number of ranked actuators in the tables (20). 1 to 65535.
        revision: Revision on the first sheet.
        date: Date on the first sheet; default: none, so that the same call gives the same bytes.
        file: What a text is called in faults.
        folder: Where the recordings that a text names lie; without it the current folder.
        deadline: How long the answer may take, such as `60 s`; without it what would take long is refused.
        memory: How much memory the recordings may take, such as `1 GiB`.

    Returns:
        The record as typed objects with `format="json"`, else the file.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: answers.Table | str | bytes = ask(
        lambda: answers.Table,
        "export",
        (text,),
        [("axis", axis), ("code", code), ("table", table), ("format", format), ("top", top), ("revision", revision), ("date", date)],
        lang,
        file=file,
        folder=folder,
        deadline=deadline,
        memory=memory,
    )
    return answer


@called
def code_parse(
    code: str,
    *,
    lang: Lang = "en",
) -> answers.CodeReading:
    """Read an ordering code and explain each field.

    Args:
        code: Ordering code, for example CHA-20A-100-H-C1024-B.
        lang: Language of the texts: `en` or `de`.

    Returns:
        The record, as `--json` has it, as typed objects; units as `antrieb.answers` states.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: answers.CodeReading = ask(
        lambda: answers.CodeReading,
        "code parse",
        (),
        [("code", code)],
        lang,
    )
    return answer


@called
def code_list(
    pattern: str | None = None,
    *,
    lang: Lang = "en",
    available: bool = False,
) -> list[answers.ListedCode]:
    """List the valid ordering codes.

    Args:
        pattern: Partial ordering code, for example CHA-20A-*-H; default: all.
        lang: Language of the texts: `en` or `de`.
        available: Only ordering codes available without enquiry.

    Returns:
        The record, as `--json` has it, as typed objects; units as `antrieb.answers` states.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: list[answers.ListedCode] = ask(
        lambda: list[answers.ListedCode],
        "code list",
        (),
        [("pattern", pattern), ("available", flag("available", available))],
        lang,
    )
    return answer


@called
def code_complete(
    code: str,
    *,
    lang: Lang = "en",
) -> answers.Completion:
    """Complete a partial ordering code and show the possible continuations.

    Args:
        code: Partial ordering code; * stands for any value of a field.
        lang: Language of the texts: `en` or `de`.

    Returns:
        The record, as `--json` has it, as typed objects; units as `antrieb.answers` states.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: answers.Completion = ask(
        lambda: answers.Completion,
        "code complete",
        (),
        [("code", code)],
        lang,
    )
    return answer


@called
def data(
    code: str,
    *,
    lang: Lang = "en",
) -> answers.Sheet:
    """Data sheet of one actuator, each value with its source table.

    Args:
        code: Ordering code.
        lang: Language of the texts: `en` or `de`.

    Returns:
        The record, as `--json` has it, as typed objects; units as `antrieb.answers` states.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: answers.Sheet = ask(
        lambda: answers.Sheet,
        "data",
        (),
        [("code", code)],
        lang,
    )
    return answer


@called
def wiring(
    code: str,
    *,
    lang: Lang = "en",
    length: str | None = None,
    cross_section: str | None = None,
) -> answers.Wiring:
    """Connectors, pins and cables of one actuator, and check of a pin list.

    Args:
        code: Ordering code.
        lang: Language of the texts: `en` or `de`.
        length: Cable length, such as "15 m": voltage drop of brake and encoder supply.
        cross_section: Conductor cross-section, such as "1 mm²".

    Returns:
        The record, as `--json` has it, as typed objects; units as `antrieb.answers` states.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: answers.Wiring = ask(
        lambda: answers.Wiring,
        "wiring",
        (),
        [("code", code), ("length", length), ("cross-section", cross_section)],
        lang,
    )
    return answer


@called
def wiring_check(
    text: Text,
    code: str,
    *,
    lang: Lang = "en",
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.WiringCheck:
    """Comparison of a pin list with the manual.

    Args:
        text: The list of pins in CSV as text, or the path of its file.
        code: Ordering code.
        lang: Language of the texts: `en` or `de`.
        file: What a text is called in faults.
        folder: Where the recordings that a text names lie; without it the current folder.
        deadline: How long the answer may take, such as `60 s`; without it what would take long is refused.
        memory: How much memory the recordings may take, such as `1 GiB`.

    Returns:
        The record, as `--json` has it, as typed objects; units as `antrieb.answers` states.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: answers.WiringCheck = ask(
        lambda: answers.WiringCheck,
        "wiring --check",
        (text,),
        [("code", code)],
        lang,
        file=file,
        folder=folder,
        deadline=deadline,
        memory=memory,
    )
    return answer


@called
def encoder(
    code: str,
    *,
    lang: Lang = "en",
    angle: str | None = None,
    turn: str | None = None,
    speed: str | None = None,
    seed: int | None = None,
    window: str | None = None,
    battery_lost: bool = False,
    error: bool = False,
    decode: str | None = None,
) -> answers.Encoder:
    """Encoder signals and data words at an angle; decoding of a word.

    Args:
        code: Ordering code.
        lang: Language of the texts: `en` or `de`.
        angle: Angle of the motor shaft, clockwise seen from the front, such as "30 deg". Without it `0 deg`.
        turn: Whole turns of the motor shaft before this angle. Without it `0`.
        speed: Speed of the motor shaft, such as "300 rad/s". Without it `0 1/min`.
        seed: Seed of the encoder error within its accuracy; default: no error.
        window: Angle range of the signals shown, such as "2 deg"; default: two periods each.
        battery_lost: Battery and supply have failed at the same time (M128S).
        error: The encoder reports an error (EnDat).
        decode: Decode this word (bits in the order sent) and report its errors.

    Returns:
        The record, as `--json` has it, as typed objects; units as `antrieb.answers` states.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: answers.Encoder = ask(
        lambda: answers.Encoder,
        "encoder",
        (),
        [("code", code), ("angle", angle), ("turn", turn), ("speed", speed), ("seed", seed), ("window", window), ("battery-lost", flag("battery_lost", battery_lost)), ("error", flag("error", error)), ("decode", decode)],
        lang,
    )
    return answer


@called
def encoder_vcd(
    code: str,
    *,
    lang: Lang = "en",
    angle: str | None = None,
    turn: str | None = None,
    speed: str | None = None,
    seed: int | None = None,
    time: str | None = None,
    endat: Literal["2.2", "2.1"] = "2.2",
    connector: Literal["feedback", "output_encoder"] = "feedback",
) -> str:
    """The digital signals of an encoder over time, as a value change dump (VCD).

    Args:
        code: Ordering code.
        lang: Language of the texts: `en` or `de`.
        angle: Angle of the motor shaft, clockwise seen from the front, such as "30 deg". Without it `0 deg`.
        turn: Whole turns of the motor shaft before this angle. Without it `0`.
        speed: Speed of the motor shaft, such as "300 rad/s". Without it `0 1/min`.
        seed: Seed of the encoder error within its accuracy; default: no error.
        time: Length of the trace (--vcd). Without it `1 ms`.
        endat: Command set of the EnDat word in the trace.
        connector: Encoder in the trace.

    Returns:
        The text of the file.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: str = ask(
        lambda: object,
        "encoder --vcd",
        (),
        [("code", code), ("angle", angle), ("turn", turn), ("speed", speed), ("seed", seed), ("time", time), ("endat", endat), ("connector", connector)],
        lang,
    )
    return answer


@called
def errata(
    about: str | None = None,
    *,
    lang: Lang = "en",
) -> answers.Errata:
    """Errors and doubtful values in the manual, and the values used instead.

    Args:
        about: Ordering code, table number, or id of an erratum; default: all.
        lang: Language of the texts: `en` or `de`.

    Returns:
        The record, as `--json` has it, as typed objects; units as `antrieb.answers` states.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: answers.Errata = ask(
        lambda: answers.Errata,
        "errata",
        (),
        [("about", about)],
        lang,
    )
    return answer


@overload
def catalogue_export(
    *,
    lang: Lang = "en",
    format: Literal["json"] = "json",
) -> list[answers.CatalogueCell]: ...


@overload
def catalogue_export(
    *,
    lang: Lang = "en",
    format: Literal["csv"],
) -> str: ...


@called
def catalogue_export(
    *,
    lang: Lang = "en",
    format: Literal["json", "csv"] = "json",
) -> list[answers.CatalogueCell] | str:
    """Every cell of the manufacturer's tables in long format.

    Args:
        lang: Language of the texts: `en` or `de`.
        format: Format of the catalogue.

    Returns:
        The record as typed objects with `format="json"`, else the file.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: list[answers.CatalogueCell] | str = ask(
        lambda: list[answers.CatalogueCell],
        "catalogue export",
        (),
        [("format", format)],
        lang,
    )
    return answer


@called
def catalogue_check(
    text: Text,
    *,
    lang: Lang = "en",
    fix_units: bool = False,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.CatalogueCheck:
    """Check catalogue files: faults with line and column, then implausible values with their reasons.

    Args:
        text: The catalogue file as text, or the path of its file.
        lang: Language of the texts: `en` or `de`.
        fix_units: Propose cells with other units or shifted decimal marks that resolve findings; writes nothing.
        file: What a text is called in faults.
        folder: Where the recordings that a text names lie; without it the current folder.
        deadline: How long the answer may take, such as `60 s`; without it what would take long is refused.
        memory: How much memory the recordings may take, such as `1 GiB`.

    Returns:
        The record, as `--json` has it, as typed objects; units as `antrieb.answers` states.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: answers.CatalogueCheck = ask(
        lambda: answers.CatalogueCheck,
        "catalogue check",
        (text,),
        [("fix-units", flag("fix_units", fix_units))],
        lang,
        file=file,
        folder=folder,
        deadline=deadline,
        memory=memory,
    )
    return answer


@called
def torsion(
    code: str,
    *,
    lang: Lang = "en",
    torque: str | None = None,
    angle: str | None = None,
) -> answers.Torsion:
    """Torsion of the gear under a torque, or the torque for an angle.

    Args:
        code: Ordering code.
        lang: Language of the texts: `en` or `de`.
        torque: Torque at the output, for example "60 N m".
        angle: Torsion angle, for example "1 arcmin", instead of the torque.

    Returns:
        The record, as `--json` has it, as typed objects; units as `antrieb.answers` states.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: answers.Torsion = ask(
        lambda: answers.Torsion,
        "torsion",
        (),
        [("code", code), ("torque", torque), ("angle", angle)],
        lang,
    )
    return answer


@called
def commission(
    code: str,
    *,
    lang: Lang = "en",
    for_: Literal["sinamics", "cia402", "plain"] | None = None,
    ambient: str | None = None,
) -> answers.CommissionAnswer:
    """Settings for the drive, checklists, and evaluation of measured values.

    Args:
        code: Ordering code.
        lang: Language of the texts: `en` or `de`.
        for_: Format of the settings: sinamics, cia402, plain.
        ambient: Temperature at which winding and sensors are measured (20 °C).

    Returns:
        The record, as `--json` has it, as typed objects; units as `antrieb.answers` states.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: answers.CommissionAnswer = ask(
        lambda: answers.CommissionAnswer,
        "commission",
        (),
        [("code", code), ("for", for_), ("ambient", ambient)],
        lang,
    )
    return answer


@called
def commission_out(
    code: str,
    for_: Literal["sinamics", "cia402"],
    *,
    lang: Lang = "en",
) -> str:
    """Drive settings as a file: parameters line by line (sinamics), or an EDS (cia402).

    Args:
        code: Ordering code.
        for_: Format of the settings: sinamics, cia402, plain.
        lang: Language of the texts: `en` or `de`.

    Returns:
        The text of the file.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: str = ask(
        lambda: object,
        "commission --out",
        (),
        [("code", code), ("for", for_)],
        lang,
    )
    return answer


@called
def commission_checklist(
    code: str,
    *,
    lang: Lang = "en",
    ambient: str | None = None,
) -> bytes:
    """Checklists as PDF, a form to be completed on screen or on paper.

    Args:
        code: Ordering code.
        lang: Language of the texts: `en` or `de`.
        ambient: Temperature at which winding and sensors are measured (20 °C).

    Returns:
        The bytes of the file.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: bytes = ask(
        lambda: object,
        "commission --checklist",
        (),
        [("code", code), ("ambient", ambient)],
        lang,
    )
    return answer


@called
def commission_blank(
    code: str,
    *,
    lang: Lang = "en",
) -> str:
    """Write an empty record for measured values.

    Args:
        code: Ordering code.
        lang: Language of the texts: `en` or `de`.

    Returns:
        The text of the file.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: str = ask(
        lambda: object,
        "commission --blank",
        (),
        [("code", code)],
        lang,
    )
    return answer


@called
def commission_record(
    text: Text,
    code: str,
    *,
    lang: Lang = "en",
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Recorded:
    """Evaluation of measured values with likely causes.

    Args:
        text: The measured values as text, or the path of their file.
        code: Ordering code.
        lang: Language of the texts: `en` or `de`.
        file: What a text is called in faults.
        folder: Where the recordings that a text names lie; without it the current folder.
        deadline: How long the answer may take, such as `60 s`; without it what would take long is refused.
        memory: How much memory the recordings may take, such as `1 GiB`.

    Returns:
        The record, as `--json` has it, as typed objects; units as `antrieb.answers` states.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: answers.Recorded = ask(
        lambda: answers.Recorded,
        "commission --record",
        (text,),
        [("code", code)],
        lang,
        file=file,
        folder=folder,
        deadline=deadline,
        memory=memory,
    )
    return answer


@called
def inertia(
    body: str | Sequence[str],
    *,
    lang: Lang = "en",
) -> answers.Inertia:
    """Moment of inertia of solid bodies.

    Args:
        body: Each body in quotes, for example "disc diameter=200mm length=20mm density=7850kg/m^3".
        lang: Language of the texts: `en` or `de`.

    Returns:
        The record, as `--json` has it, as typed objects; units as `antrieb.answers` states.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: answers.Inertia = ask(
        lambda: answers.Inertia,
        "inertia",
        (),
        [("body", body)],
        lang,
    )
    return answer


@called
def curve(
    code: str,
    *,
    lang: Lang = "en",
    voltage: str | None = None,
) -> answers.Curves:
    """Curves of the torque-speed plane.

    Args:
        code: Ordering code.
        lang: Language of the texts: `en` or `de`.
        voltage: Motor terminal voltage, rms, for example "220 V"; default: the range of the manufacturer's data.

    Returns:
        The record, as `--json` has it, as typed objects; units as `antrieb.answers` states.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: answers.Curves = ask(
        lambda: answers.Curves,
        "curve",
        (),
        [("code", code), ("voltage", voltage)],
        lang,
    )
    return answer


@called
def plot(
    text: Text,
    figure: Literal["torque_speed", "cycle", "utilisation", "torsion", "bearing_load", "candidate_map"],
    code: str | None = None,
    *,
    lang: Lang = "en",
    axis: str | None = None,
    by: Literal["mass", "length"] = "mass",
    theme: Literal["light", "dark"] = "light",
    width: str | None = None,
    height: str | None = None,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> Picture:
    """Diagram of an axis with an actuator, as SVG or PNG.

    Args:
        text: The project as text, or the path of its file.
        figure: Picture.
        code: Ordering code; default: the project's own [actuator], otherwise the best of the catalogue.
        lang: Language of the texts: `en` or `de`.
        axis: Only this axis of a project with several.
        by: Abscissa of candidate_map.
        theme: Colours of the picture.
        width: Width of the picture, for example "160 mm"; default: by its content.
        height: Height of the picture, for example "100 mm"; increased if the content requires it.
        file: What a text is called in faults.
        folder: Where the recordings that a text names lie; without it the current folder.
        deadline: How long the answer may take, such as `60 s`; without it what would take long is refused.
        memory: How much memory the recordings may take, such as `1 GiB`.

    Returns:
        The picture.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: Picture = ask(
        lambda: object,
        "plot",
        (text,),
        [("axis", axis), ("code", code), ("figure", figure), ("by", by), ("theme", theme), ("width", width), ("height", height)],
        lang,
        file=file,
        folder=folder,
        deadline=deadline,
        memory=memory,
    )
    return answer


@overload
def bearing(
    text: BaseAxis,
    *,
    lang: Lang = "en",
    axis: str | None = None,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Bearings: ...


@overload
def bearing(
    text: BaseProject | Sequence[BaseAxis],
    *,
    lang: Lang = "en",
    axis: None = None,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.AxesOfBearings: ...


@overload
def bearing(
    text: Text,
    *,
    lang: Lang = "en",
    axis: str,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Bearings: ...


@overload
def bearing(
    text: Text,
    *,
    lang: Lang = "en",
    axis: None = None,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Bearings | answers.AxesOfBearings: ...


@called
def bearing(
    text: Text,
    *,
    lang: Lang = "en",
    axis: str | None = None,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Bearings | answers.AxesOfBearings:
    """Output bearing of every size under the loads of a project.

    Args:
        text: The project as text, or the path of its file.
        lang: Language of the texts: `en` or `de`.
        axis: Only this axis of a project with several.
        file: What a text is called in faults.
        folder: Where the recordings that a text names lie; without it the current folder.
        deadline: How long the answer may take, such as `60 s`; without it what would take long is refused.
        memory: How much memory the recordings may take, such as `1 GiB`.

    Returns:
        The record, as `--json` has it, as typed objects; units as `antrieb.answers` states.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: answers.Bearings | answers.AxesOfBearings = ask(
        lambda: answers.Bearings | answers.AxesOfBearings,
        "bearing",
        (text,),
        [("axis", axis)],
        lang,
        file=file,
        folder=folder,
        deadline=deadline,
        memory=memory,
    )
    return answer


@called
def moves(
    text: Text,
    *,
    lang: Lang = "en",
    axis: str | None = None,
    every: str | None = None,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Motion:
    """Motion of an axis, every segment with the derived quantities.

    Args:
        text: The project as text, or the path of its file.
        lang: Language of the texts: `en` or `de`.
        axis: Only this axis of a project with several.
        every: Setpoints at the cycle of a controller, for example "2 ms": time, position, speed, acceleration in the units of the axis.
        file: What a text is called in faults.
        folder: Where the recordings that a text names lie; without it the current folder.
        deadline: How long the answer may take, such as `60 s`; without it what would take long is refused.
        memory: How much memory the recordings may take, such as `1 GiB`.

    Returns:
        The record, as `--json` has it, as typed objects; units as `antrieb.answers` states.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: answers.Motion = ask(
        lambda: answers.Motion,
        "moves",
        (text,),
        [("axis", axis), ("every", every)],
        lang,
        file=file,
        folder=folder,
        deadline=deadline,
        memory=memory,
    )
    return answer


@called
def battery(
    hours_per_day: str | float,
    *,
    lang: Lang = "en",
    storage: str | None = None,
) -> answers.Battery:
    """Battery life of a buffered encoder.

    Args:
        hours_per_day: Hours of operation per day, 0 to 24.
        lang: Language of the texts: `en` or `de`.
        storage: Storage before operation, for example "1 a"; default: none.

    Returns:
        The record, as `--json` has it, as typed objects; units as `antrieb.answers` states.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: answers.Battery = ask(
        lambda: answers.Battery,
        "battery",
        (),
        [("hours-per-day", hours_per_day), ("storage", storage)],
        lang,
    )
    return answer


@called
def mount(
    code: str,
    *,
    lang: Lang = "en",
    bore: str | None = None,
    bore_load: str | None = None,
    bore_housing: str | None = None,
) -> answers.Mount:
    """Mounting of an actuator: fits, screws and their utilisation, mass.

    Args:
        code: Ordering code.
        lang: Language of the texts: `en` or `de`.
        bore: Bore for both pilots: a tolerance zone such as K7, or limit deviations such as "+12/-3 µm"; default: H7, as recommended in the manual.
        bore_load: Bore of the load, if different.
        bore_housing: Bore of the machine, if different.

    Returns:
        The record, as `--json` has it, as typed objects; units as `antrieb.answers` states.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: answers.Mount = ask(
        lambda: answers.Mount,
        "mount",
        (),
        [("code", code), ("bore", bore), ("bore-load", bore_load), ("bore-housing", bore_housing)],
        lang,
    )
    return answer


@called
def mount_project(
    text: Text,
    code: str,
    *,
    lang: Lang = "en",
    bore: str | None = None,
    bore_load: str | None = None,
    bore_housing: str | None = None,
    axis: str | None = None,
    file: str | None = None,
    folder: Path | None = None,
    deadline: TimeLimit | None = None,
    memory: str | None = None,
) -> answers.Mount:
    """Mounting of an actuator with the torques and loads of a project.

    Args:
        text: The project as text, or the path of its file.
        code: Ordering code.
        lang: Language of the texts: `en` or `de`.
        bore: Bore for both pilots: a tolerance zone such as K7, or limit deviations such as "+12/-3 µm"; default: H7, as recommended in the manual.
        bore_load: Bore of the load, if different.
        bore_housing: Bore of the machine, if different.
        axis: Only this axis of a project with several.
        file: What a text is called in faults.
        folder: Where the recordings that a text names lie; without it the current folder.
        deadline: How long the answer may take, such as `60 s`; without it what would take long is refused.
        memory: How much memory the recordings may take, such as `1 GiB`.

    Returns:
        The record, as `--json` has it, as typed objects; units as `antrieb.answers` states.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: answers.Mount = ask(
        lambda: answers.Mount,
        "mount --project",
        (text,),
        [("code", code), ("bore", bore), ("bore-load", bore_load), ("bore-housing", bore_housing), ("axis", axis)],
        lang,
        file=file,
        folder=folder,
        deadline=deadline,
        memory=memory,
    )
    return answer


@called
def upkeep(
    code: str,
    delivered: str | Day,
    *,
    lang: Lang = "en",
    storage: str | None = None,
    hours_per_day: str | float | None = None,
    inspect: str | None = None,
    today: str | Day | None = None,
) -> answers.Upkeep:
    """Maintenance plan with dates, from storage to disposal.

    Args:
        code: Ordering code.
        delivered: Date of delivery, for example 2026-03-01.
        lang: Language of the texts: `en` or `de`.
        storage: Storage before operation: a time such as "1 a" or "6 months", or the date on which it ends.
        hours_per_day: Hours of operation per day, 0 to 24, for the encoder battery.
        inspect: Interval for work the manual calls for regularly, such as "6 months"; default: one year, listed as assumed.
        today: Reference date: marks overdue dates and the next date of each series.

    Returns:
        The record, as `--json` has it, as typed objects; units as `antrieb.answers` states.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: answers.Upkeep = ask(
        lambda: answers.Upkeep,
        "upkeep",
        (),
        [("code", code), ("delivered", delivered), ("storage", storage), ("hours-per-day", hours_per_day), ("inspect", inspect), ("today", today)],
        lang,
    )
    return answer


@called
def upkeep_ical(
    code: str,
    delivered: str | Day,
    *,
    lang: Lang = "en",
    storage: str | None = None,
    hours_per_day: str | float | None = None,
    inspect: str | None = None,
    today: str | Day | None = None,
    name: str | None = None,
) -> str:
    """The maintenance plan as iCalendar.

    Args:
        code: Ordering code.
        delivered: Date of delivery, for example 2026-03-01.
        lang: Language of the texts: `en` or `de`.
        storage: Storage before operation: a time such as "1 a" or "6 months", or the date on which it ends.
        hours_per_day: Hours of operation per day, 0 to 24, for the encoder battery.
        inspect: Interval for work the manual calls for regularly, such as "6 months"; default: one year, listed as assumed.
        today: Reference date: marks overdue dates and the next date of each series.
        name: Name of the actuator in the calendar, to distinguish actuators with the same ordering code.

    Returns:
        The text of the file.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: str = ask(
        lambda: object,
        "upkeep --ical",
        (),
        [("code", code), ("delivered", delivered), ("storage", storage), ("hours-per-day", hours_per_day), ("inspect", inspect), ("today", today), ("name", name)],
        lang,
    )
    return answer


@called
def new(
    kind: Literal["manual", "table", "arm", "screw", "belt", "recording", "load", "turntable", "conveyor", "slider_crank", "joint", "hoist", "winder", "unwinder", "scissor_lift", "four_bar", "sweep", "catalogue"],
    *,
    lang: Lang = "en",
    example: bool = False,
    format: Literal["toml", "csv"] | None = None,
    key: str | Sequence[str] | None = None,
    by: Literal["sobol", "lhs", "grid"] = "sobol",
    samples: int = 100,
    seed: int = 1,
) -> str:
    """Create a commented project file to fill in.

    Args:
        kind: Kind of the file.
        lang: Language of the texts: `en` or `de`.
        example: An example of a machine with all that it may have, instead of the plain file.
        format: Format of a catalogue file: toml (default) or csv; by the ending of the file that is written.
        key: For `new sweep`: a key with its range or values, "motion[1].time [s] = 1..3 log"; may be repeated.
        by: For `new sweep`: sampling method (sobol).
        samples: For `new sweep`: number of sampled rows, or steps per range of a grid (100). 1 to 1000000.
        seed: For `new sweep`: seed of the samples (1).

    Returns:
        The text of the file.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: str = ask(
        lambda: object,
        "new",
        (),
        [("kind", kind), ("example", flag("example", example)), ("format", format), ("key", key), ("by", by), ("samples", samples), ("seed", seed)],
        lang,
    )
    return answer


@called
def glossary(
    term: str | None = None,
    *,
    lang: Lang = "en",
) -> answers.Glossary:
    """Terms and symbols with their definitions, in both languages.

    Args:
        term: Symbol, identifier or term, for example T_rms; default: all.
        lang: Language of the texts: `en` or `de`.

    Returns:
        The record, as `--json` has it, as typed objects; units as `antrieb.answers` states.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: answers.Glossary = ask(
        lambda: answers.Glossary,
        "glossary",
        (),
        [("term", term)],
        lang,
    )
    return answer


@called
def units(
    quantity: str | None = None,
    *,
    lang: Lang = "en",
) -> answers.Units2:
    """Accepted units with all spellings and their value in SI.

    Args:
        quantity: Quantity or unit, for example torque or rpm; default: all.
        lang: Language of the texts: `en` or `de`.

    Returns:
        The record, as `--json` has it, as typed objects; units as `antrieb.answers` states.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: answers.Units2 = ask(
        lambda: answers.Units2,
        "units",
        (),
        [("quantity", quantity)],
        lang,
    )
    return answer


@called
def licences(
    *,
    lang: Lang = "en",
) -> answers.Licences:
    """Licences of antrieb and of all components included, fonts too.

    Args:
        lang: Language of the texts: `en` or `de`.

    Returns:
        The record, as `--json` has it, as typed objects; units as `antrieb.answers` states.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: answers.Licences = ask(
        lambda: answers.Licences,
        "licences",
        (),
        [],
        lang,
    )
    return answer


@called
def schema(
    *,
    lang: Lang = "en",
    answers: bool = False,
) -> dict[str, object]:
    """JSON Schema of the project file, or of the answers.

    Args:
        lang: Language of the texts: `en` or `de`.
        answers: Output of --json for each command.

    Returns:
        JSON as Python has it.

    Raises:
        AntriebError: Every fault of the call.
    """
    answer: dict[str, object] = ask(
        lambda: dict[str, object],
        "schema",
        (),
        [("answers", flag("answers", answers))],
        lang,
    )
    return answer


code = code_parse
catalogue = catalogue_export

# A call of each command that runs; the tests put it to the function too.
_EXAMPLES = {
    "size": "size axis.toml --top 5",
    "check": "check axis.toml --code CHA-25A-50-H-C1024",
    "sweep": "sweep axis.toml --table tasks.parquet --out best.parquet",
    "explain": "explain axis.toml --code CHA-25A-50-H-C1024 --check continuous_torque",
    "simulate": "simulate axis.toml --code CHA-25A-50-H-C1024 --scenario emergency_stop",
    "identify": "identify run.csv axis.toml --code CHA-25A-50-H-C1024",
    "report": "report axis.toml --out axis.pdf",
    "compare": "compare axis.toml --code CHA-25A-50-H-C1024 --code CHA-32A-50-H-C1024",
    "diff": "diff before.toml after.toml",
    "export": "export axis.toml --out axis.xlsx",
    "code_parse": "code parse CHA-20A-100-H-C1024-B",
    "code_list": "code list CHA-20A-*-H --available",
    "code_complete": "code complete CHA-14A-100-N",
    "data": "data CHA-20A-100-H-C1024",
    "wiring": "wiring CHA-25A-100-H-M512P-B --check pins.csv",
    "encoder": "encoder CHA-25A-100-H-M512P --angle \"12.5 deg\" --turn 3",
    "errata": "errata CHA-25A-50-H-M512P",
    "catalogue_export": "catalogue export --format csv",
    "catalogue_check": "catalogue check examples/catalogue/stock.csv",
    "torsion": "torsion CHA-20A-100-H-C1024 --torque \"60 N m\"",
    "commission": "commission CHA-25A-100-H-M512P-B --for sinamics",
    "inertia": "inertia \"disc diameter=200mm length=20mm density=7850kg/m^3\"",
    "curve": "curve CHA-20A-100-H-C1024 --voltage \"220 V\"",
    "plot": "plot axis.toml --figure torque_speed --svg plane.svg",
    "bearing": "bearing axis.toml",
    "moves": "moves axis.toml --every 2ms --out setpoints.csv",
    "battery": "battery --hours-per-day 10",
    "mount": "mount CHA-25A-100-H-M512P-B --bore K7",
    "upkeep": "upkeep CHA-14A-50-E-M128S --delivered 2026-03-01 --storage \"6 months\" --hours-per-day 10",
    "new": "new arm --out axis.toml",
    "glossary": "glossary T_rms",
    "units": "units torque",
    "licences": "licences",
    "schema": "schema",
}

__all__ = [
    "battery",
    "bearing",
    "catalogue",
    "catalogue_check",
    "catalogue_export",
    "check",
    "code",
    "code_complete",
    "code_list",
    "code_parse",
    "commission",
    "commission_blank",
    "commission_checklist",
    "commission_out",
    "commission_record",
    "compare",
    "curve",
    "data",
    "diff",
    "encoder",
    "encoder_vcd",
    "errata",
    "explain",
    "export",
    "glossary",
    "identify",
    "inertia",
    "licences",
    "mount",
    "mount_project",
    "moves",
    "new",
    "plot",
    "report",
    "schema",
    "simulate",
    "size",
    "torsion",
    "units",
    "upkeep",
    "upkeep_ical",
    "wiring",
    "wiring_check",
]
