#include "cli/json.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "cli/stats.hpp"

namespace sfumato::cli {
namespace {

TEST(JsonWriter, separates_members_and_nested_values) {
  JsonWriter json;
  json.begin_object().member("a", 1).key("b").begin_object().member("c", 0.5).end_object();
  json.key("d").begin_array().value(1).value(2).end_array().member("e", "f").end_object();
  EXPECT_EQ(json.text(), R"({"a":1,"b":{"c":0.5},"d":[1,2],"e":"f"})");
}

TEST(JsonWriter, escapes_what_strings_may_not_hold) {
  EXPECT_EQ(JsonWriter().value("a\"b\\c\nd").text(), R"("a\"b\\c\u000ad")");
}

TEST(JsonWriter, writes_null_for_numbers_that_json_has_not) {
  EXPECT_EQ(JsonWriter().value(std::numeric_limits<double>::infinity()).text(), "null");
  EXPECT_EQ(JsonWriter().value(std::numeric_limits<double>::quiet_NaN()).text(), "null");
}

TEST(RenderStats, are_written_in_the_order_of_the_manual) {
  RenderStats stats;
  stats.diffuse = {1, 2, 3, 4, 5, 0.25, 0.5, 0.75};
  stats.threads = 6;
  stats.read_seconds = 1;
  stats.rasterise_seconds = 2;
  stats.write_seconds = 3;
  stats.total_seconds = 8;
  EXPECT_EQ(to_json(stats),
            R"({"curves":1,"segments":2,"triangles":3,"vertices":4,"nodes":5,"threads":6,)"
            R"("seconds":{"read":1,"geometry":0.25,"triangulation":0.5,"gather":0.75,)"
            R"("rasterise":2,"export":0,"write":3,"total":8}})"
            "\n");
}

}  // namespace
}  // namespace sfumato::cli
