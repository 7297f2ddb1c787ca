// Drawings that were slow for their size: open sides that rays pass, curves closer than a pixel.
#include "hostile/case.hpp"
#include "hostile/documents.hpp"
#include "hostile/drawings.hpp"

namespace sfumato::hostile {
namespace {

void add_open_sides(Family& family) {
  family.add("stops_1000_on_a_line_open_below", kDone, "",
             [] { return open_below("M9 9h80", 1000); });
  family.add("stops_4000_on_a_line_open_below", kDone, "",
             [] { return open_below("M9 9h80", 4000); });
  family.add("stops_1000_on_a_slanting_line_open_below", kDone, "",
             [] { return open_below("M9 9L90 40", 1000); });
  family.add("stops_1000_on_an_arch_open_below", kDone, "",
             [] { return open_below("M9 40C30 0 60 0 90 40", 1000); });
  family.add("circles_75_open_inside", kDone, "",
             [] { return concentric_circles(75, "sf:left='red'"); });
  family.add("circles_300_open_inside", kDone, "",
             [] { return concentric_circles(300, "sf:left='red'"); });
}

void add_cases(Family& family) {
  add_open_sides(family);
}

const Register kDense("dense", add_cases);

}  // namespace
}  // namespace sfumato::hostile
