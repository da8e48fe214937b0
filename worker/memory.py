"""How much memory a worker may take."""

import resource
from pathlib import Path


def limit_to(case_memory_mb: int) -> None:
    """Let this process take so much memory, in MiB, beyond what it has now; what asks for more gets a MemoryError.

    The limit is on private memory that can be written to (RLIMIT_DATA), not on addresses (RLIMIT_AS): LLVM, BLAS and
    every thread reserve many more addresses than they ever use, so no number would fit. And it is the kernel's: a case
    may fill the memory of a machine within a second, inside one NumPy call or a kernel that holds Python's lock, so
    whoever looks at what is used from time to time looks too late, and the kernel may end another process for it.

    Elsewhere than on Linux there is no such limit.
    """
    statistics = Path("/proc/self/statm")
    if not statistics.exists():
        return
    own = int(statistics.read_text().split()[5]) * resource.getpagesize()
    _, hard = resource.getrlimit(resource.RLIMIT_DATA)
    limit = own + case_memory_mb * 2**20
    resource.setrlimit(resource.RLIMIT_DATA, (limit if hard == resource.RLIM_INFINITY else min(limit, hard), hard))
