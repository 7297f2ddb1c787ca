#pragma once

#include <cstdint>
#include <vector>

#include "formats/png_chunks.hpp"

/// Parts of photos: EXIF data, colour profiles, and files that hold them.
namespace sfumato::test {

/// EXIF data with one entry before that of the orientation and one after.
Bytes exif_of(int orientation, bool is_big_endian = false);

/// Profiles that lcms2 makes.
Bytes srgb_profile();
Bytes display_p3_profile();
/// Red is what blue is in sRGB, and the other way round.
Bytes swapped_profile();
Bytes gray_profile(double gamma);
/// Any ink makes the paper darker, and black ink most: L* = 100 (1 − (c + m + y) / 3) (1 − k).
Bytes ink_profile();

/// The data of an iCCP chunk.
Bytes png_profile(const Bytes& profile);

/// A JPEG with a segment more, behind its first two bytes. marker: 0xE1 for APP1.
Bytes with_segment(const Bytes& jpeg, int marker, const Bytes& data);
Bytes with_exif(const Bytes& jpeg, const Bytes& exif);
/// In segments of so many bytes.
Bytes with_profile(const Bytes& jpeg, const Bytes& profile, std::size_t part_bytes = 60'000);

/// A WebP of one picture with chunks more; what is empty is left out.
/// flags  more of the extended header
Bytes webp_with(const Bytes& webp, const Bytes& profile, const Bytes& exif, int width, int height,
                int flags = 0);

}  // namespace sfumato::test
