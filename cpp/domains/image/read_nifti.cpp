// NIfTI by its header and its bytes, and not by ITK: that reader knows version 1
// alone, takes the rotation next to a sheared matrix, and reads what is not finite
// as 0.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "geometry.hpp"
#include "header_lines.hpp"
#include "image_file.hpp"
#include "nifti_header.hpp"
#include "volumes.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;

std::string four_digits(double number) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.4g", number);
  return digits;
}

/// Along the axes of the world that this program has, x to the left, y to the back, as
/// ITK places such files too.
NiftiPlace without_form(const NiftiHeader& header) {
  NiftiPlace place;
  for (std::size_t a = 0; a < 3; ++a)
    place.rows[a][a] = (a < 2 ? -1 : 1) * header.spacing[a];
  return place;
}

double length_of_column(const NiftiPlace& place, std::size_t a) {
  return std::hypot(place.rows[0][a], place.rows[1][a], place.rows[2][a]);
}

/// The greatest distance between where two forms put the corners of the grid.
double distance(const NiftiHeader& header, const NiftiPlace& one, const NiftiPlace& other) {
  double greatest = 0;
  for (int corner = 0; corner < 8; ++corner) {
    double apart[3];
    for (std::size_t r = 0; r < 3; ++r) {
      apart[r] = one.rows[r][3] - other.rows[r][3];
      for (std::size_t a = 0; a < 3; ++a)
        if ((corner >> a & 1) != 0)
          apart[r] += (one.rows[r][a] - other.rows[r][a]) * static_cast<double>(header.size[a] - 1);
    }
    greatest = std::max(greatest, std::hypot(apart[0], apart[1], apart[2]));
  }
  return greatest;
}

/// The sform where it is set, as most readers take it; then the qform.
NiftiPlace choose(const NiftiHeader& header, Image& image) {
  if (!header.sform && !header.qform) {
    image.notes.push_back(
        std::string("the file says nothing of the place of its voxels (") +
        (header.version == 0 ? "it is ANALYZE" : "qform_code and sform_code are 0") +
        "); the first is at the origin, their axes are those of the world");
    return without_form(header);
  }
  if (!header.sform || !header.qform) return header.sform ? *header.sform : *header.qform;
  const double apart = distance(header, *header.sform, *header.qform);
  const double least = *std::min_element(header.spacing.begin(), header.spacing.end());
  if (apart > 0.1 * least)
    image.notes.push_back("the file's qform and sform disagree, by up to " + four_digits(apart) +
                          " mm; the sform was taken");
  return *header.sform;
}

/// From x to the right and y to the front to x to the left and y to the back.  The
/// spacing by the header is exact where the matrix is rounded.
void place(const NiftiHeader& header, Image& image) {
  const NiftiPlace place = choose(header, image);
  image.size = header.size;
  for (std::size_t r = 0; r < 3; ++r) image.origin[r] = (r < 2 ? -1 : 1) * place.rows[r][3] + 0.0;
  for (std::size_t a = 0; a < 3; ++a) {
    const double length = length_of_column(place, a);
    const bool same = std::fabs(length - header.spacing[a]) <= 1e-5 * length;
    image.spacing[a] = same ? header.spacing[a] : length;
    for (std::size_t r = 0; r < 3; ++r)
      image.axes[r][a] = (r < 2 ? -1 : 1) * place.rows[r][a] / length + 0.0;
  }
  check_geometry(image);
  orthonormalise(image);
}

void note_doubts(const fs::path& file, const NiftiHeader& header, bool packed, Image& image) {
  if (header.unit != 1)
    image.notes.push_back(std::string("lengths in the file are in ") +
                          (header.unit > 1 ? "metres" : "micrometres") +
                          ", here they are in millimetres");
  const bool named = lower(file.extension().string()) == ".gz";
  if (named && !packed)
    image.notes.push_back("the file is not packed, although its name ends with .gz");
  if (!named && packed)
    image.notes.push_back("the file is packed by gzip, although its name does not say so");
}

}  // namespace

Image read_nifti(const fs::path& file, std::uint64_t max_bytes, const ImageChoice& choice) {
  const NiftiHeader header = read_nifti_header(file);
  std::error_code failure;
  if (!fs::is_regular_file(header.voxel_file, failure))
    refuse(file, "is a header whose voxels are missing: there is no file '" +
                     header.voxel_file.string() + "'");
  Image image;
  image.name = file.string();
  const std::size_t bytes_of_one = bytes_of(header.type);
  const std::uint64_t count = check_count(file, header.size, bytes_of_one);
  const std::uint64_t volume = chosen_volume(
      file, header.volumes, std::to_string(header.volumes) + " volumes (4 dimensions, not 3)",
      choice.volume);
  const bool as_stored = header.slope == 1 && header.intercept == 0;
  check_memory(file, count * (bytes_of_one + (as_stored ? 0 : most_rescaled_bytes)), max_bytes);
  place(header, image);
  const bool packed = is_packed(header.voxel_file);
  note_doubts(header.voxel_file, header, packed, image);
  if (count * bytes_of_one > std::numeric_limits<std::int64_t>::max() / header.volumes)
    refuse(file, "has impossible dimensions");
  // The volumes behind the chosen one are looked for, too, so that the file is whole.
  const std::uint64_t bytes = count * bytes_of_one;
  StoredPart part{header.voxel_file, packed ? 0 : header.offset,
                  (packed ? header.offset : 0), bytes * header.volumes, packed};
  check_length(part);
  part.lead += volume * bytes;
  part.bytes = bytes;
  image.voxels = load_voxels(file, header.type, count, [&](char* to) {
    read_part(part, to);
    if (header.swapped) swap_bytes(to, count, bytes_of_one);
  });
  if (!as_stored) image.voxels = rescaled(image.voxels, header.slope, header.intercept);
  return image;
}

}  // namespace certet
