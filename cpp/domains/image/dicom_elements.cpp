#include "dicom_elements.hpp"

#include <gdcmSequenceOfItems.h>

#include <cmath>
#include <cstdlib>

namespace certet {
namespace {

const gdcm::DataElement* find(const gdcm::DataSet& data, DicomTag tag) {
  const gdcm::Tag wanted(static_cast<std::uint16_t>(tag >> 16),
                         static_cast<std::uint16_t>(tag & 0xffff));
  return data.FindDataElement(wanted) ? &data.GetDataElement(wanted) : nullptr;
}

}  // namespace

std::string dicom_text(const gdcm::DataSet& data, DicomTag tag) {
  const gdcm::DataElement* element = find(data, tag);
  const gdcm::ByteValue* value = element == nullptr ? nullptr : element->GetByteValue();
  if (value == nullptr) return "";
  std::string text(value->GetPointer(), value->GetLength());
  while (!text.empty() && (text.back() == '\0' || text.back() == ' ')) text.pop_back();
  return text;
}

std::vector<double> dicom_numbers(const gdcm::DataSet& data, DicomTag tag) {
  const std::string text = dicom_text(data, tag);
  std::vector<double> numbers;
  for (const char* at = text.c_str(); *at != '\0';) {
    char* end = nullptr;
    const double number = std::strtod(at, &end);
    if (end == at || !std::isfinite(number)) return {};
    numbers.push_back(number);
    while (*end == ' ') ++end;
    if (*end != '\\' && *end != '\0') return {};
    at = *end == '\\' ? end + 1 : end;
  }
  return numbers;
}

std::optional<std::uint32_t> dicom_short(const gdcm::DataSet& data, DicomTag tag) {
  const gdcm::DataElement* element = find(data, tag);
  const gdcm::ByteValue* value = element == nullptr ? nullptr : element->GetByteValue();
  if (value == nullptr || value->GetLength() < 2) return {};
  const auto* bytes = reinterpret_cast<const unsigned char*>(value->GetPointer());
  return static_cast<std::uint32_t>(bytes[0] | bytes[1] << 8);
}

std::vector<gdcm::DataSet> dicom_items(const gdcm::DataSet& data, DicomTag tag) {
  std::vector<gdcm::DataSet> items;
  const gdcm::DataElement* element = find(data, tag);
  if (element == nullptr) return items;
  const auto sequence = element->GetValueAsSQ();
  if (sequence == nullptr) return items;
  for (gdcm::SequenceOfItems::SizeType i = 1; i <= sequence->GetNumberOfItems(); ++i)
    items.push_back(sequence->GetItem(i).GetNestedDataSet());
  return items;
}

}  // namespace certet
