"""A history as Parquet: one column per channel, units and origin in the metadata."""

import json
from typing import Any, BinaryIO

import pyarrow as pa
import pyarrow.parquet as pq

from app.histories.archive import Archive

SAMPLES_AT_ONCE = 16_384
# Bytes of equal significance lie together, which makes floats small; hardly any value occurs twice.
ENCODING = {"compression": "zstd", "use_dictionary": False, "use_byte_stream_split": True}


def write(archive: Archive, origin: dict[str, Any], file: BinaryIO) -> None:
    """Write an archive, a stretch of time after the other.

    Parameters
    ----------
    archive : Archive
    origin : dict
        What is to be known of the case; becomes, as JSON, metadata of the schema.
    file : file object
        Where to.
    """
    schema = _schema(archive, origin)
    with archive.mapped() as values, pq.ParquetWriter(file, schema, **ENCODING) as writer:
        for first in range(0, len(archive.time_s), SAMPLES_AT_ONCE):
            stretch = slice(first, first + SAMPLES_AT_ONCE)
            columns = [archive.time_s[stretch], archive.track_position_m[stretch], *values[:, stretch]]
            writer.write_batch(pa.record_batch([pa.array(column) for column in columns], schema=schema))


def _schema(archive: Archive, origin: dict[str, Any]) -> pa.Schema:
    fields = [
        pa.field(name, pa.float32(), metadata={"unit": unit})
        for name, unit in (("time_s", "s"), ("track_position_m", "m"))
    ]
    fields += [
        pa.field(f"{channel['quantity']}:{channel['position']}", pa.float32(), metadata=channel)
        for channel in archive.channels
    ]
    everything = origin | {"processing": archive.processing}
    return pa.schema(
        fields, {name: value if isinstance(value, str) else json.dumps(value) for name, value in everything.items()}
    )
