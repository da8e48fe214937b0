from http import HTTPStatus
from io import BytesIO
from typing import Any

import httpx

from ... import errors
from ...client import AuthenticatedClient, Client
from ...models.export_peaks_csv_parameter_item import (
    ExportPeaksCsvParameterItem,
)
from ...models.export_peaks_csv_sort import (
    ExportPeaksCsvSort,
)
from ...models.problem_details import ProblemDetails
from ...types import UNSET, File, Response, Unset


def _get_kwargs(
    *,
    study_id: str | Unset = UNSET,
    quantity: str | Unset = UNSET,
    position: str | Unset = UNSET,
    slab: str | Unset = UNSET,
    irregularity: str | Unset = UNSET,
    spectrum: str | Unset = UNSET,
    speed_kmh_min: float | Unset = UNSET,
    speed_kmh_max: float | Unset = UNSET,
    percentile: float | Unset = UNSET,
    wavelength_min_m: float | Unset = UNSET,
    wavelength_max_m: float | Unset = UNSET,
    wavelength_m: float | Unset = UNSET,
    value_min: float | Unset = UNSET,
    value_max: float | Unset = UNSET,
    parameter: list[ExportPeaksCsvParameterItem] | Unset = UNSET,
    sort: ExportPeaksCsvSort | Unset = "case_id",
) -> dict[str, Any]:

    params: dict[str, Any] = {}

    params["study_id"] = study_id

    params["quantity"] = quantity

    params["position"] = position

    params["slab"] = slab

    params["irregularity"] = irregularity

    params["spectrum"] = spectrum

    params["speed_kmh_min"] = speed_kmh_min

    params["speed_kmh_max"] = speed_kmh_max

    params["percentile"] = percentile

    params["wavelength_min_m"] = wavelength_min_m

    params["wavelength_max_m"] = wavelength_max_m

    params["wavelength_m"] = wavelength_m

    params["value_min"] = value_min

    params["value_max"] = value_max

    json_parameter: list[str] | Unset = UNSET
    if not isinstance(parameter, Unset):
        json_parameter = []
        for parameter_item_data in parameter:
            parameter_item: str = parameter_item_data
            json_parameter.append(parameter_item)

    params["parameter"] = json_parameter

    json_sort: str | Unset = UNSET
    if not isinstance(sort, Unset):
        json_sort = sort

    params["sort"] = json_sort

    params = {k: v for k, v in params.items() if v is not UNSET and v is not None}

    _kwargs: dict[str, Any] = {
        "method": "get",
        "url": "/v1/peaks.csv",
        "params": params,
    }

    return _kwargs


def _parse_response(*, client: AuthenticatedClient | Client, response: httpx.Response) -> File | ProblemDetails | None:
    if response.status_code == 200:
        response_200 = File(payload=BytesIO(response.content))

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
) -> Response[File | ProblemDetails]:
    return Response(
        status_code=HTTPStatus(response.status_code),
        content=response.content,
        headers=response.headers,
        parsed=_parse_response(client=client, response=response),
    )


def sync_detailed(
    *,
    client: AuthenticatedClient | Client,
    study_id: str | Unset = UNSET,
    quantity: str | Unset = UNSET,
    position: str | Unset = UNSET,
    slab: str | Unset = UNSET,
    irregularity: str | Unset = UNSET,
    spectrum: str | Unset = UNSET,
    speed_kmh_min: float | Unset = UNSET,
    speed_kmh_max: float | Unset = UNSET,
    percentile: float | Unset = UNSET,
    wavelength_min_m: float | Unset = UNSET,
    wavelength_max_m: float | Unset = UNSET,
    wavelength_m: float | Unset = UNSET,
    value_min: float | Unset = UNSET,
    value_max: float | Unset = UNSET,
    parameter: list[ExportPeaksCsvParameterItem] | Unset = UNSET,
    sort: ExportPeaksCsvSort | Unset = "case_id",
) -> Response[File | ProblemDetails]:
    """Export Peaks Csv

     Export peaks as CSV, with the unit of each, its case's digest and the version of the solver.

    Args:
        study_id (str | Unset):
        quantity (str | Unset):
        position (str | Unset):
        slab (str | Unset):
        irregularity (str | Unset):
        spectrum (str | Unset):
        speed_kmh_min (float | Unset):
        speed_kmh_max (float | Unset):
        percentile (float | Unset):
        wavelength_min_m (float | Unset): Shortest wavelength of the band.
        wavelength_max_m (float | Unset): Longest wavelength of the band.
        wavelength_m (float | Unset): Wavelength of a harmonic irregularity.
        value_min (float | Unset): Only peaks of at least this, in the quantity's unit.
        value_max (float | Unset): Only peaks of at most this, in the quantity's unit.
        parameter (list[ExportPeaksCsvParameterItem] | Unset): Parameters of track, vehicle and
            numerics to tell of each peak's case, by their paths in a study; may be repeated. If none
            is given and a study is, those that the study varies.
        sort (ExportPeaksCsvSort | Unset): A column; with a minus sign, from large to small.
            Default: 'case_id'.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[File | ProblemDetails]
    """

    kwargs = _get_kwargs(
        study_id=study_id,
        quantity=quantity,
        position=position,
        slab=slab,
        irregularity=irregularity,
        spectrum=spectrum,
        speed_kmh_min=speed_kmh_min,
        speed_kmh_max=speed_kmh_max,
        percentile=percentile,
        wavelength_min_m=wavelength_min_m,
        wavelength_max_m=wavelength_max_m,
        wavelength_m=wavelength_m,
        value_min=value_min,
        value_max=value_max,
        parameter=parameter,
        sort=sort,
    )

    response = client.get_httpx_client().request(
        **kwargs,
    )

    return _build_response(client=client, response=response)


def sync(
    *,
    client: AuthenticatedClient | Client,
    study_id: str | Unset = UNSET,
    quantity: str | Unset = UNSET,
    position: str | Unset = UNSET,
    slab: str | Unset = UNSET,
    irregularity: str | Unset = UNSET,
    spectrum: str | Unset = UNSET,
    speed_kmh_min: float | Unset = UNSET,
    speed_kmh_max: float | Unset = UNSET,
    percentile: float | Unset = UNSET,
    wavelength_min_m: float | Unset = UNSET,
    wavelength_max_m: float | Unset = UNSET,
    wavelength_m: float | Unset = UNSET,
    value_min: float | Unset = UNSET,
    value_max: float | Unset = UNSET,
    parameter: list[ExportPeaksCsvParameterItem] | Unset = UNSET,
    sort: ExportPeaksCsvSort | Unset = "case_id",
) -> File | ProblemDetails | None:
    """Export Peaks Csv

     Export peaks as CSV, with the unit of each, its case's digest and the version of the solver.

    Args:
        study_id (str | Unset):
        quantity (str | Unset):
        position (str | Unset):
        slab (str | Unset):
        irregularity (str | Unset):
        spectrum (str | Unset):
        speed_kmh_min (float | Unset):
        speed_kmh_max (float | Unset):
        percentile (float | Unset):
        wavelength_min_m (float | Unset): Shortest wavelength of the band.
        wavelength_max_m (float | Unset): Longest wavelength of the band.
        wavelength_m (float | Unset): Wavelength of a harmonic irregularity.
        value_min (float | Unset): Only peaks of at least this, in the quantity's unit.
        value_max (float | Unset): Only peaks of at most this, in the quantity's unit.
        parameter (list[ExportPeaksCsvParameterItem] | Unset): Parameters of track, vehicle and
            numerics to tell of each peak's case, by their paths in a study; may be repeated. If none
            is given and a study is, those that the study varies.
        sort (ExportPeaksCsvSort | Unset): A column; with a minus sign, from large to small.
            Default: 'case_id'.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        File | ProblemDetails
    """

    return sync_detailed(
        client=client,
        study_id=study_id,
        quantity=quantity,
        position=position,
        slab=slab,
        irregularity=irregularity,
        spectrum=spectrum,
        speed_kmh_min=speed_kmh_min,
        speed_kmh_max=speed_kmh_max,
        percentile=percentile,
        wavelength_min_m=wavelength_min_m,
        wavelength_max_m=wavelength_max_m,
        wavelength_m=wavelength_m,
        value_min=value_min,
        value_max=value_max,
        parameter=parameter,
        sort=sort,
    ).parsed


async def asyncio_detailed(
    *,
    client: AuthenticatedClient | Client,
    study_id: str | Unset = UNSET,
    quantity: str | Unset = UNSET,
    position: str | Unset = UNSET,
    slab: str | Unset = UNSET,
    irregularity: str | Unset = UNSET,
    spectrum: str | Unset = UNSET,
    speed_kmh_min: float | Unset = UNSET,
    speed_kmh_max: float | Unset = UNSET,
    percentile: float | Unset = UNSET,
    wavelength_min_m: float | Unset = UNSET,
    wavelength_max_m: float | Unset = UNSET,
    wavelength_m: float | Unset = UNSET,
    value_min: float | Unset = UNSET,
    value_max: float | Unset = UNSET,
    parameter: list[ExportPeaksCsvParameterItem] | Unset = UNSET,
    sort: ExportPeaksCsvSort | Unset = "case_id",
) -> Response[File | ProblemDetails]:
    """Export Peaks Csv

     Export peaks as CSV, with the unit of each, its case's digest and the version of the solver.

    Args:
        study_id (str | Unset):
        quantity (str | Unset):
        position (str | Unset):
        slab (str | Unset):
        irregularity (str | Unset):
        spectrum (str | Unset):
        speed_kmh_min (float | Unset):
        speed_kmh_max (float | Unset):
        percentile (float | Unset):
        wavelength_min_m (float | Unset): Shortest wavelength of the band.
        wavelength_max_m (float | Unset): Longest wavelength of the band.
        wavelength_m (float | Unset): Wavelength of a harmonic irregularity.
        value_min (float | Unset): Only peaks of at least this, in the quantity's unit.
        value_max (float | Unset): Only peaks of at most this, in the quantity's unit.
        parameter (list[ExportPeaksCsvParameterItem] | Unset): Parameters of track, vehicle and
            numerics to tell of each peak's case, by their paths in a study; may be repeated. If none
            is given and a study is, those that the study varies.
        sort (ExportPeaksCsvSort | Unset): A column; with a minus sign, from large to small.
            Default: 'case_id'.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[File | ProblemDetails]
    """

    kwargs = _get_kwargs(
        study_id=study_id,
        quantity=quantity,
        position=position,
        slab=slab,
        irregularity=irregularity,
        spectrum=spectrum,
        speed_kmh_min=speed_kmh_min,
        speed_kmh_max=speed_kmh_max,
        percentile=percentile,
        wavelength_min_m=wavelength_min_m,
        wavelength_max_m=wavelength_max_m,
        wavelength_m=wavelength_m,
        value_min=value_min,
        value_max=value_max,
        parameter=parameter,
        sort=sort,
    )

    response = await client.get_async_httpx_client().request(**kwargs)

    return _build_response(client=client, response=response)


async def asyncio(
    *,
    client: AuthenticatedClient | Client,
    study_id: str | Unset = UNSET,
    quantity: str | Unset = UNSET,
    position: str | Unset = UNSET,
    slab: str | Unset = UNSET,
    irregularity: str | Unset = UNSET,
    spectrum: str | Unset = UNSET,
    speed_kmh_min: float | Unset = UNSET,
    speed_kmh_max: float | Unset = UNSET,
    percentile: float | Unset = UNSET,
    wavelength_min_m: float | Unset = UNSET,
    wavelength_max_m: float | Unset = UNSET,
    wavelength_m: float | Unset = UNSET,
    value_min: float | Unset = UNSET,
    value_max: float | Unset = UNSET,
    parameter: list[ExportPeaksCsvParameterItem] | Unset = UNSET,
    sort: ExportPeaksCsvSort | Unset = "case_id",
) -> File | ProblemDetails | None:
    """Export Peaks Csv

     Export peaks as CSV, with the unit of each, its case's digest and the version of the solver.

    Args:
        study_id (str | Unset):
        quantity (str | Unset):
        position (str | Unset):
        slab (str | Unset):
        irregularity (str | Unset):
        spectrum (str | Unset):
        speed_kmh_min (float | Unset):
        speed_kmh_max (float | Unset):
        percentile (float | Unset):
        wavelength_min_m (float | Unset): Shortest wavelength of the band.
        wavelength_max_m (float | Unset): Longest wavelength of the band.
        wavelength_m (float | Unset): Wavelength of a harmonic irregularity.
        value_min (float | Unset): Only peaks of at least this, in the quantity's unit.
        value_max (float | Unset): Only peaks of at most this, in the quantity's unit.
        parameter (list[ExportPeaksCsvParameterItem] | Unset): Parameters of track, vehicle and
            numerics to tell of each peak's case, by their paths in a study; may be repeated. If none
            is given and a study is, those that the study varies.
        sort (ExportPeaksCsvSort | Unset): A column; with a minus sign, from large to small.
            Default: 'case_id'.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        File | ProblemDetails
    """

    return (
        await asyncio_detailed(
            client=client,
            study_id=study_id,
            quantity=quantity,
            position=position,
            slab=slab,
            irregularity=irregularity,
            spectrum=spectrum,
            speed_kmh_min=speed_kmh_min,
            speed_kmh_max=speed_kmh_max,
            percentile=percentile,
            wavelength_min_m=wavelength_min_m,
            wavelength_max_m=wavelength_max_m,
            wavelength_m=wavelength_m,
            value_min=value_min,
            value_max=value_max,
            parameter=parameter,
            sort=sort,
        )
    ).parsed
