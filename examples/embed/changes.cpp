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

/// Prints the change. A program would draw it, or send it to a graphics card.
void show(const Picture& picture, const PictureDelta& delta) {
  std::printf("%s%zu of %zu layers are new\n", delta.frame ? "the frame and " : "",
              delta.layers.size(), picture.layers.size());
}

/// Returns the curve after a move of the pointer.
Curve lowered(Curve curve, double by) {
  for (Vec2& point : curve.control_points) point.y += by;
  return curve;
}

Status drag_the_sun(Context& context, Solution& solution) {
  const Curve sun = solution.document().layers[kSunLayer].curves[0];
  Status status = solution.begin_drag(context, kSunLayer, {0});
  for (int y = 0; status && y < 30; y += 10) {
    status = solution.drag(context, {lowered(sun, y)});  // for looking at, while the pointer moves
    show(solution.picture(), solution.take_delta());
  }
  if (status) status = solution.solve(context, DiffuseOptions{});  // once it rests: exact
  solution.end_drag();
  return status;
}

Status run() {
  Context context;
  Result<Solution> solution = Solution::create(context, sky_and_sun());
  if (!solution) return solution.status();
  Status status = solution->solve(context, DiffuseOptions{});
  if (!status) return status;
  show(solution->picture(), solution->take_delta());

  const Curve sun = lowered(solution->document().layers[kSunLayer].curves[0], 40);
  // An editor keeps the inverse change for its undo.
  const Result<Change> undo = solution->apply(context, ReplaceCurve{kSunLayer, 0, sun});
  if (!undo) return undo.status();
  status = solution->solve(context, DiffuseOptions{});
  if (!status) return status;
  show(solution->picture(), solution->take_delta());  // one layer is new
  return drag_the_sun(context, *solution);
}

int main() {
  const Status status = run();
  if (!status) std::fprintf(stderr, "%s\n", to_string(status).c_str());
  return status ? 0 : 1;
}
