"""The track in the frame that moves with the vehicle (C-ELE): rail, slab and base on pads, mortar and roadbed.

Position ``r = x - V t`` (Eq. 5 of the article) runs forwards from the vehicle's centre. Seen from this frame
``d/dt`` becomes ``d/dt - V d/dr`` for every beam and damper (Eqs. 6-8), and the pads walk backwards through the mesh
by one spacing every ``phases`` steps. The mesh is cut into cells of one pad spacing, all alike. In its two ends
every step takes away a part of the velocity, so that waves do not come back.

Unknowns: (w, w', z, z', y, y') at every node, ordered by node. The first node is clamped, the one after the last
cell too and left out.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.linalg import solve_banded

from solver.arrays import Array
from solver.banded import HALF_BANDWIDTH
from solver.beam import HermiteElement, hermite
from solver.case import Case

RAIL, SLAB, BASE = 0, 1, 2
NODE = 6  # unknowns per node


def element_unknowns(beam: int) -> Array:
    """Where a beam's four unknowns stand among the twelve of two neighbouring nodes."""
    return np.array([0, 1, NODE, NODE + 1]) + 2 * beam


@dataclass(frozen=True)
class TrackModel:
    """The track of a case, its mesh, and its matrices at any phase."""

    case: Case

    @cached_property
    def element(self) -> HermiteElement:
        """The one element of the uniform mesh."""
        return HermiteElement(self.case.track.pad_spacing / self.case.numerics.elements_per_pad)

    @cached_property
    def cells(self) -> int:
        """Cells of one pad spacing."""
        return self.case.cells

    @cached_property
    def absorbing_cells(self) -> int:
        """Cells of each absorbing end."""
        return self.case.absorbing_cells

    @cached_property
    def left_end(self) -> float:
        """Position of the first node, m: the vehicle near the middle, whole spacings behind its first wheel."""
        vehicle, spacing = self.case.vehicle, self.case.track.pad_spacing
        first_wheel = vehicle.half_bogie_distance + vehicle.half_wheelbase
        return first_wheel - self.wheel_cell * spacing - self.case.numerics.mesh_offset * self.element.length

    def absorption(self, step: float) -> Array:
        """What a step (s) leaves of the velocity at every node, and its slope (1/m), shape (nodes, 2).

        The rate at which velocity is lost rises with the cube of the way into an end.
        """
        t, per_cell = self.case.track, self.case.numerics.elements_per_pad
        node, depth = np.arange(self.cells * per_cell), self.absorbing_cells * per_cell
        rate = self.case.numerics.absorbing_damping / (t.rail_mass + t.slab_mass + t.base_mass)
        ahead = node >= self.cells * per_cell / 2
        way = np.clip(1 - np.where(ahead, self.cells * per_cell - node, node) / depth, 0, 1)
        left = np.exp(-rate * step * way**3)
        slope = -rate * step * 3 * way**2 / (depth * self.element.length) * left
        return np.stack([left, np.where(ahead, slope, -slope)], axis=1)

    def locate(self, position: float) -> tuple[int, float]:
        """Element that holds a position, and where in it, 0 <= xi < 1."""
        element, xi = divmod((position - self.left_end) / self.element.length, 1.0)
        return int(element), float(xi)

    def pad_location(self, phase: int) -> tuple[int, float]:
        """Element within every cell that holds the pad at a phase, and where in it."""
        return self.locate_in_cell(0.0, phase)

    def _elements_ahead(self, part: float, phase: int) -> float:
        """Elements from the start of the first wheel's cell to what stands ahead of pad 0 by a part of the spacing."""
        numerics = self.case.numerics
        travelled = phase / self.case.phases + numerics.start / self.case.track.pad_spacing
        # Rounded, so that what stands on a node stays in one element.
        return round((part - travelled) * numerics.elements_per_pad + numerics.mesh_offset, 9)

    def locate_in_cell(self, part: float, phase: int) -> tuple[int, float]:
        """Element within a cell, and place in it, of what stands ahead of every pad by a part of the spacing."""
        element, xi = divmod(self._elements_ahead(part, phase) % self.case.numerics.elements_per_pad, 1.0)
        return int(element), xi

    def cell_shift(self, part: float, phase: int) -> int:
        """Cells from the first wheel's to that of what stands ahead of pad 0, in the first cycle of phases."""
        return int(self._elements_ahead(part, phase) // self.case.numerics.elements_per_pad)

    @cached_property
    def wheel_cell(self) -> int:
        """Cell that holds the first wheel."""
        vehicle = self.case.vehicle
        first_wheel = vehicle.half_bogie_distance + vehicle.half_wheelbase
        return round(first_wheel / self.case.track.pad_spacing + self.cells / 2)

    def shape(self, xi: float | Array, derivative: int = 0) -> Array:
        """Shape functions (..., 4) of one beam, or a derivative of them."""
        return hermite(xi, self.element.length, derivative)

    def layer(self, stiffness: float, damping: float, damping_factor: float) -> Array:
        """Matrix (4, 4) of an even layer acting on one relative displacement, ``damping_factor * C + K``."""
        e = self.element
        return (stiffness + damping_factor * damping) * e.mass - damping * self.case.speed * e.gradient

    def pad(self, xi: float, damping_factor: float) -> Array:
        """Matrix (4, 4) of a pad inside an element."""
        t = self.case.track
        n, slope = self.shape(xi), self.shape(xi, 1)
        stiff = (t.pad_stiffness + damping_factor * t.pad_damping) * np.outer(n, n)
        return stiff - t.pad_damping * self.case.speed * np.outer(n, slope)

    def _element_matrix(self, inertia_factor: float, damping_factor: float) -> Array:
        """The matrix (12, 12) that all elements share, without pads."""
        t, e, speed = self.case.track, self.element, self.case.speed
        matrix = np.zeros((2 * NODE, 2 * NODE))
        for beam, mass, bending_stiffness in (
            (RAIL, t.rail_mass, t.rail_elastic_modulus * t.rail_second_moment),
            (SLAB, t.slab_mass, t.slab_elastic_modulus * t.slab_second_moment),
            (BASE, t.base_mass, t.base_elastic_modulus * t.base_second_moment),
        ):
            matrix[np.ix_(*2 * [element_unknowns(beam)])] += (
                mass * (inertia_factor * e.mass - damping_factor * speed * e.convection - speed**2 * e.stretch)
                + bending_stiffness * e.bending
            )
        couple(matrix, SLAB, BASE, self.layer(t.mortar_stiffness, t.mortar_damping, damping_factor))
        base = np.ix_(*2 * [element_unknowns(BASE)])
        matrix[base] += self.layer(t.roadbed_stiffness, t.roadbed_damping, damping_factor)
        return matrix

    def band(self, cells: int, phase: int, inertia_factor: float = 0.0, damping_factor: float = 0.0) -> Array:
        """``inertia_factor * M + damping_factor * C + K`` of the track's first cells at a phase.

        Returns
        -------
        ndarray, shape (unknowns, 19)
            Entry (i, j) in ``[i, 9 + j - i]``; the first node is clamped.
        """
        per_cell = self.case.numerics.elements_per_pad
        element, xi = self.pad_location(phase)
        pad = np.zeros((2 * NODE, 2 * NODE))
        couple(pad, RAIL, SLAB, self.pad(xi, damping_factor))
        size = NODE * cells * per_cell
        band = np.zeros((size + NODE, 2 * HALF_BANDWIDTH + 1))
        for matrix, first, every in (
            (self._element_matrix(inertia_factor, damping_factor), 0, NODE),
            (pad, NODE * element, NODE * per_cell),
        ):
            for i, j in zip(*np.nonzero(matrix), strict=True):
                rows = slice(first + i, size + i, every)
                band[rows, HALF_BANDWIDTH + j - i] += matrix[i, j]
        clamp_first_node(band)
        return band[:-NODE]

    def point(self, position: float, beam: int, derivative: int = 0) -> tuple[int, Array]:
        """First row and weights (12,) that give a beam's value or derivative at a position."""
        element, xi = self.locate(position)
        weights = np.zeros(2 * NODE)
        weights[element_unknowns(beam)] = self.shape(xi, derivative)
        return NODE * element, weights

    def unit_loads(self, positions: Array) -> Array:
        """Nodal forces (unknowns, positions) of unit loads on the rail."""
        loads = np.zeros((NODE * self.cells * self.case.numerics.elements_per_pad, len(positions)))
        for column, position in enumerate(positions):
            row, weights = self.point(position, RAIL)
            loads[row : row + 2 * NODE, column] = weights
        return loads

    def steady_response(self, phase: int, loads: Array) -> Array:
        """Displacements that stand still in the moving frame while the pads are held at a phase."""
        band = self.band(self.cells, phase)
        upper_first = np.zeros((2 * HALF_BANDWIDTH + 1, len(band)))
        for offset in range(-HALF_BANDWIDTH, HALF_BANDWIDTH + 1):
            diagonal = band[max(0, -offset) : len(band) - max(0, offset), HALF_BANDWIDTH + offset]
            upper_first[HALF_BANDWIDTH - offset, max(0, offset) : len(band) - max(0, -offset)] = diagonal
        return solve_banded((HALF_BANDWIDTH, HALF_BANDWIDTH), upper_first, loads)


def couple(matrix: Array, upper: int, lower: int, block: Array) -> None:
    """Add a layer between two beams to a matrix of two nodes."""
    u, v = element_unknowns(upper), element_unknowns(lower)
    matrix[np.ix_(u, u)] += block
    matrix[np.ix_(v, v)] += block
    matrix[np.ix_(u, v)] -= block
    matrix[np.ix_(v, u)] -= block


def clamp_first_node(band: Array) -> None:
    """Replace the first node's equations by ``u = 0`` and take it out of all others."""
    band[:NODE] = 0
    band[:NODE, HALF_BANDWIDTH] = 1
    for row in range(NODE, NODE + HALF_BANDWIDTH):
        first = max(0, HALF_BANDWIDTH - row)
        band[row, first : max(first, HALF_BANDWIDTH + NODE - row)] = 0
