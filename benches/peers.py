"""The task of benches/benches/evaluate.rs done by others: a bicubic patch to a grid of 1025 x 1025 vertices, f64, one thread.

Needs numpy and scipy (`pip install numpy scipy`). Prints millions of vertices a second, the median of 50 runs.
"""

import os

for threads in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[threads] = "1"

import statistics
import time

import numpy as np
import scipy
from scipy.interpolate import BSpline

SIZE = 1025
t = np.linspace(0.0, 1.0, SIZE)
NET = np.array([[[i * 1000.0, j * 1000.0, (3 * i + 5 * j) % 7 * 100.0] for j in range(4)] for i in range(4)])
KNOTS = np.array([0.0] * 4 + [1.0] * 4)


def bernstein():
    s = 1.0 - t
    return np.stack([s**3, 3 * t * s**2, 3 * t**2 * s, t**3], axis=1)


A = bernstein()


def numpy_product(out=None):
    """A . C . B^T: first along v for four rows of the net, then one matrix product along u."""
    along_v = np.einsum("cj,ijd->icd", A, NET).reshape(4, SIZE * 3)
    return np.matmul(A, along_v, out=out)


def scipy_bspline():
    along_u = BSpline(KNOTS, NET, 3)(t)
    return BSpline(KNOTS, along_u.transpose(1, 0, 2), 3)(t)


def measure(name, run):
    times = []
    for _ in range(50):
        start = time.perf_counter()
        run()
        times.append(time.perf_counter() - start)
    print(f"{name:40} {SIZE * SIZE / statistics.median(times) / 1e6:8.1f} Mvertices/s")


BUFFER = np.empty((SIZE, SIZE * 3))
reference = numpy_product().reshape(SIZE, SIZE, 3)
assert np.allclose(scipy_bspline().transpose(1, 0, 2), reference, atol=1e-9)
print(f"numpy {np.__version__}, scipy {scipy.__version__}, one thread")
measure("numpy separable product, reused buffer", lambda: numpy_product(BUFFER))
measure("numpy separable product, fresh buffer", numpy_product)
measure("scipy BSpline", scipy_bspline)
