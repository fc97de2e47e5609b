# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Work in a process of its own: a crash of pymeshlab ends as a message, its talk reaches nobody.

The process is a new one, never a copy of this one: a copy would inherit locks that threads of this one hold, and wait
for them for ever. It dies with the process that started it.
"""

import contextlib
import ctypes
import json
import os
import signal
import subprocess
import sys
import traceback
from collections.abc import Callable
from importlib import import_module
from typing import IO, Any, TypeAlias

# A name of a function and its arguments, all of plain types.
Job: TypeAlias = dict[str, Any]
Stage = Callable[[str], None]

# Nothing is imported from the folder that the process happens to be in.
_BOOT = (
    "import sys; sys.path[:] = filter(None, sys.path); import json; sys.path[:] = json.loads(sys.argv[2]); "
    "from laplacian_simplify.child import serve; serve()"
)
_ERRORS: dict[str, type[Exception]] = {
    error.__name__: error for error in (OSError, ValueError, RuntimeError, MemoryError, ImportError, FileNotFoundError)
}
_DIE_WITH_PARENT = 1  # PR_SET_PDEATHSIG


class ChildCrashError(Exception):
    """The process ended without an answer."""

    def __init__(self, cause: str, stage: str) -> None:
        super().__init__(cause)
        self.cause = cause
        """SIGSEGV, exit code 3, ..."""
        self.stage = stage
        """What it said last that it was doing; empty where it said nothing."""


class Child:
    """A process that runs one function of this package."""

    def __init__(
        self, function: str, arguments: Job, *, log: bool = False, standard_input: bool = False, scratch: str = ""
    ) -> None:
        """Starts it.

        Args:
            function: module and name, such as "work:simplify"; it gets a function to call with the stage that begins,
                then the arguments.
            arguments: keyword arguments of plain types.
            log: keep what it writes to the standard streams as text in self.log, which has to be read to the end;
                otherwise it is thrown away.
            standard_input: it may read that of this process.
            scratch: where it makes its scratch folders, which stay there when it is killed.
        """
        self._answers, answers = os.pipe()
        job = {"function": function, "arguments": arguments, "parent": os.getpid(), "answers": answers}
        words = [sys.executable, "-c", _BOOT, json.dumps(job), json.dumps(sys.path)]
        sink = subprocess.PIPE if log else subprocess.DEVNULL
        input_of = None if standard_input else subprocess.DEVNULL
        environment = {**os.environ, "TMPDIR": scratch} if scratch else None
        try:
            self._process = subprocess.Popen(
                words, stdin=input_of, stdout=sink, stderr=subprocess.STDOUT, pass_fds=[answers], env=environment
            )
        except BaseException:
            os.close(self._answers)
            raise
        finally:
            os.close(answers)
        self.log: IO[bytes] | None = self._process.stdout

    def answer(self, timeout: float | None = None) -> Any:
        """Waits for the end and returns what the function returned.

        Raises:
            ChildCrashError: the process ended without an answer.
            OSError, ValueError, RuntimeError, ImportError: whatever the function raised, with its text.
            subprocess.TimeoutExpired: it did not end in this many seconds; it has been killed.
        """
        try:
            with os.fdopen(self._answers, encoding="utf-8") as answers:
                if timeout is not None:
                    self._process.wait(timeout)
                lines = [json.loads(line) for line in answers]
            self._process.wait()
        finally:
            self.end()
        stage = next((line["stage"] for line in reversed(lines) if "stage" in line), "")
        if not lines or "stage" in lines[-1]:
            raise ChildCrashError(cause_of(self._process.returncode), stage)
        if "error" in lines[-1]:
            raise _ERRORS.get(lines[-1]["type"], RuntimeError)(lines[-1]["error"])
        return lines[-1]["result"]

    def end(self) -> None:
        """Ends the process, where it has not ended by itself."""
        self._process.kill()
        self._process.wait()
        if self.log:
            self.log.close()


def serve() -> None:
    """What the process does: runs the function and answers."""
    job: Job = json.loads(sys.argv[1])
    die_with(job["parent"])
    with os.fdopen(job["answers"], "w", encoding="utf-8", buffering=1) as answers:

        def answer(**line: Any) -> None:
            print(json.dumps(line), file=answers)

        module, _, name = job["function"].partition(":")
        try:
            function = getattr(import_module(f"laplacian_simplify.{module}"), name)
            answer(result=function(lambda stage: answer(stage=stage), **job["arguments"]))
        except (OSError, ValueError, RuntimeError, MemoryError, ImportError) as error:
            kind = next(known.__name__ for known in type(error).__mro__ if known.__name__ in _ERRORS)
            answer(type=kind, error=str(error) or type(error).__name__)
        except Exception as error:
            place = traceback.extract_tb(error.__traceback__)[-1]
            text = f"internal error: {type(error).__name__}: {error} (line {place.lineno} of {place.name})"
            answer(type="RuntimeError", error=text)
    os._exit(0)  # what pymeshlab does at its end is of no use any more


def die_with(parent: int) -> None:
    """Ends this process when the one that started it ends, however that happens."""
    with contextlib.suppress(OSError, AttributeError, TypeError):
        ctypes.CDLL(None).prctl(_DIE_WITH_PARENT, signal.SIGKILL)
    if os.getppid() != parent:  # it ended before
        os._exit(1)


def cause_of(exit_code: int) -> str:
    if exit_code < 0:
        with contextlib.suppress(ValueError):
            return signal.Signals(-exit_code).name
    return f"exit code {exit_code}"
