// Markers of ordinary SVG that `sfumato init --from` draws: many, cyclic, far too large.
#include "hostile/case.hpp"
#include "hostile/documents.hpp"

namespace sfumato::hostile {
namespace {

std::string marked_icon(const std::string& content) {
  return "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>" + content + "</svg>";
}

/// Returns a shape of `count` vertices with marker #m on each, after the content.
std::string marked_path(const std::string& content, std::size_t count) {
  return marked_icon(content + "<path fill='none' style='marker:url(#m)' d='M0 0" +
                     repeated("h1", count - 1) + "'/>");
}

std::string marker(const std::string& content, const std::string& attributes = "") {
  return "<marker id='m' " + attributes + ">" + content + "</marker>";
}

void add_marked(Family& family, std::string name, int exit_code, std::string message,
                Bytes document) {
  family
      .add_call(std::move(name), exit_code, std::move(message),
                {"init", "out.svg", "--from", "in.svg"})
      .with("in.svg", std::move(document));
}

void add_many_markers(Family& family) {
  add_marked(family, "markers_400000", kDone, "more than the limit of 20000 markers",
             [] { return marked_path(marker("<path d='M0 0h1'/>"), 400'000); });
  add_marked(family, "shapes_20000000", kLimit, "more than the limit of 200000 curves",
             [] { return marked_path(marker(repeated("<path d='M0 0h1v1z'/>", 1'000)), 20'000); });
  add_marked(family, "groups_20000000", kLimit, "elements read through markers",
             [] { return marked_path(marker(repeated("<g/>", 1'000)), 20'000); });
  add_marked(family, "of_a_megabyte", kLimit, "bytes read again", [] {
    return marked_icon(marker("", "viewBox='0 0 1 1" + repeated(" ", 1'000'000) + "'") +
                       repeated("<path d='M0 0h9' style='marker:url(#m)'/>", 1'000));
  });
}

void add_marker_circles(Family& family) {
  const std::string of_itself = "<path id='p' d='M0 0h1v1' style='marker:url(#m)'/>";
  add_marked(family, "of_itself", kDone, "", marked_path(marker(of_itself), 9));
  add_marked(family, "of_its_use", kDone, "",
             marked_icon(marker("<use href='#p'/>") + of_itself + "<use href='#p'/>"));
  add_marked(family, "four_in_each_of_four", kDone, "limit of 8 markers within each other", [] {
    std::string markers;
    for (int i = 0; i < 12; ++i) {
      markers += "<marker id='m" + std::to_string(i) + "'><path d='M0 0h1v1h1' fill='none' " +
                 "style='marker:url(#m" + std::to_string(i + 1) + ")'/></marker>";
    }
    return marked_icon(markers + "<path d='M0 0h1v1h1' style='marker:url(#m0)'/>");
  });
}

void add_odd_markers(Family& family) {
  const std::string square = "<path d='M0 0h1v1h-1z'/>";
  add_marked(family, "far_away", kDone, "", marked_path(marker(square, "refX='9999999'"), 9));
  add_marked(family, "of_a_wide_stroke", kDone, "reaches farther than 10000000",
             marked_icon(marker(square, "orient='1e300'") +
                         "<path d='M0 0h9' stroke-width='9999999' style='marker:url(#m)'/>"));
  add_marked(family, "of_nan", kDone, "is left out", marked_path(marker(square, "refX='nan'"), 9));
  add_marked(family, "with_a_mistake_of_sfumato", kBadInput, "use true or false",
             marked_icon(marker("<g xmlns:sf='urn:sfumato:1' sf:diffuse='maybe'/>") +
                         "<g opacity='.5'><path d='M0 0h9' style='marker:url(#m)'/></g>"));
}

void add_markers_cases(Family& family) {
  add_many_markers(family);
  add_marker_circles(family);
  add_odd_markers(family);
}

const Register kMarkers("markers", add_markers_cases);

}  // namespace
}  // namespace sfumato::hostile
