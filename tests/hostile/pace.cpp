#include "hostile/pace.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hostile/documents.hpp"
#include "hostile/drawings.hpp"

namespace sfumato::hostile {
namespace {

/// A short time on any machine, seconds.
constexpr double kLittleSeconds = 0.25;

constexpr std::size_t kElements = 20'000;
constexpr std::size_t kCurves = 40;

/// Returns elements with ids, classes and transforms for the reader, and curves that see each other
/// for meshing and gathering.
std::string reference_drawing() {
  const std::string elements =
      numbered("<g id='a", kElements, "' class='b' transform='scale(1)'/>");
  return svg("<style>.a{stroke:red}.b{fill:blue}</style>" + elements + "<g sf:diffuse='true'>" +
             dust_curves(kCurves, "sf:left='red' sf:right='blue'") + "</g>");
}

}  // namespace

Pace::Pace(const std::string& binary) : binary_(binary) {
  Case reference;
  reference.with("in.svg", reference_drawing);
  if (!sandbox_.prepare(reference)) throw std::runtime_error("the reference cannot be made");
}

double Pace::run() const {
  // Without antialiasing the mesh of all outputs is drawn. Faster pixels do not change its time.
  const Case plain = Case().also({"--no-antialias"});
  const Ended ended = sandbox_.run(binary_, plain.arguments, {});
  if (ended.exit_code != kDone) throw std::runtime_error("the reference fails: " + ended.err);
  return ended.cpu_seconds;
}

double Pace::granted_seconds(double taken) {
  if (taken <= kLittleSeconds) return kLittleSeconds;
  if (std::isfinite(least_) && taken <= kMostReferences * least_) return kMostReferences * least_;
  const double now = run();
  least_ = std::min(least_, now);
  return kMostReferences * now;
}

}  // namespace sfumato::hostile
