#include "legend.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

#include "palette.hpp"

namespace certet::view {
namespace {

constexpr Rgb ink{0x30, 0x34, 0x50};

/// Characters, five dots wide and seven high, row by row, the leftmost dot in the highest bit.
constexpr int wide = 5, high = 7;
constexpr std::string_view characters = "0123456789.e-+";
constexpr std::array<std::array<std::uint8_t, high>, 14> dots{
    {{0b01110, 0b10001, 0b10011, 0b10101, 0b11001, 0b10001, 0b01110},
     {0b00100, 0b01100, 0b00100, 0b00100, 0b00100, 0b00100, 0b01110},
     {0b01110, 0b10001, 0b00001, 0b00110, 0b01000, 0b10000, 0b11111},
     {0b11110, 0b00001, 0b00001, 0b01110, 0b00001, 0b00001, 0b11110},
     {0b00010, 0b00110, 0b01010, 0b10010, 0b11111, 0b00010, 0b00010},
     {0b11111, 0b10000, 0b11110, 0b00001, 0b00001, 0b10001, 0b01110},
     {0b00110, 0b01000, 0b10000, 0b11110, 0b10001, 0b10001, 0b01110},
     {0b11111, 0b00001, 0b00010, 0b00100, 0b01000, 0b01000, 0b01000},
     {0b01110, 0b10001, 0b10001, 0b01110, 0b10001, 0b10001, 0b01110},
     {0b01110, 0b10001, 0b10001, 0b01111, 0b00001, 0b00010, 0b01100},
     {0b00000, 0b00000, 0b00000, 0b00000, 0b00000, 0b01100, 0b01100},
     {0b00000, 0b00000, 0b01110, 0b10001, 0b11111, 0b10000, 0b01110},
     {0b00000, 0b00000, 0b00000, 0b11111, 0b00000, 0b00000, 0b00000},
     {0b00000, 0b00100, 0b00100, 0b11111, 0b00100, 0b00100, 0b00000}}};

/// Rectangles of pixels, as far as they are in the picture.
void fill(Picture& picture, int left, int top, int width, int height, const Rgb& color) {
  for (int y = std::max(top, 0); y < std::min(top + height, picture.height); ++y)
    for (int x = std::max(left, 0); x < std::min(left + width, picture.width); ++x)
      std::ranges::copy(color, picture.rgb.begin() + 3 * (std::ptrdiff_t{y} * picture.width + x));
}

/// Each dot is a square of so many pixels.
void write(Picture& picture, int left, int top, int dot, std::string_view text) {
  for (const char character : text) {
    const auto& rows = dots[characters.find(character)];
    for (int y = 0; y < high; ++y)
      for (int x = 0; x < wide; ++x)
        if ((rows[static_cast<std::size_t>(y)] >> (wide - 1 - x) & 1) != 0)
          fill(picture, left + dot * x, top + dot * y, dot, dot, ink);
    left += dot * (wide + 1);
  }
}

/// Three digits, like 0.0123 or 1.23e-05.
std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return text.data();
}

}  // namespace

void draw_distance_legend(Picture& picture, double greatest) {
  const int dot = std::max(1, picture.height / 400);
  const int length = picture.width / 3, thick = high * dot;
  const int left = (picture.width - length) / 2;
  const int top = picture.height - static_cast<int>(picture.height * legend_share / 2) - thick / 2;
  for (int x = 0; x < length; ++x)
    fill(picture, left + x, top, 1, thick, distance_color((x + 0.5) / length));
  const int gap = 2 * (wide + 1) * dot;
  write(picture, left - gap, top, dot, "0");
  write(picture, left + length + gap / 2, top, dot, number(greatest));
}

}  // namespace certet::view
