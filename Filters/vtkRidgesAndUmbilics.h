// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRidgesAndUmbilics
 * @brief   from a mesh to its ridges and umbilics, in one filter
 *
 * Runs vtkJetFitting, vtkUmbilicDetection, vtkRidgeExtraction and vtkRidgeSharpnessFilter in a row
 * and has those of their properties that matter for ridges; each is documented in its own class.
 * Fits are of degree 4, and Monge forms of order 4, as ridges and their types need them.
 *
 * Input: a triangle mesh; polygons and strips are triangulated, verts and lines are ignored.
 *
 * Output port 0: the ridges kept, the output of vtkRidgeSharpnessFilter; RidgeType is the active
 * scalar array. Output port 1: a vertex per umbilic. Output port 2: the mesh with its Monge arrays
 * and umbilic marks. Both are outputs of vtkUmbilicDetection.
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
#include "vtkJetFitting.h"          // For the stage
#include "vtkNew.h"                 // For the stages
#include "vtkPolyDataAlgorithm.h"
#include "vtkRidgeExtraction.h"      // For the stage
#include "vtkRidgeSharpnessFilter.h" // For the stage
#include "vtkUmbilicDetection.h"     // For the stage

#include <array>  // For the stages
#include <string> // For the error

/// A property of a stage, under the same name.
#define vtkRidgesForwardMacro(stage, name, type)                                                   \
  void Set##name(type value)                                                                       \
  {                                                                                                \
    this->stage->Set##name(value);                                                                 \
  }                                                                                                \
  type Get##name()                                                                                 \
  {                                                                                                \
    return this->stage->Get##name();                                                               \
  }

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
   * How neighbourhoods are chosen, one of vtkJetFitting::NeighborhoodType, and how their points are
   * weighted, one of vtkJetFitting::WeightingType. See vtkJetFitting.
   */
  vtkRidgesForwardMacro(Jets, Neighborhood, int);
  void SetNeighborhoodToPointCount() { this->SetNeighborhood(vtkJetFitting::BY_POINT_COUNT); }
  void SetNeighborhoodToRings() { this->SetNeighborhood(vtkJetFitting::BY_RINGS); }
  void SetNeighborhoodToRadius() { this->SetNeighborhood(vtkJetFitting::BY_RADIUS); }
  void SetNeighborhoodToAutomatic() { this->SetNeighborhood(vtkJetFitting::AUTOMATIC); }
  vtkRidgesForwardMacro(Jets, MinimumNumberOfPoints, int);
  vtkRidgesForwardMacro(Jets, NumberOfRings, int);
  vtkRidgesForwardMacro(Jets, Radius, double);
  vtkRidgesForwardMacro(Jets, Weighting, int);
  void SetWeightingToUniform() { this->SetWeighting(vtkJetFitting::UNIFORM); }
  void SetWeightingToGaussian() { this->SetWeighting(vtkJetFitting::GAUSSIAN); }
  vtkRidgesForwardMacro(Jets, StandardErrors, bool);
  vtkBooleanMacro(StandardErrors, bool);
  int GetSelectedNumberOfRings() { return this->Jets->GetSelectedNumberOfRings(); }
  ///@}

  ///@{
  /**
   * Umbilics: how they are found, one of vtkUmbilicDetection::Methods, which of them noise may have
   * caused, and how large their patches are. See vtkUmbilicDetection.
   */
  vtkRidgesForwardMacro(Umbilics, Method, int);
  void SetMethodToIndices() { this->SetMethod(vtkUmbilicDetection::INDICES); }
  void SetMethodToMinima() { this->SetMethod(vtkUmbilicDetection::MINIMA); }
  vtkRidgesForwardMacro(Umbilics, Significance, double);
  vtkRidgesForwardMacro(Umbilics, PatchSize, double);
  ///@}

  ///@{
  /**
   * Ridges: how types are decided, crossings placed and umbilics joined, one of
   * vtkRidgeExtraction::TypeRules, vtkRidgeExtraction::CrossingRules and
   * vtkRidgeExtraction::UmbilicJoinings, which loops and types noise may have caused, and how
   * sharpness is measured. See vtkRidgeExtraction.
   */
  vtkRidgesForwardMacro(Ridges, TypeRule, int);
  void SetTypeRuleToFourthOrder() { this->SetTypeRule(vtkRidgeExtraction::FOURTH_ORDER); }
  void SetTypeRuleToThirdOrder() { this->SetTypeRule(vtkRidgeExtraction::THIRD_ORDER); }
  vtkRidgesForwardMacro(Ridges, CrossingRule, int);
  void SetCrossingRuleToForm() { this->SetCrossingRule(vtkRidgeExtraction::FORM); }
  void SetCrossingRuleToLinear() { this->SetCrossingRule(vtkRidgeExtraction::LINEAR); }
  vtkRidgesForwardMacro(Ridges, UmbilicJoining, int);
  void SetUmbilicJoiningToPatches() { this->SetUmbilicJoining(vtkRidgeExtraction::PATCHES); }
  void SetUmbilicJoiningToTriangles() { this->SetUmbilicJoining(vtkRidgeExtraction::TRIANGLES); }
  vtkRidgesForwardMacro(Ridges, LoopSignificance, double);
  vtkRidgesForwardMacro(Ridges, TypeHysteresis, double);
  vtkRidgesForwardMacro(Ridges, ModelSize, double);
  vtkRidgesForwardMacro(Ridges, UmbilicCutOff, double);
  ///@}

  ///@{
  /**
   * Which ridges are kept: by default all. See vtkRidgeSharpnessFilter.
   */
  vtkRidgesForwardMacro(Selection, MinimumSharpness, double);
  vtkRidgesForwardMacro(Selection, MinimumStrength, double);
  vtkRidgesForwardMacro(Selection, MinimumLength, double);
  vtkRidgesForwardMacro(Selection, KeepMaximumElliptic, bool);
  vtkBooleanMacro(KeepMaximumElliptic, bool);
  vtkRidgesForwardMacro(Selection, KeepMaximumHyperbolic, bool);
  vtkBooleanMacro(KeepMaximumHyperbolic, bool);
  vtkRidgesForwardMacro(Selection, KeepMinimumElliptic, bool);
  vtkBooleanMacro(KeepMinimumElliptic, bool);
  vtkRidgesForwardMacro(Selection, KeepMinimumHyperbolic, bool);
  vtkBooleanMacro(KeepMinimumHyperbolic, bool);
  vtkRidgesForwardMacro(Selection, KeepUndecided, bool);
  vtkBooleanMacro(KeepUndecided, bool);
  vtkRidgesForwardMacro(Selection, CrestOnly, bool);
  vtkBooleanMacro(CrestOnly, bool);
  ///@}

  /// The properties are those of the stages.
  vtkMTimeType GetMTime() override;

protected:
  vtkRidgesAndUmbilics();
  ~vtkRidgesAndUmbilics() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkRidgesAndUmbilics(const vtkRidgesAndUmbilics&) = delete;
  void operator=(const vtkRidgesAndUmbilics&) = delete;

  std::array<vtkPolyDataAlgorithm*, 4> GetStages();
  void TakeIn(vtkPolyData* input);
  void ForwardProgress(vtkObject* stage, unsigned long, void*);
  void ForwardMessage(vtkObject* caller, unsigned long event, void* text);

  vtkNew<vtkJetFitting> Jets;
  vtkNew<vtkUmbilicDetection> Umbilics;
  vtkNew<vtkRidgeExtraction> Ridges;
  vtkNew<vtkRidgeSharpnessFilter> Selection;
  const vtkPolyData* LastInput = nullptr; ///< To compare with only.
  vtkMTimeType LastInputTime = 0;
  std::string ErrorText; ///< Of the stages, in this update.
};

#undef vtkRidgesForwardMacro

#endif
