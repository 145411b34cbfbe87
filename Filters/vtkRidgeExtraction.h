// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRidgeExtraction
 * @brief   extract the ridges (crest lines) of a mesh with Monge arrays
 *
 * On a blue ridge the maximum curvature k1 has an extremum along its own curvature line, on a red
 * ridge the minimum curvature k2 has one; maxima of k1 and minima of k2 are elliptic ridges, the
 * others hyperbolic. Method: RR-5294, sections 5 and 6. A ridge crosses an edge if b0 (blue) or b3
 * (red) changes sign along it, with the principal directions at its ends turned to an acute angle.
 * Crossings are joined inside triangles, and at umbilics according to UmbilicJoining
 * (Documentation/Theory.md).
 *
 * Input: a mesh with the arrays of vtkJetFitting (FourthOrder, or else P1 and P2, for the
 * fourth-order type rule only) and, if wanted, the marks of vtkUmbilicDetection. Triangles of
 * points with an invalid FitStatus are left out. Other array names: see Documentation/Arrays.md.
 *
 * Output port 0: a polyline per run of one type of a ridge. Consecutive ones of one ridge share
 * their end point and RidgeId. Arrays: on cells RidgeType (see RidgeTypes), Crest, Closed, RidgeId,
 * NearBorder, Length, Strength and, of fourth order, Sharpness and Confidence; on points Curvature,
 * SecondDerivative (fourth order), Umbilic, TurningPoint, EdgePoint0, EdgePoint1 and EdgeParameter.
 * ComputeFoldAngle adds FoldAngle (points, cells), FoldWidth (points) and NoiseFloor (field data).
 *
 * Output port 1, if FindPurplePoints is on: a vertex per purple point, with the point arrays
 * MaximumRidgeId and MinimumRidgeId of the ridges that cross there, and Triangle, the mesh's cell.
 * Output port 2: the mesh. Its cell array RidgeZone has, for maximum and minimum ridges, the region
 * in which they were left out, or -1 (see ZoneSignificance); NumberOfRidgeZones is on port 0, too.
 *
 * Guarantees, on any mesh: ridges of one colour end only at umbilics and other singular triangles,
 * on borders, at non-manifold edges and at triangles left out. The numbering changes nothing.
 * @sa vtkJetFitting vtkUmbilicDetection vtkRidgeSharpnessFilter
 */
#ifndef vtkRidgeExtraction_h
#define vtkRidgeExtraction_h

#include "vtkFiltersRidgesModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkRidgesCompatibility.h" // For the ABI namespace
#include "vtkRidgesRanks.h"

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSRIDGES_EXPORT vtkRidgeExtraction : public vtkPolyDataAlgorithm
{
public:
  static vtkRidgeExtraction* New();
  vtkTypeMacro(vtkRidgeExtraction, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Values of the RidgeType array.
  enum RidgeTypes
  {
    UNDECIDED = 0,
    MAXIMUM_ELLIPTIC = 1,   ///< blue
    MAXIMUM_HYPERBOLIC = 2, ///< green
    MINIMUM_ELLIPTIC = 3,   ///< red
    MINIMUM_HYPERBOLIC = 4  ///< yellow
  };
  /// See SetTypeRule, SetExtremalityRule, SetCrossingRule and SetUmbilicJoining.
  enum TypeRules
  {
    FOURTH_ORDER = 0,
    THIRD_ORDER = 1
  };
  enum ExtremalityRules
  {
    PRINCIPAL = 0,
    GAUSSIAN = 1
  };
  enum CrossingRules
  {
    FORM = 0,
    LINEAR = 1
  };
  enum UmbilicJoinings
  {
    PATCHES = 0,
    TRIANGLES = 1
  };

  ///@{
  /**
   * Whether to extract ridges of the maximum curvature (blue and green) and of the minimum
   * curvature (red and yellow), default on; only crest lines, the visually salient part of elliptic
   * ridges, default off; on port 1 the points where blue ridges cross red ones, and by how much the
   * surface folds across elliptic ridges (Documentation/Theory.md), default off: few need them.
   */
  vtkSetMacro(ExtractMaximum, bool);
  vtkGetMacro(ExtractMaximum, bool);
  vtkBooleanMacro(ExtractMaximum, bool);
  vtkSetMacro(ExtractMinimum, bool);
  vtkGetMacro(ExtractMinimum, bool);
  vtkBooleanMacro(ExtractMinimum, bool);
  vtkSetMacro(CrestOnly, bool);
  vtkGetMacro(CrestOnly, bool);
  vtkBooleanMacro(CrestOnly, bool);
  vtkSetMacro(FindPurplePoints, bool);
  vtkGetMacro(FindPurplePoints, bool);
  vtkBooleanMacro(FindPurplePoints, bool);
  vtkSetMacro(ComputeFoldAngle, bool);
  vtkGetMacro(ComputeFoldAngle, bool);
  vtkBooleanMacro(ComputeFoldAngle, bool);
  ///@}

  ///@{
  /**
   * How a ridge is classified as elliptic or hyperbolic: by the sign of P (FOURTH_ORDER, equation
   * 3) or by whether the curvature rises towards it (THIRD_ORDER, section 5.3). Default
   * FOURTH_ORDER: the other fails where an edge is almost parallel to the ridge.
   * ExtremalityRule defines a crossing: a change of sign of b0 or b3, each colour by itself
   * (PRINCIPAL), or, for comparison, of the Gaussian extremality b0 b3 (GAUSSIAN, section 5.2.3),
   * whose curves change colour and ignore umbilics, ExtractMaximum and ExtractMinimum. Default
   * PRINCIPAL: it keeps ridges connected. CrossingRule places a crossing on its edge: at the zero
   * of the interpolated Monge form (FORM), or by equation (4) from the values at its ends (LINEAR).
   * Default FORM: LINEAR zigzags by a third of an edge near umbilics. UmbilicJoining joins ridges
   * to umbilics in patches (PATCHES, section 6.3) or in all singular triangles (TRIANGLES, section
   * 6.2). Default PATCHES: triangles near umbilics are unreliable.
   */
  vtkSetClampMacro(TypeRule, int, FOURTH_ORDER, THIRD_ORDER);
  vtkGetMacro(TypeRule, int);
  void SetTypeRuleToFourthOrder() { this->SetTypeRule(FOURTH_ORDER); }
  void SetTypeRuleToThirdOrder() { this->SetTypeRule(THIRD_ORDER); }
  vtkSetClampMacro(ExtremalityRule, int, PRINCIPAL, GAUSSIAN);
  vtkGetMacro(ExtremalityRule, int);
  void SetExtremalityRuleToPrincipal() { this->SetExtremalityRule(PRINCIPAL); }
  void SetExtremalityRuleToGaussian() { this->SetExtremalityRule(GAUSSIAN); }
  vtkSetClampMacro(CrossingRule, int, FORM, LINEAR);
  vtkGetMacro(CrossingRule, int);
  void SetCrossingRuleToForm() { this->SetCrossingRule(FORM); }
  void SetCrossingRuleToLinear() { this->SetCrossingRule(LINEAR); }
  vtkSetClampMacro(UmbilicJoining, int, PATCHES, TRIANGLES);
  vtkGetMacro(UmbilicJoining, int);
  void SetUmbilicJoiningToPatches() { this->SetUmbilicJoining(PATCHES); }
  void SetUmbilicJoiningToTriangles() { this->SetUmbilicJoining(TRIANGLES); }
  ///@}

  ///@{
  /**
   * What noise may have caused. LoopSignificance: loops around at most 64 points, at all of which
   * b0 (b3) is within this many standard errors of 0, are left out; ZoneSignificance: so are ridges
   * in regions where b0 (b3) is nowhere larger, except up to twice as large by chance (RidgeZone).
   * Both 0 to 100, default 3, which chance and surfaces without ridges rarely exceed; 0 keeps all.
   * TypeSignificance: runs of one type over which P is within this many standard errors of 0 become
   * the type on both sides; 0 to 100, default 1, which leaves as many runs as are true.
   * TypeHysteresis: so do runs shorter than this many mean edges; 0 to 1000, default 0.
   */
  vtkSetClampMacro(LoopSignificance, double, 0.0, 100.0);
  vtkGetMacro(LoopSignificance, double);
  vtkSetClampMacro(ZoneSignificance, double, 0.0, 100.0);
  vtkGetMacro(ZoneSignificance, double);
  vtkSetClampMacro(TypeSignificance, double, 0.0, 100.0);
  vtkGetMacro(TypeSignificance, double);
  vtkSetClampMacro(TypeHysteresis, double, 0.0, 1000.0);
  vtkGetMacro(TypeHysteresis, double);
  ///@}

  ///@{
  /**
   * The length that makes sharpness dimensionless, 0 or more; default 0: the radius of the smallest
   * enclosing sphere. Within UmbilicCutOff of these, 0 to 1, of an umbilic hyperbolic ridges add
   * nothing to their sharpness, which would be infinite; default 0.01.
   */
  vtkSetClampMacro(ModelSize, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ModelSize, double);
  vtkSetClampMacro(UmbilicCutOff, double, 0.0, 1.0);
  vtkGetMacro(UmbilicCutOff, double);
  ///@}

protected:
  vtkRidgeExtraction();
  ~vtkRidgeExtraction() override = default;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// What is known of the larger mesh that the input is a part of; null: it is all there is.
  virtual const ridges::MeshPart* GetPart() { return nullptr; }
  bool ExtractMaximum = true;
  bool ExtractMinimum = true;
  bool CrestOnly = false;
  int TypeRule = FOURTH_ORDER;
  int ExtremalityRule = PRINCIPAL;
  int CrossingRule = FORM;
  int UmbilicJoining = PATCHES;
  double LoopSignificance = 3.0;
  double ZoneSignificance = 3.0;
  double TypeSignificance = 1.0;
  double TypeHysteresis = 0.0;
  bool FindPurplePoints = false;
  bool ComputeFoldAngle = false;
  double ModelSize = 0.0;
  double UmbilicCutOff = 0.01;

private:
  vtkRidgeExtraction(const vtkRidgeExtraction&) = delete;
  void operator=(const vtkRidgeExtraction&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
