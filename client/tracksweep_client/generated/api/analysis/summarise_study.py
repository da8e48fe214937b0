from http import HTTPStatus
from typing import Any, cast
from urllib.parse import quote

import httpx

from ... import errors
from ...client import AuthenticatedClient, Client
from ...models.problem_details import ProblemDetails
from ...models.statistics import Statistics
from ...models.summarise_study_statistic import (
    SummariseStudyStatistic,
)
from ...types import UNSET, Response, Unset


def _get_kwargs(
    study_id: str,
    *,
    quantity: str | Unset = UNSET,
    position: str | Unset = UNSET,
    statistic: SummariseStudyStatistic | Unset = "peak",
) -> dict[str, Any]:

    params: dict[str, Any] = {}

    params["quantity"] = quantity

    params["position"] = position

    json_statistic: str | Unset = UNSET
    if not isinstance(statistic, Unset):
        json_statistic = statistic

    params["statistic"] = json_statistic

    params = {k: v for k, v in params.items() if v is not UNSET and v is not None}

    _kwargs: dict[str, Any] = {
        "method": "get",
        "url": "/v1/studies/{study_id}/statistics".format(
            study_id=quote(str(study_id), safe=""),
        ),
        "params": params,
    }

    return _kwargs


def _parse_response(
    *, client: AuthenticatedClient | Client, response: httpx.Response
) -> Any | ProblemDetails | Statistics | None:
    if response.status_code == 200:
        response_200 = Statistics.from_dict(response.json())

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
) -> Response[Any | ProblemDetails | Statistics]:
    return Response(
        status_code=HTTPStatus(response.status_code),
        content=response.content,
        headers=response.headers,
        parsed=_parse_response(client=client, response=response),
    )


def sync_detailed(
    study_id: str,
    *,
    client: AuthenticatedClient | Client,
    quantity: str | Unset = UNSET,
    position: str | Unset = UNSET,
    statistic: SummariseStudyStatistic | Unset = "peak",
) -> Response[Any | ProblemDetails | Statistics]:
    """Summarise Study

     Summarise each quantity over the realisations of each condition.

    Args:
        study_id (str):
        quantity (str | Unset):
        position (str | Unset):
        statistic (SummariseStudyStatistic | Unset): Which number of each case. Default: 'peak'.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[Any | ProblemDetails | Statistics]
    """

    kwargs = _get_kwargs(
        study_id=study_id,
        quantity=quantity,
        position=position,
        statistic=statistic,
    )

    response = client.get_httpx_client().request(
        **kwargs,
    )

    return _build_response(client=client, response=response)


def sync(
    study_id: str,
    *,
    client: AuthenticatedClient | Client,
    quantity: str | Unset = UNSET,
    position: str | Unset = UNSET,
    statistic: SummariseStudyStatistic | Unset = "peak",
) -> Any | ProblemDetails | Statistics | None:
    """Summarise Study

     Summarise each quantity over the realisations of each condition.

    Args:
        study_id (str):
        quantity (str | Unset):
        position (str | Unset):
        statistic (SummariseStudyStatistic | Unset): Which number of each case. Default: 'peak'.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Any | ProblemDetails | Statistics
    """

    return sync_detailed(
        study_id=study_id,
        client=client,
        quantity=quantity,
        position=position,
        statistic=statistic,
    ).parsed


async def asyncio_detailed(
    study_id: str,
    *,
    client: AuthenticatedClient | Client,
    quantity: str | Unset = UNSET,
    position: str | Unset = UNSET,
    statistic: SummariseStudyStatistic | Unset = "peak",
) -> Response[Any | ProblemDetails | Statistics]:
    """Summarise Study

     Summarise each quantity over the realisations of each condition.

    Args:
        study_id (str):
        quantity (str | Unset):
        position (str | Unset):
        statistic (SummariseStudyStatistic | Unset): Which number of each case. Default: 'peak'.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[Any | ProblemDetails | Statistics]
    """

    kwargs = _get_kwargs(
        study_id=study_id,
        quantity=quantity,
        position=position,
        statistic=statistic,
    )

    response = await client.get_async_httpx_client().request(**kwargs)

    return _build_response(client=client, response=response)


async def asyncio(
    study_id: str,
    *,
    client: AuthenticatedClient | Client,
    quantity: str | Unset = UNSET,
    position: str | Unset = UNSET,
    statistic: SummariseStudyStatistic | Unset = "peak",
) -> Any | ProblemDetails | Statistics | None:
    """Summarise Study

     Summarise each quantity over the realisations of each condition.

    Args:
        study_id (str):
        quantity (str | Unset):
        position (str | Unset):
        statistic (SummariseStudyStatistic | Unset): Which number of each case. Default: 'peak'.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Any | ProblemDetails | Statistics
    """

    return (
        await asyncio_detailed(
            study_id=study_id,
            client=client,
            quantity=quantity,
            position=position,
            statistic=statistic,
        )
    ).parsed
