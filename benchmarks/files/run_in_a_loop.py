# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the command again and again on a small mesh, on a terminal and off it, and counts runs that do not end.

scripts/python benchmarks/files/run_in_a_loop.py [--runs N] [--at-once N] [--seconds N]

The exit code is 0 where every run ended with its file written.
"""

import argparse
import os
import pty
import subprocess
import sys
import tempfile
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

MESH = "OFF\n5 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n.5 .5 1\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n3 0 2 1\n3 0 3 2\n"


def outcome_of_a_run(folder: Path, number: int, seconds: float) -> str:
    """Every other run has a terminal, where a progress bar is shown."""
    target = folder / f"{number}.ply"
    words = [sys.executable, "-P", "-m", "laplacian_simplify", "simplify", str(folder / "mesh.off"), str(target)]
    ours, theirs = pty.openpty()
    error = theirs if number % 2 else subprocess.PIPE
    process = subprocess.Popen([*words, "--faces", "4"], stdout=subprocess.DEVNULL, stderr=error)
    try:
        process.communicate(timeout=seconds)
    except subprocess.TimeoutExpired:
        process.kill()
        process.communicate()
        return "did not end"
    finally:
        os.close(ours)
        os.close(theirs)
    whole = target.is_file()
    target.unlink(missing_ok=True)
    return "ended" if process.returncode == 0 and whole else f"exit code {process.returncode}, output {whole}"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=3000)
    parser.add_argument("--at-once", type=int, default=os.cpu_count())
    parser.add_argument("--seconds", type=float, default=120, help="after which a run counts as one that does not end")
    options = parser.parse_args()
    counts: Counter[str] = Counter()
    with tempfile.TemporaryDirectory() as name, ThreadPoolExecutor(options.at_once) as pool:
        folder = Path(name)
        (folder / "mesh.off").write_text(MESH)
        runs = [pool.submit(outcome_of_a_run, folder, number, options.seconds) for number in range(options.runs)]
        for number, run in enumerate(runs, start=1):
            counts[run.result()] += 1
            if number % 100 == 0 or number == options.runs:
                print(f"{number} runs: {dict(counts)}", flush=True)
    return 0 if set(counts) == {"ended"} else 1


if __name__ == "__main__":
    sys.exit(main())
