#include "options/option_reader.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "options/settle.hpp"
#include "options/tables.hpp"

namespace sfumato::options {
namespace {

/// Returns the error in the options of a call; empty: none.
std::string complaint(Call call, std::string_view text, Settings* settings = nullptr) {
  Settings own;
  Limits limits;
  OptionReader reader(call);
  reader.take(render_options(), settings ? *settings : own);
  if (call == kContext) reader.take_limits(limits);
  const Status status = reader.read(text);
  return status ? std::string() : status.message;
}

TEST(OptionReader, sets_what_the_text_says) {
  Settings settings;
  EXPECT_EQ(
      complaint(kSolve, " max-error=off\tviewport=0,0,4,8 no-blur\n order=linear ", &settings), "");
  EXPECT_EQ(settings.diffuse.max_error, 0);
  EXPECT_EQ(settings.diffuse.viewport, (Box{{0, 0}, {4, 8}}));
  EXPECT_TRUE(settings.diffuse.ignore_blur);
  EXPECT_EQ(settings.diffuse.order, PatchOrder::linear);
}

TEST(OptionReader, takes_quoted_values) {
  Settings settings;
  EXPECT_EQ(complaint(kExport, R"(title="A \"fish\" \\ = x" dpi="72")", &settings), "");
  EXPECT_EQ(settings.output.title, R"(A "fish" \ = x)");
  EXPECT_EQ(settings.output.dpi, 72);
}

TEST(OptionReader, names_the_key_of_what_is_wrong) {
  EXPECT_EQ(complaint(kSolve, "max-eror=1"),
            "unknown option \"max-eror\" for this call; did you mean max-error?");
  EXPECT_EQ(complaint(kSolve, "max-error=x"),
            "max-error: invalid value \"x\"; use a number above 0 and at most 255, or off");
  EXPECT_EQ(
      complaint(kSolve, "order=cubi"),
      "order: invalid value \"cubi\"; use one of linear|quadratic|cubic; did you mean cubic?");
  EXPECT_EQ(complaint(kSolve, "order"), "order: no value given; write it as KEY=VALUE");
  EXPECT_EQ(complaint(kSolve, "no-blur=1"), "no-blur: takes no value; leave out the value");
  EXPECT_EQ(complaint(kSolve, "scale=1 scale=1"), "scale: given twice; give it once");
  EXPECT_EQ(complaint(kExport, "no-dither dither"), "no-dither: cannot be combined with dither");
  EXPECT_EQ(complaint(kExport, "dither no-dither"), "no-dither: cannot be combined with dither");
  EXPECT_EQ(complaint(kContext, "limit.curves=300k"), "");
  EXPECT_EQ(complaint(kContext, "limit.curve=3").find("\"limit.curve\": use NAME=VALUE"), 0u);
}

TEST(OptionReader, knows_only_the_options_of_its_call) {
  EXPECT_EQ(complaint(kRaster, "lossless"), "unknown option \"lossless\" for this call");
  EXPECT_EQ(complaint(kSolve, "limit.curves=3"), "unknown option \"limit.curves\" for this call");
  EXPECT_EQ(complaint(kExport, "device=gpu"), "unknown option \"device\" for this call");
}

TEST(OptionReader, refuses_stray_quotes) {
  EXPECT_EQ(complaint(kExport, "title=\"a"),
            "title: a quote that is not closed; add the closing quote");
  EXPECT_EQ(complaint(kExport, "title=\"a\\\""),
            "title: a quote that is not closed; add the closing quote");
  EXPECT_EQ(complaint(kExport, "title=\"a\"b"),
            "title: something follows a closing quote; put a blank between");
  EXPECT_EQ(complaint(kExport, "title=a\"b"),
            "title: a quote within a value; put quotes around the whole value");
  EXPECT_EQ(complaint(kExport, "\"title\"=a"), "unknown option \"\"title\"\"");
  EXPECT_EQ(complaint(kExport, "=a"), "unknown option \"\"");
  EXPECT_EQ(complaint(kExport, "Title=a"), "unknown option \"Title\"");
}

TEST(OptionTables, have_texts_that_make_an_error_for_every_option) {
  for (const Option<Settings>& option : render_options()) {
    const ValueKind kind = option.info.kind;
    ASSERT_NE(option.info.help, nullptr) << option.info.key;
    ASSERT_NE(option.info.group, Group::none) << option.info.key;
    if (kind == ValueKind::flag || kind == ValueKind::text) continue;
    EXPECT_FALSE(parse_value(option.info, "")) << option.info.key;
    EXPECT_FALSE(value_name(option.info).empty()) << option.info.key;
  }
}

TEST(OptionTables, have_each_key_once) {
  for (const Option<Settings>& option : render_options()) {
    const std::string_view key = option.info.key;
    EXPECT_EQ(std::ranges::count_if(render_options(),
                                    [key](const auto& other) { return other.info.key == key; }),
              1)
        << key;
  }
}

TEST(Spelled, names_options_as_the_command_and_as_the_interface_do) {
  EXPECT_EQ(spelled("works with @svg=vector only", true), "works with --svg vector only");
  EXPECT_EQ(spelled("works with @svg=vector only", false), "works with svg=vector only");
  EXPECT_EQ(spelled("@mesh-overlay", true), "--mesh-overlay");
  EXPECT_EQ(spelled("a = b", true), "a = b");
}

TEST(Settle, gives_defaults_that_depend_on_the_output) {
  Settings png, jpeg, wide, vector;
  wide.depth = 16;
  vector.output.svg = SvgMode::vector;
  settle(png, OutputKind::png);
  settle(jpeg, OutputKind::jpeg);
  settle(wide, OutputKind::png);
  settle(vector, OutputKind::svg);
  EXPECT_TRUE(png.raster.dither);
  EXPECT_FALSE(jpeg.raster.dither);
  EXPECT_FALSE(wide.raster.dither);
  EXPECT_EQ(wide.raster.format, PixelFormat::rgb16);
  EXPECT_EQ(wide.diffuse.max_error, 0.25);
  EXPECT_EQ(png.diffuse.max_error, 1);
  EXPECT_EQ(*png.output.detail, 2);
  EXPECT_EQ(*vector.output.detail, 1);
}

}  // namespace
}  // namespace sfumato::options
