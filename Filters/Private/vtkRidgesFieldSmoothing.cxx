// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRidgesFieldSmoothing.h"

#include "Core/Fit/JetFit.h"
#include "Core/Mesh/EnclosingSphere.h"
#include "Core/Salience/FieldDerivatives.h"
#include "Core/Salience/LevelAveraging.h"
#include "Core/Salience/TensorSmoothing.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesBatches.h"
#include "vtkRidgesFormArrays.h"
#include "vtkRidgesRangeLoop.h"
#include "vtkRidgesUmbilicMarks.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <functional>

namespace names = vtkRidgesArrayNames;
using ridges::Id;

namespace
{

/// The arrays that come out, as memory to write to.
class SmoothedArrays : public vtkRidgesFormArrays
{
public:
  SmoothedArrays(vtkIdType count, bool hasFourthOrder)
  {
    this->Add(this->Normals, names::Normals, 3);
    this->Add(this->K1, names::MaximumCurvature, 1);
    this->Add(this->K2, names::MinimumCurvature, 1);
    this->Add(this->D1, names::MaximumDirection, 3);
    this->Add(this->D2, names::MinimumDirection, 3);
    this->Add(this->B, names::ThirdOrder, 4, true, "b");
    this->Add(this->C, names::FourthOrder, 5, hasFourthOrder, "c");
    this->Add(this->P1, names::P1, 1);
    this->Add(this->P2, names::P2, 1);
    this->Add(this->Scale, names::FitScale, 1);
    this->Allocate(count);
  }

  ridges::MongeField View() const
  {
    ridges::MongeField field;
    field.k1 = this->K1;
    field.k2 = this->K2;
    field.d1 = this->D1;
    field.d2 = this->D2;
    field.b = this->B;
    return field;
  }

  /// Second order; all others 0.
  void StoreSecondOrder(vtkIdType p, const ridges::MongeForm& form)
  {
    std::copy_n(form.n.data(), 3, this->Normals + 3 * p);
    std::copy_n(form.d1.data(), 3, this->D1 + 3 * p);
    std::copy_n(form.d2.data(), 3, this->D2 + 3 * p);
    this->K1[p] = form.k1;
    this->K2[p] = form.k2;
    std::copy_n(form.b.data(), 4, this->B + 4 * p);
    this->P1[p] = 0.0;
    this->P2[p] = 0.0;
    if (this->C)
    {
      std::fill_n(this->C + 5 * p, 5, 0.0);
    }
  }

  void StoreThirdOrder(vtkIdType p, const std::array<double, 4>& b)
  {
    std::copy_n(b.data(), 4, this->B + 4 * p);
  }

  void StoreFourthOrder(vtkIdType p, const std::array<double, 5>& c)
  {
    ridges::MongeForm form;
    form.k1 = this->K1[p];
    form.k2 = this->K2[p];
    std::copy_n(this->B + 4 * p, 4, form.b.data());
    form.c = c;
    std::copy_n(c.data(), 5, this->C + 5 * p);
    this->StoreP(p, form.P1(), form.P2());
  }

  void StoreP(vtkIdType p, double ofMaximum, double ofMinimum)
  {
    this->P1[p] = ofMaximum;
    this->P2[p] = ofMinimum;
  }

  void StoreFit(vtkIdType p, double scale, int status)
  {
    this->Scale[p] = scale;
    this->Status[p] = status;
  }

private:
  double *Normals, *K1, *K2, *D1, *D2, *B, *C, *P1, *P2, *Scale;
};

/// What is averaged, by the number of its values.
struct SecondOrder
{
  static constexpr int Components = 9;
  static std::array<double, 9> ToSpace(const ridges::MongeField& field, Id p)
  {
    return ridges::SecondOrderToSpace(field, p);
  }
  static bool FromSpace(const std::array<double, 9>& values, ridges::MongeForm& form)
  {
    return ridges::SecondOrderFromSpace(values, form);
  }
  static void StoreHighest(
    const std::array<double, 9>&, const ridges::MongeForm&, vtkIdType, SmoothedArrays&)
  {
  }
};

/// Of all orders, where P1 and P2 stand for the fourth.
struct ThirdOrder
{
  static constexpr int Components = 21;
  static std::array<double, 21> ToSpace(const ridges::MongeField& field, Id p)
  {
    return ridges::ThirdOrderToSpace(field, p);
  }
  static bool FromSpace(const std::array<double, 21>& values, ridges::MongeForm& form)
  {
    return ridges::ThirdOrderFromSpace(values, form);
  }
  static void StoreHighest(const std::array<double, 21>& values, const ridges::MongeForm&,
    vtkIdType p, SmoothedArrays& out)
  {
    out.StoreP(p, values[19], values[20]);
  }
};

struct FourthOrder
{
  static constexpr int Components = 34;
  static std::array<double, 34> ToSpace(const ridges::MongeField& field, Id p)
  {
    return ridges::FourthOrderToSpace(field, p);
  }
  static bool FromSpace(const std::array<double, 34>& values, ridges::MongeForm& form)
  {
    return ridges::FourthOrderFromSpace(values, form);
  }
  static void StoreHighest(
    const std::array<double, 34>&, const ridges::MongeForm& form, vtkIdType p, SmoothedArrays& out)
  {
    out.StoreFourthOrder(p, form.c);
  }
};

/// Calls body(p) for all points, in parallel; false if the user aborted.
template <typename Body>
bool ForPoints(vtkAlgorithm* filter, vtkIdType count, double from, double to, const Body& body)
{
  const auto range = [&body](vtkIdType begin, vtkIdType end)
  {
    for (auto p = static_cast<Id>(begin); p < end; ++p)
    {
      body(p);
    }
  };
  return vtkRidgesForBatches(filter, count, from, to, range);
}

/// The progress between two values, by parts of the work.
class Progress
{
public:
  Progress(double from, double to)
    : From(from)
    , To(to)
  {
  }
  double At(double part) const { return this->From + part * (this->To - this->From); }

private:
  double From;
  double To;
};

/// Averages forms and gives store(p, values, form, isGood) those of all points; false if the user
/// aborted.
template <typename Forms, typename Store>
bool Smooth(vtkAlgorithm* filter, const ridges::SmoothingPlan& plan,
  const ridges::MongeField& field, const std::vector<std::uint8_t>& usable,
  const Progress& progress, const Store& store)
{
  const auto count = static_cast<vtkIdType>(usable.size());
  ridges::LevelAveraging<Forms::Components> averaging(plan);
  double before = 0.1;
  const auto loop = [filter, &progress, &before](
                      Id cells, double done, const std::function<void(Id, Id)>& body)
  {
    const auto range = [&body](vtkIdType begin, vtkIdType end)
    { body(static_cast<Id>(begin), static_cast<Id>(end)); };
    const double from = before;
    before = 0.1 + 0.7 * done;
    return vtkRidgesForBatches(filter, cells, progress.At(from), progress.At(before), range);
  };
  return ForPoints(filter, count, progress.At(0.0), progress.At(0.1),
           [&averaging, &field, &usable](Id p)
           { averaging.Set(p, Forms::ToSpace(field, p), usable[p] != 0); }) &&
    averaging.Run(loop) &&
    ForPoints(filter, count, progress.At(0.8), progress.At(1.0),
      [&averaging, &store](Id p)
      {
        typename ridges::RingAveraging<Forms::Components>::Values values;
        ridges::MongeForm form;
        const bool isGood = averaging.Get(p, values) && Forms::FromSpace(values, form);
        store(p, values, isGood ? form : ridges::MongeForm(), isGood);
      });
}

struct Task
{
  vtkAlgorithm* filter;
  const vtkRidgesMongeInput& monge;
  const ridges::OneRings& rings;
  const ridges::SmoothingPlan& plan;
  vtkDataArray* status;
  Progress progress;
};

/// Averages and stores forms; false if the user aborted.
template <typename Forms>
bool SmoothAndStore(const Task& task, SmoothedArrays& out)
{
  const auto store = [&task, &out](
                       Id p, const auto& values, const ridges::MongeForm& form, bool isGood)
  {
    const int before = task.status ? static_cast<int>(task.status->GetComponent(p, 0)) : 0;
    out.StoreSecondOrder(p, form);
    if (isGood)
    {
      Forms::StoreHighest(values, form, p, out);
    }
    out.StoreFit(p, isGood ? task.plan.Sigma(p) / ridges::SmoothingPlan::SigmaPerRadius : 0.0,
      isGood ? before : before | ridges::FitInvalid);
  };
  return Smooth<Forms>(task.filter, task.plan, task.monge.arrays.GetField(),
    task.monge.arrays.GetUsable(), { task.progress.At(0.2), task.progress.At(0.7) }, store);
}

bool Differentiate(const Task& task, SmoothedArrays& out)
{
  const auto count = static_cast<vtkIdType>(task.rings.Mesh().NumberOfPoints());
  const ridges::FieldDerivatives derivatives(task.rings, out.View());
  return ForPoints(task.filter, count, task.progress.At(0.7), task.progress.At(0.85),
           [&out, &derivatives](Id p) { out.StoreThirdOrder(p, derivatives.ThirdOrder(p)); }) &&
    ForPoints(task.filter, count, task.progress.At(0.85), task.progress.At(1.0),
      [&out, &derivatives](Id p) { out.StoreFourthOrder(p, derivatives.FourthOrder(p)); });
}

} // namespace

bool vtkRidgesFieldSmoothing::BuildRings(vtkAlgorithm* filter, double from, double to)
{
  const ridges::TriangleMesh& mesh = this->GetMesh();
  const double middle = 0.5 * (from + to);
  this->Ordered = std::make_unique<ridges::OrderedRings>(mesh);
  const auto order = [this](vtkIdType begin, vtkIdType end)
  { this->Ordered->Build(static_cast<Id>(begin), static_cast<Id>(end)); };
  if (!vtkRidgesForBatches(filter, mesh.NumberOfPoints(), from, middle, order))
  {
    return false;
  }
  this->Rings = std::make_unique<ridges::OneRings>(mesh, *this->Ordered);
  const auto measure = [this](vtkIdType begin, vtkIdType end)
  { this->Rings->Build(static_cast<Id>(begin), static_cast<Id>(end)); };
  return vtkRidgesForBatches(filter, mesh.NumberOfPoints(), middle, to, measure);
}

bool vtkRidgesFieldSmoothing::Run(vtkAlgorithm* filter, vtkPolyData* input, const Rule& rule,
  vtkPolyData* output, double from, double to)
{
  this->Monge = std::make_unique<vtkRidgesMongeInput>();
  vtkRidgesMongeInput& monge = *this->Monge;
  if (!(rule.allOrders ? monge.Fetch(filter, input, true) : monge.FetchSecondOrder(filter, input)))
  {
    return false;
  }
  vtkPolyData* mesh = monge.mesh.GetPolyData();
  const vtkIdType count = mesh->GetNumberOfPoints();
  double sigma = rule.sigma;
  if (!(sigma > 0.0) && count > 0)
  {
    sigma = rule.relativeSigma * 2.0 * ridges::SmallestEnclosingSphere(this->GetMesh()).radius;
  }
  vtkNew<vtkDoubleArray> scale;
  vtkDataArray* givenScale = mesh->GetPointData()->GetArray(names::FitScale);
  const bool hasScale = givenScale && givenScale->GetNumberOfComponents() == 1 &&
    givenScale->GetNumberOfTuples() == count;
  if (hasScale)
  {
    scale->DeepCopy(givenScale);
  }
  const double* radii = hasScale ? scale->GetPointer(0) : nullptr;
  const Progress progress(from, to);
  if (!this->BuildRings(filter, progress.At(0.1), progress.At(0.2)))
  {
    return true;
  }
  this->Plan = rule.steps > 0
    ? std::make_unique<ridges::SmoothingPlan>(*this->Rings, radii, rule.steps)
    : std::make_unique<ridges::SmoothingPlan>(*this->Rings, radii, sigma,
        vtkRidgesAbortableLoop(filter, progress.At(0.2), progress.At(0.2)));
  if (vtkRidgesCompatibility::IsAborted(filter))
  {
    return true;
  }
  if (this->Plan->IsCut())
  {
    vtkWarningWithObjectMacro(filter,
      "A scale of " << sigma
                    << " is out of reach on edges so short: FitScale has what was reached (a "
                    << "smaller scale or a coarser mesh helps).");
  }
  const Task task{ filter, monge, *this->Rings, *this->Plan,
    mesh->GetPointData()->GetArray(names::FitStatus), progress };
  const bool hasFourthOrder = monge.arrays.GetField().c != nullptr;
  SmoothedArrays arrays(count, !rule.allOrders || hasFourthOrder);
  const bool isDone = !rule.allOrders
    ? SmoothAndStore<SecondOrder>(task, arrays) && Differentiate(task, arrays)
    : hasFourthOrder ? SmoothAndStore<FourthOrder>(task, arrays)
                     : SmoothAndStore<ThirdOrder>(task, arrays);
  if (isDone)
  {
    output->ShallowCopy(mesh);
    arrays.AddTo(output->GetPointData());
    vtkRidgesUmbilicMarks::RemoveFrom(output);
    monge.mesh.HandOnWith(output);
  }
  return true;
}

bool vtkRidgesFieldSmoothing::SmoothAgain(vtkAlgorithm* filter, const vtkRidgesMongeArrays& arrays,
  const std::function<void(Id, const ridges::MongeForm&)>& store, double from, double to) const
{
  return Smooth<SecondOrder>(filter, *this->Plan, arrays.GetField(), arrays.GetUsable(),
    { from, to },
    [&store](Id p, const auto&, const ridges::MongeForm& form, bool) { store(p, form); });
}
