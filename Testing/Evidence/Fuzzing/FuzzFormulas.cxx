// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Formulas as text, on meshes and without, and images. Certificates and meshes of formulas stop at
// a few hundred points.

#include "FuzzData.h"
#include "FuzzTarget.h"

#include "vtkCertifiedRidges.h"
#include "vtkCompliantRefinement.h"
#include "vtkImageMongeForm.h"
#include "vtkImplicitMongeForm.h"
#include "vtkImplicitSurfaceMesh.h"
#include "vtkNew.h"

namespace
{

const char* const Formulas[] = { "x^2/4 + y^2 + z^2/0.36 - 1", "x*y - z", "exp(-x^2) - sqrt(y) + z",
  "log(x) + sin(y)^3 - tan(z)", "x^0.5 + cbrt(y) - acos(z/3)", "((x^2+y^2)^2 - x^2)^2 + z^2 - 0.02",
  "1e300*x^2 + y - z", "x/(y - z)", "-x^-2 + sinh(y)*cosh(z)", "0*x + 1" };

//------------------------------------------------------------------------------
// One of those above, changed at one place; or text.
std::string MakeFormula(FuzzBytes& bytes)
{
  if (bytes.Below(4) == 0)
  {
    return bytes.Text(bytes.Below(64));
  }
  std::string formula = Formulas[bytes.Below(static_cast<int>(std::size(Formulas)))];
  if (bytes.Flag())
  {
    constexpr char likely[] = "xyzuv0123456789.+-*/^()esincotaqrlgp ";
    formula[bytes.Byte() % formula.size()] =
      likely[bytes.Below(static_cast<int>(sizeof(likely)) - 1)];
  }
  return formula;
}

//------------------------------------------------------------------------------
template <typename Filter>
void Certify(vtkPolyData* mesh, FuzzBytes& bytes)
{
  vtkNew<Filter> filter;
  filter->SetSurfaceType(bytes.Below(2));
  filter->SetLevel(bytes.Below(2));
  filter->SetMaximumNumberOfPoints(150);
  filter->SetFormula(MakeFormula(bytes).c_str());
  filter->SetInputData(mesh);
  fuzz::Run(filter, mesh);
}

//------------------------------------------------------------------------------
void RunExactForms(vtkPolyData* mesh, FuzzBytes& bytes)
{
  vtkNew<vtkImplicitMongeForm> forms;
  forms->SetSurfaceType(bytes.Below(3));
  forms->SetFormula(MakeFormula(bytes).c_str());
  forms->SetXFormula(MakeFormula(bytes).c_str());
  forms->SetYFormula("v");
  forms->SetZFormula("u");
  forms->SetInputData(mesh);
  fuzz::Run(forms, mesh);
}

//------------------------------------------------------------------------------
void RunSurfaceMesh(FuzzBytes& bytes)
{
  vtkNew<vtkImplicitSurfaceMesh> source;
  source->SetFormula(MakeFormula(bytes).c_str());
  source->SetBounds(-2.0, bytes.Flag() ? bytes.Number() : 2.0, -2.0, 2.0, -2.0, 2.0);
  source->SetEdgeLength(0.5 + bytes.Byte() / 256.0);
  fuzz::Run(source, nullptr);
}

//------------------------------------------------------------------------------
void RunImage(vtkPolyData* mesh, FuzzBytes& bytes)
{
  vtkNew<vtkImageMongeForm> forms;
  forms->SetSigma(bytes.Flag() ? bytes.Below(4) : 0.0);
  forms->SetIsoValue(bytes.Number());
  forms->SetInputData(0, mesh);
  forms->SetInputData(1, fuzz::MakeImage(bytes));
  fuzz::Run(forms, mesh);
}

} // namespace

//------------------------------------------------------------------------------
std::vector<std::string> FuzzSeeds()
{
  std::vector<std::string> seeds;
  for (char kind = 0; kind < 5; ++kind)
  {
    for (char formula = 0; formula < static_cast<char>(std::size(Formulas)); ++formula)
    {
      std::string seed{ kind, 1, 4, 5, 0, 0, 0, 90, 0, 1, 1 };
      seed += { 0, 1, 1, formula, 0, 1, formula, 0 };
      seed += std::string(200, static_cast<char>(37 * formula));
      seeds.push_back(seed);
    }
  }
  return seeds;
}

//------------------------------------------------------------------------------
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  FuzzBytes bytes(data, size);
  const int kind = bytes.Below(5);
  if (kind == 0)
  {
    RunSurfaceMesh(bytes);
    return 0;
  }
  const auto mesh = fuzz::MakeMesh(bytes);
  switch (kind)
  {
    case 1:
      RunExactForms(mesh, bytes);
      break;
    case 2:
      Certify<vtkCompliantRefinement>(mesh, bytes);
      break;
    case 3:
      Certify<vtkCertifiedRidges>(mesh, bytes);
      break;
    default:
      RunImage(mesh, bytes);
      break;
  }
  return 0;
}
