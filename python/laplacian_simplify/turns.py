# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Calls into pymeshlab, made so that threads of one process do not get into each other's way.

pymeshlab has one log, one progress and one redirection of its streams for all mesh sets, and lets other Python
threads run during a filter. Its readers and writers change the working directory of the process, its writers also
the locale. Threads of this package therefore take turns in pymeshlab; a filter uses all processors by itself.
"""

import ctypes
import locale
import os
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, ParamSpec, TypeVar

if TYPE_CHECKING:
    import pymeshlab

P = ParamSpec("P")
T = TypeVar("T")

_TURN = threading.RLock()
_CLONE_FS = 0x200
_ALL_CATEGORIES = 0x1FBF  # LC_ALL_MASK of glibc


def _begin_anew() -> None:
    """In a copy of the process nobody else has the turn, although a thread of the original may have had it."""
    global _TURN
    _TURN = threading.RLock()


os.register_at_fork(after_in_child=_begin_anew)


@contextmanager
def turn() -> Iterator[None]:
    """Waits for the other threads, then numbers have a decimal point whatever the locale of the process."""
    with _TURN, _decimal_point():
        yield


def with_own_folder(function: Callable[P, T], *args: P.args, **kwargs: P.kwargs) -> T:
    """Calls a function that reads or writes files through pymeshlab.

    It runs in a thread that has a working directory of its own, where the system gives it one: in the meantime other
    threads find their files, and a failure leaves the process where it was.
    """
    outcome: list[Any] = []

    def run() -> None:
        private = _own_folder()
        before = None if private else Path.cwd()
        try:
            with _decimal_point():
                outcome.extend((True, function(*args, **kwargs)))
        except BaseException as error:
            outcome.extend((False, error))
        finally:
            if before is not None:
                os.chdir(before)

    with _TURN:
        name = locale.setlocale(locale.LC_ALL)
        try:
            thread = threading.Thread(target=run, name="laplacian-simplify")
            thread.start()
            _wait_for(thread)
        finally:
            if locale.setlocale(locale.LC_ALL) != name:
                locale.setlocale(locale.LC_ALL, name)
    if not outcome[0]:
        raise outcome[1]
    return outcome[1]  # type: ignore[no-any-return]


def _wait_for(thread: threading.Thread) -> None:
    """Waits to the end also where Ctrl+C comes: pymeshlab cannot be left in the middle of its work."""
    try:
        thread.join()
    except BaseException:
        thread.join()
        raise


@contextmanager
def plain_path(path: Path) -> Iterator[str]:
    """A path to a file of a plain name that has no other letters than ASCII, whatever its folder is called.

    What Qt makes of others depends on the locale, which need not be that of the file system.
    """
    if str(path).isascii():
        yield str(path)
        return
    folder = os.open(path.parent, os.O_RDONLY | os.O_DIRECTORY)
    try:
        yield f"/proc/self/fd/{folder}/{path.name}"
    finally:
        os.close(folder)


def forget_failures() -> None:
    """Makes pymeshlab forget the mesh set of a filter that failed; call it in a turn, before files are read or written.

    pymeshlab goes on writing progress into the log of that mesh set, even when it is gone, until another filter has
    succeeded.
    """
    _lasting_mesh_set().apply_filter("get_geometric_measures")


@cache
def _lasting_mesh_set() -> "pymeshlab.MeshSet":
    """A mesh set that is never destroyed."""
    import pymeshlab

    mesh_set = pymeshlab.MeshSet()
    mesh_set.create_cube()
    return mesh_set


@cache
def _c_library() -> Any:
    """The C library, None where it has no locale of a thread."""
    try:
        library = ctypes.CDLL(None, use_errno=True)
        library.newlocale.restype = library.uselocale.restype = ctypes.c_void_p
        library.newlocale.argtypes = [ctypes.c_int, ctypes.c_char_p, ctypes.c_void_p]
        library.uselocale.argtypes = [ctypes.c_void_p]
    except (OSError, TypeError, AttributeError):
        return None
    return library


@cache
def _c_locale() -> Any:
    return _c_library().newlocale(_ALL_CATEGORIES, b"C", None)


@contextmanager
def _decimal_point() -> Iterator[None]:
    """The C locale in this thread alone."""
    library = _c_library()
    before = library.uselocale(_c_locale()) if library else None
    try:
        yield
    finally:
        if before:
            library.uselocale(before)


def _own_folder() -> bool:
    """Gives this thread a working directory of its own; some containers forbid it."""
    try:
        return bool(ctypes.CDLL(None).unshare(_CLONE_FS) == 0)
    except (OSError, TypeError, AttributeError):
        return False
