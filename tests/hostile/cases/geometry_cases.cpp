// Curves that are hard for meshers: equal, collinear, nearly parallel, thousands of crossings, far
// away.
#include <cmath>
#include <cstdio>

#include "hostile/case.hpp"
#include "hostile/documents.hpp"

namespace sfumato::hostile {
namespace {

std::string precise(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.12g", value);
  return text;
}

std::string line(double x0, double y0, double x1, double y1) {
  return "M" + precise(x0) + " " + precise(y0) + "L" + precise(x1) + " " + precise(y1);
}

/// Returns lines through one point, or nearly.
std::string star(int count, double miss) {
  std::string data;
  for (int i = 0; i < count; ++i) {
    const double angle = 3.14159265358979 * i / count;
    const double x = 50 + miss * std::sin(7.0 * i), y = 25 + miss * std::cos(11.0 * i);
    data += line(x - 60 * std::cos(angle), y - 60 * std::sin(angle), x + 60 * std::cos(angle),
                 y + 60 * std::sin(angle));
  }
  return path(data);
}

std::string parallels(int count, double distance, double slope) {
  std::string data;
  for (int i = 0; i < count; ++i) {
    data += line(5, 25 + distance * i, 95, 25 + distance * i + (i % 2 ? slope : -slope));
  }
  return path(data);
}

std::string spiral(int turns, double pitch) {
  std::string data = "M50 25";
  for (int i = 1; i <= 16 * turns; ++i) {
    const double angle = 3.14159265358979 / 8 * i, radius = pitch * i / 16;
    data +=
        "L" + precise(50 + radius * std::cos(angle)) + " " + precise(25 + radius * std::sin(angle));
  }
  return path(data);
}

void add_degenerate(Family& family) {
  family.add("all_points_equal", kDone, "has a part of no length", path("M9 9C9 9 9 9 9 9"));
  family.add("all_points_nearly_equal", kDone, "", path("M9 9C9 9 9 9 9.0000000000000036 9"));
  family.add("control_points_equal", kDone, "", path("M9 9C9 9 90 40 90 40"));
  family.add("there_and_back", kDone, "", path("M9 9L90 9L9 9L90 9L9 9"));
  family.add("there_and_back_1000", kDone, "",
             [] { return path("M9 9" + repeated("h80h-80", 1000)); });
  family.add("cusp", kDone, "", path("M9 9C100 50 0 50 90 9"));
  family.add("cusp_exact", kDone, "", path("M9 9C90 41 9 41 90 9"));
  family.add("loop_tiny", kDone, "", path("M50 25c1e-9 1e-9 -1e-9 1e-9 0 1e-9"));
  family.add("collinear_cubic_that_folds", kDone, "", path("M9 25C200 25 -100 25 90 25"));
  family.add("collinear_1000", kDone, "", [] {
    std::string data;
    for (int i = 0; i < 1000; ++i) data += line(5 + 0.01 * i, 25, 60 + 0.03 * i, 25);
    return path(data);
  });
  family.add("identical_5000", kDone, "", [] { return path(repeated("M9 9L90 40", 5000)); });
  family.add("identical_curves_2000", kDone, "",
             [] { return path(repeated("M9 9C90 9 9 40 90 40", 2000)); });
  family.add("identical_circles_2000", kDone, "", [] {
    return layer(repeated("<circle cx='50' cy='25' r='20' sf:left='red'/>", 2000));
  });
  family.add("one_point_apart_in_the_last_bit", kDone, "", [] {
    std::string data;
    for (int i = 0; i < 500; ++i) data += line(9, 9 + i * 1.8e-15, 90, 40 - i * 7e-15);
    return path(data);
  });
  family.add("ends_on_the_middle_of_others", kDone, "", [] {
    std::string data;
    for (int i = 0; i < 300; ++i)
      data += line(i * 0.3, 25, i * 0.3, i % 2 ? 0 : 50) + line(0, 25, 99, 25);
    return path(data);
  });
  family.add("corner_of_100_curves", kDone, "", [] { return star(100, 0); });
  family.add("zero_length_handles", kDone, "",
             [] { return path("M9 9" + repeated("c0 0 1 1 1 1c0 0-1-1-1-1", 1000)); });
}

void add_crossing(Family& family) {
  family.add("star_100_through_one_point", kDone, "", [] { return star(100, 0); });
  family.add("star_300_nearly_through_one_point", kDone, "", [] { return star(300, 1e-7); });
  family.add("star_100_through_a_pixel", kDone, "", [] { return star(100, 0.5); });
  family.add("grid_of_60_by_60", kDone, "", [] {
    std::string data;
    for (int i = 0; i < 60; ++i)
      data += line(1.6 * i, 0, 1.6 * i, 50) + line(0, 0.8 * i, 100, 0.8 * i);
    return path(data);
  });
  family.add("parallels_1000_a_hair_apart", kDone, "", [] { return parallels(1000, 1e-9, 0); });
  family.add("parallels_300_that_cross", kDone, "", [] { return parallels(300, 1e-7, 1e-5); });
  family.add("parallels_40_that_weave", kDone, "", [] { return parallels(40, 1e-3, 0.05); });
  family.add("circles_15_about_one_point", kDone, "", [] {
    std::string circles;
    for (int i = 1; i <= 15; ++i) {
      circles += "<circle cx='50' cy='25' r='" + precise(1.5 * i) + "' sf:left='red'/>";
    }
    return layer(circles);
  });
  family.add("circles_1000_of_nearly_one_radius", kDone, "", [] {
    std::string circles;
    for (int i = 0; i < 1000; ++i) {
      circles += "<circle cx='50' cy='25' r='" + precise(20 + 1e-10 * i) + "' sf:left='red'/>";
    }
    return layer(circles);
  });
  family.add("spiral_of_100_turns", kDone, "", [] { return spiral(100, 0.2); });
  family.add("spiral_of_1000_turns_in_a_point", kDone, "", [] { return spiral(1000, 1e-8); });
  family.add("zigzag_500", kDone, "",
             [] { return path("M0 25" + repeated("l.1 20l.1 -20", 250)); });
  family.add("zigzag_of_needles", kDone, "",
             [] { return path("M50 0" + repeated("l1e-7 50l1e-7 -50", 2000)); });
  family.add("comb", kDone, "", [] { return path("M0 0" + repeated("v50h.5v-50h.5", 80)); });
  family.add("dust_1000", kDone, "", [] {
    std::string data;
    for (int i = 0; i < 1000; ++i) {
      data += "M" + precise(std::fmod(i * 61.8034, 100)) + " " + precise(std::fmod(i * 0.05, 50)) +
              "h.001";
    }
    return path(data);
  });
  // Inherently quadratic: only a limit ends the crossings.
  family
      .add("star_3000_in_little_memory", kLimit, "memory limit of 100 MiB",
           [] { return star(3000, 9); })
      .also({"--max-memory", "100"});
}

void add_extent(Family& family) {
  family.add("as_far_as_allowed", kDone, "", path("M-1e7-1e7L1e7 1e7M-1e7 1e7L1e7-1e7"));
  family.add("wave_as_far_as_allowed", kDone, "", path("M-1e7 0C1e7 1e7 -1e7 -1e7 1e7 0"));
  family.add("far_outside_10000", kDone, "",
             [] { return path("M9999999 9999999" + repeated("l-1-1l-1 1", 10'000)); });
  family.add("around_the_artboard_by_far", kDone, "", path("M-1e7-1e7H1e7V1e7H-1e7Z"));
  family.add("tiny_1e-12", kDone, "", path("M50 25l1e-12 0l0 1e-12"));
  family.add("tiny_1e-300", kDone, "", path("M0 0l1e-300 0l0 1e-300"));
  family.add("tiny_beside_huge", kDone, "", path("M50 25l1e-9 1e-9M-1e7 25H1e7"));
  family.add("on_the_border", kDone, "", path("M0 0H100V50H0Z"));
  family.add("blur_over_everything", kDone, "", [] {
    return layer(
        "<path d='M0 25h100' sf:left='red' sf:right='blue' sf:blur='1e7'/><path d='M50 "
        "0v50' sf:left='lime' sf:right='black' sf:blur='1e7'/>");
  });
  family.add("blur_of_1000_curves", kDone, "", [] {
    return layer(
        repeated("<path d='M9 9L90 40' sf:left='red' sf:right='blue' sf:blur='9'/>", 1000));
  });
  family.add("blur_of_every_radius", kDone, "", [] {
    std::string curves;
    for (int i = 0; i < 40; ++i) {
      curves += "<path d='M0 " + precise(i + 5) + "h100' sf:left='red' sf:right='blue' sf:blur='" +
                precise(std::pow(10, i / 10.0 - 2)) + "'/>";
    }
    return layer(curves);
  });
}

/// Returns a circle in a layer under a transform; the artboard shows next to nothing of it.
std::string seen_closely(const std::string& view_box, const std::string& transform,
                         const std::string& circle) {
  return "<svg xmlns='http://www.w3.org/2000/svg' xmlns:sf='urn:sfumato:1' sf:version='1' "
         "viewBox='" +
         view_box + "'><g sf:diffuse='true' transform='" + transform + "'><circle " + circle +
         " sf:left='red' sf:right='blue'/></g></svg>";
}

void add_outside(Family& family) {
  const auto add = [&](const char* name, const std::string& document) {
    family.add(name, kDone, "", document).also({"--width", "24"});
  };
  const std::string circle = "cx='20' cy='44' r='31'";
  add("circle_on_an_artboard_of_1e-3", seen_closely("0 0 1e-3 1e-3", "scale(1)", circle));
  add("circle_on_an_artboard_of_1e-7", seen_closely("0 0 1e-7 1e-7", "scale(1)", circle));
  family.add("circle_on_an_artboard_of_1e-300", kBadInput, "a viewport too small",
             seen_closely("0 0 1e-300 1e-300", "scale(1)", circle));
  add("circle_stretched_60100_times",
      seen_closely("0 0 64 64", "scale(2.3,60100)", "cx='-17' cy='16' r='16'"));
  add("circle_beside_a_narrow_view",
      seen_closely("0 0 64 64", "scale(1090,.015)", "cx='14.8' cy='73.9' r='64'"));
  add("circle_enlarged_2e6_times", seen_closely("0 0 64 64", "scale(2e6)", circle));
}

void add_geometry_cases(Family& family) {
  add_degenerate(family);
  add_crossing(family);
  add_extent(family);
  add_outside(family);
}

const Register kGeometry("geometry", add_geometry_cases);

}  // namespace
}  // namespace sfumato::hostile
