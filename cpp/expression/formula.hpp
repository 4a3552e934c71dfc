#pragma once
/// \file
/// One formula, compiled for one thread at a time.

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "certet/frame.hpp"

namespace mu {
class Parser;
}

namespace certet {

/// Not to be used by two threads at once.
class Formula {
 public:
  /// \throws Error `bad_input`.
  explicit Formula(const std::string& text);
  ~Formula();
  Formula(const Formula&) = delete;
  Formula& operator=(const Formula&) = delete;

  /// NaN where the formula has no value.
  double operator()(const Point3& point);

 private:
  Point3 variables_{0, 0, 0};
  std::unique_ptr<mu::Parser> parser_;
};

/// Hands out as many compiled copies of a formula as there are threads asking.
class FormulaPool {
 public:
  explicit FormulaPool(std::string text);

  /// A formula for the time of its life.
  class Loan {
   public:
    explicit Loan(FormulaPool& pool) : pool_(pool), formula_(pool.take()) {}
    ~Loan() { pool_.give_back(std::move(formula_)); }
    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;
    double operator()(const Point3& point) { return (*formula_)(point); }

   private:
    FormulaPool& pool_;
    std::unique_ptr<Formula> formula_;
  };

 private:
  std::unique_ptr<Formula> take();
  void give_back(std::unique_ptr<Formula> formula);

  std::string text_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Formula>> idle_;
};

}  // namespace certet
