#pragma once
/// \file
/// Elements of a DICOM file as GDCM has read it.

#include <gdcmDataSet.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace certet {

/// Group and element, as 0xggggeeee.
using DicomTag = std::uint32_t;

/// The text of an element, without blanks behind it; empty where there is none.
std::string dicom_text(const gdcm::DataSet& data, DicomTag tag);

/// The decimal numbers of an element; none where one of them is no finite number.
std::vector<double> dicom_numbers(const gdcm::DataSet& data, DicomTag tag);

/// A number of 16 bits.
std::optional<std::uint32_t> dicom_short(const gdcm::DataSet& data, DicomTag tag);

/// The items of a sequence; none where there is no such sequence.
std::vector<gdcm::DataSet> dicom_items(const gdcm::DataSet& data, DicomTag tag);

}  // namespace certet
