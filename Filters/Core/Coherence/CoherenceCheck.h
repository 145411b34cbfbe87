// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_CoherenceCheck_h
#define ridges_CoherenceCheck_h

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace ridges
{

/// What the ids of offenders number.
enum class OffenderKind
{
  Umbilic,
  Ridge,
  RidgePoint,
  Edge, ///< A pair of points.
  Triangle
};

/// What speaks against coherence, and where.
struct Offender
{
  std::array<std::int32_t, 2> ids; ///< The second one of edges only.
  Eigen::Vector3d position;
};

/// One check of coherence.
struct CoherenceCheck
{
  CoherenceCheck(const char* checkName, const char* sectionOfPaper, OffenderKind kindOfOffenders)
    : name(checkName)
    , section(sectionOfPaper)
    , kind(kindOfOffenders)
  {
  }

  std::string name;
  std::string section; ///< Of RR-5294.
  OffenderKind kind;
  std::string expected;
  std::string found;
  bool applies = true;
  std::vector<Offender> offenders;

  bool Passed() const { return this->offenders.empty(); }
};

} // namespace ridges

#endif
