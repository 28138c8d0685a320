"""The program ``wisch``: plan, predict, run and report from the command line, see ``wisch --help``."""

import os
import signal
import sys


def main() -> int:
    """Run the program with this process's arguments, and return its exit code."""
    from . import _wisch

    # The program itself handles Ctrl-C and a closed pipe, as without Python.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    # The Prolog engine may have been installed beside this program.
    folder = os.path.dirname(os.path.abspath(sys.argv[0]))
    os.environ["PATH"] = os.pathsep.join([os.environ.get("PATH", ""), folder])
    return _wisch.run_program(["wisch", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
