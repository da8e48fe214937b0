from http import HTTPStatus
from typing import Any, cast
from urllib.parse import quote

import httpx

from ... import errors
from ...client import AuthenticatedClient, Client
from ...models.case_page import CasePage
from ...models.list_cases_sort import ListCasesSort
from ...models.list_cases_state import ListCasesState
from ...models.problem_details import ProblemDetails
from ...types import UNSET, Response, Unset


def _get_kwargs(
    study_id: str,
    *,
    page_size: int | Unset = UNSET,
    cursor: str | Unset = UNSET,
    state: ListCasesState | Unset = UNSET,
    slab: str | Unset = UNSET,
    irregularity: str | Unset = UNSET,
    percentile: float | Unset = UNSET,
    speed_kmh_min: float | Unset = UNSET,
    speed_kmh_max: float | Unset = UNSET,
    sort: ListCasesSort | Unset = "position",
) -> dict[str, Any]:

    params: dict[str, Any] = {}

    params["page_size"] = page_size

    params["cursor"] = cursor

    json_state: str | Unset = UNSET
    if not isinstance(state, Unset):
        json_state = state

    params["state"] = json_state

    params["slab"] = slab

    params["irregularity"] = irregularity

    params["percentile"] = percentile

    params["speed_kmh_min"] = speed_kmh_min

    params["speed_kmh_max"] = speed_kmh_max

    json_sort: str | Unset = UNSET
    if not isinstance(sort, Unset):
        json_sort = sort

    params["sort"] = json_sort

    params = {k: v for k, v in params.items() if v is not UNSET and v is not None}

    _kwargs: dict[str, Any] = {
        "method": "get",
        "url": "/v1/studies/{study_id}/cases".format(
            study_id=quote(str(study_id), safe=""),
        ),
        "params": params,
    }

    return _kwargs


def _parse_response(
    *, client: AuthenticatedClient | Client, response: httpx.Response
) -> Any | CasePage | ProblemDetails | None:
    if response.status_code == 200:
        response_200 = CasePage.from_dict(response.json())

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
) -> Response[Any | CasePage | ProblemDetails]:
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
    page_size: int | Unset = UNSET,
    cursor: str | Unset = UNSET,
    state: ListCasesState | Unset = UNSET,
    slab: str | Unset = UNSET,
    irregularity: str | Unset = UNSET,
    percentile: float | Unset = UNSET,
    speed_kmh_min: float | Unset = UNSET,
    speed_kmh_max: float | Unset = UNSET,
    sort: ListCasesSort | Unset = "position",
) -> Response[Any | CasePage | ProblemDetails]:
    """List Cases

     List the cases of a study, in the order of its sweep unless sorted otherwise.

    Args:
        study_id (str):
        page_size (int | Unset): Rows per page; 100 if not given.
        cursor (str | Unset): `next_cursor` of the page before.
        state (ListCasesState | Unset):
        slab (str | Unset):
        irregularity (str | Unset):
        percentile (float | Unset):
        speed_kmh_min (float | Unset):
        speed_kmh_max (float | Unset):
        sort (ListCasesSort | Unset): A column, or the place in the sweep; with a minus sign, from
            large to small. Default: 'position'.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[Any | CasePage | ProblemDetails]
    """

    kwargs = _get_kwargs(
        study_id=study_id,
        page_size=page_size,
        cursor=cursor,
        state=state,
        slab=slab,
        irregularity=irregularity,
        percentile=percentile,
        speed_kmh_min=speed_kmh_min,
        speed_kmh_max=speed_kmh_max,
        sort=sort,
    )

    response = client.get_httpx_client().request(
        **kwargs,
    )

    return _build_response(client=client, response=response)


def sync(
    study_id: str,
    *,
    client: AuthenticatedClient | Client,
    page_size: int | Unset = UNSET,
    cursor: str | Unset = UNSET,
    state: ListCasesState | Unset = UNSET,
    slab: str | Unset = UNSET,
    irregularity: str | Unset = UNSET,
    percentile: float | Unset = UNSET,
    speed_kmh_min: float | Unset = UNSET,
    speed_kmh_max: float | Unset = UNSET,
    sort: ListCasesSort | Unset = "position",
) -> Any | CasePage | ProblemDetails | None:
    """List Cases

     List the cases of a study, in the order of its sweep unless sorted otherwise.

    Args:
        study_id (str):
        page_size (int | Unset): Rows per page; 100 if not given.
        cursor (str | Unset): `next_cursor` of the page before.
        state (ListCasesState | Unset):
        slab (str | Unset):
        irregularity (str | Unset):
        percentile (float | Unset):
        speed_kmh_min (float | Unset):
        speed_kmh_max (float | Unset):
        sort (ListCasesSort | Unset): A column, or the place in the sweep; with a minus sign, from
            large to small. Default: 'position'.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Any | CasePage | ProblemDetails
    """

    return sync_detailed(
        study_id=study_id,
        client=client,
        page_size=page_size,
        cursor=cursor,
        state=state,
        slab=slab,
        irregularity=irregularity,
        percentile=percentile,
        speed_kmh_min=speed_kmh_min,
        speed_kmh_max=speed_kmh_max,
        sort=sort,
    ).parsed


async def asyncio_detailed(
    study_id: str,
    *,
    client: AuthenticatedClient | Client,
    page_size: int | Unset = UNSET,
    cursor: str | Unset = UNSET,
    state: ListCasesState | Unset = UNSET,
    slab: str | Unset = UNSET,
    irregularity: str | Unset = UNSET,
    percentile: float | Unset = UNSET,
    speed_kmh_min: float | Unset = UNSET,
    speed_kmh_max: float | Unset = UNSET,
    sort: ListCasesSort | Unset = "position",
) -> Response[Any | CasePage | ProblemDetails]:
    """List Cases

     List the cases of a study, in the order of its sweep unless sorted otherwise.

    Args:
        study_id (str):
        page_size (int | Unset): Rows per page; 100 if not given.
        cursor (str | Unset): `next_cursor` of the page before.
        state (ListCasesState | Unset):
        slab (str | Unset):
        irregularity (str | Unset):
        percentile (float | Unset):
        speed_kmh_min (float | Unset):
        speed_kmh_max (float | Unset):
        sort (ListCasesSort | Unset): A column, or the place in the sweep; with a minus sign, from
            large to small. Default: 'position'.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[Any | CasePage | ProblemDetails]
    """

    kwargs = _get_kwargs(
        study_id=study_id,
        page_size=page_size,
        cursor=cursor,
        state=state,
        slab=slab,
        irregularity=irregularity,
        percentile=percentile,
        speed_kmh_min=speed_kmh_min,
        speed_kmh_max=speed_kmh_max,
        sort=sort,
    )

    response = await client.get_async_httpx_client().request(**kwargs)

    return _build_response(client=client, response=response)


async def asyncio(
    study_id: str,
    *,
    client: AuthenticatedClient | Client,
    page_size: int | Unset = UNSET,
    cursor: str | Unset = UNSET,
    state: ListCasesState | Unset = UNSET,
    slab: str | Unset = UNSET,
    irregularity: str | Unset = UNSET,
    percentile: float | Unset = UNSET,
    speed_kmh_min: float | Unset = UNSET,
    speed_kmh_max: float | Unset = UNSET,
    sort: ListCasesSort | Unset = "position",
) -> Any | CasePage | ProblemDetails | None:
    """List Cases

     List the cases of a study, in the order of its sweep unless sorted otherwise.

    Args:
        study_id (str):
        page_size (int | Unset): Rows per page; 100 if not given.
        cursor (str | Unset): `next_cursor` of the page before.
        state (ListCasesState | Unset):
        slab (str | Unset):
        irregularity (str | Unset):
        percentile (float | Unset):
        speed_kmh_min (float | Unset):
        speed_kmh_max (float | Unset):
        sort (ListCasesSort | Unset): A column, or the place in the sweep; with a minus sign, from
            large to small. Default: 'position'.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Any | CasePage | ProblemDetails
    """

    return (
        await asyncio_detailed(
            study_id=study_id,
            client=client,
            page_size=page_size,
            cursor=cursor,
            state=state,
            slab=slab,
            irregularity=irregularity,
            percentile=percentile,
            speed_kmh_min=speed_kmh_min,
            speed_kmh_max=speed_kmh_max,
            sort=sort,
        )
    ).parsed
