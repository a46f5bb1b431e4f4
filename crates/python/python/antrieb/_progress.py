"""Progress of a sweep: a function of the caller, or a line on the terminal."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Generator
from contextlib import contextmanager
from typing import Any

from antrieb import _antrieb

Progress = bool | Callable[[int, int], object] | type[Any]
"""`True` for a line on the terminal, a function that is called with the number of judged rows and of all rows, or the class of a
bar, such as `tqdm.tqdm`."""

LATER = 0.3
"""Seconds after which a line is shown."""


class Bar:
    """A line on the terminal: judged rows, rows per second, time left."""

    def __init__(self, lang: str) -> None:
        self.lang, self.begun, self.width, self.shown = lang, time.monotonic(), 0, 0.0

    def __call__(self, done: int, all_rows: int) -> None:
        """Shows the progress, at most ten times a second."""
        now = time.monotonic()
        if now - self.begun < LATER or (now - self.shown < 0.1 and done < all_rows):
            return
        self.shown = now
        self._write(_antrieb.progress_line(done, all_rows, now - self.begun, self.lang))

    def end(self) -> None:
        """Ends the line."""
        if self.width:
            print(file=sys.stderr, flush=True)

    def _write(self, line: str) -> None:
        print("\r" + line.ljust(self.width), end="", file=sys.stderr, flush=True)
        self.width = len(line)


class Foreign:
    """A bar of another library, made when the number of all rows is known: `tqdm.tqdm`."""

    def __init__(self, of: type[Any]) -> None:
        if not hasattr(of, "update"):
            raise TypeError(f"progress is True, False, a function of two numbers, or the class of a bar with update, not the class {of.__name__}")
        self.of, self.bar, self.done = of, None, 0

    def __call__(self, done: int, all_rows: int) -> None:
        """Advances the bar."""
        bar: Any = self.of(total=all_rows) if self.bar is None else self.bar
        self.bar = bar
        bar.update(done - self.done)
        self.done = done

    def end(self) -> None:
        """Closes the bar."""
        bar: Any = self.bar
        if bar is not None and hasattr(bar, "close"):
            bar.close()


@contextmanager
def observed(progress: Any, lang: str) -> Generator[Callable[[int, int], object]]:
    """The function that a sweep calls. An interrupt says what is kept and how to go on."""
    if progress is not None and not isinstance(progress, bool) and not callable(progress):
        raise TypeError(f"progress is True, False or a function of two numbers, not {type(progress).__name__}")
    bar: Bar | Foreign | None = Bar(lang) if progress is True else Foreign(progress) if isinstance(progress, type) else None
    inner: Callable[[int, int], object] | None = bar or (progress if callable(progress) else None)
    last = (0, 0)

    def seen(done: int, all_rows: int) -> None:
        nonlocal last
        last = (done, all_rows)
        if inner is not None:
            inner(done, all_rows)

    try:
        yield seen
    except KeyboardInterrupt as interrupt:
        done, all_rows = last
        interrupt.add_note(
            f"after {done} of {all_rows} rows; their answers are not kept. Sweep.batch judges a table in parts, and the command "
            "`antrieb sweep` continues where it was interrupted"
        )
        raise
    finally:
        if bar is not None:
            bar.end()
