"""One pose of $robot."""

import numpy as np
import stewart_arrays
from robot import robot

on = stewart_arrays.Arithmetic(np)
model = stewart_arrays.prepare(on, robot())
motion = stewart_arrays.motion_of(
    on,
$motion
)
F = [0.0] * 6
$calls
