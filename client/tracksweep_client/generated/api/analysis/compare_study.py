from http import HTTPStatus
from typing import Any, cast
from urllib.parse import quote

import httpx

from ... import errors
from ...client import AuthenticatedClient, Client
from ...models.compare_study_statistic import (
    CompareStudyStatistic,
)
from ...models.comparison import Comparison
from ...models.problem_details import ProblemDetails
from ...types import UNSET, Response, Unset


def _get_kwargs(
    study_id: str,
    *,
    quantity: str | Unset = UNSET,
    position: str | Unset = UNSET,
    statistic: CompareStudyStatistic | Unset = "peak",
    axis: str,
    baseline: str | Unset = UNSET,
) -> dict[str, Any]:

    params: dict[str, Any] = {}

    params["quantity"] = quantity

    params["position"] = position

    json_statistic: str | Unset = UNSET
    if not isinstance(statistic, Unset):
        json_statistic = statistic

    params["statistic"] = json_statistic

    params["axis"] = axis

    params["baseline"] = baseline

    params = {k: v for k, v in params.items() if v is not UNSET and v is not None}

    _kwargs: dict[str, Any] = {
        "method": "get",
        "url": "/v1/studies/{study_id}/comparison".format(
            study_id=quote(str(study_id), safe=""),
        ),
        "params": params,
    }

    return _kwargs


def _parse_response(
    *, client: AuthenticatedClient | Client, response: httpx.Response
) -> Any | Comparison | ProblemDetails | None:
    if response.status_code == 200:
        response_200 = Comparison.from_dict(response.json())

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
) -> Response[Any | Comparison | ProblemDetails]:
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
    statistic: CompareStudyStatistic | Unset = "peak",
    axis: str,
    baseline: str | Unset = UNSET,
) -> Response[Any | Comparison | ProblemDetails]:
    """Compare Study

     Compare cases that differ along one axis only, such as the slab or the percentile: each pair, and
    their mean.

    Args:
        study_id (str):
        quantity (str | Unset):
        position (str | Unset):
        statistic (CompareStudyStatistic | Unset): Which number of each case. Default: 'peak'.
        axis (str): What varies in the study and is to be compared: `slab`, `percentile`,
            `wavelength_band_m`, `speed_kmh`, `track.pad_stiffness_n_per_m`, …
        baseline (str | Unset): The value of the axis that the others are compared with, a number
            or a band as JSON has it; the first of the study if not given.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[Any | Comparison | ProblemDetails]
    """

    kwargs = _get_kwargs(
        study_id=study_id,
        quantity=quantity,
        position=position,
        statistic=statistic,
        axis=axis,
        baseline=baseline,
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
    statistic: CompareStudyStatistic | Unset = "peak",
    axis: str,
    baseline: str | Unset = UNSET,
) -> Any | Comparison | ProblemDetails | None:
    """Compare Study

     Compare cases that differ along one axis only, such as the slab or the percentile: each pair, and
    their mean.

    Args:
        study_id (str):
        quantity (str | Unset):
        position (str | Unset):
        statistic (CompareStudyStatistic | Unset): Which number of each case. Default: 'peak'.
        axis (str): What varies in the study and is to be compared: `slab`, `percentile`,
            `wavelength_band_m`, `speed_kmh`, `track.pad_stiffness_n_per_m`, …
        baseline (str | Unset): The value of the axis that the others are compared with, a number
            or a band as JSON has it; the first of the study if not given.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Any | Comparison | ProblemDetails
    """

    return sync_detailed(
        study_id=study_id,
        client=client,
        quantity=quantity,
        position=position,
        statistic=statistic,
        axis=axis,
        baseline=baseline,
    ).parsed


async def asyncio_detailed(
    study_id: str,
    *,
    client: AuthenticatedClient | Client,
    quantity: str | Unset = UNSET,
    position: str | Unset = UNSET,
    statistic: CompareStudyStatistic | Unset = "peak",
    axis: str,
    baseline: str | Unset = UNSET,
) -> Response[Any | Comparison | ProblemDetails]:
    """Compare Study

     Compare cases that differ along one axis only, such as the slab or the percentile: each pair, and
    their mean.

    Args:
        study_id (str):
        quantity (str | Unset):
        position (str | Unset):
        statistic (CompareStudyStatistic | Unset): Which number of each case. Default: 'peak'.
        axis (str): What varies in the study and is to be compared: `slab`, `percentile`,
            `wavelength_band_m`, `speed_kmh`, `track.pad_stiffness_n_per_m`, …
        baseline (str | Unset): The value of the axis that the others are compared with, a number
            or a band as JSON has it; the first of the study if not given.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[Any | Comparison | ProblemDetails]
    """

    kwargs = _get_kwargs(
        study_id=study_id,
        quantity=quantity,
        position=position,
        statistic=statistic,
        axis=axis,
        baseline=baseline,
    )

    response = await client.get_async_httpx_client().request(**kwargs)

    return _build_response(client=client, response=response)


async def asyncio(
    study_id: str,
    *,
    client: AuthenticatedClient | Client,
    quantity: str | Unset = UNSET,
    position: str | Unset = UNSET,
    statistic: CompareStudyStatistic | Unset = "peak",
    axis: str,
    baseline: str | Unset = UNSET,
) -> Any | Comparison | ProblemDetails | None:
    """Compare Study

     Compare cases that differ along one axis only, such as the slab or the percentile: each pair, and
    their mean.

    Args:
        study_id (str):
        quantity (str | Unset):
        position (str | Unset):
        statistic (CompareStudyStatistic | Unset): Which number of each case. Default: 'peak'.
        axis (str): What varies in the study and is to be compared: `slab`, `percentile`,
            `wavelength_band_m`, `speed_kmh`, `track.pad_stiffness_n_per_m`, …
        baseline (str | Unset): The value of the axis that the others are compared with, a number
            or a band as JSON has it; the first of the study if not given.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Any | Comparison | ProblemDetails
    """

    return (
        await asyncio_detailed(
            study_id=study_id,
            client=client,
            quantity=quantity,
            position=position,
            statistic=statistic,
            axis=axis,
            baseline=baseline,
        )
    ).parsed
