# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests in the hosts share: the tables of the plugin, a display, a MeshLab of every version."""

import json
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

import script_hosts
from display import Display, running_display
from host_programs import PROJECT, HostProgram, built_plugin, install_host
from script_hosts import ScriptHost

HOSTS = ["meshlab-2020.09", "meshlab-2022.02", "meshlab-2025.07", "pymeshlab-2025.7"]
TABLES = PROJECT / "build" / "pymeshlab-2025.7" / "tables.json"


def all_filters() -> list[dict]:
    """The rows of the plugin's own table of filters."""
    return json.loads(TABLES.read_text(encoding="utf-8"))["filters"]


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """A test that asks for ``filter_row`` runs once for every filter of the table."""
    if "filter_row" in metafunc.fixturenames:
        rows = all_filters()
        metafunc.parametrize("filter_row", rows, ids=[row["id"] for row in rows])


@pytest.fixture(scope="session")
def filters() -> list[dict]:
    return all_filters()


@pytest.fixture(scope="session")
def part() -> Path:
    """A mechanical part: sharp edges, fillets, a bore."""
    return PROJECT / "sample_meshes" / "flange.ply"


@pytest.fixture(scope="session")
def display(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Display]:
    with running_display(tmp_path_factory.mktemp("display") / "server.log") as running:
        yield running


@pytest.fixture(scope="session")
def installed_host(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], HostProgram]:
    """MeshLab of a version with the plugin that was built for it, installed once a session."""
    hosts: dict[str, HostProgram] = {}

    def host(version: str) -> HostProgram:
        if version not in hosts:
            folder = tmp_path_factory.mktemp(f"meshlab-{version}")
            hosts[version] = install_host(version, folder, built_plugin(f"meshlab-{version}"))
        return hosts[version]

    return host


@pytest.fixture(params=HOSTS)
def run_script(
    request: pytest.FixtureRequest, display: Display, installed_host: Callable[[str], HostProgram]
) -> ScriptHost:
    if request.param == "pymeshlab-2025.7":
        return script_hosts.pymeshlab
    host = installed_host(request.param.removeprefix("meshlab-"))
    start = script_hosts.meshlabserver if host.version == "2020.09" else script_hosts.script_runner
    return start(host, display.name)
