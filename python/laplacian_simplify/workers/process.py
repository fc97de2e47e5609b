# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A process that does one job after the other; what a mesh may do to it, it does to this process alone.

A job is a function of this package, which gets a function to call with the stage that begins, then its arguments.
"""

import contextlib
import json
import os
import resource
import select
import signal
import subprocess
import sys
import time
from collections.abc import Mapping
from dataclasses import dataclass, field
from importlib import import_module
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, TypeAlias

from ..child import cause_of, die_with

Job: TypeAlias = dict[str, Any]
Answer: TypeAlias = dict[str, Any]

_BOOT = (
    "import sys; sys.path[:] = filter(None, sys.path); import json; sys.path[:] = json.loads(sys.argv[2]); "
    "from laplacian_simplify.workers.process import serve; serve()"
)
_MOST_JOBS = 500  # then a new one takes over, whatever this one may have lost of its memory
# What is said of the machine, not of the mesh: the next run tries again.
_PASSING = (
    "not enough memory",
    "bad_alloc",
    "can't start new thread",
    "no room for a copy",
    "Permission denied",
    "does not exist",
)


@dataclass(frozen=True)
class Kind:
    """What processes of one command have in common."""

    threads: int
    """What their libraries may use by themselves."""
    prepare: str = ""
    """A function that is called first, so that what it takes is not counted as memory of a job."""
    doing: Mapping[str, str] = field(default_factory=dict)
    """How messages name stages."""


class WorkerProcess:
    """The process, from outside."""

    def __init__(self, scratch: str, kind: Kind) -> None:
        """Starts it.

        Args:
            scratch: a folder for its scratch files, which go when it ends.
            kind: what it is for.
        """
        self._kind = kind
        self._scratch = TemporaryDirectory(prefix="process-", dir=scratch, ignore_cleanup_errors=True)
        self._answers, answers = os.pipe()
        about = json.dumps([os.getpid(), answers, kind.prepare])
        words = [sys.executable, "-c", _BOOT, about, json.dumps(sys.path)]
        numbers = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"), str(kind.threads))
        try:
            self._process = subprocess.Popen(
                words,
                stdin=subprocess.PIPE,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
                pass_fds=[answers],
                env={**os.environ, "TMPDIR": self._scratch.name, **numbers},
            )
        except BaseException:
            os.close(self._answers)
            self._scratch.cleanup()
            raise
        finally:
            os.close(answers)
        self._received = b""
        self._jobs = 0

    @property
    def is_worn(self) -> bool:
        """Whether another one should take its place."""
        return self._jobs >= _MOST_JOBS or self._process.poll() is not None

    def run(self, job: Job, seconds: float) -> Answer:
        """Does a job. After an answer with ``"status": "crashed"`` the process is gone.

        Args:
            job: function, such as "work:run", which returns a dictionary; its arguments; and memory, the bytes that it
                may take more than it has.
            seconds: how long it may take.
        """
        self._jobs += 1
        deadline = time.monotonic() + seconds
        stage = "starting"
        try:
            assert self._process.stdin is not None
            self._process.stdin.write(json.dumps(job).encode() + b"\n")
            self._process.stdin.flush()
            while (answer := self._next(deadline)) is not None:
                if "stage" not in answer:
                    return answer
                stage = answer["stage"]
        except TimeoutError:
            self.end()
            return {"status": "crashed", "reason": f"{self._doing(stage)} took more than {seconds:g} s"}
        except BrokenPipeError:
            pass
        self._process.wait()
        cause = cause_of(self._process.returncode)
        self.end()
        hint = ", as happens where memory runs out" if cause == "SIGKILL" else ""
        return {"status": "crashed", "reason": f"{self._doing(stage)} crashed ({cause}{hint})", "cause": cause}

    def _doing(self, stage: str) -> str:
        return self._kind.doing.get(stage, "the process for it")

    def _next(self, deadline: float) -> Answer | None:
        """The next line that the process says, or nothing where it has ended."""
        while b"\n" not in self._received:
            left = deadline - time.monotonic()
            if left <= 0 or not select.select([self._answers], [], [], left)[0]:
                raise TimeoutError
            piece = os.read(self._answers, 1 << 16)
            if not piece:
                return None
            self._received += piece
        line, _, self._received = self._received.partition(b"\n")
        answer: Answer = json.loads(line)
        return answer

    def kill(self) -> None:
        """Ends the process, from any thread; the one that waits for it gets an answer."""
        self._process.kill()

    def end(self) -> None:
        """Ends the process and lets go of what belongs to it."""
        self._process.kill()
        self._process.wait()
        with contextlib.suppress(OSError):
            assert self._process.stdin is not None
            self._process.stdin.close()
        if self._answers >= 0:
            os.close(self._answers)
            self._answers = -1
        self._scratch.cleanup()


def serve() -> None:
    """What the process does."""
    parent, number, prepare = json.loads(sys.argv[1])
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl+C is for the one who started it
    die_with(parent)
    with os.fdopen(number, "w", encoding="utf-8", buffering=1) as answers:

        def say(line: Answer) -> None:
            print(json.dumps(line), file=answers)

        if prepare:
            with contextlib.suppress(ImportError):  # a job will say it
                _function(prepare)()
        for line in sys.stdin.buffer:
            job = json.loads(line)
            with _memory(job.pop("memory")):
                say(_done(job, say))
    os._exit(0)


def _function(name: str) -> Any:
    module, _, function = name.partition(":")
    return getattr(import_module(f"laplacian_simplify.{module}"), function)


def _done(job: Job, say: Any) -> Answer:
    now = ""

    def stage(begins: str) -> None:
        nonlocal now
        now = begins
        say({"stage": begins})

    try:
        return {"status": "done", **_function(job["function"])(stage, **job["arguments"])}
    except MemoryError:
        return {"status": "refused", "reason": "not enough memory for it; give more by --memory", "again": True}
    except (OSError, ValueError, RuntimeError) as error:
        reason = str(error) or type(error).__name__
        again = now == "writing" or any(words in reason for words in _PASSING)
        return {"status": "refused", "reason": reason, **({"again": True} if again else {})}
    except Exception as error:
        return {"status": "refused", "reason": f"internal error: {type(error).__name__}: {error}", "again": True}


@contextlib.contextmanager
def _memory(more: int) -> Any:
    """Bounds the address space: what is taken now, and this many bytes more."""
    taken = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
    soft, hard = resource.getrlimit(resource.RLIMIT_AS)
    most = taken + more if hard == resource.RLIM_INFINITY else min(taken + more, hard)
    resource.setrlimit(resource.RLIMIT_AS, (most, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_AS, (soft, hard))
