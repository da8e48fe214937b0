import datetime
from http import HTTPStatus
from typing import Any

import httpx

from ... import errors
from ...client import AuthenticatedClient, Client
from ...models.list_studies_sort import ListStudiesSort
from ...models.list_studies_state import ListStudiesState
from ...models.problem_details import ProblemDetails
from ...models.study_page import StudyPage
from ...types import UNSET, Response, Unset


def _get_kwargs(
    *,
    page_size: int | Unset = UNSET,
    cursor: str | Unset = UNSET,
    state: ListStudiesState | Unset = UNSET,
    created_after: datetime.datetime | Unset = UNSET,
    name: str | Unset = UNSET,
    sort: ListStudiesSort | Unset = "-created_at",
) -> dict[str, Any]:

    params: dict[str, Any] = {}

    params["page_size"] = page_size

    params["cursor"] = cursor

    json_state: str | Unset = UNSET
    if not isinstance(state, Unset):
        json_state = state

    params["state"] = json_state

    json_created_after: str | Unset = UNSET
    if not isinstance(created_after, Unset):
        json_created_after = created_after.isoformat()
    params["created_after"] = json_created_after

    params["name"] = name

    json_sort: str | Unset = UNSET
    if not isinstance(sort, Unset):
        json_sort = sort

    params["sort"] = json_sort

    params = {k: v for k, v in params.items() if v is not UNSET and v is not None}

    _kwargs: dict[str, Any] = {
        "method": "get",
        "url": "/v1/studies",
        "params": params,
    }

    return _kwargs


def _parse_response(
    *, client: AuthenticatedClient | Client, response: httpx.Response
) -> ProblemDetails | StudyPage | None:
    if response.status_code == 200:
        response_200 = StudyPage.from_dict(response.json())

        return response_200

    if response.status_code == 401:
        response_401 = ProblemDetails.from_dict(response.json())

        return response_401

    if response.status_code == 403:
        response_403 = ProblemDetails.from_dict(response.json())

        return response_403

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
) -> Response[ProblemDetails | StudyPage]:
    return Response(
        status_code=HTTPStatus(response.status_code),
        content=response.content,
        headers=response.headers,
        parsed=_parse_response(client=client, response=response),
    )


def sync_detailed(
    *,
    client: AuthenticatedClient | Client,
    page_size: int | Unset = UNSET,
    cursor: str | Unset = UNSET,
    state: ListStudiesState | Unset = UNSET,
    created_after: datetime.datetime | Unset = UNSET,
    name: str | Unset = UNSET,
    sort: ListStudiesSort | Unset = "-created_at",
) -> Response[ProblemDetails | StudyPage]:
    """List Studies

     List studies, the newest first unless sorted otherwise.

    Args:
        page_size (int | Unset): Rows per page; 100 if not given.
        cursor (str | Unset): `next_cursor` of the page before.
        state (ListStudiesState | Unset):
        created_after (datetime.datetime | Unset): Only studies created after this instant.
        name (str | Unset): Only studies whose name contains this, in upper or lower case.
        sort (ListStudiesSort | Unset):  Default: '-created_at'.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[ProblemDetails | StudyPage]
    """

    kwargs = _get_kwargs(
        page_size=page_size,
        cursor=cursor,
        state=state,
        created_after=created_after,
        name=name,
        sort=sort,
    )

    response = client.get_httpx_client().request(
        **kwargs,
    )

    return _build_response(client=client, response=response)


def sync(
    *,
    client: AuthenticatedClient | Client,
    page_size: int | Unset = UNSET,
    cursor: str | Unset = UNSET,
    state: ListStudiesState | Unset = UNSET,
    created_after: datetime.datetime | Unset = UNSET,
    name: str | Unset = UNSET,
    sort: ListStudiesSort | Unset = "-created_at",
) -> ProblemDetails | StudyPage | None:
    """List Studies

     List studies, the newest first unless sorted otherwise.

    Args:
        page_size (int | Unset): Rows per page; 100 if not given.
        cursor (str | Unset): `next_cursor` of the page before.
        state (ListStudiesState | Unset):
        created_after (datetime.datetime | Unset): Only studies created after this instant.
        name (str | Unset): Only studies whose name contains this, in upper or lower case.
        sort (ListStudiesSort | Unset):  Default: '-created_at'.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        ProblemDetails | StudyPage
    """

    return sync_detailed(
        client=client,
        page_size=page_size,
        cursor=cursor,
        state=state,
        created_after=created_after,
        name=name,
        sort=sort,
    ).parsed


async def asyncio_detailed(
    *,
    client: AuthenticatedClient | Client,
    page_size: int | Unset = UNSET,
    cursor: str | Unset = UNSET,
    state: ListStudiesState | Unset = UNSET,
    created_after: datetime.datetime | Unset = UNSET,
    name: str | Unset = UNSET,
    sort: ListStudiesSort | Unset = "-created_at",
) -> Response[ProblemDetails | StudyPage]:
    """List Studies

     List studies, the newest first unless sorted otherwise.

    Args:
        page_size (int | Unset): Rows per page; 100 if not given.
        cursor (str | Unset): `next_cursor` of the page before.
        state (ListStudiesState | Unset):
        created_after (datetime.datetime | Unset): Only studies created after this instant.
        name (str | Unset): Only studies whose name contains this, in upper or lower case.
        sort (ListStudiesSort | Unset):  Default: '-created_at'.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[ProblemDetails | StudyPage]
    """

    kwargs = _get_kwargs(
        page_size=page_size,
        cursor=cursor,
        state=state,
        created_after=created_after,
        name=name,
        sort=sort,
    )

    response = await client.get_async_httpx_client().request(**kwargs)

    return _build_response(client=client, response=response)


async def asyncio(
    *,
    client: AuthenticatedClient | Client,
    page_size: int | Unset = UNSET,
    cursor: str | Unset = UNSET,
    state: ListStudiesState | Unset = UNSET,
    created_after: datetime.datetime | Unset = UNSET,
    name: str | Unset = UNSET,
    sort: ListStudiesSort | Unset = "-created_at",
) -> ProblemDetails | StudyPage | None:
    """List Studies

     List studies, the newest first unless sorted otherwise.

    Args:
        page_size (int | Unset): Rows per page; 100 if not given.
        cursor (str | Unset): `next_cursor` of the page before.
        state (ListStudiesState | Unset):
        created_after (datetime.datetime | Unset): Only studies created after this instant.
        name (str | Unset): Only studies whose name contains this, in upper or lower case.
        sort (ListStudiesSort | Unset):  Default: '-created_at'.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        ProblemDetails | StudyPage
    """

    return (
        await asyncio_detailed(
            client=client,
            page_size=page_size,
            cursor=cursor,
            state=state,
            created_after=created_after,
            name=name,
            sort=sort,
        )
    ).parsed
