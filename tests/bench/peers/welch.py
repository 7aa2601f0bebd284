# SPDX-License-Identifier: MIT
"""welch.py "COUNT LENGTH OVERLAP": time scipy.signal.welch on noise; prints "name;seconds;0"."""
import sys
import time

import numpy as np
from scipy.signal import welch

count, length, overlap = sys.argv[1].split()
x = np.random.default_rng(1).random(int(count)) - 0.5
best = float("inf")
for _ in range(3):
    start = time.process_time()
    welch(x, 1000, nperseg=int(length), noverlap=int(float(overlap) * int(length)))
    best = min(best, time.process_time() - start)
print(f"welch;{best:.6g};0")
