#include <optional>
#include <utility>

#include "base/limit_error.hpp"
#include "base/text/number.hpp"
#include "base/try.hpp"
#include "formats/css/tokenizer.hpp"
#include "formats/svg/read/scanner.hpp"
#include "formats/svg/shapes/path.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::svg {
namespace {

class PathReader {
 public:
  PathReader(const Context& context, std::string_view text, TableMemory& memory)
      : context_(context), poll_(context), scanner_(text), builder_(context, memory) {}

  /// mistake   as in parse_path()
  Result<std::vector<Subpath>> read(Status* mistake);

 private:
  Status read_commands();
  Status take_command();
  Status draw();
  Status draw_line();
  Status draw_cubic(bool smooth);
  Status draw_quadratic(bool smooth);
  Status draw_arc();
  Status take_point(Vec2& point);
  Status take_number(double& value);
  bool next_is_number() const;

  const Context& context_;
  css::TextPoll poll_;
  Scanner scanner_;
  PathBuilder builder_;
  char command_ = 0;  ///< in upper case
  bool relative_ = false;
  bool first_ = true;                        ///< nothing was read since the command's letter
  std::optional<Vec2> cubic_control_{};      ///< the last C or S: what S mirrors
  std::optional<Vec2> quadratic_control_{};  ///< the last Q or T: what T mirrors
};

bool PathReader::next_is_number() const {
  const char c = scanner_.peek();
  return is_digit(c) || c == '.' || c == '-' || c == '+';
}

Result<std::vector<Subpath>> PathReader::read(Status* mistake) {
  scanner_.skip_blanks();
  if (scanner_.rest() == "none") return std::vector<Subpath>();
  Status status = read_commands();
  if (mistake && status.code == StatusCode::bad_input) std::swap(*mistake, status);
  if (!status) return status;
  return builder_.take();
}

Status PathReader::read_commands() {
  while (!scanner_.at_end()) {
    const std::size_t begin = scanner_.position();
    SFUMATO_TRY(take_command());
    SFUMATO_TRY(draw());
    if (!builder_.status()) return builder_.status();
    if (builder_.control_point_count() > context_.limits.control_points) {
      return limit_error(context_.limits, &Limits::control_points, "control points");
    }
    if (builder_.subpath_count() > context_.limits.curves) {
      return limit_error(context_.limits, &Limits::curves, "curves");
    }
    scanner_.skip_blanks();
    if (!poll_.go_on(scanner_.position() - begin)) return context_.cancel_status();
  }
  return ok_status();
}

/// Reads a letter, or none if the last command continues.
Status PathReader::take_command() {
  const char c = scanner_.peek();
  const char upper = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  if (std::string_view("MZLHVCSQTA").find(upper) == std::string_view::npos || c == '\0') {
    const bool goes_on = command_ != 0 && command_ != 'Z';
    if (goes_on && (next_is_number() || c == ',')) {
      if (command_ == 'M') command_ = 'L';
      first_ = false;
      return ok_status();
    }
    return scanner_.error(command_ == 0 ? "M or m" : "a path command, one of MmLlHhVvCcSsQqTtAaZz");
  }
  if (command_ == 0 && upper != 'M') return scanner_.error("M or m");
  scanner_.take(c);
  command_ = upper;
  relative_ = c != upper;
  first_ = true;
  return ok_status();
}

Status PathReader::draw() {
  const std::optional<Vec2> last_cubic = std::exchange(cubic_control_, std::nullopt);
  const std::optional<Vec2> last_quadratic = std::exchange(quadratic_control_, std::nullopt);
  switch (command_) {
    case 'Z':
      builder_.close();
      return ok_status();
    case 'C':
    case 'S':
      cubic_control_ = last_cubic;
      return draw_cubic(command_ == 'S');
    case 'Q':
    case 'T':
      quadratic_control_ = last_quadratic;
      return draw_quadratic(command_ == 'T');
    case 'A':
      return draw_arc();
    default:
      return draw_line();
  }
}

Status PathReader::draw_line() {
  Vec2 point = builder_.current();
  if (command_ == 'H' || command_ == 'V') {
    double& axis = command_ == 'H' ? point.x : point.y;
    const double origin = relative_ ? axis : 0;
    SFUMATO_TRY(take_number(axis));
    axis += origin;
  } else {
    SFUMATO_TRY(take_point(point));
  }
  if (command_ == 'M') {
    builder_.move_to(point);
  } else {
    builder_.line_to(point);
  }
  return ok_status();
}

Status PathReader::draw_cubic(bool smooth) {
  const Vec2 from = builder_.current();
  Vec2 control1 = cubic_control_ ? 2 * from - *cubic_control_ : from;
  Vec2 control2, point;
  SFUMATO_TRY(smooth ? ok_status() : take_point(control1));
  SFUMATO_TRY(take_point(control2));
  SFUMATO_TRY(take_point(point));
  builder_.cubic_to(control1, control2, point);
  cubic_control_ = control2;
  return ok_status();
}

Status PathReader::draw_quadratic(bool smooth) {
  const Vec2 from = builder_.current();
  Vec2 control = quadratic_control_ ? 2 * from - *quadratic_control_ : from;
  Vec2 point;
  SFUMATO_TRY(smooth ? ok_status() : take_point(control));
  SFUMATO_TRY(take_point(point));
  builder_.quadratic_to(control, point);
  quadratic_control_ = control;
  return ok_status();
}

Status PathReader::draw_arc() {
  Vec2 radii, point;
  double rotation_degrees = 0;
  bool large = false, sweep = false;
  Status status = take_number(radii.x);
  if (status) status = take_number(radii.y);
  if (status) status = take_number(rotation_degrees);
  scanner_.skip_separator();
  if (status) status = scanner_.take_flag(large);
  scanner_.skip_separator();
  if (status) status = scanner_.take_flag(sweep);
  if (status) status = take_point(point);
  if (status) builder_.arc_to(radii, rotation_degrees, large, sweep, point);
  return status;
}

/// A number that is no coordinate: the same in relative commands.
Status PathReader::take_number(double& value) {
  if (first_) {
    scanner_.skip_blanks();
  } else {
    scanner_.skip_separator();
  }
  first_ = false;
  return scanner_.take_number(value);
}

Status PathReader::take_point(Vec2& point) {
  const Vec2 origin = relative_ ? builder_.current() : Vec2{};
  Vec2 written;
  SFUMATO_TRY(take_number(written.x));
  SFUMATO_TRY(take_number(written.y));
  point = origin + written;
  return ok_status();
}

}  // namespace

Result<std::vector<Subpath>> parse_path(const Context& context, std::string_view text,
                                        TableMemory& memory, Status* mistake) {
  return PathReader(context, text, memory).read(mistake);
}

}  // namespace sfumato::svg
