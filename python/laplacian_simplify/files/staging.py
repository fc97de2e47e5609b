# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Files out: each appears whole, with its companions, or not at all."""

import errno
import os
import resource
import shutil
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from tempfile import TemporaryDirectory

from .errors import MeshFileError, printable
from .texture_names import decoded, encoded, is_inside

_HEAD = 1 << 16  # bytes at the start of a file, among which names of other files are


@contextmanager
def staged_output(
    path: str | os.PathLike[str], *, source: str | os.PathLike[str] | None = None, folder: Path | None = None
) -> Iterator[Path]:
    """A path to write to, in a folder beside the output; on success what was written replaces the output.

    The folder may also be made within another one, which is on the same disk as the output.

    Its name is plain whatever that of the output is. Textures and material files that are written beside it go with
    it and get their own names. Where the source, the file that the mesh came from, lies in the same folder, textures
    that are there stay: they are the source's own.

    Raises:
        MeshFileError: nothing can be written there.
    """
    target, shown = Path(os.path.realpath(path)), printable(os.fspath(path))
    check_target(path)
    try:
        own = TemporaryDirectory(prefix=".laplacian-simplify-", dir=folder or target.parent, ignore_cleanup_errors=True)
    except (OSError, ValueError) as error:
        raise unwritable(shown, error, target.parent) from None
    with own:
        staged = Path(own.name) / ("mesh" + "".join(c for c in target.suffix if c.isascii() and c.isprintable()))
        yield staged
        try:
            _publish(staged, target, keep=source is not None and _folder(source) == target.parent)
        except OSError as error:
            raise unwritable(shown, error, target.parent) from None


def check_target(path: str | os.PathLike[str]) -> None:
    """Refuses what no file can take the place of.

    Raises:
        OSError: names the path and the reason.
    """
    target, shown = Path(os.path.realpath(path)), printable(os.fspath(path))
    try:
        if target.exists() and not target.is_file():
            kind = "a folder" if target.is_dir() else "a device or a pipe; write to - for standard output"
            raise IsADirectoryError(f"{shown} cannot be written: it is {kind}")
        if not target.parent.is_dir():
            raise NotADirectoryError(f"{shown} cannot be written: {printable(target.parent)} is not a folder")
    except (IsADirectoryError, NotADirectoryError):
        raise
    except (OSError, ValueError) as error:
        raise unwritable(shown, error, target.parent) from None


def unwritable(shown: str, error: OSError | ValueError, folder: Path) -> MeshFileError:
    """The sentence about a file that the system did not let be written: what it says, and what helps."""
    number = getattr(error, "errno", None)
    reason = getattr(error, "strerror", None) or str(error)
    remedy = {
        errno.ENOSPC: f"free space on the disk of {printable(folder)}, or write elsewhere",
        errno.EDQUOT: "your quota is used up; free space, or write elsewhere",
        errno.EROFS: f"{printable(folder)} can only be read; write elsewhere",
        errno.EACCES: f"you may not write into {printable(folder)}; write elsewhere",
        errno.EFBIG: f"files may have at most {resource.getrlimit(resource.RLIMIT_FSIZE)[0]:,} bytes here (ulimit -f)",
    }.get(number or 0, "")
    return MeshFileError(f"{shown} cannot be written: {reason}" + (f"; {remedy}" if remedy else ""))


def write_staged(staged: Path, content: str | bytes, shown: str) -> None:
    """Writes all of a staged file.

    Raises:
        MeshFileError: it could not be written; names shown and the reason.
    """
    try:
        staged.write_bytes(content if isinstance(content, bytes) else content.encode())
    except OSError as error:
        raise unwritable(shown, error, staged.parent.parent) from None


def check_room(staged: Path, shown: str) -> None:
    """Finds out why a file that a library wrote is not whole: not all libraries look whether writing succeeds.

    Raises:
        MeshFileError: nothing more can be written there, and why.
    """
    try:
        with staged.open("ab") as file:
            file.write(bytes(_HEAD))
            file.flush()
            os.fsync(file.fileno())
    except OSError as error:
        raise unwritable(shown, error, staged.parent.parent) from None


def _folder(path: str | os.PathLike[str]) -> Path:
    return Path(os.path.realpath(path)).parent


def _publish(staged: Path, target: Path, *, keep: bool) -> None:
    """Moves companions first, so that the mesh never refers to a file that is not there yet."""
    _own_names(staged, target)
    for companion in [file for file in staged.parent.rglob("*") if file.is_file() and file != staged]:
        named_after_mesh = companion.name.startswith(staged.name)
        name = target.name + companion.name.removeprefix(staged.name) if named_after_mesh else _own_name(companion.name)
        place = target.parent / name
        if named_after_mesh or not keep or not place.exists():
            place.parent.mkdir(parents=True, exist_ok=True)
            _sync(companion)
            companion.replace(place)
    if target.exists():
        _like(staged, target)
    _sync(staged)
    staged.replace(target)


def _own_name(name: str) -> str:
    """The name of a texture outside of MeshLab."""
    own = decoded(name)
    return own if encoded(own) == name and is_inside(own) else name


def _own_names(staged: Path, target: Path) -> None:
    """Names of companions within the files: their own in place of those between reading and writing."""
    suffix = staged.suffix.lower()
    if suffix == ".obj":
        plain, own = os.fsencode(staged.name), os.fsencode(target.name)
        _replace_in_head(staged, {b"mtllib ./" + plain: b"mtllib ./" + own, b"# Object " + plain: b"# Object " + own})
        library = staged.with_name(staged.name + ".mtl")
        if library.is_file():
            _with_own_textures(library, b"map_Kd ")
    elif suffix == ".ply":
        _with_own_textures(staged, b"comment TextureFile ")


def _with_own_textures(path: Path, keyword: bytes) -> None:
    names = [file.name for file in path.parent.iterdir() if _own_name(file.name) != file.name]
    _replace_in_head(
        path, {keyword + name.encode() + b"\n": keyword + os.fsencode(_own_name(name)) + b"\n" for name in names}
    )


def _replace_in_head(path: Path, replacements: dict[bytes, bytes]) -> None:
    """Replaces names in the first part of a file; the rest, which is large, is copied as it is."""
    with path.open("rb") as file:
        head = file.read(_HEAD)
        changed = head
        for old, new in replacements.items():
            changed = changed.replace(old, new)
        if changed == head:
            return
        renamed = path.with_name(path.name + ".renamed")
        with renamed.open("wb") as copy:
            copy.write(changed)
            shutil.copyfileobj(file, copy)
    renamed.replace(path)


def _like(staged: Path, target: Path) -> None:
    """Gives the new file the permissions and, where that is allowed, the owner of the old one."""
    old = target.stat()
    if (old.st_uid, old.st_gid) != (staged.stat().st_uid, staged.stat().st_gid):
        with suppress(OSError):
            os.chown(staged, old.st_uid, old.st_gid)
    staged.chmod(old.st_mode & 0o7777)


def _sync(path: Path) -> None:
    """Full disks and quotas are sometimes reported only now."""
    with path.open("rb") as file:
        os.fsync(file.fileno())
