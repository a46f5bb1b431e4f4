"""Sizing of hollow-shaft servo actuators: from a load and a motion to a verified ordering code.

>>> import antrieb as an
>>> axis = an.Axis("tilt", an.Arm(mass="6 kg", length="0.5 m"), [an.Move("modified_sine", distance="90 deg", time="0.8 s"),
...                an.Return(time="0.6 s")], supply="560 V")
>>> an.size(axis).best.code                                    # a project as objects, or a file:
>>> found = an.size("axis.toml", axis="indexing table")   # the catalogue ranked, as typed objects
>>> an.check("axis.toml", "CHA-25A-50-H-C1024")           # one actuator, every check with its margin
>>> an.plot("axis.toml", "torque_speed")                  # a notebook shows it
>>> an.sweep("axis.toml", table)                          # any Arrow table in, an Arrow table out

A project is an `Axis`, a `Project` with several, a text, or the path of a file (`axis.toml`, as the command line reads it).
Quantities are texts with their unit, `"40 1/min"`, `q(40, "1/min")`, or quantities of pint. What cannot be answered raises `AntriebError` with every fault of the input. Every question of the command line is
a function of the same name; the answers are those of `--json` as the dataclasses of `antrieb.answers`. The work is done outside
of the interpreter, other threads go on meanwhile, and an interrupt ends it.
"""

import importlib as _importlib
import os as _os
from typing import TYPE_CHECKING as _TYPE_CHECKING
from typing import Any as _Any

from antrieb import _antrieb
from antrieb import questions as questions
from antrieb import sections as sections
from antrieb._antrieb import VERSION as __version__
from antrieb._arrays import axes_from_arrays
from antrieb._axis import load, loads
from antrieb._call import AntriebError, Lang, Picture, Text
from antrieb._call import Path as Path
from antrieb._lines import Grid, Line
from antrieb._nearest import NothingFits
from antrieb._quantity import Q, Quantity, q
from antrieb._record import Record, Rows
from antrieb._section import Section
from antrieb.questions import *  # noqa: F403
from antrieb.sections import *  # noqa: F403
from antrieb._table import ArrowArray, ArrowSchema, ArrowStream, Sweep, Table, TableLike, sweep

if _TYPE_CHECKING:
    from antrieb import answers as answers
    from antrieb._call import Fault as Fault

__all__ = [
    "AntriebError",
    "ArrowArray",
    "ArrowSchema",
    "ArrowStream",
    "Fault",
    "Grid",
    "Lang",
    "Line",
    "NothingFits",
    "Picture",
    "Q",
    "Quantity",
    "Record",
    "Rows",
    "Section",
    "Sweep",
    "Table",
    "TableLike",
    "Text",
    "__version__",
    "answers",
    "axes_from_arrays",
    "load",
    "loads",
    "q",
    "sweep",
]
__all__ += questions.__all__
__all__ += sections.__all__

# The threads of this process are not those of its children.
if hasattr(_os, "register_at_fork"):
    _os.register_at_fork(before=_antrieb.settle, after_in_child=_antrieb.forked)


def __getattr__(name: str) -> _Any:
    # The classes of the answers are made when they are first used.
    if name == "answers":
        return _importlib.import_module("antrieb.answers")
    if name == "Fault":
        answers = _importlib.import_module("antrieb.answers")
        return answers.Fault | answers.CodeFault
    raise AttributeError(f"module 'antrieb' has no attribute {name!r}")
