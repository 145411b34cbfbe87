// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ridges_CompliantMesh_h
#define ridges_CompliantMesh_h

#include "Certification/MeshCertificate.h"
#include "Formula/ExactSurface.h"

#include <memory>
#include <vector>

namespace ridges
{

/// On which side of a surface the triangles of a mesh are oriented: 1 if that is along the
/// gradient, -1 if it is against it, 0 if parts of the mesh differ.
int SideOf(const ExactSurface& exact, const TriangleMesh& mesh);

/// A mesh on a surface that grows, with its exact Monge forms.
class CompliantMesh
{
public:
  /// Points are moved to the surface. `isReversed`: normals point against the gradient, as for the
  /// bounds.
  CompliantMesh(const ExactSurface& exact, const SurfaceBounds& bounds, bool isReversed,
    const std::vector<Eigen::Vector3d>& points, std::vector<Triangle> triangles);
  CompliantMesh(const CompliantMesh&) = delete;
  CompliantMesh& operator=(const CompliantMesh&) = delete;

  const std::vector<double>& Points() const { return this->Points_; }
  const std::vector<Triangle>& Triangles() const { return this->Triangles_; }
  const std::vector<MongeForm>& Forms() const { return this->Forms_; }
  const TriangleMesh& Mesh() const { return *this->Mesh_; }
  MongeField Field() const;
  Id NumberOfPoints() const { return static_cast<Id>(this->Points_.size() / 3); }

  /// Of points without a form, which must be none.
  Id NumberOfFaults() const { return this->NumberOfFaults_; }

  /// Checks the hypotheses. What did not change since the last call is not checked again.
  MeshCertificate Certify(const RangeLoop& loop, const Monitor& monitor);

  /**
   * Bisects edges and triangles where a hypothesis fails, and their neighbours as far as needed to
   * bisect triangles by their longest edges only and to leave no hanging points. Vertices on ridges
   * are moved a little, at most three times. False if nothing could be done: only the surface is
   * to blame.
   */
  bool Refine(const MeshCertificate& certificate);

private:
  void AddPoint(const Eigen::Vector3d& position);
  void ComputeForms(Id begin, Id end);
  void Rebuild();
  std::vector<std::uint8_t> MarkEdges(
    const MeshCertificate& certificate, std::vector<std::uint8_t>& moved) const;
  void MarkLongestEdges(std::vector<std::uint8_t>& marked) const;
  Id LongestEdge(Id triangle) const;
  bool IsLong(Id edge) const;
  double DistanceFromRidges(Id point) const;
  void MoveOffRidge(Id point);
  Eigen::Vector3d NewPoint(const Edge& edge, const std::optional<EdgeCertificate>& known) const;
  void Split(const std::vector<Id>& pointOfEdge);

  const ExactSurface& Exact_;
  const SurfaceBounds& Bounds_;
  bool IsReversed_;
  Id NumberOfFaults_ = 0;
  double MeanEdgeAtFirst_ = 0.0;
  std::vector<double> Points_;
  std::vector<MongeForm> Forms_; ///< As a whole, and below for a MongeField.
  std::vector<double> Normals_;
  std::vector<double> D1_;
  std::vector<double> D2_;
  std::vector<double> K1_;
  std::vector<double> K2_;
  std::vector<double> B_;
  std::vector<Triangle> Triangles_;
  std::unique_ptr<TriangleMesh> Mesh_;
  std::vector<std::uint8_t> TimesMoved_; ///< Of points; those added later have not moved.
  CertificateMemory Memory_;
};

} // namespace ridges

#endif
