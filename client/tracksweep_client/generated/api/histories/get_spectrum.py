from http import HTTPStatus
from typing import Any, cast
from urllib.parse import quote

import httpx

from ... import errors
from ...client import AuthenticatedClient, Client
from ...models.problem_details import ProblemDetails
from ...models.spectrum_view import SpectrumView
from ...types import UNSET, Response, Unset


def _get_kwargs(
    case_id: int,
    *,
    quantity: str,
    position: str,
    resolution_hz: float | Unset = 2.0,
    frequency_max_hz: float | Unset = 1000.0,
) -> dict[str, Any]:

    params: dict[str, Any] = {}

    params["quantity"] = quantity

    params["position"] = position

    params["resolution_hz"] = resolution_hz

    params["frequency_max_hz"] = frequency_max_hz

    params = {k: v for k, v in params.items() if v is not UNSET and v is not None}

    _kwargs: dict[str, Any] = {
        "method": "get",
        "url": "/v1/cases/{case_id}/spectrum".format(
            case_id=quote(str(case_id), safe=""),
        ),
        "params": params,
    }

    return _kwargs


def _parse_response(
    *, client: AuthenticatedClient | Client, response: httpx.Response
) -> Any | ProblemDetails | SpectrumView | None:
    if response.status_code == 200:
        response_200 = SpectrumView.from_dict(response.json())

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
) -> Response[Any | ProblemDetails | SpectrumView]:
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
    quantity: str,
    position: str,
    resolution_hz: float | Unset = 2.0,
    frequency_max_hz: float | Unset = 1000.0,
) -> Response[Any | ProblemDetails | SpectrumView]:
    """Get Spectrum

     Get the spectrum of one channel of a stored history, with the frequencies of passing pads and of the
    wheel on
    the track.

    Args:
        case_id (int):
        quantity (str): A quantity of the history.
        position (str): Where, as in the history.
        resolution_hz (float | Unset): Distance between frequencies: the smaller, the fewer
            segments to take the mean of. Not less than the length of the history allows. Default:
            2.0.
        frequency_max_hz (float | Unset): Highest frequency, Hz. Default: 1000.0.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[Any | ProblemDetails | SpectrumView]
    """

    kwargs = _get_kwargs(
        case_id=case_id,
        quantity=quantity,
        position=position,
        resolution_hz=resolution_hz,
        frequency_max_hz=frequency_max_hz,
    )

    response = client.get_httpx_client().request(
        **kwargs,
    )

    return _build_response(client=client, response=response)


def sync(
    case_id: int,
    *,
    client: AuthenticatedClient | Client,
    quantity: str,
    position: str,
    resolution_hz: float | Unset = 2.0,
    frequency_max_hz: float | Unset = 1000.0,
) -> Any | ProblemDetails | SpectrumView | None:
    """Get Spectrum

     Get the spectrum of one channel of a stored history, with the frequencies of passing pads and of the
    wheel on
    the track.

    Args:
        case_id (int):
        quantity (str): A quantity of the history.
        position (str): Where, as in the history.
        resolution_hz (float | Unset): Distance between frequencies: the smaller, the fewer
            segments to take the mean of. Not less than the length of the history allows. Default:
            2.0.
        frequency_max_hz (float | Unset): Highest frequency, Hz. Default: 1000.0.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Any | ProblemDetails | SpectrumView
    """

    return sync_detailed(
        case_id=case_id,
        client=client,
        quantity=quantity,
        position=position,
        resolution_hz=resolution_hz,
        frequency_max_hz=frequency_max_hz,
    ).parsed


async def asyncio_detailed(
    case_id: int,
    *,
    client: AuthenticatedClient | Client,
    quantity: str,
    position: str,
    resolution_hz: float | Unset = 2.0,
    frequency_max_hz: float | Unset = 1000.0,
) -> Response[Any | ProblemDetails | SpectrumView]:
    """Get Spectrum

     Get the spectrum of one channel of a stored history, with the frequencies of passing pads and of the
    wheel on
    the track.

    Args:
        case_id (int):
        quantity (str): A quantity of the history.
        position (str): Where, as in the history.
        resolution_hz (float | Unset): Distance between frequencies: the smaller, the fewer
            segments to take the mean of. Not less than the length of the history allows. Default:
            2.0.
        frequency_max_hz (float | Unset): Highest frequency, Hz. Default: 1000.0.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[Any | ProblemDetails | SpectrumView]
    """

    kwargs = _get_kwargs(
        case_id=case_id,
        quantity=quantity,
        position=position,
        resolution_hz=resolution_hz,
        frequency_max_hz=frequency_max_hz,
    )

    response = await client.get_async_httpx_client().request(**kwargs)

    return _build_response(client=client, response=response)


async def asyncio(
    case_id: int,
    *,
    client: AuthenticatedClient | Client,
    quantity: str,
    position: str,
    resolution_hz: float | Unset = 2.0,
    frequency_max_hz: float | Unset = 1000.0,
) -> Any | ProblemDetails | SpectrumView | None:
    """Get Spectrum

     Get the spectrum of one channel of a stored history, with the frequencies of passing pads and of the
    wheel on
    the track.

    Args:
        case_id (int):
        quantity (str): A quantity of the history.
        position (str): Where, as in the history.
        resolution_hz (float | Unset): Distance between frequencies: the smaller, the fewer
            segments to take the mean of. Not less than the length of the history allows. Default:
            2.0.
        frequency_max_hz (float | Unset): Highest frequency, Hz. Default: 1000.0.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Any | ProblemDetails | SpectrumView
    """

    return (
        await asyncio_detailed(
            case_id=case_id,
            client=client,
            quantity=quantity,
            position=position,
            resolution_hz=resolution_hz,
            frequency_max_hz=frequency_max_hz,
        )
    ).parsed
