// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRidgeSharpnessFilter
 * @brief   keep the salient ridges
 *
 * Passes the polylines of vtkRidgeExtraction that are sharp, strong and long enough and of the
 * chosen types, with all their arrays: each for itself, or whole ridges, or so many of the first.
 * Sharpness and strength have no unit, so one threshold suits a model at any scale (RR-5294,
 * section 7.2).
 *
 * Input: polylines with the cell arrays RidgeType, Crest if CrestOnly is on, RidgeId if WholeRidges
 * is on, and those of Sharpness, Strength and Length for which a minimum is set or by which lines
 * are ranked.
 *
 * Output port 0: the polylines kept, and only the points they use.
 *
 * @sa
 * vtkRidgeExtraction
 */

#ifndef vtkRidgeSharpnessFilter_h
#define vtkRidgeSharpnessFilter_h

#include "vtkFiltersRidgesModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkRidgesCompatibility.h" // For the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSRIDGES_EXPORT vtkRidgeSharpnessFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkRidgeSharpnessFilter* New();
  vtkTypeMacro(vtkRidgeSharpnessFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Minimum sharpness of a polyline, no unit, 0 or more. Default 0, which keeps all: what is
   * salient depends on the model. On smooth shapes ridges have 1 to 1000. On scans noise has as
   * much; about 300, with a fit to 200 points, keeps the ridges that the eye sees.
   */
  vtkSetClampMacro(MinimumSharpness, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MinimumSharpness, double);
  ///@}

  ///@{
  /**
   * Minimum strength of a polyline (the integral of its curvature, no unit), 0 or more. Default 0:
   * sharpness is the better measure (RR-5294, Fig. 26).
   */
  vtkSetClampMacro(MinimumStrength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MinimumStrength, double);
  ///@}

  ///@{
  /**
   * Minimum length of a polyline, in the unit of the points, 0 or more. Default 0: no length suits
   * every model.
   */
  vtkSetClampMacro(MinimumLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MinimumLength, double);
  ///@}

  ///@{
  /**
   * Which types are kept: 1 maximum elliptic (blue), 2 maximum hyperbolic (green), 3 minimum
   * elliptic (red), 4 minimum hyperbolic (yellow), 0 undecided. Default all.
   */
  vtkSetMacro(KeepMaximumElliptic, bool);
  vtkGetMacro(KeepMaximumElliptic, bool);
  vtkBooleanMacro(KeepMaximumElliptic, bool);
  vtkSetMacro(KeepMaximumHyperbolic, bool);
  vtkGetMacro(KeepMaximumHyperbolic, bool);
  vtkBooleanMacro(KeepMaximumHyperbolic, bool);
  vtkSetMacro(KeepMinimumElliptic, bool);
  vtkGetMacro(KeepMinimumElliptic, bool);
  vtkBooleanMacro(KeepMinimumElliptic, bool);
  vtkSetMacro(KeepMinimumHyperbolic, bool);
  vtkGetMacro(KeepMinimumHyperbolic, bool);
  vtkBooleanMacro(KeepMinimumHyperbolic, bool);
  vtkSetMacro(KeepUndecided, bool);
  vtkGetMacro(KeepUndecided, bool);
  vtkBooleanMacro(KeepUndecided, bool);
  ///@}

  ///@{
  /**
   * Whether to keep crest lines only. Default off: the types above decide.
   */
  vtkSetMacro(CrestOnly, bool);
  vtkGetMacro(CrestOnly, bool);
  vtkBooleanMacro(CrestOnly, bool);
  ///@}

  ///@{
  /**
   * Whether the minima above and MaximumNumber apply to whole ridges: to the sums over the lines of
   * one RidgeId that are of the chosen types. Default off: to each line. On, a ridge that changes
   * its type on its way is kept or left out as one, and thresholds may be larger.
   */
  vtkSetMacro(WholeRidges, bool);
  vtkGetMacro(WholeRidges, bool);
  vtkBooleanMacro(WholeRidges, bool);
  ///@}

  ///@{
  /**
   * How many lines, or whole ridges, are kept at most: the first by RankBy, of equal ones those
   * that come first in the input. 0 or more; default 0, which means all.
   */
  vtkSetClampMacro(MaximumNumber, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumNumber, int);
  ///@}

  /// See SetRankBy.
  enum Ranks
  {
    SHARPNESS = 0,
    STRENGTH = 1,
    LENGTH = 2
  };

  ///@{
  /**
   * What MaximumNumber ranks lines or ridges by. Default SHARPNESS, the better measure (RR-5294,
   * Fig. 26).
   */
  vtkSetClampMacro(RankBy, int, SHARPNESS, LENGTH);
  vtkGetMacro(RankBy, int);
  void SetRankByToSharpness() { this->SetRankBy(SHARPNESS); }
  void SetRankByToStrength() { this->SetRankBy(STRENGTH); }
  void SetRankByToLength() { this->SetRankBy(LENGTH); }
  ///@}

protected:
  vtkRidgeSharpnessFilter() = default;
  ~vtkRidgeSharpnessFilter() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double MinimumSharpness = 0.0;
  double MinimumStrength = 0.0;
  double MinimumLength = 0.0;
  bool KeepMaximumElliptic = true;
  bool KeepMaximumHyperbolic = true;
  bool KeepMinimumElliptic = true;
  bool KeepMinimumHyperbolic = true;
  bool KeepUndecided = true;
  bool CrestOnly = false;
  bool WholeRidges = false;
  int MaximumNumber = 0;
  int RankBy = SHARPNESS;

private:
  vtkRidgeSharpnessFilter(const vtkRidgeSharpnessFilter&) = delete;
  void operator=(const vtkRidgeSharpnessFilter&) = delete;

  bool KeepsType(int type) const;
};
VTK_ABI_NAMESPACE_END

#endif
