#pragma once
/// \file
/// What labels are called.

#include <cstdint>
#include <map>
#include <string>

namespace certet {

/// The names of labels, in UTF-8 or whatever the input had.
using LabelNames = std::map<std::int32_t, std::string>;

}  // namespace certet
