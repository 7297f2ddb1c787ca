#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/pixel_rect.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/color.hpp"

namespace sfumato::options {

/// How the text of a value is read.
enum class ValueKind : std::uint8_t {
  flag,      ///< takes no value
  number,    ///< a finite decimal number in Option::numbers
  whole,     ///< a decimal whole number in Option::wholes
  fraction,  ///< above 0 and at most 1, also as a percentage
  word,      ///< one of Option::words
  box,       ///< "x,y,width,height" in user units
  pixels,    ///< "x,y,width,height" in whole pixels
  color,     ///< an opaque colour of CSS, or none
  text       ///< any
};

/// Bounds of numbers. `lowest` itself is one of them unless the range is above it.
struct NumberRange {
  double lowest = 0;
  double highest = std::numeric_limits<double>::max();
  bool is_above = true;
};

struct WholeRange {
  std::uint64_t lowest = 0;
  std::uint64_t highest = UINT64_MAX;
};

/// A value that was read. What counts besides `text` depends on the kind.
struct Value {
  std::string_view text;
  std::optional<double> number;  ///< none: Option::instead was given
  std::uint64_t whole = 0;
  std::size_t word = 0;  ///< index into Option::words
  Box box;
  PixelRect pixels;
  std::optional<Rgb> color;  ///< none: no colour
};

/// What options are about: a heading of the command's help each.
enum class Group : std::uint8_t {
  none,  ///< not the command's
  drawing,
  place,
  solution,
  mesh,
  image,
  vector,
  running,
  resources
};

/// The calls of the C interface that know an option.
enum Call : unsigned {
  kContext = 1,
  kNewDocument = 2,
  kSolve = 4,
  kRaster = 8,
  kExport = 16,
  kEncode = 32,
  kField = 64,
  kPayload = 128,
  kLint = 256,
  kTrace = 512,
  kFitColors = 1024,
  kWeights = 2048
};

/// One option of the command and of the C interface: what both say about it, and which values it
/// takes. Where a text names an option, it does so as spelled() explains.
struct OptionInfo {
  const char* key;
  ValueKind kind;
  NumberRange numbers{};
  WholeRange wholes{};
  const char* instead = nullptr;              ///< a word that stands for no number
  std::span<const std::string_view> words{};  ///< of ValueKind::word
  const char* expected = nullptr;             ///< null: follows from words or wholes
  const char* value_name = nullptr;           ///< in the help; null: the words
  const char* excludes = nullptr;             ///< the key of what may not be given too
  const char* help = nullptr;                 ///< lines of the command's help
  Group group = Group::none;
  unsigned calls = 0;  ///< of enum Call
};

/// An option of a table, and how it changes a Target.
template <class Target>
struct Option {
  OptionInfo info;
  void (*set)(Target& target, const Value& value);
};

/// A text with its options named as their user writes them. "@svg=vector" and "@svg" become
/// "svg=vector" and "svg"; for the command they get two dashes, and a blank in the place of "=".
std::string spelled(std::string_view text, bool for_command);

/// Reads a value. Empty: the text is none of the option's values.
std::optional<Value> parse_value(const OptionInfo& option, std::string_view text);

/// What is wrong with a text that parse_value() refused, and what was probably meant: "\"x\" given,
/// expected one of 8|16".
std::string complaint_about_value(const OptionInfo& option, std::string_view text);

/// The value's name in the help: "N", "8|16".
std::string value_name(const OptionInfo& option);

}  // namespace sfumato::options
