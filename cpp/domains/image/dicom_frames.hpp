#pragma once
/// \file
/// What a DICOM file of several frames says of each of them.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "label_layers.hpp"
#include "slice_stack.hpp"

namespace gdcm {
class DataSet;
}

namespace certet {

struct DicomFrame {
  std::optional<Point3> position;
  double slope = 1, intercept = 0;
  std::uint32_t segment = 0;  ///< of a segmentation; 0: none is named
};

struct DicomFrames {
  SliceForm form;
  std::vector<DicomFrame> frames;
  double distance = 0;         ///< of neighbours by the header; 0 where it tells none
  double thickness = 0;        ///< of a slice; 0 where it is not told
  std::vector<Segment> segments;
  enum class Kind { values, binary, fractional, labels } kind = Kind::values;
  double greatest_fraction = 0;
  std::vector<std::string> notes;  ///< what is doubtful, a sentence each
};

/// By the functional groups of each frame, those that all share or, as files had it
/// before there were such groups, by the elements of the whole file: then frames lie
/// along the normal, as far apart as slices are.
/// \throws Error `bad_input` where frames lie in several directions, are times and not
/// places, or are not described.
DicomFrames read_dicom_frame_headers(const std::filesystem::path& file,
                                     const gdcm::DataSet& data, std::uint64_t frames);

}  // namespace certet
