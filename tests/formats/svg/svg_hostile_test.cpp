// Documents that were written to do harm: a limit refuses them quickly, and no memory stays
// charged.
#include <gtest/gtest.h>

#include <new>

#include "codecs/image_file.hpp"
#include "formats/image_files.hpp"
#include "formats/svg/svg_support.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::test {
namespace {

std::string repeated(const std::string& text, std::size_t count) {
  std::string result;
  result.reserve(text.size() * count);
  for (std::size_t i = 0; i < count; ++i) result += text;
  return result;
}

/// Returns nested groups: ten uses of the previous group, that many times.
std::string laughs(int levels, const std::string& first) {
  std::string groups = "<g id='g0'>" + first + "</g>";
  for (int i = 1; i <= levels; ++i) {
    groups += "<g id='g" + std::to_string(i) + "'>" +
              repeated("<use href='#g" + std::to_string(i - 1) + "'/>", 10) + "</g>";
  }
  return "<defs>" + groups + "</defs>";
}

TEST(SvgHostile, billion_laughs_are_refused) {
  const std::string layer = "<g sf:diffuse='true'><path d='M0 0 h9'/></g>";
  const Status status = status_of(svg(laughs(9, repeated(layer, 10)) + "<use href='#g9'/>"));
  EXPECT_EQ(status.code, StatusCode::limit);
  EXPECT_EQ(status.message,
            "more than the limit of 200000 layers, local curves and groups after every use was "
            "followed");
  EXPECT_EQ(status.limit, "stack-items");
  EXPECT_EQ(status.where.line, 2);
}

TEST(SvgHostile, billion_laughs_about_nothing_are_refused) {
  const Status status = status_of(svg(laughs(9, "") + "<use href='#g9'/>"));
  EXPECT_EQ(status.code, StatusCode::limit);
  EXPECT_EQ(status.message, "more than the limit of 400000 elements read through <use>");
  EXPECT_EQ(status.limit, "used-elements");
}

TEST(SvgHostile, billion_laughs_within_a_layer_are_refused) {
  const Status status = status_of(svg(laughs(9, repeated("<path d='M0 0 h9'/>", 10)) +
                                      "<g sf:diffuse='true'><use href='#g9'/></g>"));
  EXPECT_EQ(status.code, StatusCode::limit);
  EXPECT_EQ(status.message, "more than the limit of 200000 curves");
  EXPECT_EQ(status.limit, "curves");
}

TEST(SvgHostile, long_chain_of_uses_is_refused) {
  std::string chain = "<g id='g0'/>";
  for (int i = 1; i < 100'000; ++i) {
    chain += "<g id='g" + std::to_string(i) + "'><use href='#g" + std::to_string(i - 1) + "'/></g>";
  }
  const Status status = status_of(svg("<defs>" + chain + "</defs><use href='#g99999'/>"));
  EXPECT_EQ(status.code, StatusCode::limit);
  EXPECT_EQ(status.message,
            "more than the limit of 256 elements within each other after every use was followed");
  EXPECT_EQ(status.limit, "xml-depth");
}

TEST(SvgHostile, million_nested_groups_are_refused) {
  const Status status = status_of(svg(repeated("<g>", 1'000'000) + repeated("</g>", 1'000'000)));
  EXPECT_EQ(status.code, StatusCode::limit);
}

TEST(SvgHostile, groups_that_nest_too_deep_to_composite_are_refused) {
  const auto nested = [](std::size_t levels) {
    return svg(repeated("<g opacity='.5'>", levels) + kStroke + kStroke + repeated("</g>", levels));
  };
  EXPECT_TRUE(status_of(nested(limits::kGroupDepth)).ok());
  const Status status = status_of(nested(limits::kGroupDepth + 1));
  EXPECT_EQ(status.code, StatusCode::limit);
  EXPECT_EQ(to_string(status),
            "a.svg:2:1: more than the limit of 16 groups within each other that "
            "are composited by themselves");
  EXPECT_EQ(status.limit, "group-depth");
}

TEST(SvgHostile, hundred_thousand_commands_are_no_trouble) {
  const Curve curve = curve_of_path("M0 0" + repeated("l1 1h-1", 50'000));
  EXPECT_EQ(curve.piece_count(), 100'000u);
}

TEST(SvgHostile, path_beyond_the_limit_is_refused) {
  const Status status = status_of(
      svg_layer("<path d='M0 0" + repeated("h1", limits::kControlPoints / 3 + 1) + "'/>"));
  EXPECT_EQ(status.code, StatusCode::limit);
  EXPECT_EQ(to_string(status),
            "a.svg:3:1: d of <path>: more than the limit of 4000000 control "
            "points");
  EXPECT_EQ(status.limit, "control-points");
}

TEST(SvgHostile, stop_lists_beyond_the_limit_are_refused) {
  const auto blurred = [](std::size_t count) {
    return svg_layer("<path d='M0 0 h9' sf:left-blur='1" + repeated(",2", count - 1) + "'/>");
  };
  EXPECT_TRUE(status_of(blurred(limits::kStopsPerList)).ok());
  const Status status = status_of(blurred(limits::kStopsPerList + 1));
  EXPECT_EQ(status.code, StatusCode::limit);
  EXPECT_EQ(to_string(status),
            "a.svg:3:1: sf:left-blur of <path>: more than the limit of 10000 stops in one list");
  EXPECT_EQ(status.limit, "stops-per-list");
}

TEST(SvgHostile, gradients_of_more_stops_than_the_limit_are_refused) {
  const auto filled = [](std::size_t count) {
    return svg_layer(
        "<path d='M0 0 h9' sf:left='url(#p)'/>\n<linearGradient id='p' x2='9' "
        "gradientUnits='userSpaceOnUse'>\n" +
        repeated("<stop/>", count) + "</linearGradient>");
  };
  EXPECT_TRUE(status_of(filled(limits::kStopsPerList)).ok());
  const Status status = status_of(filled(limits::kStopsPerList + 1));
  EXPECT_EQ(status.code, StatusCode::limit);
  EXPECT_EQ(to_string(status), "a.svg:5:70001: more than the limit of 10000 stops in one gradient");
  EXPECT_EQ(status.limit, "stops-per-list");
}

TEST(SvgHostile, stops_times_subpaths_beyond_the_limit_are_refused) {
  const Status status = status_of(svg_layer("<path d='" + repeated("M0 0h9", 10'000) +
                                            "' sf:left-blur='1" + repeated(",2", 9'999) + "'/>"));
  EXPECT_EQ(status.code, StatusCode::limit);
  EXPECT_EQ(to_string(status), "a.svg:3:1: more than the limit of 8000000 stops");
  EXPECT_EQ(status.limit, "stops");
}

TEST(SvgHostile, more_layers_than_the_limit_are_refused) {
  const Status status = status_of(svg(repeated("<g sf:diffuse='true'/>", limits::kLayers + 1)));
  EXPECT_EQ(to_string(status), "a.svg:2:90113: more than the limit of 4096 layers");
  EXPECT_EQ(status.limit, "layers");
}

TEST(SvgHostile, style_sheet_that_multiplies_is_refused) {
  const Status status = status_of(
      svg("<style>a" + repeated(",a", 10'000) + "{" + repeated("b:c;", 10'000) + "}</style>"));
  EXPECT_EQ(status.code, StatusCode::limit);
  EXPECT_EQ(to_string(status), "a.svg:2:1: more than the limit of 100000 values in style sheets");
  EXPECT_EQ(status.limit, "style-values");
}

TEST(SvgHostile, attributes_by_the_thousand_are_no_trouble) {
  for (const char* prefix : {" data-a", " xlink:href", " :left"}) {
    std::string attributes;
    for (int i = 0; i < 16'000; ++i) attributes += prefix + std::to_string(i) + "='true'";
    const std::string text = svg("<g" + attributes + "/>");
    EXPECT_EQ(status_of(text).code, StatusCode::limit);
    const Status raised = status_of(text, nullptr, {.xml_attributes = 16'384});
    EXPECT_TRUE(raised.ok()) << to_string(raised);
  }
}

TEST(SvgHostile, entities_that_multiply_are_refused) {
  std::string entities = "<!ENTITY a0 'ha'>";
  for (int i = 1; i <= 9; ++i) {
    const std::string one = "&a" + std::to_string(i - 1) + ";";
    entities += "<!ENTITY a" + std::to_string(i) + " '" + repeated(one, 10) + "'>";
  }
  for (const char* content : {"<g id='&a9;'/>", "&a9;"}) {
    const Status status = status_of("<!DOCTYPE svg [" + entities + "]>" + svg(content));
    EXPECT_EQ(status.limit, "entity-bytes");
    EXPECT_EQ(status.where.line, 2);
  }
}

TEST(SvgHostile, external_entities_are_not_read) {
  const std::string text =
      "<!DOCTYPE svg [<!ENTITY x SYSTEM 'file:///etc/passwd'>]>" + svg("<g id='&x;'>&x;</g>");
  const ReadDocument read_document = read(text);
  ASSERT_FALSE(read_document.warnings.empty());
  EXPECT_EQ(to_string(read_document.warnings[0]),
            "a.svg:2:8: the entity \"x\" is external and is not read");
}

TEST(SvgHostile, memory_is_charged_before_it_is_taken) {
  const std::string text = svg_layer(repeated("<path d='M0 0 h9' sf:left='red, lime'/>", 2'000));
  for (const std::size_t budget : {100'000u, 500'000u, 1'000'000u}) {
    Context context;
    new (&context.budget) Budget(budget);
    const Status status = read_svg(context, text, "a.svg").status();
    EXPECT_EQ(status.code, StatusCode::limit) << budget;
    EXPECT_EQ(context.budget.used(), 0u);
  }
}

std::string with_texture(const std::string& href, int count = 1) {
  std::string curves;
  for (int i = 1; i <= count; ++i) {
    curves += "<path transform='scale(" + std::to_string(i) + ")' d='M0 0 h9' sf:left='url(#p)'/>";
  }
  return svg_layer(curves +
                   "<pattern id='p' patternUnits='userSpaceOnUse' width='4' height='2'>"
                   "<image href='" +
                   href + "'/></pattern>");
}

/// Returns a PNG whose header claims that size.
std::vector<std::uint8_t> lying_png(std::uint32_t width, std::uint32_t height) {
  std::vector<std::uint8_t> png = png_file(4, 2);
  for (int i = 0; i < 4; ++i) {
    png[16 + i] = static_cast<std::uint8_t>(width >> (24 - 8 * i));
    png[20 + i] = static_cast<std::uint8_t>(height >> (24 - 8 * i));
  }
  return png;
}

/// Returns a JPEG whose header claims that size.
std::vector<std::uint8_t> lying_jpeg(unsigned width, unsigned height) {
  std::vector<std::uint8_t> jpeg = jpeg_file(16, 16, 3, {1, 2, 3, 0});
  std::size_t frame = 2;
  while (!(jpeg[frame] == 0xFF && jpeg[frame + 1] == 0xC0)) ++frame;
  jpeg[frame + 5] = static_cast<std::uint8_t>(height >> 8);
  jpeg[frame + 6] = static_cast<std::uint8_t>(height);
  jpeg[frame + 7] = static_cast<std::uint8_t>(width >> 8);
  jpeg[frame + 8] = static_cast<std::uint8_t>(width);
  return jpeg;
}

TEST(SvgHostile, images_that_lie_about_their_size_are_refused_before_memory_is_taken) {
  MemoryLoader loader;
  loader.files["huge.png"] = lying_png(60'000, 60'000);
  loader.files["wide.png"] = lying_png(60'000, 10);
  loader.files["huge.jpg"] = lying_jpeg(60'000, 60'000);
  for (const char* name : {"huge.png", "wide.png", "huge.jpg"}) {
    EXPECT_EQ(status_of(with_texture(name), &loader).code, StatusCode::limit) << name;
  }
  loader.files["large.png"] = lying_png(8'000, 8'000);
  loader.files["large.jpg"] = lying_jpeg(8'000, 8'000);
  for (const char* name : {"large.png", "large.jpg"}) {
    const Status status = status_of(with_texture(name), &loader);
    EXPECT_EQ(status.code, StatusCode::bad_input) << name;
    EXPECT_TRUE(status.message.ends_with("is damaged: too few bytes for 8000 × 8000 pixels"))
        << status.message;
  }
}

TEST(SvgHostile, textures_beyond_the_limit_are_refused) {
  MemoryLoader loader;
  loader.files["a.png"] = png_file(4, 2);
  EXPECT_TRUE(status_of(with_texture("a.png", 60), &loader).ok());
  const Status status = status_of(with_texture("a.png", 300), &loader);
  EXPECT_EQ(status.code, StatusCode::limit);
  EXPECT_EQ(status.message, "more than the limit of 256 textures");
  EXPECT_EQ(status.limit, "textures");
}

TEST(SvgHostile, more_paints_in_a_layer_than_the_limit_are_refused) {
  MemoryLoader loader;
  loader.files["a.png"] = png_file(4, 2);
  const Status status = status_of(with_texture("a.png", 65), &loader);
  EXPECT_EQ(to_string(status), "a.svg:2:1: more than the limit of 64 paints in one layer");
  EXPECT_EQ(status.limit, "shaders-per-layer");
}

TEST(SvgHostile, huge_data_uri_is_refused) {
  const std::string uri = "data:image/png;base64," + repeated("AAAA", 8'000'000);
  const Status status = status_of(with_texture(uri));
  EXPECT_EQ(status.code, StatusCode::bad_input);
  EXPECT_EQ(status.message, "the data: URI: the image is neither a PNG nor a JPEG");
}

TEST(SvgHostile, images_cut_or_changed_anywhere_are_read_or_refused) {
  for (const bool progressive : {false, true}) {
    const std::vector<std::uint8_t> jpeg = jpeg_file(24, 16, 3, {9, 200, 80, 0}, progressive);
    for (std::size_t i = 0; i < jpeg.size(); ++i) {
      Context context;
      EXPECT_FALSE(codecs::decode_image(context, std::span(jpeg).first(i)).ok()) << i;
      std::vector<std::uint8_t> changed = jpeg;
      changed[i] = static_cast<std::uint8_t>(changed[i] ^ (1u << (i % 8)));
      const auto image = codecs::decode_image(context, changed);
      EXPECT_TRUE(image.ok() || !image.status().message.empty());
      EXPECT_EQ(context.budget.used(), 0u);
    }
  }
}

/// Returns a document with some of everything.
std::string rich_document() {
  return svg(
      "<style>.a{opacity:.5}</style><rect width='100%' height='100%' fill='#eee'/>"
      "<defs><linearGradient id='p' gradientUnits='userSpaceOnUse' x2='9'><stop offset='10%' "
      "stop-color='hsl(1 2% 3%)'/></linearGradient><pattern id='q' width='1' height='1'>"
      "<image href='data:image/png;base64," +
          base64_of(png_file(4, 2)) +
          "'/></pattern><symbol id='s' viewBox='0 0 9 9'><use href='#f'/></symbol>"
          "<g id='f' sf:diffuse='true'><path d='M0 0c1 2 3 4 5 6s7 8 9 1q1 2 3 4t5 6a5 4 30 1 0 9 "
          "9z' "
          "sf:left='red, lime 40%, blue' sf:right='url(#p)' sf:blur='1 @0, 2 @1.5'/>"
          "<circle r='5' sf:left='url(#q)' sf:left-opacity='0, 1' sf:weight='2'/></g></defs>"
          "<g class='a'><use href='#f' transform='rotate(30) scale(2 -1)'/><use href='#s'/></g>"
          "<path d='M1 1h9' sf:left='red' sf:radius='3, 2' sf:alpha='.5'/>",
      "sf:interpolation='linear'");
}

TEST(SvgHostile, documents_changed_anywhere_are_read_or_refused_with_a_reason) {
  const std::string good = rich_document();
  ASSERT_TRUE(status_of(good).ok()) << to_string(status_of(good));
  const std::string replacements = "<>/'= ,()#@%-.e9azM&\x80";
  std::uint32_t random = 12345;
  const auto next = [&random](std::size_t count) {
    random = random * 1664525u + 1013904223u;
    return (random >> 8) % count;
  };
  for (int round = 0; round < 4000; ++round) {
    std::string text = good;
    for (std::size_t i = 0; i < 1 + next(4); ++i) {
      const std::size_t at = next(text.size());
      const std::size_t kind = next(3);
      if (kind == 0) text[at] = replacements[next(replacements.size())];
      if (kind == 1) text.erase(at, 1 + next(9));
      if (kind == 2) text.insert(at, text.substr(next(text.size()), next(20)));
    }
    const Status status = status_of(text);
    if (status.ok()) continue;
    EXPECT_NE(status.code, StatusCode::internal) << text;
    EXPECT_EQ(status.where.file, "a.svg") << status.message << "\n" << text;
  }
}

}  // namespace
}  // namespace sfumato::test
