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

/// Holds a value that was read. Its kind decides which member besides `text` counts.
struct Value {
  std::string_view text;
  std::optional<double> number;  ///< none: Option::instead was given
  std::uint64_t whole = 0;
  std::size_t word = 0;  ///< index into Option::words
  Box box;
  PixelRect pixels;
  std::optional<Rgb> color;  ///< none: no colour
};

/// Sections of the command's help.
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

/// Describes one option of the command and of the C interface: its texts and the values that it
/// takes. Texts name other options in the form that spelled() explains.
struct OptionInfo {
  const char* key;
  ValueKind kind;
  NumberRange numbers{};
  WholeRange wholes{};
  const char* instead = nullptr;              ///< a word that stands for no number
  std::span<const std::string_view> words{};  ///< of ValueKind::word
  bool ignores_case = false;                  ///< of the letters of words
  const char* expected = nullptr;             ///< null: follows from words or wholes
  const char* value_name = nullptr;           ///< in the help; null: the words
  const char* excludes = nullptr;  ///< the key of an option that cannot be combined with this one
  const char* help = nullptr;      ///< lines of the command's help
  Group group = Group::none;
  unsigned calls = 0;  ///< of enum Call
};

/// Holds an option of a table and the function by which it changes a Target.
template <class Target>
struct Option {
  OptionInfo info;
  void (*set)(Target& target, const Value& value);
};

/// Returns a text with the options named as their user writes them. "@svg=vector" and "@svg" become
/// "svg=vector" and "svg". For the command they get two dashes, and a blank instead of "=".
std::string spelled(std::string_view text, bool for_command);

/// Reads a value. Returns nothing if the text is not a value of the option.
std::optional<Value> parse_value(const OptionInfo& option, std::string_view text);

/// Returns the values of an option in words: "one of 8|16". Empty: a flag, or any text.
std::string expected_value(const OptionInfo& option);

/// Returns what is wrong with a text that parse_value() refused, and what was probably meant:
/// "invalid value \"x\"; use one of 8|16".
std::string complaint_about_value(const OptionInfo& option, std::string_view text);

/// Returns the value's name in the help: "N", "8|16".
std::string value_name(const OptionInfo& option);

}  // namespace sfumato::options
