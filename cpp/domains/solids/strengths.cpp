#include "strengths.hpp"

#include <algorithm>

#include "certet/error.hpp"

namespace certet {
namespace {

[[noreturn]] void refuse(const std::string& sentence) {
  throw Error(ErrorCode::bad_option, sentence);
}

void check_names(const std::vector<std::string>& names) {
  for (std::size_t n = 0; n < names.size(); ++n) {
    if (names[n].empty()) refuse("a material has no name");
    if (std::ranges::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(n),
                          names[n]) != names.begin() + static_cast<std::ptrdiff_t>(n))
      refuse("two materials are called '" + names[n] + "'");
  }
}

}  // namespace

std::vector<Material> strongest_first(const std::vector<std::string>& names,
                                      const std::vector<std::string>& priority) {
  check_names(names);
  std::vector<Material> order;
  for (const std::string& name : priority) {
    const auto at = std::ranges::find(names, name);
    if (at == names.end()) refuse("the priority names '" + name + "', which is no material");
    const auto material = static_cast<Material>(at - names.begin() + 1);
    if (std::ranges::find(order, material) != order.end())
      refuse("the priority names '" + name + "' twice");
    order.push_back(material);
  }
  const std::size_t named = order.size();
  for (auto material = static_cast<Material>(names.size()); material > 0; --material)
    if (std::find(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(named), material) ==
        order.begin() + static_cast<std::ptrdiff_t>(named))
      order.push_back(material);
  return order;
}

}  // namespace certet
