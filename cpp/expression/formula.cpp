// The only translation unit that includes muParser.

#include "formula.hpp"

#include <muParser.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "certet/error.hpp"

namespace certet {
namespace {

double clamp(double value, double low, double high) {
  return std::max(low, std::min(value, high));
}

double hypot(const double* lengths, int count) {
  double sum = 0;
  for (int i = 0; i < count; ++i) sum += lengths[i] * lengths[i];
  return std::sqrt(sum);
}

[[noreturn]] void refuse(const std::string& text, const std::string& reason) {
  throw Error(ErrorCode::bad_input, "the formula \"" + text + "\" cannot be read: " + reason);
}

/// muParser's own sentences begin in capitals, may end in a full stop, and count
/// characters from 0.
[[noreturn]] void refuse_with(const std::string& text, const mu::ParserError& error) {
  std::string reason = error.GetMsg();
  for (const char* tail : {" found at position", " at position"})
    if (const auto end = reason.find(tail); end != std::string::npos) reason.resize(end);
  while (!reason.empty() && (reason.back() == '.' || reason.back() == ' ')) reason.pop_back();
  if (!reason.empty()) reason[0] = static_cast<char>(std::tolower(reason[0]));
  const auto position = static_cast<std::size_t>(std::max(error.GetPos(), 0));
  if (position < text.size()) reason += " at position " + std::to_string(position + 1);
  refuse(text, reason);
}

void define_functions(mu::Parser& parser) {
  parser.DefineConst("pi", std::numbers::pi);
  parser.DefineConst("e", std::numbers::e);
  parser.DefineFun("pow", static_cast<double (*)(double, double)>(std::pow));
  parser.DefineFun("floor", static_cast<double (*)(double)>(std::floor));
  parser.DefineFun("ceil", static_cast<double (*)(double)>(std::ceil));
  parser.DefineFun("clamp", clamp);
  parser.DefineFun("hypot", hypot);
}

/// Assignments would change the variables under the reader's eyes.
bool assigns(const std::string& text) {
  for (std::size_t i = text.find('='); i != std::string::npos; i = text.find('=', i + 1)) {
    const char before = i > 0 ? text[i - 1] : ' ';
    if (i + 1 < text.size() && text[i + 1] == '=')
      ++i;
    else if (before != '<' && before != '>' && before != '!')
      return true;
  }
  return false;
}

}  // namespace

Formula::Formula(const std::string& text) : parser_(std::make_unique<mu::Parser>()) {
  if (assigns(text)) refuse(text, "it may not assign with '='");
  try {
    define_functions(*parser_);
    parser_->DefineVar("x", &variables_[0]);
    parser_->DefineVar("y", &variables_[1]);
    parser_->DefineVar("z", &variables_[2]);
    parser_->SetExpr(text);
    int values = 0;
    parser_->Eval(values);
    if (values != 1) refuse(text, "it has " + std::to_string(values) + " values, not 1");
  } catch (const mu::ParserError& error) {
    refuse_with(text, error);
  }
}

Formula::~Formula() = default;

double Formula::operator()(const Point3& point) {
  variables_ = point;
  try {
    return parser_->Eval();
  } catch (const mu::ParserError&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

FormulaPool::FormulaPool(std::string text) : text_(std::move(text)) {
  idle_.push_back(std::make_unique<Formula>(text_));
}

std::unique_ptr<Formula> FormulaPool::take() {
  {
    const std::lock_guard lock(mutex_);
    if (!idle_.empty()) {
      auto formula = std::move(idle_.back());
      idle_.pop_back();
      return formula;
    }
  }
  return std::make_unique<Formula>(text_);
}

void FormulaPool::give_back(std::unique_ptr<Formula> formula) {
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(formula));
}

}  // namespace certet
