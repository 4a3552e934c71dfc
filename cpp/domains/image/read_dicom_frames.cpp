// A DICOM file of several frames as one image, or a segmentation.

#include <gdcmImageReader.h>
#include <gdcmReader.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "dicom_elements.hpp"
#include "dicom_frames.hpp"
#include "dicom_header.hpp"
#include "image_file.hpp"
#include "number_type.hpp"
#include "volumes.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;
using Kind = DicomFrames::Kind;

/// The numbers of a frame, as they are stored.
struct Stored {
  std::vector<char> bytes;
  std::uint64_t in_frame = 0;  ///< pixels
  NumberType type = NumberType::u8;
  bool single_bits = false;
};

NumberType stored_type(const fs::path& file, const DicomHeader& header) {
  const bool has_sign = header.is_signed != 0;
  switch (header.bits) {
    case 1:
    case 8: return has_sign ? NumberType::i8 : NumberType::u8;
    case 16: return has_sign ? NumberType::i16 : NumberType::u16;
    case 32: return has_sign ? NumberType::i32 : NumberType::u32;
    default: refuse(file, "has voxels of a type that is not supported");
  }
}

/// What is packed is GDCM's to unpack; the bytes it gives must be as many as wanted.
void unpack(const fs::path& file, std::vector<char>& bytes) {
  gdcm::ImageReader reader;
  reader.SetFileName(file.c_str());
  if (!reader.Read() || reader.GetImage().GetBufferLength() != bytes.size() ||
      !reader.GetImage().GetBuffer(bytes.data()))
    refuse(file, "is truncated or damaged, or packed in a way that is not supported");
}

Stored read_stored(const fs::path& file, const gdcm::DataSet& data, const DicomHeader& header,
                   std::uint64_t frames) {
  Stored stored;
  stored.type = stored_type(file, header);
  stored.single_bits = header.bits == 1;
  stored.in_frame = header.rows * header.columns;
  const std::uint64_t wanted = (stored.in_frame * frames * header.bits + 7) / 8;
  stored.bytes.assign(wanted, '\0');
  if (header.packed) {
    unpack(file, stored.bytes);
    return stored;
  }
  const gdcm::Tag pixels(0x7fe0, 0x0010);
  const gdcm::ByteValue* value =
      data.FindDataElement(pixels) ? data.GetDataElement(pixels).GetByteValue() : nullptr;
  if (value == nullptr || value->GetLength() < wanted)
    refuse(file, "is truncated or damaged: it has fewer pixels than its frames");
  std::copy_n(value->GetPointer(), wanted, stored.bytes.begin());
  return stored;
}

Voxels frame_voxels(const fs::path& file, const Stored& stored, std::size_t frame) {
  if (!stored.single_bits)
    return load_voxels(file, stored.type, stored.in_frame, [&](char* to) {
      const std::uint64_t bytes = stored.in_frame * bytes_of(stored.type);
      std::copy_n(stored.bytes.data() + frame * bytes, bytes, to);
    });
  Buffer<std::uint8_t> voxels(stored.in_frame);  // the first in the lowest bit of a byte
  for (std::uint64_t i = 0; i < stored.in_frame; ++i) {
    const std::uint64_t bit = frame * stored.in_frame + i;
    voxels[i] = static_cast<std::uint8_t>(stored.bytes[bit / 8] >> bit % 8 & 1);
  }
  return voxels;
}

std::vector<Slice> slices_of(const DicomFrames& frames) {
  std::vector<Slice> slices;
  for (std::size_t f = 0; f < frames.frames.size(); ++f)
    slices.push_back({"frame " + std::to_string(f + 1), f, *frames.frames[f].position});
  return slices;
}

/// Slices at one position, to a hundredth of a pixel, are one group.
std::vector<std::vector<Slice>> by_position(const std::vector<Slice>& sorted, double pixel) {
  std::vector<std::vector<Slice>> groups;
  for (const Slice& slice : sorted) {
    if (groups.empty() || slice.along - groups.back().front().along > 0.01 * pixel)
      groups.emplace_back();
    groups.back().push_back(slice);
  }
  for (auto& group : groups) std::ranges::sort(group, {}, &Slice::number);
  return groups;
}

std::vector<Slice> sorted_slices(const fs::path& file, const DicomFrames& frames) {
  std::vector<Slice> slices = slices_of(frames);
  sort_slices(file, slices, frames.form);
  check_straight(file, slices, frames.form);
  return slices;
}

/// One frame at each position: where there are several, as of several times, the one
/// that was chosen.
std::vector<Slice> choose_frames(const fs::path& file, const DicomFrames& frames,
                                 const ImageChoice& choice) {
  const double pixel = std::min(frames.form.spacing[0], frames.form.spacing[1]);
  const auto groups = by_position(sorted_slices(file, frames), pixel);
  const std::size_t volumes = groups.front().size();
  for (const auto& group : groups)
    if (group.size() != volumes)
      refuse(file, "has " + std::to_string(group.size()) + " frames at one position and " +
                       std::to_string(volumes) + " at another");
  const std::uint64_t volume =
      chosen_volume(file, volumes, std::to_string(volumes) + " volumes (frames at one position)",
                    choice.volume);
  std::vector<Slice> chosen;
  for (const auto& group : groups) chosen.push_back(group[volume]);
  return chosen;
}

bool one_scale(const DicomFrames& frames) {
  return std::ranges::all_of(frames.frames, [&](const DicomFrame& frame) {
    return frame.slope == frames.frames[0].slope && frame.intercept == frames.frames[0].intercept;
  });
}

void fill_values(const fs::path& file, const DicomFrames& frames, const Stored& stored,
                 const std::vector<Slice>& slices, Image& image) {
  const DicomFrame& first = frames.frames[0];
  if (one_scale(frames)) {
    const std::uint64_t bytes = stored.in_frame * bytes_of(stored.type);
    image.voxels = load_voxels(file, stored.type, stored.in_frame * slices.size(), [&](char* to) {
      for (const Slice& slice : slices)
        to = std::copy_n(stored.bytes.data() + slice.number * bytes, bytes, to);
    });
    if (first.slope != 1 || first.intercept != 0)
      image.voxels = rescaled(image.voxels, first.slope, first.intercept);
    return;
  }
  Buffer<double> values(stored.in_frame * slices.size());
  double* to = values.begin();
  for (const Slice& slice : slices) {
    const DicomFrame& frame = frames.frames[slice.number];
    to = std::visit([&](const auto& from) {
      return std::ranges::transform(from, to, [&](auto v) {
        return frame.slope * static_cast<double>(v) + frame.intercept;
      }).out;
    }, frame_voxels(file, stored, slice.number));
  }
  image.voxels = std::move(values);
}

Image read_values(const fs::path& file, const DicomFrames& frames, const gdcm::DataSet& data,
                  const DicomHeader& header, const ImageChoice& choice) {
  const std::vector<Slice> slices = choose_frames(file, frames, choice);
  const bool single = slices.size() == 1;
  Image image = slice_grid(file, frames.form, slices.front().origin, slices.size(),
                           single ? frames.thickness : slice_distance(file, slices));
  image.notes = frames.notes;
  if (single) image.notes.push_back("the image is a single slice, as thick as its header says");
  const Stored stored = read_stored(file, data, header, frames.frames.size());
  fill_values(file, frames, stored, slices, image);
  return image;
}

/// The grid of a segmentation, whose empty frames may be left out.
struct SegmentGrid {
  Image image;
  std::vector<std::pair<std::size_t, std::size_t>> places;  ///< slice and frame
};

double segment_distance(const DicomFrames& frames, const std::vector<Slice>& slices) {
  double least = 0;
  for (std::size_t k = 1; k < slices.size(); ++k) {
    const double gap = slices[k].along - slices[k - 1].along;
    if (gap > 1e-3 * frames.form.spacing[0] && (least == 0 || gap < least)) least = gap;
  }
  if (frames.distance > 0 && (least == 0 || frames.distance < 1.1 * least)) return frames.distance;
  if (least > 0) return least;
  return frames.thickness > 0 ? frames.thickness : 1;
}

SegmentGrid segment_grid(const fs::path& file, const DicomFrames& frames) {
  const std::vector<Slice> slices = sorted_slices(file, frames);
  const double distance = segment_distance(frames, slices);
  const double first = slices.front().along;
  SegmentGrid grid;
  std::size_t count = 0;
  for (const Slice& slice : slices) {
    const double steps = (slice.along - first) / distance;
    const double whole = std::round(steps);
    if (!(whole < 1e6) || !is_near(steps, whole, 0.1 + 1e-3 * whole))
      refuse(file, "has slices that are not equally spaced: " + slice.name + " is " +
                       std::to_string(slice.along - first) + " from the first, where slices are " +
                       std::to_string(distance) + " apart");
    count = std::max(count, static_cast<std::size_t>(whole) + 1);
    grid.places.emplace_back(static_cast<std::size_t>(whole), slice.number);
  }
  grid.image = slice_grid(file, frames.form, slices.front().origin, count, distance);
  return grid;
}

/// Numbers of segments by their place in the list.
std::map<std::int64_t, std::size_t> numbers_of(const std::vector<Segment>& segments) {
  std::map<std::int64_t, std::size_t> numbers;
  for (std::size_t s = 0; s < segments.size(); ++s) numbers.emplace(segments[s].value, s);
  return numbers;
}

std::size_t segment_named(const fs::path& file, const std::map<std::int64_t, std::size_t>& numbers,
                          std::int64_t number) {
  const auto found = numbers.find(number);
  if (found == numbers.end())
    refuse(file, "has voxels of segment " + std::to_string(number) + ", which it does not describe");
  return found->second;
}

Image read_segments(const fs::path& file, const DicomFrames& frames, const gdcm::DataSet& data,
                    const DicomHeader& header, std::uint64_t max_bytes, const ImageChoice& choice) {
  chosen_volume(file, 1, "", choice.volume);
  SegmentGrid grid = segment_grid(file, frames);
  check_memory(file, check_count(file, grid.image.size, 4) * 4, max_bytes);
  const Stored stored = read_stored(file, data, header, frames.frames.size());
  grid.image.notes = frames.notes;
  const auto numbers = numbers_of(frames.segments);
  if (frames.kind == Kind::fractional)
    grid.image.notes.push_back(
        "the segmentation has fractions; voxels of at least half belong to a segment");
  LabelLayers labels(grid.image, frames.segments);
  const double least = frames.kind == Kind::fractional ? 0.5 * frames.greatest_fraction : 1;
  for (const auto& [slice, frame] : grid.places) {
    const std::size_t begin = slice * stored.in_frame;
    const bool by_value = frames.kind == Kind::labels;
    const std::size_t of_frame =
        by_value ? 0 : segment_named(file, numbers, frames.frames[frame].segment);
    std::visit([&](const auto& voxels) {
      for (std::size_t i = 0; i < voxels.size(); ++i)
        if (const auto value = static_cast<std::int64_t>(voxels[i]);
            by_value ? value != 0 : static_cast<double>(value) >= least)
          labels.add(begin + i, by_value ? segment_named(file, numbers, value) : of_frame);
    }, frame_voxels(file, stored, frame));
  }
  labels.finish();
  return std::move(grid.image);
}

}  // namespace

Image read_dicom_frames(const fs::path& file, std::uint64_t max_bytes, const ImageChoice& choice) {
  const DicomHeader header = *read_dicom_header(file);
  check_memory(file, header.rows * header.columns * header.frames * sizeof(double), max_bytes);
  if (header.packed && header.samples == 1 && !header.is_gray())
    refuse(file, "has colours for voxels ('" + header.photometric + "'), not 1 number each");
  gdcm::Reader reader;
  reader.SetFileName(file.c_str());
  if (!reader.Read()) refuse_dicom(file);
  const gdcm::DataSet& data = reader.GetFile().GetDataSet();
  const DicomFrames frames = read_dicom_frame_headers(file, data, header.frames);
  if (frames.kind != Kind::values)
    return read_segments(file, frames, data, header, max_bytes, choice);
  if (header.bits == 1) refuse(file, "has voxels of a type that is not supported");
  return read_values(file, frames, data, header, choice);
}

}  // namespace certet
