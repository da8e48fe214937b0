"""The catalogue over HTTP."""

from fastapi import APIRouter

from app.access import quotas
from app.access.caller import CallerDep
from app.catalogue import service
from app.catalogue.schemas import Limits, PresetList, QuantityList, SpectrumList, TrackList, VehicleList
from app.context import ContextDep
from solver.catalogue import TRACKS, VEHICLES

router = APIRouter(prefix="/v1", tags=["catalogue"])


@router.get("/quantities")
def list_quantities() -> QuantityList:
    """List the quantities of which peaks are given: units, conventions, and limits to compare them with."""
    return QuantityList(items=service.quantities())


@router.get("/spectra")
def list_spectra() -> SpectrumList:
    """List the named spectra of the rail head, each with its convention, range and sources."""
    return SpectrumList(items=service.spectra())


@router.get("/tracks")
def list_tracks() -> TrackList:
    """List the named tracks, each value with its unit, basis and source."""
    return TrackList(items=service.named_sets("track", TRACKS))


@router.get("/vehicles")
def list_vehicles() -> VehicleList:
    """List the named cars and wheel treads, each value with its unit, basis and source."""
    return VehicleList(items=service.named_sets("vehicle", VEHICLES), wheel_treads=service.wheel_treads())


@router.get("/presets")
def list_presets() -> PresetList:
    """List the ready-made studies, those of the article among them."""
    return PresetList(items=service.presets())


@router.get("/limits")
def get_limits(context: ContextDep, caller: CallerDep) -> Limits:
    """Get how much can be asked for, by this caller too, and the bounds of every number of the model."""
    with context.database.read() as session:
        own = quotas.limits(session, context.settings, caller)
    return service.limits(context.settings, own)
