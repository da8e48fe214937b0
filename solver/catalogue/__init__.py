"""Named vehicles, wheel treads, tracks and spectra, each value with its source and how sure we are of it."""

from solver.catalogue.entry import Entry, Mark, Source
from solver.catalogue.spectra import SPECTRA
from solver.catalogue.tracks import TRACKS
from solver.catalogue.vehicles import TREADS, VEHICLES, Tread

__all__ = ["SPECTRA", "TRACKS", "TREADS", "VEHICLES", "Entry", "Mark", "Source", "Tread"]
