// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRidgesArrayNames.h
 * Names of the arrays by which the filters of this module speak to each other and to users. Their
 * meaning, components and units stand in Filters/Documentation/Arrays.md.
 */
#ifndef vtkRidgesArrayNames_h
#define vtkRidgesArrayNames_h

namespace vtkRidgesArrayNames
{
/// @name Mesh, point data, of vtkJetFitting
///@{
constexpr const char* MaximumCurvature = "MaximumCurvature";
constexpr const char* MinimumCurvature = "MinimumCurvature";
constexpr const char* MaximumDirection = "MaximumDirection";
constexpr const char* MinimumDirection = "MinimumDirection";
constexpr const char* Normals = "Normals";
constexpr const char* ThirdOrder = "ThirdOrder";
constexpr const char* FourthOrder = "FourthOrder";
constexpr const char* P1 = "P1";
constexpr const char* P2 = "P2";
constexpr const char* FitStatus = "FitStatus";
constexpr const char* FitConditionNumber = "FitConditionNumber";
constexpr const char* FitResidual = "FitResidual";
constexpr const char* FitScale = "FitScale";
constexpr const char* FitNoiseGain = "FitNoiseGain";
constexpr const char* MaximumCurvatureError = "MaximumCurvatureError";
constexpr const char* MinimumCurvatureError = "MinimumCurvatureError";
constexpr const char* ThirdOrderError = "ThirdOrderError";
constexpr const char* P1Error = "P1Error";
constexpr const char* P2Error = "P2Error";
///@}

/**
 * The Monge arrays in the order of the indices by which SetInputArrayToProcess of a filter chooses
 * others: index 0 is MaximumCurvature, and so on.
 */
constexpr const char* MongeInputs[] = { MaximumCurvature, MinimumCurvature, MaximumDirection,
  MinimumDirection, ThirdOrder, FourthOrder, P1, P2, FitStatus, MaximumCurvatureError,
  MinimumCurvatureError, ThirdOrderError, FitResidual, FitScale, FitNoiseGain };

/// @name Mesh, field data, of vtkJetFitting
///@{
constexpr const char* SelectedDegree = "SelectedDegree";
constexpr const char* SelectedNumberOfRings = "SelectedNumberOfRings";
constexpr const char* SelectedNumberOfAverages = "SelectedNumberOfAverages";
constexpr const char* EstimatedNoise = "EstimatedNoise";
constexpr const char* NoiseCorrelation = "NoiseCorrelation";
constexpr const char* SelectedFit = "SelectedFit";
///@}

/// @name Pieces of a mesh, points and cells, of vtkPRidgesAndUmbilics
///@{
constexpr const char* GatheredPointId = "GatheredPointId";
constexpr const char* GatheredCellId = "GatheredCellId";
///@}

/// @name Mesh, field data, of vtkImageMongeForm
///@{
constexpr const char* ImageNoise = "ImageNoise";
constexpr const char* ImageSigma = "ImageSigma";
///@}

/// @name Mesh, field data, of vtkImplicitSurfaceMesh
///@{
constexpr const char* Formula = "Formula";
///@}

/// @name Mesh, cell data, of vtkUmbilicDetection
///@{
constexpr const char* UmbilicPatch = "UmbilicPatch";
constexpr const char* CancelledUmbilics = "CancelledUmbilics";
constexpr const char* UmbilicZone = "UmbilicZone";
///@}

/// @name Mesh, field data, of vtkUmbilicDetection
///@{
constexpr const char* UmbilicPosition = "UmbilicPosition";
constexpr const char* UmbilicIndex = "UmbilicIndex";
constexpr const char* UmbilicRidgeCount = "UmbilicRidgeCount";
constexpr const char* UmbilicTriangle = "UmbilicTriangle";
constexpr const char* UmbilicIndexSum = "UmbilicIndexSum";
constexpr const char* EulerCharacteristic = "EulerCharacteristic";
constexpr const char* NumberOfCancelledRegions = "NumberOfCancelledRegions";
constexpr const char* NumberOfUmbilicZones = "NumberOfUmbilicZones";
///@}

/// @name Mesh, cell data and field data, of vtkRidgeExtraction
///@{
constexpr const char* RidgeZone = "RidgeZone";
constexpr const char* NumberOfRidgeZones = "NumberOfRidgeZones";
///@}

/// @name Umbilics, point data
///@{
constexpr const char* UmbilicId = "UmbilicId";
constexpr const char* Index = "Index";
constexpr const char* RidgeCount = "RidgeCount";
constexpr const char* ThirdOrderIndex = "ThirdOrderIndex";
constexpr const char* Triangle = "Triangle";
constexpr const char* Pattern = "Pattern";
constexpr const char* TouchesBorder = "TouchesBorder";
constexpr const char* NearBorder = "NearBorder"; ///< Of ridges, too.
///@}

/// @name Mesh and its edges, cell data, of vtkCompliantRefinement and vtkCertifiedRidges
///@{
constexpr const char* Certificate = "Certificate";
constexpr const char* FailedHypotheses = "FailedHypotheses";
constexpr const char* MaximumCrossings = "MaximumCrossings";
constexpr const char* MinimumCrossings = "MinimumCrossings";
///@}

/// @name Ridges, cell data
///@{
constexpr const char* RidgeType = "RidgeType";
constexpr const char* Crest = "Crest";
constexpr const char* Sharpness = "Sharpness";
constexpr const char* Confidence = "Confidence";
constexpr const char* Strength = "Strength";
constexpr const char* Length = "Length";
constexpr const char* RidgeId = "RidgeId";
constexpr const char* Closed = "Closed";
///@}

/// @name Ridges, of vtkSalientRidges, with Confidence: cell data, point data, both or, the last,
/// field data
///@{
constexpr const char* FoldMass = "FoldMass";
constexpr const char* FoldAngle = "FoldAngle";
constexpr const char* FoldWidth = "FoldWidth";
constexpr const char* ArcLength = "ArcLength";
constexpr const char* NoiseFloor = "NoiseFloor";
///@}

/// @name Purple points, point data
///@{
constexpr const char* MaximumRidgeId = "MaximumRidgeId";
constexpr const char* MinimumRidgeId = "MinimumRidgeId";
///@}

/// @name Ridges, point data
///@{
constexpr const char* Curvature = "Curvature";
constexpr const char* SecondDerivative = "SecondDerivative";
constexpr const char* Umbilic = "Umbilic";
constexpr const char* TurningPoint = "TurningPoint";
constexpr const char* EdgePoint0 = "EdgePoint0";
constexpr const char* EdgePoint1 = "EdgePoint1";
constexpr const char* EdgeParameter = "EdgeParameter";
///@}

/// @name Table of vtkRidgeCoherence
///@{
constexpr const char* Check = "Check";
constexpr const char* Section = "Section";
constexpr const char* Expected = "Expected";
constexpr const char* Found = "Found";
constexpr const char* Applies = "Applies";
constexpr const char* Passed = "Passed";
constexpr const char* Severity = "Severity";
constexpr const char* NumberOfOffenders = "NumberOfOffenders";
constexpr const char* OffenderKind = "OffenderKind";
constexpr const char* Offenders = "Offenders";
constexpr const char* OffenderPosition = "OffenderPosition";
constexpr const char* Verdict = "Verdict";
///@}

/// @name Curvature lines, cell data, besides Closed and Length; point data is Curvature
///@{
constexpr const char* PrincipalDirection = "PrincipalDirection";
///@}
}

#endif
// VTK-HeaderTest-Exclude: vtkRidgesArrayNames.h
