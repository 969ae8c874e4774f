"""Periodic normal contact by Tamaas, for comparison.

Arguments: number of cells per side, tolerance, a file of heights, a file for pressures, and mean
pressures. Lengths are over the side of the surface, pressures over the contact modulus; numbers in files
are little-endian doubles. Prints one line for each pressure: seconds and the error Tamaas reports.
"""

import sys
import time

import numpy as np
import tamaas

cells, tolerance = int(sys.argv[1]), float(sys.argv[2])
heights = np.fromfile(sys.argv[3], dtype="<f8").reshape(cells, cells)
model = tamaas.ModelFactory.createModel(
    tamaas.model_type.basic_2d, [1.0, 1.0], [cells, cells]
)
model.E, model.nu = 1.0, 0.0
solver = tamaas.PolonskyKeerRey(
    model,
    heights,
    tolerance,
    tamaas.PolonskyKeerRey.pressure,
    tamaas.PolonskyKeerRey.pressure,
)
solver.max_iter = 3000
solver.dump_freq = 10**9
with open(sys.argv[4], "wb") as file:
    for pressure in sys.argv[5:]:
        start = time.perf_counter()
        error = solver.solve(float(pressure))
        print(time.perf_counter() - start, error)
        np.asarray(model.traction).astype("<f8").tofile(file)
