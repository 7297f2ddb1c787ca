/// CGAL's constrained Delaunay triangulation as an independent check (tests only, if installed).
#ifdef SFUMATO_HAVE_CGAL

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "mesh/fuzz_kinds.hpp"
#include "mesh/mesher.hpp"

namespace sfumato::mesh::test {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Base = CGAL::Triangulation_vertex_base_2<Kernel>;
using Faces = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<Base, Faces>, CGAL::No_intersection_tag>;
using Corners = std::array<Vec2, 3>;

struct Before {
  bool operator()(Vec2 a, Vec2 b) const { return a.x != b.x ? a.x < b.x : a.y < b.y; }
};
struct CornersBefore {
  bool operator()(const Corners& a, const Corners& b) const {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), Before{});
  }
};
using TriangleSet = std::set<Corners, CornersBefore>;

Corners sorted(Corners corners) {
  std::sort(corners.begin(), corners.end(), Before{});
  return corners;
}

TriangleSet triangles_of(const TriangleMesh& mesh) {
  TriangleSet set;
  for (std::uint32_t h = 0; h < mesh.triangle_vertex.size(); h += 3) {
    set.insert(sorted({mesh.vertex_position[mesh.origin(h)], mesh.vertex_position[mesh.target(h)],
                       mesh.vertex_position[mesh.apex(h)]}));
  }
  return set;
}

TriangleSet cgal_triangles(const TriangleMesh& mesh) {
  Cdt cdt;
  std::vector<Cdt::Vertex_handle> handles;
  for (const Vec2 p : mesh.vertex_position) handles.push_back(cdt.insert({p.x, p.y}));
  for (const Constraint& c : mesh.constraint) cdt.insert_constraint(handles[c.from], handles[c.to]);
  TriangleSet set;
  for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f) {
    Corners corners;
    for (int k = 0; k < 3; ++k) corners[k] = {f->vertex(k)->point().x(), f->vertex(k)->point().y()};
    set.insert(sorted(corners));
  }
  return set;
}

/// Returns whether another corner of the two sets' differences lies on the circle of `corners`.
bool is_cocircular_with_one_of(const Corners& corners, const std::vector<Vec2>& others) {
  const auto point = [](Vec2 p) { return Kernel::Point_2(p.x, p.y); };
  return std::any_of(others.begin(), others.end(), [&](Vec2 p) {
    return p != corners[0] && p != corners[1] && p != corners[2] &&
           CGAL::side_of_oriented_circle(point(corners[0]), point(corners[1]), point(corners[2]),
                                         point(p)) == CGAL::ON_ORIENTED_BOUNDARY;
  });
}

TEST(Cgal, finds_the_same_triangles_but_for_cocircular_corners) {
  MeshOptions options;
  options.frame = {{0, 0}, {kFuzzSide, kFuzzSide}};
  for (int kind = 0; kind < kFuzzKindCount; ++kind) {
    for (std::uint64_t seed = 100; seed < 105; ++seed) {
      SCOPED_TRACE(testing::Message() << "kind " << kind << " seed " << seed);
      Context context;
      Result<Mesher> mesher =
          Mesher::build(context, fuzz_scene(static_cast<FuzzKind>(kind), seed), options);
      ASSERT_TRUE(mesher.ok()) << mesher.status().message;
      const TriangleMesh mesh = *mesher->visibility_mesh({});
      const TriangleSet ours = triangles_of(mesh);
      const TriangleSet theirs = cgal_triangles(mesh);
      ASSERT_EQ(ours.size(), theirs.size());
      std::vector<Corners> only_ours;
      std::set_difference(ours.begin(), ours.end(), theirs.begin(), theirs.end(),
                          std::back_inserter(only_ours), CornersBefore{});
      std::vector<Vec2> corners;
      for (const Corners& c : only_ours) corners.insert(corners.end(), c.begin(), c.end());
      for (const Corners& c : only_ours) EXPECT_TRUE(is_cocircular_with_one_of(c, corners));
    }
  }
}

}  // namespace
}  // namespace sfumato::mesh::test

#endif
