#pragma once
/// \file
/// Parts of a .vdb file.  Each is passed over if it is as OpenVDB writes it; else it
/// throws Error `bad_input`.

#include <cstdint>
#include <string>

#include "vdb_file.hpp"

namespace certet {

/// A cursor on a file, which is asked to say what is wrong.
struct VdbPlace {
  const formats::InputFile& file;
  formats::Cursor& cursor;

  [[noreturn]] void fail(const std::string& what) const {
    file.fail("it is truncated or damaged: " + what);
  }
  template <class Number>
  [[nodiscard]] Number number() const {
    return cursor.binary<Number>();
  }
  [[nodiscard]] std::string text() const;
  /// 0 or 1.
  [[nodiscard]] bool flag() const;
};

/// What is packed by blosc in so many bytes, and has `unpacked` bytes.
void skip_blosc(const VdbPlace& at, std::uint64_t packed, std::uint64_t unpacked);

/// \returns whether the metadata say that numbers are halves.
bool skip_metadata(const VdbPlace& at);

void skip_transform(const VdbPlace& at);

/// The tree of a grid of floats or doubles.
void skip_tree(const VdbPlace& at, const VdbGrid& grid);

}  // namespace certet
