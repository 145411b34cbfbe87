// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRidgeExtraction
 * @brief   extract the ridges (crest lines) of a mesh that carries Monge arrays
 *
 * A blue ridge is a curve along which the maximum principal curvature k1 has an extremum along its
 * own curvature line, a red ridge one of the minimum k2. Elliptic ridges are maxima of k1 or minima
 * of k2, hyperbolic ones the other extrema.
 *
 * Method: RR-5294, sections 5 and 6. The principal directions at the ends of each edge are brought
 * to an acute angle; where b0 (blue) or b3 (red) then changes its sign a ridge crosses the edge.
 * Crossings are joined inside triangles. In a singular triangle, where the acute rule is not
 * coherent and an umbilic lies, one or three of them are joined to it; in the patches and regions
 * that vtkUmbilicDetection marks crossings of the contour are joined instead, where that differs.
 *
 * Input: a mesh with the point arrays MaximumCurvature, MinimumCurvature, MaximumDirection,
 * MinimumDirection and ThirdOrder of vtkJetFitting, and, needed by the fourth-order type rule only,
 * FourthOrder or else P1 and P2; with FourthOrder types are more reliable near umbilics. FitStatus,
 * if there, tells invalid points, whose triangles are left out. The umbilics that
 * vtkUmbilicDetection marks on the mesh are used if they are there.
 *
 * Output port 0: a polyline per run of one type of a ridge. Consecutive polylines of one ridge
 * share their end point and RidgeId.
 *
 * | array            | on     | meaning                                                  | unit  |
 * |------------------|--------|----------------------------------------------------------|-------|
 * | RidgeType        | cells  | 1 max elliptic (blue), 2 max hyperbolic (green),         |       |
 * |                  |        | 3 min elliptic (red), 4 min hyperbolic (yellow), 0 none  |       |
 * | Crest            | cells  | 1: elliptic, and the ridge's curvature is the larger of  |       |
 * |                  |        | the two in absolute value (section 7.2)                  |       |
 * | Sharpness        | cells  | integral of abs(k'') times the squared model size        |       |
 * | Strength         | cells  | integral of abs(k)                                       |       |
 * | Length           | cells  | length of the polyline                                   | L     |
 * | RidgeId          | cells  | the whole ridge, across its turning points               |       |
 * | Closed           | cells  | 1: that ridge is a loop                                  |       |
 * | Curvature        | points | k1 (blue) or k2 (red)                                    | 1/L   |
 * | SecondDerivative | points | k'' = P / (k1 - k2), P2 / (k2 - k1) for red; 0 at an     | 1/L^3 |
 * |                  |        | umbilic, where it is infinite                            |       |
 * | Umbilic          | points | id of the umbilic that the point is, or -1               |       |
 * | TurningPoint     | points | 1 where the type changes between elliptic and hyperbolic |       |
 * | EdgePoint0/1     | points | ends of the mesh edge crossed, smaller id first; -1 on   |       |
 * |                  |        | no edge: at umbilics and turning points inside triangles |       |
 * | EdgeParameter    | points | fraction of the way from EdgePoint0 to EdgePoint1        |       |
 *
 * Sharpness and SecondDerivative are left out where the fourth order is missing.
 *
 * Output port 1, if FindPurplePoints is on: a vertex per purple point, with the point arrays
 * MaximumRidgeId and MinimumRidgeId, the RidgeId of the two ridges that cross there, and Triangle,
 * the cell of the mesh.
 *
 * Guarantees, on any mesh and with any values: ridges of one colour end only at umbilics and other
 * singular triangles, on borders, at non-manifold edges and at triangles left out. With
 * UmbilicJoining TRIANGLES and LoopSignificance 0 every crossing is in exactly one ridge. Order,
 * starts and senses of the ridges depend on positions only, not on the numbering.
 *
 * @warning
 * The sharpness of a hyperbolic ridge that ends at an umbilic is infinite, so that the arc within
 * UmbilicCutOff of an umbilic is left out of it; length and strength are of the whole.
 *
 * @sa
 * vtkJetFitting vtkUmbilicDetection vtkRidgeSharpnessFilter
 */

#ifndef vtkRidgeExtraction_h
#define vtkRidgeExtraction_h

#include "vtkFiltersRidgesModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

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
    MAXIMUM_ELLIPTIC = 1,
    MAXIMUM_HYPERBOLIC = 2,
    MINIMUM_ELLIPTIC = 3,
    MINIMUM_HYPERBOLIC = 4
  };

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
   * Whether to extract ridges of the maximum curvature (blue and green). Default on.
   */
  vtkSetMacro(ExtractMaximum, bool);
  vtkGetMacro(ExtractMaximum, bool);
  vtkBooleanMacro(ExtractMaximum, bool);
  ///@}

  ///@{
  /**
   * Whether to extract ridges of the minimum curvature (red and yellow). Default on.
   */
  vtkSetMacro(ExtractMinimum, bool);
  vtkGetMacro(ExtractMinimum, bool);
  vtkBooleanMacro(ExtractMinimum, bool);
  ///@}

  ///@{
  /**
   * Whether to keep crest lines only, the visually salient part of the elliptic ridges. Default
   * off: the whole picture has all ridges.
   */
  vtkSetMacro(CrestOnly, bool);
  vtkGetMacro(CrestOnly, bool);
  vtkBooleanMacro(CrestOnly, bool);
  ///@}

  ///@{
  /**
   * How a ridge is found to be elliptic or hyperbolic: by the sign of P at the crossings (fourth
   * order, equation 3) or by whether the curvature rises towards the ridge (third order, section
   * 5.3). Default fourth order: it is consistent along a ridge, while the third-order rule errs
   * where an edge is almost parallel to the ridge.
   */
  vtkSetClampMacro(TypeRule, int, FOURTH_ORDER, THIRD_ORDER);
  vtkGetMacro(TypeRule, int);
  void SetTypeRuleToFourthOrder() { this->SetTypeRule(FOURTH_ORDER); }
  void SetTypeRuleToThirdOrder() { this->SetTypeRule(THIRD_ORDER); }
  ///@}

  ///@{
  /**
   * What is taken for a ridge: a change of sign of b0 or b3 by the acute rule, colour by colour, or
   * one of the Gaussian extremality b0 b3 (sections 4.2.2 and 5.2.3). Default the former. The
   * latter is for comparison: its curves, closed or ended on borders, leave umbilics alone, pass
   * from colour to colour at purple points (RidgeType 0 there), and miss edges crossed by both
   * colours; ExtractMaximum, ExtractMinimum and umbilics do not matter then.
   */
  vtkSetClampMacro(ExtremalityRule, int, PRINCIPAL, GAUSSIAN);
  vtkGetMacro(ExtremalityRule, int);
  void SetExtremalityRuleToPrincipal() { this->SetExtremalityRule(PRINCIPAL); }
  void SetExtremalityRuleToGaussian() { this->SetExtremalityRule(GAUSSIAN); }
  ///@}

  ///@{
  /**
   * Where on a crossed edge the crossing is put: where b0 or b3 of the Monge form interpolated
   * between its ends vanishes, or by equation (4), from the two values of b0 or b3 alone. Which
   * edges are crossed is the same. Default the form: where principal directions turn fast, as near
   * umbilics, the two values belong to different directions, and lines by equation (4) zigzag by a
   * third of an edge; elsewhere the two agree.
   */
  vtkSetClampMacro(CrossingRule, int, FORM, LINEAR);
  vtkGetMacro(CrossingRule, int);
  void SetCrossingRuleToForm() { this->SetCrossingRule(FORM); }
  void SetCrossingRuleToLinear() { this->SetCrossingRule(LINEAR); }
  ///@}

  ///@{
  /**
   * How ridges are joined to umbilics: in the patches that vtkUmbilicDetection has marked (section
   * 6.3), or at the centroids of all singular triangles, whatever patches there are (the plain
   * algorithm of section 6.2). Default patches. Singular triangles outside all patches are joined
   * to the zero of the traceless second fundamental form in either case, where there are patches.
   */
  vtkSetClampMacro(UmbilicJoining, int, PATCHES, TRIANGLES);
  vtkGetMacro(UmbilicJoining, int);
  void SetUmbilicJoiningToPatches() { this->SetUmbilicJoining(PATCHES); }
  void SetUmbilicJoiningToTriangles() { this->SetUmbilicJoining(TRIANGLES); }
  ///@}

  ///@{
  /**
   * Loops that noise alone may have made are left out: those around at most 64 points at all of
   * which b0 (b3) is within this many standard errors from 0. The errors are those of
   * ThirdOrderError if that is there, else estimated from FitResidual and FitScale; without these
   * no loop is left out. 0 to 100, default 3; 0 keeps all.
   */
  vtkSetClampMacro(LoopSignificance, double, 0.0, 100.0);
  vtkGetMacro(LoopSignificance, double);
  ///@}

  ///@{
  /**
   * Runs of one type that are shorter than this many mean edge lengths, between two of another
   * type, take on that type: noise in P makes them. 0 to 1000, default 0: none does.
   */
  vtkSetClampMacro(TypeHysteresis, double, 0.0, 1000.0);
  vtkGetMacro(TypeHysteresis, double);
  ///@}

  ///@{
  /**
   * Whether to put the purple points, where a blue ridge crosses a red one, on output port 1.
   * Default off.
   */
  vtkSetMacro(FindPurplePoints, bool);
  vtkGetMacro(FindPurplePoints, bool);
  vtkBooleanMacro(FindPurplePoints, bool);
  ///@}

  ///@{
  /**
   * The length by which sharpness is made free of units, 0 or more. Default 0: the radius of the
   * smallest enclosing sphere of the mesh.
   */
  vtkSetClampMacro(ModelSize, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ModelSize, double);
  ///@}

  ///@{
  /**
   * Distance from an umbilic, as a fraction of the model size, within which hyperbolic ridges do
   * not count towards their sharpness; 0 to 1. Default 0.01. With 0 the sharpness depends on the
   * mesh, as it has no limit.
   */
  vtkSetClampMacro(UmbilicCutOff, double, 0.0, 1.0);
  vtkGetMacro(UmbilicCutOff, double);
  ///@}

protected:
  vtkRidgeExtraction();
  ~vtkRidgeExtraction() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  bool ExtractMaximum = true;
  bool ExtractMinimum = true;
  bool CrestOnly = false;
  int TypeRule = FOURTH_ORDER;
  int ExtremalityRule = PRINCIPAL;
  int CrossingRule = FORM;
  int UmbilicJoining = PATCHES;
  double LoopSignificance = 3.0;
  double TypeHysteresis = 0.0;
  bool FindPurplePoints = false;
  double ModelSize = 0.0;
  double UmbilicCutOff = 0.01;

private:
  vtkRidgeExtraction(const vtkRidgeExtraction&) = delete;
  void operator=(const vtkRidgeExtraction&) = delete;
};

#endif
