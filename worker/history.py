"""Time histories as one NumPy archive."""

import io
import json

import numpy as np

from solver.processing import processing
from solver.simulate import Response


def archive(response: Response) -> bytes:
    """The histories of a response, single precision, with quantity, position and unit of each row of ``values``; in
    ``processing``, as JSON, their conventions and how peaks are derived from them.
    """
    file = io.BytesIO()
    np.savez_compressed(
        file,
        time_s=response.time.astype(np.float32),
        track_position_m=response.track_position.astype(np.float32),
        values=response.values.astype(np.float32),
        quantity=np.array([channel.quantity for channel in response.channels]),
        position=np.array([channel.position for channel in response.channels]),
        unit=np.array([channel.unit for channel in response.channels]),
        processing=np.array(json.dumps(processing(response))),
    )
    return file.getvalue()
