# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Weighted cost functions: Fig. 5, 11, 12 and 13."""

from drawing import Panel, draw
from page import Check, Entry
from studio import Result, Studio

FUNCTIONS = {"quadric": "quadric error", "melax": "Melax", "shortest_edge": "shortest edge first"}
FIGURES = ["rms", "hausdorff", "feature_rms", "normal_deviation", "seconds"]
COLUMNS = ["rms", "Hausdorff", "feature rms", "normal deviation, °", "s"]
GUIDED = 10.0  # the paper's lambda
DISTANCES = (
    "Distances in percent of the bounding box diagonal; feature rms is measured at the tenth of the vertices with the "
    "largest descriptor."
)
CASES = (  # faces before and after in the paper, of each model
    ("cow", 5804, 2052),
    ("fandisk", 13098, 4000),
    ("bunny", 69451, 4081),
    ("bunny", 69451, 6924),
    ("mech_a", 15000, 4000),
    ("mech_a", 30000, 5000),
    ("mech_b", 30000, 5000),
    ("girl", 30000, 11000),
)


def target_faces(studio: Studio, role: str, before: int, after: int) -> int:
    """As many faces as keep the paper's ratio on our model."""
    return round(len(studio.models[role].mesh.faces) * after / before)


def figures(result: Result) -> list:
    """The columns of a result."""
    return [result.numbers[name] for name in FIGURES]


def pair(studio: Studio, role: str, target: int, function: str) -> tuple[Result, Result]:
    """Plain and guided."""
    plain, guided = (
        studio.decimate(role, target, error_function=function, feature_weight=weight) for weight in (0.0, GUIDED)
    )
    return plain, guided


def shortest_edge(studio: Studio) -> Entry:
    """Fig. 5."""
    model = studio.models["girl"]
    target = target_faces(studio, "girl", 30000, 11000)
    plain, guided = pair(studio, "girl", target, "shortest_edge")
    draw(
        [
            Panel("(a) original", model.mesh),
            Panel("(b) shortest edge first", plain.mesh),
            Panel("(c) guided", guided.mesh),
        ],
        model.name,
        studio.pictures / "figure_5.png",
    )
    return Entry(
        title="Fig. 5: guided shortest edge first",
        claim="Weighted by the Laplacian descriptor, shortest edge first preserves features that it otherwise loses.",
        pictures=[("figure_5.png", f"{model.name}: {len(model.mesh.faces)} faces, and {target} with either cost")],
        columns=["shortest edge first", "faces", *COLUMNS],
        rows=[
            ["plain", len(plain.mesh.faces), *figures(plain)],
            ["guided, λ = 10", len(guided.mesh.faces), *figures(guided)],
        ],
        checks=[
            Check("feature rms is lower", guided.numbers["feature_rms"] < plain.numbers["feature_rms"]),
            Check("normal deviation is lower", guided.numbers["normal_deviation"] < plain.numbers["normal_deviation"]),
            Check("rms is lower too", guided.numbers["rms"] < plain.numbers["rms"]),
        ],
        notes=[DISTANCES],
    )


def error_functions(studio: Studio) -> Entry:
    """Fig. 11, and the same for every model and reduction of the paper."""
    shown = (("cow", 5804, 2052, "quadric"), ("bunny", 69451, 4081, "melax"), ("mech_a", 15000, 4000, "shortest_edge"))
    pictures = []
    for role, before, after, function in shown:
        plain, guided = pair(studio, role, target_faces(studio, role, before, after), function)
        name = f"figure_11_{role}.png"
        draw(
            [Panel(FUNCTIONS[function], plain.mesh, edges=True), Panel("guided", guided.mesh, edges=True)],
            studio.models[role].name,
            studio.pictures / name,
        )
        pictures.append(
            (
                name,
                f"{studio.models[role].name}: {FUNCTIONS[function]}, plain and guided, {len(guided.mesh.faces)} faces",
            )
        )
    rows, checks, exceptions = [], [], []
    for function, words in FUNCTIONS.items():
        wins, cases = 0, sorted({(role, target_faces(studio, role, b, a)) for role, b, a in CASES})
        for role, target in cases:
            plain, guided = pair(studio, role, target, function)
            won = guided.numbers["feature_rms"] < plain.numbers["feature_rms"]
            wins += won
            if not won:
                exceptions.append(f"{words} on {studio.models[role].name} at {target} faces")
            for weight, result in ((0, plain), (10, guided)):
                rows.append([words, weight, studio.models[role].name, len(result.mesh.faces), *figures(result)])
        checks.append(
            Check(
                f"{words}: guided has the lower feature rms in at least 9 of 10 cases ({wins} of {len(cases)})",
                wins >= 0.9 * len(cases),
            )
        )
    return Entry(
        title="Fig. 11: three error functions",
        claim="Guidance by the Laplacian descriptor makes different error functions preserve features.",
        pictures=pictures,
        columns=["error function", "λ", "model", "faces", *COLUMNS],
        rows=rows,
        checks=checks,
        notes=[
            DISTANCES,
            "Exceptions, where guidance has the higher feature rms: " + ("; ".join(exceptions) or "none") + ".",
        ],
    )


def weights(studio: Studio) -> Entry:
    """Fig. 12."""
    model = studio.models["cow"]
    target = target_faces(studio, "cow", 3000, 2000)
    results = {
        weight: studio.decimate("cow", target, error_function="quadric", feature_weight=float(weight))
        for weight in (0, 1, 10, 50)
    }
    draw(
        [Panel(f"λ = {weight}", results[weight].mesh, edges=True) for weight in (1, 10, 50)],
        model.name,
        studio.pictures / "figure_12.png",
    )
    feature = {weight: result.numbers["feature_rms"] for weight, result in results.items()}
    return Entry(
        title="Fig. 12: the weight of features",
        claim="λ alone controls how many features are retained.",
        pictures=[("figure_12.png", f"{model.name}: guided quadric error, {target} faces")],
        columns=["λ", "faces", *COLUMNS],
        rows=[[weight, len(result.mesh.faces), *figures(result)] for weight, result in results.items()],
        checks=[
            Check("feature rms falls from λ = 0 to 1", feature[1] < feature[0]),
            Check("feature rms falls from λ = 1 to 10", feature[10] < feature[1]),
            Check("feature rms falls further from λ = 10 to 50", feature[50] < feature[10]),
        ],
        notes=[DISTANCES],
    )


def curvatures(studio: Studio) -> Entry:
    """Fig. 13."""
    model = studio.models["bunny"]
    target = target_faces(studio, "bunny", 69451, 6924)
    settings = {
        "curvature estimation, λ = 10": {"descriptor": "curvature_estimation", "feature_weight": GUIDED},
        "Laplacian, λ = 10": {"descriptor": "laplacian", "feature_weight": GUIDED},
        "curvature-weighted quadrics": {"descriptor": "curvature_weighted_quadric"},
        "plain quadric error": {"feature_weight": 0.0},
    }
    results = {
        name: studio.decimate("bunny", target, error_function="quadric", **values) for name, values in settings.items()
    }
    names = list(results)
    draw(
        [Panel(f"({letter}) {name}", results[name].mesh) for letter, name in zip("abc", names[:3], strict=True)],
        model.name,
        studio.pictures / "figure_13.png",
    )
    feature = {name: result.numbers["feature_rms"] for name, result in results.items()}
    return Entry(
        title="Fig. 13: compared with curvature",
        claim="Laplacian guidance and curvature-weighted quadrics preserve details better than guidance by curvature "
        "estimation.",
        pictures=[("figure_13.png", f"{model.name}: {target} faces each")],
        columns=["quadric error", "faces", *COLUMNS],
        rows=[[name, len(result.mesh.faces), *figures(result)] for name, result in results.items()],
        checks=[
            Check(
                "Laplacian guidance has a lower feature rms than curvature estimation",
                feature[names[1]] < feature[names[0]],
            ),
            Check(
                "curvature-weighted quadrics have a lower feature rms than curvature estimation",
                feature[names[2]] < feature[names[0]],
            ),
        ],
        notes=[DISTANCES],
    )
