"""The computing side: claims queued cases, solves them, finishes them."""

import os

# One case occupies one core. Libraries that each start a thread per core make two workers many times slower, and
# they read these when they are first imported.
for _library in ("OMP", "OPENBLAS", "MKL", "NUMBA"):
    os.environ.setdefault(f"{_library}_NUM_THREADS", "1")
