/// \file
/// What formulas mean, and how unreadable ones are refused.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "certet/error.hpp"
#include "certet/formula.hpp"
#include "certet/stuffing.hpp"
#include "parse.hpp"

namespace {

double value(const std::string& formula, const certet::Point3& point = {2, 3, 5}) {
  certet::Tape tape;
  const certet::NodeId root = certet::parse(formula, tape);
  return tape.evaluate(root, point);
}

TEST(Formula, Precedence) {
  EXPECT_EQ(value("-x^2"), -4);
  EXPECT_EQ(value("x^y^2"), 512);  // 2^(3^2)
  EXPECT_EQ(value("x^-y"), 0.125);
  EXPECT_EQ(value("x--y"), 5);
  EXPECT_EQ(value("+x*-y"), -6);
  EXPECT_EQ(value("x+y*z"), 17);
  EXPECT_EQ(value("x-y-z"), -6);
  EXPECT_EQ(value("z/x/y"), 5.0 / 2 / 3);
  EXPECT_EQ(value("x<y && z<y || x==2"), 1);
  EXPECT_EQ(value("x>=2 && y!=3"), 0);
  EXPECT_EQ(value("x<1 ? y : z>4 ? 7 : 8"), 7);
  EXPECT_EQ(value("1e-3*x+.5"), 0.502);
}

TEST(Formula, Functions) {
  EXPECT_EQ(value("min(x,y,z)+max(x,y,z)*10"), 52);
  EXPECT_EQ(value("sum(x,y,z)+avg(1,2)"), 11.5);
  EXPECT_EQ(value("abs(-x)+sign(-y)+sqrt(4)"), 3);
  EXPECT_EQ(value("hypot(3,4)"), 5);
  EXPECT_EQ(value("length(1,2,2)"), 3);
  EXPECT_EQ(value("clamp(x,0,1)+10*clamp(-x,0,1)+100*clamp(x,0,9)"), 201);
  EXPECT_EQ(value("mix(x,y,0)+10*mix(x,y,1)+100*mix(x,z,0.5)"), 382);
  EXPECT_EQ(value("if(x>1,y,z)+if(0,1,10)"), 13);
  EXPECT_EQ(value("floor(2.5)+ceil(2.5)+round(-2.5)+trunc(-2.5)+rint(2.5)+fmod(7,4)"), 6);
  EXPECT_EQ(value("not(x>1)+not(0)"), 1);
  EXPECT_EQ(value("pow(x,3)+x^0.5"), 8 + std::pow(2, 0.5));
  EXPECT_EQ(value("log(x)-ln(x)+log2(8)+log10(100)"), 5);
  EXPECT_EQ(value("exp(x)"), std::exp(2));
  EXPECT_EQ(value("sin(x)+cos(x)+tan(x)"), std::sin(2) + std::cos(2) + std::tan(2));
  EXPECT_EQ(value("asin(0.5)+acos(0.5)+atan(x)"),
            std::asin(0.5) + std::acos(0.5) + std::atan(2));
  EXPECT_EQ(value("sinh(x)+cosh(x)+tanh(x)"), std::sinh(2) + std::cosh(2) + std::tanh(2));
  EXPECT_DOUBLE_EQ(value("asinh(x)+acosh(x)+atanh(0.5)"),
            std::asinh(2) + std::acosh(2) + std::atanh(0.5));
  EXPECT_EQ(value("atan2(y,x)"), std::atan2(3, 2));
  EXPECT_EQ(value("pi+_pi+e+_e"), 2 * std::numbers::pi + std::numbers::e + std::numbers::e);
}

TEST(Formula, WhatIsWrittenTwiceIsComputedOnce) {
  certet::Tape tape;
  certet::parse("(x+y)^2+(x+y)*z+2*3*x", tape);
  // x y x+y 2 (x+y)^2 z (x+y)*z + 3 6 6*x +
  EXPECT_LE(tape.nodes().size(), 12U);
}

/// The sentence names the formula and says what is wrong.
void expect_refused(const std::string& formula, const std::string& word) {
  try {
    value(formula);
    ADD_FAILURE() << formula;
  } catch (const certet::Error& error) {
    const std::string sentence = error.what();
    EXPECT_EQ(error.code(), certet::ErrorCode::bad_input);
    EXPECT_NE(sentence.find(formula), std::string::npos) << sentence;
    EXPECT_NE(sentence.find(word), std::string::npos) << sentence;
    EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
  }
}

TEST(Formula, UnreadableOnesAreRefused) {
  expect_refused("", "empty");
  expect_refused("x+", "end");
  expect_refused("x+$", "position 3");
  expect_refused("x=3", "assign");
  expect_refused("1,2", "2 values");
  expect_refused("sin()", "too few");
  expect_refused("sin(x,y)", "too many");
  expect_refused("clamp(x,y)", "too few");
  expect_refused("min()", "too few");
  expect_refused("w*x", "w");
  expect_refused("x y", "position 3");
  expect_refused("x ? y", "else");
  expect_refused("\"a\"", "string");
}

/// Two balls that overlap, and the smooth union that goes around both.
TEST(FormulaDomain, ASmoothUnionIsALittleMoreThanTheUnion) {
  const std::string a = "(hypot(x-0.5,y,z)-0.7)", b = "(hypot(x+0.5,y,z)-0.7)";
  const auto tets = [](const std::string& formula) {
    const certet::FormulaDomain domain(formula, {{-1.5, -1, -1}, {1.5, 1, 1}}, 0.05, 2);
    certet::Context context;
    return certet::Stuffing(domain, domain.lattice(), {}, context).tet_count();
  };
  const auto sharp = static_cast<double>(tets("min(" + a + "," + b + ")"));
  const auto smooth =
      static_cast<double>(tets("-log(exp(-16*" + a + ")+exp(-16*" + b + "))/16"));
  EXPECT_GT(smooth, 1.005 * sharp);
  EXPECT_LT(smooth, 1.1 * sharp);
}

}  // namespace
