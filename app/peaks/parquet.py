"""Peaks as Parquet, a group of rows at a time, with units and origin in the metadata."""

import io
from collections.abc import Iterator, Sequence
from importlib.metadata import version
from typing import Any, get_args

import pyarrow as pa
import pyarrow.parquet as pq

from app.db.models import STATISTICS
from app.peaks.export import Export
from app.peaks.schemas import PeakFilters, PeakRow
from app.studies.sweep.vary import PARAMETERS

_TYPES = {str: pa.string(), float: pa.float64(), int: pa.int64()}
_UNITS = {"kmh": "km/h", "m": "m", "mm": "mm", "s": "s", "percentile": "%"}


class _Outlet(io.RawIOBase):
    """A file that is read at once by whoever writes it."""

    def __init__(self) -> None:
        self._waiting: list[bytes] = []
        self._position = 0

    def writable(self) -> bool:
        return True

    def write(self, data: Any) -> int:
        self._waiting.append(bytes(data))
        self._position += len(data)
        return len(data)

    def tell(self) -> int:
        return self._position

    def take(self) -> bytes:
        """What was written since the last time."""
        taken = b"".join(self._waiting)
        self._waiting.clear()
        return taken


def as_parquet(export: Export, filters: PeakFilters) -> Iterator[bytes]:
    """As Parquet. The unit of a field is in its metadata, that of a statistic in the column ``unit``."""
    schema, outlet = _schema(export.names, filters), _Outlet()
    with pq.ParquetWriter(outlet, schema, compression="zstd") as writer:
        for rows in filter(None, export.parts):
            columns = [
                pa.array(values, field.type) for values, field in zip(zip(*rows, strict=True), schema, strict=True)
            ]
            writer.write_batch(pa.record_batch(columns, schema=schema))
            yield outlet.take()
    yield outlet.take()


def _schema(names: Sequence[str], filters: PeakFilters) -> pa.Schema:
    asked = filters.model_dump_json(exclude_none=True, exclude={"parameter"})
    return pa.schema(map(_field, names), {"tracksweep_version": version("tracksweep"), "filters": asked})


def _field(name: str) -> pa.Field:
    if (parameter := PARAMETERS.get(name)) is not None:
        return pa.field(name, _TYPES[parameter.type], metadata={"unit": parameter.quantity.unit})
    kind = PeakRow.model_fields[name].annotation if name in PeakRow.model_fields else str
    types = get_args(kind) or (kind,)
    unit = {"unit_column": "unit"} if name in STATISTICS[:6] else {"unit": _UNITS.get(name.rpartition("_")[2], "")}
    return pa.field(name, _TYPES[types[0]], nullable=type(None) in types, metadata=unit)
