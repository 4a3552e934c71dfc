#include "method.hpp"

#include <CLI/CLI.hpp>
#include <map>

#include "certet/error.hpp"

namespace certet::command {
namespace {

/// The method that `--cuts` and `--guarantee` stand for.
Method implied(const MethodChoice& choice) {
  if (choice.cuts == Cuts::midpoint) return Method::midpoint;
  return choice.guarantee ? Method::paper : Method::embedded;
}

void judge(const MethodChoice& choice, Method method) {
  const auto refuse = [method](const std::string& option) {
    throw Error(ErrorCode::bad_option, "--method " + name(method) + " and " + option +
                                           " exclude each other");
  };
  const Cuts cuts = method == Method::midpoint ? Cuts::midpoint : Cuts::bisect;
  if (choice.cuts && *choice.cuts != cuts) refuse("--cuts " + name(*choice.cuts));
  if (choice.guarantee && method == Method::embedded)
    refuse("--guarantee " + std::string(name(*choice.guarantee)));
}

}  // namespace

Method method_of(const StuffingOptions& options) {
  if (options.cuts == Cuts::midpoint) return Method::midpoint;
  return options.guarantee == Guarantee::pieces ? Method::embedded : Method::paper;
}

std::string name(Method method) {
  switch (method) {
    case Method::embedded: return "embedded";
    case Method::paper: return "paper";
    case Method::midpoint: break;
  }
  return "midpoint";
}

std::string name(Cuts cuts) { return cuts == Cuts::bisect ? "bisect" : "midpoint"; }

void declare_method(CLI::App& app, MethodChoice& choice) {
  app.add_option("--method", choice.method,
                 "embedded: no tetrahedra overlap, the surface is a manifold, and no piece is "
                 "lost, cut or joined to another (default); paper: as published, vertices move "
                 "onto the surface whatever becomes of thin parts; midpoint: none moves, cuts "
                 "are in the middle of edges")
      ->transform(CLI::CheckedTransformer(std::map<std::string, Method>{
          {"embedded", Method::embedded}, {"paper", Method::paper}, {"midpoint", Method::midpoint}}))
      ->option_text("NAME");
  app.add_option("--cuts", choice.cuts,
                 "bisect: on the surface (default); midpoint: as --method midpoint")
      ->transform(CLI::CheckedTransformer(std::map<std::string, Cuts>{
          {"bisect", Cuts::bisect}, {"midpoint", Cuts::midpoint}}))
      ->option_text("WHERE");
  app.add_option("--guarantee", choice.guarantee,
                 "Of --method paper, which it stands for: angles: the widest dihedral angles "
                 "(default); embedding: the warped lattice never folds")
      ->transform(CLI::CheckedTransformer(std::map<std::string, Guarantee>{
          {"angles", Guarantee::angles}, {"embedding", Guarantee::embedding}}))
      ->option_text("WHICH");
}

StuffingOptions stuffing_options(const MethodChoice& choice) {
  const Method method = choice.method.value_or(implied(choice));
  judge(choice, method);
  switch (method) {
    case Method::embedded: return {Cuts::bisect, Guarantee::pieces};
    case Method::paper: return {Cuts::bisect, choice.guarantee.value_or(Guarantee::angles)};
    case Method::midpoint: break;
  }
  return {Cuts::midpoint, choice.guarantee.value_or(Guarantee::angles)};
}

}  // namespace certet::command
