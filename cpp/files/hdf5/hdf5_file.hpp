#pragma once
/// \file
/// Tables of numbers in a file of HDF5 that is there whole or not at all.

#include <hdf5.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "certet/mesh.hpp"
#include "files/formats/element_nodes.hpp"
#include "files/formats/output_file.hpp"

namespace certet::hdf5 {

/// What HDF5 calls an identifier, closed at the end.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle() = default;
  Handle(hid_t id, Close close) : id_(id), close_(close) {}
  Handle(Handle&& other) noexcept : id_(other.id_), close_(other.close_) { other.id_ = -1; }
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Handle() { static_cast<void>(close()); }
  [[nodiscard]] hid_t get() const { return id_; }
  /// Whether that went well.
  [[nodiscard]] bool close() {
    const hid_t id = std::exchange(id_, -1);
    return id < 0 || close_(id) >= 0;
  }

 private:
  hid_t id_ = -1;
  Close close_ = nullptr;
};

/// HDF5's types, in a file little-endian.
template <class T>
struct Types;

/// A table of so many rows, which come in pieces.
class Dataset {
 public:
  template <class T>
  void append(std::span<const T> values) {
    append(Types<T>::memory(), values.data(), values.size());
  }
  void append(std::span<const Point3> points);
  /// Their nodes, as a format has them.
  void append(std::span<const Tet<std::uint64_t>> tets, formats::ElementNodes& nodes);

 private:
  friend class File;
  Dataset(Handle id, std::uint64_t rows, std::uint64_t columns, const formats::OutputFile& file)
      : id_(std::move(id)), rows_(rows), columns_(columns), file_(&file) {}
  void append(hid_t type, const void* values, std::size_t count);

  Handle id_;
  std::uint64_t rows_, columns_, written_ = 0;  ///< `columns_` is 0 of a single one
  const formats::OutputFile* file_;
  std::vector<std::int64_t> numbers_ = {};  ///< of the tetrahedra that were appended last
};

/// Fails as OutputFile does.  HDF5 prints nothing while one is there.
class File {
 public:
  /// `file` must live longer.
  explicit File(formats::OutputFile& file);
  ~File();
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  void make_group(const std::string& name);
  void set_attribute(const std::string& group, const std::string& name,
                     std::span<const std::int64_t> numbers);
  void set_attribute(const std::string& group, const std::string& name, std::string_view word);

  /// \param columns of a table; 0: a single one, of as many numbers as rows
  template <class T>
  Dataset make_dataset(const std::string& name, std::uint64_t rows, std::uint64_t columns = 0) {
    return make_dataset(name, Types<T>::file(), rows, columns);
  }

  /// After the last number, and after all datasets are gone: everything is in the file.
  void close();

 private:
  Dataset make_dataset(const std::string& name, hid_t type, std::uint64_t rows,
                       std::uint64_t columns);
  void set_attribute(const std::string& group, const std::string& name, hid_t type, hid_t memory,
                     std::span<const hsize_t> size, const void* values);

  formats::OutputFile& file_;
  H5E_auto2_t print_ = nullptr;  ///< what HDF5 did with errors before
  void* print_data_ = nullptr;
  Handle id_;
};

template <>
struct Types<double> {
  static hid_t file() { return H5T_IEEE_F64LE; }
  static hid_t memory() { return H5T_NATIVE_DOUBLE; }
};
template <>
struct Types<std::int64_t> {
  static hid_t file() { return H5T_STD_I64LE; }
  static hid_t memory() { return H5T_NATIVE_INT64; }
};
template <>
struct Types<std::int32_t> {
  static hid_t file() { return H5T_STD_I32LE; }
  static hid_t memory() { return H5T_NATIVE_INT32; }
};
template <>
struct Types<std::uint8_t> {
  static hid_t file() { return H5T_STD_U8LE; }
  static hid_t memory() { return H5T_NATIVE_UINT8; }
};

}  // namespace certet::hdf5
