# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The corpus through the core and the C functions, in the program hostile_cases, which was built with sanitizers."""

import signal
import struct
import subprocess
import tempfile
from collections.abc import Iterable, Iterator
from pathlib import Path

from host_runs import Run
from hostile_meshes import HostileMesh
from mesh_bytes import CoreSetting, bytes_of
from refusals import fault_of_a_refusal


def core_runs(
    program: Path, meshes: list[HostileMesh], settings: list[CoreSetting], jobs: Iterable[tuple[int, int]]
) -> Iterator[Run]:
    """Runs the jobs, which are numbers of a mesh and of a setting; goes on after one that ended the program."""
    wanted = list(jobs)
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "cases"
        with file.open("wb") as cases:
            for mesh, setting in wanted:
                content = bytes_of(meshes[mesh], settings[setting])
                cases.write(struct.pack("<I", len(content)) + content)
        first = 0
        while first < len(wanted):
            for number, kind, seconds, said in _endings(program, file, first):
                mesh, setting = wanted[number]
                first = number + 1
                yield _checked(Run(meshes[mesh].name, settings[setting].name, kind, said, seconds))


def _checked(run: Run) -> Run:
    by_a_precondition = not run.said
    fault = fault_of_a_refusal(run.said) if run.kind == "refused" and not by_a_precondition else ""
    return Run(run.mesh, run.setting, "fault", f"{fault}: {run.said}", run.seconds) if fault else run


def _endings(program: Path, file: Path, first: int) -> Iterator[tuple[int, str, float, str]]:
    """Number of the case, how it ended, seconds, and what was said, until the program ends."""
    with tempfile.TemporaryFile("w+") as errors:
        child = subprocess.Popen([program, file, str(first)], stdout=subprocess.PIPE, stderr=errors, text=True)
        assert child.stdout
        number = None
        for line in child.stdout:
            words = line.rstrip("\n").split("\t")
            if len(words) == 1:
                number = int(words[0])
                continue
            yield int(number or 0), words[0], float(words[1]), words[2]
            number = None
        code = child.wait()
        errors.seek(0)
        if number is not None:
            yield number, "fault", 0.0, _end_in_words(code, errors.read())
        elif code != 0:
            raise RuntimeError(f"{program} ended with {code}: {errors.read()}")


def _end_in_words(code: int, report: str) -> str:
    """The line of the sanitizer that says what happened, and the first of the project's places that it names."""
    lines = report.splitlines()
    telling = ("runtime error", "ERROR: ", "ThreadSanitizer: ")
    what = next((line.strip() for line in lines if any(words in line for words in telling)), "")
    place = next((line.split()[-1] for line in lines if "vcg_ext/" in line or "python/library/" in line), "")
    if code == -signal.SIGXCPU:
        return "it took more processor time than it may"
    return f"the program ended with {code}: {what} {place}".strip()
