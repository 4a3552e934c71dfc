#include "parts/dicom.hpp"
#include "parts/part.hpp"

namespace certet::command {
namespace {

constexpr DicomPart functions{&read_dicom, &read_dicom_file};

}  // namespace

extern "C" Part certet_part() { return {CERTET_VERSION, &functions}; }

}  // namespace certet::command
