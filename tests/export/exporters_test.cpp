#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include "export/support.hpp"
#include "raster/pictures.hpp"
#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/export/eps/eps.hpp"
#include "sfumato/export/glb/glb.hpp"
#include "sfumato/export/html/html.hpp"
#include "sfumato/export/pdf/pdf.hpp"
#include "sfumato/export/svg/svg.hpp"
#include "sfumato/export/tables/tables.hpp"

/// Properties of every exporter: the same result for any number of threads, and no harm from
/// pictures that are small, broken, or too large for the memory.
namespace sfumato {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Export = std::function<Result<Bytes>(Context&, const Picture&)>;

struct Exporter {
  const char* name;
  Export write;
};

const Exporter kExporters[] = {
    {"HTML", [](Context& c, const Picture& p) { return export_html(c, p, {}); }},
    {"PDF", [](Context& c, const Picture& p) { return export_pdf(c, p, {}); }},
    {"EPS", [](Context& c, const Picture& p) { return export_eps(c, p, {}); }},
    {"SVG of pixels", [](Context& c, const Picture& p) { return export_svg(c, p, {}); }},
    {"SVG of triangles",
     [](Context& c, const Picture& p) {
       SvgOptions options;
       options.mode = SvgMode::vector;
       options.force = true;
       return export_svg(c, p, options);
     }},
    {"SFV", [](Context& c, const Picture& p) { return export_sfv(c, p, {}); }},
    {"GLB", [](Context& c, const Picture& p) { return export_glb(c, p, {}); }},
    {"NPZ", [](Context& c, const Picture& p) { return export_npz(c, p); }},
    {"JSON", [](Context& c, const Picture& p) { return export_json(c, p); }},
    {"PLY", [](Context& c, const Picture& p) { return export_ply(c, p); }}};

TEST(Exporters, one_triangle_is_written) {
  for (const Exporter& exporter : kExporters) {
    Context context;
    const auto file = exporter.write(context, test::picture_of_one_triangle());
    ASSERT_TRUE(file.ok()) << exporter.name << ": " << to_string(file.status());
    EXPECT_GT(file->size(), 100u) << exporter.name;
    EXPECT_EQ(context.budget.used(), 0u) << exporter.name;
  }
}

TEST(Exporters, refuse_a_picture_for_a_pixel_grid) {
  Picture picture = test::picture_of_one_triangle();
  picture.for_pixel_grid = true;
  for (const Exporter& exporter : kExporters) {
    Context context;
    const Status status = exporter.write(context, picture).status();
    EXPECT_EQ(status.code, StatusCode::bad_input) << exporter.name;
    EXPECT_NE(status.message.find("solve without pixel_grid"), std::string::npos) << exporter.name;
  }
}

TEST(Exporters, write_the_same_for_any_number_of_threads) {
  const auto document = test::example("apple.svg");
  ASSERT_TRUE(document);
  const Picture picture = test::solved(*document);
  ThreadPool pool(3);
  for (const Exporter& exporter : kExporters) {
    Context alone, shared;
    shared.executor = &pool;
    const auto one = exporter.write(alone, picture), three = exporter.write(shared, picture);
    ASSERT_TRUE(one.ok() && three.ok()) << exporter.name;
    EXPECT_TRUE(*one == *three) << exporter.name;
  }
}

/// Expects the limit error, or the whole file if the budget sufficed.
void expect_limit_or(const Bytes& whole, const Exporter& exporter, const Picture& picture,
                     std::size_t budget, std::size_t& successes) {
  Context context{.budget = Budget(budget)};
  const auto file = exporter.write(context, picture);
  if (file.ok()) {
    ++successes;
    EXPECT_TRUE(*file == whole) << exporter.name << " lacks something at " << budget << " bytes";
  } else {
    EXPECT_EQ(file.status().code, StatusCode::limit) << exporter.name;
    EXPECT_EQ(file.status().limit, "memory") << exporter.name;
  }
  EXPECT_EQ(context.budget.used(), 0u) << exporter.name;
}

TEST(Exporters, whatever_the_budget_nothing_is_left_out_in_silence) {
  Picture picture = test::picture_of_one_triangle();
  const PictureItem one = picture.stack.front();
  picture.stack.push_back(GroupBegin{.opacity = 0.5f});
  picture.stack.insert(picture.stack.end(), 20000, one);
  picture.stack.push_back(GroupEnd{});
  for (const Exporter& exporter : kExporters) {
    Context context;
    const auto whole = exporter.write(context, picture);
    ASSERT_TRUE(whole.ok()) << exporter.name << ": " << to_string(whole.status());
    std::size_t successes = 0, tries = 0;
    for (double budget = 20 << 10; successes < 3; budget *= 1.25, ++tries) {
      expect_limit_or(*whole, exporter, picture, static_cast<std::size_t>(budget), successes);
      if (testing::Test::HasFailure()) return;
    }
    EXPECT_GT(tries, 5u) << exporter.name;
  }
}

TEST(Exporters, a_small_budget_is_a_limit_and_nothing_stays_charged) {
  const Picture picture = test::make_picture(
      test::make_layer(test::jittered_grid(test::kTriangleBox, 120, 3), test::sloped));
  for (const Exporter& exporter : kExporters) {
    Context context{.budget = Budget(std::size_t{20} << 10)};
    EXPECT_EQ(exporter.write(context, picture).status().code, StatusCode::limit) << exporter.name;
    EXPECT_EQ(context.budget.used(), 0u) << exporter.name;
  }
}

TEST(Exporters, cancelled_work_ends) {
  const Picture picture = test::make_picture(
      test::make_layer(test::jittered_grid(test::kTriangleBox, 120, 3), test::sloped));
  for (const Exporter& exporter : kExporters) {
    Context context;
    context.cancel = true;
    EXPECT_EQ(exporter.write(context, picture).status().code, StatusCode::cancelled)
        << exporter.name;
  }
}

TEST(Exporters, tables_that_do_not_fit_are_refused) {
  for (const Exporter& exporter : kExporters) {
    const auto refuses = [&](const Picture& picture) {
      Context context;
      return exporter.write(context, picture).status().code == StatusCode::bad_input;
    };
    Picture no_layer = test::picture_of_one_triangle();
    no_layer.stack = {PatchInstance{7, {}, 1, BlendMode::normal}};
    EXPECT_TRUE(refuses(no_layer)) << exporter.name;
    Picture no_node = test::picture_of_one_triangle();
    no_node.layers[0].color.triangle_node[4] = 1000;
    EXPECT_TRUE(refuses(no_node)) << exporter.name;
    Picture no_place = test::picture_of_one_triangle();
    no_place.layers[0].vertex_position[1].x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(refuses(no_place)) << exporter.name;
    Picture no_view = test::picture_of_one_triangle();
    no_view.viewport = {{5, 5}, {5, 9}};
    EXPECT_TRUE(refuses(no_view)) << exporter.name;
    Picture open_group = test::picture_of_one_triangle();
    open_group.stack.insert(open_group.stack.begin(), GroupBegin{});
    EXPECT_TRUE(refuses(open_group)) << exporter.name;
  }
}

TEST(Exporters, node_values_that_are_no_numbers_are_not_written) {
  Picture picture = test::picture_of_one_triangle();
  picture.layers[0].color.node_value[0] = std::numeric_limits<float>::quiet_NaN();
  picture.layers[0].color.node_value[4] = std::numeric_limits<float>::infinity();
  for (const Exporter& exporter : kExporters) {
    Context context;
    const auto file = exporter.write(context, picture);
    ASSERT_TRUE(file.ok()) << exporter.name << ": " << to_string(file.status());
    const std::string text(file->begin(), file->end());
    const std::string name = exporter.name;
    if (name == "JSON" || name.starts_with("SVG of t")) {
      EXPECT_EQ(text.find("nan"), std::string::npos);
      EXPECT_EQ(text.find("inf"), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace sfumato
