#include "hostile/documents.hpp"
#include "hostile/drawings.hpp"
#include "hostile/growth.hpp"
#include "hostile/images.hpp"

namespace sfumato::hostile {
namespace {

using Arguments = std::vector<std::string>;

const Arguments kInfo{"info", "in.svg"};
const Arguments kConvert{"convert", "in.svg", "-o", "-"};
const Arguments kLint{"lint", "in.svg"};
const Arguments kRender{"render", "in.svg", "-o", "out.png"};

/// Only text: the parsers' part.
void add_texts(std::vector<Growing>& all) {
  const auto add = [&](const char* name, std::size_t first, std::size_t most, auto document) {
    all.push_back({name, first, most, document, kInfo});
  };
  add("elements", 20'000, 8'000'000, [](std::size_t n) { return svg(repeated("<g/>", n)); });
  add("unknown_names", 10'000, 2'000'000,
      [](std::size_t n) { return svg(numbered("<e", n, "/>")); });
  add("attributes", 50, 20'000, [](std::size_t n) {
    return svg(repeated("<g" + numbered(" a", 1000, "=''") + "/>", n) + kLayer);
  });
  add("declarations", 50, 20'000, [](std::size_t n) {
    return svg(repeated("<g" + numbered(" xmlns:a", 1000, "='b'") + "/>", n) + kLayer);
  });
  add("foreign_elements", 20'000, 4'000'000,
      [](std::size_t n) { return svg(repeated("<o:o/>", n) + kLayer); });
  add("entities", 20'000, 8'000'000, [](std::size_t n) {
    return "<!DOCTYPE svg [<!ENTITY a '" + repeated("x", n) + "'>]>" +
           svg("<g>" + repeated("&a;", n) + "</g>" + kLayer);
  });
  add("comments", 20'000, 8'000'000,
      [](std::size_t n) { return svg(repeated("<!---->", n) + kLayer); });
  add("lines", 1 << 20, 32 << 20,
      [](std::size_t n) { return svg(std::string(n, '\n') + "<text/>" + kLayer); });
  add("unpacked", 100'000, 4'000'000,
      [](std::size_t n) { return gzip(svg("<!--" + numbered("", n, ",") + "-->" + kLayer)); });
  add("members", 2'000, 1'000'000,
      [](std::size_t n) { return gzip(svg(kLayer)) + repeated(gzip(""), n); });
  add("ids", 20'000, 2'000'000,
      [](std::size_t n) { return svg(numbered("<g id='a", n, "'/>") + kLayer); });
  add("equal_ids", 20'000, 4'000'000,
      [](std::size_t n) { return svg(repeated("<g id='a'/>", n) + kLayer); });
  add("rules", 5'000, 90'000, [](std::size_t n) {
    return svg("<style>" + numbered(".a", n, "{b:c}") + "</style>" + kLayer);
  });
  add("selectors_and_blanks", 20'000, 8'000'000, [](std::size_t n) {
    return svg("<style>a" + repeated(",a", n) + "{" + repeated(";", n) + "}</style>" + kLayer);
  });
  add("classes", 5'000, 2'000'000, [](std::size_t n) {
    return svg("<style>.a{fill:red}</style><g class='" + numbered("b", n, " ") + "'/>" + kLayer);
  });
  add("styles", 5'000, 500'000,
      [](std::size_t n) { return svg(repeated("<g style='opacity:1;fill:red'/>", n) + kLayer); });
  add("style", 100'000, 8'000'000, [](std::size_t n) {
    return svg("<g style='" + repeated("a:b;", n) + "'>" + kLayer + "</g>");
  });
  add("transforms", 20'000, 4'000'000, [](std::size_t n) {
    return svg("<g transform='" + repeated("scale(1)", n) + "'>" + kLayer + "</g>");
  });
}

/// Documents of many parts, read.
void add_documents(std::vector<Growing>& all) {
  const auto add = [&](const char* name, std::size_t first, std::size_t most, auto document) {
    all.push_back({name, first, most, document, kInfo});
  };
  add("curves", 5'000, 200'000, [](std::size_t n) { return dust(n); });
  add("subpaths", 5'000, 200'000, [](std::size_t n) { return path(repeated("M9 9h9", n)); });
  add("path_lines", 50'000, 1'300'000,
      [](std::size_t n) { return path("M0 0" + repeated("l1 1l-1-1", n / 2)); });
  add("path_arcs", 10'000, 300'000,
      [](std::size_t n) { return path("M0 0" + repeated("a9 5 30 1 1 3 0", n)); });
  add("path_moves", 50'000, 8'000'000, [](std::size_t n) { return path(repeated("M0 0", n)); });
  add("points", 50'000, 1'300'000, [](std::size_t n) {
    return layer("<polyline sf:left='red' points='" + repeated("1 1 2 2 ", n / 2) + "'/>");
  });
  add("digits", 1 << 20, 32 << 20,
      [](std::size_t n) { return path("M0 0h9." + repeated("1", n)); });
  add("stops_of_curves", 20, 800, [](std::size_t n) {
    return layer(repeated("<path d='M9 9h9' sf:left='red" + repeated(",blue", 9'000) + "'/>", n));
  });
  add("gradients", 2'000, 64'000, [](std::size_t n) {
    return svg(kLayer + numbered("<linearGradient id='p", n, "'><stop/></linearGradient>"));
  });
  add("curves_of_a_chain", 500, 4'000, [](std::size_t n) {
    std::string chain;
    for (int i = 0; i < 200; ++i) {
      chain += "<linearGradient id='p" + std::to_string(i) + "' href='#p" + std::to_string(i + 1) +
               "'/>";
    }
    return svg("<g sf:diffuse='true'>" + repeated("<path d='M9 9h9' sf:left='url(#p0)'/>", n) +
               "</g>" + chain +
               "<linearGradient id='p200' gradientUnits='userSpaceOnUse' x2='9'>"
               "<stop/></linearGradient>");
  });
  add("uses", 5'000, 200'000, [](std::size_t n) {
    return svg("<defs><g id='a' sf:diffuse='true'><path d='M9 9h9' sf:left='red'/></g></defs>" +
               repeated("<use href='#a'/>", n));
  });
  add("uses_of_curves", 5'000, 200'000, [](std::size_t n) {
    return svg("<defs><path id='a' d='M9 9h9' sf:left='red'/></defs><g sf:diffuse='true'>" +
               repeated("<use href='#a'/>", n) + "</g>");
  });
  add("local_curves", 5'000, 200'000, [](std::size_t n) { return svg(repeated(kStroke, n)); });
  add("groups", 2'000, 40'000, [](std::size_t n) {
    return svg(repeated("<g opacity='.5'>" + kStroke + kStroke + "</g>", n));
  });
  add("orzan_curves", 2'000, 200'000,
      [](std::size_t n) { return orzan(repeated(orzan_curve(), n)); });
  add("orzan_points", 20'000, 500'000, [](std::size_t n) {
    return orzan("<curve><control_points_set>" +
                 numbered("<control_point x='9' y='1", 3 * n + 1, "e-9'/>") +
                 "</control_points_set></curve>");
  });
  add("png_pixels", 250'000, 16'000'000, [](std::size_t n) {
    const auto height = static_cast<std::uint32_t>(n / 1000);
    return textured("data:;base64," + base64(png_of_zeros({1000, height, 8, 2}, 3000)));
  });
  add("jpeg_pixels", 250'000, 16'000'000, [](std::size_t n) {
    return textured("data:;base64," +
                    base64(jpeg(1000, static_cast<int>(n / 1000), 3, JpegKind::baseline)));
  });
  add("data_uri", 1 << 20, 32 << 20, [](std::size_t n) {
    const std::string good = good_png();
    return textured(
        "data:;base64," +
        base64(good.substr(0, 33) + png_chunk("abCd", std::string(n, 'x')) + good.substr(33)));
  });
}

/// Documents drawn, written back, and checked for hints. The picture's area is constant.
void add_work(std::vector<Growing>& all) {
  const auto add = [&](const char* name, std::size_t first, std::size_t most,
                       const Arguments& arguments, auto document) {
    all.push_back({name, first, most, document, arguments});
  };
  add("drawn_twice_the_same", 2'000, 200'000, kRender,
      [](std::size_t n) { return path(repeated("M9 9L90 40", n)); });
  add("drawn_local_curves", 500, 100'000, kRender,
      [](std::size_t n) { return svg(repeated(kStroke, n)); });
  add("drawn_instances", 250, 100'000, kRender, [](std::size_t n) {
    return svg("<defs><g id='a' sf:diffuse='true'><path d='M9 9h9' sf:left='red'/></g></defs>" +
               repeated("<use href='#a'/>", n));
  });
  // Closer than half a pixel from the beginning.
  add("drawn_circles_open_inside", 200, 2'000, kRender,
      [](std::size_t n) { return concentric_circles(n, "sf:left='red'"); });
  add("drawn_circles", 200, 2'000, kRender,
      [](std::size_t n) { return concentric_circles(n, "sf:left='red' sf:right='blue'"); });
  add("drawn_parallels_open_below", 200, 4'000, kRender,
      [](std::size_t n) { return parallel_lines(n, 20, "sf:left='red'"); });
  add("drawn_parallels", 200, 4'000, kRender,
      [](std::size_t n) { return parallel_lines(n, 20, "sf:left='red' sf:right='blue'"); });
  add("converted_curves", 2'000, 100'000, kConvert, [](std::size_t n) { return dust(n); });
  add("converted_ids", 2'000, 100'000, kConvert, [](std::size_t n) {
    return layer("<path id='a' d='" + repeated("M9 9h9", n) + "' sf:left='red'/>" +
                 numbered("<path id='a-", n, "' d='M9 9h9' sf:left='red'/>"));
  });
  add("linted_curves", 1'000, 50'000, kLint, [](std::size_t n) { return dust(n); });
  add("linted_equal_curves", 1'000, 50'000, kLint,
      [](std::size_t n) { return layer(repeated("<path sf:left='red' d='M9 9h9'/>", n)); });
}

}  // namespace

std::vector<Growing> all_growing() {
  std::vector<Growing> all;
  add_texts(all);
  add_documents(all);
  add_work(all);
  return all;
}

}  // namespace sfumato::hostile
