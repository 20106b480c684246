"""``python -m archard``: the command."""

import sys

from archard._command import main

sys.exit(main())
