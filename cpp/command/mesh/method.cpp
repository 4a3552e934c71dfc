#include "method.hpp"

#include <CLI/CLI.hpp>
#include <map>

#include "certet/error.hpp"

namespace certet::command {
namespace {

/// What --method calls them: the paper's rule is that of `angles`, and of `embedding` where
/// --guarantee says so.
const std::map<std::string, Method> named_methods{
    {"key", Method::key}, {"embedded", Method::embedded}, {"paper", Method::angles},
    {"midpoint", Method::midpoint}};

/// The method that `--cuts` and `--guarantee` stand for.
Method implied(const MethodChoice& choice) {
  if (choice.cuts == Cuts::midpoint) return Method::midpoint;
  return choice.guarantee.value_or(default_method);
}

void check_choice(const MethodChoice& choice, Method method) {
  const auto refuse_both = [method](const std::string& option) {
    const std::string called = method == Method::angles ? "paper" : std::string(name(method));
    throw Error(ErrorCode::bad_option, "--method " + called + " and " + option +
                                           " exclude each other");
  };
  if (!choice.method) return;
  if (choice.cuts && *choice.cuts != facts(method).cuts)
    refuse_both("--cuts " + std::string(name(*choice.cuts)));
  if (choice.guarantee && facts(method).settles)
    refuse_both("--guarantee " + std::string(name(*choice.guarantee)));
}

}  // namespace

void declare_method(CLI::App& app, MethodChoice& choice) {
  app.add_option("--method", choice.method,
                 "key: no tetrahedra overlap, the surface is a manifold, and no piece is lost, cut "
                 "or joined to another (default, but of several labels embedded); embedded: the "
                 "same, of several labels but for single points, with diagonals that do not follow "
                 "the cuts, and wider angles; paper: as published, vertices move onto the surface "
                 "whatever becomes of thin parts; midpoint: none moves, cuts are in the middle of "
                 "edges")
      ->transform(CLI::CheckedTransformer(named_methods))
      ->option_text("NAME");
  app.add_option("--cuts", choice.cuts,
                 "bisect: on the surface (default); midpoint: as --method midpoint")
      ->transform(CLI::CheckedTransformer(std::map<std::string, Cuts>{
          {"bisect", Cuts::bisect}, {"midpoint", Cuts::midpoint}}))
      ->option_text("WHERE");
  app.add_option("--guarantee", choice.guarantee,
                 "Of --method paper, which it stands for: angles: the widest dihedral angles "
                 "(default); embedding: the warped lattice never folds")
      ->transform(CLI::CheckedTransformer(std::map<std::string, Method>{
          {"angles", Method::angles}, {"embedding", Method::embedding}}))
      ->option_text("WHICH");
}

Method chosen(const MethodChoice& choice) {
  const Method method = choice.method.value_or(implied(choice));
  check_choice(choice, method);
  // No vertex is warped at cuts in the middle, whatever the guarantee.
  return method == Method::midpoint ? method : choice.guarantee.value_or(method);
}

}  // namespace certet::command
