#include "cli/commands/stats.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "cli/commands/trace_stats.hpp"

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

TEST(TraceStats, of_many_curves_are_read_at_a_glance) {
  TraceFacts facts;
  facts.trace.rounds = {{}, {2, 4, 312, 1'234'567, 5, 30.64, 3}};
  facts.total_seconds = 4.06;
  EXPECT_EQ(summary(facts, "drawing.svg"),
            "drawing.svg: 312 curves, 1,234,567 points, 30.6 dB in 4.1 s");
  facts.trace.rounds = {{0, 1, 1, 1'000, 5, std::numeric_limits<double>::infinity(), 3}};
  EXPECT_EQ(summary(facts, "a.svg"), "a.svg: 1 curve, 1,000 points, no difference in 4.1 s");
}

TEST(TraceStats, are_written_in_the_order_of_the_manual) {
  TraceFacts facts;
  facts.trace = {{{1, 2, 3, 4, 5, 6.5, 7}}, false, 0.5, 0.25, 8, 9};
  facts.threads = 2;
  facts.read_seconds = 1;
  facts.trace_seconds = 2;
  facts.write_seconds = 3;
  facts.total_seconds = 6;
  EXPECT_EQ(to_json(facts, "a.png"),
            R"({"input":"a.png","curves":3,"control_points":4,"stops":5,"psnr_db":6.5,"scale":0.5,)"
            R"("noise":0.25,"median_length_px":8,"curves_of_nine_tenths":9,"threads":2,)"
            R"("rounds":[{"round":1,"curves":3,"control_points":4,"stops":5,"psnr_db":6.5,)"
            R"("seconds":7}],"seconds":{"read":1,"trace":2,"write":3,"total":6}})"
            "\n");
}

}  // namespace
}  // namespace sfumato::cli
