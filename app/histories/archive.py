"""The archives that workers store, read without ever holding more than a few channels of one."""

import hashlib
import json
import tempfile
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from numpy.lib.npyio import NpzFile
from numpy.typing import NDArray

from app.histories.sampling import peaks_of_bins
from app.histories.schemas import HistoryChannel, HistoryQuery

VALUES = "values.npy"


class DamagedError(Exception):
    """An archive is not what was stored."""


class Archive:
    """An archive as ``worker.history`` makes it.

    Parameters
    ----------
    npz : NpzFile

    Attributes
    ----------
    time_s, track_position_m : ndarray, shape (n,)
    channels : list of dict
        ``quantity``, ``position`` and ``unit`` of each row of the values.
    processing : dict
        How peaks are derived.
    """

    def __init__(self, npz: NpzFile) -> None:
        assert npz.zip is not None  # noqa: S101 - for the type checker: it is open
        self._zip = npz.zip
        self.time_s, self.track_position_m = npz["time_s"], npz["track_position_m"]
        names = ("quantity", "position", "unit")
        self.channels = [
            dict(zip(names, row, strict=True)) for row in zip(*(npz[n].tolist() for n in names), strict=True)
        ]
        self.processing: dict[str, Any] = json.loads(str(npz["processing"]))

    def rows(self) -> Iterator[NDArray[Any]]:
        """The values of every channel, one after the other."""
        with self._zip.open(VALUES) as member:
            np.lib.format.read_magic(member)
            shape, _, dtype = np.lib.format.read_array_header_1_0(member)
            for _ in range(shape[0]):
                yield np.frombuffer(member.read(shape[1] * dtype.itemsize), dtype)

    @contextmanager
    def mapped(self) -> Iterator[NDArray[Any]]:
        """The values of all channels, shape (channels, n), in a file of their own rather than in memory."""
        with tempfile.TemporaryDirectory() as folder:
            self._zip.extract(VALUES, folder)
            yield np.load(Path(folder) / VALUES, mmap_mode="r")


@contextmanager
def opened(chunks: Iterable[bytes], digest: str) -> Iterator[Archive]:
    """An archive from a store.

    Raises
    ------
    DamagedError
        If its SHA-256 is another.
    """
    found = hashlib.sha256()
    with tempfile.TemporaryFile() as file:
        for chunk in chunks:
            found.update(chunk)
            file.write(chunk)
        if found.hexdigest() != digest:
            raise DamagedError
        file.seek(0)
        with np.load(file) as npz:
            yield Archive(npz)


def sample(archive: Archive, query: HistoryQuery) -> tuple[int, list[HistoryChannel]]:
    """How many samples there are in the range of time, and those to show of the channels asked for."""
    begin = 0.0 if query.time_min_s is None else query.time_min_s
    end = np.inf if query.time_max_s is None else query.time_max_s
    first = int(np.searchsorted(archive.time_s, np.float32(begin), "left"))  # as precise as what it is compared with
    stop = int(np.searchsorted(archive.time_s, np.float32(end), "right"))
    time_s, found = archive.time_s[first:stop], []
    for channel, row in zip(archive.channels, archive.rows(), strict=True):
        if _is_one_of(channel["quantity"], query.quantity) and _is_one_of(channel["position"], query.position):
            values = row[first:stop]
            shown = peaks_of_bins(values, query.max_points)
            found.append(HistoryChannel(**channel, time_s=time_s[shown].tolist(), values=values[shown].tolist()))
    return len(time_s), found


def _is_one_of(name: str, chosen: list[str]) -> bool:
    return not chosen or name in chosen
