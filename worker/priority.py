"""How far a worker stands back for other processes of its machine."""

import os
import time
from pathlib import Path

# Linux weighs sessions against one another before the processes in them, and each of the service's parts has its own.
SESSION = Path("/proc/self/autogroup")
TRIES, PAUSE_S = 20, 0.15  # the system takes one such change in 0.1 s from all its users


def stand_back(nice: int) -> None:
    """Be as nice as that, as a process and, where this process leads a session, as that session."""
    os.nice(nice)
    if not SESSION.exists() or os.getsid(0) != os.getpid():
        return
    for _ in range(TRIES):
        try:
            SESSION.write_text(str(nice))
        except BlockingIOError:
            time.sleep(PAUSE_S)
        except OSError:  # read-only, as in some containers
            return
        else:
            return
