// A reader with a defect: some bytes make it throw what is no certet::Error.

#include "reader.hpp"
#include "targets.hpp"

namespace fuzz {

void planted_reader(Bytes bytes) {
  read_or_refuse([&] {
    if (bytes.size() < 2 || bytes[0] != 'L')
      throw certet::Error(certet::ErrorCode::bad_input, "the first byte is not an L");
    if (bytes[1] > '9') throw std::out_of_range("vector::_M_range_check");
  });
}

}  // namespace fuzz
