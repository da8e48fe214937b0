from __future__ import annotations

from collections.abc import Mapping
from typing import (
    TYPE_CHECKING,
    Any,
    Literal,
    TypeVar,
    cast,
)

from attrs import define as _attrs_define

if TYPE_CHECKING:
    from ..models.listed_case import ListedCase


T = TypeVar("T", bound="ListSweep")


@_attrs_define
class ListSweep:
    """Cases one by one.

    Attributes:
        kind (Literal['list']):
        cases (list[ListedCase]):
    """

    kind: Literal["list"]
    cases: list[ListedCase]

    def to_dict(self) -> dict[str, Any]:
        kind = self.kind

        cases = []
        for cases_item_data in self.cases:
            cases_item = cases_item_data.to_dict()
            cases.append(cases_item)

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "kind": kind,
                "cases": cases,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.listed_case import ListedCase  # noqa: PLC0415

        d = dict(src_dict)
        kind = cast(Literal["list"], d.pop("kind"))
        if kind != "list":
            raise ValueError(f"kind must match const 'list', got '{kind}'")

        cases = []
        _cases = d.pop("cases")
        for cases_item_data in _cases:
            cases_item = ListedCase.from_dict(cases_item_data)

            cases.append(cases_item)

        list_sweep = cls(
            kind=kind,
            cases=cases,
        )

        return list_sweep
