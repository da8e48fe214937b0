"""The record of a run: one JSON object per line, in the order in which the harness learnt of things."""

import json
import time
from pathlib import Path
from threading import Lock
from typing import Any

Line = dict[str, Any]


class Record:
    """Writes lines, each with its ``kind`` and the seconds ``t`` since the beginning."""

    def __init__(self, path: Path) -> None:
        self._file = path.open("w", buffering=1)
        self._began = time.monotonic()
        self._lock = Lock()

    def now(self) -> float:
        return round(time.monotonic() - self._began, 3)

    def write(self, kind: str, **fields: Any) -> None:
        with self._lock:
            self._file.write(json.dumps({"t": self.now(), "kind": kind} | fields) + "\n")

    def close(self) -> None:
        self._file.close()


def read(path: Path) -> list[Line]:
    return [json.loads(line) for line in path.read_text().splitlines()]
