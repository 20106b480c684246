"""The command ``archard``, for the script that is installed with the package and ``python -m archard``."""

import signal
import sys

from archard._archard import command


def main() -> int:
    """Do what the command line asks for, and return the exit code of the program."""
    # Python would hold Ctrl-C back until the command ends. Where a shell has it ignored, it stays so.
    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
        signal.signal(signal.SIGINT, signal.SIG_DFL)
    return command(sys.argv[1:])
