// JPEG textures that are inconsistent, truncated, or ask for endless work.
#include "hostile/case.hpp"
#include "hostile/documents.hpp"
#include "hostile/images.hpp"

namespace sfumato::hostile {
namespace {

void add_jpeg_kinds(Family& family) {
  const struct {
    const char* name;
    int channels;
    JpegKind kind;
  } kKinds[] = {
      {"gray", 1, JpegKind::baseline},
      {"rgb", 3, JpegKind::baseline},
      {"cmyk", 4, JpegKind::baseline},
      {"progressive", 3, JpegKind::progressive},
      {"cmyk_progressive", 4, JpegKind::progressive},
      {"arithmetic", 3, JpegKind::arithmetic},
      {"arithmetic_progressive", 3, JpegKind::arithmetic_progressive},
  };
  for (const auto& of : kKinds) {
    const auto make = [of] { return jpeg(24, 16, of.channels, of.kind); };
    const std::string label = of.name;
    family.add(label, kDone, "", kTextured).with("t", make);
    family.add(label + "_60000", kLimit, "the limit is 16384 pixels on a side", kTextured)
        .with("t", [make] { return jpeg_of_size(make(), 60'000, 60'000); });
    family.add(label + "_65500_by_1", kLimit, "the limit is 16384 pixels on a side", kTextured)
        .with("t", [make] { return jpeg_of_size(make(), 65'500, 1); });
    family.add(label + "_8000", kBadInput, "the JPEG image is damaged", kTextured)
        .with("t", [make] { return jpeg_of_size(make(), 8000, 8000); });
    family.add(label + "_without_size", kBadInput, "the JPEG image is damaged", kTextured)
        .with("t", [make] { return jpeg_of_size(make(), 0, 0); });
    family.add(label + "_half", kBadInput, "the JPEG image is damaged", kTextured)
        .with("t", [make] {
          const std::string whole = make();
          return whole.substr(0, whole.size() - 12);
        });
  }
}

void add_jpeg_damage(Family& family) {
  const std::string good = jpeg(24, 16, 3, JpegKind::baseline);
  const auto damaged = [&](const std::string& name, std::string bytes,
                           const char* message = "\"t\": the JPEG image is damaged") {
    family.add(name, kBadInput, message, kTextured).with("t", std::move(bytes));
  };
  for (std::size_t i = 3; i < good.size(); i += good.size() / 14) {
    damaged("cut_at_" + std::to_string(i), good.substr(0, i));
  }
  damaged("signature_alone", "\xFF\xD8\xFF");
  damaged("half_a_signature", "\xFF\xD8", "neither a PNG nor a JPEG");
  damaged("end_at_once", "\xFF\xD8\xFF\xD9");
  damaged("fill_bytes_a_million", "\xFF\xD8" + std::string(1 << 20, '\xFF'));
  damaged("two_frames",
          good.substr(0, jpeg_marker(good, 0xC4)) + good.substr(jpeg_marker(good, 0xC0)));
  damaged("no_frame",
          good.substr(0, jpeg_marker(good, 0xC0)) + good.substr(jpeg_marker(good, 0xC4)));
  family.add("tables_by_default", kDone, "", kTextured)
      .with("t", good.substr(0, jpeg_marker(good, 0xC4)) + good.substr(jpeg_marker(good, 0xDA)));
  damaged("no_quantization", "\xFF\xD8" + good.substr(jpeg_marker(good, 0xC0)));
  const auto changed = [&good](std::size_t at, int value) {
    std::string bytes = good;
    bytes[at] = static_cast<char>(value);
    return bytes;
  };
  const std::size_t frame = jpeg_marker(good, 0xC0);
  damaged("precision_12", changed(frame + 4, 12));
  damaged("precision_0", changed(frame + 4, 0));
  damaged("components_0", changed(frame + 9, 0));
  damaged("components_255", changed(frame + 9, 255));
  damaged("sampling_0", changed(frame + 11, 0));
  damaged("sampling_15", changed(frame + 11, 0xff));
  damaged("quantization_table_9", changed(frame + 12, 9));
  damaged("frame_of_length_0", changed(frame + 3, 0));
  damaged("huffman_table_of_300", changed(jpeg_marker(good, 0xC4) + 8, 255));
  damaged("huffman_table_99", changed(jpeg_marker(good, 0xC4) + 4, 99));
  damaged("scan_of_5", changed(jpeg_marker(good, 0xDA) + 4, 5));
  damaged("lossless", changed(frame + 1, 0xC3));
  damaged("hierarchical", changed(frame + 1, 0xC5));
  family.add("application_segments_1000", kDone, "", kTextured).with("t", [good] {
    return good.substr(0, 2) +
           repeated(std::string("\xFF\xE1\xFF\xFF", 4) + std::string(0xFFFD, 'x'), 300) +
           good.substr(2);
  });
  family.add("comments_100000", kDone, "", kTextured).with("t", [good] {
    return good.substr(0, 2) + repeated(std::string("\xFF\xFE\0\2", 4), 100'000) + good.substr(2);
  });
  family.add("tables_10000", kDone, "", kTextured).with("t", [good] {
    const std::size_t begin = jpeg_marker(good, 0xDB), end = jpeg_marker(good, 0xC0);
    return good.substr(0, 2) + repeated(good.substr(begin, end - begin), 10'000) + good.substr(2);
  });
  family.add("bytes_behind", kDone, "", kTextured).with("t", [good] {
    return good + std::string(1 << 20, '\xFF');
  });
}

void add_jpeg_work(Family& family) {
  const char* scans = "the JPEG image is damaged: more than";
  family.add("scans_5000", kBadInput, scans, kTextured).with("t", [] {
    return jpeg_of_scans(64, 64, 5000);
  });
  family.add("scans_150_of_4000_by_4000", kBadInput, scans, kTextured).with("t", [] {
    return jpeg_of_scans(4000, 4000, 150);
  });
  family.add("scans_20_of_2000_by_2000", kDone, "", kTextured).with("t", [] {
    return jpeg_of_scans(2000, 2000, 20);
  });
  family.add("arithmetic_blank_3000_by_3000", kBadInput, "too few bytes", kTextured).with("t", [] {
    return jpeg(3000, 3000, 1, JpegKind::arithmetic);
  });
  family.add("progressive_3000_by_3000", kDone, "", kTextured).with("t", [] {
    return jpeg(3000, 3000, 3, JpegKind::progressive);
  });
  family.add("restarts_without_end", kBadInput, "the JPEG image is damaged", kTextured)
      .with("t", [] {
        std::string bytes = jpeg(64, 64, 1, JpegKind::baseline);
        const std::size_t scan = jpeg_marker(bytes, 0xDA);
        return bytes.substr(0, scan) + std::string("\xFF\xDD\0\4\0\1", 6) + bytes.substr(scan, 10) +
               repeated("\xFF\xD0\xFF\xD1", 100'000);
      });
}

void add_jpeg_cases(Family& family) {
  add_jpeg_kinds(family);
  add_jpeg_damage(family);
  add_jpeg_work(family);
}

const Register kJpeg("jpeg", add_jpeg_cases);

}  // namespace
}  // namespace sfumato::hostile
