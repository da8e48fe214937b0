"""What a response records: the order of the channels, with quantity, position and unit."""

from dataclasses import dataclass


@dataclass(frozen=True, kw_only=True)
class Channel:
    """What one column of a response holds."""

    quantity: str
    position: str
    unit: str


WHEELSETS = tuple(f"wheelset_{i}" for i in (1, 2, 3, 4))

ALL_PADS, ALL_JOINTS = "pads", "joints"


def _channels(quantity: str, unit: str, *positions: str) -> tuple[Channel, ...]:
    return tuple(Channel(quantity=quantity, position=position, unit=unit) for position in positions)


# The order in which solver.march writes them. Track quantities are those under the first wheelset.
CHANNELS: tuple[Channel, ...] = (
    *_channels("wheel_rail_force", "N", *WHEELSETS),
    *_channels("rail_displacement", "m", WHEELSETS[0]),
    *_channels("rail_acceleration", "m/s^2", WHEELSETS[0]),
    *_channels("rail_acceleration_moving_frame", "m/s^2", WHEELSETS[0]),
    *_channels("slab_displacement", "m", WHEELSETS[0]),
    *_channels("slab_acceleration", "m/s^2", WHEELSETS[0]),
    *_channels("base_displacement", "m", WHEELSETS[0]),
    *_channels("base_acceleration", "m/s^2", WHEELSETS[0]),
    *_channels("slab_moment", "N m", WHEELSETS[0]),
    *_channels("roadbed_pressure", "N/m", WHEELSETS[0]),
    # The largest of all pads under the train: compression, and pull where the rail lifts off.
    *_channels("pad_force", "N", ALL_PADS),
    *_channels("pad_uplift", "N", ALL_PADS),
    *_channels("car_body_acceleration", "m/s^2", "car_body"),
    *_channels("bogie_acceleration", "m/s^2", "bogie_1", "bogie_2"),
    *_channels("wheelset_acceleration", "m/s^2", *WHEELSETS),
    # Of all joints under the train, that with the largest magnitude at the time; the moment is at the pads next to it.
    *_channels("joint_opening", "m", ALL_JOINTS),
    *_channels("joint_slope_jump", "rad", ALL_JOINTS),
    *_channels("joint_shear", "N", ALL_JOINTS),
    *_channels("slab_moment", "N m", ALL_JOINTS),
)
TRACK = 4  # first of the nine track channels
PADS = 13  # first of the pads' channels
BODIES = 15  # first of the vehicle's accelerations
JOINTS = 22  # first of the joints' channels; a continuous slab has none
