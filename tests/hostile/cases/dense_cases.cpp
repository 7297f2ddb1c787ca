// Drawings that were slow for their size: open sides that rays pass, curves closer than a pixel.
#include "hostile/case.hpp"
#include "hostile/documents.hpp"
#include "hostile/drawings.hpp"

namespace sfumato::hostile {
namespace {

void add_open_sides(Family& family) {
  family.add("stops_1000_on_a_line_open_below", kDone, "",
             [] { return open_below("M9 9h80", 1000); });
  family.add("stops_2500_on_a_line_open_below", kDone, "",
             [] { return open_below("M9 9h80", 2500); });
  family.add("stops_1000_on_a_slanting_line_open_below", kDone, "",
             [] { return open_below("M9 9L90 40", 1000); });
  family.add("stops_1000_on_an_arch_open_below", kDone, "",
             [] { return open_below("M9 40C30 0 60 0 90 40", 1000); });
  family.add("circles_75_open_inside", kDone, "",
             [] { return concentric_circles(75, "sf:left='red'"); });
  family.add("circles_15_open_outside", kDone, "",
             [] { return concentric_circles(15, "sf:right='red'"); });
  family.add("circles_300_open_inside", kDone, "",
             [] { return concentric_circles(300, "sf:left='red'"); });
}

/// Many curves per pixel.
void add_close(Family& family) {
  const std::string both = "sf:left='red' sf:right='blue'";
  family.add("circles_300_open_nowhere", kDone, "",
             [both] { return concentric_circles(300, both); });
  family.add("parallels_180_within_20_units", kDone, "",
             [both] { return parallel_lines(180, 20, both); });
  family.add("parallels_180_open_below", kDone, "",
             [] { return parallel_lines(180, 20, "sf:left='red'"); });
  family.add("parallels_100_within_a_unit", kDone, "",
             [both] { return parallel_lines(100, 1, both); });
}

/// All nodes see all curves: inherently quadratic, and ended by the time limit.
void add_dust(Family& family) {
  family.add("dust_200", kDone, "", [] { return dust(200); });
  family.add("dust_120_open_nowhere", kDone, "",
             [] { return dust(120, "sf:left='red' sf:right='blue'"); });
  family.add("dust_20000", kLimit, "the time limit of 1 s is over", [] { return dust(20'000); })
      .also({"--max-time", "1", "--threads", "1"});
  family
      .add("circles_300_open_outside", kLimit, "the time limit of 1 s is over",
           [] { return concentric_circles(300, "sf:right='red'"); })
      .also({"--max-time", "1", "--threads", "1"});
}

void add_dense_cases(Family& family) {
  add_dust(family);
  add_open_sides(family);
  add_close(family);
}

const Register kDense("dense", add_dense_cases);

}  // namespace
}  // namespace sfumato::hostile
