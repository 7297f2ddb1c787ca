#include "export/page.hpp"

namespace sfumato::outputs {

Page make_page(const Box& viewport, double unit) {
  return {viewport.width() * unit,
          viewport.height() * unit,
          {unit, 0, 0, unit, -viewport.min.x * unit, -viewport.min.y * unit}};
}

}  // namespace sfumato::outputs
