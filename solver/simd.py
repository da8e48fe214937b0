"""Vectors of lanes as a Numba type: one double per lane, kept in SIMD registers.

Plain loops over lanes are not turned into vector code by the compiler, so the vector operations are emitted
here one by one. A kernel receives ``lanes``, a tuple of as many floats as there are lanes: only its type
matters, it carries the number of lanes into compilation. Arrays have shape (rows, lanes), C order.
"""

from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.core.datamodel import models
from numba.core.datamodel.registry import register_default

from solver.compiled import emitted


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


def _address(context: Any, builder: Any, array_type: Any, array: Any, row: Any, width: int) -> Any:
    data = context.make_array(array_type)(context, builder, array).data
    first = builder.gep(data, [builder.mul(row, ir.Constant(row.type, width))])
    return builder.bitcast(first, _vector(width).as_pointer())


def _broadcast(builder: Any, scalar: Any, width: int) -> Any:
    empty = ir.Constant(_vector(width), ir.Undefined)
    one = builder.insert_element(empty, scalar, ir.Constant(ir.IntType(32), 0))
    return builder.shuffle_vector(one, empty, ir.Constant(ir.VectorType(ir.IntType(32), width), [0] * width))


@emitted
def load(_typing: Any, array: Any, row: Any, lanes: Any) -> Any:
    """The lanes of one row of a (rows, lanes) array."""

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return builder.load(_address(context, builder, signature.args[0], args[0], args[1], lanes.count), align=8)

    return Lanes(lanes.count)(array, types.intp, lanes), codegen


@emitted
def store(_typing: Any, array: Any, row: Any, vector: Any) -> Any:
    """Write the lanes of one row."""

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        builder.store(args[2], _address(context, builder, signature.args[0], args[0], args[1], vector.width), align=8)
        return context.get_dummy_value()

    return types.void(array, types.intp, vector), codegen


@emitted
def zero(_typing: Any, lanes: Any) -> Any:
    """Zero in every lane."""

    def codegen(_context: Any, _builder: Any, _signature: Any, _args: Any) -> Any:
        return ir.Constant(_vector(lanes.count), [0.0] * lanes.count)

    return Lanes(lanes.count)(lanes), codegen


@emitted
def fma(_typing: Any, factor: Any, x: Any, y: Any) -> Any:
    """``factor * x + y`` for one factor common to all lanes, rounded once."""

    def codegen(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
        vector = _vector(x.width)
        fused = cgutils.get_or_insert_function(
            builder.module, ir.FunctionType(vector, [vector] * 3), f"llvm.fma.v{x.width}f64"
        )
        return builder.call(fused, [_broadcast(builder, args[0], x.width), args[1], args[2]])

    return x(types.float64, x, y), codegen


@emitted
def scale(_typing: Any, factor: Any, x: Any) -> Any:
    """``factor * x`` for one factor common to all lanes."""

    def codegen(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
        return builder.fmul(_broadcast(builder, args[0], x.width), args[1])

    return x(types.float64, x), codegen


@emitted
def subtract(_typing: Any, x: Any, y: Any) -> Any:
    """``x - y``, lane by lane."""
    return x(x, y), lambda _context, builder, _signature, args: builder.fsub(args[0], args[1])


@emitted
def add(_typing: Any, x: Any, y: Any) -> Any:
    """``x + y``, lane by lane."""
    return x(x, y), lambda _context, builder, _signature, args: builder.fadd(args[0], args[1])
