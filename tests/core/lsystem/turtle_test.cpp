#include "lsystem/turtle/turtle.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "lsystem/grammars.hpp"

using namespace panicle;
using namespace panicle::tests;
using lsystem::pitch;
using lsystem::roll;
using lsystem::turn;

namespace {

const glm::vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);

Turtle turned(void (*how)(Turtle&, float), float angle) {
  Turtle turtle;
  how(turtle, angle);
  return turtle;
}

Turtle end_of(const std::string& modules) {
  const Recorder recorder = drawn("axiom: " + modules + " F", 0);
  REQUIRE_FALSE(recorder.lines.empty());
  return recorder.lines.back().after;
}

}  // namespace

TEST_CASE("the turtle hangs down and turns clockwise, exactly by right angles") {
  const Turtle start;
  CHECK(start.heading == -y);
  CHECK(start.left == -x);
  CHECK(glm::cross(start.heading, start.left) == start.up);

  CHECK(turned(turn, 90).heading == -start.left);
  CHECK(turned(turn, 90).left == start.heading);
  CHECK(turned(turn, 90).up == start.up);
  CHECK(turned(pitch, 90).heading == start.up);
  CHECK(turned(pitch, 90).up == -start.heading);
  CHECK(turned(pitch, 90).left == start.left);
  CHECK(turned(roll, 90).left == -start.up);
  CHECK(turned(roll, 90).up == start.left);
  CHECK(turned(roll, 90).heading == start.heading);
  for (const auto how : {turn, pitch, roll}) {
    CHECK(turned(how, 450).heading == turned(how, 90).heading);
    CHECK(turned(how, -90).left == turned(how, 270).left);
    CHECK(turned(how, 180).up == turned(how, -180).up);
  }
}

TEST_CASE("turn by 30° rotates the heading by 30°") {
  const Turtle turtle = turned(turn, 30);
  CHECK(turtle.heading.x == doctest::Approx(0.5));
  CHECK(turtle.heading.y == doctest::Approx(-std::sqrt(0.75)));
  CHECK(turtle.heading.z == 0);
}

TEST_CASE("each symbol executes the command of the table") {
  CHECK(end_of("+").heading == x);
  CHECK(end_of("-").heading == -x);
  CHECK(end_of("&").heading == -z);
  CHECK(end_of("^").heading == z);
  CHECK(end_of("/+").heading == -z);
  CHECK(end_of("\\+").heading == z);
  CHECK(end_of("|").heading == y);
  CHECK(end_of("//+").heading == -x);
  CHECK(end_of("+(60)").heading == turned(turn, 60).heading);
  CHECK(end_of("-(60)").heading == turned(turn, -60).heading);
  CHECK(end_of("F(2)+").position == glm::vec3(1, -2, 0));
  CHECK(end_of("f(2)").position == glm::vec3(0, -3, 0));
  CHECK(end_of("f(2)").line == 0);
  CHECK(end_of("!(5)").width == 5);
  CHECK(end_of("!(5)[!(3)F(9)]").width == 5);
  CHECK(end_of("[+F]").position == -y);
  CHECK(end_of("S(4)").position == glm::vec3(0, -5, 0));
}

TEST_CASE("axes leave the rachis to the right, left, front and back") {
  // The rolls of the paper's p1 … p4 (L-system 3): 180°, 90°, 180°, −90°.
  CHECK(end_of("+").heading == x);
  CHECK(end_of("//+").heading == -x);
  CHECK(end_of("// / +").heading == z);
  CHECK(end_of("// / // +").heading == -z);
  CHECK(end_of("// / // \\ +").heading == x);
}

TEST_CASE("the frame stays orthonormal along a chain of a million turns") {
  Turtle turtle;
  std::uint32_t state = 1;
  float worst = 0;
  for (int i = 0; i < 1'000'000; ++i) {
    state = state * 1664525u + 1013904223u;
    const float angle = static_cast<float>(state >> 8) * (720.0f / 16777216.0f) - 360;
    switch (state & 0x60) {
      case 0:
        turn(turtle, angle);
        break;
      case 0x20:
        pitch(turtle, angle);
        break;
      case 0x40:
        roll(turtle, angle);
        break;
      default:
        turn(turtle, angle * 1e-4f);
        break;
    }
    if (i % 1000 != 999) continue;
    for (const glm::vec3& v : {turtle.heading, turtle.left, turtle.up})
      worst = std::fmax(worst, std::fabs(glm::dot(v, v) - 1));
    worst = std::fmax(worst, std::fabs(glm::dot(turtle.heading, turtle.left)));
    worst = std::fmax(worst, std::fabs(glm::dot(turtle.left, turtle.up)));
    worst = std::fmax(worst, std::fabs(glm::dot(turtle.up, turtle.heading)));
    worst = std::fmax(worst, glm::length(glm::cross(turtle.heading, turtle.left) - turtle.up));
  }
  CHECK(worst < 2e-6f);
}

TEST_CASE("a drawing in a plane stays in it") {
  const Recorder recorder = drawn("axiom: F\nF --> F+(60)F-(120)F+(60)F", 5);
  CHECK(recorder.lines.size() == 1024);
  for (const Recorder::Line& line : recorder.lines) CHECK(line.after.position.z == 0);
  CHECK(recorder.lines.back().after.position.y == doctest::Approx(-243));
}
