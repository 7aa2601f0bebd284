# SPDX-License-Identifier: MIT
"""lowest.py FILE: scipy.sparse.linalg.eigsh, shift and invert, on the matrices in FILE. Prints
"eigsh;seconds;largest relative difference of a frequency"."""
import os
import sys
import time

os.environ["OMP_NUM_THREADS"] = os.environ["OPENBLAS_NUM_THREADS"] = "1"

import numpy as np
from scipy.sparse import csc_matrix, tril
from scipy.sparse.linalg import eigsh

with open(sys.argv[1], "rb") as file:
    n, count, entries = np.fromfile(file, np.int32, 3)
    start, row = np.fromfile(file, np.int32, n + 1), np.fromfile(file, np.int32, entries)
    lower = [csc_matrix((np.fromfile(file, float, entries), row, start), shape=(n, n))
             for _ in range(2)]
    wanted = np.fromfile(file, float, count)
stiffness, mass = ((a + tril(a, -1).T).tocsc() for a in lower)
best = float("inf")
for _ in range(3):
    begin = time.process_time()
    found, _ = eigsh(stiffness, k=int(count), M=mass, sigma=0.0)
    best = min(best, time.process_time() - begin)
error = np.max(np.abs(np.sqrt(np.sort(found) / wanted) - 1))
print(f"eigsh;{best:.6g};{error:.6g}")
