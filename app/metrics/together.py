"""Several processes behind one port count in files of one folder, and whichever is asked tells of all of them.

That is prometheus-client's multiprocess mode. It looks for the folder when it is imported, so nothing here imports it.
"""

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

FOLDER = "PROMETHEUS_MULTIPROC_DIR"  # its name for it
IN_MEMORY = Path("/dev/shm")  # noqa: S108 - a full disk would kill whoever writes to a mapped file


@contextmanager
def counting_together(processes: int) -> Iterator[None]:
    """Let the processes of the API that are started meanwhile count as one."""
    if processes == 1:
        yield
        return
    with tempfile.TemporaryDirectory(prefix="tracksweep-", dir=IN_MEMORY if IN_MEMORY.is_dir() else None) as folder:
        os.environ[FOLDER] = folder
        try:
            yield
        finally:
            del os.environ[FOLDER]
