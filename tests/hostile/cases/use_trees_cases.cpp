// `use`: cycles, chains, trees that grow tenfold at each level, and content that is copied often.
#include "hostile/case.hpp"
#include "hostile/documents.hpp"

namespace sfumato::hostile {
namespace {

const std::string kCurve = "<path d='M9 9h9' sf:left='red'/>";

/// Returns `content` used `count` times within a layer (10, 100, … of them).
std::string copied(const std::string& content, int levels) {
  return svg(laughs(levels, content) + "<g sf:diffuse='true'>" + kCurve + "<use href='#g" +
             std::to_string(levels) + "'/></g>");
}

void add_circles(Family& family) {
  family.add("of_itself", kBadInput, "href of <use> leads", svg("<use id='a' href='#a'/>"))
      .message = "goes round in a circle: #a";
  family.add("of_its_group", kBadInput, "goes round in a circle: #a → #a",
             svg("<g id='a'><use href='#a'/></g>"));
  family.add("of_its_root", kBadInput, "goes round in a circle", svg("<use href='#a'/>", "id='a'"));
  family.add("of_two", kBadInput, "goes round in a circle: #b → #a → #b",
             svg("<g id='a'><use href='#b'/></g>\n<g id='b'><use href='#a'/></g>"));
  family.add("of_200", kBadInput, "goes round in a circle", [] {
    std::string groups;
    for (int i = 0; i < 100; ++i) {
      groups += "<g id='g" + std::to_string(i) + "'><use href='#g" + std::to_string((i + 1) % 100) +
                "'/></g>";
    }
    return svg(groups);
  });
  family.add("of_100000", kLimit, "more than the limit of 256 elements within each other", [] {
    std::string groups;
    for (int i = 0; i < 100'000; ++i) {
      groups += "<g id='g" + std::to_string(i) + "'><use href='#g" +
                std::to_string((i + 1) % 100'000) + "'/></g>";
    }
    return svg(groups);
  });
  family.add("of_its_symbol", kBadInput, "goes round in a circle",
             svg("<symbol id='s'><use href='#s'/></symbol><use href='#s'/>"));
  family
      .add("of_its_layer", kBadInput, "goes round in a circle",
           svg("<g id='a' sf:diffuse='true'><use href='#a'/></g>"))
      .message = "in.svg:2";
}

/// Returns one layer that is shown whole and, a hundred thousand times larger, at another place.
std::string at_two_scales(const std::string& place) {
  return svg(
      "<defs><g id='l' sf:diffuse='true'><circle r='30' sf:left='red' sf:right='blue'/></g>"
      "</defs><use href='#l'/><use href='#l' transform='scale(1e5) " +
      place + "'/>");
}

void add_scales(Family& family) {
  family.add("of_two_scales", kDone, "", at_two_scales(""));
  family.add("of_two_scales_at_an_edge", kDone, "", at_two_scales("translate(-18 -24)"));
}

void add_trees(Family& family) {
  family.add("layers_1e9", kLimit, "more than the limit of 400000 elements read through <use>",
             [] { return svg(laughs(9, kLayer) + "<use href='#g9'/>"); });
  family.add("curves_1e9", kLimit, "more than the limit of 400000 elements read through <use>",
             [] { return copied(kCurve, 9); });
  family.add("nothing_1e9", kLimit, "more than the limit of 400000 elements read through <use>",
             [] { return svg(laughs(9, "") + "<use href='#g9'/>"); });
  family.add("local_curves_1e9", kLimit, "more than the limit of 400000 elements",
             [] { return svg(laughs(9, kStroke) + "<use href='#g9'/>"); });
  family.add("groups_1e9", kLimit, "more than the limit of 200000", [] {
    return svg(laughs(9, "<g opacity='.5'>" + kStroke + "</g>") + "<use href='#g9'/>");
  });
  family.add("stops_1e9", kLimit, "bytes read again through <use>", [] {
    return copied("<path d='M9 9h9' sf:left='red" + repeated(",lime", 9'999) + "'/>", 9);
  });
  family.add("unknown_1e9", kLimit, "elements read through <use>",
             [] { return svg(laughs(9, "<text/>") + "<use href='#g9'/>"); });
  family.add("hidden_1e9", kLimit, "elements read through <use>",
             [] { return svg(laughs(9, "<g display='none'/>") + "<use href='#g9'/>"); });
  family.add("symbols_1e9", kLimit, "elements read through <use>", [] {
    std::string symbols = "<symbol id='s0'/>";
    for (int i = 1; i <= 9; ++i) {
      symbols += "<symbol id='s" + std::to_string(i) + "'>" +
                 repeated("<use href='#s" + std::to_string(i - 1) + "'/>", 10) + "</symbol>";
    }
    return svg(symbols + "<use href='#s9'/>");
  });
  family.add("chain_of_100000", kLimit, "more than the limit of 256 elements within each other",
             [] {
               std::string chain = "<g id='g0'/>";
               for (int i = 1; i < 100'000; ++i) {
                 chain += "<g id='g" + std::to_string(i) + "'><use href='#g" +
                          std::to_string(i - 1) + "'/></g>";
               }
               return svg("<defs>" + chain + "</defs><use href='#g99999'/>");
             });
  family.add("chain_of_bare_uses", kLimit, "more than the limit of 256 elements", [] {
    std::string chain = "<g id='u0'/>";
    for (int i = 1; i < 10'000; ++i) {
      chain += "<use id='u" + std::to_string(i) + "' href='#u" + std::to_string(i - 1) + "'/>";
    }
    return svg("<defs>" + chain + "</defs><use href='#u9999'/>");
  });
}

/// Content that is costly to read once, 100,000 times.
void add_costly(Family& family) {
  const std::size_t kLong = 1 << 20;
  const char* limit = "more than the limit of";
  family.add("path_data_of_blanks", kLimit, limit,
             [] { return copied("<path d='M0 0h9" + repeated(" ", kLong) + "'/>", 5); });
  family.add("path_of_no_length", kLimit, limit,
             [] { return copied("<path d='" + repeated("M0 0h0", kLong / 8) + "'/>", 5); });
  family.add("path_of_moves", kLimit, limit,
             [] { return copied("<path d='" + repeated("M0 0", kLong / 4) + "'/>", 5); });
  family.add("points_of_no_length", kLimit, limit,
             [] { return copied("<polyline points='" + repeated("1 1 ", kLong / 4) + "'/>", 5); });
  family.add("style_of_a_megabyte", kLimit, limit,
             [] { return copied("<g style='" + repeated("a:b;", kLong / 4) + "'/>", 5); });
  family.add("class_of_a_megabyte", kLimit, limit, [] {
    return copied("<style>.a{color:red}</style><g class='" + repeated("a ", kLong / 2) + "'/>", 5);
  });
  family.add("transform_of_a_megabyte", kLimit, limit,
             [] { return copied("<g transform='" + repeated("scale(1)", kLong / 8) + "'/>", 5); });
  family.add("attributes_100000", kLimit, limit,
             [] { return copied("<g" + numbered(" a", 100'000, "=''") + "/>", 5); });
  family.add("texts_100000", kLimit, limit,
             [] { return copied("<g>" + repeated("a<!---->", 100'000) + "</g>", 5); });
  family.add("name_of_a_megabyte", kLimit, limit,
             [] { return copied("<" + repeated("a", kLong) + "/>", 5); });
  family.add("stop_list_of_blanks", kLimit, limit, [] {
    return copied("<path d='M0 0h9' sf:left='red" + repeated(" ", kLong) + "'/>", 5);
  });
  family.add("href_of_blanks", kLimit, limit,
             [] { return copied("<g id='e'/><use href='#e" + repeated(" ", kLong) + "'/>", 5); });
  family.add("gradient_of_a_megabyte_used_by_100000_curves", kLimit, limit, [] {
    return svg("<g sf:diffuse='true'>" +
               repeated("<path d='M9 9h9v9' sf:left='url(#p)'/>", 100'000) +
               "</g><linearGradient id='p' gradientUnits='userSpaceOnUse' x2='9' "
               "gradientTransform='" +
               repeated("scale(1)", kLong / 8) + "'><stop/></linearGradient>");
  });
  family
      .add("chain_of_250_gradients_used_by_20000_curves", kLimit,
           "elements read through href of paints",
           [] {
             std::string chain;
             for (int i = 0; i < 250; ++i) {
               chain += "<linearGradient id='p" + std::to_string(i) + "' href='#p" +
                        std::to_string(i + 1) + "'/>";
             }
             return svg("<g sf:diffuse='true'>" +
                        repeated("<path d='M9 9h9' sf:left='url(#p0)'/>", 20'000) + "</g>" + chain +
                        "<linearGradient id='p250' gradientUnits='userSpaceOnUse' x2='9'><stop/>"
                        "</linearGradient>");
           })
      .run({"info", "in.svg"});
}

void add_odd_trees(Family& family) {
  family.add("of_a_shape_outside_of_layers", kBadInput, "stands in no layer",
             svg("<defs>" + std::string("<path id='p' d='M0 0h9' sf:left='red'/>") +
                 "</defs><use href='#p'/>"));
  family.add("of_a_gradient", kDone, "", svg("<linearGradient id='p'/><use href='#p'/>" + kLayer))
      .message = "is drawn nowhere";
  family.add("of_a_style", kDone, "", svg("<style id='s'>a{}</style><use href='#s'/>" + kLayer));
  family.add("without_href", kBadInput, "<use> has no href", svg("<use/>"));
  family.add("of_a_url", kBadInput, "use # and the id", svg("<use href='http://127.0.0.1:1/#a'/>"));
  family.add("at_nan", kBadInput, "x of <use>", svg("<g id='a'/><use href='#a' x='nan'/>"));
  family.add("far_away", kLimit, "shows coordinates of layer \"a\" beyond the limit",
             svg("<defs>" + std::string("<g id='a' sf:diffuse='true'>") + kCurve +
                 "</g></defs><use href='#a' x='9999999' y='-9999999'/>"));
  family.add("farther_and_farther", kBadInput, "too large or too small", [] {
    std::string chain = "<g id='g0' sf:diffuse='true'>" + kCurve + "</g>";
    for (int i = 1; i < 99; ++i) {
      chain += "<g id='g" + std::to_string(i) + "'><use x='999999' href='#g" +
               std::to_string(i - 1) + "'/></g>";
    }
    return svg("<defs>" + chain + "</defs><use href='#g98'/>");
  });
  family.add("with_children", kDone, "is drawn nowhere",
             svg("<g id='a'/><use href='#a'>" + kLayer + "</use>" + kLayer));
}

void add_use_trees_cases(Family& family) {
  add_circles(family);
  add_scales(family);
  add_trees(family);
  add_costly(family);
  add_odd_trees(family);
}

const Register kUseTrees("use_trees", add_use_trees_cases);

}  // namespace
}  // namespace sfumato::hostile
