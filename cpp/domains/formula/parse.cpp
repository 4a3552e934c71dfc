// The only translation unit that includes muParser.  muParser reads the text and
// turns it into its bytecode, in which precedences and parentheses are resolved;
// the bytecode is recorded, operation by operation, and muParser is done.

#include "parse.hpp"

#include <muParser.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <memory>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include "certet/error.hpp"
#include "certet/formula.hpp"
#include "functions.hpp"

namespace certet {
namespace {

/// One line, whatever the formula and muParser have in them.
[[noreturn]] void refuse(const std::string& text, const std::string& reason,
                         std::size_t around = 0) {
  std::string sentence = "the formula \"" + shortened_formula(text, around) +
                         "\" cannot be read: " + shortened_formula(reason);
  std::ranges::replace_if(sentence, [](unsigned char c) { return c < ' ' || c == 127; }, ' ');
  throw Error(ErrorCode::bad_input, sentence);
}

/// muParser's own sentences begin in capitals, may end in a full stop, and count
/// characters from 0.
[[noreturn]] void refuse_with(const std::string& text, const mu::ParserError& error) {
  std::string reason = error.GetMsg();
  for (const char* tail : {" found at position", " at position", " at expression position"})
    if (const auto end = reason.find(tail); end != std::string::npos) reason.resize(end);
  while (!reason.empty() && (reason.back() == '.' || reason.back() == ' ')) reason.pop_back();
  if (!reason.empty()) reason[0] = static_cast<char>(std::tolower(reason[0]));
  const auto position = static_cast<std::size_t>(std::max(error.GetPos(), 0));
  if (position < text.size()) reason += " at position " + std::to_string(position + 1);
  refuse(text, reason, position);
}

// What muParser calls while it tries the formula once; a function is known in the
// bytecode by its user data.
double of_one(void*, double) { return 0; }
double of_two(void*, double, double) { return 0; }
double of_three(void*, double, double, double) { return 0; }
double of_any(void*, const double*, int) { return 0; }
double minus(double a) { return -a; }
double plus(double a) { return a; }

void define(mu::Parser& parser, const FormulaFunction& function) {
  // muParser hands it back as it was given, and nobody writes to it.
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast)
  void* const data = const_cast<FormulaFunction*>(&function);
  switch (function.operands) {
    case 1: return parser.DefineFunUserData(function.name, of_one, data, false);
    case 2: return parser.DefineFunUserData(function.name, of_two, data, false);
    case 3: return parser.DefineFunUserData(function.name, of_three, data, false);
    default: return parser.DefineFunUserData(function.name, of_any, data, false);
  }
}

void define_language(mu::Parser& parser) {
  parser.EnableOptimizer(false);  // what it would rearrange is the tape's to decide
  parser.ClearFun();
  parser.ClearInfixOprt();
  for (const FormulaFunction& function : formula_functions()) define(parser, function);
  parser.DefineInfixOprt("-", minus, mu::prINFIX, false);
  parser.DefineInfixOprt("+", plus, mu::prINFIX, false);
  for (const char* name : {"pi", "_pi"}) parser.DefineConst(name, std::numbers::pi);
  for (const char* name : {"e", "_e"}) parser.DefineConst(name, std::numbers::e);
}

/// Names and what they stand for: the coordinates, and what was defined.
class Variables {
 public:
  explicit Variables(Tape& tape) {
    constexpr std::array names{"x", "y", "z"};
    for (std::size_t a = 0; a < names.size(); ++a) define(names[a], tape.variable(a));
  }

  void define(const std::string& name, NodeId id) {
    ids_.push_back({name, id, std::make_unique<double>(0)});
  }
  void declare_to(mu::Parser& parser) const {
    for (const Variable& one : ids_) parser.DefineVar(one.name, one.place.get());
  }
  [[nodiscard]] NodeId at(const double* place) const {
    return std::ranges::find(ids_, place, [](const Variable& one) { return one.place.get(); })->id;
  }

 private:
  struct Variable {
    std::string name;
    NodeId id;
    std::unique_ptr<double> place;  ///< by which muParser knows it
  };
  std::vector<Variable> ids_;
};

/// Runs the bytecode on a stack of node numbers in place of values.
class Recorder {
 public:
  Recorder(const std::string& text, const Variables& variables, Tape& tape)
      : text_(text), variables_(variables), tape_(tape) {}

  NodeId record(const mu::ParserByteCode& code) {
    for (std::size_t i = 0; i < code.GetSize(); ++i) record(code.GetBase()[i]);
    return stack_.back();
  }

 private:
  void record(const mu::SToken& token) {
    switch (token.Cmd) {
      case mu::cmVAL: return push(tape_.constant(token.Val.data2));
      case mu::cmVAR:
        return push(variables_.at(token.Val.ptr));
      case mu::cmADD: return binary(Operation::add);
      case mu::cmSUB: return binary(Operation::subtract);
      case mu::cmMUL: return binary(Operation::multiply);
      case mu::cmDIV: return binary(Operation::divide);
      case mu::cmLT: return binary(Operation::less);
      case mu::cmLE: return binary(Operation::less_equal);
      case mu::cmGT: return binary(Operation::greater);
      case mu::cmGE: return binary(Operation::greater_equal);
      case mu::cmEQ: return binary(Operation::equal);
      case mu::cmNEQ: return binary(Operation::unequal);
      case mu::cmLAND: return binary(Operation::logical_and);
      case mu::cmLOR: return binary(Operation::logical_or);
      case mu::cmPOW: return power();
      case mu::cmFUNC: return call(token);
      case mu::cmIF: case mu::cmELSE: return;  // both branches are computed
      case mu::cmENDIF: return choose();
      case mu::cmEND: return;
      case mu::cmASSIGN: refuse(text_, "it may not assign with '='");
      default: refuse(text_, "it has an operation that formulas do not have");
    }
  }

  void call(const mu::SToken& token) {
    if (token.Fun.cb._pUserData == nullptr) return sign_operator(token);
    const auto& function = *static_cast<const FormulaFunction*>(token.Fun.cb._pUserData);
    const auto count = static_cast<std::size_t>(std::abs(token.Fun.argc));
    const NodeId result = function.record(tape_, std::span(stack_).last(count));
    stack_.resize(stack_.size() - count);
    push(result);
  }

  void sign_operator(const mu::SToken& token) {
    if (token.Fun.cb._pRawFun == reinterpret_cast<mu::erased_fun_type>(&minus))
      push(tape_.add(Operation::negate, pop()));
  }

  void binary(Operation operation) {
    const NodeId right = pop();
    const NodeId left = pop();
    push(tape_.add(operation, left, right));
  }

  void power() {
    const NodeId exponent = pop();
    const NodeId base = pop();
    push(record_power(tape_, base, exponent));
  }

  void choose() {
    const NodeId otherwise = pop();
    const NodeId then = pop();
    const NodeId condition = pop();
    push(tape_.add(Operation::select, condition, then, otherwise));
  }

  void push(NodeId id) { stack_.push_back(id); }
  NodeId pop() {
    const NodeId id = stack_.back();
    stack_.pop_back();
    return id;
  }

  const std::string& text_;
  const Variables& variables_;
  Tape& tape_;
  std::vector<NodeId> stack_;
};

NodeId parse_one(const std::string& formula, const Variables& variables, Tape& tape) {
  try {
    mu::Parser parser;
    define_language(parser);
    variables.declare_to(parser);
    parser.SetExpr(formula);
    int values = 0;
    parser.Eval(values);
    const NodeId root = Recorder(formula, variables, tape).record(parser.GetByteCode());
    if (values != 1) refuse(formula, "it has " + std::to_string(values) + " values, not 1");
    return root;
  } catch (const mu::ParserError& error) {
    refuse_with(formula, error);
  }
}

constexpr std::string_view blanks = " \t\r\n\v\f";

std::string trimmed(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
  text.remove_prefix(begin);
  return std::string(text.substr(0, text.find_last_not_of(blanks) + 1));
}

bool is_name(std::string_view text) {
  const auto is_letter = [](char c) {
    return c == '_' || std::isalpha(static_cast<unsigned char>(c)) != 0;
  };
  return !text.empty() && is_letter(text.front()) && std::ranges::all_of(text, [&](char c) {
    return is_letter(c) || std::isdigit(static_cast<unsigned char>(c)) != 0;
  });
}

/// name = formula
void define(const std::string& definition, Variables& variables, Tape& tape) {
  const std::size_t sign = std::min(definition.find('='), definition.size());
  const std::string name = trimmed(std::string_view(definition).substr(0, sign));
  if (sign == definition.size() || definition.substr(sign).starts_with("==") || !is_name(name))
    refuse(definition, "what ends with a semicolon is a definition, like r = hypot(x,y);");
  variables.define(name, parse_one(trimmed(std::string_view(definition).substr(sign + 1)),
                                   variables, tape));
}

}  // namespace

NodeId parse(const std::string& formula, Tape& tape) {
  Variables variables(tape);
  std::size_t begin = 0;
  for (std::size_t end = formula.find(';'); end != formula.npos; end = formula.find(';', begin)) {
    define(trimmed(std::string_view(formula).substr(begin, end - begin)), variables, tape);
    begin = end + 1;
  }
  return parse_one(begin == 0 ? formula : trimmed(std::string_view(formula).substr(begin)),
                   variables, tape);
}

}  // namespace certet
