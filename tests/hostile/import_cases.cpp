// Ordinary SVG made into curves by `sfumato init --from`.
#include "hostile/case.hpp"
#include "hostile/documents.hpp"

namespace sfumato::hostile {
namespace {

constexpr const char* kRoot = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>";

std::string icon(const std::string& content) {
  return kRoot + content + "</svg>";
}

std::string shape(const std::string& data, const std::string& attributes = "") {
  return icon("<path d='" + data + "' " + attributes + "/>");
}

Case& add(Family& family, std::string name, int exit_code, std::string message, Bytes document) {
  return family
      .add_call(std::move(name), exit_code, std::move(message),
                {"init", "out.svg", "--from", "in.svg"})
      .with("in.svg", std::move(document));
}

void add_broken_input(Family& family) {
  add(family, "empty", kBadInput, "the file is empty", "");
  add(family, "no_xml", kBadInput, "no XML element found", "hello");
  add(family, "no_svg", kBadInput, "expected <svg>", "<html/>");
  add(family, "orzan", kBadInput, "expected <svg>", "<curve_set/>");
  add(family, "gzip_cut", kBadInput, "cut short", "\x1f\x8b\x08");
  add(family, "no_size", kBadInput, "has no size", "<svg xmlns='http://www.w3.org/2000/svg'/>");
  add(family, "nothing", kDone, "", kRoot + std::string("</svg>"));
  add(family, "path_of_letters", kDone, "is left out", shape("hello"));
  add(family, "numbers_of_infinity", kDone, "is left out", shape("M0 0L1e999 1"));
  add(family, "far_away", kDone, "is left out", shape("M0 0H1e300V1e300z"));
  add(family, "transform_without_area", kDone, "is left out",
      shape("M0 0H9V9z", "transform='scale(0)'"));
  add(family, "use_of_itself", kBadInput, "goes round in a circle",
      icon("<g id='a'><use href='#a'/><circle r='3'/></g>"));
  add(family, "paint_that_is_missing", kDone, "no element has that id",
      shape("M0 0H9V9z", "fill='url(#nothing)'"));
  add(family, "gradient_of_itself", kDone, "go round in a circle",
      icon("<linearGradient id='a' href='#a'/><rect width='9' height='9' fill='url(#a)'/>"));
}

void add_imported_strokes(Family& family) {
  add(family, "width_of_a_million", kDone, "",
      shape("M0 0L90 90", "stroke='red' stroke-width='1e6'"));
  add(family, "width_of_nearly_nothing", kDone, "",
      shape("M0 0C90 0 0 90 90 90", "fill='none' stroke='red' stroke-width='1e-9'"));
  add(family, "width_below_zero", kDone, "",
      shape("M0 0L90 90", "fill='none' stroke='red' stroke-width='-3'"));
  add(family, "dashes_a_million", kLimit, "dash",
      [] { return shape("M0 0H1e6", "fill='none' stroke='red' stroke-dasharray='.0001'"); });
  add(family, "dashes_of_nothing", kDone, "",
      shape("M0 0H90", "fill='none' stroke='red' stroke-dasharray='0 0'"));
  add(family, "dash_offset_far", kDone, "expected a number",
      shape("M0 0H90", "fill='none' stroke='red' stroke-dasharray='3' stroke-dashoffset='-1e9'"));
  add(family, "scaled_thin", kDone, "",
      shape("M0 0C9 0 0 9 9 9", "stroke='red' transform='scale(1e-6 1e4)'"));
  add(family, "round_joins_of_a_zigzag", kDone, "", [] {
    return shape("M0 0" + repeated("l9 1l-9 1", 2'000),
                 "fill='none' stroke='red' "
                 "stroke-linejoin='round' stroke-linecap='round'");
  });
  add(family, "dots", kDone, "",
      [] { return shape(repeated("M5 5z", 20'000), "stroke='red' stroke-linecap='round'"); });
}

/// Strokes whose outlines are far longer than what is stroked.
void add_long_strokes(Family& family) {
  const std::string stroke = "fill='none' stroke='red' ";
  const auto far_away = [=] {
    return "<svg xmlns='http://www.w3.org/2000/svg' viewBox='9999990 9999990 1e-6 1e-6'><path d='"
           "M9999990 9999990c" +
           repeated("1 0-1 1 0 0 ", 60'000) + "' " + stroke + "/></svg>";
  };
  add(family, "curls_far_away", kLimit, "too long", far_away);
  add(family, "curls_far_away_in_little_memory", kLimit, "memory limit of 64 MiB", far_away)
      .also({"--max-memory", "64"});
  add(family, "curls_far_away_in_little_time", kLimit, "time limit of 0.5 s", far_away)
      .also({"--max-time", ".5"});
  const auto curls = [=] { return shape("M9 9c" + repeated("9 0-9 9 0 0 ", 100'000), stroke); };
  add(family, "curls", kLimit, "too long", curls);
  add(family, "curls_in_little_time", kLimit, "time limit of 0.2 s", curls)
      .also({"--max-time", ".2"});
  const auto dashed_curls = [=] {
    return shape("M9 9c" + repeated("9 0-9 9 0 0 ", 5'000), stroke + "stroke-dasharray='2'");
  };
  add(family, "dashes_of_curls_in_little_time", kLimit, "time limit of 0.3 s", dashed_curls)
      .also({"--max-time", ".3"});
}

void add_many(Family& family) {
  add(family, "circles_in_one_place", kLimit, "2000 layers",
      [] { return icon(repeated("<circle cx='50' cy='50' r='30' fill='red'/>", 2'000)); });
  add(family, "circles_apart", kDone, "",
      [] { return icon(numbered("<circle cy='50' r='.001' fill='red' cx='.", 5'000, "'/>")); });
  add(family, "star_of_2000_points", kLimit, "crosses itself too often", [] {
    std::string data = "M0 50";
    for (int i = 0; i < 2'000; ++i)
      data += "L" + std::to_string(i * 37 % 101) + " " + std::to_string(i * 61 % 97);
    return shape(data + "z");
  });
  add(family, "groups_a_thousand_deep", kLimit, "within each other", [] {
    return icon(repeated("<g opacity='.9'>", 1'000) + "<circle r='9'/>" + repeated("</g>", 1'000));
  });
  add(family, "subpaths_in_each_other", kLimit, "crosses itself too often",
      [] { return shape(numbered("M0 0H9V9H", 5'000, "z"), "fill-rule='evenodd'"); });
  add(family, "gradients_a_thousand", kDone, "", [] {
    return icon(numbered("<linearGradient id='g", 1'000,
                         "'><stop stop-opacity='.5'/><stop offset='1'/></linearGradient>") +
                "<rect width='9' height='9' fill='url(#g7)'/>");
  });
  add(family, "title_of_markup", kDone, "",
      icon("<title>&lt;script&gt;&#27;[2J]]&gt;</title><circle r='9'/>"));
  add(family, "title_of_a_megabyte", kDone, "",
      [] { return icon("<title>" + repeated("&lt;", 250'000) + "</title><circle r='9'/>"); });
}

void add_import_cases(Family& family) {
  add_broken_input(family);
  add_imported_strokes(family);
  add_long_strokes(family);
  add_many(family);
}

const Register kImport("import", add_import_cases);

}  // namespace
}  // namespace sfumato::hostile
