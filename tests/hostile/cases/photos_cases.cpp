// Pictures for `trace` with wrong sizes, orientations or colour profiles.
#include "hostile/case.hpp"
#include "hostile/documents.hpp"
#include "hostile/images.hpp"

namespace sfumato::hostile {
namespace {

/// Adds a call that traces the file `photo`. Ignored parts cause no message.
Case& add_photo(Family& family, std::string name, int exit_code, std::string message, Bytes photo) {
  Case& made = family.add_call(std::move(name), exit_code, std::move(message),
                               {"trace", "photo", "-o", "out.svg", "--quiet"});
  return made.with("photo", std::move(photo));
}

std::string big_endian(std::uint64_t number, int byte_count) {
  std::string bytes;
  for (int i = byte_count - 1; i >= 0; --i) bytes += static_cast<char>(number >> 8 * i);
  return bytes;
}

std::string little_endian(std::uint64_t number, int byte_count) {
  const std::string bytes = big_endian(number, byte_count);
  return {bytes.rbegin(), bytes.rend()};
}

std::string small_jpeg(int channels = 3) {
  return jpeg(24, 16, channels, JpegKind::baseline);
}

/// Returns a JPEG with a segment after its first marker. marker: '\xE1' for APP1.
std::string with_segment(const std::string& jpeg, char marker, const std::string& data) {
  return jpeg.substr(0, 2) + '\xFF' + marker + big_endian(data.size() + 2, 2) + data +
         jpeg.substr(2);
}

std::string with_exif(const std::string& exif) {
  return with_segment(small_jpeg(), '\xE1', std::string("Exif\0\0", 6) + exif);
}

/// Returns part `part` of `count` parts of a profile, both counted from 1.
std::string profile_part(int part, int count, const std::string& data) {
  return std::string("ICC_PROFILE\0", 12) + static_cast<char>(part) + static_cast<char>(count) +
         data;
}

std::string with_profile(const std::string& profile, int channels = 3) {
  return with_segment(small_jpeg(channels), '\xE2', profile_part(1, 1, profile));
}

/// Returns a profile with these tags. tag_count: the count in its table; -1: the real count.
std::string icc(const std::string& space,
                const std::vector<std::pair<std::string, std::string>>& tags,
                std::int64_t tag_count = -1, const std::string& kind = "mntr",
                const std::string& link = "XYZ ") {
  std::string table =
      big_endian(tag_count < 0 ? tags.size() : static_cast<std::uint64_t>(tag_count), 4);
  std::string content;
  for (const auto& [name, data] : tags) {
    table +=
        name + big_endian(132 + 12 * tags.size() + content.size(), 4) + big_endian(data.size(), 4);
    content += data;
  }
  const std::string rest = std::string("\4\x30\0\0", 4) + kind + space + link + std::string(12, 0) +
                           "acsp" + std::string(28, 0) + big_endian(0xF6D6, 4) +
                           big_endian(0x10000, 4) + big_endian(0xD32D, 4) + std::string(48, 0);
  return big_endian(128 + table.size() + content.size(), 4) + "lcms" + rest + table + content;
}

std::string xyz(int x, int y, int z) {
  return std::string("XYZ \0\0\0\0", 8) + big_endian(static_cast<std::uint32_t>(x), 4) +
         big_endian(static_cast<std::uint32_t>(y), 4) +
         big_endian(static_cast<std::uint32_t>(z), 4);
}

/// Returns an RGB profile with this curve.
std::string rgb_icc(const std::string& curve) {
  return icc("RGB ", {{"rXYZ", xyz(33'750, 15'800, 0)},
                      {"gXYZ", xyz(19'100, 45'300, 2'750)},
                      {"bXYZ", xyz(10'300, 4'390, 51'400)},
                      {"wtpt", xyz(63'190, 65'536, 54'061)},
                      {"rTRC", curve},
                      {"gTRC", curve},
                      {"bTRC", curve}});
}

std::string tone_curve(std::uint64_t count, const std::string& values) {
  return std::string("curv\0\0\0\0", 8) + big_endian(count, 4) + values;
}

/// Returns a table of colours that claims so many channels and points per side.
std::string table(const char* type, int inputs, int outputs, int points) {
  std::string bytes = type + std::string(4, 0);
  for (const int number : {inputs, outputs, points, 0}) bytes += static_cast<char>(number);
  return bytes + std::string(36, 1) + big_endian(2, 2) + big_endian(2, 2) + std::string(2000, 7);
}

void add_photo_sizes(Family& family) {
  const char* side = "the limit is 16384 pixels on a side; --limit image-side=N";
  const char* texels = "the limit is 64000000 texels; raise the limit with --limit texels=N";
  add_photo(family, "jpeg_60000", kLimit, side, jpeg_of_size(small_jpeg(), 60'000, 60'000));
  add_photo(family, "jpeg_16000", kLimit, texels, jpeg_of_size(small_jpeg(), 16'000, 16'000));
  add_photo(family, "jpeg_8000", kBadInput, "too few bytes for 8000 × 8000",
            jpeg_of_size(small_jpeg(), 8000, 8000));
  add_photo(family, "png_60000", kLimit, side, png({.width = 60'000, .height = 60'000}, "x"));
  add_photo(family, "png_16000", kLimit, texels, png({.width = 16'000, .height = 16'000}, "x"));
  add_photo(family, "png_8000", kBadInput, "too few bytes for 8000 × 8000",
            png({.width = 8000, .height = 8000}, "x"));
  const auto lossless = [](std::uint32_t width, std::uint32_t height) {
    const std::string data = '\x2f' + little_endian((width - 1) | (height - 1) << 14, 4) + "xxxx";
    return "RIFF" + little_endian(12 + data.size(), 4) + "WEBPVP8L" +
           little_endian(data.size(), 4) + data;
  };
  add_photo(family, "webp_16384", kLimit, texels, lossless(16'384, 16'384));
  add_photo(family, "webp_8000", kBadInput, "the WebP image is damaged", lossless(8000, 8000));
  add_photo(family, "webp_1", kBadInput, "the WebP image is damaged", lossless(1, 1));
  const std::string canvas = std::string("VP8X\x0a\0\0\0\x28\0\0\0", 12) + std::string(6, '\xff');
  add_photo(family, "webp_canvas_of_2_to_the_24", kBadInput, "the WebP image is damaged",
            "RIFF" + little_endian(4 + canvas.size(), 4) + "WEBP" + canvas);
  for (const std::size_t bytes : {0, 1, 11, 12, 15, 20, 25}) {
    add_photo(family, "webp_cut_at_" + std::to_string(bytes), kBadInput,
              "error: ", lossless(9, 9).substr(0, bytes));
  }
}

void add_exif(Family& family) {
  const std::string entry = std::string("\x12\1\3\0\1\0\0\0\6\0\0\0", 12);
  const std::string start = std::string("II*\0\x08\0\0\0", 8);
  const auto ignored = [&family](const std::string& name, const std::string& exif) {
    add_photo(family, "exif_" + name, kDone, "", with_exif(exif));
  };
  const std::string whole = start + std::string("\1\0", 2) + entry + std::string(4, 0);
  for (std::size_t size = 0; size < whole.size(); size += 3) {
    ignored("cut_at_" + std::to_string(size), whole.substr(0, size));
  }
  ignored("of_65535_entries", start + "\xff\xff" + entry);
  ignored("far_away", std::string("II*\0\xff\xff\xff\xff", 8) + entry);
  ignored("within_its_head", std::string("II*\0\0\0\0\0", 8) + entry);
  for (const char value : {0, 9, 127, -1}) {
    std::string wrong = whole;
    wrong[18] = value;
    ignored("orientation_" + std::to_string(static_cast<unsigned char>(value)), wrong);
  }
  add_photo(family, "exif_300_times", kDone, "", [whole] {
    const std::string data = std::string("Exif\0\0", 6) + whole + std::string(65'000, 'x');
    const std::string good = small_jpeg();
    return good.substr(0, 2) + repeated("\xFF\xE1" + big_endian(data.size() + 2, 2) + data, 300) +
           good.substr(2);
  });
}

void add_profiles(Family& family) {
  const auto ignored = [&family](const std::string& name, const std::string& profile,
                                 int channels = 3) {
    add_photo(family, "profile_" + name, kDone, "", with_profile(profile, channels));
  };
  ignored("empty", "");
  ignored("zeros", std::string(60'000, 0));
  ignored("of_4_billion_tags", icc("RGB ", {}, 0xFFFFFFFF));
  ignored("of_100_tags_of_none", icc("RGB ", {}, 100));
  ignored("curve_of_4_billion", rgb_icc(tone_curve(0xFFFFFFFF, "")));
  ignored("curve_of_60000", rgb_icc(tone_curve(30'000, std::string(60'000, 9))));
  ignored("curve_of_none", rgb_icc(tone_curve(0, "")));
  ignored("curve_of_zeros", rgb_icc(tone_curve(4, std::string(8, 0))));
  ignored("gamma_0", rgb_icc(tone_curve(1, std::string(2, 0))));
  ignored("formula_99", rgb_icc(std::string("para\0\0\0\0\0\x63\0\0", 12) + std::string(40, 1)));
  ignored("formula_of_extremes",
          rgb_icc(std::string("para\0\0\0\0\0\4\0\0", 12) + repeated("\x7f\xff\xff\xff", 7)));
  ignored("lights_of_none", icc("RGB ", {{"rXYZ", ""}, {"gXYZ", ""}, {"bXYZ", ""}}));
  ignored("link_of_devices", icc("RGB ", {}, -1, "link", "RGB "));
  ignored("named_colours", icc("RGB ", {}, -1, "nmcl", "Lab "));
  ignored("of_no_colours", icc("\xff\xfe\xfd\xfc", {}));
  for (const char* type : {"mft1", "mft2"}) {
    const auto inks = [&](const std::string& name, const std::string& data) {
      const std::string profile = icc("CMYK", {{"A2B0", data}}, -1, "prtr", "Lab ");
      ignored(std::string(type) + '_' + name, profile, 4);
    };
    inks("255_points", table(type, 4, 3, 255));
    inks("255_channels", table(type, 255, 3, 2));
    inks("255_results", table(type, 4, 255, 2));
    inks("1_point", table(type, 4, 3, 1));
    inks("2_points", table(type, 4, 3, 2));
    inks("no_channels", table(type, 0, 0, 0));
    inks("cut", table(type, 4, 3, 9).substr(0, 30));
  }
  const auto parts = [&family](const std::string& name, Bytes photo) {
    add_photo(family, "profile_" + name, kDone, "", std::move(photo));
  };
  parts("second_part_alone",
        with_segment(small_jpeg(), '\xE2', profile_part(2, 2, std::string(200, 1))));
  parts("part_0_of_0", with_segment(small_jpeg(), '\xE2', profile_part(0, 0, "x")));
  parts("of_16_MB", [] {
    std::string bytes = small_jpeg();
    const std::string data(65'000, 1);
    for (int part = 255; part > 0; --part) {
      bytes = with_segment(bytes, '\xE2', profile_part(part, 255, data));
    }
    return bytes;
  });
}

void add_chunks(Family& family) {
  const auto with_chunk = [&family](const std::string& name, const std::string& type, Bytes data) {
    add_photo(family, name, kDone, "", [type, data] {
      const PngHeader header{.width = 2, .height = 1};
      return png(header, std::string(7, 0), png_chunk(type, data()));
    });
  };
  add_photo(family, "png_profile_of_1_GB", kBadInput, "reached chunk/cache limits", [] {
    const std::string data = std::string("n\0\0", 3) + zlib_of_zeros(std::size_t{1} << 30);
    return png({.width = 2, .height = 1}, std::string(7, 0), png_chunk("iCCP", data));
  });
  with_chunk("png_profile_of_15_MB", "iCCP",
             [] { return std::string("n\0\0", 3) + zlib_of_zeros(std::size_t{15} << 20); });
  with_chunk("png_profile_without_a_name", "iCCP", "");
  with_chunk("png_profile_that_does_not_unpack", "iCCP", std::string("n\0\0xxxx", 7));
  with_chunk("png_gamma_0", "gAMA", big_endian(0, 4));
  with_chunk("png_gamma_1", "gAMA", big_endian(1, 4));
  with_chunk("png_gamma_4_billion", "gAMA", big_endian(0xFFFFFFFF, 4));
  with_chunk("png_lights_of_zeros", "cHRM", std::string(32, 0));
  with_chunk("png_lights_of_extremes", "cHRM", repeated("\x7f\xff\xff\xff", 8));
  with_chunk("png_lights_in_a_line", "cHRM", repeated(big_endian(33'333, 4), 8));
  with_chunk("png_exif_of_nothing", "eXIf", std::string("II"));
}

void add_photos_cases(Family& family) {
  add_photo_sizes(family);
  add_exif(family);
  add_profiles(family);
  add_chunks(family);
}

const Register kPhotos("photos", add_photos_cases);

}  // namespace
}  // namespace sfumato::hostile
