#include "mutate.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace fuzz {
namespace {

using Random = std::mt19937_64;

std::size_t below(Random& random, std::size_t limit) { return random() % limit; }

/// A stretch of an input that is not empty.
struct Piece {
  std::size_t begin, length;
};

Piece piece_of(const Input& input, Random& random) {
  const std::size_t begin = below(random, input.size());
  const std::size_t longest = std::min<std::size_t>(input.size() - begin, 64);
  return {begin, 1 + below(random, longest)};
}

auto place(Input& input, std::size_t at) { return input.begin() + static_cast<std::ptrdiff_t>(at); }

void change_bit(Input& input, Random& random) {
  input[below(random, input.size())] ^= static_cast<std::uint8_t>(1 << below(random, 8));
}

void change_byte(Input& input, Random& random) {
  static constexpr std::array<std::uint8_t, 12> bytes{0,   1,   127, 128, 255, '\n',
                                                      ' ', '-', '"', '9', '.', '<'};
  input[below(random, input.size())] = bytes[below(random, bytes.size())];
}

void erase(Input& input, Random& random) {
  const auto [begin, length] = piece_of(input, random);
  input.erase(place(input, begin), place(input, begin + length));
}

void cut_off(Input& input, Random& random) { input.resize(1 + below(random, input.size())); }

void insert_from(Input& input, const Input& other, Random& random) {
  if (other.empty()) return;
  const auto [begin, length] = piece_of(other, random);
  const Input piece(other.begin() + static_cast<std::ptrdiff_t>(begin),
                    other.begin() + static_cast<std::ptrdiff_t>(begin + length));
  input.insert(place(input, below(random, input.size() + 1)), piece.begin(), piece.end());
}

/// A binary number of 2, 4 or 8 bytes near the end of some range.
void change_binary(Input& input, Random& random) {
  const std::size_t size = std::size_t{2} << below(random, 3);
  if (input.size() < size) return;
  const std::uint64_t base = std::uint64_t{1} << below(random, 64);
  const std::uint64_t number = base - 1 + below(random, 3);
  const std::size_t at = below(random, input.size() - size + 1);
  for (std::size_t i = 0; i < size; ++i)
    input[at + i] = static_cast<std::uint8_t>(number >> (8 * i));
}

/// A number in digits becomes another one.
void change_digits(Input& input, Random& random) {
  static constexpr std::array<std::string_view, 10> numbers{
      "0",          "-1",  "1",      "65536",       "2147483648", "4294967295",
      "9999999999", "nan", "1e400", "18446744073709551615"};
  const auto digit = [](std::uint8_t c) { return std::isdigit(c) != 0; };
  const auto from = place(input, below(random, input.size()));
  const auto begin = std::find_if(from, input.end(), digit);
  if (begin == input.end()) return;
  const auto at = begin - input.begin();
  input.erase(begin, std::find_if_not(begin, input.end(), digit));
  const std::string_view number = numbers[below(random, numbers.size())];
  input.insert(input.begin() + at, number.begin(), number.end());
}

}  // namespace

Input mutated(const Input& input, const Input& other, Random& random) {
  Input result = input;
  for (std::size_t changes = 1 + below(random, 4); changes > 0; --changes) {
    if (result.empty()) result.push_back(static_cast<std::uint8_t>(random()));
    switch (below(random, 8)) {
      case 0: change_bit(result, random); break;
      case 1: change_byte(result, random); break;
      case 2: erase(result, random); break;
      case 3: cut_off(result, random); break;
      case 4: insert_from(result, result, random); break;
      case 5: insert_from(result, other, random); break;
      case 6: change_binary(result, random); break;
      default: change_digits(result, random); break;
    }
  }
  return result;
}

}  // namespace fuzz
