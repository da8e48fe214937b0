import subprocess
import sys
from dataclasses import fields, is_dataclass, replace
from typing import get_args

import numpy as np
import pytest

from solver.case import Case, Spectral, WheelTread
from solver.catalogue import SPECTRA, TRACKS, TREADS, VEHICLES, Mark
from solver.catalogue.entry import Source, of_every_value
from solver.reference.layered import LayeredTrack
from solver.vehicle import wheel_positions
from solver.wheel import static_wheel_load

CATALOGUES = {"vehicle": VEHICLES, "track": TRACKS, "spectrum": SPECTRA, "tread": TREADS}
ENTRIES = [pytest.param(entry, id=name) for catalogue in CATALOGUES.values() for name, entry in catalogue.items()]


def numbers_and_words(values, prefix=""):
    for field in fields(values):
        value = getattr(values, field.name)
        if is_dataclass(value):
            yield from numbers_and_words(value, f"{prefix}{field.name}.")
        else:
            yield f"{prefix}{field.name}"


@pytest.mark.parametrize("entry", ENTRIES)
def test_every_value_has_a_source_a_mark_and_a_basis(entry):
    names = set(numbers_and_words(entry.values))
    assert entry.provenance.keys() == names == entry.basis.keys()
    for name in names:
        assert len(entry.provenance[name].text) > 5, name
        assert entry.provenance[name].mark in get_args(Mark), name
        assert entry.basis[name], name


def test_a_nested_value_takes_the_source_of_its_part_unless_it_has_its_own():
    sources = of_every_value(
        TRACKS["crts2"].values, "all", {"joint": "joints", "joint.position": "place", "pad_stiffness": "pad"}
    )
    assert {sources[n] for n in ("joint.shear_stiffness", "joint.shear_damping")} == {"joints"}
    assert (sources["joint.position"], sources["pad_stiffness"], sources["pad_damping"]) == ("place", "pad", "all")


def test_what_nobody_published_is_not_called_common():
    for entry in TRACKS.values():
        assert {entry.provenance[f"joint.shear_{n}"].mark for n in ("stiffness", "damping")} == {"A"}
    assert all(entry.provenance["sides"].mark == "A" for name, entry in SPECTRA.items() if name != "tb3352-ballastless")
    assert VEHICLES["velaro"].provenance["car_body_mass"] == Source("TTB-2D, vehicle ICE3/AVE S103", "V")


@pytest.mark.parametrize("catalogue", CATALOGUES.values(), ids=CATALOGUES)
def test_names_are_those_of_the_entries(catalogue):
    assert [entry.name for entry in catalogue.values()] == list(catalogue)
    assert len({entry.title for entry in catalogue.values()}) == len(catalogue)


def test_every_set_is_there():
    assert list(VEHICLES) == ["crh3", "sv2014", "sv2019", "velaro"]
    assert list(TRACKS) == ["crts2", "crts2-soft"]
    assert list(SPECTRA) == ["tb3352-ballastless", "german-low", "german-high", *(f"fra-{n}" for n in range(1, 7))]
    assert tuple(TREADS) == get_args(WheelTread)


@pytest.mark.parametrize("vehicle", VEHICLES.values(), ids=VEHICLES)
@pytest.mark.parametrize("track", TRACKS.values(), ids=TRACKS)
@pytest.mark.parametrize("spectrum", SPECTRA)
def test_any_train_runs_on_any_track(vehicle, track, spectrum):
    rough = Spectral(spectrum=spectrum, wavelength_min=2.0, wavelength_max=30.0)
    Case(speed=350 / 3.6, irregularity=rough, track=track.values, vehicle=vehicle.values)


@pytest.mark.parametrize(
    ("name", "load_kn"), [("crh3", 68.67), ("sv2014", 78.48), ("sv2019", 61.6803), ("velaro", 76.02750)]
)
def test_wheel_loads(name, load_kn):
    assert static_wheel_load(VEHICLES[name].values) / 1e3 == pytest.approx(load_kn, rel=1e-5)


def test_the_rail_sinks_on_the_soft_track_as_its_source_says():
    wheels, soft = wheel_positions(VEHICLES["crh3"].values), TRACKS["crts2-soft"]
    assert soft.values == replace(TRACKS["crts2"].values, mortar_stiffness=4.5e8, roadbed_stiffness=3e7)
    (rail, *_) = LayeredTrack(soft.values, 0.0).static_deflection(np.full(4, 68.67e3), wheels, wheels[0]) * 1e3
    assert f"{rail:.2f} mm" in soft.provenance["roadbed_stiffness"].text


def test_the_service_can_read_the_catalogue_without_numpy():
    program = "import sys, solver.catalogue, solver.profile; print({'numpy', 'scipy', 'numba'} & sys.modules.keys())"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "set()"
