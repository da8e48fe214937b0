from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar

from attrs import define as _attrs_define

from ..types import UNSET, Unset

T = TypeVar("T", bound="NumericsOverrides")


@_attrs_define
class NumericsOverrides:
    """Mesh, step and observed time.

    Attributes:
        track_length_m (float | Unset): Length of track that moves with the vehicle, m. Default: 140.0.
        elements_per_pad (int | Unset): Elements of each beam between two pads. Default: 12.
        mesh_offset (float | Unset): Part of an element by which the mesh lies behind the first wheel. Default: 0.5.
        time_step_s (float | Unset): Largest time step; the step used divides the time from pad to pad, s. Default:
            0.0001.
        start_m (float | Unset): Position of the first wheel on the track at the start, m. Default: 0.0.
        settle_s (float | Unset): Time computed and discarded before the window, s. Default: 1.0.
        window_s (float | Unset): Steady window from which peaks are read, s. Default: 3.0.
        ease_in_s (float | Unset): Time over which the irregularity grows to its full height, s. Default: 0.2.
        spectral_radius (float | Unset): Spectral radius of the integrator at infinite frequency. Default: 0.8.
        absorbing_length_m (float | Unset): Length of each absorbing end, m. Default: 24.0.
        absorbing_damping_ns_per_m2 (float | Unset): Damping of the whole track added at the very ends, N s/m^2.
            Default: 3000000.0.
        joint_blending (float | Unset): Pad spacings over which the shape functions of a joint fade. Default: 2.0.
    """

    track_length_m: float | Unset = 140.0
    elements_per_pad: int | Unset = 12
    mesh_offset: float | Unset = 0.5
    time_step_s: float | Unset = 0.0001
    start_m: float | Unset = 0.0
    settle_s: float | Unset = 1.0
    window_s: float | Unset = 3.0
    ease_in_s: float | Unset = 0.2
    spectral_radius: float | Unset = 0.8
    absorbing_length_m: float | Unset = 24.0
    absorbing_damping_ns_per_m2: float | Unset = 3000000.0
    joint_blending: float | Unset = 2.0

    def to_dict(self) -> dict[str, Any]:
        track_length_m = self.track_length_m

        elements_per_pad = self.elements_per_pad

        mesh_offset = self.mesh_offset

        time_step_s = self.time_step_s

        start_m = self.start_m

        settle_s = self.settle_s

        window_s = self.window_s

        ease_in_s = self.ease_in_s

        spectral_radius = self.spectral_radius

        absorbing_length_m = self.absorbing_length_m

        absorbing_damping_ns_per_m2 = self.absorbing_damping_ns_per_m2

        joint_blending = self.joint_blending

        field_dict: dict[str, Any] = {}

        field_dict.update({})
        if track_length_m is not UNSET:
            field_dict["track_length_m"] = track_length_m
        if elements_per_pad is not UNSET:
            field_dict["elements_per_pad"] = elements_per_pad
        if mesh_offset is not UNSET:
            field_dict["mesh_offset"] = mesh_offset
        if time_step_s is not UNSET:
            field_dict["time_step_s"] = time_step_s
        if start_m is not UNSET:
            field_dict["start_m"] = start_m
        if settle_s is not UNSET:
            field_dict["settle_s"] = settle_s
        if window_s is not UNSET:
            field_dict["window_s"] = window_s
        if ease_in_s is not UNSET:
            field_dict["ease_in_s"] = ease_in_s
        if spectral_radius is not UNSET:
            field_dict["spectral_radius"] = spectral_radius
        if absorbing_length_m is not UNSET:
            field_dict["absorbing_length_m"] = absorbing_length_m
        if absorbing_damping_ns_per_m2 is not UNSET:
            field_dict["absorbing_damping_ns_per_m2"] = absorbing_damping_ns_per_m2
        if joint_blending is not UNSET:
            field_dict["joint_blending"] = joint_blending

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        track_length_m = d.pop("track_length_m", UNSET)

        elements_per_pad = d.pop("elements_per_pad", UNSET)

        mesh_offset = d.pop("mesh_offset", UNSET)

        time_step_s = d.pop("time_step_s", UNSET)

        start_m = d.pop("start_m", UNSET)

        settle_s = d.pop("settle_s", UNSET)

        window_s = d.pop("window_s", UNSET)

        ease_in_s = d.pop("ease_in_s", UNSET)

        spectral_radius = d.pop("spectral_radius", UNSET)

        absorbing_length_m = d.pop("absorbing_length_m", UNSET)

        absorbing_damping_ns_per_m2 = d.pop("absorbing_damping_ns_per_m2", UNSET)

        joint_blending = d.pop("joint_blending", UNSET)

        numerics_overrides = cls(
            track_length_m=track_length_m,
            elements_per_pad=elements_per_pad,
            mesh_offset=mesh_offset,
            time_step_s=time_step_s,
            start_m=start_m,
            settle_s=settle_s,
            window_s=window_s,
            ease_in_s=ease_in_s,
            spectral_radius=spectral_radius,
            absorbing_length_m=absorbing_length_m,
            absorbing_damping_ns_per_m2=absorbing_damping_ns_per_m2,
            joint_blending=joint_blending,
        )

        return numerics_overrides
