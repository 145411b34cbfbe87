// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRidgesAndUmbilics
 * @brief   from a mesh to its ridges and umbilics, in one filter
 *
 * Runs vtkJetFitting, vtkUmbilicDetection, vtkRidgeExtraction and vtkRidgeSharpnessFilter in a row
 * and has those of their properties that matter for ridges; each is documented in its own class.
 * Monge forms are of order 4, as ridges and their types need it.
 *
 * Input: a triangle mesh; polygons and strips are triangulated, verts and lines are ignored.
 *
 * Output port 0: the ridges kept, the output of vtkRidgeSharpnessFilter; RidgeType is the active
 * scalar array. Output port 1: a vertex per umbilic, the output of vtkUmbilicDetection. Output port
 * 2: the mesh with its Monge arrays, umbilic marks and RidgeZone.
 *
 * Guarantees: the outputs are those of the four filters in a row, byte for byte. Only stages whose
 * properties have changed, and those after them, run again: another MinimumSharpness is cheap.
 * Errors and warnings of the stages come from this filter; progress is that of the whole.
 *
 * @sa
 * vtkJetFitting vtkUmbilicDetection vtkRidgeExtraction vtkRidgeSharpnessFilter
 */

#ifndef vtkRidgesAndUmbilics_h
#define vtkRidgesAndUmbilics_h

#include "vtkFiltersRidgesModule.h" // For export macro
#include "vtkJetFitting.h"          // For its enums
#include "vtkPolyDataAlgorithm.h"
#include "vtkRidgeExtraction.h"      // For its enums
#include "vtkRidgeSharpnessFilter.h" // For its enums
#include "vtkRidgesCompatibility.h"  // For the ABI namespace
#include "vtkRidgesRanks.h"
#include "vtkUmbilicDetection.h" // For its enums

/// A property of a stage, under the same name.
#define vtkRidgesStagePropertyMacro(name, type)                                                    \
  void Set##name(type value);                                                                      \
  type Get##name()

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSRIDGES_EXPORT vtkRidgesAndUmbilics : public vtkPolyDataAlgorithm
{
public:
  static vtkRidgesAndUmbilics* New();
  vtkTypeMacro(vtkRidgesAndUmbilics, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Meaning of the output ports.
  enum OutputPorts
  {
    RIDGES = 0,
    UMBILICS = 1,
    MESH = 2
  };

  ///@{
  /**
   * The degree of fits, how neighbourhoods are chosen, one of vtkJetFitting::NeighborhoodType, and
   * how their points are weighted, one of vtkJetFitting::WeightingType. See vtkJetFitting.
   */
  vtkRidgesStagePropertyMacro(Degree, int);
  vtkRidgesStagePropertyMacro(Neighborhood, int);
  void SetNeighborhoodToPointCount() { this->SetNeighborhood(vtkJetFitting::BY_POINT_COUNT); }
  void SetNeighborhoodToRings() { this->SetNeighborhood(vtkJetFitting::BY_RINGS); }
  void SetNeighborhoodToRadius() { this->SetNeighborhood(vtkJetFitting::BY_RADIUS); }
  void SetNeighborhoodToAutomatic() { this->SetNeighborhood(vtkJetFitting::AUTOMATIC); }
  vtkRidgesStagePropertyMacro(MinimumNumberOfPoints, int);
  vtkRidgesStagePropertyMacro(NumberOfRings, int);
  vtkRidgesStagePropertyMacro(Radius, double);
  vtkRidgesStagePropertyMacro(Weighting, int);
  void SetWeightingToUniform() { this->SetWeighting(vtkJetFitting::UNIFORM); }
  void SetWeightingToGaussian() { this->SetWeighting(vtkJetFitting::GAUSSIAN); }
  vtkRidgesStagePropertyMacro(BlendNoisyFits, bool);
  vtkBooleanMacro(BlendNoisyFits, bool);
  vtkRidgesStagePropertyMacro(StandardErrors, bool);
  vtkBooleanMacro(StandardErrors, bool);
  ///@}

  ///@{
  /**
   * Umbilics: how they are found, one of vtkUmbilicDetection::Methods, which of them noise may have
   * caused, and how large their patches are. See vtkUmbilicDetection.
   */
  vtkRidgesStagePropertyMacro(Method, int);
  void SetMethodToIndices() { this->SetMethod(vtkUmbilicDetection::INDICES); }
  void SetMethodToMinima() { this->SetMethod(vtkUmbilicDetection::MINIMA); }
  vtkRidgesStagePropertyMacro(Significance, double);
  vtkRidgesStagePropertyMacro(PatchSize, double);
  ///@}

  ///@{
  /**
   * Ridges: how types are decided, crossings placed and umbilics joined, one of
   * vtkRidgeExtraction::TypeRules, vtkRidgeExtraction::CrossingRules and
   * vtkRidgeExtraction::UmbilicJoinings, which loops and types noise may have caused, and how
   * sharpness is measured. See vtkRidgeExtraction.
   */
  vtkRidgesStagePropertyMacro(TypeRule, int);
  void SetTypeRuleToFourthOrder() { this->SetTypeRule(vtkRidgeExtraction::FOURTH_ORDER); }
  void SetTypeRuleToThirdOrder() { this->SetTypeRule(vtkRidgeExtraction::THIRD_ORDER); }
  vtkRidgesStagePropertyMacro(CrossingRule, int);
  void SetCrossingRuleToForm() { this->SetCrossingRule(vtkRidgeExtraction::FORM); }
  void SetCrossingRuleToLinear() { this->SetCrossingRule(vtkRidgeExtraction::LINEAR); }
  vtkRidgesStagePropertyMacro(UmbilicJoining, int);
  void SetUmbilicJoiningToPatches() { this->SetUmbilicJoining(vtkRidgeExtraction::PATCHES); }
  void SetUmbilicJoiningToTriangles() { this->SetUmbilicJoining(vtkRidgeExtraction::TRIANGLES); }
  vtkRidgesStagePropertyMacro(LoopSignificance, double);
  vtkRidgesStagePropertyMacro(ZoneSignificance, double);
  vtkRidgesStagePropertyMacro(TypeSignificance, double);
  vtkRidgesStagePropertyMacro(TypeHysteresis, double);
  vtkRidgesStagePropertyMacro(ComputeFoldAngle, bool);
  vtkBooleanMacro(ComputeFoldAngle, bool);
  vtkRidgesStagePropertyMacro(ModelSize, double);
  vtkRidgesStagePropertyMacro(UmbilicCutOff, double);
  ///@}

  ///@{
  /**
   * Which ridges are kept: by default all. See vtkRidgeSharpnessFilter.
   */
  vtkRidgesStagePropertyMacro(MinimumSharpness, double);
  vtkRidgesStagePropertyMacro(MinimumStrength, double);
  vtkRidgesStagePropertyMacro(MinimumLength, double);
  vtkRidgesStagePropertyMacro(KeepMaximumElliptic, bool);
  vtkBooleanMacro(KeepMaximumElliptic, bool);
  vtkRidgesStagePropertyMacro(KeepMaximumHyperbolic, bool);
  vtkBooleanMacro(KeepMaximumHyperbolic, bool);
  vtkRidgesStagePropertyMacro(KeepMinimumElliptic, bool);
  vtkBooleanMacro(KeepMinimumElliptic, bool);
  vtkRidgesStagePropertyMacro(KeepMinimumHyperbolic, bool);
  vtkBooleanMacro(KeepMinimumHyperbolic, bool);
  vtkRidgesStagePropertyMacro(KeepUndecided, bool);
  vtkBooleanMacro(KeepUndecided, bool);
  vtkRidgesStagePropertyMacro(CrestOnly, bool);
  vtkBooleanMacro(CrestOnly, bool);
  vtkRidgesStagePropertyMacro(WholeRidges, bool);
  vtkBooleanMacro(WholeRidges, bool);
  vtkRidgesStagePropertyMacro(MaximumNumber, int);
  vtkRidgesStagePropertyMacro(RankBy, int);
  void SetRankByToSharpness() { this->SetRankBy(vtkRidgeSharpnessFilter::SHARPNESS); }
  void SetRankByToStrength() { this->SetRankBy(vtkRidgeSharpnessFilter::STRENGTH); }
  void SetRankByToLength() { this->SetRankBy(vtkRidgeSharpnessFilter::LENGTH); }
  ///@}

protected:
  vtkRidgesAndUmbilics();
  ~vtkRidgesAndUmbilics() override;

  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// Who has the other pieces of the mesh; null: the input is all there is.
  virtual ridges::Ranks* GetRanks() { return nullptr; }

  /// In how many pieces one rank asks for its input, one after the other.
  virtual int GetNumberOfStreamedPieces() { return 1; }

private:
  vtkRidgesAndUmbilics(const vtkRidgesAndUmbilics&) = delete;
  void operator=(const vtkRidgesAndUmbilics&) = delete;

  bool IsStreamed();
  int RequestPieces(vtkInformation*, vtkInformationVector*, vtkInformationVector*);
  int FindInPieces(vtkInformationVector*);
  int RequestSharedData(ridges::Ranks&, vtkInformationVector**, vtkInformationVector*);

  class vtkInternals;
  vtkInternals* const Internals;
};
VTK_ABI_NAMESPACE_END

#undef vtkRidgesStagePropertyMacro

#endif
