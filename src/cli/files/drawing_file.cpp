#include "cli/files/drawing_file.hpp"

#include <span>

#include "base/charge.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "cli/files/paths.hpp"
#include "codecs/deflate.hpp"
#include "sfumato/base/native/file.hpp"
#include "sfumato/formats/svg/svg_write.hpp"

namespace sfumato::cli {

Status write_drawing(Context& context, const Document& document, const std::string& output) {
  SFUMATO_TRY_ASSIGN(const std::string& svg, write_svg(context, document));
  ScopedCharge charge;
  SFUMATO_TRY(charge.add(context, capacity_bytes(svg), "the drawing"));
  const std::span text(reinterpret_cast<const std::uint8_t*>(svg.data()), svg.size());
  if (context.cancelled()) return context.cancel_status();
  if (!is_packed_name(output)) return write_file(output, text, &context);
  TableMemory memory("the drawing");
  const auto packed = codecs::gzipped(context, text, memory);
  return packed ? write_file(output, *packed, &context) : packed.status();
}

}  // namespace sfumato::cli
