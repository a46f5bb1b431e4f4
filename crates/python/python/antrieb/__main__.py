"""`python -m antrieb`: the command line."""

import sys

from antrieb._command_line import main

if __name__ == "__main__":
    sys.exit(main())
