#include "codecs/photo/photo_profile.hpp"

#include <lcms2.h>

#include <cstdlib>
#include <string>
#include <utility>

#include "base/owned.hpp"
#include "base/try.hpp"
#include "codecs/photo/photo_profile_memory.hpp"

namespace sfumato::codecs {
namespace {

using Profile = Owned<void, cmsCloseProfile>;
using Transform = Owned<void, cmsDeleteTransform>;
using Curve = Owned<cmsToneCurve, cmsFreeToneCurve>;

/// The places of a profile's kind and colours in its header. The library has enumerations for them
/// but accepts any number as their value.
constexpr std::size_t kKindAt = 12;
constexpr std::size_t kSpaceAt = 16;

/// Returns four bytes, big-endian. Precondition: the library has opened the profile, so its header
/// is complete.
std::uint32_t number_at(std::span<const std::uint8_t> profile, std::size_t at) {
  return std::uint32_t{profile[at]} << 24 | std::uint32_t{profile[at + 1]} << 16 |
         std::uint32_t{profile[at + 2]} << 8 | profile[at + 3];
}

const char* name_of(PhotoChannels channels) {
  return is_cmyk(channels) ? "CMYK" : channels == PhotoChannels::gray ? "gray" : "RGB";
}

/// Returns whether a profile of such colours can be used for such channels. A gray picture has
/// three equal channels.
bool fits(std::uint32_t space, PhotoChannels channels) {
  if (is_cmyk(channels)) return space == cmsSigCmykData;
  return space == cmsSigRgbData || (space == cmsSigGrayData && channels == PhotoChannels::gray);
}

/// Returns whether it is a profile of a device or a colour space, not a link of two devices and not
/// named colours.
bool is_of_colors(std::uint32_t kind) {
  return kind == cmsSigInputClass || kind == cmsSigDisplayClass || kind == cmsSigOutputClass ||
         kind == cmsSigColorSpaceClass;
}

/// Returns the library's description of pixels in memory.
cmsUInt32Number format_of(std::uint32_t space, const PhotoPixels& pixels) {
  const auto bytes = static_cast<cmsUInt32Number>(pixels.bytes_per_channel);
  const auto all = static_cast<cmsUInt32Number>(pixels.channel_count);
  if (space == cmsSigGrayData) {
    return COLORSPACE_SH(PT_GRAY) | CHANNELS_SH(1) | EXTRA_SH(all - 1) | BYTES_SH(bytes);
  }
  if (space == cmsSigCmykData) {
    const bool is_inverted = pixels.channels == PhotoChannels::cmyk_inverted;
    return COLORSPACE_SH(PT_CMYK) | CHANNELS_SH(4) | FLAVOR_SH(is_inverted ? 1 : 0) |
           BYTES_SH(bytes);
  }
  return COLORSPACE_SH(PT_RGB) | CHANNELS_SH(3) | EXTRA_SH(all - 3) | BYTES_SH(bytes);
}

/// By default the library converts pixels by a table of 33³ colours, up to 20 code values off. Only
/// for curves and a matrix it has a better way, with 8 bits.
cmsUInt32Number flags_for(cmsHPROFILE profile, std::uint32_t space, const PhotoPixels& pixels) {
  const cmsUInt32Number flags = cmsFLAGS_NOCACHE | cmsFLAGS_BLACKPOINTCOMPENSATION;
  const bool is_matrix = space == cmsSigRgbData && cmsIsMatrixShaper(profile) &&
                         !cmsIsTag(profile, cmsSigAToB0Tag) && !cmsIsTag(profile, cmsSigAToB1Tag);
  return is_matrix && pixels.bytes_per_channel == 1 ? flags : flags | cmsFLAGS_NOOPTIMIZE;
}

Profile profile_of_numbers(cmsContext library, std::optional<double> gamma,
                           const std::optional<std::array<Vec2, 4>>& chroma) {
  constexpr std::array<double, 5> kSrgbCurve{2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045};
  const Curve curve(gamma ? cmsBuildGamma(library, 1 / *gamma)
                          : cmsBuildParametricToneCurve(library, 4, kSrgbCurve.data()));
  if (!curve) return nullptr;
  constexpr std::array<Vec2, 4> kSrgbChroma{
      {{0.3127, 0.3290}, {0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}}};
  const std::array<Vec2, 4> lights = chroma.value_or(kSrgbChroma);
  const auto color = [&lights](std::size_t i) { return cmsCIExyY{lights[i].x, lights[i].y, 1}; };
  const cmsCIExyY white = color(0);
  const cmsCIExyYTRIPLE primaries{color(1), color(2), color(3)};
  const std::array<cmsToneCurve*, 3> curves{curve.get(), curve.get(), curve.get()};
  return Profile(cmsCreateRGBProfileTHR(library, &white, &primaries, curves.data()));
}

/// Leaves out chains of elements. They may have any length, each pixel would go through all of
/// them, and every profile has other data that can be used instead.
void drop_chains(cmsHPROFILE profile) {
  for (const cmsTagSignature tag :
       {cmsSigDToB0Tag, cmsSigDToB1Tag, cmsSigDToB2Tag, cmsSigDToB3Tag, cmsSigBToD0Tag,
        cmsSigBToD1Tag, cmsSigBToD2Tag, cmsSigBToD3Tag}) {
    if (cmsIsTag(profile, tag)) cmsWriteTag(profile, tag, nullptr);
  }
}

}  // namespace

/// Holds all parts of one conversion; the memory outlives the rest.
struct ToSrgb::Library {
  explicit Library(const Context& of) : memory(of) {}

  Status open() {
    Result<ProfileContext> opened = memory.open();
    if (opened) context = std::move(*opened);
    return opened.status();
  }

  /// Returns the status of a call of the library that failed.
  Status failure(std::string message) const {
    return memory.status() ? make_error(StatusCode::bad_input, std::move(message))
                           : memory.status();
  }
  Status link(const PhotoPixels& pixels);
  Transform transform_of(const PhotoPixels& pixels) const;
  bool changes_nothing(const PhotoPixels& pixels) const;

  ProfileMemory memory;
  ProfileContext context;
  Profile source, srgb;
  std::uint32_t space = cmsSigRgbData;  ///< of the source
  Transform transform;
};

Transform ToSrgb::Library::transform_of(const PhotoPixels& pixels) const {
  const auto bytes = static_cast<cmsUInt32Number>(pixels.bytes_per_channel);
  return Transform(
      cmsCreateTransformTHR(context.get(), source.get(), format_of(space, pixels), srgb.get(),
                            COLORSPACE_SH(PT_RGB) | CHANNELS_SH(3) | BYTES_SH(bytes),
                            INTENT_RELATIVE_COLORIMETRIC, flags_for(source.get(), space, pixels)));
}

/// Compares a grid of colours with their converted values.
bool ToSrgb::Library::changes_nothing(const PhotoPixels& pixels) const {
  if (is_cmyk(pixels.channels)) return false;
  const auto deep = transform_of({pixels.channels, 3, 2});
  if (!deep) return false;
  constexpr int kSteps = 8, kMostDifference = 128;
  const int most = pixels.channels == PhotoChannels::gray ? 0 : kSteps;
  for (int r = 0; r <= kSteps; ++r) {
    for (int g = 0; g <= most; ++g) {
      for (int b = 0; b <= most; ++b) {
        std::array<std::uint16_t, 3> color{}, converted{};
        const std::array<int, 3> steps{r, most == 0 ? r : g, most == 0 ? r : b};
        for (int c = 0; c < 3; ++c) {
          color[c] = static_cast<std::uint16_t>(steps[c] * 65535 / kSteps);
        }
        cmsDoTransform(deep.get(), color.data(), converted.data(), 1);
        for (int c = 0; c < 3; ++c) {
          if (std::abs(int{color[c]} - int{converted[c]}) > kMostDifference) return false;
        }
      }
    }
  }
  return true;
}

Status ToSrgb::Library::link(const PhotoPixels& pixels) {
  srgb.reset(cmsCreate_sRGBProfileTHR(context.get()));
  if (srgb) transform = transform_of(pixels);
  return transform ? ok_status() : failure("it cannot be used");
}

ToSrgb::ToSrgb(std::unique_ptr<Library> library) : library_(std::move(library)) {}
ToSrgb::ToSrgb(ToSrgb&&) noexcept = default;
ToSrgb& ToSrgb::operator=(ToSrgb&&) noexcept = default;
ToSrgb::~ToSrgb() = default;

Result<ToSrgb> ToSrgb::make(std::unique_ptr<Library> library, const PhotoPixels& pixels) {
  SFUMATO_TRY(library->link(pixels));
  ToSrgb conversion(std::move(library));
  conversion.is_identity_ = conversion.library_->changes_nothing(pixels);
  // The library may continue without memory that it was refused.
  SFUMATO_TRY(conversion.library_->memory.status());
  return conversion;
}

Result<ToSrgb> ToSrgb::by_profile(const Context& context, std::span<const std::uint8_t> profile,
                                  const PhotoPixels& pixels) {
  auto library = std::make_unique<Library>(context);
  SFUMATO_TRY(library->open());
  library->source.reset(cmsOpenProfileFromMemTHR(library->context.get(), profile.data(),
                                                 static_cast<cmsUInt32Number>(profile.size())));
  const cmsHPROFILE source = library->source.get();
  if (!source) return library->failure("it is damaged");
  library->space = number_at(profile, kSpaceAt);
  if (!is_of_colors(number_at(profile, kKindAt)) || !fits(library->space, pixels.channels)) {
    return library->failure(std::string("it is not one of ") + name_of(pixels.channels) +
                            " colours");
  }
  drop_chains(source);
  return make(std::move(library), pixels);
}

Result<ToSrgb> ToSrgb::by_numbers(const Context& context, std::optional<double> gamma,
                                  const std::optional<std::array<Vec2, 4>>& chroma,
                                  const PhotoPixels& pixels) {
  auto library = std::make_unique<Library>(context);
  SFUMATO_TRY(library->open());
  library->source = profile_of_numbers(library->context.get(), gamma, chroma);
  if (!library->source) return library->failure("they cannot be used");
  return make(std::move(library), pixels);
}

void ToSrgb::convert(const std::uint8_t* from, std::uint8_t* rgb, std::size_t count) const {
  cmsDoTransform(library_->transform.get(), from, rgb, static_cast<cmsUInt32Number>(count));
}

}  // namespace sfumato::codecs
