#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sfumato/base/image.hpp"

/// Small scenes in Orzan's XML, and pictures.
namespace sfumato::test {

/// Returns one curve element: `points` are whole <control_point/> elements; each side has one
/// colour.
std::string curve_xml(const std::string& points, const std::string& left, const std::string& right);

/// Returns a control point at x right, y down (the file swaps them).
std::string point_xml(const std::string& x, const std::string& y);

/// Returns a canvas with these curve elements.
std::string scene_xml(int width, int height, const std::string& curves);

/// Returns a canvas of 64 × 48: a closed curve, orange inside and blue outside, and an open one of
/// two pieces, green and violet.
std::string two_curve_scene();

/// Returns `count` open curves spread over a canvas of 512 × 512.
std::string busy_scene(int count);

std::string repeated(const std::string& text, std::size_t count);

std::string text_of(const std::vector<std::uint8_t>& bytes);

/// Returns the bytes of a PNG of this image.
std::string png_of(const Image& image);

/// Returns a PNG's image; an empty one if it cannot be decoded.
Image image_of(const std::string& png);

}  // namespace sfumato::test
