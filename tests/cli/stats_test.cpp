#include "cli/stats.hpp"

#include <gtest/gtest.h>

namespace sfumato::cli {
namespace {

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
