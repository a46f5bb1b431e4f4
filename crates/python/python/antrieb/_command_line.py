"""The command `antrieb` of the wheel: the command line itself, in this process."""

from __future__ import annotations

import signal
import sys

from antrieb import _antrieb


def main() -> int:
    """Answer the call of this process and give its exit code."""
    # As in any program: an interrupt ends it, also while no Python runs.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    return _antrieb.run(["antrieb", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
