from http import HTTPStatus
from typing import Any, cast
from urllib.parse import quote

import httpx

from ... import errors
from ...client import AuthenticatedClient, Client
from ...models.history_view import HistoryView
from ...models.problem_details import ProblemDetails
from ...types import UNSET, Response, Unset


def _get_kwargs(
    case_id: int,
    *,
    quantity: list[str] | Unset = UNSET,
    position: list[str] | Unset = UNSET,
    time_min_s: float | Unset = UNSET,
    time_max_s: float | Unset = UNSET,
    max_points: int | Unset = 1000,
) -> dict[str, Any]:

    params: dict[str, Any] = {}

    json_quantity: list[str] | Unset = UNSET
    if not isinstance(quantity, Unset):
        json_quantity = quantity

    params["quantity"] = json_quantity

    json_position: list[str] | Unset = UNSET
    if not isinstance(position, Unset):
        json_position = position

    params["position"] = json_position

    params["time_min_s"] = time_min_s

    params["time_max_s"] = time_max_s

    params["max_points"] = max_points

    params = {k: v for k, v in params.items() if v is not UNSET and v is not None}

    _kwargs: dict[str, Any] = {
        "method": "get",
        "url": "/v1/cases/{case_id}/history".format(
            case_id=quote(str(case_id), safe=""),
        ),
        "params": params,
    }

    return _kwargs


def _parse_response(
    *, client: AuthenticatedClient | Client, response: httpx.Response
) -> Any | HistoryView | ProblemDetails | None:
    if response.status_code == 200:
        response_200 = HistoryView.from_dict(response.json())

        return response_200

    if response.status_code == 304:
        response_304 = cast(Any, None)
        return response_304

    if response.status_code == 401:
        response_401 = ProblemDetails.from_dict(response.json())

        return response_401

    if response.status_code == 403:
        response_403 = ProblemDetails.from_dict(response.json())

        return response_403

    if response.status_code == 404:
        response_404 = ProblemDetails.from_dict(response.json())

        return response_404

    if response.status_code == 422:
        response_422 = ProblemDetails.from_dict(response.json())

        return response_422

    if response.status_code == 429:
        response_429 = ProblemDetails.from_dict(response.json())

        return response_429

    if response.status_code == 503:
        response_503 = ProblemDetails.from_dict(response.json())

        return response_503

    if client.raise_on_unexpected_status:
        raise errors.UnexpectedStatus(response.status_code, response.content)
    else:
        return None


def _build_response(
    *, client: AuthenticatedClient | Client, response: httpx.Response
) -> Response[Any | HistoryView | ProblemDetails]:
    return Response(
        status_code=HTTPStatus(response.status_code),
        content=response.content,
        headers=response.headers,
        parsed=_parse_response(client=client, response=response),
    )


def sync_detailed(
    case_id: int,
    *,
    client: AuthenticatedClient | Client,
    quantity: list[str] | Unset = UNSET,
    position: list[str] | Unset = UNSET,
    time_min_s: float | Unset = UNSET,
    time_max_s: float | Unset = UNSET,
    max_points: int | Unset = 1000,
) -> Response[Any | HistoryView | ProblemDetails]:
    """Get History

     Get the time history of a case, or a part of it, as fine as a screen can show. No peak is lost.

    Args:
        case_id (int):
        quantity (list[str] | Unset): Only channels of these quantities; may be repeated.
        position (list[str] | Unset): Only channels at these positions; may be repeated.
        time_min_s (float | Unset): Start, s since the window began.
        time_max_s (float | Unset): End, s since the window began.
        max_points (int | Unset): Samples per channel. Of more, those that are least or greatest
            among their neighbours are kept as they are, so that no peak is lost. Default: 1000.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[Any | HistoryView | ProblemDetails]
    """

    kwargs = _get_kwargs(
        case_id=case_id,
        quantity=quantity,
        position=position,
        time_min_s=time_min_s,
        time_max_s=time_max_s,
        max_points=max_points,
    )

    response = client.get_httpx_client().request(
        **kwargs,
    )

    return _build_response(client=client, response=response)


def sync(
    case_id: int,
    *,
    client: AuthenticatedClient | Client,
    quantity: list[str] | Unset = UNSET,
    position: list[str] | Unset = UNSET,
    time_min_s: float | Unset = UNSET,
    time_max_s: float | Unset = UNSET,
    max_points: int | Unset = 1000,
) -> Any | HistoryView | ProblemDetails | None:
    """Get History

     Get the time history of a case, or a part of it, as fine as a screen can show. No peak is lost.

    Args:
        case_id (int):
        quantity (list[str] | Unset): Only channels of these quantities; may be repeated.
        position (list[str] | Unset): Only channels at these positions; may be repeated.
        time_min_s (float | Unset): Start, s since the window began.
        time_max_s (float | Unset): End, s since the window began.
        max_points (int | Unset): Samples per channel. Of more, those that are least or greatest
            among their neighbours are kept as they are, so that no peak is lost. Default: 1000.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Any | HistoryView | ProblemDetails
    """

    return sync_detailed(
        case_id=case_id,
        client=client,
        quantity=quantity,
        position=position,
        time_min_s=time_min_s,
        time_max_s=time_max_s,
        max_points=max_points,
    ).parsed


async def asyncio_detailed(
    case_id: int,
    *,
    client: AuthenticatedClient | Client,
    quantity: list[str] | Unset = UNSET,
    position: list[str] | Unset = UNSET,
    time_min_s: float | Unset = UNSET,
    time_max_s: float | Unset = UNSET,
    max_points: int | Unset = 1000,
) -> Response[Any | HistoryView | ProblemDetails]:
    """Get History

     Get the time history of a case, or a part of it, as fine as a screen can show. No peak is lost.

    Args:
        case_id (int):
        quantity (list[str] | Unset): Only channels of these quantities; may be repeated.
        position (list[str] | Unset): Only channels at these positions; may be repeated.
        time_min_s (float | Unset): Start, s since the window began.
        time_max_s (float | Unset): End, s since the window began.
        max_points (int | Unset): Samples per channel. Of more, those that are least or greatest
            among their neighbours are kept as they are, so that no peak is lost. Default: 1000.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[Any | HistoryView | ProblemDetails]
    """

    kwargs = _get_kwargs(
        case_id=case_id,
        quantity=quantity,
        position=position,
        time_min_s=time_min_s,
        time_max_s=time_max_s,
        max_points=max_points,
    )

    response = await client.get_async_httpx_client().request(**kwargs)

    return _build_response(client=client, response=response)


async def asyncio(
    case_id: int,
    *,
    client: AuthenticatedClient | Client,
    quantity: list[str] | Unset = UNSET,
    position: list[str] | Unset = UNSET,
    time_min_s: float | Unset = UNSET,
    time_max_s: float | Unset = UNSET,
    max_points: int | Unset = 1000,
) -> Any | HistoryView | ProblemDetails | None:
    """Get History

     Get the time history of a case, or a part of it, as fine as a screen can show. No peak is lost.

    Args:
        case_id (int):
        quantity (list[str] | Unset): Only channels of these quantities; may be repeated.
        position (list[str] | Unset): Only channels at these positions; may be repeated.
        time_min_s (float | Unset): Start, s since the window began.
        time_max_s (float | Unset): End, s since the window began.
        max_points (int | Unset): Samples per channel. Of more, those that are least or greatest
            among their neighbours are kept as they are, so that no peak is lost. Default: 1000.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Any | HistoryView | ProblemDetails
    """

    return (
        await asyncio_detailed(
            case_id=case_id,
            client=client,
            quantity=quantity,
            position=position,
            time_min_s=time_min_s,
            time_max_s=time_max_s,
            max_points=max_points,
        )
    ).parsed
