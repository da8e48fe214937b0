"""Vectors of lanes as a Numba type: one double per lane, kept in SIMD registers.

Plain loops over lanes are not turned into vector code by the compiler, so the vector operations are emitted
here one by one. A kernel receives ``lanes``, a tuple of as many numbers as there are lanes; its length is part of its
type and so known to the compiler. Where the numbers are floats their values do not matter: arrays have shape
(rows, lanes), and lanes are neighbours in memory. Where they are integers, arrays have shape (rows, 1), the lanes are
segments of that one column, and the first integer is the number of rows from a segment to the next.
"""

from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.core.datamodel import models
from numba.core.datamodel.registry import register_default

from solver.compiled import emitted

MAX_LANES = 8  # as many doubles as the widest registers hold; more gained nothing, fewer cost more each


class Lanes(types.Type):
    """A vector of ``width`` doubles."""

    def __init__(self, width: int) -> None:
        self.width = width
        super().__init__(name=f"Lanes({width})")


def _vector(width: int) -> ir.VectorType:
    return ir.VectorType(ir.DoubleType(), width)


@register_default(Lanes)
class _LanesModel(models.PrimitiveModel):
    def __init__(self, dmm: Any, fe_type: Lanes) -> None:
        super().__init__(dmm, fe_type, _vector(fe_type.width))  # type: ignore[no-untyped-call]  # Numba is untyped


def _is_segmented(lanes: Any) -> bool:
    return isinstance(lanes.dtype, types.Integer)


def _address(context: Any, builder: Any, array_type: Any, array: Any, row: Any, width: int) -> Any:
    """Where the neighbours in memory lie that are the lanes of a row."""
    data = context.make_array(array_type)(context, builder, array).data
    first = builder.gep(data, [builder.mul(row, ir.Constant(row.type, width))])
    return builder.bitcast(first, _vector(width).as_pointer())


def _addresses(context: Any, builder: Any, array_type: Any, array: Any, row: Any, lanes: Any, width: int) -> list[Any]:
    """Where the same row of every segment lies."""
    data = context.make_array(array_type)(context, builder, array).data
    apart = builder.extract_value(lanes, 0)
    starts = [builder.mul(apart, ir.Constant(apart.type, lane)) for lane in range(width)]
    return [builder.gep(data, [builder.add(row, start)]) for start in starts]


def _gather(context: Any, builder: Any, array_type: Any, args: Any, width: int) -> Any:
    vector = ir.Constant(_vector(width), ir.Undefined)
    array, row, lanes = args
    for lane, address in enumerate(_addresses(context, builder, array_type, array, row, lanes, width)):
        vector = builder.insert_element(vector, builder.load(address), _index(lane))
    return vector


def _index(lane: int) -> Any:
    return ir.Constant(ir.IntType(32), lane)


def _broadcast(builder: Any, scalar: Any, width: int) -> Any:
    if isinstance(scalar.type, ir.VectorType):
        return scalar
    empty = ir.Constant(_vector(width), ir.Undefined)
    one = builder.insert_element(empty, scalar, _index(0))
    return builder.shuffle_vector(one, empty, ir.Constant(ir.VectorType(ir.IntType(32), width), [0] * width))


@emitted
def load(_typing: Any, array: Any, row: Any, lanes: Any) -> Any:
    """The lanes of one row."""

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        if not _is_segmented(lanes):
            return builder.load(_address(context, builder, array, args[0], args[1], lanes.count), align=8)
        return _gather(context, builder, array, args, lanes.count)

    return Lanes(lanes.count)(array, types.intp, lanes), codegen


@emitted
def store(_typing: Any, array: Any, row: Any, vector: Any, lanes: Any) -> Any:
    """Write the lanes of one row."""

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        at, value, apart = args[1:]
        if not _is_segmented(lanes):
            builder.store(value, _address(context, builder, array, args[0], at, lanes.count), align=8)
        else:
            for lane, address in enumerate(_addresses(context, builder, array, args[0], at, apart, lanes.count)):
                builder.store(builder.extract_element(value, _index(lane)), address)
        return context.get_dummy_value()

    return types.void(array, types.intp, vector, lanes), codegen


@emitted
def coefficient(_typing: Any, array: Any, row: Any, lanes: Any) -> Any:
    """The number in every lane that an array without lanes holds for its row."""

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        if _is_segmented(lanes):
            return _gather(context, builder, array, args, lanes.count)
        data = context.make_array(array)(context, builder, args[0]).data
        return _broadcast(builder, builder.load(builder.gep(data, [args[1]])), lanes.count)

    return Lanes(lanes.count)(array, types.intp, lanes), codegen


@emitted
def neighbours(_typing: Any, lanes: Any) -> Any:
    """As many lanes, next to each other in memory."""
    together = types.UniTuple(types.float64, lanes.count)

    def codegen(context: Any, _builder: Any, _signature: Any, _args: Any) -> Any:
        return ir.Constant(context.get_value_type(together), [0.0] * lanes.count)

    return together(lanes), codegen


@emitted
def zero(_typing: Any, lanes: Any) -> Any:
    """Zero in every lane."""

    def codegen(_context: Any, _builder: Any, _signature: Any, _args: Any) -> Any:
        return ir.Constant(_vector(lanes.count), [0.0] * lanes.count)

    return Lanes(lanes.count)(lanes), codegen


@emitted
def fma(_typing: Any, factor: Any, x: Any, y: Any) -> Any:
    """``factor * x + y``, rounded once, for one factor common to all lanes or one for each."""

    def codegen(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
        vector = _vector(x.width)
        fused = cgutils.get_or_insert_function(
            builder.module, ir.FunctionType(vector, [vector] * 3), f"llvm.fma.v{x.width}f64"
        )
        return builder.call(fused, [_broadcast(builder, args[0], x.width), args[1], args[2]])

    return x(factor if isinstance(factor, Lanes) else types.float64, x, y), codegen


@emitted
def scale(_typing: Any, factor: Any, x: Any) -> Any:
    """``factor * x`` for one factor common to all lanes or one for each."""

    def codegen(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
        return builder.fmul(_broadcast(builder, args[0], x.width), args[1])

    return x(factor if isinstance(factor, Lanes) else types.float64, x), codegen


@emitted
def subtract(_typing: Any, x: Any, y: Any) -> Any:
    """``x - y``, lane by lane."""
    return x(x, y), lambda _context, builder, _signature, args: builder.fsub(args[0], args[1])


@emitted
def add(_typing: Any, x: Any, y: Any) -> Any:
    """``x + y``, lane by lane."""
    return x(x, y), lambda _context, builder, _signature, args: builder.fadd(args[0], args[1])
