from __future__ import annotations

import datetime
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar, cast

from attrs import define as _attrs_define
from attrs import field as _attrs_field

if TYPE_CHECKING:
    from ..models.throughput import Throughput
    from ..models.worker_info import WorkerInfo


T = TypeVar("T", bound="QueueInfo")


@_attrs_define
class QueueInfo:
    """The queue and its workers.

    Attributes:
        queued (int): Cases that wait, whoever asked for them.
        running (int):
        oldest_queued_at (datetime.datetime | None): When the oldest case that waits was first asked for.
        throughput (Throughput): How many cases were computed lately, successfully or not; of the latest 10 000 cases.
        workers (list[WorkerInfo]):
    """

    queued: int
    running: int
    oldest_queued_at: datetime.datetime | None
    throughput: Throughput
    workers: list[WorkerInfo]
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        queued = self.queued

        running = self.running

        oldest_queued_at: None | str
        if isinstance(self.oldest_queued_at, datetime.datetime):
            oldest_queued_at = self.oldest_queued_at.isoformat()
        else:
            oldest_queued_at = self.oldest_queued_at

        throughput = self.throughput.to_dict()

        workers = []
        for workers_item_data in self.workers:
            workers_item = workers_item_data.to_dict()
            workers.append(workers_item)

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "queued": queued,
                "running": running,
                "oldest_queued_at": oldest_queued_at,
                "throughput": throughput,
                "workers": workers,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.throughput import Throughput  # noqa: PLC0415
        from ..models.worker_info import WorkerInfo  # noqa: PLC0415

        d = dict(src_dict)
        queued = d.pop("queued")

        running = d.pop("running")

        def _parse_oldest_queued_at(data: object) -> datetime.datetime | None:
            if data is None:
                return data
            try:
                if not isinstance(data, str):
                    raise TypeError()
                oldest_queued_at_type_0 = datetime.datetime.fromisoformat(data)

                return oldest_queued_at_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(datetime.datetime | None, data)

        oldest_queued_at = _parse_oldest_queued_at(d.pop("oldest_queued_at"))

        throughput = Throughput.from_dict(d.pop("throughput"))

        workers = []
        _workers = d.pop("workers")
        for workers_item_data in _workers:
            workers_item = WorkerInfo.from_dict(workers_item_data)

            workers.append(workers_item)

        queue_info = cls(
            queued=queued,
            running=running,
            oldest_queued_at=oldest_queued_at,
            throughput=throughput,
            workers=workers,
        )

        queue_info.additional_properties = d
        return queue_info

    @property
    def additional_keys(self) -> list[str]:
        return list(self.additional_properties.keys())

    def __getitem__(self, key: str) -> Any:
        return self.additional_properties[key]

    def __setitem__(self, key: str, value: Any) -> None:
        self.additional_properties[key] = value

    def __delitem__(self, key: str) -> None:
        del self.additional_properties[key]

    def __contains__(self, key: str) -> bool:
        return key in self.additional_properties
