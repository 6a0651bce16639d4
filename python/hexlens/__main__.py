"""python -m hexlens check FILE..."""

import sys

from ._cli import main

sys.exit(main())
