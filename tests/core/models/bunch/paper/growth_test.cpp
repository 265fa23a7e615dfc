#include "models/bunch/paper/growth.hpp"

#include <doctest/doctest.h>

#include <string>
#include <string_view>

#include "foundation/english.hpp"

using namespace panicle;
using namespace panicle::bunch;

namespace {

PaperGrowth grown_from(std::string_view text, float sag = 0) {
  PaperGrowth growth({15, 50, sag}, {}, 30);
  auto program = lsystem::compile(text, {}, lsystem::Lineages::always);
  REQUIRE_MESSAGE(program, (program ? "" : program.error().message));
  const auto bound = lsystem::bind(program.value(), {}, {});
  REQUIRE(bound);
  const auto derived = lsystem::develop(*bound.value(), 1, {}, {});
  REQUIRE(derived);
  growth.begin(*bound.value(), {}, false, 1, 0);
  REQUIRE(lsystem::interpret(*bound.value(), *derived->string, {}, growth, 1, {}));
  growth.finish();
  return growth;
}

constexpr std::string_view answers =
    "?E(type,theta,phi,l,w,b) : type=0 && l>0    --> +(theta) &(phi) !(w) F(l)\n"
    "?E(type,theta,phi,l,w,b) : type=0 && l=0    --> %\n"
    "?E(type,theta,phi,l,w,b) : type=1 && l=l_w  --> +(theta) &(phi) !(w) F(l) %\n"
    "?E(type,theta,phi,l,w,b) : type=1 && l!=l_w --> +(theta) &(phi) !(w) F(l) S(b)\n";

std::string with_answers(std::string_view text) {
  return "#define l_w 10\n" + std::string(text) + std::string(answers);
}

}  // namespace

TEST_CASE("the trace has the reason why a berry turns or withers, with the obstacle and the overlap") {
  std::string text = "axiom: F(40) [ ?E(1,0,0,30,2,20) ] [ +(45) ?E(1,0,0,30,2,20) ]";
  for (int i = 0; i < 4; ++i) text += " [ ?E(1,0,0,5,2,20) ]";
  PaperGrowth growth({15, 50, 0}, {}, 30);
  const auto program = lsystem::compile(with_answers(text + "\n"), {}, lsystem::Lineages::always);
  REQUIRE(program);
  const auto bound = lsystem::bind(program.value(), {}, {});
  REQUIRE(bound);
  const auto derived = lsystem::develop(*bound.value(), 1, {}, {});
  auto trace = lsystem::trace_derivation(*bound.value(), 1, {}, {}, {}, {});
  REQUIRE(derived);
  REQUIRE(trace);
  trace->watch_drawing(derived->string);
  growth.set_trace(&trace.value());
  growth.begin(*bound.value(), {}, false, 1, 0);
  REQUIRE(lsystem::interpret(*bound.value(), *derived->string, {}, growth, 1, {}, nullptr, &trace.value()));
  growth.finish();
  const auto& entries = trace->modules();
  CHECK(entries[0].response.empty());
  // The second comes nearer and nearer to where the two would only touch; the others begin above the first one's
  // centre.
  const auto response_of = [&](std::size_t module) { return english(entries[module].response); };
  CHECK(response_of(2) ==
        "asked 1 0 0 30 2 20 → 1 0 0 30 2 20; There is room for this part, so it keeps its direction.");
  CHECK(response_of(6).find("→ 1 0 0 10 2 20; There is no room, even after turning by ") != std::string::npos);
  CHECK(response_of(6).ends_with(
      " in 50 turns, so the pedicel withers. This part still touches the berry of module #2."));
  CHECK(response_of(9).ends_with("so the pedicel withers. This part still overlaps the berry of module #2 by 0.02."));
  std::size_t withered = 0, stood = 0;
  for (const Internode& one : growth.internodes) {
    stood += one.state == State::withered;
    if (one.kind == Kind::pedicel) CHECK(entries[one.module].text.starts_with("?E(1,0,0,"));
  }
  for (const auto& module : entries) {
    const std::string response = english(module.response);
    if (response.find("the pedicel withers") == std::string::npos) continue;
    ++withered;
    CHECK(response.find("; There is no room, even after turning by ") != std::string::npos);
    CHECK(response.find(" of module #") != std::string::npos);
    CHECK(module.fires.line == 5);
  }
  CHECK(withered == stood);
  CHECK(withered > 0);
}

TEST_CASE("the tip of its parent is no obstacle to an internode") {
  // Tips 20 across and steps of 12: each would collide with the one before, and only with that.
  const PaperGrowth growth = grown_from(with_answers("axiom: ?E(0,0,0,30,20,0) [ ?E(0,0,0,12,20,0) ]\n"));
  CHECK(growth.cuts == 0);
  REQUIRE(growth.internodes.size() == 2);
  CHECK(growth.internodes[1].end == glm::vec3(0, -42, 0));
  // A grandparent's tip is an obstacle.
  const PaperGrowth third =
      grown_from(with_answers("axiom: ?E(0,0,0,30,20,0) [ ?E(0,0,0,8,20,0) [ ?E(0,0,0,8,20,0) ] ]\n"));
  CHECK(!(third.cuts == 0 && third.internodes[2].end == glm::vec3(0, -46, 0)));
}

TEST_CASE("a pedicel between berries withers, an internode is cut with all beyond it") {
  const PaperGrowth pedicel = grown_from(with_answers(
      "axiom: F(40) [ ?E(1,0,0,12,2,20) ] [ ?E(1,0,0,12,2,20) ] [ ?E(1,0,0,12,2,20) ] [ ?E(1,0,0,12,2,20) ]"
      " [ ?E(1,0,0,12,2,20) ] [ ?E(1,0,0,12,2,20) ] [ ?E(1,0,0,12,2,20) ] [ ?E(1,0,0,12,2,20) ]\n"));
  std::size_t withered = 0;
  for (const Internode& one : pedicel.internodes) {
    withered += one.state == State::withered;
    if (one.state == State::withered) CHECK(one.kind == Kind::pedicel);
  }
  CHECK(withered > 0);
  CHECK(pedicel.balls.size() + withered == 8);
  CHECK(pedicel.refused());
}
