from http import HTTPStatus
from typing import Any

import httpx

from ... import errors
from ...client import AuthenticatedClient, Client
from ...models.problem_details import ProblemDetails
from ...models.study_detail import StudyDetail
from ...models.study_request import StudyRequest
from ...types import UNSET, Response, Unset


def _get_kwargs(
    *,
    body: StudyRequest,
    idempotency_key: str | Unset = UNSET,
) -> dict[str, Any]:
    headers: dict[str, Any] = {}
    if not isinstance(idempotency_key, Unset):
        headers["Idempotency-Key"] = idempotency_key

    _kwargs: dict[str, Any] = {
        "method": "post",
        "url": "/v1/studies",
    }

    _kwargs["json"] = body.to_dict()

    headers["Content-Type"] = "application/json"

    _kwargs["headers"] = headers
    return _kwargs


def _parse_response(
    *, client: AuthenticatedClient | Client, response: httpx.Response
) -> ProblemDetails | StudyDetail | None:
    if response.status_code == 201:
        response_201 = StudyDetail.from_dict(response.json())

        return response_201

    if response.status_code == 400:
        response_400 = ProblemDetails.from_dict(response.json())

        return response_400

    if response.status_code == 401:
        response_401 = ProblemDetails.from_dict(response.json())

        return response_401

    if response.status_code == 403:
        response_403 = ProblemDetails.from_dict(response.json())

        return response_403

    if response.status_code == 409:
        response_409 = ProblemDetails.from_dict(response.json())

        return response_409

    if response.status_code == 413:
        response_413 = ProblemDetails.from_dict(response.json())

        return response_413

    if response.status_code == 415:
        response_415 = ProblemDetails.from_dict(response.json())

        return response_415

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
) -> Response[ProblemDetails | StudyDetail]:
    return Response(
        status_code=HTTPStatus(response.status_code),
        content=response.content,
        headers=response.headers,
        parsed=_parse_response(client=client, response=response),
    )


def sync_detailed(
    *,
    client: AuthenticatedClient | Client,
    body: StudyRequest,
    idempotency_key: str | Unset = UNSET,
) -> Response[ProblemDetails | StudyDetail]:
    """Create Study

     Accept a study and queue its cases. Cases that any study had before are not computed again.

    Args:
        idempotency_key (str | Unset): Any unique text. A repeated request with the same key and
            body gets the first answer again, for 24 hours; one that comes while the first is still in
            progress is answered 409 and may be sent again.
        body (StudyRequest): A parametric study: a sweep of one model.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[ProblemDetails | StudyDetail]
    """

    kwargs = _get_kwargs(
        body=body,
        idempotency_key=idempotency_key,
    )

    response = client.get_httpx_client().request(
        **kwargs,
    )

    return _build_response(client=client, response=response)


def sync(
    *,
    client: AuthenticatedClient | Client,
    body: StudyRequest,
    idempotency_key: str | Unset = UNSET,
) -> ProblemDetails | StudyDetail | None:
    """Create Study

     Accept a study and queue its cases. Cases that any study had before are not computed again.

    Args:
        idempotency_key (str | Unset): Any unique text. A repeated request with the same key and
            body gets the first answer again, for 24 hours; one that comes while the first is still in
            progress is answered 409 and may be sent again.
        body (StudyRequest): A parametric study: a sweep of one model.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        ProblemDetails | StudyDetail
    """

    return sync_detailed(
        client=client,
        body=body,
        idempotency_key=idempotency_key,
    ).parsed


async def asyncio_detailed(
    *,
    client: AuthenticatedClient | Client,
    body: StudyRequest,
    idempotency_key: str | Unset = UNSET,
) -> Response[ProblemDetails | StudyDetail]:
    """Create Study

     Accept a study and queue its cases. Cases that any study had before are not computed again.

    Args:
        idempotency_key (str | Unset): Any unique text. A repeated request with the same key and
            body gets the first answer again, for 24 hours; one that comes while the first is still in
            progress is answered 409 and may be sent again.
        body (StudyRequest): A parametric study: a sweep of one model.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[ProblemDetails | StudyDetail]
    """

    kwargs = _get_kwargs(
        body=body,
        idempotency_key=idempotency_key,
    )

    response = await client.get_async_httpx_client().request(**kwargs)

    return _build_response(client=client, response=response)


async def asyncio(
    *,
    client: AuthenticatedClient | Client,
    body: StudyRequest,
    idempotency_key: str | Unset = UNSET,
) -> ProblemDetails | StudyDetail | None:
    """Create Study

     Accept a study and queue its cases. Cases that any study had before are not computed again.

    Args:
        idempotency_key (str | Unset): Any unique text. A repeated request with the same key and
            body gets the first answer again, for 24 hours; one that comes while the first is still in
            progress is answered 409 and may be sent again.
        body (StudyRequest): A parametric study: a sweep of one model.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        ProblemDetails | StudyDetail
    """

    return (
        await asyncio_detailed(
            client=client,
            body=body,
            idempotency_key=idempotency_key,
        )
    ).parsed
