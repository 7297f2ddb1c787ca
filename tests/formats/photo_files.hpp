#pragma once

#include <cstdint>
#include <vector>

#include "formats/png_chunks.hpp"

/// Parts of photos: EXIF data, colour profiles, and files with them.
namespace sfumato::test {

/// Returns EXIF data with one entry before the orientation and one after it.
Bytes exif_of(int orientation, bool is_big_endian = false);

/// Profiles that lcms2 makes.
Bytes srgb_profile();
Bytes display_p3_profile();
/// Red is sRGB's blue, and blue is sRGB's red.
Bytes swapped_profile();
Bytes gray_profile(double gamma);
/// Any ink darkens the paper, and black ink most: L* = 100 (1 − (c + m + y) / 3) (1 − k).
Bytes ink_profile();

/// Returns the data of an iCCP chunk.
Bytes png_profile(const Bytes& profile);

/// Returns a JPEG with one more segment after its first two bytes. marker: 0xE1 for APP1.
Bytes with_segment(const Bytes& jpeg, int marker, const Bytes& data);
Bytes with_exif(const Bytes& jpeg, const Bytes& exif);
/// Returns a JPEG with the profile in segments of so many bytes.
Bytes with_profile(const Bytes& jpeg, const Bytes& profile, std::size_t part_bytes = 60'000);

/// Returns a WebP of one picture with more chunks; empty ones are left out.
/// flags: further flags of the extended header
Bytes webp_with(const Bytes& webp, const Bytes& profile, const Bytes& exif, int width, int height,
                int flags = 0);

}  // namespace sfumato::test
