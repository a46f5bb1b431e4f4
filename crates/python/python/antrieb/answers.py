"""The answers of antrieb as typed objects.

This file is written from the schema of the answers by `cargo xtask snapshots`; do not edit it. A number is `None` where it is
not finite, a field that an answer leaves out is `None`. The unit of a figure ends its name (`mass_kg`), stands in the field
`unit` beside it, or in the `units` of its record by the name of the field.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

from antrieb._nearest import NothingFits, judged, of_key
from antrieb._record import Explainable, Record, Rows, Tabular



@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Sizing(Record):
    """`size`: judgement of the catalogue for an axis."""

    axis: str
    """Name of the axis."""
    verdict: Fit
    """Verdict on the best actuator, the project's own included."""
    answer: str | None = None
    """Best ordering code; `null` if none fits."""
    judged: int
    """Number of actuators of the catalogue judged."""
    fit: int
    """Number of actuators that fit within every limit, verdict `fits`."""
    not_evaluated: int | None = None
    """Number of actuators among `fit` for which data are missing for every check that can reject them."""
    fit_if_estimate: int
    """Number of further actuators that fit if an estimate holds, verdict `fits_if_estimate`."""
    fitting: int
    """Sum of `fit` and `fit_if_estimate`."""
    rule: str
    """Criterion of the ranking, as text."""
    ranking: Rows[Ranked]
    """Best fitting actuators, in the requested number."""
    rejected: Rows[Rejection]
    """Actuators that do not fit, by smallest excess."""
    nearest_miss: str | None = None
    """Ordering code with the smallest excess among those that do not fit but meet every requirement and are of the
right class of voltage and place; where none fits, the one with the smallest excess that meets every requirement;
where none does, the one that misses the fewest requirements and limits. `null` if there is none."""
    own: Assessed | None = None
    """Project's own actuator."""
    would_fit_after: Rows[WouldFitAfter] | None = None
    """Smallest changes of load and cycle time with which an actuator would fit, one change at a time; only if nothing
fits and the cycle is not too long for the search."""
    would_fit_with: Rows[WouldFit] | None = None
    """Values of the gearing with which an actuator would fit, one change at a time; only if nothing fits."""
    would_fit_with_law: WouldFitWithLaw | None = None
    """Law of motion in place of the assumed one with which an actuator would fit; only if nothing fits and a law is open."""
    assumptions: Rows[AssumptionEntry]
    """Assumptions."""
    stage: Stage | None = None
    """Stage between actuator and mechanism; only if the project has one."""
    motion: Motion
    """Motion resulting from the project."""

    @property
    def axes(self) -> Rows[Sizing]:
        """It as the answer of its only axis, as `AxesOfSizing` has those of several."""
        return Rows([self])

    @property
    def best(self) -> Ranked | NothingFits:
        """The best fitting actuator; where none fits `NothingFits`, which is false and has no code."""
        return self.ranking[0] if self.ranking else NothingFits.of(self)

    @property
    def candidates(self) -> Rows[Ranked | Rejection]:
        """Every actuator that was judged: those that fit by rank, then those that do not fit by their excess.

        Beyond the `top` of the call the ranking is asked anew, once.

        Raises:
            ValueError: The project has changed since.
        """
        return judged(self)

    def __iter__(self) -> Iterator[Ranked | Rejection]:
        return iter(self.candidates)

    def __len__(self) -> int:
        return len(self.candidates)

    def __contains__(self, item: object, /) -> bool:
        return item in self.candidates

    def __getitem__(self, key: int | str, /) -> Ranked | Rejection:
        return of_key(self, key)


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Ranked(Record):
    """An actuator that fits, with its rank."""

    code: str | None = None
    """Ordering code of an actuator of the catalogue."""
    name: str | None = None
    """Name of the project's own actuator."""
    maker: str | None = None
    """Maker; `null` if no file states it."""
    series: str | None = None
    """Series of the maker; `null` if no file states it."""
    kind: str | None = None
    """Kind of the product: `actuator`."""
    length_mm: float | None = None
    """Length in mm; `null` if it is not stated."""
    price: str | None = None
    """Price as written; `null` if it is not stated."""
    lead_time_d: float | None = None
    """Time of delivery in days; `null` if it is not stated."""
    verdict: Fit
    """Verdict on the actuator."""
    utilisation: float | None
    """Utilisation of the governing check; 1 is the limit. `null` if it fails at a limit of zero or outside a range."""
    tightest: CheckId | None = None
    """Id of the governing check: the failing one with the largest excess, else the one with the highest utilisation.
`null` if no check has a limit."""
    mass_kg: float | None = None
    """Mass in kg, the larger one if the manual is in doubt."""
    mass_errata: list[str]
    """Ids of the errata that touch the mass."""
    on_request: list[str]
    """Names of the fields of the code that are on request only."""
    demand: Demand | None = None
    """Demand on the actuator; `null` without J_out."""
    checks: Rows[Check]
    """The checks, in a fixed order."""
    objections: list[str]
    """Requirements not met and rules violated, as text."""
    open_requirements: list[str] | None = None
    """Requirements that stay open because a datum is missing, as text; only where there are some."""
    open_questions: int
    """Number of questions that could not be answered because a datum is missing: checks without a value, and open
requirements."""
    tolerance: Tolerance | None = None
    """Effect of the tolerances; only if the project has some."""
    rank: int
    """Rank, from 1."""

    def __iter__(self) -> Iterator[Check]:
        return iter(self.checks)

    def __len__(self) -> int:
        return len(self.checks)

    def __contains__(self, item: object, /) -> bool:
        return item in self.checks

    def __getitem__(self, key: int | str, /) -> Check:
        return self.checks[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Demand(Record):
    """The demand; if the manual's equations describe the axis, their figures together with the exact integrals."""

    mode: DemandMode
    """`integral` if the manual's equations do not describe the axis, also if a move brakes in another time than it
accelerates: then the figures are those of the integrals, and
the three torques, `moves` and `integral` are omitted."""
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
    """Torque during acceleration."""
    T_2: float | None = None
    """Torque at constant speed."""
    T_3: float | None = None
    """Torque during deceleration."""
    units: Units
    """Units of the figures."""
    moves: Rows[MoveTorques] | None = None
    """Torques of each move; only with several moves."""
    governing_move: int | None = None
    """Number of the move with the largest torque, from 1; only with several moves."""
    integral: IntegralDemand | None = None
    """Figures by exact integration, which the checks use."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class MoveTorques(Record):
    """Torques in the three phases of a move of the manual's form, in its direction, in Nm."""

    T_1: float | None
    """Torque during acceleration."""
    T_2: float | None
    """Torque at constant speed."""
    T_3: float | None
    """Torque during deceleration."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class IntegralDemand(Record):
    """Figures of the demand by exact integration."""

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
    """`integral` in every case."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Check(Explainable):
    """Result of one check."""

    id: CheckId
    """Id of the check."""
    title: str
    """Name of the check."""
    verdict: Verdict
    """Verdict of the check. `advice` also means: within the band of an estimate."""
    value: float | None = None
    """Value demanded by the axis; may be present with `not_checked`, if only the limit is missing."""
    limit: float | None = None
    """Limit of the actuator, or limit required by the project."""
    unit: str | None = None
    """Unit of value and limit: `Nm` `1/min` `A` `V` `W` `kgm^2` `N` `mm` `h` `a` `deg` `arcmin` `arcsec` `rev` `Hz`
`degC` `1`."""
    direction: Direction
    """Required relation of the value to the limit."""
    part: Part
    """Part of the actuator concerned."""
    utilisation: float | None = None
    """Value/limit for `at_most`, limit/value for `at_least`; `null` if it has no meaning."""
    margin: bool
    """`true` if the ranking uses this utilisation; `false` for a recommendation, and for a class that is met or not."""
    at: float | None = None
    """Instant of the worst case within the cycle, in s."""
    grade: Grade | None = None
    """Grade of the figures: the worst of all inputs."""
    source: str | None = None
    """Source of the limit, then of the value, joined by `; `."""
    sources: list[str]
    """The sources as a list."""
    missing: str | None = None
    """Symbol of the missing datum, or the project key that would set the limit."""
    notes: list[str]
    """Remarks, as text."""
    errata: list[str] | None = None
    """Ids of the errata that value or limit depend on; their evidence is in `notes`. Omitted if there are none."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Tolerance(Record):
    """Effect of the project's tolerances on an actuator."""

    samples: int
    """Number of samples drawn."""
    seed: int
    """Seed of the random numbers."""
    distribution: str
    """`uniform` in every case."""
    passes: int
    """Number of samples with which the actuator fits."""
    passes_if_estimate: int
    """Number of samples among `passes` with which it fits if an estimate holds, `fits_if_estimate`."""
    impossible: int
    """Number of samples without a valid axis; none of them passes."""
    share: float | None
    """Share of the samples that pass."""
    interval: list[float | None]
    """95 % interval of the share, lower and upper end."""
    utilisation: Quantiles
    """Distribution of the highest utilisation over the samples."""
    worst_corner: WorstCorner
    """Worst point found."""
    influence: Rows[Influence]
    """Influence of each quantity on the utilisation, the largest share first; empty if it does not vary."""

    def __iter__(self) -> Iterator[Influence]:
        return iter(self.influence)

    def __len__(self) -> int:
        return len(self.influence)

    def __contains__(self, item: object, /) -> bool:
        return item in self.influence

    def __getitem__(self, key: int | str, /) -> Influence:
        return self.influence[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Quantiles(Record):
    """Quantiles of the highest utilisation; `null` for an infinite one."""

    p05: float | None
    """5 % quantile."""
    p50: float | None
    """50 % quantile."""
    p95: float | None
    """95 % quantile."""
    max: float | None
    """Largest value."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class WorstCorner(Record):
    """The worst point within the tolerances."""

    verdict: Fit
    """Verdict at this point."""
    utilisation: float | None
    """Highest utilisation at this point."""
    check: CheckId | None = None
    """Id of the governing check: the failing one with the largest excess, else the one with the highest utilisation."""
    values: Rows[ToleratedValue]
    """Value of each quantity at this point."""
    is_corner: bool
    """`false`: a sample inside the bands is worse than every corner, and this is the sample."""
    exhaustive: bool
    """`true`: every corner was evaluated; `false`: more than ten quantities, the corner was searched."""

    def __iter__(self) -> Iterator[ToleratedValue]:
        return iter(self.values)

    def __len__(self) -> int:
        return len(self.values)

    def __contains__(self, item: object, /) -> bool:
        return item in self.values

    def __getitem__(self, key: int | str, /) -> ToleratedValue:
        return self.values[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class ToleratedValue(Record):
    """A quantity with a tolerance at some point."""

    quantity: str
    """Key of the quantity."""
    value: float | None
    """Value of the quantity."""
    unit: str
    """Unit as written."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Influence(Record):
    """Influence of a quantity on the utilisation."""

    quantity: str
    """Key of the quantity."""
    share: float | None
    """Share of the explained variance."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Rejection(Record):
    """Summary of the reasons for a rejection."""

    code: str
    """Ordering code of the rejected actuator."""
    maker: str | None = None
    """Maker; `null` if no file states it."""
    series: str | None = None
    """Series of the maker; `null` if no file states it."""
    kind: str | None = None
    """Kind of the product: `actuator`."""
    length_mm: float | None = None
    """Length in mm; `null` if it is not stated."""
    price: str | None = None
    """Price as written; `null` if it is not stated."""
    lead_time_d: float | None = None
    """Time of delivery in days; `null` if it is not stated."""
    check: CheckId | None = None
    """Id of the governing check: the failing one with the largest excess; `null` if only objections reject the
actuator."""
    value: float | None = None
    """Value of that check."""
    limit: float | None = None
    """Limit of that check."""
    unit: str | None = None
    """Unit of value and limit."""
    utilisation: float | None = None
    """Utilisation of that check; `null` if the limit is zero or a range."""
    failing: list[CheckId]
    """Ids of the failing checks, in the order of the checks."""
    objections: list[str]
    """Requirements not met and rules violated, as text."""

    @property
    def verdict(self) -> Fit:
        """Verdict on the actuator: it does not fit."""
        return "does_not_fit"

    @property
    def tightest(self) -> CheckId | None:
        """Id of the governing check, as `check`."""
        return self.check


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Assessed(Record):
    """An actuator with the effect of the project's tolerances."""

    code: str | None = None
    """Ordering code of an actuator of the catalogue."""
    name: str | None = None
    """Name of the project's own actuator."""
    maker: str | None = None
    """Maker; `null` if no file states it."""
    series: str | None = None
    """Series of the maker; `null` if no file states it."""
    kind: str | None = None
    """Kind of the product: `actuator`."""
    length_mm: float | None = None
    """Length in mm; `null` if it is not stated."""
    price: str | None = None
    """Price as written; `null` if it is not stated."""
    lead_time_d: float | None = None
    """Time of delivery in days; `null` if it is not stated."""
    verdict: Fit
    """Verdict on the actuator."""
    utilisation: float | None
    """Utilisation of the governing check; 1 is the limit. `null` if it fails at a limit of zero or outside a range."""
    tightest: CheckId | None = None
    """Id of the governing check: the failing one with the largest excess, else the one with the highest utilisation.
`null` if no check has a limit."""
    mass_kg: float | None = None
    """Mass in kg, the larger one if the manual is in doubt."""
    mass_errata: list[str]
    """Ids of the errata that touch the mass."""
    on_request: list[str]
    """Names of the fields of the code that are on request only."""
    demand: Demand | None = None
    """Demand on the actuator; `null` without J_out."""
    checks: Rows[Check]
    """The checks, in a fixed order."""
    objections: list[str]
    """Requirements not met and rules violated, as text."""
    open_requirements: list[str] | None = None
    """Requirements that stay open because a datum is missing, as text; only where there are some."""
    open_questions: int
    """Number of questions that could not be answered because a datum is missing: checks without a value, and open
requirements."""
    tolerance: Tolerance | None = None
    """Effect of the tolerances; only if the project has some."""

    def __iter__(self) -> Iterator[Check]:
        return iter(self.checks)

    def __len__(self) -> int:
        return len(self.checks)

    def __contains__(self, item: object, /) -> bool:
        return item in self.checks

    def __getitem__(self, key: int | str, /) -> Check:
        return self.checks[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class WouldFitAfter(Record):
    """A change of load or cycle time after which an actuator would fit."""

    change: str
    """Changed quantity: `cycle_time`, `payload_factor` or `load_factor`, as in `reserve`."""
    value: float | None
    """Duration of the cycle, or factor."""
    unit: str
    """Unit of the value; `1` for a factor."""
    code: str
    """Best ordering code with this value."""
    verdict: Fit
    """Verdict on this code."""
    if_estimate: bool
    """`true` if the code fits only if an estimate holds."""
    unless_rating: bool
    """`true` if the code fits unless a gear rating of another manufacturer applies."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class WouldFit(Record):
    """A value with which an actuator would fit."""

    key: str
    """Key of the project."""
    stated: bool
    """`true` if the project states the key; `false` if it would be added."""
    value: float | None
    """Value of three digits nearest to the stated one with which an actuator fits."""
    unit: str
    """Unit of the value; `1` for a ratio."""
    code: str
    """Best ordering code with this value."""
    verdict: Fit
    """Verdict on this code."""
    if_estimate: bool
    """`true` if the code fits only if an estimate holds."""
    unless_rating: bool
    """`true` if the code fits unless a gear rating of another manufacturer applies."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class WouldFitWithLaw(Record):
    """A law of motion with which an actuator would fit."""

    law: str
    """Law of every move whose law is open, as in project files."""
    title: str
    """Law as text."""
    keys: list[str]
    """Keys of these laws."""
    code: str
    """Best ordering code with this law."""
    verdict: Fit
    """Verdict on this code."""
    if_estimate: bool
    """`true` if the code fits only if an estimate holds."""
    unless_rating: bool
    """`true` if the code fits unless a gear rating of another manufacturer applies."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class AssumptionEntry(Record):
    """An assumption, made where the project states nothing."""

    key: str | None = None
    """Keys that take its place, separated by commas; `null` if no key does."""
    value: str | None = None
    """Value in effect, as the keys state it; `null` if no value is."""
    why: str
    """The assumption as text."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Stage(Record):
    """The stage between actuator and mechanism."""

    ratio: float | None
    """Ratio in use."""
    ratios: Rows[StageRatio]
    """Results for each ratio of the project."""

    def __iter__(self) -> Iterator[StageRatio]:
        return iter(self.ratios)

    def __len__(self) -> int:
        return len(self.ratios)

    def __contains__(self, item: object, /) -> bool:
        return item in self.ratios

    def __getitem__(self, key: int | str, /) -> StageRatio:
        return self.ratios[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class StageRatio(Record):
    """Result for a ratio of the stage."""

    ratio: float | None
    """Ratio of the stage."""
    answer: str | None = None
    """Best ordering code with this ratio; `null` if none fits."""
    utilisation: float | None
    """Utilisation of the governing check of the best actuator, or of the one with the smallest excess."""
    fitting: int
    """Number of actuators that fit, including those that depend on an estimate."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Motion(Record):
    """The motion: every segment with its given and its resulting values."""

    units: Units
    """Units of time, distance, speed and acceleration, those of a linear axis linear, and of the loads that a segment
states."""
    segments: Rows[Segment]
    """Segments in their order."""
    setpoints: Setpoints | None = None
    """Setpoints at equal steps; only if a step is stated."""
    assumptions: Rows[AssumptionEntry] | None = None
    """Assumptions about the motion; only in the answer of `moves`, other answers have those of the axis."""

    def __iter__(self) -> Iterator[Segment]:
        return iter(self.segments)

    def __len__(self) -> int:
        return len(self.segments)

    def __contains__(self, item: object, /) -> bool:
        return item in self.segments

    def __getitem__(self, key: int | str, /) -> Segment:
        return self.segments[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Segment(Record):
    """One segment."""

    law: str
    """Id of the law of motion."""
    name: str
    """Name of the law."""
    start: float | None
    """Start of the segment."""
    duration: float | None
    """Duration of the segment."""
    distance: float | None = None
    """Distance travelled, with its sign; omitted for a dwell."""
    speed: float | None = None
    """Largest speed."""
    acceleration: float | None = None
    """Largest acceleration."""
    payload: float | None = None
    """Mass in addition to those of the mechanism; omitted if no segment states a payload."""
    payload_inertia: float | None = None
    """Moment of inertia in addition to that of the mechanism; omitted if no segment states one."""
    process_force: float | None = None
    """Process force as it acts: that of the mechanism plus that of the segment; omitted if no segment states one."""
    external_torque: float | None = None
    """Torque against the positive direction as it acts: the external torque of the mechanism plus the process torque
of the segment; omitted if no segment states one."""
    recording: Recording | None = None
    """Data read from the file; only for a recorded segment."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Recording(Record):
    """Data read from the file of a recorded segment."""

    file: str
    """Name of the file as in the project."""
    encoding: TextEncoding | None = None
    """Encoding of the text; `null` for a format that is no text."""
    samples: int
    """Number of samples used."""
    first_time: float | None
    """Time of the first sample in the file, in s."""
    left_out_before: int
    """Number of samples left out before the window."""
    left_out_after: int
    """Number of samples left out after the window."""
    comments: int
    """Number of lines skipped as comments: they begin with `#` and are no rows."""
    columns: Rows[RecordedColumn]
    """Columns read."""
    unused: list[str]
    """Headings of the columns that are not used."""

    def __iter__(self) -> Iterator[RecordedColumn]:
        return iter(self.columns)

    def __len__(self) -> int:
        return len(self.columns)

    def __contains__(self, item: object, /) -> bool:
        return item in self.columns

    def __getitem__(self, key: int | str, /) -> RecordedColumn:
        return self.columns[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class RecordedColumn(Record):
    """A column of a recording."""

    role: ColumnRole
    """Role of the column."""
    name: str
    """Name in the file."""
    unit: str
    """Unit of the values."""
    unit_by: UnitBy
    """Source of the unit."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Setpoints(Record):
    """Setpoints of the motion over one cycle, its end included."""

    units: Units
    """Units of time, position, speed and acceleration."""
    every: float | None
    """Time between two rows."""
    rows: int
    """Number of rows."""
    file: str | None = None
    """File with the rows, if one was written; the lists are empty then."""
    time: list[float | None]
    """Instants from the start of the cycle."""
    position: list[float | None]
    """Position at each instant."""
    speed: list[float | None]
    """Speed at each instant."""
    acceleration: list[float | None]
    """Acceleration at each instant; where it jumps, that behind the jump."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class AxesOfSizing(Record):
    """Answers for several axes."""

    verdict: Fit
    """Worst verdict of the axes."""
    axes: Rows[Sizing]
    """Answer for each axis."""

    def __iter__(self) -> Iterator[Sizing]:
        return iter(self.axes)

    def __len__(self) -> int:
        return len(self.axes)

    def __contains__(self, item: object, /) -> bool:
        return item in self.axes

    def __getitem__(self, key: int | str, /) -> Sizing:
        return self.axes[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Judgement(Record):
    """`check`: one actuator, every check with its margin."""

    code: str | None = None
    """Ordering code of an actuator of the catalogue."""
    name: str | None = None
    """Name of the project's own actuator."""
    maker: str | None = None
    """Maker; `null` if no file states it."""
    series: str | None = None
    """Series of the maker; `null` if no file states it."""
    kind: str | None = None
    """Kind of the product: `actuator`."""
    length_mm: float | None = None
    """Length in mm; `null` if it is not stated."""
    price: str | None = None
    """Price as written; `null` if it is not stated."""
    lead_time_d: float | None = None
    """Time of delivery in days; `null` if it is not stated."""
    verdict: Fit
    """Verdict on the actuator."""
    utilisation: float | None
    """Utilisation of the governing check; 1 is the limit. `null` if it fails at a limit of zero or outside a range."""
    tightest: CheckId | None = None
    """Id of the governing check: the failing one with the largest excess, else the one with the highest utilisation.
`null` if no check has a limit."""
    mass_kg: float | None = None
    """Mass in kg, the larger one if the manual is in doubt."""
    mass_errata: list[str]
    """Ids of the errata that touch the mass."""
    on_request: list[str]
    """Names of the fields of the code that are on request only."""
    demand: Demand | None = None
    """Demand on the actuator; `null` without J_out."""
    checks: Rows[Check]
    """The checks, in a fixed order."""
    objections: list[str]
    """Requirements not met and rules violated, as text."""
    open_requirements: list[str] | None = None
    """Requirements that stay open because a datum is missing, as text; only where there are some."""
    open_questions: int
    """Number of questions that could not be answered because a datum is missing: checks without a value, and open
requirements."""
    axis: str
    """Name of the axis."""
    motion: Motion
    """Motion resulting from the project."""
    reserve: Reserve
    """Reserves of the actuator."""
    tolerance: Tolerance | None = None
    """Effect of the tolerances of the project; only if it has some."""
    assumptions: Rows[AssumptionEntry]
    """Assumptions."""

    @property
    def axes(self) -> Rows[Judgement]:
        """It as the answer of its only axis, as `AxesOfJudgement` has those of several."""
        return Rows([self])

    def __iter__(self) -> Iterator[Check]:
        return iter(self.checks)

    def __len__(self) -> int:
        return len(self.checks)

    def __contains__(self, item: object, /) -> bool:
        return item in self.checks

    def __getitem__(self, key: int | str, /) -> Check:
        return self.checks[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Reserve(Record):
    """Largest change of one quantity, all others unchanged, at which the actuator still fits (or would fit); `null` if
nothing within reach fits or everything does. Each value has four digits and is judged as stated: with it no check
fails, one step of the last digit further one does. The search proceeds in steps of 10 %, temperatures in steps of 5
K; a narrower gap between two regions that fit is not detected."""

    limits: Rows[NeededLimit] | None = None
    """Values of limits of the project, rounded to four digits on the sufficient side, with which the actuator would
fit, all together; only if nothing but these limits rejects it."""
    load_factor: float | None = None
    """Factor on all masses and moments of inertia."""
    payload_factor: float | None = None
    """Factor on the payloads of the segments."""
    cycle_time: float | None = None
    """Duration of the whole motion, run faster or slower."""
    ambient: float | None = None
    """Highest ambient temperature of those about the present one, or of the nearest ones at which the actuator fits."""
    ambient_least: float | None = None
    """Lowest ambient temperature of the same: below it a check fails, or the data of the actuator do not hold."""
    units: Units
    """Units of cycle time and ambient temperature."""
    if_estimate: list[str]
    """Names of the fields above whose value fits only if an estimate holds, `fits_if_estimate`."""
    unless_rating: list[str]
    """Names of the fields above whose value fits unless a gear rating of another manufacturer applies, `fits_if_estimate`."""
    not_checked: ReserveNotChecked | None = None
    """Checks that could not be made, for which the values do not hold; `null` if all were made that could reject the actuator, or
without a value."""
    not_sought: NotSought | None = None
    """Quantities not searched because of the cost; `null` if all were."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class NeededLimit(Record):
    """A limit of the project that would have to be changed."""

    key: str
    """Key of the limit."""
    value: float | None
    """Sufficient value."""
    unit: str
    """Unit of the value."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class ReserveNotChecked(Record):
    """Checks for which the values of a reserve do not hold: they could reject the actuator and could not be made."""

    checks: list[CheckId]
    """Checks."""
    text: str
    """Condition in words."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class NotSought(Record):
    """Quantities not searched: each step of the search would compute the load of a long recording again."""

    quantities: list[str]
    """Names of the neighbouring fields that are `null` for this reason."""
    samples: int
    """Work of each search step: recorded samples whose load is computed again, plus a quarter of the instants of
motion laws and of the loads on the flange."""
    most: int
    """Largest work permitted without `--deadline`."""
    text: str
    """Reason as text."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class AxesOfJudgement(Record):
    """Answers for several axes."""

    verdict: Fit
    """Worst verdict of the axes."""
    axes: Rows[Judgement]
    """Answer for each axis."""

    def __iter__(self) -> Iterator[Judgement]:
        return iter(self.axes)

    def __len__(self) -> int:
        return len(self.axes)

    def __contains__(self, item: object, /) -> bool:
        return item in self.axes

    def __getitem__(self, key: int | str, /) -> Judgement:
        return self.axes[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class SweepSummary(Record):
    """Summary of the answers to the rows of a table."""

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
    none_fits: Rows[MissedBy]
    """Rows for which none fits, by the governing check of the nearest miss, most first."""
    not_judged: Rows[NotJudged]
    """Rows that are not judged, by the reason, most first."""
    further: int
    """Rows with further reasons."""
    answers: Rows[SweepRow]
    """The answers of the rows; empty where a file holds them."""
    assumptions: Rows[AssumptionEntry]
    """Assumptions that hold for every row: those of the project that no column states."""

    def __iter__(self) -> Iterator[SweepRow]:
        return iter(self.answers)

    def __len__(self) -> int:
        return len(self.answers)

    def __contains__(self, item: object, /) -> bool:
        return item in self.answers

    def __getitem__(self, key: int | str, /) -> SweepRow:
        return self.answers[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class MissedBy(Record):
    """Rows that miss by a check."""

    check: str | None = None
    """The check; `null` where no actuator is of the required class."""
    title: str
    """Title of the check."""
    rows: int
    """Number of rows."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class NotJudged(Record):
    """Rows that are not judged for a reason."""

    message: str
    """The reason."""
    rows: int
    """Number of rows."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class SweepRow(Record):
    """The answer of a row."""

    row: int
    """The row, from 0."""
    fit: int | None = None
    """Number of codes that fit within every limit."""
    fit_if_estimate: int | None = None
    """Number of others that fit if an estimate holds."""
    code: str | None = None
    """The best of both."""
    utilisation: float | None = None
    """Utilisation of its governing check; where none fits that of the nearest miss."""
    tightest: CheckId | None = None
    """Identifier of this check."""
    stage_ratio: float | None = None
    """Ratio of the stage chosen among several of the project."""
    checks: Rows[SweepCheck] | None = None
    """The requested checks of the code."""
    error: str | None = None
    """Why the row is not judged."""
    labels: dict[str, str] | None = None
    """Cells of the columns that are no keys, such as `id`, by their headings; for values that the call states those of the keys."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class SweepCheck(Record):
    """Verdict and utilisation of a requested check."""

    id: CheckId
    """Identifier of the check."""
    verdict: Verdict | None = None
    """Verdict; `null` if axis or actuator do not have the check."""
    utilisation: float | None = None
    """Utilisation."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Explanations(Record):
    """`explain`: the checks of an actuator with their derivations."""

    axis: str
    """Name of the axis."""
    code: str
    """Ordering code, or name of the project's own actuator."""
    checks: Rows[Explained]
    """The requested checks."""
    assumptions: Rows[AssumptionEntry]
    """Assumptions."""

    @property
    def axes(self) -> Rows[Explanations]:
        """It as the answer of its only axis, as `AxesOfExplanations` has those of several."""
        return Rows([self])

    def __iter__(self) -> Iterator[Explained]:
        return iter(self.checks)

    def __len__(self) -> int:
        return len(self.checks)

    def __contains__(self, item: object, /) -> bool:
        return item in self.checks

    def __getitem__(self, key: int | str, /) -> Explained:
        return self.checks[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Explained(Record):
    """A check with the derivation of its value and its limit."""

    id: CheckId
    """Id of the check."""
    title: str
    """Name of the check."""
    verdict: Verdict
    """Verdict of the check. `advice` also means: within the band of an estimate."""
    value: float | None = None
    """Value demanded by the axis; may be present with `not_checked`, if only the limit is missing."""
    limit: float | None = None
    """Limit of the actuator, or limit required by the project."""
    unit: str | None = None
    """Unit of value and limit: `Nm` `1/min` `A` `V` `W` `kgm^2` `N` `mm` `h` `a` `deg` `arcmin` `arcsec` `rev` `Hz`
`degC` `1`."""
    direction: Direction
    """Required relation of the value to the limit."""
    part: Part
    """Part of the actuator concerned."""
    utilisation: float | None = None
    """Value/limit for `at_most`, limit/value for `at_least`; `null` if it has no meaning."""
    margin: bool
    """`true` if the ranking uses this utilisation; `false` for a recommendation, and for a class that is met or not."""
    at: float | None = None
    """Instant of the worst case within the cycle, in s."""
    grade: Grade | None = None
    """Grade of the figures: the worst of all inputs."""
    source: str | None = None
    """Source of the limit, then of the value, joined by `; `."""
    sources: list[str]
    """The sources as a list."""
    missing: str | None = None
    """Symbol of the missing datum, or the project key that would set the limit."""
    notes: list[str]
    """Remarks, as text."""
    errata: list[str] | None = None
    """Ids of the errata that value or limit depend on; their evidence is in `notes`. Omitted if there are none."""
    meaning: str
    """Value and limit that the check compares, as text."""
    derivation: Derivation
    """Derivation of its figures."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Derivation(Record):
    """Derivations of both sides of a check."""

    value: Node | None = None
    """Derivation of the demanded value."""
    limit: Node | None = None
    """Derivation of the limit."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Node(Record):
    """A figure and its derivation."""

    symbol: str
    """Symbol of the figure."""
    term: str | None = None
    """Meaning of the symbol; omitted if there is no term for it."""
    formula: str | None = None
    """Formula in symbols; omitted for a value that was read instead of computed."""
    figures: str | None = None
    """Formula with the values inserted."""
    value: float | None
    """Result of the formula."""
    unit: str
    """Unit of the result."""
    grade: Grade | None = None
    """Grade of the figure; `null` for the steps of a computation, which have the grade of their inputs."""
    source: str
    """Source of the figure: cell, equation, model or key."""
    errata: Rows[CitedErratum] | None = None
    """Errata that the figure depends on; omitted if there are none."""
    repeated: bool | None = None
    """`true` if the figure is derived above already; omitted otherwise."""
    operands: Rows[Node] | None = None
    """Inputs of the figure; omitted if there are none."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class CitedErratum(Record):
    """An erratum that a figure depends on."""

    id: str
    """Id of the erratum."""
    evidence: str
    """Text of the manual, value used, and reason."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class AxesOfExplanations(Record):
    """Answers for several axes."""

    verdict: Fit
    """Worst verdict of the axes."""
    axes: Rows[Explanations]
    """Answer for each axis."""

    def __iter__(self) -> Iterator[Explanations]:
        return iter(self.axes)

    def __len__(self) -> int:
        return len(self.axes)

    def __contains__(self, item: object, /) -> bool:
        return item in self.axes

    def __getitem__(self, key: int | str, /) -> Explanations:
        return self.axes[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Simulation(Record):
    """`simulate`: behaviour of the digital twin of an axis."""

    axis: str
    """Name of the axis."""
    code: str
    """Ordering code, or the name of the project's own actuator."""
    scenario: ScenarioId
    """Id of the scenario."""
    title: str
    """Name of the scenario."""
    at: float | None = None
    """Instant of the event \\[s\\]; `null` if the whole run is the scenario."""
    instant: WorstInstant | None = None
    """Choice of this instant as the worst one; `null` if it is stated or the scenario has none."""
    reaction: Reaction
    """Reaction of the servo drive to a stop and to its own faults."""
    cycles: int
    """Number of cycles."""
    seed: int
    """Seed of phases and noise."""
    time: float | None
    """Simulated time \\[s\\]."""
    steps: int
    """Number of steps of the solver."""
    step: float | None
    """Duration of one step \\[µs\\]."""
    ambient: float | None
    """Ambient temperature \\[°C\\]."""
    start: list[float | None]
    """Temperatures of winding and housing at the start \\[°C\\]."""
    summary: Figures
    """Figures of the run."""
    averaged: Figures | None = None
    """Figures of an operation over days with the mean losses of the cycle; `null` if no days are requested."""
    days: Rows[DayOfOperation]
    """Temperatures over the first and the last day of this operation; empty if no days are requested."""
    verdicts: Rows[SimulatedVerdict]
    """Figures with a limit."""
    events: Rows[SimulatedEvent]
    """Events in chronological order."""
    encoder_failure: EncoderFailure | None = None
    """Failure of the encoder; `null` if there is none."""
    comparison: Rows[Compared]
    """Results of sizing and twin with the reason for the difference; for the cycle only."""
    loops: Rows[ControlLoop]
    """Control loops, the innermost first."""
    gains: Figures
    """Gains in use."""
    gains_by_rule: bool
    """`true` if the gains follow from the rule; `false` if the project states some."""
    parameters: Rows[ModelParameter]
    """Parameters of the model."""
    notes: list[str]
    """Choices and omissions of the model, as text."""
    assumptions: Rows[AssumptionEntry]
    """Assumptions of the axis."""
    trace: str | None = None
    """File of the recorded signals; `null` if none was written."""

    @property
    def axes(self) -> Rows[Simulation]:
        """It as the answer of its only axis, as `AxesOfSimulation` has those of several."""
        return Rows([self])

    def __iter__(self) -> Iterator[SimulatedVerdict]:
        return iter(self.verdicts)

    def __len__(self) -> int:
        return len(self.verdicts)

    def __contains__(self, item: object, /) -> bool:
        return item in self.verdicts

    def __getitem__(self, key: int | str, /) -> SimulatedVerdict:
        return self.verdicts[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class WorstInstant(Record):
    """Choice of the worst instant of an event."""

    effect: EventEffect
    """Id of the effect by which the worst instant is chosen."""
    examined: int
    """Number of instants examined."""
    limited: bool
    """`true` if the limit of the steps left further instants out."""
    directions: Rows[WorstOfDirection]
    """Worst instant of every direction of motion, the chosen one first."""
    overruns: Rows[EndOverrun]
    """Farthest ways beyond the ends of the motion; empty if the axis stays between them or has none."""
    title: str
    """Choice as text."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class WorstOfDirection(Record):
    """Worst instant of a direction of motion."""

    direction: MotionDirection
    """Direction of the output at the instant."""
    at: float | None
    """Instant \\[s\\]."""
    value: float | None
    """Effect of the event at this instant."""
    unit: str
    """Unit of the effect."""
    rests: bool
    """`true` if the axis comes to rest within two seconds, or if the event does not stop it."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class EndOverrun(Record):
    """Farthest way beyond an end of the motion after an event."""

    end: MotionDirection
    """Direction of the output in which the end is passed."""
    at: float | None
    """Instant of the event \\[s\\]."""
    value: float | None
    """Distance of the farthest position from the end."""
    unit: str
    """Unit of the distance: mm along a linear axis, else degrees."""
    rests: bool
    """The axis comes to rest within the examined time."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Figure(Record):
    """A figure with its unit."""

    title: str
    """Name of the figure."""
    value: float | None = None
    """Value; `null` if there is none."""
    unit: str
    """Unit of the value."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class DayOfOperation(Record):
    """Temperatures over a day of operation."""

    day: int
    """Number of the day, from one."""
    hours: Rows[HourOfOperation]
    """Temperatures at the beginning of the day and at the end of each hour."""

    def __iter__(self) -> Iterator[HourOfOperation]:
        return iter(self.hours)

    def __len__(self) -> int:
        return len(self.hours)

    def __contains__(self, item: object, /) -> bool:
        return item in self.hours

    def __getitem__(self, key: int | str, /) -> HourOfOperation:
        return self.hours[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class HourOfOperation(Record):
    """Temperatures at the end of an hour."""

    hour: int
    """Time since the beginning of the day \\[h\\]; the operation begins at zero."""
    winding: float | None
    """Mean temperature of the winding over a cycle \\[°C\\]."""
    winding_peak: float | None
    """Highest temperature of the winding in this hour, within a cycle \\[°C\\]."""
    housing: float | None
    """Temperature of the housing \\[°C\\]."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class SimulatedVerdict(Record):
    """A figure with its limit."""

    id: RunCheckId
    """Identifier."""
    title: str
    """Name of the figure."""
    verdict: Verdict
    """Verdict on the limit."""
    value: float | None = None
    """Value of the figure."""
    limit: float | None = None
    """Largest permitted value."""
    unit: str
    """Unit of value and limit."""
    grade: Grade | None = None
    """Grade of the limit."""
    source: str | None = None
    """Source of the limit."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class SimulatedEvent(Record):
    """An event of the run."""

    time: float | None
    """Instant \\[s\\]."""
    event: EventKind
    """Kind of event."""
    title: str
    """Name of the event."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class EncoderFailure(Record):
    """A failing encoder, and its detection by the servo drive."""

    failure: str
    """Kind of failure: a failure of the scenario, or `battery`."""
    finding: str | None = None
    """Kind of detection by the servo drive; `null` if it is not detected."""
    after: float | None = None
    """Time until detection \\[ms\\]."""
    error: float | None
    """Measured minus true angle at the output, at detection, else at the end \\[°\\]."""
    title: str
    """Failure and detection as text."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Compared(Record):
    """A figure of the sizing next to that of the twin."""

    id: CheckId
    """Id of the check of the sizing."""
    title: str
    """Name of the check."""
    sizing: float | None
    """Result of the sizing."""
    twin: float | None
    """Result of the twin."""
    unit: str
    """Unit of both results."""
    why: str
    """Reason for the difference, as text."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class ControlLoop(Record):
    """A control loop with its margins."""

    id: Loop
    """Id of the loop."""
    title: str
    """Name of the loop."""
    crossover: float | None = None
    """Frequency at which the open loop has magnitude one \\[Hz\\]."""
    phase_margin: float | None = None
    """Phase margin \\[°\\]."""
    gain_margin: float | None = None
    """Gain margin \\[dB\\]."""
    bandwidth: float | None = None
    """Frequency up to which the loop follows within 3 dB \\[Hz\\]."""
    stable: bool
    """`true` if the loop is stable."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class ModelParameter(Record):
    """A parameter of the model."""

    key: str
    """Key of the parameter in the table `[twin.measured]`."""
    title: str
    """Name of the parameter."""
    value: float | None = None
    """Value; `null` if it is unknown."""
    unit: str
    """Unit of the value."""
    grade: Grade | None = None
    """Grade of the value."""
    source: str | None = None
    """Source of the value."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class AxesOfSimulation(Record):
    """Answers for several axes."""

    verdict: Fit
    """Worst verdict of the axes."""
    axes: Rows[Simulation]
    """Answer for each axis."""

    def __iter__(self) -> Iterator[Simulation]:
        return iter(self.axes)

    def __len__(self) -> int:
        return len(self.axes)

    def __contains__(self, item: object, /) -> bool:
        return item in self.axes

    def __getitem__(self, key: int | str, /) -> Simulation:
        return self.axes[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Identification(Record):
    """Parameters of load and motor estimated from a recorded run."""

    axis: str
    """Name of the axis."""
    code: str
    """Ordering code, or the name of the project's own actuator."""
    samples: int
    """Rows of the run."""
    estimates: Rows[Identified95]
    """Estimates that the run separates from each other."""
    open: Rows[LeftOpen]
    """Parameters without an estimate."""
    signals: Rows[SignalDatum]
    """Zeros, delays and filters of the signals, which the estimates take into account."""
    doubts: Rows[Doubted]
    """Signals that seem to have another unit, sign or side than their columns; while there are any, the estimates are not those of the
axis, `overrides` is empty, and the exit status is 1."""
    overrides: str
    """Lines of the project file with the measured values of actuator and load."""
    notes: list[str]
    """Method, assumptions and what is left out, in words."""

    def __iter__(self) -> Iterator[Identified95]:
        return iter(self.estimates)

    def __len__(self) -> int:
        return len(self.estimates)

    def __contains__(self, item: object, /) -> bool:
        return item in self.estimates

    def __getitem__(self, key: int | str, /) -> Identified95:
        return self.estimates[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Identified95(Record):
    """An estimate with its interval."""

    id: str
    """Identifier."""
    title: str
    """Title."""
    value: float | None
    """The value."""
    half_width: float | None
    """Half the interval that holds the true value in 95 of 100 runs."""
    unit: str
    """Unit of the value."""
    stated: float | None = None
    """Value of project or table; `null` where they have none."""
    known: bool
    """The interval is apart from zero, and narrow enough for a line of the project."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class LeftOpen(Record):
    """A parameter that a run does not determine."""

    id: str
    """Identifier."""
    title: str
    """Title."""
    reason: str
    """Reason, in words."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class SignalDatum(Record):
    """A zero, a delay or a filter of a signal of the run."""

    id: str
    """Identifier."""
    column: str
    """Heading of the column."""
    title: str
    """Title."""
    value: float | None
    """The value."""
    half_width: float | None
    """Half the interval that holds the true value in 95 of 100 runs."""
    unit: str
    """Unit of the value."""
    significant: bool
    """The value is apart from zero."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Doubted(Record):
    """A signal that does not fit its column."""

    id: str
    """Identifier of the convention that the signal seems to have."""
    column: str
    """Heading of the column."""
    text: str
    """Observation and advice, in words."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Comparison(Record):
    """`compare`: several actuators for the same axis."""

    axis: str
    """Name of the axis."""
    candidates: Rows[Head]
    """The actuators, in the requested order."""
    better: int | None = None
    """Index of the actuator with the best rank, from 0."""
    demand: Rows[DatumRow]
    """Demand on each actuator."""
    data: Rows[DatumRow]
    """Data of each actuator."""
    errata: Rows[CitedErratum]
    """Errata that touch the data."""
    checks: Rows[CheckRow]
    """Comparison check by check."""
    assumptions: Rows[AssumptionEntry]
    """Assumptions of the axis."""

    @property
    def axes(self) -> Rows[Comparison]:
        """It as the answer of its only axis, as `AxesOfComparison` has those of several."""
        return Rows([self])

    def __iter__(self) -> Iterator[CheckRow]:
        return iter(self.checks)

    def __len__(self) -> int:
        return len(self.checks)

    def __contains__(self, item: object, /) -> bool:
        return item in self.checks

    def __getitem__(self, key: int | str, /) -> CheckRow:
        return self.checks[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Head(Record):
    """An actuator in a comparison."""

    code: str
    """Ordering code, or name of the project's own actuator."""
    verdict: Fit
    """Verdict on the actuator."""
    utilisation: float | None
    """Utilisation of the governing check; 1 is the limit."""
    tightest: CheckId | None = None
    """Id of the governing check."""
    open_questions: int
    """Number of questions that could not be answered because a datum is missing."""
    objections: list[str]
    """Requirements not met and rules violated, as text."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class DatumRow(Record):
    """A figure for each actuator."""

    symbol: str
    """Symbol of the figure."""
    unit: str
    """Unit of the values."""
    values: list[float | None]
    """One value per actuator, `null` if it has none."""
    errata: list[list[str]]
    """Ids of the errata that touch the value of each actuator."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class CheckRow(Record):
    """A check for each actuator."""

    id: CheckId
    """Id of the check."""
    title: str
    """Name of the check."""
    better: int | None = None
    """Index of the better actuator, from 0; `null` if none is better."""
    answers: list[Check | None]
    """Results per actuator, `null` if an actuator has no such check."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class AxesOfComparison(Record):
    """Answers for several axes."""

    verdict: Fit
    """Worst verdict of the axes."""
    axes: Rows[Comparison]
    """Answer for each axis."""

    def __iter__(self) -> Iterator[Comparison]:
        return iter(self.axes)

    def __len__(self) -> int:
        return len(self.axes)

    def __contains__(self, item: object, /) -> bool:
        return item in self.axes

    def __getitem__(self, key: int | str, /) -> Comparison:
        return self.axes[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Difference(Record):
    """`diff`: effect of another revision of a project on an actuator."""

    axis: str
    """Name of the axis."""
    code: str
    """Ordering code, or name of the project's own actuator."""
    verdict: Fit
    """Verdict in the second project."""
    before: Head
    """Result in the first project."""
    after: Head
    """Result in the second project."""
    best_before: str | None = None
    """Best ordering code for the first project."""
    best_after: str | None = None
    """Best ordering code for the second project."""
    demand: Rows[DatumChange]
    """Demand before and after."""
    checks: Rows[CheckChange]
    """Comparison check by check."""
    inputs: Rows[InputChange]
    """Values of the project files that differ."""

    @property
    def axes(self) -> Rows[Difference]:
        """It as the answer of its only axis, as `AxesOfDifference` has those of several."""
        return Rows([self])

    def __iter__(self) -> Iterator[CheckChange]:
        return iter(self.checks)

    def __len__(self) -> int:
        return len(self.checks)

    def __contains__(self, item: object, /) -> bool:
        return item in self.checks

    def __getitem__(self, key: int | str, /) -> CheckChange:
        return self.checks[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class DatumChange(Record):
    """A figure before and after."""

    symbol: str
    """Symbol of the figure."""
    unit: str
    """Unit of the values."""
    before: float | None = None
    """Value in the first project."""
    after: float | None = None
    """Value in the second project."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class CheckChange(Record):
    """A check before and after."""

    id: CheckId
    """Id of the check."""
    title: str
    """Name of the check."""
    changed: bool
    """`true` if any part of the result differs."""
    change: float | None = None
    """Difference of the utilisations."""
    before: Check | None = None
    """Result in the first project."""
    after: Check | None = None
    """Result in the second project."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class InputChange(Record):
    """A value that differs between two project files."""

    path: str
    """Key of the value."""
    old: str | None = None
    """Value as written in the first file; `null` if it is missing there."""
    new: str | None = None
    """Value as written in the second file; `null` if it is missing there."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class AxesOfDifference(Record):
    """Answers for several axes."""

    verdict: Fit
    """Worst verdict of the axes."""
    axes: Rows[Difference]
    """Answer for each axis."""

    def __iter__(self) -> Iterator[Difference]:
        return iter(self.axes)

    def __len__(self) -> int:
        return len(self.axes)

    def __contains__(self, item: object, /) -> bool:
        return item in self.axes

    def __getitem__(self, key: int | str, /) -> Difference:
        return self.axes[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Table(Tabular):
    """`export --table`: one table of the results."""

    table: str
    """Name of the table."""
    title: str
    """Title of the table."""
    about: str
    """Content of the table."""
    columns: Rows[TableColumn]
    """Descriptions of the columns."""
    rows: list[TableRow]
    """One record per row, by the names of the columns."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class TableColumn(Record):
    """A column of a table."""

    name: str
    """Name of the column in the rows."""
    title: str
    """Heading of the column."""
    kind: ColumnKind
    """Type of the values."""
    unit: str | None = None
    """Unit of the numbers; `null` for text, and if another column has the unit of each row."""
    about: str
    """Meaning and source of the values."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class CodeReading(Record):
    """`code parse`: a code with every field explained."""

    valid: bool
    """`true` in every such answer."""
    code: str
    """The canonical spelling."""
    canonical: bool
    """`true` if the text was already in canonical spelling."""
    availability: Availability
    """Availability of the code."""
    on_request: list[str]
    """Names of the fields that are on request only."""
    fields: Rows[CodeField]
    """The nine fields, in their order."""
    notes: list[str]
    """Remarks on data that the tables of the manual do not cover."""

    def __iter__(self) -> Iterator[CodeField]:
        return iter(self.fields)

    def __len__(self) -> int:
        return len(self.fields)

    def __contains__(self, item: object, /) -> bool:
        return item in self.fields

    def __getitem__(self, key: int | str, /) -> CodeField:
        return self.fields[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class CodeField(Record):
    """A field of a code."""

    field: Field
    """Id of the field."""
    name: str
    """Name of the field."""
    token: str
    """Word of the field; empty if it is left out."""
    meaning: str
    """Meaning of the word."""
    span: list[int] | None = None
    """Place in the given text, in bytes: start and exclusive end; `null` if the field is left out."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class ListedCode(Record):
    """`code list`: a valid code."""

    code: str
    """Ordering code."""
    availability: Availability
    """Availability of the code."""
    on_request: list[str]
    """Names of the fields that are on request only."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Completion(Record):
    """`code complete`: open fields of a partial code."""

    fields: Rows[OpenField]
    """The fields except series and special design."""
    codes: Rows[ListedCode]
    """Resulting codes."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class OpenField(Record):
    """A field of a partial code."""

    field: Field
    """Id of the field."""
    name: str
    """Name of the field."""
    choices: Rows[Choice]
    """Permitted words."""

    def __iter__(self) -> Iterator[Choice]:
        return iter(self.choices)

    def __len__(self) -> int:
        return len(self.choices)

    def __contains__(self, item: object, /) -> bool:
        return item in self.choices

    def __getitem__(self, key: int | str, /) -> Choice:
        return self.choices[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Choice(Record):
    """A permitted word of a field."""

    token: str
    """Word; empty if the field may be left out."""
    availability: Availability
    """Availability of the field in at least one code with this word."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Sheet(Record):
    """`data`: the values that the manual states for an actuator."""

    code: str
    """Ordering code."""
    notes: list[str]
    """Remarks on data not covered by the tables, as text."""
    sections: Rows[SheetSection]
    """One section per table, in the order of the manual."""

    def __iter__(self) -> Iterator[SheetSection]:
        return iter(self.sections)

    def __len__(self) -> int:
        return len(self.sections)

    def __contains__(self, item: object, /) -> bool:
        return item in self.sections

    def __getitem__(self, key: int | str, /) -> SheetSection:
        return self.sections[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class SheetSection(Record):
    """Values of one table of the manual."""

    table: str
    """Number of the table."""
    title: str
    """Title of the table."""
    values: Rows[SheetValue]
    """Values for this code."""
    notices: Rows[SheetNote]
    """Notices on the table as a whole."""
    errata: list[str]
    """Ids of the errata that concern the table instead of a single cell."""

    def __iter__(self) -> Iterator[SheetValue]:
        return iter(self.values)

    def __len__(self) -> int:
        return len(self.values)

    def __contains__(self, item: object, /) -> bool:
        return item in self.values

    def __getitem__(self, key: int | str, /) -> SheetValue:
        return self.values[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class SheetValue(Record):
    """A value stated in the manual."""

    symbol: str
    """Symbol in ASCII."""
    name: str
    """Technical term."""
    condition: str
    """Further condition of the row."""
    printed: str
    """Text of the cell in the manual."""
    value: TableCell
    """Value after errata in the unit of the manual: a number or a text; `null` if the manual states none for this
code."""
    unit: str
    """Unit of the manual in ASCII; empty for pure numbers and texts."""
    table: str
    """Number of the table."""
    grade: Grade
    """Grade of the value."""
    errata: list[str]
    """Ids of the errata that concern the value."""
    checks_use: float | None = None
    """Value used by checks if it is not `value`."""
    text: str | None = None
    """Text of the value in the language of the answer; `null` for a number."""
    notes: Rows[SheetNote]
    """Notes on the row."""

    def __iter__(self) -> Iterator[SheetNote]:
        return iter(self.notes)

    def __len__(self) -> int:
        return len(self.notes)

    def __contains__(self, item: object, /) -> bool:
        return item in self.notes

    def __getitem__(self, key: int | str, /) -> SheetNote:
        return self.notes[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class SheetNote(Record):
    """A note on a value or a table."""

    mark: str | None = None
    """Mark in the manual; `null` if it has none."""
    by: NoteBy
    """Author of the note."""
    text: str
    """Text of the note in the project's own words."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Wiring(Record):
    """`wiring`: connections of an actuator."""

    code: str
    """Ordering code."""
    connectors: Rows[Connector]
    """Connectors of the actuator."""
    cables: Rows[Cable]
    """Cables listed in the manual."""
    not_available: Rows[NotAvailable]
    """Parts that do not exist for this code, or not in the manual."""
    notes: Rows[WiringNote]
    """Further statements of the tables and their notes."""
    rules: Rows[Fact]
    """Rules and hazards, the gravest first."""
    voltage_drop: VoltageDrops | None = None
    """Voltage drop on the wires; `null` unless a length was given."""
    errata: list[str]
    """Ids of the errata that concern the data shown."""

    def __iter__(self) -> Iterator[Connector]:
        return iter(self.connectors)

    def __len__(self) -> int:
        return len(self.connectors)

    def __contains__(self, item: object, /) -> bool:
        return item in self.connectors

    def __getitem__(self, key: int | str, /) -> Connector:
        return self.connectors[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Connector(Record):
    """A connector of the actuator."""

    role: ConnectorRole
    """Purpose of the connector."""
    type: str
    """Poles and thread as in the manual."""
    poles: int
    """Number of poles."""
    thread: str
    """Thread."""
    exit: ConnectorExit | None = None
    """Location: at the end of a cable, in the housing; `null` if not stated."""
    material_number: str | None = None
    """Material number of the mating connector; `null` if the manual states none."""
    outer_diameter: str | None = None
    """Outer diameter of the mating connector as in the manual; `null` if it states none."""
    length: str | None = None
    """Length of the mating connector as in the manual; `null` if it states none."""
    unit: str
    """Unit of diameter and length."""
    pins: Rows[ConnectorPin]
    """Pins; empty if the manual states none for this code."""
    ambiguous: Rows[AmbiguousColour]
    """Colours shared by several wires: identify the wire by its pin."""
    tables: list[str]
    """Tables of the connector and of its pins."""

    def __iter__(self) -> Iterator[ConnectorPin]:
        return iter(self.pins)

    def __len__(self) -> int:
        return len(self.pins)

    def __contains__(self, item: object, /) -> bool:
        return item in self.pins

    def __getitem__(self, key: int | str, /) -> ConnectorPin:
        return self.pins[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class ConnectorPin(Record):
    """A pin of a connector."""

    pin: str
    """Number of the pin, or `PE`."""
    joined_with: str | None = None
    """Pin named in brackets in the manual: both belong to one wire."""
    signal: str
    """Signal as in the manual; `-` if nothing is connected."""
    connected: bool
    """`true` if a wire is connected."""
    group: SignalGroup | None = None
    """Kind of the signal; `null` if nothing is connected."""
    colour: str | None = None
    """Colour of the wire, in the requested language; `null` if the manual states none."""
    meaning: str
    """Meaning of the signal."""
    source: str
    """Cell that states the signal; for an empty field its table."""
    grade: Grade
    """Grade of the statement."""
    errata: list[str]
    """Ids of the errata that concern the pin."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class AmbiguousColour(Record):
    """A colour shared by several wires."""

    colour: str
    """Name of the colour."""
    pins: list[str]
    """Pins whose wires have the colour."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Cable(Record):
    """A cable."""

    role: CableRole
    """Parts connected by the cable."""
    material_number: str
    """Material number."""
    length_m: float | None = None
    """Length; `null` if another manufacturer encodes it in letters of the material number."""
    length_code: str | None = None
    """Letters of the material number that encode the length; else `null`."""
    for_: str
    """Device at the other end."""
    drive: CableFor
    """Id of that device."""
    table: str
    """Table that lists the cable."""
    source: str
    """Cell that lists the cable."""
    errata: list[str]
    """Ids of the errata that concern the material number."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class NotAvailable(Record):
    """A part that does not exist."""

    id: str
    """Id of the part."""
    text: str
    """Name of the part and reason."""
    table: str
    """Table that shows it."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class WiringNote(Record):
    """A statement of the notes of a table."""

    text: str
    """Text of the note."""
    by: NoteBy
    """Author of the note."""
    table: str | None = None
    """Table concerned; `null` for several."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Fact(Record):
    """A hazard, a rule or a limit, in the project's own words."""

    id: str
    """Id of the fact."""
    signal: Signal | None = None
    """Signal word of ISO 3864-2 and ANSI Z535.6; `null` for a plain statement."""
    step: Step | None = None
    """Step of the work to which it applies; `null` if it always applies."""
    text: str
    """Text of the fact."""
    values: Rows[FactValue]
    """Figures in the text."""
    source: str
    """Source of the fact."""
    grade: Grade
    """Grade of the fact."""

    def __iter__(self) -> Iterator[FactValue]:
        return iter(self.values)

    def __len__(self) -> int:
        return len(self.values)

    def __contains__(self, item: object, /) -> bool:
        return item in self.values

    def __getitem__(self, key: int | str, /) -> FactValue:
        return self.values[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class FactValue(Record):
    """A figure of a fact."""

    id: str | None = None
    """Id among several figures; `null` for the only one."""
    number: float | None
    """Value of the figure."""
    unit: str
    """Unit in ASCII; empty for pure numbers."""
    bound: Bound
    """Kind of bound."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class VoltageDrops(Record):
    """Voltage drop on the wires of a cable."""

    length_m: float | None
    """Length of the cable."""
    cross_section_mm2: float | None = None
    """Cross-section of a wire; `null` if none was given."""
    circuits: Rows[VoltageDrop]
    """The circuits."""
    assumptions: str
    """Assumptions, as text."""
    resistivity_source: str
    """Source of the resistivity of copper."""

    def __iter__(self) -> Iterator[VoltageDrop]:
        return iter(self.circuits)

    def __len__(self) -> int:
        return len(self.circuits)

    def __contains__(self, item: object, /) -> bool:
        return item in self.circuits

    def __getitem__(self, key: int | str, /) -> VoltageDrop:
        return self.circuits[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class VoltageDrop(Record):
    """Voltage drop in one circuit, outward and return wire."""

    circuit: Circuit
    """Id of the circuit."""
    name: str
    """Name of the circuit."""
    current_a: float | None
    """Current."""
    current_source: str
    """Source of the current."""
    nominal_v: float | None = None
    """Voltage of the supply; `null` if the manual states none."""
    least_v: float | None = None
    """Minimum voltage at the load; `null` if the manual states none."""
    voltage_source: str
    """Source of the voltages."""
    loss_20_degc_v: float | None = None
    """Voltage drop at 20 °C; `null` without a cross-section."""
    loss_70_degc_v: float | None = None
    """Voltage drop at 70 °C; `null` without a cross-section."""
    needed_v: float | None = None
    """Supply voltage required for the minimum voltage at the load on a warm wire; `null` if unknown."""
    cross_section_min_mm2: float | None = None
    """Smallest cross-section at 70 °C; `null` if the manual states no limit."""
    verdict: Verdict
    """Verdict on the minimum voltage."""
    reason: str
    """Reason why it fails or is not checked; empty if it passes."""
    sense_lines: bool
    """`true` if the connector has sense lines."""
    grade: Grade
    """Grade of the voltage drop."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class WiringCheck(Record):
    """`wiring --check`: comparison of a pin list with the manual."""

    code: str
    """Ordering code."""
    agrees: bool
    """`true` if the findings are advice only."""
    rows: int
    """Number of rows in the list."""
    agreeing: int
    """Number of rows that agree with the manual."""
    findings: Rows[WiringFinding]
    """Differences by line."""

    def __iter__(self) -> Iterator[WiringFinding]:
        return iter(self.findings)

    def __len__(self) -> int:
        return len(self.findings)

    def __contains__(self, item: object, /) -> bool:
        return item in self.findings

    def __getitem__(self, key: int | str, /) -> WiringFinding:
        return self.findings[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class WiringFinding(Record):
    """A difference between list and manual."""

    id: str
    """Id of the finding."""
    severity: Severity
    """Severity of the finding."""
    connector: ConnectorRole
    """Connector concerned."""
    line: int | None = None
    """Line of the list; `null` if the finding concerns a missing entry."""
    pin: str | None = None
    """Pin; `null` if the finding concerns the connector."""
    expected: str | None = None
    """Value in the manual; `null` if the finding concerns the connector or a pin that does not exist."""
    message: str
    """Description of the difference."""
    action: str
    """Action to take."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Encoder(Record):
    """`encoder`: output of the encoders of a code at an angle."""

    code: str
    """Ordering code."""
    feedback: str
    """Motor encoder."""
    seed: int | None = None
    """Seed of the deviation; `null` if encoders measure the true angle."""
    connector: ConnectorRole
    """Connector of the encoder."""
    type_printed: str | None = None
    """Manufacturer's name of the encoder, as in the manual."""
    shaft: EncoderShaft
    """Shaft of the encoder."""
    words: Rows[EncoderWord]
    """Words sent; empty without a serial interface."""
    signals: dict[str, EncoderSignal]
    """Signals by name."""
    carrier: EncoderCarrier | None = None
    """Two periods of the excitation with the windings, while the shaft turns at its speed; `null` unless it is a
resolver."""
    table_of_pins: str | None = None
    """Table of the pins."""
    output_encoder: EncoderState | None = None
    """Output of the output encoder, option EC; `null` without it."""
    decoded: DecodedWord | None = None
    """Result of `decode`; `null` if no word was given."""
    assumptions: Rows[EncoderAssumption]
    """Assumptions of the simulation on points that the manual leaves open."""
    notes: list[str]
    """Remarks on the position."""
    rules: Rows[Fact]
    """Rules of the manual on direction and battery."""
    errata: list[str]
    """Errata that concern the data."""
    trace: str | None = None
    """File of the trace; `null` if none was written."""

    def __iter__(self) -> Iterator[EncoderWord]:
        return iter(self.words)

    def __len__(self) -> int:
        return len(self.words)

    def __contains__(self, item: object, /) -> bool:
        return item in self.words

    def __getitem__(self, key: int | str, /) -> EncoderWord:
        return self.words[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class EncoderShaft(Record):
    """The shaft of an encoder."""

    turns: int
    """Whole turns."""
    angle_deg: float | None
    """Angle within the turn \\[deg\\]."""
    speed_per_min: float | None
    """Speed \\[1/min\\]."""
    seen_deg: float | None
    """Angle measured by the encoder \\[deg\\]."""
    accuracy_arcsec: float | None = None
    """Largest deviation to either side \\[arcsec\\]; `null` if the manual states none."""
    absolute_turns: int | None = None
    """Number of turns after which the absolute position repeats; `null` without one."""
    turns_valid: bool | None = None
    """`true` if the count of turns is reliable; `null` if none is sent."""
    increments: int | None = None
    """Whole steps since zero: interpolated to 8 bit, or every edge; `null` for a resolver."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class EncoderWord(Record):
    """A word of a serial interface."""

    name: str
    """Kind of word: `endat_2_2_position`, `endat_2_1_position`, `ssi_position`."""
    title: str
    """Kind of word as text."""
    protocol: EncoderProtocol
    """Protocol of the word."""
    bits: str
    """Bits in the order sent."""
    crc: str | None = None
    """Checksum; `null` if it has none."""
    command: str | None = None
    """Mode command in the order sent; `null` if none is sent."""
    fields: Rows[WordField]
    """Fields in the order sent."""
    clocks_before: int
    """Number of clock periods of a transmission before its first bit, in a trace."""
    clock_khz: float | None
    """Clock frequency of a trace \\[kHz\\]."""
    recovery_us: list[float | None]
    """Shortest and longest time until the data line is at rest again after the word \\[us\\]."""
    calculation_us: float | None = None
    """Longest time until the position is ready \\[us\\]; `null` if unknown."""

    def __iter__(self) -> Iterator[WordField]:
        return iter(self.fields)

    def __len__(self) -> int:
        return len(self.fields)

    def __contains__(self, item: object, /) -> bool:
        return item in self.fields

    def __getitem__(self, key: int | str, /) -> WordField:
        return self.fields[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class WordField(Record):
    """A field of a word."""

    name: str
    """Kind of field: `start`, `error_1`, `error_2`, `position`, `turns`, `step`, `head`, `value`, `crc`, or a mode
command."""
    title: str
    """Kind of field as text."""
    first: int
    """Index of the first bit, from zero."""
    bits: str
    """Bits in the order sent."""
    value: int
    """Value of the field."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class EncoderSignal(Record):
    """A signal of an encoder."""

    meaning: str
    """Meaning of the signal."""
    pins: Rows[EncoderPin]
    """Pins, plus end first."""
    form: SignalForm
    """Representation of the value."""
    value: float | None = None
    """Value; `null` if it does not depend on the angle."""
    unit: str
    """Unit of the value: `V`, or `1` for a level and a fraction of an amplitude."""
    level_v: float | None = None
    """Nominal level peak to peak \\[V\\]; `null` if the manual states none."""
    level_bounds_v: list[float | None] | None = None
    """Lowest and highest level peak to peak \\[V\\]; `null` if the manual states no tolerance."""
    periods_per_turn: int | None = None
    """Periods per turn; `null` if it does not depend on the angle."""
    source: str
    """Source: the table of its level or its lines."""
    errata: list[str]
    """Ids of the errata that concern the value."""
    curve: EncoderCurve | None = None
    """Values over the angle; `null` if it does not depend on the angle."""

    def __iter__(self) -> Iterator[EncoderPin]:
        return iter(self.pins)

    def __len__(self) -> int:
        return len(self.pins)

    def __contains__(self, item: object, /) -> bool:
        return item in self.pins

    def __getitem__(self, key: int | str, /) -> EncoderPin:
        return self.pins[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class EncoderPin(Record):
    """A pin of a signal."""

    pin: str
    """Number of the pin."""
    signal: str
    """Signal as in the manual."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class EncoderCurve(Record):
    """A signal over the angle of its shaft."""

    offset_deg: list[float | None]
    """Angles relative to the position of the shaft \\[deg\\]."""
    value: list[float | None]
    """Values at these angles."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class EncoderCarrier(Record):
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


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class EncoderState(Record):
    """Output of one encoder."""

    connector: ConnectorRole
    """Connector of the encoder."""
    type_printed: str | None = None
    """Manufacturer's name of the encoder, as in the manual."""
    shaft: EncoderShaft
    """Shaft of the encoder."""
    words: Rows[EncoderWord]
    """Words sent; empty without a serial interface."""
    signals: dict[str, EncoderSignal]
    """Signals by name."""
    carrier: EncoderCarrier | None = None
    """Two periods of the excitation with the windings, while the shaft turns at its speed; `null` unless it is a
resolver."""
    table_of_pins: str | None = None
    """Table of the pins."""

    def __iter__(self) -> Iterator[EncoderWord]:
        return iter(self.words)

    def __len__(self) -> int:
        return len(self.words)

    def __contains__(self, item: object, /) -> bool:
        return item in self.words

    def __getitem__(self, key: int | str, /) -> EncoderWord:
        return self.words[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class DecodedWord(Record):
    """A decoded word."""

    name: str | None = None
    """Kind of word by its length; `null` if no word of the encoder has it."""
    title: str | None = None
    """Kind of word as text."""
    connector: ConnectorRole | None = None
    """Connector of the encoder that sends such words."""
    bits: str
    """Bits of the word."""
    valid: bool
    """`true` if the word has no fault."""
    fields: Rows[WordField]
    """Fields; empty if the length is wrong."""
    turns: int | None = None
    """Turns; `null` if the word is wrong or no position."""
    angle_deg: float | None = None
    """Angle within the turn \\[deg\\]; `null` if the word is wrong or no position."""
    encoder_error: bool | None = None
    """`true` if the encoder reports an error; `null` if the word is wrong or has no error bit."""
    faults: Rows[WordFault]
    """Faults of the word."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class WordFault(Record):
    """A fault of a word."""

    id: str
    """Kind of fault: `length`, `start`, `error_bits_alike`, `crc`, `command`, `encoder_error`."""
    message: str
    """Description of the fault."""
    hint: str | None = None
    """Point to check."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class EncoderAssumption(Record):
    """An assumption on a point that the manual leaves open."""

    id: EncoderAssumed
    """Id of the assumption."""
    text: str
    """Assumption as text, with its basis."""
    grade: Grade
    """Grade of the assumption."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Errata(Record):
    """`errata`: the requested errata."""

    about: str | None = None
    """Subject of the query: a code, a table, an id; `null` for all errata."""
    errata: Rows[Erratum]
    """Errata in the order of the data."""

    def __iter__(self) -> Iterator[Erratum]:
        return iter(self.errata)

    def __len__(self) -> int:
        return len(self.errata)

    def __contains__(self, item: object, /) -> bool:
        return item in self.errata

    def __getitem__(self, key: int | str, /) -> Erratum:
        return self.errata[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Erratum(Record):
    """One erratum."""

    id: str
    """Id of the erratum."""
    table: str | None = None
    """Table concerned; `null` for an erratum of the text."""
    cell: ErratumCell | None = None
    """Cell concerned; `null` if it concerns the table or the text."""
    where: str
    """Place as text."""
    kind: ErratumKind
    """Kind of the error."""
    status: ErratumStatus
    """Status of the correction."""
    recovered: str | None = None
    """Text in the damaged file, for kind `recovery`; else `null`."""
    printed: str
    """Value in the manual."""
    corrected: str
    """Correct value; equal to `printed` if the matter is open."""
    checks_use: str | None = None
    """Value used by checks if the safe side is not `corrected`; else `null`."""
    unit: str
    """Unit of the three values; empty for texts."""
    evidence: str
    """Evidence with figures."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class ErratumCell(Record):
    """The cell concerned by an erratum."""

    symbol: str
    """Symbol in ASCII."""
    drive: str
    """Drive as headed in the manual; empty for all drives."""
    feedback: str
    """Feedback system; empty for all systems."""
    ratio: str
    """Reduction ratio; empty for all ratios."""
    condition: str
    """Further condition of the row."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class CatalogueCell(Record):
    """`catalogue export`: a cell in long form."""

    drive: str
    """Drive as headed in the manual; empty if the cell holds for all drives."""
    feedback: str
    """Feedback system, several joined by ` / `; empty for every one of the drive."""
    ratio: str
    """Reduction ratio, or `> 50`; empty if stated once for all ratios."""
    symbol: str
    """Symbol in ASCII."""
    condition: str
    """Further condition of the row."""
    printed: str
    """Text of the cell in the manual."""
    value: TableCell
    """Value after errata in the unit of the manual: a number or a text; `null` if the manual states none."""
    unit: str
    """Unit of the manual in ASCII; empty for pure numbers and texts."""
    table: str
    """Number of the table, or its name in another document."""
    erratum: str
    """Ids of the errata that concern the value, joined by `;`."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class CatalogueCheck(Record):
    """`catalogue check`: plausibility of catalogue files."""

    plausible: bool
    """`true` without a finding."""
    files: Rows[CheckedCatalogue]
    """Files in the order of the call."""

    def __iter__(self) -> Iterator[CheckedCatalogue]:
        return iter(self.files)

    def __len__(self) -> int:
        return len(self.files)

    def __contains__(self, item: object, /) -> bool:
        return item in self.files

    def __getitem__(self, key: int | str, /) -> CheckedCatalogue:
        return self.files[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class CheckedCatalogue(Record):
    """Plausibility of one catalogue file."""

    file: str
    """Name of the file."""
    products: int
    """Number of products."""
    findings: Rows[CatalogueFinding]
    """Implausible values, in the order of the file."""
    proposals: Rows[CatalogueProposal]
    """Proposed cells, in the order of the file; empty unless requested."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class CatalogueFinding(Record):
    """An implausible value, or several that contradict each other."""

    id: str
    """Id of the rule."""
    product: str
    """Name of the product."""
    line: int
    """Line of the first value, from 1."""
    column: int
    """Column of the first value in characters, from 1."""
    formula: str
    """Compared ratio in symbols, or the key that is compared with other products; empty for names."""
    value: float | None = None
    """Value of the ratio; `null` for names."""
    low: float | None = None
    """Smallest plausible ratio; `null` for names."""
    high: float | None = None
    """Largest plausible ratio; `null` for names."""
    unit: str
    """Unit of the ratio; empty for a pure number."""
    figures: Rows[CatalogueFigure]
    """Compared values."""
    other: OtherProduct | None = None
    """Other product concerned; `null` if there is none."""
    message: str
    """Description of the finding."""
    reason: str
    """Reason why the values contradict each other, and the usual cause."""

    def __iter__(self) -> Iterator[CatalogueFigure]:
        return iter(self.figures)

    def __len__(self) -> int:
        return len(self.figures)

    def __contains__(self, item: object, /) -> bool:
        return item in self.figures

    def __getitem__(self, key: int | str, /) -> CatalogueFigure:
        return self.figures[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class CatalogueFigure(Record):
    """A value that a rule compares."""

    symbol: str
    """Symbol in the formula; empty for a rule without a formula."""
    key: str
    """Name of the key."""
    written: str
    """Value as written, with its unit."""
    line: int
    """Line of the value, from 1."""
    column: int
    """Column of the value in characters, from 1."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class OtherProduct(Record):
    """Another product of the file."""

    product: str
    """Name of the product."""
    line: int
    """Line of the product, from 1."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class CatalogueProposal(Record):
    """A proposed cell: with this one change, no rule that reads the value has a finding. Nothing is written to the file."""

    product: str | None = None
    """Name of the product; `null` for the heading of a column."""
    key: str
    """Name of the key."""
    line: int
    """Line of the cell, from 1."""
    column: int
    """Column of the cell in characters, from 1."""
    old: str
    """Cell as written."""
    new: str
    """Proposed cell."""
    meant: str
    """Value that the proposed cell means, with its unit; for a heading the unit."""
    resolves: list[str]
    """Ids of the rules that the value breaks as written."""
    alternative: bool
    """`true` if another proposal for the product resolves the same findings: one of them is wrong."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Torsion(Record):
    """`torsion`: twist angle of a gear under a torque."""

    code: str
    """Ordering code."""
    torque: float | None
    """Torque."""
    angle_rad: float | None
    """Twist angle in rad."""
    angle_arcmin: float | None
    """Twist angle in arcmin."""
    region: int
    """Number of the linear section of the curve in which the angle lies, from 1 to 3."""
    T_1: float | None
    """End of the first section."""
    T_2: float | None
    """End of the second section."""
    K: list[float | None]
    """Stiffness of the three sections."""
    hysteresis_loss: float | None = None
    """Maximum hysteresis loss after full torque in both directions; `null` if the manual states none."""
    lost_motion: float | None = None
    """Maximum lost motion under a few per cent of the rated torque in both directions; `null` if the manual states
none."""
    exceeds: Rows[TorqueExceeded]
    """Limits of actuator and gear that the torque exceeds; the curve is not stated beyond them."""
    units: Units
    """Units of torque, stiffness and angles."""
    source: str
    """Source of the curve."""

    def __iter__(self) -> Iterator[TorqueExceeded]:
        return iter(self.exceeds)

    def __len__(self) -> int:
        return len(self.exceeds)

    def __contains__(self, item: object, /) -> bool:
        return item in self.exceeds

    def __getitem__(self, key: int | str, /) -> TorqueExceeded:
        return self.exceeds[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class TorqueExceeded(Record):
    """A limit that a torque exceeds."""

    symbol: str
    """Symbol of the limit: `T_max`, `T_M`."""
    limit: float | None
    """Limit."""
    grade: Grade
    """Grade of the limit."""
    source: str
    """Source of the limit."""
    errata: list[str]
    """Ids of the errata that concern the limit."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class DriveObject(Record):
    """An object of CiA 402 with its value."""

    index: str
    """Index: `0x6075`."""
    sub: int
    """Sub-index."""
    type: str
    """Type of CiA 301: `UNSIGNED8`, `UNSIGNED16` or `UNSIGNED32`."""
    value: int
    """Value to write."""
    unit: str
    """Unit of the value."""
    name: str
    """Name of the object in the profile."""
    exact: float | None
    """Value before rounding."""
    rounding: str
    """Direction of rounding: `nearest` or `down`."""
    grade: Grade
    """Grade of the value."""
    source: str
    """Source of the figures, then the document that defines the object."""
    errata: list[str]
    """Ids of the errata that concern the value."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Commissioning(Record):
    """Known values for the commissioning of a code."""

    code: str
    """Ordering code."""
    for_: str
    """Format of the values for the servo drive: `sinamics`, `plain`."""
    hazards: Rows[Fact]
    """Hazards and conditions, the gravest first."""
    parameters: Rows[CommissionParameter]
    """Known values."""
    gaps: Rows[CommissionGap]
    """Values that a servo drive requires and no source states, with advice."""
    sinamics: Rows[DriveParameter]
    """Parameters of a SINAMICS drive; empty for another format."""
    encoder: Rows[EncoderValue]
    """Values stated for the encoders."""
    commutation: list[str]
    """Determination of the angle between encoder and rotor, step by step."""
    thresholds: Rows[SensorThreshold]
    """Thresholds of the temperature sensors in degrees and ohms."""
    overload: OverloadSupervision
    """Settings of the overload supervision."""
    lists: Rows[CommissionList]
    """Checklists: before power, first motion, after a day."""
    errata: Rows[CitedErratum]
    """Errata of the values shown, with their evidence."""

    def __iter__(self) -> Iterator[CommissionParameter]:
        return iter(self.parameters)

    def __len__(self) -> int:
        return len(self.parameters)

    def __contains__(self, item: object, /) -> bool:
        return item in self.parameters

    def __getitem__(self, key: int | str, /) -> CommissionParameter:
        return self.parameters[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class CommissionParameter(Record):
    """A value to enter in a servo drive."""

    id: str
    """Identifier."""
    symbol: str
    """Symbol in ASCII."""
    name: str
    """Name of the value."""
    value: float | None
    """Value without rounding."""
    unit: str
    """Unit of the value."""
    conversion: str
    """Id of the conversion from the manual's value."""
    conversion_text: str
    """Conversion as text."""
    grade: Grade
    """Grade of the value."""
    source: str
    """Source of the value."""
    errata: list[str]
    """Ids of the errata that concern the value."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class CommissionGap(Record):
    """A value that a servo drive requires and no source states."""

    id: str
    """Identifier."""
    text: str
    """Missing value, and advice."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class DriveParameter(Record):
    """A parameter of a SINAMICS drive."""

    number: str
    """Number with the index of the motor data set: `p350[0]`."""
    value: float | None
    """Value of the parameter."""
    unit: str
    """Unit of the value; `1` for a pure number."""
    name: str
    """Name of the parameter."""
    conversion_text: str
    """Conversion from the manual's value, as text."""
    grade: Grade
    """Grade of the value."""
    source: str
    """Source of the figure, then the document that defines the parameter."""
    errata: list[str]
    """Ids of the errata that concern the value."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class EncoderValue(Record):
    """A value stated for an encoder."""

    side: str
    """`motor` or `output`."""
    symbol: str
    """Symbol in ASCII."""
    name: str
    """Name of the value."""
    condition: str
    """Further distinction of the row."""
    value: TableCell
    """The value after errata: a number or a text."""
    text: str
    """Value as displayed."""
    unit: str
    """Unit of the value; empty for pure numbers and texts."""
    table: str
    """Number of the table."""
    notes: list[str]
    """Notes on the value."""
    errata: list[str]
    """Ids of the errata that concern the value."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class SensorThreshold(Record):
    """A threshold of a temperature sensor."""

    sensor: str
    """`kty` or `ptc`."""
    name: str
    """Name of the threshold."""
    temperature: float | None
    """Temperature in degC; for the PTC that of the corner point."""
    resistance: float | None
    """Resistance in ohm."""
    bound: str
    """`typical`, `at_most` or `at_least`."""
    grade: Grade
    """Grade of the resistance."""
    source: str
    """Source of temperature and resistance."""
    errata: list[str]
    """Ids of the errata that concern the value."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class OverloadSupervision(Record):
    """Settings of the overload supervision."""

    stall_current: float | None = None
    """Stall current in A rms, to which the overload factor refers."""
    time_constant: float | None = None
    """Time constant of the winding in s, from the project's model; the manual states none."""
    grade: Grade
    """Grade of the time constant."""
    trips: Rows[OverloadTrip]
    """Response times of a first-order supervision from the cold state."""
    text: str
    """Basis of the values, as text."""
    errata: list[str]
    """Ids of the errata that concern the stall current."""

    def __iter__(self) -> Iterator[OverloadTrip]:
        return iter(self.trips)

    def __len__(self) -> int:
        return len(self.trips)

    def __contains__(self, item: object, /) -> bool:
        return item in self.trips

    def __getitem__(self, key: int | str, /) -> OverloadTrip:
        return self.trips[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class OverloadTrip(Record):
    """Response of the overload supervision."""

    factor: float | None
    """Overload factor I/I_0."""
    time: float | None
    """Response time in s."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class CommissionList(Record):
    """A checklist."""

    step: Step
    """`before_power`, `first_motion` or `after_a_day`."""
    title: str
    """Title of the checklist."""
    entries: Rows[CommissionEntry]
    """Entries of the checklist."""

    def __iter__(self) -> Iterator[CommissionEntry]:
        return iter(self.entries)

    def __len__(self) -> int:
        return len(self.entries)

    def __contains__(self, item: object, /) -> bool:
        return item in self.entries

    def __getitem__(self, key: int | str, /) -> CommissionEntry:
        return self.entries[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class CommissionEntry(Record):
    """An entry of a checklist."""

    id: str
    """Identifier: of a fact, a value or a measurand."""
    signal: Signal | None = None
    """Signal word; `null` if there is none."""
    text: str
    """Action, setting or measurement."""
    expected: float | None = None
    """Expected value; `null` for an entry to tick."""
    low: float | None = None
    """Lower edge of the band."""
    high: float | None = None
    """Upper edge of the band."""
    shown: str
    """Expected value as displayed; empty for an entry to tick."""
    unit: str | None = None
    """Unit of the figures; `null` for an entry to tick."""
    field: bool
    """`true` if a measured value is to be recorded."""
    grade: Grade
    """Grade of the expected value."""
    source: str
    """Source of the entry."""
    errata: list[str]
    """Ids of the errata that concern the value."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Recorded(Record):
    """`commission --record`: measured values with their verdicts."""

    code: str
    """Ordering code."""
    verdict: Fit
    """Verdict on all measurements; a value not measured does not count as passed."""
    off: int
    """Number of measurements out of their band."""
    not_checked: int
    """Number of measurements that are not judged."""
    measurements: Rows[RecordedValue]
    """The measurements."""
    errata: Rows[CitedErratum]
    """Errata of the expected values, with their evidence."""

    def __iter__(self) -> Iterator[RecordedValue]:
        return iter(self.measurements)

    def __len__(self) -> int:
        return len(self.measurements)

    def __contains__(self, item: object, /) -> bool:
        return item in self.measurements

    def __getitem__(self, key: int | str, /) -> RecordedValue:
        return self.measurements[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class RecordedValue(Record):
    """One measurement with its verdict."""

    id: str
    """Id of the measurand."""
    name: str
    """Name of the measurand."""
    number: int | None = None
    """Number of the measurement among several, from 1."""
    verdict: Verdict
    """Verdict of the measurement; `advice` is outside an estimated band."""
    value: float | None = None
    """Measured value."""
    expected: float | None = None
    """Expected value."""
    low: float | None = None
    """Lower edge of the band."""
    high: float | None = None
    """Upper edge of the band."""
    unit: str
    """Unit of the figures."""
    band: str | None = None
    """Basis of the band: `printed`, `servo_motors`, `kty_data_sheet`, `din_44081`, `friction`, `ours`, `exact`."""
    remark: str
    """Basis of the band as text, or the reason why it is not judged."""
    cause: str | None = None
    """Identifier of the likely cause of the deviation."""
    cause_text: str | None = None
    """Likely cause as text."""
    grade: Grade | None = None
    """Grade of the judgement."""
    source: str
    """Source of the expected value."""
    errata: list[str]
    """Ids of the errata that concern the value."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Inertia(Record):
    """`inertia`: solid bodies about the axis."""

    bodies: Rows[Body]
    """The bodies."""
    J: float | None
    """Moment of inertia of all bodies about the axis."""
    m: float | None
    """Mass of all bodies."""
    centre: Centre
    """Centre of gravity of all bodies."""
    T_gravity_max: float | None
    """Largest torque of gravity with a horizontal axis."""
    units: Units
    """Units of the figures."""

    def __iter__(self) -> Iterator[Body]:
        return iter(self.bodies)

    def __len__(self) -> int:
        return len(self.bodies)

    def __contains__(self, item: object, /) -> bool:
        return item in self.bodies

    def __getitem__(self, key: int | str, /) -> Body:
        return self.bodies[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Body(Record):
    """One body, or several equal ones at equal angles."""

    shape: str
    """Id of the shape."""
    count: int
    """Number of equal bodies."""
    m: float | None
    """Mass of one body."""
    r: float | None
    """Distance of the body's centre from the axis."""
    angle: float | None
    """Direction of the first body."""
    J_own: float | None
    """Moment of inertia of one body about its own centre."""
    J_steiner: float | None
    """Parallel-axis (Steiner) share of the moment of inertia."""
    J: float | None
    """Moment of inertia of all equal bodies about the axis."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Centre(Record):
    """A centre of gravity in polar coordinates about the axis."""

    r: float | None
    """Distance from the axis."""
    angle: float | None
    """Direction of the centre of gravity."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Curves(Record):
    """`curve`: the curves of the torque-speed plane."""

    code: str
    """Ordering code."""
    units: Units
    """Units of speed, torque, voltage and duty factor."""
    curves: Rows[Curve]
    """The curves."""

    def __iter__(self) -> Iterator[Curve]:
        return iter(self.curves)

    def __len__(self) -> int:
        return len(self.curves)

    def __contains__(self, item: object, /) -> bool:
        return item in self.curves

    def __getitem__(self, key: int | str, /) -> Curve:
        return self.curves[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Curve(Record):
    """One curve of the torque-speed plane."""

    kind: CurveKind
    """Duty of the curve."""
    ED: float | None = None
    """Duty factor of S3 in %; `null` for other duties."""
    title: str
    """Name of the curve."""
    voltage: float | None = None
    """Terminal voltage of the curve, rms; `null` if it holds for all voltages."""
    points: list[list[float | None]]
    """Speed and torque, by rising speed."""
    upper: list[list[float | None]] | None = None
    """Upper edge of an estimate's band; `null` if there is none."""
    grade: Grade
    """Grade of the curve."""
    source: str
    """Source of the curve."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Bearings(Record):
    """`bearing`: output bearing of each size under the loads of the project."""

    sizes: Rows[BearingOfSize]
    """Results for every size."""
    assumptions: Rows[AssumptionEntry]
    """Assumptions of the axis."""

    @property
    def axes(self) -> Rows[Bearings]:
        """It as the answer of its only axis, as `AxesOfBearings` has those of several."""
        return Rows([self])


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class BearingOfSize(Record):
    """Output bearing of one size."""

    size: str
    """Size of the actuator."""
    fits: bool
    """`true` if none of the checks fails."""
    checks: Rows[Check]
    """Checks of the bearing."""

    def __iter__(self) -> Iterator[Check]:
        return iter(self.checks)

    def __len__(self) -> int:
        return len(self.checks)

    def __contains__(self, item: object, /) -> bool:
        return item in self.checks

    def __getitem__(self, key: int | str, /) -> Check:
        return self.checks[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class AxesOfBearings(Record):
    """Answers for several axes."""

    verdict: Fit
    """Worst verdict of the axes."""
    axes: Rows[Bearings]
    """Answer for each axis."""

    def __iter__(self) -> Iterator[Bearings]:
        return iter(self.axes)

    def __len__(self) -> int:
        return len(self.axes)

    def __contains__(self, item: object, /) -> bool:
        return item in self.axes

    def __getitem__(self, key: int | str, /) -> Bearings:
        return self.axes[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Battery(Record):
    """`battery`: life of the encoder's battery."""

    hours_per_day: float | None
    """Operation per day \\[h\\]."""
    storage: float | None
    """Storage before use in `unit`."""
    life: float | None
    """Life in `unit`."""
    exchange_recommended: float | None
    """Recommended time of the replacement."""
    exchange_latest: float | None
    """Latest time of the replacement."""
    capped: bool
    """`true` if the life is limited by the cell instead of its charge."""
    unit: str
    """Unit of the times in years."""
    grade: Grade
    """Grade of the life."""
    source: str
    """Source of the life."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Mount(Record):
    """`mount`: fits, tolerances, dimensions and bolted joints of an actuator."""

    code: str
    """Ordering code."""
    verdict: Fit
    """Verdict on slipping of the joints under torque alone."""
    units: Units
    """Units of the figures, by field."""
    notes: list[str]
    """Remarks on data not covered by the tables, and on the basis of the figures, as text."""
    assumptions: Rows[AssumptionEntry] | None = None
    """Assumptions of the axis whose loads act on the joints; empty without a project."""
    pilots: Rows[Pilot]
    """Pilots with their bores, load side first."""
    tolerances: Rows[MountValue]
    """Tolerances of the output flange."""
    dimensions: Rows[MountValue]
    """Dimensions, mass, mounting plate, degree of protection."""
    lifting_gear: bool | None = None
    """`true` if the mass requires lifting gear; `null` if the manual states no mass for the code."""
    joints: Rows[Joint]
    """Bolted joints, load side first."""
    facts: Rows[Fact]
    """Requirements of the manual, in the order of a machine's life."""
    errata: Rows[CitedErratum]
    """Errata of the values above."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Pilot(Record):
    """A pilot with its bore."""

    side: Side
    """Side of the actuator."""
    title: str
    """Name of the side."""
    nominal: float | None
    """Nominal diameter."""
    zone: str
    """Tolerance zone of the pilot."""
    upper: float | None
    """Upper limit deviation of the pilot."""
    lower: float | None
    """Lower limit deviation of the pilot."""
    recommended: str
    """Tolerance zone recommended by the manual for the bore."""
    bore: str | None = None
    """Tolerance zone of the bore; `null` for user-defined limit deviations."""
    bore_upper: float | None
    """Upper limit deviation of the bore."""
    bore_lower: float | None
    """Lower limit deviation of the bore."""
    clearance_min: float | None
    """Smallest clearance; interference is negative."""
    clearance_max: float | None
    """Largest clearance."""
    off_centre_max: float | None
    """Largest offset of the part from the centre: half of the largest clearance, zero with interference."""
    fit: FitKind
    """Kind of fit."""
    fit_text: str
    """Kind of fit as text."""
    grade: Grade
    """Grade of the clearances."""
    sources: list[str]
    """Sources of the figures."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class MountValue(Record):
    """A value stated in the manual."""

    symbol: str
    """Symbol in ASCII."""
    name: str
    """Technical term."""
    value: TableCell
    """Value; `null` if the manual states none for the code."""
    unit: str
    """Unit in ASCII; empty for texts."""
    grade: Grade | None = None
    """Grade of the value; `null` without a value."""
    source: str | None = None
    """Source of the value; `null` without a value."""
    errata: list[str]
    """Ids of the errata that touch it."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Joint(Record):
    """A bolted joint."""

    side: Side
    """Side of the actuator."""
    title: str
    """Name of the side."""
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
    """Torque transmitted by the joint with degreased faces."""
    friction: float | None = None
    """Friction coefficient assumed for this torque."""
    clamp_force: float | None = None
    """Clamp force per screw that follows from it: estimated."""
    source: str | None = None
    """Source of the stated values."""
    tightening_errata: list[str]
    """Ids of the errata that touch the tightening torque."""
    transmissible_errata: list[str]
    """Ids of the errata that touch the torque that the joint transmits."""
    cases: Rows[JointCase]
    """Results for each load."""

    def __iter__(self) -> Iterator[JointCase]:
        return iter(self.cases)

    def __len__(self) -> int:
        return len(self.cases)

    def __contains__(self, item: object, /) -> bool:
        return item in self.cases

    def __getitem__(self, key: int | str, /) -> JointCase:
        return self.cases[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class JointCase(Record):
    """A joint under a load."""

    case: LoadCase
    """Load case."""
    title: str
    """Name of the load case."""
    torque: float | None = None
    """Torque; `null` without one, or if unknown."""
    torque_source: str | None = None
    """Source of the torque."""
    torque_errata: list[str]
    """Ids of the errata that touch the torque."""
    utilisation: float | None = None
    """Share of the transmissible torque, torque alone."""
    verdict: Verdict
    """Verdict on torque alone."""
    grade: Grade | None = None
    """Grade of the utilisation."""
    moment: float | None = None
    """Tilting moment acting at the same time."""
    moment_source: str | None = None
    """Source of the moment."""
    moment_errata: list[str]
    """Ids of the errata that touch the moment."""
    relieved: float | None = None
    """Share of its clamp force lost by the screw relieved most: estimated."""
    utilisation_together: float | None = None
    """Share of the remaining friction used by torque and forces: estimated; `null` if the joint opens."""
    verdict_together: Verdict
    """Verdict on all loads together; `advice` if the estimate is not sufficient."""
    missing: str | None = None
    """Missing data for a verdict, as text."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Upkeep(Record):
    """`upkeep`: maintenance tasks and their dates."""

    code: str
    """Ordering code."""
    verdict: Fit
    """Verdict on the storage against the permitted limits."""
    delivered: str
    """Day of delivery, such as `2026-03-01`."""
    in_service: str
    """First day of service."""
    today: str | None = None
    """Reference day of the plan; `null` if not stated."""
    plan: Rows[Planned]
    """Plan by date."""
    battery: Battery | None = None
    """Life of the encoder's battery; `null` without one, or if the hours of operation are not stated."""
    notes: list[str]
    """Assumptions, and points that the manual does not state, as text."""
    storage: Rows[Fact]
    """Facts on transport and storage."""
    service: Rows[Fact]
    """Facts on service."""
    shutdown: Rows[Fact]
    """Facts on shutdown, in the order of the steps."""
    disposal: Rows[Fact]
    """Facts on disposal."""
    errata: Rows[CitedErratum]
    """Errata of the text that the plan depends on."""
    calendar: str | None = None
    """ICalendar file of the plan; `null` if none was written."""

    def __iter__(self) -> Iterator[Planned]:
        return iter(self.plan)

    def __len__(self) -> int:
        return len(self.plan)

    def __contains__(self, item: object, /) -> bool:
        return item in self.plan

    def __getitem__(self, key: int | str, /) -> Planned:
        return self.plan[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Planned(Record):
    """A task of the plan."""

    task: Task
    """Id of the task."""
    title: str
    """Name of the task."""
    rule: Rule
    """Binding force of the task."""
    rule_text: str
    """Rule as text, with its interval."""
    interval: str | None = None
    """Interval of a series in ISO 8601: `P6M`, `P90D`."""
    first: str
    """Date; the first one of a series."""
    next: str
    """First date of a series that is not before today, if today is stated."""
    passed: bool
    """`true` if the date lies before today, if today is stated."""
    fact: str
    """Id of the fact that requires the task."""
    text: str
    """Text of the fact."""
    source: str
    """Source of the date."""
    grade: Grade | None = None
    """Grade of the date; `null` if it follows from an interval stated by the user."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Glossary(Record):
    """Words and symbols, all or the requested ones."""

    words: Rows[GlossaryWord]
    """Terms of the product, one per thing."""
    terms: Rows[GlossaryTerm]
    """Symbols of the tables."""
    symbols: Rows[GlossarySymbol]
    """Symbols of the derivations and of the values for a servo drive. A symbol with several meanings has several
entries."""
    checks: Rows[GlossaryCheck] | None = None
    """Checks with the requested title; only where there are some."""

    @property
    def entries(self) -> Rows[GlossaryWord | GlossaryTerm | GlossarySymbol]:
        """The words, the terms and the symbols."""
        return Rows([*self.words, *self.terms, *self.symbols])

    def __iter__(self) -> Iterator[GlossaryWord | GlossaryTerm | GlossarySymbol]:
        return iter(self.entries)

    def __len__(self) -> int:
        return len(self.entries)

    def __contains__(self, item: object, /) -> bool:
        return item in self.entries

    def __getitem__(self, key: int | str, /) -> GlossaryWord | GlossaryTerm | GlossarySymbol:
        return self.entries[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class GlossaryWord(Record):
    """A word of the product."""

    id: str
    """Identifier."""
    en: str
    """English word."""
    de: str
    """German word."""
    meaning: str
    """Meaning, in the requested language."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class GlossaryTerm(Record):
    """A symbol of the tables."""

    symbol: str
    """Symbol in ASCII, as in the catalogue's export: `T_max`."""
    identifier: str
    """Long name, as in project files."""
    unit: str
    """Unit in the manual; empty for a pure number or a text."""
    en: str
    """English term."""
    de: str
    """German term."""
    remark: str
    """Remark in the requested language; may be empty."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class GlossarySymbol(Record):
    """A symbol of the derivations of `explain`, or of the values of `commission`."""

    symbol: str
    """Symbol in ASCII."""
    shown: str
    """Symbol as displayed in formulas."""
    en: str
    """English meaning."""
    de: str
    """German meaning."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class GlossaryCheck(Record):
    """A check of an actuator, which `explain` states with formula, inputs and sources."""

    id: str
    """Identifier."""
    en: str
    """English title."""
    de: str
    """German title."""
    meaning_en: str
    """Value and limit that the check compares, in English."""
    meaning_de: str
    """Value and limit that the check compares, in German."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Units2(Record):
    """Units by the quantity that they measure."""

    quantities: Rows[Measured]
    """The quantities."""

    def __iter__(self) -> Iterator[Measured]:
        return iter(self.quantities)

    def __len__(self) -> int:
        return len(self.quantities)

    def __contains__(self, item: object, /) -> bool:
        return item in self.quantities

    def __getitem__(self, key: int | str, /) -> Measured:
        return self.quantities[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Measured(Record):
    """A quantity with its units."""

    quantity: str
    """Name in the language of the call."""
    si_unit: str
    """The unit in which `si` and `zero` are stated, in the spelling of project files."""
    units: Rows[UnitRead]
    """Units, the usual one first."""

    def __iter__(self) -> Iterator[UnitRead]:
        return iter(self.units)

    def __len__(self) -> int:
        return len(self.units)

    def __contains__(self, item: object, /) -> bool:
        return item in self.units

    def __getitem__(self, key: int | str, /) -> UnitRead:
        return self.units[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class UnitRead(Record):
    """A unit and how it is read."""

    unit: str
    """Spelling in project files."""
    symbol: str
    """Symbol in reports and on the terminal."""
    json: str
    """Spelling in JSON and tables."""
    also: list[str]
    """Further spellings that are read."""
    si: float | None
    """One of it, as a difference, in SI."""
    zero: float | None
    """Zero of it in SI: nonzero for degrees Celsius alone."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Licences(Record):
    """Licence of the program and of the third-party work in it."""

    texts: Rows[LicenceText]
    """Licence texts, the program's own first."""

    def __iter__(self) -> Iterator[LicenceText]:
        return iter(self.texts)

    def __len__(self) -> int:
        return len(self.texts)

    def __contains__(self, item: object, /) -> bool:
        return item in self.texts

    def __getitem__(self, key: int | str, /) -> LicenceText:
        return self.texts[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class LicenceText(Record):
    """A licence text as in the repository."""

    name: str
    """File in the repository."""
    text: str
    """Complete text, in Markdown if the name ends in `.md`."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class CommissionWritten(Record):
    """`commission --out`, `--checklist` or `--blank`: a file written."""

    file: str
    """Path of the file."""
    code: str
    """Ordering code."""
    bytes: int
    """Size of the file in bytes."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class FilesWritten(Record):
    """`new --out`: the files written."""

    files: list[str]
    """Paths of the files."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class ReportWritten(Record):
    """`report`: the file written."""

    file: str
    """Path as given."""
    code: str | None = None
    """Ordering code, or name of the project's own actuator; omitted for several axes."""
    verdict: Fit
    """Verdict on the actuator, or the worst verdict of several."""
    axes: Rows[AxisWritten] | None = None
    """Axes with their actuators; only with several axes."""
    bytes: int
    """Size of the file in bytes."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class AxisWritten(Record):
    """An axis in a report."""

    axis: str
    """Name of the axis."""
    code: str
    """Ordering code, or name of the project's own actuator."""
    verdict: Fit
    """Verdict on the actuator."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class ExportWritten(Record):
    """`export --out`: the file written."""

    file: str
    """Path as given."""
    code: str | None = None
    """Ordering code, or name of the project's own actuator; absent for several axes."""
    verdict: Fit
    """Verdict on the actuator; of several axes the worst."""
    tables: Rows[TableWritten]
    """Tables in the file; empty for several axes."""
    left_out: Rows[TableWritten]
    """Tables left out because they are too long for a sheet of a workbook; empty for several axes."""
    axes: Rows[AxisExported] | None = None
    """Several axes, in the order of the sheets; absent for one."""

    def __iter__(self) -> Iterator[TableWritten]:
        return iter(self.tables)

    def __len__(self) -> int:
        return len(self.tables)

    def __contains__(self, item: object, /) -> bool:
        return item in self.tables

    def __getitem__(self, key: int | str, /) -> TableWritten:
        return self.tables[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class TableWritten(Record):
    """A table in a file."""

    name: str
    """Name of the table."""
    rows: int
    """Number of rows."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class AxisExported(Record):
    """One of several axes of a workbook."""

    axis: str
    """Name of the axis."""
    code: str
    """Ordering code, or name of the project's own actuator."""
    verdict: Fit
    """Verdict on the actuator."""
    tables: Rows[TableWritten]
    """Tables in the file."""
    left_out: Rows[TableWritten]
    """Tables left out because they are too long for a sheet."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class PlotWritten(Record):
    """`plot`: the picture written."""

    figure: str
    """Id of the figure."""
    file: str | None = None
    """Path of the first file; `null` for standard output."""
    files: list[str]
    """Paths of the files."""
    width: float | None
    """Width of the picture."""
    height: float | None
    """Height of the picture."""
    units: Units
    """Units of width and height."""
    title: str
    """Title of the picture."""
    caption: str
    """Caption below the picture."""
    description: str
    """Description of the picture, for screen readers."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class CodeFaults(Record):
    """An invalid code or partial code: written instead of the answer."""

    valid: bool
    """`false` in every such answer."""
    text: str
    """Text as given."""
    errors: Rows[CodeFault]
    """Faults in the order of the text."""
    nearest: list[str]
    """Nearest valid codes with data in the manual."""
    nearest_codes: Rows[ListedCode]
    """Nearest valid codes with their availability."""

    def __iter__(self) -> Iterator[CodeFault]:
        return iter(self.errors)

    def __len__(self) -> int:
        return len(self.errors)

    def __contains__(self, item: object, /) -> bool:
        return item in self.errors

    def __getitem__(self, key: int | str, /) -> CodeFault:
        return self.errors[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class CodeFault(Record):
    """A fault of a code."""

    id: str
    """Stable id of the kind of fault: `code_rule` for a rule of a table, `code_spelling` for anything else."""
    position: int
    """Place in characters, from 1."""
    span: list[int]
    """Place in bytes: start and exclusive end."""
    text: str | None = None
    """Text at this place."""
    message: str
    """Description of the fault, one sentence."""
    hint: str | None = None
    """Valid text at this place; `null` if nothing is similar."""
    table: str | None = None
    """Ordering table with the violated rule; `null` for a fault of the spelling."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Faults(Record):
    """Faults of a request; a command that cannot answer writes this record instead of its answer, and exits with 2."""

    errors: Rows[Fault]
    """Faults in the order of the file."""
    nearest_codes: Rows[ListedCode] | None = None
    """Nearest valid codes, if one of the faults is a wrong ordering code."""

    def __iter__(self) -> Iterator[Fault]:
        return iter(self.errors)

    def __len__(self) -> int:
        return len(self.errors)

    def __contains__(self, item: object, /) -> bool:
        return item in self.errors

    def __getitem__(self, key: int | str, /) -> Fault:
        return self.errors[key]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Fault(Record):
    """One fault; id, option, file and place are omitted if there is none."""

    id: str | None = None
    """Stable id of the kind of fault."""
    option: str | None = None
    """Option of the command line concerned."""
    file: str | None = None
    """File concerned."""
    line: int | None = None
    """Line, from 1."""
    column: int | None = None
    """Column in characters, from 1."""
    span: list[int] | None = None
    """Offending part in bytes: start and exclusive end."""
    heading: str | None = None
    """Heading of the table column concerned."""
    row: int | None = None
    """Row of the table, from 0."""
    message: str
    """Description of the fault, one sentence."""
    hint: str | None = None
    """Expected text, or the nearest valid choice; `null` if nothing is similar."""


Fit = Literal["fits", "fits_if_estimate", "does_not_fit"]
"""Verdict on an actuator, or on the best of several; best first.

`fits`: No check fails, and no requirement or rule is violated

`fits_if_estimate`: No check fails, but one exceeds its limit within the band of an estimate, with the verdict `advice`

`does_not_fit`: A check fails, or a requirement is not met"""

CheckId = Literal["peak_torque", "peak_speed", "mean_speed", "continuous_torque", "peak_current", "demagnetisation", "voltage", "inertia_ratio", "rope_tension", "gear_mean_torque", "gear_life", "torsion", "natural_frequency", "bearing_axial", "bearing_radial", "bearing_tilting_moment", "bearing_static_moment", "bearing_life", "bearing_static", "tilt_angle", "ambient", "altitude", "protection", "humidity", "humidity_min", "vibration", "shock", "mounting", "dc_link", "drive_current", "drive_current_peak", "drive_peak_time", "torque_speed_trace", "thermal", "overload_i2t", "regeneration", "gear_mean_input_speed", "collision_torque", "collision_number", "resonance_speed", "error_budget", "deviation", "brake_holding", "brake_applications", "brake_emergency", "brake_stops", "feedback_range", "feedback_resolution", "battery", "screw_joint_load", "screw_joint_housing", "application"]

DemandMode = Literal["manual", "integral"]
"""Method by which the figures of a demand are computed.

`manual`: The manual's equations 69.1 to 69.4

`integral`: Exact integration"""

Units = dict[str, str]
"""The units of the figures, by symbol or field."""

Verdict = Literal["pass", "fail", "advice", "not_checked"]

Direction = Literal["at_most", "at_least"]

Part = Literal["drive", "thermal", "energy", "gear", "output_bearing", "brake", "feedback", "screws", "environment"]

Grade = Literal["printed", "computed", "published", "estimated", "assumed"]

TextEncoding = Literal["utf8", "utf16", "utf16_guessed", "windows1252_guessed"]
"""Encoding of the text of a recording.

`utf8`: UTF-8; every byte of the header is valid

`utf16`: UTF-16, stated by the byte order mark

`utf16_guessed`: UTF-16, guessed from the zeros between the letters

`windows1252_guessed`: Windows-1252, which includes Latin-1: guessed, since the header is no UTF-8"""

ColumnRole = Literal["time", "position", "speed", "torque"]
"""Role of a column in a recording."""

UnitBy = Literal["header", "unit_row", "metadata", "values", "project"]
"""Source of the unit of a column.

`header`: The name of the column

`unit_row`: A row of units below the names

`metadata`: The metadata of the file

`values`: The values of the column: clock times

`project`: The project file"""

ScenarioId = Literal["cycle", "emergency_stop", "power_failure", "brake_stuck", "hanging_load", "blocked_load", "encoder_failure", "battery_loss", "link_sag", "hot_ambient", "cold_grease", "collision"]

EventEffect = Literal["travel", "torque", "link_voltage", "speed"]

MotionDirection = Literal["positive", "negative", "standstill"]

Reaction = Literal["ramp", "brake", "coast"]

Figures = dict[str, Figure]

RunCheckId = Literal["current_peak", "torque_peak", "speed_peak", "winding_peak", "overload", "link_high", "stop_angle", "drive_faults"]

EventKind = Literal["scenario", "ramp", "pulses_off", "brake_closes", "brake_closed", "brake_closed_moving", "brake_open", "brake_slips", "at_rest", "limited", "overload", "winding_warning", "winding_shutdown", "ptc_response", "following_error", "link_low", "link_high", "brake_resistor", "no_position", "turns_lost", "demagnetisation", "collision_torque", "overspeed", "diverged"]

Loop = Literal["current", "speed", "position"]

ColumnKind = Literal["text", "number", "count", "word"]
"""Type of the values of a column.

`text`: Text

`number`: Numbers

`count`: Whole numbers

`word`: A word of a fixed set"""

TableCell = float | str | None
"""A value of a table."""

Availability = Literal["available", "on_request"]
"""Availability of an ordering code.

`available`: Available without a request

`on_request`: Available on request only"""

Field = Literal["series", "size", "ratio", "winding", "feedback", "brake", "option_1", "option_2", "special"]

NoteBy = Literal["manual", "antrieb"]
"""Author of a note.

`manual`: The manual

`antrieb`: A conclusion of the project from the manual"""

ConnectorRole = Literal["motor", "feedback", "output_encoder"]

ConnectorExit = Literal["cable", "housing"]
"""Location of a connector.

`cable`: Connector at the end of a cable

`housing`: Connector in the housing"""

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
"""Representation of the value of a signal.

`voltage`: A voltage between its pins

`peak_voltage`: A voltage at the peak of the excitation

`level`: Logic level: one is high, zero low

`share`: Fraction of the amplitude, which the manual does not state

`other`: Clocked or alternating signal, independent of the angle"""

EncoderAssumed = Literal["order_of_tracks", "zero_of_tracks", "zero_of_commutation", "zero_of_position", "zero_of_output", "times_of_endat", "times_of_ssi", "carrier", "deviation", "battery_lost"]

ErratumKind = Literal["recovery", "print_error", "contradiction", "rounding", "edition"]
"""Kind of an erratum.

`recovery`: The recovered text differs from the manual

`print_error`: The manual is wrong, as proven by neighbouring values

`contradiction`: Two statements of the manual exclude each other, and nothing decides between them

`rounding`: Rounded to the unsafe side or with false digits

`edition`: Another edition states a different value"""

ErratumStatus = Literal["corrected", "flagged"]
"""Status of an erratum.

`corrected`: The correct value is proven and used

`flagged`: The value of the manual stays and is flagged"""

CommissionAnswer = Rows[DriveObject] | Commissioning
"""`commission`: the list of objects with `--for cia402`, else the whole sheet."""

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
"""A row with a value for each column."""

__all__ = [
    "AmbiguousColour",
    "Assessed",
    "AssumptionEntry",
    "Availability",
    "AxesOfBearings",
    "AxesOfComparison",
    "AxesOfDifference",
    "AxesOfExplanations",
    "AxesOfJudgement",
    "AxesOfSimulation",
    "AxesOfSizing",
    "AxisExported",
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
    "CatalogueCheck",
    "CatalogueFigure",
    "CatalogueFinding",
    "CatalogueProposal",
    "Centre",
    "Check",
    "CheckChange",
    "CheckId",
    "CheckRow",
    "CheckedCatalogue",
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
    "DayOfOperation",
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
    "EndOverrun",
    "Errata",
    "Erratum",
    "ErratumCell",
    "ErratumKind",
    "ErratumStatus",
    "EventEffect",
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
    "GlossaryCheck",
    "GlossarySymbol",
    "GlossaryTerm",
    "GlossaryWord",
    "Grade",
    "Head",
    "HourOfOperation",
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
    "MotionDirection",
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
    "OtherProduct",
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
    "ReserveNotChecked",
    "Rule",
    "RunCheckId",
    "ScenarioId",
    "Segment",
    "SensorThreshold",
    "Setpoints",
    "Severity",
    "Sheet",
    "SheetNote",
    "SheetSection",
    "SheetValue",
    "Side",
    "Signal",
    "SignalDatum",
    "SignalForm",
    "SignalGroup",
    "SimulatedEvent",
    "SimulatedVerdict",
    "Simulation",
    "Sizing",
    "Stage",
    "StageRatio",
    "Step",
    "SweepCheck",
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
    "TorqueExceeded",
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
    "WorstInstant",
    "WorstOfDirection",
    "WouldFit",
    "WouldFitAfter",
    "WouldFitWithLaw",
]
