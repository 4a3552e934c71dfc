#pragma once
/// \file
/// Files that say what labels mean.

#include <filesystem>

#include "certet/labels.hpp"

namespace certet {

/// Reads a table of labels, one on each line, `#` before a comment:
///   - ITK-SNAP's label description:  7 255 0 0 1 1 1 "Left thalamus"
///   - 3D Slicer's colour table (.ctbl), FreeSurfer's:  7 Left_thalamus 255 0 0 255
///   - a number and a name, as MRIcron and FSL have them:  7 Left thalamus
/// \throws Error `bad_input` with one sentence that names the file and the line.
LabelNames read_label_names(const std::filesystem::path& file);

}  // namespace certet
