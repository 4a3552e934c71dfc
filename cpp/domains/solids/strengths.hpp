#pragma once
/// \file
/// Which of several solids a point belongs to that is in more than one.

#include <span>
#include <string>
#include <vector>

#include "certet/domain.hpp"

namespace certet {

/// The materials 1, 2, … of these names, the strongest first: those of `priority` in its
/// order, then the others, the last one first.
/// \throws Error `bad_option` where a name is empty or there twice, in either list, and
/// where `priority` has one that `names` has not.
std::vector<Material> strongest_first(const std::vector<std::string>& names,
                                      const std::vector<std::string>& priority);

}  // namespace certet
