#pragma once
/// \file
/// Values of options that are more than one number.

#include <cstdint>
#include <string>
#include <vector>

#include "certet/formula.hpp"
#include "certet/image.hpp"
#include "certet/pieces.hpp"

namespace certet::command {

/// "1,5-9": labels and ranges of labels, which may be negative.
/// \throws Error `bad_option`.
std::vector<LabelRange> parse_labels(const std::string& text);

/// "x0,y0,z0,x1,y1,z1".  \throws Error `bad_option`.
Bounds parse_bounds(const std::string& text, const std::string& option = "--bounds");

/// "a,b,c", all positive.  \throws Error `bad_option`.
Point3 parse_spacing(const std::string& text);

/// "largest", a number of pieces, or "percolating:x" (or y, z).  \throws Error `bad_option`.
KeepRule parse_keep(const std::string& text);

/// A whole number of at least 1.  \throws Error `bad_option` naming the option.
std::uint64_t parse_count(const std::string& option, const std::string& text);

/// From 0 upwards.
std::uint64_t parse_whole(const std::string& option, const std::string& text);

/// A finite number.  \throws Error `bad_option` naming the option.
double parse_number(const std::string& option, const std::string& text);

/// A positive one.
double parse_positive(const std::string& option, const std::string& text);

}  // namespace certet::command
