// Keeps a drawing solved while it changes (docs/api.md).
#include <cstdio>
#include <sfumato/sfumato.hpp>

using namespace sfumato;

constexpr std::uint32_t kSunLayer = 1;

Document sky_and_sun() {
  Document document;
  document.artboard = {{0, 0}, {400, 300}};  // user units; y points down
  Curve sky = polyline({{-20, -20}, {420, -20}});
  sky.right = colored({rgb(0x1d2b64), rgb(0xff9966)});  // below, along the curve
  add_layer(document, {sky});
  Curve sun =
      bezier({{210, 120}, {210, 67}, {290, 67}, {290, 120}, {290, 173}, {210, 173}, {210, 120}});
  sun.right = colored({rgb(0xfff3c4)});  // inside, as the curve runs clockwise on the screen
  sun.left = colored({rgb(0xffb75e)});
  add_layer(document, {sun});
  return document;
}

/// What a program would draw, or send to a graphics card.
void show(const Picture& picture, const PictureDelta& delta) {
  std::printf("%s%zu of %zu layers are new\n", delta.frame ? "the frame and " : "",
              delta.layers.size(), picture.layers.size());
}

Status run() {
  Context context;
  Result<Solution> solution = Solution::create(context, sky_and_sun());
  if (!solution) return solution.status();
  Status status = solution->solve(context, DiffuseOptions{});
  if (!status) return status;
  show(solution->picture(), solution->take_delta());

  Curve sun = solution->document().layers[kSunLayer].curves[0];
  for (Vec2& point : sun.control_points) point.y += 40;
  // What takes the change back is what an editor's undo keeps.
  const Result<Change> undo = solution->apply(context, ReplaceCurve{kSunLayer, 0, sun});
  if (!undo) return undo.status();
  status = solution->solve(context, DiffuseOptions{});
  if (!status) return status;
  show(solution->picture(), solution->take_delta());  // one layer is new
  return status;
}

int main() {
  const Status status = run();
  if (!status) std::fprintf(stderr, "%s\n", to_string(status).c_str());
  return status ? 0 : 1;
}
