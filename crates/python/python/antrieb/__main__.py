"""`python -m antrieb`: the command line."""

import sys

from antrieb._command_line import main

sys.exit(main())
