#pragma once
/// \file
/// From the labels around a tile to its fields.

#include <memory>

#include "fields/field_tile.hpp"
#include "fields/label_window.hpp"
#include "fields/rules.hpp"

namespace certet::fields {

/// How many voxels around a tile its fields depend on.
int halo_of(const Rules& rules);

/// Makes one tile after the other, and keeps what memory that takes.
class TileMaker {
 public:
  explicit TileMaker(const Rules& rules);
  ~TileMaker();

  /// The smoothed indicators, without constants and not held yet.  nullptr where the
  /// window has one label.
  std::unique_ptr<Tile> make(const LabelWindow& window);

 private:
  class Fields;
  std::unique_ptr<Fields> fields_;
  Tile tile_;
};

}  // namespace certet::fields
