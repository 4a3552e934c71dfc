#include "section.hpp"

namespace certet::formats {

void Section::append(std::span<const std::byte> bytes) {
  if (gathered_.size() + bytes.size() > capacity_) flush();
  if (bytes.size() > capacity_) {
    file_->write_at(offset_, bytes);
    offset_ += bytes.size();
    return;
  }
  gathered_.insert(gathered_.end(), bytes.begin(), bytes.end());
}

void Section::flush() {
  file_->write_at(offset_, gathered_);
  offset_ += gathered_.size();
  gathered_.clear();
}

}  // namespace certet::formats
