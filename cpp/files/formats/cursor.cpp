#include "cursor.hpp"

#include <algorithm>
#include <cstring>

namespace certet::formats {

std::string in_quotes(std::string_view word) {
  std::string text = "'";
  for (const char c : word.substr(0, 40)) text += c > ' ' && c <= '~' ? c : '?';
  return text += '\'';
}

/// Moves what is left to the front and reads on; false at the end of the file,
/// or where there is no room.
bool Cursor::refill() {
  std::memmove(text_.data(), text_.data() + at_, end_ - at_);
  end_ -= at_;
  at_ = 0;
  const std::size_t room = text_.size() - end_;
  const auto size =
      static_cast<std::size_t>(std::min<std::uint64_t>(room, file_.size() - offset_));
  file_.read_at(offset_, std::as_writable_bytes(std::span(text_).subspan(end_, size)));
  offset_ += size;
  end_ += size;
  return size > 0;
}

std::string_view Cursor::word() {
  do {
    while (at_ < end_ && is_blank(text_[at_])) ++at_;
  } while (at_ == end_ && refill());
  std::size_t length = 0;
  do {
    while (at_ + length < end_ && !is_blank(text_[at_ + length])) ++length;
  } while (at_ + length == end_ && refill());
  const std::string_view word(text_.data() + at_, length);
  at_ += length;
  return word;
}

std::string_view Cursor::line() {
  std::size_t length = 0;
  do {
    while (at_ + length < end_ && text_[at_ + length] != '\n') ++length;
  } while (at_ + length == end_ && refill());
  const std::string_view line(text_.data() + at_, length);
  at_ = std::min(at_ + length + 1, end_);
  return line.ends_with('\r') ? line.substr(0, length - 1) : line;
}

void Cursor::skip_past(std::string_view words) {
  for (;;) {
    const std::string_view text(text_.data() + at_, end_ - at_);
    const std::size_t found = text.find(words);
    if (found != text.npos) {
      at_ += found + words.size();
      return;
    }
    // The words may begin in the text at hand.
    at_ += text.size() - std::min(text.size(), words.size());
    if (!refill()) file_.fail("it is cut off: its " + in_quotes(words) + " is missing");
  }
}

void Cursor::bytes(std::span<std::byte> out) {
  if (out.size() > remaining()) file_.fail("it is cut off");
  const std::size_t at_hand = std::min(out.size(), end_ - at_);
  std::memcpy(out.data(), text_.data() + at_, at_hand);
  at_ += at_hand;
  out = out.subspan(at_hand);
  if (out.size() >= capacity) {
    file_.read_at(offset_, out);
    offset_ += out.size();
  } else if (!out.empty()) {
    refill();
    std::memcpy(out.data(), text_.data(), out.size());
    at_ = out.size();
  }
}

void Cursor::skip(std::uint64_t bytes) {
  if (bytes > remaining()) file_.fail("it is cut off");
  if (bytes <= end_ - at_) at_ += static_cast<std::size_t>(bytes);
  else go_to(position() + bytes);
}

void Cursor::go_to(std::uint64_t position) {
  if (position > file_.size()) file_.fail("it is cut off");
  offset_ = position;
  at_ = end_ = 0;
}

std::uint64_t Cursor::checked(std::uint64_t count, std::uint64_t least_bytes,
                             const char* things) const {
  if (count > remaining() / least_bytes)
    file_.fail("it is too short for the " + std::to_string(count) + " " + things +
               " that it announces");
  return count;
}

}  // namespace certet::formats
