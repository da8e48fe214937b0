from http import HTTPStatus
from typing import Any
from urllib.parse import quote

import httpx

from ... import errors
from ...client import AuthenticatedClient, Client
from ...models.problem_details import ProblemDetails
from ...models.study_detail import StudyDetail
from ...models.study_patch import StudyPatch
from ...types import Response


def _get_kwargs(
    study_id: str,
    *,
    body: StudyPatch,
    if_match: str,
) -> dict[str, Any]:
    headers: dict[str, Any] = {}
    headers["If-Match"] = if_match

    _kwargs: dict[str, Any] = {
        "method": "patch",
        "url": "/v1/studies/{study_id}".format(
            study_id=quote(str(study_id), safe=""),
        ),
    }

    _kwargs["json"] = body.to_dict()

    headers["Content-Type"] = "application/json"

    _kwargs["headers"] = headers
    return _kwargs


def _parse_response(
    *, client: AuthenticatedClient | Client, response: httpx.Response
) -> ProblemDetails | StudyDetail | None:
    if response.status_code == 200:
        response_200 = StudyDetail.from_dict(response.json())

        return response_200

    if response.status_code == 400:
        response_400 = ProblemDetails.from_dict(response.json())

        return response_400

    if response.status_code == 401:
        response_401 = ProblemDetails.from_dict(response.json())

        return response_401

    if response.status_code == 403:
        response_403 = ProblemDetails.from_dict(response.json())

        return response_403

    if response.status_code == 404:
        response_404 = ProblemDetails.from_dict(response.json())

        return response_404

    if response.status_code == 412:
        response_412 = ProblemDetails.from_dict(response.json())

        return response_412

    if response.status_code == 413:
        response_413 = ProblemDetails.from_dict(response.json())

        return response_413

    if response.status_code == 415:
        response_415 = ProblemDetails.from_dict(response.json())

        return response_415

    if response.status_code == 422:
        response_422 = ProblemDetails.from_dict(response.json())

        return response_422

    if response.status_code == 428:
        response_428 = ProblemDetails.from_dict(response.json())

        return response_428

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
    study_id: str,
    *,
    client: AuthenticatedClient | Client,
    body: StudyPatch,
    if_match: str,
) -> Response[ProblemDetails | StudyDetail]:
    """Update Study

     Change a study's name, labels or priority. A case of several studies has the highest of their
    priorities.

    Args:
        study_id (str):
        if_match (str): Required: the ETag of the version that is to be changed, or * for any.
            What changes by itself, such as progress, does not count.
        body (StudyPatch): Changes to a study, as a JSON merge patch (RFC 7396): what is left out
            stays, a label of null is removed.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[ProblemDetails | StudyDetail]
    """

    kwargs = _get_kwargs(
        study_id=study_id,
        body=body,
        if_match=if_match,
    )

    response = client.get_httpx_client().request(
        **kwargs,
    )

    return _build_response(client=client, response=response)


def sync(
    study_id: str,
    *,
    client: AuthenticatedClient | Client,
    body: StudyPatch,
    if_match: str,
) -> ProblemDetails | StudyDetail | None:
    """Update Study

     Change a study's name, labels or priority. A case of several studies has the highest of their
    priorities.

    Args:
        study_id (str):
        if_match (str): Required: the ETag of the version that is to be changed, or * for any.
            What changes by itself, such as progress, does not count.
        body (StudyPatch): Changes to a study, as a JSON merge patch (RFC 7396): what is left out
            stays, a label of null is removed.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        ProblemDetails | StudyDetail
    """

    return sync_detailed(
        study_id=study_id,
        client=client,
        body=body,
        if_match=if_match,
    ).parsed


async def asyncio_detailed(
    study_id: str,
    *,
    client: AuthenticatedClient | Client,
    body: StudyPatch,
    if_match: str,
) -> Response[ProblemDetails | StudyDetail]:
    """Update Study

     Change a study's name, labels or priority. A case of several studies has the highest of their
    priorities.

    Args:
        study_id (str):
        if_match (str): Required: the ETag of the version that is to be changed, or * for any.
            What changes by itself, such as progress, does not count.
        body (StudyPatch): Changes to a study, as a JSON merge patch (RFC 7396): what is left out
            stays, a label of null is removed.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[ProblemDetails | StudyDetail]
    """

    kwargs = _get_kwargs(
        study_id=study_id,
        body=body,
        if_match=if_match,
    )

    response = await client.get_async_httpx_client().request(**kwargs)

    return _build_response(client=client, response=response)


async def asyncio(
    study_id: str,
    *,
    client: AuthenticatedClient | Client,
    body: StudyPatch,
    if_match: str,
) -> ProblemDetails | StudyDetail | None:
    """Update Study

     Change a study's name, labels or priority. A case of several studies has the highest of their
    priorities.

    Args:
        study_id (str):
        if_match (str): Required: the ETag of the version that is to be changed, or * for any.
            What changes by itself, such as progress, does not count.
        body (StudyPatch): Changes to a study, as a JSON merge patch (RFC 7396): what is left out
            stays, a label of null is removed.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        ProblemDetails | StudyDetail
    """

    return (
        await asyncio_detailed(
            study_id=study_id,
            client=client,
            body=body,
            if_match=if_match,
        )
    ).parsed
