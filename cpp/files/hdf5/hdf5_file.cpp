#include "hdf5_file.hpp"

#include "certet/formats.hpp"

namespace certet {

bool has_hdf5() { return true; }

namespace hdf5 {
namespace {

/// What the system said, of the innermost of HDF5's errors that has it.
std::string reason() {
  std::string found = "HDF5 could not write it";
  const auto look = [](unsigned, const H5E_error2_t* error, void* data) -> herr_t {
    constexpr std::string_view before = "error message = '";
    const std::string_view text = error->desc == nullptr ? "" : error->desc;
    const std::size_t begin = text.find(before);
    if (begin != std::string_view::npos) {
      const std::string_view message = text.substr(begin + before.size());
      *static_cast<std::string*>(data) = message.substr(0, message.find('\''));
    }
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, look, &found);
  return found;
}

hid_t checked(hid_t result, const formats::OutputFile& file) {
  if (result < 0) file.fail(reason());
  return result;
}

}  // namespace

void Dataset::append(hid_t type, const void* values, std::size_t count) {
  if (count == 0) return;
  const bool table = columns_ != 0;
  const hsize_t rows = count / (table ? columns_ : 1);
  if (written_ + rows > rows_) file_->fail("more came than was announced");
  const std::array<hsize_t, 2> begin{written_, 0}, size{rows, columns_};
  const Handle inside(checked(H5Dget_space(id_.get()), *file_), H5Sclose);
  const Handle piece(checked(H5Screate_simple(table ? 2 : 1, size.data(), nullptr), *file_),
                     H5Sclose);
  checked(H5Sselect_hyperslab(inside.get(), H5S_SELECT_SET, begin.data(), nullptr, size.data(),
                              nullptr),
          *file_);
  checked(H5Dwrite(id_.get(), type, piece.get(), inside.get(), H5P_DEFAULT, values), *file_);
  written_ += rows;
}

void Dataset::append(std::span<const Point3> points) {
  if (!points.empty()) append(std::span<const double>(points.front().data(), 3 * points.size()));
}

void Dataset::append(std::span<const Tet<std::uint64_t>> tets, formats::ElementNodes& nodes) {
  numbers_.clear();
  for (const Tet<std::uint64_t>& tet : tets) {
    const std::span<const std::uint64_t> own = nodes.tet(tet);
    numbers_.insert(numbers_.end(), own.begin(), own.end());
  }
  append(std::span<const std::int64_t>(numbers_));
}

File::File(formats::OutputFile& file) : file_(file) {
  H5Eget_auto2(H5E_DEFAULT, &print_, &print_data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation.get(), 0);  // the same bytes at any time
  id_ = {checked(H5Fcreate(file.growing().c_str(), H5F_ACC_TRUNC, creation.get(), H5P_DEFAULT),
                 file_),
         H5Fclose};
}

File::~File() {
  static_cast<void>(id_.close());
  H5Eset_auto2(H5E_DEFAULT, print_, print_data_);
}

void File::make_group(const std::string& name) {
  const Handle creation(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation.get(), 0);
  const Handle group(checked(H5Gcreate2(id_.get(), name.c_str(), H5P_DEFAULT, creation.get(),
                                        H5P_DEFAULT),
                             file_),
                     H5Gclose);
}

Dataset File::make_dataset(const std::string& name, hid_t type, std::uint64_t rows,
                           std::uint64_t columns) {
  const std::array<hsize_t, 2> size{rows, columns};
  const Handle space(checked(H5Screate_simple(columns == 0 ? 1 : 2, size.data(), nullptr), file_),
                     H5Sclose);
  const Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation.get(), 0);
  H5Pset_fill_time(creation.get(), H5D_FILL_TIME_NEVER);
  return {Handle(checked(H5Dcreate2(id_.get(), name.c_str(), type, space.get(), H5P_DEFAULT,
                                    creation.get(), H5P_DEFAULT),
                         file_),
                 H5Dclose),
          rows, columns, file_};
}

void File::set_attribute(const std::string& group, const std::string& name,
                         std::span<const std::int64_t> numbers) {
  const hsize_t size = numbers.size();
  set_attribute(group, name, Types<std::int64_t>::file(), Types<std::int64_t>::memory(),
                std::span(&size, 1), numbers.data());
}

void File::set_attribute(const std::string& group, const std::string& name,
                         std::string_view word) {
  const Handle type(checked(H5Tcopy(H5T_C_S1), file_), H5Tclose);
  checked(H5Tset_size(type.get(), word.size()), file_);
  checked(H5Tset_strpad(type.get(), H5T_STR_NULLPAD), file_);
  set_attribute(group, name, type.get(), type.get(), {}, word.data());
}

void File::set_attribute(const std::string& group, const std::string& name, hid_t type,
                         hid_t memory, std::span<const hsize_t> size, const void* values) {
  const Handle owner(checked(H5Gopen2(id_.get(), group.c_str(), H5P_DEFAULT), file_), H5Gclose);
  const Handle space(checked(size.empty() ? H5Screate(H5S_SCALAR)
                                          : H5Screate_simple(1, size.data(), nullptr),
                             file_),
                     H5Sclose);
  const Handle attribute(checked(H5Acreate2(owner.get(), name.c_str(), type, space.get(),
                                            H5P_DEFAULT, H5P_DEFAULT),
                                 file_),
                         H5Aclose);
  checked(H5Awrite(attribute.get(), memory, values), file_);
}

void File::close() {
  if (!id_.close()) file_.fail(reason());
}

}  // namespace hdf5
}  // namespace certet
