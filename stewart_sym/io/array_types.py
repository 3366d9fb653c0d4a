"""Array types for annotations."""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]
Codes = NDArray[np.int32]
Indices = NDArray[np.intp]
