// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_PatchSearch_h
#define ridges_PatchSearch_h

#include "Certification/MeshCertificate.h"

#include <functional>

namespace ridges
{

MappedTriangle MappedTriangleOf(const CertifiedInput& input, const Triangle& corners);
double LongestSide(const TriangleMesh& mesh, Id triangle);

/**
 * Patches around umbilics for which hypotheses 2.2a to 2.2c hold: rings of triangles whose images
 * are in the disk where all ridges are known to end at the umbilic, with as many crossings on the
 * border as ridges. All ridges in such a patch are arcs from the umbilic to the border.
 */
class PatchSearch
{
public:
  PatchSearch(const CertifiedInput& input, const CertificateMemory& memory)
    : Input_(input)
    , Memory_(memory)
  {
  }

  /// Puts certificates of these edges or triangles into the memory.
  using Certify = std::function<void(const std::vector<Id>&)>;

  /// Umbilics that are not on the mesh are left out.
  std::vector<PatchCertificate> Find(const std::vector<UmbilicCertificate>& umbilics,
    const Certify& certifyEdges, const Certify& certifyTriangles);

private:
  Id TriangleOf(const UmbilicCertificate& umbilic) const;
  std::vector<Id> RingsAround(Id triangle, int rings) const;
  void Choose(
    const Certify& certifyEdges, const Certify& certifyTriangles, PatchCertificate& found) const;
  bool IsIsolatedFrom(const std::vector<Id>& patch, const std::vector<Id>& wider) const;
  bool IsInDisk(const UmbilicCertificate& umbilic, Id triangle) const;
  bool IsDisk(const std::vector<Id>& patch) const;
  std::vector<Id> BorderOf(const std::vector<Id>& patch) const;
  std::uint16_t FailedOnBorder(
    const UmbilicCertificate& umbilic, const std::vector<Id>& border) const;

  const CertifiedInput& Input_;
  const CertificateMemory& Memory_;
};

} // namespace ridges

#endif
