"""Sizing of hollow-shaft servo actuators: from a load and a motion to a verified ordering code.

>>> import antrieb
>>> found = antrieb.size("axis.toml", axis="indexing table")   # the catalogue ranked, as typed objects
>>> antrieb.check("axis.toml", "CHA-25A-50-H-C1024")           # one actuator, every check with its margin
>>> antrieb.plot("axis.toml", "torque_speed")                  # a notebook shows it
>>> antrieb.sweep("axis.toml", table)                          # any Arrow table in, an Arrow table out

A project is its text or the path of its file (`axis.toml`, as the command line reads it). Quantities are texts with their unit,
`"40 1/min"`. What cannot be answered raises `AntriebError` with every fault of the input. Every question of the command line is
a function of the same name; the answers are those of `--json` as the dataclasses of `antrieb.answers`. The work is done outside
of the interpreter, other threads go on meanwhile, and an interrupt ends it.
"""

import os as _os

from antrieb import _antrieb, answers
from antrieb import questions as questions
from antrieb._antrieb import VERSION as __version__
from antrieb._call import AntriebError, Fault, Lang, Path, Picture, Text
from antrieb.questions import *  # noqa: F403
from antrieb._table import ArrowArray, ArrowSchema, ArrowStream, Sweep, Table, sweep

__all__ = [
    "AntriebError",
    "ArrowArray",
    "ArrowSchema",
    "ArrowStream",
    "Fault",
    "Lang",
    "Path",
    "Picture",
    "Sweep",
    "Table",
    "Text",
    "__version__",
    "answers",
    "sweep",
]
__all__ += questions.__all__

# The threads of this process are not those of its children.
if hasattr(_os, "register_at_fork"):
    _os.register_at_fork(after_in_child=_antrieb.forked)
