#include "export/page.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <variant>

#include "export/support.hpp"
#include "sfumato/export/eps/eps.hpp"
#include "sfumato/export/pdf/pdf.hpp"
#include "sfumato/formats/read_document.hpp"
#include "sfumato/solve/diffuse.hpp"

namespace sfumato::test {
namespace {

TEST(InstanceScale, is_the_largest_stretch) {
  EXPECT_EQ(outputs::instance_scale({16, 0, 0, 0.0625, 5, 6}), 16);
  EXPECT_EQ(outputs::instance_scale({0, -16, 0.0625, 0, 5, 6}), 16);
  EXPECT_NEAR(outputs::instance_scale({1, 0, 2, 1, 0, 0}), 1 + std::sqrt(2), 1e-12);
}

TEST(InstanceScale, of_a_similarity_is_the_root_of_its_determinant) {
  const double s = 3 * std::sin(0.3), c = 3 * std::cos(0.3);
  for (const Affine& map : {Affine{c, s, -s, c, 1, 2}, Affine{c, s, s, -c, 1, 2}, Affine{}}) {
    EXPECT_EQ(outputs::instance_scale(map), std::sqrt(std::fabs(map.determinant())));
  }
}

TEST(InstanceScale, of_a_map_that_flattens_is_0) {
  EXPECT_EQ(outputs::instance_scale({3, 0, 0, 0, 1, 2}), 0);
}

/// Returns a circle in its own layer under this map, in a vector format.
template <class Export>
std::size_t triangles_under(const Affine& map, Export export_it) {
  Context context;
  const Result<ReadDocument> read = read_document(
      context,
      R"(<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 64 64" )"
      R"(sf:version="1"><g sf:diffuse="true"><circle cx="32" cy="32" r="20" sf:left="red" )"
      R"(sf:right="gold"/></g></svg>)",
      "a.svg", nullptr);
  EXPECT_TRUE(read.ok());
  Result<Picture> picture = diffuse(context, read->document, {});
  EXPECT_TRUE(picture.ok());
  std::get<PatchInstance>(picture->stack.at(0)).artboard_from_layer = map;
  ExportNotes notes;
  EXPECT_TRUE(export_it(context, *picture, &notes).ok());
  return notes.triangle_count;
}

TEST(Exports, of_a_stretched_layer_are_as_fine_as_its_longest_side_needs) {
  const auto pdf = [](Context& context, const Picture& picture, ExportNotes* notes) {
    return export_pdf(context, picture, {}, notes);
  };
  const auto eps = [](Context& context, const Picture& picture, ExportNotes* notes) {
    return export_eps(context, picture, {}, notes);
  };
  const Affine small{0.25, 0, 0, 0.25, 0, 0}, flat{16, 0, 0, 0.00390625, 0, 0},
      large{16, 0, 0, 16, 0, 0};
  // If the area counted, both would be equal, because `flat` has the area of `small`.
  EXPECT_NE(triangles_under(small, pdf), triangles_under(large, pdf));
  EXPECT_EQ(triangles_under(flat, pdf), triangles_under(large, pdf));
  EXPECT_EQ(triangles_under(flat, eps), triangles_under(large, eps));
}

}  // namespace
}  // namespace sfumato::test
