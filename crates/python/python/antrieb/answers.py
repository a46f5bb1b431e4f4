"""The answers of antrieb as typed objects.

This file is written from the schema of the answers by `cargo xtask snapshots`; do not edit it. A number is `None` where it is
not finite, a field that an answer leaves out is `None`. The unit of a figure ends its name (`mass_kg`), stands in the field
`unit` beside it, or in the `units` of its record by the name of the field.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal



@dataclass(frozen=True, slots=True, kw_only=True)
class Sizing:
    """`size`: the catalogue judged for an axis."""

    axis: str
    """Name of the axis."""
    verdict: Fit
    """The verdict on the best, the project's own included."""
    answer: str | None = None
    """The best ordering code; `null` if none fits."""
    judged: int
    """How many actuators of the catalogue were judged."""
    fit: int
    """How many of them fit within every limit, verdict `fits`."""
    fit_if_estimate: int
    """How many others fit if an estimate holds, verdict `fits_if_estimate`."""
    fitting: int
    """The sum of both."""
    rule: str
    """What the ranking goes by, in words."""
    ranking: list[Ranked]
    """The best that fit, in the requested number."""
    rejected: list[Rejection]
    """Those that do not fit, by what they miss by."""
    nearest_miss: str | None = None
    """Of those that do not fit the one that misses by least, among those that meet every requirement and are of the right class of
voltage and place; `null` where there is none."""
    own: Assessed | None = None
    """The project's own actuator."""
    would_fit_with: list[WouldFit] | None = None
    """Where nothing fits: values of the gearing with which an actuator would, one change at a time."""
    assumptions: list[str]
    """What was assumed, in words."""
    stage: Stage | None = None
    """The stage between actuator and mechanism; only where the project has one."""
    motion: Motion
    """The motion as it came out."""

    @property
    def axes(self) -> list[Sizing]:
        """It as the answer of its only axis, as `AxesOfSizing` has those of several."""
        return [self]


@dataclass(frozen=True, slots=True, kw_only=True)
class Ranked:
    """An actuator that fits, with its place."""

    code: str | None = None
    """Ordering code, of an actuator of the catalogue."""
    name: str | None = None
    """Name, of the project's own actuator."""
    verdict: Fit
    """The verdict on it."""
    utilisation: float | None
    """Utilisation of the governing check; 1 is the limit. `null` where it fails at a limit of zero or outside a range."""
    tightest: CheckId | None = None
    """Id of the governing check: the failing one that is exceeded most; where none fails, the one with the highest utilisation.
`null` if no check has a limit."""
    mass_kg: float | None = None
    """Mass in kg, the larger one where the print is in doubt."""
    on_request: list[str]
    """Names of the fields of the code that are on request only."""
    demand: Demand | None = None
    """Demand on the actuator; `null` without J_out."""
    checks: list[Check]
    """Every check, in a fixed order."""
    objections: list[str]
    """Requirements not met and rules broken, in words."""
    open_questions: int
    """How many questions could not be answered for want of a datum: checks without a value, and requirements left open."""
    tolerance: Tolerance | None = None
    """What the tolerances mean; only where the project has some."""
    rank: int
    """Its place, from 1."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Demand:
    """The demand; where the manual's equations describe the axis, their figures with the exact integrals beside them."""

    mode: DemandMode
    """`integral` where the manual's equations do not describe the axis: then the figures are those of the integrals, and
the three torques, `moves` and `integral` are left out."""
    T_rms: float | None
    """Effective torque in Nm."""
    T_peak: float | None
    """Largest torque in Nm."""
    n_av: float | None
    """Mean speed in 1/min."""
    n_peak: float | None
    """Largest speed in 1/min."""
    ED: float | None
    """Share of the cycle in which the axis moves, in %."""
    T_1: float | None = None
    """While accelerating."""
    T_2: float | None = None
    """While running."""
    T_3: float | None = None
    """While braking."""
    units: Units
    """The units of the figures."""
    moves: list[MoveTorques] | None = None
    """With several moves only: the torques of each."""
    governing_move: int | None = None
    """With several moves only: number of the move with the largest torque, from 1."""
    integral: IntegralDemand | None = None
    """The same figures by exact integration; checks use these."""


@dataclass(frozen=True, slots=True, kw_only=True)
class MoveTorques:
    """The three torques of a move of the manual's form, in its direction, in Nm."""

    T_1: float | None
    """While accelerating."""
    T_2: float | None
    """While running."""
    T_3: float | None
    """While braking."""


@dataclass(frozen=True, slots=True, kw_only=True)
class IntegralDemand:
    """The figures by exact integration."""

    T_rms: float | None
    """Effective torque in Nm."""
    T_peak: float | None
    """Largest torque in Nm."""
    n_av: float | None
    """Mean speed in 1/min."""
    n_peak: float | None
    """Largest speed in 1/min."""
    ED: float | None
    """Share of the cycle in which the axis moves, in %."""
    mode: DemandMode
    """Always `integral`."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Check:
    """The answer of one check."""

    id: CheckId
    """Which check."""
    title: str
    """Its name in words."""
    verdict: Verdict
    """What came out. `advice` also means: inside the band of an estimate."""
    value: float | None = None
    """What the axis asks; with `not_checked` it may still be there, when only the limit is missing."""
    limit: float | None = None
    """What the actuator gives or the project asks."""
    unit: str | None = None
    """Unit of both: `Nm` `1/min` `A` `V` `W` `kgm^2` `N` `mm` `h` `a` `deg` `arcmin` `arcsec` `rev` `Hz` `degC` `1`."""
    direction: Direction
    """How the value must lie to the limit."""
    part: Part
    """The part of the actuator that it is about."""
    utilisation: float | None = None
    """Value/limit for `at_most`, limit/value for `at_least`; `null` where it makes no sense."""
    margin: bool
    """Whether the ranking looks at that utilisation: not of a recommendation nor of a class that is met or not."""
    at: float | None = None
    """Instant of the worst case within the cycle, in s."""
    grade: Grade | None = None
    """How far the figures can be trusted: the worst of all that went in."""
    source: str | None = None
    """Source of the limit, then of the value, joined by `; `."""
    sources: list[str]
    """The same sources, each by itself."""
    missing: str | None = None
    """Symbol of the datum that is missing, or the key of the project that would give the limit."""
    notes: list[str]
    """Remarks, in words."""
    errata: list[str] | None = None
    """Only where a value or limit rests on one: the ids of the errata, whose evidence stands in `notes`."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Tolerance:
    """What the tolerances of the project mean for an actuator."""

    samples: int
    """How many samples were drawn."""
    seed: int
    """With which seed."""
    distribution: str
    """Always `uniform`."""
    passes: int
    """Samples with which nothing speaks against the actuator."""
    impossible: int
    """Samples with which there is no axis; none of them passes."""
    share: float | None
    """Share of the samples that pass."""
    interval: list[float | None]
    """Its 95 % interval, low and high."""
    utilisation: Quantiles
    """The highest utilisation over the samples."""
    worst_corner: WorstCorner
    """The worst that was found."""
    influence: list[Influence]
    """What the utilisation hangs on, the largest share first; empty where it does not vary."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Quantiles:
    """Quantiles of the highest utilisation; `null` where it is infinite."""

    p05: float | None
    """5 %."""
    p50: float | None
    """50 %."""
    p95: float | None
    """95 %."""
    max: float | None
    """The largest."""


@dataclass(frozen=True, slots=True, kw_only=True)
class WorstCorner:
    """The worst point within the tolerances."""

    verdict: Fit
    """Whether the actuator fits there."""
    utilisation: float | None
    """Its highest utilisation there."""
    check: CheckId | None = None
    """The failing check that is exceeded most, else the tightest."""
    values: list[ToleratedValue]
    """The value of each quantity there."""
    is_corner: bool
    """`false`: a sample inside the bands is worse than every corner, and this is the sample."""
    exhaustive: bool
    """`true`: every corner was looked at; `false`: more than ten quantities, the corner was searched."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ToleratedValue:
    """A quantity with a tolerance at some point."""

    quantity: str
    """Its key."""
    value: float | None
    """Its value."""
    unit: str
    """The unit, as written."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Influence:
    """How much a quantity moves the utilisation."""

    quantity: str
    """Its key."""
    share: float | None
    """Share of the explained variance."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Rejection:
    """Why a candidate is rejected, in short."""

    code: str
    """Its ordering code."""
    check: CheckId | None = None
    """Id of the governing check: the failing one that is exceeded most; `null` where only objections speak against it."""
    value: float | None = None
    """Value of that check."""
    limit: float | None = None
    """Its limit."""
    unit: str | None = None
    """Unit of both."""
    utilisation: float | None = None
    """Its utilisation; `null` where the limit is zero or a range."""
    failing: list[CheckId]
    """Ids of all failing checks, in the order of the checks."""
    objections: list[str]
    """Requirements not met and rules broken, in words."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Assessed:
    """An actuator with what the tolerances of the project mean for it."""

    code: str | None = None
    """Ordering code, of an actuator of the catalogue."""
    name: str | None = None
    """Name, of the project's own actuator."""
    verdict: Fit
    """The verdict on it."""
    utilisation: float | None
    """Utilisation of the governing check; 1 is the limit. `null` where it fails at a limit of zero or outside a range."""
    tightest: CheckId | None = None
    """Id of the governing check: the failing one that is exceeded most; where none fails, the one with the highest utilisation.
`null` if no check has a limit."""
    mass_kg: float | None = None
    """Mass in kg, the larger one where the print is in doubt."""
    on_request: list[str]
    """Names of the fields of the code that are on request only."""
    demand: Demand | None = None
    """Demand on the actuator; `null` without J_out."""
    checks: list[Check]
    """Every check, in a fixed order."""
    objections: list[str]
    """Requirements not met and rules broken, in words."""
    open_questions: int
    """How many questions could not be answered for want of a datum: checks without a value, and requirements left open."""
    tolerance: Tolerance | None = None
    """What the tolerances mean; only where the project has some."""


@dataclass(frozen=True, slots=True, kw_only=True)
class WouldFit:
    """A value with which an actuator would fit."""

    key: str
    """The key of the project."""
    stated: bool
    """Whether the project states it; else it would be added."""
    value: float | None
    """The value of three digits nearest to the stated one with which an actuator fits."""
    unit: str
    """Its unit; `1` for a ratio."""
    code: str
    """The best ordering code with it."""
    verdict: Fit
    """The verdict on it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Stage:
    """The stage between actuator and mechanism."""

    ratio: float | None
    """Its ratio."""
    ratios: list[StageRatio]
    """What each ratio of the project would give."""


@dataclass(frozen=True, slots=True, kw_only=True)
class StageRatio:
    """What a ratio of the stage would give."""

    ratio: float | None
    """The ratio."""
    answer: str | None = None
    """The best ordering code with it; `null` if none fits."""
    utilisation: float | None
    """Utilisation of the governing check of the best, or of the nearest miss."""
    fitting: int
    """How many fit, if only by an estimate."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Motion:
    """The motion: every segment with what was given and what followed from it."""

    units: Units
    """Units of time, distance, speed and acceleration; those of a linear axis are linear."""
    segments: list[Segment]
    """The segments in their order."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Segment:
    """One segment."""

    law: str
    """Id of the law of motion."""
    name: str
    """The law in words."""
    start: float | None
    """When it begins."""
    duration: float | None
    """How long it takes."""
    distance: float | None = None
    """The way travelled, with its sign; left out for a dwell."""
    speed: float | None = None
    """The largest speed."""
    acceleration: float | None = None
    """The largest acceleration."""
    recording: Recording | None = None
    """What was read from the file; only of a recorded segment."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Recording:
    """What was read from the file of a recorded segment."""

    file: str
    """Its name as the project has it."""
    encoding: TextEncoding | None = None
    """How its text was read; `null` of a format that is no text."""
    samples: int
    """How many samples are used."""
    first_time: float | None
    """The time that the first of them had in the file, in s."""
    left_out_before: int
    """How many samples before the cut were left out."""
    left_out_after: int
    """How many samples after the cut were left out."""
    columns: list[RecordedColumn]
    """The columns that were read."""
    unused: list[str]
    """Names of columns that hold a quantity by name or unit, and are not used."""


@dataclass(frozen=True, slots=True, kw_only=True)
class RecordedColumn:
    """A column of a recording."""

    role: ColumnRole
    """What it is."""
    name: str
    """What it is called in the file."""
    unit: str
    """Its unit."""
    unit_by: UnitBy
    """Source of the unit."""


@dataclass(frozen=True, slots=True, kw_only=True)
class AxesOfSizing:
    """The answers of several axes."""

    verdict: Fit
    """The worst verdict of the axes."""
    axes: list[Sizing]
    """The answer of each axis."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Judgement:
    """`check`: one actuator, every check with its margin."""

    code: str | None = None
    """Ordering code, of an actuator of the catalogue."""
    name: str | None = None
    """Name, of the project's own actuator."""
    verdict: Fit
    """The verdict on it."""
    utilisation: float | None
    """Utilisation of the governing check; 1 is the limit. `null` where it fails at a limit of zero or outside a range."""
    tightest: CheckId | None = None
    """Id of the governing check: the failing one that is exceeded most; where none fails, the one with the highest utilisation.
`null` if no check has a limit."""
    mass_kg: float | None = None
    """Mass in kg, the larger one where the print is in doubt."""
    on_request: list[str]
    """Names of the fields of the code that are on request only."""
    demand: Demand | None = None
    """Demand on the actuator; `null` without J_out."""
    checks: list[Check]
    """Every check, in a fixed order."""
    objections: list[str]
    """Requirements not met and rules broken, in words."""
    open_questions: int
    """How many questions could not be answered for want of a datum: checks without a value, and requirements left open."""
    axis: str
    """Name of the axis."""
    motion: Motion
    """The motion as it came out."""
    reserve: Reserve
    """How far one thing may be changed."""
    tolerance: Tolerance | None = None
    """What the tolerances of the project mean; only where it has some."""
    assumptions: list[str]
    """What was assumed, in words."""

    @property
    def axes(self) -> list[Judgement]:
        """It as the answer of its only axis, as `AxesOfJudgement` has those of several."""
        return [self]


@dataclass(frozen=True, slots=True, kw_only=True)
class Reserve:
    """How far one thing may be changed, all others as they are, with the actuator still fitting (or with which it would fit);
`null` where nothing within reach fits or everything does. Each value has four digits and is judged as it stands: with it no
check fails, one step of the last digit further one does. The search walks in steps of 10 %, temperatures in steps of 5 K; a
gap between two regions that fit is passed over where it is narrower."""

    limits: list[NeededLimit] | None = None
    """Only limits of the project keep the actuator out, and these values of their keys, rounded to four digits on the side
that suffices, all together would let it in."""
    load_factor: float | None = None
    """On all masses and inertias."""
    payload_factor: float | None = None
    """On the payloads of the segments."""
    cycle_time: float | None = None
    """The whole motion run through faster or slower."""
    ambient: float | None = None
    """The ambient temperature."""
    units: Units
    """Units of the latter two."""
    if_estimate: list[str]
    """The fields above with whose value it fits only if an estimate holds, `fits_if_estimate`."""
    not_sought: NotSought | None = None
    """What was not sought because of what it costs; `null` where everything was."""


@dataclass(frozen=True, slots=True, kw_only=True)
class NeededLimit:
    """A limit of the project that would have to be another."""

    key: str
    """Its key."""
    value: float | None
    """The value that suffices."""
    unit: str
    """Its unit."""


@dataclass(frozen=True, slots=True, kw_only=True)
class NotSought:
    """Changes that were not sought: each step of the search would find the load of a long recording anew."""

    quantities: list[str]
    """The fields beside this one that are `null` for it."""
    samples: int
    """Work of each search step: recorded samples whose load is found anew, with a quarter of the instants of motion laws and of the
loads on the flange."""
    most: int
    """Largest such work without `--deadline`."""
    text: str
    """The same in words."""


@dataclass(frozen=True, slots=True, kw_only=True)
class AxesOfJudgement:
    """The answers of several axes."""

    verdict: Fit
    """The worst verdict of the axes."""
    axes: list[Judgement]
    """The answer of each axis."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SweepSummary:
    """What the rows of a table were answered with."""

    file: str | None = None
    """The file of the answers; `null` where there is none."""
    rows: int
    """Rows of the table."""
    fit: int
    """Rows for which an actuator fits within every limit."""
    fit_if_estimate: int
    """Rows for which one fits only if an estimate holds."""
    fitting: int
    """The sum of both."""
    none_fits: list[MissedBy]
    """Rows for which none fits, by the governing check of the nearest miss, most first."""
    not_judged: list[NotJudged]
    """Rows that are not judged, by the reason, most first."""
    further: int
    """Rows with further reasons."""
    answers: list[SweepRow]
    """The answers of the rows; empty where a file holds them."""


@dataclass(frozen=True, slots=True, kw_only=True)
class MissedBy:
    """Rows that miss by a check."""

    check: str | None = None
    """The check; `null` where no actuator is of the required class."""
    title: str
    """In words."""
    rows: int
    """How many rows."""


@dataclass(frozen=True, slots=True, kw_only=True)
class NotJudged:
    """Rows that are not judged for a reason."""

    message: str
    """The reason."""
    rows: int
    """How many rows."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SweepRow:
    """The answer of a row."""

    row: int
    """The row, from 0."""
    fit: int | None = None
    """How many codes fit within every limit."""
    fit_if_estimate: int | None = None
    """How many others fit if an estimate holds."""
    code: str | None = None
    """The best of both."""
    utilisation: float | None = None
    """Utilisation of its governing check; where none fits that of the nearest miss."""
    tightest: str | None = None
    """That check."""
    error: str | None = None
    """Why the row is not judged."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Explanations:
    """`explain`: the checks of an actuator with their derivations."""

    axis: str
    """Name of the axis."""
    code: str
    """Ordering code, or name of the project's own actuator."""
    checks: list[Explained]
    """The requested checks."""
    assumptions: list[str]
    """What was assumed, in words."""

    @property
    def axes(self) -> list[Explanations]:
        """It as the answer of its only axis, as `AxesOfExplanations` has those of several."""
        return [self]


@dataclass(frozen=True, slots=True, kw_only=True)
class Explained:
    """A check with the derivation of its value and its limit."""

    id: CheckId
    """Which check."""
    title: str
    """Its name in words."""
    verdict: Verdict
    """What came out. `advice` also means: inside the band of an estimate."""
    value: float | None = None
    """What the axis asks; with `not_checked` it may still be there, when only the limit is missing."""
    limit: float | None = None
    """What the actuator gives or the project asks."""
    unit: str | None = None
    """Unit of both: `Nm` `1/min` `A` `V` `W` `kgm^2` `N` `mm` `h` `a` `deg` `arcmin` `arcsec` `rev` `Hz` `degC` `1`."""
    direction: Direction
    """How the value must lie to the limit."""
    part: Part
    """The part of the actuator that it is about."""
    utilisation: float | None = None
    """Value/limit for `at_most`, limit/value for `at_least`; `null` where it makes no sense."""
    margin: bool
    """Whether the ranking looks at that utilisation: not of a recommendation nor of a class that is met or not."""
    at: float | None = None
    """Instant of the worst case within the cycle, in s."""
    grade: Grade | None = None
    """How far the figures can be trusted: the worst of all that went in."""
    source: str | None = None
    """Source of the limit, then of the value, joined by `; `."""
    sources: list[str]
    """The same sources, each by itself."""
    missing: str | None = None
    """Symbol of the datum that is missing, or the key of the project that would give the limit."""
    notes: list[str]
    """Remarks, in words."""
    errata: list[str] | None = None
    """Only where a value or limit rests on one: the ids of the errata, whose evidence stands in `notes`."""
    derivation: Derivation
    """How its figures came about."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Derivation:
    """Where both sides of a check come from."""

    value: Node | None = None
    """Of what the axis asks."""
    limit: Node | None = None
    """Of what is permitted."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Node:
    """A figure and how it came about."""

    symbol: str
    """Its symbol."""
    term: str | None = None
    """What the symbol means; left out where there is no term for it."""
    formula: str | None = None
    """The formula, in symbols; left out for what was read and not computed."""
    figures: str | None = None
    """The formula with its figures put in."""
    value: float | None
    """The result."""
    unit: str
    """Its unit."""
    grade: Grade | None = None
    """How far it can be trusted; `null` for the steps of a computation, which are as good as what went in."""
    source: str
    """Where it stands: cell, equation, model or key."""
    errata: list[CitedErratum] | None = None
    """The errata that it rests on; left out where there is none."""
    repeated: bool | None = None
    """Whether it is derived above already; left out where not."""
    operands: list[Node] | None = None
    """What went in; left out where nothing did."""


@dataclass(frozen=True, slots=True, kw_only=True)
class CitedErratum:
    """An erratum that a figure rests on."""

    id: str
    """Its id."""
    evidence: str
    """What stands in print, what is used, and why."""


@dataclass(frozen=True, slots=True, kw_only=True)
class AxesOfExplanations:
    """The answers of several axes."""

    verdict: Fit
    """The worst verdict of the axes."""
    axes: list[Explanations]
    """The answer of each axis."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Simulation:
    """`simulate`: what the digital twin of an axis does."""

    axis: str
    """Name of the axis."""
    code: str
    """Ordering code, or the name of the project's own actuator."""
    scenario: ScenarioId
    """What happens."""
    title: str
    """The scenario in words."""
    at: float | None = None
    """When it happens \\[s\\]; `null`: the whole run is the scenario."""
    reaction: Reaction
    """How the drive reacts to a stop and to its own faults."""
    cycles: int
    """Cycles that are run."""
    seed: int
    """Seed of phases and noise."""
    time: float | None
    """Simulated time \\[s\\]."""
    steps: int
    """Steps of the solver."""
    step: float | None
    """One of them \\[µs\\]."""
    ambient: float | None
    """Temperature of the air \\[°C\\]."""
    start: list[float | None]
    """Temperatures of winding and housing at the start \\[°C\\]."""
    summary: Figures
    """The run in figures."""
    averaged: Figures | None = None
    """Operation over days by the mean losses of the cycle, in figures; `null` where no days are requested."""
    verdicts: list[SimulatedVerdict]
    """Figures with a limit."""
    events: list[SimulatedEvent]
    """What happened, by time."""
    encoder_failure: EncoderFailure | None = None
    """How the encoder failed; `null`: it did not."""
    comparison: list[Compared]
    """What the sizing said, what the twin shows, and why they differ; of the cycle alone."""
    loops: list[ControlLoop]
    """The loops of the control, the innermost first."""
    gains: Figures
    """The gains in use."""
    gains_by_rule: bool
    """Whether they follow from the rule; else the project states some."""
    parameters: list[ModelParameter]
    """Every parameter of the model."""
    notes: list[str]
    """What was assumed or left out, in words."""
    trace: str | None = None
    """The file that the course was written to; `null`: none."""

    @property
    def axes(self) -> list[Simulation]:
        """It as the answer of its only axis, as `AxesOfSimulation` has those of several."""
        return [self]


@dataclass(frozen=True, slots=True, kw_only=True)
class Figure:
    """A figure with its unit."""

    title: str
    """In words."""
    value: float | None = None
    """The value; `null` where there is none."""
    unit: str
    """Its unit."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SimulatedVerdict:
    """A figure with its limit."""

    id: str
    """Identifier."""
    title: str
    """In words."""
    verdict: Verdict
    """Whether the limit is kept."""
    value: float | None = None
    """The value."""
    limit: float | None = None
    """The largest permitted."""
    unit: str
    """Unit of both."""
    grade: Grade | None = None
    """How far the limit can be trusted."""
    source: str | None = None
    """Where the limit is from."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SimulatedEvent:
    """Something that happened."""

    time: float | None
    """When \\[s\\]."""
    event: EventKind
    """What."""
    title: str
    """In words."""


@dataclass(frozen=True, slots=True, kw_only=True)
class EncoderFailure:
    """An encoder that fails, and what the drive notices of it."""

    failure: str
    """What fails: a failure of the scenario, or `battery`."""
    finding: str | None = None
    """How the drive notices it; `null`: it does not."""
    after: float | None = None
    """After which time \\[ms\\]."""
    error: float | None
    """The angle that is read less the true one, at the output, when it is noticed, else at the end \\[°\\]."""
    title: str
    """The whole in words."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Compared:
    """A figure of the sizing beside that of the twin."""

    id: CheckId
    """The check of the sizing."""
    title: str
    """In words."""
    sizing: float | None
    """What the sizing said."""
    twin: float | None
    """What the twin shows."""
    unit: str
    """Unit of both."""
    why: str
    """Why they differ, in words."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ControlLoop:
    """A loop with its margins."""

    id: Loop
    """Which."""
    title: str
    """In words."""
    crossover: float | None = None
    """Frequency at which the open loop has magnitude one \\[Hz\\]."""
    phase_margin: float | None = None
    """Phase margin \\[°\\]."""
    gain_margin: float | None = None
    """Gain margin \\[dB\\]."""
    bandwidth: float | None = None
    """Frequency up to which it follows within 3 dB \\[Hz\\]."""
    stable: bool
    """Whether it is stable."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ModelParameter:
    """A parameter of the model."""

    key: str
    """Its key."""
    value: float | None = None
    """Its value; `null` where nothing is known."""
    unit: str
    """Its unit."""
    grade: Grade | None = None
    """How far it can be trusted."""
    source: str | None = None
    """Where it is from."""


@dataclass(frozen=True, slots=True, kw_only=True)
class AxesOfSimulation:
    """The answers of several axes."""

    verdict: Fit
    """The worst verdict of the axes."""
    axes: list[Simulation]
    """The answer of each axis."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Identification:
    """What a recorded run says of load and motor."""

    axis: str
    """Name of the axis."""
    code: str
    """Ordering code, or the name of the project's own actuator."""
    samples: int
    """Rows of the run."""
    estimates: list[Identified95]
    """Estimates that the run separates from each other."""
    open: list[LeftOpen]
    """Parameters without an estimate."""
    doubts: list[Doubted]
    """Signals that seem to have another unit, sign or side than their columns; while there are any, the estimates are not those of the
axis, `overrides` is empty, and the exit status is 1."""
    overrides: str
    """Lines of the project file with the measured values of actuator and load."""
    notes: list[str]
    """Method, assumptions and what is left out, in words."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Identified95:
    """An estimate with its interval."""

    id: str
    """Identifier."""
    title: str
    """In words."""
    value: float | None
    """The value."""
    half_width: float | None
    """Half the interval that holds the true value in 95 of 100 runs."""
    unit: str
    """Its unit."""
    stated: float | None = None
    """Value of project or table; `null` where they have none."""
    known: bool
    """The interval is apart from zero, and narrow enough for a line of the project."""


@dataclass(frozen=True, slots=True, kw_only=True)
class LeftOpen:
    """A parameter that a run does not determine."""

    id: str
    """Identifier."""
    title: str
    """In words."""
    reason: str
    """Reason, in words."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Doubted:
    """A signal that does not fit its column."""

    id: str
    """Identifier of the convention that the signal seems to have."""
    column: str
    """Heading of the column."""
    text: str
    """Observation and advice, in words."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Comparison:
    """`compare`: several actuators for the same axis."""

    axis: str
    """Name of the axis."""
    candidates: list[Head]
    """The actuators, in the requested order."""
    better: int | None = None
    """Index of the actuator that ranks best, from 0."""
    demand: list[DatumRow]
    """The demand on each."""
    data: list[DatumRow]
    """What each is."""
    checks: list[CheckRow]
    """Check by check."""

    @property
    def axes(self) -> list[Comparison]:
        """It as the answer of its only axis, as `AxesOfComparison` has those of several."""
        return [self]


@dataclass(frozen=True, slots=True, kw_only=True)
class Head:
    """An actuator in a comparison."""

    code: str
    """Ordering code, or name of the project's own actuator."""
    verdict: Fit
    """Whether nothing speaks against it."""
    utilisation: float | None
    """Utilisation of the governing check; 1 is the limit."""
    tightest: CheckId | None = None
    """Id of the check that it belongs to."""
    open_questions: int
    """How many questions could not be answered for want of a datum."""
    objections: list[str]
    """Requirements not met and rules broken, in words."""


@dataclass(frozen=True, slots=True, kw_only=True)
class DatumRow:
    """A figure of each actuator."""

    symbol: str
    """Its symbol."""
    unit: str
    """Its unit."""
    values: list[float | None]
    """One value for each actuator, `null` where there is none."""


@dataclass(frozen=True, slots=True, kw_only=True)
class CheckRow:
    """A check of each actuator."""

    id: CheckId
    """Which check."""
    title: str
    """Its name in words."""
    better: int | None = None
    """Index of the actuator that does better, from 0; `null` where none does."""
    answers: list[Check | None]
    """The answers, `null` where an actuator has no such check."""


@dataclass(frozen=True, slots=True, kw_only=True)
class AxesOfComparison:
    """The answers of several axes."""

    verdict: Fit
    """The worst verdict of the axes."""
    axes: list[Comparison]
    """The answer of each axis."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Difference:
    """`diff`: what another revision of a project does to an actuator."""

    axis: str
    """Name of the axis."""
    code: str
    """The actuator."""
    verdict: Fit
    """Whether it fits in the second project."""
    before: Head
    """In the first project."""
    after: Head
    """In the second project."""
    best_before: str | None = None
    """The best ordering code for the first project."""
    best_after: str | None = None
    """The best ordering code for the second project."""
    demand: list[DatumChange]
    """The demand before and after."""
    checks: list[CheckChange]
    """Check by check."""
    inputs: list[InputChange]
    """The values of the project files that differ."""

    @property
    def axes(self) -> list[Difference]:
        """It as the answer of its only axis, as `AxesOfDifference` has those of several."""
        return [self]


@dataclass(frozen=True, slots=True, kw_only=True)
class DatumChange:
    """A figure before and after."""

    symbol: str
    """Its symbol."""
    unit: str
    """Its unit."""
    before: float | None = None
    """In the first project."""
    after: float | None = None
    """In the second project."""


@dataclass(frozen=True, slots=True, kw_only=True)
class CheckChange:
    """A check before and after."""

    id: CheckId
    """Which check."""
    title: str
    """Its name in words."""
    changed: bool
    """Whether anything about it is another."""
    change: float | None = None
    """Difference of the utilisations."""
    before: Check | None = None
    """In the first project."""
    after: Check | None = None
    """In the second project."""


@dataclass(frozen=True, slots=True, kw_only=True)
class InputChange:
    """A value that differs between two project files."""

    path: str
    """Its key."""
    old: str | None = None
    """As written in the first file; `null` where it is not there."""
    new: str | None = None
    """As written in the second file; `null` where it is not there."""


@dataclass(frozen=True, slots=True, kw_only=True)
class AxesOfDifference:
    """The answers of several axes."""

    verdict: Fit
    """The worst verdict of the axes."""
    axes: list[Difference]
    """The answer of each axis."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Table:
    """`export --table`: one table of the results."""

    table: str
    """Its name."""
    title: str
    """Its title."""
    about: str
    """What it holds."""
    columns: list[TableColumn]
    """What each column means."""
    rows: list[TableRow]
    """A record for each row, by the names of the columns."""


@dataclass(frozen=True, slots=True, kw_only=True)
class TableColumn:
    """A column of a table."""

    name: str
    """Its name in the rows."""
    title: str
    """Its heading."""
    kind: ColumnKind
    """What it holds."""
    unit: str | None = None
    """Unit of its numbers; `null` for words, and where another column names the unit of each row."""
    about: str
    """What it means and where it comes from."""


@dataclass(frozen=True, slots=True, kw_only=True)
class CodeReading:
    """`code parse`: a code with every field explained."""

    valid: bool
    """Always `true`."""
    code: str
    """The canonical spelling."""
    canonical: bool
    """Whether the text was written so."""
    availability: Availability
    """Whether it can be had without asking."""
    on_request: list[str]
    """Names of the fields that are on request only."""
    fields: list[CodeField]
    """All nine fields, in their order."""
    notes: list[str]
    """What the manual's tables do not cover of it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class CodeField:
    """A field of a code."""

    field: Field
    """Which field."""
    name: str
    """Its name."""
    token: str
    """What stands there; empty where it is left out."""
    meaning: str
    """What that means."""
    span: list[int] | None = None
    """Its place in the text given, in bytes: begin, and end without it; `null` where it is left out."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ListedCode:
    """`code list`: a valid code."""

    code: str
    """The code."""
    availability: Availability
    """Whether it can be had without asking."""
    on_request: list[str]
    """Names of the fields that are on request only."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Completion:
    """`code complete`: what a partial code leaves open."""

    fields: list[OpenField]
    """Each field but series and special design."""
    codes: list[ListedCode]
    """The codes that result."""


@dataclass(frozen=True, slots=True, kw_only=True)
class OpenField:
    """A field of a partial code."""

    field: Field
    """Which field."""
    name: str
    """Its name."""
    choices: list[Choice]
    """What may stand there."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Choice:
    """What may stand at a field."""

    token: str
    """The word; empty where the field may be left out."""
    availability: Availability
    """Whether at least one code with it has this field without asking."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Sheet:
    """`data`: every printed value of an actuator."""

    code: str
    """The code."""
    notes: list[str]
    """What the tables do not cover of it, in words."""
    sections: list[SheetSection]
    """One section for each printed table, in the order of the manual."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SheetSection:
    """The values of one printed table."""

    table: str
    """Number of the table."""
    title: str
    """Its title."""
    values: list[SheetValue]
    """Its values for this code."""
    notices: list[SheetNote]
    """Notices on the table as a whole."""
    errata: list[str]
    """Ids of the errata of the table that name no single cell."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SheetValue:
    """A printed value."""

    symbol: str
    """Symbol in ASCII."""
    name: str
    """The field's word for it."""
    condition: str
    """Further distinction of the row."""
    printed: str
    """The text of the cell as printed."""
    value: TableCell
    """The value after errata in the printed unit: a number or a text; `null` where none is printed, for this code."""
    unit: str
    """The printed unit in ASCII; empty for pure numbers and texts."""
    table: str
    """Number of the table."""
    grade: Grade
    """How far it can be trusted."""
    errata: list[str]
    """Ids of the errata that touch it."""
    checks_use: float | None = None
    """The value that checks take where it is not `value`."""
    text: str | None = None
    """The value of a text in the language of the answer; `null` for a number."""
    notes: list[SheetNote]
    """Notes on the row."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SheetNote:
    """A note on a value or a table."""

    mark: str | None = None
    """The mark as printed; `null` where it has none."""
    by: NoteBy
    """Who says so."""
    text: str
    """What it says, in our words."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Wiring:
    """`wiring`: what is connected where."""

    code: str
    """The code."""
    connectors: list[Connector]
    """Its connectors."""
    cables: list[Cable]
    """The cables that the manual lists for it."""
    not_available: list[NotAvailable]
    """What there is not for this code, or not in the manual."""
    notes: list[WiringNote]
    """What the tables and their notes say besides."""
    rules: list[Fact]
    """Rules and hazards, gravest first."""
    voltage_drop: VoltageDrops | None = None
    """Voltage lost on the wires; `null` unless a length was given."""
    errata: list[str]
    """Ids of the errata that touch what is shown."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Connector:
    """A connector of the actuator."""

    role: ConnectorRole
    """What it is for."""
    type: str
    """Poles and thread as printed."""
    poles: int
    """Its poles."""
    thread: str
    """Its thread."""
    exit: ConnectorExit | None = None
    """Where it is: at the end of a cable, in the housing; `null` where that is not stated."""
    material_number: str | None = None
    """Material number of the mating coupling; `null` where none is printed."""
    outer_diameter: str | None = None
    """Outer diameter of the mating coupling as printed; `null` where none is."""
    length: str | None = None
    """Length of the mating coupling as printed; `null` where none is."""
    unit: str
    """Unit of the two."""
    pins: list[ConnectorPin]
    """Its pins; empty where they are not printed for this code."""
    ambiguous: list[AmbiguousColour]
    """Colours that several of its wires have: wire by pin."""
    tables: list[str]
    """Table of the connector, and of its pins."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ConnectorPin:
    """A pin of a connector."""

    pin: str
    """Its number, or `PE`."""
    joined_with: str | None = None
    """The pin that the print names in brackets: both belong to one wire."""
    signal: str
    """The signal as printed; `-` where nothing is connected."""
    connected: bool
    """Whether something is connected."""
    group: SignalGroup | None = None
    """Of which kind the signal is; `null` where nothing is connected."""
    colour: str | None = None
    """Colour of the wire, in the requested language; `null` if none is printed."""
    meaning: str
    """What the signal is."""
    source: str
    """The cell that prints it; of an empty field its table."""
    grade: Grade
    """How far it can be trusted."""
    errata: list[str]
    """Ids of the errata that touch it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class AmbiguousColour:
    """A colour that does not tell wires apart."""

    colour: str
    """The colour."""
    pins: list[str]
    """The pins whose wires have it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Cable:
    """A cable."""

    role: CableRole
    """What it connects."""
    material_number: str
    """Its material number."""
    length_m: float | None = None
    """Its length; `null` where the material number has it in letters of another maker."""
    length_code: str | None = None
    """The letters of the material number that stand for the length; else `null`."""
    for_: str
    """What it goes to."""
    drive: CableFor
    """The same as an id."""
    table: str
    """The table that prints it."""
    source: str
    """The cell that prints it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class NotAvailable:
    """What there is not."""

    id: str
    """Its id."""
    text: str
    """What there is not, and why."""
    table: str
    """The table that shows it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class WiringNote:
    """What a table's notes say."""

    text: str
    """What it says."""
    by: NoteBy
    """Who says so."""
    table: str | None = None
    """The table that it is about; `null`: several."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Fact:
    """A hazard, a rule or a limit, in our words."""

    id: str
    """Its id."""
    signal: Signal | None = None
    """Signal word of ISO 3864-2 and ANSI Z535.6; `null` for a plain statement."""
    step: Step | None = None
    """When it matters; `null`: always."""
    text: str
    """What it says."""
    values: list[FactValue]
    """The figures in it."""
    source: str
    """Where it stands."""
    grade: Grade
    """How far it can be trusted."""


@dataclass(frozen=True, slots=True, kw_only=True)
class FactValue:
    """A figure of a fact."""

    id: str | None = None
    """Which of several; `null` for the only one."""
    number: float | None
    """The figure."""
    unit: str
    """Its unit in ASCII; empty for pure numbers."""
    bound: Bound
    """What it bounds."""


@dataclass(frozen=True, slots=True, kw_only=True)
class VoltageDrops:
    """Voltage lost on the wires of a cable."""

    length_m: float | None
    """Length of the cable."""
    cross_section_mm2: float | None = None
    """Cross-section of a wire; `null` where none was given."""
    circuits: list[VoltageDrop]
    """The circuits."""
    assumptions: str
    """What was assumed."""
    resistivity_source: str
    """Where the resistivity of copper is from."""


@dataclass(frozen=True, slots=True, kw_only=True)
class VoltageDrop:
    """Voltage lost in one circuit, forth and back."""

    circuit: Circuit
    """Which circuit."""
    name: str
    """Its name."""
    current_a: float | None
    """Its current."""
    current_source: str
    """Where the current is from."""
    nominal_v: float | None = None
    """Voltage that the source has; `null` where none is printed."""
    least_v: float | None = None
    """Least voltage at the load; `null` where none is printed."""
    voltage_source: str
    """Where the voltages are from."""
    loss_20_degc_v: float | None = None
    """Loss at 20 °C; `null` without a cross-section."""
    loss_70_degc_v: float | None = None
    """Loss at 70 °C; `null` without a cross-section."""
    needed_v: float | None = None
    """Source voltage required for the least voltage at the load on a warm wire; `null` if not known."""
    cross_section_min_mm2: float | None = None
    """Smallest cross-section at 70 °C; `null` where no limit is printed."""
    verdict: Verdict
    """Whether it is enough."""
    reason: str
    """Why it is not, or not checked; empty where it is enough."""
    sense_lines: bool
    """Whether the connector has sense lines."""
    grade: Grade
    """How far the loss can be trusted."""


@dataclass(frozen=True, slots=True, kw_only=True)
class WiringCheck:
    """`wiring --check`: a list of pins compared with the print."""

    code: str
    """The code."""
    agrees: bool
    """Whether nothing but advice was found."""
    rows: int
    """Rows of the list."""
    agreeing: int
    """Rows that agree with the print."""
    findings: list[WiringFinding]
    """What is different, by line."""


@dataclass(frozen=True, slots=True, kw_only=True)
class WiringFinding:
    """A difference between list and print."""

    id: str
    """Its id."""
    severity: Severity
    """How grave it is."""
    connector: ConnectorRole
    """The connector."""
    line: int | None = None
    """Line of the list; `null` where it is about what is not in it."""
    pin: str | None = None
    """The pin; `null` where it is about the connector."""
    expected: str | None = None
    """The printed value; `null` if the finding is about the connector or a pin that does not exist."""
    message: str
    """What is different."""
    action: str
    """What to do."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Encoder:
    """`encoder`: what the encoders of a code send at an angle."""

    code: str
    """The code."""
    feedback: str
    """The motor feedback."""
    seed: int | None = None
    """Seed of the deviation; `null` where encoders see the true angle."""
    connector: ConnectorRole
    """Its connector."""
    type_printed: str | None = None
    """Its maker's name for it, as printed."""
    shaft: EncoderShaft
    """Its shaft."""
    words: list[EncoderWord]
    """The words that it sends; none where it has no serial interface."""
    signals: dict[str, EncoderSignal]
    """Its signals by name."""
    carrier: EncoderCarrier | None = None
    """Two periods of the excitation with the windings, while the shaft turns at its speed; `null` unless it is a resolver."""
    table_of_pins: str | None = None
    """The table of its pins."""
    output_encoder: EncoderState | None = None
    """What the encoder at the output sends, option EC; `null` without it."""
    decoded: DecodedWord | None = None
    """What `decode` reads; `null` where no word was given."""
    assumptions: list[EncoderAssumption]
    """What the manual leaves open and the simulation takes."""
    notes: list[str]
    """What is to be known about the position."""
    rules: list[Fact]
    """Rules of the manual on its direction and its battery."""
    errata: list[str]
    """Errata that concern the data."""
    trace: str | None = None
    """The file of the trace, where one was written."""


@dataclass(frozen=True, slots=True, kw_only=True)
class EncoderShaft:
    """The shaft of an encoder."""

    turns: int
    """Whole turns."""
    angle_deg: float | None
    """Angle within the turn \\[deg\\]."""
    speed_per_min: float | None
    """Speed \\[1/min\\]."""
    seen_deg: float | None
    """Angle that the encoder sees \\[deg\\]."""
    accuracy_arcsec: float | None = None
    """Largest deviation to either side \\[arcsec\\]; `null` where none is printed."""
    absolute_turns: int | None = None
    """Turns after which the absolute position begins again; `null` without one."""
    turns_valid: bool | None = None
    """Whether the count of turns can be trusted; `null` where none is sent."""
    increments: int | None = None
    """Whole steps since the zero: interpolated to 8 bit, or every edge; `null` for a resolver."""


@dataclass(frozen=True, slots=True, kw_only=True)
class EncoderWord:
    """A word."""

    name: str
    """What it is: `endat_2_2_position`, `endat_2_1_position`, `ssi_position`."""
    title: str
    """The same in words."""
    protocol: EncoderProtocol
    """Its protocol."""
    bits: str
    """Its bits in the order sent."""
    crc: str | None = None
    """Its check; `null` where it has none."""
    command: str | None = None
    """Its mode command in the order sent; `null` where none is sent."""
    fields: list[WordField]
    """Its fields in the order sent."""
    clocks_before: int
    """Clock periods of a transmission before its first bit, in a trace."""
    clock_khz: float | None
    """Clock frequency of a trace \\[kHz\\]."""
    recovery_us: list[float | None]
    """Time until data is at rest again behind the word, shortest and longest \\[us\\]."""
    calculation_us: float | None = None
    """Longest time until the position is ready \\[us\\]; `null` where none is known."""


@dataclass(frozen=True, slots=True, kw_only=True)
class WordField:
    """A field of a word."""

    name: str
    """What it is: `start`, `error_1`, `error_2`, `position`, `turns`, `step`, `head`, `value`, `crc`, or a mode command."""
    title: str
    """The same in words."""
    first: int
    """Place of its first bit, from zero."""
    bits: str
    """Its bits in the order sent."""
    value: int
    """Its value."""


@dataclass(frozen=True, slots=True, kw_only=True)
class EncoderSignal:
    """A signal."""

    meaning: str
    """What it is."""
    pins: list[EncoderPin]
    """Its pins, plus end first."""
    form: SignalForm
    """How its value is meant."""
    value: float | None = None
    """Its value; `null` where it does not follow the angle."""
    unit: str
    """Unit of the value: `V`, or `1` for a level and a part of an amplitude."""
    level_v: float | None = None
    """Nominal level peak to peak \\[V\\]; `null` where none is printed."""
    level_bounds_v: list[float | None] | None = None
    """Lowest and highest level peak to peak \\[V\\]; `null` where no tolerance is printed."""
    periods_per_turn: int | None = None
    """Periods in a turn; `null` where it does not follow the angle."""
    source: str
    """Where it stands: the table of its level or its lines."""
    curve: EncoderCurve | None = None
    """Its course over the angle; `null` where it does not follow the angle."""


@dataclass(frozen=True, slots=True, kw_only=True)
class EncoderPin:
    """A pin."""

    pin: str
    """Its number."""
    signal: str
    """The signal as printed."""


@dataclass(frozen=True, slots=True, kw_only=True)
class EncoderCurve:
    """A signal over the angle of its shaft."""

    offset_deg: list[float | None]
    """Angles from where the shaft stands \\[deg\\]."""
    value: list[float | None]
    """The values there."""


@dataclass(frozen=True, slots=True, kw_only=True)
class EncoderCarrier:
    """Voltages of a resolver over time."""

    frequency_khz: float | None
    """Frequency of the excitation \\[kHz\\]."""
    time_us: list[float | None]
    """Time \\[us\\]."""
    excitation_v: list[float | None]
    """Excitation \\[V\\]."""
    sine_v: list[float | None]
    """Sine winding \\[V\\]."""
    cosine_v: list[float | None]
    """Cosine winding \\[V\\]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class EncoderState:
    """What one encoder sends."""

    connector: ConnectorRole
    """Its connector."""
    type_printed: str | None = None
    """Its maker's name for it, as printed."""
    shaft: EncoderShaft
    """Its shaft."""
    words: list[EncoderWord]
    """The words that it sends; none where it has no serial interface."""
    signals: dict[str, EncoderSignal]
    """Its signals by name."""
    carrier: EncoderCarrier | None = None
    """Two periods of the excitation with the windings, while the shaft turns at its speed; `null` unless it is a resolver."""
    table_of_pins: str | None = None
    """The table of its pins."""


@dataclass(frozen=True, slots=True, kw_only=True)
class DecodedWord:
    """A word that was read."""

    name: str | None = None
    """What it is by its length; `null` where no word of the encoder has it."""
    title: str | None = None
    """The same in words."""
    connector: ConnectorRole | None = None
    """The connector of the encoder that sends such words."""
    bits: str
    """Its bits."""
    valid: bool
    """Whether nothing is wrong with it."""
    fields: list[WordField]
    """Its fields; none where its length is wrong."""
    turns: int | None = None
    """Turns; `null` where the word is wrong or no position."""
    angle_deg: float | None = None
    """Angle within the turn \\[deg\\]; `null` likewise."""
    encoder_error: bool | None = None
    """Whether the encoder reports an error; `null` where the word is wrong or has no error bit."""
    faults: list[WordFault]
    """What is wrong with it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class WordFault:
    """What is wrong with a word."""

    id: str
    """What: `length`, `start`, `error_bits_alike`, `crc`, `command`, `encoder_error`."""
    message: str
    """The same in words."""
    hint: str | None = None
    """What to look at."""


@dataclass(frozen=True, slots=True, kw_only=True)
class EncoderAssumption:
    """What is taken where the manual says nothing."""

    id: EncoderAssumed
    """What."""
    text: str
    """The same in words, with what it rests on."""
    grade: Grade
    """How far it can be trusted."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Errata:
    """`errata`: the requested errata."""

    about: str | None = None
    """What was asked about: a code, a table, an id; `null`: all."""
    errata: list[Erratum]
    """The errata, in the order of the data."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Erratum:
    """One erratum."""

    id: str
    """Its id."""
    table: str | None = None
    """The table concerned; `null` for one of the text."""
    cell: ErratumCell | None = None
    """The cell that it names; `null` where it is about the table or the text."""
    where: str
    """The place in words."""
    kind: ErratumKind
    """What is wrong, and with what."""
    status: ErratumStatus
    """Whether the right value is proven."""
    recovered: str | None = None
    """What the damaged text has, for kind `recovery`; else `null`."""
    printed: str
    """What stands printed."""
    corrected: str
    """What is right; equal to `printed` where the matter is open."""
    checks_use: str | None = None
    """What checks use where the safe side is not `corrected`; else `null`."""
    unit: str
    """Unit of the three; empty for texts."""
    evidence: str
    """Why, with the figures."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ErratumCell:
    """The cell that an erratum names."""

    symbol: str
    """Symbol in ASCII."""
    drive: str
    """The drive as the manual heads it; empty: all."""
    feedback: str
    """Feedback system; empty: all."""
    ratio: str
    """Reduction ratio; empty: all."""
    condition: str
    """Further distinction of the row."""


@dataclass(frozen=True, slots=True, kw_only=True)
class CatalogueCell:
    """`catalogue export`: a printed cell in long form."""

    drive: str
    """The drive as the manual heads it; empty where the cell holds for all."""
    feedback: str
    """Feedback system, several joined by ` / `; empty: every one of the drive."""
    ratio: str
    """Reduction ratio, or `> 50`; empty: printed once for all ratios."""
    symbol: str
    """Symbol in ASCII."""
    condition: str
    """Further distinction of the row."""
    printed: str
    """The text of the cell as printed."""
    value: TableCell
    """The value after errata in the printed unit: a number or a text; `null` where none is printed."""
    unit: str
    """The printed unit in ASCII; empty for pure numbers and texts."""
    table: str
    """Number of the table, or its name in another document."""
    erratum: str
    """Ids of the errata that touch it, joined by `;`."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Torsion:
    """`torsion`: the angle by which a gear yields under a torque."""

    code: str
    """Ordering code."""
    torque: float | None
    """The torque."""
    angle_rad: float | None
    """The angle in rad."""
    angle_arcmin: float | None
    """The same angle in arcmin."""
    region: int
    """Which of the three straight pieces of the curve it lies on, from 1."""
    T_1: float | None
    """End of the first piece."""
    T_2: float | None
    """End of the second piece."""
    K: list[float | None]
    """Stiffness of the three pieces."""
    hysteresis_loss: float | None = None
    """Most that is lost by hysteresis after full torque to both sides; `null` where none is printed."""
    lost_motion: float | None = None
    """Most that is lost under a few per cent of the rated torque to both sides; `null` where none is printed."""
    units: Units
    """Units of torque, stiffness and lost angles."""
    source: str
    """Where the curve is from."""


@dataclass(frozen=True, slots=True, kw_only=True)
class DriveObject:
    """An object of CiA 402 with its value."""

    index: str
    """Index: `0x6075`."""
    sub: int
    """Sub-index."""
    type: str
    """Type of CiA 301: `UNSIGNED8`, `UNSIGNED16` or `UNSIGNED32`."""
    value: int
    """The value to write."""
    unit: str
    """Unit of the value."""
    name: str
    """Name of the object in the profile."""
    exact: float | None
    """The value before it was rounded."""
    rounding: str
    """How it was rounded: `nearest` or `down`."""
    grade: Grade
    """How far it can be trusted."""
    source: str
    """Where the figures stand, then the document that names the object."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Commissioning:
    """All that is known for the commissioning of a code."""

    code: str
    """The code."""
    for_: str
    """Format of the values for the drive: `sinamics`, `plain`."""
    hazards: list[Fact]
    """Hazards and conditions, gravest first."""
    parameters: list[CommissionParameter]
    """Every value that is known."""
    gaps: list[CommissionGap]
    """Values that a drive requires and no source states, with advice."""
    sinamics: list[DriveParameter]
    """The parameters of a SINAMICS drive; empty for another form."""
    encoder: list[EncoderValue]
    """What is printed about the encoders."""
    commutation: list[str]
    """How the angle between encoder and rotor is found, step by step."""
    thresholds: list[SensorThreshold]
    """Thresholds of the temperature sensors in degrees and ohms."""
    overload: OverloadSupervision
    """What the supervision of overload is set to."""
    lists: list[CommissionList]
    """The check-lists: before power, first motion, after a day."""


@dataclass(frozen=True, slots=True, kw_only=True)
class CommissionParameter:
    """A value to enter in a drive."""

    id: str
    """Identifier."""
    symbol: str
    """Symbol in ASCII."""
    name: str
    """What it is."""
    value: float | None
    """Its value, not rounded."""
    unit: str
    """Its unit."""
    conversion: str
    """How it follows from what is printed."""
    conversion_text: str
    """The same in words."""
    grade: Grade
    """How far it can be trusted."""
    source: str
    """Where it stands."""
    errata: list[str]
    """Ids of the errata that touch it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class CommissionGap:
    """A value that a drive requires and no source states."""

    id: str
    """Identifier."""
    text: str
    """What is missing, and what to do."""


@dataclass(frozen=True, slots=True, kw_only=True)
class DriveParameter:
    """A parameter of a SINAMICS drive."""

    number: str
    """Number with the index of the motor data set: `p350[0]`."""
    value: float | None
    """Its value."""
    unit: str
    """Its unit; `1` for a pure number."""
    name: str
    """What it is."""
    conversion_text: str
    """How it follows from what is printed."""
    grade: Grade
    """How far it can be trusted."""
    source: str
    """Where the figure stands, then the document that names the parameter."""


@dataclass(frozen=True, slots=True, kw_only=True)
class EncoderValue:
    """A printed value of an encoder."""

    side: str
    """`motor` or `output`."""
    symbol: str
    """Symbol in ASCII."""
    name: str
    """What it is."""
    condition: str
    """Further distinction of the row."""
    value: TableCell
    """The value after errata: a number or a text."""
    text: str
    """The same as it is shown."""
    unit: str
    """Its unit; empty for pure numbers and texts."""
    table: str
    """Number of the table."""
    notes: list[str]
    """Notes on it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SensorThreshold:
    """A threshold of a temperature sensor."""

    sensor: str
    """`kty` or `ptc`."""
    name: str
    """What it is."""
    temperature: float | None
    """Temperature in degC, of the PTC that of the corner."""
    resistance: float | None
    """Resistance in ohm."""
    bound: str
    """`typical`, `at_most` or `at_least`."""
    grade: Grade
    """How far it can be trusted: that of the resistance."""
    source: str
    """Where both stand."""


@dataclass(frozen=True, slots=True, kw_only=True)
class OverloadSupervision:
    """What the supervision of overload is set to."""

    stall_current: float | None = None
    """Stall current in A rms, to which the overload factor refers."""
    time_constant: float | None = None
    """Time constant of the winding in s, by the model of the house; the manual states none."""
    grade: Grade
    """How far the time constant can be trusted."""
    trips: list[OverloadTrip]
    """When a first-order supervision responds, from the cold."""
    text: str
    """What this rests on, in words."""


@dataclass(frozen=True, slots=True, kw_only=True)
class OverloadTrip:
    """When the supervision of overload responds."""

    factor: float | None
    """Overload factor I/I_0."""
    time: float | None
    """Time in s."""


@dataclass(frozen=True, slots=True, kw_only=True)
class CommissionList:
    """A check-list."""

    step: Step
    """`before_power`, `first_motion` or `after_a_day`."""
    title: str
    """Its title."""
    entries: list[CommissionEntry]
    """Its lines."""


@dataclass(frozen=True, slots=True, kw_only=True)
class CommissionEntry:
    """A line of a check-list."""

    id: str
    """Identifier: of a fact, a value or a measurand."""
    signal: Signal | None = None
    """Signal word; `null` where there is none."""
    text: str
    """What is to be done, set or measured."""
    expected: float | None = None
    """What should come out; `null` for a line to tick."""
    low: float | None = None
    """Lower edge of the band."""
    high: float | None = None
    """Upper edge of the band."""
    shown: str
    """The same as it is shown; empty for a line to tick."""
    unit: str | None = None
    """Unit of the figures; `null` for a line to tick."""
    field: bool
    """Whether a measured value is to be written down."""
    grade: Grade
    """How far it can be trusted."""
    source: str
    """Where it stands."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Recorded:
    """`commission --record`: what was measured, judged."""

    code: str
    """The code."""
    verdict: Fit
    """Whether nothing is off; what was not measured does not count as passed."""
    off: int
    """How many measurements are off."""
    not_checked: int
    """How many are not judged."""
    measurements: list[RecordedValue]
    """Each measurement."""


@dataclass(frozen=True, slots=True, kw_only=True)
class RecordedValue:
    """One measurement with its verdict."""

    id: str
    """What was measured."""
    name: str
    """The same in words."""
    number: int | None = None
    """Which of several, from 1."""
    verdict: Verdict
    """What comes out; `advice` is outside an estimated band."""
    value: float | None = None
    """The measured value."""
    expected: float | None = None
    """What it should be."""
    low: float | None = None
    """Lower edge of the band."""
    high: float | None = None
    """Upper edge of the band."""
    unit: str
    """Unit of the figures."""
    band: str | None = None
    """What the band rests on: `printed`, `servo_motors`, `kty_data_sheet`, `din_44081`, `friction`, `ours`, `exact`."""
    remark: str
    """The same in words, or why it is not judged."""
    cause: str | None = None
    """Identifier of the likely cause of what is off."""
    cause_text: str | None = None
    """The likely cause in words."""
    grade: Grade | None = None
    """How far the judgement can be trusted."""
    source: str
    """Where what it is compared with stands."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Inertia:
    """`inertia`: solid bodies about the axis."""

    bodies: list[Body]
    """Body by body."""
    J: float | None
    """Moment of inertia of all about the axis."""
    m: float | None
    """Mass of all."""
    centre: Centre
    """Centre of gravity of all."""
    T_gravity_max: float | None
    """Largest torque of gravity if the axis lies horizontally."""
    units: Units
    """The units of the figures."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Body:
    """One body, or several alike at equal angles."""

    shape: str
    """Id of its shape."""
    count: int
    """How many."""
    m: float | None
    """Mass of one of them."""
    r: float | None
    """Distance of the centre from the axis."""
    angle: float | None
    """Direction of the first."""
    J_own: float | None
    """Inertia of one of them about the own centre."""
    J_steiner: float | None
    """What the distance adds to that."""
    J: float | None
    """Both together, of all of them."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Centre:
    """A centre of gravity in polar coordinates about the axis."""

    r: float | None
    """Distance from the axis."""
    angle: float | None
    """Direction."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Curves:
    """`curve`: the curves of the torque-speed plane."""

    code: str
    """Ordering code."""
    units: Units
    """Units of speed, torque, voltage and duty factor."""
    curves: list[Curve]
    """The curves."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Curve:
    """One curve of the torque-speed plane."""

    kind: CurveKind
    """Which duty."""
    ED: float | None = None
    """Duty factor of S3 in %; `null` of the others."""
    title: str
    """Its name in words."""
    voltage: float | None = None
    """DC link voltage that it holds for; `null` where it holds for all."""
    points: list[list[float | None]]
    """Speed and torque, by rising speed."""
    upper: list[list[float | None]] | None = None
    """Upper edge of an estimate's band; `null` where there is none."""
    grade: Grade
    """How far it can be trusted."""
    source: str
    """Where it is from."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Bearings:
    """`bearing`: the output bearing of each size under the loads of the project."""

    sizes: list[BearingOfSize]
    """Every size."""

    @property
    def axes(self) -> list[Bearings]:
        """It as the answer of its only axis, as `AxesOfBearings` has those of several."""
        return [self]


@dataclass(frozen=True, slots=True, kw_only=True)
class BearingOfSize:
    """The output bearing of one size."""

    size: str
    """The size."""
    fits: bool
    """Whether none of its checks fails."""
    checks: list[Check]
    """The checks of the bearing."""


@dataclass(frozen=True, slots=True, kw_only=True)
class AxesOfBearings:
    """The answers of several axes."""

    verdict: Fit
    """The worst verdict of the axes."""
    axes: list[Bearings]
    """The answer of each axis."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Battery:
    """`battery`: the life of the encoder's battery."""

    life: float | None
    """Life in `unit`."""
    exchange_recommended: float | None
    """When it should be exchanged."""
    exchange_latest: float | None
    """When it must be exchanged."""
    capped: bool
    """Whether the life is that of the cell, not of its charge."""
    unit: str
    """Unit of the three."""
    grade: Grade
    """How far the life can be trusted."""
    source: str
    """Where it is from."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Mount:
    """`mount`: fits, tolerances, dimensions and screw joints of an actuator."""

    code: str
    """Ordering code."""
    verdict: Fit
    """Whether no joint slips under torque alone."""
    units: Units
    """Units of the figures, by field."""
    notes: list[str]
    """What the tables do not cover of the code, and what the figures rest on, in words."""
    pilots: list[Pilot]
    """The pilots with the bores over them, load first."""
    tolerances: list[MountValue]
    """Tolerances of the output flange."""
    dimensions: list[MountValue]
    """Dimensions, mass, mounting plate, degree of protection."""
    lifting_gear: bool | None = None
    """Whether the mass requires lifting gear; `null` if no mass is printed for the code."""
    joints: list[Joint]
    """The screw joints, load first."""
    facts: list[Fact]
    """Requirements of the manual, in the order of a machine's life."""
    errata: list[CitedErratum]
    """Errata of what stands above."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Pilot:
    """A pilot with the bore over it."""

    side: Side
    """Which side."""
    title: str
    """The side in words."""
    nominal: float | None
    """Nominal diameter."""
    zone: str
    """Tolerance zone of the pilot."""
    upper: float | None
    """Upper limit deviation of the pilot."""
    lower: float | None
    """Lower limit deviation of the pilot."""
    recommended: str
    """Zone that the manual recommends for the bore."""
    bore: str | None = None
    """Tolerance zone of the bore; `null` for limit deviations of one's own."""
    bore_upper: float | None
    """Upper limit deviation of the bore."""
    bore_lower: float | None
    """Lower limit deviation of the bore."""
    clearance_min: float | None
    """Smallest clearance; interference is negative."""
    clearance_max: float | None
    """Largest clearance."""
    off_centre_max: float | None
    """By how much the part may sit off centre: half of the largest clearance, none with interference."""
    fit: FitKind
    """What the fit is."""
    fit_text: str
    """The same in words."""
    grade: Grade
    """How far the clearances can be trusted."""
    sources: list[str]
    """Where the figures are from."""


@dataclass(frozen=True, slots=True, kw_only=True)
class MountValue:
    """A printed value."""

    symbol: str
    """Symbol in ASCII."""
    name: str
    """The field's word for it."""
    value: TableCell
    """The value; `null` where none is printed for the code."""
    unit: str
    """Its unit in ASCII; empty for texts."""
    grade: Grade | None = None
    """How far it can be trusted; `null` without a value."""
    source: str | None = None
    """Where it is from; `null` without a value."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Joint:
    """A screw joint."""

    side: Side
    """Which side."""
    title: str
    """The side in words."""
    count: float | None = None
    """Number of screws."""
    size: str | None = None
    """Thread."""
    class_: str | None = None
    """Property class."""
    bolt_circle: float | None = None
    """Diameter of the bolt circle."""
    tightening_torque: float | None = None
    """Tightening torque of a screw."""
    transmissible_torque: float | None = None
    """Torque that the joint transmits, faces degreased."""
    friction: float | None = None
    """Coefficient of friction that it holds for."""
    clamp_force: float | None = None
    """Clamp force of a screw that it implies: estimated."""
    source: str | None = None
    """Where the printed values are from."""
    cases: list[JointCase]
    """The joint under each load."""


@dataclass(frozen=True, slots=True, kw_only=True)
class JointCase:
    """A joint under a load."""

    case: LoadCase
    """Which load."""
    title: str
    """The load in words."""
    torque: float | None = None
    """The torque; `null` without one, or where none is known."""
    torque_source: str | None = None
    """Where the torque is from."""
    utilisation: float | None = None
    """Share of the transmissible torque, torque alone."""
    verdict: Verdict
    """Verdict on torque alone."""
    grade: Grade | None = None
    """How far the share can be trusted."""
    moment: float | None = None
    """Tilting moment that acts with it."""
    moment_source: str | None = None
    """Where the moment is from."""
    relieved: float | None = None
    """Share of the clamp force that the screw relieved most loses: estimated."""
    utilisation_together: float | None = None
    """Share of the friction left that torque and forces take: estimated; `null` where the joint opens."""
    verdict_together: Verdict
    """Verdict on everything at once; `advice` where the estimate does not suffice."""
    missing: str | None = None
    """What is missing for a verdict, in words."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Upkeep:
    """`upkeep`: what is to be done, and by when."""

    code: str
    """Ordering code."""
    verdict: Fit
    """Whether the storage is within what is permitted."""
    delivered: str
    """Day of delivery, as `2026-03-01`."""
    in_service: str
    """Day on which service begins."""
    today: str | None = None
    """Day that the plan is looked at from; `null`: not stated."""
    plan: list[Planned]
    """The plan, by date."""
    battery: Battery | None = None
    """Life of the encoder's battery; `null` without one, or where the hours of operation are not stated."""
    notes: list[str]
    """What was assumed, and what the manual does not state, in words."""
    storage: list[Fact]
    """Transport and storage."""
    service: list[Fact]
    """In service."""
    shutdown: list[Fact]
    """Shutting down, in the order of the steps."""
    disposal: list[Fact]
    """Disposal."""
    errata: list[CitedErratum]
    """Errata of the text that the plan rests on."""
    calendar: str | None = None
    """The iCalendar file that the plan was written to; `null`: none."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Planned:
    """A line of the plan."""

    task: Task
    """What."""
    title: str
    """The task in words."""
    rule: Rule
    """How binding."""
    rule_text: str
    """The rule in words, with its interval."""
    interval: str | None = None
    """Interval of a series, as ISO 8601 writes it: `P6M`, `P90D`."""
    first: str
    """The date; of a series the first."""
    next: str
    """Of a series the first date that is not before today, if today is stated."""
    passed: bool
    """Whether it lies before today, if today is stated."""
    fact: str
    """Id of the fact that it rests on."""
    text: str
    """What the fact says."""
    source: str
    """Where the date is from."""
    grade: Grade | None = None
    """How far it can be trusted; `null` where it follows from an interval that the user states."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Glossary:
    """Words and symbols, all or the requested ones."""

    words: list[GlossaryWord]
    """Words of the product: one for one thing."""
    terms: list[GlossaryTerm]
    """Symbols of the tables."""
    symbols: list[GlossarySymbol]
    """Symbols of the derivations and of the values for a drive. One that means several things stands several times."""


@dataclass(frozen=True, slots=True, kw_only=True)
class GlossaryWord:
    """A word of the product."""

    id: str
    """Identifier."""
    en: str
    """English word."""
    de: str
    """German word."""
    meaning: str
    """Meaning, in the requested language."""


@dataclass(frozen=True, slots=True, kw_only=True)
class GlossaryTerm:
    """A symbol of the tables."""

    symbol: str
    """Symbol in ASCII, as in the catalogue's export: `T_max`."""
    identifier: str
    """Long name, as in project files."""
    unit: str
    """Unit of the print; empty for a bare number or a text."""
    en: str
    """English term."""
    de: str
    """German term."""
    remark: str
    """Remark in the requested language; may be empty."""


@dataclass(frozen=True, slots=True, kw_only=True)
class GlossarySymbol:
    """A symbol of the derivations that `explain` gives, or of the values that `commission` gives."""

    symbol: str
    """Symbol in ASCII."""
    shown: str
    """Symbol as formulas show it."""
    en: str
    """English meaning."""
    de: str
    """German meaning."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Units2:
    """Units by the quantity that they measure."""

    quantities: list[Measured]
    """The quantities."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Measured:
    """A quantity with its units."""

    quantity: str
    """Its name in the language of the call."""
    si_unit: str
    """The unit in which `si` and `zero` are stated, in the spelling of project files."""
    units: list[UnitRead]
    """Its units, the usual one first."""


@dataclass(frozen=True, slots=True, kw_only=True)
class UnitRead:
    """A unit and how it is read."""

    unit: str
    """In project files."""
    symbol: str
    """In reports and on the terminal."""
    json: str
    """In JSON and tables."""
    also: list[str]
    """Further spellings that are read."""
    si: float | None
    """One of it, as a difference, in SI."""
    zero: float | None
    """Zero of it in SI: nonzero for degrees Celsius alone."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Licences:
    """The licence of the program and those of the work of others in it."""

    texts: list[LicenceText]
    """The program's own first."""


@dataclass(frozen=True, slots=True, kw_only=True)
class LicenceText:
    """A text as it stands in the repository."""

    name: str
    """Its file in the repository."""
    text: str
    """The whole of it, in Markdown where the name ends so."""


@dataclass(frozen=True, slots=True, kw_only=True)
class CommissionWritten:
    """`commission --out`, `--checklist` or `--blank`: a file that was written."""

    file: str
    """Its path."""
    code: str
    """The code."""
    bytes: int
    """How many bytes it has."""


@dataclass(frozen=True, slots=True, kw_only=True)
class FilesWritten:
    """`new --out`: the files that were written."""

    files: list[str]
    """Their paths."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ReportWritten:
    """`report`: the file that was written."""

    file: str
    """Its path as given."""
    code: str | None = None
    """Ordering code, or name of the project's own actuator; left out where the report is about several axes."""
    verdict: Fit
    """Whether nothing speaks against it, or against any of several."""
    axes: list[AxisWritten] | None = None
    """With several axes only: each with its actuator."""
    bytes: int
    """Size of the file."""


@dataclass(frozen=True, slots=True, kw_only=True)
class AxisWritten:
    """An axis in a file."""

    axis: str
    """Its name."""
    code: str
    """Ordering code, or name of the project's own actuator."""
    verdict: Fit
    """Whether nothing speaks against it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ExportWritten:
    """`export --out`: the file that was written."""

    file: str
    """Its path as given."""
    code: str
    """Ordering code, or name of the project's own actuator."""
    verdict: Fit
    """Whether nothing speaks against it."""
    tables: list[TableWritten]
    """The tables in it."""
    left_out: list[TableWritten]
    """Tables that it does not have, because they are too long for a sheet of a workbook."""


@dataclass(frozen=True, slots=True, kw_only=True)
class TableWritten:
    """A table in a file."""

    name: str
    """Its name."""
    rows: int
    """How many rows it has."""


@dataclass(frozen=True, slots=True, kw_only=True)
class PlotWritten:
    """`plot`: the picture that was written."""

    figure: str
    """Id of the figure."""
    file: str | None = None
    """The first of the files; `null` where it went to standard output."""
    files: list[str]
    """All files."""
    width: float | None
    """Width of the picture."""
    height: float | None
    """Height of the picture."""
    units: Units
    """Units of both."""
    title: str
    """Its title."""
    caption: str
    """The line below it."""
    description: str
    """Description of the picture, for screen readers."""


@dataclass(frozen=True, slots=True, kw_only=True)
class CodeFaults:
    """A code, or a partial code, that cannot be: written instead of the answer."""

    valid: bool
    """Always `false`."""
    text: str
    """The text given."""
    errors: list[CodeFault]
    """Every fault, in the order of the text."""
    nearest: list[str]
    """The nearest valid codes that the manual prints data for."""
    nearest_codes: list[ListedCode]
    """The same with their availability."""


@dataclass(frozen=True, slots=True, kw_only=True)
class CodeFault:
    """A fault of a code."""

    id: str
    """Stable id of its kind: `code_rule` for a rule of a table, `code_spelling` for anything else."""
    position: int
    """Its place in characters, from 1."""
    span: list[int]
    """Its place in bytes: begin, and end without it."""
    text: str | None = None
    """What stands there."""
    message: str
    """What is wrong, one sentence."""
    hint: str | None = None
    """What would be valid here; `null` where nothing is near."""
    table: str | None = None
    """The ordering table whose rule is broken; `null` for a fault of the spelling."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Faults:
    """Every fault that was found; a command that cannot answer writes this instead of its answer, and exits with 2."""

    errors: list[Fault]
    """The faults, in the order of the file."""
    nearest_codes: list[ListedCode] | None = None
    """The nearest valid codes, where a wrong ordering code is among the faults."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Fault:
    """One fault; id, option, file and place are left out where there is none."""

    id: str | None = None
    """Stable id of its kind."""
    option: str | None = None
    """The option of the command line that it is about."""
    file: str | None = None
    """The file that it is about."""
    line: int | None = None
    """Line, from 1."""
    column: int | None = None
    """Column in characters, from 1."""
    span: list[int] | None = None
    """The offending part in bytes: begin, and end without it."""
    heading: str | None = None
    """The heading of the column of a table that it is about."""
    row: int | None = None
    """The row of the table, from 0."""
    message: str
    """What is wrong, one sentence."""
    hint: str | None = None
    """What was expected, or the nearest valid choice; `null` where nothing is near."""


Fit = Literal["fits", "fits_if_estimate", "does_not_fit"]
"""Verdict on an actuator, or on the best of several; the best first.

`fits`: Nothing speaks against it

`fits_if_estimate`: No check fails, but one is beyond its limit within the band of an estimate, with the verdict `advice`

`does_not_fit`: A check fails, or a requirement is not met"""

CheckId = Literal["peak_torque", "peak_speed", "mean_speed", "continuous_torque", "peak_current", "demagnetisation", "drive_current", "voltage", "inertia_ratio", "rope_tension", "gear_mean_torque", "gear_life", "torsion", "natural_frequency", "bearing_axial", "bearing_radial", "bearing_tilting_moment", "bearing_static_moment", "bearing_life", "bearing_static", "tilt_angle", "ambient", "torque_speed_trace", "thermal", "overload_i2t", "gear_mean_input_speed", "collision_torque", "resonance_speed", "error_budget", "brake_holding", "brake_emergency", "dc_link", "regeneration", "feedback_range", "feedback_resolution", "battery", "screw_joint_load", "screw_joint_housing", "application"]

DemandMode = Literal["manual", "integral"]
"""How the figures of a demand were found.

`manual`: By the manual's equations 69.1 to 69.4

`integral`: By exact integration"""

Units = dict[str, str]
"""The units of the figures, by symbol or field."""

Verdict = Literal["pass", "fail", "advice", "not_checked"]

Direction = Literal["at_most", "at_least"]

Part = Literal["drive", "thermal", "energy", "gear", "output_bearing", "brake", "feedback", "screws"]

Grade = Literal["printed", "computed", "published", "estimated", "assumed"]

TextEncoding = Literal["utf8", "utf16", "utf16_guessed", "windows1252_guessed"]
"""How the text of a recording was read.

`utf8`: UTF-8, which every byte of the header agrees to

`utf16`: UTF-16, as the mark at the beginning says

`utf16_guessed`: UTF-16, guessed from the zeros between the letters

`windows1252_guessed`: Windows-1252, of which Latin-1 is a part: guessed, since the header is no UTF-8"""

ColumnRole = Literal["time", "position", "speed", "torque"]
"""What a column of a recording is."""

UnitBy = Literal["header", "unit_row", "metadata", "values", "project"]
"""Source of the unit of a column.

`header`: The name of the column

`unit_row`: A row of units below the names

`metadata`: The file's own metadata

`values`: The values of the column: clock times

`project`: The project file"""

ScenarioId = Literal["cycle", "emergency_stop", "power_failure", "brake_stuck", "hanging_load", "blocked_load", "encoder_failure", "battery_loss", "link_sag", "hot_ambient", "cold_grease", "collision"]

Reaction = Literal["ramp", "brake", "coast"]

Figures = dict[str, Figure]

EventKind = Literal["scenario", "ramp", "pulses_off", "brake_closes", "brake_closed", "brake_closed_moving", "brake_open", "brake_slips", "at_rest", "limited", "overload", "winding_warning", "winding_shutdown", "ptc_response", "following_error", "link_low", "link_high", "brake_resistor", "no_position", "turns_lost", "demagnetisation", "collision_torque", "overspeed", "diverged"]

Loop = Literal["current", "speed", "position"]

ColumnKind = Literal["text", "number", "count", "word"]
"""What a column holds.

`text`: Text

`number`: Numbers

`count`: Whole numbers

`word`: A word of a fixed set"""

TableCell = float | str | None
"""A value of a table."""

Availability = Literal["available", "on_request"]
"""Whether a code can be ordered as it is.

`available`: Yes

`on_request`: On request only"""

Field = Literal["series", "size", "ratio", "winding", "feedback", "brake", "option_1", "option_2", "special"]

NoteBy = Literal["manual", "antrieb"]
"""Who says what a note says.

`manual`: The manual

`antrieb`: Our own conclusion from the print"""

ConnectorRole = Literal["motor", "feedback", "output_encoder"]

ConnectorExit = Literal["cable", "housing"]
"""Where a connector is.

`cable`: At the end of a cable

`housing`: In the housing"""

SignalGroup = Literal["phase", "protective_earth", "brake", "ptc", "kty", "supply", "sense", "incremental", "reference", "commutation", "serial", "resolver", "shield"]

CableRole = Literal["motor", "feedback", "output_encoder", "set"]

CableFor = Literal["sinamics_s120_smc", "sinamics_s120_smc20", "simodrive", "yukondrive", "open_end"]

Signal = Literal["danger", "warning", "caution", "notice", "info"]

Step = Literal["transport", "mounting", "wiring", "before_power", "first_motion", "after_a_day", "in_service", "shutdown", "disposal"]

Bound = Literal["above", "below", "at_least", "at_most", "about", "exactly"]

Circuit = Literal["brake", "feedback_supply", "output_encoder_supply"]

Severity = Literal["danger", "fault", "advice"]

EncoderProtocol = Literal["endat", "ssi"]

SignalForm = Literal["voltage", "peak_voltage", "level", "share", "other"]
"""How the value of a signal is meant.

`voltage`: A voltage between its pins

`peak_voltage`: A voltage at the peak of the excitation

`level`: One is high, zero low

`share`: A part of the amplitude, which is not printed

`other`: Clocked or alternating: it does not follow the angle"""

EncoderAssumed = Literal["order_of_tracks", "zero_of_tracks", "zero_of_commutation", "zero_of_position", "zero_of_output", "times_of_endat", "times_of_ssi", "carrier", "deviation", "battery_lost"]

ErratumKind = Literal["recovery", "print_error", "contradiction", "rounding", "edition"]
"""What is wrong, and with what.

`recovery`: The recovered text differs from the print

`print_error`: The print itself is wrong and its neighbours prove it

`contradiction`: Two printed facts exclude each other and nothing decides

`rounding`: Rounded to the unsafe side or with false digits

`edition`: Another edition prints otherwise"""

ErratumStatus = Literal["corrected", "flagged"]
"""Whether an erratum is settled.

`corrected`: The right value is proven and used

`flagged`: The print stays and is flagged"""

CommissionAnswer = list[DriveObject] | Commissioning
"""`commission`: with `--for cia402` the list of objects, else the whole sheet."""

CurveKind = Literal["continuous", "S3", "short_time"]
"""Duty of a curve.

`continuous`: Continuous

`S3`: Intermittent periodic duty

`short_time`: Short time"""

Side = Literal["load", "housing"]

FitKind = Literal["clearance", "transition", "interference"]

LoadCase = Literal["peak", "collision", "brake", "static_moment"]

Task = Literal["storage_end", "cleaning", "cables", "protective_earth", "screws", "seals", "encoder_recommended", "battery_empty", "encoder_latest"]

Rule = Literal["at_the_latest", "recommended", "estimated", "every", "every_at_most"]

TableRow = dict[str, TableCell]
"""A row: a value for each column."""

__all__ = [
    "AmbiguousColour",
    "Assessed",
    "Availability",
    "AxesOfBearings",
    "AxesOfComparison",
    "AxesOfDifference",
    "AxesOfExplanations",
    "AxesOfJudgement",
    "AxesOfSimulation",
    "AxesOfSizing",
    "AxisWritten",
    "Battery",
    "BearingOfSize",
    "Bearings",
    "Body",
    "Bound",
    "Cable",
    "CableFor",
    "CableRole",
    "CatalogueCell",
    "Centre",
    "Check",
    "CheckChange",
    "CheckId",
    "CheckRow",
    "Choice",
    "Circuit",
    "CitedErratum",
    "CodeFault",
    "CodeFaults",
    "CodeField",
    "CodeReading",
    "ColumnKind",
    "ColumnRole",
    "CommissionAnswer",
    "CommissionEntry",
    "CommissionGap",
    "CommissionList",
    "CommissionParameter",
    "CommissionWritten",
    "Commissioning",
    "Compared",
    "Comparison",
    "Completion",
    "Connector",
    "ConnectorExit",
    "ConnectorPin",
    "ConnectorRole",
    "ControlLoop",
    "Curve",
    "CurveKind",
    "Curves",
    "DatumChange",
    "DatumRow",
    "DecodedWord",
    "Demand",
    "DemandMode",
    "Derivation",
    "Difference",
    "Direction",
    "Doubted",
    "DriveObject",
    "DriveParameter",
    "Encoder",
    "EncoderAssumed",
    "EncoderAssumption",
    "EncoderCarrier",
    "EncoderCurve",
    "EncoderFailure",
    "EncoderPin",
    "EncoderProtocol",
    "EncoderShaft",
    "EncoderSignal",
    "EncoderState",
    "EncoderValue",
    "EncoderWord",
    "Errata",
    "Erratum",
    "ErratumCell",
    "ErratumKind",
    "ErratumStatus",
    "EventKind",
    "Explained",
    "Explanations",
    "ExportWritten",
    "Fact",
    "FactValue",
    "Fault",
    "Faults",
    "Field",
    "Figure",
    "Figures",
    "FilesWritten",
    "Fit",
    "FitKind",
    "Glossary",
    "GlossarySymbol",
    "GlossaryTerm",
    "GlossaryWord",
    "Grade",
    "Head",
    "Identification",
    "Identified95",
    "Inertia",
    "Influence",
    "InputChange",
    "IntegralDemand",
    "Joint",
    "JointCase",
    "Judgement",
    "LeftOpen",
    "LicenceText",
    "Licences",
    "ListedCode",
    "LoadCase",
    "Loop",
    "Measured",
    "MissedBy",
    "ModelParameter",
    "Motion",
    "Mount",
    "MountValue",
    "MoveTorques",
    "NeededLimit",
    "Node",
    "NotAvailable",
    "NotJudged",
    "NotSought",
    "NoteBy",
    "OpenField",
    "OverloadSupervision",
    "OverloadTrip",
    "Part",
    "Pilot",
    "Planned",
    "PlotWritten",
    "Quantiles",
    "Ranked",
    "Reaction",
    "Recorded",
    "RecordedColumn",
    "RecordedValue",
    "Recording",
    "Rejection",
    "ReportWritten",
    "Reserve",
    "Rule",
    "ScenarioId",
    "Segment",
    "SensorThreshold",
    "Severity",
    "Sheet",
    "SheetNote",
    "SheetSection",
    "SheetValue",
    "Side",
    "Signal",
    "SignalForm",
    "SignalGroup",
    "SimulatedEvent",
    "SimulatedVerdict",
    "Simulation",
    "Sizing",
    "Stage",
    "StageRatio",
    "Step",
    "SweepRow",
    "SweepSummary",
    "Table",
    "TableCell",
    "TableColumn",
    "TableRow",
    "TableWritten",
    "Task",
    "TextEncoding",
    "Tolerance",
    "ToleratedValue",
    "Torsion",
    "UnitBy",
    "UnitRead",
    "Units",
    "Units2",
    "Upkeep",
    "Verdict",
    "VoltageDrop",
    "VoltageDrops",
    "Wiring",
    "WiringCheck",
    "WiringFinding",
    "WiringNote",
    "WordFault",
    "WordField",
    "WorstCorner",
    "WouldFit",
]
