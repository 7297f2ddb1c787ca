#include "cli/files/solved_input.hpp"

#include <utility>

#include "base/text/number_text.hpp"
#include "cli/files/paths.hpp"

namespace sfumato::cli {
namespace {

/// Returns the options that were given and have no effect on a solved picture: "--rays, --seed".
std::string useless_options(const RenderArguments& arguments) {
  std::vector<std::string> names = arguments.drawing_options;
  // A file that can be enlarged shows everything that was solved.
  const bool shows_all = !options::is_image(arguments.kind);
  if (shows_all && arguments.settings.diffuse.viewport) names.emplace_back("--viewport");
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

}  // namespace

std::string complaint_about_scale(double solved_scale, double drawn_scale) {
  constexpr double kRounding = 1.001;
  if (drawn_scale <= solved_scale * kRounding) return {};
  return "solved for " + rounded_number_text(solved_scale, 3) + " pixels per user unit, drawn at " +
         rounded_number_text(drawn_scale, 3) + "; `sfumato solve --scale` makes a finer one";
}

Result<SolvedInput> read_solved(const Context& context, const std::string& input,
                                const std::string& bytes) {
  PictureOrigin origin;
  Result<Picture> picture = read_picture(
      context, {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, &origin);
  if (picture) return SolvedInput{std::move(*picture), origin};
  Status status = picture.status();
  status.where.file = display_name(input);
  return status;
}

Result<SolvedInput> read_solved(const Context& context, const RenderArguments& arguments,
                                const std::string& bytes) {
  const std::string useless = useless_options(arguments);
  if (useless.empty()) return read_solved(context, arguments.input, bytes);
  return make_error(StatusCode::bad_input,
                    useless +
                        ": only for drawings, but this is a solved picture, "
                        "`sfumato solve` takes them",
                    {display_name(arguments.input)});
}

}  // namespace sfumato::cli
