#include "limits/peak/cases.hpp"

#include <cstdint>
#include <utility>

#include "limits/large_inputs.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/codecs/jpeg_encode.hpp"
#include "sfumato/codecs/png.hpp"
#include "support/gzip.hpp"

namespace sfumato::peak {
namespace {

constexpr const char* kHead =
    "<svg xmlns='http://www.w3.org/2000/svg' xmlns:sf='urn:sfumato:1' viewBox='0 0 100 100'>\n";
constexpr const char* kLayer =
    "<g id='layer' sf:diffuse='true'><path d='M10 20C40 90 60 5 90 80' sf:left='red' "
    "sf:right='blue'/></g>\n";

std::string drawing(const std::string& content) {
  return kHead + content + "</svg>\n";
}

std::string one_curve() {
  return drawing(kLayer);
}

std::string instances(int count) {
  std::string text = std::string("<defs>") + kLayer + "</defs>\n";
  for (int i = 0; i < count; ++i) {
    text += "<use href='#layer' transform='translate(" + std::to_string(i % 97) + "," +
            std::to_string(i % 89) + ") scale(0.02)'/>\n";
  }
  return drawing(text);
}

std::string local_curves(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    text += "<path d='M" + std::to_string(i % 97) + " " + std::to_string(i % 89) +
            "l4 3' sf:left='red' sf:right='blue' sf:radius='2'/>\n";
  }
  return drawing(text);
}

std::string textured(const std::string& file) {
  return drawing(
      "<defs><pattern id='p' patternUnits='userSpaceOnUse' width='100' height='100'>"
      "<image href='" +
      file +
      "' width='100' height='100'/></pattern></defs>"
      "<g sf:diffuse='true'><path d='M10 20C40 90 60 5 90 80' sf:left='red' "
      "sf:right='url(#p)'/></g>\n");
}

/// Returns waves, which compress well.
Image waves(int side, PixelFormat format) {
  Image image{side, side, format, {}};
  image.bytes.resize(image.row_bytes() * static_cast<std::size_t>(side));
  const std::size_t row = image.row_bytes();
  for (std::size_t i = 0; i < image.bytes.size(); ++i) {
    image.bytes[i] = static_cast<std::uint8_t>((i % row) / 64 + (i / row) / 16);
  }
  return image;
}

std::string text_of(const Result<std::vector<std::uint8_t>>& bytes) {
  return bytes ? std::string(bytes->begin(), bytes->end()) : std::string();
}

Context roomy() {
  return Context{.budget = Budget(std::size_t{12} << 30)};
}

std::string png_texture(int side, PixelFormat format) {
  Context context = roomy();
  return text_of(encode_png(context, waves(side, format)));
}

std::string jpeg_texture(int side) {
  Context context = roomy();
  return text_of(encode_jpeg(context, test::noise_image(side, side), 60));
}

using Words = std::vector<std::string>;

/// Returns a case of one drawing, whose output is DIR/out.EXTENSION.
Case rendered(std::string name, std::function<std::string()> drawing, const std::string& extension,
              const Words& more = {}) {
  Case made{std::move(name), {{"in.svg", std::move(drawing)}}, {}};
  made.arguments = {"render", "DIR/in.svg", "-o", "DIR/out." + extension, "--quiet"};
  made.arguments.insert(made.arguments.end(), more.begin(), more.end());
  return made;
}

Case quick(Case of) {
  of.is_quick = true;
  return of;
}

Case with_file(Case of, std::string name, std::function<std::string()> bytes) {
  of.files.push_back({std::move(name), std::move(bytes)});
  return of;
}

void add_pictures(std::vector<Case>& cases) {
  for (const char* side : {"2048", "4096", "8192", "16384"}) {
    const std::string name = std::string("picture of ") + side + "², ";
    for (const char* extension : {"png", "jpg", "webp"}) {
      if (extension == std::string("webp") && side == std::string("16384")) continue;
      Case one = rendered(name + extension, one_curve, extension, {"--width", side});
      one.is_quick = side == std::string("2048");
      cases.push_back(one);
    }
    cases.push_back(rendered(name + "png of 16 bits and alpha", one_curve, "png",
                             {"--width", side, "--depth", "16", "--background", "none"}));
  }
  for (const char* side : {"2048", "4096"}) {
    cases.push_back(rendered(std::string("picture of ") + side + "², lossless webp", one_curve,
                             "webp", {"--width", side, "--lossless"}));
  }
  cases.push_back(
      rendered("pixels of 2048²", one_curve, "png", {"--width", "2048", "--method", "pixels"}));
}

void add_meshes(std::vector<Case>& cases) {
  for (const char* area : {"4e-5", "1e-5", "2e-6", "4e-7"}) {
    for (const char* extension : {"png", "pdf", "eps", "glb", "html", "svg"}) {
      Words more{"--max-area", area, "--max-error", "off", "--width", "512"};
      if (extension == std::string("svg")) {
        more.insert(more.end(), {"--svg", "vector", "--force", "--limit", "svg-triangles=600k"});
      }
      Case one = rendered(std::string("triangles of ") + area + " of the artboard, " + extension,
                          one_curve, extension, more);
      one.is_quick = area == std::string("1e-5");
      cases.push_back(one);
    }
  }
  cases.push_back(
      rendered("triangles of 1e-300 of the artboard", one_curve, "png", {"--max-area", "1e-300"}));
  cases.push_back(rendered("triangles of 2e-6 of the artboard, 3 threads", one_curve, "png",
                           {"--max-area", "2e-6", "--max-error", "1", "--threads", "3"}));
}

void add_curves(std::vector<Case>& cases) {
  for (const char* extension : {"png", "pdf", "glb", "html"}) {
    const auto text = [] { return test::many_curves_svg(3000); };
    cases.push_back(rendered(std::string("3,000 curves, ") + extension, text, extension,
                             {"--max-error", "off", "--width", "512"}));
  }
  // Solving would take longer, and its memory is already at its peak by then.
  for (const int count : {20'000, 200'000}) {
    const auto text = [count] { return test::many_curves_svg(static_cast<std::size_t>(count)); };
    cases.push_back(rendered(std::to_string(count) + " curves, 10 s of them", text, "png",
                             {"--max-error", "off", "--width", "512", "--max-time", "10"}));
  }
  for (const int count : {10'000, 100'000}) {
    const auto uses = [count] { return instances(count); };
    for (const char* extension : {"png", "pdf", "glb", "html", "svg"}) {
      cases.push_back(rendered(std::to_string(count) + " instances, " + extension, uses, extension,
                               {"--max-error", "off", "--width", "512"}));
    }
    const auto strokes = [count] { return local_curves(count); };
    for (const char* extension : {"png", "pdf", "html"}) {
      cases.push_back(rendered(std::to_string(count) + " local curves, " + extension, strokes,
                               extension, {"--width", "512"}));
    }
  }
  cases.push_back(rendered("path of 1,300,000 pieces",
                           [] { return test::long_path_svg(1'300'000); }, "png",
                           {"--max-error", "off"}));
  cases.push_back(rendered(
      "flat artboard",
      [] {
        return "<svg xmlns='http://www.w3.org/2000/svg' xmlns:sf="
               "'urn:sfumato:1' viewBox='0 0 1000 1e-6'>" +
               std::string(kLayer) + "</svg>";
      },
      "png"));
}

void add_textures(std::vector<Case>& cases) {
  for (const int side : {1500, 4900, 7900}) {
    const std::string size = std::to_string(side) + "²";
    const auto png = [](std::string name, int pixels, PixelFormat format) {
      Case one = rendered("PNG texture of " + name, [] { return textured("t.png"); }, "png",
                          {"--width", "512"});
      return with_file(one, "t.png", [pixels, format] { return png_texture(pixels, format); });
    };
    cases.push_back(png(size, side, PixelFormat::rgb8));
    cases.back().is_quick = side == 1500;
    cases.push_back(png(size + ", 16 bits", side, PixelFormat::rgba16));
    for (const char* extension : {"png", "pdf", "glb", "html"}) {
      Case one =
          with_file(rendered("JPEG texture of " + size + ", " + extension,
                             [] { return textured("t.jpg"); }, extension, {"--width", "512"}),
                    "t.jpg", [side] { return jpeg_texture(side); });
      one.is_quick = side == 1500;
      cases.push_back(one);
    }
    Case saved = with_file(rendered(
                               "", [] { return textured("t.jpg"); }, "svg"),
                           "t.jpg", [side] { return jpeg_texture(side); });
    saved.name = "JPEG texture of " + size + ", convert";
    saved.arguments = {"convert", "DIR/in.svg", "-o", "DIR/out.svg"};
    cases.push_back(saved);
  }
}

void add_texts(std::vector<Case>& cases) {
  cases.push_back(quick(rendered(
      "gzip of 60 MiB of blanks",
      [] { return test::gzipped(drawing(std::string(std::size_t{60} << 20, ' ') + kLayer)); },
      "png")));
  for (const char* extension : {"png", "svg"}) {
    cases.push_back(rendered(
        std::string("Orzan's XML of 100,000 curves, ") + extension,
        [] { return test::many_curves_orzan(100'000); }, extension));
  }
  for (const char* verb : {"info", "lint", "convert"}) {
    Case one = rendered(
        std::string("200,000 curves, ") + verb, [] { return test::many_curves_svg(200'000); },
        "svg");
    one.arguments = {verb, "DIR/in.svg"};
    if (verb == std::string("convert"))
      one.arguments.insert(one.arguments.end(), {"-o", "DIR/out.svg"});
    cases.push_back(one);
  }
}

}  // namespace

Case empty_drawing() {
  return rendered("empty drawing", [] { return drawing(""); }, "png", {"--width", "16"});
}

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  add_pictures(cases);
  add_meshes(cases);
  add_curves(cases);
  add_textures(cases);
  add_texts(cases);
  return cases;
}

}  // namespace sfumato::peak
