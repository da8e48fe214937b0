"""Contains all the data models used in inputs/outputs"""

from .band import Band
from .caller_limits import CallerLimits
from .caller_limits_scope import CallerLimitsScope
from .case_counts import CaseCounts
from .case_detail import CaseDetail
from .case_detail_inputs import CaseDetailInputs
from .case_detail_processing_type_0 import CaseDetailProcessingType0
from .case_detail_state import CaseDetailState
from .case_error import CaseError
from .case_page import CasePage
from .case_peak import CasePeak
from .case_peak_list import CasePeakList
from .case_summary import CaseSummary
from .case_summary_state import CaseSummaryState
from .catalogue_value import CatalogueValue
from .catalogue_value_mark import CatalogueValueMark
from .caveat import Caveat
from .caveat_code import CaveatCode
from .changes import Changes
from .compare_study_statistic import CompareStudyStatistic
from .comparison import Comparison
from .confidence_interval import ConfidenceInterval
from .cpu_estimate import CpuEstimate
from .cpu_estimate_basis import CpuEstimateBasis
from .difference import Difference
from .download_history_through import DownloadHistoryThrough
from .estimated_cases import EstimatedCases
from .export_peaks_csv_parameter_item import ExportPeaksCsvParameterItem
from .export_peaks_csv_sort import ExportPeaksCsvSort
from .export_peaks_parquet_parameter_item import ExportPeaksParquetParameterItem
from .export_peaks_parquet_sort import ExportPeaksParquetSort
from .field_problem import FieldProblem
from .field_source import FieldSource
from .field_source_mark import FieldSourceMark
from .finish_estimate import FinishEstimate
from .harmonic_sweep import HarmonicSweep
from .harmonic_wave import HarmonicWave
from .height_density import HeightDensity
from .heights import Heights
from .history_channel import HistoryChannel
from .history_view import HistoryView
from .interval import Interval
from .irregularity_preview import IrregularityPreview
from .joint_overrides import JointOverrides
from .limits import Limits
from .list_cases_sort import ListCasesSort
from .list_cases_state import ListCasesState
from .list_peaks_parameter_item import ListPeaksParameterItem
from .list_peaks_sort import ListPeaksSort
from .list_profiles_sort import ListProfilesSort
from .list_studies_sort import ListStudiesSort
from .list_studies_state import ListStudiesState
from .list_sweep import ListSweep
from .listed_case import ListedCase
from .listed_case_slab import ListedCaseSlab
from .mean_difference import MeanDifference
from .named_set import NamedSet
from .numerics_overrides import NumericsOverrides
from .pairing import Pairing
from .pairing_conditions import PairingConditions
from .parameter_info import ParameterInfo
from .peak_page import PeakPage
from .peak_row import PeakRow
from .peak_row_parameters import PeakRowParameters
from .power_law_spectrum import PowerLawSpectrum
from .power_law_spectrum_per import PowerLawSpectrumPer
from .power_law_spectrum_sides import PowerLawSpectrumSides
from .preset_info import PresetInfo
from .preset_info_study import PresetInfoStudy
from .preset_list import PresetList
from .preview_request import PreviewRequest
from .problem_details import ProblemDetails
from .product_sweep import ProductSweep
from .product_sweep_slab_item import ProductSweepSlabItem
from .profile_info import ProfileInfo
from .profile_page import ProfilePage
from .profile_sweep import ProfileSweep
from .quantiles import Quantiles
from .quantity_info import QuantityInfo
from .quantity_info_peak import QuantityInfoPeak
from .quantity_limit import QuantityLimit
from .quantity_limit_mark import QuantityLimitMark
from .quantity_list import QuantityList
from .queue_info import QueueInfo
from .rational_spectrum import RationalSpectrum
from .rational_spectrum_per import RationalSpectrumPer
from .rational_spectrum_sides import RationalSpectrumSides
from .running_case import RunningCase
from .share import Share
from .share_list import ShareList
from .single_dip import SingleDip
from .smooth_rail import SmoothRail
from .spectrum_info import SpectrumInfo
from .spectrum_info_definition import SpectrumInfoDefinition
from .spectrum_list import SpectrumList
from .spectrum_sample import SpectrumSample
from .spectrum_sample_spectrum_type_0 import SpectrumSampleSpectrumType0
from .spectrum_sweep import SpectrumSweep
from .spectrum_sweep_spectrum_type_0 import SpectrumSweepSpectrumType0
from .spectrum_view import SpectrumView
from .speed_range import SpeedRange
from .statistics import Statistics
from .stored_history import StoredHistory
from .stored_profile import StoredProfile
from .study_detail import StudyDetail
from .study_detail_definition import StudyDetailDefinition
from .study_detail_labels import StudyDetailLabels
from .study_detail_state import StudyDetailState
from .study_estimate import StudyEstimate
from .study_page import StudyPage
from .study_patch import StudyPatch
from .study_patch_labels import StudyPatchLabels
from .study_request import StudyRequest
from .study_request_labels import StudyRequestLabels
from .study_request_sweep_type_0 import StudyRequestSweepType0
from .study_summary import StudySummary
from .study_summary_labels import StudySummaryLabels
from .study_summary_state import StudySummaryState
from .sum_of import SumOf
from .summarise_study_statistic import SummariseStudyStatistic
from .summary import Summary
from .summary_conditions import SummaryConditions
from .table_spectrum import TableSpectrum
from .table_spectrum_per import TableSpectrumPer
from .table_spectrum_sides import TableSpectrumSides
from .throughput import Throughput
from .track_list import TrackList
from .track_overrides import TrackOverrides
from .track_overrides_base import TrackOverridesBase
from .vary import Vary
from .vehicle_list import VehicleList
from .vehicle_overrides import VehicleOverrides
from .vehicle_overrides_base import VehicleOverridesBase
from .vehicle_overrides_wheel_tread import VehicleOverridesWheelTread
from .verification_detail import VerificationDetail
from .verification_detail_differences_type_0 import VerificationDetailDifferencesType0
from .verification_detail_outcome_type_0 import VerificationDetailOutcomeType0
from .verification_detail_state import VerificationDetailState
from .wheel_tread import WheelTread
from .wheel_tread_mark import WheelTreadMark
from .worker_info import WorkerInfo
from .zip_sweep import ZipSweep
from .zip_sweep_slab_item import ZipSweepSlabItem

__all__ = (
    "Band",
    "CallerLimits",
    "CallerLimitsScope",
    "CaseCounts",
    "CaseDetail",
    "CaseDetailInputs",
    "CaseDetailProcessingType0",
    "CaseDetailState",
    "CaseError",
    "CasePage",
    "CasePeak",
    "CasePeakList",
    "CaseSummary",
    "CaseSummaryState",
    "CatalogueValue",
    "CatalogueValueMark",
    "Caveat",
    "CaveatCode",
    "Changes",
    "CompareStudyStatistic",
    "Comparison",
    "ConfidenceInterval",
    "CpuEstimate",
    "CpuEstimateBasis",
    "Difference",
    "DownloadHistoryThrough",
    "EstimatedCases",
    "ExportPeaksCsvParameterItem",
    "ExportPeaksCsvSort",
    "ExportPeaksParquetParameterItem",
    "ExportPeaksParquetSort",
    "FieldProblem",
    "FieldSource",
    "FieldSourceMark",
    "FinishEstimate",
    "HarmonicSweep",
    "HarmonicWave",
    "HeightDensity",
    "Heights",
    "HistoryChannel",
    "HistoryView",
    "Interval",
    "IrregularityPreview",
    "JointOverrides",
    "Limits",
    "ListCasesSort",
    "ListCasesState",
    "ListedCase",
    "ListedCaseSlab",
    "ListPeaksParameterItem",
    "ListPeaksSort",
    "ListProfilesSort",
    "ListStudiesSort",
    "ListStudiesState",
    "ListSweep",
    "MeanDifference",
    "NamedSet",
    "NumericsOverrides",
    "Pairing",
    "PairingConditions",
    "ParameterInfo",
    "PeakPage",
    "PeakRow",
    "PeakRowParameters",
    "PowerLawSpectrum",
    "PowerLawSpectrumPer",
    "PowerLawSpectrumSides",
    "PresetInfo",
    "PresetInfoStudy",
    "PresetList",
    "PreviewRequest",
    "ProblemDetails",
    "ProductSweep",
    "ProductSweepSlabItem",
    "ProfileInfo",
    "ProfilePage",
    "ProfileSweep",
    "Quantiles",
    "QuantityInfo",
    "QuantityInfoPeak",
    "QuantityLimit",
    "QuantityLimitMark",
    "QuantityList",
    "QueueInfo",
    "RationalSpectrum",
    "RationalSpectrumPer",
    "RationalSpectrumSides",
    "RunningCase",
    "Share",
    "ShareList",
    "SingleDip",
    "SmoothRail",
    "SpectrumInfo",
    "SpectrumInfoDefinition",
    "SpectrumList",
    "SpectrumSample",
    "SpectrumSampleSpectrumType0",
    "SpectrumSweep",
    "SpectrumSweepSpectrumType0",
    "SpectrumView",
    "SpeedRange",
    "Statistics",
    "StoredHistory",
    "StoredProfile",
    "StudyDetail",
    "StudyDetailDefinition",
    "StudyDetailLabels",
    "StudyDetailState",
    "StudyEstimate",
    "StudyPage",
    "StudyPatch",
    "StudyPatchLabels",
    "StudyRequest",
    "StudyRequestLabels",
    "StudyRequestSweepType0",
    "StudySummary",
    "StudySummaryLabels",
    "StudySummaryState",
    "SummariseStudyStatistic",
    "Summary",
    "SummaryConditions",
    "SumOf",
    "TableSpectrum",
    "TableSpectrumPer",
    "TableSpectrumSides",
    "Throughput",
    "TrackList",
    "TrackOverrides",
    "TrackOverridesBase",
    "Vary",
    "VehicleList",
    "VehicleOverrides",
    "VehicleOverridesBase",
    "VehicleOverridesWheelTread",
    "VerificationDetail",
    "VerificationDetailDifferencesType0",
    "VerificationDetailOutcomeType0",
    "VerificationDetailState",
    "WheelTread",
    "WheelTreadMark",
    "WorkerInfo",
    "ZipSweep",
    "ZipSweepSlabItem",
)
