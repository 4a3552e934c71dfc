#pragma once
/// \file
/// Real numbers in fields that are 16 characters wide, as punched cards had them.

#include <array>
#include <string>

#include "certet/frame.hpp"
#include "output_file.hpp"

namespace certet::formats {

/// The nearest number that 16 characters hold, with a point: of a finite one at least 9
/// significant digits, and at least 13 from a thousandth to 10^13.
std::string field16(double number);

/// Such fields for the points of a mesh, and whether they hold it.
class Fields16 {
 public:
  /// The coordinates of a point, as they are to be written.
  [[nodiscard]] std::array<std::string, 3> fields(const Point3& point);
  /// The greatest rounding of a coordinate may be a thousand millionth of the mesh's length along
  /// its longest axis.
  /// \throws Error `write_failed`, by `file`, where it is more.
  void finish(const OutputFile& file) const;

 private:
  Point3 low_{}, high_{};
  bool any_ = false;
  double rounding_ = 0;
};

}  // namespace certet::formats
