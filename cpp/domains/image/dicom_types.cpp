#include "dicom_types.hpp"

#include <algorithm>
#include <array>

namespace certet {
namespace {

/// The types of what places and shows an image.
struct Type {
  std::uint32_t tag;
  std::string_view names;
};
constexpr auto types = std::to_array<Type>({
    {0x00020001, "OB"}, {0x00020002, "UI"}, {0x00020003, "UI"}, {0x00020010, "UI"},
    {0x00020012, "UI"}, {0x00020013, "SH"}, {0x00020016, "AE"},
    {0x00080008, "CS"}, {0x00080016, "UI"}, {0x00080018, "UI"}, {0x00080060, "CS"},
    {0x00180050, "DS"}, {0x00180088, "DS"}, {0x00181114, "DS"}, {0x00181164, "DS"},
    {0x0020000d, "UI"}, {0x0020000e, "UI"}, {0x00200013, "IS"}, {0x00200032, "DS"},
    {0x00200037, "DS"}, {0x00200052, "UI"}, {0x00209113, "SQ"}, {0x00209116, "SQ"},
    {0x00280002, "US"}, {0x00280004, "CS"}, {0x00280006, "US"}, {0x00280008, "IS"},
    {0x00280009, "AT"}, {0x00280010, "US"}, {0x00280011, "US"}, {0x00280030, "DS"},
    {0x00280034, "IS"}, {0x00280100, "US"}, {0x00280101, "US"}, {0x00280102, "US"},
    {0x00280103, "US"}, {0x00280106, "US SS"}, {0x00280107, "US SS"}, {0x00280120, "US SS"},
    {0x00281050, "DS"}, {0x00281051, "DS"}, {0x00281052, "DS"}, {0x00281053, "DS"},
    {0x00281054, "LO"}, {0x00281055, "LO"}, {0x00281101, "US SS"}, {0x00281102, "US SS"},
    {0x00281103, "US SS"}, {0x00281201, "OW"}, {0x00281202, "OW"}, {0x00281203, "OW"},
    {0x00282110, "CS"}, {0x00282112, "DS"}, {0x00282114, "CS"}, {0x00289110, "SQ"},
    {0x00289145, "SQ"}, {0x00480006, "UL"}, {0x00540022, "SQ"}, {0x00620001, "CS"},
    {0x00620002, "SQ"}, {0x00620004, "US"}, {0x00620005, "LO"}, {0x0062000a, "SQ"},
    {0x0062000b, "US"}, {0x0062000e, "US"}, {0x00880200, "SQ"}, {0x3004000c, "DS"},
    {0x3004000e, "DS"}, {0x52009229, "SQ"}, {0x52009230, "SQ"}, {pixel_data, "OB OW"},
});

static_assert(std::ranges::is_sorted(types, {}, &Type::tag));

}  // namespace

bool is_of_its_type(std::uint32_t tag, std::string_view name) {
  const auto at = std::ranges::lower_bound(types, tag, {}, &Type::tag);
  return at == types.end() || at->tag != tag || at->names.find(name) != at->names.npos;
}

bool is_known_sequence(std::uint32_t tag) {
  const auto at = std::ranges::lower_bound(types, tag, {}, &Type::tag);
  return at != types.end() && at->tag == tag && at->names == "SQ";
}

}  // namespace certet
