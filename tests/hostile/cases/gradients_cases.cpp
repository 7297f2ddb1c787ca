// Gradients: chains and cycles of href, invalid stops, frames that vanish.
#include "hostile/case.hpp"
#include "hostile/documents.hpp"

namespace sfumato::hostile {
namespace {

std::string linear(const std::string& attributes, const std::string& content = "<stop/>") {
  return painted("<linearGradient id='p' gradientUnits='userSpaceOnUse' " + attributes + ">" +
                 content + "</linearGradient>");
}

std::string radial(const std::string& attributes) {
  return painted("<radialGradient id='p' gradientUnits='userSpaceOnUse' " + attributes +
                 "><stop/><stop offset='1' stop-color='red'/></radialGradient>");
}

std::string chain(std::size_t length, bool closed) {
  std::string gradients;
  for (std::size_t i = 0; i < length; ++i) {
    gradients += "<linearGradient id='p" + (i == 0 ? "" : std::to_string(i)) + "' href='#p" +
                 (closed && i + 1 == length ? "" : std::to_string(i + 1)) + "'/>";
  }
  return painted(gradients + "<linearGradient id='p" + std::to_string(length) +
                 "'><stop/></linearGradient>");
}

void add_references(Family& family) {
  family.add("of_itself", kBadInput, "go round in a circle: #p → #p", linear("href='#p'"));
  family.add("circle_of_3", kBadInput, "go round in a circle", chain(3, true));
  family.add("circle_of_100000", kLimit, "paints that inherit from each other",
             [] { return chain(100'000, true); });
  family.add("chain_of_250", kDone, "", [] { return chain(250, false); });
  family.add("chain_of_256", kLimit, "more than the limit of 256 paints that inherit",
             [] { return chain(256, false); });
  family.add("href_to_nothing", kBadInput, "no element has that id", linear("href='#q'"));
  family.add("href_to_a_file", kBadInput, "use # and the id", linear("href='a.svg#p'"));
  family.add("href_to_a_pattern", kBadInput, "use a paint of the same kind",
             painted("<linearGradient id='p' href='#q'/><pattern id='q'/>"));
  family.add("href_to_a_path", kBadInput, "use a paint of the same kind",
             painted("<linearGradient id='p' href='#c'/><path id='c'/>"));
  family.add("url_of_nothing", kBadInput, "use url(#id)", curve("sf:left='url()'"));
  family.add("url_of_a_hash", kBadInput, "use url(#id)", curve("sf:left='url(#)'"));
  family.add("url_of_a_file", kBadInput, "use url(#id)", curve("sf:left='url(a.svg#b)'"));
  family.add("url_without_end", kBadInput, "no element has that id", curve("sf:left='url(#p'"));
  family.add("url_of_a_megabyte", kBadInput, "sf:left of <path>",
             [] { return curve("sf:left='url(#" + repeated("x", kMillion) + ")'"); });
  family.add("url_of_a_group", kBadInput, "which is a <g>", painted("<g id='p'/>"));
  family.add("url_of_its_own_curve", kBadInput, "which is a <path>",
             layer("<path id='p' d='M9 9h9' sf:left='url(#p)'/>"));
}

void add_stops(Family& family) {
  family.add("no_stops", kBadInput, "the gradient has no stops", linear("", ""));
  family.add("a_million_stops", kLimit, "more than the limit of 10000 stops in one gradient",
             [] { return linear("x2='99'", repeated("<stop/>", kMillion)); });
  family.add("as_many_stops_as_allowed", kDone, "", [] {
    return linear("x2='99'",
                  repeated("<stop offset='.5'/><stop offset='.5' stop-color='red'/>", 5'000));
  });
  family.add("as_many_stops_in_one_pixel", kDone, "", [] {
    return linear("x2='1e-9' spreadMethod='repeat'",
                  repeated("<stop/><stop offset='1' stop-color='red'/>", 5'000));
  });
  family.add("stops_backwards", kDone, "",
             linear("x2='99'", "<stop offset='1'/><stop offset='0' stop-color='red'/>"));
  for (const auto& [name, text] : {std::pair("nan", "nan"),
                                   {"word", "half"},
                                   {"empty", ""},
                                   {"sign", "%"},
                                   {"beyond_doubles", "1e999"}}) {
    family.add(std::string("offset_") + name, kBadInput, "offset of <stop>",
               linear("", "<stop offset='" + std::string(text) + "'/>"));
    family.add(std::string("stop_opacity_") + name, kBadInput, "stop-opacity of <stop>",
               linear("", "<stop stop-opacity='" + std::string(text) + "'/>"));
    family.add(std::string("stop_color_") + name, kBadInput, "stop-color of <stop>",
               linear("", "<stop stop-color='" + std::string(text) + "'/>"));
  }
  family.add("offset_huge", kDone, "",
             linear("", "<stop offset='1e300'/><stop offset='-1e300%'/>"));
  family
      .add("bounds_of_20000_curves_times_400_stops", kLimit, "memory limit of 128 MiB",
           [] {
             std::string curves;
             for (int i = 0; i < 30'000; ++i) {
               curves += "<path d='M0 0h" + std::to_string(i + 1) + "v9' sf:left='url(#p)'/>";
             }
             return svg("<g sf:diffuse='true'>" + curves + "</g><linearGradient id='p'>" +
                        repeated("<stop/>", 400) + "</linearGradient>");
           })
      .also({"--max-memory", "128"});
  family.add("bounds_of_65_curves", kLimit, "more than the limit of 64 paints in one layer", [] {
    std::string curves;
    for (int i = 0; i < 65; ++i) {
      curves += "<path d='M0 0h" + std::to_string(i + 1) + "v9' sf:left='url(#p)'/>";
    }
    return svg("<g sf:diffuse='true'>" + curves +
               "</g><linearGradient id='p'><stop/>"
               "</linearGradient>");
  });
}

void add_frames(Family& family) {
  family.add("of_no_length", kDone, "", linear("x1='9' x2='9'"));
  family.add("of_a_tiny_length", kDone, "",
             linear("x2='1e-300' spreadMethod='repeat'", "<stop/><stop offset='1'/>"));
  family.add("of_a_huge_length", kDone, "", linear("x1='-9999999' x2='9999999'"));
  family.add("units_unknown", kBadInput, "use userSpaceOnUse or objectBoundingBox",
             painted("<linearGradient id='p' gradientUnits='px'><stop/></linearGradient>"));
  family.add("spread_unknown", kBadInput, "use pad, reflect or repeat",
             linear("spreadMethod='mirror'"));
  family.add("bounds_of_a_straight_line", kBadInput, "has no area for <linearGradient>",
             curve("sf:left='url(#p)'", "<linearGradient id='p'><stop/></linearGradient>"));
  family.add("bounds_of_nearly_a_line", kBadInput, "has no area",
             svg("<g sf:diffuse='true'><path d='M9 9h80v1e-300' sf:left='url(#p)'/></g>"
                 "<linearGradient id='p'><stop/></linearGradient>"));
  family.add("radius_negative", kBadInput, "r is negative", radial("r='-1'"));
  family.add("radius_of_0", kDone, "", radial("r='0'"));
  family.add("radius_tiny", kDone, "", radial("cx='50' cy='25' r='1e-300' spreadMethod='reflect'"));
  family.add("radius_huge", kDone, "", radial("r='9999999'"));
  family.add("focus_outside", kDone, "", radial("r='9' fx='9999999'"));
  family.add("focus_on_the_circle", kDone, "",
             radial("cx='0' cy='0' r='9' fx='9' fy='0' spreadMethod='repeat'"));
  family.add("focus_radius", kDone, "", radial("r='9' fr='99'"));
  family.add("negative_focus_radius", kBadInput, "fr is negative", radial("r='9' fr='-9'"));
  family.add("as_opacity", kDone, "",
             curve("sf:left='red' sf:left-opacity='url(#p)'",
                   "<linearGradient id='p' gradientUnits='userSpaceOnUse'><stop stop-opacity='.5'/>"
                   "</linearGradient>"));
  family.add("as_blur", kBadInput, "sf:blur of <path>", curve("sf:left='red' sf:blur='url(#p)'"));
  family.add("of_a_local_curve", kBadInput, "sf:left of <path>",
             svg("<path d='M9 9h9' sf:left='url(#p)' sf:radius='1'/><linearGradient id='p'/>"));
}

void add_gradients_cases(Family& family) {
  add_references(family);
  add_stops(family);
  add_frames(family);
}

const Register kGradients("gradients", add_gradients_cases);

}  // namespace
}  // namespace sfumato::hostile
