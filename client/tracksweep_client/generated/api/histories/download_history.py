from http import HTTPStatus
from io import BytesIO
from typing import Any, cast
from urllib.parse import quote

import httpx

from ... import errors
from ...client import AuthenticatedClient, Client
from ...models.download_history_through import (
    DownloadHistoryThrough,
)
from ...models.problem_details import ProblemDetails
from ...types import UNSET, File, Response, Unset


def _get_kwargs(
    case_id: int,
    *,
    through: DownloadHistoryThrough | Unset = "any",
) -> dict[str, Any]:

    params: dict[str, Any] = {}

    json_through: str | Unset = UNSET
    if not isinstance(through, Unset):
        json_through = through

    params["through"] = json_through

    params = {k: v for k, v in params.items() if v is not UNSET and v is not None}

    _kwargs: dict[str, Any] = {
        "method": "get",
        "url": "/v1/cases/{case_id}/history.npz".format(
            case_id=quote(str(case_id), safe=""),
        ),
        "params": params,
    }

    return _kwargs


def _parse_response(
    *, client: AuthenticatedClient | Client, response: httpx.Response
) -> Any | File | ProblemDetails | None:
    if response.status_code == 200:
        response_200 = File(payload=BytesIO(response.content))

        return response_200

    if response.status_code == 206:
        response_206 = cast(Any, None)
        return response_206

    if response.status_code == 304:
        response_304 = cast(Any, None)
        return response_304

    if response.status_code == 307:
        response_307 = cast(Any, None)
        return response_307

    if response.status_code == 401:
        response_401 = ProblemDetails.from_dict(response.json())

        return response_401

    if response.status_code == 403:
        response_403 = ProblemDetails.from_dict(response.json())

        return response_403

    if response.status_code == 404:
        response_404 = ProblemDetails.from_dict(response.json())

        return response_404

    if response.status_code == 416:
        response_416 = ProblemDetails.from_dict(response.json())

        return response_416

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
) -> Response[Any | File | ProblemDetails]:
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
    through: DownloadHistoryThrough | Unset = "any",
) -> Response[Any | File | ProblemDetails]:
    """Download History

     Download the time history of a case at full resolution, as a NumPy archive.

    Args:
        case_id (int):
        through (DownloadHistoryThrough | Unset): Whether a service that is set up for it may
            answer with a link into its bucket (307). Default: 'any'.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[Any | File | ProblemDetails]
    """

    kwargs = _get_kwargs(
        case_id=case_id,
        through=through,
    )

    response = client.get_httpx_client().request(
        **kwargs,
    )

    return _build_response(client=client, response=response)


def sync(
    case_id: int,
    *,
    client: AuthenticatedClient | Client,
    through: DownloadHistoryThrough | Unset = "any",
) -> Any | File | ProblemDetails | None:
    """Download History

     Download the time history of a case at full resolution, as a NumPy archive.

    Args:
        case_id (int):
        through (DownloadHistoryThrough | Unset): Whether a service that is set up for it may
            answer with a link into its bucket (307). Default: 'any'.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Any | File | ProblemDetails
    """

    return sync_detailed(
        case_id=case_id,
        client=client,
        through=through,
    ).parsed


async def asyncio_detailed(
    case_id: int,
    *,
    client: AuthenticatedClient | Client,
    through: DownloadHistoryThrough | Unset = "any",
) -> Response[Any | File | ProblemDetails]:
    """Download History

     Download the time history of a case at full resolution, as a NumPy archive.

    Args:
        case_id (int):
        through (DownloadHistoryThrough | Unset): Whether a service that is set up for it may
            answer with a link into its bucket (307). Default: 'any'.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[Any | File | ProblemDetails]
    """

    kwargs = _get_kwargs(
        case_id=case_id,
        through=through,
    )

    response = await client.get_async_httpx_client().request(**kwargs)

    return _build_response(client=client, response=response)


async def asyncio(
    case_id: int,
    *,
    client: AuthenticatedClient | Client,
    through: DownloadHistoryThrough | Unset = "any",
) -> Any | File | ProblemDetails | None:
    """Download History

     Download the time history of a case at full resolution, as a NumPy archive.

    Args:
        case_id (int):
        through (DownloadHistoryThrough | Unset): Whether a service that is set up for it may
            answer with a link into its bucket (307). Default: 'any'.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Any | File | ProblemDetails
    """

    return (
        await asyncio_detailed(
            case_id=case_id,
            client=client,
            through=through,
        )
    ).parsed
