#include "formats/photo_files.hpp"

#include <gtest/gtest.h>
#include <lcms2.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace sfumato::test {
namespace {

void append(std::string_view text, Bytes& out) {
  out.insert(out.end(), text.begin(), text.end());
}

void append_little(std::uint32_t value, int byte_count, Bytes& out) {
  for (int i = 0; i < byte_count; ++i) out.push_back(static_cast<std::uint8_t>(value >> 8 * i));
}

/// Returns the bytes of the profile, and closes it.
Bytes saved(cmsHPROFILE profile) {
  cmsUInt32Number size = 0;
  EXPECT_TRUE(profile && cmsSaveProfileToMem(profile, nullptr, &size));
  Bytes bytes(size);
  EXPECT_TRUE(cmsSaveProfileToMem(profile, bytes.data(), &size));
  cmsCloseProfile(profile);
  return bytes;
}

/// Returns a profile with sRGB's curve and white.
Bytes rgb_profile(const cmsCIExyYTRIPLE& primaries) {
  constexpr std::array<double, 5> kSrgbCurve{2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045};
  cmsToneCurve* const curve = cmsBuildParametricToneCurve(nullptr, 4, kSrgbCurve.data());
  const std::array<cmsToneCurve*, 3> curves{curve, curve, curve};
  constexpr cmsCIExyY kWhitePoint{0.3127, 0.3290, 1};
  Bytes bytes = saved(cmsCreateRGBProfile(&kWhitePoint, &primaries, curves.data()));
  cmsFreeToneCurve(curve);
  return bytes;
}

/// Computes Lab of four inks, both as 16-bit values of the library.
cmsInt32Number darken(const cmsUInt16Number* inks, cmsUInt16Number* lab, void*) {
  const double color = (inks[0] + inks[1] + inks[2]) / (3 * 65535.0), black = inks[3] / 65535.0;
  const cmsCIELab value{100 * (1 - color) * (1 - black), 0, 0};
  cmsFloat2LabEncoded(lab, &value);
  return 1;
}

void append_webp_chunk(std::string_view name, const Bytes& data, Bytes& out) {
  append(name, out);
  append_little(static_cast<std::uint32_t>(data.size()), 4, out);
  out.insert(out.end(), data.begin(), data.end());
  if (data.size() % 2 != 0) out.push_back(0);
}

}  // namespace

Bytes exif_of(int orientation, bool is_big_endian) {
  Bytes exif;
  append(is_big_endian ? "MM" : "II", exif);
  const auto number = [&](std::uint32_t value, int byte_count) {
    for (int i = 0; i < byte_count; ++i) {
      const int shift = 8 * (is_big_endian ? byte_count - 1 - i : i);
      exif.push_back(static_cast<std::uint8_t>(value >> shift));
    }
  };
  number(42, 2), number(8, 4), number(3, 2);
  const auto entry = [&](std::uint32_t tag, std::uint32_t value) {
    number(tag, 2), number(3, 2), number(1, 4), number(value, 2), number(0, 2);
  };
  entry(0x0100, 7);
  entry(0x0112, static_cast<std::uint32_t>(orientation));
  entry(0x0128, 2);
  number(0, 4);
  return exif;
}

Bytes srgb_profile() {
  return saved(cmsCreate_sRGBProfile());
}

Bytes display_p3_profile() {
  return rgb_profile({{0.680, 0.320, 1}, {0.265, 0.690, 1}, {0.150, 0.060, 1}});
}

Bytes swapped_profile() {
  return rgb_profile({{0.15, 0.06, 1}, {0.30, 0.60, 1}, {0.64, 0.33, 1}});
}

Bytes gray_profile(double gamma) {
  cmsToneCurve* const curve = cmsBuildGamma(nullptr, gamma);
  Bytes bytes = saved(cmsCreateGrayProfile(cmsD50_xyY(), curve));
  cmsFreeToneCurve(curve);
  return bytes;
}

Bytes ink_profile() {
  cmsHPROFILE profile = cmsCreateProfilePlaceholder(nullptr);
  cmsSetProfileVersion(profile, 4.3);
  cmsSetDeviceClass(profile, cmsSigOutputClass);
  cmsSetColorSpace(profile, cmsSigCmykData);
  cmsSetPCS(profile, cmsSigLabData);
  cmsPipeline* const pipeline = cmsPipelineAlloc(nullptr, 4, 3);
  cmsStage* const table = cmsStageAllocCLut16bit(nullptr, 9, 4, 3, nullptr);
  EXPECT_TRUE(cmsStageSampleCLut16bit(table, darken, nullptr, 0));
  cmsPipelineInsertStage(pipeline, cmsAT_END, cmsStageAllocToneCurves(nullptr, 4, nullptr));
  cmsPipelineInsertStage(pipeline, cmsAT_END, table);
  cmsPipelineInsertStage(pipeline, cmsAT_END, cmsStageAllocToneCurves(nullptr, 3, nullptr));
  EXPECT_TRUE(cmsWriteTag(profile, cmsSigAToB0Tag, pipeline));
  cmsPipelineFree(pipeline);
  return saved(profile);
}

Bytes png_profile(const Bytes& profile) {
  Bytes data;
  append(std::string_view("name\0\0", 6), data);
  const Bytes content = packed(profile);
  data.insert(data.end(), content.begin(), content.end());
  return data;
}

Bytes with_segment(const Bytes& jpeg, int marker, const Bytes& data) {
  Bytes segment{0xFF, static_cast<std::uint8_t>(marker)};
  segment.push_back(static_cast<std::uint8_t>((data.size() + 2) >> 8));
  segment.push_back(static_cast<std::uint8_t>(data.size() + 2));
  segment.insert(segment.end(), data.begin(), data.end());
  Bytes file = jpeg;
  file.insert(file.begin() + 2, segment.begin(), segment.end());
  return file;
}

Bytes with_exif(const Bytes& jpeg, const Bytes& exif) {
  Bytes data;
  append(std::string_view("Exif\0\0", 6), data);
  data.insert(data.end(), exif.begin(), exif.end());
  return with_segment(jpeg, 0xE1, data);
}

Bytes with_profile(const Bytes& jpeg, const Bytes& profile, std::size_t part_bytes) {
  const std::size_t parts = (profile.size() + part_bytes - 1) / part_bytes;
  Bytes file = jpeg;
  for (std::size_t part = parts; part-- > 0;) {
    Bytes data;
    append(std::string_view("ICC_PROFILE\0", 12), data);
    data.push_back(static_cast<std::uint8_t>(part + 1));
    data.push_back(static_cast<std::uint8_t>(parts));
    const auto begin = profile.begin() + static_cast<std::ptrdiff_t>(part * part_bytes);
    const std::size_t count = std::min(part_bytes, profile.size() - part * part_bytes);
    data.insert(data.end(), begin, begin + static_cast<std::ptrdiff_t>(count));
    file = with_segment(file, 0xE2, data);
  }
  return file;
}

Bytes webp_with(const Bytes& webp, const Bytes& profile, const Bytes& exif, int width, int height,
                int flags) {
  constexpr int kProfileFlag = 0x20, kExifFlag = 0x08;
  Bytes chunks, header;
  append("WEBP", chunks);
  if (!profile.empty()) flags |= kProfileFlag;
  if (!exif.empty()) flags |= kExifFlag;
  append_little(static_cast<std::uint32_t>(flags), 4, header);
  append_little(static_cast<std::uint32_t>(width - 1), 3, header);
  append_little(static_cast<std::uint32_t>(height - 1), 3, header);
  append_webp_chunk("VP8X", header, chunks);
  if (!profile.empty()) append_webp_chunk("ICCP", profile, chunks);
  chunks.insert(chunks.end(), webp.begin() + 12, webp.end());
  if (!exif.empty()) append_webp_chunk("EXIF", exif, chunks);
  Bytes file;
  append("RIFF", file);
  append_little(static_cast<std::uint32_t>(chunks.size()), 4, file);
  file.insert(file.end(), chunks.begin(), chunks.end());
  return file;
}

}  // namespace sfumato::test
