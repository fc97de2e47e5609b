# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Signals that stop the command: what is begun, such as a scratch folder, is also ended."""

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import NoReturn

_STOPPING = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


def die_at_once() -> None:
    """Ctrl+C ends the process without a word, as long as it has nothing to clean up."""
    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
        signal.signal(signal.SIGINT, signal.SIG_DFL)


@contextmanager
def signals_held() -> Iterator[None]:
    """Ctrl+C, SIGTERM and SIGHUP wait, but those that this process ignores, as nohup makes it.

    They come as KeyboardInterrupt within ``signals_let_in``, and at the end. Other threads than the first one get no
    signals: there it does nothing.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = {number: signal.getsignal(number) for number in _STOPPING}
    heard = [number for number, handler in before.items() if handler is not signal.SIG_IGN]
    mask = signal.pthread_sigmask(signal.SIG_BLOCK, heard)
    for number in heard:
        signal.signal(number, _interrupted)
    try:
        yield
    finally:
        try:
            signal.pthread_sigmask(signal.SIG_SETMASK, mask)
        finally:
            for number in heard:
                signal.signal(number, before[number])


@contextmanager
def signals_let_in() -> Iterator[None]:
    """Signals that were held come here."""
    mask = signal.pthread_sigmask(signal.SIG_UNBLOCK, _STOPPING)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, mask)


def _interrupted(_number: int, _frame: object) -> NoReturn:
    raise KeyboardInterrupt
