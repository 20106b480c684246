"""The logger ``archard``, silent until a program asks for it.

At INFO runs, rows and fits begin and end, with their verdict; at DEBUG there is each step and each line of it.
What is doubtful is told by :mod:`warnings` alone: ``logging.captureWarnings(True)`` makes it log messages too.
"""

import logging

log = logging.getLogger("archard")
log.addHandler(logging.NullHandler())
