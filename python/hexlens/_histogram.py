"""How relative minima are distributed: the bins of all histograms here."""

from typing import Final

import numpy as np
from numpy.typing import NDArray

__all__ = ["BINS", "EDGES", "histogram_of"]

#: Bins between 0 and 1, the greatest relative minimum that there is; below 0 as wide, down to -1, and one for all up to that. A bin has its
#: upper end: 0, which is invalid, is on the side of what is negative.
BINS: Final = 40
#: Where bins begin and end: -inf, -1, -0.975 and so on to 1.
EDGES: Final = (-np.inf, *(place / BINS for place in range(-BINS, BINS + 1)))


def histogram_of(relative: NDArray[np.float64]) -> NDArray[np.int64]:
    """How many are in each bin; NaN is in none."""
    known = relative[~np.isnan(relative)]
    places = np.clip(BINS + np.ceil(np.clip(known, -2, 2) * BINS), 0, 2 * BINS).astype(np.int64)
    return np.bincount(places, minlength=2 * BINS + 1)
