// PNG textures that are inconsistent, truncated, or unpack to gigabytes.
#include <functional>

#include "hostile/case.hpp"
#include "hostile/documents.hpp"
#include "hostile/images.hpp"

namespace sfumato::hostile {
namespace {

void add_png_headers(Family& family) {
  const auto lying = [&](const char* name, int code, const char* message, PngHeader header) {
    family.add(name, code, message, kTextured).with("t", [header] {
      return png_header(header) + png_chunk("IDAT", zlib_packed("x")) + png_chunk("IEND", "");
    });
  };
  const char* damaged = "the PNG image is damaged";
  lying("size_60000", kLimit, "the limit is 16384 pixels on a side", {60'000, 60'000});
  lying("size_2_to_31", kLimit, "the limit is 16384 pixels on a side", {0x7fffffff, 0x7fffffff});
  lying("size_2_to_32", kLimit, "the limit is 16384 pixels on a side", {0xffffffff, 0xffffffff});
  lying("width_60000", kLimit, "the limit is 16384 pixels on a side", {60'000, 10});
  lying("height_60000", kLimit, "the limit is 16384 pixels on a side", {10, 60'000});
  lying("size_within_the_limits", kBadInput, "too few bytes for 8000 × 8000 pixels", {8000, 8000});
  lying("size_within_the_limits_of_16_bits", kBadInput, "too few bytes", {8000, 8000, 16, 6});
  lying("no_width", kBadInput, damaged, {0, 15});
  lying("no_height", kBadInput, damaged, {15, 0});
  lying("no_size", kBadInput, damaged, {0, 0});
  lying("depth_3", kBadInput, damaged, {15, 15, 3, 0});
  lying("depth_0", kBadInput, damaged, {15, 15, 0, 0});
  lying("depth_255", kBadInput, damaged, {15, 15, 255, 0});
  lying("depth_16_of_a_palette", kBadInput, damaged, {15, 15, 16, 3});
  lying("colour_type_1", kBadInput, damaged, {15, 15, 8, 1});
  lying("colour_type_7", kBadInput, damaged, {15, 15, 8, 7});
  lying("compression_1", kBadInput, damaged, {15, 15, 8, 2, 1});
  lying("filter_1", kBadInput, damaged, {15, 15, 8, 2, 0, 1});
  lying("interlace_2", kBadInput, damaged, {15, 15, 8, 2, 0, 0, 2});
  lying("interlaced_without_data", kBadInput, damaged, {15, 15, 8, 2, 0, 0, 1});
  lying("palette_missing", kBadInput, damaged, {15, 15, 8, 3});
}

void add_png_kinds(Family& family) {
  const auto kind = [&](const char* name, PngHeader header, std::size_t bytes,
                        std::string before = "") {
    family.add(name, kDone, "", kTextured).with("t", [header, bytes, before] {
      return png(header, std::string(bytes, '\0'), before);
    });
  };
  const std::string palette = png_chunk("PLTE", std::string(6, 'x'));
  kind("interlaced", {15, 15, 8, 2, 0, 0, 1}, 9999);
  kind("interlaced_one_pixel", {1, 1, 8, 2, 0, 0, 1}, 99);
  kind("interlaced_thin", {1, 999, 1, 0, 0, 0, 1}, 9999);
  kind("gray_of_1_bit", {15, 15, 1, 0}, 45);
  kind("gray_of_16_bits", {15, 15, 16, 0}, 465);
  kind("rgba_of_16_bits", {15, 15, 16, 6}, 1815);
  kind("gray_and_alpha", {15, 15, 8, 4}, 465);
  kind("palette", {15, 15, 8, 3}, 240, palette);
  kind("transparent_gray", {15, 15, 8, 0}, 240, png_chunk("tRNS", std::string(2, '\0')));
  kind("transparent_palette", {15, 15, 8, 3}, 240, palette + png_chunk("tRNS", "x"));
  kind("more_data_than_pixels", {15, 15, 8, 2}, 99'999);
  kind("one_pixel", {1, 1, 8, 2}, 4);
  kind("row_of_16384", {16'384, 1, 1, 0}, 2049);
}

void add_png_damage(Family& family) {
  const std::string good = good_png();
  const auto damaged = [&](const std::string& name, std::string bytes,
                           const char* message = "\"t\": the PNG image is damaged") {
    family.add(name, kBadInput, message, kTextured).with("t", std::move(bytes));
  };
  family.add("good", kDone, "", kTextured).with("t", good);
  for (const std::size_t at : {8, 12, 16, 29, 33, 37, 41, 60, 200}) {
    damaged("cut_at_" + std::to_string(at), good.substr(0, at));
  }
  damaged("cut_before_the_end", good.substr(0, good.size() - 12));
  damaged("cut_in_the_end", good.substr(0, good.size() - 1));
  damaged("signature_alone", kPngSignature);
  damaged("signature_of_an_upload", "\x89PNG\n\x1a\n" + good.substr(8), "neither a PNG nor a JPEG");
  for (const auto& [name, at] : {std::pair("header", 29), {"data", 45}, {"end", -1}}) {
    std::string bytes = good;
    const std::size_t index = at < 0 ? bytes.size() - 1 : static_cast<std::size_t>(at);
    bytes[index] = static_cast<char>(bytes[index] ^ 1);
    damaged(std::string("crc_of_the_") + name, bytes);
  }
  damaged("two_headers", png_header({}) + png_header({}).substr(8) + png_chunk("IEND", ""));
  family.add("data_first", kLimit, "the limit is 16384 pixels on a side", kTextured)
      .with("t", kPngSignature + png_chunk("IDAT", "") + good.substr(8));
  damaged("no_data", png_header({}) + png_chunk("IEND", ""));
  damaged("empty_data", png_header({}) + png_chunk("IDAT", "") + png_chunk("IEND", ""));
  damaged("data_that_are_no_zlib",
          png_header({}) + png_chunk("IDAT", std::string(999, 'x')) + png_chunk("IEND", ""));
  damaged("data_too_short", png({}, std::string(9, '\0')));
  damaged("filter_of_a_row", png({}, std::string(999, '\x05')));
  damaged("palette_of_5_bytes",
          png({15, 15, 8, 3}, std::string(240, '\0'), png_chunk("PLTE", "12345")));
  family.add("palette_index_beyond", kDone, "", kTextured)
      .with("t", png({15, 15, 8, 3}, std::string(240, '\x01'), png_chunk("PLTE", "123")));
  damaged("chunk_of_2_gib", good.substr(0, 33) + "\x7f\xff\xff\xff" + "IDAT");
  damaged("chunk_of_4_gib", good.substr(0, 33) + "\xff\xff\xff\xff" + "IDAT");
  damaged("critical_chunk_unknown", good.substr(0, 33) + png_chunk("ABCD", "x") + good.substr(33));
  damaged("data_apart", png_header({}) + png_chunk("IDAT", "\x78") + png_chunk("tEXt", "a") +
                            png_chunk("IDAT", "\x9c") + png_chunk("IEND", ""));
  family.add("data_of_a_million_empty_chunks", kDone, "", kTextured).with("t", [good] {
    const std::string empty = png_chunk("IDAT", "");
    return good.substr(0, 33) + repeated(empty, 200'000) + good.substr(33);
  });
  family.add("data_byte_by_byte", kDone, "", kTextured).with("t", [good] {
    std::string bytes = good.substr(0, 33);
    for (std::size_t i = 41; i + 16 < good.size(); ++i)
      bytes += png_chunk("IDAT", good.substr(i, 1));
    return bytes + png_chunk("IEND", "");
  });
}

void add_png_bombs(Family& family) {
  const std::string good = good_png();
  const auto with_chunks = [&](const char* name, int code, const char* message,
                               std::function<std::string()> chunks) {
    family.add(name, code, message, kTextured).with("t", [good, chunks] {
      return good.substr(0, 33) + chunks() + good.substr(33);
    });
  };
  with_chunks("texts_200000", kBadInput, "is damaged",
              [] { return repeated(png_chunk("tEXt", std::string("a\0b", 3)), 200'000); });
  with_chunks("text_bomb", kBadInput, "is damaged", [] {
    return png_chunk("zTXt", std::string("a\0\0", 3) + zlib_of_zeros(std::size_t{1} << 30));
  });
  with_chunks("text_bombs_100", kBadInput, "is damaged", [] {
    return repeated(png_chunk("zTXt", std::string("a\0\0", 3) + zlib_of_zeros(10 << 20)), 100);
  });
  with_chunks("profile_bomb", kBadInput, "is damaged", [] {
    return png_chunk("iCCP", std::string("a\0\0", 3) + zlib_of_zeros(std::size_t{1} << 30));
  });
  with_chunks("international_text_bomb", kBadInput, "is damaged", [] {
    return png_chunk("iTXt", std::string("a\0\1\0\0\0", 6) + zlib_of_zeros(std::size_t{1} << 30));
  });
  with_chunks("suggested_palettes_20000", kBadInput, "is damaged", [] {
    std::string chunks;
    for (int i = 0; i < 20'000; ++i) {
      chunks += png_chunk("sPLT", std::to_string(i) + std::string("\0\x08", 2));
    }
    return chunks;
  });
  with_chunks("unknown_chunks_200000", kDone, "",
              [] { return repeated(png_chunk("abCd", "x"), 200'000); });
  family.add("zeros_20000_by_20000", kLimit, "the limit is 16384 pixels on a side", kTextured)
      .with("t", [] {
        return png_of_zeros({20'000, 20'000, 8, 0}, 20'000);
      });
  family.add("zeros_of_a_gibibyte_behind", kDone, "", kTextured).with("t", [] {
    return png_header({}) + png_chunk("IDAT", zlib_of_zeros(std::size_t{1} << 30)) +
           png_chunk("IEND", "");
  });
  family.add("zeros_3000_by_3000", kDone, "", kTextured).with("t", [] {
    return png_of_zeros({3000, 3000, 8, 2}, 9000);
  });
  family.add("zeros_8000_by_8000_in_little_memory", kLimit, "memory limit of 200 MiB", kTextured)
      .also({"--max-memory", "200"})
      .with("t", [] {
        return png_of_zeros({8000, 8000, 8, 2}, 24'000);
      });
  family.add("interlaced_3000_by_2000", kDone, "", kTextured).with("t", [] {
    // Seven passes with their own rows: slightly more than the whole.
    return png_header({3000, 2000, 8, 0, 0, 0, 1}) +
           png_chunk("IDAT", zlib_of_zeros(3000 * 2000 + 9000)) + png_chunk("IEND", "");
  });
}

void add_png_cases(Family& family) {
  add_png_headers(family);
  add_png_kinds(family);
  add_png_damage(family);
  add_png_bombs(family);
}

const Register kPng("png", add_png_cases);

}  // namespace
}  // namespace sfumato::hostile
