#pragma once
/// \file
/// The types of DICOM elements that place and show an image.

#include <cstdint>
#include <string_view>

namespace certet {

/// The tag of Pixel Data.
inline constexpr std::uint32_t pixel_data = 0x7fe00010;

/// False where an element of this tag (0xggggeeee) has another type than the two
/// letters; true for tags that are not known here.
bool is_of_its_type(std::uint32_t tag, std::string_view name);

/// Where no type is written, these are walked as well: they are read later on.
bool is_known_sequence(std::uint32_t tag);

}  // namespace certet
