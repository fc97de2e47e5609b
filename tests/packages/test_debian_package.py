# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The .deb in a Debian 12 of its own, with that release's MeshLab."""

import os
import shutil
import subprocess
import sysconfig
from collections.abc import Iterator
from pathlib import Path

import pytest

from conftest import FLANGE, Run, faces_in, package, run
from display import Display
from host_programs import CACHE

DEBIAN = CACHE / "debian-12" / "root"
NAME = "meshlab-plugin-laplacian-simplify"
PLUGIN = f"usr/lib/{sysconfig.get_config_var('MULTIARCH')}/meshlab/plugins/libfilter_laplacian_simplify.so"
CHANGING = ("var/lib/dpkg", "var/log", "var/cache", "root", "tmp", "run", "etc/ld.so.cache")
"""What installing any package changes, and where MeshLab keeps settings."""


@pytest.fixture(scope="module")
def debian(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    if os.geteuid() != 0 or not DEBIAN.is_dir() or run("unshare", "--mount", "true").returncode != 0:
        pytest.skip("the .deb: only root, free to mount, can run a Debian of its own")
    root = tmp_path_factory.mktemp("debian") / "root"
    subprocess.run(["cp", "-a", "--reflink=auto", DEBIAN, root], check=True)
    yield root
    shutil.rmtree(root)


def inside(root: Path, *words: str, display: str = "") -> Run:
    """Runs a command in the Debian. Programs find their libraries by /proc, which is mounted for the command alone."""
    mounted = 'mount -t proc proc "$0/proc" && exec chroot "$0" "$@"'
    environment = {"PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "HOME": "/root", "LC_ALL": "C.UTF-8", "DISPLAY": display}
    return run("unshare", "--mount", "sh", "-c", mounted, root, *words, env=environment)


def files_of(root: Path) -> set[Path]:
    found = {path.relative_to(root) for path in root.rglob("*")}
    return {path for path in found if not str(path).startswith(CHANGING)}


def test_installed_meshlabserver_has_the_filter_and_removal_leaves_nothing(
    debian: Path, display: Display, script: Path
) -> None:
    before = files_of(debian)
    shutil.copy(package("*.deb"), debian / "tmp" / "plugin.deb")
    done = inside(debian, "dpkg", "-i", "/tmp/plugin.deb")
    assert done.returncode == 0, done.stdout
    assert (debian / PLUGIN).is_file()
    shutil.copy(script, debian / "tmp" / "script.mlx")
    shutil.copy(FLANGE, debian / "tmp" / "flange.ply")
    words = ["meshlabserver", "-i", "/tmp/flange.ply", "-o", "/tmp/small.ply", "-s", "/tmp/script.mlx"]
    ran = inside(debian, *words, display=display.name)
    assert ran.returncode == 0, ran.stdout
    assert faces_in(debian / "tmp" / "small.ply") == 1000
    done = inside(debian, "dpkg", "--purge", NAME)
    assert done.returncode == 0, done.stdout
    assert files_of(debian) == before


def test_it_depends_on_the_meshlab_that_it_fits(debian: Path) -> None:
    """MeshLab 2020.09 loads any plugin without asking what it was built for."""
    control = run("dpkg-deb", "--field", package("*.deb"), "Depends").stdout
    assert "meshlab (>= 2020.09), meshlab (<< 2020.10)" in control
    status = debian / "var/lib/dpkg/status"
    kept = status.read_text()
    shutil.copy(package("*.deb"), debian / "tmp" / "plugin.deb")
    try:
        status.write_text(kept.replace("Version: 2020.09+dfsg1", "Version: 2022.02+dfsg1"))
        done = inside(debian, "dpkg", "-i", "/tmp/plugin.deb")
    finally:
        status.write_text(kept)
        (debian / PLUGIN).unlink(missing_ok=True)
    assert done.returncode != 0
    assert f"{NAME} depends on meshlab (<< 2020.10)" in done.stdout


def test_lintian_finds_nothing_but_that_the_project_has_no_address() -> None:
    """No mail address of the maintainer, and no bug that asked for the package."""
    found = run("lintian", "--allow-root", package("*.deb")).stdout.splitlines()
    tags = {line.split(": ")[-1].split()[0] for line in found if not line.startswith("N:")}
    assert tags <= {"malformed-contact", "bogus-mail-host-in-debian-changelog", "initial-upload-closes-no-bugs"}
