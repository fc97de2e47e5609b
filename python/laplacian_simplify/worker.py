# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Work in a process of its own: a crash of pymeshlab ends as a message, its talk never reaches standard output."""

import multiprocessing
import os
import re
import signal
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from multiprocessing.connection import Connection
from typing import Any, NoReturn

_STOPPING = (signal.SIGINT, signal.SIGTERM)

Progress = Callable[[int, str], None]

# pymeshlab, when it is verbose, writes what filters report as progress to standard error in this form.
_PROGRESS = re.compile(r"LOG: \d+ (.*?)\s*\[ (\d+)% \]")


@contextmanager
def signals_held() -> Iterator[None]:
    """Ctrl+C and SIGTERM wait: what is begun here, such as a scratch folder, is also ended.

    Both are let in, as KeyboardInterrupt, while run_in_worker waits, and at the end.
    """
    before = signal.signal(signal.SIGTERM, _interrupted)
    mask = signal.pthread_sigmask(signal.SIG_BLOCK, _STOPPING)
    try:
        yield
    finally:
        try:
            signal.pthread_sigmask(signal.SIG_SETMASK, mask)
        finally:
            signal.signal(signal.SIGTERM, before)


def _interrupted(_number: int, _frame: object) -> NoReturn:
    raise KeyboardInterrupt


def run_in_worker(job: Callable[[], Any], on_progress: Progress) -> Any:
    """Runs the job in a child process and returns what it returns, which must be small and of plain types.

    Raises:
        ChildProcessError: the process crashed.
        OSError, ValueError, RuntimeError: whatever the job raised, with its text.
    """
    context = multiprocessing.get_context("fork")  # the child starts with nothing of pymeshlab loaded
    receiver, sender = context.Pipe(duplex=False)
    log_in, log_out = os.pipe()
    process = context.Process(target=_work, args=(job, sender, log_out), daemon=True)
    process.start()
    sender.close()
    os.close(log_out)
    try:
        _follow(log_in, on_progress)
        succeeded, outcome = receiver.recv()
    except EOFError:
        process.join()
        raise ChildProcessError(f"pymeshlab crashed ({_cause(process.exitcode)})") from None
    finally:
        process.kill()
        process.join()
    if not succeeded:
        raise outcome
    return outcome


def _work(job: Callable[[], Any], sender: Connection, log_out: int) -> None:
    os.dup2(log_out, 1)
    os.dup2(log_out, 2)
    try:
        sender.send((True, job()))
    except (OSError, ValueError, RuntimeError) as error:
        sender.send((False, error))
    except Exception as error:
        sender.send((False, RuntimeError(f"internal error: {type(error).__name__}: {error}")))


def _follow(log_in: int, on_progress: Progress) -> None:
    """Passes progress on until the child has closed its log; here signals are let in."""
    with open(log_in, errors="replace") as log:
        mask = signal.pthread_sigmask(signal.SIG_UNBLOCK, _STOPPING)
        try:
            for line in log:
                found = _PROGRESS.search(line)
                if found:
                    on_progress(int(found[2]), found[1])
        finally:
            signal.pthread_sigmask(signal.SIG_SETMASK, mask)


def _cause(exit_code: int | None) -> str:
    if exit_code is not None and exit_code < 0:
        return signal.Signals(-exit_code).name
    return f"exit code {exit_code}"
