// Ordinary SVG converted to curves by `sfumato init --from`.
#include "hostile/case.hpp"
#include "hostile/documents.hpp"
#include "hostile/images.hpp"

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
  add(family, "no_svg", kBadInput, "use <svg>", "<html/>");
  add(family, "orzan", kBadInput, "use <svg>", "<curve_set/>");
  add(family, "gzip_cut", kBadInput, "cut short", "\x1f\x8b\x08");
  add(family, "no_size", kDone, "no size", "<svg xmlns='http://www.w3.org/2000/svg'/>");
  add(family, "no_size_and_far_away", kDone, "farther than",
      "<svg xmlns='http://www.w3.org/2000/svg'><circle cx='1e7' r='1e7'/><circle r='9'/></svg>");
  add(family, "no_size_and_thin", kDone, "no size",
      "<svg xmlns='http://www.w3.org/2000/svg'><path d='M0 0H9e6V1e-9H0'/></svg>");
  add(family, "nothing", kDone, "", kRoot + std::string("</svg>"));
  add(family, "path_of_letters", kDone, "is left out", shape("hello"));
  add(family, "numbers_of_infinity", kDone, "is left out", shape("M0 0L1e999 1"));
  add(family, "far_away", kDone, "is left out", shape("M0 0H1e300V1e300z"));
  add(family, "transform_without_area", kDone, "is left out",
      shape("M0 0H9V9z", "transform='scale(0)'"));
  add(family, "use_of_itself", kDone, "goes round in a circle",
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
  add(family, "width_below_zero", kDone, "it is ignored",
      shape("M0 0L90 90", "fill='none' stroke='red' stroke-width='-3'"));
  add(family, "dashes_a_million", kDone, "more than the limit of 20000 dashes",
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

/// Strokes whose outlines are far longer than their paths.
void add_long_strokes(Family& family) {
  const std::string stroke = "fill='none' stroke='red' ";
  const auto far_away = [=] {
    return "<svg xmlns='http://www.w3.org/2000/svg' viewBox='9999990 9999990 1e-6 1e-6'><path d='"
           "M9999990 9999990c" +
           repeated("1 0-1 1 0 0 ", 60'000) + "' " + stroke + "/></svg>";
  };
  add(family, "curls_far_away", kDone, "its outline is too long", far_away);
  add(family, "curls_far_away_in_little_memory", kLimit, "memory limit of 64 MiB", far_away)
      .also({"--max-memory", "64"});
  add(family, "curls_far_away_in_little_time", kLimit, "time limit of 0.5 s", far_away)
      .also({"--max-time", ".5"});
  const auto curls = [=] { return shape("M9 9c" + repeated("9 0-9 9 0 0 ", 100'000), stroke); };
  add(family, "curls", kDone, "its outline is too long", curls);
  add(family, "curls_in_little_time", kLimit, "time limit of 0.2 s", curls)
      .also({"--max-time", ".2"});
  const auto dashed_curls = [=] {
    return shape("M9 9c" + repeated("9 0-9 9 0 0 ", 5'000), stroke + "stroke-dasharray='2'");
  };
  add(family, "dashes_of_curls_in_little_time", kLimit, "time limit of 0.3 s", dashed_curls)
      .also({"--max-time", ".3"});
}

void add_many(Family& family) {
  add(family, "circles_in_one_place", kLimit,
      "limit of 4096 layers; raise the limit with --limit layers=N",
      [] { return icon(repeated("<circle cx='50' cy='50' r='30' fill='red'/>", 5'000)); });
  add(family, "rings_in_each_other", kDone, "", [] {
    std::string rings;
    for (int i = 1; i < 2'000; ++i) {
      const std::string radius = std::to_string(.02 * i);
      rings += "<circle cx='50' cy='50' r='" + radius + "' fill='none' stroke='red' " +
               "stroke-width='.005'/>";
    }
    return icon(rings);
  });
  add(family, "switches_in_use", kLimit, "elements read through <use>", [] {
    return icon("<g id='a'><switch>" + repeated("<g systemLanguage='x'/>", 10'000) +
                "</switch></g>" + repeated("<use href='#a'/>", 1'000));
  });
  add(family, "contexts_of_laughs", kLimit, "limit", [] {
    return icon(laughs(9, "<circle r='9' fill='context-fill'/>") + "<use href='#g9' fill='red'/>");
  });
  add(family, "contexts_in_each_other", kDone, "", [] {
    std::string uses = "<circle id='u0' r='9' fill='context-fill'/>";
    for (int i = 1; i < 100; ++i) {
      const std::string before = std::to_string(i - 1);
      uses += "<use id='u" + std::to_string(i) + "' fill='context-fill' href='#u" + before + "'/>";
    }
    return icon("<defs>" + uses + "</defs>" + repeated("<use href='#u99' fill='red'/>", 20));
  });
  add(family, "hrefs_of_gradients_200_long", kDone, "", [] {
    std::string chain = "<linearGradient id='g0'><stop/></linearGradient>";
    for (int i = 1; i < 200; ++i) {
      const std::string before = std::to_string(i - 1);
      chain += "<linearGradient id='g" + std::to_string(i) + "' href='#g" + before + "'/>";
    }
    return icon(chain + numbered("<rect fill='url(#g199)' width='1' height='1' x='", 500, "'/>"));
  });
  add(family, "pictures_in_each_other", kDone, "", [] {
    return icon(repeated("<svg width='99%' height='99%' overflow='inherit'>", 150) +
                repeated("<rect width='50%' height='50%'/>", 100) + repeated("</svg>", 150));
  });
  add(family, "circles_apart", kDone, "",
      [] { return icon(numbered("<circle cy='50' r='.001' fill='red' cx='.", 5'000, "'/>")); });
  add(family, "star_of_2000_points", kDone, "it crosses itself too often", [] {
    std::string data = "M0 50";
    for (int i = 0; i < 2'000; ++i)
      data += "L" + std::to_string(i * 37 % 101) + " " + std::to_string(i * 61 % 97);
    return shape(data + "z");
  });
  add(family, "groups_a_thousand_deep", kLimit, "within each other", [] {
    return icon(repeated("<g opacity='.9'>", 1'000) + "<circle r='9'/>" + repeated("</g>", 1'000));
  });
  add(family, "subpaths_in_each_other", kDone, "it crosses itself too often",
      [] { return shape(numbered("M0 0H9V9H", 5'000, "z"), "fill-rule='evenodd'"); });
  add(family, "gradients_a_thousand", kDone, "", [] {
    return icon(numbered("<linearGradient id='g", 1'000,
                         "'><stop stop-opacity='.5'/><stop offset='1'/></linearGradient>") +
                "<rect width='9' height='9' fill='url(#g7)'/>");
  });
  add(family, "uses_of_paths_without_paint", kLimit, "limit of 200000 curves", [] {
    return icon("<g id='a' fill='none'>" + repeated("<path d='M1 1H9V9z'/>", 1'000) + "</g>" +
                repeated("<use href='#a'/>", 998));
  });
  const auto deep = [](const std::string& content, std::size_t count = 200'000) {
    return icon(repeated("<g>", 120) + repeated(content, count) + repeated("</g>", 120));
  };
  add(family, "many_in_120_groups", kDone, "",
      [=] { return deep("<path d='M1 1H9V9z' fill='none'/>"); });
  add(family, "many_in_groups_of_their_own_in_120", kDone, "",
      [=] { return deep("<g><path d='M1 1H9z' fill='none'/></g>"); });
  add(family, "many_strokes_of_em_in_120_groups", kDone, "",
      [=] { return deep("<path d='M1 1H9' stroke='red' fill='none' stroke-width='0em'/>"); });
  add(family, "many_variables_in_120_groups", kDone, "variable-bytes", [=] {
    return deep("<path d='M1 1H9z' fill='var(--a,none)' stroke='var(--a,none)'/>", 120'000);
  });
  add(family, "title_of_markup", kDone, "",
      icon("<title>&lt;script&gt;&#27;[2J]]&gt;</title><circle r='9'/>"));
  add(family, "title_of_a_megabyte", kDone, "",
      [] { return icon("<title>" + repeated("&lt;", 250'000) + "</title><circle r='9'/>"); });
}

void add_imported_images(Family& family) {
  const auto add_image = [&](const char* name, int code, const char* message, Bytes document) {
    add(family, name, code, message, std::move(document)).with("t", good_png());
  };
  const std::string image = "<image href='t' ";
  add_image("image_missing", kDone, "\"u\"", icon("<image href='u'/><circle r='9'/>"));
  add_image("image_above_the_folder", kDone, "is left out", icon("<image href='../../t'/>"));
  add_image("image_of_itself", kDone, "neither a PNG nor a JPEG", icon("<image href='in.svg'/>"));
  add_image("image_tiny", kDone, "is left out", icon(image + "width='1e-300'/>"));
  add_image("image_thin", kDone, "",
            icon(image + "width='1e7' height='1e-7' preserveAspectRatio='none'/>"));
  add_image("image_far_away", kDone, "farther than", icon(image + "x='1e7' width='1e7'/>"));
  add_image("image_flat", kDone, "flattened", icon(image + "transform='scale(1 0)'/>"));
  add_image("image_turned", kDone, "", icon(image + "transform='rotate(1e6)skewX(89)'/>"));
  add_image("images_many", kLimit, "textures",
            [=] { return icon(numbered(image + "x='", 1'000, "'/>")); });
  add_image("images_missing_many", kDone, "is left out",
            [] { return icon(numbered("<image href='u", 10'000, "'/>")); });
  add_image("image_of_laughs", kLimit, "limit",
            [=] { return icon(laughs(9, image + "width='9'/>") + "<use href='#g9'/>"); });
  add(family, "image_of_gigapixels", kLimit, "image", [] {
    return icon("<image href='t'/>");
  }).with("t", [] {
    return png_of_zeros({60'000, 60'000, 8, 6}, 240'001);
  });
}

std::string vector_pattern(const std::string& attributes, const std::string& content) {
  return "<pattern " + attributes + ">" + content + "</pattern>";
}

void add_imported_patterns(Family& family) {
  const std::string tile = "width='9' height='9' patternUnits='userSpaceOnUse' ";
  const std::string filled = "<rect width='90' height='90' fill='url(#p)'/>";
  const std::string dot = "<circle r='3'/>";
  add(family, "pattern_of_itself", kDone, "painted with itself",
      icon(vector_pattern("id='p' " + tile, dot + filled) + filled));
  add(family, "pattern_that_uses_what_it_paints", kDone, "painted with itself",
      icon(vector_pattern("id='p' " + tile, "<use href='#a'/>") +
           "<g id='a'><circle r='40' fill='url(#p)'/></g>"));
  add(family, "patterns_in_patterns", kDone,
      "limit of 64 tiles of patterns and masks; raise the limit pattern-tiles", [=] {
        std::string patterns;
        for (int i = 0; i < 30; ++i) {
          patterns += vector_pattern(
              "id='p" + std::to_string(i) + "' width='.3' height='.3'",
              numbered("<rect fill='url(#p" + std::to_string(i + 1) + ")' height='9' width='1", 10,
                       "'/>"));
        }
        return icon(patterns + "<rect width='90' height='90' fill='url(#p0)'/>");
      });
  add(family, "pattern_at_a_thousand_places", kDone,
      "limit of 64 tiles of patterns and masks; raise the limit pattern-tiles", [=] {
        return icon(vector_pattern("id='p' width='.5' height='.5'", dot) +
                    numbered("<rect fill='url(#p)' height='9' width='1", 1'000, "'/>"));
      });
  add(family, "pattern_huge", kDone, "raise the limit pattern-side",
      icon(vector_pattern("id='p' width='1e7' height='1e7' patternUnits='userSpaceOnUse'", dot) +
           filled));
  add(family, "pattern_tiny", kDone, "too large or too small",
      icon(vector_pattern("id='p' width='1e-7' height='1e-7' patternUnits='userSpaceOnUse'", dot) +
           filled));
  add(family, "pattern_tiny_to_the_end", kDone, "is left out",
      icon(vector_pattern("id='p' width='1e-300' height='1e-300' patternUnits='userSpaceOnUse'",
                          dot) +
           filled));
  add(family, "pattern_far_away", kDone, "too large or too small",
      icon(vector_pattern("id='p' viewBox='0 0 1e-7 1e-7' " + tile, "<circle r='9'/>") + filled));
  add(family, "pattern_of_many_shapes_at_many_places", kDone, "limit of 1000 shapes in patterns",
      [=] {
        return icon(vector_pattern("id='p' width='1' height='1'",
                                   numbered("<circle r='9' cx='", 400, "' stroke='red'/>")) +
                    numbered("<rect fill='url(#p)' height='90' width='1", 60, "'/>"));
      });
  add(family, "patterns_in_each_other", kDone, "limit of 4 patterns and masks within each other",
      [=] {
        std::string patterns;
        for (int i = 0; i < 9; ++i) {
          patterns += vector_pattern("id='p" + std::to_string(i) + "' " + tile,
                                     "<circle r='9' fill='url(#p" + std::to_string(i + 1) + ")'/>");
        }
        return icon(patterns + "<rect width='90' height='90' fill='url(#p0)'/>");
      });
  add(family, "pattern_of_laughs", kLimit, "limit", [=] {
    return icon(laughs(9, dot) + vector_pattern("id='p' " + tile, "<use href='#g9'/>") + filled);
  });
}

void add_import_cases(Family& family) {
  add_broken_input(family);
  add_imported_strokes(family);
  add_long_strokes(family);
  add_many(family);
  add_imported_images(family);
  add_imported_patterns(family);
}

const Register kImport("import", add_import_cases);

}  // namespace
}  // namespace sfumato::hostile
