# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m laplacian_simplify: the command laplacian-simplify."""

import sys

from .signals import die_at_once


def main() -> int:
    """The command, in a process of its own."""
    die_at_once()  # before anything that takes time
    from .command_line import main as command
    from .streams import flush_or_drop, open_closed_streams, write_names_as_they_are

    open_closed_streams()
    write_names_as_they_are()
    try:
        return command()
    except OSError:  # the help had nowhere to go
        return 1
    finally:
        flush_or_drop()


if __name__ == "__main__":
    sys.exit(main())
