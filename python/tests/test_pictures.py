# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture and the page as people see them: drawn without a display, and opened in a browser."""

import base64
import html
import json
import os
import re
import socket
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from array_meshes import UP, wave, write_off
from conftest import SAMPLE_MESHES, assert_one_line, faces_in, run_command

import laplacian_simplify as ls
from laplacian_simplify import command_line
from laplacian_simplify.pictures import page as pages

PNG = b"\x89PNG\r\n\x1a\n"
SCREENSHOTS = Path(__file__).parents[2] / "build" / "screenshots"
# What a name of a file, a template and a formula could take for their own.
ODD_NAME = "</script><img src=x onerror=alert(1)> & $title $x_1$ 'ä.off"
BROWSER = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]  # as root, and without a GPU


class Display:
    """A display that nobody should ask for anything: it counts who does, and hangs up."""

    def __init__(self) -> None:
        number = 1000 + os.getpid()  # as other tests may run at the same time
        self.name = f":{number}"
        self.asked = 0
        self._listener = socket.socket(socket.AF_UNIX)
        self._listener.bind(f"\0/tmp/.X11-unix/X{number}")  # where clients of X look first
        self._listener.listen()
        threading.Thread(target=self._count, daemon=True).start()

    def _count(self) -> None:
        while True:
            client, _ = self._listener.accept()
            self.asked += 1
            client.close()


class Pages:
    """What simplify draws of a relief, and compare of files with odd names."""

    displays_asked = 0

    def __init__(self, folder: Path) -> None:
        vertices, faces = wave()
        write_off(folder / "wave.off", vertices, faces)
        (folder / "odd").mkdir()
        self.odd = write_off(folder / "odd" / ODD_NAME.replace("/", "_"), vertices, faces)
        self.picture, self.page = folder / "out.png", folder / "out.html"
        self.odd_page = folder / "odd.html"
        words = ["--percent", 10, "--picture", self.picture, "--report", self.page, "--json", folder / "out.json"]
        self.done = run_command("simplify", folder / "wave.off", folder / "small.ply", *words)
        assert self.done.returncode == 0, self.done.stderr
        self.report = json.loads((folder / "out.json").read_text())
        self.compared = ls.compare(self.odd, folder / "small.ply", report=self.odd_page)


@pytest.fixture(scope="module")
def drawn(tmp_path_factory: pytest.TempPathFactory) -> Pages:
    display = Display()
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("DISPLAY", display.name)
        pages = Pages(tmp_path_factory.mktemp("drawn"))
    pages.displays_asked = display.asked
    return pages


def pixels(path: Path) -> np.ndarray:
    """Red, green and blue in 0..1."""
    from matplotlib.image import imread

    return imread(path)[..., :3]


def saturation(image: np.ndarray) -> np.ndarray:
    return image.max(axis=-1) - image.min(axis=-1)


def test_the_picture_has_both_meshes_in_grey_and_the_distance_in_colors(drawn: Pages) -> None:
    assert drawn.picture.read_bytes().startswith(PNG)
    image = pixels(drawn.picture)
    assert image.shape[1] == int((3 * 4.3 + 1.75) * 150)
    body = image[110:-140]
    panels = [body[:, round(k * 4.3 * 150) : round((k + 1) * 4.3 * 150)] for k in range(3)]
    for grey in panels[:2]:
        assert (grey.min(axis=-1) < 0.9).mean() > 0.2  # something is there
        assert saturation(grey).max() < 0.2
    assert (saturation(panels[2]) > 0.4).mean() > 0.05
    bar = body[:, round((3 * 4.3 + 0.78) * 150) :]
    assert saturation(bar).max() > 0.5


def test_a_display_that_is_there_is_not_asked(drawn: Pages) -> None:
    assert drawn.picture.is_file()
    assert drawn.displays_asked == 0


def test_the_page_is_whole_and_asks_for_nothing(drawn: Pages) -> None:
    text = drawn.page.read_text(encoding="utf-8")
    assert text.rstrip().endswith("</html>")
    assert "default-src 'none'" in text
    outside = [word for word in re.findall(r"""(?:src|href)=["']?([^"'> ]+)""", text) if not word.startswith("data:")]
    assert outside == []
    assert len(text) < 15e6
    numbers = {"faces": f"{drawn.report['faces']:,}", "effort": "balanced", "stop_reason_text": "target reached"}
    for name, value in numbers.items():
        assert f"<th>{name}</th><td>{value}</td>" in text
    assert f"Laplacian Simplify {ls.__version__}" in text
    assert f"rms {drawn.report['rms']:.3g} %" in text
    assert text.count('class="bar" x=') == 40


def test_names_are_text_and_nothing_else(drawn: Pages) -> None:
    text = drawn.odd_page.read_text(encoding="utf-8")
    assert html.escape(drawn.odd.name) in text
    assert "<img src=x" not in text
    assert text.count("<script") == text.count("</script>") == 3


def test_the_viewer_has_what_is_pinned() -> None:
    """And nothing that would end the element that it is in."""
    pinned = json.loads((Path(__file__).parents[1] / "viewer" / "package.json").read_text())["devDependencies"]["three"]
    library = (Path(pages.__file__).parent / "three.min.js").read_text(encoding="utf-8")
    assert f"Part of three.js {pinned};" in library
    assert "SPDX-License-Identifier: MIT" in library
    assert "Permission is hereby granted" in library
    for text in (library, (Path(pages.__file__).parent / "viewer.js").read_text(encoding="utf-8")):
        assert "<!--" not in text
        assert "</script" not in text


def test_large_meshes_are_reduced_for_the_viewer(monkeypatch: pytest.MonkeyPatch) -> None:
    """Colors stay those of the original's vertices, and the page says what it shows."""
    from laplacian_simplify.comparison.distances import measure
    from laplacian_simplify.comparison.surface import checked_surface
    from laplacian_simplify.pictures.picture import Look
    from laplacian_simplify.pictures.scene import Facts, Scene
    from laplacian_simplify.pictures.view import view_of

    monkeypatch.setattr(pages, "MOST_FACES", 500)
    vertices, faces = wave()
    before, after = checked_surface("large", vertices, faces), checked_surface("up", vertices + UP, faces)
    facts = Facts(("A", "B"), [], [], [], "0")
    look = Look(view_of(before, after), 1.0, before.diagonal)
    text = pages.page_text(Scene(before, after), measure(before, after, 100), facts, look, PNG)
    data = json.loads(text.partition('id="data">')[2].partition("</script>")[0])
    mesh = data["meshes"][0]
    shown = len(base64.b64decode(mesh["faces"])) // 12
    assert 490 < shown <= 500
    assert f"large has 1,682 faces; the viewer shows it with {shown}." in text
    errors = np.frombuffer(base64.b64decode(mesh["errors"]), np.float32)
    assert len(errors) == len(base64.b64decode(mesh["positions"])) / 12
    exact = ls.compare((vertices, faces), (vertices + UP, faces)).in_units["forward_hausdorff"]
    assert errors.max() <= exact * (1 + 1e-6)
    assert errors.max() > exact / 2


def test_meshes_that_cannot_be_reduced_are_shown_by_some_of_their_faces(monkeypatch: pytest.MonkeyPatch) -> None:
    """Separate triangles: none of them may vanish."""
    from laplacian_simplify.comparison.surface import checked_surface

    vertices, faces = wave()
    corners = vertices[faces]
    apart = (0.9 * corners + 0.1 * corners.mean(axis=1, keepdims=True)).reshape(-1, 3)
    surface = checked_surface("A", apart, np.arange(len(apart)).reshape(-1, 3))
    monkeypatch.setattr(pages, "MOST_FACES", 500)
    shown = pages._shown_by(surface, surface, 1)
    assert 400 < len(shown.faces) <= 500
    assert len(shown.positions) == 3 * len(shown.faces) == len(shown.errors)


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    from playwright.sync_api import sync_playwright

    with sync_playwright() as started:
        running = started.chromium.launch(executable_path="/usr/bin/chromium", args=BROWSER)
        yield running
        running.close()


class Opened:
    """A page in the browser, and all that it said and asked for."""

    def __init__(self, browser: Any, path: Path, **options: Any) -> None:
        self.tab = browser.new_page(viewport={"width": 1000, "height": 700}, **options)
        self.said: list[str] = []
        self.asked: list[str] = []
        self.tab.on("console", lambda message: self.said.append(f"{message.type}: {message.text}"))
        self.tab.on("pageerror", lambda error: self.said.append(f"error: {error}"))
        self.tab.on("request", lambda request: self.asked.append(request.url))
        self.tab.on("dialog", lambda dialog: self.said.append(f"error: {dialog.message}"))
        self.tab.goto(path.as_uri())

    def canvas(self, name: str = "") -> np.ndarray:
        """What the viewer shows, once it has drawn a frame, without the legend that lies over it."""
        self.tab.evaluate("() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
        SCREENSHOTS.mkdir(parents=True, exist_ok=True)
        path = SCREENSHOTS / f"report_page_{name or 'canvas'}.png"
        self.tab.locator("#stage canvas").screenshot(path=path)
        return pixels(path)[:, :-230]

    def choose(self, number: int) -> None:
        self.tab.locator("#controls label.choice").nth(number).click()


def test_the_viewer_shows_both_meshes_and_their_distances(drawn: Pages, browser: Any) -> None:
    opened = Opened(browser, drawn.page)
    views = {}
    for number, name in enumerate(["before", "after", "error-before", "error-after"]):
        opened.choose(number)
        views[name] = opened.canvas(name)
        assert (views[name].min(axis=-1) < 0.95).mean() > 0.1, name  # it is not blank
        assert opened.tab.locator("#legend").is_visible() == name.startswith("error")
    for plain in ("before", "after"):
        assert saturation(views[plain]).max() < 0.2
    for error in ("error-before", "error-after"):
        assert (saturation(views[error]) > 0.4).mean() > 0.02
    assert np.abs(views["before"] - views["after"]).max() > 0.2  # edges of others
    opened.tab.screenshot(path=SCREENSHOTS / "report_page.png", full_page=True)
    assert opened.said == []
    assert opened.asked == [drawn.page.as_uri()]
    opened.tab.close()


def test_the_viewer_turns_by_hand_by_itself_and_back(drawn: Pages, browser: Any) -> None:
    opened = Opened(browser, drawn.page)
    first = opened.canvas()
    box = opened.tab.locator("#stage").bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    opened.tab.mouse.move(x, y)
    opened.tab.mouse.down()
    opened.tab.mouse.move(x + 150, y, steps=5)
    opened.tab.mouse.up()
    turned = opened.canvas()
    assert np.abs(turned - first).mean() > 0.01
    opened.tab.locator("#back").click()
    assert np.abs(opened.canvas() - first).mean() < 0.001
    opened.tab.locator("#turn").check()
    frames = "let left = 30; (function next() { left-- ? requestAnimationFrame(next) : done() })()"
    opened.tab.evaluate(f"new Promise(done => {{ {frames} }})")
    opened.tab.locator("#turn").uncheck()
    assert np.abs(opened.canvas() - first).mean() > 0.001
    opened.tab.keyboard.press("1")
    assert opened.tab.locator("input[name=shown]:checked").get_attribute("value") == "before"
    assert opened.said == []
    opened.tab.close()


def test_odd_names_do_nothing_in_the_browser(drawn: Pages, browser: Any) -> None:
    opened = Opened(browser, drawn.odd_page)
    assert opened.tab.title() == f"{drawn.odd.name} | small.ply"
    assert (opened.canvas().min(axis=-1) < 0.95).mean() > 0.1
    assert opened.said == []
    assert opened.asked == [drawn.odd_page.as_uri()]
    opened.tab.close()


def test_without_scripts_the_picture_and_the_numbers_are_there(drawn: Pages, browser: Any) -> None:
    opened = Opened(browser, drawn.page, java_script_enabled=False)
    assert "target reached" in opened.tab.locator("#summary").inner_text()
    assert opened.tab.locator("img").bounding_box()["height"] > 200
    opened.tab.close()


def test_nothing_is_written_where_drawing_fails(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(command_line, "DRAW", "pictures.work:no_such_function")
    words = ["simplify", SAMPLE_MESHES / "folded_sheet.ply", tmp_path / "small.ply", "--percent", "50", "--quiet"]
    words += ["--picture", tmp_path / "out.png", "--report", tmp_path / "out.html", "--json", tmp_path / "out.json"]
    assert command_line.main([str(word) for word in words]) == 1
    assert_one_line(capsys.readouterr().err)
    assert list(tmp_path.iterdir()) == []


def test_a_crash_while_drawing_is_a_message(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "fake").mkdir()
    (tmp_path / "fake" / "pyvista.py").write_text("import os; os.abort()")
    monkeypatch.syspath_prepend(tmp_path / "fake")
    (tmp_path / "out").mkdir()
    words = ["simplify", SAMPLE_MESHES / "folded_sheet.ply", tmp_path / "out" / "small.ply", "--percent", 50, "--quiet"]
    assert command_line.main([*map(str, words), "--picture", str(tmp_path / "out" / "out.png")]) == 1
    said = capsys.readouterr().err
    assert_one_line(said)
    assert "out.png cannot be drawn: the process that draws ended (SIGABRT); nothing was written" in said
    assert list((tmp_path / "out").iterdir()) == []


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        (["--picture", "out.jpg"], "--picture out.jpg: a picture is PNG, so its name has to end with .png"),
        (["--report", "small.html"], "--report small.html is the file of OUTPUT, which it would replace"),
        (["--picture", "out.png", "--json", "out.png"], "--picture out.png is the file of --json, which"),
    ],
)
def test_names_that_do_not_fit_are_refused(tmp_path: Path, arguments: list[str], text: str) -> None:
    words = ["simplify", SAMPLE_MESHES / "folded_sheet.ply", "small.html", "--percent", 50, *arguments]
    done = run_command(*words, cwd=tmp_path)
    assert done.returncode == 2
    assert_one_line(done.stderr)
    assert text in done.stderr
    assert list(tmp_path.iterdir()) == []


def test_the_mesh_is_the_same_with_and_without_pictures(drawn: Pages) -> None:
    folder = drawn.page.parent
    assert run_command("simplify", folder / "wave.off", folder / "plain.ply", "--percent", 10).returncode == 0
    assert (folder / "plain.ply").read_bytes() == (folder / "small.ply").read_bytes()
    assert faces_in(folder / "small.ply") == drawn.report["faces"]
