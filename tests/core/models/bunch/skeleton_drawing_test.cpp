#include "models/bunch/paper/skeleton_drawing.hpp"

#include "models/bunch/drawn_text.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::tests;

namespace {

constexpr std::string_view answers =
    "?E(type,theta,phi,l,w) : type=0 --> !(w) F(l)\n"
    "?E(type,theta,phi,l,w) : type=1 --> !(w) F(l) S(1)\n";

std::vector<Kind> kinds_of(const SkeletonDrawing& drawing) {
  std::vector<Kind> kinds;
  for (const Internode& one : drawing.internodes) kinds.push_back(one.kind);
  return kinds;
}

std::string with(std::string_view text, std::string_view more) { return std::string(text) + std::string(more); }

}  // namespace

TEST_CASE("an answer's lines are those of its ?E: a thorn beside it is not") {
  const SkeletonDrawing drawing =
      finished_text(with("axiom: Ae\nAe --> ?E(0,0,0,9,2) [ Ap ]\nAp --> [ +(90) F(1) ] ?E(1,0,0,5,1)\n", answers));
  CHECK(kinds_of(drawing) == std::vector<Kind>{Kind::end, Kind::axis, Kind::pedicel});
  CHECK(drawing.internodes[1].parent == 0);
  CHECK(drawing.internodes[2].parent == 0);
  CHECK(drawing.internodes[2].radius == 0.5f);
}

TEST_CASE("lines in a row are internodes of one organ, each where the last one ends") {
  const SkeletonDrawing drawing = finished_text(
      "axiom: Ap\nAp --> ?E(1,0,0,9,2)\n?E(type,theta,phi,l,w) : 1 --> !(w/2) F(l/3) F(l/3) F(l/3) S(1)\n");
  REQUIRE(drawing.internodes.size() == 3);
  CHECK(kinds_of(drawing) == std::vector<Kind>(3, Kind::pedicel));
  CHECK(!drawing.internodes[0].joint);
  CHECK(drawing.internodes[0].radius == 1.0f);  // as the module requested
  for (std::size_t i = 1; i < 3; ++i) {
    CHECK(drawing.internodes[i].joint);
    CHECK(drawing.internodes[i].radius == 0.5f);  // the turtle's width
    CHECK(drawing.internodes[i].start == drawing.internodes[i - 1].end);
  }
  // The text's own lines, without an answer.
  const SkeletonDrawing plain = finished_text("axiom: Ap\nAp --> F(3) F(3) S(1)\n");
  CHECK(kinds_of(plain) == std::vector<Kind>(2, Kind::pedicel));
  CHECK(plain.internodes[1].joint);
}

TEST_CASE("a line with a ball is a pedicel; a stem that leads on beyond its ball is not") {
  const SkeletonDrawing drawing = finished_text("axiom: B\nB --> F(3) S(1) [ F(2) S(1) ] [ F(2) ]\n");
  CHECK(kinds_of(drawing) == std::vector<Kind>{Kind::axis, Kind::pedicel, Kind::axis});
}

TEST_CASE("a pedicel whose answer has no ball stays a pedicel") {
  const std::string barren = "?E(type,theta,phi,l,w) : 1 --> F(l)\n";
  CHECK(kinds_of(finished_text("axiom: Ap\nAp --> ?E(1,0,0,5,1)\n" + barren)) == std::vector<Kind>{Kind::pedicel});
}

TEST_CASE("axes are numbered by the rachis internode they leave; the rachis's end has no axis") {
  const SkeletonDrawing drawing = finished_text(
      "axiom: Ar(2)\nAr(n) : n>0 --> F(5) [ Ar(n-1) ] [ +(90) Af ]\nAr(n) : n=0 --> Ae\nAf --> F(3)\nAe --> F(2) "
      "S(1)\n");
  // Ar(2), Ar(1), Ae, then the axes from the tip upwards; the end structure has a ball, and so is a pedicel.
  REQUIRE(drawing.internodes.size() == 5);
  std::vector<std::int32_t> axes;
  for (const Internode& one : drawing.internodes) axes.push_back(one.axis);
  CHECK(axes == std::vector<std::int32_t>{-1, -1, -1, 1, 0});
}

TEST_CASE("balls that hang on no line are left out, and counted") {
  SkeletonDrawing drawing = drawn_text("axiom: S(1) F(2) S(1)\n");
  CHECK(drawing.attached_balls() == 1);
  CHECK(drawing.finish() == 1);
  REQUIRE(drawing.balls.size() == 1);
  CHECK(drawing.balls[0].segment == 0);
}
