# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What reading costs: processor time of this version against another, in pairs, on files of a million faces.

scripts/python benchmarks/files/read_in_pairs.py OTHER [--pairs N] [--faces N]

OTHER is a folder with the other version's package laplacian_simplify in it, such as the build/python of a checkout of
an older commit. Each pair is two new processes one after the other, so that what else the machine does meets both.
"""

import argparse
import os
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

# The first mesh pays for imports; the processor time of the second one is measured.
PROGRAM = """
import resource, sys
import laplacian_simplify as ls

ls.load()
ls.read_mesh(sys.argv[1])
before = resource.getrusage(resource.RUSAGE_SELF).ru_utime
ls.read_mesh(sys.argv[2])
used = resource.getrusage(resource.RUSAGE_SELF)
print("measured", used.ru_utime - before, used.ru_maxrss / 1024)
"""


def sheet(faces: int) -> tuple[np.ndarray, np.ndarray]:
    """A wavy sheet of about this many triangles."""
    side = round((faces / 2) ** 0.5) + 1
    x, y = np.meshgrid(np.linspace(0, 1, side), np.linspace(0, 1, side))
    points = np.stack([x, y, 0.05 * np.sin(20 * x) * np.cos(17 * y)], axis=-1).reshape(-1, 3)
    index = np.arange(side * side).reshape(side, side)
    a, b, c, d = (index[i, j].ravel() for i, j in ((_A, _A), (_A, _B), (_B, _B), (_B, _A)))
    return points, np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])


_A, _B = slice(None, -1), slice(1, None)


def write_files(folder: Path, faces: int) -> list[Path]:
    """The same mesh in the formats in question."""
    points, triangles = sheet(faces)
    header = (
        "ply\nformat {} 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
        "element face {}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    rows = np.zeros(len(triangles), [("n", "u1"), ("v", "<i4", 3)])
    rows["n"], rows["v"] = 3, triangles
    with (folder / "binary.ply").open("wb") as file:
        file.write(header.format("binary_little_endian", len(points), len(triangles)).encode())
        file.write(points.astype("<f4").tobytes() + rows.tobytes())
    with (folder / "text.ply").open("w") as file:
        file.write(header.format("ascii", len(points), len(triangles)))
        np.savetxt(file, points, "%.7g")
        np.savetxt(file, np.insert(triangles, 0, 3, axis=1), "%d")
    facets = np.zeros(len(triangles), [("n", "<f4", 3), ("v", "<f4", (3, 3)), ("a", "<u2")])
    facets["v"] = points[triangles]
    (folder / "binary.stl").write_bytes(bytes(80) + np.uint32(len(triangles)).tobytes() + facets.tobytes())
    with (folder / "positions.obj").open("w") as file:
        np.savetxt(file, points, "v %.7f %.7f %.7f")
        np.savetxt(file, triangles + 1, "f %d %d %d")
    with (folder / "full.obj").open("w") as file:
        np.savetxt(file, points, "v %.7f %.7f %.7f")
        np.savetxt(file, points[:, :2], "vt %.6f %.6f")
        np.savetxt(file, points, "vn %.5f %.5f %.5f")
        np.savetxt(file, np.repeat(triangles + 1, 3, axis=1), "f %d/%d/%d %d/%d/%d %d/%d/%d")
    return sorted(folder.iterdir())


def seconds_and_megabytes(package: str, small: Path, file: Path) -> tuple[float, float]:
    """Processor time of one reading, and the most memory that the process had."""
    words = [sys.executable, "-P", "-W", "ignore", "-c", PROGRAM, str(small), str(file)]
    environment = {**os.environ, "PYTHONPATH": package}
    done = subprocess.run(words, env=environment, capture_output=True, text=True, check=True)
    seconds, megabytes = done.stdout.partition("measured ")[2].split()
    return float(seconds), float(megabytes)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("other", metavar="OTHER")
    parser.add_argument("--pairs", type=int, default=5)
    parser.add_argument("--faces", type=int, default=1_000_000)
    options = parser.parse_args()
    this = os.environ["PYTHONPATH"].split(os.pathsep)[0]
    with tempfile.TemporaryDirectory() as name:
        files = write_files(Path(name), options.faces)
        small = Path(__file__).parents[2] / "sample_meshes" / "painted_box.obj"
        print(f"{'file':<16}{'other s':>9}{'this s':>9}{'ratio':>7}  {'MB':>11}  ratios of the pairs")
        for file in files:
            pairs = [
                (seconds_and_megabytes(options.other, small, file), seconds_and_megabytes(this, small, file))
                for _ in range(options.pairs)
            ]
            ratios = [now[0] / before[0] for before, now in pairs]
            print(
                f"{file.name:<16}{statistics.median(before[0] for before, _ in pairs):>9.2f}"
                f"{statistics.median(now[0] for _, now in pairs):>9.2f}{statistics.median(ratios):>7.2f}  "
                f"{pairs[0][0][1]:>4.0f} ->{pairs[0][1][1]:>4.0f}  {' '.join(f'{ratio:.2f}' for ratio in ratios)}",
                flush=True,
            )


if __name__ == "__main__":
    main()
