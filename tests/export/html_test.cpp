// The HTML file as a text; tests/viewer tests the page in a browser.
#include "sfumato/export/html/html.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "codecs/base64.hpp"
#include "display/embedded.hpp"
#include "export/support.hpp"

namespace sfumato {
namespace {

/// Returns one triangle of one colour.
Picture triangle_picture() {
  Picture picture;
  picture.artboard = picture.viewport = {{0, 0}, {10, 10}};
  PatchLayer layer;
  layer.frame = picture.artboard;
  layer.vertex_position = {{0, 0}, {10, 0}, {0, 10}};
  layer.triangle_vertex = {0, 1, 2};
  layer.edge_is_curve = {1, 0, 0};
  layer.color.triangle_node = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  layer.color.node_value.assign(30, 0.5f);
  picture.layers = {layer};
  picture.stack = {PatchInstance{}};
  return picture;
}

std::string html_of(const Picture& picture, const HtmlOptions& options = {}) {
  Context context;
  const auto html = export_html(context, picture, options);
  EXPECT_TRUE(html) << html.status().message;
  EXPECT_EQ(context.budget.used(), 0u);
  return html ? std::string(html->begin(), html->end()) : std::string();
}

TEST(Html, holds_all_that_it_needs) {
  const std::string html = html_of(triangle_picture());
  EXPECT_TRUE(html.starts_with("<!DOCTYPE html>"));
  EXPECT_TRUE(html.ends_with("</html>\n"));
  EXPECT_EQ(html.find("http"), html.find("http-equiv"));
  EXPECT_EQ(test::count(html, " src="), 0u);  // of an element, not of a script
  for (const char* mark : {"{{title", "{{style", "{{fallback", "{{payload", "{{script"})
    EXPECT_EQ(test::count(html, mark), 0u) << mark;
  EXPECT_EQ(test::count(html, "<script"), test::count(html, "</script>"));
  EXPECT_NE(html.find("default-src 'none'"), std::string::npos);
}

TEST(Html, is_the_bundled_page_with_its_marks_filled) {
  const std::string_view bundle = display::page_text("page.html");
  const std::string html = html_of(triangle_picture());
  EXPECT_GT(bundle.size(), 100'000u);
  EXPECT_TRUE(html.starts_with(bundle.substr(0, bundle.find("{{"))));
  EXPECT_TRUE(html.ends_with(bundle.substr(bundle.rfind("}}") + 2)));
}

TEST(Html, a_title_cannot_leave_its_place) {
  const std::string plain = html_of(triangle_picture());
  const std::string html =
      html_of(triangle_picture(), {.title = "\"><script>a()</script>&\n{{payload}}"});
  EXPECT_EQ(test::count(html, "<script"), test::count(plain, "<script"));
  EXPECT_NE(html.find("<title>&quot;&gt;&lt;script&gt;a()&lt;/script&gt;&amp; {{payload}}</title>"),
            std::string::npos);
}

TEST(Html, a_fallback_picture_is_shown_until_the_first_frame) {
  HtmlOptions options;
  options.fallback = {'a', 'b', 'c'};
  options.fallback_type = "image/jpeg";
  const std::string html = html_of(triangle_picture(), options);
  EXPECT_NE(html.find("src=\"data:image/jpeg;base64,YWJj\""), std::string::npos);
  options.fallback_type = "image/jpeg\" onload=\"a()";
  Context context;
  EXPECT_EQ(export_html(context, triangle_picture(), options).status().code, StatusCode::bad_input);
}

TEST(Html, counts_its_triangles) {
  Context context;
  ExportNotes notes;
  ASSERT_TRUE(export_html(context, triangle_picture(), {}, &notes));
  EXPECT_EQ(notes.triangle_count, 1u);
  EXPECT_TRUE(notes.lost.empty());
}

TEST(Html, an_empty_picture_makes_a_page) {
  Picture picture;
  picture.artboard = picture.viewport = {{0, 0}, {10, 10}};
  EXPECT_FALSE(html_of(picture).empty());
}

TEST(Sfv, is_what_the_page_holds_of_the_picture) {
  const Picture picture = triangle_picture();
  for (const std::optional<Rgb> background : {std::optional<Rgb>{}, std::optional(Rgb{1, 0, 0})}) {
    Context context;
    ExportNotes notes;
    const auto file = export_sfv(context, picture, {.background = background}, &notes);
    ASSERT_TRUE(file) << file.status().message;
    EXPECT_EQ(notes.triangle_count, 1u);
    EXPECT_EQ(context.budget.used(), 0u);
    const std::string html = html_of(picture, {.background = background});
    EXPECT_NE(html.find("id=\"payload\">" + codecs::encode_base64(*file) + "</script>"),
              std::string::npos);
  }
}

TEST(Sfv, refuses_what_the_page_refuses) {
  Context context;
  const float bad = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(export_sfv(context, triangle_picture(), {.background = Rgb{bad, 0, 0}}).status().code,
            StatusCode::bad_input);
  Picture picture = triangle_picture();
  picture.layers[0].triangle_vertex[0] = 3;
  EXPECT_EQ(export_sfv(context, picture, {}).status().code, StatusCode::bad_input);
}

TEST(Html, the_same_picture_gives_the_same_bytes) {
  EXPECT_EQ(html_of(triangle_picture()), html_of(triangle_picture()));
}

TEST(Html, refuses_what_does_not_fit_together) {
  Picture picture = triangle_picture();
  picture.layers[0].color.triangle_node[4] = 10;
  Context context;
  EXPECT_EQ(export_html(context, picture, {}).status().code, StatusCode::bad_input);
}

TEST(Html, refuses_a_viewport_without_an_area) {
  Context context;
  Picture picture = triangle_picture();
  picture.viewport = {};
  EXPECT_EQ(export_html(context, picture, {}).status().code, StatusCode::bad_input);
  picture.viewport = {{0, 0}, {0, 10}};
  EXPECT_EQ(export_html(context, picture, {}).status().code, StatusCode::bad_input);
}

TEST(Html, values_that_are_no_numbers_are_not_written) {
  Picture zero = triangle_picture(), odd = zero;
  zero.layers[0].color.node_value[4] = 0;
  odd.layers[0].color.node_value[4] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(html_of(odd), html_of(zero));
  odd.layers[0].color.node_value[4] = std::numeric_limits<float>::infinity();
  EXPECT_FALSE(html_of(odd).empty());
}

/// Returns triangles that share one vertex, one node and one edge; the search for neighbours must
/// not become slow.
Picture many_triangles(std::size_t count) {
  Picture picture = triangle_picture();
  PatchLayer& layer = picture.layers[0];
  layer.triangle_vertex.resize(3 * count);
  layer.edge_is_curve.assign(3 * count, 0);
  for (std::size_t i = 0; i < 3 * count; ++i)
    layer.triangle_vertex[i] = static_cast<std::uint32_t>(i % 3);
  layer.color.triangle_node.assign(kNodesPerTriangle * count, 0);
  return picture;
}

TEST(Html, refuses_five_million_triangles_and_says_what_helps) {
  Context context;
  const Status status = export_html(context, many_triangles(5'000'000), {}).status();
  EXPECT_EQ(status.code, StatusCode::limit);
  EXPECT_NE(status.message.find("5000000 triangles"), std::string::npos);
  EXPECT_EQ(status.limit, "viewer-triangles");
}

TEST(Html, triangles_that_all_lie_on_each_other_are_taken) {
  EXPECT_FALSE(html_of(many_triangles(100'000)).empty());
}

TEST(Html, charges_its_memory) {
  Context context{.budget = Budget(1'000'000)};
  EXPECT_EQ(export_html(context, many_triangles(100'000), {}).status().code, StatusCode::limit);
}

TEST(Html, stops_when_cancelled) {
  Context context;
  context.cancel = true;
  EXPECT_EQ(export_html(context, triangle_picture(), {}).status().code, StatusCode::cancelled);
}

}  // namespace
}  // namespace sfumato
