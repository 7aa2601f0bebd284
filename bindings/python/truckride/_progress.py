# SPDX-License-Identifier: MIT
"""Progress of long work: callbacks, a bar in a terminal, Ctrl-C."""
from __future__ import annotations

import signal
import sys
import threading
import time
from typing import Any, Callable, Optional, TextIO, Union

from . import _abi

# None: only Ctrl-C is watched. True: a bar, if a terminal is attached. A function receives
# the fraction done, 0 to 1, and cancels the work by returning something true.
Progress = Union[None, bool, Callable[[float], Any]]


class Bar:
    """A line like tqdm's: share done, bar, time so far and to go."""

    WIDTH = 40

    def __init__(self, title: str, stream: Optional[TextIO] = None) -> None:
        self.title = title
        self.stream = stream or sys.stderr
        self.started = time.monotonic()
        self.shown = -1

    def __call__(self, fraction: float) -> None:
        percent = int(100 * fraction)
        if percent == self.shown:
            return
        self.shown = percent
        spent = time.monotonic() - self.started
        left = f"{spent / fraction - spent:.1f}" if fraction > 0 else "?"
        full = int(self.WIDTH * fraction)
        bar = "█" * full + " " * (self.WIDTH - full)
        self.stream.write(f"\r{self.title}: {percent:3d}% |{bar}| {spent:.1f} s < {left} s ")
        self.stream.flush()

    def close(self) -> None:
        if self.shown >= 0:
            self.stream.write("\n")
            self.stream.flush()


class Watch:
    """Hands progress to Python and brings exceptions, Ctrl-C among them, back out of C.

        with Watch(progress, "simulate") as watch:
            status = lib.trk_...(..., watch.callback, None)
    """

    def __init__(self, progress: Progress, title: str) -> None:
        self.bar: Optional[Bar] = None
        self.report: Optional[Callable[[float], Any]] = None
        self.error: Optional[BaseException] = None
        self.guarded = False
        if callable(progress):
            self.report = progress
        elif progress and sys.stderr is not None and sys.stderr.isatty():
            self.report = self.bar = Bar(title)
        self.callback = _abi.trk_progress(self._called)

    def _called(self, user: Optional[int], fraction: float) -> int:
        try:
            return int(bool(self.error or (self.report and self.report(fraction))))
        except BaseException as error:
            self.error = error
            return 1

    def _interrupt(self, number: int, frame: object) -> None:
        self.error = KeyboardInterrupt()

    def __enter__(self) -> Watch:
        # Python's own handler raises wherever it is, also before the callback can catch it.
        if threading.current_thread() is threading.main_thread() \
                and signal.getsignal(signal.SIGINT) is signal.default_int_handler:
            signal.signal(signal.SIGINT, self._interrupt)
            self.guarded = True
        return self

    def __exit__(self, kind: object, error: Optional[BaseException], trace: object) -> None:
        if self.guarded:
            signal.signal(signal.SIGINT, signal.default_int_handler)
        if self.bar:
            self.bar.close()
        if self.error is not None:  # instead of the CancelledError it led to
            caught, self.error = self.error, None
            raise caught from None
