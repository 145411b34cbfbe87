// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMongeSmoothing.h"

#include "Core/Fit/JetFit.h"
#include "Core/Mesh/EnclosingSphere.h"
#include "Core/Mesh/OrderedRings.h"
#include "Core/Salience/FieldDerivatives.h"
#include "Core/Salience/SmoothingPlan.h"
#include "Core/Salience/TensorSmoothing.h"
#include "vtkRidgesArrayNames.h"
#include "vtkRidgesBatches.h"
#include "vtkRidgesFormArrays.h"
#include "vtkRidgesMongeInput.h"
#include "vtkRidgesRequest.h"
#include "vtkRidgesUmbilicMarks.h"

#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <vector>

namespace names = vtkRidgesArrayNames;
using ridges::Id;

vtkStandardNewMacro(vtkMongeSmoothing);

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

struct Task
{
  vtkMongeSmoothing* filter;
  const vtkRidgesMongeInput& monge;
  const ridges::OneRings& rings;
  vtkDataArray* status;
  const double* scale;
  double sigma;
  int steps; ///< 0: as many as sigma needs.
};

/// Averages and stores forms; false if the user aborted.
template <typename Forms>
bool Smooth(const Task& task, SmoothedArrays& out)
{
  const ridges::MongeField& field = task.monge.arrays.GetField();
  const std::vector<std::uint8_t>& usable = task.monge.arrays.GetUsable();
  const auto count = static_cast<vtkIdType>(task.rings.Mesh().NumberOfPoints());
  const ridges::SmoothingPlan plan = task.steps > 0
    ? ridges::SmoothingPlan(task.rings, task.scale, task.steps)
    : ridges::SmoothingPlan(task.rings, task.scale, task.sigma);
  if (plan.IsCut())
  {
    vtkWarningWithObjectMacro(task.filter,
      "A scale of " << task.sigma
                    << " is out of reach on edges so short: the field was smoothed in "
                    << plan.Sweeps().size()
                    << " steps, FitScale has what they reached (a smaller scale or a "
                    << "coarser mesh helps).");
  }
  const std::vector<ridges::AveragingSweep>& sweeps = plan.Sweeps();
  ridges::RingAveraging<Forms::Components> averaging(task.rings, sweeps.front().length > 0);
  if (!ForPoints(task.filter, count, 0.2, 0.25,
        [&averaging, &field, &usable](Id p)
        { averaging.Set(p, Forms::ToSpace(field, p), usable[p] != 0); }) ||
    !ForPoints(task.filter, count, 0.25, 0.3,
      [&averaging, &plan](Id p) { averaging.Prepare(p, plan.Share(p)); }))
  {
    return false;
  }
  double progress = 0.3;
  for (const ridges::AveragingSweep& sweep : sweeps)
  {
    const auto range = [&averaging, &sweep](vtkIdType begin, vtkIdType end)
    { averaging.Step(static_cast<Id>(begin), static_cast<Id>(end), sweep); };
    const double next = progress + 0.3 / static_cast<double>(sweeps.size());
    if (!vtkRidgesForBatches(task.filter, count, progress, next, range))
    {
      return false;
    }
    averaging.Swap(sweep);
    progress = next;
  }
  return ForPoints(task.filter, count, 0.6, 0.7,
    [&averaging, &task, &plan, &out](Id p)
    {
      typename ridges::RingAveraging<Forms::Components>::Values values;
      ridges::MongeForm form;
      const bool good = averaging.Get(p, values) && Forms::FromSpace(values, form);
      const int before = task.status ? static_cast<int>(task.status->GetComponent(p, 0)) : 0;
      out.StoreSecondOrder(p, good ? form : ridges::MongeForm());
      if (good)
      {
        Forms::StoreHighest(values, form, p, out);
      }
      out.StoreFit(p, good ? plan.Sigma(p) / ridges::SmoothingPlan::SigmaPerRadius : 0.0,
        good ? before : before | ridges::FitInvalid);
    });
}

bool Differentiate(const Task& task, SmoothedArrays& out)
{
  const auto count = static_cast<vtkIdType>(task.rings.Mesh().NumberOfPoints());
  const ridges::FieldDerivatives derivatives(task.rings, out.View());
  return ForPoints(task.filter, count, 0.7, 0.85,
           [&out, &derivatives](Id p) { out.StoreThirdOrder(p, derivatives.ThirdOrder(p)); }) &&
    ForPoints(task.filter, count, 0.85, 1.0,
      [&out, &derivatives](Id p) { out.StoreFourthOrder(p, derivatives.FourthOrder(p)); });
}

} // namespace

const char* vtkMongeSmoothing::GetMethodAsString() const
{
  return this->Method == ALL_ORDERS ? "AllOrders" : "SecondOrder";
}

int vtkMongeSmoothing::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkRidgesGetPolyData(this, inputVector[0]);
  if (!input ||
    !vtkRidgesAreNumbers(
      this, { { "Sigma", this->Sigma }, { "RelativeSigma", this->RelativeSigma } }))
  {
    return 0;
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const bool allOrders = this->Method == ALL_ORDERS;

  vtkRidgesMongeInput monge;
  if (!(allOrders ? monge.Fetch(this, input, true) : monge.FetchSecondOrder(this, input)))
  {
    return 0;
  }
  vtkPolyData* mesh = monge.mesh.GetPolyData();
  const ridges::TriangleMesh& triangles = monge.mesh.GetTriangles();
  const vtkIdType count = mesh->GetNumberOfPoints();
  double sigma = this->Sigma;
  if (!(sigma > 0.0) && count > 0)
  {
    sigma = this->RelativeSigma * 2.0 * ridges::SmallestEnclosingSphere(triangles).radius;
  }

  vtkNew<vtkDoubleArray> scale;
  vtkDataArray* givenScale = mesh->GetPointData()->GetArray(names::FitScale);
  const bool hasScale = givenScale && givenScale->GetNumberOfComponents() == 1 &&
    givenScale->GetNumberOfTuples() == count;
  if (hasScale)
  {
    scale->DeepCopy(givenScale);
  }

  ridges::OrderedRings ordered(triangles);
  const auto order = [&ordered](vtkIdType begin, vtkIdType end)
  { ordered.Build(static_cast<Id>(begin), static_cast<Id>(end)); };
  if (!vtkRidgesForBatches(this, count, 0.1, 0.15, order))
  {
    return 1;
  }
  ridges::OneRings rings(triangles, ordered);
  const auto measure = [&rings](vtkIdType begin, vtkIdType end)
  { rings.Build(static_cast<Id>(begin), static_cast<Id>(end)); };
  if (!vtkRidgesForBatches(this, count, 0.15, 0.2, measure))
  {
    return 1;
  }
  const Task task{ this, monge, rings, mesh->GetPointData()->GetArray(names::FitStatus),
    hasScale ? scale->GetPointer(0) : nullptr, sigma, this->NumberOfSteps };
  const bool hasFourthOrder = monge.arrays.GetField().c != nullptr;
  SmoothedArrays arrays(count, !allOrders || hasFourthOrder);
  const bool isDone = !allOrders ? Smooth<SecondOrder>(task, arrays) && Differentiate(task, arrays)
    : hasFourthOrder             ? Smooth<FourthOrder>(task, arrays)
                                 : Smooth<ThirdOrder>(task, arrays);
  if (!isDone)
  {
    return 1;
  }
  output->ShallowCopy(mesh);
  arrays.AddTo(output->GetPointData());
  vtkRidgesUmbilicMarks::RemoveFrom(output);
  monge.mesh.HandOnWith(output);
  return 1;
}

void vtkMongeSmoothing::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->GetMethodAsString() << "\n";
  os << indent << "Sigma: " << this->Sigma << "\n";
  os << indent << "RelativeSigma: " << this->RelativeSigma << "\n";
  os << indent << "NumberOfSteps: " << this->NumberOfSteps << "\n";
}
