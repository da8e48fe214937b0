"""What is listed is what there is."""

import numpy as np

from solver.case import Case, Smooth
from solver.catalogue import TRACKS, VEHICLES
from solver.channels import CHANNELS
from solver.observables import OBSERVABLES
from solver.peaks import peaks
from solver.simulate import Response

CASE = Case(speed=80.0, irregularity=Smooth(), track=TRACKS["crts2"].values, vehicle=VEHICLES["crh3"].values)


def test_every_quantity_of_a_response_is_listed_and_no_other():
    time = 1e-3 * np.arange(1, 1001)
    values = np.random.default_rng(1).normal(-1.0, 0.2, (len(CHANNELS), len(time)))
    response = Response(
        case=CASE, time=time, track_position=CASE.speed * time, channels=CHANNELS, values=values, time_step=1e-3
    )
    found = peaks(response)
    assert {(peak.quantity, peak.unit) for peak in found} == {(each.name, each.unit) for each in OBSERVABLES.values()}
    for peak in found:
        assert peak.peak == (
            peak.maximum if OBSERVABLES[peak.quantity].peak == "maximum" else max(abs(peak.maximum), abs(peak.minimum))
        )
    recorded = {channel.quantity for channel in CHANNELS}
    assert {each.name for each in OBSERVABLES.values() if not each.of} == recorded
    assert {each.of for each in OBSERVABLES.values() if each.of} <= recorded
