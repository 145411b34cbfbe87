// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkJetFitting
 * @brief   estimate curvatures and their derivatives at the points of a triangle mesh
 *
 * Around each point a polynomial height function is fitted, and its Monge form is written out: the
 * principal curvatures k1 >= k2 with their directions, and the third- and fourth-order coefficients
 * that ridges are made of (RR-5294, section 3, equations 1 and 2):
 *
 *   z = 1/2 (k1 x^2 + k2 y^2) + 1/6 (b0 x^3 + 3 b1 x^2 y + 3 b2 x y^2 + b3 y^3)
 *     + 1/24 (c0 x^4 + 4 c1 x^3 y + 6 c2 x^2 y^2 + 4 c3 x y^3 + c4 y^4)
 *
 * with x along d1, y along d2, z along the normal n, and (d1, d2, n) direct and orthonormal.
 *
 * Output port 0: the mesh, with these point arrays (L is the length unit of the points; arrays of
 * an order above MongeOrder are left out):
 *
 * | array              | comp. | meaning                                          | unit  |
 * |--------------------|-------|--------------------------------------------------|-------|
 * | MaximumCurvature   | 1     | k1                                               | 1/L   |
 * | MinimumCurvature   | 1     | k2                                               | 1/L   |
 * | MaximumDirection   | 3     | d1, unit                                         |       |
 * | MinimumDirection   | 3     | d2, unit                                         |       |
 * | Normals            | 3     | n, unit, on the side of the mesh's orientation   |       |
 * | ThirdOrder         | 4     | b0 b1 b2 b3                                      | 1/L^2 |
 * | FourthOrder        | 5     | c0 c1 c2 c3 c4                                   | 1/L^3 |
 * | P1, P2             | 1     | 3 b1^2 + (k1 - k2)(c0 - 3 k1^3), and its dual    | 1/L^4 |
 * | FitStatus          | 1     | 0, or a sum of vtkJetFitting::FitStatusBits      |       |
 * | FitConditionNumber | 1     | of the least squares, which is free of units     |       |
 * | FitResidual        | 1     | rms of the heights left over, per fitting radius |       |
 * | FitScale           | 1     | radius of the neighbourhood that was fitted      | L     |
 *
 * and, if StandardErrors is on, the standard errors MaximumCurvatureError, MinimumCurvatureError,
 * ThirdOrderError (of b0 to b3), P1Error and P2Error, in the unit of what they are the error of.
 *
 * Curvature is positive where the surface bends towards its normal: a sphere of radius r with
 * outward normals has k1 = k2 = -1/r. vtkCurvatures has the opposite sign.
 *
 * Method: jet fitting. The neighbourhood's principal axes give the height direction; offsets are in
 * units of its radius. Several points are fitted at once by refined normal equations, those that
 * need it one by one by an orthogonal decomposition. On a smooth surface sampled at distance h the
 * errors of k, b and c are of the orders Degree - 1, - 2 and - 3 in h, one better if regular.
 * Guarantees: the same bytes for any number of threads, any SMP back end and any numbering of
 * points and cells; between machines with and without fused multiply-add k, b and P differ by
 * round-off (1e-12, 1e-10 and 1e-10 relative, on clean meshes). No value is ever NaN: where nothing
 * can be fitted all are 0 and FitStatus says FIT_INVALID. Polygons and strips are triangulated.
 *
 * @warning The triangles have to be consistently oriented: flipping the orientation changes the
 * sign of the curvatures and swaps maximum and minimum (k1' = -k2, k2' = -k1).
 * @sa vtkUmbilicDetection vtkRidgeExtraction vtkCurvatures
 */

#ifndef vtkJetFitting_h
#define vtkJetFitting_h

#include "vtkFiltersRidgesModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKFILTERSRIDGES_EXPORT vtkJetFitting : public vtkPolyDataAlgorithm
{
public:
  static vtkJetFitting* New();
  vtkTypeMacro(vtkJetFitting, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// See SetNeighborhood and SetWeighting.
  enum NeighborhoodType
  {
    BY_POINT_COUNT = 0,
    BY_RINGS = 1,
    BY_RADIUS = 2,
    AUTOMATIC = 3
  };
  enum WeightingType
  {
    UNIFORM = 0,
    GAUSSIAN = 1
  };

  /// Bits of FitStatus.
  enum FitStatusBits
  {
    FIT_GOOD = 0,
    FIT_BOUNDARY = 1,        ///< On the border: the neighbourhood is one-sided.
    FIT_TOO_FEW_POINTS = 2,  ///< Fewer points than coefficients: fitted in a lower degree.
    FIT_ILL_CONDITIONED = 4, ///< The points hardly determine the polynomial.
    FIT_INVALID = 8          ///< Nothing could be fitted: all values are 0.
  };

  ///@{
  /**
   * Degree of the polynomial, 1 to 4. Default 4: ridges need b, and their type c, and an even
   * degree above these lets their errors cancel best.
   */
  vtkSetClampMacro(Degree, int, 1, 4);
  vtkGetMacro(Degree, int);
  ///@}

  ///@{
  /**
   * Highest order of the Monge form that is written out, 1 to 4: 1 normals, 2 curvatures and
   * directions, 3 ThirdOrder, 4 FourthOrder, P1, P2; at most Degree. Default 4: ridges need all.
   */
  vtkSetClampMacro(MongeOrder, int, 1, 4);
  vtkGetMacro(MongeOrder, int);
  ///@}

  ///@{
  /**
   * What bounds a neighbourhood: whole rings until there are MinimumNumberOfPoints points and the
   * least squares is well conditioned (default: it follows the density of the mesh and gets borders
   * right), exactly NumberOfRings rings, what is connected inside the ball of a Radius, or, for
   * noise that is independent from point to point, automatic: the number of rings, 2 to 8, at which
   * curvatures have the least estimated error on this mesh, else as by point count.
   */
  vtkSetClampMacro(Neighborhood, int, BY_POINT_COUNT, AUTOMATIC);
  vtkGetMacro(Neighborhood, int);
  void SetNeighborhoodToPointCount() { this->SetNeighborhood(BY_POINT_COUNT); }
  void SetNeighborhoodToRings() { this->SetNeighborhood(BY_RINGS); }
  void SetNeighborhoodToRadius() { this->SetNeighborhood(BY_RADIUS); }
  void SetNeighborhoodToAutomatic() { this->SetNeighborhood(AUTOMATIC); }
  const char* GetNeighborhoodAsString() const;
  ///@}

  ///@{
  /**
   * Points that a neighbourhood has at least, the point itself included, 3 or more, raised to the
   * number of coefficients (15 for degree 4). Default 18: two rings of a regular mesh have 19,
   * while 15 would let the polynomial interpolate. Take more on noisy data.
   */
  vtkSetClampMacro(MinimumNumberOfPoints, int, 3, VTK_INT_MAX);
  vtkGetMacro(MinimumNumberOfPoints, int);
  ///@}

  ///@{
  /**
   * Rings of a neighbourhood, 1 or more; a lower degree is fitted, and flagged, where they have
   * too few points. Default 3: two are just enough on a regular mesh only.
   */
  vtkSetClampMacro(NumberOfRings, int, 1, 1000);
  vtkGetMacro(NumberOfRings, int);
  ///@}

  ///@{
  /**
   * Radius of a neighbourhood, in the unit of the points; to be used it has to be positive. The
   * other side of a thin wall is never taken. Default 0: no radius is right for all meshes.
   */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  /// Rings that the last update chose where Neighborhood was automatic, else 0.
  vtkGetMacro(SelectedNumberOfRings, int);

  ///@{
  /**
   * How much the points of a neighbourhood count: all the same, or by a Gaussian of the distance
   * with a standard deviation of half of FitScale. Default uniform: it has the least variance.
   */
  vtkSetClampMacro(Weighting, int, UNIFORM, GAUSSIAN);
  vtkGetMacro(Weighting, int);
  void SetWeightingToUniform() { this->SetWeighting(UNIFORM); }
  void SetWeightingToGaussian() { this->SetWeighting(GAUSSIAN); }
  const char* GetWeightingAsString() const;
  ///@}

  ///@{
  /**
   * Whether standard errors are put out: how far noise that is independent from point to point
   * makes the values scatter, by each fit's residuals. -1 stands for unknown: no fit, too few
   * points or too low a degree. Default off: fitting all points again, one by one, takes 25 times
   * as long.
   */
  vtkSetMacro(StandardErrors, bool);
  vtkGetMacro(StandardErrors, bool);
  vtkBooleanMacro(StandardErrors, bool);
  ///@}

protected:
  vtkJetFitting() = default;
  ~vtkJetFitting() override = default;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int Degree = 4;
  int MongeOrder = 4;
  int Neighborhood = BY_POINT_COUNT;
  int MinimumNumberOfPoints = 18;
  int NumberOfRings = 3;
  double Radius = 0.0;
  int SelectedNumberOfRings = 0;
  int Weighting = UNIFORM;
  bool StandardErrors = false;

private:
  vtkJetFitting(const vtkJetFitting&) = delete;
  void operator=(const vtkJetFitting&) = delete;
};

#endif
