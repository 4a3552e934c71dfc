"""How far a run is."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any

Follow = Callable[[str, int, int], Any]


def follower(progress: Any) -> Follow | None:
    """What the library tells: nobody, a bar, or the user's function."""
    if progress is None or progress is False:
        return None
    if progress is True:
        return _bar()
    if not callable(progress):
        raise ValueError(f"progress is True, False or a function, not {progress!r}")
    follow: Follow = progress
    return follow


def _bar() -> Follow:
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return _line
    bars: dict[str, Any] = {}

    def show(stage: str, done: int, total: int) -> None:
        """A bar for each stage, by its layers."""
        bar = bars.get(stage)
        if bar is None:
            bar = bars[stage] = tqdm(total=total, desc=stage, unit="layer", leave=False)
        bar.update(done - bar.n)
        if done >= total:
            bar.close()
            del bars[stage]

    return show


def _line(stage: str, done: int, total: int) -> None:
    """One line, on a terminal alone."""
    if sys.stderr.isatty():
        print(f"\r{stage} {done}/{total}\033[K", end="" if done < total else "\r\033[K",
              file=sys.stderr, flush=True)
