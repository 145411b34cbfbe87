// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_MeshCertificate_h
#define ridges_MeshCertificate_h

#include "Base/Monitor.h"
#include "Certification/EdgeCertificate.h"
#include "Certification/TriangleCertificate.h"
#include "Certification/UmbilicCertificate.h"
#include "Mesh/TriangleMesh.h"
#include "Monge/MongeField.h"

#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace ridges
{

/// A mesh on a surface, with exact Monge forms. Normals and directions have 3 values a point.
struct CertifiedInput
{
  const SurfaceBounds& surface;
  const TriangleMesh& mesh;
  const MongeField& field;
  const double* normals;
};

/// An umbilic on the mesh, and its patch.
struct PatchCertificate
{
  UmbilicCertificate umbilic;
  Id triangle;              ///< That contains it.
  std::vector<Id> patch;    ///< A disk of triangles around that one.
  std::uint16_t failed = 0; ///< Bits of Hypothesis.
};

/// All that is known of a mesh.
struct MeshCertificate
{
  std::vector<PatchCertificate> patches;
  std::vector<Id> patchOfTriangle; ///< -1 outside.
  /// Empty inside patches, where hypotheses ask nothing.
  std::vector<std::optional<EdgeCertificate>> edges;
  std::vector<std::optional<TriangleCertificate>> triangles;

  /// All bits that concern a triangle: its own, those of its edges and of its patch.
  std::uint16_t FailedAt(const TriangleMesh& mesh, Id triangle) const;
  bool HoldsEverywhere() const;
};

/// What stays true of edges and triangles while a mesh is refined: they are known by their points,
/// which must not move.
class CertificateMemory
{
public:
  const EdgeCertificate* Find(const Edge& edge) const;
  void Keep(const Edge& edge, const EdgeCertificate& certificate);
  const TriangleCertificate* Find(const Triangle& triangle) const;
  void Keep(const Triangle& triangle, const TriangleCertificate& certificate);

  /// After one of them has moved.
  void Forget(const std::vector<std::uint8_t>& moved);

  /// True the first time, so that umbilics are looked for once from each triangle.
  bool IsNewStart(const Triangle& triangle);

  std::vector<UmbilicCertificate> umbilics;

private:
  struct TriangleHash
  {
    std::size_t operator()(const Triangle& triangle) const;
  };
  static std::uint64_t KeyOf(const Edge& edge);

  std::unordered_map<std::uint64_t, EdgeCertificate> Edges_;
  std::unordered_map<Triangle, TriangleCertificate, TriangleHash> Triangles_;
  std::unordered_set<Triangle, TriangleHash> Starts_;
};

/// Checks all hypotheses. Empty edges and triangles if the monitor stops it.
MeshCertificate CertifyMesh(const CertifiedInput& input, CertificateMemory& memory,
  const RangeLoop& loop, const Monitor& monitor = NeverStops);

} // namespace ridges

#endif
