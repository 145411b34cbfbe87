// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkJetFitting
 * @brief   estimate curvatures and their derivatives at the points of a triangle mesh
 *
 * Around each point a polynomial height function is fitted to the points near it, and its Monge
 * form is written out: the principal curvatures k1 >= k2 with their directions, and the third- and
 * fourth-order coefficients that ridges are made of (RR-5294, section 3, equations 1 and 2):
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
 * Method: jet fitting. The neighbourhood's principal axes give the height direction, the point
 * itself the origin; offsets are scaled by the neighbourhood's radius. Several points are fitted at
 * once by refined normal equations, those that these are not exact enough for one by one by an
 * orthogonal decomposition. On a smooth surface sampled at distance h the error of k is of the
 * order of h^(Degree - 1), that of b h^(Degree - 2), that of c h^(Degree - 3), and one order better
 * on regular samplings.
 *
 * Guarantees: the same bytes for any number of threads, any SMP back end and any numbering of
 * points and cells; between machines with and without fused multiply-add k, b and P differ by
 * round-off (1e-12, 1e-10 and 1e-10 relative, on clean meshes). No value is ever NaN: where nothing
 * can be fitted all values are 0 and FitStatus says FIT_INVALID. Polygons and strips are
 * triangulated; verts and lines are passed over.
 *
 * @warning
 * The triangles have to be consistently oriented: flipping the orientation changes the sign of the
 * curvatures and swaps maximum and minimum (k1' = -k2, k2' = -k1).
 *
 * @sa
 * vtkUmbilicDetection vtkRidgeExtraction vtkCurvatures
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

  /// What bounds a neighbourhood.
  enum NeighborhoodType
  {
    BY_POINT_COUNT = 0,
    BY_RINGS = 1,
    BY_RADIUS = 2,
    AUTOMATIC = 3
  };

  /// How much the points of a neighbourhood count.
  enum WeightingType
  {
    UNIFORM = 0,
    GAUSSIAN = 1
  };

  /// Bits of the FitStatus array.
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
   * directions, 3 ThirdOrder, 4 FourthOrder, P1 and P2. Never more than Degree. Default 4.
   */
  vtkSetClampMacro(MongeOrder, int, 1, 4);
  vtkGetMacro(MongeOrder, int);
  ///@}

  ///@{
  /**
   * What bounds a neighbourhood: whole rings until there are MinimumNumberOfPoints points and, up
   * to four rings more, until the least squares is well conditioned (default: it follows the
   * density of the mesh, never falls short, and gets borders right), exactly NumberOfRings rings,
   * what is connected to the point inside the ball of a Radius, or, for noisy meshes, automatic:
   * the number of rings, 2 to 8, at which curvatures have the least estimated error on this mesh,
   * else as by point count. Noise has to be independent from point to point (no smoothed mesh).
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
   * Points that a neighbourhood has at least, the point itself included, 3 or more. A number below
   * that of the coefficients (15 for degree 4) is raised to it. Default 18: two rings of a regular
   * mesh have 19 points, while the bare 15 would let the polynomial interpolate, with a few
   * nearly singular systems on any mesh. Take more on noisy data.
   */
  vtkSetClampMacro(MinimumNumberOfPoints, int, 3, VTK_INT_MAX);
  vtkGetMacro(MinimumNumberOfPoints, int);
  ///@}

  ///@{
  /**
   * Rings of a neighbourhood, 1 or more; points with too few neighbours for Degree are fitted in
   * a lower one and flagged. Default 3: two rings are just enough on a regular mesh only.
   */
  vtkSetClampMacro(NumberOfRings, int, 1, 1000);
  vtkGetMacro(NumberOfRings, int);
  ///@}

  ///@{
  /**
   * Radius of a neighbourhood, in the unit of the points; it has to be set, and positive, to be
   * used. Only what edges connect inside the ball is taken, never the other side of a thin wall.
   * Default 0: no radius is right for all meshes.
   */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  /// Rings that the last update chose, where Neighborhood was automatic; 0 where it was not.
  vtkGetMacro(SelectedNumberOfRings, int);

  ///@{
  /**
   * How much the points of a neighbourhood count: uniform, all the same, or by a Gaussian of the
   * distance whose standard deviation is half of FitScale: 1 at the point, 0.135 at the radius.
   * Default uniform: least variance; Gaussian takes a wider neighbourhood for the same.
   */
  vtkSetClampMacro(Weighting, int, UNIFORM, GAUSSIAN);
  vtkGetMacro(Weighting, int);
  void SetWeightingToUniform() { this->SetWeighting(UNIFORM); }
  void SetWeightingToGaussian() { this->SetWeighting(GAUSSIAN); }
  const char* GetWeightingAsString() const;
  ///@}

  ///@{
  /**
   * Whether standard errors are put out: by each fit's residuals, how far noise that is independent
   * from point to point makes the values scatter. -1 stands for unknown: no fit, no more points
   * than coefficients, or a fit of too low a degree. Parameters.md tells how to use them. Default
   * off: points are then fitted once more, one by one, which takes some 15 times as long.
   * The other arrays are the same either way.
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
