#pragma once
/// \file
/// What a comparison of the two sides found.

#include <ostream>
#include <string>
#include <vector>

class Differences {
 public:
  /// Counts one comparison, and remembers it if the sides disagree.
  template <class Describe>
  void expect(bool agree, const Describe& describe) {
    ++compared_;
    if (agree) return;
    ++count_;
    if (sentences_.size() < 5) sentences_.push_back(describe());
  }

  [[nodiscard]] bool empty() const { return count_ == 0; }
  [[nodiscard]] long compared() const { return compared_; }

  friend std::ostream& operator<<(std::ostream& out, const Differences& d) {
    out << d.count_ << " differences in " << d.compared_ << " comparisons";
    for (const std::string& sentence : d.sentences_) out << "\n  " << sentence;
    return out;
  }

 private:
  long compared_ = 0;
  long count_ = 0;
  std::vector<std::string> sentences_;
};
