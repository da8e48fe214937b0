"""What a response records: the order of the channels, with quantity, position and unit."""

from dataclasses import dataclass

from solver.observables import OBSERVABLES


@dataclass(frozen=True, kw_only=True)
class Channel:
    """What one column of a response holds."""

    quantity: str
    position: str
    unit: str


WHEELSETS = tuple(f"wheelset_{i}" for i in (1, 2, 3, 4))

ALL_PADS, ALL_JOINTS = "pads", "joints"


def _channels(quantity: str, *positions: str) -> tuple[Channel, ...]:
    unit = OBSERVABLES[quantity].unit
    return tuple(Channel(quantity=quantity, position=position, unit=unit) for position in positions)


# The order in which solver.march writes them. Track quantities are those under the first wheelset.
CHANNELS: tuple[Channel, ...] = (
    *_channels("wheel_rail_force", *WHEELSETS),
    *_channels("rail_displacement", WHEELSETS[0]),
    *_channels("rail_acceleration", WHEELSETS[0]),
    *_channels("rail_acceleration_moving_frame", WHEELSETS[0]),
    *_channels("slab_displacement", WHEELSETS[0]),
    *_channels("slab_acceleration", WHEELSETS[0]),
    *_channels("base_displacement", WHEELSETS[0]),
    *_channels("base_acceleration", WHEELSETS[0]),
    *_channels("slab_moment", WHEELSETS[0]),
    *_channels("roadbed_pressure", WHEELSETS[0]),
    # The largest of all pads under the train: compression, and pull where the rail lifts off.
    *_channels("pad_force", ALL_PADS),
    *_channels("pad_uplift", ALL_PADS),
    *_channels("car_body_acceleration", "car_body"),
    *_channels("bogie_acceleration", "bogie_1", "bogie_2"),
    *_channels("wheelset_acceleration", *WHEELSETS),
    # Of all joints under the train, that with the largest magnitude at the time; the moment is at the pads next to it.
    *_channels("joint_opening", ALL_JOINTS),
    *_channels("joint_slope_jump", ALL_JOINTS),
    *_channels("joint_shear", ALL_JOINTS),
    *_channels("slab_moment", ALL_JOINTS),
)
TRACK = 4  # first of the nine track channels
PADS = 13  # first of the pads' channels
BODIES = 15  # first of the vehicle's accelerations
JOINTS = 22  # first of the joints' channels; a continuous slab has none
