// Builds a drawing in code and uses every public function on it: outside FOLDER
#include <cmath>
#include <cstdio>
#include <sfumato/sfumato.hpp>
#include <string>

#include "base/status.hpp"
#include "mesh/mesh.hpp"

namespace {

sfumato::Document drawing() {
  using namespace sfumato;
  Document document;
  document.artboard = {{0, 0}, {120, 80}};
  Curve wave = bezier({{10, 40}, {40, 0}, {80, 80}, {110, 40}});
  wave.left = colored({rgb(0xff8800), rgb(0xffee00)});
  wave.right = colored({rgb(0x003366)}, 4);
  Curve frame = polyline({{2, 2}, {118, 2}, {118, 78}, {2, 78}, {2, 2}});
  frame.right = colored({rgb(0xffffff)});
  const std::uint32_t layer = add_layer(document, {frame, wave});
  add_instance(document, layer, {0.2, 0, 0, 0.2, 90, 60}, 0.5f, BlendMode::multiply);
  return document;
}

/// Writes a result's bytes, or prints the error.
bool write(const sfumato::Result<std::vector<std::uint8_t>>& bytes, const std::string& path) {
  const sfumato::Status status = bytes ? sfumato::write_file(path, *bytes) : bytes.status();
  if (!status) std::fprintf(stderr, "%s: %s\n", path.c_str(), to_string(status).c_str());
  return status.ok();
}

/// Checks colours: just above the middle of the wave its left colour shows, and just below it the
/// mean of the left and right colours, by blur.
bool evaluates(sfumato::Context& context, const sfumato::Document& document) {
  using namespace sfumato;
  const auto evaluator = PointEvaluator::create(context, document, {});
  if (!evaluator) return false;
  const std::vector<Vec2> points{{60, 39.99}, {60, 60}};
  std::vector<float> color(3 * points.size());
  std::vector<std::uint8_t> hit(points.size());
  if (!evaluator->evaluate(context, 0, points, color, hit)) return false;
  const bool is_orange = std::fabs(color[0] - 1) < 0.01f && std::fabs(color[1] - 0.73f) < 0.05f;
  const bool is_blue = color[5] > color[3];
  const bool refuses = !evaluator->evaluate(context, 7, points, color, hit).ok();
  return hit[0] && hit[1] && is_orange && is_blue && refuses;
}

bool draws(sfumato::Context& context, const sfumato::Document& document,
           const std::string& folder) {
  using namespace sfumato;
  const Result<Picture> picture = diffuse(context, document, {});
  if (!picture) return false;
  RasterOptions options;
  options.width = 240;
  options.height = 160;
  const Result<Image> image = rasterize(context, *picture, options);
  const Result<Image> exact = render_pixels(context, document, {}, options);
  if (!image || !exact) return false;
  return write(encode_png(context, *image), folder + "/outside.png") &&
         write(export_pdf(context, *picture, {}), folder + "/outside.pdf") &&
         write(export_html(context, *picture, {}), folder + "/outside.html");
}

bool comes_back(sfumato::Context& context, const sfumato::Document& document) {
  using namespace sfumato;
  const Result<std::string> svg = write_svg(context, document);
  if (!svg) return false;
  const Result<ReadDocument> read = read_document(context, *svg, "outside.svg");
  return read && read->warnings.empty() && read->document.layers.size() == 1;
}

bool names_its_limit(const sfumato::Document& document) {
  sfumato::Context context;
  context.limits.curves = 1;
  const sfumato::Result<sfumato::Picture> picture = diffuse(context, document, {});
  return picture.status().limit == "curves" &&
         picture.status().message.find("--") == std::string::npos;
}

}  // namespace

int main(int argc, char** argv) {
  const Mesh own_mesh{3};
  if (argc != 2 || own_mesh.vertex_count != 3) return 2;
  sfumato::ThreadPool pool(2);
  sfumato::Context context;
  context.executor = &pool;
  const sfumato::Document document = drawing();
  const bool is_fine = draws(context, document, argv[1]) && evaluates(context, document) &&
                       comes_back(context, document) && names_its_limit(document);
  const Status own_status = is_fine ? Status::fine : Status::lost;
  return own_status == Status::fine ? 0 : 1;
}
