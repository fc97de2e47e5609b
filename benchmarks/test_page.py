# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page hides nothing: what is behind is bold, and what was not measured says so."""

import pytest

import runs
from meshes import GROUPS, PERCENTS, BenchmarkMesh
from page_aims import Aim, aim_lines, aims_by_subject, distance_aims, runs_behind, validity_aims
from page_geometry import look_table, tool_table
from page_speed import growth_factor, input_name, pair_table, speed_table
from page_validity import validity_lines
from ratio_tables import cells
from runs import Store, Workshop, run_tool
from timing import ratio_of_least, ratios

NAMES = [name for names in GROUPS.values() for name in names]


def table(**figures) -> dict:
    """A tool's runs on all meshes with the same figures."""
    usual = {"rms": 1.0, "feature_rms": 1.0, "hausdorff": 1.0, "normal_deviation": 1.0, "perceptual": 0.5}
    return {f"{name}_{percent}": {**usual, **figures} for name in NAMES for percent in PERCENTS}


def clean_run(**figures) -> dict:
    """A run of the section on validity."""
    topology = ("non_manifold_edges", "non_manifold_vertices", "duplicate_faces", "degenerate_faces")
    return {"faces": 10, "target": 10, "folded_faces": 0, **{f"new_{fault}": 0 for fault in topology}, **figures}


def timed(*seconds: float) -> list[dict]:
    return [{"cpu_seconds": s, "wall_seconds": s, "peak_bytes": 100, "others": 0.5} for s in seconds]


def test_an_aim_that_is_missed_is_bold_and_shows_by_how_much():
    assert Aim("a", 0.9, 0.8).row() == "| a | 0.9 | 0.8 |"
    assert Aim("a", 0.9, 0.95).row() == "| a | 0.9 | **0.95** |"
    assert Aim("a", 1.02, 1.0204).row() == "| a | 1.02 | **1.0204** |"
    assert Aim("a", None, 3.0).row() == "| a | no aim | 3 |"


def test_aims_without_figures_are_listed_and_not_met():
    aims = [aim for found in aims_by_subject({}).values() for aim in found]
    assert len(aims) > 50
    assert not any(aim.met for aim in aims)
    assert all("not measured" in aim.row() for aim in aims)
    assert any("0 of" in line and "were not measured" in line for line in aim_lines({}))


def test_only_refinement_aims_at_the_normals():
    section = {"cgal_lt": table(), "cgal_gh": table(), "pymeshlab": table()}
    section |= {peer: table(rms=0.9, normal_deviation=1.1) for peer in ("fast", "balanced")}
    rows = {
        peer: next(aim for aim in distance_aims(section, peer) if "normal deviation" in aim.text)
        for peer in ("fast", "balanced")
    }
    assert rows["fast"].bound is None
    assert rows["balanced"].bound == 1.07
    assert "**1.1**" in rows["balanced"].row()


def test_a_cell_is_lost_to_the_better_of_both_unless_all_are_tiny():
    def one_run(rms):
        return {("cow", 50): {"rms": rms, "feature_rms": 1.0, "hausdorff": 1.0, "normal_deviation": 1.0}}

    def rms_cell(own, reference, second):
        found = cells(one_run(own), one_run(reference), one_run(second))
        return next(cell for cell in found if cell.axis == "rms")

    assert rms_cell(0.9, 1.0, 0.8).lost
    assert rms_cell(0.9, 1.0, 0.8).to_the_better == pytest.approx(0.9 / 0.8)
    assert not rms_cell(0.7, 1.0, 0.8).lost
    assert not rms_cell(9e-4, 1.0, 1e-4).lost


def test_a_run_behind_the_host_is_named_even_where_it_is_tiny():
    section = {"pymeshlab": table(), "fast": table(rms=0.5, feature_rms=0.5)}
    assert runs_behind(section, "fast") == []
    section["fast"]["cow_50"]["feature_rms"] = 1.0
    section["fast"]["igea_2"]["rms"], section["pymeshlab"]["igea_2"]["rms"] = 2e-5, 1e-5
    assert runs_behind(section, "fast") == ["cow 50 %", "igea 2 % (all below 0.001 % of the diagonal)"]


def validity_section() -> dict:
    tools = {peer: {"cow_50": clean_run(), "cow_1": clean_run()} for peer in ("cgal_lt", "fast", "balanced")}
    tools["cgal_lt"]["cow_50"]["folded_faces"] = 2
    tools["fast"]["cow_50"]["folded_faces"] = 3
    tools["balanced"]["cow_1"] |= {"faces": 11, "new_non_manifold_edges": 1}
    return {"faces": {"cow": 100}, "percents": [50, 1], "runs": tools}


def test_validity_names_the_runs_with_more_folded_faces_and_other_faults():
    lines = "\n".join(validity_lines(validity_section()))
    assert "| 3/3 **50 %: 3 > 2** |" in lines
    assert "**balanced: target missed at 1 % (11 faces, not 10), non-manifold edges at 1 %**" in lines


def test_a_mesh_that_the_reference_cannot_take_counts_as_no_folded_face_there():
    section = validity_section()
    section["runs"]["cgal_lt"]["cow_50"] = {"failure": "exit code 1", "target": 50}
    lines = "\n".join(validity_lines(section))
    assert "**50 %: 3 > 0**" in lines
    assert "cow: exit code 1" in lines


def test_every_kind_of_fault_is_counted_among_the_aims():
    section = validity_section()
    section["runs"]["balanced"]["cow_50"] = {"failure": "crashed", "target": 50}
    counts = {aim.text: aim.measured for aim in validity_aims({"validity": section}, "balanced")}
    assert list(counts.values()) == [1, 0, 1, 1, 0]


def test_times_show_the_limit_and_the_load():
    speed = {"faces": 100, "figures": {"cgal_lt": [{"failure": "> 300 s"}], "meshoptimizer_debian": timed(1, 3)}}
    lines = "\n".join(speed_table(speed, "meshoptimizer_debian"))
    assert "| > 300 s |" in lines
    assert "| 2.00 | 2.00 |" in lines
    row = {"tool": "engine_fast", "reference": "meshoptimizer_debian"}
    row["figures"] = {"engine_fast": timed(1, 2, 9), "meshoptimizer_debian": timed(2, 2, 3)}
    lines = "\n".join(pair_table({"igea_loop_1": {"faces": 100, "rows": [row]}}))
    assert "igea, subdivided by Loop's rule" in lines
    assert "| 1.00 (0.50–3.00) | 0.50 |" in lines
    assert "| 0.5 | 3 |" in lines


def test_ratios_are_taken_inside_pairs():
    assert ratios(timed(1, 2, 9), timed(2, 2, 3), "cpu_seconds") == (1, 0.5, 3)
    assert ratio_of_least(timed(1, 2, 9), timed(2, 2, 3), "cpu_seconds") == 0.5


def test_growth_is_counted_from_the_cheaper_mesh_around_a_hundred_thousand_faces():
    rows = [(10_000, 0.001), (80_000, 0.08), (300_000, 0.6), (1_000_000, 1.5)]
    growth = {"rows": [{"faces": faces, "figures": {"engine_fast": timed(s)}} for faces, s in rows]}
    assert growth_factor(growth, "engine_fast") == pytest.approx(1.5)


def test_inputs_are_named_in_words():
    assert input_name("bunny10k_textured") == "bunny10k_textured"
    assert input_name("igea_subdivided_1") == "igea, subdivided at midpoints"
    assert input_name("fandisk_subdivided_2") == "fandisk, subdivided at midpoints 2 times"


def test_the_perceptual_table_has_ratios_by_group_and_leaves_old_figures_out():
    section = {"cgal_lt": table(), "fast": table(perceptual=0.6), "pymeshlab": table()}
    for run in section["pymeshlab"].values():
        del run["perceptual"]
    lines = look_table(section)
    assert len(lines) == 4  # head, rule, fast and the reference itself
    assert lines[2].count("**1.20**") == 9


def test_figures_in_an_older_layout_are_forgotten_but_for_the_geometry(tmp_path):
    path = tmp_path / "results.json"
    path.write_text('{"quality": {"cgal_lt": {}}, "descriptor": {"arrays": "text"}}')
    store = Store(path)
    assert store.section("quality") == {"cgal_lt": {}}
    assert "descriptor" not in store.sections
    store.section("speed")["large"] = "igea"
    store.save()
    assert Store(path).section("speed") == {"large": "igea"}


def test_a_tool_that_fails_says_why_and_one_that_takes_too_long_is_stopped(tmp_path, monkeypatch):
    script = tmp_path / "one_run.py"
    monkeypatch.setattr(runs, "ONE_RUN", script)
    mesh = BenchmarkMesh("cow", "natural", tmp_path / "cow.npz", tmp_path / "cow.ply")
    jobs = [(10, tmp_path / "result.npz")]
    script.write_text("raise SystemExit('no such tool')")
    assert run_tool(Workshop(tmp_path), "cgal_lt", mesh, jobs) == [{"failure": "no such tool"}]
    script.write_text("while True: pass")
    assert run_tool(Workshop(tmp_path), "cgal_lt", mesh, jobs, limit=1) == [{"failure": "> 1 s"}]


def test_a_run_too_short_for_the_clock_does_not_stop_the_page():
    counts = {"faces": 10, "target": 10, "folded_faces": 0, "new_non_manifold_edges": 0}
    section = {"cgal_lt": table(cpu_seconds=1.0, **counts), "fast": table(cpu_seconds=0.5, **counts)}
    section["fast"]["cow_2"]["cpu_seconds"] = section["cgal_lt"]["cow_2"]["cpu_seconds"] = 0.0
    assert tool_table(section)[2].endswith("| 0.50 |")
