// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkJetFitting
 * @brief   estimate curvatures and their derivatives at the points of a triangle mesh
 *
 * Fits a polynomial height function around each point and outputs its Monge form (RR-5294,
 * equations 1 and 2), with principal curvatures k1 >= k2 and all coefficients that define ridges:
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
 * | FitConditionNumber | 1     | of the scaled least squares problem, no unit     |       |
 * | FitResidual        | 1     | rms of the height residuals, per fitting radius  |       |
 * | FitScale           | 1     | radius of the neighbourhood that was fitted      | L     |
 * | FitNoiseGain       | 1     | error of ThirdOrder, per FitResidual / FitScale^2|       |
 *
 * and, if StandardErrors is on, the errors MaximumCurvatureError, MinimumCurvatureError,
 * ThirdOrderError (of b0 to b3), P1Error and P2Error, in the units of these values. If Neighborhood
 * is AUTOMATIC, the field arrays SelectedDegree, SelectedNumberOfRings, SelectedNumberOfAverages,
 * EstimatedNoise (standard deviation of the points, L), NoiseCorrelation and, in words, SelectedFit
 * report the choice, of blended fits the last one. Where NoiseCorrelation is not about 0, points
 * were smoothed or resampled, or the fits do not follow the surface, and EstimatedNoise is wrong.
 *
 * Curvature is positive where the surface bends towards its normal: a sphere of radius r with
 * outward normals has k1 = k2 = -1/r. vtkCurvatures has the opposite sign.
 *
 * Method: jet fitting. The principal axes of the neighbourhood give the height direction; offsets
 * are in units of its radius. On a smooth surface sampled at distance h the errors of k, b and c
 * are of order Degree - 1, Degree - 2 and Degree - 3 in h, one better on regular samplings.
 * Guarantees: the same bytes for any number of threads, any SMP back end and any numbering; fused
 * multiply-add changes k, b and P by round-off (1e-12, 1e-10 and 1e-10, on clean meshes). No value
 * is NaN: where nothing fits all are 0 and FitStatus is FIT_INVALID. Polygons and strips are
 * triangulated. For composite data and ghosts see Documentation/Arrays.md.
 * @warning The triangles must be consistently oriented: flipping the orientation changes the
 * sign of the curvatures and swaps maximum and minimum (k1' = -k2, k2' = -k1).
 * @sa vtkUmbilicDetection vtkRidgeExtraction vtkCurvatures
 */

#ifndef vtkJetFitting_h
#define vtkJetFitting_h

#include "vtkFiltersRidgesModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkRidgesCompatibility.h" // For the ABI namespace
#include "vtkRidgesRanks.h"

VTK_ABI_NAMESPACE_BEGIN
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
    FIT_INVALID = 8,         ///< Nothing could be fitted: all values are 0.
    FIT_FOLDED = 16 ///< The surface folds over in the neighbourhood: fitted to a part of it.
  };

  ///@{
  /**
   * Degree of the polynomial, 1 to 8; 6 and 8 are more exact on clean meshes, and slower. Default
   * 0: chosen with Neighborhood AUTOMATIC, else 4, as ridges need c. MongeOrder is the highest
   * order of the Monge form in the output, 1 to 4: 1 normals, 2 curvatures and directions, 3
   * ThirdOrder, 4 FourthOrder, P1, P2; at most the degree. Default 4: ridges need all.
   */
  vtkSetClampMacro(Degree, int, 0, 8);
  vtkGetMacro(Degree, int);
  vtkSetClampMacro(MongeOrder, int, 1, 4);
  vtkGetMacro(MongeOrder, int);
  ///@}

  ///@{
  /**
   * How a neighbourhood is chosen. BY_POINT_COUNT: whole rings until there are
   * MinimumNumberOfPoints points and the fit is well conditioned. BY_RINGS: exactly NumberOfRings
   * rings. BY_RADIUS: what is connected inside the ball of a Radius. AUTOMATIC: the degree, 4 to 8
   * if none is set, and the rings, 2 to 24, with the least estimated error of ThirdOrder, or, with
   * MongeOrder 2, of the curvatures from degree 2 on. Where there is noise, two averages over
   * one-rings follow (vtkMongeSmoothing), and the standard errors are those before. Default
   * AUTOMATIC: no other choice suits both exact data and noise. Without noise it blends three fits
   * at each point by their errors; with BlendNoisyFits also where there is noise, independent from
   * point to point. Default on: more ridges are whole; the fit takes about 2.5 times as long.
   */
  vtkSetClampMacro(Neighborhood, int, BY_POINT_COUNT, AUTOMATIC);
  vtkGetMacro(Neighborhood, int);
  void SetNeighborhoodToPointCount() { this->SetNeighborhood(BY_POINT_COUNT); }
  void SetNeighborhoodToRings() { this->SetNeighborhood(BY_RINGS); }
  void SetNeighborhoodToRadius() { this->SetNeighborhood(BY_RADIUS); }
  void SetNeighborhoodToAutomatic() { this->SetNeighborhood(AUTOMATIC); }
  const char* GetNeighborhoodAsString() const;
  vtkSetMacro(BlendNoisyFits, bool);
  vtkGetMacro(BlendNoisyFits, bool);
  vtkBooleanMacro(BlendNoisyFits, bool);
  ///@}

  ///@{
  /**
   * Minimum number of points in a neighbourhood, itself included; at least 3, raised to 15, 26, 34,
   * 45, 56 in degrees 4 to 8. Default 18: two rings of a regular mesh have 19; 15 interpolate.
   * Number of rings, 1 to 1000. Where they have too few points a lower degree is fitted, and
   * flagged. Default 3: two are enough on a regular mesh only; four from degree 7 on.
   * Radius, in the unit of the points; it must be positive to be used. The other side of a thin
   * wall is never included. Default 0: no radius suits every mesh.
   */
  vtkSetClampMacro(MinimumNumberOfPoints, int, 3, VTK_INT_MAX);
  vtkGetMacro(MinimumNumberOfPoints, int);
  vtkSetClampMacro(NumberOfRings, int, 1, 1000);
  vtkGetMacro(NumberOfRings, int);
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Weights of the points in a neighbourhood: equal, or a Gaussian of the distance with a standard
   * deviation of half of FitScale. Default UNIFORM: it has the smallest variance.
   */
  vtkSetClampMacro(Weighting, int, UNIFORM, GAUSSIAN);
  vtkGetMacro(Weighting, int);
  void SetWeightingToUniform() { this->SetWeighting(UNIFORM); }
  void SetWeightingToGaussian() { this->SetWeighting(GAUSSIAN); }
  const char* GetWeightingAsString() const;
  ///@}

  ///@{
  /**
   * Whether to output the standard errors caused by noise that is independent from point to point,
   * estimated from the residuals of each fit; -1 if unknown: no fit, too few points, low degree.
   * Default off: the fit takes a quarter longer, or twice as long with weights.
   */
  vtkSetMacro(StandardErrors, bool);
  vtkGetMacro(StandardErrors, bool);
  vtkBooleanMacro(StandardErrors, bool);
  ///@}

protected:
  vtkJetFitting() = default;
  ~vtkJetFitting() override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  /// Who has the other pieces of the mesh; null: the input is all there is.
  virtual ridges::Ranks* GetRanks() { return nullptr; }
  /// Where to keep what they know of the whole mesh after the fit; null: nowhere.
  virtual ridges::SharedSurface* GetSurface() { return nullptr; }
  int Degree = 0;
  int MongeOrder = 4;
  int Neighborhood = AUTOMATIC;
  bool BlendNoisyFits = true;
  int MinimumNumberOfPoints = 18;
  int NumberOfRings = 3;
  double Radius = 0.0;
  int Weighting = UNIFORM;
  bool StandardErrors = false;

private:
  vtkJetFitting(const vtkJetFitting&) = delete;
  void operator=(const vtkJetFitting&) = delete;
  int RequestPiece(vtkInformation*, vtkInformationVector*, vtkInformationVector*);
  vtkRidgesStreamedFit* Stream = nullptr;
};
VTK_ABI_NAMESPACE_END

#endif
